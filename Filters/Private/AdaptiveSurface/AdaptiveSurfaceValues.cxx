// SPDX-License-Identifier: BSD-3-Clause
#include "Private/AdaptiveSurface/AdaptiveSurfaceValues.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include <algorithm>

namespace subdivision
{

/// The origin of a new vertex: the origin of the earliest parent, and of parents of the same level
/// the smallest. So it does not depend on the order of splits.
template <typename Id>
vtkIdType AdaptiveSurfaceValues<Id>::FindOrigin(Id vertex) const
{
  return this->Origins[this->Mesh.FindFirstParent(vertex,
    [this](Id a, Id b)
    {
      const int levels[2] = { this->GetLevel(a), this->GetLevel(b) };
      return levels[0] != levels[1] ? levels[0] < levels[1] : this->Origins[a] < this->Origins[b];
    })];
}

/// Computes the first value and the limit of each new vertex from vertices of earlier levels. The
/// array gets the limit.
template <typename Id>
void AdaptiveSurfaceValues<Id>::AddVertices(const std::vector<Id>& vertices)
{
  const vtkIdType size = this->Mesh.GetNumberOfVertices();
  const int components = this->Components;
  const vtkIdType given = this->Mesh.GetNumberOfControlVertices();
  double* limits = this->Array.Grow(size);
  if (!this->IsSmooth)
  {
    this->Origins.resize(static_cast<std::size_t>(size));
    for (const Id v : InTurn(vertices)) // level by level
    {
      this->Origins[v] = v < given ? v : this->FindOrigin(v);
      if (v >= given)
      {
        std::copy_n(limits + this->Origins[v] * components, components, limits + v * components);
      }
    }
    return;
  }
  BetweenLoops::Act();
  this->Nodes.resize(static_cast<std::size_t>(2 * size * components));
  BetweenLoops::Act();
  const bool isFirst = !vertices.empty() && vertices[0] < given;
  std::vector<double> control(
    isFirst ? limits : nullptr, isFirst ? limits + given * components : nullptr);
  for (std::size_t begin = 0; begin < vertices.size();)
  {
    std::size_t end = begin;
    while (
      end < vertices.size() && this->GetLevel(vertices[end]) == this->GetLevel(vertices[begin]))
    {
      ++end;
    }
    double* nodes = this->Nodes.data();
    const double* from = this->GetLevel(vertices[begin]) < 0 ? control.data() : nodes;
    ForRanges(static_cast<vtkIdType>(end - begin),
      [&](vtkIdType first, vtkIdType last)
      {
        RowBlock<Id> rows;
        for (vtkIdType i = first; i < last; ++i)
        {
          const vtkIdType v = vertices[begin + i];
          double* out = nodes + 2 * v * components;
          rows.Clear();
          this->Rows.AppendVertex(static_cast<Id>(v), rows);
          rows.Apply(from, out, components);
          std::copy_n(out + components, components, limits + v * components);
        }
      });
    begin = end;
  }
}

/// Computes the limits of the points that new faces and segments would get if they were split.
template <typename Id>
void AdaptiveSurfaceValues<Id>::AddCentres(const std::vector<Id>& faces, vtkIdType firstSegment)
{
  const int components = this->Components;
  this->Centres.resize(static_cast<std::size_t>(this->Mesh.GetNumberOfFaces() * components));
  BetweenLoops::Act();
  this->FirstCentres.resize(this->Centres.size());
  BetweenLoops::Act();
  this->Thirds.resize(static_cast<std::size_t>(2 * this->Mesh.GetNumberOfSegments() * components));
  auto forRanges = [&](vtkIdType size, const auto& append, double* out, const auto& place)
  {
    ForRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        RowBlock<Id> rows;
        for (vtkIdType i = begin; i < end; ++i)
        {
          rows.Clear();
          append(i, rows);
          rows.Apply(this->Nodes.data(), out + place(i) * components, components);
        }
      });
  };
  auto ofFaces = [&](auto append, double* out)
  {
    forRanges(
      static_cast<vtkIdType>(faces.size()),
      [&](vtkIdType i, RowBlock<Id>& rows)
      {
        if (!this->Mesh.IsCut(faces[i]))
        {
          (this->Rows.*append)(faces[i], rows);
        }
      },
      out, [&](vtkIdType i) { return static_cast<vtkIdType>(faces[i]); });
  };
  ofFaces(&AdaptiveSqrtThreeRows<Id>::AppendCentreLimit, this->Centres.data());
  ofFaces(&AdaptiveSqrtThreeRows<Id>::AppendCentre, this->FirstCentres.data());
  forRanges(
    2 * (this->Mesh.GetNumberOfSegments() - firstSegment), [&](vtkIdType i, RowBlock<Id>& rows)
    { this->Rows.AppendThirdLimit(static_cast<Id>(firstSegment + i / 2), i % 2 == 1, rows); },
    this->Thirds.data(), [&](vtkIdType i) { return 2 * firstSegment + i; });
}

/// The middle of an edge, on the cubic curve through its ends and its thirds.
template <typename Id>
void AdaptiveSurfaceValues<Id>::FindMiddleOfThirds(
  Id begin, Id end, const double* thirds, double* middle) const
{
  const double* a = this->GetLimit(begin);
  const double* b = this->GetLimit(end);
  for (int c = 0; c < this->Components; ++c)
  {
    middle[c] = (9. * (thirds[c] + thirds[this->Components + c]) - a[c] - b[c]) / 16.;
  }
}

/// Adds the position of a vertex on a given level, times `weight`.
template <typename Id>
void AdaptiveSurfaceValues<Id>::AddPosition(Id vertex, int level, double weight, double* sum) const
{
  const double part = this->Rows.GetPart(vertex, level);
  const double* values = this->Nodes.data() + 2 * static_cast<vtkIdType>(vertex) * this->Components;
  this->Add(values, weight * part, sum);
  this->Add(values + this->Components, weight * (1. - part), sum);
}

/// The result of AppendLimitOnEdge, computed much faster, where all six faces around the edge are
/// there and none is at a curve. Returns false elsewhere.
template <typename Id>
bool AdaptiveSurfaceValues<Id>::FindRegularThirds(Id corner, double* thirds) const
{
  const Id twin = this->Mesh.GetTwin(corner);
  const Id ends[2] = { this->Mesh.GetVertex(corner),
    this->Mesh.GetVertex(this->Mesh.Next(corner)) };
  const bool turns = this->Mesh.GetVertex(twin) == ends[0];
  const Id before = this->Mesh.Previous(twin);
  const Id after = this->Mesh.Next(twin);
  const Id around[2][2] = { { this->Mesh.Previous(corner), turns ? before : after },
    { this->Mesh.Next(corner), turns ? after : before } };
  const int level = this->Mesh.GetLevel(corner / 3) + 1;
  std::fill(thirds, thirds + 2 * this->Components, 0.);
  for (int end = 0; end < 2; ++end)
  {
    double* third = thirds + end * this->Components;
    for (const Id edge : around[end])
    {
      const Id across = this->Mesh.GetTwin(edge);
      if (across < 0 || this->Mesh.IsCut(across / 3))
      {
        return false;
      }
      this->Add(this->GetFirstCentre(across / 3), 1. / 36., third);
    }
    for (const Id face : { corner / 3, twin / 3 })
    {
      this->Add(this->GetFirstCentre(face), 1. / 4., third);
      this->Add(this->GetCentre(face), 1. / 18., third);
    }
    this->AddPosition(ends[end], level, 2. / 9., third);
    this->AddPosition(ends[end], level + 1, 1. / 12., third);
    this->AddPosition(ends[1 - end], level, 1. / 36., third);
  }
  return true;
}

template <typename Id>
int AdaptiveSurfaceValues<Id>::FindPlacesOfSegment(Id segment, double* places) const
{
  const Id* ends = this->Mesh.GetSegmentAt(segment).Ends;
  std::copy_n(this->GetThird(segment, false), 2 * this->Components, places + this->Components);
  this->FindMiddleOfThirds(ends[0], ends[1], places + this->Components, places);
  return 3;
}

template <typename Id>
int AdaptiveSurfaceValues<Id>::FindPlaces(Id corner, RowBlock<Id>& rows, double* places) const
{
  const Id twin = this->Mesh.GetTwin(corner);
  if (this->Mesh.IsFixed(corner))
  {
    return this->FindPlacesOfSegment(this->Mesh.GetSegment(corner), places);
  }
  if (twin < 0 || this->Mesh.IsCut(corner / 3) || this->Mesh.IsCut(twin / 3))
  {
    return this->FindMiddle(corner, places) ? 1 : 0;
  }
  if (!this->FindRegularThirds(corner, places + this->Components))
  {
    rows.Clear();
    this->Rows.AppendLimitOnEdge(corner, false, rows);
    this->Rows.AppendLimitOnEdge(corner, true, rows);
    rows.Apply(this->Nodes.data(), places + this->Components, this->Components);
  }
  this->FindMiddleOfThirds(this->Mesh.GetVertex(corner),
    this->Mesh.GetVertex(this->Mesh.Next(corner)), places + this->Components, places);
  return 3;
}

/// The limit in the middle of an edge; false where its other face is not there.
template <typename Id>
bool AdaptiveSurfaceValues<Id>::FindMiddle(Id corner, double* middle) const
{
  const Id twin = this->Mesh.GetTwin(corner);
  if (twin < 0)
  {
    return false;
  }
  auto getThird = [&](Id at)
  {
    bool isSecond = false;
    const Id segment = this->Mesh.GetThirdAcross(at, isSecond);
    return this->GetThird(segment, isSecond);
  };
  std::fill(middle, middle + this->Components, 0.);
  const Id corners[2] = { corner, twin };
  const bool isCut[2] = { this->Mesh.IsCut(corner / 3), this->Mesh.IsCut(twin / 3) };
  for (int i = 0; i < 2; ++i)
  {
    if (isCut[i])
    {
      // A face that is cut has no centre, and nothing lies beyond its curve: the point on the curve
      // is used.
      this->Add(getThird(corners[i]), isCut[1 - i] ? 1. / 2. : 3. / 8., middle);
      continue;
    }
    this->Add(this->GetCentre(corners[i] / 3), isCut[1 - i] ? 3. / 4. : 9. / 16., middle);
    this->Add(this->GetLimit(this->Mesh.GetVertex(this->Mesh.Previous(corners[i]))),
      isCut[1 - i] ? -1. / 8. : -1. / 16., middle);
  }
  return true;
}

SUBDIVISION_COMPILE(class AdaptiveSurfaceValues);

}
