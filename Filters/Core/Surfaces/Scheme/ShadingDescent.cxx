// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/ShadingDescent.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace subdivision
{
namespace
{

/// Local matrices are full ones.
constexpr std::size_t MostItems = 200;
/// Where steps around a vertex do not repeat one matrix, stars are taken from the level after so
/// many carrier periods.
constexpr int MostPeriods = 10;

/// The values of a patch of a level around some vertices.
template <typename Id>
class ShadingDescent
{
public:
  ShadingDescent(const SurfaceScheme<Id>& scheme, double* normals)
    : Scheme(scheme)
    , Normals(normals)
  {
  }

  /// `vertices`: ascending.
  void Run(const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases,
    const Buffer<unsigned char>& turned, const double* points, std::vector<Id>&& vertices)
  {
    this->Owners = vertices;
    this->Vertices = std::move(vertices);
    this->Crop(level, creases, points, turned);
    // Only after two steps all further ones have the same rules around a vertex.
    const int most = MostPeriods * this->Scheme.GetCarrierPeriod();
    for (int step = 0; !this->Vertices.empty(); ++step)
    {
      const bool isLast = level.Step + step >= most;
      if (isLast || (step >= 2 && this->Patch->GetSharpEdges().empty()))
      {
        this->Finish(isLast);
      }
      if (!this->Vertices.empty())
      {
        this->Step();
      }
    }
  }

  /// From the level itself.
  static void FindNormal(const PolygonMesh<Id>& mesh, Id vertex, const double* points,
    const Buffer<unsigned char>& turned, double* normal)
  {
    const Around around = Find(mesh, vertex);
    FindNormal(mesh, around, GetEnds(around, points), turned, normal);
  }

private:
  /// The items of a star: the vertex itself, the other ends of its edges, and in quads the corners
  /// opposite to it.
  struct Around
  {
    std::vector<Id> Items;                   ///< vertices of the patch
    std::vector<Id> Rows;                    ///< of the next level, where these become such items
    std::vector<std::array<int, 2>> Corners; ///< the items at both sides of each corner
    std::vector<Id> Faces;                   ///< of each corner
  };

  void Crop(const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases, const double* points,
    const Buffer<unsigned char>& turned)
  {
    std::vector<Id> near = this->Vertices;
    for (const Id vertex : this->Vertices)
    {
      const Around around = Find(level.Mesh, vertex);
      near.insert(near.end(), around.Items.begin(), around.Items.end());
    }
    SortUnique(near);
    this->Patch = std::make_unique<SharpPatch<Id>>(this->Scheme, level, creases, near);
    const PolygonMesh<Id>& mesh = this->Patch->GetLevel().Mesh;
    this->Points.assign(3 * static_cast<std::size_t>(mesh.NumberOfVertices), 0.);
    double* to = this->Points.data();
    for (const Id vertex : this->Patch->GetVertices())
    {
      to = std::copy_n(points + 3 * static_cast<vtkIdType>(vertex), 3, to);
    }
    this->Turned = Buffer<unsigned char>(mesh.NumberOfFaces, 0);
    const std::vector<Id>& faces = this->Patch->GetFaces();
    for (std::size_t f = 0; f < faces.size() && !turned.empty(); ++f)
    {
      this->Turned[f] = turned[faces[f]];
    }
    for (Id& vertex : this->Vertices)
    {
      vertex = this->Patch->FindVertex(vertex);
    }
  }

  void Step()
  {
    SharpCreases<Id> creases;
    const SurfaceLevel<Id> next = this->Patch->Refine(creases);
    const SurfaceLevel<Id>& level = this->Patch->GetLevel();
    std::vector<double> points(3 * static_cast<std::size_t>(next.Mesh.NumberOfVertices));
    RowBlock<Id> row;
    for (vtkIdType v = 0; v < next.Mesh.NumberOfVertices; ++v)
    {
      row.Clear();
      this->Patch->AppendRow(v, row);
      row.Apply(this->Points.data(), points.data() + 3 * v, 3);
    }
    Buffer<unsigned char> turned(next.Mesh.NumberOfFaces);
    for (vtkIdType f = 0; f < turned.size(); ++f)
    {
      turned[f] = this->Turned[this->Scheme.GetOrientingFace(level, f)];
    }
    const std::unique_ptr<SharpPatch<Id>> before = std::move(this->Patch);
    this->Crop(next, creases, points.data(), turned);
  }

  /// The number of an item, which is added if it is none yet.
  static int AddItem(Id item, std::vector<Id>& items)
  {
    const auto found = std::find(items.begin() + 1, items.end(), item);
    const auto number = found - items.begin();
    found == items.end() ? items.push_back(item) : void();
    return static_cast<int>(number);
  }

  static Around Find(const PolygonMesh<Id>& mesh, Id vertex)
  {
    Around around;
    if (mesh.Edges.empty() && mesh.NumberOfFaces > 0) // of a dual scheme: other ends tell them
    {
      around.Items.push_back(vertex);
      VisitFans(mesh, vertex,
        [&](Id fan)
        {
          VisitFan(mesh, fan,
            [&](const FanStep<Id>& step)
            {
              const int begin = AddItem(mesh.Vertices[mesh.Next(step.Corner)], around.Items);
              const int end = AddItem(mesh.Vertices[mesh.Previous(step.Corner)], around.Items);
              around.Corners.push_back({ { begin, end } });
              around.Faces.push_back(mesh.GetFace(step.Corner));
            });
        });
      return around;
    }
    std::vector<Id> edges;
    CollectEdges(mesh, vertex, [](Id) { return true; }, edges);
    around.Items.push_back(vertex);
    around.Rows.push_back(vertex);
    for (const Id edge : edges)
    {
      around.Items.push_back(mesh.GetOtherEnd(edge, vertex));
      around.Rows.push_back(static_cast<Id>(mesh.NumberOfVertices + edge));
    }
    const auto itemOf = [&](Id halfEdge)
    {
      return static_cast<int>(
        1 + (std::find(edges.begin(), edges.end(), mesh.Edges[halfEdge]) - edges.begin()));
    };
    VisitFans(mesh, vertex,
      [&](Id fan)
      {
        VisitFan(mesh, fan,
          [&](const FanStep<Id>& step)
          {
            const Id face = mesh.GetFace(step.Corner);
            around.Corners.push_back(
              { { itemOf(step.Corner), itemOf(mesh.Previous(step.Corner)) } });
            around.Faces.push_back(face);
            if (mesh.GetSize(face) == 4)
            {
              around.Items.push_back(mesh.Vertices[mesh.Next(mesh.Next(step.Corner))]);
              around.Rows.push_back(
                static_cast<Id>(mesh.NumberOfVertices + mesh.GetNumberOfEdges() + face));
            }
          });
      });
    return around;
  }

  /// Finds the normals of the vertices, but unless `all` only where all further steps are one
  /// matrix.
  void Finish(bool all)
  {
    std::vector<Id> rest[2];
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      const PolygonMesh<Id>& mesh = this->Patch->GetLevel().Mesh;
      const Around around = Find(mesh, this->Vertices[i]);
      std::vector<double> ends = GetEnds(around, this->Points.data());
      if (!this->GoOn(around, ends) && !all)
      {
        rest[0].push_back(this->Vertices[i]);
        rest[1].push_back(this->Owners[i]);
        continue;
      }
      FindNormal(mesh, around, ends, this->Turned,
        this->Normals + 3 * static_cast<vtkIdType>(this->Owners[i]));
    }
    this->Vertices = std::move(rest[0]);
    this->Owners = std::move(rest[1]);
  }

  /// The items after the first, seen from this one.
  static std::vector<double> GetEnds(const Around& around, const double* points)
  {
    std::vector<double> ends;
    const double* from = points + 3 * static_cast<vtkIdType>(around.Items[0]);
    for (std::size_t i = 1; i < around.Items.size(); ++i)
    {
      const double* to = points + 3 * static_cast<vtkIdType>(around.Items[i]);
      ends.insert(ends.end(), { to[0] - from[0], to[1] - from[1], to[2] - from[2] });
    }
    return ends;
  }

  /// Makes all further steps at once. False: the items around the vertex are not all that counts.
  bool GoOn(const Around& around, std::vector<double>& ends) const
  {
    const SurfaceLevel<Id>& level = this->Patch->GetLevel();
    const std::size_t size = around.Items.size();
    std::vector<Id> sorted = around.Items;
    std::sort(sorted.begin(), sorted.end());
    const bool hasFacePoints = level.Mesh.Arity == 4;
    if (size > MostItems || !this->Scheme.HalvesEdges() || this->Scheme.IsDual() ||
      std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end() ||
      this->Scheme.GetNumberOfRows(level) !=
        level.Mesh.NumberOfVertices + level.Mesh.GetNumberOfEdges() +
          (hasFacePoints ? level.Mesh.NumberOfFaces : 0))
    {
      return false;
    }
    std::vector<double> matrix(size * size, 0.);
    RowBlock<Id> row;
    for (std::size_t i = 0; i < size; ++i)
    {
      row.Clear();
      this->Patch->AppendRow(around.Rows[i], row);
      for (std::size_t k = 0; k < row.GetNumberOfEntries(); ++k)
      {
        const auto item = std::find(around.Items.begin(), around.Items.end(), row.GetColumns()[k]);
        if (item == around.Items.end() && row.GetWeights()[k] != 0.)
        {
          return false;
        }
        matrix[i * size + static_cast<std::size_t>(item - around.Items.begin())] +=
          row.GetWeights()[k];
      }
    }
    const std::vector<double> rows = FindStarRows(matrix, size, around.Corners, level.Step);
    std::vector<double> later(ends.size(), 0.);
    for (std::size_t i = 0; i + 1 < size; ++i)
    {
      for (std::size_t k = 0; k + 1 < size; ++k)
      {
        for (int c = 0; c < 3; ++c)
        {
          later[3 * i + c] += rows[i * size + k + 1] * ends[3 * k + c];
        }
      }
    }
    ends = std::move(later);
    return true;
  }

  static void FindNormal(const PolygonMesh<Id>& mesh, const Around& around,
    const std::vector<double>& ends, const Buffer<unsigned char>& turned, double* normal)
  {
    ShadingStar star;
    const auto getEnd = [&](std::size_t item) { return ends.data() + 3 * (item - 1); };
    std::size_t across = around.Items.size();
    for (const Id face : around.Faces)
    {
      across -= mesh.GetSize(face) == 4 ? 1 : 0;
    }
    for (std::size_t i = 1; i < across; ++i)
    {
      star.AddLine(getEnd(i));
    }
    for (std::size_t i = 0; i < around.Faces.size(); ++i)
    {
      const double* a = getEnd(around.Corners[i][0]);
      const double* b = getEnd(around.Corners[i][1]);
      const bool isQuad = mesh.GetSize(around.Faces[i]) == 4;
      const double* far = isQuad ? getEnd(across++) : nullptr;
      double middle[3];
      for (int c = 0; c < 3; ++c)
      {
        middle[c] = isQuad ? (a[c] + b[c] + far[c]) / 4. : (a[c] + b[c]) / 3.;
      }
      star.AddCorner(a, b, middle, !turned.empty() && turned[around.Faces[i]] ? -1. : 1.);
    }
    star.FindNormal(normal);
  }

  const SurfaceScheme<Id>& Scheme;
  double* const Normals;
  std::vector<Id> Vertices; ///< of the patch
  std::vector<Id> Owners;   ///< their ids on the level
  std::unique_ptr<SharpPatch<Id>> Patch;
  std::vector<double> Points;   ///< of the patch
  Buffer<unsigned char> Turned; ///< faces of the patch
};

}

template <typename Id>
void FindShadingNormals(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const Buffer<unsigned char>& turned,
  const Buffer<unsigned char>& missing, const double* points, double* normals)
{
  std::vector<Id> vertices;
  ForEachInTurn(missing.size(),
    [&](vtkIdType v)
    {
      double* tangent = normals + 3 * v;
      if (!missing[v])
      {
        return;
      }
      if (GetFirstFan(level.Mesh, static_cast<Id>(v)) < 0 &&
        std::any_of(tangent, tangent + 3, [](double value) { return value != 0.; }))
      {
        FindPerpendicular(tangent, tangent);
      }
      else if (!scheme.HasLimitStars())
      {
        ShadingDescent<Id>::FindNormal(
          level.Mesh, static_cast<Id>(v), points, turned, normals + 3 * v);
      }
      else
      {
        vertices.push_back(static_cast<Id>(v));
      }
    });
  constexpr vtkIdType block = 64;
  const auto size = static_cast<vtkIdType>(vertices.size());
  ForRangesOfBlocks((size + block - 1) / block,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType b = begin; b < end; ++b)
      {
        ShadingDescent<Id>(scheme, normals)
          .Run(level, creases, turned, points,
            { vertices.begin() + b * block, vertices.begin() + std::min(size, (b + 1) * block) });
      }
    });
}

SUBDIVISION_COMPILE_FUNCTION(FindShadingNormals);

}
