// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitOperators.h
 * The operators that follow the last step: they move points and arrays to the limit, and compute
 * its normals and tangents.
 */
#ifndef SubdivisionObjects_LimitOperators_h
#define SubdivisionObjects_LimitOperators_h

#include "Core/Solids/Limits/LimitNormals.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/PointArrays.h"

namespace subdivision
{

template <typename Id>
struct LimitOperators
{
  SparseRows<Id> Rows; ///< none: points stay where they are
  LimitTangents<Id> Tangents;
  bool HasNormals = false;
  bool HasTangents = false; ///< these go to arrays of their own

  LimitOperators() = default;
  /// A level of any volume scheme.
  template <typename Level>
  LimitOperators(const Level& level, const SemiSharpStages<Id>& creases,
    const ControlSolids& solids, bool project, bool generateNormals, bool generateTangents);

  /// `arrays` belong to the level; `inverted` and `turned` as in ComputeLimitNormals.
  void Apply(PointArrays& arrays, const std::vector<vtkIdType>& inverted,
    const Buffer<unsigned char>& turned) const;
  std::size_t GetMemorySize() const
  {
    return this->Rows.GetMemorySize() + this->Tangents.GetMemorySize();
  }
};

}

#endif
