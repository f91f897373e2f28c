# SPDX-License-Identifier: BSD-3-Clause
"""Tables whose rows can be computed one by one, the pages that hold them, and the comparison of both."""

import dataclasses
import pathlib
import re
from typing import Callable

FOLDER = pathlib.Path(__file__).resolve().parent
NUMBER = re.compile(r"-?\d+\.\d+")


@dataclasses.dataclass
class Row:
    """A row: what it is about, and a function that computes the other columns."""
    key: str
    compute: Callable[[], list]


@dataclasses.dataclass
class Table:
    title: str
    text: str
    columns: list
    rows: list
    plot: str = ""  # name of a file beside the page, which the page's `draw` makes
    caption: str = ""


@dataclasses.dataclass
class Page:
    name: str
    title: str
    text: str
    tables: list
    draw: Callable = None  # takes the texts of all tables, by title
    claims: list = dataclasses.field(default_factory=list)  # pairs of a sentence of the page and what has to hold for it


def number(value, digits=4):
    """Without a minus before zero, so that rounding does not change a sign."""
    text = f"{value:.{digits}f}"
    return text.lstrip("-") if float(text) == 0 else text


def yes(value):
    return "yes" if value else "no"


def line(cells):
    return "| " + " | ".join(cells) + " |"


def write(page):
    """Computes and writes a page; its tables as lists of lists of texts, by title."""
    made, lines = {}, [f"# {page.title}", "", page.text.strip(), ""]
    for table in page.tables:
        print(f"{page.name}: {table.title}", flush=True)
        rows = made[table.title] = [[row.key] + row.compute() for row in table.rows]
        lines += [f"## {table.title}", "", table.text.strip(), "", line(table.columns), line(["---"] * len(table.columns))]
        lines += [line(row) for row in rows] + [""]
        if table.plot:
            lines += [f"![{table.caption}]({table.plot})", "", f"*{table.caption}*", ""]
    (FOLDER / f"{page.name}.md").write_text("\n".join(lines), encoding="utf-8")
    if page.draw:
        page.draw(made)


def read(page):
    """The tables of a page as it stands, by title."""
    found, title = {}, ""
    for text in (FOLDER / f"{page.name}.md").read_text(encoding="utf-8").splitlines():
        if text.startswith("## "):
            title = text[3:]
        elif text.startswith("| ") and not text.startswith("| ---"):
            found.setdefault(title, []).append(text[2:-2].split(" | "))
    return {title: rows[1:] for title, rows in found.items()}


def column(page, title, name):
    """A column of a table of a page as it stands: from keys to texts."""
    table, = (table for table in page.tables if table.title == title)
    return {row[0]: row[table.columns.index(name)] for row in read(page)[title]}


def numbers(page, title, name):
    """The same as numbers, where there are some; keys too."""
    return {float(key): float(text) for key, text in column(page, title, name).items() if text != "-"}


def holds_for(page, title, name, answer="yes"):
    """The keys of the rows which have this answer."""
    return [key for key, text in column(page, title, name).items() if text == answer]


def is_all(text):
    """Whether a text such as "5 of 5" has the same number twice."""
    some, _, of = text.partition(" of ")
    return some == of


def untrue_claims(page):
    """The sentences that the page does not have, or that its tables do not show."""
    text = " ".join((FOLDER / f"{page.name}.md").read_text(encoding="utf-8").split())
    return [sentence for sentence, holds in page.claims if sentence not in text or not holds(page)]


def is_same(written, computed):
    """Equal but for one unit in the last digit of a decimal number, which is rounding."""
    if NUMBER.sub("#", written) != NUMBER.sub("#", computed):
        return False
    for a, b in zip(NUMBER.findall(written), NUMBER.findall(computed)):
        digits = len(a.partition(".")[2])
        if len(b.partition(".")[2]) != digits or abs(float(a) - float(b)) > 1.01 * 10 ** -digits:
            return False
    return True


def differences(page, turn=None):
    """What does not agree between a page and its computation, and how many rows were computed: of a turn (0, 1 or 2) each
    third one, and each one in some turn."""
    faults, count, written = [], 0, read(page)
    if list(written) != [table.title for table in page.tables]:
        return [f"{page.name}: the page has the tables {list(written)}"], 0
    for table in page.tables:
        rows = {row[0]: row for row in written[table.title]}
        if list(rows) != [row.key for row in table.rows]:
            faults.append(f"{page.name}, {table.title}: the page has the rows {list(rows)}")
            continue
        for row in table.rows[turn::3] if turn is not None else table.rows:
            count += 1
            computed = [row.key] + row.compute()
            shown = rows[row.key]
            if len(shown) != len(computed) or not all(map(is_same, shown, computed)):
                faults.append(f"{page.name}, {table.title}: the page has {shown}, computed was {computed}")
    return faults, count
