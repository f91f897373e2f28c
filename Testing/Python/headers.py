# SPDX-License-Identifier: BSD-3-Clause
"""What the headers of the classes, and the sources that belong to them, state about options and arrays."""

import pathlib
import re

from vtkmodules.vtkCommonDataModel import vtkSphere
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

import subdivisionobjects

ROOT = pathlib.Path(__file__).resolve().parents[2]
CLASSES = [cls for name, cls in sorted(vars(subdivisionobjects).items())
           if name.startswith("vtk") and isinstance(cls, type) and issubclass(cls, vtkAlgorithm)]
# What has a setter but is no option: an object of the process, which ParaView sets by itself.
NO_OPTIONS = {"Controller"}


def words(text):
    return " ".join(text.split())


def number(text):
    """The number that is written as "20", "0.1" or "500 million"; None for the name of an open end."""
    value, _, million = text.partition(" ")
    return None if text.startswith("VTK_") else float(value) * (1e6 if million else 1)


def stated_defaults(text):
    """All defaults that a text states, each as a tuple of numbers; (None,) where it says none."""
    found = [(value == "On",) for value in re.findall(r"\b(On|Off) by default\b", text)]
    found += [(None,) for _ in re.findall(r"\b[Nn]one by default\b", text)]
    found += [(float(value),) for value in re.findall(r"\((\d+), the default\b", text)]
    value = r"(-?\d+(?:\.\d+)?(?: million)?)"
    return found + [tuple(number(part) for part in pair if part)
                    for pair in re.findall(rf"\b[Dd]efault {value}(?: to {value})?", text)]


def along_axes(stated, value):
    """What is stated for one axis, for all axes of a value that has more components."""
    return stated * (len(value) // len(stated))


def stated_ranges(text):
    """All ranges in front of a default, each as a pair; an open end is None."""
    value = r"(-?\d+(?:\.\d+)?)"
    return [(float(low), float(high) if high else None)
            for low, high in re.findall(rf"{value} (?:to {value}|or more)[,;.] [Dd]efault\b", text)]


class Option:
    """What a header says of an option. Options with a common comment all have its text."""

    def __init__(self, name, text, clamp):
        self.name = name
        self.text = words(text)
        self.clamp = clamp  # the ends, as they are written; empty: values are not clamped
        self.is_enumeration = bool(clamp) and clamp[0][0].isalpha()
        # The class that has the names of the enumeration, where it is not the option's own.
        self.scope = clamp[0].rpartition("::")[0] if clamp else ""

    def constant(self, cls, name):
        """The number of a name of the enumeration."""
        return int(getattr(getattr(subdivisionobjects, self.scope) if self.scope else cls, name.rpartition("::")[2]))

    def ends(self, cls):
        return tuple(self.constant(cls, end) if self.is_enumeration else number(end) for end in self.clamp)

    def get(self, made):
        value = getattr(made, "Get" + self.name)()
        return value if isinstance(value, tuple) else (value,)

    def set(self, made, *values):
        """Returns what was set."""
        getattr(made, "Set" + self.name)(*values)
        return values

    def change(self, made):
        """Sets a value that is not the default, and returns it."""
        value = self.get(made)
        if value[0] is None:
            return self.set(made, vtkSphere())
        if isinstance(value[0], bool):
            return self.set(made, not value[0])
        if self.is_enumeration:
            return self.set(made, next(end for end in self.ends(type(made)) if end != value[0]))
        high = self.ends(type(made))[1] if self.clamp else None
        if high is not None and value[0] + 1 > high:
            ends = self.ends(type(made))
            return self.set(made, *(type(part)(next(end for end in ends if end != part)) for part in value))
        return self.set(made, *(part + 1 for part in value))


class ArrayEntry:
    """An entry of the list of arrays that a class reads."""

    def __init__(self, text, only_cells):
        self.text = words(text)
        kinds = re.findall(r"\b(cell|point)(?: or (point))? array\b", "cell array" if only_cells else self.text)
        self.kinds = [kind.capitalize() for kind in kinds[0] if kind] if kinds else []
        self.is_integer = bool(re.search(r"\binteger", self.text))
        self.fallback = (re.findall(r"[Uu]nset: `(\w+)` if there", self.text) + [None])[0]
        self.criterion = (re.findall(r"\bfor (RefineBy\w+)", self.text) + [None])[0]


class Header:
    """A header, and the source that belongs to it."""

    def __init__(self, cls):
        text, source = ((ROOT / "Filters" / (cls.__name__ + ending)).read_text(encoding="utf-8")
                        for ending in (".h", ".cxx"))
        about = re.sub(r"^ \* ?", "", re.search(r"/\*\*(.*?)\*/", text, re.S).group(1), flags=re.M)
        declaration = text[re.search(rf"class VTKSUBDIVISIONOBJECTS_EXPORT {cls.__name__}\s", text).start():]
        self.enumerations = [[item.split()[0] for item in body.split(",")]
                             for body in re.findall(r"enum \w+\s*\{(.*?)\}", declaration, re.S)]
        self.options = dict(self.find_options(cls, declaration[:declaration.index("protected:")]))
        self.here = {name: (number(value),) for name, value in
                     re.findall(r"(\w+) \(here (\d+(?: million)?) by default\)", words(about))}
        title = r"@par (Cell a|A)rrays read, by SetInputArrayToProcess\n(.*?)(?=^@par|\Z)"
        self.arrays = {int(index): ArrayEntry(text, start == "Cell a")
                       for start, listed in re.findall(title, about, re.M | re.S)
                       for index, text in re.findall(r"^ - (\d+), ((?:.|\n(?= {3}))*)", listed, re.M)}
        self.indices = dict(self.find_indices(declaration, source))

    @staticmethod
    def find_options(cls, declaration):
        comment = ""
        for match in re.finditer(
                r"/\*\*(?P<comment>.*?)\*/|///@\}|vtkSet\w*Macro\(\s*(?P<name>\w+), \w+(?P<clamp>[^;]*)\);|"
                r"void Set(?P<method>\w+)\(", declaration, re.S):
            name = match["name"] or match["method"]
            if not name:
                comment = re.sub(r"^\s*\*", "", match["comment"] or "", flags=re.M)
            elif hasattr(cls, "Get" + name) and name not in NO_OPTIONS:
                yield name, Option(name, comment, re.findall(r"[^\s,]+", match["clamp"] or ""))

    @staticmethod
    def find_indices(declaration, source):
        """The array indices of the code, each with a word for what is there."""
        for index, target in re.findall(r"find\(\{ (\d+),[^}]*\}, options\.(?:Features\.)?(\w+)\)", source):
            yield int(index), target.rstrip("s").lower()
        for body in re.findall(r"enum \w+\s*\{([^}]*_ARRAY[^}]*)\}", declaration):
            index = -1
            for name, value in re.findall(r"(\w+)_ARRAY(?: = (\d+))?", body):
                index = int(value) if value else index + 1
                yield index, name.lower()


HEADERS = {cls: Header(cls) for cls in CLASSES}


def of_bases(cls, member):
    """What the headers of a class and of its bases have."""
    return {key: value for base in reversed(cls.__mro__) if base in HEADERS
            for key, value in getattr(HEADERS[base], member).items()}
