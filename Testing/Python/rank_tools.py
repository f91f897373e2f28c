# SPDX-License-Identifier: BSD-3-Clause
"""What the tests on several ranks share: importing this starts MPI, in python3 as in pvbatch.

The name `simple` is that of paraview.simple, and None without ParaView.
"""

import ctypes
import ctypes.util
import os
import sys
import traceback

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkObject, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

SKIPPED = 77
NUMBER = "NumberOfCell"  # the cell array by which cells of parts and of the whole are compared


def start_mpi():
    """The controller, in python3, which pvbatch has by itself."""
    try:
        from vtkmodules.vtkParallelMPI import vtkMPIController
    except ImportError:
        print("skipped: this VTK has no MPI")
        sys.exit(SKIPPED)
    library = ctypes.util.find_library("mpi")
    ctypes.CDLL(library or "libmpi.so", ctypes.RTLD_GLOBAL).MPI_Init(None, None)
    made = vtkMPIController()
    made.Initialize()
    vtkMultiProcessController.SetGlobalController(made)
    return made


if "SUBDIVISIONOBJECTS_PLUGIN" in os.environ:
    import tools  # loads the plugin

    simple = tools.simple
    controller = vtkMultiProcessController.GetGlobalController()
else:
    simple = None
    controller = start_mpi()
vtkObject.GlobalWarningDisplayOff()  # each rank would warn of the same cells
RANK, RANKS = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def own_cells(proxy):
    """The output of a proxy on this rank without the layer of ghost cells for which ParaView asks."""
    own = simple.RemoveGhostInformation(Input=proxy)
    own.UpdatePipeline()
    given = own.GetClientSideObject().GetOutputDataObject(0)
    output = given.NewInstance()
    output.ShallowCopy(given)
    simple.Delete(own)
    return output


def totals(values):
    """The sum of each value over all ranks."""
    ours, sums = (numpy_to_vtk(np.array(values, dtype=float), deep=1) for _ in range(2))
    controller.AllReduce(ours, sums, vtkCommunicator.SUM_OP)
    return vtk_to_numpy(sums).astype(int)


def cells_of(mesh):
    """Types, corners and offsets; of poly data, of polygons only."""
    array = mesh.GetPolys() if mesh.IsA("vtkPolyData") else mesh.GetCells()
    offsets = vtk_to_numpy(array.GetOffsetsArray()).astype(np.int64)
    corners = vtk_to_numpy(array.GetConnectivityArray()).astype(np.int64)
    types = None if mesh.IsA("vtkPolyData") else vtk_to_numpy(mesh.GetCellTypesArray())
    return types, corners, offsets


def corners_of(corners, offsets, cells):
    """The corners of some cells, in a row, and how many each has."""
    sizes = np.diff(offsets)[cells]
    begins = np.repeat(offsets[:-1][cells] - np.concatenate(([0], np.cumsum(sizes)[:-1])), sizes)
    return corners[begins + np.arange(sizes.sum())], sizes


def named(data):
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in arrays if array}


def add(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    data.AddArray(array)
    return array


def ids(name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=np.int64), deep=1, array_type=VTK_ID_TYPE)
    array.SetName(name)
    return array


def take(mesh, cells, points=None, with_ids=False):
    """Some cells of a mesh with the points that they use, in the order of `points`, else of the mesh."""
    cells = np.asarray(cells, dtype=np.int64)
    types, corners, offsets = cells_of(mesh)
    used, sizes = corners_of(corners, offsets, cells)
    points = np.unique(used) if points is None else points
    places = np.full(mesh.GetNumberOfPoints(), -1, dtype=np.int64)
    places[points] = np.arange(len(points))
    array = vtkCellArray()
    array.SetData(ids("", np.concatenate(([0], np.cumsum(sizes)))), ids("", places[used]))
    part = mesh.NewInstance()
    part.SetPoints(vtkPoints())
    coordinates = vtk_to_numpy(mesh.GetPoints().GetData())[points]
    part.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(coordinates), deep=1))
    if types is None:
        part.SetPolys(array)
    elif len(cells):
        part.SetCells(numpy_to_vtk(np.ascontiguousarray(types[cells]), deep=1), array)
    for get, chosen in (("GetPointData", points), ("GetCellData", cells)):
        for name, values in named(getattr(mesh, get)()).items():
            add(getattr(part, get)(), name, values[chosen])
    if with_ids:
        part.GetPointData().SetGlobalIds(ids("PointIds", points))
        part.GetCellData().SetGlobalIds(ids("CellIds", cells))
    return part


def numbered(mesh):
    """A copy without unused points, whose cells have numbers, and its points values."""
    copy = mesh.NewInstance()
    copy.DeepCopy(mesh)
    for data in (copy.GetPointData(), copy.GetCellData()):
        for i in reversed(range(data.GetNumberOfArrays())):
            if not data.GetArray(i):
                data.RemoveArray(i)  # texts
    number = cells_of(copy)[2].size - 1
    if copy.GetNumberOfCells() != number:  # vertices and lines of poly data, whose arrays count them too
        copy.GetCellData().Initialize()
    chance = np.random.RandomState(3)
    add(copy.GetCellData(), NUMBER, np.arange(number, dtype=np.int32))
    add(copy.GetPointData(), "Values", chance.rand(copy.GetNumberOfPoints(), 2))
    return take(copy, np.arange(number))


def in_slabs(mesh, parts):
    """For each cell its part: slabs along x, of equal numbers of cells."""
    _, corners, offsets = cells_of(mesh)
    x = vtk_to_numpy(mesh.GetPoints().GetData())[:, 0][corners]
    order = np.argsort(np.add.reduceat(x, offsets[:-1]) / np.diff(offsets), kind="stable")
    part = np.empty(len(order), dtype=int)
    part[order] = np.arange(len(order)) * parts // len(order)
    return part


def by_chance(mesh, parts):
    return np.random.RandomState(11).randint(0, parts, cells_of(mesh)[2].size - 1)


def on_last_rank(mesh, parts):
    return np.full(cells_of(mesh)[2].size - 1, parts - 1)


def as_it_comes(mesh, part_of, parts):
    """The mesh with cells and points in the order in which the parts, one after the other, have them."""
    _, corners, offsets = cells_of(mesh)
    cells = np.argsort(part_of, kind="stable")
    order = []
    for part in range(parts):
        order.append(np.unique(corners_of(corners, offsets, np.nonzero(part_of == part)[0])[0]))
    points = np.concatenate(order)
    _, first = np.unique(points, return_index=True)
    return take(mesh, cells, points[np.sort(first)])


def differences(whole, part):
    """What cells of `part` do not have as `whole` has it, bit for bit."""
    found = []
    ours, theirs = (named(mesh.GetCellData()) for mesh in (whole, part))
    names = [{*named(mesh.GetPointData()), *named(mesh.GetCellData())} - {"PointIds", "CellIds"}
             for mesh in (whole, part)]
    if NUMBER not in theirs:
        return [] if part.GetNumberOfCells() == 0 else ["no numbers of cells"]
    if names[0] != names[1]:
        found.append(f"arrays: {sorted(names[0])} and {sorted(names[1])}")
    own = np.nonzero(np.isin(ours[NUMBER], theirs[NUMBER]))[0]
    own = own[np.argsort(ours[NUMBER][own], kind="stable")]
    cells = np.argsort(theirs[NUMBER], kind="stable")
    if len(own) != len(cells):
        return found + [f"{len(cells)} cells instead of {len(own)}"]
    corners = []
    for mesh, chosen in ((whole, own), (part, cells)):
        types, all_corners, offsets = cells_of(mesh)
        of_chosen, sizes = corners_of(all_corners, offsets, chosen)
        corners.append(of_chosen)
        kinds = sizes if types is None else types[chosen]
        found += ["types of cells"] if mesh is part and not np.array_equal(kinds, first) else []
        first = kinds
    if found or len(corners[0]) != len(corners[1]):
        return found + ["corners"]
    pairs = np.unique(np.stack(corners, axis=1), axis=0)
    if len(pairs) != len(np.unique(pairs[:, 0])) or len(pairs) != len(np.unique(pairs[:, 1])):
        found.append("cells share other points")
    values = [dict(named(mesh.GetPointData()), coordinates=vtk_to_numpy(mesh.GetPoints().GetData()))
              for mesh in (whole, part)]
    for name in values[0]:
        if name in values[1] and values[0][name][pairs[:, 0]].tobytes() != values[1][name][pairs[:, 1]].tobytes():
            found.append(name)
    counted = {"OctahedronId", "GreenParent", "vtkOriginalCellIds"}  # count in the part
    return found + [name for name in ours if name in theirs and name not in counted
                    and ours[name][own].tobytes() != theirs[name][cells].tobytes()]


def main(run):
    """Runs a test on all ranks. The others end too where one fails, because mpirun ends them."""
    try:
        failures = run()
    except BaseException:  # else the others would wait
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)
    for failure in failures:
        print(f"rank {RANK} of {RANKS}: {failure}", flush=True)
    failed = totals([len(failures)])[0]
    if RANK == 0 and not failed:
        print(f"{RANKS} ranks agree", flush=True)
    controller.Barrier()
    if simple is None:
        controller.Finalize()
    sys.stdout.flush()
    os._exit(1 if failed else 0)
