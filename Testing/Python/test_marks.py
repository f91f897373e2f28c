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

    def subdivide(self, **options):
        return simple.MultidimensionalSubdivision(Input=self.model, **options)

    def stay(self, proxy):
        """The points of the input that do not move."""
        return set(np.nonzero((points(proxy)[:len(self.rest)] == self.rest).all(axis=1))[0])

    def test_defaults(self):
        proxy = self.subdivide()
        self.assertEqual((proxy.MarkCorners, proxy.MarkCreases, proxy.MarkSurfaces, proxy.MarkByFunction),
                         (1, 0, 0, 0))
        self.assertEqual(list(proxy.MarksArray), ["POINTS", "None"])
        self.assertEqual(proxy.CreasePoints, "Coincident")
        self.assertEqual(self.stay(proxy), set())

    def test_selected_points_are_corners(self):
        ids = simple.IDSelectionSource(IDs=[0, 4, 0, 7], FieldType="POINT")
        self.assertEqual(self.stay(self.subdivide(MarkSelection=ids)), {4, 7})
        surface = simple.SurfaceSubdivision(Input=simple.ExtractSurface(Input=self.model), Scheme="Loop")
        before = points(surface).copy()
        surface.MarkSelection = ids
        self.assertTrue((points(surface) != before).any())

    def test_an_array(self):
        marks = simple.Calculator(Input=self.model, ResultArrayName="Marks", Function="if(coordsZ > 0.9, 1, 0)")
        marks.UpdatePipeline()
        proxy = simple.MultidimensionalSubdivision(Input=marks, MarksArray=["POINTS", "Marks"])
        self.assertEqual(self.stay(proxy), set(np.nonzero(self.rest[:, 2] > 0.9)[0]))
        proxy.MarkCorners = 0
        self.assertEqual(self.stay(proxy), set())
        free = points(proxy).copy()
        proxy.MarkCreases = 1
        creased = points(proxy).copy()
        self.assertTrue((creased != free).any())
        proxy.MarkSurfaces = 1
        self.assertTrue((points(proxy) != creased).any())

    def test_a_function(self):
        proxy = self.subdivide(MarkByFunction=1)
        proxy.MarkFunction = "Sphere"
        proxy.MarkFunction.Center = list(self.rest[3])
        proxy.MarkFunction.Radius = 0.01
        self.assertEqual(self.stay(proxy), {3})

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
