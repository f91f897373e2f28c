// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceErrorBounds.cxx
 * GenerateErrorBounds of vtkSurfaceSubdivision.
 */
#include "BezierTools.h"
#include "BoundTools.h"

using namespace bound_tools;
using bezier_tools::MakeSheet;

namespace
{

using Surface = vtkSurfaceSubdivision;
using Surfaces = std::function<void(Surface*)>;

/// A prism over a polygon of n sides: quads, and two polygons.
Grid MakePrism(int n)
{
  std::vector<Point> points;
  std::vector<Cell> cells{ { VTK_POLYGON, {} }, { VTK_POLYGON, {} } };
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2. * 3.14159265358979 * i / n;
    points.push_back({ std::cos(angle), std::sin(angle), 0.1 * (i % 3) });
    points.push_back({ std::cos(angle), 1.2 * std::sin(angle), 1. });
    const vtkIdType next = 2 * ((i + 1) % n);
    cells.push_back({ VTK_QUAD, { 2 * i, next, next + 1, 2 * i + 1 } });
    cells[0].Points.insert(cells[0].Points.begin(), 2 * i);
    cells[1].Points.push_back(2 * i + 1);
  }
  return MakeGrid(points, cells);
}

Tightness Check(vtkUnstructuredGrid* input, int scheme, int levels, int steps, bool projects,
  const Surfaces& configure = {})
{
  const Surfaces withScheme = [&](Surface* filter)
  {
    filter->SetScheme(scheme);
    if (configure)
    {
      configure(filter);
    }
  };
  Tightness tightness;
  ExpectBounds(
    MakeBounded<Surface>(WithValues(input), levels, steps, withScheme, projects), tightness);
  return tightness;
}

}

TEST(SurfaceErrorBounds, HoldAndAreNearTheTruth)
{
  for (const int scheme : { Surface::LOOP, Surface::CATMULL_CLARK })
  {
    for (const bool projects : { false, true })
    {
      std::vector<double> ratios;
      const auto check = [&](vtkUnstructuredGrid* input, int levels)
      {
        const Tightness found = Check(input, scheme, levels, 4, projects);
        ratios.insert(ratios.end(), found.Ratios.begin(), found.Ratios.end());
      };
      for (const int n : { 3, 4, 5, 7, 12 })
      {
        check(MakePrism(n), 1);
      }
      check(MakeSheet(4, scheme == Surface::LOOP, 0.3), 0);
      check(MakeSheet(4, scheme == Surface::LOOP, 0.3), 1);
      Tightness all;
      all.Ratios = ratios;
      std::cout << "scheme " << scheme << (projects ? " on the limit" : "") << ": median "
                << all.GetMedian() << ", most " << all.GetLargest() << "\n";
      EXPECT_LT(all.GetMedian(), 2.) << scheme;
      EXPECT_LT(all.GetLargest(), 3.) << scheme;
    }
  }
}

TEST(SurfaceErrorBounds, HoldWithCreasesAndBoundaries)
{
  for (const int scheme : { Surface::LOOP, Surface::CATMULL_CLARK, Surface::LINEAR })
  {
    for (unsigned seed = 1; seed < 5; ++seed)
    {
      const Grid sheet = MakeSheet(3, scheme == Surface::LOOP, 0.1 * seed);
      std::vector<int> flags(static_cast<std::size_t>(sheet->GetNumberOfCells()), 0);
      for (const auto& ends : { std::array<vtkIdType, 2>{ 5, 6 }, { 6, 10 } })
      {
        sheet->InsertNextCell(VTK_LINE, 2, ends.data());
        flags.push_back(1);
      }
      const Grid input = WithValues(sheet);
      AddCellArray(input, "Singular", flags);
      Check(input, scheme, static_cast<int>(seed % 2), 4, seed > 2,
        [&](Surface* filter)
        {
          filter->SetModifiedBoundary(seed % 2 == 0);
          filter->SetCreaseEnd(static_cast<int>(seed / 2 % 2));
          filter->SetInterpolatePoints(seed == 3 && scheme == Surface::LOOP);
        });
    }
  }
}

TEST(SurfaceErrorBounds, SayWhereThereAreNone)
{
  const auto expectWarning =
    [](vtkUnstructuredGrid* input, const Surfaces& configure, const std::string& part)
  {
    vtkNew<Surface> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->GenerateErrorBoundsOn();
    configure(filter);
    filter->SetInputData(input);
    filter->Update();
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(messages->CountWarnings(part), 1) << part;
    EXPECT_EQ(messages->CountWarnings("GenerateErrorBounds is ignored"), 1) << part;
    if (filter->GetOutput())
    {
      EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("ErrorBound"), nullptr);
    }
  };
  const Grid sheet = MakeSheet(2, false, 0.1);
  for (const int scheme :
    { Surface::MODIFIED_BUTTERFLY, Surface::DOO_SABIN, Surface::MIDEDGE, Surface::FOUR_EIGHT })
  {
    expectWarning(sheet, [&](Surface* f) { f->SetScheme(scheme); }, "Error bounds need Scheme");
  }
  expectWarning(sheet, [](Surface* f) { f->SetOutputCellsToBezier(); }, "Bezier cells");
  expectWarning(
    MakePrism(5),
    [](Surface* f)
    {
      f->SetSchemeToCatmullClark();
      f->SetNumberOfLevels(0);
    },
    "no quads");
  // A concave corner, where the default is flat.
  const Grid corner = MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 2., 0., 0. }, { 0., 1., 0. },
                                 { 1., 1., 0. }, { 2., 1., 0. }, { 0., 2., 0. }, { 1., 2., 0. } },
    { { VTK_QUAD, { 0, 1, 4, 3 } }, { VTK_QUAD, { 1, 2, 5, 4 } }, { VTK_QUAD, { 3, 4, 7, 6 } },
      { VTK_VERTEX, { 4 } } });
  AddCellArray(corner, "Singular", { 0, 0, 0, 1 });
  expectWarning(corner, [](Surface* f) { f->SetSchemeToCatmullClark(); }, "negative weights");
}
