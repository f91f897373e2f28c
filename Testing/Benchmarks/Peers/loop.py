# SPDX-License-Identifier: BSD-3-Clause
"""Loop subdivision beside that of VTK, on a sphere of 20,480 triangles with one array, three levels. By hand:
loop.py [REPETITIONS], with a Python that finds subdivisionobjects, or pvpython. VTK_SMP_MAX_THREADS is the number of
threads. VTK's filter uses one thread whatever that is."""

import statistics
import sys
import time

from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource

import subdivisionobjects

LEVELS = 3


def make_sphere():
    solid = vtkPlatonicSolidSource()
    solid.SetSolidTypeToIcosahedron()
    fine = subdivisionobjects.vtkSurfaceSubdivision()
    fine.SetInputConnection(solid.GetOutputPort())
    fine.SetNumberOfLevels(5)
    height = vtkElevationFilter()
    height.SetInputConnection(fine.GetOutputPort())
    height.Update()
    points = height.GetOutput()
    sphere = vtkPolyData()
    sphere.SetPoints(points.GetPoints())
    sphere.SetPolys(points.GetPolys())
    sphere.GetPointData().AddArray(points.GetPointData().GetArray("Elevation"))
    return sphere


def measure(make, set_levels, mesh):
    """Seconds of a first run, and the filter."""
    made = make()
    made.SetInputData(mesh)
    getattr(made, set_levels)(LEVELS)
    start = time.perf_counter()
    made.Update()
    return time.perf_counter() - start, made


def compare(mesh, repetitions, keep):
    """Medians of VTK's filter and ours. What is kept makes the next run ask the system for its memory."""
    vtk, ours, kept = [], [], []
    for _ in range(repetitions):  # in turns, so that both have what other work leaves
        for times, make, set_levels in ((vtk, vtkLoopSubdivisionFilter, "SetNumberOfSubdivisions"),
                                        (ours, subdivisionobjects.vtkSurfaceSubdivision, "SetNumberOfLevels")):
            seconds, made = measure(make, set_levels, mesh)
            times.append(seconds)
            kept += [made] if keep else []
    return statistics.median(vtk), statistics.median(ours)


def main():
    repetitions = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    mesh = make_sphere()
    threads = vtkSMPTools.GetEstimatedNumberOfThreads()
    print(f"{mesh.GetNumberOfCells()} triangles, {LEVELS} levels, {threads} thread(s)")
    for text, keep in (("memory used before", False), ("new memory", True)):
        vtk, ours = compare(mesh, repetitions, keep)
        print(f"{text}: vtkLoopSubdivisionFilter {vtk:.3f} s, vtkSurfaceSubdivision {ours:.3f} s, "
              f"{vtk / ours:.1f} times as fast")


main()
