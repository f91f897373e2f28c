# SPDX-License-Identifier: BSD-3-Clause
"""Writes AddLabels, with which messages have the labels of panels: write_labels.py FOLDER_OF_OPTIONS.PY
OUTPUT FILE.xml..."""

import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import options  # noqa: E402
from options import quoted  # noqa: E402


def name(one):
    return f'"{one.label if isinstance(one, options.Filter) else one.shown}"'


def main():
    filters = options.read(sys.argv[3:])
    classes = {cls: f'"{label}"' for cls, label in options.VTK_FILTERS.items()}
    calls = []
    for one in filters:
        words = ", ".join(f"{{ {quoted(key)}, {quoted(value)} }}"
                          for key, value in options.words(one, filters, name, classes).items())
        calls.append(f"  subdivision::AddWords({quoted(one.cls)}, {{ {words} }});\n")
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(f"""// Made by Plugin/write_labels.py from the files beside it. Edit those.
#include "Labels.h"
#include "Words.h"

void AddLabels()
{{
{"".join(calls)}}}
""")


main()
