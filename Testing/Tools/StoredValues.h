// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StoredValues.h
 * Arrays of any type as bytes, before and after an operator.
 */
#ifndef SubdivisionObjects_StoredValues_h
#define SubdivisionObjects_StoredValues_h

#include "Core/Operators/ApplyRows.h"

#include <random>
#include <vector>

namespace coretest
{

using namespace subdivision;

/// Types are numbers of VTK: VTK_DOUBLE, VTK_FLOAT, VTK_LONG_LONG or VTK_UNSIGNED_CHAR.
struct StoredValues
{
  int InType;
  int OutType;
  int Components;
  vtkIdType Tuples;
  std::vector<unsigned char> In;
  std::vector<unsigned char> Out;

  /// As ApplyToArrays takes it.
  MovedArray GetArray()
  {
    return { this->In.data(), this->InType, this->Out.data(), this->OutType, this->Components,
      this->Tuples };
  }
  /// Makes room for the values after an operator.
  void Resize(vtkIdType rows);
};

/// Random values. `wild`: some are not finite, very large, or -0.
StoredValues MakeStoredValues(
  int inType, int outType, int components, vtkIdType tuples, std::mt19937& random, bool wild);

/// The number of values after the operator that differ. Which of two bit patterns says "not a
/// number" is left to the processor.
int CountDifferences(const StoredValues& a, const StoredValues& b);

}

#endif
