// SPDX-License-Identifier: BSD-3-Clause
// How a uniform subdivision interpolates, and warns of the result.
#include "Private/Uniform/UniformRun.h"

#include "Core/Operators/SparseRows.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Reading/SolidOrientation.h"
#include "Private/Run/StampFields.h"
#include "Private/Values/SharedInterpolation.h"

#include "vtkCellData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <limits>

namespace subdivision
{

/// An earlier filter that made the input has solved for control points, or was not to.
bool UniformRun::Interpolates() const
{
  return this->Options.Interpolation.IsOn() && !this->Mesh.IsStamped;
}

double UniformRun::GetPointsWeight() const
{
  const InterpolationOptions& options = this->Options.Interpolation;
  const double weight = this->Solves && options.Points ? options.Weight : 0.;
  // Which points are chosen is not kept: a number that equals none stands for them.
  return weight > 0. && options.Chosen ? std::numeric_limits<double>::quiet_NaN() : weight;
}

/// Decides, with all partitions, whether they solve for control points, and whether the points of
/// the output are the kept ones: all of them have to be.
void UniformRun::PlanInterpolation()
{
  this->Solves = AgreeWithOthers(this->Interpolates(), this->Options);
  // Tangents, which are not kept, need the points before they are projected; on which side normals
  // are, other partitions may decide.
  const KeptOperator* kept = this->Found;
  const bool knowsPoints = kept && kept->Steps && kept->PointsOut &&
    !this->Options.GenerateTangents && this->Options.GenerateLimitNormals == kept->HasNormals &&
    !(kept->HasNormals && this->Others) && kept->PointsWeight == this->GetPointsWeight() &&
    HoldsSameValues(this->Points->GetPoints(), kept->PointsIn) && kept->HasPoints();
  this->ReusesPoints = AgreeWithOthers(knowsPoints, this->Options);
}

/// `limit` has the limits of the points that were read; null: there are none.
void UniformRun::Interpolate(const PointOperator* limit)
{
  if (this->Solves)
  {
    InterpolationLimits limits;
    limits.LeastEigenvalue = GetLeastEigenvalue(this->Options.Features.Weights);
    ConnectToOthers(this->Input, this->Mesh.Cells, this->Options, limits);
    const SparseRows<int> none;
    this->Points->Interpolate(limit ? *limit : static_cast<const PointOperator&>(none),
      this->Options.Interpolation, limits, this->Options.Warn);
  }
}

/// Says in the stamp which values were solved for, here or by an earlier filter.
void UniformRun::StampInterpolation(StampedIds& ids) const
{
  if (this->Solves)
  {
    ids.Interpolated = this->Options.Interpolation.GetNumbers();
  }
  else if (this->Mesh.IsStamped)
  {
    ids.Interpolated = ReadFieldIds(InterpolatedName, this->Input->GetFieldData());
    WarnOfLateInterpolation(this->Options.Interpolation, ids.Interpolated, this->Options.Warn);
  }
}

/// Warns of solids that smoothing turned inside out, and marks them (Inverted).
void UniformRun::CheckOrientation()
{
  vtkSmartPointer<vtkUnsignedCharArray> marks;
  if (this->Options.GenerateClassification)
  {
    marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
    marks->SetName(InvertedName);
    marks->SetNumberOfTuples(this->Output->GetNumberOfCells());
    marks->FillValue(0);
    AddInstead(this->Input->GetCellData(), marks, this->Output->GetCellData());
  }
  const int levels = this->Mesh.MadeLevels + this->Options.Levels;
  const bool hasMoved = this->Options.Levels > 0 || this->Options.ProjectToLimit;
  if (!hasMoved && (levels == 0 || !marks))
  {
    return;
  }
  KeptOperator* kept = this->Found ? this->Found : this->ToKeep.get();
  if (kept && kept->IsUpright)
  {
    return;
  }
  const InvertedCells found =
    FindInvertedCells(this->Mesh.GetControl(), levels, this->Mesh.Inverted, this->Points->GetTie(),
      this->Output, this->Cells.Signs, marks ? marks->GetPointer(0) : nullptr);
  if (kept)
  {
    kept->IsUpright = found.Count == 0;
  }
  if (hasMoved)
  {
    TellInverted(found, this->Output->GetNumberOfCells(), this->Options);
  }
}

}
