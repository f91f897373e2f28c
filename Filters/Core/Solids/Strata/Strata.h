// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Strata.h
 * Which rule does each vertex and edge follow, and with which ring (Mathematics 3, 4, 6).
 *
 * BuildStrata examines links once, on the control mesh. Children inherit strata (Refinement.h): a
 * child inside an edge or a face has the stratum of that edge or face, a child inside a tetrahedron
 * follows the rule of solids.
 */
#ifndef SubdivisionObjects_Strata_h
#define SubdivisionObjects_Strata_h

#include "Core/Rules/LoopWeights.h"
#include "Core/Rules/Rule.h"
#include "Core/Rules/Stratum.h"
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Solids/Strata/SectorEdges.h"

#include <vector>

namespace subdivision
{

/// Singular simplices: a flag for each vertex, edge and face; an empty buffer means none.
struct SingularSimplices
{
  Buffer<unsigned char> Vertices;
  Buffer<unsigned char> Edges;
  Buffer<unsigned char> Faces;
};

struct StrataOptions
{
  JointRule Type1 = JointRule::Blend;
  JointRule Type2 = JointRule::Blend;
  JointRule Type3 = JointRule::Blend;
  /// Whether the end of a crease is a dart, that is, follows the rule that it would have without
  /// the crease. Otherwise it is a corner.
  bool DartEnds = false;
  LoopWeights Weights = LoopWeights::Warren;
  /// Whether edges that end on a curve or at a corner follow the rules of SectorEdges.h there.
  bool ModifiedBoundary = false;
  /// For these rules the angle of each sector at a corner, by vertex, in radians; negative or not a
  /// number: the plain rule; may be empty.
  Buffer<double> CornerAngles;
  /// The part of each maximal edge and face for the choice FollowPart, negative for none; may be
  /// empty.
  Buffer<int> EdgeParts;
  Buffer<int> FaceParts;
  /// 1 + the JointRule that replaces the three choices above at this vertex or edge, or 0 to keep
  /// them; may be empty.
  Buffer<unsigned char> VertexChoices;
  Buffer<unsigned char> EdgeChoices;
  Buffer<unsigned char> FaceChoices; ///< for edges that a step makes inside faces
};

/// The rings of all vertices or all edges of a level, as compressed rows.
template <typename Id>
struct Rings
{
  Buffer<Id> Offsets;
  /// Vertices.
  Buffer<Id> Members;
  /// The carrier of each member: in the ring of a vertex the edge to the member; in the ring of an
  /// edge the face that edge and member span, or -1 if there is none, which occurs at Blend edges
  /// of the control mesh. Tet/oct levels also have octahedra here (TetOctComplex.h). Empty on a
  /// level that is not refined further.
  Buffer<Id> Carriers;

  vtkIdType GetSize(vtkIdType i) const { return this->Offsets[i + 1] - this->Offsets[i]; }
  Row<Id> GetMembers(vtkIdType i) const { return this->GetRow(this->Members, i); }
  Row<Id> GetCarriers(vtkIdType i) const { return this->GetRow(this->Carriers, i); }
  std::size_t GetMemorySize() const
  {
    return this->Offsets.GetMemorySize() + this->Members.GetMemorySize() +
      this->Carriers.GetMemorySize();
  }

private:
  Row<Id> GetRow(const Buffer<Id>& items, vtkIdType i) const
  {
    return { items.data() + this->Offsets[i], items.data() + this->Offsets[i + 1] };
  }
};

template <typename Id>
struct Strata
{
  Buffer<Stratum> Vertices;
  Buffer<Stratum> Edges;
  /// The rule of the edges that a step makes inside a face: Surface, Solid (some of these edges are
  /// then regular), Blend, or Curve, which means that each such edge is sharp. Empty on a level
  /// that is not refined further.
  Buffer<Stratum> Faces;
  Rings<Id> VertexRings;
  Rings<Id> EdgeRings;
  LoopWeights Weights = LoopWeights::Warren; ///< of vertices with d = 2
  bool ModifiedBoundary = false;
  std::vector<SectorEdge<Id>> Sectors; ///< the edges whose rule that changes

  /// Takes the choices that are the same on all levels and in all parts.
  void TakeChoices(const Strata& other)
  {
    this->Weights = other.Weights;
    this->ModifiedBoundary = other.ModifiedBoundary;
  }
};

template <typename Id>
Strata<Id> BuildStrata(const SimplicialComplex<Id>& complex, const SingularSimplices& singular,
  const StrataOptions& options);

}

#endif
