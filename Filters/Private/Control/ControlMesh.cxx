// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/ControlMesh.h"

#include "Core/Memory/Loops.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Run/StampFields.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace subdivision
{
namespace
{

/// The global ids of points; empty where they cannot be used, so that the index takes their place.
std::vector<vtkIdType> ReadGlobalIds(
  vtkDataArray* ids, vtkIdType points, const std::function<void(const std::string&)>& warn)
{
  std::vector<vtkIdType> values;
  if (ids && (ids->GetNumberOfComponents() != 1 || ids->GetNumberOfTuples() > points))
  {
    warn("The global ids have " + std::to_string(ids->GetNumberOfTuples()) + " tuples of " +
      std::to_string(ids->GetNumberOfComponents()) + " components for " + std::to_string(points) +
      " points: the filter uses the point ids instead.");
  }
  else if (ids)
  {
    values.resize(ids->GetNumberOfTuples());
    vtkIdTypeArray* exact = vtkIdTypeArray::SafeDownCast(ids);
    for (const vtkIdType i : InTurn(ids->GetNumberOfTuples()))
    {
      values[i] = exact ? exact->GetValue(i) : ToId(ids->GetComponent(i, 0));
    }
  }
  return values;
}

/// Lifts tuples of points from a refined level to the control level, where the tuples are the
/// children of simplices. Returns false where they are not.
bool LiftTuples(const SharpTuples& tuples, const Stamp& stamp, SharpTuples& lifted)
{
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    SimplexList fine;
    fine.Connectivity = tuples.Tuples.Tuples[dimension];
    fine.Dimensions.assign(
      fine.Connectivity.size() / (dimension + 1), static_cast<unsigned char>(dimension));
    SimplexList coarse;
    if (!FindControlMesh(SimplexView(fine), stamp, coarse))
    {
      return false;
    }
    lifted.Tuples.Tuples[dimension] = coarse.Connectivity;
  }
  for (int dimension = 1; dimension < 3; ++dimension)
  {
    const std::size_t children = std::size_t(1) << (dimension * stamp.Levels);
    for (std::size_t i = 0; i < tuples.Sharpness[dimension].size(); i += children)
    {
      lifted.Sharpness[dimension].push_back(tuples.Sharpness[dimension][i]);
    }
  }
  return true;
}

/// The inverted and flat control simplices that an earlier filter found, as FindInvertedTets gives
/// them.
std::vector<vtkIdType> ReadInverted(vtkPointSet* input, const SimplexList& control)
{
  std::vector<vtkIdType> inverted;
  for (vtkIdType simplex : ReadFieldIds(InvertedCellsName, input->GetFieldData()))
  {
    if (simplex >= 0 && simplex / 2 < control.GetNumberOfSimplices() &&
      (inverted.empty() || simplex > inverted.back()))
    {
      inverted.push_back(simplex);
    }
  }
  return inverted;
}

/// Whether a volume scheme made the input, but not this one.
bool IsOfOtherScheme(vtkPointSet* input, StampScheme scheme)
{
  bool found = false;
  ForVolumeSchemes<int>(
    [&](auto any)
    {
      const auto other = static_cast<StampScheme>(decltype(any)::Traits.Number);
      Stamp ignored;
      found = found || (other != scheme && ReadStamp(input, other, ignored));
    });
  return found;
}

}

ControlMesh ReadControlMesh(vtkPointSet* input, bool trustStamp, const FeatureOptions& features,
  StampScheme scheme, PlainIds ids)
{
  ControlMesh mesh;
  auto warn = [&mesh](const std::string& warning) { mesh.Warnings.push_back(warning); };
  Stamp stamp;
  mesh.IsStamped = trustStamp && ReadStamp(input, scheme, stamp);
  mesh.IsOfOtherScheme = trustStamp && !mesh.IsStamped && IsOfOtherScheme(input, scheme);
  vtkDataArray* carried = FindField(GlobalIdsName, input->GetFieldData());
  vtkDataArray* own = input->GetPointData()->GetGlobalIds();
  if (own && own->GetNumberOfTuples() < input->GetNumberOfPoints())
  {
    warn("There are " + std::to_string(own->GetNumberOfTuples()) + " global ids for " +
      std::to_string(input->GetNumberOfPoints()) +
      " points: the filter uses the point ids instead.");
    own = nullptr;
  }
  const bool isOurs =
    mesh.IsStamped || (trustStamp && ReadStamp(input, StampScheme::RedGreen, stamp));
  const bool useCarried = isOurs && carried;
  mesh.GlobalIds = ReadGlobalIds(useCarried ? carried : own, input->GetNumberOfPoints(), warn);
  mesh.Cells = CellsToSimplices(input, mesh.IsStamped ? nullptr : mesh.GetGlobalIds(), ids);
  const bool whole = mesh.Cells.ParentCells.empty() && mesh.Cells.Warnings.empty() &&
    mesh.Cells.Simplices.GetNumberOfSimplices() == input->GetNumberOfCells();
  if (mesh.IsStamped && !whole)
  {
    return ReadControlMesh(input, false, features, scheme, ids);
  }
  mesh.Warnings.insert(mesh.Warnings.end(), mesh.Cells.Warnings.begin(), mesh.Cells.Warnings.end());
  mesh.Values = ReadFeatureValues(features, mesh.Cells, warn);
  const SharpTuples marked = FindMarkedSimplices(input, mesh.Cells, features.Marks, warn);
  if (!mesh.IsStamped)
  {
    mesh.Derived = marked;
    return mesh;
  }
  ReadSingularTuples(input, mesh.Derived);
  AddMissing(marked, mesh.Derived);
  if (stamp.Levels > 0)
  {
    if (!FindControlMesh(mesh.Cells.GetView(), stamp, mesh.Above))
    {
      return ReadControlMesh(input, false, features, scheme, ids);
    }
    // If children of a control simplex have different values by now, this level itself is the
    // control mesh.
    FeatureValues values;
    SharpTuples derived;
    if (LiftFeatureValues(mesh.Above, stamp.Levels, mesh.Values, values) &&
      LiftTuples(mesh.Derived, stamp, derived))
    {
      mesh.MadeLevels = stamp.Levels;
      mesh.Values = std::move(values);
      mesh.Derived = std::move(derived);
      mesh.Inverted = ReadInverted(input, mesh.Above);
    }
  }
  return mesh;
}

}
