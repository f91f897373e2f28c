# SPDX-License-Identifier: BSD-3-Clause
"""The types of arguments, for editors and type checkers. Only these import it."""

from os import PathLike
from typing import Any, Callable, Dict, List, Literal, Mapping, Protocol, Sequence, Tuple, Union

from numpy.typing import ArrayLike, NDArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkSelection, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .arrays import Arrays

# Rows of ids: an array, a dictionary of them, or blocks as meshio has them.
Cells = Union[ArrayLike, Mapping[str, ArrayLike], Sequence[Tuple[str, ArrayLike]]]
Data = Mapping[str, ArrayLike]


class Mesh(Protocol):
    """A mesh of meshio."""

    points: NDArray[Any]
    cells: List[object]
    point_data: Dict[str, NDArray[Any]]
    cell_data: Dict[str, List[NDArray[Any]]]


# What gives arrays: arrays, a file, a mesh of meshio.
Given = Union[ArrayLike, Tuple[ArrayLike, Cells], Arrays, Mesh, str, PathLike[str]]
# PyVista's meshes are data sets of VTK.
AnyMesh = Union[Given, vtkDataObject, vtkAlgorithm, Sequence[vtkDataObject]]
Selection = Union[vtkSelection, Mapping[Literal["points", "cells"], ArrayLike]]
Table = Union[vtkTable, Data]
Creases = Union[ArrayLike, Tuple[ArrayLike, ArrayLike], Mapping[Tuple[int, int], float]]
Progress = Union[None, bool, Callable[[float], object]]
