# SPDX-License-Identifier: BSD-3-Clause
"""11. Ranks: each process has a part of the mesh, and the parts fit as if one process had it all.

Run it by `mpirun -np 3 python3 11_ranks.py`; alone it is one rank. In ParaView: connect to a pvserver of several ranks.
"""

import ctypes

from picture import picture
from subdivisionobjects import model, vtkMultiDimensionalSubdivision
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkParallelMPI import vtkMPIController

ctypes.CDLL("libmpi.so", ctypes.RTLD_GLOBAL).MPI_Init(None, None)  # mpi4py and pvbatch do it by themselves
controller = vtkMPIController()
controller.Initialize()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()

whole = model(model="MaterialBlock")
part = vtkUnstructuredGrid()
part.SetPoints(whole.GetPoints())
first, end = (whole.GetNumberOfCells() * n // ranks for n in (rank, rank + 1))
for cell in range(first, end):
    part.InsertNextCell(whole.GetCellType(cell), whole.GetCell(cell).GetPointIds())

smooth = vtkMultiDimensionalSubdivision()
smooth.SetController(controller)
smooth.SetInputData(part)
smooth.SetNumberOfLevels(2)
smooth.UpdatePiece(rank, ranks, 0)
print("rank", rank, "of", ranks, "has", smooth.GetOutput().GetNumberOfCells(), "cells")

if rank > 0:
    controller.Send(smooth.GetOutput(), 0, 1)
else:
    parts = [smooth.GetOutput()] + [vtkUnstructuredGrid() for _ in range(1, ranks)]
    for other in range(1, ranks):
        controller.Receive(parts[other], other, 1)
    picture(parts, edges=False)  # the part of rank 0 in grey
controller.Finalize()
