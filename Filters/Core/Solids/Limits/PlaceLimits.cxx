// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PlaceLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/CurvedPlaces.h"
#include "Core/Solids/Limits/PatchPolynomials.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/RegularParts.h"
#include "Core/Solids/Limits/SolidPlaces.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace subdivision
{
namespace
{

/// The part of a patch in which a place lies.
template <typename Id>
struct PlaceInPatch
{
  int Part = 0;                                ///< SheetKey::Part; 0: the row is known
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

  /// Finds the columns, ascending. `ready`: the row, if it is known. Consecutive places
  /// often have the same patch, which is read once then.
  const std::vector<Id>& FindColumns(const PlaceInPatch<Id>& patch, const PlaceRow<Id>& ready)
  {
    if (patch.Part == 0)
    {
      return ready.Columns;
    }
    this->ReadPatch(patch);
    return this->Columns;
  }
  /// The sums of the rows that FindColumns read last: one weight for each column.
  void Sum(const LimitPlace<Id>& place, const PlaceInPatch<Id>& patch, const PlaceRow<Id>& ready,
    const PlaceSums& sums)
  {
    if (patch.Part == 0)
    {
      ready.CopyWeights(sums);
      return;
    }
    if (IsInner(patch))
    {
      constexpr PatchDirections along{ { { { 1., 0. } }, { { 0., 1. } } } };
      patch.Simplex->Inner.Weight(place.Parameters[0], place.Parameters[1], along, sums);
      return;
    }
    if (this->Weights.empty())
    {
      this->WeightPatch();
    }
    const PlaceInPart part =
      GoToPart(place.Dimension, StartPart(place, *patch.Simplex), patch.Part);
    const CornerWeights& first = part.Directions[0];
    const CornerWeights& second = part.Directions[1];
    const PatchParts powers = FindPatchPowers(PatchPowers::Quartic, part.At[1], part.At[2],
      { { { { first[1], second[1] } }, { { first[2], second[2] } } } });
    SumPowers(PatchPowers::Quartic, powers, this->Weights.data(), this->Columns.size(), sums);
  }

private:
  /// Whether a place lies in a triangle that needs no polynomial of its own.
  static bool IsInner(const PlaceInPatch<Id>& patch)
  {
    return patch.Part == 1 && patch.Simplex->Inner.GetSize() > 0;
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

  void ReadPatch(const PlaceInPatch<Id>& patch)
  {
    if (this->Part == patch.Part && this->Simplex == patch.Simplex)
    {
      return;
    }
    this->Part = patch.Part;
    this->Simplex = patch.Simplex;
    this->Weights.clear();
    if (IsInner(patch))
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

/// Finds in which parts of patches places lie, and makes the rows of all others. `ready`: rows that
/// are known.
template <typename LevelType, typename Id>
std::vector<PlaceInPatch<Id>> FindPatches(const LevelLattices<LevelType>& lattices,
  const LevelType& level, RegularReader<LevelType>& reader,
  const std::vector<LimitPlace<Id>>& places, bool hasDerivatives, std::vector<PlaceRow<Id>>& ready)
{
  const SharpSimplices<Id>& sharp = lattices.GetSharp();
  const int sharpSteps = CountSharpSteps(sharp.GetCreases());
  const Buffer<unsigned char> isSharpAt = FlagSharpVertices(level.Complex, sharp);
  const auto isSharp = [&isSharpAt](const LimitPlace<Id>& place)
  {
    const Id* ids = place.Corners.data();
    return !isSharpAt.empty() && place.Dimension > 0 &&
      std::any_of(ids, ids + place.Dimension + 1, [&](Id v) { return isSharpAt[v] != 0; });
  };
  std::vector<PlaceInPatch<Id>> all(places.size());
  for (const std::size_t i : InTurn(places.size()))
  {
    const int dimension = places[i].Dimension;
    if (dimension == 3)
    {
      continue; // all that is known is ready
    }
    const RegularSimplex<Id>& regular = reader.Find(places[i]);
    if (regular.Number < 0)
    {
      throw std::invalid_argument("A place lies in no cell.");
    }
    all[i].Simplex = &regular;
    if (!isSharp(places[i]))
    {
      all[i].Part = regular.Inner.GetSize() > 0 ? 1
        : regular.IsPatch ? FindPart(StartPart(places[i], regular), dimension, regular.Parts)
                          : 0;
    }
  }
  ForPlacesInThreads(
    places.size(),
    [&]() { return std::make_shared<PlaceFinder<LevelType>>(level, lattices, hasDerivatives); },
    [&](PlaceFinder<LevelType>& finder, std::size_t i)
    {
      if (all[i].Simplex && all[i].Part == 0)
      {
        finder.Find(places[i], *all[i].Simplex, isSharp(places[i]) ? sharpSteps : 0, ready[i]);
      }
    });
  return all;
}

/// The same where nothing moves: rows have the corners of cells.
template <typename Id>
std::vector<PlaceRow<Id>> FindLinear(const std::vector<LimitPlace<Id>>& places)
{
  std::vector<PlaceRow<Id>> rows(places.size());
  for (const std::size_t i : InTurn(places.size()))
  {
    const PlaceInPart part = StartPart(places[i]);
    std::map<Id, PartWeights> columns;
    for (int k = 0; k <= places[i].Dimension; ++k)
    {
      const auto& directions = part.Directions;
      columns[places[i].Corners[k]] = { { part.At[k], directions[0][k], directions[1][k],
        directions[2][k] } };
    }
    for (const auto& [column, weights] : columns)
    {
      rows[i].Columns.push_back(column);
      rows[i].Weights.push_back(weights);
    }
  }
  return rows;
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

/// Puts the rows of all places together, in threads.
template <typename Id>
void Combine(LoopWeights weights, const std::vector<LimitPlace<Id>>& places,
  const std::vector<PlaceInPatch<Id>>& patches, const std::vector<PlaceRow<Id>>& ready,
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
          act(i, *made, made->FindColumns(patches[i], ready[i]));
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
      made.Sum(places[i], patches[i], ready[i], rows.GetWeights(i));
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
  RegularReader<LevelType> reader(level, places);
  std::vector<PlaceRow<Id>> ready(places.size());
  std::vector<PlaceInPatch<Id>> patches(places.size());
  if constexpr (std::is_same<SchemeOf<LevelType>, LinearScheme<Id>>::value)
  {
    ready = FindLinear(places);
  }
  else
  {
    const LevelLattices<LevelType> lattices(level, creases);
    if (FindDimension(places) == 3)
    {
      ready = FindSolidRows(level, lattices, places);
    }
    patches =
      FindPatches(lattices, level, reader, places, derivatives != PlaceDerivatives::None, ready);
  }
  this->Rows.NumberOfColumns = level.Complex.NumberOfVertices;
  Combine(reader.GetWeights(), places, patches, ready, derivatives, this->Rows);
}

SUBDIVISION_COMPILE(struct PlaceLimits);
#define SUBDIVISION_PLACES(Scheme)                                                                 \
  template PlaceLimits<Scheme::Id>::PlaceLimits(const Scheme::Level&,                              \
    const SemiSharpStages<Scheme::Id>&, const std::vector<LimitPlace<Scheme::Id>>&,                \
    PlaceDerivatives)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_PLACES);

}
