// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StampedParts.h
 * Lets a filter go on with the output of an earlier filter for blocks and partitions (Stamp.h).
 * Field arrays of a block hold the numbers that its points and cells have in the whole output.
 */
#ifndef SubdivisionObjects_StampedParts_h
#define SubdivisionObjects_StampedParts_h

#include "Private/Distribution/JoinedMesh.h"
#include "Private/Partitions/OtherPartitions.h"

#include "vtkAbstractArray.h"
#include "vtkFieldData.h"

class vtkIdTypeArray;

namespace subdivision
{

/// Whether an earlier filter made a mesh.
bool HasStamp(vtkPointSet* mesh);

/// Adds the numbers of the points and cells of a block to its field data. The arrays themselves,
/// which get other names.
void WriteStampedNumbers(vtkIdTypeArray* points, vtkIdTypeArray* cells, vtkPointSet* block);

/// Sets Points and Cells of the parts of a partition to these numbers, and Levels; all partitions
/// call it. Returns false in all of them, and the parts are undefined, unless all parts come
/// from one output, and nothing of it is missing.
bool TakeStampedNumbers(std::vector<MeshPart>& parts, Exchange& exchange);

/// Whether a field array has ids of a stamp that all partitions around the block have to know.
bool IsStampedList(vtkAbstractArray* array);

/// Adds the field arrays that accept(array) wants.
template <typename Accept>
void AddFieldArrays(vtkFieldData* from, const Accept& accept, vtkFieldData* to)
{
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(a);
    accept(array) ? void(to->AddArray(array)) : void();
  }
}

/// Gives the joined mesh of a partition the stamp of its parts. `taken` is the result of
/// TakeStampedNumbers; `isPartial`: whether there are other partitions. Returns false if there is a
/// stamp that is lost.
bool RestoreStamp(
  const std::vector<MeshPart>& parts, bool taken, bool isPartial, JoinedMesh& joined);

/**
 * The cells of a part in the groups in which AddLayers sends them: the descendants of one control
 * simplex, where an earlier filter made them, the green parts of a leaf, else each cell for itself.
 */
struct CellGroups
{
  std::vector<vtkIdType> Cells;       ///< cells that are not left out, group by group
  std::vector<vtkIdType> Starts{ 0 }; ///< of groups in Cells, and its end
  std::vector<vtkIdType> Points;      ///< of the part: the corners of the groups
  std::vector<vtkIdType> PointStarts{ 0 };

  vtkIdType GetNumberOfGroups() const { return static_cast<vtkIdType>(this->Starts.size()) - 1; }
};

/// Returns false if the cells of a part are not the descendants of simplices after part.Levels
/// steps.
bool FindGroups(const MeshPart& part, CellGroups& groups);

}

#endif
