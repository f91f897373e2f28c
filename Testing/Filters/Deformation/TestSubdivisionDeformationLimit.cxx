// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionDeformationLimit.cxx
 * Points that are bound to places of the limit: identity, affine maps, and derivatives that do not
 * jump.
 */
#include "SubdivisionDeformationTools.h"

#include "vtkSubdivisionCageSource.h"

using namespace deformation_tools;

namespace
{

Point Same(const Point& x)
{
  return x;
}

/// A cage of 3 by 3 by 3 boxes in which the points of the cloud are.
Grid MakeCage()
{
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetNumberOfCells(3, 3, 3);
  source->SetBounds(-1., 1., -1., 1., -1., 1.);
  source->SetMargin(50.);
  source->Update();
  return source->GetOutput();
}

/// A sheet of quads in the plane z = 0, from -1 to 1.
vtkSmartPointer<vtkPolyData> MakeSheet()
{
  constexpr vtkIdType size = 4;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> quads;
  for (vtkIdType j = 0; j <= size; ++j)
  {
    for (vtkIdType i = 0; i <= size; ++i)
    {
      points->InsertNextPoint(i * 2. / size - 1., j * 2. / size - 1., 0.);
      const vtkIdType first = i + (size + 1) * j;
      i < size&& j < size
        ? void(quads->InsertNextCell({ first, first + 1, first + size + 2, first + size + 1 }))
        : void();
    }
  }
  auto sheet = vtkSmartPointer<vtkPolyData>::New();
  sheet->SetPoints(points);
  sheet->SetPolys(quads);
  return sheet;
}

/// What becomes of unit vectors along x at points of a line along x that are 1e-3 apart.
vtkSmartPointer<vtkDataArray> TurnVectors(
  vtkSubdivisionDeformation* filter, const Grid& cage, const Grid& bent)
{
  constexpr int size = 2001;
  constexpr double step = 1e-3;
  std::vector<Point> line;
  for (int i = 0; i < size; ++i)
  {
    line.push_back({ step * (i - size / 2), 0.137, -0.211 });
  }
  const Grid cloud = MakeGrid(line, {});
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("x");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < size; ++i)
  {
    vectors->InsertNextTuple3(1., 0., 0.);
  }
  cloud->GetPointData()->SetVectors(vectors);
  filter->SetInputDataObject(cloud);
  filter->SetRestMeshData(cage);
  filter->SetDeformedMeshData(bent);
  filter->Update();
  return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->GetArray("x");
}

/// The largest second difference of the derivative of the deformation: a smooth slope has h^2.
double FindLargestJump(vtkSubdivisionDeformation* filter, const Grid& cage, const Grid& bent)
{
  const auto turned = TurnVectors(filter, cage, bent);
  double most = 0.;
  for (vtkIdType i = 1; i + 1 < turned->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      most = std::max(most,
        std::abs(turned->GetComponent(i - 1, c) - 2. * turned->GetComponent(i, c) +
          turned->GetComponent(i + 1, c)));
    }
  }
  return most;
}

}

TEST(SubdivisionDeformationLimit, IdentityAndAffineMaps)
{
  using Filter = vtkSubdivisionDeformation;
  const Grid cage = MakeCage();
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT, Filter::LINEAR, Filter::HYBRID })
  {
    SCOPED_TRACE(scheme);
    const int size = scheme == Filter::HYBRID ? 3 : 200; // a place of it takes up to a second
    const Grid cloud = MakeCloud(size, { -0.9, -0.9, -0.9 }, { 0.9, 0.9, 0.9 }, 5);
    Deformer filter;
    filter->SetVolumeScheme(scheme);
    filter->SetEmbeddingToLimit();
    filter->SetOutsidePointsToError();
    EXPECT_LT(GetLargestError(filter.Run(cloud, cage, cage), cloud, Same), 1e-12);
    EXPECT_LT(GetLargestError(filter.Run(cloud, cage, Moved(cage, Affine)), cloud, Affine), 1e-12);
    EXPECT_TRUE(filter.WasSilent());
    EXPECT_EQ(filter->GetNumberOfLocationBuilds(), 1);
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
  }
}

TEST(SubdivisionDeformationLimit, IsTheLimitOfManyLevels)
{
  const Grid cage = MakeKuhnBox(2, 0.2, 3);
  const Grid bent = Moved(cage, Bend);
  const Grid cloud = MakeCloud(50, { 0.6, 0.6, 0.6 }, { 1.4, 1.4, 1.4 }, 5);
  Deformer exact;
  exact->SetEmbeddingToLimit();
  const auto made = exact.Run(cloud, cage, bent);
  double before = 1.;
  for (const int levels : { 1, 2, 3, 4 })
  {
    Deformer filter;
    filter->SetNumberOfLevels(levels);
    const auto other = filter.Run(cloud, cage, bent);
    const double error = GetLargestError(other, made, Same);
    EXPECT_LT(error, 0.45 * before);
    before = error;
  }
}

TEST(SubdivisionDeformationLimit, DerivativesDoNotJump)
{
  const Grid cage = MakeCage();
  const Grid bent = Moved(cage, [](const Point& x)
    { return Point{ x[0] + 0.3 * std::sin(3. * x[1] * x[0]), x[1] + 0.2 * x[0] * x[0], x[2] }; });
  vtkNew<vtkSubdivisionDeformation> cells;
  cells->SetNumberOfLevels(3);
  EXPECT_GT(FindLargestJump(cells, cage, bent), 1e-3);
  vtkNew<vtkSubdivisionDeformation> limit;
  limit->SetEmbeddingToLimit();
  EXPECT_LT(FindLargestJump(limit, cage, bent), 2e-6) << "second derivatives are continuous";
  const auto turned = TurnVectors(limit, cage, Moved(cage, Affine));
  for (vtkIdType i = 0; i < turned->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(turned->GetComponent(i, 0), 1.1, 1e-10);
    EXPECT_NEAR(turned->GetComponent(i, 1), -0.5, 1e-10);
    EXPECT_NEAR(turned->GetComponent(i, 2), 0.1, 1e-10);
  }
}

TEST(SubdivisionDeformationLimit, Planes)
{
  const auto sheet = MakeSheet();
  const Grid cloud = MakeCloud(100, { -0.7, -0.7, 0. }, { 0.7, 0.7, 0. }, 3);
  const auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(sheet);
  moved->SetPoints(MovePoints(sheet, Affine));
  for (const int scheme : { 0, 1 })
  {
    Deformer filter;
    filter->SetSurfaceScheme(scheme);
    filter->SetEmbeddingToLimit();
    filter->SetOutsidePointsToError();
    EXPECT_LT(GetLargestError(filter.Run(cloud, sheet, sheet), cloud, Same), 1e-12);
    EXPECT_LT(GetLargestError(filter.Run(cloud, sheet, moved), cloud, Affine), 1e-12);
    EXPECT_TRUE(filter.WasSilent());
  }
}

TEST(SubdivisionDeformationLimit, PointsOutside)
{
  const Grid cage = MakeCage();
  const Grid moved = Moved(cage, [](const Point& x) { return Point{ x[0] + 1., x[1], x[2] }; });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Grid points = MakeGrid({ { 0., 0., 0. }, { 9., 0., 0. }, { 0., nan, 0. } }, {});
  for (const int rule : { 0, 1 })
  {
    Deformer filter;
    filter->SetEmbeddingToLimit();
    filter->SetOutsidePoints(rule);
    const auto made = filter.Run(points, cage, moved);
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 2);
    EXPECT_NEAR(GetPoint(made, 0)[0], 1., 1e-12);
    EXPECT_NEAR(GetPoint(made, 1)[0], rule == 0 ? 9. : 10., 1e-9);
    EXPECT_TRUE(std::isnan(GetPoint(made, 2)[1]));
    EXPECT_EQ(filter.GetWarnings().size(), 1u);
  }
}
