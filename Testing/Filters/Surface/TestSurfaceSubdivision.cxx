// SPDX-License-Identifier: BSD-3-Clause
// The surface filter as a filter: threads, messages, storage, hostile input. The algebra of its
// operator is tested in Python (test_surfaces.py).
#include "SurfaceTools.h"

#include "Core/Surfaces/Scheme/SurfaceRings.h"

namespace
{

using namespace surfacetools;
using multi_dimensional_subdivision_tools::MakeArray;
using multi_dimensional_subdivision_tools::MakeInThreads;
using multi_dimensional_subdivision_tools::Messages;
using Surface = vtkSmartPointer<vtkPolyData>;
using Ids = std::vector<vtkIdType>;

/// A bumpy sheet of quads, some of them two triangles.
Surface MakeSheet(int n)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> height(0., 1.);
  Model model = surfacetools::MakeSheet(n, n, false, { 1., 0., 0. }, { 0., 1., 0. });
  for (Point& point : model.Points)
  {
    point[2] = height(random);
  }
  const Polygons quads = std::exchange(model.Faces, {});
  for (int i = 0; i < n * n; ++i)
  {
    const auto& quad = quads[i];
    if ((i % n + i / n) % 3 == 0)
    {
      model.Faces.push_back({ quad[0], quad[1], quad[2] });
      model.Faces.push_back({ quad[0], quad[2], quad[3] });
    }
    else
    {
      model.Faces.push_back(quad);
    }
  }
  return MakeInput(model);
}

/// Runs the filter and keeps what it says.
class Filter
{
public:
  explicit Filter(vtkPolyData* input)
  {
    this->Object->SetInputData(input);
    this->Heard->Watch(this->Object);
  }
  vtkPolyData* operator()()
  {
    this->Object->Update();
    return this->Object->GetOutput();
  }
  vtkSurfaceSubdivision* operator->() { return this->Object; }

private:
  vtkNew<vtkSurfaceSubdivision> Object;
  vtkNew<Messages> Heard;

public:
  const std::vector<std::string>& Warnings = Heard->Warnings;
  const std::vector<std::string>& Errors = Heard->Errors;
};

/// Steps that make about as many faces as `steps` of Loop.
int FindSteps(int scheme, int steps)
{
  return scheme == vtkSurfaceSubdivision::MIDEDGE || scheme == vtkSurfaceSubdivision::FOUR_EIGHT
    ? 2 * steps
    : scheme == vtkSurfaceSubdivision::SQRT_THREE ? steps + 1
                                                  : steps;
}

class SurfaceSchemesTest : public testing::TestWithParam<int>
{
};

TEST_P(SurfaceSchemesTest, ThreadsDoNotChangeTheResult)
{
  const Surface sheet = MakeSheet(40);
  const vtkIdType size = sheet->GetNumberOfPoints();
  sheet->GetPointData()->AddArray(MakeArray<vtkUnsignedCharArray>("colours", 3, size, 0, 256, 1));
  sheet->GetPointData()->AddArray(MakeArray<vtkIntArray>("labels", 1, size, 0, 7, 2));
  for (const bool hasCreases : { false, true }) // without them levels may be skipped
  {
    for (vtkIdType i = 0; i < 20 && hasCreases; ++i)
    {
      sheet->GetLines()->InsertNextCell({ 42 * i, 42 * i + 1 });
    }
    const Surface result = MakeInThreads(
      [&]
      {
        Filter run(sheet);
        run->SetScheme(GetParam());
        run->SetNumberOfLevels(FindSteps(GetParam(), 3));
        run->SetProjectToLimit(true);
        run->SetGenerateLimitNormals(true);
        const Surface output = run();
        EXPECT_TRUE(run.Errors.empty());
        return output;
      });
    EXPECT_GT(result->GetNumberOfPolys(), 60000);
  }
}

TEST_P(SurfaceSchemesTest, CacheGivesTheSameBits)
{
  for (const int levels : { 2, 4 }) // of more levels some go before the last step if none is kept
  {
    SCOPED_TRACE(levels);
    const Surface sheet = MakeSheet(6);
    Filter kept(sheet);
    kept->SetScheme(GetParam());
    kept->SetNumberOfLevels(levels);
    Surface before = Surface::New();
    before->ShallowCopy(kept());
    sheet->GetPoints()->SetPoint(8, 3., 2., 7.);
    sheet->GetPoints()->Modified();
    sheet->Modified();
    vtkPolyData* after = kept();
    EXPECT_EQ(kept->GetNumberOfTopologyBuilds(), 1);
    EXPECT_EQ(after->GetPolys(), before->GetPolys());
    Filter fresh(sheet);
    fresh->SetScheme(GetParam());
    fresh->SetNumberOfLevels(levels);
    fresh->SetCacheOperator(false);
    ExpectSameBits(fresh(), after);
    EXPECT_EQ(fresh->GetNumberOfTopologyBuilds(), 0);
  }
}

TEST_P(SurfaceSchemesTest, NarrowIdsHoldTheSame)
{
  const Surface sheet = MakeSheet(4);
  Filter wide(sheet);
  Filter narrow(sheet);
  wide->SetScheme(GetParam());
  narrow->SetScheme(GetParam());
  narrow->SetUse32BitIds(true);
  ExpectSameBits(wide(), narrow());
  EXPECT_FALSE(narrow()->GetPolys()->IsStorage64Bit());
}

TEST_P(SurfaceSchemesTest, NonManifoldInputIsNeverRefused)
{
  // Random triangles on few points: edges of many faces, pinched vertices, equal triangles.
  std::mt19937 random(11);
  std::uniform_int_distribution<vtkIdType> point(0, 11);
  for (unsigned trial = 0; trial < 20; ++trial)
  {
    std::vector<Ids> faces;
    for (int i = 0; i < 25; ++i)
    {
      const Ids ids{ point(random), point(random), point(random) };
      if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0])
      {
        faces.push_back(ids);
      }
    }
    Filter run(MakeInput(MakeRandomPoints(12, trial), faces, { { 0, 1, 5 }, { 3, 9 } }));
    run->SetScheme(GetParam());
    run->SetNumberOfLevels(FindSteps(GetParam(), 2));
    run->SetProjectToLimit(true);
    run->SetGenerateLimitNormals(true);
    vtkPolyData* out = run();
    EXPECT_TRUE(run.Errors.empty());
    EXPECT_GE(out->GetNumberOfPolys(), static_cast<vtkIdType>(faces.size()) * 9);
    double bounds[6];
    out->GetPoints()->GetBounds(bounds);
    for (double bound : bounds)
    {
      EXPECT_LT(std::abs(bound), 4.);
    }
    for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i)
    {
      double x[3];
      out->GetPoint(i, x);
      EXPECT_TRUE(std::isfinite(x[0] + x[1] + x[2]));
    }
  }
}

TEST_P(SurfaceSchemesTest, NothingInNothingOut)
{
  Filter run(Surface::New());
  run->SetScheme(GetParam());
  EXPECT_EQ(run()->GetNumberOfPoints(), 0);
  Filter points(MakeInput({ { 1., 2., 3. } }, {}));
  points->SetScheme(GetParam());
  EXPECT_EQ(points()->GetNumberOfPoints(), 1);
  EXPECT_TRUE(run.Errors.empty() && points.Errors.empty());
}

INSTANTIATE_TEST_SUITE_P(SurfaceSubdivision, SurfaceSchemesTest,
  testing::Values(vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
    vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, vtkSurfaceSubdivision::DOO_SABIN,
    vtkSurfaceSubdivision::MIDEDGE, vtkSurfaceSubdivision::FOUR_EIGHT,
    vtkSurfaceSubdivision::SQRT_THREE, vtkSurfaceSubdivision::LINEAR));

TEST(SurfaceSubdivision, StripsBecomeTrianglesInPlace)
{
  const Surface strip =
    MakeInput({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 1., 1., 0. } }, {});
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  strip->SetStrips(strips);
  for (int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK })
  {
    Filter run(strip);
    run->SetScheme(scheme);
    run->SetNumberOfLevels(0);
    vtkPolyData* out = run();
    ASSERT_EQ(out->GetNumberOfPolys(), 2);
    vtkNew<vtkIdList> ids;
    out->GetCellPoints(1, ids);
    EXPECT_EQ(ids->GetId(0), 2);
    EXPECT_EQ(ids->GetId(1), 1);
    EXPECT_EQ(ids->GetId(2), 3);
  }
}

TEST(SurfaceSubdivision, PolygonsWithARepeatedPointCollapseOrAreLeftOut)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 },
    { 1, 1, 0 }, { 2, 1, 0 } };
  // The second one names a point twice in a row, the third one at two places.
  Filter filter(MakeInput(points, { { 0, 1, 4, 3 }, { 1, 1, 2, 5, 4 }, { 0, 1, 2, 1, 4 } }));
  filter->SetScheme(vtkSurfaceSubdivision::CATMULL_CLARK);
  filter->SetNumberOfLevels(0);
  vtkCellArray* polys = filter()->GetPolys();
  ASSERT_EQ(polys->GetNumberOfCells(), 2);
  const Ids expected[2] = { { 0, 1, 4, 3 }, { 1, 2, 5, 4 } };
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    vtkNew<vtkIdList> ids;
    polys->GetCellAtId(cell, ids);
    EXPECT_EQ(Ids(ids->begin(), ids->end()), expected[cell]);
  }
  std::string all;
  for (const std::string& warning : filter.Warnings)
  {
    all += warning;
  }
  EXPECT_NE(all.find("1 polygon(s) pass through a point twice"), std::string::npos) << all;
}

TEST(SurfaceSubdivision, UnusableArraysAreNamed)
{
  const Surface sheet = MakeSheet(2);
  vtkNew<vtkDoubleArray> flags;
  flags->SetName("flags");
  flags->SetNumberOfTuples(sheet->GetNumberOfCells());
  flags->FillValue(0.5);
  sheet->GetCellData()->AddArray(flags);
  Filter run(sheet);
  run->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "flags");
  EXPECT_EQ(run()->GetNumberOfPoints(), 0);
  ASSERT_FALSE(run.Errors.empty());
  EXPECT_NE(run.Errors.front().find("\"flags\""), std::string::npos);
  Filter missing(sheet);
  missing->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "no such");
  missing();
  ASSERT_FALSE(missing.Errors.empty());
  EXPECT_NE(missing.Errors.front().find("Point array \"no such\""), std::string::npos);
}

TEST(SurfaceSubdivision, FanWalksTurnAtFlippedFaces)
{
  // A closed fan of four triangles, every other one the wrong way round.
  subdivision::PolygonList<int> list;
  list.NumberOfVertices = 5;
  const int corners[12] = { 0, 1, 2, 0, 3, 2, 0, 3, 4, 0, 1, 4 };
  list.Vertices = subdivision::Buffer<int>(12);
  std::copy(corners, corners + 12, list.Vertices.begin());
  list.FaceOffsets = subdivision::Buffer<int>(5);
  for (int f = 0; f < 5; ++f)
  {
    list.FaceOffsets[f] = 3 * f;
  }
  list.Segments = subdivision::Buffer<int>(0);
  subdivision::Buffer<int> segments;
  const auto mesh = subdivision::BuildPolygonMesh(std::move(list), segments);
  EXPECT_EQ(mesh.GetNumberOfEdges(), 8);
  EXPECT_TRUE(mesh.Joints.empty());
  std::vector<int> faces;
  EXPECT_TRUE(subdivision::VisitFan(mesh, mesh.VertexCorners[0],
    [&](const subdivision::FanStep<int>& step) { faces.push_back(mesh.GetFace(step.Corner)); }));
  EXPECT_EQ(faces.size(), 4u);
  faces.clear();
  EXPECT_FALSE(subdivision::VisitFan(mesh, mesh.VertexCorners[2],
    [&](const subdivision::FanStep<int>& step) { faces.push_back(mesh.GetFace(step.Corner)); }));
  EXPECT_EQ(faces.size(), 2u);
}

}
