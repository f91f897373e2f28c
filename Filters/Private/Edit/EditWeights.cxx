// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Edit/EditWeights.h"

#include "Private/Reading/CellReader.h"
#include "Private/Reading/CellsToSimplices.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

double GetDistance(vtkPointSet* mesh, vtkIdType a, vtkIdType b)
{
  double x[3];
  double y[3];
  mesh->GetPoint(a, x);
  mesh->GetPoint(b, y);
  return std::sqrt(vtkMath::Distance2BetweenPoints(x, y));
}

/// Calls visit(a, b) for the edges of all simplices between points of the mesh, an edge of several
/// simplices for each.
template <typename Visit>
void ForEdges(vtkPointSet* mesh, const Visit& visit)
{
  const SimplicesOfCells cells = CellsToSimplices(mesh, nullptr, PlainIds::InPlace);
  const SimplexView view = cells.GetView();
  const vtkIdType points = mesh->GetNumberOfPoints();
  const vtkIdType* ids = view.Connectivity;
  for (const vtkIdType s : InTurn(view.NumberOfSimplices))
  {
    const int size = view.Dimensions[s] + 1;
    for (int i = 0; i < size; ++i)
    {
      for (int k = i + 1; k < size; ++k)
      {
        if (ids[i] < points && ids[k] < points) // no centres
        {
          visit(ids[i], ids[k]);
        }
      }
    }
    ids += size;
  }
}

/// The points at the other ends of all edges, by points.
struct Neighbours
{
  explicit Neighbours(vtkPointSet* mesh)
    : Offsets(static_cast<std::size_t>(mesh->GetNumberOfPoints()) + 1, 0)
  {
    ForEdges(mesh,
      [this](vtkIdType a, vtkIdType b)
      {
        ++this->Offsets[a + 1];
        ++this->Offsets[b + 1];
      });
    for (const std::size_t i : InTurn(this->Offsets.size() - 1))
    {
      this->Offsets[i + 1] += this->Offsets[i];
    }
    this->Ids.resize(static_cast<std::size_t>(this->Offsets.back()));
    std::vector<vtkIdType> next(this->Offsets);
    ForEdges(mesh,
      [this, &next](vtkIdType a, vtkIdType b)
      {
        this->Ids[next[a]++] = b;
        this->Ids[next[b]++] = a;
      });
  }

  std::vector<vtkIdType> Offsets;
  std::vector<vtkIdType> Ids;
};

/// Distances along edges from the selected points, as far as `radius` (E. W. Dijkstra, 1959).
Buffer<double> FindDistancesAlongEdges(
  vtkPointSet* mesh, const Buffer<unsigned char>& points, double radius)
{
  const Neighbours neighbours(mesh);
  Buffer<double> distances(points.size(), std::numeric_limits<double>::infinity());
  using Reached = std::pair<double, vtkIdType>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  for (const vtkIdType i : InTurn(points.size()))
  {
    if (points[i])
    {
      distances[i] = 0.;
      queue.push({ 0., i });
    }
  }
  for (Turns turns; !queue.empty(); turns.Next())
  {
    const auto [distance, at] = queue.top();
    queue.pop();
    for (vtkIdType n = neighbours.Offsets[at];
      distance <= distances[at] && n < neighbours.Offsets[at + 1]; ++n)
    {
      const vtkIdType other = neighbours.Ids[n];
      const double farther = distance + GetDistance(mesh, at, other);
      if (farther < radius && farther < distances[other])
      {
        distances[other] = farther;
        queue.push({ farther, other });
      }
    }
  }
  return distances;
}

/// Straight distances from the selected points, as far as `radius`.
Buffer<double> FindDistancesInSpace(
  vtkPointSet* mesh, const Buffer<unsigned char>& points, double radius)
{
  vtkNew<vtkPoints> chosen;
  chosen->SetDataTypeToDouble();
  for (const vtkIdType i : InTurn(points.size()))
  {
    double x[3];
    mesh->GetPoint(i, x);
    if (points[i] && std::isfinite(x[0] + x[1] + x[2]))
    {
      chosen->InsertNextPoint(x);
    }
  }
  Buffer<double> distances(points.size(), std::numeric_limits<double>::infinity());
  if (chosen->GetNumberOfPoints() == 0)
  {
    return distances;
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(chosen);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  vtkDataArray* all = mesh->GetPoints()->GetData();
  ForEach(points.size(),
    [&](vtkIdType i)
    {
      double x[3];
      double squared = 0.;
      all->GetTuple(i, x);
      if (points[i])
      {
        distances[i] = 0.;
      }
      else if (std::isfinite(x[0] + x[1] + x[2]) &&
        locator->FindClosestPointWithinRadius(radius, x, squared) >= 0)
      {
        distances[i] = std::sqrt(squared);
      }
    });
  return distances;
}

double GetWeight(double part, FalloffShapeKind shape)
{
  const double s = std::max(0., 1. - part);
  return shape == FalloffShapeKind::Linear ? s
    : shape == FalloffShapeKind::Sharp     ? s * s
                                           : s * s * (3. - 2. * s);
}

/// Calls visit(cell, ids, size) for all cells in turn, without ids that are no points.
template <typename Visit>
void ForCells(vtkPointSet* mesh, const Visit& visit)
{
  const CellReader cells(mesh);
  std::vector<vtkIdType> scratch;
  std::vector<vtkIdType> ids;
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    ids.clear();
    std::copy_if(cell.Ids, cell.Ids + cell.Size, std::back_inserter(ids),
      [mesh](vtkIdType id) { return id >= 0 && id < mesh->GetNumberOfPoints(); });
    visit(c, ids);
  }
}

}

Buffer<unsigned char> FindEditedPoints(vtkPointSet* mesh, const SelectedParts* selected)
{
  Buffer<unsigned char> points(
    mesh->GetNumberOfPoints(), static_cast<unsigned char>(selected ? 0 : 1));
  if (!selected)
  {
    return points;
  }
  for (const std::size_t i : InTurn(selected->Points.size()))
  {
    points[static_cast<vtkIdType>(i)] = selected->Points[i];
  }
  if (!selected->Cells.empty())
  {
    ForCells(mesh,
      [&](vtkIdType c, const std::vector<vtkIdType>& ids)
      {
        for (const vtkIdType id : ids)
        {
          points[id] |= selected->Cells[c];
        }
      });
  }
  return points;
}

Buffer<unsigned char> FindEditedCells(
  vtkPointSet* mesh, const SelectedParts* selected, const Buffer<unsigned char>& points)
{
  Buffer<unsigned char> cells(
    mesh->GetNumberOfCells(), static_cast<unsigned char>(selected ? 0 : 1));
  const bool hasPoints = selected && !selected->Points.empty();
  const bool hasCells = selected && !selected->Cells.empty();
  if (hasPoints || hasCells)
  {
    ForCells(mesh,
      [&](vtkIdType c, const std::vector<vtkIdType>& ids)
      {
        const bool isWhole = hasPoints && !ids.empty() &&
          std::all_of(ids.begin(), ids.end(), [&](vtkIdType id) { return points[id] != 0; });
        cells[c] = isWhole || (hasCells && selected->Cells[c]) ? 1 : 0;
      });
  }
  return cells;
}

double FindMeanLength(vtkPointSet* mesh, const Buffer<unsigned char>& points)
{
  double sum = 0.;
  double count = 0.;
  ForEdges(mesh,
    [&](vtkIdType a, vtkIdType b)
    {
      const double length = points[a] || points[b] ? GetDistance(mesh, a, b) : 0.;
      sum += length;
      count += length > 0. ? 1. : 0.;
    });
  return count > 0. && std::isfinite(sum) ? sum / count : 1.;
}

Buffer<double> FindWeights(
  vtkPointSet* mesh, const Buffer<unsigned char>& points, double radius, const EditOptions& options)
{
  Buffer<double> weights(points.size());
  if (radius <= 0.)
  {
    ForEach(points.size(), [&](vtkIdType i) { weights[i] = points[i] ? 1. : 0.; });
    return weights;
  }
  const Buffer<double> distances = options.AlongEdges
    ? FindDistancesAlongEdges(mesh, points, radius)
    : FindDistancesInSpace(mesh, points, radius);
  ForEach(points.size(), [&](vtkIdType i)
    { weights[i] = points[i] ? 1. : GetWeight(distances[i] / radius, options.Shape); });
  return weights;
}

Buffer<double> FindCellWeights(vtkPointSet* mesh, const Buffer<unsigned char>& cells,
  const Buffer<double>& weights, double radius)
{
  Buffer<double> found(cells.size(), 0.);
  ForCells(mesh,
    [&](vtkIdType c, const std::vector<vtkIdType>& ids)
    {
      double sum = 0.;
      for (const vtkIdType id : ids)
      {
        sum += weights[id];
      }
      const bool isNear = radius > 0. && !ids.empty();
      found[c] = cells[c] ? 1. : isNear ? sum / static_cast<double>(ids.size()) : 0.;
    });
  return found;
}

}
