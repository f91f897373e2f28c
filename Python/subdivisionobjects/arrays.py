# SPDX-License-Identifier: BSD-3-Clause
"""What functions return where the mesh was given as arrays or as a file. NumPy is loaded when it is needed."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, Union

if TYPE_CHECKING:
    import numpy as np
    from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

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
        points: Any,
        cells: Any,
        point_data: Dict[str, Any],
        cell_data: Dict[str, Any],
        field_data: Optional[Dict[str, Any]] = None,
        attributes: Optional[Dict[str, str]] = None,
    ) -> Arrays:
        made = super().__new__(cls, (points, cells))
        made.points, made.cells, made.point_data, made.cell_data = points, cells, point_data, cell_data
        made.field_data, made.attributes = field_data or {}, attributes or {}
        return made

    def __getnewargs__(self) -> Tuple[Any, ...]:
        """For copy and pickle: what __new__ takes."""
        return self.points, self.cells, self.point_data, self.cell_data, self.field_data, self.attributes

    def __repr__(self) -> str:
        """How many points and cells there are, and the names of arrays."""
        parts = [f"{len(self.points)} points"] + [f"{len(rows)} {name}" for name, rows in self.cells_by_type().items()]
        for what in ("point_data", "cell_data", "field_data"):
            if getattr(self, what):
                parts.append(f"{what} {', '.join(map(str, getattr(self, what)))}")
        return f"<Arrays: {'; '.join(parts)}>"

    def cells_by_type(self) -> Dict[str, Any]:
        """The cells as a dictionary of rows, also where they are of one type."""
        if isinstance(self.cells, dict):
            return self.cells
        return {TYPES_BY_SIZE[self.cells.shape[1]]: self.cells} if len(self.cells) else {}

    def save(self, name: Union[str, os.PathLike[str]]) -> None:
        """Writes a file in the format of its ending: .vtu, .vtp, .vtk, .stl, .ply, .obj, and those of meshio where it
        is installed. Of solids .vtp, .stl, .ply and .obj get the outside."""
        from . import files

        files.save(self, name)

    def to_vtk(self) -> Union[vtkUnstructuredGrid, vtkPolyData]:
        """The same as a vtkUnstructuredGrid; points without cells are a vtkPolyData."""
        from . import meshes

        return meshes.to_vtk(self)

    def to_meshio(self) -> Any:
        """The same as a meshio.Mesh."""
        from . import files

        return files.to_meshio(self)
