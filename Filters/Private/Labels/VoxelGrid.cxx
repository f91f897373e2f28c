// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/VoxelGrid.h"

#include "Core/Memory/Loops.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

std::array<vtkIdType, 3> GetStructuredSize(vtkDataSet* data)
{
  int size[3] = { 0, 0, 0 };
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(size);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    std::copy_n(rectilinear->GetDimensions(), 3, size);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetDimensions(size);
  }
  return { size[0], size[1], size[2] };
}

VoxelGrid::VoxelGrid(vtkDataSet* data, bool ofPoints, int length)
  : Data(data)
  , Points(GetStructuredSize(data))
  , First(ofPoints ? -.5 : 0.)
  , Length(length)
  , IsEven(vtkImageData::SafeDownCast(data) != nullptr)
{
  if (!this->IsEven)
  {
    return;
  }
  auto* image = vtkImageData::SafeDownCast(data);
  const int* extent = image->GetExtent();
  double first[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = extent[2 * axis] + this->First;
  }
  image->TransformContinuousIndexToPhysicalPoint(first, this->Origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    double next[3] = { first[0], first[1], first[2] };
    next[axis] += length;
    image->TransformContinuousIndexToPhysicalPoint(next, this->Axes[axis]);
    vtkMath::Subtract(this->Axes[axis], this->Origin, this->Axes[axis]);
  }
  this->VoxelVolume = vtkMath::Determinant3x3(this->Axes);
}

std::string VoxelGrid::FindFault()
{
  if (this->Points[0] * this->Points[1] * this->Points[2] != this->Data->GetNumberOfPoints())
  {
    return "The input does not have the number of points that its dimensions say.";
  }
  if (!this->IsEven && *std::min_element(this->Points.begin(), this->Points.end()) < 2)
  {
    return "The input has one point only along an axis: labels of grids need two or more along "
           "each, those of an image of points do not.";
  }
  if (!this->IsEven)
  {
    for (const vtkIdType i : InTurn(this->Data->GetNumberOfPoints()))
    {
      const double* x = this->Data->GetPoint(i);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        return "Point " + std::to_string(i) +
          " of the input is at no finite place: each point needs one, also a hidden point, because "
          "the sizes of voxels come from them.";
      }
    }
    this->VoxelVolume = this->MeasureMeanVoxel() * std::pow(this->Length, 3);
  }
  if (std::abs(this->VoxelVolume) > 0. && std::isfinite(this->VoxelVolume))
  {
    return std::string();
  }
  std::string spacing;
  if (auto* image = vtkImageData::SafeDownCast(this->Data))
  {
    const double* given = image->GetSpacing();
    spacing = ": the spacing is " + std::to_string(given[0]) + ", " + std::to_string(given[1]) +
      ", " + std::to_string(given[2]) + ", and each of these must be a finite number other than 0";
  }
  return "The voxels of the input have no volume" + spacing + ".";
}

double VoxelGrid::MeasureMeanVoxel() const
{
  const vtkIdType cells = this->First < 0. ? 0 : 1;
  double sum = 0.;
  std::array<vtkIdType, 3> at;
  Turns turns;
  for (at[2] = 0; at[2] < this->Points[2] - cells; ++at[2])
  {
    for (at[1] = 0; at[1] < this->Points[1] - cells; ++at[1])
    {
      for (at[0] = 0; at[0] < this->Points[0] - cells; ++at[0], turns.Next())
      {
        sum += this->MeasureBox(at, { 1, 1, 1 });
      }
    }
  }
  return sum /
    static_cast<double>(
      (this->Points[0] - cells) * (this->Points[1] - cells) * (this->Points[2] - cells));
}

void VoxelGrid::Place(const Vector& corner, double* point) const
{
  if (!this->IsEven)
  {
    this->PlaceIndex(
      { this->First + this->Length * corner[0], this->First + this->Length * corner[1],
        this->First + this->Length * corner[2] },
      point);
    return;
  }
  for (int c = 0; c < 3; ++c)
  {
    point[c] = this->Origin[c] + corner[0] * this->Axes[0][c] + corner[1] * this->Axes[1][c] +
      corner[2] * this->Axes[2][c];
  }
}

void VoxelGrid::PlaceIndex(const Vector& index, double* point) const
{
  vtkIdType low[3];
  double part[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = static_cast<double>(this->Points[axis] - 2);
    low[axis] = static_cast<vtkIdType>(std::clamp(std::floor(index[axis]), 0., last));
    part[axis] = index[axis] - static_cast<double>(low[axis]);
  }
  std::fill_n(point, 3, 0.);
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.;
    vtkIdType at[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int high = corner >> axis & 1;
      at[axis] = low[axis] + high;
      weight *= high ? part[axis] : 1. - part[axis];
    }
    double x[3];
    this->Data->GetPoint(at[0] + this->Points[0] * (at[1] + this->Points[1] * at[2]), x);
    for (int c = 0; c < 3; ++c)
    {
      point[c] += weight * x[c];
    }
  }
}

/// The volume of the six tetrahedra around the diagonal of a box of voxels.
double VoxelGrid::MeasureBox(
  const std::array<vtkIdType, 3>& first, const std::array<vtkIdType, 3>& extent) const
{
  double corners[8][3];
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector index;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = this->First + static_cast<double>(first[axis]) +
        static_cast<double>((corner >> axis & 1) * extent[axis]);
    }
    this->PlaceIndex(index, corners[corner]);
  }
  constexpr int paths[6][2] = { { 1, 3 }, { 3, 2 }, { 2, 6 }, { 6, 4 }, { 4, 5 }, { 5, 1 } };
  double volume = 0.;
  for (const auto& path : paths)
  {
    double edges[3][3];
    vtkMath::Subtract(corners[path[0]], corners[0], edges[0]);
    vtkMath::Subtract(corners[path[1]], corners[0], edges[1]);
    vtkMath::Subtract(corners[7], corners[0], edges[2]);
    volume += vtkMath::Determinant3x3(edges) / 6.;
  }
  return volume;
}

double VoxelGrid::GetShare(
  const std::array<vtkIdType, 3>& first, const std::array<vtkIdType, 3>& extent) const
{
  return this->IsEven
    ? static_cast<double>(extent[0] * extent[1] * extent[2]) / std::pow(this->Length, 3)
    : this->MeasureBox(first, extent) / this->VoxelVolume;
}

}
