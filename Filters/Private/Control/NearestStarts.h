// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearestStarts.h
 * Where searches for nearest places begin (NearestPlaces.h): at the nearest flat piece of a fine
 * level, and in the cells beside it.
 *
 * At a crease, a corner or an extraordinary vertex each cell may have a place that is nearer than
 * all around it, and the flat pieces do not tell which of these places is the nearest one. So on
 * surfaces a search begins in each cell that has a piece beside the nearest piece, and nearly as
 * near; where pieces at a corner of a cell are not nearly in one plane, several do.
 */
#ifndef SubdivisionObjects_NearestStarts_h
#define SubdivisionObjects_NearestStarts_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/SimplexTree.h"
#include "Private/Control/NearestPlaces.h"

#include <array>
#include <vector>

namespace subdivision
{

/// A place in a part of a simplex as one of the simplex, by the number of the part after some steps
/// as the box spline splits it.
std::array<double, 4> LeavePartOfSimplex(
  int dimension, int levels, vtkIdType part, std::array<double, 4> weights);

class NearestStarts
{
public:
  /// As FindNearestPlaces. `cells` must outlive this.
  NearestStarts(const SearchedCells& cells, vtkDataSet* fine, int levels);

  /// Adds the places at which searches for a point begin, that of the nearest piece first; none if
  /// the point is not finite. Several threads may ask.
  void Find(const std::array<double, 3>& x, std::vector<NearestPlace>& starts) const;

private:
  /// A piece of a cell, or half of one that is a quad.
  struct Piece
  {
    vtkIdType Number;
    int Half; ///< of a quad: with its second corner, or its fourth one
  };
  /// Tetrahedra, or all others.
  struct Pieces
  {
    Buffer<int> Corners;
    std::vector<Piece> Numbers;
    SimplexTree Tree;
  };
  struct Found
  {
    const Pieces* Of = nullptr;
    PlaceInSimplex Place;
    double Distance2 = 0.;
  };
  vtkIdType FindCell(const Found& found) const;
  double FindSize(const Found& found) const;
  NearestPlace MakeStart(const Found& found) const;
  bool IsFlat(vtkIdType point) const;
  void AddAtCorner(
    const Found& found, const std::array<double, 3>& x, std::vector<NearestPlace>& starts) const;

  const SearchedCells& Cells;
  const int Levels;
  Buffer<vtkIdType> Firsts; ///< the number of the first piece of each cell
  Buffer<double> Points;    ///< of the fine level
  Pieces Kinds[2];
  Rows<vtkIdType> AtPoints; ///< of Kinds[1], by points of the fine level
};

}

#endif
