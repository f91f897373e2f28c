// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerCgal.cxx
 * CGAL: Loop subdivision of a Surface_mesh. Carries no scalar.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

namespace benchmarks
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Produced Subdivide(Stopwatch& watch, const FlatMesh& input, int levels)
{
  Mesh mesh;
  std::vector<double> points;
  std::vector<int> cells;
  watch.Start();
  mesh.reserve(
    input.GetNumberOfPoints(), input.GetNumberOfCells() * 3 / 2, input.GetNumberOfCells());
  for (int i = 0; i < input.GetNumberOfPoints(); ++i)
  {
    const double* x = input.Points.data() + 3 * i;
    mesh.add_vertex(Kernel::Point_3(x[0], x[1], x[2]));
  }
  for (std::size_t t = 0; t < input.Cells.size(); t += 3)
  {
    const int* v = input.Cells.data() + t;
    mesh.add_face(Mesh::Vertex_index(v[0]), Mesh::Vertex_index(v[1]), Mesh::Vertex_index(v[2]));
  }
  CGAL::Subdivision_method_3::Loop_subdivision(
    mesh, CGAL::parameters::number_of_iterations(levels));
  points.reserve(3 * mesh.number_of_vertices());
  cells.reserve(3 * mesh.number_of_faces());
  for (auto v : mesh.vertices())
  {
    const Kernel::Point_3& x = mesh.point(v);
    points.insert(points.end(), { x.x(), x.y(), x.z() });
  }
  for (auto f : mesh.faces())
  {
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      cells.push_back(static_cast<int>(v));
    }
  }
  watch.Stop();
  return { static_cast<double>(cells.size() / 3),
    static_cast<double>(8 * points.size() + 4 * cells.size()) };
}

void RegisterCgal()
{
  static const FlatMesh sphere = MakeSphere(5);
  Register("peer/CGAL Loop/sphere/levels:3", 1,
    [](Stopwatch& watch) { return Subdivide(watch, sphere, 3); });
}

const Registration Registered(RegisterCgal);

}
}
