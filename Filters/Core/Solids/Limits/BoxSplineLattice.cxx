// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/BoxSplineLattice.h"

#include "Core/Memory/Ids.h"
#include "Core/Rules/Masks.h"
#include "Core/Solids/Limits/LatticeLimit.h"

#include <algorithm>
#include <utility>

namespace subdivision
{
namespace
{

/// The marked edges of a tetrahedron are 02 and 13.
int GetPartner(int corner)
{
  return corner ^ 2;
}

LatticeWeights Move(LatticeWeights weights, int from, int to)
{
  --weights[from];
  ++weights[to];
  return weights;
}
LatticeWeights With(LatticeWeights weights, int corner)
{
  ++weights[corner];
  return weights;
}
/// Along the diagonal of a tetrahedron: from the ends of the marked edge without a corner to the
/// ends of the other one.
LatticeWeights MoveToPair(LatticeWeights weights, int corner)
{
  const int pair = corner % 2;
  for (int i = 0; i < 4; ++i)
  {
    weights[i] += i % 2 == pair ? 1 : -1;
  }
  return weights;
}
LatticeWeights Sum(LatticeWeights a, const LatticeWeights& b)
{
  std::transform(
    a.begin(), a.end(), b.begin(), a.begin(), [](long long x, long long y) { return x + y; });
  return a;
}
/// A vertex inside a face of which each edge is sharp lies on a curve along the edge in the middle
/// of which it was made: the corner of the face whose weight does not change along this.
int FindStillCorner(LatticeWeights weights)
{
  const auto isEven = [](long long w) { return w % 2 == 0; };
  while (std::all_of(weights.begin(), weights.end(), isEven))
  {
    std::for_each(weights.begin(), weights.end(), [](long long& w) { w /= 2; });
  }
  return static_cast<int>(std::find_if(weights.begin(), weights.end(), isEven) - weights.begin());
}

}

template <typename Id>
const Id* BoxSplineLattice<Id>::GetCorners(int dimension, Id simplex) const
{
  const Buffer<Id>& vertices = dimension == 3 ? this->Complex.TetVertices
    : dimension == 2                          ? this->Complex.FaceVertices
                                              : this->Complex.EdgeVertices;
  return vertices.data() + vtkIdType(dimension + 1) * simplex;
}

/// Weights for the corners of one simplex as weights for those of another one, which has all of
/// them whose weight is not 0.
template <typename Id>
LatticeWeights BoxSplineLattice<Id>::Lift(
  const Id* from, int corners, const LatticeWeights& weights, const Id* to, int cornersThere) const
{
  LatticeWeights lifted{};
  for (int k = 0; k < corners; ++k)
  {
    for (int i = 0; weights[k] != 0 && i < cornersThere; ++i)
    {
      lifted[i] += to[i] == from[k] ? weights[k] : 0;
    }
  }
  return lifted;
}

template <typename Id>
LatticeVertex<Id> BoxSplineLattice<Id>::Find(
  int dimension, Id simplex, const LatticeWeights& weights) const
{
  int inside[4] = {}; // the corners with a weight
  int outside = 0;
  int size = 0;
  for (int i = 0; i <= dimension; ++i)
  {
    outside = weights[i] == 0 ? i : outside;
    inside[size] = i;
    size += weights[i] != 0 ? 1 : 0;
  }
  if (size == dimension + 1)
  {
    return { dimension, simplex, weights };
  }
  const Id* corners = this->GetCorners(dimension, simplex);
  LatticeVertex<Id> vertex;
  vertex.Dimension = size - 1;
  if (size == 1)
  {
    vertex.Simplex = corners[inside[0]];
    vertex.Weights[0] = weights[inside[0]];
    return vertex;
  }
  const vtkIdType first = vtkIdType(simplex) * (dimension == 3 && size == 2 ? 6 : dimension + 1);
  vertex.Simplex = dimension == 2 ? this->Complex.FaceEdges[first + triangle::EdgeOpposite[outside]]
    : size == 3                   ? this->Complex.TetFaces[first + outside]
                : this->Complex.TetEdges[first + tetrahedron::EdgeOf[inside[0]][inside[1]]];
  vertex.Weights =
    this->Lift(corners, dimension + 1, weights, this->GetCorners(size - 1, vertex.Simplex), size);
  return vertex;
}

template <typename Id>
Rule BoxSplineLattice<Id>::GetRule(const LatticeVertex<Id>& vertex) const
{
  if (vertex.Dimension == 3)
  {
    return Rule::Solid;
  }
  const Buffer<Stratum>& strata = vertex.Dimension == 2 ? this->Strata.Faces
    : vertex.Dimension == 1                             ? this->Strata.Edges
                                                        : this->Strata.Vertices;
  const Rule rule = strata[vertex.Simplex].GetRule();
  return rule == Rule::RegularEdge ? Rule::Solid : rule;
}

/// Calls act(dimension, simplex, weights, weights of neighbour) for each neighbour in the ring of a
/// vertex: both lie in this simplex.
template <typename Id>
template <typename Act>
bool BoxSplineLattice<Id>::ForRing(const LatticeVertex<Id>& vertex, const Act& act) const
{
  switch (vertex.Dimension)
  {
    case 0:
      return this->ForRingOfVertex(vertex, act);
    case 1:
      return this->ForRingOnEdge(vertex, act);
    case 2:
      return this->ForRingInFace(vertex, act);
    default:
      return this->ForRingInTet(vertex, act);
  }
}

template <typename Id>
template <typename Act>
bool BoxSplineLattice<Id>::ForRingOfVertex(const LatticeVertex<Id>& vertex, const Act& act) const
{
  const Rule rule = this->GetRule(vertex);
  if (rule == Rule::Corner)
  {
    return true;
  }
  const Row<Id> edges = this->Strata.VertexRings.GetCarriers(vertex.Simplex);
  if (this->IsUnknown(rule) ||
    std::any_of(edges.begin(), edges.end(), [](Id edge) { return edge < 0; }))
  {
    return false;
  }
  for (const Id edge : edges)
  {
    const int own = this->GetCorners(1, edge)[0] == vertex.Simplex ? 0 : 1;
    LatticeWeights weights{};
    weights[own] = vertex.Weights[0];
    act(1, edge, weights, Move(weights, own, 1 - own));
  }
  return true;
}

template <typename Id>
template <typename Act>
bool BoxSplineLattice<Id>::ForRingOnEdge(const LatticeVertex<Id>& vertex, const Act& act) const
{
  const Id edge = vertex.Simplex;
  const Rule rule = this->GetRule(vertex);
  const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(edge);
  if (this->IsUnknown(rule) || (rule == Rule::Surface && faces.size() != 2))
  {
    return false;
  }
  act(1, edge, vertex.Weights, Move(vertex.Weights, 0, 1));
  act(1, edge, vertex.Weights, Move(vertex.Weights, 1, 0));
  const Id* ends = this->GetCorners(1, edge);
  const bool goesInside = this->HasSolids && (rule == Rule::Solid || rule == Rule::Blend);
  for (const Id face : rule == Rule::Curve ? Row<Id>{ nullptr, nullptr } : faces)
  {
    if (face < 0 && rule == Rule::Blend) // a member for the first step only
    {
      continue;
    }
    if (face < 0)
    {
      return false;
    }
    const LatticeWeights own = this->Lift(ends, 2, vertex.Weights, this->GetCorners(2, face), 3);
    const int third = triangle::VertexOpposite[this->Complex.EdgeInFace(face, edge)];
    for (int i = 0; i < 3; ++i)
    {
      i != third ? act(2, face, own, Move(own, i, third)) : void();
    }
    for (const Id tet : goesInside ? this->Complex.FaceTets[face] : Row<Id>{ nullptr, nullptr })
    {
      const int number = this->Complex.EdgeInTet(tet, edge);
      const int* others = tetrahedron::EdgeVertices[tetrahedron::OppositeEdge(number)];
      // Each tetrahedron once, though it has two faces at the edge.
      if (tetrahedron::IsMarked(number) && this->Complex.FaceInTet(tet, face) == others[0])
      {
        const LatticeWeights inTet =
          this->Lift(ends, 2, vertex.Weights, this->GetCorners(3, tet), 4);
        act(3, tet, inTet, MoveToPair(inTet, others[0]));
      }
    }
  }
  return true;
}

template <typename Id>
template <typename Act>
bool BoxSplineLattice<Id>::ForRingInFace(const LatticeVertex<Id>& vertex, const Act& act) const
{
  const Id face = vertex.Simplex;
  const Rule rule = this->GetRule(vertex);
  if (this->IsUnknown(rule))
  {
    return false;
  }
  const int still = rule == Rule::Curve ? FindStillCorner(vertex.Weights) : -1;
  for (int i = 0; i < 3; ++i)
  {
    for (const int k : { (i + 1) % 3, (i + 2) % 3 })
    {
      i != still&& k != still ? act(2, face, vertex.Weights, Move(vertex.Weights, i, k)) : void();
    }
  }
  const bool goesInside = this->HasSolids && rule != Rule::Surface && rule != Rule::Curve;
  for (const Id tet : goesInside ? this->Complex.FaceTets[face] : Row<Id>{ nullptr, nullptr })
  {
    const int apex = this->Complex.FaceInTet(tet, face);
    const LatticeWeights own =
      this->Lift(this->GetCorners(2, face), 3, vertex.Weights, this->GetCorners(3, tet), 4);
    for (int i = 0; i < 4; ++i)
    {
      i != apex ? act(3, tet, own, Move(own, i, apex)) : void();
    }
    act(3, tet, own, MoveToPair(own, apex));
  }
  return true;
}

template <typename Id>
template <typename Act>
bool BoxSplineLattice<Id>::ForRingInTet(const LatticeVertex<Id>& vertex, const Act& act) const
{
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      i != k ? act(3, vertex.Simplex, vertex.Weights, Move(vertex.Weights, i, k)) : void();
    }
  }
  act(3, vertex.Simplex, vertex.Weights, MoveToPair(vertex.Weights, 0));
  act(3, vertex.Simplex, vertex.Weights, MoveToPair(vertex.Weights, 1));
  return true;
}

template <typename Id>
bool BoxSplineLattice<Id>::ReadRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const
{
  row.Clear();
  const LatticeWeights& weights = vertex.Weights;
  return std::all_of(weights.begin(), weights.end(), [](long long w) { return w % 2 == 0; })
    ? this->ReadVertexRow(vertex, row)
    : this->ReadEdgeRow(vertex, row);
}

template <typename Id>
bool BoxSplineLattice<Id>::ReadVertexRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const
{
  LatticeVertex<Id> old = vertex;
  for (long long& weight : old.Weights)
  {
    weight /= 2;
  }
  row.Add(old, 0.);
  if (!this->ForRing(old,
        [&](int dimension, Id simplex, const LatticeWeights&, const LatticeWeights& weights)
        { row.Add(this->Find(dimension, simplex, weights), 0.); }))
  {
    return false;
  }
  const Mask mask = VertexMask(
    this->GetRule(old), static_cast<vtkIdType>(row.Vertices.size()) - 1, this->Strata.Weights);
  std::fill(row.Weights.begin(), row.Weights.end(), mask.Ring);
  row.Weights[0] = mask.Own;
  return true;
}

/// The ends of the edge are `base` with one more of each corner whose weight is odd; if all four
/// are odd, the edge is along a diagonal.
template <typename Id>
bool BoxSplineLattice<Id>::ReadEdgeRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const
{
  LatticeWeights base = vertex.Weights;
  int odd[4];
  int odds = 0;
  for (int i = 0; i < 4; ++i)
  {
    odd[odds] = i;
    odds += base[i] % 2 != 0 ? 1 : 0;
    base[i] /= 2;
  }
  for (int i = 0; i < 2; ++i)
  {
    const LatticeWeights end = With(base, odd[i]);
    row.Add(this->Find(vertex.Dimension, vertex.Simplex, odds == 4 ? With(end, i + 2) : end), 0.);
  }
  Rule rule = this->GetRule(vertex);
  if (vertex.Dimension == 1)
  {
    rule = this->Strata.Edges[vertex.Simplex].GetRule();
    if (!this->AddRingOfEdge(vertex, base, row))
    {
      return false;
    }
  }
  else if (vertex.Dimension == 2 && !this->AddRingInFace(vertex, base, row, rule))
  {
    return false;
  }
  else if (vertex.Dimension == 3)
  {
    this->AddRingInTet(vertex, base, row, rule);
  }
  const Mask mask = EdgeMask(rule, static_cast<vtkIdType>(row.Vertices.size()) - 2);
  std::fill(row.Weights.begin(), row.Weights.end(), mask.Ring);
  row.Weights[0] = row.Weights[1] = mask.Own;
  return vertex.Dimension != 1 || this->ApplySectors(vertex, base, row);
}

/// Gives an edge at the end of a control edge whose rule depends on the sector there its weights.
template <typename Id>
bool BoxSplineLattice<Id>::ApplySectors(
  const LatticeVertex<Id>& vertex, const LatticeWeights& base, LatticeRow<Id>& row) const
{
  std::array<SectorEdge<Id>, 2> taken;
  int size = 0;
  for (const SectorEdge<Id>& sector : FindSectorEdges(this->Strata.Sectors, vertex.Simplex))
  {
    if (base[1 - sector.End] == 0)
    {
      taken[size] = sector;
      taken[size++].IsShared = sector.IsShared && base[sector.End] == 0; // as a step leaves it
    }
  }
  const SectorEdgeRange<Id> sectors{ taken.data(), taken.data() + size };
  if (sectors.IsEmpty() || !AreComplete(sectors))
  {
    return sectors.IsEmpty();
  }
  const SectorMask mask = GetSectorMask(sectors);
  std::fill(row.Weights.begin(), row.Weights.end(), mask.Ring);
  std::copy_n(mask.Ends, 2, row.Weights.begin());
  for (const SectorEdge<Id>& sector : sectors)
  {
    const Id corner = this->GetCorners(1, vertex.Simplex)[sector.End];
    for (int i = 0; i < 2 && sector.Flatness > 0.; ++i)
    {
      const int own = this->GetCorners(1, sector.Bounds[i])[0] == corner ? 0 : 1;
      LatticeWeights weights{};
      weights[own] = base[sector.End];
      weights[1 - own] = 1;
      row.Add(this->Find(1, sector.Bounds[i], weights), mask.Bounds[sector.End][i]);
    }
  }
  return true;
}

template <typename Id>
bool BoxSplineLattice<Id>::AddRingOfEdge(
  const LatticeVertex<Id>& vertex, const LatticeWeights& base, LatticeRow<Id>& row) const
{
  const Rule rule = this->GetRule(vertex);
  const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(vertex.Simplex);
  if (rule == Rule::Curve)
  {
    return true;
  }
  if (this->IsUnknown(rule) || (rule == Rule::Surface && faces.size() != 2))
  {
    return false;
  }
  const Row<Id> members = this->Strata.EdgeRings.GetMembers(vertex.Simplex);
  const bool isFirst = base[0] + base[1] == 0;
  for (const Id& face : faces)
  {
    if (face < 0 && rule == Rule::Blend)
    {
      isFirst ? row.Add({ 0, members.begin()[&face - faces.begin()], { { 1, 0, 0, 0 } } }, 0.)
              : void();
      continue;
    }
    if (face < 0)
    {
      return false;
    }
    const LatticeWeights inFace =
      this->Lift(this->GetCorners(1, vertex.Simplex), 2, base, this->GetCorners(2, face), 3);
    const int third = triangle::VertexOpposite[this->Complex.EdgeInFace(face, vertex.Simplex)];
    row.Add(this->Find(2, face, With(inFace, third)), 0.);
  }
  return true;
}

template <typename Id>
bool BoxSplineLattice<Id>::AddRingInFace(const LatticeVertex<Id>& vertex,
  const LatticeWeights& base, LatticeRow<Id>& row, Rule& rule) const
{
  const Id face = vertex.Simplex;
  const Row<Id> tets = this->Complex.FaceTets[face];
  if (this->IsUnknown(rule) || rule == Rule::Curve)
  {
    return rule == Rule::Curve;
  }
  const Id* corners = this->GetCorners(2, face);
  int even = 0;
  while (vertex.Weights[even] % 2 != 0)
  {
    ++even;
  }
  const LatticeWeights both = With(With(base, (even + 1) % 3), (even + 2) % 3);
  LatticeWeights across = both;
  --across[even];
  row.Add(this->Find(2, face, With(base, even)), 0.);
  row.Add(this->Find(2, face, across), 0.);
  if (rule == Rule::Surface || !this->HasSolids)
  {
    return true;
  }
  const bool isBlend = rule == Rule::Blend;
  rule = isBlend ? rule : Rule::RegularEdge; // unless a tetrahedron marks another edge of the face
  for (const Id tet : tets)
  {
    const int apex = this->Complex.FaceInTet(tet, face);
    const int beside = GetPartner(apex);
    const LatticeWeights inTet = this->Lift(corners, 3, base, this->GetCorners(3, tet), 4);
    row.Add(this->Find(3, tet, With(inTet, apex)), 0.);
    const int third = this->Complex.VertexInTet(tet, corners[even]);
    if (third != beside)
    {
      rule = isBlend ? rule : Rule::Solid;
      LatticeWeights member = With(With(inTet, beside), apex);
      --member[third];
      row.Add(this->Find(3, tet, member), 0.);
    }
  }
  return true;
}

template <typename Id>
void BoxSplineLattice<Id>::AddRingInTet(const LatticeVertex<Id>& vertex, const LatticeWeights& base,
  LatticeRow<Id>& row, Rule& rule) const
{
  const auto add = [&](const LatticeWeights& weights)
  { row.Add(this->Find(3, vertex.Simplex, weights), 0.); };
  const auto isOdd = [&](int i) { return vertex.Weights[i] % 2 != 0; };
  if (isOdd(0) && isOdd(1) && isOdd(2) && isOdd(3))
  {
    rule = Rule::RegularEdge;
    for (int i = 0; i < 4; i += 2)
    {
      for (int k = 1; k < 4; k += 2)
      {
        add(With(With(base, i), k));
      }
    }
    return;
  }
  LatticeWeights both = base;
  for (int i = 0; i < 4; ++i)
  {
    both[i] += isOdd(i) ? 1 : 0;
  }
  for (int i = 0; i < 4; ++i)
  {
    if (!isOdd(i))
    {
      LatticeWeights across = both;
      --across[i];
      add(With(base, i));
      add(across);
    }
    else if (isOdd(GetPartner(i)))
    {
      rule = Rule::RegularEdge;
    }
    else // along an edge that is not marked
    {
      LatticeWeights member = With(With(base, i), GetPartner(i));
      for (int k = 0; k < 4; ++k)
      {
        member[k] -= !isOdd(k) && k != GetPartner(i) ? 1 : 0;
      }
      add(member);
    }
  }
}

template <typename Id>
bool BoxSplineLattice<Id>::AddStar(const LatticeVertex<Id>& vertex, LatticeStar<Id>& star) const
{
  star.Add(vertex, vertex.Double());
  const bool isKnown = this->ForRing(vertex,
    [&](int dimension, Id simplex, const LatticeWeights& own, const LatticeWeights& other)
    {
      star.Add(
        this->Find(dimension, simplex, other), this->Find(dimension, simplex, Sum(own, other)));
    });
  return isKnown && (vertex.Dimension > 0 || !this->HasSolids || GrowStar(*this, *this, star));
}

template <typename Id>
void BoxSplineLattice<Id>::AddStarInSolid(
  const LatticeVertex<Id>& vertex, Id tet, LatticeStar<Id>& star) const
{
  const LatticeWeights own = this->Lift(this->GetCorners(vertex.Dimension, vertex.Simplex),
    vertex.Dimension + 1, vertex.Weights, this->GetCorners(3, tet), 4);
  this->ForRingInTet({ 3, tet, own },
    [&](int, Id, const LatticeWeights&, const LatticeWeights& other)
    {
      if (*std::min_element(other.begin(), other.end()) >= 0)
      {
        star.Add(this->Find(3, tet, other), this->Find(3, tet, Sum(own, other)));
      }
    });
}

template <typename Id>
bool BoxSplineLattice<Id>::ReadLimit(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row)
{
  static const std::vector<double> ofCurves{ 2. / 3., 1. / 6., 1. / 6. };
  static const std::vector<double> ofSurfaces{ 1. / 2., 1. / 12., 1. / 12., 1. / 12., 1. / 12.,
    1. / 12., 1. / 12. };
  const Rule rule = this->GetRule(vertex);
  const bool isFixed = vertex.Dimension > 0;
  const std::vector<double>* weights = isFixed && rule == Rule::Curve ? &ofCurves
    : isFixed && rule == Rule::Surface                                ? &ofSurfaces
                                                                      : nullptr;
  if (!weights)
  {
    this->SetKey(vertex);
    weights = this->Limits.Find(this->Key,
      [&](std::vector<double>& solved) { return SolveLatticeLimit(*this, vertex, solved); });
  }
  if (!weights)
  {
    return false;
  }
  if (vertex.Dimension == 0)
  {
    LatticeStar<Id> star;
    const bool isKnown = this->AddStar(vertex, star);
    row.Vertices = std::move(star.Items);
    row.Weights = *weights;
    return isKnown;
  }
  row.Clear();
  row.Add(vertex, weights->front());
  return this->ForRing(vertex,
    [&](int dimension, Id in, const LatticeWeights&, const LatticeWeights& other)
    { row.Add(this->Find(dimension, in, other), (*weights)[row.Weights.size()]); });
}

SUBDIVISION_COMPILE(class BoxSplineLattice);

}
