// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeformationOptions.h
 * The options of vtkSubdivisionDeformation.
 */
#ifndef SubdivisionObjects_DeformationOptions_h
#define SubdivisionObjects_DeformationOptions_h

#include "Core/Surfaces/Steps/SurfaceSchemes.h"
#include "Private/Control/Stamp.h"
#include "Private/Run/RunOptions.h"

namespace subdivision
{

enum class OutsideRule
{
  Leave,
  Nearest,
  Error
};

struct DeformationOptions : RunOptions
{
  int Levels = 2;
  StampScheme Scheme = StampScheme::BoxSpline;               ///< of solids
  bool KeepsCellTypes = false;                               ///< no cell is cut; Scheme is not read
  SurfaceSchemeKind SurfaceScheme = SurfaceSchemeKind::Loop; ///< of meshes without solids
  OutsideRule Outside = OutsideRule::Leave;
  bool OnLimit = false; ///< points are bound to places of the limit; there are no levels then
  bool TransformVectors = true;
};

}

#endif
