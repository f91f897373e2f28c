// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DualLimits.h
 * The common parts of the limits of dual schemes (Mathematics 12). The place of a vertex on the
 * limit surface is the limit at the face that the next step makes around it, or on a boundary the
 * limit at the side which the next step makes there.
 */
#ifndef SubdivisionObjects_DualLimits_h
#define SubdivisionObjects_DualLimits_h

#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Dual/DualPlaces.h"

#include <cmath>
#include <vector>

namespace subdivision
{

/// The first fan of a vertex, in the order in which its vertex face has its corners.
template <typename Id>
struct DualFan
{
  std::vector<FanStep<Id>> Steps;
  std::vector<Id> Ends; ///< other ends of the edges that the walk crosses, and in a chain of its
                        ///< first and last edge
  bool IsCycle = false;

  vtkIdType GetSize() const { return static_cast<vtkIdType>(this->Steps.size()); }

  /// Finds the fan of a vertex. False: it has no faces.
  bool Find(const PolygonMesh<Id>& mesh, Id vertex)
  {
    this->Steps.clear();
    this->Ends.clear();
    const Id corner = GetFirstFan(mesh, vertex);
    if (corner < 0)
    {
      return false;
    }
    const auto add = [&](Id halfEdge)
    {
      const Id from = mesh.Vertices[halfEdge];
      this->Ends.push_back(from == vertex ? mesh.Vertices[mesh.Next(halfEdge)] : from);
    };
    this->IsCycle = FindFanForward(mesh, corner, this->Steps);
    for (const FanStep<Id>& step : this->Steps)
    {
      add(step.GetHalfEdgeIn(mesh));
    }
    if (!this->IsCycle)
    {
      add(this->Steps.back().GetHalfEdgeOut(mesh));
    }
    return true;
  }
};

/// The weight of the j-th of n corners of a face in its limit: the mean, or a tangent.
inline double GetDualWeight(LimitKind kind, std::size_t j, std::size_t n)
{
  const double size = static_cast<double>(n);
  const double angle = 2. * Pi * static_cast<double>(j) / size;
  return kind == LimitKind::Position ? 1. / size
    : kind == LimitKind::Tangent1    ? std::cos(angle)
                                     : std::sin(angle);
}

/// Appends the limit position of a boundary vertex, where two steps are one of Chaikin's scheme or
/// one step is, or the tangent along the boundary. `own`: the vertex's weight.
template <typename Id>
void AppendDualBoundary(
  const DualFan<Id>& fan, Id vertex, LimitKind kind, double own, RowBlock<Id>& rows)
{
  const bool isPosition = kind == LimitKind::Position;
  if (isPosition)
  {
    rows.Add(vertex, own);
  }
  rows.Add(fan.Ends.front(), isPosition ? (1. - own) / 2. : 1.);
  rows.Add(fan.Ends.back(), isPosition ? (1. - own) / 2. : -1.);
}

}

#endif
