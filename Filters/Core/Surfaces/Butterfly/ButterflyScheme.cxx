// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Butterfly/ButterflyScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Butterfly/ButterflyMasks.h"
#include "Core/Surfaces/Butterfly/ButterflyTangents.h"
#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// One end of a smooth edge, and the faces around it.
template <typename Id>
struct EdgeEnd
{
  Id Vertex = 0;
  Id Corner = 0;         ///< the vertex's corner in the edge's first face
  SectorEnds<Id> Sector; ///< Size 0: faces are all around
  bool IsRegular = false;
  /// At a regular end on a curve: which of the edge's two faces, 0 or 1, has an edge of the curve.
  /// Otherwise -1.
  int CurveSide = -1;
};

/// Makes the row of one edge at a time.
template <typename Id>
class EdgeRows
{
public:
  EdgeRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, RowBlock<Id>& rows)
    : Mesh(level.Mesh)
    , Valences(level.Places)
    , Tags(tags)
    , HasOtherTags(&tags != &level.Tags)
    , Rows(rows)
  {
  }

  /// Writes the columns of an edge with the mask ButterflyEdge; false: it has another.
  bool FindRegular(Id edge, Id columns[8])
  {
    columns[0] = this->Mesh.EdgeVertices[2 * edge];
    columns[1] = this->Mesh.EdgeVertices[2 * edge + 1];
    if (this->HasOtherTags || this->Tags.Edges[edge] != EdgeTag::Smooth ||
      !this->IsInside(columns[0]) || !this->IsInside(columns[1]))
    {
      return false;
    }
    this->SetHalfEdges(edge);
    Id* next = columns + 2;
    for (int side = 0; side < 2; ++side)
    {
      *next++ = this->GetOpposite(side);
      *next++ = this->GetWing(side, columns[0]);
      *next++ = this->GetWing(side, columns[1]);
    }
    return true;
  }

  void Append(Id edge)
  {
    if (this->Tags.Edges[edge] != EdgeTag::Smooth)
    {
      this->AppendCurve(edge, 1.);
      return;
    }
    this->SetHalfEdges(edge);
    const EdgeEnd<Id> ends[2] = { this->FindEnd(edge, 0), this->FindEnd(edge, 1) };
    if (ends[0].IsRegular && ends[1].IsRegular)
    {
      this->AppendRegular(ends);
      return;
    }
    const double factor = ends[0].IsRegular == ends[1].IsRegular ? 0.5 : 1.;
    for (const EdgeEnd<Id>& end : ends)
    {
      if (!end.IsRegular)
      {
        this->AppendExtraordinary(edge, end, factor);
      }
    }
  }

private:
  void SetHalfEdges(Id edge)
  {
    this->HalfEdges[0] = this->Mesh.EdgeCorners[edge];
    this->HalfEdges[1] = this->Mesh.Twins[this->HalfEdges[0]];
  }
  /// Whether a vertex has six faces and smooth edges all around.
  bool IsInside(Id vertex) const
  {
    return this->Tags.Vertices[vertex] == VertexTag::Smooth && this->Valences[vertex] == 6;
  }
  EdgeEnd<Id> FindEnd(Id edge, int which)
  {
    EdgeEnd<Id> end;
    end.Vertex = this->Mesh.EdgeVertices[2 * edge + which];
    end.Corner = GetCornerAt(this->Mesh, this->HalfEdges[0], end.Vertex);
    const VertexTag tag = this->Tags.Vertices[end.Vertex];
    if (tag != VertexTag::Smooth)
    {
      end.Sector = FindSectorEnds(this->Mesh, this->Tags, end.Corner);
    }
    if (end.Sector.Size == 0)
    {
      end.IsRegular = this->Valences[end.Vertex] == 6 && !this->HasOtherSharpEdges(end.Vertex);
    }
    else if (tag == VertexTag::Curve && end.Sector.Size == 3)
    {
      end.IsRegular = true;
      const Id first = this->Mesh.Edges[this->GetSide(0, end.Vertex)];
      end.CurveSide = this->Tags.Edges[first] == EdgeTag::Smooth;
    }
    return end;
  }

  bool HasOtherSharpEdges(Id vertex)
  {
    if (!this->HasOtherTags)
    {
      return false;
    }
    CollectSharpEdges(this->Mesh, this->Tags, vertex, this->Around);
    return !this->Around.empty();
  }
  /// Appends the four-point rule along the curve of an edge vw. Where the curve ends at v, the
  /// missing point is 2v - w.
  void AppendCurve(Id edge, double factor)
  {
    double weights[2] = { 9. / 16., 9. / 16. };
    for (int i = 0; i < 2; ++i)
    {
      const Id vertex = this->Mesh.EdgeVertices[2 * edge + i];
      this->Around.clear();
      if (this->Tags.Vertices[vertex] == VertexTag::Curve)
      {
        CollectCurveEdges(this->Mesh, this->Tags, vertex, this->Around);
      }
      if (this->Around.size() == 2 && (this->Around[0] == edge || this->Around[1] == edge))
      {
        const Id beyond = this->Around[this->Around[0] == edge ? 1 : 0];
        this->Rows.Add(this->Mesh.GetOtherEnd(beyond, vertex), -factor / 16.);
      }
      else
      {
        weights[i] -= 2. / 16.;
        weights[1 - i] += 1. / 16.;
      }
    }
    this->Rows.Add(this->Mesh.EdgeVertices[2 * edge], factor * weights[0]);
    this->Rows.Add(this->Mesh.EdgeVertices[2 * edge + 1], factor * weights[1]);
  }
  /// Both ends are regular.
  void AppendRegular(const EdgeEnd<Id>* ends)
  {
    const Id a = ends[0].Vertex;
    const Id b = ends[1].Vertex;
    const int sides[2] = { ends[0].CurveSide, ends[1].CurveSide };
    if (sides[0] < 0 && sides[1] < 0)
    {
      this->Rows.Add(a, 1. / 2.);
      this->Rows.Add(b, 1. / 2.);
      for (int side = 0; side < 2; ++side)
      {
        this->Rows.Add(this->GetOpposite(side), 1. / 8.);
        this->AddWing(side, a, -1. / 16.);
        this->AddWing(side, b, -1. / 16.);
      }
      return;
    }
    if (sides[0] < 0 || sides[1] < 0)
    {
      const Id inside = sides[0] < 0 ? a : b;
      const Id onCurve = sides[0] < 0 ? b : a;
      const int side = std::max(sides[0], sides[1]);
      this->Rows.Add(inside, 5. / 8.);
      this->Rows.Add(onCurve, 3. / 8.);
      this->Rows.Add(this->GetOpposite(1 - side), 3. / 16.);
      this->Rows.Add(this->GetOpposite(side), 1. / 16.);
      this->AddWing(1 - side, inside, -1. / 8.);
      this->AddWing(1 - side, onCurve, -1. / 16.);
      this->AddWing(side, inside, -1. / 16.);
      return;
    }
    this->Rows.Add(a, 1. / 2.);
    this->Rows.Add(b, 1. / 2.);
    if (sides[0] == sides[1])
    {
      const int side = 1 - sides[0];
      this->Rows.Add(this->GetOpposite(side), 1. / 4.);
      this->AddWing(side, a, -1. / 8.);
      this->AddWing(side, b, -1. / 8.);
      return;
    }
    // The missing wings complete parallelograms.
    this->Rows.Add(this->GetOpposite(0), 1. / 16.);
    this->Rows.Add(this->GetOpposite(1), 1. / 16.);
    this->AddWing(sides[1], a, -1. / 16.);
    this->AddWing(sides[0], b, -1. / 16.);
  }
  void AppendExtraordinary(Id edge, const EdgeEnd<Id>& end, double factor)
  {
    if (end.Sector.Size > 0)
    {
      this->AppendSector(edge, end, factor);
      return;
    }
    AppendButterflyRing(this->Mesh, edge, end.Vertex, end.Corner, factor, this->Rows);
  }
  void AppendSector(Id edge, const EdgeEnd<Id>& end, double factor)
  {
    const int k = end.Sector.Size;
    this->Around.clear(); // edges
    FanStep<Id> step = end.Sector.First;
    for (int j = 0; j < k; ++j)
    {
      this->Around.push_back(this->Mesh.Edges[step.GetHalfEdgeIn(this->Mesh)]);
      step.Advance(this->Mesh);
    }
    this->Around.push_back(this->Mesh.Edges[end.Sector.Last.GetHalfEdgeOut(this->Mesh)]);
    const int i = static_cast<int>(
      std::find(this->Around.begin(), this->Around.end(), edge) - this->Around.begin());
    const Sector<Id>* corner = this->Tags.Vertices[end.Vertex] == VertexTag::Corner
      ? FindSector(this->Tags, end.Vertex, end.Sector)
      : nullptr;
    const double flatness = corner ? corner->Flatness : 0.;
    const double kept = factor * (1. - flatness);
    double own = corner ? kept : kept * butterfly::CurveCentre(k, i);
    for (int j = 0; j <= k; ++j)
    {
      const double weight = kept *
        (corner ? butterfly::CornerRing(k, corner->Angle, i, j) : butterfly::CurveRing(k, i, j));
      own -= corner ? weight : 0.;
      this->Rows.Add(this->Mesh.GetOtherEnd(this->Around[j], end.Vertex), weight);
    }
    if (flatness > 0.)
    {
      // Move towards the plane of the new points on the two sharp edges.
      const Id curves[2] = { this->Around.front(), this->Around.back() };
      own += factor * flatness;
      for (int last = 0; last < 2; ++last)
      {
        const double weight =
          factor * flatness * butterfly::LinearInSector(k, corner->Angle, i, last == 1);
        own -= weight;
        this->AppendCurve(curves[last], weight);
      }
    }
    this->Rows.Add(end.Vertex, own);
  }

  Id GetOpposite(int side) const
  {
    return this->Mesh.Vertices[this->Mesh.Previous(this->HalfEdges[side])];
  }
  /// The half-edge between an end and the opposite vertex of a face.
  Id GetSide(int side, Id vertex) const
  {
    const Id halfEdge = this->HalfEdges[side];
    return this->Mesh.Vertices[halfEdge] == vertex ? this->Mesh.Previous(halfEdge)
                                                   : this->Mesh.Next(halfEdge);
  }
  /// The vertex across that half-edge.
  Id GetWing(int side, Id vertex) const { return this->GetBeyond(this->GetSide(side, vertex)); }
  Id GetBeyond(Id halfEdge) const
  {
    return this->Mesh.Vertices[this->Mesh.Previous(this->Mesh.Twins[halfEdge])];
  }
  void AddWing(int side, Id vertex, double weight)
  {
    this->Rows.Add(this->GetWing(side, vertex), weight);
  }

  const PolygonMesh<Id>& Mesh;
  const Buffer<Id>& Valences;
  const SurfaceTags<Id>& Tags;
  bool HasOtherTags; ///< whether more edges are sharp than Prepare saw
  RowBlock<Id>& Rows;
  Id HalfEdges[2] = { 0, 0 };
  std::vector<Id> Around;
};

template <typename Id>
class ButterflyScheme : public PrimalScheme<Id, 3>
{
public:
  bool HasCornersOfOneFace() const override { return true; }
  DenseRows GetDenseRows() const override { return DenseRows::OfVertices; }
  FaceMemory GetFaceMemory() const override { return { 32., 0.5, 9., 26., 90., 120., 26. }; }
  /// Sets Places: for each vertex with one closed fan and smooth edges only the number of its
  /// faces, otherwise 0.
  void Prepare(SurfaceLevel<Id>& level) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    level.Places = Buffer<Id>(mesh.NumberOfVertices);
    const auto count = [&mesh, &level](Id corner)
    {
      Id faces = 0;
      FanStep<Id> step{ corner, true };
      do
      {
        ++faces;
        const Id edge = mesh.Edges[step.GetHalfEdgeIn(mesh)];
        if (level.Tags.Edges[edge] != EdgeTag::Smooth || !step.Advance(mesh))
        {
          return Id(0);
        }
      } while (step.Corner != corner);
      return faces;
    };
    ForEach(mesh.NumberOfVertices,
      [&](vtkIdType v)
      {
        const Id corner = mesh.VertexCorners[v];
        level.Places[v] = corner < 0 ? 0 : count(corner);
      });
  }
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    EdgeRows<Id> edges(level, tags, rows);
    ForKindsOfRows<2>({ mesh.NumberOfVertices, mesh.GetNumberOfEdges() }, begin, end,
      [&](std::size_t kind, vtkIdType first, vtkIdType last)
      {
        if (kind == 0)
        {
          rows.AddCopies(first, last - first);
          return;
        }
        AppendRegularGroups<1>(
          ButterflyEdge, first, last, [&](vtkIdType edge, Id* columns)
          { return edges.FindRegular(static_cast<Id>(edge), columns); },
          [&](vtkIdType edge) { edges.Append(static_cast<Id>(edge)); }, rows);
      });
  }

  bool HasLimitsOfNext(const SurfaceLevel<Id>& /*level*/, bool tangents) const override
  {
    return !tangents;
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    if (kind == LimitKind::Position)
    {
      rows.AddCopies(begin, end - begin);
      return;
    }
    ButterflyTangents<Id> tangents(level, tags, *this);
    const bool hasOtherTags = &tags != &level.Tags;
    const auto isInside = [&](Id v)
    { return tags.Vertices[v] == VertexTag::Smooth && level.Places[v] == 6 && !hasOtherTags; };
    AppendCycleRows(
      level.Mesh, ButterflyTangentsInside[kind == LimitKind::Tangent1 ? 0 : 1], begin, end,
      isInside,
      [&](Id, const std::vector<FanStep<Id>>& steps, Id* columns)
      {
        bool isRegular = !steps.empty();
        for (std::size_t j = 0; isRegular && j < steps.size(); ++j)
        {
          const PolygonMesh<Id>& mesh = level.Mesh;
          const Id neighbour = GetNeighbour(mesh, steps[j]);
          isRegular = isInside(neighbour);
          if (isRegular)
          {
            const Id across = mesh.Twins[mesh.Next(steps[j].Corner)];
            const Id side =
              mesh.Vertices[across] == neighbour ? mesh.Previous(across) : mesh.Next(across);
            columns[j] = neighbour;
            columns[6 + j] = mesh.Vertices[mesh.Previous(across)];
            columns[12 + j] = mesh.Vertices[mesh.Previous(mesh.Twins[side])];
          }
        }
        return isRegular;
      },
      [&](Id vertex, const std::vector<FanStep<Id>>&) { tangents.Append(vertex, kind, rows); },
      rows);
  }
  const double* GetSecondTangent(const double* first) const override
  {
    return first == ButterflyTangentsInside[0].data() ? ButterflyTangentsInside[1].data() : nullptr;
  }
};

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeButterflyScheme()
{
  return std::make_unique<ButterflyScheme<Id>>();
}

SUBDIVISION_COMPILE_FUNCTION(MakeButterflyScheme);

}
