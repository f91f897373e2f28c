// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Places/SurfacePlaces.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Surfaces/Places/RegularPatch.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <numeric>

namespace subdivision
{
namespace
{

/// A row for each of PlaceParts over the same columns: those of one column after the other.
template <typename Id>
struct PlaceRow
{
  std::vector<Id> Columns;
  std::vector<std::array<double, PlaceParts::Count>> Weights;
};

/// A place on its way through the levels.
template <typename Id>
struct MovingPlace
{
  SurfacePlace<Id> Place;
  PlaceRow<Id>* Row;
};

/// Splits a quad with a place at its corner k: the part there begins at this corner.
template <typename Id>
void GoToCornerOfQuad(int k, SurfacePlace<Id>& place)
{
  const std::array<double, 2> at = place.At;
  const auto directions = place.Directions;
  // x of the part is along the edge that begins at the corner, y along the one before.
  constexpr int axes[4][2] = { { 0, 1 }, { 1, 0 }, { 0, 1 }, { 1, 0 } };
  constexpr bool turned[4][2] = { { false, false }, { false, true }, { true, true },
    { true, false } };
  for (int i = 0; i < 2; ++i)
  {
    const int axis = axes[k][i];
    place.At[i] = 2. * (turned[k][i] ? 1. - at[axis] : at[axis]);
    for (int p = 0; p < 2; ++p)
    {
      place.Directions[i][p] = (turned[k][i] ? -2. : 2.) * directions[axis][p];
    }
  }
}

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

/// The derivatives by the parameters, from those by x and y.
template <typename Id>
std::array<double, PlaceParts::Count> TurnJet(const LocalJet& jet, const SurfacePlace<Id>& place)
{
  const auto& x = place.Directions[0]; // a structured binding cannot be captured
  const auto& y = place.Directions[1];
  const auto second = [&](int p, int q)
  { return jet[3] * x[p] * x[q] + jet[4] * (x[p] * y[q] + y[p] * x[q]) + jet[5] * y[p] * y[q]; };
  std::array<double, PlaceParts::Count> parts{};
  parts[PlaceParts::Value] = jet[0];
  for (int p = 0; p < 2; ++p)
  {
    parts[PlaceParts::First + p] = jet[1] * x[p] + jet[2] * y[p];
  }
  parts[PlaceParts::Second] = second(0, 0);
  parts[PlaceParts::Mixed] = second(0, 1);
  parts[PlaceParts::SecondOfSecond] = second(1, 1);
  return parts;
}

/// Weights of the corners of a part that counts as flat: linear, or bilinear.
std::vector<LocalJet> WeightCorners(std::size_t corners, double x, double y)
{
  const double r = 1. - x;
  const double s = 1. - y;
  switch (corners)
  {
    case 1:
      return { { { 1. } } };
    case 2:
      return { { { r, -1. } }, { { x, 1. } } };
    case 3:
      return { { { r - y, -1., -1. } }, { { x, 1., 0. } }, { { y, 0., 1. } } };
    default:
      return { { { r * s, -s, -r } }, { { x * s, s, -x } }, { { x * y, y, x } },
        { { r * y, -y, r } } };
  }
}

/// Whether a place is a corner of its part.
template <typename Id>
bool IsAtCorner(const SurfacePlace<Id>& place, std::size_t corners)
{
  const std::vector<LocalJet> weights = WeightCorners(corners, place.At[0], place.At[1]);
  return std::any_of(
    weights.begin(), weights.end(), [](const LocalJet& jet) { return jet[0] == 1.; });
}

/// The surroundings of a part, with rows over the vertices around the part with which it began.
/// They are stored without a row that all share, that of one corner. What is left becomes smaller
/// with the part, so that derivatives have the precision of numbers of this size.
template <typename Id>
class PartSurroundings
{
public:
  using Matrix = std::vector<double>; ///< of all columns for the first vertex, the second, ...

  PartSurroundings(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
    const SharpCreases<Id>& creases, const std::vector<Id>& vertices)
    : Patch(scheme, level, creases, vertices)
    , Columns(this->Patch.GetVertices())
    , Size(this->Columns.size())
    , Shared(this->Size, 0.)
    , Rows(this->Size * this->Size, 0.)
  {
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      this->Rows[i * this->Size + i] = 1.;
    }
  }
  /// The surroundings of some vertices of the level that a step from others makes.
  PartSurroundings(const SurfaceScheme<Id>& scheme, const PartSurroundings& before,
    const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases, const std::vector<Id>& vertices)
    : Patch(scheme, level, creases, vertices)
    , Columns(before.Columns)
    , Size(before.Size)
    , Shared(before.Shared)
    , Rows(this->Patch.GetVertices().size() * this->Size, 0.)
  {
    RowBlock<Id> row;
    double* sum = this->Rows.data();
    for (const Id vertex : this->Patch.GetVertices())
    {
      row.Clear();
      before.Patch.AppendRow(vertex, row);
      before.AddRow(row, sum);
      sum += this->Size;
    }
    const auto corner = static_cast<std::size_t>(this->Patch.FindVertex(vertices.front()));
    const auto first = this->Rows.begin() + static_cast<std::ptrdiff_t>(corner * this->Size);
    const Matrix more(first, first + static_cast<std::ptrdiff_t>(this->Size));
    for (std::size_t c = 0; c < this->Size; ++c)
    {
      this->Shared[c] += more[c];
    }
    for (std::size_t i = 0; i < this->Rows.size(); ++i)
    {
      this->Rows[i] -= more[i % this->Size];
    }
  }

  /// Adds what a row over the vertices of the patch is over the columns, without what is shared.
  void AddRow(const RowBlock<Id>& row, double* sum) const
  {
    const double* weights = row.GetWeights();
    for (std::size_t k = 0; k < row.GetNumberOfEntries(); ++k)
    {
      this->AddVertex(row.GetColumns()[k], weights[k], sum);
    }
  }
  void AddVertex(Id vertex, double factor, double* sum) const
  {
    const double* row = this->Rows.data() + static_cast<std::size_t>(vertex) * this->Size;
    for (std::size_t c = 0; c < this->Size; ++c)
    {
      sum[c] += factor * row[c];
    }
  }

  SharpPatch<Id> Patch;
  const std::vector<Id> Columns;
  const std::size_t Size; ///< of columns
  Matrix Shared;          ///< a part of each row with the sum 1

private:
  Matrix Rows; ///< of the vertices of the patch
};

/// Finds the rows of all places of one vertex, edge or face.
template <typename Id>
class PlaceDescent
{
public:
  explicit PlaceDescent(const SurfaceScheme<Id>& scheme)
    : Scheme(scheme)
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
    const bool isSharp = !around.Patch.GetSharpEdges().empty();
    const bool isWhole = this->Dimension < 2 || level.Mesh.GetSize(part) == this->Sides;
    RegularPatch<Id> regular;
    if (!isSharp && this->Dimension > 0 && isWhole &&
      (this->Dimension == 1 ? regular.FindLine(level, part) : regular.FindFace(level, part)))
    {
      this->UsePolynomial(around, regular, places);
      return;
    }
    if (isWhole)
    {
      this->UseCorners(around, part, places, splits);
    }
    if (!places.empty())
    {
      this->Split(around, part, places, splits);
    }
  }

  void UsePolynomial(
    const PartSurroundings<Id>& around, const RegularPatch<Id>& regular, Places& places) const
  {
    std::vector<double> rows(regular.Points.size() * around.Size, 0.);
    for (std::size_t j = 0; j < regular.Points.size(); ++j)
    {
      for (const auto& [vertex, weight] : regular.Points[j])
      {
        around.AddVertex(vertex, weight, rows.data() + j * around.Size);
      }
    }
    for (MovingPlace<Id>& moving : places)
    {
      const std::array<double, 2>& at = moving.Place.At;
      this->AddRows(around, rows, WeightControlPoints(regular.Domain, at[0], at[1]), moving);
    }
  }

  /// Takes values and derivatives of places from the limits of the corners of their part, where
  /// this is exact, or nothing better can be had, and removes these places.
  void UseCorners(const PartSurroundings<Id>& around, Id part, Places& places, int splits) const
  {
    const std::vector<Id> corners = this->CollectCorners(around.Patch.GetLevel().Mesh, part, false);
    const bool areLimits =
      around.Patch.GetSharpEdges().empty() && (this->Dimension == 0 || splits >= SplitsAtCorners);
    const auto isDone = [&](const MovingPlace<Id>& moving)
    {
      return splits == MostSurfaceSplits || (areLimits && IsAtCorner(moving.Place, corners.size()));
    };
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
      around.AddRow(row, rows.data() + i * around.Size);
    }
    Places rest;
    for (MovingPlace<Id>& moving : places)
    {
      if (!isDone(moving))
      {
        rest.push_back(moving);
        continue;
      }
      const std::array<double, 2>& at = moving.Place.At;
      this->AddRows(around, rows, WeightCorners(corners.size(), at[0], at[1]), moving);
      if (this->Dimension == 2)
      {
        this->TurnToTangents(around, corners, *moving.Row);
      }
    }
    places = std::move(rest);
  }

  /// Replaces first derivatives near an extraordinary vertex by what is most like them in the plane
  /// of its tangents: the plane through the corners of a part comes near that plane only slowly.
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
      around.AddRow(mask, tangents[i].data());
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
        a += row.Weights[c][p] * tangents[0][c];
        b += row.Weights[c][p] * tangents[1][c];
      }
      for (std::size_t c = 0; c < around.Size; ++c)
      {
        row.Weights[c][p] =
          ((a * bb - b * ab) * tangents[0][c] + (b * aa - a * ab) * tangents[1][c]) / determinant;
      }
    }
  }

  /// Sets the row of a place, from rows and the weight that each has.
  void AddRows(const PartSurroundings<Id>& around, const std::vector<double>& rows,
    const std::vector<LocalJet>& weights, MovingPlace<Id>& moving) const
  {
    PlaceRow<Id>& row = *moving.Row;
    row.Columns = around.Columns;
    row.Weights.assign(around.Size, {});
    for (std::size_t j = 0; j < weights.size(); ++j)
    {
      const auto parts = TurnJet(weights[j], moving.Place);
      const double* from = rows.data() + j * around.Size;
      for (std::size_t c = 0; c < around.Size; ++c)
      {
        for (int p = 0; p < PlaceParts::Count && from[c] != 0.; ++p)
        {
          row.Weights[c][p] += parts[p] * from[c];
        }
      }
    }
    for (std::size_t c = 0; c < around.Size; ++c)
    {
      row.Weights[c][PlaceParts::Value] += around.Shared[c];
    }
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
    for (auto& [child, own] : parts)
    {
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
          place.Corner = -1; // x and y are those of the next level
          return corner;
        }
        return static_cast<Id>(mesh.GetFirst(part) + GoToPartOfQuad(place));
    }
  }

  const SurfaceScheme<Id>& Scheme;
  const Id Sides; ///< of the scheme's faces
  int Dimension = 0;
};

/// Joins the rows of all places, without columns that have no weight.
template <typename Id>
PlaceRows<Id> JoinRows(vtkIdType columns, const std::vector<PlaceRow<Id>>& all)
{
  const auto size = static_cast<vtkIdType>(all.size());
  const auto hasWeight = [](const std::array<double, PlaceParts::Count>& weights)
  { return std::any_of(weights.begin(), weights.end(), [](double w) { return w != 0.; }); };
  Buffer<Id> offsets(size + 1);
  ForEach(size,
    [&](vtkIdType i)
    {
      offsets[i] =
        static_cast<Id>(std::count_if(all[i].Weights.begin(), all[i].Weights.end(), hasWeight));
    });
  CountsToOffsets(offsets);
  PlaceRows<Id> rows;
  for (SparseRows<Id>& part : rows)
  {
    part.NumberOfColumns = columns;
    part.Offsets = Buffer<Id>(size + 1);
    CopyInThreads(offsets.data(), size + 1, part.Offsets.data());
    part.Columns = Buffer<Id>(offsets[size]);
    part.Weights = Buffer<double>(offsets[size]);
  }
  ForEach(size,
    [&](vtkIdType i)
    {
      vtkIdType to = offsets[i];
      for (std::size_t c = 0; c < all[i].Columns.size(); ++c)
      {
        if (hasWeight(all[i].Weights[c]))
        {
          for (int p = 0; p < PlaceParts::Count; ++p)
          {
            rows[p].Columns[to] = all[i].Columns[c];
            rows[p].Weights[to] = all[i].Weights[c][p];
          }
          ++to;
        }
      }
    });
  return rows;
}

}

template <typename Id>
PlaceRows<Id> FindSurfacePlaces(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const std::vector<SurfacePlace<Id>>& places)
{
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto isBefore = [&places](std::size_t a, std::size_t b)
  {
    return places[a].Dimension != places[b].Dimension ? places[a].Dimension < places[b].Dimension
                                                      : places[a].Part < places[b].Part;
  };
  StableSort(order, isBefore);
  std::vector<std::size_t> starts; // of the places of one part
  for (const std::size_t i : InTurn(order.size()))
  {
    if (i == 0 || isBefore(order[i - 1], order[i]))
    {
      starts.push_back(i);
    }
  }
  const auto groups = static_cast<vtkIdType>(starts.size());
  starts.push_back(order.size());
  std::vector<PlaceRow<Id>> rows(places.size());
  ForRangesOfBlocks(groups,
    [&](vtkIdType begin, vtkIdType end)
    {
      PlaceDescent<Id> descent(scheme);
      for (vtkIdType group = begin; group < end; ++group)
      {
        std::vector<MovingPlace<Id>> moving;
        for (std::size_t i = starts[group]; i < starts[group + 1]; ++i)
        {
          moving.push_back({ places[order[i]], &rows[order[i]] });
        }
        descent.Run(level, creases, moving);
      }
    });
  return JoinRows(level.Mesh.NumberOfVertices, rows);
}

SUBDIVISION_COMPILE_FUNCTION(FindSurfacePlaces);

}
