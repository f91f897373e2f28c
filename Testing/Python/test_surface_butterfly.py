# SPDX-License-Identifier: BSD-3-Clause
"""Modified Butterfly (Mathematics 12): the spectrum of one step around inner and boundary vertices."""

import unittest

import numpy as np
import tools
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from subdivisionobjects import vtkSurfaceSubdivision

RINGS = 4


class Wheel:
    """Triangles in rings around vertex 0: k sectors, closed or not."""

    def __init__(self, k, closed):
        self.k = k
        self.closed = closed
        self.places = [(0, 0)]
        self.ids = {}
        for r in range(1, RINGS + 1):
            for i in range(r * k + (0 if closed else 1)):
                self.ids[r, i] = len(self.places)
                self.places.append((r, i))
        self.triangles = []
        for s in range(k):
            for r in range(1, RINGS + 1):
                for j in range(r):
                    inner, outer = s * (r - 1) + j, s * r + j
                    self.triangles.append((self.find(r - 1, inner), self.find(r, outer), self.find(r, outer + 1)))
                    if j < r - 1:
                        self.triangles.append(
                            (self.find(r - 1, inner), self.find(r, outer + 1), self.find(r - 1, inner + 1)))

    def find(self, r, i):
        if r == 0:
            return 0
        return self.ids[r, i % (r * self.k)] if self.closed else self.ids[r, i]

    def step(self):
        """One step as a matrix, and the new vertex of each edge."""
        size = len(self.places)
        points = vtkPoints()
        points.SetDataTypeToDouble()
        for r, i in self.places:
            points.InsertNextPoint(r, i, 0)
        cells = vtkCellArray()
        for triangle in self.triangles:
            cells.InsertNextCell(3)
            for v in triangle:
                cells.InsertCellPoint(v)
        mesh = vtkPolyData()
        mesh.SetPoints(points)
        mesh.SetPolys(cells)
        unit = vtkDoubleArray()
        unit.SetName("unit")
        unit.SetNumberOfComponents(size)
        unit.SetNumberOfTuples(size)
        vtk_to_numpy(unit)[:] = np.eye(size)
        mesh.GetPointData().AddArray(unit)
        subdivision = vtkSurfaceSubdivision()
        subdivision.SetInputData(mesh)
        subdivision.SetSchemeToModifiedButterfly()
        subdivision.Update()
        output = subdivision.GetOutput()
        children = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        middles = {}
        for f, triangle in enumerate(self.triangles):
            for q in range(3):
                child = next(list(c) for c in children[4 * f:4 * f + 3] if triangle[q] in c)
                at = child.index(triangle[q])
                for side in (1, 2):
                    middles[frozenset((triangle[q], triangle[(q + side) % 3]))] = child[(at + side) % 3]
        return vtk_to_numpy(output.GetPointData().GetArray("unit")), middles

    def eigenvalues(self):
        """Of the step from three rings to the three rings of half the size."""
        matrix, middles = self.step()
        assert abs(matrix.sum(1) - 1).max() < 1e-12
        rows, columns = [], []
        for v, (r, i) in enumerate(self.places):
            if r == RINGS:
                continue
            columns.append(v)
            s, w = divmod(i, r) if r else (0, 0)
            if r and i == r * self.k:
                s, w = self.k - 1, r
            u = r - w
            ends = {self.find((u + a + w + b) // 2, s * ((u + a + w + b) // 2) + (w + b) // 2)
                    for a, b in ((u % 2, -(w % 2)), (-(u % 2), w % 2))}
            rows.append(middles[frozenset(ends)] if len(ends) == 2 else ends.pop())
        assert np.all(np.delete(matrix[rows], columns, 1) == 0)
        return sorted(abs(np.linalg.eigvals(matrix[np.ix_(rows, columns)])), reverse=True)


class Spectrum(unittest.TestCase):
    def check(self, k, closed):
        values = Wheel(k, closed).eigenvalues()
        np.testing.assert_allclose(values[:3], [1, 0.5, 0.5], atol=1e-6)
        self.assertLess(values[3], 0.2501)

    def test_interior(self):
        for k in range(3, 13):
            with self.subTest(valence=k):
                self.check(k, True)

    def test_boundary(self):
        for k in range(1, 9):
            with self.subTest(faces=k):
                self.check(k, False)


if __name__ == "__main__":
    tools.main()
