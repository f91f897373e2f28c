// SPDX-License-Identifier: BSD-3-Clause
// OpenMesh's sqrt(3), Catmull-Clark, modified Butterfly and Loop subdivision, in double, on closed
// meshes: what ours makes. Its weights are tables, of 50 valences for sqrt(3) and Loop.
#include "PeerTools.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

namespace
{

using namespace peertools;
namespace Uniform = OpenMesh::Subdivider::Uniform;

struct DoubleTraits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Triangles = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
using Polygons = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

template <typename Mesh, template <typename, typename> class Scheme>
Model SubdivideTheirs(const Model& model, int levels)
{
  Mesh mesh;
  for (const Point& point : model.Points)
  {
    mesh.add_vertex(typename Mesh::Point(point.data()));
  }
  for (const auto& ids : model.Faces)
  {
    std::vector<typename Mesh::VertexHandle> face;
    for (vtkIdType id : ids)
    {
      face.push_back(mesh.vertex_handle(static_cast<unsigned>(id)));
    }
    mesh.add_face(face);
  }
  Scheme<Mesh, double> subdivider;
  subdivider.attach(mesh);
  subdivider(static_cast<std::size_t>(levels));
  subdivider.detach();
  Model made;
  for (auto v : mesh.vertices())
  {
    const auto& x = mesh.point(v);
    made.Points.push_back({ x[0], x[1], x[2] });
  }
  for (auto f : mesh.faces())
  {
    made.Faces.emplace_back();
    for (auto v : f.vertices())
    {
      made.Faces.back().push_back(v.idx());
    }
  }
  return made;
}

TEST(PeerOpenMesh, SqrtThree)
{
  ExpectSameOnClosedMeshes(
    vtkSurfaceSubdivision::SQRT_THREE, true, SubdivideTheirs<Triangles, Uniform::Sqrt3T>);
}

TEST(PeerOpenMesh, CatmullClark)
{
  ExpectSameOnClosedMeshes(
    vtkSurfaceSubdivision::CATMULL_CLARK, false, SubdivideTheirs<Polygons, Uniform::CatmullClarkT>);
}

TEST(PeerOpenMesh, ModifiedButterfly)
{
  ExpectSameOnClosedMeshes(vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, true,
    SubdivideTheirs<Triangles, Uniform::ModifiedButterflyT>);
}

TEST(PeerOpenMesh, LoopWithHisWeights)
{
  ExpectSameOnClosedMeshes(
    vtkSurfaceSubdivision::LOOP, true, SubdivideTheirs<Triangles, Uniform::LoopT>, WithLoopWeights);
}

// Its Catmull-Clark has a boundary of its own: (1, 4, 1) / 6 at vertices.
TEST(PeerOpenMesh, PlainBoundary)
{
  ExpectSameOnTube(
    vtkSurfaceSubdivision::LOOP, true, SubdivideTheirs<Triangles, Uniform::LoopT>, WithLoopWeights);
}

}
