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

  /// `fine` is the mesh after the steps, `points` the numbers of points before, after one, two, and
  /// all steps.
  NestedPieces(vtkPointSet* fine, const std::array<vtkIdType, Steps + 1>& points);

  /// Whether these are the cells of `mesh`, in its order.
  bool AreOf(vtkPointSet* mesh) const;
  bool HasTets() const { return this->Has[PatchShape::Tetrahedron]; }
  bool HasQuads() const { return this->Has[PatchShape::Quad]; }

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Kinds.size()); }
  int GetNumberOfCorners(vtkIdType cell) const { return CountCorners(this->Kinds[cell]); }
  vtkIdType GetCorner(vtkIdType cell, int corner) const
  {
    return this->CellCorners[MostCorners * cell + corner];
  }

  /// The pieces of a cell after all steps are those from GetFirst(cell) to before that of the next
  /// cell. They have as many corners as the cell.
  vtkIdType GetNumberOfPieces() const { return this->Corners.size() / MostCorners; }
  vtkIdType GetFirst(vtkIdType cell) const { return this->Firsts[cell]; }
  /// The corners of a piece; -1 behind the last one.
  const vtkIdType* GetPiece(vtkIdType piece) const
  {
    return this->Corners.data() + MostCorners * piece;
  }
  /// Where a corner of a piece is, as weights of the corners of its cell.
  const Weights& GetWeights(vtkIdType cell, vtkIdType piece, int corner) const
  {
    return this
      ->Places[this->Kinds[cell] + 1][MostCorners * (piece - this->GetFirst(cell)) + corner];
  }

  vtkIdType GetNumberOfPoints(int step) const { return this->Points[step]; }
  /// The points in whose middle a point is that step 2 or 3 made; -1 behind the last one, all -1 if
  /// no cell has it.
  const vtkIdType* GetParents(int step, vtkIdType point) const
  {
    return this->Parents[step].data() + MostCorners * (point - this->Points[step - 1]);
  }

private:
  static int CountCorners(int kind)
  {
    return kind < 0 ? 1 : PatchShape::Get(static_cast<PatchShape::Kind>(kind)).Corners;
  }
  void ReadCells(const BezierRoots& roots);
  void ReadPieces(const BezierRoots& roots);
  void FindParents(const BezierRoots& roots, int step);

  std::array<vtkIdType, Steps + 1> Points;
  std::vector<signed char> Kinds; ///< a PatchShape::Kind; -1: a vertex
  std::vector<vtkIdType> CellCorners;
  std::vector<vtkIdType> Firsts; ///< of each cell, and one past the last
  Buffer<vtkIdType> Corners;
  std::array<Buffer<vtkIdType>, Steps + 1> Parents; ///< of the points of the last two steps
  std::array<std::vector<Weights>, PatchShape::NumberOfKinds + 1> Places; ///< by kind + 1
  std::array<bool, PatchShape::NumberOfKinds> Has{};
  bool IsNested = true;
};

}

#endif
