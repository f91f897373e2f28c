// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoreReference.h
 * Mathematics 2 to 5 written down once more, slowly and by definition: sets of vertex sets, links
 * as sets, default options. What Core computes must equal this.
 */
#ifndef SubdivisionObjects_CoreReference_h
#define SubdivisionObjects_CoreReference_h

#include "CoreTools.h"

namespace coretest
{

using Sets = std::set<Tuple>;

inline bool Contains(const Tuple& outer, const Tuple& inner)
{
  return std::includes(outer.begin(), outer.end(), inner.begin(), inner.end());
}

Tuple Without(const Tuple& outer, const Tuple& inner);

/// All non-empty faces of a simplex, itself included.
Sets FacesOf(const Tuple& simplex);

/// What a vertex or an edge must follow.
struct Expected
{
  Rule FollowedRule = Rule::Corner;
  int Type = 0;
  Tuple Ring;
};

enum class Shape
{
  Absent,
  Interior,
  Boundary,
  Type2,
  Type3
};

class Reference
{
public:
  explicit Reference(const SimplexList& cells, const std::set<Tuple>& singular = {});

  std::vector<Expected> Vertices;
  std::map<Tuple, Expected> Edges;

  /// The row of a vertex or edge, by the table of Mathematics 5.
  std::vector<double> MakeRow(const Tuple& simplex, const Expected& expected) const;

private:
  Sets Link(const Tuple& simplex, int k) const;
  Shape Place(const Tuple& simplex, int k) const;
  std::vector<int> DimensionsOf(const Tuple& simplex) const;
  int TypeOf(const Tuple& simplex) const;
  Expected DecideEdge(const Tuple& edge) const;
  Expected DecideVertex(vtkIdType vertex) const;
  bool IsRegular(const Tuple& edge) const;
  /// Singular faces around a simplex.
  Sets SingularFacesAt(const Tuple& simplex) const;
  /// Triangles of exactly one maximal tetrahedron that hold a simplex.
  Sets BoundaryTrianglesAt(const Tuple& simplex) const;
  static int CountPieces(const Sets& simplices);
  static Shape ShapeOfGraph(const Sets& arcs);
  static Shape ShapeOfSurface(const Sets& triangles);
  static Tuple VerticesOf(const Sets& simplices);

  Sets Closure;
  Sets Maximal[4];
  std::map<Tuple, Sets> Marked; ///< the marked edges of each tetrahedron
  std::set<Tuple> Singular;
  std::map<vtkIdType, std::set<vtkIdType>> Neighbours;
  std::map<vtkIdType, Sets> MaximalAt[4];
  vtkIdType NumberOfPoints = 0;
};

}

#endif
