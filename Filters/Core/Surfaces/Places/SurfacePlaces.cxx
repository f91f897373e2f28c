// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Places/SurfacePlaces.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Operators/PlaceSum.h"
#include "Core/Surfaces/Places/QuadParts.h"
#include "Core/Surfaces/Places/RegularPatch.h"
#include "Core/Surfaces/Scheme/SharpLimits.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace subdivision
{
namespace
{

/// The patches of some levels, each around a part that a step makes of the one before, and the rows
/// of their vertices, as PlaceSum goes back through them. Level 0 is the whole level around which
/// the first patch is. A vertex has its number on the level that a step has made, of which the next
/// patch is a part.
template <typename Id>
class PatchLevels
{
public:
  using LevelRow = VertexRow<LevelVertex<Id>>;

  explicit PatchLevels(const SurfaceScheme<Id>& scheme)
    : Scheme(scheme)
  {
  }

  /// How many patches there are: the level that the step from the last one makes.
  int GetSize() const { return static_cast<int>(this->Patches.size()); }
  SharpPatch<Id>& GetLast() { return *this->Patches.back().Patch; }
  const SharpPatch<Id>& GetLast() const { return *this->Patches.back().Patch; }
  /// Adds a patch around vertices of the level of that number, ascending.
  void Add(
    const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases, const std::vector<Id>& vertices)
  {
    this->Patches.push_back(
      { std::make_unique<SharpPatch<Id>>(this->Scheme, level, creases, vertices), {} });
  }
  void RemoveLast() { this->Patches.pop_back(); }

  // These return true: all rules are known.

  /// The row of a vertex over the level before it. Each is made once.
  bool ReadRow(const LevelVertex<Id>& vertex, LevelRow& row)
  {
    Level& level = this->Patches[vertex.Level - 1];
    const auto number = static_cast<std::size_t>(vertex.Number);
    if (level.Rows.size() <= number)
    {
      level.Rows.resize(number + 1);
    }
    if (level.Rows[number].Vertices.empty())
    {
      this->Block.Clear();
      level.Patch->AppendRow(vertex.Number, this->Block);
      this->Take(vertex.Level - 1, level.Rows[number]);
    }
    row = level.Rows[number];
    return true;
  }
  /// The limit, or a tangent, of a vertex over its own level, of which there is a patch. No crease
  /// is sharp near it any more.
  bool ReadLimit(const LevelVertex<Id>& vertex, LevelRow& row, LimitKind kind = LimitKind::Position)
  {
    const SharpPatch<Id>& patch = *this->Patches[vertex.Level].Patch;
    this->Block.Clear();
    patch.AppendLimitRow(patch.FindVertex(vertex.Number), kind, this->Block);
    row.Clear();
    this->Take(vertex.Level, row);
    return true;
  }

private:
  struct Level
  {
    std::unique_ptr<SharpPatch<Id>> Patch;
    std::vector<LevelRow> Rows; ///< of vertices that the step from it makes, where known
  };

  void Take(int level, LevelRow& row) const
  {
    const std::vector<Id>& vertices = this->Patches[level].Patch->GetVertices();
    const Id* columns = this->Block.GetColumns();
    const double* weights = this->Block.GetWeights();
    for (std::size_t k = 0; k < this->Block.GetNumberOfEntries(); ++k)
    {
      row.Add({ level, vertices[columns[k]] }, weights[k]);
    }
  }

  const SurfaceScheme<Id>& Scheme;
  std::vector<Level> Patches;
  RowBlock<Id> Block;
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
    : Derivatives(derivatives)
    , Sides(scheme.NeedsTriangles() ? 3 : 4)
    , Levels(scheme)
  {
  }

  /// Sets the rows of places getPlace(0) to getPlace(size - 1) of one part of the level, or
  /// `inner`, if it is a face inside of a regular surface. `isFar`: no crease near the part is
  /// sharp for some steps more.
  template <typename GetPlace>
  void Run(const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases, bool isFar,
    std::size_t size, const GetPlace& getPlace, SplineColumns<Id>& inner,
    std::vector<PlaceRow<Id>>& rows)
  {
    const Id part = getPlace(0).Part;
    this->Dimension = getPlace(0).Dimension;
    const bool isRegular = isFar && this->FindRegular(level, part);
    if (isRegular && this->Dimension == 2 && this->Regular.TakeColumns(inner))
    {
      return;
    }
    rows.resize(size);
    Places places;
    for (std::size_t i = 0; i < size; ++i)
    {
      places.push_back({ getPlace(i), &rows[i] });
    }
    isRegular ? this->UsePolynomial(0, places) : this->GoOn(level, creases, part, places);
  }

private:
  using Places = std::vector<MovingPlace<Id>>;
  /// PlaceParts, and two tangents.
  using Weights = std::array<double, PlaceParts::Count + 2>;

  std::vector<Id> ListCorners(const PolygonMesh<Id>& mesh, Id part) const
  {
    const Id* first = this->Dimension == 0 ? &part
      : this->Dimension == 1 ? mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(part)
                             : mesh.Vertices.data() + mesh.GetFirst(part);
    return { first, first + (this->Dimension < 2 ? Id(this->Dimension + 1) : mesh.GetSize(part)) };
  }

  /// Places of one part of a level.
  void GoOn(const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases, Id part, Places& places)
  {
    const int number = this->Levels.GetSize();
    const bool isSharp = !creases.Edges.empty();
    if (!isSharp && this->FindRegular(level, part))
    {
      this->UsePolynomial(number, places);
      return;
    }
    const std::vector<Id> corners = this->ListCorners(level.Mesh, part);
    std::vector<Id> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    this->Levels.Add(level, creases, sorted);
    const bool isSharpHere = !this->Levels.GetLast().GetSharpEdges().empty();
    if (isSharp && !isSharpHere && this->FindRegular(level, part))
    {
      this->UsePolynomial(number, places);
      places.clear();
    }
    else if (this->IsWhole(level, part))
    {
      this->UseCorners(level, number, corners, places);
    }
    if (!places.empty())
    {
      this->Split(part, places);
    }
    this->Levels.RemoveLast();
  }

  /// Whether a part has the number of corners of the scheme.
  bool IsWhole(const SurfaceLevel<Id>& level, Id part) const
  {
    return this->Dimension < 2 || level.Mesh.GetSize(part) == this->Sides;
  }

  bool FindRegular(const SurfaceLevel<Id>& level, Id part)
  {
    return this->Dimension > 0 && this->IsWhole(level, part) &&
      (this->Dimension == 1 ? this->Regular.FindLine(level, part)
                            : this->Regular.FindFace(level, part));
  }
  /// Takes the polynomial over a part that is regular.
  void UsePolynomial(int number, const Places& places)
  {
    PatchParts ofPoints{};
    for (const MovingPlace<Id>& moving : places)
    {
      const SurfacePlace<Id>& place = moving.Place;
      WeightControlPoints(
        this->Regular.Domain, place.At, place.Directions, this->Derivatives, ofPoints);
      this->Sum.Clear();
      for (std::size_t j = 0; j < this->Regular.Points.size(); ++j)
      {
        for (const auto& [vertex, factor] : this->Regular.Points[j])
        {
          this->Sum.Add({ number, vertex }, TakeWeights(ofPoints, j, factor));
        }
      }
      this->Sum.StepBack(number);
      this->Sum.Write(*moving.Row);
    }
  }
  static Weights TakeWeights(const PatchParts& parts, std::size_t j, double factor)
  {
    Weights weights{};
    for (std::size_t p = 0; p < PlaceParts::Count; ++p)
    {
      weights[p] = factor * parts[p][j];
    }
    return weights;
  }

  /// Takes values and derivatives of places from the limits of the corners of their part, where
  /// this is exact, or nothing better can be had, and removes these places.
  void UseCorners(
    const SurfaceLevel<Id>& level, int number, const std::vector<Id>& corners, Places& places)
  {
    const auto size = static_cast<int>(corners.size());
    const bool areLimits = this->Levels.GetLast().GetSharpEdges().empty() &&
      (this->Dimension == 0 || number >= SplitsAtCorners);
    const auto isLeft = [&](const MovingPlace<Id>& moving)
    { return number < MostSurfaceSplits && !(areLimits && IsAtCorner(moving.Place, size)); };
    const auto done = std::stable_partition(places.begin(), places.end(), isLeft);
    for (auto moving = done; moving != places.end(); ++moving)
    {
      const PatchParts ofCorners = WeightCorners(size, moving->Place.At, moving->Place.Directions);
      this->Sum.Clear();
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        this->Sum.AddLimit(LevelVertex<Id>{ number, corners[i] }, TakeWeights(ofCorners, i, 1.));
      }
      const bool hasTangents = this->Dimension == 2 && this->AddTangents(level, number, corners);
      this->Sum.StepBack(number);
      this->Sum.Write(*moving->Row);
      hasTangents ? this->TurnToTangents(*moving->Row) : void();
    }
    places.erase(done, places.end());
  }

  /// Adds the tangents at the first of the corners that is extraordinary. False: there is none.
  bool AddTangents(const SurfaceLevel<Id>& level, int number, const std::vector<Id>& corners)
  {
    std::vector<Id> edges;
    const auto isExtraordinary = [&](Id corner)
    {
      CollectEdges(level.Mesh, corner, [](Id) { return true; }, edges);
      return level.Tags.Vertices[corner] == VertexTag::Smooth &&
        edges.size() != (this->Sides == 3 ? 6 : 4);
    };
    const auto corner = std::find_if(corners.begin(), corners.end(), isExtraordinary);
    constexpr LimitKind kinds[2] = { LimitKind::Tangent1, LimitKind::Tangent2 };
    typename PatchLevels<Id>::LevelRow row;
    for (std::size_t i = 0; i < 2 && corner != corners.end(); ++i)
    {
      this->Levels.ReadLimit({ number, *corner }, row, kinds[i]);
      for (std::size_t k = 0; k < row.Vertices.size(); ++k)
      {
        Weights weights{};
        weights[PlaceParts::Count + i] = row.Weights[k];
        this->Sum.Add(row.Vertices[k], weights);
      }
    }
    return corner != corners.end();
  }

  /// Replaces first derivatives near an extraordinary vertex by the nearest vectors in the plane of
  /// its tangents: the plane through the corners of a part comes near that plane only slowly.
  void TurnToTangents(PlaceRow<Id>& row) const
  {
    std::vector<std::array<double, 2>> tangents;
    this->Sum.ForColumns([&tangents](Id, const Weights& weights)
      { tangents.push_back({ { weights[PlaceParts::Count], weights[PlaceParts::Count + 1] } }); });
    double aa = 0.;
    double ab = 0.;
    double bb = 0.;
    for (const auto& [a, b] : tangents)
    {
      aa += a * a;
      ab += a * b;
      bb += b * b;
    }
    const double determinant = aa * bb - ab * ab;
    for (int p = PlaceParts::First; p < PlaceParts::First + 2 && determinant > 0.; ++p)
    {
      double a = 0.;
      double b = 0.;
      for (std::size_t c = 0; c < tangents.size(); ++c)
      {
        a += row.Weights[c][p] * tangents[c][0];
        b += row.Weights[c][p] * tangents[c][1];
      }
      for (std::size_t c = 0; c < tangents.size(); ++c)
      {
        row.Weights[c][p] =
          ((a * bb - b * ab) * tangents[c][0] + (b * aa - a * ab) * tangents[c][1]) / determinant;
      }
    }
  }

  /// Takes a step, and goes on with each part that has places.
  void Split(Id part, Places& places)
  {
    SharpPatch<Id>& patch = this->Levels.GetLast();
    const Id own = this->Dimension == 0 ? patch.FindVertex(part)
      : this->Dimension == 1            ? patch.FindEdge(part)
                                        : patch.FindFace(part);
    SharpCreases<Id> creases;
    const SurfaceLevel<Id> next = patch.Refine(creases);
    std::vector<std::pair<Id, Places>> parts;
    for (MovingPlace<Id>& moving : places)
    {
      const Id child = this->GoToPart(patch.GetLevel().Mesh, own, moving.Place);
      auto found = std::find_if(
        parts.begin(), parts.end(), [child](const auto& made) { return made.first == child; });
      if (found == parts.end())
      {
        parts.emplace_back(child, Places());
        found = parts.end() - 1;
      }
      found->second.push_back(moving);
    }
    for (auto& [child, ofChild] : parts)
    {
      this->GoOn(next, creases, child, ofChild);
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

  const PlaceDerivatives Derivatives;
  const Id Sides; ///< of the scheme's faces
  int Dimension = 0;
  RegularPatch<Id> Regular; ///< that was found last
  PatchLevels<Id> Levels;
  PlaceSum<PatchLevels<Id>, Weights> Sum{ this->Levels };
};

/// The data for the rows of places of a vertex, edge or face.
template <typename Id>
struct PartRows
{
  SplineColumns<Id> Inner;        ///< of a face inside of a regular surface. Of all others:
  std::vector<PlaceRow<Id>> Rows; ///< the rows of the places

  const Id* GetColumns(std::size_t place) const
  {
    return this->Rows.empty() ? this->Inner.begin() : this->Rows[place].Columns.data();
  }
  std::size_t CountColumns(std::size_t place) const
  {
    return this->Rows.empty() ? static_cast<std::size_t>(this->Inner.GetSize())
                              : this->Rows[place].Columns.size();
  }
};

/// The places of each part, one part after the other.
template <typename Id>
struct PlacesOfParts
{
  std::vector<std::size_t> Order;  ///< of all places
  std::vector<std::size_t> Starts; ///< of the places of a part in that order; one more than parts

  explicit PlacesOfParts(const std::vector<SurfacePlace<Id>>& places)
    : Order(places.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
    const auto isBefore = [&places](std::size_t a, std::size_t b)
    {
      return places[a].Dimension != places[b].Dimension ? places[a].Dimension < places[b].Dimension
                                                        : places[a].Part < places[b].Part;
    };
    if (!std::is_sorted(this->Order.begin(), this->Order.end(), isBefore)) // often it is
    {
      StableSort(this->Order, isBefore);
    }
    for (const std::size_t i : InTurn(this->Order.size()))
    {
      if (i == 0 || isBefore(this->Order[i - 1], this->Order[i]))
      {
        this->Starts.push_back(i);
      }
    }
    this->Starts.push_back(this->Order.size());
  }
  vtkIdType GetNumberOfParts() const { return static_cast<vtkIdType>(this->Starts.size()) - 1; }
  std::size_t CountPlaces(vtkIdType part) const
  {
    return this->Starts[part + 1] - this->Starts[part];
  }
  /// The number of place i of a part among all places.
  std::size_t GetPlace(vtkIdType part, std::size_t i) const
  {
    return this->Order[this->Starts[part] + i];
  }
};

/// Tells whether a part has no crease near it that is sharp for some steps more.
template <typename Id>
class FarParts
{
public:
  FarParts(const PolygonMesh<Id>& mesh, const SharpCreases<Id>& creases)
    : Mesh(mesh)
    , Near(CollectNear(mesh, creases.Edges))
  {
  }
  bool Has(int dimension, Id part) const
  {
    const Id* ids = dimension == 2 ? this->Mesh.Vertices.data() + this->Mesh.GetFirst(part)
      : dimension == 1 ? this->Mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(part)
                       : &part;
    return std::none_of(ids, ids + (dimension == 2 ? this->Mesh.GetSize(part) : Id(dimension + 1)),
      [this](Id vertex)
      { return std::binary_search(this->Near.begin(), this->Near.end(), vertex); });
  }

private:
  const PolygonMesh<Id>& Mesh;
  const std::vector<Id> Near;
};

}

template <typename Id>
PlaceRows<Id> FindSurfacePlaces(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const std::vector<SurfacePlace<Id>>& places,
  PlaceDerivatives derivatives)
{
  const PlacesOfParts<Id> parts(places);
  const FarParts<Id> far(level.Mesh, creases);
  std::vector<PartRows<Id>> made(static_cast<std::size_t>(parts.GetNumberOfParts()));
  Buffer<Id> offsets(static_cast<vtkIdType>(places.size()) + 1);
  ForRangesOfBlocks(parts.GetNumberOfParts(),
    [&](vtkIdType begin, vtkIdType end)
    {
      PlaceDescent<Id> descent(scheme, derivatives);
      for (vtkIdType part = begin; part < end; ++part)
      {
        const std::size_t size = parts.CountPlaces(part);
        const SurfacePlace<Id>& first = places[parts.GetPlace(part, 0)];
        const auto getPlace = [&](std::size_t i) -> const auto&
        { return places[parts.GetPlace(part, i)]; };
        descent.Run(level, creases, far.Has(first.Dimension, first.Part), size, getPlace,
          made[part].Inner, made[part].Rows);
        for (std::size_t i = 0; i < size; ++i)
        {
          offsets[parts.GetPlace(part, i)] = static_cast<Id>(made[part].CountColumns(i));
        }
      }
    });
  CountsToOffsets(offsets);
  PlaceRows<Id> rows(level.Mesh.NumberOfVertices, std::move(offsets), 2, derivatives);
  ForRangesOfBlocks(parts.GetNumberOfParts(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType part = begin; part < end; ++part)
      {
        const PartRows<Id>& of = made[part];
        for (std::size_t i = 0; i < parts.CountPlaces(part); ++i)
        {
          const auto number = static_cast<vtkIdType>(parts.GetPlace(part, i));
          const SurfacePlace<Id>& place = places[number];
          const PlaceSums weights = rows.GetWeights(number);
          std::copy_n(
            of.GetColumns(i), of.CountColumns(i), rows.Columns.data() + rows.Offsets[number]);
          of.Rows.empty() ? of.Inner.Weight(place.At[0], place.At[1], place.Directions, weights)
                          : of.Rows[i].CopyWeights(weights);
        }
      }
    });
  return rows;
}

SUBDIVISION_COMPILE_FUNCTION(FindSurfacePlaces);

}
