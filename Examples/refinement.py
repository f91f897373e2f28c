# SPDX-License-Identifier: BSD-3-Clause
"""Detail only where it is needed: refinement_values.png, refinement_shape.png, and what it saves in numbers.

The block of two materials, refined where its values change; and the screw on the limit of subdivision,
refined to a tolerance, beside the uniform mesh that is as exact.

`./dev demo` makes these after the gallery; `pvpython --force-offscreen-rendering refinement.py` makes
only these (see demo.py for the environment that it needs).
"""

import math
import os
import time

import demo_pictures as look
import numpy as np
import picture_files
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

BLOCK_TOLERANCE = 0.15
SHOWN_TOLERANCE = 0.3
FINEST = 5  # level of the mesh that errors are measured with


def updated(proxy):
    """The output of a proxy, and the seconds that it took."""
    start = time.perf_counter()
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0), time.perf_counter() - start


def model(name):
    source = simple.SubdivisionModel(Model=name)
    source.UpdatePipeline()
    return source


def largest_jump(grid, name):
    """The largest change of an array along an edge."""
    values = vtk_to_numpy(grid.GetPointData().GetArray(name))
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    return float(np.ptp(values[tets], axis=1).max())


def distance(points, grid):
    """The largest distance of points from the surface of a grid."""
    surface = vtkImplicitPolyDataDistance()
    surface.SetInput(look.surface_of(grid))
    distances = vtkDoubleArray()
    surface.FunctionValue(points, distances)
    return float(np.abs(vtk_to_numpy(distances)).max())


def row(words, cells, error, seconds):
    print(f"  {words:<34} {cells:>9,} cells   error {error:.5f}   {seconds:7.3f} s", flush=True)


def picture(grid, words, frame, direction, colouring=None):
    size = math.dist(frame.min(axis=0), frame.max(axis=0))
    actors = look.actors_of(grid, colouring or look.part_array(grid), size, edges=True)
    return look.render(actors, [look.caption(words)], frame, direction)


def block():
    print("Refined where Tension changes (error: its largest change along an edge, part of its range)")
    source = model("MaterialBlock")
    control, _ = updated(source)
    low, high = control.GetPointData().GetArray("Tension").GetRange()
    refined = simple.RedGreenRefinement(
        Input=source, AttributeArray=["POINTS", "Tension"], AttributeTolerance=BLOCK_TOLERANCE, MaximumLevel=8)
    grid, seconds = updated(refined)
    error = largest_jump(grid, "Tension") / (high - low)
    row(f"adaptive, tolerance {BLOCK_TOLERANCE}", grid.GetNumberOfCells(), error, seconds)
    for level in range(1, 7):
        uniform, seconds = updated(simple.RedGreenRefinement(
            Input=source, RefineByAttributeError=0, RefineByEdgeLength=1, MaximumEdgeLength=0, MaximumLevel=level))
        error = largest_jump(uniform, "Tension") / (high - low)
        row(f"uniform, level {level}", uniform.GetNumberOfCells(), error, seconds)
        if error <= BLOCK_TOLERANCE:
            break
    print(f"  so the adaptive mesh saves {100 * (1 - grid.GetNumberOfCells() / uniform.GetNumberOfCells()):.0f} %"
          " of the cells.")
    frame = look.used_points(control)
    colouring = ("point", "Tension", look.tension_colours(low, high))
    coarse, _ = updated(simple.RedGreenRefinement(
        Input=source, AttributeArray=["POINTS", "Tension"], AttributeTolerance=SHOWN_TOLERANCE, MaximumLevel=8))
    return [picture(some, f"{words}\n{some.GetNumberOfCells():,} cells", frame, (1.0, -1.6, 0.9), colouring)
            for some, words in ((control, "MaterialBlock"), (coarse, f"AttributeTolerance {SHOWN_TOLERANCE}:"),
                                (grid, f"AttributeTolerance {BLOCK_TOLERANCE}:"))]


def screw():
    print(f"Refined to a distance from the limit (error: measured with level {FINEST})")
    source = model("Screw")
    finest, _ = updated(simple.MultidimensionalSubdivision(
        Input=source, NumberOfLevels=FINEST, ProjectToLimit=1))
    exact = look.surface_of(finest).GetPoints().GetData()
    for level in (2, 3, 4):
        uniform, seconds = updated(simple.MultidimensionalSubdivision(
            Input=source, NumberOfLevels=level, ProjectToLimit=1))
        error = distance(exact, uniform)
        row(f"uniform, level {level}", uniform.GetNumberOfCells(), error, seconds)
        # The criterion is on the safe side: what it allows may be more than what is found.
        for factor in (1.3, 1.2, 1.1, 1.0):
            grid, seconds = updated(simple.RedGreenRefinement(
                Input=source, RefineByAttributeError=0, RefineByGeometricError=1, Shape="Smooth",
                GeometricTolerance=factor * error, RelativeTolerance=0, MaximumLevel=8))
            ours = distance(exact, grid)
            if ours <= error:
                break
        row(f"adaptive, as exact, a part of 1/{uniform.GetNumberOfCells() / grid.GetNumberOfCells():.1f}",
            grid.GetNumberOfCells(), ours, seconds)
        if level == 3:
            shown = (uniform, "uniform, level 3:"), (grid, "adaptive, as exact:")
    frame = look.used_points(finest)
    blade = frame.mean(axis=0) + (frame - frame.mean(axis=0)) * 0.3 + 0.26 * np.ptp(frame, axis=0) * (1, 0, 0)
    view = (1.0, -1.6, 0.5)
    whole = [picture(some, f"{words}\n{some.GetNumberOfCells():,} cells", frame, view) for some, words in shown]
    return whole + [picture_files.framed(picture(some, "detail", blade, view)) for some, _ in shown]


def draw():
    picture_files.write_figure(block(), "refinement_values", 3)
    picture_files.write_figure(screw(), "refinement_shape", 2)
    print(f"What was refined is in refinement_*.png in {os.getcwd()}.")


if __name__ == "__main__":
    import demo

    demo.load_plugin()
    draw()
