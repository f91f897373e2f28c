# SPDX-License-Identifier: BSD-3-Clause
"""Singularities, joints and materials in ParaView: properties, array pickers, state files, the preset."""

import os
import shutil
import subprocess
import tempfile
import unittest
from xml.etree import ElementTree

import numpy as np
import tools
from paraview import servermanager, simple
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy

import subdivisionobjects

ARRAYS = ["SingularArray", "MaterialArray", "PartArray", "JointOfEachCell", "SharpnessArray"]
CHOICES = {
    "CreaseEnd": ["Corner", "Dart"],
    "LoopWeights": ["Standard", "Original"],
    "CellsInOtherCells": ["Ignore", "Sharp Inside", "Sharp"],
    "WhereDimensionsMeet": ["Blend", "Sharp", "Follow Dimension 1", "Follow Dimension 2", "Follow Dimension 3"],
    "WhereBranchesMeet": ["Blend", "Sharp", "Follow Part"],
    "WhereBoundariesTouch": ["Blend", "Sharp"],
}
# The names of the class, where the panel has others.
NAMES = {"CellsInOtherCells": "EmbeddedCells", "CompactIds": "Use32BitIds", "WhereDimensionsMeet": "Type1Rule", "WhereBranchesMeet": "Type2Rule",
         "WhereBoundariesTouch": "Type3Rule"}


def model(name="MaterialBlock"):
    source = simple.SubdivisionModel(Model=name)
    source.UpdatePipeline()
    return source


def subdivide(source, **options):
    """Cells are cut: the tests below count tetrahedra and triangles."""
    return simple.MultidimensionalSubdivision(Input=source, GenerateClassification=1, **{"VolumeScheme": "Standard", **options})


def elements(proxy, name):
    prop = proxy.GetProperty(name).SMProperty
    return [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]


def offered(proxy, name):
    domain = proxy.GetProperty(name).SMProperty.GetDomain("array_list")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]


def coordinates(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())


def rules(grid):
    return vtk_to_numpy(grid.GetPointData().GetArray("RuleDimension"))


def updated(proxy):
    proxy.UpdatePipeline()
    return tools.output(proxy)


def with_errors(proxy):
    """The output of a proxy and the error messages on the way."""
    messages = []

    @calldata_type("string0")
    def keep(_caller, _event, message):
        messages.append(message)

    proxy.UpdateVTKObjects()
    algorithm = proxy.GetClientSideObject()
    observed = [(one, one.AddObserver("ErrorEvent", keep)) for one in (algorithm, algorithm.GetExecutive())]
    try:
        return updated(proxy), messages
    finally:
        for one, tag in observed:
            one.RemoveObserver(tag)


def without_spellings(prop):
    """The first name of each number."""
    numbers = {}
    for text in prop.Available:
        numbers.setdefault(prop.ConvertValue(text), text)
    return list(numbers.values())


class Properties(unittest.TestCase):
    def test_choices_and_defaults(self):
        proxy = subdivide(model())
        for name, values in CHOICES.items():
            with self.subTest(name):
                self.assertEqual(without_spellings(proxy.GetProperty(name)), values)
                self.assertEqual(getattr(proxy, name), values[0])
        made = subdivisionobjects.vtkMultiDimensionalSubdivision()
        for name in (*CHOICES, "PreserveInterfaces", "DetectFeatures", "FeatureAngle", "CacheOperator", "CompactIds"):
            self.assertEqual(elements(proxy, name), [getattr(made, "Get" + NAMES.get(name, name))()], name)

    def test_entries_have_several_spellings(self):
        """Without spaces and signs, and as they were called before; what is told is the first one."""
        surface = simple.SurfaceSubdivision(Input=simple.Sphere())
        refinement = simple.RedGreenRefinement(Input=model())
        for proxy, name, told, others in (
                (surface, "Scheme", "Catmull-Clark", ["CatmullClark"]), (surface, "Scheme", "Sqrt Three", ["SqrtThree"]),
                (surface, "LoopWeights", "Original", ["Loop"]), (refinement, "Shape", "Smooth", ["Limit"]),
                (refinement, "VolumeScheme", "Even", ["Tet/Oct", "TetOct"]),
                (refinement, "VolumeScheme", "Standard", ["Box Spline", "BoxSpline"]),
                (refinement, "CellsInOtherCells", "Sharp Inside", ["SharpInside", "Singular Inside", "SingularInside"])):
            for text in [told] + others:
                setattr(proxy, name, text)
                self.assertEqual(getattr(proxy, name), told, text)
        with self.assertRaises(ValueError):
            surface.Scheme = "Catmull"

    def test_choices_reach_the_filter(self):
        proxy = subdivide(model())
        for name, values in CHOICES.items():
            for i, value in enumerate(values):
                setattr(proxy, name, value)
                proxy.UpdateVTKObjects()
                self.assertEqual(getattr(proxy.GetClientSideObject(), "Get" + NAMES.get(name, name))(), i, name)

    def test_only_what_applies_is_shown(self):
        proxy = subdivide(model())
        for name, on in (("FeatureAngle", "DetectFeatures"), ("MaterialArray", "PreserveInterfaces"),
                         ("PartArray", "Type2Rule")):
            hints = proxy.GetProperty(name).SMProperty.GetHints()
            found = []

            def collect(element):
                found.append(element.GetAttribute("property"))
                for i in range(element.GetNumberOfNestedElements()):
                    collect(element.GetNestedElement(i))

            collect(hints)
            self.assertIn(on, found, name)
            for other in filter(None, found):
                self.assertTrue(proxy.SMProxy.GetProperty(other), other)


class Arrays(unittest.TestCase):
    def test_none_is_the_default(self):
        proxy = subdivide(model())
        for i, name in enumerate(ARRAYS):
            self.assertEqual(elements(proxy, name), [str(i), "0", "0", "1", "None"], name)

    def test_a_name_is_enough(self):
        """So None is one of cells, although ParaView knows the entry for points only (ArrayWidget). A name
        for points would have ParaView make a point array of the cell array, and the output would have that, too."""
        made = []
        for value in ("MaterialId", ["CELLS", "MaterialId"]):
            proxy = subdivide(model())
            proxy.SingularArray = value
            made.append(tools.numbers(updated(proxy)))
        self.assertEqual(made[0], made[1])

    def test_only_fitting_arrays_are_offered(self):
        source = model()
        for name, function, kind in (("Reals", "MaterialId + 0.5", "Double"), ("Labels", "MaterialId", "Int"),
                                     ("Vectors", "MaterialId * iHat", "Double")):
            source = simple.Calculator(Input=source, AttributeType="Cell Data", ResultArrayName=name,
                                       Function=function, ResultArrayType=kind)
        source = simple.Calculator(Input=source, ResultArrayName="PointLabels", Function="1", ResultArrayType="Int")
        source.UpdatePipeline()
        proxy = subdivide(source)
        integers = {"None", "MaterialId", "Singular", "Labels"}
        for name in ("SingularArray", "PartArray", "JointOfEachCell"):
            self.assertEqual(set(offered(proxy, name)), integers, name)
        self.assertEqual(set(offered(proxy, "MaterialArray")), integers | {"Reals"})
        self.assertEqual(set(offered(proxy, "SharpnessArray")), {"None", "Reals"})

    def test_set_and_unset(self):
        proxy = subdivide(model())
        for name in ARRAYS:
            for value, expected in ((["CELLS", "Singular"], "Singular"), ("None", "None"), ("Singular", "Singular"),
                                    (["CELLS", "None"], "None")):
                setattr(proxy, name, value)
                self.assertEqual(elements(proxy, name)[3:], ["1", expected], name)
                self.assertEqual(getattr(proxy, name)[1], expected)
        self.assertGreater(updated(proxy).GetNumberOfCells(), 0)

    def test_no_cell_arrays_at_all(self):
        cone = simple.Cone()
        cone.UpdatePipeline()
        proxy = subdivide(cone)
        for name in ARRAYS:
            self.assertEqual(offered(proxy, name), ["None"])
        self.assertGreater(updated(proxy).GetNumberOfCells(), 0)

    def test_another_name_for_the_flags(self):
        part = model("MechanicalPart")
        renamed = simple.Calculator(Input=part, AttributeType="Cell Data", ResultArrayName="Flags",
                                    Function="Singular", ResultArrayType="Int")
        plain = simple.PassArrays(Input=renamed, CellDataArrays=["Flags"], PointDataArrays=["Tension"])
        plain.UpdatePipeline()
        wanted = coordinates(updated(subdivide(part)))
        named = subdivide(plain, SingularArray=["CELLS", "Flags"])
        self.assertTrue((coordinates(updated(named)) == wanted).all())
        named.SingularArray = "None"
        self.assertFalse((coordinates(updated(named)) == wanted).all())

    def test_a_missing_array_is_an_error(self):
        for name in ARRAYS:
            with self.subTest(name):
                proxy = subdivide(model(), **{name: ["CELLS", "Nowhere"]})
                grid, messages = with_errors(proxy)
                self.assertEqual(grid.GetNumberOfCells(), 0)
                self.assertTrue(any('"Nowhere"' in message for message in messages), messages)
                setattr(proxy, name, "None")
                grid, messages = with_errors(proxy)
                self.assertGreater(grid.GetNumberOfCells(), 0)
                self.assertEqual(messages, [])

    def test_interfaces_need_materials(self):
        grid, messages = with_errors(subdivide(simple.Cone(), PreserveInterfaces=1))
        self.assertEqual(grid.GetNumberOfCells(), 0)
        self.assertTrue(any('"Preserve Interfaces"' in message for message in messages), messages)


class Interfaces(unittest.TestCase):
    """MaterialBlock: the interface is a step, from z = 1 to z = 2 at x = 1."""

    @staticmethod
    def on_interface(x):
        return ((x[:, 2] == 1) & (x[:, 0] <= 1)) | ((x[:, 2] == 2) & (x[:, 0] >= 1)) | (
            (x[:, 0] == 1) & (x[:, 2] >= 1) & (x[:, 2] <= 2))

    def test_rules_of_the_control_mesh(self):
        proxy = subdivide(model(), NumberOfLevels=0)
        before = updated(proxy)
        x = coordinates(before)
        interface = self.on_interface(x)
        border = (x[:, 1] % 2 == 0) | (x[:, 0] % 2 == 0)
        self.assertTrue((rules(before)[interface & ~border] == 3).all())
        proxy.PreserveInterfaces = 1
        after = rules(updated(proxy))
        self.assertEqual((interface.sum(), (interface & ~border).sum()), (12, 2))
        self.assertTrue((after[interface & ~border] == 2).all())  # inside the singular surface
        self.assertTrue((after[interface & border] == 1).all())  # its border is a curve
        self.assertTrue((after[~interface] == rules(before)[~interface]).all())

    def test_children_keep_the_material_and_the_interface(self):
        proxy = subdivide(model(), NumberOfLevels=2, PreserveInterfaces=1, GenerateOriginalIds=1)
        smooth = updated(proxy)
        cells = vtk_to_numpy(smooth.GetCells().GetConnectivityArray()).reshape(-1, 4)
        material = vtk_to_numpy(smooth.GetCellData().GetArray("MaterialId"))
        both = np.intersect1d(cells[material == 0], cells[material == 1])
        self.assertEqual(set(rules(smooth)[both]), {1, 2})
        # 3 x 2 quads, so 12 triangles with 16 children each: 9 x 13 points.
        self.assertEqual(len(both), 13 * 9)
        default = subdivide(model(), NumberOfLevels=2)
        self.assertFalse((coordinates(updated(default)) == coordinates(smooth)).all())

    def test_the_material_array_by_name(self):
        wanted = coordinates(updated(subdivide(model(), PreserveInterfaces=1)))
        proxy = subdivide(model(), PreserveInterfaces=1, MaterialArray=["CELLS", "MaterialId"])
        self.assertTrue((coordinates(updated(proxy)) == wanted).all())
        proxy.MaterialArray = ["CELLS", "Singular"]  # the same everywhere: no interface
        self.assertFalse((coordinates(updated(proxy)) == wanted).all())


class Features(unittest.TestCase):
    def test_angle(self):
        block = model()
        round_ = coordinates(updated(subdivide(block)))
        proxy = subdivide(block, DetectFeatures=1)
        self.assertTrue((np.ptp(coordinates(updated(proxy)), axis=0) == (2, 2, 3)).all())  # corners stay
        proxy.FeatureAngle = 120
        self.assertTrue((coordinates(updated(proxy)) == round_).all())


class Files(unittest.TestCase):
    def test_state(self):
        choices = dict(NumberOfLevels=2, SingularArray=["CELLS", "Singular"], MaterialArray=["CELLS", "MaterialId"],
                       PreserveInterfaces=1, DetectFeatures=1, FeatureAngle=42.0, CreaseEnd="Dart",
                       LoopWeights="Original", CellsInOtherCells="Sharp Inside", WhereDimensionsMeet="Follow Dimension 2",
                       WhereBranchesMeet="Sharp", WhereBoundariesTouch="Sharp", CacheOperator=0, CompactIds=1)
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        proxy = subdivide(model("MechanicalPart"), **choices)
        wanted = {name: elements(proxy, name) for name in (*choices, *ARRAYS)}
        shape = tools.numbers(updated(proxy))
        servermanager.SaveState("features.pvsm")
        self.write_as_before("features.pvsm", "older.pvsm")
        for state in ("features.pvsm", "older.pvsm"):
            simple.ResetSession()
            simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
            simple.LoadState(state)
            found = [source for (name, _), source in simple.GetSources().items() if "Multi" in name]
            self.assertEqual(len(found), 1)
            self.assertEqual({name: elements(found[0], name) for name in wanted}, wanted)
            self.assertEqual(tools.numbers(updated(found[0])), shape)

    def write_as_before(self, state, older):
        """As it was before the panel had presets and other words: names of properties and numbers are all that counts."""
        tree = ElementTree.parse(state)
        (proxy,) = [one for one in tree.iter("Proxy") if one.get("type") == "MultiDimensionalSubdivision"]
        names = {element.get("name") for element in proxy.iter("Property")}
        self.assertLessEqual({"EmbeddedCells", "Use32BitIds", "LoopWeights", "Type1Rule", "RuleArray"}, names)
        for element in proxy.findall("Property"):
            if element.get("name") == "Preset":
                proxy.remove(element)
            for domain in element.findall("Domain"):
                element.remove(domain)
        tree.write(older)

    def test_preset(self):
        with tempfile.TemporaryDirectory() as home:  # of a user who never imported it
            script = os.path.join(home, "script.py")
            with open(script, "w", encoding="utf-8") as file:
                file.write("import sys\n"
                           f"sys.path.insert(0, {os.path.dirname(os.path.abspath(__file__))!r})\n"
                           "import tools\n"
                           "table = tools.simple.GetColorTransferFunction('RuleDimension')\n"
                           "table.ApplyPreset('Subdivision Rules', False)\n"  # true even for what is not there
                           "print(len(table.Annotations))\n")
            ran = subprocess.run([shutil.which("pvpython"), "--force-offscreen-rendering", script],
                                 env=dict(os.environ, HOME=home, XDG_CONFIG_HOME=home), stdout=subprocess.PIPE,
                                 text=True, timeout=100)
        self.assertEqual(ran.stdout.split()[-1:], ["10"])
        table = simple.GetColorTransferFunction("RuleDimension")
        self.assertTrue(table.ApplyPreset("Subdivision Rules", False))
        preset = os.path.join(os.path.dirname(tools.plugin), "RuleDimensionColors.json")
        self.assertTrue(os.path.isfile(preset), preset)
        self.assertTrue(simple.ImportPresets(preset))
        self.assertEqual(table.InterpretValuesAsCategories, 1)
        self.assertEqual(list(table.Annotations)[::2], list("01234"))
        colours = np.reshape(list(table.IndexedColors), (5, 3))
        self.assertEqual(len(np.unique(colours, axis=0)), 5)
        # red, green, blue; orange; violet
        self.assertEqual([int(colour.argmax()) for colour in colours], [0, 1, 2, 0, 2])


if __name__ == "__main__":
    tools.main()
