// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartsAsCells.h
 * Parts of cells as cells of their own, one step (of sqrt(3) two) deeper.
 *
 * A cell whose edges are halved looks the same on each level: the inside of its edges and faces
 * repeats at half the size. So the next step has the rows of the last one, at other places, and
 * needs no mesh that is split once more (Mathematics 14). Rows of sqrt(3) reach beyond the
 * neighbours of a cell, so that a further step has other rows. There the parts are cut out of the
 * mesh, with the cells on which their limits depend, and are split as a mesh of their own.
 */
#ifndef SubdivisionObjects_PartsAsCells_h
#define SubdivisionObjects_PartsAsCells_h

#include "Private/Bounds/NestedPieces.h"
#include "Private/Bounds/Sectors.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <vector>

class vtkPointSet;
class vtkPolyData;

namespace subdivision
{

/// Cells, their sectors, and the last of their steps.
struct SteppedPieces
{
  const NestedPieces& Pieces;
  const Sectors& AllSectors;
  Sectors::Step Last;
};

class PartsAsCells
{
public:
  /// A child of a cell (PieceLattice::Children).
  struct Part
  {
    vtkIdType Cell;
    int Child;
    bool operator<(const Part& other) const
    {
      return this->Cell < other.Cell || (this->Cell == other.Cell && this->Child < other.Child);
    }
    bool operator==(const Part& other) const
    {
      return this->Cell == other.Cell && this->Child == other.Child;
    }
  };
  /// For each point that is a corner of a cell, a place in the cells before.
  struct Corner
  {
    vtkIdType Cell;
    int Point; ///< of its lattice
  };

  PartsAsCells(const PartsAsCells&) = delete;
  PartsAsCells& operator=(const PartsAsCells&) = delete;
  virtual ~PartsAsCells() = default;

  SteppedPieces Get() const { return { *this->Pieces, *this->AllSectors, this->Last }; }
  /// The cells that wanted parts are.
  const std::vector<vtkIdType>& GetWanted() const { return this->Wanted; }
  const std::vector<Corner>& GetCorners() const { return this->Corners; }
  /// Values at the points after step 1 or 2, from values at the points before.
  Buffer<double> Take(int step, const Buffer<double>& values, int components) const;

protected:
  explicit PartsAsCells(const SteppedPieces& from)
    : From(from)
  {
  }
  const NestedPieces::Lattice& GetLattice(const Part& part) const
  {
    return this->From.Pieces.GetLattice(part.Cell);
  }
  /// The point before that a point of a part is; -1 if it was not there.
  vtkIdType GetOld(const Part& part, int point) const
  {
    const int old = this->GetLattice(part).FindOfChild(part.Child, point);
    return old < 0 ? -1
                   : this->From.Pieces.GetPoint(this->From.Pieces.GetFirstPlace(part.Cell) + old);
  }
  vtkIdType GetOldCorner(const Part& part, int corner) const
  {
    return this->GetOld(part, this->GetLattice(part).CornerPoints[corner]);
  }
  /// Lists the wanted parts, each with all quarters of its octahedron, and after them the other
  /// parts that have a corner with a wanted one in common.
  void ListParts(const std::vector<Part>& wanted);
  /// To be called when there are pieces: part p is the cell cells[p].
  void Finish(const std::vector<vtkIdType>& cells, const Sectors::Step& last);

  const SteppedPieces From;
  std::vector<Part> Parts;
  std::unique_ptr<NestedPieces> Pieces;

private:
  std::vector<vtkIdType> Wanted; ///< numbers of parts, until Finish
  std::vector<Corner> Corners;
  std::vector<vtkIdType> Old; ///< which point before each one is that was there before step 3
  Sectors::Step Last;
  std::unique_ptr<Sectors> AllSectors;
};

/// Makes parts of cells deeper. Returns null after an error, or a stop.
using SplitCells = std::function<std::unique_ptr<PartsAsCells>(
  const SteppedPieces& from, const std::vector<PartsAsCells::Part>& wanted)>;

/// A row is not a number where it may read a point that these cells lack. Wanted cells depend on no
/// such row, unless a rule reads beyond cells that meet.
std::unique_ptr<PartsAsCells> SplitIntoHalves(
  const SteppedPieces& from, const std::vector<PartsAsCells::Part>& wanted);

/// The cell array of a patch that tells which vertices and lines are singular.
constexpr const char* PatchSingularName = "Singular";
/// Splits a patch. Returns null after an error, or a stop.
using SubdividePatch = std::function<vtkSmartPointer<vtkPointSet>(
  vtkPolyData* patch, int levels, MatrixFactors* factors)>;

/// Returns null where `subdivide` does.
std::unique_ptr<PartsAsCells> SplitIntoThirds(const SteppedPieces& from,
  const std::vector<PartsAsCells::Part>& wanted, const SubdividePatch& subdivide);

}

#endif
