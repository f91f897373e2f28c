// SPDX-License-Identifier: BSD-3-Clause
// What a uniform subdivision writes for the next filter.
#include "Private/Uniform/UniformRun.h"

#include "Private/ArrayNames.h"
#include "Private/Control/Partners.h"
#include "Private/Control/StampFields.h"
#include "Private/Uniform/OutputNumbers.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
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
  if (Partners* others = FindPartners(this->Options, this->Input))
  {
    this->CountInWhole(*others, stamp, ids);
  }
  WriteStamp(stamp, this->Output);
  WriteStampedIds(ids, this->Output);
}

/// Adds the numbers that points and cells have in the whole output, of which this is a part, and
/// makes the stamp count there.
void UniformRun::CountInWhole(Partners& others, Stamp& stamp, StampedIds& ids)
{
  const OutputNumbers numbers = NumberOutput(this->Mesh,
    this->Found ? this->Found->ControlDerived : this->Control.Derived.Tuples, this->Input,
    stamp.Levels, this->GetScheme(), others);
  this->Output->GetPointData()->AddArray(
    MakeField<vtkIdTypeArray>(PointNumbersName, numbers.Points));
  this->Output->GetCellData()->AddArray(MakeField<vtkIdTypeArray>(CellNumbersName, numbers.Cells));
  stamp.NumberOfControlPoints = numbers.NumberOfControlPoints;
  stamp.NumberOfPoints = numbers.NumberOfPoints;
  stamp.NumberOfCells = numbers.NumberOfCells;
  std::vector<double> sharpness; // of own lines
  for (std::size_t i = 0; i < ids.Singular.Sharpness.size(); ++i)
  {
    const std::vector<char>& isOwn = numbers.IsOwnDerived[1];
    if (isOwn[i * isOwn.size() / ids.Singular.Sharpness.size()])
    {
      sharpness.push_back(ids.Singular.Sharpness[i]);
    }
  }
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    std::vector<vtkIdType> own;
    const std::vector<char>& isOwn = numbers.IsOwnDerived[dimension];
    const std::vector<vtkIdType>& tuples = ids.Singular.Tuples.Tuples[dimension];
    const std::size_t ofEach = isOwn.empty() ? 1 : tuples.size() / isOwn.size();
    for (std::size_t i = 0; i < tuples.size(); ++i)
    {
      if (isOwn[i / ofEach])
      {
        own.push_back(numbers.Points[tuples[i]]);
      }
    }
    ids.Singular.Tuples.Tuples[dimension] = std::move(own);
  }
  ids.Singular.Sharpness = std::move(sharpness);
  for (const vtkIdType simplex : ids.Inverted)
  {
    ids.FirstInverted.push_back(2 * numbers.FirstCells[simplex / 2] + simplex % 2);
  }
  ids.Inverted.clear();
  ids.Global.clear(); // points have their order
}

}
