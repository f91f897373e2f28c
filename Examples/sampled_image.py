# SPDX-License-Identifier: BSD-3-Clause
"""A part of two materials as an image, in volume rendering: the picture of Sample Smooth Object in the guide.

It is plain Python (Documentation/Guide/Python.md says what PYTHONPATH has to be); `./dev pictures` runs it, too.
"""

import numpy as np
import picture_files
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401, draws volumes
from subdivisionobjects import meshes, model, sample
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume, vtkVolumeProperty,
    vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper

SIZE = 1200  # of a panel; the small picture has a quarter of it
BLUE, ORANGE = (0.45, 0.62, 0.88), (0.98, 0.66, 0.3)
DIRECTION = (0.5, -1.0, 0.75)


def colours(points):
    made = vtkColorTransferFunction()
    for value, colour in points:
        made.AddRGBPoint(value, *colour)
    return made


def spread(values, inside):
    """Values inside, and means of these in the samples around: so no colour of the outside is mixed with them."""
    values, weights = np.where(inside, values, 0.0), inside.astype(float)
    for _ in range(3):
        sums, counts = values * weights, weights.copy()
        for axis in range(3):
            for step in (-1, 1):
                sums += np.roll(values * weights, step, axis)
                counts += np.roll(weights, step, axis)
        values = np.where(weights > 0, values, sums / np.maximum(counts, 1))
        weights = np.maximum(weights, counts > 0)
    return values


def blurred(values):
    """Means of the samples around each."""
    for axis in 2 * (0, 1, 2):
        values = (np.roll(values, 1, axis) + 2 * values + np.roll(values, -1, axis)) / 4
    return values


def control_mesh(mesh):
    faces = vtkGeometryFilter()
    faces.SetInputData(mesh)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(faces.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("MaterialId")
    mapper.SetLookupTable(colours([(0, BLUE), (1, ORANGE)]))
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.2, 0.25, 0.35)
    look.SetLineWidth(3)
    return actor


def volume(image, values, coverage, transfer):
    """Colours by values, as dense as the coverage: boundaries are as smooth as the object."""
    low, high = transfer.GetRange()
    table = np.array([transfer.GetColor(low + part * (high - low)) for part in np.linspace(0, 1, 256)])
    chosen = table[np.clip((values - low) / (high - low) * 255, 0, 255).astype(int)]
    chosen[blurred(coverage) < 1e-6] = 1
    pixels = np.concatenate([chosen, coverage[..., np.newaxis]], axis=-1) * 255
    data = image.to_vtk()
    data.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 4).astype(np.uint8), deep=True))
    mapper = vtkFixedPointVolumeRayCastMapper()
    mapper.SetInputData(data)
    step = image.spacing[0] / 4
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(step)
    mapper.SetImageSampleDistance(1)
    opacity = vtkPiecewiseFunction()
    # Blocks that are dense nowhere are left out, and in VTK 9.1 others with them: so there is a trace of fog.
    for value, dense in ((0, 6.2e-5), (80, 6.2e-5), (180, 1), (255, 1)):
        opacity.AddPoint(value, dense)
    look = vtkVolumeProperty()
    look.IndependentComponentsOff()
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(step)
    look.SetInterpolationTypeToLinear()
    look.ShadeOn()
    look.SetAmbient(0.3)
    look.SetDiffuse(0.85)
    look.SetSpecular(0.25)
    look.SetSpecularPower(30)
    made = vtkVolume()
    made.SetMapper(mapper)
    made.SetProperty(look)
    return made


def panel(prop, bounds):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddViewProp(prop)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(SIZE, round(0.64 * SIZE))
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(DIRECTION)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera(bounds)
    camera.Zoom(1.33)
    renderer.ResetCameraClippingRange(bounds)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    pixels = picture_files.pixels_of(image.GetOutput())
    pixels[pixels.min(axis=2) > 235] = 255  # the fog
    return image.GetOutput()


def main():
    mesh = model(model="MechanicalPart")
    image = meshes.to_samples(sample(mesh, number_of_samples=200, generate_coverage=True, thickness=0.16, margin=4))
    print(image)
    inside = image["vtkValidPointMask"] != 0
    handle = blurred((inside & (image["Material"] == 1)).astype(float))  # a surface, which coverage leaves out
    coverage = np.maximum(image["Coverage"], handle)
    opened = coverage.copy()
    opened[:, :opened.shape[1] // 2] = 0
    bounds = np.array(mesh.GetBounds()) - (0, 0, 0, 0, 1, 0)  # the handle has room above it already
    materials = colours([(0, BLUE), (1, ORANGE)])
    low, high = image["Tension"][inside].min(), image["Tension"][inside].max()
    tensions = colours([(low, (0.23, 0.3, 0.75)), ((low + high) / 2, (0.87, 0.87, 0.87)), (high, (0.7, 0.02, 0.15))])
    views = [control_mesh(mesh), volume(image, spread(image["Material"], inside), coverage, materials),
             volume(image, spread(image["Tension"], inside), opened, tensions)]
    picture_files.write_figure([panel(view, bounds) for view in views], "sampled_image", len(views))


main()
