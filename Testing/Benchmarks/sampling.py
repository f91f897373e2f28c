# SPDX-License-Identifier: BSD-3-Clause
"""The smooth object on an image, by vtkSubdivisionSampler and by VTK: seconds at the same error.

    python3 Testing/Benchmarks/sampling.py [SAMPLES ...]

VTK takes a level of vtkMultiDimensionalSubdivision, its points on the limit, and vtkResampleToImage (vtkProbeFilter
with a cell locator): the first level whose error is not larger. Errors are those of an array in parts of its range, as
root of the mean square, against vtkSubdivisionLimitProbe at 2,000 samples in the object. Each time is the median of
three, subdivision included; the threads are those that VTK takes.
"""

import statistics
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkResampleToImage

import subdivisionobjects

ARRAY = "Tension"
RUNS = 3


def seconds(run):
    times = []
    for _ in range(RUNS):
        begin = time.perf_counter()
        result = run()
        times.append(time.perf_counter() - begin)
    return statistics.median(times), result


def take(image, name):
    return vtk_to_numpy(image.GetPointData().GetArray(name))


def exact(mesh, places):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    probe = subdivisionobjects.vtkSubdivisionLimitProbe()
    probe.SetInputDataObject(mesh)
    probe.SetInputDataObject(3, data)
    probe.Update()
    return take(probe.GetOutput(), ARRAY), take(probe.GetOutput(), "Distance")


def sample(mesh, size):
    sampler = subdivisionobjects.vtkSubdivisionSampler()
    sampler.SetInputDataObject(mesh)
    sampler.SetNumberOfSamples(size)
    sampler.SetOutputDimensions(8)
    sampler.Update()
    return sampler.GetOutput()


def resample(mesh, like, level):
    fine = subdivisionobjects.vtkMultiDimensionalSubdivision()
    fine.SetInputDataObject(mesh)
    fine.SetNumberOfLevels(level)
    fine.ProjectToLimitOn()
    fine.SetOutputDimensions(8)
    made = vtkResampleToImage()
    made.SetInputConnection(fine.GetOutputPort())
    made.SetUseInputBounds(False)
    made.SetSamplingBounds(like.GetBounds())
    made.SetSamplingDimensions(like.GetDimensions())
    made.Update()
    return made.GetOutput()


def error(image, ids, wanted):
    inside = take(image, "vtkValidPointMask")[ids] != 0
    away = (take(image, ARRAY)[ids] - wanted)[inside]
    return float(np.sqrt((away ** 2).mean()) / np.ptp(wanted))


def main(sizes):
    source = subdivisionobjects.vtkSubdivisionModelSource()
    source.SetModelToMechanicalPart()
    source.Update()
    mesh = source.GetOutput()
    print("| samples | ours, s | error | VTK: level | s | error | ratio |")
    print("|---|---|---|---|---|---|---|")
    for size in sizes:
        own, image = seconds(lambda: sample(mesh, size))
        inside = np.nonzero(take(image, "vtkValidPointMask"))[0]
        ids = np.random.default_rng(1).choice(inside, 2000, replace=False)
        wanted, distance = exact(mesh, np.array([image.GetPoint(int(i)) for i in ids]))
        ids, wanted = ids[distance == 0], wanted[distance == 0]
        mistake = error(image, ids, wanted)
        for level in range(1, 7):
            other, theirs = seconds(lambda: resample(mesh, image, level))
            others = error(theirs, ids, wanted)
            if others <= mistake:
                break
        print(f"| {'x'.join(map(str, image.GetDimensions()))} | {own:.3f} | {mistake:.1e} | {level} | {other:.2f} | "
              f"{others:.1e} | {other / own:.0f} |", flush=True)


if __name__ == "__main__":
    main([int(size) for size in sys.argv[1:]] or [64, 128, 256])
