// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceDescent.h
 * The rows of places of one vertex, edge or face that is not regular, by steps of its surroundings.
 */
#ifndef SubdivisionObjects_PlaceDescent_h
#define SubdivisionObjects_PlaceDescent_h

#include "Core/Surfaces/Places/PartSurroundings.h"
#include "Core/Surfaces/Places/PatchWeights.h"
#include "Core/Surfaces/Places/QuadParts.h"
#include "Core/Surfaces/Places/RegularPatch.h"
#include "Core/Surfaces/Places/SurfacePlaces.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace subdivision
{

/// A row for each of PlaceParts that is wanted over the same columns; others are empty.
template <typename Id>
struct PlaceRow
{
  std::vector<Id> Columns;
  std::array<std::vector<double>, PlaceParts::Count> Weights;

  /// Removes columns that have no weight.
  void RemoveZeros()
  {
    const auto hasWeight = [this](std::size_t c)
    {
      return std::any_of(this->Weights.begin(), this->Weights.end(),
        [c](const std::vector<double>& weights) { return !weights.empty() && weights[c] != 0.; });
    };
    std::size_t left = 0;
    for (std::size_t c = 0; c < this->Columns.size(); ++c)
    {
      if (hasWeight(c))
      {
        this->Columns[left] = this->Columns[c];
        for (std::vector<double>& weights : this->Weights)
        {
          weights.empty() ? void() : void(weights[left] = weights[c]);
        }
        ++left;
      }
    }
    this->Columns.resize(left);
    for (std::vector<double>& weights : this->Weights)
    {
      weights.resize(std::min(left, weights.size()));
    }
  }
};

/// A place on its way through the levels.
template <typename Id>
struct MovingPlace
{
  SurfacePlace<Id> Place;
  PlaceRow<Id>* Row;
};

/// Goes on to the part of a quad, triangle or line, and returns its number.
template <typename Id>
int GoToPartOfQuad(SurfacePlace<Id>& place)
{
  const int k = place.At[1] <= 0.5 ? (place.At[0] <= 0.5 ? 0 : 1) : (place.At[0] <= 0.5 ? 3 : 2);
  GoToCornerOfQuad(k, place);
  return k;
}

template <typename Id>
int GoToPartOfTriangle(SurfacePlace<Id>& place)
{
  const auto [x, y] = place.At;
  auto& d = place.Directions;
  if (x + y > 0.5 && x <= 0.5 && y <= 0.5) // the middle one
  {
    place.At = { { 2. * (x + y) - 1., 1. - 2. * x } };
    for (int p = 0; p < 2; ++p)
    {
      const double ofX = d[0][p];
      d[0][p] = 2. * (ofX + d[1][p]);
      d[1][p] = -2. * ofX;
    }
    return 3;
  }
  const int child = x > 0.5 ? 1 : y > 0.5 ? 2 : 0;
  place.At = { { child == 1 ? 2. * x - 1. : 2. * x, child == 2 ? 2. * y - 1. : 2. * y } };
  for (auto& axis : d)
  {
    axis = { { 2. * axis[0], 2. * axis[1] } };
  }
  return child;
}

template <typename Id>
int GoToPartOfLine(SurfacePlace<Id>& place)
{
  const int child = place.At[0] <= 0.5 ? 0 : 1;
  place.At[0] = 2. * place.At[0] - child;
  place.Directions[0] = { { 2. * place.Directions[0][0], 2. * place.Directions[0][1] } };
  return child;
}

/// Whether a place is a corner of its part.
template <typename Id>
bool IsAtCorner(const SurfacePlace<Id>& place, int corners)
{
  const PatchParts weights = WeightCorners(corners, place.At, place.Directions);
  const double* first = weights[PlaceParts::Value].data();
  return std::find(first, first + corners, 1.) != first + corners;
}

/// Finds the rows of all places of one vertex, edge or face.
template <typename Id>
class PlaceDescent
{
public:
  PlaceDescent(const SurfaceScheme<Id>& scheme, PlaceDerivatives derivatives)
    : Scheme(scheme)
    , Derivatives(derivatives)
    , Sides(scheme.NeedsTriangles() ? 3 : 4)
  {
  }

  void Run(const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases,
    std::vector<MovingPlace<Id>>& places)
  {
    this->Dimension = places.front().Place.Dimension;
    const Id part = places.front().Place.Part;
    PartSurroundings<Id> start(
      this->Scheme, level, creases, this->CollectCorners(level.Mesh, part, true));
    this->GoOn(start, this->FindPart(start.Patch, part), places, 0);
  }

private:
  using Places = std::vector<MovingPlace<Id>>;

  Id FindPart(const SharpPatch<Id>& patch, Id part) const
  {
    return this->Dimension == 0 ? patch.FindVertex(part)
      : this->Dimension == 1    ? patch.FindEdge(part)
                                : patch.FindFace(part);
  }
  /// The corners of a part, in its order, or ascending.
  std::vector<Id> CollectCorners(const PolygonMesh<Id>& mesh, Id part, bool ascending) const
  {
    std::vector<Id> corners{ part };
    if (this->Dimension == 1)
    {
      const Id* ends = mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(part);
      corners.assign(ends, ends + 2);
    }
    else if (this->Dimension == 2)
    {
      const Id* first = mesh.Vertices.data() + mesh.GetFirst(part);
      corners.assign(first, first + mesh.GetSize(part));
    }
    if (ascending)
    {
      std::sort(corners.begin(), corners.end());
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    }
    return corners;
  }

  /// Places of one part, which is in the patch, after some splits.
  void GoOn(PartSurroundings<Id>& around, Id part, Places& places, int splits) const
  {
    const SurfaceLevel<Id>& level = around.Patch.GetLevel();
    RegularPatch<Id> regular;
    if (around.Patch.GetSharpEdges().empty() && this->FindRegular(level, part, regular))
    {
      const auto addVertex = [&](Id vertex, double weight, double* sum)
      { around.AddVertex(vertex, weight, sum); };
      this->UsePolynomial(around, regular, addVertex, places);
      return;
    }
    if (this->IsWhole(level, part))
    {
      this->UseCorners(around, part, places, splits);
    }
    if (!places.empty())
    {
      this->Split(around, part, places, splits);
    }
  }

  /// Whether a part has the number of corners of the scheme.
  bool IsWhole(const SurfaceLevel<Id>& level, Id part) const
  {
    return this->Dimension < 2 || level.Mesh.GetSize(part) == this->Sides;
  }
  bool FindRegular(const SurfaceLevel<Id>& level, Id part, RegularPatch<Id>& regular) const
  {
    return this->Dimension > 0 && this->IsWhole(level, part) &&
      (this->Dimension == 1 ? regular.FindLine(level, part) : regular.FindFace(level, part));
  }

  /// addVertex(vertex, weight, sum): adds the row over the columns of a vertex that the patch has,
  /// without the shared row.
  template <typename AddVertex>
  void UsePolynomial(const PartSurroundings<Id>& around, const RegularPatch<Id>& regular,
    const AddVertex& addVertex, Places& places) const
  {
    // The row of the first point is taken off all of them, as PartSurroundings does it.
    const std::size_t size = around.Size;
    std::vector<double> rows(regular.Points.size() * size, 0.);
    for (std::size_t j = 0; j < regular.Points.size(); ++j)
    {
      for (const auto& [vertex, weight] : regular.Points[j])
      {
        addVertex(vertex, weight, rows.data() + j * size);
      }
    }
    std::vector<double> shared(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(size));
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      rows[i] -= shared[i % size];
    }
    std::transform(
      shared.begin(), shared.end(), around.Shared.begin(), shared.begin(), std::plus<>());
    PatchParts weights{};
    for (MovingPlace<Id>& moving : places)
    {
      const SurfacePlace<Id>& place = moving.Place;
      WeightControlPoints(regular.Domain, place.At, place.Directions, this->Derivatives, weights);
      this->AddRows(around.Columns, shared, rows, weights, *moving.Row);
    }
  }

  /// Takes values and derivatives of places from the limits of the corners of their part, where
  /// this is exact, or nothing better can be had, and removes these places.
  void UseCorners(const PartSurroundings<Id>& around, Id part, Places& places, int splits) const
  {
    const std::vector<Id> corners = this->CollectCorners(around.Patch.GetLevel().Mesh, part, false);
    const auto size = static_cast<int>(corners.size());
    const bool areLimits =
      around.Patch.GetSharpEdges().empty() && (this->Dimension == 0 || splits >= SplitsAtCorners);
    const auto isDone = [&](const MovingPlace<Id>& moving)
    { return splits == MostSurfaceSplits || (areLimits && IsAtCorner(moving.Place, size)); };
    if (std::none_of(places.begin(), places.end(), isDone))
    {
      return;
    }
    std::vector<double> rows(corners.size() * around.Size, 0.);
    RowBlock<Id> row;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      row.Clear();
      around.Patch.AppendLimitRow(corners[i], LimitKind::Position, row);
      around.AddRow(row, 1., rows.data() + i * around.Size);
    }
    Places rest;
    for (MovingPlace<Id>& moving : places)
    {
      if (!isDone(moving))
      {
        rest.push_back(moving);
        continue;
      }
      this->AddRows(around.Columns, around.Shared, rows,
        WeightCorners(size, moving.Place.At, moving.Place.Directions), *moving.Row);
      if (this->Dimension == 2)
      {
        this->TurnToTangents(around, corners, *moving.Row);
      }
    }
    places = std::move(rest);
  }

  /// Replaces first derivatives near an extraordinary vertex by the nearest vectors in the plane of
  /// its tangents: the plane through the corners of a part comes near that plane only slowly.
  void TurnToTangents(
    const PartSurroundings<Id>& around, const std::vector<Id>& corners, PlaceRow<Id>& row) const
  {
    const SurfaceLevel<Id>& level = around.Patch.GetLevel();
    std::vector<Id> edges;
    const auto isExtraordinary = [&](Id corner)
    {
      CollectEdges(level.Mesh, corner, [](Id) { return true; }, edges);
      return level.Tags.Vertices[corner] == VertexTag::Smooth &&
        edges.size() != (this->Sides == 3 ? 6 : 4);
    };
    const auto corner = std::find_if(corners.begin(), corners.end(), isExtraordinary);
    if (corner == corners.end())
    {
      return;
    }
    std::array<std::vector<double>, 2> tangents;
    constexpr LimitKind kinds[2] = { LimitKind::Tangent1, LimitKind::Tangent2 };
    RowBlock<Id> mask;
    for (int i = 0; i < 2; ++i)
    {
      mask.Clear();
      around.Patch.AppendLimitRow(*corner, kinds[i], mask);
      tangents[i].assign(around.Size, 0.);
      around.AddRow(mask, 1., tangents[i].data());
    }
    const auto dot = [](const std::vector<double>& a, const std::vector<double>& b)
    { return std::inner_product(a.begin(), a.end(), b.begin(), 0.); };
    const double aa = dot(tangents[0], tangents[0]);
    const double ab = dot(tangents[0], tangents[1]);
    const double bb = dot(tangents[1], tangents[1]);
    const double determinant = aa * bb - ab * ab;
    for (int p = PlaceParts::First; p < PlaceParts::First + 2 && determinant > 0.; ++p)
    {
      double a = 0.;
      double b = 0.;
      for (std::size_t c = 0; c < around.Size; ++c)
      {
        a += row.Weights[p][c] * tangents[0][c];
        b += row.Weights[p][c] * tangents[1][c];
      }
      for (std::size_t c = 0; c < around.Size; ++c)
      {
        row.Weights[p][c] =
          ((a * bb - b * ab) * tangents[0][c] + (b * aa - a * ab) * tangents[1][c]) / determinant;
      }
    }
  }

  /// Sets the row of a place, from rows and the weights that each has.
  void AddRows(const std::vector<Id>& columns, const std::vector<double>& shared,
    const std::vector<double>& rows, const PatchParts& weights, PlaceRow<Id>& row) const
  {
    const std::size_t size = columns.size();
    row.Columns = columns;
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      if (p == PlaceParts::First + 2 || !IsWanted(p, this->Derivatives))
      {
        continue;
      }
      std::vector<double>& sums = row.Weights[p];
      sums.assign(size, 0.);
      for (std::size_t j = 0; j * size < rows.size(); ++j)
      {
        const double weight = weights[p][j];
        const double* from = rows.data() + j * size;
        for (std::size_t c = 0; c < size; ++c)
        {
          sums[c] += weight * from[c];
        }
      }
    }
    std::vector<double>& values = row.Weights[PlaceParts::Value];
    std::transform(values.begin(), values.end(), shared.begin(), values.begin(), std::plus<>());
  }

  /// Takes a step, and goes on with each part that has places.
  void Split(PartSurroundings<Id>& around, Id part, Places& places, int splits) const
  {
    const PolygonMesh<Id>& mesh = around.Patch.GetLevel().Mesh;
    SharpCreases<Id> creases;
    const SurfaceLevel<Id> next = around.Patch.Refine(creases);
    std::vector<std::pair<Id, Places>> parts;
    for (MovingPlace<Id>& moving : places)
    {
      const Id child = this->GoToPart(mesh, part, moving.Place);
      auto found = std::find_if(
        parts.begin(), parts.end(), [child](const auto& made) { return made.first == child; });
      if (found == parts.end())
      {
        parts.emplace_back(child, Places());
        found = parts.end() - 1;
      }
      found->second.push_back(moving);
    }
    places.clear();
    RowBlock<Id> row;
    const auto addVertex = [&](Id vertex, double weight, double* sum)
    { around.AddVertexOfNext(vertex, weight, row, sum); };
    for (auto& [child, own] : parts)
    {
      RegularPatch<Id> regular;
      if (creases.Edges.empty() && this->FindRegular(next, child, regular))
      {
        this->UsePolynomial(around, regular, addVertex, own);
        continue;
      }
      PartSurroundings<Id> inside(
        this->Scheme, around, next, creases, this->CollectCorners(next.Mesh, child, true));
      this->GoOn(inside, this->FindPart(inside.Patch, child), own, splits + 1);
    }
  }

  /// The number of the part of the next level in which a place lies.
  Id GoToPart(const PolygonMesh<Id>& mesh, Id part, SurfacePlace<Id>& place) const
  {
    switch (this->Dimension)
    {
      case 0:
        return part;
      case 1:
        return static_cast<Id>(2 * part + GoToPartOfLine(place));
      default:
        if (this->Sides == 3)
        {
          return static_cast<Id>(4 * part + GoToPartOfTriangle(place));
        }
        if (place.Corner >= 0)
        {
          const Id corner = mesh.GetFirst(part) + static_cast<Id>(place.Corner);
          place.Corner = -1; // x and y belong to the next level now
          return corner;
        }
        return static_cast<Id>(mesh.GetFirst(part) + GoToPartOfQuad(place));
    }
  }

  const SurfaceScheme<Id>& Scheme;
  const PlaceDerivatives Derivatives;
  const Id Sides; ///< of the scheme's faces
  int Dimension = 0;
};

}

#endif
