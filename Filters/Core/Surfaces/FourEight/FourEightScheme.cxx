// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/FourEight/FourEightLimits.h"
#include "Core/Surfaces/FourEight/FourEightMasks.h"
#include "Core/Surfaces/FourEight/FourEightRefinement.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SurfacePatch.h"

namespace subdivision
{
namespace
{

template <typename T>
void Extend(Buffer<T>& buffer, vtkIdType by)
{
  Buffer<T> longer(buffer.size() + by);
  std::copy(buffer.begin(), buffer.end(), longer.begin());
  buffer = std::move(longer);
}

/// The corners at whose edges the patch ends and the level goes on.
template <typename Id>
std::vector<Id> FindRim(const PolygonMesh<Id>& whole, const SurfacePatch<Id>& patch)
{
  const PolygonMesh<Id>& mesh = patch.Level.Mesh;
  std::vector<Id> rim;
  for (const Id corner : InTurn(static_cast<Id>(mesh.GetNumberOfCorners())))
  {
    const Id face = mesh.GetFace(corner);
    const Id same = whole.GetFirst(patch.Faces[face]) + corner - mesh.GetFirst(face);
    if (mesh.Twins[corner] < 0 && whole.Twins[same] >= 0)
    {
      rim.push_back(corner);
    }
  }
  return rim;
}

template <typename Id>
class RimMaker
{
public:
  RimMaker(PolygonMesh<Id>& mesh, SurfaceTags<Id>& tags)
    : Mesh(mesh)
    , Tags(tags)
  {
  }

  void Run(const std::vector<Id>& rim)
  {
    PolygonMesh<Id>& mesh = this->Mesh;
    const auto size = static_cast<vtkIdType>(rim.size());
    this->Vertex = static_cast<Id>(mesh.NumberOfVertices);
    this->Edge = static_cast<Id>(mesh.GetNumberOfEdges());
    this->Corner = static_cast<Id>(mesh.GetNumberOfCorners());
    this->StoreOffsets(3 * size);
    for (Buffer<Id>* of : { &mesh.Vertices, &mesh.Edges, &mesh.Twins })
    {
      Extend(*of, 9 * size);
    }
    Extend(mesh.EdgeVertices, 10 * size);
    Extend(mesh.EdgeCorners, 5 * size);
    Extend(mesh.VertexCorners, 2 * size);
    Extend(this->Tags.Edges, 5 * size);
    Extend(this->Tags.Vertices, 2 * size);
    mesh.NumberOfVertices += 2 * size;
    for (const Id corner : rim)
    {
      this->Add(corner);
      this->Vertex += 2;
      this->Edge += 5;
      this->Corner += 9;
    }
  }

private:
  /// The new faces are triangles, whatever the others are.
  void StoreOffsets(vtkIdType faces)
  {
    PolygonMesh<Id>& mesh = this->Mesh;
    const vtkIdType old = mesh.NumberOfFaces;
    Buffer<Id> offsets(old + faces + 1);
    Buffer<Id> cornerFaces(this->Corner + 3 * faces);
    for (vtkIdType f = 0; f <= old + faces; ++f)
    {
      offsets[f] =
        f < old ? mesh.GetFirst(static_cast<Id>(f)) : this->Corner + static_cast<Id>(3 * (f - old));
    }
    for (vtkIdType f = 0; f < old + faces; ++f)
    {
      std::fill(
        cornerFaces.begin() + offsets[f], cornerFaces.begin() + offsets[f + 1], static_cast<Id>(f));
    }
    mesh.FaceOffsets = std::move(offsets);
    mesh.CornerFaces = std::move(cornerFaces);
    mesh.NumberOfFaces += faces;
    mesh.Arity = 0;
  }

  /// The triangles bam, adm and dbm over the edge ab of a corner.
  void Add(Id corner)
  {
    PolygonMesh<Id>& mesh = this->Mesh;
    const Id a = mesh.Vertices[corner];
    const Id b = mesh.Vertices[mesh.Next(corner)];
    const Id m = this->Vertex;
    const Id d = this->Vertex + 1;
    const Id edge = this->Edge;
    const Id first = this->Corner;
    const Id vertices[9] = { b, a, m, a, d, m, d, b, m };
    const Id edges[9] = { mesh.Edges[corner], edge, static_cast<Id>(edge + 1),
      static_cast<Id>(edge + 2), static_cast<Id>(edge + 3), edge, static_cast<Id>(edge + 4),
      static_cast<Id>(edge + 1), static_cast<Id>(edge + 3) };
    const Id ends[10] = { a, m, m, b, a, d, d, m, d, b };
    constexpr int twins[9] = { 0, 5, 7, -1, 8, 1, -1, 2, 4 };
    constexpr int firstCorners[5] = { 1, 2, 3, 4, 6 };
    for (int i = 0; i < 9; ++i)
    {
      mesh.Vertices[first + i] = vertices[i];
      mesh.Edges[first + i] = edges[i];
      mesh.Twins[first + i] = twins[i] < 0 ? -1 : first + twins[i];
    }
    mesh.Twins[first] = corner;
    mesh.Twins[corner] = first;
    std::copy(ends, ends + 10, mesh.EdgeVertices.begin() + 2 * edge);
    for (int i = 0; i < 5; ++i)
    {
      mesh.EdgeCorners[edge + i] = first + firstCorners[i];
      this->Tags.Edges[edge + i] = i == 2 || i == 4 ? EdgeTag::Sharp : EdgeTag::Smooth;
    }
    mesh.VertexCorners[m] = first + 2;
    mesh.VertexCorners[d] = first + 4;
    this->Tags.Vertices[m] = VertexTag::Corner;
    this->Tags.Vertices[d] = VertexTag::Corner;
  }

  PolygonMesh<Id>& Mesh;
  SurfaceTags<Id>& Tags;
  Id Vertex = 0; ///< the next one that is new
  Id Edge = 0;
  Id Corner = 0;
};

template <typename Id>
class FourEightScheme : public FourEightRefinement<Id>
{
public:
  explicit FourEightScheme(bool modifiedBoundary)
    : ModifiedBoundary(modifiedBoundary)
  {
  }

  bool NeedsTriangles() const override { return false; }
  double GetThirdEigenvalue(int k, double angle) const override
  {
    return this->ModifiedBoundary && k > 1 ? GetFourEightThirdEigenvalue(k, angle) : 0.;
  }
  bool HasCornersOfOneFace() const override { return true; }
  DenseRows GetDenseRows() const override { return DenseRows::OfLimits; }
  FaceMemory GetFaceMemory() const override { return { 32., 0.5, 16., 66., 122., 155. }; }
  double CountFaces(double faces, double corners, int steps) const override
  {
    return steps > 0 ? corners * std::pow(2., steps - 1) : faces;
  }
  /// Edges where the patch ends and the whole level goes on get a face beyond, of new vertices:
  /// even steps need that a fixed edge belongs to a triangle which has no other one. Over an edge
  /// ab stands a triangle abd with a vertex m in its middle, that is, three triangles, of which two
  /// have a fixed edge. Edges of the whole level have its tags. Only the surroundings of vertices
  /// inside have anything to do with the whole level.
  void CloseRim(const SurfaceLevel<Id>& whole, SurfacePatch<Id>& patch) const override
  {
    for (std::size_t e = 0; e < patch.Edges.size(); ++e)
    {
      patch.Level.Tags.Edges[static_cast<vtkIdType>(e)] = whole.Tags.Edges[patch.Edges[e]];
    }
    const std::vector<Id> rim = FindRim(whole.Mesh, patch);
    if (!rim.empty())
    {
      RimMaker<Id>(patch.Level.Mesh, patch.Level.Tags).Run(rim);
    }
  }
  /// A child between two faces that lie in one control face each gets these two: First is the
  /// control face of its last corner, Second of its second corner, which are both new. In the next
  /// step each edge that is not fixed ends at one of these two corners, and its child lies in the
  /// control face of that corner.
  void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, bool areWhole,
    Buffer<Carrier<Id>>& children) const override
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
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override
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
          this->AppendCentres(level, topology, tags, first, last, rows);
        }
        for (vtkIdType row = first; row < last && kind == 2; ++row)
        {
          const Id edge = topology.FindCutEdge(static_cast<Id>(topology.GetEndOfCentres() + row));
          rows.Add(mesh.EdgeVertices[2 * edge], 0.5);
          rows.Add(mesh.EdgeVertices[2 * edge + 1], 0.5);
          rows.EndRow();
        }
      });
  }

  vtkIdType GetOrientingFace(const SurfaceLevel<Id>& level, vtkIdType child) const override
  {
    return level.Mesh.GetFace(FourEightTopology<Id>(level).FindCornerOf(static_cast<Id>(child)));
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& /*tags*/,
    LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    AppendFourEightLimits(*this, level, this->ModifiedBoundary, kind, begin, end, rows);
  }

private:
  static void AppendVertices(const FourEightTopology<Id>& topology, const SurfaceTags<Id>& tags,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);
  void AppendCentres(const SurfaceLevel<Id>& level, const FourEightTopology<Id>& topology,
    const SurfaceTags<Id>& tags, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const;

  const bool ModifiedBoundary;
};

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

/// The means of faces that are not cut; quads beside curves may have other weights.
template <typename Id>
void FourEightScheme<Id>::AppendCentres(const SurfaceLevel<Id>& level,
  const FourEightTopology<Id>& topology, const SurfaceTags<Id>& tags, vtkIdType begin,
  vtkIdType end, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = topology.Mesh;
  const bool hasOthers =
    this->ModifiedBoundary && topology.HasFixed() && (topology.IsEven || !tags.Sectors.empty());
  const auto find = [&](Id face)
  { return CentreAtCurves<Id, 4>(level, tags, face, 2, GetFourEightFarWeight, 1. / 2.); };
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
        if (mesh.GetSize(face) != 4 || (hasOthers && !find(face).IsPlain()))
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
      const Id size = mesh.GetSize(face);
      if (size == 4)
      {
        find(face).Append(rows);
      }
      ++face;
      for (Id c = first; c < first + size && size != 4; ++c)
      {
        rows.Add(mesh.Vertices[c], 1. / size);
      }
      rows.EndRow();
    }
  }
}

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeFourEightScheme(bool modifiedBoundary)
{
  return std::make_unique<FourEightScheme<Id>>(modifiedBoundary);
}

SUBDIVISION_COMPILE_FUNCTION(MakeFourEightScheme);

}
