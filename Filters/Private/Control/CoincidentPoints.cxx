// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/CoincidentPoints.h"

#include "Core/Memory/Sorting.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/NearPoints.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Reading/UnusedPoints.h"
#include "Private/Values/PointCopies.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
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
    : Meshes(meshes)
    , Options(options)
    , Tolerance(tolerance)
  {
    this->Read();
    this->FindGroups();
  }
  /// Returns a mesh as it is if it does not change.
  vtkSmartPointer<vtkPointSet> Merge(std::size_t mesh);
  const ReplacedValues& GetReplaced() const { return this->OfArrays; }
  vtkIdType GetNumberOfCollapsed() const { return this->Collapsed; }
  vtkIdType GetFirstCollapsed() const { return this->FirstCollapsed; }
  vtkIdType GetNumberOfTorn() const { return this->Torn; }

private:
  using Group = Row<vtkIdType>;

  void Read();
  void FindGroups();
  void Divide(const Group& group);
  std::vector<std::uint64_t> GetKept(vtkIdType point) const;
  void FindReplaced();
  void NumberParts();
  void Move(std::size_t mesh, vtkPointSet* merged) const;
  void ChangeIds(std::size_t mesh, vtkPointSet* merged);
  void AddStands(std::size_t mesh, vtkPointSet* merged) const;
  void ChangeArrays(std::size_t mesh, vtkPointSet* merged) const;
  void AddCopies(std::size_t mesh, vtkPointSet* merged) const;
  template <typename Visit>
  void ForEachGroup(const Visit& visit) const;
  int GetMesh(vtkIdType point) const
  {
    return static_cast<int>(
      std::upper_bound(this->Starts.begin(), this->Starts.end(), point) - this->Starts.begin() - 1);
  }
  /// Whether points of different values of an array stay apart.
  bool IsKept(vtkDataSetAttributes* data, vtkAbstractArray* array) const
  {
    const bool isField = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
    const bool isKept = (this->Options.Values == MergedValues::Keep && this->Options.HasSeams) ||
      (this->Options.HasCopies && isField);
    return vtkDataArray::SafeDownCast(array) && !this->IsIgnored(data, array) &&
      (isKept || (array == data->GetTCoords() && this->Options.KeepsTexture));
  }
  /// Ids, which name points and are no values of theirs, and normals, which a filter makes anew.
  static bool IsIgnored(vtkDataSetAttributes* data, vtkAbstractArray* array)
  {
    const std::string name = array->GetName() ? array->GetName() : "";
    return array == data->GetGlobalIds() || array == data->GetPedigreeIds() ||
      array == data->GetNormals() || name == OriginalPointIdsName || name == MaterialPointIdsName ||
      name == vtkDataSetAttributes::GhostArrayName();
  }
  bool IsAveraged(vtkAbstractArray* array) const
  {
    return this->Options.Values == MergedValues::Average &&
      IsSmoothed(array, this->Options.InterpolateIntegers);
  }

  const std::vector<vtkPointSet*>& Meshes;
  const MergeOptions& Options;
  double Tolerance;
  std::vector<vtkIdType> Starts; ///< of the points of each mesh among all
  Buffer<double> X;
  std::vector<vtkIdType> GlobalIds; ///< or indices in the mesh, of all points
  std::vector<vtkIdType> Members;   ///< of groups of several points, group by group, in order
  Buffer<vtkIdType> Stands;         ///< the point of the same mesh that stands for each
  Buffer<vtkIdType> Firsts;         ///< the first point of each group
  Buffer<vtkIdType> Equals;         ///< the first point of the group that has equal kept values
  std::vector<vtkIdType> Parts;     ///< of each point, if there are copies
  ReplacedValues OfArrays;
  std::atomic<vtkIdType> Collapsed{ 0 };
  std::atomic<vtkIdType> FirstCollapsed{ VTK_ID_MAX };
  vtkIdType Torn = 0; ///< points that touch another of the same part, with another value
};

void Merger::Read()
{
  vtkIdType size = 0;
  for (vtkPointSet* mesh : this->Meshes)
  {
    this->Starts.push_back(size);
    size += mesh->GetNumberOfPoints();
  }
  this->X = Buffer<double>(3 * size);
  this->Stands = Buffer<vtkIdType>(size);
  ForEach(size, [&](vtkIdType i) { this->Stands[i] = i; });
  this->Firsts = Buffer<vtkIdType>(size);
  CopyInThreads(this->Stands.data(), size, this->Firsts.data());
  for (std::size_t m = 0; m < this->Meshes.size(); ++m)
  {
    vtkPointSet* mesh = this->Meshes[m];
    const vtkIdType points = mesh->GetNumberOfPoints();
    ForEach(
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

void Merger::FindGroups()
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
  const Buffer<vtkIdType> firsts = FindFirstOfNear(this->X.data(), points, this->Tolerance, order);
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
  this->ForEachGroup([this](const Group& group) { this->Divide(group); });
  this->FindReplaced();
  if (this->Options.HasCopies)
  {
    this->NumberParts();
  }
}

template <typename Visit>
void Merger::ForEachGroup(const Visit& visit) const
{
  const vtkIdType* const end = this->Members.data() + this->Members.size();
  Turns turns;
  for (const vtkIdType* first = this->Members.data(); first != end; turns.Next())
  {
    const vtkIdType* last = std::find_if(
      first, end, [&](vtkIdType i) { return this->Firsts[i] != this->Firsts[*first]; });
    visit(Group{ first, last });
    first = last;
  }
}

/// The bits of all values that are kept.
std::vector<std::uint64_t> Merger::GetKept(vtkIdType point) const
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
void Merger::Divide(const Group& group)
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
void Merger::NumberParts()
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
  this->ForEachGroup(
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

vtkSmartPointer<vtkPointSet> Merger::Merge(std::size_t mesh)
{
  vtkPointSet* input = this->Meshes[mesh];
  const bool changes = !this->Members.empty();
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
  if (this->Tolerance <= 0.)
  {
    return;
  }
  const vtkIdType begin = this->Starts[mesh];
  const vtkIdType end = begin + merged->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(merged->GetPoints()->GetDataType());
  points->DeepCopy(merged->GetPoints());
  const auto at = [this](vtkIdType i)
  {
    const double* x = this->X.data() + 3 * i;
    return std::array<double, 3>{ x[0], x[1], x[2] };
  };
  this->ForEachGroup(
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
  const vtkIdType begin = this->Starts[mesh];
  const vtkIdType size = merged->GetNumberOfPoints();
  const auto stand = [&](vtkIdType id)
  { return id >= 0 && id < size ? this->Stands[begin + id] - begin : id; };
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
  const vtkIdType begin = this->Starts[mesh];
  vtkNew<vtkIdTypeArray> stands;
  stands->SetName(MergedPointsName);
  stands->SetNumberOfValues(merged->GetNumberOfPoints());
  std::iota(
    stands->GetPointer(0), stands->GetPointer(0) + stands->GetNumberOfValues(), vtkIdType(0));
  for (const vtkIdType point : FindUnusedPoints(merged))
  {
    stands->SetValue(point, this->Stands[begin + point] - begin);
  }
  merged->GetPointData()->AddArray(stands);
}

/// Writes means, and leaves out texture coordinates that would come from one side.
void Merger::ChangeArrays(std::size_t mesh, vtkPointSet* merged) const
{
  vtkPointData* data = merged->GetPointData();
  const vtkIdType begin = this->Starts[mesh];
  const vtkIdType end = begin + merged->GetNumberOfPoints();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    auto* array = data->GetArray(a);
    if (!array || array->GetNumberOfTuples() != end - begin || IsIgnored(data, array) ||
      !this->IsAveraged(array))
    {
      continue;
    }
    const auto means = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    means->DeepCopy(array);
    this->ForEachGroup(
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
              auto& [sum, count] = sums[this->Stands[point] - begin];
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
  const vtkIdType begin = this->Starts[mesh];
  const vtkIdType size = merged->GetNumberOfPoints();
  const auto ids = MakeArray(VTK_ID_TYPE, 1, size);
  ids->SetName(MaterialPointIdsName);
  ForEach(size, [&](vtkIdType i) { ids->SetComponent(i, 0, this->Firsts[begin + i]); });
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
    parts->SetComponent(
      c, 0, static_cast<double>(has ? this->Parts[static_cast<std::size_t>(begin + *first)] : -1));
  }
  merged->GetCellData()->AddArray(parts);
}

void Merger::FindReplaced()
{
  for (std::size_t m = 0; m < this->Meshes.size(); ++m)
  {
    vtkPointData* data = this->Meshes[m]->GetPointData();
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = data->GetAbstractArray(a);
      if (IsIgnored(data, array) || this->IsAveraged(array) ||
        array->GetNumberOfTuples() != this->Meshes[m]->GetNumberOfPoints())
      {
        continue;
      }
      Replaced found;
      for (const vtkIdType point : InTurn(this->Members))
      {
        const bool isOurs = this->GetMesh(point) == static_cast<int>(m);
        const double difference = isOurs
          ? GetDifference(array, point - this->Starts[m], this->Stands[point] - this->Starts[m])
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
  DescribeReplaced(replaced, options.Values, warnings);
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
