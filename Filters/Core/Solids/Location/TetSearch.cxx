// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/TetSearch.h"

#include "Core/Solids/Location/BinnedPoints.h"
#include "Core/Solids/Location/PointGroups.h"
#include "Core/Solids/Location/TetFrame.h"

#include <array>
#include <cmath>

namespace subdivision
{
namespace
{

/// Gives lower bounds of the least weight of points in a tetrahedron, fast.
class WeightBounds
{
public:
  /// `box` holds the tetrahedron and all points that are asked for.
  WeightBounds(const TetFrame& tet, const Box& box)
    : First(tet.First)
  {
    double reach = 0.;
    for (int c = 0; c < 3; ++c)
    {
      reach += box.High[c] - box.Low[c];
      for (int i = 0; i < 3; ++i)
      {
        this->Gradients[i][c] = tet.Normals[i][c] / tet.Volume;
      }
    }
    // The weights of TetFrame differ from these by what rounding leaves in the normals and the
    // volume, relative to the latter, and a step more: some 5e-15 times the square of this.
    const double flatness = reach * reach * reach / std::abs(tet.Volume);
    this->Margin = 1e-13 * flatness * flatness;
  }

  /// Sets the least weight of each of the points [begin, end).
  void Compute(const BinnedPoints& points, int begin, int end, double* least) const
  {
    const double* x = points.Coordinates[0].data() + begin;
    const double* y = points.Coordinates[1].data() + begin;
    const double* z = points.Coordinates[2].data() + begin;
    const double first[3] = { this->First[0], this->First[1], this->First[2] };
    const auto g = this->Gradients; // a copy, which no write to `least` can change
    for (int i = 0; i < end - begin; ++i)
    {
      const double dx = x[i] - first[0];
      const double dy = y[i] - first[1];
      const double dz = z[i] - first[2];
      const double a = dx * g[0][0] + dy * g[0][1] + dz * g[0][2];
      const double b = dx * g[1][0] + dy * g[1][1] + dz * g[1][2];
      const double c = dx * g[2][0] + dy * g[2][1] + dz * g[2][2];
      const double rest = 1. - a - b - c;
      const double ab = a < b ? a : b;
      const double cr = c < rest ? c : rest;
      least[i] = ab < cr ? ab : cr;
    }
  }

  double Margin; ///< by which they may be too small

private:
  const double* First;
  std::array<std::array<double, 3>, 3> Gradients;
};

}

struct TetSearch::Group
{
  BinnedPoints Points;
  HoldTolerances Tolerances;
  int* Tets;
  double* Weights;
};

TetSearch::TetSearch(const double* points, const Buffer<int>& corners)
  : Points(points)
  , Corners(corners.data())
  , Size(static_cast<int>(corners.size() / 4))
{
  int size = this->Size;
  while (size > 0 && (this->Levels.empty() || size > 1))
  {
    const int below = size;
    const Buffer<Box>* children = this->Levels.empty() ? nullptr : &this->Levels.back();
    size = (size + Width - 1) / Width;
    Buffer<Box> boxes(size);
    ForEach(size,
      [&](vtkIdType node)
      {
        Box box;
        const int first = static_cast<int>(node) * Width;
        for (int i = first; i < std::min(below, first + Width); ++i)
        {
          box.Add(children ? (*children)[i] : this->GetBox(i));
        }
        boxes[node] = box;
      });
    this->Levels.push_back(std::move(boxes));
  }
}

void TetSearch::GetCorners(int tet, const double* corners[4]) const
{
  const int* ids = this->Corners + 4 * static_cast<vtkIdType>(tet);
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = this->Points + 3 * static_cast<vtkIdType>(ids[i]);
  }
}

/// A box that is a little wider than the tetrahedron, for tolerances and rounding.
Box TetSearch::GetBox(int tet) const
{
  const double* corners[4];
  this->GetCorners(tet, corners);
  Box box;
  double most = 0.;
  for (int i = 0; i < 4; ++i)
  {
    box.Add(corners[i]);
  }
  for (int c = 0; c < 3; ++c)
  {
    most = std::max(most, box.High[c] - box.Low[c]);
  }
  for (int c = 0; c < 3; ++c)
  {
    const double more = 1e-3 * (box.High[c] - box.Low[c]) + 1e-10 * most;
    box.Low[c] -= more;
    box.High[c] += more;
  }
  return box;
}

void TetSearch::Find(const double* points, int size, const HoldTolerances& tolerances, int* tets,
  double* weights) const
{
  const Box nowhere;
  const int most = std::clamp(size / 64, 1024, 16384); // for a core's own cache
  const PointGroups groups(points, size, this->Size > 0 ? this->Levels.back()[0] : nowhere, most);
  ForRangesOfBlocks(groups.GetNumberOfGroups(),
    [&](vtkIdType begin, vtkIdType end)
    {
      Group group{ {}, tolerances, tets, weights };
      for (vtkIdType g = begin; g < end; ++g)
      {
        const int first = groups.Starts[g];
        group.Points.Load(points, groups.Order.data() + first, groups.Starts[g + 1] - first);
        for (int point : group.Points.Ids)
        {
          tets[point] = -1;
        }
        this->Visit(this->Levels.size() - 1, 0, group);
      }
    });
  const int outside = groups.Starts.back();
  ForEach(size - outside, [&](vtkIdType i) { tets[groups.Order[outside + i]] = -1; });
}

/// Visits the tetrahedra in ascending order.
void TetSearch::Visit(std::size_t level, int node, Group& group) const
{
  if (!group.Points.GetBox().Meets(this->Levels[level][node]))
  {
    return;
  }
  const int below = level > 0 ? static_cast<int>(this->Levels[level - 1].size()) : this->Size;
  const int first = node * Width;
  for (int i = first; i < below && i < first + Width; ++i)
  {
    level > 0 ? this->Visit(level - 1, i, group) : this->FindInTet(i, group);
  }
}

void TetSearch::FindInTet(int tet, Group& group) const
{
  BinnedPoints& points = group.Points;
  const Box box = this->GetBox(tet);
  if (!points.GetBox().Meets(box))
  {
    return;
  }
  const auto& rows = points.FindRows(box);
  if (rows.empty())
  {
    return;
  }
  const double* corners[4];
  this->GetCorners(tet, corners);
  const TetFrame frame(corners);
  if (frame.IsFlat())
  {
    return;
  }
  const WeightBounds bounds(frame, box);
  const double tight = -group.Tolerances.Tight;
  const double loose = -group.Tolerances.Loose;
  const double threshold = loose - bounds.Margin;
  auto decide = [&](int i)
  {
    const double x[3] = { points.Coordinates[0][i], points.Coordinates[1][i],
      points.Coordinates[2][i] };
    const std::array<double, 4> weights = frame.GetWeights(x);
    const double least = *std::min_element(weights.begin(), weights.end());
    Hold& hold = points.Holds[i];
    if (least >= tight || (least >= loose && hold == Hold::None))
    {
      hold = least >= tight ? Hold::Tight : Hold::Loose;
      const auto point = static_cast<vtkIdType>(points.Ids[i]);
      group.Tets[point] = tet;
      std::copy(weights.begin() + 1, weights.end(), group.Weights + 3 * point);
    }
  };
  constexpr int most = 64;
  double least[most];
  for (auto [begin, end] : rows)
  {
    for (; begin < end; begin += most)
    {
      const int last = std::min(end, begin + most);
      bounds.Compute(points, begin, last, least);
      for (int i = begin; i < last; ++i)
      {
        if (!(least[i - begin] < threshold) && points.Holds[i] != Hold::Tight)
        {
          decide(i);
        }
      }
    }
  }
}

}
