// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/PairIndex.h"
#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <utility>

namespace subdivision
{
namespace
{

/// Finds the edges of half-edges and segments.
template <typename Id>
class EdgeSearch
{
public:
  EdgeSearch(PolygonMesh<Id>& mesh, const Buffer<Id>& segments)
    : Mesh(mesh)
    , Segments(segments)
    , Corners(mesh.GetNumberOfCorners())
  {
  }

  void Run(Buffer<Id>& segmentEdges)
  {
    const PairIndex<Id> index(this->Corners + this->Segments.size() / 2,
      this->Mesh.NumberOfVertices, [this](const auto& use) { this->ForPairs(use); });
    const vtkIdType edges = index.GetNumberOfRanks();
    this->Mesh.EdgeVertices = Buffer<Id>(2 * edges);
    this->Mesh.EdgeCorners = Buffer<Id>(edges);
    this->Mesh.Edges = Buffer<Id>(this->Corners);
    this->Mesh.Twins = Buffer<Id>(this->Corners);
    segmentEdges = Buffer<Id>(this->Segments.size() / 2);
    std::atomic<bool> hasSheaves(false);
    index.ForRanks(
      [&](Id edge, Id, const Entry* begin, const Entry* end)
      {
        if (this->SetEdge(edge, begin, end, segmentEdges) > 2)
        {
          hasSheaves = true;
        }
      });
    if (hasSheaves)
    {
      this->FindSheaves();
    }
  }

private:
  using Entry = PairEntry<Id>;

  /// Calls use(pair, smaller end, larger end) for all half-edges, then for segments.
  template <typename Use>
  void ForPairs(const Use& use) const
  {
    const Id* const vertices = this->Mesh.Vertices.data();
    ForEachInTurn(this->Mesh.NumberOfFaces,
      [&](vtkIdType face)
      {
        const vtkIdType first = this->Mesh.GetFirst(static_cast<Id>(face));
        const vtkIdType last = first + this->Mesh.GetSize(static_cast<Id>(face)) - 1;
        for (vtkIdType corner = first; corner < last; ++corner)
        {
          use(corner, std::min(vertices[corner], vertices[corner + 1]),
            std::max(vertices[corner], vertices[corner + 1]));
        }
        use(last, std::min(vertices[last], vertices[first]),
          std::max(vertices[last], vertices[first]));
      });
    ForEachInTurn(this->Segments.size() / 2,
      [&](vtkIdType segment)
      {
        const Id* ends = this->Segments.data() + 2 * segment;
        use(this->Corners + segment, std::min(ends[0], ends[1]), std::max(ends[0], ends[1]));
      });
  }
  std::pair<Id, Id> GetEnds(vtkIdType pair) const
  {
    if (pair < this->Corners)
    {
      const Id corner = static_cast<Id>(pair);
      return { this->Mesh.Vertices[corner], this->Mesh.Vertices[this->Mesh.Next(corner)] };
    }
    const Id* ends = this->Segments.data() + 2 * (pair - this->Corners);
    return { ends[0], ends[1] };
  }
  /// Some half-edges and segments are one edge; it runs as the first of them does. Returns how many
  /// half-edges there are: they come before segments.
  Id SetEdge(Id edge, const Entry* begin, const Entry* end, Buffer<Id>& segmentEdges)
  {
    const Id first = begin->GetPair();
    const std::pair<Id, Id> ends = this->GetEnds(first);
    this->Mesh.EdgeVertices[2 * vtkIdType(edge)] = ends.first;
    this->Mesh.EdgeVertices[2 * vtkIdType(edge) + 1] = ends.second;
    Id corners = 0;
    for (const Entry* entry = begin; entry < end; ++entry)
    {
      const Id pair = entry->GetPair();
      if (pair < this->Corners)
      {
        this->Mesh.Edges[pair] = edge;
        this->Mesh.Twins[pair] = -1;
        ++corners;
      }
      else
      {
        segmentEdges[pair - this->Corners] =
          2 * edge + (this->GetEnds(pair).first == ends.first ? 0 : 1);
      }
    }
    this->Mesh.EdgeCorners[edge] = corners > 0 ? first : -1;
    if (corners == 2)
    {
      this->Mesh.Twins[first] = begin[1].GetPair();
      this->Mesh.Twins[begin[1].GetPair()] = first;
    }
    return corners;
  }

  /// Lists the edges of three or more faces.
  void FindSheaves()
  {
    std::vector<std::pair<Id, Id>> found; // edges with their corners beyond the first
    ForEachInTurn(this->Corners,
      [&](vtkIdType corner)
      {
        const Id edge = this->Mesh.Edges[corner];
        if (this->Mesh.Twins[corner] < 0 && this->Mesh.EdgeCorners[edge] != corner)
        {
          found.emplace_back(edge, static_cast<Id>(corner));
        }
      });
    StableSort(found, std::less<>());
    for (const auto& item : InTurn(found))
    {
      auto& sheaves = this->Mesh.Sheaves;
      if (sheaves.empty() || sheaves.back().Edge != item.first)
      {
        sheaves.push_back({ item.first, { this->Mesh.EdgeCorners[item.first] } });
      }
      sheaves.back().Corners.push_back(item.second);
    }
  }

  PolygonMesh<Id>& Mesh;
  const Buffer<Id>& Segments;
  const vtkIdType Corners;
};

/// How many faces the fan of a corner has: one walk around a vertex where it is a cycle, else one
/// to either side.
template <typename Id>
Id CountFan(const PolygonMesh<Id>& mesh, Id corner)
{
  Id count = 1;
  for (FanStep<Id> step{ corner, true }; step.Advance(mesh); ++count)
  {
    if (step.Corner == corner)
    {
      return count;
    }
  }
  for (FanStep<Id> step{ corner, false }; step.Advance(mesh);)
  {
    ++count;
  }
  return count;
}

/// Sets VertexCorners and Joints.
template <typename Id>
void FindFans(PolygonMesh<Id>& mesh)
{
  const vtkIdType vertices = mesh.NumberOfVertices;
  Buffer<Id> counts(vertices, 0);
  mesh.VertexCorners = Buffer<Id>(vertices, static_cast<Id>(-1));
  const vtkIdType last = mesh.GetNumberOfCorners() - 1;
  ForEachInTurn(last + 1,
    [&](vtkIdType fromLast)
    {
      const Id vertex = mesh.Vertices[last - fromLast];
      mesh.VertexCorners[vertex] = static_cast<Id>(last - fromLast);
      ++counts[vertex];
    });
  Buffer<unsigned char> isJoint(vertices);
  ForEach(vertices,
    [&](vtkIdType v)
    {
      const Id corner = mesh.VertexCorners[v];
      isJoint[v] = corner >= 0 && CountFan(mesh, corner) != counts[v];
    });
  for (const auto& sheaf : InTurn(mesh.Sheaves))
  {
    isJoint[mesh.EdgeVertices[2 * sheaf.Edge]] = 1;
    isJoint[mesh.EdgeVertices[2 * sheaf.Edge + 1]] = 1;
  }
  std::vector<Id> freeEdges;
  ForEachInTurn(mesh.GetNumberOfEdges(),
    [&](vtkIdType e)
    {
      if (mesh.EdgeCorners[e] < 0)
      {
        freeEdges.push_back(static_cast<Id>(e));
        isJoint[mesh.EdgeVertices[2 * e]] = 1;
        isJoint[mesh.EdgeVertices[2 * e + 1]] = 1;
      }
    });
  ForEachInTurn(vertices,
    [&](vtkIdType v)
    {
      if (isJoint[v])
      {
        mesh.VertexCorners[v] = static_cast<Id>(-2 - static_cast<vtkIdType>(mesh.Joints.size()));
        mesh.Joints.push_back({ static_cast<Id>(v), {}, {} });
      }
    });
  if (mesh.Joints.empty())
  {
    return;
  }
  auto jointOf = [&mesh](Id v) -> auto& { return mesh.Joints[-2 - mesh.VertexCorners[v]]; };
  for (Id edge : InTurn(freeEdges))
  {
    jointOf(mesh.EdgeVertices[2 * edge]).FreeEdges.push_back(edge);
    jointOf(mesh.EdgeVertices[2 * edge + 1]).FreeEdges.push_back(edge);
  }
  std::vector<std::vector<Id>> corners(mesh.Joints.size());
  for (const vtkIdType c : InTurn(mesh.GetNumberOfCorners()))
  {
    const Id joint = -2 - mesh.VertexCorners[mesh.Vertices[c]];
    if (joint >= 0)
    {
      corners[joint].push_back(static_cast<Id>(c));
    }
  }
  for (const std::size_t j : InTurn(mesh.Joints.size()))
  {
    std::vector<bool> seen(corners[j].size(), false);
    for (std::size_t i = 0; i < corners[j].size(); ++i)
    {
      if (!seen[i])
      {
        mesh.Joints[j].Fans.push_back(corners[j][i]);
        VisitFan(mesh, corners[j][i],
          [&](const FanStep<Id>& step)
          {
            const auto at = std::lower_bound(corners[j].begin(), corners[j].end(), step.Corner);
            seen[at - corners[j].begin()] = true;
          });
      }
    }
  }
}

}

template <typename Id>
std::size_t PolygonMesh<Id>::GetMemorySize() const
{
  return this->FaceOffsets.GetMemorySize() + this->CornerFaces.GetMemorySize() +
    this->Vertices.GetMemorySize() + this->Edges.GetMemorySize() + this->Twins.GetMemorySize() +
    this->EdgeVertices.GetMemorySize() + this->EdgeCorners.GetMemorySize() +
    this->VertexCorners.GetMemorySize() + sizeof(Joint) * this->Joints.size() +
    sizeof(Sheaf) * this->Sheaves.size();
}

template <typename Id>
PolygonMesh<Id> BuildPolygonMesh(PolygonList<Id>&& list, Buffer<Id>& segmentEdges)
{
  PolygonMesh<Id> mesh;
  mesh.NumberOfVertices = list.NumberOfVertices;
  mesh.NumberOfFaces = list.FaceOffsets.size() - 1;
  mesh.Vertices = std::move(list.Vertices);
  const Buffer<Id>& offsets = list.FaceOffsets;
  const Id size = mesh.NumberOfFaces > 0 ? offsets[1] : 3;
  bool same = size <= 4;
  ForEachInTurn(
    mesh.NumberOfFaces, [&](vtkIdType f) { same = same && offsets[f + 1] - offsets[f] == size; });
  mesh.Arity = same ? static_cast<int>(size) : 0;
  if (!same)
  {
    mesh.FaceOffsets = std::move(list.FaceOffsets);
    mesh.CornerFaces = Buffer<Id>(mesh.Vertices.size());
    ForEach(mesh.NumberOfFaces,
      [&mesh](vtkIdType f)
      {
        std::fill(mesh.CornerFaces.data() + mesh.FaceOffsets[f],
          mesh.CornerFaces.data() + mesh.FaceOffsets[f + 1], static_cast<Id>(f));
      });
  }
  EdgeSearch<Id>(mesh, list.Segments).Run(segmentEdges);
  FindFans(mesh);
  return mesh;
}

SUBDIVISION_COMPILE(struct PolygonMesh);
SUBDIVISION_COMPILE_FUNCTION(BuildPolygonMesh);

}
