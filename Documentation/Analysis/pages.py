# SPDX-License-Identifier: BSD-3-Clause
"""Tables whose rows can be computed one by one, the files that hold them, the pages that show some of them, and the comparison
of files with what is computed."""

import csv
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
    keys: list = None  # rows that the page shows, all if there is no list; without a row it leaves the table to the file
    hidden: list = dataclasses.field(default_factory=list)  # columns that the page does not show


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


def file_of(page, ending):
    return FOLDER / f"{page.name}.{ending}"


def write(page):
    """Computes the rows of a page, and writes the file that has them and the page that shows some."""
    made = {}
    for table in page.tables:
        print(f"{page.name}: {table.title}", flush=True)
        made[table.title] = [[row.key] + row.compute() for row in table.rows]
    with open(file_of(page, "csv"), "w", encoding="utf-8", newline="") as file:
        for table in page.tables:
            csv.writer(file, lineterminator="\n").writerows(
                [table.title, *cells] for cells in [table.columns, *made[table.title]])
    write_text(page)
    if page.draw:
        page.draw(made)


def write_text(page):
    file_of(page, "md").write_text(render(page, read(page)), encoding="utf-8")


def lines_of(table, rows):
    """The lines of a table of a page: rows and columns that it shows."""
    columns = [i for i, name in enumerate(table.columns) if name not in table.hidden]
    cells = [row for row in rows if table.keys is None or row[0] in table.keys]
    return [line([row[i] for i in columns]) for row in [table.columns, ["---"] * len(table.columns), *cells]]


def picture(table, first):
    """A plot, with its caption unless the page's first plot has the same words about another title."""
    said = table is not first and table.caption.replace(table.title, "") == first.caption.replace(first.title, "")
    return [f"![{table.title}]({table.plot})", ""] + ([] if said else [f"*{table.caption}*", ""])


def render(page, made):
    """The text of a page, which begins with its first plot; rows of tables as lists of lists of texts, by title."""
    first = next((table for table in page.tables if table.plot), None)
    lines = [f"# {page.title}", "", *(picture(first, first) if first else []), page.text.strip(), ""]
    if any(table.keys is not None or table.hidden for table in page.tables):
        count = sum(map(len, made.values()))
        left = "; ".join(table.title for table in page.tables if table.keys == [])
        lines += [f"Tables show some rows and columns; [{page.name}.csv]({page.name}.csv) has all {count} rows."
                  + (f" It alone has the tables of: {left}." if left else ""), ""]
    for table in (table for table in page.tables if table.keys != []):
        lines += [f"## {table.title}", ""] + ([table.text.strip(), ""] if table.text else [])
        lines += [*lines_of(table, made[table.title]), ""]
        if table.plot and table is not first:
            lines += picture(table, first)
    return "\n".join(lines)


def read_file(page):
    """The tables of the file of a page as it stands, by title; columns come first."""
    found = {}
    with open(file_of(page, "csv"), encoding="utf-8", newline="") as file:
        for title, *cells in csv.reader(file):
            found.setdefault(title, []).append(cells)
    return found


def read(page):
    """The rows of the file of a page, by the titles of their tables."""
    return {title: rows for title, (_, *rows) in read_file(page).items()}


def column(page, title, name):
    """A column of a table in the file of a page: from keys to texts."""
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
    """The sentences that the page does not have, or that its rows do not show."""
    text = " ".join(file_of(page, "md").read_text(encoding="utf-8").split())
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
    """What does not agree between the file of a page and its computation, and how many rows were computed: of a turn (0, 1
    or 2) each third one, and each one in some turn."""
    faults, count, written = [], 0, read(page)
    if [(title, columns) for title, (columns, *_) in read_file(page).items()] != [
            (table.title, table.columns) for table in page.tables]:
        return [f"{page.name}: the file has the tables {list(written)}, or columns that are other ones"], 0
    for table in page.tables:
        rows = {row[0]: row for row in written[table.title]}
        if list(rows) != [row.key for row in table.rows]:
            faults.append(f"{page.name}, {table.title}: the file has the rows {list(rows)}")
            continue
        for row in table.rows[turn::3] if turn is not None else table.rows:
            count += 1
            computed = [row.key] + row.compute()
            shown = rows[row.key]
            if len(shown) != len(computed) or not all(map(is_same, shown, computed)):
                faults.append(f"{page.name}, {table.title}: the file has {shown}, computed was {computed}")
    return faults, count
