# SPDX-License-Identifier: BSD-3-Clause
"""What the documentation of the classes and the XML of the plugin state, against the classes themselves."""

import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData, vtkSphere

import subdivisionobjects
from headers import HEADERS, NO_OPTIONS, along_axes, of_bases, stated_defaults, stated_ranges, words

PLUGIN = pathlib.Path(__file__).resolve().parents[2] / "Plugin"
ABSTRACT = (subdivisionobjects.vtkSubdivisionAlgorithm, subdivisionobjects.vtkRefinementAlgorithm,
            subdivisionobjects.vtkMarkedSubdivisionAlgorithm, subdivisionobjects.vtkUniformSubdivisionAlgorithm)
CONCRETE = [cls for cls in HEADERS if cls not in ABSTRACT]
PRECISIONS = ["SINGLE_PRECISION", "DOUBLE_PRECISION", "DEFAULT_PRECISION"]

# Properties whose default is not that of the class, and why.
OTHER_DEFAULTS = {
    "AdaptiveSurfaceSubdivision.ImplicitFunction": "ParaView takes the first proxy of the list; the class has none",
    "RedGreenRefinement.ImplicitFunction": "the same",
    "MultiDimensionalSubdivision.MarkFunction": "the same",
    "SimplicialComplexTopology.MarkFunction": "the same",
    "SubdivisionLimitProbe.MarkFunction": "the same",
    "SubdivisionMeasures.MarkFunction": "the same",
    "SubdivisionSampler.MarkFunction": "the same",
    "SubdivisionSmoothness.MarkFunction": "the same",
    "SurfaceSubdivision.MarkFunction": "the same",
}
# Options and arrays without a property: surfaces have no rules for them, and the filters warn of them.
SURFACES = ("SurfaceSubdivision", "AdaptiveSurfaceSubdivision")
NOT_OFFERED = {f"{name}.{option}" for name in SURFACES for option in ("EmbeddedCells",)}
# Filters without rules to interpolate.
NOT_INTERPOLATED = ("AdaptiveSurfaceSubdivision", "SimplicialComplexTopology", "SubdivisionDeformation", "SubdivisionSmoothness")
NOT_OFFERED |= {f"{name}.{option}" for name in NOT_INTERPOLATED
                for option in ("InterpolatePoints", "InterpolateArrays", "InterpolationWeight")}
NOT_OFFERED |= {"SubdivisionCageSource.Hug"}  # it has no input
# Options of the mesh that comes out of their base class, where these have a table and an image.
NOT_OFFERED |= {f"{name}.{option}" for name in ("SubdivisionMeasures", "SubdivisionSampler") for option in (
    "NumberOfLevels", "ProjectToLimit", "GenerateLimitNormals", "SmoothShading", "GenerateTangents", "GenerateErrorBounds",
    "GenerateClassification", "OutputCells", "CellOrder", "BezierTolerance", "CacheOperator", "Use32BitIds")}
ARRAYS_NOT_OFFERED = {2, 3}


class Documentation(unittest.TestCase):
    def for_options(self, check):
        for cls in CONCRETE:
            for name, option in of_bases(cls, "options").items():
                with self.subTest(f"{cls.__name__}.{name}"):
                    check(cls(), option)

    def test_headers_have_the_options_of_the_classes(self):
        for cls, header in HEADERS.items():
            made = {name[3:] for name in vars(cls) if name.startswith("Set") and "Get" + name[3:] in vars(cls)}
            self.assertEqual(set(header.options), made - NO_OPTIONS, cls.__name__)

    def test_defaults(self):
        def check(made, option):
            stated = stated_defaults(option.text)
            self.assertEqual(len(stated), 1, f"the comment has to state one default: {option.text}")
            here = of_bases(type(made), "here")
            value = option.get(made)
            self.assertEqual(along_axes(here.get(option.name, stated[0]), value), value, option.text)
        self.for_options(check)

    def test_ranges(self):
        def check(made, option):
            if not option.clamp:
                return self.assertEqual(stated_ranges(option.text), [], "a range is stated, but nothing clamps")
            low, high = option.ends(type(made))
            if option.is_enumeration:
                stated = [int(n) for pair in re.findall(r"\((\d+)(?: to (\d+))?", option.text) for n in pair if n]
                self.assertEqual((min(stated), max(stated)), (low, high), option.text)
                for name, value in re.findall(r"\b([A-Z][A-Z0-9_]+) \((\d+)", option.text):
                    self.assertEqual(option.constant(type(made), name), int(value), name)
            else:
                self.assertEqual(stated_ranges(option.text), [(low, high)], option.text)
            number_type = type(option.get(made)[0])
            most = high or number_type(1e18)
            for value, kept in ((low, low), (low - 1, low), (most, most)) + (((high + 1, high),) if high else ()):
                option.set(made, number_type(value))
                self.assertEqual(option.get(made), (kept,), f"after {value} was set")
        self.for_options(check)

    def test_print_self(self):
        def check(made, option):
            line = re.compile(rf"^\s*{option.name}: (.*)$", re.M)
            before = line.findall(str(made))
            value = option.change(made)
            after = line.findall(str(made))
            self.assertEqual((len(before), len(after)), (1, 1), "lines of PrintSelf")
            self.assertNotEqual(before, after)
            if hasattr(made, f"Get{option.name}AsString"):
                self.assertEqual(after, [getattr(made, f"Get{option.name}AsString")()])
            elif not isinstance(value[0], vtkSphere):
                self.assertEqual(tuple(float(part) for part in after[0].split()), value)
        self.for_options(check)


def numbers(name, components, size, value=0.):
    array = vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfComponents(components)
    for _ in range(size):
        array.InsertNextTuple([value] * components)
    return array


def required(made, port):
    return made.GetInputPortInformation(port).Get(made.INPUT_REQUIRED_DATA_TYPE())


def complaints(cls, criteria, index=0, kind="Cell", name="None", fallback=None):
    """Kind, name, index and fault of all arrays that a filter complains about, with these criteria on and the
    array of this name at the index. An array `fallback` of the input is unusable: it has two components."""
    made = cls()
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    for point in ((0, 0, 0), (1, 0, 0), (0, 1, 0)):
        data.GetPoints().InsertNextPoint(point)
    data.SetPolys(vtkCellArray())
    data.GetPolys().InsertNextCell(3, (0, 1, 2))
    if required(made, 0) == "vtkImageData":
        data = vtkImageData()
        data.SetDimensions(2, 2, 2)
    data.GetPointData().SetScalars(numbers("floating", 1, data.GetNumberOfPoints()))
    data.GetCellData().SetScalars(numbers("floating", 1, 1))
    for side in (data.GetPointData(), data.GetCellData()):
        side.AddArray(numbers("fractions", 1, side.GetScalars().GetNumberOfTuples(), 0.5))
    if fallback:
        data.GetCellData().AddArray(numbers(fallback, 2, 1))
    for port in range(made.GetNumberOfInputPorts()):
        if port == 0 or required(made, port) not in ("vtkSelection", "vtkTable", "vtkImageData"):
            made.SetInputDataObject(port, data)
    for option in of_bases(cls, "options"):
        if option.startswith("RefineBy"):
            getattr(made, "Set" + option)(option in criteria)
    made.SetInputArrayToProcess(index, 0, 0, int(kind == "Cell"), name)
    messages = []

    @calldata_type(VTK_STRING)
    def listen(_, __, message):
        messages.append(message)

    for source in (made, made.GetExecutive()):
        for event in ("ErrorEvent", "WarningEvent"):
            source.AddObserver(event, listen)
    made.Update()
    return [(kind, name, int(index), fault) for message in messages for kind, name, index, fault in
            re.findall(r'(Cell|Point) array "(\w+)" \(array index (\d+)\) (.*)', message)]


class Arrays(unittest.TestCase):
    def test_indices_of_the_code(self):
        for cls, header in HEADERS.items():
            self.assertEqual(set(header.arrays), set(header.indices), cls.__name__)
            for index, word in header.indices.items():
                self.assertIn(word, header.arrays[index].text.lower(), f"{cls.__name__}, array index {index}")

    def test_filters_look_there(self):
        for cls in (cls for cls in CONCRETE if of_bases(cls, "arrays")):
            listed = of_bases(cls, "arrays")
            for index in range(max(listed) + 4):
                for kind in ("Cell", "Point"):
                    with self.subTest(f"{cls.__name__}, {kind.lower()} array at index {index}"):
                        self.check(cls, listed, index, kind)

    def check(self, cls, listed, index, kind):
        every = {entry.criterion for entry in listed.values()}
        told = [found[:3] for found in complaints(cls, every, index, kind, "missing")]
        if index not in listed:
            return self.assertEqual(told, [])
        entry = listed[index]
        self.assertEqual(told, [(kind if kind in entry.kinds else entry.kinds[0], "missing", index)])
        self.assertTrue(complaints(cls, {entry.criterion}, index, kind, "missing"))
        others = complaints(cls, every - {entry.criterion}, index, kind, "missing")
        self.assertEqual(bool(others), not entry.criterion, entry.text)
        told = str(complaints(cls, every, index, kind, "fractions"))
        self.assertEqual("must hold integers" in told, entry.is_integer, f"{entry.text}: {told}")
        told = str(complaints(cls, every, index, kind, "floating"))
        self.assertNotIn("must hold integers", told)
        if entry.fallback:
            told = [found[:3] for found in complaints(cls, every, fallback=entry.fallback)]
            self.assertEqual(told, [("Cell", entry.fallback, index)])


def proxies():
    """Of each proxy of a concrete class: name, class, and properties with those of its base proxies."""
    texts = [path.read_text(encoding="utf-8") for path in sorted(PLUGIN.glob("*.xml"))]
    interpolation = (PLUGIN / "Interpolation.xml.in").read_text(encoding="utf-8")
    texts = [text.replace("@INTERPOLATION@", interpolation) for text in texts]
    for_solids = (PLUGIN / "SolidOptions.xml.in").read_text(encoding="utf-8")
    texts += [for_solids.replace("@KIND@", kind) for kind in ("Subdivision", "MarkedSubdivision", "Refinement")]
    found = {proxy.get("name"): proxy for text in texts
             for proxy in ElementTree.fromstring(text).iter("SourceProxy")}
    for name, proxy in found.items():
        cls = getattr(subdivisionobjects, proxy.get("class"))
        if cls in CONCRETE:
            chain = [proxy]
            while chain[0].get("base_proxyname"):
                chain.insert(0, found[chain[0].get("base_proxyname")])
            yield name, cls, {child.get("name"): child for one in chain for child in one if child.get("command")}


class Proxies(unittest.TestCase):
    def test_every_option_is_offered(self):
        self.assertEqual({cls for _, cls, _ in proxies()}, set(CONCRETE))
        missing = {f"{name}.{option}" for name, cls, properties in proxies()
                   for option in of_bases(cls, "options") if option not in properties}
        self.assertEqual(missing, NOT_OFFERED)

    def test_options(self):
        left_out = set()
        for name, cls, properties in proxies():
            for key, element in properties.items():
                if f"{name}.{key}" in OTHER_DEFAULTS:
                    left_out.add(f"{name}.{key}")
                elif element.get("clean_command") and element.get("default_values"):
                    with self.subTest(f"{name}.{key}"):
                        self.check_set(of_bases(cls, "options")[key], cls, element)
                elif element.get("command") not in ("SetInputConnection", "SetInputArrayToProcess",
                                                     "AddInterpolatedArray", "AddFieldOfCells", "AddPaintedArray"):
                    with self.subTest(f"{name}.{key}"):
                        # Panels show numbers of 64 bits as doubles only.
                        self.assertEqual(element.get("command").replace("AsDouble", ""), "Set" + key)
                        self.check_option(of_bases(cls, "options")[key], cls, element)
        self.assertEqual(left_out, set(OTHER_DEFAULTS))

    def check_option(self, option, cls, element):
        default = option.get(cls())
        tooltip = words(element.findtext("Documentation"))
        self.assertEqual(tuple(float(part) for part in element.get("default_values").split()), default)
        self.assertEqual(element.find("BooleanDomain") is not None, isinstance(default[0], bool))
        if option.is_enumeration:
            entries = {entry.get("text"): int(entry.get("value")) for entry in element.iter("Entry")}
            self.check_entries(option, cls, {entry.get("also", entry.get("text")): int(entry.get("value"))
                                             for entry in element.iter("Entry")})
            stated = [(value,) for text, value in entries.items() if text + " (the default" in tooltip]
        else:
            stated = [along_axes(one, default) for one in stated_defaults(tooltip)]
            if option.clamp:
                self.check_range(*option.ends(cls), element, tooltip)
        self.assertEqual(stated, [default], f"the tooltip has to state the default: {tooltip}")

    def check_set(self, option, cls, element):
        """A set of numbers, each a check box, which is a sum of powers of 2 in the class."""
        self.assertEqual((element.get("command"), element.get("clean_command")),
                         ("Add" + option.name[:-1], "Clear" + option.name))
        made = cls()
        getattr(made, element.get("clean_command"))()
        for number in element.get("default_values").split():
            getattr(made, element.get("command"))(int(number))
        self.assertEqual(option.get(made), option.get(cls()))
        names = [entry.get("text") for entry in element.iter("Entry")]
        for value, name in enumerate(names):
            getattr(made, element.get("clean_command"))()
            getattr(made, element.get("command"))(value)
            self.assertEqual(option.get(made), (getattr(cls, name.upper()),))
        default = "all" if len(element.get("default_values").split()) == len(names) else names[
            int(element.get("default_values"))]
        self.assertRegex(words(element.findtext("Documentation")), f"{default} by default")

    def check_entries(self, option, cls, entries):
        low, high = option.ends(cls)
        self.assertEqual(sorted(entries.values()), list(range(low, high + 1)))
        scope = getattr(subdivisionobjects, option.scope) if option.scope else cls
        names = next((names for base in scope.__mro__ if base in HEADERS for names in HEADERS[base].enumerations
                      if option.clamp[0].rpartition("::")[2] in names), PRECISIONS)
        for text, value in entries.items():
            text = re.sub(r"\W", "", text.replace("Same as input", "Default"))
            word = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", text).upper()
            self.assertTrue([n for n in names if word in n and option.constant(cls, n) == value],
                            f"{text} is not {value}")
            if hasattr(cls, f"Set{option.name}To{text}"):
                made = cls()
                getattr(made, f"Set{option.name}To{text}")()
                self.assertEqual(option.get(made), (value,), text)

    def check_range(self, low, high, element, tooltip):
        entries = [(entry.get("text"), int(entry.get("value"))) for entry in element.iter("Entry")]
        if entries:  # a list of some of the numbers
            self.assertEqual([text for text, _ in entries], [str(value) for _, value in entries])
            self.assertEqual((min(entries)[1], max(entries)[1]), (low, high))
            self.assertIn(f"{', '.join(text for text, _ in entries[:-1])} or {entries[-1][0]}", tooltip)
            return
        domains = [child for child in element if child.tag in ("IntRangeDomain", "DoubleRangeDomain")]
        self.assertEqual([float(domain.get("min")) for domain in domains], [low])
        most = domains[0].get("max")
        self.assertTrue(most or high is None, "the range has no end, but values are clamped")
        if most and float(most) != high:  # numbers beyond the slider can be typed: the tooltip has the whole range
            self.assertLess(float(most), high or float("inf"))
            self.assertEqual(stated_ranges(tooltip), [(low, high)])
        self.assertIn(stated_ranges(tooltip), ([], [(low, high)]))

    def test_arrays(self):
        for name, cls, properties in proxies():
            found = {int(element.get("default_values").split()[0]): key for key, element in properties.items()
                     if element.get("command") == "SetInputArrayToProcess"}
            left_out = (ARRAYS_NOT_OFFERED if name in SURFACES else set()) | ({13} if name in NOT_INTERPOLATED else set())
            self.assertEqual(set(found) | left_out, set(of_bases(cls, "arrays")), name)
            self.assertEqual(set(found) & left_out, set(), name)
            for index, key in found.items():
                with self.subTest(f"{name}.{key}"):
                    self.check_array(of_bases(cls, "arrays")[index], key, properties)

    def check_array(self, entry, key, properties):
        element = properties[key]
        tooltip = words(element.findtext("Documentation"))
        self.assertIn(key[:-len("Array")].lower(), entry.text.lower())
        types = element.find("ArrayListDomain").get("data_type").split()
        self.assertFalse(entry.is_integer and {"10", "11"} & set(types), "arrays of floats are offered")
        self.assertIn(" or ".join(sorted(entry.kinds)[::-1]).lower() + " array", tooltip.lower())
        if entry.fallback:
            self.assertIn(f"array {entry.fallback},", tooltip)
        if len(entry.kinds) == 1:  # of two kinds, ParaView sets a kind together with the array
            port = properties[element.find(".//RequiredProperties/Property").get("name")].get("port_index", "0")
            default = [port, "0", str(int(entry.kinds == ["Cell"])), "None"]
            self.assertEqual(element.get("default_values").split()[1:], default)
            self.assertRegex(tooltip, r"None (\(the default\)|by default)")


if __name__ == "__main__":
    unittest.main()
