// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Topology/TopologyNumbers.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Control/Partners.h"
#include "Private/Control/SharedNumbers.h"
#include "Private/Control/StampFields.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

Ids NumberPoints(vtkPointSet* input, const ControlMesh& mesh, Partners& partners)
{
  const SimplexView read = mesh.Cells.GetView();
  const Ids& parents = mesh.Cells.ParentCells;
  Ids cells;
  for (const vtkIdType s : InTurn(read.NumberOfSimplices))
  {
    cells.push_back(parents.empty() ? s : parents[s]);
  }
  const SharedKeys pieces = MakeKeysOfPieces(cells, PlaceCells(input, partners), partners);
  return NumberVertices(input->GetNumberOfPoints(), read, pieces, partners).First;
}

/// Of own cells of one dimension, by the numbers of their points; the first one has the number
/// `first`, which becomes the first one of the next dimension.
void NumberCells(vtkUnstructuredGrid* output, const Ids& own, int dimension, const Ids& points,
  vtkIdType& first, Partners& partners, Ids& numbers)
{
  const CellReader reader(output);
  SharedKeys things;
  things.Width = dimension + 1;
  Ids scratch;
  for (const vtkIdType c : InTurn(own))
  {
    const CellIds cell = reader.GetCell(c, scratch);
    const std::size_t start = things.Keys.size();
    for (vtkIdType k = 0; k < cell.Size; ++k)
    {
      things.Keys.push_back(points[cell.Ids[k]]);
    }
    std::sort(things.Keys.begin() + static_cast<std::ptrdiff_t>(start), things.Keys.end());
  }
  things.Own.assign(own.size(), 1);
  const SharedNumbers found = NumberTogether(things, partners);
  for (const std::size_t i : InTurn(own.size()))
  {
    numbers[own[i]] = first + found.First[i];
  }
  first += found.Totals[0];
}

}

void AddTopologyNumbers(vtkPointSet* input, const ControlMesh& mesh,
  const std::function<bool(vtkIdType)>& isOwn, Partners& partners, vtkUnstructuredGrid* output)
{
  const Ids points = NumberPoints(input, mesh, partners);
  const CellReader reader(output);
  Ids own[3];
  Ids scratch;
  for (const vtkIdType c : InTurn(output->GetNumberOfCells()))
  {
    if (isOwn(c))
    {
      own[reader.GetCell(c, scratch).Size - 1].push_back(c);
    }
  }
  Ids cells(static_cast<std::size_t>(output->GetNumberOfCells()), -1);
  vtkIdType first = 0;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    NumberCells(output, own[dimension], dimension, points, first, partners, cells);
  }
  output->GetPointData()->AddArray(MakeField<vtkIdTypeArray>(PointNumbersName, points));
  output->GetCellData()->AddArray(MakeField<vtkIdTypeArray>(CellNumbersName, cells));
}

}
