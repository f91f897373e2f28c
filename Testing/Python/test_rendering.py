# SPDX-License-Identifier: BSD-3-Clause
"""Model, filter, volume rendering of its solids: there is something to see."""

import os
import unittest

import numpy as np
import tools
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def pixels(file_name):
    """Rows of red, green and blue."""
    reader = simple.PNGSeriesReader(FileNames=[os.path.abspath(file_name)])
    reader.UpdatePipeline()
    return vtk_to_numpy(tools.output(reader).GetPointData().GetScalars())[:, :3].astype(int)


def cell_types(proxy):
    proxy.UpdatePipeline()
    made = tools.output(proxy)
    return {made.GetCellType(i) for i in range(made.GetNumberOfCells())}


class Rendering(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.view = simple.CreateRenderView(ViewSize=[400, 300])
        cls.view.OrientationAxesVisibility = 0
        cls.view.UseColorPaletteForBackground = 0
        cls.view.Background = [1.0, 1.0, 1.0]
        model = simple.SubdivisionModel(Model="SpringAndValve")
        cls.smooth = simple.MultidimensionalSubdivision(Input=model, NumberOfLevels=2)
        cls.solids = simple.MultidimensionalSubdivision(Input=model, NumberOfLevels=2, OutputDimensions=[3])
        cls.extracted = simple.ExtractDimensions(Input=cls.smooth)
        cls.mixed = (cls.smooth, simple.RedGreenRefinement(Input=model))

    def picture(self, proxy, representation, file_name, array="Tension"):
        simple.HideAll(self.view)
        display = simple.Show(proxy, self.view)
        display.SetRepresentationType(representation)
        simple.ColorBy(display, ("POINTS", array))
        display.RescaleTransferFunctionToDataRange()
        display.SetScalarBarVisibility(self.view, False)
        self.view.CameraPosition = [4.0, -10.0, 4.0]
        self.view.CameraViewUp = [0.0, 0.0, 1.0]
        self.view.ResetCamera()
        simple.SaveScreenshot(file_name, self.view)
        seen = pixels(file_name)
        self.assertEqual(len(seen), 400 * 300)
        drawn = (seen < 250).any(axis=1)
        return drawn.mean(), seen[drawn]

    def check_volume(self, proxy, array="Tension"):
        share, seen = self.picture(proxy, "Volume", "volume.png", array)
        self.assertTrue(0.02 < share < 0.9, f"drawn is {share:.2%} of the picture")
        self.assertGreater(len(np.unique(seen, axis=0)), 100)
        self.assertGreater(seen.std(axis=0).max(), 10)
        return share

    def test_volume_of_cells_that_keep_their_types(self):
        """Hexahedra, and hexahedra beside quads and lines."""
        wavelet = simple.Wavelet(WholeExtent=[0, 5, 0, 5, 0, 5])
        hexahedra = simple.MultidimensionalSubdivision(Input=wavelet, NumberOfLevels=1)
        self.assertEqual(cell_types(hexahedra), {12})
        whole = self.check_volume(hexahedra, "RTData")
        tetrahedra = simple.MultidimensionalSubdivision(Input=wavelet, NumberOfLevels=1, VolumeScheme="Standard")
        self.assertAlmostEqual(self.check_volume(tetrahedra, "RTData"), whole, delta=0.02)
        skin = simple.ExtractSurface(Input=wavelet)
        mixed = simple.MultidimensionalSubdivision(
            Input=simple.AppendDatasets(Input=[wavelet, skin, simple.ExtractEdges(Input=skin)]), MergePoints=1)
        self.assertLessEqual({3, 9, 12}, cell_types(mixed))
        self.assertAlmostEqual(self.check_volume(mixed, "RTData"), whole, delta=0.02)

    def test_volume_of_blocks(self):
        """All blocks, of solids of several types, and a surface without any."""
        left = simple.Wavelet(WholeExtent=[0, 3, 0, 5, 0, 5])
        right = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[3, 6, 0, 5, 0, 5]))
        group = simple.GroupDatasets(Input=[left, right, simple.ExtractSurface(Input=left)])
        blocks = simple.MultidimensionalSubdivision(Input=group, NumberOfLevels=1)
        blocks.UpdatePipeline()
        self.assertTrue(tools.output(blocks).IsA("vtkCompositeDataSet"))
        display = simple.Show(blocks, self.view)
        if "Volume" not in display.GetProperty("Representation").Available:
            self.skipTest("skipped: this ParaView offers no Volume of blocks")
        whole = simple.MultidimensionalSubdivision(Input=simple.AppendDatasets(Input=[left, right]), MergePoints=1)
        self.assertAlmostEqual(self.check_volume(blocks, "RTData"), self.check_volume(whole, "RTData"), delta=0.05)

    def test_volume(self):
        for solids in (self.solids, self.extracted, *self.mixed):  # the last ones have cells of all dimensions
            self.check_volume(solids)
        self.assertEqual(tools.numbers(tools.output(self.solids)), tools.numbers(tools.output(self.extracted)))
        self.assertGreater(tools.output(self.smooth).GetNumberOfCells(),
                           tools.output(self.solids).GetNumberOfCells())

    def test_dimensions_are_chosen_by_name_too(self):
        some = simple.ExtractDimensions(Input=self.smooth, OutputDimensions=["Surfaces", "Lines"])
        some.UpdatePipeline()
        self.assertEqual(list(some.OutputDimensions), ["Surfaces", "Lines"])
        kinds = [{grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}
                 for grid in (tools.output(self.smooth), tools.output(some))]
        self.assertTrue(kinds[1])
        self.assertEqual(kinds[1], kinds[0] & {3, 5})

    def test_surface(self):
        share, seen = self.picture(self.smooth, "Surface", "surface.png")
        self.assertTrue(0.1 < share < 0.9, f"drawn is {share:.2%} of the picture")
        # Tension goes from blue to red.
        self.assertTrue((seen[:, 2] - seen[:, 0] > 50).any() and (seen[:, 0] - seen[:, 2] > 50).any())


if __name__ == "__main__":
    tools.main()
