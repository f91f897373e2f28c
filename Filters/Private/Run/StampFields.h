// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StampFields.h
 * The field arrays of stamps: the numbers that each stamp has (Mathematics 2), and lists of values.
 */
#ifndef SubdivisionObjects_StampFields_h
#define SubdivisionObjects_StampFields_h

#include "vtkFieldData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace subdivision
{

/// Levels that a stamp can claim.
constexpr int MostStampedLevels = 20;

/// The field array with the numbers of a stamp. The first number is the version of the format;
/// where the others stand that all stamps have, each kind of stamp says.
struct StampFormat
{
  const char* Name;
  vtkIdType Version;
  int NumberOfNumbers;
  int Levels;
  int ControlPoints;
  int Points;
  int Cells;
};

/// The numbers of a stamp. Empty if there is none of that format, or if it does not fit the counts
/// of the mesh.
std::vector<vtkIdType> ReadStampNumbers(vtkPointSet* mesh, const StampFormat& format);

/// The field array of that name, or null if there is none with so many components. All that filters
/// read of field arrays goes through here.
vtkDataArray* FindField(const char* name, vtkFieldData* data, int components = 1);

/// The tuples of a field array, one after another. Empty if there is no array of that name with so
/// many components. Numbers that are no ids become -1.
std::vector<double> ReadFieldValues(const char* name, vtkFieldData* data, int components = 1);
std::vector<vtkIdType> ReadFieldIds(const char* name, vtkFieldData* data, int components = 1);

template <typename Array, typename Value>
vtkSmartPointer<Array> MakeField(
  const char* name, const std::vector<Value>& values, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/// Writes a field array anew, or removes it if there are no values.
template <typename Array, typename Value>
void WriteField(
  const char* name, const std::vector<Value>& values, vtkFieldData* data, int components = 1)
{
  data->RemoveArray(name);
  if (!values.empty())
  {
    data->AddArray(MakeField<Array>(name, values, components));
  }
}

}

#endif
