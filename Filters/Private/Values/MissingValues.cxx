// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Values/MissingValues.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Partitions/OtherPartitions.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <cmath>
#include <limits>
#include <utility>

namespace subdivision
{
namespace
{

constexpr const char* MaskName = "vtkValidPointMask"; ///< filters of VTK that probe write it

bool IsFloating(vtkDataArray* array)
{
  return array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
}

/// The array of whole numbers that says which values are there; null if there is none.
vtkDataArray* FindMask(vtkPointSet* mesh)
{
  vtkDataArray* mask = mesh->GetPointData()->GetArray(MaskName);
  const bool fits = mask && !IsFloating(mask) && mask->GetNumberOfComponents() == 1 &&
    mask->GetNumberOfTuples() == mesh->GetNumberOfPoints();
  return fits ? mask : nullptr;
}

/// The mesh with values that are not a number where they are masked, also in the mask.
vtkSmartPointer<vtkPointSet> MaskValues(vtkPointSet* input, vtkDataArray* mask)
{
  auto mesh = vtkSmartPointer<vtkPointSet>::Take(input->NewInstance());
  mesh->ShallowCopy(input);
  const vtkIdType size = mask->GetNumberOfTuples();
  const auto ones = MakeArray(VTK_DOUBLE, 1, size);
  ones->SetName(MaskName);
  ones->Fill(1.);
  mesh->GetPointData()->AddArray(ones);
  for (int a = 0; a < mesh->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* given = mesh->GetPointData()->GetArray(a);
    if (!IsFloating(given) || !given->GetName() || given->GetNumberOfTuples() != size)
    {
      continue;
    }
    const auto masked = vtkSmartPointer<vtkDataArray>::Take(given->NewInstance());
    masked->DeepCopy(given);
    for (const vtkIdType i : InTurn(size))
    {
      for (int c = 0; c < masked->GetNumberOfComponents() && mask->GetComponent(i, 0) == 0.; ++c)
      {
        masked->SetComponent(i, c, std::numeric_limits<double>::quiet_NaN());
      }
    }
    mesh->GetPointData()->AddArray(masked); // in its place
  }
  return mesh;
}

/// Where the smoothed mask is a number, values are there.
void RestoreMask(vtkPointSet* output, vtkDataArray* mask)
{
  vtkDataArray* smoothed = output->GetPointData()->GetArray(MaskName);
  if (IsFloating(smoothed))
  {
    const auto restored = vtkSmartPointer<vtkDataArray>::Take(mask->NewInstance());
    restored->SetName(MaskName);
    restored->SetNumberOfTuples(smoothed->GetNumberOfTuples());
    for (const vtkIdType i : InTurn(smoothed->GetNumberOfTuples()))
    {
      restored->SetComponent(i, 0, std::isfinite(smoothed->GetComponent(i, 0)) ? 1. : 0.);
    }
    output->GetPointData()->AddArray(restored);
  }
}

struct Missing
{
  vtkIdType Count = 0;
  vtkIdType First = 0;
};

Missing CountMissing(vtkDataArray* array)
{
  Missing found;
  for (const vtkIdType i : InTurn(array->GetNumberOfTuples()))
  {
    bool isThere = true;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      isThere = isThere && std::isfinite(array->GetComponent(i, c));
    }
    found.First = found.Count == 0 && !isThere ? i : found.First;
    found.Count += isThere ? 0 : 1;
  }
  return found;
}

}

bool RunWithMissingValues(vtkPointSet* input, vtkPointSet* output, RunOptions& options,
  const std::function<bool(vtkPointSet*, vtkPointSet*)>& work)
{
  vtkDataArray* mask = FindMask(input);
  vtkSmartPointer<vtkPointSet> mesh = input;
  if (mask)
  {
    mesh = MaskValues(input, mask);
  }
  std::string note;
  options.NoteOfMissing = &note;
  const bool isDone = work(mesh, output);
  options.NoteOfMissing = nullptr;
  std::string text;
  for (int a = 0; isDone && a < mesh->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* given = mesh->GetPointData()->GetArray(a);
    const std::string name = IsFloating(given) && given->GetName() ? given->GetName() : MaskName;
    const Missing before = name == MaskName ? Missing() : CountMissing(given);
    vtkDataArray* made = output->GetPointData()->GetArray(name.c_str());
    const Missing after = before.Count > 0 && IsFloating(made) ? CountMissing(made) : Missing();
    if (after.Count > 0 &&
      (after.Count != before.Count || made->GetNumberOfTuples() != given->GetNumberOfTuples()))
    {
      text += (text.empty() ? "" : "; ") + ("the point array \"" + name + "\" ");
      text += options.Others ? "at some points"
                             : "at " + std::to_string(before.Count) + " of " +
          std::to_string(given->GetNumberOfTuples()) + " points (the first is point " +
          std::to_string(before.First) + "), and so at " + std::to_string(after.Count) + " of " +
          std::to_string(made->GetNumberOfTuples()) + " points of the output";
    }
  }
  if (!text.empty())
  {
    options.Warn("Values are missing, because they are not a number, infinite, or masked by " +
      std::string(MaskName) + ": " + text +
      ". What takes none of them is as it would be without them. " + note +
      "Fill them in first if there should be values.");
  }
  else if (!note.empty())
  {
    options.Warn(note + "Fill in missing values first if there should be some.");
  }
  if (isDone && mask)
  {
    RestoreMask(output, mask);
  }
  return isDone;
}

void NoteEdgesWithoutValue(std::vector<std::pair<vtkIdType, vtkIdType>>& edges, vtkDataArray* array,
  const char* where, const RunOptions& options)
{
  SortDistinct(edges);
  if (!edges.empty() && options.NoteOfMissing)
  {
    const char* name = array->GetName();
    *options.NoteOfMissing = "RefineByAttributeError does not refine " +
      std::to_string(edges.size()) + " edges: the point array \"" + (name ? name : "") +
      "\" is not finite " + where + ", the first joins points " + std::to_string(edges[0].first) +
      " and " + std::to_string(edges[0].second) + ". ";
  }
}

}
