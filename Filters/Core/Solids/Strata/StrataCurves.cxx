// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Strata/StrataCurves.h"

#include "Core/Memory/Ids.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The stratum of a vertex of so many edges: isolated ones and ends do not move.
Stratum GetStratum(vtkIdType edges)
{
  return edges < 2 ? Stratum(Rule::Corner)
    : edges == 2   ? Stratum(Rule::Curve)
                   : Stratum(Rule::Blend, 2);
}

/// Lists the edges at vertices that have a ring, and their other ends. `rings` has offsets.
template <typename Id>
void FillRings(
  const SimplicialComplex<Id>& complex, const Buffer<Stratum>& vertices, Rings<Id>& rings)
{
  const vtkIdType size = vertices.size();
  rings.Members = Buffer<Id>(rings.Offsets[size]);
  rings.Carriers = Buffer<Id>(rings.Offsets[size]);
  // Each offset counts up to the next one.
  Id* const next = rings.Offsets.data();
  const auto add = [&](Id vertex, Id edge, Id other)
  {
    if (vertices[vertex].GetRule() != Rule::Corner)
    {
      const Id place = next[vertex]++;
      rings.Members[place] = other;
      rings.Carriers[place] = edge;
    }
  };
  ForEachInTurn(complex.NumberOfEdges,
    [&](vtkIdType e)
    {
      const Id* ends = complex.EdgeVertices.data() + 2 * e;
      add(ends[0], static_cast<Id>(e), ends[1]);
      add(ends[1], static_cast<Id>(e), ends[0]);
    });
  std::copy_backward(next, next + size, next + size + 1);
  next[0] = 0;
}

}

template <typename Id>
bool FindStrataOfCurves(const SimplicialComplex<Id>& complex, const SingularSimplices& singular,
  const StrataOptions& options, Strata<Id>& strata)
{
  if (!complex.HasEdgesAlone() || !singular.Vertices.empty() || !singular.Edges.empty())
  {
    return false;
  }
  const vtkIdType size = complex.NumberOfVertices;
  Rings<Id> rings;
  rings.Offsets = Buffer<Id>(size + 1, Id(0));
  ForEachInTurn(
    complex.EdgeVertices.size(), [&](vtkIdType i) { ++rings.Offsets[complex.EdgeVertices[i]]; });
  const bool blends = options.Type2 == JointRule::Blend && options.VertexChoices.empty();
  if (!blends && *std::max_element(rings.Offsets.begin(), rings.Offsets.end()) > 2)
  {
    return false;
  }
  strata.Weights = options.Weights;
  strata.ModifiedBoundary = options.ModifiedBoundary;
  strata.Vertices = Buffer<Stratum>(size);
  ForEach(size,
    [&](vtkIdType v)
    {
      strata.Vertices[v] = GetStratum(rings.Offsets[v]);
      rings.Offsets[v] = rings.Offsets[v] == 1 ? 0 : rings.Offsets[v];
    });
  CountsToOffsets(rings.Offsets);
  FillRings(complex, strata.Vertices, rings);
  strata.VertexRings = std::move(rings);
  strata.Edges = Buffer<Stratum>(complex.NumberOfEdges, Stratum(Rule::Curve));
  strata.Faces = Buffer<Stratum>(0);
  strata.EdgeRings.Offsets = Buffer<Id>(complex.NumberOfEdges + 1, Id(0));
  return true;
}

SUBDIVISION_COMPILE_FUNCTION(FindStrataOfCurves);

}
