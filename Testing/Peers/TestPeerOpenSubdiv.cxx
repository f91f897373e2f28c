// SPDX-License-Identifier: BSD-3-Clause
// OpenSubdiv's Loop and Catmull-Clark subdivision, in double, and their limits: what ours makes.
#include "PeerTools.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <memory>

namespace
{

using namespace peertools;
namespace Far = OpenSubdiv::Far;

struct Vertex
{
  Point At{};
  void Clear() { this->At = {}; }
  void AddWithWeight(const Vertex& other, double weight)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->At[c] += weight * other.At[c];
    }
  }
};

Model SubdivideTheirs(const Model& model, int levels, bool triangles, bool limit)
{
  std::vector<int> sizes;
  std::vector<int> corners;
  for (const auto& face : model.Faces)
  {
    sizes.push_back(static_cast<int>(face.size()));
    for (vtkIdType id : face)
    {
      corners.push_back(static_cast<int>(id));
    }
  }
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(model.Points.size());
  descriptor.numFaces = static_cast<int>(sizes.size());
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = corners.data();
  OpenSubdiv::Sdc::Options rules;
  rules.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  const std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(descriptor,
    Factory::Options(
      triangles ? OpenSubdiv::Sdc::SCHEME_LOOP : OpenSubdiv::Sdc::SCHEME_CATMARK, rules)));
  Far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);
  const Far::PrimvarRefinerReal<double> primvars(*refiner);
  std::vector<Vertex> points(model.Points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i].At = model.Points[i];
  }
  for (int level = 1; level <= levels; ++level)
  {
    std::vector<Vertex> next(static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
    primvars.Interpolate(level, points, next);
    points.swap(next);
  }
  if (limit)
  {
    std::vector<Vertex> limits(points.size());
    primvars.Limit(points, limits);
    points.swap(limits);
  }
  Model made;
  for (const Vertex& point : points)
  {
    made.Points.push_back(point.At);
  }
  const Far::TopologyLevel& last = refiner->GetLevel(levels);
  for (int f = 0; f < last.GetNumFaces(); ++f)
  {
    const auto face = last.GetFaceVertices(f);
    made.Faces.emplace_back(face.begin(), face.end());
  }
  return made;
}

/// Its masks or their limits, as a Subdivider.
Subdivider MakeTheirs(bool triangles, bool limit)
{
  return [triangles, limit](const Model& model, int levels)
  { return SubdivideTheirs(model, levels, triangles, limit); };
}

TEST(PeerOpenSubdiv, LoopWithHisWeights)
{
  ExpectSameOnClosedMeshes(
    vtkSurfaceSubdivision::LOOP, true, MakeTheirs(true, false), WithLoopWeights);
}

TEST(PeerOpenSubdiv, LimitsOfLoop)
{
  ExpectSameOnClosedMeshes(vtkSurfaceSubdivision::LOOP, true, MakeTheirs(true, true),
    [](vtkSurfaceSubdivision* filter)
    {
      WithLoopWeights(filter);
      filter->ProjectToLimitOn();
    });
}

TEST(PeerOpenSubdiv, CatmullClark)
{
  ExpectSameOnClosedMeshes(vtkSurfaceSubdivision::CATMULL_CLARK, false, MakeTheirs(false, false));
}

TEST(PeerOpenSubdiv, PlainBoundary)
{
  ExpectSameOnTube(vtkSurfaceSubdivision::LOOP, true, MakeTheirs(true, false), WithLoopWeights);
  ExpectSameOnTube(vtkSurfaceSubdivision::CATMULL_CLARK, false, MakeTheirs(false, false));
}

}
