// SPDX-License-Identifier: BSD-3-Clause
// Meshes for the tests of dual schemes.
#ifndef DualSchemeTools_h
#define DualSchemeTools_h

#include "SurfaceTools.h"

#include "Core/Surfaces/Steps/SurfaceSteps.h"

namespace dualtools
{

using Level = subdivision::SurfaceLevel<int>;
using Mesh = subdivision::PolygonMesh<int>;
using Faces = surfacetools::Polygons;
using Point = surfacetools::Point;
using Points = std::vector<Point>;
using Data = vtkSmartPointer<vtkPolyData>;
using surfacetools::ExpectSameBits;
using surfacetools::MakeLevel;
using surfacetools::MakeRandomPoints;
using surfacetools::RunFilter;

struct Shape
{
  std::string Name;
  int NumberOfVertices;
  Faces Polygons;
  int Euler;        ///< of the surface, sheets apart
  bool Orientation; ///< all faces are oriented alike
};

Faces MakeQuads(int columns, int rows);

Faces MakeMoebius(int n);

std::vector<Shape> MakeShapes();

class Steps
{
public:
  Steps(Level&& control, subdivision::SurfaceSchemeKind kind, int steps, int firstStep = 0);
  const Level& operator[](int level) const { return this->Values->GetLevel(level); }
  subdivision::SparseRows<int> GetRows(int step) const;
  Points Apply(int step, const Points& in) const;
  /// Limits, or tangents, of the vertices of the last level.
  Points ApplyLimit(subdivision::LimitKind kind, const Points& in) const;
  /// Of the faces after a step, on those before it.
  std::vector<subdivision::Carrier<int>> GetCarriers(int step) const;

private:
  std::unique_ptr<subdivision::SurfaceSteps<int>> Values;
};

int CountOpenSides(const Level& level);

inline bool IsNear(const Point& a, const Point& b)
{
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 1e-13;
}

Point GetCentre(const Mesh& mesh, int face, const Points& points);

/// Of a mesh that the surface filter takes.
Data MakeData(const Points& points, const Faces& faces, const Faces& lines = {},
  const std::vector<vtkIdType>& vertices = {});

void AddIds(
  vtkDataSetAttributes* data, const char* name, const std::vector<vtkIdType>& values, bool global);

}

#endif
