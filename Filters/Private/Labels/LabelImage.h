// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelImage.h
 * A grid of voxels with a label each, and how blocks of voxels become one.
 */
#ifndef SubdivisionObjects_LabelImage_h
#define SubdivisionObjects_LabelImage_h

#include "Core/Memory/Buffer.h"

#include "vtkType.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;

namespace subdivision
{

struct LabelImage
{
  std::array<vtkIdType, 3> Size{ 0, 0, 0 }; ///< voxels along each axis
  /// By x, then y, then z: 0 for background, i + 1 for Labels[i].
  Buffer<int> Voxels;
  std::vector<vtkVariant> Labels;     ///< ascending, each of them in the image
  std::vector<vtkIdType> FirstVoxels; ///< one with each label
  vtkIdType NumberOfMaterialVoxels = 0;
  vtkIdType NumberOfMissing = 0; ///< values that are NaN or infinite, and so background
  vtkIdType FirstMissing = -1;
  /// Of an image of blocks: the size of the image from which it was made.
  std::array<vtkIdType, 3> FineSize{ 0, 0, 0 };
  int Length = 1; ///< of a block, in voxels
  /// Of each block the bits of the ends of the image (-x, x, -y, y, -z, z) where it is the last one
  /// and half of its voxels there, or more, are of materials.
  Buffer<unsigned char> Ends;

  vtkIdType GetId(vtkIdType i, vtkIdType j, vtkIdType k) const
  {
    return i + this->Size[0] * (j + this->Size[1] * k);
  }
  std::array<vtkIdType, 3> GetPlace(vtkIdType voxel) const
  {
    return { voxel % this->Size[0], voxel / this->Size[0] % this->Size[1],
      voxel / this->Size[0] / this->Size[1] };
  }
  /// Of an image of blocks: the voxels of a block, from the first along each axis.
  std::array<vtkIdType, 3> GetFirst(vtkIdType block) const
  {
    const auto at = this->GetPlace(block);
    return { this->Length * at[0], this->Length * at[1], this->Length * at[2] };
  }
  std::array<vtkIdType, 3> GetExtent(vtkIdType block) const
  {
    const auto at = this->GetPlace(block);
    std::array<vtkIdType, 3> extent;
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[axis] = at[axis] + 1 < this->Size[axis]
        ? this->Length
        : this->FineSize[axis] - this->Length * at[axis];
    }
    return extent;
  }
};

/// Calls visit(voxel) for the voxels of a block.
template <typename Visit>
void VisitBlock(const LabelImage& coarse, vtkIdType block, const Visit& visit)
{
  const auto first = coarse.GetFirst(block);
  const auto extent = coarse.GetExtent(block);
  for (vtkIdType k = first[2]; k < first[2] + extent[2]; ++k)
  {
    for (vtkIdType j = first[1]; j < first[1] + extent[1]; ++j)
    {
      const vtkIdType row = coarse.FineSize[0] * (j + coarse.FineSize[1] * k);
      for (vtkIdType i = first[0]; i < first[0] + extent[0]; ++i)
      {
        visit(row + i);
      }
    }
  }
}

/// A value as whole number of 64 bits, also where a double cannot tell it from others; not valid if
/// it is none. `array` is contiguous.
vtkVariant FindWholeNumber(vtkDataArray* array, vtkIdType tuple);

/// Sets Voxels and Labels of an image whose Size is set. Voxels where isHidden says so, or whose
/// value is missing, are background. Returns an error message if a value is no integer.
std::string ReadLabels(vtkDataArray* array, const vtkVariant& background,
  const std::function<bool(vtkIdType)>& isHidden, LabelImage& image);

/// Makes one voxel of each block of `length`^3: of the label that most of its voxels have. Where
/// labels have equally many, materials come before background, then the smallest label wins. At the
/// end of the image blocks have half of that length or more, or up to one half more. Labels are the
/// labels of `image`, also where none is left.
LabelImage Coarsen(const LabelImage& image, int length);

/// The smallest length of blocks that leaves at most `wanted` voxels of materials; 1 if `wanted`
/// is 0.
int FindBlockLength(const LabelImage& image, vtkIdType wanted);

/// Adds to `cells` the arrays of `voxels` but `labels`, ids and ghosts, a tuple for each voxel of
/// `coarse` that is no background. Floating point arrays get the mean over the voxels of the block
/// that have its label, others the tuple of the first of these.
void CopyVoxelArrays(const LabelImage& fine, const LabelImage& coarse, vtkDataSetAttributes* voxels,
  vtkDataArray* labels, vtkDataSetAttributes* cells,
  const std::function<void(const std::string&)>& warn);

}

#endif
