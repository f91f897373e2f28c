// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/CoincidentPoints.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/PointCopies.h"
#include "Private/Reading/PointOrder.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/ReadableMesh.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// For each point the one that stands for all at its place; empty if all places differ. A point
/// that is not finite stands for itself.
Buffer<vtkIdType> FindRepresentatives(vtkPointSet* mesh)
{
  const vtkIdType size = mesh->GetNumberOfPoints();
  Buffer<std::array<double, 3>> places(size);
  Buffer<vtkIdType> sorted(size);
  ForEach(size,
    [&](vtkIdType i)
    {
      mesh->GetPoint(i, places[i].data());
      for (double& x : places[i])
      {
        x = std::isfinite(x) ? x : 0.; // the order has to be one
      }
      sorted[i] = i;
    });
  const std::vector<vtkIdType> globalIds = ReadIdsOf(mesh->GetPointData(), size);
  const PointOrder order{ globalIds.empty() ? nullptr : globalIds.data() };
  StableSort(sorted, [&](vtkIdType a, vtkIdType b)
    { return places[a] != places[b] ? places[a] < places[b] : order(a, b); });
  auto isFinite = [mesh](vtkIdType point)
  {
    std::array<double, 3> x;
    mesh->GetPoint(point, x.data());
    return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
  };
  Buffer<vtkIdType> representatives(size);
  vtkIdType first = -1;
  bool merges = false;
  for (const vtkIdType point : InTurn(sorted))
  {
    representatives[point] = point;
    if (isFinite(point))
    {
      const bool isSame = first >= 0 && places[first] == places[point];
      first = isSame ? first : point;
      representatives[point] = first;
      merges = merges || isSame;
    }
  }
  return merges ? std::move(representatives) : Buffer<vtkIdType>();
}

/// Whether two different points among these are at one place.
template <typename T>
bool HasCoincident(const T* begin, const T* end, const Buffer<vtkIdType>& representatives)
{
  const auto exists = [&](T id) { return id >= 0 && id < representatives.size(); };
  return std::any_of(begin, end,
    [&](T a)
    {
      return exists(a) &&
        std::any_of(begin, end,
          [&](T b) { return exists(b) && a != b && representatives[a] == representatives[b]; });
    });
}

vtkSmartPointer<vtkDataObject> MergeIn(vtkPointSet* mesh)
{
  const Buffer<vtkIdType> representatives = FindRepresentatives(mesh);
  if (representatives.empty())
  {
    return mesh;
  }
  const auto merged = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  merged->ShallowCopy(mesh);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  const auto types = grid ? GetCellTypes(grid) : nullptr;
  ChangeCells(merged, representatives.size(),
    [&](vtkIdType cell, auto* begin, auto* end)
    {
      // The loops of a polyhedron's faces end where their first point comes again.
      if (types && types->GetValue(cell) == FaceLoops && HasCoincident(begin, end, representatives))
      {
        return;
      }
      for (; begin != end; ++begin)
      {
        if (*begin >= 0 && *begin < representatives.size())
        {
          *begin = static_cast<std::decay_t<decltype(*begin)>>(representatives[*begin]);
        }
      }
    });
  return merged;
}

}

vtkSmartPointer<vtkDataObject> MergeCoincidentPoints(vtkDataObject* readable)
{
  return ChangeMeshes(readable,
    [](vtkDataObject* data, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(data);
      if (mesh && mesh->GetNumberOfPoints() > 0)
      {
        return MergeIn(mesh);
      }
      return data;
    });
}

}
