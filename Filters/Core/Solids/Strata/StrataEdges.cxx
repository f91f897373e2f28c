// SPDX-License-Identifier: BSD-3-Clause
// Decides the rules and rings of edges (Mathematics 4, 6).
#include "Core/Solids/Complex/Simplices.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Strata/StrataBuilder.h"

#include <limits>

namespace subdivision
{

template <typename Id>
bool IsRegularEdge(const Links<Id>& links, Id edge)
{
  const SimplicialComplex<Id>& complex = links.Complex;
  int faces = 0;
  if (complex.NumberOfTriangleCells == 0 && links.EdgeFaces[edge].size() != 4)
  {
    return false;
  }
  for (Id face : links.EdgeFaces[edge])
  {
    const Row<Id> tets = complex.FaceTets[face];
    if (tets.size() == 0)
    {
      continue; // a maximal triangle: the edge lies in C_2 too and follows C_3
    }
    ++faces;
    for (Id tet : tets)
    {
      if (!tetrahedron::IsMarked(complex.EdgeInTet(tet, edge)))
      {
        return false;
      }
    }
  }
  return faces == 4;
}

template <typename Id, typename AnyComplex>
Decision StrataDecisions<Id, AnyComplex>::DecideEdge(Id edge) const
{
  const bool flagged = !this->Singular.Edges.empty() && this->Singular.Edges[edge];
  if (this->Complex.HasEdgesAlone())
  {
    return Decide(Rule::Curve, 0, flagged ? RingKind::Creases : RingKind::None); // as below
  }
  const unsigned char dimensions = this->Around.EdgeDimensions(edge);
  // No edge is a joint inside C_1 alone.
  const Place places[4] = { {}, {}, this->Around.PlaceEdge(edge, 2),
    this->Around.PlaceEdge(edge, 3) };
  if (dimensions == DimensionBit(2) && places[2] == Place::Interior && !this->HasSingular())
  {
    return DecideIn(Rule::Surface, 0, dimensions); // as below, in fewer steps
  }
  const int type = this->TypeOf(dimensions, places);
  const int singularFaces = this->CountSingularFaces(edge);
  if (flagged || singularFaces == 1 || singularFaces > 2)
  {
    return Decide(Rule::Curve, type, RingKind::Creases);
  }
  if (singularFaces == 2)
  {
    return Decide(Rule::Surface, type, RingKind::SingularFaces);
  }
  if (type)
  {
    const unsigned char regional =
      this->Options.EdgeChoices.empty() ? 0 : this->Options.EdgeChoices[edge];
    return this->DecideJointEdge(edge, type, dimensions, this->Choice(type, regional));
  }
  const int k = dimensions == 1 ? 1 : dimensions == 2 ? 2 : 3;
  return this->DecideEdgeIn(edge, k, places[k], 0);
}

template <typename Id, typename AnyComplex>
Decision StrataDecisions<Id, AnyComplex>::DecideJointEdge(
  Id edge, int type, unsigned char dimensions, JointRule rule) const
{
  switch (rule)
  {
    case JointRule::Sharp:
      return Decide(Rule::Curve, type, RingKind::SharpJoints);
    case JointRule::FollowDimension1:
    case JointRule::FollowDimension2:
    case JointRule::FollowDimension3:
    {
      const int k = 1 + static_cast<int>(rule) - static_cast<int>(JointRule::FollowDimension1);
      if (dimensions & DimensionBit(k))
      {
        return this->DecideEdgeIn(edge, k, this->Around.PlaceEdge(edge, k), type);
      }
      break;
    }
    case JointRule::FollowPart:
    {
      const int part = this->FindPartAtEdge(edge);
      if (part >= 0)
      {
        return { Stratum(Rule::Surface, type), RingKind::Part, DimensionBit(2), part };
      }
      break;
    }
    default:
      break;
  }
  return DecideIn(Rule::Blend, type, AllDimensions);
}

/// Decides an edge inside C_k alone, where it has the given place. If it is a joint of C_k, it lies
/// in other C_k too, which the choice FollowDimension ignores.
template <typename Id, typename AnyComplex>
Decision StrataDecisions<Id, AnyComplex>::DecideEdgeIn(Id edge, int k, Place place, int type) const
{
  if (k == 1)
  {
    return Decide(Rule::Curve, type, RingKind::None);
  }
  switch (place)
  {
    case Place::Boundary:
      return k == 3 ? Decide(Rule::Surface, type, RingKind::BoundaryOfSolid)
                    : Decide(Rule::Curve, type, RingKind::BoundaryOfSurface);
    case Place::Interior:
    {
      const Rule rule = k == 2              ? Rule::Surface
        : IsRegularEdge(this->Around, edge) ? Rule::RegularEdge
                                            : Rule::Solid;
      return DecideIn(rule, type, DimensionBit(k));
    }
    default:
      break;
  }
  const int inner = place == Place::Type2 ? 2 : 3;
  const unsigned char regional =
    this->Options.EdgeChoices.empty() ? 0 : this->Options.EdgeChoices[edge];
  Decision decision =
    this->DecideJointEdge(edge, type, DimensionBit(k), this->Choice(inner, regional));
  if (decision.Ring == RingKind::InDimensions)
  {
    decision.Dimensions = DimensionBit(k);
  }
  return decision;
}

template <typename Id, typename AnyComplex>
bool StrataDecisions<Id, AnyComplex>::IsInEdgeRing(Id face, const Decision& decision) const
{
  switch (decision.Ring)
  {
    case RingKind::SingularFaces:
      return this->IsSingularFace(face);
    case RingKind::InDimensions:
      return this->Around.FaceDimension(face) & decision.Dimensions;
    case RingKind::BoundaryOfSolid:
      return this->CountSolids(face) == 1;
    case RingKind::Part:
      return this->CountSolids(face) == 0 && this->PartOfFace(face) == decision.Part;
    default:
      return false;
  }
}

/// The part with the smallest id that has exactly two of the triangles at an edge, or -1.
template <typename Id, typename AnyComplex>
int StrataDecisions<Id, AnyComplex>::FindPartAtEdge(Id edge) const
{
  int best = std::numeric_limits<int>::max();
  for (Id face : this->Around.EdgeFaces[edge])
  {
    const int part = this->PartOfFace(face);
    if (part < 0 || part >= best)
    {
      continue;
    }
    int count = 0;
    for (Id other : this->Around.EdgeFaces[edge])
    {
      count += this->CountSolids(other) == 0 && this->PartOfFace(other) == part ? 1 : 0;
    }
    best = count == 2 ? part : best;
  }
  return best == std::numeric_limits<int>::max() ? -1 : best;
}

SUBDIVISION_COMPILE(class StrataDecisions);
template class StrataDecisions<int, CellComplex<int>>;
template class StrataDecisions<long long, CellComplex<long long>>;

}
