// SPDX-License-Identifier: BSD-3-Clause
// Subdivides arrays of points and cells twice, without a data set of VTK: with the headers of Core.
#include <Core/Memory/Coordinates.h>
#include <Core/Solids/BoxSpline/BoxSplineScheme.h>
#include <Core/Solids/Complex/TetOrder.h>
#include <Core/Solids/Scheme/Stencils.h>

#include <iostream>
#include <vector>

using namespace subdivision;

int main()
{
  // A tetrahedron, a triangle at one of its edges, and a line at one of its points.
  std::vector<double> points{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 2 };
  SimplexList cells;
  cells.NumberOfPoints = 6;
  cells.Dimensions = { 3, 2, 1 };
  cells.Connectivity = { 0, 1, 2, 3, 1, 2, 4, 3, 5 };
  OrderTets(cells, Coordinates{ points.data() }, nullptr, 0);

  std::vector<CellRun> runs;
  Level<int> level;
  level.Complex = BuildComplex<int>(cells, runs);
  level.Strata = BuildStrata(level.Complex, SingularSimplices(), StrataOptions());
  for (int step = 0; step < 2; ++step)
  {
    const LevelRows<int> rows(level);
    std::vector<double> moved(3 * rows.GetNumberOfRows());
    rows.Apply(points.data(), moved.data(), 3);
    points = moved;
    level = Refine(level, Depth::ForRefinement);
    runs = RefineRuns(runs, 1);
  }

  const CellCounts counts = CountCells(runs);
  std::vector<long long> connectivity(counts.Entries);
  std::vector<long long> offsets(counts.Cells + 1);
  std::vector<unsigned char> types(counts.Cells); // as VTK numbers them
  WriteCells(level.Complex, runs,
    CellStorage<long long>{ connectivity.data(), offsets.data(), types.data() });

  std::cout << "3 cells became " << counts.Cells << ", with " << points.size() / 3 << " points\n";
  return counts.Cells == 64 + 16 + 4 ? 0 : 1;
}
