# SPDX-License-Identifier: BSD-3-Clause
"""How smooth schemes are, and how near: what fails, characteristic maps, basis functions, normals next to borders, and
bounds. guide_pictures.py makes them."""

import demo_pictures as look
import numpy as np
from deformation import quads, source_of, to_points
from gallery import only_cells
from paraview import simple
from side_by_side import BLUE, VIEW, output, points_of, write
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkPolyData, vtkUnstructuredGrid

def spindle(count):
    """Tetrahedra around a long edge."""
    turns = 2 * np.pi * np.arange(count) / count
    ring = np.stack([np.cos(turns), np.sin(turns), 0 * turns], axis=1)
    grid = vtkUnstructuredGrid()
    grid.SetPoints(to_points(np.concatenate([[[0, 0, -2], [0, 0, 2]], ring])))
    for i in range(count):
        grid.InsertNextCell(VTK_TETRA, 4, (0, 1, 2 + i, 2 + (i + 1) % count))
    return grid


def smoothness():
    grid = spindle(9)
    colours = look.category_colours([("holds", BLUE), ("fails", (0.85, 0.25, 0.15))])
    shown = []
    for scheme in ("Box Spline", "Tet/Oct"):
        found = output(simple.SubdivisionSmoothness(Input=source_of(grid), Scheme=scheme))
        edges = only_cells(found, "SimplexDimension", 1)
        actors = look.actors_of(edges, ("cell", "Failing", colours), 4.0)
        shown.append((f"Scheme: {scheme}", actors, look.used_points(grid)))
    write("smoothness", shown, VIEW, 2)


def fan(count):
    """Triangles around a point."""
    turns = 2 * np.pi * np.arange(count) / count
    ring = np.stack([np.cos(turns), np.sin(turns), 0 * turns], axis=1)
    data = vtkPolyData()
    data.SetPoints(to_points(np.concatenate([[[0, 0, 0]], ring])))
    data.SetPolys(vtkCellArray())
    for i in range(count):
        data.GetPolys().InsertNextCell(3, (0, 1 + i, 1 + (i + 1) % count))
    return data


def characteristic_map(grid, cell, **options):
    return output(simple.SubdivisionSmoothness(Input=source_of(grid), MapOfCell=cell, **options))


def maps_of_surfaces():
    """Kobbelt's figure 17: the first cell is the vertex in the middle."""
    shown = []
    for count in range(3, 10):
        found = characteristic_map(fan(count), 0, Scheme="Sqrt Three")
        colours = look.tension_colours(0.0, 2.0)
        points = points_of(found)
        size = np.abs(points).max()
        shown.append((f"{count} triangles", look.actors_of(found, ("cell", "Jacobian", colours), 1.0, edges=True),
                      points / size))
        for actor in shown[-1][1]:
            actor.SetScale(1 / size)
    write("maps_of_surfaces", shown, (0.0, -0.02, 1.0), 4)


def maps_of_faces():
    """The vertex in the middle becomes a face, which is what repeats."""
    shown = []
    for scheme in ("Doo-Sabin", "Midedge"):
        for count in (4, 5, 8):
            found = characteristic_map(fan(count), 0, Scheme=scheme)
            actors = look.actors_of(found, ("cell", "Jacobian", look.tension_colours(0.0, 2.0)), 1.0, edges=True)
            points = points_of(found)
            size = np.abs(points).max()
            for actor in actors:
                actor.SetScale(1 / size)
            shown.append((f"{scheme}, {count} corners", actors, points / size))
    write("maps_of_faces", shown, (0.0, -0.02, 1.0), 3)


def ball(neighbours):
    """Tetrahedra around a point that has so many neighbours: two poles and one ring of others, or two (12)."""
    rings = 2 if neighbours == 12 else 1
    count = (neighbours - 2) // rings
    turns = 2 * np.pi * np.arange(count) / count
    points = [[0, 0, 0], [0, 0, 1.5], [0, 0, -1.5]]
    for ring in range(rings):
        height = 0.5 - ring if rings == 2 else 0.0
        points += [[np.cos(t + ring * np.pi / count), np.sin(t + ring * np.pi / count), height] for t in turns]
    grid = vtkUnstructuredGrid()
    grid.SetPoints(to_points(np.array(points)))
    last = 3 + (rings - 1) * count
    for i in range(count):
        following = (i + 1) % count
        sides = [(1, 3 + i, 3 + following), (2, last + i, last + following)]
        if rings == 2:
            sides += [(3 + i, 3 + following, last + i), (last + i, last + following, 3 + following)]
        for side in sides:
            grid.InsertNextCell(VTK_TETRA, 4, (0,) + side)
    return grid


def maps_of_solids():
    """Schaefer's figures 11 and 12, and a map that folds."""
    shown = []

    def add(words, grid, cell, scheme):
        found = characteristic_map(grid, cell, Scheme=scheme)
        jacobians = vtk_to_numpy(found.GetCellData().GetArray("Jacobian"))
        most = np.abs(jacobians).max()
        points = points_of(found)
        size = np.abs(points).max()
        actors = look.actors_of(found, ("cell", "Jacobian", look.tension_colours(-most, most)), 1.0, edges=True)
        for actor in actors:
            actor.SetScale(1 / size)
        shown.append((words, actors, points / size))

    for count in (5, 6, 7, 8, 9, 12):
        add(f"Tet/Oct, a vertex of {count}", ball(count), 0, "Tet/Oct")
    for count in range(3, 11):
        edges = output(simple.SubdivisionSmoothness(Input=source_of(spindle(count)), Scheme="Tet/Oct"))
        inside = (vtk_to_numpy(edges.GetCellData().GetArray("SimplexDimension")) == 1) & (
            vtk_to_numpy(edges.GetCellData().GetArray("RuleDimension")) == 3)
        add(f"Tet/Oct, an edge of {count}", spindle(count), int(np.flatnonzero(inside)[0]), "Tet/Oct")
    add("Box Spline, a vertex of 6:\nblue cells fold", ball(6), 0, "Box Spline")
    write("maps_of_solids", shown, VIEW, 4)


def with_impulse(data, point):
    """The mesh with the array of which subdivision makes the basis function of a point."""
    values = np.zeros(data.GetNumberOfPoints())
    values[point] = 1.0
    array = numpy_to_vtk(values, deep=True)
    array.SetName("BasisFunction")
    made = data.NewInstance()
    made.ShallowCopy(data)
    made.GetPointData().AddArray(array)
    return source_of(made)


def basis_functions():
    """As heights over a net of quads."""
    steps = np.arange(7.0)
    net = quads(np.stack(np.meshgrid(steps, steps, [0.0], indexing="ij"), axis=-1)[:, :, 0])
    shown = []
    for scheme in ("Catmull-Clark", "Loop", "Modified Butterfly", "Sqrt Three", "Four-Eight", "Doo-Sabin"):
        levels = 8 if scheme == "Four-Eight" else 6 if scheme == "Sqrt Three" else 4
        found = output(simple.SurfaceSubdivision(Input=with_impulse(net, 24), Scheme=scheme, NumberOfLevels=levels,
                                                 ProjectToLimit=1))
        heights = vtk_to_numpy(found.GetPointData().GetArray("BasisFunction"))
        points = points_of(found)
        points[:, 2] = 3.0 * heights
        found.SetPoints(to_points(points))
        shown.append((scheme, look.actors_of(found, ("point", "BasisFunction", look.tension_colours(-1.0, 1.0)), 1.0),
                      points))
    write("basis_functions", shown, VIEW, 3)


def basis_functions_of_solids():
    """Of points of the flower, cut open, whose solid head, surfaces and curve are one object: each function reaches into all
    of them that meet at its point."""
    model = output(simple.SubdivisionModel(Model="MixedDimensions"))
    shown = []
    for words, point in (("of the solid", 7), ("of solid and surfaces", 8), ("of solid and curve", 0),
                         ("of surfaces and curve", 72)):
        found = output(simple.MultidimensionalSubdivision(Input=with_impulse(model, point), NumberOfLevels=4,
                                                          ProjectToLimit=1))
        largest = vtk_to_numpy(found.GetPointData().GetArray("BasisFunction")).max()
        points = look.used_points(found)
        size = np.linalg.norm(points.max(axis=0) - points.min(axis=0))
        colours = ("point", "BasisFunction", look.tension_colours(-0.4 * largest, largest))
        actors = look.cut_actors(found, look.middle_plane(points, (0.0, -1.0, 0.0)), colours, size)
        shown.append((f"A point {words}\nblue: 0, red: {largest:.2f}", actors, points[points[:, 2] > -3.0]))
    write("basis_functions_of_solids", shown, VIEW, 2)


def border_fan(count):
    """Triangles on one side of a point of a border, once more around, not flat."""
    turns = np.pi * np.arange(count + 1) / count
    rings = [[0, 0, 0.8]]
    for radius, lift in ((1.0, 0.0), (2.0, 0.3)):
        rings += [[radius * np.cos(t), -radius * np.sin(t), lift * np.cos(2 * t)] for t in turns]
    data = vtkPolyData()
    data.SetPoints(to_points(np.array(rings)))
    data.SetPolys(vtkCellArray())
    inner, outer = 1, 2 + count
    for i in range(count):
        data.GetPolys().InsertNextCell(3, (0, inner + i + 1, inner + i))
        data.GetPolys().InsertNextCell(3, (inner + i, inner + i + 1, outer + i))
        data.GetPolys().InsertNextCell(3, (inner + i + 1, outer + i + 1, outer + i))
    return data


def normals_at(data, points, length):
    """Lines along the limit normals at some points."""
    where = points_of(data)[points]
    normals = vtk_to_numpy(data.GetPointData().GetArray("LimitNormals"))[points]
    lines = vtkPolyData()
    lines.SetPoints(to_points(np.concatenate([where, where + length * normals])))
    lines.SetLines(vtkCellArray())
    for i in range(len(points)):
        lines.GetLines().InsertNextCell(2, (i, len(points) + i))
    return lines


def modified_boundary():
    """A point of a border in many triangles: by the plain rules there is a crease in the middle."""
    net = border_fan(9)
    shown = []
    for words, modified in (("SmoothUpToBorders: Off", 0), ("SmoothUpToBorders: On", 1)):
        found = output(simple.MultidimensionalSubdivision(
            Input=source_of(net), NumberOfLevels=5, ProjectToLimit=1, GenerateLimitNormals=1,
            SmoothUpToBorders=modified))
        points = points_of(found)
        near = np.flatnonzero(np.linalg.norm(points - points[0], axis=1) < 0.3)
        bristles = normals_at(found, near[::3], 0.25)
        actors = look.actors_of(found, None, 1.0) + [look.tubes(bristles, 0.004, None)]
        for actor, colour in zip(actors, (BLUE, (0.85, 0.25, 0.15))):
            actor.GetProperty().SetColor(*colour)
        actors[-1].GetProperty().SetAmbient(0.8)
        shown.append((words, actors, points[np.linalg.norm(points - points[0], axis=1) < 0.8]))
    write("modified_boundary", shown, (0.3, -1.0, 0.9), 2)


def error_bounds():
    """Each cell in the colour of its bound."""
    model = simple.SubdivisionModel(Model="Character")
    shown = []
    for levels in (0, 1, 2):
        found = output(simple.MultidimensionalSubdivision(Input=model, NumberOfLevels=levels, GenerateErrorBounds=1))
        bounds = vtk_to_numpy(found.GetCellData().GetArray("ErrorBound"))
        colours = look.tension_colours(0.0, bounds.max())
        actors = look.actors_of(found, ("cell", "ErrorBound", colours), 1.0, edges=True)
        shown.append((f"NumberOfLevels: {levels}\nred: {bounds.max():.2g}", actors, points_of(found)))
    write("error_bounds", shown, VIEW, 3)
