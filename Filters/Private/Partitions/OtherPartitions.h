// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OtherPartitions.h
 * The messages of a partition of a mesh to the others, and its knowledge of them.
 */
#ifndef SubdivisionObjects_OtherPartitions_h
#define SubdivisionObjects_OtherPartitions_h

#include "vtkType.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace subdivision
{

/// Thrown where another partition has stopped its work: this one has to stop too.
class PartitionStopped : public std::exception
{
public:
  const char* what() const noexcept override { return "another partition has stopped"; }
};

/// The exchange of one partition with all others, which call the same functions in the same order.
class Exchange
{
public:
  /// By the number of the partition that they go to, and then come from.
  using Messages = std::map<int, std::vector<char>>;
  template <typename T>
  using Lists = std::map<int, std::vector<T>>;

  virtual ~Exchange() = default;
  virtual int GetPartition() const = 0;
  virtual int GetNumberOfPartitions() const = 0;
  /// Delivers messages. Returns false if no partition had any.
  virtual bool Send(Messages& messages) = 0;
  /// The values of all partitions, which are not negative; -1 for partitions without a mesh while
  /// others work: they send nothing and lose all messages.
  virtual std::vector<vtkIdType> Gather(vtkIdType own) = 0;

  /// The same as Send for lists of plain values.
  template <typename T>
  bool SendLists(Lists<T>& lists);
  vtkIdType Sum(vtkIdType own);
  vtkIdType Max(vtkIdType own);
  /// Whether all partitions say yes.
  bool Agree(bool own) { return this->Max(own ? 0 : 1) == 0; }
  /// The first partition that has a mesh.
  int FindFirst();
  /// Sets each value to the largest that a partition has. All bring the same number of values.
  void FindLargest(std::vector<double>& values);
  /// Replaces values in one partition by all values, in the order of partitions; elsewhere by none.
  template <typename T>
  void BringTo(int one, std::vector<T>& values);
  /// Replaces values by the values of one partition.
  template <typename T>
  void TakeFrom(int one, std::vector<T>& values);
  /// Replaces values by the values of all partitions, in their order.
  template <typename T>
  void ShareWithAll(std::vector<T>& values);

private:
  template <typename T>
  Lists<T> MakeListsForAll(const std::vector<T>& values) const
  {
    Lists<T> lists;
    for (int to = 0; to < this->GetNumberOfPartitions(); ++to)
    {
      lists[to] = values;
    }
    return lists;
  }
  template <typename T>
  static void Join(const Lists<T>& lists, std::vector<T>& values)
  {
    values.clear();
    for (const auto& [from, list] : lists)
    {
      values.insert(values.end(), list.begin(), list.end());
    }
  }
};

/**
 * The other partitions, as the work on one partition knows them. The mesh that the work gets has
 * the cells of the partition, its own, and copies of cells of others around them.
 *
 * A partition may stop at any time: its work returns false, or throws; then Send and Gather throw
 * PartitionStopped in the others.
 */
class OtherPartitions : public Exchange
{
public:
  /// The ids of the points of the mesh, ascending: equal ids are one point.
  virtual const std::vector<vtkIdType>& GetPointIds() const = 0;
  /// The ids of the cells of the mesh; in poly data ascending within each kind of cells.
  virtual const std::vector<vtkIdType>& GetCellIds() const = 0;
  virtual bool IsOwn(vtkIdType cell) const = 0;
  /// The partitions that have cells of their own at points of an own cell.
  virtual const std::vector<int>& GetNeighbours(vtkIdType cell) const = 0;
};

template <typename T>
bool Exchange::SendLists(Lists<T>& lists)
{
  Messages messages;
  for (auto& [to, list] : lists)
  {
    const char* first = reinterpret_cast<const char*>(list.data());
    messages[to].assign(first, first + list.size() * sizeof(T));
    std::vector<T>().swap(list);
  }
  lists.clear();
  const bool haveSent = this->Send(messages);
  for (auto& [from, message] : messages)
  {
    std::vector<T>& list = lists[from];
    list.resize(message.size() / sizeof(T));
    if (!list.empty()) // else there is no place to copy to, which memcpy does not allow
    {
      std::memcpy(static_cast<void*>(list.data()), message.data(), message.size());
    }
    std::vector<char>().swap(message);
  }
  return haveSent;
}

inline vtkIdType Exchange::Sum(vtkIdType own)
{
  const std::vector<vtkIdType> all = this->Gather(own);
  return std::accumulate(all.begin(), all.end(), vtkIdType(0),
    [](vtkIdType sum, vtkIdType value) { return sum + std::max<vtkIdType>(value, 0); });
}

inline vtkIdType Exchange::Max(vtkIdType own)
{
  const std::vector<vtkIdType> all = this->Gather(own);
  return *std::max_element(all.begin(), all.end());
}

inline int Exchange::FindFirst()
{
  const std::vector<vtkIdType> all = this->Gather(0);
  return static_cast<int>(std::find(all.begin(), all.end(), vtkIdType(0)) - all.begin());
}

inline void Exchange::FindLargest(std::vector<double>& values)
{
  const std::vector<vtkIdType> counts = this->Gather(static_cast<vtkIdType>(values.size()));
  const auto first =
    std::find_if(counts.begin(), counts.end(), [](vtkIdType count) { return count >= 0; });
  if (std::any_of(
        first, counts.end(), [&](vtkIdType count) { return count >= 0 && count != *first; }))
  {
    throw PartitionStopped(); // in all partitions: whoever goes on would wait for ever
  }
  const int one = static_cast<int>(first - counts.begin());
  const std::size_t size = values.size();
  this->BringTo(one, values);
  for (std::size_t i = size; i < values.size(); ++i)
  {
    values[i % size] = values[i] > values[i % size] ? values[i] : values[i % size];
  }
  values.resize(size);
  this->TakeFrom(one, values);
}

template <typename T>
void Exchange::BringTo(int one, std::vector<T>& values)
{
  Lists<T> lists{ { one, std::move(values) } };
  this->SendLists(lists);
  Join(lists, values);
}

template <typename T>
void Exchange::TakeFrom(int one, std::vector<T>& values)
{
  Lists<T> lists = this->GetPartition() == one ? this->MakeListsForAll(values) : Lists<T>();
  this->SendLists(lists);
  values = std::move(lists.at(one));
}

template <typename T>
void Exchange::ShareWithAll(std::vector<T>& values)
{
  Lists<T> lists = this->MakeListsForAll(values);
  this->SendLists(lists);
  Join(lists, values);
}

}

#endif
