// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenMesh.h
 * What red-green refinement starts from: an input's simplices, or, where an earlier filter of this
 * kind made the input, the cells that its green cells stand for; and what travels with an output so
 * that the next filter knows them.
 */
#ifndef SubdivisionObjects_RedGreenMesh_h
#define SubdivisionObjects_RedGreenMesh_h

#include "Core/Solids/RedGreen/RedGreenOutput.h"
#include "Private/Control/ControlMesh.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

/// Arrays of the output.
constexpr const char* LevelName = "RefinementLevel";
constexpr const char* KindName = "RefinementKind";
constexpr const char* GreenParentName = "GreenParent";
constexpr const char* LeavesName = "RedGreenLeaves";

struct RedGreenMesh
{
  ControlMesh Control; ///< as read; where green cells are undone, its cells are the leaves
  bool TetOrderIsFinal = false;
  bool IsContinued = false;          ///< an earlier filter's cells and levels go on
  std::vector<unsigned char> Levels; ///< of the simplices; empty: all 0
  /// Ends and middle of the edges that are split already.
  std::vector<std::array<vtkIdType, 3>> Midpoints;

  vtkIdType GetInputCell(vtkIdType simplex) const
  {
    const auto& parents = this->Control.Cells.ParentCells;
    return parents.empty() ? simplex : parents[simplex];
  }
  SimplexView GetView() const
  {
    SimplexView view = this->Control.Cells.GetView();
    view.Levels = this->Levels.empty() ? nullptr : this->Levels.data();
    return view;
  }
};

/// Reads an input. `trustStamp`: as in ReadControlMesh; `undo`: false where its green cells are to
/// be taken as they are. `warn` hears why they are although it has some of an earlier filter's.
RedGreenMesh ReadRedGreenMesh(vtkPointSet* input, const FeatureOptions& features, bool trustStamp,
  bool undo, const std::function<void(const std::string&)>& warn);

/// Writes or replaces the stamp, the leaves and the global ids of a finished output.
template <typename Id>
void WriteRedGreenFields(const RedGreenMesh& mesh, const RedGreenOutput<Id>& plan, bool isProjected,
  vtkUnstructuredGrid* output);

}

#endif
