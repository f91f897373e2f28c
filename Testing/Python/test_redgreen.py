# SPDX-License-Identifier: BSD-3-Clause
"""Red-green refinement in ParaView: properties, array pickers, selections, functions, state files."""

import os
import unittest

import numpy as np
import tools
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import subdivisionobjects
from subdivisionobjects import meshes


def model(name="MaterialBlock"):
    source = simple.SubdivisionModel(Model=name)
    source.UpdatePipeline()
    return source


def refine(source, **options):
    """Without a criterion but those that are given."""
    return simple.RedGreenRefinement(Input=source, **{"RefineByAttributeError": 0, **options})


def updated(proxy):
    proxy.UpdatePipeline()
    return tools.output(proxy)


def cells(grid, name):
    return vtk_to_numpy(grid.GetCellData().GetArray(name))


def offered(proxy, name):
    domain = proxy.GetProperty(name).SMProperty.GetDomain("array_list")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]


class Properties(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))

    def test_defaults_are_those_of_the_class(self):
        proxy = simple.RedGreenRefinement(Input=model())
        made = subdivisionobjects.vtkRedGreenRefinement()
        names = [name[3:] for name in dir(made) if name.startswith("Set") and proxy.SMProxy.GetProperty(name[3:])
                 and isinstance(getattr(made, "Get" + name[3:])(), (bool, int, float))]
        self.assertGreaterEqual(len(names), 17)
        for name in names:
            prop = proxy.SMProxy.GetProperty(name)
            self.assertEqual(prop.GetElement(0), getattr(made, "Get" + name)(), name)
        self.assertEqual(made.GetMaximumNumberOfCells(), 500000000)

    def test_arrays_are_offered(self):
        proxy = simple.RedGreenRefinement(Input=model())
        self.assertIn("Tension", offered(proxy, "AttributeArray"))
        self.assertNotIn("MaterialId", offered(proxy, "AttributeArray"))
        self.assertIn("MaterialId", offered(proxy, "WantedLevelArray"))
        self.assertIn("Tension", offered(proxy, "RangeArray"))
        self.assertIn("MaterialId", offered(proxy, "RangeArray"))
        self.assertEqual(proxy.AttributeArray[1], "None")
        self.assertEqual(proxy.WantedLevelArray[1], "None")

    def test_menu_and_help(self):
        proxy = servermanager.ProxyManager().GetPrototypeProxy("filters", "RedGreenRefinement")
        self.assertEqual(proxy.GetXMLLabel(), "Red-Green Refinement")
        menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
        self.assertEqual(menu.GetAttribute("category"), "Subdivision Objects")
        self.assertGreater(len(proxy.GetDocumentation().GetDescription()), 100)

    def test_every_property_reaches_the_filter(self):
        proxy = refine(model(), RefineByEdgeLength=1, MaximumEdgeLength=0.5, MaximumLevel=5, Shape="Smooth",
                       GeometricTolerance=0.25, RelativeTolerance=0, AttributeTolerance=0.75,
                       AttributeErrorKind="Limit Difference", ArrayRange=[2, 3], MaximumNumberOfCells=10**6)
        proxy.UpdateVTKObjects()
        text = str(proxy.GetClientSideObject())
        for words in ("MaximumLevel: 5", "MaximumEdgeLength: 0.5", "Placement: 1", "GeometricTolerance: 0.25",
                      "RelativeTolerance: 0", "AttributeTolerance: 0.75", "AttributeErrorKind: 1",
                      "ArrayRange: 2 3", "MaximumNumberOfCells: 1000000", "RefineByAttributeError: 0"):
            self.assertIn(words, text)


class Criteria(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        self.model = model()
        self.control = tools.output(self.model)

    def test_where_the_tension_changes(self):
        coarse = updated(simple.RedGreenRefinement(Input=self.model, AttributeTolerance=0.5))
        fine = updated(simple.RedGreenRefinement(Input=self.model, AttributeTolerance=0.2,
                                                 AttributeArray=["POINTS", "Tension"]))
        self.assertGreater(fine.GetNumberOfCells(), coarse.GetNumberOfCells())
        self.assertGreater(coarse.GetNumberOfCells(), self.control.GetNumberOfCells())
        self.assertEqual(tools.arrays(fine.GetCellData()) - tools.arrays(self.control.GetCellData()),
                         {"RefinementLevel", "RefinementKind", "GreenParent", "vtkOriginalCellIds"})
        origins = cells(fine, "vtkOriginalCellIds")
        self.assertTrue((np.diff(origins) >= 0).all())
        self.assertTrue((cells(fine, "MaterialId") == cells(self.control, "MaterialId")[origins]).all())

    def test_range_of_a_cell_array(self):
        grid = updated(refine(self.model, RefineByArrayRange=1, RangeArray=["CELLS", "MaterialId"],
                              ArrayRange=[1, 1], MaximumLevel=1))
        wanted = cells(grid, "MaterialId") == 1
        self.assertTrue(wanted.any() and not wanted.all())
        self.assertTrue((cells(grid, "RefinementKind")[wanted] == 1).all())
        self.assertFalse((cells(grid, "RefinementKind")[~wanted] == 1).all())

    def test_inside_a_sphere(self):
        bounds = np.reshape(self.control.GetBounds(), (3, 2))
        proxy = refine(self.model, RefineByFunction=1, ImplicitFunction="Sphere", MaximumLevel=2)
        proxy.ImplicitFunction.Center = list(bounds[:, 0])
        proxy.ImplicitFunction.Radius = float(np.linalg.norm(bounds[:, 1] - bounds[:, 0])) / 2
        large = updated(proxy).GetNumberOfCells()
        proxy.ImplicitFunction.Radius *= 0.6
        small = updated(proxy).GetNumberOfCells()
        self.assertGreater(large, small)
        self.assertGreater(small, self.control.GetNumberOfCells())

    def test_selection(self):
        ids = simple.IDSelectionSource(IDs=[0, 3, 0, 5], FieldType="CELL")
        proxy = refine(self.model, RefineBySelection=1, Selection=ids, MaximumLevel=1)
        grid = updated(proxy)
        wanted = np.isin(cells(grid, "vtkOriginalCellIds"), (3, 5))
        self.assertTrue(wanted.any())
        self.assertTrue((cells(grid, "RefinementKind")[wanted] == 1).all())
        self.assertTrue((cells(grid, "RefinementKind") == 0).any())

    def refined(self, selection, source=None):
        """The cells of the input that a selection makes red."""
        grid = updated(refine(source or self.model, RefineBySelection=1, Selection=selection, MaximumLevel=1))
        return set(cells(grid, "vtkOriginalCellIds")[cells(grid, "RefinementKind") == 1])

    def test_vertices_that_are_not_smooth(self):
        """What Subdivision Smoothness finds is selected there, and refined in the mesh."""
        points = [[0, 0, 0], [1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]
        tets = [[0, 1, 2, 3], [0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4]]
        mesh = simple.TrivialProducer()
        mesh.GetClientSideObject().SetOutput(meshes.to_vtk(np.array(points, float), tets))
        smooth = simple.SubdivisionSmoothness(Input=mesh, SampleMaps=1)
        failing = vtk_to_numpy(updated(smooth).GetPointData().GetArray("Failing"))
        self.assertEqual(list(failing), [1, 0, 0, 1, 1])  # the middle, and two edges at it
        both = simple.AppendAttributes(Input=[mesh, smooth])
        refined = updated(refine(both, RefineByArrayRange=1, RangeArray=["POINTS", "Failing"], ArrayRange=[1, 1],
                                 MaximumLevel=1))
        self.assertEqual(refined.GetNumberOfCells(), 32)
        chosen = simple.ThresholdSelectionSource(ArrayName="Failing", FieldType="POINT", Thresholds=[1, 1])
        self.assertEqual(self.refined(chosen, both), {0, 1, 2, 3})

    def test_selections_by_values_and_places(self):
        ids = cells(self.control, "MaterialId")
        ones = set(np.flatnonzero(ids == 1))
        values = simple.ThresholdSelectionSource(ArrayName="MaterialId", FieldType="CELL", Thresholds=[1, 1])
        self.assertTrue(ones <= self.refined(values) and ones)
        values.InsideOut = 1
        self.assertTrue(set(np.flatnonzero(ids != 1)) <= self.refined(values))
        points = vtk_to_numpy(self.control.GetPoints().GetData())
        tet = vtk_to_numpy(self.control.GetCells().GetConnectivityArray())[8:12]
        place = simple.LocationSelectionSource(FieldType="CELL", Locations=list(points[tet].mean(axis=0)))
        self.assertIn(2, self.refined(place))
        self.assertLess(len(self.refined(place)), self.control.GetNumberOfCells())

    def test_selections_by_an_expression(self):
        some = simple.IDSelectionSource(IDs=[-1, 3, -1, 5, -1, 8], FieldType="CELL")
        others = simple.IDSelectionSource(IDs=[-1, 5, -1, 8], FieldType="CELL")
        both = simple.AppendSelections(Input=[some, others], Expression="s0 & !s1", SelectionNames=["s0", "s1"])
        alone = simple.IDSelectionSource(IDs=[-1, 3], FieldType="CELL")
        self.assertEqual(self.refined(both), self.refined(alone))
        self.assertNotEqual(self.refined(both), self.refined(some))

    def test_a_block_is_selected(self):
        blocks = simple.GroupDatasets(Input=[self.model, model("Screw")])
        chosen = simple.BlockSelectionSource(Blocks=[2])
        proxy = refine(blocks, RefineBySelection=1, Selection=chosen, MaximumLevel=1)
        proxy.UpdatePipeline()
        grid = proxy.GetClientSideObject().GetOutputDataObject(0)
        self.assertTrue(grid.IsA("vtkCompositeDataSet"), grid.GetClassName())
        iterator = grid.NewIterator()
        sizes = []
        while not iterator.IsDoneWithTraversal():
            sizes.append(iterator.GetCurrentDataObject().GetNumberOfCells())
            iterator.GoToNextItem()
        screw = tools.output(model("Screw"))
        self.assertEqual(sizes, [self.control.GetNumberOfCells(), tools.cells_after(screw, 1)])

    def test_on_the_limit(self):
        smooth = updated(refine(model("Screw"), RefineByGeometricError=1, GeometricTolerance=0.01,
                                Shape="Smooth", MaximumLevel=5))
        rough = updated(refine(model("Screw"), RefineByGeometricError=1, GeometricTolerance=0.05,
                               Shape="Smooth", MaximumLevel=5))
        self.assertGreater(smooth.GetNumberOfCells(), rough.GetNumberOfCells())

    def test_filters_in_a_row_undo_green_cells(self):
        first = refine(self.model, RefineByArrayRange=1, RangeArray=["CELLS", "MaterialId"], ArrayRange=[1, 1],
                       MaximumLevel=1)
        self.assertTrue((cells(updated(first), "RefinementKind") > 1).any())
        second = refine(first, RefineByEdgeLength=1, MaximumEdgeLength=0, MaximumLevel=1)
        self.assertTrue((cells(updated(second), "RefinementLevel") >= 1).all())
        again = refine(first, RefineByEdgeLength=1, MaximumEdgeLength=0, MaximumLevel=0)
        self.assertEqual(tools.numbers(updated(again)), tools.numbers(updated(first)))

    def test_empty_selection(self):
        with tools.quiet():
            grid = updated(refine(self.model, RefineBySelection=1))
        self.assertEqual(grid.GetNumberOfCells(), self.control.GetNumberOfCells())


class State(unittest.TestCase):
    def test_saved_and_loaded(self):
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        proxy = refine(model(), RefineByFunction=1, ImplicitFunction="Sphere", MaximumLevel=2)
        proxy.ImplicitFunction.Center = [0.25, 0.5, 0]
        proxy.ImplicitFunction.Radius = 1.5
        wanted = tools.numbers(updated(proxy))
        found = tools.saved_and_loaded(proxy)
        self.assertEqual(list(found.ImplicitFunction.Center), [0.25, 0.5, 0])
        self.assertEqual(tools.numbers(updated(found)), wanted)


if __name__ == "__main__":
    tools.main()
