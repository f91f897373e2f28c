// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridPlaceRun.h"

#include "Core/Memory/Loops.h"
#include "Core/Solids/Hybrid/HybridPlaces.h"
#include "Private/Places/NearestPlaces.h"
#include "Private/Uniform/HybridSearch.h"
#include "Private/Uniform/PlaceResult.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numeric>
#include <string>

namespace subdivision
{
namespace
{

/// Finds places by the parameters that they have in cells of VTK.
template <typename Id>
class PlaceReader
{
public:
  PlaceReader(const HybridLevel<Id>& level, const std::vector<vtkIdType>& sources,
    vtkPointSet* input, const UniformOptions& options)
    : Complex(level.Complex)
    , Sources(sources)
    , Input(input)
    , Options(options)
    , Firsts(static_cast<std::size_t>(input->GetNumberOfCells()), -1)
    , Counts(Firsts.size(), 0)
  {
    for (const std::size_t c : InTurn(sources.size()))
    {
      this->Firsts[sources[c]] = static_cast<vtkIdType>(c);
      ++this->Counts[sources[c]];
    }
  }

  /// Sets the local corners of a tetrahedron of the input that is part of an octahedron, the fourth
  /// one at most after the first. Returns false if there is none.
  bool ReadQuarter(vtkIdType cell, int quarter, std::array<int, 4>& corners)
  {
    vtkIdType found = -1;
    const vtkIdType source = this->Sources[static_cast<std::size_t>(cell)] + quarter;
    if (this->Complex.Cells.Shapes[cell] != CellShape::Octahedron ||
      !this->FindCell(source, found).empty() || found != cell)
    {
      return false;
    }
    std::transform(this->Points->begin(), this->Points->end(), corners.begin(),
      [&](vtkIdType id) { return this->FindCorner(cell, id); });
    return true;
  }

  /// Gives a place the parameters and directions that its cell of the input has, if this is a cell
  /// of its own.
  PlaceInCell Describe(int quarter, HybridPlace& place)
  {
    PlaceInCell described;
    described.Cell = this->Sources[static_cast<std::size_t>(place.Cell)] + quarter;
    vtkIdType found = -1;
    if (this->FindCell(described.Cell, found).empty() && found == place.Cell)
    {
      described.Parameters = this->FindParameters(place);
      this->Locate(described.Parameters, place);
    }
    return described;
  }

  /// Returns false after an error.
  bool Read(
    const PlaceRequest& request, std::vector<HybridPlace>& places, std::vector<vtkIdType>& missing)
  {
    for (const vtkIdType i : InTurn(request.Cells->GetNumberOfTuples()))
    {
      HybridPlace place;
      bool isFinite = true;
      const vtkIdType cell = request.Cells->GetValue(i);
      std::string error = this->FindCell(cell, place.Cell);
      if (error.empty())
      {
        double at[3];
        request.Parameters->GetTuple(i, at);
        std::fill(at + this->Complex.Cells.GetTable(place.Cell).Dimension, at + 3, 0.);
        isFinite = std::isfinite(at[0] + at[1] + at[2]);
        if (!isFinite)
        {
          missing.push_back(i);
          std::fill_n(at, 3, 0.);
        }
        constexpr double rounding = 1e-9;
        if (!(this->Locate({ { at[0], at[1], at[2] } }, place) >= -rounding))
        {
          error = ", but outside of it: parameters are those of VTK, from 0 to 1, and the sum of "
                  "those that are weights of points is 1 at most. Correct them, or find the cell "
                  "of the point with a locator of VTK first.";
        }
      }
      if (!error.empty())
      {
        this->Options.Fail(
          "Place " + std::to_string(i) + " is in cell " + std::to_string(cell) + error);
        return false;
      }
      places.push_back(place);
    }
    WarnOfMissingPlaces(missing, "parameters", this->Options);
    return true;
  }

private:
  /// Finds the cell of the level that is a cell of the input, or the octahedron of which this is a
  /// piece. Returns the rest of an error message if there is none.
  std::string FindCell(vtkIdType cell, vtkIdType& found)
  {
    if (cell < 0 || cell >= this->Input->GetNumberOfCells())
    {
      return ": the input has no such cell.";
    }
    this->Input->GetCellPoints(cell, this->Points);
    const vtkIdType size = this->Points->GetNumberOfIds();
    const vtkIdType* ids = this->Points->GetPointer(0);
    for (vtkIdType c = cell; c >= 0 && c > cell - 4; --c)
    {
      found = this->Firsts[c];
      const bool isOne = this->Counts[c] == 1;
      const bool isOct = isOne && this->Complex.Cells.Shapes[found] == CellShape::Octahedron;
      const bool isPiece = isOct && size == 4 &&
        std::all_of(ids, ids + 4, [&](vtkIdType id) { return this->FindCorner(found, id) < 6; });
      const bool isOwn = c == cell && isOne && !isOct && !this->Complex.IsTwin(found) &&
        this->Complex.Cells.GetTable(found).Corners == size;
      if (isPiece || isOwn)
      {
        return {};
      }
    }
    return this->Counts[cell] == 0
      ? ", which was left out, as warnings say."
      : ", which is no cell of its own: it equals an earlier one, or the filter makes other "
        "cells of it. Take places in other cells, or the Subdivision Limit Probe, which takes "
        "points.";
  }
  int FindCorner(vtkIdType found, vtkIdType point) const
  {
    const Id* corners = this->Complex.Cells.GetCorners(found);
    const int size = this->Complex.Cells.GetTable(found).Corners;
    return static_cast<int>(std::find(corners, corners + size, static_cast<Id>(point)) - corners);
  }

  /// Sets where a place is. Returns how far inside of its cell that is.
  double Locate(const FramePoint& at, HybridPlace& place)
  {
    const CellShape shape = this->Complex.Cells.Shapes[place.Cell];
    place.At = at;
    place.Directions = { { { { 1., 0., 0. } }, { { 0., 1., 0. } }, { { 0., 0., 1. } } } };
    if (shape == CellShape::Pyramid)
    {
      // The square becomes smaller towards the apex.
      const double size = 1. - at[2];
      place.At = { { size * at[0], size * at[1], at[2] } };
      place.Directions = { { { { size, 0., 0. } }, { { 0., size, 0. } },
        { { -at[0], -at[1], 1. } } } };
      return Measure(CellShape::Hex, at);
    }
    if (shape != CellShape::Octahedron)
    {
      return Measure(shape, at);
    }
    const std::vector<FramePoint> corners = this->GetQuarterCorners(place.Cell);
    place.At = corners[0];
    for (std::size_t p = 0; p < 3; ++p)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        place.Directions[p][k] = corners[p + 1][k] - corners[0][k];
        place.At[k] += at[p] * place.Directions[p][k];
      }
    }
    return Measure(CellShape::Tet, at);
  }
  /// The inverse of Locate.
  FramePoint FindParameters(const HybridPlace& place) const
  {
    const CellShape shape = this->Complex.Cells.Shapes[place.Cell];
    const FramePoint& at = place.At;
    if (shape == CellShape::Pyramid)
    {
      const double size = 1. - at[2];
      return size > 0. ? FramePoint{ { at[0] / size, at[1] / size, at[2] } } : at;
    }
    if (shape != CellShape::Octahedron)
    {
      return at;
    }
    const auto shares =
      ShareCorners(CellShape::Tet, this->GetQuarterCorners(place.Cell), at).Values;
    return { { shares[1], shares[2], shares[3] } };
  }
  /// Where the points of the cell of the input are in an octahedron.
  std::vector<FramePoint> GetQuarterCorners(vtkIdType cell) const
  {
    const std::vector<FramePoint> all = GetFrameCorners(CellShape::Octahedron);
    std::vector<FramePoint> corners;
    for (vtkIdType i = 0; i < 4; ++i)
    {
      corners.push_back(
        all[static_cast<std::size_t>(this->FindCorner(cell, this->Points->GetId(i)))]);
    }
    return corners;
  }

  static double Measure(CellShape shape, const FramePoint& at)
  {
    return ShareCorners(shape, GetFrameCorners(shape), at).Least;
  }

  const CellComplex<Id>& Complex;
  const std::vector<vtkIdType>& Sources;
  vtkPointSet* Input;
  const UniformOptions& Options;
  std::vector<vtkIdType> Firsts; ///< a cell of the level for each of the input
  std::vector<vtkIdType> Counts; ///< how many there are
  vtkNew<vtkIdList> Points;      ///< of a cell
};

/// Few places at a time, so that their rows take little memory.
template <typename Id, typename Use>
void ForParts(HybridPlaceLimits<Id>& limits, const std::vector<HybridPlace>& places,
  PlaceDerivatives derivatives, const Use& use)
{
  constexpr std::size_t most = 1024;
  for (std::size_t begin = 0; begin < places.size(); begin += most)
  {
    const auto first = places.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto size = std::min(most, places.size() - begin);
    use(static_cast<vtkIdType>(begin),
      limits.Find({ first, first + static_cast<std::ptrdiff_t>(size) }, derivatives));
    BetweenLoops::Act();
  }
}

/// The limits at places of a search. Places of a cell are looked at together: they share patches.
template <typename Id>
PlaceValues EvaluateInOrder(const HybridSearch<Id>& search, HybridPlaceLimits<Id>& limits,
  const std::vector<NearestPlace>& nearest, bool valuesOnly, const double* coordinates)
{
  std::vector<std::size_t> order(nearest.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return nearest[a].Cell < nearest[b].Cell; });
  std::vector<HybridPlace> places;
  std::transform(order.begin(), order.end(), std::back_inserter(places),
    [&](std::size_t i) { return search.MakePlace(nearest[i]); });
  PlaceValues values(nearest.size());
  ForParts(limits, places, valuesOnly ? PlaceDerivatives::None : PlaceDerivatives::Second,
    [&](vtkIdType begin, const PlaceRows<Id>& rows)
    {
      ForEach(rows.GetNumberOfPlaces(),
        [&](vtkIdType i) { values[order[begin + i]] = SumParts(rows, i, coordinates); });
    });
  return values;
}

/// Finds the places that are nearest to points. `found` gets arrays that say where they are.
/// Returns false after an error.
template <typename Id>
bool FindNearest(PlaceReader<Id>& reader, const HybridLevel<Id>& level, vtkPointSet* input,
  const UniformOptions& options, const double* coordinates, HybridPlaceLimits<Id>& limits,
  std::vector<HybridPlace>& places, std::vector<vtkIdType>& missing, vtkPolyData* found)
{
  vtkDataSet* given = options.Places->Targets;
  std::vector<std::array<double, 3>> targets(static_cast<std::size_t>(given->GetNumberOfPoints()));
  for (const vtkIdType i : InTurn(given->GetNumberOfPoints()))
  {
    given->GetPoint(i, targets[i].data());
  }
  const HybridSearch<Id> search(level.Complex,
    [&reader](vtkIdType cell, int quarter, std::array<int, 4>& corners)
    { return reader.ReadQuarter(cell, quarter, corners); });
  std::unique_ptr<SolidPieces> solids;
  if (search.HasSolids())
  {
    UniformOptions ofFine = options;
    ofFine.Places = nullptr;
    ofFine.Levels = HybridSearch<Id>::Levels;
    ofFine.Warn = [](const std::string&) {}; // this run has told all
    vtkNew<vtkUnstructuredGrid> fine;
    if (!RefineKeepingTypes(input, ofFine, fine))
    {
      return false;
    }
    solids = search.MakePieces(fine);
  }
  const SearchedCells cells = search.GetCells();
  const std::vector<NearestPlace> nearest = FindNearestPlaces(cells, solids.get(), targets,
    [&](const std::vector<NearestPlace>& asked, bool valuesOnly)
    { return EvaluateInOrder(search, limits, asked, valuesOnly, coordinates); });
  if (!CheckNearestPlaces(nearest, cells.GetNumberOfCells() > 0, options, missing))
  {
    return false;
  }
  std::vector<PlaceInCell> inCells;
  for (const NearestPlace& one : InTurn(nearest))
  {
    places.push_back(one.Cell < 0 ? HybridPlace() : search.MakePlace(one));
    inCells.push_back(
      one.Cell < 0 ? PlaceInCell() : reader.Describe(search.GetQuarter(one), places.back()));
  }
  AddNearestArrays(nearest, inCells, found);
  return true;
}

}

template <typename Id>
bool FindPlacesKeepingTypes(const HybridLevel<Id>& level, const std::vector<vtkIdType>& sources,
  vtkPointSet* input, const UniformOptions& options, PointArrays& points)
{
  const PlaceRequest& request = *options.Places;
  std::vector<HybridPlace> places;
  std::vector<vtkIdType> missing;
  vtkNew<vtkPolyData> found;
  PlaceReader<Id> reader(level, sources, input, options);
  HybridPlaceLimits<Id> limits(level);
  const bool isRead = request.Targets
    ? FindNearest(reader, level, input, options, points.GetCoordinates(), limits, places, missing,
        found.Get())
    : reader.Read(request, places, missing);
  if (!isRead)
  {
    return false;
  }
  WritePlaces(
    request, static_cast<vtkIdType>(places.size()), missing, [&](const auto& use)
    { ForParts(limits, places, request.GetDerivatives(), use); }, [&](vtkIdType i)
    { return level.Complex.Cells.GetTable(places[static_cast<std::size_t>(i)].Cell).Dimension; },
    [&](vtkIdType i)
    {
      const HybridPlace& place = places[static_cast<std::size_t>(i)];
      const CellShape shape = level.Complex.Cells.Shapes[place.Cell];
      const auto shares = ShareCorners(shape, GetFrameCorners(shape), place.At).Values;
      const auto most = std::max_element(shares.begin(), shares.end()) - shares.begin();
      return static_cast<vtkIdType>(level.Complex.Cells.GetCorners(place.Cell)[most]);
    },
    points, found);
  return true;
}

SUBDIVISION_COMPILE_FUNCTION(FindPlacesKeepingTypes);

}
