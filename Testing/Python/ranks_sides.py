# SPDX-License-Identifier: BSD-3-Clause
"""JoinSides on several ranks: an object that is closed on its rank is joined there, and of others a warning tells."""

import numpy as np
import rank_tools as ranks
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkObject, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import subdivisionobjects

SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
CORNERS = np.array([[x, y, z] for z in (0.0, 1) for y in (0, 1) for x in (0, 1)])


def sides_of_box(chosen, at=0.0):
    """Some sides of a box, each with points of its own."""
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    points = CORNERS[[corner for side in chosen for corner in SIDES[side]]].reshape(-1, 3) + [at, 0, 0]
    mesh.GetPoints().SetData(numpy_to_vtk(points, deep=1))
    polys = vtkCellArray()
    for side in range(len(chosen)):
        polys.InsertNextCell(4, range(4 * side, 4 * side + 4))
    mesh.SetPolys(polys)
    return mesh


def run_on(mesh, name):
    """The points of all ranks, and whether rank 0 tells of sides."""
    made = getattr(subdivisionobjects, name)()
    told = []

    def note(_, __, text):
        # The plugin says "Join Sides", so the test does not read the name of the option.
        told.append("sides of a surface meet that are not closed on their rank" in text)

    note.CallDataType = "string0"
    made.AddObserver("WarningEvent", note)
    made.SetNumberOfLevels(0)
    made.SetInputData(mesh)
    made.Update()
    return list(ranks.totals([made.GetOutput().GetNumberOfPoints(), sum(told)]))


def run():
    failures = []
    vtkObject.GlobalWarningDisplayOn()  # else nothing is said at all
    for name in ("vtkMultiDimensionalSubdivision", "vtkSurfaceSubdivision"):
        whole = run_on(sides_of_box(range(6), 3.0 * ranks.RANK), name)
        if whole != [8 * ranks.RANKS, 0]:
            failures.append(f"{name}: boxes on their ranks have the points, and warnings: {whole}")
        points, told = run_on(sides_of_box(range(ranks.RANK, 6, ranks.RANKS)), name)
        if ranks.RANKS < 5 and [points, told] != ([8, 0] if ranks.RANKS == 1 else [24, 1]):
            failures.append(f"{name}: a box on all ranks has {points} points, and {told} warnings")
    return failures


ranks.main(run)
