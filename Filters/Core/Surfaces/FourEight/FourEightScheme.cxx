// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/FourEight/FourEightLimits.h"
#include "Core/Surfaces/FourEight/FourEightRefinement.h"
#include "Core/Surfaces/FourEight/FourEightRegular.h"
#include "Core/Surfaces/FourEight/FourEightRim.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/FixedEdges.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"

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
  FaceMemory GetFaceMemory() const override { return { 32., 0.5, 16., 66., 122., 155. }; }
  double CountFaces(double faces, double corners, int steps) const override
  {
    return steps > 0 ? corners * std::pow(2., steps - 1) : faces;
  }
  void RestrictTags(SurfaceLevel<Id>& level) const override { FixEdges(level); }
  void CloseRim(const SurfaceLevel<Id>& whole, SurfacePatch<Id>& patch) const override
  {
    subdivision::CloseRim(whole, patch);
  }
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
  bool WritesFaces() const override { return true; }
  void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const override
  {
    WriteFourEight(level, ids);
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
  static void AppendVertices(const FourEightTopology<Id>& topology, const SurfaceTags<Id>& tags,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);
  static void AppendCentres(
    const FourEightTopology<Id>& topology, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);
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

/// A child between two faces that lie in one control face each gets these two: First is the control
/// face of its last corner, Second of its second corner, which are both new. In the next step each
/// edge that is not fixed ends at one of these two corners, and its child lies in the control face
/// of that corner.
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
  ForKindsOfRows<3>(
    { mesh.NumberOfVertices, topology.GetNumberOfCentres(), topology.GetNumberOfFixed() }, begin,
    end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      if (kind == 0)
      {
        AppendVertices(topology, tags, first, last, rows);
      }
      else if (kind == 1)
      {
        AppendCentres(topology, first, last, rows);
      }
      for (vtkIdType row = first; row < last && kind == 2; ++row)
      {
        const Id edge = topology.FindFixed(static_cast<Id>(row));
        rows.Add(mesh.EdgeVertices[2 * edge], 0.5);
        rows.Add(mesh.EdgeVertices[2 * edge + 1], 0.5);
        rows.EndRow();
      }
    });
}

/// Smooth vertices: half from the mean of their neighbours. Curves: cubic B-spline in even steps.
template <typename Id>
void FourEightScheme<Id>::AppendVertices(const FourEightTopology<Id>& topology,
  const SurfaceTags<Id>& tags, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  using Steps = typename CycleWalks<Id>::Steps;
  const PolygonMesh<Id>& mesh = topology.Mesh;
  std::vector<Id> edges;
  const auto isSmooth = [&tags](Id vertex) { return tags.Vertices[vertex] == VertexTag::Smooth; };
  AppendCycleRows(
    mesh, FourEightVertex, begin, end, isSmooth,
    [&mesh](Id vertex, const Steps& steps, Id* columns)
    {
      if (steps.size() != 4)
      {
        return false;
      }
      columns[0] = vertex;
      const FanStep<Id>* step = steps.data();
      for (int k = 1; k < 5; ++k)
      {
        columns[k] = GetNeighbour(mesh, *step++);
      }
      return true;
    },
    [&](Id vertex, const Steps& steps)
    {
      if (!isSmooth(vertex) && topology.IsEven)
      {
        AppendCurveVertex(mesh, tags, vertex, 3. / 4., edges, rows);
        return;
      }
      rows.Add(vertex, isSmooth(vertex) ? 0.5 : 1.);
      for (const FanStep<Id>& step : steps)
      {
        rows.Add(GetNeighbour(mesh, step), 0.5 / static_cast<double>(steps.size()));
      }
    },
    rows);
}

/// The means of faces that are not cut.
template <typename Id>
void FourEightScheme<Id>::AppendCentres(
  const FourEightTopology<Id>& topology, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const PolygonMesh<Id>& mesh = topology.Mesh;
  Id face = topology.FindFace(static_cast<Id>(begin));
  const auto findNext = [&]
  {
    while (topology.IsCut(face))
    {
      ++face;
    }
    return mesh.GetFirst(face);
  };
  for (vtkIdType row = begin; row < end; ++row)
  {
    row += rows.AddRun(FourEightCentre, end - row,
      [&](vtkIdType, Id* columns)
      {
        const Id first = findNext();
        if (mesh.GetSize(face) != 4)
        {
          return false;
        }
        std::copy_n(mesh.Vertices.data() + first, 4, columns);
        ++face;
        return true;
      });
    if (row < end)
    {
      const Id first = findNext();
      const Id size = mesh.GetSize(face++);
      for (Id c = first; c < first + size; ++c)
      {
        rows.Add(mesh.Vertices[c], 1. / size);
      }
      rows.EndRow();
    }
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
