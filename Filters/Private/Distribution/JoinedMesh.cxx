// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/JoinedMesh.h"

#include "Core/Memory/Sorting.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/GreenLeaves.h"
#include "Private/Distribution/JoinedArrays.h"
#include "Private/Reading/CellReader.h"
#include "Private/Values/PointCopies.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <tuple>

namespace subdivision
{
namespace
{

bool Exists(vtkIdType point, const std::vector<vtkIdType>& points)
{
  return point >= 0 && point < static_cast<vtkIdType>(points.size());
}

/// A point or cell of a part. `Kind` orders the cells of poly data: vertices, lines, polygons,
/// strips.
struct Item
{
  int Kind;
  int Part;
  vtkIdType Id;
  vtkIdType Index;

  bool operator<(const Item& other) const
  {
    return std::tie(this->Kind, this->Id, this->Part, this->Index) <
      std::tie(other.Kind, other.Id, other.Part, other.Index);
  }
};

int GetKind(int cellType)
{
  switch (cellType)
  {
    case VTK_POLY_VERTEX:
      return 0;
    case VTK_POLY_LINE:
      return 1;
    case VTK_POLYGON:
      return 2;
    default:
      return 3;
  }
}

/// Sorts items by id, drops items whose id came before, and says where each item of each part is.
Places SortItems(std::vector<Item>& items, const std::vector<MeshPart>& parts,
  const std::vector<vtkIdType> MeshPart::* ids)
{
  StableSort(items, std::less<>());
  Places places;
  for (const MeshPart& part : parts)
  {
    places.OfPart.emplace_back((part.*ids).size(), -1);
  }
  const Item* last = nullptr;
  std::vector<Item> unique;
  for (const Item& item : InTurn(items))
  {
    if (!last || item.Kind != last->Kind || item.Id != last->Id)
    {
      unique.push_back(item);
    }
    last = &item;
    places.OfPart[item.Part][item.Index] = static_cast<vtkIdType>(unique.size()) - 1;
  }
  places.Size = static_cast<vtkIdType>(unique.size());
  items = std::move(unique);
  return places;
}

/// Places the points or cells of parts: getKind(part, index) comes before their ids.
template <typename GetKind>
Places PlaceItems(const std::vector<MeshPart>& parts, const std::vector<vtkIdType> MeshPart::* ids,
  const GetKind& getKind, std::vector<Item>& items)
{
  for (size_t p = 0; p < parts.size(); ++p)
  {
    for (size_t i = 0; i < (parts[p].*ids).size(); ++i)
    {
      const vtkIdType id = (parts[p].*ids)[i];
      const auto index = static_cast<vtkIdType>(i);
      id >= 0 ? items.push_back({ getKind(p, index), static_cast<int>(p), id, index }) : void();
    }
  }
  return SortItems(items, parts, ids);
}

vtkSmartPointer<vtkPoints> JoinPoints(
  const std::vector<MeshPart>& parts, const std::vector<Item>& items, int type)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(items.size()));
  for (size_t i = 0; i < items.size(); ++i)
  {
    double at[3];
    parts[items[i].Part].Mesh->GetPoint(items[i].Index, at);
    points->SetPoint(static_cast<vtkIdType>(i), at);
  }
  return points;
}

/// Cells, as they come.
class CellLists
{
public:
  explicit CellLists(vtkIdType size)
    : Types(vtkSmartPointer<vtkUnsignedCharArray>::New())
  {
    this->Types->SetNumberOfValues(size);
    this->OfKind[0].Offsets.reserve(static_cast<size_t>(size) + 1);
    this->OfKind[0].Ids.reserve(4 * static_cast<size_t>(size)); // most cells are simplices
  }

  /// Starts cell `i`, whose points follow. `kind`: as GetKind for poly data, else 0.
  void Start(vtkIdType i, int kind, int type)
  {
    this->Types->SetValue(i, static_cast<unsigned char>(type));
    this->Current = &this->OfKind[kind];
  }
  void Add(vtkIdType point) { this->Current->Ids.push_back(point); }
  void End()
  {
    this->Current->Offsets.push_back(static_cast<vtkIdType>(this->Current->Ids.size()));
  }

  void GiveTo(vtkPointSet* mesh)
  {
    std::vector<vtkSmartPointer<vtkCellArray>> lists;
    for (List& list : this->OfKind)
    {
      lists.push_back(list.Take());
    }
    SetCellArrays(mesh, this->Types, lists);
  }

private:
  struct List
  {
    std::vector<vtkIdType> Offsets{ 0 };
    std::vector<vtkIdType> Ids;

    vtkSmartPointer<vtkCellArray> Take()
    {
      auto cells = vtkSmartPointer<vtkCellArray>::New();
      cells->SetData(ToArray(this->Offsets), ToArray(this->Ids));
      *this = List();
      return cells;
    }
    static vtkSmartPointer<vtkDataArray> ToArray(const std::vector<vtkIdType>& values)
    {
      const auto array = MakeArray(VTK_ID_TYPE, 1, static_cast<vtkIdType>(values.size()));
      if (!values.empty())
      {
        std::memcpy(array->GetVoidPointer(0), values.data(), values.size() * sizeof(vtkIdType));
      }
      return array;
    }
  };

  std::array<List, 4> OfKind;
  List* Current = nullptr;
  vtkSmartPointer<vtkUnsignedCharArray> Types;
};

/// Polyhedra as MakeReadable leaves them are of another type. Polyhedra of crease geometry, which
/// takes no solids, become their points: VTK reads the points of VTK_POLYHEDRON in another way.
int GetJoinedType(const CellReader& reader, vtkIdType cell, vtkIdType size)
{
  const int type = reader.GetGridType(cell, size);
  return type == VTK_POLYHEDRON ? VTK_CONVEX_POINT_SET : type;
}

void JoinCells(const std::vector<CellReader>& readers, const std::vector<Item>& items,
  const Places& points, vtkPointSet* mesh)
{
  CellLists lists(static_cast<vtkIdType>(items.size()));
  std::vector<vtkIdType> scratch;
  for (size_t i = 0; i < items.size(); ++i)
  {
    const Item& item = items[i];
    const CellIds cell = readers[item.Part].GetCell(item.Index, scratch);
    const std::vector<vtkIdType>& places = points.OfPart[item.Part];
    lists.Start(static_cast<vtkIdType>(i), item.Kind,
      GetJoinedType(readers[item.Part], item.Index, cell.Size));
    for (vtkIdType k = 0; k < cell.Size; ++k)
    {
      lists.Add(Exists(cell.Ids[k], places) ? places[cell.Ids[k]] : -1);
    }
    lists.End();
  }
  lists.GiveTo(mesh);
}

void AddBlocks(
  const std::vector<MeshPart>& parts, const std::vector<Item>& cells, vtkPointSet* mesh)
{
  vtkNew<vtkIntArray> blocks;
  blocks->SetName(BlockName);
  blocks->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
  for (const size_t i : InTurn(cells.size()))
  {
    blocks->SetValue(static_cast<vtkIdType>(i), parts[cells[i].Part].Block);
  }
  mesh->GetCellData()->AddArray(blocks);
}

void JoinLeaves(const std::vector<MeshPart>& parts, const std::vector<Item>& cells,
  const Places& points, vtkPointSet* mesh)
{
  std::vector<vtkPointSet*> meshes;
  for (const MeshPart& part : parts)
  {
    meshes.push_back(part.Mesh);
  }
  TakeLeaves(
    meshes, [&](vtkIdType c) { return CellOfMesh(cells[c].Part, cells[c].Index); },
    [&](std::size_t part, vtkIdType point)
    {
      const std::vector<vtkIdType>& places = points.OfPart[part];
      return Exists(point, places) ? places[point] : vtkIdType(-1);
    },
    mesh);
}

std::vector<vtkIdType> GetIds(const std::vector<Item>& items)
{
  std::vector<vtkIdType> ids;
  ids.reserve(items.size());
  for (const Item& item : items)
  {
    ids.push_back(item.Id);
  }
  return ids;
}

// ------------------------------------------------------------------------------------------------
// Parting

/// The points of some cells and `kept`, ascending; `place` gets the new index of each.
std::vector<vtkIdType> FindPoints(const CellReader& reader, const std::vector<vtkIdType>& cells,
  const std::vector<vtkIdType>& kept, std::vector<vtkIdType>& place)
{
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(cells))
  {
    const CellIds cell = reader.GetCell(c, scratch);
    for (vtkIdType k = 0; k < cell.Size; ++k)
    {
      if (Exists(cell.Ids[k], place))
      {
        place[cell.Ids[k]] = 0;
      }
    }
  }
  for (const vtkIdType point : InTurn(kept))
  {
    place[point] = 0;
  }
  std::vector<vtkIdType> points;
  for (const size_t i : InTurn(place.size()))
  {
    if (place[i] == 0)
    {
      place[i] = static_cast<vtkIdType>(points.size());
      points.push_back(static_cast<vtkIdType>(i));
    }
  }
  return points;
}

bool HasPolyhedra(const CellReader& reader)
{
  const unsigned char* types = reader.GetTypes();
  return types &&
    std::find(types, types + reader.GetNumberOfCells(), VTK_POLYHEDRON) !=
    types + reader.GetNumberOfCells();
}

/// Writes cells of a grid with polyhedra, which are more than lists of points.
void TakeWithFaces(vtkUnstructuredGrid* whole, const std::vector<vtkIdType>& cells,
  const std::vector<vtkIdType>& place, vtkUnstructuredGrid* part)
{
  const CellReader reader(whole);
  std::vector<vtkIdType> scratch;
  vtkNew<vtkIdList> ids;
  const auto find = [&](vtkIdType i)
  { ids->SetId(i, Exists(ids->GetId(i), place) ? place[ids->GetId(i)] : -1); };
  for (const vtkIdType c : InTurn(cells))
  {
    int type = reader.GetCellType(c);
    if (type == VTK_POLYHEDRON)
    {
      // The number of faces, then the size and the points of each.
      type = ReadFaceStream(whole, c, ids) ? VTK_POLYHEDRON : VTK_EMPTY_CELL;
      for (vtkIdType face = 1; face < ids->GetNumberOfIds(); face += ids->GetId(face) + 1)
      {
        for (vtkIdType i = 1; i <= ids->GetId(face); ++i)
        {
          find(face + i);
        }
      }
    }
    else
    {
      const CellIds cell = reader.GetCell(c, scratch);
      ids->SetNumberOfIds(cell.Size);
      for (vtkIdType i = 0; i < cell.Size; ++i)
      {
        ids->SetId(i, cell.Ids[i]);
        find(i);
      }
    }
    part->InsertNextCell(type, ids);
  }
}

/// Takes the values of `sources` of `size` points or cells.
void TakeArrays(vtkDataSetAttributes* from, vtkIdType size, const std::vector<vtkIdType>& sources,
  vtkDataSetAttributes* to)
{
  const Row<vtkIdType> row = { sources.data(), sources.data() + sources.size() };
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    const bool isOfBlocks = array->GetName() && std::string(array->GetName()) == BlockName;
    if (!isOfBlocks && HasValues(array, size))
    {
      AddLike(from, a, Gather(array, row), to);
    }
  }
}

}

vtkSmartPointer<vtkPointSet> MakeMesh(bool isPolyData)
{
  if (isPolyData)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  return vtkSmartPointer<vtkUnstructuredGrid>::New();
}

JoinedMesh Join(const std::vector<MeshPart>& parts, int pointType, bool keepsOwnFloats)
{
  std::vector<CellReader> readers;
  bool isPolyData = true;
  for (const MeshPart& part : parts)
  {
    readers.emplace_back(part.Mesh);
    isPolyData = isPolyData && vtkPolyData::SafeDownCast(part.Mesh);
  }
  JoinedMesh joined;
  joined.Mesh = MakeMesh(isPolyData);
  std::vector<Item> points;
  Places pointPlaces =
    PlaceItems(parts, &MeshPart::Points, [](size_t, vtkIdType) { return 0; }, points);
  std::vector<Item> cells;
  Places cellPlaces = PlaceItems(
    parts, &MeshPart::Cells, [&](size_t part, vtkIdType cell)
    { return isPolyData ? GetKind(readers[part].GetCellType(cell)) : 0; }, cells);
  joined.Mesh->SetPoints(JoinPoints(parts, points, pointType));
  JoinCells(readers, cells, pointPlaces, joined.Mesh);
  joined.PointArrays = JoinArrays(
    parts, pointPlaces, vtkDataObject::POINT, keepsOwnFloats, joined.Mesh->GetPointData());
  ExtendArrays(joined.Mesh, joined.PointArrays, pointPlaces);
  joined.CellArrays =
    JoinArrays(parts, cellPlaces, vtkDataObject::CELL, false, joined.Mesh->GetCellData());
  JoinLeaves(parts, cells, pointPlaces, joined.Mesh);
  AddBlocks(parts, cells, joined.Mesh);
  joined.PointIds = GetIds(points);
  joined.CellIds = GetIds(cells);
  joined.PointPlaces = std::move(pointPlaces.OfPart);
  joined.CellPlaces = std::move(cellPlaces.OfPart);
  return joined;
}

std::vector<std::vector<vtkIdType>> FindCellsOfBlocks(vtkPointSet* whole, int count)
{
  std::vector<std::vector<vtkIdType>> cells(static_cast<size_t>(count));
  auto* blocks = vtkIntArray::SafeDownCast(whole->GetCellData()->GetArray(BlockName));
  const vtkIdType size = blocks ? blocks->GetNumberOfValues() : 0;
  for (const vtkIdType c : InTurn(size))
  {
    const int block = blocks->GetValue(c);
    if (block >= 0 && block < count)
    {
      cells[block].push_back(c);
    }
  }
  return cells;
}

std::vector<vtkIdType> TakeCells(vtkPointSet* whole, const std::vector<vtkIdType>& cells,
  const std::vector<vtkIdType>& kept, vtkPointSet* part)
{
  const CellReader reader(whole);
  std::vector<vtkIdType> place(whole->GetNumberOfPoints(), -1);
  const std::vector<vtkIdType> points = FindPoints(reader, cells, kept, place);

  TakeValues(whole, points, cells, part);
  TakeLeaves(whole, cells, points, part);
  if (HasPolyhedra(reader))
  {
    TakeWithFaces(vtkUnstructuredGrid::SafeDownCast(whole), cells, place,
      vtkUnstructuredGrid::SafeDownCast(part));
    return points;
  }
  const bool isPolyData = vtkPolyData::SafeDownCast(whole) != nullptr;
  CellLists lists(static_cast<vtkIdType>(cells.size()));
  std::vector<vtkIdType> scratch;
  for (const size_t i : InTurn(cells.size()))
  {
    const CellIds cell = reader.GetCell(cells[i], scratch);
    const int type = reader.GetCellType(cells[i]);
    lists.Start(static_cast<vtkIdType>(i), isPolyData ? GetKind(type) : 0, type);
    for (vtkIdType k = 0; k < cell.Size; ++k)
    {
      lists.Add(Exists(cell.Ids[k], place) ? place[cell.Ids[k]] : -1);
    }
    lists.End();
  }
  lists.GiveTo(part);
  return points;
}

void TakeValues(vtkPointSet* whole, const std::vector<vtkIdType>& points,
  const std::vector<vtkIdType>& cells, vtkPointSet* part)
{
  auto coordinates = vtkSmartPointer<vtkPoints>::New();
  coordinates->SetDataType(whole->GetPoints()->GetDataType());
  coordinates->SetData(vtkDataArray::SafeDownCast(
    Gather(whole->GetPoints()->GetData(), { points.data(), points.data() + points.size() })));
  part->SetPoints(coordinates);
  TakeArrays(whole->GetPointData(), whole->GetNumberOfPoints(), points, part->GetPointData());
  TakeArrays(whole->GetCellData(), whole->GetNumberOfCells(), cells, part->GetCellData());
}

}
