// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/FourEight/FourEightLimits.h"
#include "Core/Surfaces/FourEight/FourEightRefinement.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/FixedEdges.h"

namespace subdivision
{
namespace
{

template <typename Id>
class FourEightScheme : public SurfaceScheme<Id>
{
public:
  bool NeedsTriangles() const override { return false; }
  bool HalvesEdges() const override { return false; }
  bool HasCornersOfOneFace() const override { return true; }
  DenseRows GetDenseRows() const override { return DenseRows::OfLimits; }
  double CountFaces(double faces, double corners, int steps) const override
  {
    return steps > 0 ? corners * std::pow(2., steps - 1) : faces;
  }
  void RestrictTags(SurfaceLevel<Id>& level) const override { FixEdges(level); }
  void Prepare(SurfaceLevel<Id>& level) const override { CountFourEightPlaces(level); }
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return FourEightTopology<Id>(level).GetNumberOfVertices();
  }
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override
  {
    return RefineFourEight(level, depth);
  }
  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override
  {
    ListFourEightChildren(level, segments, children);
  }
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override
  {
    return RefineFourEightTags(level, tags);
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override;
  int GetCarrierPeriod() const override { return 2; }
  void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, bool areWhole,
    Buffer<Carrier<Id>>& children) const override;
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override;
  vtkIdType GetOrientingFace(const SurfaceLevel<Id>& level, vtkIdType child) const override
  {
    return level.Mesh.GetFace(FourEightTopology<Id>(level).FindCornerOf(static_cast<Id>(child)));
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& /*tags*/,
    LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    AppendFourEightLimits(*this, level, kind, begin, end, rows);
  }

private:
  void AppendVertex(const FourEightTopology<Id>& topology, const SurfaceTags<Id>& tags, Id vertex,
    std::vector<Id>& edges, RowBlock<Id>& rows) const;
};

template <typename Id>
void FourEightScheme<Id>::GetParents(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const FourEightTopology<Id> topology(level);
  const Id vertex = static_cast<Id>(row);
  if (row < mesh.NumberOfVertices)
  {
    parents.assign({ row });
  }
  else if (vertex < topology.GetFirstMiddle())
  {
    const Id face = topology.FindFace(vertex - topology.GetFirstCentre());
    const Id* first = mesh.Vertices.data() + mesh.GetFirst(face);
    parents.assign(first, first + mesh.GetSize(face));
  }
  else
  {
    const Id edge = topology.FindFixed(vertex - topology.GetFirstMiddle());
    parents.assign({ mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] });
  }
}

/// A child between two faces that lie in one control face each gets these two: as First that of its
/// last corner, as Second that of its second corner, which are both new. In the next step each edge
/// that is not fixed ends at one of these two corners, and its child lies in the control face of
/// that corner.
template <typename Id>
void FourEightScheme<Id>::CarryFaces(const SurfaceLevel<Id>& level,
  const Buffer<Carrier<Id>>& faces, bool areWhole, Buffer<Carrier<Id>>& children) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const FourEightTopology<Id> topology(level);
  children = Buffer<Carrier<Id>>(topology.GetNumberOfFaces());
  ForEach(mesh.GetNumberOfCorners(),
    [&](vtkIdType c)
    {
      const Id corner = static_cast<Id>(c);
      if (!topology.HasChild(corner))
      {
        return;
      }
      const Id face = mesh.GetFace(corner);
      const Id other = topology.IsFixed(corner) ? face : mesh.GetFace(mesh.Twins[corner]);
      const bool isOfLast = corner - mesh.GetFirst(face) >= 2;
      const Id carrier = isOfLast ? faces[face].First : faces[face].Second;
      children[topology.GetChild(corner)] = areWhole
        ? Carrier<Id>{ faces[face].First, faces[other].First }
        : Carrier<Id>{ carrier, carrier };
    });
}

template <typename Id>
void FourEightScheme<Id>::AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const FourEightTopology<Id> topology(level);
  const vtkIdType middles = topology.GetFirstMiddle();
  std::vector<Id> edges;
  vtkIdType row = begin;
  for (; row < std::min(end, mesh.NumberOfVertices); ++row)
  {
    this->AppendVertex(topology, tags, static_cast<Id>(row), edges, rows);
    rows.EndRow();
  }
  if (row < std::min(end, middles))
  {
    Id face = topology.FindFace(static_cast<Id>(row) - topology.GetFirstCentre());
    for (; row < std::min(end, middles); ++row, ++face)
    {
      while (topology.IsCut(face))
      {
        ++face;
      }
      const Id first = mesh.GetFirst(face);
      const Id size = mesh.GetSize(face);
      for (Id c = first; c < first + size; ++c)
      {
        rows.Add(mesh.Vertices[c], 1. / size);
      }
      rows.EndRow();
    }
  }
  for (; row < end; ++row)
  {
    const Id edge = topology.FindFixed(static_cast<Id>(row - middles));
    rows.Add(mesh.EdgeVertices[2 * edge], 0.5);
    rows.Add(mesh.EdgeVertices[2 * edge + 1], 0.5);
    rows.EndRow();
  }
}

/// Smooth vertices: half from the mean of their neighbours. Curves: cubic B-spline in even steps.
template <typename Id>
void FourEightScheme<Id>::AppendVertex(const FourEightTopology<Id>& topology,
  const SurfaceTags<Id>& tags, Id vertex, std::vector<Id>& edges, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = topology.Mesh;
  if (tags.Vertices[vertex] != VertexTag::Smooth)
  {
    if (topology.IsEven)
    {
      AppendCurveVertex(mesh, tags, vertex, 3. / 4., edges, rows);
    }
    else
    {
      rows.Add(vertex, 1.);
    }
    return;
  }
  rows.Add(vertex, 0.5);
  const std::size_t first = rows.GetNumberOfEntries();
  VisitCycle(mesh, mesh.VertexCorners[vertex],
    [&](const FanStep<Id>& step)
    {
      const Id in = step.GetHalfEdgeIn(mesh);
      rows.Add(mesh.Vertices[in == step.Corner ? mesh.Next(in) : in], 0.);
    });
  const double weight = 0.5 / static_cast<double>(rows.GetNumberOfEntries() - first);
  for (std::size_t entry = first; entry < rows.GetNumberOfEntries(); ++entry)
  {
    rows.SetWeight(entry, weight); // known after the walk around the vertex
  }
}

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeFourEightScheme()
{
  return std::make_unique<FourEightScheme<Id>>();
}

SUBDIVISION_COMPILE_FUNCTION(MakeFourEightScheme);

}
