// SPDX-License-Identifier: BSD-3-Clause
// Files of each format go out and come back in; sizes are foretold.
#include "Precompiled.h"

#include "Conversion.h"
#include "Files.h"
#include "Messages.h"
#include "Names.h"
#include "Pipeline.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkOutputWindow.h"
#include "vtkStringArray.h"
#include "vtkSubdivisionModelSource.h"

#include "vtksys/SystemTools.hxx"

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

template <typename Array>
void AddArray(vtkDataObject* data, int association, const char* name, int components, double value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(
    association == vtkDataObject::FIELD ? 1 : data->GetNumberOfElements(association));
  array->Fill(value);
  data->GetAttributesAsFieldData(association)->AddArray(array);
}

double FirstOf(vtkFieldData* data, const char* name)
{
  return data->GetArray(name) ? data->GetArray(name)->GetComponent(0, 0) : -1.;
}

double LastOf(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  return array ? array->GetComponent(array->GetNumberOfTuples() - 1, 0) : -1.;
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

TEST(ProgramFiles, NumbersStayWhatTheyAre)
{
  const auto ship = Ship(1);
  AddArray<vtkDoubleArray>(ship, vtkDataObject::POINT, "Third", 1, 1. / 3.);
  for (const char* name : { "third.vtu", "third.vtk", "third.vtp", "third.vtm" })
  {
    WriteFile(ship, name);
    const auto read = ReadFile(name);
    ASSERT_FALSE(GetDataSets(read).empty()) << name;
    for (vtkDataSet* set : GetDataSets(read))
    {
      EXPECT_EQ(LastOf(set->GetPointData(), "Third"), 1. / 3.) << name;
    }
  }
}

TEST(ProgramFiles, EndingsInLargeLetters)
{
  for (const char* name : { "LARGE.VTU", "LARGE.PLY", "LARGE.STL", "LARGE.OBJ", "LARGE.VTM",
         "LARGE.PVTU", "LARGE.Vtp", "LARGE.VTK" })
  {
    WriteFile(Ship(0), name);
    EXPECT_GT(GetSize(ReadFile(name)).Cells, 0.) << name;
  }
  EXPECT_FALSE(vtksys::SystemTools::FileExists("LARGE.PLY.ply"));
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

namespace
{

/// Two ships whose arrays differ.
vtkSmartPointer<vtkMultiBlockDataSet> TwoShips()
{
  const auto first = Ship(0);
  const auto second = Ship(0);
  AddArray<vtkFloatArray>(first, vtkDataObject::POINT, "OfFirst", 3, 4.);
  AddArray<vtkIntArray>(second, vtkDataObject::CELL, "OfSecond", 1, 5.);
  AddArray<vtkDoubleArray>(first, vtkDataObject::CELL, "OfBoth", 1, 6.);
  AddArray<vtkIntArray>(second, vtkDataObject::CELL, "OfBoth", 2, 7.);
  vtkNew<vtkStringArray> words;
  words->SetName("Words");
  words->SetNumberOfValues(vtkDataSet::SafeDownCast(second)->GetNumberOfPoints());
  words->SetValue(0, "word");
  vtkDataSet::SafeDownCast(second)->GetPointData()->AddArray(words);
  vtkDataSet::SafeDownCast(second)->GetCellData()->SetActiveScalars("OfSecond");
  AddArray<vtkIntArray>(first, vtkDataObject::FIELD, "Field", 1, 8.);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  return blocks;
}

}

TEST(ProgramFiles, ArraysThatNotAllBlocksHaveStay)
{
  for (const char* name : { "arrays.vtu", "arrays.pvtu", "arrays.vtp", "arrays.pvtp" })
  {
    WriteFile(TwoShips(), name);
    const auto read = ReadFile(name);
    auto* set = vtkDataSet::SafeDownCast(read);
    ASSERT_NE(set, nullptr) << name;
    vtkPointData* points = set->GetPointData();
    vtkCellData* cells = set->GetCellData();
    ASSERT_TRUE(points->HasArray("OfFirst") && points->HasArray("Words")) << name;
    EXPECT_EQ(points->GetArray("OfFirst")->GetNumberOfComponents(), 3) << name;
    EXPECT_EQ(FirstOf(points, "OfFirst"), 4.) << name;
    EXPECT_EQ(LastOf(points, "OfFirst"), 0.) << name;
    EXPECT_EQ(FirstOf(cells, "OfSecond"), 0.) << name;
    EXPECT_EQ(LastOf(cells, "OfSecond"), 5.) << name;
    EXPECT_EQ(FirstOf(cells, "OfBoth"), 6.) << name;
    EXPECT_EQ(LastOf(cells, "OfBoth"), 0.) << name;
    EXPECT_EQ(LastOf(cells, "OfBoth'"), 7.) << name;
    EXPECT_EQ(cells->GetScalars(), cells->GetArray("OfSecond")) << name;
    auto* words = vtkStringArray::SafeDownCast(points->GetAbstractArray("Words"));
    EXPECT_EQ(words->GetValue(0), "") << name;
    bool found = false;
    for (vtkIdType i = 0; i < words->GetNumberOfValues(); ++i)
    {
      found = found || words->GetValue(i) == "word";
    }
    EXPECT_TRUE(found) << name;
    EXPECT_EQ(FirstOf(set->GetFieldData(), "Field"), 8.) << name;
  }
}

TEST(ProgramFiles, BlocksWithoutAnything)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> none;
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(1, Ship(0)); // 0 is empty
  blocks->SetBlock(0, none);
  blocks->SetBlock(1, inner);
  WriteFile(blocks, "empty.vtm");
  const auto read = ReadFile("empty.vtm");
  EXPECT_EQ(vtkMultiBlockDataSet::SafeDownCast(read)->GetNumberOfBlocks(), 2u);
  EXPECT_EQ(GetSize(read).Cells, GetSize(Ship(0)).Cells);
}

TEST(ProgramFiles, CurvesThatAreLeftOutAreTold)
{
  vtkNew<vtkSubdivisionModelSource> model;
  model->SetModelToMixedDimensions();
  model->Update();
  for (const char* name : { "curves.stl", "curves.ply" })
  {
    testing::internal::CaptureStderr();
    WriteFile(model->GetOutputDataObject(0), name);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("8 lines and vertices are left out"),
      std::string::npos)
      << name;
  }
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0., 0., 0.);
  points->InsertNextPoint(1., 0., 0.);
  vtkNew<vtkPolyData> curve;
  curve->Allocate(2);
  curve->SetPoints(points);
  const vtkIdType ids[] = { 0, 1 };
  curve->InsertNextCell(VTK_LINE, 2, ids);
  curve->InsertNextCell(VTK_VERTEX, 1, ids);
  testing::internal::CaptureStderr();
  WriteFile(curve, "curve.obj");
  EXPECT_NE(
    testing::internal::GetCapturedStderr().find("1 vertices are left out"), std::string::npos);
}

TEST(ProgramFiles, TextsThatExodusCannotHoldAreTold)
{
  const std::string endings = ListWritable();
  if (endings.find(".exo") == std::string::npos)
  {
    GTEST_SKIP() << "VTK has no IOExodus";
  }
  testing::internal::CaptureStderr();
  WriteFile(TwoShips(), "texts.exo");
  EXPECT_NE(testing::internal::GetCapturedStderr().find("the array \"Words\" is left out"),
    std::string::npos);
  const auto read = ReadFile("texts.exo");
  for (vtkDataSet* set : GetDataSets(read))
  {
    EXPECT_TRUE(set->GetPointData()->HasArray("OfFirst"));
    EXPECT_FALSE(set->GetPointData()->HasArray("Words"));
  }
}

TEST(ProgramFiles, CellsThatFormatsCannotHold)
{
  WriteLegacy("missing.vtk",
    "DATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 2 10\n4 0 1 2 3\n4 "
    "0 1 "
    "2 9\nCELL_TYPES 2\n10 10\n");
  WriteLegacy("voxel.vtk",
    "DATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n"
    "CELLS 2 10\n8 0 1 2 3 4 5 6 7\n0\nCELL_TYPES 2\n11 0\n");
  std::istringstream endings(ListWritable());
  for (std::string ending; endings >> ending;)
  {
    const bool isExodus = ending.compare(0, 2, ".e") == 0;
    if (isExodus || ending == ".stl" || ending == ".vtp" || ending == ".pvtp" || ending == ".obj")
    {
      EXPECT_THROW(WriteFile(ReadFile("missing.vtk"), "missing" + ending), Failure) << ending;
    }
    if (isExodus)
    {
      EXPECT_THROW(WriteFile(ReadFile("voxel.vtk"), "voxel" + ending), Failure) << ending;
    }
  }
  EXPECT_NO_THROW(WriteFile(ReadFile("missing.vtk"), "missing.vtu"));
  WriteLegacy("missing-face.vtk",
    "DATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 7\n");
  EXPECT_THROW(WriteFile(ReadFile("missing-face.vtk"), "missing.stl"), Failure);
}

TEST(ProgramFiles, FieldArraysThatDifferAreNamed)
{
  const auto blocks = TwoShips();
  AddArray<vtkIntArray>(blocks->GetBlock(1), vtkDataObject::FIELD, "Field", 1, 9.);
  testing::internal::CaptureStderr();
  WriteFile(blocks, "fields.vtu");
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_NE(told.find("\"Field\""), std::string::npos);
  EXPECT_EQ(told.find("\"Subdivision"), std::string::npos); // of the run, for the next filter
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

namespace
{

std::string Content(const std::string& name)
{
  std::ostringstream text;
  text << std::ifstream(name, std::ios::binary).rdbuf();
  return text.str();
}

void Write(const std::string& name, const std::string& content)
{
  std::ofstream(name, std::ios::binary) << content;
}

/// Expects that a file can be read as a whole, and nothing less of it.
void ExpectNoPart(const std::string& name, std::size_t from)
{
  const std::string all = Content(name);
  const std::string part = "part-of-" + name;
  for (const std::size_t size : { from, (from + all.size()) / 2, all.size() - 1 })
  {
    Write(part, all.substr(0, size));
    EXPECT_THROW(ReadFile(part), Failure) << part << " " << size << " of " << all.size();
  }
  EXPECT_NO_THROW(ReadFile(name)) << name;
}

}

TEST(ProgramFiles, ThatEndTooEarly)
{
  for (const char* name : { "whole.ply", "whole.stl" })
  {
    WriteFile(Ship(1), name);
    ExpectNoPart(name, 600);
  }
  Write("text.stl",
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nendsolid");
  ExpectNoPart("text.stl", 70);
  const std::string header = "element vertex 3\nproperty float x\nproperty float y\nproperty float "
                             "z\nelement face 1\nproperty list uchar int vertex_indices\n"
                             "end_header\n";
  Write("text.ply", "ply\nformat ascii 1.0\n" + header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_NO_THROW(ReadFile("text.ply"));
  Write("part.ply", "ply\nformat ascii 1.0\n" + header + "0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_THROW(ReadFile("part.ply"), Failure);
  for (const char* wrong : { "uchar int vertex_indices", "vertex_indices", "float x\n" })
  {
    std::string damaged = header;
    damaged.replace(damaged.find(wrong), 1, "#");
    Write("damaged.ply", "ply\nformat ascii 1.0\n" + damaged + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_THROW(ReadFile("damaged.ply"), Failure) << damaged;
  }
  Write("big.ply",
    "ply\nformat binary_big_endian 1.0\n" + header + std::string(36, '\0') + "\3" +
      std::string("\0\0\0\0\0\0\0\1\0\0\0\2", 12));
  ExpectNoPart("big.ply", 200);
  testing::internal::CaptureStderr();
  CatchMessages(false);
  WriteFile(Ship(1), "whole.vtk");
  Write("part.vtk", Content("whole.vtk").substr(0, 9000));
  EXPECT_THROW(ReadFile("part.vtk"), Failure);
  vtkOutputWindow::SetInstance(nullptr);
  testing::internal::GetCapturedStderr();
}

TEST(ProgramFiles, WhatFormatsCannotHold)
{
  EXPECT_THROW(WriteFile(Ship(0), "ship.vti"), Failure);
  EXPECT_THROW(ReadFile("there-is-none.vtu"), Failure);
  EXPECT_THROW(CheckReadable("a.doc"), UsageError);
  EXPECT_THROW(CheckWritable("a"), UsageError);
}
