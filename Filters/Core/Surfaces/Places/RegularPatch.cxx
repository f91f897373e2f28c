// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Places/RegularPatch.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// Tells whether the corners of a face have the rules of a uniform spline.
template <typename Id>
class RegularRules
{
public:
  RegularRules(const SurfaceLevel<Id>& level, int sides)
    : Mesh(level.Mesh)
    , Tags(level.Tags)
    , Sides(sides)
  {
  }

  bool IsRegularFace(Id face)
  {
    if (this->Mesh.GetSize(face) != this->Sides)
    {
      return false;
    }
    const Id first = this->Mesh.GetFirst(face);
    for (Id corner = first; corner < first + this->Sides; ++corner)
    {
      if (!this->IsRegularCorner(corner))
      {
        return false;
      }
    }
    return true;
  }

private:
  bool IsSmooth(Id halfEdge) const
  {
    return this->Tags.Edges[this->Mesh.Edges[halfEdge]] == EdgeTag::Smooth;
  }
  bool IsOnCurve(Id edge) const
  {
    return std::find(this->Curve.begin(), this->Curve.end(), edge) != this->Curve.end();
  }

  bool IsRegularCorner(Id corner)
  {
    const Id vertex = this->Mesh.Vertices[corner];
    const bool isQuad = this->Sides == 4;
    if (this->Tags.Vertices[vertex] == VertexTag::Smooth)
    {
      return this->IsRegularFan({ corner, true }, isQuad ? 4 : 6, true);
    }
    const SectorEnds<Id> ends = FindSectorEnds(this->Mesh, this->Tags, corner);
    if (this->Tags.Vertices[vertex] == VertexTag::Corner)
    {
      const Id halfEdges[2] = { corner, this->Mesh.Previous(corner) };
      return ends.Size == 1 && this->IsRegularFan(ends.First, 1, false) &&
        std::all_of(halfEdges, halfEdges + 2,
          [this](Id halfEdge) { return IsSharp(this->Tags.Edges[this->Mesh.Edges[halfEdge]]); });
    }
    if (this->Tags.Vertices[vertex] != VertexTag::Curve || ends.Size != (isQuad ? 2 : 3))
    {
      return false;
    }
    CollectCurveEdges(this->Mesh, this->Tags, vertex, this->Curve);
    return this->Curve.size() == 2 &&
      this->IsOnCurve(this->Mesh.Edges[ends.First.GetHalfEdgeIn(this->Mesh)]) &&
      this->IsOnCurve(this->Mesh.Edges[ends.Last.GetHalfEdgeOut(this->Mesh)]) &&
      this->IsRegularFan(ends.First, ends.Size, false);
  }

  /// Whether so many faces follow one another, in which the rules of a uniform spline hold.
  bool IsRegularFan(FanStep<Id> step, int size, bool isClosed)
  {
    const Id begin = step.Corner;
    for (int i = 0; i < size; ++i)
    {
      const Id face = this->Mesh.GetFace(step.Corner);
      if (this->Mesh.GetSize(face) != this->Sides || this->HasOtherRules(face))
      {
        return false;
      }
      if (i + 1 == size && !isClosed)
      {
        return true;
      }
      const Id out = step.GetHalfEdgeOut(this->Mesh);
      if (!this->IsSmooth(out) || this->IsBentAtEnd(out, this->Mesh.Vertices[begin]) ||
        !step.Advance(this->Mesh) || (step.Corner == begin && i + 1 < size))
      {
        return false;
      }
    }
    return step.Corner == begin;
  }

  /// Whether new points of a face are moved to the plane of a corner.
  bool HasOtherRules(Id face) const
  {
    const Id* first = this->Mesh.Vertices.data() + this->Mesh.GetFirst(face);
    return !this->Tags.Sectors.empty() &&
      std::any_of(first, first + this->Sides,
        [this](Id vertex)
        {
          auto at = FindSectors(this->Tags, vertex);
          while (at != this->Tags.Sectors.end() && at->Vertex == vertex && !(at->Flatness > 0.))
          {
            ++at;
          }
          return at != this->Tags.Sectors.end() && at->Vertex == vertex;
        });
  }

  /// Whether the far end of an edge gives its point other weights than a uniform spline has.
  bool IsBentAtEnd(Id halfEdge, Id vertex) const
  {
    const Id other = this->Mesh.GetOtherEnd(this->Mesh.Edges[halfEdge], vertex);
    const double angle =
      FindAngleOfFace(this->Mesh, this->Tags, other, GetCornerAt(this->Mesh, halfEdge, other));
    const double regular = this->Sides == 4 ? Pi / 2. : Pi / 3.;
    return angle > 0. && std::abs(angle - regular) > 1e-14;
  }

  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const int Sides;
  std::vector<Id> Curve;
};

/// The vertices to which a walk comes, two at most.
template <typename Id>
struct WalkEnds
{
  bool empty() const { return this->Size == 0; }
  std::size_t size() const { return this->Size; }
  Id operator[](std::size_t i) const { return this->Ids[i]; }

  std::array<Id, 2> Ids{};
  std::size_t Size = 0;
};

/// Collects control points of a regular face.
template <typename Id>
class ControlPointReader
{
public:
  ControlPointReader(const SurfaceLevel<Id>& level, Id face)
    : Mesh(level.Mesh)
    , First(level.Mesh.GetFirst(face))
    , Sides(level.Mesh.GetSize(face))
  {
    for (Id k = 0; k < this->Sides; ++k)
    {
      this->Smooth[k] = level.Tags.Edges[this->Mesh.Edges[this->First + k]] == EdgeTag::Smooth;
    }
    this->Tags = &level.Tags;
  }

  void ReadQuad(std::vector<ControlPoint<Id>>& points) const
  {
    using Grid = std::array<std::array<ControlPoint<Id>, 4>, 4>;
    // Of each edge: its direction, and the row of the grid that lies beyond it.
    constexpr int own[4][2] = { { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 } };
    constexpr int beyond[4][2] = { { 0, -1 }, { 1, 0 }, { 0, 1 }, { -1, 0 } };
    Grid grid;
    for (int k = 0; k < 4; ++k)
    {
      const int* at = own[k];
      const int* end = own[(k + 1) % 4];
      grid[at[0]][at[1]] = this->GetCorner(k);
      if (!this->Smooth[k])
      {
        continue;
      }
      const WalkEnds<Id> left = this->Walk(k, false, 1);
      const WalkEnds<Id> right = this->Walk((k + 1) % 4, true, 1);
      grid[at[0] + beyond[k][0]][at[1] + beyond[k][1]] = ControlPoint<Id>::Of(left[0]);
      grid[end[0] + beyond[k][0]][end[1] + beyond[k][1]] = ControlPoint<Id>::Of(right[0]);
      const int before = (k + 3) % 4;
      if (this->Smooth[before])
      {
        grid[at[0] + beyond[k][0] + beyond[before][0]][at[1] + beyond[k][1] + beyond[before][1]] =
          ControlPoint<Id>::Of(this->GetOpposite(k));
      }
    }
    const auto mirror =
      [](ControlPoint<Id>& to, const ControlPoint<Id>& on, const ControlPoint<Id>& inside)
    {
      if (!on.empty() && !inside.empty())
      {
        to = ControlPoint<Id>().Add(on, 2.).Add(inside, -1.);
      }
    };
    for (int i = 0; i < 4; ++i)
    {
      if (!this->Smooth[3])
      {
        mirror(grid[0][i], grid[1][i], grid[2][i]);
      }
      if (!this->Smooth[1])
      {
        mirror(grid[3][i], grid[2][i], grid[1][i]);
      }
    }
    for (int i = 0; i < 4; ++i)
    {
      if (!this->Smooth[0])
      {
        mirror(grid[i][0], grid[i][1], grid[i][2]);
      }
      if (!this->Smooth[2])
      {
        mirror(grid[i][3], grid[i][2], grid[i][1]);
      }
    }
    for (int y = 0; y < 4; ++y)
    {
      for (int x = 0; x < 4; ++x)
      {
        points.push_back(grid[x][y]);
      }
    }
  }

  /// The corners; the points beyond edges k; then for each corner k the point next to that beyond
  /// edge k, and the one next to that beyond the edge before.
  void ReadTriangle(std::vector<ControlPoint<Id>>& points) const
  {
    std::array<ControlPoint<Id>, 3> own;
    std::array<ControlPoint<Id>, 3> beyond;
    for (int k = 0; k < 3; ++k)
    {
      own[k] = this->GetCorner(k);
    }
    for (int k = 0; k < 3; ++k)
    {
      beyond[k] = this->Smooth[k] ? ControlPoint<Id>::Of(this->Walk(k, false, 1)[0])
                                  : Mirror(own[k], own[(k + 1) % 3], own[(k + 2) % 3]);
    }
    points.assign(own.begin(), own.end());
    points.insert(points.end(), beyond.begin(), beyond.end());
    for (int k = 0; k < 3; ++k)
    {
      const ControlPoint<Id>& next = own[(k + 1) % 3];
      const ControlPoint<Id>& last = own[(k + 2) % 3];
      const ControlPoint<Id>& beyondNext = beyond[k];
      const ControlPoint<Id>& beyondLast = beyond[(k + 2) % 3];
      ControlPoint<Id> atNext;
      ControlPoint<Id> atLast;
      const WalkEnds<Id> forward = this->Walk(k, false, 2);
      const WalkEnds<Id> backward = this->Walk(k, true, 2);
      if (forward.size() > 1)
      {
        atNext.Add(forward[1], 1.);
      }
      if (backward.size() > 1)
      {
        atLast.Add(backward[1], 1.);
      }
      if (forward.empty() && backward.empty()) // a corner
      {
        atNext.Add(own[k], 2.).Add(last, -1.);
        atLast.Add(own[k], 2.).Add(next, -1.);
      }
      else if (forward.size() == 1 && backward.size() == 1) // the face is in the middle
      {
        atNext = Mirror(own[k], beyondNext, next);
        atLast = Mirror(own[k], beyondLast, last);
      }
      else if (forward.empty())
      {
        atNext = Mirror(own[k], atLast, beyondLast);
      }
      else if (backward.empty())
      {
        atLast = Mirror(own[k], atNext, beyondNext);
      }
      points.push_back(atNext);
      points.push_back(atLast);
    }
  }

private:
  ControlPoint<Id> GetCorner(int k) const
  {
    return ControlPoint<Id>::Of(this->Mesh.Vertices[this->First + k]);
  }
  /// The point beyond an edge on a curve.
  static ControlPoint<Id> Mirror(
    const ControlPoint<Id>& a, const ControlPoint<Id>& b, const ControlPoint<Id>& inside)
  {
    return ControlPoint<Id>().Add(a, 1.).Add(b, 1.).Add(inside, -1.);
  }

  /// The other ends of the edges to which a walk around corner k comes: across edge k, or, if
  /// `isBack`, the edge before. At most so many, fewer where a curve stops it.
  WalkEnds<Id> Walk(int k, bool isBack, std::size_t most) const
  {
    const Id corner = static_cast<Id>(this->First + k);
    const Id vertex = this->Mesh.Vertices[corner];
    WalkEnds<Id> ends;
    FanStep<Id> step{ corner, isBack };
    while (ends.Size < most &&
      this->Tags->Edges[this->Mesh.Edges[step.GetHalfEdgeOut(this->Mesh)]] == EdgeTag::Smooth)
    {
      step.Advance(this->Mesh);
      ends.Ids[ends.Size++] =
        this->Mesh.GetOtherEnd(this->Mesh.Edges[step.GetHalfEdgeOut(this->Mesh)], vertex);
    }
    return ends;
  }

  /// The vertex opposite to corner k in the quad that shares only this corner with the face.
  Id GetOpposite(int k) const
  {
    FanStep<Id> step{ static_cast<Id>(this->First + k), false };
    step.Advance(this->Mesh);
    step.Advance(this->Mesh);
    return this->Mesh.Vertices[this->Mesh.Next(this->Mesh.Next(step.Corner))];
  }

  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>* Tags;
  const Id First;
  const Id Sides;
  std::array<bool, 4> Smooth{}; ///< of each edge of the face
};

}

template <typename Id>
bool RegularPatch<Id>::FindFace(const SurfaceLevel<Id>& level, Id face)
{
  const int sides = static_cast<int>(level.Mesh.GetSize(face));
  if ((sides != 3 && sides != 4) || !RegularRules<Id>(level, sides).IsRegularFace(face))
  {
    return false;
  }
  const ControlPointReader<Id> reader(level, face);
  this->Domain = sides == 4 ? PolynomialDomain::Quad : PolynomialDomain::Triangle;
  this->Points.clear();
  sides == 4 ? reader.ReadQuad(this->Points) : reader.ReadTriangle(this->Points);
  return true;
}

template <typename Id>
bool RegularPatch<Id>::FindLine(const SurfaceLevel<Id>& level, Id edge)
{
  if (!IsSharp(level.Tags.Edges[edge]))
  {
    return false;
  }
  const Id* ends = level.Mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(edge);
  std::array<ControlPoint<Id>, 2> beyond;
  std::vector<Id> curve;
  for (int end = 0; end < 2; ++end)
  {
    const Id vertex = ends[end];
    if (level.Tags.Vertices[vertex] == VertexTag::Corner)
    {
      beyond[end].Add(vertex, 2.).Add(ends[1 - end], -1.);
      continue;
    }
    CollectCurveEdges(level.Mesh, level.Tags, vertex, curve);
    if (level.Tags.Vertices[vertex] != VertexTag::Curve || curve.size() != 2 ||
      std::find(curve.begin(), curve.end(), edge) == curve.end())
    {
      return false;
    }
    const Id other = curve[0] == edge ? curve[1] : curve[0];
    beyond[end].Add(level.Mesh.GetOtherEnd(other, vertex), 1.);
  }
  this->Domain = PolynomialDomain::Line;
  this->Points = { beyond[0], ControlPoint<Id>::Of(ends[0]), ControlPoint<Id>::Of(ends[1]),
    beyond[1] };
  return true;
}

template <typename Id>
bool RegularPatch<Id>::TakeColumns(SplineColumns<Id>& columns) const
{
  if (!std::all_of(this->Points.begin(), this->Points.end(),
        [](const ControlPoint<Id>& point) { return point.Size == 1; }))
  {
    return false;
  }
  std::array<Id, BicubicPoints> points;
  std::transform(this->Points.begin(), this->Points.end(), points.begin(),
    [](const ControlPoint<Id>& point) { return point.begin()->Vertex; });
  return columns.Set(points, static_cast<int>(this->Points.size()));
}

void WeightControlPoints(PolynomialDomain domain, const PlaceAt& at,
  const PatchDirections& directions, PlaceDerivatives derivatives, PatchParts& parts)
{
  switch (domain)
  {
    case PolynomialDomain::Line:
      WeightCubic(at[0], directions, parts);
      return;
    case PolynomialDomain::Triangle:
      WeightBoxSpline(at[0], at[1], directions, derivatives, parts);
      return;
    default:
      WeightBicubic(at[0], at[1], directions, derivatives, parts);
  }
}

PatchParts WeightCorners(int corners, const PlaceAt& at, const PatchDirections& directions)
{
  const auto [x, y] = at;
  const auto& [dx, dy] = directions;
  PatchParts parts{};
  // The function that is 1 at corner k, and its derivatives.
  const auto set = [&, &dx = dx, &dy = dy](
                     int k, double value, double byX, double byY, double byBoth)
  {
    parts[PlaceParts::Value][k] = value;
    for (int p = 0; p < 2; ++p)
    {
      parts[PlaceParts::First + p][k] = byX * dx[p] + byY * dy[p];
    }
    parts[PlaceParts::Second][k] = 2. * byBoth * dx[0] * dy[0];
    parts[PlaceParts::Mixed][k] = byBoth * (dx[0] * dy[1] + dx[1] * dy[0]);
    parts[PlaceParts::SecondOfSecond][k] = 2. * byBoth * dx[1] * dy[1];
  };
  switch (corners)
  {
    case 1:
      set(0, 1., 0., 0., 0.);
      break;
    case 2:
      set(0, 1. - x, -1., 0., 0.);
      set(1, x, 1., 0., 0.);
      break;
    case 3:
      set(0, 1. - x - y, -1., -1., 0.);
      set(1, x, 1., 0., 0.);
      set(2, y, 0., 1., 0.);
      break;
    default:
      set(0, (1. - x) * (1. - y), y - 1., x - 1., 1.);
      set(1, x * (1. - y), 1. - y, -x, -1.);
      set(2, x * y, y, x, 1.);
      set(3, (1. - x) * y, -y, 1. - x, -1.);
  }
  return parts;
}

SUBDIVISION_COMPILE(struct RegularPatch);

}
