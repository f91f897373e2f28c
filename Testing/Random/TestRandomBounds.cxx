// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRandomBounds.cxx
 * Error bounds hold on random meshes with random rules.
 */
#include "BoundTools.h"
#include "RandomSurfaces.h"
#include "RandomTools.h"

using namespace bound_tools;
using random_tools::Chance;
using random_tools::Draw;
using random_tools::ForSeeds;

namespace
{

void CheckComplex(unsigned seed)
{
  Chance chance(seed);
  const bool withSolids = Draw(chance, 2) == 0;
  const Grid input = WithValues(MakeRandomComplex(seed, withSolids));
  const unsigned choices = chance();
  const Configure configure = [choices](Filter* filter)
  {
    Chance of(choices);
    filter->SetDetectFeatures(Draw(of, 2) == 0);
    filter->SetCreaseEnd(Draw(of, 2));
    filter->SetLoopWeights(Draw(of, 2));
    filter->SetEmbeddedCells(Draw(of, 3));
    filter->SetType1Rule(Draw(of, 5));
    filter->SetType2Rule(Draw(of, 2));
    filter->SetType3Rule(Draw(of, 2));
    filter->SetInterpolatePoints(Draw(of, 4) == 0);
  };
  const int levels = withSolids ? 0 : Draw(chance, 3);
  const bool projects = Draw(chance, 2) == 0;
  Tightness found;
  ExpectBounds(MakeBounded<Filter>(input, levels, 4, configure, projects), found);
}

void CheckSurface(unsigned seed)
{
  Chance chance(seed);
  const surfacetools::Model model = surfacetools::RandomSurface(seed).Get();
  std::vector<Cell> cells;
  std::vector<int> flags;
  for (const auto& face : model.Faces)
  {
    cells.push_back({ VTK_TRIANGLE, face });
    flags.push_back(0);
  }
  for (int i = 0; i < Draw(chance, 4); ++i)
  {
    const Ids& face =
      model.Faces[static_cast<std::size_t>(Draw(chance, static_cast<int>(flags.size())))];
    cells.push_back({ VTK_LINE, { face[0], face[1] } });
  }
  flags.resize(cells.size(), 1);
  const Grid grid = MakeGrid(model.Points, cells);
  AddCellArray(grid, "Singular", flags);
  const Grid input = WithValues(grid);
  const int scheme =
    Draw(chance, 2) == 0 ? vtkSurfaceSubdivision::LOOP : vtkSurfaceSubdivision::CATMULL_CLARK;
  const int crease = Draw(chance, 2);
  const bool modified = Draw(chance, 2) == 0;
  const std::function<void(vtkSurfaceSubdivision*)> configure = [=](vtkSurfaceSubdivision* filter)
  {
    filter->SetScheme(scheme);
    filter->SetCreaseEnd(crease);
    filter->SetModifiedBoundary(modified);
  };
  const int levels = scheme == vtkSurfaceSubdivision::LOOP ? Draw(chance, 2) : 1;
  const bool projects = Draw(chance, 2) == 0;
  const auto bounded = MakeBounded<vtkSurfaceSubdivision>(input, levels, 3, configure, projects);
  if (bounded.Coarse->GetCellData()->HasArray("ErrorBound")) // no negative weights
  {
    Tightness found;
    ExpectBounds(bounded, found);
  }
}

}

TEST(RandomBounds, HoldOnComplexes)
{
  ForSeeds(0.05, CheckComplex);
}

TEST(RandomBounds, HoldOnSurfaces)
{
  ForSeeds(0.05, CheckSurface);
}
