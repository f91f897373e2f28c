// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Partners.h
 * The other partitions of a mesh, for work that has to agree with them in rounds.
 */
#ifndef SubdivisionObjects_Partners_h
#define SubdivisionObjects_Partners_h

#include "vtkType.h"

#include <cstring>
#include <exception>
#include <map>
#include <vector>

namespace subdivision
{

/// Thrown where another partition has stopped its work: this one has to stop too.
class PartnersStopped : public std::exception
{
public:
  const char* what() const noexcept override { return "another partition has stopped"; }
};

/**
 * The other partitions, as the work on one partition knows them. The mesh that the work gets has
 * the cells of the partition, its own, and copies of cells of others around them.
 *
 * All partitions call the functions below the line in the same order. A partition may stop at any
 * time: its work returns false, or throws; then these functions throw PartnersStopped in the
 * others.
 */
class Partners
{
public:
  using Messages = std::map<int, std::vector<char>>;

  virtual ~Partners() = default;
  virtual int GetPartition() const = 0;
  virtual int GetNumberOfPartitions() const = 0;
  /// The ids of the points of the mesh, ascending: equal ids are one point.
  virtual const std::vector<vtkIdType>& GetPointIds() const = 0;
  /// The ids of the cells of the mesh; in poly data ascending within each kind of cells.
  virtual const std::vector<vtkIdType>& GetCellIds() const = 0;
  virtual bool IsOwn(vtkIdType cell) const = 0;
  /// The partitions that have cells of their own at points of an own cell.
  virtual const std::vector<int>& GetNeighbours(vtkIdType cell) const = 0;

  // ----------------------------------------------------------------------------------------------

  /// Delivers messages, by the number of the partition that they go to, and then come from. Returns
  /// false if no partition had any.
  virtual bool Send(Messages& messages) = 0;
  /// The values of all partitions, which are not negative; -1 for partitions without a mesh, which
  /// send nothing and lose all messages.
  virtual std::vector<vtkIdType> Gather(vtkIdType own) = 0;
  /// The sum of such values.
  vtkIdType Sum(vtkIdType own);
  /// The first partition that has a mesh.
  int FindFirst();
  /// Sets each value to the largest that a partition has. All bring the same number of values.
  void FindLargest(std::vector<double>& values);
  /// Replaces values in one partition by all values, in the order of partitions; elsewhere by none.
  void BringTo(int one, std::vector<double>& values);
  /// Replaces values by the values of one partition.
  void TakeFrom(int one, std::vector<double>& values);
};

inline vtkIdType Partners::Sum(vtkIdType own)
{
  vtkIdType sum = 0;
  for (const vtkIdType value : this->Gather(own))
  {
    sum += value > 0 ? value : 0;
  }
  return sum;
}

inline int Partners::FindFirst()
{
  const std::vector<vtkIdType> all = this->Gather(0);
  int first = 0;
  while (all[first] < 0)
  {
    ++first;
  }
  return first;
}

inline void Partners::FindLargest(std::vector<double>& values)
{
  const std::vector<vtkIdType> counts = this->Gather(static_cast<vtkIdType>(values.size()));
  int first = 0;
  while (counts[first] < 0)
  {
    ++first;
  }
  for (const vtkIdType count : counts)
  {
    if (count >= 0 && count != counts[first])
    {
      throw PartnersStopped(); // in all partitions: whoever goes on would wait for ever
    }
  }
  const std::size_t size = values.size();
  this->BringTo(first, values);
  for (std::size_t i = size; i < values.size(); ++i)
  {
    values[i % size] = values[i] > values[i % size] ? values[i] : values[i % size];
  }
  values.resize(size);
  this->TakeFrom(first, values);
}

/// Numbers, or records of numbers, as a message.
template <typename Number>
std::vector<char> Pack(const std::vector<Number>& numbers)
{
  const char* first = reinterpret_cast<const char*>(numbers.data());
  return { first, first + numbers.size() * sizeof(Number) };
}

template <typename Number>
Partners::Messages PackAll(const std::map<int, std::vector<Number>>& lists)
{
  Partners::Messages messages;
  for (const auto& [partition, list] : lists)
  {
    messages[partition] = Pack(list);
  }
  return messages;
}

template <typename Number>
std::vector<Number> Unpack(const std::vector<char>& message)
{
  std::vector<Number> numbers(message.size() / sizeof(Number));
  if (!numbers.empty()) // else there is no place to copy to, which memcpy does not allow
  {
    std::memcpy(
      static_cast<void*>(numbers.data()), message.data(), numbers.size() * sizeof(Number));
  }
  return numbers;
}

inline void Partners::BringTo(int one, std::vector<double>& values)
{
  Messages messages;
  messages[one] = Pack(values);
  this->Send(messages);
  values.clear();
  for (const auto& [from, message] : messages)
  {
    const std::vector<double> others = Unpack<double>(message);
    values.insert(values.end(), others.begin(), others.end());
  }
}

inline void Partners::TakeFrom(int one, std::vector<double>& values)
{
  Messages messages;
  for (int to = 0; this->GetPartition() == one && to < this->GetNumberOfPartitions(); ++to)
  {
    messages[to] = Pack(values);
  }
  this->Send(messages);
  values = Unpack<double>(messages.at(one));
}

}

#endif
