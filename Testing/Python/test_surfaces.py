# SPDX-License-Identifier: BSD-3-Clause
"""Subdivision surfaces: the operator itself, seen through an array that is an identity matrix, by its algebra."""

import itertools
import unittest

import numpy as np
import tools
from paraview import simple
from surface_tools import (
    CATMULL_CLARK, LOOP, add, children, coordinates, faces_of, fan, flag_corner, grid, lines_of, local_matrix,
    mesh, moebius, operator, point_array, quad_star, run, spectrum, wheel, with_identity, zoo,
)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter

from subdivisionobjects import vtkMultiDimensionalSubdivision, vtkSurfaceSubdivision


class Rows(unittest.TestCase):
    def test_rows_sum_to_one_and_carry_affine_maps(self):
        turn = np.random.RandomState(0).rand(3, 3)
        for (name, surface), scheme in itertools.product(zoo().items(), (LOOP, CATMULL_CLARK)):
            with self.subTest(name, scheme=scheme):
                out = run(with_identity(surface), scheme, 2)
                rows = point_array(out, "e")
                np.testing.assert_allclose(rows.sum(axis=1), 1, atol=1e-12)
                np.testing.assert_allclose(rows @ coordinates(surface), coordinates(out), atol=1e-12)
                moved = mesh(coordinates(surface) @ turn + 5, faces_of(surface))
                moved.SetLines(surface.GetLines())
                moved.SetVerts(surface.GetVerts())
                if scheme == CATMULL_CLARK or name != "pentagon":  # ears are cut by shape
                    np.testing.assert_allclose(
                        coordinates(run(moved, scheme, 2)), coordinates(out) @ turn + 5, atol=1e-11)

    def test_regular_masks_are_splines(self):
        rows = operator(grid(7, True), LOOP)
        centre = 24
        weights = sorted(w for w in rows[centre] if w)
        np.testing.assert_allclose(weights, [1 / 16] * 6 + [10 / 16], atol=1e-15)
        box = {(0, 0): 10, (1, 0): 1, (0, 1): 1, (1, 1): 1, (-1, 0): 1, (0, -1): 1, (-1, -1): 1}
        for (x, y), weight in box.items():
            self.assertAlmostEqual(rows[centre][centre + 7 * y + x], weight / 16, 14)
        coarse = grid(7, False)
        fine = run(with_identity(coarse), CATMULL_CLARK)
        rows = point_array(fine, "e")
        made = children(coarse, fine, CATMULL_CLARK)
        spline = {0: {-1: 1 / 8, 0: 6 / 8, 1: 1 / 8}, 1: {0: 1 / 2, 1: 1 / 2}}
        for row, (a, b) in ((centre, (0, 0)), (made[frozenset((24, 25))], (1, 0)), (made[frozenset((24, 31))], (0, 1)),
                            (made[frozenset((24, 25, 32, 31))], (1, 1))):
            expected = np.zeros(49)
            for (x, u), (y, v) in itertools.product(spline[a].items(), spline[b].items()):
                expected[centre + 7 * y + x] = u * v
            np.testing.assert_allclose(rows[row], expected, atol=1e-15)

    def test_boundary_is_a_cubic_spline(self):
        for scheme in (LOOP, CATMULL_CLARK):
            coarse = grid(5, scheme == LOOP)
            fine = run(with_identity(coarse), scheme)
            rows = point_array(fine, "e")
            self.assertEqual({i: w for i, w in enumerate(rows[2]) if w}, {1: 1 / 8, 2: 3 / 4, 3: 1 / 8})
            middle = children(coarse, fine, scheme)[frozenset((1, 2))]
            self.assertEqual({i: w for i, w in enumerate(rows[middle]) if w}, {1: 1 / 2, 2: 1 / 2})

    def test_quadratic_precision_on_grids(self):
        for scheme in (LOOP, CATMULL_CLARK):
            for powers in ((2, 0), (1, 1), (0, 2)):
                surface = grid(9, scheme == LOOP)
                x, y = coordinates(surface)[:, :2].T
                add(surface.GetPointData(), "q", x ** powers[0] * y ** powers[1])
                out = run(surface, scheme)
                px, py = coordinates(out)[:, :2].T
                inside = (abs(px - 4) < 2.1) & (abs(py - 4) < 2.1)
                off = (point_array(out, "q") - px ** powers[0] * py ** powers[1])[inside]
                self.assertGreater(len(off), 25)
                np.testing.assert_allclose(off, off[0], atol=1e-12)


class Spectra(unittest.TestCase):
    def check(self, values):
        values = list(values) + [0.0]
        self.assertAlmostEqual(values[0], 1, 12)
        self.assertLess(values[1], 1 - 1e-9)
        self.assertGreater(values[2], values[3] + 1e-6)

    def test_interior(self):
        for k in range(3, 13):
            with self.subTest(k):
                values = spectrum(local_matrix(wheel(k), LOOP))
                self.check(values)
                expected = 0.25 if k == 3 else 3 / 8 + np.cos(2 * np.pi / k) / 4
                np.testing.assert_allclose(values[1:3], expected, atol=1e-10)
                values = spectrum(local_matrix(quad_star(k, 2 * np.pi, True), CATMULL_CLARK))
                self.check(values)
                c = np.cos(2 * np.pi / k)
                np.testing.assert_allclose(values[1:3], (5 + c + np.sqrt((9 + c) * (1 + c))) / 16, atol=1e-10)

    def test_smooth_boundary(self):
        for k in range(1, 9):
            with self.subTest(k):
                values = spectrum(local_matrix(fan(k, np.pi if k > 1 else 1.), LOOP))
                self.check(values)
                self.assertAlmostEqual(values[1], 0.5, 10)
                if k > 1:
                    self.assertAlmostEqual(values[2], 0.5, 10)
                    values = spectrum(local_matrix(quad_star(k, np.pi, False), CATMULL_CLARK))
                    self.check(values)
                    np.testing.assert_allclose(values[1:3], 0.5, atol=1e-10)

    def test_plain_boundary_is_not_smooth_for_many_faces(self):
        values = spectrum(local_matrix(fan(8, np.pi), LOOP, ModifiedBoundary=False))
        self.assertGreater(values[2], 0.5)

    def test_corners(self):
        shapes = [(k, a * np.pi) for k in range(1, 9) for a in (0.2, 0.5, 0.85, 1.15, 1.5, 1.85) if a < 0.9 * k]
        for (k, angle), scheme in itertools.product(shapes, (LOOP, CATMULL_CLARK)):
            with self.subTest(k=k, angle=angle, scheme=scheme):
                made = fan(k, angle) if scheme == LOOP else quad_star(k, angle, False)
                matrix = local_matrix(flag_corner(made), scheme)
                values = spectrum(matrix)
                self.check(values)
                np.testing.assert_allclose(values[1:3], 0.5, atol=1e-10)
                # The subdominant pair is the sector itself: it does not fold.
                t = angle / k
                turns = np.arange(k + 1) * t
                for wave in (np.cos, np.sin):
                    ring = wave(turns)
                    vector = [0, *ring]
                    if scheme == CATMULL_CLARK:
                        vector += list(ring[:-1] + ring[1:])
                    np.testing.assert_allclose(matrix @ vector, np.array(vector) / 2, atol=1e-10)
                if angle > np.pi:
                    self.assertLess(values[3] if len(values) > 3 else 0, 0.25 + 1e-9)

    def test_angles_that_are_clamped(self):
        for angle, used in ((0.05, 1 / 8), (0.95, 7 / 8), (1.05, 9 / 8), (1.95, 15 / 8)):
            made = flag_corner(fan(4, 0.6 * np.pi))
            add(made.GetPointData(), "angle", np.full(made.GetNumberOfPoints(), 180. * angle))
            matrix = local_matrix(made, LOOP, arrays=[(10, 0, "angle")])
            turns = np.arange(5) * used * np.pi / 4
            for wave in (np.cos, np.sin):
                vector = np.array([0, *wave(turns)])
                np.testing.assert_allclose(matrix @ vector, vector / 2, atol=1e-10)

    def test_given_angle_and_flatness(self):
        made = flag_corner(fan(4, np.pi / 2))
        add(made.GetPointData(), "angle", np.full(made.GetNumberOfPoints(), 270.))
        matrix = local_matrix(made, LOOP, arrays=[(10, 0, "angle")])
        ring = np.cos(np.arange(5) * 1.5 * np.pi / 4)
        np.testing.assert_allclose(matrix @ [0, *ring], np.array([0, *ring]) / 2, atol=1e-10)
        made = flag_corner(fan(4, np.pi / 2))
        add(made.GetPointData(), "flat", np.full(made.GetNumberOfPoints(), 0.75))
        once = run(with_identity(made), LOOP, arrays=[(6, 0, "flat")])
        plain = run(with_identity(made), LOOP)
        self.assertGreater(abs(point_array(once, "e") - point_array(plain, "e")).max(), 0.01)
        np.testing.assert_allclose(point_array(once, "e").sum(axis=1), 1, atol=1e-12)

    def test_dart(self):
        made = wheel(6)
        spoke = [0, 1]
        tagged = mesh(coordinates(made), faces_of(made), lines=[spoke])
        add(tagged.GetCellData(), "Singular", np.array([1] + [0] * made.GetNumberOfPolys(), dtype=np.int32))
        matrix = local_matrix(tagged, LOOP, CreaseEnd=1)
        values = spectrum(matrix)
        np.testing.assert_allclose(values[:4], [1, .5, .5, .338], atol=2e-3)


class Limits(unittest.TestCase):
    def surfaces(self):
        for name, surface in zoo().items():
            yield name, surface, {}
        made = wheel(6)
        tagged = mesh(coordinates(made), faces_of(made), lines=[[0, 1]])
        add(tagged.GetCellData(), "Singular", np.array([1] + [0] * made.GetNumberOfPolys(), dtype=np.int32))
        yield "dart", tagged, {"CreaseEnd": 1}
        made = fan(5, 1.4 * np.pi)
        coordinates(made)[:, 2] = np.random.RandomState(1).rand(made.GetNumberOfPoints())
        yield "concave", flag_corner(made), {}
        yield "plain", fan(4, np.pi), {"ModifiedBoundary": False}
        made = zoo()["cube"]
        yield "creases", made, {"DetectFeatures": True, "FeatureAngle": 80}

    def test_projection_does_not_depend_on_the_level(self):
        for (name, surface, options), scheme in itertools.product(self.surfaces(), (LOOP, CATMULL_CLARK)):
            with self.subTest(name, scheme=scheme):
                size = surface.GetNumberOfPoints()
                found = [coordinates(run(surface, scheme, n, ProjectToLimit=True, **options))[:size] for n in range(4)]
                for later in found[1:]:
                    np.testing.assert_allclose(later, found[0], atol=1e-9)

    def test_limit_is_where_many_levels_go(self):
        for scheme, surface in ((LOOP, wheel(4, 2)), (CATMULL_CLARK, zoo()["pyramid"]), (LOOP, fan(3, np.pi, 2))):
            size = surface.GetNumberOfPoints()
            limit = coordinates(run(surface, scheme, 0, ProjectToLimit=True))
            steps = [coordinates(run(surface, scheme, n))[:size] for n in (5, 6)]
            rest = [abs(step - limit).max() for step in steps]
            self.assertLess(rest[1], 0.55 * rest[0])
            self.assertLess(rest[1], 0.01)

    def test_normals_are_those_of_the_fine_mesh(self):
        for (name, surface, options), scheme in itertools.product(self.surfaces(), (LOOP, CATMULL_CLARK)):
            if name in ("lines", "points", "book", "bow", "mixed", "moebius", "creases", "pentagon", "triangle"):
                continue
            with self.subTest(name, scheme=scheme):
                size = surface.GetNumberOfPoints()
                exact = point_array(run(surface, scheme, 0, GenerateLimitNormals=True, **options), "LimitNormals")
                later = point_array(run(surface, scheme, 2, GenerateLimitNormals=True, **options), "LimitNormals")
                np.testing.assert_allclose(later[:size], exact, atol=1e-5)
                fine = run(surface, scheme, 6, **options)
                points = coordinates(fine)
                sums = np.zeros((size, 3))
                for face in faces_of(fine):
                    for at, vertex in enumerate(face):
                        if vertex < size:
                            a = points[face[(at + 1) % len(face)]] - points[vertex]
                            b = points[face[at - 1]] - points[vertex]
                            normal = np.cross(a, b)
                            sums[vertex] += normal / max(1e-300, np.linalg.norm(normal))
                sums /= np.linalg.norm(sums, axis=1)[:, None]
                self.assertGreater((sums * exact).sum(axis=1).min(), 0.99)

    def test_tangents_span_the_plane(self):
        out = run(wheel(7), LOOP, 1, GenerateLimitNormals=True, GenerateTangents=True)
        normals = point_array(out, "LimitNormals")
        for name in ("LimitTangent1", "LimitTangent2"):
            np.testing.assert_allclose((point_array(out, name) * normals).sum(axis=1), 0, atol=1e-12)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-12)


class Meshes(unittest.TestCase):
    def test_loop_is_the_main_filter_without_boundary_rules(self):
        # The ends of the edge of three faces have a common neighbour that is in none of them.
        book = mesh(np.random.RandomState(6).rand(6, 3),
                    [[0, 1, 2], [0, 1, 3], [1, 0, 4], [0, 2, 5], [1, 5, 3]])
        for name, surface in {**zoo(), "book with a relief": book}.items():
            with self.subTest(name):
                main = vtkMultiDimensionalSubdivision()
                main.SetInputData(surface)
                main.SetNumberOfLevels(3)
                main.SetVolumeSchemeToBoxSpline()  # which cuts quads, as Loop does
                main.ModifiedBoundaryOff()
                main.Update()
                out = run(surface, LOOP, 3, ModifiedBoundary=False)
                self.assertEqual(out.GetNumberOfPoints(), main.GetOutput().GetNumberOfPoints())
                self.assertEqual(out.GetNumberOfCells(), main.GetOutput().GetNumberOfCells())
                for cell in range(out.GetNumberOfCells()):
                    a = out.GetCell(cell).GetPoints().GetData()
                    b = main.GetOutput().GetCell(cell).GetPoints().GetData()
                    np.testing.assert_allclose(vtk_to_numpy(a), vtk_to_numpy(b), atol=1e-13)

    def test_loop_is_vtks_where_the_weights_agree(self):
        # Valences 3 and 6 only: for others VTK takes Loop's own weights, which are not the default.
        tetrahedron = mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.3, 1]],
                           [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
        theirs = vtkLoopSubdivisionFilter()
        theirs.SetInputData(tetrahedron)
        theirs.SetNumberOfSubdivisions(3)
        theirs.Update()
        ours = coordinates(run(tetrahedron, LOOP, 3))
        other = coordinates(theirs.GetOutput())
        self.assertEqual(len(ours), len(other))
        distances = np.linalg.norm(ours[:, None] - other[None], axis=2)
        self.assertLess(distances.min(axis=1).max(), 1e-6)  # theirs are floats

    def test_lines_follow_their_edges(self):
        surface = grid(3, False)
        lined = mesh(coordinates(surface), faces_of(surface), lines=[[4, 1], [4, 5, 8], [2, 1]], verts=[[3, 4]])
        for scheme in (LOOP, CATMULL_CLARK):
            out = run(lined, scheme, 2)
            edges = {frozenset((f[i], f[i - 1])) for f in faces_of(out) for i in range(len(f))}
            lines = lines_of(out)
            self.assertEqual(len(lines), 16)
            for a, b in lines:
                self.assertIn(frozenset((a, b)), edges)
            self.assertEqual([lines[0][0], lines[3][1], lines[4][0], lines[11][1]], [4, 1, 4, 8])
            self.assertTrue(all(lines[i][1] == lines[i + 1][0] for i in (0, 1, 2, 4, 5, 6, 8, 9, 10)))
            self.assertEqual(out.GetNumberOfVerts(), 2)

    def test_cell_arrays_go_to_the_children(self):
        surface = zoo()["mixed"]
        add(surface.GetCellData(), "id", np.arange(surface.GetNumberOfCells()))
        # Vertices 0, 1, then a poly line of two pieces, a line, six quads.
        out = run(surface, CATMULL_CLARK, 2, GenerateOriginalIds=True)
        ids = vtk_to_numpy(out.GetCellData().GetArray("id"))
        self.assertEqual(list(np.bincount(ids)), [1, 1, 8, 4] + [16] * 6)
        self.assertTrue((vtk_to_numpy(out.GetCellData().GetArray("vtkOriginalCellIds")) == ids).all())
        origins = point_array(out, "vtkOriginalPointIds")
        self.assertEqual(list(origins[:10]), list(range(10)))
        self.assertTrue((origins[10:] == -1).all())

    def test_integers_take_a_parents_value(self):
        surface = zoo()["cube"]
        add(surface.GetPointData(), "label", np.arange(8, dtype=np.int32) + 10)
        for scheme in (LOOP, CATMULL_CLARK):
            out = run(surface, scheme, 2)
            labels = point_array(out, "label")
            self.assertEqual(list(labels[:8]), list(range(10, 18)))
            self.assertTrue(set(labels) <= set(range(10, 18)))

    def test_large_valence(self):
        k = 2000
        turns = 2 * np.pi * np.arange(k) / k
        points = [[0, 0, 1]] + [[np.cos(t), np.sin(t), 0] for t in turns]
        surface = mesh(points, [[0, 1 + i, 1 + (i + 1) % k] for i in range(k)])
        for scheme in (LOOP, CATMULL_CLARK):
            out = run(surface, scheme, 2, ProjectToLimit=True)
            self.assertTrue(np.isfinite(coordinates(out)).all())
            np.testing.assert_allclose(coordinates(out)[0][:2], 0, atol=1e-9)

    def test_filters_in_a_row(self):
        for (name, surface, options), scheme in itertools.product(Limits().surfaces(), (LOOP, CATMULL_CLARK)):
            with self.subTest(name, scheme=scheme):
                add(surface.GetPointData(), "label", np.arange(surface.GetNumberOfPoints()))
                once = run(surface, scheme, 3, **options)
                row = surface
                for _ in range(3):
                    row = run(row, scheme, 1, **options)
                self.assertTrue((coordinates(row) == coordinates(once)).all())
                self.assertTrue((point_array(row, "label") == point_array(once, "label")).all())
                self.assertEqual(faces_of(row), faces_of(once))
                self.assertEqual(lines_of(row), lines_of(once))

    def test_what_was_changed_in_between_counts(self):
        made = wheel(6)
        lined = mesh(coordinates(made), faces_of(made), lines=[[0, 1], [0, 4]])
        once = run(lined, LOOP, 1)
        add(once.GetCellData(), "Singular", np.array([1, 1, 1, 0] + [0] * once.GetNumberOfPolys(), dtype=np.int32))
        fresh = mesh(coordinates(once), faces_of(once), lines=lines_of(once))
        fresh.GetCellData().ShallowCopy(once.GetCellData())
        for surface in (once, fresh):
            surface.GetPointData().Initialize()
        a, b = run(once, LOOP, 1), run(fresh, LOOP, 1)
        self.assertEqual(faces_of(a), faces_of(b))
        np.testing.assert_array_equal(coordinates(a), coordinates(b))
        moved = run(made, LOOP, 1)
        coordinates(moved)[0] += 1
        again = run(moved, LOOP, 1)
        self.assertGreater(abs(coordinates(again)[0] - coordinates(run(made, LOOP, 2))[0]).max(), 0.1)

    def test_semi_sharp(self):
        made = wheel(6)
        crease = [[0, 1], [0, 4]]
        for sharpness, same in ((0., None), (50., 1), (1.5, None)):
            tagged = mesh(coordinates(made), faces_of(made), lines=crease)
            add(tagged.GetCellData(), "s", np.array([sharpness] * 2 + [0.] * made.GetNumberOfPolys()))
            out = run(tagged, LOOP, 3, arrays=[(4, 1, "s")])
            add(tagged.GetCellData(), "Singular", np.array([1] * 2 + [0] * made.GetNumberOfPolys(), dtype=np.int32))
            sharp = run(tagged, LOOP, 3)
            tagged.GetCellData().RemoveArray("Singular")
            smooth = run(tagged, LOOP, 3)
            if sharpness == 0.:
                np.testing.assert_array_equal(coordinates(out), coordinates(smooth))
            elif same:
                np.testing.assert_array_equal(coordinates(out), coordinates(sharp))
            else:
                row = tagged
                for _ in range(3):
                    row = run(row, LOOP, 1, arrays=[(4, 1, "s")])
                np.testing.assert_array_equal(coordinates(row), coordinates(out))
                self.assertGreater(abs(coordinates(out) - coordinates(sharp)).max(), 1e-4)
                self.assertGreater(abs(coordinates(out) - coordinates(smooth)).max(), 1e-4)
                left = vtk_to_numpy(run(tagged, LOOP, 1, arrays=[(4, 1, "s")]).GetCellData().GetArray("s"))
                self.assertEqual(list(left[:4]), [0.5] * 4)

    def test_semi_sharp_rows_are_means(self):
        made = wheel(6)
        crease = [[0, 1], [0, 4]]
        tagged = with_identity(mesh(coordinates(made), faces_of(made), lines=crease))
        faces = [0.] * made.GetNumberOfPolys()

        def flagged(edges):
            add(tagged.GetCellData(), "Singular", np.array([*edges] + [0] * len(faces), dtype=np.int32))
            rows = point_array(run(tagged, LOOP), "e")
            tagged.GetCellData().RemoveArray("Singular")
            return rows

        middle = children(made, run(made, LOOP), LOOP)
        for sharpness in ((0.2, 0.6), (0.5, 0.5), (0.3, 1.4)):
            add(tagged.GetCellData(), "s", np.array([*sharpness, *faces]))
            rows = point_array(run(tagged, LOOP, arrays=[(4, 1, "s")]), "e")
            tagged.GetCellData().RemoveArray("s")
            # Between the creases that are sharp for the whole step, as if flagged, and all of them: a vertex
            # has the mean of its edges that are sharp in part, an edge its own, a smooth edge that of its end.
            whole, all_of_them = flagged([s >= 1 for s in sharpness]), flagged([1, 1])
            parts = [s for s in sharpness if s < 1]
            mean = sum(parts) / len(parts)
            for row, weight in ((0, mean), (middle[frozenset((0, 1))], sharpness[0]),
                                (middle[frozenset((0, 4))], min(1, sharpness[1])), (middle[frozenset((0, 2))], mean)):
                expected = (1 - weight) * whole[row] + weight * all_of_them[row]
                np.testing.assert_allclose(rows[row], expected, atol=1e-15)

    def test_cache_gives_what_a_fresh_filter_gives(self):
        surface = flag_corner(fan(4, 0.6 * np.pi))
        subdivision = vtkSurfaceSubdivision()
        subdivision.SetInputData(surface)
        subdivision.SetNumberOfLevels(2)
        subdivision.Update()
        polys = subdivision.GetOutput().GetPolys()
        for angle in (0.5, 1.4):
            coordinates(surface)[:] = coordinates(fan(4, angle * np.pi))
            surface.GetPoints().Modified()
            subdivision.Update()
            self.assertIs(subdivision.GetOutput().GetPolys(), polys)
            np.testing.assert_array_equal(
                coordinates(subdivision.GetOutput()), coordinates(run(surface, LOOP, 2)))
        self.assertEqual(subdivision.GetNumberOfTopologyBuilds(), 1)
        for name, value in (("ModifiedBoundary", False), ("NumberOfLevels", 1), ("Scheme", CATMULL_CLARK),
                            ("ModifiedBoundary", True), ("CreaseEnd", 1), ("Scheme", LOOP), ("NumberOfLevels", 2),
                            ("LoopWeights", 1), ("LoopWeights", 0)):
            getattr(subdivision, "Set" + name)(value)
            subdivision.Update()
            fresh = run(surface, subdivision.GetScheme(), subdivision.GetNumberOfLevels(), CacheOperator=False,
                        ModifiedBoundary=subdivision.GetModifiedBoundary(), CreaseEnd=subdivision.GetCreaseEnd(),
                        LoopWeights=subdivision.GetLoopWeights())
            np.testing.assert_array_equal(coordinates(subdivision.GetOutput()), coordinates(fresh))
        surface.GetCellData().GetArray("Singular").SetValue(0, 0)
        surface.GetCellData().GetArray("Singular").Modified()
        surface.Modified()
        subdivision.Update()
        np.testing.assert_array_equal(coordinates(subdivision.GetOutput()), coordinates(run(surface, LOOP, 2)))

    def test_vertices_of_one_face(self):
        corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]])
        quad = mesh(corners, [[0, 1, 2, 3]])
        for scheme in (CATMULL_CLARK, vtkSurfaceSubdivision.FOUR_EIGHT, vtkSurfaceSubdivision.MODIFIED_BUTTERFLY):
            np.testing.assert_array_equal(coordinates(run(quad, scheme, 2))[:4], corners)
        for scheme in (LOOP, vtkSurfaceSubdivision.SQRT_THREE):  # smooth there
            self.assertGreater(abs(coordinates(run(quad, scheme, 2))[:4] - corners)[[1, 3]].max(), 0.1)

    def test_seams_of_textures(self):
        # A tube: the seam's points are there twice, with texture coordinates 0 and 1.
        n = 8
        turns = 2 * np.pi * np.arange(n + 1) / n
        turns[n] = 0
        points = [[np.cos(t), np.sin(t), z] for z in range(4) for t in turns]
        u = np.array([[i / n, z / 3] for z in range(4) for i in range(n + 1)])
        faces = [[r * (n + 1) + i, r * (n + 1) + i + 1, (r + 1) * (n + 1) + i + 1, (r + 1) * (n + 1) + i]
                 for r in range(3) for i in range(n)]
        triangles = [half for f in faces for half in ([f[0], f[1], f[2]], [f[0], f[2], f[3]])]
        for scheme, faces in ((LOOP, triangles), (vtkSurfaceSubdivision.MODIFIED_BUTTERFLY, triangles),
                              (CATMULL_CLARK, faces)):
            surface = mesh(points, faces)
            apart = run(surface, scheme, 2)
            add(surface.GetPointData(), "texture", u)
            surface.GetPointData().SetActiveTCoords("texture")
            closed = [[a if a % (n + 1) < n else a - n for a in face] for face in faces]
            joined = run(mesh(points, closed), scheme, 2, GenerateLimitNormals=True)
            out = run(surface, scheme, 2, GenerateLimitNormals=True)
            corners = np.concatenate(faces_of(out))
            np.testing.assert_array_equal(corners, np.concatenate(faces_of(apart)))
            same = np.concatenate(faces_of(joined))
            np.testing.assert_allclose(coordinates(out)[corners], coordinates(joined)[same], atol=1e-14)
            np.testing.assert_allclose(
                point_array(out, "LimitNormals")[corners], point_array(joined, "LimitNormals")[same], atol=1e-14)
            self.assertEqual(coordinates(out).shape, coordinates(apart).shape)
            texture = point_array(out, "texture")
            self.assertEqual(out.GetPointData().GetTCoords().GetName(), "texture")
            self.assertEqual((texture[:, 0] == 0).sum(), (texture[:, 0] == 1).sum())
            self.assertEqual((texture[:, 0] == 0).sum(), 13)
            alone = run(surface, scheme, 2, JoinSeams=False)
            np.testing.assert_array_equal(coordinates(alone), coordinates(apart))

    def test_bad_cells_are_passed_over(self):
        bad = mesh(coordinates(zoo()["cube"]), faces_of(zoo()["cube"]) + [[0, 1, 0, 2], [3, 3, 3]])
        with tools.quiet():
            out = run(bad, CATMULL_CLARK, 1)
        self.assertEqual(out.GetNumberOfPolys(), 24)

    def test_limit_on_cells(self):
        with tools.quiet():
            out = run(zoo()["cube"], CATMULL_CLARK, 5, MaximumNumberOfCells=6143)
        self.assertEqual(out.GetNumberOfPoints(), 0)
        self.assertEqual(run(zoo()["cube"], CATMULL_CLARK, 5, MaximumNumberOfCells=6144).GetNumberOfPolys(), 6144)


class InParaView(unittest.TestCase):
    def test_pipeline(self):
        sphere = simple.Sphere()
        surface = simple.SurfaceSubdivision(Input=sphere, Scheme="Catmull-Clark", NumberOfLevels=2, GenerateLimitNormals=1)
        surface.UpdatePipeline()
        out = tools.output(surface)
        self.assertGreater(out.GetNumberOfPolys(), 1000)
        self.assertIn("LimitNormals", tools.arrays(out.GetPointData()))


    def test_adaptive(self):
        sphere = simple.Sphere(ThetaResolution=12, PhiResolution=12)
        surface = simple.AdaptiveSurfaceSubdivision(
            Input=sphere, RefineByAttributeError=0, RefineByGeometricError=1,
            GeometricTolerance=1e-3, MaximumLevel=10)
        surface.UpdatePipeline()
        out = tools.output(surface)
        coarse = out.GetNumberOfPolys()
        generations = vtk_to_numpy(out.GetCellData().GetArray("Generation"))
        self.assertGreater(generations.max(), 1)
        triangles = vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        self.assertTrue((np.unique(edges, axis=0, return_counts=True)[1] == 2).all())
        surface.GeometricTolerance = 1e-4
        surface.UpdatePipeline()
        self.assertGreater(tools.output(surface).GetNumberOfPolys(), 4 * coarse)
        # Arrays are chosen by their properties, also in a trace.
        directions = simple.Calculator(Input=sphere, ResultArrayName="Directions", Function="2*coords")
        surface = simple.AdaptiveSurfaceSubdivision(
            Input=directions, RefineByGeometricError=0, RefineByAttributeError=1,
            AttributeArray=["POINTS", "Directions"], AttributeTolerance=0.05,
            MaximumLevel=8)
        surface.UpdatePipeline()
        out = tools.output(surface)
        triangles = vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        values = vtk_to_numpy(out.GetPointData().GetArray("Directions")).astype(float)
        change = np.linalg.norm(values[triangles] - values[triangles[:, [1, 2, 0]]], axis=2).max()
        self.assertLess(change, 0.05 * 2 * np.sqrt(3))
        self.assertGreater(out.GetNumberOfPolys(), 1000)


if __name__ == "__main__":
    tools.main()
