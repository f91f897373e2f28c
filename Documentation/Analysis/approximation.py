# SPDX-License-Identifier: BSD-3-Clause
"""Page on how fast errors fall when control meshes are refined and follow samples of a smooth function."""

import numpy as np
import pages
import plots
from errors import CORRECTIONS, curve_errors, solid_errors, surface_errors
from pages import Page, Row, Table, number
from solid_maps import BOX_SPLINE, TET_OCT
from surface_matrices import FOUR_EIGHT, SQRT_THREE, quad_matrix
from surface_tools import CATMULL_CLARK, LOOP, quad_star, spectrum
from surfaces import (BUTTERFLY, DOO_SABIN, MIDEDGE, butterfly_value, catmull_clark_value, loop_value, midedge_value,
                      sqrt_three_value)


def four_eight_value(k):
    return spectrum(quad_matrix(quad_star(k, 2 * np.pi, True), k, True)[1])[1]


# The scheme, how smooth it lets its functions be, and l1.
SURFACES = {
    "Loop": (LOOP, 3, loop_value), "Catmull-Clark": (CATMULL_CLARK, 3, catmull_clark_value),
    "Butterfly": (BUTTERFLY, 2, butterfly_value), "sqrt(3)": (SQRT_THREE, 3, sqrt_three_value),
    "4-8": (FOUR_EIGHT, 3, four_eight_value), "Doo-Sabin": (DOO_SABIN, 2, lambda k: 1 / 2),
    "Midedge": (MIDEDGE, 2, midedge_value)}
TEXTS = {"sqrt(3)": "Steps are two levels, which divide lengths by 3.", "4-8": "Steps are two levels.",
         "Doo-Sabin": "A face of so many corners in the middle of the first step; so many quads around a vertex before it.",
         "Midedge": "The same; steps are two levels."}
SOLIDS = {"Solids, box spline": BOX_SPLINE, "Solids, tet/oct": TET_OCT}
FACES = (3, 4, 5, 6, 7, 8, 10, 12)
# Rows of pages, by the name of their first column; tables with another name show all.
SHOWN = {"faces": ["4", "6", "7", "12"],
         "where": ["lattice", "edge of 4", "edge of 8", "vertex of 12"]}
REGULAR = {"Loop": "6", "Catmull-Clark": "4", "Butterfly": "6", "sqrt(3)": "6", "4-8": "4", "Doo-Sabin": "4", "Midedge": "4"}
ORDERS = {"Loop": 4, "Catmull-Clark": 4, "Butterfly": 4, "sqrt(3)": 3, "4-8": 6, "Doo-Sabin": 3, "Midedge": 3}
PLACES = [("lattice", 0), *(("edge", n) for n in range(3, 9)), *(("vertex", n) for n in (4, 6, 12))]

# ------------------------------------------------------------ rows and tables


def orders(found, factor=2):
    """Texts of both orders between the last two, if a step divides lengths by a factor."""
    return [number(np.log(a / b) / np.log(factor), 2) for a, b in zip(found[-2], found[-1])]


def largest(found):
    return [f"{one:.1e}" for one, _ in found]


def bound(power, value, factor):
    """The order that the power of the larger one of l1 and its value on regular meshes means."""
    return [number(power * np.log(1 / max(value, 1 / factor)) / np.log(factor), 2)]


def surface_row(name, k):
    scheme, power, value = SURFACES[name]
    factor = 3 if name == "sqrt(3)" else 2
    values, slopes = surface_errors(scheme, k, "wave")
    others = surface_errors(scheme, k, "bell")
    return (largest(values) + orders(values, factor) + bound(power, value(k), factor) + orders(slopes, factor)
            + bound(power - 1, value(k), factor) + orders(others[0], factor) + orders(others[1], factor)[1:])


def both(wave, bell):
    return largest(wave) + orders(wave) + orders(bell)


def solid_row(scheme, kind, count):
    return both(*solid_errors(scheme, kind, count))


def table(title, text, key, steps, rows, slopes=()):
    columns = [key] + [f"step {step}" for step in range(1, steps + 1)] + ["order", "order in L2", *slopes, "bell",
                                                                          "bell in L2"]
    return Table(title, text, columns + (["bell, slopes in L2"] if slopes else []), rows,
                 f"Approximation{plots.plain(title)}.png", f"{title}: largest error by steps.",
                 SHOWN.get(key), [name for name in columns if name.startswith("step")] + ["bell", "bell in L2"] + (
                     ["slopes", "slopes in L2", *slopes[-1:], "bell, slopes in L2"] if slopes else []))


def surface_table(name):
    of = "Theorem 7" if name == "Loop" else "as Theorem 7"
    return table(name, TEXTS.get(name, ""), "faces",
                 3 if name == "sqrt(3)" else 4, [Row(str(k), lambda k=k: surface_row(name, k)) for k in FACES],
                 [of, "slopes", "slopes in L2", f"{of}, s = 1"])


def solid_table(title, scheme):
    return table(title, "The same places." if scheme == TET_OCT else
                 "*Lattice*: the middle of a tetrahedron after three to six steps. Others after one to four steps: "
                 "the middle of an edge of so many tetrahedra, and a vertex whose neighbours are the corners of a tetrahedron, an "
                 "octahedron or an icosahedron.", "where", 4,
                 [Row(kind + (f" of {count}" if count else ""), lambda kind=kind, count=count: solid_row(scheme, kind, count))
                  for kind, count in PLACES])


def draw(made):
    for title, rows in made.items():
        steps = 3 if title == "sqrt(3)" else 4
        label = "{} faces" if title in SURFACES else "{}"
        plots.curves(f"Approximation{plots.plain(title)}",
                     [(label.format(row[0]), list(range(1, steps + 1)), [float(one) for one in row[1:steps + 1]])
                      for row in rows], "steps", "largest error")


# ------------------------------------------------------------ sentences that the rows have to show


def theorem(page, title):
    return next(name for name in ("Theorem 7", "as Theorem 7")
                if any(name in table.columns for table in page.tables if table.title == title))


def is_met(page, title):
    """Whether orders in L2 are at least those of the theorem, of values and of slopes, of both functions, in each row."""
    of = theorem(page, title)
    pairs = [("order in L2", of), ("bell in L2", of), ("slopes in L2", f"{of}, s = 1"), ("bell, slopes in L2", f"{of}, s = 1")]
    return all(pages.numbers(page, title, found)[key] >= pages.numbers(page, title, least)[key]
               for found, least in pairs for key in map(float, FACES))


def is_near(page, title, key, order, names=("order", "order in L2", "bell", "bell in L2")):
    """Whether orders are as expected, or a little larger: errors of few levels do not tell more."""
    return all(order - .1 < float(pages.column(page, title, name)[key]) for name in names)


def between(page, titles, name, keys, least, most):
    """Whether a column is in a range, in all rows with these keys."""
    return all(least <= float(pages.column(page, title, name)[key]) <= most for title in titles for key in keys)


TEXT = f"""
How fast does the error fall when control meshes get finer? Order 4 means that halving all lengths divides the error by 16.

**What it shows.** Regular meshes of Loop (6 triangles), Catmull-Clark (4 quads), Butterfly, curves and solids on
lattices have order 4, as box splines and B-splines have; sqrt(3), Doo-Sabin and midedge have 3, and 4-8 has 6. Orders
of slopes are smaller by 1 there; those of 4-8 are not, at these points.

Near extraordinary vertices the mesh is coarser: its edges shrink by l1 for each step, and not by 1/2. The largest error has
order 2 and less for 7 and more triangles of Loop, and 5 and more quads of Catmull-Clark and 4-8. Midedge is the worst: order
0.2 in a face of 12.

**Theorem 7** of [Z] bounds the L2 error of the *best* approximation by Loop's functions. The bound is the largest l1, at least
1/2, to the power 3 - s for each step; s = 1 is for the first derivatives. The column has it as an order, the file also for s = 1. What is measured
here meets the bound at every valence, for both functions, and so it does the same bound with the l1 of the other schemes. (For
these [Z] has no such theorem. Butterfly, Doo-Sabin and midedge are C^1, so that their power is 2 - s.) A second estimate of the
survey, order 4 in L2 at every valence with another notion of smoothness, is not met by interpolation of a function that is
smooth in the plane: 2.90 at 7 triangles.

**Solids.** Around extraordinary edges and vertices the L2 error has order 2.5 to 3.9, the largest one 1.4 to 3.2. An edge of 4
of the box spline is regular, and has order 4 like the lattice.

**What is measured.** A plane mesh with three rings around a vertex of *k* faces is subdivided several times and projected to
its limit. Its points get the heights sin(1.3 x + 0.4) cos(1.1 y - 0.3). *InterpolatePoints* finds the control points whose
limit goes through all of them. For x and y these are the control points of the subdivided plane mesh, so that the spaces of
functions are nested as in Theorem 7. Butterfly interpolates by itself. On quads 4-8 and midedge have no such control points:
heights of control points begin as the function, and the error of the limit is added to them {CORRECTIONS} times.
The limit at all points two levels finer (Butterfly: four) is compared with the function at their x and y, up to a distance of 1
from the vertex. The L2 error is taken over the points, not by area. *Slopes* are errors of the gradient, from limit normals at
points two levels finer. The file has the errors of each step, too, and orders for a second function, *bell*:
1 / (1 + x^2 + 0.3 x + 0.5 y^2).

In solids both functions depend on z, too (`errors.py`), and values are not interpolated: the error of the limit is added to
them once."""

CLAIMS = [
    ("Regular meshes of Loop (6 triangles), Catmull-Clark (4 quads), Butterfly, curves and solids on lattices have order 4, as "
     "box splines and B-splines have; sqrt(3), Doo-Sabin and midedge have 3, and 4-8 has 6.",
     lambda page: all(is_near(page, name, REGULAR[name], order, ("order", "order in L2")) for name, order in ORDERS.items())
     and all(is_near(page, name, REGULAR[name], order) for name, order in ORDERS.items() if name != "4-8") and all(
         is_near(page, *place, 4) for place in (("Curves", "all equal"), ("Curves", "1 : 3 in turn"), *(
             (title, "lattice") for title in SOLIDS)))),
    ("Orders of slopes are smaller by 1 there; those of 4-8 are not, at these points.",
     lambda page: all(between(page, [name], title, [REGULAR[name]], order - 1.05, order - .9)
                      for name, order in ORDERS.items() if name != "4-8" for title in ("slopes", "slopes in L2"))
     and between(page, ["4-8"], "slopes", "4", 5.9, 6.1)),
    ("What is measured here meets the bound at every valence, for both functions, and so it does the same bound with the l1 of the "
     "other schemes.", lambda page: all(is_met(page, name) for name in SURFACES)),
    ("is not met by interpolation of a function that is smooth in the plane: 2.90 at 7 triangles.",
     lambda page: pages.column(page, "Loop", "order in L2")["7"] == "2.90"),
    ("The largest error has order 2 and less for 7 and more triangles of Loop, and 5 and more quads of Catmull-Clark and 4-8.",
     lambda page: all(value <= 2 for title, first in (("Loop", 7), ("Catmull-Clark", 5), ("4-8", 5))
                      for key, value in pages.numbers(page, title, "order").items() if key >= first)),
    ("Midedge is the worst: order 0.2 in a face of 12.",
     lambda page: between(page, ["Midedge"], "order", ["12"], .15, .25)
     and all(pages.numbers(page, name, "order")[12] > .25 for name in SURFACES if name != "Midedge")),
    ("Around extraordinary edges and vertices the L2 error has order 2.5 to 3.9, the largest one 1.4 to 3.2.",
     lambda page: all(between(page, [title], name, [row.key for row in table.rows if row.key != "lattice" and (
         title, row.key) != ("Solids, box spline", "edge of 4")], *of)
         for table in page.tables for title in [table.title] if title in SOLIDS
         for name, of in (("order in L2", (2.5, 3.9)), ("bell in L2", (2.5, 3.9)), ("order", (1.4, 3.2)), ("bell", (1.4, 3.2))))),
    ("An edge of 4 of the box spline is regular, and has order 4 like the lattice.",
     lambda page: is_near(page, "Solids, box spline", "edge of 4", 4, ("order in L2", "bell in L2"))),
]


def make_page():
    lengths = {"all equal": 1, "1 : 3 in turn": 3}
    curves = table("Curves", "A polyline along x, by the lengths of its edges; y is 0.", "lengths", 4, [
        Row(text, lambda ratio=ratio: both(*(curve_errors(ratio, name) for name in ("wave", "bell"))))
        for text, ratio in lengths.items()])
    return Page("ApproximationOrder", "Approximation order, measured", TEXT, [surface_table(name) for name in SURFACES] + [
        curves] + [solid_table(title, scheme) for title, scheme in SOLIDS.items()], draw, CLAIMS)
