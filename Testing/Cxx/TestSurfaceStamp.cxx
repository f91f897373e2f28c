// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceStamp.cxx
 * How vtkSurfaceSubdivision knows its own output, and what it believes of a file.
 */
#include "SurfaceTools.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"

using namespace surfacetools;

TEST(SurfaceStamp, AForgedStampIsNotBelieved)
{
  const Model grid = MakeGrid(2, 1, false, { 1., 0., 0. }, { 0., 1., 0. });
  const auto plain = MakeInput(grid);
  const auto expected = RunFilter(plain, vtkSurfaceSubdivision::CATMULL_CLARK, 1);
  const vtkIdType points = plain->GetNumberOfPoints();
  for (const vtkIdType size : { 1 << 26, 1 << 28, 1 << 30, 3, 4, 5, 0 })
  {
    for (const vtkIdType levels : { 1, 2, 19, 20 })
    {
      const auto forged = MakeInput(grid);
      // Version, scheme, levels, control points, control faces, corners of each, points, cells.
      const vtkIdType numbers[] = { 1, vtkSurfaceSubdivision::CATMULL_CLARK, levels, points, 1,
        size, points, 2 };
      vtkNew<vtkIdTypeArray> stamp;
      stamp->SetName("SubdivisionSurface");
      for (const vtkIdType number : numbers)
      {
        stamp->InsertNextValue(number);
      }
      forged->GetFieldData()->AddArray(stamp);
      vtkNew<vtkIdTypeArray> sizes; // read where there is no common size
      sizes->SetName("SubdivisionSurfaceSizes");
      sizes->InsertNextValue(vtkIdType(1) << 58);
      forged->GetFieldData()->AddArray(sizes);
      ExpectSameBits(RunFilter(forged, vtkSurfaceSubdivision::CATMULL_CLARK, 1), expected);
    }
  }
}
