// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Values/MaterialColours.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Run/Features.h"
#include "Private/Values/PointCopies.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace subdivision
{
namespace
{

constexpr int NoMaterial = -1;

/// Whether each simplex is no face of another one.
std::vector<char> FindMaximal(const ColouredSimplices& pieces)
{
  std::vector<char> isMaximal(static_cast<std::size_t>(pieces.GetSize()), 1);
  const auto& dimensions = pieces.Cells.Simplices.Dimensions;
  if (dimensions.empty() ||
    std::all_of(dimensions.begin(), dimensions.end(), [&](int d) { return d == dimensions[0]; }))
  {
    return isMaximal;
  }
  std::unordered_multimap<vtkIdType, vtkIdType> smaller; // by one of their points
  for (vtkIdType i = 0; i < pieces.GetSize(); ++i)
  {
    if (pieces.GetDimension(i) < 3)
    {
      smaller.emplace(*pieces.GetPoints(i).begin(), i);
    }
  }
  for (vtkIdType i = 0; i < pieces.GetSize(); ++i)
  {
    for (const vtkIdType point : pieces.GetPoints(i))
    {
      const auto range = smaller.equal_range(point);
      for (auto at = range.first; at != range.second; ++at)
      {
        const Row<vtkIdType> points = pieces.GetPoints(at->second);
        const bool isFace = pieces.GetDimension(at->second) < pieces.GetDimension(i) &&
          std::all_of(points.begin(), points.end(), [&](vtkIdType p) { return pieces.Has(i, p); });
        isMaximal[at->second] = isMaximal[at->second] && !isFace;
      }
    }
  }
  return isMaximal;
}

using MaterialPairs = std::vector<std::pair<int, int>>;

/// Whether all cells at each point are known, because a cell of this partition has the point.
std::vector<char> FindKnownPoints(const ColouredSimplices& pieces, OtherPartitions* others)
{
  const auto size = static_cast<std::size_t>(pieces.Cells.Simplices.NumberOfPoints);
  std::vector<char> isKnown(size, others ? 0 : 1);
  for (vtkIdType i = 0; others && i < pieces.GetSize(); ++i)
  {
    for (const vtkIdType point : pieces.GetPoints(i))
    {
      isKnown[point] |= others->IsOwn(pieces.GetCell(i)) ? 1 : 0;
    }
  }
  return isKnown;
}

/// The materials at each point that is known.
class MaterialsAtPoints
{
public:
  MaterialsAtPoints(
    const ColouredSimplices& pieces, const std::vector<int>& materialOf, OtherPartitions* others)
    : First(static_cast<std::size_t>(pieces.Cells.Simplices.NumberOfPoints), NoMaterial)
  {
    const std::vector<char> isKnown = FindKnownPoints(pieces, others);
    for (vtkIdType i = 0; i < pieces.GetSize(); ++i)
    {
      for (const vtkIdType point : pieces.GetPoints(i))
      {
        int& known = this->First[static_cast<std::size_t>(point)];
        if (!isKnown[static_cast<std::size_t>(point)] || materialOf[i] == NoMaterial)
        {
          continue;
        }
        if (known == NoMaterial)
        {
          known = materialOf[i];
        }
        else if (known != materialOf[i])
        {
          this->More.emplace_back(point, materialOf[i]);
        }
      }
    }
    SortDistinct(this->More);
  }

  void Add(vtkIdType point, std::vector<int>& materials) const
  {
    if (this->First[static_cast<std::size_t>(point)] != NoMaterial)
    {
      materials.push_back(this->First[static_cast<std::size_t>(point)]);
    }
    for (auto at = std::lower_bound(this->More.begin(), this->More.end(),
           std::make_pair(point, std::numeric_limits<int>::min()));
      at != this->More.end() && at->first == point; ++at)
    {
      materials.push_back(at->second);
    }
  }

private:
  std::vector<int> First;
  std::vector<std::pair<vtkIdType, int>> More; ///< of points with several; ascending
};

/// Pairs of materials that a simplex has at its points; both orders. At a joint, rows read all
/// neighbours: of two materials that only a third one joins, one may not take the values of the
/// other.
MaterialPairs FindMaterialPairs(
  const ColouredSimplices& pieces, const std::vector<int>& materialOf, OtherPartitions* others)
{
  const MaterialsAtPoints known(pieces, materialOf, others);
  MaterialPairs pairs;
  std::size_t most = std::size_t(1) << 20; // simplices find the same pairs again and again
  std::vector<int> here;
  for (vtkIdType i = 0; i < pieces.GetSize(); ++i)
  {
    here.clear();
    for (const vtkIdType point : pieces.GetPoints(i))
    {
      known.Add(point, here);
    }
    std::sort(here.begin(), here.end());
    here.erase(std::unique(here.begin(), here.end()), here.end());
    for (const int a : here)
    {
      for (const int b : here)
      {
        if (a != b)
        {
          pairs.emplace_back(a, b);
        }
      }
    }
    if (pairs.size() > most)
    {
      SortDistinct(pairs);
      most = std::max(most, 2 * pairs.size());
    }
  }
  SortDistinct(pairs);
  return pairs;
}

/// Gives each material the smallest colour that no earlier one has that it meets. Returns the
/// number of colours, at least 1.
int ChooseColours(const MaterialPairs& pairs, std::vector<int>& colours)
{
  int count = 1;
  auto at = pairs.begin();
  for (std::size_t material = 0; material < colours.size(); ++material)
  {
    std::vector<char> isTaken(static_cast<std::size_t>(count) + 1, 0);
    for (; at != pairs.end() && at->first == static_cast<int>(material); ++at)
    {
      if (at->second < at->first)
      {
        isTaken[static_cast<std::size_t>(colours[at->second])] = 1;
      }
    }
    colours[material] =
      static_cast<int>(std::find(isTaken.begin(), isTaken.end(), 0) - isTaken.begin());
    count = std::max(count, colours[material] + 1);
  }
  return count;
}

using Ids = std::vector<vtkIdType>;

/// The materials and pairs of all partitions.
class AllMaterials
{
public:
  /// The message of one partition: the number of its materials, their keys, and its pairs.
  static Ids Tell(const Ids& keys, const MaterialPairs& pairs)
  {
    Ids told{ static_cast<vtkIdType>(keys.size()) };
    told.insert(told.end(), keys.begin(), keys.end());
    for (const auto& [a, b] : InTurn(pairs))
    {
      told.insert(told.end(), { keys[a], keys[b] });
    }
    return told;
  }
  void Add(const Ids& told)
  {
    const auto pairs = told.begin() + 1 + static_cast<std::ptrdiff_t>(told[0]);
    this->Keys.insert(this->Keys.end(), told.begin() + 1, pairs);
    for (auto key = pairs; key != told.end(); key += 2)
    {
      this->Pairs.emplace_back(key[0], key[1]);
    }
  }
  void Colour()
  {
    SortDistinct(this->Keys);
    MaterialPairs pairs;
    for (const auto& [a, b] : InTurn(this->Pairs))
    {
      pairs.emplace_back(this->Find(a), this->Find(b));
    }
    std::sort(pairs.begin(), pairs.end());
    this->Colours.resize(this->Keys.size());
    this->NumberOfColours = ChooseColours(pairs, this->Colours);
  }
  /// The answer to a partition: the numbers of all colours and materials, and the colours and
  /// numbers of its materials.
  Ids Answer(const Ids& told) const
  {
    Ids answer{ this->NumberOfColours, static_cast<vtkIdType>(this->Keys.size()) };
    for (vtkIdType i = 1; i <= told[0]; ++i)
    {
      const int material = this->Find(told[i]);
      answer.insert(answer.end(), { this->Colours[material], material });
    }
    return answer;
  }

private:
  int Find(vtkIdType key) const
  {
    const auto found = std::lower_bound(this->Keys.begin(), this->Keys.end(), key);
    return static_cast<int>(found - this->Keys.begin());
  }

  Ids Keys;
  std::vector<std::pair<vtkIdType, vtkIdType>> Pairs; ///< of keys
  std::vector<int> Colours;
  int NumberOfColours = 1;
};

/// The answer of AllMaterials: the first partition chooses the colours of all materials.
Ids ChooseTogether(const Ids& keys, const MaterialPairs& pairs, OtherPartitions& others)
{
  const int first = others.FindFirst();
  Exchange::Lists<vtkIdType> lists{ { first, AllMaterials::Tell(keys, pairs) } };
  others.SendLists(lists);
  if (others.GetPartition() == first)
  {
    AllMaterials all;
    for (const auto& [from, told] : lists)
    {
      all.Add(told);
    }
    all.Colour();
    for (auto& [from, list] : lists)
    {
      list = all.Answer(list);
    }
  }
  others.SendLists(lists);
  return std::move(lists.at(first));
}

/// The same without others.
Ids ChooseAlone(const Ids& keys, const MaterialPairs& pairs)
{
  std::vector<int> colours(keys.size(), 0);
  const int count = ChooseColours(pairs, colours);
  Ids answer{ count, static_cast<vtkIdType>(keys.size()) };
  for (std::size_t material = 0; material < keys.size(); ++material)
  {
    answer.insert(answer.end(), { colours[material], static_cast<vtkIdType>(material) });
  }
  return answer;
}

/// Splits cells as the work of a filter does.
SimplicesOfCells Split(vtkPointSet* mesh)
{
  const Ids ids = ReadIdsOf(mesh->GetPointData(), mesh->GetNumberOfPoints());
  const bool isWhole = static_cast<vtkIdType>(ids.size()) == mesh->GetNumberOfPoints();
  return CellsToSimplices(mesh, isWhole ? ids.data() : nullptr);
}

}

ColouredSimplices::ColouredSimplices(
  vtkPointSet* mesh, vtkDataArray* materials, OtherPartitions* others)
  : Cells(Split(mesh))
{
  this->Offsets.push_back(0);
  for (const unsigned char dimension : InTurn(this->Cells.Simplices.Dimensions))
  {
    this->Offsets.push_back(this->Offsets.back() + dimension + 1);
  }
  Ids keys;
  const std::vector<int> numbers = NumberMaterials(materials, &keys);
  const std::vector<char> isMaximal = FindMaximal(*this);
  std::vector<char> hasMaximal(numbers.size(), 0); // of cells
  for (vtkIdType i = 0; i < this->GetSize(); ++i)
  {
    hasMaximal[this->GetCell(i)] = hasMaximal[this->GetCell(i)] || isMaximal[i];
  }
  std::vector<int> materialOf;
  for (vtkIdType i = 0; i < this->GetSize(); ++i)
  {
    materialOf.push_back(hasMaximal[this->GetCell(i)] ? numbers[this->GetCell(i)] : NoMaterial);
  }
  const MaterialPairs pairs = FindMaterialPairs(*this, materialOf, others);
  const Ids chosen = others ? ChooseTogether(keys, pairs, *others) : ChooseAlone(keys, pairs);
  this->NumberOfColours = static_cast<int>(chosen[0]);
  this->NumberOfMaterials = static_cast<int>(chosen[1]);
  for (const int material : materialOf)
  {
    const vtkIdType* both = chosen.data() + 2 + 2 * material;
    this->Colours.push_back(material == NoMaterial ? NoColour : static_cast<int>(both[0]));
    this->Materials.push_back(material == NoMaterial ? NoMaterial : static_cast<int>(both[1]));
  }
}

std::vector<ColourMask> FindColoursAtPoints(vtkPointSet* mesh)
{
  ColourMasks masks(mesh->GetNumberOfPoints());
  vtkDataArray* colours = mesh->GetCellData()->GetArray(ColourName);
  ForEachCellArray(mesh,
    [&](vtkCellArray* cells, vtkIdType first)
    {
      masks.Add(cells, [&](vtkIdType c)
        { return colours ? static_cast<int>(colours->GetComponent(first + c, 0)) : NoColour; });
    });
  return masks.Get();
}

}
