# SPDX-License-Identifier: BSD-3-Clause
"""The program `subdivide` as users run it, and whether it has every option of the classes."""

import csv
import importlib.util
import json
import os
import pathlib
import pty
import re
import resource
import shutil
import signal
import subprocess
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOInfovis import vtkDelimitedTextReader
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter, vtkXMLTableWriter, vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter)

import subdivisionobjects
from headers import CLASSES, of_bases
from subdivisionobjects import meshes
from subdivisionobjects.run import FILTERS

PROGRAM = os.environ.get("SUBDIVISIONOBJECTS_PROGRAM", "")
DATA = pathlib.Path(os.environ["SUBDIVISIONOBJECTS_DATA"])
SHIP = str(DATA / "Ship.vtu")
SOURCE = pathlib.Path(__file__).resolve().parents[2]
# Names of options that are names of arrays and fields, too.
ARRAYS = {"MaterialId"}
# What the panels do not show either, of filters whose output is no mesh first.
NO_MESH = {"NumberOfLevels", "ProjectToLimit", "GenerateLimitNormals", "SmoothShading", "GenerateTangents",
           "GenerateErrorBounds", "GenerateClassification", "OutputCells", "CellOrder", "BezierTolerance", "CacheOperator",
           "Use32BitIds", "OutputPointsPrecision", "GenerateOriginalIds", "GenerateGlobalIds"}
# What the panels do not show either.
HIDDEN = {"vtkSurfaceSubdivision": {"EmbeddedCells"},
          "vtkAdaptiveSurfaceSubdivision": {"EmbeddedCells", "LoopWeights", "ModifiedBoundary"},
          "vtkSimplicialComplexTopology": {"InterfaceValues", "LoopWeights", "ModifiedBoundary"},
          "vtkSubdivisionLimitProbe": {"InterfaceValues"}, "vtkSubdivisionSmoothness": {"InterfaceValues"},
          "vtkSubdivisionCageSource": {"Hug"},  # of cage-around
          "vtkSubdivisionMeasures": NO_MESH, "vtkSubdivisionSampler": NO_MESH,
          "vtkSubdivisionDeformation": {"InterpolateIntegers", "GenerateOriginalIds", "GenerateGlobalIds",
                                        "InterfaceValues"}}
UNSMOOTHED = {"InterpolatePoints", "InterpolateArrays", "InterpolationWeight"}

# A tetrahedron around a point near one of its faces.
THIN = """# vtk DataFile Version 3.0

ASCII
DATASET UNSTRUCTURED_GRID
POINTS 5 double
0 0 0 1 0 0 0 1 0 0 0 1 0.3 0.3 0.3
CELLS 4 20
4 0 1 2 4 4 0 1 4 3 4 0 4 2 3 4 4 1 2 3
CELL_TYPES 4
10 10 10 10
"""


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def run_on_full_disk(size, *arguments):
    """No file can have more bytes than this."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300, preexec_fn=limit)


def grid(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def cells(name):
    return grid(name).GetNumberOfCells()


def picture(name):
    """Pixels, the row of the least y first."""
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    image = reader.GetOutput()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[1::-1])


def write(writer, data, name):
    writer.SetInputData(data)
    writer.SetFileName(name)
    writer.Write()


def plain(name):
    return name.replace("-", "").lower()


def letters(text):
    return re.sub(r"[\W_]", "", text).lower()


@unittest.skipUnless(PROGRAM, "skipped: there is no program")
class Program(unittest.TestCase):
    def test_every_option_of_the_classes(self):
        filters = {found[1] for found in re.finditer(r"^  ([a-z][a-z-]+)(?:   \(.*\))?$", run("--help").stdout, re.MULTILINE)}
        found = {}
        for one in filters:
            listed = run("--filter", one, "--help").stdout
            found[plain(one)] = {plain(line.split()[0].rstrip(",")) for line in listed.splitlines() if line.startswith("  --")}
        for cls in CLASSES:
            names = [name for name in found if plain(cls.__name__[3:]) in (name, "subdivision" + name,
                                                                           "subdivision" + name + "source")]
            if cls.__name__ in ("vtkSubdivisionAlgorithm", "vtkRefinementAlgorithm", "vtkMarkedSubdivisionAlgorithm",
                                "vtkUniformSubdivisionAlgorithm"):
                self.assertEqual(names, [])
                continue
            self.assertEqual(len(names), 1, cls.__name__)
            missing = {name for name in of_bases(cls, "options") if plain(name) not in found[names[0]]}
            self.assertEqual(missing - UNSMOOTHED, HIDDEN.get(cls.__name__, set()), cls.__name__)
            if cls.__name__ in ("vtkMultiDimensionalSubdivision", "vtkRedGreenRefinement", "vtkSurfaceSubdivision"):
                self.assertFalse(missing & UNSMOOTHED)

    def test_labels_of_panels_stand_in_helps_and_are_taken(self):
        """Whatever the panel and the menu call an option and a filter, the program and Python have it, too."""
        labels = {}
        for path in sorted((SOURCE / "Plugin").glob("*.xml*")):
            for tag in re.findall(r"<\w+Property\s([^>]*)>", path.read_text(encoding="utf-8")):
                found = dict(re.findall(r'(\w+)="([^"]*)"', tag))
                if "command" in found:
                    name = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", found["name"]).lower()
                    labels.setdefault(name, set()).add(found.get("label") or found["name"])
        self.assertIn("Smooth Up To Borders", labels["modified_boundary"])
        for one in FILTERS.values():
            done = run("--filter", one.label, "--help")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(one.label.split()[0].lower(), run("--help").stdout.lower())
            listed = repr(subdivisionobjects.options(one.label))
            self.assertTrue(listed.startswith(f"{one.name} ({one.label}): "))
            heads = {letters(line.split()[0].rstrip(",")): letters(line) for line in done.stdout.splitlines()
                     if line.startswith("  --")}
            rows = [letters(line) for line in listed.splitlines() if " = " in line]
            for name in one.options:
                with self.subTest(f"{one.name}: {name}"):
                    own = [label for label in labels[name] if letters(label) in heads[letters(name)]]
                    self.assertTrue(own)
                    self.assertTrue(any(letters(own[0]) in row and letters(name) in row for row in rows))
                    one.check({re.sub(r"\W+", "_", re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", own[0])).lower(): 1})
                    for label in labels[name]:  # names of classes are for classes
                        known = re.search("[a-z0-9][A-Z]", label) and label not in ARRAYS
                        self.assertNotRegex(done.stdout + listed, rf"\b{label}\b" if known else "(?!)")

    def test_entries_are_taken_in_all_spellings(self):
        """As panels write them, without spaces, and by former names."""
        count = 0
        for one in FILTERS.values():
            for name, option in one.options.items():
                for text, value in (*option.entries.items(), *option.spellings.items()):
                    for spelling in (text, text.replace(" ", ""), text.lower().replace(" ", "-"), text.replace("-", "")):
                        self.assertEqual(option.entry(name, spelling), value, f"{one.name}: {name}")
                        count += 1
        self.assertGreater(count, 500)
        self.assertEqual(run(SHIP, "a.vtu", "--scheme", "tetoct", "--no-smooth-up-to-borders").returncode, 0)
        self.assertEqual(run(SHIP, "b.vtu", "--VolumeScheme", "Even", "--no-modified-boundary").returncode, 0)
        self.assertEqual(pathlib.Path("a.vtu").read_bytes(), pathlib.Path("b.vtu").read_bytes())

    def test_functions_of_python_have_the_same_options(self):
        for name, one in FILTERS.items():
            filter_name = {"subdivide": "multi"}.get(name, name.replace("_", "-"))
            listed = run("--filter", filter_name, "--help").stdout
            found = {plain(line.split()[0].rstrip(",")) for line in listed.splitlines() if line.startswith("  --")}
            common = found & {plain(f"--{option}") for option in ("filter", "refine", "info", "quiet", "help", "version")}
            self.assertEqual(found - common, {name.replace("_", "") for name in one.options}, name)

    def test_tables(self):
        expected = subdivisionobjects.measures(SHIP, maximum_level=2)
        done = run("measure", SHIP, "--maximum-level", 2)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        shown = [float(line.split()[1]) for line in done.stdout.splitlines() if line.startswith("Measure ")]
        self.assertEqual(shown, expected["Measure"].tolist())
        self.assertEqual(run("measure", SHIP, "ship.json", "--maximum-level", 2).returncode, 0)
        with open("ship.json", encoding="utf-8") as file:
            found = json.load(file)
        self.assertEqual(found["MeasuredLevels"], 2)
        self.assertEqual([row["Centroid"] for row in found["rows"]], expected["Centroid"].tolist())
        self.assertEqual(run("measure", SHIP, "ship.csv", "--maximum-level", 2).returncode, 0)
        with open("ship.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([float(row["Centroid:Y"]) for row in rows], expected["Centroid"][:, 1].tolist())
        for wrong in (["ship.vtu"], ["--info"]):
            done = run("measure", SHIP, *wrong)
            self.assertEqual(done.returncode, 2)
            self.assertIn("table", done.stderr)

    def test_images(self):
        write(vtkXMLUnstructuredGridWriter(), subdivisionobjects.model(model="MechanicalPart"), "part.vtu")
        done = run("sample", "part.vtu", "part.vti", "--spacing", 0.1, "--generate-coverage")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        expected = subdivisionobjects.sample("part.vtu", spacing=0.1, generate_coverage=True)
        found = meshes.to_samples(meshes.to_vtk("part.vti"))
        self.assertEqual((found.origin, found.spacing), (expected.origin, expected.spacing))
        self.assertEqual(list(found), list(expected))
        for name, values in expected.items():
            np.testing.assert_array_equal(found[name], values)
        self.assertGreater(found["vtkValidPointMask"].sum(), 1000)
        self.assertEqual(run("sample", "part.vtu", "same.vti", "--grid", "part.vti").returncode, 0)
        np.testing.assert_array_equal(meshes.to_samples(meshes.to_vtk("same.vti"))["Material"], expected["Material"])
        for code, text, arguments in (
                (1, "--maximum-number-of-samples, 1000", ("x.vti", "--spacing", 0.01, "--maximum-number-of-samples", 1000)),
                (1, "Spacing is not usable", ("x.vti", "--spacing", -1)),
                (2, "cannot write", ("x.csv",))):
            done = run("sample", "part.vtu", *arguments)
            self.assertEqual(done.returncode, code)
            self.assertIn(text, done.stderr)
            self.assertFalse(os.path.exists("x.vti"))

    def test_slices_of_materials_of_16_digits_and_of_no_number(self):
        """Each has its pictures, which none overwrites."""
        for materials, names in (([1234567890123456, 1234567890123457], ["1234567890123456", "1234567890123457"]),
                                 ([0.1, np.nan], ["0.1", "nan"])):
            points = np.array([[x, y, z] for z in (0.0, 1) for y in (0, 1) for x in (0, 1, 2)])
            data = {"cell_data": {"MaterialId": np.array(materials)}}
            cells = {"hexahedron": [[i, i + 1, i + 4, i + 3, i + 6, i + 7, i + 10, i + 9] for i in (0, 1)]}
            write(vtkXMLUnstructuredGridWriter(), meshes.to_vtk(points, cells, **data), "two.vtu")
            for coverage in (False, True):
                arguments = ["--generate-coverage"] if coverage else []
                done = run("sample", "two.vtu", "--number-of-samples", 6, *arguments, "--slices", "two")
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                image = subdivisionobjects.sample(points, cells, number_of_samples=6, generate_coverage=coverage, **data)
                image.save_slices("two/of_python")
                for folder in ("two", "two/of_python"):
                    of_layer = [picture(f"{folder}/layer00002_material{name}.png") for name in names]
                    self.assertTrue(all(one.max() == 255 for one in of_layer), f"{folder}, {names}, {coverage}")
                shutil.rmtree("two")

    def test_slices(self):
        """Pictures of the program and of Python are the same, and pixels of materials together are the object."""
        write(vtkXMLUnstructuredGridWriter(), subdivisionobjects.model(model="MaterialBlock"), "part.vtu")
        options = {"spacing": 0.1, "output_dimensions": ["Tetrahedra"]}
        arguments = ["sample", "part.vtu", "--spacing", 0.1, "--output-dimensions", "Tetrahedra"]
        for folder, more, given, dither in (
                ("plain", [], {}, False), ("grey", ["--generate-coverage"], {"generate_coverage": True}, False),
                ("dots", ["--generate-coverage", "--dither"], {"generate_coverage": True}, True)):
            done = run(*arguments, *more, "--slices", folder)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
            image = meshes.to_samples(subdivisionobjects.sample(meshes.to_vtk("part.vtu"), **options, **given))
            image.save_slices(folder + "/of_python", dither)
            names = sorted(name for name in os.listdir(folder) if name.endswith(".png"))
            self.assertEqual(names, sorted(name for name in os.listdir(folder + "/of_python") if name.endswith(".png")))
            depth, height, width = image["Material"].shape
            materials = np.unique(image["Material"][image["vtkValidPointMask"] == 1])
            self.assertGreater(len(materials), 1)
            self.assertEqual(len(names), len(materials) * depth)
            for name in names:
                np.testing.assert_array_equal(picture(f"{folder}/{name}"), picture(f"{folder}/of_python/{name}"), name)
            layers = [[picture(f"{folder}/layer{k:05}_material{m}.png") for m in materials] for k in range(depth)]
            values = np.moveaxis(np.array(layers), 1, -1) / 255  # z, y, x and materials
            self.assertEqual(values.shape, (depth, height, width, len(materials)))
            told = [json.loads(pathlib.Path(f"{at}/slices.json").read_text(encoding="utf-8"))
                    for at in (folder, folder + "/of_python")]
            self.assertEqual(told[0], told[1])
            self.assertEqual((told[0]["pixel_and_layer"], told[0]["materials"]), ([0.1, 0.1, 0.1], [f"{m}" for m in materials]))
            if folder == "plain":
                inside = image["vtkValidPointMask"] == 1
                for number, material in enumerate(materials):
                    np.testing.assert_array_equal(values[..., number] == 1, inside & (image["Material"] == material))
            elif folder == "grey":
                np.testing.assert_allclose(values, image["Coverage"], atol=0.5 / 255 + 1e-6)
            else:
                self.assertEqual(set(np.unique(values)), {0, 1})
                self.assertEqual(values.sum(axis=-1).max(), 1)  # no pixel has two materials
                covered = image["Coverage"].astype(float)
                self.assertTrue((values[covered == 1] == 1).all() and (values[covered == 0] == 0).all())
                np.testing.assert_allclose(values.sum(axis=(0, 1, 2)), covered.sum(axis=(0, 1, 2)), rtol=0.01)
        for code, text, given in ((2, "let sample be", ("multi", "part.vtu", "x.vtu", "--slices", "x")),
                                  (2, "needs a value", ("sample", "part.vtu", "x.vti", "--slices=")),
                                  (2, "is for --slices", ("sample", "part.vtu", "x.vti", "--dither")),
                                  (1, "part.vtu", ("sample", "part.vtu", "--slices", "part.vtu"))):
            done = run(*given)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(text, done.stderr)

    def test_openvdb_is_written_or_told(self):
        write(vtkXMLUnstructuredGridWriter(), subdivisionobjects.model(model="MechanicalPart"), "part.vtu")
        done = run("sample", "part.vtu", "part.vdb", "--spacing", 0.3)
        if importlib.util.find_spec("vtkmodules.vtkIOOpenVDB"):
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(pathlib.Path("part.vdb").read_bytes()[:4], b" BDV")  # the number of the format, turned round
        else:
            self.assertEqual(done.returncode, 2)
            self.assertIn("built without its module IOOpenVDB", done.stderr)
            with self.assertRaisesRegex(ValueError, "built without the module IOOpenVDB"):
                meshes.to_samples(subdivisionobjects.sample(meshes.to_vtk("part.vtu"), spacing=0.3)).save("part.vdb")
        self.assertEqual(os.path.exists("part.vdb"), done.returncode == 0)

    def test_it_does_what_the_class_does(self):
        done = run(SHIP, "smooth.vtu", "--levels", 2, "--scheme", "tetoct")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        made = subdivisionobjects.vtkMultiDimensionalSubdivision()
        source = subdivisionobjects.vtkSubdivisionModelSource()
        source.SetModelToShip()
        made.SetInputConnection(source.GetOutputPort())
        made.SetNumberOfLevels(2)
        made.SetVolumeSchemeToTetOct()
        made.Update()
        self.assertEqual(cells("smooth.vtu"), made.GetOutput().GetNumberOfCells())

    def test_info_is_what_comes_out(self):
        told = run(SHIP, "--info", "--levels", 4).stdout.split()
        self.assertEqual(told[0], "about")
        self.assertEqual(run(SHIP, "four.vtu", "--levels", 4).returncode, 0)
        self.assertEqual(int(told[1]), cells("four.vtu"))

    def test_info_tells_no_warning_of_fewer_levels(self):
        pathlib.Path("thin.vtk").write_text(THIN, encoding="utf-8")
        self.assertIn("inside out", run("thin.vtk", "smooth.vtu", "--levels", 3).stderr)
        self.assertEqual(run("thin.vtk", "--info", "--levels", 9).stderr, "")

    def test_an_input_is_never_written_over(self):
        ship = shutil.copy(SHIP, "ship.vtu")
        before = pathlib.Path(ship).read_bytes()
        for arguments in ((ship, "./ship.vtu"), (SHIP, ship, "--filter", "deformation", "--rest-mesh", ship)):
            refused = run(*arguments)
            self.assertEqual(refused.returncode, 2)
            self.assertIn("over the input", refused.stderr)
            self.assertEqual(pathlib.Path(ship).read_bytes(), before)

    def test_info_of_what_cannot_be_foretold(self):
        told = run(SHIP, "--info", "--filter", "red-green", "--refine", "edge-length=0.5").stdout.split()
        run(SHIP, "fine.vtu", "--filter", "red-green", "--refine", "edge-length=0.5")
        self.assertEqual(int(told[0]), cells("fine.vtu"))

    def test_a_second_input(self):
        self.assertEqual(run(SHIP, "cage.vtu", "--filter", "cage-around", "--margin", 50).returncode, 0)
        done = run(SHIP, "bent.vtu", "--filter", "deformation", "--rest-mesh", "cage.vtu", "--deformed-mesh", "cage.vtu")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(cells("bent.vtu"), cells(SHIP))

    def test_arrays_are_found_where_they_are(self):
        """RangeArray is a point array by default; MaterialId is one of cells."""
        done = run(DATA / "MaterialBlock.vtu", "range.vtu", "--filter", "red-green", "--refine", "array-range=0.5,1.5",
                   "--range-array", "MaterialId", "--maximum-level", 1)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        made = subdivisionobjects.red_green_refinement(
            subdivisionobjects.model(model="MaterialBlock"), refine={"array_range": (0.5, 1.5)}, range_array="MaterialId",
            maximum_level=1)
        self.assertEqual(cells("range.vtu"), made.GetNumberOfCells())

    def test_tables_of_materials(self):
        """Numbers become cell arrays, names field arrays, however the table is written."""
        image = vtkImageData()
        image.SetDimensions(6, 6, 6)
        labels = vtkIntArray()
        labels.SetName("Tissue")
        for i in range(image.GetNumberOfPoints()):
            labels.InsertNextValue(7 if i % 6 < 3 else 5)
        image.GetPointData().SetScalars(labels)
        write(vtkXMLImageDataWriter(), image, "labels.vti")
        pathlib.Path("comma.csv").write_text('Label, Name,Density\n5,"bone, hard",1.5\n7,"says ""a""",2\n')
        pathlib.Path("semicolon.csv").write_bytes(b"\xef\xbb\xbfLabel;Name;Density\r\n5;bone, hard;1.5\r\n7;x;2\r\n")
        pathlib.Path("tab.tsv").write_text("Density\tTissue\tName\n1.5\t5\tbone, hard\n2\t7\tx\n")
        read = vtkDelimitedTextReader()
        read.SetFileName("comma.csv")
        read.SetHaveHeaders(True)
        read.DetectNumericColumnsOn()
        read.Update()
        write(vtkXMLTableWriter(), read.GetOutput(), "table.vtt")
        for name in ("comma.csv", "semicolon.csv", "tab.tsv", "table.vtt"):
            with self.subTest(name):
                done = run("labels.vti", "solid.vtu", "--filter", "label-solid", "--materials", name)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                solid = grid("solid.vtu")
                density = solid.GetCellData().GetArray("Density")
                tissue = solid.GetCellData().GetArray("Tissue")
                pairs = {(tissue.GetTuple1(i), density.GetTuple1(i)) for i in range(solid.GetNumberOfCells())}
                self.assertEqual(pairs, {(5., 1.5), (7., 2.)})
                self.assertEqual(solid.GetFieldData().GetAbstractArray("Name").GetValue(0), "bone, hard")
        for name, text, why in (("none.csv", None, "there is no file"), ("empty.csv", "", "empty.csv"),
                                ("header.csv", "Label,Density\n", "has no rows"),
                                ("short.csv", "Label,Density\n5,1\n\n7\n", "row 2 of the table \"short.csv\" has 1 values"),
                                ("long.csv", "Label,Density\n5,1\n7,2,3", "has 3 values, but there are 2 titles"),
                                ("twice.csv", '"Label", Label\n5,1\n', "two columns with the title \"Label\"")):
            with self.subTest(name):
                if text is not None:
                    pathlib.Path(name).write_text(text)
                done = run("labels.vti", "x.vtu", "--filter", "label-solid", "--materials", name)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(why, done.stderr)
        pathlib.Path("gap.csv").write_text("Label,Density,Name\n5,,a\n7,2,\"b\nc\"\n\n")
        done = run("labels.vti", "gap.vtu", "--filter", "label-solid", "--materials", "gap.csv")
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (0, 1))
        self.assertIn('row 1 of the table "gap.csv" has nothing in the column "Density"', done.stderr)

    def test_exit_codes_and_messages(self):
        for code, text, arguments in (
                (2, "did you mean --levels?", (SHIP, "x.vtu", "--levles", 2)),
                (2, "cannot write", (SHIP, "x.txt")),
                (1, "there is no file", ("none.vtu", "x.vtu")),
                (1, "--maximum-number-of-cells = 1000", (SHIP, "x.vtu", "--levels", 5, "--maximum-cells", 1000)),
                (1, "cannot write", (SHIP, "no-such-folder/x.vtu")),
                (1, ".vti files cannot hold", (SHIP, "x.vti"))):
            with self.subTest(arguments):
                done = run(*arguments)
                self.assertEqual((done.returncode, done.stdout), (code, ""))
                self.assertIn(text, done.stderr)
                self.assertTrue(all(line.startswith("subdivide: ") for line in done.stderr.splitlines()), done.stderr)
                self.assertFalse(os.path.exists(str(arguments[1])))

    def test_messages_name_options_of_the_program(self):
        for text, arguments in (
                ('Cell array "Nowhere" (--singular-array) is not there', ("--singular-array", "Nowhere")),
                ("--preserve-interfaces needs a cell array of materials: set --material-array",
                 ("--preserve-interfaces",)),
                ("takes their outside, 4 face(s). Use multi-dimensional-subdivision", ("--filter", "surface")),
                ("--deformed-mesh is missing; the output is the input. --rest-mesh is a mesh of solid cells around the "
                 "input, such as a cage of cage-around, --deformed-mesh the same", ("--filter", "deformation"))):
            with self.subTest(arguments):
                told = run("thin.vtk", "told.vtu", *arguments).stderr
                self.assertIn(text, told)
                self.assertNotRegex(told, "array index|input port|vtk[A-Z]")

    def test_files_that_are_not_whole(self):
        """Some of VTK's writers crash when the disk is full, some say nothing."""
        listed = run("--help").stdout.split("Writes")[1].split("\n\n")[0]
        endings = [word for word in listed.split("):")[1].split() if word not in (".vti", ".vtr", ".vts")]
        self.assertGreater(len(endings), 10)
        folder = pathlib.Path("full")
        for ending in endings:
            name = folder / ("x" + ending)
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
            self.assertEqual(run(SHIP, name, "--levels", 2).returncode, 0)
            largest = max(path.stat().st_size for path in folder.rglob("*") if path.is_file())
            for size in (0, 100, largest // 2, largest - 1):
                shutil.rmtree(folder)
                folder.mkdir()
                with self.subTest(ending, size=size, of=largest):
                    done = run_on_full_disk(size, SHIP, name, "--levels", 2)
                    self.assertEqual(done.returncode, 1, done.stderr)
                    self.assertIn(f'cannot write "{name}"', done.stderr)
                    if ending not in (".e", ".ex2", ".exo"):
                        self.assertFalse(name.exists())

    def test_places_where_nothing_can_be_written(self):
        pathlib.Path("folder.vtu").mkdir(exist_ok=True)
        old = pathlib.Path("old.vtu")
        for name, why in (("no-folder/x.pvtu", 'there is no folder "no-folder"'), ("folder.vtu", "it is a folder"),
                          ("x" * 300 + ".vtu", "cannot write")):
            with self.subTest(name):
                done = run(SHIP, name, "--levels", 9)  # is told before the work
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertIn(why, done.stderr)
        self.assertFalse(os.path.exists("no-folder"))
        old.write_text("old")
        self.assertEqual(run("none.vtu", old).returncode, 1)
        self.assertEqual(old.read_text(), "old")

    def test_standard_streams_that_are_closed(self):
        def shell(command):
            return subprocess.run(["sh", "-c", command, PROGRAM, SHIP], capture_output=True, text=True, timeout=300)
        for command in ('"$0" --help >&-', '"$0" "$1" --info >&-', '"$0" --version >/dev/full'):
            done = shell(command)
            self.assertEqual(done.returncode, 1, command)
            self.assertIn("standard output", done.stderr)
        # A warning must not go into the file that takes the place of the standard error.
        pathlib.Path("warns.vtk").write_text(
            "# vtk DataFile Version 3.0\nm\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
            "CELLS 2 8\n3 0 1 2\n3 0 1 9\nCELL_TYPES 2\n5 5\n")
        self.assertIn("warning", run("warns.vtk", "expected.vtu").stderr)
        for closed in ("2>&-", "<&- >&- 2>&-"):
            self.assertEqual(shell(f'"$0" warns.vtk closed.vtu {closed}').returncode, 0)
            self.assertEqual(pathlib.Path("closed.vtu").read_bytes(), pathlib.Path("expected.vtu").read_bytes())

    def test_warnings_go_to_stderr_once(self):
        pathlib.Path("broken.vtu").write_bytes(b"nonsense")
        mixed = DATA / "MixedDimensions.vtu"
        self.assertIn("left out", run(mixed, "mixed.stl").stderr)
        self.assertEqual(run(mixed, "mixed.stl", "--quiet").stderr, "")
        done = run("broken.vtu", "x.vtu")
        self.assertEqual(done.returncode, 1)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), len(set(lines)))

    def test_version(self):
        self.assertRegex(run("--version").stdout, r"\Asubdivide \d+\.\d+\.\d+, VTK 9\.\d+")
        self.assertIn(subdivisionobjects.__version__, run("--version").stdout)

    def test_progress_on_a_terminal_only(self):
        self.assertNotIn("[#", run(SHIP, "three.vtu", "--levels", 3).stderr)
        ours, its = pty.openpty()
        done = subprocess.Popen([PROGRAM, SHIP, "three.vtu", "--levels", "3"], stderr=its)
        self.assertEqual(done.wait(timeout=300), 0)
        os.close(its)
        self.assertIn(b"[#", os.read(ours, 100000))
        os.close(ours)


if __name__ == "__main__":
    unittest.main()
