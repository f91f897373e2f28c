# SPDX-License-Identifier: BSD-3-Clause
"""What functions return where the mesh was given as arrays or as a file. NumPy is loaded when it is needed."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, Union

if TYPE_CHECKING:
    import numpy as np
    from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkUnstructuredGrid

    from .kinds import AnyMesh, Mesh

    Samples = Dict[str, np.ndarray[Any, Any]]
else:
    Samples = dict

# Of cells that are one array: by the number of points that its rows have.
TYPES_BY_SIZE = {1: "vertex", 2: "line", 3: "triangle", 4: "tetra"}


class Arrays(tuple):
    """Points and cells of a mesh: points, cells = arrays.

    `points` has three columns. `cells` has a row of point ids for each cell if all are vertices, lines, triangles or
    tetrahedra. Else it is a dictionary of such arrays, by "vertex", "line", "triangle", "tetra", "quad", "hexahedron",
    "wedge", "pyramid", and "polygonN" for polygons of N points, so that no quad is taken for a tetrahedron.
    `point_data` and `cell_data` are dictionaries of arrays, of numbers and of texts; the cells follow each other as in
    `cells`. `field_data` has arrays of any lengths, of the mesh as a whole. `attributes` has the names of the arrays of
    points that are "texture_coordinates" and "normals", if there are any.

    `save` writes a file, `to_vtk` and `to_meshio` give the mesh of other packages.
    """

    points: np.ndarray[Any, Any]
    cells: Union[np.ndarray[Any, Any], Dict[str, np.ndarray[Any, Any]]]
    point_data: Dict[str, np.ndarray[Any, Any]]
    cell_data: Dict[str, np.ndarray[Any, Any]]
    field_data: Dict[str, np.ndarray[Any, Any]]
    attributes: Dict[str, str]

    def __new__(
        cls,
        points: np.ndarray[Any, Any],
        cells: Union[np.ndarray[Any, Any], Dict[str, np.ndarray[Any, Any]]],
        point_data: Dict[str, np.ndarray[Any, Any]],
        cell_data: Dict[str, np.ndarray[Any, Any]],
        field_data: Optional[Dict[str, np.ndarray[Any, Any]]] = None,
        attributes: Optional[Dict[str, str]] = None,
    ) -> Arrays:
        made = super().__new__(cls, (points, cells))
        made.points, made.cells, made.point_data, made.cell_data = points, cells, point_data, cell_data
        made.field_data, made.attributes = field_data or {}, attributes or {}
        return made

    def __getnewargs__(self) -> Tuple[object, ...]:
        """For copy and pickle: what __new__ takes."""
        return self.points, self.cells, self.point_data, self.cell_data, self.field_data, self.attributes

    def __repr__(self) -> str:
        """How many points and cells there are, and the names of arrays."""
        parts = [f"{len(self.points)} points"] + [f"{len(rows)} {name}" for name, rows in self.cells_by_type().items()]
        for what in ("point_data", "cell_data", "field_data"):
            if getattr(self, what):
                parts.append(f"{what} {', '.join(map(str, getattr(self, what)))}")
        return f"<Arrays: {'; '.join(parts)}>"

    def cells_by_type(self) -> Dict[str, np.ndarray[Any, Any]]:
        """The cells as a dictionary of rows, also where they are of one type."""
        if isinstance(self.cells, dict):
            return self.cells
        return {TYPES_BY_SIZE[self.cells.shape[1]]: self.cells} if len(self.cells) else {}

    def save(self, name: Union[str, os.PathLike[str]], groups: Optional[str] = None) -> None:
        """Writes a file in the format of its ending: .vtu, .vtp, .vtk, .stl, .ply, .obj, those of `write_solver_mesh`
        (.msh, .inp, .exo), by whose `groups` cells are named, and those of meshio where it is installed. Of solids .vtp, .stl,
        .ply and .obj get the outside."""
        from . import files

        files.save(self, name, groups)

    def to_vtk(self) -> Union[vtkUnstructuredGrid, vtkPolyData]:
        """The same as a vtkUnstructuredGrid; points without cells are a vtkPolyData."""
        from . import meshes

        return meshes.to_vtk(self)

    def to_meshio(self) -> Mesh:
        """The same as a meshio.Mesh."""
        from . import files

        return files.to_meshio(self)


class Image(Samples):
    """Arrays of an image by name, as a dictionary: image["Material"][k, j, i] is the sample at origin + spacing * (i, j, k).

    Arrays of several components have a last axis for them. `origin` and `spacing` have three numbers each, along x, y and
    z. `scalars` is the name of the array that volume rendering shows first, `materials` has those of the components of
    "Coverage". `save` writes a file, `to_vtk` gives the image of VTK.
    """

    def __init__(
        self, arrays: Samples, origin: Tuple[float, ...], spacing: Tuple[float, ...], scalars: Optional[str] = None,
        materials: Tuple[str, ...] = ()
    ) -> None:
        super().__init__(arrays)
        self.origin, self.spacing, self.scalars, self.materials = origin, spacing, scalars, materials

    def __repr__(self) -> str:
        """How many samples there are along x, y and z, and the names of arrays."""
        shape = next(iter(self.values())).shape[2::-1] if self else (0, 0, 0)
        return f"<Image: {' x '.join(map(str, shape))} samples; {', '.join(self)}>"

    def save(self, name: Union[str, os.PathLike[str]]) -> None:
        """Writes a .vti or .vtk file, or .vdb where VTK has OpenVDB."""
        from . import files

        files.save_image(self, name)

    def save_slices(self, folder: Union[str, os.PathLike[str]], dither: bool = False) -> None:
        """Writes a picture for each layer and material, as printers read them, as `subdivide sample --slices` does:
        layer00000_material3.png and so on, without a material layer00000.png, and slices.json with the size and place of
        pixels. Pixels are 255 inside, "Coverage" makes those of boundaries grey or, with `dither`, black and white as
        often as they are covered. The first row has the largest y."""
        from . import slices

        slices.save(self, folder, dither)

    def to_vtk(self) -> vtkImageData:
        """The same as a vtkImageData."""
        from . import meshes

        return meshes.from_image(self)


def write_solver_mesh(
    mesh: AnyMesh,
    name: Union[str, os.PathLike[str]],
    groups: Optional[str] = None,
    names: Optional[Dict[int, str]] = None,
) -> None:
    """Writes a mesh for a solver, by the ending of the name: .msh (Gmsh, version 4.1), .inp (CalculiX and Abaqus), or
    .e, .exo, .ex2 (Exodus, needs netCDF4).

    Node i + 1 of the file is point i of the mesh, and element i + 1 is cell i, so that results can be put beside points
    and cells. `groups` names a cell array of whole numbers, such as MaterialId: cells with the same number and dimension are
    a physical group, an ELSET with its NSET, or blocks of elements. `names` is a dictionary from these numbers to names.
    Else names are those in field data, as of a mesh from Gmsh, or MaterialId_1. Without `groups` they are points,
    curves, surfaces and solids.

        smooth = subdivide("part.vtu", output_cells="Quadratic")
        write_solver_mesh(smooth, "part.inp", groups="MaterialId", names={1: "Steel"})
    """
    from . import solvers

    solvers.write(mesh, name, groups, names)
