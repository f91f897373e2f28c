# SPDX-License-Identifier: BSD-3-Clause
"""What the tutorials share: it draws meshes beside each other, into a file that has the name of the script."""

import pathlib
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401, draws volumes
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolume import vtkUnstructuredGridVolumeRayCastMapper

BLUE, WHITE, RED = (0.23, 0.3, 0.75), (0.87, 0.87, 0.87), (0.7, 0.02, 0.15)


def colours(low, high):
    made = vtkColorTransferFunction()
    for part, colour in ((0, BLUE), (0.5, WHITE), (1, RED)):
        made.AddRGBPoint(low + part * (high - low), *colour)
    return made


def surface(data, array, edges, colour, curved=False):
    """Its faces, coloured by an array of points or cells; curved ones in small parts."""
    faces = vtkGeometryFilter()
    faces.SetNonlinearSubdivisionLevel(3 if curved else 1)
    faces.SetInputData(data)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(faces.GetOutputPort())
    mapper.SetColorModeToMapScalars()
    mapper.ScalarVisibilityOff()
    for side, mode in ((data.GetPointData(), "Point"), (data.GetCellData(), "Cell")):
        if array and side.HasArray(array):
            getattr(mapper, f"SetScalarModeToUse{mode}FieldData")()
            mapper.SelectColorArray(array)
            low, high = side.GetArray(array).GetRange(0)
            mapper.SetLookupTable(colours(low - 1e-3 * (high - low), high))
            mapper.UseLookupTableScalarRangeOn()
            mapper.ScalarVisibilityOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(colour)
    look.SetEdgeVisibility(edges)
    look.SetEdgeColor(0.4, 0.45, 0.55)
    return actor


def volume(data, array):
    """Its solids, as a cloud."""
    low, high = data.GetPointData().GetArray(array).GetRange()
    data.GetPointData().SetActiveScalars(array)
    mapper = vtkUnstructuredGridVolumeRayCastMapper()
    mapper.SetInputData(data)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(low, 0)
    opacity.AddPoint(high, 6 / data.GetLength())
    made = vtkVolume()
    made.SetMapper(mapper)
    made.GetProperty().SetColor(colours(low, high))
    made.GetProperty().SetScalarOpacity(opacity)
    return made


def picture(*views, array=None, edges=True, cloud=False, curved=False, direction=(0.63, -1, 0.47)):
    """Each view is a mesh, or a list of meshes that are drawn together, the first one with edges, all others in red."""
    size = (400, (300, 260, 180, 130)[len(views) - 1])
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(size)
    for number, view in enumerate(views):
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        renderer.SetViewport(number / len(views), 0, (number + 1) / len(views), 1)
        for index, mesh in enumerate(view if isinstance(view, list) else [view]):
            data = mesh.to_vtk() if hasattr(mesh, "to_vtk") else mesh
            look = (edges, (0.75, 0.8, 0.9)) if index == 0 else (False, RED)
            renderer.AddViewProp(volume(data, array) if cloud else surface(data, array, *look, curved))
        window.AddRenderer(renderer)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(direction)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCamera()
        camera.SetWindowCenter(0.013, 0.007)  # rays along edges of cells would see nothing
        camera.Zoom(1.2 * min(1, size[0] / len(views) / size[1]))
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(pathlib.Path(sys.argv[0]).stem + ".png")
    writer.Write()
    print("wrote", writer.GetFileName())
