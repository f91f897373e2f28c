// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenLimit.h"

#include "Core/Memory/Ids.h"

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

SUBDIVISION_COMPILE(class RedGreenLimit);

}
