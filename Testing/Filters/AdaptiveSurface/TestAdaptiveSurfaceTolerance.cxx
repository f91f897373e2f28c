// SPDX-License-Identifier: BSD-3-Clause
// How near the limit vtkAdaptiveSurfaceSubdivision is, and with how many triangles.

#include "AdaptiveFilterTools.h"
#include "RandomSurfaces.h"

#include "vtkMultiDimensionalSubdivision.h"
#include "vtkRedGreenRefinement.h"

using namespace adaptive_filter_tools;

TEST(AdaptiveSurface, TheGeometricErrorIsBelowTheTolerance)
{
  const PolyData input = MakeHill(10);
  const PolyData fine = RefineByShape(input, 5e-4);
  vtkIdType before = input->GetNumberOfCells();
  for (double tolerance : { 0.1, 0.03, 0.01 })
  {
    const PolyData output = RefineByShape(input, tolerance);
    const double error = GetLargestDistance(fine, output);
    EXPECT_LE(error, tolerance);
    EXPECT_GE(error, 0.2 * tolerance);
    EXPECT_GT(output->GetNumberOfCells(), before);
    before = output->GetNumberOfCells();
    // The plain around the hill stays as it is.
    auto* generations =
      vtkUnsignedCharArray::SafeDownCast(output->GetCellData()->GetArray("Generation"));
    ASSERT_NE(generations, nullptr);
    EXPECT_EQ(generations->GetValueRange()[0], 0);
    EXPECT_GT(generations->GetValueRange()[1], 1);
  }
  // Uniform steps to the same error take more.
  const PolyData uniform = RunPlainSqrtThree(input, 4);
  const double error = GetLargestDistance(fine, uniform);
  const PolyData output = RefineByShape(input, error);
  EXPECT_LE(GetLargestDistance(fine, output), error);
  EXPECT_LT(2 * output->GetNumberOfPolys(), uniform->GetNumberOfPolys());
}

namespace
{

/// The middles of the edges of all triangles, and their centres.
PolyData MakePlaces(vtkPolyData* mesh)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    Point x[3];
    Point centre{};
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(ids->GetId(i), x[i].data());
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Point& next = x[(i + 1) % 3];
      places->InsertNextPoint(
        0.5 * (x[i][0] + next[0]), 0.5 * (x[i][1] + next[1]), 0.5 * (x[i][2] + next[2]));
      for (std::size_t c = 0; c < 3; ++c)
      {
        centre[c] += x[i][c] / 3.;
      }
    }
    places->InsertNextPoint(centre.data());
  }
  auto points = PolyData::New();
  points->SetPoints(places);
  return points;
}

/// How far a mesh and its limit are from each other; `limit`: a fine mesh on it.
double MeasureError(vtkPolyData* mesh, vtkPolyData* limit)
{
  return std::max(GetLargestDistance(limit, mesh), GetLargestDistance(MakePlaces(mesh), limit));
}

/// The triangles of a grid.
PolyData MakeSurface(vtkUnstructuredGrid* grid)
{
  auto surface = PolyData::New();
  surface->SetPoints(grid->GetPoints());
  surface->SetPolys(grid->GetCells());
  return surface;
}

PolyData RefineLoop(vtkPolyData* input, double tolerance)
{
  vtkNew<vtkRedGreenRefinement> filter;
  filter->SetInputData(input);
  filter->SetPlacementToLimit();
  filter->RefineByAttributeErrorOff();
  filter->RefineByGeometricErrorOn();
  filter->SetGeometricTolerance(tolerance);
  filter->SetMaximumLevel(8);
  filter->Update();
  return MakeSurface(filter->GetOutput());
}

PolyData MakeLoopLimit(vtkPolyData* input, int levels)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetInputData(input);
  filter->ProjectToLimitOn();
  filter->SetNumberOfLevels(levels);
  filter->Update();
  return MakeSurface(vtkUnstructuredGrid::SafeDownCast(filter->GetOutput()));
}

}

/// The estimate is no bound, but on rough meshes it does not fail; and adaptive Loop subdivision,
/// for which the same is true, takes about as many triangles.
TEST(AdaptiveSurface, RandomMeshesAreWithinTheTolerance)
{
  constexpr double tolerance = 0.01;
  vtkIdType triangles = 0;
  vtkIdType ofLoop = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const PolyData input = MakeInput(RandomSurface(seed).Get());
    const double allowed = tolerance * input->GetLength();
    const PolyData output = Refine(input,
      [](Filter* filter)
      {
        filter->RefineByGeometricErrorOn();
        filter->SetGeometricTolerance(tolerance);
        filter->SetMaximumLevel(12);
      });
    EXPECT_LE(MeasureError(output, RunPlainSqrtThree(input, 6)), allowed);
    const PolyData loop = RefineLoop(input, tolerance);
    EXPECT_LE(MeasureError(loop, MakeLoopLimit(input, 4)), allowed);
    triangles += output->GetNumberOfPolys();
    ofLoop += loop->GetNumberOfPolys();
  }
  const double ratio = static_cast<double>(ofLoop) / static_cast<double>(triangles);
  EXPECT_GT(ratio, 0.9);
  EXPECT_LT(ratio, 1.1);
}

/// Every edge has an inflection in its middle, where its limit is on it.
TEST(AdaptiveSurface, LinesThatTheLimitCrossesInTheMiddleAreSeen)
{
  Model zigzag;
  for (vtkIdType i = 0; i < 12; ++i)
  {
    zigzag.Points.push_back({ 1. * static_cast<double>(i), i % 2 ? 1. : -1., 0. });
    if (i > 0)
    {
      zigzag.Lines.push_back({ i - 1, i });
    }
  }
  const PolyData input = MakeInput(zigzag);
  EXPECT_LT(RefineByShape(input, 0.1)->GetNumberOfLines(), 2 * input->GetNumberOfLines());
  EXPECT_GE(RefineByShape(input, 0.003)->GetNumberOfLines(), 9 * input->GetNumberOfLines());
}
