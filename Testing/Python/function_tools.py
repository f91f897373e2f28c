# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the package: tests that are the same with plain VTK and with ParaView."""

import copy
import pickle
import unittest
import warnings

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkSphere, vtkUnstructuredGrid)

import subdivisionobjects
from subdivisionobjects import functions, meshes
from subdivisionobjects.run import FILTERS

TET = np.array([[0., 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
CUBE = np.array([[x, y, z] for z in (0., 1) for y in (0, 1) for x in (0, 1)])
SQUARES = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])


def filtered(cls, mesh, **options):
    made = cls()
    made.SetInputDataObject(0, mesh)
    for name, value in options.items():
        getattr(made, "Set" + name)(value)
    made.Update()
    return made.GetOutputDataObject(0)


def coordinates(mesh):
    return numpy_support.vtk_to_numpy(mesh.GetPoints().GetData())


def other(option):
    """A value that is not the default."""
    default = option.default
    if option.kind == "enum":
        return next(text for text in option.entries if text != default)
    if option.kind == "set":
        return (next(text for text in option.entries if (text,) != tuple(default)),)
    if option.kind in ("mesh", "selection", "table"):
        return {"mesh": (TET, [[0, 1, 2, 3]]), "selection": {"points": [1]}, "table": {"Label": [1]}}[option.kind]
    if option.kind == "bool":
        return not default
    if option.kind == "strings":
        return ("SomeName",)
    if option.kind == "array":
        return "SomeName"
    if option.kind == "function":
        return vtkSphere()
    if isinstance(default, tuple):
        return tuple(value + 1 for value in default)
    return (default / 2 or 0.05) if isinstance(default, float) else default - 1 or 2


def state(made):
    """What the filter prints, without what is other in each, and its inputs and arrays."""
    return [line for line in str(made).splitlines() if "0x" not in line and "Modified Time" not in line] + \
        [made.GetNumberOfInputConnections(port) for port in range(made.GetNumberOfInputPorts())]


class Matrices(unittest.TestCase):
    """What a filter does to points, by NumPy, and by SciPy where it is installed."""

    def for_filters(self, check):
        """Calls a function with filters that have run, and with their points before and after."""
        tet = meshes.to_vtk(TET, {"tetra": [[0, 1, 2, 3]], "line": [[3, 0]]})
        cube = meshes.to_vtk(CUBE, {"quad": SQUARES})
        for cls, mesh, options in (
                ("MultiDimensionalSubdivision", tet, {"NumberOfLevels": 3}),
                ("MultiDimensionalSubdivision", tet, {"NumberOfLevels": 2, "VolumeScheme": 1, "ProjectToLimit": True}),
                ("SurfaceSubdivision", cube, {"NumberOfLevels": 3, "Scheme": 2}),
                ("SurfaceSubdivision", cube, {"NumberOfLevels": 0, "Scheme": 2, "ProjectToLimit": True}),
                ("SurfaceSubdivision", cube, {"NumberOfLevels": 2, "Scheme": 3})):
            with self.subTest(f"{cls}, {options}"):
                made = getattr(subdivisionobjects, "vtk" + cls)()
                made.SetInputDataObject(mesh)
                for name, value in options.items():
                    getattr(made, "Set" + name)(value)
                made.Update()
                check(made, coordinates(made.GetInputDataObject(0, 0)), coordinates(made.GetOutputDataObject(0)))

    def test_matrices_multiply_to_the_output(self):
        def check(made, before, after):
            matrix = subdivisionobjects.operator_matrix(made)
            self.assertEqual(matrix.number_of_columns, len(before))
            np.testing.assert_allclose(matrix.multiply(before), after, rtol=0, atol=1e-14)
            values = before
            for factor in subdivisionobjects.operator_factors(made):
                values = factor.multiply(values)
            np.testing.assert_array_equal(values, after)

        self.for_filters(check)

    def test_scipy_multiplies_to_the_output(self):
        try:
            import scipy.sparse
        except ImportError:
            self.skipTest("skipped: there is no SciPy")

        def check(made, before, after):
            matrix = subdivisionobjects.operator_matrix(made).to_scipy()
            self.assertTrue(scipy.sparse.isspmatrix_csr(matrix))
            self.assertEqual(matrix.shape, (len(after), len(before)))
            np.testing.assert_allclose(matrix @ before, after, rtol=0, atol=1e-14)
            np.testing.assert_allclose(matrix.sum(axis=1), 1, rtol=0, atol=1e-14)
            values = before
            for factor in subdivisionobjects.operator_factors(made):
                values = factor.to_scipy() @ values
            np.testing.assert_array_equal(values, after)

        self.for_filters(check)

    def test_errors(self):
        made = subdivisionobjects.vtkMultiDimensionalSubdivision()
        with self.assertRaisesRegex(RuntimeError, "the input is missing"):
            subdivisionobjects.operator_matrix(made)
        made.SetInputDataObject(meshes.to_vtk(TET, [[0, 1, 2, 3]]))
        matrix = subdivisionobjects.operator_matrix(made)
        with self.assertRaisesRegex(ValueError, "4 values"):
            matrix.multiply([1., 2.])


class Limits(unittest.TestCase):
    def test_places(self):
        made = self.filter_of(meshes.to_vtk(TET, {"line": [[0, 1], [1, 2]]}, {"T": TET[:, 0] + 2 * TET[:, 1]}))
        at = subdivisionobjects.evaluate_limit(made, [0, 1], [[1], [0]])
        np.testing.assert_allclose(at.points, [(TET[0] + 4 * TET[1] + TET[2]) / 6] * 2, rtol=0, atol=1e-15)
        np.testing.assert_allclose(at.point_data["DerivativeU"], [(TET[2] - TET[0]) / 2] * 2, rtol=0, atol=1e-14)
        np.testing.assert_allclose(at.point_data["T"], at.points @ [1, 2, 0], rtol=0, atol=1e-15)

    def test_places_of_surfaces(self):
        """The limit of a quad alone is bilinear."""
        points = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 1], [0, 1, 0]], float)
        made = subdivisionobjects.vtkSurfaceSubdivision()
        made.SetInputDataObject(meshes.to_vtk(points, {"quad": [[0, 1, 2, 3]]}))
        made.SetSchemeToCatmullClark()
        at = subdivisionobjects.evaluate_limit(made, [0, 0], [[0.25, 0.5], [1, 1]])
        np.testing.assert_allclose(at.points, [[0.5, 0.5, 0.125], [2, 1, 1]], rtol=0, atol=1e-14)
        np.testing.assert_allclose(at.point_data["DerivativeU"], [[2, 0, 0.5], [2, 0, 1]], rtol=0, atol=1e-14)

    def test_probe(self):
        """The middle of a curve is nearest to points on its normal."""
        line = meshes.to_vtk(TET, {"line": [[0, 1], [1, 2]]}, {"T": TET[:, 0] + 2 * TET[:, 1]})
        middle = (TET[0] + 4 * TET[1] + TET[2]) / 6
        normal = np.array([1., 0, 0])
        found = subdivisionobjects.limit_probe(line, places=middle + 0.1 * np.array([normal, -normal, 0 * normal]))
        points = coordinates(found)
        np.testing.assert_allclose(points, [middle] * 3, rtol=0, atol=1e-12)
        data = meshes.data_arrays(found.GetPointData())
        np.testing.assert_allclose(data["Distance"], [0.1, 0.1, 0], rtol=0, atol=1e-12)
        np.testing.assert_allclose(data["T"], points @ [1, 2, 0], rtol=0, atol=1e-12)
        at = subdivisionobjects.evaluate_limit(self.filter_of(line), data["CellId"], data["CellParameters"])
        np.testing.assert_allclose(at.points, points, rtol=0, atol=1e-14)

    def test_probe_in_hexahedra(self):
        """They are not cut: a place inside has the parameters of VTK."""
        corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1.]])
        mesh = meshes.to_vtk(corners, {"hexahedron": [range(8)]})
        at = [[0.2, 0.4, 0.7], [0.5, 0.5, 0.5]]
        places = subdivisionobjects.evaluate_limit(self.filter_of(mesh), [0, 0], at).points
        found = subdivisionobjects.limit_probe(mesh, scheme="Automatic", places=np.vstack([places, [[0.5, 0.5, 5]]]))
        data = meshes.data_arrays(found.GetPointData())
        np.testing.assert_allclose(data["CellParameters"], at + [[0.5, 0.5, 1]], rtol=0, atol=1e-9)
        np.testing.assert_allclose(data["Distance"][:2], 0, rtol=0, atol=1e-12)
        self.assertGreater(data["Distance"][2], 4)

    def test_smoothness(self):
        """A point with four neighbours inside a solid fails by one scheme, and its four cells are refined for that."""
        points = [[0, 0, 0], [1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]
        mesh = meshes.to_vtk(np.array(points, float), [[0, 1, 2, 3], [0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4]])
        smooth = subdivisionobjects.smoothness(mesh, sample_maps=False)
        failing = meshes.data_arrays(smooth.GetPointData())["Failing"]
        self.assertEqual(failing[0], 1)
        values = meshes.data_arrays(smooth.GetCellData())["Eigenvalues"][0]
        np.testing.assert_allclose(values[:5], [1, 1 / 4, 3 / 16, 3 / 16, 3 / 16], rtol=0, atol=1e-9)
        mesh.GetPointData().AddArray(smooth.GetPointData().GetArray("Failing"))
        finer = subdivisionobjects.red_green_refinement(mesh, refine={"array_range": (1, 1)}, range_array="Failing",
                                                        maximum_level=1)
        self.assertEqual(finer.GetNumberOfCells(), 32)
        other = subdivisionobjects.smoothness(mesh, scheme="Tet/Oct", failing_only=True)
        self.assertEqual(other.GetNumberOfCells(), 0)

    @staticmethod
    def loop_step(n, k=None):
        """Loop's step around a vertex of n triangles; with k on a boundary with k triangles, by the plain rule."""
        size = n if k is None else k + 1
        matrix = np.zeros((1 + size, 1 + size))
        for j in range(size):
            near = [1 + (j - 1) % size, 1 + (j + 1) % size]
            if k is not None and j in (0, k):
                matrix[1 + j, [0, 1 + j]] = 1 / 2
                continue
            matrix[1 + j, [0, 1 + j]] = 3 / 8
            matrix[1 + j, near] += 1 / 8
        ring = [1, size] if k is not None else list(range(1, size + 1))
        matrix[0, ring] = 1 / 8 if k is not None else (3 / 16 if n == 3 else 3 / 8 / n)
        matrix[0, 0] = 1 - matrix[0].sum()
        return matrix

    def test_smoothness_of_a_matrix(self):
        for n, curvature in ((3, "bounded"), (4, "unbounded"), (5, "unbounded"), (6, "bounded"), (7, "unbounded")):
            with self.subTest(n):
                faces = [[0, 1 + j, 1 + (j + 1) % n] for j in range(n)]
                found = subdivisionobjects.smoothness(self.loop_step(n), faces=faces)
                waves = [3 / 8 + np.cos(2 * np.pi * m / n) / 4 for m in range(1, n)]
                centre = 5 / 8 - n * self.loop_step(n)[0, 1]
                np.testing.assert_allclose(found.eigenvalues, sorted([1, centre] + waves, reverse=True), atol=1e-9)
                self.assertEqual((found.condition, found.curvature, found.regular), (True, curvature, True))
                np.testing.assert_allclose(found.limit, [2 / 5] + [1 / 5] * 3 if n == 3 else [1 / 2] + [1 / 2 / n] * n)
                turned = subdivisionobjects.smoothness(self.loop_step(n), faces=[faces[0], faces[1][::-1]])
                self.assertFalse(turned.regular)
        for k in range(2, 10):  # Mathematics 12: the plain rule is smooth for up to five triangles
            found = subdivisionobjects.smoothness(self.loop_step(0, k), curves=1)
            self.assertEqual(found.condition, k < 6)
            self.assertEqual(found.map is None, k >= 6)
        one = subdivisionobjects.smoothness(np.diag([1.0] * 4) / 2 + 1 / 8, dimension=1)
        self.assertFalse(one.condition)

    def test_matrices_that_are_no_steps(self):
        wrong = self.loop_step(6)
        wrong[3, 0] = 0.5
        with self.assertRaisesRegex(ValueError, "row 3 sums to 1.125, not to 1: it may read points"):
            subdivisionobjects.smoothness(wrong)
        wrong[2, 0] = np.nan
        with self.assertRaisesRegex(ValueError, "row 2 has numbers that are not finite"):
            subdivisionobjects.smoothness(wrong)
        with self.assertRaisesRegex(ValueError, "dimension must be 1 to 3, not 4"):
            subdivisionobjects.smoothness(self.loop_step(6), dimension=4)
        with self.assertRaisesRegex(ValueError, "rows of 3 numbers of points"):
            subdivisionobjects.smoothness(self.loop_step(6), faces=[[0, 1]])

    @staticmethod
    def filter_of(mesh):
        made = subdivisionobjects.vtkMultiDimensionalSubdivision()
        made.SetInputDataObject(mesh)
        return made

    def test_errors(self):
        made = self.filter_of(meshes.to_vtk(TET, [[0, 1, 2, 3]]))
        with self.assertRaisesRegex(RuntimeError, "no such cell"):
            subdivisionobjects.evaluate_limit(made, [1], [[0.1, 0.1, 0.1]])
        with self.assertRaisesRegex(ValueError, "the shapes"):
            subdivisionobjects.evaluate_limit(made, [0, 0], [[0.1, 0.1, 0.1]])


# Functions of filters in which Loop's scheme moves no points.
UNWEIGHTED = ("adaptive_surface_subdivision", "simplicial_complex_topology")


class Options(unittest.TestCase):
    def test_every_option_reaches_its_filter(self):
        count = 0
        for name, one in FILTERS.items():
            for key, option in one.options.items():
                with self.subTest(f"{name}, {key}"):
                    made = getattr(subdivisionobjects, one.cls)()
                    before = state(made)
                    option.apply(made, key, other(option))
                    if option.kind == "array":
                        array = made.GetInputArrayInformation(option.index)
                        self.assertIn("SomeName", str(array))
                    else:
                        self.assertNotEqual(before, state(made))
                    count += 1
        self.assertGreater(count, 250)

    def test_every_option_of_the_classes(self):
        self.assertEqual(list(FILTERS), functions.__all__)
        for name, one in FILTERS.items():
            cls = getattr(subdivisionobjects, one.cls)
            commands = {option.command for option in one.options.values()}
            ours = {member for base in cls.__mro__ if base.__name__ in vars(subdivisionobjects) for member in vars(base)
                    if member.startswith("Set") and "Get" + member[3:] in vars(base)} - {"SetController"}
            missing = ours - commands - {"SetOutputDimensions"}
            without = {"SetLoopWeights", "SetModifiedBoundary"} & missing if name in UNWEIGHTED else set()
            if name in ("measures", "sample"):  # no mesh, which has levels, points and cells
                without |= {"SetNumberOfLevels", "SetProjectToLimit", "SetGenerateLimitNormals", "SetGenerateTangents", "SetSmoothShading",
                            "SetGenerateErrorBounds", "SetGenerateClassification", "SetOutputCells", "SetCellOrder",
                            "SetBezierTolerance",
                            "SetCacheOperator", "SetUse32BitIds", "SetOutputPointsPrecision"}
            self.assertLessEqual(missing - without, {
                "SetEmbeddedCells", "SetInterpolateIntegers", "SetGenerateOriginalIds", "SetGenerateGlobalIds",
                "SetInterpolatePoints", "SetInterpolateArrays", "SetInterpolationWeight", "SetBounds", "SetHug",
                "SetInterfaceValues"}, name)

    def test_wrong_values(self):
        cells = [[0, 1, 2, 3]]
        for error, text, options in (
                (TypeError, "levles", {"levles": 3}),
                (ValueError, "volume_scheme is one of .*'Linear'", {"scheme": "tetrahedral"}),
                (ValueError, "the nearest is 20", {"levels": 21}),
                (RuntimeError, "maximum_number_of_cells = 10", {"levels": 3, "maximum_cells": 10})):
            with self.assertRaisesRegex(error, text):
                subdivisionobjects.subdivide(TET, cells, **options)
        for text, wrong in (("tetra 0 has point ids", [[0, 1, 2, 4]]),
                            ("not rows of several sizes; .* 'line': rows", [[0, 1, 2, 3], [0, 1]]),
                            ("rows of 3 integers", {"triangle": [[0, 1]]}),
                            ("no cells 'brick'", {"brick": [[0]]}), ("not the shape", [0, 1, 2])):
            with self.assertRaisesRegex(ValueError, text):
                subdivisionobjects.subdivide(TET, wrong)

    def test_arrays_of_numpy_as_values(self):
        expected = subdivisionobjects.cage(bounds=[0, 1, 0, 2, 0, 3], number_of_cells=[1, 2, 3])
        made = subdivisionobjects.cage(bounds=np.array([0, 1, 0, 2, 0, 3.]), number_of_cells=np.array([1, 2, 3]))
        np.testing.assert_array_equal(coordinates(made), coordinates(expected))
        fine = subdivisionobjects.subdivide(
            TET, [[0, 1, 2, 3]], levels=np.int64(2), maximum_cells=np.array(100), detect_features=np.bool_(True),
            output_dimensions=np.array(["Tetrahedra"]), scheme=np.array("linear"))
        self.assertEqual(fine.cells.shape, (64, 4))
        ship = subdivisionobjects.model(model="Ship")
        longest = subdivisionobjects.red_green_refinement(ship, refine={"edge_length": np.array([.5])})
        expected = subdivisionobjects.red_green_refinement(ship, refine={"edge_length": .5})
        np.testing.assert_array_equal(coordinates(longest), coordinates(expected))

    def test_wrong_values_name_their_option(self):
        for text, options in (
                ("number_of_levels takes a whole number, not 'many'", {"levels": "many"}),
                ("number_of_levels takes a whole number, not 1.5", {"levels": 1.5}),
                ("number_of_levels takes a whole number, not .1, 2.", {"levels": (1, 2)}),
                ("number_of_levels=.* is out of range", {"levels": 2**70}),
                ("join_blocks is True or False, not 'off'", {"join_blocks": "off"}),
                ("join_blocks is True or False, not 2", {"join_blocks": 2}),
                ("output_dimensions is one of .*'Tetrahedra'.*, not 3.5", {"dimensions": 3.5}),
                ("feature_angle takes a number, not '30'", {"feature_angle": "30"}),
                ("feature_angle takes a number, not nan", {"feature_angle": np.nan}),
                ("material_array is the name of an array, not", {"material_array": np.array([1, 2, 3])}),
                (r"not a selection such as", {"mark_selection": [1]})):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                subdivisionobjects.subdivide(TET, [[0, 1, 2, 3]], **options)
        with self.assertRaisesRegex(FileNotFoundError, "there is no file 'mesh.vtu'"):
            subdivisionobjects.subdivide("mesh.vtu")
        with self.assertRaisesRegex(ValueError, "is not a table such as"):
            subdivisionobjects.label_solid(np.ones((1, 1, 1), int), materials=[1])

    def test_each_number_of_several_is_checked(self):
        for text, cells in ((r"number_of_cells=.0, -2, 2. is out of range; the nearest is .1, 1, 2.", (0, -2, 2)),
                            ("number_of_cells takes 3 whole numbers, not .1, 2.", (1, 2)),
                            ("number_of_cells takes 3 whole numbers, not 2", 2),
                            ("number_of_cells takes 3 whole numbers, not .1.0, 2.0, 3.5.", np.array([1, 2, 3.5]))):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                subdivisionobjects.cage(number_of_cells=cells)

    def test_lists_of_criteria_are_refused(self):
        ship = subdivisionobjects.model(model="Ship")
        for wrong in (["curvature"], np.array(["curvature"]), 3):
            with self.assertRaisesRegex(ValueError, "refine is the name .* not .*; the criteria are .*edge_length"):
                subdivisionobjects.red_green_refinement(ship, refine=wrong)

    def test_warnings(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            subdivisionobjects.surface_subdivision(TET, {"tetra": [[0, 1, 2, 3]], "triangle": [[0, 1, 2]]})
        self.assertEqual(len(told), 1)
        self.assertTrue(str(told[0].message).startswith("1 cell(s) are solids"), str(told[0].message))
        self.assertEqual(told[0].filename, __file__)


class Meshes(unittest.TestCase):
    def test_arrays(self):
        points, cells = subdivisionobjects.subdivide(TET, [[0, 1, 2, 3]], levels=2)
        self.assertEqual((points.shape, cells.shape), ((35, 3), (64, 4)))
        linear = subdivisionobjects.subdivide((TET, [[0, 1, 2, 3]]), number_of_levels=2, scheme="linear")
        self.assertEqual(linear.points.max(), 1)
        self.assertLess(points.max(), 1)

    def test_arrays_and_data(self):
        made = subdivisionobjects.subdivide(
            TET.astype(np.float32), {"tetra": [[0, 1, 2, 3]], "line": np.array([[0, 1]])}, levels=1,
            point_data={"T": [1., 2, 3, 4]}, cell_data={"id": [7, 8]})
        self.assertEqual(made.points.dtype, np.float32)
        self.assertEqual({name: len(rows) for name, rows in made.cells.items()}, {"line": 2, "tetra": 8})
        self.assertEqual(list(made.cell_data["id"]), [8, 8] + 8 * [7])
        self.assertEqual(made.point_data["T"].shape, (10,))
        half = subdivisionobjects.subdivide(TET, [[0, 1, 2, 3]], point_data={"T": np.ones(4, np.float16)})
        self.assertEqual(half.point_data["T"].dtype, np.float32)
        again = subdivisionobjects.subdivide(made, levels=1)
        self.assertEqual(len(again.cells["tetra"]), 64)

    def test_surfaces(self):
        made = subdivisionobjects.surface_subdivision(CUBE, {"quad": SQUARES}, scheme="catmull-clark", levels=2)
        self.assertEqual((made.points.shape, made.cells["quad"].shape), ((98, 3), (96, 4)))

    def test_quads_and_polygons_go_in_again(self):
        for scheme in ("catmull-clark", "doo-sabin"):
            once = subdivisionobjects.surface_subdivision(CUBE, {"quad": SQUARES}, scheme=scheme, levels=1)
            points, cells = subdivisionobjects.surface_subdivision(*once, scheme=scheme, levels=0)
            np.testing.assert_array_equal(points, once.points)
            self.assertEqual(set(cells), set(once.cells))

    def test_bezier_cells_have_names(self):
        """They come out by their names, and go in again: as the linear cells at their corners."""
        cube = subdivisionobjects.surface_subdivision(CUBE, {"quad": SQUARES}, scheme="catmull-clark", levels=0,
                                                      output_cells="bezier")
        self.assertEqual(set(cube.cells), {"bezier_quad"})
        self.assertEqual(cube.cells["bezier_quad"].shape, (6, 16))
        with self.assertWarns(Warning):
            again = subdivisionobjects.surface_subdivision(cube, scheme="catmull-clark", levels=1)
        self.assertEqual(len(again.cells["quad"]), 24)

    def test_polygons_are_input_again(self):
        """Doo-Sabin makes a triangle of each corner of a cube, and of a prism with five sides two pentagons."""
        cube = subdivisionobjects.surface_subdivision(CUBE, {"quad": SQUARES}, scheme="DooSabin")
        self.assertEqual({name: len(rows) for name, rows in cube.cells.items()}, {"quad": 18, "triangle": 8})
        turn = 2 * np.pi * np.arange(5) / 5
        ring = np.column_stack([np.cos(turn), np.sin(turn)])
        points = np.vstack([np.column_stack([ring, np.full(5, z)]) for z in (0, 1)])
        side = np.arange(5)
        cells = {"polygon5": [side[::-1], side + 5],
                 "quad": np.column_stack([side, (side + 1) % 5, (side + 1) % 5 + 5, side + 5])}
        once = subdivisionobjects.surface_subdivision(points, cells, scheme="DooSabin")
        self.assertEqual(once.cells["polygon5"].shape, (2, 5))
        again = subdivisionobjects.surface_subdivision(once, scheme="DooSabin")
        twice = subdivisionobjects.surface_subdivision(points, cells, scheme="DooSabin", levels=2)
        self.assertEqual({name: len(rows) for name, rows in again.cells.items()},
                         {name: len(rows) for name, rows in twice.cells.items()})
        np.testing.assert_allclose(np.sort(again.points, axis=0), np.sort(twice.points, axis=0), atol=1e-12)
        for name in ("polygon2", "polygon", "polygons5"):
            with self.assertRaisesRegex(ValueError, f"no cells '{name}'.*such as polygon5"):
                subdivisionobjects.surface_subdivision(points, {name: [[0, 1]]})

    def test_copies(self):
        made = subdivisionobjects.subdivide(TET, [[0, 1, 2, 3]], point_data={"T": [1., 2, 3, 4]}, cell_data={"id": [7]})
        copies = [copy.copy(made), copy.deepcopy(made)]
        copies += [pickle.loads(pickle.dumps(made, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
        for other_one in copies:
            self.assertIsInstance(other_one, subdivisionobjects.Arrays)
            points, cells = other_one
            self.assertIs(points, other_one.points)
            self.assertIs(cells, other_one.cells)
            np.testing.assert_array_equal(points, made.points)
            np.testing.assert_array_equal(cells, made.cells)
            np.testing.assert_array_equal(other_one.point_data["T"], made.point_data["T"])
            np.testing.assert_array_equal(other_one.cell_data["id"], made.cell_data["id"])
        self.assertIsNot(copies[1].points, made.points)

    def test_labels(self):
        """Axes are x, y, z: a box of 2 x 3 x 5 voxels, of which the last one along z is of another material."""
        labels = np.ones((2, 3, 5), np.uint8)
        labels[:, :, 4] = 2
        options = {"number_of_control_cells": 0, "number_of_smoothing_steps": 0, "levels": 0}
        made = subdivisionobjects.label_solid(labels, spacing=(2, 1, .5), origin=np.array([10, 20, 30]), **options)
        np.testing.assert_allclose(made.points.min(axis=0), [9, 19.5, 29.75], atol=.1)
        np.testing.assert_allclose(made.points.max(axis=0), [13, 22.5, 32.25], atol=.1)
        self.assertEqual(made.cells.shape, (6 * labels.size, 4))
        upper = made.points[made.cells[made.cell_data["Label"] == 2]]
        self.assertGreater(upper.reshape(-1, 3)[:, 2].min(), 31.6)
        plain = subdivisionobjects.label_solid(labels.T, **options)
        np.testing.assert_allclose(np.ptp(plain.points, axis=0), [5, 3, 2], atol=.2)
        for error, text, array, more in (
                (ValueError, r"array \[x, y, z\], not the shape \(2, 3\)", labels[:, :, 0], {}),
                (ValueError, r"not the shape \(0, 3, 5\)", labels[:0], {}),
                (ValueError, "spacing takes 3 finite numbers", labels, {"spacing": 1}),
                (ValueError, "spacing must be above 0", labels, {"spacing": (1, 0, 1)}),
                (ValueError, "origin takes 3 finite numbers", labels, {"origin": (1, 0, np.nan)}),
                (TypeError, "spacing and an origin of its own", vtkImageData(), {"spacing": (1, 1, 1)})):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                subdivisionobjects.label_solid(array, **more)
        self.assertIn("labels[i, j, k]", subdivisionobjects.label_solid.__doc__)

    def test_data_sets(self):
        ship = subdivisionobjects.model(model="Ship")
        self.assertIsInstance(ship, vtkUnstructuredGrid)
        made = subdivisionobjects.subdivide(ship, levels=2)
        expected = filtered(subdivisionobjects.vtkMultiDimensionalSubdivision, ship, NumberOfLevels=2)
        np.testing.assert_array_equal(coordinates(made), coordinates(expected))

    def test_blocks(self):
        ship = subdivisionobjects.model(model="Ship")
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, ship)
        made = subdivisionobjects.subdivide(blocks, levels=1)
        self.assertIsInstance(made, vtkMultiBlockDataSet)
        parts = subdivisionobjects.subdivide([ship, ship], levels=1, join_blocks=False)
        self.assertEqual([part.GetNumberOfCells() for part in parts], 2 * [made.GetBlock(0).GetNumberOfCells()])

    def test_refinement(self):
        ship = subdivisionobjects.model(model="Ship")
        made = subdivisionobjects.red_green_refinement(ship, refine={"edge_length": 0.5}, placement="limit")
        expected = filtered(subdivisionobjects.vtkRedGreenRefinement, ship, RefineByEdgeLength=1, MaximumEdgeLength=0.5,
                            RefineByAttributeError=0, RefineByGeometricError=0, Placement=1)
        np.testing.assert_array_equal(coordinates(made), coordinates(expected))
        sphere = vtkSphere()
        sphere.SetRadius(1)
        inside = subdivisionobjects.red_green_refinement(ship, refine="function", implicit_function=sphere)
        self.assertGreater(inside.GetNumberOfCells(), ship.GetNumberOfCells())
        chosen = subdivisionobjects.red_green_refinement(ship, refine="selection", selection={"cells": [3]},
                                                         maximum_level=1)
        self.assertGreater(chosen.GetNumberOfCells(), ship.GetNumberOfCells())
        with self.assertRaisesRegex(ValueError, "no criterion 'size'"):
            subdivisionobjects.red_green_refinement(ship, refine={"size": 1})

    def test_arrays_are_found_where_they_are(self):
        block = subdivisionobjects.model(model="MaterialBlock")
        made = subdivisionobjects.red_green_refinement(block, refine={"array_range": (0.5, 1.5)},
                                                       range_array="MaterialId", maximum_level=1)
        expected = subdivisionobjects.vtkRedGreenRefinement()
        expected.SetInputDataObject(block)
        expected.SetRefineByAttributeError(False)
        expected.SetRefineByGeometricError(False)
        expected.SetRefineByArrayRange(True)
        expected.SetArrayRange(0.5, 1.5)
        expected.SetInputArrayToProcess(6, 0, 0, 1, "MaterialId")
        expected.SetMaximumLevel(1)
        expected.Update()
        np.testing.assert_array_equal(coordinates(made), coordinates(expected.GetOutput()))

    def test_deformation(self):
        ball = np.random.default_rng(1).random((50, 3))
        cage = subdivisionobjects.cage()
        moved = vtkUnstructuredGrid()
        moved.DeepCopy(cage)
        coordinates(moved)[:] += [1, 2, 3]
        made = subdivisionobjects.deformation(ball, rest_mesh=cage, deformed_mesh=moved)
        np.testing.assert_allclose(made.points, ball + [1, 2, 3], atol=1e-12)

    def test_pipelines(self):
        source = subdivisionobjects.vtkSubdivisionModelSource()
        self.assertGreater(subdivisionobjects.subdivide(source).GetNumberOfCells(), 0)

    def test_surface_output(self):
        squares = meshes.to_vtk(CUBE, {"quad": SQUARES})
        self.assertIsInstance(subdivisionobjects.surface_subdivision(squares), vtkPolyData)
