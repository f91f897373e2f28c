// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/FaceStars.h"

#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Smoothness/LocalMatrix.h"
#include "Core/Smoothness/MapSamples.h"
#include "Core/Smoothness/SurfaceStarLevels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

using Place = MapPlace;
using Matrix = SurfaceStarLevels::Matrix;

/// The face in the middle of a level of a dual scheme, around which all is symmetric.
int FindMiddle(const PolygonMesh<int>& mesh, const std::vector<Place>& points)
{
  int best = 0;
  double least = 1e300;
  for (int face = 0; face < mesh.NumberOfFaces; ++face)
  {
    Place sum{ { 0., 0. } };
    const int first = mesh.GetFirst(face);
    const int size = mesh.GetSize(face);
    for (int k = first; k < first + size; ++k)
    {
      sum[0] += points[mesh.Vertices[k]][0] / size;
      sum[1] += points[mesh.Vertices[k]][1] / size;
    }
    const double distance = std::hypot(sum[0], sum[1]);
    best = distance < least ? face : best;
    least = std::min(least, distance);
  }
  return best;
}

std::vector<int> GetCorners(const PolygonMesh<int>& mesh, int face)
{
  const int* corners = mesh.Vertices.data() + mesh.GetFirst(face);
  return { corners, corners + mesh.GetSize(face) };
}

/// The vertices of the faces up to some edges away from the face of a corner. Their order starts
/// there, and is the same in meshes that are alike.
std::vector<int> Walk(const PolygonMesh<int>& mesh, int corner, int distance)
{
  std::vector<int> vertices;
  std::vector<char> isTaken(static_cast<std::size_t>(mesh.NumberOfVertices), 0);
  std::vector<char> isSeen(static_cast<std::size_t>(mesh.NumberOfFaces), 0);
  std::vector<int> entries{ corner };
  isSeen[mesh.GetFace(corner)] = 1;
  for (int layer = 0; layer <= distance; ++layer)
  {
    std::vector<int> next;
    for (const int entry : entries)
    {
      int at = entry;
      do
      {
        const int vertex = mesh.Vertices[at];
        if (!isTaken[vertex])
        {
          isTaken[vertex] = 1;
          vertices.push_back(vertex);
        }
        const int twin = mesh.Twins[at];
        if (twin >= 0 && !isSeen[mesh.GetFace(twin)])
        {
          isSeen[mesh.GetFace(twin)] = 1;
          next.push_back(twin);
        }
        at = mesh.Next(at);
      } while (at != entry);
    }
    entries = std::move(next);
  }
  return vertices;
}

/// Steps around the face in the middle.
class FaceStar
{
public:
  /// `periods`: that are made after the second level. `distance`: how many edges away from the face
  /// in the middle the faces are whose corners belong to the map.
  FaceStar(const SurfaceStar& star, int periods, int distance)
    : Star(star)
    , Distance(distance)
    , Repeats(GetPeriod(star.Scheme))
    , Last(Here + Repeats.Steps * periods)
    , Mesh(star.Faces, 2. * Pi, true)
    , Made(star, Mesh, Last)
  {
    this->Points.push_back(this->Mesh.GetPlaces());
    for (int step = 0; step < this->Last; ++step)
    {
      this->Points.push_back(this->Made.Apply(step, step + 1, this->Points.back()));
    }
  }

  SmoothnessFacts Examine(bool samples) const
  {
    std::vector<int> order;
    SmoothnessFacts facts = this->FindEigenvalues(order);
    const std::vector<Place> map = samples ? this->FindMap(facts, order) : std::vector<Place>();
    if (!map.empty())
    {
      this->Sample(map, facts);
    }
    return facts;
  }

  StarMap MakeMap() const
  {
    std::vector<int> order;
    const SmoothnessFacts facts = this->FindEigenvalues(order);
    const std::vector<Place> points = this->FindMap(facts, order);
    StarMap map = points.empty() ? StarMap() : this->MakeMap(points);
    map.Facts = facts;
    return map;
  }

private:
  static constexpr int Here = 2; ///< the level whose face in the middle is examined

  int FindMiddleOf(int level) const
  {
    return FindMiddle(this->Made.Get(level).Mesh, this->Points[level]);
  }

  SmoothnessFacts FindEigenvalues(std::vector<int>& order) const
  {
    SmoothnessFacts facts;
    facts.Valence = this->Star.Faces;
    LocalMatrix matrix;
    if (this->MakeMatrix(matrix, order))
    {
      std::vector<double> moduli = matrix.FindModuli();
      facts.SetEigenvalues(moduli);
      moduli.resize(std::max<std::size_t>(moduli.size(), 4), 0.);
      moduli[3] = std::max(moduli[3], 1. / 4.);
      facts.Condition = HoldsInside(moduli, 2);
    }
    return facts;
  }

  /// Of the corners of the face. `order`: for each of its new corners the old one in its place,
  /// which it reads most.
  bool MakeMatrix(LocalMatrix& matrix, std::vector<int>& order) const
  {
    const int later = Here + this->Repeats.Steps;
    const std::vector<int> here = GetCorners(this->Made.Get(Here).Mesh, this->FindMiddleOf(Here));
    const std::vector<int> there =
      GetCorners(this->Made.Get(later).Mesh, this->FindMiddleOf(later));
    const Matrix steps = this->Made.GetSteps(Here, later);
    const int size = static_cast<int>(here.size());
    matrix = LocalMatrix(size);
    for (const int row : there)
    {
      std::vector<double> weights(size, 0.);
      for (vtkIdType k = steps.Offsets[row]; k < steps.Offsets[row + 1]; ++k)
      {
        const auto at = std::find(here.begin(), here.end(), steps.Columns[k]);
        weights[at == here.end() ? 0 : at - here.begin()] +=
          at == here.end() ? 0. : steps.Weights[k];
      }
      const auto own =
        static_cast<int>(std::max_element(weights.begin(), weights.end()) - weights.begin());
      if (std::abs(std::accumulate(weights.begin(), weights.end(), 0.) - 1.) > 1e-9 ||
        std::find(order.begin(), order.end(), own) != order.end())
      {
        return false;
      }
      order.push_back(own);
      for (int column = 0; column < size; ++column)
      {
        matrix.At(own, column) = weights[column];
      }
    }
    return true;
  }

  /// Of all that lies around the face. `first`: the old corner in the place of the first new one.
  bool MakeMatrixAround(int first, LocalMatrix& matrix, std::vector<int>& vertices) const
  {
    const int later = Here + this->Repeats.Steps;
    const PolygonMesh<int>& before = this->Made.Get(Here).Mesh;
    const PolygonMesh<int>& after = this->Made.Get(later).Mesh;
    vertices = Walk(before, before.GetFirst(this->FindMiddleOf(Here)) + first, this->Distance);
    const std::vector<int> made =
      Walk(after, after.GetFirst(this->FindMiddleOf(later)), this->Distance);
    const auto size = static_cast<int>(vertices.size());
    if (size > LocalMatrix::MostItems || made.size() != vertices.size())
    {
      return false;
    }
    std::vector<int> columns(static_cast<std::size_t>(before.NumberOfVertices), -1);
    for (int i = 0; i < size; ++i)
    {
      columns[vertices[i]] = i;
    }
    const Matrix steps = this->Made.GetSteps(Here, later);
    matrix = LocalMatrix(size);
    bool isClosed = true;
    for (int i = 0; i < size; ++i)
    {
      for (vtkIdType k = steps.Offsets[made[i]]; k < steps.Offsets[made[i] + 1]; ++k)
      {
        const int column = columns[steps.Columns[k]];
        isClosed = isClosed && column >= 0;
        if (column >= 0)
        {
          matrix.At(i, column) += steps.Weights[k];
        }
      }
    }
    return isClosed;
  }

  /// Where the map takes the vertices of the last level; unknown places are no numbers. Empty if
  /// there is no map. `order` as in MakeMatrix.
  std::vector<Place> FindMap(const SmoothnessFacts& facts, const std::vector<int>& order) const
  {
    LocalMatrix matrix;
    std::vector<int> vertices;
    const std::vector<double> basis =
      facts.Condition == Answer::Yes && this->MakeMatrixAround(order[0], matrix, vertices)
      ? matrix.FindLeading(2)
      : std::vector<double>();
    return basis.empty()
      ? std::vector<Place>()
      : this->Made.Apply(Here, this->Last, PlaceValues(basis, vertices, this->Points[Here].size()));
  }

  /// The length of an edge of the last level.
  double GetEdge() const
  {
    double edge = 1.;
    for (int step = Here; step < this->Last; step += this->Repeats.Steps)
    {
      edge /= this->Repeats.Factor;
    }
    return edge;
  }

  static Place FindCentre(const std::vector<Place>& map, const std::vector<int>& corners)
  {
    Place middle{ { 0., 0. } };
    for (const int corner : corners)
    {
      for (int c = 0; c < 2; ++c)
      {
        middle[c] += map[corner][c] / static_cast<double>(corners.size());
      }
    }
    return middle;
  }

  /// `map` as FindMap makes it.
  void Sample(std::vector<Place> map, SmoothnessFacts& facts) const
  {
    const PolygonMesh<int>& mesh = this->Made.Get(this->Last).Mesh;
    const std::vector<int> corners = GetCorners(mesh, this->FindMiddleOf(this->Last));
    const double edge = this->GetEdge();
    const std::vector<double> rings = this->FindRings(corners, edge);
    const auto isNear = [&](int vertex, double least, double most)
    {
      const double away = rings[vertex] + edge / 2.;
      return away > least - 1e-6 && away < most + 1e-6;
    };
    std::vector<std::array<int, 3>> triangles;
    for (const int face : InTurn(static_cast<int>(mesh.NumberOfFaces)))
    {
      const std::vector<int> ids = GetCorners(mesh, face);
      if (std::any_of(ids.begin(), ids.end(), [&](int v) { return isNear(v, 1., 2.); }))
      {
        for (std::size_t k = 0; k < ids.size(); ++k)
        {
          triangles.push_back({ { ids[k], ids[(k + 1) % ids.size()], ids[(k + 2) % ids.size()] } });
        }
      }
    }
    std::vector<std::pair<double, int>> ring;
    const std::vector<Place>& places = this->Points.back();
    for (int v = 0; v < static_cast<int>(places.size()); ++v)
    {
      if (isNear(v, 2., 2.))
      {
        ring.emplace_back(std::atan2(places[v][1], places[v][0]), v);
      }
    }
    std::sort(ring.begin(), ring.end());
    std::vector<int> sorted;
    for (const auto& [turn, vertex] : ring)
    {
      sorted.push_back(vertex);
    }
    const Place middle = FindCentre(map, corners);
    for (Place& place : map)
    {
      place = { { place[0] - middle[0], place[1] - middle[1] } };
    }
    SetSamples(map, triangles, sorted, false, facts);
  }

  StarMap MakeMap(const std::vector<Place>& map) const
  {
    const double edge = this->GetEdge();
    const PolygonMesh<int>& mesh = this->Made.Get(this->Last).Mesh;
    const std::vector<int> corners = GetCorners(mesh, this->FindMiddleOf(this->Last));
    std::vector<StarMap::Point> points;
    for (const Place& place : map)
    {
      points.push_back({ { place[0], place[1], 0. } });
    }
    // Two more points, of no cell: the middle, and the middle of an edge.
    const Place middle = FindCentre(map, corners);
    const Place ofEdge = FindCentre(map, { corners[0], corners[1] });
    points.push_back({ { middle[0], middle[1], 0. } });
    points.push_back({ { ofEdge[0], ofEdge[1], 0. } });
    std::vector<double> rings = this->FindRings(corners, edge);
    rings.push_back(0.);
    rings.push_back(edge / 2.);
    const auto size = static_cast<int>(map.size());
    StarMapMaker maker(2, std::move(points), std::move(rings));
    for (const int face : InTurn(static_cast<int>(mesh.NumberOfFaces)))
    {
      maker.AddCell(mesh.Vertices.data() + mesh.GetFirst(face), mesh.GetSize(face),
        mesh.GetSize(face) * edge * edge / 4.);
    }
    return maker.Make(size, size + 1, size + 1);
  }

  /// Half an edge at the corners of the face in the middle, and an edge more for each edge from
  /// there.
  std::vector<double> FindRings(std::vector<int> front, double edge) const
  {
    const PolygonMesh<int>& mesh = this->Made.Get(this->Last).Mesh;
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(mesh.NumberOfVertices));
    for (const int corner : InTurn(static_cast<int>(mesh.GetNumberOfCorners())))
    {
      const int from = mesh.Vertices[corner];
      const int to = mesh.Vertices[mesh.Next(corner)];
      neighbours[from].push_back(to);
      neighbours[to].push_back(from);
    }
    std::vector<double> rings(neighbours.size(), 0.);
    for (double ring = edge / 2.; !front.empty(); ring += edge)
    {
      std::vector<int> next;
      for (const int vertex : front)
      {
        rings[vertex] = rings[vertex] > 0. ? rings[vertex] : ring;
      }
      for (const int vertex : front)
      {
        for (const int neighbour : neighbours[vertex])
        {
          if (rings[neighbour] == 0.)
          {
            rings[neighbour] = ring + edge;
            next.push_back(neighbour);
          }
        }
      }
      front = std::move(next);
    }
    return rings;
  }

  const SurfaceStar Star;
  const int Distance;
  const Period Repeats;
  const int Last; ///< level
  const StarMesh Mesh;
  const SurfaceStarLevels Made;
  std::vector<std::vector<Place>> Points; ///< the flat mesh after each step
};

}

SmoothnessFacts ExamineFace(const SurfaceStar& star, bool samples)
{
  return FaceStar(star, samples ? 2 : 1, SampledDistance).Examine(samples);
}

StarMap MapFace(const SurfaceStar& star, int levels)
{
  return FaceStar(star, std::max(1, levels), MappedDistance).MakeMap();
}

}
