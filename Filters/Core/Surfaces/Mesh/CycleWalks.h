// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CycleWalks.h
 * Walks around several vertices that take turns. Each step of a walk waits for memory that the step
 * before has named; steps of different walks wait together.
 */
#ifndef SubdivisionObjects_CycleWalks_h
#define SubdivisionObjects_CycleWalks_h

#include "Core/Surfaces/Mesh/PolygonMesh.h"

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

  /// Walks around up to Most vertices from `first` on: around vertices that wanted(vertex) takes,
  /// each of which must have one fan. Walks go forward from its corner, also in a chain.
  template <typename Wanted>
  void Walk(const PolygonMesh<Id>& mesh, Id first, Id end, const Wanted& wanted)
  {
    this->First = first;
    int walking[Most];
    int count = 0;
    for (Id vertex = first; vertex < end; ++vertex)
    {
      const int walk = static_cast<int>(vertex - first);
      this->Cycles[walk].clear();
      if (wanted(vertex))
      {
        this->Add(walk, { mesh.VertexCorners[vertex], true });
        walking[count++] = walk;
      }
    }
    while (count > 0)
    {
      int left = 0;
      for (int i = 0; i < count; ++i)
      {
        const int walk = walking[i];
        const FanStep<Id>* last = this->Cycles[walk].data() + this->Cycles[walk].size() - 1;
        FanStep<Id> step{ last->Corner, last->Forward };
        const bool goesOn = step.Advance(mesh);
        this->AreCycles[walk] = goesOn;
        if (goesOn && step.Corner != mesh.VertexCorners[first + walk])
        {
          this->Add(walk, step);
          walking[left++] = walk;
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
  /// Moves a step in parts, as Advance wrote it: a load of both would wait for these stores.
  void Add(int walk, const FanStep<Id>& step)
  {
    FanStep<Id>& next = this->Cycles[walk].emplace_back();
    next.Corner = step.Corner;
    next.Forward = step.Forward;
  }

  Steps Cycles[Most];
  bool AreCycles[Most] = {};
  Id First = 0;
};

}

#endif
