// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/GreenLeaves.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Run/StampFields.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <iterator>

namespace subdivision
{

GreenLeaves::GreenLeaves(vtkPointSet* mesh)
{
  vtkDataArray* leaves = FindField(LeavesName, mesh->GetFieldData(), LeafComponents);
  if (leaves && HasIds(mesh->GetCellData(), GreenParentName, mesh->GetNumberOfCells()))
  {
    this->Parents = mesh->GetCellData()->GetArray(GreenParentName);
    this->Leaves = leaves;
  }
}

vtkIdType GreenLeaves::GetLeaf(vtkIdType cell) const
{
  const vtkIdType leaf = this->Parents ? ToId(this->Parents->GetComponent(cell, 0)) : -1;
  return leaf >= 0 && leaf < this->Leaves->GetNumberOfTuples() ? leaf : -1;
}

vtkIdType GreenLeaves::GetPoint(vtkIdType leaf, int component) const
{
  return std::max<vtkIdType>(ToId(this->Leaves->GetComponent(leaf, component)), -1);
}

int GreenLeaves::CountParts(vtkIdType leaf) const
{
  int midpoints = 0;
  for (int c = 4; c < LeafComponents; ++c)
  {
    midpoints += this->GetPoint(leaf, c) >= 0 ? 1 : 0;
  }
  return midpoints == 1 ? 2 : 4;
}

void TakeLeaves(const std::vector<vtkPointSet*>& from,
  const std::function<CellOfMesh(vtkIdType)>& sourceOf,
  const std::function<vtkIdType(std::size_t, vtkIdType)>& placeOf, vtkPointSet* mesh)
{
  std::vector<GreenLeaves> given;
  for (vtkPointSet* one : from)
  {
    given.emplace_back(one);
  }
  vtkDataArray* parents = mesh->GetCellData()->GetArray(GreenParentName);
  if (!parents || parents->GetNumberOfComponents() != 1 ||
    std::all_of(
      given.begin(), given.end(), [](const GreenLeaves& leaves) { return leaves.IsEmpty(); }))
  {
    return;
  }
  std::vector<vtkIdType> taken;
  CellOfMesh last(0, -1); // the leaf of the cell before
  vtkIdType parent = -1;
  for (const vtkIdType c : InTurn(parents->GetNumberOfTuples()))
  {
    const auto [i, cell] = sourceOf(c);
    const CellOfMesh leaf(i, given[i].GetLeaf(cell));
    if (leaf != last)
    {
      last = leaf;
      vtkIdType tuple[LeafComponents];
      bool isThere = leaf.second >= 0;
      for (int k = 0; isThere && k < LeafComponents; ++k)
      {
        const vtkIdType point = given[i].GetPoint(leaf.second, k);
        tuple[k] = point < 0 ? -1 : placeOf(i, point);
        isThere = point < 0 || tuple[k] >= 0;
      }
      parent = isThere ? static_cast<vtkIdType>(taken.size()) / LeafComponents : -1;
      if (isThere)
      {
        std::copy(std::begin(tuple), std::end(tuple), std::back_inserter(taken));
      }
    }
    parents->SetComponent(c, 0, static_cast<double>(parent));
  }
  const auto leaves = MakeField<vtkIdTypeArray>(LeavesName, std::vector<vtkIdType>());
  leaves->SetNumberOfComponents(LeafComponents);
  leaves->SetNumberOfTuples(static_cast<vtkIdType>(taken.size()) / LeafComponents);
  std::copy(taken.begin(), taken.end(), leaves->GetPointer(0));
  mesh->GetFieldData()->AddArray(leaves);
}

void TakeLeaves(vtkPointSet* from, const std::vector<vtkIdType>& cells,
  const std::vector<vtkIdType>& points, vtkPointSet* mesh)
{
  TakeLeaves(
    { from }, [&](vtkIdType c) { return CellOfMesh(0, cells[c]); },
    [&](std::size_t, vtkIdType point)
    {
      const auto found = std::lower_bound(points.begin(), points.end(), point);
      return found == points.end() || *found != point ? vtkIdType(-1) : found - points.begin();
    },
    mesh);
}

}
