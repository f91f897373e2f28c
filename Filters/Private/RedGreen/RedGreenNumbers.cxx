// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenNumbers.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Control/SharedNumbers.h"
#include "Private/Control/StampFields.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Adds the numbers of vertices that the same number of halvings made.
template <typename Id>
void NumberMidpoints(const std::vector<Id>& vertices, const RedGreen<Id>& state,
  const std::vector<char>& own, Partners& partners, WholeIds& points)
{
  SharedKeys midpoints;
  midpoints.Width = 2;
  for (const Id vertex : InTurn(vertices))
  {
    const auto ends = state.GetEnds(vertex);
    const auto [least, most] = std::minmax(points.Ids[ends[0]], points.Ids[ends[1]]);
    midpoints.Keys.push_back(std::max<vtkIdType>(least, 0));
    midpoints.Keys.push_back(std::max<vtkIdType>(most, 0));
    midpoints.Own.push_back(own[vertex] && least >= 0);
  }
  const SharedNumbers numbers = NumberTogether(midpoints, partners);
  for (const std::size_t i : InTurn(vertices.size()))
  {
    points.Ids[vertices[i]] = numbers.First[i] < 0 ? -1 : points.Total + numbers.First[i];
  }
  points.Total += numbers.Totals[0];
}

}

template <typename Id>
WholeSize AddRedGreenNumbers(vtkPointSet* input, const RedGreenMesh& mesh,
  const RedGreen<Id>& state, const Ids& simplices, Partners& partners, vtkUnstructuredGrid* output)
{
  const SimplexView read = mesh.Control.Cells.GetView();
  Ids cellsOfSimplices;
  for (const vtkIdType s : InTurn(read.NumberOfSimplices))
  {
    cellsOfSimplices.push_back(mesh.GetInputCell(s));
  }
  const SharedKeys pieces =
    MakeKeysOfPieces(cellsOfSimplices, PlaceCells(input, partners), partners);
  // cells
  IdSegment parts{ 0, 0, Ids(cellsOfSimplices.size() + 1, 0) };
  Ids inputCells;
  for (const vtkIdType simplex : InTurn(simplices))
  {
    ++parts.Before[simplex + 1];
    inputCells.push_back(cellsOfSimplices[simplex]);
  }
  std::partial_sum(parts.Before.begin(), parts.Before.end(), parts.Before.begin());
  const IdSegments cells{ parts };
  const WholeIds ofCells =
    std::move(FindWholeIds({ &cells }, { NumberTogether(pieces, 0, { &cells }, partners) })[0]);
  // points
  const std::vector<char> own = FindOwnPoints(output, inputCells, partners);
  SharedNumbers given = NumberVertices(input->GetNumberOfPoints(), read, pieces, partners);
  WholeIds points{ std::move(given.First), given.Totals[0] };
  points.Ids.resize(static_cast<std::size_t>(state.GetNumberOfVertices()), -1);
  std::vector<std::vector<Id>> added = ListByHalvings(state);
  const Ids halvings = partners.Gather(static_cast<vtkIdType>(added.size()));
  added.resize(static_cast<std::size_t>(*std::max_element(halvings.begin(), halvings.end())));
  for (const std::vector<Id>& vertices : added)
  {
    NumberMidpoints(vertices, state, own, partners, points);
  }
  output->GetPointData()->AddArray(MakeField<vtkIdTypeArray>(PointNumbersName, points.Ids));
  output->GetCellData()->AddArray(MakeField<vtkIdTypeArray>(CellNumbersName, ofCells.Ids));
  return { points.Total, ofCells.Total };
}

SUBDIVISION_COMPILE_FUNCTION(AddRedGreenNumbers);

}
