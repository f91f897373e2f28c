// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridSearch.h
 * The cells of a level in which every cell keeps its type, as simplices in which nearest places are
 * searched (NearestPlaces.h).
 *
 * Each cell is cut in its own coordinates, in which the limit is the same, cut or not: a solid into
 * the tetrahedra between its smallest corner and the faces without this, a face by the diagonals
 * from its smallest corner, so that neighbours fit. The triangles on the boundary of solids follow.
 */
#ifndef SubdivisionObjects_HybridSearch_h
#define SubdivisionObjects_HybridSearch_h

#include "Core/Solids/Hybrid/HybridPlaces.h"
#include "Private/Places/NearestPlaces.h"
#include "Private/Places/SolidPieces.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

class vtkDataSet;

namespace subdivision
{

template <typename Id>
class HybridSearch
{
public:
  /// Sets the local corners of one of the four tetrahedra that an octahedron is in the input;
  /// false: the cell is none.
  using ReadQuarter = std::function<bool(vtkIdType cell, int quarter, std::array<int, 4>& corners)>;

  /// The complex has to live as long.
  HybridSearch(const CellComplex<Id>& complex, const ReadQuarter& readQuarter);

  SearchedCells GetCells() const
  {
    return { this->Complex.NumberOfVertices, this->Dimensions, this->Connectivity, false, true };
  }
  bool HasSolids() const { return this->Complex.NumberOfTets > 0; }
  HybridPlace MakePlace(const NearestPlace& nearest) const;
  /// Which of the tetrahedra of an octahedron has a place; 0 in other cells.
  int GetQuarter(const NearestPlace& nearest) const
  {
    return this->Parts[static_cast<std::size_t>(nearest.Cell)].Quarter;
  }

  static constexpr int Levels = 2;
  /// `fine`: the points of the level after two steps, on the limit. This has to live as long.
  std::unique_ptr<SolidPieces> MakePieces(vtkDataSet* fine) const;

private:
  /// A simplex of a cell.
  struct Part
  {
    vtkIdType Cell;
    int Quarter;
    std::array<FramePoint, 4> Corners;
  };
  void AddCell(vtkIdType cell, const ReadQuarter& readQuarter);
  void AddSides(vtkIdType cell);
  void Add(vtkIdType cell, int dimension, const std::array<int, 4>& corners, int quarter = 0);
  NearestPlace FindPlace(vtkIdType cell, const FramePoint& at) const;

  const CellComplex<Id>& Complex;
  std::vector<unsigned char> Dimensions;
  std::vector<vtkIdType> Connectivity;
  std::vector<Part> Parts;
  std::vector<std::size_t> Firsts; ///< the first part of each cell, and their end without sides
};

}

#endif
