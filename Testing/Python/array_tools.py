# SPDX-License-Identifier: BSD-3-Clause
"""What NumPy has as arrays of the functions: taken as it is, or refused by name. The same with plain VTK and with
ParaView."""

import copy
import types
import unittest
import warnings

import numpy as np

import subdivisionobjects
from subdivisionobjects import meshes

TET = np.array([[0., 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
CELL = [[0, 1, 2, 3]]
CUBE = np.array([[x, y, z] for z in (0., 1) for y in (0, 1) for x in (0, 1)])
SQUARES = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
RING = np.array([[4, 5], [5, 7], [7, 6], [6, 4]])


def linear(**more):
    """A tetrahedron and its middles."""
    return subdivisionobjects.subdivide(TET, CELL, levels=1, scheme="linear", **more)


def through(values):
    """What becomes of values at the four points, where they stay what they are."""
    return linear(point_data={"values": values}).point_data["values"][:4]


def counts(mesh):
    return {name: len(rows) for name, rows in mesh.cells.items()} if isinstance(mesh.cells, dict) else len(mesh.cells)


class Foreign:
    """An array of another library."""

    def __init__(self, values, error=None):
        self.values, self.error = values, error

    def __array__(self, dtype=None, copy=None):
        if self.error:
            raise RuntimeError(self.error)
        return np.asarray(self.values, dtype)


class Exchanged:
    """An array of another library that only hands out its memory."""

    def __init__(self, values):
        self.values = values

    def __dlpack__(self, **options):
        return self.values.__dlpack__(**options)

    def __dlpack_device__(self):
        return self.values.__dlpack_device__()


class Values(unittest.TestCase):
    def test_numbers_of_any_kind_are_taken(self):
        plain = np.array([0., 1.5, -2, 300])
        locked = plain.copy()
        locked.flags.writeable = False
        for what, values in (("big-endian", plain.astype(">f8")), ("big-endian, single", plain.astype(">f4")),
                             ("big-endian, half", plain.astype(">f2")), ("half", plain.astype(np.float16)),
                             ("extended", plain.astype(np.longdouble)), ("steps", np.repeat(plain, 2)[::2]),
                             ("backwards", plain[::-1].copy()[::-1]), ("read-only", locked),
                             ("objects", plain.astype(object)), ("foreign", Foreign(plain)),
                             ("exchanged", Exchanged(plain)), ("masked", np.ma.array(plain)),
                             ("list", plain.tolist())):
            with self.subTest(what):
                np.testing.assert_array_equal(through(values), plain)
        for dtype in (">i2", ">i4", "<u8", ">u8", "i1"):
            with self.subTest(dtype):
                self.assertEqual(list(through(np.array([1, 2, 3, 100], dtype))), [1, 2, 3, 100])
        rows = np.arange(12.).reshape(4, 3)
        np.testing.assert_array_equal(through(np.asfortranarray(rows)), rows)

    def test_points_and_cells_of_any_kind_are_taken(self):
        expected = linear()
        for points, cells in ((TET.astype(">f8"), np.array(CELL, ">i4")), (np.asfortranarray(TET), np.uint64(CELL)),
                              (TET.astype(object), np.array(CELL, object)), (Foreign(TET), Foreign(CELL)),
                              (TET.astype(np.longdouble), np.array(CELL, np.int8)), (TET.astype(int), CELL)):
            made = subdivisionobjects.subdivide(points, cells, levels=1, scheme="linear")
            np.testing.assert_array_equal(made.points, expected.points)
            np.testing.assert_array_equal(made.cells, expected.cells)

    def test_masked_values_are_missing(self):
        values = through(np.ma.array([1., 2, 3, 4], mask=[0, 1, 0, 0]))
        self.assertEqual(list(np.isnan(values)), [False, True, False, False])
        self.assertEqual(list(through(np.ma.array([1, 2, 3, 4], mask=False))), [1, 2, 3, 4])
        self.assertEqual(list(np.isnan(through([1, None, 2.5, 3]))), [False, True, False, False])

    def test_tensors_and_truth_values_stay_what_they_are(self):
        tensors = np.arange(36.).reshape(4, 3, 3)
        made = linear(point_data={"stress": tensors}, cell_data={"inside": [True], "strain": tensors[:1]})
        self.assertEqual(made.point_data["stress"].shape, (10, 3, 3))
        np.testing.assert_array_equal(made.point_data["stress"][:4], tensors)
        self.assertEqual((made.cell_data["inside"].dtype, made.cell_data["inside"].all()), (bool, True))
        self.assertEqual(made.cell_data["strain"].shape, (8, 3, 3))
        again = subdivisionobjects.subdivide(made, levels=1, scheme="linear")
        self.assertEqual(again.point_data["stress"].shape[1:], (3, 3))
        self.assertEqual(again.cell_data["inside"].dtype, bool)

    def test_texts(self):
        for values in (list("abcd"), np.array(list("abcd")), np.array(list("abcd"), object), np.array(list("abcd"), "S")):
            self.assertEqual(list(through(values)), list("abcd"))
        made = linear(cell_data={"material": ["steel"]}, point_data={"pair": [["a", "\u00e9"]] * 4})
        self.assertEqual(set(made.cell_data["material"]), {"steel"})
        self.assertEqual(made.point_data["pair"].shape, (10, 2))
        self.assertEqual(set(made.point_data["pair"][:, 1]), {"\u00e9"})

    def test_what_is_not_taken_is_refused_by_name(self):
        for text, values in (("complex numbers.*real", np.zeros(4, complex)), ("records", np.zeros(4, [("a", float)])),
                             ("dates", np.zeros(4, "M8[s]")), ("spans of time", np.zeros(4, "m8[s]")),
                             ("single value 5: .* 4 points", 5), ("single value 'abcd'", "abcd"), ("is None", None),
                             ("a mask.*int64.*filled", np.ma.array([1, 2, 3, 4], mask=[0, 1, 0, 0])),
                             ("too large", np.array([1, 2, 3, 10**30], object)),
                             ("too large", np.full(4, 1e300, np.longdouble)**2 if np.finfo(np.longdouble).max > 1e308
                              else np.array([1, 2, 3, 10**30], object)),
                             ("NoneType, str", ["a", None, "b", "c"]), ("no text of UTF-8", [b"\xff"] * 4),
                             ("3 values, but there are 4 points", [1, 2, 3]), ("0 values", []),
                             ("rows without values", np.zeros((4, 0))), ("cannot become", [[1], [1, 2], [1], [1]]),
                             ("use detach", Foreign(None, "use detach")), ("dict", {"a": 1})):
            with self.subTest(text), warnings.catch_warnings():
                warnings.simplefilter("error")
                with self.assertRaisesRegex(ValueError, "(?s)the array 'wrong'.*" + text):
                    linear(point_data={"wrong": values})
        with self.assertRaisesRegex(ValueError, "'wrong' has 2 values, but there are 1 cells"):
            linear(cell_data={"wrong": [1, 2]})
        with self.assertRaisesRegex(ValueError, "point_data is a dictionary"):
            linear(point_data=[TET])
        for text, points in (("points has complex", TET.astype(complex)), ("points must be numbers", TET.astype(str)),
                             ("points must be numbers", TET.T)):
            with self.assertRaisesRegex(ValueError, text):
                subdivisionobjects.subdivide(points, CELL)

    def test_labels(self):
        for labels in (np.ones((2, 2, 2), ">i2"), np.ones((2, 2, 2), bool), np.ones((2, 2, 2), np.float16)):
            made = subdivisionobjects.label_solid(labels, number_of_control_cells=0, levels=0)
            self.assertEqual(set(made.cell_data["Label"]), {1})
        masked = np.ma.array(np.ones((2, 2, 2), int), mask=np.zeros((2, 2, 2), bool))
        masked[0, 0, 0] = np.ma.masked
        with self.assertRaisesRegex(ValueError, "labels has missing values"):
            subdivisionobjects.label_solid(masked)


class Cells(unittest.TestCase):
    def refuses(self, text, cells, points=np.zeros((12, 3)), function=subdivisionobjects.subdivide):
        with self.subTest(text), self.assertRaisesRegex(ValueError, text):
            function(points, cells)

    def test_rows_of_four(self):
        quads = subdivisionobjects.surface_subdivision(CUBE, SQUARES, scheme="catmull-clark")
        expected = subdivisionobjects.surface_subdivision(CUBE, {"quad": SQUARES}, scheme="catmull-clark")
        np.testing.assert_array_equal(quads.points, expected.points)
        self.assertEqual(counts(subdivisionobjects.subdivide(CUBE, [[0, 1, 2, 4]], levels=1)), 8)
        solids = subdivisionobjects.subdivide(TET, CELL, levels=1)
        with self.assertWarnsRegex(Warning, "8 cell.s. are solids.* takes their outside, 16 face"):
            self.assertEqual(counts(subdivisionobjects.surface_subdivision(solids, levels=1)), 64)

    def test_rows_that_may_be_many_cells(self):
        self.refuses(r"'tetra': rows\[:, :4\].*TetGen.*'tetra': rows\[:, 1:\].*'pyramid': rows", [[0, 1, 2, 3, 9]])
        self.refuses(r"'quad': rows\[:, :4\]", [[0, 1, 2, 3, 9]], function=subdivisionobjects.surface_subdivision)
        self.refuses(r"begins with its number of points: give rows\[:, 1:\] for cells 'tetra'",
                     [[4, 0, 1, 2, 3], [4, 3, 2, 1, 4]])
        self.refuses("for cells 'quad'", [[4, 0, 1, 2, 3], [4, 3, 2, 1, 4]],
                     function=subdivisionobjects.surface_subdivision)
        self.refuses("for cells 'triangle'", [[3, 0, 1, 2], [3, 1, 2, 3]])
        self.refuses("for cells 'line'", [[2, 0, 1], [2, 1, 2]])
        self.refuses(r"give rows\[:, 1:\]", [[3, 0, 1, 2]], TET[:3])
        self.refuses(r"reshape\(-1, 5\)", [4, 0, 1, 2, 3])
        self.refuses(r"cell_data: give rows\[:, :4\]", {"tetra": [[0, 1, 2, 3, 9]]})
        self.refuses(r"its number of points, give rows\[:, 1:\]", {"tetra": [[4, 0, 1, 2, 3]]})
        star = subdivisionobjects.subdivide(CUBE, [[3, 0, 1, 2], [3, 0, 1, 4]], levels=1)  # are tetrahedra
        self.assertEqual(counts(star), 16)

    def test_ids(self):
        self.refuses("counted from 0: where they begin with 1, give rows - 1", [[1, 2, 3, 4]], TET)
        self.refuses(r"tetra 1 has point ids \[0, 1, 2, -1\]", [[0, 1, 2, 3], [0, 1, 2, -1]])
        self.refuses(r"give rows.astype\(int\)", [[0., 1, 2, 3]])
        self.refuses("of bool", np.ones((1, 4), bool))
        self.refuses("there are no cells", {"tetra": np.zeros((0, 4), int)})
        self.refuses("there are no cells", {})

    def test_other_cells(self):
        for cells, expected in (({10: CELL}, 8), ([("tetra", CELL), ("line", [[0, 1]])], {"line": 2, "tetra": 8}),
                                ({"polygon": [[0, 1, 2], [0, 1, 3, 2]]}, {"triangle": 4, "quad": 4}),
                                ({"polygon": [[0, 1, 3, 2]]}, {"quad": 4})):
            self.assertEqual(counts(subdivisionobjects.subdivide(TET, cells, levels=1)), expected)
        middles = np.vstack([TET, [(TET[a] + TET[b]) / 2 for a, b in
                                   ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))]])
        pieces = subdivisionobjects.subdivide(middles, {"tetra10": [range(10)]}, levels=0, quadratic_cells="pieces")
        self.assertEqual(counts(pieces), 8)

    def test_meshes_of_meshio(self):
        mesh = types.SimpleNamespace(
            points=TET, point_data={"T": np.arange(4.)}, cell_data={"region": [np.array([5]), np.array([6, 7])]},
            cells=[types.SimpleNamespace(type="tetra", data=np.array(CELL)),
                   types.SimpleNamespace(type="triangle", data=np.array([[0, 1, 2], [0, 1, 3]]))])
        made = subdivisionobjects.subdivide(mesh, levels=1)
        self.assertEqual(counts(made), {"tetra": 8, "triangle": 8})
        self.assertEqual(made.cell_data["region"].tolist(), 4 * [6] + 4 * [7] + 8 * [5])
        self.assertEqual(made.point_data["T"].shape, (10,))
        mesh.cell_sets = {"some": [[0], []]}
        with self.assertWarnsRegex(UserWarning, "cell_sets of the mesh are left out") as told:
            subdivisionobjects.subdivide(mesh)
        self.assertEqual(told.filename, __file__)

    def test_values_by_types(self):
        cells = {"tetra": CELL, "line": [[0, 1]]}
        made = subdivisionobjects.subdivide(TET, cells, levels=0, cell_data={"id": {"line": [2], "tetra": [1]}})
        self.assertEqual(list(made.cell_data["id"]), [2, 1])
        with self.assertRaisesRegex(ValueError, "'id' has no values for the cells 'line'"):
            subdivisionobjects.subdivide(TET, cells, cell_data={"id": {"tetra": [1]}})


class Chosen(unittest.TestCase):
    def test_masks_are_masks(self):
        mesh = subdivisionobjects.subdivide(TET, CELL, levels=2)
        mask = np.zeros(len(mesh.cells), bool)
        mask[[3, 40]] = True

        def refined(**chosen):
            return counts(subdivisionobjects.red_green_refinement(mesh, refine="selection", maximum_level=1,
                                                                  selection=chosen))

        self.assertEqual(refined(cells=mask), refined(cells=[3, 40]))
        self.assertEqual(refined(cells=mask.tolist()), refined(cells=[3, 40]))
        self.assertNotEqual(refined(cells=mask), refined(cells=[0, 1]))
        of_points = np.arange(len(mesh.points)) == 2
        self.assertEqual(refined(points=of_points), refined(points=[2]))
        for text, chosen in (("selection: .* mask of the shape .63,., but there are 64 cells", {"cells": mask[1:]}),
                             (r"\(64, 1\)", {"cells": mask[:, None]}), ("35 points", {"points": mask}),
                             ("must have integers", {"cells": [0.5]}), ("the id 64: ", {"cells": [64]}),
                             ("the id -1: ", {"points": [-1]})):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                refined(**chosen)
        ship = subdivisionobjects.model(model="Ship")
        with self.assertRaisesRegex(ValueError, "is a mask, which needs"):
            subdivisionobjects.subdivide([ship], mark_selection={"points": of_points})

    def test_masks_mark_points(self):
        mask = np.array([True, False, False, True])
        marked = subdivisionobjects.subdivide(TET, CELL, mark_selection={"points": mask})
        expected = subdivisionobjects.subdivide(TET, CELL, mark_selection={"points": [0, 3]})
        np.testing.assert_array_equal(marked.points, expected.points)

    def test_truth_values_are_no_numbers(self):
        for name in ("maximum_cells", "levels", "feature_angle", "scheme"):
            with self.subTest(name), self.assertRaisesRegex(ValueError, "not True"):
                subdivisionobjects.subdivide(TET, CELL, **{name: True})
        made = subdivisionobjects.vtkMultiDimensionalSubdivision()
        made.SetInputDataObject(meshes.to_vtk(TET, CELL))
        for text, cells, parameters in (("cells must have integers, not bool", [True], [[.1, .1, .1]]),
                                        ("cells must have integers, not float64", [0.], [[.1, .1, .1]]),
                                        ("parameters has complex", [0], [[.1j, 0, 0]])):
            with self.assertRaisesRegex(ValueError, text):
                subdivisionobjects.evaluate_limit(made, cells, parameters)

    def test_creases(self):
        def smooth(**more):
            return subdivisionobjects.surface_subdivision(CUBE, SQUARES, scheme="catmull-clark", levels=2, **more).points

        ring = meshes.to_vtk(CUBE, {"line": RING}, None, {"Sharpness": [1.5] * 4})
        expected = smooth(crease_geometry=ring)
        self.assertGreater(np.abs(expected - smooth()).max(), 0.01)
        for creases in (np.column_stack([RING, [1.5] * 4]), (RING, 1.5), (RING, [1.5] * 4),
                        {tuple(pair): 1.5 for pair in RING}, [[*pair, 1.5] for pair in RING.tolist()]):
            np.testing.assert_array_equal(smooth(creases=creases), expected)
        forever = smooth(crease_geometry=meshes.to_vtk(CUBE, {"line": RING}))
        np.testing.assert_array_equal(smooth(creases=RING), forever)
        np.testing.assert_array_equal(smooth(creases=(RING, np.inf)), forever)
        # Points at the same place are told apart.
        twice = subdivisionobjects.surface_subdivision(
            np.vstack([CUBE, CUBE]), np.vstack([SQUARES, SQUARES + 8]), scheme="catmull-clark", creases=RING + 8)
        once = subdivisionobjects.surface_subdivision(CUBE, SQUARES, scheme="catmull-clark")
        np.testing.assert_array_equal(twice.points[:8], once.points[:8])
        self.assertGreater(np.abs(twice.points[8:16] - once.points[:8]).max(), 0.01)
        for text, wrong in (("the id 99", [[0, 99]]), ("of bool", np.ones((4, 2), bool)), ("0 or more", [[0, 1, -1.]]),
                            ("whole numbers", [[.5, 1, 1]]), (r"shape \(4, 4\)", np.ones((4, 4)))):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                smooth(creases=wrong)
        with self.assertRaisesRegex(ValueError, "not both"):
            smooth(creases=RING, crease_geometry=ring)

    def test_texture_coordinates_by_name(self):
        given = {"uv": CUBE[:, :2], "many": np.zeros((8, 5))}
        made = subdivisionobjects.surface_subdivision(CUBE, SQUARES, point_data=given, texture_coordinates="uv")
        self.assertEqual(made.attributes["texture_coordinates"], "uv")
        again = copy.deepcopy(subdivisionobjects.surface_subdivision(made))
        self.assertEqual(again.attributes["texture_coordinates"], "uv")
        mesh = meshes.to_vtk(CUBE, {"quad": SQUARES}, given)
        output = subdivisionobjects.surface_subdivision(mesh, texture_coordinates="uv")
        self.assertEqual(output.GetPointData().GetTCoords().GetName(), "uv")
        self.assertIsNone(mesh.GetPointData().GetTCoords())
        for text, more in (("texture_coordinates is the name.*'UV'; did you mean uv", {"texture_coordinates": "UV"}),
                           ("'many' cannot be texture_coordinates: it has 5", {"texture_coordinates": "many"}),
                           ("'uv' cannot be normals", {"normals": "uv"})):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                subdivisionobjects.surface_subdivision(CUBE, SQUARES, point_data=given, **more)


class Results(unittest.TestCase):
    def test_field_data_come_out(self):
        made = subdivisionobjects.simplicial_complex_topology(TET, CELL)
        self.assertEqual(made.field_data["EulerCharacteristic"], [1])
        materials = {"Label": [1], "Name": ["bone"], "Density": [1.5]}
        bone = subdivisionobjects.label_solid(np.ones((2, 2, 2), int), materials=materials, number_of_control_cells=0,
                                              levels=0)
        self.assertEqual(list(bone.field_data["Name"]), ["bone"])
        self.assertEqual(set(bone.cell_data["Density"]), {1.5})
        self.assertEqual(list(copy.copy(bone).field_data["Name"]), ["bone"])

    def test_functions_in_a_row_are_one(self):
        once = subdivisionobjects.subdivide(TET, CELL, levels=1, point_data={"T": [1., 2, 3, 4]})
        twice = subdivisionobjects.subdivide(TET, CELL, levels=2, point_data={"T": [1., 2, 3, 4]})
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            again = subdivisionobjects.subdivide(once, levels=1)
            mixed = subdivisionobjects.subdivide(TET, {"tetra": CELL, "line": [[0, 1]]}, levels=1)
            self.assertEqual(counts(subdivisionobjects.subdivide(mixed, levels=1)), {"line": 4, "tetra": 64})
        self.assertIn("Subdivision", once.field_data)
        self.assertNotIn("Subdivision", mixed.field_data)  # cells come out in another order
        np.testing.assert_array_equal(again.points, twice.points)
        np.testing.assert_array_equal(again.cells, twice.cells)
        np.testing.assert_array_equal(again.point_data["T"], twice.point_data["T"])
        with self.assertRaisesRegex(TypeError, "cells of its own"):
            subdivisionobjects.subdivide(once, CELL)
        more = subdivisionobjects.subdivide(once, levels=0, cell_data={"id": np.arange(8)})
        self.assertEqual(list(more.cell_data["id"]), list(range(8)))

    def test_nothing_left_is_an_error(self):
        for text, call in (
                ("coordinates are infinite or not a number", lambda: subdivisionobjects.subdivide(TET * np.nan, CELL)),
                ("repeated point ids", lambda: subdivisionobjects.subdivide(TET, [[0, 1, 2, 2]])),
                ("the background", lambda: subdivisionobjects.label_solid(np.zeros((3, 3, 3), int)))):
            with self.subTest(text), self.assertWarns(Warning):
                with self.assertRaisesRegex(RuntimeError, "nothing is left of the input: .*" + text):
                    call()
        for dimensions in ("Lines", ["Lines"], 1):
            self.assertEqual(counts(subdivisionobjects.subdivide(TET, CELL, dimensions=dimensions)), {})

    def test_nearest_names_are_told(self):
        for error, text, call in (
                (TypeError, "no argument 'levles'; did you mean levels", lambda: linear(levles=2)),
                (TypeError, "no argument 'merge_point'; did you mean merge_points", lambda: linear(merge_point=True)),
                (ValueError, "not 'linaer'; did you mean Linear",
                 lambda: subdivisionobjects.subdivide(TET, CELL, scheme="linaer")),
                (ValueError, "'curvture'.*did you mean curvature",
                 lambda: subdivisionobjects.red_green_refinement(TET, CELL, refine="curvture"))):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                call()

    def test_messages_name_arguments(self):
        for text, more in (("'Nowhere' .singular_array. is not there".replace("'", '"'), {"singular_array": "Nowhere"}),
                           ("preserve_interfaces needs .*: set material_array", {"preserve_interfaces": True}),
                           ("number_of_levels = 20 .* maximum_number_of_cells = 9", {"levels": 20, "maximum_cells": 9})):
            with self.subTest(text), self.assertRaisesRegex(RuntimeError, text):
                subdivisionobjects.subdivide(TET, CELL, **more)
        with self.assertWarnsRegex(UserWarning, "cell 1, type 10, tetra. with a point"):
            subdivisionobjects.subdivide(np.vstack([TET, [[np.nan] * 3]]), [[0, 1, 2, 3], [1, 2, 3, 4]])
        with self.assertRaisesRegex(RuntimeError, "deformed_mesh is missing; .* cage_around, deformed_mesh the same"):
            subdivisionobjects.deformation(TET)
        with self.assertRaisesRegex(ValueError, r"rest_mesh: tetra 0 has point ids \[0, 1, 2, 9\]"):
            subdivisionobjects.deformation(TET, rest_mesh=(TET, [[0, 1, 2, 9]]))
