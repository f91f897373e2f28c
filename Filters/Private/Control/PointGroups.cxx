// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/PointGroups.h"

#include "Core/Memory/Sorting.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Reading/UnusedPoints.h"
#include "Private/Values/PointCopies.h"

#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <cstring>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace subdivision
{

bool IsNoValue(vtkDataSetAttributes* data, vtkAbstractArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return array == data->GetGlobalIds() || array == data->GetPedigreeIds() ||
    array == data->GetNormals() || name == OriginalPointIdsName || name == MaterialPointIdsName ||
    name == vtkDataSetAttributes::GhostArrayName();
}

PointGroups::PointGroups(
  const std::vector<vtkPointSet*>& meshes, double tolerance, const MergeOptions& options)
  : Meshes(meshes)
  , Options(options)
  , Tolerance(tolerance)
{
  this->Read();
  this->Find();
  if (this->Options.HasCopies)
  {
    this->NumberParts();
  }
}

void PointGroups::Read()
{
  vtkIdType size = 0;
  for (vtkPointSet* mesh : this->Meshes)
  {
    this->Starts.push_back(size);
    size += mesh->GetNumberOfPoints();
  }
  this->X = Buffer<double>(3 * size);
  this->Stands = Buffer<vtkIdType>(size);
  subdivision::ForEach(size, [&](vtkIdType i) { this->Stands[i] = i; });
  this->Firsts = Buffer<vtkIdType>(size);
  CopyInThreads(this->Stands.data(), size, this->Firsts.data());
  for (std::size_t m = 0; m < this->Meshes.size(); ++m)
  {
    vtkPointSet* mesh = this->Meshes[m];
    const vtkIdType points = mesh->GetNumberOfPoints();
    subdivision::ForEach(
      points, [&](vtkIdType i) { mesh->GetPoint(i, this->X.data() + 3 * (this->Starts[m] + i)); });
    std::vector<vtkIdType> ids = ReadIdsOf(mesh->GetPointData(), points);
    if (ids.empty())
    {
      ids.resize(static_cast<std::size_t>(points));
      std::iota(ids.begin(), ids.end(), vtkIdType(0));
    }
    this->GlobalIds.insert(this->GlobalIds.end(), ids.begin(), ids.end());
  }
}

void PointGroups::Find()
{
  const vtkIdType size = this->Stands.size();
  Buffer<unsigned char> used(size, 1);
  for (std::size_t m = 0; m < this->Meshes.size(); ++m)
  {
    for (const vtkIdType point : FindUnusedPoints(this->Meshes[m]))
    {
      used[this->Starts[m] + point] = 0;
    }
  }
  std::vector<vtkIdType> points;
  for (const vtkIdType i : InTurn(size))
  {
    if (used[i])
    {
      points.push_back(i);
    }
  }
  const PointOrder order{ this->GlobalIds.data() };
  const Buffer<vtkIdType> firsts = this->FindFirsts(points, order);
  Buffer<unsigned char> isMember(size, 0);
  for (const vtkIdType i : InTurn(firsts.size()))
  {
    this->Firsts[points[i]] = firsts[i];
    if (firsts[i] != points[i])
    {
      isMember[points[i]] = 1;
      isMember[firsts[i]] = 1;
    }
  }
  for (const vtkIdType i : InTurn(size))
  {
    if (isMember[i])
    {
      this->Members.push_back(i);
    }
  }
  StableSort(this->Members,
    [&](vtkIdType a, vtkIdType b)
    {
      return this->Firsts[a] != this->Firsts[b] ? this->Firsts[a] < this->Firsts[b] : order(a, b);
    });
  this->Equals = Buffer<vtkIdType>(size);
  CopyInThreads(this->Firsts.data(), size, this->Equals.data());
  this->ForEach([this](const Group& group) { this->Divide(group); });
}

/// The first point of the group of each.
Buffer<vtkIdType> PointGroups::FindFirsts(
  const std::vector<vtkIdType>& points, const PointOrder& order) const
{
  if (this->Options.Sides.empty())
  {
    return FindFirstOfNear(this->X.data(), points, this->Tolerance, order);
  }
  Sets sets(this->Stands.size());
  for (std::size_t m = 0; m < this->Meshes.size(); ++m)
  {
    const auto found = this->Options.Sides.find(this->Meshes[m]);
    for (const auto& [a, b] : found == this->Options.Sides.end() ? PointPairs() : found->second)
    {
      sets.Join(this->Starts[m] + a, this->Starts[m] + b);
    }
  }
  Buffer<vtkIdType> least(this->Stands.size(), -1); // of each set
  for (const vtkIdType point : InTurn(points))
  {
    vtkIdType& first = least[sets.Find(point)];
    first = first < 0 || order(point, first) ? point : first;
  }
  Buffer<vtkIdType> firsts(static_cast<vtkIdType>(points.size()));
  for (const vtkIdType i : InTurn(firsts.size()))
  {
    firsts[i] = least[sets.Find(points[static_cast<std::size_t>(i)])];
  }
  return firsts;
}

/// Whether points of different values of an array stay apart.
bool PointGroups::IsKept(vtkDataSetAttributes* data, vtkAbstractArray* array) const
{
  const bool isField = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  const bool isKept = (this->Options.Values == MergedValues::Keep && this->Options.HasSeams) ||
    (this->Options.HasCopies && isField);
  return vtkDataArray::SafeDownCast(array) && !IsNoValue(data, array) &&
    (isKept || (array == data->GetTCoords() && this->Options.KeepsTexture));
}

/// The bits of all values that are kept.
std::vector<std::uint64_t> PointGroups::GetKept(vtkIdType point) const
{
  std::vector<std::uint64_t> kept;
  const auto m = static_cast<std::size_t>(this->GetMesh(point));
  vtkPointData* data = this->Meshes[m]->GetPointData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    for (int k = 0; this->IsKept(data, array) &&
      array->GetNumberOfTuples() == this->Meshes[m]->GetNumberOfPoints() &&
      k < array->GetNumberOfComponents();
      ++k)
    {
      const double value =
        vtkDataArray::SafeDownCast(array)->GetComponent(point - this->Starts[m], k) + 0.;
      kept.emplace_back();
      std::memcpy(&kept.back(), &value, sizeof(value));
    }
  }
  return kept;
}

/// Finds out which points of a group stand for which.
void PointGroups::Divide(const Group& group)
{
  std::map<std::vector<std::uint64_t>, vtkIdType> equal;
  std::map<std::pair<vtkIdType, int>, vtkIdType> stands; // of equal ones in each mesh
  for (const vtkIdType point : group)
  {
    this->Equals[point] = equal.emplace(this->GetKept(point), point).first->second;
    const std::pair<vtkIdType, int> key(this->Equals[point], this->GetMesh(point));
    this->Stands[point] = stands.emplace(key, point).first->second;
  }
}

/// Numbers the parts that cells with points of equal values connect.
void PointGroups::NumberParts()
{
  Sets sets(this->Equals.size());
  for (const vtkIdType i : InTurn(this->Equals.size()))
  {
    sets.Join(i, this->Equals[i]);
  }
  for (std::size_t m = 0; m < this->Meshes.size(); ++m)
  {
    const CellReader cells(this->Meshes[m]);
    std::vector<vtkIdType> scratch;
    for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
    {
      const CellIds cell = cells.GetCell(c, scratch);
      vtkIdType first = -1;
      for (vtkIdType i = 0; i < cell.Size; ++i)
      {
        if (cell.Ids[i] >= 0 && cell.Ids[i] < this->Meshes[m]->GetNumberOfPoints())
        {
          const vtkIdType point = this->Starts[m] + cell.Ids[i];
          first = first < 0 ? point : first;
          sets.Join(first, point);
        }
      }
    }
  }
  for (const vtkIdType i : InTurn(this->Equals.size()))
  {
    this->Parts.push_back(sets.Find(i));
  }
  this->ForEach(
    [&](const Group& group)
    {
      std::map<vtkIdType, vtkIdType> valueOf; // of each part
      for (const vtkIdType point : group)
      {
        this->Torn += valueOf.emplace(this->Parts[point], this->Equals[point]).first->second !=
          this->Equals[point];
      }
    });
}

}
