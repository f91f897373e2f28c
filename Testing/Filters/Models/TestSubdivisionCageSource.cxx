// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionCageSource.cxx
 * Cages fill their box with positive tetrahedra that fit together, and are a rest mesh for
 * deformation.
 */
#include "SubdivisionDeformationTools.h"

#include "vtkConnectivityFilter.h"
#include "vtkGeometryFilter.h"
#include "vtkSubdivisionCageSource.h"

using namespace deformation_tools;

namespace
{

struct Made
{
  Grid Cage;
  std::vector<std::string> Errors;
};

Made MakeCage(vtkSubdivisionCageSource* source)
{
  vtkNew<Messages> heard;
  heard->Watch(source);
  source->Update();
  return { source->GetOutput(), heard->Errors };
}

void ExpectBounds(vtkDataSet* cage, const std::array<double, 6>& expected)
{
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(cage->GetBounds()[i], expected[i], 1e-12) << i;
  }
}

}

TEST(SubdivisionCageSource, FillsItsBox)
{
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetNumberOfCells(3, 1, 4);
  source->SetBounds(-1, 2, 0, 4, 5, 6);
  source->SetMargin(0);
  const Made made = MakeCage(source);
  EXPECT_TRUE(made.Errors.empty());
  ASSERT_EQ(made.Cage->GetNumberOfCells(), 6 * 12);
  EXPECT_EQ(made.Cage->GetNumberOfPoints(), 4 * 2 * 5);
  ExpectBounds(made.Cage, { -1, 2, 0, 4, 5, 6 });
  double volume = 0;
  std::map<std::set<vtkIdType>, int> count;
  for (const Ids& tet : GetCells(made.Cage))
  {
    ASSERT_EQ(tet.size(), 4u);
    EXPECT_GT(GetSignedVolume(made.Cage, tet), 0);
    volume += GetSignedVolume(made.Cage, tet);
    for (const vtkIdType left : tet)
    {
      std::set<vtkIdType> face(tet.begin(), tet.end());
      face.erase(left);
      ++count[face];
    }
  }
  EXPECT_NEAR(volume, 12, 1e-12);
  vtkIdType outside = 0;
  for (const auto& [face, n] : count)
  {
    EXPECT_LE(n, 2);
    outside += n == 1 ? 1 : 0;
  }
  EXPECT_EQ(outside, 2 * 2 * (3 * 1 + 3 * 4 + 1 * 4));
}

/// The box of a cage whose limit has these bounds inside: it has two cells along each axis, of
/// which a quarter is beyond them on each side.
std::array<double, 6> Enlarge(std::array<double, 6> bounds)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    bounds[2 * axis] -= length / 6.;
    bounds[2 * axis + 1] += length / 6.;
  }
  return bounds;
}

TEST(SubdivisionCageSource, IsAroundItsInput)
{
  const Grid first = MakeCloud(20, { 0, 0, 0 }, { 1, 1, 1 }, 1);
  const Grid second = MakeCloud(20, { 3, 0, 0 }, { 4, 1, 1 }, 2);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(2, second);
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetMargin(0);
  source->SetInputDataObject(0, blocks);
  const double* a = first->GetBounds();
  const double* b = second->GetBounds();
  std::array<double, 6> all{};
  for (int axis = 0; axis < 3; ++axis)
  {
    all[2 * axis] = std::min(a[2 * axis], b[2 * axis]);
    all[2 * axis + 1] = std::max(a[2 * axis + 1], b[2 * axis + 1]);
  }
  ExpectBounds(MakeCage(source).Cage, Enlarge(all));
  source->SetMargin(10);
  const double margin = (all[1] - all[0]) / 10;
  for (int axis = 0; axis < 3; ++axis)
  {
    all[2 * axis] -= margin;
    all[2 * axis + 1] += margin;
  }
  ExpectBounds(MakeCage(source).Cage, Enlarge(all));
  // Without input, Bounds count.
  source->SetInputDataObject(0, nullptr);
  source->RemoveAllInputConnections(0);
  ExpectBounds(MakeCage(source).Cage, { -.1, 1.1, -.1, 1.1, -.1, 1.1 });
}

TEST(SubdivisionCageSource, BadBoxesAreErrors)
{
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetBounds(0, 1, 2, 1, 0, 1);
  Made made = MakeCage(source);
  ASSERT_EQ(made.Errors.size(), 1u);
  EXPECT_NE(made.Errors[0].find("along y"), std::string::npos);
  EXPECT_EQ(made.Cage->GetNumberOfCells(), 0);
  source->SetBounds(0, 1, 0, 1, 3, 3);
  EXPECT_TRUE(MakeCage(source).Errors.empty()) << "the margin gives it a volume";
  ExpectBounds(source->GetOutput(), { -.05, 1.05, -.05, 1.05, 2.95, 3.05 });
  source->SetMargin(0);
  made = MakeCage(source);
  ASSERT_EQ(made.Errors.size(), 1u);
  EXPECT_NE(made.Errors[0].find("flat along z"), std::string::npos);
  source->SetInputDataObject(0, Grid::New());
  made = MakeCage(source);
  ASSERT_EQ(made.Errors.size(), 1u);
  EXPECT_NE(made.Errors[0].find("no points"), std::string::npos);
  source->SetNumberOfCells(0, 7, 1000);
  EXPECT_EQ(source->GetNumberOfCells()[0], 1);
  EXPECT_EQ(source->GetNumberOfCells()[1], 7);
  EXPECT_EQ(source->GetNumberOfCells()[2], 100);
}

TEST(SubdivisionCageSource, BoxesFitTheTypeOfPoints)
{
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetBounds(0, 1e39, 0, 1, 0, 1);
  EXPECT_TRUE(MakeCage(source).Errors.empty());
  source->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  const Made made = MakeCage(source);
  ASSERT_EQ(made.Errors.size(), 1u);
  EXPECT_NE(made.Errors[0].find("too large for OutputPointsPrecision"), std::string::npos);
  EXPECT_EQ(made.Cage->GetNumberOfPoints(), 0);
}

TEST(SubdivisionCageSource, StartsADeformation)
{
  const Grid cloud = MakeCloud(500, { -1, 0, 2 }, { 1, 3, 4 }, 3);
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetInputDataObject(0, cloud);
  const Grid cage = MakeCage(source).Cage;
  Deformer deformer;
  const auto result = deformer.Run(cloud, cage, Moved(cage, Affine));
  EXPECT_TRUE(deformer.WasSilent());
  EXPECT_LT(GetLargestError(result, cloud, Affine), 1e-12);
}

/// Objects that fill their box, with the defaults of both and with few and many cells.
TEST(SubdivisionCageSource, AllOfABoxIsInsideTheSmoothedCage)
{
  Grid box = MakeCloud(0, { 0, 0, 0 }, { 1, 1, 1 }, 1);
  for (int i = 0; i < 9 * 9 * 9; ++i)
  {
    box->GetPoints()->InsertNextPoint(i % 9 / 8., 2. * (i / 9 % 9) / 8., 5. * (i / 81) / 8.);
  }
  for (const int n : { 1, 2, 5 })
  {
    for (const int levels : { 0, 2, 4 })
    {
      vtkNew<vtkSubdivisionCageSource> source;
      source->SetInputDataObject(0, box);
      source->SetNumberOfCells(n, n, 2);
      source->SetMargin(n == 1 ? 0. : 5.);
      const Grid cage = MakeCage(source).Cage;
      vtkNew<vtkSubdivisionDeformation> filter;
      filter->SetInputData(0, box);
      filter->SetRestMeshData(cage);
      filter->SetDeformedMeshData(cage);
      filter->SetNumberOfLevels(levels);
      filter->Update();
      EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0) << n << " cells, level " << levels;
    }
  }
}

TEST(SubdivisionDeformation, WithoutMeshesThereIsOneError)
{
  const Grid cloud = MakeCloud(5, { 0, 0, 0 }, { 1, 1, 1 }, 3);
  vtkNew<vtkSubdivisionDeformation> filter;
  vtkNew<Messages> heard;
  heard->Watch(filter);
  filter->SetInputDataObject(0, cloud);
  filter->Update();
  ASSERT_EQ(heard->Errors.size(), 1u);
  EXPECT_NE(heard->Errors[0].find("DeformedMesh (input port 2)"), std::string::npos);
  EXPECT_NE(heard->Errors[0].find("RestMesh is a mesh of"), std::string::npos);
  EXPECT_NE(heard->Errors[0].find("vtkSubdivisionCageSource"), std::string::npos);
  EXPECT_EQ(ComparePoints(vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0)), cloud), "");
  heard->Errors.clear();
  vtkNew<vtkSubdivisionCageSource> source;
  filter->SetRestMeshConnection(source->GetOutputPort());
  filter->Update();
  ASSERT_EQ(heard->Errors.size(), 1u);
  EXPECT_NE(heard->Errors[0].find("DeformedMesh (input port 2)"), std::string::npos);
}

namespace
{

/// Points of two crossing tubes of random radii, which fill a part of their box.
Grid MakeTubes(unsigned seed)
{
  std::mt19937 random(seed);
  const auto draw = [&random] { return random() / 4294967296.; };
  std::vector<Point> points;
  const double radius = 0.02 + 0.2 * draw();
  const double bend = 2. * draw();
  for (int i = 0; i < 4000; ++i)
  {
    const double t = 2. * draw() - 1.;
    const double a = 7. * draw();
    const double r = radius * (1. + draw() * t);
    i % 2 == 0 ? points.push_back({ 3. * t, bend * t * t + r * std::cos(a), r * std::sin(a) })
               : points.push_back({ r * std::cos(a) + t * t, r * std::sin(a), 2. * t });
  }
  return MakeGrid(points, {});
}

/// How many pairs of boxes of a cage meet in an edge or a point alone.
vtkIdType CountSurfaceEdgesOfOthers(vtkUnstructuredGrid* cage)
{
  std::map<std::set<vtkIdType>, int> faces;
  for (const Ids& tet : GetCells(cage))
  {
    for (const vtkIdType left : tet)
    {
      std::set<vtkIdType> face(tet.begin(), tet.end());
      face.erase(left);
      ++faces[face];
    }
  }
  std::map<std::set<vtkIdType>, int> edges;
  for (const auto& [face, n] : faces)
  {
    for (const vtkIdType left : face)
    {
      std::set<vtkIdType> edge(face.begin(), face.end());
      edge.erase(left);
      edges[edge] += n == 1 ? 1 : 0;
    }
  }
  return std::count_if(edges.begin(), edges.end(),
    [](const auto& edge) { return edge.second != 0 && edge.second != 2; });
}

}

/// All points are inside of the smoothed cage, which is smaller than the box, and a solid whose
/// surface is a manifold.
TEST(SubdivisionCageSource, HugsItsInput)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    SCOPED_TRACE(seed);
    const Grid tubes = MakeTubes(seed);
    const int n = 1 + static_cast<int>(seed);
    vtkNew<vtkSubdivisionCageSource> source;
    source->SetInputDataObject(0, tubes);
    source->SetNumberOfCells(n, 1 + n / 2, n + 2);
    source->SetMargin(0.);
    source->HugOn();
    const Made made = MakeCage(source);
    ASSERT_TRUE(made.Errors.empty());
    const int boxes = n * (1 + n / 2) * (n + 2);
    EXPECT_TRUE(n < 6 || made.Cage->GetNumberOfCells() < 5 * boxes);
    EXPECT_EQ(CountSurfaceEdgesOfOthers(made.Cage), 0);
    Deformer filter;
    filter->SetNumberOfLevels(3);
    filter->SetOutsidePointsToError();
    const auto same = filter.Run(tubes, made.Cage, made.Cage);
    EXPECT_TRUE(filter.WasSilent());
    EXPECT_LT(GetLargestError(same, tubes, [](const Point& x) { return x; }), 1e-12);
    const auto moved = filter.Run(tubes, made.Cage, Moved(made.Cage, Affine));
    EXPECT_LT(GetLargestError(moved, tubes, Affine), 1e-12);
  }
}

/// Boxes around single points, which would meet in edges and points.
TEST(SubdivisionCageSource, HugsSinglePoints)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const Grid cloud = MakeCloud(25, { 0., 0., 0. }, { 1., 1., 1. }, seed);
    vtkNew<vtkSubdivisionCageSource> source;
    source->SetInputDataObject(0, cloud);
    source->SetNumberOfCells(12, 11, 10);
    source->SetMargin(0.);
    source->HugOn();
    const Made made = MakeCage(source);
    EXPECT_EQ(CountSurfaceEdgesOfOthers(made.Cage), 0);
    Deformer filter;
    filter->SetOutsidePointsToError();
    filter.Run(cloud, made.Cage, made.Cage);
    EXPECT_TRUE(filter.WasSilent());
  }
}

/// Joining boxes may close a way to others: each part of a cage has one surface.
TEST(SubdivisionCageSource, HuggingLeavesNoCavities)
{
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    vtkNew<vtkSubdivisionCageSource> source;
    source->SetInputDataObject(0, MakeCloud(18, { 0., 0., 0. }, { 1., 1., 1. }, seed));
    source->SetNumberOfCells(6, 6, 6);
    source->SetMargin(0.);
    source->HugOn();
    vtkNew<vtkConnectivityFilter> parts;
    parts->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkGeometryFilter> skin;
    skin->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkConnectivityFilter> surfaces;
    surfaces->SetInputConnection(skin->GetOutputPort());
    parts->Update();
    surfaces->Update();
    EXPECT_EQ(surfaces->GetNumberOfExtractedRegions(), parts->GetNumberOfExtractedRegions())
      << seed;
  }
}

/// A skin has an inside, too: a cage has no cavity.
TEST(SubdivisionCageSource, FillsAHuggedSkin)
{
  std::vector<Point> points;
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i)
  {
    const double z = random() / 2147483648. - 1.;
    const double a = 2. * vtkMath::Pi() * (random() / 4294967296.);
    const double r = std::sqrt(1. - z * z);
    points.push_back({ r * std::cos(a), r * std::sin(a), z });
  }
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetInputDataObject(0, MakeGrid(points, {}));
  source->SetNumberOfCells(12, 12, 12);
  source->SetMargin(0.);
  source->HugOn();
  const Made made = MakeCage(source);
  double volume = 0.;
  for (const Ids& tet : GetCells(made.Cage))
  {
    volume += GetSignedVolume(made.Cage, tet);
  }
  EXPECT_GT(volume, 4. / 3. * vtkMath::Pi());
  EXPECT_LT(volume, 8.) << "which the box has";
  Deformer filter;
  filter->SetOutsidePointsToError();
  filter.Run(MakeGrid({ { 0., 0., 0. } }, {}), made.Cage, made.Cage);
  EXPECT_TRUE(filter.WasSilent()) << "the middle is inside";
  // The bounds are those of all finite coordinates.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  points = { { 0., nan, 0. }, { 1., nan, 1. }, { nan, 0., nan }, { nan, 1., nan } };
  source->SetInputDataObject(0, MakeGrid(points, {}));
  const Made none = MakeCage(source);
  EXPECT_EQ(none.Cage->GetNumberOfCells(), 0);
  ASSERT_EQ(none.Errors.size(), 1u);
  EXPECT_NE(none.Errors[0].find("has finite coordinates alone"), std::string::npos);
  points.push_back({ 0.5, 0.5, 0.5 });
  source->SetInputDataObject(0, MakeGrid(points, {}));
  EXPECT_GT(MakeCage(source).Cage->GetNumberOfCells(), 0);
}
