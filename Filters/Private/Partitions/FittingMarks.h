// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FittingMarks.h
 * How many marks of a round may be applied where all of them lead to too many cells.
 */
#ifndef SubdivisionObjects_FittingMarks_h
#define SubdivisionObjects_FittingMarks_h

#include "Private/Partitions/OtherPartitions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace subdivision
{

/// The warning of marks that were left out, where the output would have more cells than `most`.
inline std::string DescribeLeftOut(vtkIdType left, vtkIdType most, bool memoryIsLimit)
{
  return std::to_string(left) +
    " places that the criteria ask for were not refined. The filter leaves out those with the "
    "smallest errors first, the worst ones last: the output would have more than " +
    std::to_string(most) + " cells, " +
    (memoryIsLimit
        ? "for which there is not enough memory. Use weaker criteria, a lower MaximumLevel, or a "
          "part of the input."
        : "which is MaximumNumberOfCells. Raise it, or use weaker criteria or a lower "
          "MaximumLevel.");
}

/// How many of the first marks fit, or a few less. `fitsWith(count)` tries.
template <typename Try>
std::size_t FindFittingCount(std::size_t marks, const Try& fitsWith)
{
  std::size_t fits = 0;
  std::size_t exceeds = marks;
  const std::size_t exact = std::max<std::size_t>(1, marks / 1024);
  while (exceeds - fits > exact)
  {
    const std::size_t middle = fits + (exceeds - fits) / 2;
    (fitsWith(middle) ? fits : exceeds) = middle;
  }
  return fits;
}

/// The same for the marks of one of several partitions, the largest errors first: finds an error
/// above which the marks of all partitions fit, so that the result is the same for any partition.
template <typename Mark, typename Try>
std::size_t FindFittingError(
  const std::vector<Mark>& marks, OtherPartitions& others, const Try& fitsWith)
{
  const auto count = [&marks](double error)
  {
    return static_cast<std::size_t>(std::count_if(
      marks.begin(), marks.end(), [error](const auto& mark) { return mark.Error > error; }));
  };
  constexpr double most = 1e100; // stands for infinite errors
  std::vector<double> largest{ marks.empty() ? 1. : std::min(most, marks.front().Error) };
  others.FindLargest(largest);
  double fits = largest[0] < most ? largest[0] : std::numeric_limits<double>::infinity();
  double exceeds = 1.;
  for (int step = 0; step < 10; ++step)
  {
    const double middle = std::sqrt(std::min(most, fits) * exceeds);
    (fitsWith(count(middle)) ? fits : exceeds) = middle;
  }
  return count(fits);
}

}

#endif
