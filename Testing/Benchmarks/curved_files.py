#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Curved cells of all models, and of all meshes in a folder, on levels 0 to 3: how many are valid, and how far nodes moved.

usage: PYTHONPATH=... curved_files.py [FOLDER] [MOST]    (MOST: cells that an output may have, 1,000,000)

Where a level would have more cells than MOST, its mesh is the first cells that hang together. The table is Markdown; 'inside out' counts cells
that are so even with straight edges, whose first one an error names. The exit status is 1 where a cell is not valid and no error says so.
"""

import pathlib
import re
import sys
import time

import numpy as np
import vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import subdivisionobjects as so

LEVELS = range(4)
MOST = 1_000_000
REPAIRED = re.compile(r"(\d+) of \d+ curved solids were not valid.* by ([-+.e\d]+) at most")
HOPELESS = re.compile(r"(\d+) of \d+ curved solids are inside out.*the first is (cell \d+)")


def models():
    for number in range(so.vtkSubdivisionModelSource.CYLINDER + 1):
        source = so.vtkSubdivisionModelSource()
        source.SetModel(number)
        source.Update()
        yield f"model {number}", source.GetOutput()


def files(folder):
    for path in sorted(folder.glob("*.vt[pu]")):
        reader = vtk.vtkXMLPolyDataReader() if path.suffix == ".vtp" else vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        yield path.stem, reader.GetOutput()


def first_cells(mesh, count):
    """That many cells around the first one: layer after layer those that share points, then the next piece."""
    if mesh.GetNumberOfCells() <= count:
        return mesh
    points = vtk.vtkIdList()
    sizes, ids = [], []
    for cell in range(mesh.GetNumberOfCells()):
        mesh.GetCellPoints(cell, points)
        sizes.append(points.GetNumberOfIds())
        ids.extend(points.GetId(i) for i in range(sizes[-1]))
    owner, ids = np.repeat(np.arange(len(sizes)), sizes), np.array(ids)
    wrong = (ids < 0) | (ids >= mesh.GetNumberOfPoints())  # in a file made to be hostile
    is_wrong = np.isin(np.arange(len(sizes)), owner[wrong])
    owner, ids = owner[~is_wrong[owner]], ids[~is_wrong[owner]]
    taken, seen = np.zeros(len(sizes), bool), np.zeros(mesh.GetNumberOfPoints(), bool)
    while taken.sum() < min(count, (~is_wrong).sum()):
        near = np.unique(owner[seen[ids]])
        new = near[~taken[near]]
        new = (new if len(new) else np.nonzero(~(taken | is_wrong))[0][:1])[:count - taken.sum()]
        taken[new] = True
        seen[ids[np.isin(owner, new)]] = True
    cut = vtk.vtkExtractCells()
    cut.SetInputData(mesh)
    chosen = vtk.vtkIdList()
    for cell in np.nonzero(taken)[0]:
        chosen.InsertNextId(int(cell))
    cut.SetCellList(chosen)
    cut.Update()
    return cut.GetOutput()


def curve(mesh, levels):
    """The cells, what was told, and the seconds."""
    told = []
    made = so.vtkMultiDimensionalSubdivision()

    def keep(_, __, text):
        told.append(text)
    keep.CallDataType = vtk.VTK_STRING
    for event in ("WarningEvent", "ErrorEvent"):
        made.AddObserver(event, keep)
    made.SetInputDataObject(mesh)
    made.SetNumberOfLevels(levels)
    made.SetOutputCellsToQuadratic()
    vtk.vtkObject.GlobalWarningDisplayOn()  # else nothing is told
    start = time.perf_counter()
    made.Update()
    vtk.vtkObject.GlobalWarningDisplayOff()
    return made.GetOutput(), told, time.perf_counter() - start


def count_cells(grid, levels):
    """How many cells that many further levels would have."""
    if not grid.GetNumberOfCells():
        return 0
    types, counts = np.unique(vtk_to_numpy(grid.GetCellTypesArray()), return_counts=True)
    dimensions = [{vtk.VTK_VERTEX: 0, vtk.VTK_QUADRATIC_EDGE: 1, vtk.VTK_QUADRATIC_TRIANGLE: 2}.get(int(t), 3) for t in types]
    return sum(int(c) * 2 ** (d * levels) for c, d in zip(counts, dimensions))


def rows(name, mesh, most):
    """The rows of a mesh, and whether each cell is valid or told to be inside out."""
    places = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float) if mesh.GetNumberOfPoints() else np.zeros((1, 3))
    size = np.linalg.norm(np.ptp(places[np.isfinite(places).all(axis=1)], axis=0))
    part, grid = mesh, None
    for level in LEVELS:
        while level and count_cells(grid, level) > most and part.GetNumberOfCells() > 1:
            part = first_cells(part, max(1, int(0.9 * part.GetNumberOfCells() * most / count_cells(grid, level))))
            grid = curve(part, 0)[0]
        made, told, seconds = curve(part, level)
        grid = made if level == 0 else grid
        text = " ".join(told)
        repaired, hopeless = REPAIRED.search(text), HOPELESS.search(text)
        valid = made.GetCellData().GetArray("Valid")
        invalid = int((vtk_to_numpy(valid) == 0).sum()) if valid else 0
        other = next((t.split("): ")[-1].strip() for t in told if "ERROR" in t and not HOPELESS.search(t)), "")
        moved = f"{float(repaired[2]) / size:.1e}" if repaired else ""
        yield (f"| {name} | {level} | {part.GetNumberOfCells()} of {mesh.GetNumberOfCells()} | {made.GetNumberOfCells()} | "
               f"{repaired[1] if repaired else 0} | {moved} | {f'{hopeless[1]}, {hopeless[2]}' if hopeless else 0} | {seconds:.2f} |",
               invalid == (int(hopeless[1]) if hopeless else 0), other)


def main():
    vtk.vtkObject.GlobalWarningDisplayOff()
    vtk.vtkLogger.SetStderrVerbosity(vtk.vtkLogger.VERBOSITY_OFF)
    most = int(sys.argv[2]) if len(sys.argv) > 2 else MOST
    print("| mesh | level | input cells | cells | repaired | largest move, of the size | inside out | seconds |\n"
          "|---|---|---|---|---|---|---|---|")
    missed = []
    for name, mesh in [*models()] if len(sys.argv) < 2 else (item for items in (models(), files(pathlib.Path(sys.argv[1]))) for item in items):
        for row, is_right, other in rows(name, mesh, most):
            print(row + (f" {other}" if other else ""), flush=True)
            missed += [] if is_right else [row]
    if missed:
        sys.exit("Cells that are not valid, and no error says so:\n" + "\n".join(missed))


main()
