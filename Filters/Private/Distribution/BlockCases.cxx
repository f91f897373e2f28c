// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/BlockCases.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Distribution/JoinedArrays.h"
#include "Private/Partitions/SharedDirectory.h"
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
#include <set>
#include <sstream>
#include <tuple>

namespace subdivision
{
namespace
{

using Parts = std::vector<MeshPart>;
using Warn = std::function<void(const std::string&)>;

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
    Turns turns;
    for (size_t begin = 0, end = 0; begin < points.size(); begin = end, turns.Next())
    {
      const auto& first = points[begin];
      bool isKnown = !isOwn;
      for (; end < points.size() && std::get<0>(points[end]) == std::get<0>(first); ++end)
      {
        isKnown = isKnown || parts[std::get<2>(points[end])].Block != NoBlock;
      }
      for (size_t k = begin + 1; k < end && isKnown; ++k)
      {
        if (std::get<1>(points[k]) != std::get<1>(first))
        {
          this->Compare(
            std::get<2>(first), std::get<3>(first), std::get<2>(points[k]), std::get<3>(points[k]));
        }
      }
    }
  }

  std::map<std::string, Difference> OfArrays;
  std::set<int> Blocks; ///< with other values: twice the number, and 1 for floating point values
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

/// Adds the cells of a dimension that have points which exist: as keys two numbers for the points,
/// and the message about each is its block and a number for the values at its points.
void AddCells(const MeshPart& part, int dimension, SharedKeys& cells, std::vector<vtkIdType>& told)
{
  const std::vector<std::uint64_t> values = HashValues(part);
  std::vector<vtkIdType> ids;
  ForEachCellOf(part, dimension,
    [&](int, const CellIds& cell)
    {
      std::uint64_t ofValues = 0;
      ids.clear();
      for (vtkIdType k = 0; k < cell.Size; ++k)
      {
        const bool exists = cell.Ids[k] >= 0 && cell.Ids[k] < part.Mesh->GetNumberOfPoints();
        ids.push_back(exists ? part.Points[cell.Ids[k]] : -1);
        ofValues += exists ? Mix(values[cell.Ids[k]], static_cast<std::uint64_t>(ids[k])) : 0;
      }
      SortDistinct(ids);
      std::uint64_t ofPoints[2] = { 0, 0 };
      for (const vtkIdType id : ids)
      {
        ofPoints[0] = Mix(ofPoints[0], static_cast<std::uint64_t>(id));
        ofPoints[1] = Mix(ofPoints[1] + 1, ~static_cast<std::uint64_t>(id));
      }
      if (!ids.empty() && ids[0] >= 0)
      {
        cells.Keys.push_back(static_cast<vtkIdType>(ofPoints[0] >> 1));
        cells.Keys.push_back(static_cast<vtkIdType>(ofPoints[1]));
        cells.Own.push_back(1);
        told.insert(told.end(), { part.Index, static_cast<vtkIdType>(ofValues) });
      }
    });
}

using BlockPair = std::array<int, 2>; ///< the first one less, or the same

/// Blocks with cells in common; of more than two with one cell each and the next. Of a block and
/// itself: all of its cells.
struct CommonCells
{
  BlockPair Blocks;
  int AreOther; ///< whether values at the points of one of them differ
  vtkIdType Count;

  void Add(vtkIdType count, int areOther)
  {
    this->Count += count;
    this->AreOther |= areOther;
  }
};

using CommonOfBlocks = std::map<BlockPair, CommonCells>;

CommonCells& FindCommon(CommonOfBlocks& counts, const BlockPair& blocks)
{
  return counts.try_emplace(blocks, CommonCells{ blocks, 0, 0 }).first->second;
}

/// Counts the cells that a directory knows.
std::vector<CommonCells> CountCommon(SharedDirectory& directory)
{
  CommonOfBlocks counts;
  std::vector<std::pair<int, vtkIdType>> blocks; // of one cell, and numbers for values
  directory.ForThings(
    [&](auto first, auto last)
    {
      blocks.clear();
      for (; first != last; ++first)
      {
        blocks.emplace_back(static_cast<int>(first->Told[0]), first->Told[1]);
      }
      std::stable_sort(blocks.begin(), blocks.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; });
      for (size_t i = 0; i < blocks.size(); ++i)
      {
        const int own = blocks[i].first;
        FindCommon(counts, { own, own }).Add(1, 0);
        if (i > 0 && blocks[i - 1].first != own)
        {
          FindCommon(counts, { blocks[i - 1].first, own })
            .Add(1, blocks[i].second != blocks[i - 1].second ? 1 : 0);
        }
      }
    });
  std::vector<CommonCells> common;
  for (const auto& [pair, count] : counts)
  {
    common.push_back(count);
  }
  return common;
}

/// Pairs of blocks that are cases of one mesh.
std::vector<BlockPair> FindPairs(const Parts& parts, Exchange& exchange)
{
  vtkIdType highest = 0;
  for (const MeshPart& part : parts)
  {
    ForEachCellOf(part, -1,
      [&](int dimension, const CellIds&) { highest = std::max<vtkIdType>(highest, dimension); });
  }
  const auto dimension = static_cast<int>(exchange.Max(highest));
  SharedKeys cells;
  cells.Width = 2;
  std::vector<vtkIdType> told;
  for (const MeshPart& part : parts)
  {
    AddCells(part, dimension, cells, told);
  }
  SharedDirectory directory(cells, 2, told, 0, exchange);
  std::vector<CommonCells> all = CountCommon(directory);
  exchange.ShareWithAll(all);
  CommonOfBlocks sums;
  for (const CommonCells& common : all)
  {
    FindCommon(sums, common.Blocks).Add(common.Count, common.AreOther);
  }
  std::vector<BlockPair> pairs;
  for (const auto& [blocks, sum] : sums)
  {
    const auto [a, b] = blocks;
    const vtkIdType fewer = std::min(sums.at({ a, a }).Count, sums.at({ b, b }).Count);
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
  for (const MeshPart& part : parts)
  {
    last = std::max<vtkIdType>(last, part.Index);
    first = std::max<vtkIdType>(first, -part.Index);
  }
  return exchange.Max(last) > -exchange.Max(first);
}

bool FindCases(Parts& parts, Exchange& exchange, const Warn& warn)
{
  const std::vector<BlockPair> pairs = FindPairs(parts, exchange);
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
  const std::string differences =
    pairs.empty() ? std::string() : BlockValues(parts, false).Describe();
  vtkIdType areSeveral = pairs.empty() ? 0 : 1;
  for (MeshPart& part : parts)
  {
    bool hasCells = false;
    ForEachCellOf(part, -1, [&](int, const CellIds&) { hasCells = true; });
    part.Case = hasCells ? cases[part.Index] : -1 - part.Index;
    areSeveral = part.Case != 0 ? 1 : areSeveral;
    part.Variants.clear();
  }
  if (!pairs.empty() && exchange.GetPartition() == 0)
  {
    warn("Blocks have cells in common (the first are blocks " + std::to_string(pairs[0][0]) +
      " and " + std::to_string(pairs[0][1]) +
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
  const BlockValues values(parts, true);
  if (warn && values.NumberOfPoints > 0) // where values jump anyway that is no news
  {
    warn("Blocks have different values at " + std::to_string(values.NumberOfPoints) +
      " points that they share: they differ " + values.Describe() +
      ". Each block keeps its own, so that values jump between them. If they should not, compute "
      "them for all blocks together.");
  }
  std::vector<int> blocks(values.Blocks.begin(), values.Blocks.end());
  exchange.ShareWithAll(blocks);
  SortDistinct(blocks);
  for (MeshPart& part : parts)
  {
    const auto has = [&](int kind)
    { return std::binary_search(blocks.begin(), blocks.end(), 2 * part.Index + kind); };
    part.KeepsOwnFloats = has(1);
    part.KeepsOwn = part.KeepsOwnFloats || has(0);
  }
  return std::any_of(blocks.begin(), blocks.end(), [](int block) { return block % 2 != 0; });
}

}
