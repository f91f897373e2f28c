// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LatticeRing.h"

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace subdivision
{
namespace
{

/// a + b - c - d
LatticeStep Combine(
  const LatticeStep& a, const LatticeStep& b, const LatticeStep& c, const LatticeStep& d)
{
  LatticeStep sum;
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    sum[i] = static_cast<signed char>(a[i] + b[i] - c[i] - d[i]);
  }
  return sum;
}

/// The two vertices between which a lattice point is.
using Ends = std::array<int, 2>;
template <int Vertices, int Edges>
Ends GetEnds(const int (&edges)[Edges][2], int point)
{
  const int edge = point - Vertices;
  return edge < 0 ? Ends{ { point, point } } : Ends{ { edges[edge][0], edges[edge][1] } };
}
Ends GetEndsInTet(int point)
{
  return GetEnds<4>(tetrahedron::EdgeVertices, point);
}
int GetPointInTet(int a, int b)
{
  return LatticePoint<MarkedTetShape>(a, b);
}

/// A simplex between points half way between corners. getEnds(i): the corners for point i.
template <typename GetEnds>
LatticeCorners PickCorners(const LatticeCorners& parent, int size, const GetEnds& getEnds)
{
  const Ends first = getEnds(0);
  LatticeCorners picked{};
  for (int i = 1; i < size; ++i)
  {
    const Ends ends = getEnds(i);
    picked[i] = Combine(parent[ends[0]], parent[ends[1]], parent[first[0]], parent[first[1]]);
  }
  return picked;
}
template <typename Points>
LatticeCorners PickInTet(const LatticeCorners& tet, int size, const Points& points)
{
  return PickCorners(tet, size, [&points](int i) { return GetEndsInTet(points[i]); });
}

int FindInChild(int child, int point)
{
  return FindPlace<4>(tetrahedron::Children[child], point);
}
/// The child of a tetrahedron at a child of the face that its vertices `places` form.
int FindChildAt(const std::array<int, 3>& places, int child)
{
  return child < 3 ? places[child]
                   : tetrahedron::MiddleChildren[6 - places[0] - places[1] - places[2]];
}
std::array<int, 3> GetPointsOfInnerFace(int face)
{
  const int* edges = tetrahedron::InteriorFaces[face].Edges;
  return { { 4 + edges[0], 4 + edges[1], 4 + edges[2] } };
}

/// The vertex with at least half of the weight; how many there are if none has it.
template <typename Weights>
int FindBeyond(const Weights& at, int size, long long half)
{
  return static_cast<int>(
    std::find_if(at.begin(), at.begin() + size, [half](long long w) { return w >= half; }) -
    at.begin());
}

/// The same point by weights of lattice points of a tetrahedron: those of one child, or of what
/// lies between children. Their sum is half as large.
std::array<long long, 10> WeighPoints(const LatticeCut::Weights& at, long long half)
{
  std::array<long long, 10> points{};
  const auto get = [&points](int a, int b) -> long long& { return points[GetPointInTet(a, b)]; };
  const int corner = FindBeyond(at, 4, half);
  for (int k = 0; corner < 4 && k < 4; ++k)
  {
    get(corner, k) = k == corner ? at[k] - half : at[k];
  }
  if (corner == 4) // on either side of the two planes along the diagonal
  {
    const long long to03 = half - at[1] - at[2];
    const long long to01 = half - at[2] - at[3];
    (to03 > 0 ? get(0, 3) : get(1, 2)) = std::abs(to03);
    (to01 > 0 ? get(0, 1) : get(2, 3)) = std::abs(to01);
    get(0, 2) = at[0] - get(0, 1) - get(0, 3);
    get(1, 3) = at[1] - get(0, 1) - get(1, 2);
  }
  return points;
}
template <typename Points>
bool HasAll(const std::array<long long, 10>& weights, const Points& points)
{
  const auto add = [&weights](long long sum, int point) { return sum + weights[point]; };
  return std::accumulate(std::begin(points), std::end(points), 0LL, add) ==
    std::accumulate(weights.begin(), weights.end(), 0LL);
}

/// The diagonal that ends on the edge in a child of a tetrahedron, behind a face; by lattice points
/// of the ends and the third vertex of the face.
void AddDiagonalInChild(LatticeRing& ring, int chart, const LatticeCorners& tet, int child,
  const std::array<int, 3>& points)
{
  ring.AddDiagonal(chart, PickInTet(tet, 4, tetrahedron::Children[child]),
    FindInChild(child, points[0]), FindInChild(child, points[1]), FindInChild(child, points[2]));
}

/// An inner face of a tetrahedron, by the same points.
void AddInnerFace(LatticeRing& ring, int chart, const LatticeCorners& tet, int face,
  const std::array<int, 3>& points)
{
  const LatticeCorners at = PickInTet(tet, 3, points);
  ring.AddFace(chart, at[0], at[1], at[2]);
  for (const int child : tetrahedron::InteriorFaces[face].Tets)
  {
    AddDiagonalInChild(ring, chart, tet, child, points);
  }
}

void AddAroundDiagonal(LatticeRing& ring, const LatticeCorners& tet)
{
  const int first = 4 + tetrahedron::MarkedEdges[0];
  const int second = 4 + tetrahedron::MarkedEdges[1];
  const LatticeCorners at = PickInTet(tet, 2, std::array<int, 2>{ { first, second } });
  ring.AddEnds(at[0], at[1]);
  for (int q = 0; q < 4; ++q)
  {
    AddInnerFace(ring, -1, tet, 4 + q, { { first, second, 4 + tetrahedron::EquatorEdges[q] } });
  }
  ring.IsRegular = true;
}

int Pack(const LatticeCorners& corners, int size)
{
  int packed = 0;
  for (int i = 1; i < size; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      packed = 4 * packed + 1 + corners[i][k] - corners[0][k];
    }
  }
  return packed;
}

}

void LatticeRing::AddEnds(const LatticeStep& first, const LatticeStep& second)
{
  this->Vertex.push_back({ -1, Combine(first, {}, second, {}) });
  this->Vertex.push_back({ -1, Combine(second, {}, first, {}) });
}

void LatticeRing::AddFace(
  int chart, const LatticeStep& first, const LatticeStep& second, const LatticeStep& third)
{
  this->Edge.push_back({ chart, Combine(third, third, first, second) });
  this->Vertex.push_back({ chart, Combine(third, {}, second, {}) });
  this->Vertex.push_back({ chart, Combine(third, {}, first, {}) });
}

void LatticeRing::AddDiagonal(
  int chart, const LatticeCorners& tet, int first, int second, int third)
{
  const int edge = tetrahedron::EdgeOf[first][second];
  const int* opposite = tetrahedron::EdgeVertices[tetrahedron::OppositeEdge(edge)];
  if (tetrahedron::IsMarked(edge) && opposite[0] == 6 - first - second - third)
  {
    this->Vertex.push_back(
      { chart, Combine(tet[opposite[0]], tet[opposite[1]], tet[first], tet[second]) });
  }
}

void LatticeCut::FindInFace(const Weights& at, const std::vector<LatticeRing::Chart>& charts)
{
  this->At = at;
  this->Corners = LatticeUnits;
  this->Sides.clear();
  for (const LatticeRing::Chart& chart : charts)
  {
    this->Sides.push_back({ static_cast<int>(this->Sides.size()), LatticeUnits,
      { { chart.Places[0], chart.Places[1], chart.Places[2] } } });
  }
  this->GoDown();
}

void LatticeCut::FindInTet(Weights at)
{
  this->Corner = -1;
  this->Corners = LatticeUnits;
  this->Sides.clear();
  for (;;)
  {
    const auto points = WeighPoints(at, (at[0] + at[1] + at[2] + at[3]) / 2);
    const auto size =
      std::count_if(points.begin(), points.end(), [](long long weight) { return weight > 0; });
    int place = 0;
    while (size == 3 && !HasAll(points, GetPointsOfInnerFace(place)))
    {
      ++place;
    }
    if (size < 4)
    {
      return size == 3 ? this->StartOnInnerFace(place, points) : void();
    }
    while (!HasAll(points, tetrahedron::Children[place]))
    {
      ++place;
    }
    for (int i = 0; i < 4; ++i)
    {
      at[i] = points[tetrahedron::Children[place][i]];
    }
    this->Corners = PickInTet(this->Corners, 4, tetrahedron::Children[place]);
  }
}

/// Goes on from a tetrahedron to one of the faces inside it.
void LatticeCut::StartOnInnerFace(int face, const std::array<long long, 10>& points)
{
  const LatticeCorners tet = this->Corners;
  const auto corners = GetPointsOfInnerFace(face);
  this->Corners = PickInTet(tet, 3, corners);
  for (const int child : tetrahedron::InteriorFaces[face].Tets)
  {
    this->Sides.push_back({ -1, PickInTet(tet, 4, tetrahedron::Children[child]), {} });
    for (int i = 0; i < 3; ++i)
    {
      this->At[i] = points[corners[i]];
      this->Sides.back().Places[i] = FindInChild(child, corners[i]);
    }
  }
  this->GoDown();
}

/// Goes on to the child of the face that has the edge, until the edge is between children.
void LatticeCut::GoDown()
{
  for (;;)
  {
    const long long half = (this->At[0] + this->At[1] + this->At[2]) / 2;
    const int child = FindBeyond(this->At, 3, half); // 3 is the middle one
    if (child < 3 && this->At[child] == half)
    {
      this->Corner = child;
      return;
    }
    std::array<Ends, 3> points;
    Weights at{};
    for (int i = 0; i < 3; ++i)
    {
      points[i] = GetEnds<3>(triangle::EdgeVertices, triangle::Children[child][i]);
      const auto [a, b] = points[i];
      at[i] = child == 3 ? half - this->At[3 - a - b]
        : a == b         ? this->At[child] - half
                         : this->At[a + b - child];
    }
    this->At = at;
    this->Corners = PickCorners(this->Corners, 3, [&points](int i) { return points[i]; });
    for (Side& side : this->Sides)
    {
      const int childOfTet = FindChildAt(side.Places, child);
      const std::array<int, 3> old = side.Places;
      for (int i = 0; i < 3; ++i)
      {
        side.Places[i] =
          FindInChild(childOfTet, GetPointInTet(old[points[i][0]], old[points[i][1]]));
      }
      side.Corners = PickInTet(side.Corners, 4, tetrahedron::Children[childOfTet]);
    }
  }
}

void LatticeCut::AppendKey(Neighbourhood& key) const
{
  key.push_back(4 * Pack(this->Corners, this->Corner < 0 ? 4 : 3) + std::max(this->Corner, 0));
  for (const Side& side : this->Sides) // no two edges of it are parallel, which tells Places
  {
    key.push_back(Pack(side.Corners, 4));
  }
}

void LatticeCut::AddTo(LatticeRing& ring) const
{
  if (this->Corner < 0)
  {
    AddAroundDiagonal(ring, this->Corners);
    return;
  }
  const int own = this->Corner;
  const int others[2] = { own == 0 ? 1 : 0, own == 2 ? 1 : 2 };
  ring.IsRegular = !this->Sides.empty();
  for (const bool isMiddle : { false, true })
  {
    const Ends ends[3] = { { { own, others[0] } }, { { own, others[1] } },
      isMiddle ? Ends{ { others[0], others[1] } } : Ends{ { own, own } } };
    const LatticeCorners at = PickCorners(this->Corners, 3, [&ends](int i) { return ends[i]; });
    isMiddle ? void() : ring.AddEnds(at[0], at[1]);
    ring.AddFace(-1, at[0], at[1], at[2]);
    for (const Side& side : this->Sides)
    {
      std::array<int, 3> points;
      for (int i = 0; i < 3; ++i)
      {
        points[i] = GetPointInTet(side.Places[ends[i][0]], side.Places[ends[i][1]]);
      }
      AddDiagonalInChild(
        ring, side.Chart, side.Corners, FindChildAt(side.Places, isMiddle ? 3 : own), points);
    }
  }
  for (const Side& side : this->Sides)
  {
    const int corner = side.Places[own];
    const int first = side.Places[others[0]];
    const int second = side.Places[others[1]];
    const int ends[2] = { GetPointInTet(corner, first), GetPointInTet(corner, second) };
    const tetrahedron::FaceCutLink& link =
      tetrahedron::FaceCutLinks[corner][6 - corner - first - second];
    AddInnerFace(
      ring, side.Chart, side.Corners, corner, { { ends[0], ends[1], 4 + link.CutEdge } });
    if (link.HasDiagonal)
    {
      AddInnerFace(ring, side.Chart, side.Corners, link.DiagonalFace,
        { { ends[0], ends[1], 4 + link.DiagonalEdge } });
    }
    ring.IsRegular &= tetrahedron::IsMarked(tetrahedron::EdgeOf[first][second]);
  }
}

}
