// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LatticeParts.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"

#include <algorithm>

namespace subdivision
{
namespace
{

LatticeWeights Sum(LatticeWeights a, const LatticeWeights& b, int factor = 1)
{
  for (int i = 0; i < 4; ++i)
  {
    a[i] += factor * b[i];
  }
  return a;
}

template <typename Id>
LatticeWeights GetCorner(const LatticeVertex<Id>& part, int corner)
{
  LatticeWeights weights = part.Weights;
  for (int i = 0; i < 3; ++i)
  {
    weights[i] += (i == corner) != (part.Simplex == 1) ? 1 : 0;
  }
  return weights;
}

}

template <typename Id>
void LatticeParts<Id>::SortCorners(const Id* corners, int size)
{
  const std::array<int, 3> order = subdivision::SortCorners(
    size, [&](int a, int b) { return this->IsBefore(corners[a], corners[b]); });
  this->Corners.fill(-1);
  for (int k = 0; k < size; ++k)
  {
    this->Corners[k] = corners[order[k]];
  }
}

template <typename Id>
bool LatticeParts<Id>::Start(const PatchSimplex<Id>& simplex)
{
  this->Parts.Clear();
  this->Places.clear();
  const bool isFace = simplex.Corners[2] >= 0;
  bool isStarted = false;
  if (isFace)
  {
    isStarted = this->StartFace(simplex.Number);
  }
  else if (this->Strata.Edges[simplex.Number].GetRule() == Rule::Curve)
  {
    this->Dimension = 1;
    this->Simplex = simplex.Number;
    this->SortCorners(simplex.Corners.data(), 2);
    isStarted = true;
  }
  else if (this->FindSide(simplex.Number, -1).IsInside)
  {
    const Id* faces = this->Strata.EdgeRings.GetCarriers(simplex.Number).begin();
    const Id* thirds = this->Strata.EdgeRings.GetMembers(simplex.Number).begin();
    isStarted = this->StartFace(faces[this->IsBefore(thirds[1], thirds[0]) ? 1 : 0]);
  }
  for (int k = 0; k < 3; ++k)
  {
    const Id* found = std::find(simplex.Corners.begin(), simplex.Corners.end(), this->Corners[k]);
    this->Order[k] = this->Corners[k] < 0 || found == simplex.Corners.end()
      ? -1
      : static_cast<int>(found - simplex.Corners.begin());
  }
  return isStarted;
}

template <typename Id>
bool LatticeParts<Id>::StartFace(Id face)
{
  this->Dimension = 2;
  this->Simplex = face;
  this->SortCorners(this->Complex.FaceVertices.data() + 3 * vtkIdType(face), 3);
  for (int k = 0; k < 3; ++k)
  {
    const int corner = this->Complex.VertexInFace(face, this->Corners[k]);
    this->Sides[k] = this->FindSide(
      this->Complex.FaceEdges[3 * vtkIdType(face) + triangle::EdgeOpposite[corner]], face);
  }
  return this->Strata.Faces[face].GetRule() == Rule::Surface;
}

template <typename Id>
typename LatticeParts<Id>::Side LatticeParts<Id>::FindSide(Id edge, Id face) const
{
  Side side;
  const Rule rule = this->Strata.Edges[edge].GetRule();
  const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(edge);
  side.IsCurve = rule == Rule::Curve;
  side.IsInside = rule == Rule::Surface && faces.size() == 2 &&
    FindSectorEdges(this->Strata.Sectors, edge).IsEmpty() &&
    std::all_of(faces.begin(), faces.end(),
      [this](Id at) { return at >= 0 && this->Strata.Faces[at].GetRule() == Rule::Surface; }) &&
    (face < 0 || std::find(faces.begin(), faces.end(), face) != faces.end());
  if (side.IsInside)
  {
    side.Across = faces.begin()[faces.begin()[0] == face ? 1 : 0];
  }
  return side;
}

template <typename Id>
void LatticeParts<Id>::Add(const std::array<double, 3>& at, double* limit)
{
  std::array<double, 3> ordered{};
  for (int k = 0; k < 3; ++k)
  {
    ordered[k] = this->Order[k] < 0 ? 0. : at[this->Order[k]];
  }
  LatticeWeights weights{};
  const int last = FindLatticeLevel(ordered, weights);
  for (int level = 1; level < last; ++level)
  {
    const long long size = 1ll << (last - level);
    Part part;
    part.Dimension = level;
    Place place{};
    long long left = 0;
    for (int k = 0; k < 3; ++k)
    {
      part.Weights[k] = weights[k] / size;
      left += weights[k] % size;
      place.At[k] = static_cast<double>(weights[k] % size) / static_cast<double>(size);
    }
    part.Simplex = left > size ? 1 : 0;
    if (this->IsRegular(part))
    {
      for (double& weight : place.At)
      {
        weight = part.Simplex == 1 ? 1. - weight : weight;
      }
      place.Part = this->Parts.GetNumber(part);
      place.Limit = limit;
      this->Places.push_back(place);
      return;
    }
  }
}

template <typename Id>
bool LatticeParts<Id>::IsRegular(const Part& part) const
{
  for (int i = 0; i <= this->Dimension; ++i)
  {
    const LatticeWeights corner = GetCorner(part, i);
    int zeros = 0;
    for (int k = 0; k <= this->Dimension; ++k)
    {
      const bool isOn = corner[k] == 0;
      zeros += isOn ? 1 : 0;
      if (isOn && this->Dimension == 2 && !this->Sides[k].IsInside && !this->Sides[k].IsCurve)
      {
        return false;
      }
    }
    if (zeros >= this->Dimension)
    {
      return false;
    }
  }
  return true;
}

template <typename Id>
bool LatticeParts<Id>::IsOutside(const LatticeWeights& point) const
{
  bool isOutside = false;
  for (int k = 0; k < 3; ++k)
  {
    isOutside = isOutside || (point[k] < 0 && this->Sides[k].IsCurve);
  }
  return isOutside;
}

/// The columns of a regular part as SheetRows.h has them, and their key.
template <typename Id>
SheetKey LatticeParts<Id>::ListColumns(const Part& part, std::vector<LatticeWeights>& columns) const
{
  SheetKey key;
  columns.clear();
  for (int i = 0; i <= this->Dimension; ++i)
  {
    columns.push_back(GetCorner(part, i));
  }
  if (this->Dimension == 1)
  {
    key.Places = SheetPlaces::CurveEdge;
    const LatticeWeights along = Sum(columns[1], columns[0], -1);
    for (int i = 0; i < 2; ++i)
    {
      key.Fans[i].What = SheetFan::Kind::Open;
      columns.push_back(Sum(columns[i], along, i == 0 ? -1 : 1));
    }
    return key;
  }
  key.Places = SheetPlaces::Face;
  for (int i = 0; i < 3; ++i)
  {
    // All around the corner, from one side of the part to the other one.
    const LatticeWeights own = columns[i];
    const LatticeWeights next = Sum(columns[(i + 1) % 3], own, -1);
    const LatticeWeights last = Sum(columns[(i + 2) % 3], own, -1);
    const std::array<LatticeWeights, 4> around{ { Sum(Sum(own, last), next, -1), Sum(own, next, -1),
      Sum(own, last, -1), Sum(Sum(own, next), last, -1) } };
    const auto isOutside = [this](const LatticeWeights& at) { return this->IsOutside(at); };
    const auto end = std::find_if(around.begin(), around.end(), isOutside);
    SheetFan& fan = key.Fans[i];
    fan.After = static_cast<int>(end - around.begin());
    fan.What = end == around.end() ? SheetFan::Kind::Closed : SheetFan::Kind::Open;
    columns.insert(columns.end(), around.begin(), end);
    if (end != around.end())
    {
      const auto first = std::find_if(around.rbegin(), around.rend(), isOutside);
      fan.Before = static_cast<int>(first - around.rbegin());
      columns.insert(columns.end(), around.rbegin(), first);
    }
  }
  return key;
}

/// The value at a point of a level. One that lies beyond the edge opposite to a corner is in the
/// face across that edge.
template <typename Id>
const double* LatticeParts<Id>::FindValue(const LatticeWeights& point, int level)
{
  Id simplex = this->Simplex;
  LatticeWeights at = point;
  std::array<Id, 3> corners = this->Corners;
  for (int k = 0; k < 3; ++k)
  {
    if (point[k] < 0)
    {
      simplex = this->Sides[k].Across;
      at = Sum(point, { { -1, -1, -1, 0 } });
      at[k] = 1;
      const Id* ofFace = this->Complex.FaceVertices.data() + 3 * vtkIdType(simplex);
      corners[k] = *std::find_if(ofFace, ofFace + 3, [&](Id corner)
        { return corner != corners[(k + 1) % 3] && corner != corners[(k + 2) % 3]; });
    }
  }
  const Id* listed = this->Dimension == 1
    ? this->Complex.EdgeVertices.data() + 2 * vtkIdType(simplex)
    : this->Complex.FaceVertices.data() + 3 * vtkIdType(simplex);
  LatticeWeights weights{};
  for (int k = 0; k <= this->Dimension; ++k)
  {
    weights[std::find(listed, listed + this->Dimension + 1, corners[k]) - listed] = at[k];
  }
  return this->Values.FindValue(this->Dimension, simplex, weights, level, this->Control);
}

template <typename Id>
void LatticeParts<Id>::Run(PatchTree& tree)
{
  StableSort(this->Places, [](const Place& a, const Place& b) { return a.Part < b.Part; });
  std::vector<LatticeWeights> columns;
  for (auto place = this->Places.begin(); place != this->Places.end(); ++place)
  {
    if (place == this->Places.begin() || place[-1].Part != place->Part)
    {
      const Part& part = this->Parts.Vertices[place->Part];
      const SheetKey key = this->ListColumns(part, columns);
      double* values = tree.Start(key, columns.size(), { { 0, 1, 2 } });
      for (const LatticeWeights& column : columns)
      {
        values = std::copy_n(this->FindValue(column, part.Dimension), this->Components, values);
      }
    }
    tree.Find(place->At, place->Limit);
  }
}

SUBDIVISION_COMPILE(class LatticeParts);

}
