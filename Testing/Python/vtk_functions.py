# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the package, with plain VTK."""

from array_tools import Cells, Chosen, Results, Values  # noqa: F401
from function_tools import Limits, Matrices, Meshes, Options  # noqa: F401
from image_tools import Images  # noqa: F401
from input_tools import Blocks, Digits, Forms, Messages, Rows, Texts  # noqa: F401
from package_tools import Measures, Package, PyVista  # noqa: F401
from series_tools import Progress, Series  # noqa: F401
from task_tools import Help, Saved, Tasks, Types  # noqa: F401

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
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


# Works until a signal stops it, and says whether this one came too late to see it: behind the last reports of progress.
LONG_WORK = """
import signal
from task_tools import grid
from subdivisionobjects import execution, subdivide

reports, seen = [], []
report = execution.Stopper.report

def note(stopper, *more):
    part = stopper.made.GetProgress()
    seen.extend([part] if stopper.error and not seen else [])
    reports.append(part)
    report(stopper, *more)

execution.Stopper.report = note
mesh, inside, missed = grid(16), [], []

def handle(*_):
    if inside:
        raise KeyboardInterrupt
    missed.append(1)

signal.signal(signal.SIGINT, handle)
print("begun", flush=True)
found = "late"
while found == "late":
    reports.clear(), seen.clear()
    try:
        inside.append(1)
        subdivide(*mesh, levels=2)
        inside.clear()
    except KeyboardInterrupt:
        inside.clear()
        if seen and seen[0] < 0.6:
            found = "stopped" if max(part for part in reports if part < 1) < 0.6 else "went on"
        print(found, flush=True)
    if missed:
        missed.clear()
        print(found, flush=True)
"""


class CtrlC(unittest.TestCase):
    def test_it_stops_a_script(self):
        """A signal from outside, while the filter works: an exception of Python, no end of the process."""
        path = os.pathsep.join(filter(None, sys.path))
        working = subprocess.Popen([sys.executable, "-c", LONG_WORK], stdout=subprocess.PIPE, text=True,
                                   stderr=subprocess.PIPE, env={**os.environ, "PYTHONPATH": path})
        self.addCleanup(working.kill)
        told = working.stdout.readline()
        self.assertEqual(told, "begun\n")
        for i in range(100):
            if told == "stopped\n":
                break
            time.sleep(0.013 * (i % 7))
            working.send_signal(signal.SIGINT)
            told = working.stdout.readline()
            self.assertIn(told, ("late\n", "stopped\n"))
        rest, errors = working.communicate(timeout=300)
        self.assertEqual((working.returncode, told, rest, errors), (0, "stopped\n", "", ""))


if __name__ == "__main__":
    unittest.main()
