// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceChecks.h"

#include "Core/Memory/CellSplits.h"
#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Surface/SurfaceCreases.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// Whether options ask for sharp edges or vertices.
bool HasFlags(const FeatureOptions& features)
{
  return features.Singular || features.Sharpness || features.PreserveInterfaces ||
    features.DetectFeatures || !features.Marks.IsEmpty();
}

/// Whether each edge has an even number of faces: then the numbers that are made of its ends cancel
/// each other.
bool IsClosed(const SurfaceCells& cells)
{
  std::uint64_t sum = 0;
  for (const auto face : InTurn(cells.GetNumberOfFaces()))
  {
    const vtkIdType begin = cells.FaceOffsets[face];
    const vtkIdType end = cells.FaceOffsets[face + 1];
    for (vtkIdType i = begin, last = end - 1; i < end; last = i++)
    {
      const auto [a, b] = std::minmax(cells.Corners[last], cells.Corners[i]);
      const std::uint64_t edge =
        static_cast<std::uint64_t>(a) * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(b);
      sum ^= (edge ^ edge >> 29) * 0xbf58476d1ce4e5b9U;
    }
  }
  return sum == 0;
}

/// At most so many vertices of the level before the last have an irregular one beside them, where
/// all edges are smooth. Infinity: faces have other orientations than their neighbours.
double CountIrregular(const SurfaceCells& cells, bool hasTriangles, int levels)
{
  std::vector<vtkIdType> faces(static_cast<std::size_t>(cells.NumberOfPoints)); // at each point
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  edges.reserve(cells.Corners.size());
  double irregular = 0.;
  for (const auto face : InTurn(cells.GetNumberOfFaces()))
  {
    const vtkIdType begin = cells.FaceOffsets[face];
    const vtkIdType end = cells.FaceOffsets[face + 1];
    irregular += hasTriangles || end - begin == 4 ? 0. : 1. + static_cast<double>(end - begin);
    for (vtkIdType i = begin, last = end - 1; i < end; last = i++)
    {
      edges.emplace_back(cells.Corners[last], cells.Corners[i]);
      ++faces[cells.Corners[i]];
    }
  }
  const vtkIdType regular = hasTriangles ? 6 : 4;
  for (const auto size : InTurn(faces))
  {
    irregular += size == 0 || size == regular ? 0. : 1. + static_cast<double>(size);
  }
  StableSort(edges, std::less<>());
  double open = 0.;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const auto [a, b] = edges[i];
    if (i > 0 && edges[i - 1] == edges[i])
    {
      return std::numeric_limits<double>::infinity();
    }
    open += std::binary_search(edges.begin(), edges.end(), std::make_pair(b, a)) ? 0. : 1.;
  }
  return irregular + std::ldexp(3. * open, levels - 1);
}

/// Whether the last level is not made for limits; if in doubt it is.
bool SkipsLast(
  const SurfaceCells& cells, const SurfaceScheme<int>& scheme, const SurfaceOptions& options)
{
  if (options.Levels == 0 || options.Places || options.Others || HasFlags(options.Features) ||
    options.SplitSharpEdges || !cells.Segments.empty())
  {
    return false;
  }
  const auto corners = static_cast<double>(cells.Corners.size());
  const auto faces = static_cast<double>(cells.GetNumberOfFaces());
  return CountIrregular(cells, scheme.NeedsTriangles(), options.Levels) <= MostIrregularVertices *
    scheme.GetFaceMemory().Points * scheme.CountFaces(faces, corners, options.Levels - 1);
}

/// The size of the output.
struct SurfaceSize
{
  double Faces = 0.;
  double Lines = 0.;
  double Points = 0.;
  bool HasLargeIds = false; ///< whether the levels need ids of 64 bits
};

SurfaceSize CountOutput(
  const SurfaceCells& cells, const SurfaceScheme<int>& scheme, const SurfaceOptions& options)
{
  const auto corners = static_cast<double>(cells.Corners.size());
  const auto points = static_cast<double>(cells.NumberOfPoints);
  const double faces = std::max(1., static_cast<double>(cells.GetNumberOfFaces()));
  SurfaceSize size;
  size.Faces = cells.FaceCells.empty() ? 0. : scheme.CountFaces(faces, corners, options.Levels);
  size.Lines = std::ldexp(static_cast<double>(cells.SegmentCells.size()), options.Levels);
  size.Points = points + size.Lines;
  if (options.Levels > 0)
  {
    // The points of a closed surface, and points on boundaries, most where no face has neighbours.
    size.Points +=
      scheme.GetFaceMemory().Points * size.Faces + 0.5 * corners * std::sqrt(size.Faces / faces);
  }
  size.HasLargeIds =
    16. * (size.Faces + corners + points + 2. * size.Lines) > static_cast<double>(LargestSmallId);
  return size;
}

/// The peak, in bytes, of a run that makes the normals of its options or of one that makes none.
double EstimateBytes(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceScheme<int>& scheme, const SurfaceOptions& options, const SurfaceSize& size)
{
  if (options.NormalsWhereSmooth)
  {
    SurfaceOptions sharp = options;
    sharp.GenerateLimitNormals = sharp.NormalsWhereSmooth = false;
    SurfaceOptions smooth = options;
    smooth.NormalsWhereSmooth = false;
    smooth.Features = FeatureOptions(); // which find nothing sharp
    return std::max(EstimateBytes(input, cells, scheme, sharp, size),
      EstimateBytes(input, cells, scheme, smooth, size));
  }
  const FaceMemory ofFace = scheme.GetFaceMemory();
  const bool readsLimits = options.ReadsLimit();
  const bool isSmooth =
    (scheme.IsDual() || !HasFlags(options.Features)) && cells.Segments.empty() && IsClosed(cells);
  const bool keepsTangents = options.GenerateTangents; // normals alone do not
  const double ofNext = options.HasFrames() && (keepsTangents || ofFace.FramesOfNext == 0.)
    ? ofFace.FramesOfNext
    : ofFace.LimitsOfNext;
  const double beside = readsLimits && ofNext > 0. && SkipsLast(cells, scheme, options) ? ofNext
    : options.HasFrames() ? (keepsTangents ? 1. : 0.72) * ofFace.Frames
    : readsLimits         ? ofFace.Limits
    : isSmooth            ? ofFace.Smooth
                          : ofFace.Sharp;
  const double items = size.Faces + size.Lines;
  const double ofSides =
    options.SplitSharpEdges ? 2.5 * ofFace.Ids : 0.; // and a copy of the output
  const double data = GetBytesPerTuple(input->GetPointData());
  const bool areFloat = input->GetPoints() && input->GetPoints()->GetDataType() == VTK_FLOAT &&
    options.OutputPointsPrecision != vtkAlgorithm::DOUBLE_PRECISION;
  const double frames = (options.GenerateLimitNormals ? (areFloat ? 12. : 24.) : 0.) +
    (options.GenerateTangents ? 48. : 0.);
  return BytesOfPages + items * (ofFace.Ids + GetBytesPerTuple(input->GetCellData())) +
    size.Points * (24. + data + frames) +
    ((size.HasLargeIds ? 2. : 1.) * beside + ofSides) * items +
    (readsLimits ? 1.2 : 0.3) * data * size.Points;
}

/// An error message if the output would be too large.
std::string CheckSize(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceScheme<int>& scheme, const SurfaceOptions& options, const SurfaceSize& size)
{
  const double all = size.Faces + size.Lines + static_cast<double>(cells.VertexCells.size());
  const std::string tooMany = CheckNumberOfCells(
    all, all * scheme.GetFaceMemory().Ids, options.Levels, options.MaximumNumberOfCells);
  return tooMany.empty() ? CheckMemory(all, size.Points,
                             EstimateBytes(input, cells, scheme, options, size), options.Levels)
                         : tooMany;
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
    const bool hasTangents = options.HasFrames();
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
        if (levels > 0.) // limits are at points that a step made, with all corners around
        {
          const double limits = (options.ProjectToLimit ? 4. : 0.) + (hasTangents ? 8. : 0.);
          this->OfVertices += limits;
          this->OfFaces += limits;
        }
        return;
      case DenseRows::OfLimits:
        // The limits of neighbours, of opposite corners and of points near them read all of these.
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
  SurfaceSize size = CountOutput(cells, scheme, options);
  if (options.Splits) // of cells that go on, with some around them
  {
    const std::vector<char>& flags = options.Splits->Flags.back();
    const auto steps = options.Levels - static_cast<int>(options.Splits->Flags.size());
    const double last =
      std::ldexp(4. * static_cast<double>(std::count(flags.begin(), flags.end(), 1)), 2 * steps);
    size = { std::min(size.Faces, last), std::min(size.Lines, last), std::min(size.Points, last),
      size.HasLargeIds };
  }
  const std::string tooLarge = CheckSize(input, cells, scheme, options, size);
  const std::string tooDense = tooLarge.empty() ? CheckDenseRows(cells, scheme, options) : tooLarge;
  if (!tooDense.empty())
  {
    options.Fail(tooDense);
    return false;
  }
  isLarge = size.HasLargeIds;
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
  if (scheme.IsDual() && (HasFlags(features) || options.Features.CornerAngles || options.Flatness))
  {
    options.Warn(
      "This scheme is dual and has no creases and corners: the filter ignores flags, "
      "marks, sharpness, PreserveInterfaces, DetectFeatures, and angles and flatness of corners.");
  }
}

}
