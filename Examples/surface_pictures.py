# SPDX-License-Identifier: BSD-3-Clause
"""What properties do to a surface, side by side: pictures of the guide, which guide_pictures.py makes."""

import math

import demo_pictures as look
import gallery_surfaces
import numpy as np
from deformation import source_of
from gallery import Mesh, model, subdivide
from paraview import simple
from side_by_side import BLUE, add_array, output, points_of, write
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter


def surface(data, **options):
    made = simple.SurfaceSubdivision(Input=source_of(data), **{"NumberOfLevels": 5, **options})
    return look.surface_of(output(made))


def surface_picture(words, data, edges=False):
    actor = look.polygons(data, None, edges, False)
    actor.GetProperty().SetColor(*BLUE)
    return words, [actor], points_of(data)


def crease_on_a_cube(sharpness):
    control = gallery_surfaces.mesh(*gallery_surfaces.CUBE)
    rim = [4, 5, 7, 6, 4]
    lines = vtkCellArray()
    for ends in zip(rim, rim[1:]):
        lines.InsertNextCell(2, ends)
    control.SetLines(lines)
    add_array(control.GetCellData(), "Sharpness", [sharpness] * 4 + [0.0] * 6)
    return control


def surface_options():
    cube = gallery_surfaces.mesh(*gallery_surfaces.CUBE)
    shown = [surface_picture("Catmull-Clark", surface(cube, Scheme="Catmull-Clark")),
             surface_picture("InterpolatePoints", surface(cube, Scheme="Catmull-Clark", InterpolatePoints=1)),
             surface_picture("ProjectToLimit,\n2 levels", surface(
                 cube, Scheme="Catmull-Clark", NumberOfLevels=2, ProjectToLimit=1), True)]
    for value in (1.0, 2.0, math.inf):
        shown.append(surface_picture(f"Sharpness {value:g}\nof the upper edges", surface(
            crease_on_a_cube(value), Scheme="Catmull-Clark", SharpnessArray=["CELLS", "Sharpness"])))
    write("surface_options", shown, (0.45, -1.0, 0.35))


def curved_edges(grid):
    """The edges of curved cells, as lines of many pieces."""
    pieces = 16
    points, lines, drawn = vtkPoints(), vtkCellArray(), set()
    for cell in range(grid.GetNumberOfCells()):
        for number in range(grid.GetCell(cell).GetNumberOfEdges()):
            edge = grid.GetCell(cell).GetEdge(number)
            ends = frozenset((edge.GetPointId(0), edge.GetPointId(1)))
            if ends in drawn:
                continue
            drawn.add(ends)
            weights = [0.0] * edge.GetNumberOfPoints()
            lines.InsertNextCell(pieces + 1)
            for i in range(pieces + 1):
                at = [0.0, 0.0, 0.0]
                edge.EvaluateLocation(reference(0), [i / pieces, 0.0, 0.0], at, weights)
                lines.InsertCellPoint(points.InsertNextPoint(at))
    made = vtkPolyData()
    made.SetPoints(points)
    made.SetLines(lines)
    return made


def bezier_cells():
    """Catmull-Clark as Bezier cells: Tessellate shows them as they are."""
    cube = source_of(gallery_surfaces.mesh(*gallery_surfaces.CUBE))
    shown = [surface_picture("linear cells,\n1 level, on the limit", surface(
        gallery_surfaces.mesh(*gallery_surfaces.CUBE), Scheme="Catmull-Clark", NumberOfLevels=1, ProjectToLimit=1), True)]
    for levels_most, tolerance in ((0, 1e-4), (4, 1e-4)):
        cells = simple.SurfaceSubdivision(Input=cube, Scheme="Catmull-Clark", OutputCells="Bezier",
                                          NumberOfLevels=levels_most, BezierTolerance=tolerance)
        made = output(cells)
        fine = look.surface_of(output(simple.Tessellate(Input=cells, ChordError=1e-4, MaximumNumberofSubdivisions=5)))
        words, actors, points = surface_picture(f"{made.GetNumberOfCells()} Bezier cells:\nat most {levels_most} levels",
                                                normals_of(fine))
        edges = look.tubes(curved_edges(made), 0.004, None)
        edges.GetProperty().SetColor(0.2, 0.22, 0.26)
        shown.append((words, [*actors, edges], points))
    write("bezier_cells", shown, (0.45, -1.0, 0.35))


def curved_cells():
    """Flat cells beside curved ones, with their edges."""
    part = model("MechanicalPart")
    shown = []
    for words, options in (("Linear", {"ProjectToLimit": 1}), ("Quadratic", {"OutputCells": "Quadratic"})):
        made = subdivide(part, 0, OutputDimensions="Tetrahedra", **options)
        outside = vtkDataSetSurfaceFilter()
        outside.SetInputData(made)
        outside.SetNonlinearSubdivisionLevel(4)
        outside.Update()
        picture, actors, points = surface_picture(f"{words}:\n{made.GetNumberOfCells()} cells",
                                                  outside.GetOutput() if words == "Linear" else normals_of(outside.GetOutput()))
        edges = look.tubes(curved_edges(made), 0.005, None)
        edges.GetProperty().SetColor(0.2, 0.22, 0.26)
        shown.append((picture, [*actors, edges], points))
    write("curved_cells", shown, (0.45, -1.0, 0.55), 2)


def normals_of(data):
    """For round shading: Tessellate gives none."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def seams():
    """A box has points of its own for each face, and texture coordinates."""
    box = output(simple.Box())
    shown = [surface_picture("a box with\ntexture coordinates", box, True)]
    for join in (1, 0):
        shown.append(surface_picture(f"JoinSeams {join}", surface(box, Scheme="Catmull-Clark", JoinSeams=join)))
    write("surface_seams", shown, (0.45, -1.0, 0.35))


def concave_sheet():
    """A bent sheet with a concave corner."""
    mesh = Mesh()
    for u, v in ((0, 0), (1, 0), (0, 1)):
        corners = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)]
        mesh.cell(*((x, y, 0.5 * (x - y) ** 2) for x, y in corners))
    mesh.cell((1, 1, 0), singular=1)
    return look.surface_of(mesh.grid())


def corners():
    """What arrays of points say of the concave corner."""
    shown = []
    for words, arrays in (("default", {}), ("Angle 90", {"CornerAngles": 90.0}), ("Flatness 0.5", {"CornerFlatness": 0.5}),
                          ("Flatness 1", {"CornerFlatness": 1.0})):
        control = concave_sheet()
        options = {}
        for name, value in arrays.items():
            add_array(control.GetPointData(), name, np.full(control.GetNumberOfPoints(), value))
            options[name] = ["POINTS", name]
        shown.append(surface_picture(words, surface(control, Scheme="Catmull-Clark", **options)))
    write("surface_corners", shown, (0.3, -1.0, 1.2), 4)


def boundary():
    control = concave_sheet()
    shown = [surface_picture("control mesh with\na concave corner", control, True)]
    for value in (1, 0):
        shown.append(surface_picture(f"SmoothUpToBorders {value}", surface(
            control, Scheme="Catmull-Clark", SmoothUpToBorders=value)))
    write("surface_boundary", shown, (0.3, -1.0, 1.2))
