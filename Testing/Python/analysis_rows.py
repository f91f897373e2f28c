# SPDX-License-Identifier: BSD-3-Clause
"""Compares rows of some pages of Documentation/Analysis with what is computed: one test for each part, side by side. All rows,
or a third of them by turns of the commit, as `./dev test` asks for."""

import os
import pathlib
import sys
import unittest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Analysis"))

import analysis  # noqa: E402
import pages  # noqa: E402
import plots  # noqa: E402, F401

PARTS = {
    "triangles": ["Loop", "Butterfly", "OtherSurfaces"],
    "quads": ["CatmullClark"],
    "solids": ["BoxSpline", "TetOct"],
    "hybrid": ["Hybrid"],
    "measured": ["MeasuredSmoothness"],
    "approximation": ["ApproximationOrder"],
    "convergence": ["Convergence"],
}


class Rows(unittest.TestCase):
    part = ""

    def test_rows_are_what_is_computed(self):
        turn = os.environ.get("SUBDIVISIONOBJECTS_TURN") or None
        for page in analysis.all_pages():
            if page.name in PARTS[self.part]:
                with self.subTest(page.name):
                    faults, count = pages.differences(page, turn and int(turn))
                    self.assertEqual(faults, [])
                    self.assertGreater(count, 0)


def main(part):
    Rows.part = part
    unittest.main(__name__)
