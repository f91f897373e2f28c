# SPDX-License-Identifier: BSD-3-Clause
"""What the examples with CalculiX share: it runs the program, reads its results, and draws them on the smooth object."""

import os
import pathlib
import re
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "Tutorials"))
from picture import picture  # noqa: E402


def run(name, text):
    """Writes name.inp, solves it by ccx, and returns what name.frd has."""
    pathlib.Path(f"{name}.inp").write_text(text, encoding="utf-8")
    done = subprocess.run(["ccx", name], capture_output=True, text=True, check=False, env={**os.environ, "OMP_NUM_THREADS": "1"})
    if "*ERROR" in done.stdout or done.returncode or not pathlib.Path(f"{name}.frd").exists():
        raise RuntimeError(f"ccx {name} failed:\n{done.stdout[-2000:]}")
    return read_frd(f"{name}.frd")


def node_set(name, points):
    """Text of a set of nodes: node i + 1 of the file is point i."""
    return f"*NSET, NSET={name}\n" + ",\n".join(str(point + 1) for point in points)


def read_frd(name):
    """Results of the last step: for each name, such as DISP and STRESS, an array with a row for each node, from 1 on. Numbers
    have 12 characters each, without a space between."""
    results, rows, title = {}, {}, None
    for line in pathlib.Path(name).read_text(encoding="utf-8").splitlines():
        if line.startswith(" -4"):
            title, rows = line.split()[1], {}
        elif line.startswith(" -1") and title:
            rows[int(line[3:13])] = [float(value) for value in re.findall(".{12}", line[13:])]
        elif line.startswith(" -3") and title:
            values = np.full((max(rows) + 1, max(map(len, rows.values()))), np.nan)
            for node, row in rows.items():
                values[node, :len(row)] = row
            results[title], title = values[1:], None
    return results


def mises(stress):
    """The stress of von Mises, of rows xx, yy, zz, xy, yz, zx."""
    x, y, z, xy, yz, zx = stress.T
    return np.sqrt(((x - y)**2 + (y - z)**2 + (z - x)**2) / 2 + 3 * (xy**2 + yz**2 + zx**2))


def points_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())


def with_results(mesh, displacement=None, factor=1, **arrays):
    """A copy of the mesh with results as point data, moved by a displacement times a factor."""
    made = mesh.NewInstance()
    made.ShallowCopy(mesh)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values[:mesh.GetNumberOfPoints()]), deep=True)
        array.SetName(name)
        made.GetPointData().AddArray(array)
    if displacement is not None:
        points = made.GetPoints().NewInstance()
        points.SetData(numpy_to_vtk(points_of(mesh) + factor * displacement[:mesh.GetNumberOfPoints(), :3], deep=True))
        made.SetPoints(points)
    return made


def draw(*meshes, curved=True, **given):
    """Pictures beside each other. Where there are lines or vertices, VTK 9.1 cannot draw other cells curved."""
    picture(*meshes, edges=False, curved=curved, **given)
