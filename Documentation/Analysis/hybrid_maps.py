# SPDX-License-Identifier: BSD-3-Clause
"""Local matrices of the scheme that keeps the types of cells, by what the filter makes of cells around a vertex, an edge or
a face. All cells here are affine images of regular ones. So the linear scheme halves what lies around a vertex, and tells
which point of a level stands for which point of the level before."""

import itertools

import numpy as np
from solid_maps import HYBRID, LINEAR, cell_array, independent, solids_of, subdivide, walk
from surface_tools import add, cells, point_array
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_PYRAMID, VTK_QUAD, VTK_TETRA, VTK_TRIANGLE, VTK_WEDGE,
                                           vtkUnstructuredGrid)

# For each corner that has three edges the three neighbours, in the order of a right hand; of faces two.
CORNERS = {
    VTK_TRIANGLE: [(0, 1, 2), (1, 2, 0), (2, 0, 1)],
    VTK_QUAD: [(0, 1, 3), (1, 2, 0), (2, 3, 1), (3, 0, 2)],
    VTK_TETRA: [(0, 1, 2, 3)],
    VTK_PYRAMID: [(0, 1, 3, 4), (1, 2, 0, 4), (2, 3, 1, 4), (3, 0, 2, 4)],
    VTK_WEDGE: [(0, 1, 2, 3), (1, 2, 0, 4), (2, 0, 1, 5), (3, 5, 4, 0), (4, 3, 5, 1), (5, 4, 3, 2)],
    VTK_HEXAHEDRON: [(0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7), (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2),
                     (7, 6, 4, 3)]}
TURNED = {VTK_TETRA: (0, 2, 1, 3), VTK_PYRAMID: (0, 3, 2, 1, 4), VTK_WEDGE: (0, 2, 1, 3, 5, 4),
          VTK_HEXAHEDRON: (0, 3, 2, 1, 4, 7, 6, 5)}  # the other way round


class Control:
    """A mesh whose points are sums of vectors: a point is named by them, and made once."""

    def __init__(self, vectors, oriented=True):
        """oriented: cells are turned so that they have a positive volume."""
        self.vectors, self.oriented, self.names, self.points, self.types, self.cells = vectors, oriented, {}, [], [], []

    def point(self, *names):
        key = tuple(sorted(names, key=str))
        if key not in self.names:
            self.names[key] = len(self.points)
            self.points.append(sum((self.vectors[name] for name in key), np.zeros(3)))
        return self.names[key]

    def add(self, kind, *corners):
        ids = [self.point(*corner) for corner in corners]
        first, *others = (np.array(self.points[ids[i]]) for i in CORNERS[kind][0])
        if self.oriented and kind in TURNED and np.linalg.det(np.array(others) - first) < 0:
            ids = [ids[i] for i in TURNED[kind]]
        self.types.append(kind)
        self.cells.append(ids)

    def grid(self):
        made, held = vtkUnstructuredGrid(), vtkPoints()
        held.SetData(numpy_to_vtk(np.array(self.points, dtype=float), deep=True))
        made.SetPoints(held)
        made.SetCells(numpy_to_vtk(np.array(self.types, dtype=np.uint8), deep=True), cells(self.cells))
        add(made.GetPointData(), "place", np.array(self.points, dtype=float))
        return made


def cells_of(made):
    ids = vtk_to_numpy(made.GetCells().GetConnectivityArray())
    ends = vtk_to_numpy(made.GetCells().GetOffsetsArray())
    return [ids[a:b] for a, b in zip(ends, ends[1:])]


def types_of(made):
    return vtk_to_numpy(made.GetCellTypesArray())


class Incidence:
    """Which solids have which points: octahedra are one solid though four cells."""

    def __init__(self, made):
        self.ids = vtk_to_numpy(made.GetCells().GetConnectivityArray())
        self.ends = vtk_to_numpy(made.GetCells().GetOffsetsArray())
        self.solids, self.count = solids_of(made), made.GetNumberOfPoints()

    def touching(self, points):
        """For each cell whether its solid has one of the points."""
        at = np.logical_or.reduceat(np.isin(self.ids, points), self.ends[:-1])
        return np.isin(self.solids, self.solids[at])

    def points(self, at):
        return np.unique(self.ids[np.repeat(at, np.diff(self.ends))])

    def near(self, points, rings):
        for _ in range(rings):
            points = self.points(self.touching(points))
        return points


def keys(places):
    return [tuple(key) for key in np.round(places * 1e7).astype(np.int64).tolist()]


class Local:
    """A level of a control mesh, the next one, and what the step between them does around places."""

    def __init__(self, control, level):
        grid = control.grid()
        self.places = [point_array(subdivide(grid, LINEAR, n, KeepCellTypes=True), "place") for n in (level, level + 1)]
        self.made = subdivide(grid, HYBRID, level)
        self.incidence = Incidence(self.made)
        self.names = [{key: i for i, key in enumerate(keys(places))} for places in self.places]
        assert self.made.GetNumberOfPoints() == len(self.places[0]) == len(self.names[0])

    def point(self, place):
        return self.names[0][keys(np.array([place]))[0]]

    def matrices(self, here, images):
        """What a step does to some points, for each of the lists of places where these are looked for on the next level."""
        found = self.rows(here, images)
        for matrix in found:
            np.testing.assert_allclose(matrix.sum(axis=1), 1, atol=1e-12)  # nothing from elsewhere
        return found

    def rows(self, here, images):
        columns = np.zeros((len(self.places[0]), len(here)))
        columns[here, np.arange(len(here))] = 1
        before = vtkUnstructuredGrid()
        before.ShallowCopy(self.made)
        add(before.GetPointData(), "e", columns)
        rows = point_array(subdivide(before, HYBRID), "e")
        return [rows[[self.names[1][key] for key in keys(places)]] for places in images]

    def star(self, place, rings=1):
        """(matrix, points) of so many rings around the point at a place."""
        here = self.incidence.near([self.point(place)], rings)
        return self.matrices(here, [(self.places[0][here] + place) / 2])[0], here

    def corners(self, at, here):
        """Corners with their neighbours of the cells that are chosen, as numbers in a list of points."""
        numbers, all_cells, types = {one: i for i, one in enumerate(here.tolist())}, cells_of(self.made), types_of(self.made)
        return np.array([[numbers[int(all_cells[c][i])] for i in corner]
                         for c in np.flatnonzero(at) for corner in CORNERS[types[c]]])

    def map(self, place):
        """(whether the characteristic map has one orientation at all corners of cells that are looked at, how many there are):
        two levels further, between half a ring and one."""
        matrix, here = self.star(place, 2)
        values, vectors = np.linalg.eig(matrix)
        vertex, size = self.point(place), 2 if self.is_flat() else 3
        image = np.zeros((len(self.places[0]), size))
        image[here] = independent(vectors[:, np.argsort(-abs(values))[1:size + 1]])
        before = vtkUnstructuredGrid()
        before.ShallowCopy(self.made)
        add(before.GetPointData(), "image", image - image[vertex])
        add(before.GetPointData(), "place", self.places[0])
        add(before.GetCellData(), "Star", self.incidence.touching([vertex]).astype(np.int32))
        middle = subdivide(before, HYBRID)
        add(middle.GetCellData(), "Inner", Incidence(middle).touching([vertex]).astype(np.int32))
        fine = subdivide(middle, HYBRID)
        at = np.flatnonzero((cell_array(fine, "Star") == 1) & (cell_array(fine, "Inner") == 0))
        return orientations(fine, at, size)

    def is_flat(self):
        return types_of(self.made).max() <= VTK_QUAD


def orientations(made, at, size):
    """Tetrahedra that are pieces of octahedra are turned as on the control mesh, and other cells keep their order."""
    image, place, all_cells, types = (*(point_array(made, name)[:, :size] for name in ("image", "place")), cells_of(made),
                                      types_of(made))

    def signs(of, corners):
        return np.sign(np.linalg.det(of[corners[:, 1:]] - of[corners[:, :1]]))

    found = []
    for kind in np.unique(types[at]):
        corners = np.array([[cell[i] for i in corner] for cell in (all_cells[c] for c in at[types[at] == kind])
                            for corner in CORNERS[kind]])
        found.append(signs(image, corners) * (signs(place, corners) if kind == VTK_TETRA else 1))
    found = np.concatenate(found)
    return bool((found > 0).all() or (found < 0).all()), len(found)


# ------------------------------------------------------------ around vertices


def vertex_star(points, triangles, quads, oriented=True):
    """Cells around the origin: a triangle of directions is the place of a cell, and `quads` are the pairs of directions
    between which cells have quads, and not triangles."""
    made = Control(points, oriented)
    made.point()
    for a, b, c in triangles:
        flat = [frozenset(pair) in quads for pair in ((a, b), (b, c), (c, a))]
        while flat in ([True, False, True], [True, True, False], [False, True, False], [False, False, True]):
            a, b, c, flat = b, c, a, flat[1:] + flat[:1]  # until its only triangle, or quad, is between a and b
        made.add(*[
            (VTK_TETRA, (), (a,), (b,), (c,)), (VTK_PYRAMID, (), (a,), (a, b), (b,), (c,)),
            (VTK_WEDGE, (), (a,), (b,), (c,), (a, c), (b, c)),
            (VTK_HEXAHEDRON, (), (a,), (a, b), (b,), (c,), (a, c), (a, b, c), (b, c))][sum(flat)])
    return made


def pairs(triangles):
    return sorted({tuple(sorted(pair)) for face in triangles for pair in itertools.combinations(map(int, face), 2)})


def six_pyramids():
    """Whose apexes meet in the middle of a cube."""
    made = Control(np.array(list(itertools.product((-1., 1.), repeat=3))))
    made.point()
    for step, (one, other) in ((1, (2, 4)), (2, (1, 4)), (4, (1, 2))):
        for first in (0, step):
            made.add(VTK_PYRAMID, *((first + k,) for k in (0, one, one + other, other)), ())
    return made


# ------------------------------------------------------------ along edges, across faces, on surfaces

SIDES = {"h": "qq", "w": "qq", "t": "tt", "a": "tt", "p": "qt", "P": "tq", "u": "qt", "U": "tq"}


def edge_star(sectors):
    """Cells around an edge, a letter for each: h hexahedra, w wedges along their axis, t tetrahedra, p and P pyramids with
    their base on one side, u and U wedges with the edge in a triangle, a pyramids with the edge to their apex."""
    turns = 2 * np.pi * np.arange(len(sectors)) / len(sectors)
    made = Control({"z": np.array([0, 0, 1.]), **{i: np.array([np.cos(t), np.sin(t), 0]) for i, t in enumerate(turns)}})
    for i, letter in enumerate(sectors):
        j = (i + 1) % len(sectors)
        assert SIDES[letter][0] == SIDES[sectors[i - 1]][1], "faces differ"
        q, t = (i, j) if SIDES[letter][0] == "q" else (j, i)  # the side with the quad, of cells that have one
        made.add(*{
            "h": (VTK_HEXAHEDRON, (), (i,), (i, j), (j,), ("z",), (i, "z"), (i, j, "z"), (j, "z")),
            "w": (VTK_WEDGE, (), (i,), (j,), ("z",), (i, "z"), (j, "z")),
            "t": (VTK_TETRA, (), (i,), (j,), ("z",)),
            "a": (VTK_PYRAMID, (), (i,), (i, j), (j,), ("z",)),
            "p": (VTK_PYRAMID, (), ("z",), (q, "z"), (q,), (t,)),
            "u": (VTK_WEDGE, (), ("z",), (t,), (q,), (q, "z"), (q, t))}[letter.lower()])
    return made


CELLS = {  # on a quad or triangle of x and y, towards z
    "hexahedron": (VTK_HEXAHEDRON, (), "x", "xy", "y", "z", "xz", "xyz", "yz"),
    "wedge, quad": (VTK_WEDGE, (), "x", "z", "y", "xy", "yz"),
    "pyramid, base": (VTK_PYRAMID, (), "x", "xy", "y", "z"),
    "wedge, triangle": (VTK_WEDGE, (), "x", "y", "z", "xz", "yz"),
    "pyramid, triangle": (VTK_PYRAMID, (), "x", "xz", "z", "y"),
    "tetrahedron": (VTK_TETRA, (), "x", "y", "z")}


def two_cells(one, other):
    """On both sides of a face; directions on the other side are those that the cell has there."""
    vectors = {"x": np.array([1., 0, 0]), "y": np.array([0, 1., 0]), "z": np.array([.2, .1, 1]), "v": np.array([.1, .3, -1])}
    made = Control(vectors)
    for name, z in ((one, "z"), (other, "v")):
        kind, *corners = CELLS[name]
        made.add(kind, *(tuple(c.replace("z", z) for c in corner) for corner in corners))
    return made


def surface_star(faces):
    """Quads and triangles around the origin, a letter for each: q, t."""
    turns = 2 * np.pi * np.arange(len(faces)) / len(faces)
    made = Control({i: np.array([np.cos(t), np.sin(t), 0]) for i, t in enumerate(turns)}, False)
    for i, letter in enumerate(faces):
        j = (i + 1) % len(faces)
        made.add(*((VTK_TRIANGLE, (), (i,), (j,)) if letter == "t" else (VTK_QUAD, (), (i,), (i, j), (j,))))
    return made


# ------------------------------------------------------------ all links of hexahedra around a vertex


def sorted_code(triangles):
    """The same for triangulations that are the same but for numbers of vertices, faster than `code`: walks begin where the
    degrees are least."""
    degree = np.bincount(np.ravel(triangles))
    apex = {}
    for face in triangles:
        for i in range(3):
            apex.setdefault(frozenset((face[i], face[i - 1])), []).append(face[i - 2])
    starts = [(a, b, c) for edge, both in apex.items() for a, b in itertools.permutations(edge) for c in both]
    rank = [(degree[a], degree[b], degree[c]) for a, b, c in starts]
    return min(walk(apex, *start) for start, one in zip(starts, rank) if one == min(rank))


def flipped(triangles):
    """All triangulations in which another diagonal is between two neighbours."""
    opposite = {(face[i], face[i - 2]): face[i - 1] for face in triangles for i in range(3)}  # on the edge's other side
    edges = {frozenset(edge) for edge in opposite}
    for a, b in opposite:
        c, d = opposite[a, b], opposite[b, a]
        if a < b and frozenset((c, d)) not in edges:
            yield [face for face in triangles if not {a, b} <= set(face)] + [(c, d, b), (d, c, a)]


def all_triangulations(count):
    """Of the sphere, with so many vertices: flips lead from one to all."""
    first = [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)]
    for vertex in range(4, count):  # each in the middle of a triangle
        a, b, c = first.pop()
        first += [(a, b, vertex), (b, c, vertex), (c, a, vertex)]
    found, left = {sorted_code(first): first}, [first]
    while left:
        for other in flipped(left.pop()):
            key = sorted_code(other)
            if key not in found:
                found[key] = other
                left.append(other)
    return [found[key] for key in sorted(found)]


# ------------------------------------------------------------ what lies around a face

QUADS = ("hexahedron", "wedge, quad", "pyramid, base")


class FaceLevel:
    """A level of two cells on a face, a point inside the face, and steps to its neighbours there."""

    def __init__(self, one, other, deep):
        """deep: with four rings around the point."""
        level, at = {(True, False): (3, 3), (True, True): (3, 4), (False, False): (3, 2), (False, True): (4, 5)}[
            one in QUADS, deep]
        self.control = two_cells(one, other)
        self.local = Local(self.control, level)
        self.steps = np.array([self.control.vectors[name] for name in "xyz"]) / 2 ** level
        self.other = np.array([self.control.vectors[name] for name in "xyv"]) / 2 ** level
        self.place = at * (self.steps[0] + self.steps[1])

    def patch(self):
        """What a step does to the points of all solids that touch a quad, or two triangles, of the face, for each quarter;
        and to what these read, if a pyramid's tip is among them."""
        corners = [self.place + i * self.steps[0] + j * self.steps[1] for i in (0, 1) for j in (0, 1)]
        ids = [self.local.point(corner) for corner in corners]
        here, wide = self.local.incidence.near(ids, 1), self.local.incidence.near(ids, 2)

        def images(points):
            return [(self.local.places[0][points] + corner) / 2 for corner in corners]

        while True:
            reads = np.any([abs(rows).max(axis=0) > 0 for rows in self.local.rows(wide, images(here))], axis=0)
            more = np.union1d(here, wide[reads])
            if len(more) == len(here):
                return self.local.matrices(here, images(here))
            here = more

    def second_jump(self):
        """How much second derivatives differ on both sides, as a part of the largest, at worst: of limits that a step divides
        by four. They are quadratic in the coordinates of the characteristic map on each side."""
        matrix, here = self.local.star(self.place, 4)
        values, vectors = np.linalg.eig(matrix)
        order = np.argsort(-abs(values))
        flat = independent(vectors[:, order[1:4]])
        flat, quarter = flat - flat[here == self.local.point(self.place)], order[4:10][abs(values[order[4:10]] - 1 / 4) < 1e-6]
        bent = independent(vectors[:, quarter])
        places = self.local.places[0][here] - self.place
        sides = []
        for steps in (self.steps, self.other):
            at = np.linalg.solve(steps.T, places.T)[2] > 1.5  # from two rings off the face on
            u = flat[at] / abs(flat).max()
            products = [u[:, i] * u[:, j] for i, j in itertools.combinations_with_replacement(range(3), 2)]
            terms = np.column_stack([np.ones(len(u)), u, *products])
            found = np.linalg.lstsq(terms, bent[at], rcond=None)[0]
            np.testing.assert_allclose(terms @ found, bent[at], atol=1e-8 * abs(bent).max())
            sides.append(found[4:])
        return len(quarter), np.linalg.norm(sides[0] - sides[1], 2) / max(np.linalg.norm(side, 2) for side in sides)
