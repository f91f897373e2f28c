# SPDX-License-Identifier: BSD-3-Clause
"""The Python lines of README and the guide for plain VTK, and the lines for the program, are run as they stand there."""

import os
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest

import readme
import subdivisionobjects

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter


class ReadmeTest(unittest.TestCase):
    def test_vtk(self):
        blocks = readme.blocks("python", after="## In Python, without ParaView")
        self.assertEqual(len(blocks), 1)
        names = {}
        exec(compile(blocks[0], "README.md", "exec"), names)
        self.assertGreater(names["smooth"].GetNumberOfCells(), names["ship"].GetNumberOfCells())
        self.assertEqual(names["tetrahedra"].shape, (512, 4))

    def test_guide(self):
        page = readme.GUIDE[-1]
        self.assertEqual(page.name, "Python.md")
        names = {}
        for block in readme.blocks("python", path=page):
            exec(compile(block, page.name, "exec"), names)
        self.assertEqual(names["tetrahedra"].shape, (512, 4))
        self.assertEqual(len(names["temperature"]), len(names["fine_points"]))
        self.assertEqual(len(names["solid"].cells), 8 * 6 * 8 * 6 * 4)
        self.assertEqual(names["basis"].argmax(), 7)

    def test_program(self):
        program = os.environ.get("SUBDIVISIONOBJECTS_PROGRAM", "")
        if not program:
            self.skipTest("there is no program")
        lines = []
        for path in [readme.PROJECT / "README.md", *readme.GUIDE]:
            lines += re.findall(r"(?:^    |`)(?:build/vtk/bin/)?subdivide ([\w/]+\.vtu [^`#\n]*)",
                                path.read_text(encoding="utf-8"), re.MULTILINE)
        self.assertEqual(len(lines), 5, lines)
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(readme.PROJECT / "Data", os.path.join(folder, "Data"))
            shutil.copyfile(readme.PROJECT / "Data/Ship.vtu", os.path.join(folder, "mesh.vtu"))
            for line in lines:
                words = shlex.split(line)
                subprocess.run([program, *words], cwd=folder, check=True, timeout=300)
                self.assertTrue(os.path.isfile(os.path.join(folder, words[1])), line)
                os.remove(os.path.join(folder, words[1]))

    def test_vtk_refuses_what_we_take(self):
        """What README says of three triangles at an edge."""
        points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]]
        mesh = vtkPolyData()
        mesh.SetPoints(vtkPoints())
        triangles = vtkCellArray()
        for point in points:
            mesh.GetPoints().InsertNextPoint(point)
        for third in (2, 3, 4):
            triangles.InsertNextCell(3, (0, 1, third))
        mesh.SetPolys(triangles)
        told = []
        refused = vtkLoopSubdivisionFilter()
        refused.SetInputData(mesh)

        @calldata_type(VTK_STRING)
        def listen(_, __, message):
            told.append(message)

        refused.AddObserver("ErrorEvent", listen)
        refused.GetExecutive().AddObserver("ErrorEvent", listen)
        refused.Update()
        self.assertIn("non-manifold and cannot be subdivided", "".join(told))
        self.assertEqual(refused.GetOutput().GetNumberOfCells(), 0)
        self.assertEqual(subdivisionobjects.surface_subdivision(mesh, scheme="Loop").GetNumberOfCells(), 12)


if __name__ == "__main__":
    unittest.main()
