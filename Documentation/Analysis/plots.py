# SPDX-License-Identifier: BSD-3-Clause
"""Plots of the pages, made of the numbers of their tables. matplotlib is loaded only where something is drawn."""

from pages import FOLDER


def figure():
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot
    made, axes = matplotlib.pyplot.subplots(figsize=(6, 3.6), dpi=100)
    axes.spines[["top", "right"]].set_visible(False)
    return made, axes


def save(made, axes, name):
    if axes.get_legend_handles_labels()[0]:
        axes.legend(frameon=False, fontsize=8)
    made.tight_layout()
    made.savefig(FOLDER / f"{name}.png", metadata={"Software": None})  # nothing in the file that changes by itself


def spectrum(name, rows):
    made, axes = figure()
    k = [int(row[0]) for row in rows]
    axes.plot(k, [float(row[1]) for row in rows], "o-", markersize=3, label="l1 = l2")
    axes.plot(k, [float(row[3]) for row in rows], "s-", markersize=3, label="|l3|")
    axes.set_xlabel("faces around the vertex")
    axes.set_ylabel("eigenvalue")
    axes.set_ylim(0, 0.75)
    save(made, axes, name)


def curves(name, series, across, up, logarithmic=True):
    """Lines of (label, xs, ys)."""
    made, axes = figure()
    for (label, xs, ys), mark in zip(series, "os^vDP*X<>ph" * 2):
        axes.plot(xs, ys, mark + "-", markersize=4, linewidth=1, label=label)
    if logarithmic:
        axes.set_yscale("log")
    axes.set_xlabel(across)
    axes.set_ylabel(up)
    save(made, axes, name)


def gaps(name, rows):
    made, axes = figure()
    k = [int(row[0]) for row in rows]
    axes.fill_between(k, [float(row[2]) for row in rows], [float(row[3]) for row in rows], alpha=0.3)
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set_xlabel("valence of the vertex")
    axes.set_ylabel("l3 - l4")
    save(made, axes, name)
