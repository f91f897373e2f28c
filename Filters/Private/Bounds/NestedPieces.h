// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NestedPieces.h
 * The cells of a mesh that is split uniformly, and the pieces that three further steps split them
 * into.
 */
#ifndef SubdivisionObjects_NestedPieces_h
#define SubdivisionObjects_NestedPieces_h

#include "Core/Memory/Buffer.h"
#include "Private/Bounds/PieceLattice.h"

#include <algorithm>
#include <array>
#include <vector>

class vtkPointSet;

namespace subdivision
{

class SplitRoots;

class NestedPieces
{
public:
  using Lattice = PieceLattice;
  using Weights = Lattice::Weights;
  using Mask = Lattice::Mask;
  static constexpr int Steps = Lattice::Steps;
  static constexpr int MostCorners = Lattice::MostCorners;

  /// `fine` is the mesh after the steps, `points` the numbers of points before, after one, two, and
  /// all steps. `before`: the mesh before these if its scheme is tet/oct. There are no cells if
  /// some cell was not split in all steps.
  NestedPieces(vtkPointSet* fine, const std::array<vtkIdType, Steps + 1>& points,
    vtkPointSet* before = nullptr);

  /// `kinds` has the kind of each cell (PieceLattice::Get), `placePoints` the points of all cells,
  /// each in the order of its lattice.
  NestedPieces(const std::vector<int>& kinds, Buffer<vtkIdType> placePoints,
    const std::array<vtkIdType, Steps + 1>& points);

  /// Whether these are the cells of `mesh`, in its order. Corners of tet/oct tetrahedra may have
  /// another one.
  bool AreOf(vtkPointSet* mesh) const;
  bool HasTets() const
  {
    return this->Has[PatchShape::Tetrahedron] ||
      std::any_of(this->Has.begin() + Lattice::TetOctTetrahedron, this->Has.end(),
        [](bool has) { return has; });
  }
  /// Whether edges are cut into thirds.
  bool HasThirds() const
  {
    return this->Has[Lattice::CurveInThirds] || this->Has[Lattice::TriangleInThirds];
  }
  bool HasQuads() const { return this->Has[PatchShape::Quad]; }

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Kinds.size()); }
  int GetNumberOfCorners(vtkIdType cell) const { return this->GetLattice(cell).Corners; }
  vtkIdType GetCorner(vtkIdType cell, int corner) const
  {
    return this->GetPoint(this->FirstPlaces[cell] + this->GetLattice(cell).CornerPoints[corner]);
  }

  int GetDimension(vtkIdType cell) const { return this->GetLattice(cell).Dimension; }
  int GetKind(vtkIdType cell) const { return this->Kinds[cell]; }
  /// The first quarter of an octahedron that a cell is a quarter of; of others the cell itself.
  vtkIdType GetFirstQuarter(vtkIdType cell) const
  {
    return cell - std::max(0, this->Kinds[cell] - Lattice::FirstQuarter);
  }
  const Lattice& GetLattice(vtkIdType cell) const { return *this->Lattices[this->Kinds[cell] + 1]; }

  /// A place is a point of a cell after all steps: a cell has places from GetFirstPlace(cell) to
  /// before the first one of the next cell, in the order of its lattice.
  vtkIdType GetNumberOfPlaces() const { return this->PlacePoints.size(); }
  vtkIdType GetFirstPlace(vtkIdType cell) const { return this->FirstPlaces[cell]; }
  vtkIdType GetPoint(vtkIdType place) const { return this->PlacePoints[place]; }

  vtkIdType GetNumberOfPoints(int step) const { return this->Points[step]; }
  /// The points in whose middle a point is that step 2 or 3 made; -1 behind the last one, all -1 if
  /// no cell has it.
  const vtkIdType* GetParents(int step, vtkIdType point) const
  {
    return this->Parents[step].data() + MostCorners * (point - this->Points[step - 1]);
  }

private:
  void ReadCells(const SplitRoots& roots, vtkPointSet* before);
  void AddCell(int kind);
  void ReadPlaces(const SplitRoots& roots);
  void ReadTetOct(const SplitRoots& roots, vtkPointSet* fine, vtkPointSet* before);
  void AlignEqualTets();
  void FindParents();

  std::array<vtkIdType, Steps + 1> Points;
  std::vector<signed char> Kinds;             ///< as PieceLattice::Get has them
  std::vector<vtkIdType> FirstPlaces = { 0 }; ///< of each cell, and one past the last
  Buffer<vtkIdType> PlacePoints;
  std::array<Buffer<vtkIdType>, Steps + 1> Parents; ///< of the points of the last two steps
  std::array<const Lattice*, Lattice::NumberOfKinds + 1> Lattices; ///< by kind + 1
  std::array<bool, Lattice::NumberOfKinds> Has{};
};

}

#endif
