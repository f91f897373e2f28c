// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenLimit.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/PairTable.h"
#include "Core/Operators/ForBlocks.h"
#include "Core/Solids/Limits/PlaceLimits.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
bool RedGreenLimit<Id>::Build(const ControlMesh& mesh, const FeatureOptions& features,
  StampScheme scheme, const Coordinates& points, const WarnFunction& warn)
{
  return scheme == StampScheme::TetOct
    ? this->template BuildWith<TetOctScheme<Id>>(mesh, features, points, warn)
    : this->template BuildWith<BoxSplineScheme<Id>>(mesh, features, points, warn);
}

template <typename Id>
template <typename Scheme>
bool RedGreenLimit<Id>::BuildWith(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn)
{
  ControlComplex<Id> control;
  typename Scheme::Level level;
  if (!BuildControlComplex<Scheme>(
        mesh, features, points, warn, Depth::ForRefinement, control, level))
  {
    return false;
  }
  this->Solids.Numbers = std::move(control.Solids);
  this->Solids.Steps = mesh.MadeLevels;
  this->Creases = BuildSharpStages<Scheme>(mesh, features, control, 0);
  this->Control = std::move(level);
  return true;
}

template <typename Id>
SparseRows<Id> RedGreenLimit<Id>::GetControlRows() const
{
  return std::visit(
    [this](const auto& control) { return BuildLimitRows(control, this->Creases); }, this->Control);
}

template <typename Id>
LocalLimit<Id> RedGreenLimit<Id>::GetOperator(
  const std::vector<std::array<Id, 2>>& midpoints, bool hasNormals) const
{
  return std::visit(
    [&](const auto& control)
    {
      return LocalLimit<Id>(
        control, this->Creases, midpoints, hasNormals ? &this->Solids : nullptr);
    },
    this->Control);
}

namespace
{

template <typename Id>
void FindPieces(const Level<Id>&, std::vector<LimitPlace<Id>>&)
{
}
/// Faces and edges on a diagonal of an octahedron are none of the complex: such places get a piece
/// around it.
template <typename Id>
void FindPieces(const TetOctLevel<Id>& level, std::vector<LimitPlace<Id>>& places)
{
  PairTable<Id> diagonals;
  const Id* const octs = level.OctVertices.data();
  for (const vtkIdType d : InTurn(level.OctVertices.size() / 2))
  {
    diagonals.FindOrAdd(octs[2 * d], octs[2 * d + 1], static_cast<Id>(d));
  }
  for (LimitPlace<Id>& place : InTurn(places))
  {
    const int corners = place.Dimension + 1;
    for (int pair = 0; corners < 4 && pair < 3; ++pair)
    {
      const Id first = place.Corners[pair == 2 ? 1 : 0];
      const Id second = place.Corners[pair == 0 ? 1 : 2];
      const Id diagonal = first < 0 || second < 0 ? -1 : diagonals.Find(first, second);
      if (diagonal < 0)
      {
        continue;
      }
      const Id* oct = octs + diagonal / 3 * 6;
      const auto isCorner = [&](Id v)
      { return std::find(place.Corners.begin(), place.Corners.end(), v) != place.Corners.end(); };
      for (int axis = 1; axis < 3; ++axis)
      {
        const Id* const ends = oct + (diagonal % 3 + axis) % 3 * 2;
        isCorner(ends[0]) || isCorner(ends[1]) ? void()
                                               : void(place.Corners[++place.Dimension] = ends[0]);
      }
      break;
    }
  }
}

}

template <typename Id>
void RedGreenLimit<Id>::ForMeans(
  const SparseRows<Id>& means, vtkIdType first, const PointOperator::User& use) const
{
  std::vector<LimitPlace<Id>> places;
  for (vtkIdType row = first; row < means.GetNumberOfRows(); ++row)
  {
    LimitPlace<Id> place;
    const vtkIdType begin = means.Offsets[row];
    place.Dimension = static_cast<int>(means.Offsets[row + 1] - begin) - 1;
    std::copy_n(means.Columns.data() + begin, place.Dimension + 1, place.Corners.begin());
    std::copy_n(means.Weights.data() + begin + 1, place.Dimension, place.Parameters.begin());
    places.push_back(place);
  }
  this->WithControl(
    [&](const auto& control)
    {
      FindPieces(control, places);
      ForPartsOfPlaces(control, this->Creases, places, PlaceDerivatives::None,
        [&](vtkIdType begin, const PlaceLimits<Id>& limits)
        {
          WeightedRows<Id> rows =
            limits.Rows.GetRows(PlaceParts::Value, 0, limits.Rows.GetNumberOfPlaces());
          rows.FirstRow = means.NumberOfColumns + first + begin;
          use(rows);
        });
    });
}

SUBDIVISION_COMPILE(class RedGreenLimit);

}
