// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/OwnValues.h"

#include "Core/Memory/Loops.h"
#include "Private/Distribution/JoinedArrays.h"
#include "Private/Values/MaterialFields.h"
#include "Private/Values/PointCopies.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace subdivision
{
namespace
{

/// A point of a part that becomes a copy.
struct Copy
{
  int Part;
  vtkIdType Index;
  vtkIdType Place; ///< in the joined mesh
};

/// An array of the joined mesh, and the arrays of the parts whose values it has; null: none.
struct Values
{
  std::string Name;
  vtkDataArray* Joined;
  std::vector<vtkDataArray*> OfPart;
};

std::vector<Values> FindValues(const std::vector<MeshPart>& parts, const JoinedMesh& joined)
{
  std::vector<Values> found;
  for (const JoinedArray& entry : joined.PointArrays)
  {
    vtkDataArray* array = joined.Mesh->GetPointData()->GetArray(entry.Name.c_str());
    if (!array || !IsFloating(array))
    {
      continue;
    }
    found.push_back({ entry.Name, array, {} });
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      found.back().OfPart.push_back(entry.OfPart[p]
          ? vtkDataArray::SafeDownCast(FindArray(parts[p].Mesh->GetPointData(), array, entry))
          : nullptr);
    }
  }
  return found;
}

/// Whether two tuples are the same; a number that is none is like another.
bool AreSame(vtkDataArray* a, vtkIdType i, vtkDataArray* b, vtkIdType j)
{
  for (int c = 0; c < a->GetNumberOfComponents(); ++c)
  {
    const double x = a->GetComponent(i, c);
    const double y = b->GetComponent(j, c);
    if (x != y && !(std::isnan(x) && std::isnan(y)))
    {
      return false;
    }
  }
  return true;
}

/// The points of parts for which one of the arrays has another value in the mesh.
std::vector<Copy> FindCopies(const std::vector<MeshPart>& parts, const JoinedMesh& joined,
  const std::vector<Values>& arrays, OwnValues keeps)
{
  std::vector<Copy> copies;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const bool keepsOwn = keeps == OwnValues::OfAll || parts[p].KeepsOwnFloats;
    const std::vector<vtkIdType> none;
    const std::vector<vtkIdType>& places = keepsOwn ? joined.PointPlaces[p] : none;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const Copy copy{ static_cast<int>(p), static_cast<vtkIdType>(i), places[i] };
      const auto isOther = [&](const Values& values)
      {
        return values.OfPart[p] &&
          !AreSame(values.OfPart[p], copy.Index, values.Joined, copy.Place);
      };
      if (copy.Place >= 0 && std::any_of(arrays.begin(), arrays.end(), isOther))
      {
        copies.push_back(copy);
      }
    }
  }
  return copies;
}

/// Tells of each cell whose values it reads: its block, or 0 where blocks agree.
void AddOwnBlocks(const std::vector<MeshPart>& parts, JoinedMesh& joined)
{
  const auto blocks = MakeArray(VTK_INT, 1, joined.Mesh->GetNumberOfCells());
  blocks->SetName(OwnBlockName);
  blocks->Fill(0.);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (const vtkIdType place : InTurn(joined.CellPlaces[p]))
    {
      if (place >= 0 && parts[p].KeepsOwnFloats)
      {
        blocks->SetComponent(place, 0, 1. + parts[p].Index);
      }
    }
  }
  joined.Mesh->GetCellData()->AddArray(blocks);
}

}

void TakeCopiedPoints(std::vector<MeshPart>& parts)
{
  for (MeshPart& part : parts)
  {
    vtkPointData* data = part.Mesh->GetPointData();
    if (HasIds(data, MaterialPointIdsName, part.Mesh->GetNumberOfPoints()))
    {
      vtkDataArray* ids = data->GetArray(MaterialPointIdsName);
      for (std::size_t i = 0; i < part.Points.size(); ++i)
      {
        const vtkIdType id = ToId(ids->GetComponent(static_cast<vtkIdType>(i), 0));
        const bool isOther = id >= 0 && id < part.Points[i];
        part.Points[i] = isOther ? id : part.Points[i];
      }
    }
  }
}

void KeepOwnValues(const std::vector<MeshPart>& parts, JoinedMesh& joined, OwnValues keeps)
{
  if (keeps == OwnValues::OfBlocks)
  {
    AddOwnBlocks(parts, joined);
  }

  const std::vector<Values> arrays = FindValues(parts, joined);
  const std::vector<Copy> copies = FindCopies(parts, joined, arrays, keeps);
  vtkPointSet* mesh = joined.Mesh;
  if (copies.empty() && !mesh->GetPointData()->HasArray(MaterialPointIdsName))
  {
    return;
  }
  const vtkIdType size = mesh->GetNumberOfPoints();
  std::vector<std::vector<vtkIdType>> newIds = joined.PointPlaces; // of the points of parts
  std::vector<vtkIdType> sources;
  for (const vtkIdType i : InTurn(size))
  {
    sources.push_back(i);
  }
  for (const Copy& copy : InTurn(copies))
  {
    newIds[copy.Part][copy.Index] = static_cast<vtkIdType>(sources.size());
    sources.push_back(copy.Place);
  }
  // The part of each cell, which is the first that has it, and its id there.
  std::vector<std::pair<int, vtkIdType>> cells(mesh->GetNumberOfCells(), { -1, -1 });
  std::vector<CellReader> readers;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    readers.emplace_back(parts[p].Mesh);
    for (std::size_t c = 0; c < joined.CellPlaces[p].size(); ++c)
    {
      const vtkIdType place = joined.CellPlaces[p][c];
      if (place >= 0 && cells[place].first < 0)
      {
        cells[place] = { static_cast<int>(p), static_cast<vtkIdType>(c) };
      }
    }
  }
  TakePoints(mesh, sources,
    [&](vtkIdType cell, auto* begin, auto* end)
    {
      const auto [part, index] = cells[cell];
      std::vector<vtkIdType> scratch;
      const CellIds ids = readers[part].GetCell(index, scratch);
      const std::vector<vtkIdType>& ofPart = newIds[part];
      for (vtkIdType k = 0; k < std::min<vtkIdType>(ids.Size, end - begin); ++k)
      {
        const bool exists = ids.Ids[k] >= 0 && ids.Ids[k] < static_cast<vtkIdType>(ofPart.size());
        begin[k] = static_cast<std::decay_t<decltype(*begin)>>(exists ? ofPart[ids.Ids[k]] : -1);
      }
    });
  for (const Values& values : arrays)
  {
    vtkDataArray* array = mesh->GetPointData()->GetArray(values.Name.c_str());
    for (std::size_t i = 0; i < copies.size(); ++i)
    {
      if (vtkDataArray* from = values.OfPart[copies[i].Part])
      {
        array->SetTuple(size + static_cast<vtkIdType>(i), copies[i].Index, from);
      }
    }
  }
  const auto ids = MakeArray(VTK_ID_TYPE, 1, static_cast<vtkIdType>(sources.size()));
  std::copy(sources.begin(), sources.end(), static_cast<vtkIdType*>(ids->GetVoidPointer(0)));
  ids->SetName(MaterialPointIdsName);
  mesh->GetPointData()->AddArray(ids);
}

}
