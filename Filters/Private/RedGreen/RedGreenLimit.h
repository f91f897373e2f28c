// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenLimit.h
 * Red-green refinement and the limit of smooth subdivision: the control level, and the operator
 * that puts all vertices of a state on the limit.
 */
#ifndef SubdivisionObjects_RedGreenLimit_h
#define SubdivisionObjects_RedGreenLimit_h

#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LimitNormals.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/RedGreen/RedGreen.h"
#include "Private/Control/ControlComplex.h"

#include <array>
#include <variant>
#include <vector>

namespace subdivision
{

template <typename Id>
class RedGreenLimit
{
public:
  /// `scheme`: the scheme of the limit. False where a stamp that is trusted leads to other cells
  /// than the input has.
  bool Build(const ControlMesh& mesh, const FeatureOptions& features, StampScheme scheme,
    const Coordinates& points, const WarnFunction& warn);

  /// The limits of the control vertices.
  SparseRows<Id> GetControlRows() const;
  /// Sets the coordinates and the attribute of the control vertices, where they differ from the
  /// numbers that the criteria read; empty: they do not.
  void SetControlValues(std::vector<double>&& coordinates, std::vector<double>&& attribute)
  {
    this->ControlCoordinates = std::move(coordinates);
    this->ControlAttribute = std::move(attribute);
  }

  /// Calls act(level) for the control level, which is of the scheme of the limit.
  template <typename Act>
  void WithControl(const Act& act) const
  {
    std::visit(act, this->Control);
  }

  /// From values at the control vertices to the limits of these and of midpoints (LocalLimit.h);
  /// `hasNormals`: for normals, too.
  LocalLimit<Id> GetOperator(
    const std::vector<std::array<Id, 2>>& midpoints, bool hasNormals) const;

  /// Uses the rows of the limits at means of control vertices, which lie in one simplex: those of
  /// `means` from `first` on.
  void ForMeans(const SparseRows<Id>& means, vtkIdType first, const PointOperator::User& use) const;

  const SemiSharpStages<Id>& GetCreases() const { return this->Creases; }
  const std::vector<double>& GetControlCoordinates() const { return this->ControlCoordinates; }
  const std::vector<double>& GetControlAttribute() const { return this->ControlAttribute; }

private:
  template <typename Scheme>
  bool BuildWith(const ControlMesh& mesh, const FeatureOptions& features, const Coordinates& points,
    const WarnFunction& warn);

  std::variant<Level<Id>, TetOctLevel<Id>> Control;
  SemiSharpStages<Id> Creases;
  ControlSolids Solids;
  std::vector<double> ControlCoordinates;
  std::vector<double> ControlAttribute;
};

}

#endif
