// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshMessage.h
 * Cells with their points and arrays as bytes, to send them to another partition.
 */
#ifndef SubdivisionObjects_MeshMessage_h
#define SubdivisionObjects_MeshMessage_h

#include "Private/Distribution/JoinedMesh.h"

namespace subdivision
{

/// Appends cells of a part, ascending, with their points, their ids, and all arrays but variants.
/// Names of components and information keys are not sent: they come from the receiver's own cells.
/// Returns the points.
std::vector<vtkIdType> PackCells(
  const MeshPart& part, const std::vector<vtkIdType>& cells, std::vector<char>& message);

/// Appends the parts that PackCells wrote, as cells of no block of this rank.
void UnpackCells(const std::vector<char>& message, std::vector<MeshPart>& parts);

/// Appends coordinates and arrays of points and cells, to send them again when cells are the same.
void PackValues(const MeshPart& part, const std::vector<vtkIdType>& points,
  const std::vector<vtkIdType>& cells, std::vector<char>& message);

/// Gives parts that UnpackCells made, in their order, the values that PackValues wrote.
void UnpackValues(const std::vector<char>& message, const std::vector<MeshPart*>& parts);

}

#endif
