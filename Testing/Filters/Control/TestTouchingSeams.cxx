// SPDX-License-Identifier: BSD-3-Clause
// JoinSides of the main filter: sides of one object become one smooth surface, and each keeps its
// texture coordinates, as vtkSurfaceSubdivision keeps them; and of red-green refinement, where they
// are linear in each control triangle.
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkRedGreenRefinement.h"
#include "vtkSubdivisionOperator.h"
#include "vtkSurfaceSubdivision.h"

#include "vtkCallbackCommand.h"
#include "vtkCubeSource.h"
#include "vtkSphere.h"
#include "vtkTriangleFilter.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

using Main = vtkMultiDimensionalSubdivision;
using OfSurfaces = vtkSurfaceSubdivision;
using RedGreen = vtkRedGreenRefinement;
using Surface = vtkSmartPointer<vtkPolyData>;
/// Coordinates and texture coordinates of a point.
using Corner = std::array<double, 5>;

Surface MakeCube()
{
  vtkNew<vtkCubeSource> source;
  source->Update();
  return source->GetOutput();
}

Surface ToTriangles(const Surface& surface)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

/// A tube of quads with one texture around it, whose first and last points are in one place, and
/// lids.
Surface MakeTube(int size)
{
  const Surface tube = Surface::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkFloatArray> texture;
  texture->SetName("texture");
  texture->SetNumberOfComponents(2);
  const auto add = [&](int i, int z, double u, double v)
  {
    const double angle = 2. * vtkMath::Pi() * (i % size) / size;
    texture->InsertNextTuple2(u, v);
    return points->InsertNextPoint(std::cos(angle), std::sin(angle), z);
  };
  for (int i = 0; i <= size; ++i)
  {
    for (int z = 0; z < 3; ++z)
    {
      add(i, z, double(i) / size, 0.5 * z);
    }
  }
  for (int i = 0; i < size; ++i)
  {
    for (vtkIdType z = 0; z < 2; ++z)
    {
      const vtkIdType a = 3 * i + z;
      polys->InsertNextCell({ a, a + 3, a + 4, a + 1 });
    }
  }
  for (int z = 0; z < 3; z += 2)
  {
    const vtkIdType middle = points->InsertNextPoint(0., 0., z);
    texture->InsertNextTuple2(0.5, 0.5);
    const vtkIdType first = points->GetNumberOfPoints();
    for (int i = 0; i < size; ++i)
    {
      add(i, z, std::cos(i), std::sin(i));
    }
    for (int i = 0; i < size; i += 2)
    {
      const vtkIdType a = first + i;
      const vtkIdType b = a + 1;
      const vtkIdType c = first + (i + 2) % size;
      z == 0 ? polys->InsertNextCell({ middle, c, b, a })
             : polys->InsertNextCell({ middle, a, b, c });
    }
  }
  tube->SetPoints(points);
  tube->SetPolys(polys);
  tube->GetPointData()->SetTCoords(texture);
  return tube;
}

/// A bent sheet of rectangles from (x, y) to (x, y), each with points and a texture of its own.
Surface MakeSheet(const std::vector<std::array<int, 4>>& rectangles)
{
  const Surface sheet = Surface::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkFloatArray> texture;
  texture->SetName("texture");
  texture->SetNumberOfComponents(2);
  for (const auto& ends : rectangles)
  {
    polys->InsertNextCell(4);
    for (const int corner : { 0, 1, 3, 2 })
    {
      const int x = ends[2 * (corner % 2)];
      const int y = ends[1 + 2 * (corner / 2)];
      polys->InsertCellPoint(points->InsertNextPoint(x, y, 0.3 * x * y));
      texture->InsertNextTuple2(corner % 2, corner / 2);
    }
  }
  sheet->SetPoints(points);
  sheet->SetPolys(polys);
  sheet->GetPointData()->SetTCoords(texture);
  return sheet;
}

/// All points of all cells, in order.
std::vector<Corner> ListCorners(vtkPointSet* mesh)
{
  std::vector<Corner> corners;
  vtkDataArray* const texture = mesh->GetPointData()->GetTCoords();
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCellPoints(c, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      const Point p = GetPoint(mesh, id);
      corners.push_back({ p[0], p[1], p[2], texture ? texture->GetComponent(id, 0) : -1.,
        texture ? texture->GetComponent(id, 1) : -1. });
    }
  }
  return corners;
}

template <typename FilterClass>
vtkSmartPointer<vtkPointSet> RunOn(vtkDataObject* input, int levels,
  const std::function<void(FilterClass*)>& configure = {}, Messages* messages = nullptr)
{
  vtkNew<FilterClass> filter;
  filter->SetNumberOfLevels(levels);
  configure ? configure(filter) : void();
  vtkNew<Messages> own;
  UpdateInSilence(filter, input, messages ? messages : own.Get());
  return filter->GetOutput();
}

/// Expects points and nearly the same texture coordinates there, whatever the order of cells is.
void ExpectNear(vtkPointSet* a, vtkPointSet* b, double tolerance)
{
  std::multimap<std::array<double, 3>, Corner> places;
  const auto round = [](const Corner& corner)
  {
    std::array<double, 3> key;
    std::transform(corner.begin(), corner.begin() + 3, key.begin(),
      [](double x) { return std::round(x * 1e5) + 0.; });
    return key;
  };
  const auto expected = ListCorners(b);
  for (const Corner& corner : expected)
  {
    places.emplace(round(corner), corner);
  }
  const auto found = ListCorners(a);
  EXPECT_EQ(found.size(), expected.size());
  double most = 0.;
  for (const Corner& corner : found)
  {
    const auto [first, last] = places.equal_range(round(corner));
    double least = 1e9;
    for (auto other = first; other != last; ++other)
    {
      least =
        std::min(least, std::hypot(corner[3] - other->second[3], corner[4] - other->second[4]));
    }
    most = std::max(most, least);
  }
  EXPECT_LE(most, tolerance);
}

/// The filter of surfaces knows the angles of corners, the main filter does not.
const auto CatmullClark = [](OfSurfaces* filter)
{
  filter->SetSchemeToCatmullClark();
  filter->ModifiedBoundaryOff();
};
const auto Loop = [](OfSurfaces* filter)
{
  filter->SetSchemeToLoop();
  filter->ModifiedBoundaryOff();
};
const auto Plain = [](Main* filter) { filter->ModifiedBoundaryOff(); };

}

TEST(TouchingSeams, SidesHaveTheTextureThatTheFilterOfSurfacesGivesThem)
{
  vtkNew<Messages> messages;
  for (const Surface& surface : { MakeCube(), MakeTube(6) })
  {
    ExpectNear(
      RunOn<Main>(surface, 2, Plain, messages), RunOn<OfSurfaces>(surface, 2, CatmullClark), 2e-6);
    const Surface triangles = ToTriangles(surface);
    ExpectNear(
      RunOn<Main>(triangles, 2, Plain, messages), RunOn<OfSurfaces>(triangles, 2, Loop), 2e-6);
  }
  EXPECT_EQ(messages->CountWarnings("texture"), 0);
}

TEST(TouchingSeams, TheShapeIsThatOfSidesWithoutTexture)
{
  const Surface bare = MakeCube();
  const Surface cube = MakeCube();
  bare->GetPointData()->SetTCoords(nullptr);
  for (int levels = 0; levels < 4; ++levels)
  {
    const auto made = RunOn<Main>(cube, levels);
    const auto expected = RunOn<Main>(bare, levels);
    // The same points, and then copies of some.
    ASSERT_GT(made->GetNumberOfPoints(), expected->GetNumberOfPoints());
    for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(GetPoint(made, i), GetPoint(expected, i));
    }
    auto corners = ListCorners(made);
    auto without = ListCorners(expected);
    ASSERT_EQ(corners.size(), without.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      EXPECT_TRUE(std::equal(corners[i].begin(), corners[i].begin() + 3, without[i].begin()));
    }
    // 24 corners of sides; points on edges twice, inside of sides once.
    const int n = 1 << levels;
    EXPECT_EQ(made->GetNumberOfPoints(), 6 * (n + 1) * (n + 1));
    for (int k = 0; k < 2; ++k) // corners of textures stay
    {
      double range[4];
      made->GetPointData()->GetTCoords()->GetRange(range, k);
      cube->GetPointData()->GetTCoords()->GetRange(range + 2, k);
      EXPECT_EQ(range[0], range[2]);
      EXPECT_EQ(range[1], range[3]);
    }
  }
}

TEST(TouchingSeams, FiltersInARowAreOne)
{
  for (const Surface& surface : { MakeCube(), MakeTube(6) })
  {
    const auto whole = RunOn<Main>(surface, 3);
    ASSERT_TRUE(whole->GetPointData()->GetTCoords());
    const auto row = RunOn<Main>(RunOn<Main>(RunOn<Main>(surface, 1), 1), 1);
    ExpectNear(row, whole, 1e-6);
    ASSERT_EQ(row->GetNumberOfPoints(), whole->GetNumberOfPoints());
    for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(GetPoint(row, i), GetPoint(whole, i));
    }
  }
}

TEST(TouchingSeams, LimitsAndOtherArraysAndOptions)
{
  const Surface cube = MakeCube();
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType i = 0; i < 24; ++i)
  {
    values->InsertNextValue(cube->GetPoint(i)[0]);
  }
  cube->GetPointData()->AddArray(values);
  const auto made = RunOn<Main>(cube, 2,
    [](Main* filter)
    {
      filter->ProjectToLimitOn();
      filter->GenerateLimitNormalsOn();
      filter->GenerateTangentsOn();
      filter->GenerateOriginalIdsOn();
      filter->GenerateGlobalIdsOn();
      filter->InterpolatePointsOn();
    });
  vtkPointData* const data = made->GetPointData();
  ASSERT_TRUE(data->GetTCoords() && data->GetNormals());
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    EXPECT_EQ(data->GetAbstractArray(a)->GetNumberOfTuples(), made->GetNumberOfPoints());
  }
  for (vtkIdType i = 0; i < 8; ++i) // control points, on the limit
  {
    EXPECT_NEAR(data->GetArray("values")->GetComponent(i, 0), made->GetPoint(i)[0], 0.6);
    EXPECT_NEAR(std::abs(made->GetPoint(i)[0]), 0.5, 1e-6);
  }
}

TEST(TouchingSeams, OperatorsHaveRowsForCopies)
{
  for (const Surface& surface : { MakeCube(), ToTriangles(MakeTube(6)) })
  {
    vtkNew<Main> filter;
    filter->SetInputDataObject(surface);
    filter->SetNumberOfLevels(2);
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->Update();
    vtkNew<vtkSubdivisionOperator> found;
    ASSERT_TRUE(filter->ComputeOperator(found));
    EXPECT_EQ(found->GetNumberOfColumns(), surface->GetNumberOfPoints());
    EXPECT_EQ(found->GetNumberOfRows(), filter->GetOutput()->GetNumberOfPoints());
  }
}

/// Of points that moved, and of another texture, nothing is built anew.
TEST(TouchingSeams, OperatorsAreKept)
{
  for (const int scheme : { Main::BOX_SPLINE, Main::HYBRID })
  {
    vtkNew<Main> filter;
    filter->SetVolumeScheme(scheme);
    filter->SetNumberOfLevels(3);
    const Surface cube = MakeCube();
    filter->SetInputDataObject(cube);
    filter->Update();
    const vtkIdType builds = filter->GetNumberOfTopologyBuilds();
    const Surface moved = Surface::New();
    moved->DeepCopy(cube);
    for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
    {
      const Point p = GetPoint(moved, i);
      moved->GetPoints()->SetPoint(i, 2. * p[0], p[1], p[2] + p[0]);
    }
    moved->GetPointData()->GetTCoords()->SetTuple2(0, 5., 5.);
    filter->SetInputDataObject(moved);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), builds);
    const auto afresh =
      RunOn<Main>(moved, 3, [scheme](Main* one) { one->SetVolumeScheme(scheme); });
    EXPECT_EQ(ListCorners(filter->GetOutput()), ListCorners(afresh));
  }
}

TEST(TouchingSeams, OthersAreToldAndLeftOut)
{
  const auto told =
    [&](vtkPolyData* surface, const std::function<void(Main*)>& configure, const char* text)
  {
    vtkNew<Messages> messages;
    const auto made = RunOn<Main>(surface, 1, configure, messages);
    EXPECT_FALSE(made->GetPointData()->GetTCoords());
    EXPECT_EQ(messages->CountWarnings(text), 1) << text;
  };
  told(MakeCube(), [](Main* filter) { filter->GenerateErrorBoundsOn(); }, "differ in the texture");
  told(
    MakeCube(), [](Main* filter) { filter->SetOutputCellsToQuadratic(); }, "differ in the texture");
  const Surface sheet = MakeSheet({ { 0, 0, 1, 1 }, { 1, 0, 2, 1 } });
  told(sheet, {}, "differ in the texture"); // open: the next filter would not join it
  // Beside other pieces that stay apart, closed ones keep theirs.
  const Surface both = MakeCube();
  for (int i = 0; i < 12; ++i) // two strips that meet
  {
    const int y = i / 3 - i / 6;
    both->GetPoints()->InsertNextPoint(5. + i % 3, y, y == 2);
    both->GetPointData()->GetTCoords()->InsertNextTuple2(i % 3, y);
    both->GetPointData()->GetNormals()->InsertNextTuple3(0., 0., 1.);
  }
  for (const vtkIdType first : { 24, 25, 30, 31 })
  {
    both->GetPolys()->InsertNextCell({ first, first + 1, first + 4, first + 3 });
  }
  EXPECT_TRUE(RunOn<Main>(both, 1)->GetPointData()->GetTCoords());
  // Means have no sides.
  const auto means =
    RunOn<Main>(MakeCube(), 1, [](Main* filter) { filter->SetMergedValuesToAverage(); });
  EXPECT_TRUE(means->GetPointData()->GetTCoords());
  EXPECT_EQ(means->GetNumberOfPoints(), 26);
  // Nor have textures that are equal on both sides.
  const Surface cube = MakeCube();
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    cube->GetPointData()->GetTCoords()->SetTuple2(i, cube->GetPoint(i)[0], cube->GetPoint(i)[2]);
  }
  const auto equal = RunOn<Main>(cube, 1);
  EXPECT_TRUE(equal->GetPointData()->GetTCoords());
  EXPECT_EQ(equal->GetNumberOfPoints(), 26);
}

TEST(TouchingSeams, AnAbortStopsTheWorkOnTextures)
{
  vtkNew<Main> filter;
  filter->SetInputDataObject(MakeCube());
  filter->SetNumberOfLevels(4);
  double last = 0.;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&last);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* const running = static_cast<vtkAlgorithm*>(caller);
      EXPECT_GE(running->GetProgress(), *static_cast<double*>(data)); // never goes back
      *static_cast<double*>(data) = running->GetProgress();
      running->GetProgress() > 0.75 ? running->SetAbortExecute(1) : void();
    });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

namespace
{

/// Refined in a ball that cuts seams.
vtkSmartPointer<vtkPointSet> Refine(vtkDataObject* input, int levels,
  const std::function<void(RedGreen*)>& configure = {}, Messages* messages = nullptr)
{
  vtkNew<vtkSphere> ball;
  ball->SetCenter(0.5, 0.4, 0.45);
  ball->SetRadius(0.7);
  vtkNew<RedGreen> filter;
  filter->RefineByAttributeErrorOff();
  filter->RefineByFunctionOn();
  filter->SetImplicitFunction(ball);
  filter->SetMaximumLevel(levels);
  configure ? configure(filter) : void();
  vtkNew<Messages> own;
  UpdateInSilence(filter, input, messages ? messages : own.Get());
  return filter->GetOutput();
}

/// The texture coordinates of a place in a triangle of a mesh.
std::array<double, 2> FindTexture(vtkPointSet* mesh, vtkIdType triangle, const Point& place)
{
  vtkCell* const cell = mesh->GetCell(triangle);
  double closest[3];
  double parameters[3];
  double distance = 0.;
  double weights[3];
  int part = 0;
  cell->EvaluatePosition(place.data(), closest, part, parameters, distance, weights);
  EXPECT_LT(distance, 1e-12);
  std::array<double, 2> found{};
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      found[k] +=
        weights[i] * mesh->GetPointData()->GetTCoords()->GetComponent(cell->GetPointId(i), k);
    }
  }
  return found;
}

/// Expects in each cell the texture of the control triangle of which it is a part.
void ExpectLinearTexture(vtkPointSet* made, vtkPointSet* control)
{
  vtkDataArray* const texture = made->GetPointData()->GetTCoords();
  vtkDataArray* const sources = made->GetCellData()->GetArray("vtkOriginalCellIds");
  ASSERT_TRUE(texture && sources);
  std::vector<bool> isUsed(static_cast<std::size_t>(made->GetNumberOfPoints()), false);
  for (vtkIdType c = 0; c < made->GetNumberOfCells(); ++c)
  {
    const auto source = static_cast<vtkIdType>(sources->GetComponent(c, 0));
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType point = made->GetCell(c)->GetPointId(i);
      isUsed[static_cast<std::size_t>(point)] = true;
      const auto expected = FindTexture(control, source, GetPoint(made, point));
      EXPECT_NEAR(texture->GetComponent(point, 0), expected[0], 2e-6);
      EXPECT_NEAR(texture->GetComponent(point, 1), expected[1], 2e-6);
    }
  }
  EXPECT_EQ(std::count(isUsed.begin(), isUsed.end(), false), 0);
}

}

TEST(TouchingSeams, LocalRefinementIsLinearOnBothSides)
{
  for (const Surface& surface : { ToTriangles(MakeCube()), ToTriangles(MakeTube(6)) })
  {
    vtkNew<Messages> messages;
    const auto made = Refine(surface, 4, {}, messages);
    EXPECT_EQ(messages->CountWarnings("texture"), 0);
    EXPECT_GT(made->GetNumberOfCells(), 2 * surface->GetNumberOfCells());
    ExpectLinearTexture(made, surface);
    // A filter after it joins the sides again, undoes green cells, and goes on.
    const auto row = Refine(Refine(surface, 2), 4);
    SCOPED_TRACE("row");
    ExpectLinearTexture(row, surface);
  }
}

TEST(TouchingSeams, LocalRefinementHasThePointsOfSidesWithoutTexture)
{
  const Surface cube = ToTriangles(MakeCube());
  const Surface bare = Surface::New();
  bare->DeepCopy(cube);
  bare->GetPointData()->SetTCoords(nullptr);
  const auto compare = [](vtkPointSet* made, vtkPointSet* expected)
  {
    ASSERT_EQ(made->GetNumberOfCells(), expected->GetNumberOfCells());
    for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(GetPoint(made, i), GetPoint(expected, i));
    }
  };
  const auto made = Refine(cube, 2);
  const auto expected = Refine(bare, 2);
  compare(made, expected);
  compare(Refine(made, 2), Refine(expected, 2));
}

TEST(TouchingSeams, LocalRefinementOnTheLimitHasTheSameTexture)
{
  const Surface surface = ToTriangles(MakeTube(6));
  const auto onLimit = [](RedGreen* filter)
  {
    filter->SetPlacementToLimit();
    filter->GenerateLimitNormalsOn();
  };
  const auto made = Refine(surface, 1, onLimit);
  const auto straight = Refine(surface, 1);
  ASSERT_EQ(made->GetNumberOfPoints(), straight->GetNumberOfPoints());
  vtkPointData* const data = made->GetPointData();
  ASSERT_TRUE(data->GetTCoords() && data->GetNormals());
  EXPECT_EQ(data->GetNormals()->GetNumberOfTuples(), made->GetNumberOfPoints());
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_EQ(data->GetTCoords()->GetComponent(i, k),
        straight->GetPointData()->GetTCoords()->GetComponent(i, k));
    }
  }
}

TEST(TouchingSeams, LocalRefinementOfQuadsKeepsTheirTexture)
{
  const auto made = Refine(MakeCube(), 3);
  vtkDataArray* const texture = made->GetPointData()->GetTCoords();
  vtkDataArray* const sources = made->GetCellData()->GetArray("vtkOriginalCellIds");
  ASSERT_TRUE(texture && sources);
  const auto cube = MakeCube();
  for (vtkIdType c = 0; c < made->GetNumberOfCells(); ++c)
  {
    // The texture of a side of the cube is linear.
    vtkCell* const quad = cube->GetCell(static_cast<vtkIdType>(sources->GetComponent(c, 0)));
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType id = made->GetCell(c)->GetPointId(i);
      double closest[3];
      double parameters[3];
      double distance = 0.;
      double weights[4];
      int part = 0;
      quad->EvaluatePosition(made->GetPoint(id), closest, part, parameters, distance, weights);
      for (int k = 0; k < 2; ++k)
      {
        double expected = 0.;
        for (int j = 0; j < 4; ++j)
        {
          expected +=
            weights[j] * cube->GetPointData()->GetTCoords()->GetComponent(quad->GetPointId(j), k);
        }
        EXPECT_NEAR(texture->GetComponent(id, k), expected, 1e-6);
      }
    }
  }
}

TEST(TouchingSeams, LocalRefinementTellsWhereItKeepsNone)
{
  vtkNew<Messages> messages;
  const auto made =
    Refine(MakeCube(), 1, [](RedGreen* filter) { filter->SetOutputCellsToQuadratic(); }, messages);
  EXPECT_FALSE(made->GetPointData()->GetTCoords());
  EXPECT_EQ(messages->CountWarnings("differ in the texture"), 1);
}
