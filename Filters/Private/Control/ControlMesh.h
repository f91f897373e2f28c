// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ControlMesh.h
 * Reads the mesh that a filter subdivides: the simplices of the input or, if an earlier filter of
 * this project made the input, the control mesh of that filter.
 */
#ifndef SubdivisionObjects_ControlMesh_h
#define SubdivisionObjects_ControlMesh_h

#include "Private/Control/Stamp.h"
#include "Private/Reading/CellsToSimplices.h"
#include "Private/Run/Features.h"
#include "Private/Run/Marks.h"

#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

struct ControlMesh
{
  SimplicesOfCells Cells;       ///< the input's simplices
  bool IsOfOtherScheme = false; ///< made by an earlier filter, but not by this scheme
  bool IsStamped =
    false; ///< made by an earlier filter: tetrahedra keep their order, nothing is derived
  int MadeLevels = 0;   ///< steps that earlier filters made; this filter repeats them on ids
  FeatureValues Values; ///< of the control simplices
  /// Singular simplices among them that are marked, or that an earlier filter derived.
  SharpTuples Derived;
  /// Control simplices of negative and of no volume, as FindInvertedTets gives them; first the ones
  /// that an earlier filter found.
  std::vector<vtkIdType> Inverted;
  std::vector<vtkIdType> GlobalIds; ///< of the first control points; empty: the index is used

  /// The control simplices.
  const SimplexList& GetControl() const
  {
    return this->MadeLevels > 0 ? this->Above : this->Cells.Simplices;
  }
  const vtkIdType* GetGlobalIds() const
  {
    return this->GlobalIds.empty() ? nullptr : this->GlobalIds.data();
  }

  SimplexList Above; ///< the control simplices where MadeLevels > 0
  /// Warnings for the user. Until it is known whether the stamp is true, they are not told.
  std::vector<std::string> Warnings;
};

/// Reads an input. `trustStamp`: false if its stamp has turned out to be wrong, which
/// BuildControlComplex finds. A stamp of another scheme than `scheme` never leads to a control
/// mesh. `ids`: as in CellsToSimplices.
ControlMesh ReadControlMesh(vtkPointSet* input, bool trustStamp, const FeatureOptions& features,
  StampScheme scheme = StampScheme::BoxSpline, PlainIds ids = PlainIds::Copied);

}

#endif
