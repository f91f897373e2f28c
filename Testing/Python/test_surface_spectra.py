# SPDX-License-Identifier: BSD-3-Clause
"""4-8 and sqrt(3): eigenvalues and eigenvectors of two steps around inner, boundary and corner vertices; dual schemes
at boundaries, where what repeats is not around a vertex."""

import unittest

import numpy as np
import tools
from surface_matrices import FOUR_EIGHT, SQRT_THREE, is_smooth, quad_matrix, triangle_matrix
from surface_tools import add, coordinates, faces_of, fan, flag_corner, grid, point_array, quad_star, run, spectrum, wheel

from subdivisionobjects import vtkSurfaceSubdivision


class FourEight(unittest.TestCase):
    def test_limit_totals(self):
        for k in range(3, 13):
            with self.subTest(k):
                places, matrix = quad_matrix(quad_star(k, 2 * np.pi, True), k, True)
                values, vectors = np.linalg.eig(matrix.T)
                mask = vectors[:, np.argmin(abs(values - 1))].real
                totals = np.zeros(4)  # centre, edges, corners, all else
                for (_, a, b), weight in zip(places, mask / mask.sum()):
                    totals[3 if max(a, b) > 1 else a + b] += weight
                np.testing.assert_allclose(120 * totals, [35, 59, 22, 4], atol=1e-9)

    def test_interior(self):
        for k in range(3, 13):
            with self.subTest(k):
                values = spectrum(quad_matrix(quad_star(k, 2 * np.pi, True), k, True)[1])
                self.assertTrue(is_smooth(values))
                self.assertAlmostEqual(values[1], values[2], 10)

    def test_boundary(self):
        for k in range(2, 13):
            with self.subTest(k):
                made = quad_star(k, np.pi, False)
                plain = spectrum(quad_matrix(made, k, False, ModifiedBoundary=False)[1])
                self.assertEqual(is_smooth(plain, 1 / 2), k < 4)  # Mathematics 12: for two and three faces only
                values = spectrum(quad_matrix(made, k, False)[1])
                self.assertTrue(is_smooth(values, 1 / 2))
                np.testing.assert_allclose(values[1:3], 1 / 2, atol=1e-9)

    def test_corners(self):
        for angle, first in ((30, 1), (90, 1), (150, 1), (210, 2), (330, 2)):
            for k in range(first, 13):
                with self.subTest(k=k, angle=angle):
                    made = quad_star(k, np.radians(angle), False)
                    made = made if k == 1 else flag_corner(made)
                    values = spectrum(quad_matrix(made, k, False)[1])
                    np.testing.assert_allclose(values[1:3], 1 / 2, atol=1e-9)
                    self.assertTrue(is_smooth(values, 1 / 2))
                    plain = spectrum(quad_matrix(made, k, False, ModifiedBoundary=False)[1])
                    self.assertEqual(is_smooth(plain, 1 / 2), k == 1)


class SqrtThree(unittest.TestCase):
    def test_interior(self):
        for k in range(3, 13):
            with self.subTest(k):
                values = spectrum(triangle_matrix(wheel(k), k, True))
                waves = [4 / 9 * np.cos(np.pi * m / k) ** 2 for m in range(1, k)]  # Kobbelt's (4), squared
                mean = (2 / 3 - (4 - 2 * np.cos(2 * np.pi / k)) / 9) ** 2
                np.testing.assert_allclose(values, sorted([1, mean] + waves, reverse=True), atol=1e-7)
                self.assertTrue(is_smooth(values))

    def waves(self, k):
        return [(2 + 2 * np.cos(np.pi * m / k)) / 9 for m in range(1, k)]

    def test_boundary(self):
        for k in range(2, 13):
            with self.subTest(k):
                made = fan(k, np.pi)
                plain = spectrum(triangle_matrix(made, k, False, ModifiedBoundary=False))
                np.testing.assert_allclose(plain, sorted([1, 1 / 3, 1 / 9] + self.waves(k), reverse=True), atol=1e-7)
                self.assertEqual(is_smooth(plain, 1 / 3), k < 6)  # Mathematics 11: for up to five triangles
                values = spectrum(triangle_matrix(made, k, False))
                waves = np.array(self.waves(k)) / self.waves(k)[0] / 3
                np.testing.assert_allclose(values, sorted([1, 1 / 3, 1 / 9, *waves], reverse=True), atol=1e-7)
                self.assertTrue(is_smooth(values, 1 / 3))

    def test_corners(self):
        for angle, first in ((30, 1), (90, 1), (150, 1), (210, 2), (330, 2)):
            for k in range(first, 13):
                with self.subTest(k=k, angle=angle):
                    made = flag_corner(fan(k, np.radians(angle)))
                    plain = spectrum(triangle_matrix(made, k, False, ModifiedBoundary=False))
                    np.testing.assert_allclose(plain, sorted([1, 1 / 3, 1 / 3] + self.waves(k), reverse=True), atol=1e-7)
                    self.assertEqual(is_smooth(plain, 1 / 3), k < 3)
                    values = spectrum(triangle_matrix(made, k, False))
                    waves = np.array(self.waves(k)) / (2 + 2 * np.cos(np.radians(angle) / k)) * 3
                    if angle > 180 and k > 1:  # flatness
                        waves *= 1 / 9 / waves[0] if angle < 120 * k else 0
                    np.testing.assert_allclose(values, sorted([1, 1 / 3, 1 / 3, *waves], reverse=True), atol=1e-7)
                    self.assertTrue(is_smooth(values, 1 / 3))


def measure_bend(made):
    """The largest distance between the normals of neighbouring faces, one of which is at the boundary."""
    points, faces = coordinates(made), faces_of(made)
    sides = {}
    for f, face in enumerate(faces):
        for i, vertex in enumerate(face):
            sides.setdefault(frozenset((vertex, face[i - 1])), []).append(f)
    outside = {v for side, around in sides.items() if len(around) == 1 for v in side}
    outer = {f for f, face in enumerate(faces) if not outside.isdisjoint(face)}

    def normal(face):
        corners = points[face] - points[face].mean(axis=0)
        total = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
        return total / np.linalg.norm(total)

    pairs = [pair for pair in sides.values() if len(pair) == 2 and not outer.isdisjoint(pair)]
    normals = {f: normal(faces[f]) for f in set().union(*pairs)}
    return max(np.linalg.norm(normals[a] - normals[b]) for a, b in pairs)


class DualBoundaries(unittest.TestCase):
    def check(self, scheme, steps, k):
        made = quad_star(k, np.pi if k > 1 else 1., False, 1)
        coordinates(made)[:, 2] = 0.3 * np.random.RandomState(k).rand(made.GetNumberOfPoints())
        return [measure_bend(run(made, scheme, n)) for n in steps]

    def test_doo_sabin_is_smooth(self):
        for k in range(1, 9):
            with self.subTest(k):
                bends = self.check(vtkSurfaceSubdivision.DOO_SABIN, (3, 4, 5), k)
                self.assertLess(bends[1], 0.6 * bends[0])
                self.assertLess(bends[2], 0.6 * bends[1])

    def test_midedge_is_not(self):
        # Two steps give both ends of half of a boundary edge the direction across that its end had.
        for k in range(1, 9):
            with self.subTest(k):
                bends = self.check(vtkSurfaceSubdivision.MIDEDGE, (6, 10), k)
                self.assertGreater(bends[1], 0.8 * bends[0])
                self.assertGreater(bends[1], 0.05)


class Precision(unittest.TestCase):
    def test_quadratic_functions_on_grids(self):
        # Up to a constant, which is that of the lattice's second moments.
        n = 13
        constants = {FOUR_EIGHT: [1 / 4, 0, 1 / 4], SQRT_THREE: [2 / 9, 1 / 9, 2 / 9]}
        for scheme, found in constants.items():
            for powers, constant in zip(((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)), [0, 0] + found):
                made = grid(n, scheme == SQRT_THREE)
                x, y = coordinates(made)[:, :2].T
                add(made.GetPointData(), "q", x ** powers[0] * y ** powers[1])
                out = run(made, scheme)
                px, py = coordinates(out)[:, :2].T
                inside = (abs(px - n // 2) < 3.1) & (abs(py - n // 2) < 3.1)
                self.assertGreater(inside.sum(), 70)
                off = (point_array(out, "q") - px ** powers[0] * py ** powers[1])[inside]
                np.testing.assert_allclose(off, constant, atol=1e-12)


if __name__ == "__main__":
    tools.main()
