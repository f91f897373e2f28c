# SPDX-License-Identifier: BSD-3-Clause
"""Plots of the pages, made of the numbers of their tables. matplotlib is loaded only where something is drawn. Each file
tells which numbers it shows, so that a test sees a plot that is older than its table."""

import contextlib
import hashlib
import re
import zlib

from pages import FOLDER

KEYWORD = "Numbers"  # of the text in the file
recorded = None


def plain(title):
    """A title as a part of the name of a file."""
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[^A-Za-z0-9]+", title))


@contextlib.contextmanager
def recording():
    """Nothing is drawn: from names of plots to what their files should tell."""
    global recorded
    recorded = {}
    try:
        yield recorded
    finally:
        recorded = None


def digest(numbers):
    return hashlib.sha256(repr(numbers).encode()).hexdigest()


def told(name):
    """What the file of a plot tells, or None."""
    data = (FOLDER / f"{name}.png").read_bytes()
    at = 8
    while at < len(data):
        length, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        content = data[at + 8:at + 8 + length]
        assert int.from_bytes(data[at + 8 + length:at + 12 + length], "big") == zlib.crc32(kind + content)
        if kind == b"tEXt" and content.startswith(KEYWORD.encode() + b"\0"):
            return content.partition(b"\0")[2].decode()
        at += 12 + length
    return None


def save(name, numbers, draw):
    """Draws into axes, unless it is only asked what would be drawn."""
    if recorded is not None:
        recorded[name] = digest(numbers)
        return
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot
    made, axes = matplotlib.pyplot.subplots(figsize=(6, 3.6), dpi=100)
    axes.spines[["top", "right"]].set_visible(False)
    draw(axes)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(frameon=False, fontsize=8)
    made.tight_layout()
    # Nothing else in the file that changes by itself.
    made.savefig(FOLDER / f"{name}.png", metadata={"Software": None, KEYWORD: digest(numbers)})
    matplotlib.pyplot.close(made)


def spectrum(name, rows, top=0.75):
    lines(name, [("l1 = l2", *numbers_of(rows, 1)), ("|l3|", *numbers_of(rows, 3))], "faces", "eigenvalue", top)


def numbers_of(rows, column):
    return [int(row[0]) for row in rows], [float(row[column]) for row in rows]


def lines(name, series, across, up, top):
    """Lines of (label, xs, ys), from zero up."""
    def draw(axes):
        for (label, xs, ys), mark in zip(series, "os^vDP*X"):
            axes.plot(xs, ys, mark + "-", markersize=3, label=label)
        axes.set_xlabel(across)
        axes.set_ylabel(up)
        axes.set_ylim(0, top)

    save(name, series, draw)


def curves(name, series, across, up):
    """Lines of (label, xs, ys), up by powers."""
    def draw(axes):
        for (label, xs, ys), mark in zip(series, "os^vDP*X<>ph" * 2):
            axes.plot(xs, ys, mark + "-", markersize=4, linewidth=1, label=label)
        axes.set_yscale("log")
        axes.set_xticks(series[0][1])
        axes.set_xlabel(across)
        axes.set_ylabel(up)

    save(name, series, draw)


def gaps(name, rows):
    k, least = numbers_of(rows, 2)
    largest = numbers_of(rows, 3)[1]

    def draw(axes):
        axes.fill_between(k, least, largest, alpha=0.3)
        axes.axhline(0, color="black", linewidth=0.8)
        axes.set_xlabel("valence of the vertex")
        axes.set_ylabel("l3 - l4")

    save(name, (k, least, largest), draw)
