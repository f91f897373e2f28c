// SPDX-License-Identifier: BSD-3-Clause
#include "AdaptiveSurfaceValues.h"

#include <algorithm>

namespace subdivision
{

/// The vertices' two values, which only need those of earlier levels; the array gets the limit.
template <typename Id>
void AdaptiveSurfaceValues<Id>::AddVertices(const std::vector<Id>& vertices)
{
  const vtkIdType size = this->Mesh.GetNumberOfVertices();
  const int components = this->Components;
  const vtkIdType given = this->Mesh.GetNumberOfControlVertices();
  double* limits = this->Array.Grow(size);
  if (!this->IsSmooth)
  {
    for (const Id v : vertices) // in the order in which they came into being
    {
      if (v >= given)
      {
        const Id source = this->Mesh.GetAdded(v).Source;
        const Id* parents =
          source >= 0 ? this->Mesh.GetVertices(source) : this->Mesh.GetSegmentAt(-1 - source).Ends;
        const Id parent = *std::min_element(parents, parents + (source >= 0 ? 3 : 2));
        std::copy_n(limits + static_cast<vtkIdType>(parent) * components, components,
          limits + static_cast<vtkIdType>(v) * components);
      }
    }
    return;
  }
  this->Nodes.resize(static_cast<std::size_t>(2 * size * components));
  const bool isFirst = !vertices.empty() && vertices[0] < given;
  std::vector<double> control(
    isFirst ? limits : nullptr, isFirst ? limits + given * components : nullptr);
  auto getLevel = [&](Id v) { return v < given ? -1 : int(this->Mesh.GetAdded(v).Level); };
  for (std::size_t begin = 0; begin < vertices.size();)
  {
    std::size_t end = begin;
    while (end < vertices.size() && getLevel(vertices[end]) == getLevel(vertices[begin]))
    {
      ++end;
    }
    double* nodes = this->Nodes.data();
    const double* from = getLevel(vertices[begin]) < 0 ? control.data() : nodes;
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
          ApplyRows(rows, from, out, components);
          std::copy_n(out + components, components, limits + v * components);
        }
      });
    begin = end;
  }
}

/// The limits of the points that new faces and segments would get.
template <typename Id>
void AdaptiveSurfaceValues<Id>::AddCentres(const std::vector<Id>& faces, vtkIdType firstSegment)
{
  const int components = this->Components;
  this->Centres.resize(static_cast<std::size_t>(this->Mesh.GetNumberOfFaces() * components));
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
          ApplyRows(rows, this->Nodes.data(), out + place(i) * components, components);
        }
      });
  };
  forRanges(
    static_cast<vtkIdType>(faces.size()),
    [&](vtkIdType i, RowBlock<Id>& rows)
    {
      if (!this->Mesh.IsCut(faces[i]))
      {
        this->Rows.AppendCentreLimit(faces[i], rows);
      }
    },
    this->Centres.data(), [&](vtkIdType i) { return static_cast<vtkIdType>(faces[i]); });
  forRanges(
    2 * (this->Mesh.GetNumberOfSegments() - firstSegment), [&](vtkIdType i, RowBlock<Id>& rows)
    { this->Rows.AppendThirdLimit(static_cast<Id>(firstSegment + i / 2), i % 2 == 1, rows); },
    this->Thirds.data(), [&](vtkIdType i) { return 2 * firstSegment + i; });
}

/// The limit in the middle of a segment.
template <typename Id>
void AdaptiveSurfaceValues<Id>::FindMiddleOfSegment(Id segment, double* middle) const
{
  const Id* ends = this->Mesh.GetSegmentAt(segment).Ends;
  const double* a = this->GetLimit(ends[0]);
  const double* b = this->GetLimit(ends[1]);
  const double* p = this->GetThird(segment, false);
  const double* q = this->GetThird(segment, true);
  for (int c = 0; c < this->Components; ++c)
  {
    middle[c] = (9. * (p[c] + q[c]) - a[c] - b[c]) / 16.;
  }
}

/// The limit in the middle of an edge; false where its other face is not there.
template <typename Id>
bool AdaptiveSurfaceValues<Id>::FindMiddle(Id corner, double* middle) const
{
  if (this->Mesh.IsFixed(corner))
  {
    this->FindMiddleOfSegment(this->Mesh.GetSegment(corner), middle);
    return true;
  }
  const Id twin = this->Mesh.GetTwin(corner);
  if (twin < 0)
  {
    return false;
  }
  auto add = [&](const double* value, double weight)
  {
    for (int c = 0; c < this->Components; ++c)
    {
      middle[c] += weight * value[c];
    }
  };
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
      // Nothing is known beyond a curve.
      add(getThird(corners[i]), isCut[1 - i] ? 1. / 2. : 3. / 8.);
      continue;
    }
    add(this->GetCentre(corners[i] / 3), isCut[1 - i] ? 3. / 4. : 9. / 16.);
    add(this->GetLimit(this->Mesh.GetVertex(this->Mesh.Previous(corners[i]))),
      isCut[1 - i] ? -1. / 8. : -1. / 16.);
  }
  return true;
}

template class AdaptiveSurfaceValues<int>;
template class AdaptiveSurfaceValues<long long>;

}
