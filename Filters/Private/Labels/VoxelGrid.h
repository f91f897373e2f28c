// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelGrid.h
 * Where the voxels of an image, or of a rectilinear or structured grid, are in space.
 */
#ifndef SubdivisionObjects_VoxelGrid_h
#define SubdivisionObjects_VoxelGrid_h

#include "vtkType.h"

#include <array>
#include <string>

class vtkDataSet;

namespace subdivision
{

/// The number of points of structured data along each axis.
std::array<vtkIdType, 3> GetStructuredSize(vtkDataSet* data);

/// Between points of the data positions are trilinear, beyond them linear.
class VoxelGrid
{
public:
  using Vector = std::array<double, 3>;

  /// Voxels are around the points of `data`, or its cells; `length` of them along each axis make a
  /// control voxel.
  VoxelGrid(vtkDataSet* data, bool ofPoints, int length);

  /// Returns an error message if voxels have no volume, or no place.
  std::string FindFault();
  /// Where a corner of control voxels is, counted in these from the first corner of all.
  void Place(const Vector& corner, double* point) const;
  /// The volume of a control voxel, negative in mirrored data: of all the same, or the mean. Call
  /// FindFault before.
  double GetVoxelVolume() const { return this->VoxelVolume; }
  /// The volume of a box of voxels of the data, in control voxels.
  double GetShare(
    const std::array<vtkIdType, 3>& first, const std::array<vtkIdType, 3>& extent) const;

private:
  void PlaceIndex(const Vector& index, double* point) const;
  double MeasureMeanVoxel() const;
  double MeasureBox(
    const std::array<vtkIdType, 3>& first, const std::array<vtkIdType, 3>& extent) const;

  vtkDataSet* Data;
  std::array<vtkIdType, 3> Points; ///< along each axis
  double First;                    ///< index of the first corner
  double Length;
  bool IsEven; ///< all voxels are alike: it is an image
  double VoxelVolume = 0.;
  double Origin[3]; ///< of an image
  double Axes[3][3];
};

}

#endif
