// SPDX-License-Identifier: BSD-3-Clause
// Meshes for the tests of dual schemes, and what every dual step must keep.
#ifndef DualSchemeTools_h
#define DualSchemeTools_h

#include "Core/Surfaces/Steps/SurfaceSchemes.h"
#include "Core/Surfaces/Steps/SurfaceSteps.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace dualtools
{

using Level = subdivision::SurfaceLevel<int>;
using Mesh = subdivision::PolygonMesh<int>;
using Faces = std::vector<std::vector<int>>;
using Points = std::vector<std::array<double, 3>>;

struct Shape
{
  std::string Name;
  int NumberOfVertices;
  Faces Polygons;
  int Euler;        ///< of the surface, sheets apart
  bool Orientation; ///< all faces are oriented alike
};

Level MakeLevel(int vertices, const Faces& faces, const std::vector<int>& segments = {});

Faces MakeQuads(int columns, int rows);

Faces MakeTorus(int n);

/// k triangles around vertex 0; open: k + 1 vertices around.
Faces MakeFan(int k, bool open);

Faces MakeMoebius(int n);

std::vector<Shape> MakeShapes();

Points MakePoints(int n, unsigned seed = 3);

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

Faces GetFaces(const Mesh& mesh);

/// A level is what its cells say, every edge has one or two faces, every face its own corners.
void ExpectConforming(const Level& level);

/// V - E + F without vertices that have no faces.
int GetEuler(const Level& level);

int CountOpenSides(const Level& level);

/// Twins run in opposite directions wherever the faces are oriented alike.
void ExpectOriented(const Level& level);

/// Boundary points of a level, with those of a neighbour each: the boundary as segments.
using Segment = std::array<std::array<double, 3>, 2>;
std::vector<Segment> GetBoundary(const Level& level, const Points& points);

inline bool IsNear(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 1e-13;
}

/// `fine` is Chaikin's boundary of `coarse`, whose half-edges follow one another.
void ExpectChaikin(const std::vector<Segment>& coarse, const std::vector<Segment>& fine);

/// Rows sum to one, have no negative entries, and no column twice.
void ExpectAverages(const subdivision::SparseRows<int>& rows);

std::array<double, 3> GetCentre(const Mesh& mesh, int face, const Points& points);

/// What holds on every mesh and for both schemes.
void ExpectDualSteps(subdivision::SurfaceSchemeKind kind, int levels);

/// Twice `stepsOfOne` steps: each time the boundary is that of one step of Chaikin's.
void ExpectChaikinBoundary(subdivision::SurfaceSchemeKind kind, int stepsOfOne);

/// Inside a plane grid the points of the second step are odd multiples of 1 / scale, each once.
void ExpectRegularGrid(subdivision::SurfaceSchemeKind kind, double scale, std::size_t count);

/// Open and closed fans of 2,000 triangles.
void ExpectLargeFans(subdivision::SurfaceSchemeKind kind, int levels);

}

#endif
