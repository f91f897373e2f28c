# SPDX-License-Identifier: BSD-3-Clause
"""The types of the functions of the package, for editors and type checkers: the text of functions.pyi."""

import json

# What filters make of a data set; others make one of the type that they are given.
GRID = "vtkUnstructuredGrid"
OUTPUTS = {
    "vtkAdaptiveSurfaceSubdivision": "vtkPolyData",
    "vtkExtractDimensions": None,
    "vtkSubdivisionDeformation": None,
    "vtkSubdivisionLimitProbe": "vtkPolyData",
    "vtkSurfaceSubdivision": "vtkPolyData",
}
INPUTS = {
    "cells": "Any",
    "point_data": "Optional[Mapping[str, Any]]",
    "cell_data": "Optional[Mapping[str, Any]]",
    "texture_coordinates": "Optional[str]",
    "normals": "Optional[str]",
    "spacing": "Optional[Sequence[float]]",
    "origin": "Optional[Sequence[float]]",
    "creases": "Any",
}
HEAD = """# Made by Python/write_functions.py from the files of Plugin. Edit those.
# mypy: disable-error-code=misc
# Where VTK has no types, its classes are Any, and overloads seem to be the same.
from os import PathLike
from typing import Any, Callable, Literal, Mapping, Optional, Sequence, Tuple, TypedDict, TypeVar, Union, overload

from numpy.typing import ArrayLike
from typing_extensions import Unpack
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataObject, vtkImplicitFunction, vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid)

from .arrays import Arrays

__version__: str
__all__ = {names}

_Data = TypeVar("_Data", bound=vtkDataObject)
_Given = Union[ArrayLike, Tuple[ArrayLike, Any], Arrays, str, PathLike[str]]
_Progress = Union[None, bool, Callable[[float], Any]]
_Criteria = Union[None, str, Mapping[str, Any]]

"""


def value_type(option):
    """The type of an argument."""
    values = ", ".join(json.dumps(text, ensure_ascii=False) for text, _ in option.entries)
    if option.kind in ("bool", "enum"):
        return "bool" if option.kind == "bool" else f"Literal[{values}]"
    if option.kind == "set":
        return f"Sequence[Literal[{values}]]"
    if option.kind in ("int", "id", "double"):
        one = "float" if option.kind == "double" else "int"
        return one if option.count == 1 else f"Sequence[{one}]"
    if option.kind == "strings":
        return "Sequence[str]"
    return {"array": "Optional[str]", "function": "Optional[vtkImplicitFunction]"}.get(option.kind, "Any")


def more_options(one):
    """The options that the signature does not have, under all of their names."""
    named = {**one.options, **{short: one.options[name] for short, name in one.aliases.items()}}
    lines = [f"    {name}: {value_type(option)}\n" for name, option in named.items() if name not in one.shown]
    return f"class _{one.name}_options(TypedDict, total=False):\n{''.join(lines) or '    pass'}\n"


def function(one):
    """A function with its types, for each kind of mesh."""
    front, back = one.parameters()
    keys = ["refine: _Criteria = ..."] if one.criteria else []
    keys += [f"{name}: {value_type(option)} = ..." for name, option in one.shown.items()]
    keys += [f"{name}: {INPUTS[name]} = ..." for name in back]
    keys += ["progress: _Progress = ...", f"**options: Unpack[_{one.name}_options]"]
    output = OUTPUTS.get(one.filter.cls, GRID)
    # What is none of these is Any: a list of data sets, a filter, a mesh of meshio or PyVista.
    kinds = [
        ("_Given", "Arrays"),
        ("vtkCompositeDataSet", "vtkMultiBlockDataSet"),
        ("vtkDataObject", output),
        ("Any", "Any"),
    ]
    if not front:
        kinds = [(None, GRID)]
    if output is None:
        kinds = [("_Given", "Arrays"), ("_Data", "_Data"), ("Any", "Any")]
    made = more_options(one)
    for given, found in kinds:
        first = [f"mesh: {given}" if name == "mesh" else f"{name}: {INPUTS[name]} = ..." for name in front]
        arguments = "".join(f"    {argument},\n" for argument in first + ["*"] + keys[:-1]) + f"    {keys[-1]}\n"
        made += ("@overload\n" if front else "") + f"def {one.name}(\n{arguments}) -> {found}: ...\n"
    return made + "\n"


def text(functions, names):
    return HEAD.replace("{names}", repr(names)) + "".join(map(function, functions))
