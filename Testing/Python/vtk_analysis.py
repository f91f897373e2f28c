# SPDX-License-Identifier: BSD-3-Clause
"""Each page of Documentation/Analysis is in its index and in one of the tests vtk_analysis_PART, which compute its rows."""

import pathlib
import unittest

from analysis_rows import PARTS, analysis, pages, plots


class Analysis(unittest.TestCase):
    def test_each_page_is_in_the_index(self):
        index = (pages.FOLDER / "README.md").read_text(encoding="utf-8")
        written = {path.name for path in pages.FOLDER.glob("*.md")} - {"README.md"}
        self.assertEqual(written, {f"{page.name}.md" for page in analysis.all_pages()})
        for name in written:
            self.assertIn(f"({name})", index)

    def test_each_page_is_in_one_test(self):
        named = [name for part in PARTS.values() for name in part]
        self.assertEqual(sorted(named), sorted(page.name for page in analysis.all_pages()))
        here = pathlib.Path(__file__).resolve().parent
        self.assertEqual({path.name for path in here.glob("vtk_analysis_*.py")}, {f"vtk_analysis_{part}.py" for part in PARTS})

    def test_pages_are_made_of_their_rows(self):
        for page in analysis.all_pages():
            with self.subTest(page.name):
                self.assertEqual(pages.file_of(page, "md").read_text(encoding="utf-8"), pages.render(page, pages.read(page)))

    def test_rows_and_columns_that_pages_choose_are_there(self):
        for page in analysis.all_pages():
            for table in page.tables:
                with self.subTest(f"{page.name}, {table.title}"):
                    self.assertLessEqual(set(table.hidden), set(table.columns))
                    self.assertTrue(not table.keys or set(table.keys) & {row.key for row in table.rows})
                    self.assertFalse(table.plot and table.keys == [], "a plot that no page shows")

    def test_sentences_follow_from_the_rows(self):
        for page in analysis.all_pages():
            with self.subTest(page.name):
                self.assertEqual(pages.untrue_claims(page), [])

    def test_plots_show_the_rows(self):
        shown = {}
        for page in analysis.all_pages():
            with plots.recording() as expected:
                if page.draw:
                    page.draw(pages.read(page))
            self.assertEqual({f"{name}.png" for name in expected}, {table.plot for table in page.tables if table.plot})
            for name, numbers in expected.items():
                with self.subTest(name):
                    self.assertEqual(plots.told(name), numbers)
            shown.update(expected)
        self.assertEqual({path.stem for path in pages.FOLDER.glob("*.png")}, set(shown))

    def test_a_plot_of_other_numbers_is_seen(self):
        page = next(page for page in analysis.all_pages() if page.name == "Loop")
        rows = pages.read(page)
        rows["Inside"][0][1] = "0.1234"
        with plots.recording() as expected:
            page.draw(rows)
        self.assertNotEqual(plots.told("Loop"), expected["Loop"])

    def test_a_wrong_digit_is_seen(self):
        self.assertTrue(pages.is_same("0.4523", "0.4524"))  # rounding
        self.assertFalse(pages.is_same("0.4523", "0.4525"))
        self.assertFalse(pages.is_same("0.4523", "0.45"))
        self.assertFalse(pages.is_same("25 of 25", "24 of 25"))
        self.assertFalse(pages.is_same("yes", "no"))


if __name__ == "__main__":
    unittest.main()
