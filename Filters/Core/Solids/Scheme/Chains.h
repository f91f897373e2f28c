// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Chains.h
 * Several steps at once from a level that has nothing but vertices and edges. The levels between
 * are never made: each edge becomes a chain of edges, and all numbers follow by arithmetic.
 */
#ifndef SubdivisionObjects_Chains_h
#define SubdivisionObjects_Chains_h

#include "Core/Operators/ChainOperator.h"
#include "Core/Solids/Scheme/Level.h"
#include "Core/Solids/Scheme/Stencils.h"

namespace subdivision
{

/// With more steps the chains of few edges are larger than a core's own cache.
constexpr int MostStepsOfChains = 5;

/// Whether few enough edges meet at vertices. Each chain takes the stars of both of its ends along,
/// so that all edges at one vertex would take the square of their number.
template <typename LevelType>
bool HasSmallStars(const LevelType& level)
{
  constexpr vtkIdType most = 32; // for each edge; 4 where nothing branches
  vtkIdType members = 0;
  for (const auto vertex : InTurn(level.Complex.NumberOfVertices))
  {
    const auto size = static_cast<vtkIdType>(level.Strata.VertexRings.GetSize(vertex));
    members += size * size;
  }
  return members <= most * static_cast<vtkIdType>(level.Complex.NumberOfEdges);
}

/// The numbers of the points inside the chains. A place in a chain is a number from 1 on.
class ChainPoints
{
public:
  ChainPoints(vtkIdType vertices, vtkIdType edges, int steps)
    : NumberOfVertices(vertices)
    , NumberOfEdges(edges)
    , Steps(steps)
  {
  }
  vtkIdType GetNumberOfPoints() const { return this->GetFirst(this->Steps); }
  /// The number of a point is GetFirst(place) + GetFactor(place) * edge.
  vtkIdType GetFactor(vtkIdType place) const { return vtkIdType(1) << this->GetStep(place); }
  vtkIdType GetFirstAt(vtkIdType place) const
  {
    const int step = this->GetStep(place);
    return this->GetFirst(step) + (place >> (this->Steps - step));
  }
  /// The vertex whose values a point takes in arrays that are not smoothed, as it would step by
  /// step: each new point takes those of the earlier one of its neighbours, `earliest(edge)` tells
  /// which end of an edge that is. `ends`: two for each edge.
  template <typename Id, typename Earliest>
  vtkIdType FindOrigin(vtkIdType point, const Id* ends, const Earliest& earliest) const
  {
    if (point < this->NumberOfVertices)
    {
      return point;
    }
    int step = 0;
    while (point >= this->GetFirst(step + 1))
    {
      ++step;
    }
    const vtkIdType number = point - this->GetFirst(step);
    const vtkIdType edge = number >> step;
    vtkIdType place = 2 * (number - (edge << step)) + 1; // after this step
    while (step > 0)
    {
      place += place % 4 == 1 ? -1 : 1; // the neighbour that an earlier step made
      if (place == 0 || place == vtkIdType(2) << step)
      {
        return ends[2 * edge + (place == 0 ? 0 : 1)];
      }
      for (; place % 2 == 0; place /= 2)
      {
        --step;
      }
    }
    return earliest(edge);
  }

private:
  /// The first point that a step makes, the first of which is step 0.
  vtkIdType GetFirst(int step) const
  {
    return this->NumberOfVertices + ((vtkIdType(1) << step) - 1) * this->NumberOfEdges;
  }
  /// The step that makes a point.
  int GetStep(vtkIdType place) const
  {
    int step = this->Steps - 1;
    for (; place % 2 == 0; place /= 2)
    {
      --step;
    }
    return step;
  }

  vtkIdType NumberOfVertices;
  vtkIdType NumberOfEdges;
  int Steps;
};

/// The operator of some steps from a level. The level is the control level or was made with
/// Depth::ForRefinement, has no faces, and its scheme has masks of one section.
template <typename Id>
class Chains : public ChainOperator
{
public:
  template <typename Level>
  Chains(const Level& level, int steps)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , Masks(*GetSolidRows(level).Masks)
    , Steps(steps)
    , Points(level.Complex.NumberOfVertices, level.Complex.NumberOfEdges, steps)
  {
  }
  vtkIdType GetNumberOfColumns() const override { return this->Complex.NumberOfVertices; }
  vtkIdType GetNumberOfRows() const override { return this->Points.GetNumberOfPoints(); }
  void ForEachChains(const ChainUser& use) const override;

  /// The vertex whose values a row takes in arrays that are not smoothed. isEarlier(a, b): whether
  /// vertex a comes before vertex b.
  template <typename IsEarlier>
  vtkIdType FindOrigin(vtkIdType row, const IsEarlier& isEarlier) const
  {
    const Id* ends = this->Complex.EdgeVertices.data();
    return this->Points.FindOrigin(row, ends, [&](vtkIdType edge)
      { return *std::min_element(ends + 2 * edge, ends + 2 * edge + 2, isEarlier); });
  }

  /// The strata of all vertices after the steps.
  Buffer<Stratum> GetStrata() const;

private:
  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const RingMasks& Masks;
  const int Steps;
  const ChainPoints Points;
};

}

#endif
