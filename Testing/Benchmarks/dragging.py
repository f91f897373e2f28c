# SPDX-License-Identifier: BSD-3-Clause
"""Frames a second while an edit is dragged: its translation changes, and all filters after it are updated.

    python3 Testing/Benchmarks/dragging.py [CELLS]

Rows: how many cells come out, what a frame takes (median and longest of 20, the first apply left out), its processor time
on all threads, which other programs disturb less, and the first apply. "after a level": the edit stands between two filters
that subdivide. "sheet": it has a border, with corners whose angles the edit changes. The threads are those that VTK takes.
"""

import statistics
import sys
import time

import numpy as np
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkSelection, vtkSelectionNode
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersSources import vtkSphereSource

import subdivisionobjects as so
from subdivisionobjects import meshes

FRAMES = 20


def selection(points):
    """A tenth of the points."""
    ids = vtkIdTypeArray()
    for i in range(max(1, points // 10)):
        ids.InsertNextValue(i)
    node = vtkSelectionNode()
    node.SetContentType(vtkSelectionNode.INDICES)
    node.SetFieldType(vtkSelectionNode.POINT)
    node.SetSelectionList(ids)
    made = vtkSelection()
    made.AddNode(node)
    source = vtkTrivialProducer()
    source.SetOutput(made)
    return source


def solid():
    source = so.vtkSubdivisionCageSource()
    source.SetNumberOfCells(7, 3, 2)
    return source


def surface():
    source = vtkSphereSource()
    source.SetThetaResolution(16)
    source.SetPhiResolution(10)
    return source


def of_quads(points, wraps):
    """A lattice of 8 by 8 quads, which is closed if it wraps around."""
    size = 8 if wraps else 9
    quads = [[i + size * j, (i + 1) % size + size * j, (i + 1) % size + size * ((j + 1) % size), i + size * ((j + 1) % size)]
             for j in range(8) for i in range(8)]
    at = np.stack(np.meshgrid(*2 * [np.arange(size) * 2 * np.pi / 8]), axis=-1).reshape(-1, 2)
    source = vtkTrivialProducer()
    source.SetOutput(meshes.to_vtk(np.stack(points(*at.T), axis=-1), {"quad": np.array(quads)}, of_surfaces=True))
    return source


def torus():
    return of_quads(lambda u, v: ((3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)), True)


def sheet():
    return of_quads(lambda u, v: (u, v, np.zeros(len(u))), False)


def measure(name, source, make, growth, cells, before=0):
    """`growth`: of the number of cells by a level. `before`: levels before the edit."""
    chain = [source]
    source.Update()
    count = source.GetOutputDataObject(0).GetNumberOfCells()
    if before:
        chain.append(make())
        chain[-1].SetNumberOfLevels(before)
        chain[-1].SetInputConnection(source.GetOutputPort())
        chain[-1].Update()
        count = chain[-1].GetOutputDataObject(0).GetNumberOfCells()
    edit = so.vtkSubdivisionEdit()
    edit.SetInputConnection(0, chain[-1].GetOutputPort())
    picked = selection(chain[-1].GetOutputDataObject(0).GetNumberOfPoints())
    edit.SetSelectionConnection(picked.GetOutputPort())
    levels = 0
    while count < cells:
        levels += 1
        count *= growth
    last = make()
    last.SetNumberOfLevels(levels)
    last.SetInputConnection(edit.GetOutputPort())

    def frame(x):
        begin, used = time.perf_counter(), time.process_time()
        edit.SetTranslation(x, 0, 0.5 * x)
        last.Update()
        return time.perf_counter() - begin, time.process_time() - used

    size = source.GetOutputDataObject(0).GetLength()
    first, _ = frame(0.001 * size)
    frame(0.002 * size)
    times, used = zip(*(frame((0.003 + 0.001 * i) * size) for i in range(FRAMES)))
    out = last.GetOutputDataObject(0).GetNumberOfCells()
    middle = statistics.median(times)
    print(f"| {name} | {out:,} | {1000 * middle:.0f} ms | {1000 * max(times):.0f} ms | {1000 * statistics.median(used):.0f} ms "
          f"| {1 / middle:.1f} | {first:.2f} s |", flush=True)


def main():
    cells = int(sys.argv[1]) if len(sys.argv) > 1 else 10**6
    print("| output | cells | frame | longest | processor | frames a second | first apply |\n"
          "|---|---|---|---|---|---|---|")
    for before in (0, 1):
        where = " after a level" if before else ""
        measure("tetrahedra" + where, solid(), so.vtkMultiDimensionalSubdivision, 8, cells, before)

        def triangles():
            made = so.vtkSurfaceSubdivision()
            made.SetSchemeToLoop()
            return made

        measure("triangles" + where, surface(), triangles, 4, cells, before)

        def quads():
            made = so.vtkSurfaceSubdivision()
            made.SetSchemeToCatmullClark()
            return made

        measure("quads" + where, torus(), quads, 4, cells, before)
        measure("quads of a sheet" + where, sheet(), quads, 4, cells, before)


main()
