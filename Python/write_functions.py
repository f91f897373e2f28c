# SPDX-License-Identifier: BSD-3-Clause
"""Writes the functions of the package: write_functions.py FOLDER_OF_OPTIONS.PY VERSION OUTPUT FILE.xml...

OUTPUT is functions.py; functions.pyi beside it has the types. A function shows the options that its panel shows at
once, SHOWN of them at most; the others are given by their names all the same."""

import json
import keyword
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import options  # noqa: E402
import signatures  # noqa: E402

# How many options a signature and its help have.
SHOWN = 8
WIDTH = 96

# Names of functions that are not those of the filters.
FUNCTIONS = {"multi_dimensional_subdivision": "subdivide", "sampler": "sample"}
EXAMPLES = {
    "subdivide": [
        "points, cells = subdivide(points, [[0, 1, 2, 3]], levels=3)",
        'subdivide("mesh.vtu", levels=3).save("fine.vtu")',
    ],
    "surface_subdivision": ['fine = surface_subdivision(points, quads, scheme="catmull-clark", levels=3)'],
    "adaptive_surface_subdivision": ['fine = adaptive_surface_subdivision(points, quads, refine={"curvature": 10})'],
    "red_green_refinement": ['finer = red_green_refinement("mesh.vtu", refine={"edge_length": 0.5})'],
    "extract_dimensions": ['solids = extract_dimensions("mesh.vtu", dimensions=["Solids"])'],
    "simplicial_complex_topology": ['print(simplicial_complex_topology("mesh.vtu").field_data)'],
    "cage": ["around = cage(bounds=[0, 1, 0, 1, 0, 1], number_of_cells=[2, 2, 2])"],
    "cage_around": ["around = cage_around(points)"],
    "deformation": ["bent = deformation(points, rest_mesh=rest, deformed_mesh=moved)"],
    "label_solid": ["solid = label_solid(labels, spacing=(0.5, 0.5, 1.2))"],
    "limit_probe": ['nearest = limit_probe("mesh.vtu", places=points)'],
    "measures": ['print(measures("mesh.vtu")["Measure"])'],
    "model": ['ship = model(model="Ship")'],
    "sample": ['sample("mesh.vtu", spacing=0.1).save("image.vti")'],
    "smoothness": ['print(smoothness("mesh.vtu").point_data["Failing"])'],
}

# Arguments that are no options, with their help; those of functions with a mesh, or with an image.
MESH = {
    "mesh": "a data set of VTK or PyVista, a list of them, a mesh of meshio, the name of a file, or points as an "
            "array. What comes out is given in the same way; of a file and of arrays it is Arrays.",
    "cells": "with points, rows of point ids, or a dictionary of rows by types of cells. {rows}",
}
MESH_DATA = {
    "point_data, cell_data": "with points, dictionaries of arrays by name.",
    "texture_coordinates, normals": "the names of arrays of points that are these.",
}
ROWS = {True: "Rows of four are quads.", False: "Rows of four are tetrahedra; give quads in a dictionary."}
IMAGE = {
    "mesh": "a data set of VTK or PyVista, a file, or labels as an array with the axes x, y, z: labels[i, j, k] is the "
            "voxel around origin + spacing * (i, j, k). Where slices along z come first, give labels.T. What comes out "
            "has the label of each cell in cell_data['Label'].",
}
IMAGE_DATA = {"spacing, origin": "with an array, three numbers each along x, y and z; default (1, 1, 1) and (0, 0, 0)."}
CREASES = "rows of two point ids, whose edges stay sharp; a third number is a sharpness, for so many levels only."
REFINE = "where cells are split: a criterion, or a dictionary of criteria with their numbers. They are {criteria}."
PROGRESS = "a function of the part that is done, from 0 to 1, or True for a bar of tqdm."


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


def default(option):
    """The default of an option, as a value of Python."""
    first = [text for text, value in option.entries if str(value) in option.default]
    if option.kind in ("bool", "enum", "set"):
        return {"bool": option.default == ["1"], "enum": first[0] if first else None, "set": tuple(first)}[option.kind]
    if option.kind in ("int", "id", "double"):
        numbers = tuple(float(part) if option.kind == "double" else int(part) for part in option.default)
        return numbers[0] if option.count == 1 else numbers
    return () if option.kind == "strings" else None


class Function:
    """What is written of one filter or source."""

    def __init__(self, one):
        self.filter = one
        self.name = function_name(one)
        self.options = {snake(option.name): option for option in one.options}
        self.inputs = "OF_IMAGES" if one.takes_image else "OF_MESHES" if one.has_input else "()"
        self.criteria = {snake(key[len("RefineBy"):]): (snake(key), value and snake(value))
                         for key, value in one.criteria().items()}
        self.has_creases = "crease_geometry" in self.options
        taken = {*self.options, "mesh", "cells", "point_data", "cell_data", "texture_coordinates", "normals", "spacing",
                 "origin", "creases", "refine", "progress", "options"}
        made = [(snake(option.alias), name) for name, option in self.options.items() if option.alias]
        short = [key for key, _ in made]
        self.aliases = {key: name for key, name in made if key not in taken and short.count(key) == 1 and
                        key.isidentifier() and not keyword.iskeyword(key)}
        self.short = {name: key for key, name in reversed(self.aliases.items())}
        self.shown = self.choose()

    def choose(self):
        """The options of the signature by the names there: the first that the panel shows, but for those of criteria,
        which `refine` has."""
        by_refine = {name for pair in self.criteria.values() for name in pair}
        chosen = [name for name, option in self.options.items() if not option.advanced and name not in by_refine]
        return {self.short.get(name, name): self.options[name] for name in chosen[:SHOWN]}

    def in_python(self, text):
        """What the panel says, with the names of options that the function has."""
        return self.filter.in_words(text, lambda other: self.short.get(snake(other.name), snake(other.name)))

    def parameters(self):
        """The arguments of the signature that are no options: those in front, and those behind."""
        front = list(MESH) if self.inputs == "OF_MESHES" else list(IMAGE) if self.inputs == "OF_IMAGES" else []
        data = {"OF_MESHES": MESH_DATA, "OF_IMAGES": IMAGE_DATA}.get(self.inputs, {})
        return front, [name for names in data for name in names.split(", ")] + ["creases"] * self.has_creases


def function_name(one):
    return FUNCTIONS.get(snake(one.short_name), snake(one.short_name))


def name_in_messages(one):
    return function_name(one) if isinstance(one, options.Filter) else snake(one.name)


def option_code(one, name, option):
    group = one.filter.groups.get(option.name)
    rest = [repr(option.kind), repr(option.command), f"default={default(option)!r}"]
    rest += [f"help={quoted(one.in_python(option.help))}"]
    rest += [f"group={quoted(group)}"] if group else []
    rest += [f"clean={option.clean_command!r}"] if option.clean_command else []
    rest += [f"entries={option.entries!r}"] if option.entries else []
    rest += [f"spellings={option.spellings!r}"] if option.spellings else []
    rest += [f"port={option.port}"] if option.port else []
    rest += [f"index={option.index}, association={option.association}"] if option.kind == "array" else []
    return f"        {quoted(name)}: Option(\n            {', '.join(rest)}),\n"


def table(one, filters):
    """The description of a function, by which it runs."""
    known = {**options.words(one.filter, filters, name_in_messages, {}), **WORDS}
    known.update(WORDS_OF_BOUNDS if "bounds" in one.options else WORDS_WITHOUT_BOUNDS)
    words = "".join(f"        {quoted(key)}: {quoted(value)},\n" for key, value in known.items())
    made = "".join(option_code(one, name, option) for name, option in one.options.items())
    return f"""_{one.name} = Filter(
    {quoted(one.name)}, {quoted(one.filter.label)}, {quoted(one.filter.cls)},
    {quoted(one.filter.short_help)},
    {quoted(one.in_python(chr(10).join(one.filter.help)))},
    {one.inputs},
    {{
{made}    }},
    {one.aliases!r},
    {one.criteria!r},
    {{
{words}    }})
"""


def first_sentence(text):
    """The first sentence, without an explanation in it where it is long."""
    found = re.split(r"(?<=[.!?])\s+(?=[A-Z0-9\"'])", text)[0]
    return found if len(found) < 2 * WIDTH else re.split(r"(?<=\w)[:;] ", found)[0] + "."


def documentation(one):
    """One screen: what the function does, an example, and the arguments of the signature."""
    parts = [options.wrap(one.filter.short_help, WIDTH, "    ")]
    calls = EXAMPLES.get(one.name) or [f"made = {one.name}({quoted('mesh.vtu') if one.filter.has_input else ''})"]
    parts.append("\n".join(" " * 8 + line for line in calls))
    lines = []
    if one.filter.has_input:
        lines += list((IMAGE if one.filter.takes_image else MESH).items())
    if one.criteria:
        lines.append(("refine", REFINE.format(criteria=", ".join(one.criteria))))
    for name, option in one.shown.items():
        values = ", ".join(quoted(text) for text, _ in option.entries)
        what = f" {'Some' if option.kind == 'set' else 'One'} of {values}." if values else ""
        lines.append((name, first_sentence(one.in_python(option.help)) + what))
    if one.filter.has_input:
        lines += list((IMAGE_DATA if one.filter.takes_image else MESH_DATA).items())
    lines += [("creases", CREASES)] if one.has_creases else []
    lines.append(("progress", PROGRESS))
    more = len(one.options) - len(one.shown)
    if more > 0:
        lines.append(("options", f"{more} more: options({quoted(one.name)}) lists all, "
                                 f"options({quoted(one.name)}, word) explains those that have a word."))
    rows = ROWS["Surface" in one.filter.cls]
    what, first = signatures.OUTPUTS.get(one.filter.cls), lines[0][1]
    if what == signatures.TABLE:
        lines[0] = ("mesh", first.split(" What comes out")[0] + " What comes out is a dictionary of arrays.")
    elif what == signatures.IMAGE:
        lines[0] = ("mesh", first.replace("it is Arrays", "it is an Image: arrays by name, with the axes z, y and x"))
    parts.append("\n".join(item(name, text.replace("{rows}", rows)) for name, text in lines))
    return "\n\n".join(parts).replace("\\", "\\\\").replace('"""', '\\"\\"\\"').strip()


def item(name, text):
    first, *rest = options.wrap(f"{name}: {text}", WIDTH, " " * 8).split("\n")
    return "\n".join([first[4:]] + rest)


def signature(one):
    """The arguments of a function with their defaults."""
    front, back = one.parameters()
    made = [name if name == "mesh" else f"{name}=None" for name in front] + ["*"]
    made += ["refine=None"] if one.criteria else []
    made += [f"{name}={default(option)!r}" for name, option in one.shown.items()]
    return ", ".join(made + [f"{name}=None" for name in back] + ["progress=None", "**options"])


def function(one, filters):
    return f'''{table(one, filters)}

@runs(_{one.name})
def {one.name}({signature(one)}):
    """{documentation(one)}
    """


'''


def main():
    filters = options.read(sys.argv[4:])
    functions = [Function(one) for one in filters]
    names = [one.name for one in functions]
    with open(sys.argv[3], "w", encoding="utf-8") as file:
        file.write(f'''# Made by Python/write_functions.py from the files of Plugin. Edit those.
"""A function for each filter and source, with its options as arguments."""

from .run import OF_IMAGES, OF_MESHES, Filter, Option, runs

__version__ = {sys.argv[2]!r}
__all__ = {names!r}

{"".join(function(one, filters) for one in functions)}''')
    with open(sys.argv[3] + "i", "w", encoding="utf-8") as file:
        file.write(signatures.text(functions, names))


if __name__ == "__main__":
    main()
