// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputContractCases.h
 * Damaged and unlikely inputs, by the keys of Documentation/Guide/InputContract.md.
 */
#ifndef SubdivisionObjects_InputContractCases_h
#define SubdivisionObjects_InputContractCases_h

#include "FeatureTools.h"

namespace input_contract
{

using namespace feature_tools;

/// What the filter gets: a mesh, whose changes a case makes, and options.
struct Trial
{
  std::vector<Point> Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
  std::vector<Cell> Cells = { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } } };
  std::function<void(vtkUnstructuredGrid*)> Change = [](vtkUnstructuredGrid*) {};
  Configure Set;                        ///< may be none
  vtkSmartPointer<vtkDataObject> Other; ///< in place of the mesh
  bool HasInput = true;
};

using Case = std::function<void(Trial&)>;

const std::map<std::string, Case>& GetCases();

}

#endif
