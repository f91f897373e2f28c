# SPDX-License-Identifier: BSD-3-Clause
"""Objects bent by the coarse control mesh around them: deformation_knot.png and
deformation_sheets.png.

A knot with bumps, 72,000 quads, in a cage of 60 hexahedra (that is, 360 tetrahedra), in three poses;
and a test pattern of parallel sheets in a cylinder with creased edges, before and after (like figure 8
of Schaefer, Hakenberg and Warren, "Smooth Subdivision of Tetrahedral Meshes").

`./dev demo` makes these after the gallery; `pvpython --force-offscreen-rendering deformation.py` makes
only these (see demo.py for the environment that it needs).
"""

import math
import os
import time

import demo_pictures as look
import numpy as np
import picture_files
from gallery import Mesh, subdivide
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_TETRA, vtkCellArray, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkFeatureEdges, vtkPolyDataNormals

SHEET_COLOURS = [(0.93, 0.76, 0.55), (0.30, 0.47, 0.66)]
KNOT_COLOURS = (0.86, 0.60, 0.56)


def to_points(array):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(array, dtype=float), deep=True))
    return points


def quads(array, closed=(False, False)):
    """Poly data of an array of points in rows; `closed`: the last row, column joins the first."""
    rows, columns = array.shape[:2]
    ids = np.arange(rows * columns).reshape(rows, columns)
    for axis in (0, 1):
        if closed[axis]:
            ids = np.concatenate([ids, ids.take([0], axis)], axis)
    cells = np.stack([ids[:-1, :-1], ids[1:, :-1], ids[1:, 1:], ids[:-1, 1:]], axis=-1).reshape(-1, 4)
    polys = vtkCellArray()
    polys.SetData(4, numpy_to_vtk(cells.astype(np.int64).ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(to_points(array.reshape(-1, 3)))
    data.SetPolys(polys)
    return data


# ---------------------------------------------------------------- the deformation

def source_of(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


class Deformation:
    """An object in a cage; poses are functions on the points of the cage."""

    def __init__(self, thing, cage, **options):
        self.cage = cage
        self.moved = cage.NewInstance()
        self.moved.ShallowCopy(cage)
        self.source = source_of(self.moved)
        self.proxy = simple.SubdivisionDeformation(
            Input=source_of(thing), RestMesh=source_of(cage), DeformedMesh=self.source, **options)

    def pose(self, map_points):
        """The cage and the object in a pose, and the seconds that it took."""
        rest = vtk_to_numpy(self.cage.GetPoints().GetData())
        self.moved.SetPoints(to_points(map_points(rest)))
        self.source.MarkModified(self.source)
        start = time.perf_counter()
        self.proxy.UpdatePipeline()
        seconds = time.perf_counter() - start
        cage = self.moved.NewInstance()
        cage.ShallowCopy(self.moved)
        output = self.proxy.GetClientSideObject().GetOutputDataObject(0)
        data = output.NewInstance()
        data.ShallowCopy(output)
        return cage, data, seconds


def wires(cage, size):
    """The edges of the hull of a cage, as thin tubes."""
    edges = vtkFeatureEdges()
    edges.SetInputData(look.surface_of(look.of_types(cage, VTK_TETRA, VTK_HEXAHEDRON)))
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOn()
    edges.ColoringOff()
    edges.Update()
    actor = look.tubes(edges.GetOutput(), 0.0015 * size, None)
    actor.GetProperty().SetColor(0.35, 0.38, 0.43)
    return [actor]


def check_all_inside(deformation):
    """Also that the cage was subdivided but once."""
    told = str(deformation.proxy.GetClientSideObject())
    if "NumberOfOutsidePoints: 0" not in told or "NumberOfTopologyBuilds: 1" not in told:
        raise RuntimeError("what is deformed is to be inside its cage, which is subdivided once")


def shaded(data, colour):
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.Update()
    actor = look.polygons(normals.GetOutput(), None, False, False)
    actor.GetProperty().SetColor(*colour)
    return actor


def coloured(actors):
    for actor in actors:
        actor.GetProperty().SetColor(*look.PALETTE[2])
    return actors


def titled(words):
    return [look.caption(words)]


# ---------------------------------------------------------------- the knot

def knot(along=1200, around=60):
    """A trefoil, thick, with bumps and a spiral groove."""
    t = np.linspace(0, 2 * math.pi, along, endpoint=False)

    def curve(s):
        return np.stack([np.sin(s) + 2 * np.sin(2 * s), np.cos(s) - 2 * np.cos(2 * s), -1.1 * np.sin(3 * s)], -1)

    centre = curve(t)
    tangent = curve(t + 1e-4) - curve(t - 1e-4)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    side = np.cross(tangent, [0, 0, 1])
    side /= np.linalg.norm(side, axis=1)[:, None]
    up = np.cross(side, tangent)
    a = np.linspace(0, 2 * math.pi, around, endpoint=False)
    radius = (0.48 + 0.05 * np.sin(48 * t)[:, None] * np.sin(6 * a)[None, :]
              + 0.05 * np.cos(a[None, :] + 12 * t[:, None]))
    ring = np.cos(a)[None, :, None] * side[:, None, :] + np.sin(a)[None, :, None] * up[:, None, :]
    return quads(centre[:, None, :] + radius[:, :, None] * ring, (True, True))


def block_cage(low, high, counts):
    mesh = Mesh()
    low, high = np.array(low, float), np.array(high, float)

    def place(x):
        return tuple(low + (high - low) * np.array(x) / counts)

    mesh.block((0, 0, 0), counts, place)
    return mesh.grid()


def twist(x):
    angle = 0.35 * x[:, 0]
    return np.stack([x[:, 0], np.cos(angle) * x[:, 1] - np.sin(angle) * x[:, 2],
                     np.sin(angle) * x[:, 1] + np.cos(angle) * x[:, 2]], axis=1)


def bend(x):
    angle, radius = 0.36 * x[:, 0], 3.4 + x[:, 2]
    return np.stack([radius * np.sin(angle), x[:, 1], radius * np.cos(angle) - 3.4], axis=1)


def squeeze(x):
    scale = 0.5 + 0.04 * x[:, 0] ** 2
    return np.stack([1.25 * x[:, 0], scale * x[:, 1], np.sqrt(scale) * x[:, 2]], axis=1)


def draw_knot():
    thing = knot()
    cage = block_cage((-4.1, -4.1, -2.4), (4.1, 4.1, 2.4), (5, 4, 3))
    deformation = Deformation(thing, cage, NumberOfLevels=3)
    images = []
    for words, pose in (("at rest", lambda x: x), ("twisted", twist), ("bent", bend), ("squeezed", squeeze)):
        moved, data, seconds = deformation.pose(pose)
        print(f"Knot, {data.GetNumberOfPoints():,} points, {words}: {1000 * seconds:.1f} ms", flush=True)
        frame = vtk_to_numpy(moved.GetPoints().GetData())
        images.append(look.render([shaded(data, KNOT_COLOURS)] + wires(moved, 10), titled(words), frame,
                                  (0.35, -1.0, 0.75)))
    check_all_inside(deformation)
    return images


# ---------------------------------------------------------------- the test pattern (figure 8)

def cylinder():
    """The built-in model, whose rims are creases."""
    source = simple.SubdivisionModel(Model="Cylinder")
    source.UpdatePipeline()
    cage = vtkUnstructuredGrid()
    cage.ShallowCopy(source.GetClientSideObject().GetOutputDataObject(0))
    return cage


def sheets(radius=1.25, low=0.05, high=2.95, count=5, resolution=161):
    """Upright parallel sheets in a cylinder, with squares of two colours."""
    joined = vtkAppendPolyData()
    for y in np.linspace(-0.8, 0.8, count) * radius:
        half = math.sqrt(radius ** 2 - y ** 2)
        u, z = np.meshgrid(np.linspace(-half, half, resolution), np.linspace(low, high, resolution), indexing="ij")
        sheet = quads(np.stack([u, np.full_like(u, y), z], axis=-1))
        middle = (u[:-1, :-1] + u[1:, 1:]) / 2, (z[:-1, :-1] + z[1:, 1:]) / 2
        parity = (np.floor(middle[0] / 0.29 + 0.5) + np.floor((middle[1] - low) / 0.29)) % 2
        squares = numpy_to_vtk(parity.reshape(-1).astype(np.int32), deep=True)
        squares.SetName("Square")
        sheet.GetCellData().AddArray(squares)
        joined.AddInputData(sheet)
    joined.Update()
    return joined.GetOutput()


def push(x):
    """Leaning, turned at the top, and pulled out at one side."""
    z = x[:, 2]
    angle = 0.35 * z
    turned = np.stack([np.cos(angle) * x[:, 0] - np.sin(angle) * x[:, 1],
                       np.sin(angle) * x[:, 0] + np.cos(angle) * x[:, 1], z], axis=1)
    turned[:, 0] += 0.16 * z ** 2
    turned[:, 2] += 0.25 * x[:, 0] * (z > 1.5)
    return turned


def draw_pattern():
    cage, pattern = cylinder(), sheets()
    squares = "cell", "Square", look.category_colours([("", colour) for colour in SHEET_COLOURS])
    deformation = Deformation(pattern, cage, NumberOfLevels=4)
    direction = (1.0, -0.7, 0.5)
    frame = vtk_to_numpy(cage.GetPoints().GetData())
    solids = look.surface_of(look.of_types(subdivide(cage, 4), VTK_TETRA))
    images = [
        look.render(coloured(look.actors_of(cage, None, 4.0, edges=True)), titled("control mesh, rims creased"), frame,
                    direction),
        look.render([shaded(solids, look.PALETTE[2])], titled("subdivided"), frame, direction)]
    for words, pose in (("parallel sheets in it", lambda x: x), ("deformed", push)):
        moved, data, seconds = deformation.pose(pose)
        print(f"Sheets, {data.GetNumberOfPoints():,} points, {words}: {1000 * seconds:.1f} ms", flush=True)
        images.append(look.render([look.polygons(data, squares, False, False)] + wires(moved, 4), titled(words),
                                  vtk_to_numpy(moved.GetPoints().GetData()), direction))
    check_all_inside(deformation)
    return images


def draw():
    picture_files.write_figure(draw_knot(), "deformation_knot", 2)
    picture_files.write_figure(draw_pattern(), "deformation_sheets", 2)
    print(f"The deformations are in deformation_*.png in {os.getcwd()}.")


if __name__ == "__main__":
    import demo

    demo.load_plugin()
    draw()
