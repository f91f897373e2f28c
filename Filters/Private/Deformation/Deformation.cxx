// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Deformation/Deformation.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Deformation/DeformedVectors.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <cmath>

namespace subdivision
{
namespace
{

int ChooseType(vtkDataArray* points, int precision)
{
  return precision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT
    : precision == vtkAlgorithm::DOUBLE_PRECISION    ? VTK_DOUBLE
    : points->GetDataType() == VTK_FLOAT             ? VTK_FLOAT
                                                     : VTK_DOUBLE;
}

bool HasPoints(vtkPointSet* data)
{
  return data->GetPoints() && data->GetNumberOfPoints() > 0;
}

/// The first control point that is finite at rest and not in the deformed mesh; -1: none.
vtkIdType FindLostPoint(vtkPointSet* rest, vtkPointSet* deformed)
{
  auto isFinite = [](vtkPointSet* mesh, vtkIdType i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
  };
  for (const vtkIdType i : InTurn(rest->GetNumberOfPoints()))
  {
    if (!isFinite(deformed, i) && isFinite(rest, i))
    {
      return i;
    }
  }
  return -1;
}

/// How many points are outside, which is the first, and how many are not finite.
std::string DescribeOutside(const EmbeddedPoints& embedded)
{
  const auto outside = static_cast<vtkIdType>(embedded.Outside.size());
  std::string text = std::to_string(outside) + " of " +
    std::to_string(embedded.GetNumberOfPoints()) + " points, the first is point " +
    std::to_string(embedded.Outside[0]) + ", are not inside the subdivided rest mesh";
  if (embedded.NumberNotFinite > 0)
  {
    text += " (" + std::to_string(embedded.NumberNotFinite) + " are not finite)";
  }
  return text;
}

}

bool Deformation::Run(vtkPointSet* input, vtkPointSet* rest, vtkPointSet* deformed,
  const DeformationOptions& options, vtkPointSet* output)
{
  try
  {
    return this->Deform(input, rest, deformed, options, output);
  }
  catch (...) // too little memory, or the user stops it
  {
    this->Clear(); // the kept data may be incomplete
    throw;
  }
}

bool Deformation::Deform(vtkPointSet* input, vtkPointSet* rest, vtkPointSet* deformed,
  const DeformationOptions& options, vtkPointSet* output)
{
  output->ShallowCopy(input);
  if (!HasPoints(input))
  {
    return true;
  }
  if (!HasPoints(rest) || rest->GetNumberOfCells() == 0)
  {
    options.Warn("The rest mesh has no cells, so that nothing is inside of it: the output is the "
                 "input. Give it a mesh of solid cells around the input.");
    return true;
  }
  if (!this->Prepare(rest, deformed, options))
  {
    return false;
  }
  if (!this->Rest.HasCells())
  {
    options.Warn(
      "The rest mesh has no cell that can be used: the output is the input. Correct its cells.");
    return true;
  }
  vtkDataArray* points = input->GetPoints()->GetData();
  const auto given = Contiguous(points);
  const auto control = this->Rest.MoveControlPoints(deformed);
  const int type = ChooseType(points, options.OutputPointsPrecision);
  const bool hasVectors = options.TransformVectors && HasVectors(input);
  // Most often the points are known, and are moved while that is found out.
  EmbeddedPoints* embedded = this->GuessEmbedded(given, options);
  const double* moved = embedded ? this->Rest.MovePoints(control) : nullptr;
  auto result = embedded ? MoveIfEmbedded(*embedded, moved, type, given) : nullptr;
  if (result)
  {
    this->Use(*embedded);
  }
  else
  {
    embedded = this->FindEmbedded(given, hasVectors && options.OnLimit, options);
    moved = nullptr;
  }
  if (!embedded)
  {
    return false;
  }
  this->Rest.WarnOfInvertedCells(control, options);
  const auto* movedControl = static_cast<const double*>(control->GetVoidPointer(0));
  if (!moved && !embedded->IsOnLimit() && (hasVectors || embedded->Composed.GetNumberOfRows() == 0))
  {
    moved = this->Rest.MovePoints(control);
  }
  if (!result)
  {
    result = MoveEmbeddedPoints(*embedded, movedControl, moved, type);
  }
  CopyLooks(points, result);
  vtkNew<vtkPoints> outputPoints;
  outputPoints->SetDataType(result->GetDataType());
  outputPoints->SetData(result);
  output->SetPoints(outputPoints);
  if (hasVectors)
  {
    const auto jacobians = embedded->IsOnLimit()
      ? ComputeJacobians(*embedded, this->Rest.GetControlPoints(), movedControl)
      : ComputeJacobians(*embedded, this->Rest.GetPoints(), moved);
    TransformVectors(jacobians, options, output);
  }
  return true;
}

/// Checks the meshes against each other, and subdivides the one at rest if it is new.
bool Deformation::Prepare(
  vtkPointSet* rest, vtkPointSet* deformed, const DeformationOptions& options)
{
  const std::string difference = CompareCells(rest, deformed);
  if (!difference.empty())
  {
    options.Fail("The deformed mesh must have the points and cells of the rest mesh, in the same "
                 "order; only coordinates may differ. " +
      difference + " The output is the input.");
    return false;
  }
  const vtkIdType lost = FindLostPoint(rest, deformed);
  if (lost >= 0)
  {
    options.Fail("Point " + std::to_string(lost) +
      " of the deformed mesh is not finite. The output is the input. Correct its coordinates.");
    return false;
  }
  const vtkIdType builds = this->Rest.NumberOfBuilds;
  if (!this->Rest.Update(rest, options))
  {
    return false;
  }
  if (this->Rest.IsTooLarge())
  {
    options.Fail("The subdivided rest mesh would have " +
      std::to_string(this->Rest.GetNumberOfPoints()) +
      " points, and it or its cells are too many. Use fewer levels.");
    this->Clear();
    return false;
  }
  if (this->Rest.NumberOfBuilds != builds)
  {
    this->Embedded.Clear();
    if (this->Rest.HasCells())
    {
      this->Rest.WarnOfInvertedCells(nullptr, options);
    }
  }
  return !options.Progress || !options.Progress(0.5);
}

/// The embedded points that are kept for points which begin like these, if such points can be moved
/// before it is known whether they are equal; else null.
EmbeddedPoints* Deformation::GuessEmbedded(
  vtkDataArray* points, const DeformationOptions& options) const
{
  const int type = points->GetDataType();
  return type != VTK_DOUBLE && type != VTK_FLOAT
    ? nullptr
    : this->Embedded.Find<EmbeddedPoints>(
        [&](const EmbeddedPoints& kept)
        {
          return !options.OnLimit && !kept.IsOnLimit() && kept.Rule == options.Outside &&
            kept.Composed.GetNumberOfRows() == 0 &&
            (kept.Outside.empty() || options.Outside != OutsideRule::Error) &&
            BeginsAs(points, kept.Print);
        });
}

/// Notes that embedded points serve this update.
void Deformation::Use(EmbeddedPoints& embedded)
{
  embedded.Used = true;
  this->NumberOfOutsidePoints += static_cast<vtkIdType>(embedded.Outside.size());
}

/// Finds the embedded points that are kept for equal points, or embeds the points. Returns null if
/// points are outside and OutsidePoints makes that an error, or if they are too many.
EmbeddedPoints* Deformation::FindEmbedded(
  vtkDataArray* points, bool slopes, const DeformationOptions& options)
{
  Fingerprint print = ComputeFingerprint(points);
  EmbeddedPoints* embedded = this->Embedded.Find<EmbeddedPoints>(
    [&](const EmbeddedPoints& kept)
    {
      return kept.Rule == options.Outside && kept.IsOnLimit() == options.OnLimit &&
        (!slopes || kept.OnLimit[1].GetNumberOfRows() > 0) && kept.Print == print;
    });
  const bool isNew = !embedded;
  if (isNew)
  {
    ++this->Embedded.NumberOfBuilds;
    std::unique_ptr<EmbeddedPoints> made = options.OnLimit
      ? EmbedOnLimit(points, slopes, options, this->Rest)
      : EmbedPoints(points, options.Outside, this->Rest);
    if (!made && !options.OnLimit)
    {
      options.Fail("More than " + std::to_string(EmbeddedPoints::MostOthers) +
        " points are in no solid cell of the rest mesh, which is too many to find the nearest "
        "place for each. The output is the input. Deform the object in parts, or set OutsidePoints "
        "to Leave.");
    }
    if (!made)
    {
      return nullptr;
    }
    embedded = this->Embedded.Add(std::move(made));
    embedded->Print = std::move(print);
  }
  this->Use(*embedded);
  if (embedded->Outside.empty())
  {
    return embedded;
  }
  const std::string text = DescribeOutside(*embedded);
  if (options.Outside == OutsideRule::Error)
  {
    options.Fail(text +
      ". The output is the input. Make the rest mesh larger, or set OutsidePoints to Leave or "
      "Nearest.");
    return nullptr;
  }
  if (isNew)
  {
    options.Warn(text +
      (options.Outside == OutsideRule::Leave
          ? ": the filter leaves them where they are (OutsidePoints)."
          : ": the filter moves each like the nearest place in this mesh (OutsidePoints), and "
            "leaves those that are not finite."));
  }
  return embedded;
}

void Deformation::Clear()
{
  this->Embedded.Clear();
  this->Rest.Clear();
}

std::size_t Deformation::GetMemorySize() const
{
  return this->Rest.GetOperatorSize() + this->Embedded.GetMemorySize();
}

}
