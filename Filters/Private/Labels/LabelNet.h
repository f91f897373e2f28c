// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelNet.h
 * The corners of voxels, moved so that the faces between labels get smooth and keep volumes.
 */
#ifndef SubdivisionObjects_LabelNet_h
#define SubdivisionObjects_LabelNet_h

#include "Core/Memory/Buffer.h"

#include "Private/Labels/LabelImage.h"

#include "vtkType.h"

#include <array>
#include <vector>

namespace subdivision
{

/// Lengths are in voxels: the corners of a voxel are one apart.
class LabelNet
{
public:
  using Vector = std::array<double, 3>;
  using Cell = std::array<vtkIdType, 8>;

  /// `largest`: how far a corner may be moved. `isFlat`: where a material touches the border of the
  /// image, corners stay there.
  LabelNet(const LabelImage& image, double largest, bool isFlat);

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Corners.size()); }
  /// The voxels of materials, in the order of the image, as VTK_HEXAHEDRON.
  const std::vector<Cell>& GetCells() const { return this->Cells; }
  /// The label of each cell, as the image numbers them.
  const std::vector<int>& GetCellLabels() const { return this->CellLabels; }

  /// With a flat border: the edges at which its faces end.
  const std::vector<std::array<vtkIdType, 2>>& GetBorderEdges() const { return this->BorderEdges; }

  /// Moves all corners by so many pairs of steps, one to the mean of the neighbours, and one away
  /// from it, by which the shape does not shrink (Taubin). Neighbours of a corner on an interface
  /// lie on interfaces, of one on a curve where interfaces meet on such curves.
  void Smooth(int steps);
  /// Takes a quarter of the smoothing back at the corners of cells.
  void Stiffen(const std::vector<vtkIdType>& cells);
  /// Where the corners are after the smallest move from the smoothed ones that gives the labels
  /// these volumes (in voxels, [0] is of the background and not read), as far as they may be moved.
  std::vector<Vector> HoldVolumes(const std::vector<double>& volumes) const;

private:
  using Vectors = std::vector<Vector>;
  /// A face between different labels; the normal of its corners points from Low to High.
  struct Face
  {
    std::array<vtkIdType, 4> Corners;
    int Low;
    int High;
  };

  void AddPoints();
  void AddCells();
  void AddFaces();
  int GetLabel(vtkIdType i, vtkIdType j, vtkIdType k) const;
  vtkIdType GetPlace(vtkIdType i, vtkIdType j, vtkIdType k) const
  {
    return i + this->Lines[0] * (j + this->Lines[1] * k);
  }
  void Step(double factor, bool isInside, const Vectors& from, Vectors& to) const;
  /// Where a corner is before it is smoothed: the image may end before or behind the last blocks.
  double GetRest(vtkIdType i, int axis) const;
  bool IsHeld(vtkIdType i, int axis) const { return this->Held[i] >> axis & 1; }
  Vector Limit(vtkIdType i, Vector move) const;
  std::vector<double> GetVolumes(const Vectors& moves, Vectors& areas) const;
  /// Of the pressures of labels: the moves of corners that they make; and by how much these change
  /// the volumes.
  Vectors Press(const Vectors& areas, const std::vector<double>& sizes,
    const std::vector<double>& pressures) const;
  std::vector<double> GetChange(const Vectors& areas, const Vectors& moves) const;
  /// The moves that change the volumes as wanted, if faces stay as they are.
  Vectors Solve(const Vectors& areas, const std::vector<double>& change) const;

  const LabelImage& Image;
  double Largest;
  bool IsFlat;
  std::array<vtkIdType, 3> Lines; ///< of corners along each axis
  Buffer<vtkIdType> Ids;          ///< of the point at each place; -1 in the background
  std::vector<std::array<int, 3>> Corners;
  std::vector<unsigned char> Directions; ///< bits of the neighbours: -x, x, -y, y, -z, z
  std::vector<unsigned char> Held;       ///< bits of the axes along which it does not move
  std::vector<unsigned char> IsInside;   ///< whether all voxels around have one label
  std::vector<Cell> Cells;
  std::vector<int> CellLabels;
  std::vector<Face> Faces;
  std::vector<std::array<vtkIdType, 2>> BorderEdges; ///< of points
  Vectors Smoothed;                                  ///< moves of corners
};

}

#endif
