// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SelectedParts.h
 * Finds the points and cells that a vtkSelection selects.
 */
#ifndef SubdivisionObjects_SelectedParts_h
#define SubdivisionObjects_SelectedParts_h

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkDataObject;
class vtkSelection;

namespace subdivision
{

/// For each mesh where there are any, 1 for each cell that is selected or has a selected point.
using SelectedCells = std::map<vtkDataObject*, std::vector<unsigned char>>;

/// Finds the selected cells of a mesh, or of all meshes in a composite input. The result has cells
/// of `readable`, which MakeReadable makes of the input; points that were merged there stand for
/// the points that they became. If the selection cannot be used, `fail` gets the reason.
SelectedCells FindSelectedCells(vtkDataObject* input, vtkDataObject* readable,
  vtkSelection* selection, const std::function<void(const std::string&)>& fail);

/// 1 for each point and each cell that is selected by itself; empty where there are none.
struct SelectedParts
{
  std::vector<unsigned char> Points;
  std::vector<unsigned char> Cells;
};

/// The same for points and cells, of all nodes together.
std::map<vtkDataObject*, SelectedParts> FindSelectedParts(vtkDataObject* input,
  vtkDataObject* readable, vtkSelection* selection,
  const std::function<void(const std::string&)>& fail);

}

#endif
