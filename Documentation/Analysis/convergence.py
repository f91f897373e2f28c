# SPDX-License-Identifier: BSD-3-Clause
"""Page on how fast the error of a solver falls on curved cells, beside the same cells with straight edges."""

import itertools

import numpy as np
import pages
import plots
from pages import Page, Row, Table, number

import subdivisionobjects
from subdivisionobjects.solvers import shape_of, vtk_places

LEVELS = (0, 1, 2, 3)
LEVELS_OF_SOLIDS = (0, 1, 2)
ORDERS = (1, 2, 3, 4)
ORDERS_OF_SOLIDS = (1, 2)  # others take a minute each
LAGRANGE = {"VTK_LAGRANGE_TRIANGLE": 69, "VTK_LAGRANGE_TETRAHEDRON": 71, "VTK_LAGRANGE_HEXAHEDRON": 72}

# ------------------------------------------------------------ domains


def ring(count, circles):
    """Control triangles between two curves, which are no circles. Six meet inside, three at the boundary: all is regular."""
    angles = 2 * np.pi * np.arange(count) / count
    points = [[r * np.cos(a) * (1 + 0.1 * np.sin(2 * a)), r * np.sin(a)] for r in np.linspace(1, 2, circles) for a in angles]
    triangles = []
    for c in range(circles - 1):
        for i in range(count):
            a, b = c * count + i, c * count + (i + 1) % count
            triangles += [[a, a + count, b + count], [a, b + count, b]]
    return np.array(points), np.array(triangles)


def star(count):
    """Control triangles around a vertex of so many, and a ring around them."""
    points, triangles = ring(count, 2)
    centre = len(points)
    fan = [[centre, i, (i + 1) % count] for i in range(count)]
    return np.vstack([points, [[0, 0]]]), np.vstack([triangles, fan])


def plane(mesh, levels, order):
    points, triangles = mesh
    return subdivisionobjects.surface_subdivision(np.column_stack([points, np.zeros(len(points))]), {"triangle": triangles},
                                                  scheme="Loop", levels=levels, output_cells="Lagrange", cell_order=order)


def torus(shape, levels, order, keeps=False):
    """Hexahedra in a ring whose four long edges are creases, two across; or six tetrahedra in each of them. `keeps`: in the shape of
    the cells of level 0."""
    count, across = 6, 3
    side = np.linspace(-0.6, 0.6, across)
    points = np.array([[(2 + y) * np.cos(a), (2 + y) * np.sin(a), z + 0.2 * np.cos(2 * a)]
                       for a in 2 * np.pi * np.arange(count) / count for y in side for z in side])
    at = np.arange(count * across**2).reshape(count, across, across)
    lines = [[at[i, y, z], at[(i + 1) % count, y, z]] for i in range(count) for y in (0, -1) for z in (0, -1)]
    cubes = [[[[at[(i + a) % count, y + b, z + c] for c in (0, 1)] for b in (0, 1)] for a in (0, 1)]
             for i in range(count) for y in range(across - 1) for z in range(across - 1)]
    if shape == "hexahedron":
        cells = [[cube[a][b][c] for a, b, c in HEXAHEDRON] for cube in cubes]
    else:
        cells = [[cube[a][b][c] for a, b, c in path_of(axes)] for cube in cubes for axes in itertools.permutations(range(3))]
        cells = [cell if np.linalg.det(points[cell[1:]] - points[cell[0]]) > 0 else [*cell[:2], *cell[:1:-1]] for cell in cells]
    options = {"output_cells": "Lagrange", "cell_order": order, "creases": lines, "output_dimensions": "Tetrahedra"}
    made = subdivisionobjects.subdivide(points, {shape: cells}, levels=levels, **options)
    if keeps and levels:
        step = subdivisionobjects.prolongation_matrix(points, {shape: cells}, levels=levels, **options)
        made.points = step.multiply(torus(shape, levels - 1, order, True).points)
    return made


HEXAHEDRON = [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0), (1, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0)]


def path_of(axes):
    """From a corner of a cube to the opposite one, along the axes in turn."""
    at = np.zeros(3, int)
    yield tuple(at)
    for axis in axes:
        at[axis] = 1
        yield tuple(at)


DOMAINS = {"Ring": lambda *of: plane(ring(8, 3), *of), "Five triangles at a vertex": lambda *of: plane(star(5), *of),
           "Eight triangles at a vertex": lambda *of: plane(star(8), *of),
           "Solid ring, hexahedra": lambda *of: torus("hexahedron", *of), "Solid ring, tetrahedra": lambda *of: torus("tetra", *of),
           "Solid ring, tetrahedra that keep their shape": lambda *of: torus("tetra", *of, True)}

# ------------------------------------------------------------ rows


def errors(domain, order, levels):
    """Of curved and of straight cells, by level."""
    from solving import Element, l2_error, straight  # needs SciPy

    found = []
    for level in levels:
        made = DOMAINS[domain](level, order)
        (name, cells), = ((name, rows) for name, rows in made.cells_by_type().items() if name in LAGRANGE)
        kind, size = LAGRANGE[name], cells.shape[1]
        shape, _ = shape_of(kind, size)
        dimension = 2 if shape == "triangle" else 3
        places = vtk_places(kind, size, order)[:, :dimension] / order
        element = Element(places, order, shape != "hexahedron")
        points = made.points[:, :dimension].astype(float)
        found.append([l2_error(element, points, cells, points),
                      l2_error(element, straight(element, points, cells), cells, points)])
    return np.array(found).T


def row(domain, order, levels):
    texts = []
    for one in errors(domain, order, levels):
        texts += [f"{error:.1e}" for error in one] + [number(np.log2(one[-2] / one[-1]), 2)]
    return texts


def table(domain, text, levels=LEVELS, orders=ORDERS, drawn=True, shown=None):
    columns = ["p", *(f"curved, level {level}" for level in levels), "curved: order",
               *(f"straight, level {level}" for level in levels), "straight: order"]
    last = [f"curved, level {levels[-1]}", f"straight, level {levels[-1]}"]
    return Table(domain, text, columns, [Row(str(p), lambda p=p: row(domain, p, levels)) for p in orders],
                 f"Convergence{plots.plain(domain)}.png" if drawn else "", f"{domain}: error in L2 by level.", shown,
                 [name for name in columns if "level" in name and name not in last])


def draw(made):
    rows, count = made["Ring"], len(LEVELS)
    curves = [(f"p = {one[0]}", list(LEVELS), [float(text) for text in one[1:count + 1]]) for one in rows]
    curves += [(f"p = {one[0]}, straight", list(LEVELS), [float(text) for text in one[count + 2:2 * count + 2]])
               for one in rows[1:]]
    plots.curves("ConvergenceRing", curves, "level", "error in L2")


# ------------------------------------------------------------ sentences that the rows have to show

TEXT = """
How fast does the error of a solver fall on cells of order p (`OutputCells` = Lagrange), curved or with straight edges?

**What it shows.** On regular meshes the order is p + 1 with curved cells. With straight edges it is 2, whatever p is: on the
ring, cells of order 4 then have an error 40,000 times as large on level 3.

Around a vertex where not six triangles meet the limit is C^1 only. Orders 1 and 2 lose nothing there; order 4 falls to 3.6 around
five triangles, and to 2.8 around eight. Tetrahedra meet boundaries at such edges: order 2 falls to 2.9, and 3 to 3.15 (hexahedra: 3.7). So take
quadratic cells there, or keep the shape of a level: nodes of the next are the prolongation times its nodes. Then order 3 reaches 3.7.

**What is measured.** Poisson's equation is solved by shape functions of Lagrange in cells whose geometry has the same order. The
solution is sin(1.3 x + 0.4) sin(1.1 y + 1.3), in solids times sin(0.9 z + 0.7). A node on the boundary gets the value at the place
of the boundary for which it stands. The error is a part of the solution, the
order that between the last two levels (`solving.py`).
"""


def near(page, title, name, expected, most=.1):
    return all(abs(order - expected(p)) < most for p, order in pages.numbers(page, title, name).items())


def ratio(page, title, p):
    """How many times as large the last error of straight cells is."""
    return float(pages.column(page, title, "straight, level 3")[p]) / float(pages.column(page, title, "curved, level 3")[p])


SOLIDS = ("Solid ring, hexahedra", "Solid ring, tetrahedra")
KEPT = "Solid ring, tetrahedra that keep their shape"
STARS = ("Five triangles at a vertex", "Eight triangles at a vertex")
CLAIMS = [
    ("On regular meshes the order is p + 1 with curved cells.",
     lambda page: near(page, "Ring", "curved: order", lambda p: p + 1)
     and all(abs(pages.numbers(page, SOLIDS[0], "curved: order")[p] - p - 1) < .15 for p in ORDERS_OF_SOLIDS)),
    ("With straight edges it is 2, whatever p is:",
     lambda page: all(near(page, title, "straight: order", lambda p: 2, .2) for title in ("Ring", *SOLIDS, KEPT, *STARS))),
    ("cells of order 4 then have an error 40,000 times as large on level 3.",
     lambda page: 35000 < ratio(page, "Ring", "4") < 50000),
    ("Orders 1 and 2 lose nothing there; order 4 falls to 3.6 around five triangles, and to 2.8 around eight.",
     lambda page: all(abs(pages.numbers(page, title, "curved: order")[p] - p - 1) < .1 for title in STARS for p in (1, 2))
     and [round(pages.numbers(page, title, "curved: order")[4], 1) for title in STARS] == [3.6, 2.8]),
    ("Tetrahedra meet boundaries at such edges: order 2 falls to 2.9, and 3 to 3.15 (hexahedra: 3.7).",
     lambda page: [pages.numbers(page, SOLIDS[1], "curved: order")[p] for p in (2, 3)] == [2.9, 3.15]
     and round(pages.numbers(page, SOLIDS[0], "curved: order")[3], 1) == 3.7),
    ("Then order 3 reaches 3.7.", lambda page: round(pages.numbers(page, KEPT, "curved: order")[3], 1) == 3.7),
]


def make_page():
    return Page("Convergence", "Convergence in a solver, measured", TEXT, [
        table("Ring", "Triangles of Loop between two closed curves: six meet inside, three at boundaries."),
        *(table(title, "With a ring around them.", drawn=False, shown=["4"]) for title in STARS),
        *(table(title, text, LEVELS_OF_SOLIDS, orders, False, [str(p) for p in orders if p > 1]) for title, text, orders in (
            (SOLIDS[0], "Hexahedra that stay (`VolumeScheme` Hybrid), in a ring with four creases.", (*ORDERS_OF_SOLIDS, 3)),
            (SOLIDS[1], "Six tetrahedra (*Standard*) in each of them.", (*ORDERS_OF_SOLIDS, 3)),
            (KEPT, "Parts of cells of level 0.", (3,))))], draw, CLAIMS)
