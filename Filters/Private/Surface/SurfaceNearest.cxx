// SPDX-License-Identifier: BSD-3-Clause
// The places of a surface that are nearest to points.
#include "Private/Surface/SurfaceRun.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The parameters of a place in a cell that is one vertex, line or face, for who asks for places.
template <typename Id>
std::array<double, 3> GetParameters(const SurfaceSearch<Id>& search, const NearestPlace& nearest,
  const PolygonMesh<Id>& mesh, vtkIdList* points)
{
  const SurfacePlace<Id> place = search.MakePlace(nearest);
  switch (place.Dimension)
  {
    case 0:
      return { { 0., 0., 0. } };
    case 1:
      return { { search.GetPlaceOnLine(nearest), 0., 0. } };
    default:
      break;
  }
  const auto [x, y] = place.At;
  if (!search.GetCells().HasQuads)
  {
    const double weights[3] = { 1. - x - y, x, y };
    const Id* corners = mesh.Vertices.data() + mesh.GetFirst(place.Part);
    std::array<double, 3> ofPoints{};
    for (int k = 1; k < 3; ++k)
    {
      ofPoints[k - 1] =
        weights[std::find(corners, corners + 2, static_cast<Id>(points->GetId(k))) - corners];
    }
    return ofPoints;
  }
  return { { x, y, static_cast<double>(std::max(0, place.Corner)) } };
}

}

template <typename Id>
bool SurfaceRun<Id>::FindNearest(vtkDataSet* targets, const PartsOfCells& parts,
  std::vector<NearestPlace>& nearest, std::vector<PlaceInCell>& inCells,
  std::vector<vtkIdType>& missing)
{
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(targets->GetNumberOfPoints()));
  for (const vtkIdType i : InTurn(targets->GetNumberOfPoints()))
  {
    targets->GetPoint(i, points[i].data());
  }
  const SurfaceSteps<Id>& steps = this->GetStepsOfPoints();
  const SurfaceSearch<Id> search(
    this->GetCellsOf(steps), GetLast(steps), this->Scheme->NeedsTriangles());
  const double* coordinates = this->Points->GetCoordinates();
  const auto evaluate = [&](const std::vector<NearestPlace>& asked, bool)
  {
    std::vector<SurfacePlace<Id>> places;
    for (const NearestPlace& one : asked)
    {
      places.push_back(this->TakePlaceOfLine(GetLast(steps), search.MakePlace(one)));
    }
    PlaceValues values(asked.size());
    this->SumPlaces(steps, places, PlaceDerivatives::Second,
      [&](vtkIdType begin, const PlaceRows<Id>& rows)
      {
        ForEach(rows.GetNumberOfPlaces(),
          [&](vtkIdType i) { values[begin + i] = SumParts(rows, i, coordinates); });
      });
    return values;
  };
  const SearchedCells searched = search.GetCells();
  nearest = FindNearestPlaces(searched, nullptr, points, evaluate);
  if (!CheckNearestPlaces(nearest, searched.GetNumberOfCells() > 0, this->Options, missing))
  {
    return false;
  }
  vtkNew<vtkIdList> ids;
  for (const NearestPlace& one : InTurn(nearest))
  {
    if (one.Cell < 0)
    {
      inCells.emplace_back();
      continue;
    }
    const vtkIdType owner = search.FindOwner(one);
    PlaceInCell inCell;
    inCell.Cell = parts.GetSource(owner);
    if (parts[inCell.Cell].Count == 1)
    {
      this->Input->GetCellPoints(owner, ids);
      inCell.Parameters = GetParameters(search, one, GetLast(*this->Steps).Mesh, ids);
    }
    inCells.push_back(inCell);
  }
  return true;
}

SUBDIVISION_COMPILE(class SurfaceRun);

}
