# SPDX-License-Identifier: BSD-3-Clause
"""Each example with a solver runs as it stands, says what is right, and ends in a picture. Where the solver is missing the example
is skipped."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from vtk_tutorials import ROOT, WITH_DISPLAY, colours

FOLDER = ROOT / "Examples" / "Solvers"
PAGE = ROOT / "Documentation" / "Guide" / "CurvedCellsForSolvers.md"
NUMBER = r"(-?\d+\.?\d*(?:e[-+]?\d+)?)"


def has(*names):
    """Whether modules of Python or programs are installed."""
    return all(importlib.util.find_spec(name) or shutil.which(name) for name in names)


class Examples(unittest.TestCase):
    def run_example(self, name, *needed):
        """What the example prints."""
        path = FOLDER / f"{name}.py"
        self.assertLessEqual(len(path.read_text(encoding="utf-8").splitlines()), 90)
        if not has(*needed):
            self.skipTest(f"skipped: there is no {' or no '.join(needed)}")
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([WITH_DISPLAY, sys.executable, path], cwd=folder, capture_output=True, text=True, check=False,
                                  env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "XDG_CACHE_HOME": folder}, timeout=600)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            many, part = colours(pathlib.Path(folder) / f"{name}.png")
            self.assertGreater(many, 100)
            self.assertGreater(part, 0.03)
        return done.stdout

    def numbers(self, text, pattern):
        found = re.search(pattern.replace("#", NUMBER), text)
        self.assertTrue(found, text)
        return [float(one) for one in found.groups()]

    def test_elasticity(self):
        text = self.run_example("elasticity", "ccx")
        cells, _, tip, bar, _ = self.numbers(
            text, "# cells C3D10, # nodes: the tip moves by #, that of a straight bar of this size by #; the largest stress is #")
        self.assertEqual(cells, 2304)
        self.assertTrue(0.8 < tip / bar < 1.1, text)

    def test_heat(self):
        text = self.run_example("heat", "dolfinx", "gmsh", "scipy")
        largest, apart = self.numbers(text, "the largest temperature is #, and # from that of SciPy")
        self.assertLess(apart, 1e-4 * largest)

    def test_beam_shell_solid(self):
        text = self.run_example("beam_shell_solid", "ccx")
        _, _, far, beam = self.numbers(text, "# cells, # nodes: the stem moves at its top by #, a straight beam by #")
        self.assertTrue(0.9 < far / beam < 1.15, text)

    def test_the_pages_have_the_errors_of_the_analysis(self):
        """That of the analysis the table, that of the guide the last row."""
        analysis = ROOT / "Documentation" / "Analysis"
        rows = [line.split(",") for line in (analysis / "Convergence.csv").read_text().splitlines()]
        rows = [row[1:] for row in rows if row[0] == "Ring" and row[1] != "p"]
        self.assertEqual([row[0] for row in rows], ["1", "2", "3", "4"])
        table = (analysis / "Convergence.md").read_text(encoding="utf-8")
        for order, *of in rows:
            self.assertIn(f"| {order} | {of[3]} | {of[4]} | {of[8]} | {of[9]} |", table)
        self.assertIn(f"{of[3]} with curved cells of order 4, and {of[8]} with straight edges",
                      " ".join(PAGE.read_text(encoding="utf-8").split()))

    def test_the_page_has_them(self):
        text = PAGE.read_text(encoding="utf-8")
        for path in sorted(FOLDER.glob("*.py")):
            self.assertIn(f"Examples/Solvers/{path.name}", text)


if __name__ == "__main__":
    unittest.main()
