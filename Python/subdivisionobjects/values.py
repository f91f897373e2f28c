# SPDX-License-Identifier: BSD-3-Clause
"""From what can become arrays of NumPy to arrays of VTK, and back."""

import numbers

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.util.vtkConstants import VTK_ID_TYPE
from vtkmodules.vtkCommonCore import vtkBitArray, vtkDataArray, vtkStringArray

from .run import check_texts

# The array by which VTK hides points and cells.
GHOSTS = "vtkGhostType"

# What dtypes of these kinds cannot be, and what helps.
REFUSED = {"c": "complex numbers: give their parts, .real and .imag, as two arrays",
           "m": "spans of time: give numbers, such as values / np.timedelta64(1, 's')",
           "M": "dates: give numbers, such as values.astype('int64')",
           "V": "records: give each of their fields as an array"}


def to_numpy(name, values):
    """An array of NumPy of a kind that VTK has, in the order of bytes of this machine. Missing floating point numbers
    are NaN; what cannot be taken as it is is a ValueError that names it."""
    if values is None:
        raise ValueError(f"{name} is None")
    if isinstance(values, np.ma.MaskedArray):
        values = without_mask(name, values)
    elif hasattr(values, "__dlpack__") and not hasattr(values, "__array__"):
        values = np.from_dlpack(values)
    try:
        made = np.asarray(values)
        if isinstance(values, (list, tuple)) and may_be_others(made):
            made = np.asarray(values, object)
    except Exception as error:  # of any library
        raise ValueError(f"{name} cannot become an array of NumPy: {error}") from None
    if made.dtype.kind in "OT":
        made = without_objects(name, made)
    kind, size = made.dtype.kind, made.dtype.itemsize
    if kind in REFUSED:
        raise ValueError(f"{name} has {REFUSED[kind]}")
    if kind == "S":
        made = to_texts(name, made, np.char.decode)
    if kind in "SU":
        check_texts(name, made.ravel().tolist())
        return made
    if kind == "f" and size not in (4, 8):
        return other_floats(name, made)
    return made.astype(made.dtype.newbyteorder("="), copy=False)


def may_be_others(made):
    """Whether NumPy made of a list what was not in it: texts of numbers, or floating point numbers of integers."""
    return made.dtype.kind == "U" or (made.dtype.kind == "f" and bool((np.abs(made) >= 2.0**53).any()))


def without_mask(name, values):
    if values.dtype.kind == "f":
        return values.filled(np.nan)
    if np.ma.is_masked(values):
        raise ValueError(f"{name} has missing values (a mask), which {values.dtype} cannot say: give floating point "
                         "numbers, or fill them by .filled(value)")
    return values.data


def without_objects(name, values):
    """Objects of Python that are all texts, all truth values, or all numbers, of which None is a missing one."""
    found = values.ravel().tolist()
    if all(isinstance(one, (str, bytes)) for one in found):
        texts = to_texts(name, found, lambda ones, _: [one if isinstance(one, str) else one.decode() for one in ones])
        return np.array(texts, str).reshape(values.shape)
    if all(isinstance(one, (bool, np.bool_)) for one in found):
        return values.astype(bool)
    if all(isinstance(one, numbers.Integral) for one in found):
        return values.astype(type_of_integers(name, min(found), max(found)))
    if all(one is None or isinstance(one, numbers.Real) for one in found):
        try:
            made = values.astype(np.float64)
        except OverflowError:
            raise ValueError(f"{name} has a number that is too large") from None
        check_digits(name, [one for one in found if isinstance(one, numbers.Integral)], made.dtype)
        return made
    kinds = ", ".join(sorted({type(one).__name__ for one in found}))
    raise ValueError(f"{name} has objects of Python ({kinds}), not numbers alone or texts alone; rows must have equal "
                     "lengths")


def to_texts(name, values, decode):
    try:
        return decode(values, "utf-8")
    except UnicodeDecodeError as error:
        raise ValueError(f"{name} has bytes that are no text of UTF-8: {error}") from None


def type_of_integers(name, low, high):
    """The type of whole numbers that has all from `low` to `high`."""
    for dtype in (np.int64, np.uint64):
        if np.iinfo(dtype).min <= low and high <= np.iinfo(dtype).max:
            return dtype
    raise ValueError(f"{name} has a number that is too large: no type of whole numbers has both {low} and {high}")


def check_digits(name, integers, dtype):
    """Refuses whole numbers that are others in floating point numbers of this type."""
    for one in integers:
        if int(dtype.type(one)) != one:
            raise ValueError(f"{name} has the whole number {one} beside missing values or floating point numbers: as "
                             f"{dtype} it would be {int(dtype.type(one))}; give whole numbers alone")


def join(name, parts):
    """Parts of an array, one after the other, as one that holds all their values."""
    parts = [to_numpy(name, part) for part in parts]
    parts = [part for part in parts if part.size] or parts[:1]
    shapes = {part.shape[1:] for part in parts}
    if len(shapes) > 1 or () in {part.shape for part in parts}:
        shown = ", ".join(str(part.shape) for part in parts)
        raise ValueError(f"{name} must have values of one shape for all cells, not the shapes {shown}")
    kinds = {part.dtype.kind for part in parts}
    if "U" in kinds and len(kinds) > 1:
        raise ValueError(f"{name} has texts for some types of cells, and numbers for others")
    if kinds == {"i", "u"}:
        dtype = type_of_integers(name, min(int(part.min()) for part in parts), max(int(part.max()) for part in parts))
        return np.concatenate([part.astype(dtype) for part in parts])
    made = np.concatenate(parts)
    for part in parts:
        if part.dtype.kind in "iu" and made.dtype.kind == "f":
            check_digits(name, part[np.abs(part.astype(float)) >= 2.0**53].ravel().tolist(), made.dtype)
    return made


def other_floats(name, values):
    with np.errstate(over="ignore"):
        made = values.astype(np.float32 if values.dtype.itemsize < 4 else np.float64)
    if not np.array_equal(np.isfinite(made), np.isfinite(values)):
        raise ValueError(f"{name} has a number that is too large for double precision")
    return made


def to_integers(name, values):
    """Whole numbers as an array of int64."""
    made = to_numpy(name, values)
    if made.size == 0:
        return made.astype(np.int64)
    if made.dtype.kind not in "iu":
        raise ValueError(f"{name} must have integers, not {made.dtype}")
    if made.max() > np.iinfo(np.int64).max:
        raise ValueError(f"{name} has a number that is too large")
    return made.astype(np.int64)


def to_ids(name, values, count=None, what="cells"):
    """Ids, or those where a mask for `count` points or cells is True."""
    made = to_numpy(name, values)
    if made.dtype.kind == "b" and made.size:
        if count is None:
            raise ValueError(f"{name} is a mask, which needs a mesh that is no list of blocks: give ids")
        if made.shape != (count,):
            raise ValueError(f"{name} is a mask of the shape {made.shape}, but there are {count} {what}")
        return np.flatnonzero(made)
    ids = to_integers(name, made).ravel()
    wrong = ids[(ids < 0) | (ids >= count)] if count is not None else ids[ids < 0]
    if len(wrong):
        there = "" if count is None else f", and there are {count} {what}"
        raise ValueError(f"{name} has the id {wrong[0]}: ids are counted from 0{there}")
    return ids


def to_array(name, values, count, what="points or cells", forms=None):
    """An array of VTK with a value, or a row of values, for each of `count`. What VTK does not keep of it goes into
    `forms`, by its name: the shape of its rows, and whether it has truth values."""
    shown = f"the array {name!r}"
    if not isinstance(name, (str, type(None))) or "\0" in (name or ""):
        raise ValueError(f"{shown} must have a text without zero bytes as its name")
    check_texts("the name of an array", [name or ""])
    values = to_numpy(shown, values)
    if values.ndim == 0:
        raise ValueError(f"{shown} is the single value {values.item()!r}: give one for each of {count} {what}")
    if len(values) != count:
        raise ValueError(f"{shown} has {len(values)} values, but there are {count} {what}")
    if name == GHOSTS:
        values = to_marks(shown, values)
    if forms is not None:
        forms[name] = (values.shape[1:], values.dtype.kind == "b")
    if values.ndim > 1:  # tensors are rows of their components
        values = values.reshape(count, int(np.prod(values.shape[1:])))
        if values.shape[1] == 0:
            raise ValueError(f"{shown} has rows without values")
    made = to_vtk_array(values)
    if name is not None:
        made.SetName(name)
    return made


def to_marks(shown, values):
    """The marks of hidden points and cells as bytes: VTK passes over arrays of other types."""
    if values.dtype.kind not in "biu" or values.ndim != 1 or (values.size and (values.min() < 0 or values.max() > 255)):
        raise ValueError(f"{shown} marks what VTK hides: it must have a whole number from 0 to 255 for each, not the "
                         f"shape {values.shape} of {values.dtype}")
    return values.astype(np.uint8)


def to_vtk_array(values, array_type=None):
    if values.dtype.kind == "U":
        made = vtkStringArray()
        made.SetNumberOfComponents(values.shape[1] if values.ndim > 1 else 1)
        for value in values.ravel().tolist():
            made.InsertNextValue(value)
        return made
    values = values.astype(np.uint8) if values.dtype.kind == "b" else np.require(values, requirements="CW")
    return numpy_support.numpy_to_vtk(values, deep=1, array_type=array_type)


def to_vtk_ids(ids):
    return to_vtk_array(np.ascontiguousarray(ids, np.int64), VTK_ID_TYPE)


def from_vtk_array(array):
    if isinstance(array, vtkStringArray):
        values = np.array([array.GetValue(i) for i in range(array.GetNumberOfValues())], str)
        components = array.GetNumberOfComponents()
        return values.reshape(-1, components) if components > 1 else values
    if isinstance(array, vtkBitArray):
        values = np.array([array.GetValue(i) for i in range(array.GetNumberOfValues())], np.uint8)
        components = array.GetNumberOfComponents()
        return values.reshape(-1, components) if components > 1 else values
    return numpy_support.vtk_to_numpy(array)


def data_arrays(data, forms=None):
    """The arrays of numbers and texts, by name, in the forms in which they were given (to_array)."""
    found = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        if not isinstance(array, (vtkDataArray, vtkStringArray)):
            continue
        values = from_vtk_array(array)
        shape, is_truth = (forms or {}).get(array.GetName(), ((), False))
        if shape and array.GetNumberOfComponents() == int(np.prod(shape)):
            values = values.reshape((-1,) + shape)
        found[array.GetName()] = values.astype(bool) if is_truth and values.dtype == np.uint8 else values
    return found
