// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeeperPieces.h
 * Parts of cells as cells of their own, one step deeper, without a mesh that is split once more.
 *
 * A cell looks the same on each level: the inside of its edges and faces repeats at half the size.
 * So the next step has the rows of the last one, at other places (Mathematics 14).
 */
#ifndef SubdivisionObjects_DeeperPieces_h
#define SubdivisionObjects_DeeperPieces_h

#include "Private/Bounds/DeeperCells.h"

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace subdivision
{

class DeeperPieces : public DeeperCells
{
public:
  /// Whole numbers for the corners of a cell.
  using Weights = std::array<int, NestedPieces::MostCorners>;

  /// The cells are `wanted`, each with all quarters of its octahedron, and after them the other
  /// parts at their points. A row is not a number where it may read a point that these cells lack.
  /// Wanted cells depend on no such row, unless a rule reads beyond cells that meet.
  DeeperPieces(const SteppedPieces& from, const std::vector<Part>& wanted);
  SteppedPieces Get() const override
  {
    return { *this->Pieces, *this->AllSectors, { &this->Last } };
  }

private:
  using Mask = NestedPieces::Mask;
  /// How a place is moved to one where its row is known.
  struct Shift
  {
    vtkIdType Cell;
    Mask Face;           ///< all cells that have it are alike there
    Weights Corners;     ///< how much of each corner is taken away
    LatticePoint Inside; ///< the same inside a quad
  };
  void ListParts(const std::vector<Part>& wanted);
  void AddParts(const std::vector<Part>& parts, std::map<Part, vtkIdType>& numbers);
  void NumberOldPoints();
  void NumberNewPoints();
  void FindPieces();
  void MakeRows();
  vtkIdType FindRow(const Part& part, int point, Shift& shift) const;
  bool Match(const Shift& shift, vtkIdType cell, Weights& corners) const;
  vtkIdType ShiftColumn(const Shift& shift, vtkIdType column) const;
  vtkIdType ShiftInOctahedron(vtkIdType place, vtkIdType quarter, const Weights& corners) const;
  vtkIdType FindNumber(vtkIdType old) const;
  const NestedPieces::Lattice& GetLattice(const Part& part) const
  {
    return this->From.Pieces.GetLattice(part.Cell);
  }
  /// The point before that is one of a part, and was there before the last step.
  vtkIdType GetOld(const Part& part, int point) const;

  const SteppedPieces From;
  std::vector<Part> Parts;
  std::vector<vtkIdType> FirstPlaces; ///< of each part
  Buffer<vtkIdType> PlacePoints;
  std::array<vtkIdType, NestedPieces::Steps + 1> Counts{};
  std::vector<std::pair<vtkIdType, vtkIdType>> NumbersOfOld; ///< ascending
  std::unique_ptr<NestedPieces> Pieces;
  MatrixFactors::Matrix Last;
  std::unique_ptr<Sectors> AllSectors;
};

}

#endif
