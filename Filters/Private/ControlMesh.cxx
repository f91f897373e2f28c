// SPDX-License-Identifier: BSD-3-Clause
#include "ControlMesh.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace subdivision
{
namespace
{

std::vector<vtkIdType> ReadGlobalIds(vtkDataArray* ids)
{
  std::vector<vtkIdType> values;
  if (ids)
  {
    values.resize(ids->GetNumberOfTuples());
    vtkIdTypeArray* exact = vtkIdTypeArray::SafeDownCast(ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      values[i] = exact ? exact->GetValue(i) : static_cast<vtkIdType>(ids->GetComponent(i, 0));
    }
  }
  return values;
}

/// Tuples of a refined level seen as simplices, lifted to the control level.
bool LiftTuples(const SimplexTuples& tuples, const Stamp& stamp, SimplexTuples& lifted)
{
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    SimplexList fine;
    fine.Connectivity = tuples.Tuples[dimension];
    fine.Dimensions.assign(
      fine.Connectivity.size() / (dimension + 1), static_cast<unsigned char>(dimension));
    SimplexList coarse;
    if (!FindControlMesh(fine, stamp, coarse))
    {
      return false;
    }
    lifted.Tuples[dimension] = coarse.Connectivity;
  }
  return true;
}

}

ControlMesh ReadControlMesh(vtkPointSet* input, bool trustStamp, const FeatureOptions& features,
  const std::function<void(const std::string&)>& warn)
{
  ControlMesh mesh;
  Stamp stamp;
  mesh.IsStamped = trustStamp && ReadStamp(input, stamp);
  vtkDataArray* carried = input->GetFieldData()->GetArray(GlobalIdsName);
  vtkDataArray* own = input->GetPointData()->GetGlobalIds();
  mesh.GlobalIds = ReadGlobalIds(mesh.IsStamped && carried ? carried : own);
  mesh.Cells = CellsToSimplices(input, mesh.IsStamped || !own ? nullptr : mesh.GetGlobalIds());
  const bool whole = mesh.Cells.ParentCells.empty() && mesh.Cells.Warnings.empty() &&
    mesh.Cells.Simplices.GetNumberOfSimplices() == input->GetNumberOfCells();
  if (mesh.IsStamped && !whole)
  {
    return ReadControlMesh(input, false, features, warn);
  }
  for (const std::string& warning : mesh.Cells.Warnings)
  {
    warn(warning);
  }
  mesh.Values = ReadFeatureValues(features, mesh.Cells, warn);
  if (!mesh.IsStamped)
  {
    return mesh;
  }
  ReadSingularTuples(input, mesh.Derived);
  if (stamp.Levels > 0)
  {
    if (!FindControlMesh(mesh.Cells.Simplices, stamp, mesh.Above))
    {
      return ReadControlMesh(input, false, features, warn);
    }
    // Where children were given different values since, this level itself is the control mesh.
    FeatureValues values;
    SimplexTuples derived;
    if (LiftFeatureValues(mesh.Above, stamp.Levels, mesh.Values, values) &&
      LiftTuples(mesh.Derived, stamp, derived))
    {
      mesh.MadeLevels = stamp.Levels;
      mesh.Values = std::move(values);
      mesh.Derived = std::move(derived);
    }
  }
  return mesh;
}

}
