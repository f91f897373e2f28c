# SPDX-License-Identifier: BSD-3-Clause
"""Python as people write it: ten tasks in three lines each, help on one screen, types, results and files. The same with
plain VTK and with ParaView."""

import ast
import importlib.util
import os
import pathlib
import pydoc
import re
import sys
import tempfile
import textwrap
import types
import unittest
import unittest.mock
import warnings

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

import subdivisionobjects
from subdivisionobjects import Arrays, functions, meshes
from subdivisionobjects.run import FILTERS, OF_IMAGES, OF_MESHES, Option

POINTS = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
TETS = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
CUBE = np.array([[x, y, z] for z in (0.0, 1) for y in (0, 1) for x in (0, 1)])
QUADS = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
# What fits on a screen.
LINES, COLUMNS = 40, 100


def grid(count):
    """Points and hexahedra of a cube of `count` cells along each side."""
    side = np.arange(count + 1)
    ids = np.arange((count + 1) ** 3).reshape(count + 1, count + 1, count + 1)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    rows = [ids[i : count + i, j : count + j, k : count + k].ravel() for i, j, k in corners]
    points = np.stack(np.meshgrid(side, side, side, indexing="ij"), axis=-1).reshape(-1, 3)
    return points.astype(float), {"hexahedron": np.column_stack(rows)}


class InFolder(unittest.TestCase):
    """In a folder of its own, where mesh.vtu is."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder.name)
        subdivisionobjects.subdivide(POINTS, TETS, levels=0, point_data={"T": POINTS[:, 0]}).save("mesh.vtu")


class Tasks(InFolder):
    def do(self, text, **names):
        """Runs lines as who writes a script has them; three are enough."""
        lines = textwrap.dedent(text).strip()
        self.assertLessEqual(len(lines.splitlines()), 3)
        names = {**vars(subdivisionobjects), "points": POINTS, "tetrahedra": TETS, "T": POINTS[:, 0], **names}
        exec(compile(lines, "task", "exec"), names)
        return types.SimpleNamespace(**{name: names[name] for name in names if name.isidentifier()})

    def test_from_a_file_to_a_file(self):
        self.do('subdivide("mesh.vtu", levels=2).save("fine.vtu")')
        fine = subdivisionobjects.subdivide("fine.vtu", levels=0)
        self.assertEqual((fine.cells.shape, fine.point_data["T"].shape), ((128, 4), (len(fine.points),)))

    def test_from_arrays_to_arrays(self):
        done = self.do("fine_points, fine_cells = subdivide(points, tetrahedra, levels=3)")
        self.assertEqual((done.fine_points.shape[1], done.fine_cells.shape), (3, (1024, 4)))

    def test_a_time_series(self):
        steps = [POINTS[:, 0] * time for time in range(3)]
        done = self.do(
            """
            smooth = Subdivider(points, tetrahedra, levels=2)
            for step, values in enumerate(steps):
                smooth.apply({"T": values}).save(f"step{step}.vtu")
            """,
            steps=steps,
        )
        for step in range(3):
            saved = subdivisionobjects.subdivide(f"step{step}.vtu", levels=0).point_data["T"]
            np.testing.assert_allclose(saved, done.smooth.points[:, 0] * step, rtol=0, atol=1e-14)

    def test_the_limit_at_places(self):
        done = self.do(
            """
            places = [[0.25, 0.25, 0.25], [0, 0, 1]]
            at = evaluate_limit((points, tetrahedra), [0, 1], places, point_data={"T": T})
            values, slopes = at.point_data["T"], at.point_data["DerivativeU"]
            """
        )
        np.testing.assert_allclose(done.values, done.at.points[:, 0], rtol=0, atol=1e-14)
        self.assertEqual(done.slopes.shape, (2, 3))

    def test_detail_by_an_array(self):
        done = self.do(
            """
            data = {"T": T**9, "other": T}
            where = {"refine": {"attribute_error": 0.1}, "attribute_array": "T", "maximum_level": 2}
            finer = red_green_refinement(points, tetrahedra, point_data=data, **where)
            """
        )
        steps = np.abs(np.diff(done.finer.point_data["T"][done.finer.cells], axis=1))
        self.assertGreater(len(done.finer.cells), 50)
        self.assertLessEqual(steps.max(), 0.25)

    def test_creases(self):
        done = self.do(
            """
            ring = [[4, 5], [5, 7], [7, 6], [6, 4]]
            can = surface_subdivision(cube, quads, scheme="catmull-clark", levels=3, creases=ring)
            """,
            cube=CUBE,
            quads=QUADS,
        )
        self.assertEqual(done.can.points[:, 2].max(), 1)
        self.assertLess(0.02, done.can.points[:, 2].min())

    def test_a_volume_with_materials(self):
        done = self.do(
            """
            materials = {"MaterialId": [1, 2]}
            solid = subdivide(points, tetrahedra, levels=2, cell_data=materials, preserve_interfaces=True)
            steel = solid.cells[solid.cell_data["MaterialId"] == 1]
            """
        )
        self.assertEqual(done.steel.shape, (64, 4))
        shared = np.intersect1d(done.steel, done.solid.cells[done.solid.cell_data["MaterialId"] == 2])
        self.assertEqual(len(shared), 15)

    def test_from_labels_to_a_solid(self):
        labels = np.zeros((6, 5, 4), np.uint8)
        labels[1:5, 1:4, 1:3] = 7
        self.do('label_solid(labels, spacing=(0.5, 0.5, 1.2)).save("solid.vtu")', labels=labels)
        solid = subdivisionobjects.subdivide("solid.vtu", levels=0)
        self.assertEqual(set(solid.cell_data["Label"]), {7})

    def test_a_deformation(self):
        done = self.do(
            """
            around = cage_around(points)
            bent = deformation(points, rest_mesh=around, deformed_mesh=(around.points + [1, 2, 3], around.cells))
            """
        )
        np.testing.assert_allclose(done.bent.points, POINTS + [1, 2, 3], rtol=0, atol=1e-12)

    def test_the_operator_of_scipy(self):
        if not importlib.util.find_spec("scipy"):
            self.skipTest("skipped: there is no SciPy")
        done = self.do("S = operator_matrix(points, tetrahedra, levels=2).to_scipy()")
        expected = subdivisionobjects.subdivide(POINTS, TETS, levels=2)
        np.testing.assert_allclose(done.S @ POINTS, expected.points, rtol=0, atol=1e-14)


class Help(InFolder):
    def test_it_is_one_screen(self):
        for name in functions.__all__:
            text = pydoc.plain(pydoc.render_doc(getattr(subdivisionobjects, name)))
            lines = [part for line in text.splitlines() for part in (textwrap.wrap(line, COLUMNS) or [""])]
            self.assertLessEqual(len(lines), LINES, text)

    def test_the_signature_shows_what_it_says(self):
        """All that a signature has is explained, and what an option is by default."""
        for name, one in FILTERS.items():
            signature = pydoc.render_doc(getattr(functions, name)).splitlines()[2]
            shown = re.findall(r"(\w+)=([^=]*)(?:, (?=\w+=|\*)|\)$)", signature)
            listed = subdivisionobjects.options(name)
            for key, value in shown:
                self.assertRegex(getattr(functions, name).__doc__, rf"\n    (\w+, )?{key}[,:]")
                if key in listed:
                    self.assertEqual(value, repr(listed[key].default))
        signature = pydoc.render_doc(functions.subdivide)
        for key in ("levels", "scheme", "progress"):
            self.assertIn(f"{key}=", signature)

    def test_examples(self):
        names = {
            **vars(subdivisionobjects),
            "points": CUBE,
            "quads": QUADS,
            "triangles": QUADS[:, :3],
            "labels": np.ones((2, 3, 4), int),
            "rest": subdivisionobjects.cage(),
            "moved": subdivisionobjects.cage(),
            "print": lambda shown: self.assertTrue(len(shown)),
        }
        count = 0
        for name in functions.__all__:
            lines = re.findall(
                r"^        (?=\S)(.*\(.*\))$", functions.__dict__[name].__doc__.split("mesh:")[0], re.MULTILINE
            )
            self.assertTrue(any(f"{name}(" in line for line in lines), name)
            for line in lines:
                exec(compile(line, name, "exec"), dict(names))
                count += 1
        self.assertEqual(count, len(functions.__all__) + 1)

    def test_options_are_listed(self):
        for name, one in FILTERS.items():
            text = repr(subdivisionobjects.options(name))
            for key in [*one.options, *one.aliases]:
                self.assertRegex(text, rf"\n  (.*, )?{key}(,.*)? = ")
        self.assertEqual(
            repr(subdivisionobjects.options(subdivisionobjects.subdivide)),
            repr(subdivisionobjects.options("subdivide")),
        )
        self.assertEqual(list(subdivisionobjects.options()), functions.__all__)

    def test_options_with_a_word_are_explained(self):
        found = subdivisionobjects.options("subdivide", "crease")
        self.assertIn("crease_geometry", found)
        self.assertNotIn("volume_scheme", found)  # whose help has the word, too
        self.assertIn(f"one of {', '.join(map(repr, found['crease_points'].entries))}", repr(found))
        self.assertEqual(set(subdivisionobjects.options("subdivide", "OctahedronId")), {"volume_scheme", "scheme"})
        with self.assertRaisesRegex(ValueError, "no option of subdivide has the word 'banana'"):
            subdivisionobjects.options("subdivide", "banana")
        with self.assertRaisesRegex(ValueError, "no function 'subdivde'.*did you mean subdivide"):
            subdivisionobjects.options("subdivde")

    def test_unknown_options_are_told_with_near_ones(self):
        for given, near in (
            ("levles", "levels"),
            ("NumberOfLevels", "number_of_levels"),
            ("crease", "creases"),
            ("angle", "feature_angle"),
        ):
            with self.assertRaisesRegex(
                TypeError, rf"no argument '{given}'; did you mean .*\b{near}\b.*options\('subdivide'\)"
            ):
                subdivisionobjects.subdivide(POINTS, TETS, **{given: 1})

    def test_spellings(self):
        option = Option("enum", "SetScheme", entries=[("Smooth", 1), ("Plain", 0)], spellings=[("Box Spline", 1)])
        self.assertEqual([option.entry("scheme", text) for text in ("smooth", "BoxSpline", "plain", 1)], [1, 1, 0, 1])
        with self.assertRaisesRegex(ValueError, "scheme is one of 'Smooth', 'Plain', not 'Boxes'"):
            option.entry("scheme", "Boxes")

    def test_old_names(self):
        new = subdivisionobjects.subdivide(POINTS, TETS, levels=2, scheme="Linear")
        old = subdivisionobjects.multi_dimensional_subdivision(POINTS, TETS, number_of_levels=2, volume_scheme="Linear")
        np.testing.assert_array_equal(new.points, old.points)


class Saved(InFolder):
    def test_results_say_what_they_are(self):
        made = subdivisionobjects.subdivide(
            POINTS, {"tetra": TETS, "line": [[0, 1]]}, levels=1, point_data={"T": POINTS[:, 0]}
        )
        self.assertEqual(repr(made)[:41], "<Arrays: 14 points; 2 line; 16 tetra; poi")
        self.assertIn("point_data T", repr(made))
        self.assertLess(len(repr(made)), 100)

    def test_every_format(self):
        solid = subdivisionobjects.subdivide(POINTS, TETS, levels=1, point_data={"T": POINTS[:, 0]})
        surface = subdivisionobjects.surface_subdivision(CUBE, QUADS, scheme="catmull-clark", levels=1)
        for made, ending, count in (
            (solid, "vtu", 16), (solid, "vtk", 16), (solid, "VTP", 24), (solid, "stl", 24), (solid, "ply", 24),
            (solid, "obj", 24), (surface, "vtu", 24), (surface, "vtp", 24), (surface, "obj", 24), (surface, "stl", 48),
        ):  # fmt: skip
            with self.subTest(ending):
                made.save(pathlib.Path(f"made.{ending}"))
                read = meshes.to_vtk(f"made.{ending}")
                self.assertEqual(read.GetNumberOfCells(), count)
                self.assertEqual(
                    bool(read.GetPointData().HasArray("T")), made is solid and ending in ("vtu", "vtk", "VTP")
                )
        self.assertEqual([name for name in os.listdir() if "part" in name], [])

    def test_polygons_become_triangles(self):
        """A polygon that is not convex, the shape of an L."""
        corners = np.array([[0.0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]])
        mesh = Arrays(corners, {"polygon6": np.array([[2, 3, 4, 5, 0, 1]])}, {}, {})
        for ending in ("stl", "ply"):
            mesh.save(f"l.{ending}")
            points, triangles = meshes.to_arrays(meshes.to_vtk(f"l.{ending}"))
            sides = np.diff(points[triangles], axis=1)
            self.assertAlmostEqual(np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum() / 2, 3)

    def test_points_alone(self):
        made = subdivisionobjects.deformation(
            POINTS, rest_mesh=subdivisionobjects.cage(), deformed_mesh=subdivisionobjects.cage()
        )
        self.assertIsInstance(made.to_vtk(), vtkPolyData)
        made.save("points.vtu")
        self.assertEqual(meshes.to_vtk("points.vtu").GetNumberOfPoints(), 5)

    def test_what_cannot_be_saved(self):
        made = subdivisionobjects.subdivide(POINTS, {"line": [[0, 1]]}, levels=1)
        for error, text, name in (
            (FileNotFoundError, "no folder 'nowhere'", "nowhere/made.vtu"),
            (ValueError, "no triangles for 'line.stl'", "line.stl"),
        ):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                made.save(name)
        with unittest.mock.patch.dict(sys.modules, meshio=None):
            with self.assertRaisesRegex(ValueError, "'made.mesh' ends with none of .vtu, .*meshio, .* is not installed"):
                made.save("made.mesh")
            pathlib.Path("made.msh").write_text("")
            with self.assertRaisesRegex(ValueError, "'made.msh' ends with none of .vtu, .*not installed"):
                subdivisionobjects.subdivide("made.msh")
        os.mkdir("folder.vtu")
        with self.assertRaisesRegex(OSError, "'folder.vtu' was not written"):
            made.save("folder.vtu")
        self.assertEqual([name for name in os.listdir() if "part" in name], [])

    def test_files_that_are_none(self):
        pathlib.Path("broken.vtu").write_text("<VTKFile type='UnstructuredGrid'><Unstr")
        with self.assertRaisesRegex((RuntimeError, ValueError), "broken.vtu|[Ee]rror"):
            subdivisionobjects.subdivide("broken.vtu")

    def test_meshes_of_others(self):
        made = subdivisionobjects.subdivide(
            POINTS, {"tetra": TETS, "line": [[0, 1]]}, levels=1, cell_data={"id": [5, 6, 7]}
        )
        self.assertIsInstance(made.to_vtk(), vtkUnstructuredGrid)
        self.assertEqual(made.to_vtk().GetNumberOfCells(), 18)
        stand_in = types.ModuleType("meshio")
        stand_in.Mesh = lambda points, cells, **data: types.SimpleNamespace(points=points, cells=cells, **data)
        with unittest.mock.patch.dict(sys.modules, meshio=stand_in):
            other = made.to_meshio()
        self.assertEqual([(name, len(rows)) for name, rows in other.cells], [("line", 2), ("tetra", 16)])
        self.assertEqual([part.tolist() for part in other.cell_data["id"]], [[7, 7], 8 * [5] + 8 * [6]])

    def test_meshio(self):
        if not importlib.util.find_spec("meshio"):
            self.skipTest("skipped: there is no meshio")
        made = subdivisionobjects.subdivide(
            POINTS, {"tetra": TETS, "line": [[0, 1]]}, levels=1, point_data={"T": POINTS[:, 0]}
        )
        made.save("made.mesh")
        again = subdivisionobjects.subdivide("made.mesh", levels=0)
        np.testing.assert_allclose(again.points, made.points)
        self.assertEqual({name: len(rows) for name, rows in again.cells.items()}, {"line": 2, "tetra": 16})
        self.assertEqual([block.type for block in made.to_meshio().cells], ["line", "tetra"])
        with self.assertRaisesRegex(ValueError, "meshio cannot write 'made.nothing'"):
            made.save("made.nothing")


class Types(unittest.TestCase):
    """What editors and type checkers read."""

    def setUp(self):
        text = pathlib.Path(functions.__file__).with_suffix(".pyi").read_text(encoding="utf-8")
        self.stub = ast.parse(text).body

    def test_they_have_all_arguments(self):
        for name, one in FILTERS.items():
            more = next(node for node in self.stub if getattr(node, "name", "") == f"_{name}_options")
            rest = [line.target.id for line in more.body if isinstance(line, ast.AnnAssign)]
            for node in self.stub:
                if isinstance(node, ast.FunctionDef) and node.name == name:
                    named = [each.arg for each in node.args.args + node.args.kwonlyargs]
                    self.assertEqual(sorted(named + rest), sorted(one.names()), name)

    def test_they_are_known(self):
        """Any is what arrays have, and what is passed on."""
        folder = pathlib.Path(functions.__file__).parent
        for path in (*sorted(folder.glob("*.py")), folder / "functions.pyi"):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            passed = {id(one.annotation) for node in ast.walk(tree) if isinstance(node, ast.arguments)
                      for one in (node.vararg, node.kwarg) if one}
            arrays = {id(inner) for node in ast.walk(tree)
                      if isinstance(node, ast.Subscript) and ast.unparse(node.value) in ("np.ndarray", "NDArray")
                      for inner in ast.walk(node)}
            for node in ast.walk(tree):
                if isinstance(node, ast.Name) and node.id == "Any" and id(node) not in passed | arrays:
                    self.fail(f"{path.name}, line {node.lineno}: a type that is not known")

    def test_types_of_arguments_are_those_that_are_taken(self):
        """The members of each union in kinds.py."""
        solid, ids, lines = meshes.to_vtk(POINTS, TETS), {"points": [0, 1]}, (POINTS, [[0, 1]])
        made = subdivisionobjects.subdivide(POINTS, TETS, levels=0)
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "mesh.vtu")
            made.save(name)
            for mesh in (solid, [solid], made, (POINTS, TETS), (POINTS, {"tetra": TETS}), (POINTS, [("tetra", TETS)]), name):
                self.assertTrue(subdivisionobjects.subdivide(mesh))
        for option, values in {"mark_selection": [ids, meshes.to_selection(ids)], "crease_geometry": [lines, meshes.to_vtk(*lines)],
                               "creases": [[[0, 1]], ([[0, 1]], 1.5), {(0, 1): 1.5}]}.items():
            for value in values:
                self.assertEqual(len(subdivisionobjects.subdivide(POINTS, TETS, **{option: value}).cells), 16)

    def test_they_return_what_comes_out(self):
        cube, image = meshes.to_vtk(CUBE, QUADS, of_surfaces=True), meshes.to_image(np.ones((2, 2, 2), int))
        more = {"limit_probe": {"places": CUBE}, "deformation": {"rest_mesh": cube, "deformed_mesh": cube}}
        found = {"_Data": "vtkUnstructuredGrid"}
        for node in self.stub:
            first = node.args.args[:1] if isinstance(node, ast.FunctionDef) else []
            if isinstance(node, ast.FunctionDef) and (
                not first or getattr(first[0].annotation, "id", "") in ("vtkDataObject", "_Data")
            ):
                given = {OF_MESHES: [cube], OF_IMAGES: [image], (): []}[FILTERS[node.name].inputs]
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    made = getattr(functions, node.name)(*given, **more.get(node.name, {}))
                self.assertEqual(type(made).__name__, found.get(node.returns.id, node.returns.id), node.name)
                found[node.name] = True
        self.assertEqual(set(found) - {"_Data"}, set(FILTERS) - {"measures"})
        self.assertIsInstance(functions.measures(cube), dict)
