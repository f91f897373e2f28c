// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Exchange.h
 * Messages between partitions, on one rank or on several.
 */
#ifndef SubdivisionObjects_Exchange_h
#define SubdivisionObjects_Exchange_h

#include "vtkType.h"

#include <cstring>
#include <map>
#include <vector>

class vtkMultiProcessController;

namespace subdivision
{

/**
 * Every rank has the same number of partitions: one in a filter; tests and benchmarks simulate more
 * in one process. All ranks call all functions in the same order.
 */
class Exchange
{
public:
  /// `controller`: null for one process.
  explicit Exchange(vtkMultiProcessController* controller = nullptr, int partitionsOfRank = 1);

  int GetNumberOfPartitions() const { return this->NumberOfRanks * this->OfRank; }
  int GetNumberOfRanks() const { return this->NumberOfRanks; }
  int GetPartitionsOfRank() const { return this->OfRank; }
  /// The number of partition `i` of this rank among all.
  int GetPartition(int i) const { return this->Rank * this->OfRank + i; }

  /// Messages by the number of the partition that they go to, or come from.
  using Bytes = std::vector<char>;
  using Messages = std::map<int, Bytes>;
  /// Delivers messages: `out[i]` is what partition i of this rank sends. Empty messages need not
  /// arrive.
  std::vector<Messages> Send(std::vector<Messages> out);

  /// The same for lists of plain values.
  template <typename T>
  using Lists = std::map<int, std::vector<T>>;
  template <typename T>
  std::vector<Lists<T>> SendLists(const std::vector<Lists<T>>& out);

  /// The values that all partitions give, in the order of partitions: `own[i]` is that of partition
  /// i of this rank.
  std::vector<vtkIdType> Gather(const std::vector<vtkIdType>& own);
  vtkIdType Max(vtkIdType own);
  /// Whether all ranks say yes.
  bool Agree(bool own) { return this->Max(own ? 0 : 1) == 0; }

  /// What this rank sent to other partitions so far.
  vtkIdType GetNumberOfMessages() const { return this->NumberOfMessages; }
  vtkIdType GetNumberOfBytes() const { return this->NumberOfBytes; }

private:
  std::vector<Messages> SendToRanks(std::vector<Messages> out);

  vtkMultiProcessController* Controller;
  int NumberOfRanks = 1;
  int Rank = 0;
  int OfRank;
  vtkIdType NumberOfMessages = 0;
  vtkIdType NumberOfBytes = 0;
};

template <typename T>
std::vector<Exchange::Lists<T>> Exchange::SendLists(const std::vector<Lists<T>>& out)
{
  std::vector<Messages> bytes(out.size());
  for (size_t i = 0; i < out.size(); ++i)
  {
    for (const auto& [to, list] : out[i])
    {
      Bytes& message = bytes[i][to];
      message.resize(list.size() * sizeof(T));
      if (!list.empty())
      {
        std::memcpy(message.data(), list.data(), message.size());
      }
    }
  }
  std::vector<Lists<T>> in(out.size());
  const std::vector<Messages> arrived = this->Send(std::move(bytes));
  for (size_t i = 0; i < in.size(); ++i)
  {
    for (const auto& [from, message] : arrived[i])
    {
      std::vector<T>& list = in[i][from];
      list.resize(message.size() / sizeof(T));
      if (!list.empty())
      {
        std::memcpy(static_cast<void*>(list.data()), message.data(), message.size());
      }
    }
  }
  return in;
}

}

#endif
