# SPDX-License-Identifier: BSD-3-Clause
"""Pictures that are shaded by LimitNormals show no dark band: each pixel is nearly as bright as on a much finer mesh,
whose triangles are shaded by their own planes, so that no normal of a point has a part in it.

Pixels of triangles that touch a sharp edge, or a joint of more than two faces, are left out: a point has one normal
for all faces that meet there, so it is blended."""

import os
import unittest

import numpy as np
import tools
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 pylint: disable=unused-import

MODELS = ("MixedDimensions", "Screw", "SpringAndValve", "Ship", "MechanicalPart", "Character", "MaterialBlock", "Cylinder")
SIZE = 400
LEVELS, FINER = 2, 4
NEAR = 1e-3
SHARP = 20  # degrees between faces of the finer mesh
DIRECTIONS = ((3, -5, 3), (-4, 3, -2), (1, 4, 3), (-3, -3, 1))
MUCH = 64  # of 255
MOST = 0.001  # of the pixels that are compared


def surface(grid):
    """The triangles that are drawn, without lines: cell arrays of poly data have an entry for each of these, too."""
    skin = vtkDataSetSurfaceFilter()
    skin.SetInputData(grid)
    skin.Update()
    triangles = vtkPolyData()
    triangles.SetPoints(skin.GetOutput().GetPoints())
    triangles.SetPolys(skin.GetOutput().GetPolys())
    triangles.GetPointData().ShallowCopy(skin.GetOutput().GetPointData())
    return triangles


def touches_sharp(faces, finer):
    """Which faces touch a sharp edge or a joint: those with a corner near such an edge of the finer mesh, for both meshes lie
    on the limit."""
    edges = vtkFeatureEdges()
    edges.SetInputData(finer)
    edges.SetFeatureAngle(SHARP)
    edges.BoundaryEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    is_sharp = np.zeros(faces.GetNumberOfPoints(), bool)
    if edges.GetOutput().GetNumberOfCells():
        locator = vtkStaticCellLocator()
        locator.SetDataSet(edges.GetOutput())
        locator.BuildLocator()
        for i in range(faces.GetNumberOfPoints()):
            found, cell, part, distance = [0.0] * 3, reference(0), reference(0), reference(0.0)
            is_sharp[i] = locator.FindClosestPointWithinRadius(
                faces.GetPoint(i), finer.GetLength() * NEAR, found, vtkGenericCell(), cell, part, distance)
    polygons = faces.GetPolys()
    corners = is_sharp[vtk_to_numpy(polygons.GetConnectivityArray())].astype(int)
    return np.add.reduceat(corners, vtk_to_numpy(polygons.GetOffsetsArray())[:-1]) > 0


class Picture:
    """What a camera without perspective sees of one data set from several sides."""

    def __init__(self, data, bounds):
        self.mapper = vtkPolyDataMapper()
        self.mapper.SetInputData(data)
        self.mapper.ScalarVisibilityOff()
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0, 0, 0)
        self.renderer.AddActor(self.actor)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        self.renderer.GetActiveCamera().ParallelProjectionOn()
        self.bounds = bounds

    def look(self, direction):
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(0, 0, 0)
        camera.SetPosition(direction)
        camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCamera(self.bounds)
        self.renderer.ResetCameraClippingRange(self.bounds)
        self.window.Render()
        image = vtkWindowToImageFilter()
        image.SetInput(self.window)
        image.ReadFrontBufferOff()
        image.Update()
        return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())[:, 0].astype(int)

    def depth(self):
        image = vtkWindowToImageFilter()
        image.SetInput(self.window)
        image.SetInputBufferTypeToZBuffer()
        image.Update()
        return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())

    def shade(self, flat):
        looks = self.actor.GetProperty()
        looks.SetAmbient(0)
        looks.SetDiffuse(1)
        looks.SetSpecular(0)
        if flat:
            looks.SetInterpolationToFlat()

    def show(self, cells):
        """The flags of cells, white or black."""
        flags = numpy_to_vtk(np.where(cells, 255, 0).astype(np.uint8), deep=True)
        flags.SetName("Flag")
        self.mapper.GetInput().GetCellData().SetScalars(flags)
        self.mapper.ScalarVisibilityOn()
        self.mapper.SetScalarModeToUseCellData()
        self.mapper.SetColorModeToDirectScalars()
        self.actor.GetProperty().LightingOff()


def subdivide(source, levels=LEVELS):
    return simple.MultidimensionalSubdivision(
        Input=source, NumberOfLevels=levels, ProjectToLimit=1, GenerateLimitNormals=1, OutputDimensions=[2, 3])


def refine(source):
    """Large and small triangles beside each other, from levels that differ."""
    return simple.RedGreenRefinement(
        Input=source, Shape="Smooth", GenerateLimitNormals=1, RefineByAttributeError=0, RefineByGeometricError=1,
        GeometricTolerance=5e-4, MaximumLevel=FINER)


class Shading(unittest.TestCase):
    def check(self, name, source, make=subdivide):
        meshes = []
        for proxy in (make(source), subdivide(source, FINER)):
            proxy.UpdatePipeline()
            meshes.append(surface(tools.output(proxy)))
        mesh, finer = meshes
        bounds = finer.GetBounds()
        pictures = [Picture(mesh, bounds), Picture(finer, bounds)]
        for picture, flat in zip(pictures, (False, True)):
            picture.shade(flat)
        flagged = Picture(surface(mesh), bounds)
        sharp = touches_sharp(mesh, finer)
        flagged.show(~sharp)
        for direction in DIRECTIONS:
            bright, exact = (picture.look(direction) for picture in pictures)
            near, far = (picture.depth() for picture in pictures)
            smooth = flagged.look(direction) > 128
            drawn = (near < 1) & (far < 1)
            same = smooth & drawn & (abs(near - far) < 0.005)
            difference = (bright - exact)[same]
            with self.subTest(f"{name} from {direction}"):
                self.assertGreater(drawn.mean(), 0.03)
                self.assertGreater(same.sum(), 0.3 * drawn.sum())
                self.assertLess((difference < -MUCH).mean(), MOST, "dark")
                self.assertLess((difference > MUCH).mean(), MOST, "bright")

    def test_models(self):
        for model in MODELS:
            with self.subTest(model):
                self.check(model, simple.SubdivisionModel(Model=model))

    def test_locally_refined(self):
        for model in MODELS:
            with self.subTest(model):
                self.check(model, simple.SubdivisionModel(Model=model), refine)

    def test_sources(self):
        for name, source in (("Box", simple.Box()), ("Sphere", simple.Sphere()),
                             ("Cylinder", simple.Cylinder(Resolution=12))):
            with self.subTest(name):
                self.check(name, simple.Clean(Input=source))

    def test_cut_bunny(self):
        path = os.path.join(os.environ.get("SUBDIVISIONOBJECTS_SHARED_DATA", "../shared/data"), "surf_bunny_3k.vtp")
        if not os.path.exists(path):
            self.skipTest(f"skipped: {path} is missing")
        cut = simple.Clip(Input=simple.Clean(Input=simple.XMLPolyDataReader(FileName=[path])), ClipType="Plane")
        cut.ClipType.Normal = [1.0, 0.0, 0.2]
        self.check("cut bunny", cut)


if __name__ == "__main__":
    tools.main()
