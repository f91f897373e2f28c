// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelPieces.h
 * The connected pieces of labels, before and after blocks of voxels become one.
 */
#ifndef SubdivisionObjects_LabelPieces_h
#define SubdivisionObjects_LabelPieces_h

#include "Core/Memory/Buffer.h"
#include "Private/Labels/LabelImage.h"

#include <string>

namespace subdivision
{

/// For each voxel the first one of its piece: of voxels of one label that touch in faces, or also
/// in edges and corners; -1 in the background.
Buffer<vtkIdType> FindPieces(const LabelImage& image, bool byCorners);

/// Gives blocks to labels so that the blocks of a piece, where it has some, are connected as the
/// piece is; if it is connected by faces, by faces. Such a block has voxels of the piece. Small
/// pieces come first, and the last block of a label stays.
void KeepConnected(
  const LabelImage& fine, const Buffer<vtkIdType>& pieces, bool byCorners, LabelImage& coarse);

/// A text on labels of which a piece comes apart, or some pieces with enough voxels for a block are
/// lost, but not all; empty if there are none.
std::string DescribeChangedLabels(const LabelImage& fine, const Buffer<vtkIdType>& pieces,
  bool byCorners, const LabelImage& coarse);

}

#endif
