// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Run/MarkGeometry.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

namespace subdivision
{
namespace
{

/// Points are the same that differ by less than this fraction of the mesh's diagonal.
constexpr double Tolerance = 1e-6;
constexpr double Forever = std::numeric_limits<double>::infinity();

/// For each point of the geometry the point of the mesh that it is, or -1.
std::vector<vtkIdType> FindPoints(
  vtkPointSet* input, vtkPointSet* geometry, const std::vector<vtkIdType>& meshIds, bool byIds)
{
  std::vector<vtkIdType> found(static_cast<size_t>(geometry->GetNumberOfPoints()), -1);
  if (!byIds)
  {
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(input);
    locator->BuildLocator();
    for (const size_t i : InTurn(found.size()))
    {
      double point[3];
      double distance = 0.;
      geometry->GetPoint(static_cast<vtkIdType>(i), point);
      found[i] =
        locator->FindClosestPointWithinRadius(Tolerance * input->GetLength(), point, distance);
    }
    return found;
  }
  std::unordered_map<vtkIdType, vtkIdType> places;
  for (const size_t i : InTurn(meshIds.size()))
  {
    places.emplace(meshIds[i], static_cast<vtkIdType>(i));
  }
  const std::vector<vtkIdType> ids =
    ReadIdsOf(geometry->GetPointData(), geometry->GetNumberOfPoints());
  for (const size_t i : InTurn(found.size()))
  {
    const vtkIdType id = ids.empty() ? static_cast<vtkIdType>(i) : ids[i];
    const auto place = places.find(id);
    found[i] = place != places.end()                                  ? place->second
      : meshIds.empty() && id >= 0 && id < input->GetNumberOfPoints() ? id
                                                                      : -1;
  }
  return found;
}

/// The simplices of the geometry on points of the mesh, and which of them the mesh has.
class Candidates
{
public:
  explicit Candidates(vtkIdType points)
    : IsAt(static_cast<size_t>(points), 0)
  {
  }

  void Add(const vtkIdType* ids, int size)
  {
    this->IsFound.emplace(MakeKey(ids, size), false);
    for (int i = 0; i < size; ++i)
    {
      this->IsAt[ids[i]] = 1;
    }
  }
  /// Finds the candidates among the faces of a simplex.
  void Find(const vtkIdType* ids, int dimension)
  {
    vtkIdType points[4];
    const auto end = std::copy_if(ids, ids + dimension + 1, points, [this](vtkIdType id)
      { return id < static_cast<vtkIdType>(this->IsAt.size()) && this->IsAt[id]; });
    const int count = static_cast<int>(end - points);
    for (int some = 1; some < 1 << count; ++some)
    {
      vtkIdType face[4];
      int size = 0;
      for (int i = 0; i < count; ++i)
      {
        if (some >> i & 1)
        {
          face[size++] = points[i];
        }
      }
      const auto found = size < 4 ? this->IsFound.find(MakeKey(face, size)) : this->IsFound.end();
      if (found != this->IsFound.end())
      {
        found->second = true;
      }
    }
  }
  bool Has(const vtkIdType* ids, int size) const { return this->IsFound.at(MakeKey(ids, size)); }

private:
  std::vector<char> IsAt;
  std::map<SimplexKey, bool> IsFound;
};

/// Calls visit(number, ids, dimension) for all simplices.
template <typename Visit>
void ForSimplices(const SimplexView& simplices, const Visit& visit)
{
  const vtkIdType* ids = simplices.Connectivity;
  for (const vtkIdType i : InTurn(simplices.NumberOfSimplices))
  {
    visit(i, ids, static_cast<int>(simplices.Dimensions[i]));
    ids += simplices.Dimensions[i] + 1;
  }
}

/// How sharp cells of the geometry are; null: all stay sharp.
vtkDataArray* FindSharpness(
  vtkPointSet* geometry, const std::function<void(const std::string&)>& warn)
{
  vtkDataArray* sharpness = geometry->GetCellData()->GetArray("Sharpness");
  if (sharpness && sharpness->GetNumberOfTuples() != geometry->GetNumberOfCells())
  {
    warn("The cell array \"Sharpness\" of the crease geometry has " +
      std::to_string(sharpness->GetNumberOfTuples()) + " tuples for " +
      std::to_string(geometry->GetNumberOfCells()) +
      " cells: the filter ignores it, and all of its creases stay sharp. Give it one tuple for "
      "each.");
    return nullptr;
  }
  return sharpness;
}

}

void MarkGeometry(vtkPointSet* input, const SimplexView& mesh, const MarkOptions& options,
  const std::function<void(const std::string&)>& warn, SharpTuples& tuples)
{
  vtkPointSet* geometry = options.Geometry;
  const std::vector<vtkIdType> meshIds =
    ReadIdsOf(input->GetPointData(), input->GetNumberOfPoints());
  const std::vector<vtkIdType> points = FindPoints(input, geometry, meshIds, options.ByIds);
  std::vector<vtkIdType> order(points); // the order of the mesh decides on diagonals
  for (vtkIdType& id : order)
  {
    id = id >= 0 && !meshIds.empty() ? meshIds[id] : id;
  }
  const SimplicesOfCells cells = CellsToSimplices(geometry, order.data());
  const auto place = [&](const vtkIdType* ids, int dimension, vtkIdType* placed)
  {
    std::transform(ids, ids + dimension + 1, placed,
      [&](vtkIdType id) { return id < static_cast<vtkIdType>(points.size()) ? points[id] : -1; });
    return dimension < 3 && *std::min_element(placed, placed + dimension + 1) >= 0;
  };
  vtkIdType placed[4];
  Candidates candidates(input->GetNumberOfPoints());
  ForSimplices(cells.GetView(),
    [&](vtkIdType, const vtkIdType* ids, int dimension)
    {
      if (place(ids, dimension, placed))
      {
        candidates.Add(placed, dimension + 1);
      }
    });
  ForSimplices(
    mesh, [&](vtkIdType, const vtkIdType* ids, int dimension) { candidates.Find(ids, dimension); });
  vtkDataArray* sharpness = FindSharpness(geometry, warn);
  vtkIdType lost = 0;
  vtkIdType first = -1;
  ForSimplices(cells.GetView(),
    [&](vtkIdType i, const vtkIdType* ids, int dimension)
    {
      if (place(ids, dimension, placed) && candidates.Has(placed, dimension + 1))
      {
        const vtkIdType cell = cells.ParentCells.empty() ? i : cells.ParentCells[i];
        const bool stays = !sharpness || dimension == 0 || (dimension == 2 && options.FacesStay);
        const double s = stays ? Forever : sharpness->GetComponent(cell, 0);
        auto& to = tuples.Tuples.Tuples[dimension];
        if (dimension > 0 && s > 0.)
        {
          tuples.Sharpness[dimension].push_back(s);
        }
        if (s > 0.)
        {
          to.insert(to.end(), placed, placed + dimension + 1);
        }
      }
      else if (lost++ == 0)
      {
        first = cells.ParentCells.empty() ? i : cells.ParentCells[i];
      }
    });
  if (lost > 0 && options.TellsLost)
  {
    warn(std::to_string(lost) + " of " + std::to_string(cells.GetView().NumberOfSimplices) +
      " vertices, lines and triangles of the crease geometry are no vertices, edges and triangles "
      "of the mesh, the first in cell " +
      std::to_string(first) +
      " of the geometry: the filter ignores them. Their points have to be points of the mesh "
      "(CreasePoints), and lines have to follow its edges.");
  }
}

}
