# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the package, with plain VTK."""

from array_tools import Cells, Chosen, Results, Values  # noqa: F401
from function_tools import Limits, Matrices, Meshes, Options, Package, PyVista  # noqa: F401
from input_tools import Blocks, Digits, Forms, Messages, Rows, Texts  # noqa: F401

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest


class OtherVTK(unittest.TestCase):
    def test_an_import_beside_another_vtk_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            other = pathlib.Path(folder, "vtkmodules")
            other.mkdir()
            for name in ("__init__", "vtkCommonDataModel", "vtkCommonExecutionModel"):
                (other / f"{name}.py").write_text("", encoding="utf-8")
            (other / "vtkCommonCore.py").write_text(
                "class vtkVersion:\n    GetVTKVersion = staticmethod(lambda: '5.0.0')\n", encoding="utf-8")
            path = os.pathsep.join([folder, *filter(None, sys.path)])
            done = subprocess.run([sys.executable, "-c", "import subdivisionobjects"], capture_output=True, text=True,
                                  timeout=300, env={**os.environ, "PYTHONPATH": path})
            self.assertEqual(done.returncode, 1)
            self.assertIn("Python finds VTK 5.0.0", done.stderr)


if __name__ == "__main__":
    unittest.main()
