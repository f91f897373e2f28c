// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/PointIds.h"

#include "Core/Memory/Sorting.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Distribution/BlockCases.h"
#include "Private/Distribution/PlacesOfIds.h"
#include "Private/Partitions/SharedValues.h"
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

using Parts = std::vector<MeshPart>;
using Ids = std::vector<vtkIdType>;

/// Marks the cells that are used, and the points: all but points that only duplicate cells use.
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
  for (const MeshPart& part : parts)
  {
    const vtkIdType size = part.Mesh->GetNumberOfElements(association);
    const Ids ids = ReadIdsOf(part.Mesh->GetAttributes(association), size);
    have = have && static_cast<vtkIdType>(ids.size()) == size &&
      std::all_of(ids.begin(), ids.end(), [](vtkIdType id) { return id >= 0 && id < VTK_ID_MAX; });
  }
  return exchange.Agree(have);
}

void TakeGlobalIds(Parts& parts, int association, Ids MeshPart::* ids)
{
  for (MeshPart& part : parts)
  {
    const Ids given =
      ReadIdsOf(part.Mesh->GetAttributes(association), part.Mesh->GetNumberOfElements(association));
    for (size_t i = 0; i < given.size(); ++i)
    {
      vtkIdType& id = (part.*ids)[i];
      id = id < 0 ? -1 : given[i];
    }
  }
}

/// The number at which this partition starts if it takes `count` of them.
vtkIdType GetStart(vtkIdType count, Exchange& exchange)
{
  const Ids all = exchange.Gather(count);
  return std::accumulate(all.begin(), all.begin() + exchange.GetPartition(), vtkIdType(0));
}

void NumberCells(Parts& parts, Exchange& exchange)
{
  vtkIdType count = 0;
  for (const MeshPart& part : parts)
  {
    count +=
      std::count_if(part.Cells.begin(), part.Cells.end(), [](vtkIdType id) { return id >= 0; });
  }
  vtkIdType next = GetStart(count, exchange);
  for (MeshPart& part : parts)
  {
    for (vtkIdType& id : part.Cells)
    {
      id = id < 0 ? -1 : next++;
    }
  }
}

/// Whether no two cells have the same global id.
bool HaveDistinctCells(const Parts& parts, Exchange& exchange)
{
  SharedKeys cells;
  for (const MeshPart& part : parts)
  {
    const Ids ids = ReadIdsOf(part.Mesh->GetCellData(), part.Mesh->GetNumberOfCells());
    for (size_t i = 0; i < ids.size(); ++i)
    {
      if (part.Cells[i] >= 0)
      {
        cells.Keys.push_back(ids[i]);
      }
    }
  }
  cells.Own.assign(cells.Keys.size(), 1);
  SharedDirectory directory(cells, 0, {}, 0, exchange);
  bool distinct = true;
  directory.ForThings([&](auto first, auto last) { distinct = distinct && last - first == 1; });
  return exchange.Agree(distinct);
}

// ------------------------------------------------------------------------------------------------
// Points by coordinates

/// The key that points have in common if they are one point: coordinates or, with global ids, the
/// variant of the id as the first of them.
struct Site
{
  std::array<double, 3> At;
  vtkIdType Id;
  vtkIdType Case;

  auto Get() const { return std::tie(this->At, this->Id, this->Case); }
  bool operator<(const Site& other) const { return this->Get() < other.Get(); }
  bool operator!=(const Site& other) const { return this->Get() != other.Get(); }
};

/// Adds the key by which the directory knows a site. Of coordinates the first id is the partition
/// that keeps it.
void AddKey(const Site& site, bool byIds, int partitions, SharedKeys& keys)
{
  if (byIds)
  {
    keys.Keys.insert(keys.Keys.end(), { site.Id, static_cast<vtkIdType>(site.At[0]), site.Case });
    return;
  }
  vtkIdType bits[3];
  std::memcpy(bits, site.At.data(), sizeof(bits));
  std::uint64_t hash = 0;
  for (const vtkIdType x : bits)
  {
    hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  keys.Keys.push_back(static_cast<vtkIdType>(hash % static_cast<std::uint64_t>(partitions)));
  keys.Keys.insert(keys.Keys.end(), bits, bits + 3);
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

/// The points of a partition sorted by place; points without a finite place, which nobody can
/// share, come last and unsorted.
std::vector<PointOfPart> SortPoints(const Parts& parts, bool byIds, size_t& finite)
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

  PlacesOfPartition(const Parts& parts, bool byIds, bool joinsCopies)
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

/// The answer of the directory about a place: the first partition that has it (which gives the
/// number), the place there, and whether points stay apart there.
struct Answer
{
  vtkIdType Owner;
  vtkIdType Place;
  bool IsSeveral;
};

/// Asks for each place who else has it.
std::vector<Answer> AskDirectory(const PlacesOfPartition& own, bool byIds, Exchange& exchange)
{
  std::vector<Answer> answers;
  for (const size_t i : InTurn(own.GetNumberOfPlaces()))
  {
    answers.push_back(
      { exchange.GetPartition(), static_cast<vtkIdType>(i), own.IsSeveral[i] != 0 });
  }
  if (exchange.GetNumberOfPartitions() == 1)
  {
    return answers;
  }
  SharedKeys keys;
  keys.Width = byIds ? 3 : 4;
  Ids told;
  for (const size_t i : InTurn(own.NumberOfFinite))
  {
    AddKey(own.Points[own.Begins[i]].At, byIds, exchange.GetNumberOfPartitions(), keys);
    keys.Own.push_back(1);
    told.push_back(2 * answers[i].Place + own.IsSeveral[i]);
  }
  SharedDirectory directory(keys, 1, told, 2, exchange);
  directory.ForThings(
    [](auto first, auto last)
    {
      const bool isSeveral =
        std::any_of(first, last, [](const auto& entry) { return *entry.Told % 2 != 0; });
      for (auto entry = first; entry != last; ++entry)
      {
        entry->Answer[0] = first->From;
        entry->Answer[1] = *first->Told / 2 * 2 + (isSeveral ? 1 : 0);
      }
    });
  const Ids found = directory.TakeAnswers();
  for (const size_t i : InTurn(own.NumberOfFinite))
  {
    answers[i] = { found[2 * i], found[2 * i + 1] / 2, found[2 * i + 1] % 2 != 0 };
  }
  return answers;
}

/// Gives numbers to the places and points that this partition owns: in the order in which the
/// points stand in the parts, so that one partition keeps its order.
void NumberOwn(
  const std::vector<Answer>& answers, Parts& parts, PlacesOfPartition& own, Exchange& exchange)
{
  own.Ids.assign(own.GetNumberOfPlaces(), -1);
  std::vector<Ids> placeOf; // of each point, by part and index
  for (const MeshPart& part : parts)
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
  for (size_t p = 0; p < parts.size(); ++p)
  {
    for (size_t i = 0; i < placeOf[p].size(); ++i)
    {
      const vtkIdType place = placeOf[p][i];
      if (place >= 0 && answers[place].IsSeveral)
      {
        parts[p].Points[i] = count++;
      }
      else if (place >= 0 && answers[place].Owner == exchange.GetPartition() && own.Ids[place] < 0)
      {
        own.Ids[place] = count++;
      }
    }
  }
  const vtkIdType start = GetStart(count, exchange);
  const auto move = [start](Ids& ids)
  {
    for (vtkIdType& id : ids)
    {
      id = id < 0 ? -1 : id + start;
    }
  };
  move(own.Ids);
  for (MeshPart& part : parts)
  {
    move(part.Points); // overwritten below where the place has the number
  }
}

/// Takes the numbers of places that other partitions own.
void FetchNumbers(const std::vector<Answer>& answers, PlacesOfPartition& places, Exchange& exchange)
{
  Ids owners;
  for (const Answer& answer : InTurn(answers))
  {
    const bool isOfOther = !answer.IsSeveral && answer.Owner != exchange.GetPartition();
    owners.push_back(isOfOther ? answer.Owner : -1);
    owners.push_back(isOfOther ? answer.Place : -1);
  }
  SharedValues(owners, exchange).TakeOthers(places.Ids.data(), 1);
}

/// `byIds`: points have the same place if they have the same number, variant and case.
void IdentifyByPlace(Parts& parts, Exchange& exchange,
  const std::function<void(const std::string&)>& warn, bool byIds, bool joinsCopies)
{
  PlacesOfPartition places(parts, byIds, joinsCopies);
  const std::vector<Answer> answers = AskDirectory(places, byIds, exchange);
  NumberOwn(answers, parts, places, exchange);
  if (exchange.GetNumberOfPartitions() > 1)
  {
    FetchNumbers(answers, places, exchange);
  }
  vtkIdType several = 0;
  const PointOfPart* first = nullptr;
  for (size_t i = 0; i < places.GetNumberOfPlaces(); ++i)
  {
    const PointOfPart* begin = places.Points.data() + places.Begins[i];
    const PointOfPart* end = places.Points.data() + places.Begins[i + 1];
    if (answers[i].IsSeveral)
    {
      const bool isShared =
        answers[i].Owner != exchange.GetPartition() || begin->Part != (end - 1)->Part;
      several += isShared ? 1 : 0;
      first = isShared && !first ? begin : first;
      continue;
    }
    for (const PointOfPart* point = begin; point != end; ++point)
    {
      parts[point->Part].Points[point->Index] = places.Ids[i];
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
  for (MeshPart& part : parts)
  {
    MarkUsed(part);
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
