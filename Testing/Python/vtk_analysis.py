# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/Analysis has what is computed: of each table the quick rows; `./dev analysis --check` takes all."""

import os
import pathlib
import sys
import unittest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Analysis"))

import analysis  # noqa: E402
import pages  # noqa: E402


class Analysis(unittest.TestCase):
    def test_rows_are_what_is_computed(self):
        for page in analysis.all_pages():
            with self.subTest(page.name):
                faults, count = pages.differences(page, everything=False)
                self.assertEqual(faults, [])
                self.assertGreater(count, 0)

    def test_each_page_is_in_the_index(self):
        index = (pages.FOLDER / "README.md").read_text(encoding="utf-8")
        written = {path.name for path in pages.FOLDER.glob("*.md")} - {"README.md"}
        self.assertEqual(written, {f"{page.name}.md" for page in analysis.all_pages()})
        for name in written:
            self.assertIn(f"({name})", index)

    def test_a_wrong_digit_is_seen(self):
        self.assertTrue(pages.is_same("0.4523", "0.4524"))  # rounding
        self.assertFalse(pages.is_same("0.4523", "0.4525"))
        self.assertFalse(pages.is_same("0.4523", "0.45"))
        self.assertFalse(pages.is_same("25 of 25", "24 of 25"))
        self.assertFalse(pages.is_same("yes", "no"))


if __name__ == "__main__":
    unittest.main()
