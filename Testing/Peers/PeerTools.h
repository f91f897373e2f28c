// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerTools.h
 * Closed meshes for comparisons with other libraries, and the comparison: points are matched by
 * place, then faces by their points.
 */
#ifndef PeerTools_h
#define PeerTools_h

#include "SurfaceTools.h"

#include <functional>

namespace peertools
{

using surfacetools::Model;
using surfacetools::Point;

/// Two poles and k points around.
inline Model MakeBipyramid(int k)
{
  Model model;
  model.Points.resize(static_cast<std::size_t>(k) + 2);
  for (int i = 0; i < k; ++i)
  {
    model.Faces.push_back({ i, (i + 1) % k, k });
    model.Faces.push_back({ (i + 1) % k, i, k + 1 });
  }
  return model;
}

/// Two faces of k sides, and quads between them.
inline Model MakePrism(int k)
{
  Model model;
  model.Points.resize(2 * static_cast<std::size_t>(k));
  model.Faces.resize(2);
  for (int i = 0; i < k; ++i)
  {
    model.Faces[0].push_back(k - 1 - i);
    model.Faces[1].push_back(k + i);
    model.Faces.push_back({ i, (i + 1) % k, k + (i + 1) % k, k + i });
  }
  return model;
}

/// Two poles, k quads around each: vertices of k and of three faces.
inline Model MakeTrapezohedron(int k)
{
  Model model;
  model.Points.resize(2 * static_cast<std::size_t>(k) + 2);
  for (int i = 0; i < k; ++i)
  {
    model.Faces.push_back({ 2 * k, 2 * i, 2 * i + 1, 2 * ((i + 1) % k) });
    model.Faces.push_back({ 2 * k + 1, 2 * ((i + 1) % k) + 1, 2 * ((i + 1) % k), 2 * i + 1 });
  }
  return model;
}

/// Everything is regular.
inline Model MakeTorus(int width, int height, bool triangles)
{
  Model model;
  model.Points.resize(static_cast<std::size_t>(width * height));
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      auto id = [&](int a, int b) -> vtkIdType { return (b % height) * width + a % width; };
      const vtkIdType quad[4] = { id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1) };
      if (triangles)
      {
        model.Faces.push_back({ quad[0], quad[1], quad[2] });
        model.Faces.push_back({ quad[0], quad[2], quad[3] });
      }
      else
      {
        model.Faces.push_back({ quad[0], quad[1], quad[2], quad[3] });
      }
    }
  }
  return model;
}

/// Each triangle is three: vertices of three faces, and of twice as many as there were.
inline Model SplitTriangles(const Model& model)
{
  Model made;
  made.Points.resize(model.Points.size() + model.Faces.size());
  vtkIdType centre = static_cast<vtkIdType>(model.Points.size());
  for (const auto& f : model.Faces)
  {
    made.Faces.insert(
      made.Faces.end(), { { f[0], f[1], centre }, { f[1], f[2], centre }, { f[2], f[0], centre } });
    ++centre;
  }
  return made;
}

/// Closed meshes with random points. All numbers of faces at a vertex from 3 to 24 occur, around
/// poles and, where triangles are split, beside each other.
inline std::map<std::string, Model> MakeClosedMeshes(bool triangles)
{
  std::map<std::string, Model> meshes;
  meshes["tetrahedron"].Faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  meshes["tetrahedron"].Points.resize(4);
  meshes["torus"] = MakeTorus(5, 4, triangles);
  for (int k = 3; k <= 24; ++k)
  {
    meshes["bipyramid " + std::to_string(k)] = MakeBipyramid(k);
    if (k <= 12)
    {
      meshes["split bipyramid " + std::to_string(k)] = SplitTriangles(MakeBipyramid(k));
    }
    if (!triangles)
    {
      meshes["prism " + std::to_string(k)] = MakePrism(k);
      meshes["trapezohedron " + std::to_string(k)] = MakeTrapezohedron(k);
    }
  }
  unsigned seed = 40;
  for (auto& entry : meshes)
  {
    entry.second.Points = surfacetools::MakeRandomPoints(entry.second.Points.size(), ++seed);
  }
  return meshes;
}

/// What a test sets in our filter beside scheme and levels.
using Configure = std::function<void(vtkSurfaceSubdivision*)>;

/// The other libraries have the weights of Loop's thesis.
inline void WithLoopWeights(vtkSurfaceSubdivision* filter)
{
  filter->SetLoopWeightsToLoop();
}

/// What our filter makes of a mesh.
inline Model Subdivide(
  const Model& model, int scheme, int levels, const Configure& configure = nullptr)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(surfacetools::MakeInput(model));
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(levels);
  if (configure)
  {
    configure(filter);
  }
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  Model made;
  made.Points.resize(static_cast<std::size_t>(output->GetNumberOfPoints()));
  for (std::size_t i = 0; i < made.Points.size(); ++i)
  {
    output->GetPoint(static_cast<vtkIdType>(i), made.Points[i].data());
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < output->GetNumberOfPolys(); ++c)
  {
    output->GetCellPoints(c, ids);
    made.Faces.emplace_back(ids->begin(), ids->end());
  }
  return made;
}

/// The points of dual schemes that lie on the surface: the input's go unused.
inline Model DropUnused(const Model& model)
{
  std::map<vtkIdType, vtkIdType> ids;
  Model made;
  for (std::vector<vtkIdType> face : model.Faces)
  {
    for (vtkIdType& id : face)
    {
      const auto found = ids.emplace(id, static_cast<vtkIdType>(ids.size()));
      if (found.second)
      {
        made.Points.push_back(model.Points[id]);
      }
      id = found.first->second;
    }
    made.Faces.push_back(face);
  }
  return made;
}

/// For each point of a, the only one of b that is not farther than a tolerance.
inline std::vector<vtkIdType> MatchPoints(const Model& a, const Model& b, double tolerance)
{
  std::vector<std::size_t> order(b.Points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::sort(order.begin(), order.end(),
    [&b](std::size_t p, std::size_t q) { return b.Points[p][0] < b.Points[q][0]; });
  std::vector<vtkIdType> matches;
  std::set<vtkIdType> used;
  for (const Point& point : a.Points)
  {
    auto at = std::lower_bound(order.begin(), order.end(), point[0] - tolerance,
      [&b](std::size_t p, double x) { return b.Points[p][0] < x; });
    vtkIdType match = -1;
    for (; at != order.end() && b.Points[*at][0] <= point[0] + tolerance; ++at)
    {
      if (surfacetools::GetDistance(point, b.Points[*at]) <= tolerance)
      {
        EXPECT_LT(match, 0) << "two points in one place";
        match = static_cast<vtkIdType>(*at);
      }
    }
    EXPECT_TRUE(match >= 0 && used.insert(match).second) << "point " << matches.size();
    matches.push_back(match);
  }
  return matches;
}

inline std::multiset<std::vector<vtkIdType>> CollectFaces(
  const Model& model, const std::function<vtkIdType(vtkIdType)>& rename)
{
  std::multiset<std::vector<vtkIdType>> faces;
  for (std::vector<vtkIdType> face : model.Faces)
  {
    std::transform(face.begin(), face.end(), face.begin(), rename);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.insert(face);
  }
  return faces;
}

/// The same points, to 1e-12, and the same faces, with the same orientation.
inline void ExpectSame(const Model& ours, const Model& theirs)
{
  ASSERT_EQ(ours.Points.size(), theirs.Points.size());
  ASSERT_EQ(ours.Faces.size(), theirs.Faces.size());
  const std::vector<vtkIdType> matches = MatchPoints(ours, theirs, 1e-12);
  ASSERT_FALSE(testing::Test::HasFailure());
  EXPECT_EQ(CollectFaces(ours, [&](vtkIdType i) { return matches[i]; }),
    CollectFaces(theirs, [](vtkIdType i) { return i; }));
}

using Subdivider = std::function<Model(const Model&, int levels)>;

/// Our filter and another library, after one to three steps, on all closed meshes.
inline void ExpectSameOnClosedMeshes(
  int scheme, bool triangles, const Subdivider& theirs, const Configure& configure = nullptr)
{
  for (const auto& entry : MakeClosedMeshes(triangles))
  {
    for (int levels = 1; levels <= 3; ++levels)
    {
      SCOPED_TRACE(entry.first + ", levels: " + std::to_string(levels));
      ExpectSame(DropUnused(Subdivide(entry.second, scheme, levels, configure)),
        theirs(entry.second, levels));
      if (testing::Test::HasFailure())
      {
        return;
      }
    }
  }
}

/// A tube, with boundary: where curves have the plain rules, they are those of others too.
inline void ExpectSameOnTube(
  int scheme, bool triangles, const Subdivider& theirs, const Configure& configure = nullptr)
{
  Model tube = MakeTorus(6, 4, triangles);
  tube.Faces.resize(tube.Faces.size() * 3 / 4); // rows of faces come one after another
  tube.Points = surfacetools::MakeRandomPoints(tube.Points.size(), 70);
  const auto plain = [&configure](vtkSurfaceSubdivision* filter)
  {
    filter->ModifiedBoundaryOff();
    if (configure)
    {
      configure(filter);
    }
  };
  for (int levels = 1; levels <= 3; ++levels)
  {
    SCOPED_TRACE("tube, levels: " + std::to_string(levels));
    ExpectSame(Subdivide(tube, scheme, levels, plain), theirs(tube, levels));
  }
}

}

#endif
