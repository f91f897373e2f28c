# SPDX-License-Identifier: BSD-3-Clause
"""From arrays, lists and meshes of PyVista to data sets of VTK, and back."""

import os
import re
import sys

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.util.vtkConstants import VTK_ID_TYPE
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYGON, vtkCellArray, vtkCompositeDataSet, vtkDataObject, vtkImageData, vtkMultiBlockDataSet, vtkPolyData,
    vtkSelection, vtkSelectionNode, vtkTable, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .run import Arrays

# Type of VTK and number of points.
CELLS = {"vertex": (1, 1), "line": (3, 2), "triangle": (5, 3), "tetra": (10, 4), "quad": (9, 4),
         "hexahedron": (12, 8), "wedge": (13, 6), "pyramid": (14, 5),
         # What output_cells="bezier" makes.
         "bezier_curve": (75, 4), "bezier_triangle": (76, 15), "bezier_quad": (77, 16), "bezier_tetra": (78, 56)}
NAMES = {kind: name for name, (kind, _) in CELLS.items()}
SMALL = {np.dtype(bool): np.uint8, np.dtype(np.float16): np.float32}
# What the rows of a single array are, by their number of points.
BY_SIZE = {1: "vertex", 2: "line", 3: "triangle", 4: "tetra", 5: "pyramid", 6: "wedge", 8: "hexahedron"}


def to_vtk(mesh, cells=None, point_data=None, cell_data=None):
    """A data set of VTK as it is; arrays, a pair (points, cells) or a list of data sets as a data set."""
    if isinstance(mesh, vtkAlgorithm):
        mesh.Update()
        mesh = mesh.GetOutputDataObject(0)
    if isinstance(mesh, vtkDataObject):
        if cells is not None or point_data or cell_data:
            raise TypeError("a data set has cells and arrays of its own")
        return mesh
    if isinstance(mesh, Arrays):
        return from_arrays(*mesh, mesh.point_data, mesh.cell_data)
    if cells is None and isinstance(mesh, tuple) and len(mesh) == 2:
        return from_arrays(*mesh, point_data, cell_data)
    if is_list_of_data_sets(mesh):
        blocks = vtkMultiBlockDataSet()
        for index, one in enumerate(mesh):
            blocks.SetBlock(index, one)
        return blocks
    if isinstance(mesh, (str, os.PathLike)):
        raise TypeError(f"{str(mesh)!r} is the name of a file: read it first, by a reader of vtkmodules.vtkIOXML for "
                        "instance, or take the program subdivide")
    return from_arrays(mesh, cells, point_data, cell_data)


def is_list_of_data_sets(mesh):
    return isinstance(mesh, list) and bool(mesh) and all(isinstance(one, vtkDataObject) for one in mesh)


def to_image(labels, spacing=None, origin=None):
    """A data set of VTK as it is; an array [x, y, z] as an image with these labels at its points."""
    if isinstance(labels, (vtkAlgorithm, vtkDataObject)) or is_list_of_data_sets(labels):
        if spacing is not None or origin is not None:
            raise TypeError("a data set has a spacing and an origin of its own")
        return to_vtk(labels)
    labels = np.asarray(labels)
    if labels.ndim != 3 or 0 in labels.shape or labels.dtype.kind not in "buif":
        raise ValueError("labels must be numbers in an array [x, y, z], not the shape "
                         f"{labels.shape} of {labels.dtype}")
    image = vtkImageData()
    image.SetDimensions(*labels.shape)
    image.SetSpacing(*three_numbers("spacing", spacing, (1, 1, 1)))
    image.SetOrigin(*three_numbers("origin", origin, (0, 0, 0)))
    image.GetPointData().SetScalars(to_array("Label", labels.ravel(order="F"), labels.size))  # VTK: x goes fastest
    return image


def three_numbers(name, values, default):
    values = np.asarray(default if values is None else values)
    if values.shape != (3,) or values.dtype.kind not in "buif" or not np.isfinite(values).all():
        raise ValueError(f"{name} takes 3 finite numbers, along x, y and z, not {values.tolist()!r}")
    if name == "spacing" and values.min() <= 0:
        raise ValueError(f"spacing must be above 0, not {values.tolist()!r}")
    return values.tolist()


def from_arrays(points, cells, point_data=None, cell_data=None):
    points = np.asarray(points)
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ValueError(f"points must have 2 or 3 columns, not the shape {points.shape}")
    if points.dtype != np.float32:
        points = points.astype(np.float64)
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points), points.dtype)])
    coordinates = vtkPoints()
    coordinates.SetData(numpy_support.numpy_to_vtk(np.ascontiguousarray(points), deep=1))
    if cells is None:
        mesh = vtkPolyData()
        mesh.SetPoints(coordinates)
    else:
        mesh = vtkUnstructuredGrid()
        mesh.SetPoints(coordinates)
        set_cells(mesh, cells, len(points))
    for what, count, target in ((point_data, len(points), mesh.GetPointData()),
                                (cell_data, mesh.GetNumberOfCells(), mesh.GetCellData())):
        for name, values in (what or {}).items():
            target.AddArray(to_array(name, values, count))
    return mesh


def set_cells(grid, cells, number_of_points):
    if not hasattr(cells, "items"):
        try:
            rows = np.asarray(cells)
            found = f"the shape {rows.shape}"
        except ValueError:  # of NumPy, whose text is about arrays
            rows, found = np.empty(0), "rows of several sizes"
        if rows.ndim != 2 or rows.shape[1] not in BY_SIZE:
            raise ValueError(f"cells must have a row of 1 to 6 or 8 point ids each, not {found}; for other or several "
                             "types give a dictionary such as {'quad': rows, 'line': rows}")
        cells = {BY_SIZE[rows.shape[1]]: rows}
    types, sizes, ids = [], [], []
    for name, rows in cells.items():
        kind, size = kind_and_size(name)
        rows = np.asarray(rows)
        if rows.ndim != 2 or rows.shape[1] != size or not np.issubdtype(rows.dtype, np.integer):
            raise ValueError(f"{name} must have rows of {size} integers, not the shape {rows.shape} of {rows.dtype}")
        wrong = np.flatnonzero(((rows < 0) | (rows >= number_of_points)).any(axis=1))
        if len(wrong):
            raise ValueError(f"{name} {wrong[0]} has point ids {rows[wrong[0]].tolist()}, but there are "
                             f"{number_of_points} points")
        types.append(np.full(len(rows), kind, np.uint8))
        sizes.append(np.full(len(rows), size))
        ids.append(rows.ravel())
    if not types:
        raise ValueError("there are no cells")
    made = vtkCellArray()
    offsets = np.concatenate([[0], np.cumsum(np.concatenate(sizes))]).astype(np.int64)
    made.SetData(*(numpy_support.numpy_to_vtk(part, deep=1, array_type=VTK_ID_TYPE)
                   for part in (offsets, np.concatenate(ids).astype(np.int64))))
    grid.SetCells(numpy_support.numpy_to_vtk(np.concatenate(types), deep=1), made)


def kind_and_size(name):
    """Of cells by their name: polygon5 has 5 points."""
    if name in CELLS:
        return CELLS[name]
    polygon = re.fullmatch("polygon([0-9]+)", str(name))
    if not polygon or int(polygon[1]) < 3:
        raise ValueError(f"there are no cells {name!r}: they are {', '.join(CELLS)}, and polygonN with N points each, "
                         "such as polygon5")
    return VTK_POLYGON, int(polygon[1])


def to_array(name, values, count):
    values = np.asarray(values)
    if len(values) != count:
        raise ValueError(f"the array {name!r} has {len(values)} values, but there are {count} points or cells")
    if values.dtype in SMALL:  # which VTK does not have
        values = values.astype(SMALL[values.dtype])
    if values.dtype.kind in "UO":
        made = vtkStringArray()
        for value in values:
            made.InsertNextValue(str(value))
    else:
        made = numpy_support.numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    made.SetName(name)
    return made


def to_selection(value):
    """{"points": ids} or {"cells": ids} as a selection."""
    return from_dictionary(value, vtkSelection, add_ids, "a selection such as {'cells': [0, 1]}")


def to_table(value):
    """A dictionary of columns as a table."""
    return from_dictionary(value, vtkTable, add_column, "a table such as {'Label': [1, 2]}")


def from_dictionary(value, cls, add, what):
    """What is of the class as it is; else one to which `add` adds what the dictionary has."""
    if isinstance(value, cls):
        return value
    if not hasattr(value, "items"):
        raise ValueError(f"{value!r} is not {what}")
    made = cls()
    for name, values in value.items():
        add(made, name, values)
    return made


def add_ids(selection, kind, ids):
    if kind not in ("points", "cells"):
        raise ValueError(f"a selection has points or cells, not {kind!r}")
    node = vtkSelectionNode()
    node.SetContentType(vtkSelectionNode.INDICES)
    node.SetFieldType(vtkSelectionNode.POINT if kind == "points" else vtkSelectionNode.CELL)
    node.SetSelectionList(numpy_support.numpy_to_vtk(np.asarray(ids, dtype="int64"), deep=1, array_type=VTK_ID_TYPE))
    selection.AddNode(node)


def add_column(table, name, values):
    table.AddColumn(to_array(name, values, len(values)))


def like(mesh, output):
    """The output of a filter in the way in which its input was given."""
    if isinstance(mesh, vtkDataObject):
        if any(base.__module__.split(".")[0] == "pyvista" for base in type(mesh).__mro__):
            return sys.modules["pyvista"].wrap(output)
        return output
    if mesh is None or isinstance(mesh, vtkAlgorithm):
        return output
    if isinstance(output, vtkCompositeDataSet):
        return [output.GetBlock(i) for i in range(output.GetNumberOfBlocks())]
    return to_arrays(output)


def to_arrays(mesh):
    groups = {}
    first = 0
    for kinds, cells in cell_arrays(mesh):
        offsets = numpy_support.vtk_to_numpy(cells.GetOffsetsArray())
        ids = numpy_support.vtk_to_numpy(cells.GetConnectivityArray())
        sizes = np.diff(offsets)
        kinds = np.full(len(sizes), VTK_POLYGON) if kinds is None else kinds
        for kind, size in sorted({(int(k), int(s)) for k, s in np.unique(np.column_stack([kinds, sizes]), axis=0)}):
            chosen = np.flatnonzero((kinds == kind) & (sizes == size))
            name = NAMES.get(kind) or {3: "triangle", 4: "quad"}.get(size, f"polygon{size}")
            rows = ids[offsets[chosen][:, None] + np.arange(size)]
            groups.setdefault(name, []).append((first + chosen, rows))
        first += len(sizes)
    order = [part for parts in groups.values() for part, _ in parts]
    order = np.concatenate(order) if order else np.zeros(0, int)
    cells = {name: np.concatenate([rows for _, rows in parts]) for name, parts in groups.items()}
    if set(cells) in ({"vertex"}, {"line"}, {"triangle"}, {"tetra"}):
        cells = next(iter(cells.values()))
    points = mesh.GetPoints()
    points = numpy_support.vtk_to_numpy(points.GetData()) if points else np.zeros((0, 3))
    return Arrays(points, cells, data_arrays(mesh.GetPointData()),
                  {name: values[order] for name, values in data_arrays(mesh.GetCellData()).items()})


def cell_arrays(mesh):
    """The cells of a mesh in its order, with their types; None for polygons."""
    if isinstance(mesh, vtkPolyData):
        for kind, cells in ((1, mesh.GetVerts()), (3, mesh.GetLines()), (None, mesh.GetPolys())):
            count = cells.GetNumberOfCells()
            if count:
                yield (None if kind is None else np.full(count, kind)), cells
    elif mesh.GetNumberOfCells():
        types = mesh.GetCellTypesArray() if hasattr(mesh, "GetCellTypesArray") else mesh.GetCellTypes()
        yield numpy_support.vtk_to_numpy(types), mesh.GetCells()


def data_arrays(data):
    """The arrays of numbers, by name."""
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {array.GetName(): numpy_support.vtk_to_numpy(array) for array in arrays if array}
