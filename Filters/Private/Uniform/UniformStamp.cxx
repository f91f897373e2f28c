// SPDX-License-Identifier: BSD-3-Clause
// The stamp of a uniform subdivision for the next filter.
#include "Private/Uniform/UniformRun.h"

#include "Private/Run/StampFields.h"
#include "Private/Uniform/OutputNumbers.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace subdivision
{

void UniformRun::WriteStamps()
{
  Stamp stamp;
  stamp.Scheme = this->Options.Scheme;
  stamp.Levels = this->Mesh.MadeLevels + this->Options.Levels;
  stamp.NumberOfControlPoints = this->Mesh.GetControl().NumberOfPoints;
  stamp.IsProjected = this->Options.ProjectToLimit;
  StampedIds ids;
  if (!stamp.IsProjected)
  {
    ids = { this->Derived, this->Mesh.GlobalIds, this->Mesh.Inverted, {}, {} };
    this->StampInterpolation(ids);
  }
  if (this->Others)
  {
    this->CountInWhole(stamp, ids);
  }
  WriteStamp(stamp, this->Output);
  WriteStampedIds(ids, this->Output);
}

/// Finds the remaining sharpness of derived simplices.
void UniformRun::LowerSharpness()
{
  const int all = this->Mesh.MadeLevels + this->Options.Levels;
  for (int dimension = 1; dimension < 3; ++dimension)
  {
    const std::vector<double>& given = this->Control.Derived.Sharpness[dimension];
    std::vector<double>& left = this->Derived.Sharpness[dimension];
    left.clear();
    for (std::size_t i = 0; i < given.size(); ++i) // the rest, for all children
    {
      if (this->Wanted.IsAll() || this->Numbers.HasDerived[dimension][i])
      {
        left.insert(left.end(), std::size_t(1) << (dimension * all),
          std::max(given[i] - this->Options.Levels, 0.));
      }
    }
  }
}

/// Adds the numbers that points and cells have in the whole output, of which this is a part, and
/// makes the stamp count there.
void UniformRun::CountInWhole(Stamp& stamp, StampedIds& ids)
{
  const ControlNumbers& control = this->Numbers;
  const OutputNumbers numbers =
    NumberOutput(control, this->Mesh.GetControl(), stamp.Levels, this->GetScheme());
  this->Output->GetPointData()->AddArray(numbers.Points);
  this->Output->GetCellData()->AddArray(numbers.Cells);
  stamp.NumberOfControlPoints = control.Totals[0];
  stamp.NumberOfPoints = numbers.NumberOfPoints;
  stamp.NumberOfCells = control.NumberOfCells;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    const std::vector<char>& isOwn = control.IsOwnDerived[dimension];
    const auto keepOwn = [&isOwn](auto& values)
    {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        if (isOwn[i * isOwn.size() / values.size()])
        {
          values[kept++] = values[i];
        }
      }
      values.resize(kept);
    };
    keepOwn(ids.Singular.Sharpness[dimension]);
    keepOwn(ids.Singular.Tuples.Tuples[dimension]);
    for (vtkIdType& point : ids.Singular.Tuples.Tuples[dimension])
    {
      point = numbers.Points->GetValue(point);
    }
  }
  for (const vtkIdType simplex : ids.Inverted)
  {
    ids.FirstInverted.push_back(2 * control.FirstCells[simplex / 2] + simplex % 2);
  }
  ids.Inverted.clear();
  ids.Global.clear(); // points have their order
}

}
