# SPDX-License-Identifier: BSD-3-Clause
"""What options a function has, as its panel in ParaView has them: options("subdivide")."""

from __future__ import annotations

import re
import textwrap
from typing import Callable, Dict, List, Mapping, Optional, Union

from .run import FILTERS, Filter, Option, find_filter, plain

WIDTH = 100


class Listing(Dict[str, Union[str, Option]]):
    """A dictionary that is shown as a text."""

    def __init__(self, found: Mapping[str, Union[str, Option]], text: str) -> None:
        super().__init__(found)
        self.text = text

    def __repr__(self) -> str:
        return self.text


def options(function: Union[None, str, Callable[..., object]] = None, word: Optional[str] = None) -> Listing:
    """The options of a function, or of its name, with defaults; those that have a word in their names with all of their
    help. Without a function: all functions.

        options("subdivide")
        options("subdivide", "crease")
        options("subdivide")["levels"].default
    """
    if function is None:
        lines = [f"{name:32} {one.label}: {one.help}" for name, one in FILTERS.items()]
        return Listing({name: one.help for name, one in FILTERS.items()}, "\n".join(lines))
    one = find_filter(function)
    if word is None:
        return Listing(by_all_names(one, one.options), brief_text(one))
    found = with_word(one, word)
    if not found:
        raise ValueError(f"no option of {one.name} has the word {word!r} in its name or help")
    return Listing(by_all_names(one, found), "\n\n".join(full_text(one, name) for name in found))


def by_all_names(one: Filter, found: Dict[str, Option]) -> Dict[str, Option]:
    """Options by their names, and by their shorter ones."""
    return {**found, **{short: found[name] for short, name in one.aliases.items() if name in found}}


def with_word(one: Filter, word: str) -> Dict[str, Option]:
    """The options that have a word in their names; where there are none, those that have it in their help."""
    word = plain(word)
    named = {name: option for name, option in one.options.items() if word in plain(" ".join(names_of(one, name)))}
    return named or {name: option for name, option in one.options.items() if word in plain(option.help)}


def names_of(one: Filter, name: str) -> List[str]:
    """The name of an option, behind shorter ones."""
    return [short for short, full in one.aliases.items() if full == name] + [name]


def brief_text(one: Filter) -> str:
    """A line for each option, in the groups of the panel."""
    groups: Dict[str, List[str]] = {}
    for name, option in one.options.items():
        start = f"{', '.join(names_of(one, name))} = {option.default!r}"
        help_ = textwrap.shorten(re.split(r"(?<=\.)\s", option.help)[0], WIDTH - 8, placeholder=" ...")
        groups.setdefault(option.group, []).append(f"  {start}\n      {help_}")
    parts = [f"{one.name} ({one.label}): {one.help}", *(textwrap.fill(part, WIDTH) for part in one.more_help.split("\n"))]
    parts.append(f'{len(one.options)} options; options("{one.name}", word) explains those that have a word.')
    return "\n\n".join(parts + ["\n".join([f"{group or 'General'}:"] + lines) for group, lines in groups.items()])


def full_text(one: Filter, name: str) -> str:
    """The names of an option, its values and all of its help."""
    option = one.options[name]
    values = f", one of {', '.join(map(repr, option.entries))}" if option.entries else ""
    head = textwrap.fill(
        f"{', '.join(names_of(one, name))} = {option.default!r}{values}", WIDTH, subsequent_indent="  "
    )
    return f"{head}\n{textwrap.fill(option.help, WIDTH, initial_indent='    ', subsequent_indent='    ')}"
