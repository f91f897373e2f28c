// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LatticeRings.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Limits/LatticeLimit.h"

#include <algorithm>
#include <utility>

namespace subdivision
{

/// The ring of a vertex of any level; null: it is not known.
template <typename Id>
LatticeRing* LatticeRings<Id>::FindRing(const LatticeVertex<Id>& vertex)
{
  if (!this->IsKnown(vertex.Dimension, vertex.Simplex))
  {
    return nullptr;
  }
  const auto simplex = static_cast<std::uint64_t>(vertex.Simplex);
  this->Key = { vertex.Dimension, static_cast<int>(simplex), static_cast<int>(simplex >> 32) };
  this->Charts.clear();
  if (vertex.Dimension > 1)
  {
    this->FindCut(vertex);
  }
  if (this->Rings.size() > 4096) // bounds the memory
  {
    this->Rings.clear();
  }
  const auto [found, isNew] = this->Rings.try_emplace(this->Key);
  LatticeRing& ring = found->second;
  if (isNew && vertex.Dimension > 1)
  {
    ring.Charts = this->Charts;
    this->Cut.AddTo(ring);
  }
  else if (isNew)
  {
    vertex.Dimension == 0 ? this->MakeAtVertex(vertex.Simplex, ring)
                          : this->MakeOnEdge(vertex.Simplex, ring);
  }
  return &ring;
}

/// What the ring of a control vertex, an edge or a face follows from. Negative: a member without
/// face, which only the first step reads.
template <typename Id>
Row<Id> LatticeRings<Id>::GetCarriers(int dimension, Id simplex) const
{
  switch (dimension)
  {
    case 0:
      return this->Strata.Vertices[simplex].GetRule() == Rule::Corner
        ? Row<Id>()
        : this->Strata.VertexRings.GetCarriers(simplex);
    case 1:
      return this->Strata.Edges[simplex].GetRule() == Rule::Curve
        ? Row<Id>()
        : this->Strata.EdgeRings.GetCarriers(simplex);
    default:
      return this->Strata.Faces[simplex].GetRule() == Rule::Surface
        ? Row<Id>()
        : this->Complex.FaceTets[simplex];
  }
}

template <typename Id>
bool LatticeRings<Id>::IsKnown(int dimension, Id simplex) const
{
  if (dimension == 2)
  {
    const Rule rule = this->Strata.Faces[simplex].GetRule();
    return rule == Rule::Surface || rule == Rule::Blend ||
      (rule == Rule::Solid && this->Complex.FaceTets[simplex].size() == 2);
  }
  if (dimension == 3 || (dimension == 1 && this->Strata.Edges[simplex].GetRule() == Rule::Blend))
  {
    return true;
  }
  const Row<Id> carriers = this->GetCarriers(dimension, simplex);
  return std::all_of(carriers.begin(), carriers.end(), [](Id carrier) { return carrier >= 0; });
}

/// A simplex that has some corners.
template <typename Id>
LatticeRing::Chart LatticeRings<Id>::GetChart(
  int dimension, Id simplex, int size, const Id* corners) const
{
  const Id* there = this->Lattice.GetCorners(dimension, simplex);
  // What is not among the first ones is the last one.
  LatticeRing::Chart chart{ dimension, simplex, {} };
  for (int i = 0; i < size; ++i)
  {
    chart.Places[i] = static_cast<int>(std::find(there, there + dimension, corners[i]) - there);
  }
  return chart;
}

/// Finds the cut for a vertex in a face or tetrahedron, with charts, and the key of its ring: all
/// tetrahedra are alike, and all faces of surfaces.
template <typename Id>
void LatticeRings<Id>::FindCut(const LatticeVertex<Id>& vertex)
{
  const bool isShared =
    vertex.Dimension == 3 || this->Strata.Faces[vertex.Simplex].GetRule() == Rule::Surface;
  LatticeWeights at = vertex.Weights;
  while (std::all_of(at.begin(), at.end(), [](long long weight) { return weight % 2 == 0; }))
  {
    for (long long& weight : at)
    {
      weight /= 2;
    }
  }
  if (vertex.Dimension == 3)
  {
    this->Cut.FindInTet(at);
  }
  else
  {
    for (const Id tet : this->GetCarriers(2, vertex.Simplex))
    {
      this->Charts.push_back(
        this->GetChart(3, tet, 3, this->Lattice.GetCorners(2, vertex.Simplex)));
    }
    this->Cut.FindInFace(at, this->Charts);
  }
  this->Key.resize(isShared ? 1 : 3);
  this->Cut.AppendKey(this->Key);
}

template <typename Id>
void LatticeRings<Id>::MakeAtVertex(Id vertex, LatticeRing& ring) const
{
  for (const Id edge : this->GetCarriers(0, vertex))
  {
    ring.Charts.push_back(this->GetChart(1, edge, 1, &vertex));
    LatticeStep step = { { 1, 1, 0, 0 } };
    step[ring.Charts.back().Places[0]] = -1;
    ring.Vertex.push_back({ static_cast<int>(ring.Charts.size()) - 1, step });
  }
}

template <typename Id>
void LatticeRings<Id>::MakeOnEdge(Id edge, LatticeRing& ring) const
{
  ring.AddEnds(LatticeUnits[0], LatticeUnits[1]);
  const Id* ends = this->Lattice.GetCorners(1, edge);
  const auto addChart = [&](int dimension, Id simplex)
  {
    ring.Charts.push_back(this->GetChart(dimension, simplex, 2, ends));
    return ring.Charts.back().Places;
  };
  const auto getLast = [&ring]() { return static_cast<int>(ring.Charts.size()) - 1; };
  const bool isSurface = this->Strata.Edges[edge].GetRule() == Rule::Surface;
  for (const Id face : this->GetCarriers(1, edge))
  {
    if (face < 0)
    {
      continue;
    }
    const auto inFace = addChart(2, face);
    const int third = 3 - inFace[0] - inFace[1];
    ring.AddFace(getLast(), LatticeUnits[inFace[0]], LatticeUnits[inFace[1]], LatticeUnits[third]);
    for (const Id tet : isSurface ? Row<Id>() : this->Complex.FaceTets[face])
    {
      const auto inTet = addChart(3, tet);
      ring.AddDiagonal(getLast(), LatticeUnits, inTet[0], inTet[1],
        this->Complex.VertexInTet(tet, this->Lattice.GetCorners(2, face)[third]));
    }
  }
}

/// The vertex at (factor * weights + step) / divisor.
template <typename Id>
LatticeVertex<Id> LatticeRings<Id>::Go(const LatticeVertex<Id>& vertex, const LatticeRing& ring,
  const LatticeRing::Step& step, int factor, int divisor) const
{
  const LatticeRing::Chart own{ vertex.Dimension, vertex.Simplex, { { 0, 1, 2, 3 } } };
  const LatticeRing::Chart& chart =
    step.Chart < 0 ? own : ring.Charts[static_cast<std::size_t>(step.Chart)];
  LatticeWeights at{};
  for (int i = 0; i <= vertex.Dimension; ++i)
  {
    at[chart.Places[i]] = factor * vertex.Weights[i];
  }
  for (int i = 0; i < 4; ++i)
  {
    at[i] = (at[i] + step.Change[i]) / divisor;
  }
  return this->Lattice.Find(chart.Dimension, static_cast<Id>(chart.Simplex), at);
}

/// Sets the weights of a row of which the vertices are known.
template <typename Id>
void LatticeRings<Id>::SetWeights(bool isEdge, Rule rule, LatticeRow<Id>& row) const
{
  const std::size_t own = isEdge ? 2 : 1;
  const PartedMask mask =
    GetMask(this->Masks, isEdge, rule, static_cast<vtkIdType>(row.Vertices.size() - own));
  row.Vertices.resize(mask.Weights[0] == 0. ? own : row.Vertices.size());
  row.Weights.assign(row.Vertices.size(), mask.Weights[0]);
  std::fill_n(row.Weights.begin(), own, mask.Own);
}

template <typename Id>
bool LatticeRings<Id>::ReadRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row)
{
  row.Clear();
  LatticeVertex<Id> old = vertex;
  for (long long& weight : old.Weights)
  {
    if (weight % 2 != 0)
    {
      return this->ReadEdgeRow(vertex, row);
    }
    weight /= 2;
  }
  const LatticeRing* ring = this->FindRing(old);
  if (!ring)
  {
    return false;
  }
  row.Vertices.push_back(old);
  for (const LatticeRing::Step& step : ring->Vertex)
  {
    row.Vertices.push_back(this->Go(old, *ring, step, 1, 1));
  }
  this->SetWeights(false, this->Lattice.GetRule(old), row);
  return true;
}

/// The row of a vertex in the middle of an edge of the level before.
template <typename Id>
bool LatticeRings<Id>::ReadEdgeRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row)
{
  const LatticeRing* ring = this->FindRing(vertex);
  if (!ring)
  {
    return false;
  }
  const auto add = [&](const LatticeRing::Step& step)
  { row.Vertices.push_back(this->Go(vertex, *ring, step, 1, 2)); };
  std::for_each_n(ring->Vertex.begin(), 2, add);
  if (vertex.Dimension == 1 && vertex.Weights[0] + vertex.Weights[1] == 2) // a control edge
  {
    for (const Id member : this->Strata.EdgeRings.GetMembers(vertex.Simplex))
    {
      row.Vertices.push_back({ 0, member, { { 1, 0, 0, 0 } } });
    }
  }
  else
  {
    std::for_each(ring->Edge.begin(), ring->Edge.end(), add);
  }
  const Rule rule = vertex.Dimension == 1 ? this->Strata.Edges[vertex.Simplex].GetRule()
                                          : this->Lattice.GetRule(vertex);
  this->SetWeights(true, rule == Rule::Solid && ring->IsRegular ? Rule::RegularEdge : rule, row);
  return true;
}

template <typename Id>
bool LatticeRings<Id>::SolveLimit(
  const LatticeVertex<Id>& vertex, const LatticeRing& ring, std::vector<double>& weights)
{
  std::vector<LatticeVertex<Id>> items{ vertex };
  std::vector<LatticeVertex<Id>> next{ vertex };
  for (long long& weight : next[0].Weights)
  {
    weight *= 2;
  }
  for (const LatticeRing::Step& step : ring.Vertex)
  {
    items.push_back(this->Go(vertex, ring, step, 1, 1));
    next.push_back(this->Go(vertex, ring, step, 2, 1));
  }
  return SolveLatticeLimit(*this, items, next, weights);
}

template <typename Id>
bool LatticeRings<Id>::ReadLimit(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row)
{
  LatticeRing* ring = this->FindRing(vertex);
  if (ring && ring->Limit.empty())
  {
    std::vector<double> weights;
    const bool isSolved = this->SolveLimit(vertex, *ring, weights);
    ring = isSolved ? this->FindRing(vertex) : nullptr; // others were looked for meanwhile
    isSolved ? ring->Limit.swap(weights) : void();
  }
  if (!ring)
  {
    return false;
  }
  row.Clear();
  row.Vertices.push_back(vertex);
  for (const LatticeRing::Step& step : ring->Vertex)
  {
    row.Vertices.push_back(this->Go(vertex, *ring, step, 1, 1));
  }
  row.Weights = ring->Limit;
  return true;
}

SUBDIVISION_COMPILE(class LatticeRings);

}
