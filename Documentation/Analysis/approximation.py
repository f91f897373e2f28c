# SPDX-License-Identifier: BSD-3-Clause
"""Page on how fast errors fall when control meshes are refined and interpolate samples of a smooth function."""

import functools

import numpy as np
import pages
import plots
from pages import Page, Row, Table, number
from solid_maps import BOX_SPLINE, TET_OCT, add, point_array, solid, subdivide
from surface_maps import straight
from surface_matrices import SQRT_THREE
from surface_tools import CATMULL_CLARK, LOOP, coordinates, faces_of, lines_of, mesh, quad_star, run, wheel
from surfaces import BUTTERFLY, catmull_clark_value, loop_value, sqrt_three_value

from subdivisionobjects import vtkSurfaceSubdivision

DOO_SABIN = vtkSurfaceSubdivision.DOO_SABIN
NAMES = {"Loop": LOOP, "Catmull-Clark": CATMULL_CLARK, "Butterfly": BUTTERFLY}
OTHERS = {"sqrt(3)": SQRT_THREE, "Doo-Sabin": DOO_SABIN}
LIMIT = {"InterpolatePoints": True, "ProjectToLimit": True}


def wave(x, y):
    return np.sin(1.3 * x + .4) * np.cos(1.1 * y - .3)


def size(off):
    """The largest error, and the root of the mean square."""
    return off.max(), np.sqrt((off ** 2).mean())


@functools.lru_cache(maxsize=None)
def errors(name, k):
    """Errors of the surface whose limit interpolates samples of a function over a plane mesh around a vertex, or in a face,
    of k, by steps (sqrt(3): two each), up to one edge of the first mesh from the vertex."""
    scheme = {**NAMES, **OTHERS}[name]
    quads = scheme in (CATMULL_CLARK, DOO_SABIN)
    made = quad_star(k, 2 * np.pi, True) if quads else straight(wheel(k), k, 2 * np.pi, True)
    found, each = [], 2 if scheme == SQRT_THREE else 1
    for step in range(1, 5 - (scheme == SQRT_THREE)):
        # Limits of points of the same plane surface at each step: interpolation finds this surface again.
        finer = run(made, scheme, each * step, **({} if scheme == BUTTERFLY else {"ProjectToLimit": True}))
        points = coordinates(finer).copy()
        points[:, 2] = wave(points[:, 0], points[:, 1])
        # Butterfly interpolates by itself, and its points are on the limit.
        levels, options = (4, {}) if scheme == BUTTERFLY else (2, LIMIT)
        out = coordinates(run(mesh(points, faces_of(finer)), scheme, levels, **options))
        x, y, z = out[np.hypot(out[:, 0], out[:, 1]) < 1].T
        found.append(size(abs(z - wave(x, y))))
    return found


@functools.lru_cache(maxsize=None)
def curve_errors(ratio):
    """The same for a polyline whose lengths alternate by a ratio."""
    x = np.cumsum([-3] + [2 / (1 + ratio) * (ratio if i % 2 else 1) for i in range(6)])
    made = mesh(np.column_stack([x, 0 * x, 0 * x]), [], lines=[range(len(x))])
    found = []
    for step in range(1, 5):
        finer = run(made, LOOP, step, ProjectToLimit=True)
        points = coordinates(finer).copy()
        points[:, 2] = wave(points[:, 0], 0)
        out = coordinates(run(mesh(points, [], lines=lines_of(finer)), LOOP, 2, **LIMIT))
        inside = abs(out[:, 0]) < 1
        found.append(size(abs(out[inside, 2] - wave(out[inside, 0], 0))))
    return found


@functools.lru_cache(maxsize=None)
def solid_errors(scheme):
    """The same in the middle of a tetrahedron, where the mesh of each level is a lattice; samples are not interpolated but
    get back once what the limit takes from them."""
    made = solid(np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) * 2, [[0, 1, 3, 2]])
    found = []
    for level in range(2, 6):
        control = subdivide(made, scheme, level)
        f = volume_wave(coordinates(subdivide(control, scheme, 0, ProjectToLimit=True)))
        add(control.GetPointData(), "f", f)
        add(control.GetPointData(), "f", 2 * f - point_array(subdivide(control, scheme, 0, ProjectToLimit=True), "f"))
        out = subdivide(control, scheme, 1, ProjectToLimit=True)
        x = coordinates(out)
        inside = np.linalg.norm(x, axis=1) < .4
        found.append(size(abs(point_array(out, "f") - volume_wave(x))[inside]))
    return found


def volume_wave(points):
    x, y, z = points.T
    return wave(x, y) * np.cos(.7 * z + .2)


def orders(found, factor=2):
    """Texts of the largest errors, and both orders between the last two, if a step divides lengths by a factor."""
    last = [np.log(a / b) / np.log(factor) for a, b in zip(found[-2], found[-1])]
    return [f"{largest:.1e}" for largest, _ in found] + [number(one, 2) for one in last]


def bound(power, value, factor=2):
    """The order that the power of the larger one of l1 and its value on regular meshes means."""
    return [number(power * np.log(1 / max(value, 1 / factor)) / np.log(factor), 2)]


def surface_orders(name, k):
    if name == "sqrt(3)":
        return orders(errors(name, k), 3) + bound(3, sqrt_three_value(k), 3)
    power = {"Loop": 3, "Catmull-Clark": 3, "Doo-Sabin": 2}
    values = {"Loop": loop_value, "Catmull-Clark": catmull_clark_value, "Doo-Sabin": lambda k: 1 / 2}
    return orders(errors(name, k)) + (bound(power[name], values[name](k)) if name in power else [])


def table(title, text, key, steps, rows, last=""):
    columns = [key] + [f"step {step}" for step in range(1, steps + 1)] + ["order", "order in L2"]
    draws = title in NAMES
    return Table(title, text, columns + ([last] if last else []), rows,
                 f"Approximation{plots.plain(title)}.png" if draws else "",
                 f"{title}: largest error by steps, for each number of faces." if draws else "")


def surface_table(name):
    text = {"sqrt(3)": "Two steps each time, which divide lengths by 3.",
            "Doo-Sabin": "A face of *k* corners in the middle of the first step; *k* quads around a vertex before it."}
    last = {"Loop": "Theorem 7", "Butterfly": ""}
    return table(name, "Largest errors, and both orders between the last two. " + text.get(name, ""), "faces",
                 3 if name == "sqrt(3)" else 4,
                 [Row(str(k), lambda k=k: surface_orders(name, k)) for k in (3, 4, 5, 6, 7, 8, 10, 12)],
                 last.get(name, "as Theorem 7"))


def draw(made):
    for name in NAMES:
        plots.curves(f"Approximation{plots.plain(name)}",
                     [(f"{row[0]} faces", [1, 2, 3, 4], [float(one) for one in row[1:5]]) for row in made[name]],
                     "steps", "largest error")


def is_met(page, title, name):
    """Whether the order in L2 is at least that of a column, in each row."""
    found, least = pages.numbers(page, title, "order in L2"), pages.numbers(page, title, name)
    return all(found[key] >= least[key] for key in least)


def is_near(page, title, key, order):
    """Whether both orders are as expected, or a little larger: errors of few levels do not tell more."""
    return all(order - .1 < float(pages.column(page, title, name)[key]) for name in ("order", "order in L2"))


CLAIMS = [
    ("Regular meshes of Loop (6 triangles), Catmull-Clark (4 quads), Butterfly, curves and solids on lattices have order 4, as "
     "box splines and B-splines have; sqrt(3) and Doo-Sabin have 3.",
     lambda page: all(is_near(page, *place, 4) for place in (
         ("Loop", "6"), ("Catmull-Clark", "4"), ("Butterfly", "6"), ("Curves", "all equal"), ("Curves", "1 : 3 in turn"),
         ("Solids", "box spline"), ("Solids", "tet/oct")))
     and all(is_near(page, *place, 3) for place in (("sqrt(3)", "6"), ("Doo-Sabin", "4")))),
    ("Interpolation meets it at every valence, and so it does the same bound with the l1 of the other schemes.",
     lambda page: is_met(page, "Loop", "Theorem 7") and all(
         is_met(page, title, "as Theorem 7") for title in ("Catmull-Clark", "sqrt(3)", "Doo-Sabin"))),
    ("is not met by interpolation of a function that is smooth in the plane: 2.90 at 7 triangles.",
     lambda page: pages.column(page, "Loop", "order in L2")["7"] == "2.90"),
    ("The largest error has order 2 and less for 7 and more triangles of Loop, and 5 and more quads of Catmull-Clark",
     lambda page: all(value <= 2 for title, first in (("Loop", 7), ("Catmull-Clark", 5))
                      for key, value in pages.numbers(page, title, "order").items() if key >= first)),
]


def make_page():
    return Page("ApproximationOrder", "Approximation order, measured", """
How fast the error falls when control meshes are refined. A plane mesh with three rings around a vertex of *k* faces is
subdivided and projected to its limit, several times. Its points get the heights sin(1.3 x + 0.4) cos(1.1 y - 0.3).
*InterpolatePoints* finds the control points whose limit goes through all of them: for x and y those of the subdivided plane
mesh, so that the spaces of functions are nested as in Theorem 7 of [Z]. (Butterfly interpolates by itself.) The limit at
all points two levels finer (Butterfly: four) is compared with the function at their x and y, up to a distance of 1
from the vertex. Order 4 means that halving all lengths divides the error by 16. The L2 error is taken over the points, not
by area. 4-8 and midedge are not measured: on quads they have no control points for *InterpolatePoints*.

**What it shows.** Regular meshes of Loop (6 triangles), Catmull-Clark (4 quads), Butterfly, curves and solids on lattices have
order 4, as box splines and B-splines have; sqrt(3) and Doo-Sabin have 3. Theorem 7 bounds
the L2 error of the *best* approximation by Loop's functions by the power 3 of the largest l1, at least 1/2, for each
step; the last column of Loop has this as an order. Interpolation meets it at every valence, and so it does the same
bound with the l1 of the other schemes. (For these there is no such theorem in [Z]; the power of Doo-Sabin is 2, as it is
C^1.) The survey's second estimate, order 4 in L2 at every valence with another notion of smoothness, is not met by
interpolation of a function that is smooth in the plane: 2.90 at 7 triangles. The largest error has order 2 and less
for 7 and more triangles of Loop, and 5 and more quads of Catmull-Clark, as the mesh around the vertex is coarser there:
its edges shrink by l1 and not by 1/2.
""", [surface_table(name) for name in [*NAMES, *OTHERS]] + [
        table("Curves", "A polyline along x, by the lengths of its edges; y is 0.", "lengths", 4,
              [Row("all equal", lambda: orders(curve_errors(1))), Row("1 : 3 in turn", lambda: orders(curve_errors(3)))]),
        table("Solids", "In the middle of a tetrahedron after two to five steps, where its mesh is a lattice. The function is "
              "also multiplied by cos(0.7 z + 0.2). Its values at limits are not interpolated: each control value is the value "
              "there, plus what the limit of these values lacks there.", "scheme", 4,
              [Row("box spline", lambda: orders(solid_errors(BOX_SPLINE))),
               Row("tet/oct", lambda: orders(solid_errors(TET_OCT)))])],
        draw, CLAIMS)
