// SPDX-License-Identifier: BSD-3-Clause
// Finds the edges whose rule depends on the sector at one of their ends (Mathematics 12).
#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/Strata/StrataBuilder.h"

#include <iterator>

namespace subdivision
{
namespace
{

/// An angle that is pi up to this, relative, counts as convex.
constexpr double AngleTie = 1e-9;

bool IsOnCurve(const Decision& vertex)
{
  const Rule rule = vertex.Result.GetRule();
  return rule == Rule::Curve || rule == Rule::Corner;
}

/// The shift of a sector in which each face has the angle `t`.
double GetShift(bool ofQuads, double t)
{
  return ofQuads ? std::cos(t) / 4. : PlainEndWeight - GetFarEndWeight(t);
}

/// Appends the inner edges of a sector of faces of the angle `t` at a vertex.
template <typename Id, typename AnyComplex>
void AppendSector(const AnyComplex& complex, const Buffer<Decision>& vertices, Id vertex,
  const std::vector<Id>& walk, bool ofQuads, double t, std::vector<SectorEdge<Id>>& sectors)
{
  const auto size = static_cast<int>(walk.size()) - 1;
  const double angle = t * size;
  const bool isConcave = vertices[vertex].Result.GetRule() == Rule::Corner && angle > Pi;
  for (int j = 1; j < size; ++j)
  {
    const Id other = complex.GetOtherEnd(walk[j], vertex);
    SectorEdge<Id> sector;
    sector.Edge = walk[j];
    sector.End = complex.EdgeVertices[2 * vtkIdType(walk[j])] == vertex ? 0 : 1;
    sector.IsShared = IsOnCurve(vertices[other]);
    sector.Shift = GetShift(ofQuads, t);
    if (isConcave)
    {
      const FlatWeights weights = GetFlatWeights(angle, std::cos(j * t), std::sin(j * t));
      sector.Flatness = GetFlatness(GetThirdEigenvalueOfTriangles(size, angle));
      sector.Weights[0] = weights.First;
      sector.Weights[1] = weights.Last;
      for (int i = 0; i < 2; ++i)
      {
        sector.Bounds[i] = i == 0 ? walk.front() : walk.back();
        sector.Ends[i] = complex.GetOtherEnd(sector.Bounds[i], vertex);
      }
    }
    sectors.push_back(sector);
  }
}

}

/// Goes around a vertex from an edge that bounds a surface there, across a face and edges inside
/// the surface, to the next edge that bounds it. Returns whether it passes some edges; `walk` gets
/// all of them. `quads` gets the number of quads among the faces.
template <typename Id, typename AnyComplex>
bool StrataDecisions<Id, AnyComplex>::WalkSector(const Buffer<Decision>& edges, Id vertex, Id edge,
  Id face, std::vector<Id>& walk, std::size_t& quads) const
{
  walk.assign(1, edge);
  quads = 0;
  for (;;)
  {
    const Id before = walk.back();
    quads += GetOppositeVertex(this->Complex, face, before) < 0 ? 1 : 0;
    const Id next =
      GetOtherEdge(this->Complex, face, before, vertex, this->Complex.GetOtherEnd(before, vertex));
    walk.push_back(next);
    if (edges[next].Result.GetRule() != Rule::Surface)
    {
      return walk.size() > 2 && next != edge;
    }
    if (!this->IsInEdgeRing(face, edges[next]))
    {
      return false; // of another surface
    }
    const Row<Id> faces = this->Around.EdgeFaces[next];
    face = *std::find_if(faces.begin(), faces.end(),
      [&](Id other) { return other != face && this->IsInEdgeRing(other, edges[next]); });
  }
}

/// Appends the edges of all sectors at a vertex.
template <typename Id, typename AnyComplex>
void StrataDecisions<Id, AnyComplex>::AppendSectors(Id vertex, const Buffer<Decision>& edges,
  const Buffer<Decision>& vertices, std::vector<SectorEdge<Id>>& sectors) const
{
  const bool isCorner = vertices[vertex].Result.GetRule() == Rule::Corner;
  const double given =
    isCorner && !this->Options.CornerAngles.empty() ? this->Options.CornerAngles[vertex] : -1.;
  if (!IsOnCurve(vertices[vertex]) || (isCorner && !(given >= 0.)))
  {
    return;
  }
  std::vector<Id> walk;
  std::size_t quads = 0;
  for (Id edge : this->Around.VertexEdges[vertex])
  {
    const bool bounds = edges[edge].Result.GetRule() != Rule::Surface;
    for (Id face : bounds ? this->Around.EdgeFaces[edge] : Row<Id>())
    {
      // Each sector is found from both of its ends. The smaller id decides, which is the same in
      // all partitions of a mesh.
      if (!this->WalkSector(edges, vertex, edge, face, walk, quads) ||
        this->Complex.GetOtherEnd(walk.back(), vertex) < this->Complex.GetOtherEnd(edge, vertex))
      {
        continue;
      }
      const auto size = static_cast<int>(walk.size()) - 1;
      const bool ofQuads = quads > 0;
      if (ofQuads && quads + 1 < walk.size())
      {
        continue; // of both: the plain rule
      }
      if (isCorner)
      {
        const double t = ClampCornerAngle(given, AngleTie) / size;
        AppendSector(this->Complex, vertices, vertex, walk, ofQuads, t, sectors);
      }
      else if (size != (ofQuads ? 2 : 3)) // where it is the plain rule, bit for bit
      {
        AppendSector(this->Complex, vertices, vertex, walk, ofQuads, Pi / size, sectors);
      }
    }
  }
}

template <typename Id, typename AnyComplex>
std::vector<SectorEdge<Id>> StrataDecisions<Id, AnyComplex>::CollectSectors(
  const Buffer<Decision>& edges, const Buffer<Decision>& vertices) const
{
  constexpr vtkIdType block = 4096;
  const vtkIdType size = this->Complex.NumberOfVertices;
  const vtkIdType blocks = (size + block - 1) / block;
  std::vector<std::vector<SectorEdge<Id>>> parts(static_cast<std::size_t>(blocks));
  const auto collect = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType b = begin; b < end; ++b)
    {
      for (vtkIdType v = b * block; v < std::min(size, (b + 1) * block); ++v)
      {
        this->AppendSectors(
          static_cast<Id>(v), edges, vertices, parts[static_cast<std::size_t>(b)]);
      }
    }
  };
  ForRangesOfBlocks(blocks, collect);
  std::vector<SectorEdge<Id>> sectors;
  for (std::vector<SectorEdge<Id>>& part : parts)
  {
    std::copy(part.begin(), part.end(), std::back_inserter(sectors));
  }
  StableSort(sectors, [](const SectorEdge<Id>& a, const SectorEdge<Id>& b)
    { return a.Edge < b.Edge || (a.Edge == b.Edge && a.End < b.End); });
  return sectors;
}

SUBDIVISION_COMPILE(class StrataDecisions);
template class StrataDecisions<int, CellComplex<int>>;
template class StrataDecisions<long long, CellComplex<long long>>;

}
