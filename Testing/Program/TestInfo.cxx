// SPDX-License-Identifier: BSD-3-Clause
// --info foretells what then comes out.
#include "Precompiled.h"
#include "Turns.h"

#include "CommandLine.h"
#include "Files.h"
#include "Info.h"
#include "Pipeline.h"

#include "vtkImageData.h"

using namespace subdivide;

namespace
{

Command Read(const std::vector<std::string>& arguments)
{
  Command command = ReadCommandLine(arguments);
  Connect(command);
  return command;
}

/// Cells and points within this part of them.
void ExpectForetold(const std::vector<std::string>& arguments, double tolerance)
{
  if (!turns::IsNextInTurn())
  {
    return;
  }
  std::string all;
  for (const std::string& argument : arguments)
  {
    all += argument + " ";
  }
  const Forecast forecast = Foretell(Read(arguments));
  const Size real = GetSize(Update(Read(arguments)));
  EXPECT_FALSE(forecast.IsExact) << all;
  EXPECT_EQ(forecast.Maximum, 0.) << all;
  EXPECT_NEAR(forecast.Output.Cells, real.Cells, tolerance * real.Cells) << all;
  EXPECT_NEAR(forecast.Output.Points, real.Points, tolerance * real.Points) << all;
  EXPECT_NEAR(forecast.Output.Bytes, real.Bytes, .15 * real.Bytes) << all;
}

/// Squares of two triangles, and beside them a curve.
vtkSmartPointer<vtkPolyData> Surface(int squares, int lines)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkCellArray> curve;
  for (int j = 0; j <= squares; ++j)
  {
    for (int i = 0; i <= squares; ++i)
    {
      points->InsertNextPoint(i, j, std::sin(i) * std::cos(j));
      if (i < squares && j < squares)
      {
        const vtkIdType a = i + j * (squares + 1);
        triangles->InsertNextCell({ a, a + 1, a + squares + 2 });
        triangles->InsertNextCell({ a, a + squares + 2, a + squares + 1 });
      }
    }
  }
  for (int i = 0; i < lines; ++i)
  {
    const vtkIdType next = points->InsertNextPoint(i, -5., std::sin(i));
    curve->InsertNextCell({ i == 0 ? 0 : next - 1, next });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetLines(curve);
  surface->SetPolys(triangles);
  return surface;
}

/// Tetrahedra and a curve that do not touch each other.
vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra(int tetrahedra, int lines)
{
  vtkNew<vtkPoints> points;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  for (int t = 0; t < tetrahedra; ++t)
  {
    const vtkIdType first = points->InsertNextPoint(2. * t, 0., 0.);
    points->InsertNextPoint(2. * t + 1., 0., 0.);
    points->InsertNextPoint(2. * t, 1., 0.);
    points->InsertNextPoint(2. * t, 0., 1.);
    const vtkIdType corners[] = { first, first + 1, first + 2, first + 3 };
    grid->InsertNextCell(VTK_TETRA, 4, corners);
  }
  points->InsertNextPoint(0., -9., 0.);
  for (int i = 0; i < lines; ++i)
  {
    const vtkIdType next = points->InsertNextPoint(i, -5., 0.);
    const vtkIdType ends[] = { next - 1, next };
    grid->InsertNextCell(VTK_LINE, 2, ends);
  }
  return grid;
}

}

TEST(ProgramInfo, LargeSurfaces)
{
  WriteFile(Surface(190, 0), "large.vtp"); // 72,200 triangles
  for (const char* scheme : { "Loop", "CatmullClark", "DooSabin" })
  {
    ExpectForetold(
      { "large.vtp", "x.vtp", "--filter", "surface", "--scheme", scheme, "--levels", "3" }, .002);
  }
  for (const char* scheme : { "FourEight", "Midedge", "SqrtThree" })
  {
    ExpectForetold(
      { "large.vtp", "x.vtp", "--filter", "surface", "--scheme", scheme, "--levels", "5" }, .01);
  }
  ExpectForetold({ "large.vtp", "x.vtu", "--levels", "3" }, .001);
}

TEST(ProgramInfo, FewSurfacesAmongCurves)
{
  WriteFile(Surface(4, 10000), "curves.vtp");
  ExpectForetold({ "curves.vtp", "x.vtu", "--levels", "6" }, .001);
  for (const char* scheme : { "Loop", "CatmullClark", "DooSabin", "Midedge" })
  {
    ExpectForetold(
      { "curves.vtp", "x.vtp", "--filter", "surface", "--scheme", scheme, "--levels", "6" }, .001);
  }
  // These split curves in every second level.
  for (const auto& scheme : std::vector<std::pair<const char*, const char*>>{
         { "FourEight", "12" }, { "FourEight", "13" }, { "SqrtThree", "8" }, { "SqrtThree", "9" } })
  {
    ExpectForetold({ "curves.vtp", "x.vtp", "--filter", "surface", "--scheme", scheme.first,
                     "--levels", scheme.second },
      .01);
  }
}

TEST(ProgramInfo, SolidsAndMixedMeshes)
{
  for (const char* scheme : { "BoxSpline", "TetOct", "Linear" })
  {
    ExpectForetold({ "x.vtu", "--filter", "model", "--model", "ship", "--filter", "multi",
                     "--scheme", scheme, "--levels", "5" },
      0.);
    ExpectForetold({ "x.vtu", "--filter", "model", "--model", "MixedDimensions", "--filter",
                     "multi", "--scheme", scheme, "--levels", "5" },
      0.);
  }
  WriteFile(Tetrahedra(4000, 40000), "tetrahedra.vtu");
  ExpectForetold({ "tetrahedra.vtu", "x.vtu", "--levels", "3" }, .001);
}

TEST(ProgramInfo, Labels)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(12, 12, 12);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    labels->InsertNextValue(std::hypot(x[0] - 6., x[1] - 6., x[2] - 6.) < 5. ? 1 : 0);
  }
  image->GetPointData()->SetScalars(labels);
  WriteFile(image, "labels.vti");
  ExpectForetold({ "labels.vti", "x.vtu", "--filter", "label-solid", "--levels", "3" }, .01);
}

TEST(ProgramInfo, WhetherMaximumNumberOfCellsStopsTheRun)
{
  const std::vector<std::string> arguments{ "x.vtu", "--filter", "model", "--model", "ship",
    "--filter", "multi", "--levels" };
  for (const char* shown : { "", "Triangles" })
  {
    for (const char* levels : { "3", "4", "5", "20" })
    {
      std::vector<std::string> all = arguments;
      all.insert(all.end(), { levels, "--maximum-cells", "400000" });
      if (*shown)
      {
        all.insert(all.end(), { "--dimensions", shown });
      }
      const bool stops = Foretell(Read(all)).Maximum == 400000.;
      EXPECT_EQ(stops, std::string(levels) != "3") << levels << " " << shown;
      if (stops)
      {
        testing::internal::CaptureStderr();
        EXPECT_EQ(GetSize(Update(Read(all))).Cells, 0.) << levels;
        testing::internal::GetCapturedStderr();
      }
    }
  }
}

TEST(ProgramInfo, PointsThatDoNotExist)
{
  const auto grid = Tetrahedra(1, 0);
  const vtkIdType corners[] = { 0, 1, 2, 99 };
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  WriteFile(grid, "missing.vtu");
  testing::internal::CaptureStderr();
  const Forecast forecast =
    Foretell(Read({ "missing.vtu", "x.vtu", "--dimensions", "Triangles", "--levels", "3" }));
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(forecast.Output.Cells, 0.);
}

TEST(ProgramInfo, WhatDoesNotGrowIsMade)
{
  WriteFile(Tetrahedra(1, 0), "one.vtu");
  testing::internal::CaptureStderr(); // points outside
  const Forecast forecast = Foretell(Read({ "one.vtu", "x.vtu", "--filter", "deformation",
    "--rest-mesh", "one.vtu", "--deformed-mesh", "one.vtu", "--levels", "5" }));
  testing::internal::GetCapturedStderr();
  EXPECT_TRUE(forecast.IsExact);
  EXPECT_EQ(forecast.Output.Cells, 1.);
}
