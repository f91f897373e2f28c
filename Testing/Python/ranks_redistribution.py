# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/Ranks.md: a file that one rank reads is spread before it is subdivided, and once more after."""

import os
import sys

import rank_tools as ranks
from vtkmodules.util.numpy_support import vtk_to_numpy

import subdivisionobjects

if not ranks.simple:
    print("skipped: only ParaView has the filter that spreads a mesh")
    sys.stdout.flush()
    os._exit(0)


def distinct(grid):
    if not grid.GetNumberOfPoints():
        return set()
    return {point.tobytes() for point in vtk_to_numpy(grid.GetPoints().GetData()) + 0.}


def run():
    file_name = os.path.join(os.environ["SUBDIVISIONOBJECTS_DATA"], "SpringAndValve.vtu")
    mesh = ranks.simple.XMLUnstructuredGridReader(FileName=[file_name], TimeArray="None")
    # ParaView 6 has another name for it.
    known_ids = getattr(ranks.simple, "GlobalPointAndCellIds", None) or ranks.simple.GenerateGlobalIds
    spread = ranks.simple.RedistributeDataSet(Input=known_ids(Input=mesh))
    spread.UpdatePipeline()
    mesh.UpdatePipeline()
    read, kept = ranks.totals([proxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
                               for proxy in (mesh, spread)])
    if kept < read:  # it sends cells as files with appended data, which ParaView 5.11 with a newer Expat cannot read
        print(f"skipped: RedistributeDataSet of this ParaView loses {read - kept} of {read} cells", flush=True)
        return []
    smooth = ranks.simple.MultidimensionalSubdivision(Input=spread, NumberOfLevels=2)
    even = ranks.simple.RedistributeDataSet(Input=smooth)
    even.UpdatePipeline()
    source = subdivisionobjects.vtkSubdivisionModelSource()
    source.SetModelToSpringAndValve()
    source.Update()
    whole = subdivisionobjects.vtkMultiDimensionalSubdivision()
    whole.SetController(None)
    whole.SetInputConnection(source.GetOutputPort())
    whole.SetNumberOfLevels(2)
    whole.Update()
    expected = whole.GetOutput()
    known = distinct(expected)
    failures = []
    for proxy in (smooth, even):
        grid = ranks.own_cells(proxy)
        cells, others = ranks.totals([grid.GetNumberOfCells(), len(distinct(grid) - known)])
        if cells != expected.GetNumberOfCells():
            failures.append(f"{cells} cells instead of {expected.GetNumberOfCells()}")
        if others:
            failures.append(f"{others} points that the whole does not have")
    return failures


ranks.main(run)
