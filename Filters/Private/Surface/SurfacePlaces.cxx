// SPDX-License-Identifier: BSD-3-Clause
// The limit at places of cells, with derivatives.
#include "Core/Surfaces/Places/SurfacePlaces.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Surface/SurfaceRun.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace subdivision
{
namespace
{

/// Moves a parameter into [0, 1], but by rounding only. False: it is outside.
bool MoveInside(double& x)
{
  constexpr double rounding = 1e-9;
  const bool isInside = x >= -rounding && x <= 1. + rounding;
  x = std::min(1., std::max(0., x));
  return isInside;
}

/// Sets the place in a triangle whose corners `order` are the points of its cell. False: it is
/// outside.
template <typename Id>
bool SetInTriangle(double u, double v, const std::array<int, 3>& order, SurfacePlace<Id>& place)
{
  double rest = 1. - u - v;
  if (!MoveInside(u) || !MoveInside(v) || !MoveInside(rest))
  {
    return false;
  }
  if (u + v > 1.)
  {
    v = 1. - u;
  }
  std::array<double, 3> weights{};
  std::array<std::array<double, 2>, 3> changes{};
  weights[order[0]] = std::max(0., 1. - u - v);
  weights[order[1]] = u;
  weights[order[2]] = v;
  changes[order[0]] = { { -1., -1. } };
  changes[order[1]] = { { 1., 0. } };
  changes[order[2]] = { { 0., 1. } };
  place.At = { { weights[1], weights[2] } };
  place.Directions = { { changes[1], changes[2] } };
  return true;
}

}

/// A place of a line as one of a face, if its edge is in one; other places as they are.
template <typename Id>
SurfacePlace<Id> SurfaceRun<Id>::TakePlaceOfLine(
  const SurfaceLevel<Id>& level, const SurfacePlace<Id>& place) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Id corner = place.Dimension == 1 ? mesh.EdgeCorners[place.Part] : Id(-1);
  if (corner < 0)
  {
    return place;
  }
  SurfacePlace<Id> taken;
  taken.Dimension = 2;
  taken.Part = mesh.GetFace(corner);
  const Id sides = mesh.GetSize(taken.Part);
  const int k = static_cast<int>(corner - mesh.GetFirst(taken.Part));
  // Along the half-edge, and how that changes with the parameters.
  const bool isTurned =
    mesh.Vertices[corner] != mesh.EdgeVertices[2 * static_cast<vtkIdType>(place.Part)];
  const double x = isTurned ? 1. - place.At[0] : place.At[0];
  const double slope = isTurned ? -place.Directions[0][0] : place.Directions[0][0];
  const bool isTriangle = this->Scheme->NeedsTriangles();
  if (!isTriangle && sides != 4)
  {
    const bool isInFirst = x <= 0.5;
    taken.Corner = isInFirst ? k : (k + 1) % static_cast<int>(sides);
    taken.At = { { isInFirst ? 2. * x : 0., isInFirst ? 0. : 2. * (1. - x) } };
    taken.Directions = { { { { isInFirst ? 2. * slope : 0., 0. } },
      { { isInFirst ? 0. : -2. * slope, 0. } } } };
    return taken;
  }
  // The corners of the face in x and y.
  constexpr double ofTriangle[3][2] = { { 0., 0. }, { 1., 0. }, { 0., 1. } };
  constexpr double ofQuad[4][2] = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } };
  const double* from = isTriangle ? ofTriangle[k] : ofQuad[k];
  const double* to = isTriangle ? ofTriangle[(k + 1) % 3] : ofQuad[(k + 1) % 4];
  for (int i = 0; i < 2; ++i)
  {
    taken.At[i] = from[i] == to[i] ? from[i] : from[i] < to[i] ? x : 1. - x;
    taken.Directions[i] = { { (to[i] - from[i]) * slope, 0. } };
  }
  return taken;
}

/// Finds the part of the cell of a place. Returns false, after an error, if the cell is none.
template <typename Id>
bool SurfaceRun<Id>::ReadPlace(vtkIdType i, const PlaceInCell& given, const PartsOfCells& parts,
  const SurfaceSteps<Id>& steps, SurfacePlace<Id>& place, PlaceOrigin& origin,
  std::vector<vtkIdType>& missing) const
{
  const PolygonMesh<Id>& mesh = GetLast(*this->Steps).Mesh;
  const SurfaceLevel<Id>& level = GetLast(steps);
  const vtkIdType cell = given.Cell;
  const auto fail = [&](const std::string& what)
  {
    this->Options.Fail("Place " + std::to_string(i) + " is in cell " + std::to_string(cell) + what);
    return false;
  };
  if (cell < 0 || cell >= parts.GetNumberOfCells())
  {
    return fail(": the input has no such cell.");
  }
  const PartOfCell& part = parts[cell];
  vtkNew<vtkIdList> points;
  if (part.Count == 1)
  {
    this->Input->GetCellPoints(part.Cell, points);
  }
  if (part.Count != 1 ||
    (part.Dimension == 2 && points->GetNumberOfIds() != mesh.GetSize(static_cast<Id>(part.Part))))
  {
    return fail(", which was cut into several cells or left out, or has a point twice. Cut it by "
                "another filter first, or use Scheme = CatmullClark for polygons.");
  }
  std::array<double, 3> p{};
  const bool isTriangle = this->Scheme->NeedsTriangles();
  const bool isPolygon = part.Dimension == 2 && !isTriangle && points->GetNumberOfIds() != 4;
  const auto known = given.Parameters.begin() + part.Dimension + (isPolygon ? 1 : 0);
  if (std::all_of(given.Parameters.begin(), known, [](double x) { return std::isfinite(x); }))
  {
    std::copy(given.Parameters.begin(), known, p.begin());
  }
  else
  {
    missing.push_back(i);
  }
  place = SurfacePlace<Id>();
  place.Dimension = part.Dimension;
  place.Part = static_cast<Id>(part.Part);
  bool isInside = true;
  vtkIdType corner = 0; // the nearest, of the points of the cell
  if (part.Dimension == 0)
  {
    place.Part = static_cast<Id>(this->GetCellsOf(steps).Vertices[part.Part]);
  }
  else if (part.Dimension == 1)
  {
    isInside = MoveInside(p[0]);
    corner = p[0] > 0.5 ? 1 : 0;
    const Id line = level.Lines[part.Part];
    place.Part = line / 2;
    place.At[0] = line % 2 == 0 ? p[0] : 1. - p[0];
    place.Directions = { { { { line % 2 == 0 ? 1. : -1., 0. } }, { { 0., 0. } } } };
    place = this->TakePlaceOfLine(level, place);
  }
  else if (isTriangle)
  {
    std::array<int, 3> order{};
    const Id* corners = mesh.Vertices.data() + mesh.GetFirst(place.Part);
    for (int k = 0; k < 3; ++k)
    {
      order[k] = static_cast<int>(
        std::find(corners, corners + 2, static_cast<Id>(points->GetId(k))) - corners);
    }
    isInside = SetInTriangle(p[0], p[1], order, place);
    const double first = 1. - p[0] - p[1];
    corner = first >= std::max(p[0], p[1]) ? 0 : p[0] >= p[1] ? 1 : 2;
  }
  else
  {
    isInside = MoveInside(p[0]);
    isInside = MoveInside(p[1]) && isInside;
    place.At = { { p[0], p[1] } };
    corner = p[1] <= 0.5 ? (p[0] <= 0.5 ? 0 : 1) : (p[0] <= 0.5 ? 3 : 2);
    if (isPolygon)
    {
      const double last = static_cast<double>(points->GetNumberOfIds()) - 1.;
      if (p[2] != std::floor(p[2]) || p[2] < 0. || p[2] > last)
      {
        return fail(", a polygon that is no quad: its third parameter is the number of one of its "
                    "points, from 0 on.");
      }
      place.Corner = static_cast<int>(p[2]);
      corner = place.Corner;
    }
  }
  if (!isInside)
  {
    return fail(": it is outside of the cell. Parameters are not negative, and 1 at most; in a "
                "triangle that is their sum.");
  }
  origin = { points->GetId(corner), part.Dimension };
  return true;
}

/// Calls use(begin, rows) for the rows of some places at a time, so that they take little memory.
template <typename Id>
void SurfaceRun<Id>::SumPlaces(const SurfaceSteps<Id>& steps,
  const std::vector<SurfacePlace<Id>>& places, PlaceDerivatives derivatives,
  const std::function<void(vtkIdType, const PlaceRows<Id>&)>& use) const
{
  constexpr std::size_t most = 8192;
  for (std::size_t begin = 0; begin < places.size(); begin += most)
  {
    const auto first = places.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto count = static_cast<std::ptrdiff_t>(std::min(most, places.size() - begin));
    use(static_cast<vtkIdType>(begin),
      FindSurfacePlaces(*this->Scheme, GetLast(steps), steps.GetSharpCreases(),
        std::vector<SurfacePlace<Id>>(first, first + count), derivatives));
    BetweenLoops::Act();
  }
}

template <typename Id>
bool SurfaceRun<Id>::FindPlaces(SurfaceCells&& cells, const PlaceRequest& request)
{
  this->Cells = std::move(cells);
  if (!this->Plan())
  {
    return false;
  }
  const PartsOfCells parts(this->Cells, this->Input);
  vtkNew<vtkPolyData> found; // with further arrays
  std::vector<PlaceInCell> asked;
  std::vector<NearestPlace> nearest;
  std::vector<vtkIdType> missing;
  if (request.Targets)
  {
    this->Interpolate();
    if (this->IsStopped(0.5) || !this->FindNearest(request.Targets, parts, nearest, asked, missing))
    {
      return false;
    }
    AddNearestArrays(nearest, asked, found);
  }
  else
  {
    for (const vtkIdType i : InTurn(request.Cells->GetNumberOfTuples()))
    {
      asked.push_back({ request.Cells->GetValue(i), {} });
      request.Parameters->GetTuple(i, asked.back().Parameters.data());
    }
  }
  std::vector<PlaceOrigin> origins(asked.size());
  std::vector<SurfacePlace<Id>> places(asked.size());
  const auto read = [&](const SurfaceSteps<Id>& steps)
  {
    const SurfaceSearch<Id> search(
      this->GetCellsOf(steps), GetLast(steps), this->Scheme->NeedsTriangles());
    missing.resize(request.Targets ? missing.size() : 0);
    for (const vtkIdType i : InTurn(static_cast<vtkIdType>(asked.size())))
    {
      if (request.Targets && (asked[i].Cell < 0 || parts[asked[i].Cell].Count != 1))
      {
        const NearestPlace at = asked[i].Cell < 0 ? NearestPlace{ 0 } : nearest[i];
        const SurfacePlace<Id> place = search.MakePlace(at);
        origins[i] = { static_cast<vtkIdType>(search.FindNearestVertex(at)), place.Dimension };
        places[i] = this->TakePlaceOfLine(GetLast(steps), place);
      }
      else if (!this->ReadPlace(i, asked[i], parts, steps, places[i], origins[i], missing))
      {
        return false;
      }
    }
    return true;
  };
  if (!read(this->GetStepsOfPoints()))
  {
    return false;
  }
  if (!request.Targets)
  {
    WarnOfMissingPlaces(missing, "parameters", this->Options);
    this->Interpolate();
  }
  const auto size = static_cast<vtkIdType>(places.size());
  const double* coordinates = this->Points->GetCoordinates();
  std::optional<DerivativeArrays> derivatives;
  request.HasDerivatives ? void(derivatives.emplace(size, found)) : void();
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfComponents(3);
  values->SetNumberOfTuples(size);
  AppendedRows rows;
  this->SumPlaces(this->GetStepsOfPoints(), places, request.GetDerivatives(),
    [&](vtkIdType begin, const PlaceRows<Id>& some)
    {
      if (!this->Joined)
      {
        rows.Append(some);
      }
      ForEach(some.GetNumberOfPlaces(),
        [&](vtkIdType i)
        {
          const PlacePoint point = SumParts(some, i, coordinates);
          values->SetTypedTuple(begin + i, point[PlaceParts::Value].data());
          derivatives ? derivatives->Set(begin + i, origins[begin + i].Dimension, point) : void();
        });
    });
  if (this->Joined)
  {
    if (!read(*this->Steps)) // edges have other numbers there
    {
      return false;
    }
    this->SumPlaces(*this->Steps, places, PlaceDerivatives::None,
      [&rows](vtkIdType, const PlaceRows<Id>& some) { rows.Append(some); });
    const auto points = MakeArray(this->Points->GetPoints()->GetDataType(), 3, size);
    for (const vtkIdType i : InTurn(size))
    {
      points->SetTuple(i, values->GetTuple(i));
    }
    this->Points->ReusePoints(points);
  }
  SparseRows<vtkIdType> ofValues = rows.Finish();
  this->Points->Advance(ofValues, [&origins](vtkIdType row) { return origins[row].Point; });
  if (request.Rows)
  {
    (*request.Rows)[0] = std::move(ofValues);
  }
  this->Points->ForgetInputPoints();
  request.Output->Initialize();
  this->Points->Finish(request.Output);
  FinishPlaces(missing, found, request.Targets, request.Output);
  return true;
}

SUBDIVISION_COMPILE(class SurfaceRun);

}
