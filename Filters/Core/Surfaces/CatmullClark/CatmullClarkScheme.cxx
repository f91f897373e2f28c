// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/CatmullClark/CatmullClarkScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/CatmullClark/CatmullClarkRegular.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/SectorRows.h"
#include "Core/Surfaces/Scheme/SurfaceLimits.h"

#include <array>
#include <cmath>

namespace subdivision
{
namespace
{

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
class CatmullClarkScheme : public PrimalScheme<Id, 4>
{
public:
  explicit CatmullClarkScheme(bool modifiedBoundary)
    : ModifiedBoundary(modifiedBoundary)
  {
  }
  bool HasCornersOfOneFace() const override { return true; }
  FaceMemory GetFaceMemory() const override { return { 40., 1., 12., 36., 118., 198., 36., 157. }; }
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
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const bool isPlain = mesh.Arity == 4 && (!this->ModifiedBoundary || tags.Sectors.empty());
    ForKindsOfRows<3>({ mesh.NumberOfVertices, mesh.GetNumberOfEdges(), mesh.NumberOfFaces }, begin,
      end,
      [&](std::size_t kind, vtkIdType first, vtkIdType last)
      {
        switch (kind)
        {
          case 0:
            this->AppendVertices(level, tags, first, last, rows);
            break;
          case 1:
            AppendRegularGroups<1>(
              QuadsAtEdge, first, last, [&](vtkIdType edge, Id* columns)
              { return this->FindQuadsOfEdge(mesh, tags, static_cast<Id>(edge), columns); },
              [&](vtkIdType edge) { this->AppendEdge(mesh, tags, static_cast<Id>(edge), rows); },
              rows);
            break;
          default:
            AppendRegularGroups<1>(
              QuadOfFace, first, last,
              [&](vtkIdType face, Id* columns)
              {
                std::copy_n(mesh.Vertices.data() + 4 * face, isPlain ? 4 : 0, columns);
                return isPlain;
              },
              [&](vtkIdType face) { this->AppendFace(mesh, tags, static_cast<Id>(face), rows); },
              rows);
        }
      });
  }

  bool SkipsNext(const SurfaceLevel<Id>& level) const override { return level.Mesh.Arity == 4; }
  void AppendRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    AppendPrimalRowsOfNext<4>(
      level, QuadsAtVertex, QuadsAtEdge,
      [&](Id vertex, const std::vector<FanStep<Id>>& steps, const auto& members)
      { AppendQuadVertex(vertex, steps, members, rows); }, others, begin, end, rows);
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    LimitFinder<Id>(level, tags, *this, this->ModifiedBoundary, LoopWeights::Warren)
      .AppendRows(kind, begin, end, rows);
  }
  const double* GetSecondTangent(const double* first) const override
  {
    return LimitFinder<Id>::template GetSecondTangent<4>(first);
  }
  bool HasLimitsOfNext(const SurfaceLevel<Id>& level, bool) const override
  {
    return level.Mesh.Arity == 4;
  }
  void AppendLimitRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
    LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    LimitFinder<Id>::template AppendRowsOfNext<4>(
      level, others, LoopWeights::Warren, kind, begin, end, rows);
  }

private:
  void AppendVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    std::vector<Id> scratch;
    AppendPrimalVertices<4>(
      level, tags, QuadsAtVertex, begin, end,
      [&](const FanStep<Id>& step, Id* two) { GetVerticesOfQuad(mesh, step, two); },
      [&mesh](Id vertex, Id* columns)
      {
        columns[0] = vertex;
        return FindRingOfNewPoint(mesh, vertex, columns + 1);
      },
      [&](Id vertex, const std::vector<FanStep<Id>>& steps)
      {
        steps.empty() ? AppendCurveVertex(mesh, tags, vertex, 3. / 4., scratch, rows)
                      : this->AppendSmoothVertex(mesh, vertex, steps, rows);
      },
      rows);
  }
  /// Finds the vertices of both quads at an edge inside: its ends first. False: it has another row.
  bool FindQuadsOfEdge(
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

  /// `steps`: of the walk around the vertex.
  void AppendSmoothVertex(const PolygonMesh<Id>& mesh, Id vertex,
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
  /// Appends the row of an edge that has no quads on both sides, or one end on a curve.
  void AppendEdge(
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
    const EdgeAtCurve<Id> rule(mesh, tags, edge, this->ModifiedBoundary,
      [](double angle)
      {
        const double far = angle > 0. ? 3. / 8. - std::cos(angle) / 4. : 3. / 8.;
        return std::array<double, 2>{ 5. / 8. - far, far - 1. / 8. };
      });
    const double kept = rule.Flat.GetKept();
    const double own = rule.Size == 0 ? 0.25 : rule.Weights[0] / rule.Size;
    const double other = rule.Size == 0 ? 0.25 : rule.Weights[1] / rule.Size;
    if (mesh.Arity == 4)
    {
      // The ends are in both faces.
      rows.Add(ends[0], kept * (own + 1. / 8.));
      rows.Add(ends[1], kept * (other + 1. / 8.));
      for (const Id halfEdge : { corner, twin })
      {
        const Id before = mesh.Previous(halfEdge);
        rows.Add(mesh.Vertices[before], kept / 16.);
        rows.Add(mesh.Vertices[mesh.Previous(before)], kept / 16.);
      }
    }
    else
    {
      rows.Add(ends[0], kept * own);
      rows.Add(ends[1], kept * other);
      AppendMean(mesh, mesh.GetFace(corner), kept / 4., rows);
      AppendMean(mesh, mesh.GetFace(twin), kept / 4., rows);
    }
    rule.Flat.Append(rows);
  }
  void AppendFace(
    const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id face, RowBlock<Id>& rows) const
  {
    FlatPoints<Id> flat;
    const Id first = mesh.GetFirst(face);
    const bool mayBeFlat = this->ModifiedBoundary && !tags.Sectors.empty();
    for (Id c = first; mayBeFlat && c < first + mesh.GetSize(face); ++c)
    {
      flat.Add(FindFlatPoint(mesh, tags, mesh.Vertices[c], c, Id(-1), true));
    }
    AppendMean(mesh, face, flat.GetKept(), rows);
    flat.Append(rows);
  }

  bool ModifiedBoundary;
};

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeCatmullClarkScheme(bool modifiedBoundary)
{
  return std::make_unique<CatmullClarkScheme<Id>>(modifiedBoundary);
}

SUBDIVISION_COMPILE_FUNCTION(MakeCatmullClarkScheme);

}
