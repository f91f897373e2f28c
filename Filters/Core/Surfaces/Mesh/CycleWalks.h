// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CycleWalks.h
 * Walks around several vertices that take turns. Each step of a walk waits for memory that the step
 * before has named; steps of different walks wait together.
 */
#ifndef SubdivisionObjects_CycleWalks_h
#define SubdivisionObjects_CycleWalks_h

#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
class CycleWalks
{
public:
  /// How many walks take turns.
  static constexpr int Most = 8;

  using Steps = std::vector<FanStep<Id>>;

  CycleWalks()
  {
    for (Steps& steps : this->Cycles)
    {
      steps.reserve(8); // most vertices have no more
    }
  }

  /// Walks around up to Most vertices from `first` on: around those that wanted(vertex) takes, each
  /// of which must have one fan. Walks go forward from its corner, also in a chain.
  template <typename Wanted>
  void Walk(const PolygonMesh<Id>& mesh, Id first, Id end, const Wanted& wanted)
  {
    this->First = first;
    std::array<int, Most> walking{};
    int count = 0;
    for (Id vertex = first; vertex < end; ++vertex)
    {
      Steps& steps = this->Cycles[vertex - first];
      steps.clear();
      if (wanted(vertex))
      {
        steps.push_back({ mesh.VertexCorners[vertex], true });
        walking[count++] = vertex - first;
      }
    }
    while (count > 0)
    {
      int left = 0;
      for (int i = 0; i < count; ++i)
      {
        Steps& steps = this->Cycles[walking[i]];
        FanStep<Id> step = steps.back();
        const bool goesOn = step.Advance(mesh);
        this->AreCycles[walking[i]] = goesOn;
        if (goesOn && step.Corner != steps.front().Corner)
        {
          steps.push_back(step);
          walking[left++] = walking[i];
        }
      }
      count = left;
    }
  }

  /// The steps of VisitCycle around a vertex; empty if it was not wanted.
  const Steps& Get(Id vertex) const { return this->Cycles[vertex - this->First]; }
  /// Whether the fan of a vertex that was wanted is a cycle. If not, the steps are not all there.
  bool IsCycle(Id vertex) const { return this->AreCycles[vertex - this->First]; }

private:
  std::array<Steps, Most> Cycles;
  std::array<bool, Most> AreCycles{};
  Id First = 0;
};

}

#endif
