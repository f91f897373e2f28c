// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceChecks.h"

#include "Private/Control/SizeChecks.h"
#include "Private/Surface/SurfaceCreases.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace subdivision
{
namespace
{

/// An error message if the output would be too large; `faces`: about how many there will be.
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

}

bool ReadAndCheck(vtkPolyData* input, const SurfaceScheme<int>& scheme,
  const SurfaceOptions& options, SurfaceCells& cells, bool& isLarge)
{
  vtkIdTypeArray* ids = vtkIdTypeArray::SafeDownCast(input->GetPointData()->GetGlobalIds());
  const bool hasIds = ids && ids->GetNumberOfTuples() == input->GetNumberOfPoints();
  cells = ReadSurfaceCells(input, scheme.NeedsTriangles(), hasIds ? ids->GetPointer(0) : nullptr);
  for (const std::string& warning : cells.Warnings)
  {
    options.Warn(warning);
  }
  WarnOfUnused(scheme, options);
  double faces = 0.;
  const std::string tooLarge = CheckSize(input, cells, scheme, options, faces);
  if (!tooLarge.empty())
  {
    options.Fail(tooLarge);
    return false;
  }
  isLarge = 16. *
      (faces + static_cast<double>(cells.Corners.size()) +
        static_cast<double>(cells.NumberOfPoints) +
        std::ldexp(static_cast<double>(cells.Segments.size()), options.Levels)) >
    static_cast<double>(std::numeric_limits<int>::max());
  return true;
}

void WarnOfUnused(const SurfaceScheme<int>& scheme, const SurfaceOptions& options)
{
  if (!scheme.HasLimit() &&
    (options.ProjectToLimit || options.GenerateLimitNormals || options.GenerateTangents ||
      options.Interpolation.IsOn()))
  {
    options.Warn("The filter computes no limits for this scheme: it ignores ProjectToLimit, "
                 "GenerateLimitNormals, GenerateTangents, InterpolatePoints and InterpolateArrays. "
                 "Use another scheme than FourEight.");
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
