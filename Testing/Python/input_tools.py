# SPDX-License-Identifier: BSD-3-Clause
"""What Python users give wrongly, or in forms that are easily lost: it is taken as it is meant, or refused in their
words. The same with plain VTK and with ParaView."""

import types
import unittest
import warnings

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkTable, vtkUnstructuredGrid

import subdivisionobjects
from subdivisionobjects import meshes

POINTS = np.array([[0., 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
TETS = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
TRIANGLES = np.array([[0, 1, 2], [1, 2, 3]])
MIXED = {"tetra": TETS, "line": [[0, 1]]}
BIG = 2**53 + 1  # the least whole number that double precision has not


def of_cells(values, cells=TETS):
    """What becomes of values of cells, in the order of the filter: lines come before tetrahedra."""
    return subdivisionobjects.subdivide(POINTS, cells, levels=0, cell_data={"id": values}).cell_data["id"]


class Refusals(unittest.TestCase):
    def refuses(self, text, call, error=ValueError):
        with self.subTest(text), self.assertRaisesRegex(error, text) as found:
            call()
        return str(getattr(found, "exception", ""))


class Texts(Refusals):
    def test_texts_that_are_no_utf_8(self):
        """VTK would end the process."""
        bad = b"caf\xe9".decode("utf-8", "surrogateescape")
        for call in (lambda: of_cells(["a", bad]), lambda: of_cells(np.array(["a", bad], object)),
                     lambda: of_cells({"tetra": ["a", bad]}),
                     lambda: subdivisionobjects.subdivide(POINTS, TETS, point_data={"id": list("abcd") + [bad]})):
            self.refuses(r"'id'.* 'caf\\udce9', which UTF-8 cannot have: .*latin-1", call)
        self.refuses("materials: the array 'Name'", lambda: subdivisionobjects.label_solid(
            np.ones((2, 2, 2), int), materials={"Label": [1], "Name": [bad]}))
        self.refuses(r"name of an array has 'caf\\udce9'",
                     lambda: subdivisionobjects.subdivide(POINTS, TETS, point_data={bad: np.zeros(5)}))
        self.refuses(r"array 'a\\x00b' must have a text without zero bytes as its name",
                     lambda: subdivisionobjects.subdivide(POINTS, TETS, point_data={"a\0b": np.zeros(5)}))
        for name, value in (("material_array", bad), ("interpolated_arrays", [bad]), ("texture_coordinates", bad)):
            self.refuses(f"{name} has 'caf", lambda: subdivisionobjects.subdivide(POINTS, TETS, **{name: value}))

    def test_texts_beside_others(self):
        self.refuses("'id' has objects of Python .float, str.", lambda: of_cells(["a", np.nan]))
        self.refuses("'id' has objects of Python .int, str.", lambda: of_cells(["a", 1]))
        self.refuses("'id' has texts for some types of cells", lambda: of_cells([["a", "b"], [1]], MIXED))
        self.assertEqual(list(of_cells([b"a", "\u00e9"])), ["a", "\u00e9"])


class Blocks(Refusals):
    def test_values_by_types_have_their_lengths(self):
        self.refuses("'id' has 1 values for the cells 'tetra', of which there are 2",
                     lambda: of_cells({"tetra": [1], "line": [3, 4]}, MIXED))
        self.refuses("'id' has 1 values for the cells 'quad', of which there are 0",
                     lambda: of_cells({"tetra": [1, 2], "quad": [9]}))
        self.assertEqual(list(of_cells({"tetra": [1, 2], "quad": []})), [1, 2])
        self.assertEqual(of_cells({"tetra": [1, 2], "line": []}, {"tetra": TETS, "line": []}).dtype, int)

    def test_blocks_of_one_type_share_values(self):
        blocks = [("tetra", TETS[:1]), ("line", [[0, 1]]), ("tetra", TETS[1:])]
        self.assertEqual(list(of_cells({"tetra": [1, 2], "line": [3]}, blocks)), [3, 1, 2])
        self.refuses("'id' has 1 values for the cells 'tetra', of which there are 2",
                     lambda: of_cells({"tetra": [1], "line": [3]}, blocks))

    def test_lists_by_blocks(self):
        self.assertEqual(list(of_cells([[1, 2], [3]], MIXED)), [3, 1, 2])
        self.refuses("'id' has 1 values in block 0, which has 2 cells 'tetra'", lambda: of_cells([[1], [3, 4]], MIXED))
        self.refuses(r"'id' must have values of one shape for all cells, not the shapes \(2, 2\), \(1,\)",
                     lambda: of_cells([[[1, 2], [3, 4]], [5]], MIXED))
        self.refuses("'id' has missing values", lambda: of_cells([np.ma.array([1, 2], mask=[0, 1]), [3]], MIXED))

    def test_types_of_vtk(self):
        made = subdivisionobjects.subdivide(POINTS, [(10, TETS), (3, [[0, 1]])], levels=0,
                                            cell_data={"id": {"tetra": [1, 2], 3: [5]}})
        self.assertEqual(list(made.cell_data["id"]), [5, 1, 2])
        lines = subdivisionobjects.subdivide(POINTS, [(0, 1), (1, 2)], levels=0)
        self.assertEqual(lines.cells.shape, (2, 2))


class Digits(Refusals):
    def test_large_whole_numbers_stay(self):
        for values in ([2**63 + 1, 5], np.array([2**64 - 1, 5], object), [BIG, 1], [2**60, 1e300]):
            self.assertEqual([int(value) for value in of_cells(values)], [int(value) for value in values])
        parts = [np.array([7, 5], np.uint64), np.array([-BIG])]
        self.assertEqual(of_cells(parts, MIXED).tolist(), [-BIG, 7, 5])

    def test_lost_digits_are_told(self):
        for text, values, cells in (
                (f"'id' has the whole number {BIG} beside .* it would be {BIG - 1}", [BIG, None], TETS),
                (f"'id' has the whole number {BIG}", [BIG, .5], TETS),
                (f"'id' has the whole number {BIG}", [np.array([BIG, 1]), [.5]], MIXED),
                ("'id' .* too large: no type .* both -1 and 9223372036854775809", [2**63 + 1, -1], TETS),
                ("'id' .* too large", [np.array([2**64 - 1, 1], np.uint64), np.array([-1])], MIXED)):
            self.refuses(text, lambda: of_cells(values, cells))


class Forms(Refusals):
    def test_blocks_keep_their_forms(self):
        strains = np.arange(27.).reshape(3, 3, 3)
        made = subdivisionobjects.subdivide(POINTS, MIXED, levels=1, cell_data={
            "strain": [strains[:2], strains[2:]], "inside": [np.array([True, True]), np.array([False])],
            "objects": np.array([True, False, True], object)}, point_data={"one": np.ones((5, 1))})
        self.assertEqual(made.cell_data["strain"].shape, (18, 3, 3))
        np.testing.assert_array_equal(made.cell_data["strain"][0], strains[2])
        self.assertEqual(made.cell_data["inside"].tolist(), 2 * [False] + 16 * [True])
        self.assertEqual((made.cell_data["inside"].dtype, made.cell_data["objects"].dtype), (bool, bool))
        self.assertEqual(made.point_data["one"].shape[1:], (1,))

    def test_field_data_of_meshio(self):
        mesh = types.SimpleNamespace(points=POINTS, point_data={}, cell_data={}, cells=[("tetra", TETS)],
                                     field_data={"steel": np.array([1, 3]), "turn": np.zeros((2, 3, 3)), "is": [True]})
        made = subdivisionobjects.subdivide(mesh)
        self.assertEqual(made.field_data["steel"].tolist(), [1, 3])
        self.assertEqual((made.field_data["turn"].shape, made.field_data["is"].dtype), ((2, 3, 3), bool))
        mesh.field_data = {"steel": {"id": 3}}
        self.refuses("field_data: the array 'steel' has objects", lambda: subdivisionobjects.subdivide(mesh))

    def test_marks_of_hidden_cells_hide(self):
        for marks in (np.array([0, 32]), [0, 32], np.array([0, 32], np.uint8)):
            made = subdivisionobjects.subdivide(POINTS, TETS, levels=0, cell_data={"vtkGhostType": marks})
            self.assertEqual(len(made.cells), 1)
        for marks in ([0., 32], [0, 256], [-1, 0], [[0], [32]]):
            self.refuses("'vtkGhostType' marks what VTK hides: .* 0 to 255",
                         lambda: subdivisionobjects.subdivide(POINTS, TETS, cell_data={"vtkGhostType": marks}))

    def test_texts_are_no_texture(self):
        self.refuses("'name' cannot be texture_coordinates: it has no numbers", lambda: subdivisionobjects.subdivide(
            POINTS, TETS, point_data={"name": list("abcde")}, texture_coordinates="name"))


class Rows(Refusals):
    def test_rows_that_begin_with_their_size(self):
        rows = [[3, 0, 1, 2], [3, 1, 2, 4]]
        with self.assertWarnsRegex(UserWarning, r"all rows of cells begin with 3, .*'tetra' .*rows\[:, 1:\]") as told:
            subdivisionobjects.subdivide(POINTS, rows)
        self.assertEqual(told.filename, __file__)
        with self.assertWarnsRegex(UserWarning, "all rows of cells begin with 2, .*'triangle'"):
            subdivisionobjects.surface_subdivision(POINTS, [[2, 0, 1], [2, 1, 3]])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            subdivisionobjects.subdivide(POINTS, {"tetra": [[3, 0, 2, 1], [3, 1, 2, 4]]})
            subdivisionobjects.subdivide(POINTS, [[3, 0, 2, 1]])

    def test_cures_fit(self):
        for text, cells in ((r"give rows.astype\(int\)", [[0., 1, 2, 3]]),
                            ("NaN is the id of no point", [[0, 1, 2, np.nan]]),
                            ("there are no cells", []), ("there are no cells", np.zeros((0, 4))),
                            (r"missing points .a mask.: .*rows.mask.any\(axis=1\)", np.ma.array(TETS, mask=TETS == 4)),
                            ("no cells 'polygon' of 2 points: .*'line': rows", {"polygon": [[0, 1], [0, 1, 2]]})):
            found = self.refuses(text, lambda: subdivisionobjects.subdivide(POINTS, cells))
            self.assertEqual("astype" in found, "astype" in text)
        halves = self.refuses("4 integers", lambda: subdivisionobjects.subdivide(POINTS, [[0, 1, 2, .5]]))
        self.assertNotIn("astype", halves)

    def test_creases(self):
        for text, creases in (
                (r"the row \[1, 1\], from a point to itself", [[0, 1], [1, 1]]),
                (r"from pairs of point ids to sharpness, such as .*: 1 is no pair", {1: 1}),
                (r"creases has 2 rows, and sharpness of the shape \(3,\)", (np.array([[0, 1], [1, 2]]), [1, 2, 3])),
                ("creases cannot become", ([[0, 1], [1]], 1)), ("creases has no rows", np.zeros((0, 2), int))):
            self.refuses(text, lambda: subdivisionobjects.surface_subdivision(POINTS, TRIANGLES, creases=creases))


class Messages(Refusals):
    def test_meshes_of_wrong_types(self):
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        grid = meshes.to_vtk(POINTS, TETS)
        for text, call in (
                ("^mesh is a vtkImageData, but can only be vtkUnstructuredGrid.*vtkAppendFilter",
                 lambda: subdivisionobjects.extract_dimensions(image)),
                ("^mesh is a vtkTable, but", lambda: subdivisionobjects.subdivide(vtkTable())),
                ("^mesh is a vtkUnstructuredGrid, but can only be vtkImageData",
                 lambda: subdivisionobjects.label_solid(grid)),
                ("^rest_mesh is a vtkTable", lambda: subdivisionobjects.deformation(POINTS, rest_mesh=vtkTable()))):
            self.refuses(text, call, RuntimeError)
        for text, mesh in (("mesh is None", None),
                           (r"data sets of VTK only, but \[1\] is of the type NoneType", [grid, None]),
                           (r"\[0\] is of the type tuple", [(POINTS, TETS), (POINTS, TETS)])):
            self.refuses(text, lambda: subdivisionobjects.subdivide(mesh), TypeError)
        parts = subdivisionobjects.subdivide((grid, grid), levels=0, join_blocks=False)
        self.assertEqual([part.GetNumberOfCells() for part in parts], [2, 2])

    def test_arguments_by_two_names(self):
        self.refuses("levels and number_of_levels are the same",
                     lambda: subdivisionobjects.subdivide(POINTS, TETS, levels=2, number_of_levels=1))
        self.assertEqual(len(subdivisionobjects.subdivide(POINTS, TETS, levels=None, number_of_levels=2).cells), 128)

    def test_criteria_without_a_number(self):
        def refined(name, value):
            return lambda: subdivisionobjects.red_green_refinement(POINTS, TETS, refine={name: value})

        self.refuses("'selection' takes no number: .*selection=", refined("selection", {"cells": [0]}))
        self.refuses("'wanted_level' takes no number: .*wanted_level_array=", refined("wanted_level", .5))
        self.refuses("'wanted_level' takes no number", lambda: subdivisionobjects.adaptive_surface_subdivision(
            POINTS, TRIANGLES, refine={"wanted_level": 2}))

    def test_words_of_filters(self):
        with self.assertWarnsRegex(UserWarning, "Give selection={'cells': ids}"):
            subdivisionobjects.red_green_refinement(POINTS, TETS, refine="selection")
        with self.assertWarnsRegex(UserWarning, 'are solids.* outside, .*Use (subdivide|"Multi-dimensional Subdivision") to') as told:
            subdivisionobjects.surface_subdivision(POINTS, {"tetra": TETS, "triangle": TRIANGLES})
        self.assertNotIn("vtk", str(told.warning))
        for text, call in (
                ("coordinates of the mesh, or make margin smaller",
                 lambda: subdivisionobjects.cage_around(np.vstack([POINTS, [np.inf, 0, 0]]), TETS)),
                ("Give points, or bounds to the function cage",
                 lambda: subdivisionobjects.cage_around(vtkUnstructuredGrid())),
                ("Raise margin, or give bounds", lambda: subdivisionobjects.cage_around(POINTS[:2], margin=0.)),
                ("ascending order, or make margin smaller",
                 lambda: subdivisionobjects.cage(bounds=(1, 0, 0, 1, 0, 1)))):
            self.refuses(text, call, RuntimeError)
