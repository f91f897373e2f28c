// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PlaceLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LatticeNames.h"
#include "Core/Solids/Limits/LocalLattice.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/Limits/PatchPolynomials.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/RegularParts.h"
#include "Core/Solids/Limits/SolidPlaces.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>

namespace subdivision
{
namespace
{

/// The terms of the row of a place: a part of a patch, or nodes with their weights.
template <typename Id>
struct PlaceNodes
{
  std::vector<Id> Vertices;
  std::vector<std::array<double, PlaceParts::Count>> Weights;
  int Part = 0;                                ///< SheetKey::Part; 0: there are nodes
  const RegularSimplex<Id>* Simplex = nullptr; ///< in which the part is
};

/// The rows of a place over the columns that they have.
template <typename Id>
class RowsOfPlace
{
public:
  explicit RowsOfPlace(LoopWeights weights)
    : Polynomials(weights)
  {
  }

  /// Finds the columns, ascending. `ready`: the row of a place that has nodes. Consecutive places
  /// often have the same patch, which is read once then.
  const std::vector<Id>& FindColumns(const PlaceNodes<Id>& nodes, const PlaceRow<Id>& ready)
  {
    if (nodes.Part == 0)
    {
      return ready.Columns;
    }
    this->ReadPatch(nodes);
    return this->Columns;
  }
  /// The sums of what FindColumns read last: one weight for each column.
  void Sum(const LimitPlace<Id>& place, const PlaceNodes<Id>& nodes, const PlaceRow<Id>& ready,
    const PlaceSums& sums)
  {
    if (nodes.Part == 0)
    {
      ready.CopyWeights(sums);
      return;
    }
    if (IsInner(nodes))
    {
      constexpr PatchDirections along{ { { { 1., 0. } }, { { 0., 1. } } } };
      nodes.Simplex->Inner.Weight(place.Parameters[0], place.Parameters[1], along, sums);
      return;
    }
    if (this->Weights.empty())
    {
      this->WeightPatch();
    }
    const PlaceInPart part =
      GoToPart(place.Dimension, StartPart(place, *nodes.Simplex), nodes.Part);
    const CornerWeights& first = part.Directions[0];
    const CornerWeights& second = part.Directions[1];
    const PatchParts powers = FindPatchPowers(PatchPowers::Quartic, part.At[1], part.At[2],
      { { { { first[1], second[1] } }, { { first[2], second[2] } } } });
    SumPowers(PatchPowers::Quartic, powers, this->Weights.data(), this->Columns.size(), sums);
  }

private:
  /// Whether a place lies in a triangle that needs no polynomial of its own.
  static bool IsInner(const PlaceNodes<Id>& nodes)
  {
    return nodes.Part == 1 && nodes.Simplex->Inner.GetSize() > 0;
  }
  void SortColumns()
  {
    std::sort(this->Columns.begin(), this->Columns.end());
    this->Columns.erase(
      std::unique(this->Columns.begin(), this->Columns.end()), this->Columns.end());
  }
  std::size_t FindPlace(Id column) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(this->Columns.begin(), this->Columns.end(), column) - this->Columns.begin());
  }

  void ReadPatch(const PlaceNodes<Id>& nodes)
  {
    if (this->Part == nodes.Part && this->Simplex == nodes.Simplex)
    {
      return;
    }
    this->Part = nodes.Part;
    this->Simplex = nodes.Simplex;
    this->Weights.clear();
    if (IsInner(nodes))
    {
      this->Columns.assign(this->Simplex->Inner.begin(), this->Simplex->Inner.end());
      return;
    }
    this->Columns = this->Simplex->Patch.Columns;
    this->SortColumns();
  }
  void WeightPatch()
  {
    SheetKey key = this->Simplex->Patch.Key;
    key.Part = static_cast<std::uint16_t>(this->Part);
    const std::vector<double>& polynomials = this->Polynomials.Find(key);
    const std::vector<Id>& columns = this->Simplex->Patch.Columns;
    this->Weights.assign(QuarticPowers * this->Columns.size(), 0.);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      const std::size_t to = this->FindPlace(columns[c]);
      for (std::size_t p = 0; p < QuarticPowers; ++p)
      {
        this->Weights[p * this->Columns.size() + to] += polynomials[p * columns.size() + c];
      }
    }
  }

  PatchPolynomials Polynomials;
  const RegularSimplex<Id>* Simplex = nullptr; ///< whose patch was read last
  int Part = 0;                                ///< of that patch; 0: none was read
  std::vector<Id> Columns;
  std::vector<double> Weights; ///< of all columns for the first power, for the second, ...
};

/// How often patches are split: nearer to a corner that is not regular there are few places, and
/// parts are numbered in 16 bits.
constexpr int SplitsOfPatch = 6;

/// Whether the limit over a part is one polynomial.
bool IsRegular(const PlaceInPart& part, int dimension, const RegularParts& regular)
{
  const auto first = part.Carriers.begin();
  return std::all_of(
    first, first + dimension + 1, [&regular](int carrier) { return regular[carrier]; });
}

/// Decides how often the simplex of a place is split whose limit is no polynomial: what matters is
/// how small the part is beside its distance from where the limit is not smooth, so splits count
/// from the last one on after which the part has its corners between others of the simplex.
class SplitCount
{
public:
  SplitCount(const PlaceInPart& part, int dimension)
    : Dimension(dimension)
    , Carriers(this->FlagCarriers(part))
  {
  }

  void Add(const PlaceInPart& part)
  {
    const unsigned int carriers = this->FlagCarriers(part);
    this->Splits = carriers == this->Carriers ? this->Splits + 1 : 0;
    this->Carriers = carriers;
  }
  bool IsEnough() const { return this->Splits >= MostSplits; }

private:
  unsigned int FlagCarriers(const PlaceInPart& part) const
  {
    unsigned int flags = 0;
    for (int i = 0; i <= this->Dimension; ++i)
    {
      flags |= 1u << static_cast<unsigned int>(part.Carriers[i]);
    }
    return flags;
  }

  const int Dimension;
  unsigned int Carriers; ///< a bit for each set of corners between which the part has some
  int Splits = 0;
};

/// Takes the linear function between the corners of a part.
template <typename Id>
void TakeCorners(
  int dimension, const PlaceInPart& part, const std::array<Id, 4>& corners, PlaceNodes<Id>& nodes)
{
  for (int i = 0; i <= dimension; ++i)
  {
    nodes.Vertices.push_back(corners[i]);
    nodes.Weights.push_back(
      { { part.At[i], part.Directions[0][i], part.Directions[1][i], part.Directions[2][i] } });
  }
}

/// The part of a patch with a place whose limit is one polynomial (SheetKey::Part); 0 where that is
/// too small: few parts serve nearly all places of a mesh, and rows of others are found together.
int FindPart(PlaceInPart place, int dimension, const RegularParts& regular)
{
  int part = 1;
  for (int splits = 0; !IsRegular(place, dimension, regular); ++splits)
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

/// The control vertices at which something depends on what is semi-sharp; empty: there are none.
/// The limit over a simplex none of whose corners is one of them is what it is where nothing is
/// sharp: on all levels it reads rows of what lies at its corners.
template <typename Id>
Buffer<unsigned char> FlagSharpVertices(
  const SimplicialComplex<Id>& complex, const SharpSimplices<Id>& sharp)
{
  Buffer<unsigned char> flags(sharp.IsEmpty() ? 0 : complex.NumberOfVertices, 0);
  const auto flag = [&](int dimension, const Buffer<Id>& corners)
  {
    for (const vtkIdType i : InTurn(corners.size()))
    {
      flags[corners[i]] |= sharp.Has(dimension, static_cast<Id>(i / (dimension + 1))) ? 1 : 0;
    }
  };
  for (const Id v : InTurn(static_cast<Id>(flags.size())))
  {
    flags[v] = sharp.Has(0, v) ? 1 : 0;
  }
  if (!flags.empty())
  {
    flag(1, complex.EdgeVertices);
    flag(2, complex.FaceVertices);
  }
  return flags;
}

/// Splits a curve or triangle around a place `sharpSteps` times, and on until the part is regular
/// or so small that the limit is linear. Its nodes are those of a polynomial then, or its corners.
template <typename Id>
void SplitToNodes(const RegularSimplex<Id>& simplex, PlaceInPart part, int dimension,
  int sharpSteps, bool hasDerivatives, VertexNames<Id>& names, PlaceNodes<Id>& nodes)
{
  std::array<Id, 4> corners = simplex.Corners;
  const auto isRegular = [&]() { return IsRegular(part, dimension, simplex.Parts); };
  // At a corner of a part the limit is that of a vertex, but for its derivatives.
  const auto isAtCorner = [&]()
  { return !hasDerivatives && std::find(part.At.begin(), part.At.end(), 1.) != part.At.end(); };
  SplitCount count(part, dimension);
  for (int sharp = sharpSteps; !isAtCorner() && (sharp > 0 || (!isRegular() && !count.IsEnough()));
    --sharp)
  {
    const int child = part.FindChild(dimension);
    part.GoToChild(dimension, child);
    corners = GetCornersOfChild(corners, dimension, child, names);
    count.Add(part);
  }
  if (isAtCorner() || !isRegular())
  {
    TakeCorners(dimension, part, corners, nodes);
    return;
  }
  nodes.Weights = WeightLattice(dimension, part.At, part.Directions);
  for (const PlaceNode& node : ListLattice(dimension))
  {
    nodes.Vertices.push_back(FindNode(corners, node, names));
  }
}

/// What the row of each place is made of. `ready`: rows that are known.
template <typename LevelType, typename Id>
std::vector<PlaceNodes<Id>> FindNodes(const LevelType& level, RegularReader<LevelType>& reader,
  const SharpSimplices<Id>& sharp, const std::vector<LimitPlace<Id>>& places,
  const std::vector<PlaceRow<Id>>& ready, bool hasDerivatives, VertexNames<Id>& names)
{
  constexpr bool isLinear = std::is_same<SchemeOf<LevelType>, LinearScheme<Id>>::value;
  const int sharpSteps = CountSharpSteps(sharp.GetCreases());
  const Buffer<unsigned char> isSharpAt = FlagSharpVertices(level.Complex, sharp);
  std::vector<PlaceNodes<Id>> all;
  all.reserve(places.size());
  for (const LimitPlace<Id>& place : InTurn(places))
  {
    const int dimension = place.Dimension;
    const std::size_t number = all.size();
    PlaceNodes<Id>& nodes = all.emplace_back();
    if (!ready[number].Columns.empty())
    {
      continue;
    }
    if (isLinear || dimension == 0)
    {
      TakeCorners(dimension, StartPart(place), place.Corners, nodes);
      continue;
    }
    if (dimension == 3)
    {
      continue; // all that is known is ready
    }
    const RegularSimplex<Id>& regular = reader.Find(place);
    const Id* ids = place.Corners.data();
    const bool isSharp = !isSharpAt.empty() &&
      std::any_of(ids, ids + dimension + 1, [&](Id v) { return isSharpAt[v] != 0; });
    nodes.Simplex = &regular;
    nodes.Part = !isSharp && regular.Inner.GetSize() > 0 ? 1 : 0;
    if (nodes.Part > 0)
    {
      continue;
    }
    const PlaceInPart part = StartPart(place, regular);
    nodes.Part = !isSharp && regular.IsPatch ? FindPart(part, dimension, regular.Parts) : 0;
    if (nodes.Part > 0)
    {
      continue;
    }
    SplitToNodes(regular, part, dimension, isSharp ? sharpSteps : 0, hasDerivatives, names, nodes);
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

/// Sums rows of nodes, of one place after the other.
template <typename Id>
class NodeSum
{
public:
  explicit NodeSum(const LocalLimit<Id>& limit)
    : Lattice(limit)
  {
  }

  void Find(const PlaceNodes<Id>& nodes, PlaceRow<Id>& row)
  {
    this->Sum.Clear();
    for (std::size_t n = 0; n < nodes.Vertices.size(); ++n)
    {
      this->Sum.AddLimit(nodes.Vertices[n], nodes.Weights[n]);
    }
    this->Sum.StepBack(this->Lattice.GetLevel(nodes.Vertices[0]) + 1);
    this->Sum.Write(row);
  }

private:
  LocalLattice<Id> Lattice;
  PlaceSum<LocalLattice<Id>> Sum{ this->Lattice };
};

/// Makes the rows of places that have nodes.
template <typename LevelType, typename Id>
void SumNodes(const LevelType& level, const SemiSharpStages<Id>& creases,
  const VertexNames<Id>& names, const std::vector<PlaceNodes<Id>>& nodes,
  std::vector<PlaceRow<Id>>& rows)
{
  const std::vector<std::array<Id, 2>>& midpoints = names.GetMidpoints();
  Buffer<unsigned char> wanted(
    level.Complex.NumberOfVertices + static_cast<vtkIdType>(midpoints.size()), 0);
  for (const PlaceNodes<Id>& place : InTurn(nodes))
  {
    for (const Id vertex : place.Vertices)
    {
      wanted[vertex] = 1;
    }
  }
  const LocalLimit<Id> limit(level, creases, midpoints, wanted);
  ForPlacesInThreads(
    nodes.size(), [&]() { return std::make_shared<NodeSum<Id>>(limit); },
    [&](NodeSum<Id>& sum, std::size_t i)
    { nodes[i].Vertices.empty() ? void() : sum.Find(nodes[i], rows[i]); });
}

/// The same where nothing moves: nodes are control vertices.
template <typename Id>
void TakeNodes(const std::vector<PlaceNodes<Id>>& nodes, std::vector<PlaceRow<Id>>& rows)
{
  for (const std::size_t i : InTurn(nodes.size()))
  {
    std::map<Id, PartWeights> columns;
    for (std::size_t n = 0; n < nodes[i].Vertices.size(); ++n)
    {
      columns[nodes[i].Vertices[n]] = nodes[i].Weights[n];
    }
    for (const auto& [column, weights] : columns)
    {
      rows[i].Columns.push_back(column);
      rows[i].Weights.push_back(weights);
    }
  }
}

/// Puts the rows of all places together, in threads.
template <typename Id>
void Combine(LoopWeights weights, const std::vector<LimitPlace<Id>>& places,
  const std::vector<PlaceNodes<Id>>& nodes, const std::vector<PlaceRow<Id>>& ready,
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
          made = std::make_shared<RowsOfPlace<Id>>(weights);
        }
        for (vtkIdType i = begin; i < end; ++i)
        {
          act(i, *made, made->FindColumns(nodes[i], ready[i]));
        }
      });
  };
  Buffer<Id> offsets(size + 1);
  forPlaces([&](vtkIdType i, const auto&, const std::vector<Id>& columns)
    { offsets[i] = static_cast<Id>(columns.size()); });
  CountsToOffsets(offsets);
  rows =
    PlaceRows<Id>(rows.NumberOfColumns, std::move(offsets), FindDimension(places), derivatives);
  forPlaces(
    [&](vtkIdType i, auto& made, const std::vector<Id>& columns)
    {
      std::copy(columns.begin(), columns.end(), rows.Columns.begin() + rows.Offsets[i]);
      made.Sum(places[i], nodes[i], ready[i], rows.GetWeights(i));
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

}

template <typename Id>
template <typename LevelType>
PlaceLimits<Id>::PlaceLimits(const LevelType& level, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& asked, PlaceDerivatives derivatives)
{
  std::vector<LimitPlace<Id>> ordered;
  const std::vector<LimitPlace<Id>>& places = OrderCorners(asked, ordered);
  constexpr bool isLinear = std::is_same<SchemeOf<LevelType>, LinearScheme<Id>>::value;
  VertexNames<Id> names(level.Complex.NumberOfVertices);
  RegularReader<LevelType> reader(level, places);
  std::vector<PlaceRow<Id>> ready(places.size());
  const LevelLattices<LevelType> lattices(level, creases);
  if constexpr (!isLinear)
  {
    if (FindDimension(places) == 3)
    {
      ready = FindSolidRows(level, lattices, places);
    }
  }
  const std::vector<PlaceNodes<Id>> nodes = FindNodes(level, reader, lattices.GetSharp(), places,
    ready, derivatives != PlaceDerivatives::None, names);
  if constexpr (isLinear)
  {
    TakeNodes(nodes, ready);
  }
  else
  {
    SumNodes(level, creases, names, nodes, ready);
  }
  this->Rows.NumberOfColumns = level.Complex.NumberOfVertices;
  Combine(reader.GetWeights(), places, nodes, ready, derivatives, this->Rows);
}

SUBDIVISION_COMPILE(struct PlaceLimits);
#define SUBDIVISION_PLACES(Scheme)                                                                 \
  template PlaceLimits<Scheme::Id>::PlaceLimits(const Scheme::Level&,                              \
    const SemiSharpStages<Scheme::Id>&, const std::vector<LimitPlace<Scheme::Id>>&,                \
    PlaceDerivatives)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_PLACES);

}
