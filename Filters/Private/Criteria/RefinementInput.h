// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinementInput.h
 * Reads the criteria of a filter from its settings and its arrays.
 */
#ifndef SubdivisionObjects_RefinementInput_h
#define SubdivisionObjects_RefinementInput_h

#include "Private/Criteria/RefinementCriteria.h"

class vtkAlgorithm;

namespace subdivision
{

/// The options that both refining filters have by these names.
struct RefinementSettings
{
  bool RefineByAttributeError;
  double AttributeTolerance;
  bool AttributeErrorOfLimit;
  bool RefineByArrayRange;
  const double* ArrayRange;
  bool RefineByEdgeLength;
  double MaximumEdgeLength;
  bool RefineByGeometricError;
  double GeometricTolerance;
  bool RelativeTolerance;
  bool RefineByCurvature;
  double MaximumAngle; ///< in degrees
  bool RefineByWantedLevel;
  int MaximumLevel;
  bool InterpolateIntegers;
  /// Whether there are criteria beside these.
  bool HasOthers;
  /// The indices of their arrays in SetInputArrayToProcess.
  int AttributeIndex;
  int RangeIndex;
  int LevelIndex;
};

/// The options of a filter. Its arrays have the indices from `firstIndex` on: for attributes, the
/// range, wanted levels. The settings point into the filter.
template <typename Filter>
RefinementSettings GetRefinementSettings(Filter* filter, int firstIndex, bool hasOthers)
{
  RefinementSettings settings;
  settings.RefineByAttributeError = filter->GetRefineByAttributeError();
  settings.AttributeTolerance = filter->GetAttributeTolerance();
  settings.AttributeErrorOfLimit = filter->GetAttributeErrorKind() == Filter::LIMIT_DIFFERENCE;
  settings.RefineByArrayRange = filter->GetRefineByArrayRange();
  settings.ArrayRange = filter->GetArrayRange();
  settings.RefineByEdgeLength = filter->GetRefineByEdgeLength();
  settings.MaximumEdgeLength = filter->GetMaximumEdgeLength();
  settings.RefineByGeometricError = filter->GetRefineByGeometricError();
  settings.GeometricTolerance = filter->GetGeometricTolerance();
  settings.RelativeTolerance = filter->GetRelativeTolerance();
  settings.RefineByCurvature = filter->GetRefineByCurvature();
  settings.MaximumAngle = filter->GetMaximumAngle();
  settings.RefineByWantedLevel = filter->GetRefineByWantedLevel();
  settings.MaximumLevel = filter->GetMaximumLevel();
  settings.InterpolateIntegers = filter->GetInterpolateIntegers();
  settings.HasOthers = hasOthers;
  settings.AttributeIndex = firstIndex;
  settings.RangeIndex = firstIndex + 1;
  settings.LevelIndex = firstIndex + 2;
  return settings;
}

/// False, after `fail`, if an array cannot be used.
bool ReadRefinementOptions(vtkAlgorithm* filter, vtkPointSet* input,
  const RefinementSettings& settings, const std::function<void(const std::string&)>& warn,
  const std::function<void(const std::string&)>& fail, RefinementOptions& options);

}

#endif
