// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/PointIds.h"

#include "Core/Memory/Sorting.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Distribution/BlockCases.h"
#include "Private/Distribution/PlacesOfIds.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Values/PointCopies.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <tuple>

namespace subdivision
{
namespace
{

using Parts = std::vector<std::vector<MeshPart>>;

/// Marks the cells that are used, and the points: all but those that only duplicate cells use.
void MarkUsed(MeshPart& part)
{
  const vtkIdType size = part.Mesh->GetNumberOfCells();
  part.Cells.assign(size, 0);
  part.Points.assign(part.Mesh->GetNumberOfPoints(), 0);
  const unsigned char* types = GetGhosts(part.Mesh, size);
  if (!types)
  {
    return;
  }
  const CellReader reader(part.Mesh);
  std::vector<vtkIdType> scratch;
  auto mark = [&](bool duplicate, vtkIdType value)
  {
    for (const vtkIdType c : InTurn(size))
    {
      if (((types[c] & vtkDataSetAttributes::DUPLICATECELL) != 0) != duplicate)
      {
        continue;
      }
      part.Cells[c] = value;
      const CellIds cell = reader.GetCell(c, scratch);
      for (vtkIdType i = 0; i < cell.Size; ++i)
      {
        if (cell.Ids[i] >= 0 && cell.Ids[i] < static_cast<vtkIdType>(part.Points.size()))
        {
          part.Points[cell.Ids[i]] = value;
        }
      }
    }
  };
  mark(true, -1);
  mark(false, 0);
}

bool AllHave(const Parts& parts, Exchange& exchange, int association)
{
  bool have = true;
  for (const auto& partition : parts)
  {
    for (const MeshPart& part : partition)
    {
      const vtkIdType size = part.Mesh->GetNumberOfElements(association);
      const std::vector<vtkIdType> ids = ReadIdsOf(part.Mesh->GetAttributes(association), size);
      have = have && static_cast<vtkIdType>(ids.size()) == size &&
        std::all_of(
          ids.begin(), ids.end(), [](vtkIdType id) { return id >= 0 && id < VTK_ID_MAX; });
    }
  }
  return exchange.Agree(have);
}

void TakeGlobalIds(Parts& parts, int association, std::vector<vtkIdType> MeshPart::* ids)
{
  for (auto& partition : parts)
  {
    for (MeshPart& part : partition)
    {
      const std::vector<vtkIdType> given = ReadIdsOf(
        part.Mesh->GetAttributes(association), part.Mesh->GetNumberOfElements(association));
      for (size_t i = 0; i < given.size(); ++i)
      {
        vtkIdType& id = (part.*ids)[i];
        id = id < 0 ? -1 : given[i];
      }
    }
  }
}

/// The numbers at which the partitions of this rank start, if partition i of it takes counts[i].
std::vector<vtkIdType> GetStarts(const std::vector<vtkIdType>& counts, Exchange& exchange)
{
  const std::vector<vtkIdType> all = exchange.Gather(counts);
  std::vector<vtkIdType> starts;
  for (size_t i = 0; i < counts.size(); ++i)
  {
    starts.push_back(std::accumulate(
      all.begin(), all.begin() + exchange.GetPartition(static_cast<int>(i)), vtkIdType(0)));
  }
  return starts;
}

void NumberCells(Parts& parts, Exchange& exchange)
{
  std::vector<vtkIdType> counts;
  for (const auto& partition : parts)
  {
    vtkIdType count = 0;
    for (const MeshPart& part : partition)
    {
      count +=
        std::count_if(part.Cells.begin(), part.Cells.end(), [](vtkIdType id) { return id >= 0; });
    }
    counts.push_back(count);
  }
  std::vector<vtkIdType> next = GetStarts(counts, exchange);
  for (size_t p = 0; p < parts.size(); ++p)
  {
    for (MeshPart& part : parts[p])
    {
      for (vtkIdType& id : part.Cells)
      {
        id = id < 0 ? -1 : next[p]++;
      }
    }
  }
}

/// Whether no two cells have the same global id.
bool HaveDistinctCells(const Parts& parts, Exchange& exchange)
{
  const vtkIdType partitions = exchange.GetNumberOfPartitions();
  std::vector<Exchange::Lists<vtkIdType>> lists(parts.size());
  for (size_t p = 0; p < parts.size(); ++p)
  {
    for (const MeshPart& part : parts[p])
    {
      const std::vector<vtkIdType> ids =
        ReadIdsOf(part.Mesh->GetCellData(), part.Mesh->GetNumberOfCells());
      for (size_t i = 0; i < ids.size(); ++i)
      {
        if (part.Cells[i] >= 0)
        {
          lists[p][static_cast<int>(ids[i] % partitions)].push_back(ids[i]);
        }
      }
    }
  }
  bool distinct = true;
  for (const Exchange::Lists<vtkIdType>& arrived : exchange.SendLists(lists))
  {
    std::vector<vtkIdType> all;
    for (const auto& [from, list] : arrived)
    {
      all.insert(all.end(), list.begin(), list.end());
    }
    std::sort(all.begin(), all.end());
    distinct = distinct && std::adjacent_find(all.begin(), all.end()) == all.end();
  }
  return exchange.Agree(distinct);
}

// ------------------------------------------------------------------------------------------------
// Points by coordinates

/// What points have in common that are one point: coordinates or, with global ids, the variant of
/// the id as the first of them.
struct Site
{
  std::array<double, 3> At;
  vtkIdType Id;
  vtkIdType Case;

  auto Get() const { return std::tie(this->At, this->Id, this->Case); }
  bool operator<(const Site& other) const { return this->Get() < other.Get(); }
  bool operator!=(const Site& other) const { return this->Get() != other.Get(); }
};

/// A place, and a number of it in its partition.
struct Place
{
  Site At;
  vtkIdType Number;
  int Partition;
  int IsSeveral; ///< a part has several points there

  bool operator<(const Place& other) const
  {
    return this->At != other.At ? this->At < other.At : this->Partition < other.Partition;
  }
};

std::size_t Hash(const Site& site)
{
  std::uint64_t hash =
    static_cast<std::uint64_t>(site.Id + 1) * 31 + static_cast<std::uint64_t>(site.Case);
  for (const double x : site.At)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

/// A point of a partition.
struct PointOfPart
{
  Site At;
  int Part;
  vtkIdType Index;

  bool operator<(const PointOfPart& other) const
  {
    return this->At != other.At
      ? this->At < other.At
      : (this->Part != other.Part ? this->Part < other.Part : this->Index < other.Index);
  }
};

/// The points of a partition sorted by place; those without a finite place, which nobody can share,
/// come last and unsorted.
std::vector<PointOfPart> SortPoints(const std::vector<MeshPart>& parts, bool byIds, size_t& finite)
{
  std::vector<PointOfPart> points;
  std::vector<PointOfPart> others;
  for (size_t p = 0; p < parts.size(); ++p)
  {
    for (size_t i = 0; i < parts[p].Points.size(); ++i)
    {
      if (parts[p].Points[i] < 0)
      {
        continue;
      }
      PointOfPart point = { { {}, -1, parts[p].Case }, static_cast<int>(p),
        static_cast<vtkIdType>(i) };
      bool isFinite = true;
      if (!byIds)
      {
        parts[p].Mesh->GetPoint(point.Index, point.At.At.data());
        for (double& x : point.At.At)
        {
          isFinite = isFinite && std::isfinite(x);
          x += 0.; // -0 becomes 0
        }
      }
      else
      {
        point.At.Id = parts[p].Points[i];
        point.At.At[0] = parts[p].Variants.empty() ? 0. : static_cast<double>(parts[p].Variants[i]);
      }
      (isFinite ? points : others).push_back(point);
    }
  }
  StableSort(points, std::less<>());
  finite = points.size();
  points.insert(points.end(), others.begin(), others.end());
  return points;
}

/// The points of one partition by place.
struct PlacesOfPartition
{
  std::vector<PointOfPart> Points;
  std::vector<size_t> Begins; ///< of the points of each place, one more than places
  std::vector<char> IsSeveral;
  std::vector<vtkIdType> Ids; ///< of each place; -1: its points have ids of their own

  PlacesOfPartition(const std::vector<MeshPart>& parts, bool byIds, bool joinsCopies)
  {
    std::vector<std::vector<vtkIdType>> firsts(parts.size()); // of copies; empty: there are none
    for (std::size_t p = 0; joinsCopies && p < parts.size(); ++p)
    {
      firsts[p] = FindFirstCopies(parts[p].Mesh);
    }
    const auto areCopies = [&](const PointOfPart& a, const PointOfPart& b)
    { return !firsts[a.Part].empty() && firsts[a.Part][a.Index] == firsts[a.Part][b.Index]; };
    size_t finite = 0;
    this->Points = SortPoints(parts, byIds, finite);
    for (const size_t i : InTurn(this->Points.size()))
    {
      if (i >= finite || i == 0 || this->Points[i].At != this->Points[i - 1].At)
      {
        this->Begins.push_back(i);
        this->IsSeveral.push_back(i >= finite);
      }
      else if (this->Points[i].Part == this->Points[i - 1].Part &&
        !areCopies(this->Points[i], this->Points[i - 1]))
      {
        this->IsSeveral.back() = 1;
      }
    }
    this->Begins.push_back(this->Points.size());
    this->NumberOfFinite = static_cast<size_t>(
      std::lower_bound(this->Begins.begin(), this->Begins.end(), finite) - this->Begins.begin());
  }
  size_t GetNumberOfPlaces() const { return this->Begins.size() - 1; }

  size_t NumberOfFinite; ///< places with finite coordinates
};

/// What the directory says of a place: the first partition that has it (which gives the number),
/// and whether points stay apart there.
struct Answer
{
  vtkIdType Number;
  int Owner;
  int IsSeveral;
};

/// Asks for each place of each partition who else has it.
std::vector<std::vector<Answer>> AskDirectory(
  const std::vector<PlacesOfPartition>& own, Exchange& exchange)
{
  const auto partitions = static_cast<std::size_t>(exchange.GetNumberOfPartitions());
  std::vector<Exchange::Lists<Place>> questions(own.size());
  std::vector<std::vector<Answer>> answers;
  for (const size_t p : InTurn(own.size()))
  {
    answers.emplace_back();
    const int self = exchange.GetPartition(static_cast<int>(p));
    for (size_t i = 0; i < own[p].GetNumberOfPlaces(); ++i)
    {
      answers[p].push_back({ static_cast<vtkIdType>(i), self, own[p].IsSeveral[i] });
      if (partitions > 1 && i < own[p].NumberOfFinite)
      {
        const auto& at = own[p].Points[own[p].Begins[i]].At;
        questions[p][static_cast<int>(Hash(at) % partitions)].push_back(
          { at, static_cast<vtkIdType>(i), self, own[p].IsSeveral[i] });
      }
    }
  }
  if (partitions == 1)
  {
    return answers;
  }
  // The answer to each question, in the order of the questions.
  std::vector<Exchange::Lists<Place>> asked = exchange.SendLists(questions);
  std::vector<Exchange::Lists<Answer>> replies(own.size());
  for (size_t d = 0; d < asked.size(); ++d)
  {
    std::vector<Place> all;
    for (const auto& [from, list] : asked[d])
    {
      all.insert(all.end(), list.begin(), list.end());
    }
    std::sort(all.begin(), all.end());
    for (const auto& [from, list] : asked[d])
    {
      for (const Place& place : list)
      {
        auto first = std::lower_bound(all.begin(), all.end(), place,
          [](const Place& a, const Place& b) { return a.At < b.At; });
        Answer answer = { first->Number, first->Partition, 0 };
        for (; first != all.end() && !(first->At != place.At); ++first)
        {
          answer.IsSeveral |= first->IsSeveral;
        }
        replies[d][from].push_back(answer);
      }
    }
  }
  const std::vector<Exchange::Lists<Answer>> arrived = exchange.SendLists(replies);
  for (const size_t p : InTurn(own.size()))
  {
    for (const auto& [from, list] : arrived[p])
    {
      const std::vector<Place>& mine = questions[p][from];
      for (size_t i = 0; i < list.size(); ++i)
      {
        answers[p][mine[i].Number] = list[i];
      }
    }
  }
  return answers;
}

/// Gives numbers to the places and points that partitions own: in the order in which the points
/// stand in the parts, so that one partition keeps its order.
void NumberOwn(const std::vector<std::vector<Answer>>& answers, Parts& parts,
  std::vector<PlacesOfPartition>& places, Exchange& exchange)
{
  std::vector<vtkIdType> counts;
  for (size_t p = 0; p < parts.size(); ++p)
  {
    const int self = exchange.GetPartition(static_cast<int>(p));
    PlacesOfPartition& own = places[p];
    own.Ids.assign(own.GetNumberOfPlaces(), -1);
    // The place of each point, by part and index.
    std::vector<std::vector<vtkIdType>> placeOf;
    for (const MeshPart& part : parts[p])
    {
      placeOf.emplace_back(part.Points.size(), -1);
    }
    for (size_t i = 0; i < own.GetNumberOfPlaces(); ++i)
    {
      for (size_t k = own.Begins[i]; k < own.Begins[i + 1]; ++k)
      {
        placeOf[own.Points[k].Part][own.Points[k].Index] = static_cast<vtkIdType>(i);
      }
    }
    vtkIdType count = 0;
    for (size_t q = 0; q < parts[p].size(); ++q)
    {
      for (size_t i = 0; i < placeOf[q].size(); ++i)
      {
        const vtkIdType place = placeOf[q][i];
        if (place < 0)
        {
          continue;
        }
        const Answer& answer = answers[p][place];
        if (answer.IsSeveral)
        {
          parts[p][q].Points[i] = count++;
        }
        else if (answer.Owner == self && own.Ids[place] < 0)
        {
          own.Ids[place] = count++;
        }
      }
    }
    counts.push_back(count);
  }
  const std::vector<vtkIdType> starts = GetStarts(counts, exchange);
  for (size_t p = 0; p < parts.size(); ++p)
  {
    for (vtkIdType& id : places[p].Ids)
    {
      id = id < 0 ? -1 : id + starts[p];
    }
    for (MeshPart& part : parts[p])
    {
      for (vtkIdType& id : part.Points)
      {
        id = id < 0 ? -1 : id + starts[p]; // overwritten below where the place has the number
      }
    }
  }
}

/// Asks the owners for the numbers of places that other partitions own.
void FetchNumbers(const std::vector<std::vector<Answer>>& answers,
  std::vector<PlacesOfPartition>& places, Exchange& exchange)
{
  std::vector<Exchange::Lists<vtkIdType>> questions(places.size());
  std::vector<Exchange::Lists<vtkIdType>> askedFor(places.size());
  for (const size_t p : InTurn(places.size()))
  {
    const int self = exchange.GetPartition(static_cast<int>(p));
    for (size_t i = 0; i < answers[p].size(); ++i)
    {
      if (!answers[p][i].IsSeveral && answers[p][i].Owner != self)
      {
        questions[p][answers[p][i].Owner].push_back(answers[p][i].Number);
        askedFor[p][answers[p][i].Owner].push_back(static_cast<vtkIdType>(i));
      }
    }
  }
  std::vector<Exchange::Lists<vtkIdType>> replies(places.size());
  const std::vector<Exchange::Lists<vtkIdType>> asked = exchange.SendLists(questions);
  for (const size_t p : InTurn(places.size()))
  {
    for (const auto& [from, list] : asked[p])
    {
      for (const vtkIdType place : list)
      {
        replies[p][from].push_back(places[p].Ids[place]);
      }
    }
  }
  const std::vector<Exchange::Lists<vtkIdType>> arrived = exchange.SendLists(replies);
  for (const size_t p : InTurn(places.size()))
  {
    for (const auto& [from, list] : arrived[p])
    {
      for (size_t i = 0; i < list.size(); ++i)
      {
        places[p].Ids[askedFor[p][from][i]] = list[i];
      }
    }
  }
}

/// `byIds`: points have the same place if they have the same number, variant and case.
void IdentifyByPlace(Parts& parts, Exchange& exchange,
  const std::function<void(const std::string&)>& warn, bool byIds, bool joinsCopies)
{
  std::vector<PlacesOfPartition> places;
  for (const auto& partition : parts)
  {
    places.emplace_back(partition, byIds, joinsCopies);
  }
  const std::vector<std::vector<Answer>> answers = AskDirectory(places, exchange);
  NumberOwn(answers, parts, places, exchange);
  if (exchange.GetNumberOfPartitions() > 1)
  {
    FetchNumbers(answers, places, exchange);
  }
  vtkIdType several = 0;
  const PointOfPart* first = nullptr;
  for (size_t p = 0; p < parts.size(); ++p)
  {
    for (size_t i = 0; i < places[p].GetNumberOfPlaces(); ++i)
    {
      if (answers[p][i].IsSeveral)
      {
        const bool isShared = answers[p][i].Owner != exchange.GetPartition(static_cast<int>(p)) ||
          places[p].Points[places[p].Begins[i]].Part !=
            places[p].Points[places[p].Begins[i + 1] - 1].Part;
        several += isShared ? 1 : 0;
        first = isShared && !first ? &places[p].Points[places[p].Begins[i]] : first;
        continue;
      }
      for (size_t k = places[p].Begins[i]; k < places[p].Begins[i + 1]; ++k)
      {
        const PointOfPart& point = places[p].Points[k];
        parts[p][point.Part].Points[point.Index] = places[p].Ids[i];
      }
    }
  }
  if (several > 0)
  {
    warn("At " + std::to_string(several) +
      " places where blocks or partitions meet, one of them has several points with the same "
      "coordinates, the first is point " +
      std::to_string(first->Index) +
      ". Points stay apart there, and the result may have gaps. Give the points global ids, or "
      "merge points with vtkStaticCleanUnstructuredGrid or vtkCleanPolyData before.");
  }
}

}

bool IdentifyPoints(Parts& parts, Exchange& exchange,
  const std::function<void(const std::string&)>& warn, bool joinsCopies)
{
  for (auto& partition : parts)
  {
    for (MeshPart& part : partition)
    {
      MarkUsed(part);
    }
  }
  bool areSeveral = false;
  if (!AllHave(parts, exchange, vtkDataObject::POINT))
  {
    IdentifyByPlace(parts, exchange, warn, false, joinsCopies);
  }
  else
  {
    TakeGlobalIds(parts, vtkDataObject::POINT, &MeshPart::Points);
    areSeveral = FindPlacesOfIds(parts, exchange, warn);
    if (areSeveral)
    {
      IdentifyByPlace(parts, exchange, warn, true, joinsCopies);
    }
  }
  if (AreSeveralBlocks(parts, exchange) && FindCases(parts, exchange, warn))
  {
    IdentifyByPlace(parts, exchange, warn, true, joinsCopies);
  }
  if (AllHave(parts, exchange, vtkDataObject::CELL) && HaveDistinctCells(parts, exchange))
  {
    TakeGlobalIds(parts, vtkDataObject::CELL, &MeshPart::Cells);
  }
  else
  {
    NumberCells(parts, exchange);
  }
  return areSeveral;
}

}
