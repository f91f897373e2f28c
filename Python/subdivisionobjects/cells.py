# SPDX-License-Identifier: BSD-3-Clause
"""Cells as arrays of NumPy, in dictionaries, lists of blocks and meshes of meshio, to cells of VTK."""

import re

import numpy as np
from vtkmodules.vtkCommonDataModel import VTK_POLYGON, vtkCellArray

from .execution import warn
from .values import join, to_integers, to_numpy, to_vtk_array, to_vtk_ids

# Type of VTK and number of points, by the names that meshio has, too.
CELLS = {"vertex": (1, 1), "line": (3, 2), "triangle": (5, 3), "tetra": (10, 4), "quad": (9, 4),
         "hexahedron": (12, 8), "wedge": (13, 6), "pyramid": (14, 5), "penta_prism": (15, 10), "hexa_prism": (16, 12),
         "pixel": (8, 4), "voxel": (11, 8),
         "line3": (21, 3), "line4": (35, 4), "triangle6": (22, 6), "triangle7": (34, 7), "quad6": (30, 6),
         "quad8": (23, 8), "quad9": (28, 9), "tetra10": (24, 10), "hexahedron20": (25, 20), "hexahedron24": (33, 24),
         "hexahedron27": (29, 27), "wedge12": (31, 12), "wedge15": (26, 15), "wedge18": (32, 18),
         "pyramid13": (27, 13),
         # What output_cells="bezier" makes.
         "bezier_curve": (75, 4), "bezier_triangle": (76, 15), "bezier_quad": (77, 16), "bezier_tetra": (78, 56)}
# What output_cells="lagrange" makes, of any number of points.
LAGRANGE = {f"VTK_LAGRANGE_{name}": kind for kind, name in enumerate(
    ("CURVE", "TRIANGLE", "QUADRILATERAL", "TETRAHEDRON", "HEXAHEDRON", "WEDGE"), 68)}
NAMES = {**{kind: name for name, (kind, _) in CELLS.items()}, **{kind: name for name, kind in LAGRANGE.items()}}
# What the rows of a single array are, by their number of points.
OF_SOLIDS = {1: "vertex", 2: "line", 3: "triangle", 4: "tetra", 6: "wedge", 8: "hexahedron"}
OF_SURFACES = {1: "vertex", 2: "line", 3: "triangle", 4: "quad"}
OTHERWISE = "for other or several types give a dictionary such as {'quad': rows, 'line': rows}"


class Block:
    """Some cells of a mesh, of one type: their points, one cell after the other, and how many each of them has."""

    def __init__(self, name, rows):
        self.name = name
        ragged = isinstance(rows, (list, tuple)) and len({np.size(row) for row in rows}) > 1
        if name in ("polygon", VTK_POLYGON) and (ragged or getattr(rows, "dtype", None) == object):
            rows = [to_integers("polygon", row).ravel() for row in rows]
            self.kind = kind_and_size("polygon", min(map(len, rows)))[0]
            self.sizes, self.ids = np.array([len(row) for row in rows]), np.concatenate(rows)
            return
        rows = to_rows(name, rows)
        if rows.size == 0:
            self.kind, self.sizes, self.ids = kind_and_size(name, 3)[0], np.zeros(0, int), np.zeros(0, int)
            return
        self.kind, size = kind_and_size(name, rows.shape[1] if rows.ndim == 2 else None)
        if rows.ndim != 2 or rows.shape[1] != size or rows.dtype.kind not in "iu":
            raise ValueError(f"{name} must have rows of {size} integers, not the shape {rows.shape} of {rows.dtype}"
                             f"{cure(rows, size)}")
        self.sizes, self.ids = np.full(len(rows), size), to_integers(name, rows).ravel()

    def __len__(self):
        return len(self.sizes)

    def check(self, number_of_points):
        wrong = np.flatnonzero((self.ids < 0) | (self.ids >= number_of_points))
        if not len(wrong):
            return
        ends = np.cumsum(self.sizes)
        cell = int(np.searchsorted(ends, wrong[0], side="right"))
        row = self.ids[ends[cell] - self.sizes[cell]:ends[cell]].tolist()
        counted = "; ids are counted from 0: where they begin with 1, give rows - 1" \
            if self.ids.min() == 1 and self.ids.max() == number_of_points else ""
        if (self.ids[ends - self.sizes] == self.sizes - 1).all():
            counted = "; where each row begins with its number of points, as in VTK and PyVista, give rows[:, 1:]"
        raise ValueError(f"{self.name} {cell} has point ids {row}, but there are {number_of_points} points{counted}")


def to_rows(name, values):
    """Rows of cells as an array. Points cannot be missing in them."""
    if np.ma.is_masked(values):
        raise ValueError(f"{name} has cells with missing points (a mask): leave these cells out, by "
                         "rows[~rows.mask.any(axis=1)].data")
    return to_numpy(name, values)


def name_of(kind):
    """The name of cells that are given by it, or by their type of VTK."""
    is_type = isinstance(kind, (int, np.integer))
    return NAMES.get(kind, "polygon" if kind == VTK_POLYGON else kind) if is_type else kind


def kind_and_size(name, size=None):
    """Of cells by their name, or their type of VTK: polygon5 has 5 points, polygon as many as its rows have."""
    name = name_of(name)
    if name in CELLS:
        return CELLS[name]
    if name in LAGRANGE and size is not None:
        return LAGRANGE[name], size
    polygon = re.fullmatch("polygon([0-9]*)", str(name))
    count = int(polygon[1] or size or 0) if polygon else 0
    if count < 3:
        if name == "polygon" and size is not None:
            raise ValueError(f"there are no cells 'polygon' of {size} points: they have three or more, such as "
                             "polygon5; cells of two points are lines: give {'line': rows}")
        raise ValueError(f"there are no cells {name!r}: they are {', '.join(CELLS)}, and polygonN with N points each, "
                         "such as polygon5")
    return VTK_POLYGON, count


def begins_with_size(rows):
    """Whether each row begins with its number of points, as in VTK and PyVista: that is an id again in some row."""
    size = rows.shape[1] - 1 if rows.ndim == 2 else 0
    return size > 0 and bool((rows[:, 0] == size).all()) and bool((rows[:, 1:] == size).any())


def warn_of_size(rows, name):
    """Warns where rows may begin with their number of points, or all cells have one point in common."""
    size = rows.shape[1] - 1
    if len(rows) > 1 and size > 1 and (rows[:, 0] == size).all():
        warn(f"all rows of cells begin with {size}, and are taken as cells {name!r} around the point {size}: where "
             f"it is their number of points, give rows[:, 1:]; where they are right, {{{name!r}: rows}} says so")


def cure(rows, size):
    if rows.ndim == 1 and rows.dtype.kind in "iu":
        return (f"; a flat array in which each cell begins with its number of points, as VTK and PyVista have it, "
                f"becomes rows by .reshape(-1, {size + 1})[:, 1:] where all have {size}")
    if rows.ndim == 2 and rows.shape[1] == size + 1 and len(rows) and (rows[:, 0] == size).all():
        return "; where each row begins with its number of points, give rows[:, 1:]"
    if rows.ndim == 2 and rows.shape[1] == size + 1:
        return f"; a region or material behind the points belongs to cell_data: give rows[:, :{size}]"
    if rows.dtype.kind == "f" and not np.isfinite(rows).all():
        return "; NaN is the id of no point: leave the cells that have it out"
    if rows.dtype.kind == "f" and (rows == np.round(rows)).all():
        return "; give rows.astype(int)"
    return ""


def name_of_rows(rows, of_surfaces):
    """What the rows of a single array are."""
    found = OF_SURFACES if of_surfaces else OF_SOLIDS
    if rows.ndim == 2 and rows.shape[1] - 1 in found and begins_with_size(rows):
        inner = found[rows.shape[1] - 1]
        raise ValueError(f"each row of cells begins with its number of points: give rows[:, 1:] for cells {inner!r}")
    if rows.ndim == 2 and rows.shape[1] == 5:
        quad = found[4]
        raise ValueError(
            f"rows of 5 integers may be many cells: give {{{quad!r}: rows[:, :4]}}, with the fifth column as "
            f"cell_data={{'region': rows[:, 4]}}, where it is a region or material, as of iso2mesh and TetGen; "
            f"{{{quad!r}: rows[:, 1:]}} where rows begin with their number of points, as in VTK and PyVista; "
            f"{{'pyramid': rows}} or {{'polygon5': rows}} where these are meant")
    if rows.ndim != 2 or rows.shape[1] not in found:
        sizes = "1 to 4" if of_surfaces else "1 to 4, 6 or 8"
        raise ValueError(f"cells must have a row of {sizes} point ids each, not the shape {rows.shape}"
                         f"{cure(rows, 4)}; {OTHERWISE}")
    warn_of_size(rows, found[rows.shape[1]])
    return found[rows.shape[1]]


def is_pair(one):
    """Whether it is a type of cells, by its name or that of VTK, and their rows, and not a row of two ids."""
    return isinstance(one, (list, tuple)) and len(one) == 2 and (isinstance(one[0], str) or (
        isinstance(one[0], (int, np.integer)) and not isinstance(one[1], (int, float, np.number))))


def find_blocks(cells, of_surfaces):
    """The blocks of a dictionary by types, of a list of pairs or of blocks of meshio, or of a single array."""
    if hasattr(cells, "items"):
        return [Block(name, rows) for name, rows in cells.items()]
    if isinstance(cells, (list, tuple)) and len(cells):
        pairs = [(one.type, one.data) if hasattr(one, "type") and hasattr(one, "data") else one for one in cells]
        if all(map(is_pair, pairs)):
            return [Block(name, rows) for name, rows in pairs]
        if len({np.size(one) for one in cells}) > 1:
            raise ValueError(f"cells must have a row of point ids each, of one size, not rows of several sizes; "
                             f"{OTHERWISE}")
    rows = to_rows("cells", cells)
    if rows.size == 0:
        return []
    return [Block(name_of_rows(rows, of_surfaces), rows)]


def set_cells(grid, cells, number_of_points, of_surfaces=False):
    """Sets the cells of a grid, and returns how many each block has, by name."""
    blocks = find_blocks(cells, of_surfaces)
    if not sum(map(len, blocks)):
        raise ValueError("there are no cells")
    for block in blocks:
        block.check(number_of_points)
    made = vtkCellArray()
    sizes = np.concatenate([block.sizes for block in blocks])
    made.SetData(to_vtk_ids(np.concatenate([[0], np.cumsum(sizes)])),
                 to_vtk_ids(np.concatenate([block.ids for block in blocks])))
    grid.SetCells(to_vtk_array(np.concatenate([np.full(len(block), block.kind, np.uint8) for block in blocks])), made)
    return [(block.name, len(block)) for block in blocks]


def join_blocks(name, values, blocks):
    """Values of cells by blocks, a list as meshio has it or a dictionary by types, one after the other."""
    shown = f"the array {name!r}"
    if hasattr(values, "items"):
        return join(shown, parts_by_types(shown, values, blocks))
    if not isinstance(values, (list, tuple)) or len(values) != len(blocks):
        return values
    sizes, lengths = [size for _, size in blocks], [length(part) for part in values]
    if None in lengths or (lengths != sizes and len(values) == sum(sizes)):  # a value or a row of values for each cell
        return values
    for index, (block, size) in enumerate(blocks):
        if lengths[index] != size:
            raise ValueError(f"{shown} has {lengths[index]} values in block {index}, which has {size} cells {block!r}")
    return join(shown, values)


def parts_by_types(shown, values, blocks):
    """Of values by types of cells those of each block. Blocks of one type share them."""
    given = {name_of(kind): np.atleast_1d(to_numpy(f"{shown}, cells {kind!r},", part)) for kind, part in values.items()}
    used = dict.fromkeys(given, 0)
    parts = []
    for block, size in blocks:
        block = name_of(block)
        if block not in given:
            if size:
                raise ValueError(f"{shown} has no values for the cells {block!r}")
            continue
        parts.append(given[block][used[block]:used[block] + size])
        used[block] += size
    for block, part in given.items():
        if len(part) != used[block]:
            raise ValueError(f"{shown} has {len(part)} values for the cells {block!r}, of which there are "
                             f"{used[block]}")
    return parts


def length(values):
    """How many values a list or an array has; None for a single value."""
    try:
        return None if isinstance(values, (str, bytes)) else len(values)
    except TypeError:
        return None
