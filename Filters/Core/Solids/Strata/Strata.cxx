// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Strata/Strata.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Strata/StrataBuilder.h"
#include "Core/Solids/Strata/StrataCurves.h"

#include <algorithm>
#include <iterator>

namespace subdivision
{
namespace
{

/// Makes the ring of each row i of `around`. Its carriers are all with accept(i, carrier), or
/// simply all if acceptAll(i), with member(i, carrier) as members; the vertices of reliefs[i]
/// follow, with the carrier -1.
template <typename Id, typename AcceptAll, typename Accept, typename Member>
Rings<Id> MakeRings(const Rows<Id>& around, const AcceptAll& acceptAll, const Accept& accept,
  const Member& member, const std::vector<std::vector<Id>>& reliefs)
{
  const vtkIdType size = around.GetNumberOfRows();
  Rings<Id> rings;
  if (around.Items.empty() && reliefs.empty())
  {
    rings.Offsets = Buffer<Id>(size + 1, Id(0));
    return rings;
  }
  rings.Offsets = Buffer<Id>(size + 1);
  ForEach(size,
    [&](vtkIdType i)
    {
      const Row<Id> row = around[i];
      const auto count = acceptAll(i)
        ? row.size()
        : std::count_if(row.begin(), row.end(), [&](Id carrier) { return accept(i, carrier); });
      rings.Offsets[i] = static_cast<Id>(count + (reliefs.empty() ? 0 : reliefs[i].size()));
    });
  CountsToOffsets(rings.Offsets);
  rings.Members = Buffer<Id>(rings.Offsets[size]);
  rings.Carriers = Buffer<Id>(rings.Offsets[size]);
  ForEach(size,
    [&](vtkIdType i)
    {
      Id out = rings.Offsets[i];
      const bool all = acceptAll(i);
      for (Id carrier : around[i])
      {
        if (all || accept(i, carrier))
        {
          rings.Members[out] = member(i, carrier);
          rings.Carriers[out++] = carrier;
        }
      }
      if (!reliefs.empty())
      {
        for (Id vertex : reliefs[i])
        {
          rings.Members[out] = vertex;
          rings.Carriers[out++] = -1;
        }
      }
    });
  return rings;
}

}

/// The non-manifold type: 1 in several C_k, otherwise the type of the place in the only C_k, 0 for
/// manifold.
template <typename Id, typename AnyComplex>
int StrataDecisions<Id, AnyComplex>::TypeOf(unsigned char dimensions, const Place places[4]) const
{
  if (dimensions & (dimensions - 1))
  {
    return 1;
  }
  for (int k = 1; k <= 3; ++k)
  {
    if (dimensions == DimensionBit(k))
    {
      return places[k] == Place::Type2 ? 2 : places[k] == Place::Type3 ? 3 : 0;
    }
  }
  return 0;
}

template <typename Id, typename AnyComplex>
JointRule StrataDecisions<Id, AnyComplex>::Choice(int type, unsigned char regional) const
{
  JointRule rule = type == 1 ? this->Options.Type1
    : type == 2              ? this->Options.Type2
                             : this->Options.Type3;
  if (regional)
  {
    rule = static_cast<JointRule>(regional - 1);
  }
  const bool follows = rule != JointRule::Blend && rule != JointRule::Sharp;
  const bool exists = !follows || (type == 1 && rule != JointRule::FollowPart) ||
    (type == 2 && rule == JointRule::FollowPart);
  return exists ? rule : JointRule::Blend;
}

template <typename Id, typename AnyComplex>
int StrataDecisions<Id, AnyComplex>::CountSingularFaces(Id edge) const
{
  int count = 0;
  if (!this->Singular.Faces.empty())
  {
    for (Id face : this->Around.EdgeFaces[edge])
    {
      count += this->IsSingularFace(face) ? 1 : 0;
    }
  }
  return count;
}

template <typename Id, typename AnyComplex>
Stratum StrataDecisions<Id, AnyComplex>::DecideFace(Id face) const
{
  const vtkIdType tets = this->CountSolids(face);
  const int type = tets > 2 ? 2 : 0;
  if (tets < 2 || this->IsSingularFace(face))
  {
    return Stratum(Rule::Surface, type);
  }
  if (tets == 2)
  {
    return Stratum(Rule::Solid);
  }
  const unsigned char regional =
    this->Options.FaceChoices.empty() ? 0 : this->Options.FaceChoices[face];
  const bool isSharp = this->Choice(type, regional) == JointRule::Sharp;
  return Stratum(isSharp ? Rule::Curve : Rule::Blend, type);
}

/// Common neighbours of the ends of a Blend edge that lie on no face with it.
template <typename Id, typename AnyComplex>
void StrataDecisions<Id, AnyComplex>::CollectRelief(
  Id edge, const Decision& decision, std::vector<Id>& relief) const
{
  // Search at the end with fewer edges: otherwise a vertex of high valence would be searched once
  // for each of its edges.
  auto valence = [this](Id vertex) { return this->Around.VertexEdges[vertex].size(); };
  auto areJoined = [&](Id a, Id b)
  {
    const Id from = valence(a) < valence(b) ? a : b;
    const Row<Id> edges = this->Around.VertexEdges[from];
    return std::any_of(edges.begin(), edges.end(),
      [&](Id other)
      {
        return (this->Around.EdgeDimensions(other) & decision.Dimensions) &&
          this->Complex.GetOtherEnd(other, from) == (from == a ? b : a);
      });
  };
  const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge);
  const Id near = valence(ends[0]) < valence(ends[1]) ? ends[0] : ends[1];
  const Id far = this->Complex.GetOtherEnd(edge, near);
  std::vector<Id> common;
  for (Id other : this->Around.VertexEdges[near])
  {
    const Id neighbour = this->Complex.GetOtherEnd(other, near);
    if (neighbour != far && (this->Around.EdgeDimensions(other) & decision.Dimensions) &&
      areJoined(neighbour, far))
    {
      common.push_back(neighbour);
    }
  }
  std::sort(common.begin(), common.end());
  std::vector<Id> spanned;
  for (Id face : this->Around.EdgeFaces[edge])
  {
    if (this->IsInEdgeRing(face, decision))
    {
      spanned.push_back(GetOppositeVertex(this->Complex, face, edge));
    }
  }
  std::sort(spanned.begin(), spanned.end());
  std::set_difference(
    common.begin(), common.end(), spanned.begin(), spanned.end(), std::back_inserter(relief));
}

/// The reliefs of all edges; empty where no edge has one.
template <typename Id, typename AnyComplex>
std::vector<std::vector<Id>> StrataDecisions<Id, AnyComplex>::CollectReliefs(
  const Buffer<Decision>& edges) const
{
  std::vector<std::vector<Id>> reliefs;
  if (std::none_of(edges.begin(), edges.end(),
        [](const Decision& decision) { return decision.Result.GetRule() == Rule::Blend; }))
  {
    return reliefs;
  }
  reliefs.resize(edges.size());
  ForEach(edges.size(),
    [&](vtkIdType e)
    {
      if (edges[e].Result.GetRule() == Rule::Blend)
      {
        this->CollectRelief(static_cast<Id>(e), edges[e], reliefs[e]);
      }
    });
  if (std::all_of(reliefs.begin(), reliefs.end(), [](const auto& r) { return r.empty(); }))
  {
    reliefs.clear();
  }
  return reliefs;
}

template <typename Id, typename AnyComplex>
void StrataDecisions<Id, AnyComplex>::DecideAll(Buffer<Decision>& edges, Buffer<Decision>& vertices)
{
  this->EdgeMarks = Buffer<unsigned char>(edges.size());
  ForEach(edges.size(),
    [&](vtkIdType e)
    {
      edges[e] = this->DecideEdge(static_cast<Id>(e));
      this->EdgeMarks[e] = edges[e].Ring == RingKind::Creases ? 1
        : edges[e].Ring == RingKind::SharpJoints              ? 2
                                                              : 0;
    });
  ForEach(
    vertices.size(), [&](vtkIdType v) { vertices[v] = this->DecideVertex(static_cast<Id>(v)); });
}

template <typename Id>
Strata<Id> StrataBuilder<Id>::Build()
{
  const vtkIdType edges = this->Complex.NumberOfEdges;
  const vtkIdType vertices = this->Complex.NumberOfVertices;
  Strata<Id> strata;
  strata.Weights = this->Options.Weights;
  strata.ModifiedBoundary = this->Options.ModifiedBoundary;
  Buffer<Decision> edgeDecisions(edges);
  Buffer<Decision> vertexDecisions(vertices);
  this->DecideAll(edgeDecisions, vertexDecisions);
  strata.Edges = Buffer<Stratum>(edges);
  ForEach(edges, [&](vtkIdType e) { strata.Edges[e] = edgeDecisions[e].Result; });
  strata.Vertices = Buffer<Stratum>(vertices);
  ForEach(vertices, [&](vtkIdType v) { strata.Vertices[v] = vertexDecisions[v].Result; });
  strata.Faces = Buffer<Stratum>(this->Complex.NumberOfFaces);
  ForEach(this->Complex.NumberOfFaces,
    [&](vtkIdType f) { strata.Faces[f] = this->DecideFace(static_cast<Id>(f)); });

  const unsigned char only = this->Around.GetOnlyDimension();
  const auto areAllIn = [only](const Decision& decision)
  { return decision.Ring == RingKind::InDimensions && (decision.Dimensions & only) != 0; };
  strata.EdgeRings = MakeRings(
    this->Around.EdgeFaces, [&](vtkIdType e) { return areAllIn(edgeDecisions[e]); },
    [&](vtkIdType e, Id face) { return this->IsInEdgeRing(face, edgeDecisions[e]); },
    [&](vtkIdType e, Id face) { return this->Complex.VertexOpposite(face, static_cast<Id>(e)); },
    this->CollectReliefs(edgeDecisions));
  strata.VertexRings = MakeRings(
    this->Around.VertexEdges, [&](vtkIdType v) { return areAllIn(vertexDecisions[v]); },
    [&](vtkIdType v, Id edge) { return this->IsInVertexRing(edge, vertexDecisions[v]); },
    [&](vtkIdType v, Id edge) { return this->Complex.GetOtherEnd(edge, static_cast<Id>(v)); },
    std::vector<std::vector<Id>>());
  if (strata.ModifiedBoundary)
  {
    strata.Sectors = this->CollectSectors(edgeDecisions, vertexDecisions);
  }
  return strata;
}

SUBDIVISION_COMPILE(class StrataBuilder);
SUBDIVISION_COMPILE(class StrataDecisions);
template class StrataDecisions<int, CellComplex<int>>;
template class StrataDecisions<long long, CellComplex<long long>>;

template <typename Id>
Strata<Id> BuildStrata(const SimplicialComplex<Id>& complex, const SingularSimplices& singular,
  const StrataOptions& options)
{
  Strata<Id> curves;
  return FindStrataOfCurves(complex, singular, options, curves)
    ? std::move(curves)
    : StrataBuilder<Id>(complex, singular, options).Build();
}

SUBDIVISION_COMPILE_FUNCTION(BuildStrata);

}
