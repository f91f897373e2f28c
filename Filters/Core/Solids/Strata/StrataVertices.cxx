// SPDX-License-Identifier: BSD-3-Clause
// Decides the rules and rings of vertices (Mathematics 4, 6).
#include "Core/Solids/Strata/StrataBuilder.h"

#include "Core/Memory/Ids.h"

namespace subdivision
{
namespace
{

Decision DecideCurves(std::size_t edges, RingKind ring, int type)
{
  const Rule rule = RuleOfCurves(edges);
  return Decide(rule, type, rule == Rule::Curve ? ring : RingKind::None);
}

}

template <typename Id, typename AnyComplex>
Decision StrataDecisions<Id, AnyComplex>::DecideVertex(Id vertex) const
{
  if (this->Complex.HasEdgesAlone() && this->Around.VertexEdges[vertex].size() == 2 &&
    !this->HasSingular())
  {
    return DecideIn(Rule::Curve, 0, DimensionBit(1)); // as below, in fewer steps
  }
  const unsigned char dimensions = this->Around.VertexDimensions(vertex);
  Place places[4] = {};
  for (int k = 1; k <= 3; ++k)
  {
    if (dimensions & DimensionBit(k))
    {
      places[k] = this->Around.PlaceVertex(vertex, k);
    }
  }
  const int type = this->TypeOf(dimensions, places);
  Decision decision;
  if (this->DecideSingularVertex(vertex, type, decision))
  {
    return decision;
  }
  if (dimensions == 0) // isolated
  {
    return Decide(Rule::Corner, 0, RingKind::None);
  }
  if (type)
  {
    const unsigned char regional =
      this->Options.VertexChoices.empty() ? 0 : this->Options.VertexChoices[vertex];
    return this->DecideJointVertex(vertex, type, dimensions, this->Choice(type, regional));
  }
  const int k = dimensions == 1 ? 1 : dimensions == 2 ? 2 : 3;
  return this->DecideVertexIn(vertex, k, places[k], 0);
}

/// Items 1 to 3 of the list for vertices in Mathematics 4: singular vertices, creases, singular
/// triangles. Returns false if none of them applies.
template <typename Id, typename AnyComplex>
bool StrataDecisions<Id, AnyComplex>::DecideSingularVertex(
  Id vertex, int type, Decision& decision) const
{
  if (!this->HasSingular())
  {
    return false;
  }
  const Decision corner = Decide(Rule::Corner, type, RingKind::None);
  if (!this->Singular.Vertices.empty() && this->Singular.Vertices[vertex])
  {
    decision = corner;
    return true;
  }
  std::size_t creases = 0;
  bool onSingularFace = false;
  for (Id edge : this->Around.VertexEdges[vertex])
  {
    creases += this->IsCrease(edge) ? 1 : 0;
    onSingularFace = onSingularFace || this->CountSingularFaces(edge) > 0;
  }
  const bool isDart = creases == 1 && this->Options.DartEnds && !this->LiesOnBoundaryCurve(vertex);
  if (creases > 0 && !isDart)
  {
    decision = DecideCurves(creases, RingKind::Creases, type);
    return true;
  }
  if (onSingularFace)
  {
    const bool closed =
      this->Around.IsClosedFan(vertex, [this](Id face) { return this->IsSingularFace(face); });
    decision = closed ? Decide(Rule::Surface, type, RingKind::SingularFaces) : corner;
    return true;
  }
  return false;
}

template <typename Id, typename AnyComplex>
bool StrataDecisions<Id, AnyComplex>::LiesOnBoundaryCurve(Id vertex) const
{
  for (Id edge : this->Around.VertexEdges[vertex])
  {
    if (this->Around.PlaceEdge(edge, 2) == Place::Boundary || (this->CountSingularFaces(edge) == 1))
    {
      return true;
    }
  }
  return this->Around.PlaceVertex(vertex, 1) == Place::Boundary;
}

template <typename Id, typename AnyComplex>
Decision StrataDecisions<Id, AnyComplex>::DecideJointVertex(
  Id vertex, int type, unsigned char dimensions, JointRule rule) const
{
  switch (rule)
  {
    case JointRule::Sharp:
    {
      std::size_t sharp = 0;
      for (Id edge : this->Around.VertexEdges[vertex])
      {
        sharp += this->IsSharpJoint(edge) ? 1 : 0;
      }
      return DecideCurves(sharp, RingKind::SharpJoints, type);
    }
    case JointRule::FollowDimension1:
    case JointRule::FollowDimension2:
    case JointRule::FollowDimension3:
    {
      const int k = 1 + static_cast<int>(rule) - static_cast<int>(JointRule::FollowDimension1);
      if (dimensions & DimensionBit(k))
      {
        const Place place = this->Around.PlaceVertex(vertex, k);
        return this->DecideVertexIn(vertex, k, place, type);
      }
      break;
    }
    case JointRule::FollowPart:
    {
      const int k = dimensions & DimensionBit(1) ? 1 : 2;
      const int part = dimensions & DimensionBit(k) ? this->FindPartAtVertex(vertex, k) : -1;
      if (part >= 0)
      {
        return { Stratum(RuleOfDimension(k), type), RingKind::Part, DimensionBit(k), part };
      }
      break;
    }
    default:
      break;
  }
  return DecideIn(Rule::Blend, type, AllDimensions);
}

template <typename Id, typename AnyComplex>
Decision StrataDecisions<Id, AnyComplex>::DecideVertexIn(
  Id vertex, int k, Place place, int type) const
{
  if (place == Place::Interior)
  {
    return DecideIn(RuleOfDimension(k), type, DimensionBit(k));
  }
  if (place == Place::Boundary)
  {
    const RingKind rings[4] = { RingKind::None, RingKind::None, RingKind::BoundaryOfSurface,
      RingKind::BoundaryOfSolid };
    return Decide(RuleOfDimension(k - 1), type, rings[k]);
  }
  const int inner = place == Place::Type2 ? 2 : 3;
  const unsigned char regional =
    this->Options.VertexChoices.empty() ? 0 : this->Options.VertexChoices[vertex];
  Decision decision =
    this->DecideJointVertex(vertex, type, DimensionBit(k), this->Choice(inner, regional));
  if (decision.Ring == RingKind::InDimensions)
  {
    decision.Dimensions = DimensionBit(k);
  }
  return decision;
}

template <typename Id, typename AnyComplex>
bool StrataDecisions<Id, AnyComplex>::IsInVertexRing(Id edge, const Decision& decision) const
{
  switch (decision.Ring)
  {
    case RingKind::Creases:
      return this->IsCrease(edge);
    case RingKind::SharpJoints:
      return this->IsSharpJoint(edge);
    case RingKind::SingularFaces:
      return this->CountSingularFaces(edge) > 0;
    case RingKind::InDimensions:
      return this->Around.EdgeDimensions(edge) & decision.Dimensions;
    case RingKind::BoundaryOfSolid:
      return this->Around.PlaceEdge(edge, 3) == Place::Boundary;
    case RingKind::BoundaryOfSurface:
      return this->Around.PlaceEdge(edge, 2) == Place::Boundary;
    case RingKind::Part:
    {
      if (decision.Dimensions == DimensionBit(1))
      {
        return this->Around.EdgeFaces[edge].size() == 0 && this->PartOfEdge(edge) == decision.Part;
      }
      const Row<Id> faces = this->Around.EdgeFaces[edge];
      return std::any_of(faces.begin(), faces.end(), [&](Id face)
        { return this->CountSolids(face) == 0 && this->PartOfFace(face) == decision.Part; });
    }
    default:
      return false;
  }
}

/// The part with the smallest id that is a manifold inside C_k (k = 1 or 2) at a vertex: it has
/// exactly two lines there, or its triangles form one closed fan. Returns -1 if there is none.
template <typename Id, typename AnyComplex>
int StrataDecisions<Id, AnyComplex>::FindPartAtVertex(Id vertex, int k) const
{
  std::vector<int> parts;
  for (Id edge : this->Around.VertexEdges[vertex])
  {
    if (k == 1 && this->Around.EdgeFaces[edge].size() == 0)
    {
      parts.push_back(this->PartOfEdge(edge));
    }
    for (Id face : this->Around.EdgeFaces[edge])
    {
      if (k == 2 && this->CountSolids(face) == 0)
      {
        parts.push_back(this->PartOfFace(face));
      }
    }
  }
  std::sort(parts.begin(), parts.end());
  for (auto part = parts.begin(); part != parts.end();)
  {
    const auto next = std::upper_bound(part, parts.end(), *part);
    const bool goesOn = *part >= 0 &&
      (k == 1 ? next - part == 2
              : this->Around.IsClosedFan(vertex, [&](Id face)
                  { return this->CountSolids(face) == 0 && this->PartOfFace(face) == *part; }));
    if (goesOn)
    {
      return *part;
    }
    part = next;
  }
  return -1;
}

SUBDIVISION_COMPILE(class StrataDecisions);
template class StrataDecisions<int, CellComplex<int>>;
template class StrataDecisions<long long, CellComplex<long long>>;

}
