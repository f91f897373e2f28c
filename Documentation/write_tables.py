# SPDX-License-Identifier: BSD-3-Clause
"""Writes titles and tables of properties in Documentation/Guide anew: write_tables.py FILE.xml...

The files are those of Plugin after CMake pasted what they share, and the tables stand below the line
"<!-- properties -->" of the page that has the name of the filter."""

import pathlib
import re
import sys

sys.dont_write_bytecode = True
here = pathlib.Path(__file__).parent
sys.path.insert(0, str(here.parent / "Plugin"))
import options  # noqa: E402

MARK = "<!-- properties -->\n"


def label(one):
    """What the panel shows: without a label of its own the name in words."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", one.name) if one.label == one.name else one.label.replace("|", "/")


def table(title, properties):
    rows = [f"| {label(one)} | `{one.name}` | {one.help.replace('|', '/')} |" for one in properties]
    head = [f"\n## {title}", "", "| in the panel | name | what it does |", "|---|---|---|"]
    return "\n".join(head + rows) + "\n"


def tables(one):
    written = (here.parent / "Plugin" / f"{one.name}.xml").read_text(encoding="utf-8")
    own = [option for option in one.options if f'name="{option.name}"' in written]
    others = [option for option in one.options if option not in own]
    text = table("Properties", own) if own else ""
    if others:
        text += table("Properties that other filters have, too" if own else "Properties", others)
    return text


def main():
    for one in options.read(sys.argv[1:]):
        page = here / "Guide" / f"{one.name}.md"
        text = page.read_text(encoding="utf-8")
        text = f"# {one.label}\n" + text[text.index("\n") + 1:text.index(MARK)]
        page.write_text(text + MARK + tables(one), encoding="utf-8")


main()
