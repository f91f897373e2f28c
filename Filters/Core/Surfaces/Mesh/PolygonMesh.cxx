// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// Finds the edges of half-edges and segments. Each of these is an entry in the list of the smaller
/// one of its two ends, and entries with the same other end are one edge.
template <typename Id>
class EdgeSearch
{
public:
  EdgeSearch(PolygonMesh<Id>& mesh, const Buffer<Id>& segments)
    : Mesh(mesh)
    , Segments(segments)
    , Corners(mesh.GetNumberOfCorners())
    , Size(Corners + segments.size() / 2)
  {
  }

  void Run(Buffer<Id>& segmentEdges)
  {
    this->FillEntries();
    this->NumberEdges(segmentEdges);
  }

private:
  struct Entry
  {
    Id Far; ///< the larger end
    Id Source;
    bool operator<(const Entry& other) const
    {
      return this->Far != other.Far ? this->Far < other.Far : this->Source < other.Source;
    }
  };

  std::pair<Id, Id> GetEnds(vtkIdType source) const
  {
    if (source < this->Corners)
    {
      const Id corner = static_cast<Id>(source);
      return { this->Mesh.Vertices[corner], this->Mesh.Vertices[this->Mesh.Next(corner)] };
    }
    const vtkIdType s = source - this->Corners;
    return { this->Segments[2 * s], this->Segments[2 * s + 1] };
  }

  void FillEntries()
  {
    const vtkIdType vertices = this->Mesh.NumberOfVertices;
    this->First = Buffer<Id>(vertices + 1, 0);
    for (const vtkIdType i : InTurn(this->Size))
    {
      const auto ends = this->GetEnds(i);
      ++this->First[std::min(ends.first, ends.second)];
    }
    CountsToOffsets(this->First);
    Buffer<Id> next(vertices);
    std::copy(this->First.begin(), this->First.end() - 1, next.begin());
    this->Entries = Buffer<Entry>(this->Size);
    for (const vtkIdType i : InTurn(this->Size))
    {
      const auto ends = this->GetEnds(i);
      this->Entries[next[std::min(ends.first, ends.second)]++] = {
        std::max(ends.first, ends.second), static_cast<Id>(i)
      };
    }
    ForEach(vertices,
      [this](vtkIdType v)
      {
        std::sort(this->Entries.data() + this->First[v], this->Entries.data() + this->First[v + 1]);
      });
  }

  void NumberEdges(Buffer<Id>& segmentEdges)
  {
    const vtkIdType vertices = this->Mesh.NumberOfVertices;
    Buffer<Id> firstEdges(vertices + 1);
    auto isNew = [this](Id k, vtkIdType v)
    { return k == this->First[v] || this->Entries[k].Far != this->Entries[k - 1].Far; };
    ForEach(vertices,
      [&](vtkIdType v)
      {
        Id count = 0;
        for (Id k = this->First[v]; k < this->First[v + 1]; ++k)
        {
          count += isNew(k, v);
        }
        firstEdges[v] = count;
      });
    CountsToOffsets(firstEdges);
    const vtkIdType edges = firstEdges[vertices];
    this->Mesh.EdgeVertices = Buffer<Id>(2 * edges);
    this->Mesh.EdgeCorners = Buffer<Id>(edges);
    this->Mesh.Edges = Buffer<Id>(this->Corners);
    this->Mesh.Twins = Buffer<Id>(this->Corners, static_cast<Id>(-1));
    segmentEdges = Buffer<Id>(this->Segments.size() / 2);
    ForEach(vertices,
      [&](vtkIdType v)
      {
        Id edge = firstEdges[v];
        for (Id k = this->First[v]; k < this->First[v + 1]; ++edge)
        {
          Id last = k + 1;
          while (last < this->First[v + 1] && !isNew(last, v))
          {
            ++last;
          }
          this->SetEdge(edge, k, last, segmentEdges);
          k = last;
        }
      });
    this->FindSheaves();
  }

  /// Entries [first, last) are one edge; it runs as the first of them does.
  void SetEdge(Id edge, Id first, Id last, Buffer<Id>& segmentEdges)
  {
    const Entry* entries = this->Entries.data();
    const auto ends = this->GetEnds(entries[first].Source);
    this->Mesh.EdgeVertices[2 * edge] = ends.first;
    this->Mesh.EdgeVertices[2 * edge + 1] = ends.second;
    Id corners = 0; // they come before segments
    for (Id k = first; k < last; ++k)
    {
      const Id source = entries[k].Source;
      if (source < this->Corners)
      {
        this->Mesh.Edges[source] = edge;
        ++corners;
      }
      else
      {
        segmentEdges[source - this->Corners] =
          2 * edge + (this->GetEnds(source).first == ends.first ? 0 : 1);
      }
    }
    this->Mesh.EdgeCorners[edge] = corners > 0 ? entries[first].Source : -1;
    if (corners == 2)
    {
      this->Mesh.Twins[entries[first].Source] = entries[first + 1].Source;
      this->Mesh.Twins[entries[first + 1].Source] = entries[first].Source;
    }
  }

  /// Lists the edges of three or more faces.
  void FindSheaves()
  {
    for (vtkIdType k = 0; k < this->Size; ++k)
    {
      const Id source = this->Entries[k].Source;
      if (source >= this->Corners || this->Mesh.Twins[source] >= 0)
      {
        continue;
      }
      const Id edge = this->Mesh.Edges[source];
      if (this->Mesh.EdgeCorners[edge] != source)
      {
        auto& sheaves = this->Mesh.Sheaves;
        if (sheaves.empty() || sheaves.back().Edge != edge)
        {
          sheaves.push_back({ edge, { this->Mesh.EdgeCorners[edge] } });
        }
        sheaves.back().Corners.push_back(source);
      }
    }
  }

  PolygonMesh<Id>& Mesh;
  const Buffer<Id>& Segments;
  vtkIdType Corners;
  vtkIdType Size;
  Buffer<Id> First;
  Buffer<Entry> Entries;
};

/// Sets VertexCorners and Joints.
template <typename Id>
void FindFans(PolygonMesh<Id>& mesh)
{
  const vtkIdType vertices = mesh.NumberOfVertices;
  Buffer<Id> counts(vertices, 0);
  mesh.VertexCorners = Buffer<Id>(vertices, static_cast<Id>(-1));
  for (const vtkIdType fromLast : InTurn(mesh.GetNumberOfCorners()))
  {
    const vtkIdType c = mesh.GetNumberOfCorners() - 1 - fromLast;
    mesh.VertexCorners[mesh.Vertices[c]] = static_cast<Id>(c);
    ++counts[mesh.Vertices[c]];
  }
  Buffer<unsigned char> isJoint(vertices);
  ForEach(vertices,
    [&](vtkIdType v)
    {
      Id faces = 0;
      if (mesh.VertexCorners[v] >= 0)
      {
        VisitFan(mesh, mesh.VertexCorners[v], [&](const FanStep<Id>&) { ++faces; });
      }
      isJoint[v] = faces != counts[v];
    });
  for (const auto& sheaf : InTurn(mesh.Sheaves))
  {
    isJoint[mesh.EdgeVertices[2 * sheaf.Edge]] = 1;
    isJoint[mesh.EdgeVertices[2 * sheaf.Edge + 1]] = 1;
  }
  std::vector<Id> freeEdges;
  for (const vtkIdType e : InTurn(mesh.GetNumberOfEdges()))
  {
    if (mesh.EdgeCorners[e] < 0)
    {
      freeEdges.push_back(static_cast<Id>(e));
      isJoint[mesh.EdgeVertices[2 * e]] = 1;
      isJoint[mesh.EdgeVertices[2 * e + 1]] = 1;
    }
  }
  for (const vtkIdType v : InTurn(vertices))
  {
    if (isJoint[v])
    {
      mesh.VertexCorners[v] = static_cast<Id>(-2 - static_cast<vtkIdType>(mesh.Joints.size()));
      mesh.Joints.push_back({ static_cast<Id>(v), {}, {} });
    }
  }
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
  for (const vtkIdType f : InTurn(mesh.NumberOfFaces))
  {
    same = same && offsets[f + 1] - offsets[f] == size;
  }
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
