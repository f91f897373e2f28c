// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Arrays.h
 * Small helpers for VTK arrays: making them, and giving a copy the looks of its original.
 */
#ifndef SubdivisionObjects_Arrays_h
#define SubdivisionObjects_Arrays_h

#include "Core/Memory/Buffer.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace subdivision
{

/// A contiguous array of a VTK value type, its values not initialised.
vtkSmartPointer<vtkDataArray> MakeArray(int valueType, int components, vtkIdType tuples);

/// Gives an empty array room for tuples, not initialised.
void Allocate(vtkDataArray* array, int components, vtkIdType tuples);

/// Name, component names and information keys.
void CopyLooks(vtkAbstractArray* from, vtkAbstractArray* to);

/// Adds `array`, which stands for the array `source` of `from`, with the same active attribute.
void AddLike(
  vtkDataSetAttributes* from, int source, vtkAbstractArray* array, vtkDataSetAttributes* to);

/// Adds an array of the filter's own making in the place of one that `from` may have by its name.
void AddInstead(vtkDataSetAttributes* from, vtkAbstractArray* array, vtkDataSetAttributes* to);

/// Whether an array has a tuple for each point or cell; if not it cannot be used, and `warn` hears
/// so.
bool HasTuples(vtkAbstractArray* array, vtkIdType wanted, const char* kind,
  const std::function<void(const std::string&)>& warn);

/// Whether there is an array of integers by that name, one for each of `tuples` points or cells.
bool HasIds(vtkDataSetAttributes* data, const char* name, vtkIdType tuples);

/// The global ids of points or cells; empty unless there is one for each.
std::vector<vtkIdType> ReadIdsOf(vtkDataSetAttributes* data, vtkIdType tuples);

/// A number as an id; -1 where it is none.
vtkIdType ToId(double value);

/// The array itself if it is contiguous, else a contiguous copy.
vtkSmartPointer<vtkDataArray> Contiguous(vtkDataArray* array);

/// Whether two contiguous arrays have the same type and the same values, bit for bit.
bool HoldsSameValues(vtkDataArray* a, vtkDataArray* b);

/// Numbers that tell a contiguous array from others, by its values: 8 of 64 bits for every half
/// megabyte, so that to compare them is to read the array once, and nothing but them.
std::vector<std::uint64_t> ComputeFingerprint(vtkDataArray* array);

/// out[i] = in[sources[i]], whatever the arrays hold.
vtkSmartPointer<vtkAbstractArray> Gather(vtkAbstractArray* in, Row<vtkIdType> sources);

}

#endif
