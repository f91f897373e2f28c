# SPDX-License-Identifier: BSD-3-Clause
"""An image of labels, as a segmented scan is, becomes a smooth solid of three materials, shown as volume."""

import os
import unittest

import numpy as np
import tools
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkTable

SIZE = 40
NAMES = {1: "soft tissue", 2: "bone", 3: "marrow"}
DENSITIES = {1: 1.05, 2: 1.9, 3: 1.03}


def labels():
    """A bone with marrow in an ellipsoid of soft tissue."""
    z, y, x = (2 * np.indices((SIZE,) * 3) + 1) / SIZE - 1
    tissue = (x / .9) ** 2 + (y / .8) ** 2 + (z / .93) ** 2 < 1
    along = (.3 * x + .2 * y + z) / np.sqrt(1.13)
    radius = np.sqrt(np.maximum(0, x * x + y * y + z * z - along * along))
    wall = .32 + .12 * along ** 2 + .04 * np.cos(6 * along)
    bone = tissue & (radius < wall) & (abs(along) < .7)
    marrow = bone & (radius < wall - .12) & (abs(along) < .6)
    return tissue * 1 + bone + marrow


def producer(made):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(made)
    source.UpdatePipeline()
    return source


def scan():
    image = vtkImageData()
    image.SetDimensions(SIZE, SIZE, SIZE)
    image.SetSpacing(.5, .5, 1.25)
    values = numpy_to_vtk(labels().astype(np.int16).ravel(), deep=True)
    values.SetName("Tissue")
    image.GetPointData().SetScalars(values)
    return producer(image)


def materials():
    table = vtkTable()
    for name, array, column in (("Tissue", vtkIntArray(), list(NAMES)), ("Density", vtkDoubleArray(), DENSITIES.values()),
                                ("Name", vtkStringArray(), NAMES.values())):
        array.SetName(name)
        for value in column:
            array.InsertNextValue(value)
        table.AddColumn(array)
    return producer(table)


class Labels(unittest.TestCase):
    def test_a_scan_in_one_apply(self):
        solid = simple.SmoothSolidfromLabels(Input=scan(), Materials=materials(), NumberOfControlCells=0)
        solid.UpdatePipeline()
        grid = tools.output(solid)
        points = vtk_to_numpy(grid.GetPoints().GetData())
        tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        self.assertEqual(len(tets), grid.GetNumberOfCells())
        corners = points[tets]
        edges = corners[:, 1:] - corners[:, :1]
        volumes = np.linalg.det(edges) / 6
        self.assertGreater(volumes.min(), 0)
        found = vtk_to_numpy(grid.GetCellData().GetArray("Tissue"))
        self.assertEqual(grid.GetCellData().GetScalars().GetName(), "Tissue")
        voxels = labels()
        for label in NAMES:
            wanted = (voxels == label).sum() * .5 * .5 * 1.25
            self.assertAlmostEqual(volumes[found == label].sum() / wanted, 1, delta=.005)
            density = vtk_to_numpy(grid.GetCellData().GetArray("Density"))[found == label]
            self.assertEqual(set(density), {DENSITIES[label]})
        names = grid.GetFieldData().GetAbstractArray("Name")
        self.assertEqual([names.GetValue(i) for i in range(3)], list(NAMES.values()))
        self.draw(solid)

    def draw(self, solid):
        view = simple.CreateRenderView(ViewSize=[400, 300])
        view.OrientationAxesVisibility = 0
        view.UseColorPaletteForBackground = 0
        view.Background = [1.0, 1.0, 1.0]
        display = simple.Show(solid, view)
        display.SetRepresentationType("Volume")
        simple.ColorBy(display, ("CELLS", "Tissue"))
        simple.GetColorTransferFunction("Tissue").RescaleTransferFunction(0, 3)
        simple.GetOpacityTransferFunction("Tissue").RescaleTransferFunction(0, 3)
        display.SetScalarBarVisibility(view, False)
        view.CameraPosition = [4.0, -10.0, 4.0]
        view.CameraViewUp = [0.0, 0.0, 1.0]
        simple.Render(view)
        view.ResetCamera()
        simple.SaveScreenshot("labels.png", view)
        reader = simple.PNGSeriesReader(FileNames=[os.path.abspath("labels.png")])
        reader.UpdatePipeline()
        seen = vtk_to_numpy(tools.output(reader).GetPointData().GetScalars())[:, :3].astype(int)
        drawn = (seen < 250).any(axis=1)
        self.assertTrue(.05 < drawn.mean() < .9, f"drawn is {drawn.mean():.2%} of the picture")
        self.assertGreater(len(np.unique(seen[drawn], axis=0)), 100)

    def test_options(self):
        source = scan()
        solid = simple.SmoothSolidfromLabels(Input=source, NumberOfControlCells=2000, NumberOfLevels=0,
                                             VolumeScheme="Even", BackgroundLabel=1)
        solid.UpdatePipeline()
        self.assertEqual(list(solid.LabelsArray), ["POINTS", "None"])  # the active scalars
        grid = tools.output(solid)
        self.assertTrue(0 < grid.GetNumberOfCells() <= 12000)
        self.assertEqual(set(vtk_to_numpy(grid.GetCellData().GetArray("Tissue"))), {0, 2, 3})


if __name__ == "__main__":
    tools.main()
