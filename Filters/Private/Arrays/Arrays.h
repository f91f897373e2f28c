// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Arrays.h
 * Helpers for VTK arrays: to make, copy and compare them.
 */
#ifndef SubdivisionObjects_Arrays_h
#define SubdivisionObjects_Arrays_h

#include "Core/Memory/Buffer.h"
#include "Private/Arrays/Fingerprint.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace subdivision
{

/// A contiguous array of a VTK value type, its values not initialised.
vtkSmartPointer<vtkDataArray> MakeArray(int valueType, int components, vtkIdType tuples);

/// Gives an empty array room for tuples, not initialised.
void Allocate(vtkDataArray* array, int components, vtkIdType tuples);

/// An array of the kind of another, with its looks, its values not initialised. Whatever the other
/// is stored as, this one can be written.
vtkSmartPointer<vtkAbstractArray> MakeLike(vtkAbstractArray* array, vtkIdType tuples);

/// Copies the name, the component names, the information keys and the lookup table.
void CopyLooks(vtkAbstractArray* from, vtkAbstractArray* to);

/// Adds `array`, which stands for the array `source` of `from`, with the same active attribute.
void AddLike(
  vtkDataSetAttributes* from, int source, vtkAbstractArray* array, vtkDataSetAttributes* to);

/// Adds an array that the filter made. If `from` has an array of this name, the new one takes its
/// place as active attribute.
void AddInstead(vtkDataSetAttributes* from, vtkAbstractArray* array, vtkDataSetAttributes* to);

/// Whether an array has a tuple for each point or cell. If not, it cannot be used, and `warn` gets
/// a message.
bool HasTuples(vtkAbstractArray* array, vtkIdType wanted, const char* kind,
  const std::function<void(const std::string&)>& warn);

/// Whether there is an array of integers by that name, one for each of `tuples` points or cells.
bool HasIds(vtkDataSetAttributes* data, const char* name, vtkIdType tuples);

/// The global ids of points or cells; empty unless there is one for each.
std::vector<vtkIdType> ReadIdsOf(vtkDataSetAttributes* data, vtkIdType tuples);

/// The lists of all ranks, one after another in their order. All ranks call it.
std::vector<double> GatherFromRanks(
  vtkMultiProcessController* controller, const std::vector<double>& own);

/// Converts a number to an id; -1 if it is NaN or so large that a double is not exact.
vtkIdType ToId(double value);
/// The nearest number from 1 to the largest one.
vtkIdType ToCount(double value);

/// The array itself if it is contiguous, else a contiguous copy.
vtkSmartPointer<vtkDataArray> Contiguous(vtkDataArray* array);

/// Whether two contiguous arrays have the same type and the same values, bit for bit.
bool HoldsSameValues(vtkDataArray* a, vtkDataArray* b);

/**
 * Arrays that a filter keeps and that its outputs have, too. Who has an output may write into its
 * arrays, as NumPy does, and no modified time tells. So a filter takes their fingerprint before it
 * hands them out, and compares before it uses them again. That takes as long as reading them.
 */
class SharedArrays
{
public:
  /// Null is no array.
  void Set(const std::vector<vtkDataArray*>& arrays);
  void Clear();
  /// Whether these are the arrays that were set, with the values that they had.
  bool Hold(const std::vector<vtkDataArray*>& arrays) const;

private:
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::vector<Fingerprint> Fingerprints;
};

/// out[i] = in[sources[i]], whatever the arrays hold.
vtkSmartPointer<vtkAbstractArray> Gather(vtkAbstractArray* in, Row<vtkIdType> sources);

}

#endif
