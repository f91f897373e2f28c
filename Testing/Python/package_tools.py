# SPDX-License-Identifier: BSD-3-Clause
"""Measures by a function, and what the package is: tests that are the same with plain VTK and with ParaView."""

import pathlib
import sys
import types
import unittest
import unittest.mock

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

import subdivisionobjects
from function_tools import TET


class Measures(unittest.TestCase):
    def test_gradients_of_measures_go_uphill(self):
        """A step along the derivatives makes a volume and an integral larger by their squares."""
        points = TET * [1, 2, 3]
        given = {"maximum_level": 3, "tolerance": 0, "density_array": "Density"}

        def measured(moved, heat):
            found = subdivisionobjects.measures(moved, [[0, 1, 2, 3]], point_data={
                "Density": np.arange(4.) + 1, "Heat": heat}, **given)
            return found["Measure"][0], found["HeatIntegral"][0]

        heat = np.array([1., -2., 0., 3.])
        made = subdivisionobjects.measure_gradients(points, [[0, 1, 2, 3]], row=0, point_data={
            "Density": np.arange(4.) + 1, "Heat": heat}, **given)
        self.assertEqual({name: values.shape for name, values in made.items() if "Heat" not in name}, {
            "MeasureByPoints": (4, 3), "MassByPoints": (4, 3), "MassByDensity": (4,), "DensityIntegralByPoints": (4, 3),
            "DensityIntegralByValues": (4,), "DensityIntegralByDensity": (4,)})
        step = 1e-5
        for number, by_points, by_values in ((0, "MeasureByPoints", None), (1, "HeatIntegralByPoints", "HeatIntegralByValues")):
            ways = made[by_points], made[by_values] if by_values else np.zeros(4)
            high, low = (measured(points + sign * step * ways[0], heat + sign * step * ways[1])[number] for sign in (1, -1))
            self.assertAlmostEqual((high - low) / (2 * step), sum((way ** 2).sum() for way in ways), 7)
        with self.assertRaisesRegex(RuntimeError, "no row 7"):
            subdivisionobjects.measure_gradients(points, [[0, 1, 2, 3]], row=7)

    def test_measures_are_a_dictionary_of_arrays(self):
        points = np.array(TET, float)
        found = subdivisionobjects.measures(points, [[0, 1, 2, 3]], point_data={"Density": points[:, 0] + 1},
                                            density_array="Density", scheme="linear")
        self.assertEqual(found["Dimension"].tolist(), [3])
        self.assertEqual(found["Centroid"].shape, (1, 3))
        volume = abs(np.linalg.det(points[1:] - points[0])) / 6
        np.testing.assert_allclose(found["Measure"], [volume], rtol=1e-12)
        np.testing.assert_allclose(found["Mass"], [volume * (points[:, 0].mean() + 1)], rtol=1e-12)
        self.assertLess(found["MassRemainder"][0], 1e-12)


class Package(unittest.TestCase):
    def test_version_and_types(self):
        self.assertRegex(subdivisionobjects.__version__, r"\A\d+\.\d+\.\d+\Z")
        self.assertTrue((pathlib.Path(subdivisionobjects.__file__).parent / "py.typed").exists())


class PyVista(unittest.TestCase):
    def test_its_meshes_are_wrapped_again(self):
        """With what stands for PyVista here: its classes derive from those of VTK, and `wrap` makes them."""
        class Grid(vtkUnstructuredGrid):
            __module__ = "pyvista.core.pointset"

        def wrap(mesh):
            made = Grid()
            made.ShallowCopy(mesh)
            return made

        mesh = wrap(subdivisionobjects.model(model="Ship"))
        stand_in = types.ModuleType("pyvista")
        stand_in.wrap = wrap
        with unittest.mock.patch.dict(sys.modules, pyvista=stand_in):
            made = subdivisionobjects.subdivide(mesh)
        self.assertIs(type(made), Grid)
        self.assertGreater(made.GetNumberOfCells(), mesh.GetNumberOfCells())

    def test_meshes_stay_what_they_are(self):
        try:
            import pyvista
        except ImportError:
            self.skipTest("skipped: there is no PyVista")
        grid = pyvista.UnstructuredGrid(subdivisionobjects.model(model="Ship"))
        made = subdivisionobjects.subdivide(grid, levels=1)
        self.assertIs(type(made), pyvista.UnstructuredGrid)
        self.assertGreater(made.n_cells, grid.n_cells)
        surface = subdivisionobjects.surface_subdivision(pyvista.Cube().clean(), levels=1)
        self.assertIs(type(surface), pyvista.PolyData)
        blocks = subdivisionobjects.subdivide(pyvista.MultiBlock([grid]), levels=1)
        self.assertIs(type(blocks), pyvista.MultiBlock)
