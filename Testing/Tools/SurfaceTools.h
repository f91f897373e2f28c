// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceTools.h
 * Small surfaces, their levels and rows, and checks that hold for every scheme which replaces
 * edges.
 */
#ifndef SurfaceTools_h
#define SurfaceTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSurfaceSubdivision.h"

#include "Core/Operators/RowBlock.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"
#include "Core/Surfaces/Steps/SurfaceSchemes.h"

namespace surfacetools
{

using namespace subdivision;
using Point = std::array<double, 3>;
using Polygons = std::vector<std::vector<vtkIdType>>;

struct Model
{
  std::vector<Point> Points;
  Polygons Faces;
  Polygons Lines; ///< of two points
  std::vector<vtkIdType> Corners;
};

std::vector<Point> MakeRandomPoints(std::size_t count, unsigned seed);

/// n triangles around point 0; open: half of a disk, with point 0 on the boundary.
Model MakeFan(int n, bool open);

/// A grid over the unit cells of two vectors, with its four corners flagged.
Model MakeSheet(int width, int height, bool triangles, Point a, Point b);

/// Random positions for the topologies that matter.
std::map<std::string, Model> MakeZoo(bool triangles);

template <typename T>
Buffer<int> ToBuffer(const T& values)
{
  Buffer<int> buffer(static_cast<vtkIdType>(values.size()));
  std::transform(values.begin(), values.end(), buffer.begin(), [](auto v) { return int(v); });
  return buffer;
}

SurfaceLevel<int> MakeLevel(std::size_t points, const Polygons& faces, const Polygons& lines = {});

/// A surface that is subdivided step by step.
class Walk
{
public:
  Walk(const Model& model, SurfaceSchemeKind kind, bool modifiedBoundary = true);

  RowBlock<int> GetRows() const;
  static std::vector<Point> Apply(const RowBlock<int>& rows, const std::vector<Point>& in);
  std::vector<Point> GetLimit(LimitKind kind = LimitKind::Position) const;
  void Step();

  /// The other ends of a vertex's edges.
  std::vector<int> GetNeighbours(int vertex) const;

  std::shared_ptr<const SurfaceScheme<int>> Scheme;
  std::vector<Point> Points;
  SurfaceLevel<int> Level;
};

inline double GetDistance(const Point& a, const Point& b)
{
  return std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) });
}

/// The incidences of a level are those that a search over its faces finds.
void CheckIncidences(const SurfaceLevel<int>& level);

/// Rows sum to 1, whatever the input is; a step commutes with affine maps.
void CheckRows(const Walk& walk);

/// V - E + F, where free lines count as edges.
inline vtkIdType GetEuler(const PolygonMesh<int>& mesh)
{
  return mesh.NumberOfVertices - mesh.GetNumberOfEdges() + mesh.NumberOfFaces;
}

// ------------------------------------------------------------------------------------------------
// Through the filter

vtkSmartPointer<vtkPolyData> MakeInput(const Model& model);

inline vtkSmartPointer<vtkPolyData> MakeInput(
  const std::vector<Point>& points, const Polygons& faces, const Polygons& lines = {})
{
  return MakeInput(Model{ points, faces, lines, {} });
}

vtkSmartPointer<vtkPolyData> RunFilter(vtkPolyData* input, int scheme, int levels,
  bool limit = false, const std::function<void(vtkSurfaceSubdivision*)>& configure = nullptr);

/// The uniform mesh, at the limit, of which an adaptive one is a part: both have plain boundaries.
inline vtkSmartPointer<vtkPolyData> RunPlainSqrtThree(vtkPolyData* input, int levels)
{
  return RunFilter(input, vtkSurfaceSubdivision::SQRT_THREE, levels, true,
    [](vtkSurfaceSubdivision* filter) { filter->ModifiedBoundaryOff(); });
}

/// The first limit normals, of length 1.
std::vector<Point> GetNormals(vtkPolyData* output, std::size_t count);

inline void ExpectSameBits(vtkPolyData* a, vtkPolyData* b)
{
  EXPECT_EQ(multi_dimensional_subdivision_tools::Compare(a, b, false), "");
}

}

#endif
