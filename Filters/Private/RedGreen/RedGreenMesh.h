// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenMesh.h
 * Reads the mesh that red-green refinement starts from: the simplices of the input or, if an
 * earlier filter of this kind made the input, with the leaves in the place of their green parts.
 * Writes the field arrays from which the next filter can tell the leaves.
 */
#ifndef SubdivisionObjects_RedGreenMesh_h
#define SubdivisionObjects_RedGreenMesh_h

#include "Core/Solids/RedGreen/RedGreenOutput.h"
#include "Private/Control/ControlMesh.h"
#include "Private/Control/GreenLeaves.h"
#include "Private/Partitions/SharedNumbers.h"

#include <array>
#include <vector>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

/// Arrays of the output.
constexpr const char* LevelName = "RefinementLevel";
constexpr const char* KindName = "RefinementKind";

struct RedGreenMesh
{
  ControlMesh Control; ///< as read; where green cells are undone, its cells are the leaves
  bool TetOrderIsFinal = false;
  bool IsContinued = false; ///< green cells of an earlier filter were undone, its levels are kept
  std::vector<unsigned char> Levels; ///< of the simplices; empty: all 0
  /// Ends and midpoint of each edge of a leaf that is split already.
  std::vector<std::array<vtkIdType, 3>> Midpoints;
  std::vector<CellScope> Scopes; ///< of the simplices; empty: all are Own

  vtkIdType GetInputCell(vtkIdType simplex) const
  {
    const auto& parents = this->Control.Cells.ParentCells;
    return parents.empty() ? simplex : parents[simplex];
  }
  /// Whether original ids go on, because an earlier filter of this kind wrote them.
  bool CarriesOriginals() const { return this->IsContinued || this->Control.IsStamped; }
  CellScope GetScope(vtkIdType simplex) const
  {
    return this->Scopes.empty() ? CellScope::Own : this->Scopes[simplex];
  }
  SimplexView GetView() const
  {
    SimplexView view = this->Control.Cells.GetView();
    view.Levels = this->Levels.empty() ? nullptr : this->Levels.data();
    return view;
  }
};

/// Reads an input. `scheme` and `trustStamp`: as in ReadControlMesh; `undo`: false if green cells
/// are to be taken as they are. The warnings of the control mesh have the reason if the green cells
/// of an earlier filter cannot be undone.
RedGreenMesh ReadRedGreenMesh(vtkPointSet* input, const FeatureOptions& features,
  StampScheme scheme, bool trustStamp, bool undo);

/// Writes or replaces the stamp, the leaves and the global ids of a finished output. `whole`: the
/// numbers of the output of which this is a part; nothing: it is the whole.
template <typename Id>
void WriteRedGreenFields(const RedGreenMesh& mesh, const RedGreenOutput<Id>& plan, bool isProjected,
  const WholeNumbers& whole, vtkUnstructuredGrid* output);

}

#endif
