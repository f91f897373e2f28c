// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenNormals.cxx
 * vtkRedGreenRefinement: normals of points on the limit.
 */
#include "PointTools.h"
#include "RedGreenRefinementTools.h"

#include "vtkSphereSource.h"
#include "vtkSubdivisionModelSource.h"

using namespace red_green_refinement_tools;
using namespace point_tools;

namespace
{

Point GetNormal(vtkPointSet* mesh, vtkIdType point)
{
  Point normal;
  mesh->GetPointData()->GetNormals()->GetTuple(point, normal.data());
  return normal;
}

/// The normals of the main filter.
Grid MakeUniform(
  vtkDataObject* input, int levels, int scheme = vtkMultiDimensionalSubdivision::BOX_SPLINE)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeScheme(scheme);
  filter->SetInputDataObject(input);
  filter->SetNumberOfLevels(levels);
  filter->ProjectToLimitOn();
  filter->GenerateLimitNormalsOn();
  filter->GenerateClassificationOn();
  filter->Update();
  return filter->GetOutput();
}

/// Whether the normal of a point is one of tangents: it is the same on two levels. At corners and
/// on curves it may be so by chance.
bool IsExact(vtkUnstructuredGrid* uniform, vtkUnstructuredGrid* finer, vtkIdType point)
{
  return uniform->GetPointData()->GetArray("RuleDimension")->GetComponent(point, 0) == 2. &&
    Distance(GetNormal(uniform, point), GetNormal(finer, point)) < 1e-12;
}

void SetLimit(Filter* filter)
{
  filter->SetPlacementToLimit();
  filter->GenerateLimitNormalsOn();
}

Grid RefineHereAndThere(vtkDataObject* input, int scheme = Filter::BOX_SPLINE)
{
  return Refine(input,
    [scheme](Filter* filter)
    {
      SetLimit(filter);
      filter->SetVolumeScheme(scheme);
      filter->RefineByWantedLevelOn();
    });
}

class RedGreenNormalsZoo : public testing::TestWithParam<std::string>
{
};

/// Normals of tangents are those of the main filter; the main filter's own normals of two levels
/// tell which these are.
TEST_P(RedGreenNormalsZoo, AreThoseOfTheMainFilter)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  const Grid finer = MakeUniform(input, 3);
  for (int level = 0; level < 3; ++level)
  {
    const Grid output = HalveAll(input, level, SetLimit);
    const Grid uniform = MakeUniform(input, level);
    ASSERT_EQ(output->GetNumberOfCells(), uniform->GetNumberOfCells());
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      Ids own = GetCell(output, c);
      Ids others = GetCell(uniform, c);
      if (level == 0) // whose tetrahedra the main filter orders
      {
        std::sort(own.begin(), own.end());
        std::sort(others.begin(), others.end());
      }
      for (std::size_t i = 0; i < own.size(); ++i)
      {
        // Main levels number old points first.
        const Point expected = GetNormal(uniform, others[i]);
        if (IsExact(uniform, finer, others[i]))
        {
          ASSERT_LT(Distance(GetNormal(output, own[i]), expected), 1e-12)
            << "level " << level << ", point " << own[i];
        }
        else
        {
          const Point normal = GetNormal(output, own[i]);
          EXPECT_NEAR(Dot(normal, normal), Dot(expected, expected), 1e-12);
        }
      }
    }
  }
}

/// A point with tangents has the same normal whatever is refined around it.
void ExpectNormalsOfUniformMesh(vtkUnstructuredGrid* input, int scheme)
{
  const Grid uniform = MakeUniform(input, 3, scheme);
  const Grid before = MakeUniform(input, 2, scheme);
  std::map<Point, vtkIdType> exact;
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    if (IsExact(before, uniform, i))
    {
      Point key = GetPoint(uniform, i);
      std::transform(
        key.begin(), key.end(), key.begin(), [](double x) { return std::round(x * 1e9) * 1e-9; });
      exact[key] = i;
    }
  }
  const Grid output = RefineHereAndThere(input, scheme);
  vtkIdType found = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Point key = GetPoint(output, i);
    std::transform(
      key.begin(), key.end(), key.begin(), [](double x) { return std::round(x * 1e9) * 1e-9; });
    const auto same = exact.find(key);
    if (same != exact.end())
    {
      ++found;
      EXPECT_LT(Distance(GetNormal(output, i), GetNormal(uniform, same->second)), 1e-12) << i;
    }
  }
  EXPECT_GT(found, exact.empty() ? -1 : 0);
}

TEST_P(RedGreenNormalsZoo, DoNotDependOnTheirNeighbourhood)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  AddWantedLevels(input, 3, 5, 0.3);
  ExpectNormalsOfUniformMesh(input, Filter::BOX_SPLINE);
}

TEST_P(RedGreenNormalsZoo, DoNotDependOnTheirNeighbourhoodInTheTetOctScheme)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  AddWantedLevels(input, 3, 5, 0.3);
  ExpectNormalsOfUniformMesh(input, Filter::TET_OCT);
}

INSTANTIATE_TEST_SUITE_P(Zoo, RedGreenNormalsZoo, testing::ValuesIn(coretest::GetNamesOfZoo(0)),
  [](const auto& instance) { return instance.param; });

vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.);
  source->SetThetaResolution(12);
  source->SetPhiResolution(9);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

/// The largest angle between the normal of a triangle and those of its corners.
double GetLargestAngle(vtkPointSet* mesh)
{
  double angle = 0.;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCellPoints(c, ids);
    const Point a = GetPoint(mesh, ids->GetId(0));
    const Point b = GetPoint(mesh, ids->GetId(1));
    const Point d = GetPoint(mesh, ids->GetId(2));
    Point normal;
    for (int k = 0; k < 3; ++k)
    {
      const int i = (k + 1) % 3;
      const int j = (k + 2) % 3;
      normal[k] = (b[i] - a[i]) * (d[j] - a[j]) - (b[j] - a[j]) * (d[i] - a[i]);
    }
    const double length = std::sqrt(Dot(normal, normal));
    for (const vtkIdType id : *ids)
    {
      angle = std::max(angle, std::acos(std::min(1., Dot(normal, GetNormal(mesh, id)) / length)));
    }
  }
  return angle;
}

}

TEST(RedGreenNormals, OfASphereFitItsTriangles)
{
  double before = 1.;
  for (int level = 1; level < 4; ++level)
  {
    const Grid output = HalveAll(MakeSphere(), level, SetLimit);
    ASSERT_STREQ(output->GetPointData()->GetNormals()->GetName(), "LimitNormals");
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Point x = GetPoint(output, i);
      EXPECT_GT(Dot(GetNormal(output, i), x) / std::sqrt(Dot(x, x)), 0.99);
    }
    const double angle = GetLargestAngle(output);
    EXPECT_LT(angle, 0.6 * before) << level;
    before = angle;
  }
}

TEST(RedGreenNormals, HaveOneSideHoweverCellsAreOriented)
{
  const auto sphere = MakeSphere();
  const Grid expected = HalveAll(sphere, 1, SetLimit);
  for (vtkIdType c = 1; c < sphere->GetNumberOfCells(); c += 3)
  {
    sphere->ReverseCell(c);
  }
  const Grid output = HalveAll(sphere, 1, SetLimit);
  ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Point x = GetPoint(output, i);
    EXPECT_GT(Dot(GetNormal(output, i), x), 0.9);
  }
}

TEST(RedGreenNormals, HaveTheTypeOfPointsAndReplaceOlderOnes)
{
  const auto sphere = MakeSphere();
  const Grid first = HalveAll(sphere, 1, SetLimit);
  EXPECT_EQ(first->GetPointData()->GetNormals()->GetDataType(), VTK_DOUBLE);
  for (const char* name : { "RefinementLevel", "RefinementKind", "GreenParent" })
  {
    first->GetCellData()->RemoveArray(name); // of which the filter would warn
  }
  const Grid second = HalveAll(first, 1, SetLimit);
  EXPECT_EQ(second->GetPointData()->GetNormals()->GetNumberOfTuples(), second->GetNumberOfPoints());
  const Grid single = Refine(sphere,
    [](Filter* filter)
    {
      SetLimit(filter);
      filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    });
  EXPECT_EQ(single->GetPointData()->GetNormals()->GetDataType(), VTK_FLOAT);
}

TEST(RedGreenNormals, NeedTheLimit)
{
  vtkNew<Messages> messages;
  const Grid output =
    Refine(MakeSphere(), [](Filter* filter) { filter->GenerateLimitNormalsOn(); }, messages);
  EXPECT_FALSE(output->GetPointData()->HasArray("LimitNormals"));
  EXPECT_EQ(messages->CountWarnings("GenerateLimitNormals"), 1);
}

/// Normals at joints, corners and curves of the models: unit vectors at all that has a surface.
TEST(RedGreenNormals, OfModelsAreUnitVectors)
{
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    SCOPED_TRACE(model);
    vtkNew<vtkSubdivisionModelSource> source;
    source->SetModel(model);
    source->Update();
    const Grid input = source->GetOutput();
    AddWantedLevels(input, 2, 3);
    const Grid output = RefineHereAndThere(input);
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      output->GetCellPoints(c, ids);
      for (const vtkIdType id : *ids)
      {
        if (output->GetCellType(c) != VTK_TETRA)
        {
          ASSERT_NEAR(Dot(GetNormal(output, id), GetNormal(output, id)), 1., 1e-12);
        }
      }
    }
  }
}
