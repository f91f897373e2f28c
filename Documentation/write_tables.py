# SPDX-License-Identifier: BSD-3-Clause
"""Writes titles and tables of properties in Documentation/Guide anew: write_tables.py [--check] FILE.xml...

The files are those of Plugin after CMake pasted what they share. The tables stand below the line "<!-- properties -->" of
the page that has the name of the filter; what stands below "<!-- end -->" stays. Rows that several filters have stand once,
in CommonProperties.md, by the groups of the panels, those of most filters first; the pages of these filters name them.
Other rows that two filters have word for word stand on the page of the filter with more properties; the other page names
them, with a link. With --check it writes nothing, and fails where a page would change."""

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
END = "\n<!-- end -->\n"
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


def row_of(option):
    return option.name, option.label, option.help


def find_owners(filters):
    """The filter on whose page a row stands that is not common: of those that have it, the one with most properties."""
    owners = {}
    for one in sorted(filters, key=lambda one: -len(one.options)):
        for option in one.options:
            owners.setdefault(row_of(option), one)
    return owners


def of_page(one, common, owners):
    """The table of a filter, and names of its rows that stand elsewhere: in CommonProperties.md, by group, or on the page of
    another filter."""
    own, others, borrowed = [], collections.defaultdict(list), collections.defaultdict(list)
    for option in one.options:
        group, shared = common.get(option.name, (None, None))
        owner = owners[row_of(option)]
        if shared and row_of(shared) == row_of(option):
            others[f"[{group}]({COMMON}#{anchor(group)})"].append(f"`{option.name}`")
        elif owner is not one:
            borrowed[f"[{owner.label}]({owner.name}.md#properties)"].append(f"`{option.name}`")
        else:
            own.append(option)
    text = "\n## Properties\n\n" + (table(own) if own else "")
    for found, kind in ((others, f"[common properties]({COMMON})"), (borrowed, "properties of another filter")):
        if found:
            text += ("" if text.endswith("\n\n") else "\n") + f"{'It also has' if own else 'It has'} these {kind}:\n\n"
            text += "".join(f"- {where}: {', '.join(names)}\n" for where, names in found.items())
    return text


def of_common(common):
    groups = collections.defaultdict(list)
    for group, option in common.values():
        groups[group].append(option)
    return "".join(f"\n## {group}\n\n" + table(properties) for group, properties in groups.items())


def new_page(page, title, tables):
    text = page.read_text(encoding="utf-8")
    _, end, last = text.partition(END)
    return f"# {title}\n" + text[text.index("\n") + 1:text.index(MARK)] + MARK + tables + end + last


def main():
    check = sys.argv[1] == "--check"
    paths = sys.argv[2 if check else 1:]
    filters = options.read(paths)
    common = find_common(filters, read_groups(paths))
    made = [(COMMON, "Common properties", of_common(common))]
    owners = find_owners(filters)
    made += [(f"{one.name}.md", one.label, of_page(one, common, owners)) for one in filters]
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
