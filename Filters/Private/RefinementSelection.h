// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinementSelection.h
 * Which cells of a mesh a vtkSelection means.
 */
#ifndef SubdivisionObjects_RefinementSelection_h
#define SubdivisionObjects_RefinementSelection_h

#include <vector>

class vtkPointSet;
class vtkSelection;

namespace subdivision
{

/// 1 for each cell that is selected or has a selected point; empty if nothing is. `block`: the
/// composite index of the mesh where it is a part of a larger one, else 0.
std::vector<unsigned char> FindSelectedCells(
  vtkPointSet* input, vtkSelection* selection, unsigned int block);

}

#endif
