// SPDX-License-Identifier: BSD-3-Clause
// The midedge scheme: masks and topology. TestSurfaceDualSchemes.cxx has what Doo-Sabin has, too.
#include "DualSchemeTools.h"

using namespace dualtools;

namespace
{

constexpr auto Kind = subdivision::SurfaceSchemeKind::Midedge;

TEST(SurfaceMidedge, VerticesAreMidpoints)
{
  const Steps steps(MakeLevel(9, MakeQuads(2, 2)), Kind, 1);
  const auto rows = steps.GetRows(0);
  const Mesh& mesh = steps[0].Mesh;
  ASSERT_EQ(rows.GetNumberOfRows(), 12 + 8); // edges, boundary vertices
  std::set<std::pair<int, int>> seen;
  for (int r = 0; r < 12; ++r)
  {
    const int k = rows.Offsets[r];
    ASSERT_EQ(rows.Offsets[r + 1] - k, 2);
    EXPECT_EQ(rows.Weights[k], 0.5);
    EXPECT_EQ(rows.Weights[k + 1], 0.5);
    seen.insert(std::minmax(rows.Columns[k], rows.Columns[k + 1]));
  }
  for (int e = 0; e < 12; ++e)
  {
    const auto ends = std::minmax(mesh.EdgeVertices[2 * e], mesh.EdgeVertices[2 * e + 1]);
    EXPECT_EQ(seen.count(ends), 1u);
  }
}

/// Two steps of a face of k corners on itself: row 0 of the circulant matrix.
std::vector<double> GetTwoSteps(int k)
{
  std::vector<vtkIdType> face(k);
  for (int i = 0; i < k; ++i)
  {
    face[i] = i;
  }
  const Steps steps(MakeLevel(k, { face }), Kind, 2);
  const auto rows = subdivision::Multiply(steps.GetRows(1), steps.GetRows(0));
  std::vector<double> weights(k, 0.);
  const int row = steps[2].Mesh.Vertices[steps[2].Mesh.GetFirst(0)];
  for (int i = rows.Offsets[row]; i < rows.Offsets[row + 1]; ++i)
  {
    weights[rows.Columns[i]] += rows.Weights[i];
  }
  return weights;
}

TEST(SurfaceMidedge, SpectrumOfTwoSteps)
{
  // cos^2(pi m / k): 1/4 twice for three sides, as much as there is in the rings around.
  for (int k = 3; k <= 12; ++k)
  {
    const std::vector<double> weights = GetTwoSteps(k);
    for (int mode = 0; mode < k; ++mode)
    {
      double re = 0.;
      double im = 0.;
      for (int j = 0; j < k; ++j)
      {
        const double angle = 2. * std::acos(-1.) * mode * j / k;
        re += weights[j] * std::cos(angle);
        im += weights[j] * std::sin(angle);
      }
      const double c = std::cos(std::acos(-1.) * mode / k);
      EXPECT_NEAR(std::hypot(re, im), c * c, 1e-14);
    }
  }
}

/// How far the surface around a face of k sides is from its plane: the largest sine between their
/// normals, after some steps.
double MeasureBend(int k, int numberOfSteps)
{
  Faces faces(1);
  for (int i = 0; i < k; ++i)
  {
    faces[0].push_back(i);
  }
  constexpr int rings = 3;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int i = 0; i < k; ++i)
    {
      const int next = (i + 1) % k;
      faces.push_back({ ring * k + next, ring * k + i, ring * k + k + i, ring * k + k + next });
    }
  }
  const int size = (rings + 1) * k;
  const Steps steps(MakeLevel(size, faces), Kind, numberOfSteps);
  Points points;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2. * std::acos(-1.) * i / k;
    const double radius = 1. + i / k;
    points.push_back(
      { radius * std::cos(angle), radius * std::sin(angle), 0.1 * radius * radius * (i % 3) });
  }
  for (int step = 0; step < numberOfSteps; ++step)
  {
    points = steps.Apply(step, points);
  }
  const Mesh& mesh = steps[numberOfSteps].Mesh;
  auto getNormal = [&](int face)
  {
    const auto centre = GetCentre(mesh, face, points);
    std::array<double, 3> normal{};
    for (int c = mesh.GetFirst(face); c < mesh.GetFirst(face) + mesh.GetSize(face); ++c)
    {
      const auto& a = points[mesh.Vertices[c]];
      const auto& b = points[mesh.Vertices[mesh.Next(c)]];
      for (int i = 0; i < 3; ++i)
      {
        const int j = (i + 1) % 3;
        const int l = (i + 2) % 3;
        normal[i] +=
          (a[j] - centre[j]) * (b[l] - centre[l]) - (a[l] - centre[l]) * (b[j] - centre[j]);
      }
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    return std::array<double, 3>{ normal[0] / length, normal[1] / length, normal[2] / length };
  };
  const auto own = getNormal(0);
  double bend = 0.;
  for (int c = mesh.GetFirst(0); c < mesh.GetFirst(0) + mesh.GetSize(0); ++c)
  {
    VisitFan(mesh, c,
      [&](const subdivision::FanStep<int>& step)
      {
        const auto n = getNormal(mesh.GetFace(step.Corner));
        bend = std::max(bend,
          std::hypot(own[1] * n[2] - own[2] * n[1], own[2] * n[0] - own[0] * n[2],
            own[0] * n[1] - own[1] * n[0]));
      });
  }
  return bend;
}

TEST(SurfaceMidedge, NormalsSettleFastButNotAtThreeSides)
{
  for (int k = 4; k <= 8; ++k)
  {
    EXPECT_LT(MeasureBend(k, 12), 0.6 * MeasureBend(k, 10)) << k;
    EXPECT_LT(MeasureBend(k, 14), 0.02) << k;
  }
  // Three sides: a quarter is not only theirs, and normals settle more slowly than any power.
  EXPECT_GT(MeasureBend(3, 12), 0.8 * MeasureBend(3, 10));
  EXPECT_GT(MeasureBend(3, 14), 0.8 * MeasureBend(3, 12));
}

TEST(SurfaceMidedge, Counts)
{
  const Steps cube(MakeLevel(8, MakeShapes()[1].Polygons), Kind, 2);
  EXPECT_EQ(cube[1].Mesh.NumberOfVertices, 12);
  EXPECT_EQ(cube[1].Mesh.NumberOfFaces, 14);
  EXPECT_EQ(cube[2].Mesh.NumberOfVertices, 24);
  EXPECT_EQ(cube[2].Mesh.NumberOfFaces, 26);
  const Steps triangle(MakeLevel(3, { { 0, 1, 2 } }), Kind, 3);
  EXPECT_EQ(triangle[1].Mesh.NumberOfVertices, 6);
  EXPECT_EQ(triangle[1].Mesh.NumberOfFaces, 4);
  EXPECT_EQ(CountOpenSides(triangle[1]), 6);
  EXPECT_EQ(triangle[2].Mesh.NumberOfVertices, 9);
  EXPECT_EQ(triangle[2].Mesh.NumberOfFaces, 7);
  EXPECT_EQ(CountOpenSides(triangle[2]), 6);
  EXPECT_EQ(CountOpenSides(triangle[3]), 12);
  const Steps even(MakeLevel(3, { { 0, 1, 2 } }), Kind, 1, 1);
  EXPECT_EQ(even[1].Mesh.NumberOfFaces, 1);
  const Steps pillow(MakeLevel(3, { { 0, 1, 2 }, { 0, 2, 1 } }), Kind, 1);
  EXPECT_EQ(pillow[1].Mesh.NumberOfFaces, 2);
  EXPECT_EQ(CountOpenSides(pillow[1]), 0);
}

TEST(SurfaceMidedge, OtherMeshesBeginWithAnOddStep)
{
  // The stamp of one step is not believed where cells are missing.
  const Data once =
    RunFilter(MakeData(MakeRandomPoints(3, 3), { { 0, 1, 2 } }), vtkSurfaceSubdivision::MIDEDGE, 1);
  EXPECT_EQ(RunFilter(once, vtkSurfaceSubdivision::MIDEDGE, 1)->GetNumberOfPolys(), 7);
  auto part = Data::New();
  part->ShallowCopy(once);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  part->SetPolys(cells);
  EXPECT_EQ(RunFilter(part, vtkSurfaceSubdivision::MIDEDGE, 1)->GetNumberOfPolys(), 4);
}

}
