# SPDX-License-Identifier: BSD-3-Clause
"""The pictures that demo.py makes, with plain VTK rendering: nothing here is about subdivision."""

import json
import math
import pathlib

import numpy as np
import picture_files
import vtkmodules.vtkInteractionStyle  # noqa: F401  registers what rendering needs
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_LINE, VTK_PYRAMID, VTK_QUAD, VTK_TETRA, VTK_TRIANGLE, VTK_VERTEX, VTK_WEDGE, vtkCellArray,
    vtkPlane, vtkPolyData)
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData, vtkCutter, vtkFeatureEdges, vtkPolyDataNormals, vtkTubeFilter)
from vtkmodules.vtkFiltersExtraction import vtkExtractCellsByType
from vtkmodules.vtkFiltersGeneral import vtkTableBasedClipDataSet
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkActor2D, vtkColorTransferFunction, vtkGlyph3DMapper, vtkLightKit, vtkPolyDataMapper,
    vtkPolyDataMapper2D, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

SIZE = (1600, 1200)  # of a picture, in pixels
CAPTION = 76  # the height of its letters
SOLIDS = (VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID)
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
    """The numbers of vertices, lines, faces and solids."""
    counts = np.bincount(cell_types(grid), minlength=256)
    return [int(counts[list(kinds)].sum()) for kinds in ((VTK_VERTEX,), (VTK_LINE,), (VTK_TRIANGLE, VTK_QUAD), SOLIDS)]


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
    return actors + curves_and_points(data, colouring, size)


def tubes(lines, radius, colouring):
    tube = vtkTubeFilter()
    tube.SetInputData(lines)
    tube.SetRadius(radius)
    tube.SetNumberOfSides(12)
    tube.CappingOn()
    mapper = mapper_for(colouring)
    mapper.SetInputConnection(tube.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def curves_and_points(data, colouring, size):
    actors = []
    if data.GetNumberOfLines():
        actors.append(tubes(only(data, lines=True), 0.006 * size, colouring))
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


def rule_balls(grid, size, plane=None):
    """The points of the singular, curve and blending rules, which colours on triangles hardly show: all, or those
    behind a plane and on curves."""
    data = surface_of(grid)
    rules = vtk_to_numpy(data.GetPointData().GetArray("RuleDimension"))
    shown = np.ones(len(rules), bool)
    if plane:
        shown = (points_of(data) - plane.GetOrigin()) @ np.array(plane.GetNormal()) <= 0
        shown[vtk_to_numpy(lines_of(data, False).GetLines().GetConnectivityArray())] = True
    actors = []
    for rule, radius in ((0, 0.012), (1, 0.005), (4, 0.006)):
        where = points_of(data)[(rules == rule) & shown]
        if 0 < len(where) < 200_000:
            actors.append(balls(where, radius * size, RULES[rule][1]))
    return actors


# ---------------------------------------------------------------- notes

def text(words, size, x, y):
    actor = vtkTextActor()
    actor.SetInput(words)
    actor.GetTextProperty().SetColor(*INK)
    actor.GetTextProperty().SetFontSize(size)
    actor.SetPosition(x, y)
    return actor


def caption(words):
    """In the upper left corner, in one or two lines, on white where a detail fills the picture."""
    actor = text(words, CAPTION, 36, SIZE[1] - 24)
    actor.GetTextProperty().SetVerticalJustificationToTop()
    actor.GetTextProperty().SetBackgroundColor(1.0, 1.0, 1.0)
    actor.GetTextProperty().SetBackgroundOpacity(1.0)
    return actor


def round_numbers(low, high):
    """Three to seven multiples of 1, 2 or 5 times a power of ten from low to high, as words and numbers."""
    rough = (high - low) / 5
    power = 10.0 ** math.floor(math.log10(rough))
    step = min((factor * power for factor in (1, 2, 5, 10)), key=lambda one: abs(math.log(one / rough)))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [(f"{i * step:.6g}", i * step) for i in range(first, last + 1)]


def colour_bar(colours, title, scale=1.0):
    """At the right: the colours between the ends of their range, with round numbers."""
    low, high = colours.GetRange()
    width, height, left, bottom = 60 * scale, 0.5 * SIZE[1], SIZE[0] - 200 * scale, 0.2 * SIZE[1]
    steps = 120
    actors = [square(colours.GetColor(low + (i + 0.5) / steps * (high - low)), (width, height / steps + 1), left,
                     bottom + i * height / steps) for i in range(steps)]
    for word, value in round_numbers(low, high):
        y = bottom + (value - low) / (high - low) * height
        actors.append(square(INK, (14 * scale, 3), left + width, y - 1.5))
        label = text(word, round(48 * scale), left + width + 22 * scale, y)
        label.GetTextProperty().SetVerticalJustificationToCentered()
        actors.append(label)
    return actors + [text(title, round(52 * scale), left - 20 * scale, bottom + height + 28 * scale)]


def square(colour, sides, x, y):
    points = vtkPoints()
    for corner in ((0, 0), (1, 0), (1, 1), (0, 1)):
        points.InsertNextPoint(corner[0] * sides[0], corner[1] * sides[1], 0)
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


def rule_legend(present, places, size=44):
    """Names and colours of rules, at places (x, y)."""
    actors = []
    for (x, y), rule in zip(places, sorted(present)):
        label, colour = RULES[rule]
        actors += [square(colour, (0.8 * size, 0.8 * size), x, y), text(label, size, x + 1.3 * size, y)]
    return actors


ROOM = (0.04, 0.04, 0.04, 0.17)  # left, right, below and above what a picture shows, as parts of it
ROOM_FOR_NOTES = (0.04, 0.15, 0.16, 0.12)  # for a bar at the right and a legend below


def render(actors, annotations, points, direction, room=ROOM, size=SIZE):
    """An image of actors, seen so that points fill it."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for actor in actors:
        renderer.AddActor(actor)
    for actor in annotations:
        renderer.AddActor2D(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(0.85)
    lights.AddLightsToRenderer(renderer)
    aim_camera(renderer, points, direction, room)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return grab.GetOutput()


def aim_camera(renderer, points, direction, room):
    """Looks against `direction` at some points, so that they fill the picture but for the room at its sides."""
    forward = np.array(direction) / np.linalg.norm(direction)
    right = np.cross((0, 0, 1), forward)
    right /= np.linalg.norm(right)
    up = np.cross(forward, right)
    seen = points @ np.array([right, up, forward]).T
    low, high = seen.min(axis=0), seen.max(axis=0)
    width, height, depth = high - low
    aspect = SIZE[0] / SIZE[1]
    left_room, right_room, low_room, high_room = room
    scale = max(height / (1 - low_room - high_room), width / aspect / (1 - left_room - right_room)) / 2
    middle = (low + high) / 2 + scale * np.array([(right_room - left_room) * aspect, high_room - low_room, 0])
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


# ---------------------------------------------------------------- cuts

def middle_plane(points, normal):
    """Through the middle of points, or a little off it, where models have their points."""
    low, high = points.min(axis=0), points.max(axis=0)
    unit = np.array(normal) / np.linalg.norm(normal)
    plane = vtkPlane()
    plane.SetOrigin(*((low + high) / 2 + 0.004 * math.dist(low, high) * unit))
    plane.SetNormal(*normal)
    return plane


def behind(data, plane):
    """The half behind a plane, cut through."""
    cut = vtkTableBasedClipDataSet()
    cut.SetClipFunction(plane)
    cut.InsideOutOn()
    cut.SetInputData(data)
    cut.Update()
    return surface_of(cut.GetOutput())


def cap_actors(solids, plane, colouring, size, edges):
    """The face where a plane cuts solids, in plain colours, and the line around it."""
    cutter = vtkCutter()
    cutter.SetInputData(solids)
    cutter.SetCutFunction(plane)
    if edges:  # of the cells, not of triangles that they are cut into
        cutter.GenerateTrianglesOff()
    clean = vtkCleanPolyData()
    clean.SetInputConnection(cutter.GetOutputPort())
    clean.Update()
    if clean.GetOutput().GetNumberOfPolys() == 0:
        return []
    face = polygons(clean.GetOutput(), colouring, edges, False)
    face.GetProperty().SetAmbient(1.0)  # no light: colours are those of the bar
    face.GetProperty().SetDiffuse(0.0)
    face.GetProperty().SetSpecular(0.0)
    border = vtkFeatureEdges()
    border.SetInputConnection(clean.GetOutputPort())
    border.FeatureEdgesOff()
    border.NonManifoldEdgesOff()
    border.ColoringOff()
    border.Update()
    line = tubes(border.GetOutput(), 0.0015 * size, None)
    line.GetProperty().SetColor(*INK)
    return [face, line]


def cut_actors(grid, plane, colouring, size, cap_colouring=None, edges=False):
    """What is behind a plane, with flat caps on cut solids; curves stay whole."""
    solids = of_types(grid, *SOLIDS)
    others = surface_of(of_types(grid, *(set(range(1, VTK_PYRAMID + 1)) - set(SOLIDS))))
    actors = []
    for part, on_top in ((surface_of(solids), False), (others, True)):
        half = behind(only(part, polys=True), plane) if part.GetNumberOfPolys() else part
        if half.GetNumberOfPolys():
            actors.append(polygons(half, colouring, edges, on_top))
    if solids.GetNumberOfCells():
        actors += cap_actors(solids, plane, cap_colouring or colouring, size, edges)
    return actors + cut_curves(others, plane, colouring, size)


def cut_curves(data, plane, colouring, size):
    """Those that are creases are cut as what they lie on."""
    actors = []
    for lines in (behind(lines_of(data, True), plane), lines_of(data, False)):
        actors += curves_and_points(lines, colouring, size)
    return actors


def lines_of(data, creases):
    """The lines that are flagged as creases, or all others."""
    lines = only(data, lines=True)
    flags = lines.GetCellData().GetArray("Singular")
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray()).reshape(-1, 2)
    chosen = (vtk_to_numpy(flags) != 0 if flags else np.zeros(len(ids), bool)) == creases
    made = vtkPolyData()
    made.SetPoints(lines.GetPoints())
    made.GetPointData().ShallowCopy(lines.GetPointData())
    cells = vtkCellArray()
    cells.SetData(2, numpy_to_vtk(ids[chosen].astype(np.int64).ravel(), deep=True))
    made.SetLines(cells)
    for i in range(lines.GetCellData().GetNumberOfArrays()):
        array = lines.GetCellData().GetArray(i)
        if array:
            values = numpy_to_vtk(vtk_to_numpy(array)[chosen], deep=True)
            values.SetName(array.GetName())
            made.GetCellData().AddArray(values)
    return made


def with_rules_of_cells(data):
    """Poly data with the cell array RuleOfCell: 2 but where all corners have another rule."""
    rules = vtk_to_numpy(data.GetPointData().GetArray("RuleDimension"))
    made = only(data, polys=True)
    corners = vtk_to_numpy(made.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    values = np.where((rules[corners] == 2).any(axis=1), 2, rules[corners].max(axis=1))
    array = numpy_to_vtk(values.astype(np.int32), deep=True)
    array.SetName("RuleOfCell")
    made.GetCellData().AddArray(array)
    return made


def rule_actors(grid, plane, size):
    """A cut mesh in the colours of its rules, and the rules that are seen."""
    colours = category_colours(RULES)
    solids = of_types(grid, *SOLIDS)
    others = surface_of(of_types(grid, *(set(range(1, VTK_PYRAMID + 1)) - set(SOLIDS))))
    actors, present = [], set()
    for part, on_top in ((surface_of(solids), False), (others, True)):
        if part.GetNumberOfPolys():
            half = behind(with_rules_of_cells(part), plane)
            actors.append(polygons(half, ("cell", "RuleOfCell", colours), False, on_top))
            present.add(2)
    if solids.GetNumberOfCells():
        caps = cap_actors(solids, plane, None, size, False)
        for face in caps[:1]:
            face.GetProperty().SetColor(*RULES[3][1])
            present.add(3)
        actors += caps
    actors += cut_curves(others, plane, ("point", "RuleDimension", colours), size)
    return actors + rule_balls(grid, size, plane), present | set(rules_in(grid)) - {3}


# ---------------------------------------------------------------- pictures of models

class ModelPictures:
    """What demo.py shows of a control mesh and of what became of it."""

    def __init__(self, name, control, smooth, levels, direction, normal):
        self.name, self.direction, self.levels = name, direction, levels
        self.grid = smooth.NewInstance()
        self.grid.ShallowCopy(smooth)  # the array that is shown may have to be added
        self.points = np.concatenate([used_points(control), used_points(smooth)])
        control_points = used_points(control)
        size = math.dist(control_points.min(axis=0), control_points.max(axis=0))
        plane = middle_plane(control_points, normal)
        self.array, low, high = shown_array(self.grid)
        self.colours = tension_colours(low, high)
        parts = part_array(control)
        rules, self.present = rule_actors(self.grid, plane, size)
        self.actors = {
            "control": actors_of(control, parts, size, edges=True), "smooth": actors_of(self.grid, parts, size),
            "inside": cut_actors(self.grid, plane, ("point", self.array, self.colours), size), "rules": rules}

    def draw(self):
        """(what it shows, image), with titles and legends."""
        steps = f"{self.levels} level{'s' * (self.levels != 1)}"
        places = [(40 + 800 * (i % 2), 140 - 56 * (i // 2)) for i in range(5)]
        shown = [
            ("control", "control mesh", []), ("smooth", steps, []),
            ("inside", f"{steps}, cut open", colour_bar(self.colours, self.array)),
            ("rules", "rules (RuleDimension)", rule_legend(self.present, places))]
        return [(what, render(self.actors[what], [*notes, caption(f"{self.name}: {title}")], self.points,
                              self.direction, ROOM_FOR_NOTES)) for what, title, notes in shown]

    def draw_bare(self):
        """The same without words, to be printed small; the bar has large ones."""
        bar = colour_bar(self.colours, self.array, 2.0)
        return [render(actors, bar if what == "inside" else [], self.points, self.direction, (0.02, 0.29, 0.02, 0.02))
                for what, actors in self.actors.items()]


def table_for_readme(models):
    """The pictures of some models, with heads above and the legend below."""
    heads = [text(words, 64, 3200 // 4 * i + 30, 30) for i, words in
             enumerate(("control mesh", f"{models[0].levels} levels", "cut open", "rules"))]
    legend = rule_legend(range(5), [(30 + x, 24) for x in (0, 720, 1400, 1810, 2330)], 46)
    corner = np.array([[0.0, 0, 0], [1, 1, 1]])
    head, foot = (render([], actors, corner, (1, 1, 1), size=(3200, 110)) for actors in (heads, legend))
    rows = [[picture_files.halved(image) for image in model.draw_bare()] for model in models]
    return picture_files.contact_sheet([[head], *rows, [foot]])


def rules_in(grid):
    return [int(rule) for rule in np.unique(vtk_to_numpy(grid.GetPointData().GetArray("RuleDimension")))]


def used_points(grid):
    """The points that cells use; others may be anywhere."""
    return points_of(grid)[np.unique(vtk_to_numpy(grid.GetCells().GetConnectivityArray()))].astype(float)
