# SPDX-License-Identifier: BSD-3-Clause
"""The pictures that demo.py makes, with plain VTK rendering: nothing here is about subdivision."""

import json
import math
import pathlib

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401  registers what rendering needs
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_LINE, VTK_PYRAMID, VTK_TETRA, VTK_TRIANGLE, VTK_VERTEX, VTK_WEDGE, vtkCellArray,
    vtkPlane, vtkPolyData)
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkImageAppend, vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersExtraction import vtkExtractCellsByType, vtkExtractGeometry
from vtkmodules.vtkFiltersGeneral import vtkTableBasedClipDataSet
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkActor2D, vtkColorTransferFunction, vtkGlyph3DMapper, vtkLightKit, vtkPolyDataMapper,
    vtkPolyDataMapper2D, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

SIZE = (800, 600)  # of a picture; rendered twice as large and shrunk, for smooth edges
SOLIDS = (VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID)  # a cut makes the last three
INK = (0.15, 0.17, 0.2)
PALETTE = [(0.93, 0.76, 0.55), (0.55, 0.73, 0.60), (0.56, 0.70, 0.85), (0.86, 0.60, 0.56),
           (0.45, 0.47, 0.52), (0.75, 0.66, 0.84), (0.90, 0.85, 0.58), (0.60, 0.80, 0.80)]
PRESET = pathlib.Path(__file__).resolve().parent.parent / "Plugin" / "RuleDimensionColors.json"


def read_preset():
    """(label, colour) of the rules 0 to 4: the colour preset that comes with the plugin."""
    preset = json.loads(PRESET.read_text())[0]
    words, numbers = preset["Annotations"], preset["IndexedColors"]
    return [(f"{words[2 * i]}: {words[2 * i + 1]}", tuple(numbers[3 * i:3 * i + 3]))
            for i in range(len(numbers) // 3)]


RULES = read_preset()


def cell_types(grid):
    # The first name is gone from the newest VTK, where the second gives the array.
    get = getattr(grid, "GetCellTypesArray", None) or grid.GetCellTypes
    return vtk_to_numpy(get())


def count_by_dimension(grid):
    """The numbers of vertices, lines, triangles and tetrahedra."""
    counts = np.bincount(cell_types(grid), minlength=256)
    return [int(counts[kind]) for kind in (VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA)]


# ---------------------------------------------------------------- colours

def tension_colours(low, high):
    """From deep blue over white-ish sand to dark red, even in lightness."""
    colours = vtkColorTransferFunction()
    colours.SetColorSpaceToLab()
    stops = [(0.0, 0.14, 0.22, 0.52), (0.25, 0.27, 0.57, 0.78), (0.5, 0.96, 0.94, 0.86),
             (0.75, 0.93, 0.60, 0.33), (1.0, 0.60, 0.09, 0.13)]
    for at, red, green, blue in stops:
        colours.AddRGBPoint(low + at * (high - low), red, green, blue)
    colours.Build()
    return colours


def category_colours(entries):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(entries))
    table.SetTableRange(0, len(entries) - 1)
    table.IndexedLookupOn()
    for i, (label, colour) in enumerate(entries):
        table.SetTableValue(i, *colour, 1.0)
        table.SetAnnotation(i, label)
    return table


def part_colours(values):
    """A colour for every different value of a cell array."""
    table = vtkLookupTable()
    table.IndexedLookupOn()
    different = np.unique(values)
    table.SetNumberOfTableValues(len(different))
    for i, value in enumerate(different):
        table.SetTableValue(i, *PALETTE[i % len(PALETTE)], 1.0)
        table.SetAnnotation(float(value), "")
    return table


# ---------------------------------------------------------------- actors

def surface_of(grid):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput()


def only(data, verts=False, lines=False, polys=False):
    """A part of poly data by the dimension of its cells, with the cell arrays that belong to it."""
    counts = [data.GetNumberOfVerts(), data.GetNumberOfLines(), data.GetNumberOfPolys()]
    starts = np.concatenate([[0], np.cumsum(counts)])
    dimension = 0 if verts else 1 if lines else 2
    part = vtkPolyData()
    part.SetPoints(data.GetPoints())
    part.GetPointData().ShallowCopy(data.GetPointData())
    cells = (data.GetVerts, data.GetLines, data.GetPolys)[dimension]()
    (part.SetVerts, part.SetLines, part.SetPolys)[dimension](cells)
    for i in range(data.GetCellData().GetNumberOfArrays()):
        array = data.GetCellData().GetArray(i)
        if array:
            values = numpy_to_vtk(
                vtk_to_numpy(array)[starts[dimension]:starts[dimension + 1]], deep=True)
            values.SetName(array.GetName())
            part.GetCellData().AddArray(values)
    return part


def mapper_for(colouring):
    mapper = vtkPolyDataMapper()
    if colouring is None:
        mapper.ScalarVisibilityOff()
        return mapper
    kind, name, colours = colouring
    (mapper.SetScalarModeToUsePointFieldData if kind == "point" else mapper.SetScalarModeToUseCellFieldData)()
    mapper.SelectColorArray(name)
    mapper.SetColorModeToMapScalars()  # unsigned chars are no colours here
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    if isinstance(colours, vtkColorTransferFunction):
        mapper.InterpolateScalarsBeforeMappingOn()
    return mapper


def polygons(data, colouring, edges, on_top):
    """An actor for the polygons; on top: of others in the same place."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(only(data, polys=True))
    normals.SetFeatureAngle(5 if edges else 50)
    mapper = mapper_for(colouring)
    mapper.SetInputConnection(normals.GetOutputPort())
    if on_top:
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-1.0, -1.0)
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetAmbient(0.22)
    look.SetSpecular(0.12)
    look.SetSpecularPower(25)
    if edges:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(*INK)
        look.SetLineWidth(2.0)
    return actor


def of_types(grid, *types):
    chosen = vtkExtractCellsByType()
    chosen.SetInputData(grid)
    for kind in types:
        chosen.AddCellType(kind)
    chosen.Update()
    return chosen.GetOutput()


def actors_of(grid, colouring, size, edges=False):
    """The surface of a grid (colouring: kind, array, colours), curves as tubes, points as balls."""
    actors = []
    # Triangles may lie on the boundary of solids.
    solids = surface_of(of_types(grid, *SOLIDS))
    data = surface_of(of_types(grid, *(set(range(1, VTK_PYRAMID + 1)) - set(SOLIDS))))
    for part, on_top in ((solids, False), (data, True)):
        if part.GetNumberOfPolys():
            actors.append(polygons(part, colouring, edges, on_top))
    if data.GetNumberOfLines():
        tubes = vtkTubeFilter()
        tubes.SetInputData(only(data, lines=True))
        tubes.SetRadius(0.006 * size)
        tubes.SetNumberOfSides(12)
        tubes.CappingOn()
        mapper = mapper_for(colouring)
        mapper.SetInputConnection(tubes.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actors.append(actor)
    if data.GetNumberOfVerts():
        ids = vtk_to_numpy(data.GetVerts().GetConnectivityArray())
        actors.append(balls(points_of(data)[ids], 0.008 * size, INK))
    return actors


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def balls(where, radius, colour):
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(12)
    ball.SetPhiResolution(9)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(where), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(data)
    mapper.SetSourceConnection(ball.GetOutputPort())
    mapper.ScalingOff()
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    return actor


def rule_balls(grid, size):
    """The points of the singular, curve and blending rules, which colours on triangles hardly show."""
    data = surface_of(grid)
    rules = vtk_to_numpy(data.GetPointData().GetArray("RuleDimension"))
    actors = []
    for rule, radius in ((0, 0.012), (1, 0.005), (4, 0.006)):
        where = points_of(data)[rules == rule]
        if 0 < len(where) < 200_000:
            actors.append(balls(where, radius * size, RULES[rule][1]))
    return actors


# ---------------------------------------------------------------- pictures

def text(words, size, x, y):
    actor = vtkTextActor()
    actor.SetInput(words)
    actor.GetTextProperty().SetColor(*INK)
    actor.GetTextProperty().SetFontSize(size)
    actor.SetPosition(x, y)
    return actor


def colour_bar(colours, title):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle(title)
    bar.SetUnconstrainedFontSize(True)
    for look in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty(), bar.GetAnnotationTextProperty()):
        look.SetColor(*INK)
        look.SetFontSize(30)
        look.ItalicOff()
        look.BoldOff()
        look.ShadowOff()
    bar.SetLabelFormat("%.3g")
    bar.SetNumberOfLabels(5)
    bar.SetVerticalTitleSeparation(16)
    bar.SetPosition(0.84, 0.12)
    bar.SetWidth(0.13)
    bar.SetHeight(0.5)
    bar.SetBarRatio(0.25)
    return bar


def square(colour, side, x, y):
    points = vtkPoints()
    for corner in ((0, 0), (side, 0), (side, side), (0, side)):
        points.InsertNextPoint(*corner, 0)
    cells = vtkCellArray()
    cells.InsertNextCell(4, range(4))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(data)
    actor = vtkActor2D()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.SetPosition(x, y)
    return actor


def rule_legend(present):
    """Names and colours of the rules, in the lower left corner."""
    actors = []
    for row, rule in enumerate(sorted(present, reverse=True)):
        label, colour = RULES[rule]
        actors += [square(colour, 28, 40, 40 + 46 * row), text(label, 32, 86, 40 + 46 * row)]
    return actors


def render(actors, annotations, points, direction):
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for actor in actors:
        renderer.AddActor(actor)
    for actor in annotations:
        renderer.AddActor2D(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(2 * SIZE[0], 2 * SIZE[1])
    window.AddRenderer(renderer)
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(0.85)
    lights.AddLightsToRenderer(renderer)
    aim_camera(renderer, points, direction)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    return resized(grab.GetOutputPort(), SIZE)


def aim_camera(renderer, points, direction):
    """Looks against `direction` at some points, so that they fill the picture."""
    forward = np.array(direction) / np.linalg.norm(direction)
    right = np.cross((0, 0, 1), forward)
    right /= np.linalg.norm(right)
    up = np.cross(forward, right)
    seen = points @ np.array([right, up, forward]).T
    low, high = seen.min(axis=0), seen.max(axis=0)
    width, height, depth = high - low
    aspect = SIZE[0] / SIZE[1]
    scale = max(height / 0.80, width / aspect / 0.76) / 2  # room for the title above, the bar beside
    middle = (low + high) / 2 + scale * np.array([0.10 * aspect, 0.07, 0])
    centre = middle @ np.array([right, up, forward])
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(scale)
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + forward * (2 * depth + scale)))
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange()


def shown_array(grid):
    """(name, range) of the point array to show; the height is added where there is none."""
    points = grid.GetPointData()
    names = [points.GetArrayName(i) for i in range(points.GetNumberOfArrays()) if points.GetArray(i)]
    names = [name for name in names if name not in ("RuleDimension", "NonManifoldType")
             and points.GetArray(name).GetNumberOfComponents() == 1]
    name = "Tension" if "Tension" in names else names[0] if names else "Height"
    if name == "Height" and "Height" not in names:
        height = numpy_to_vtk(np.ascontiguousarray(points_of(grid)[:, 2]), deep=True)
        height.SetName(name)
        points.AddArray(height)
    low, high = points.GetArray(name).GetFiniteRange()
    return name, low, high if high > low else low + 1


def part_array(grid):
    """Cell array by which the parts are coloured: a small number of integers, if there is one."""
    cells = grid.GetCellData()
    names = [cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays()) if cells.GetArray(i)]
    names.sort(key=lambda name: (name != "MaterialId", name in ("ManifoldDimension", "Singular")))
    for name in names:
        array = cells.GetArray(name)
        if array.GetNumberOfComponents() == 1 and len(np.unique(vtk_to_numpy(array))) <= 64:
            return "cell", name, part_colours(vtk_to_numpy(array))
    return None


def cut_open(grid, plane, whole_cells):
    """The half behind a plane: cut through, or as the whole cells there."""
    if whole_cells:
        cut = vtkExtractGeometry()
        cut.SetImplicitFunction(plane)
        cut.ExtractInsideOn()
        cut.ExtractBoundaryCellsOn()
    else:
        cut = vtkTableBasedClipDataSet()
        cut.SetClipFunction(plane)
        cut.InsideOutOn()
    cut.SetInputData(grid)
    cut.Update()
    return cut.GetOutput()


def pictures(name, control, smooth, levels, direction, normal):
    """(what it shows, image) of a control mesh and what became of it."""
    grid = smooth.NewInstance()
    grid.ShallowCopy(smooth)  # the array that is shown may have to be added
    points = used_points(control)
    low_corner, high_corner = points.min(axis=0), points.max(axis=0)
    size = math.dist(low_corner, high_corner)
    plane = vtkPlane()
    # A little off the middle, where models have their points.
    unit = np.array(normal) / np.linalg.norm(normal)
    plane.SetOrigin(*((low_corner + high_corner) / 2 + 0.004 * size * unit))
    plane.SetNormal(*normal)
    array, low, high = shown_array(grid)
    parts, tension = part_array(control), tension_colours(low, high)
    rules = category_colours(RULES)
    opened, crinkled = cut_open(grid, plane, False), cut_open(grid, plane, True)
    steps = f"{levels} level{'s' * (levels != 1)}"
    shown = [
        ("control", "control mesh", actors_of(control, parts, size, edges=True), []),
        ("smooth", steps, actors_of(grid, parts, size), []),
        ("inside", f"{steps}, cut open", actors_of(opened, ("point", array, tension), size),
         [colour_bar(tension, array)]),
        ("rules", "RuleDimension",
         actors_of(crinkled, ("point", "RuleDimension", rules), size) + rule_balls(crinkled, size),
         rule_legend(rules_in(crinkled)))]
    return [(what, render(actors, notes + [text(f"{name}: {title}", 52, 36, 2 * SIZE[1] - 84)],
                          points, direction))
            for what, title, actors, notes in shown]


def rules_in(grid):
    return [int(rule) for rule in np.unique(vtk_to_numpy(grid.GetPointData().GetArray("RuleDimension")))]


def used_points(grid):
    """The points that cells use; others may be anywhere."""
    return points_of(grid)[np.unique(vtk_to_numpy(grid.GetCells().GetConnectivityArray()))].astype(float)


# ---------------------------------------------------------------- images

def resized(port, size):
    shrink = vtkImageResize()
    shrink.SetInputConnection(port)
    shrink.SetOutputDimensions(*size, 1)
    shrink.Update()
    return shrink.GetOutput()


def shrunk(image, factor):
    width, height, _ = image.GetDimensions()
    producer = vtkTrivialProducer()
    producer.SetOutput(image)
    return resized(producer.GetOutputPort(), (round(factor * width), round(factor * height)))


def append(images, axis):
    joined = vtkImageAppend()
    joined.SetAppendAxis(axis)
    for image in images:
        joined.AddInputData(image)
    joined.Update()
    return joined.GetOutput()


def contact_sheet(rows):
    return append([append(row, 0) for row in reversed(rows)], 1)  # images count from the bottom


def write_png(image, file_name):
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(file_name)
    writer.SetCompressionLevel(9)
    writer.Write()
