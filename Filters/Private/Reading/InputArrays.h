// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputArrays.h
 * The arrays that SetInputArrayToProcess names.
 */
#ifndef SubdivisionObjects_InputArrays_h
#define SubdivisionObjects_InputArrays_h

#include "vtkType.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSetAttributes;

namespace subdivision
{

struct ArrayRequest
{
  int Index;
  const char* Fallback; ///< the name where none is given; may be null
  bool Integral;
  bool OfPoints = false;
  bool AnyComponents = false; ///< else one
};

/// The name set at an index, empty for none; `association`, if it is set, that of its array.
std::string GetInputArrayName(vtkAlgorithm* algorithm, int index, int& association);

/// Sets `array` to what was asked for, or null where it is unset and the fallback is not there.
/// False, after `fail`, where a named array cannot be used. `size`: number of cells or points.
bool FindInputArray(vtkAlgorithm* algorithm, vtkDataSetAttributes* data, vtkIdType size,
  const ArrayRequest& request, const std::function<void(const std::string&)>& warn,
  const std::function<void(const std::string&)>& fail, vtkDataArray*& array);

}

#endif
