// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceChecks.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/Control/SizeChecks.h"
#include "Private/Surface/SurfaceCreases.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>
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

/// Vertices or faces with so many neighbours that k rows of k values take long.
struct ManyNeighbours
{
  double Values = 0.; ///< sum of k^2
  vtkIdType Largest = -1;
  vtkIdType Size = 0; ///< of the largest

  void Add(vtkIdType item, vtkIdType size)
  {
    constexpr vtkIdType few = 256; // in meshes of any size, values are up to so many times the rows
    if (size > few)
    {
      this->Values += static_cast<double>(size) * static_cast<double>(size);
      this->Largest = size > this->Size ? item : this->Largest;
      this->Size = std::max(size, this->Size);
    }
  }
};

/// How often the values of k neighbours are computed for all of these, around vertices and faces.
struct DensePasses
{
  DensePasses(const SurfaceScheme<int>& scheme, const SurfaceOptions& options)
  {
    const bool hasTangents = options.GenerateLimitNormals || options.GenerateTangents;
    const double levels = options.Levels;
    switch (scheme.GetDenseRows())
    {
      case DenseRows::OfVertices:
        // Each tangent is a sum of all these rows, which takes about five times as long as they do.
        this->OfVertices = levels > 0. ? levels + (hasTangents ? 10. : 0.) : 0.;
        return;
      case DenseRows::OfFaces:
        // The faces that a dual scheme makes of vertices are there from the second level on.
        this->OfVertices = std::max(levels - 1., 0.);
        this->OfFaces = levels;
        if (levels > 0.) // limits are those of points that a step made, of all corners around
        {
          const double limits = (options.ProjectToLimit ? 4. : 0.) + (hasTangents ? 8. : 0.);
          this->OfVertices += limits;
          this->OfFaces += limits;
        }
        return;
      case DenseRows::OfLimits:
        // The limits of neighbours, of opposite corners and of what is near them read all of these.
        this->OfVertices = 5. *
          ((options.ProjectToLimit ? 1. : 0.) + (options.Interpolation.IsOn() ? 1. : 0.) +
            (hasTangents ? 2. : 0.));
        this->OfFaces = this->OfVertices;
        return;
      default:
        return;
    }
  }

  double OfVertices = 0.;
  double OfFaces = 0.;
};

/// The error message if the rows of a step would have more values than can be computed in seconds.
std::string CheckDenseRows(
  const SurfaceCells& cells, const SurfaceScheme<int>& scheme, const SurfaceOptions& options)
{
  constexpr double most = 4e8; // some 10 s
  const DensePasses passes(scheme, options);
  if (passes.OfVertices + passes.OfFaces == 0.)
  {
    return std::string();
  }
  std::vector<vtkIdType> valences(static_cast<std::size_t>(cells.NumberOfPoints), 0);
  for (const vtkIdType point : InTurn(cells.Corners))
  {
    ++valences[point];
  }
  ManyNeighbours vertices;
  ForEachInTurn(
    cells.NumberOfPoints, [&](vtkIdType point) { vertices.Add(point, valences[point]); });
  ManyNeighbours faces;
  ForEachInTurn(cells.GetNumberOfFaces(), [&](vtkIdType face)
    { faces.Add(cells.FaceCells[face], cells.FaceOffsets[face + 1] - cells.FaceOffsets[face]); });
  const double ofVertices = vertices.Values * passes.OfVertices;
  const double ofFaces = faces.Values * passes.OfFaces;
  if (ofVertices + ofFaces <= most)
  {
    return std::string();
  }
  std::ostringstream message;
  ofFaces > ofVertices
    ? message << "Cell " << faces.Largest << " has " << faces.Size << " corners"
    : message << "Point " << vertices.Largest << " has " << vertices.Size << " faces around it";
  message << ". This scheme computes each new point there from all of them: "
          << static_cast<vtkIdType>(ofVertices + ofFaces) << " values, above "
          << static_cast<vtkIdType>(most) << ", which would take too long. "
          << (scheme.GetDenseRows() == DenseRows::OfVertices
                 ? "Take the scheme Loop or SqrtThree"
                 : "Take the scheme CatmullClark or Midedge")
          << (ofFaces > ofVertices ? ", or cut the cell into smaller ones."
                                   : ", or cut the faces there so that fewer share the point.");
  return message.str();
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
  const std::string tooDense = tooLarge.empty() ? CheckDenseRows(cells, scheme, options) : tooLarge;
  if (!tooDense.empty())
  {
    options.Fail(tooDense);
    return false;
  }
  isLarge = 16. *
      (faces + static_cast<double>(cells.Corners.size()) +
        static_cast<double>(cells.NumberOfPoints) +
        std::ldexp(static_cast<double>(cells.Segments.size()), options.Levels)) >
    static_cast<double>(LargestSmallId);
  return true;
}

void WarnOfUnused(const SurfaceScheme<int>& scheme, const SurfaceOptions& options)
{
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
