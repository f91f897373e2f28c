# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as files of solvers: MSH 4.1 of Gmsh, .inp of CalculiX and Abaqus, Exodus.

meshio 5.0 has writers of these formats, which are not used: they name cells by the last type of a table (C3D10MH for
ten nodes), leave out groups without nodes of their own, and do not turn nodes of hexahedra in Exodus and of beams.
"""

import contextlib
import importlib
import os
import re
from typing import NamedTuple

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

from .cells import NAMES
from .execution import warn
from .run import nearest
from .values import data_arrays

DIMENSIONS = ("points", "curves", "surfaces", "solids")
# Shapes and orders of cells by their types of VTK; those of Lagrange have any order.
SHAPES = {1: ("vertex", 1), 3: ("line", 1), 5: ("triangle", 1), 9: ("quad", 1), 10: ("tetra", 1), 12: ("hexahedron", 1),
          13: ("wedge", 1), 14: ("pyramid", 1), 21: ("line", 2), 22: ("triangle", 2), 23: ("quad", "edges"),
          24: ("tetra", 2), 25: ("hexahedron", "edges"), 26: ("wedge", "edges"), 27: ("pyramid", "edges"),
          68: ("line", 0), 69: ("triangle", 0), 70: ("quad", 0), 71: ("tetra", 0), 72: ("hexahedron", 0), 73: ("wedge", 0)}
DIMENSION = {"vertex": 0, "line": 1, "triangle": 2, "quad": 2, "tetra": 3, "hexahedron": 3, "wedge": 3, "pyramid": 3}
# Corners, edges and faces in the order of Gmsh.
CORNERS = {
    "line": [(0,), (1,)], "triangle": [(0, 0), (1, 0), (0, 1)], "quad": [(0, 0), (1, 0), (1, 1), (0, 1)],
    "tetra": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    "hexahedron": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
    "wedge": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]}
EDGES = {
    "line": [], "triangle": ["01", "12", "20"], "quad": ["01", "12", "23", "30"],
    "tetra": ["01", "12", "20", "30", "32", "31"],
    "hexahedron": ["01", "03", "04", "12", "15", "23", "26", "37", "45", "47", "56", "67"],
    "wedge": ["01", "02", "03", "12", "14", "25", "34", "35", "45"]}
FACES = {"tetra": ["021", "013", "032", "312"], "hexahedron": ["0321", "0154", "0473", "1265", "2376", "4567"],
         "wedge": ["021", "345", "0143", "0352", "1254"]}
# How many nodes a cell of Lagrange has.
NODES = {"line": lambda p: p + 1, "triangle": lambda p: (p + 1) * (p + 2) // 2, "quad": lambda p: (p + 1)**2,
         "tetra": lambda p: (p + 1) * (p + 2) * (p + 3) // 6, "hexahedron": lambda p: (p + 1)**3,
         "wedge": lambda p: (p + 1)**2 * (p + 2) // 2}
# How much smaller the inside of a cell is, in steps between nodes.
INSIDE = {"triangle": 3, "quad": 2, "tetra": 4, "hexahedron": 2}
# Numbers of Gmsh, by orders from 1 on.
GMSH = {"vertex": [15], "line": [1, 8, 26, 27, 28, 62], "triangle": [2, 9, 21, 23, 25, 42], "quad": [3, 10, 36, 37, 38, 47],
        "tetra": [4, 11, 29, 30, 31, 71], "hexahedron": [5, 12, 92, 93, 94, 95], "wedge": [6, 13],
        "pyramid": [7]}
# Of nodes at corners and edges only: the number, and the nodes of VTK in the order of Gmsh.
GMSH_OF_EDGES = {
    "quad": (16, range(8)), "pyramid": (19, [0, 1, 2, 3, 4, 5, 8, 9, 6, 10, 7, 11, 12]),
    "hexahedron": (17, [0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14]),
    "wedge": (18, [0, 1, 2, 3, 4, 5, 6, 8, 12, 7, 13, 14, 9, 11, 10])}
# The element of CalculiX, and the nodes of VTK in its order where that is another one.
CALCULIX = {("line", 1): ("B31", None), ("line", 2): ("B32", [0, 2, 1]), ("triangle", 1): ("S3", None),
            ("triangle", 2): ("S6", None), ("quad", 1): ("S4", None), ("quad", "edges"): ("S8R", None),
            ("tetra", 1): ("C3D4", None), ("tetra", 2): ("C3D10", None), ("hexahedron", 1): ("C3D8", None),
            ("hexahedron", "edges"): ("C3D20", None), ("wedge", 1): ("C3D6", None), ("wedge", "edges"): ("C3D15", None)}
# The same of Exodus: upright edges come before those at the top.
EXODUS = {("vertex", 1): ("SPHERE", None), ("line", 1): ("BAR2", None), ("line", 2): ("BEAM3", None),
          ("triangle", 1): ("TRI3", None), ("triangle", 2): ("TRI6", None), ("quad", 1): ("QUAD4", None),
          ("quad", "edges"): ("QUAD8", None), ("tetra", 1): ("TETRA", None), ("tetra", 2): ("TETRA10", None),
          ("hexahedron", 1): ("HEX8", None), ("wedge", 1): ("WEDGE", None), ("pyramid", 1): ("PYRAMID", None),
          ("hexahedron", "edges"): ("HEX20", [*range(12), 16, 17, 18, 19, 12, 13, 14, 15]),
          ("wedge", "edges"): ("WEDGE15", [*range(9), 12, 13, 14, 9, 10, 11]), ("pyramid", "edges"): ("PYRAMID13", None)}


class Group(NamedTuple):
    """Cells that a solver knows by one name, all of one dimension."""

    dimension: int
    number: int
    name: str


class Block(NamedTuple):
    """Cells of a group that are of one type: their ids, and rows of points in VTK's order."""

    group: Group
    kind: int
    cells: np.ndarray
    rows: np.ndarray


def shape_of(kind, size):
    """The shape and order of cells by their type of VTK and number of nodes; None where solvers have no such cells."""
    shape, order = SHAPES.get(kind, (None, None))
    if order == 0:
        order = next(p for p in range(1, size + 1) if NODES[shape](p) >= size)
    return (shape, order) if shape else None


def gmsh_nodes(shape, order):
    """Places of nodes in the order of Gmsh, as multiples of 1 / order: corners, edges, faces, and the inside as a smaller
    cell."""
    corners = np.array(CORNERS[shape])
    if order == 0:
        return np.zeros((1, corners.shape[1]), int)
    places = [order * corners]
    for edge in EDGES[shape] if order > 1 else []:
        a, b = (corners[int(c)] for c in edge)
        places += [order * a + np.arange(1, order)[:, None] * (b - a)]
    for face in FACES.get(shape, []):
        first, second, last = (corners[int(face[i])] for i in (0, 1, -1))
        of = "triangle" if len(face) == 3 else "quad"
        if order >= INSIDE[of]:
            i, j = gmsh_nodes(of, order - INSIDE[of]).T[:, :, None] + 1
            places += [order * first + i * (second - first) + j * (last - first)]
    if shape == "line":
        places += [np.arange(1, order)[:, None]]
    elif shape != "wedge" and order >= INSIDE[shape]:
        places += [gmsh_nodes(shape, order - INSIDE[shape]) + 1]
    return np.concatenate(places)


def vtk_places(kind, size, order):
    """Places of nodes in VTK's order, which differs between its versions, as multiples of 1 / order."""
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetNumberOfPoints(size)
    grid.SetPoints(points)
    grid.InsertNextCell(kind, size, list(range(size)))
    return np.rint(np.reshape(grid.GetCell(0).GetParametricCoords(), (-1, 3))[:size] * order).astype(int)


def gmsh_type(block, kind, size):
    """The number of Gmsh for a type of cells, and the nodes of VTK in its order."""
    shape, order = block
    if order == "edges":
        return GMSH_OF_EDGES[shape]
    if shape in ("vertex", "pyramid") or order == 1:
        return GMSH[shape][0], range(size)
    ours = {tuple(place): node for node, place in enumerate(vtk_places(kind, size, order)[:, :DIMENSION[shape]].tolist())}
    return GMSH[shape][order - 1], [ours[tuple(place)] for place in gmsh_nodes(shape, order).tolist()]


def group_values(data, groups):
    """The number of the group of each cell."""
    if groups is None:
        return np.ones(data.GetNumberOfCells(), int)
    arrays = data_arrays(data.GetCellData())
    if groups not in arrays:
        raise ValueError(f"groups is the name of a cell array, not {groups!r}{nearest(groups, arrays)}")
    values = arrays[groups]
    if values.ndim != 1 or values.dtype.kind not in "buif" or (values != np.round(values)).any():
        raise ValueError(f"the cell array {groups!r} cannot be groups: it has values that are no whole numbers")
    return values.astype(int)


def group_names(data, groups, names):
    """Names of groups by (dimension, number), or by number: those of the caller, and those in field data, which are
    arrays [number, dimension] as Gmsh and meshio have them, or the first texts beside numbers with the name of the array."""
    fields = data_arrays(data.GetFieldData())
    found = {}
    if groups in fields:
        texts = [one for one in fields.values() if one.dtype.kind in "UO" and len(one) == len(fields[groups])]
        found.update(zip(fields[groups].ravel().tolist(), texts[0].tolist()) if texts else [])
    for name, pair in fields.items():
        if np.size(pair) == 2 and np.asarray(pair).dtype.kind in "iu" and groups is not None:
            number, dimension = np.ravel(pair).tolist()
            found[dimension, number] = name
    found.update(names or {})
    return found


def find_groups(data, groups, names):
    """The blocks of all cells, in order of groups. Solvers count groups from 1."""
    from . import meshes

    values, known = group_values(data, groups), group_names(data, groups, names)
    next_number = max(values.max(initial=0), 0) + 1
    numbers = {}
    for value in np.unique(values).tolist():
        numbers[value] = value if value > 0 else next_number
        next_number += value < 1
    moved = {value: number for value, number in numbers.items() if value != number}
    if moved:
        warn("solvers count groups from 1: " + ", ".join(f"{groups} {old} is number {new}" for old, new in moved.items())
             + " in the file")
    parts = {}
    first = 0
    for kinds, cells in meshes.cell_arrays(data):
        offsets, ids = (numpy_support.vtk_to_numpy(one) for one in (cells.GetOffsetsArray(), cells.GetConnectivityArray()))
        for name, chosen, size in meshes.cells_of_types(kinds, np.diff(offsets)):
            kind = int(kinds[chosen[0]]) if kinds is not None else {"triangle": 5, "quad": 9}.get(name, 7)
            shape = shape_of(kind, size)
            if not shape:
                raise ValueError(f"cell {first + chosen[0]} is of the type {NAMES.get(kind, kind)!r}, which solvers do not "
                                 "have: subdivide the mesh first, with output_cells='Quadratic' or levels=0")
            rows = ids[offsets[chosen][:, None] + np.arange(size)]
            of = values[first + chosen]
            for value in np.unique(of).tolist():
                parts.setdefault((DIMENSION[shape[0]], value), []).append(
                    (kind, first + chosen[of == value], rows[of == value]))
        first += len(offsets) - 1
    labels = {key: str(known.get(key, known.get(key[1])) or (DIMENSIONS[key[0]] if groups is None else f"{groups}_{key[1]}"))
              for key in parts}
    blocks = []
    for dimension, value in sorted(parts):
        name = labels[dimension, value]
        if list(labels.values()).count(name) > 1 and groups is not None:
            name += f"_{DIMENSIONS[dimension]}"
        group = Group(dimension, numbers[value], name)
        blocks += [Block(group, *part) for part in parts[dimension, value]]
    return blocks


def write(mesh, name, groups=None, names=None):
    """What write_solver_mesh does."""
    from . import meshes

    data = meshes.to_vtk(mesh)
    name = os.fspath(name)
    write_format = WRITERS.get(os.path.splitext(name)[1].lower())
    if not write_format:
        raise ValueError(f"{name!r} ends with none of {', '.join(WRITERS)}")
    if not hasattr(data, "GetCells") and not hasattr(data, "GetPolys"):
        raise ValueError(f"a {data.GetClassName()} cannot be written for a solver: give one mesh with points and cells")
    if not data.GetNumberOfCells():
        raise ValueError("there are no cells for a solver")
    points = numpy_support.vtk_to_numpy(data.GetPoints().GetData())
    write_format(name, points, find_groups(data, groups, names), data)


def element_of(table, block, ending):
    """The element of a solver for the cells of a block, and their rows in its order."""
    shape = shape_of(block.kind, block.rows.shape[1])
    if shape not in table:
        raise ValueError(f"cell {block.cells[0]} is a {shape[0]} with {block.rows.shape[1]} nodes, which {ending} does not "
                         f"have: take output_cells='Quadratic', or write .msh{', .exo' if shape in EXODUS else ''}")
    element, order = table[shape]
    return element, block.rows if order is None else block.rows[:, order]


@contextlib.contextmanager
def whole_file(name):
    """The name of a file beside the one of this name, which gets this name when it is whole."""
    folder = os.path.dirname(name) or "."
    if not os.path.isdir(folder):
        raise FileNotFoundError(f"there is no folder {folder!r}")
    part = os.path.join(folder, f".part-{os.getpid()}-{os.path.basename(name)}")
    try:
        yield part
        os.replace(part, name)
    finally:
        if os.path.exists(part):
            os.remove(part)


def digits(points):
    """How numbers are written so that they are the same when they are read."""
    return "%.17g" if points.dtype == np.float64 else "%.9g"


def all_groups(blocks):
    return sorted({block.group for block in blocks})


# ------------------------------------------------------------ CalculiX, Abaqus


def write_inp(name, points, blocks, _):
    elements = [None if block.group.dimension == 0 else element_of(CALCULIX, block, ".inp") for block in blocks]
    labels = set_labels(all_groups(blocks))
    with whole_file(name) as part, open(part, "w", encoding="utf-8") as file:
        file.write("*NODE, NSET=NODES\n")
        for node, place in enumerate(points.tolist(), 1):
            file.write(f"{node}, {', '.join(map(short, place))}\n")
        for block, element in zip(blocks, elements):
            if not element:  # a solver has no element for a vertex
                continue
            file.write(f"*ELEMENT, TYPE={element[0]}, ELSET={labels[block.group]}\n")
            rows = np.column_stack([block.cells, element[1]]) + 1
            # A line has 16 numbers at most.
            fmt = ",".join(rows.shape[1] * ["%d"])
            if rows.shape[1] > 16:
                fmt = ",".join(16 * ["%d"]) + ",\n" + ",".join((rows.shape[1] - 16) * ["%d"])
            np.savetxt(file, rows, fmt=fmt)
        for group in all_groups(blocks):
            nodes = np.unique(np.concatenate([block.rows.ravel() for block in blocks if block.group == group])) + 1
            file.write(f"*NSET, NSET={labels[group]}\n")
            lines = (",".join(map(str, nodes[i:i + 16].tolist())) for i in range(0, len(nodes), 16))
            file.write(",\n".join(lines) + "\n")


def short(value):
    """A number in 20 characters at most, as CalculiX reads them: all digits, unless its exponent takes their place."""
    text = repr(value)
    return text if len(text) <= 20 else f"{value:.12e}"


def set_labels(groups):
    """Names of sets: letters, digits and _, one for each group."""
    labels = {}
    for group in groups:
        label = re.sub(r"[^A-Za-z0-9_]", "_", group.name)
        label = label if label[:1].isalpha() else f"Set_{label}"
        taken = {one.upper() for one in labels.values()}
        labels[group] = label if label.upper() not in taken else f"{label}_{DIMENSIONS[group.dimension]}_{group.number}"
    return labels


# ------------------------------------------------------------ Gmsh


def write_msh(name, points, blocks, data):
    found = []
    for block in blocks:
        shape = shape_of(block.kind, block.rows.shape[1])
        if shape[1] != "edges" and shape[1] > len(GMSH[shape[0]]):
            raise ValueError(f"cell {block.cells[0]} is a {shape[0]} of order {shape[1]}; Gmsh goes up to "
                             f"{len(GMSH[shape[0]])}")
        number, order = gmsh_type(shape, block.kind, block.rows.shape[1])
        found.append((number, block.rows[:, list(order)]))
    entities, owner = find_entities(points, blocks)
    real = digits(points)
    with whole_file(name) as part, open(part, "w", encoding="utf-8") as file:
        file.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n")
        groups = all_groups(blocks)
        file.write(f"$PhysicalNames\n{len(groups)}\n")
        for group in groups:
            file.write(f'{group.dimension} {group.number} "{group.name}"\n')
        file.write("$EndPhysicalNames\n$Entities\n")
        file.write(" ".join(str(sum(one[0] == dimension for one in entities)) for dimension in range(4)) + "\n")
        for (dimension, tag), (group, nodes) in entities.items():
            at = points[nodes].min(axis=0).tolist() + (points[nodes].max(axis=0).tolist() if dimension else [])
            file.write(f"{tag} {' '.join(real % x for x in at)} 1 {group.number}{' 0' if dimension else ''}\n")
        file.write(f"$EndEntities\n$Nodes\n{len(np.unique(owner))} {len(points)} 1 {len(points)}\n")
        for index, (dimension, tag) in enumerate(entities):
            nodes = np.flatnonzero(owner == index)
            if len(nodes):
                file.write(f"{dimension} {tag} 0 {len(nodes)}\n")
                np.savetxt(file, nodes + 1, fmt="%d")
                np.savetxt(file, points[nodes], fmt=real)
        count = data.GetNumberOfCells()
        file.write(f"$EndNodes\n$Elements\n{sum(max(len(b.cells), 1) if b.group.dimension == 0 else 1 for b in blocks)} "
                   f"{count} 1 {count}\n")
        points_seen = 0
        for block, (number, rows) in zip(blocks, found):
            rows = np.column_stack([block.cells, rows]) + 1
            if block.group.dimension == 0:  # an entity for each vertex
                for row in rows:
                    points_seen += 1
                    file.write(f"0 {points_seen} {number} 1\n{row[0]} {row[1]}\n")
                continue
            file.write(f"{block.group.dimension} {block.group.number} {number} {len(rows)}\n")
            np.savetxt(file, rows, fmt="%d")
        file.write("$EndElements\n")
        for what, arrays in (("NodeData", data.GetPointData()), ("ElementData", data.GetCellData())):
            for title, values in data_arrays(arrays).items():
                write_view(file, what, title, values)


def find_entities(points, blocks):
    """Entities of Gmsh, one for each group and for each vertex, with their nodes; and which one each node belongs to, of the
    lowest dimension that has it."""
    entities = {}
    for block in blocks:
        group = block.group
        for row in block.rows if group.dimension == 0 else [block.rows.ravel()]:
            tag = len(entities) + 1 if group.dimension == 0 else group.number
            before = entities.get((group.dimension, tag), (group, np.zeros(0, int)))[1]
            entities[group.dimension, tag] = group, np.concatenate([before, row])
    owner = np.full(len(points), len(entities) - 1)
    for index, (_, nodes) in reversed(list(enumerate(entities.values()))):
        owner[nodes] = index
    return entities, owner


def write_view(file, what, name, values):
    """Values of nodes or elements. Gmsh has numbers, vectors and tensors."""
    values = values.reshape(len(values), -1) if len(values) else values
    if values.dtype.kind not in "buif" or values.ndim != 2 or values.shape[1] not in (1, 3, 9) or name.startswith("gmsh:"):
        return
    file.write(f'${what}\n1\n"{name}"\n1\n0\n3\n0\n{values.shape[1]}\n{len(values)}\n')
    np.savetxt(file, np.column_stack([np.arange(1, len(values) + 1), values]),
               fmt="%d" + values.shape[1] * (" " + ("%.9g" if values.dtype == np.float32 else "%.17g")))
    file.write(f"$End{what}\n")


# ------------------------------------------------------------ Exodus


def write_exodus(name, points, blocks, data):
    try:
        netcdf = importlib.import_module("netCDF4")
    except ImportError:
        raise ValueError(f"{name!r} cannot be written: netCDF4, which writes Exodus, is not installed") from None
    found = [element_of(EXODUS, block, ".exo") for block in blocks]
    with whole_file(name) as part, netcdf.Dataset(part, "w", format="NETCDF3_64BIT_OFFSET") as file:
        file.setncatts({"title": "SubdivisionObjects", "api_version": np.float32(5.1), "version": np.float32(5.1),
                        "floating_point_word_size": np.int32(8), "file_size": np.int32(1)})
        for key, size in (("len_string", 33), ("num_dim", 3), ("num_nodes", len(points)),
                          ("num_elem", data.GetNumberOfCells()), ("num_el_blk", len(blocks)), ("time_step", None)):
            file.createDimension(key, size)

        def put(key, values, *dimensions, kind="i4"):
            variable = file.createVariable(key, kind, dimensions)
            variable[:] = values
            return variable

        put("time_whole", [0.], "time_step", kind="f8")
        for axis in range(3):
            put("coord" + "xyz"[axis], points[:, axis], "num_nodes", kind="f8")
        put("coor_names", texts(["x", "y", "z"]), "num_dim", "len_string", kind="S1")
        put("eb_status", 1, "num_el_blk")
        put("eb_prop1", block_numbers(blocks), "num_el_blk").setncattr("name", "ID")
        put("eb_names", texts([block.group.name for block in blocks]), "num_el_blk", "len_string", kind="S1")
        put("elem_num_map", np.concatenate([block.cells for block in blocks]) + 1, "num_elem")
        for index, (element, rows) in enumerate(found, 1):
            sizes = f"num_el_in_blk{index}", f"num_nod_per_el{index}"
            for key, size in zip(sizes, rows.shape):
                file.createDimension(key, size)
            put(f"connect{index}", rows + 1, *sizes).elem_type = element
        write_values(file, put, blocks, data)


def texts(names):
    return np.array([list(name.encode()[:32].ljust(33, b"\0").decode("latin-1")) for name in names], "S1")


def block_numbers(blocks):
    """The number of the group; of a group with several blocks, or in several dimensions, the next ones."""
    used, numbers = {block.group.number for block in blocks}, []
    for block in blocks:
        number = block.group.number
        numbers.append(number if number not in numbers else max(used) + 1)
        used.add(numbers[-1])
    return numbers


def write_values(file, put, blocks, data):
    """Numbers at nodes and of elements, a variable for each component."""
    order = [block.cells for block in blocks]
    for what, size, arrays in (("nod", "num_nodes", data.GetPointData()), ("elem", None, data.GetCellData())):
        columns = {}
        for name, values in data_arrays(arrays).items():
            values = values.reshape(len(values), -1) if len(values) else values
            if values.dtype.kind in "buif":
                ends = [""] if values.shape[1] == 1 else list("XYZ") if values.shape[1] == 3 else map(str, range(values.shape[1]))
                columns.update((name + end, values[:, i]) for i, end in enumerate(ends))
        if not columns:
            continue
        file.createDimension(f"num_{what}_var", len(columns))
        put(f"name_{what}_var", texts(columns), f"num_{what}_var", "len_string", kind="S1")
        for index, values in enumerate(columns.values(), 1):
            if size:
                put(f"vals_nod_var{index}", values[None], "time_step", size, kind="f8")
                continue
            for number, cells in enumerate(order, 1):
                put(f"vals_elem_var{index}eb{number}", values[cells][None], "time_step", f"num_el_in_blk{number}", kind="f8")


WRITERS = {".msh": write_msh, ".inp": write_inp, ".e": write_exodus, ".exo": write_exodus, ".ex2": write_exodus}
