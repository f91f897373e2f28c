# SPDX-License-Identifier: BSD-3-Clause
"""The main line in ParaView: models, filter, threshold, slice, saved state (pictures: test_rendering.py)."""

import math
import os
import unittest

import numpy as np
import tools
from paraview import simple, smstate
from vtkmodules.util.numpy_support import vtk_to_numpy


class Models(unittest.TestCase):
    def test_every_model(self):
        for model in simple.SubdivisionModel().GetProperty("Model").Available:
            with self.subTest(model):
                source = simple.SubdivisionModel(Model=model)
                subdivision = simple.MultidimensionalSubdivision(
                    Input=source, NumberOfLevels=2, GenerateOriginalIds=1)
                subdivision.UpdatePipeline()
                control, smooth = tools.output(source), tools.output(subdivision)
                self.assertEqual(smooth.GetNumberOfCells(), tools.cells_after(control, 2))
                # All weights are positive: nothing leaves the box of the control mesh.
                low, high = control.GetPointData().GetArray("Tension").GetRange()
                tension = smooth.GetPointData().GetArray("Tension").GetRange()
                self.assertTrue(low <= tension[0] < tension[1] <= high)
                for inside, outside in zip(np.reshape(smooth.GetBounds(), (3, 2)),
                                           np.reshape(control.GetBounds(), (3, 2))):
                    self.assertTrue(outside[0] <= inside[0] < inside[1] <= outside[1])
                ids = vtk_to_numpy(smooth.GetCellData().GetArray("vtkOriginalCellIds"))
                parents = vtk_to_numpy(control.GetCellData().GetArray("MaterialId"))
                parts = vtk_to_numpy(smooth.GetCellData().GetArray("MaterialId"))
                self.assertTrue((parts == parents[ids]).all())

    def test_the_same_file(self):
        folder = os.environ.get("SUBDIVISIONOBJECTS_DATA", "")
        for model in simple.SubdivisionModel().GetProperty("Model").Available:
            with self.subTest(model):
                made = simple.MultidimensionalSubdivision(Input=simple.SubdivisionModel(Model=model))
                file_name = os.path.join(folder, model + ".vtu")
                self.assertTrue(os.path.isfile(file_name), file_name)
                read = simple.MultidimensionalSubdivision(
                    Input=simple.XMLUnstructuredGridReader(FileName=[file_name], TimeArray="None"))
                made.UpdatePipeline()
                read.UpdatePipeline()
                self.assertEqual(tools.numbers(tools.output(made)), tools.numbers(tools.output(read)))


class Pipeline(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        self.model = simple.SubdivisionModel(Model="SpringAndValve")
        self.subdivision = simple.MultidimensionalSubdivision(
            Input=self.model, NumberOfLevels=2, GenerateClassification=1)

    def solids(self):
        return simple.Threshold(Input=self.subdivision, Scalars=["CELLS", "ManifoldDimension"],
                                LowerThreshold=3, UpperThreshold=3)

    def test_chain_is_one(self):
        once = simple.MultidimensionalSubdivision(Input=self.model, NumberOfLevels=1)
        twice = simple.MultidimensionalSubdivision(Input=once, NumberOfLevels=1, GenerateClassification=1)
        for proxy in (self.subdivision, twice):
            proxy.UpdatePipeline()
        self.assertEqual(tools.numbers(tools.output(self.subdivision)), tools.numbers(tools.output(twice)))

    def test_blocks(self):
        ball = simple.Sphere()
        blocks = simple.GroupDatasets(Input=[self.model, ball])
        subdivision = simple.MultidimensionalSubdivision(Input=blocks)
        subdivision.UpdatePipeline()
        alone = [simple.MultidimensionalSubdivision(Input=block) for block in (self.model, ball)]
        for proxy in alone:
            proxy.UpdatePipeline()
        self.assertEqual(subdivision.GetDataInformation().GetNumberOfCells(),
                         sum(proxy.GetDataInformation().GetNumberOfCells() for proxy in alone))

    def test_threshold_leaves_the_solids(self):
        solids = self.solids()
        solids.UpdatePipeline()
        grid = tools.output(solids)
        control = tools.output(self.model)
        tets = sum(control.GetCellType(i) == 10 for i in range(control.GetNumberOfCells()))
        self.assertEqual(grid.GetNumberOfCells(), tets * 64)
        self.assertTrue(all(grid.GetCellType(i) == 10 for i in range(grid.GetNumberOfCells())))
        ids = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        a, b, c, d = np.moveaxis(vtk_to_numpy(grid.GetPoints().GetData())[ids], 1, 0)
        volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
        self.assertGreater(volumes.min(), 0)

    def test_slice(self):
        cut = simple.Slice(Input=self.solids())
        cut.SliceType.Origin = [0.0, 0.0, 4.4]
        cut.SliceType.Normal = [0.0, 0.0, 1.0]
        cut.UpdatePipeline()
        data = tools.output(cut)
        self.assertGreater(data.GetNumberOfPolys(), 100)
        self.assertTrue(np.allclose(vtk_to_numpy(data.GetPoints().GetData())[:, 2], 4.4))
        low, high = tools.output(self.model).GetPointData().GetArray("Tension").GetRange()
        cut_low, cut_high = data.GetPointData().GetArray("Tension").GetRange()
        self.assertTrue(low <= cut_low < cut_high <= high)
        area = simple.IntegrateVariables(Input=cut)
        area.UpdatePipeline()
        measured = tools.output(area).GetCellData().GetArray("Area").GetValue(0)
        self.assertTrue(1 < measured < math.pi * 1.9**2, measured)  # the cap is at most 1.9 wide

    def test_state(self):
        self.subdivision.NumberOfLevels = 1
        self.subdivision.GenerateOriginalIds = 1
        self.subdivision.OutputPointsPrecision = "Single"
        simple.RenameSource("smooth", self.subdivision)
        self.subdivision.UpdatePipeline()
        before = tools.numbers(tools.output(self.subdivision))
        state = smstate.get_state()
        state = state if isinstance(state, str) else "\n".join(state)
        self.assertIn("SubdivisionModel(", state)
        self.assertIn("MultidimensionalSubdivision(", state)
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        self.assertIsNone(simple.FindSource("smooth"))
        exec(compile(state, "state.py", "exec"), {"__name__": "state"})
        again = simple.FindSource("smooth")
        self.assertIsNotNone(again)
        self.assertEqual((again.NumberOfLevels, again.GenerateOriginalIds, again.OutputPointsPrecision),
                         (1, 1, "Single"))
        again.UpdatePipeline()
        self.assertEqual(tools.numbers(tools.output(again)), before)

    def test_state_file(self):
        simple.RenameSource("smooth", self.subdivision)
        self.subdivision.UpdatePipeline()
        before = tools.numbers(tools.output(self.subdivision))
        simple.SaveState(os.path.abspath("state.pvsm"))
        simple.ResetSession()
        simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
        simple.LoadState(os.path.abspath("state.pvsm"))
        again = simple.FindSource("smooth")
        again.UpdatePipeline()
        self.assertEqual(tools.numbers(tools.output(again)), before)


if __name__ == "__main__":
    tools.main()
