// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerDune.cxx
 * dune-uggrid: global red refinement of tetrahedra, which conforms, and red-green refinement near a
 * corner. Carries no scalar, moves nothing.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include <dune/common/parallel/mpihelper.hh>
#include <dune/grid/common/gridfactory.hh>
#include <dune/grid/uggrid.hh>

#include <functional>
#include <memory>

namespace benchmarks
{
namespace
{

using Grid = Dune::UGGrid<3>;

std::unique_ptr<Grid> MakeGrid(const FlatMesh& input)
{
  Dune::GridFactory<Grid> factory;
  for (int i = 0; i < input.GetNumberOfPoints(); ++i)
  {
    const double* x = input.Points.data() + 3 * i;
    factory.insertVertex({ x[0], x[1], x[2] });
  }
  for (std::size_t t = 0; t < input.Cells.size(); t += 4)
  {
    factory.insertElement(Dune::GeometryTypes::tetrahedron,
      std::vector<unsigned int>(input.Cells.data() + t, input.Cells.data() + t + 4));
  }
  return std::unique_ptr<Grid>(factory.createGrid());
}

/// One round: the leaves whose centroid lies within a radius of the corner.
void RefineCorner(Grid& grid, double radius)
{
  for (const auto& element : Dune::elements(grid.leafGridView()))
  {
    const auto centre = element.geometry().center();
    if (centre.two_norm2() < radius * radius)
    {
      grid.mark(1, element);
    }
  }
  grid.preAdapt();
  grid.adapt();
  grid.postAdapt();
}

Produced Subdivide(
  Stopwatch& watch, const FlatMesh& input, const std::function<void(Grid&)>& refine)
{
  std::unique_ptr<Grid> grid;
  std::vector<double> points;
  std::vector<int> cells;
  watch.Start();
  grid = MakeGrid(input);
  refine(*grid);
  const auto view = grid->leafGridView();
  const auto& indices = view.indexSet();
  points.resize(3 * indices.size(3));
  cells.resize(4 * indices.size(0));
  for (const auto& vertex : Dune::vertices(view))
  {
    const auto x = vertex.geometry().corner(0);
    std::copy(x.begin(), x.end(), points.data() + 3 * indices.index(vertex));
  }
  for (const auto& element : Dune::elements(view))
  {
    int* out = cells.data() + 4 * indices.index(element);
    for (int corner = 0; corner < 4; ++corner)
    {
      out[corner] = static_cast<int>(indices.subIndex(element, corner, 3));
    }
  }
  watch.Stop();
  return { static_cast<double>(cells.size() / 4),
    static_cast<double>(8 * points.size() + 4 * cells.size()) };
}

void RegisterPeer(
  const std::string& name, const FlatMesh& mesh, const std::function<void(Grid&)>& refine)
{
  Register(
    name, 1,
    [&mesh, refine](Stopwatch& watch)
    {
      int argc = 0;
      char** argv = nullptr;
      Dune::MPIHelper::instance(argc, argv);
      return Subdivide(watch, mesh, refine);
    },
    1);
}

void RegisterDune()
{
  static const FlatMesh cube = MakeCube(12);
  const int levels = IsQuick() ? 2 : 3;
  RegisterPeer("peer/dune-uggrid/cube/levels:" + std::to_string(levels), cube,
    [levels](Grid& grid) { grid.globalRefine(levels); });
  RegisterPeer("peer/dune-uggrid local/corner/levels:4", cube,
    [](Grid& grid)
    {
      for (int round = 0; round < 4; ++round)
      {
        RefineCorner(grid, 0.21);
      }
    });
}

const Registration Registered(RegisterDune);

}
}
