// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegularLattice.h
 * Where the tetrahedra of a control level lie as in the regular lattice, of which the limit of the
 * box-spline scheme is a polynomial over each tetrahedron (BoxSplinePatch.h).
 */
#ifndef SubdivisionObjects_RegularLattice_h
#define SubdivisionObjects_RegularLattice_h

#include "Core/Memory/Ids.h"
#include "Core/Solids/Limits/SharpLattice.h"

#include <algorithm>
#include <array>

namespace subdivision
{

template <typename Id>
class RegularLattice
{
public:
  /// Both must outlive this; the lattice is of the level.
  RegularLattice(const Level<Id>& level, const SharpLattice<Id, BoxSplineLattice<Id>>& lattice)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , Lattice(lattice)
  {
  }
  /// Inside which parts of a tetrahedron all is like in the regular lattice, by the corners of the
  /// part, one bit for each.
  std::array<bool, 16> FindRegularParts(Id tet) const
  {
    std::array<bool, 16> parts{};
    parts[15] = true;
    const vtkIdType t = tet;
    for (int i = 0; i < 4; ++i)
    {
      parts[15 - (1 << i)] = this->IsRegularFace(this->Complex.TetFaces[4 * t + i]);
      parts[1 << i] = this->IsRegularVertex(this->Complex.TetVertices[4 * t + i]);
    }
    for (int e = 0; e < 6; ++e)
    {
      const int* ends = tetrahedron::EdgeVertices[e];
      parts[1 << ends[0] | 1 << ends[1]] = this->IsRegularEdge(this->Complex.TetEdges[6 * t + e]);
    }
    return parts;
  }

  /// The vertex with some weights of the corners of a tetrahedron. Where some are negative it lies
  /// in other tetrahedra of the lattice. False if the way to it leads through a face that is not
  /// regular.
  /// Beyond a face of corners A, B and C with the marked edge AB, and with C beside corner D, is a
  /// corner E with D + E = A + B.
  bool Find(Id tet, LatticeWeights weights, LatticeVertex<Id>& vertex) const
  {
    constexpr int most = 16;
    for (int step = 0; step < most; ++step)
    {
      const auto least = std::min_element(weights.begin(), weights.end());
      if (*least >= 0)
      {
        vertex = this->Lattice.GetSmooth().Find(3, tet, weights);
        return true;
      }
      const auto corner = static_cast<int>(least - weights.begin());
      const long long count = -*least;
      const Id face = this->Complex.TetFaces[4 * vtkIdType(tet) + corner];
      if (!this->IsRegularFace(face))
      {
        return false;
      }
      weights[corner] = 0;
      for (int i = 0; i < 4; ++i)
      {
        weights[i] -= i % 2 != corner % 2 ? count : 0;
      }
      const Row<Id> tets = this->Complex.FaceTets[face];
      const Id other = tets.begin()[tets.begin()[0] == tet ? 1 : 0];
      weights = this->Lattice.GetSmooth().LiftToTet(tet, weights, other);
      weights[this->Complex.FaceInTet(other, face)] = count;
      tet = other;
    }
    return false;
  }

private:
  /// Whether both tetrahedra at a face mark the same edge of it.
  bool IsRegularFace(Id face) const
  {
    const Row<Id> tets = this->Complex.FaceTets[face];
    if (tets.size() != 2 || this->Strata.Faces[face].GetRule() != Rule::Solid ||
      this->Lattice.IsSharp(2, face))
    {
      return false;
    }
    const auto getMarked = [&](Id tet)
    { return this->GetMarkedEdge(tet, this->Complex.FaceInTet(tet, face)); };
    return getMarked(tets.begin()[0]) == getMarked(tets.begin()[1]);
  }
  /// Whether an edge is surrounded as in the regular lattice: by four tetrahedra that mark it, or
  /// by six that do not.
  bool IsRegularEdge(Id edge) const
  {
    const Rule rule = this->Strata.Edges[edge].GetRule();
    const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(edge);
    if ((rule != Rule::Solid && rule != Rule::RegularEdge) || this->Lattice.IsSharp(1, edge) ||
      !std::all_of(faces.begin(), faces.end(),
        [this](Id face) { return face >= 0 && this->IsRegularFace(face); }))
    {
      return false;
    }
    const Id tet = this->Complex.FaceTets[faces.begin()[0]].begin()[0];
    const bool isMarked = tetrahedron::IsMarked(this->Complex.EdgeInTet(tet, edge));
    return faces.size() == (isMarked ? 4 : 6);
  }
  /// A sphere of 24 triangles, each with one vertex of a marked edge, is a sphere of the lattice.
  bool IsRegularVertex(Id vertex) const
  {
    constexpr int neighbours = 14;
    const Row<Id> edges = this->Strata.VertexRings.GetCarriers(vertex);
    return this->Strata.Vertices[vertex].GetRule() == Rule::Solid && edges.size() == neighbours &&
      !this->Lattice.IsSharp(0, vertex) &&
      std::all_of(edges.begin(), edges.end(),
        [this](Id edge) { return edge >= 0 && this->IsRegularEdge(edge); });
  }

  /// The marked edge of a tetrahedron that lies in one of its faces.
  Id GetMarkedEdge(Id tet, int face) const
  {
    return this->Complex.TetEdges[6 * vtkIdType(tet) + tetrahedron::MarkedEdges[face % 2 ? 0 : 1]];
  }

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const SharpLattice<Id, BoxSplineLattice<Id>>& Lattice;
};

}

#endif
