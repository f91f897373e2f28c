// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/PartitionsOfRank.h"

#include "Private/Distribution/JoinedMesh.h"

#include "vtkCellData.h"
#include "vtkDIYUtilities.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <thread>
#include <utility>

// clang-format off
#include "vtk_diy2.h" // renames the namespace diy, so it comes first
#include VTK_DIY2(diy/assigner.hpp)
#include VTK_DIY2(diy/master.hpp)
// clang-format on

namespace subdivision
{
namespace
{

/// The state of a rank in DIY: the messages to and from its partitions, with their addresses.
struct Envelope
{
  int To;
  int From;
  std::vector<char> Message;
};

struct Mailbox
{
  std::vector<Envelope> Out;
  std::vector<Envelope> In;
};

// The announcement of a partition before an exchange of its work: one of these plus a multiple of
// Next; below zero it has stopped.
constexpr vtkIdType Ends = 0;    ///< its work is done
constexpr vtkIdType Answers = 1; ///< it has no mesh
constexpr vtkIdType Sends = 2;   ///< plus Next if it has messages
constexpr vtkIdType Gathers = 3; ///< plus Next times its value
constexpr vtkIdType Next = 4;
constexpr vtkIdType Stopped = -1;

/// Whether all partitions with a mesh do the same.
bool DoAll(const std::vector<vtkIdType>& all, vtkIdType what)
{
  return std::all_of(all.begin(), all.end(),
    [what](vtkIdType value) { return value >= 0 && (value % Next == what || value == Answers); });
}

/// Throws where some do something else, because they have stopped.
void ExpectAll(const std::vector<vtkIdType>& all, vtkIdType what)
{
  if (!DoAll(all, what))
  {
    throw PartitionStopped();
  }
}

bool HaveMessages(const std::vector<vtkIdType>& all)
{
  return std::any_of(all.begin(), all.end(), [](vtkIdType value) { return value >= Next; });
}

}

PartitionsOfRank::PartitionsOfRank(vtkMultiProcessController* controller, int size)
  : Controller(controller)
  , Size(size)
  , Own(static_cast<std::size_t>(size), 0)
  , Sent(static_cast<std::size_t>(size))
  , Received(static_cast<std::size_t>(size))
{
  if (controller)
  {
    this->NumberOfRanks = controller->GetNumberOfProcesses();
    this->Rank = controller->GetLocalProcessId();
  }
}

void PartitionsOfRank::Run(
  const std::function<void(int)>& work, const std::function<void(int)>& begin)
{
  this->Begin = begin;
  const auto takeTurn = [&](int i)
  {
    const std::lock_guard<std::mutex> lock(this->Turn);
    this->Begin(i);
    work(i);
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < this->Size; ++i)
  {
    threads.emplace_back(takeTurn, i);
  }
  takeTurn(0);
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  this->Begin = nullptr;
}

/// The partition that comes last acts for all. The turn of the others ends until then.
void PartitionsOfRank::Meet(int i, const std::function<void()>& act)
{
  if (++this->Arrived == this->Size)
  {
    this->Arrived = 0;
    act();
    ++this->NumberOfMeetings;
    this->HaveMet.notify_all();
    return;
  }
  std::unique_lock<std::mutex> lock(this->Turn, std::adopt_lock);
  const long long before = this->NumberOfMeetings;
  this->HaveMet.wait(lock, [&] { return this->NumberOfMeetings != before; });
  lock.release();
  this->Begin(i);
}

std::vector<vtkIdType> PartitionsOfRank::Gather(int i, vtkIdType value)
{
  this->Own[i] = value;
  this->Meet(i,
    [this]
    {
      this->All = this->Own;
      if (this->NumberOfRanks > 1)
      {
        this->All.resize(this->GetNumberOfPartitions());
        this->Controller->AllGather(this->Own.data(), this->All.data(), this->Size);
      }
    });
  return this->All;
}

void PartitionsOfRank::Deliver(int i, Exchange::Messages& messages)
{
  this->Sent[i] = std::move(messages);
  this->Meet(i,
    [this]
    {
      this->CountSent();
      this->SendToRanks();
    });
  messages = std::move(this->Received[i]);
  this->Received[i].clear();
}

void PartitionsOfRank::CountSent()
{
  for (int i = 0; i < this->Size; ++i)
  {
    for (const auto& [to, message] : this->Sent[i])
    {
      if (to != this->GetPartition(i) && !message.empty())
      {
        ++this->NumberOfMessages;
        this->NumberOfBytes += static_cast<vtkIdType>(message.size());
      }
    }
  }
}

void PartitionsOfRank::SendToRanks()
{
  Mailbox box;
  for (int i = 0; i < this->Size; ++i)
  {
    for (auto& [to, message] : this->Sent[i])
    {
      box.Out.push_back({ to, this->GetPartition(i), std::move(message) });
    }
    this->Sent[i].clear();
  }
  if (this->NumberOfRanks == 1)
  {
    box.In = std::move(box.Out);
  }
  else
  {
    diy::mpi::communicator communicator = vtkDIYUtilities::GetCommunicator(this->Controller);
    diy::Master master(communicator, 1);
    master.add(this->Rank, &box, new diy::Link);
    master.foreach (
      [this](Mailbox* mail, const diy::Master::ProxyWithLink& proxy)
      {
        for (const Envelope& envelope : mail->Out)
        {
          const int rank = envelope.To / this->Size;
          const diy::BlockID target = { rank, rank };
          proxy.enqueue(target, envelope.To);
          proxy.enqueue(target, envelope.From);
          proxy.enqueue(target, envelope.Message);
        }
        mail->Out.clear();
      });
    master.exchange(/*remote=*/true);
    master.foreach (
      [](Mailbox* mail, const diy::Master::ProxyWithLink& proxy)
      {
        std::vector<int> senders;
        proxy.incoming(senders);
        for (const int sender : senders)
        {
          while (proxy.incoming(sender))
          {
            Envelope envelope;
            proxy.dequeue(sender, envelope.To);
            proxy.dequeue(sender, envelope.From);
            proxy.dequeue(sender, envelope.Message);
            mail->In.push_back(std::move(envelope));
          }
        }
      });
  }
  for (Envelope& envelope : box.In)
  {
    this->Received[envelope.To - this->GetPartition(0)][envelope.From] =
      std::move(envelope.Message);
  }
}

// ------------------------------------------------------------------------------------------------

void ExchangeOfWork::Start(
  const JoinedMesh& joined, const std::map<int, std::vector<std::vector<char>>>& copies)
{
  this->Joined = &joined;
  this->Blocks = vtkIntArray::SafeDownCast(joined.Mesh->GetCellData()->GetArray(BlockName));
  this->Neighbours.resize(joined.CellIds.size());
  for (const auto& [partition, parts] : copies)
  {
    for (std::size_t part = 0; part < parts.size(); ++part)
    {
      for (std::size_t cell = 0; cell < parts[part].size(); ++cell)
      {
        const vtkIdType place = parts[part][cell] ? joined.CellPlaces[part][cell] : -1;
        if (place >= 0)
        {
          this->Neighbours[place].push_back(partition);
        }
      }
    }
  }
}

const std::vector<vtkIdType>& ExchangeOfWork::GetPointIds() const
{
  return this->Joined->PointIds;
}

const std::vector<vtkIdType>& ExchangeOfWork::GetCellIds() const
{
  return this->Joined->CellIds;
}

bool ExchangeOfWork::IsOwn(vtkIdType cell) const
{
  return this->Blocks->GetValue(cell) != NoBlock;
}

bool ExchangeOfWork::Send(Messages& messages)
{
  const std::vector<vtkIdType> all = this->All.Gather(messages.empty() ? Sends : Sends + Next);
  ExpectAll(all, Sends);
  if (!HaveMessages(all))
  {
    return false;
  }
  return this->All.Send(messages);
}

std::vector<vtkIdType> ExchangeOfWork::Gather(vtkIdType own)
{
  std::vector<vtkIdType> all = this->All.Gather(Gathers + Next * own);
  ExpectAll(all, Gathers);
  for (vtkIdType& value : all)
  {
    value = value == Answers ? -1 : value / Next;
  }
  return all;
}

bool ExchangeOfWork::End(bool done)
{
  return DoAll(this->All.Gather(done ? Ends : Stopped), Ends);
}

bool ExchangeOfWork::Answer()
{
  for (;;)
  {
    const std::vector<vtkIdType> all = this->All.Gather(Answers);
    if (DoAll(all, Ends))
    {
      return true;
    }
    if (DoAll(all, Sends) && HaveMessages(all))
    {
      Messages none;
      this->All.Send(none);
    }
    else if (!DoAll(all, Sends) && !DoAll(all, Gathers))
    {
      return false;
    }
  }
}

}
