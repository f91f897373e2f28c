# SPDX-License-Identifier: BSD-3-Clause
"""What every feature does, on small meshes: gallery_*.png.

`./dev demo` makes these after the built-in models; `pvpython --force-offscreen-rendering gallery.py`
makes only these (see demo.py for the environment that it needs).
"""

import itertools
import math
import os

import demo_pictures as look
import numpy as np
import picture_files
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_LINE, VTK_QUAD, VTK_TRIANGLE, VTK_VERTEX, VTK_WEDGE,
    vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkThreshold

LEVELS = 4
KINDS = {1: VTK_VERTEX, 2: VTK_LINE, 3: VTK_TRIANGLE, 4: VTK_QUAD, 6: VTK_WEDGE, 8: VTK_HEXAHEDRON}


class Mesh:
    """A control mesh. Points are found by their coordinates: parts that touch share them."""

    def __init__(self):
        self.points, self.ids, self.cells = [], {}, []

    def point(self, x):
        key = tuple(round(float(value), 6) for value in x)
        if key not in self.ids:
            self.ids[key] = len(self.points)
            self.points.append(key)
        return self.ids[key]

    def cell(self, *corners, part=0, singular=0):
        self.cells.append(([self.point(x) for x in corners], part, singular))

    def curve(self, *points, **options):
        for a, b in zip(points, points[1:]):
            self.cell(a, b, **options)

    def sheet(self, corner, count_u, count_v, **options):
        """Quads; corner(u, v) is a point."""
        for u, v in itertools.product(range(count_u), range(count_v)):
            self.cell(corner(u, v), corner(u + 1, v), corner(u + 1, v + 1), corner(u, v + 1), **options)

    def block(self, low, counts, bend=lambda x: x, part=lambda i, j, k: 0):
        """Hexahedra of size 1."""
        for i, j, k in itertools.product(*map(range, counts)):
            corners = [(low[0] + i + a, low[1] + j + b, low[2] + k + c)
                       for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            self.cell(*map(bend, corners), part=part(i, j, k))

    def grid(self, flagged=True):
        """The mesh, with its flagged cells or without them."""
        cells = [cell for cell in self.cells if flagged or not cell[2]]
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        points.SetDataTypeToDouble()
        for x in self.points:
            points.InsertNextPoint(*x)
        grid.SetPoints(points)
        for ids, _, _ in cells:
            grid.InsertNextCell(KINDS[len(ids)], len(ids), ids)
        for name, values in (("MaterialId", [part for _, part, _ in cells]),
                             ("Singular", [singular for _, _, singular in cells])):
            array = numpy_to_vtk(np.array(values, dtype=np.int32), deep=True)
            array.SetName(name)
            grid.GetCellData().AddArray(array)
        return grid


# ---------------------------------------------------------------- what the pictures show

def subdivide(grid, levels=LEVELS, **options):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(grid)
    subdivision = simple.MultidimensionalSubdivision(
        Input=source, NumberOfLevels=levels, GenerateClassification=1, **options)
    subdivision.UpdatePipeline()
    smooth = subdivision.GetClientSideObject().GetOutputDataObject(0)
    if smooth.GetNumberOfCells() == 0:
        raise RuntimeError("the gallery was not subdivided, see above")
    return smooth


def only_cells(grid, array, value):
    chosen = vtkThreshold()
    chosen.SetInputData(grid)
    chosen.SetInputArrayToProcess(0, 0, 0, 1, array)
    chosen.SetLowerThreshold(value)
    chosen.SetUpperThreshold(value)
    chosen.Update()
    return chosen.GetOutput()


class Figure:
    """Pictures of the same size, seen from the same side; the first is the control mesh."""

    def __init__(self, name, title, mesh, direction):
        self.name, self.direction = name, direction
        self.control = subdivide(mesh, 0)
        self.frame = look.used_points(self.control)
        self.size = math.dist(self.frame.min(axis=0), self.frame.max(axis=0))
        self.pictures = []
        self.draw(f"{title}\ncontrol mesh", self.actors(self.control, edges=True) + self.flags(self.control))

    def actors(self, grid, colouring=None, edges=False):
        return look.actors_of(grid, colouring or look.part_array(self.control), self.size, edges=edges)

    def flags(self, grid):
        """The singular points and lines, in the colours of their rules."""
        if not grid.GetCellData().HasArray("Singular"):
            return []
        singular = only_cells(grid, "Singular", 1)
        lines, dots = look.of_types(singular, VTK_LINE), look.of_types(singular, VTK_VERTEX)
        actors = []
        if lines.GetNumberOfCells():
            actors += look.actors_of(lines, None, 1.3 * self.size)
            actors[-1].GetProperty().SetColor(*look.RULES[1][1])
        if dots.GetNumberOfCells():
            actors.append(look.balls(look.used_points(dots), 0.016 * self.size, look.RULES[0][1]))
        return actors

    def draw(self, words, actors, notes=()):
        self.pictures.append((actors, [look.caption(words), *notes]))

    def add(self, words, grid, rules=True, colouring=None, edges=False):
        """With dots where the rules 0, 1 and 4 (red, green, violet) are at work."""
        self.frame = np.concatenate([self.frame, look.used_points(grid)])
        actors = self.actors(grid, colouring, edges)
        self.draw(words, actors + (look.rule_balls(grid, self.size) if rules else []))

    def add_cut(self, words, grid, normal, colouring=None, notes=(), edges=False):
        """Cut open, with the colours of the parts unless others are given."""
        self.frame = np.concatenate([self.frame, look.used_points(grid)])
        plane = look.middle_plane(look.used_points(self.control), normal)
        colouring = colouring or look.part_array(self.control)
        self.draw(words, look.cut_actors(grid, plane, colouring, self.size, edges=edges), notes)

    def write(self):
        columns = 2 if len(self.pictures) == 4 else 3
        room = look.ROOM_FOR_NOTES if any(len(notes) > 1 for _, notes in self.pictures) else look.ROOM
        images = [look.render(actors, notes, self.frame, self.direction, room) for actors, notes in self.pictures]
        picture_files.write_figure(images, f"gallery_{self.name}", columns)


# ---------------------------------------------------------------- joints (figures 14 and 15)

def type_1():
    """A solid, a sheet on it and a curve through the tip of the sheet."""
    mesh = Mesh()
    mesh.block((0, 0, 0), (2, 2, 1))
    mesh.sheet(lambda u, v: (u, 1, 1 + v), 2, 2, part=2)
    mesh.curve((-0.7, 1, 1.6), (-0.5, 1, 2.8), (1, 1, 3), (1.6, 1, 4), (2.7, 1, 3.6), part=3)
    grid = mesh.grid()
    figure = Figure("type1", "Where dimensions meet", grid, (0.55, -1.0, 0.45))
    for rule in ("Blend", "Sharp", "Follow Dimension 1", "Follow Dimension 2", "Follow Dimension 3"):
        figure.add(f"WhereDimensionsMeet:\n{rule}", subdivide(grid, WhereDimensionsMeet=rule))
    return figure


def type_2():
    """Three sheets at one edge, of which two are one part; two curves that cross."""
    mesh = Mesh()
    for part, angle in ((0, 200), (0, 340), (1, 90)):
        towards = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        mesh.sheet(lambda u, v, d=towards: (u * d[0], v - 1.5, u * d[1]), 2, 3, part=part)
    for part, shift in ((2, -1), (3, 1)):
        mesh.curve(*((4 + shift * x, 0, z) for x, z in ((-1.4, 1.6), (-1, 0.6), (0, 0), (1, 0.6), (1.4, -1.2))),
                   part=part)
    grid = mesh.grid()
    figure = Figure("type2", "Where branches meet", grid, (0.25, -1.0, 0.4))
    for rule in ("Blend", "Sharp", "Follow Part"):
        options = {"PartArray": ["CELLS", "MaterialId"]} if rule == "Follow Part" else {}
        figure.add(f"WhereBranchesMeet:\n{rule}", subdivide(grid, WhereBranchesMeet=rule, **options))
    return figure


def type_3():
    """Two sheets that touch in a point; two solids that touch in an edge."""
    mesh = Mesh()
    for part, sign in ((0, -1), (1, 1)):
        mesh.sheet(lambda u, v, s=sign: (s * (u + v) * 0.6, (u - v) * 0.6, 0.4 + 0.2 * (u + v) ** 1.5),
                   2, 2, part=part)
    mesh.block((3, -0.5, 0), (1, 1, 1), part=lambda i, j, k: 2)
    mesh.block((4, -0.5, 1), (1, 1, 1), part=lambda i, j, k: 3)
    grid = mesh.grid()
    figure = Figure("type3", "Where boundaries touch", grid, (0.2, -1.0, 0.55))
    for rule in ("Blend", "Sharp"):
        figure.add(f"WhereBoundariesTouch:\n{rule}", subdivide(grid, WhereBoundariesTouch=rule))
    return figure


# ---------------------------------------------------------------- singularities (figure 16)

def ball():
    """A block that becomes a ball."""
    mesh = Mesh()
    mesh.block((-1, -1, -1), (2, 2, 2))
    return mesh


def cusp():
    mesh = ball()
    top = mesh.point((0, 0, 1))
    mesh.cell((0, 0, 1), singular=1)
    mesh.points[top] = (0, 0, 2)
    figure = Figure("cusp", "A singular vertex", mesh.grid(), (0.6, -1.0, 0.35))
    figure.add("without the flag", subdivide(mesh.grid(flagged=False)))
    figure.add("a cusp", subdivide(mesh.grid()))
    return figure


def corner():
    mesh = ball()
    start = np.array((1, -1, 1))
    for axis in range(3):
        step = -start * (np.arange(3) == axis)
        mesh.curve(start, start + step, start + 2 * step, singular=1)
    mesh.cell(start, singular=1)
    figure = Figure("corner", "Singular vertex and lines", mesh.grid(), (0.7, -1.0, 0.6))
    figure.add("without the flags", subdivide(mesh.grid(flagged=False)))
    figure.add("CreaseEnd: Dart\n(corner and creases)", subdivide(mesh.grid(), CreaseEnd="Dart"))
    figure.add("CreaseEnd: Corner\n(the ends stay, too)", subdivide(mesh.grid()))
    return figure


def embedded():
    """A wavy surface through the middle of a solid."""
    mesh = Mesh()

    def bend(x):
        return (x[0], x[1], x[2] + (0.55 * (-1) ** round(x[0]) if x[2] == 1 else 0))

    mesh.block((0, 0, 0), (4, 3, 2), bend, part=lambda i, j, k: k)
    mesh.sheet(lambda u, v: bend((u, v, 1)), 4, 3, part=1)
    grid = mesh.grid()
    figure = Figure("embedded", "A surface in a solid", grid, (0.4, -1.0, 0.55))
    for rule in ("Ignore", "Sharp Inside"):
        solids = look.of_types(subdivide(grid, CellsInOtherCells=rule), *look.SOLIDS)
        figure.add(f"CellsInOtherCells: {rule}\n(what is below it)", only_cells(solids, "MaterialId", 0), rules=False)
    return figure


# ---------------------------------------------------------------- models (figure 20)

def model(name):
    source = simple.SubdivisionModel(Model=name)
    source.UpdatePipeline()
    return source.GetClientSideObject().GetOutputDataObject(0)


def mechanical_part():
    grid = model("MechanicalPart")
    figure = Figure("mechanical_part", "Mechanical part", grid, (-0.45, -1.0, 0.75))
    figure.add("without the flags:\nround everywhere", subdivide(only_cells(grid, "Singular", 0), 3), rules=False)
    smooth = subdivide(grid, 3)
    figure.draw("with the flags: a circle,\nflat faces, corners", figure.actors(smooth) + figure.flags(smooth))
    name, low, high = look.shown_array(smooth)
    tension = look.tension_colours(low, high)
    figure.add_cut("cut open", smooth, (0.0, -1.0, 0.0), ("point", name, tension), look.colour_bar(tension, name))
    return figure


def material_block():
    grid = model("MaterialBlock")
    figure = Figure("materials", "Two materials", grid, (0.7, -1.0, 0.6))
    for words, options in (("blended", {}), ("PreserveInterfaces", {"PreserveInterfaces": 1})):
        smooth = subdivide(grid, **options)
        figure.add_cut(f"{words},\ncut open", smooth, (0.0, -1.0, 0.0))
        figure.add(f"{words}:\nthe lower material", only_cells(smooth, "MaterialId", 0), rules=False)
    return figure


def draw():
    for make in (type_1, type_2, type_3, cusp, corner, embedded, mechanical_part, material_block):
        make().write()
    print(f"The features are in gallery_*.png in {os.getcwd()}.")


if __name__ == "__main__":
    import demo

    demo.load_plugin()
    draw()
