# SPDX-License-Identifier: BSD-3-Clause
"""The lines of code that README and the guide show, so that tests can run them."""

import pathlib
import re

PROJECT = pathlib.Path(__file__).parents[2]
# The pages of the guide, with the one whose Python is that of plain VTK last.
GUIDE = sorted((PROJECT / "Documentation" / "Guide").glob("*.md"), key=lambda path: (path.stem == "Python", path.stem))


def blocks(language, after=None, before=None, path=PROJECT / "README.md"):
    text = path.read_text(encoding="utf-8")
    if after:
        text = text[text.index(after):]
    if before:
        text = text[:text.index(before)]
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)
