# SPDX-License-Identifier: BSD-3-Clause
"""The filters, sources and options that the .xml files of this folder describe, for the programs that write the
command line and the functions of Python from them. The files are given after CMake pasted what they share."""

import re
import textwrap
import xml.etree.ElementTree as ElementTree

# Shorter names of options.
ALIASES = {"NumberOfLevels": "Levels", "VolumeScheme": "Scheme", "MaximumNumberOfCells": "MaximumCells",
           "OutputDimensions": "Dimensions"}


# Filters of VTK that messages name, and their names in the menus of ParaView.
VTK_FILTERS = {"vtkCleanPolyData": "Clean", "vtkDataSetSurfaceFilter": "Extract Surface",
               "vtkDataSetTriangleFilter": "Tetrahedralize", "vtkRedistributeDataSetFilter": "Redistribute DataSet",
               "vtkStaticCleanUnstructuredGrid": "Clean to Grid", "vtkTriangleFilter": "Triangulate"}


# Data sets and cells of VTK that messages name by their classes, as who sees no classes calls them.
CELLS = ("Vertex PolyVertex Line PolyLine Triangle TriangleStrip Polygon Pixel Quad Tetra Voxel Hexahedron Wedge Pyramid "
         "PentagonalPrism HexagonalPrism QuadraticEdge QuadraticTriangle QuadraticQuad QuadraticPolygon QuadraticTetra "
         "QuadraticHexahedron QuadraticWedge QuadraticPyramid BiQuadraticQuad TriQuadraticHexahedron TriQuadraticPyramid "
         "QuadraticLinearQuad QuadraticLinearWedge BiQuadraticQuadraticWedge BiQuadraticQuadraticHexahedron "
         "BiQuadraticTriangle CubicLine ConvexPointSet Polyhedron EmptyCell").split() + [
    kind + cell for kind in ("Lagrange", "Bezier")
    for cell in ("Curve", "Triangle", "Quadrilateral", "Tetra", "Hexahedron", "Wedge")]


def split(name, between):
    """NumberOfLevels as number-of-levels or number_of_levels."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", between, name).replace("-", between).lower()


def paragraphs(text):
    """A text of the files as paragraphs, each of which is one line."""
    return [" ".join(part.split()) for part in re.split(r"\n\s*\n", text.strip())]


class Option:
    """One property. `kind` says what its value is:

    bool, enum (one of `entries`), int, id (of 64 bits), double: `count` numbers;
    set: some of `entries`; strings: names;
    array: the name of an array; function: an implicit function;
    mesh, selection, table: the input at `port`.
    """

    def __init__(self, element):
        self.name = element.get("name")
        self.label = element.get("label") or self.name
        # Panels show numbers of 64 bits as doubles only.
        self.command, self.is_id = re.subn("AsDouble$", "", element.get("command"))
        self.clean_command = element.get("clean_command")
        self.hidden = element.get("unused") == "1"  # programs have all others, also those that panels leave out
        self.help = " ".join(paragraphs(element.findtext("Documentation", "")))
        entries = [(entry.get("text"), int(entry.get("value")), entry.get("spelling")) for entry in element.iter("Entry")]
        self.entries = [(text, value) for text, value, spelling in entries if not spelling]
        self.spellings = [(text, value) for text, value, spelling in entries if spelling]
        self.port = int(element.get("port_index", 0))
        self.count = int(element.get("number_of_elements") or 1)
        self.default = (element.get("default_values") or "").split(element.get("default_values_delimiter"))
        self.types = [entry.get("value") for entry in element.iter("DataType")]
        self.shown_with = {one.get("property") for one in element.iter("PropertyWidgetDecorator")}
        self.advanced = element.get("panel_visibility") in ("advanced", "never")
        self.kind = self.find_kind(element)
        if self.kind == "array":
            # Index, port, connection, association; points where the user says which.
            self.index, self.port, _, self.association = [int(part) for part in self.default[:4] + ["0"] * 3][:4]

    def find_kind(self, element):
        if element.tag == "InputProperty":
            return {"vtkSelection": "selection", "vtkTable": "table"}.get(self.types[0], "mesh")
        if element.tag == "ProxyProperty":
            return "function"
        if element.tag == "StringVectorProperty":
            return "array" if self.command == "SetInputArrayToProcess" else "strings"
        if self.entries:
            return "set" if element.get("repeat_command") else "enum"
        if element.find("BooleanDomain") is not None:
            return "bool"
        return {"IntVectorProperty": "int", "DoubleVectorProperty": "id" if self.is_id else "double"}[element.tag]

    @property
    def shown(self):
        """What the panel shows."""
        return self.label if self.label != self.name else re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", self.name)

    @property
    def alias(self):
        """A shorter name, or what the panel shows."""
        shown = re.sub(r"\W", "", self.label)
        return ALIASES.get(self.name, shown if shown != self.name else "")


class Filter:
    """A proxy of a class that can be made: a filter, or a source, which has no input."""

    def __init__(self, element):
        self.name = element.get("name")
        self.cls = element.get("class")
        self.label = element.get("label")
        documentation = element.find("Documentation")
        self.short_help = documentation.get("short_help")
        self.help = paragraphs(documentation.text)
        made = [Option(child) for child in element if child.get("command")]
        inputs = [option for option in made if option.command == "SetInputConnection"]
        self.has_input = any(option.port == 0 for option in inputs)
        self.takes_image = any(option.port == 0 and option.types[0] == "vtkImageData" for option in inputs)
        self.options = [option for option in made if not option.hidden and
                        not (option in inputs and option.port == 0)]
        # The title of the part of the panel that each property is in.
        self.groups = {one.get("name"): group.get("label") for group in element.iter("PropertyGroup")
                       for one in group.iter("Property")}

    @property
    def short_name(self):
        """Without what all of them have in common."""
        return re.sub(r"^Subdivision(?=[A-Z])|Source$", "", self.name)

    def in_words(self, text, name):
        """A text of the panel, in which `name` gives the options the names that an interface has."""
        known = {said: name(other) for other in self.options for said in (other.name, other.shown)
                 if re.search("[a-z0-9 ][A-Z]", said)}
        words = "|".join(map(re.escape, sorted(known, key=len, reverse=True)))
        return re.sub(rf"\b(?:{words})\b", lambda found: known[found[0]], text) if known else text

    def criteria(self):
        """Of each option RefineByX the number that belongs to it, if any: the first that panels show with it."""
        found, last = {}, None
        for option in self.options:
            if option.name.startswith("RefineBy"):
                last = option.name
                found[last] = None
            elif last in option.shown_with and option.kind == "double" and not found[last]:
                found[last] = option.name
        return found


def read(paths):
    """All filters and sources of the files, by name."""
    proxies = [element for path in paths for element in ElementTree.parse(path).getroot().iter("SourceProxy")]
    return sorted(map(Filter, proxies), key=lambda one: one.name)


def words(one, filters, name, classes):
    """What messages of a filter say, and what an interface says instead. `name` gives its name of an option, `classes`
    has its names of classes; cells, and filters of the project are added by what `name` gives."""
    made = {other.cls: name(other) for other in sorted(filters, key=lambda other: other.has_input)}
    made.update({f"vtk{cell}": split(cell, " ") for cell in CELLS}, **classes)
    for option in one.options:
        shown = name(option)
        if re.search("[a-z0-9][A-Z]", option.name):
            made[option.name] = shown
        else:  # a word like any other, which is an option in these places only
            made.update({f"{option.name} =": f"{shown} =", f"set {option.name} to": f"set {shown} to",
                         f"Set {option.name} to": f"Set {shown} to"})
        if option.kind == "array":
            made[f"array index {option.index}"] = shown
        elif option.port:
            made.update({f"input port {option.port}": shown, f"{option.name} (input port {option.port})": shown})
    return made


ESCAPES = str.maketrans({"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t", "\r": "\\r"})


def quoted(text):
    """As C++ literals, in pieces: compilers limit their lengths."""
    pieces = [text[at:at + 100] for at in range(0, len(text), 100)] or [""]
    return " ".join(f'"{piece.translate(ESCAPES)}"' for piece in pieces)


def wrap(text, width, indent=""):
    return textwrap.fill(text, width, initial_indent=indent, subsequent_indent=indent, break_long_words=False,
                         break_on_hyphens=False)
