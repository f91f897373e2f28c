// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerOpenMesh.cxx
 * OpenMesh: Loop and sqrt(3) subdivision. Neither carries a scalar.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

namespace benchmarks
{
namespace
{

struct DoubleTraits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

template <typename Subdivider>
Produced Subdivide(Stopwatch& watch, const FlatMesh& input, int levels)
{
  Mesh mesh;
  std::vector<double> points;
  std::vector<int> cells;
  watch.Start();
  for (int i = 0; i < input.GetNumberOfPoints(); ++i)
  {
    mesh.add_vertex(Mesh::Point(input.Points.data() + 3 * i));
  }
  for (std::size_t t = 0; t < input.Cells.size(); t += 3)
  {
    const int* v = input.Cells.data() + t;
    mesh.add_face(mesh.vertex_handle(v[0]), mesh.vertex_handle(v[1]), mesh.vertex_handle(v[2]));
  }
  Subdivider subdivider;
  subdivider.attach(mesh);
  subdivider(levels);
  subdivider.detach();
  points.resize(3 * mesh.n_vertices());
  cells.resize(3 * mesh.n_faces());
  for (auto v : mesh.vertices())
  {
    std::copy_n(mesh.point(v).data(), 3, points.data() + 3 * v.idx());
  }
  for (auto f : mesh.faces())
  {
    int* out = cells.data() + 3 * f.idx();
    for (auto v : f.vertices())
    {
      *out++ = v.idx();
    }
  }
  watch.Stop();
  return { static_cast<double>(cells.size() / 3),
    static_cast<double>(8 * points.size() + 4 * cells.size()) };
}

void RegisterOpenMesh()
{
  static const FlatMesh sphere = MakeSphere(5);
  Register("peer/OpenMesh Loop/sphere/levels:3", 1,
    [](Stopwatch& watch)
    { return Subdivide<OpenMesh::Subdivider::Uniform::LoopT<Mesh, double>>(watch, sphere, 3); });
  Register("peer/OpenMesh sqrt3/sphere/levels:3", 1,
    [](Stopwatch& watch)
    { return Subdivide<OpenMesh::Subdivider::Uniform::Sqrt3T<Mesh, double>>(watch, sphere, 3); });
}

const Registration Registered(RegisterOpenMesh);

}
}
