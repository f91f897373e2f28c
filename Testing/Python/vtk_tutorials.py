# SPDX-License-Identifier: BSD-3-Clause
"""Each tutorial runs as it stands, is short, and ends in a picture on which there is something to see."""

import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Examples" / "Tutorials"
PAGE = ROOT / "Documentation" / "Guide" / "Tutorials.md"
SCRIPTS = sorted(FOLDER.glob("[0-9]*.py"))
PROGRAMS = sorted((ROOT / "Examples" / "Cxx" / "Tutorials").glob("[0-9]*.cxx"))
WITH_DISPLAY = ROOT / "Testing" / "Python" / "with_display"


def colours(path):
    """How many colours a picture has, and which part of it is not background."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    one = values[:, 0] * 65536 + values[:, 1] * 256 + values[:, 2]
    return len(set(one.tolist())), float((one != 0xFFFFFF).mean())


class Tutorials(unittest.TestCase):
    def test_there_are_twelve(self):
        self.assertEqual([int(path.name[:2]) for path in SCRIPTS], list(range(12)))

    def test_they_are_short(self):
        for path in SCRIPTS:
            text = path.read_text(encoding="utf-8")
            self.assertLessEqual(len(text.splitlines()), 40, path.name)
            self.assertIn("In ParaView: ", text.replace("In\nParaView", "In ParaView"), path.name)

    def test_the_first_five_are_there_in_cxx(self):
        self.assertEqual([path.stem for path in PROGRAMS], [path.stem for path in SCRIPTS[:5]])
        for path in PROGRAMS:
            self.assertLessEqual(len(path.read_text(encoding="utf-8").splitlines()), 40, path.name)
            self.assertIn(f"Examples/Cxx/Tutorials/{path.name}", PAGE.read_text(encoding="utf-8"))

    def test_the_page_has_them_in_order(self):
        text = PAGE.read_text(encoding="utf-8")
        places = [text.index(f"Examples/Tutorials/{path.name}") for path in SCRIPTS]
        self.assertEqual(places, sorted(places))
        for path in SCRIPTS:
            picture = ROOT / "Documentation" / "Guide" / "pictures" / f"tutorial_{path.stem}.png"
            self.assertIn(f"pictures/{picture.name}", text)
            self.assertLess(picture.stat().st_size, 60_000, picture.name)
            self.assertGreater(colours(picture)[0], 20, picture.name)

    def test_they_run(self):
        for path in SCRIPTS:
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder:
                if path.name.startswith("09"):
                    try:
                        import scipy  # noqa: F401
                    except ImportError:
                        continue
                start = time.perf_counter()
                done = subprocess.run([WITH_DISPLAY, sys.executable, path], cwd=folder, capture_output=True, text=True,
                                      env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}, timeout=300, check=False)
                if "No module named 'vtkmodules.vtkParallelMPI'" in done.stderr:
                    continue
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                many, part = colours(pathlib.Path(folder) / f"{path.stem}.png")
                self.assertGreater(many, 20, path.name)
                self.assertGreater(part, 0.03, path.name)
                print(path.name, round(time.perf_counter() - start, 1), "s")


if __name__ == "__main__":
    unittest.main()
