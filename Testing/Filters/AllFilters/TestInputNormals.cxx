// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestInputNormals.cxx
 * Normals of the input do not hold where points move: no filter takes them for values, or leaves
 * them active there.
 */
#include "FeatureTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSphereSource.h"
#include "vtkSurfaceSubdivision.h"

using namespace feature_tools;

namespace
{

/// A sphere with normals at points and at cells, and a value that stays.
vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkSphereSource> source;
  source->Update();
  const vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  vtkNew<vtkFloatArray> ofCells;
  ofCells->SetName("CellNormals");
  ofCells->SetNumberOfComponents(3);
  ofCells->SetNumberOfTuples(sphere->GetNumberOfCells());
  ofCells->Fill(1.);
  sphere->GetCellData()->SetNormals(ofCells);
  return sphere;
}

vtkPointSet* RunOn(vtkSubdivisionAlgorithm* filter, vtkPolyData* input)
{
  filter->SetInputData(input);
  filter->Update();
  return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
}

/// Whether the normals are those of the filter, or are not there.
void ExpectOwnNormals(vtkPointSet* output, bool generates)
{
  ASSERT_GT(output->GetNumberOfCells(), 96);
  EXPECT_FALSE(output->GetPointData()->HasArray("Normals"));
  EXPECT_FALSE(output->GetCellData()->HasArray("CellNormals"));
  EXPECT_EQ(output->GetCellData()->GetNormals(), nullptr);
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  ASSERT_EQ(normals != nullptr, generates);
  EXPECT_TRUE(!normals || std::string(normals->GetName()) == "LimitNormals");
}

}

TEST(InputNormals, AreReplacedOrLeftOut)
{
  const auto sphere = MakeSphere();
  for (const bool generates : { false, true })
  {
    vtkNew<vtkMultiDimensionalSubdivision> solids;
    solids->SetGenerateLimitNormals(generates);
    solids->SmoothShadingOff();
    ExpectOwnNormals(RunOn(solids, sphere), generates);
    for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::SQRT_THREE;
      ++scheme)
    {
      SCOPED_TRACE(scheme);
      vtkNew<vtkSurfaceSubdivision> surfaces;
      surfaces->SetScheme(scheme);
      surfaces->SetGenerateLimitNormals(generates);
      surfaces->SmoothShadingOff();
      ExpectOwnNormals(RunOn(surfaces, sphere), generates);
    }
    vtkNew<vtkAdaptiveSurfaceSubdivision> adaptive;
    adaptive->SetGenerateLimitNormals(generates);
    adaptive->SetGeometricTolerance(1e-4);
    ExpectOwnNormals(RunOn(adaptive, sphere), generates);
  }
}

TEST(InputNormals, OfAnEarlierFilterAreLeftOut)
{
  const auto sphere = MakeSphere();
  vtkNew<vtkSurfaceSubdivision> first;
  first->SetGenerateLimitNormals(true);
  RunOn(first, sphere);
  vtkNew<vtkSurfaceSubdivision> second;
  second->SmoothShadingOff();
  vtkPointSet* output = RunOn(second, first->GetOutput());
  EXPECT_FALSE(output->GetPointData()->HasArray("LimitNormals"));
  EXPECT_EQ(output->GetPointData()->GetNormals(), nullptr);
}

TEST(InputNormals, StayWhereNothingMoves)
{
  const auto sphere = MakeSphere();
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetNumberOfLevels(0);
  vtkPointSet* output = RunOn(filter, sphere);
  ASSERT_TRUE(output->GetPointData()->GetNormals());
  EXPECT_STREQ(output->GetPointData()->GetNormals()->GetName(), "Normals");
  EXPECT_TRUE(output->GetCellData()->GetNormals());
}

TEST(InputNormals, AreLeftOutByRedGreenOnTheLimitAlone)
{
  const auto sphere = MakeSphere();
  vtkNew<vtkRedGreenRefinement> filter;
  filter->SetRefineByEdgeLength(true);
  filter->SetMaximumEdgeLength(0.2);
  filter->SetPlacementToLimit();
  ExpectOwnNormals(RunOn(filter, sphere), false);
  filter->SetPlacementToLinear();
  vtkPointSet* output = RunOn(filter, sphere);
  EXPECT_EQ(output->GetPointData()->GetNormals(), nullptr);
  vtkDataArray* normals = output->GetCellData()->GetNormals();
  ASSERT_TRUE(normals);
  EXPECT_STREQ(normals->GetName(), "CellNormals");
  EXPECT_EQ(normals->GetNumberOfTuples(), output->GetNumberOfCells());
}

TEST(InputNormals, StayAtCellsWhoseChildrenLieInThem)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToLinear();
  vtkPointSet* output = RunOn(filter, MakeSphere());
  EXPECT_EQ(output->GetPointData()->GetNormals(), nullptr);
  EXPECT_TRUE(output->GetCellData()->GetNormals());
}

TEST(InputNormals, AreLeftOutWherePointsGoToTheLimit)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetNumberOfLevels(0);
  filter->SetProjectToLimit(true);
  vtkPointSet* output = RunOn(filter, MakeSphere());
  EXPECT_EQ(output->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(output->GetCellData()->GetNormals(), nullptr);
}

/// Triangles near a line that marks them are cut into children of other cells than their parents.
TEST(InputNormals, OfCutCellsAreLeftOut)
{
  const Grid quads = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 1, 1, 1 }, { 2, 1, 0 } },
    { { VTK_QUAD, { 0, 1, 4, 3 } }, { VTK_TRIANGLE, { 1, 2, 4 } }, { VTK_TRIANGLE, { 2, 5, 4 } } });
  vtkNew<vtkFloatArray> normals;
  normals->SetName("CellNormals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(quads->GetNumberOfCells());
  normals->Fill(1.);
  quads->GetCellData()->SetNormals(normals);
  EXPECT_EQ(Subdivide(quads, 1)->GetCellData()->GetNormals(), nullptr);
}
