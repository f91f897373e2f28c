// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NestedPieces.h
 * The cells of a mesh that is split uniformly, and the pieces that three further steps split them
 * into.
 */
#ifndef SubdivisionObjects_NestedPieces_h
#define SubdivisionObjects_NestedPieces_h

#include "Core/Memory/Buffer.h"
#include "Private/Bezier/PatchShape.h"

#include <array>
#include <vector>

class vtkPointSet;

namespace subdivision
{

class BezierRoots;

class NestedPieces
{
public:
  static constexpr int Steps = 3;
  static constexpr int MostCorners = 4;
  using Weights = std::array<double, MostCorners>;
  /// Some corners of a cell, a bit for each. Those of a vertex, an edge, a face or all are a face.
  using Mask = unsigned;

  /// The points of a cell after all steps, and its pieces.
  struct Lattice
  {
    int Dimension = 0;
    int Corners = 1;
    std::vector<Weights> Points; ///< each as weights of the corners of the cell
    std::vector<Mask> Faces;     ///< which face each point is inside of
    std::vector<std::vector<int>>
      Neighbours;            ///< the points of the pieces at each point, itself too
    std::vector<int> Pieces; ///< the points of each piece, one after the other

    int GetNumberOfPieces() const { return static_cast<int>(this->Pieces.size()) / this->Corners; }
    Mask GetWhole() const { return (1U << this->Corners) - 1U; }
    /// The smallest face that has some corners.
    Mask Close(Mask corners) const;
  };

  /// `fine` is the mesh after the steps, `points` the numbers of points before, after one, two, and
  /// all steps.
  NestedPieces(vtkPointSet* fine, const std::array<vtkIdType, Steps + 1>& points);

  /// Whether these are the cells of `mesh`, in its order.
  bool AreOf(vtkPointSet* mesh) const;
  bool HasTets() const { return this->Has[PatchShape::Tetrahedron]; }
  bool HasQuads() const { return this->Has[PatchShape::Quad]; }

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Kinds.size()); }
  int GetNumberOfCorners(vtkIdType cell) const { return this->GetLattice(cell).Corners; }
  vtkIdType GetCorner(vtkIdType cell, int corner) const
  {
    return this->CellCorners[MostCorners * cell + corner];
  }

  int GetDimension(vtkIdType cell) const { return this->GetLattice(cell).Dimension; }
  const Lattice& GetLattice(vtkIdType cell) const { return this->Lattices[this->Kinds[cell] + 1]; }

  /// A place is a point of a cell after all steps: those of a cell are from GetFirstPlace(cell) to
  /// before that of the next cell, in the order of its lattice.
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
  void ReadCells(const BezierRoots& roots);
  void ReadPlaces(const BezierRoots& roots);
  void FindParents(const BezierRoots& roots, int step);

  std::array<vtkIdType, Steps + 1> Points;
  std::vector<signed char> Kinds; ///< a PatchShape::Kind; -1: a vertex
  std::vector<vtkIdType> CellCorners;
  std::vector<vtkIdType> FirstPlaces; ///< of each cell, and one past the last
  Buffer<vtkIdType> PlacePoints;
  std::array<Buffer<vtkIdType>, Steps + 1> Parents; ///< of the points of the last two steps
  std::array<Lattice, PatchShape::NumberOfKinds + 1> Lattices; ///< by kind + 1
  std::array<bool, PatchShape::NumberOfKinds> Has{};
  bool IsNested = true;
};

}

#endif
