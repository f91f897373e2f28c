// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Store.h
 * Converts a sum in double to the type of an array.
 */
#ifndef SubdivisionObjects_Store_h
#define SubdivisionObjects_Store_h

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace subdivision
{

/// Integers are rounded and stay in range, and are 0 where the value is not a number; a finite
/// number never becomes infinite.
template <typename T>
T Store(double value)
{
  if constexpr (std::is_floating_point<T>::value)
  {
    if constexpr (sizeof(T) < sizeof(double))
    {
      constexpr double most = static_cast<double>(std::numeric_limits<T>::max());
      return static_cast<T>(std::isfinite(value) ? std::max(-most, std::min(value, most)) : value);
    }
    return static_cast<T>(value);
  }
  else
  {
    constexpr double low = static_cast<double>(std::numeric_limits<T>::lowest());
    constexpr double high = static_cast<double>(std::numeric_limits<T>::max());
    const double below = std::floor(value); // value + 0.5 would be rounded itself
    const double rounded = value - below >= 0.5 ? below + 1. : below;
    return std::isnan(value) ? T(0)
      : rounded <= low       ? std::numeric_limits<T>::lowest()
      : rounded >= high      ? std::numeric_limits<T>::max()
                             : static_cast<T>(rounded);
  }
}

}

#endif
