// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerCgal.cxx
 * CGAL: Loop, sqrt(3), Catmull-Clark and Doo-Sabin subdivision of a Surface_mesh. None carries a
 * scalar.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace benchmarks
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// `growth`: how many faces a step makes of one. The space of the result is reserved.
template <typename Method>
Produced Subdivide(
  Stopwatch& watch, const FlatMesh& input, int levels, int growth, const Method& method)
{
  const int faces = input.GetNumberOfCells() * static_cast<int>(std::pow(growth, levels));
  Mesh mesh;
  std::vector<double> points;
  std::vector<int> cells;
  watch.Start();
  mesh.reserve(faces * (input.Corners - 2) / 2 + 2, faces * input.Corners / 2, faces);
  for (int i = 0; i < input.GetNumberOfPoints(); ++i)
  {
    const double* x = input.Points.data() + 3 * i;
    mesh.add_vertex(Kernel::Point_3(x[0], x[1], x[2]));
  }
  std::vector<Mesh::Vertex_index> face(input.Corners);
  for (auto v = input.Cells.begin(); v != input.Cells.end(); v += input.Corners)
  {
    std::transform(v, v + input.Corners, face.begin(), [](int i) { return Mesh::Vertex_index(i); });
    mesh.add_face(face);
  }
  method(mesh, CGAL::parameters::number_of_iterations(levels));
  points.reserve(3 * mesh.number_of_vertices());
  cells.reserve(input.Corners * mesh.number_of_faces());
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
  return { static_cast<double>(mesh.number_of_faces()),
    static_cast<double>(8 * points.size() + 4 * cells.size()) };
}

void RegisterCgal()
{
  namespace Methods = CGAL::Subdivision_method_3;
  static const FlatMesh sphere = MakeSphere(5);
  static const FlatMesh quads = MakeQuadSphere(58);
  static const FlatMesh bumpy = MakeBumpySphere(6);
  Register("peer/CGAL Loop/sphere/levels:3", 1,
    [](Stopwatch& watch)
    {
      return Subdivide(watch, sphere, 3, 4,
        [](Mesh& mesh, const auto& options) { Methods::Loop_subdivision(mesh, options); });
    });
  Register("peer/CGAL sqrt3/sphere/levels:4", 1,
    [](Stopwatch& watch)
    {
      return Subdivide(watch, sphere, 4, 3,
        [](Mesh& mesh, const auto& options) { Methods::Sqrt3_subdivision(mesh, options); });
    });
  // Uniform: two steps, where adaptive refinement makes as many triangles at most.
  Register("peer/CGAL sqrt3/bumpy/levels:2", 1,
    [](Stopwatch& watch)
    {
      return Subdivide(watch, bumpy, 2, 3,
        [](Mesh& mesh, const auto& options) { Methods::Sqrt3_subdivision(mesh, options); });
    });
  static const FlatMesh bunny = ReadTriangles(GetDataFolder() + "/surf_bunny_full.vtp");
  if (bunny.GetNumberOfCells() > 0)
  {
    Register("peer/CGAL sqrt3/bunny/levels:2", 1,
      [](Stopwatch& watch)
      {
        return Subdivide(watch, bunny, 2, 3,
          [](Mesh& mesh, const auto& options) { Methods::Sqrt3_subdivision(mesh, options); });
      });
  }
  Register("peer/CGAL Catmull-Clark/quads/levels:3", 1,
    [](Stopwatch& watch)
    {
      return Subdivide(watch, quads, 3, 4,
        [](Mesh& mesh, const auto& options) { Methods::CatmullClark_subdivision(mesh, options); });
    });
  Register("peer/CGAL Doo-Sabin/quads/levels:3", 1,
    [](Stopwatch& watch)
    {
      return Subdivide(watch, quads, 3, 4,
        [](Mesh& mesh, const auto& options) { Methods::DooSabin_subdivision(mesh, options); });
    });
}

const Registration Registered(RegisterCgal);

}
}
