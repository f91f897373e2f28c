# SPDX-License-Identifier: BSD-3-Clause
"""The modified Butterfly scheme: its rows, seen through an array that is an identity matrix."""

import itertools
import unittest

import numpy as np
import tools
from surface_tools import (LOOP, add, children, coordinates, faces_of, fan, flag_corner, grid, mesh, moebius,
                           point_array, run, spectrum, wheel, with_identity, zoo)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkButterflySubdivisionFilter

from subdivisionobjects import vtkSurfaceSubdivision

BUTTERFLY = vtkSurfaceSubdivision.MODIFIED_BUTTERFLY


def rows_of(coarse, **options):
    """For each edge, as a pair, the weights of its row; by vertex."""
    fine = run(with_identity(coarse), BUTTERFLY, **options)
    rows = point_array(fine, "e")
    made = children(coarse, fine, LOOP)
    return {edge: {i: w for i, w in enumerate(rows[row]) if abs(w) > 1e-15} for edge, row in made.items()}


def creased(made, lines):
    tagged = mesh(coordinates(made), faces_of(made), lines=lines)
    flags = [1] * len(lines) + [0] * made.GetNumberOfPolys()
    add(tagged.GetCellData(), "Singular", np.array(flags, dtype=np.int32))
    return tagged


def neighbours(faces, vertex):
    """In order around the vertex, from one end to the other if there are ends."""
    after = {face[(face.index(vertex) + 1) % 3]: face[face.index(vertex) - 1] for face in faces if vertex in face}
    ends = set(after) - set(after.values())
    ring = [min(ends or after)]
    while ring[-1] in after and after[ring[-1]] not in ring:
        ring.append(after[ring[-1]])
    return ring, not ends


def local_matrix(made, **options):
    """What a step does to vertex 0 and two rings, one step in, where all else is regular."""
    first = run(made, BUTTERFLY, **options)
    second = run(with_identity(first), BUTTERFLY, **options)
    old, new = children(made, first, LOOP), children(first, second, LOOP)
    ring, closed = neighbours(faces_of(made), 0)
    near = [old[frozenset((0, w))] for w in ring]
    pairs = list(zip(range(len(ring)), range(1, len(ring)))) + ([(len(ring) - 1, 0)] if closed else [])
    here = [0] + near + ring + [old[frozenset((ring[i], ring[j]))] for i, j in pairs]
    there = [0] + [new[frozenset((0, v))] for v in near] + near
    there += [new[frozenset((near[i], near[j]))] for i, j in pairs]
    matrix = point_array(second, "e")[np.ix_(there, here)]
    np.testing.assert_allclose(matrix.sum(axis=1), 1, atol=1e-12)  # nothing from elsewhere
    return matrix


def closed_surfaces():
    tetrahedron = mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.3, 1]],
                       [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    octahedron = mesh([[1, 0, 0], [0, 1.2, 0], [-1, 0, 0], [0, -1, 0], [0, .1, 1], [0, 0, -1]],
                      [[i, (i + 1) % 4, 4] for i in range(4)] + [[(i + 1) % 4, i, 5] for i in range(4)])
    yield tetrahedron
    yield octahedron
    for k in (5, 7, 9, 12):
        turns = 2 * np.pi * np.arange(k) / k
        points = [[np.cos(t), np.sin(t), 0.1 * np.cos(3 * t)] for t in turns] + [[0, 0, 1], [0.1, 0, -1]]
        yield mesh(points, [[i, (i + 1) % k, k] for i in range(k)] + [[(i + 1) % k, i, k + 1] for i in range(k)])
    n = 7  # a torus: everything is regular
    points = [[(3 + np.cos(2 * np.pi * b / n)) * np.cos(2 * np.pi * a / n),
               (3 + np.cos(2 * np.pi * b / n)) * np.sin(2 * np.pi * a / n), np.sin(2 * np.pi * b / n)]
              for a in range(n) for b in range(n)]
    faces = []
    for a, b in itertools.product(range(n), repeat=2):
        p, q, r, s = (n * ((a + i) % n) + (b + j) % n for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)))
        faces += [[p, q, r], [p, r, s]]
    yield mesh(points, faces)


class Rows(unittest.TestCase):
    def test_rows_sum_to_one_carry_affine_maps_and_keep_vertices(self):
        turn = np.random.RandomState(0).rand(3, 3)
        for name, surface in zoo().items():
            with self.subTest(name):
                size = surface.GetNumberOfPoints()
                out = run(with_identity(surface), BUTTERFLY, 2)
                rows = point_array(out, "e")
                np.testing.assert_array_equal(rows[:size], np.eye(size))
                np.testing.assert_array_equal(coordinates(out)[:size], coordinates(surface))
                np.testing.assert_allclose(rows.sum(axis=1), 1, atol=1e-12)
                np.testing.assert_allclose(rows @ coordinates(surface), coordinates(out), atol=1e-12)
                moved = mesh(coordinates(surface) @ turn + 5, faces_of(surface))
                moved.SetLines(surface.GetLines())
                moved.SetVerts(surface.GetVerts())
                if all(len(face) == 3 for face in faces_of(surface)):  # diagonals are chosen by shape
                    np.testing.assert_allclose(
                        coordinates(run(moved, BUTTERFLY, 2)), coordinates(out) @ turn + 5, atol=1e-11)

    def test_regular_rows(self):
        n = 7
        rows = rows_of(grid(n, True))
        at = lambda x, y: n * y + x  # noqa: E731
        eight = {(2, 3): 1 / 2, (3, 3): 1 / 2, (3, 4): 1 / 8, (2, 2): 1 / 8, (1, 2): -1 / 16, (3, 2): -1 / 16,
                 (2, 4): -1 / 16, (4, 4): -1 / 16}
        inside = {(3, 1): 5 / 8, (3, 0): 3 / 8, (4, 1): 3 / 16, (2, 0): 1 / 16, (4, 2): -1 / 8, (4, 0): -1 / 16,
                  (2, 1): -1 / 16}
        curve = {(2, 0): 9 / 16, (3, 0): 9 / 16, (1, 0): -1 / 16, (4, 0): -1 / 16}
        tip = {(n - 2, 0): 1 / 2, (n - 1, 1): 1 / 2, (n - 2, 1): 1 / 4, (n - 3, 0): -1 / 8, (n - 1, 2): -1 / 8}
        for expected, edge in ((eight, ((2, 3), (3, 3))), (inside, ((3, 0), (3, 1))), (curve, ((2, 0), (3, 0))),
                               (tip, ((n - 2, 0), (n - 1, 1)))):
            found = rows[frozenset(at(*end) for end in edge)]
            self.assertEqual(set(found), {at(*p) for p in expected})
            for p, weight in expected.items():
                self.assertAlmostEqual(found[at(*p)], weight, 15)

    def test_strip(self):
        # Curves on both sides, three faces at each vertex: the missing wings complete parallelograms.
        points = [[i + 0.5 * j, j, 0] for j in (0, 1) for i in range(6)]
        faces = [f for i in range(5) for f in ([i, i + 1, 6 + i], [i + 1, 7 + i, 6 + i])]
        rows = rows_of(mesh(points, faces))
        expected = {2: 1 / 2, 8: 1 / 2, 7: 1 / 16, 3: 1 / 16, 1: -1 / 16, 9: -1 / 16}
        self.assertEqual(rows[frozenset((2, 8))], expected)

    def test_curves_end_straight(self):
        rows = point_array(run(with_identity(zoo()["lines"]), BUTTERFLY), "e")[4:]
        np.testing.assert_allclose(rows[0], [7 / 16, 10 / 16, -1 / 16, 0], atol=1e-15)
        np.testing.assert_allclose(rows[1], [-1 / 16, 9 / 16, 9 / 16, -1 / 16], atol=1e-15)
        # The corners of one triangle: each side is straight.
        rows = rows_of(zoo()["triangle"])
        for edge, row in rows.items():
            self.assertEqual(row, {v: 1 / 2 for v in edge})

    def test_precision(self):
        n = 9
        for a, b in itertools.product(range(4), repeat=2):
            if a + b > 3:
                continue
            surface = grid(n, True)
            x, y = coordinates(surface)[:, :2].T
            add(surface.GetPointData(), "q", x ** a * y ** b)
            out = run(surface, BUTTERFLY)
            px, py = coordinates(out)[:, :2].T
            off = abs(point_array(out, "q") - px ** a * py ** b)
            deep = (np.minimum(px, py) >= 1) & (np.maximum(px, py) <= n - 2)
            self.assertGreater(deep.sum(), 150)
            np.testing.assert_allclose(off[deep], 0, atol=1e-9)
            side = (px > 2) & (px < n - 3) & (py < 1)  # far from the corners of the grid
            if a + b < 3:
                self.assertGreater(side.sum(), 10)
                np.testing.assert_allclose(off[side], 0, atol=1e-10)
            np.testing.assert_allclose(off[side & (py == 0)], 0, atol=1e-9)

    def test_a_crease_is_a_boundary_on_both_sides(self):
        n = 7
        whole = grid(n, True)
        coordinates(whole)[:] += 0.1 * np.random.RandomState(2).rand(n * n, 3)
        crease = [[n * 3 + x, n * 3 + x + 1] for x in range(n - 1)]
        rows = rows_of(creased(whole, crease))
        for upper in (False, True):
            faces = [f for f in faces_of(whole) if (min(f) >= 3 * n if upper else max(f) < 4 * n)]
            half = rows_of(mesh(coordinates(whole), faces))
            for edge, row in half.items():
                # The ends of the crease are corners of three and more sharp edges on the whole grid.
                if all(1 < v % n < n - 2 for v in edge):
                    self.assertEqual(rows[edge], row)

    def test_extraordinary_ends(self):
        k = 7
        made = wheel(k)
        ring, _ = neighbours(faces_of(made), 0)
        rows = rows_of(made)
        for i, w in enumerate(ring):
            row = rows[frozenset((0, w))]  # the other end is regular
            self.assertAlmostEqual(row[0], 0.75, 14)
            for j, v in enumerate(ring):
                t = 2 * np.pi * (j - i) / k
                self.assertAlmostEqual(row.get(v, 0.), (0.25 + np.cos(t) + 0.5 * np.cos(2 * t)) / k, 14)
        sphere = list(closed_surfaces())[4]  # k = 9 at the poles, 4 at the equator: the mean
        row = rows_of(sphere)[frozenset((0, 9))]
        self.assertAlmostEqual(row[0], (0.75 + (0.25 + 1 + 0.5) / 9) / 2, 14)
        self.assertAlmostEqual(row[9], (0.75 + 3 / 8) / 2, 14)
        self.assertAlmostEqual(row[10], -1 / 16, 14)


class Spectra(unittest.TestCase):
    def check(self, values, third=0.26):
        self.assertAlmostEqual(values[0], 1, 10)
        np.testing.assert_allclose(values[1:3], 0.5, atol=1e-8)
        self.assertLess(values[3], third)  # 1/4 where nothing else is said, of multiplicity two and more

    def test_interior(self):
        for k in range(3, 13):
            with self.subTest(k):
                self.check(spectrum(local_matrix(wheel(k))))

    def test_smooth_boundary(self):
        for k in range(1, 9):
            with self.subTest(k):
                self.check(spectrum(local_matrix(fan(k, np.pi if k > 1 else 1.))))

    def test_corners(self):
        shapes = [(k, a * np.pi) for k in range(1, 9) for a in (0.25, 0.5, 0.75, 1.25, 1.5, 1.75) if a < 0.9 * k]
        for k, angle in shapes:
            with self.subTest(k=k, angle=angle):
                matrix = local_matrix(flag_corner(fan(k, angle)))
                self.check(spectrum(matrix))
                turns = np.arange(k + 1) * angle / k
                for wave in (np.cos, np.sin):  # the sector itself: it does not fold
                    ring = wave(turns)
                    vector = np.array([0, *ring, *(2 * ring), *np.zeros(k)])
                    np.testing.assert_allclose((matrix @ vector)[1:k + 2], ring / 2, atol=1e-10)

    def test_crease_ends(self):
        for k in range(3, 10):
            with self.subTest(k):
                for end in (0, 1):
                    self.check(spectrum(local_matrix(creased(wheel(k), [[0, 1]]), CreaseEnd=end)), 0.43)

    def test_flatness(self):
        made = flag_corner(fan(4, 0.5 * np.pi))
        add(made.GetPointData(), "flat", np.full(made.GetNumberOfPoints(), 0.5))
        values = spectrum(local_matrix(made, arrays=[(6, 0, "flat")]))
        self.check(values)
        plain = spectrum(local_matrix(flag_corner(fan(4, 0.5 * np.pi))))
        self.assertLess(sum(values), sum(plain) - 0.1)


class Tangents(unittest.TestCase):
    def surfaces(self):
        for name, surface in zoo().items():
            if name not in ("lines", "points", "book", "bow", "mixed", "triangle", "moebius"):
                yield name, surface, {}
        random = np.random.RandomState(1)
        for k in range(3, 9):
            surface = wheel(k)
            coordinates(surface)[:, 2] *= 3
            yield f"wheel {k}", surface, {}
            yield f"crease {k}", creased(surface, [[1, 0], [0, 3]]), {}
            yield f"dart {k}", creased(surface, [[0, 1]]), {"CreaseEnd": 1}
            surface = fan(k, np.pi)
            coordinates(surface)[:] += 0.1 * random.rand(surface.GetNumberOfPoints(), 3)
            yield f"fan {k}", surface, {}
            surface = flag_corner(fan(k, 1.4 * np.pi))
            coordinates(surface)[:] += 0.1 * random.rand(surface.GetNumberOfPoints(), 3)
            yield f"corner {k}", surface, {}

    def test_tangents_are_those_of_every_level(self):
        for name, surface, options in self.surfaces():
            with self.subTest(name):
                size = surface.GetNumberOfPoints()
                found = [run(surface, BUTTERFLY, n, GenerateTangents=True, **options) for n in range(3)]
                for one in ("LimitTangent1", "LimitTangent2"):
                    exact, later = (point_array(found[n], one)[:size] for n in (0, 2))
                    lengths = np.linalg.norm(exact, axis=1)
                    self.assertGreater(lengths.max(), 0.01)
                    for a, b in zip(exact, later):
                        np.testing.assert_allclose(4 * b, a, atol=1e-9)

    def test_normals_are_those_of_the_fine_mesh(self):
        for name, surface, options in self.surfaces():
            if name in ("pentagon",) or "crease" in name:  # one face, or two planes
                continue
            with self.subTest(name):
                size = surface.GetNumberOfPoints()
                exact = point_array(run(surface, BUTTERFLY, 0, GenerateLimitNormals=True, **options), "LimitNormals")
                fine = run(surface, BUTTERFLY, 6, **options)
                points = coordinates(fine)
                sums = np.zeros((size, 3))
                faces = vtk_to_numpy(fine.GetPolys().GetConnectivityArray()).reshape(-1, 3)
                for turned in (faces, np.roll(faces, 1, axis=1), np.roll(faces, 2, axis=1)):
                    old = turned[turned[:, 0] < size]
                    normals = np.cross(points[old[:, 1]] - points[old[:, 0]], points[old[:, 2]] - points[old[:, 0]])
                    normals /= np.maximum(1e-300, np.linalg.norm(normals, axis=1))[:, None]
                    np.add.at(sums, old[:, 0], normals)
                sums /= np.linalg.norm(sums, axis=1)[:, None]
                self.assertGreater((sums * exact).sum(axis=1).min(), 0.97)

    def test_projection_moves_nothing(self):
        surface = zoo()["open cube"]
        np.testing.assert_array_equal(coordinates(run(surface, BUTTERFLY, 2, ProjectToLimit=True)),
                                      coordinates(run(surface, BUTTERFLY, 2)))


class Meshes(unittest.TestCase):
    def test_as_vtk_on_closed_surfaces(self):
        for surface in closed_surfaces():
            add(surface.GetPointData(), "x", coordinates(surface))  # VTK's points are floats
            with self.subTest(surface.GetNumberOfPoints()):
                theirs = vtkButterflySubdivisionFilter()
                theirs.SetInputData(surface)
                theirs.SetNumberOfSubdivisions(2)
                theirs.Update()
                other = point_array(theirs.GetOutput(), "x")
                ours = coordinates(run(surface, BUTTERFLY, 2))
                self.assertEqual(len(ours), len(other))
                distances = np.linalg.norm(ours[:, None] - other[None], axis=2)
                self.assertLess(distances.min(axis=1).max(), 1e-12)
                self.assertLess(distances.min(axis=0).max(), 1e-12)

    def test_filters_in_a_row(self):
        more = {"creased": creased(wheel(6), [[0, 1], [0, 4]]), "corner": flag_corner(fan(5, 1.5 * np.pi))}
        for name, surface in {**zoo(), **more}.items():
            with self.subTest(name):
                once = run(surface, BUTTERFLY, 2)
                row = run(run(surface, BUTTERFLY), BUTTERFLY)
                np.testing.assert_array_equal(coordinates(row), coordinates(once))
                self.assertEqual(faces_of(row), faces_of(once))

    def test_large_valence(self):
        k = 2000
        turns = 2 * np.pi * np.arange(k) / k
        points = [[0, 0, 1]] + [[np.cos(t), np.sin(t), 0] for t in turns]
        closed = mesh(points, [[0, 1 + i, 1 + (i + 1) % k] for i in range(k)])
        half = mesh(points, [[0, 1 + i, 2 + i] for i in range(k - 1)])
        for surface in (closed, half):
            out = run(surface, BUTTERFLY, 1, GenerateLimitNormals=True)
            self.assertTrue(np.isfinite(coordinates(out)).all())
            self.assertLess(abs(coordinates(out)).max(), 2)
            self.assertEqual(out.GetNumberOfPolys(), 4 * surface.GetNumberOfPolys())

    def test_moebius(self):
        surface = moebius(24)
        out = run(surface, BUTTERFLY, 3)
        self.assertEqual(out.GetNumberOfPolys(), 48 * 64)
        radii = np.linalg.norm(coordinates(out)[:, :2], axis=1)
        self.assertTrue(((radii > 0.55) & (radii < 1.45)).all())

    def test_semi_sharp(self):
        made = wheel(6)
        tagged = mesh(coordinates(made), faces_of(made), lines=[[0, 1], [0, 4]])
        for sharpness in (0., 1.5, 50.):
            add(tagged.GetCellData(), "s", np.array([sharpness] * 2 + [0.] * made.GetNumberOfPolys()))
            out = run(with_identity(tagged), BUTTERFLY, 2, arrays=[(4, 1, "s")])
            np.testing.assert_allclose(point_array(out, "e").sum(axis=1), 1, atol=1e-12)
            sharp = coordinates(run(creased(made, [[0, 1], [0, 4]]), BUTTERFLY, 2))
            smooth = coordinates(run(made, BUTTERFLY, 2))
            self.assertEqual((coordinates(out) == sharp).all(), sharpness == 50)
            self.assertEqual((coordinates(out) == smooth).all(), sharpness == 0)


if __name__ == "__main__":
    tools.main()
