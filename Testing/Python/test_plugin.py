# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin offers: its proxies, their names, every option of every class, and help for each."""

import pathlib
import re
import unittest
from xml.etree import ElementTree

import numpy as np
import tools
from headers import NO_OPTIONS
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

import subdivisionobjects

HEADERS = pathlib.Path(__file__).resolve().parents[2] / "Filters"
PLUGIN = HEADERS.parent / "Plugin"
MODELS = ["MixedDimensions", "Screw", "SpringAndValve", "Ship", "MechanicalPart", "Character", "MaterialBlock",
          "Cylinder"]
# Those with the options that filters share.
FILTERS = ["AdaptiveSurfaceSubdivision", "MultiDimensionalSubdivision", "RedGreenRefinement", "SimplicialComplexTopology",
           "SubdivisionDeformation", "SubdivisionLimitProbe", "SubdivisionSmoothness", "SurfaceSubdivision"]


def definition(name):
    """The proxy of a class (its name without vtk)."""
    for group in ("filters", "sources"):
        if servermanager.ProxyManager().GetPrototypeProxy(group, name):
            return servermanager.ProxyManager().GetPrototypeProxy(group, name)
    return None


def properties(proxy):
    iterator = proxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey(), iterator.GetProperty()
        iterator.Next()


def nested(element, name):
    """All elements of this name in one, as ParaView reads its XML."""
    for i in range(element.GetNumberOfNestedElements() if element else 0):
        child = element.GetNestedElement(i)
        yield from [child] * (child.GetName() == name)
        yield from nested(child, name)


def is_of_scripts(key, prop):
    """Whether panels show an option only when it is set already, or never."""
    decorators = {hint.GetAttribute("property") for hint in nested(prop.GetHints(), "PropertyWidgetDecorator")}
    has_no_widget = prop.IsA("vtkSMInputProperty") and not list(nested(prop.GetHints(), "SelectionInput"))
    traced = {hint.GetAttribute("property") for hint in nested(prop.GetHints(), "TracedIf")}
    return prop.GetPanelVisibility() == "never" or key in decorators or "MarkByFunction" in traced or (
        has_no_widget and key in traced)


def updated(proxy):
    proxy.UpdatePipeline()
    return tools.output(proxy)


def options(cls):
    """The options of a class, by their C++ setters, those of our own base classes included."""
    found = set()
    for ours in cls.__mro__:
        if ours.__name__ in vars(subdivisionobjects):
            found |= {name[3:] for name in vars(ours) if name.startswith("Set")
                      and "Get" + name[3:] in vars(ours)}
    return found - NO_OPTIONS


class Package(unittest.TestCase):
    def test_offers_every_class(self):
        headers = [header.stem for header in HEADERS.glob("vtk*.h")]
        self.assertGreaterEqual(len(headers), 3)
        for name in headers:
            self.assertTrue(hasattr(subdivisionobjects, name), name)

    def test_every_class_has_a_proxy(self):
        for name, cls in vars(subdivisionobjects).items():
            if not name.startswith("vtk") or not isinstance(cls, type) or not issubclass(cls, vtkAlgorithm):
                continue
            if name in ("vtkSubdivisionAlgorithm", "vtkRefinementAlgorithm", "vtkMarkedSubdivisionAlgorithm",
                        "vtkUniformSubdivisionAlgorithm"):  # abstract
                continue
            with self.subTest(name):
                proxy = definition(name[3:])
                self.assertIsNotNone(proxy)
                self.assertEqual(proxy.GetVTKClassName(), name)
                names = {key for key, _ in properties(proxy)}
                without = {"EmbeddedCells"} if "Surface" in name else set()
                without |= {"Hug"} if name == "vtkSubdivisionCageSource" else set()  # of its filter, Cage Around
                if name in ("vtkSubdivisionMeasures", "vtkSubdivisionSampler"):  # no mesh that these could change
                    without |= {"NumberOfLevels", "ProjectToLimit", "GenerateLimitNormals", "SmoothShading", "GenerateTangents",
                                "GenerateErrorBounds", "GenerateClassification", "OutputCells", "CellOrder",
                                "BezierTolerance",
                                "CacheOperator", "Use32BitIds"}
                if name not in ("vtkMultiDimensionalSubdivision", "vtkRedGreenRefinement", "vtkSubdivisionLimitProbe",
                                "vtkSubdivisionMeasures", "vtkSubdivisionSampler", "vtkSurfaceSubdivision"):
                    without |= options(cls) & {"InterpolatePoints", "InterpolateArrays", "InterpolationWeight"}
                self.assertEqual(options(cls) - names, without, "options without a property")


class Proxies(unittest.TestCase):
    expected = {
        "MultiDimensionalSubdivision": ("Multi-dimensional Subdivision", "MultidimensionalSubdivision"),
        "SubdivisionModelSource": ("Subdivision Model", "SubdivisionModel"),
        "SubdivisionCageSource": ("Cage", "Cage"),
        "SubdivisionLabelSolid": ("Smooth Solid from Labels", "SmoothSolidfromLabels"),
        "SubdivisionMeasures": ("Measure Smooth Object", "MeasureSmoothObject"),
        "SubdivisionEdit": ("Edit Selection", "EditSelection"),
        "SubdivisionSampler": ("Sample Smooth Object", "SampleSmoothObject"),
        "ExtractDimensions": ("Extract Dimensions", "ExtractDimensions"),
    }

    def test_names_and_menus(self):
        for name, (label, python_name) in self.expected.items():
            with self.subTest(name):
                proxy = definition(name)
                self.assertEqual(proxy.GetXMLLabel(), label)
                self.assertTrue(callable(getattr(simple, python_name)))
                menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
                self.assertEqual(menu.GetAttribute("category"), "Subdivision Objects")

    def test_help(self):
        for name in self.expected:
            proxy = definition(name)
            help_texts = proxy.GetDocumentation()
            self.assertTrue(help_texts.GetShortHelp() and help_texts.GetLongHelp(), name)
            self.assertGreater(len(help_texts.GetDescription()), 100, name)
            for key, prop in properties(proxy):
                with self.subTest(name + "." + key):
                    self.assertIn(prop.GetPanelVisibility(), ("default", "advanced", "never"))
                    if key != "Input":
                        self.assertIn("default", prop.GetDocumentation().GetDescription().lower())
                    self.assertGreater(len(prop.GetDocumentation().GetDescription().strip()), 60)

    def test_groups(self):
        proxy = definition("MultiDimensionalSubdivision")
        grouped = set()
        for i in range(proxy.GetNumberOfPropertyGroups()):
            group = proxy.GetPropertyGroup(i)
            self.assertTrue(group.GetXMLLabel())
            grouped |= {group.GetPropertyName(j) for j in range(group.GetNumberOfProperties())}
        names = {key for key, prop in properties(proxy) if not is_of_scripts(key, prop)} - {"Input", "NextApply"}
        self.assertEqual(names - grouped, set())

    def test_sharp_features_are_in_one_group(self):
        """Options of corners, creases and singular surfaces, where a filter has them."""
        sharp = {"CornerAngleArray", "CreaseGeometry", "FlatnessArray", "LevelsArray", "MarkSurfaces"}
        for name in ("MultiDimensionalSubdivision", "SurfaceSubdivision", "RedGreenRefinement", "AdaptiveSurfaceSubdivision"):
            proxy = definition(name)
            groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
            (group,) = [group for group in groups if group.GetXMLLabel() == "Sharp features"]
            named = {group.GetPropertyName(k) for k in range(group.GetNumberOfProperties())}
            self.assertEqual(sharp & {key for key, _ in properties(proxy)}, sharp & named, name)

    def test_groups_after_the_first_are_collapsible(self):
        """What a filter is for stays in sight; the names of the other groups are keys of ParaView's settings."""
        plain = set()
        for name in FILTERS:
            proxy = definition(name)
            keys = {key for key, _ in properties(proxy)}
            groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
            self.assertEqual(len({group.GetName() for group in groups}), len(groups), name)
            for group in groups:
                with self.subTest(name + "." + group.GetName()):
                    # The widget of a group makes a panel of its properties: one of the group's name would be the group.
                    self.assertNotIn(group.GetXMLLabel().replace(" ", ""), keys)
                    if group.GetPanelWidget() != "SubdivisionObjectsGroup":
                        plain.add((name, group.GetName()))
        self.assertEqual(plain, {
            ("AdaptiveSurfaceSubdivision", "Criteria"), ("AdaptiveSurfaceSubdivision", "Refinement"),
            ("MultiDimensionalSubdivision", "Subdivision"), ("RedGreenRefinement", "Criteria"),
            ("RedGreenRefinement", "Refinement"), ("SimplicialComplexTopology", "Topology"),
            ("SubdivisionDeformation", "Deformation"), ("SubdivisionSmoothness", "Smoothness")})

    def test_own_properties_stand_first(self):
        """Then those that filters share. Of these a filter replaces some, where they stand."""
        shared = (PLUGIN / "Interpolation.xml.in").read_text(encoding="utf-8")
        criteria = (PLUGIN / "RefinementAlgorithm.xml").read_text(encoding="utf-8")
        criteria = criteria[criteria.index("      </Documentation>\n") + 23:criteria.index("    </SourceProxy>")]
        for name in FILTERS:
            text = (PLUGIN / f"{name}.xml").read_text(encoding="utf-8").replace("@INTERPOLATION@", shared)
            text = text.replace("@REFINEMENT@", criteria)
            elements = [element for element in next(ElementTree.fromstring(text).iter("SourceProxy"))
                        if element.get("command") or element.get("name") in ("Preset", "NextApply")]
            own = {element.get("name") for element in elements if not element.get("override")} - {"Input"}
            iterator = servermanager.vtkSMOrderedPropertyIterator()
            iterator.SetProxy(definition(name))
            iterator.Begin()
            order = []
            while not iterator.IsAtEnd():
                order.append(iterator.GetKey())
                iterator.Next()
            self.assertEqual(order[0], "Input")
            self.assertEqual(set(order[1:len(own) + 1]), own, name)
            self.assertLessEqual({element.get("name") for element in elements}, set(order))

    def test_model_names(self):
        source = simple.SubdivisionModel()
        self.assertEqual(source.Model, "MixedDimensions")
        self.assertEqual(source.GetProperty("Model").Available, MODELS)
        self.assertEqual(source.OutputPointsPrecision, "Double")
        for i, name in enumerate(MODELS):
            self.assertEqual(subdivisionobjects.vtkSubdivisionModelSource.GetModelName(i), name)

    def test_entries_are_named_as_in_the_classes(self):
        named = set()
        for name, cls in vars(subdivisionobjects).items():
            proxy = definition(name[3:]) if name.startswith("vtk") else None
            for key, prop in properties(proxy) if proxy else ():
                domain = prop.FindDomain("vtkSMEnumerationDomain")
                setters = [member for member in dir(cls) if member.startswith(f"Set{key}To")]
                if domain and setters:
                    numbers = {}
                    for i in range(domain.GetNumberOfEntries()):
                        text = re.sub(r"\W", "", domain.GetEntryText(i))
                        numbers.setdefault(domain.GetEntryValue(i), set()).add(f"Set{key}To{text}")
                    for number, spellings in numbers.items():
                        with self.subTest(f"{name}.{key}", spellings=spellings):
                            (setter,) = spellings & set(setters)
                            made = cls()
                            getattr(made, setter)()
                            self.assertEqual(getattr(made, f"Get{key}")(), number)
                    self.assertEqual(len(numbers), len(setters), f"{name}.{key}")
                    named.add(key)
        self.assertLessEqual({"Model", "Scheme", "VolumeScheme", "Placement", "OutsidePoints", "Type1Rule"}, named)

    def test_orders_of_cells_are_a_list(self):
        for proxy in (simple.MultidimensionalSubdivision(Input=simple.SubdivisionModel()),
                      simple.SurfaceSubdivision(Input=simple.Sphere()), simple.RedGreenRefinement(Input=simple.SubdivisionModel())):
            self.assertEqual(list(proxy.GetProperty("CellOrder").Available), ["1", "2", "3", "4", "5", "6"])
            for order in (4, "1", "3", "2"):
                proxy.CellOrder = order
                self.assertEqual(proxy.CellOrder, str(order))
                proxy.UpdateVTKObjects()
                self.assertIn(f"CellOrder: {order}", str(proxy.GetClientSideObject()))

    def test_displays_of_curved_cells_are_curved(self):
        """Finely, but not where there are curved lines, on which VTK crashes then."""
        view = simple.CreateRenderView()
        for cells, level, model, options in (("Linear", 1, "Ship", {}), ("Bezier", 3, "Ship", {}), ("Quadratic", 3, "MaterialBlock", {}),
                                             ("Quadratic", 1, "MixedDimensions", {}), ("Lagrange", 1, "MixedDimensions", {}),
                                             ("Quadratic", 3, "MixedDimensions", {"OutputDimensions": ["Tetrahedra"]})):
            made = simple.MultidimensionalSubdivision(Input=simple.SubdivisionModel(Model=model), OutputCells=cells, **options)
            self.assertEqual(simple.Show(made, view).NonlinearSubdivisionLevel, level, (cells, model))
            simple.Render(view)
            simple.Hide(made, view)

    def test_defaults_are_those_of_the_classes(self):
        proxy = simple.MultidimensionalSubdivision(Input=simple.SubdivisionModel())
        made = subdivisionobjects.vtkMultiDimensionalSubdivision()
        for name in ("NumberOfLevels", "GenerateClassification", "InterpolateIntegers", "GenerateOriginalIds",
                     "OutputPointsPrecision", "MaximumNumberOfCells"):
            element = proxy.SMProxy.GetProperty(name)
            self.assertEqual(element.GetElement(0), int(getattr(made, "Get" + name)()), name)
        proxy.MaximumNumberOfCells = 10**11  # needs 64 bits
        self.assertEqual(proxy.MaximumNumberOfCells, 10**11)
        proxy.UpdateVTKObjects()
        self.assertIn(f"MaximumNumberOfCells: {10**11}", str(proxy.GetClientSideObject()))

    def test_every_property_reaches_the_filter(self):
        source = simple.SubdivisionModel(Model="Ship", OutputPointsPrecision="Single")
        proxy = simple.MultidimensionalSubdivision(
            Input=source, NumberOfLevels=2, GenerateClassification=1, GenerateOriginalIds=1,
            InterpolateIntegers=1, OutputPointsPrecision="Double", MaximumNumberOfCells=10**7)
        proxy.UpdatePipeline()
        filter_ = proxy.GetClientSideObject()
        text = str(filter_)
        for words in ("NumberOfLevels: 2", "MaximumNumberOfCells: 10000000"):
            self.assertIn(words, text)
        output = filter_.GetOutputDataObject(0)
        self.assertEqual(tools.arrays(output.GetPointData()),
                         {"Tension", "RuleDimension", "NonManifoldType", "vtkOriginalPointIds"})
        self.assertEqual(tools.arrays(output.GetCellData()),
                         {"MaterialId", "Singular", "ManifoldDimension", "Inverted", "vtkOriginalCellIds"})
        self.assertEqual(source.GetClientSideObject().GetOutputDataObject(0).GetPoints().GetDataType(), 10)
        self.assertEqual(output.GetPoints().GetDataType(), 11)

    def test_arrays_start_as_none(self):
        """Even where the input has active cell scalars that would fit."""
        source = subdivisionobjects.vtkSubdivisionModelSource()
        source.Update()
        source.GetOutput().GetCellData().SetActiveScalars("MaterialId")
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(source.GetOutput())
        producer.UpdatePipeline()
        proxy = simple.MultidimensionalSubdivision(Input=producer)
        proxy.UpdatePipeline()
        names = [name for name in proxy.ListProperties() if name.endswith("Array")]
        self.assertGreaterEqual(len(names), 4)
        for name in names:
            self.assertEqual(proxy.GetPropertyValue(name)[1], "None", name)
        offered = proxy.SMProxy.GetProperty("SingularArray").GetDomain("array_list")
        self.assertEqual([offered.GetString(i) for i in range(offered.GetNumberOfStrings())],
                         ["None", "MaterialId", "Singular"])

    def test_interpolated_arrays_are_chosen(self):
        """All floating point arrays of points are offered, with any number of components, and none is chosen."""
        source = subdivisionobjects.vtkSubdivisionModelSource()
        source.Update()
        grid = source.GetOutput()
        for array_type, name, components in ((10, "Velocity", 3), (11, "Heat", 1), (6, "Count", 1)):
            array = vtkDataArray.CreateDataArray(array_type)
            array.SetName(name)
            array.SetNumberOfComponents(components)
            array.SetNumberOfTuples(grid.GetNumberOfPoints())
            array.Fill(1)
            grid.GetPointData().AddArray(array)
        surface = vtkGeometryFilter()
        surface.SetInputData(grid)
        surface.Update()
        for data, make in ((grid, simple.MultidimensionalSubdivision), (grid, simple.RedGreenRefinement),
                           (surface.GetOutput(), simple.SurfaceSubdivision)):
            producer = simple.TrivialProducer()
            producer.GetClientSideObject().SetOutput(data)
            producer.UpdatePipeline()
            proxy = make(Input=producer)
            prop = proxy.SMProxy.GetProperty("InterpolatedArrays")
            self.assertEqual(prop.GetNumberOfElements(), 0)
            offered = prop.FindDomain("vtkSMArrayListDomain")
            names = {offered.GetString(i) for i in range(offered.GetNumberOfStrings())}
            self.assertLessEqual({"Velocity", "Heat"}, names)
            self.assertNotIn("Count", names)
            proxy.InterpolateArrays = 1
            proxy.InterpolatedArrays = ["Heat"]
            proxy.UpdatePipeline()
            self.assertIn("Interpolated arrays: Heat", str(proxy.GetClientSideObject()))

    def test_local_refinement_shows_its_edges(self):
        model = simple.SubdivisionModel()
        for create, shown in ((simple.RedGreenRefinement, "Surface With Edges"),
                              (simple.AdaptiveSurfaceSubdivision, "Surface With Edges"),
                              (simple.MultidimensionalSubdivision, "Surface")):
            view = simple.CreateRenderView()
            self.assertEqual(simple.Show(create(Input=model), view).Representation, shown)

    def test_panels_have_few_options(self):
        """Without the gear, and more with it. Others are options of scripts, which panels show once they are set. The
        criteria of refinement are one list; of their options those count that are always there."""
        for name, most in (("MultiDimensionalSubdivision", 8), ("SurfaceSubdivision", 7), ("RedGreenRefinement", 10)):
            proxy = definition(name)
            advanced, one = set(), set()
            for i in range(proxy.GetNumberOfPropertyGroups()):
                group = proxy.GetPropertyGroup(i)
                keys = {group.GetPropertyName(k) for k in range(group.GetNumberOfProperties())}
                advanced |= keys if group.GetPanelVisibility() == "advanced" else set()
                one |= keys if group.GetPanelWidget() == "SubdivisionObjectsCriteria" else set()
            counts = {"default": 1 if one else 0, "advanced": 0, "scripts": 0}
            for key, prop in properties(proxy):
                decorators = {hint.GetAttribute("property") for hint in nested(prop.GetHints(), "PropertyWidgetDecorator")}
                if key in {"Input", "NextApply"} | one or decorators & one:
                    continue
                shown = "advanced" if key in advanced else prop.GetPanelVisibility()
                counts["scripts" if is_of_scripts(key, prop) else shown] += 1
            self.assertLessEqual(counts["default"], most, name)
            self.assertLessEqual(counts["advanced"], 30, name)
            self.assertGreater(counts["scripts"], 5, name)

    def test_presets_set_what_is_there(self):
        for name, scheme in (("MultiDimensionalSubdivision", "VolumeScheme"), ("SurfaceSubdivision", "Scheme")):
            hints = definition(name).GetProperty("Preset").GetHints()
            texts = [preset.GetAttribute("text") for preset in nested(hints, "Preset")]
            self.assertEqual(len(set(texts)), len(texts))
            self.assertLessEqual({"CAD part: keep sharp edges", "Organic", "Through my points", "Exact split"}, set(texts))
            self.assertEqual("For volume rendering" in texts, name == "MultiDimensionalSubdivision")
            for value in nested(hints, "Value"):
                key = value.GetAttribute("property")
                self.assertTrue(definition(name).GetProperty(key).IsA("vtkSMIntVectorProperty"), key)
                if key == scheme:
                    entries = definition(name).GetProperty(key).FindDomain("vtkSMEnumerationDomain")
                    self.assertEqual(int(value.GetAttribute("value")), entries.GetEntryValueForText("Linear"))

    def test_what_has_no_effect_is_hidden(self):
        for name in ("SubdivisionDeformation", "SimplicialComplexTopology", "SubdivisionSmoothness"):
            for key in ("InterfaceValues", "FieldsOfCells"):
                self.assertEqual(definition(name).GetProperty(key).GetPanelVisibility(), "never", f"{name}.{key}")

    def test_all_schemes_have_limits(self):
        """So that no option of the limit is grey."""
        prototype = definition("SurfaceSubdivision")
        entries = prototype.GetProperty("Scheme").FindDomain("vtkSMEnumerationDomain")
        proxy = simple.SurfaceSubdivision(Input=simple.Sphere(), GenerateLimitNormals=1)
        for i in range(entries.GetNumberOfEntries()):
            proxy.Scheme = entries.GetEntryText(i)
            proxy.UpdatePipeline()
            self.assertIn("LimitNormals", tools.arrays(tools.output(proxy).GetPointData()), proxy.Scheme)
        for name in ("ProjectToLimit", "GenerateLimitNormals", "GenerateTangents"):
            decorators = nested(prototype.GetProperty(name).GetHints(), "PropertyWidgetDecorator")
            self.assertNotIn("Scheme", [hint.GetAttribute("property") for hint in decorators], name)

    def test_the_largest_size_is_in_the_panel(self):
        """Without the gear: its error tells the user to change it. A group that is advanced would hide it."""
        for name in ("MultiDimensionalSubdivision", "SurfaceSubdivision", "RedGreenRefinement",
                     "AdaptiveSurfaceSubdivision", "SubdivisionDeformation", "SimplicialComplexTopology",
                     "SubdivisionLimitProbe", "SubdivisionSmoothness"):
            proxy = definition(name)
            prop = proxy.GetProperty("MaximumNumberOfCells")
            self.assertEqual(prop.GetPanelVisibility(), "default", name)
            self.assertTrue(prop.IsA("vtkSMDoubleVectorProperty"), name)  # others have no widget
            for i in range(proxy.GetNumberOfPropertyGroups()):
                group = proxy.GetPropertyGroup(i)
                if prop in [group.GetProperty(k) for k in range(group.GetNumberOfProperties())]:
                    self.assertEqual(group.GetPanelVisibility(), "default", name)

    def test_error_bounds_hold_at_points(self):
        sphere = simple.Sphere(ThetaResolution=5, PhiResolution=4)
        for create in (simple.MultidimensionalSubdivision, simple.SurfaceSubdivision):
            options = {"Input": sphere, "NumberOfLevels": 1, "OutputPointsPrecision": "Double"}
            made = updated(create(**options, GenerateErrorBounds=1))
            limit = updated(create(**options, ProjectToLimit=1))
            bounds = vtk_to_numpy(made.GetCellData().GetArray("ErrorBound"))
            points = [vtk_to_numpy(data.GetPoints().GetData()) for data in (made, limit)]
            distances = np.linalg.norm(points[0] - points[1], axis=1)
            self.assertGreater(distances.max(), 0.01)
            for cell, bound in enumerate(bounds):
                ids = made.GetCell(cell).GetPointIds()
                self.assertLessEqual(max(distances[ids.GetId(i)] for i in range(ids.GetNumberOfIds())), bound)
            self.assertLess(bounds.max(), 4 * distances.max())
            moved = vtk_to_numpy(made.GetPointData().GetArray("SmoothingDistance"))
            self.assertGreater(moved.max(), 0.01)
            self.assertEqual(moved.min(), -1)  # new points
            self.assertIsNone(limit.GetCellData().GetArray("ErrorBound"))

    def test_modified_boundary_is_that_of_surfaces(self):
        turns = np.pi * np.arange(8) / 7  # seven triangles on one side of point 0
        corners = np.stack([np.cos(turns), np.sin(turns), 0.3 * np.cos(2 * turns)], axis=1)
        fan = vtkPolyData()
        fan.SetPoints(vtkPoints())
        fan.SetPolys(vtkCellArray())
        for corner in np.concatenate([[[0, 0, 0.5]], corners]):
            fan.GetPoints().InsertNextPoint(corner)
        for i in range(1, 8):
            fan.GetPolys().InsertNextCell(3, (0, i, i + 1))
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(fan)

        def points(create, **options):
            made = create(Input=producer, NumberOfLevels=2, OutputPointsPrecision="Double", **options)
            found = vtk_to_numpy(updated(made).GetPoints().GetData())
            return found[np.lexsort(np.round(found, 9).T)]  # points of edges have another order in each filter

        plain = points(simple.MultidimensionalSubdivision, SmoothUpToBorders=0)
        modified = points(simple.MultidimensionalSubdivision)
        np.testing.assert_allclose(modified, points(simple.SurfaceSubdivision, Scheme="Loop"), atol=1e-12)
        np.testing.assert_allclose(plain, points(simple.SurfaceSubdivision, Scheme="Loop", SmoothUpToBorders=0),
                                   atol=1e-12)
        self.assertGreater(np.abs(plain - modified).max(), 1e-3)

    def test_the_guard_stops_it(self):
        proxy = simple.MultidimensionalSubdivision(
            Input=simple.SubdivisionModel(), NumberOfLevels=3, MaximumNumberOfCells=1000)
        with tools.quiet():
            proxy.UpdatePipeline()
        self.assertEqual(tools.output(proxy).GetNumberOfCells(), 0)


if __name__ == "__main__":
    tools.main()
