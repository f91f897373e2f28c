// SPDX-License-Identifier: BSD-3-Clause
// CGAL's Subdivision_method_3: sqrt(3), Catmull-Clark, Doo-Sabin and Loop, in double, on closed
// meshes: what ours makes.
#include "PeerTools.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

namespace
{

using namespace peertools;
namespace Methods = CGAL::Subdivision_method_3;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <typename Method>
Model SubdivideTheirs(const Model& model, int levels, const Method& method)
{
  Mesh mesh;
  for (const Point& x : model.Points)
  {
    mesh.add_vertex(Kernel::Point_3(x[0], x[1], x[2]));
  }
  for (const auto& ids : model.Faces)
  {
    std::vector<Mesh::Vertex_index> face;
    for (vtkIdType id : ids)
    {
      face.emplace_back(static_cast<Mesh::size_type>(id));
    }
    mesh.add_face(face);
  }
  method(mesh, CGAL::parameters::number_of_iterations(levels));
  mesh.collect_garbage();
  Model made;
  for (auto v : mesh.vertices())
  {
    const Kernel::Point_3& x = mesh.point(v);
    made.Points.push_back({ x.x(), x.y(), x.z() });
  }
  for (auto f : mesh.faces())
  {
    made.Faces.emplace_back();
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      made.Faces.back().push_back(static_cast<vtkIdType>(v));
    }
  }
  return made;
}

TEST(PeerCgal, SqrtThree)
{
  ExpectSameOnClosedMeshes(vtkSurfaceSubdivision::SQRT_THREE, true,
    [](const Model& model, int levels)
    {
      return SubdivideTheirs(model, levels,
        [](Mesh& mesh, const auto& options) { Methods::Sqrt3_subdivision(mesh, options); });
    });
}

TEST(PeerCgal, CatmullClark)
{
  ExpectSameOnClosedMeshes(vtkSurfaceSubdivision::CATMULL_CLARK, false,
    [](const Model& model, int levels)
    {
      return SubdivideTheirs(model, levels,
        [](Mesh& mesh, const auto& options) { Methods::CatmullClark_subdivision(mesh, options); });
    });
}

TEST(PeerCgal, DooSabin)
{
  ExpectSameOnClosedMeshes(vtkSurfaceSubdivision::DOO_SABIN, false,
    [](const Model& model, int levels)
    {
      return SubdivideTheirs(model, levels,
        [](Mesh& mesh, const auto& options) { Methods::DooSabin_subdivision(mesh, options); });
    });
}

TEST(PeerCgal, LoopWithHisWeights)
{
  ExpectSameOnClosedMeshes(
    vtkSurfaceSubdivision::LOOP, true,
    [](const Model& model, int levels)
    {
      return SubdivideTheirs(model, levels,
        [](Mesh& mesh, const auto& options) { Methods::Loop_subdivision(mesh, options); });
    },
    WithLoopWeights);
}

TEST(PeerCgal, PlainBoundary)
{
  ExpectSameOnTube(
    vtkSurfaceSubdivision::LOOP, true,
    [](const Model& model, int levels)
    {
      return SubdivideTheirs(model, levels,
        [](Mesh& mesh, const auto& options) { Methods::Loop_subdivision(mesh, options); });
    },
    WithLoopWeights);
  ExpectSameOnTube(vtkSurfaceSubdivision::CATMULL_CLARK, false,
    [](const Model& model, int levels)
    {
      return SubdivideTheirs(model, levels,
        [](Mesh& mesh, const auto& options) { Methods::CatmullClark_subdivision(mesh, options); });
    });
}

}
