# SPDX-License-Identifier: BSD-3-Clause
"""Plain VTK: the package offers every class, and filters in a row are one filter, bit for bit."""

import pathlib
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy

import subdivisionobjects
from subdivisionobjects import vtkMultiDimensionalSubdivision, vtkSubdivisionModelSource

HEADERS = pathlib.Path(__file__).resolve().parents[2] / "Filters"


def subdivided(port, levels):
    subdivision = vtkMultiDimensionalSubdivision()
    subdivision.SetInputConnection(port)
    subdivision.SetNumberOfLevels(levels)
    subdivision.GenerateClassificationOn()
    subdivision.GenerateOriginalIdsOn()
    subdivision.Update()
    return subdivision


class Chain(unittest.TestCase):
    def test_every_class(self):
        for header in HEADERS.glob("vtk*.h"):
            self.assertTrue(hasattr(subdivisionobjects, header.stem), header.stem)

    def test_chain_is_one(self):
        for model in range(vtkSubdivisionModelSource.NUMBER_OF_MODELS):
            source = vtkSubdivisionModelSource()
            source.SetModel(model)
            with self.subTest(source.GetModelAsString()):
                one = subdivided(source.GetOutputPort(), 3)
                row = [subdivided(source.GetOutputPort(), 0)]
                for _ in range(3):
                    row.append(subdivided(row[-1].GetOutputPort(), 1))
                self.assert_equal(one.GetOutput(), row[-1].GetOutput())

    def assert_equal(self, a, b):
        pairs = [(a.GetPoints().GetData(), b.GetPoints().GetData()),
                 (a.GetCells().GetConnectivityArray(), b.GetCells().GetConnectivityArray())]
        for get in ("GetPointData", "GetCellData"):
            ours, theirs = getattr(a, get)(), getattr(b, get)()
            self.assertEqual(ours.GetNumberOfArrays(), theirs.GetNumberOfArrays())
            for i in range(ours.GetNumberOfArrays()):
                pairs.append((ours.GetArray(i), theirs.GetArray(ours.GetArrayName(i))))
        for ours, theirs in pairs:
            self.assertEqual(vtk_to_numpy(ours).tobytes(), vtk_to_numpy(theirs).tobytes(), ours.GetName())


if __name__ == "__main__":
    unittest.main(verbosity=2)
