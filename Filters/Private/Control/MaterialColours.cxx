// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/MaterialColours.h"

#include "Private/ArrayNames.h"
#include "Private/Control/Features.h"
#include "Private/Control/PointCopies.h"

#include "vtkCellData.h"

#include <unordered_map>
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
      smaller.emplace(pieces.GetPlace(*pieces.GetPoints(i).begin()), i);
    }
  }
  for (vtkIdType i = 0; i < pieces.GetSize(); ++i)
  {
    for (const vtkIdType point : pieces.GetPoints(i))
    {
      const auto range = smaller.equal_range(pieces.GetPlace(point));
      for (auto at = range.first; at != range.second; ++at)
      {
        const Row<vtkIdType> points = pieces.GetPoints(at->second);
        const bool isFace = pieces.GetDimension(at->second) < pieces.GetDimension(i) &&
          std::all_of(
            points.begin(), points.end(),
            [&](vtkIdType p) { return pieces.Has(i, pieces.GetPlace(p)); });
        isMaximal[at->second] = isMaximal[at->second] && !isFace;
      }
    }
  }
  return isMaximal;
}

/// Pairs of materials that meet in a point; both orders.
std::vector<std::pair<int, int>> FindMeetings(
  const ColouredSimplices& pieces, const std::vector<int>& materialOf)
{
  std::vector<int> first(
    static_cast<std::size_t>(pieces.Cells.Simplices.NumberOfPoints), NoMaterial);
  std::vector<std::pair<vtkIdType, int>> at; // all materials of points with several
  for (vtkIdType i = 0; i < pieces.GetSize(); ++i)
  {
    for (const vtkIdType point : pieces.GetPoints(i))
    {
      const vtkIdType place = pieces.GetPlace(point);
      int& known = first[static_cast<std::size_t>(place)];
      if (materialOf[i] != NoMaterial && known == NoMaterial)
      {
        known = materialOf[i];
      }
      else if (materialOf[i] != NoMaterial && known != materialOf[i])
      {
        at.emplace_back(place, materialOf[i]);
        at.emplace_back(place, known);
      }
    }
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  std::vector<std::pair<int, int>> meetings;
  for (auto begin = at.begin(); begin != at.end();)
  {
    const auto end =
      std::find_if(begin, at.end(), [&](const auto& other) { return other.first != begin->first; });
    for (auto a = begin; a != end; ++a)
    {
      for (auto b = begin; b != end; ++b)
      {
        if (a != b)
        {
          meetings.emplace_back(a->second, b->second);
        }
      }
    }
    begin = end;
  }
  std::sort(meetings.begin(), meetings.end());
  meetings.erase(std::unique(meetings.begin(), meetings.end()), meetings.end());
  return meetings;
}

/// Gives each material the smallest colour that no earlier one has that it meets. Returns the
/// number of colours, at least 1.
int ChooseColours(const std::vector<std::pair<int, int>>& meetings, std::vector<int>& colours)
{
  int count = 1;
  auto at = meetings.begin();
  for (std::size_t material = 0; material < colours.size(); ++material)
  {
    std::vector<char> isTaken(static_cast<std::size_t>(count) + 1, 0);
    for (; at != meetings.end() && at->first == static_cast<int>(material); ++at)
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

}

ColouredSimplices::ColouredSimplices(
  vtkPointSet* mesh, vtkDataArray* materials, const std::vector<vtkIdType>& places)
  : Cells(CellsToSimplices(mesh, nullptr))
  , Places(places)
{
  this->Offsets.push_back(0);
  for (const unsigned char dimension : this->Cells.Simplices.Dimensions)
  {
    this->Offsets.push_back(this->Offsets.back() + dimension + 1);
  }
  const std::vector<int> numbers = NumberMaterials(materials);
  const std::vector<char> isMaximal = FindMaximal(*this);
  std::vector<char> hasMaximal(numbers.size(), 0); // of cells
  for (vtkIdType i = 0; i < this->GetSize(); ++i)
  {
    hasMaximal[this->GetCell(i)] = hasMaximal[this->GetCell(i)] || isMaximal[i];
  }
  std::vector<int> materialOf;
  int count = 0;
  for (vtkIdType i = 0; i < this->GetSize(); ++i)
  {
    materialOf.push_back(hasMaximal[this->GetCell(i)] ? numbers[this->GetCell(i)] : NoMaterial);
    count = std::max(count, materialOf.back() + 1);
  }
  std::vector<int> colours(static_cast<std::size_t>(count), 0);
  this->NumberOfColours = ChooseColours(FindMeetings(*this, materialOf), colours);
  for (const int material : materialOf)
  {
    this->Colours.push_back(material == NoMaterial ? NoColour : colours[material]);
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
