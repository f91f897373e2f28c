# SPDX-License-Identifier: BSD-3-Clause
"""Adaptive surface subdivision in ParaView: properties, selections, functions, state files."""

import unittest

import numpy as np
import tools
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

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
        self.assertEqual(redgreen - adaptive, {"Shape", "CellsInOtherCells", "PartArray", "JointOfEachCell",
                                               "InterpolatePoints", "InterpolateArrays", "InterpolatedArrays",
                                               "InterpolatedPoints", "InterpolationWeight", "VolumeScheme", "OutputCells", "CellOrder"})
        self.assertEqual(adaptive - redgreen, {"GenerateTangents", "CompactIds"})

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


if __name__ == "__main__":
    tools.main()
