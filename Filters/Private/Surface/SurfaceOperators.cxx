// SPDX-License-Identifier: BSD-3-Clause
// The operators of a subdivision surface without an output.
#include "Private/Surface/SurfaceRun.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Reading/PolygonEars.h"
#include "Private/Surface/SurfaceChecks.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// The points after the steps.
vtkSmartPointer<vtkDataArray> MovePoints(vtkPolyData* input, const OperatorSequence* steps)
{
  SimplicesOfCells noCentres;
  noCentres.Simplices.NumberOfPoints = input->GetNumberOfPoints();
  const auto control = StartValues(input->GetPoints()->GetData(), VTK_DOUBLE, noCentres);
  if (!steps)
  {
    return control;
  }
  Buffer<double> values;
  steps->Apply(static_cast<const double*>(control->GetVoidPointer(0)), 3, values);
  const auto points = MakeArray(VTK_DOUBLE, 3, values.size() / 3);
  std::copy(values.begin(), values.end(), static_cast<double*>(points->GetVoidPointer(0)));
  return points;
}

/// The cells of the last level. A face of n corners gives n - 2 triangles, so that their positions
/// follow from its first corner.
Buffer<vtkIdType> GatherTriangles(
  const SurfaceSteps<int>& steps, const std::vector<vtkIdType>& vertices, vtkDataArray* points)
{
  const int last = steps.GetNumberOfSteps();
  const SurfaceLevel<int>& level = steps.GetLevel(last);
  const PolygonMesh<int>& mesh = level.Mesh;
  Buffer<vtkIdType> corners(steps.GetNumberOfCorners(last));
  steps.WriteFaces(last, corners.data());
  const vtkIdType ofFaces = corners.size() - 2 * static_cast<vtkIdType>(mesh.NumberOfFaces);
  const vtkIdType lines = level.Lines.size();
  const auto ofVertices = static_cast<vtkIdType>(vertices.size());
  Buffer<vtkIdType> triangles(3 * (ofFaces + lines + ofVertices));
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  coordinates->SetData(points);
  ForRanges(mesh.NumberOfFaces,
    [&](vtkIdType begin, vtkIdType end)
    {
      PolygonEars ears(coordinates, PointOrder());
      for (vtkIdType face = begin; face < end; ++face)
      {
        const vtkIdType first = mesh.GetFirstOfCounted(face);
        const vtkIdType size = mesh.GetFirstOfCounted(face + 1) - first;
        vtkIdType* to = triangles.data() + 3 * (first - 2 * face);
        for (const auto& triangle : ears.Cut(corners.data() + first, size))
        {
          to = std::copy(triangle.begin(), triangle.end(), to);
        }
      }
    });
  vtkIdType* to = triangles.data() + 3 * ofFaces;
  for (const int line : InTurn(level.Lines))
  {
    const int* ends = mesh.EdgeVertices.data() + 2 * (line / 2);
    for (const int end : { ends[0], ends[1], ends[1] })
    {
      *to++ = end;
    }
  }
  for (const vtkIdType vertex : InTurn(vertices))
  {
    to = std::fill_n(to, 3, vertex);
  }
  return triangles;
}

}

bool FindSurfaceOperators(
  vtkPolyData* input, const SurfaceOptions& options, SurfaceOperators& operators)
{
  auto scheme = MakeSurfaceScheme<int>(
    options.Scheme, options.Features.ModifiedBoundary, options.Features.Weights);
  SurfaceCells cells;
  bool isLarge = false;
  if (!ReadAndCheck(input, *scheme, options, cells, isLarge))
  {
    return false;
  }
  if (isLarge)
  {
    options.Fail("The subdivided mesh would have more points than its operators can number. Use "
                 "fewer levels.");
    return false;
  }
  const std::vector<vtkIdType> vertices = cells.Vertices;
  SurfaceRun<int> run(input, options, std::move(scheme), nullptr);
  int first = 0;
  const SurfaceSteps<int>* levels = run.MakeLevels(std::move(cells), first);
  if (!levels)
  {
    return false;
  }
  std::vector<SparseRows<int>> steps;
  for (int step = first; step < levels->GetNumberOfSteps(); ++step)
  {
    steps.push_back(levels->GetStep(step).Store());
  }
  if (!steps.empty())
  {
    operators.Steps = std::make_unique<StoredSequence>(std::move(steps));
  }
  operators.Points = MovePoints(input, operators.Steps.get());
  operators.Triangles = GatherTriangles(*levels, vertices, operators.Points);
  return true;
}

}
