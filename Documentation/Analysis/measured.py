# SPDX-License-Identifier: BSD-3-Clause
"""Pages on what fine meshes show: how first derivatives jump around extraordinary vertices, and how well functions are
approximated."""

import functools

import numpy as np
import plots
from pages import Page, Row, Table, number
from solid_maps import BOX_SPLINE, TET_OCT, moduli, random_star, solid, star_matrix, subdivide, tets_of
from surface_maps import Local, straight
from surface_tools import CATMULL_CLARK, LOOP, coordinates, faces_of, mesh, quad_star, run, wheel
from surfaces import loop_value
from vtkmodules.util.numpy_support import vtk_to_numpy

from subdivisionobjects import vtkSurfaceSubdivision

BUTTERFLY = vtkSurfaceSubdivision.MODIFIED_BUTTERFLY
NAMES = {"Loop": LOOP, "Catmull-Clark": CATMULL_CLARK, "Butterfly": BUTTERFLY}
LEVELS = (2, 4, 6, 8)

# ------------------------------------------------------------ jumps of first derivatives


def gradient_jump(points, values, cells):
    """The largest difference between gradients of linear functions on cells at one vertex, by their largest length."""
    edges = points[cells[:, 1:]] - points[cells[:, :1]]
    rises = values[cells[:, 1:]] - values[cells[:, :1]]
    gradients = np.linalg.solve(edges, rises[..., None])[..., 0]
    spread = np.linalg.norm(gradients[:, None] - gradients[None], axis=2).max()
    return spread / np.linalg.norm(gradients, axis=1).max()


def surface_jumps(scheme, k):
    """The jump around vertex 0 of random heights over a random plane mesh, by level."""
    made = quad_star(k, 2 * np.pi, True, 2) if scheme == CATMULL_CLARK else straight(wheel(k, 3), k, 2 * np.pi, True)
    random = np.random.RandomState(k)
    points = coordinates(made)
    points[:, :2] += random.uniform(-.15, .15, (len(points), 2)) * min(1, 6 / k)
    points[:, 2] = random.uniform(-1, 1, len(points))
    found = []
    for level in LEVELS:
        out = run(made, scheme, level)
        size = 4 if scheme == CATMULL_CLARK else 3
        connectivity = vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, size)
        rows, places = np.nonzero(connectivity == 0)
        cells = np.stack([connectivity[rows, places], connectivity[rows, (places + 1) % size],
                          connectivity[rows, (places - 1) % size]], axis=1)
        x = coordinates(out)
        found.append(gradient_jump(x[:, :2], x[:, 2], cells))
    values = np.abs(Local(scheme, k, "interior").values())
    return found, values[3] / values[2]


def solid_jumps(scheme, valence):
    """The same around a vertex of random tetrahedra: further levels by powers of what one step does."""
    random = np.random.RandomState(200 + valence)
    points, triangles = random_star(random, valence)
    made = solid(np.concatenate([[[0, 0, 0]], points]), [[0, *(face + 1)] for face in triangles])
    first = subdivide(made, scheme)
    matrix, ids = star_matrix(first, 0, scheme)
    numbers = {vertex: i for i, vertex in enumerate(ids)}
    tets = tets_of(first)
    cells = np.array([sorted(numbers[int(v)] for v in tet) for tet in tets[(tets == 0).any(axis=1)]])
    values = np.column_stack([coordinates(first)[ids], random.uniform(-1, 1, len(ids))])
    found = []
    for level in range(1, max(LEVELS) + 1):
        if level in LEVELS:
            found.append(gradient_jump(values[:, :3], values[:, 3], cells))
        values = matrix @ values
        values = values - values[0]
    behind = moduli(matrix)
    return found, behind[3] / behind[2]


def jumps(found, expected):
    rate = (found[-1] / found[-2]) ** (1 / (LEVELS[-1] - LEVELS[-2]))
    return [number(one, 5) for one in found] + [number(rate, 2), number(expected, 2)]


def jump_table(title, text, function, keys, quick, plot=""):
    return Table(title, text, ["faces or valence"] + [f"level {level}" for level in LEVELS] + ["rate", "expected"],
                 [Row(str(k), lambda k=k: jumps(*function(k)), k in quick) for k in keys],
                 plot and f"Jumps{plot}.png", f"{title}: jump by level, for each valence.")


def surface_table(name, scheme, keys):
    return jump_table(name, "Random heights over a random plane mesh.", lambda k: surface_jumps(scheme, k), keys, (3, 4, 5),
                      name if name == "Loop" else "")


# ------------------------------------------------------------ approximation


def wave(x, y):
    return np.sin(1.3 * x + .4) * np.cos(1.1 * y - .3)


@functools.lru_cache(maxsize=None)
def errors(name, k):
    """(largest, root of the mean square) errors of the surface whose limit interpolates samples of a function over a
    plane mesh around a vertex of k faces, after one to four steps, up to one edge of the first mesh from the vertex."""
    scheme = NAMES[name]
    made = quad_star(k, 2 * np.pi, True) if scheme == CATMULL_CLARK else straight(wheel(k), k, 2 * np.pi, True)
    found = []
    for step in range(1, 5):
        # Limits of points of the same plane surface at each step: interpolation finds this surface again.
        finer = run(made, scheme, step, **({} if scheme == BUTTERFLY else {"ProjectToLimit": True}))
        points = coordinates(finer).copy()
        points[:, 2] = wave(points[:, 0], points[:, 1])
        # Butterfly interpolates by itself, and its points are on the limit.
        levels, options = (4, {}) if scheme == BUTTERFLY else (2, {"InterpolatePoints": True, "ProjectToLimit": True})
        out = coordinates(run(mesh(points, faces_of(finer)), scheme, levels, **options))
        x, y, z = out[np.hypot(out[:, 0], out[:, 1]) < 1].T
        off = abs(z - wave(x, y))
        found.append((off.max(), np.sqrt((off ** 2).mean())))
    return found


def orders(name, k):
    found = errors(name, k)
    last = [np.log2(a / b) for a, b in zip(found[-2], found[-1])]
    bound = 3 * np.log2(1 / max(loop_value(k), 1 / 2))
    return [number(largest, 7) for largest, _ in found] + [number(one, 2) for one in last] + (
        [number(bound, 2)] if name == "Loop" else [])


def approximation_table(name):
    columns = ["faces", "step 1", "step 2", "step 3", "step 4", "order", "order in L2"]
    return Table(name, "Largest errors, and both orders between the last two.",
                 columns + (["Theorem 7"] if name == "Loop" else []),
                 [Row(str(k), lambda k=k: orders(name, k), k < 8) for k in (3, 4, 5, 6, 7, 8, 10, 12)],
                 f"Approximation{name.replace('-', '')}.png", f"{name}: largest error by steps, for each number of faces.")


def draw_jumps(made):
    for title, name in (("Loop", "JumpsLoop"), ("Box spline", "JumpsBoxSpline"), ("Tet/oct", "JumpsTetOct")):
        plots.curves(name, [(row[0], LEVELS, [max(float(one), 1e-5) for one in row[1:5]]) for row in made[title]],
                     "level", "jump of first derivatives")


def draw_errors(made):
    for name in NAMES:
        plots.curves(f"Approximation{name.replace('-', '')}",
                     [(f"{row[0]} faces", [1, 2, 3, 4], [float(one) for one in row[1:5]]) for row in made[name]],
                     "steps", "largest error")


def make_pages():
    surfaces = (3, 4, 5, 6, 7, 8, 10, 12)
    tables = [surface_table(name, scheme, surfaces) for name, scheme in NAMES.items()]
    tables += [jump_table(name, f"Around input vertices of random tetrahedra. Levels from 2 on are powers of the matrix of "
                          "one step that the filter makes.", lambda n, scheme=scheme: solid_jumps(scheme, n),
                          [*range(4, 13), 16, 20], range(4, 21), name.replace("/o", "O").replace(" s", "S"))
               for name, scheme in (("Box spline", BOX_SPLINE), ("Tet/oct", TET_OCT))]
    return [
        Page("MeasuredSmoothness", "Smoothness, measured", f"""
How first derivatives jump where eigenvalues say that they may. Positions and one value at each point are random around a
vertex. Cells at this vertex on a fine level each have a gradient of the value by position; the jump is the largest
difference of two of these gradients, as a part of the largest gradient. Where the limit is C^1 it falls to 0.
*Rate* is its factor for each level from 6 to 8, and *expected* is the ratio of the first eigenvalue behind the tangents
to the last of the tangents. The rate comes near to it on deep levels, and is smaller where the eigenvector of that value
has no part. An expected 1 means that the condition fails.

Meshes of surfaces are whole meshes of 8 levels. Loop, Catmull-Clark and Butterfly fall at each valence from level 4
on, slowly for many faces. Of the box spline valence 4 and 5 do not fall, which agrees with (24); 6 has an expected rate of 0.95 in this
star, and does not fall from level 6 to 8 yet. Tet/oct falls at each valence.""", tables, draw_jumps),
        Page("ApproximationOrder", "Approximation order, measured", """
How fast the error falls when control meshes are refined. A plane mesh with three rings around a vertex of *k* faces is
subdivided one to four times and projected to its limit. Its points get the heights sin(1.3 x + 0.4) cos(1.1 y - 0.3).
*InterpolatePoints* finds the control points whose limit goes through all of them: for x and y those of the subdivided plane
mesh, so that the spaces of functions are nested as in Theorem 7 of [Z]. (Butterfly interpolates by itself.) The limit at
all points two levels finer (Butterfly: four) is compared with the function at their x and y, up to a distance of 1
from the vertex. Order 4 means that one step divides the error by 16. The L2 error is taken over the points, not by area.

**What it shows.** Regular meshes (6 triangles, 4 quads) have order 4, as box splines and B-splines have. Theorem 7 bounds
the L2 error of the *best* approximation by Loop's functions by the power 3 of the largest l1, at least 1/2, for each
step; the last column of Loop has this as an order. Interpolation meets it at every valence, and is above it where l1 is
1/2 or less. The survey's second estimate, order 4 in L2 at every valence with another notion of smoothness, is not met by
interpolation of a function that is smooth in the plane: 2.9 at 7 triangles. The largest error has order 2 and less
for many faces, as the mesh around the vertex is coarser there: its edges shrink by l1 and not by 1/2.
""", [approximation_table(name) for name in NAMES], draw_errors)]
