// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/RegularRings.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/ForBlocks.h"
#include "Core/Operators/TangentErrors.h"
#include "Core/Rules/Pi.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/RingFinder.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// The tangents of the vertices that come from flagged vertices, and from edges there. `vertices`
/// receives their numbers in the whole next level.
template <typename Level>
LimitTangents<typename Level::IdType> BuildAt(const Level& level, int steps,
  const Buffer<unsigned char>& at, Buffer<typename Level::IdType>& vertices)
{
  using Id = typename Level::IdType;
  const RefinedPart<Level> part(level, at);
  const Restriction<Level>& restriction = part.GetPart();
  vertices = Buffer<Id>(part.GetNext().Complex.NumberOfVertices);
  ForEach(vertices.size(), [&](vtkIdType v) { vertices[v] = part.GetWhole(v); });
  ShadingCells<Id> cells;
  for (const Id face : InTurn(restriction.GetOldFaces()))
  {
    const bool isCell = face < level.Complex.NumberOfTriangleCells;
    cells.Triangles.insert(
      cells.Triangles.end(), 4, isCell ? static_cast<Id>(face >> 2 * steps) : Id(-1));
  }
  for (const Id edge : InTurn(restriction.GetOldEdges()))
  {
    cells.Lines.insert(cells.Lines.end(), 2, edge < level.Complex.NumberOfLineCells ? 1 : 0);
  }
  for (const Id vertex : InTurn(level.Complex.VertexCells))
  {
    if (restriction.GetNewVertices()[vertex] >= 0)
    {
      cells.Points.push_back(restriction.GetNewVertices()[vertex]);
    }
  }
  return BuildLimitTangents(part.GetNext(), {}, {}, cells, steps + 1);
}

}

/// act(vertex, first tangent, second tangent, whether they are turned) in several threads.
template <typename Id>
template <typename Act>
void RegularRings<Id>::ForRegular(
  const Coordinates& points, const Buffer<unsigned char>& turned, const Act& act) const
{
  double weights[2][Size];
  for (int j = 0; j < Size; ++j)
  {
    const double angle = 2. * Pi * static_cast<double>(j) / Size;
    weights[0][j] = std::cos(angle);
    weights[1][j] = std::sin(angle);
  }
  ForBlocksInThreads(this->Sides.size(),
    [&](vtkIdType begin, vtkIdType end)
    {
      double tangents[2][3 * BlockSize];
      for (int k = 0; k < 2; ++k)
      {
        const EqualRows<Id> rows{ 0, end - begin, Size, this->Members.data() + Size * begin,
          weights[k] };
        SumRows(rows, points.Values, tangents[k], 3);
      }
      for (vtkIdType v = begin; v < end; ++v)
      {
        const Id side = this->Sides[v];
        if (side >= 0)
        {
          act(v, tangents[0] + 3 * (v - begin), tangents[1] + 3 * (v - begin),
            (side % 2 == 1) != (!turned.empty() && turned[side / 2] != 0), weights);
        }
      }
    });
}

template <typename Id>
void RegularRings<Id>::ComputeNormals(
  const Coordinates& points, const Buffer<unsigned char>& turned, double* normals) const
{
  const double largest = FindLargest(points.Values, 3 * this->Sides.size());
  this->ForRegular(points, turned,
    [&](vtkIdType v, const double* first, const double* second, bool isTurned,
      const double(&weights)[2][Size])
    {
      const auto getError = [&](const double* ofTangent, bool isBound)
      {
        return isBound ? GetTangentBound(ofTangent, Size, largest, points.GetUnit())
                       : GetTangentError(this->Members.data() + Size * v, ofTangent, Size,
                           points.Values, points.GetUnit());
      };
      FindSectorNormal(
        first, second,
        [&](bool isBound) { return getError(weights[0], isBound) + getError(weights[1], isBound); },
        isTurned, normals + 3 * v);
    });
}

template <typename Id>
void RegularRings<Id>::ComputeTangents(const Coordinates& points,
  const Buffer<unsigned char>& turned, double* first, double* second) const
{
  this->ForRegular(points, turned,
    [&](vtkIdType v, const double* a, const double* b, bool isTurned, const auto&)
    {
      for (int c = 0; c < 3; ++c)
      {
        first[3 * v + c] = a[c];
        second[3 * v + c] = isTurned ? -b[c] : b[c];
      }
    });
}

template <typename Level>
RegularRings<typename Level::IdType> FindRegularRings(const Level& level, int steps,
  LimitTangents<typename Level::IdType>& others, Buffer<typename Level::IdType>& vertices)
{
  using Id = typename Level::IdType;
  const RingFinder<Level> finder(level, steps);
  const vtkIdType old = level.Complex.NumberOfVertices;
  RegularRings<Id> rings;
  rings.Members = Buffer<Id>(RegularRings<Id>::Size * (old + level.Complex.NumberOfEdges));
  rings.Sides = Buffer<Id>(old + level.Complex.NumberOfEdges);
  ForEach(rings.Sides.size(),
    [&](vtkIdType v)
    {
      Id* ring = rings.Members.data() + RegularRings<Id>::Size * v;
      rings.Sides[v] = v < old ? finder.FindOld(static_cast<Id>(v), ring)
                               : finder.FindMidpoint(static_cast<Id>(v - old), ring);
      if (rings.Sides[v] < 0)
      {
        std::fill_n(ring, RegularRings<Id>::Size, static_cast<Id>(v));
      }
    });
  Buffer<unsigned char> at(old);
  ForEach(old, [&](vtkIdType v) { at[v] = rings.Sides[v] < 0; });
  ForEachInTurn(level.Complex.NumberOfEdges,
    [&](vtkIdType e)
    {
      for (int k = 0; k < 2 && rings.Sides[old + e] < 0; ++k)
      {
        at[level.Complex.EdgeVertices[2 * e + k]] = 1;
      }
    });
  if constexpr (SchemeOf<Level>::Traits.HasTangents)
  {
    others = BuildAt(level, steps, at, vertices);
  }
  return rings;
}

SUBDIVISION_COMPILE(struct RegularRings);

#define SUBDIVISION_REGULAR_RINGS(Scheme)                                                          \
  template RegularRings<Scheme::Id> FindRegularRings(                                              \
    const Scheme::Level&, int, LimitTangents<Scheme::Id>&, Buffer<Scheme::Id>&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_REGULAR_RINGS);

}
