// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Partitions/SharedNumbers.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/CellsToSimplices.h"
#include "Private/Run/StampFields.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// How many things there are of the kind of a segment.
vtkIdType CountThings(const IdSegment& segment, const std::vector<SharedNumbers>& things)
{
  const SharedNumbers& numbers = things[segment.Kind];
  return static_cast<vtkIdType>(numbers.First.size() / numbers.Totals.size());
}

vtkIdType CountIds(const IdSegments& list, const std::vector<SharedNumbers>& things)
{
  vtkIdType count = 0;
  for (const IdSegment& segment : list)
  {
    count += segment.CountBefore(CountThings(segment, things));
  }
  return count;
}

/// Writes the ids of a list in the whole mesh, and returns how many that has. `varied`: of each
/// kind, how many varied segments were there before; counted further.
vtkIdType WriteIds(const IdSegments& list, const std::vector<SharedNumbers>& things,
  std::vector<size_t>& varied, vtkIdType* ids)
{
  vtkIdType total = 0;
  for (const IdSegment& segment : list)
  {
    const SharedNumbers& numbers = things[segment.Kind];
    const size_t kinds = numbers.Totals.size();
    const size_t kind = segment.IsVaried() ? ++varied[segment.Kind] : 0;
    const vtkIdType ofEach = segment.IsVaried() ? 1 : segment.OfEach;
    const vtkIdType size = CountThings(segment, things);
    ForEach(size,
      [&](vtkIdType i)
      {
        const vtkIdType first = numbers.First[kinds * i + kind];
        const vtkIdType before = segment.CountBefore(i);
        const vtkIdType last = segment.CountBefore(i + 1);
        for (vtkIdType k = before; k < last; ++k)
        {
          ids[k] = first < 0 ? -1 : total + ofEach * first + k - before;
        }
      });
    total += ofEach * numbers.Totals[kind];
    ids += segment.CountBefore(size);
  }
  return total;
}

/// Answers with the numbers of ids before each thing that some partition is sure of, and adds the
/// numbers that it gets.
void AnswerNumbers(SharedDirectory& directory, bool haveSizes, Ids& before)
{
  directory.ForThings(
    [&](auto first, auto last)
    {
      const auto sure = std::find_if(first, last, [](const auto& entry) { return entry.IsOwn; });
      for (; sure != last && first != last; ++first)
      {
        for (size_t kind = 0; kind < before.size(); ++kind)
        {
          const bool isKnown = first->IsOwn || !haveSizes || first->Told[kind] == sure->Told[kind];
          first->Answer[kind] = isKnown ? before[kind] : -1;
        }
      }
      for (size_t kind = 0; sure != last && kind < before.size(); ++kind)
      {
        before[kind] += sure->Told[kind];
      }
    });
}

}

SharedNumbers NumberTogether(const SharedKeys& things, OtherPartitions& others)
{
  const auto kinds = static_cast<size_t>(things.Kinds);
  const Ids ones(things.Sizes.empty() ? things.Own.size() : 0, 1);
  SharedDirectory directory(
    things, things.Kinds, ones.empty() ? things.Sizes : ones, things.Kinds, others);
  SharedNumbers numbers;
  Ids sums(kinds, 0);
  AnswerNumbers(directory, !things.Sizes.empty(), sums);
  Ids before;
  for (const vtkIdType sum : sums)
  {
    Ids all = others.Gather(sum);
    std::replace(all.begin(), all.end(), vtkIdType(-1), vtkIdType(0));
    const auto own = all.begin() + others.GetPartition();
    before.push_back(std::accumulate(all.begin(), own, vtkIdType(0)));
    numbers.Totals.push_back(std::accumulate(own, all.end(), before.back()));
  }
  AnswerNumbers(directory, !things.Sizes.empty(), before);
  numbers.First = directory.TakeAnswers();
  return numbers;
}

SharedNumbers NumberTogether(
  SharedKeys things, int kind, const std::vector<const IdSegments*>& lists, OtherPartitions& others)
{
  std::vector<const IdSegment*> varied;
  for (const IdSegments* list : lists)
  {
    for (const IdSegment& segment : *list)
    {
      if (segment.Kind == kind && segment.IsVaried())
      {
        varied.push_back(&segment);
      }
    }
  }
  things.Kinds = 1 + static_cast<int>(varied.size());
  things.Sizes.reserve(things.Own.size() * (1 + varied.size()));
  for (const size_t i : InTurn(things.Own.size()))
  {
    const auto thing = static_cast<vtkIdType>(i);
    things.Sizes.push_back(1);
    for (const IdSegment* segment : varied)
    {
      things.Sizes.push_back(segment->CountBefore(thing + 1) - segment->CountBefore(thing));
    }
  }
  return NumberTogether(things, others);
}

void WholeIds::Add(
  const SharedKeys& things, OtherPartitions& others, const std::vector<vtkIdType>& places)
{
  const SharedNumbers numbers = NumberTogether(things, others);
  const std::size_t first = this->Ids.size();
  this->Ids.resize(first + (places.empty() ? numbers.First.size() : 0));
  for (const std::size_t i : InTurn(numbers.First.size()))
  {
    this->Ids[places.empty() ? first + i : static_cast<std::size_t>(places[i])] =
      numbers.First[i] < 0 ? -1 : this->Total + numbers.First[i];
  }
  this->Total += numbers.Totals[0];
}

std::vector<WholeIds> FindWholeIds(
  const std::vector<const IdSegments*>& lists, const std::vector<SharedNumbers>& things)
{
  std::vector<size_t> varied(things.size(), 0);
  std::vector<WholeIds> found;
  for (const IdSegments* list : lists)
  {
    found.emplace_back();
    WholeIds& whole = found.back();
    whole.Ids.resize(static_cast<size_t>(CountIds(*list, things)));
    whole.Total = WriteIds(*list, things, varied, whole.Ids.data());
  }
  return found;
}

vtkIdType FindWholeIds(
  const IdSegments& list, const std::vector<SharedNumbers>& things, vtkIdTypeArray* ids)
{
  std::vector<size_t> varied(things.size(), 0);
  Allocate(ids, 1, CountIds(list, things));
  return WriteIds(list, things, varied, ids->GetPointer(0));
}

Ids PlaceCells(vtkPointSet* input, OtherPartitions& others)
{
  Ids places = others.GetCellIds();
  if (auto* surface = vtkPolyData::SafeDownCast(input))
  {
    const vtkIdType last = places.empty() ? 0 : *std::max_element(places.begin(), places.end());
    const Ids all = others.Gather(last);
    const vtkIdType size = *std::max_element(all.begin(), all.end()) + 1;
    std::array<vtkIdType, 3> ends{ surface->GetNumberOfVerts(), surface->GetNumberOfLines(),
      surface->GetNumberOfPolys() };
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    for (const size_t c : InTurn(places.size()))
    {
      for (const vtkIdType end : ends)
      {
        places[c] += static_cast<vtkIdType>(c) >= end ? size : 0;
      }
    }
  }
  return places;
}

SharedKeys MakeKeysOfPieces(const Ids& cells, const Ids& places, OtherPartitions& others)
{
  SharedKeys pieces;
  pieces.Width = 2;
  for (const size_t i : InTurn(cells.size()))
  {
    const bool isSame = i > 0 && cells[i] == cells[i - 1];
    pieces.Keys.push_back(places[cells[i]]);
    pieces.Keys.push_back(isSame ? pieces.Keys[pieces.Keys.size() - 2] + 1 : 0);
    pieces.Own.push_back(others.IsOwn(cells[i]));
  }
  return pieces;
}

SharedKeys MakeKeysOfPieces(
  const SimplicesOfCells& simplices, const Ids& places, OtherPartitions& others)
{
  Ids cells = simplices.ParentCells;
  if (cells.empty())
  {
    cells.resize(static_cast<std::size_t>(simplices.Simplices.GetNumberOfSimplices()));
    std::iota(cells.begin(), cells.end(), vtkIdType(0));
  }
  return MakeKeysOfPieces(cells, places, others);
}

std::vector<char> FindOwnPoints(vtkPointSet* mesh, const std::function<bool(vtkIdType)>& isOwn)
{
  const CellReader cells(mesh);
  std::vector<char> own(static_cast<size_t>(mesh->GetNumberOfPoints()), 0);
  Ids scratch;
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    const bool isOfOwn = isOwn(c);
    for (vtkIdType i = 0; i < cell.Size && isOfOwn; ++i)
    {
      if (cell.Ids[i] >= 0 && cell.Ids[i] < mesh->GetNumberOfPoints())
      {
        own[cell.Ids[i]] = 1;
      }
    }
  }
  return own;
}

std::vector<char> FindOwnPoints(
  vtkPointSet* mesh, const Ids& inputCells, const OtherPartitions& others)
{
  return FindOwnPoints(mesh,
    [&](vtkIdType cell) { return others.IsOwn(inputCells.empty() ? cell : inputCells[cell]); });
}

SharedKeys MakeCentreKeys(vtkIdType points, const SimplexView& simplices, const SharedKeys& pieces)
{
  SharedKeys centres;
  centres.Width = 2;
  centres.Own.assign(static_cast<size_t>(simplices.NumberOfPoints - points), 0);
  centres.Keys.assign(2 * centres.Own.size(), 0);
  std::vector<char> seen(centres.Own.size(), 0);
  size_t entry = 0;
  for (const vtkIdType s : InTurn(simplices.NumberOfSimplices))
  {
    for (int k = 0; k <= simplices.Dimensions[s]; ++k, ++entry)
    {
      const vtkIdType centre = simplices.Connectivity[entry] - points;
      if (centre >= 0 && !seen[centre])
      {
        seen[centre] = 1;
        centres.Own[centre] = pieces.Own[s];
        // The things that one cell brought are consecutive.
        vtkIdType* key = centres.Keys.data() + 2 * centre;
        key[0] = pieces.Keys[2 * s];
        key[1] = centre > 0 && seen[centre - 1] && key[-2] == key[0] ? key[-1] + 1 : 0;
      }
    }
  }
  return centres;
}

WholeIds NumberPoints(vtkIdType points, OtherPartitions& others)
{
  SharedKeys given;
  const Ids& ids = others.GetPointIds();
  given.Keys.assign(ids.begin(), ids.begin() + points);
  given.Own.assign(given.Keys.size(), 1);
  WholeIds numbers;
  numbers.Add(given, others);
  return numbers;
}

WholeIds NumberVertices(
  vtkIdType points, const SimplexView& simplices, const SharedKeys& pieces, OtherPartitions& others)
{
  points = std::min(points, simplices.NumberOfPoints);
  WholeIds numbers = NumberPoints(points, others);
  numbers.Add(MakeCentreKeys(points, simplices, pieces), others);
  return numbers;
}

WholeIds NumberCells(const Ids& places, const Ids& sources, OtherPartitions& others)
{
  SharedKeys inputs;
  IdSegment cells{ 0, 0, { 0 } };
  for (std::size_t c = 0; c < sources.size(); ++c)
  {
    if (c == 0 || sources[c] != sources[c - 1])
    {
      inputs.Keys.push_back(places[sources[c]]);
      inputs.Own.push_back(others.IsOwn(sources[c]));
      cells.Before.push_back(cells.Before.back());
    }
    ++cells.Before.back();
  }
  const IdSegments list{ cells };
  return std::move(FindWholeIds({ &list }, { NumberTogether(inputs, 0, { &list }, others) })[0]);
}

void WholeNumbers::Write(vtkPointSet* output) const
{
  output->GetPointData()->AddArray(MakeField<vtkIdTypeArray>(PointNumbersName, this->Points.Ids));
  output->GetCellData()->AddArray(MakeField<vtkIdTypeArray>(CellNumbersName, this->Cells.Ids));
}

}
