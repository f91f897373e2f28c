// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Meeting.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <utility>

namespace subdivision
{
namespace
{

// What a partition tells before an exchange: one of these plus a multiple of Next; below zero it
// has stopped.
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
    throw PartnersStopped();
  }
}

bool HaveMessages(const std::vector<vtkIdType>& all)
{
  return std::any_of(all.begin(), all.end(), [](vtkIdType value) { return value >= Next; });
}

}

class PartnersOfMesh : public Partners
{
public:
  PartnersOfMesh(Meeting& meeting, int i, const JoinedMesh& joined)
    : With(meeting)
    , Index(i)
    , Joined(joined)
    , Blocks(vtkIntArray::SafeDownCast(joined.Mesh->GetCellData()->GetArray(BlockName)))
    , Neighbours(joined.CellIds.size())
  {
  }
  void AddNeighbour(vtkIdType cell, int partition) { this->Neighbours[cell].push_back(partition); }

  int GetPartition() const override { return this->With.Messenger.GetPartition(this->Index); }
  int GetNumberOfPartitions() const override
  {
    return this->With.Messenger.GetNumberOfPartitions();
  }
  const std::vector<vtkIdType>& GetPointIds() const override { return this->Joined.PointIds; }
  const std::vector<vtkIdType>& GetCellIds() const override { return this->Joined.CellIds; }
  bool IsOwn(vtkIdType cell) const override { return this->Blocks->GetValue(cell) != NoBlock; }
  const std::vector<int>& GetNeighbours(vtkIdType cell) const override
  {
    return this->Neighbours[cell];
  }
  bool Send(Messages& messages) override { return this->With.Send(this->Index, messages); }
  std::vector<vtkIdType> Gather(vtkIdType own) override
  {
    return this->With.GatherValues(this->Index, own);
  }

private:
  Meeting& With;
  int Index;
  const JoinedMesh& Joined;
  vtkSmartPointer<vtkIntArray> Blocks;
  std::vector<std::vector<int>> Neighbours; ///< of each cell
};

Meeting::Meeting(Exchange& exchange)
  : Messenger(exchange)
  , Own(static_cast<size_t>(exchange.GetPartitionsOfRank()), 0)
  , Mail(static_cast<size_t>(exchange.GetPartitionsOfRank()))
{
}

std::unique_ptr<Partners> Meeting::MakePartners(
  int i, const JoinedMesh& joined, const Copies& copies)
{
  auto partners = std::make_unique<PartnersOfMesh>(*this, i, joined);
  for (const auto& [partition, parts] : copies)
  {
    for (size_t part = 0; part < parts.size(); ++part)
    {
      for (size_t cell = 0; cell < parts[part].size(); ++cell)
      {
        const vtkIdType place = parts[part][cell] ? joined.CellPlaces[part][cell] : -1;
        if (place >= 0)
        {
          partners->AddNeighbour(place, partition);
        }
      }
    }
  }
  return partners;
}

/// All partitions of this rank bring something, the last one acts, then all take what is theirs.
void Meeting::Meet(const std::function<void()>& bring, const std::function<void()>& act,
  const std::function<void()>& take)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  bring();
  if (++this->Arrived == this->Messenger.GetPartitionsOfRank())
  {
    this->Arrived = 0;
    act();
    ++this->Meetings;
    this->HasMet.notify_all();
  }
  else
  {
    const long long before = this->Meetings;
    this->HasMet.wait(lock, [&] { return this->Meetings != before; });
  }
  take();
}

std::vector<vtkIdType> Meeting::Gather(int i, vtkIdType value)
{
  std::vector<vtkIdType> all;
  this->Meet([&] { this->Own[i] = value; }, [&] { this->All = this->Messenger.Gather(this->Own); },
    [&] { all = this->All; });
  return all;
}

void Meeting::Deliver(int i, Partners::Messages& messages)
{
  this->Meet([&] { this->Mail[i] = std::move(messages); },
    [&] { this->Mail = this->Messenger.Send(std::move(this->Mail)); },
    [&] { messages = std::move(this->Mail[i]); });
}

bool Meeting::Send(int i, Partners::Messages& messages)
{
  const std::vector<vtkIdType> all = this->Gather(i, messages.empty() ? Sends : Sends + Next);
  ExpectAll(all, Sends);
  if (!HaveMessages(all))
  {
    return false;
  }
  this->Deliver(i, messages);
  return true;
}

std::vector<vtkIdType> Meeting::GatherValues(int i, vtkIdType own)
{
  std::vector<vtkIdType> all = this->Gather(i, Gathers + Next * own);
  ExpectAll(all, Gathers);
  for (vtkIdType& value : all)
  {
    value = value == Answers ? -1 : value / Next;
  }
  return all;
}

bool Meeting::End(int i, bool done)
{
  return DoAll(this->Gather(i, done ? Ends : Stopped), Ends);
}

bool Meeting::Answer(int i)
{
  for (;;)
  {
    const std::vector<vtkIdType> all = this->Gather(i, Answers);
    if (DoAll(all, Ends))
    {
      return true;
    }
    if (DoAll(all, Sends) && HaveMessages(all))
    {
      Partners::Messages none;
      this->Deliver(i, none);
    }
    else if (!DoAll(all, Sends) && !DoAll(all, Gathers))
    {
      return false;
    }
  }
}

}
