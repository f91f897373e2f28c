// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionLimitProbe.cxx
 * Nearest places on the limit: known places are found again, and no vertex of a fine level is
 * nearer.
 */
#include "LimitProbeTools.h"
#include "Turns.h"

#include "vtkStaticPointLocator.h"
#include "vtkSubdivisionModelSource.h"

using namespace limit_probe_tools;

namespace
{

/// Switches ModifiedBoundary on, with angles of corners.
struct ModifyBoundary
{
  template <typename Filter>
  void operator()(Filter* filter) const
  {
    filter->ModifiedBoundaryOn();
    filter->SetInputArrayToProcess(10, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Angle");
  }
};

}

TEST(SubdivisionLimitProbe, NoVertexOfAFineLevelIsNearer)
{
  std::mt19937 random(1);
  const auto draw = [&random] { return random() / 4294967296.; };
  std::vector<Point> targets;
  for (int i = 0; i < 200; ++i)
  {
    targets.push_back({ 7. * draw() - 1., 6. * draw() - 1., draw() - 0.5 }); // some beside it
  }
  ExpectNoVertexIsNearer(MakeWavySurface(0.1, 0.4), targets, 5, 0.03); // vertices are as far apart
}

/// A place that was moved along the normal is found again; so are places on curves.
TEST(SubdivisionLimitProbe, FootPoints)
{
  const Grid mesh = MakeWavySurface(0.1, 0.4);
  const vtkIdType line[3] = { 40, 41, 42 };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(mesh->GetPoints());
  for (int i = 0; i < 7; ++i)
  {
    points->InsertNextPoint(i, 0.3 * i * i, 20.);
  }
  mesh->SetPoints(points);
  mesh->InsertNextCell(VTK_LINE, 2, line);
  mesh->InsertNextCell(VTK_LINE, 2, line + 1);
  vtkNew<vtkMultiDimensionalSubdivision> evaluator;
  evaluator->SetInputData(mesh);
  vtkNew<vtkIdTypeArray> cells;
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetNumberOfComponents(3);
  // Some places are so near to an edge that the search may begin beyond it.
  const std::vector<Point> ofTriangles = { { 0.3, 0.4, 0. }, { 0.003, 0.4, 0. }, { 0.4, 0.003, 0. },
    { 0.5, 0.497, 0. }, { 0.05, 0.1, 0. } };
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    for (const Point& p : ofTriangles)
    {
      cells->InsertNextValue(i);
      parameters->InsertNextTuple3(p[0], mesh->GetCellType(i) == VTK_LINE ? 0. : p[1], 0.);
    }
  }
  vtkNew<vtkPolyData> at;
  ASSERT_TRUE(evaluator->EvaluateLimit(cells, parameters, at));
  const std::vector<Point> targets = place_tools::MoveAlongNormals(at, 0.2); // zero on curves
  const auto found = Probe(mesh, targets);
  for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(found, i)[c], GetPoint(at, i)[c], 1e-8) << i;
    }
    const vtkIdType cell = cells->GetValue(i);
    EXPECT_EQ(found->GetPointData()->GetArray("CellId")->GetComponent(i, 0), cell);
    EXPECT_NEAR(found->GetPointData()->GetArray("Distance")->GetComponent(i, 0),
      mesh->GetCellType(cell) == VTK_LINE ? 0. : 0.2, 1e-10)
      << i;
  }
}

/// At creases each cell may have a nearest place of its own. No vertex of level 7 is nearer than
/// the one that is found, for points at any small distance from vertices of a crease, and its ends.
TEST(SubdivisionLimitProbe, NearestPlacesAtIrregularCreases)
{
  for (unsigned int seed = 0; seed < 5; ++seed)
  {
    if (!turns::IsInTurn(seed))
    {
      continue;
    }
    std::mt19937 random(seed);
    const auto draw = [&random] { return random() / 4294967296.; };
    std::vector<Point> points;
    std::vector<Cell> cells;
    for (int i = 0; i < 36; ++i)
    {
      points.push_back({ i % 6 + 0.3 * draw(), i / 6 + 0.3 * draw(), 0.8 * draw() });
    }
    for (vtkIdType i = 0; i < 29; ++i)
    {
      if (i % 6 < 5)
      {
        const bool turned = draw() < 0.5;
        cells.push_back({ VTK_TRIANGLE, { i, i + 1, turned ? i + 6 : i + 7 } });
        cells.push_back({ VTK_TRIANGLE, { turned ? i + 1 : i, i + 7, i + 6 } });
      }
    }
    const std::size_t triangles = cells.size();
    Ids crease{ 7 + static_cast<vtkIdType>(random() % 4) };
    while (crease.back() % 6 < 5 && crease.back() / 6 < 5 && crease.size() < 6)
    {
      crease.push_back(crease.back() + (random() % 2 == 0 ? 1 : 6));
      cells.push_back({ VTK_LINE, { crease[crease.size() - 2], crease.back() } });
    }
    const Grid mesh = MakeGrid(points, cells);
    vtkNew<vtkIntArray> flags;
    flags->SetName("Singular");
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      flags->InsertNextValue(i < triangles ? 0 : 1);
    }
    mesh->GetCellData()->AddArray(flags);
    const auto project = [&mesh](int levels)
    {
      vtkNew<vtkMultiDimensionalSubdivision> filter;
      filter->SetNumberOfLevels(levels);
      filter->ProjectToLimitOn();
      return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
    };
    const Grid coarse = project(0);
    const Grid fine = project(7);
    std::vector<Point> targets;
    for (const vtkIdType vertex : crease)
    {
      for (int i = 0; i < 40; ++i)
      {
        Point target = GetPoint(coarse, vertex);
        const double size = std::pow(10., -2. * draw());
        for (double& x : target)
        {
          x += size * (1.2 * draw() - 0.6);
        }
        targets.push_back(target);
      }
    }
    const auto found = Probe(mesh, targets);
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(fine);
    locator->BuildLocator();
    for (std::size_t t = 0; t < targets.size(); ++t)
    {
      const Point p = GetPoint(fine, locator->FindClosestPoint(targets[t].data()));
      EXPECT_LE(
        found->GetPointData()->GetArray("Distance")->GetComponent(static_cast<vtkIdType>(t), 0),
        std::hypot(p[0] - targets[t][0], p[1] - targets[t][1], p[2] - targets[t][2]) + 1e-10)
        << seed << " " << t << ", vertex " << crease[t / 40];
    }
  }
}

/// The limit of the linear scheme is the mesh.
TEST(SubdivisionLimitProbe, OfTheLinearSchemeAreOnTheMesh)
{
  const Grid mesh = MakeModel(vtkSubdivisionModelSource::MIXED_DIMENSIONS);
  std::mt19937 random(2);
  std::vector<Point> targets;
  for (int i = 0; i < 60; ++i)
  {
    const auto draw = [&](int axis)
    {
      const double* bounds = mesh->GetBounds() + 2 * axis;
      return bounds[0] + (bounds[1] - bounds[0]) * (random() / 2147483648. - 0.5);
    };
    const double x = draw(0);
    const double y = draw(1);
    targets.push_back({ x, y, draw(2) });
  }
  vtkNew<vtkSubdivisionLimitProbe> filter;
  filter->SetSchemeToLinear();
  filter->SetInputDataObject(3, place_tools::MakeTargets(targets));
  const auto found = UpdateWithoutErrors<vtkPolyData>(filter.Get(), mesh);
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    double least = 1e9;
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
    {
      std::vector<double> weights(8);
      double nearest[3];
      double parameters[3];
      double squared = 0.;
      int part = 0;
      mesh->GetCell(c)->EvaluatePosition(
        targets[i].data(), nearest, part, parameters, squared, weights.data());
      least = std::min(least, squared);
    }
    EXPECT_NEAR(found->GetPointData()->GetArray("Distance")->GetComponent(i, 0), std::sqrt(least),
      1e-9 * mesh->GetLength())
      << i;
  }
}

/// The limit is that of ModifiedBoundary, next to borders, creases and corners with an angle.
TEST(SubdivisionLimitProbe, FootPointsOfModifiedBoundary)
{
  const Grid mesh = MakeWavySurface(0.1, 0.4);
  mesh->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Angle", 1, mesh->GetNumberOfPoints(), 60., 160., 3));
  const vtkIdType crease[3] = { 14, 15, 16 };
  const vtkIdType corners[2] = { 0, 15 };
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  const vtkIdType triangles = mesh->GetNumberOfCells();
  mesh->InsertNextCell(VTK_LINE, 2, crease);
  mesh->InsertNextCell(VTK_LINE, 2, crease + 1);
  mesh->InsertNextCell(VTK_VERTEX, 1, corners);
  mesh->InsertNextCell(VTK_VERTEX, 1, corners + 1);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    flags->InsertNextValue(i < triangles ? 0 : 1);
  }
  mesh->GetCellData()->AddArray(flags);
  vtkNew<vtkIdTypeArray> cells;
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    for (const Point& p : { Point{ 0.3, 0.4, 0. }, Point{ 0.05, 0.1, 0. } })
    {
      cells->InsertNextValue(i);
      parameters->InsertNextTuple(p.data());
    }
  }
  const auto evaluate = [&](bool modified)
  {
    vtkNew<vtkMultiDimensionalSubdivision> evaluator;
    evaluator->SetInputData(mesh);
    if (modified)
    {
      ModifyBoundary()(evaluator.Get());
    }
    const auto at = vtkSmartPointer<vtkPolyData>::New();
    EXPECT_TRUE(evaluator->EvaluateLimit(cells, parameters, at));
    return at;
  };
  const auto at = evaluate(true);
  const auto plain = evaluate(false);
  const std::vector<Point> targets = place_tools::MoveAlongNormals(at, 0.05);
  const auto found = Probe(mesh, targets, ModifyBoundary());
  double difference = 0.;
  for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(found->GetPointData()->GetArray("CellId")->GetComponent(i, 0), cells->GetValue(i));
    EXPECT_NEAR(found->GetPointData()->GetArray("Distance")->GetComponent(i, 0), 0.05, 1e-10) << i;
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(found, i)[c], GetPoint(at, i)[c], 1e-8) << i;
      difference = std::max(difference, std::abs(GetPoint(at, i)[c] - GetPoint(plain, i)[c]));
    }
  }
  EXPECT_GT(difference, 0.01); // so that a filter without the option fails
}

TEST(SubdivisionLimitProbe, SplitCellsAndErrors)
{
  const Grid box = MakeMixedBox(2);
  vtkNew<vtkSubdivisionLimitProbe> filter;
  filter->SetSchemeToBoxSpline();
  filter->SetInputDataObject(3, place_tools::MakeTargets({ { 0.4, 0.4, 0.4 }, { 1.4, 1.3, 1.2 } }));
  const auto found = UpdateWithoutErrors<vtkPolyData>(filter.Get(), box);
  ASSERT_EQ(found->GetNumberOfPoints(), 2);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    const auto cell =
      static_cast<vtkIdType>(found->GetPointData()->GetArray("CellId")->GetComponent(i, 0));
    const double parameter = found->GetPointData()->GetArray("CellParameters")->GetComponent(i, 0);
    EXPECT_EQ(parameter == -1., box->GetCell(cell)->GetNumberOfPoints() > 4);
  }
  vtkNew<Messages> messages;
  messages->Watch(filter);
  const auto fails = [&](vtkDataObject* mesh, const Point& target, const char* part)
  {
    messages->Errors.clear();
    filter->SetInputDataObject(mesh);
    filter->SetInputDataObject(3, place_tools::MakeTargets({ target }));
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    ASSERT_FALSE(messages->Errors.empty()) << part;
    EXPECT_NE(messages->Errors[0].find(part), std::string::npos) << messages->Errors[0];
  };
  fails(MakeGrid({ { 0., 0., 0. } }, {}), { 0., 0., 0. }, "no cells");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, box);
  fails(blocks, { 0., 0., 0. }, "consists of blocks");
  messages->Errors.clear();
  filter->SetInputDataObject(box);
  filter->SetInputConnection(3, nullptr);
  filter->Update();
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("Places (input port 3) are missing"), std::string::npos);
}

/// A place that is not finite has no results; all others have those that they have without it. A
/// place very far away is one like any other.
TEST(SubdivisionLimitProbe, MissingPlaces)
{
  const Grid mesh = MakeModel(7);
  vtkNew<vtkSubdivisionLimitProbe> filter;
  filter->SetInputDataObject(mesh);
  filter->SetInputDataObject(3,
    place_tools::MakeTargets({ { 0.4, 0.3, 0.2 }, { std::nan(""), 0., 0. }, { 1e300, 0., 0. } }));
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_EQ(
    messages->CountWarnings("1 place has coordinates that are not finite; the first is place 1"),
    1);
  vtkPolyData* found = filter->GetOutput();
  ASSERT_EQ(found->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(std::isnan(found->GetPoint(i)[0]), i == 1);
    for (const char* name : { "Distance", "Random", "DerivativeU" })
    {
      EXPECT_EQ(std::isnan(found->GetPointData()->GetArray(name)->GetComponent(i, 0)), i == 1);
    }
  }
  EXPECT_EQ(found->GetPointData()->GetArray("CellId")->GetComponent(1, 0), -1.);
  EXPECT_NEAR(found->GetPointData()->GetArray("Distance")->GetComponent(2, 0) / 1e300, 1., 1e-12);
}

/// Where no cell is left, or there is no place, arrays have the length of the output.
TEST(SubdivisionLimitProbe, ArraysOfNothing)
{
  const auto targets = place_tools::MakeTargets({ { 0.4, 0.3, 0.2 }, { 1., 0., 0. } });
  vtkNew<vtkDoubleArray> values;
  values->SetName("OwnValues");
  values->SetNumberOfValues(2);
  values->FillValue(1.);
  targets->GetPointData()->AddArray(values);
  const Grid one = MakeModel(1);
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  ids->SetNumberOfValues(one->GetNumberOfPoints());
  ids->FillValue(1);
  one->GetPointData()->SetPedigreeIds(ids);
  const auto expectLengths = [](vtkPolyData* found)
  {
    for (int a = 0; a < found->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = found->GetPointData()->GetAbstractArray(a);
      EXPECT_EQ(array->GetNumberOfTuples(), found->GetNumberOfPoints()) << array->GetName();
    }
  };
  expectLengths(Probe(one, {}));
  for (const Grid& mesh : { MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, {}),
         MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_LINE, { 0, 0 } } }) })
  {
    vtkNew<vtkSubdivisionLimitProbe> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(mesh);
    filter->SetInputDataObject(3, targets);
    filter->Update();
    EXPECT_FALSE(messages->Errors.empty() && messages->Warnings.empty());
    expectLengths(filter->GetOutput());
  }
}
