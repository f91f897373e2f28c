# SPDX-License-Identifier: BSD-3-Clause
"""What a filter does to points, as sparse matrices. NumPy is loaded when it is needed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, List, NamedTuple, Optional, Union

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray

from . import vtkSubdivisionObjects
from .execution import listen_to
from .run import to_filter

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike
    from scipy.sparse import csr_matrix

    from .kinds import AnyMesh, Cells


class Rows(NamedTuple):
    """A sparse matrix: row i has the columns ids[offsets[i]:offsets[i + 1]] with these weights."""

    offsets: np.ndarray[Any, Any]
    ids: np.ndarray[Any, Any]
    weights: np.ndarray[Any, Any]
    number_of_columns: int

    def multiply(self, values: ArrayLike) -> np.ndarray[Any, Any]:
        """The matrix times an array of a value, or a row of values, for each column: each row is summed in double, in
        the order of its entries, starting with 0."""
        import numpy as np
        from .values import to_numpy

        given = to_numpy("values", values).astype(float)
        if len(given) != self.number_of_columns:
            raise ValueError(f"there must be {self.number_of_columns} values, one for each column, not {len(given)}")
        sums = np.zeros((len(self.offsets) - 1,) + given.shape[1:])
        left = np.diff(self.offsets)
        for entry in range(left.max(initial=0)):  # the entry of this number of all rows at once
            rows = np.flatnonzero(left > entry)
            at = self.offsets[rows] + entry
            weights = self.weights[at].reshape((-1,) + (1,) * (given.ndim - 1))
            sums[rows] += weights * given[self.ids[at]]
        return sums

    def to_scipy(self) -> csr_matrix:
        """The same as a scipy.sparse.csr_matrix."""
        from scipy.sparse import csr_matrix

        return csr_matrix((self.weights, self.ids, self.offsets), shape=(len(self.offsets) - 1, self.number_of_columns))


def _read(get, number_of_columns):
    from vtkmodules.util import numpy_support

    arrays = vtkIdTypeArray(), vtkIdTypeArray(), vtkDoubleArray()
    get(*arrays)
    return Rows(*map(numpy_support.vtk_to_numpy, arrays), number_of_columns)


def _compute(mesh, cells, function, options, compute="ComputeOperator"):
    progress = options.pop("progress", None)
    made, words = to_filter(mesh, cells, function, options)
    found = vtkSubdivisionObjects.vtkSubdivisionOperator()
    with listen_to(made, words, progress):
        getattr(made, compute)(found)
    return found


def operator_matrix(
    mesh: AnyMesh, cells: Optional[Cells] = None, *, function: Union[str, Callable[..., object]] = "subdivide", **options: Any
) -> Rows:
    """The matrix S of `subdivide` or `surface_subdivision` with these options: a row for each point of the output, a
    column for each point of the input. S times the points is the output but for rounding.

        S = operator_matrix(points, tetrahedra, levels=2).to_scipy()
        S = operator_matrix(points, quads, function="surface_subdivision", scheme="catmull-clark").to_scipy()

    mesh, cells: as these functions take them; or mesh is a vtkMultiDimensionalSubdivision or vtkSurfaceSubdivision,
    with its input and options.
    """
    found = _compute(mesh, cells, function, options)
    return _read(found.GetRows, found.GetNumberOfColumns())


def prolongation_matrix(
    mesh: AnyMesh, cells: Optional[Cells] = None, *, function: Union[str, Callable[..., object]] = "subdivide", **options: Any
) -> Rows:
    """The matrix from values at the nodes of curved cells of the level before to the nodes of the output, for solvers on
    nested levels: a row has the shape functions of the cell in which a node lies, there.

        P = prolongation_matrix(points, tetrahedra, levels=2, output_cells="lagrange", cell_order=3).to_scipy()

    Arguments are those of `operator_matrix`; columns are the points of `subdivide` with one level less.
    """
    found = _compute(mesh, cells, function, options, "ComputeProlongation")
    return _read(found.GetRows, found.GetNumberOfColumns())


def operator_factors(
    mesh: AnyMesh, cells: Optional[Cells] = None, *, function: Union[str, Callable[..., object]] = "subdivide", **options: Any
) -> List[Rows]:
    """Matrices whose product is S, the first of them to be applied first. They sum as the filter does: one multiplied
    after the other gives the output bit for bit, where points are in double and no cell gets a point at its centre.
    Arguments are those of `operator_matrix`."""
    found = _compute(mesh, cells, function, options)
    columns = found.GetNumberOfColumns()
    factors = []
    for factor in range(found.GetNumberOfFactors()):
        factors.append(_read(lambda *arrays, factor=factor: found.GetFactor(factor, *arrays), columns))
        columns = len(factors[-1].offsets) - 1
    return factors
