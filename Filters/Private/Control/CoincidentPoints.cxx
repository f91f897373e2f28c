// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/CoincidentPoints.h"

#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/PointGroups.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Reading/UnusedPoints.h"
#include "Private/Values/PointCopies.h"

#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <utility>

namespace subdivision
{
namespace
{

/// Whether two different ids among these mean one point.
template <typename T, typename Stand>
bool Collapses(const T* begin, const T* end, const Stand& stand)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> ids;
  std::for_each(begin, end, [&](T id) { ids.emplace_back(stand(id), id); });
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end(), [](const auto& a, const auto& b)
           { return a.first == b.first && a.second != b.second; }) != ids.end();
}

/// Meshes whose points are merged, as if they were one.
class Merger
{
public:
  Merger(const std::vector<vtkPointSet*>& meshes, double tolerance, const MergeOptions& options)
    : Groups(meshes, tolerance, options)
    , Options(options)
  {
    this->FindReplaced();
  }
  /// Returns a mesh as it is if it does not change.
  vtkSmartPointer<vtkPointSet> Merge(std::size_t mesh);
  const ReplacedValues& GetReplaced() const { return this->OfArrays; }
  vtkIdType GetNumberOfCollapsed() const { return this->Collapsed; }
  vtkIdType GetFirstCollapsed() const { return this->FirstCollapsed; }
  vtkIdType GetNumberOfTorn() const { return this->Groups.Torn; }

private:
  using Group = PointGroups::Group;

  void FindReplaced();
  void Move(std::size_t mesh, vtkPointSet* merged) const;
  void ChangeIds(std::size_t mesh, vtkPointSet* merged);
  void AddStands(std::size_t mesh, vtkPointSet* merged) const;
  void ChangeArrays(std::size_t mesh, vtkPointSet* merged) const;
  void AddCopies(std::size_t mesh, vtkPointSet* merged) const;
  bool IsAveraged(vtkAbstractArray* array) const
  {
    return this->Options.Values == MergedValues::Average &&
      IsSmoothed(array, this->Options.InterpolateIntegers);
  }

  const PointGroups Groups;
  const MergeOptions& Options;
  ReplacedValues OfArrays;
  std::atomic<vtkIdType> Collapsed{ 0 };
  std::atomic<vtkIdType> FirstCollapsed{ VTK_ID_MAX };
};

vtkSmartPointer<vtkPointSet> Merger::Merge(std::size_t mesh)
{
  vtkPointSet* input = this->Groups.Meshes[mesh];
  const bool changes = !this->Groups.Members.empty();
  if (!changes && !this->Options.HasCopies)
  {
    return input;
  }
  auto merged = vtkSmartPointer<vtkPointSet>::Take(input->NewInstance());
  merged->ShallowCopy(input);
  this->Move(mesh, merged);
  this->ChangeArrays(mesh, merged);
  this->ChangeIds(mesh, merged);
  this->AddStands(mesh, merged);
  if (this->Options.HasCopies)
  {
    this->AddCopies(mesh, merged);
  }
  return merged;
}

/// Moves all points of a group to the least place of any.
void Merger::Move(std::size_t mesh, vtkPointSet* merged) const
{
  if (this->Groups.Tolerance <= 0.)
  {
    return;
  }
  const vtkIdType begin = this->Groups.Starts[mesh];
  const vtkIdType end = begin + merged->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(merged->GetPoints()->GetDataType());
  points->DeepCopy(merged->GetPoints());
  const auto at = [this](vtkIdType i)
  {
    const double* x = this->Groups.X.data() + 3 * i;
    return std::array<double, 3>{ x[0], x[1], x[2] };
  };
  this->Groups.ForEach(
    [&](const Group& group)
    {
      const auto place = at(*std::min_element(
        group.begin(), group.end(), [&](vtkIdType a, vtkIdType b) { return at(a) < at(b); }));
      for (const vtkIdType point : group)
      {
        if (point >= begin && point < end)
        {
          points->SetPoint(point - begin, place.data());
        }
      }
    });
  merged->SetPoints(points);
}

void Merger::ChangeIds(std::size_t mesh, vtkPointSet* merged)
{
  const vtkIdType begin = this->Groups.Starts[mesh];
  const vtkIdType size = merged->GetNumberOfPoints();
  const auto stand = [&](vtkIdType id)
  { return id >= 0 && id < size ? this->Groups.Stands[begin + id] - begin : id; };
  auto* grid = vtkUnstructuredGrid::SafeDownCast(merged);
  const auto types = grid ? GetCellTypes(grid) : nullptr;
  ChangeCells(merged, size,
    [&](vtkIdType cell, auto* first, auto* last)
    {
      using Id = std::decay_t<decltype(*first)>;
      if (std::all_of(first, last, [&](Id id) { return stand(id) == id; }))
      {
        return;
      }
      if (Collapses(first, last, stand))
      {
        ++this->Collapsed;
        vtkIdType known = this->FirstCollapsed;
        while (cell < known && !this->FirstCollapsed.compare_exchange_weak(known, cell))
        {
        }
        // The loops of a polyhedron's faces end where their first point comes again.
        if (types && types->GetValue(cell) == FaceLoops)
        {
          return;
        }
      }
      std::transform(first, last, first, [&](Id id) { return static_cast<Id>(stand(id)); });
    });
}

/// Tells which points took the places of points that cells had and have no more.
void Merger::AddStands(std::size_t mesh, vtkPointSet* merged) const
{
  const vtkIdType begin = this->Groups.Starts[mesh];
  vtkNew<vtkIdTypeArray> stands;
  stands->SetName(MergedPointsName);
  stands->SetNumberOfValues(merged->GetNumberOfPoints());
  std::iota(
    stands->GetPointer(0), stands->GetPointer(0) + stands->GetNumberOfValues(), vtkIdType(0));
  for (const vtkIdType point : FindUnusedPoints(merged))
  {
    stands->SetValue(point, this->Groups.Stands[begin + point] - begin);
  }
  merged->GetPointData()->AddArray(stands);
}

/// Writes means, and leaves out texture coordinates that would come from one side.
void Merger::ChangeArrays(std::size_t mesh, vtkPointSet* merged) const
{
  vtkPointData* data = merged->GetPointData();
  const vtkIdType begin = this->Groups.Starts[mesh];
  const vtkIdType end = begin + merged->GetNumberOfPoints();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    auto* array = data->GetArray(a);
    if (!array || array->GetNumberOfTuples() != end - begin || IsNoValue(data, array) ||
      !this->IsAveraged(array))
    {
      continue;
    }
    const auto means = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    means->DeepCopy(array);
    this->Groups.ForEach(
      [&](const Group& group)
      {
        for (int k = 0; k < array->GetNumberOfComponents(); ++k)
        {
          std::map<vtkIdType, std::pair<double, int>> sums; // by the point that stands
          for (const vtkIdType point : group)
          {
            const bool isOurs = point >= begin && point < end;
            const double value = isOurs ? array->GetComponent(point - begin, k) : std::nan("");
            if (!std::isnan(value))
            {
              auto& [sum, count] = sums[this->Groups.Stands[point] - begin];
              sum += value;
              ++count;
            }
          }
          for (const auto& [point, sum] : sums)
          {
            const double mean = sum.first / sum.second;
            const bool isInteger =
              array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
            means->SetComponent(point, k, isInteger ? std::round(mean) : mean);
          }
        }
      });
    AddInstead(data, means, data);
  }
  for (const auto& [name, what] : this->OfArrays)
  {
    if (what.IsTexture)
    {
      data->RemoveArray(name.c_str());
    }
  }
}

void Merger::AddCopies(std::size_t mesh, vtkPointSet* merged) const
{
  const vtkIdType begin = this->Groups.Starts[mesh];
  const vtkIdType size = merged->GetNumberOfPoints();
  const auto ids = MakeArray(VTK_ID_TYPE, 1, size);
  ids->SetName(MaterialPointIdsName);
  ForEach(size, [&](vtkIdType i) { ids->SetComponent(i, 0, this->Groups.Firsts[begin + i]); });
  merged->GetPointData()->AddArray(ids);
  const CellReader cells(merged);
  const auto parts = MakeArray(VTK_ID_TYPE, 1, cells.GetNumberOfCells());
  parts->SetName(MergedPartsName);
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    const auto first = std::find_if(
      cell.Ids, cell.Ids + cell.Size, [size](vtkIdType id) { return id >= 0 && id < size; });
    const bool has = first != cell.Ids + cell.Size;
    parts->SetComponent(c, 0,
      static_cast<double>(has ? this->Groups.Parts[static_cast<std::size_t>(begin + *first)] : -1));
  }
  merged->GetCellData()->AddArray(parts);
}

void Merger::FindReplaced()
{
  for (std::size_t m = 0; m < this->Groups.Meshes.size(); ++m)
  {
    vtkPointData* data = this->Groups.Meshes[m]->GetPointData();
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = data->GetAbstractArray(a);
      if (IsNoValue(data, array) || this->IsAveraged(array) ||
        (this->Options.TearsTexture && array == data->GetTCoords()) ||
        array->GetNumberOfTuples() != this->Groups.Meshes[m]->GetNumberOfPoints())
      {
        continue;
      }
      Replaced found;
      for (const vtkIdType point : InTurn(this->Groups.Members))
      {
        const bool isOurs = this->Groups.GetMesh(point) == static_cast<int>(m);
        const double difference = isOurs ? GetDifference(array, point - this->Groups.Starts[m],
                                             this->Groups.Stands[point] - this->Groups.Starts[m])
                                         : 0.;
        found.Points += difference > 0.;
        found.Most = std::isfinite(difference) ? std::max(found.Most, difference) : found.Most;
      }
      if (found.Points > 0)
      {
        found.IsTexture = array == data->GetTCoords();
        this->OfArrays[array->GetName() ? array->GetName() : ""].Add(found);
      }
    }
  }
}

double FindTolerance(const std::vector<vtkPointSet*>& meshes, const MergeOptions& options)
{
  if (options.Tolerance <= 0.)
  {
    return 0.;
  }
  Box box;
  for (vtkPointSet* mesh : meshes)
  {
    for (const vtkIdType i : InTurn(mesh->GetNumberOfPoints()))
    {
      double x[3];
      mesh->GetPoint(i, x);
      if (std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]))
      {
        box.Add(x);
      }
    }
  }
  return options.Tolerance * GetDiagonal(box);
}

}

bool FindSides(vtkDataObject* readable, bool sharesRanks, MergeOptions& options,
  std::vector<std::string>& warnings)
{
  const bool areIdsShared =
    sharesRanks || (options.JoinsBlocks && vtkDataObjectTree::SafeDownCast(readable) != nullptr);
  bool isOpen = false;
  ChangeMeshes(readable,
    [&](vtkDataObject* data, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(data);
      vtkPointData* values = mesh ? mesh->GetPointData() : nullptr;
      // Seams of texture coordinates are joined later, copies of points know what they are, and
      // others may know points by their ids.
      if (values && !values->HasArray(MaterialPointIdsName) &&
        !(areIdsShared && values->GetGlobalIds()) &&
        !(options.KeepsTexture && values->GetTCoords()))
      {
        auto pairs = FindTouchingSides(mesh, &isOpen, sharesRanks);
        pairs.empty() ? void() : void(options.Sides.emplace(mesh, std::move(pairs)));
      }
      return data;
    });
  if (isOpen && sharesRanks)
  {
    warnings.emplace_back(
      "JoinSides: sides of a surface meet that are not closed on their rank. They stay apart, as "
      "no rank knows the sides of others. Apply vtkStaticCleanUnstructuredGrid (surfaces: "
      "vtkCleanPolyData) before the mesh is distributed.");
  }
  options.JoinsBlocks = options.KeepsTexture = false;
  const auto sides = options.Sides.find(vtkPointSet::SafeDownCast(readable));
  vtkDataArray* const texture =
    sides == options.Sides.end() ? nullptr : sides->first->GetPointData()->GetTCoords();
  const auto differs = [texture](const auto& pair)
  { return GetDifference(texture, pair.first, pair.second) > 0.; };
  options.TearsTexture = options.TearsTexture && !sharesRanks && !isOpen &&
    options.Values == MergedValues::First && texture &&
    texture->GetNumberOfTuples() == sides->first->GetNumberOfPoints() &&
    std::any_of(sides->second.begin(), sides->second.end(), differs);
  return !options.Sides.empty();
}

vtkSmartPointer<vtkDataObject> MergeCoincidentPoints(
  vtkDataObject* readable, const MergeOptions& options, std::vector<std::string>& warnings)
{
  std::vector<vtkPointSet*> meshes;
  ChangeMeshes(readable,
    [&](vtkDataObject* data, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(data);
      if (mesh && mesh->GetNumberOfPoints() > 0)
      {
        meshes.push_back(mesh);
      }
      return data;
    });
  const double tolerance = FindTolerance(meshes, options);
  std::map<vtkDataObject*, vtkSmartPointer<vtkPointSet>> merged;
  ReplacedValues replaced;
  vtkIdType collapsed = 0;
  vtkIdType first = VTK_ID_MAX;
  vtkIdType torn = 0;
  const auto mergeAll = [&](const std::vector<vtkPointSet*>& some)
  {
    Merger merger(some, tolerance, options);
    for (std::size_t m = 0; m < some.size(); ++m)
    {
      merged[some[m]] = merger.Merge(m);
    }
    for (const auto& [name, what] : merger.GetReplaced())
    {
      replaced[name].Add(what);
    }
    collapsed += merger.GetNumberOfCollapsed();
    first = std::min(first, merger.GetFirstCollapsed());
    torn += merger.GetNumberOfTorn();
  };
  if (options.JoinsBlocks)
  {
    mergeAll(meshes);
  }
  for (std::size_t m = 0; !options.JoinsBlocks && m < meshes.size(); ++m)
  {
    mergeAll({ meshes[m] });
  }
  DescribeReplaced(replaced, options.Values, !options.Sides.empty(), warnings);
  DescribeCollapsed(collapsed, first, warnings);
  DescribeTorn(torn, warnings);
  return ChangeMeshes(readable,
    [&](vtkDataObject* data, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      const auto found = merged.find(data);
      if (found == merged.end())
      {
        return data;
      }
      return found->second;
    });
}

}
