# SPDX-License-Identifier: BSD-3-Clause
"""Corners, creases and surfaces that are marked in ParaView: arrays, selections, functions, other geometry."""

import unittest

import numpy as np
import tools
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def points(proxy):
    proxy.UpdatePipeline()
    return vtk_to_numpy(tools.output(proxy).GetPoints().GetData())


class Marks(unittest.TestCase):
    def setUp(self):
        self.model = simple.SubdivisionModel(Model="MaterialBlock")
        self.rest = points(self.model)
        self.still = self.stay(self.subdivide())  # where the lattice is regular
        self.free = [i for i in range(len(self.rest)) if i not in self.still]
        self.assertGreater(len(self.free), 8)

    def subdivide(self, **options):
        return simple.MultidimensionalSubdivision(Input=self.model, **options)

    def stay(self, proxy):
        """The points of the input that do not move."""
        return set(np.nonzero((points(proxy)[:len(self.rest)] == self.rest).all(axis=1))[0])

    def stopped(self, proxy):
        """Those of them that move without marks."""
        return self.stay(proxy) - self.still

    def test_defaults(self):
        proxy = self.subdivide()
        self.assertEqual((proxy.MarkCorners, proxy.MarkCreases, proxy.MarkSurfaces, proxy.MarkByFunction),
                         (1, 0, 0, 0))
        self.assertEqual(list(proxy.MarksArray), ["POINTS", "None"])
        self.assertEqual(proxy.MatchPointsBy, "Position")
        self.assertEqual(self.stopped(proxy), set())

    def test_selected_points_are_corners(self):
        some = self.free[3:5]
        ids = simple.IDSelectionSource(IDs=[0, some[0], 0, some[1]], FieldType="POINT")
        self.assertEqual(self.stopped(self.subdivide(MarkSelection=ids)), set(some))
        surface = simple.SurfaceSubdivision(Input=simple.ExtractSurface(Input=self.model), Scheme="Loop")
        before = points(surface).copy()
        surface.MarkSelection = ids
        self.assertTrue((points(surface) != before).any())

    def test_an_array(self):
        marks = simple.Calculator(Input=self.model, ResultArrayName="Marks", Function="if(coordsZ > 0.9, 1, 0)")
        marks.UpdatePipeline()
        proxy = simple.MultidimensionalSubdivision(Input=marks, MarksArray=["POINTS", "Marks"])
        expected = {i for i in self.free if self.rest[i, 2] > 0.9}
        self.assertTrue(0 < len(expected) < len(self.free))
        self.assertEqual(self.stopped(proxy), expected)
        proxy.MarkCorners = 0
        self.assertEqual(self.stopped(proxy), set())
        free = points(proxy).copy()
        proxy.MarkCreases = 1
        self.assertTrue((points(proxy) != free).any())
        proxy.MarkCreases = 0
        proxy.MarkSurfaces = 1
        self.assertTrue((points(proxy) != free).any())

    def test_creases_for_some_levels(self):
        marks = simple.Calculator(Input=self.model, ResultArrayName="Marks", Function="if(coordsZ > 0.9, 2, 0)")
        marks.UpdatePipeline()
        proxy = simple.MultidimensionalSubdivision(Input=marks, MarksArray=["POINTS", "Marks"], MarkCorners=0,
                                                   MarkCreases=1, NumberOfLevels=3)
        for_ever = points(proxy).copy()
        proxy.LevelsArray = ["POINTS", "Marks"]
        self.assertTrue((points(proxy) != for_ever).any())
        proxy.NumberOfLevels = 2
        some = points(proxy).copy()
        proxy.LevelsArray = ["POINTS", "None"]
        self.assertTrue((points(proxy) == some).all())

    def test_a_function(self):
        proxy = self.subdivide(MarkByFunction=1)
        proxy.MarkFunction = "Sphere"
        proxy.MarkFunction.Center = list(self.rest[self.free[3]])
        proxy.MarkFunction.Radius = 0.01
        self.assertEqual(self.stopped(proxy), {self.free[3]})

    def test_lines_of_another_mesh(self):
        edges = simple.FeatureEdges(Input=simple.ExtractSurface(Input=self.model), FeatureAngle=60.0)
        self.assertGreater(len(points(edges)), 8)
        free = points(self.subdivide())
        creased = points(self.subdivide(CreaseGeometry=edges))
        sharp = points(self.subdivide(DetectFeatures=1, FeatureAngle=60.0))
        self.assertGreater(abs(creased - free).max(), 0.01)
        np.testing.assert_allclose(np.sort(creased, axis=0), np.sort(sharp, axis=0), atol=1e-6)


if __name__ == "__main__":
    tools.main()
