# SPDX-License-Identifier: BSD-3-Clause
"""Matrices whose products have to shrink where a scheme is smooth: of steps to the patches of a control face (tet/oct), and
of differences on the regular mesh (sqrt(3))."""

import functools
import itertools
import math

import numpy as np
from solid_maps import TET_OCT, cell_array, independent, solid, solids_of, subdivide, tets_of
from surface_maps import straight
from surface_matrices import SQRT_THREE
from surface_tools import add, coordinates, point_array, run, wheel
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

# ------------------------------------------------------------ steps to the patches of a face


def two_tetrahedra():
    """Two tetrahedra that are mirror images in their face, and one on each outer face, so that their edges are inside."""
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    tets, points = [[0, 1, 2, 3], [0, 2, 1, 4]], corners + [[0, 0, 1], [0, 0, -1]]
    for apex in (3, 4):
        for a, b in itertools.combinations(range(3), 2):
            c = 3 - a - b
            tets.append([a, b, apex, len(points)])
            points.append((np.array(points)[[a, b, apex]].sum(axis=0) - np.array(points)[c]).tolist())
    return solid(points, tets)


def finer(made, places):
    """The next level, and where its points lie without smoothing: in the middle of all vertices that the solids of the
    level before have in common at them, of an edge or of an octahedron. Not a number where fewer solids meet."""
    before = vtkUnstructuredGrid()
    before.ShallowCopy(made)
    parents = solids_of(made)
    add(before.GetCellData(), "Solid", parents.astype(np.int64))
    after = subdivide(before, TET_OCT)
    corners, around = {}, {}
    for cell, parent in zip(tets_of(made).tolist(), parents.tolist()):
        corners.setdefault(parent, set()).update(cell)
    for cell, parent in zip(tets_of(after).tolist(), cell_array(after, "Solid").tolist()):
        for vertex in cell:
            around.setdefault(vertex, set()).add(parent)
    found = np.full((after.GetNumberOfPoints(), 3), np.nan)
    found[:len(places)] = places
    for vertex in range(len(places), len(found)):
        common = sorted(set.intersection(*(corners[parent] for parent in around[vertex])))
        if len(common) in (2, 6):
            found[vertex] = places[common].mean(axis=0)
    return after, found


@functools.lru_cache(maxsize=None)
def patch_matrices():
    """Vertices of all solids that touch two triangles of the face, one of a tetrahedron and one of an octahedron on each
    side, and what a step does to them, for each quarter of the two triangles."""
    made = two_tetrahedra()
    places = coordinates(made).copy()
    for _ in range(3):
        made, places = finer(made, places)
    levels = []
    corner, size = np.array([2, 2, 0]), 8  # far enough from the sides of the face
    for factor in (1, 2):
        own = np.unique(tets_of(made)[cell_array(made, "Control") < 2])
        keys = np.round(places[own] * size * factor).astype(int) - factor * corner
        levels.append({tuple(key): vertex for key, vertex in zip(keys.tolist(), own.tolist())})
        if factor == 1:
            touched = [levels[0][key] for key in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0))]
            tets, solids = tets_of(made), solids_of(made)
            at = np.isin(solids, solids[np.isin(tets, touched).any(axis=1)])
            ids = np.unique(tets[at])
            columns = np.zeros((made.GetNumberOfPoints(), len(ids)))
            columns[ids, np.arange(len(ids))] = 1
            add(made.GetPointData(), "e", columns)
            made, places = finer(made, places)
    coarse, fine = levels
    patch = np.array([key for key, vertex in sorted(coarse.items(), key=lambda item: item[1]) if vertex in ids])
    rows = point_array(made, "e")
    matrices = [rows[[fine[tuple(key)] for key in (patch + [i, j, 0]).tolist()]] for i in (0, 1) for j in (0, 1)]
    for matrix in matrices:
        np.testing.assert_allclose(matrix.sum(axis=1), 1, atol=1e-12)  # nothing from elsewhere
    return patch, matrices


@functools.lru_cache(maxsize=None)
def contracted():
    """The matrices of the patch on what is left of values when ten functions, of 1, 1/2 and 1/4, are taken out; in
    coordinates in which their norms are small."""
    patch, matrices = patch_matrices()
    common, left = without(matrices, [1] + 3 * [1 / 2] + 6 * [1 / 4])
    # Of 1, x, y, z and six products of two of them three are odd in z. With z |z| in the place of z^2 four would be.
    names = {tuple(key): i for i, key in enumerate(patch.tolist())}
    mirror = [names[x, y, -z] for x, y, z in patch.tolist()]
    np.testing.assert_allclose(np.trace(common.T @ common[mirror]), 7 - 3, atol=1e-9)
    return adapted(left, 0.28)


def without(matrices, leading):
    """(the functions of these eigenvalues of the first matrix, which all matrices keep, the matrices on what is left)."""
    values, vectors = np.linalg.eig(matrices[0])
    order = np.argsort(-abs(values))[:len(leading)]
    np.testing.assert_allclose(values[order], leading, atol=1e-9)
    common = independent(vectors[:, order])
    rest = np.linalg.svd(common)[0][:, len(leading):]
    for matrix in matrices:
        np.testing.assert_allclose(rest.T @ matrix @ common, 0, atol=1e-12)
    return common, [rest.T @ matrix @ rest for matrix in matrices]


def adapted(matrices, factor):
    """The same in other coordinates. The square of their norm is the sum of squares of what all products make, each
    divided by the factor for each matrix of it; the factor has to be so large that the sum exists."""
    square = term = np.eye(len(matrices[0]))
    for _ in range(2000):
        term = sum(matrix.T @ term @ matrix for matrix in matrices) / factor ** 2
        square = square + term
        if abs(term).max() < 1e-14 * abs(square).max():
            break
    else:
        raise AssertionError("the sum does not exist")
    root = np.linalg.cholesky((square + square.T) / 2).T
    return [root @ matrix @ np.linalg.inv(root) for matrix in matrices]


def longer(matrices, products):
    return np.matmul(np.array(matrices)[:, None], products[None]).reshape(-1, *matrices[0].shape)


def radius_bounds(matrices, length):
    """(count of all products of so many matrices, the lower and the upper bound of the joint spectral radius by them)."""
    products = np.array(matrices)
    for _ in range(length - 1):
        products = longer(matrices, products)
    largest = abs(np.linalg.eigvals(products)).max()
    return len(products), largest ** (1 / length), np.linalg.norm(products, 2, axis=(1, 2)).max() ** (1 / length)


def radius_cut(matrices, bound):
    """(count of products looked at, length of the longest): products grow until their norm is below the bound to the power
    of their length. Where they all end, any long product consists of such pieces, and the radius is below the bound."""
    count, length, products = 0, 0, np.array(matrices)
    while len(products):
        count, length = count + len(products), length + 1
        products = products[np.linalg.norm(products, 2, axis=(1, 2)) > bound ** length]
        products = longer(matrices, products)
        assert count < 100000
    return count, length


# ------------------------------------------------------------ differences on the regular mesh

AXES = np.array([[1, 0], [1 / 2, np.sqrt(3) / 2]])


def lattice_step(rings, steps):
    """Where points of the regular mesh up to so many rings away lie, in steps along its edges, and what sqrt(3) steps, an
    even number, do to them."""
    made = straight(wheel(6, rings + 4), 6, 2 * np.pi, True, rings + 4)
    count = 1 + 3 * rings * (rings + 1)
    columns = np.zeros((made.GetNumberOfPoints(), count))
    columns[:count] = np.eye(count)
    add(made.GetPointData(), "e", columns)
    after = run(made, SQRT_THREE, steps)

    def places(points, factor):
        return np.round(np.linalg.solve(AXES.T, points[:, :2].T).T * factor, 6)

    here = places(coordinates(made)[:count], 1)
    there = {tuple(key): i for i, key in enumerate(places(coordinates(after), 3 ** (steps // 2)).tolist())}
    matrix = point_array(after, "e")[[there[tuple(key)] for key in here.tolist()]]
    np.testing.assert_allclose(matrix.sum(axis=1), 1, atol=1e-12)  # nothing from elsewhere
    return here.astype(int), matrix


def third_differences(places):
    """All third differences of values at places, along two directions and mixed, as a matrix."""
    names, rows = {tuple(key): i for i, key in enumerate(places.tolist())}, []
    for second in range(4):
        first = 3 - second
        weights = {(i, j): (-1) ** (3 - i - j) * math.comb(first, i) * math.comb(second, j)
                   for i in range(first + 1) for j in range(second + 1)}
        for x, y in names:
            if all((x + i, y + j) in names for i, j in weights):
                row = np.zeros(len(names))
                for (i, j), weight in weights.items():
                    row[names[x + i, y + j]] = weight
                rows.append(row)
    return np.array(rows)


def contractivity(rings, steps):
    """(count of points, count of differences, norm of the difference scheme times the square of the factor of lengths, and
    its spectral radius times that, by one double step)."""
    places, matrix = lattice_step(rings, steps)
    jet = third_differences(places)
    kernel = np.linalg.svd(jet)[2][-6:].T  # quadratic polynomials
    np.testing.assert_allclose(jet @ kernel, 0, atol=1e-12)
    np.testing.assert_allclose(jet @ matrix @ kernel, 0, atol=1e-12)  # steps keep them
    scheme = 3 ** steps * jet @ matrix @ np.linalg.pinv(jet)
    return len(places), len(jet), np.linalg.norm(scheme, 2), abs(np.linalg.eigvals(scheme)).max() ** (2 / steps)
