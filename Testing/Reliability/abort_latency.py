# SPDX-License-Identifier: BSD-3-Clause
"""How long filters work on after somebody stopped them.

    abort_latency.py OUTPUT.json [RUNS]

Each filter runs twice to its end, then RUNS times (4), stopped at times that are spread over the
faster of these runs.
A user's click is seen at the next report of progress, as in ParaView, so that the time from the click to the
return of Update has the wait for this report in it. Written: median and longest time of each filter, in ms.
"""
import json
import statistics
import sys
import time

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonCore import VTK_INT

from subdivisionobjects import (
    vtkAdaptiveSurfaceSubdivision, vtkMultiDimensionalSubdivision, vtkRedGreenRefinement, vtkSimplicialComplexTopology,
    vtkSubdivisionDeformation, vtkSubdivisionLabelSolid, vtkSubdivisionLimitProbe, vtkSubdivisionModelSource,
    vtkSubdivisionSmoothness, vtkSurfaceSubdivision)


def subdivided(levels, surface=False):
    """A model of solids, surfaces and curves, or its surface, as an input that is large enough to take time."""
    source = vtkSubdivisionModelSource()
    source.SetModelToMechanicalPart()
    fine = vtkMultiDimensionalSubdivision()
    fine.SetInputConnection(source.GetOutputPort())
    fine.SetNumberOfLevels(levels)
    if surface:
        fine.SetOutputDimensions(vtkMultiDimensionalSubdivision.TRIANGLES)
    fine.Update()
    mesh = fine.GetOutput().NewInstance()
    mesh.DeepCopy(fine.GetOutput())
    mesh.GetFieldData().Initialize()  # a mesh like any other
    return mesh


def make_labels():
    image = vtkImageData()
    image.SetDimensions(40, 40, 40)
    image.AllocateScalars(VTK_INT, 1)
    scalars = image.GetPointData().GetScalars()
    scalars.SetName("Label")
    for i in range(scalars.GetNumberOfTuples()):
        x, y, z = i % 40 - 20, i // 40 % 40 - 20, i // 1600 - 20
        scalars.SetValue(i, 1 if x * x + y * y + z * z < 200 else 2 if abs(x) < 18 else 0)
    return image


def list_cases():
    """Filters with their inputs, each of which takes seconds."""
    solids = subdivided(1)
    fine = subdivided(2)
    surface = subdivided(1, True)

    def uniform(levels, configure=lambda made: None):
        made = vtkMultiDimensionalSubdivision()
        made.SetNumberOfLevels(levels)
        configure(made)
        return made

    def limits(made):
        made.ProjectToLimitOn()
        made.GenerateLimitNormalsOn()

    def red_green():
        made = vtkRedGreenRefinement()
        made.RefineByAttributeErrorOff()
        made.RefineByEdgeLengthOn()
        made.SetMaximumEdgeLength(solids.GetLength() / 80.)
        return made, [solids]

    def surfaces():
        made = vtkSurfaceSubdivision()
        made.SetNumberOfLevels(5)
        return made, [surface]

    def adaptive():
        made = vtkAdaptiveSurfaceSubdivision()
        made.RefineByAttributeErrorOff()
        made.RefineByEdgeLengthOn()
        made.SetMaximumEdgeLength(surface.GetLength() / 250.)
        return made, [surface]

    def probe():
        made = vtkSubdivisionLimitProbe()
        made.SetInputDataObject(3, surface)
        return made, [surface]

    return {
        "Multi-dimensional Subdivision": lambda: (uniform(3), [fine]),
        "the same with limits and normals": lambda: (uniform(2, limits), [fine]),
        "the same with Bezier cells": lambda: (uniform(1, lambda made: made.SetOutputCellsToBezier()), [solids]),
        "the same with error bounds": lambda: (uniform(0, lambda made: made.GenerateErrorBoundsOn()), [solids]),
        "Red-Green Refinement": red_green,
        "Surface Subdivision": surfaces,
        "Adaptive Surface Subdivision": adaptive,
        "Subdivision Deformation": lambda: (vtkSubdivisionDeformation(), [fine, solids, solids]),
        "Subdivision Limit Probe": probe,
        "Simplicial Complex Topology": lambda: (vtkSimplicialComplexTopology(), [subdivided(3)]),
        "Subdivision Smoothness": lambda: (vtkSubdivisionSmoothness(), [solids]),
        "Subdivision Label Solid": lambda: (vtkSubdivisionLabelSolid(), [make_labels()]),
    }


def run(case, stop_after):
    """Runs a filter; returns how long it worked after it should stop, and how long in all."""
    filter_, inputs = case
    for port, data in enumerate(inputs):
        filter_.SetInputDataObject(port, data)
    begin = time.perf_counter()

    def see(caller, _event):
        if time.perf_counter() - begin >= stop_after:
            caller.SetAbortExecute(1)

    filter_.AddObserver("ProgressEvent", see)
    filter_.Update()
    took = time.perf_counter() - begin
    return max(0., took - stop_after), took


def main():
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 4
    figures = {}
    for name, make in list_cases().items():
        whole = min(run(make(), 1e9)[1] for _ in range(2))
        times = []
        for i in range(runs):
            stop_after = whole * (i + 0.5) / runs
            latency, took = run(make(), stop_after)
            if took > stop_after:  # else it was done before
                times.append(1000. * latency)
        if not times:
            sys.exit("%s was always done before it was stopped: take a larger input" % name)
        figures[name] = {"whole": round(1000. * whole, 1), "median": round(statistics.median(times), 1),
                         "worst": round(max(times), 1), "runs": len(times)}
        print(name, figures[name], flush=True)
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        json.dump(figures, file, indent=1)


main()
