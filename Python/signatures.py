# SPDX-License-Identifier: BSD-3-Clause
"""The types of the functions of the package, for editors and type checkers: the text of functions.pyi."""

import json

# What filters make of a data set; others make one of the type that they are given.
GRID = "vtkUnstructuredGrid"
TABLE = "Dict[str, NDArray[Any]]"
IMAGE = "vtkImageData"
OUTPUTS = {
    "vtkAdaptiveSurfaceSubdivision": "vtkPolyData",
    "vtkExtractDimensions": None,
    "vtkSubdivisionDeformation": None,
    "vtkSubdivisionEdit": None,
    "vtkSubdivisionLimitProbe": "vtkPolyData",
    "vtkSubdivisionMeasures": TABLE,
    "vtkSubdivisionSampler": IMAGE,
    "vtkSurfaceSubdivision": "vtkPolyData",
}
INPUTS = {
    "cells": "Optional[Cells]",
    "point_data": "Optional[Data]",
    "cell_data": "Optional[Data]",
    "texture_coordinates": "Optional[str]",
    "normals": "Optional[str]",
    "spacing": "Optional[Sequence[float]]",
    "origin": "Optional[Sequence[float]]",
    "creases": "Optional[Creases]",
}
OTHERS = {
    "array": "Optional[str]",
    "function": "Optional[vtkImplicitFunction]",
    "mesh": "Optional[AnyMesh]",
    "selection": "Optional[Selection]",
    "table": "Optional[Table]",
}
HEAD = """# Made by Python/write_functions.py from the files of Plugin. Edit those.
# mypy: disable-error-code=misc
# Where VTK has no types, its classes are Any, and overloads seem to be the same.
from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, TypedDict, TypeVar, Union, overload

from numpy.typing import NDArray
from typing_extensions import Unpack
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataObject, vtkImageData, vtkImplicitFunction, vtkMultiBlockDataSet, vtkPolyData,
    vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .arrays import Arrays, Image
from .kinds import AnyMesh, Cells, Creases, Data, Given, Progress, Selection, Table

__version__: str
__all__ = {names}

_Data = TypeVar("_Data", bound=vtkDataObject)

"""


def value_type(option):
    """The type of an argument."""
    values = ", ".join(text if text.isdigit() else json.dumps(text, ensure_ascii=False) for text, _ in option.entries)
    if option.kind in ("bool", "enum"):
        return "bool" if option.kind == "bool" else f"Literal[{values}]"
    if option.kind == "set":
        return f"Sequence[Literal[{values}]]"
    if option.kind in ("int", "id", "double"):
        one = "float" if option.kind == "double" else "int"
        return one if option.count == 1 else f"Sequence[{one}]"
    if option.kind == "strings":
        return "Sequence[str]"
    return OTHERS[option.kind]


def more_options(one):
    """The options that the signature does not have, under all of their names."""
    named = {**one.options, **{short: one.options[name] for short, name in one.aliases.items()}}
    lines = [f"    {name}: {value_type(option)}\n" for name, option in named.items() if name not in one.shown]
    return f"class _{one.name}_options(TypedDict, total=False):\n{''.join(lines) or '    pass'}\n"


def criteria_type(one):
    """One of the criteria, or several with their numbers."""
    names = f"Literal[{', '.join(map(json.dumps, one.criteria))}]"
    return f"Union[None, {names}, Mapping[{names}, Optional[float]]]"


def function(one):
    """A function with its types, for each kind of mesh."""
    front, back = one.parameters()
    keys = [f"refine: {criteria_type(one)} = ..."] if one.criteria else []
    keys += [f"{name}: {value_type(option)} = ..." for name, option in one.shown.items()]
    keys += [f"{name}: {INPUTS[name]} = ..." for name in back]
    keys += ["progress: Progress = ...", f"**options: Unpack[_{one.name}_options]"]
    output = OUTPUTS.get(one.filter.cls, GRID)
    # A list comes out as one, of a filter what it makes.
    kinds = [
        ("Given", "Arrays"),
        ("vtkCompositeDataSet", "vtkMultiBlockDataSet"),
        ("vtkDataObject", output),
        ("Sequence[vtkDataObject]", f"List[{output}]"),
        ("vtkAlgorithm", f"Union[{output}, vtkMultiBlockDataSet]"),
    ]
    if not front:
        kinds = [(None, GRID)]
    elif output is None:
        kinds = [("Given", "Arrays"), ("_Data", "_Data"), ("Sequence[_Data]", "List[_Data]"), ("vtkAlgorithm", "vtkDataObject")]
    elif output == TABLE:
        kinds = [("AnyMesh", TABLE)]
    elif output == IMAGE:
        kinds = [("Given", "Image"), ("vtkDataObject", IMAGE), ("vtkAlgorithm", IMAGE)]
    made = more_options(one)
    for given, found in kinds:
        first = [f"mesh: {given}" if name == "mesh" else f"{name}: {INPUTS[name]} = ..." for name in front]
        arguments = "".join(f"    {argument},\n" for argument in first + ["*"] + keys[:-1]) + f"    {keys[-1]}\n"
        made += ("@overload\n" if len(kinds) > 1 else "") + f"def {one.name}(\n{arguments}) -> {found}: ...\n"
    return made + "\n"


def text(functions, names):
    return HEAD.replace("{names}", repr(names)) + "".join(map(function, functions))
