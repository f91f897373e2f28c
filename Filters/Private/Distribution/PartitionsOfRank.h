// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartitionsOfRank.h
 * Delivers messages between the partitions of all ranks.
 */
#ifndef SubdivisionObjects_PartitionsOfRank_h
#define SubdivisionObjects_PartitionsOfRank_h

#include "Private/Partitions/OtherPartitions.h"

#include "vtkSmartPointer.h"

#include <condition_variable>
#include <functional>
#include <mutex>

class vtkIntArray;
class vtkMultiProcessController;

namespace subdivision
{

struct JoinedMesh;

/**
 * Every rank has the same number of partitions: one in a filter; tests and benchmarks simulate more
 * in one process, each in a thread of its own. These take turns: one goes on until it waits for the
 * others in an exchange.
 */
class PartitionsOfRank
{
public:
  /// `controller`: null for one process.
  explicit PartitionsOfRank(vtkMultiProcessController* controller = nullptr, int size = 1);

  int GetNumberOfPartitions() const { return this->NumberOfRanks * this->Size; }
  /// The number of partition `i` of this rank among all.
  int GetPartition(int i) const { return this->Rank * this->Size + i; }
  /// Calls work(0) to work(size - 1), and begin(i) before each turn of work(i).
  void Run(const std::function<void(int)>& work, const std::function<void(int)>& begin);

  /// The work of partition i of this rank; the others do the same.
  std::vector<vtkIdType> Gather(int i, vtkIdType value);
  void Deliver(int i, Exchange::Messages& messages);

  /// The bytes that this rank sent to other partitions so far.
  vtkIdType GetNumberOfMessages() const { return this->NumberOfMessages; }
  vtkIdType GetNumberOfBytes() const { return this->NumberOfBytes; }

private:
  using Mails = std::vector<Exchange::Messages>; ///< of each partition of this rank

  void Meet(int i, const std::function<void()>& act);
  void CountSent();
  void SendToRanks();

  vtkMultiProcessController* Controller;
  int NumberOfRanks = 1;
  int Rank = 0;
  int Size;
  vtkIdType NumberOfMessages = 0;
  vtkIdType NumberOfBytes = 0;

  std::mutex Turn;
  std::condition_variable HaveMet;
  std::function<void(int)> Begin;
  int Arrived = 0;
  long long NumberOfMeetings = 0;
  std::vector<vtkIdType> Own;
  std::vector<vtkIdType> All;
  Mails Sent;
  Mails Received;
};

/// The exchange of partition i of this rank where all partitions go on to the end.
class ExchangeOfAll : public Exchange
{
public:
  explicit ExchangeOfAll(PartitionsOfRank& of, int i = 0)
    : Of(of)
    , Index(i)
  {
  }
  int GetPartition() const override { return this->Of.GetPartition(this->Index); }
  int GetNumberOfPartitions() const override { return this->Of.GetNumberOfPartitions(); }
  bool Send(Messages& messages) override
  {
    this->Of.Deliver(this->Index, messages);
    return true;
  }
  std::vector<vtkIdType> Gather(vtkIdType own) override
  {
    return this->Of.Gather(this->Index, own);
  }

private:
  PartitionsOfRank& Of;
  int Index;
};

/**
 * The exchange of partition i of this rank while it works. Before each exchange all partitions
 * announce their next step. So one that has stopped, and one that has no mesh, which answers until
 * the others are done, are known to all.
 */
class ExchangeOfWork : public OtherPartitions
{
public:
  ExchangeOfWork(PartitionsOfRank& of, int i)
    : All(of, i)
  {
  }
  /// `copies`: of each other partition, which cells of each part it has, from SentLayers.
  void Start(const JoinedMesh& joined, const std::map<int, std::vector<std::vector<char>>>& copies);
  bool HasStarted() const { return this->Joined != nullptr; }
  /// Ends the work, which is done or not. Returns whether all are done. Not after PartitionStopped.
  bool End(bool done);
  /// Answers for a partition without a mesh until the others end. Returns whether these are done.
  bool Answer();

  int GetPartition() const override { return this->All.GetPartition(); }
  int GetNumberOfPartitions() const override { return this->All.GetNumberOfPartitions(); }
  bool Send(Messages& messages) override;
  std::vector<vtkIdType> Gather(vtkIdType own) override;
  const std::vector<vtkIdType>& GetPointIds() const override;
  const std::vector<vtkIdType>& GetCellIds() const override;
  bool IsOwn(vtkIdType cell) const override;
  const std::vector<int>& GetNeighbours(vtkIdType cell) const override
  {
    return this->Neighbours[cell];
  }

private:
  ExchangeOfAll All;
  const JoinedMesh* Joined = nullptr;
  vtkSmartPointer<vtkIntArray> Blocks;
  std::vector<std::vector<int>> Neighbours; ///< of each cell
};

}

#endif
