# SPDX-License-Identifier: BSD-3-Clause
"""What all functions do: set the options of a filter, run it, and tell of its errors and warnings."""

import contextlib
import difflib
import functools
import inspect
import math
import numbers
import operator
import re
import sys
import warnings

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import vtkSubdivisionObjects


class Arrays(tuple):
    """Points and cells of a mesh: points, cells = arrays.

    `points` has three columns. `cells` has a row of point ids for each cell if all are vertices, lines, triangles or
    tetrahedra. Else it is a dictionary of such arrays, by "vertex", "line", "triangle", "tetra", "quad", "hexahedron",
    "wedge", "pyramid", and "polygonN" for polygons of N points, so that no quad is taken for a tetrahedron.
    `point_data` and `cell_data` are dictionaries of arrays, of numbers and of texts; the cells follow each other as in
    `cells`. `field_data` has arrays of any lengths, of the mesh as a whole. `attributes` has the names of the arrays of
    points that are "texture_coordinates" and "normals", if there are any.
    """

    def __new__(cls, points, cells, point_data, cell_data, field_data=None, attributes=None):
        made = super().__new__(cls, (points, cells))
        made.points, made.cells, made.point_data, made.cell_data = points, cells, point_data, cell_data
        made.field_data, made.attributes = field_data or {}, attributes or {}
        return made

    def __getnewargs__(self):
        """For copy and pickle: what __new__ takes."""
        return self.points, self.cells, self.point_data, self.cell_data, self.field_data, self.attributes


def check_texts(name, texts):
    """Refuses what VTK cannot take as a text: it would end the process."""
    try:
        "".join(texts).encode()
    except UnicodeEncodeError:
        wrong = next(text for text in texts if any("\ud800" <= character <= "\udfff" for character in text))
        raise ValueError(f"{name} has {wrong!a}, which UTF-8 cannot have: where it was bytes, such as the name of a "
                         "file, decode them by their own encoding, as in .decode('latin-1')") from None


def warn(message):
    """Warns who called the package."""
    frame, level = sys._getframe(), 1
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] in (__package__, "contextlib"):
        frame, level = frame.f_back, level + 1
    warnings.warn(message, stacklevel=level)


def is_number(value):
    return isinstance(value, numbers.Real) and not isinstance(value, bool) and not math.isnan(value)


def to_index(value):
    return None if isinstance(value, bool) else operator.index(value)


# What a number of these kinds is, and what makes one of the value of an option.
NUMBERS = {"int": ("whole number", to_index), "id": ("whole number", to_index),
           "double": ("number", lambda value: float(value) if is_number(value) else None)}


class Option:
    """An option of a filter, by the name of the argument."""

    def __init__(self, kind, command, clean=None, entries=(), spellings=(), port=0, index=0, association=0):
        self.kind = kind
        self.command = command
        self.clean = clean
        self.entries = dict(entries)
        self.spellings = dict(spellings)
        self.port = port
        self.index = index
        self.association = association

    def apply(self, made, name, value):
        if self.kind in ("mesh", "selection", "table"):
            from . import meshes  # which needs NumPy
            try:
                made.SetInputDataObject(self.port, meshes.to_selection(value, made.GetInputDataObject(0, 0))
                                        if self.kind == "selection" else
                                        {"mesh": meshes.to_vtk, "table": meshes.to_table}[self.kind](value))
            except ValueError as error:
                raise ValueError(f"{name}: {error}") from None
            return
        value = without_numpy(value)
        if self.kind in ("set", "strings"):
            self.apply_list(made, name, value)
        elif self.kind == "array":
            self.apply_array(made, name, value)
        elif self.kind == "enum":
            getattr(made, self.command)(self.entry(name, value))
        elif self.kind == "bool":
            if value not in (True, False):
                raise ValueError(f"{name} is True or False, not {value!r}")
            getattr(made, self.command)(bool(value))
        elif self.kind in NUMBERS:
            self.apply_numbers(made, name, value)
        else:
            getattr(made, self.command)(value)

    def apply_list(self, made, name, value):
        values = value if isinstance(value, (tuple, list)) else (value,)
        if self.kind == "set":
            values = [self.entry(name, one) for one in values]
        elif not all(isinstance(one, str) for one in values):
            raise ValueError(f"{name} takes names, such as ['Density'], not {value!r}")
        else:
            check_texts(name, values)
        getattr(made, self.clean)()
        for one in values:
            getattr(made, self.command)(one)

    def apply_array(self, made, name, value):
        if not isinstance(value, str):
            raise ValueError(f"{name} is the name of an array, not {value!r}; the array itself belongs to the mesh")
        check_texts(name, [value])
        data = made.GetInputDataObject(self.port, 0)
        association = self.association
        if not has_array(data, association, value) and has_array(data, 1 - association, value):
            association = 1 - association
        made.SetInputArrayToProcess(self.index, self.port, 0, association, value)

    def apply_numbers(self, made, name, value):
        what, convert = NUMBERS[self.kind]
        get = getattr(made, "Get" + self.command[3:])
        count = len(get()) if isinstance(get(), tuple) else 1
        try:
            values = tuple(map(convert, value if isinstance(value, (tuple, list)) else (value,)))
        except TypeError:
            values = ()
        if len(values) != count or None in values:
            raise ValueError(f"{name} takes {f'{count} {what}s' if count > 1 else f'a {what}'}, not {value!r}")
        try:
            getattr(made, self.command)(*values)
        except OverflowError:
            raise ValueError(f"{name}={value} is out of range") from None
        if (get() if count > 1 else (get(),)) != values:
            raise ValueError(f"{name}={value} is out of range; the nearest is {get()}")

    def entry(self, name, value):
        for text, number in (*self.entries.items(), *self.spellings.items()):
            if (value == number and not isinstance(value, bool)) or plain(value) == plain(text):
                return number
        raise ValueError(f"{name} is one of {', '.join(map(repr, self.entries))}, not {value!r}"
                         f"{nearest(value, self.entries)}")


def without_numpy(value):
    """An array or a number of NumPy as a list or a number of Python."""
    if isinstance(value, (tuple, list)):
        return [without_numpy(one) for one in value]
    return value.tolist() if hasattr(value, "tolist") else value


def nearest(name, names):
    """"; did you mean X?", with the name that is the most alike; empty if none is."""
    known = {plain(one): one for one in names}
    found = difflib.get_close_matches(plain(name), known, 1)
    return f"; did you mean {known[found[0]]}?" if found else ""


def checked(aliases):
    """Makes a function refuse an argument that does not exist, and tell the nearest, or that is given by two names."""
    def wrap(function):
        names = list(inspect.signature(function).parameters)

        @functools.wraps(function)
        def call(*args, **given):
            for name in given:
                if name not in names:
                    raise TypeError(f"{function.__name__}() has no argument {name!r}{nearest(name, names)}")
                if name in aliases and aliases[name] in given and given[name] is not None:
                    raise ValueError(f"{name} and {aliases[name]} are the same: give one of them")
            return function(*args, **given)

        return call

    return wrap


def plain(text):
    return re.sub(r"[\W_]", "", str(text)).lower()


def has_array(data, association, name):
    if isinstance(data, vtkCompositeDataSet):
        iterator = data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            if has_array(iterator.GetCurrentDataObject(), association, name):
                return True
            iterator.GoToNextItem()
        return False
    return bool(data) and bool(data.GetAttributesAsFieldData(association).HasArray(name))


def choose_criteria(criteria, refine, values):
    """Switches on what `refine` names, with its numbers, and all other criteria off."""
    for switch, _ in criteria.values():
        values[switch] = False
    if not isinstance(refine, str) and not hasattr(refine, "items"):
        raise ValueError("refine is the name of a criterion, or a dictionary such as {'curvature': 10}, not "
                         f"{refine!r}; the criteria are {', '.join(criteria)}")
    for name, number in ({refine: None} if isinstance(refine, str) else refine).items():
        if name not in criteria:
            raise ValueError(f"there is no criterion {name!r}: they are {', '.join(criteria)}"
                             f"{nearest(name, criteria)}")
        switch, option = criteria[name]
        values[switch] = True
        if number is not None:
            if not option:
                others = [f"{key}=..." for key in values if name in key and key != switch]
                raise ValueError(f"the criterion {name!r} takes no number: give None for it"
                                 f"{' and ' + ', '.join(others) if others else ''}")
            values[option] = number


def run(cls, options, aliases, criteria, values, words):
    """Runs a filter of this class with the arguments of a function, and returns its output like its input."""
    from . import meshes
    made = getattr(vtkSubdivisionObjects, cls)()
    has_mesh = "mesh" in values
    mesh = values.pop("mesh", None)
    if has_mesh and mesh is None:
        raise TypeError("mesh is None: give a data set of VTK, points and cells, or a mesh that has them")
    forms = {"point": {}, "cell": {}, "field": {}}
    data = [values.pop(key, None) for key in ("cells", "point_data", "cell_data")]
    attributes = {key: values.pop(key, None) for key in meshes.ATTRIBUTES}
    creases = values.pop("creases", None)
    for short, name in aliases.items():
        value = values.pop(short)
        values[name] = values[name] if value is None else value
    refine = values.pop("refine", None)
    if refine is not None:
        choose_criteria(criteria, refine, values)
    if "spacing" in values:
        made.SetInputDataObject(0, meshes.to_image(mesh, values.pop("spacing"), values.pop("origin")))
    elif has_mesh:
        given = meshes.to_vtk(mesh, *data, of_surfaces="Surface" in cls, forms=forms)
        made.SetInputDataObject(0, meshes.with_attributes(given, attributes))
    # Arrays belong to inputs, which come first.
    for name in sorted(values, key=lambda name: options[name].kind == "array"):
        if values[name] is not None:
            options[name].apply(made, name, values[name])
    if creases is not None:
        set_creases(made, options, values, creases)
    with listen_to(made, words) as told:
        made.Update()
    output = made.GetOutputDataObject(0)
    # With these options nothing may come out of a mesh that is right.
    chosen = without_numpy(values.get("output_dimensions", ()))
    is_part = values.get("failing_only") or values.get("special_only") or values.get("places") is not None or (
        chosen is not None and (not isinstance(chosen, list) or
                                0 < len(chosen) < len(options["output_dimensions"].entries)))
    if told["WarningEvent"] and not is_part and is_empty(output) and not is_empty(made.GetInputDataObject(0, 0)):
        raise RuntimeError("nothing is left of the input: " + "\n".join(told["WarningEvent"]))
    return meshes.like(mesh, output, forms)


def set_creases(made, options, values, creases):
    from . import meshes
    if values.get("crease_geometry") is not None:
        raise ValueError("give creases or crease_geometry, not both")
    options["crease_points"].apply(made, "crease_points", "Same Id")
    lines = meshes.to_creases(creases, made.GetInputDataObject(0, 0))
    made.SetInputDataObject(options["crease_geometry"].port, lines)


def is_empty(data):
    """Whether it has no cells."""
    blocks = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())] if hasattr(data, "GetNumberOfBlocks") else [data]
    return not any(one and one.GetNumberOfCells() for one in blocks)


def of_input_type(made, text):
    """What the pipeline says of an input that the filter does not take, without the words of pipelines."""
    found = re.match(r"Input for connection index \d+ on input port index (\d+) for algorithm .+ is of type (\w+)", text)
    if not found:
        return text
    port, key = int(found[1]), vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
    information = made.GetInputPortInformation(port)
    types = [information.Get(key, i) for i in range(information.Length(key))]
    cure = ""
    if "vtkUnstructuredGrid" in types and made.GetInputDataObject(port, 0).IsA("vtkDataSet"):
        cure = "; vtkmodules.vtkFiltersCore.vtkAppendFilter makes a vtkUnstructuredGrid of other data sets"
    return f"input port {port} is a {found[2]}, but can only be {', '.join(types)}{cure}"


def replace(words, text):
    """The text with other words; where several fit, the longest is meant."""
    if not words:
        return text
    # Where ParaView's plugin is loaded, too, messages have the labels of panels.
    known = set(words.values())
    text = re.sub(r'"([A-Z][A-Za-z0-9 -]*)"', lambda found: next(
        (name for name in [re.sub("[ -]", "_", found[1].lower())] if name in known), found[0]), text)
    any_word = "|".join(map(re.escape, sorted(words, key=len, reverse=True)))
    return re.sub(rf"(?<![^\W_])(?:{any_word})(?![^\W_])", lambda found: words[found[0]], text)


@contextlib.contextmanager
def listen_to(made, words=None):
    """Errors become an exception, warnings those of Python, told to who called the function that calls this. `words` of
    the messages are replaced by those of the caller."""
    told = {"ErrorEvent": [], "WarningEvent": []}

    @calldata_type(VTK_STRING)
    def listen(_, event, message):
        if "returned failure for request" not in message:  # the pipeline says once more that something failed
            text = re.sub(r"\A(ERROR|Warning): In .*\n\S+ \(\w+\): ", "", message).strip()
            told[event].append(replace(words, of_input_type(made, text)))

    observers = [(source, source.AddObserver(event, listen)) for source in (made, made.GetExecutive()) for event in told]
    try:
        yield told
    finally:
        for source, observer in observers:
            source.RemoveObserver(observer)
    for message in told["WarningEvent"]:
        warn(message)
    if told["ErrorEvent"]:
        raise RuntimeError("\n".join(told["ErrorEvent"]))
