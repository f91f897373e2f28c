// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Meeting.h
 * Lets the partitions of a mesh meet while work on them is done.
 */
#ifndef SubdivisionObjects_Meeting_h
#define SubdivisionObjects_Meeting_h

#include "Private/Distribution/Exchange.h"
#include "Private/Distribution/JoinedMesh.h"
#include "Private/Distribution/Layers.h"
#include "Private/Partitions/Partners.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

namespace subdivision
{

/**
 * The partitions of this rank: the work on each has a thread of its own. In a filter there is one,
 * and no further thread.
 *
 * Before each exchange all partitions tell what they are about to do. So one that has stopped, and
 * one that has no mesh, which answers until the others are done, are known to all.
 */
class Meeting
{
public:
  explicit Meeting(Exchange& exchange);

  /// What the work on partition i of this rank gets; `copies`: as AddLayers returns them.
  std::unique_ptr<Partners> MakePartners(int i, const JoinedMesh& joined, const Copies& copies);

  /// Ends the work on a partition, which is done or not. Returns whether all are done. Not after
  /// PartnersStopped.
  bool End(int i, bool done);
  /// Answers for a partition without a mesh until the others end. Returns whether these are done.
  bool Answer(int i);

private:
  friend class PartnersOfMesh;

  bool Send(int i, Partners::Messages& messages);
  std::vector<vtkIdType> GatherValues(int i, vtkIdType own);
  std::vector<vtkIdType> Gather(int i, vtkIdType value);
  void Deliver(int i, Partners::Messages& messages);
  void Meet(const std::function<void()>& bring, const std::function<void()>& act,
    const std::function<void()>& take);

  Exchange& Messenger;
  std::mutex Mutex;
  std::condition_variable HasMet;
  int Arrived = 0;
  long long Meetings = 0;
  std::vector<vtkIdType> Own;
  std::vector<vtkIdType> All;
  std::vector<Exchange::Messages> Mail; ///< of each partition, out and then in
};

}

#endif
