// SPDX-License-Identifier: BSD-3-Clause
// The limit at places of cells, with derivatives.
#include "Private/Uniform/UniformRun.h"

#include "Core/Memory/Loops.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/PlaceLimits.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Places/NearestPlaces.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Places/SolidPieces.h"
#include "Private/Uniform/PlaceResult.h"
#include "Private/Uniform/StartPieces.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;

/// Gives a place the order of the points of its cell, which is one simplex.
template <typename Id>
void SetOrder(vtkIdList* points, LimitPlace<Id>& place)
{
  const auto first = place.Corners.begin();
  for (int k = 0; k <= place.Dimension; ++k)
  {
    place.Order[k] = static_cast<int>(
      std::find(first, first + place.Dimension, static_cast<Id>(points->GetId(k))) - first);
  }
}

/// Simplices, then the triangles on the boundary of their tetrahedra.
struct CellsAndSides
{
  explicit CellsAndSides(const SimplexList& simplices)
    : Dimensions(simplices.Dimensions)
    , Connectivity(simplices.Connectivity)
    , Size(simplices.GetNumberOfSimplices())
  {
    struct Side
    {
      std::array<vtkIdType, 3> Corners;
      vtkIdType Tet;
    };
    std::vector<Side> sides;
    const vtkIdType* corners = simplices.Connectivity.data();
    for (const vtkIdType s : InTurn(this->Size))
    {
      for (int k = 0; simplices.Dimensions[s] == 3 && k < 4; ++k)
      {
        Side side{ { { corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4] } }, s };
        std::sort(side.Corners.begin(), side.Corners.end());
        sides.push_back(side);
      }
      corners += simplices.Dimensions[s] + 1;
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b)
      { return a.Corners != b.Corners ? a.Corners < b.Corners : a.Tet < b.Tet; });
    for (std::size_t i = 0, next = 0; i < sides.size(); i = next)
    {
      while (next < sides.size() && sides[next].Corners == sides[i].Corners)
      {
        ++next;
      }
      if (next == i + 1)
      {
        this->Dimensions.push_back(2);
        this->Connectivity.insert(
          this->Connectivity.end(), sides[i].Corners.begin(), sides[i].Corners.end());
        this->Tets.push_back(sides[i].Tet);
      }
    }
  }
  /// `starts`: of the corners of simplices, and their end.
  const vtkIdType* GetCorners(vtkIdType cell, const std::vector<vtkIdType>& starts) const
  {
    return this->Connectivity.data() +
      (cell < this->Size ? starts[cell] : starts.back() + 3 * (cell - this->Size));
  }
  /// A place on the boundary becomes one of the tetrahedron there.
  void GoToSolid(
    const SimplexList& simplices, const std::vector<vtkIdType>& starts, NearestPlace& place) const
  {
    if (place.Cell < this->Size)
    {
      return;
    }
    const vtkIdType* of = this->GetCorners(place.Cell, starts);
    const vtkIdType tet = this->Tets[place.Cell - this->Size];
    const vtkIdType* corners = simplices.Connectivity.data() + starts[tet];
    std::array<double, 4> weights{};
    for (int k = 0; k < 3; ++k)
    {
      weights[std::find(corners, corners + 4, of[k]) - corners] = place.Weights[k];
    }
    place.Cell = tet;
    place.Weights = weights;
  }

  std::vector<unsigned char> Dimensions;
  std::vector<vtkIdType> Connectivity;
  const vtkIdType Size;        ///< how many simplices there are
  std::vector<vtkIdType> Tets; ///< of the triangles
};

/// Whether a place lies in its simplex, but for rounding.
template <typename Id>
bool IsInside(const LimitPlace<Id>& place)
{
  constexpr double rounding = 1e-9;
  const Vector& p = place.Parameters;
  return *std::min_element(p.begin(), p.end()) >= -rounding && p[0] + p[1] + p[2] <= 1. + rounding;
}

}

/// Finds the simplex of the cell of each place, and the order of its corners. Returns false, after
/// an error, if a cell has none of its own.
template <typename Id>
bool UniformRun::ReadPlaces(const PlaceRequest& request, std::vector<LimitPlace<Id>>& places,
  std::vector<vtkIdType>& missing) const
{
  const SimplexList& simplices = this->Mesh.Cells.Simplices;
  const auto& parents = this->Mesh.Cells.ParentCells;
  const vtkIdType cells = this->Input->GetNumberOfCells();
  std::vector<vtkIdType> starts(static_cast<std::size_t>(cells), -1); // of the simplices
  std::vector<int> counts(static_cast<std::size_t>(cells), 0);
  std::vector<int> dimensions(static_cast<std::size_t>(cells), 0);
  vtkIdType start = 0;
  for (const vtkIdType s : InTurn(simplices.GetNumberOfSimplices()))
  {
    const auto cell = static_cast<std::size_t>(parents.empty() ? s : parents[s]);
    starts[cell] = start;
    dimensions[cell] = simplices.Dimensions[s];
    ++counts[cell];
    start += simplices.Dimensions[s] + 1;
  }
  vtkNew<vtkIdList> points;
  for (const vtkIdType i : InTurn(request.Cells->GetNumberOfTuples()))
  {
    const vtkIdType cell = request.Cells->GetValue(i);
    if (cell < 0 || cell >= cells || counts[cell] != 1)
    {
      this->Options.Fail("Place " + std::to_string(i) + " is in cell " + std::to_string(cell) +
        (cell < 0 || cell >= cells ? ": the input has no such cell."
            : counts[cell] == 0
            ? ", which was left out, as warnings say."
            : ", which is no vertex, line, triangle or tetrahedron: the filter cuts it, and the "
              "pieces have other parameters. " +
              std::string(dimensions[cell] == 2
                  ? "Ask EvaluateLimit of vtkSurfaceSubdivision with Scheme = CatmullClark, which "
                    "has places in quads and polygons."
                  : "Use the Subdivision Limit Probe, which takes points.")));
      return false;
    }
    LimitPlace<Id> place;
    place.Dimension = dimensions[cell];
    this->Input->GetCellPoints(cell, points);
    const vtkIdType* corners = simplices.Connectivity.data() + starts[cell];
    for (int k = 0; k <= place.Dimension; ++k)
    {
      place.Corners[k] = static_cast<Id>(corners[k]);
    }
    SetOrder(points, place);
    bool isFinite = true;
    for (int k = 0; k < place.Dimension; ++k)
    {
      place.Parameters[k] = request.Parameters->GetComponent(i, k);
      isFinite = isFinite && std::isfinite(place.Parameters[k]);
    }
    if (!isFinite)
    {
      missing.push_back(i);
      place.Parameters = Vector{};
    }
    if (!IsInside(place))
    {
      this->Options.Fail("Place " + std::to_string(i) + " is outside of cell " +
        std::to_string(cell) +
        ": parameters are not negative, and their sum is 1 at most. Use the "
        "Subdivision Limit Probe for points of which the cell is not known.");
      return false;
    }
    places.push_back(place);
  }
  WarnOfMissingPlaces(missing, "parameters", this->Options);
  return true;
}

/// Finds the places that are nearest to points. `found` gets arrays that say where they are.
template <typename Scheme>
bool UniformRun::FindNearest(const PlaceRequest& request, const typename Scheme::Level& level,
  const SemiSharpStages<typename Scheme::Id>& creases,
  std::vector<LimitPlace<typename Scheme::Id>>& places, std::vector<vtkIdType>& missing,
  vtkPolyData* found)
{
  using Id = typename Scheme::Id;
  const SimplexList& simplices = this->Mesh.Cells.Simplices;
  const auto& parents = this->Mesh.Cells.ParentCells;
  std::vector<Vector> targets(static_cast<std::size_t>(request.Targets->GetNumberOfPoints()));
  for (const vtkIdType i : InTurn(request.Targets->GetNumberOfPoints()))
  {
    request.Targets->GetPoint(i, targets[i].data());
  }
  constexpr int levels = 2;
  vtkSmartPointer<vtkUnstructuredGrid> fine;
  if (level.Complex.NumberOfTets > 0 || Scheme::CountCentres(level) > 0)
  {
    UniformOptions options = this->Options;
    options.Places = nullptr;
    options.Levels = levels;
    options.Warn = [](const std::string&) {}; // this run has told all
    fine = vtkSmartPointer<vtkUnstructuredGrid>::New();
    if (!UniformRun(this->Input, options, fine).Run())
    {
      return false;
    }
    if constexpr (Scheme::Traits.HasPieces)
    {
      Buffer<vtkIdType> octahedra(simplices.GetNumberOfSimplices());
      NumberOctahedra(this->Control.Runs, Scheme::CountSteps(level), octahedra.data());
      fine = CutSolidsAnew(fine, simplices, octahedra, levels);
    }
  }
  const CellsAndSides all(simplices);
  std::vector<vtkIdType> starts{ 0 };
  std::vector<int> counts(static_cast<std::size_t>(this->Input->GetNumberOfCells()), 0);
  for (const vtkIdType s : InTurn(simplices.GetNumberOfSimplices()))
  {
    starts.push_back(starts.back() + simplices.Dimensions[s] + 1);
    ++counts[parents.empty() ? s : parents[s]];
  }
  const auto makePlace = [&](const NearestPlace& nearest)
  {
    LimitPlace<Id> place;
    place.Dimension = all.Dimensions[nearest.Cell];
    const vtkIdType* corners = all.GetCorners(nearest.Cell, starts);
    std::transform(corners, corners + place.Dimension + 1, place.Corners.begin(),
      [](vtkIdType id) { return static_cast<Id>(id); });
    std::copy_n(nearest.Weights.begin() + 1, 3, place.Parameters.begin());
    return place;
  };
  const double* coordinates = this->Points->GetCoordinates();
  const auto evaluate = [&](const std::vector<NearestPlace>& nearest, bool valuesOnly)
  {
    std::vector<LimitPlace<Id>> at;
    std::transform(nearest.begin(), nearest.end(), std::back_inserter(at), makePlace);
    PlaceValues values(at.size());
    ForPartsOfPlaces(level, creases, at,
      valuesOnly ? PlaceDerivatives::None : PlaceDerivatives::Second,
      [&](vtkIdType begin, const PlaceLimits<Id>& limits)
      {
        ForEach(limits.Rows.GetNumberOfPlaces(),
          [&](vtkIdType i) { values[begin + i] = SumParts(limits.Rows, i, coordinates); });
      });
    return values;
  };
  const SearchedCells searched{ simplices.NumberOfPoints, all.Dimensions, all.Connectivity, false };
  const auto solids = fine ? std::make_unique<SolidPieces>(searched, fine, levels) : nullptr;
  std::vector<NearestPlace> nearest = FindNearestPlaces(searched, solids.get(), targets, evaluate);
  if (!CheckNearestPlaces(nearest, searched.GetNumberOfCells() > 0, this->Options, missing))
  {
    return false;
  }
  std::vector<PlaceInCell> inCells;
  vtkNew<vtkIdList> points;
  for (NearestPlace& one : InTurn(nearest))
  {
    if (one.Cell < 0)
    {
      places.push_back(makePlace(NearestPlace{ 0, { { 1., 0., 0., 0. } } }));
      inCells.emplace_back();
      continue;
    }
    all.GoToSolid(simplices, starts, one);
    PlaceInCell inCell;
    inCell.Cell = parents.empty() ? one.Cell : parents[one.Cell];
    LimitPlace<Id> place = makePlace(one);
    if (counts[inCell.Cell] == 1)
    {
      this->Input->GetCellPoints(inCell.Cell, points);
      SetOrder(points, place);
      for (int k = 0; k < place.Dimension; ++k)
      {
        place.Parameters[k] = one.Weights[place.Order[k + 1]];
      }
      inCell.Parameters = place.Parameters;
    }
    places.push_back(place);
    inCells.push_back(inCell);
  }
  AddNearestArrays(nearest, inCells, found);
  return true;
}

template <typename Scheme>
bool UniformRun::FindPlaces(const PlaceRequest& request, const typename Scheme::Level& level)
{
  using Id = typename Scheme::Id;
  const auto creases =
    BuildSharpStages<Scheme>(this->Mesh, this->Options.Features, this->Control, 0);
  if (this->Interpolates())
  {
    const SparseRows<Id> limit = BuildLimitRows(level, creases);
    this->Interpolate(&limit);
  }
  std::vector<LimitPlace<Id>> places;
  vtkNew<vtkPolyData> found; // with further arrays
  std::vector<vtkIdType> missing;
  if (this->IsStopped(0.5) ||
    !(request.Targets ? this->FindNearest<Scheme>(request, level, creases, places, missing, found)
                      : this->ReadPlaces(request, places, missing)))
  {
    return false;
  }
  WritePlaces(
    request, static_cast<vtkIdType>(places.size()), missing,
    [&](const auto& use)
    {
      ForPartsOfPlaces(level, creases, places, request.GetDerivatives(),
        [&use](vtkIdType begin, const PlaceLimits<Id>& limits) { use(begin, limits.Rows); });
    },
    [&](vtkIdType place) { return places[place].Dimension; },
    [&](vtkIdType row)
    {
      const LimitPlace<Id>& place = places[row];
      const Vector& p = place.Parameters;
      const double first = 1. - p[0] - p[1] - p[2];
      const auto most = std::max_element(p.begin(), p.end());
      return static_cast<vtkIdType>(
        place.Corners[place.Order[first >= *most ? 0 : 1 + (most - p.begin())]]);
    },
    *this->Points, found);
  return true;
}

bool UniformRun::FindPlaces(const PlaceRequest& request)
{
  if (!this->Plan())
  {
    return false;
  }
  this->PlanInterpolation();
  return std::visit([&](const auto& level)
    { return this->FindPlaces<SchemeOf<std::decay_t<decltype(level)>>>(request, level); },
    this->Current);
}

}
