// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCellArrays.h"

#include "Arrays.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace subdivision
{
namespace
{

constexpr const char* OriginalCells = "vtkOriginalCellIds";

/// The input cell of each output cell.
template <typename Id>
Buffer<vtkIdType> FindSources(
  const SurfaceCells& cells, const SurfaceSteps<Id>& steps, int firstStep)
{
  Buffer<vtkIdType> faces(steps.GetLevel(firstStep).Mesh.NumberOfFaces);
  std::copy(cells.FaceCells.begin(), cells.FaceCells.end(), faces.begin());
  for (int step = firstStep; step < steps.GetNumberOfSteps(); ++step)
  {
    Buffer<vtkIdType> parents;
    steps.GetScheme().GetFaceParents(steps.GetLevel(step), parents);
    ForEach(parents.size(), [&](vtkIdType i) { parents[i] = faces[parents[i]]; });
    faces = std::move(parents);
  }
  const vtkIdType vertices = static_cast<vtkIdType>(cells.VertexCells.size());
  const vtkIdType segments = static_cast<vtkIdType>(cells.SegmentCells.size());
  const vtkIdType lines = steps.GetLevel(steps.GetNumberOfSteps()).Lines.size();
  Buffer<vtkIdType> sources(vertices + lines + faces.size());
  std::copy(cells.VertexCells.begin(), cells.VertexCells.end(), sources.begin());
  ForEach(lines,
    [&](vtkIdType i) { sources[vertices + i] = cells.SegmentCells[i / (lines / segments)]; });
  std::copy(faces.begin(), faces.end(), sources.begin() + vertices + lines);
  return sources;
}

}

void CopySurfaceCellArrays(vtkPolyData* input, const Buffer<vtkIdType>& sources, bool originals,
  const RunOptions& options, vtkPolyData* output)
{
  vtkCellData* from = input->GetCellData();
  vtkCellData* to = output->GetCellData();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (array != from->GetGlobalIds() && array != from->GetPedigreeIds() &&
      !(originals && name == OriginalCells) &&
      HasTuples(array, input->GetNumberOfCells(), "cell", options.Warn))
    {
      AddLike(from, i, Gather(array, { sources.begin(), sources.end() }), to);
    }
  }
  if (originals)
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(OriginalCells);
    ids->SetNumberOfTuples(sources.size());
    std::copy(sources.begin(), sources.end(), ids->GetPointer(0));
    AddInstead(from, ids, to);
  }
}

template <typename Id>
void CopySurfaceCellArrays(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceSteps<Id>& steps, int firstStep, bool goesOn, const RunOptions& options,
  vtkPolyData* output)
{
  vtkCellData* from = input->GetCellData();
  const bool carried = goesOn && HasIds(from, OriginalCells, input->GetNumberOfCells());
  const bool originals = options.GenerateOriginalIds && !carried;
  if (from->GetNumberOfArrays() == 0 && !originals)
  {
    return;
  }
  CopySurfaceCellArrays(input, FindSources(cells, steps, firstStep), originals, options, output);
  if (vtkDataArray* given = options.Features.Sharpness)
  {
    vtkDataArray* sharpness = output->GetCellData()->GetArray(given->GetName());
    const vtkIdType first = static_cast<vtkIdType>(cells.VertexCells.size());
    const vtkIdType lines = steps.GetLevel(steps.GetNumberOfSteps()).Lines.size();
    for (vtkIdType i = first; sharpness && i < first + lines; ++i)
    {
      sharpness->SetComponent(
        i, 0, std::max(sharpness->GetComponent(i, 0) - (steps.GetNumberOfSteps() - firstStep), 0.));
    }
  }
}

template void CopySurfaceCellArrays(vtkPolyData*, const SurfaceCells&, const SurfaceSteps<int>&,
  int, bool, const RunOptions&, vtkPolyData*);
template void CopySurfaceCellArrays(vtkPolyData*, const SurfaceCells&,
  const SurfaceSteps<long long>&, int, bool, const RunOptions&, vtkPolyData*);

}
