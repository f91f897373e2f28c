# SPDX-License-Identifier: BSD-3-Clause
"""From arrays, lists and meshes of PyVista to data sets of VTK, and back."""

import os
import sys

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYGON, vtkCompositeDataSet, vtkDataObject, vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet,
    vtkPolyData, vtkSelection, vtkSelectionNode, vtkTable, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import files
from .arrays import Arrays, Image
from .cells import NAMES, join_blocks, set_cells
from .execution import warn
from .run import check_texts, nearest
from .values import (  # noqa: F401
    GHOSTS, data_arrays, to_array, to_ids, to_integers, to_numpy, to_vtk_array, to_vtk_ids)

# Field data by which a filter goes on with what an earlier one made, if the cells keep their order.
STAMP = "Subdivision"
COVERAGE = "Coverage"  # an array of images


def to_vtk(mesh, cells=None, point_data=None, cell_data=None, of_surfaces=False, forms=None):
    """A data set of VTK as it is; arrays, a pair (points, cells), a mesh of meshio, a file or a list of data sets as a
    data set. Of surfaces rows of four are quads. `forms` takes those of arrays (to_array): "point", "cell" and "field"."""
    if isinstance(mesh, vtkAlgorithm):
        mesh.Update()
        mesh = mesh.GetOutputDataObject(0)
    if isinstance(mesh, (str, os.PathLike)):
        mesh = files.read(mesh)
    if isinstance(mesh, Image):
        mesh = mesh.to_vtk()
    if isinstance(mesh, vtkDataObject):
        if cells is not None or point_data or cell_data:
            raise TypeError("a data set has cells and arrays of its own")
        return mesh
    if has_arrays(mesh):
        if cells is not None:
            raise TypeError("the mesh has cells of its own")
        return from_mesh(mesh, point_data, cell_data, of_surfaces, forms)
    if is_list_of_data_sets(mesh):
        blocks = vtkMultiBlockDataSet()
        for index, one in enumerate(mesh):
            blocks.SetBlock(index, one)
        return blocks
    if cells is None and isinstance(mesh, tuple) and len(mesh) == 2:
        return from_arrays(*mesh, point_data, cell_data, of_surfaces, forms)
    return from_arrays(mesh, cells, point_data, cell_data, of_surfaces, forms)


def has_arrays(mesh):
    """Whether it has points, cells and arrays, as Arrays and a mesh of meshio."""
    return all(hasattr(mesh, name) for name in ("points", "cells", "point_data", "cell_data"))


def from_mesh(mesh, point_data, cell_data, of_surfaces, forms):
    lost = [name for name in ("point_sets", "cell_sets") if getattr(mesh, name, None)]
    if lost:
        warn(f"{' and '.join(lost)} of the mesh are left out: give them as masks in point_data or cell_data")
    is_ours = isinstance(mesh, Arrays)
    cells = None if is_ours and not len(mesh.cells) else mesh.cells
    made = from_arrays(mesh.points, cells, {**mesh.point_data, **(point_data or {})},
                       {**mesh.cell_data, **(cell_data or {})}, of_surfaces and not is_ours, forms)
    for name, values in (getattr(mesh, "field_data", None) or {}).items():
        values = np.atleast_1d(to_numpy(f"field_data: the array {name!r}", values))
        made.GetFieldData().AddArray(to_array(name, values, len(values), "values", (forms or {}).get("field")))
    for attribute, name in mesh.attributes.items() if is_ours else ():
        if name in mesh.point_data:
            set_attribute(made, attribute, name)
    return made


def is_list_of_data_sets(mesh):
    """Whether it is a list of data sets of VTK. What is none of them in a list of meshes is an error."""
    if not isinstance(mesh, (list, tuple)) or not mesh:
        return False
    others = [index for index, one in enumerate(mesh) if not isinstance(one, vtkDataObject)]
    is_list = len(others) < len(mesh) or (isinstance(mesh, list) and is_mesh(mesh[0]))
    if is_list and others:
        raise TypeError(f"a list of meshes has data sets of VTK only, but [{others[0]}] is of the type "
                        f"{type(mesh[others[0]]).__name__}")
    return is_list


def is_mesh(one):
    """Whether it is a mesh that is no data set: a pair of points and cells, Arrays, or one of meshio."""
    return has_arrays(one) or (isinstance(one, tuple) and len(one) == 2 and
                               all(isinstance(part, (list, np.ndarray)) or hasattr(part, "items") for part in one))


# Arguments that name the array of points which is an attribute of VTK.
ATTRIBUTES = {"texture_coordinates": vtkDataSetAttributes.TCOORDS, "normals": vtkDataSetAttributes.NORMALS}


def set_attribute(mesh, attribute, name):
    """Makes an array of points the attribute."""
    if not hasattr(mesh, "GetPointData"):
        raise ValueError(f"{attribute} is for a mesh that is no list of blocks")
    data = mesh.GetPointData()
    check_texts(attribute, [name] if isinstance(name, str) else [])
    if not isinstance(name, str) or not data.HasArray(name):
        names = [data.GetArrayName(i) or "" for i in range(data.GetNumberOfArrays())]
        raise ValueError(f"{attribute} is the name of an array of point_data, not {name!r}{nearest(name, names)}")
    if not isinstance(data.GetAbstractArray(name), vtkDataArray):
        raise ValueError(f"the array {name!r} cannot be {attribute}: it has no numbers")
    components = data.GetAbstractArray(name).GetNumberOfComponents()
    if components not in ((1, 2, 3) if attribute == "texture_coordinates" else (3,)):
        raise ValueError(f"the array {name!r} cannot be {attribute}: it has {components} components")
    data.SetActiveAttribute(name, ATTRIBUTES[attribute])


def with_attributes(mesh, names):
    """The mesh with arrays of points as attributes, by the names of arguments; not the mesh of the caller."""
    names = {attribute: name for attribute, name in names.items() if name is not None}
    if not names:
        return mesh
    made = mesh.NewInstance()
    made.ShallowCopy(mesh)
    for attribute, name in names.items():
        set_attribute(made, attribute, name)
    return made


def to_image(labels, spacing=None, origin=None):
    """A data set of VTK as it is, or from a file; an array [x, y, z] as an image with these labels at its points."""
    if isinstance(labels, (str, os.PathLike)):
        labels = files.read(labels)
    if isinstance(labels, (vtkAlgorithm, vtkDataObject)) or is_list_of_data_sets(labels):
        if spacing is not None or origin is not None:
            raise TypeError("a data set has a spacing and an origin of its own")
        return to_vtk(labels)
    labels = to_numpy("labels", labels)
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
    values = to_numpy(name, default if values is None else values)
    if values.shape != (3,) or values.dtype.kind not in "buif" or not np.isfinite(values).all():
        raise ValueError(f"{name} takes 3 finite numbers, along x, y and z, not {values.tolist()!r}")
    if name == "spacing" and values.min() <= 0:
        raise ValueError(f"spacing must be above 0, not {values.tolist()!r}")
    return values.tolist()


def from_arrays(points, cells, point_data=None, cell_data=None, of_surfaces=False, forms=None):
    points = to_numpy("points", points)
    if points.ndim != 2 or points.shape[1] not in (2, 3) or points.dtype.kind not in "buif":
        raise ValueError(f"points must be numbers in 2 or 3 columns, not the shape {points.shape} of {points.dtype}")
    if points.dtype != np.float32:
        points = points.astype(np.float64)
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points), points.dtype)])
    coordinates = vtkPoints()
    coordinates.SetData(to_vtk_array(points))
    blocks = []
    if cells is None:
        mesh = vtkPolyData()
        mesh.SetPoints(coordinates)
    else:
        mesh = vtkUnstructuredGrid()
        mesh.SetPoints(coordinates)
        blocks = set_cells(mesh, cells, len(points), of_surfaces)
    for what, given, target, count in (("point", point_data, mesh.GetPointData(), len(points)),
                                       ("cell", cell_data, mesh.GetCellData(), mesh.GetNumberOfCells())):
        if given is not None and not hasattr(given, "items"):
            raise ValueError(f"{what}_data is a dictionary of arrays by name, not {type(given).__name__}")
        for name, values in (given or {}).items():
            values = join_blocks(name, values, blocks) if what == "cell" else values
            target.AddArray(to_array(name, values, count, what + "s", (forms or {}).get(what)))
    return mesh


def to_selection(value, mesh=None):
    """{"points": ids} or {"cells": ids} as a selection; a mask of truth values chooses those of the mesh."""
    def add(selection, kind, ids):
        if kind not in ("points", "cells"):
            raise ValueError(f"a selection has points or cells, not {kind!r}")
        count = getattr(mesh, f"GetNumberOf{kind.capitalize()}", None) if hasattr(mesh, "GetPointData") else None
        node = vtkSelectionNode()
        node.SetContentType(vtkSelectionNode.INDICES)
        node.SetFieldType(vtkSelectionNode.POINT if kind == "points" else vtkSelectionNode.CELL)
        node.SetSelectionList(to_vtk_ids(to_ids(f"the selection of {kind}", ids, count and count(), kind)))
        selection.AddNode(node)

    return from_dictionary(value, vtkSelection, add, "a selection such as {'cells': [0, 1]}")


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


def add_column(table, name, values):
    count = table.GetNumberOfRows() if table.GetNumberOfColumns() else len(np.atleast_1d(values))
    table.AddColumn(to_array(name, values, count, "rows"))


def to_crease_rows(value):
    """Rows of a dictionary from pairs to sharpness, or of a pair of rows and sharpness; other rows as they are."""
    if hasattr(value, "items"):
        wrong = [pair for pair in value if not isinstance(pair, (tuple, frozenset)) or len(pair) != 2]
        if wrong:
            raise ValueError(f"creases is a dictionary from pairs of point ids to sharpness, such as {{(0, 1): 1.5}}: "
                             f"{wrong[0]!r} is no pair")
        return [(*pair, sharpness) for pair, sharpness in value.items()]
    if isinstance(value, tuple) and len(value) == 2 and to_numpy("creases", value[0]).ndim == 2:
        rows, sharpness = (to_numpy("creases", part) for part in value)
        if sharpness.shape not in ((), (1,), (len(rows),)):
            raise ValueError(f"creases has {len(rows)} rows, and sharpness of the shape {sharpness.shape}: give one "
                             "for all or one for each")
        return np.column_stack([rows, np.broadcast_to(sharpness, len(rows))])
    return value


def to_creases(value, mesh):
    """Rows of two point ids, and of a sharpness where there is a third column, as lines on the points of the mesh. Also
    a pair of such rows and their sharpness, or a dictionary from pairs to sharpness."""
    value = to_crease_rows(value)
    if not hasattr(mesh, "GetPoints"):
        raise ValueError("creases are for a mesh with points, which is no list of blocks: give crease_geometry")
    rows = to_numpy("creases", value)
    if rows.size == 0:
        raise ValueError("creases has no rows: give None where there are none")
    if rows.ndim != 2 or rows.shape[1] not in (2, 3) or rows.dtype.kind not in "iuf":
        raise ValueError("creases must be rows of two point ids, and of a sharpness as a third number where creases are "
                         f"not to stay sharp for ever, not the shape {rows.shape} of {rows.dtype}")
    pairs = rows[:, :2].astype(np.int64)
    if (pairs != rows[:, :2]).any():
        raise ValueError("the point ids of creases must be whole numbers")
    to_ids("creases", pairs, mesh.GetNumberOfPoints(), "points")
    same = pairs[pairs[:, 0] == pairs[:, 1]]
    if len(same):
        raise ValueError(f"creases has the row {same[0].tolist()}, from a point to itself: it is no edge")
    if rows.shape[1] == 3 and not (rows[:, 2] >= 0).all():
        raise ValueError("the sharpness of creases must be 0 or more")
    made = vtkUnstructuredGrid()
    made.SetPoints(mesh.GetPoints())
    set_cells(made, {"line": pairs}, mesh.GetNumberOfPoints())
    if rows.shape[1] == 3:
        made.GetCellData().AddArray(to_array("Sharpness", rows[:, 2].astype(float), len(rows)))
    ids = mesh.GetPointData().GetGlobalIds()
    if ids:
        made.GetPointData().SetGlobalIds(ids)
    return made


def like(mesh, output, forms):
    """The output of a filter in the way in which its input was given, and arrays in the forms of those there. A table is
    a dictionary of its columns."""
    if isinstance(output, vtkTable):
        return data_arrays(output.GetRowData())
    if isinstance(mesh, vtkDataObject):
        if any(base.__module__.split(".")[0] == "pyvista" for base in type(mesh).__mro__):
            return sys.modules["pyvista"].wrap(output)
        return output
    if mesh is None or isinstance(mesh, vtkAlgorithm):
        return output
    if isinstance(output, vtkCompositeDataSet):
        return [output.GetBlock(i) for i in range(output.GetNumberOfBlocks())]
    return (to_samples if isinstance(output, vtkImageData) else to_arrays)(output, forms)


def to_samples(image, forms=None):
    """The arrays of an image, which have the axes z, y and x: x goes fastest in VTK."""
    shape = image.GetDimensions()[::-1]
    arrays = data_arrays(image.GetPointData(), (forms or {}).get("point"))
    lows = image.GetExtent()[::2] if image.GetNumberOfPoints() else (0, 0, 0)
    origin = tuple(o + s * low for o, s, low in zip(image.GetOrigin(), image.GetSpacing(), lows))
    active = image.GetPointData().GetScalars()
    coverage = image.GetPointData().GetArray(COVERAGE)
    names = [coverage.GetComponentName(c) for c in range(coverage.GetNumberOfComponents())] if coverage else []
    return Image({name: values.reshape(shape + values.shape[1:]) for name, values in arrays.items()}, origin,
                 image.GetSpacing(), active and active.GetName(), tuple(name for name in names if name))


def from_image(image):
    """Arrays with the axes z, y and x as a vtkImageData."""
    made = vtkImageData()
    made.SetOrigin(*three_numbers("origin", image.origin, None))
    made.SetSpacing(*three_numbers("spacing", image.spacing, None))
    shapes = {np.shape(values)[:3] for values in image.values()}
    if len(shapes) > 1 or any(len(shape) < 3 for shape in shapes):
        raise ValueError(f"the arrays of an image must have the same axes z, y and x, not the shapes {sorted(shapes)}")
    if shapes:
        made.SetDimensions(*shapes.pop()[::-1])
    for name, values in image.items():
        values = to_numpy(name, values)
        made.GetPointData().AddArray(to_array(name, values.reshape(-1, *values.shape[3:]), made.GetNumberOfPoints()))
    for component, name in enumerate(image.materials if COVERAGE in image else ()):
        made.GetPointData().GetArray(COVERAGE).SetComponentName(component, name)
    if image.scalars in image:
        made.GetPointData().SetActiveScalars(image.scalars)
    return made


def to_arrays(mesh, forms=None):
    forms = forms or {}
    groups = {}
    first = 0
    for kinds, cells in cell_arrays(mesh):
        offsets = numpy_support.vtk_to_numpy(cells.GetOffsetsArray())
        ids = numpy_support.vtk_to_numpy(cells.GetConnectivityArray())
        for name, chosen, size in cells_of_types(kinds, np.diff(offsets)):
            rows = ids.reshape(-1, size) if len(chosen) == len(offsets) - 1 else \
                ids[offsets[chosen][:, None] + np.arange(size)]
            groups.setdefault(name, []).append((first + chosen, rows))
        first += len(offsets) - 1
    order = join_parts([part for parts in groups.values() for part, _ in parts])
    cells = {name: join_parts([rows for _, rows in parts]) for name, parts in groups.items()}
    if set(cells) in ({"vertex"}, {"line"}, {"triangle"}, {"tetra"}):
        cells = next(iter(cells.values()))
    points = mesh.GetPoints()
    points = numpy_support.vtk_to_numpy(points.GetData()) if points else np.zeros((0, 3))
    fields = data_arrays(mesh.GetFieldData(), forms.get("field"))
    is_in_order = bool((order == np.arange(len(order))).all())
    if not is_in_order:
        fields = {name: values for name, values in fields.items() if not (name or "").startswith(STAMP)}
    active = {attribute: mesh.GetPointData().GetAbstractAttribute(kind) for attribute, kind in ATTRIBUTES.items()}
    return Arrays(points, cells, data_arrays(mesh.GetPointData(), forms.get("point")),
                  {name: values if is_in_order else values[order]
                   for name, values in data_arrays(mesh.GetCellData(), forms.get("cell")).items()},
                  fields, {attribute: array.GetName() for attribute, array in active.items() if array})


def join_parts(parts):
    """Arrays one after the other; a single one as it is."""
    return parts[0] if len(parts) == 1 else np.concatenate(parts) if parts else np.zeros(0, int)


def cells_of_types(kinds, sizes):
    """For each type and number of points that cells have, by `kinds`, None for polygons, and `sizes`: its name, its
    cells and the number."""
    kinds = np.int64(VTK_POLYGON) if kinds is None else kinds.astype(np.int64)
    keys = sizes.astype(np.int64) + (kinds << 40)
    first = keys[0] if len(keys) else 0
    for key in [first] if (keys == first).all() else np.unique(keys).tolist():
        kind, size = int(key) >> 40, int(key) & (2**40 - 1)
        name = NAMES.get(kind) or {3: "triangle", 4: "quad"}.get(size, f"polygon{size}")
        yield name, np.flatnonzero(keys == key), size


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
