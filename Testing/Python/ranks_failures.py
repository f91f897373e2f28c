# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong on one rank ends the filter on all: one message, by rank 0, and nobody waits."""

import numpy as np
import rank_tools as ranks
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

import subdivisionobjects


class Messages:
    """What a filter on this rank says."""

    def __init__(self, made):
        self.texts = []
        for event in ("ErrorEvent", "WarningEvent"):
            made.AddObserver(event, self.add)
        self.add.__func__.CallDataType = "string0"

    def add(self, _, __, text="?"):
        self.texts.append(text)


def run_on(mesh, stops=False, **options):
    """The cells of all ranks, and the messages of all. `stops`: the user stops this rank."""
    made = subdivisionobjects.vtkMultiDimensionalSubdivision()
    messages = Messages(made)
    made.SetNumberOfLevels(1)
    if stops:
        made.AddObserver("ProgressEvent", lambda *_: made.SetAbortExecute(1))
    for key, value in options.items():
        getattr(made, "Set" + key)(value)
    made.SetInputData(mesh)
    made.Update()
    said = [int(ranks.RANK == 0) * len(messages.texts), int(ranks.RANK > 0) * len(messages.texts)]
    return ranks.totals([made.GetOutput().GetNumberOfCells()] + said)


def values_of(grid):
    """All values of the output on this rank."""
    arrays = [grid.GetPoints().GetData(), grid.GetCells().GetConnectivityArray()]
    for data in (grid.GetPointData(), grid.GetCellData()):
        arrays += [data.GetArray(a) for a in range(data.GetNumberOfArrays())]
    return [(array.GetName(), array.GetDataType(), vtk_to_numpy(array).tobytes()) for array in arrays]


def check_change(failures, what, part, change):
    """A filter that knows the parts of before gives what a new one gives when one rank has changed its part."""
    changed = part.NewInstance()
    changed.DeepCopy(part)
    if ranks.RANK == ranks.RANKS - 1:
        change(changed)
    made = [subdivisionobjects.vtkMultiDimensionalSubdivision() for _ in range(2)]
    made[0].SetInputData(part)
    made[0].Update()
    for each in made:
        each.SetInputData(changed)
        each.Update()
    outputs = [each.GetOutput() for each in made]
    if values_of(outputs[0]) != values_of(outputs[1]) or not ranks.totals([outputs[0].GetNumberOfCells()])[0]:
        failures.append(f"{what}: another output than that of a new filter")
    if part.GetCellData().HasArray("MaterialId") != outputs[0].GetCellData().HasArray("MaterialId"):
        failures.append(f"{what}: MaterialId is lost")


def move_points(mesh):
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    points += 0.1 * points[:, ::-1]
    mesh.GetPoints().Modified()


def change_cell(mesh):
    """Gives the first cell a corner of another one."""
    corners = vtk_to_numpy(mesh.GetCells().GetConnectivityArray())
    own = set(corners[:mesh.GetCells().GetCellSize(0)])
    corners[0] = next(corner for corner in corners if corner not in own)
    mesh.GetCells().Modified()


def change_type(mesh):
    values = numpy_to_vtk(vtk_to_numpy(mesh.GetCellData().GetArray("MaterialId")).astype(np.float32), deep=1)
    values.SetName("MaterialId")
    mesh.GetCellData().AddArray(values)


def run():
    source = subdivisionobjects.vtkSubdivisionModelSource()
    source.SetModelToMaterialBlock()
    source.Update()
    mesh = ranks.numbered(source.GetOutput())
    part_of = ranks.by_chance(mesh, ranks.RANKS)
    part = ranks.take(mesh, np.nonzero(part_of == ranks.RANK)[0], with_ids=True)
    last = ranks.RANK == ranks.RANKS - 1
    vtkObject.GlobalWarningDisplayOn()  # else nothing is said at all
    failures = []

    def expect(what, found, cells, messages_of_first=0):
        wanted = [cells, messages_of_first, 0]
        if list(found) != wanted:
            failures.append(f"{what}: cells, messages of rank 0, of others: {list(found)} instead of {wanted}")

    whole = run_on(part)[0]
    if not whole:
        failures.append("no cells at all")
    expect("all cells on the last rank", run_on(ranks.take(mesh, np.arange(mesh.GetNumberOfCells()), with_ids=True)
                                                if last else vtkUnstructuredGrid()), whole, int(ranks.RANKS > 3))
    expect("no cells on any rank", run_on(vtkPolyData()), 0)
    expect("too many cells on the last rank", run_on(part, MaximumNumberOfCells=1 if last else 10 ** 8), 0, 1)
    expect("the user stops the last rank", run_on(part, stops=last), 0)
    check_change(failures, "points moved on the last rank", part, move_points)
    check_change(failures, "a cell changed on the last rank", part, change_cell)
    check_change(failures, "an array of another type on the last rank", part, change_type)
    if ranks.RANKS > 1 and not last:
        part.GetCellData().RemoveArray("MaterialId")
    expect("an array that only the last rank has", run_on(part, PreserveInterfaces=True), whole)
    return failures


ranks.main(run)
