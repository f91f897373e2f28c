// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestInputNormals.cxx
 * Normals of the input do not hold for smoothed points: no filter takes them for values, or leaves
 * them active.
 */
#include "FeatureTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkFloatArray.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkPolyData.h"
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
    ExpectOwnNormals(RunOn(solids, sphere), generates);
    for (int scheme = 0; scheme < 7; ++scheme)
    {
      SCOPED_TRACE(scheme);
      vtkNew<vtkSurfaceSubdivision> surfaces;
      surfaces->SetScheme(scheme);
      const bool hasLimits = scheme != vtkSurfaceSubdivision::FOUR_EIGHT &&
        scheme != vtkSurfaceSubdivision::DOO_SABIN && scheme != vtkSurfaceSubdivision::MIDEDGE;
      surfaces->SetGenerateLimitNormals(generates && hasLimits);
      ExpectOwnNormals(RunOn(surfaces, sphere), generates && hasLimits);
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
