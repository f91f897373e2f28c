# SPDX-License-Identifier: BSD-3-Clause
"""An image, deformed with and without creases: the picture of Subdivision Deformation in the gallery, after figure 1 of
S. Schaefer, J. Hakenberg and J. Warren, "Smooth Subdivision of Tetrahedral Meshes".

A leaf of layers lies in a control mesh of quads in its plane. The points of its middle line are moved: by smooth rules alone
(middle), and with this line as a crease with corners (right), which goes where its points go. It is plain Python
(Documentation/Guide/Python.md says what PYTHONPATH has to be); `./dev pictures` runs it, too.
"""

import numpy as np
import picture_files
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws
from subdivisionobjects import deformation, meshes
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

SIZE = 900  # of a panel; the small picture has a quarter of it
PIXELS = 420
CELLS = 8


def layers():
    """An image from -1 to 1: layers on both sides of a line, which fade to the border of a leaf."""
    x, y = np.meshgrid(*2 * [np.linspace(-1, 1, PIXELS)])
    leaf = 0.8 * np.sqrt(np.clip(1 - (x / 0.93) ** 2, 0, None)) - np.abs(y)
    waves = 0.5 + 0.5 * np.cos(26 * np.abs(y) + 5 * x)
    cells = 0.5 + 0.5 * np.sin(40 * x + 9 * np.sin(7 * y)) * np.sin(43 * y)
    inside = 0.25 + 0.55 * waves + 0.2 * cells
    grey = np.where(leaf > 0, inside * np.clip(leaf / 0.1, 0.35, 1), 1.0)
    grey[(np.abs(y) < 0.012) & (leaf > 0)] = 0.05
    colours = np.stack([grey, 0.3 + 0.7 * grey, 0.45 + 0.55 * grey], axis=-1)
    image = vtkImageData()
    image.SetDimensions(PIXELS, PIXELS, 1)
    image.SetOrigin(-1, -1, 0)
    image.SetSpacing(2 / (PIXELS - 1), 2 / (PIXELS - 1), 1)
    image.GetPointData().SetScalars(numpy_to_vtk((255 * colours).astype(np.uint8).reshape(-1, 3), deep=True))
    return image


def control():
    """Points of a lattice, its quads, and the edges of its middle row."""
    ticks = np.linspace(-1.1, 1.1, CELLS + 1)
    points = np.array([[x, y, 0] for y in ticks for x in ticks])
    ids = np.arange((CELLS + 1) ** 2).reshape(CELLS + 1, CELLS + 1)
    quads = np.stack([ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]], axis=-1).reshape(-1, 4)
    middle = ids[CELLS // 2, 1:-1]
    return points, quads, middle, np.stack([middle[:-1], middle[1:]], axis=-1)


def mesh(points, quads, creases):
    """Corners, and the lines between them, flagged as singular, and the quads."""
    corners = np.unique(creases)[:, np.newaxis].astype(int)
    cells = {"vertex": corners, "line": creases, "quad": quads} if len(creases) else {"quad": quads}
    flags = np.repeat([1, 0], [len(corners) + len(creases), len(quads)])
    return meshes.to_vtk(points, cells, cell_data={"Singular": flags})


def surface(data, edges=False):
    faces = vtkGeometryFilter()
    faces.SetInputData(data)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(faces.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.LightingOff()
    if edges:
        mapper.ScalarVisibilityOff()
        look.SetRepresentationToWireframe()
        look.SetColor(0.8, 0.1, 0.1)
        look.SetLineWidth(2)
        look.SetOpacity(0.6)
        actor.SetPosition(0, 0, 0.01)
    return actor


def panel(image, lattice):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddViewProp(surface(image))
    renderer.AddViewProp(surface(lattice, edges=True))
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    renderer.GetActiveCamera().ParallelProjectionOn()
    renderer.ResetCamera(-1.1, 1.1, -1.1, 1.1, 0, 0.02)
    renderer.GetActiveCamera().SetParallelScale(1.13)
    window.Render()
    shot = vtkWindowToImageFilter()
    shot.SetInput(window)
    shot.ReadFrontBufferOff()
    shot.Update()
    return shot.GetOutput()


def main():
    image = layers()
    points, quads, middle, edges = control()
    moved = points.copy()
    moved[middle, 1] += 0.2 * np.where(np.arange(len(middle)) % 2 == 0, 1, -1)
    panels = [panel(image, mesh(points, quads, []))]
    for creases in ([], edges):
        rest, deformed = (mesh(at, quads, creases) for at in (points, moved))
        bent = deformation(image, rest_mesh=rest, deformed_mesh=deformed, surface_scheme="catmull-clark", embedding="limit")
        panels.append(panel(bent, deformed))
    picture_files.write_figure(panels, "gallery_deformed_image", len(panels))


main()
