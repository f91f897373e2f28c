// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TetOct/TetOctComplex.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Scheme/ChildRowsMaker.h"
#include "Core/Solids/Scheme/Refiner.h"
#include "Core/Solids/Scheme/VertexSegments.h"
#include "Core/Solids/TetOct/TetOctSplit.h"

namespace subdivision
{

template <typename Id>
TetOctLevel<Id> MakeTetOctLevel(Level<Id>&& control)
{
  TetOctLevel<Id> level;
  level.Complex = std::move(control.Complex);
  level.Strata = std::move(control.Strata);
  level.NumberOfControlVertices = level.Complex.NumberOfVertices;
  level.EqualOcts = { Buffer<Id>(0), Buffer<Id>(0) };
  auto& edges = level.Strata.Edges;
  ForEach(edges.size(),
    [&](vtkIdType e) // edges that are regular for the box spline are not regular in this scheme
    {
      const bool regular = edges[e].GetRule() == Rule::RegularEdge;
      edges[e] = regular ? Stratum(Rule::Solid, edges[e].GetType()) : edges[e];
    });
  Buffer<Id> tetsAt(level.Complex.NumberOfEdges, Id(0));
  for (Id edge : InTurn(level.Complex.TetEdges))
  {
    ++tetsAt[edge];
  }
  const Rings<Id>& rings = level.Strata.VertexRings;
  auto counts = std::make_shared<Buffer<Id>>(rings.Carriers.size());
  ForEach(counts->size(), [&](vtkIdType i) { (*counts)[i] = tetsAt[rings.Carriers[i]]; });
  level.TetsAtSpokes = counts;
  return level;
}

template <typename Id>
TetOctLevel<Id> Refine(const TetOctLevel<Id>& parent, Depth depth)
{
  return Refiner<TetOctSplit<Id>>(parent, depth).Run();
}

IdSegments ListTetOctVertices(int steps)
{
  return ListVertexSegments<TetShape::Shapes>(steps);
}

template class ChildRows<TetOctSplit<int>>;
template class ChildRows<TetOctSplit<long long>>;
SUBDIVISION_COMPILE_FUNCTION(MakeTetOctLevel);
template TetOctLevel<int> Refine(const TetOctLevel<int>&, Depth);
template TetOctLevel<long long> Refine(const TetOctLevel<long long>&, Depth);

}
