# SPDX-License-Identifier: BSD-3-Clause
"""Jumps of first derivatives around vertices and edges of solids: on fine meshes, and by powers of what one step does."""

import itertools

import filter_maps
import numpy as np
from jumps import DEEP, LEVELS, NOISE, SEEDS, Measured, gradient_jumps
from pages import number
from solid_maps import (BOX_SPLINE, LINEAR, TET_OCT, edge_star, is_smooth, middle_of_edge, moduli, random_star, solid,
                        solids_of, star_matrix, subdivide, tets_of, vertex_star)
from surface_tools import add, coordinates, mesh, point_array
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from subdivisionobjects import vtkMultiDimensionalSubdivision

SCHEMES = {BOX_SPLINE: "BOX_SPLINE", TET_OCT: "TET_OCT"}
MESHES = 1  # of random stars whose powers are compared with meshes
WHOLE = 5  # levels of meshes of which nothing is left out
FACE_STARS = 5
PLACES = 6  # of each of them
HEIGHTS = {"marked": .95, "not marked": .2, "tet/oct": 1.}  # of which each tetrahedron at the edge has these marks

# ------------------------------------------------------------ meshes, and powers of what a step does


def near_solids(made, vertex, rings):
    """The solids up to so many rings around a vertex as a control mesh of its own, and the vertex there. Octahedra become
    tetrahedra for good, so that there must be none at the vertex."""
    tets, solids = tets_of(made), solids_of(made)
    reached = np.zeros(made.GetNumberOfPoints(), dtype=bool)
    reached[vertex] = True
    for _ in range(rings):
        at = np.isin(solids, solids[reached[tets].any(axis=1)])
        reached[tets[at]] = True
    renamed = np.cumsum(reached) - 1
    cut = solid(coordinates(made)[reached], renamed[tets[at]])
    add(cut.GetPointData(), "x", point_array(made, "x")[reached])
    return cut, renamed[vertex]


def next_level(made, scheme):
    """A step whose values are in an array. The points stay those of the linear scheme: by these a filter that reads a part
    of a level finds the diagonals of octahedra that were chosen on the control mesh."""
    fine = subdivide(made, scheme)
    if scheme == BOX_SPLINE:
        linear = subdivide(made, LINEAR)
        np.testing.assert_array_equal(tets_of(linear), tets_of(fine))
        coordinates(fine)[:] = coordinates(linear)
    return fine


def cut_mesh(control, vertex_of, scheme):
    """A mesh of 8 levels, of which only two rings around the vertex are kept on the way."""
    made = next_level(control, scheme)
    vertex = vertex_of(made)
    for _ in range(LEVELS[-1] - 1):
        made, vertex = near_solids(made, vertex, 2)
        made = next_level(made, scheme)
    return made, vertex


def whole_mesh(control, vertex_of, scheme):
    return subdivide(control, scheme, WHOLE), vertex_of(subdivide(control, scheme))


def check(made, vertex, expected):
    """A mesh has the same values around the vertex, from which they are counted."""
    tets, solids = tets_of(made), solids_of(made)
    ids = np.unique(tets[np.isin(solids, solids[(tets == vertex).any(axis=1)])])
    found = point_array(made, "x")[ids] - point_array(made, "x")[vertex]
    found, expected = (values[values[:, 3].argsort()] for values in (found, expected))  # by the first heights
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9 * abs(expected).max())


def star_cells(made, vertex, ids):
    """The tetrahedra at a vertex, by places of their vertices in a list that begins with it."""
    numbers = {one: i for i, one in enumerate(ids)}
    tets = tets_of(made)
    return np.array([sorted(numbers[int(v)] for v in tet) for tet in tets[(tets == vertex).any(axis=1)]])


class Straight:
    """Positions and heights of several seeds around a vertex. Positions become flat with the level, as l1 is larger than l3,
    and jumps small beside slopes; so both are kept straight: positions = points @ inverse of `turn`, and the heights are
    those over what has a `slope`."""

    def __init__(self, x):
        x = np.moveaxis(x.reshape(len(x), -1, 4), 1, 0)
        self.points, self.heights = x[..., :3], x[..., 3]
        self.turn, self.slope = np.eye(3)[None], np.zeros((len(x), 3))
        self.straighten()

    def straighten(self):
        self.points, factor = np.linalg.qr(self.points - self.points[:, :1])
        self.points = self.points - self.points[:, :1]
        self.turn = self.turn @ np.linalg.inv(factor)
        self.heights = self.heights - self.heights[:, :1]
        over = np.einsum("snj,sn->sj", self.points, self.heights)
        self.heights = self.heights - np.einsum("snj,sj->sn", self.points, over)
        self.slope = self.slope + np.einsum("sij,sj->si", self.turn, over)

    def step(self, matrix):
        self.points, self.heights = matrix @ self.points, self.heights @ matrix.T
        self.straighten()

    def jumps(self, cells):
        return gradient_jumps(np.moveaxis(self.points, 1, 0), self.heights.T, cells, self.turn, self.slope[:, None])


def jumps_by_level(control, vertex_of, scheme, values, meshes):
    """(jumps by level of values (points, seeds, 4), which are positions and heights, the moduli of eigenvalues)."""
    add(control.GetPointData(), "x", values.reshape(len(values), -1))
    first = subdivide(control, scheme)
    vertex = vertex_of(first)
    matrix, ids = star_matrix(first, vertex, scheme)
    x = point_array(first, "x")[ids]
    for level, make in meshes.items():
        expected = np.linalg.matrix_power(matrix, level - 1) @ x
        check(*make(control, vertex_of, scheme), expected - expected[0])
    return jumps_of_powers(matrix, x, star_cells(first, vertex, ids), 1), moduli(matrix)


def jumps_of_powers(matrix, x, cells, first):
    """Jumps by level: a step multiplies the values of the first level by the matrix."""
    straight, found = Straight(x), {}
    for level in range(first, DEEP[-1] + 1):
        if level in LEVELS + DEEP:
            found[level] = straight.jumps(cells)
            if found[level].max() < NOISE:
                break
        straight.step(matrix)
    return found


def promises(control, scheme, corners, values):
    return is_smooth(values) and filter_maps.columns(control, SCHEMES[scheme], corners, values[:4])[:2] == ["yes", "yes"]


def measure_vertex(scheme, valence):
    """Around a vertex of random tetrahedra, other ones for each seed."""
    jumps, expected, smooth = {}, [], []
    for seed in range(SEEDS):
        random = np.random.RandomState(1000 * seed + 200 + valence)
        control = vertex_star(*random_star(random, valence))
        values = np.column_stack([coordinates(control), random.uniform(-1, 1, valence + 1)])
        found, behind = jumps_by_level(control, lambda _: 0, scheme, values[:, None],
                                       {LEVELS[-1]: cut_mesh} if seed < MESHES else {})
        for level in LEVELS + DEEP:
            jumps.setdefault(level, []).extend(found.get(level, [0.]))
        expected.append(behind[3] / behind[2])
        smooth.append(promises(control, scheme, [0], behind))
    return Measured({level: np.array(jump) for level, jump in jumps.items()}, np.array(expected), np.array(smooth))


def measure_edge(scheme, n, height, meshes):
    """Around the middle of an edge of n tetrahedra, at random positions."""
    control = edge_star(n, height)
    values = np.zeros((n + 2, SEEDS, 4))
    for seed in range(SEEDS):
        random = np.random.RandomState(1000 * seed + 400 + n)
        values[:, seed, :3] = coordinates(control) + random.uniform(-.1, .1, (n + 2, 3)) * min(1, 6 / n)
        values[:, seed, 3] = random.uniform(-1, 1, n + 2)
    found, behind = jumps_by_level(control, lambda first: middle_of_edge(first, n), scheme, values, meshes)
    return Measured(found, np.full(SEEDS, behind[3] / behind[2]),
                    np.full(SEEDS, promises(control, scheme, [0, 1], behind)))


# ------------------------------------------------------------ both sides of faces


def face_places(made, random):
    """Random places on inner faces, each in both tetrahedra: pairs of a cell and the weights of its second to fourth point."""
    tets, found = tets_of(made).tolist(), []
    for (i, one), (j, other) in itertools.combinations(enumerate(tets), 2):
        common = sorted(set(one) & set(other))
        if len(common) == 3 and len(found) < 2 * PLACES:
            weights = dict(zip(common, random.dirichlet((2, 2, 2))))
            found += [(cell, [weights.get(vertex, 0.) for vertex in tets[cell][1:]]) for cell in (i, j)]
    return found


def limit_derivatives(made, scheme, places):
    """Derivatives of limit points by the parameters of cells, and these points, by EvaluateLimit."""
    subdivision, out = vtkMultiDimensionalSubdivision(), vtkPolyData()
    subdivision.SetInputData(made)
    subdivision.SetVolumeScheme(scheme)
    cells = numpy_to_vtkIdTypeArray(np.array([cell for cell, _ in places], dtype=np.int64), deep=True)
    assert subdivision.EvaluateLimit(cells, numpy_to_vtk(np.array([weights for _, weights in places]), deep=True), out)
    return np.stack([point_array(out, f"Derivative{name}") for name in "UVW"], axis=1), coordinates(out)


def face_jumps(scheme):
    """(count of places, largest jump of the derivatives of a deformation by position across faces, of positions there)."""
    jumps_, gaps = [], []
    for seed in range(FACE_STARS):
        random = np.random.RandomState(300 + seed)
        points, faces = random_star(random, 8)
        made, moved = vertex_star(points, faces), vertex_star(points + random.uniform(-.03, .03, points.shape), faces)
        places = face_places(made, random)
        (x, at), (y, _) = (limit_derivatives(mesh_, scheme, places) for mesh_ in (made, moved))
        gradients = np.linalg.solve(x, y - x)
        size = np.linalg.norm(gradients, axis=(1, 2)).max()
        jumps_ += (np.linalg.norm(gradients[::2] - gradients[1::2], axis=(1, 2)) / size).tolist()
        gaps += abs(at[::2] - at[1::2]).max(axis=1).tolist()
    return [str(len(gaps)), number(max(jumps_), 5), number(max(gaps), 9)]
