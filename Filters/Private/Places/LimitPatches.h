// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitPatches.h
 * Where on curves and surfaces the limit is nearest to points, among all places.
 *
 * Over most parts of a cell the limit is a polynomial. Each cell that may have the nearest place of
 * a point gets the polynomial that is the limit at a lattice. A finer lattice tells how far it is
 * from the limit elsewhere; where that is more than rounding the cell is split, as often as some
 * point needs. The squared distance from a polynomial is a polynomial, whose least value is found
 * for certain (PatchMinimum.h).
 */
#ifndef SubdivisionObjects_LimitPatches_h
#define SubdivisionObjects_LimitPatches_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/Box.h"
#include "Private/Places/NearestPlaces.h"
#include "Private/Places/PatchMinimum.h"

#include <array>
#include <vector>

namespace subdivision
{

class LimitPatches
{
public:
  /// Both must outlive this. Cells of solids have no patches.
  LimitPatches(const SearchedCells& cells, const EvaluatePlaces& evaluate);

  /// The places at which searches for each point begin: the nearest one, to within 1e-6 of the size
  /// of all patches, and places in other cells that may be nearer still. Of equally near ones the
  /// one in the cell with the smallest number is the first. None without patches, and for a point
  /// that is not finite. A point from which more than ten thousand patches are nearly equally far
  /// may get another of these.
  std::vector<std::vector<NearestPlace>> Find(const std::vector<std::array<double, 3>>& points);

  /// A point from which the same place is the nearest one, but for rounding, and whose distance can
  /// be squared: itself unless it is very far away.
  std::array<double, 3> Approach(const std::array<double, 3>& point) const;

  /// How large all patches together are.
  double GetSize() const { return this->Size; }

private:
  using Vector = std::array<double, 3>;
  /// Values at the points of a lattice, by the numbers that PatchFactors have.
  using Lattice = std::array<Vector, PatchSide * PatchSide>;
  struct Patch
  {
    vtkIdType Cell = -1;
    PatchFrame Frame = WholePatch;
    Box Bounds; ///< of the limit over it; a guess until it is known
    bool IsKnown = false;
    bool IsFinal = false;
    double Margin = 0.;          ///< how far the limit may be from the polynomial
    std::vector<Vector> Nodes;   ///< limits, as PatchShape lists them
    std::vector<Vector> Factors; ///< the polynomial, likewise
    std::vector<Vector> Corners; ///< limits at the corners of a cell
    vtkIdType Children = -1;     ///< the first of them
    int Splits = 0;
  };
  struct Search;
  struct Shape;
  static const Shape& GetShape(PatchKind kind);
  PatchKind GetKind(vtkIdType cell) const;
  NearestPlace MakePlace(vtkIdType cell, const std::array<double, 2>& at) const;
  Vector Normalize(const Vector& x) const;
  std::vector<Vector> FindCorners();
  void MakeRoots();
  void SortRoots();
  void Split(const std::vector<vtkIdType>& patches);
  void TakeValues(vtkIdType number, const Lattice& values);
  void AddChildren(vtkIdType number, const Lattice& values);
  void Fit(Patch& patch) const;
  void Visit(std::size_t level, vtkIdType node, Search& search) const;
  void VisitPatch(vtkIdType number, Search& search) const;

  const SearchedCells& Cells;
  const EvaluatePlaces& Evaluate;
  Vector Middle{};  ///< of all patches
  double Size = 1.; ///< and how large they are; patches have this size 1
  /// The distance that a polynomial may have, as searches go on from places: a fraction of the
  /// size, or the rounding of limits.
  double Enough = 1e-6;
  std::vector<Patch> Patches;
  Buffer<vtkIdType> Order;         ///< of cells with patches along a curve
  std::vector<Buffer<Box>> Levels; ///< boxes of four patches each, then of four boxes each
};

}

#endif
