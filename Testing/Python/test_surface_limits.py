# SPDX-License-Identifier: BSD-3-Clause
"""Limits of subdivision surfaces: against twelve further levels, and where creases are still sharp for some."""

import itertools
import unittest

import numpy as np
import tools
from surface_tools import (CATMULL_CLARK, LOOP, add, coordinates, faces_of, fan, lines_of, mesh, point_array,
                           quad_star, run, wheel, with_identity, zoo)
from vtkmodules.util.numpy_support import vtk_to_numpy

from subdivisionobjects import vtkSurfaceSubdivision

BUTTERFLY = vtkSurfaceSubdivision.MODIFIED_BUTTERFLY
SQRT_THREE = vtkSurfaceSubdivision.SQRT_THREE
RINGS = 3


def tagged(made, lines, name="Singular", values=None):
    """The same faces, with lines that have a value each."""
    result = mesh(coordinates(made), faces_of(made), lines=lines)
    values = np.ones(len(lines), dtype=np.int32) if values is None else np.array(values, dtype=float)
    add(result.GetCellData(), name, np.append(values, np.zeros(made.GetNumberOfPolys(), values.dtype)))
    return result


def crop(made, vertex):
    """What lies in a few rings around a vertex, which becomes vertex 0."""
    faces, lines = faces_of(made), lines_of(made)
    inside = {vertex}
    for _ in range(RINGS - 1):
        inside |= {v for cell in faces + lines if inside & set(cell) for v in cell}
    kept = [[i for i, cell in enumerate(cells) if inside & set(cell)] for cells in (lines, faces)]
    order = [vertex] + sorted({v for i in kept[1] for v in faces[i]} | {v for i in kept[0] for v in lines[i]} - {vertex})
    order = list(dict.fromkeys(order))
    ids = {v: i for i, v in enumerate(order)}
    part = mesh(coordinates(made)[order], [[ids[v] for v in faces[i]] for i in kept[1]],
                lines=[[ids[v] for v in lines[i]] for i in kept[0]])
    add(part.GetPointData(), "e", point_array(made, "e")[order])
    cells = kept[0] + [len(lines) + i for i in kept[1]]
    for a in range(made.GetCellData().GetNumberOfArrays()):
        array = made.GetCellData().GetArray(a)
        add(part.GetCellData(), array.GetName(), vtk_to_numpy(array)[cells])
    return part


def descend(made, scheme, vertex, levels, **options):
    """The surroundings of a vertex after that many levels, as if the whole mesh had been subdivided."""
    at_once = 2 if scheme == SQRT_THREE else 1  # every other step is different on boundaries
    part = crop(with_identity(made), vertex)
    for _ in range(levels // at_once):
        part = crop(run(part, scheme, at_once, **options), 0)
    return part


def find_normal(part):
    points = coordinates(part)
    total = np.zeros(3)
    for face in faces_of(part):
        if 0 in face:
            at = face.index(0)
            normal = np.cross(points[face[(at + 1) % len(face)]] - points[0], points[face[at - 1]] - points[0])
            total += normal / np.linalg.norm(normal)
    return total / np.linalg.norm(total)


def bumpy(made, seed):
    coordinates(made)[:, 2] += np.random.RandomState(seed).rand(made.GetNumberOfPoints())
    return made


class TwelveFurtherLevels(unittest.TestCase):
    def check(self, made, scheme, vertices, normals=True, **options):
        named = {"GenerateLimitNormals": True} if normals else {}
        exact = run(with_identity(made), scheme, 0, ProjectToLimit=True, **named, **options)
        made.GetPointData().Initialize()
        for vertex in vertices:
            part = descend(made, scheme, vertex, 12, **options)
            made.GetPointData().Initialize()
            row = point_array(exact, "e")[vertex]
            self.assertAlmostEqual(row.sum(), 1, 12)
            # The slowest part of a position is at most half of what it was, at each step.
            np.testing.assert_allclose(point_array(part, "e")[0], row, atol=2e-4)
            if normals:
                self.assertGreater(find_normal(part) @ point_array(exact, "LimitNormals")[vertex], 0.999)

    def test_interior(self):
        for k in range(3, 13):
            for scheme in (LOOP, BUTTERFLY, SQRT_THREE, CATMULL_CLARK):
                with self.subTest(k=k, scheme=scheme):
                    made = quad_star(k, 2 * np.pi, True, 2) if scheme == CATMULL_CLARK else wheel(k, 2)
                    self.check(bumpy(made, k), scheme, [0])

    def test_boundary(self):
        for k in range(1, 9):
            for scheme in (LOOP, BUTTERFLY, SQRT_THREE, CATMULL_CLARK):
                with self.subTest(k=k, scheme=scheme):
                    angle = np.pi if k > 1 else 1.
                    made = quad_star(k, angle, False, 2) if scheme == CATMULL_CLARK else fan(k, angle, 2)
                    # At 8 triangles six double steps of sqrt(3) only halve what is left of l3 beside l2.
                    self.check(bumpy(made, k), scheme, [0], 1 < k < (8 if scheme == SQRT_THREE else 9))

    def test_plain_boundary(self):
        for k in range(2, 6):
            self.check(bumpy(fan(k, np.pi, 2), k), LOOP, [0], ModifiedBoundary=False)
            self.check(bumpy(quad_star(k, np.pi, False, 2), k), CATMULL_CLARK, [0], False, ModifiedBoundary=False)

    def test_creases_and_their_ends(self):
        made = bumpy(wheel(6, 2), 1)
        star = bumpy(quad_star(5, 2 * np.pi, True, 2), 1)
        ring = sorted({v for f in faces_of(star) if 0 in f for v in (f[(f.index(0) + 1) % 4], f[f.index(0) - 1])})
        for scheme, surface, ends in ((LOOP, made, (1, 3)), (BUTTERFLY, made, (1, 3)), (SQRT_THREE, made, (1, 3)),
                                      (CATMULL_CLARK, star, (ring[0], ring[2]))):
            with self.subTest(scheme):
                crease = tagged(surface, [[ends[0], 0], [0, ends[1]]])
                self.check(crease, scheme, [0, 2, ends[0]], False)
                self.check(tagged(surface, [[ends[0], 0]]), scheme, [0, 2], False, CreaseEnd=1)

    def test_everything(self):
        for (name, made), scheme in itertools.product(zoo().items(), (LOOP, CATMULL_CLARK, BUTTERFLY, SQRT_THREE)):
            is_triangular = all(len(face) == 3 for face in faces_of(made))
            if name in ("wheel", "grid", "quads", "moebius", "points", "mixed") or not (
                    scheme == CATMULL_CLARK or is_triangular):  # seen above; cut by shape
                continue
            with self.subTest(name, scheme=scheme):
                self.check(copy_lines(made), scheme, range(min(5, made.GetNumberOfPoints())), False)


def copy_lines(made):
    return mesh(coordinates(made), faces_of(made), lines=lines_of_any(made))


def lines_of_any(made):
    ids = vtk_to_numpy(made.GetLines().GetConnectivityArray())
    offsets = vtk_to_numpy(made.GetLines().GetOffsetsArray())
    return [list(ids[a + i:a + i + 2]) for a, b in zip(offsets[:-1], offsets[1:]) for i in range(b - a - 1)]


class StillSharp(unittest.TestCase):
    def surfaces(self):
        made = bumpy(wheel(7), 3)
        for sharpness in ([2.5, 1.5], [0.3, 0.3], [3., 3.]):
            yield "crease", made, [[1, 0], [0, 4]], sharpness
        yield "three", made, [[1, 0], [0, 4], [0, 6]], [2.5, 1.5, 0.7]
        yield "end", made, [[1, 0]], [2.2]
        yield "long", made, [[1, 0], [0, 4]], [15., 15.]
        yield "longer", made, [[1, 0], [0, 4]], [40., 40.]
        yield "endless", made, [[1, 0], [0, 4]], [1e9, 1e9]
        yield "to the boundary", bumpy(fan(4, np.pi), 4), [[0, 3], [0, 2]], [1.7, 2.]
        yield "cube", zoo()["open cube"], [[0, 1], [1, 3], [1, 5]], [1.7, 2.3, 0.5]
        yield "pyramid", zoo()["pyramid"], [[0, 4], [4, 2], [3, 4]], [1.7, 2.3, 0.5]
        yield "book", zoo()["book"], [[0, 1], [1, 2]], [1.4, 0.6]
        star = bumpy(quad_star(5, 2 * np.pi, True, 2), 1)
        ring = sorted({v for f in faces_of(star) if 0 in f for v in (f[(f.index(0) + 1) % 4], f[f.index(0) - 1])})
        yield "star", star, [[0, ring[0]], [ring[2], 0]], [1.3, 2.7]

    def test_limits_do_not_depend_on_the_level(self):
        arrays = [(4, 1, "s")]
        options = ({}, {"ModifiedBoundary": False}, {"CreaseEnd": 1})
        for (name, made, lines, sharpness), scheme, option in itertools.product(
                self.surfaces(), (LOOP, CATMULL_CLARK, BUTTERFLY), options):
            with self.subTest(name, scheme=scheme, **option):
                size = made.GetNumberOfPoints()
                surface = tagged(made, lines, "s", sharpness)
                found = [run(surface, scheme, n, arrays, ProjectToLimit=True, GenerateLimitNormals=True,
                             GenerateTangents=True, **option)
                         for n in range(5)]
                # Joints that are blended have no tangents, but the normal of the faces of their level.
                has_tangents = abs(point_array(found[-1], "LimitTangent1")[:size]).max(axis=1) > 0
                for later in found[:-1]:
                    np.testing.assert_allclose(coordinates(later)[:size], coordinates(found[-1])[:size], atol=1e-12)
                    normals, last = (point_array(out, "LimitNormals")[:size] for out in (later, found[-1]))
                    if max(sharpness) < 26:  # then those of 26 levels
                        np.testing.assert_allclose(normals[has_tangents], last[has_tangents], atol=1e-8)
                    self.assertTrue(np.isfinite(normals).all())

    def test_sharpness_is_seen(self):
        for name, made, lines, sharpness in self.surfaces():
            if name == "book":
                continue
            with self.subTest(name):
                limits = [coordinates(run(tagged(made, lines, "s", s), CATMULL_CLARK, 0, [(4, 1, "s")],
                                          ProjectToLimit=True))
                          for s in (sharpness, [0.] * len(lines))]
                self.assertGreater(abs(limits[0] - limits[1]).max(), 0.003)
        made = bumpy(wheel(7), 3)  # for ever: a crease
        lines = [[1, 0], [0, 4]]
        for scheme in (LOOP, CATMULL_CLARK):
            endless = run(tagged(made, lines, "s", [1e9, 1e9]), scheme, 1, [(4, 1, "s")], ProjectToLimit=True)
            crease = run(tagged(made, lines), scheme, 1, ProjectToLimit=True)
            np.testing.assert_allclose(coordinates(endless), coordinates(crease), atol=1e-12)

    def test_twelve_further_levels(self):
        made = bumpy(wheel(5, 2), 8)
        for scheme, sharpness in itertools.product((LOOP, CATMULL_CLARK), ([1.5, 2.5], [4., 4.])):
            surface = tagged(made, [[1, 0], [0, 3]], "s", sharpness)
            exact = run(with_identity(surface), scheme, 0, [(4, 1, "s")], ProjectToLimit=True, GenerateLimitNormals=True)
            surface.GetPointData().Initialize()
            for vertex in (0, 1, 2):
                part = descend(surface, scheme, vertex, 12, arrays=[(4, 1, "s")])
                surface.GetPointData().Initialize()
                np.testing.assert_allclose(point_array(part, "e")[0], point_array(exact, "e")[vertex], atol=1e-4)
                self.assertGreater(find_normal(part) @ point_array(exact, "LimitNormals")[vertex], 0.995)


if __name__ == "__main__":
    tools.main()
