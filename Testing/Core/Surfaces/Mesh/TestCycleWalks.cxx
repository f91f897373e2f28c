// SPDX-License-Identifier: BSD-3-Clause
// Faster ways around a vertex see what VisitCycle sees, in the same order.
#include "Core/Surfaces/Mesh/CycleWalks.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"
#include "SurfaceTools.h"

using namespace surfacetools;

namespace
{

std::vector<int> GetCorners(const PolygonMesh<int>& mesh, int vertex)
{
  std::vector<int> corners;
  VisitCycle(mesh, mesh.VertexCorners[vertex], [&](const FanStep<int>& step)
    { corners.push_back(step.Forward ? step.Corner : -1 - step.Corner); });
  return corners;
}

std::vector<int> GetRing(const PolygonMesh<int>& mesh, int vertex)
{
  std::vector<int> ring;
  VisitCycle(mesh, mesh.VertexCorners[vertex],
    [&](const FanStep<int>& step)
    {
      ring.push_back(
        mesh.Vertices[step.Forward ? mesh.Next(step.Corner) : mesh.Previous(step.Corner)]);
    });
  return ring;
}

/// The zoo, and spheres some of whose triangles are turned over.
std::map<std::string, Model> MakeModels(bool triangles)
{
  std::map<std::string, Model> models = MakeZoo(triangles);
  for (const auto& [name, model] : MakeZoo(triangles))
  {
    Model turned = model;
    for (std::size_t f = 0; f < turned.Faces.size(); f += 3)
    {
      std::reverse(turned.Faces[f].begin(), turned.Faces[f].end());
    }
    models[name + ", partly turned"] = turned;
  }
  return models;
}

}

TEST(CycleWalks, SeeWhatVisitCycleSees)
{
  int walked = 0;
  for (const bool triangles : { true, false })
  {
    for (const auto& [name, model] : MakeModels(triangles))
    {
      Walk walk(model, triangles ? SurfaceSchemeKind::Loop : SurfaceSchemeKind::CatmullClark);
      for (int step = 0; step < 3; ++step, walk.Step())
      {
        const auto isSmooth = [&](int v)
        { return walk.Level.Tags.Vertices[v] == VertexTag::Smooth && v % 5 != 4; };
        const PolygonMesh<int>& mesh = walk.Level.Mesh;
        const int size = static_cast<int>(mesh.NumberOfVertices);
        CycleWalks<int> walks;
        for (int first = 0; first < size; first += walks.Most)
        {
          const int end = std::min(size, first + walks.Most);
          walks.Walk(mesh, first, end, isSmooth);
          for (int v = first; v < end; ++v)
          {
            std::vector<int> corners;
            for (const FanStep<int>& at : walks.Get(v))
            {
              corners.push_back(at.Forward ? at.Corner : -1 - at.Corner);
            }
            EXPECT_EQ(corners, isSmooth(v) ? GetCorners(mesh, v) : std::vector<int>()) << name;
            walked += isSmooth(v) ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(walked, 1000);
}

TEST(FindRingOfEdgePoint, IsThatOfAWalk)
{
  int found = 0;
  int left = 0;
  for (const auto& [name, model] : MakeModels(true))
  {
    Walk walk(model, SurfaceSchemeKind::Loop);
    for (int step = 1; step < 3; ++step)
    {
      walk.Step();
      const PolygonMesh<int>& mesh = walk.Level.Mesh;
      for (vtkIdType v = walk.Level.VerticesBefore; v < mesh.NumberOfVertices; ++v)
      {
        const int vertex = static_cast<int>(v);
        std::vector<int> ring(6);
        const bool isFound = FindRingOfEdgePoint(mesh, vertex, ring.data());
        if (isFound)
        {
          EXPECT_EQ(ring, GetRing(mesh, vertex)) << name << ", step " << step << ", " << vertex;
        }
        (isFound ? found : left) += 1;
      }
    }
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(left, 100) << "at boundaries and turned triangles";
}

TEST(FindRingOfNewPoint, AreThoseOfAWalk)
{
  int ofEdges = 0;
  int ofFaces = 0;
  int left = 0;
  for (const auto& [name, model] : MakeModels(false))
  {
    Walk walk(model, SurfaceSchemeKind::CatmullClark);
    for (int step = 1; step < 3; ++step)
    {
      const vtkIdType firstOfFaces =
        walk.Level.Mesh.NumberOfVertices + walk.Level.Mesh.GetNumberOfEdges();
      walk.Step();
      const PolygonMesh<int>& mesh = walk.Level.Mesh;
      for (vtkIdType v = walk.Level.VerticesBefore; v < mesh.NumberOfVertices; ++v)
      {
        const int vertex = static_cast<int>(v);
        std::vector<int> found(8);
        if (!FindRingOfNewPoint(mesh, vertex, found.data()))
        {
          ++left;
          continue;
        }
        std::vector<int> wanted;
        VisitCycle(mesh, mesh.VertexCorners[vertex],
          [&](const FanStep<int>& at)
          {
            const int next = mesh.Next(at.Corner);
            wanted.push_back(mesh.Vertices[at.Forward ? next : mesh.Previous(at.Corner)]);
            wanted.push_back(mesh.Vertices[mesh.Next(next)]);
          });
        EXPECT_EQ(found, wanted) << name << ", step " << step << ", " << vertex;
        (v < firstOfFaces ? ofEdges : ofFaces) += 1;
      }
    }
  }
  EXPECT_GT(ofEdges, 300);
  EXPECT_GT(ofFaces, 100);
  EXPECT_GT(left, 100) << "at boundaries, turned faces and faces of other sizes";
}
