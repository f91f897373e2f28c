// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/SimplexTree.h"

#include "Core/Solids/Location/CurveOrder.h"
#include "Core/Solids/Location/TetFrame.h"

#include <cmath>
#include <limits>

namespace subdivision
{
namespace
{

using namespace vectors;

/// Finds the weights of the point of a simplex of `count` corners that is nearest to x; returns the
/// squared distance.
double FindNearestPlace(
  const double* const* corners, int count, const double x[3], double* weights);

/// The same for the nearest of some facets of the simplex: those whose opposite corner has a
/// negative weight in `beyond`, because x lies on their other side; all facets if `beyond` is null,
/// for a flat simplex.
double FindNearestInFacets(
  const double* const* corners, int count, const double x[3], const double* beyond, double* weights)
{
  double best = std::numeric_limits<double>::infinity();
  for (int omitted = 0; omitted < count; ++omitted)
  {
    if (beyond && beyond[omitted] >= 0.)
    {
      continue;
    }
    const double* facet[3];
    double found[3];
    for (int i = 0; i + 1 < count; ++i)
    {
      facet[i] = corners[i + (i >= omitted)];
    }
    const double distance2 = FindNearestPlace(facet, count - 1, x, found);
    if (distance2 < best)
    {
      best = distance2;
      for (int i = 0; i < count; ++i)
      {
        weights[i] = i == omitted ? 0. : found[i - (i > omitted)];
      }
    }
  }
  return best;
}

/// Weights of the projection of x to the line or plane of 2 or 3 corners; false if degenerate.
bool Project(const double* const* corners, int count, const double x[3], double* weights)
{
  const Vector d = Subtract(x, corners[0]);
  const Vector u = Subtract(corners[1], corners[0]);
  const double uu = Dot(u, u);
  if (count == 2)
  {
    weights[1] = Dot(d, u) / uu;
    weights[0] = 1. - weights[1];
    return uu > 0.;
  }
  const Vector v = Subtract(corners[2], corners[0]);
  const double vv = Dot(v, v);
  const Vector normal = Cross(u, v);
  const double nn = Dot(normal, normal);
  if (!(nn > 1e-28 * uu * vv))
  {
    return false;
  }
  weights[1] = Dot(Cross(d, v), normal) / nn;
  weights[2] = Dot(Cross(u, d), normal) / nn;
  weights[0] = 1. - weights[1] - weights[2];
  return true;
}

double FindNearestPlace(const double* const* corners, int count, const double x[3], double* weights)
{
  bool solved = true;
  if (count == 1)
  {
    weights[0] = 1.;
  }
  else
  {
    solved =
      count == 4 ? FindWeightsInTet(corners, x, weights) : Project(corners, count, x, weights);
  }
  if (!solved || std::any_of(weights, weights + count, [](double w) { return w < 0.; }))
  {
    double beyond[4];
    std::copy(weights, weights + count, beyond);
    return FindNearestInFacets(corners, count, x, solved ? beyond : nullptr, weights);
  }
  double distance2 = 0.;
  for (int c = 0; c < 3; ++c)
  {
    double difference = x[c];
    for (int i = 0; i < count; ++i)
    {
      difference -= weights[i] * corners[i][c];
    }
    distance2 += difference * difference;
  }
  return distance2;
}

}

// ------------------------------------------------------------------------------------------------

SimplexTree::SimplexTree(const double* points, int corners, const Buffer<int>& ids)
  : Points(points)
  , Corners(corners)
  , Ids(ids.data())
{
  this->Sort(ids.size() / corners);
  this->MakeBoxes();
}

void SimplexTree::GetPoints(vtkIdType simplex, const double* corners[4]) const
{
  const int* ids = this->GetCorners(simplex);
  for (int i = 0; i < this->Corners; ++i)
  {
    corners[i] = this->Points + 3 * static_cast<vtkIdType>(ids[i]);
  }
}

Box SimplexTree::GetBox(vtkIdType simplex) const
{
  const double* corners[4];
  this->GetPoints(simplex, corners);
  Box box;
  for (int i = 0; i < this->Corners; ++i)
  {
    box.Add(corners[i]);
  }
  return box;
}

void SimplexTree::Sort(vtkIdType size)
{
  Box all;
  ForEachInTurn(size * this->Corners,
    [&](vtkIdType i) { all.Add(this->Points + 3 * static_cast<vtkIdType>(this->Ids[i])); });
  this->Order = SortAlongCurve(size, all,
    [this](vtkIdType i, double* middle)
    {
      const Box box = this->GetBox(i);
      for (int c = 0; c < 3; ++c)
      {
        middle[c] = 0.5 * box.Low[c] + 0.5 * box.High[c];
      }
    });
}

/// Boxes are a little wider than what they hold, for the rounding of distances.
void SimplexTree::MakeBoxes()
{
  vtkIdType size = this->Order.size();
  while (size > 0 && (this->Levels.empty() || size > 1))
  {
    const vtkIdType below = size;
    const Buffer<Box>* children = this->Levels.empty() ? nullptr : &this->Levels.back();
    size = (size + Width - 1) / Width;
    Buffer<Box> boxes(size);
    ForEach(size,
      [&](vtkIdType node)
      {
        const vtkIdType end = std::min(below, (node + 1) * Width);
        Box all;
        for (vtkIdType i = node * Width; i < end; ++i)
        {
          Box box = children ? (*children)[i] : this->GetBox(this->Order[i]);
          for (int c = 0; c < 3 && !children; ++c)
          {
            const double more = 1e-3 * (box.High[c] - box.Low[c]);
            box.Low[c] -= more;
            box.High[c] += more;
          }
          all.Add(box);
        }
        boxes[node] = all;
      });
    this->Levels.push_back(std::move(boxes));
  }
}

struct SimplexTree::Nearest
{
  const double* X;
  PlaceInSimplex Found;
  double Distance2 = std::numeric_limits<double>::infinity();
};

double SimplexTree::GetDistance2(const Box& box, const double x[3])
{
  double sum = 0.;
  for (int c = 0; c < 3; ++c)
  {
    const double outside = std::max({ box.Low[c] - x[c], 0., x[c] - box.High[c] });
    sum += outside * outside;
  }
  return sum;
}

void SimplexTree::Visit(std::size_t level, vtkIdType node, Nearest& nearest) const
{
  const vtkIdType below = level > 0 ? this->Levels[level - 1].size() : this->Order.size();
  const vtkIdType first = node * Width;
  const vtkIdType end = std::min(below, first + Width);
  if (level > 0)
  {
    std::pair<double, vtkIdType> children[Width]; // by distance
    for (vtkIdType i = first; i < end; ++i)
    {
      const std::pair<double, vtkIdType> child{ GetDistance2(this->Levels[level - 1][i], nearest.X),
        i };
      vtkIdType at = i - first;
      for (; at > 0 && child < children[at - 1]; --at)
      {
        children[at] = children[at - 1];
      }
      children[at] = child;
    }
    for (vtkIdType i = 0; i < end - first; ++i)
    {
      // not <: an equally near simplex may have a smaller index
      if (children[i].first <= nearest.Distance2)
      {
        this->Visit(level - 1, children[i].second, nearest);
      }
    }
    return;
  }
  for (vtkIdType i = first; i < end; ++i)
  {
    const vtkIdType simplex = this->Order[i];
    const double* corners[4];
    double weights[4] = { 0., 0., 0., 0. };
    this->GetPoints(simplex, corners);
    const double distance2 = FindNearestPlace(corners, this->Corners, nearest.X, weights);
    if (distance2 < nearest.Distance2 ||
      (distance2 == nearest.Distance2 && simplex < nearest.Found.Simplex))
    {
      nearest.Distance2 = distance2;
      nearest.Found.Simplex = simplex;
      std::copy(weights, weights + 4, nearest.Found.Weights);
    }
  }
}

bool SimplexTree::FindNearest(const double x[3], PlaceInSimplex& place, double& distance2) const
{
  Nearest nearest;
  nearest.X = x;
  if (!this->Levels.empty())
  {
    this->Visit(this->Levels.size() - 1, 0, nearest);
  }
  place = nearest.Found;
  distance2 = nearest.Distance2;
  return place.Simplex >= 0;
}

}
