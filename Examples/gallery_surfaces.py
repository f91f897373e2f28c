# SPDX-License-Identifier: BSD-3-Clause
"""A cube and a tetrahedron by every scheme of Surface Subdivision:
gallery_surfaces_cube.png and gallery_surfaces_tetrahedron.png.

`./dev demo` makes them after the features; `pvpython --force-offscreen-rendering gallery_surfaces.py`
makes only these (see demo.py for the environment that it needs). The survey's figures 11 and 12.
"""

import os

import demo_pictures as look
import numpy as np
import picture_files
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

CUBE = ([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)],
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
TETRAHEDRON = ([[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
SCHEMES = ["Loop", "Modified Butterfly", "Catmull-Clark", "Doo-Sabin", "Midedge", "Four-Eight", "Sqrt Three"]
LEVELS = {"Four-Eight": 8, "Sqrt Three": 6, "Midedge": 8}


def mesh(points, faces):
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.array(points, dtype=float), deep=True))
    polygons = vtkCellArray()
    for face in faces:
        polygons.InsertNextCell(len(face), face)
    made = vtkPolyData()
    made.SetPoints(coordinates)
    made.SetPolys(polygons)
    return made


def subdivide(control, scheme):
    """What a scheme makes of it, by the plugin's filter."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(control)
    smooth = simple.SurfaceSubdivision(Input=source, Scheme=scheme, NumberOfLevels=LEVELS.get(scheme, 5))
    smooth.UpdatePipeline()
    made = vtkPolyData()
    made.ShallowCopy(smooth.GetClientSideObject().GetOutputDataObject(0))
    simple.Delete(smooth)
    simple.Delete(source)
    return made


def row(title, control):
    """Images of a mesh and what each scheme makes of it, at the same scale."""
    shown = [(f"{title}\ncontrol mesh", control, True)]
    shown += [(scheme, subdivide(control, scheme), False) for scheme in SCHEMES]
    frame = np.concatenate([look.points_of(data).astype(float) for _, data, _ in shown])
    images = []
    for words, data, edges in shown:
        actor = look.polygons(data, None, edges, False)
        actor.GetProperty().SetColor(0.62, 0.74, 0.86)
        images.append(look.render([actor], [look.caption(words)], frame, (0.45, -1.0, 0.35)))
    return images


def draw():
    for name, shape in (("Cube", CUBE), ("Tetrahedron", TETRAHEDRON)):
        picture_files.write_figure(row(name, mesh(*shape)), f"gallery_surfaces_{name.lower()}", 4)
    print(f"The schemes for surfaces are in gallery_surfaces_*.png in {os.getcwd()}.")


if __name__ == "__main__":
    import demo

    demo.load_plugin()
    draw()
