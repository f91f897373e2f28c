# SPDX-License-Identifier: BSD-3-Clause
"""What every surface scheme does on the meshes that matter: one triangle, Moebius strips, large valences, strips,
lines, vertices, seams."""

import unittest

import numpy as np
import tools
from surface_tools import (add, cells, coordinates, faces_of, fan, flag_corner, lines_of, mesh, moebius, point_array,
                           quad_star, run)
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING

from subdivisionobjects import vtkSurfaceSubdivision

SCHEMES = {name: getattr(vtkSurfaceSubdivision, name) for name in (
    "LOOP", "MODIFIED_BUTTERFLY", "CATMULL_CLARK", "DOO_SABIN", "MIDEDGE", "FOUR_EIGHT", "SQRT_THREE", "LINEAR")}
OF_TRIANGLES = ("LOOP", "MODIFIED_BUTTERFLY", "SQRT_THREE", "LINEAR")
DUAL = ("DOO_SABIN", "MIDEDGE")


def topology(made):
    """Euler characteristic, number of boundary curves, and edges that do not have one or two faces."""
    sides = {}
    for face in faces_of(made):
        for i, vertex in enumerate(face):
            side = frozenset((vertex, face[i - 1]))
            sides[side] = sides.get(side, 0) + 1
    vertices = {v for face in faces_of(made) for v in face}
    after = {}
    for side, count in sides.items():
        if count == 1:
            for v in side:
                after.setdefault(v, []).extend(side - {v})
    curves, seen = 0, set()
    for start in after:
        if start not in seen:
            curves += 1
            stack = [start]
            while stack:
                at = stack.pop()
                if at not in seen:
                    seen.add(at)
                    stack += after[at]
    return len(vertices) - len(sides) + made.GetNumberOfPolys(), curves, sum(c > 2 for c in sides.values())


class EveryScheme(unittest.TestCase):
    def outputs(self, make, levels):
        for name, scheme in SCHEMES.items():
            yield name, run(make(name), scheme, levels, ProjectToLimit=True, GenerateLimitNormals=True)

    def test_one_triangle(self):
        corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        for name, out in self.outputs(lambda _: mesh(corners, [[0, 1, 2]]), 4):
            self.assertEqual(topology(out), (1, 1, 0))
            x, y, z = coordinates(out).T
            self.assertGreater(min(x.min(), y.min(), 1 - (x + y).max()), -1e-12)
            self.assertEqual(abs(z).max(), 0)
            if name == "MODIFIED_BUTTERFLY":  # its corners stay, and so do its sides
                self.assertEqual(((x == 0) | (y == 0) | (abs(x + y - 1) < 1e-12)).sum(), 48)
            if name not in DUAL:
                normals = point_array(out, "LimitNormals")
                lengths = np.linalg.norm(normals, axis=1)
                np.testing.assert_allclose(normals[lengths > 0.5], [[0, 0, 1]] * (lengths > 0.5).sum(), atol=1e-12)
                self.assertGreater((lengths > 0.5).sum(), len(lengths) - 4)

    def test_moebius_strip(self):
        def make(name):
            made = moebius(12)
            if name in OF_TRIANGLES:
                halves = [half for f in faces_of(made) for half in ([f[0], f[1], f[2]], [f[0], f[2], f[3]])]
                made = mesh(coordinates(made), halves)
            return made

        for name, out in self.outputs(make, 4):
            self.assertEqual(topology(out), (0, 1, 0))
            x, y, z = coordinates(out).T
            self.assertTrue(((np.hypot(x, y) > 0.4) & (np.hypot(x, y) < 1.5) & (abs(z) < 0.5)).all())

    def test_valences_of_three_and_two_thousand(self):
        for k in (3, 2000):
            turns = 2 * np.pi * np.arange(k) / k
            points = [[np.cos(t), np.sin(t), 0] for t in turns] + [[0, 0, 1], [0, 0, -1]]
            faces = [f for i in range(k) for f in ([i, (i + 1) % k, k], [(i + 1) % k, i, k + 1])]
            for name, out in self.outputs(lambda _: mesh(points, faces), 2):
                used = np.unique(np.concatenate(faces_of(out)))
                made = coordinates(out)[used]
                self.assertTrue(np.isfinite(coordinates(out)).all())
                self.assertLess(abs(made).max(), 1 + 1e-12 if name != "MODIFIED_BUTTERFLY" else 1.6)
                self.assertLess(abs(made.mean(axis=0)).max(), 1e-9)
                if k == 3:
                    self.assertEqual(topology(out), (2, 0, 0))
                if name not in DUAL:
                    poles = coordinates(out)[k:k + 2]
                    np.testing.assert_allclose(poles[:, :2], 0, atol=1e-9)
                    np.testing.assert_allclose(poles[0], -poles[1], atol=1e-9)
                    self.assertGreater(poles[0][2], 0)

    def test_order_of_cells(self):
        for name, scheme in SCHEMES.items():
            with self.subTest(name):
                made = mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 0, 1], [2, 1, 1], [3, 0, 0]],
                            [[4, 5, 6]], lines=[[0, 1], [4, 6]], verts=[[6], [2]])
                made.SetStrips(cells([[0, 1, 2, 3], [3, 1, 5, 4]]))
                # Vertices 0, 1; lines 2, 3; the triangle 4; the strips 5 and 6.
                add(made.GetCellData(), "id", np.arange(7, dtype=np.int32))
                start = run(made, scheme, 0)
                self.assertEqual([start.GetNumberOfVerts(), start.GetNumberOfLines(), start.GetNumberOfPolys(),
                                  start.GetNumberOfStrips()], [2, 2, 5, 0])
                self.assertEqual(faces_of(start), [[4, 5, 6], [0, 1, 2], [2, 1, 3], [3, 1, 5], [5, 1, 4]])
                self.assertEqual(list(vtk_to_numpy(start.GetCellData().GetArray("id"))), [0, 1, 2, 3, 4, 5, 5, 6, 6])
                out = run(made, scheme, 2)
                ids = vtk_to_numpy(out.GetCellData().GetArray("id"))
                self.assertEqual(list(ids[:2]), [0, 1])
                lines = out.GetNumberOfLines()
                self.assertEqual(lines, 6 if name == "SQRT_THREE" else 4 if name == "FOUR_EIGHT" else 8)
                self.assertEqual(list(ids[2:2 + lines]), [2] * (lines // 2) + [3] * (lines // 2))
                polys = ids[2 + lines:]
                self.assertEqual(set(polys), {4, 5, 6})
                if name not in DUAL + ("SQRT_THREE", "FOUR_EIGHT"):  # there cells lie in several parents
                    self.assertTrue((np.diff(polys) >= 0).all())

    def test_lines_follow_their_edges(self):
        points = [[x, y, 0.1 * x * y] for y in range(4) for x in range(4)]
        quads = [[4 * y + x, 4 * y + x + 1, 4 * y + x + 5, 4 * y + x + 4] for y in range(3) for x in range(3)]
        free = [[16, 17], [17, 5]]
        for name, scheme in SCHEMES.items():
            faces = [half for f in quads for half in (f[:3], [f[0], f[2], f[3]])] if name in OF_TRIANGLES else quads
            made = mesh(points + [[0, 0, 2], [1, 0, 1]], faces, lines=[[4, 5], [5, 9], [1, 2]] + free)
            with self.subTest(name):
                out = run(made, scheme, 2)
                sides = {frozenset((f[i], f[i - 1])) for f in faces_of(out) for i in range(len(f))}
                lines = lines_of(out)
                on_faces = [frozenset(line) in sides for line in lines]
                pieces = len(lines) // 5
                # Lines of dual schemes have points of their own.
                self.assertEqual(on_faces, [name not in DUAL] * (3 * pieces) + [False] * (2 * pieces))
                for i in range(5):
                    for a, b in zip(lines[pieces * i:pieces * i + pieces], lines[pieces * i + 1:pieces * i + pieces]):
                        self.assertEqual(a[1], b[0])
                ends = coordinates(out)[[lines[3 * pieces][0], lines[3 * pieces][1]]]
                np.testing.assert_allclose(ends[0], [0, 0, 2])
                if name not in DUAL:
                    self.assertEqual(lines[0][0], 4)
                    self.assertEqual(lines[pieces - 1][1], 5)

    def test_nothing_is_refused(self):
        # Edges of three faces, two equal faces, a pinched vertex, a face seen from behind, a free edge.
        points = np.random.RandomState(4).rand(12, 3)
        faces = [[0, 1, 2], [0, 1, 3], [1, 0, 4], [2, 5, 6], [2, 6, 5], [7, 8, 9], [7, 9, 10], [8, 7, 10], [0, 1, 2]]
        for name, out in self.outputs(lambda _: mesh(points, faces, lines=[[4, 11]], verts=[[11]]), 2):
            factor = 9 if name == "SQRT_THREE" else 12 if name in ("CATMULL_CLARK", "DOO_SABIN") else 3
            self.assertGreaterEqual(out.GetNumberOfPolys(), factor * len(faces))
            self.assertTrue(np.isfinite(coordinates(out)).all())
            self.assertLess(abs(coordinates(out) - 0.5).max(), 1)

    def test_polygons_for_triangle_schemes(self):
        square = mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
        for name, scheme in SCHEMES.items():
            with self.subTest(name):
                said = []

                @calldata_type(VTK_STRING)
                def hear(_object, _event, text, said=said):
                    said.append(text)

                subdivision = vtkSurfaceSubdivision()
                subdivision.AddObserver("WarningEvent", hear)
                subdivision.SetInputData(square)
                subdivision.SetScheme(scheme)
                subdivision.Update()
                self.assertEqual(said, [])  # that is normal work
                out = subdivision.GetOutput()
                sizes = {out.GetCell(i).GetNumberOfPoints() for i in range(out.GetNumberOfCells())}
                self.assertEqual(sizes == {3}, name in (*OF_TRIANGLES, "FOUR_EIGHT"))


class Flatness(unittest.TestCase):
    def test_points_come_closer_to_the_plane_of_the_corner(self):
        for name in ("LOOP", "MODIFIED_BUTTERFLY", "CATMULL_CLARK"):
            for angle in (0.6 * np.pi, 1.4 * np.pi):
                made = quad_star(4, angle, False) if name == "CATMULL_CLARK" else fan(4, angle)
                x, y, z = coordinates(made).T
                z[:] = (abs(y) > 1e-9) & (abs(x * np.sin(angle) - y * np.cos(angle)) > 1e-9)  # 0: on the curves
                heights = []
                for s in (0., 0.5, 1., -1.):
                    surface = flag_corner(made)
                    add(surface.GetPointData(), "flat", np.full(surface.GetNumberOfPoints(), s))
                    out = run(surface, SCHEMES[name], 1, arrays=[(6, 0, "flat")])
                    near = {v for f in faces_of(out) if 0 in f for v in f}
                    heights.append(coordinates(out)[sorted(near), 2].max())
                with self.subTest(name, angle=angle):
                    self.assertGreater(heights[0], 0.1)
                    self.assertAlmostEqual(heights[1], heights[0] / 2, 12)
                    self.assertAlmostEqual(heights[2], 0, 12)
                    plain = run(flag_corner(made), SCHEMES[name], 1)
                    near = {v for f in faces_of(plain) if 0 in f for v in f}
                    # Negative: what is done without the array.
                    self.assertEqual(heights[3], coordinates(plain)[sorted(near), 2].max())
                    if angle < np.pi or name == "MODIFIED_BUTTERFLY":
                        self.assertEqual(heights[3], heights[0])
                    else:
                        self.assertLess(heights[3], heights[0])


if __name__ == "__main__":
    tools.main()
