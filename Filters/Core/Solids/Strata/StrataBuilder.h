// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StrataBuilder.h
 * The decisions behind Strata.h: edges first (StrataEdges.cxx), then vertices (StrataVertices.cxx),
 * and at last edges of sectors (StrataSectors.cxx).
 */
#ifndef SubdivisionObjects_StrataBuilder_h
#define SubdivisionObjects_StrataBuilder_h

#include "Core/Cells/CellComplex.h"
#include "Core/Solids/Complex/Links.h"
#include "Core/Solids/Strata/Strata.h"

namespace subdivision
{

/// Which edges at a vertex, or faces at an edge, give the members of its ring. Edges of the kinds
/// None, Creases, SharpJoints and BoundaryOfSurface have d = 1 and an empty ring.
enum class RingKind : unsigned char
{
  None,
  Creases,         ///< edges with d = 1 because they or triangles at them are singular
  SingularFaces,   ///< singular faces, and the edges on them
  SharpJoints,     ///< joint edges with d = 1 by the choice Sharp
  InDimensions,    ///< all edges or faces in the C_k of Decision::Dimensions
  BoundaryOfSolid, ///< boundary faces of C_3 and their edges
  BoundaryOfSurface,
  Part ///< lines or triangles of Decision::Part
};

struct Decision
{
  Stratum Result;
  RingKind Ring;
  unsigned char Dimensions;
  int Part;
};

constexpr Decision Decide(Rule rule, int type, RingKind ring)
{
  return { Stratum(rule, type), ring, {}, {} };
}

/// With all neighbours in the C_k of some dimensions.
constexpr Decision DecideIn(Rule rule, int type, unsigned char dimensions)
{
  return { Stratum(rule, type), RingKind::InDimensions, dimensions, {} };
}

constexpr Rule RuleOfDimension(int d)
{
  return static_cast<Rule>(d);
}

/// The decisions on a SimplicialComplex or a CellComplex.
template <typename Id, typename AnyComplex = SimplicialComplex<Id>>
class StrataDecisions
{
public:
  StrataDecisions(
    const AnyComplex& complex, const SingularSimplices& singular, const StrataOptions& options)
    : Complex(complex)
    , Singular(singular)
    , Options(options)
    , Around(complex)
  {
  }

  /// Decides all edges, then all vertices; `edges` and `vertices` have their sizes.
  void DecideAll(Buffer<Decision>& edges, Buffer<Decision>& vertices);
  Stratum DecideFace(Id face) const;
  bool IsSingularFace(Id face) const
  {
    return !this->Singular.Faces.empty() && this->Singular.Faces[face];
  }
  bool IsInEdgeRing(Id face, const Decision& decision) const;
  bool IsInVertexRing(Id edge, const Decision& decision) const;
  /// For each Blend edge the common neighbours of its ends that lie on no triangle with it; empty
  /// where no edge has one.
  std::vector<std::vector<Id>> CollectReliefs(const Buffer<Decision>& edges) const;
  /// The edges of sectors (StrataSectors.cxx).
  std::vector<SectorEdge<Id>> CollectSectors(
    const Buffer<Decision>& edges, const Buffer<Decision>& vertices) const;
  const Links<Id, AnyComplex>& GetLinks() const { return this->Around; }

protected:
  // Edges.
  Decision DecideEdge(Id edge) const;
  Decision DecideJointEdge(Id edge, int type, unsigned char dimensions, JointRule rule) const;
  Decision DecideEdgeIn(Id edge, int k, Place place, int type) const;
  // Vertices.
  Decision DecideVertex(Id vertex) const;
  bool DecideSingularVertex(Id vertex, int type, Decision& decision) const;
  Decision DecideJointVertex(Id vertex, int type, unsigned char dimensions, JointRule rule) const;
  Decision DecideVertexIn(Id vertex, int k, Place place, int type) const;
  bool LiesOnBoundaryCurve(Id vertex) const;
  int FindPartAtVertex(Id vertex, int k) const;
  int FindPartAtEdge(Id edge) const;
  bool WalkSector(const Buffer<Decision>& edges, Id vertex, Id edge, Id face, std::vector<Id>& walk,
    std::size_t& quads) const;
  void AppendSectors(Id vertex, const Buffer<Decision>& edges, const Buffer<Decision>& vertices,
    std::vector<SectorEdge<Id>>& sectors) const;
  // Shared.
  int TypeOf(unsigned char dimensions, const Place places[4]) const;
  JointRule Choice(int type, unsigned char regional) const;
  int CountSingularFaces(Id edge) const;
  int PartOfEdge(Id e) const
  {
    return this->Options.EdgeParts.empty() ? -1 : this->Options.EdgeParts[e];
  }
  int PartOfFace(Id f) const
  {
    return this->Options.FaceParts.empty() ? -1 : this->Options.FaceParts[f];
  }
  vtkIdType CountSolids(Id face) const { return GetSolidsAt(this->Complex, face).size(); }
  bool HasSingular() const
  {
    return !this->Singular.Vertices.empty() || !this->Singular.Edges.empty() ||
      !this->Singular.Faces.empty();
  }
  bool IsCrease(Id edge) const { return this->EdgeMarks[edge] & 1; }
  bool IsSharpJoint(Id edge) const { return this->EdgeMarks[edge] & 2; }
  void CollectRelief(Id edge, const Decision& decision, std::vector<Id>& relief) const;

  const AnyComplex& Complex;
  const SingularSimplices& Singular;
  const StrataOptions& Options;
  const Links<Id, AnyComplex> Around;
  Buffer<unsigned char> EdgeMarks;
};

/// Whether an interior edge is one of the box spline's in the direction of valence 4: it has
/// exactly four tetrahedra, and is marked in all four.
template <typename Id>
bool IsRegularEdge(const Links<Id>& links, Id edge);
template <typename Id>
bool IsRegularEdge(const Links<Id, CellComplex<Id>>&, Id)
{
  return false;
}

template <typename Id>
class StrataBuilder : public StrataDecisions<Id>
{
public:
  using StrataDecisions<Id>::StrataDecisions;

  Strata<Id> Build();
};

}

#endif
