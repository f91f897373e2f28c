# SPDX-License-Identifier: BSD-3-Clause
"""Writes the pages of this folder and the files of their rows: analysis.py [--check|--text] [PAGE...]

With --check it compares the files with what is computed; with --text it writes pages of the files as they stand, for a change of
a text."""

import pathlib
import sys

sys.dont_write_bytecode = True
here = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(here), str(here.parents[1] / "Testing" / "Python")]

import approximation  # noqa: E402
import convergence  # noqa: E402
import hybrid  # noqa: E402
import measured  # noqa: E402
import pages  # noqa: E402
import solids  # noqa: E402
import surfaces  # noqa: E402


def all_pages():
    return surfaces.make_pages() + solids.make_pages() + [
        hybrid.make_page(), measured.make_page(), approximation.make_page(), convergence.make_page()]


def main():
    names = [name for name in sys.argv[1:] if name not in ("--check", "--text")]
    known = [page.name for page in all_pages()]
    for name in names:
        if name not in known:
            sys.exit(f"no page {name}; there are {' '.join(known)}")
    chosen = [page for page in all_pages() if not names or page.name in names]
    if "--check" not in sys.argv:
        for page in chosen:
            (pages.write_text if "--text" in sys.argv else pages.write)(page)
        return
    total = 0
    for page in chosen:
        faults, count = pages.differences(page)
        total += count
        if faults:
            sys.exit("\n".join(faults))
    print(f"{total} rows of {len(chosen)} pages are what was computed")


if __name__ == "__main__":
    main()
