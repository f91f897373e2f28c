# SPDX-License-Identifier: BSD-3-Clause
"""Points on the limit, and its normals, in ParaView."""

import numpy as np
import tools
import unittest
from paraview import simple
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.util.numpy_support import vtk_to_numpy


def subdivide(source, levels, **options):
    proxy = simple.MultidimensionalSubdivision(Input=source, NumberOfLevels=levels, **options)
    proxy.UpdatePipeline()
    return tools.output(proxy)


def points(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())


class Limit(unittest.TestCase):
    def test_every_model_at_every_level(self):
        for model in simple.SubdivisionModel().GetProperty("Model").Available:
            with self.subTest(model):
                source = simple.SubdivisionModel(Model=model)
                coarse = subdivide(source, 0, ProjectToLimit=1)
                self.assertFalse(np.array_equal(points(coarse), points(subdivide(source, 0))))
                for levels in (1, 2):
                    fine = subdivide(source, levels, ProjectToLimit=1)
                    size = coarse.GetNumberOfPoints()
                    self.assertLess(abs(points(fine)[:size] - points(coarse)).max(), 1e-5)
                    tension = [vtk_to_numpy(grid.GetPointData().GetArray("Tension"))[:size]
                               for grid in (coarse, fine)]
                    self.assertLess(abs(tension[1] - tension[0]).max(), 1e-5)
                    coarse = fine

    def test_normals(self):
        for model in simple.SubdivisionModel().GetProperty("Model").Available:
            with self.subTest(model):
                source = simple.SubdivisionModel(Model=model)
                smooth = subdivide(source, 1, GenerateLimitNormals=1, GenerateClassification=1)
                self.assertEqual(smooth.GetPointData().GetNormals().GetName(), "LimitNormals")
                lengths = self.lengths(smooth)
                self.assertTrue(np.logical_or(lengths == 0, abs(lengths - 1) < 1e-6).all())
                # Inside solids there is none, but whatever can be seen is shaded.
                rules = vtk_to_numpy(smooth.GetPointData().GetArray("RuleDimension"))
                self.assertTrue((lengths[rules == 3] == 0).all())
                seen = vtkDataSetSurfaceFilter()
                seen.SetInputData(smooth)
                seen.Update()
                self.assertGreater(self.lengths(seen.GetOutput()).min(), 0.)

    def test_normals_of_a_surface_are_made_on_request(self):
        for shades, wanted in ((0, False), (0, True), (1, False)):
            surface = simple.SurfaceSubdivision(
                Input=simple.Sphere(), GenerateLimitNormals=wanted, SmoothShading=shades)
            surface.UpdatePipeline()
            self.assertEqual(bool(tools.output(surface).GetPointData().HasArray("LimitNormals")),
                             bool(wanted or shades))

    @staticmethod
    def lengths(data):
        return np.linalg.norm(vtk_to_numpy(data.GetPointData().GetArray("LimitNormals")), axis=1)


if __name__ == "__main__":
    tools.main()
