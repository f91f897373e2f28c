# SPDX-License-Identifier: BSD-3-Clause
"""The lines of code that README shows, so that tests can run them."""

import pathlib
import re


def blocks(language, after=None, before=None):
    text = (pathlib.Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    if after:
        text = text[text.index(after):]
    if before:
        text = text[:text.index(before)]
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)
