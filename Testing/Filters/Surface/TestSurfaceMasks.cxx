// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceMasks.cxx
 * Rows of Loop and Catmull-Clark next to curves and corners, by the formulas of Mathematics 12.
 */
#include "SurfaceTools.h"

#include "Core/Surfaces/Scheme/SurfaceTags.h"

using namespace surfacetools;

namespace
{

/// k faces around point 0, which take an angle in the plane; points 1, 2, ... are the other ends of
/// the k + 1 edges, and for quads then follow the far corners.
Model MakeSector(int k, double angle, bool triangles)
{
  Model model;
  model.Points.push_back({ 0., 0., 0. });
  for (int j = 0; j <= k; ++j)
  {
    const double t = angle * j / k;
    model.Points.push_back({ std::cos(t), std::sin(t), 0. });
  }
  for (vtkIdType j = 1; j <= k; ++j)
  {
    if (triangles)
    {
      model.Faces.push_back({ 0, j, j + 1 });
    }
    else
    {
      const double t = angle * (static_cast<double>(j) - 0.5) / k;
      model.Faces.push_back({ 0, j, static_cast<vtkIdType>(model.Points.size()), j + 1 });
      model.Points.push_back({ 1.5 * std::cos(t), 1.5 * std::sin(t), 0. });
    }
  }
  return model;
}

/// The row of the point of the edge from point 0 to another, by column.
std::map<int, double> FindEdgeRow(const Walk& walk, int other)
{
  const PolygonMesh<int>& mesh = walk.Level.Mesh;
  const RowBlock<int> rows = walk.GetRows();
  std::map<int, double> row;
  for (int e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const int* ends = mesh.EdgeVertices.data() + 2 * e;
    if (std::min(ends[0], ends[1]) == 0 && std::max(ends[0], ends[1]) == other)
    {
      const std::size_t at = static_cast<std::size_t>(mesh.NumberOfVertices + e);
      for (std::size_t i = rows.GetBegin(at); i < rows.GetEnd(at); ++i)
      {
        row[rows.GetColumns()[i]] += rows.GetWeights()[i];
      }
    }
  }
  return row;
}

/// The rule of an edge inside a sector: theta is the angle of one face.
void CheckEdges(const Model& model, int k, double theta, bool triangles)
{
  const Walk walk(model, triangles ? SurfaceSchemeKind::Loop : SurfaceSchemeKind::CatmullClark);
  // The other ends lie on the boundary too, each with two faces: the mean of what both ask for.
  const double gammaOfSmooth = (triangles ? 0.5 : 0.375) - std::cos(Pi / 2.) / 4.;
  const double gamma = (triangles ? 0.5 : 0.375) - std::cos(theta) / 4.;
  for (int j = 2; j <= k; ++j)
  {
    std::map<int, double> row = FindEdgeRow(walk, j);
    const double own = triangles ? 0.75 - gamma : 0.625 - gamma;
    const double other = triangles ? gamma : gamma - 0.125;
    const double ofOther = triangles ? gammaOfSmooth : gammaOfSmooth - 0.125;
    const double fromOther = triangles ? 0.75 - gammaOfSmooth : 0.625 - gammaOfSmooth;
    if (triangles)
    {
      EXPECT_NEAR(row[0], (own + ofOther) / 2., 1e-14) << "k " << k << " edge " << j;
      EXPECT_NEAR(row[j], (other + fromOther) / 2., 1e-14) << "k " << k << " edge " << j;
      EXPECT_NEAR(row[j - 1], 0.125, 1e-14);
      EXPECT_NEAR(row[j + 1], 0.125, 1e-14);
    }
    else
    {
      EXPECT_NEAR(row[0], (own + ofOther) / 2. + 0.125, 1e-14) << "k " << k << " edge " << j;
      EXPECT_NEAR(row[j], (other + fromOther) / 2. + 0.125, 1e-14) << "k " << k << " edge " << j;
      EXPECT_NEAR(row[j - 1], 0.0625, 1e-14);
      EXPECT_NEAR(row[k + j], 0.0625, 1e-14);
    }
  }
}

}

TEST(SurfaceMasks, GammaNextToASmoothBoundary)
{
  for (const bool triangles : { true, false })
  {
    for (int k = 2; k < 8; ++k)
    {
      CheckEdges(MakeSector(k, Pi, triangles), k, Pi / k, triangles);
    }
  }
}

TEST(SurfaceMasks, GammaAtConvexCornersIsClamped)
{
  const double least = Pi / 8.;
  const double most = 7. * Pi / 8.;
  for (const bool triangles : { true, false })
  {
    for (int k = 2; k < 6; ++k)
    {
      for (const double angle : { 0.2, 0.6, 1.5, 2.5, 2.9, 3.1 })
      {
        Model model = MakeSector(k, angle, triangles);
        model.Corners = { 0 };
        CheckEdges(model, k, std::max(least, std::min(angle, most)) / k, triangles);
      }
    }
  }
}

/// The end of a crease that is a corner bounds no sector, so that no angle changes its rule.
TEST(SurfaceMasks, EdgesAtTheEndOfACreaseTakeThePlainRule)
{
  for (const bool triangles : { true, false })
  {
    for (const int k : { 4, 6, 7, 9 })
    {
      Model model = MakeSector(k, 2. * Pi, triangles);
      for (std::vector<vtkIdType>& face : model.Faces)
      {
        std::replace(face.begin(), face.end(), vtkIdType(k + 1), vtkIdType(1));
      }
      Walk walk(model, triangles ? SurfaceSchemeKind::Loop : SurfaceSchemeKind::CatmullClark);
      const PolygonMesh<int>& mesh = walk.Level.Mesh;
      SurfaceFeatures features;
      for (int e = 0; e < mesh.GetNumberOfEdges(); ++e)
      {
        const int* ends = mesh.EdgeVertices.data() + 2 * e;
        features.SharpEdges.push_back(std::min(ends[0], ends[1]) == 0 && ends[0] + ends[1] == 1);
      }
      walk.Level.Tags = ClassifySurface(mesh, *walk.Scheme, features, walk.Points.data()->data());
      walk.Scheme->Prepare(walk.Level);
      ASSERT_EQ(walk.Level.Tags.Vertices[0], VertexTag::Corner);
      for (int j = 2; j <= k; ++j)
      {
        std::map<int, double> row = FindEdgeRow(walk, j);
        // The other end is on the boundary, with two faces: gamma is 1/2 there, or 3/8.
        EXPECT_NEAR(row[0], triangles ? (3. / 8. + 1. / 2.) / 2. : 3. / 8., 1e-14) << k << " " << j;
        EXPECT_NEAR(row[j], triangles ? (3. / 8. + 1. / 4.) / 2. : 3. / 8., 1e-14) << k << " " << j;
      }
    }
  }
}

TEST(SurfaceMasks, AnglesOfConcaveCornersAreClamped)
{
  for (const bool triangles : { true, false })
  {
    for (const double angle : { 3.2, 3.4, 4., 5., 5.7, 6.1 })
    {
      const int k = 5;
      Model model = MakeSector(k, angle, triangles);
      model.Corners = { 0 };
      const Walk walk(model, triangles ? SurfaceSchemeKind::Loop : SurfaceSchemeKind::CatmullClark);
      const double clamped = std::max(9. * Pi / 8., std::min(angle, 15. * Pi / 8.));
      bool found = false;
      for (const Sector<int>& sector : walk.Level.Tags.Sectors)
      {
        if (sector.Vertex == 0)
        {
          found = true;
          EXPECT_NEAR(sector.Angle, clamped, 1e-13) << angle;
          const double c = std::cos(Pi / k);
          const double gamma = 3. / 8. - std::cos(clamped / k) / 4.;
          const double half = gamma + c / 8. - 0.25;
          const double third = triangles
            ? 0.5 + (c - std::cos(clamped / k)) / 4.
            : (gamma + c / 8. + 0.25 + std::sqrt(half * half + (1. + c) / 8.)) / 2.;
          EXPECT_NEAR(sector.Flatness, std::max(0., 1. - 0.25 / third), 1e-13) << angle;
        }
      }
      EXPECT_TRUE(found);
      // The points of the sector move towards x1_j = cos(j t), x2_j = sin(j t) in the plane of the
      // corner's two curves.
      std::map<int, double> row = FindEdgeRow(walk, 2);
      double sum = 0.;
      for (const auto& entry : row)
      {
        sum += entry.second;
      }
      EXPECT_NEAR(sum, 1., 1e-14);
      EXPECT_GT(std::abs(row[k + 1]), 1e-6) << "the end of the other curve counts too";
    }
  }
}

// The octahedron's neighbours cancel out, so that its points show their own weight: 5/8 of Warren,
// 33/64 of Loop's thesis, and of his limits 3/(11 - 8 * 33/64).
TEST(SurfaceMasks, LoopWeightsReachPointsLimitsAndWhatIsKept)
{
  Model octahedron;
  octahedron.Points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  octahedron.Faces = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(MakeInput(octahedron));
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  const auto getFirst = [&filter]
  {
    filter->Update();
    return filter->GetOutput()->GetPoint(0)[0];
  };
  EXPECT_NEAR(getFirst(), 5. / 8., 1e-15);
  filter->SetLoopWeightsToLoop();
  EXPECT_NEAR(getFirst(), 33. / 64., 1e-15);
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 2);
  filter->ProjectToLimitOn();
  EXPECT_NEAR(getFirst(), 24. / 55., 1e-15);
  filter->SetNumberOfLevels(2);
  EXPECT_NEAR(getFirst(), 24. / 55., 1e-15);
  filter->SetNumberOfLevels(0);
  EXPECT_NEAR(getFirst(), 24. / 55., 1e-15);
  filter->InterpolatePointsOn();
  EXPECT_NEAR(getFirst(), 1., 1e-9);
  filter->InterpolatePointsOff();
  filter->SetLoopWeightsToWarren();
  EXPECT_NEAR(getFirst(), 1. / 2., 1e-15);
}
