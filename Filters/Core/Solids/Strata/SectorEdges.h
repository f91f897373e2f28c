// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SectorEdges.h
 * Edges of surfaces that end on a curve or at a corner, where their rule depends on the *sector*.
 * It depends on the number of triangles between the two edges that bound the surface there, and at
 * a corner on the angle (Mathematics 12).
 *
 * BuildStrata finds them on the control mesh, if StrataOptions::ModifiedBoundary is set. A step
 * makes no new ones: the half of such an edge at the curve or corner takes its place. Vertices that
 * a step makes on curves have three triangles on each side, where both rules are the same.
 */
#ifndef SubdivisionObjects_SectorEdges_h
#define SubdivisionObjects_SectorEdges_h

#include "Core/Memory/Buffer.h"
#include "Core/Rules/SectorMasks.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// One end of an edge whose rule is not the plain one. Lists of them ascend by edge and end.
template <typename Id>
struct SectorEdge
{
  Id Edge = 0;
  int End = 0; ///< which end lies on the curve, or is the corner
  /// Whether the other end lies on a curve or is a corner, too: the rule is the mean of both.
  bool IsShared = false;
  /// How much more weight this end has than by the plain rule; the other end has as much less.
  double Shift = 0.;
  double Flatness = 0.; ///< s; 0: none, and the members below are not set
  /// The first and the last edge of the sector, their far ends, and the weights of these in the
  /// point towards which the new point moves; -1: not in this part of a mesh.
  Id Bounds[2] = { -1, -1 };
  Id Ends[2] = { -1, -1 };
  double Weights[2] = { 0., 0. };

  bool IsComplete() const
  {
    return this->Flatness == 0. || (this->Ends[0] >= 0 && this->Ends[1] >= 0);
  }
};

/// The records of one edge: none, or one for one or for each of its ends.
template <typename Id>
struct SectorEdgeRange
{
  const SectorEdge<Id>* First = nullptr;
  const SectorEdge<Id>* Last = nullptr;

  const SectorEdge<Id>* begin() const { return this->First; }
  const SectorEdge<Id>* end() const { return this->Last; }
  bool IsEmpty() const { return this->First == this->Last; }
};

template <typename Id>
SectorEdgeRange<Id> FindSectorEdges(const std::vector<SectorEdge<Id>>& sectors, Id edge)
{
  if (sectors.empty())
  {
    return {};
  }
  const auto first = std::lower_bound(sectors.begin(), sectors.end(), edge,
    [](const SectorEdge<Id>& sector, Id wanted) { return sector.Edge < wanted; });
  auto last = first;
  while (last != sectors.end() && last->Edge == edge)
  {
    ++last;
  }
  return { sectors.data() + (first - sectors.begin()), sectors.data() + (last - sectors.begin()) };
}

template <typename Id>
bool AreComplete(const SectorEdgeRange<Id>& sectors)
{
  return std::all_of(sectors.begin(), sectors.end(),
    [](const SectorEdge<Id>& sector) { return sector.IsComplete(); });
}

/// The weights of the new point of an edge.
struct SectorMask
{
  double Ends[2] = { PlainEndWeight, PlainEndWeight };
  double Ring = 1. / 8.; ///< of the two opposite vertices
  /// Of the far ends of the bounds of the sector at each end; 0 without flatness.
  double Bounds[2][2] = { { 0., 0. }, { 0., 0. } };
};

template <typename Id>
SectorMask GetSectorMask(const SectorEdgeRange<Id>& sectors)
{
  SectorMask mask;
  int flat = 0;
  for (const SectorEdge<Id>& sector : sectors)
  {
    const double shift = sector.IsShared ? sector.Shift / 2. : sector.Shift;
    mask.Ends[sector.End] += shift;
    mask.Ends[1 - sector.End] -= shift;
    flat += sector.Flatness > 0. ? 1 : 0;
  }
  double kept = 1.; // weight of the point before flatness moves it
  for (const SectorEdge<Id>& sector : sectors)
  {
    kept -= sector.Flatness / std::max(1, flat);
  }
  mask.Ends[0] *= kept;
  mask.Ends[1] *= kept;
  mask.Ring *= kept;
  for (const SectorEdge<Id>& sector : sectors)
  {
    if (sector.Flatness > 0.)
    {
      const double part = sector.Flatness / flat;
      mask.Ends[sector.End] += part * (1. - sector.Weights[0] - sector.Weights[1]);
      mask.Bounds[sector.End][0] = part * sector.Weights[0];
      mask.Bounds[sector.End][1] = part * sector.Weights[1];
    }
  }
  return mask;
}

/// The same list after one step. `ends`: of the edges before; `vertices`: how many there were. The
/// halves of edge e are 2e and 2e + 1, its midpoint is vertex `vertices` + e.
template <typename Id>
std::vector<SectorEdge<Id>> RefineSectorEdges(
  const std::vector<SectorEdge<Id>>& sectors, const Buffer<Id>& ends, Id vertices)
{
  std::vector<SectorEdge<Id>> refined = sectors;
  for (SectorEdge<Id>& sector : refined)
  {
    const Id vertex = ends[2 * vtkIdType(sector.Edge) + sector.End];
    sector.Edge = 2 * sector.Edge + sector.End;
    sector.IsShared = false;
    for (int i = 0; i < 2; ++i)
    {
      const Id bound = sector.Bounds[i];
      if (bound >= 0)
      {
        sector.Bounds[i] = 2 * bound + (ends[2 * vtkIdType(bound)] == vertex ? 0 : 1);
        sector.Ends[i] = vertices + bound;
      }
    }
  }
  return refined;
}

/// The list of a part of a mesh: `edge` and `vertex` give the numbers in the part, or -1.
template <typename Id, typename NewEdge, typename NewVertex>
std::vector<SectorEdge<Id>> CutSectorEdges(
  const std::vector<SectorEdge<Id>>& sectors, const NewEdge& edge, const NewVertex& vertex)
{
  std::vector<SectorEdge<Id>> part;
  for (SectorEdge<Id> sector : sectors)
  {
    sector.Edge = edge(sector.Edge);
    for (int i = 0; i < 2; ++i)
    {
      sector.Bounds[i] = sector.Bounds[i] < 0 ? Id(-1) : edge(sector.Bounds[i]);
      sector.Ends[i] = sector.Ends[i] < 0 ? Id(-1) : vertex(sector.Ends[i]);
    }
    if (sector.Edge >= 0)
    {
      part.push_back(sector);
    }
  }
  return part;
}

}

#endif
