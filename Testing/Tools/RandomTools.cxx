// SPDX-License-Identifier: BSD-3-Clause
#include "RandomTools.h"

#include "vtkPointSet.h"
#include "vtkStaticPointLocator.h"

namespace random_tools
{

void MapIds(vtkCellArray* cells, const Ids& map)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; cells && c < cells->GetNumberOfCells(); ++c)
  {
    cells->GetCellAtId(c, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ids->SetId(i, map[ids->GetId(i)]);
    }
    cells->ReplaceCellAtId(c, ids);
  }
}

Data Renumber(vtkPointSet* mesh, const Ids& map)
{
  const Data copy = Copy(mesh);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalIds");
  ids->SetNumberOfTuples(mesh->GetNumberOfPoints());
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(map[i], mesh->GetPoint(i));
    ids->SetValue(map[i], i);
  }
  copy->SetPoints(points);
  copy->GetPointData()->SetGlobalIds(ids);
  if (auto* surface = vtkPolyData::SafeDownCast(copy))
  {
    for (vtkCellArray* cells : { surface->GetVerts(), surface->GetLines(), surface->GetPolys() })
    {
      MapIds(cells, map);
    }
  }
  else
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(copy);
    MapIds(grid->GetCells(), map);
  }
  return copy;
}

void ExpectNear(const Point& a, const Point& b, double tolerance, const std::string& what)
{
  for (int c = 0; c < 3; ++c)
  {
    ASSERT_NEAR(a[c], b[c], tolerance) << what;
  }
}

void ExpectSamePlaces(vtkPointSet* a, vtkPointSet* b, double tolerance)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(a);
  locator->BuildLocator();
  for (vtkIdType i = 0; i < b->GetNumberOfPoints(); ++i)
  {
    const Point p = At(b, i);
    ExpectNear(
      At(a, locator->FindClosestPoint(p.data())), p, tolerance, "point " + std::to_string(i));
  }
}

void ExpectSameCorners(vtkPointSet* a, vtkPointSet* b, double tolerance, bool withSolids)
{
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  vtkNew<vtkIdList> first;
  vtkNew<vtkIdList> second;
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    a->GetCellPoints(cell, first);
    b->GetCellPoints(cell, second);
    ASSERT_EQ(first->GetNumberOfIds(), second->GetNumberOfIds());
    if (!withSolids && a->GetCellType(cell) == VTK_TETRA)
    {
      continue;
    }
    for (vtkIdType i = 0; i < first->GetNumberOfIds(); ++i)
    {
      ExpectNear(At(a, first->GetId(i)), At(b, second->GetId(i)), tolerance,
        "cell " + std::to_string(cell) + " corner " + std::to_string(i));
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
}

Ids Shuffle(vtkIdType size, Chance& chance)
{
  Ids map(size);
  std::iota(map.begin(), map.end(), 0);
  std::shuffle(map.begin(), map.end(), chance);
  return map;
}

double GetLargestDifference(vtkPointSet* a, vtkPointSet* b)
{
  double largest = 0.;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    const Point p = At(a, i);
    const Point q = At(b, i);
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::abs(p[c] - q[c]));
    }
  }
  return largest;
}

namespace
{

/// Whether moving points by at most `distance` changes the output by more than `difference`.
bool Jumps(vtkPointSet* mesh, vtkPointSet* output, int levels, const Run& run, double distance,
  double difference, Chance& chance)
{
  auto move = [&](const Point& p)
  {
    Point q;
    for (int c = 0; c < 3; ++c)
    {
      q[c] = p[c] + 2. * distance * (DrawNumber(chance) - 0.5);
    }
    return q;
  };
  for (int trial = 0; trial < 32; ++trial)
  {
    const Data other = run(WithPoints(mesh, VTK_DOUBLE, move), levels);
    if (other->GetNumberOfPoints() != output->GetNumberOfPoints() ||
      GetLargestDifference(other, output) > difference)
    {
      return true;
    }
  }
  return false;
}

}

bool IsUndecided(vtkPointSet* mesh, int levels, const Run& run, Chance& chance)
{
  const Data output = run(mesh, levels);
  const double size = GetSize(mesh);
  // The second finds small jumps, such as those of the diagonals of an octahedron.
  return Jumps(mesh, output, levels, run, 3e-5 * size, 3e-3 * size, chance) ||
    Jumps(mesh, output, levels, run, 1e-6 * size, 2e-5 * size, chance);
}

void ExpectSameInSinglePrecision(
  vtkPointSet* mesh, int levels, const Run& run, vtkPointSet* output, Chance& chance)
{
  const Data single = run(InType(mesh, VTK_FLOAT), levels);
  const bool isSame = single->GetNumberOfPoints() == output->GetNumberOfPoints() &&
    GetLargestDifference(single, output) <= 1e-5 * GetSize(mesh);
  EXPECT_TRUE(isSame || IsUndecided(mesh, levels, run, chance));
}

void ExpectTheSame(
  vtkPointSet* mesh, int levels, const Run& run, Chance& chance, bool hasOctahedra, bool keepsOrder)
{
  const Data output = run(mesh, levels);
  const double exact = 1e-11 * GetSize(mesh);
  {
    SCOPED_TRACE("mirrored");
    ExpectSamePoints(output, run(Mirror(mesh), levels), output->GetNumberOfPoints(), exact,
      [](const Point& p) { return Point{ -p[0], p[1], p[2] }; });
  }
  {
    SCOPED_TRACE("other numbers");
    const Data other = run(Renumber(mesh, Shuffle(mesh->GetNumberOfPoints(), chance)), levels);
    if (keepsOrder)
    {
      ExpectSameCorners(output, other, exact, !hasOctahedra);
    }
    ExpectSamePlaces(output, other, exact);
  }
  SCOPED_TRACE("single precision");
  ExpectSameInSinglePrecision(mesh, levels, run, output, chance);
}

}
