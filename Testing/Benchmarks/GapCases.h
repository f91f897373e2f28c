// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GapCases.h
 * Every filter and source, with every kind of work that it has, on large meshes.
 */
#ifndef SubdivisionObjects_GapCases_h
#define SubdivisionObjects_GapCases_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace benchmarks
{

struct GapCase
{
  std::string Name;
  /// Makes the algorithm with its inputs, which are `scale` times as large as usual.
  std::function<vtkSmartPointer<vtkAlgorithm>(double scale)> Make;
  /// If there: what is changed after a first execution; the second one is looked at.
  std::function<void(vtkAlgorithm*)> Change;
};

std::vector<GapCase> GetGapCases();

}

#endif
