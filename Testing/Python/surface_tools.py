# SPDX-License-Identifier: BSD-3-Clause
"""Meshes for tests of subdivision surfaces, and the operator of a filter as a matrix: what it makes of an identity."""

import itertools

import numpy as np
from quiet import quiet
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from subdivisionobjects import vtkSurfaceSubdivision

LOOP = vtkSurfaceSubdivision.LOOP
CATMULL_CLARK = vtkSurfaceSubdivision.CATMULL_CLARK


def cells(lists):
    offsets = np.cumsum([0] + [len(ids) for ids in lists], dtype=np.int64)
    connectivity = np.fromiter(itertools.chain.from_iterable(lists), np.int64, offsets[-1])
    result = vtkCellArray()
    result.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(connectivity, deep=True))
    return result


def mesh(points, faces, lines=(), verts=()):
    """A surface with double coordinates."""
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.array(points, dtype=float).reshape(-1, 3), deep=True))
    made = vtkPolyData()
    made.SetPoints(coordinates)
    made.SetPolys(cells(faces))
    made.SetLines(cells(lines))
    made.SetVerts(cells(verts))
    return made


def add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def with_identity(made):
    add(made.GetPointData(), "e", np.eye(made.GetNumberOfPoints()))
    return made


def run(made, scheme, levels=1, arrays=(), **options):
    """Without the warning that polygons become triangles."""
    with quiet():
        return execute(made, scheme, levels, arrays, **options)


def execute(made, scheme, levels, arrays, **options):
    subdivision = vtkSurfaceSubdivision()
    subdivision.SetInputData(made)
    subdivision.SetScheme(scheme)
    subdivision.SetNumberOfLevels(levels)
    for index, association, name in arrays:
        subdivision.SetInputArrayToProcess(index, 0, 0, association, name)
    for name, value in options.items():
        getattr(subdivision, "Set" + name)(value)
    subdivision.Update()
    out = vtkPolyData()
    out.ShallowCopy(subdivision.GetOutput())
    return out


def coordinates(made):
    return vtk_to_numpy(made.GetPoints().GetData())


def point_array(made, name):
    return vtk_to_numpy(made.GetPointData().GetArray(name))


def faces_of(made):
    array = made.GetPolys()
    ids = vtk_to_numpy(array.GetConnectivityArray()).tolist()
    offsets = vtk_to_numpy(array.GetOffsetsArray()).tolist()
    return [ids[a:b] for a, b in zip(offsets[:-1], offsets[1:])]


def lines_of(made):
    return vtk_to_numpy(made.GetLines().GetConnectivityArray()).reshape(-1, 2).tolist()


def operator(made, scheme, **options):
    """The rows of one step."""
    return point_array(run(with_identity(made), scheme, **options), "e")


def children(coarse, fine, scheme):
    """Points of edges and faces, read off the children of faces, which come in order."""
    found = {}
    small = faces_of(fine)
    child = 0
    for face in faces_of(coarse):
        for i, vertex in enumerate(face):
            after = face[(i + 1) % len(face)]
            if scheme == LOOP:
                corner = small[child + i]
                assert corner[i] == vertex
                found[frozenset((vertex, after))] = corner[(i + 1) % 3]
            else:
                quad = small[child + i]
                assert quad[0] == vertex
                found[frozenset((vertex, after))] = quad[1]
                found[frozenset(face)] = quad[2]
        child += 4 if scheme == LOOP else len(face)
    return found


def wheel(k, rings=3):
    """k triangles around vertex 0, in rings."""
    points = [[0, 0, 0]]
    ids = {(0, 0): 0}
    for r in range(1, rings + 1):
        for i in range(k * r):
            ids[r, i] = len(points)
            angle = 2 * np.pi * i / (k * r)
            points.append([r * np.cos(angle), r * np.sin(angle), 0.1 * np.sin(7 * i + r)])
    faces = []
    for r in range(1, rings + 1):
        for s in range(k):
            for i in range(r):
                inner = [ids[r - 1, (s * (r - 1) + j) % max(1, k * (r - 1))] for j in (i, i + 1)]
                outer = [ids[r, (s * r + j) % (k * r)] for j in (i, i + 1)]
                faces.append([inner[0], outer[0], outer[1]])
                if i < r - 1:
                    faces.append([inner[0], outer[1], inner[1]])
    return mesh(points, faces)


def fan(k, angle, rings=3):
    """k triangles in a sector of an angle at vertex 0, in rings."""
    points = [[0, 0, 0]]
    ids = {(0, 0): 0}
    for r in range(1, rings + 1):
        for i in range(k * r + 1):
            ids[r, i] = len(points)
            turn = angle * i / (k * r)
            points.append([r * np.cos(turn), r * np.sin(turn), 0])
    faces = []
    for r in range(1, rings + 1):
        for s in range(k):
            for i in range(r):
                faces.append([ids[r - 1, s * (r - 1) + i], ids[r, s * r + i], ids[r, s * r + i + 1]])
                if i < r - 1:
                    faces.append([ids[r - 1, s * (r - 1) + i], ids[r, s * r + i + 1], ids[r - 1, s * (r - 1) + i + 1]])
    return mesh(points, faces)


def quad_star(k, angle, closed, size=3):
    """k sectors of size x size quads at vertex 0."""
    points = []
    ids = {}

    def point(s, a, b):
        if a == 0 and b == 0:
            key = 0
        elif b == 0:
            key = (s, a)
        elif a == 0:
            key = ((s + 1) % k if closed else s + 1, b)
        else:
            key = (s, a, b)
        if key not in ids:
            ids[key] = len(points)
            t = [angle * (s + j) / k for j in (0, 1)]
            points.append([a * np.cos(t[0]) + b * np.cos(t[1]), a * np.sin(t[0]) + b * np.sin(t[1]), 0])
        return ids[key]

    point(0, 0, 0)
    faces = []
    for s in range(k):
        for a, b in itertools.product(range(size), repeat=2):
            faces.append([point(s, a, b), point(s, a + 1, b), point(s, a + 1, b + 1), point(s, a, b + 1)])
    return mesh(points, faces)


def local_matrix(made, scheme, **options):
    """What a step does to vertex 0 and its faces, one step in, where all else is regular."""
    first = run(made, scheme, **options)
    second = run(with_identity(first), scheme, **options)
    rows = point_array(second, "e")
    made_on = children(first, second, scheme)
    around = [face for face in faces_of(first) if 0 in face]
    here = [0]
    there = [0]
    for face in around:
        at = face.index(0)
        for other in (face[(at + 1) % len(face)], face[at - 1]):
            if other not in here:
                here.append(other)
                there.append(made_on[frozenset((0, other))])
    if scheme == CATMULL_CLARK:
        for face in around:
            here.append(face[(face.index(0) + 2) % 4])
            there.append(made_on[frozenset(face)])
    matrix = rows[np.ix_(there, here)]
    np.testing.assert_allclose(matrix.sum(axis=1), 1, atol=1e-12)  # nothing from elsewhere
    return matrix


def spectrum(matrix):
    return sorted(abs(np.linalg.eigvals(matrix)), reverse=True)


def flag_corner(made, vertex=0):
    """The same mesh with one vertex tagged as a corner."""
    tagged = mesh(coordinates(made), faces_of(made), verts=[[vertex]])
    add(tagged.GetCellData(), "Singular", np.array([1] + [0] * made.GetNumberOfPolys(), dtype=np.int32))
    return tagged


def grid(n, triangles):
    points = [[x, y, 0] for y in range(n) for x in range(n)]
    faces = []
    for y, x in itertools.product(range(n - 1), repeat=2):
        quad = [y * n + x, y * n + x + 1, (y + 1) * n + x + 1, (y + 1) * n + x]
        faces += [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]] if triangles else [quad]
    return mesh(points, faces)


def moebius(n=9):
    points = []
    for i in range(n):
        t = 2 * np.pi * i / n
        for s in (-0.4, 0.4):
            radius = 1 + s * np.cos(t / 2)
            points.append([radius * np.cos(t), radius * np.sin(t), s * np.sin(t / 2)])
    faces = [[2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1] for i in range(n - 1)]
    faces.append([2 * n - 2, 1, 0, 2 * n - 1])
    return mesh(points, faces)


def zoo():
    """Meshes of many kinds, with random heights."""
    random = np.random.RandomState(3)
    cube = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    made = {
        "triangle": mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]),
        "pentagon": mesh([[np.cos(t), np.sin(t), 0] for t in np.arange(5)], [range(5)]),
        "cube": mesh(cube, sides),
        "open cube": mesh(cube, sides[1:]),
        "pyramid": mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [.4, .4, 1]],
                        [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [0, 3, 2, 1]]),
        "book": mesh([[0, 0, 0], [0, 0, 1], [1, 0, 0], [-1, .2, 0], [0, 1, 0]], [[0, 1, 2], [0, 1, 3], [1, 0, 4]]),
        "bow": mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [-1, 0, 0], [-1, -1, 0]], [[0, 1, 2], [0, 3, 4]]),
        "mixed": mesh(cube + [[2, 2, 2], [3, 3, 2]], sides, lines=[[7, 8, 9], [0, 1]], verts=[[9], [0]]),
        "lines": mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 0, 1]], [], lines=[[0, 1, 2, 3]]),
        "grid": grid(4, True),
        "quads": grid(4, False),
        "moebius": moebius(),
        "wheel": wheel(5),
        "points": mesh([[0, 0, 0], [1, 0, 0]], [], verts=[[0]]),
    }
    for surface in made.values():
        coordinates(surface)[:] += 0.05 * random.rand(surface.GetNumberOfPoints(), 3)
    return made
