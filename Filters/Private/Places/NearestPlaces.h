// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearestPlaces.h
 * The places of a limit that are nearest to given points.
 *
 * For a point inside of a solid a fine level on the limit tells where to begin; for all others
 * patches of curves and surfaces do, among them the boundaries of solids (LimitPatches.h). From
 * there the squared distance is made smaller by steps of Newton's method, which stop at the border
 * of a cell. Where a search ends there, it goes on in the other cells at that place of the border.
 */
#ifndef SubdivisionObjects_NearestPlaces_h
#define SubdivisionObjects_NearestPlaces_h

#include "Core/Operators/PlaceParts.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

class vtkPolyData;

namespace subdivision
{

class SolidPieces;
struct RunOptions;

/// Where places are searched: a view of simplices, or of quads instead of triangles.
struct SearchedCells
{
  vtkIdType NumberOfPoints;
  const std::vector<unsigned char>& Dimensions;
  const std::vector<vtkIdType>& Connectivity; ///< of one cell after the other
  bool HasQuads;
  bool LacksSecond = false; ///< second derivatives may be 0 where they are not known

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Dimensions.size()); }
  bool IsQuad(vtkIdType cell) const { return this->HasQuads && this->Dimensions[cell] == 2; }
  int CountCorners(vtkIdType cell) const
  {
    return this->Dimensions[cell] + (this->IsQuad(cell) ? 2 : 1);
  }
};

struct NearestPlace
{
  vtkIdType Cell = -1;
  /// Of the corners of a simplex. In a quad x and y: 0 and 0 at its first corner, 1 and 0 at the
  /// second one.
  std::array<double, 4> Weights{};
  double Distance = std::numeric_limits<double>::infinity();
};

/// Gives the value and the derivatives (PlaceParts) of each place, three numbers each. With
/// `valuesOnly` nobody reads the latter.
using PlaceValues = std::vector<std::array<std::array<double, 3>, PlaceParts::Count>>;
using EvaluatePlaces =
  std::function<PlaceValues(const std::vector<NearestPlace>& places, bool valuesOnly)>;

/// The triangles on the boundary of solids are among `cells`, too. `solids`: null where there are
/// none. Points that are not finite get no cell.
std::vector<NearestPlace> FindNearestPlaces(const SearchedCells& cells, const SolidPieces* solids,
  const std::vector<std::array<double, 3>>& points, const EvaluatePlaces& evaluate);

/// Lists points that have no place, and warns of them. Returns false after an error, if there are
/// no cells.
bool CheckNearestPlaces(const std::vector<NearestPlace>& places, bool hasCells,
  const RunOptions& options, std::vector<vtkIdType>& missing);

/// A nearest place in the output.
struct PlaceInCell
{
  vtkIdType Cell = -1;                                   ///< of the input
  std::array<double, 3> Parameters{ { -1., -1., -1. } }; ///< -1: it has none of its own
};
/// Adds the arrays Distance, CellId and CellParameters.
void AddNearestArrays(const std::vector<NearestPlace>& places,
  const std::vector<PlaceInCell>& inCells, vtkPolyData* output);

}

#endif
