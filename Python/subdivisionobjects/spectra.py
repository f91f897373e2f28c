# SPDX-License-Identifier: BSD-3-Clause
"""How smooth rules of one's own are: what the matrix of a step around a vertex says. NumPy is loaded when it is needed."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, List, NamedTuple, Optional, Union

from . import functions
from .matrices import Rows

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike
    from scipy.sparse import spmatrix
    from vtkmodules.vtkCommonDataModel import vtkDataObject

    from .arrays import Arrays
    from .kinds import AnyMesh

EQUAL = 1e-6  # eigenvalues that differ by less count as equal, as in vtkSubdivisionSmoothness
FAINT = 1e-12


class Spectrum(NamedTuple):
    """What a step does around a vertex. Moduli of eigenvalues descend; the first one is 1."""

    eigenvalues: np.ndarray[Any, Any]
    condition: bool  # 1 > l_d > l_(d+1), d = dimension; beside curves the values of these are among l_1 to l_d
    curvature: str  # where the condition holds: "zero", "bounded" or "unbounded", by l_(d+1) and the square of l_d
    limit: np.ndarray[Any, Any]  # the weights of all points in the limit of the vertex
    map: Optional[np.ndarray[Any, Any]]  # the control points of the characteristic map, d numbers for each; None: no condition
    regular: Optional[bool]  # whether the given faces of the map all have one orientation


def _to_square(matrix):
    """A dense square matrix of more rows than points have coordinates; None: it is none."""
    import numpy as np

    if isinstance(matrix, Rows):
        matrix = matrix.multiply(np.eye(matrix.number_of_columns))
    dense = matrix.toarray() if hasattr(matrix, "toarray") else matrix
    if not isinstance(dense, (list, tuple, np.ndarray)):
        return None
    try:
        dense = np.asarray(dense, dtype=float)
    except (TypeError, ValueError):
        return None
    return dense if dense.ndim == 2 and dense.shape[0] == dense.shape[1] > 3 else None


def _find_map(matrix, eigenvalues, dimension):
    """An orthonormal basis of the real invariant space of l_1 to l_d."""
    import numpy as np

    values, vectors = np.linalg.eig(matrix)
    order = np.argsort(-abs(values), kind="stable")[1 : dimension + 1]
    both = np.hstack([vectors[:, order].real, vectors[:, order].imag])
    space, sizes, _ = np.linalg.svd(both, full_matrices=False)
    return space[:, :dimension] if np.sum(sizes > EQUAL) == dimension else None


def _are_regular(made, faces):
    import numpy as np

    corners = made[np.asarray(faces)]
    dimension = made.shape[1]
    if corners.ndim != 3 or corners.shape[1] != dimension + 1:
        raise ValueError(f"faces must be rows of {dimension + 1} numbers of points: simplices of the map")
    sizes = np.linalg.det(corners[:, 1:] - corners[:, :1])
    return bool((sizes > FAINT).all() or (sizes < -FAINT).all())


def examine(
    matrix: Union[ArrayLike, Rows, spmatrix],
    *,
    dimension: int = 2,
    along: float = 0.5,
    curves: int = 0,
    faces: Optional[ArrayLike] = None,
) -> Spectrum:
    """What the matrix of a step says: row i makes point i of the star from the points of the star one level before, in
    the same order, and reads no other points. A scheme whose steps turn the mesh needs the matrix of two steps.

    dimension: of the object, 1 to 3. along, curves: beside curves l_1 to l_d must contain the eigenvalue of the curve
    this often: once on a smooth boundary, twice at a corner. faces: simplices of points, which the characteristic map
    must keep turned alike.
    """
    import numpy as np

    dense = _to_square(matrix)
    if dense is None:
        raise ValueError("the matrix must be square, with a row for each point of the star, four or more")
    if not np.isfinite(dense).all():
        raise ValueError(f"row {np.argmin(np.isfinite(dense).all(axis=1))} has numbers that are not finite")
    sums = dense.sum(axis=1)
    if abs(sums - 1).max() > 1e-9:
        row = int(np.argmax(abs(sums - 1) > 1e-9))
        raise ValueError(f"row {row} sums to {sums[row]:.12g}, not to 1: it may read points that are not in the star")
    if not 1 <= dimension <= 3:
        raise ValueError(f"dimension must be 1 to 3, not {dimension}")
    values, left = np.linalg.eig(dense.T)
    moduli = np.array(sorted(abs(values), reverse=True))
    first = left[:, np.argmin(abs(values - 1))].real
    last, rest = moduli[dimension], moduli[dimension + 1] if len(moduli) > dimension + 1 else 0.0
    found = int(np.sum(abs(moduli[1 : dimension + 1] - along) < EQUAL))
    condition = bool(moduli[1] < 1 - EQUAL and last > rest + EQUAL and found >= curves)
    made = _find_map(dense, moduli, dimension) if condition else None
    ratio = rest - last**2
    return Spectrum(
        moduli,
        condition,
        "" if not condition else "bounded" if abs(ratio) < EQUAL else "zero" if ratio < 0 else "unbounded",
        first / first.sum(),
        made,
        None if made is None or faces is None else _are_regular(made, faces),
    )


@functools.wraps(functions.smoothness)
def smoothness(
    mesh: Union[AnyMesh, Rows, spmatrix], *arguments: Any, **options: Any
) -> Union[Spectrum, Arrays, vtkDataObject, List[vtkDataObject]]:
    if not arguments and "cells" not in options and _to_square(mesh) is not None:
        return examine(mesh, **options)
    return functions.smoothness(mesh, *arguments, **options)


smoothness.__doc__ = f"""{functions.smoothness.__doc__.rstrip()}

    A square matrix instead of a mesh is a step of rules of one's own around a vertex; smoothness(matrix, dimension=2,
    along=0.5, curves=0, faces=None) gives its eigenvalues, condition, curvature, limit, map and regular.
    """
