// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PlaceLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LatticeNames.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/Limits/PlaceRows.h"
#include "Core/Solids/Limits/TetOctPlaces.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>

namespace subdivision
{
namespace
{

/// How often a simplex is split that does not become regular: errors are a part of the square of
/// its size.
constexpr int MostSplits = 24;
/// The same after all corners lie inside a tetrahedron, where the limit is a polynomial of degree
/// 5: each split divides what a polynomial of degree 4 leaves out by 32.
constexpr int SplitsInside = 6;
/// The same by the tet/oct scheme, whose limits are no polynomials: the value is linear between
/// four limits then, with an error of the square of their distance.
constexpr int SplitsOfTetOct = 22;
/// And of patches: nearer to a corner that is not regular there are few places, and parts are
/// numbered in 16 bits.
constexpr int SplitsOfPatch = 6;

/// Whether all corners of a part of a tetrahedron lie inside it.
bool IsInside(const PlaceInPart& part)
{
  const auto& carriers = part.Carriers;
  return std::all_of(carriers.begin(), carriers.end(), [](int carrier) { return carrier == 15; });
}

/// Whether the limit over a part is a polynomial, at least but for rounding. `inside`: how often a
/// part inside a tetrahedron was split.
bool IsSmall(const PlaceInPart& part, int dimension, int inside, const RegularParts& regular)
{
  const auto first = part.Carriers.begin();
  return dimension == 3
    ? inside >= SplitsInside
    : std::all_of(first, first + dimension + 1, [&](int carrier) { return regular[carrier]; });
}

/// The part of a patch with a place whose limit is one polynomial (SheetKey::Part); 0 where that is
/// too small: few parts serve nearly all places of a mesh, and rows of others are found together.
int FindPart(PlaceInPart place, int dimension, const RegularParts& regular)
{
  int part = 1;
  for (int splits = 0; !IsSmall(place, dimension, 0, regular); ++splits)
  {
    if (splits == SplitsOfPatch)
    {
      return 0;
    }
    const int child = place.FindChild(dimension);
    place.GoToChild(dimension, child);
    part = 4 * part + child;
  }
  return part;
}

/// Steps after which no semi-sharp crease is left.
template <typename Id>
int CountSharpSteps(const SemiSharpStages<Id>& creases)
{
  double most = 0.;
  for (const auto* sharpness : { &creases.Sharpness, &creases.FaceSharpness })
  {
    for (const double s : InTurn(*sharpness))
    {
      most = std::max(most, s);
    }
  }
  return static_cast<int>(std::ceil(std::min<double>(most, MostSplits)));
}

/// What the row of each place is made of. `ready`: rows that are known.
template <typename LevelType, typename Id>
std::vector<PlaceNodes<Id>> FindNodes([[maybe_unused]] const LevelType& level,
  RegularReader<LevelType>& reader, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& places, const std::vector<SolidRow<Id>>& ready,
  VertexNames<Id>& names)
{
  constexpr bool isLinear = std::is_same<SchemeOf<LevelType>, LinearScheme<Id>>::value;
  const int sharpSteps = CountSharpSteps(creases);
  [[maybe_unused]] OctPieces<Id> pieces;
  if constexpr (SchemeOf<LevelType>::Traits.HasPieces)
  {
    pieces = OctPieces<Id>(level, places);
  }
  std::vector<PlaceNodes<Id>> all;
  all.reserve(places.size());
  for (const LimitPlace<Id>& place : InTurn(places))
  {
    const int dimension = place.Dimension;
    const std::size_t number = all.size();
    PlaceNodes<Id>& nodes = all.emplace_back();
    if (number < ready.size() && !ready[number].Columns.empty())
    {
      nodes.Ready = &ready[number];
      continue;
    }
    if (isLinear)
    {
      const PlaceInPart part = StartPart(place);
      for (int i = 0; i <= dimension; ++i)
      {
        nodes.Vertices.push_back(place.Corners[i]);
        nodes.Weights.push_back(
          { { part.At[i], part.Directions[0][i], part.Directions[1][i], part.Directions[2][i] } });
      }
      continue;
    }
    if constexpr (SchemeOf<LevelType>::Traits.HasPieces)
    {
      if (dimension == 3)
      {
        const PlaceInPart part = StartPart(place);
        const Id* octahedron = pieces.Find(place.Corners);
        TetOctPlace<Id> inside = octahedron ? TetOctPlace<Id>(octahedron, place.Corners, part)
                                            : TetOctPlace<Id>(place.Corners, part);
        for (int splits = 0; splits < SplitsOfTetOct; ++splits)
        {
          inside.Split(names);
        }
        inside.Finish(names, nodes.Vertices, nodes.Weights);
        continue;
      }
    }
    const RegularSimplex<Id>& regular = reader.Find(place);
    const bool isSharp = sharpSteps > 0;
    nodes.Simplex = &regular;
    nodes.Part = !isSharp && regular.Inner.GetSize() > 0 ? 1 : 0;
    if (nodes.Part > 0)
    {
      continue;
    }
    PlaceInPart part = StartPart(place, regular);
    nodes.Part = !isSharp && regular.IsPatch ? FindPart(part, dimension, regular.Parts) : 0;
    if (nodes.Part > 0)
    {
      continue;
    }
    std::array<Id, 4> corners = regular.Corners;
    int inside = 0;
    for (int splits = 0; dimension > 0 && splits < MostSplits &&
      (splits < sharpSteps || !IsSmall(part, dimension, inside, regular.Parts));
      ++splits)
    {
      inside += dimension == 3 && IsInside(part) ? 1 : 0;
      const int child = part.FindChild(dimension);
      part.GoToChild(dimension, child);
      corners = GetCornersOfChild(corners, dimension, child, names);
    }
    nodes.Weights = WeightLattice(dimension, part.At, part.Directions);
    for (const PlaceNode& node : ListLattice(dimension))
    {
      nodes.Vertices.push_back(FindNode(corners, node, names));
    }
  }
  return all;
}

/// The largest dimension of cells with places.
template <typename Id>
int FindDimension(const std::vector<LimitPlace<Id>>& places)
{
  int dimension = 0;
  for (const LimitPlace<Id>& place : InTurn(places))
  {
    dimension = std::max(dimension, place.Dimension);
  }
  return dimension;
}

/// Makes the rows of all places, in threads.
template <typename Id>
void Combine(const SparseRows<Id>& limits, LoopWeights weights,
  const std::vector<LimitPlace<Id>>& places, const std::vector<PlaceNodes<Id>>& nodes,
  PlaceDerivatives derivatives, PlaceRows<Id>& rows)
{
  const auto size = static_cast<vtkIdType>(places.size());
  vtkSMPThreadLocal<std::shared_ptr<RowsOfPlace<Id>>> ofThreads;
  const auto forPlaces = [&](const auto& act)
  {
    ForRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::shared_ptr<RowsOfPlace<Id>>& made = ofThreads.Local();
        if (!made)
        {
          made = std::make_shared<RowsOfPlace<Id>>(limits, weights);
        }
        for (vtkIdType i = begin; i < end; ++i)
        {
          act(i, *made, made->FindColumns(nodes[i]));
        }
      });
  };
  Buffer<Id> offsets(size + 1);
  forPlaces([&](vtkIdType i, const auto&, const std::vector<Id>& columns)
    { offsets[i] = static_cast<Id>(columns.size()); });
  CountsToOffsets(offsets);
  rows =
    PlaceRows<Id>(limits.NumberOfColumns, std::move(offsets), FindDimension(places), derivatives);
  forPlaces(
    [&](vtkIdType i, auto& made, const std::vector<Id>& columns)
    {
      std::copy(columns.begin(), columns.end(), rows.Columns.begin() + rows.Offsets[i]);
      made.Sum(places[i], nodes[i], rows.GetWeights(i));
    });
}

/// The order of corners only matters where tetrahedra are split: all other places get that of who
/// asks. Returns `asked` itself if they have it, else `ordered`.
template <typename Id>
const std::vector<LimitPlace<Id>>& OrderCorners(
  const std::vector<LimitPlace<Id>>& asked, std::vector<LimitPlace<Id>>& ordered)
{
  const std::array<int, 4> own = LimitPlace<Id>().Order;
  const auto isOrdered = [&own](const LimitPlace<Id>& place)
  {
    const auto* order = place.Order.data();
    return place.Dimension == 3 || std::equal(order, order + place.Dimension + 1, own.data());
  };
  if (std::all_of(asked.begin(), asked.end(), isOrdered))
  {
    return asked;
  }
  ordered = asked;
  for (LimitPlace<Id>& place : InTurn(ordered))
  {
    const LimitPlace<Id> old = place;
    for (int i = 0; place.Dimension < 3 && i <= place.Dimension; ++i)
    {
      place.Corners[i] = old.Corners[old.Order[i]];
      place.Order[i] = i;
    }
  }
  return ordered;
}

/// The limits of all vertices of a level where nothing moves.
template <typename Id>
SparseRows<Id> MakeRowsThatStay(Id vertices)
{
  SparseRows<Id> rows;
  rows.NumberOfColumns = vertices;
  rows.Offsets = Buffer<Id>(vtkIdType(vertices) + 1);
  rows.Columns = Buffer<Id>(vertices);
  rows.Weights = Buffer<double>(vertices, 1.);
  ForEach(vertices, [&](vtkIdType v) { rows.Offsets[v] = rows.Columns[v] = static_cast<Id>(v); });
  rows.Offsets[vertices] = vertices;
  return rows;
}

}

template <typename Id>
template <typename LevelType>
PlaceLimits<Id>::PlaceLimits(const LevelType& level, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& asked, PlaceDerivatives derivatives)
{
  std::vector<LimitPlace<Id>> ordered;
  const std::vector<LimitPlace<Id>>& places = OrderCorners(asked, ordered);
  const Id vertices = level.Complex.NumberOfVertices;
  VertexNames<Id> names(vertices);
  RegularReader<LevelType> reader(level, places);
  std::vector<SolidRow<Id>> ready;
  if constexpr (!std::is_same<SchemeOf<LevelType>, LinearScheme<Id>>::value)
  {
    if (FindDimension(places) == 3)
    {
      ready = FindSolidRows(level, creases, places);
    }
  }
  const std::vector<PlaceNodes<Id>> nodes = FindNodes(level, reader, creases, places, ready, names);
  if constexpr (std::is_same<SchemeOf<LevelType>, LinearScheme<Id>>::value)
  {
    Combine(
      MakeRowsThatStay(vertices), reader.GetWeights(), places, nodes, derivatives, this->Rows);
  }
  else
  {
    Buffer<unsigned char> wanted(vertices + static_cast<vtkIdType>(names.GetMidpoints().size()), 0);
    for (const PlaceNodes<Id>& place : InTurn(nodes))
    {
      for (const Id vertex : place.Vertices)
      {
        wanted[vertex] = 1;
      }
    }
    Combine(LocalLimit<Id>(level, creases, names.GetMidpoints(), wanted).BuildRows(),
      reader.GetWeights(), places, nodes, derivatives, this->Rows);
  }
}

SUBDIVISION_COMPILE(struct PlaceLimits);
#define SUBDIVISION_PLACES(Scheme)                                                                 \
  template PlaceLimits<Scheme::Id>::PlaceLimits(const Scheme::Level&,                              \
    const SemiSharpStages<Scheme::Id>&, const std::vector<LimitPlace<Scheme::Id>>&,                \
    PlaceDerivatives)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_PLACES);

}
