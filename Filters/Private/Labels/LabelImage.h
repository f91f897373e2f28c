// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelImage.h
 * A grid of voxels with a label each, and how blocks of voxels become one.
 */
#ifndef SubdivisionObjects_LabelImage_h
#define SubdivisionObjects_LabelImage_h

#include "Core/Memory/Buffer.h"

#include "vtkType.h"

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
  std::vector<double> Labels; ///< ascending, each of them in the image
  vtkIdType NumberOfMaterialVoxels = 0;

  vtkIdType GetId(vtkIdType i, vtkIdType j, vtkIdType k) const
  {
    return i + this->Size[0] * (j + this->Size[1] * k);
  }
};

/// Sets Voxels and Labels of an image whose Size is set. Voxels where isHidden says so are
/// background. Returns an error message if a value is no integer.
std::string ReadLabels(vtkDataArray* array, double background,
  const std::function<bool(vtkIdType)>& isHidden, LabelImage& image);

/// Makes one voxel of each block of `length`^3: of the label that most of its voxels have. Where
/// labels have equally many, materials come before background, then the smallest label wins. What a
/// block has beyond the image is background. Labels are those of `image`, also where none is left.
LabelImage Coarsen(const LabelImage& image, int length);

/// The smallest length of blocks that leaves at most `wanted` voxels of materials; 1 if `wanted`
/// is 0.
int FindBlockLength(const LabelImage& image, vtkIdType wanted);

/// Adds to `cells` the arrays of `voxels` but `labels`, ids and ghosts, a tuple for each voxel of
/// `coarse` that is no background: of floating point arrays the mean over the voxels of the block
/// that have its label, of others the tuple of the first of these.
void CopyVoxelArrays(const LabelImage& fine, const LabelImage& coarse, int length,
  vtkDataSetAttributes* voxels, vtkDataArray* labels, vtkDataSetAttributes* cells,
  const std::function<void(const std::string&)>& warn);

}

#endif
