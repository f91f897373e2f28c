// SPDX-License-Identifier: BSD-3-Clause
// Files of each format go out and come back in; sizes are foretold.
#include "Files.h"
#include "Names.h"
#include "Pipeline.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace subdivide;

namespace
{

vtkSmartPointer<vtkDataObject> Ship(int levels, int scheme = 0)
{
  vtkNew<vtkSubdivisionModelSource> model;
  model->SetModelToShip();
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetInputConnection(model->GetOutputPort());
  filter->SetNumberOfLevels(levels);
  filter->SetVolumeScheme(scheme);
  filter->Update();
  return filter->GetOutputDataObject(0);
}

template <typename Grid>
vtkSmartPointer<vtkDataObject> Structured()
{
  vtkNew<Grid> grid;
  grid->SetDimensions(2, 3, 4);
  return grid;
}

vtkSmartPointer<vtkDataObject> FittingData(const std::string& ending)
{
  if (ending == ".vti")
  {
    return Structured<vtkImageData>();
  }
  if (ending == ".vtr")
  {
    return ReadFile("rectilinear.vtk");
  }
  if (ending == ".vts")
  {
    return ReadFile("structured.vtk");
  }
  return Ship(1);
}

void WriteLegacy(const char* name, const char* body)
{
  std::ofstream(name) << "# vtk DataFile Version 3.0\nmesh\nASCII\n" << body;
}

}

TEST(ProgramFiles, OfEachFormat)
{
  WriteLegacy("rectilinear.vtk",
    "DATASET RECTILINEAR_GRID\nDIMENSIONS 2 2 1\nX_COORDINATES 2 float\n0 1\nY_COORDINATES 2 "
    "float\n0 1\n"
    "Z_COORDINATES 1 float\n0\n");
  WriteLegacy("structured.vtk",
    "DATASET STRUCTURED_GRID\nDIMENSIONS 2 2 1\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n");
  std::istringstream endings(ListWritable());
  int count = 0;
  for (std::string ending; endings >> ending; ++count)
  {
    const std::string name = "written" + ending;
    const auto data = FittingData(ending);
    WriteFile(data, name);
    const Size before = GetSize(data);
    const Size after = GetSize(ReadFile(name));
    EXPECT_GT(after.Cells, 0.) << name;
    const bool surface = ending == ".obj" || ending == ".ply" || ending == ".stl" ||
      ending == ".vtp" || ending == ".pvtp";
    if (surface)
    {
      EXPECT_LT(after.Cells, before.Cells) << name;
      EXPECT_FALSE(after.HasSolids) << name;
    }
    else
    {
      EXPECT_EQ(after.Cells, before.Cells) << name;
      EXPECT_EQ(after.HasSolids, before.HasSolids) << name;
    }
  }
  EXPECT_GE(count, 12);
}

TEST(ProgramFiles, Blocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Ship(0));
  blocks->SetBlock(1, Ship(1));
  const double cells = GetSize(blocks).Cells;
  WriteFile(blocks, "blocks.vtm");
  const auto read = ReadFile("blocks.vtm");
  ASSERT_NE(vtkMultiBlockDataSet::SafeDownCast(read), nullptr);
  EXPECT_EQ(vtkMultiBlockDataSet::SafeDownCast(read)->GetNumberOfBlocks(), 2u);
  EXPECT_EQ(GetSize(read).Cells, cells);
  for (const char* name : { "blocks.vtu", "blocks.vtk" })
  {
    WriteFile(blocks, name);
    EXPECT_EQ(GetSize(ReadFile(name)).Cells, cells) << name;
  }
  WriteFile(blocks, "blocks.stl");
  EXPECT_GT(GetSize(ReadFile("blocks.stl")).Cells, 0.);
}

TEST(ProgramFiles, AllArraysOfLegacyFilesAreRead)
{
  WriteLegacy("arrays.vtk",
    "DATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n0 0 0\nCELLS 1 2\n1 0\nCELL_TYPES 1\n1\nPOINT_DATA "
    "1\n"
    "SCALARS a float\nLOOKUP_TABLE default\n1\nSCALARS b float\nLOOKUP_TABLE default\n2\n");
  const auto data = ReadFile("arrays.vtk");
  auto* grid = vtkDataSet::SafeDownCast(data);
  ASSERT_NE(grid, nullptr);
  EXPECT_NE(grid->GetPointData()->GetArray("a"), nullptr);
  EXPECT_NE(grid->GetPointData()->GetArray("b"), nullptr);
}

TEST(ProgramFiles, WhatFormatsCannotHold)
{
  EXPECT_THROW(WriteFile(Ship(0), "ship.vti"), Failure);
  EXPECT_THROW(ReadFile("there-is-none.vtu"), Failure);
  EXPECT_THROW(CheckReadable("a.doc"), UsageError);
  EXPECT_THROW(CheckWritable("a"), UsageError);
}

TEST(ProgramInfo, SizesAreForetoldExactly)
{
  for (int scheme : { 0, 1, 2 })
  {
    std::vector<double> cells;
    std::vector<double> points;
    for (int level = 0; level < 4; ++level)
    {
      const Size size = GetSize(Ship(level, scheme));
      cells.push_back(size.Cells);
      points.push_back(size.Points);
    }
    const Size later = GetSize(Ship(5, scheme));
    EXPECT_EQ(Extrapolate(cells, { 8., 4., 2., 1. }, 5), later.Cells);
    EXPECT_EQ(Extrapolate(points, { 8., 4., 2., 1. }, 5), later.Points);
  }
  EXPECT_EQ(Extrapolate({ 5., 5. }, { 8., 4. }, 7), 5.);
}
