// SPDX-License-Identifier: BSD-3-Clause
#include "ButterflyScheme.h"

#include "PrimalRefinement.h"
#include "SchemeMasks.h"
#include "SurfaceRings.h"

namespace subdivision
{
namespace
{

/// One end of a smooth edge, as the table of the survey's section 4 sees it.
template <typename Id>
struct EdgeEnd
{
  Id Vertex;
  FanStep<Id> Start{ 0, true }; ///< a face at the edge, entered by it
  SectorEnds<Id> Ends;          ///< Size 0: no curve ends the walk around the vertex
  int Size = 0;                 ///< faces around the vertex, or in the sector
  double Angle = 0.;            ///< of a corner's sector; 0 on smooth curves
  bool IsRegular = false;

  bool IsOnCurve() const { return this->Ends.Size > 0; }
};

template <typename Id>
class ButterflyScheme : public SurfaceScheme<Id>
{
public:
  bool NeedsTriangles() const override { return true; }
  bool HasCornersOfOneFace() const override { return true; }
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return level.Mesh.NumberOfVertices + level.Mesh.GetNumberOfEdges();
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override
  {
    const vtkIdType edge = row - level.Mesh.NumberOfVertices;
    if (edge < 0)
    {
      parents.assign({ row });
      return;
    }
    parents.assign({ level.Mesh.EdgeVertices[2 * edge], level.Mesh.EdgeVertices[2 * edge + 1] });
  }
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override
  {
    return RefineTriangles(level, depth);
  }
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override
  {
    return RefineTriangleTags(level, tags);
  }
  void GetFaceParents(const SurfaceLevel<Id>& level, Buffer<vtkIdType>& parents) const override
  {
    parents = Buffer<vtkIdType>(4 * level.Mesh.NumberOfFaces);
    ForEach(parents.size(), [&parents](vtkIdType i) { parents[i] = i / 4; });
  }
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override;
};

/// Four points along a curve; beyond its end, the reflection there.
template <typename Id>
void AppendCurveEdge(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, RowBlock<Id>& rows)
{
  std::vector<Id> sharp;
  for (int end = 0; end < 2; ++end)
  {
    const Id vertex = mesh.EdgeVertices[2 * edge + end];
    const Id other = mesh.EdgeVertices[2 * edge + 1 - end];
    sharp.clear();
    if (tags.Vertices[vertex] == VertexTag::Curve)
    {
      CollectSharpEdges(mesh, tags, vertex, sharp);
    }
    if (sharp.size() == 2)
    {
      rows.Add(vertex, FourPointEnd);
      rows.Add(mesh.GetOtherEnd(sharp[0] == edge ? sharp[1] : sharp[0], vertex), FourPointBeyond);
    }
    else
    {
      rows.Add(vertex, FourPointEnd + 2. * FourPointBeyond);
      rows.Add(other, -FourPointBeyond);
    }
  }
}

template <typename Id>
EdgeEnd<Id> DescribeEnd(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, Id vertex)
{
  EdgeEnd<Id> end;
  end.Vertex = vertex;
  const Id corner = GetCornerAt(mesh, mesh.EdgeCorners[edge], vertex);
  end.Start = { corner, mesh.Edges[corner] == edge };
  const VertexTag tag = tags.Vertices[vertex];
  if (tag == VertexTag::Curve || tag == VertexTag::Corner)
  {
    end.Ends = FindSectorEnds(mesh, tags, corner);
    end.Size = end.Ends.Size;
    end.IsRegular = tag == VertexTag::Curve && end.Size == 3;
    if (tag == VertexTag::Corner && end.Size > 0)
    {
      const Sector<Id>* sector = FindSector(tags, vertex, end.Ends);
      end.Angle = sector ? sector->Angle : 0.;
    }
  }
  if (!end.IsOnCurve())
  {
    VisitFan(mesh, corner, [&end](const FanStep<Id>&) { ++end.Size; });
    end.IsRegular = end.Size == 6;
  }
  return end;
}

/// The rule of an extraordinary end, times `factor`.
template <typename Id>
void AppendEnd(
  const PolygonMesh<Id>& mesh, Id edge, const EdgeEnd<Id>& end, double factor, RowBlock<Id>& rows)
{
  const int k = end.Size;
  auto neighbour = [&](Id halfEdge) { return mesh.GetOtherEnd(mesh.Edges[halfEdge], end.Vertex); };
  if (!end.IsOnCurve())
  {
    rows.Add(end.Vertex, factor * ButterflyCentre);
    FanStep<Id> step = end.Start;
    for (int j = 0; j < k; ++j)
    {
      rows.Add(neighbour(step.GetHalfEdgeIn(mesh)), factor * ButterflyRing(k, j));
      step.Advance(mesh);
    }
    return;
  }
  int i = 0;
  FanStep<Id> step = end.Ends.First;
  while (mesh.Edges[step.GetHalfEdgeIn(mesh)] != edge)
  {
    ++i;
    step.Advance(mesh);
  }
  double own = 1.;
  step = end.Ends.First;
  for (int j = 0; j <= k; ++j)
  {
    const Id halfEdge = j < k ? step.GetHalfEdgeIn(mesh) : end.Ends.Last.GetHalfEdgeOut(mesh);
    const double weight =
      end.Angle > 0. ? ButterflyCornerRing(k, end.Angle, i, j) : ButterflySectorRing(k, i, j);
    own -= weight;
    rows.Add(neighbour(halfEdge), factor * weight);
    step.Advance(mesh);
  }
  rows.Add(end.Vertex, factor * own);
}

/// Both ends are regular: eight points, some of which curves hide.
template <typename Id>
class RegularEdge
{
public:
  RegularEdge(
    const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, const EdgeEnd<Id> (&ends)[2])
  {
    const Id corners[2] = { mesh.EdgeCorners[edge], mesh.Twins[mesh.EdgeCorners[edge]] };
    for (int side = 0; side < 2; ++side)
    {
      this->Opposite[side] = mesh.Vertices[mesh.Previous(corners[side])];
      for (int end = 0; end < 2; ++end)
      {
        this->Ends[end] = ends[end].Vertex;
        const bool atBegin = mesh.Vertices[corners[side]] == ends[end].Vertex;
        const Id outer = atBegin ? mesh.Previous(corners[side]) : mesh.Next(corners[side]);
        const Id twin = mesh.Twins[outer];
        const bool hidden =
          ends[end].IsOnCurve() && tags.Edges[mesh.Edges[outer]] != EdgeTag::Smooth;
        this->Wings[end][side] = hidden || twin < 0 ? -1 : mesh.Vertices[mesh.Previous(twin)];
      }
    }
  }

  void Append(RowBlock<Id>& rows) const
  {
    const int hidden[2] = { this->FindHidden(0), this->FindHidden(1) };
    if (hidden[0] >= 0 && hidden[0] == hidden[1])
    {
      this->AppendBothOnOneSide(1 - hidden[0], rows);
    }
    else if ((hidden[0] >= 0) != (hidden[1] >= 0))
    {
      const int curve = hidden[0] >= 0 ? 0 : 1;
      this->AppendInteriorToCurve(curve, hidden[curve], rows);
    }
    else
    {
      this->AppendEight(rows);
    }
  }

private:
  int FindHidden(int end) const
  {
    return this->Wings[end][0] < 0 ? 0 : this->Wings[end][1] < 0 ? 1 : -1;
  }

  void AppendEight(RowBlock<Id>& rows) const
  {
    for (int end = 0; end < 2; ++end)
    {
      rows.Add(this->Ends[end], ButterflyEnd);
      rows.Add(this->Opposite[end], ButterflyOpposite);
      for (int side = 0; side < 2; ++side)
      {
        if (this->Wings[end][side] >= 0)
        {
          rows.Add(this->Wings[end][side], ButterflyWing);
          continue;
        }
        rows.Add(this->Ends[end], ButterflyWing);
        rows.Add(this->Opposite[side], ButterflyWing);
        rows.Add(this->Ends[1 - end], -ButterflyWing);
      }
    }
  }
  void AppendBothOnOneSide(int side, RowBlock<Id>& rows) const
  {
    for (int end = 0; end < 2; ++end)
    {
      rows.Add(this->Ends[end], creasecrease::End);
      rows.Add(this->Wings[end][side], creasecrease::Wing);
    }
    rows.Add(this->Opposite[side], creasecrease::Opposite);
  }
  void AppendInteriorToCurve(int curve, int hidden, RowBlock<Id>& rows) const
  {
    const int inside = 1 - hidden;
    rows.Add(this->Ends[1 - curve], interiorcrease::Interior);
    rows.Add(this->Ends[curve], interiorcrease::Crease);
    rows.Add(this->Opposite[inside], interiorcrease::OppositeInside);
    rows.Add(this->Opposite[hidden], interiorcrease::OppositeOnCrease);
    rows.Add(this->Wings[1 - curve][inside], interiorcrease::WingInteriorInside);
    rows.Add(this->Wings[1 - curve][hidden], interiorcrease::OtherWing);
    rows.Add(this->Wings[curve][inside], interiorcrease::OtherWing);
  }

  Id Ends[2];
  Id Opposite[2];
  Id Wings[2][2]; ///< of each end, on each side; -1: hidden
};

template <typename Id>
void ButterflyScheme<Id>::AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  for (vtkIdType row = begin; row < end; ++row)
  {
    if (row < mesh.NumberOfVertices)
    {
      rows.Add(row, 1.);
      rows.EndRow();
      continue;
    }
    const Id edge = static_cast<Id>(row - mesh.NumberOfVertices);
    const Id corner = mesh.EdgeCorners[edge];
    if (tags.Edges[edge] != EdgeTag::Smooth || corner < 0 || mesh.Twins[corner] < 0)
    {
      AppendCurveEdge(mesh, tags, edge, rows);
      rows.EndRow();
      continue;
    }
    const EdgeEnd<Id> ends[2] = { DescribeEnd(mesh, tags, edge, mesh.EdgeVertices[2 * edge]),
      DescribeEnd(mesh, tags, edge, mesh.EdgeVertices[2 * edge + 1]) };
    if (ends[0].IsRegular && ends[1].IsRegular)
    {
      RegularEdge<Id>(mesh, tags, edge, ends).Append(rows);
    }
    else
    {
      const double factor = ends[0].IsRegular || ends[1].IsRegular ? 1. : 0.5;
      for (const EdgeEnd<Id>& side : ends)
      {
        if (!side.IsRegular)
        {
          AppendEnd(mesh, edge, side, factor, rows);
        }
      }
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

template std::unique_ptr<SurfaceScheme<int>> MakeButterflyScheme();
template std::unique_ptr<SurfaceScheme<long long>> MakeButterflyScheme();

}
