# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's Information panel lists first: the user's own arrays, then what a filter adds. ParaView up to 5.13 sorts
the arrays of points, of cells and of fields by their names, later ones show them in the order of the data."""

import unittest

import tools
from paraview import simple

OWN = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
output = self.GetOutput()
for data, size in ((output.GetPointData(), output.GetNumberOfPoints()), (output.GetCellData(), output.GetNumberOfCells()),
                   (output.GetFieldData(), 3)):
    for name in ("mine", "yours"):
        array = vtkDoubleArray()
        array.SetName(name)
        array.SetNumberOfTuples(size)
        array.Fill(1)
        data.AddArray(array)
"""


def names(data):
    return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]


class Information(unittest.TestCase):
    def setUp(self):
        self.solids = simple.ProgrammableFilter(Input=simple.SubdivisionModel(Model="MaterialBlock"), CopyArrays=1, Script=OWN)
        self.surface = simple.ProgrammableFilter(Input=simple.Sphere(), CopyArrays=1, Script=OWN)

    def check(self, make, mesh):
        """One filter with all arrays that it can generate, and a second one behind it."""
        for _ in range(2):
            proxy = make(Input=mesh)
            for name in proxy.ListProperties():
                if name.startswith("Generate"):
                    setattr(proxy, name, 1)
            with tools.quiet():
                proxy.UpdatePipeline()
            given, made = tools.output(mesh), tools.output(proxy)
            for kind in ("GetPointData", "GetCellData", "GetFieldData"):
                before, after = names(getattr(given, kind)()), names(getattr(made, kind)())
                added = [i for i, name in enumerate(after) if name not in before]
                own = [i for i, name in enumerate(after) if name in ("mine", "yours")]
                with self.subTest(f"{make.__name__}.{kind}", arrays=after):
                    self.assertTrue(kind == "GetCellData" or len(own) == 2)
                    self.assertTrue(not own or not added or max(own) < min(added))
                    ours = [i for i, name in enumerate(after) if name.startswith(
                        ("Subdivision", "RedGreen", "vtkOriginal", "Global", "Octahedron", "Limit"))]
                    self.assertTrue(not own or not ours or max(own) < min(ours))
            mesh = proxy

    def test_filters_for_solids(self):
        self.check(lambda **options: simple.MultidimensionalSubdivision(VolumeScheme="Tet/Oct", **options), self.solids)
        for placement in ("Linear", "Limit"):
            self.check(lambda placement=placement, **options: simple.RedGreenRefinement(
                Shape=placement, RefineByEdgeLength=1, MaximumEdgeLength=0.3, **options), self.solids)
        self.check(simple.SimplicialComplexTopology, self.solids)
        self.check(simple.ExtractDimensions, self.solids)

    def test_filters_for_surfaces(self):
        for scheme in ("Loop", "Catmull-Clark"):
            self.check(lambda scheme=scheme, **options: simple.SurfaceSubdivision(Scheme=scheme, **options), self.surface)
        self.check(lambda **options: simple.AdaptiveSurfaceSubdivision(
            RefineByEdgeLength=1, MaximumEdgeLength=0.1, **options), self.surface)

    def test_deformation(self):
        cage = simple.CageAround(Input=self.surface)
        self.check(lambda **options: simple.SubdivisionDeformation(RestMesh=cage, DeformedMesh=cage, **options), self.surface)

    def test_blocks(self):
        blocks = simple.GroupDatasets(Input=[self.surface, simple.Transform(Input=self.surface)])
        proxy = simple.SurfaceSubdivision(Input=blocks, GenerateLimitNormals=1, GenerateTangents=1, GenerateOriginalIds=1)
        proxy.UpdatePipeline()
        block = tools.output(proxy)
        while not hasattr(block, "GetPointData"):
            block = block.GetBlock(0) if hasattr(block, "GetBlock") else block.GetPartitionedDataSet(0).GetPartition(0)
        self.assertEqual([name for name in names(block.GetPointData()) if name in ("mine", "yours")],
                         names(block.GetPointData())[:2])

    def test_panel(self):
        """The panel reads this: points, then cells, then fields, where the stamp stands."""
        proxy = simple.SurfaceSubdivision(Input=self.surface, GenerateLimitNormals=1)
        proxy.UpdatePipeline()
        information = proxy.SMProxy.GetDataInformation().GetPointDataInformation()
        listed = [information.GetArrayInformation(i).GetName() for i in range(information.GetNumberOfArrays())]
        inside = names(tools.output(proxy).GetPointData())
        self.assertIn(listed, (sorted(inside, key=str.lower), inside))


if __name__ == "__main__":
    unittest.main()
