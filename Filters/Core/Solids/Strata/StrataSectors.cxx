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

bool IsOnCurve(Stratum vertex)
{
  return vertex.GetRule() == Rule::Curve || vertex.GetRule() == Rule::Corner;
}

/// Goes around a vertex from an edge that bounds a surface there, across a face and edges inside
/// the surface, to the next edge that bounds it. Returns whether it passes some edges; `walk` gets
/// all of them.
template <typename Id>
bool WalkSector(const SimplicialComplex<Id>& complex, const Strata<Id>& strata, Id vertex, Id edge,
  Id face, std::vector<Id>& walk)
{
  walk.assign(1, edge);
  for (;;)
  {
    const Id next = complex.OtherEdge(face, walk.back(), vertex);
    walk.push_back(next);
    if (strata.Edges[next].GetRule() != Rule::Surface)
    {
      return walk.size() > 2 && next != edge;
    }
    const Row<Id> faces = strata.EdgeRings.GetCarriers(next); // two, as at all edges of surfaces
    if (faces.begin()[0] != face && faces.begin()[1] != face)
    {
      return false; // of another surface
    }
    face = faces.begin()[faces.begin()[0] == face ? 1 : 0];
  }
}

/// Appends the inner edges of a sector of triangles of the angle `t` at a vertex.
template <typename Id>
void AppendSector(const SimplicialComplex<Id>& complex, const Strata<Id>& strata, Id vertex,
  const std::vector<Id>& walk, double t, std::vector<SectorEdge<Id>>& sectors)
{
  const auto size = static_cast<int>(walk.size()) - 1;
  const double angle = t * size;
  const bool isConcave = strata.Vertices[vertex].GetRule() == Rule::Corner && angle > Pi;
  for (int j = 1; j < size; ++j)
  {
    const Id other = complex.GetOtherEnd(walk[j], vertex);
    SectorEdge<Id> sector;
    sector.Edge = walk[j];
    sector.End = complex.EdgeVertices[2 * vtkIdType(walk[j])] == vertex ? 0 : 1;
    sector.IsShared = IsOnCurve(strata.Vertices[other]);
    sector.Shift = PlainEndWeight - GetFarEndWeight(t);
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

/// Appends the edges of all sectors at a vertex.
template <typename Id>
void StrataBuilder<Id>::AppendSectors(
  Id vertex, const Strata<Id>& strata, std::vector<SectorEdge<Id>>& sectors) const
{
  const bool isCorner = strata.Vertices[vertex].GetRule() == Rule::Corner;
  const double given =
    isCorner && !this->Options.CornerAngles.empty() ? this->Options.CornerAngles[vertex] : -1.;
  if (!IsOnCurve(strata.Vertices[vertex]) || (isCorner && !(given >= 0.)))
  {
    return;
  }
  std::vector<Id> walk;
  for (Id edge : this->Around.VertexEdges[vertex])
  {
    const bool bounds = strata.Edges[edge].GetRule() != Rule::Surface;
    for (Id face : bounds ? this->Around.EdgeFaces[edge] : Row<Id>())
    {
      // Each sector is found from both of its ends. The smaller id decides, which is the same in
      // all partitions of a mesh.
      if (!WalkSector(this->Complex, strata, vertex, edge, face, walk) ||
        this->Complex.GetOtherEnd(walk.back(), vertex) < this->Complex.GetOtherEnd(edge, vertex))
      {
        continue;
      }
      const auto size = static_cast<int>(walk.size()) - 1;
      if (isCorner)
      {
        const double t = ClampCornerAngle(given, AngleTie) / size;
        AppendSector(this->Complex, strata, vertex, walk, t, sectors);
      }
      else if (size != 3) // where it is the plain rule, bit for bit
      {
        AppendSector(this->Complex, strata, vertex, walk, Pi / size, sectors);
      }
    }
  }
}

template <typename Id>
std::vector<SectorEdge<Id>> StrataBuilder<Id>::CollectSectors(const Strata<Id>& strata) const
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
        this->AppendSectors(static_cast<Id>(v), strata, parts[static_cast<std::size_t>(b)]);
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

SUBDIVISION_COMPILE(class StrataBuilder);

}
