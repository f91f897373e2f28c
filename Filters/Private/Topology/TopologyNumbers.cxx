// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Topology/TopologyNumbers.h"

#include "Core/Memory/Loops.h"
#include "Private/Control/Partners.h"
#include "Private/Control/SharedNumbers.h"
#include "Private/Reading/CellReader.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// The points of some cells as keys.
SharedKeys MakeKeys(const CellReader& reader, const Ids& cells, int width, const Ids& points)
{
  SharedKeys keys;
  keys.Width = width;
  keys.Own.assign(cells.size(), 1);
  Ids scratch;
  for (const vtkIdType c : InTurn(cells))
  {
    const CellIds cell = reader.GetCell(c, scratch);
    for (vtkIdType k = 0; k < width; ++k)
    {
      keys.Keys.push_back(points[cell.Ids[k]]);
    }
    std::sort(keys.Keys.end() - width, keys.Keys.end());
  }
  return keys;
}

}

void AddTopologyNumbers(vtkPointSet* input, const ControlMesh& mesh,
  const std::function<bool(vtkIdType)>& isOwn, Partners& partners, vtkUnstructuredGrid* output)
{
  const SimplexView read = mesh.Cells.GetView();
  Ids cells = mesh.Cells.ParentCells;
  for (vtkIdType s = 0; mesh.Cells.ParentCells.empty() && s < read.NumberOfSimplices; ++s)
  {
    cells.push_back(s);
  }
  const SharedKeys pieces = MakeKeysOfPieces(cells, PlaceCells(input, partners), partners);
  WholeNumbers numbers;
  numbers.Points = NumberVertices(input->GetNumberOfPoints(), read, pieces, partners);
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
  numbers.Cells.Ids.assign(static_cast<std::size_t>(output->GetNumberOfCells()), -1);
  for (int i = 0; i < 3; ++i)
  {
    numbers.Cells.Add(MakeKeys(reader, own[i], i + 1, numbers.Points.Ids), partners, own[i]);
  }
  numbers.Write(output);
}

}
