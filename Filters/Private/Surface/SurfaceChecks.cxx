// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceChecks.h"

#include "Private/Control/SizeChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Surface/SurfaceCreases.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <vector>

namespace subdivision
{

std::string CheckSize(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceScheme<int>& scheme, const SurfaceOptions& options, double& faces)
{
  const double lines = std::ldexp(static_cast<double>(cells.SegmentCells.size()), options.Levels);
  faces = scheme.CountFaces(static_cast<double>(cells.GetNumberOfFaces()),
    static_cast<double>(cells.Corners.size()), options.Levels);
  const double all = faces + lines + static_cast<double>(cells.VertexCells.size());
  const double bytesPerFace = scheme.NeedsTriangles() ? 32. : 40.;
  const std::string tooMany =
    CheckNumberOfCells(all, all * bytesPerFace, options.Levels, options.MaximumNumberOfCells);
  if (!tooMany.empty())
  {
    return tooMany;
  }
  // A face has about one point; the levels before the last take about as much as its cells.
  const double points = static_cast<double>(cells.NumberOfPoints) + faces + lines;
  const double bytes = all * (2. * bytesPerFace + GetBytesPerTuple(input->GetCellData())) +
    1.25 * points * (24. + GetBytesPerTuple(input->GetPointData()));
  return CheckMemory(all, points, bytes, options.Levels);
}

void WarnOfUnused(
  vtkPolyData* input, const SurfaceScheme<int>& scheme, const SurfaceOptions& options)
{
  const CellReader reader(input);
  std::vector<vtkIdType> scratch;
  vtkIdType polygons = 0;
  for (vtkIdType c = 0; scheme.NeedsTriangles() && c < reader.GetNumberOfCells(); ++c)
  {
    polygons += reader.GetCellType(c) == VTK_POLYGON && reader.GetCell(c, scratch).Size > 3;
  }
  if (polygons > 0)
  {
    options.Warn(std::to_string(polygons) +
      " polygon(s) have more than three points: the filter splits them into triangles, which this "
      "scheme needs.");
  }
  if (!scheme.HasLimit() &&
    (options.ProjectToLimit || options.GenerateLimitNormals || options.GenerateTangents ||
      options.Interpolation.IsOn()))
  {
    options.Warn("The filter computes no limits for this scheme: it ignores ProjectToLimit, "
                 "GenerateLimitNormals, GenerateTangents, InterpolatePoints and InterpolateArrays. "
                 "Use Loop, CatmullClark, ModifiedButterfly or SqrtThree.");
  }
  const FeatureOptions& features = options.Features;
  auto isKnown = [](JointRule rule) { return FindKnownRule(rule) == rule; };
  if (features.Embedded != EmbeddedRule::Follow || features.Part || features.Rules ||
    !isKnown(features.Type1) || !isKnown(features.Type2) || !isKnown(features.Type3))
  {
    options.Warn("The surface filters have no rules for EmbeddedCells, joints that follow "
                 "a dimension or a part, and rules of regions: the filter ignores "
                 "them. Flag lines and vertices instead (array index 0), or use "
                 "vtkMultiDimensionalSubdivision.");
  }
  if (!scheme.UsesTags() &&
    (features.Singular || features.Sharpness || features.PreserveInterfaces ||
      features.DetectFeatures || options.Angles || options.Flatness || !features.Marks.IsEmpty()))
  {
    options.Warn(
      "This scheme is dual and has no creases and corners: the filter ignores flags, "
      "marks, sharpness, PreserveInterfaces, DetectFeatures, and angles and flatness of corners.");
  }
}

}
