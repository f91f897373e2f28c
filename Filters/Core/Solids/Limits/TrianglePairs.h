// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TrianglePairs.h
 * Which triangles of surfaces lie at sharp edges, and which of them continue each other.
 */
#ifndef SubdivisionObjects_TrianglePairs_h
#define SubdivisionObjects_TrianglePairs_h

#include "Core/Memory/Loops.h"
#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/Strata/Strata.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// The triangles of surfaces that continue each other across edges.
template <typename Scheme>
class TrianglePairs
{
public:
  using Id = typename Scheme::Id;

  explicit TrianglePairs(const typename Scheme::Level& level)
    : Complex(level.Complex)
    , Strata(level.Strata)
  {
    this->FindFacesAtCurves();
  }
  Row<Id> GetFacesAtCurve(Id edge) const { return this->FacesAtCurves[edge]; }
  Rule RuleOf(Id edge) const { return this->Strata.Edges[edge].GetRule(); }
  /// Links for FindSides, over edges with an end that is sure; no flags: all are.
  template <typename Visit>
  void ForLinks(Id face, const std::vector<char>& isSure, const Visit& visit) const
  {
    for (int k = 0; k < 3 && this->Complex.FaceTets[face].size() == 0; ++k)
    {
      Id faces[2];
      const Id edge = this->Complex.FaceEdges[3 * vtkIdType(face) + k];
      const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge);
      if ((isSure.empty() || isSure[ends[0]] || isSure[ends[1]]) && this->FindPair(edge, faces))
      {
        visit(vtkIdType(faces[faces[0] == face ? 1 : 0]), this->Contradict(edge, faces));
      }
    }
  }

private:
  void FindFacesAtCurves()
  {
    const vtkIdType edges = this->Complex.NumberOfEdges;
    this->FacesAtCurves.Offsets = Buffer<Id>(edges + 1, 0);
    auto forPairs = [&](const auto& act)
    {
      ForEachInTurn(this->Complex.NumberOfFaces,
        [&](vtkIdType f)
        {
          const Id face = static_cast<Id>(f);
          for (int k = 0; k < 3 && this->Complex.FaceTets[face].size() < 2; ++k)
          {
            const Id edge = this->Complex.FaceEdges[3 * f + k];
            if (this->RuleOf(edge) == Rule::Curve)
            {
              act(edge, face);
            }
          }
        });
    };
    forPairs([&](Id edge, Id) { ++this->FacesAtCurves.Offsets[edge]; });
    CountsToOffsets(this->FacesAtCurves.Offsets);
    this->FacesAtCurves.Items = Buffer<Id>(this->FacesAtCurves.Offsets[edges]);
    std::vector<Id> next(this->FacesAtCurves.Offsets.begin(), this->FacesAtCurves.Offsets.end());
    forPairs([&](Id edge, Id face) { this->FacesAtCurves.Items[next[edge]++] = face; });
  }
  /// Finds the two maximal triangles that continue each other across an edge, smooth or crease.
  /// Returns false if there are not exactly two.
  bool FindPair(Id edge, Id (&faces)[2]) const
  {
    const Row<Id> row = this->RuleOf(edge) == Rule::Surface
      ? this->Strata.EdgeRings.GetCarriers(edge)
      : this->FacesAtCurves[edge];
    if (row.size() != 2)
    {
      return false;
    }
    std::copy(row.begin(), row.end(), faces);
    return faces[0] >= 0 && faces[1] >= 0 && this->Complex.FaceTets[faces[0]].size() == 0 &&
      this->Complex.FaceTets[faces[1]].size() == 0;
  }
  /// Whether both triangles run along their edge in the same direction.
  bool Contradict(Id edge, const Id (&faces)[2]) const
  {
    const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge);
    auto runsAlong = [&](Id face)
    {
      return (this->Complex.VertexInFace(face, ends[0]) + 1) % 3 ==
        this->Complex.VertexInFace(face, ends[1]);
    };
    return runsAlong(faces[0]) == runsAlong(faces[1]);
  }

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  Rows<Id> FacesAtCurves; ///< the faces of less than two tetrahedra at each edge with d = 1
};

}

#endif
