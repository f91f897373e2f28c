# SPDX-License-Identifier: BSD-3-Clause
"""Poisson's equation on curved cells, by shape functions of Lagrange in VTK's order of nodes: how large the error is."""

import itertools

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

# The solution, its waves, and what is on the right: minus its Laplacian.
WAVES, SHIFTS = np.array([1.3, 1.1, 0.9]), np.array([0.4, 1.3, 0.7])


def solution(points):
    return np.prod(np.sin(points * WAVES[:points.shape[-1]] + SHIFTS[:points.shape[-1]]), axis=-1)


def source(points):
    return (WAVES[:points.shape[-1]]**2).sum() * solution(points)


class Element:
    """Shape functions of a triangle, a tetrahedron or a hexahedron whose nodes are at places of the unit cell."""

    def __init__(self, places, order, simplex):
        self.places, self.simplex = places, simplex
        powers = itertools.product(range(order + 1), repeat=places.shape[1])
        self.powers = np.array([one for one in powers if not simplex or sum(one) <= order])
        self.weights_of = np.linalg.inv(self.monomials(places))

    def monomials(self, at, axis=None):
        """The monomials at places, or their derivatives by an axis."""
        values = at[:, None, :] ** self.powers
        if axis is not None:
            power = self.powers[:, axis]
            values[:, :, axis] = power * at[:, None, axis] ** np.maximum(power - 1, 0)
        return values.prod(axis=-1)

    def values(self, at):
        return self.monomials(at) @ self.weights_of

    def slopes(self, at):
        """By place, node and axis."""
        return np.stack([self.monomials(at, axis) @ self.weights_of for axis in range(at.shape[1])], axis=-1)

    def quadrature(self, count):
        """Gauss points and weights; those of a cube, squeezed into a simplex."""
        dimension = self.places.shape[1]
        x, w = np.polynomial.legendre.leggauss(count)
        at = np.array(list(itertools.product((x + 1) / 2, repeat=dimension)))
        weights = np.prod(list(itertools.product(w / 2, repeat=dimension)), axis=1)
        if self.simplex:
            rest = np.ones(len(at))
            for axis in range(dimension):
                weights = weights * rest ** (axis > 0)
                at[:, axis] *= rest
                rest = rest - at[:, axis]
        return at, weights

    def boundary(self, cells):
        """The nodes on sides that only one cell has."""
        if self.simplex:
            sides = [self.places[:, axis] == 0 for axis in range(self.places.shape[1])]
            sides.append(np.isclose(self.places.sum(axis=1), 1))
        else:
            sides = [self.places[:, axis] == end for axis in range(self.places.shape[1]) for end in (0, 1)]
        corners = len(self.places) > 0 and np.isin(self.places, (0, 1)).all(axis=1)
        keys = np.concatenate([np.sort(cells[:, side & corners], axis=1) for side in sides])
        _, first, counts = np.unique(keys, axis=0, return_index=True, return_counts=True)
        first = first[counts == 1]
        return np.unique(np.concatenate([cells[first[first // len(cells) == index] % len(cells)][:, side].ravel()
                                         for index, side in enumerate(sides)]))


def straight(element, points, cells):
    """The same cells with straight edges: nodes where their places are between the corners."""
    corners = np.isin(element.places, (0, 1)).all(axis=1)
    linear = Element(element.places[corners], 1, element.simplex)
    moved = points.copy()
    moved[cells] = np.einsum("ij,cjd->cid", linear.values(element.places), points[cells[:, corners]])
    return moved


def solve(matrix, right, dimension):
    """In solids, where factors would have too many numbers, by conjugate gradients (that of SciPy calls its tolerance by names
    that differ between versions)."""
    if dimension == 2:
        return spsolve(matrix, right)
    scales, found, rest = 1 / matrix.diagonal(), np.zeros(len(right)), right
    along, size = scales * rest, rest @ (scales * rest)
    first = size
    while size > 1e-24 * first:
        image = matrix @ along
        step = size / (along @ image)
        found, rest = found + step * along, rest - step * image
        before, size = size, rest @ (scales * rest)
        along = scales * rest + size / before * along
    return found


def l2_error(element, points, cells, places_of_data):
    """Solves Poisson's equation with the values of the solution on the boundary, which are those at `places_of_data`, and
    returns the L2 norm of the error over the cells, as a part of the norm of the solution."""
    order = int(element.powers.max())
    at, weights = element.quadrature(order + 2)
    shapes, slopes = element.values(at), element.slopes(at)
    found = points[cells]
    jacobians = np.matmul(np.swapaxes(found, 1, 2)[:, None], slopes[None])
    volumes = np.abs(np.linalg.det(jacobians)) * weights
    gradients = np.matmul(slopes[None], np.linalg.inv(jacobians))
    places = np.matmul(shapes, found)
    rows = np.swapaxes(gradients, 2, 3).reshape(len(cells), -1, cells.shape[1])
    scales = np.repeat(volumes, points.shape[1], axis=1)[:, :, None]
    stiffness = np.matmul(np.swapaxes(rows * scales, 1, 2), rows)
    loads = (source(places) * volumes) @ shapes
    rows, columns = np.repeat(cells, cells.shape[1], axis=1), np.tile(cells, cells.shape[1])
    size = len(points)
    matrix = coo_matrix((stiffness.ravel(), (rows.ravel(), columns.ravel())), (size, size)).tocsr()
    right = np.bincount(cells.ravel(), loads.ravel(), size)
    known = element.boundary(cells)
    values = np.zeros(size)
    values[known] = solution(places_of_data[known])
    free = np.setdiff1d(cells, known)
    values[free] = solve(matrix[free][:, free].tocsc(), right[free] - matrix[free][:, known] @ values[known], points.shape[1])
    error = values[cells] @ shapes.T - solution(places)
    return np.sqrt((error**2 * volumes).sum() / (solution(places)**2 * volumes).sum())
