# SPDX-License-Identifier: BSD-3-Clause
"""Inputs of every kind in ParaView: images, quadratic cells, and cages for deformation."""

import unittest

from paraview import simple
from vtkmodules.util.vtkConstants import VTK_QUADRATIC_TETRA
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

import tools


class InputKinds(unittest.TestCase):
    def test_filters_are_offered_for_images(self):
        image = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
        image.UpdatePipeline()
        made = simple.MultidimensionalSubdivision(Input=image, NumberOfLevels=1)
        made.UpdatePipeline()
        self.assertEqual(tools.output(made).GetNumberOfCells(), 4 ** 3 * 8)
        self.assertIn("RTData", tools.arrays(tools.output(made).GetPointData()))
        for name in ("SimplicialComplexTopology", "RedGreenRefinement"):
            other = getattr(simple, name)(Input=image)
            other.UpdatePipeline()
            self.assertGreater(tools.output(other).GetNumberOfCells(), 6 * 64)
        flat = simple.SurfaceSubdivision(Input=simple.Wavelet(WholeExtent=[-2, 2, -2, 2, 0, 0]), Scheme="Catmull-Clark",
                                         NumberOfLevels=1)
        flat.UpdatePipeline()
        self.assertEqual(tools.output(flat).GetNumberOfCells(), 4 * 16)

    def test_quadratic_cells(self):
        points = vtkPoints()
        for place in ((0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1),
                      (0, 1, 1)):
            points.InsertNextPoint(place)
        grid = vtkUnstructuredGrid()
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_QUADRATIC_TETRA, 10, range(10))
        cells = simple.TrivialProducer()
        cells.GetClientSideObject().SetOutput(grid)
        cells.UpdatePipeline()
        made = simple.MultidimensionalSubdivision(Input=cells, NumberOfLevels=0)
        for rule, pieces in (("Corners", 1), ("Pieces", 8)):
            made.QuadraticCells = rule
            with tools.quiet():
                made.UpdatePipeline()
            self.assertEqual(tools.output(made).GetNumberOfCells(), pieces)

    def test_a_cage_starts_a_deformation(self):
        ball = simple.Sphere(Radius=2.0)
        cage = simple.CageAround(Input=ball, NumberOfCells=[2, 3, 2], Margin=40.0)
        moved = simple.Calculator(Input=cage, CoordinateResults=1, Function="coords*2")
        bent = simple.SubdivisionDeformation(Input=ball, RestMesh=cage, DeformedMesh=moved)
        bent.UpdatePipeline()
        self.assertEqual(tools.output(cage).GetNumberOfCells(), 6 * 12)
        for i in range(6):
            self.assertAlmostEqual(tools.output(bent).GetBounds()[i], 2 * tools.output(ball).GetBounds()[i], 5)
        alone = simple.Cage(Bounds=[0, 1, 0, 2, 0, 3], Margin=0.0)
        alone.UpdatePipeline()
        self.assertEqual(tools.output(alone).GetBounds(), (0, 1, 0, 2, 0, 3))


if __name__ == "__main__":
    tools.main()
