// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/SharedNumbers.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/Keepers.h"
#include "Private/Control/Partners.h"
#include "Private/Reading/CellReader.h"

#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Whether partitions may have different sizes of a thing that not all of them are sure of.
bool MayDiffer(size_t kinds)
{
  return kinds > 1;
}

/// What a partition keeps: records of a key and its sizes. The things that some partition is sure
/// of, ascending, each once.
class Kept
{
public:
  Kept(int width, int kinds)
    : Width(width)
    , Length(width + kinds)
  {
  }
  void Add(const vtkIdType* first, const vtkIdType* last)
  {
    this->Records.insert(this->Records.end(), first, last);
  }
  /// Replaces sizes by the sums of those before.
  void SumUp()
  {
    this->Sort();
    this->Sums.assign(static_cast<size_t>(this->Length - this->Width), 0);
    for (vtkIdType* record : InTurn(this->Sorted))
    {
      for (size_t kind = 0; kind < this->Sums.size(); ++kind)
      {
        const vtkIdType size = record[this->Width + kind];
        record[this->Width + kind] = this->Sums[kind];
        this->Sums[kind] += size;
      }
    }
  }
  /// The sums of all.
  const Ids& GetSums() const { return this->Sums; }
  /// Which thing has a key; the number of things: nobody is sure of it.
  size_t Find(const vtkIdType* key) const
  {
    const size_t place = this->FindBucket(key);
    if (place + 1 >= this->Starts.size())
    {
      return this->Sorted.size();
    }
    const auto last = this->Sorted.begin() + this->Starts[place + 1];
    const auto found = std::lower_bound(this->Sorted.begin() + this->Starts[place], last, key,
      [this](const vtkIdType* record, const vtkIdType* k) { return this->IsLess(record, k); });
    return found == last || this->IsLess(key, *found)
      ? this->Sorted.size()
      : static_cast<size_t>(found - this->Sorted.begin());
  }
  /// The sum of those before a thing, or of all.
  vtkIdType GetBefore(size_t thing, size_t kind) const
  {
    return thing < this->Sorted.size() ? this->Sorted[thing][this->Width + kind] : this->Sums[kind];
  }
  size_t GetNumberOfThings() const { return this->Sorted.size(); }

private:
  bool IsLess(const vtkIdType* a, const vtkIdType* b) const
  {
    return std::lexicographical_compare(a, a + this->Width, b, b + this->Width);
  }
  /// Buckets are ranges of first ids: about as many as there are records, however far apart ids
  /// are.
  size_t FindBucket(const vtkIdType* key) const
  {
    return static_cast<size_t>((std::max(*key, this->Least) - this->Least) >> this->BucketShift);
  }
  void MakeBuckets()
  {
    const auto length = static_cast<size_t>(this->Length);
    vtkIdType last = 0;
    this->Least = this->Records.empty() ? 0 : this->Records[0];
    for (size_t i = 0; i < this->Records.size(); i += length)
    {
      this->Least = std::min(this->Least, this->Records[i]);
      last = std::max(last, this->Records[i]);
    }
    const auto size = static_cast<vtkIdType>(this->Records.size() / length);
    this->BucketShift = 0;
    while ((last - this->Least) >> this->BucketShift > size)
    {
      ++this->BucketShift;
    }
    this->Starts.assign(((last - this->Least) >> this->BucketShift) + 2, 0);
  }
  /// Sorts by counting the keys of each bucket, and then the few in each.
  void Sort()
  {
    const auto length = static_cast<size_t>(this->Length);
    this->MakeBuckets();
    std::vector<size_t> ends(this->Starts.size(), 0);
    for (size_t i = 0; i < this->Records.size(); i += length)
    {
      ++ends[this->FindBucket(this->Records.data() + i) + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<vtkIdType*> records(this->Records.size() / length);
    for (size_t i = 0; i < this->Records.size(); i += length)
    {
      vtkIdType* record = this->Records.data() + i;
      records[ends[this->FindBucket(record)]++] = record;
    }
    const auto isLess = [this](const vtkIdType* a, const vtkIdType* b)
    { return this->IsLess(a, b); };
    auto first = records.begin();
    for (size_t bucket = 0; bucket < ends.size(); ++bucket)
    {
      const auto next = records.begin() + ends[bucket];
      this->Starts[bucket] = this->Sorted.size();
      std::sort(first, next, isLess);
      std::unique_copy(first, next, std::back_inserter(this->Sorted),
        [&](const vtkIdType* a, const vtkIdType* b) { return !isLess(a, b); });
      first = next;
    }
  }

  int Width;
  int Length;
  Ids Records;
  vtkIdType Least = 0;        ///< first id of a key
  int BucketShift = 0;        ///< a bucket is so wide: 2 to this power
  std::vector<size_t> Starts; ///< in Sorted, of each bucket
  std::vector<vtkIdType*> Sorted;
  Ids Sums;
};

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

/// The questions of this partition: to each keeper the number of things that it is sure of, these
/// with their sizes, then the keys of the others, with their sizes if these may differ.
class Questions
{
public:
  Questions(const SharedKeys& things, const Keepers& keepers)
    : Kinds(things.Kinds)
  {
    const auto width = static_cast<size_t>(things.Width);
    const auto kinds = static_cast<size_t>(things.Kinds);
    for (const bool own : { true, false })
    {
      for (size_t i = 0; i < things.Own.size(); ++i)
      {
        if (static_cast<bool>(things.Own[i]) != own)
        {
          continue;
        }
        const vtkIdType* key = things.Keys.data() + width * i;
        auto& [ids, places] = this->To[keepers.Find(key[0])];
        ids.resize(std::max<size_t>(ids.size(), 1), 0);
        ids.insert(ids.end(), key, key + width);
        places.push_back(i);
        ids[0] += own ? 1 : 0;
        if (own || MayDiffer(kinds))
        {
          for (size_t kind = 0; kind < kinds; ++kind)
          {
            ids.push_back(things.Sizes.empty() ? 1 : things.Sizes[kinds * i + kind]);
          }
        }
      }
    }
  }
  Partners::Messages Pack() const
  {
    Partners::Messages messages;
    for (const auto& [keeper, question] : this->To)
    {
      messages[keeper] = PackIds(question.first);
    }
    return messages;
  }
  /// Sorts in the answers of all keepers; `before`: what their predecessors have.
  void Take(const Partners::Messages& answers, SharedNumbers& numbers) const
  {
    const auto kinds = static_cast<size_t>(this->Kinds);
    for (const auto& [keeper, message] : answers)
    {
      const Ids answer = UnpackIds(message);
      const std::vector<size_t>& places = this->To.at(keeper).second;
      for (size_t i = 0; i < places.size(); ++i)
      {
        std::copy_n(answer.data() + kinds * i, kinds, numbers.First.data() + kinds * places[i]);
      }
    }
  }

private:
  int Kinds;
  std::map<int, std::pair<Ids, std::vector<size_t>>> To;
};

/// The answers of this partition: numbers count from its own first thing.
class Answers
{
public:
  Answers(const SharedKeys& things, const Partners::Messages& questions)
    : Width(static_cast<size_t>(things.Width))
    , Kinds(static_cast<size_t>(things.Kinds))
    , Things(things.Width, things.Kinds)
  {
    for (const auto& [from, message] : questions)
    {
      Ids& ids = this->Asked[from];
      ids = UnpackIds(message);
      const size_t sure = static_cast<size_t>(ids[0]) * (this->Width + this->Kinds);
      this->Things.Add(ids.data() + 1, ids.data() + 1 + sure);
    }
    this->Things.SumUp();
  }
  const Ids& GetSums() const { return this->Things.GetSums(); }
  /// `before`: how many ids of each kind the keepers before this one have.
  Partners::Messages Pack(const Ids& before) const
  {
    Partners::Messages messages;
    for (const auto& [from, ids] : this->Asked)
    {
      Ids answer;
      answer.reserve(ids.size());
      size_t at = 1;
      for (vtkIdType i = 0; at < ids.size(); ++i)
      {
        const bool isSure = i < ids[0];
        const size_t found = this->Things.Find(ids.data() + at);
        at += this->Width;
        for (size_t kind = 0; kind < this->Kinds; ++kind)
        {
          const bool isKnown = found < this->Things.GetNumberOfThings() &&
            (isSure || !MayDiffer(this->Kinds) || this->GetSize(found, kind) == ids[at + kind]);
          answer.push_back(isKnown ? before[kind] + this->Things.GetBefore(found, kind) : -1);
        }
        at += isSure || MayDiffer(this->Kinds) ? this->Kinds : 0;
      }
      messages[from] = PackIds(answer);
    }
    return messages;
  }

private:
  vtkIdType GetSize(size_t thing, size_t kind) const
  {
    return this->Things.GetBefore(thing + 1, kind) - this->Things.GetBefore(thing, kind);
  }

  size_t Width;
  size_t Kinds;
  Kept Things;
  std::map<int, Ids> Asked;
};

}

SharedNumbers NumberTogether(const SharedKeys& things, Partners& partners)
{
  const Keepers keepers(things, partners);
  const Questions questions(things, keepers);
  Partners::Messages messages = questions.Pack();
  partners.Send(messages);
  const Answers answers(things, messages);
  SharedNumbers numbers;
  Ids before;
  for (const vtkIdType sum : answers.GetSums())
  {
    Ids all = partners.Gather(sum);
    std::replace(all.begin(), all.end(), vtkIdType(-1), vtkIdType(0));
    const auto own = all.begin() + partners.GetPartition();
    before.push_back(std::accumulate(all.begin(), own, vtkIdType(0)));
    numbers.Totals.push_back(std::accumulate(own, all.end(), before.back()));
  }
  messages = answers.Pack(before);
  partners.Send(messages);
  numbers.First.assign(things.Own.size() * static_cast<size_t>(things.Kinds), -1);
  questions.Take(messages, numbers);
  return numbers;
}

SharedNumbers NumberTogether(
  SharedKeys things, int kind, const std::vector<const IdSegments*>& lists, Partners& partners)
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
  return NumberTogether(things, partners);
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

Ids PlaceCells(vtkPointSet* input, Partners& partners)
{
  Ids places = partners.GetCellIds();
  if (auto* surface = vtkPolyData::SafeDownCast(input))
  {
    const vtkIdType last = places.empty() ? 0 : *std::max_element(places.begin(), places.end());
    const Ids all = partners.Gather(last);
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

SharedKeys MakeKeysOfPieces(const Ids& cells, const Ids& places, Partners& partners)
{
  SharedKeys pieces;
  pieces.Width = 2;
  for (const size_t i : InTurn(cells.size()))
  {
    const bool isSame = i > 0 && cells[i] == cells[i - 1];
    pieces.Keys.push_back(places[cells[i]]);
    pieces.Keys.push_back(isSame ? pieces.Keys[pieces.Keys.size() - 2] + 1 : 0);
    pieces.Own.push_back(partners.IsOwn(cells[i]));
  }
  return pieces;
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

std::vector<char> FindOwnPoints(vtkPointSet* mesh, const Ids& inputCells, const Partners& partners)
{
  return FindOwnPoints(mesh,
    [&](vtkIdType cell) { return partners.IsOwn(inputCells.empty() ? cell : inputCells[cell]); });
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
        // Those that one cell brought are consecutive.
        vtkIdType* key = centres.Keys.data() + 2 * centre;
        key[0] = pieces.Keys[2 * s];
        key[1] = centre > 0 && seen[centre - 1] && key[-2] == key[0] ? key[-1] + 1 : 0;
      }
    }
  }
  return centres;
}

SharedNumbers NumberVertices(
  vtkIdType points, const SimplexView& simplices, const SharedKeys& pieces, Partners& partners)
{
  SharedKeys given;
  const Ids& ids = partners.GetPointIds();
  points = std::min(points, simplices.NumberOfPoints);
  given.Keys.assign(ids.begin(), ids.begin() + points);
  given.Own.assign(given.Keys.size(), 1);
  SharedNumbers numbers = NumberTogether(given, partners);
  const SharedNumbers ofCentres =
    NumberTogether(MakeCentreKeys(points, simplices, pieces), partners);
  for (const vtkIdType number : InTurn(ofCentres.First))
  {
    numbers.First.push_back(number < 0 ? -1 : numbers.Totals[0] + number);
  }
  numbers.Totals[0] += ofCentres.Totals[0];
  return numbers;
}

}
