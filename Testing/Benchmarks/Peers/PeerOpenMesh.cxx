// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerOpenMesh.cxx
 * OpenMesh: Loop, modified Butterfly, sqrt(3) and Catmull-Clark subdivision. None carries a scalar.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

#include <algorithm>
#include <vector>

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
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

/// `growth` is how many faces a step makes of each.
template <typename Mesh, template <typename, typename> class Scheme>
Produced Subdivide(Stopwatch& watch, const FlatMesh& input, int levels, int growth)
{
  Mesh mesh;
  std::vector<double> points;
  std::vector<int> cells;
  watch.Start();
  std::size_t faces = input.GetNumberOfCells();
  for (int level = 0; level < levels; ++level)
  {
    faces *= growth;
  }
  // By Euler's formula, because the surfaces are closed.
  mesh.reserve(faces * (input.Corners - 2) / 2 + 2, faces * input.Corners / 2, faces);
  for (int i = 0; i < input.GetNumberOfPoints(); ++i)
  {
    mesh.add_vertex(typename Mesh::Point(input.Points.data() + 3 * i));
  }
  std::vector<typename Mesh::VertexHandle> face(input.Corners);
  for (auto v = input.Cells.begin(); v != input.Cells.end(); v += input.Corners)
  {
    std::transform(
      v, v + input.Corners, face.begin(), [&mesh](int i) { return mesh.vertex_handle(i); });
    mesh.add_face(face);
  }
  Scheme<Mesh, double> subdivider;
  subdivider.attach(mesh);
  subdivider(levels);
  subdivider.detach();
  points.resize(3 * mesh.n_vertices());
  cells.resize(input.Corners * mesh.n_faces());
  for (auto v : mesh.vertices())
  {
    std::copy_n(mesh.point(v).data(), 3, points.data() + 3 * v.idx());
  }
  for (auto f : mesh.faces())
  {
    int* out = cells.data() + input.Corners * f.idx();
    for (auto v : f.vertices())
    {
      *out++ = v.idx();
    }
  }
  watch.Stop();
  return { static_cast<double>(mesh.n_faces()),
    static_cast<double>(8 * points.size() + 4 * cells.size()) };
}

void RegisterOpenMesh()
{
  namespace Uniform = OpenMesh::Subdivider::Uniform;
  static const FlatMesh sphere = MakeSphere(5);
  static const FlatMesh quads = MakeQuadSphere(58);
  Register("peer/OpenMesh Loop/sphere/levels:3", 1,
    [](Stopwatch& watch) { return Subdivide<Mesh, Uniform::LoopT>(watch, sphere, 3, 4); });
  Register("peer/OpenMesh Butterfly/sphere/levels:3", 1, [](Stopwatch& watch)
    { return Subdivide<Mesh, Uniform::ModifiedButterflyT>(watch, sphere, 3, 4); });
  Register("peer/OpenMesh sqrt3/sphere/levels:4", 1,
    [](Stopwatch& watch) { return Subdivide<Mesh, Uniform::Sqrt3T>(watch, sphere, 4, 3); });
  Register("peer/OpenMesh Catmull-Clark/quads/levels:3", 1, [](Stopwatch& watch)
    { return Subdivide<PolyMesh, Uniform::CatmullClarkT>(watch, quads, 3, 4); });
}

const Registration Registered(RegisterOpenMesh);

}
}
