// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/SimplexTree.h"

#include "Core/Solids/Location/CurveOrder.h"
#include "Core/Solids/Location/TetFrame.h"

#include <algorithm>
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

/// The same for the nearest of some facets of the simplex: facets whose opposite corner has a
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

/// Makes the box of a simplex a little wider, for the rounding of distances and weights.
Box Widen(Box box)
{
  const double most =
    std::max({ box.High[0] - box.Low[0], box.High[1] - box.Low[1], box.High[2] - box.Low[2] });
  for (int c = 0; c < 3; ++c)
  {
    const double more = 1e-3 * (box.High[c] - box.Low[c]) + 1e-10 * most;
    box.Low[c] -= more;
    box.High[c] += more;
  }
  return box;
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
  if (corners == 3)
  {
    this->MakeSlabs();
  }
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
          all.Add(children ? (*children)[i] : Widen(this->GetBox(this->Order[i])));
        }
        boxes[node] = all;
      });
    this->Levels.push_back(std::move(boxes));
  }
}

void SimplexTree::MakeSlabs()
{
  vtkIdType width = Width;
  const std::size_t levels = std::min(LevelsWithSlabs, this->Levels.size());
  for (std::size_t level = 0; level < levels; ++level, width *= Width)
  {
    Buffer<Slab> slabs(this->Levels[level].size());
    ForEach(slabs.size(),
      [&](vtkIdType node)
      {
        slabs[node] =
          this->MakeSlab(node * width, std::min(this->GetNumberOfSimplices(), (node + 1) * width));
      });
    this->Slabs.push_back(std::move(slabs));
  }
}

/// The slab of triangles [begin, end) along the curve; its normal is the mean of theirs.
SimplexTree::Slab SimplexTree::MakeSlab(vtkIdType begin, vtkIdType end) const
{
  const double* corners[4];
  Vector sum{};
  for (vtkIdType i = begin; i < end; ++i)
  {
    this->GetPoints(this->Order[i], corners);
    const Vector normal = Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]));
    const double sign = Dot(normal, sum) < 0. ? -1. : 1.; // whichever way it is turned
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += sign * normal[c];
    }
  }
  const double length = std::sqrt(Dot(sum, sum));
  const bool isKnown = std::isnormal(length);
  Slab slab{ {}, {}, 0., 0. };
  this->GetPoints(this->Order[begin], corners);
  for (int c = 0; c < 3; ++c)
  {
    slab.Corner[c] = corners[0][c];
    slab.Normal[c] = isKnown ? sum[c] / length : 0.;
  }
  for (vtkIdType i = begin; i < end; ++i)
  {
    this->GetPoints(this->Order[i], corners);
    for (int k = 0; k < this->Corners; ++k)
    {
      const Vector from = Subtract(corners[k], slab.Corner);
      const double height = Dot(from, { slab.Normal[0], slab.Normal[1], slab.Normal[2] });
      slab.Low = std::min(slab.Low, height);
      slab.High = std::max(slab.High, height);
    }
  }
  return slab;
}

double SimplexTree::Slab::GetDistance(const double x[3]) const
{
  double height = 0.;
  double slack = 0.;
  for (int c = 0; c < 3; ++c)
  {
    const double difference = x[c] - this->Corner[c];
    height += difference * this->Normal[c];
    slack += std::abs(difference);
  }
  const double outside = std::max(this->Low - height, height - this->High);
  return outside - 1e-9 * (slack + (this->High - this->Low)); // for rounding
}

struct SimplexTree::Nearest
{
  const double* X;
  PlaceInSimplex Found;
  double Distance2 = std::numeric_limits<double>::infinity();
  double Direction[3] = { 0., 0., 0. }; ///< of length 1, to the place that was found

  void Take(vtkIdType simplex, const double* const* corners, int count, const double* weights,
    double distance2);
  bool IsNearer(const double* const* corners, int count) const;
};

void SimplexTree::Nearest::Take(vtkIdType simplex, const double* const* corners, int count,
  const double* weights, double distance2)
{
  this->Distance2 = distance2;
  this->Found.Simplex = simplex;
  std::copy(weights, weights + 4, this->Found.Weights);
  Vector to{ -this->X[0], -this->X[1], -this->X[2] };
  for (int c = 0; c < 3; ++c)
  {
    for (int k = 0; k < count; ++k)
    {
      to[c] += weights[k] * corners[k][c];
    }
  }
  const double length = std::sqrt(Dot(to, to));
  for (int c = 0; c < 3; ++c)
  {
    this->Direction[c] = std::isnormal(length) ? to[c] / length : 0.;
  }
}

/// Whether a simplex may be as near as the place that was found, or nearer: false if it lies behind
/// the plane through this place across the direction to it, by more than rounding.
bool SimplexTree::Nearest::IsNearer(const double* const* corners, int count) const
{
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < count; ++k)
  {
    double along = 0.;
    double slack = 0.;
    for (int c = 0; c < 3; ++c)
    {
      const double difference = corners[k][c] - this->X[c];
      along += difference * this->Direction[c];
      slack += std::abs(difference);
    }
    least = std::min(least, along - 1e-9 * slack);
  }
  return !(least > 0. && least * least > this->Distance2);
}

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

/// A square of a distance that no simplex of a node is nearer than.
double SimplexTree::GetLeastDistance2(std::size_t level, vtkIdType node, const double x[3]) const
{
  const double distance2 = GetDistance2(this->Levels[level][node], x);
  if (level >= this->Slabs.size())
  {
    return distance2;
  }
  const double ofSlab = std::max(0., this->Slabs[level][node].GetDistance(x));
  return std::max(distance2, ofSlab * ofSlab);
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
      const std::pair<double, vtkIdType> child{ this->GetLeastDistance2(level - 1, i, nearest.X),
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
    if (!nearest.IsNearer(corners, this->Corners))
    {
      continue;
    }
    const double distance2 = FindNearestPlace(corners, this->Corners, nearest.X, weights);
    if (distance2 < nearest.Distance2 ||
      (distance2 == nearest.Distance2 && simplex < nearest.Found.Simplex))
    {
      nearest.Take(simplex, corners, this->Corners, weights, distance2);
    }
  }
}

Buffer<vtkIdType> SimplexTree::SortPoints(
  vtkIdType size, const std::function<void(vtkIdType i, double x[3])>& getPoint) const
{
  return SortAlongCurve(size, this->Levels.empty() ? Box() : this->Levels.back()[0], getPoint);
}

void SimplexTree::FindHolding(const double (*points)[3], int size, const HoldTolerances& tolerances,
  PlaceInSimplex* places) const
{
  Box around; // of the points that some tetrahedron may hold
  for (int i = 0; i < size; ++i)
  {
    places[i] = PlaceInSimplex();
    if (!this->Levels.empty() && this->Levels.back()[0].Holds(points[i]))
    {
      around.Add(points[i]);
    }
  }
  const std::size_t most = size > 1 ? 4 * static_cast<std::size_t>(size) + 64 : SIZE_MAX;
  std::vector<vtkIdType> tets;
  this->ForEachWhere([&](const Box& box) { return tets.size() <= most && box.Meets(around); },
    [&](vtkIdType tet) { tets.push_back(tet); });
  if (tets.size() > most) // the points are not near each other
  {
    this->FindHolding(points, size / 2, tolerances, places);
    this->FindHolding(points + size / 2, size - size / 2, tolerances, places + size / 2);
    return;
  }
  bool isTight[MostAtOnce] = {};
  for (vtkIdType tet : tets)
  {
    const double* corners[4];
    this->GetPoints(tet, corners);
    const Box box = Widen(this->GetBox(tet));
    if (!box.Meets(around))
    {
      continue;
    }
    const TetFrame frame(corners);
    const int lookedAt = frame.IsFlat() ? 0 : size;
    for (int i = 0; i < lookedAt; ++i)
    {
      const bool isFirst = places[i].Simplex < 0 || tet < places[i].Simplex;
      if ((isTight[i] && !isFirst) || !box.Holds(points[i]))
      {
        continue;
      }
      const std::array<double, 4> weights = frame.GetWeights(points[i]);
      const double least = *std::min_element(weights.begin(), weights.end());
      const bool isBetter = !isTight[i] && least >= -tolerances.Tight;
      if (least >= -tolerances.Loose &&
        (isBetter || (isFirst && (!isTight[i] || least >= -tolerances.Tight))))
      {
        isTight[i] = isTight[i] || isBetter;
        places[i].Simplex = tet;
        std::copy(weights.begin(), weights.end(), places[i].Weights);
      }
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
