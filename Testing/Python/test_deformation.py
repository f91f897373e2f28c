# SPDX-License-Identifier: BSD-3-Clause
"""Subdivision Deformation in ParaView: its proxy, an interactive session, animation, blocks, saved state."""

import os
import unittest

import numpy as np
import tools
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import subdivisionobjects


def points(proxy):
    return vtk_to_numpy(tools.output(proxy).GetPoints().GetData()).copy()


def calculator(source, function):
    return simple.Calculator(Input=source, CoordinateResults=1, Function=function, ResultArrayName="moved")


class Proxy(unittest.TestCase):
    def setUp(self):
        self.proxy = servermanager.ProxyManager().GetPrototypeProxy("filters", "SubdivisionDeformation")

    def test_names(self):
        self.assertEqual(self.proxy.GetXMLLabel(), "Subdivision Deformation")
        menu = self.proxy.GetHints().FindNestedElementByName("ShowInMenu")
        self.assertEqual(menu.GetAttribute("category"), "Subdivision Objects")

    def test_help(self):
        self.assertGreater(len(self.proxy.GetDocumentation().GetDescription()), 100)
        for name in ("Input", "RestMesh", "DeformedMesh", "NumberOfLevels", "SurfaceScheme", "OutsidePoints",
                     "TransformVectors", "SingularArray", "MaterialArray", "OutputPointsPrecision"):
            text = self.proxy.GetProperty(name).GetDocumentation().GetDescription()
            self.assertGreater(len(text.strip()), 60, name)

    def test_defaults_are_those_of_the_class(self):
        made = subdivisionobjects.vtkSubdivisionDeformation()
        for name in ("NumberOfLevels", "SurfaceScheme", "OutsidePoints", "TransformVectors", "OutputPointsPrecision",
                     "MaximumNumberOfCells", "CreaseEnd"):
            self.assertEqual(self.proxy.GetProperty(name).GetElement(0), int(getattr(made, "Get" + name)()), name)

    def test_what_means_nothing_is_not_shown(self):
        for name in ("InterpolateIntegers", "GenerateOriginalIds", "GenerateGlobalIds"):
            self.assertEqual(self.proxy.GetProperty(name).GetPanelVisibility(), "never")


class Session(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        self.cage = simple.SubdivisionModel(Model="MaterialBlock")  # [0, 2] x [0, 2] x [0, 3]
        self.ball = simple.Sphere(Center=[1.0, 1.0, 1.5], Radius=0.55, ThetaResolution=40, PhiResolution=40)
        self.moved = calculator(self.cage, "coords")
        self.filter = simple.SubdivisionDeformation(Input=self.ball, RestMesh=self.cage, DeformedMesh=self.moved)

    def counts(self):
        made = self.filter.GetClientSideObject()
        return made.GetNumberOfTopologyBuilds(), made.GetNumberOfLocationBuilds(), made.GetNumberOfOutsidePoints()

    def test_moving_control_points(self):
        self.filter.UpdatePipeline()
        rest = points(self.ball)
        self.assertLess(abs(points(self.filter) - rest).max(), 1e-6)
        # Affine, and then bent: only the kept rows are applied.
        self.moved.Function = "(2*coordsX + 0.5*coordsZ)*iHat + (coordsY - 1)*jHat + (coordsZ + coordsX)*kHat"
        self.filter.UpdatePipeline()
        x, y, z = rest.T
        wanted = np.stack([2 * x + 0.5 * z, y - 1, z + x], axis=1)
        self.assertLess(abs(points(self.filter) - wanted).max(), 1e-5)
        self.moved.Function = "(coordsX + 0.3*coordsZ*coordsZ)*iHat + coordsY*jHat + coordsZ*kHat"
        self.filter.UpdatePipeline()
        self.assertGreater(abs(points(self.filter) - rest).max(), 0.5)
        self.assertEqual(self.counts(), (1, 1, 0))
        output = tools.output(self.filter)
        self.assertTrue(output.IsA("vtkPolyData"))
        self.assertEqual(output.GetNumberOfCells(), tools.output(self.ball).GetNumberOfCells())

    def test_normals(self):
        """The sphere's own normals, stretched along z, are those of the ellipsoid."""
        self.moved.Function = "coordsX*iHat + coordsY*jHat + 3*coordsZ*kHat"
        self.filter.UpdatePipeline()
        found = vtk_to_numpy(tools.output(self.filter).GetPointData().GetNormals())
        wanted = vtk_to_numpy(tools.output(self.ball).GetPointData().GetNormals()) * [1, 1, 1 / 3]
        wanted = wanted / np.linalg.norm(wanted, axis=1)[:, None]
        self.assertLess(abs(found - wanted).max(), 1e-5)
        self.filter.TransformVectors = 0
        self.filter.UpdatePipeline()
        found = vtk_to_numpy(tools.output(self.filter).GetPointData().GetNormals())
        self.assertTrue((found == vtk_to_numpy(tools.output(self.ball).GetPointData().GetNormals())).all())
        self.assertEqual(self.counts(), (1, 1, 0))

    def test_animation(self):
        """A control mesh that is another at every time."""
        self.moved.Function = ""
        programmable = simple.ProgrammableFilter(Input=self.cage, OutputDataSetType="vtkUnstructuredGrid")
        programmable.RequestInformationScript = """
times = [0.0, 1.0, 2.0]
info = self.GetOutputInformation(0)
info.Set(self.GetExecutive().TIME_STEPS(), times, 3)
info.Set(self.GetExecutive().TIME_RANGE(), [0.0, 2.0], 2)
"""
        programmable.Script = """
import vtk
grid = self.GetInputDataObject(0, 0)
time = self.GetOutputInformation(0).Get(self.GetExecutive().UPDATE_TIME_STEP())
points = vtk.vtkPoints()
points.DeepCopy(grid.GetPoints())
for i in range(points.GetNumberOfPoints()):
    x, y, z = points.GetPoint(i)
    points.SetPoint(i, x + time, y, z * (1 + time))
out = self.GetOutputDataObject(0)
out.ShallowCopy(grid)
out.SetPoints(points)
"""
        self.filter.DeformedMesh = programmable
        self.filter.UpdatePipelineInformation()
        told = self.filter.GetClientSideObject().GetOutputInformation(0)
        times = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
        self.assertEqual([told.Get(times, i) for i in range(told.Length(times))], [0.0, 1.0, 2.0])
        rest = None
        for time in (0.0, 1.0, 2.0, 1.0):
            self.filter.UpdatePipeline(time)
            rest = points(self.ball)
            wanted = rest * [1, 1, 1 + time] + [time, 0, 0]
            self.assertLess(abs(points(self.filter) - wanted).max(), 1e-5, time)
        self.assertEqual(self.counts(), (1, 1, 0))

    def test_features_of_the_rest_mesh(self):
        """The arrays that are offered are those of the rest mesh; a sharp box keeps its corners inside."""
        offered = self.filter.SMProxy.GetProperty("MaterialArray").GetDomain("array_list")
        self.filter.UpdatePipeline()
        names = [offered.GetString(i) for i in range(offered.GetNumberOfStrings())]
        self.assertEqual(names[0], "None")
        self.assertIn("MaterialId", names)
        box = simple.Box(XLength=1.96, YLength=1.96, ZLength=2.96, Center=[1.0, 1.0, 1.5])
        self.filter.Input = box
        with tools.quiet():
            self.filter.UpdatePipeline()
        self.assertEqual(self.counts()[2], tools.output(box).GetNumberOfPoints())
        self.filter.DetectFeatures = 1
        self.filter.UpdatePipeline()
        self.assertEqual(self.counts()[2], 0)

    def test_outside(self):
        self.ball.Radius = 1.2
        self.moved.Function = "coords + 2*iHat"
        with tools.quiet():
            self.filter.UpdatePipeline()
        outside = self.counts()[2]
        self.assertTrue(0 < outside < tools.output(self.ball).GetNumberOfPoints())
        rest = points(self.ball)
        shifts = points(self.filter) - rest
        self.assertEqual((abs(shifts).max(axis=1) == 0).sum(), outside)
        self.filter.OutsidePoints = "Nearest"
        with tools.quiet():
            self.filter.UpdatePipeline()
        self.assertLess(abs(points(self.filter) - rest - [2, 0, 0]).max(), 1e-5)
        self.filter.OutsidePoints = "Error"
        with tools.quiet():
            self.filter.UpdatePipeline()
        self.assertTrue((points(self.filter) == rest).all())

    def test_bad_meshes_lose_nothing(self):
        self.filter.DeformedMesh = simple.SubdivisionModel(Model="Screw")
        with tools.quiet():
            self.filter.UpdatePipeline()
        self.assertTrue((points(self.filter) == points(self.ball)).all())

    def test_blocks(self):
        other = simple.Cone(Center=[1.0, 1.0, 1.5], Radius=0.3, Height=0.5)
        self.filter.Input = simple.GroupDatasets(Input=[self.ball, other])
        self.moved.Function = "coords + 0.5*coordsZ*iHat"
        self.filter.UpdatePipeline()
        output = tools.output(self.filter)
        self.assertTrue(output.IsA("vtkCompositeDataSet"))
        self.assertEqual(self.filter.GetDataInformation().GetNumberOfPoints(),
                         len(points(self.ball)) + tools.output(other).GetNumberOfPoints())
        self.assertEqual(self.counts(), (1, 2, 0))

    def test_state(self):
        self.moved.Function = "(coordsX + 0.3*coordsZ*coordsZ)*iHat + coordsY*jHat + coordsZ*kHat"
        self.filter.NumberOfLevels = 1
        self.filter.OutsidePoints = "Nearest"
        simple.RenameSource("bent", self.filter)
        self.filter.UpdatePipeline()
        before = points(self.filter)
        simple.SaveState(os.path.abspath("deformation.pvsm"))
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        simple.LoadState(os.path.abspath("deformation.pvsm"))
        again = simple.FindSource("bent")
        self.assertEqual((again.NumberOfLevels, again.OutsidePoints), (1, "Nearest"))
        again.UpdatePipeline()
        self.assertTrue((points(again) == before).all())


class Class(unittest.TestCase):
    def test_without_paraview(self):
        source = subdivisionobjects.vtkSubdivisionModelSource()
        source.SetModelToMaterialBlock()
        source.Update()
        rest = source.GetOutput()
        deformed = vtkUnstructuredGrid()
        deformed.DeepCopy(rest)
        deformed.GetPoints().SetData(numpy_to_vtk(vtk_to_numpy(rest.GetPoints().GetData()) * 2.0, deep=True))
        # The subdivided mesh itself is deformed.
        fine = subdivisionobjects.vtkMultiDimensionalSubdivision()
        fine.SetInputData(rest)
        fine.SetNumberOfLevels(2)
        deformation = subdivisionobjects.vtkSubdivisionDeformation()
        deformation.SetInputConnection(fine.GetOutputPort())
        deformation.SetRestMeshData(rest)
        deformation.SetDeformedMeshData(deformed)
        deformation.Update()
        found = vtk_to_numpy(deformation.GetOutput().GetPoints().GetData())
        wanted = 2.0 * vtk_to_numpy(fine.GetOutput().GetPoints().GetData())
        self.assertLess(abs(found - wanted).max(), 1e-12)


if __name__ == "__main__":
    tools.main()
