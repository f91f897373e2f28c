// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/BlockCases.h"

#include "Core/Memory/Runs.h"
#include "Core/Memory/Sorting.h"
#include "Private/Distribution/JoinedArrays.h"
#include "Private/Reading/CellChecks.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <tuple>

namespace subdivision
{
namespace
{

using Parts = std::vector<std::vector<MeshPart>>;
using Warn = std::function<void(const std::string&)>;

/// The same list to all partitions: what all of them have, ascending and each once.
template <typename T>
std::vector<T> ShareWithAll(const std::vector<std::vector<T>>& own, Exchange& exchange)
{
  std::vector<Exchange::Lists<T>> lists(own.size());
  for (const size_t p : InTurn(own.size()))
  {
    for (int to = 0; to < exchange.GetNumberOfPartitions(); ++to)
    {
      lists[p][to] = own[p];
    }
  }
  std::vector<T> all;
  const std::vector<Exchange::Lists<T>> arrived = exchange.SendLists(lists);
  for (const auto& [from, list] : arrived[0])
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  SortDistinct(all);
  return all;
}

// ------------------------------------------------------------------------------------------------
// Values

/// Whether two values are other ones, and not by rounding only.
bool DoDiffer(double a, double b, double rounding)
{
  return a != b && !(std::isnan(a) && std::isnan(b)) &&
    !(std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b)));
}

double GetRounding(vtkDataArray* array)
{
  return !IsFloating(array) ? 0. : array->GetDataType() == VTK_FLOAT ? 2.5e-7 : 1e-12;
}

/// By how much components of two arrays of one type differ, 0 where that is no number; -1: they are
/// the same.
double FindDifference(
  vtkAbstractArray* a, vtkIdType i, vtkAbstractArray* b, vtkIdType k, int component)
{
  const int size = a->GetNumberOfComponents();
  auto* numbers = vtkDataArray::SafeDownCast(a);
  if (!numbers)
  {
    const vtkVariant value = a->GetVariantValue(i * size + component);
    return value == b->GetVariantValue(k * size + component) ? -1. : 0.;
  }
  const double x = numbers->GetComponent(i, component);
  const double y = static_cast<vtkDataArray*>(b)->GetComponent(k, component);
  const double difference = std::isfinite(x - y) ? std::abs(x - y) : 0.;
  return DoDiffer(x, y, GetRounding(numbers)) ? difference : -1.;
}

/// Whether an array has values of points, and no numbers of them.
bool HasValuesOfPoints(vtkAbstractArray* array, vtkPointData* data)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return !name.empty() && array != data->GetGlobalIds() && array != data->GetPedigreeIds() &&
    name != vtkDataSetAttributes::GhostArrayName() && name != OriginalPointIdsName &&
    name != MaterialPointIdsName;
}

/// The largest difference of an array, and the blocks that have it.
struct Difference
{
  double Most = -1.;
  int Blocks[2] = {};
};

/// Compares the values of blocks at the points that they share.
class BlockValues
{
public:
  /// `isOwn`: only at points that parts of this partition have.
  BlockValues(const std::vector<MeshPart>& parts, bool isOwn)
    : Parts(parts)
  {
    std::vector<std::tuple<vtkIdType, int, size_t, size_t>> points; // id, block, part, index
    for (size_t p = 0; p < parts.size(); ++p)
    {
      for (size_t i = 0; i < parts[p].Points.size(); ++i)
      {
        if (parts[p].Points[i] >= 0)
        {
          points.emplace_back(parts[p].Points[i], parts[p].Index, p, i);
        }
      }
    }
    StableSort(points, std::less<>());
    ForEachRun(
      points, [](const auto& point) { return std::get<0>(point); },
      [&](size_t begin, size_t end)
      {
        const bool isKnown = !isOwn ||
          std::any_of(points.begin() + begin, points.begin() + end,
            [&](const auto& point) { return parts[std::get<2>(point)].Block != NoBlock; });
        const auto& first = points[begin];
        for (size_t k = begin + 1; k < end && isKnown; ++k)
        {
          if (std::get<1>(points[k]) != std::get<1>(first))
          {
            this->Compare(std::get<2>(first), std::get<3>(first), std::get<2>(points[k]),
              std::get<3>(points[k]));
          }
        }
      });
  }

  std::map<std::string, Difference> OfArrays;
  std::set<int> Blocks; ///< with other values: twice the number, and 1 for those of floating point
  vtkIdType NumberOfPoints = 0;

  /// "150 in the array "T" (blocks 1 and 2)"; empty where there are none.
  std::string Describe() const
  {
    std::ostringstream text;
    for (const auto& [name, difference] : this->OfArrays)
    {
      text << (text.tellp() > 0 ? ", " : "");
      if (difference.Most > 0.)
      {
        text << "by up to " << difference.Most << " ";
      }
      text << "in the point array \"" << name << "\" (blocks " << difference.Blocks[0] << " and "
           << difference.Blocks[1] << ")";
    }
    return text.str();
  }

private:
  struct ArrayPair
  {
    vtkAbstractArray* A;
    vtkAbstractArray* B;
  };

  const std::vector<ArrayPair>& FindPairs(size_t a, size_t b)
  {
    const auto [found, isNew] = this->Pairs.emplace(std::make_pair(a, b), std::vector<ArrayPair>());
    vtkPointSet* mesh = this->Parts[a].Mesh;
    vtkPointSet* other = this->Parts[b].Mesh;
    vtkPointData* data = mesh->GetPointData();
    for (int i = 0; isNew && i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      vtkAbstractArray* same = HasValuesOfPoints(array, data)
        ? other->GetPointData()->GetAbstractArray(array->GetName())
        : nullptr;
      if (same && same->GetDataType() == array->GetDataType() &&
        same->GetNumberOfComponents() == array->GetNumberOfComponents() &&
        array->GetNumberOfTuples() == mesh->GetNumberOfPoints() &&
        same->GetNumberOfTuples() == other->GetNumberOfPoints())
      {
        found->second.push_back({ array, same });
      }
    }
    return found->second;
  }

  void Compare(size_t a, size_t i, size_t b, size_t k)
  {
    bool isOther = false;
    for (const ArrayPair& pair : this->FindPairs(a, b))
    {
      for (int c = 0; c < pair.A->GetNumberOfComponents(); ++c)
      {
        const double difference =
          FindDifference(pair.A, static_cast<vtkIdType>(i), pair.B, static_cast<vtkIdType>(k), c);
        if (difference >= 0.)
        {
          isOther = true;
          this->Add(a, b, difference, pair);
        }
      }
    }
    this->NumberOfPoints += isOther ? 1 : 0;
  }

  void Add(size_t a, size_t b, double difference, const ArrayPair& pair)
  {
    Difference& most = this->OfArrays[pair.A->GetName()];
    if (difference > most.Most)
    {
      most = { difference, { this->Parts[a].Index, this->Parts[b].Index } };
    }
    const int isFloating = IsFloating(pair.A) ? 1 : 0;
    this->Blocks.insert(
      { 2 * this->Parts[a].Index + isFloating, 2 * this->Parts[b].Index + isFloating });
  }

  const std::vector<MeshPart>& Parts;
  std::map<std::pair<size_t, size_t>, std::vector<ArrayPair>> Pairs;
};

// ------------------------------------------------------------------------------------------------
// Cells

/// The points of a cell, as two numbers, its block, and a number for the values at its points.
struct CellOfBlock
{
  std::uint64_t First;
  std::uint64_t Second;
  int Block;
  int Unused;
  std::uint64_t Values;

  auto GetOrder() const { return std::tie(this->First, this->Second, this->Block); }
  bool operator<(const CellOfBlock& other) const { return this->GetOrder() < other.GetOrder(); }
};

std::uint64_t Mix(std::uint64_t hash, std::uint64_t value)
{
  hash = (hash ^ value) * 0x9e3779b97f4a7c15u;
  return hash ^ (hash >> 31);
}

/// Calls visit(cell, its points) for the cells of a part that are there, not hidden, and of
/// `dimension`; less than 0: of any.
template <typename Visit>
void ForEachCellOf(const MeshPart& part, int dimension, const Visit& visit)
{
  const CellReader reader(part.Mesh);
  const unsigned char* types = GetGhosts(part.Mesh, reader.GetNumberOfCells());
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
  {
    const int own = GetDimensionOfType(reader.GetCellType(c));
    const bool isHidden = types && IsHiddenCell(types[c]);
    if (part.Cells[c] >= 0 && !isHidden && own >= 0 && (dimension < 0 || dimension == own))
    {
      visit(own, reader.GetCell(c, scratch));
    }
  }
}

/// A number for the values at each point, which rounding seldom changes.
std::vector<std::uint64_t> HashValues(const MeshPart& part)
{
  std::vector<std::uint64_t> hashes(part.Points.size(), 0);
  vtkPointData* data = part.Mesh->GetPointData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* given = data->GetAbstractArray(a);
    const bool isUsed = HasValuesOfPoints(given, data) &&
      given->GetNumberOfTuples() == part.Mesh->GetNumberOfPoints();
    auto* array = vtkDataArray::SafeDownCast(given);
    const std::uint64_t name = isUsed ? std::hash<std::string>()(given->GetName()) : 0;
    for (const size_t i : InTurn(isUsed ? hashes.size() : size_t(0)))
    {
      for (int c = 0; c < given->GetNumberOfComponents(); ++c)
      {
        if (!array)
        {
          const vtkIdType at = static_cast<vtkIdType>(i) * given->GetNumberOfComponents() + c;
          const std::string text = given->GetVariantValue(at).ToString();
          hashes[i] += Mix(name + static_cast<std::uint64_t>(c), std::hash<std::string>()(text));
          continue;
        }
        const double value = array->GetComponent(static_cast<vtkIdType>(i), c);
        const float rounded = std::isnan(value) ? 0.f : static_cast<float>(value) + 0.f;
        std::uint32_t bits = std::isnan(value) ? 1 : 0;
        std::memcpy(&bits, &rounded, std::isnan(value) ? 0 : sizeof(bits));
        hashes[i] += Mix(Mix(name, static_cast<std::uint64_t>(c)), bits); // in any order
      }
    }
  }
  return hashes;
}

/// The cells of a dimension that have points which exist.
std::vector<CellOfBlock> FindCellsOf(const MeshPart& part, int dimension)
{
  const std::vector<std::uint64_t> values = HashValues(part);
  std::vector<CellOfBlock> cells;
  std::vector<vtkIdType> ids;
  ForEachCellOf(part, dimension,
    [&](int, const CellIds& cell)
    {
      CellOfBlock found{ 0, 0, part.Index, 0, 0 };
      ids.clear();
      for (vtkIdType k = 0; k < cell.Size; ++k)
      {
        const bool exists = cell.Ids[k] >= 0 && cell.Ids[k] < part.Mesh->GetNumberOfPoints();
        ids.push_back(exists ? part.Points[cell.Ids[k]] : -1);
        found.Values += exists ? Mix(values[cell.Ids[k]], static_cast<std::uint64_t>(ids[k])) : 0;
      }
      std::sort(ids.begin(), ids.end());
      ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
      for (const vtkIdType id : ids)
      {
        found.First = Mix(found.First, static_cast<std::uint64_t>(id));
        found.Second = Mix(found.Second + 1, ~static_cast<std::uint64_t>(id));
      }
      if (!ids.empty() && ids[0] >= 0)
      {
        cells.push_back(found);
      }
    });
  return cells;
}

/// Blocks with cells in common; of more than two with one cell each and the next. Of a block and
/// itself: all of its cells.
struct CommonCells
{
  int Blocks[2];
  int Partition; ///< that has counted
  int AreOther;  ///< whether values at the points of one of them differ
  vtkIdType Count;

  auto GetOrder() const
  {
    return std::tie(this->Blocks[0], this->Blocks[1], this->Partition, this->Count);
  }
  bool operator<(const CommonCells& other) const { return this->GetOrder() < other.GetOrder(); }
  bool operator==(const CommonCells& other) const { return this->GetOrder() == other.GetOrder(); }
};

/// Counts the cells that a directory knows.
std::vector<CommonCells> CountCommon(const Exchange::Lists<CellOfBlock>& arrived, int partition)
{
  std::vector<CellOfBlock> all;
  for (const auto& [from, list] : arrived)
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  StableSort(all, std::less<>());
  std::map<std::pair<int, int>, CommonCells> counts;
  for (const size_t i : InTurn(all.size()))
  {
    const bool isCommon = i > 0 && all[i].First == all[i - 1].First &&
      all[i].Second == all[i - 1].Second && all[i].Block != all[i - 1].Block;
    const auto add = [&](int other, bool isOther)
    {
      const auto at = counts.try_emplace(
        { other, all[i].Block }, CommonCells{ { other, all[i].Block }, partition, 0, 0 });
      ++at.first->second.Count;
      at.first->second.AreOther |= isOther ? 1 : 0;
    };
    add(all[i].Block, false);
    if (isCommon)
    {
      add(all[i - 1].Block, all[i].Values != all[i - 1].Values);
    }
  }
  std::vector<CommonCells> common;
  for (const auto& [blocks, count] : counts)
  {
    common.push_back(count);
  }
  return common;
}

/// Pairs of blocks that are cases of one mesh, the first one less.
using BlockPairs = std::vector<std::pair<int, int>>;

BlockPairs FindPairs(const Parts& parts, Exchange& exchange)
{
  vtkIdType highest = -1;
  for (const auto& partition : parts)
  {
    for (const MeshPart& part : partition)
    {
      ForEachCellOf(part, -1,
        [&](int dimension, const CellIds&) { highest = std::max<vtkIdType>(highest, dimension); });
    }
  }
  const auto dimension = static_cast<int>(exchange.Max(highest));
  const auto partitions = static_cast<std::uint64_t>(exchange.GetNumberOfPartitions());
  std::vector<Exchange::Lists<CellOfBlock>> lists(parts.size());
  for (const size_t p : InTurn(dimension < 0 ? size_t(0) : parts.size()))
  {
    for (const MeshPart& part : parts[p])
    {
      for (const CellOfBlock& cell : FindCellsOf(part, dimension))
      {
        lists[p][static_cast<int>(cell.First % partitions)].push_back(cell);
      }
    }
  }
  const std::vector<Exchange::Lists<CellOfBlock>> arrived = exchange.SendLists(lists);
  std::vector<std::vector<CommonCells>> own;
  for (size_t p = 0; p < arrived.size(); ++p)
  {
    own.push_back(CountCommon(arrived[p], exchange.GetPartition(static_cast<int>(p))));
  }
  std::map<std::pair<int, int>, CommonCells> sums;
  for (const CommonCells& common : ShareWithAll(own, exchange))
  {
    CommonCells& sum = sums[{ common.Blocks[0], common.Blocks[1] }];
    sum.Count += common.Count;
    sum.AreOther |= common.AreOther;
  }
  BlockPairs pairs;
  for (const auto& [blocks, sum] : sums)
  {
    const auto [a, b] = blocks;
    const vtkIdType fewer = std::min(sums[{ a, a }].Count, sums[{ b, b }].Count);
    if (a != b && (sum.AreOther || 2 * sum.Count >= fewer))
    {
      pairs.push_back(blocks);
    }
  }
  return pairs;
}

}

bool AreSeveralBlocks(const Parts& parts, Exchange& exchange)
{
  vtkIdType last = -1;
  vtkIdType first = -VTK_INT_MAX;
  for (const auto& partition : parts)
  {
    for (const MeshPart& part : partition)
    {
      last = std::max<vtkIdType>(last, part.Index);
      first = std::max<vtkIdType>(first, -part.Index);
    }
  }
  return exchange.Max(last) > -exchange.Max(first);
}

bool FindCases(Parts& parts, Exchange& exchange, const Warn& warn)
{
  const BlockPairs pairs = FindPairs(parts, exchange);
  std::map<int, int> firsts; // of the blocks that pairs connect
  const std::function<int(int)> findFirst = [&](int block)
  {
    const auto found = firsts.find(block);
    return found == firsts.end() ? block : found->second = findFirst(found->second);
  };
  std::set<int> blocks;
  for (const auto& [a, b] : pairs)
  {
    const auto [first, second] = std::minmax({ findFirst(a), findFirst(b) });
    if (first != second)
    {
      firsts[second] = first;
    }
    blocks.insert({ a, b });
  }
  std::map<int, int> cases;
  std::map<int, int> counts;
  for (const int block : blocks)
  {
    cases[block] = counts[findFirst(block)]++;
  }
  std::string differences;
  vtkIdType areSeveral = pairs.empty() ? 0 : 1;
  for (auto& partition : parts)
  {
    if (!pairs.empty())
    {
      differences = BlockValues(partition, false).Describe();
    }
    for (MeshPart& part : partition)
    {
      bool hasCells = false;
      ForEachCellOf(part, -1, [&](int, const CellIds&) { hasCells = true; });
      part.Case = hasCells ? cases[part.Index] : -1 - part.Index;
      areSeveral = part.Case != 0 ? 1 : areSeveral;
      part.Variants.clear();
    }
  }
  if (!pairs.empty() && exchange.GetPartition(0) == 0)
  {
    warn("Blocks have cells in common (the first are blocks " + std::to_string(pairs[0].first) +
      " and " + std::to_string(pairs[0].second) +
      "): they are taken for cases or time steps of one mesh, and not for neighbours. Each has its "
      "own points and values" +
      (differences.empty() ? "" : ", which differ " + differences) +
      ". Blocks that are parts of one object must not have the same cell twice: remove it from one "
      "of them, or mark it as a duplicate (vtkGhostType).");
  }
  return exchange.Max(areSeveral) > 0;
}

bool FindOwnBlocks(Parts& parts, Exchange& exchange, const Warn& warn)
{
  std::vector<std::vector<int>> own;
  for (const auto& partition : parts)
  {
    const BlockValues values(partition, true);
    own.emplace_back(values.Blocks.begin(), values.Blocks.end());
    if (warn && values.NumberOfPoints > 0) // where values jump anyway that is no news
    {
      warn("Blocks have different values at " + std::to_string(values.NumberOfPoints) +
        " points that they share: they differ " + values.Describe() +
        ". Each block keeps its own, so that values jump between them. If they should not, compute "
        "them for all blocks together.");
    }
  }
  const std::vector<int> blocks = ShareWithAll(own, exchange);
  for (auto& partition : parts)
  {
    for (MeshPart& part : partition)
    {
      const auto has = [&](int kind)
      { return std::binary_search(blocks.begin(), blocks.end(), 2 * part.Index + kind); };
      part.KeepsOwnFloats = has(1);
      part.KeepsOwn = part.KeepsOwnFloats || has(0);
    }
  }
  return std::any_of(blocks.begin(), blocks.end(), [](int block) { return block % 2 != 0; });
}

}
