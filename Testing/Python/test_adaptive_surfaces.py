# SPDX-License-Identifier: BSD-3-Clause
"""Adaptive surface subdivision in ParaView: properties, selections, functions, state files, also older ones."""

import os
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np
import tools
from paraview import servermanager, simple
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING

LEVELS = 4


def refine(source, **options):
    """Without a criterion but those that are given."""
    return simple.AdaptiveSurfaceSubdivision(
        Input=source, **{"RefineByGeometricError": 0, "MaximumLevel": LEVELS, **options})


def updated(proxy):
    proxy.UpdatePipeline()
    return tools.output(proxy)


def centres(mesh):
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(mesh.GetPoints().GetData())[triangles].mean(axis=1)


def cells(mesh, name):
    return vtk_to_numpy(mesh.GetCellData().GetArray(name))


class InParaView(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        self.sphere = simple.Sphere(ThetaResolution=16, PhiResolution=16)
        self.control = updated(self.sphere)

    def test_menu_and_help(self):
        proxy = servermanager.ProxyManager().GetPrototypeProxy("filters", "AdaptiveSurfaceSubdivision")
        self.assertEqual(proxy.GetXMLLabel(), "Adaptive Surface Subdivision")
        menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
        self.assertEqual(menu.GetAttribute("category"), "Subdivision Objects")
        self.assertGreater(len(proxy.GetDocumentation().GetDescription()), 100)

    def test_criteria_are_those_of_red_green_refinement(self):
        adaptive, redgreen = ({key for key in proxy.ListProperties()} for proxy in (
            simple.AdaptiveSurfaceSubdivision(Input=self.sphere), simple.RedGreenRefinement(Input=self.sphere)))
        self.assertEqual(redgreen - adaptive, {"Placement", "EmbeddedCells", "PartArray", "RuleArray",
                                               "InterpolatePoints", "InterpolateArrays", "InterpolatedArrays",
                                               "InterpolationWeight", "VolumeScheme", "ModifiedBoundary",
                                               "CornerAngleArray"})
        self.assertEqual(adaptive - redgreen, {"GenerateTangents", "Use32BitIds"})

    def test_selection(self):
        ids = simple.IDSelectionSource(IDs=[0, 3, 0, 50], FieldType="CELL")
        mesh = updated(refine(self.sphere, RefineBySelection=1, Selection=ids))
        selected = np.isin(cells(mesh, "vtkOriginalCellIds"), (3, 50))
        self.assertGreater(selected.sum(), 2 * 3 ** (LEVELS - 1))
        self.assertEqual(cells(mesh, "Generation")[selected].max(), 2 * LEVELS)
        self.assertTrue((cells(mesh, "Generation")[~selected] == 0).any())

    def test_selection_of_points(self):
        ids = simple.IDSelectionSource(IDs=[0, 0], FieldType="POINT")  # a pole
        mesh = updated(refine(self.sphere, RefineBySelection=1, Selection=ids))
        height = centres(mesh)[:, 2]
        self.assertTrue((cells(mesh, "Generation")[height > 0.49] >= 2 * LEVELS - 1).all())
        self.assertTrue((cells(mesh, "Generation")[height < 0] == 0).all())

    def test_inside_a_sphere(self):
        proxy = refine(self.sphere, RefineByFunction=1, ImplicitFunction="Sphere")
        proxy.ImplicitFunction.Center = [0.5, 0, 0]
        proxy.ImplicitFunction.Radius = 0.4
        large = updated(proxy)
        distances = np.linalg.norm(centres(large) - [0.5, 0, 0], axis=1)
        self.assertTrue((cells(large, "Generation")[distances < 0.3] >= 2 * LEVELS - 1).all())
        self.assertTrue((cells(large, "Generation")[distances > 0.8] == 0).all())
        size = large.GetNumberOfCells()
        proxy.ImplicitFunction.Radius = 0.2
        self.assertLess(updated(proxy).GetNumberOfCells(), size)

    def test_saved_and_loaded(self):
        proxy = refine(self.sphere, RefineByFunction=1, ImplicitFunction="Sphere", GenerateLimitNormals=1)
        proxy.ImplicitFunction.Center = [0.25, 0.5, 0]
        wanted = tools.numbers(updated(proxy))
        found = tools.saved_and_loaded(proxy)
        self.assertEqual(list(found.ImplicitFunction.Center), [0.25, 0.5, 0])
        self.assertEqual(tools.numbers(updated(found)), wanted)


class OlderStates(unittest.TestCase):
    """Those in which Surface Subdivision has Adaptive and the criteria."""

    def load(self, adaptive):
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        surface = simple.SurfaceSubdivision(Input=simple.Sphere(), Scheme="Sqrt Three", Adaptive=adaptive)
        simple.RenameSource("older", surface)
        path = os.path.abspath("older.pvsm")
        simple.SaveState(path)
        state = ElementTree.parse(path)
        proxy = next(element for element in state.iter("Proxy") if element.get("type") == "SurfaceSubdivision")
        for name, value in (("RefineByAttributeError", 0), ("RefineByGeometricError", 1), ("MaximumLevel", 6)):
            self.assertIsNone(proxy.find(f"Property[@name='{name}']"))
            criterion = ElementTree.SubElement(
                proxy, "Property", name=name, id=f"{proxy.get('id')}.{name}", number_of_elements="1")
            ElementTree.SubElement(criterion, "Element", index="0", value=str(value))
        state.write(path)
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        simple.LoadState(path)
        return simple.FindSource("older")

    def update(self, proxy):
        messages = []

        @calldata_type(VTK_STRING)
        def listen(_, __, message):
            messages.append(message)

        proxy.UpdateVTKObjects()
        proxy.GetClientSideObject().AddObserver("ErrorEvent", listen)
        return updated(proxy), messages

    def test_adaptive_ones_say_what_to_use(self):
        found = self.load(1)
        self.assertEqual((found.Scheme, found.Adaptive), ("Sqrt Three", 1))
        mesh, messages = self.update(found)
        self.assertEqual(mesh.GetNumberOfCells(), 0)
        self.assertEqual(len(messages), 1)
        self.assertIn('"Adaptive Surface Subdivision"', messages[0])
        found.Adaptive = 0
        self.assertGreater(updated(found).GetNumberOfCells(), 0)

    def test_uniform_ones_load(self):
        mesh, messages = self.update(self.load(0))
        self.assertEqual(messages, [])
        self.assertEqual(mesh.GetNumberOfCells(), 3 * updated(simple.Sphere()).GetNumberOfCells())


if __name__ == "__main__":
    tools.main()
