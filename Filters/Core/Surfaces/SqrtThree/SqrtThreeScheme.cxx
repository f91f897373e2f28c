// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/SqrtThreeScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/CurveTangents.h"
#include "Core/Surfaces/Scheme/FixedEdges.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeMasks.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeRefinement.h"

#include <cmath>

namespace subdivision
{
namespace
{

template <typename Id>
class SqrtThreeScheme : public SurfaceScheme<Id>
{
public:
  bool NeedsTriangles() const override { return true; }
  bool HalvesEdges() const override { return false; }
  double CountFaces(double faces, double /*corners*/, int steps) const override
  {
    return faces * std::pow(3., steps);
  }
  void RestrictTags(SurfaceLevel<Id>& level) const override { FixEdges(level); }
  void Prepare(SurfaceLevel<Id>& level) const override { CountSqrtThreePlaces(level); }
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return SqrtThreeTopology<Id>(level).GetNumberOfVertices();
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override;
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override
  {
    return RefineSqrtThree(level, depth);
  }
  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override
  {
    ListSqrtThreeChildren(level, segments, children);
  }
  bool WritesFaces() const override { return true; }
  void WriteFaces(const SurfaceLevel<Id>& level, int* ids) const override
  {
    WriteSqrtThree(level, ids);
  }
  void WriteFaces(const SurfaceLevel<Id>& level, long long* ids) const override
  {
    WriteSqrtThree(level, ids);
  }
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override
  {
    return RefineSqrtThreeTags(level, tags);
  }
  int GetCarrierPeriod() const override { return 2; }
  void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, bool areWhole,
    Buffer<Carrier<Id>>& children) const override;
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override;

  vtkIdType GetOrientingFace(const SurfaceLevel<Id>&, vtkIdType child) const override
  {
    return child / 3;
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override;

private:
  using Topology = SqrtThreeTopology<Id>;
  void AppendSmooth(const SurfaceLevel<Id>& level, Id vertex, RowBlock<Id>& rows) const;
  bool AppendCentre(const SurfaceLevel<Id>& level, Id vertex, RowBlock<Id>& rows) const;
  void AppendThird(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, bool second,
    std::vector<Id>& edges, RowBlock<Id>& rows) const;
  void AppendSmoothPosition(const SurfaceLevel<Id>& level, Id vertex, RowBlock<Id>& rows) const;
  void AppendSmoothTangent(
    const SurfaceLevel<Id>& level, Id vertex, LimitKind kind, RowBlock<Id>& rows) const;
  void AppendAcross(const SurfaceLevel<Id>& level, Id vertex, double turn,
    const std::vector<Id>& ring, RowBlock<Id>& rows) const;
};

/// In an even step, the edge opposite to the vertex in the face of a step around it, as its corner,
/// if this edge is fixed; otherwise -1.
template <typename Id>
Id FindFixedOpposite(const SurfaceLevel<Id>& level, const FanStep<Id>& step)
{
  if (level.Places.empty())
  {
    return -1;
  }
  const Id opposite = level.Mesh.Next(step.Corner);
  return IsSharp(level.Tags.Edges[level.Mesh.Edges[opposite]]) ? opposite : -1;
}

template <typename Id>
void SqrtThreeScheme<Id>::GetParents(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const
{
  const Topology topology(level);
  const vtkIdType centre = row - level.Mesh.NumberOfVertices;
  const vtkIdType third = centre - topology.Centres;
  if (centre < 0)
  {
    parents.assign({ row });
  }
  else if (third < 0)
  {
    const Id* first = level.Mesh.Vertices.data() + 3 * topology.FindFace(static_cast<Id>(centre));
    parents.assign(first, first + 3);
  }
  else
  {
    const Id edge = topology.FindCutEdge(static_cast<Id>(row));
    parents.assign({ level.Mesh.EdgeVertices[2 * edge], level.Mesh.EdgeVertices[2 * edge + 1] });
  }
}

template <typename Id>
void SqrtThreeScheme<Id>::CarryFaces(const SurfaceLevel<Id>& level,
  const Buffer<Carrier<Id>>& faces, bool areWhole, Buffer<Carrier<Id>>& children) const
{
  const Topology topology(level);
  const PolygonMesh<Id>& mesh = level.Mesh;
  children = Buffer<Carrier<Id>>(mesh.GetNumberOfCorners());
  ForEach(children.size(),
    [&](vtkIdType c)
    {
      const Id corner = static_cast<Id>(c);
      const Carrier<Id>& own = faces[corner / 3];
      const bool isFixed = topology.IsFixed(corner);
      const Id twin = isFixed ? corner : mesh.Twins[corner];
      const bool isSecond = !isFixed && topology.RunsWith(corner, twin) && twin < corner;
      children[c] = areWhole ? JoinSqrtThree(own, faces[twin / 3], isSecond)
                             : PartSqrtThree(own, corner % 3, isSecond);
    });
}

// ------------------------------------------------------------------------------------------------
// Rows of a step

template <typename Id>
void SqrtThreeScheme<Id>::AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Topology topology(level);
  const vtkIdType vertices = mesh.NumberOfVertices;
  const vtkIdType thirds = vertices + topology.Centres;
  std::vector<Id> edges;
  vtkIdType row = begin;
  for (; row < std::min(end, vertices); ++row)
  {
    const Id vertex = static_cast<Id>(row);
    if (tags.Vertices[row] == VertexTag::Smooth)
    {
      this->AppendSmooth(level, vertex, rows);
    }
    else if (topology.IsEven)
    {
      AppendCurveVertex(mesh, tags, vertex, 19. / 27., edges, rows);
    }
    else
    {
      rows.Add(row, 1.);
    }
    rows.EndRow();
  }
  if (row < std::min(end, thirds))
  {
    Id face = topology.FindFace(static_cast<Id>(row - vertices));
    for (; row < std::min(end, thirds); ++row, ++face)
    {
      while (topology.GetCentre(face) < 0)
      {
        ++face;
      }
      for (int i = 0; i < 3; ++i)
      {
        rows.Add(mesh.Vertices[3 * face + i], 1. / 3.);
      }
      rows.EndRow();
    }
  }
  for (; row < end; ++row)
  {
    const bool second = (row - thirds) % 2 == 1;
    this->AppendThird(mesh, tags, topology.FindCutEdge(static_cast<Id>(row)), second, edges, rows);
    rows.EndRow();
  }
}

/// Appends the row of a smooth vertex p. In even steps it has a ghost neighbour a + b - p beyond
/// each fixed edge ab opposite to it, which keeps a flat grid exact (Mathematics 11).
template <typename Id>
void SqrtThreeScheme<Id>::AppendSmooth(
  const SurfaceLevel<Id>& level, Id vertex, RowBlock<Id>& rows) const
{
  if (this->AppendCentre(level, vertex, rows))
  {
    return;
  }
  const PolygonMesh<Id>& mesh = level.Mesh;
  int n = 0;
  int ghosts = 0;
  const std::size_t own = rows.GetNumberOfEntries();
  rows.Add(vertex, 0.); // weights follow when all entries are known
  VisitCycle(mesh, mesh.VertexCorners[vertex],
    [&](const FanStep<Id>& step)
    {
      ++n;
      const Id in = step.GetHalfEdgeIn(mesh);
      rows.Add(mesh.Vertices[in == step.Corner ? mesh.Next(in) : in], 0.);
      const Id opposite = FindFixedOpposite(level, step);
      if (opposite >= 0)
      {
        ++ghosts;
        rows.Add(mesh.Vertices[opposite], 0.);
        rows.Add(mesh.Vertices[mesh.Next(opposite)], 0.);
      }
    });
  n += ghosts;
  const double ring = GetSqrtThreeRingWeight(n) / n;
  rows.SetWeight(own, 1. - ring * (n + ghosts));
  for (std::size_t entry = own + 1; entry < rows.GetNumberOfEntries(); ++entry)
  {
    rows.SetWeight(entry, ring);
  }
}

/// Appends the same row without a walk if the vertex is the centre of a face without fixed edges:
/// the three children of that face have all its neighbours, in the same order. Returns false for
/// other vertices.
template <typename Id>
bool SqrtThreeScheme<Id>::AppendCentre(
  const SurfaceLevel<Id>& level, Id vertex, RowBlock<Id>& rows) const
{
  const Id corner = level.Mesh.VertexCorners[vertex];
  if (level.Step == 0 || corner % 9 != 2)
  {
    return false;
  }
  const Id* faces = level.Mesh.Vertices.data() + (corner - 2);
  for (int i = 0; i < 9; i += 3)
  {
    if (faces[i + 2] != vertex || faces[i + 1] == faces[(i + 3) % 9])
    {
      return false;
    }
  }
  constexpr int n = 6;
  const double ring = GetSqrtThreeRingWeight(n) / n;
  rows.Add(vertex, 1. - ring * n);
  for (int i = 0; i < 9; i += 3)
  {
    rows.Add(faces[i], ring);
    rows.Add(faces[i + 1], ring);
  }
  return true;
}

/// Appends the row of the point at one third of a fixed edge: that of a cubic B-spline cut into
/// thirds (Kobbelt, eq. 9) or, next to a vertex that stays, 2/3 and 1/3.
template <typename Id>
void SqrtThreeScheme<Id>::AppendThird(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags,
  Id edge, bool second, std::vector<Id>& edges, RowBlock<Id>& rows) const
{
  const Id near = mesh.EdgeVertices[2 * edge + (second ? 1 : 0)];
  const Id far = mesh.EdgeVertices[2 * edge + (second ? 0 : 1)];
  edges.clear();
  if (tags.Vertices[near] == VertexTag::Curve)
  {
    CollectSharpEdges(mesh, tags, near, edges);
  }
  if (edges.size() != 2)
  {
    rows.Add(near, 2. / 3.);
    rows.Add(far, 1. / 3.);
    return;
  }
  rows.Add(near, 16. / 27.);
  rows.Add(far, 10. / 27.);
  rows.Add(mesh.GetOtherEnd(edges[edges[0] == edge ? 1 : 0], near), 1. / 27.);
}

// ------------------------------------------------------------------------------------------------
// Limits

template <typename Id>
void SqrtThreeScheme<Id>::AppendLimitRows(const SurfaceLevel<Id>& level,
  const SurfaceTags<Id>& tags, LimitKind kind, vtkIdType begin, vtkIdType end,
  RowBlock<Id>& rows) const
{
  std::vector<Id> edges;
  for (vtkIdType v = begin; v < end; ++v)
  {
    const Id vertex = static_cast<Id>(v);
    const bool isSmooth = tags.Vertices[v] == VertexTag::Smooth;
    const bool isPosition = kind == LimitKind::Position;
    if (isPosition && isSmooth)
    {
      this->AppendSmoothPosition(level, vertex, rows);
    }
    else if (isPosition)
    {
      AppendCurveVertex(level.Mesh, tags, vertex, 2. / 3., edges, rows);
    }
    else if (isSmooth)
    {
      this->AppendSmoothTangent(level, vertex, kind, rows);
    }
    else
    {
      AppendSectorTangent(level, tags, vertex, kind, edges, rows,
        [&](const SectorEnds<Id>&, double turn)
        { this->AppendAcross(level, vertex, turn, edges, rows); });
    }
    rows.EndRow();
  }
}

/// Appends the limit (1 - b) p + b mean(ring) (Kobbelt, eq. 7). Before an even step, a vertex p
/// opposite to a fixed edge has the ring for which this holds only after the step: there the two
/// points on the fixed edge take the place of the centre of the face.
template <typename Id>
void SqrtThreeScheme<Id>::AppendSmoothPosition(
  const SurfaceLevel<Id>& level, Id vertex, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Id start = mesh.VertexCorners[vertex];
  int n = 0;
  int ghosts = 0;
  VisitCycle(mesh, start,
    [&](const FanStep<Id>& step)
    {
      ++n;
      ghosts += FindFixedOpposite(level, step) >= 0;
    });
  const double a = GetSqrtThreeRingWeight(n + ghosts);
  const double b = 3. * a / (1. + 3. * a);
  auto addRing = [&](RowBlock<Id>& out, double weight)
  {
    VisitCycle(mesh, start,
      [&](const FanStep<Id>& step)
      {
        const Id in = step.GetHalfEdgeIn(mesh);
        out.Add(mesh.Vertices[in == step.Corner ? mesh.Next(in) : in], weight);
      });
  };
  if (ghosts == 0)
  {
    rows.Add(vertex, 1. - b);
    addRing(rows, b / n);
    return;
  }
  RowBlock<Id> next;
  std::vector<Id> edges;
  auto addNext = [&](double weight)
  {
    for (std::size_t k = 0; k < next.GetNumberOfEntries(); ++k)
    {
      rows.Add(next.GetColumns()[k], weight * next.GetWeights()[k]);
    }
    next.Clear();
  };
  this->AppendSmooth(level, vertex, next);
  addNext(1. - b);
  const double ring = b / (n + ghosts);
  VisitCycle(mesh, start,
    [&](const FanStep<Id>& step)
    {
      const Id opposite = FindFixedOpposite(level, step);
      if (opposite < 0)
      {
        for (Id c : { step.Corner, mesh.Next(step.Corner), mesh.Previous(step.Corner) })
        {
          rows.Add(mesh.Vertices[c], ring / 3.);
        }
        return;
      }
      for (const bool second : { false, true })
      {
        this->AppendThird(mesh, level.Tags, mesh.Edges[opposite], second, edges, next);
        addNext(ring);
      }
    });
}

/// Appends a tangent: the sum over the ring with the weights cos or sin of the angle. A step turns
/// the ring by half a triangle, which does not change the plane of both tangents. For a vertex
/// opposite to a fixed edge the ring is that after the next step, as for the position.
template <typename Id>
void SqrtThreeScheme<Id>::AppendSmoothTangent(
  const SurfaceLevel<Id>& level, Id vertex, LimitKind kind, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Id start = mesh.VertexCorners[vertex];
  int n = 0;
  int ghosts = 0;
  VisitCycle(mesh, start,
    [&](const FanStep<Id>& step)
    {
      ++n;
      ghosts += FindFixedOpposite(level, step) >= 0;
    });
  int j = 0;
  auto getNext = [&]
  {
    const double angle = 2. * Pi * j++ / (n + ghosts);
    return kind == LimitKind::Tangent1 ? std::cos(angle) : std::sin(angle);
  };
  std::vector<Id> edges;
  RowBlock<Id> third;
  VisitCycle(mesh, start,
    [&](const FanStep<Id>& step)
    {
      const Id in = step.GetHalfEdgeIn(mesh);
      const Id first = mesh.Vertices[in == step.Corner ? mesh.Next(in) : in];
      const Id opposite = FindFixedOpposite(level, step);
      if (ghosts == 0)
      {
        rows.Add(first, getNext());
      }
      else if (opposite < 0)
      {
        const double weight = getNext() / 3.;
        for (Id c : { step.Corner, mesh.Next(step.Corner), mesh.Previous(step.Corner) })
        {
          rows.Add(mesh.Vertices[c], weight);
        }
      }
      for (int end = 0; end < 2 && opposite >= 0; ++end)
      {
        const Id edge = mesh.Edges[opposite];
        const bool isFirst = mesh.EdgeVertices[2 * edge] == first;
        third.Clear();
        this->AppendThird(mesh, level.Tags, edge, isFirst == (end == 1), edges, third);
        const double weight = getNext();
        for (std::size_t k = 0; k < third.GetNumberOfEntries(); ++k)
        {
          rows.Add(third.GetColumns()[k], weight * third.GetWeights()[k]);
        }
      }
    });
}

/// Appends the tangent across a curve in a sector, times `turn`. `ring`: the other ends of its
/// edges.
template <typename Id>
void SqrtThreeScheme<Id>::AppendAcross(const SurfaceLevel<Id>& level, Id vertex, double turn,
  const std::vector<Id>& ring, RowBlock<Id>& rows) const
{
  const int size = static_cast<int>(ring.size()) - 1;
  SqrtThreeTransversalMask mask(level.Step % 2 == 0 ? size : size - 1);
  if (level.Step % 2 == 1)
  {
    mask.MakeOdd();
  }
  rows.Add(vertex, turn * mask.Own);
  rows.Add(ring.front(), turn * mask.End);
  rows.Add(ring.back(), turn * mask.End);
  for (std::size_t j = 1; j + 1 < ring.size(); ++j)
  {
    rows.Add(ring[j], turn * mask.Inside[j]);
  }
}

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeSqrtThreeScheme()
{
  return std::make_unique<SqrtThreeScheme<Id>>();
}

SUBDIVISION_COMPILE_FUNCTION(MakeSqrtThreeScheme);

}
