// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceJoints.cxx
 * Where parts of a surface meet, Loop subdivision is that of vtkMultiDimensionalSubdivision.
 */
#include "SurfaceTools.h"

#include "vtkMultiDimensionalSubdivision.h"

#include "vtkUnstructuredGrid.h"

using namespace surfacetools;

TEST(SurfaceJoints, BordersDoNotCountAmongSharpJoints)
{
  // Three triangles at an edge; two of them are closed around point 0, the border of the third ends
  // there: of the two sharp edges of point 0 one is a joint, so that it is a corner.
  Model model;
  model.Points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0.2, 0 }, { -0.3, 1, 0.1 }, { -0.6, -1, 0.3 } };
  model.Faces = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 }, { 0, 2, 3 } };
  vtkNew<vtkSurfaceSubdivision> loop;
  loop->SetInputData(MakeInput(model));
  loop->ModifiedBoundaryOff();
  loop->SetType2Rule(vtkSurfaceSubdivision::SHARP);
  loop->Update();
  vtkNew<vtkMultiDimensionalSubdivision> main;
  main->SetInputData(MakeInput(model));
  main->SetType2RuleToSharp();
  main->Update();
  for (vtkIdType i = 0; i < 5; ++i)
  {
    Point a;
    Point b;
    loop->GetOutput()->GetPoint(i, a.data());
    main->GetOutput()->GetPoint(i, b.data());
    EXPECT_LT(GetDistance(a, b), 1e-14) << "point " << i;
  }
  EXPECT_EQ(loop->GetOutput()->GetPoint(0)[1], 0.);
}
