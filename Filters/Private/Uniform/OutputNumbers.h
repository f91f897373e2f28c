// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutputNumbers.h
 * Numbers the points and cells of an output that is made of a part of a mesh as the output of the
 * whole mesh numbers them.
 */
#ifndef SubdivisionObjects_OutputNumbers_h
#define SubdivisionObjects_OutputNumbers_h

#include "Core/Solids/AllSchemes/LevelCut.h"
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Private/Control/ControlMesh.h"

#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkPointSet;

namespace subdivision
{

class OtherPartitions;

/// The simplices that go into the output, where the mesh has copies of cells of other partitions.
struct WantedSimplices
{
  std::vector<char> Flags;       ///< one for each control simplex; empty: all are wanted
  std::vector<vtkIdType> Points; ///< that no cell of the input uses, if not all are wanted

  bool IsAll() const { return this->Flags.empty(); }
  bool Has(vtkIdType simplex) const { return this->IsAll() || this->Flags[simplex]; }
  bool operator==(const WantedSimplices& other) const
  {
    return this->Flags == other.Flags && this->Points == other.Points;
  }
};

/// The control simplices of a part of a mesh, and their numbers in the whole.
struct ControlNumbers
{
  /// Of vertices, edges, faces and tetrahedra; -1 far from own cells. How many the whole has.
  std::array<std::vector<vtkIdType>, 4> Numbers;
  std::array<vtkIdType, 4> Totals{};
  /// Wanted simplices with their faces, and wanted points.
  ControlParts Parts;
  /// Of each wanted simplex, the number of its first cell in the output.
  std::vector<vtkIdType> FirstCells;
  vtkIdType NumberOfCells = 0; ///< of the output of the whole
  /// Of each derived simplex that is kept, by its dimension, whether it is a face of an own cell:
  /// only then this partition is sure of it.
  std::vector<char> IsOwnDerived[3];
  std::vector<char> HasDerived[3]; ///< of each derived simplex, whether it is kept
};

/**
 * Numbers control simplices. `complex` is the one of the control mesh and of derived singular
 * simplices, and `runs` has runs of the former, and then of the latter. `mesh` was read from
 * `input`, the mesh that `others` know; the output is `steps` steps after its control mesh. All
 * partitions call this together.
 *
 * The ids of children follow from the ids of their parents by arithmetic. So it is enough to number
 * the vertices, edges, faces and tetrahedra of the control mesh, each kind with NumberTogether: 16
 * exchanges, however many steps there are. About 300 bytes are sent for each control tetrahedron.
 */
template <typename Id>
ControlNumbers NumberControl(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const ControlMesh& mesh, const WantedSimplices& wanted, vtkPointSet* input, int steps,
  OtherPartitions& others);

struct OutputNumbers
{
  vtkSmartPointer<vtkIdTypeArray> Points; ///< -1 far from own cells
  vtkSmartPointer<vtkIdTypeArray> Cells;
  vtkIdType NumberOfPoints = 0; ///< of the whole
};

/// The numbers of the points and cells of the output, `steps` steps after the control mesh, of
/// which `wanted` are the wanted simplices.
OutputNumbers NumberOutput(
  const ControlNumbers& control, const SimplexList& wanted, int steps, const SchemeTraits& scheme);

}

#endif
