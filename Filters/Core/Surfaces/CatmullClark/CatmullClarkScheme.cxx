// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/CatmullClark/CatmullClarkScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/CatmullClark/CatmullClarkRegular.h"
#include "Core/Surfaces/CatmullClark/CatmullClarkRowsOfNext.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"
#include "Core/Surfaces/Scheme/SectorRows.h"
#include "Core/Surfaces/Scheme/SurfaceLimits.h"

#include <array>
#include <cmath>

namespace subdivision
{
namespace
{

template <typename Id>
class CatmullClarkScheme : public SurfaceScheme<Id>
{
public:
  explicit CatmullClarkScheme(bool modifiedBoundary)
    : SurfaceScheme<Id>({ [](const SurfaceLevel<Id>& level) { return level.Mesh.Arity == 4; },
        AppendCatmullClarkRowsOfNext<Id>, GetCatmullClarkParentsOfNext<Id>, WriteQuadsOfNext<Id> })
    , ModifiedBoundary(modifiedBoundary)
  {
  }
  bool NeedsTriangles() const override { return false; }
  bool HasCornersOfOneFace() const override { return true; }
  FaceMemory GetFaceMemory() const override { return { 40., 1., 12., 36., 118., 198. }; }
  double GetThirdEigenvalue(int k, double angle) const override
  {
    const double c = std::cos(Pi / k);
    const double g = 3. / 8. - std::cos(angle / k) / 4.;
    const double half = g + c / 8. - 0.25;
    return (g + c / 8. + 0.25 + std::sqrt(half * half + (1. + c) / 8.)) / 2.;
  }
  double CountFaces(double faces, double corners, int steps) const override
  {
    return steps > 0 ? corners * std::pow(4., steps - 1) : faces;
  }
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return level.Mesh.NumberOfVertices + level.Mesh.GetNumberOfEdges() + level.Mesh.NumberOfFaces;
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const vtkIdType edge = row - mesh.NumberOfVertices;
    const vtkIdType face = edge - mesh.GetNumberOfEdges();
    if (edge < 0)
    {
      parents.assign({ row });
    }
    else if (face < 0)
    {
      parents.assign({ mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] });
    }
    else
    {
      const Id* first = mesh.Vertices.data() + mesh.GetFirst(static_cast<Id>(face));
      parents.assign(first, first + mesh.GetSize(static_cast<Id>(face)));
    }
  }
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override
  {
    return RefineToQuads(level, depth);
  }
  void ListChildren(const SurfaceLevel<Id>&, const SurfaceSegments& segments,
    SurfaceSegments& children) const override
  {
    ListQuadChildren(segments, children);
  }
  bool WritesFaces() const override { return true; }
  void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const override
  {
    WriteQuads(level, ids);
  }
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override
  {
    return RefineToQuadTags(level, tags);
  }
  void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, bool,
    Buffer<Carrier<Id>>& children) const override
  {
    children = Buffer<Carrier<Id>>(level.Mesh.GetNumberOfCorners());
    ForEach(children.size(),
      [&](vtkIdType i) { children[i] = faces[level.Mesh.GetFace(static_cast<Id>(i))]; });
  }
  vtkIdType GetOrientingFace(const SurfaceLevel<Id>& level, vtkIdType child) const override
  {
    return level.Mesh.GetFace(static_cast<Id>(child));
  }

  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override;

  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    LimitFinder<Id> finder(level, tags, *this, this->ModifiedBoundary, LoopWeights::Warren);
    for (vtkIdType v = begin; v < end; ++v)
    {
      finder.Append(static_cast<Id>(v), kind, rows);
      rows.EndRow();
    }
  }

private:
  void AppendVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const;
  bool FindQuadsOfEdge(
    const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, Id vertices[6]) const;
  void AppendSmoothVertex(const PolygonMesh<Id>& mesh, Id vertex,
    const std::vector<FanStep<Id>>& steps, RowBlock<Id>& rows) const;
  void AppendEdge(
    const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, RowBlock<Id>& rows) const;
  void AppendFace(
    const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id face, RowBlock<Id>& rows) const;

  bool ModifiedBoundary;
};

/// The neighbour by whose edge a walk enters a quad, and the vertex opposite.
template <typename Id>
void GetVerticesOfQuad(const PolygonMesh<Id>& mesh, const FanStep<Id>& step, Id vertices[2])
{
  const Id next = mesh.Next(step.Corner);
  vertices[0] = mesh.Vertices[step.Forward ? next : mesh.Previous(step.Corner)];
  vertices[1] = mesh.Vertices[mesh.Next(next)];
}

/// The mean of a face's corners, times a factor.
template <typename Id>
void AppendMean(const PolygonMesh<Id>& mesh, Id face, double factor, RowBlock<Id>& rows)
{
  const Id first = mesh.GetFirst(face);
  const Id size = mesh.GetSize(face);
  for (Id c = first; c < first + size; ++c)
  {
    rows.Add(mesh.Vertices[c], factor / size);
  }
}

template <typename Id>
void CatmullClarkScheme<Id>::AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType vertices = mesh.NumberOfVertices;
  const vtkIdType edges = vertices + mesh.GetNumberOfEdges();
  this->AppendVertices(level, tags, begin, std::min(end, vertices), rows);
  const vtkIdType lastOfEdges = std::min(end, edges);
  for (vtkIdType row = std::max(begin, vertices); row < lastOfEdges; ++row)
  {
    row += rows.AddRun(QuadsAtEdge, lastOfEdges - row, [&](vtkIdType i, Id* columns)
      { return this->FindQuadsOfEdge(mesh, tags, static_cast<Id>(row + i - vertices), columns); });
    if (row < lastOfEdges)
    {
      this->AppendEdge(mesh, tags, static_cast<Id>(row - vertices), rows);
      rows.EndRow();
    }
  }
  const bool isPlain = mesh.Arity == 4 && (!this->ModifiedBoundary || tags.Sectors.empty());
  for (vtkIdType row = std::max(begin, edges); row < end; ++row)
  {
    row += rows.AddRun(QuadOfFace, isPlain ? end - row : 0,
      [&](vtkIdType i, Id* columns)
      {
        std::copy_n(mesh.Vertices.data() + 4 * (row + i - edges), 4, columns);
        return true;
      });
    if (row < end)
    {
      this->AppendFace(mesh, tags, static_cast<Id>(row - edges), rows);
      rows.EndRow();
    }
  }
}

template <typename Id>
void CatmullClarkScheme<Id>::AppendVertices(const SurfaceLevel<Id>& level,
  const SurfaceTags<Id>& tags, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const auto isSmooth = [&tags](vtkIdType v) { return tags.Vertices[v] == VertexTag::Smooth; };
  const vtkIdType firstNew =
    level.VerticesBefore < 0 ? end : std::min<vtkIdType>(end, level.VerticesBefore);
  std::vector<Id> scratch;
  const auto append = [&](Id vertex, const std::vector<FanStep<Id>>& steps)
  {
    isSmooth(vertex) ? this->AppendSmoothVertex(mesh, vertex, steps, rows)
                     : AppendCurveVertex(mesh, tags, vertex, 3. / 4., scratch, rows);
  };
  AppendQuadVertices(
    level, tags, begin, firstNew,
    [&](const FanStep<Id>& step, Id* two) { GetVerticesOfQuad(mesh, step, two); }, append, rows);
  std::vector<FanStep<Id>> steps;
  for (vtkIdType vertex = std::max(begin, firstNew); vertex < end; ++vertex)
  {
    vertex += rows.AddRun(QuadsAtVertex, end - vertex,
      [&](vtkIdType i, Id* columns)
      {
        columns[0] = static_cast<Id>(vertex + i);
        return isSmooth(columns[0]) && FindRingOfNewPoint(mesh, columns[0], columns + 1);
      });
    if (vertex < end)
    {
      const Id v = static_cast<Id>(vertex);
      steps.clear();
      if (isSmooth(v))
      {
        VisitCycle(
          mesh, mesh.VertexCorners[v], [&](const FanStep<Id>& step) { steps.push_back(step); });
      }
      append(v, steps);
      rows.EndRow();
    }
  }
}

/// `steps`: of the walk around the vertex.
template <typename Id>
void CatmullClarkScheme<Id>::AppendSmoothVertex(const PolygonMesh<Id>& mesh, Id vertex,
  const std::vector<FanStep<Id>>& steps, RowBlock<Id>& rows) const
{
  if (mesh.Arity == 4)
  {
    AppendQuadVertex(
      vertex, steps,
      [&mesh](const FanStep<Id>& step, Id* two) { GetVerticesOfQuad(mesh, step, two); }, rows);
    return;
  }
  const int k = static_cast<int>(steps.size());
  const double edge = 1. / (static_cast<double>(k) * k);
  const double own = static_cast<double>(k - 2) / k;
  rows.Add(vertex, own);
  for (const FanStep<Id>& step : steps)
  {
    rows.Add(
      mesh.Vertices[step.Forward ? mesh.Next(step.Corner) : mesh.Previous(step.Corner)], edge);
    AppendMean(mesh, mesh.GetFace(step.Corner), edge, rows);
  }
}

/// Finds the vertices of both quads at an edge inside: its ends first. False: it has another row.
template <typename Id>
bool CatmullClarkScheme<Id>::FindQuadsOfEdge(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, Id vertices[6]) const
{
  vertices[0] = mesh.EdgeVertices[2 * edge];
  vertices[1] = mesh.EdgeVertices[2 * edge + 1];
  const bool isInside = tags.Vertices[vertices[0]] == VertexTag::Smooth &&
    tags.Vertices[vertices[1]] == VertexTag::Smooth;
  if (mesh.Arity != 4 || tags.Edges[edge] != EdgeTag::Smooth ||
    (!isInside && this->ModifiedBoundary))
  {
    return false;
  }
  const Id corner = mesh.EdgeCorners[edge];
  Id* next = vertices + 2;
  for (const Id halfEdge : { corner, mesh.Twins[corner] })
  {
    const Id before = mesh.Previous(halfEdge);
    *next++ = mesh.Vertices[before];
    *next++ = mesh.Vertices[mesh.Previous(before)];
  }
  return true;
}

/// Appends the row of an edge that has no quads on both sides, or one end on a curve.
template <typename Id>
void CatmullClarkScheme<Id>::AppendEdge(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, RowBlock<Id>& rows) const
{
  const Id ends[2] = { mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] };
  if (tags.Edges[edge] != EdgeTag::Smooth)
  {
    rows.Add(ends[0], 0.5);
    rows.Add(ends[1], 0.5);
    return;
  }
  const Id corner = mesh.EdgeCorners[edge];
  const Id twin = mesh.Twins[corner];
  double weights[2] = { 0., 0. };
  FlatPoint<Id> flats[2];
  int asking = 0;
  int flat = 0;
  for (int end = 0; end < 2 && this->ModifiedBoundary; ++end)
  {
    if (tags.Vertices[ends[end]] == VertexTag::Smooth)
    {
      continue;
    }
    const Id at = GetCornerAt(mesh, corner, ends[end]);
    const double angle = FindAngleOfFace(mesh, tags, ends[end], at);
    const double gamma = angle > 0. ? 3. / 8. - std::cos(angle) / 4. : 3. / 8.;
    weights[end] += 5. / 8. - gamma;
    weights[1 - end] += gamma - 1. / 8.;
    ++asking;
    flats[end] = FindFlatPoint(mesh, tags, ends[end], at, edge, false);
    flat += flats[end].Flatness > 0.;
  }
  if (asking == 0)
  {
    weights[0] = weights[1] = 0.25;
    asking = 1;
  }
  double kept = 1.; // weight of the point before Flatness moves it
  for (const FlatPoint<Id>& point : flats)
  {
    kept -= point.Flatness / std::max(1, flat);
  }
  if (mesh.Arity == 4)
  {
    // The ends are in both faces.
    rows.Add(ends[0], kept * (weights[0] / asking + 1. / 8.));
    rows.Add(ends[1], kept * (weights[1] / asking + 1. / 8.));
    for (const Id halfEdge : { corner, twin })
    {
      const Id before = mesh.Previous(halfEdge);
      rows.Add(mesh.Vertices[before], kept / 16.);
      rows.Add(mesh.Vertices[mesh.Previous(before)], kept / 16.);
    }
  }
  else
  {
    rows.Add(ends[0], kept * weights[0] / asking);
    rows.Add(ends[1], kept * weights[1] / asking);
    AppendMean(mesh, mesh.GetFace(corner), kept / 4., rows);
    AppendMean(mesh, mesh.GetFace(twin), kept / 4., rows);
  }
  for (const FlatPoint<Id>& point : flats)
  {
    if (point.Flatness > 0.)
    {
      point.Append(rows, point.Flatness / flat);
    }
  }
}

template <typename Id>
void CatmullClarkScheme<Id>::AppendFace(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id face, RowBlock<Id>& rows) const
{
  double kept = 1.;
  std::vector<FlatPoint<Id>> flats;
  if (this->ModifiedBoundary && !tags.Sectors.empty())
  {
    const Id first = mesh.GetFirst(face);
    for (Id c = first; c < first + mesh.GetSize(face); ++c)
    {
      const FlatPoint<Id> point = FindFlatPoint(mesh, tags, mesh.Vertices[c], c, Id(-1), true);
      if (point.Flatness > 0.)
      {
        flats.push_back(point);
      }
    }
    for (const FlatPoint<Id>& point : flats)
    {
      kept -= point.Flatness / static_cast<double>(flats.size());
    }
  }
  AppendMean(mesh, face, kept, rows);
  for (const FlatPoint<Id>& point : flats)
  {
    point.Append(rows, point.Flatness / static_cast<double>(flats.size()));
  }
}

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeCatmullClarkScheme(bool modifiedBoundary)
{
  return std::make_unique<CatmullClarkScheme<Id>>(modifiedBoundary);
}

SUBDIVISION_COMPILE_FUNCTION(MakeCatmullClarkScheme);

}
