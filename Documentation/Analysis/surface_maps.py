# SPDX-License-Identifier: BSD-3-Clause
"""Local matrices and characteristic maps of surface schemes, by what the filter makes of control meshes around a vertex."""

import numpy as np
from surface_tools import (CATMULL_CLARK, add, coordinates, faces_of, fan, flag_corner, mesh, point_array, quad_star, run, wheel)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.util.numpy_support import numpy_to_vtk

RINGS = 3


def straight(made, k, angle, closed, rings=RINGS):
    """The same triangles, with rings that are straight inside each of k sectors: midpoints lie on them again."""
    points = coordinates(made)
    points[:] = 0
    at = 1
    for r in range(1, rings + 1):
        for i in range(k * r + (0 if closed else 1)):
            s, j = divmod(i, r)
            t = np.array([s, s + 1]) * angle / k
            points[at, :2] = ((r - j) * np.array([np.cos(t[0]), np.sin(t[0])]) + j * np.array([np.cos(t[1]), np.sin(t[1])]))
            at += 1
    return made


def star(scheme, k, kind):
    """k sectors of faces around vertex 0, on each side of a crease: (mesh, whether it closes, angle)."""
    quads = scheme == CATMULL_CLARK
    k = 2 * k if kind == "crease" else k
    angles = {"interior": 2 * np.pi, "crease": 2 * np.pi, "boundary": np.pi, "convex": np.pi / 2, "concave": 1.5 * np.pi}
    closed, angle = kind in ("interior", "crease"), angles[kind]
    if quads:
        made = quad_star(k, angle, closed, RINGS)
    else:
        made = straight(wheel(k, RINGS) if closed else fan(k, angle, RINGS), k, angle, closed)
    if kind in ("convex", "concave"):
        made = flag_corner(made)
    elif kind == "crease":  # along the first and the middle spoke
        flat = abs(coordinates(made)[:, 1]) < 1e-9
        lines = sorted({tuple(sorted((a, b))) for face in faces_of(made) for a, b in zip(face, face[1:] + face[:1])
                        if flat[a] and flat[b]})
        made = mesh(coordinates(made), faces_of(made), lines=lines)
        add(made.GetCellData(), "Singular", np.array([1] * len(lines) + [0] * made.GetNumberOfPolys(), dtype=np.int32))
    return made, closed, angle


def parameters(made, out, levels):
    """Where the points of a level lie on the control mesh, read off the order of children."""
    corners = coordinates(made)[np.array(faces_of(made)), :2]
    for _ in range(levels):
        after, middle = np.roll(corners, -1, axis=1), corners.mean(axis=1, keepdims=True)
        edges = (corners + after) / 2
        if corners.shape[1] == 4:
            corners = np.stack([corners, edges, np.broadcast_to(middle, corners.shape), np.roll(edges, 1, axis=1)], axis=2)
        else:  # child i keeps corner i in its place; the fourth lies between
            (x0, x1, x2), (x01, x12, x02) = np.moveaxis(corners, 1, 0), np.moveaxis(edges, 1, 0)
            corners = np.stack([np.stack(child, axis=1) for child in
                                ((x0, x01, x02), (x01, x1, x12), (x02, x12, x2), (x01, x12, x02))], axis=1)
        corners = corners.reshape(-1, *corners.shape[2:])
    ids = np.array(faces_of(out)).ravel()
    places = np.full((out.GetNumberOfPoints(), 2), np.nan)
    places[ids] = corners.reshape(-1, 2)
    np.testing.assert_allclose(places[ids], corners.reshape(-1, 2), atol=1e-12)  # neighbours agree
    return places


def distances(places, k, angle, quads):
    """How many rings of the control mesh a place is away from vertex 0."""
    turn = np.arctan2(places[:, 1], places[:, 0]) % (2 * np.pi)
    width = angle / k
    sector = np.clip(np.floor(np.where(turn > angle + 1e-6, 0, turn) / width + 1e-9), 0, k - 1)
    turn = turn - sector * width
    length = np.hypot(places[:, 0], places[:, 1])
    b = length * np.sin(turn) / np.sin(width)
    a = length * np.sin(width - turn) / np.sin(width)
    return np.maximum(a, b) if quads else a + b


def with_points(made, points):
    """The same mesh with its stamp, with other points."""
    moved = vtkPolyData()
    moved.ShallowCopy(made)
    coordinates_ = vtkPoints()
    coordinates_.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    moved.SetPoints(coordinates_)
    return moved


def least(matrix, count):
    """Orthonormal columns x for which |matrix x| is least, by inverse iteration; much faster than all singular vectors."""
    shifted = matrix + 1e-13 * np.eye(len(matrix))  # so that it has an inverse
    columns = np.random.default_rng(1).standard_normal((len(matrix), count))
    for _ in range(4):
        columns = np.linalg.qr(np.linalg.solve(shifted, np.linalg.solve(shifted.T, columns)))[0]
    return columns


class Local:
    """What a step does around vertex 0, one level in, to the points up to three rings of that level away."""

    def __init__(self, scheme, k, kind, **options):
        self.scheme, self.options = scheme, options
        self.quads = scheme == CATMULL_CLARK
        self.made, self.closed, self.angle = star(scheme, k, kind)
        self.k = 2 * k if kind == "crease" else k
        self.first = run(self.made, scheme, 1, **options)
        self.places = parameters(self.made, self.first, 1)
        self.here = np.flatnonzero(self.rings(self.places) < RINGS / 2 + 1e-6)
        columns = np.zeros((self.first.GetNumberOfPoints(), len(self.here)))
        columns[self.here, np.arange(len(self.here))] = 1
        before = vtkPolyData()
        before.ShallowCopy(self.first)
        add(before.GetPointData(), "e", columns)
        second = run(before, scheme, 1, **options)
        finer = parameters(self.made, second, 2)
        found = {tuple(key): i for i, key in enumerate(np.round(finer * 2e6).astype(int))}
        there = [found[tuple(key)] for key in np.round(self.places[self.here] * 1e6).astype(int)]
        self.matrix = point_array(second, "e")[there]
        np.testing.assert_allclose(self.matrix.sum(axis=1), 1, atol=1e-12)  # nothing from elsewhere

    def rings(self, places):
        return distances(places, self.k, self.angle, self.quads)

    def values(self, count=8):
        return sorted(np.linalg.eigvals(self.matrix), key=lambda value: -abs(value))[:count]

    def map(self, levels=2):
        """(regular, injective, count of triangles looked at) of the characteristic map between half a ring and one."""
        one, other = np.real(self.values(3)[1:])
        # An eigenvector minimises |(A - l) x|; of two equal eigenvalues so do two vectors.
        groups = [((one + other) / 2, 2)] if abs(one - other) < 1e-6 else [(one, 1), (other, 1)]
        pair = np.hstack([least(self.matrix - value * np.eye(len(self.here)), count) for value, count in groups])
        points = np.zeros((self.first.GetNumberOfPoints(), 3))
        points[self.here, :2] = pair - pair[self.here == 0]
        fine = run(with_points(self.first, points), self.scheme, levels, **self.options)
        places = parameters(self.made, fine, levels + 1)
        rings = self.rings(places)
        faces = np.array(faces_of(fine))
        faces = faces[(rings[faces].max(axis=1) < 0.5 + 1e-6) & (rings[faces].min(axis=1) > 0.25 - 1e-6)]
        n = faces.shape[1]
        triangles = np.concatenate([faces[:, [i, (i + 1) % n, (i + 2) % n]] for i in range(n if n > 3 else 1)])

        def areas(of):
            x = of[triangles]
            u, v = x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]
            return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]

        image = coordinates(fine)[:, :2]
        signs = areas(image) * areas(places)
        regular = bool((signs > 0).all() or (signs < 0).all())
        rim = np.flatnonzero(abs(rings - 0.5) < 1e-6)
        turn = np.arctan2(places[rim, 1], places[rim, 0]) % (2 * np.pi)
        rim = rim[np.argsort(np.where(turn > 2 * np.pi - 1e-9, 0, turn), kind="stable")]
        edge = image[rim, 0] + 1j * image[rim, 1]
        if self.closed:
            edge = np.append(edge, edge[0])
        steps = np.angle(edge[1:] / edge[:-1])
        total = abs(steps.sum())
        around = abs(total - 2 * np.pi) < 1e-6 if self.closed else total < 2 * np.pi
        # Regular, and its rim goes around once in one direction: nothing is covered twice.
        one_way = bool((steps > 0).all() or (steps < 0).all())
        return regular, regular and around and one_way, len(triangles)
