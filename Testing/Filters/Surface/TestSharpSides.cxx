// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSharpSides.cxx
 * SplitSharpEdges gives each side of what is sharp a point, with the normal there.
 */
#include "SurfaceTools.h"

#include "vtkFieldData.h"

using namespace surfacetools;

namespace
{

const std::vector<int> Known = { vtkSurfaceSubdivision::LOOP,
  vtkSurfaceSubdivision::CATMULL_CLARK };

vtkSmartPointer<vtkPolyData> RunSplit(vtkPolyData* input, int scheme, int levels, bool splits,
  bool projects = false, double angle = 30.)
{
  return RunFilter(input, scheme, levels, projects,
    [=](vtkSurfaceSubdivision* filter)
    {
      filter->SetSplitSharpEdges(splits);
      filter->SetDetectFeatures(angle > 0.);
      filter->SetFeatureAngle(angle);
      filter->GenerateLimitNormalsOn();
    });
}

Point GetPoint(vtkPolyData* mesh, vtkIdType i)
{
  Point x;
  mesh->GetPoint(i, x.data());
  return x;
}

/// A curved sheet of two halves that meet in an edge.
Model MakeRoof(bool triangles)
{
  Model model = MakeSheet(6, 4, triangles, { 1., 0., 0. }, { 0., 1., 0. });
  for (Point& p : model.Points)
  {
    const double x = p[0] - 3.;
    p[2] = 0.1 * x * x - 2. * std::abs(x) + 0.2 * p[1] * p[1];
  }
  return model;
}

/// The faces of a model whose middle is on one side of x = 3.
Model TakeHalf(const Model& model, bool isFirst)
{
  Model half = model;
  half.Faces.clear();
  for (const auto& face : model.Faces)
  {
    double sum = 0.;
    for (const vtkIdType point : face)
    {
      sum += model.Points[static_cast<std::size_t>(point)][0] - 3.;
    }
    if ((sum < 0.) == isFirst)
    {
      half.Faces.push_back(face);
    }
  }
  return half;
}

}

TEST(SharpSides, OfACubeAreFlat)
{
  const auto cube = MakeInput(MakeZoo(false).at("cube"));
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const bool isLeft = i == 0 || i == 3 || i == 4 || i == 7;
    cube->GetPoints()->SetPoint(i, isLeft ? 0. : 1., i % 4 < 2 ? 0. : 1., i < 4 ? 0. : 1.);
  }
  for (const bool projects : { false, true })
  {
    const auto output = RunSplit(cube, vtkSurfaceSubdivision::CATMULL_CLARK, 2, true, projects);
    EXPECT_EQ(output->GetNumberOfCells(), 96);
    ASSERT_EQ(output->GetNumberOfPoints(), 6 * 25 + 1) << "and one that is not used";
    EXPECT_EQ(
      RunSplit(cube, vtkSurfaceSubdivision::CATMULL_CLARK, 2, false)->GetNumberOfPoints(), 99);
    const auto normals = GetNormals(output, 151);
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      output->GetCellPoints(cell, ids);
      const Point n = normals[static_cast<std::size_t>(ids->GetId(0))];
      EXPECT_NEAR(std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]), 1., 1e-12);
      for (vtkIdType k = 0; k < 4; ++k)
      {
        EXPECT_LT(GetDistance(normals[static_cast<std::size_t>(ids->GetId(k))], n), 1e-12);
        const Point a = GetPoint(output, ids->GetId(k));
        const Point b = GetPoint(output, ids->GetId((k + 1) % 4));
        EXPECT_NEAR(n[0] * (b[0] - a[0]) + n[1] * (b[1] - a[1]) + n[2] * (b[2] - a[2]), 0., 1e-12);
      }
    }
  }
}

/// On each side of a crease as where the surface ends there.
TEST(SharpSides, HaveTheNormalsOfTheLimit)
{
  for (const int scheme : Known)
  {
    const Model roof = MakeRoof(scheme == vtkSurfaceSubdivision::LOOP);
    const auto output = RunSplit(MakeInput(roof), scheme, 2, true);
    const auto plain = RunSplit(MakeInput(roof), scheme, 2, false);
    EXPECT_EQ(output->GetNumberOfPoints(), plain->GetNumberOfPoints() + 17) << "4 x 4 + 1 copies";
    const auto normals = GetNormals(output, static_cast<std::size_t>(output->GetNumberOfPoints()));
    int compared = 0;
    for (const bool isFirst : { true, false })
    {
      const auto half = RunSplit(MakeInput(TakeHalf(roof, isFirst)), scheme, 2, false, false, 0.);
      const auto expected = GetNormals(half, static_cast<std::size_t>(half->GetNumberOfPoints()));
      for (vtkIdType i = 0; i < half->GetNumberOfPoints(); ++i)
      {
        const Point x = GetPoint(half, i);
        for (vtkIdType k = 0; k < output->GetNumberOfPoints(); ++k)
        {
          // The halves have other corners, at the ends of the crease, and other rules beside them.
          if (std::abs(x[0] - 3.) < 1e-9 && x[1] > 1. - 1e-9 && x[1] < 3. + 1e-9 &&
            GetDistance(GetPoint(output, k), x) < 1e-9)
          {
            const Point& n = normals[static_cast<std::size_t>(k)];
            const bool isThisSide = (n[0] < 0.) == isFirst;
            EXPECT_TRUE(!isThisSide || GetDistance(n, expected[static_cast<std::size_t>(i)]) < 1e-9)
              << scheme << " " << x[1];
            compared += isThisSide ? 1 : 0;
          }
        }
      }
    }
    EXPECT_EQ(compared, 2 * 9);
  }
}

TEST(SharpSides, OfJointsAndOfWhatIsNotSharp)
{
  for (const bool triangles : { false, true })
  {
    for (const auto& [name, model] : MakeZoo(triangles))
    {
      SCOPED_TRACE(name);
      const auto input = MakeInput(model);
      for (const int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
             vtkSurfaceSubdivision::SQRT_THREE, vtkSurfaceSubdivision::DOO_SABIN })
      {
        const auto plain = RunSplit(input, scheme, 2, false, false, 0.);
        const auto split = RunSplit(input, scheme, 2, true, false, 0.);
        // Loop blends joints, and where closed sheets touch there are no sides in the limit.
        const bool isSplit =
          scheme == vtkSurfaceSubdivision::CATMULL_CLARK && (name == "book" || name == "bow tie");
        EXPECT_EQ(split->GetNumberOfPoints() > plain->GetNumberOfPoints(), isSplit) << scheme;
        if (split->GetNumberOfPoints() == plain->GetNumberOfPoints())
        {
          ExpectSameBits(split, plain);
          continue;
        }
        EXPECT_EQ(split->GetNumberOfCells(), plain->GetNumberOfCells());
        EXPECT_LT(
          split->GetFieldData()->GetNumberOfArrays(), plain->GetFieldData()->GetNumberOfArrays())
          << "no stamp: cells came apart";
        vtkNew<vtkIdList> ids;
        vtkNew<vtkIdList> before;
        for (vtkIdType cell = 0; cell < split->GetNumberOfCells(); ++cell)
        {
          split->GetCellPoints(cell, ids);
          plain->GetCellPoints(cell, before);
          for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
          {
            EXPECT_EQ(GetPoint(split, ids->GetId(k)), GetPoint(plain, before->GetId(k)));
          }
        }
        const auto all = static_cast<std::size_t>(split->GetNumberOfPoints());
        for (const Point& n : GetNormals(split, all))
        {
          EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1., 1e-9);
        }
      }
    }
  }
}

/// With it surfaces are shaded where something is sharp, too, and kept levels stay as they are.
TEST(SharpSides, LetSmoothShadingMakeNormals)
{
  const auto input = MakeInput(MakeRoof(false));
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetNumberOfLevels(2);
  filter->DetectFeaturesOn();
  filter->CacheOperatorOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNormals(), nullptr);
  const vtkIdType points = filter->GetOutput()->GetNumberOfPoints();
  for (const bool splits : { true, false, true })
  {
    filter->SetSplitSharpEdges(splits);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNormals() != nullptr, splits);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), points + (splits ? 17 : 0));
  }
  filter->SmoothShadingOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), points);
}
