// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidsAtFaces.h
 * The control tetrahedra in which the solids at the faces of a level lie.
 */
#ifndef SubdivisionObjects_SolidsAtFaces_h
#define SubdivisionObjects_SolidsAtFaces_h

#include "Core/Solids/Limits/ShadingStars.h"
#include "Core/Solids/Scheme/SolidScheme.h"

namespace subdivision
{

template <typename Scheme>
class SolidsAtFaces
{
public:
  using Id = typename Scheme::Id;

  /// Both must live as long. A skin has its solids in `solids`.
  SolidsAtFaces(const typename Scheme::Level& level, const ControlSolids& solids)
    : Here(level)
    , Solids(solids)
    , Tets(level, solids.Steps)
  {
  }
  vtkIdType Count(Id face) const
  {
    return this->Solids.OfSkin ? this->GetSides(face).size()
                               : this->Here.Complex.FaceTets[face].size();
  }
  /// Passes the side (LimitTangents::Sides) of a face for each of its solids, where its vertices
  /// are seen in the order of `triangle`.
  template <typename Act>
  void ForSides(Id face, const Id (&triangle)[3], const Act& act) const
  {
    if (this->Solids.OfSkin)
    {
      const auto& complex = this->Here.Complex;
      const bool isTurned = complex.VertexInFace(face, triangle[1]) !=
        (complex.VertexInFace(face, triangle[0]) + 1) % 3;
      for (const vtkIdType side : this->GetSides(face))
      {
        act(isTurned ? side ^ 1 : side);
      }
      return;
    }
    for (const Id cell : this->Here.Complex.FaceTets[face])
    {
      const vtkIdType tet = this->Tets.Find(cell);
      const vtkIdType number = this->Solids.Numbers.empty() ? tet : this->Solids.Numbers[tet];
      act(2 * number + (Scheme::GetTurn(this->Here, cell, triangle) < 0 ? 1 : 0));
    }
  }

private:
  Row<vtkIdType> GetSides(Id face) const
  {
    return (*this->Solids.OfSkin)[static_cast<vtkIdType>(face) >> 2 * this->Solids.SkinSteps];
  }

  const typename Scheme::Level& Here;
  const ControlSolids& Solids;
  const typename Scheme::ControlTets Tets;
};

}

#endif
