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
#include <functional>
#include <vector>

class vtkDataSet;

namespace subdivision
{

/// A place in a part of a simplex as one of the simplex, by the number of the part after some steps
/// as the box spline splits it.
std::array<double, 4> LeavePartOfSimplex(
  int dimension, int levels, vtkIdType part, std::array<double, 4> weights);

class SolidPieces
{
public:
  /// Sets where a place in a piece is, by the weights of its corners.
  using LocateInPiece =
    std::function<void(vtkIdType piece, const std::array<double, 4>& weights, NearestPlace& start)>;

  /// The pieces of simplices: the first cells of `fine`, after `levels` steps, projected to the
  /// limit; each in as many pieces as a step makes, one cell after the other. `cells` must outlive
  /// this.
  SolidPieces(const SearchedCells& cells, vtkDataSet* fine, int levels);
  /// Any pieces, each with the numbers of four points.
  SolidPieces(vtkDataSet* fine, const std::vector<int>& corners, LocateInPiece locate);

  /// Sets the place at which the search for a point begins. False: it lies in no piece, unless
  /// `isBeside`: then that is the nearest piece. Several threads may ask.
  bool Find(const std::array<double, 3>& x, bool isBeside, NearestPlace& start) const;

private:
  void Build(vtkDataSet* fine, const std::vector<int>& corners);

  LocateInPiece Locate;
  Buffer<double> Points; ///< of the fine level
  Buffer<int> Corners;   ///< of pieces of solids
  SimplexTree Tree;
  Box All;
};

}

#endif
