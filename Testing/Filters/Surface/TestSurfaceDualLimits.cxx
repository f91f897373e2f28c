// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: limits of the dual schemes. The limit at a face is the mean of its corners, on
// all levels; where a vertex's limit is such a mean, or the middle of a side of the boundary, it is
// on the surface.
#include "DualSchemeTools.h"
#include "PointTools.h"

using namespace dualtools;
using namespace point_tools;

namespace
{

using subdivision::LimitKind;
using subdivision::SurfaceSchemeKind;
using Vector = std::array<double, 3>;

/// The sum of weight(j) times the j-th corner of a face.
Vector SumCorners(const Mesh& mesh, const Points& points, int face,
  const std::function<double(int j, int size)>& weight)
{
  Vector sum{};
  const int size = mesh.GetSize(face);
  for (int j = 0; j < size; ++j)
  {
    const Vector& corner = points[mesh.Vertices[mesh.GetFirst(face) + j]];
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += weight(j, size) * corner[c];
    }
  }
  return sum;
}

double Mean(int, int size)
{
  return 1. / size;
}

/// A mesh after some steps, and the limits of its control vertices.
struct Subdivided
{
  Subdivided(const Shape& shape, SurfaceSchemeKind kind, int steps, int firstStep = 0)
    : Levels(MakeLevel(shape.NumberOfVertices, shape.Polygons), kind, steps, firstStep)
    , Control(MakeLevel(shape.NumberOfVertices, shape.Polygons), kind, 0, firstStep)
    , Values{ MakeRandomPoints(shape.NumberOfVertices, 3) }
  {
    for (int step = 0; step < steps; ++step)
    {
      this->Values.push_back(this->Levels.Apply(step, this->Values.back()));
    }
  }
  Points GetLimits(LimitKind kind) const { return this->Control.ApplyLimit(kind, this->Values[0]); }
  const Mesh& GetLast() const
  {
    return this->Levels[static_cast<int>(this->Values.size()) - 1].Mesh;
  }

  const Steps Levels;
  const Steps Control;
  std::vector<Points> Values;
};

/// The face whose mean is here; -1: none.
int FindFace(const Mesh& mesh, const Points& points, const Vector& at)
{
  for (int f = 0; f < mesh.NumberOfFaces; ++f)
  {
    if (IsNear(SumCorners(mesh, points, f, Mean), at))
    {
      return f;
    }
  }
  return -1;
}

/// The open side in whose middle this is; -1: none.
int FindOpenSide(const Mesh& mesh, const Points& points, const Vector& at)
{
  for (int c = 0; c < mesh.Twins.size(); ++c)
  {
    const Vector& a = points[mesh.Vertices[c]];
    const Vector& b = points[mesh.Vertices[mesh.Next(c)]];
    if (mesh.Twins[c] < 0 &&
      IsNear({ (a[0] + b[0]) / 2., (a[1] + b[1]) / 2., (a[2] + b[2]) / 2. }, at))
    {
      return c;
    }
  }
  return -1;
}

void ExpectSameDirection(const Vector& a, const Vector& b, const std::string& what)
{
  EXPECT_GT(Length(a), 0.) << what;
  EXPECT_GT(a[0] * b[0] + a[1] * b[1] + a[2] * b[2], 0.) << what;
  EXPECT_LT(Length(Cross(a, b)), 1e-9 * Length(a) * Length(b)) << what;
}

/// All vertices have their limits on what four steps make; firstStep 1: of the second step on.
void ExpectOnSurface(SurfaceSchemeKind kind, int firstStep)
{
  for (const Shape& shape : MakeShapes())
  {
    const Subdivided made(shape, kind, firstStep == 0 ? 4 : 3, firstStep);
    const Points limits = made.GetLimits(LimitKind::Position);
    for (int v = 0; v < shape.NumberOfVertices; ++v)
    {
      EXPECT_TRUE(FindFace(made.GetLast(), made.Values.back(), limits[v]) >= 0 ||
        FindOpenSide(made.GetLast(), made.Values.back(), limits[v]) >= 0)
        << shape.Name << " vertex " << v << " first step " << firstStep;
    }
  }
}

/// The tangents of vertices inside have the plane of the face that each step makes there: of its
/// corners, times cosines and sines.
void ExpectPlanesInside(SurfaceSchemeKind kind, std::size_t least)
{
  int tested = 0;
  for (const Shape& shape : MakeShapes())
  {
    const Subdivided made(shape, kind, 3);
    const Points limits = made.GetLimits(LimitKind::Position);
    const Points first = made.GetLimits(LimitKind::Tangent1);
    const Points second = made.GetLimits(LimitKind::Tangent2);
    for (int v = 0; v < shape.NumberOfVertices; ++v)
    {
      const std::string what = shape.Name + " vertex " + std::to_string(v);
      const int face = FindFace(made.GetLast(), made.Values.back(), limits[v]);
      const bool hasPlane = Length(first[v]) > 0. && Length(second[v]) > 0.;
      if (face < 0 || !hasPlane)
      {
        continue;
      }
      ++tested;
      const auto wave = [&](double (*of)(double))
      {
        return SumCorners(made.GetLast(), made.Values.back(), face,
          [of](int j, int size) { return of(2. * std::acos(-1.) * j / size); });
      };
      ExpectSameDirection(Cross(first[v], second[v]),
        Cross(
          wave([](double t) { return std::cos(t); }), wave([](double t) { return std::sin(t); })),
        what);
      EXPECT_GE(static_cast<std::size_t>(made.GetLast().GetSize(face)), least) << what;
    }
  }
  EXPECT_GT(tested, 20);
}

}

TEST(SurfaceDualLimits, OfDooSabinAreOnTheSurface)
{
  ExpectOnSurface(SurfaceSchemeKind::DooSabin, 0);
}

TEST(SurfaceDualLimits, OfMidedgeAreOnTheSurface)
{
  ExpectOnSurface(SurfaceSchemeKind::Midedge, 0);
  ExpectOnSurface(SurfaceSchemeKind::Midedge, 1);
}

// A quarter of all points of a regular mesh: (1, 6, 1) (1, 6, 1) / 64.
TEST(SurfaceDualLimits, OfRegularVerticesAreThoseOfTheBiquadraticSpline)
{
  const Steps grid(MakeLevel(16, MakeQuads(3, 3)), SurfaceSchemeKind::DooSabin, 0);
  for (int column = 0; column < 16; ++column)
  {
    Points impulse(16, Vector{});
    impulse[column][0] = 1.;
    const auto weight = [](int a, int b) { return a == b ? 6. : std::abs(a - b) == 1 ? 1. : 0.; };
    EXPECT_NEAR(grid.ApplyLimit(LimitKind::Position, impulse)[5][0],
      weight(column % 4, 1) * weight(column / 4, 1) / 64., 1e-15);
  }
}

TEST(SurfaceDualLimits, PlanesInside)
{
  ExpectPlanesInside(SurfaceSchemeKind::DooSabin, 3);
  ExpectPlanesInside(SurfaceSchemeKind::Midedge, 4); // three faces have none
}

// From the second step on each step quarters what lies between the inner and the outer vertices of
// the face at a side of the boundary.
TEST(SurfaceDualLimits, DooSabinAcrossTheBoundary)
{
  int tested = 0;
  for (const Shape& shape : MakeShapes())
  {
    for (const int steps : { 2, 4 })
    {
      const Subdivided made(shape, SurfaceSchemeKind::DooSabin, steps);
      const Mesh& mesh = made.GetLast();
      const Points& points = made.Values.back();
      const Points limits = made.GetLimits(LimitKind::Position);
      const Points along = made.GetLimits(LimitKind::Tangent1);
      const Points across = made.GetLimits(LimitKind::Tangent2);
      for (int v = 0; v < shape.NumberOfVertices; ++v)
      {
        const std::string what = shape.Name + " vertex " + std::to_string(v);
        const int side = FindOpenSide(mesh, points, limits[v]);
        if (side < 0)
        {
          continue;
        }
        ++tested;
        const int next = mesh.Next(side);
        const int third = mesh.Next(next);
        Vector between;
        for (int c = 0; c < 3; ++c)
        {
          between[c] =
            (points[mesh.Vertices[third]][c] + points[mesh.Vertices[mesh.Next(third)]][c] -
              points[mesh.Vertices[side]][c] - points[mesh.Vertices[next]][c]) /
            2. * std::pow(4., steps - 2);
        }
        EXPECT_LT(Length({ between[0] - across[v][0], between[1] - across[v][1],
                    between[2] - across[v][2] }),
          1e-11)
          << what;
        const Vector& a = points[mesh.Vertices[side]];
        const Vector& b = points[mesh.Vertices[next]];
        EXPECT_LT(Length(Cross(along[v], { b[0] - a[0], b[1] - a[1], b[2] - a[2] })), 1e-11)
          << what;
      }
    }
  }
  EXPECT_GT(tested, 60);
}

TEST(SurfaceDualLimits, OfLinesAreCubicSplines)
{
  const Points points = MakeRandomPoints(4, 3);
  for (const auto kind : { SurfaceSchemeKind::DooSabin, SurfaceSchemeKind::Midedge })
  {
    const Steps line(MakeLevel(4, {}, { { 0, 1 }, { 1, 2 } }), kind, 0);
    const Points limits = line.ApplyLimit(LimitKind::Position, points);
    const Points tangents = line.ApplyLimit(LimitKind::Tangent1, points);
    EXPECT_EQ(limits[0], points[0]);
    EXPECT_EQ(limits[3], points[3]);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(limits[1][c], (points[0][c] + 4. * points[1][c] + points[2][c]) / 6., 1e-15);
      EXPECT_NEAR(std::abs(tangents[1][c]), std::abs(points[0][c] - points[2][c]), 1e-15);
      EXPECT_EQ(tangents[3][c], 0.);
    }
  }
}

// Through the filter: faces on all sides of a cube, one of them turned, so that normals point
// outwards as most faces say; they are perpendicular to the tangents.
TEST(SurfaceDualLimits, NormalsOfTheFilterPointOutwards)
{
  Points points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ i % 2 - 0.5, i / 2 % 2 - 0.5, i / 4 - 0.5 });
  }
  const Data input = MakeData(points,
    { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
      { 1, 5, 7, 3 } });
  for (const int scheme : { vtkSurfaceSubdivision::DOO_SABIN, vtkSurfaceSubdivision::MIDEDGE })
  {
    for (int levels = 0; levels <= 3; ++levels)
    {
      vtkNew<vtkSurfaceSubdivision> filter;
      filter->SetInputData(input);
      filter->SetScheme(scheme);
      filter->SetNumberOfLevels(levels);
      filter->ProjectToLimitOn();
      filter->GenerateLimitNormalsOn();
      filter->GenerateTangentsOn();
      filter->Update();
      vtkPolyData* output = filter->GetOutput();
      vtkDataArray* normals = output->GetPointData()->GetArray("LimitNormals");
      ASSERT_NE(normals, nullptr);
      EXPECT_EQ(output->GetPointData()->GetNormals(), normals);
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        Vector x;
        Vector normal;
        Vector tangent;
        output->GetPoint(i, x.data());
        normals->GetTuple(i, normal.data());
        output->GetPointData()->GetArray("LimitTangent1")->GetTuple(i, tangent.data());
        EXPECT_NEAR(Length(normal), 1., 1e-12);
        EXPECT_GT(x[0] * normal[0] + x[1] * normal[1] + x[2] * normal[2], 0.3 * Length(x))
          << scheme << " level " << levels << " point " << i;
        EXPECT_NEAR(
          tangent[0] * normal[0] + tangent[1] * normal[1] + tangent[2] * normal[2], 0., 1e-12);
      }
    }
  }
}
