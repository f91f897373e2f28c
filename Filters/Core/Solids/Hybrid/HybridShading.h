// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridShading.h
 * Normals for shading at vertices of a level that have no tangents (ShadingStars.h).
 */
#ifndef SubdivisionObjects_HybridShading_h
#define SubdivisionObjects_HybridShading_h

#include "Core/Cells/CellSigns.h"
#include "Core/Solids/Hybrid/HybridLocal.h"
#include "Core/Solids/Limits/ShadingStars.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// The cell whose row has an entry.
template <typename Id>
vtkIdType FindOwner(const Rows<Id>& rows, Id entry)
{
  return std::upper_bound(rows.Offsets.begin(), rows.Offsets.end(), entry) - rows.Offsets.begin() -
    1;
}

/// The cells that faces are, or are sides of, and the control cells of these. On a skin
/// (HybridSkin.h) a polygon stands for the side of a solid: ~side, of its own order, for the
/// control cell.
template <typename Id>
class FacesOfControl
{
public:
  FacesOfControl(const CellComplex<Id>& complex, const std::vector<vtkIdType>& controls)
    : Complex(complex)
    , Controls(controls)
  {
  }
  /// The first cell at a face.
  vtkIdType GetCell(Id face) const
  {
    return FindOwner(this->Complex.CellFaces, this->Complex.FaceFirsts[face]);
  }
  vtkIdType GetControl(Id face) const
  {
    return this->Controls[static_cast<std::size_t>(this->GetCell(face))];
  }
  /// Whether a face goes on from one vertex to the next.
  bool GoesOn(Id face, Id vertex, Id next) const
  {
    const Row<Id> corners = this->Complex.GetVertices(face);
    const auto at = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
    return corners.begin()[(at + 1) % corners.size()] == next;
  }
  /// Whether a face is the side of one solid.
  bool IsSide(Id face) const
  {
    return this->Complex.FaceSolids[face].size() == 1 || this->GetControl(face) < 0;
  }
  /// That side (LimitTangents::Sides), if the face goes on from a vertex to another.
  vtkIdType GetSide(Id face, Id vertex, Id next) const
  {
    if (this->Complex.FaceSolids[face].size() == 0)
    {
      return ~this->GetControl(face) ^ (this->GoesOn(face, vertex, next) ? 0 : 1);
    }
    const Id cell = *this->Complex.FaceSolids[face].begin();
    const CellTable& table = this->Complex.Cells.GetTable(cell);
    const Id* faces = this->Complex.CellFaces[cell].begin();
    const auto local =
      static_cast<std::size_t>(std::find(faces, faces + table.Faces.size(), face) - faces);
    const Id* corners = this->Complex.Cells.GetCorners(cell);
    const std::vector<unsigned char>& cycle = table.Faces[local];
    const auto at = std::find_if(cycle.begin(), cycle.end(),
                      [&](unsigned char corner) { return corners[corner] == vertex; }) -
      cycle.begin();
    const bool goesOn = corners[cycle[(static_cast<std::size_t>(at) + 1) % cycle.size()]] == next;
    const double sign = GetFaceSigns(this->Complex.Cells.Shapes[cell])[local];
    return 2 * this->Controls[static_cast<std::size_t>(cell)] + ((sign > 0.) == goesOn ? 0 : 1);
  }

private:
  const CellComplex<Id>& Complex;
  const std::vector<vtkIdType>& Controls;
};

/// The stars of vertices that are flagged, and lie at faces of surfaces or outsides, lines or
/// vertex cells. The level is `made` steps after the control level.
template <typename Id>
ShadingStars<Id> BuildHybridShading(const HybridLevel<Id>& level,
  const std::vector<vtkIdType>& controls, const Buffer<unsigned char>& missing, int made);

}

#endif
