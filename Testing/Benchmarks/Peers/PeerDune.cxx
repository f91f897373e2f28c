// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerDune.cxx
 * dune-uggrid: global red refinement of tetrahedra, which conforms. Carries no scalar, moves
 * nothing.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include <dune/common/parallel/mpihelper.hh>
#include <dune/grid/common/gridfactory.hh>
#include <dune/grid/uggrid.hh>

#include <memory>

namespace benchmarks
{
namespace
{

using Grid = Dune::UGGrid<3>;

Produced Subdivide(Stopwatch& watch, const FlatMesh& input, int levels)
{
  std::unique_ptr<Grid> grid;
  std::vector<double> points;
  std::vector<int> cells;
  watch.Start();
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
  grid = factory.createGrid();
  grid->globalRefine(levels);
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

void RegisterDune()
{
  static const FlatMesh cube = MakeCube(12);
  const int levels = IsQuick() ? 2 : 3;
  Register(
    "peer/dune-uggrid/cube/levels:" + std::to_string(levels), 1,
    [levels](Stopwatch& watch)
    {
      int argc = 0;
      char** argv = nullptr;
      Dune::MPIHelper::instance(argc, argv);
      return Subdivide(watch, cube, levels);
    },
    1);
}

const Registration Registered(RegisterDune);

}
}
