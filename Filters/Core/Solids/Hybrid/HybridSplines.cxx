// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridSplines.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/BoxSpline.h"
#include "Core/Solids/Hybrid/HybridFans.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The ends of a line, and the next vertices of the curve on which it lies; none, if it lies on
/// none that is smooth there.
template <typename Id>
std::vector<Id> FindPointsOfLine(const HybridLevel<Id>& level, const Id* corners)
{
  std::vector<Id> points{ Id(-1), corners[0], corners[1], Id(-1) };
  for (int i = 0; i < 2; ++i)
  {
    if (level.Strata.Vertices[corners[i]].Result.GetRule() != Rule::Curve ||
      level.Sharpness.GetMost(level.Complex, corners[i]) > 0.)
    {
      return {};
    }
    const Id* ring = level.Strata.GetCurve(corners[i]).Ring;
    const bool isAlong = ring[0] == corners[1 - i] || ring[1] == corners[1 - i];
    const auto isCurve = [&](Id end)
    {
      const Id edge = level.Complex.FindEdge(corners[i], end);
      return level.Strata.Edges[edge].Result.GetRule() <= Rule::Curve;
    };
    if (!isAlong || !isCurve(ring[0]) || !isCurve(ring[1]))
    {
      return {};
    }
    points[i == 0 ? 0 : 3] = ring[ring[0] == corners[1 - i] ? 1 : 0];
  }
  return points;
}

/// The control points (BoxSpline.h) of a quad or triangle, if around each corner there are four
/// quads or six triangles of a smooth surface.
template <typename Id>
std::vector<Id> FindPointsOfFace(const HybridLevel<Id>& level, const Id* corners, Id face)
{
  const CellComplex<Id>& complex = level.Complex;
  const int size = complex.GetSize(face);
  const std::size_t valence = size == 4 ? 4 : 6;
  std::vector<Id> points(size == 4 ? BicubicPoints : BoxSplinePoints, Id(-1));
  HybridFan<Id> fan;
  for (int i = 0; i < size; ++i)
  {
    const bool isRegular = level.Strata.Vertices[corners[i]].Result.GetRule() == Rule::Surface &&
      FindFan(level, corners[i], fan) && IsPlainFan(level, fan) && fan.Faces.size() == valence &&
      std::all_of(
        fan.Faces.begin(), fan.Faces.end(), [&](Id f) { return complex.GetSize(f) == size; });
    const auto own = std::find(fan.Faces.begin(), fan.Faces.end(), face) - fan.Faces.begin();
    if (!isRegular || fan.Faces.begin() + own == fan.Faces.end())
    {
      return {};
    }
    const auto get = [&](std::size_t k) { return (static_cast<std::size_t>(own) + k) % valence; };
    // From the next corner on, away from the face.
    std::vector<Id> ends;
    for (std::size_t k = 1; k <= valence; ++k)
    {
      ends.push_back(complex.GetOtherEnd(fan.Edges[get(k)], corners[i]));
    }
    ends[0] != corners[(i + 1) % size] ? std::reverse(ends.begin(), ends.end()) : void();
    if (size == 3)
    {
      const Id own4[4] = { corners[i], ends[1], ends[2], ends[3] };
      const int places[4] = { i, 3 + i, 6 + 2 * i, 7 + 2 * i };
      for (int k = 0; k < 4; ++k)
      {
        points[static_cast<std::size_t>(places[k])] = own4[k];
      }
      continue;
    }
    const Row<Id> far = complex.GetVertices(fan.Faces[get(2)]);
    const auto at = std::find(far.begin(), far.end(), corners[i]) - far.begin();
    // The corner itself, and beyond it along the edges from the next and from the last corner.
    const Id grid[4] = { corners[i], ends[2], ends[1], far.begin()[(at + 2) % 4] };
    for (int k = 0; k < 4; ++k)
    {
      const bool isNextAlongU = i % 2 == 0;
      const bool alongU = isNextAlongU ? (k & 1) != 0 : (k & 2) != 0;
      const bool alongV = isNextAlongU ? (k & 2) != 0 : (k & 1) != 0;
      const int u = i == 1 || i == 2 ? (alongU ? 3 : 2) : (alongU ? 0 : 1);
      const int v = i >= 2 ? (alongV ? 3 : 2) : (alongV ? 0 : 1);
      points[static_cast<std::size_t>(4 * v + u)] = grid[k];
    }
  }
  return points;
}

constexpr std::size_t TricubicPoints = 64;

/// The bits are the coordinates of corner i of a hexahedron; and back.
std::size_t TurnCorner(std::size_t i)
{
  return i ^ (i >> 1 & 1);
}

/// Whether a vertex lies inside a lattice of hexahedra, and nothing is sharp there.
template <typename Id>
bool IsInLattice(const HybridLevel<Id>& level, Id vertex)
{
  const CellComplex<Id>& complex = level.Complex;
  const Row<Id> solids = complex.VertexSolids[vertex];
  const Row<Id> edges = complex.VertexEdges[vertex];
  return level.Strata.Vertices[vertex].Result.GetRule() == Rule::Solid &&
    solids.end() - solids.begin() == 8 && edges.end() - edges.begin() == 6 &&
    std::all_of(solids.begin(), solids.end(),
      [&](Id cell)
      {
        const Row<Id> faces = complex.CellFaces[cell];
        return complex.Cells.Shapes[cell] == CellShape::Hex &&
          std::all_of(faces.begin(), faces.end(),
            [&](Id face)
            {
              const Row<Id> ids = complex.GetVertices(face);
              return std::find(ids.begin(), ids.end(), vertex) == ids.end() ||
                level.Strata.Faces[face].GetRule() == Rule::Solid;
            });
      }) &&
    std::all_of(edges.begin(), edges.end(),
      [&](Id edge)
      {
        const Row<Id> around = complex.EdgeSolids[edge];
        return level.Strata.Edges[edge].Result.GetRule() == Rule::Solid &&
          around.end() - around.begin() == 4;
      }) &&
    level.Sharpness.GetMost(complex, vertex) <= 0.;
}

/// The control points of a hexahedron inside a lattice: x fastest, each coordinate from one layer
/// before the cell on.
template <typename Id>
std::vector<Id> FindPointsOfHex(const HybridLevel<Id>& level, const Id* corners)
{
  const CellComplex<Id>& complex = level.Complex;
  std::vector<Id> points(TricubicPoints, Id(-1));
  for (std::size_t i = 0; i < 8; ++i)
  {
    if (!IsInLattice(level, corners[i]))
    {
      return {};
    }
    const std::size_t bits = TurnCorner(i);
    const auto getNext = [&](std::size_t axis) { return corners[TurnCorner(bits ^ (1u << axis))]; };
    // The hexahedron beyond the corner, and those beyond one side at the corner.
    const Id* beyond = nullptr;
    std::array<Id, 3> outer{ { Id(-1), Id(-1), Id(-1) } };
    for (const Id cell : complex.VertexSolids[corners[i]])
    {
      const Id* own = complex.Cells.GetCorners(cell);
      const std::size_t at =
        TurnCorner(static_cast<std::size_t>(std::find(own, own + 8, corners[i]) - own));
      std::size_t has = 0;
      Id last = -1; // a neighbour of the corner that is none in the cell of the points
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const Id end = own[TurnCorner(at ^ (1u << axis))];
        std::size_t found = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
          found |= end == getNext(k) ? 1u << k : 0u;
        }
        has |= found;
        last = found == 0 ? end : last;
      }
      beyond = has == 0 ? own : beyond;
      for (std::size_t k = 0; k < 3; ++k)
      {
        outer[k] = has == (7u ^ (1u << k)) ? last : outer[k];
      }
    }
    if (!beyond)
    {
      return {};
    }
    const std::size_t at =
      TurnCorner(static_cast<std::size_t>(std::find(beyond, beyond + 8, corners[i]) - beyond));
    std::array<std::size_t, 3> turns{}; // the bit of its corners that changes along each axis
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto end = static_cast<std::size_t>(std::find(beyond, beyond + 8, outer[k]) - beyond);
      turns[k] = end < 8 ? TurnCorner(end) ^ at : 0;
    }
    if ((turns[0] | turns[1] | turns[2]) != 7 || turns[0] + turns[1] + turns[2] != 7)
    {
      return {};
    }
    for (std::size_t out = 0; out < 8; ++out)
    {
      std::size_t place = 0;
      std::size_t turned = at;
      for (std::size_t k = 0, stride = 1; k < 3; ++k, stride *= 4)
      {
        const bool isOut = (out >> k & 1) != 0;
        const bool isHigh = (bits >> k & 1) != 0;
        place += stride * (isHigh ? (isOut ? 3u : 2u) : (isOut ? 0u : 1u));
        turned ^= isOut ? turns[k] : 0;
      }
      points[place] = beyond[TurnCorner(turned)];
    }
  }
  return points;
}

/// The weights of the control points of a hexahedron, without second derivatives.
std::vector<PartWeights> WeightTricubic(
  const CornerShares& shares, const std::array<FramePoint, 3>& along)
{
  std::array<std::array<double, 4>, 3> values{};
  std::array<std::array<double, 4>, 3> slopes{};
  std::array<FramePoint, 3> directions{}; // by axis, then by direction
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double t = 0.;
    for (std::size_t i = 0; i < 8; ++i)
    {
      if ((TurnCorner(i) >> axis & 1) != 0)
      {
        t += shares.Values[i];
        for (std::size_t k = 0; k < 9; ++k)
        {
          directions[axis][k / 3] += along[k / 3][k % 3] * shares.Slopes[i][k % 3];
        }
      }
    }
    const double s = 1. - t;
    values[axis] = { { s * s * s / 6., 2. / 3. - t * t * (1. - t / 2.),
      2. / 3. - s * s * (1. - s / 2.), t * t * t / 6. } };
    slopes[axis] = { { -s * s / 2., t * (1.5 * t - 2.), s * (2. - 1.5 * s), t * t / 2. } };
  }
  std::vector<PartWeights> weights(TricubicPoints, PartWeights{});
  for (std::size_t i = 0; i < TricubicPoints; ++i)
  {
    const std::size_t at[3] = { i % 4, i / 4 % 4, i / 16 };
    weights[i][PlaceParts::Value] = values[0][at[0]] * values[1][at[1]] * values[2][at[2]];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::size_t b = (axis + 1) % 3;
      const std::size_t c = (axis + 2) % 3;
      const double slope = slopes[axis][at[axis]] * values[b][at[b]] * values[c][at[c]];
      for (std::size_t k = 0; k < 3; ++k)
      {
        weights[i][PlaceParts::First + k] += slope * directions[axis][k];
      }
    }
  }
  return weights;
}

PatchParts WeightSpline(
  CellShape shape, const CornerShares& shares, const std::array<FramePoint, 3>& along)
{
  // In quads a coordinate is the sum of two shares; corner 7 has none.
  const bool isQuad = shape == CellShape::Quad;
  const std::size_t second = isQuad ? 2 : 7;
  const std::size_t corners[2][2] = { { 1, second }, { isQuad ? 3u : 2u, second } };
  double at[2] = { 0., 0. };
  PatchDirections directions{};
  for (std::size_t c = 0; c < 2; ++c)
  {
    for (const std::size_t corner : corners[c])
    {
      at[c] += shares.Values[corner];
      for (std::size_t k = 0; k < 6; ++k)
      {
        directions[c][k / 3] += along[k / 3][k % 3] * shares.Slopes[corner][k % 3];
      }
    }
  }
  PatchParts parts{};
  switch (shape)
  {
    case CellShape::Line:
      WeightCubic(at[0], directions, parts);
      break;
    case CellShape::Triangle:
      WeightBoxSpline(at[0], at[1], directions, PlaceDerivatives::Second, parts);
      break;
    default:
      WeightBicubic(at[0], at[1], directions, PlaceDerivatives::Second, parts);
      break;
  }
  parts[PlaceParts::First + 2] = {};
  return parts;
}

}

template <typename Id>
std::vector<Id> FindSpline(const HybridLevel<Id>& level, vtkIdType cell)
{
  const Id* corners = level.Complex.Cells.GetCorners(cell);
  switch (level.Complex.Cells.Shapes[cell])
  {
    case CellShape::Line:
      return FindPointsOfLine(level, corners);
    case CellShape::Triangle:
    case CellShape::Quad:
      return FindPointsOfFace(level, corners, *level.Complex.CellFaces[cell].begin());
    case CellShape::Hex:
      return FindPointsOfHex(level, corners);
    default:
      return {};
  }
}

std::vector<PartWeights> WeighSpline(CellShape shape, std::size_t size, const CornerShares& shares,
  const std::array<FramePoint, 3>& along)
{
  if (shape == CellShape::Hex)
  {
    return WeightTricubic(shares, along);
  }
  const PatchParts parts = WeightSpline(shape, shares, along);
  std::vector<PartWeights> weights(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    std::transform(parts.begin(), parts.end(), weights[i].begin(),
      [i](const auto& ofPoints) { return ofPoints[i]; });
  }
  return weights;
}

SUBDIVISION_COMPILE_FUNCTION(FindSpline);

}
