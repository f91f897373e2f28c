// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/PointCopies.h"

#include "Private/ArrayNames.h"

#include <algorithm>
#include <unordered_map>

namespace subdivision
{

std::vector<vtkIdType> FindFirstCopies(vtkPointSet* mesh)
{
  const vtkIdType size = mesh->GetNumberOfPoints();
  std::vector<vtkIdType> firsts;
  if (!HasIds(mesh->GetPointData(), MaterialPointIdsName, size))
  {
    return firsts;
  }
  vtkDataArray* ids = mesh->GetPointData()->GetArray(MaterialPointIdsName);
  std::unordered_map<vtkIdType, vtkIdType> places;
  bool hasCopies = false;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const vtkIdType id = ToId(ids->GetComponent(i, 0));
    const vtkIdType first = id < 0 ? i : places.emplace(id, i).first->second;
    double ours[3];
    double theirs[3];
    mesh->GetPoint(i, ours);
    mesh->GetPoint(first, theirs);
    firsts.push_back(std::equal(ours, ours + 3, theirs) ? first : i);
    hasCopies = hasCopies || firsts.back() != i;
  }
  if (!hasCopies)
  {
    firsts.clear();
  }
  return firsts;
}

}
