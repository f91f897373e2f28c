# SPDX-License-Identifier: BSD-3-Clause
"""How long filters work on after somebody stopped them.

    abort_latency.py OUTPUT.json [RUNS]
    abort_latency.py --gaps [PART...]

Each filter runs twice to its end, then RUNS times (4), stopped at times that are spread over the
faster of these runs.
A user's click is seen at the next report of progress, as in ParaView, so that the time from the click to the
return of Update has the wait for this report in it. Written: median and longest time of each filter, in ms.

With --gaps, by hand: the longest time between two reports of each case whose name has one of the parts, also of each
scheme, criterion and kind of output; of the wall clock and of all threads together. On a machine that other programs
use, too, the work took at most the smaller one. Fails where that is above 0.2 s.
"""
import json
import statistics
import sys
import time

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonCore import VTK_INT

from subdivisionobjects import (
    vtkAdaptiveSurfaceSubdivision, vtkMultiDimensionalSubdivision, vtkRedGreenRefinement, vtkSimplicialComplexTopology,
    vtkSubdivisionDeformation, vtkSubdivisionLabelSolid, vtkSubdivisionLimitProbe, vtkSubdivisionMeasures,
    vtkSubdivisionModelSource, vtkSubdivisionSampler, vtkSubdivisionSmoothness, vtkSurfaceSubdivision)


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

    def sampler():
        made = vtkSubdivisionSampler()
        made.SetNumberOfSamples(300)
        made.GenerateCoverageOn()
        made.GenerateDistanceOn()
        return made, [subdivided(0)]

    return {
        "Sample Smooth Object": sampler,
        "Measure Smooth Object": lambda: (vtkSubdivisionMeasures(), [solids]),
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


def list_kinds():
    """Each scheme, criterion and kind of output, with inputs that are made once."""
    solids, surface = subdivided(1), subdivided(1, True)

    def case(class_, mesh, **options):
        def make():
            made = class_()
            for name, value in options.items():
                getattr(made, "Set" + name)(*value if isinstance(value, tuple) else (value,))
            return made, [mesh]
        return make

    main, red_green = vtkMultiDimensionalSubdivision, vtkRedGreenRefinement
    by_length = {"RefineByAttributeError": 0, "RefineByEdgeLength": 1, "MaximumEdgeLength": solids.GetLength() / 60.}
    cases = {"main, " + name: case(main, solids, **options) for name, options in {
        "no cache": {"NumberOfLevels": 2, "CacheOperator": 0},
        "interpolation": {"NumberOfLevels": 2, "InterpolatePoints": 1, "InterpolateArrays": 1},
        "Bezier cells": {"NumberOfLevels": 1, "OutputCellsToBezier": ()},
        "error bounds": {"NumberOfLevels": 0, "GenerateErrorBounds": 1},
        "interfaces": {"NumberOfLevels": 2, "PreserveInterfaces": 1},
        "values that jump": {"NumberOfLevels": 2, "PreserveInterfaces": 1, "InterfaceValuesToDiscontinuous": ()},
        "features": {"NumberOfLevels": 2, "DetectFeatures": 1},
        "all arrays": {"NumberOfLevels": 2, "GenerateClassification": 1, "GenerateOriginalIds": 1, "GenerateGlobalIds": 1},
        "types": {"NumberOfLevels": 2, "VolumeScheme": 2, "KeepCellTypes": 1},
    }.items()}
    for scheme in range(3):
        for limit in 0, 1:
            cases["main, scheme %d%s" % (scheme, ", limits, normals" * limit)] = case(
                main, solids, VolumeScheme=scheme, NumberOfLevels=2, ProjectToLimit=limit, GenerateLimitNormals=limit)
        if scheme < 2:
            cases["smoothness, scheme %d" % scheme] = case(vtkSubdivisionSmoothness, solids, Scheme=scheme)
            cases["red-green on the limit, scheme %d" % scheme] = case(
                red_green, solids, VolumeScheme=scheme, Placement=1, GenerateLimitNormals=1, **by_length)
    for scheme in range(vtkSurfaceSubdivision.LINEAR + 1):
        limit = int(scheme not in (vtkSurfaceSubdivision.MODIFIED_BUTTERFLY, vtkSurfaceSubdivision.LINEAR))
        cases["surface, scheme %d" % scheme] = case(vtkSurfaceSubdivision, surface, Scheme=scheme, NumberOfLevels=4)
        cases["surface, scheme %d, limits, normals, tangents, interpolation" % scheme] = case(
            vtkSurfaceSubdivision, surface, Scheme=scheme, NumberOfLevels=4, ProjectToLimit=limit, GenerateLimitNormals=1,
            GenerateTangents=1, InterpolatePoints=limit, GenerateOriginalIds=1)
    for name, options in {
            "limit difference": {"AttributeErrorKindToLimitDifference": (), "AttributeTolerance": 1e-4},
            "geometric error": {"RefineByAttributeError": 0, "RefineByGeometricError": 1, "GeometricTolerance": 1e-5},
            "curvature": {"RefineByAttributeError": 0, "RefineByCurvature": 1, "MaximumAngle": 1.}}.items():
        cases["red-green, " + name] = case(red_green, solids, MaximumLevel=2, **options)
        cases["adaptive, " + name] = case(vtkAdaptiveSurfaceSubdivision, surface, MaximumLevel=4, **options)
    return cases


def report_gaps(parts):
    """Prints the longest time between two reports of each case; returns how many are above 0.2 s."""
    too_long = 0
    for name, make in {**list_cases(), **list_kinds()}.items():
        if parts and not any(part in name for part in parts):
            continue
        filter_, inputs = make()
        for port, data in enumerate(inputs):
            filter_.SetInputDataObject(port, data)
        moments = [(time.perf_counter(), time.process_time(), 0.)]

        def see(caller, _event, moments=moments):
            moments.append((time.perf_counter(), time.process_time(), caller.GetProgress()))

        filter_.AddObserver("ProgressEvent", see)
        filter_.Update()
        see(filter_, None)
        gaps = [(min(b[0] - a[0], b[1] - a[1]), b[0] - a[0], b[1] - a[1], b[2]) for a, b in zip(moments, moments[1:])]
        least, wall, work, progress = max(gaps)
        print("%-60s %4d reports, longest gap %.2f s (%.2f of work) at %.2f" % (name, len(gaps), wall, work, progress),
              flush=True)
        too_long += least > 0.2
    return too_long


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
    if sys.argv[1] == "--gaps":
        sys.exit(report_gaps(sys.argv[2:]) > 0)
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
