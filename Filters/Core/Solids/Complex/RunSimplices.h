// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunSimplices.h
 * The simplices of a complex in the order of runs.
 */
#ifndef SubdivisionObjects_RunSimplices_h
#define SubdivisionObjects_RunSimplices_h

#include "Core/Solids/Complex/SimplicialComplex.h"

#include <algorithm>
#include <iterator>

namespace subdivision
{

/// Calls act(its place among the cells, its dimension, the number in the complex of the vertex,
/// edge, face or tetrahedron that it is, whether it equals an earlier one) for each simplex.
template <typename Id, typename Act>
void ForSimplices(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, const Act& act)
{
  const Buffer<Id>* twins[4] = { nullptr, &complex.EqualLines.Twins, &complex.EqualTriangles.Twins,
    &complex.EqualTets.Twins };
  for (const CellRun& run : runs)
  {
    for (vtkIdType i = 0; i < run.Count; ++i)
    {
      const vtkIdType index = run.First + i;
      const vtkIdType number = run.Dimension == 0 ? complex.VertexCells[index]
        : run.Equal                               ? (*twins[run.Dimension])[index]
                                                  : index;
      act(run.FirstCell + i, run.Dimension, number, run.Equal);
    }
  }
}

/// Calls act(its place, its number, whether it equals another) for each simplex of a dimension.
template <typename Id, typename Act>
void ForSimplices(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  int dimension, const Act& act)
{
  std::vector<CellRun> own;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(own),
    [dimension](const CellRun& run) { return run.Dimension == dimension; });
  ForSimplices(complex, own,
    [&act](vtkIdType place, int, vtkIdType number, bool isEqual) { act(place, number, isEqual); });
}

}

#endif
