// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SharpRows.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
std::vector<Id> CollectEnds(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges)
{
  std::vector<Id> ends;
  for (const SharpEdge<Id>& edge : edges)
  {
    const Id* both = mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(edge.Edge);
    ends.insert(ends.end(), both, both + 2);
  }
  SortUnique(ends);
  return ends;
}

template <typename Id>
std::vector<Id> CollectWithNeighbours(const PolygonMesh<Id>& mesh, const std::vector<Id>& vertices)
{
  std::vector<Id> all = vertices;
  std::vector<Id> edges;
  for (const Id vertex : vertices)
  {
    CollectEdges(mesh, vertex, [](Id) { return true; }, edges);
    for (const Id edge : edges)
    {
      all.push_back(mesh.GetOtherEnd(edge, vertex));
    }
    VisitFaces(mesh, vertex, [&](Id face) { AppendOfFace(mesh, mesh.Vertices, face, all); });
  }
  SortUnique(all);
  return all;
}

template <typename Id>
SharpRows<Id>::SharpRows(
  const SurfaceLevel<Id>& level, SharpTagPair<Id>&& tags, const std::vector<SharpEdge<Id>>& edges)
  : Tags(std::move(tags))
{
  this->AddVertices(level.Mesh, edges);
  this->AddEdges(level.Mesh, edges);
  this->AddFaces(level.Mesh);
  std::sort(this->Rows.begin(), this->Rows.end(),
    [](const PartlySharpRow& a, const PartlySharpRow& b) { return b.Row > a.Row; });
}

/// Sets Parts, for each end of edges that are sharp in part the mean of their parts, and adds the
/// rows of the ends of all sharp edges.
template <typename Id>
void SharpRows<Id>::AddVertices(
  const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges)
{
  std::vector<PartlySharpRow> given;
  for (const SharpEdge<Id>& edge : edges)
  {
    for (int end = 0; end < 2 && edge.Left < 1.; ++end)
    {
      given.push_back(
        { mesh.EdgeVertices[2 * static_cast<vtkIdType>(edge.Edge) + end], edge.Left });
    }
  }
  std::stable_sort(given.begin(), given.end(),
    [](const PartlySharpRow& a, const PartlySharpRow& b) { return b.Row > a.Row; });
  for (auto at = given.begin(); at != given.end();)
  {
    double sum = 0.;
    const auto first = at;
    for (; at != given.end() && at->Row == first->Row; ++at)
    {
      sum += at->Part;
    }
    this->Parts.push_back({ first->Row, sum / static_cast<double>(at - first) });
  }
  for (const Id end : CollectEnds(mesh, edges))
  {
    this->Rows.push_back({ end, this->GetPart({ end }) });
  }
}

/// The mean of the sharp fractions of some vertices that have one; 0: none has.
template <typename Id>
double SharpRows<Id>::GetPart(const std::vector<Id>& vertices) const
{
  double sum = 0.;
  int count = 0;
  for (const Id vertex : vertices)
  {
    const auto at = std::lower_bound(this->Parts.begin(), this->Parts.end(), vertex,
      [](const PartlySharpRow& row, vtkIdType v) { return v > row.Row; });
    if (at != this->Parts.end() && at->Row == vertex)
    {
      sum += at->Part;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.;
}

/// Adds the rows of the edges whose rules depend on sharp edges: these themselves, all edges at
/// their ends, and the other edges of the faces there. A sharp edge has its own fraction; another
/// edge has the fraction of its ends or, if these have none, of the other corners of its faces.
template <typename Id>
void SharpRows<Id>::AddEdges(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges)
{
  std::vector<Id> near;
  std::vector<Id> around;
  for (const Id end : CollectEnds(mesh, edges))
  {
    CollectEdges(mesh, end, [](Id) { return true; }, around);
    near.insert(near.end(), around.begin(), around.end());
    VisitFaces(mesh, end, [&](Id face) { AppendOfFace(mesh, mesh.Edges, face, near); });
  }
  SortUnique(near);
  auto sharp = edges.begin();
  for (const Id edge : near)
  {
    while (sharp != edges.end() && sharp->Edge < edge)
    {
      ++sharp;
    }
    const Id* ends = mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(edge);
    double part = this->GetPart({ ends[0], ends[1] });
    const Id corner = mesh.EdgeCorners[edge];
    if (sharp != edges.end() && sharp->Edge == edge)
    {
      part = sharp->Left < 1. ? sharp->Left : 0.;
    }
    else if (part == 0. && corner >= 0)
    {
      std::vector<Id> across;
      AppendOfFace(mesh, mesh.Vertices, mesh.GetFace(corner), across);
      if (mesh.Twins[corner] >= 0)
      {
        AppendOfFace(mesh, mesh.Vertices, mesh.GetFace(mesh.Twins[corner]), across);
      }
      SortUnique(across);
      part = this->GetPart(across);
    }
    this->Rows.push_back({ mesh.NumberOfVertices + edge, part });
  }
}

template <typename Id>
void SharpRows<Id>::AddFaces(const PolygonMesh<Id>& mesh)
{
  std::vector<Id> faces;
  for (const PartlySharpRow& row : this->Rows)
  {
    if (mesh.NumberOfVertices > row.Row)
    {
      VisitFaces(mesh, static_cast<Id>(row.Row), [&](Id face) { faces.push_back(face); });
    }
  }
  SortUnique(faces);
  for (const Id face : faces)
  {
    std::vector<Id> corners;
    AppendOfFace(mesh, mesh.Vertices, face, corners);
    this->Rows.push_back(
      { mesh.NumberOfVertices + mesh.GetNumberOfEdges() + face, this->GetPart(corners) });
  }
}

template <typename Id>
void SharpRows<Id>::Append(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  auto at = std::lower_bound(this->Rows.begin(), this->Rows.end(), begin,
    [](const PartlySharpRow& row, vtkIdType r) { return r > row.Row; });
  RowBlock<Id> one;
  auto add = [&](const SurfaceTags<Id>& tags, vtkIdType row, double factor)
  {
    one.Clear();
    scheme.AppendRows(level, tags, row, row + 1, one);
    AddTimes(one, factor, rows);
  };
  for (vtkIdType row = begin; row < end;)
  {
    const vtkIdType next = at == this->Rows.end() ? end : std::min<vtkIdType>(end, at->Row);
    if (next > row)
    {
      scheme.AppendRows(level, level.Tags, row, next, rows);
      row = next;
      continue;
    }
    if (at->Part > 0.)
    {
      add(this->Tags.Whole, row, 1. - at->Part);
      add(this->Tags.All, row, at->Part);
      rows.EndRow();
    }
    else
    {
      scheme.AppendRows(level, this->Tags.Whole, row, row + 1, rows);
    }
    ++row;
    ++at;
  }
}

SUBDIVISION_COMPILE(class SharpRows);
SUBDIVISION_COMPILE_FUNCTION(CollectEnds);
SUBDIVISION_COMPILE_FUNCTION(CollectWithNeighbours);

}
