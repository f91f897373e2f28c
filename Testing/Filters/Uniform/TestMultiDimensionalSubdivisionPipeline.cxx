// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMultiDimensionalSubdivisionPipeline.cxx
 * Threads, vtkPolyData and composite input, and agreement with VTK's own Loop filter.
 */
#include "BackEnds.h"
#include "MultiDimensionalSubdivisionTools.h"
#include "Turns.h"

#include "vtkCompositeDataPipeline.h"
#include "vtkLoopSubdivisionFilter.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

/// Switches the back end, and back at the end.
class BackEnd
{
public:
  explicit BackEnd(const char* name, int threads)
    : Before(vtkSMPTools::GetBackend())
    , Good(vtkSMPTools::SetBackend(name))
  {
    if (this->Good)
    {
      vtkSMPTools::Initialize(threads);
    }
  }
  ~BackEnd()
  {
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(this->Before.c_str());
  }
  BackEnd(const BackEnd&) = delete;
  void operator=(const BackEnd&) = delete;

  std::string Before;
  bool Good;
};

vtkSmartPointer<vtkPolyData> MakePoly(vtkPoints* points, const std::vector<Ids>& verts,
  const std::vector<Ids>& lines, const std::vector<Ids>& polys, const std::vector<Ids>& strips)
{
  auto poly = vtkSmartPointer<vtkPolyData>::New();
  poly->SetPoints(points);
  const std::vector<Ids>* lists[4] = { &verts, &lines, &polys, &strips };
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkCellArray> cells;
    for (const Ids& cell : *lists[i])
    {
      cells->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
    }
    i == 0     ? poly->SetVerts(cells)
      : i == 1 ? poly->SetLines(cells)
      : i == 2 ? poly->SetPolys(cells)
               : poly->SetStrips(cells);
  }
  return poly;
}

/// A torus of triangles in which every vertex has six neighbours.
Grid MakeTorus(int m, int n, int type)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  std::mt19937 random(4);
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < m; ++i)
    {
      const double u = 2 * 3.14159265358979 * i / m;
      const double v = 2 * 3.14159265358979 * j / n;
      const double r = 3 + std::cos(v) + 0.2 * (random() / 4294967296.);
      points.push_back({ r * std::cos(u), r * std::sin(u), std::sin(v) });
      const auto at = [&](int a, int b) { return vtkIdType((i + a) % m + m * ((j + b) % n)); };
      cells.push_back({ VTK_TRIANGLE, { at(0, 0), at(1, 0), at(1, 1) } });
      cells.push_back({ VTK_TRIANGLE, { at(0, 0), at(1, 1), at(0, 1) } });
    }
  }
  return MakeGrid(points, cells, type);
}

}

TEST(MultiDimensionalSubdivisionThreads, SameBitsWithAnyBackEndAndNumberOfThreads)
{
  // More than a hundred thousand input cells, of all dimensions, with arrays of all kinds.
  const Grid grid = MakeMixedBox(27);
  AddGlobalIds(grid, 9);
  AddArrays(grid);
  Options options;
  options.OriginalIds = options.Classification = true;
  options.Levels = 0;
  Grid simplices;
  Grid expected;
  {
    const BackEnd serial("Sequential", 1);
    ASSERT_TRUE(serial.Good);
    simplices = Subdivide(grid, options);
    options.Levels = 1;
    expected = Subdivide(grid, options);
  }
  ASSERT_GT(simplices->GetNumberOfCells(), 100000);
  int others = 0;
  for (const char* name : BackEnds)
  {
    for (int threads = 1; threads <= 4; ++threads)
    {
      const BackEnd backEnd(name, threads);
      if (!backEnd.Good)
      {
        break;
      }
      others += std::string(name) == "Sequential" ? 0 : 1;
      if (!turns::IsInTurn(static_cast<std::size_t>(others)))
      {
        continue;
      }
      EXPECT_EQ(Compare(Subdivide(grid, options), expected), "") << name << threads;
      if (threads == 3)
      {
        EXPECT_EQ(Compare(Subdivide(simplices, options), expected), "") << name;
      }
      if (std::string(name) == "Sequential")
      {
        break; // more threads are one
      }
    }
  }
  EXPECT_GE(others, 4); // STDThread is everywhere
}

TEST(MultiDimensionalSubdivisionPolyData, EqualsTheSameUnstructuredGrid)
{
  std::vector<Point> coordinates;
  std::mt19937 random(2);
  for (int i = 0; i < 14; ++i)
  {
    auto shift = [&random] { return 0.1 * (random() / 4294967296.); };
    coordinates.push_back({ i % 4 + shift(), i / 4 + shift(), shift() });
  }
  const std::vector<Ids> verts = { { 3 }, { 0, 12 } };
  const std::vector<Ids> lines = { { 0, 12 }, { 12, 13, 1 } };
  const std::vector<Ids> polys = { { 0, 1, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 },
    { 4, 5, 6, 10, 9, 8 } };
  const std::vector<Ids> strips = { { 2, 3, 6, 7, 11 } };
  std::vector<Cell> cells;
  for (const Ids& ids : verts)
  {
    cells.push_back({ VTK_POLY_VERTEX, ids });
  }
  for (const Ids& ids : lines)
  {
    cells.push_back({ VTK_POLY_LINE, ids });
  }
  for (const Ids& ids : polys)
  {
    cells.push_back({ VTK_POLYGON, ids });
  }
  for (const Ids& ids : strips)
  {
    cells.push_back({ VTK_TRIANGLE_STRIP, ids });
  }
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (bool globalIds : { false, true })
    {
      const Grid grid = MakeGrid(coordinates, cells, type);
      AddArrays(grid);
      if (globalIds)
      {
        AddGlobalIds(grid, 6);
      }
      const auto poly = MakePoly(grid->GetPoints(), verts, lines, polys, strips);
      poly->GetPointData()->ShallowCopy(grid->GetPointData());
      poly->GetCellData()->ShallowCopy(grid->GetCellData());
      poly->GetFieldData()->ShallowCopy(grid->GetFieldData());
      for (int levels : { 0, 1, 2 })
      {
        Options options;
        options.Levels = levels;
        options.OriginalIds = options.Classification = true;
        const Grid result = Subdivide(poly, options);
        EXPECT_GT(result->GetNumberOfCells(), 0);
        EXPECT_EQ(Compare(result, Subdivide(grid, options)), "");
      }
    }
  }
}

TEST(MultiDimensionalSubdivisionComposite, EveryBlockByItself)
{
  const Grid first = MakeMixedBox(1);
  AddArrays(first);
  const Grid second = MakeTorus(5, 6, VTK_FLOAT);
  const auto third = MakePoly(first->GetPoints(), {}, { { 0, 1, 3 } }, {}, {});
  const Grid ours = Subdivide(first, 1);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, second);
  inner->SetBlock(1, ours);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, inner);
  blocks->SetBlock(3, third);
  vtkNew<Messages> messages;
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  vtkNew<vtkCompositeDataPipeline> executive;
  filter->SetExecutive(executive);
  filter->JoinBlocksOff();
  messages->Watch(filter);
  filter->SetInputData(blocks);
  filter->SetNumberOfLevels(2);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_TRUE(messages->Warnings.empty());
  auto* result = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(result);
  ASSERT_EQ(result->GetNumberOfBlocks(), 4u);
  EXPECT_FALSE(result->GetBlock(1));
  auto* nested = vtkMultiBlockDataSet::SafeDownCast(result->GetBlock(2));
  ASSERT_TRUE(nested);
  const std::pair<vtkDataObject*, vtkDataObject*> pairs[] = { { first, result->GetBlock(0) },
    { second, nested->GetBlock(0) }, { ours, nested->GetBlock(1) },
    { third, result->GetBlock(3) } };
  for (const auto& [in, out] : pairs)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(out);
    ASSERT_TRUE(grid);
    EXPECT_EQ(Compare(grid, Subdivide(in, 2)), "");
  }
}

TEST(MultiDimensionalSubdivisionPipeline, ExecutesAgainOnlyWhenSomethingChanged)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetInputData(MakeTorus(4, 4, VTK_DOUBLE));
  filter->Update();
  const vtkMTimeType time = filter->GetOutput()->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetMTime(), time);
  filter->SetNumberOfLevels(1); // as it is
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetMTime(), time);
  filter->GenerateOriginalIdsOn();
  filter->Update();
  EXPECT_NE(filter->GetOutput()->GetMTime(), time);
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("vtkOriginalPointIds"));
  filter->SetNumberOfLevels(99);
  EXPECT_EQ(filter->GetNumberOfLevels(), 20);
  filter->SetNumberOfLevels(-1);
  EXPECT_EQ(filter->GetNumberOfLevels(), 0);
}

// ---------------------------------------------------------------- VTK's Loop filter

TEST(MultiDimensionalSubdivisionLoop, AgreesWithVtkOnRegularMeshes)
{
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const Grid torus = MakeTorus(7, 9, type);
    torus->GetPointData()->AddArray(
      MakeArray<vtkDoubleArray>("value", 1, torus->GetNumberOfPoints(), -1, 1, 3));
    std::vector<Ids> triangles = GetCells(torus);
    const auto poly = MakePoly(torus->GetPoints(), {}, {}, triangles, {});
    poly->GetPointData()->ShallowCopy(torus->GetPointData());
    for (int levels : { 1, 2, 3 })
    {
      vtkNew<vtkLoopSubdivisionFilter> loop;
      loop->SetInputData(poly);
      loop->SetNumberOfSubdivisions(levels);
      loop->Update();
      vtkPolyData* theirs = loop->GetOutput();
      const Grid ours = Subdivide(torus, levels);
      ASSERT_EQ(ours->GetNumberOfPoints(), theirs->GetNumberOfPoints());
      ASSERT_EQ(ours->GetNumberOfCells(), theirs->GetNumberOfCells());
      // VTK's points are floats in any case.
      const bool exact = theirs->GetPoints()->GetDataType() == VTK_DOUBLE && type == VTK_DOUBLE;
      const double tolerance = exact ? 1e-12 : 3e-6;
      // Same numbering of old points, another one of new points: match the nearest in x.
      std::multimap<double, vtkIdType> byX;
      for (vtkIdType i = 0; i < theirs->GetNumberOfPoints(); ++i)
      {
        byX.emplace(GetPoint(theirs, i)[0], i);
      }
      vtkDataArray* a = ours->GetPointData()->GetArray("value");
      vtkDataArray* b = theirs->GetPointData()->GetArray("value");
      ASSERT_TRUE(a && b);
      for (vtkIdType i = 0; i < ours->GetNumberOfPoints(); ++i)
      {
        const Point p = GetPoint(ours, i);
        double best = 1e9;
        vtkIdType match = -1;
        const auto end = byX.upper_bound(p[0] + tolerance);
        for (auto at = byX.lower_bound(p[0] - tolerance); at != end; ++at)
        {
          const Point q = GetPoint(theirs, at->second);
          const double distance = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
          match = distance < best ? at->second : match;
          best = std::min(best, distance);
        }
        ASSERT_LT(best, tolerance) << "point " << i;
        ASSERT_NEAR(a->GetTuple1(i), b->GetTuple1(match), 1e-12);
        ASSERT_TRUE(i >= torus->GetNumberOfPoints() || match == i);
      }
    }
  }
}
