// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/SurfaceStarLevels.h"

#include "Core/Memory/Loops.h"

#include <algorithm>
#include <limits>

namespace subdivision
{
namespace
{

using Kind = SurfaceStar::Kind;
using Place = StarMesh::Place;

/// Where the vertices of all levels lie in the control mesh. New ones are in the middle of their
/// parents, but steps that turn the mesh need care. After the second of them vertices lie on edges
/// of the level before both, which the flat mesh bends where it is irregular.
class PlaceFinder
{
public:
  PlaceFinder(const SurfaceStarLevels& levels, const std::vector<Place>& control)
    : Made(levels)
    , Places{ control }
  {
  }

  std::vector<std::vector<Place>> Find(int steps)
  {
    const SurfaceScheme<int>& scheme = this->Made.GetScheme();
    for (int level = 0; level < steps; ++level)
    {
      const bool isSecond = level % 2 == 1 && !scheme.HalvesEdges();
      const SparseRows<int> step = this->Made.GetStep(level);
      std::vector<Place> made(static_cast<std::size_t>(step.GetNumberOfRows()));
      for (std::size_t v = 0; v < made.size(); ++v)
      {
        const auto row = static_cast<vtkIdType>(v);
        const std::vector<vtkIdType> parents = this->GetParents(level, row);
        made[v] = parents.size() == 2 && scheme.NeedsTriangles() && !scheme.HalvesEdges()
          ? this->CutInThree(step, row, parents)
          : isSecond && parents.size() > 2 ? this->FindOnEdge(level, parents)
                                           : this->Mix(this->Places[level], parents);
      }
      this->Places.push_back(std::move(made));
    }
    return this->Places;
  }

private:
  std::vector<vtkIdType> GetParents(int level, vtkIdType row) const
  {
    std::vector<vtkIdType> parents;
    this->Made.GetScheme().GetParents(this->Made.Get(level), row, parents);
    return parents;
  }

  /// A vertex as often as it is in the list.
  static Place Mix(const std::vector<Place>& places, const std::vector<vtkIdType>& parents)
  {
    Place sum{ { 0., 0. } };
    for (const vtkIdType parent : parents)
    {
      sum[0] += places[parent][0] / static_cast<double>(parents.size());
      sum[1] += places[parent][1] / static_cast<double>(parents.size());
    }
    return sum;
  }

  /// On an edge that sqrt(3) cuts in three, nearer to the end with the larger weight.
  Place CutInThree(
    const SparseRows<int>& step, vtkIdType row, const std::vector<vtkIdType>& ends) const
  {
    const auto weigh = [&](vtkIdType end)
    { return SurfaceStarLevels::SumRow(step, row, [end](int v) { return v == end ? 1. : 0.; }); };
    const vtkIdType near = weigh(ends[0]) > weigh(ends[1]) ? ends[0] : ends[1];
    return this->Mix(this->Places.back(), { ends[0], ends[1], near });
  }

  /// The middle of a face of two centres and the edge between them (4-8); of a face with one end of
  /// this edge (sqrt(3)) the third at that end.
  Place FindOnEdge(int level, const std::vector<vtkIdType>& parents) const
  {
    const std::vector<Place>& before = this->Places[level - 1];
    std::vector<vtkIdType> old;
    std::vector<vtkIdType> common;
    for (const vtkIdType parent : parents)
    {
      const std::vector<vtkIdType> from = this->GetParents(level - 1, parent);
      if (from.size() == 1)
      {
        old.push_back(parent);
        continue;
      }
      const bool isFirst = common.empty();
      std::vector<vtkIdType> both;
      std::copy_if(from.begin(), from.end(), std::back_inserter(both), [&](vtkIdType v)
        { return isFirst || std::find(common.begin(), common.end(), v) != common.end(); });
      common = both;
    }
    if (old.size() == 1)
    {
      common.push_back(old[0]);
      return Mix(before, common);
    }
    return Mix(before, old);
  }

  const SurfaceStarLevels& Made;
  std::vector<std::vector<Place>> Places;
};

}

Period GetPeriod(SurfaceSchemeKind scheme)
{
  switch (scheme)
  {
    case SurfaceSchemeKind::SqrtThree:
      return { 2, 3. };
    case SurfaceSchemeKind::FourEight:
    case SurfaceSchemeKind::Midedge:
      return { 2, 2. };
    default:
      return { 1, 2. };
  }
}

SurfaceStarLevels::SurfaceStarLevels(const SurfaceStar& star, const StarMesh& mesh, int steps)
{
  const auto scheme = MakeSurfaceScheme<int>(star.Scheme, star.ModifiedBoundary, star.Weights);
  SurfaceLevel<int> control;
  PolygonList<int> faces = mesh.MakeList();
  control.Mesh = BuildPolygonMesh(std::move(faces), control.Lines);
  SurfaceFeatures features;
  features.DartEnds = true;
  if (star.EndsCrease)
  {
    features.SharpEdges.assign(control.Mesh.GetNumberOfEdges(), 0);
    for (const vtkIdType e : InTurn(control.Mesh.GetNumberOfEdges()))
    {
      const int* ends = control.Mesh.EdgeVertices.data() + 2 * e;
      features.SharpEdges[e] = mesh.IsOnFirstRay(ends[0]) && mesh.IsOnFirstRay(ends[1]) ? 1 : 0;
    }
  }
  const auto size = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  features.Corners.assign(size, 0);
  features.Corners[0] = star.Where == Kind::Corner ? 1 : 0;
  if (star.Where == Kind::Corner)
  {
    features.Angles.assign(size, -1.);
    features.Flatness.assign(size, -1.);
    features.Angles[0] = star.Angle;
    features.Flatness[0] = star.Flatness;
  }
  control.Tags = ClassifySurface(control.Mesh, *scheme, features, mesh.GetPoints());
  this->Steps = std::make_unique<SurfaceSteps<int>>(
    std::move(control), scheme, steps, LastLevel::Whole, [](double) { return false; });
}

SparseRows<int> SurfaceStarLevels::GetSteps(int from, int to) const
{
  Matrix product = this->GetStep(from);
  for (int step = from + 1; step < to; ++step)
  {
    product = Multiply(this->GetStep(step), product);
  }
  return product;
}

std::vector<Place> SurfaceStarLevels::Apply(int from, int to, std::vector<Place> values) const
{
  for (int step = from; step < to; ++step)
  {
    const Matrix rows = this->GetStep(step);
    std::vector<Place> next(static_cast<std::size_t>(rows.GetNumberOfRows()));
    for (std::size_t v = 0; v < next.size(); ++v)
    {
      for (int c = 0; c < 2; ++c)
      {
        next[v][c] =
          SumRow(rows, static_cast<vtkIdType>(v), [&](int column) { return values[column][c]; });
      }
    }
    values = std::move(next);
  }
  return values;
}

std::vector<Place> PlaceValues(
  const std::vector<double>& values, const std::vector<int>& vertices, std::size_t size)
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<Place> placed(size, Place{ { unknown, unknown } });
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    placed[vertices[i]] = { { values[2 * i], values[2 * i + 1] } };
  }
  return placed;
}

std::vector<std::vector<Place>> FindStarPlaces(
  const SurfaceStarLevels& levels, const std::vector<Place>& control, int steps)
{
  return PlaceFinder(levels, control).Find(steps);
}

}
