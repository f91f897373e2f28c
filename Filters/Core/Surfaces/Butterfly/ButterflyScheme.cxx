// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Butterfly/ButterflyScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Butterfly/ButterflyMasks.h"
#include "Core/Surfaces/Butterfly/ButterflyTangents.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <array>

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

template <typename Id>
class ButterflyScheme : public PrimalScheme<Id, 3>
{
public:
  bool HasCornersOfOneFace() const override { return true; }
  DenseRows GetDenseRows() const override { return DenseRows::OfVertices; }
  FaceMemory GetFaceMemory() const override { return { 32., 0.5, 9., 26., 90., 120., 26. }; }
  /// Sets Places: for each vertex with one closed fan and smooth edges only the number of its
  /// faces, otherwise 0.
  void Prepare(SurfaceLevel<Id>& level) const override;
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override;

  bool HasLimitsOfNext(const SurfaceLevel<Id>& /*level*/, bool tangents) const override
  {
    return !tangents;
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override;
};

template <typename Id>
void ButterflyScheme<Id>::Prepare(SurfaceLevel<Id>& level) const
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
  const vtkIdType firstNew =
    level.VerticesBefore < 0 ? mesh.NumberOfVertices : level.VerticesBefore;
  // The point of an edge has only smooth edges around it if its edge is, of which both halves have
  // the tag.
  const auto isInside = [&](vtkIdType vertex)
  { return vertex >= firstNew && level.Tags.Edges[2 * (vertex - firstNew)] == EdgeTag::Smooth; };
  ForEach(mesh.NumberOfVertices,
    [&](vtkIdType v)
    {
      const Id corner = mesh.VertexCorners[v];
      level.Places[v] = corner < 0 ? 0 : isInside(v) ? 6 : count(corner);
    });
}

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

  /// The same for the three edges inside a triangle of the level before, across each of its corners
  /// x: the children of triangle f are 4 f + i at x_i, whose corner i it is, and 4 f + 3, whose
  /// corners p_i are the points of the edges from x_i on.
  bool FindInside(Id face, Id columns[24]) const
  {
    const Id first = 12 * face;
    const Id* x = this->Mesh.Vertices.data() + first;
    const Id* p = x + 9;
    if (this->HasOtherTags || !this->IsInside(p[0]) || !this->IsInside(p[1]) ||
      !this->IsInside(p[2]))
    {
      return false;
    }
    constexpr Id before[3] = { 2, 3, 7 }; // the half-edges that end at x_i
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const int last = (i + 2) % 3;
      *columns++ = p[i];
      *columns++ = p[last];
      *columns++ = x[4 * i];
      *columns++ = this->GetBeyond(first + 4 * i);
      *columns++ = this->GetBeyond(first + before[i]);
      *columns++ = p[next];
      *columns++ = x[4 * next];
      *columns++ = x[4 * last];
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
  EdgeEnd<Id> FindEnd(Id edge, int which);
  bool HasOtherSharpEdges(Id vertex)
  {
    if (!this->HasOtherTags)
    {
      return false;
    }
    CollectSharpEdges(this->Mesh, this->Tags, vertex, this->Around);
    return !this->Around.empty();
  }
  void AppendCurve(Id edge, double factor);
  void AppendRegular(const EdgeEnd<Id>* ends);
  void AppendExtraordinary(Id edge, const EdgeEnd<Id>& end, double factor);
  void AppendSector(Id edge, const EdgeEnd<Id>& end, double factor);

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
EdgeEnd<Id> EdgeRows<Id>::FindEnd(Id edge, int which)
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

/// Appends the four-point rule along the curve of an edge vw. Where the curve ends at v, the
/// missing point is 2v - w.
template <typename Id>
void EdgeRows<Id>::AppendCurve(Id edge, double factor)
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
template <typename Id>
void EdgeRows<Id>::AppendRegular(const EdgeEnd<Id>* ends)
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

template <typename Id>
void EdgeRows<Id>::AppendExtraordinary(Id edge, const EdgeEnd<Id>& end, double factor)
{
  if (end.Sector.Size > 0)
  {
    this->AppendSector(edge, end, factor);
    return;
  }
  AppendButterflyRing(this->Mesh, edge, end.Vertex, end.Corner, factor, this->Rows);
}

template <typename Id>
void EdgeRows<Id>::AppendSector(Id edge, const EdgeEnd<Id>& end, double factor)
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

template <typename Id>
void ButterflyScheme<Id>::AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  EdgeRows<Id> edges(level, tags, rows);
  // Edges inside the triangles of the level before come last.
  const vtkIdType inside = level.VerticesBefore < 0 ? 0 : mesh.NumberOfFaces / 4 * 3;
  const vtkIdType others = mesh.GetNumberOfEdges() - inside;
  ForKindsOfRows<3>({ mesh.NumberOfVertices, others, inside }, begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      const auto append = [&](vtkIdType edge)
      { edges.Append(static_cast<Id>(kind == 1 ? edge : others + edge)); };
      switch (kind)
      {
        case 0:
          rows.AddCopies(first, last - first);
          break;
        case 1:
          AppendRegularGroups<1>(
            ButterflyEdge, first, last, [&](vtkIdType edge, Id* columns)
            { return edges.FindRegular(static_cast<Id>(edge), columns); }, append, rows);
          break;
        default:
          AppendRegularGroups<3>(
            ButterflyEdge, first, last, [&](vtkIdType face, Id* columns)
            { return edges.FindInside(static_cast<Id>(face), columns); }, append, rows);
          break;
      }
    });
}

template <typename Id>
void ButterflyScheme<Id>::AppendLimitRows(const SurfaceLevel<Id>& level,
  const SurfaceTags<Id>& tags, LimitKind kind, vtkIdType begin, vtkIdType end,
  RowBlock<Id>& rows) const
{
  ButterflyTangents<Id> tangents(level, tags, *this);
  for (vtkIdType v = begin; v < end; ++v)
  {
    if (kind == LimitKind::Position)
    {
      rows.Add(v, 1.);
    }
    else
    {
      tangents.Append(static_cast<Id>(v), kind, rows);
    }
    rows.EndRow();
  }
}

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeButterflyScheme()
{
  return std::make_unique<ButterflyScheme<Id>>();
}

SUBDIVISION_COMPILE_FUNCTION(MakeButterflyScheme);

}
