# SPDX-License-Identifier: BSD-3-Clause
"""What all functions do: set the options of a filter, run it, and return its output like its input."""

import difflib
import functools
import inspect
import math
import numbers
import operator
import re
from typing import Dict, NamedTuple, Optional, Tuple

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import vtkSubdivisionObjects
from .execution import listen_to


def check_texts(name, texts):
    """Refuses what VTK cannot take as a text: it would end the process."""
    try:
        "".join(texts).encode()
    except UnicodeEncodeError:
        wrong = next(text for text in texts if any("\ud800" <= character <= "\udfff" for character in text))
        raise ValueError(f"{name} has {wrong!a}, which UTF-8 cannot have: where it was bytes, such as the name of a "
                         "file, decode them by their own encoding, as in .decode('latin-1')") from None


def is_number(value):
    return isinstance(value, numbers.Real) and not isinstance(value, bool) and not math.isnan(value)


def to_index(value):
    return None if isinstance(value, bool) else operator.index(value)


# What a number of these kinds is, and what makes one of the value of an option.
NUMBERS = {"int": ("whole number", to_index), "id": ("whole number", to_index),
           "double": ("number", lambda value: float(value) if is_number(value) else None)}


class Option:
    """An option of a filter, by the name of the argument."""

    def __init__(self, kind, command, default=None, help="", group="", clean=None, entries=(), spellings=(), port=0,
                 index=0, association=0):
        self.kind = kind
        self.command = command
        self.default = default
        self.help = help
        self.group = group
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
    """"; did you mean X or Y?", with the names that are the most alike; empty if none is."""
    known = {plain(one): one for one in names}
    given = plain(name)
    found = difflib.get_close_matches(given, known, 3)
    if len(given) > 2:
        found += [one for one in known if given in one and one not in found]
    return f"; did you mean {' or '.join(known[one] for one in found[:3])}?" if found else ""


# What functions take besides the options of their filters.
OF_MESHES = ("mesh", "cells", "point_data", "cell_data", "texture_coordinates", "normals")
OF_IMAGES = ("mesh", "spacing", "origin")


class Filter(NamedTuple):
    """What a function runs: a class, its options by the names of arguments, and shorter names of these."""

    name: str
    label: str
    cls: str
    help: str
    more_help: str
    inputs: Tuple[str, ...]
    options: Dict[str, Option]
    aliases: Dict[str, str]
    criteria: Dict[str, Tuple[str, Optional[str]]]
    words: Dict[str, str]

    def names(self):
        """All arguments of the function."""
        more = (["creases"] if "crease_geometry" in self.options else []) + (["refine"] if self.criteria else [])
        return [*self.inputs, "progress", *more, *self.aliases, *self.options]

    def check(self, given):
        """Refuses an argument that does not exist, and tells the nearest, or that is given by two names."""
        names = self.names()
        for name, value in given.items():
            if name not in names:
                raise TypeError(
                    f"{self.name}() has no argument {name!r}{nearest(name, names)}; "
                    f"subdivisionobjects.options({self.name!r}) lists all"
                )
            if name in self.aliases and value is not None and given.get(self.aliases[name]) is not None:
                raise ValueError(f"{name} and {self.aliases[name]} are the same: give one of them")

    def has(self, method):
        """Whether its class has a method, and makes a mesh for which that is."""
        return self.name not in ("measures", "sample") and hasattr(getattr(vtkSubdivisionObjects, self.cls), method)

    def values(self, given):
        """The values of all options, and of other arguments that are given."""
        values = {name: option.default for name, option in self.options.items()}
        values.update((self.aliases.get(name, name), value) for name, value in given.items() if value is not None)
        return values


# All functions, by name.
FILTERS: Dict[str, Filter] = {}


def find_filter(function):
    """What a function runs: the function, or its name."""
    name = getattr(function, "__name__", function)
    if name == "multi_dimensional_subdivision":
        name = "subdivide"
    name = next((one.name for one in FILTERS.values() if plain(name) == plain(one.label)), name)
    if name not in FILTERS:
        raise ValueError(f"there is no function {name!r}: they are {', '.join(FILTERS)}{nearest(name, FILTERS)}")
    return FILTERS[name]


def runs(one):
    """Makes a function that has a signature only run a filter with its arguments."""

    def wrap(function):
        signature = inspect.signature(function)

        @functools.wraps(function)
        def call(*args, **given):
            one.check(given)
            bound = dict(signature.bind(*args, **given).arguments)
            options = bound.pop("options", {})
            return run(one, {**bound, **options})

        return call

    FILTERS[one.name] = one
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


class Ready(NamedTuple):
    """A filter with its input and options, and what its output is to be like."""

    made: vtkAlgorithm
    mesh: object
    forms: Dict[str, Dict[str, object]]
    values: Dict[str, object]


def prepare(one, given):
    """Makes a filter and sets its input and options by the arguments of its function."""
    from . import meshes

    one.check(given)
    values = one.values(given)
    made = getattr(vtkSubdivisionObjects, one.cls)()
    mesh = values.pop("mesh", None)
    if one.inputs and mesh is None:
        raise TypeError("mesh is None: give a data set of VTK, points and cells, a file, or a mesh that has them")
    forms = {"point": {}, "cell": {}, "field": {}}
    data = [values.pop(key, None) for key in ("cells", "point_data", "cell_data")]
    more = {key: None if key in one.options else values.pop(key, None)
            for key in (*meshes.ATTRIBUTES, "spacing", "origin", "creases", "refine")}
    if more["refine"] is not None:
        choose_criteria(one.criteria, more["refine"], values)
    if one.inputs == OF_IMAGES:
        made.SetInputDataObject(0, meshes.to_image(mesh, more["spacing"], more["origin"]))
    elif one.inputs:
        found = meshes.to_vtk(mesh, *data, of_surfaces="Surface" in one.cls, forms=forms)
        made.SetInputDataObject(0, meshes.with_attributes(found, {key: more[key] for key in meshes.ATTRIBUTES}))
    # Arrays belong to inputs, which come first.
    for name in sorted(one.options, key=lambda name: one.options[name].kind == "array"):
        if values[name] is not None:
            one.options[name].apply(made, name, values[name])
    if more["creases"] is not None:
        set_creases(made, one.options, values, more["creases"])
    return Ready(made, mesh, forms, values)


def to_filter(mesh, cells, function, options):
    """A filter that has an operator and a limit as it is; else one of a function, with a mesh and options. Also what
    words its messages have."""
    if isinstance(mesh, vtkAlgorithm) and hasattr(mesh, "ComputeOperator"):
        if cells is not None or options:
            raise TypeError("a filter has a mesh and options of its own")
        return mesh, None
    one = find_filter(function)
    able = [other.name for other in FILTERS.values() if other.has("ComputeOperator")]
    if one.name not in able:
        raise ValueError(f"{one.name} has no operator: function is one of {', '.join(able)}")
    return prepare(one, {"mesh": mesh, "cells": cells, **options}).made, one.words


def run(one, given):
    """Runs a filter with the arguments of its function, and returns its output like its input."""
    from . import meshes

    progress = given.pop("progress", None)
    ready = prepare(one, given)
    return meshes.like(ready.mesh, execute(one, ready, progress), ready.forms)


def execute(one, ready, progress=None):
    """Runs a filter that is ready, and returns its output."""
    made, values = ready.made, ready.values
    with listen_to(made, one.words, progress) as told:
        made.Update()
    output = made.GetOutputDataObject(0)
    # With these options nothing may come out of a mesh that is right.
    chosen = without_numpy(values.get("output_dimensions"))
    is_part = bool(values.get("failing_only") or values.get("special_only") or values.get("places") is not None)
    if chosen is not None:
        is_part |= not isinstance(chosen, list) or 0 < len(chosen) < len(one.options["output_dimensions"].entries)
    if told["WarningEvent"] and not is_part and is_empty(output) and not is_empty(made.GetInputDataObject(0, 0)):
        raise RuntimeError("nothing is left of the input: " + "\n".join(told["WarningEvent"]))
    return output


def set_creases(made, options, values, creases):
    from . import meshes
    if values.get("crease_geometry") is not None:
        raise ValueError("give creases or crease_geometry, not both")
    options["crease_points"].apply(made, "crease_points", "Same Id")
    lines = meshes.to_creases(creases, made.GetInputDataObject(0, 0))
    made.SetInputDataObject(options["crease_geometry"].port, lines)


def is_empty(data):
    """Whether it has no cells, or rows."""
    if hasattr(data, "GetNumberOfRows"):
        return not data.GetNumberOfRows()
    blocks = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())] if hasattr(data, "GetNumberOfBlocks") else [data]
    return not any(one and one.GetNumberOfCells() for one in blocks)
