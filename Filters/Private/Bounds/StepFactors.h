// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StepFactors.h
 * Steps as matrices that are applied one after the other.
 */
#ifndef SubdivisionObjects_StepFactors_h
#define SubdivisionObjects_StepFactors_h

#include "Core/Memory/Buffer.h"
#include "Private/Bounds/Sectors.h"

#include <cstddef>

namespace subdivision
{

/// The factors of the operations from `first` to before `last`.
Sectors::Step ListFactors(const MatrixFactors& factors, std::size_t first, std::size_t last);

/// The values after them; the same values if there are none.
Buffer<double> ApplyFactors(
  const Sectors::Step& factors, const Buffer<double>& values, int components);

}

#endif
