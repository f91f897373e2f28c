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

/// Which partition knows who has a point, and the knowledge of this one.
class Directory
{
public:
  Directory(const std::vector<MeshPart>& parts, Exchange& exchange)
  {
    vtkIdType last = 0;
    for (const MeshPart& part : parts)
    {
      last = std::accumulate(part.Points.begin(), part.Points.end(), last,
        [](vtkIdType a, vtkIdType b) { return std::max(a, b); });
    }
    this->Share = exchange.Max(last) / exchange.GetNumberOfPartitions() + 1;
  }
  int Find(vtkIdType point) const { return static_cast<int>(point / this->Share); }

  /// Adds the partition to the holders of the points.
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

/// The own parts of a partition, and the cells that it sent and got so far.
struct Partition
{
  std::vector<MeshPart>& Parts;
  const size_t NumberOfOwn;
  std::vector<CellGroups> Groups; ///< of all parts
  Copies Sent;
  SentLayers Kept;
  std::vector<vtkIdType> Known; ///< points of its cells, ascending

  explicit Partition(std::vector<MeshPart>& parts)
    : Parts(parts)
    , NumberOfOwn(parts.size())
  {
  }
  /// Groups the cells of parts that are new, and returns the points at the corners of their groups
  /// that were not known, ascending.
  std::vector<vtkIdType> FindNewPoints();
};

bool Exists(vtkIdType point, const MeshPart& part)
{
  return point >= 0 && point < static_cast<vtkIdType>(part.Points.size());
}

std::vector<vtkIdType> Partition::FindNewPoints()
{
  std::vector<vtkIdType> ids;
  while (this->Groups.size() < this->Parts.size())
  {
    MeshPart& part = this->Parts[this->Groups.size()];
    part.Levels = this->Parts.front().Levels;
    this->Groups.emplace_back();
    FindGroups(part, this->Groups.back());
    std::vector<char> used(part.Points.size(), 0);
    for (const vtkIdType point : this->Groups.back().Points)
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
  std::vector<vtkIdType> fresh;
  std::set_difference(
    ids.begin(), ids.end(), this->Known.begin(), this->Known.end(), std::back_inserter(fresh));
  std::vector<vtkIdType> known;
  std::merge(
    fresh.begin(), fresh.end(), this->Known.begin(), this->Known.end(), std::back_inserter(known));
  this->Known = std::move(known);
  return fresh;
}

/// Which groups are wished: groups with a wished point, or groups all of whose points are wished.
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
    const MeshPart& part = partition.Parts[p];
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
        std::vector<vtkIdType> points = PackCells(partition.Parts[p], cells[p], messages[to]);
        partition.Kept.Out[to].push_back({ p, std::move(points), cells[p] });
      }
    }
  }
  return messages;
}

}

SentLayers AddLayers(std::vector<MeshPart>& parts, int layers, Exchange& exchange)
{
  Directory directory(parts, exchange);
  Partition partition(parts);
  const bool areStamped = exchange.Max(parts.empty() ? 0 : parts[0].Levels) > 0;
  for (int layer = 0; layer < layers + (areStamped ? 1 : 0); ++layer)
  {
    const Extent extent = layer < layers ? Extent::Stars : Extent::Inside;
    // To the directory: the points that are new.
    Exchange::Lists<vtkIdType> points;
    for (const vtkIdType id : partition.FindNewPoints())
    {
      points[directory.Find(id)].push_back(id);
    }
    exchange.SendLists(points);
    if (layer == 0)
    {
      for (const auto& [from, list] : points)
      {
        directory.Add(list, from);
      }
      directory.Sort();
    }
    // From the directory to the partitions that have cells there.
    Exchange::Lists<Wish> wishes;
    for (const auto& [from, list] : points)
    {
      for (const vtkIdType point : list)
      {
        directory.PassOn({ point, from }, wishes);
      }
    }
    exchange.SendLists(wishes);
    // From these to the partitions that asked: the cells.
    std::vector<Wish> all;
    for (const auto& [from, list] : wishes)
    {
      all.insert(all.end(), list.begin(), list.end());
    }
    Exchange::Messages cells = PackWished(partition, std::move(all), extent);
    if (layer == 0)
    {
      partition.Kept.OfFirst = partition.Sent;
    }
    exchange.Send(cells);
    for (const auto& [from, message] : cells)
    {
      size_t next = parts.size();
      UnpackCells(message, parts);
      for (; next < parts.size(); ++next)
      {
        partition.Kept.In[from].push_back(next);
      }
    }
  }
  return std::move(partition.Kept);
}

void SendValuesAgain(std::vector<MeshPart>& parts, const SentLayers& sent, Exchange& exchange)
{
  Exchange::Messages messages;
  for (const auto& [to, list] : sent.Out)
  {
    for (const SentLayers::Cells& cells : list)
    {
      PackValues(parts[cells.Part], cells.Points, cells.Cells, messages[to]);
    }
  }
  exchange.Send(messages);
  for (const auto& [from, message] : messages)
  {
    std::vector<MeshPart*> added;
    for (const size_t p : sent.In.at(from))
    {
      added.push_back(&parts[p]);
    }
    UnpackValues(message, added);
  }
}

}
