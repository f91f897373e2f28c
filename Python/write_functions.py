# SPDX-License-Identifier: BSD-3-Clause
"""Writes the functions of the package: write_functions.py FOLDER_OF_OPTIONS.PY VERSION OUTPUT FILE.xml..."""

import json
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import options  # noqa: E402


MESH = ["mesh: Any", "cells: Any = None", "*", "point_data: Optional[Mapping[str, Any]] = None",
        "cell_data: Optional[Mapping[str, Any]] = None", "texture_coordinates: Optional[str] = None",
        "normals: Optional[str] = None"]
MESH_HELP = (
    "mesh: a data set of VTK, also of PyVista, a list of them, a mesh of meshio, Arrays, or the points as an array. "
    "cells: with points, rows of point ids, a dictionary of such arrays by types of cells (Arrays), or a list of pairs "
    "of a type and rows. point_data, cell_data: with points, arrays by name. texture_coordinates, normals: the names of "
    "arrays of points that are these. The output is given as the input is: a data set, a list, or Arrays.")
ROWS_HELP = {True: "Rows of four are quads.", False: "Rows of four are tetrahedra; give quads in a dictionary."}
CREASES_HELP = (
    "creases: rows of two point ids, whose edges stay sharp, and as a third number of a sharpness, where they are "
    "sharp in so many levels only. It is a shorter way to crease_geometry.")
IMAGE = ["mesh: Any", "*", "spacing: Optional[Sequence[float]] = None", "origin: Optional[Sequence[float]] = None"]
IMAGE_HELP = (
    "mesh: a data set of VTK, also of PyVista, or the labels as an array of NumPy with three axes in the order x, y, "
    "z: labels[i, j, k] is the voxel around origin + spacing * (i, j, k). Where the slices along z come first, give the "
    "transpose, labels.T. spacing, origin: with an array, three numbers each along x, y and z; default (1, 1, 1) and "
    "(0, 0, 0). The output is given as the input is: a data set, or Arrays, whose cell_data['Label'] has the label of "
    "each cell.")


# What messages say for panels and pipelines, and what helps who calls functions.
SURFACE = ("Give the faces of their surface as cells (of a data set vtkmodules.vtkFiltersGeometry extracts them by "
           "vtkGeometryFilter, PyVista by extract_surface)")
SELECTION = "Give selection={'cells': ids} or {'points': ids}"
WORDS = {"input port 0": "mesh", "vtkDataObjectTree": "vtkMultiBlockDataSet",
         "Extract their surface first by vtkDataSetSurfaceFilter": SURFACE,
         "Connect a selection (input port 1)": SELECTION,
         # The same where ParaView's plugin is loaded.
         'Extract their surface first by "Extract Surface"': SURFACE, "Connect a selection (selection)": SELECTION,
         "Disconnect it to have a cage in its Bounds": "Give points, or bounds to the function cage",
         "Raise Margin": "Raise margin", "set Bounds with a volume": "give bounds with a volume to the function cage"}
# The bounds of a cage around a mesh are those of the mesh.
WORDS_WITHOUT_BOUNDS = {"Set them in ascending order, or make Margin smaller":
                        "Correct the coordinates of the mesh, or make margin smaller"}
WORDS_OF_BOUNDS = {"make Margin smaller": "make margin smaller"}


def snake(name):
    return options.split(name, "_")


def quoted(text):
    """As a literal with double quotes, as the rest of the file has them."""
    return json.dumps(text, ensure_ascii=False)


def value_type(option):
    """The type of an argument, and its default."""
    values = ", ".join(quoted(text) for text, _ in option.entries)
    first = [text for text, value in option.entries if str(value) in option.default]
    if option.kind == "bool":
        return "bool", str(option.default == ["1"])
    if option.kind == "enum":
        return f"Literal[{values}]", repr(first[0])
    if option.kind == "set":
        return f"Sequence[Literal[{values}]]", repr(tuple(first))
    if option.kind in ("int", "id", "double"):
        one = "float" if option.kind == "double" else "int"
        numbers = [float(part) if one == "float" else int(part) for part in option.default]
        return (one, repr(numbers[0])) if option.count == 1 else (f"Sequence[{one}]", repr(tuple(numbers)))
    if option.kind == "strings":
        return "Sequence[str]", "()"
    return {"array": "Optional[str]", "function": "Optional[vtkImplicitFunction]"}.get(option.kind, "Any"), "None"


def aliases(one):
    names = {option.name for option in one.options}
    return {snake(option.alias): option for option in one.options if option.alias and option.alias not in names}


def name_in_messages(one):
    return snake(one.short_name if isinstance(one, options.Filter) else one.name)


def table(one, filters):
    lines = []
    for option in one.options:
        rest = [repr(option.kind), repr(option.command)]
        rest += [f"clean={option.clean_command!r}"] if option.clean_command else []
        rest += [f"entries={option.entries!r}"] if option.entries else []
        rest += [f"spellings={option.spellings!r}"] if option.spellings else []
        rest += [f"port={option.port}"] if option.port else []
        rest += [f"index={option.index}, association={option.association}"] if option.kind == "array" else []
        lines.append(f"    {quoted(snake(option.name))}: Option({', '.join(rest)}),\n")
    known = {**options.words(one, filters, name_in_messages, {}), **WORDS}
    known.update(WORDS_OF_BOUNDS if any(option.name == "Bounds" for option in one.options) else WORDS_WITHOUT_BOUNDS)
    words = "".join(f"    {quoted(key)}: {quoted(value)},\n" for key, value in known.items())
    name = snake(one.short_name)
    return f"_{name} = {{\n{''.join(lines)}}}\n_{name}_words = {{\n{words}}}\n"


def has_creases(one):
    return any(option.name == "CreaseGeometry" for option in one.options)


def documentation(one):
    text = "\n\n".join(options.wrap(part, 112, "    ") for part in [one.short_help] + one.help)
    if one.has_input:
        mesh_help = f"{MESH_HELP} {ROWS_HELP['Surface' in one.cls]}"
        text += "\n\n" + options.wrap(IMAGE_HELP if one.takes_image else mesh_help, 112, "    ")
    if has_creases(one):
        text += "\n\n" + options.wrap(CREASES_HELP, 112, "    ")
    if one.criteria():
        text += "\n\n" + options.wrap(
            "refine: the criteria that are to be used, with their numbers or None, such as "
            "{'curvature': 10}; all others are off.", 112, "    ")
    for option in one.options:
        short = [key for key, value in aliases(one).items() if value is option]
        name = snake(option.name) + "".join(f", {key}" for key in short)
        text += "\n\n" + options.wrap(f"{name}: {option.help}", 112, "    ")
    return text.replace("\\", "\\\\").replace('"""', '\\"\\"\\"').strip()


def function(one, filters):
    name = snake(one.short_name)
    arguments = ["*"]
    if one.has_input:
        arguments = list(IMAGE if one.takes_image else MESH) + ["creases: Any = None"] * has_creases(one)
    for option in one.options:
        kind, value = value_type(option)
        arguments.append(f"{snake(option.name)}: {kind} = {value}")
    for key, option in aliases(one).items():
        arguments.append(f"{key}: Optional[{value_type(option)[0]}] = None")
    if one.criteria():
        arguments.append("refine: Union[None, str, Mapping[str, Any]] = None")
    short = {key: snake(option.name) for key, option in aliases(one).items()}
    criteria = {snake(key[len("RefineBy"):]): (snake(key), value and snake(value))
                for key, value in one.criteria().items()}
    joined = ",\n        ".join(arguments)
    return f'''{table(one, filters)}

@checked({short!r})
def {name}(
        {joined}) -> Any:
    """{documentation(one)}
    """
    return run({quoted(one.cls)}, _{name}, {short!r}, {criteria!r}, locals(), _{name}_words)


'''


def main():
    filters = options.read(sys.argv[4:])
    names = [snake(one.short_name) for one in filters]
    with open(sys.argv[3], "w", encoding="utf-8") as file:
        file.write(f'''# Made by Python/write_functions.py from the files of Plugin. Edit those.
"""A function for each filter and source, with its options as arguments."""

from __future__ import annotations

from typing import Any, Literal, Mapping, Optional, Sequence, Union

from vtkmodules.vtkCommonDataModel import vtkImplicitFunction

from .run import Option, checked, run

__version__ = {sys.argv[2]!r}
__all__ = {names!r}

{"".join(function(one, filters) for one in filters)}''')


main()
