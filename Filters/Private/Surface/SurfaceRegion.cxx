// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceRegion.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/Partners.h"
#include "Private/Control/Stamp.h"
#include "Private/Control/StampFields.h"
#include "Private/Reading/CellReader.h"
#include "Private/Surface/SurfaceCreases.h"
#include "Private/Surface/SurfaceStamp.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

constexpr const char* ControlName = "SubdivisionRegionControl";
constexpr const char* KindNames[3][2] = { { "SubdivisionRegionVerts",
                                            "SubdivisionRegionVertsOffsets" },
  { "SubdivisionRegionLines", "SubdivisionRegionLinesOffsets" },
  { "SubdivisionRegionPolys", "SubdivisionRegionPolysOffsets" } };

/// No mesh has so many simplices, and twice the number is an id.
constexpr vtkIdType LargestKey = vtkIdType(1) << (8 * sizeof(vtkIdType) - 8);

void KeepCells(vtkCellArray* cells, const char* const* names, vtkFieldData* data)
{
  vtkDataArray* const lists[2] = { cells->GetConnectivityArray(), cells->GetOffsetsArray() };
  for (int i = 0; i < 2; ++i)
  {
    const auto copy = vtkSmartPointer<vtkDataArray>::Take(lists[i]->NewInstance());
    copy->ShallowCopy(lists[i]);
    copy->SetName(names[i]);
    data->AddArray(copy);
  }
}

/// Cells that KeepCells kept, all of whose points exist; null: there are none.
vtkSmartPointer<vtkCellArray> ReadCells(vtkFieldData* data, const char* const* names, size_t points)
{
  const Ids connectivity = ReadFieldIds(names[0], data);
  const Ids offsets = ReadFieldIds(names[1], data);
  const bool areCells = !offsets.empty() && offsets.front() == 0 &&
    offsets.back() == static_cast<vtkIdType>(connectivity.size()) &&
    std::is_sorted(offsets.begin(), offsets.end()) &&
    std::all_of(connectivity.begin(), connectivity.end(),
      [points](vtkIdType id) { return id >= 0 && id < static_cast<vtkIdType>(points); });
  if (!areCells)
  {
    return nullptr;
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(
    MakeField<vtkIdTypeArray>("", offsets), MakeField<vtkIdTypeArray>("", connectivity));
  return cells;
}

/// Where each of `numbers` is among `ids`; -1: nowhere.
Ids FindPlaces(const Ids& numbers, const Ids& ids)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> sorted;
  for (const size_t i : InTurn(ids.size()))
  {
    sorted.emplace_back(ids[i], static_cast<vtkIdType>(i));
  }
  std::sort(sorted.begin(), sorted.end());
  Ids places;
  for (const vtkIdType number : InTurn(numbers))
  {
    const auto found =
      std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(number, vtkIdType(0)));
    places.push_back(
      number >= 0 && found != sorted.end() && found->first == number ? found->second : -1);
  }
  return places;
}

/// The values of the input, and any where it has none: no own point or cell depends on those.
void TakeArrays(vtkDataSetAttributes* from, Ids places, vtkDataSetAttributes* to)
{
  std::replace(places.begin(), places.end(), vtkIdType(-1), vtkIdType(0));
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    AddLike(from, a,
      Gather(from->GetAbstractArray(a), { places.data(), places.data() + places.size() }), to);
  }
}

void TakeValues(vtkPolyData* input, SurfaceRegion& region)
{
  vtkPolyData* mesh = region.Mesh;
  Ids places = region.Points;
  std::replace(places.begin(), places.end(), vtkIdType(-1), vtkIdType(0));
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetData(vtkDataArray::SafeDownCast(
    Gather(input->GetPoints()->GetData(), { places.data(), places.data() + places.size() })));
  mesh->SetPoints(points);
  TakeArrays(input->GetPointData(), region.Points, mesh->GetPointData());
  TakeArrays(input->GetCellData(), region.Cells, mesh->GetCellData());
  auto* blocks = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray(BlockName));
  for (size_t c = 0; blocks && c < region.Cells.size(); ++c)
  {
    if (region.Cells[c] < 0)
    {
      blocks->SetValue(static_cast<vtkIdType>(c), NoBlock);
    }
  }
  mesh->GetFieldData()->PassData(input->GetFieldData());
}

/// Forgets cells that have other points than those of the input. Returns whether all own cells of
/// the input are left.
bool CompareCells(vtkPolyData* input, SurfaceRegion& region)
{
  const CellReader before(input);
  const CellReader after(region.Mesh);
  auto* blocks = vtkIntArray::SafeDownCast(input->GetCellData()->GetArray(BlockName));
  std::vector<char> isThere(static_cast<size_t>(input->GetNumberOfCells()), 0);
  Ids scratch[2];
  for (const size_t c : InTurn(region.Cells.size()))
  {
    vtkIdType& place = region.Cells[c];
    if (place < 0)
    {
      continue;
    }
    const CellIds cell = before.GetCell(place, scratch[0]);
    const CellIds own = after.GetCell(static_cast<vtkIdType>(c), scratch[1]);
    const bool isSame = cell.Size == own.Size &&
      std::equal(cell.Ids, cell.Ids + cell.Size, own.Ids,
        [&region](vtkIdType a, vtkIdType b) { return a == region.Points[static_cast<size_t>(b)]; });
    place = isSame && !isThere[place] ? place : -1;
    if (place >= 0)
    {
      isThere[place] = 1;
    }
  }
  for (const size_t c : InTurn(isThere.size()))
  {
    const bool isOwn = !blocks || blocks->GetValue(static_cast<vtkIdType>(c)) != NoBlock;
    if (isOwn && !isThere[c])
    {
      return false;
    }
  }
  return true;
}

/// `points`, `cells`: the numbers of those of the input in the whole.
bool MakeRegion(vtkPolyData* input, const Ids& points, const Ids& cells, SurfaceRegion& region)
{
  vtkFieldData* data = input->GetFieldData();
  region.Points = FindPlaces(ReadFieldIds(RegionPointsName, data), points);
  region.Cells = FindPlaces(ReadFieldIds(RegionCellsName, data), cells);
  vtkSmartPointer<vtkCellArray> kinds[3];
  for (int kind = 0; kind < 3; ++kind)
  {
    kinds[kind] = ReadCells(data, KindNames[kind], region.Points.size());
    if (!kinds[kind])
    {
      return false;
    }
  }
  region.Mesh = vtkSmartPointer<vtkPolyData>::New();
  region.Mesh->SetVerts(kinds[0]);
  region.Mesh->SetLines(kinds[1]);
  region.Mesh->SetPolys(kinds[2]);
  if (region.Mesh->GetNumberOfCells() != static_cast<vtkIdType>(region.Cells.size()) ||
    (input->GetNumberOfPoints() == 0 && !region.Points.empty()) ||
    (input->GetNumberOfCells() == 0 && !region.Cells.empty()) || !CompareCells(input, region))
  {
    return false;
  }
  TakeValues(input, region);
  SurfaceStamp stamp;
  const SurfaceCells whole = ReadSurfaceCells(region.Mesh, false, nullptr);
  return ReadSurfaceStamp(region.Mesh, stamp) && whole.Warnings.empty();
}

Ids CountUpTo(vtkIdType size)
{
  Ids ids;
  for (const vtkIdType i : InTurn(size))
  {
    ids.push_back(i);
  }
  return ids;
}

void FollowArray(vtkDataSetAttributes* region, vtkSmartPointer<vtkDataArray>& array)
{
  array = array && array->GetName() ? region->GetArray(array->GetName()) : nullptr;
}

void CountIn(
  const char* name, vtkDataSetAttributes* input, const Ids& places, vtkDataSetAttributes* output)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetAbstractArray(name));
  for (const vtkIdType i :
    InTurn(ids && !input->HasArray(name) ? ids->GetNumberOfValues() : vtkIdType(0)))
  {
    const vtkIdType id = ids->GetValue(i);
    ids->SetValue(i, id >= 0 ? places[static_cast<size_t>(id)] : id);
  }
}

}

void WriteRegion(const SurfaceNumbers& numbers, vtkPolyData* output)
{
  vtkFieldData* data = output->GetFieldData();
  vtkCellArray* const kinds[3] = { output->GetVerts(), output->GetLines(), output->GetPolys() };
  for (int kind = 0; kind < 3; ++kind)
  {
    KeepCells(kinds[kind], KindNames[kind], data);
  }
  data->AddArray(MakeField<vtkIdTypeArray>(RegionPointsName, numbers.Points.Ids));
  data->AddArray(MakeField<vtkIdTypeArray>(RegionCellsName, numbers.Cells.Ids));
  data->AddArray(MakeField<vtkIdTypeArray>(ControlName, numbers.Control, 2));
}

void RemoveRegion(vtkPolyData* output)
{
  vtkFieldData* data = output->GetFieldData();
  for (const auto& names : KindNames)
  {
    data->RemoveArray(names[0]);
    data->RemoveArray(names[1]);
  }
  for (const char* name : { RegionPointsName, RegionCellsName, RegionBlockName, ControlName })
  {
    data->RemoveArray(name);
  }
}

bool FindRegion(vtkPolyData* input, const SurfaceOptions& options, SurfaceRegion& region)
{
  Stamp stamp;
  if (!input->GetFieldData()->HasArray(RegionPointsName) || !ReadPartStamp(input, stamp))
  {
    return false;
  }
  Partners* others = FindPartners(options, input);
  const auto haveAny = [others](bool isTrue)
  { return others ? others->Sum(isTrue ? 1 : 0) > 0 : isTrue; };
  const auto isMarked = [&]
  {
    return !FindMarkedEdges(input, options.Features.Marks, [](const std::string&) {})
              .Points.empty();
  };
  bool goesOn = static_cast<int>(stamp.Scheme) ==
      static_cast<int>(StampScheme::FirstOfSurfaces) + static_cast<int>(options.Scheme) &&
    !haveAny(isMarked());
  if (goesOn &&
    haveAny(
      !MakeRegion(input, others ? others->GetPointIds() : CountUpTo(input->GetNumberOfPoints()),
        others ? others->GetCellIds() : CountUpTo(input->GetNumberOfCells()), region)))
  {
    options.Warn("The cells of the input are not those that an earlier filter made: this filter "
                 "takes them as any other mesh.");
    goesOn = false;
  }
  if (!goesOn && others) // the mesh was joined for this filter
  {
    RemoveSurfaceStamp(input);
  }
  return goesOn;
}

SurfaceOptions TakeToRegion(
  vtkPolyData* input, const SurfaceOptions& options, const SurfaceRegion& region)
{
  SurfaceOptions taken = options;
  Partners* others = FindPartners(options, input);
  taken.FindPartners = [others](vtkPointSet*) { return others; };
  taken.IsRegion = true;
  taken.Features.Marks = MarkOptions(); // there are none
  FollowArray(region.Mesh->GetPointData(), taken.Angles);
  FollowArray(region.Mesh->GetPointData(), taken.Flatness);
  for (auto* array : { &taken.Features.Singular, &taken.Features.Material, &taken.Features.Part,
         &taken.Features.Rules, &taken.Features.Sharpness })
  {
    FollowArray(region.Mesh->GetCellData(), *array);
  }
  return taken;
}

void CountInInput(vtkPolyData* input, const SurfaceRegion& region, vtkPolyData* output)
{
  CountIn(OriginalPointIdsName, input->GetPointData(), region.Points, output->GetPointData());
  CountIn(OriginalCellIdsName, input->GetCellData(), region.Cells, output->GetCellData());
}

ControlKeys ReadControlKeys(vtkPolyData* region)
{
  ControlKeys keys;
  const Ids control = ReadFieldIds(ControlName, region->GetFieldData(), 2);
  for (size_t i = 0; i < control.size(); i += 2)
  {
    if (control[i] >= 0 && control[i] < NumberOfControlKinds && control[i + 1] >= 0 &&
      control[i + 1] < LargestKey)
    {
      SharedKeys& kind = keys[static_cast<size_t>(control[i])];
      kind.Keys.push_back(control[i + 1] / 2);
      kind.Own.push_back(static_cast<char>(control[i + 1] % 2));
    }
  }
  return keys;
}

}
