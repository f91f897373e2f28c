// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/UniformSubdivision.h"

#include "Core/Memory/Loops.h"
#include "Private/Control/CoincidentPoints.h"
#include "Private/Values/PointCopies.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

/// The torn mesh with texture coordinates alone, and with the cell data of the joined one.
vtkSmartPointer<vtkPointSet> TakeTexture(vtkPointSet* torn, vtkPointSet* joined)
{
  auto mesh = vtkSmartPointer<vtkPointSet>::Take(torn->NewInstance());
  mesh->ShallowCopy(torn);
  mesh->GetPointData()->Initialize();
  mesh->GetPointData()->SetTCoords(torn->GetPointData()->GetTCoords());
  mesh->GetCellData()->ShallowCopy(joined->GetCellData());
  mesh->SetFieldData(vtkNew<vtkFieldData>()); // no stamp, as sides are apart
  return mesh;
}

/// The options for texture coordinates, whose corners are marked.
UniformOptions GetOptionsOfTexture(const UniformOptions& given, vtkDataArray* corners)
{
  UniformOptions options = given;
  options.GenerateLimitNormals = options.NormalsWhereSmooth = options.GenerateTangents = false;
  options.GenerateClassification = options.GenerateOriginalIds = options.GenerateGlobalIds = false;
  options.Interpolation.Points = false;
  options.Factors = nullptr;
  options.Warn = [](const std::string&) {}; // the joined mesh has told
  options.Features.MergesPoints = true;
  options.Features.CornerAngles = nullptr;
  options.Features.Marks = MarkOptions();
  options.Features.Marks.SelectedPoints = corners;
  return options;
}

/// Gives points of the output a copy for each point of the torn one beyond the first, and the
/// texture coordinates there.
void Tear(vtkPointSet* torn, vtkPointSet* output, MatrixFactors* factors)
{
  const Buffer<vtkIdType> joined = FindJoinedPoints(torn, output);
  std::vector<vtkIdType> sources(static_cast<std::size_t>(output->GetNumberOfPoints()));
  std::iota(sources.begin(), sources.end(), vtkIdType(0));
  std::vector<vtkIdType> from(sources.size(), -1); // the point of the torn mesh
  std::vector<vtkIdType> newIds;
  for (const vtkIdType i : InTurn(joined.size()))
  {
    const bool isCopy = joined[i] >= 0 && from[joined[i]] >= 0;
    newIds.push_back(isCopy ? static_cast<vtkIdType>(sources.size()) : joined[i]);
    isCopy ? from.push_back(i) : joined[i] >= 0 ? void(from[joined[i]] = i) : void();
    isCopy ? sources.push_back(joined[i]) : void();
  }
  AppendSources({ { 0, sources } }, output, factors);
  const CellReader cells(torn);
  TakePoints(output, sources,
    [&](vtkIdType cell, auto* begin, auto* end)
    {
      std::vector<vtkIdType> scratch;
      const CellIds ids = cells.GetCell(cell, scratch);
      std::transform(ids.Ids, ids.Ids + (end - begin), begin,
        [&](vtkIdType id) { return static_cast<std::decay_t<decltype(*begin)>>(newIds[id]); });
    });
  vtkDataArray* const made = output->GetPointData()->GetTCoords();
  vtkDataArray* const texture = torn->GetPointData()->GetTCoords();
  for (const std::size_t i : InTurn(from.size()))
  {
    from[i] >= 0 ? made->SetTuple(static_cast<vtkIdType>(i), from[i], texture) : void();
  }
}

}

bool SubdivideWithSeams(
  vtkPointSet* joined, vtkPointSet* torn, const UniformOptions& given, vtkUnstructuredGrid* output)
{
  const auto subdivide =
    [&given](vtkPointSet* input, UniformOptions options, ProgressPart part, vtkUnstructuredGrid* to)
  {
    options.Progress = [&given, part](double done)
    { return given.Progress && given.Progress(done < 0. ? done : part.At(done)); };
    return SubdivideUniformly(input, options, to);
  };
  const Buffer<unsigned char> corners = FindSeamCorners(torn, FindJoinedPoints(torn, joined));
  const auto marks = MakeArray(VTK_UNSIGNED_CHAR, 1, corners.size());
  std::copy(corners.begin(), corners.end(), static_cast<unsigned char*>(marks->GetVoidPointer(0)));
  vtkNew<vtkUnstructuredGrid> made;
  if (!subdivide(joined, given, { 0., 0.7 }, output) ||
    !subdivide(TakeTexture(torn, joined), GetOptionsOfTexture(given, marks), { 0.7, 1. }, made))
  {
    return false;
  }
  if (output->GetPointData()->GetTCoords() && made->GetPointData()->GetTCoords() &&
    made->GetNumberOfCells() == output->GetNumberOfCells())
  {
    Tear(made, output, given.Factors);
  }
  return true;
}

}
