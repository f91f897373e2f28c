// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyTangents.h
 * Tangents of modified Butterfly surfaces.
 *
 * A tangent is a left eigenvector for the eigenvalue 1/2 of the step around a vertex. At regular
 * vertices it has weights for all vertices within two edges (figure 8 of Zorin's survey), along
 * curves for two vertices on each side, otherwise for the neighbours. It is taken on the next
 * level, from which on the rules around each vertex stay the same, and multiplied by the rows of
 * this step.
 */
#ifndef SubdivisionObjects_ButterflyTangents_h
#define SubdivisionObjects_ButterflyTangents_h

#include "Core/Memory/Ids.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

template <typename Id>
class ButterflyTangents
{
public:
  ButterflyTangents(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, const SurfaceScheme<Id>& scheme)
    : Level(level)
    , Mesh(level.Mesh)
    , Tags(tags)
    , Scheme(scheme)
  {
  }
  /// Adds the entries of a vertex's row. A tangent that does not exist has none.
  void Append(Id vertex, LimitKind kind, RowBlock<Id>& rows)
  {
    const Id corner = FindTangentCorner(this->Mesh, this->Tags, vertex);
    const bool isCurve = IsOnCurve(this->Mesh, this->Tags, vertex);
    if (corner < 0)
    {
      CollectSharpEdges(this->Mesh, this->Tags, vertex, this->Edges);
      if (isCurve && this->Edges.size() == 2 && kind == LimitKind::Tangent1)
      {
        this->AppendOnCurve(vertex, kind, 1., rows);
      }
      return;
    }
    const SectorEnds<Id> ends = FindSectorEnds(this->Mesh, this->Tags, corner);
    this->CollectFaces(ends.Size > 0 ? ends.First : FanStep<Id>{ corner, true }, ends.Size);
    const double turn = ends.Size > 0 && !ends.First.Forward ? -1. : 1.;
    if (ends.Size == 0)
    {
      this->AppendInside(vertex, kind, rows);
    }
    else if (isCurve)
    {
      this->AppendOnCurve(vertex, kind, turn, rows);
    }
    else
    {
      this->AppendAtCorner(vertex, kind, ends, turn, rows);
    }
  }

private:
  /// Collects the edges around the vertex or in its sector, and in Across for each face there its
  /// edge opposite to the vertex.
  /// `size` is the number of faces of the sector, which has one edge more; 0 means all around the
  /// vertex.
  void CollectFaces(FanStep<Id> step, int size)
  {
    this->Edges.clear();
    this->Across.clear();
    const Id first = step.Corner;
    int faces = 0;
    do
    {
      this->Edges.push_back(this->Mesh.Edges[step.GetHalfEdgeIn(this->Mesh)]);
      this->Across.push_back(this->Mesh.Edges[this->Mesh.Next(step.Corner)]);
      if (++faces == size)
      {
        this->Edges.push_back(this->Mesh.Edges[step.GetHalfEdgeOut(this->Mesh)]);
        return;
      }
    } while (step.Advance(this->Mesh) && step.Corner != first);
  }
  /// Adds the row of the edge point of an edge, times a weight.
  void AddPoint(Id edge, double weight, RowBlock<Id>& rows)
  {
    const vtkIdType row = this->Mesh.NumberOfVertices + edge;
    this->Next.Clear();
    this->Scheme.AppendRows(this->Level, this->Tags, row, row + 1, this->Next);
    AddTimes(this->Next, weight, rows);
  }
  /// Adds, times a weight, the derivative at `vertex` of the limit of the four-point rule along
  /// `edge`, as if the curve ended at the vertex. The difference of two of these is the derivative
  /// of a curve that goes on.
  void AddAlongCurve(Id vertex, Id edge, double weight, RowBlock<Id>& rows)
  {
    this->AddPoint(edge, 8. * weight, rows);
    rows.Add(this->Mesh.GetOtherEnd(edge, vertex), -weight);
    rows.Add(vertex, -7. * weight);
  }
  void AppendInside(Id vertex, LimitKind kind, RowBlock<Id>& rows)
  {
    const auto sharp = std::find_if(this->Edges.begin(), this->Edges.end(),
      [this](Id e) { return this->Tags.Edges[e] != EdgeTag::Smooth; });
    if (sharp != this->Edges.end())
    {
      // A dart: the first tangent is along the crease, the second across it.
      if (kind == LimitKind::Tangent1)
      {
        this->AddAlongCurve(vertex, *sharp, 1., rows);
        return;
      }
      std::rotate(this->Edges.begin(), sharp, this->Edges.end());
    }
    const std::size_t k = this->Edges.size();
    auto wave = [kind, k](std::size_t j)
    {
      const double angle = 2. * Pi * static_cast<double>(j) / static_cast<double>(k);
      return kind == LimitKind::Tangent1 ? std::cos(angle) : std::sin(angle);
    };
    if (this->Level.Places[vertex] != 6)
    {
      for (std::size_t j = 0; j < k; ++j)
      {
        this->AddPoint(this->Edges[j], wave(j), rows);
      }
      return;
    }
    for (std::size_t j = 0; j < k; ++j)
    {
      this->AddPoint(this->Edges[j], 16. * wave(j), rows);
      rows.Add(this->Mesh.GetOtherEnd(this->Edges[j], vertex), wave(j));
      this->AddPoint(this->Across[j], -8. / 3. * (wave(j) + wave(j + 1)), rows);
    }
  }
  void AppendOnCurve(Id vertex, LimitKind kind, double turn, RowBlock<Id>& rows)
  {
    const std::size_t k = this->Edges.size() - 1;
    if (kind == LimitKind::Tangent1)
    {
      this->AddAlongCurve(vertex, this->Edges.front(), 1., rows);
      this->AddAlongCurve(vertex, this->Edges.back(), -1., rows);
      return;
    }
    if (k == 1)
    {
      // With one face the curve bends in the tangent plane. The second difference on the next level
      // minus a quarter of the one on this level is a vector of this plane, which the four-point
      // rule multiplies by 1/4 without adding anything.
      for (const Id edge : this->Edges)
      {
        this->AddPoint(edge, turn, rows);
        rows.Add(this->Mesh.GetOtherEnd(edge, vertex), -turn / 4.);
      }
      rows.Add(vertex, -3. / 2. * turn);
      return;
    }
    if (k == 3)
    {
      this->AppendAcrossRegularCurve(vertex, turn, rows);
      return;
    }
    double sum = 0.;
    for (std::size_t j = 1; j < k; ++j)
    {
      const double weight = turn * std::sin(static_cast<double>(j) * Pi / static_cast<double>(k));
      this->AddPoint(this->Edges[j], weight, rows);
      sum += weight;
    }
    rows.Add(vertex, -sum);
  }
  void AppendAcrossRegularCurve(Id vertex, double turn, RowBlock<Id>& rows)
  {
    constexpr double near[4] = { -2., 30., 30., -2. };
    constexpr double far[4] = { 1., 4., 4., 1. };
    constexpr double across[3] = { -6., -20., -6. };
    rows.Add(vertex, -34. * turn);
    for (std::size_t j = 0; j < 4; ++j)
    {
      this->AddPoint(this->Edges[j], near[j] * turn, rows);
      rows.Add(this->Mesh.GetOtherEnd(this->Edges[j], vertex), far[j] * turn);
    }
    for (std::size_t j = 0; j < 3; ++j)
    {
      this->AddPoint(this->Across[j], across[j] * turn, rows);
    }
  }
  /// The tangents at a corner: along the first sharp edge of the sector, and perpendicular to it in
  /// the plane of both.
  void AppendAtCorner(
    Id vertex, LimitKind kind, const SectorEnds<Id>& ends, double turn, RowBlock<Id>& rows)
  {
    if (kind == LimitKind::Tangent1)
    {
      this->AddAlongCurve(vertex, this->Edges.front(), 1., rows);
      return;
    }
    const Sector<Id>* sector = FindSector(this->Tags, vertex, ends);
    const double angle = sector ? sector->Angle : Pi / 2.;
    this->AddAlongCurve(
      vertex, this->Edges.front(), -turn * std::cos(angle) / std::sin(angle), rows);
    this->AddAlongCurve(vertex, this->Edges.back(), turn / std::sin(angle), rows);
  }

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const SurfaceScheme<Id>& Scheme;
  RowBlock<Id> Next;
  std::vector<Id> Edges;
  std::vector<Id> Across;
};

}

#endif
