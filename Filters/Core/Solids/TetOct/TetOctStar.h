// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctStar.h
 * The tet/oct scheme for LevelStar (LevelStar.h): its masks, and the members of rings that lie
 * opposite in octahedra.
 */
#ifndef SubdivisionObjects_TetOctStar_h
#define SubdivisionObjects_TetOctStar_h

#include "Core/Solids/TetOct/TetOctSplit.h"

namespace subdivision
{

template <typename Id>
class TetOctStar
{
public:
  explicit TetOctStar(const TetOctLevel<Id>& level)
    : Here(level)
  {
  }

  const RingMasks& GetMasks() const { return TetOctMasks(this->Here.Strata.Weights); }
  vtkIdType CountSolids(Id vertex, Rule rule, vtkIdType ringSize) const
  {
    return CountOpposites(rule, ringSize, this->IsControl(vertex));
  }
  vtkIdType CountFaces(Rule rule, vtkIdType ringSize) const
  {
    return rule == Rule::RegularEdge ? RegularFaces : ringSize;
  }
  Id GetOppositeEnd(Id oct, Id vertex) const
  {
    const int own = VertexInOct(this->Here, oct, vertex);
    return this->Here.OctVertices[6 * vtkIdType(oct) + octahedron::Opposite(own)];
  }
  template <typename Add>
  void ForEdgesInSolid(Id oct, Id vertex, const Add& add) const
  {
    const int own = VertexInOct(this->Here, oct, vertex);
    for (int other = 0; other < 6; ++other)
    {
      if (other / 2 != own / 2)
      {
        add(this->EdgeInOct(oct, own, other));
      }
    }
  }
  Id GetEdgeBeyond(Id oct, Id vertex, Id far) const
  {
    return this->EdgeInOct(oct, VertexInOct(this->Here, oct, vertex),
      octahedron::Opposite(VertexInOct(this->Here, oct, far)));
  }
  bool HasSpokes(Id vertex, Rule rule) const
  {
    return this->IsControl(vertex) && rule == Rule::Solid;
  }

private:
  bool IsControl(Id vertex) const { return vertex < this->Here.NumberOfControlVertices; }
  Id EdgeInOct(Id oct, int a, int b) const
  {
    return this->Here.OctEdges[12 * vtkIdType(oct) + octahedron::EdgeOf[a][b]];
  }

  const TetOctLevel<Id>& Here;
};

}

#endif
