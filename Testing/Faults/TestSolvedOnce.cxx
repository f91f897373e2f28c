// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSolvedOnce.cxx
 * vtkSubdivisionSmoothness solves equal local matrices once, and examines equal stars once: each of
 * them asks for memory, so that a mesh of many equal stars would ask for more with each star.
 */
#include "FailingMemory.h"
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSubdivisionSmoothness.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

enum Kind
{
  Solids,    ///< five tetrahedra around an edge
  Triangles, ///< a bipyramid of ten triangles
  Quads      ///< a cube
};

/// So many equal parts.
Grid MakeParts(Kind kind, int count)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int part = 0; part < count; ++part)
  {
    const auto first = static_cast<vtkIdType>(points.size());
    const double x = 10. * part;
    if (kind == Quads)
    {
      for (int i = 0; i < 8; ++i)
      {
        points.push_back({ x + i % 2, i / 2 % 2 + 0., i / 4 + 0. });
      }
      for (const Ids& quad : { Ids{ 0, 2, 3, 1 }, Ids{ 4, 5, 7, 6 }, Ids{ 0, 1, 5, 4 },
             Ids{ 2, 6, 7, 3 }, Ids{ 0, 4, 6, 2 }, Ids{ 1, 3, 7, 5 } })
      {
        cells.push_back(
          { VTK_QUAD, { first + quad[0], first + quad[1], first + quad[2], first + quad[3] } });
      }
      continue;
    }
    points.push_back({ x, 0., 1. });
    points.push_back({ x, 0., -1. });
    for (vtkIdType i = 0; i < 5; ++i)
    {
      const double angle = 6.28318530717959 / 5. * static_cast<double>(i);
      points.push_back({ x + std::cos(angle), std::sin(angle), 0. });
      const vtkIdType a = first + 2 + i;
      const vtkIdType b = first + 2 + (i + 1) % 5;
      if (kind == Solids)
      {
        cells.push_back({ VTK_TETRA, { first, first + 1, a, b } });
        continue;
      }
      cells.push_back({ VTK_TRIANGLE, { a, b, first } });
      cells.push_back({ VTK_TRIANGLE, { b, a, first + 1 } });
    }
  }
  return MakeGrid(points, cells);
}

/// How often the library asks for memory.
long CountCalls(int scheme, Kind kind, int parts)
{
  const Grid grid = MakeParts(kind, parts);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(grid->GetPoints());
  surface->SetPolys(grid->GetCells());
  const bool readsGrid = scheme <= vtkSubdivisionSmoothness::TET_OCT;
  long calls = 0;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]
    {
      vtkNew<vtkSubdivisionSmoothness> filter;
      vtkNew<Messages> messages;
      messages->Watch(filter);
      filter->SetScheme(scheme);
      filter->SetInputDataObject(
        readsGrid ? static_cast<vtkDataObject*>(grid) : static_cast<vtkDataObject*>(surface));
      failing_memory::FailAfter(std::numeric_limits<long>::max());
      filter->Update();
      EXPECT_FALSE(failing_memory::Stop());
      calls = failing_memory::GetNumberOfCalls();
      EXPECT_TRUE(messages->Errors.empty());
      EXPECT_GT(
        vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells(), parts);
    });
  return calls;
}

}

/// Twice the parts cost what lists need that grow, which is far less than a star for each part.
TEST(SolvedOnce, EqualStars)
{
  using Smoothness = vtkSubdivisionSmoothness;
  const std::vector<std::pair<int, Kind>> cases{ { Smoothness::BOX_SPLINE, Solids },
    { Smoothness::TET_OCT, Solids }, { Smoothness::BOX_SPLINE, Triangles },
    { Smoothness::LOOP, Triangles }, { Smoothness::MODIFIED_BUTTERFLY, Triangles },
    { Smoothness::SQRT_THREE, Triangles }, { Smoothness::CATMULL_CLARK, Quads },
    { Smoothness::DOO_SABIN, Quads }, { Smoothness::MIDEDGE, Quads },
    { Smoothness::FOUR_EIGHT, Quads } };
  for (const auto& [scheme, kind] : cases)
  {
    constexpr int parts = 200;
    CountCalls(scheme, kind, 1); // tables that are made once
    const long few = CountCalls(scheme, kind, parts);
    const long many = CountCalls(scheme, kind, 2 * parts);
    std::cout << scheme << " " << kind << ": " << few << " calls for " << parts << " parts, "
              << many << " for twice as many\n";
    EXPECT_LT(many - few, parts / 2) << scheme << " " << kind;
  }
}
