# SPDX-License-Identifier: BSD-3-Clause
"""What properties do to a shape, side by side: the pictures of the guide that no other script makes.

`./dev pictures` makes them after those of `./dev demo`: gallery_*.png to be printed, and in the folder guide the small
ones, which Documentation/Guide/pictures has; `pvpython --force-offscreen-rendering guide_pictures.py` makes only these
(see demo.py for the environment that it needs).
"""

import math
import os
import pathlib
import re

import adaptive_surfaces
import demo_pictures as look
import numpy as np
import picture_files
import scheme_pictures
import surface_pictures
from deformation import quads, shaded, source_of, to_points, wires
from gallery import Figure, Mesh, ball, model, only_cells, subdivide
from paraview import simple
from side_by_side import VIEW, add_array, output, points_of, write
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_PYRAMID,
    VTK_QUADRATIC_TETRA,
    VTK_TETRA,
    VTK_WEDGE,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOImage import vtkPNGReader

# ---------------------------------------------------------------- Multi-dimensional Subdivision

def levels():
    grid = model("Ship")
    figure = Figure("levels", "Ship", grid, (0.7, -1.0, 0.5))
    for count in (1, 2):
        figure.add(f"NumberOfLevels {count}", subdivide(grid, count), rules=False, edges=True)
    figure.write()


def volume_schemes():
    grid = ball().grid()
    figure = Figure("volume_schemes", "8 hexahedra", grid, (0.35, -1.0, 0.4))
    for words, options in (("Standard", {"VolumeScheme": "Standard"}), ("Even", {"VolumeScheme": "Even"}),
                           ("Keep cell types", {"VolumeScheme": "Keep cell types"}),
                           ("Linear", {"VolumeScheme": "Linear"}),
                           ("Linear,\nKeepCellTypes", {"VolumeScheme": "Linear", "KeepCellTypes": 1})):
        figure.add_cut(words, subdivide(grid, 2, **options), (0.0, -1.0, 0.0), edges=True)
    figure.write()


def four_cell_types():
    """A row of hexahedra between two wedges, with pyramids on them and tetrahedra between these."""
    count = 3
    points = [(x, y, z) for x in range(count + 1) for z in (0, 1) for y in (0, 1)]
    tips = [len(points) + i for i in range(count)]
    points += [(x + 0.5, 0.5, 1.8) for x in range(count)] + [(x, y, 0) for x in (-1, count + 1) for y in (0, 1)]
    ends = len(points) - 4
    grid = vtkUnstructuredGrid()
    grid.SetPoints(to_points(np.array(points, dtype=float)))
    parts = []

    def add(kind, *ids):
        grid.InsertNextCell(kind, len(ids), ids)
        parts.append((VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_TETRA).index(kind))

    for i in range(count):
        a, b = 4 * i, 4 * i + 4
        add(VTK_HEXAHEDRON, a, b, b + 1, a + 1, a + 2, b + 2, b + 3, a + 3)
        add(VTK_PYRAMID, a + 2, b + 2, b + 3, a + 3, tips[i])
    for i in range(count - 1):
        add(VTK_TETRA, 4 * i + 6, 4 * i + 7, tips[i], tips[i + 1])
    add(VTK_WEDGE, ends, 0, 2, ends + 1, 1, 3)
    last = 4 * count
    add(VTK_WEDGE, ends + 2, last + 2, last, ends + 3, last + 3, last + 1)
    add_array(grid.GetCellData(), "MaterialId", parts)
    return grid


def cell_types():
    grid = four_cell_types()
    figure = Figure("cell_types", "Four types of cells", grid, (0.35, -1.0, 0.5))
    for words, scheme in (("Standard: tetrahedra,\nwith a diagonal in each quad", "Standard"),
                          ("Keep cell types", "Keep cell types")):
        figure.add(words, subdivide(grid, 2, VolumeScheme=scheme), rules=False, edges=True)
    figure.add_cut("Keep cell types,\ncut open", subdivide(grid, 2, VolumeScheme="Keep cell types"), (0.0, -1.0, 0.0),
                   edges=True)
    figure.write()


def rim_of_a_block(sharpness):
    """A block whose upper rim is a crease."""
    mesh = ball()
    around = [(-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1)]
    count = len(mesh.cells)
    mesh.curve(*((x, y, 1) for x, y in around))
    grid = mesh.grid()
    add_array(grid.GetCellData(), "Sharpness", [0.0] * count + [sharpness] * (len(around) - 1))
    return grid


def sharpness():
    figure = Figure("sharpness", "A crease", rim_of_a_block(1.0), VIEW)
    for value in (0.0, 1.0, 1.5, 2.0, math.inf):
        smooth = subdivide(rim_of_a_block(value), SharpnessArray=["CELLS", "Sharpness"])
        figure.add(f"Sharpness {value:g}", look.of_types(smooth, *look.SOLIDS), rules=False)
    figure.write()


def marks():
    grid = ball().grid()
    add_array(grid.GetPointData(), "Mark", (points_of(grid)[:, 2] > 0.5).astype(float))
    figure = Figure("marks", "Marked at the top", grid, VIEW)
    for words, options in (("no marks", None), ("MarkCorners", (1, 0, 0)), ("MarkCreases", (0, 1, 0)),
                           ("MarkSurfaces", (0, 0, 1))):
        names = ("MarkCorners", "MarkCreases", "MarkSurfaces")
        chosen = {**dict(zip(names, options)), "MarksArray": ["POINTS", "Mark"]} if options else {}
        figure.add(words, subdivide(grid, **chosen))
    figure.write()


def levels_of_marks():
    grid = ball().grid()
    points = points_of(grid)
    top = points[:, 2] > 0.5
    rim = top & (abs(points[:, :2]).max(axis=1) > 0.5)
    options = {"MarksArray": ["POINTS", "Mark"], "MarkCorners": 0, "MarkCreases": 1}
    add_array(grid.GetPointData(), "Mark", rim.astype(float))
    figure = Figure("levels_of_marks", "The rim is marked", grid, VIEW)
    figure.add("MarkCreases,\nno LevelsArray", subdivide(grid, **options), rules=False)
    for words, values in (("LevelsArray:\n1 everywhere", np.ones(len(points))),
                          ("LevelsArray: 1 at the left,\ninfinity elsewhere", np.where(points[:, 0] < -0.5, 1.0, np.inf))):
        add_array(grid.GetPointData(), "Levels", values)
        figure.add(words, subdivide(grid, LevelsArray=["POINTS", "Levels"], **options), rules=False)
    figure.write()


def crease_geometry():
    """Lines and a vertex of another mesh, at points of the ball."""
    around = ((-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1))
    figure = Figure("crease_geometry", "A ball without creases", ball().grid(), VIEW)
    for words, has_line, has_vertex in (("a closed line", True, False), ("a vertex", False, True), ("both", True, True)):
        mesh = Mesh()
        if has_line:
            mesh.curve(*((x, y, 1) for x, y in around))
        if has_vertex:
            mesh.cell((1, -1, -1))
        smooth = subdivide(ball().grid(), CreaseGeometry=source_of(mesh.grid()))
        figure.add(f"CreaseGeometry:\n{words}", smooth)
    figure.write()


def rules_by_region():
    """Two sheets on a block: the joint of one of them has its own rule."""
    mesh = Mesh()
    mesh.block((0, 0, 0), (4, 2, 1))
    for part, x in ((2, 1), (3, 3)):
        mesh.sheet(lambda u, v, x=x: (x, u, 1 + v), 2, 2, part=part)
    grid = mesh.grid()
    right = vtk_to_numpy(grid.GetCellData().GetArray("MaterialId")) == 3
    figure = Figure("rules_by_region", "Two sheets on a block", grid, (0.55, -1.0, 0.45))
    for words, rule in (("no JointOfEachCell:\nboth blend", 0), ("JointOfEachCell: 2 (Sharp)\nin the right sheet", 2),
                        ("JointOfEachCell: 5 (Follow Dimension 3)\nin the right sheet", 5)):
        add_array(grid.GetCellData(), "Rule", np.where(right, rule, 0).astype(np.int32))
        figure.add(words, subdivide(grid, JointOfEachCell=["CELLS", "Rule"]))
    figure.write()


def features():
    grid = only_cells(model("MechanicalPart"), "Singular", 0)
    figure = Figure("features", "No flags", grid, (-0.45, -1.0, 0.75))
    figure.add("DetectFeatures\noff", subdivide(grid, 3), rules=False)
    for angle in (30, 60):
        figure.add(f"DetectFeatures,\nFeatureAngle {angle}", subdivide(grid, 3, DetectFeatures=1, FeatureAngle=angle),
                   rules=False)
    figure.write()


def interpolation():
    grid = ball().grid()
    figure = Figure("interpolation", "8 hexahedra", grid, VIEW)
    for words, count, options in (
            ("default", 4, {}), ("ProjectToLimit,\n1 level", 1, {"ProjectToLimit": 1}),
            ("InterpolatePoints,\nInterpolationWeight 0.5", 4, {"InterpolatePoints": 1, "InterpolationWeight": 0.5}),
            ("InterpolatePoints", 4, {"InterpolatePoints": 1})):
        figure.add(words, subdivide(grid, count, **options), rules=False, edges=count == 1)
    figure.write()


def quadratic_cells():
    """A quadratic tetrahedron with bent edges."""
    corners = np.array([[0, 0, 0], [2, 0, 0], [1, 1.8, 0], [1, 0.6, 1.8]])
    middles = [(corners[a] + corners[b]) / 2 for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
    bent = [x + 0.45 * (x - corners.mean(axis=0)) for x in middles]
    grid = vtkUnstructuredGrid()
    grid.SetPoints(to_points(np.array([*corners, *bent])))
    grid.InsertNextCell(VTK_QUADRATIC_TETRA, 10, range(10))
    add_array(grid.GetCellData(), "MaterialId", [0])
    shown = []
    for option in ("Corners", "Pieces"):
        for words, count in ((f"control mesh:\n{option}", 0), (f"QuadraticCells:\n{option}", 4)):
            made = subdivide(grid, count, QuadraticCells=option)
            actors = look.actors_of(made, look.part_array(grid), 2.0, edges=count == 0)
            shown.append((words, actors, look.used_points(made)))
    write("quadratic_cells", shown, VIEW, 4)


def join_blocks():
    """Two blocks of two hexahedra, which share a face."""
    blocks = []
    for part in (0, 1):
        mesh = Mesh()
        mesh.block((0, 0, part), (2, 1, 1), part=lambda i, j, k, number=part: number)
        blocks.append(source_of(mesh.grid()))
    group = simple.GroupDatasets(Input=blocks)
    shown = []
    for words, count, join in (("two blocks", 0, 1), ("JoinBlocks 1", 4, 1), ("JoinBlocks 0", 4, 0)):
        grid = output(simple.MergeBlocks(Input=simple.MultidimensionalSubdivision(
            Input=group, NumberOfLevels=count, JoinBlocks=join)))
        actors = look.actors_of(grid, look.part_array(grid), 3.0, edges=count == 0)
        shown.append((words, actors, look.used_points(grid)))
    write("join_blocks", shown, VIEW)


def interface_values():
    """A value that each material has, as one field and as a field of each."""
    continuous, jumping = model("MaterialBlock"), model("MaterialBlock")
    density = vtk_to_numpy(jumping.GetCellData().GetArray("MaterialId")).astype(float)
    add_array(jumping.GetCellData(), "Density", density)
    add_array(continuous.GetPointData(), "Density", mean_of_cells(continuous, density))
    colours = look.tension_colours(0.0, 1.0)
    shown = []
    for words, grid, options in (
            ("Continuous", continuous, {}),
            ("Discontinuous", jumping, {"InterfaceValues": "Discontinuous", "CellArraysToSmooth": ["Density"]})):
        made = subdivide(grid, 3, PreserveInterfaces=1, **options)
        plane = look.middle_plane(look.used_points(made), (0.0, -1.0, 0.0))
        actors = []
        for part in (0, 1):  # cut one by one, because a cut joins points that coincide
            actors += look.cut_actors(only_cells(made, "MaterialId", part), plane, ("point", "Density", colours), 3.0)
        shown.append((f"InterfaceValues:\n{words}", actors, look.used_points(made)))
    write("interface_values", shown, (0.7, -1.0, 0.6), 2)


def mean_of_cells(grid, values):
    sums, counts = np.zeros(grid.GetNumberOfPoints()), np.zeros(grid.GetNumberOfPoints())
    for cell, value in enumerate(values):
        ids = [grid.GetCell(cell).GetPointId(i) for i in range(grid.GetCell(cell).GetNumberOfPoints())]
        sums[ids] += value
        counts[ids] += 1
    return sums / np.maximum(counts, 1)


# ---------------------------------------------------------------- local refinement

NO_CRITERION = {"RefineByAttributeError": 0, "RefineByGeometricError": 0}
CRITERIA = (
    ("RefineByEdgeLength", {"MaximumEdgeLength": 0.45}),
    ("RefineByGeometricError", {"GeometricTolerance": 0.004}),
    ("RefineByCurvature", {"MaximumAngle": 30.0}))


def refined(filter_of, source, criterion, options, **more):
    return output(filter_of(Input=source, **{**NO_CRITERION, criterion: 1, "MaximumLevel": 8, **options, **more}))


def cells_picture(words, grid):
    return words, look.actors_of(grid, look.part_array(grid), 10.0, edges=True), look.used_points(grid)


def criteria():
    source = source_of(model("MechanicalPart"))
    grid = output(source)
    middle = look.used_points(grid)
    centre = middle.mean(axis=0)
    near = np.array([np.linalg.norm(np.mean([grid.GetPoint(grid.GetCell(i).GetPointId(k)) for k in range(
        grid.GetCell(i).GetNumberOfPoints())], axis=0) - centre) for i in range(grid.GetNumberOfCells())])
    add_array(grid.GetCellData(), "WantedLevel", np.where(near < np.quantile(near, 0.3), 2, 0).astype(np.int32))
    shown = [("control mesh", grid)]
    for name, options in CRITERIA:
        placement = {} if name == "RefineByEdgeLength" else {"Shape": "Smooth"}
        shown.append((name, refined(simple.RedGreenRefinement, source, name, options, **placement)))
    name = "RefineByWantedLevel"
    shown.append((name, refined(simple.RedGreenRefinement, source_of(grid), name, {})))
    shown.append(("RefineByAttributeError", refined(
        simple.RedGreenRefinement, source, "RefineByAttributeError",
        {"AttributeArray": ["POINTS", "Tension"], "AttributeTolerance": 0.1})))
    write("criteria", [cells_picture(f"{words}\n{grid.GetNumberOfCells():,} cells", grid) for words, grid in shown],
          (-0.45, -1.0, 0.75))


def criteria_of_places():
    """Where values lie in a range, and inside a sphere."""
    source = source_of(model("MaterialBlock"))
    low, high = output(source).GetPointData().GetArray("Tension").GetRange()
    top = [0.6 * high + 0.4 * low, high]
    ranged = refined(simple.RedGreenRefinement, source, "RefineByArrayRange",
                     {"RangeArray": ["POINTS", "Tension"], "ArrayRange": top, "MaximumLevel": 3})
    inside = simple.RedGreenRefinement(Input=source, RefineByFunction=1, ImplicitFunction="Sphere", MaximumLevel=4,
                                       **NO_CRITERION)
    bounds = output(source).GetBounds()
    inside.ImplicitFunction.Center = [bounds[1], bounds[2], bounds[5]]
    inside.ImplicitFunction.Radius = 0.4 * (bounds[5] - bounds[4])
    chosen = simple.IDSelectionSource(FieldType="CELL", IDs=[-1, 0, -1, 5])
    selected = refined(simple.RedGreenRefinement, source, "RefineBySelection", {"Selection": chosen, "MaximumLevel": 3})
    shown = [cells_picture(f"{words}\n{grid.GetNumberOfCells():,} cells", grid) for words, grid in (
        ("RefineByArrayRange", ranged), ("RefineByFunction", output(inside)), ("RefineBySelection", selected))]
    write("criteria_of_places", shown, (0.7, -1.0, 0.6))


def adaptive_criteria():
    source = adaptive_surfaces.solids_of("MechanicalPart")
    shown = [surface_pictures.surface_picture("control mesh", output(source), True)]
    for name, options in CRITERIA:
        made = refined(simple.AdaptiveSurfaceSubdivision, source, name, options, MaximumLevel=12)
        words = f"{name}\n{made.GetNumberOfCells():,} triangles"
        shown.append(surface_pictures.surface_picture(words, look.surface_of(made), True))
    write("adaptive_criteria", shown, (1.0, -1.6, 0.7), 2)


# ---------------------------------------------------------------- deformation and cages

def raised(x):
    return x + np.outer(0.35 * x[:, 2] ** 2, (1, 0, 0))


def outside_points():
    ball_of_quads = output(simple.Sphere(Center=[0.0, 0.0, 1.7], Radius=1.15, ThetaResolution=80, PhiResolution=80))
    cage = output(simple.Cage(Bounds=[-0.9, 0.9, -1.3, 1.3, 0.0, 3.4], NumberOfCells=[2, 2, 3], Margin=0))
    moved = cage.NewInstance()
    moved.ShallowCopy(cage)
    moved.SetPoints(to_points(raised(points_of(cage))))
    shown = [("at rest", [shaded(ball_of_quads, look.PALETTE[3])] + wires(cage, 6), points_of(cage))]
    for rule in ("Leave", "Nearest"):
        made = output(simple.SubdivisionDeformation(
            Input=source_of(ball_of_quads), RestMesh=source_of(cage), DeformedMesh=source_of(moved),
            OutsidePoints=rule))
        shown.append((f"OutsidePoints:\n{rule}", [shaded(made, look.PALETTE[3])] + wires(moved, 6),
                      np.concatenate([points_of(moved), points_of(made)])))
    write("outside_points", shown, (0.35, -1.0, 0.3))


def deformation_levels():
    """A rod in a cage of few boxes."""
    height, angle = np.meshgrid(np.linspace(0.1, 3.3, 80), np.linspace(0, 2 * math.pi, 48, endpoint=False),
                                indexing="ij")
    rod = quads(np.stack([0.5 * np.cos(angle), 0.5 * np.sin(angle), height], axis=-1), (False, True))
    cage = output(simple.Cage(Bounds=[-1, 1, -1, 1, 0.0, 3.4], NumberOfCells=[1, 1, 2], Margin=0))
    moved = cage.NewInstance()
    moved.ShallowCopy(cage)
    x = points_of(cage)
    shift = np.where(x[:, 2] > 2, 1.5, np.where(x[:, 2] > 1, -0.3, 0.0))  # of the upper and the middle layer
    moved.SetPoints(to_points(x + np.outer(shift, (1, 0, 0))))
    shown = [("at rest", [shaded(rod, look.PALETTE[3])] + wires(cage, 6), points_of(cage))]
    for count in (0, 1, 3):
        made = output(simple.SubdivisionDeformation(
            Input=source_of(rod), RestMesh=source_of(cage), DeformedMesh=source_of(moved), NumberOfLevels=count,
            OutsidePoints="Nearest"))
        shown.append((f"NumberOfLevels {count}", [shaded(made, look.PALETTE[3])] + wires(moved, 6), points_of(moved)))
    write("deformation_levels", shown, (0.35, -1.0, 0.3), 4)


def cages():
    thing = model("Screw")
    size = math.dist(*np.array(thing.GetBounds()).reshape(3, 2).T)
    shown = []
    for counts, margin in (([2, 2, 2], 5), ([4, 4, 3], 5), ([2, 2, 2], 30)):
        cage = output(simple.CageAround(Input=source_of(thing), NumberOfCells=counts, Margin=margin))
        words = f"NumberOfCells {' '.join(map(str, counts))}\nMargin {margin}"
        shown.append((words, look.actors_of(thing, look.part_array(thing), size) + wires(cage, size), points_of(cage)))
    write("cages", shown, VIEW)


# ---------------------------------------------------------------- the other filters

def labels():
    scan = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
    image = simple.Calculator(Input=scan, Function="(RTData > 130) + (RTData > 190)", ResultArrayName="Label")
    shown = []
    for words, options in (
            ("NumberOfSmoothingSteps 0", {"NumberOfSmoothingSteps": 0, "NumberOfLevels": 0}),
            ("default", {}), ("NumberOfControlCells 1000", {"NumberOfControlCells": 1000}),
            ("MaximumDisplacement 0.2", {"MaximumDisplacement": 0.2}),
            ("BackgroundLabel 1", {"BackgroundLabel": 1}), ("BackgroundLabel -1", {"BackgroundLabel": -1})):
        grid = output(simple.SmoothSolidfromLabels(Input=image, LabelsArray=["POINTS", "Label"], **options))
        points = look.used_points(grid)
        plane = look.middle_plane(points, (0.4, -1.0, 0.0))
        colours = "cell", "Label", look.part_colours(np.arange(3))
        actors = look.cut_actors(grid, plane, colours, 30.0)
        shown.append((f"{words}\n{grid.GetNumberOfCells():,} cells", actors, points))
    write("labels", shown, VIEW)


def topology():
    source = simple.SubdivisionModel(Model="Ship")
    shown = []
    colours = look.category_colours(look.RULES)
    for special in (0, 1):
        grid = output(simple.SimplicialComplexTopology(Input=source, SpecialOnly=special))
        edges = only_cells(grid, "SimplexDimension", 1)
        actors = look.actors_of(edges, ("cell", "RuleDimension", colours), 8.0)
        shown.append((f"SpecialOnly {special}", actors, look.used_points(grid)))
    write("topology", shown, (0.7, -1.0, 0.5), 2)


def dimensions():
    smooth = source_of(subdivide(model("Ship"), 3))
    parts = look.part_array(model("Ship"))
    whole = output(smooth)
    size = math.dist(*np.array(whole.GetBounds()).reshape(3, 2).T)
    shown = [("all", look.actors_of(whole, parts, size), look.used_points(whole))]
    for word in ("Solids", "Surfaces", "Lines"):
        grid = output(simple.ExtractDimensions(Input=smooth, OutputDimensions=[word]))
        shown.append((f"OutputDimensions:\n{word}", look.actors_of(grid, parts, size), look.used_points(whole)))
    write("dimensions", shown, (0.7, -1.0, 0.5), 2)


def models():
    import demo

    images = []
    for name, (direction, _) in demo.VIEWS.items():
        grid = model(name)
        points = look.used_points(grid)
        size = math.dist(points.min(axis=0), points.max(axis=0))
        images.append(look.render(look.actors_of(grid, look.part_array(grid), size, edges=True), [look.caption(name)],
                                  points, direction))
    picture_files.write_figure(images, "gallery_models", 4)


def figure():
    """The figure of the tutorial, by the lines that stand there."""
    project = pathlib.Path(__file__).resolve().parent.parent
    text = (project / "Documentation/Guide/FromAFileToAFigure.md").read_text(encoding="utf-8")
    lines = re.search(r"```python\n(.*?)```", text, re.DOTALL)[1].replace('"Data/', f'"{project}/Data/')
    exec(compile(lines, "FromAFileToAFigure.md", "exec"), dict(vars(simple)))
    reader = vtkPNGReader()
    reader.SetFileName("figure.png")
    reader.Update()
    picture_files.write_small_png(picture_files.halved(reader.GetOutput()), "guide/figure.png")


def draw():
    for make in (levels, volume_schemes, cell_types, sharpness, marks, levels_of_marks, crease_geometry,
                 rules_by_region, features, interpolation, quadratic_cells, join_blocks, interface_values,
                 surface_pictures.surface_options, surface_pictures.bezier_cells, surface_pictures.curved_cells,
                 surface_pictures.seams, surface_pictures.boundary, surface_pictures.corners, criteria,
                 criteria_of_places, adaptive_criteria, deformation_levels, outside_points, cages, labels, topology,
                 scheme_pictures.modified_boundary, scheme_pictures.error_bounds, scheme_pictures.smoothness,
                 scheme_pictures.maps_of_surfaces, scheme_pictures.maps_of_faces, scheme_pictures.maps_of_solids,
                 scheme_pictures.basis_functions, scheme_pictures.basis_functions_of_solids, dimensions, models, figure):
        make()
    print(f"What properties do is in gallery_*.png in {os.getcwd()}, and small in the folder guide.")


if __name__ == "__main__":
    import demo

    demo.load_plugin()
    draw()
