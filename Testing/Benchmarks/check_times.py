#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Times that must stay short on ordinary input, and costs that must stay in proportion.

usage: PYTHONPATH=... check_times.py [NAME]      (the package subdivisionobjects of any build; NAME: a check, such as curved, or words of a row)

Each row is the best of some runs, beside its bar; the exit status is 1 where a bar is missed. ./dev bench --times runs it.
"""

import multiprocessing
import pathlib
import re
import sys
import time

import numpy as np
import vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

import subdivisionobjects as so

MODELS = range(so.vtkSubdivisionModelSource.CYLINDER + 1)


def timed(run, times=3):
    best = float("inf")
    for _ in range(times):
        start = time.perf_counter()
        run()
        best = min(best, time.perf_counter() - start)
    return best


def model(number):
    source = so.vtkSubdivisionModelSource()
    source.SetModel(number)
    source.Update()
    return source.GetOutput()


def points_of(places):
    data = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=1))
    data.SetPoints(points)
    return data


def probe(mesh, places):
    def run():
        made = so.vtkSubdivisionLimitProbe()
        made.SetInputDataObject(0, mesh)
        made.SetInputDataObject(3, points_of(places))
        made.Update()
        assert made.GetOutput().GetNumberOfPoints() == len(places)
    return run


def probes():
    """2 ms a place at any distance, in all models."""
    random = np.random.default_rng(1)
    for number in MODELS:
        mesh = model(number)
        bounds = np.array(mesh.GetBounds()).reshape(3, 2)
        middle, size = bounds.mean(axis=1), np.ptp(bounds, axis=1).max()
        for distance in (0.5, 3.0, 100.0):
            places = middle + distance * size * random.uniform(-1, 1, (1000, 3))
            yield f"probe, model {number}, {distance} sizes away, ms a place", timed(probe(mesh, places), 3), 2.0


def probe_of_many():
    """10^5 places in a minute."""
    mesh = model(1)
    bounds = np.array(mesh.GetBounds()).reshape(3, 2)
    places = np.random.default_rng(2).uniform(bounds[:, 0], bounds[:, 1], (100_000, 3))
    yield "probe of Screw, 100,000 places, s", timed(probe(mesh, places), 1), 60.0


def bezier():
    """Bezier cells cost what is split, not all levels: 466 cells by two levels."""
    mesh = model(so.vtkSubdivisionModelSource.MECHANICAL_PART)

    def run():
        made = so.vtkMultiDimensionalSubdivision()
        made.SetInputData(mesh)
        made.SetNumberOfLevels(2)
        made.SetOutputCellsToBezier()
        made.SetBezierTolerance(1e-4)
        made.Update()
        assert made.GetOutput().GetNumberOfCells() > mesh.GetNumberOfCells()
    yield "Bezier cells of the mechanical part by two levels, s", timed(run, 1), 12.0


def making(levels, cells, order):
    """What makes cells of the mechanical part on the limit, and the points that there are."""
    mesh = model(so.vtkSubdivisionModelSource.MECHANICAL_PART)

    def run():
        made = so.vtkMultiDimensionalSubdivision()
        made.SetInputData(mesh)
        made.SetNumberOfLevels(levels)
        made.SetOutputCells(cells)
        made.SetCellOrder(order)
        made.CacheOperatorOff()
        made.ProjectToLimitOn()
        made.SmoothShadingOff()
        made.Update()
        return made.GetOutput().GetNumberOfPoints()
    return run


def peak_per_node(*case):
    """How many bytes a node the largest memory of a process of its own is beyond what it had before."""
    def memory(name):  # getrusage has the peak of the process that started this one, too
        return int(re.search(rf"{name}:\s+(\d+) kB", pathlib.Path("/proc/self/status").read_text())[1]) * 1024
    run = making(*case)
    before = memory("VmRSS")
    nodes = run()
    return (memory("VmHWM") - before) / nodes


def curved():
    """Curved cells for solvers beside linear cells of the same points on the limit: at most three times, of time and memory."""
    with multiprocessing.get_context("spawn").Pool(1, maxtasksperchild=1) as pool:
        def peak(*case):
            return pool.apply(peak_per_node, case)
        linear, most = timed(making(3, 0, 1), 5), peak(4, 0, 1)
        for name, steps, cells, order in (("Quadratic", 1, 2, 2), ("Lagrange of order 4", 2, 3, 4)):
            words = f"{name} cells, times linear ones of as many points"
            yield words, timed(making(3 - steps, cells, order), 5) / linear, 3.0
            bytes_of_node = peak(4 - steps, cells, order)
            yield f"{words}: memory of a node, {bytes_of_node:,.0f} bytes", bytes_of_node / most, 3.0


def smoothness():
    """10 s at the defaults for 57,000 solids."""
    image = vtk.vtkImageData()
    image.SetDimensions(23, 23, 23)
    cut = vtk.vtkDataSetTriangleFilter()
    cut.SetInputData(image)
    cut.Update()

    def run():
        made = so.vtkSubdivisionSmoothness()
        made.SetInputData(cut.GetOutput())
        made.Update()
    yield f"Smoothness of {cut.GetOutput().GetNumberOfCells():,} solids, s", timed(run, 1), 10.0


def blocks():
    """Time of joining blocks is linear in their number: eight times as many cost eight times as much, or less than twelve."""
    def make(count):
        blocks = vtk.vtkMultiBlockDataSet()
        for i in range(count):
            image = vtk.vtkImageData()
            image.SetDimensions(5, 5, 5)
            image.SetOrigin(4 * i, 0, 0)
            cut = vtk.vtkDataSetTriangleFilter()
            cut.SetInputData(image)
            cut.Update()
            blocks.SetBlock(i, cut.GetOutput())

        def run():
            made = so.vtkMultiDimensionalSubdivision()
            made.SetInputData(blocks)
            made.SetNumberOfLevels(0)
            made.Update()
        return timed(run)
    few, many = make(64), make(512)
    yield "512 blocks joined, times that of 64", many / few, 12.0


def main():
    missed = False
    wanted = sys.argv[1] if len(sys.argv) > 1 else ""
    checks = (probes, probe_of_many, bezier, curved, smoothness, blocks)
    named = [check for check in checks if check.__name__ == wanted]
    for check in named or checks:
        for name, figure, bar in check():
            if named or wanted in name:
                missed = missed or figure > bar
                print(f"{'ok  ' if figure <= bar else 'MISS'} {figure:10.3f} (bar {bar:g}) {name}", flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
