// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/TetOctLattice.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Limits/LatticeLimit.h"
#include "Core/Solids/TetOct/TetOctMasks.h"

#include <algorithm>
#include <cstdlib>

namespace subdivision
{
namespace
{

using Point = std::array<long long, 3>;

Point Add(Point a, const Point& b, long long factor = 1)
{
  for (int k = 0; k < 3; ++k)
  {
    a[k] += factor * b[k];
  }
  return a;
}
Point Move(Point at, int axis, long long by)
{
  at[axis] += by;
  return at;
}
Point Halve(Point at)
{
  for (long long& x : at)
  {
    x /= 2;
  }
  return at;
}
long long Sum(const Point& at)
{
  return at[0] + at[1] + at[2];
}

template <typename Id>
void AddOnce(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row)
{
  const auto end = row.Vertices.end();
  std::find(row.Vertices.begin(), end, vertex) == end ? row.Add(vertex, 0.) : void();
}

/// Corner 0 of a tetrahedron is the origin, and the others are (1, 1, 0), (1, 0, 1) and (0, 1, 1).
Point ToPoint(const LatticeWeights& weights)
{
  return { { weights[1] + weights[2], weights[1] + weights[3], weights[2] + weights[3] } };
}
LatticeWeights ToWeights(const Point& at, long long size)
{
  const long long half = Sum(at) / 2;
  return { { size - half, half - at[2], half - at[1], half - at[0] } };
}

}

template <typename Id>
Rows<Id> ListSolidsAtVertices(const TetOctLevel<Id>& level)
{
  const vtkIdType ofTets = level.Complex.TetVertices.size();
  return ListByRow<Id>(
    level.Complex.NumberOfVertices, ofTets + level.OctVertices.size(), [&](vtkIdType i)
    { return i < ofTets ? level.Complex.TetVertices[i] : level.OctVertices[i - ofTets]; },
    [&](vtkIdType i)
    {
      return static_cast<Id>(i < ofTets ? i / 4 : level.Complex.NumberOfTets + (i - ofTets) / 6);
    });
}

template <typename Id>
const Id* TetOctLattice<Id>::GetCorners(Id solid, int& size) const
{
  size = this->IsOct(solid) ? 6 : 4;
  const Id tets = this->Here.Complex.NumberOfTets;
  return this->IsOct(solid) ? this->Here.OctVertices.data() + 6 * vtkIdType(solid - tets)
                            : this->Here.Complex.TetVertices.data() + 4 * vtkIdType(solid);
}

/// Where a vertex is in one of the solids at it.
template <typename Id>
std::array<long long, 3> TetOctLattice<Id>::Place(const LatticeVertex<Id>& vertex, Id solid) const
{
  const LatticeWeights& weights = vertex.Weights;
  if (vertex.Dimension == 3)
  {
    return this->IsOct(solid) ? Point{ { weights[0], weights[1], weights[2] } } : ToPoint(weights);
  }
  int size = 0;
  const Id* corners = this->GetCorners(solid, size);
  const bool isCorner = vertex.Dimension == 0;
  const Id* own =
    isCorner ? &vertex.Simplex : this->Curved.GetCorners(vertex.Dimension, vertex.Simplex);
  LatticeWeights inSolid{};
  for (int k = 0; k <= vertex.Dimension; ++k)
  {
    const auto number = static_cast<int>(std::find(corners, corners + size, own[k]) - corners);
    size == 4 ? inSolid[number] = weights[k]
              : inSolid[number / 2] = number % 2 != 0 ? weights[k] : -weights[k];
  }
  return size == 4 ? ToPoint(inSolid) : Point{ { inSolid[0], inSolid[1], inSolid[2] } };
}

template <typename Id>
LatticeVertex<Id> TetOctLattice<Id>::Find(Id solid, const LatticeWeights& weights) const
{
  if (!this->IsOct(solid))
  {
    return this->Curved.Find(3, solid, weights);
  }
  int outer[3] = {}; // the vertices between which it lies on the octahedron
  LatticeWeights ofOuter{};
  int size = 0;
  long long left = weights[3];
  for (int k = 0; k < 3; ++k)
  {
    outer[size] = 2 * k + (weights[k] > 0 ? 1 : 0);
    ofOuter[size] = std::abs(weights[k]);
    left -= ofOuter[size];
    size += weights[k] != 0 ? 1 : 0;
  }
  if (left > 0)
  {
    return { 3, solid, weights };
  }
  const vtkIdType oct = solid - this->Here.Complex.NumberOfTets;
  const Id* corners = this->Here.OctVertices.data() + 6 * oct;
  LatticeVertex<Id> vertex;
  vertex.Dimension = size - 1;
  vertex.Simplex = size == 1 ? corners[outer[0]]
    : size == 2 ? this->Here.OctEdges[12 * oct + octahedron::EdgeOf[outer[0]][outer[1]]]
                : this->Here.OctFaces[8 * oct + octahedron::FaceOf(outer[0], outer[1], outer[2])];
  const Id* own = size == 1 ? &vertex.Simplex : this->Curved.GetCorners(size - 1, vertex.Simplex);
  for (int k = 0; k < size; ++k)
  {
    const auto place = std::find(own, own + size, corners[outer[k]]) - own;
    vertex.Weights[place] = ofOuter[k];
  }
  return vertex;
}

template <typename Id>
LatticeVertex<Id> TetOctLattice<Id>::FindAt(const Frame& frame, const Point& at) const
{
  return this->Find(frame.Solid,
    this->IsOct(frame.Solid) ? LatticeWeights{ { at[0], at[1], at[2], frame.Size } }
                             : ToWeights(at, frame.Size));
}

template <typename Id>
bool TetOctLattice<Id>::IsInside(const Frame& frame, const Point& at) const
{
  if (this->IsOct(frame.Solid))
  {
    return std::abs(at[0]) + std::abs(at[1]) + std::abs(at[2]) <= frame.Size;
  }
  const LatticeWeights weights = ToWeights(at, frame.Size);
  return *std::min_element(weights.begin(), weights.end()) >= 0;
}

/// Calls act(solid) for each control solid at a vertex.
template <typename Id>
template <typename Act>
void TetOctLattice<Id>::ForSolids(const LatticeVertex<Id>& vertex, const Act& act) const
{
  const Id simplex = vertex.Simplex;
  if (vertex.Dimension == 3)
  {
    act(simplex);
    return;
  }
  if (vertex.Dimension == 2)
  {
    const Row<Id> solids = this->Here.Complex.FaceTets[simplex];
    std::for_each(solids.begin(), solids.end(), act);
    return;
  }
  const Id* ends = vertex.Dimension == 1 ? this->Curved.GetCorners(1, simplex) : nullptr;
  for (const Id solid : this->SolidsAt[ends ? ends[0] : simplex])
  {
    int size = 0;
    const Id* corners = this->GetCorners(solid, size);
    if (!ends || std::find(corners, corners + size, ends[1]) != corners + size)
    {
      act(solid);
    }
  }
}

/// Calls act(cell) for each tetrahedron and octahedron at a vertex inside a control solid.
template <typename Id>
template <typename Act>
void TetOctLattice<Id>::ForCells(const Frame& frame, const Point& at, const Act& act) const
{
  const auto actInside = [&](const Cell& cell)
  {
    const auto first = cell.Vertices.begin();
    if (std::all_of(
          first, first + cell.Size, [&](const Point& p) { return this->IsInside(frame, p); }))
    {
      act(cell);
    }
  };
  for (int signs = 0; signs < 8; ++signs)
  {
    const long long x = signs & 1 ? 1 : -1;
    const long long y = signs & 2 ? 1 : -1;
    const long long z = signs & 4 ? 1 : -1;
    actInside(
      { { { at, Add(at, { { x, y, 0 } }), Add(at, { { x, 0, z } }), Add(at, { { 0, y, z } }) } },
        4 });
  }
  for (int k = 0; k < 3; ++k)
  {
    for (const long long way : { -1, 1 })
    {
      const Point centre = Move(at, k, way);
      const int i = (k + 1) % 3;
      const int j = (k + 2) % 3;
      actInside({ { { at, Move(at, k, 2 * way), Move(centre, i, -1), Move(centre, i, 1),
                    Move(centre, j, -1), Move(centre, j, 1) } },
        6 });
    }
  }
}

/// Adds the shares of the cells inside a control solid in the row of a vertex, and returns how many
/// fine cells they have at it.
template <typename Id>
int TetOctLattice<Id>::AddVertexShares(
  const Frame& frame, const Point& at, LatticeRow<Id>& row) const
{
  int cells = 0;
  this->ForCells(frame, at,
    [&](const Cell& cell)
    {
      ++cells;
      const auto add = [&](int number, double share)
      { row.Add(this->FindAt(frame, cell.Vertices[number]), share); };
      add(0, cell.IsOct() ? tetoct::OctVertexOwn : tetoct::TetVertexOwn);
      for (int i = 1; i < cell.Size; ++i)
      {
        add(i,
          !cell.IsOct() ? tetoct::TetVertexOther
            : i == 1    ? tetoct::OctVertexFar
                        : tetoct::OctVertexNear);
      }
    });
  return cells;
}

/// The same for the edge between two vertices.
template <typename Id>
int TetOctLattice<Id>::AddEdgeShares(
  const Frame& frame, const Point& first, const Point& second, LatticeRow<Id>& row) const
{
  int cells = 0;
  this->ForCells(frame, first,
    [&](const Cell& cell)
    {
      const auto begin = cell.Vertices.begin();
      const auto other = static_cast<int>(std::find(begin, begin + cell.Size, second) - begin);
      if (other == cell.Size)
      {
        return;
      }
      cells += cell.IsOct() ? 4 : 3;
      for (int i = 0; i < cell.Size; ++i)
      {
        const bool isEnd = i == 0 || i == other;
        const bool isFar = i == 1 || i == (other ^ 1);
        const double share = !cell.IsOct() ? (isEnd ? tetoct::TetEdgeEnd : tetoct::TetEdgeOther)
          : isEnd                          ? tetoct::OctEdgeEnd
          : isFar                          ? tetoct::OctEdgeFar
                                           : tetoct::OctEdgeNear;
        row.Add(this->FindAt(frame, cell.Vertices[i]), share);
      }
    });
  return cells;
}

/// The row of a vertex that is regular and has all of its cells in one control solid: without the
/// search for them, which takes most of the time elsewhere.
template <typename Id>
void TetOctLattice<Id>::AddRegularVertex(
  const Frame& frame, const Point& at, LatticeRow<Id>& row) const
{
  const auto add = [&](const Point& p, double weight) { row.Add(this->FindAt(frame, p), weight); };
  add(at, RegularVertexMask.Own);
  for (int k = 0; k < 3; ++k)
  {
    for (const long long way : { -1, 1 })
    {
      add(Move(at, k, 2 * way), RegularVertexMask.Weights[1]);
      add(Move(Move(at, k, way), (k + 1) % 3, 1), RegularVertexMask.Weights[0]);
      add(Move(Move(at, k, way), (k + 1) % 3, -1), RegularVertexMask.Weights[0]);
    }
  }
}
/// The same for the edge between two vertices; the third axis has the same coordinate at both.
template <typename Id>
void TetOctLattice<Id>::AddRegularEdge(
  const Frame& frame, const Point& first, const Point& second, int third, LatticeRow<Id>& row) const
{
  const auto add = [&](const Point& p, double weight) { row.Add(this->FindAt(frame, p), weight); };
  add(first, RegularEdgeMask.Own);
  add(second, RegularEdgeMask.Own);
  for (int k = 0; k < 3; ++k)
  {
    if (k != third)
    {
      const long long way = second[k] - first[k];
      add(Move(Move(first, k, way), third, 1), RegularEdgeMask.Weights[0]);
      add(Move(Move(first, k, way), third, -1), RegularEdgeMask.Weights[0]);
      add(Move(first, k, 2 * way), RegularEdgeMask.Weights[1]);
      add(Move(second, k, -2 * way), RegularEdgeMask.Weights[1]);
    }
  }
}

/// The ends of the edge, on the level before, in the middle of which a vertex is.
template <typename Id>
std::array<Point, 2> TetOctLattice<Id>::FindEnds(const Frame& frame, const Point& at) const
{
  Point way{};
  int last = 0; // of two axes
  for (int k = 0; k < 3; ++k)
  {
    way[k] = at[k] % 2 != 0 ? 1 : 0;
    last = way[k] != 0 ? k : last;
  }
  way[last] = this->IsVertex(frame, Halve(Add(at, way))) ? 1 : -1;
  return { { Halve(Add(at, way, -1)), Halve(Add(at, way)) } };
}

/// Adds the shares of a control solid in the row of a vertex over the level before, and returns the
/// number by which its row is divided.
template <typename Id>
int TetOctLattice<Id>::AddShares(
  const LatticeVertex<Id>& vertex, Id solid, LatticeRow<Id>& row) const
{
  const Frame frame{ solid, this->GetSize(vertex) / 2 };
  const Point at = this->Place(vertex, solid);
  const auto isOdd = [](long long x) { return x % 2 != 0; };
  if (std::any_of(at.begin(), at.end(), isOdd)) // the midpoint of an edge
  {
    const std::array<Point, 2> ends = this->FindEnds(frame, at);
    if (vertex.Dimension < 3)
    {
      return this->AddEdgeShares(frame, ends[0], ends[1], row);
    }
    const auto third = static_cast<int>(std::find_if_not(at.begin(), at.end(), isOdd) - at.begin());
    this->AddRegularEdge(frame, ends[0], ends[1], third, row);
    return 1;
  }
  const Point half = Halve(at);
  if (this->IsVertex(frame, half))
  {
    if (vertex.Dimension < 3)
    {
      return this->AddVertexShares(frame, half, row);
    }
    this->AddRegularVertex(frame, half, row);
    return 1;
  }
  for (int k = 0; k < 3; ++k) // the centre of an octahedron
  {
    row.Add(this->FindAt(frame, Move(half, k, -1)), 1. / 6.);
    row.Add(this->FindAt(frame, Move(half, k, 1)), 1. / 6.);
  }
  return 1;
}

template <typename Id>
bool TetOctLattice<Id>::ReadRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const
{
  const Rule rule = this->GetRule(vertex);
  if (rule == Rule::Blend)
  {
    return this->ReadBlend(vertex, row);
  }
  if (rule != Rule::Solid)
  {
    return this->Curved.ReadRow(vertex, row);
  }
  row.Clear();
  int cells = 0;
  this->ForSolids(vertex, [&](Id solid) { cells += this->AddShares(vertex, solid, row); });
  for (double& weight : row.Weights)
  {
    weight /= cells;
  }
  return true;
}

/// Adds all vertices in cells with a vertex; one that is there already is left out.
template <typename Id>
void TetOctLattice<Id>::AddStarInSolid(
  const LatticeVertex<Id>& vertex, Id solid, LatticeStar<Id>& star) const
{
  const Frame frame{ solid, this->GetSize(vertex) };
  const Point own = this->Place(vertex, solid);
  this->ForCells(frame, own,
    [&](const Cell& cell)
    {
      for (int i = 1; i < cell.Size; ++i)
      {
        const LatticeVertex<Id> member = this->FindAt(frame, cell.Vertices[i]);
        if (std::find(star.Items.begin(), star.Items.end(), member) == star.Items.end())
        {
          star.Add(member, this->FindAt({ solid, 2 * frame.Size }, Add(own, cell.Vertices[i])));
        }
      }
    });
}

/// With Blend the row of a vertex reads all vertices to which edges lead, but the control vertices
/// that its ring leaves out; that of an edge those to which edges lead from both ends.
template <typename Id>
bool TetOctLattice<Id>::ReadBlend(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const
{
  if (!this->Curved.ReadRow(vertex, row))
  {
    return false;
  }
  const LatticeWeights& weights = vertex.Weights;
  const bool isOld =
    std::all_of(weights.begin(), weights.end(), [](long long w) { return w % 2 == 0; });
  const std::size_t curved = row.Vertices.size();
  if (vertex.Dimension == 1 && isOld)
  {
    this->AddSpokes(row.Vertices.front(), row);
  }
  for (const Id solid : vertex.Dimension == 2 ? this->Here.Complex.FaceTets[vertex.Simplex]
                                              : Row<Id>{ nullptr, nullptr })
  {
    isOld ? this->AddNeighbours(row.Vertices.front(), solid, row)
          : this->AddNeighboursOfEdge(vertex, solid, row);
  }
  if (row.Vertices.size() > curved)
  {
    const std::size_t own = isOld ? 1 : 2;
    const auto ring = static_cast<vtkIdType>(row.Vertices.size() - own);
    const Mask mask =
      isOld ? VertexMask(Rule::Blend, ring, this->Strata.Weights) : EdgeMask(Rule::Blend, ring);
    std::fill(row.Weights.begin(), row.Weights.end(), mask.Ring);
    std::fill_n(row.Weights.begin(), own, mask.Own);
  }
  return true;
}

/// Adds the vertex ahead of one on a control edge in each octahedron at the faces of its ring.
template <typename Id>
void TetOctLattice<Id>::AddSpokes(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const
{
  const Id edge = vertex.Simplex;
  for (const Id face : this->Strata.EdgeRings.GetCarriers(edge))
  {
    for (const Id solid :
      face < 0 ? Row<Id>{ nullptr, nullptr } : this->Here.Complex.FaceTets[face])
    {
      const vtkIdType oct = solid - this->Here.Complex.NumberOfTets;
      const auto isFirst = [&]()
      {
        const int local = FindPlace<12>(this->Here.OctEdges.data() + 12 * oct, edge);
        return this->Here.OctFaces[8 * oct + octahedron::FirstFaceAt(local)] == face;
      };
      if (oct >= 0 && isFirst()) // two of its faces lie at the edge
      {
        Point at = this->Place(vertex, solid);
        for (long long& x : at)
        {
          x -= x > 0 ? 1 : x < 0 ? -1 : 0;
        }
        row.Add(this->FindAt({ solid, this->GetSize(vertex) }, at), 0.);
      }
    }
  }
}

/// Adds the neighbours in a solid at its face of a vertex there, but those on the face, which are
/// in the row.
template <typename Id>
void TetOctLattice<Id>::AddNeighbours(
  const LatticeVertex<Id>& vertex, Id solid, LatticeRow<Id>& row) const
{
  const Frame frame{ solid, this->GetSize(vertex) };
  this->ForCells(frame, this->Place(vertex, solid),
    [&](const Cell& cell)
    {
      for (int i = cell.IsOct() ? 2 : 1; i < cell.Size; ++i)
      {
        AddOnce(this->FindAt(frame, cell.Vertices[i]), row);
      }
    });
}

/// The same for the edge in the middle of which a vertex is made.
template <typename Id>
void TetOctLattice<Id>::AddNeighboursOfEdge(
  const LatticeVertex<Id>& vertex, Id solid, LatticeRow<Id>& row) const
{
  const Frame frame{ solid, this->GetSize(vertex) / 2 };
  const std::array<Point, 2> ends = this->FindEnds(frame, this->Place(vertex, solid));
  this->ForCells(frame, ends[0],
    [&](const Cell& cell)
    {
      const auto begin = cell.Vertices.begin();
      const auto other = static_cast<int>(std::find(begin, begin + cell.Size, ends[1]) - begin);
      for (int i = cell.IsOct() ? 2 : 1; other < cell.Size && i < cell.Size; ++i)
      {
        i != other && (!cell.IsOct() || i != (other ^ 1))
          ? AddOnce(this->FindAt(frame, cell.Vertices[i]), row)
          : void();
      }
    });
}

template <typename Id>
bool TetOctLattice<Id>::AddStar(const LatticeVertex<Id>& vertex, LatticeStar<Id>& star) const
{
  const Rule rule = this->GetRule(vertex);
  if (rule == Rule::Solid)
  {
    star.Add(vertex, vertex.Double());
  }
  else
  {
    const bool isKnown = this->Curved.AddStar(vertex, star);
    if (!isKnown || rule != Rule::Blend)
    {
      return isKnown && (vertex.Dimension > 0 || GrowStar(*this, this->Curved, star));
    }
  }
  this->ForSolids(vertex, [&](Id solid) { this->AddStarInSolid(vertex, solid, star); });
  return vertex.Dimension > 0 || GrowStar(*this, this->Curved, star);
}

template <typename Id>
bool TetOctLattice<Id>::ReadLimit(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row)
{
  const Rule rule = this->GetRule(vertex);
  if (vertex.Dimension > 0 && rule != Rule::Solid && rule != Rule::Blend)
  {
    return this->Curved.ReadLimit(vertex, row);
  }
  Neighbourhood key{ vertex.Dimension }; // all vertices inside solids have the same weights
  vertex.Dimension < 3 ? AppendId(vertex.Simplex, key) : void();
  const std::vector<double>* weights = this->Limits.Find(
    key, [&](std::vector<double>& solved) { return SolveLatticeLimit(*this, vertex, solved); });
  LatticeStar<Id> star;
  if (!weights || !this->AddStar(vertex, star))
  {
    return false;
  }
  row.Clear();
  for (std::size_t i = 0; i < weights->size(); ++i)
  {
    (*weights)[i] != 0. ? row.Add(star.Items[i], (*weights)[i]) : void();
  }
  return true;
}

template Rows<int> ListSolidsAtVertices(const TetOctLevel<int>&);
template Rows<long long> ListSolidsAtVertices(const TetOctLevel<long long>&);
SUBDIVISION_COMPILE(class TetOctLattice);

}
