// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Exchange.h"

#include "vtkDIYUtilities.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
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

/// What a rank has in DIY: the messages to and from its partitions, with their addresses.
struct Envelope
{
  int To;
  int From;
  Exchange::Bytes Message;
};

struct Mailbox
{
  std::vector<Envelope> Out;
  std::vector<Envelope> In;
};

}

Exchange::Exchange(vtkMultiProcessController* controller, int partitionsOfRank)
  : Controller(controller)
  , OfRank(partitionsOfRank)
{
  if (controller)
  {
    this->NumberOfRanks = controller->GetNumberOfProcesses();
    this->Rank = controller->GetLocalProcessId();
  }
}

std::vector<Exchange::Messages> Exchange::Send(std::vector<Messages> out)
{
  for (size_t i = 0; i < out.size(); ++i)
  {
    for (const auto& [to, message] : out[i])
    {
      if (to != this->GetPartition(static_cast<int>(i)) && !message.empty())
      {
        ++this->NumberOfMessages;
        this->NumberOfBytes += static_cast<vtkIdType>(message.size());
      }
    }
  }
  if (this->NumberOfRanks > 1)
  {
    return this->SendToRanks(std::move(out));
  }
  std::vector<Messages> in(out.size());
  for (size_t i = 0; i < out.size(); ++i)
  {
    for (auto& [to, message] : out[i])
    {
      in[to][static_cast<int>(i)] = std::move(message);
    }
  }
  return in;
}

std::vector<Exchange::Messages> Exchange::SendToRanks(std::vector<Messages> out)
{
  diy::mpi::communicator communicator = vtkDIYUtilities::GetCommunicator(this->Controller);
  diy::Master master(communicator, 1);
  Mailbox box;
  for (size_t i = 0; i < out.size(); ++i)
  {
    for (auto& [to, message] : out[i])
    {
      box.Out.push_back({ to, this->GetPartition(static_cast<int>(i)), std::move(message) });
    }
  }
  master.add(this->Rank, &box, new diy::Link);
  master.foreach (
    [this](Mailbox* mail, const diy::Master::ProxyWithLink& proxy)
    {
      for (const Envelope& envelope : mail->Out)
      {
        const int rank = envelope.To / this->OfRank;
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
  std::vector<Messages> in(out.size());
  for (Envelope& envelope : box.In)
  {
    in[envelope.To - this->GetPartition(0)][envelope.From] = std::move(envelope.Message);
  }
  return in;
}

std::vector<vtkIdType> Exchange::Gather(const std::vector<vtkIdType>& own)
{
  if (this->NumberOfRanks == 1)
  {
    return own;
  }
  std::vector<vtkIdType> all(this->GetNumberOfPartitions());
  this->Controller->AllGather(own.data(), all.data(), static_cast<vtkIdType>(own.size()));
  return all;
}

vtkIdType Exchange::Max(vtkIdType own)
{
  const std::vector<vtkIdType> all =
    this->Gather(std::vector<vtkIdType>(static_cast<size_t>(this->OfRank), own));
  return *std::max_element(all.begin(), all.end());
}

}
