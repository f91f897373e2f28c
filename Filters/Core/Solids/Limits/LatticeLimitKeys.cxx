// SPDX-License-Identifier: BSD-3-Clause
// Which vertices of a BoxSplineLattice have equal weights of limits.
#include "Core/Solids/Limits/BoxSplineLattice.h"

#include "Core/Memory/Ids.h"

#include <algorithm>

namespace subdivision
{

/// Sets the key to what the weights of a limit depend on, and the order of its ring. All tetrahedra
/// are alike.
template <typename Id>
void BoxSplineLattice<Id>::SetKey(const LatticeVertex<Id>& vertex)
{
  this->Key = { vertex.Dimension };
  const Id simplex = vertex.Simplex;
  if (vertex.Dimension == 0)
  {
    AppendId(simplex, this->Key);
  }
  else if (vertex.Dimension == 1)
  {
    this->AppendEdge(simplex);
  }
  else if (vertex.Dimension == 2)
  {
    this->Key.push_back(static_cast<int>(this->Strata.Faces[simplex].GetRule()));
    for (const Id tet : this->Complex.FaceTets[simplex])
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Key.push_back(this->Complex.VertexInTet(tet, this->GetCorners(2, simplex)[k]));
      }
    }
  }
}

/// The faces around an edge, and of each tetrahedron at them which edge it marks, and whether its
/// diagonal comes behind the face.
template <typename Id>
void BoxSplineLattice<Id>::AppendEdge(Id edge)
{
  this->Key.push_back(static_cast<int>(this->Strata.Edges[edge].GetRule()));
  const Id* ends = this->GetCorners(1, edge);
  this->Tets.clear();
  for (const Id face : this->Strata.EdgeRings.GetCarriers(edge))
  {
    if (face < 0)
    {
      this->Key.push_back(-1);
      continue;
    }
    this->Key.push_back(static_cast<int>(this->Strata.Faces[face].GetRule()));
    const int places[2] = { this->Complex.VertexInFace(face, ends[0]),
      this->Complex.VertexInFace(face, ends[1]) };
    this->Key.push_back(places[0] < places[1] ? 1 : 0);
    for (const Id tet : this->Complex.FaceTets[face])
    {
      const auto found = std::find(this->Tets.begin(), this->Tets.end(), tet);
      const auto number = static_cast<int>(found - this->Tets.begin());
      found == this->Tets.end() ? this->Tets.push_back(tet) : void();
      const int apex = this->Complex.FaceInTet(tet, face);
      const int first = this->Complex.VertexInTet(tet, ends[0]);
      const int second = this->Complex.VertexInTet(tet, ends[1]);
      const int third = 6 - first - second - apex;
      const auto isMarked = [first](int other)
      { return tetrahedron::IsMarked(tetrahedron::EdgeOf[first][other]); };
      const int kind = isMarked(third) ? 0 : isMarked(apex) ? 1 : apex > third ? 2 : 3;
      this->Key.push_back(-2 - 4 * number - kind);
    }
  }
}

SUBDIVISION_COMPILE(class BoxSplineLattice);

}
