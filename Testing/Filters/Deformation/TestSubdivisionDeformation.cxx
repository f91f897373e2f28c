// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionDeformation.cxx
 * What the deformation is: affine maps, identity, smoothness, and what is kept.
 */
#include "SubdivisionDeformationTools.h"

#include "vtkStructuredGrid.h"

using namespace deformation_tools;

namespace
{

Point Same(const Point& x)
{
  return x;
}

/// Cages of all kinds: noisy, with features, of other cells, with surfaces and curves.
std::vector<Grid> MakeCages()
{
  return { MakeKuhnBox(2, 0.2, 3), MakeMixedBox(2),
    MakeFlaggedOctahedron({ { VTK_LINE, { 0, 2 } } }) };
}

/// Points that are inside every subdivided mesh of a cage: near those of its cells' middles.
Grid MakeInside(vtkUnstructuredGrid* cage, int levels, int perCell = 1, int scheme = 0)
{
  const Grid fine = Execute(cage, levels, [=](Filter* f) { f->SetVolumeScheme(scheme); });
  std::vector<Point> points;
  std::vector<Cell> cells;
  std::mt19937 random(4);
  for (vtkIdType i = 0; i < fine->GetNumberOfCells(); ++i)
  {
    const Ids ids = GetCell(fine, i);
    for (int k = 0; ids.size() == 4 && k < perCell; ++k)
    {
      double sum = 0.;
      Point x = { 0., 0., 0. };
      for (vtkIdType id : ids)
      {
        const double weight = 0.01 + random() / 4294967296.;
        const Point corner = GetPoint(fine, id);
        sum += weight;
        for (int c = 0; c < 3; ++c)
        {
          x[c] += weight * corner[c];
        }
      }
      cells.push_back({ VTK_VERTEX, { static_cast<vtkIdType>(points.size()) } });
      points.push_back({ x[0] / sum, x[1] / sum, x[2] / sum });
    }
  }
  return MakeGrid(points, cells);
}

/// Second differences of x along a line that is parallel to the x axis, where a mesh moves it.
std::vector<double> GetSecondDifferences(
  const Grid& cage, const Grid& bent, int scheme, int levels, double step)
{
  constexpr int size = 41;
  std::vector<Point> line;
  for (int i = 0; i < size; ++i)
  {
    line.push_back({ 0.8 + step * i, 1.93, 2.21 });
  }
  Deformer filter;
  filter->SetNumberOfLevels(levels);
  filter->SetVolumeScheme(scheme);
  const auto result = filter.Run(MakeGrid(line, {}), cage, bent);
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
  std::vector<double> seconds;
  for (int i = 1; i + 1 < size; ++i)
  {
    seconds.push_back(
      (GetPoint(result, i - 1)[0] - 2. * GetPoint(result, i)[0] + GetPoint(result, i + 1)[0]) /
      (step * step));
  }
  return seconds;
}

/// Runs `work` with a back end and a number of threads.
template <typename Work>
void WithThreads(const char* backend, int threads, const Work& work)
{
  const std::string before = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend(backend));
  vtkSMPTools::Initialize(threads);
  work();
  vtkSMPTools::SetBackend(before.c_str());
  vtkSMPTools::Initialize(0);
}

}

TEST(SubdivisionDeformation, AffineMapsAreReproduced)
{
  for (const Grid& cage : MakeCages())
  {
    for (int variant = 0; variant < 6; ++variant)
    {
      const int levels = std::array<int, 3>{ 0, 1, 3 }[variant / 2];
      const Grid inside = MakeInside(cage, levels, 1, variant % 2);
      Deformer filter;
      filter->SetNumberOfLevels(levels);
      filter->SetVolumeScheme(variant % 2);
      const auto same = filter.Run(inside, cage, cage);
      EXPECT_LT(GetLargestError(same, inside, Same), 1e-12) << levels;
      const auto moved = filter.Run(inside, cage, Moved(cage, Affine));
      EXPECT_LT(GetLargestError(moved, inside, Affine), 1e-12) << levels;
      EXPECT_TRUE(filter.GetErrors().empty());
      EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
      EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
      EXPECT_EQ(filter->GetNumberOfLocationBuilds(), 1);
    }
  }
}

TEST(SubdivisionDeformation, ManyPointsTakeTheOtherWayToTheSamePlace)
{
  // Few points have composed rows, many do not. The second cage has a semi-sharp crease.
  const Grid smooth = MakeKuhnBox(2, 0.2, 3);
  const Grid creased = DeepCopy(smooth);
  const vtkIdType crease[3][2] = { { 0, 1 }, { 1, 4 }, { 4, 13 } };
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("sharpness");
  for (vtkIdType i = 0; i < smooth->GetNumberOfCells(); ++i)
  {
    sharpness->InsertNextValue(0.);
  }
  for (const auto& line : crease)
  {
    creased->InsertNextCell(VTK_LINE, 2, line);
    sharpness->InsertNextValue(1.5);
  }
  creased->GetCellData()->AddArray(sharpness);
  for (int variant = 0; variant < 4; ++variant)
  {
    const Grid cage = variant % 2 == 0 ? smooth : creased;
    const Grid bent = Moved(cage, Bend);
    const Grid many = MakeInside(smooth, 3, 30);
    Deformer filter;
    filter->SetNumberOfLevels(3);
    filter->SetVolumeScheme(variant / 2);
    if (cage == creased)
    {
      filter->SetInputArrayToProcess(4, 1, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "sharpness");
    }
    const auto all = filter.Run(many, cage, bent);
    std::vector<Point> some;
    for (vtkIdType i = 0; i < many->GetNumberOfPoints(); i += 3001)
    {
      some.push_back(GetPoint(many, i));
    }
    const auto few = filter.Run(MakeGrid(some, {}), cage, bent);
    for (std::size_t k = 0; k < some.size(); ++k)
    {
      const Point a = GetPoint(all, static_cast<vtkIdType>(3001 * k));
      const Point b = GetPoint(few, static_cast<vtkIdType>(k));
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(a[c], b[c], 1e-13);
      }
    }
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
    EXPECT_EQ(filter->GetNumberOfLocationBuilds(), 2);
    EXPECT_TRUE(filter.GetErrors().empty());
  }
}

TEST(SubdivisionDeformation, FollowsTheSubdividedMesh)
{
  // The points of the subdivided rest mesh become those of the same subdivision of the other shape:
  // by the filter itself, with the deformed coordinates as an array.
  for (int variant = 0; variant < 4; ++variant)
  {
    const bool sharp = variant % 2 == 1;
    const Grid cage = MakeKuhnBox(2, 0.2, 5);
    const Grid bent = Moved(cage, Bend);
    const Grid carried = DeepCopy(cage);
    bent->GetPoints()->GetData()->SetName("bent");
    carried->GetPointData()->AddArray(bent->GetPoints()->GetData());
    const Grid fine = Execute(carried, 2,
      [&](Filter* f)
      {
        f->SetDetectFeatures(sharp);
        f->SetFeatureAngle(40.);
        f->SetVolumeScheme(variant / 2);
      });
    Deformer filter;
    filter->SetVolumeScheme(variant / 2);
    filter->SetDetectFeatures(sharp);
    filter->SetFeatureAngle(40.);
    const auto result = filter.Run(fine, cage, bent);
    vtkDataArray* wanted = fine->GetPointData()->GetArray("bent");
    double largest = 0.;
    for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
    {
      const Point x = GetPoint(result, i);
      for (int c = 0; c < 3; ++c)
      {
        largest = std::max(largest, std::abs(x[c] - wanted->GetComponent(i, c)));
      }
    }
    EXPECT_LT(largest, 1e-12);
    EXPECT_TRUE(filter.WasSilent());
  }
}

TEST(SubdivisionDeformation, SharpCagesKeepMorePointsInside)
{
  // The corners of a box are inside of it only if they are kept.
  const Grid cage = MakeKuhnBox(2);
  const Grid cloud = MakeGrid({ { 0.001, 0.001, 0.001 }, { 1., 1., 1. } }, {});
  Deformer filter;
  filter.Run(cloud, cage, cage);
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 1);
  filter->DetectFeaturesOn();
  filter.Run(cloud, cage, cage);
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 2);
}

TEST(SubdivisionDeformation, IsSmoothAcrossInputFaces)
{
  // Second differences of a bent map along a line through the faces of the control mesh: those of
  // level 0 jump there, and grow as 1/h; the smooth map's stay, and converge.
  const Grid cage = MakeKuhnBox(4);
  const Grid bent = Moved(cage,
    [](const Point& x) { return Point{ x[0] + 0.3 * std::sin(2. * x[0]) * x[1], x[1], x[2] }; });
  constexpr double step = 0.0625;
  for (int scheme : { 0, 1 })
  {
    std::vector<std::vector<double>> seconds;
    for (int levels = 0; levels <= 4; ++levels)
    {
      seconds.push_back(GetSecondDifferences(cage, bent, scheme, levels, step));
    }
    auto difference = [&](int a, int b)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < seconds[a].size(); ++i)
      {
        largest = std::max(largest, std::abs(seconds[a][i] - seconds[b][i]));
      }
      return largest;
    };
    EXPECT_LT(difference(3, 4), 0.7 * difference(2, 3)) << scheme;
    EXPECT_LT(difference(2, 3), difference(1, 2)) << scheme;
    double largest = 0.;
    double roughest = 0.;
    for (std::size_t i = 0; i < seconds[4].size(); ++i)
    {
      largest = std::max(largest, std::abs(seconds[4][i]));
      roughest = std::max(roughest, std::abs(seconds[0][i]));
    }
    EXPECT_LT(largest, 4.);   // the map's own is 2.4 y
    EXPECT_GT(roughest, 12.); // kinks
  }
}

// ---------------------------------------------------------------- what is kept

TEST(SubdivisionDeformation, OnlyMovedControlPointsBuildNothing)
{
  const Grid cage = MakeKuhnBox(2, 0.1, 2);
  for (int size : { 50, 60000 }) // composed rows, and level operators
  {
    const Grid cloud = MakeCloud(size, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);
    Deformer filter;
    for (int time = 0; time < 4; ++time)
    {
      // Other objects of equal content: neither pointers nor times are alike.
      const Grid bent =
        Moved(cage, [=](const Point& x) { return Point{ x[0], x[1] + time * x[0] * x[2], x[2] }; });
      const auto kept = filter.Run(DeepCopy(cloud), DeepCopy(cage), bent);
      Deformer fresh;
      EXPECT_EQ(ComparePoints(kept, fresh.Run(cloud, cage, bent)), "") << time;
    }
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
    EXPECT_EQ(filter->GetNumberOfLocationBuilds(), 1);
  }
}

TEST(SubdivisionDeformation, ChangesAreNoticedByContent)
{
  const Grid cage = MakeKuhnBox(2, 0.1, 2);
  const Grid bent = Moved(cage, Bend);
  const Grid cloud = MakeCloud(50, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);
  Deformer filter;
  filter.Run(cloud, cage, bent);
  auto expectFresh = [&](vtkIdType topologies, vtkIdType locations, const char* what)
  {
    const auto kept = filter.Run(cloud, cage, bent);
    Deformer fresh;
    fresh->SetNumberOfLevels(filter->GetNumberOfLevels());
    fresh->SetVolumeScheme(filter->GetVolumeScheme());
    fresh->SetCreaseEnd(filter->GetCreaseEnd());
    fresh->SetLoopWeights(filter->GetLoopWeights());
    EXPECT_EQ(ComparePoints(kept, fresh.Run(cloud, cage, bent)), "") << what;
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), topologies) << what;
    EXPECT_EQ(filter->GetNumberOfLocationBuilds(), locations) << what;
  };
  expectFresh(1, 1, "nothing");
  // Behind the back of every modified time.
  static_cast<double*>(cloud->GetPoints()->GetVoidPointer(0))[5] += 0.01;
  expectFresh(1, 2, "a point");
  static_cast<double*>(cage->GetPoints()->GetVoidPointer(0))[13 * 3] += 0.01;
  expectFresh(2, 3, "a control point at rest");
  filter->SetNumberOfLevels(1);
  expectFresh(3, 4, "levels");
  filter->SetCreaseEndToDart();
  expectFresh(4, 5, "an option of the rules");
  cage->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("MaterialId", 1, cage->GetNumberOfCells(), 0, 3, 1));
  expectFresh(5, 6, "an array that may choose rules");
  cage->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("else", 1, cage->GetNumberOfCells(), 0, 3, 1));
  expectFresh(5, 6, "an array that may not");
  cage->GetCellData()->GetArray("MaterialId")->SetTuple1(7, 5);
  expectFresh(6, 7, "a value that may choose rules");
  filter->SetVolumeSchemeToTetOct();
  expectFresh(7, 8, "the scheme");
  filter->SetLoopWeightsToLoop();
  expectFresh(8, 9, "weights");
}

TEST(SubdivisionDeformation, SameBitsForAnyThreads)
{
  const Grid cage = MakeMixedBox(2);
  const Grid bent = Moved(cage, Bend);
  for (int size : { 100, 40000 })
  {
    const Grid cloud = MakeCloud(size, { -0.2, -0.2, -0.2 }, { 2.2, 2.2, 2.2 }, 8);
    vtkSmartPointer<vtkPointSet> results[3];
    auto run = [&](int i)
    {
      Deformer filter;
      filter->SetOutsidePointsToNearest();
      results[i] = filter.Run(cloud, cage, bent);
      EXPECT_GT(filter->GetNumberOfOutsidePoints(), 0);
    };
    WithThreads("Sequential", 1, [&] { run(0); });
    WithThreads("STDThread", 2, [&] { run(1); });
    WithThreads("STDThread", 4, [&] { run(2); });
    EXPECT_EQ(ComparePoints(results[0], results[1]), "");
    EXPECT_EQ(ComparePoints(results[0], results[2]), "");
  }
}

// ---------------------------------------------------------------- types of data

TEST(SubdivisionDeformation, TheOutputHasTheTypeOfTheInput)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid moved = Moved(cage, Affine);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->GetData()->SetName("places");
  points->GetData()->SetComponentName(1, "north");
  for (int i = 0; i < 27; ++i)
  {
    points->InsertNextPoint(0.8 + 0.2 * (i % 3), 0.8 + 0.2 * (i / 3 % 3), 0.8 + 0.2 * (i / 9));
  }
  vtkNew<vtkStructuredGrid> block;
  block->SetDimensions(3, 3, 3);
  block->SetPoints(points);
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkCellArray> polys;
  const vtkIdType quad[4] = { 0, 1, 4, 3 };
  polys->InsertNextCell(4, quad);
  surface->SetPoints(points);
  surface->SetPolys(polys);
  surface->GetCellData()->AddArray(MakeNames("names", 1));
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_QUAD, 4, quad);
  Deformer filter;
  for (vtkPointSet* input : { static_cast<vtkPointSet*>(block), static_cast<vtkPointSet*>(surface),
         static_cast<vtkPointSet*>(grid) })
  {
    const auto output = filter.Run(input, cage, moved);
    ASSERT_TRUE(output->IsA(input->GetClassName()));
    EXPECT_LT(GetLargestError(output, input, Affine), 1e-6);
    EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_FLOAT);
    EXPECT_EQ(output->GetNumberOfCells(), input->GetNumberOfCells());
    EXPECT_EQ(output->GetPoints()->GetData()->GetName(), std::string("places"));
    EXPECT_EQ(output->GetPoints()->GetData()->GetComponentName(1), std::string("north"));
    EXPECT_EQ(CompareArrays(input->GetCellData(), output->GetCellData(), "cells"), "");
  }
  EXPECT_EQ(filter->GetNumberOfLocationBuilds(), 1); // their points are equal
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  const auto exact = filter.Run(grid, cage, moved);
  EXPECT_EQ(exact->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_LT(GetLargestError(exact, grid, Affine), 1e-12);
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformation, SinglePrecisionAtRestStaysBitForBit)
{
  const Grid cage = MakeKuhnBox(2, 0.1, 6);
  const Grid cloud = MakeCloud(20000, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1, VTK_FLOAT);
  Deformer filter;
  EXPECT_EQ(ComparePoints(filter.Run(cloud, cage, cage), cloud), "");
}

TEST(SubdivisionDeformation, BlocksAreDeformedEachByItself)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid bent = Moved(cage, Bend);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(MakeCloud(30, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1)->GetPoints());
  const Grid cloud = MakeCloud(40, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 2);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, surface);
  blocks->SetBlock(1, cloud);
  Deformer filter;
  for (int time = 0; time < 3; ++time)
  {
    filter->SetInputData(blocks.Get());
    filter->SetRestMeshData(cage);
    filter->SetDeformedMeshData(bent);
    filter->Modified();
    filter->Update();
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_TRUE(output);
    ASSERT_EQ(output->GetNumberOfBlocks(), 2U);
    auto* first = vtkPolyData::SafeDownCast(output->GetBlock(0));
    auto* second = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(1));
    ASSERT_TRUE(first && second);
    Deformer alone;
    EXPECT_EQ(ComparePoints(first, alone.Run(surface, cage, bent)), "");
    EXPECT_EQ(ComparePoints(second, alone.Run(cloud, cage, bent)), "");
  }
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
  EXPECT_EQ(filter->GetNumberOfLocationBuilds(), 2);
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformation, ControlMeshesMayBePolyDataOrWithoutSolids)
{
  // A square of two triangles: nothing can be inside, but Nearest binds to it.
  vtkNew<vtkPolyData> sheet;
  vtkNew<vtkCellArray> polys;
  const vtkIdType triangles[2][3] = { { 0, 1, 2 }, { 0, 2, 3 } };
  polys->InsertNextCell(3, triangles[0]);
  polys->InsertNextCell(3, triangles[1]);
  sheet->SetPoints(
    MakeGrid({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } }, {})->GetPoints());
  sheet->SetPolys(polys);
  vtkNew<vtkPolyData> lifted;
  lifted->DeepCopy(sheet);
  for (int i = 0; i < 4; ++i)
  {
    lifted->GetPoints()->SetPoint(i, i % 3 == 0 ? 1. : 5., i < 2 ? 0. : 4., 2.);
  }
  const Grid cloud = MakeCloud(200, { 1, 1, -1 }, { 3, 3, 1 }, 1);
  Deformer filter;
  EXPECT_EQ(ComparePoints(filter.Run(cloud, sheet, lifted), cloud), "");
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 200);
  ASSERT_EQ(filter.GetWarnings().size(), 1U);
  EXPECT_NE(filter.GetWarnings()[0].find("200 of 200 points"), std::string::npos);
  filter.Forget();
  filter->SetOutsidePointsToNearest();
  const auto moved = filter.Run(cloud, sheet, lifted);
  EXPECT_LT(GetLargestError(
              moved, cloud, [](const Point& x) { return Point{ x[0] + 1., x[1], x[2] + 2. }; }),
    1e-12);
  EXPECT_EQ(filter.GetWarnings().size(), 1U);
}
