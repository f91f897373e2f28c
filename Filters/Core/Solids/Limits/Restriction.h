// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Restriction.h
 * A part of a level as a level of its own, to be refined where detail is needed.
 */
#ifndef SubdivisionObjects_Restriction_h
#define SubdivisionObjects_Restriction_h

#include "Core/Memory/Selection.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <memory>

namespace subdivision
{

/// Flags vertices, edges and faces of a level.
struct PartsOfLevel
{
  Buffer<unsigned char> Vertices;
  Buffer<unsigned char> Edges;
  Buffer<unsigned char> Faces;
};

/**
 * Chooses the part of a level of any scheme: all simplices and other solids at some vertices, and
 * their faces. They keep their order.
 *
 * What lies at none of these vertices is at the border, where something may be missing. There
 * vertices are corners, edges creases, and faces a boundary, all without rings: rows made from them
 * are not those of the level, but no step looks for what is not there.
 */
template <typename LevelType>
class Restriction
{
public:
  using Id = typename LevelType::IdType;

  /// `level` was made with Depth::ForRefinement; `at`: whether all that lies at a vertex is kept.
  /// Both must outlive the restriction.
  Restriction(const LevelType& level, const Buffer<unsigned char>& at);

  /// Chooses these parts alone, which have all that their rules read, and no solids.
  Restriction(const LevelType& level, const PartsOfLevel& kept);

  /// The part; none of its cells counts as a cell of the output.
  LevelType Restrict() const;
  /// Other strata of the level, and the numbers of their spokes, in the part.
  Strata<Id> Restrict(const Strata<Id>& strata) const;
  std::shared_ptr<const Buffer<Id>> RestrictSpokes(
    const Strata<Id>& strata, const std::shared_ptr<const Buffer<Id>>& spokes) const;

  /// The number in the part of each vertex of the level (-1 if it is not kept), and the inverse.
  const Buffer<Id>& GetNewVertices() const { return this->Vertices.New; }
  const Buffer<Id>& GetOldVertices() const { return this->Vertices.Old; }
  /// The same for edges, faces and tetrahedra of the level.
  const Buffer<Id>& GetNewEdges() const { return this->Edges.New; }
  const Buffer<Id>& GetNewFaces() const { return this->Faces.New; }
  const Buffer<Id>& GetNewTets() const { return this->Tets.New; }
  /// The edges, faces and octahedra of the level that the part has.
  const Buffer<Id>& GetOldEdges() const { return this->Edges.Old; }
  const Buffer<Id>& GetOldFaces() const { return this->Faces.Old; }
  const Buffer<Id>& GetOldOcts() const { return this->Octs.Old; }

private:
  Buffer<Stratum> Restrict(const Buffer<Stratum>& strata, const Selection<Id>& owners,
    const Buffer<unsigned char>& isInside, Rule atBorder) const;
  template <typename Act>
  void ForEntries(const Rings<Id>& rings, vtkIdType owner, vtkIdType firstSolid,
    const Selection<Id>& carriers, const Act& act) const;
  template <typename FirstSolid>
  Rings<Id> Restrict(const Rings<Id>& rings, const Selection<Id>& owners,
    const Buffer<unsigned char>& isInside, const Selection<Id>& carriers,
    const FirstSolid& firstSolid) const;
  Rows<Id> RestrictFaceCells() const;

  const LevelType& Whole;
  const Buffer<unsigned char>& At;
  const typename SchemeOf<LevelType>::Star Solids;
  Selection<Id> Vertices;
  Selection<Id> Edges;
  Selection<Id> Faces;
  Selection<Id> Tets;
  Selection<Id> Octs;
  Buffer<unsigned char> EdgesInside; ///< whether all that lies at an edge of the level is kept
  Buffer<unsigned char> FacesInside;
};

}

#endif
