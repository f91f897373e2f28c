# SPDX-License-Identifier: BSD-3-Clause
"""Adaptive sqrt(3) beside adaptive Loop subdivision: adaptive_*.png, and a table of how many
triangles each takes to be as close to its limit as is asked for (L. Kobbelt, "sqrt(3)-Subdivision",
figures 11 and 12).

Both refine by the same criterion, the distance from the limit as a part of the bounding box, and put
all points on the limit. Their errors are then measured, as the largest distance of points of the limit
from the mesh; the points are those of a mesh for a smaller tolerance.

`./dev demo` makes this for two models. By hand, for other tolerances and surfaces (.vtp, .vtu):

    SUBDIVISIONOBJECTS_PLUGIN=<folder>/SubdivisionObjects.so pvpython adaptive_surfaces.py 1e-2 1e-3 ... FILE ...

With SUBDIVISIONOBJECTS_SHARED_DATA=<folder> the bunny there is one of the surfaces.
"""

import os
import sys
import time

import demo_pictures as look
import numpy as np
import picture_files
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance, vtkTriangleFilter

MODELS = ("MechanicalPart", "SpringAndValve")
# Where pictures of details look, as parts of the bounding box.
DETAILS = {"MechanicalPart": (0.6, 0.0, 0.3), "SpringAndValve": (0.3, 0.0, 0.65)}
QUICK = (1e-2, 1e-3)
MOST = 50_000_000  # cells that a mesh may have
MOST_TO_MEASURE = 6_000_000  # cells of the mesh whose points an error is measured with; nan beyond
SAMPLES = 100_000


def triangles_of(grid, solids_only=False):
    """The triangles of a surface, or of the boundary of solids, as a source without any array."""
    if solids_only:
        only_solids = vtkUnstructuredGrid()
        only_solids.SetPoints(grid.GetPoints())
        only_solids.Allocate(grid.GetNumberOfCells())
        for cell in np.flatnonzero(look.cell_types(grid) == VTK_TETRA):
            only_solids.InsertNextCell(VTK_TETRA, grid.GetCell(int(cell)).GetPointIds())
        grid = only_solids
    faces = vtkTriangleFilter()
    faces.SetInputData(look.surface_of(grid))
    faces.Update()
    bare = vtkPolyData()
    bare.SetPoints(faces.GetOutput().GetPoints())
    bare.SetPolys(faces.GetOutput().GetPolys())
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(bare)
    return source


def solids_of(name):
    source = simple.SubdivisionModel(Model=name)
    source.UpdatePipeline()
    return triangles_of(source.GetClientSideObject().GetOutputDataObject(0), solids_only=True)


def read(name):
    source = simple.OpenDataFile(name)
    source.UpdatePipeline()
    return triangles_of(source.GetClientSideObject().GetOutputDataObject(0))


def sqrt3(surface, tolerance):
    return simple.AdaptiveSurfaceSubdivision(
        Input=surface, RefineByAttributeError=0, RefineByGeometricError=1,
        GeometricTolerance=tolerance, MaximumLevel=40, MaximumNumberOfCells=MOST, OutputPointsPrecision="Double")


def loop(surface, tolerance):
    return simple.RedGreenRefinement(
        Input=surface, Shape="Smooth", RefineByAttributeError=0, RefineByGeometricError=1,
        GeometricTolerance=tolerance, MaximumLevel=20, MaximumNumberOfCells=MOST, OutputPointsPrecision="Double")


def updated(proxy):
    """The output of a proxy as a surface, and the seconds that it took."""
    start = time.perf_counter()
    proxy.UpdatePipeline()
    seconds = time.perf_counter() - start
    mesh = look.surface_of(proxy.GetClientSideObject().GetOutputDataObject(0))
    simple.Delete(proxy)
    return mesh, seconds


def largest_distance(exact, mesh):
    """Of some points of a surface from another one."""
    points = vtk_to_numpy(exact.GetPoints().GetData())
    some = np.ascontiguousarray(points[::max(1, len(points) // SAMPLES)])
    surface = vtkImplicitPolyDataDistance()
    surface.SetInput(mesh)
    distances = vtkDoubleArray()
    surface.FunctionValue(numpy_to_vtk(some), distances)
    return float(np.abs(vtk_to_numpy(distances)).max())


def measure(scheme, surface, tolerance, size):
    """Triangles, error as a part of `size` (nan where it would take too long to measure), seconds."""
    mesh, seconds = updated(scheme(surface, tolerance))
    cells = mesh.GetNumberOfCells()
    error = float("nan")
    if 8 * cells <= MOST_TO_MEASURE:
        exact, _ = updated(scheme(surface, tolerance / 8))
        error = largest_distance(exact, mesh) / size
    return cells, error, seconds


def compare(name, surface, tolerances):
    surface.UpdatePipeline()
    control = surface.GetClientSideObject().GetOutputDataObject(0)
    size = control.GetLength()
    print(f"{name}, {control.GetNumberOfCells():,} triangles")
    print("  tolerance     sqrt(3)    error  seconds |       Loop    error  seconds | sqrt(3) has fewer:"
          " at this tolerance, at the same error")
    for tolerance in tolerances:
        ours = measure(sqrt3, surface, tolerance, size)
        others = measure(loop, surface, tolerance, size)
        # The number of triangles goes with one over the error.
        fewer = 100 * (1 - ours[0] / others[0])
        fewer_at_error = 100 * (1 - ours[0] * ours[1] / (others[0] * others[1]))
        print(f"  {tolerance:<9g} " + " |".join(f"{cells:>11,} {error:8.1e} {seconds:8.2f}" for cells, error, seconds
                                              in (ours, others)) + f" | {fewer:5.0f} % {fewer_at_error:5.0f} %", flush=True)


def draw():
    print("Adaptive sqrt(3) beside adaptive Loop subdivision (errors as parts of the bounding box)")
    for name in MODELS:
        surface = solids_of(name)
        compare(name, surface, QUICK)
        meshes = [(words, updated(scheme(surface, 3e-3))[0]) for scheme, words in ((sqrt3, "sqrt(3)"), (loop, "Loop"))]
        frame = np.concatenate([look.points_of(mesh).astype(float) for _, mesh in meshes])
        low, size = frame.min(axis=0), np.ptp(frame, axis=0)
        images = [picture(mesh, f"{name}, {words}:\n{mesh.GetNumberOfCells():,} triangles", frame)
                  for words, mesh in meshes]
        detail = low + (frame - low) * 0.35 + size * DETAILS[name]
        images += [picture_files.framed(picture(mesh, "detail", detail)) for _, mesh in meshes]
        picture_files.write_figure(images, f"adaptive_{name}", 2)
    print(f"Both are in adaptive_*.png in {os.getcwd()}.")


def picture(mesh, words, frame):
    actor = look.polygons(mesh, None, True, False)
    actor.GetProperty().SetColor(0.87, 0.83, 0.73)
    return look.render([actor], [look.caption(words)], frame, (1.0, -1.6, 0.7))


def main(arguments):
    tolerances = [float(a) for a in arguments if not os.path.exists(a)] or QUICK
    surfaces = {name: solids_of(name) for name in MODELS}
    for name in [a for a in arguments if os.path.exists(a)]:
        surfaces[name] = read(name)
    bunny = os.path.join(os.environ.get("SUBDIVISIONOBJECTS_SHARED_DATA", ""), "surf_bunny_3k.vtp")
    if os.path.exists(bunny):
        surfaces["surf_bunny_3k"] = read(bunny)
    else:
        print("The bunny is left out: SUBDIVISIONOBJECTS_SHARED_DATA does not name its folder.")
    for name, surface in surfaces.items():
        compare(name, surface, tolerances)


if __name__ == "__main__":
    import demo

    demo.load_plugin()
    main(sys.argv[1:])
