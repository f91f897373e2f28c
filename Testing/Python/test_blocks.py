# SPDX-License-Identifier: BSD-3-Clause
"""Files whose blocks share faces, through ParaView's readers: blocks are one mesh, and stay blocks."""

import os
import unittest

import numpy as np
import tools
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter

NAMES = ("below", "above")


def model():
    source = simple.SubdivisionModel(Model="MaterialBlock")
    source.UpdatePipeline()
    return tools.output(source)


def parts(mesh):
    """The cells of each material."""
    for material in range(len(NAMES)):
        threshold = vtkThreshold()
        threshold.SetInputData(mesh)
        threshold.SetInputArrayToProcess(0, 0, 0, 1, "MaterialId")
        threshold.SetLowerThreshold(material)
        threshold.SetUpperThreshold(material)
        threshold.Update()
        yield threshold.GetOutput()


def skin(mesh):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(mesh)
    surface.Update()
    return surface.GetOutput()


def write(meshes, name):
    blocks = vtkMultiBlockDataSet()
    for i, mesh in enumerate(meshes):
        blocks.SetBlock(i, mesh)
        blocks.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), NAMES[i])
    writer = vtkXMLMultiBlockDataWriter()
    writer.SetInputData(blocks)
    writer.SetFileName(os.path.abspath(name))
    writer.SetDataModeToAscii()  # with all digits; ParaView 5.11 with a newer Expat reads no appended data
    assert writer.Write()


def leaves(data):
    iterator = data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME()), iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def places(meshes):
    """The distinct points of meshes."""
    points = np.concatenate([vtk_to_numpy(mesh.GetPoints().GetData()) for mesh in meshes])
    return len(np.unique(points + 0., axis=0))


class Blocks(unittest.TestCase):
    def check(self, filter_, file_name, whole, **options):
        reader = simple.OpenDataFile(os.path.abspath(file_name))
        joined = filter_(Input=reader, NumberOfLevels=2, **options)
        apart = filter_(Input=reader, NumberOfLevels=2, JoinBlocks=0, **options)
        for proxy in (joined, apart):
            proxy.UpdatePipeline()
        found = list(leaves(tools.output(joined)))
        self.assertEqual(len(found), len(NAMES))
        meshes = [mesh for _, mesh in found]
        self.assertEqual(sum(mesh.GetNumberOfCells() for mesh in meshes), whole.GetNumberOfCells())
        self.assertEqual(places(meshes), places([whole]), "there is a crack")
        separate = [mesh for _, mesh in leaves(tools.output(apart))]
        self.assertEqual([mesh.GetNumberOfCells() for mesh in separate], [mesh.GetNumberOfCells() for mesh in meshes])
        return found, separate

    def check_materials(self, found):
        for material, (_, mesh) in enumerate(found):
            values = vtk_to_numpy(mesh.GetCellData().GetArray("MaterialId"))
            self.assertEqual(set(values), {material})

    def test_solids(self):
        write(parts(model()), "solids.vtm")
        whole = simple.MultidimensionalSubdivision(Input=simple.SubdivisionModel(Model="MaterialBlock"), NumberOfLevels=2)
        whole.UpdatePipeline()
        found, separate = self.check(simple.MultidimensionalSubdivision, "solids.vtm", tools.output(whole))
        self.assertEqual(tuple(name for name, _ in found), NAMES)
        self.check_materials(found)
        self.assertGreater(places(separate), places([tools.output(whole)]), "without JoinBlocks there are cracks")

    def test_surfaces(self):
        # Two halves of a box, without the interface between them.
        box = simple.Box()
        halves = []
        for side in (1, -1):
            clip = simple.Clip(Input=simple.Triangulate(Input=box), ClipType="Plane")
            clip.ClipType.Normal = [side, 0.0, 0.0]
            surface = simple.ExtractSurface(Input=clip)
            clean = simple.Clean(Input=surface)
            clean.UpdatePipeline()
            mesh = tools.output(clean)
            for name in ("Normals", "TCoords"):
                mesh.GetPointData().RemoveArray(name)
            halves.append(mesh)
        write(halves, "surfaces.vtm")
        grouped = simple.GroupDatasets(Input=[simple.XMLMultiBlockDataReader(FileName=[os.path.abspath("surfaces.vtm")])])
        merged = simple.Clean(Input=simple.ExtractSurface(Input=simple.MergeBlocks(Input=grouped)))
        whole = simple.SurfaceSubdivision(Input=merged, NumberOfLevels=2)
        whole.UpdatePipeline()
        found, _ = self.check(simple.SurfaceSubdivision, "surfaces.vtm", tools.output(whole))
        self.assertEqual(tuple(name for name, _ in found), NAMES)

    def test_exodus(self):
        try:
            from vtkmodules.vtkIOExodus import vtkExodusIIWriter
        except ImportError:
            self.skipTest("this ParaView has no vtkExodusIIWriter")
        writer = vtkExodusIIWriter()
        writer.SetInputData(model())
        writer.SetFileName(os.path.abspath("solids.exo"))
        writer.SetBlockIdArrayName("MaterialId")
        writer.SetStoreDoubles(1)
        writer.Write()
        whole = simple.MultidimensionalSubdivision(Input=simple.SubdivisionModel(Model="MaterialBlock"), NumberOfLevels=2)
        whole.UpdatePipeline()
        self.check(simple.MultidimensionalSubdivision, "solids.exo", tools.output(whole))


if __name__ == "__main__":
    tools.main()
