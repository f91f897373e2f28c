# SPDX-License-Identifier: BSD-3-Clause
"""Subdivision of a mesh whose values change. NumPy is loaded when it is needed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Union, overload

from . import limits, matrices
from .arrays import Arrays
from .run import FILTERS, execute, find_filter, prepare

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike
    from vtkmodules.vtkCommonDataModel import vtkPointSet

    from .kinds import AnyMesh, Cells, Data

# The name of values that are given without one.
VALUES = "Values"


class Subdivider:
    """Subdivides a mesh once, and then only values at its points: those of another time step, or moved points.

        smooth = Subdivider(points, cells, levels=3)
        fine_values = smooth.apply(values)
        smooth.apply({"T": values}).save("step7.vtu")

    mesh, cells and options are those of `subdivide`, or of another function, such as
    `Subdivider(points, quads, function="surface_subdivision", scheme="catmull-clark")`. The result is `mesh`, and its
    parts are `points`, `cells`, `point_data` and `cell_data`.
    """

    def __init__(
        self, mesh: AnyMesh, cells: Optional[Cells] = None, *, function: Union[str, Callable[..., object]] = "subdivide", **options: Any
    ) -> None:
        from . import meshes

        self._filter = find_filter(function)
        able = [one.name for one in FILTERS.values() if one.has("SetCacheOperator")]
        if self._filter.name not in able:
            raise ValueError(f"{self._filter.name} keeps no operator: function is one of {', '.join(able)}")
        self._progress = options.pop("progress", None)
        self._ready = prepare(self._filter, {"mesh": mesh, "cells": cells, **options})
        self._input = self._ready.made.GetInputDataObject(0, 0)
        if not hasattr(self._input, "GetPoints"):
            raise ValueError("the mesh is a list of blocks: give one mesh")
        output = execute(self._filter, self._ready, self._progress)
        self.mesh: Arrays = meshes.to_arrays(output, self._ready.forms)

    def __repr__(self) -> str:
        return f"<Subdivider: {self._filter.name}, {self._input.GetNumberOfPoints()} points to {self.mesh!r}>"

    @property
    def points(self) -> np.ndarray[Any, Any]:
        return self.mesh.points

    @property
    def cells(self) -> Union[np.ndarray[Any, Any], Dict[str, np.ndarray[Any, Any]]]:
        return self.mesh.cells

    @property
    def point_data(self) -> Dict[str, np.ndarray[Any, Any]]:
        return self.mesh.point_data

    @property
    def cell_data(self) -> Dict[str, np.ndarray[Any, Any]]:
        return self.mesh.cell_data

    @overload
    def apply(self, values: Data) -> Arrays:
        ...

    @overload
    def apply(self, values: ArrayLike) -> np.ndarray[Any, Any]:
        ...

    def apply(self, values: Union[Data, ArrayLike]) -> Union[Arrays, np.ndarray[Any, Any]]:
        """What becomes of values at the points of the input: an array with a number or a row of numbers for each point
        gives the array at the fine points, a dictionary of arrays by name the fine mesh with these arrays.

        The points of the input are such values, too: `apply(moved)` gives the fine points of the moved mesh. As in
        `point_data` whole numbers are not smoothed: give floating point numbers.
        """
        from . import meshes

        named = dict(values) if hasattr(values, "items") else {VALUES: values}
        forms: Dict[str, object] = {}
        made = self._ready.made
        made.SetInputDataObject(0, self._with_values(named, forms))
        try:
            output = execute(self._filter, self._ready, self._progress)
        finally:
            made.SetInputDataObject(0, self._input)
        found = meshes.data_arrays(output.GetPointData(), forms)
        if not hasattr(values, "items"):
            return found[VALUES]
        made = self.mesh
        return Arrays(made.points, made.cells, {name: found[name] for name in named}, made.cell_data, made.field_data)

    def _with_values(self, named: Dict[str, ArrayLike], forms: Dict[str, object]) -> vtkPointSet:
        """The input with these values in the place of others at points that choose no rules."""
        from . import meshes

        data = self._input.NewInstance()
        data.ShallowCopy(self._input)
        arrays = data.GetPointData()
        # Arrays that are ids, ghosts or chosen by an option make rules: they stay.
        rules = {self._ready.values[name] for name, one in self._filter.options.items() if one.kind == "array"}
        for index in reversed(range(arrays.GetNumberOfArrays())):
            name = arrays.GetArrayName(index)
            if arrays.IsArrayAnAttribute(index) < 0 and name not in rules and name != meshes.GHOSTS:
                arrays.RemoveArray(index)
        for name, one in named.items():
            arrays.AddArray(meshes.to_array(name, one, data.GetNumberOfPoints(), "points", forms))
        return data

    def matrix(self) -> matrices.Rows:
        """The operator as a sparse matrix, a row for each fine point and a column for each point of the input; its
        `to_scipy()` is a scipy.sparse.csr_matrix."""
        return matrices.operator_matrix(self._ready.made)

    def evaluate(self, cells: ArrayLike, parameters: ArrayLike) -> Arrays:
        """The limit at places of cells of the input: see `evaluate_limit`."""
        return limits.evaluate_limit(self._ready.made, cells, parameters)
