// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinement.cxx
 * vtkRedGreenRefinement: conformity in any dimension, filters in a row, threads.
 */
#include "RedGreenRefinementTools.h"

#include "vtkSubdivisionModelSource.h"

using namespace red_green_refinement_tools;

namespace
{

/// The longest edge cubed over the volume: 8.5 of a regular tetrahedron.
double GetShape(const std::array<Point, 4>& p)
{
  double longest = 0.;
  Point e[4] = {};
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      longest =
        std::max(longest, std::hypot(p[i][0] - p[k][0], p[i][1] - p[k][1], p[i][2] - p[k][2]));
    }
    for (int c = 0; c < 3; ++c)
    {
      e[i][c] = p[i][c] - p[0][c];
    }
  }
  const double volume = e[1][0] * (e[2][1] * e[3][2] - e[2][2] * e[3][1]) -
    e[1][1] * (e[2][0] * e[3][2] - e[2][2] * e[3][0]) +
    e[1][2] * (e[2][0] * e[3][1] - e[2][1] * e[3][0]);
  return longest * longest * longest / std::abs(volume / 6.);
}

std::array<Point, 4> GetTet(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const Ids ids = GetCell(grid, cell);
  return { GetPoint(grid, ids[0]), GetPoint(grid, ids[1]), GetPoint(grid, ids[2]),
    GetPoint(grid, ids[3]) };
}

double GetWorstShape(vtkUnstructuredGrid* grid)
{
  double worst = 0.;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    worst = std::max(worst, GetShape(GetTet(grid, i)));
  }
  return worst;
}

/// The worst part that a tetrahedron has when one edge, two opposite ones or a face are split.
double GetWorstGreenShape(const std::array<Point, 4>& tet)
{
  auto middle = [&](int a, int b)
  {
    return Point{ (tet[a][0] + tet[b][0]) / 2., (tet[a][1] + tet[b][1]) / 2.,
      (tet[a][2] + tet[b][2]) / 2. };
  };
  double worst = 0.;
  for (int a = 0; a < 4; ++a)
  {
    for (int b = 0; b < 4; ++b)
    {
      for (int c = 0; c < 4; ++c)
      {
        const int d = 6 - a - b - c;
        if (a == b || a == c || b == c)
        {
          continue;
        }
        auto half = tet;
        half[a] = middle(a, b);
        auto quarter = half;
        quarter[c] = middle(c, d);
        auto corner = half;
        corner[c] = middle(b, c);
        auto inner = corner;
        inner[b] = middle(a, c);
        worst =
          std::max({ worst, GetShape(half), GetShape(quarter), GetShape(corner), GetShape(inner) });
      }
    }
  }
  return worst;
}

class RedGreenZoo : public testing::TestWithParam<std::string>
{
};

TEST_P(RedGreenZoo, RandomMarksStayConforming)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  AddWeights(input);
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    AddWantedLevels(input, 3, seed);
    const Grid output = RefineToWanted(input);
    EXPECT_EQ(CheckConformity(input, output), "") << "seed " << seed;
    EXPECT_GE(output->GetNumberOfCells(), input->GetNumberOfCells());
  }
}

TEST_P(RedGreenZoo, SixFiltersInARowStayConforming)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  AddWeights(input);
  Grid current = input;
  for (unsigned round = 0; round < 6; ++round)
  {
    const Grid next =
      RefineByChance(current, round, std::max<vtkIdType>(8, current->GetNumberOfCells() / 4));
    ASSERT_EQ(CheckConformity(input, next), "") << "round " << round;
    ASSERT_GE(next->GetNumberOfCells(), current->GetNumberOfCells());
    current = next;
  }
}

TEST_P(RedGreenZoo, EverythingMarkedIsUniformRefinement)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  const Grid output = Refine(input,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.);
      filter->SetMaximumLevel(2);
    });
  const Grid uniform = Subdivide(input, 2);
  ASSERT_EQ(output->GetNumberOfCells(), uniform->GetNumberOfCells());
  EXPECT_EQ(output->GetNumberOfPoints(), uniform->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const bool isVertex = output->GetCellType(i) == VTK_VERTEX;
    EXPECT_EQ(output->GetCellType(i), uniform->GetCellType(i));
    EXPECT_EQ(
      output->GetCellData()->GetArray("RefinementLevel")->GetComponent(i, 0), isVertex ? 0 : 2);
    EXPECT_EQ(
      output->GetCellData()->GetArray("RefinementKind")->GetComponent(i, 0), isVertex ? 0 : 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, RedGreenZoo, testing::ValuesIn(coretest::GetNamesOfZoo(60)),
  [](const auto& instance) { return instance.param; });

// ------------------------------------------------------------------------------------------------
// Filters in a row

Configure NearCorner(double radius, int level)
{
  return [radius, level](Filter* filter)
  {
    filter->RefineByArrayRangeOn();
    filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "FromCorner");
    filter->SetArrayRange(0., radius);
    filter->SetMaximumLevel(level);
  };
}

Grid MakeBoxWithDistance(int n)
{
  const Grid box = MakeBox(n);
  vtkNew<vtkDoubleArray> distance;
  distance->SetName("FromCorner");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(box, i);
    distance->InsertNextValue(std::hypot(p[0], p[1], p[2]));
  }
  box->GetPointData()->AddArray(distance);
  return box;
}

TEST(RedGreenChaining, GreenCellsAreUndone)
{
  const Grid box = MakeBoxWithDistance(2);
  const Grid once = Refine(box, NearCorner(0.1, 1));
  EXPECT_GT(CountKind(once, 2) + CountKind(once, 3) + CountKind(once, 4), 0);
  // Everything: as if the first filter had not been there.
  auto everything = [](Filter* filter)
  {
    filter->RefineByEdgeLengthOn();
    filter->SetMaximumEdgeLength(0.9);
  };
  const Grid all = Refine(once, everything);
  const Grid direct = Refine(box, everything);
  EXPECT_EQ(all->GetNumberOfCells(), direct->GetNumberOfCells());
  EXPECT_EQ(all->GetNumberOfPoints(), direct->GetNumberOfPoints());
  EXPECT_EQ(CountKind(all, 1), all->GetNumberOfCells());
  EXPECT_DOUBLE_EQ(GetWorstShape(all), GetWorstShape(direct));
}

TEST(RedGreenChaining, NothingWantedChangesNothing)
{
  const Grid once = Refine(MakeBoxWithDistance(2), NearCorner(0.3, 3));
  const Grid twice = Refine(once, NearCorner(-1., 3));
  EXPECT_EQ(Compare(once, twice), "");
}

/// What the cells are, whatever the numbers of their points.
std::vector<std::array<Point, 4>> GetTets(vtkUnstructuredGrid* grid)
{
  std::vector<std::array<Point, 4>> tets;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    tets.push_back(GetTet(grid, i));
  }
  return tets;
}

TEST(RedGreenChaining, StepsInARowAreStepsInOneFilter)
{
  const Grid box = MakeBoxWithDistance(3);
  Grid current = box;
  for (int step = 0; step < 3; ++step)
  {
    current = Refine(current, NearCorner(0.4, 1));
  }
  const Grid direct = Refine(box, NearCorner(0.4, 3));
  EXPECT_EQ(current->GetNumberOfPoints(), direct->GetNumberOfPoints());
  EXPECT_EQ(GetTets(current), GetTets(direct));
  EXPECT_EQ(CompareArrays(current->GetCellData(), direct->GetCellData(), "cell data"), "");
}

/// Points of the second filter lie between the corners of a leaf and the middles that the first has
/// made: up to seven points of its input.
TEST(RedGreenChaining, ThreeLevelsWhereGreenCellsWere)
{
  for (const char* name : { "KuhnCube", "FlushFin", "EverythingAtOnce" })
  {
    const Grid input = MakeGrid(coretest::FindInZoo(name));
    AddWeights(input);
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
      AddWantedLevels(input, 1, seed);
      const Grid second = Refine(RefineToWanted(input, 1),
        [](Filter* filter)
        {
          filter->RefineByEdgeLengthOn();
          filter->SetMaximumEdgeLength(0.);
        });
      EXPECT_EQ(CheckConformity(input, second), "") << name << " " << seed;
    }
  }
}

TEST(RedGreenChaining, ShapesStayGoodOverManyFilters)
{
  const Grid box = MakeBoxWithDistance(1);
  const Grid red = Refine(box,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.);
    });
  double worst = GetWorstShape(red);
  for (vtkIdType i = 0; i < red->GetNumberOfCells(); ++i)
  {
    worst = std::max(worst, GetWorstGreenShape(GetTet(red, i)));
  }
  Grid current = box;
  for (int step = 0; step < 6; ++step)
  {
    current = Refine(current, NearCorner(0.05, 1));
  }
  EXPECT_GT(current->GetNumberOfCells(), 100);
  EXPECT_LE(GetWorstShape(current), 1.0000001 * worst);
}

TEST(RedGreenChaining, AChangedMeshIsPlainInput)
{
  const Grid once = Refine(MakeBoxWithDistance(2), NearCorner(0.1, 1));
  // One cell turned: the stamp still fits where it does not look, the cells do not.
  auto changed = Grid::New();
  changed->DeepCopy(once);
  vtkNew<vtkCellArray> cells;
  std::vector<Ids> ids = GetCells(once);
  std::swap(ids.back()[0], ids.back()[1]);
  for (const Ids& cell : ids)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  changed->SetCells(VTK_TETRA, cells);
  vtkNew<Messages> messages;
  const Grid output = Refine(changed, NearCorner(-1., 1), messages);
  EXPECT_EQ(CountKind(output, 0), output->GetNumberOfCells());
  EXPECT_EQ(output->GetNumberOfCells(), once->GetNumberOfCells());
  EXPECT_EQ(messages->CountWarnings("is replaced"), 3); // its own arrays are somebody else's now
}

TEST(RedGreenChaining, ValuesOfGreenCellsAreNotLost)
{
  const Grid once = Refine(MakeBoxWithDistance(2), NearCorner(0.1, 1));
  auto changed = Grid::New();
  changed->ShallowCopy(once);
  changed->GetCellData()->AddArray(
    MakeArray<vtkDoubleArray>("Quality", 1, once->GetNumberOfCells(), 0., 1., 4));
  vtkNew<Messages> messages;
  const Grid output = Refine(changed, NearCorner(-1., 1), messages);
  EXPECT_EQ(messages->CountWarnings("\"Quality\" has different values in green cells"), 1);
  EXPECT_EQ(CompareValues(output->GetCellData()->GetArray("Quality"),
              changed->GetCellData()->GetArray("Quality")),
    "");
}

TEST(RedGreenChaining, OriginalIdsAreCarriedOn)
{
  const Grid box = MakeBoxWithDistance(2);
  const Grid once = Refine(box, NearCorner(0.1, 1));
  const Grid twice = Refine(once, NearCorner(0.1, 1));
  vtkDataArray* origins = twice->GetCellData()->GetArray("vtkOriginalCellIds");
  EXPECT_EQ(origins->GetRange(0)[0], 0.);
  EXPECT_EQ(origins->GetRange(0)[1], box->GetNumberOfCells() - 1.);
}

// ------------------------------------------------------------------------------------------------

TEST(RedGreenThreads, SameBits)
{
  vtkNew<vtkSubdivisionModelSource> models;
  for (int model = 0; model < 7; ++model)
  {
    models->SetModel(model);
    models->Update();
    auto run = [&]
    {
      return Refine(models->GetOutput(),
        [model](Filter* filter)
        {
          filter->RefineByAttributeErrorOn();
          filter->SetAttributeTolerance(0.05);
          filter->SetMaximumLevel(model % 2 ? 3 : 4);
          filter->SetPlacement(model % 2);
          filter->SetRefineByGeometricError(model % 2 > 0);
          filter->SetGeometricTolerance(0.005);
        });
    };
    const char* before = vtkSMPTools::GetBackend();
    vtkSMPTools::SetBackend("Sequential");
    const Grid serial = run();
    vtkSMPTools::SetBackend("STDThread");
    for (int threads : { 2, 3, 4 })
    {
      vtkSMPTools::Initialize(threads);
      EXPECT_EQ(Compare(serial, run()), "") << model << " with " << threads << " threads";
    }
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(before);
    EXPECT_GT(serial->GetNumberOfCells(), models->GetOutput()->GetNumberOfCells());
  }
}

}
