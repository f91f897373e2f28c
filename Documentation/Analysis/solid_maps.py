# SPDX-License-Identifier: BSD-3-Clause
"""Local matrices of volume schemes, by what the filter makes of tetrahedra around a vertex, an edge or a face."""

import itertools

import numpy as np
from quiet import quiet
from surface_tools import add, coordinates, point_array
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkUnstructuredGrid

from subdivisionobjects import vtkMultiDimensionalSubdivision

BOX_SPLINE = vtkMultiDimensionalSubdivision.BOX_SPLINE
TET_OCT = vtkMultiDimensionalSubdivision.TET_OCT
LINEAR = vtkMultiDimensionalSubdivision.LINEAR
HYBRID = vtkMultiDimensionalSubdivision.HYBRID


def solid(points, tets):
    made, held, cells = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    held.SetData(numpy_to_vtk(np.array(points, dtype=float), deep=True))
    made.SetPoints(held)
    tets = np.array(tets, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(4 * np.arange(len(tets) + 1), deep=True),
                  numpy_to_vtkIdTypeArray(tets.ravel(), deep=True))
    made.SetCells(VTK_TETRA, cells)
    add(made.GetCellData(), "Control", np.arange(len(tets), dtype=np.int32))
    return made


def subdivide(made, scheme, levels=1, **options):
    with quiet():
        filter_ = vtkMultiDimensionalSubdivision()
        filter_.SetInputData(made)
        filter_.SetVolumeScheme(scheme)
        filter_.SetNumberOfLevels(levels)
        for name, value in options.items():
            getattr(filter_, "Set" + name)(value)
        filter_.Update()
    out = vtkUnstructuredGrid()
    out.ShallowCopy(filter_.GetOutput())
    return out


def cell_array(made, name):
    return vtk_to_numpy(made.GetCellData().GetArray(name))


def tets_of(made):
    return vtk_to_numpy(made.GetCells().GetConnectivityArray()).reshape(-1, 4)


def solids_of(made):
    """For each output cell the solid it is of: pieces of an octahedron are one."""
    count = made.GetNumberOfCells()
    octahedra = made.GetCellData().GetArray("OctahedronId")
    if not octahedra:
        return np.arange(count)
    ids = vtk_to_numpy(octahedra)
    return np.where(ids < 0, np.arange(count), count + ids)


def star_matrix(made, vertex, scheme):
    """(what a step does to a vertex and all vertices of the solids at it, these vertices, the vertex first)."""
    tets, solids = tets_of(made), solids_of(made)
    at = set(solids[(tets == vertex).any(axis=1)])
    near = np.flatnonzero(np.isin(solids, list(at)))

    def signatures(cells, names):
        """In which solids at the vertex each of their vertices lies: this tells neighbours apart on both levels."""
        around = {}
        for cell, name in zip(cells, names):
            for v in cell:
                around.setdefault(int(v), set()).add(int(name))
        found = {frozenset(value): key for key, value in around.items() if key != vertex}
        assert len(found) == len(around) - 1
        return found

    here = signatures(tets[near], solids[near])
    before = vtkUnstructuredGrid()
    before.ShallowCopy(made)
    names = sorted(here, key=sorted)
    ids = [vertex] + [here[name] for name in names]
    columns = np.zeros((made.GetNumberOfPoints(), len(ids)))
    columns[ids, np.arange(len(ids))] = 1
    add(before.GetPointData(), "e", columns)
    add(before.GetCellData(), "Solid", solids.astype(np.int64))
    after = subdivide(before, scheme)
    tets, solids, parents = tets_of(after), solids_of(after), cell_array(after, "Solid")
    touching = np.isin(solids, solids[(tets == vertex).any(axis=1)])
    there = signatures(tets[touching], parents[touching])
    matrix = point_array(after, "e")[[vertex] + [there[name] for name in names]]
    np.testing.assert_allclose(matrix.sum(axis=1), 1, atol=1e-12)  # nothing from elsewhere
    return matrix, ids


def moduli(matrix, count=8):
    found = sorted(abs(np.linalg.eigvals(matrix)), reverse=True)
    return (found + [0.] * count)[1:count]


def is_smooth(values):
    """Condition (24): 1 > l1 >= l2 >= l3 > l4."""
    return bool(values[0] < 1 - 1e-6 and values[2] > values[3] + 1e-6)


def independent(vectors):
    """Real vectors that span what these do: pairs of conjugate ones are real and imaginary parts of one."""
    real, imaginary = np.real(vectors), np.imag(vectors)
    return np.linalg.svd(np.hstack([real, imaginary]), full_matrices=False)[0][:, :vectors.shape[1]]


# ------------------------------------------------------------ around vertices

def hull(points):
    """Triangles of the convex hull of points in general position, or None where not all are on it."""
    triples = np.array(list(itertools.combinations(range(len(points)), 3)))
    a, b, c = (points[triples[:, i]] for i in range(3))
    normals = np.cross(b - a, c - a)
    heights = np.einsum("ij,kj->ik", normals, points) - np.einsum("ij,ij->i", normals, a)[:, None]
    scale = 1e-9 * np.abs(heights).max()
    outside = (heights < scale).all(axis=1) | (heights > -scale).all(axis=1)
    faces = triples[outside]
    return faces if len(set(faces.ravel())) == len(points) and len(faces) == 2 * len(points) - 4 else None


def code(faces):
    """The same for triangulations of the sphere that are the same but for numbers of vertices."""
    apex = {}
    for face in faces:
        for i in range(3):
            apex.setdefault(frozenset((face[i], face[i - 1])), []).append(face[i - 2])
    best = None
    for edge, (one, other) in apex.items():
        for a, b in itertools.permutations(edge):
            for c in (one, other):
                found = walk(apex, a, b, c)
                best = found if best is None or found < best else best
    return best


def walk(apex, a, b, c):
    """Numbers of vertices in the order of a walk that begins with the triangle abc: lists of neighbours in turn."""
    number, starts, queue = {a: 0, b: 1}, {a: (b, c), b: (a, c)}, [a, b]
    # b sees a first and then c, so that it turns the other way round than a; walk it the same way instead.
    starts[b] = (a, next(v for v in apex[frozenset((a, b))] if v != c))
    text = []
    for vertex in queue:
        before, at = starts[vertex]
        ring = [before, at]
        while True:
            after = next(v for v in apex[frozenset((vertex, ring[-1]))] if v != ring[-2])
            if after == ring[0]:
                break
            ring.append(after)
        for i, other in enumerate(ring):
            if other not in number:
                number[other] = len(number)
                starts[other] = (vertex, ring[i - 1])
                queue.append(other)
            text.append(number[other])
        text.append(-1)
    return tuple(text)


def random_star(random, valence):
    """Points around the origin whose hull has them all and the origin inside, and its triangles."""
    while True:
        points = random.standard_normal((valence, 3))
        points /= np.linalg.norm(points, axis=1)[:, None] ** random.uniform(.8, 1)
        faces = hull(points)
        if faces is not None:
            a, b, c = (points[faces[:, i]] for i in range(3))
            volumes = np.abs(np.einsum("ij,ij->i", a, np.cross(b, c)))
            inner = np.abs(np.einsum("ij,ij->i", np.cross(b - a, c - a), a) / np.linalg.norm(np.cross(b - a, c - a), axis=1))
            centre = points.mean(axis=0)
            signs = np.sign(np.einsum("ij,ij->i", np.cross(b - a, c - a), a)) * np.sign(
                np.einsum("ij,ij->i", np.cross(b - a, c - a), a - centre))
            if (signs > 0).all() and volumes.min() > 1e-3 and inner.min() > 1e-2:
                return points, faces


def vertex_star(points, faces):
    """Tetrahedra around vertex 0, in their middle."""
    return solid(np.concatenate([[[0, 0, 0]], points]), [[0, *(face + 1)] for face in faces])


def vertex_matrix(points, faces, scheme):
    """Around an input vertex in the middle of tetrahedra, after the first step."""
    return star_matrix(subdivide(vertex_star(points, faces), scheme), 0, scheme)[0]


# ------------------------------------------------------------ along edges, across faces

def edge_star(n, height):
    """An edge of n tetrahedra, from vertex 0 to vertex 1: it is marked in all of them if it is long."""
    ring = [[np.cos(2 * np.pi * i / n), np.sin(2 * np.pi * i / n), 0] for i in range(n)]
    return solid([[0, 0, -height], [0, 0, height], *ring], [[0, 1, 2 + i, 2 + (i + 1) % n] for i in range(n)])


def middle_of_edge(first, n):
    """The vertex in the middle of an edge of n tetrahedra after the first step."""
    tets, owners = tets_of(first), cell_array(first, "Control")
    middle, = (set.intersection(*(set(tets[owners == i].ravel().tolist()) for i in range(n))) - {0, 1})
    return middle


def edge_matrix(n, scheme, height):
    """Around the middle of an edge of n tetrahedra."""
    first = subdivide(edge_star(n, height), scheme)
    return star_matrix(first, middle_of_edge(first, n), scheme)[0]


def marked_edges(points, tet):
    """The two opposite edges whose midpoints are nearest to each other."""
    pairs = [((0, 1), (2, 3)), ((0, 2), (1, 3)), ((0, 3), (1, 2))]
    x = points[list(tet)]
    _, best = min((np.linalg.norm(x[list(one)].mean(axis=0) - x[list(other)].mean(axis=0)), (one, other))
                  for one, other in pairs)
    return [frozenset(tet[i] for i in edge) for edge in best]


def face_matrices(random, scheme):
    """Two random tetrahedra on a face: (whether both mark the same edge of it, they, matrices around vertices inside it)."""
    while True:
        points = np.concatenate([random.uniform(-1, 1, (3, 3)) * [1, 1, 0], random.uniform(-1, 1, (2, 3))])
        points[3:, 2] = [abs(points[3, 2]) + .2, -abs(points[4, 2]) - .2]
        if abs(np.linalg.det(np.stack([points[1] - points[0], points[2] - points[0], [0, 0, 1]]))) > .3:
            break
    tets = [(0, 1, 2, 3), (0, 2, 1, 4)]
    shared = [next(edge for edge in marked_edges(points, tet) if edge <= {0, 1, 2}) for tet in tets]
    made = solid(points, tets)
    second = subdivide(made, scheme, 2)
    cells, owners = tets_of(second), cell_array(second, "Control")
    face = set(cells[owners == 0].ravel()) & set(cells[owners == 1].ravel())
    sides = np.array([sum(v in face for v in cell) == 3 for cell in cells]) & (owners == 0)
    counts = {v: sum(v in cell for cell in cells[sides]) for v in face}
    # Three of the face's 15 vertices are inside it; octahedra are cut, and a cut may add edges on no face.
    inner = sorted(counts, key=lambda v: -counts[v])[:3]
    return shared[0] == shared[1], made, [star_matrix(second, int(v), scheme)[0] for v in inner]
