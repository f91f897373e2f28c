// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Layers.h"

#include "Core/Memory/Sorting.h"
#include "Private/Distribution/MeshMessage.h"
#include "Private/Distribution/StampedParts.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace subdivision
{
namespace
{

/// A point that a partition has cells at, or wants the cells of.
struct Wish
{
  vtkIdType Point;
  int Partition;
  int Unused = 0;

  bool operator<(const Wish& other) const
  {
    return this->Point != other.Point ? this->Point < other.Point
                                      : this->Partition < other.Partition;
  }
};

/// The partition that knows who has a point.
class Directory
{
public:
  Directory(vtkIdType numberOfIds, int partitions)
    : Share((numberOfIds + partitions - 1) / partitions)
  {
  }
  int Find(vtkIdType point) const { return static_cast<int>(point / this->Share); }

  /// Adds the partition to those that have the points.
  void Add(const std::vector<vtkIdType>& points, int partition)
  {
    for (const vtkIdType point : InTurn(points))
    {
      this->Holders.push_back({ point, partition });
    }
  }
  void Sort() { StableSort(this->Holders, std::less<>()); }

  /// Passes on a wish to all that have the point but the one who wishes.
  void PassOn(const Wish& wish, Exchange::Lists<Wish>& toHolders) const
  {
    auto holder = std::lower_bound(this->Holders.begin(), this->Holders.end(), wish.Point,
      [](const Wish& a, vtkIdType point) { return a.Point < point; });
    for (; holder != this->Holders.end() && holder->Point == wish.Point; ++holder)
    {
      if (holder->Partition != wish.Partition)
      {
        toHolders[holder->Partition].push_back(wish);
      }
    }
  }

private:
  vtkIdType Share;
  std::vector<Wish> Holders;
};

/// One partition: its own parts, and what it sent and got so far.
struct Partition
{
  std::vector<MeshPart>* Parts = nullptr;
  size_t NumberOfOwn = 0;
  std::vector<CellGroups> Groups; ///< of all parts
  Copies Sent;
  SentLayers Kept;
  std::vector<vtkIdType> Known; ///< points of its cells, ascending

  explicit Partition(std::vector<MeshPart>& parts)
    : Parts(&parts)
    , NumberOfOwn(parts.size())
  {
    this->GroupNewParts();
  }
  void GroupNewParts()
  {
    while (this->Groups.size() < this->Parts->size())
    {
      MeshPart& part = (*this->Parts)[this->Groups.size()];
      part.Levels = this->Parts->front().Levels;
      this->Groups.emplace_back();
      FindGroups(part, this->Groups.back());
    }
  }
};

bool Exists(vtkIdType point, const MeshPart& part)
{
  return point >= 0 && point < static_cast<vtkIdType>(part.Points.size());
}

/// The ids of the points at the corners of groups, ascending. `first`: the first part.
std::vector<vtkIdType> FindPointIds(const Partition& partition, size_t first)
{
  std::vector<vtkIdType> ids;
  for (size_t p = first; p < partition.Groups.size(); ++p)
  {
    const MeshPart& part = (*partition.Parts)[p];
    std::vector<char> used(part.Points.size(), 0);
    for (const vtkIdType point : partition.Groups[p].Points)
    {
      if (Exists(point, part))
      {
        used[point] = 1;
      }
    }
    for (size_t i = 0; i < used.size(); ++i)
    {
      if (used[i] && part.Points[i] >= 0)
      {
        ids.push_back(part.Points[i]);
      }
    }
  }
  SortDistinct(ids);
  return ids;
}

/// Which groups are wished: those with a wished point, or those all of whose points are.
enum class Extent
{
  Stars,
  Inside
};

/// send(partition, group) for the wished groups of a part.
template <typename Send>
void VisitWished(const CellGroups& groups, const MeshPart& part, const std::vector<Wish>& wishes,
  Extent extent, const Send& send)
{
  // The first wish of each point of the part.
  std::vector<vtkIdType> first(part.Points.size(), -1);
  for (const size_t i : InTurn(first.size()))
  {
    const auto found = std::lower_bound(wishes.begin(), wishes.end(), part.Points[i],
      [](const Wish& a, vtkIdType point) { return a.Point < point; });
    if (found != wishes.end() && found->Point == part.Points[i])
    {
      first[i] = found - wishes.begin();
    }
  }
  std::map<int, vtkIdType> wished; // by the partition, how many points of the group
  for (vtkIdType g = 0; g < groups.GetNumberOfGroups(); ++g)
  {
    wished.clear();
    for (vtkIdType i = groups.PointStarts[g]; i < groups.PointStarts[g + 1]; ++i)
    {
      const vtkIdType point = groups.Points[i];
      if (!Exists(point, part) || first[point] < 0)
      {
        continue;
      }
      for (auto wish = wishes.begin() + first[point];
        wish != wishes.end() && wish->Point == part.Points[point]; ++wish)
      {
        ++wished[wish->Partition];
      }
    }
    const vtkIdType least =
      extent == Extent::Stars ? 1 : groups.PointStarts[g + 1] - groups.PointStarts[g];
    for (const auto& [partition, points] : wished)
    {
      if (points >= least)
      {
        send(partition, g);
      }
    }
  }
}

/// The messages with the wished cells of a partition.
Exchange::Messages PackWished(Partition& partition, std::vector<Wish> wishes, Extent extent)
{
  std::sort(wishes.begin(), wishes.end());
  std::map<int, std::vector<std::vector<vtkIdType>>> lists; // to a partition: cells of each part
  for (const size_t p : InTurn(partition.NumberOfOwn))
  {
    const MeshPart& part = (*partition.Parts)[p];
    const CellGroups& groups = partition.Groups[p];
    VisitWished(groups, part, wishes, extent,
      [&](int to, vtkIdType group)
      {
        auto& sent = partition.Sent[to];
        sent.resize(partition.NumberOfOwn);
        sent[p].resize(part.Cells.size(), 0);
        for (vtkIdType i = groups.Starts[group]; i < groups.Starts[group + 1]; ++i)
        {
          const vtkIdType cell = groups.Cells[i];
          if (!sent[p][cell])
          {
            sent[p][cell] = 1;
            lists[to].resize(partition.NumberOfOwn);
            lists[to][p].push_back(cell);
          }
        }
      });
  }
  Exchange::Messages messages;
  for (const auto& [to, cells] : lists)
  {
    for (size_t p = 0; p < cells.size(); ++p)
    {
      if (!cells[p].empty())
      {
        std::vector<vtkIdType> points = PackCells((*partition.Parts)[p], cells[p], messages[to]);
        partition.Kept.Out[to].push_back({ p, std::move(points), cells[p] });
      }
    }
  }
  return messages;
}

vtkIdType CountIds(const std::vector<std::vector<MeshPart>>& parts, Exchange& exchange)
{
  vtkIdType last = 0;
  for (const auto& partition : parts)
  {
    for (const MeshPart& part : partition)
    {
      last = std::accumulate(part.Points.begin(), part.Points.end(), last,
        [](vtkIdType a, vtkIdType b) { return std::max(a, b); });
    }
  }
  return exchange.Max(last) + 1;
}

/// How many exchanges bring the stars of points, and how many what is inside.
std::pair<int, int> CountExchanges(
  const std::vector<std::vector<MeshPart>>& parts, int layers, Exchange& exchange)
{
  vtkIdType most = 0;
  for (const auto& partition : parts)
  {
    most = std::max<vtkIdType>(most, partition.empty() ? 0 : partition[0].Levels);
  }
  return { layers, exchange.Max(most) > 0 ? 1 : 0 };
}

}

std::vector<SentLayers> AddLayers(
  std::vector<std::vector<MeshPart>>& parts, int layers, Exchange& exchange)
{
  std::vector<Directory> directories(
    parts.size(), Directory(CountIds(parts, exchange), exchange.GetNumberOfPartitions()));
  std::vector<Partition> partitions;
  for (auto& own : parts)
  {
    partitions.emplace_back(own);
  }
  size_t size = parts.size();
  std::vector<size_t> seen(size, 0); // parts whose points are known
  const auto [stars, inside] = CountExchanges(parts, layers, exchange);
  for (int layer = 0; layer < stars + inside; ++layer)
  {
    const Extent extent = layer < stars ? Extent::Stars : Extent::Inside;
    // To the directory: the points that are new.
    std::vector<Exchange::Lists<vtkIdType>> questions(size);
    for (size_t i = 0; i < size; ++i)
    {
      Partition& partition = partitions[i];
      partition.GroupNewParts();
      const std::vector<vtkIdType> ids = FindPointIds(partition, seen[i]);
      seen[i] = partition.Parts->size();
      std::vector<vtkIdType> fresh;
      std::set_difference(ids.begin(), ids.end(), partition.Known.begin(), partition.Known.end(),
        std::back_inserter(fresh));
      std::vector<vtkIdType> known;
      std::merge(fresh.begin(), fresh.end(), partition.Known.begin(), partition.Known.end(),
        std::back_inserter(known));
      partition.Known = std::move(known);
      for (const vtkIdType id : fresh)
      {
        questions[i][directories[i].Find(id)].push_back(id);
      }
    }
    // From the directory to the partitions that have cells there.
    std::vector<Exchange::Lists<Wish>> wishes(size);
    const std::vector<Exchange::Lists<vtkIdType>> asked = exchange.SendLists(questions);
    for (size_t i = 0; i < size; ++i)
    {
      if (layer == 0)
      {
        for (const auto& [from, points] : asked[i])
        {
          directories[i].Add(points, from);
        }
        directories[i].Sort();
      }
      for (const auto& [from, points] : asked[i])
      {
        for (const vtkIdType point : points)
        {
          directories[i].PassOn({ point, from }, wishes[i]);
        }
      }
    }
    // From these to those who asked: the cells.
    std::vector<Exchange::Messages> cells(size);
    const std::vector<Exchange::Lists<Wish>> wished = exchange.SendLists(wishes);
    for (size_t i = 0; i < size; ++i)
    {
      std::vector<Wish> all;
      for (const auto& [from, list] : wished[i])
      {
        all.insert(all.end(), list.begin(), list.end());
      }
      cells[i] = PackWished(partitions[i], std::move(all), extent);
      if (layer == 0)
      {
        partitions[i].Kept.OfFirst = partitions[i].Sent;
      }
    }
    const std::vector<Exchange::Messages> arrived = exchange.Send(std::move(cells));
    for (const size_t i : InTurn(size))
    {
      for (const auto& [from, message] : arrived[i])
      {
        const size_t first = partitions[i].Parts->size();
        UnpackCells(message, *partitions[i].Parts);
        for (size_t p = first; p < partitions[i].Parts->size(); ++p)
        {
          partitions[i].Kept.In[from].push_back(p);
        }
      }
    }
  }
  std::vector<SentLayers> sent;
  for (Partition& partition : partitions)
  {
    sent.push_back(std::move(partition.Kept));
  }
  return sent;
}

void SendValuesAgain(std::vector<std::vector<MeshPart>>& parts, const std::vector<SentLayers>& sent,
  Exchange& exchange)
{
  std::vector<Exchange::Messages> out(parts.size());
  for (size_t i = 0; i < parts.size(); ++i)
  {
    for (const auto& [to, list] : sent[i].Out)
    {
      for (const SentLayers::Cells& cells : list)
      {
        PackValues(parts[i][cells.Part], cells.Points, cells.Cells, out[i][to]);
      }
    }
  }
  const std::vector<Exchange::Messages> arrived = exchange.Send(std::move(out));
  for (size_t i = 0; i < parts.size(); ++i)
  {
    for (const auto& [from, message] : arrived[i])
    {
      std::vector<MeshPart*> added;
      for (const size_t p : sent[i].In.at(from))
      {
        added.push_back(&parts[i][p]);
      }
      UnpackValues(message, added);
    }
  }
}

}
