// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputArrays.h
 * The arrays that SetInputArrayToProcess names.
 */
#ifndef SubdivisionObjects_InputArrays_h
#define SubdivisionObjects_InputArrays_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataSetAttributes;
class vtkPointSet;

namespace subdivision
{

struct ArrayRequest
{
  int Index;
  const char* Fallback; ///< the array to take where the user chose none; may be null
  bool Integral;
  bool OfPoints = false;
  bool AnyComponents = false; ///< if false, the array must have one component
  /// What its numbers are, if they have to be smoothed; null: they need not.
  const char* Smoothed = nullptr;
};

/// The name that SetInputArrayToProcess gave to `index`; empty if it gave none, or None. If an
/// association was given too, `association` is set to it.
std::string GetInputArrayName(vtkAlgorithm* algorithm, int index, int& association);

/// Sets `array` to the array that the user chose, or else to the fallback; null if there is
/// neither. A chosen array that cannot be used calls `fail` and returns false. A fallback that
/// cannot be used calls `warn` and is ignored. `size`: number of cells or points.
bool FindInputArray(vtkAlgorithm* algorithm, vtkDataSetAttributes* data, vtkIdType size,
  const ArrayRequest& request, const std::function<void(const std::string&)>& warn,
  const std::function<void(const std::string&)>& fail, vtkDataArray*& array);

}

#endif
