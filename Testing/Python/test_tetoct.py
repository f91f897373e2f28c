# SPDX-License-Identifier: BSD-3-Clause
"""The tet/oct scheme in ParaView: the property, octahedra in the output, filters in a row."""

import unittest

import numpy as np
import tools
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def subdivide(source, levels, scheme="Tet/Oct"):
    proxy = simple.MultidimensionalSubdivision(
        Input=source, NumberOfLevels=levels, VolumeScheme=scheme)
    proxy.UpdatePipeline()
    return proxy


class TetOct(unittest.TestCase):
    def test_octahedra(self):
        model = simple.SubdivisionModel(Model="MaterialBlock")
        model.UpdatePipeline()
        tets = sum(tools.output(model).GetCellType(i) == 10
                   for i in range(tools.output(model).GetNumberOfCells()))
        grid = tools.output(subdivide(model, 2))
        self.assertEqual(grid.GetNumberOfCells(), tools.cells_after(tools.output(model), 2))
        ids = vtk_to_numpy(grid.GetCellData().GetArray("OctahedronId"))
        numbers, pieces = np.unique(ids[ids >= 0], return_counts=True)
        self.assertEqual(len(numbers), 10 * tets)
        self.assertTrue((pieces == 4).all())
        self.assertFalse(
            tools.output(subdivide(model, 2, "Box Spline")).GetCellData().HasArray("OctahedronId"))

    def test_in_a_row(self):
        model = simple.SubdivisionModel(Model="MixedDimensions")
        three = tools.output(subdivide(model, 3))
        row = tools.output(subdivide(subdivide(subdivide(model, 1), 1), 1))
        self.assertEqual(tools.numbers(three), tools.numbers(row))
        self.assertTrue(np.array_equal(vtk_to_numpy(three.GetCells().GetConnectivityArray()),
                                       vtk_to_numpy(row.GetCells().GetConnectivityArray())))


if __name__ == "__main__":
    tools.main()
