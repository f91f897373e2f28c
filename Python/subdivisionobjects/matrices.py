# SPDX-License-Identifier: BSD-3-Clause
"""What a filter does to points, as sparse matrices. NumPy is loaded when it is needed."""

from typing import Any, NamedTuple

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray

from . import vtkSubdivisionObjects
from .run import listen_to


class Rows(NamedTuple):
    """A sparse matrix: row i has the columns ids[offsets[i]:offsets[i + 1]] with these weights."""

    offsets: Any
    ids: Any
    weights: Any
    number_of_columns: int

    def multiply(self, values):
        """The matrix times an array of a value, or a row of values, for each column: each row is summed in double, in
        the order of its entries, starting with 0."""
        import numpy as np
        from .values import to_numpy
        values = to_numpy("values", values).astype(float)
        if len(values) != self.number_of_columns:
            raise ValueError(f"there must be {self.number_of_columns} values, one for each column, not {len(values)}")
        sums = np.zeros((len(self.offsets) - 1,) + values.shape[1:])
        left = np.diff(self.offsets)
        for entry in range(left.max(initial=0)):  # the entry of this number of all rows at once
            rows = np.flatnonzero(left > entry)
            at = self.offsets[rows] + entry
            weights = self.weights[at].reshape((-1,) + (1,) * (values.ndim - 1))
            sums[rows] += weights * values[self.ids[at]]
        return sums

    def to_scipy(self):
        """The same as a scipy.sparse.csr_matrix."""
        from scipy.sparse import csr_matrix
        return csr_matrix((self.weights, self.ids, self.offsets),
                          shape=(len(self.offsets) - 1, self.number_of_columns))


def _read(get, number_of_columns):
    from vtkmodules.util import numpy_support
    arrays = vtkIdTypeArray(), vtkIdTypeArray(), vtkDoubleArray()
    get(*arrays)
    return Rows(*map(numpy_support.vtk_to_numpy, arrays), number_of_columns)


def _compute(made):
    found = vtkSubdivisionObjects.vtkSubdivisionOperator()
    with listen_to(made):
        made.ComputeOperator(found)
    return found


def operator_matrix(made):
    """The matrix S of a vtkMultiDimensionalSubdivision or vtkSurfaceSubdivision with its input and options: a row for
    each point of the output, a column for each point of the input. S times the points is the output but for rounding.
    """
    found = _compute(made)
    return _read(found.GetRows, found.GetNumberOfColumns())


def operator_factors(made):
    """Matrices whose product is S, the first of them to be applied first. They sum as the filter does: one multiplied
    after the other gives the output bit for bit, where points are in double and no cell gets a point at its centre."""
    found = _compute(made)
    columns = found.GetNumberOfColumns()
    factors = []
    for factor in range(found.GetNumberOfFactors()):
        factors.append(_read(lambda *arrays, factor=factor: found.GetFactor(factor, *arrays), columns))
        columns = len(factors[-1].offsets) - 1
    return factors
