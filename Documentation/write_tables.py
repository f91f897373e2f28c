# SPDX-License-Identifier: BSD-3-Clause
"""Writes titles and tables of properties in Documentation/Guide anew: write_tables.py FILE.xml...

The files are those of Plugin after CMake pasted what they share. The tables stand below the line "<!-- properties -->" of
the page that has the name of the filter. Rows that several filters have stand once, in CommonProperties.md, by the groups
of the panels; the pages of these filters name them."""

import collections
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

sys.dont_write_bytecode = True
here = pathlib.Path(__file__).parent
sys.path.insert(0, str(here.parent / "Plugin"))
import options  # noqa: E402

MARK = "<!-- properties -->\n"
COMMON = "CommonProperties.md"


def property_cell(one):
    """The name, and what the panel shows if that is not the same in words."""
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", one.name)
    shown = words if one.label == one.name else one.label.replace("|", "/")
    return f"`{one.name}`" if shown == words else f"`{one.name}` (*{shown}*)"


def table(properties):
    rows = [f"| {property_cell(one)} | {one.help.replace('|', '/')} |" for one in properties]
    return "\n".join(["| property | what it does |", "|---|---|"] + rows) + "\n"


def anchor(group):
    """What a link behind # calls a section."""
    return re.sub(r"[^\w\- ]", "", group.lower()).replace(" ", "-")


def read_groups(paths):
    """Of each filter the groups of its panel: the label of a group by the name of a property."""
    groups = {}
    for path in paths:
        for proxy in ElementTree.parse(path).getroot().iter("SourceProxy"):
            found = groups.setdefault(proxy.get("name"), {})
            for group in proxy.iter("PropertyGroup"):
                found.update((one.get("name"), group.get("label")) for one in group.iter("Property"))
    return groups


def find_common(filters, groups):
    """Group and property by name, in the order of the panels: of those in groups the text that most filters have, if two have it."""
    texts = collections.defaultdict(list)
    for one in filters:
        for option in one.options:
            if option.name in groups[one.name]:
                texts[option.name].append((option.label, option.help))
    common = {}
    for one in sorted(filters, key=lambda one: -len(one.options)):
        for option in one.options:
            group = groups[one.name].get(option.name)
            most = collections.Counter(texts[option.name]).most_common(1)
            if group and most[0][1] > 1 and most[0][0] == (option.label, option.help):
                common.setdefault(option.name, (group, option))
    return common


def of_page(one, common):
    """The table of a filter, and by group the names of its rows that stand in CommonProperties.md."""
    own, others = [], collections.defaultdict(list)
    for option in one.options:
        group, shared = common.get(option.name, (None, None))
        if shared and (shared.label, shared.help) == (option.label, option.help):
            others[group].append(f"`{option.name}`")
        else:
            own.append(option)
    text = "\n## Properties\n\n" + (table(own) if own else "")
    if others:
        text += f"\n{'It also has' if own else 'It has'} these [common properties]({COMMON}):\n\n"
        text += "".join(f"- [{group}]({COMMON}#{anchor(group)}): {', '.join(names)}\n" for group, names in others.items())
    return text


def write_common(common):
    groups = collections.defaultdict(list)
    for group, option in common.values():
        groups[group].append(option)
    page = here / "Guide" / COMMON
    text = page.read_text(encoding="utf-8")
    text = text[:text.index(MARK)] + MARK
    for group, properties in groups.items():
        text += f"\n## {group}\n\n" + table(properties)
    page.write_text(text, encoding="utf-8")


def main():
    filters = options.read(sys.argv[1:])
    common = find_common(filters, read_groups(sys.argv[1:]))
    write_common(common)
    for one in filters:
        page = here / "Guide" / f"{one.name}.md"
        text = page.read_text(encoding="utf-8")
        text = f"# {one.label}\n" + text[text.index("\n") + 1:text.index(MARK)]
        page.write_text(text + MARK + of_page(one, common), encoding="utf-8")


main()
