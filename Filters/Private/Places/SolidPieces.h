// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidPieces.h
 * Where searches for points inside of solids begin (NearestPlaces.h): in the flat piece of a fine
 * level that has the point.
 */
#ifndef SubdivisionObjects_SolidPieces_h
#define SubdivisionObjects_SolidPieces_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/Box.h"
#include "Core/Solids/Location/SimplexTree.h"
#include "Private/Places/NearestPlaces.h"

#include <array>
#include <vector>

namespace subdivision
{

/// A place in a part of a simplex as one of the simplex, by the number of the part after some steps
/// as the box spline splits it.
std::array<double, 4> LeavePartOfSimplex(
  int dimension, int levels, vtkIdType part, std::array<double, 4> weights);

class SolidPieces
{
public:
  /// As FindNearestPlaces.
  SolidPieces(const SearchedCells& cells, vtkDataSet* fine, int levels);

  /// Sets the place at which the search for a point begins. False: it lies in no piece, unless
  /// `isBeside`: then that is the nearest piece. Several threads may ask.
  bool Find(const std::array<double, 3>& x, bool isBeside, NearestPlace& start) const;

private:
  const int Levels;
  Buffer<vtkIdType> Firsts; ///< the number of the first piece of each cell
  Buffer<double> Points;    ///< of the fine level
  Buffer<int> Corners;      ///< of pieces of solids
  std::vector<vtkIdType> Numbers;
  SimplexTree Tree;
  Box All;
};

}

#endif
