# SPDX-License-Identifier: BSD-3-Clause
"""Writes titles and tables of properties in Documentation/Guide anew: write_tables.py [--check] FILE.xml...

The files are those of Plugin after CMake pasted what they share. The tables stand below the line "<!-- properties -->" of
the page that has the name of the filter. Rows that several filters have stand once, in CommonProperties.md, by the groups
of the panels, those of most filters first; the pages of these filters name them. With --check it writes nothing, and fails
where a page would change."""

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
OTHERS = "Further properties"  # of no group
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
    """Group and property by name: the text that most filters have, if two have it, or three where no panel has a group for it.
    The groups of most filters come first."""
    texts = collections.defaultdict(list)
    for one in filters:
        for option in one.options:
            texts[option.name].append((option.label, option.help))
    common = {}
    for one in sorted(filters, key=lambda one: -len(one.options)):
        for option in one.options:
            group = next((found[option.name] for found in groups.values() if option.name in found), OTHERS)
            most = collections.Counter(texts[option.name]).most_common(1)
            if most[0][1] > (2 if group == OTHERS else 1) and most[0][0] == (option.label, option.help):
                common.setdefault(option.name, (group, option))
    most = collections.Counter()
    for name, (group, _) in common.items():
        most[group] = max(most[group], len(texts[name]))
    return dict(sorted(common.items(), key=lambda item: (item[1][0] == OTHERS, -most[item[1][0]])))


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


def of_common(common):
    groups = collections.defaultdict(list)
    for group, option in common.values():
        groups[group].append(option)
    return "".join(f"\n## {group}\n\n" + table(properties) for group, properties in groups.items())


def new_page(page, title, tables):
    text = page.read_text(encoding="utf-8")
    return f"# {title}\n" + text[text.index("\n") + 1:text.index(MARK)] + MARK + tables


def main():
    check = sys.argv[1] == "--check"
    paths = sys.argv[2 if check else 1:]
    filters = options.read(paths)
    common = find_common(filters, read_groups(paths))
    made = [(COMMON, "Common properties", of_common(common))]
    made += [(f"{one.name}.md", one.label, of_page(one, common)) for one in filters]
    changed = []
    for name, title, tables in made:
        page = here / "Guide" / name
        text = new_page(page, title, tables)
        if text != page.read_text(encoding="utf-8"):
            changed.append(name)
            if not check:
                page.write_text(text, encoding="utf-8")
    if check and changed:
        sys.exit(f"tables are not those of Plugin in {', '.join(changed)}: cmake --build build/vtk --target guide_tables writes them")


main()
