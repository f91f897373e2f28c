// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinementInput.h
 * Finds the arrays that criteria read.
 */
#ifndef SubdivisionObjects_RefinementInput_h
#define SubdivisionObjects_RefinementInput_h

#include "Private/Criteria/RefinementCriteria.h"

class vtkAlgorithm;

namespace subdivision
{

/**
 * The arrays of an input by their indices in SetInputArrayToProcess. The methods return false,
 * after `fail`, if an array cannot be used. `criterion`: the name of the option that cannot do
 * without the array.
 */
class RefinementArrays
{
public:
  using Tell = std::function<void(const std::string&)>;
  using Array = vtkSmartPointer<vtkDataArray>;
  RefinementArrays(vtkAlgorithm* filter, vtkPointSet* input, const Tell& warn, const Tell& fail)
    : Filter(filter)
    , Input(input)
    , Warn(warn)
    , Fail(fail)
  {
  }
  /// The array of points that the user chose, else the active scalars, else the first array of
  /// floating point numbers; null if there is none.
  bool FindOfPoints(int index, Array& array) const;
  /// The array that the user chose, else the active scalars of the points, else of the cells.
  bool Find(int index, const char* criterion, Array& array, bool& ofCells) const;
  /// The array of cells with integers that the user chose, else the one named `fallback`.
  bool FindOfCells(int index, const char* criterion, const char* fallback, Array& array) const;

private:
  bool FindNamed(
    int index, bool ofCells, const char* fallback, bool integral, vtkDataArray*& array) const;

  vtkAlgorithm* Filter;
  vtkPointSet* Input;
  const Tell& Warn;
  const Tell& Fail;
};

}

#endif
