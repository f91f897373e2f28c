// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Dual/DooSabinScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Dual/DooSabinWeights.h"
#include "Core/Surfaces/Dual/DualLimits.h"
#include "Core/Surfaces/Dual/DualRefiner.h"
#include "Core/Surfaces/Scheme/CycleRows.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// A boundary edge counts as a quad without width. This is the weight of the nearer end in each of
/// its two points.
constexpr double NearEnd = 3. / 4.;

template <typename Id>
class DooSabinRefiner;

/// Appends the rows of the corners of whole quads, from the first corner of a face on, as far as
/// there are some. Returns how many rows there are.
template <typename Id>
vtkIdType AppendWholeQuads(
  const PolygonMesh<Id>& mesh, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const Id face = begin < end ? mesh.GetFace(static_cast<Id>(begin)) : 0;
  if (begin >= end || mesh.GetFirst(face) != begin)
  {
    return 0;
  }
  return rows.AddQuads(DooSabinQuad, (end - begin) / 4,
    [&](vtkIdType i, Id* corners)
    {
      std::copy_n(mesh.Vertices.data() + begin + 4 * i, 4, corners);
      return mesh.GetSize(static_cast<Id>(face + i)) == 4;
    });
}

/// Writes the vertices of a corner's face from the corner on, if it is a quad.
template <typename Id>
bool FindQuad(const PolygonMesh<Id>& mesh, Id corner, Id columns[4])
{
  const Id face = mesh.GetFace(corner);
  if (mesh.GetSize(face) != 4)
  {
    return false;
  }
  const Id first = mesh.GetFirst(face);
  for (Id k = 0; k < 4; ++k)
  {
    columns[k] = mesh.Vertices[first + (corner - first + k) % 4];
  }
  return true;
}

template <typename Id>
class DooSabinRefiner : public DualRefiner<Id>
{
  using typename DualRefiner<Id>::Fan;

public:
  explicit DooSabinRefiner(const SurfaceLevel<Id>& level)
    : DualRefiner<Id>(level)
    , Corners(level.Mesh.GetNumberOfCorners())
  {
  }

  template <typename Out>
  void WriteFaces(Out* ids)
  {
    ForEach(this->Corners, [&](vtkIdType c) { this->SetCorner(static_cast<Id>(c), ids); });
    this->SetVertexFaces([&](const Fan& fan, Id at) { return this->SetFan(fan, at, ids); });
  }

private:
  Id GetSideStart(Id first) const
  {
    return static_cast<Id>(this->Corners) + 4 * this->Places.Sides[first];
  }
  /// The point on an open side that is nearer to a vertex.
  Id GetOpenPoint(Id corner, Id vertex) const
  {
    return static_cast<Id>(this->Corners) + 2 * this->Places.OpenSides[corner] +
      (this->Mesh.Vertices[corner] == vertex ? 0 : 1);
  }
  /// The half-edge of the face along a side that lies at one end of the side.
  Id GetAcross(Id corner, Id vertex) const
  {
    const Id first = GetFirstOfSide(this->Mesh, corner);
    return this->GetSideStart(first) + (this->Mesh.Vertices[first] == vertex ? 1 : 3);
  }

  /// Sets the vertex at a corner, and the face along its side if it is the first corner there.
  template <typename Out>
  void SetCorner(Id corner, Out* ids)
  {
    const auto set = [ids](Id at, Id vertex) { ids[at] = static_cast<Out>(vertex); };
    set(corner, corner);
    this->SetVertexCorner(corner, corner);
    if (GetFirstOfSide(this->Mesh, corner) != corner)
    {
      return;
    }
    const Id twin = this->Mesh.Twins[corner];
    const Id start = this->GetSideStart(corner);
    set(start, this->Mesh.Next(corner));
    set(start + 1, corner);
    this->Join(start, corner);
    if (twin < 0)
    {
      for (Id end = 0; end < 2; ++end)
      {
        const Id point = this->GetOpenPoint(corner, this->Mesh.Vertices[corner]) + end;
        set(start + 2 + end, point);
        this->SetVertexCorner(point, start + 2 + end);
      }
      this->Open(start + 2);
      return;
    }
    const bool sameWay = this->Mesh.Vertices[twin] == this->Mesh.Vertices[corner];
    const Id next = this->Mesh.Next(twin);
    set(start + 2, sameWay ? twin : next);
    set(start + 3, sameWay ? next : twin);
    this->Join(start + 2, twin);
  }

  template <typename Out>
  vtkIdType SetFan(const Fan& fan, Id at, Out* ids)
  {
    const Id vertex = fan.Vertex;
    const vtkIdType size = this->Places.GetFaceSize(fan.Steps.size(), fan.IsCycle);
    if (size < 3)
    {
      this->Join(this->GetAcross(fan.Steps.front().GetHalfEdgeOut(this->Mesh), vertex),
        this->GetAcross(fan.Steps.back().GetHalfEdgeOut(this->Mesh), vertex));
      return 0;
    }
    for (const FanStep<Id>& step : fan.Steps)
    {
      ids[at] = static_cast<Out>(step.Corner);
      this->Join(at++, this->GetAcross(step.GetHalfEdgeOut(this->Mesh), vertex));
    }
    if (!fan.IsCycle)
    {
      ids[at] =
        static_cast<Out>(this->GetOpenPoint(fan.Steps.back().GetHalfEdgeOut(this->Mesh), vertex));
      this->Open(at++);
      const Id first = fan.Steps.front().GetHalfEdgeIn(this->Mesh);
      ids[at] = static_cast<Out>(this->GetOpenPoint(first, vertex));
      this->Join(at, this->GetAcross(first, vertex));
    }
    return size;
  }

  const vtkIdType Corners;
};

/// Limit rows of the vertices of a level, from the rows that the next step has around them.
template <typename Id>
class DooSabinLimits
{
public:
  DooSabinLimits(const SurfaceLevel<Id>& level, RowBlock<Id>& rows)
    : Level(level)
    , Mesh(level.Mesh)
    , Rows(rows)
  {
  }
  void Append(Id vertex, LimitKind kind)
  {
    if (!this->Fan.Find(this->Mesh, vertex))
    {
      AppendLoneLimit(this->Level, vertex, kind, this->Rows);
      return;
    }
    const std::size_t k = this->Fan.Steps.size();
    if (!this->Fan.IsCycle && kind == LimitKind::Tangent2)
    {
      this->AppendAcrossBoundary(vertex);
    }
    else if (!this->Fan.IsCycle)
    {
      AppendDualBoundary(this->Fan, vertex, kind, 3. / 4., this->Rows);
    }
    else if (k == 2 && kind == LimitKind::Position)
    {
      this->AppendBetweenTwoFaces();
    }
    for (std::size_t j = 0; j < k && this->Fan.IsCycle && k > 2; ++j)
    {
      this->AddCorner(this->Fan.Steps[j].Corner, GetDualWeight(kind, j, k));
    }
  }

private:
  /// Adds the row of the vertex that the step makes at a corner, times a factor.
  void AddCorner(Id corner, double factor)
  {
    const vtkIdType size = this->Mesh.GetSize(this->Mesh.GetFace(corner));
    if (static_cast<vtkIdType>(this->Weights.size()) != size)
    {
      FindCornerWeights(size, this->Weights);
    }
    for (const double weight : this->Weights)
    {
      this->Rows.Add(this->Mesh.Vertices[corner], factor * weight);
      corner = this->Mesh.Next(corner);
    }
  }
  /// Between two faces the step makes no face, but an edge. The limit in its middle is the mean of
  /// the face that the step after it makes there, of four vertices.
  void AppendBetweenTwoFaces()
  {
    for (const FanStep<Id>& step : this->Fan.Steps)
    {
      this->AddCorner(step.Corner, 3. / 8.);
      this->AddCorner(this->Mesh.Next(step.Corner), 1. / 16.);
      this->AddCorner(this->Mesh.Previous(step.Corner), 1. / 16.);
    }
  }
  /// The second step makes along the open side of the vertex face a face, of which all later steps
  /// quarter the difference between its inner and its outer vertices.
  void AppendAcrossBoundary(Id vertex)
  {
    const std::size_t k = this->Fan.Steps.size();
    const std::size_t n = k + 2;
    std::vector<double> weights;
    FindCornerWeights(static_cast<vtkIdType>(n), weights);
    const auto ofCorner = [&](std::size_t j) // of the mean of the inner vertices
    { return (weights[(j + n - k) % n] + weights[(j + n - k - 1) % n]) / 2.; };
    for (std::size_t j = 0; j < k; ++j)
    {
      this->AddCorner(this->Fan.Steps[j].Corner, ofCorner(j));
    }
    for (std::size_t end = 0; end < 2; ++end)
    {
      const double weight = ofCorner(k + end) - 1. / 2.;
      this->Rows.Add(vertex, weight * NearEnd);
      this->Rows.Add(
        end == 0 ? this->Fan.Ends.back() : this->Fan.Ends.front(), weight * (1. - NearEnd));
    }
  }

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  RowBlock<Id>& Rows;
  DualFan<Id> Fan;
  std::vector<double> Weights; ///< of the corners of a face
};

template <typename Id>
class DooSabinScheme : public DualScheme<Id, DooSabinRefiner<Id>>
{
public:
  DenseRows GetDenseRows() const override { return DenseRows::OfFaces; }
  FaceMemory GetFaceMemory() const override { return { 40., 1., 12., 42., 145., 220. }; }
  double CountFaces(double faces, double corners, int steps) const override
  {
    return steps > 0 ? corners * std::pow(4., steps - 1) : faces;
  }

  /// The face of a chain has also the points of its two open sides.
  void Prepare(SurfaceLevel<Id>& level) const override
  {
    const auto places = CountDualPlaces(level, 2);
    places->FirstLone = level.Mesh.GetNumberOfCorners() + 2 * places->GetNumberOfOpenSides();
    places->HasQuads = true;
    level.Dual = places;
  }
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>&, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const vtkIdType corners = mesh.GetNumberOfCorners();
    const vtkIdType lone = level.Dual->FirstLone;
    std::vector<double> weights;
    for (vtkIdType row = begin; row < end; ++row)
    {
      row += AppendWholeQuads(mesh, row, std::min(end, corners), rows);
      row += rows.AddRun(DooSabinQuad, std::max<vtkIdType>(std::min(end, corners) - row, 0),
        [&](vtkIdType i, Id* columns)
        { return FindQuad(mesh, static_cast<Id>(row + i), columns); });
      if (row == end)
      {
        break;
      }
      if (row >= lone)
      {
        AppendLoneRow(level, row - lone, rows);
      }
      else if (row >= corners)
      {
        bool isFirst = false;
        const Id corner = FindOpenSide(level, row, isFirst);
        rows.Add(mesh.Vertices[corner], isFirst ? NearEnd : 1. - NearEnd);
        rows.Add(mesh.Vertices[mesh.Next(corner)], isFirst ? 1. - NearEnd : NearEnd);
      }
      else
      {
        const Id corner = static_cast<Id>(row);
        const vtkIdType size = mesh.GetSize(mesh.GetFace(corner));
        if (static_cast<vtkIdType>(weights.size()) != size)
        {
          FindCornerWeights(size, weights);
        }
        Id at = corner;
        for (const double weight : weights)
        {
          rows.Add(mesh.Vertices[at], weight);
          at = mesh.Next(at);
        }
      }
      rows.EndRow();
    }
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const vtkIdType lone = level.Dual->FirstLone;
    if (row >= lone)
    {
      GetLoneParents(level, row - lone, parents);
    }
    else if (row >= mesh.GetNumberOfCorners())
    {
      bool isFirst = false;
      const Id corner = FindOpenSide(level, row, isFirst);
      parents.assign({ mesh.Vertices[corner], mesh.Vertices[mesh.Next(corner)] });
    }
    else
    {
      const Id face = mesh.GetFace(static_cast<Id>(row));
      const Id* first = mesh.Vertices.data() + mesh.GetFirst(face);
      parents.assign(first, first + mesh.GetSize(face));
    }
  }

  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override
  {
    AppendChildren(segments.Corners, 1, children.Vertices);
    AppendCounted(segments.Corners, segments.Sizes, level.Dual->OpenSides, 2, children.Vertices);
    ListDualChildren(level, segments, children);
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>&, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    DooSabinLimits<Id> limits(level, rows);
    AppendCycleRows(
      mesh, DooSabinLimitsOfQuads[static_cast<std::size_t>(kind)], begin, end,
      [&mesh](Id v) { return mesh.VertexCorners[v] >= 0; },
      [&mesh](Id vertex, const std::vector<FanStep<Id>>& steps, Id* columns)
      {
        FanStep<Id> last = steps.size() == 4 ? steps.back() : FanStep<Id>{ Id(-1), true };
        bool isRegular =
          last.Corner >= 0 && last.Advance(mesh) && last.Corner == steps.front().Corner;
        columns[0] = vertex;
        for (std::size_t j = 0; isRegular && j < 4; ++j)
        {
          isRegular = mesh.GetSize(mesh.GetFace(steps[j].Corner)) == 4;
          columns[1 + j] = GetNeighbour(mesh, steps[j]);
          columns[5 + j] = mesh.Vertices[mesh.Next(mesh.Next(steps[j].Corner))];
        }
        return isRegular;
      },
      [&](Id vertex, const std::vector<FanStep<Id>>&) { limits.Append(vertex, kind); }, rows);
  }
  const double* GetSecondTangent(const double* first) const override
  {
    return first == DooSabinLimitsOfQuads[1].data() ? DooSabinLimitsOfQuads[2].data() : nullptr;
  }

private:
  /// The open side to which a row belongs; `isFirst` tells whether the point is near the beginning
  /// of its half-edge.
  static Id FindOpenSide(const SurfaceLevel<Id>& level, vtkIdType row, bool& isFirst)
  {
    const vtkIdType point = row - level.Mesh.GetNumberOfCorners();
    isFirst = point % 2 == 0;
    return FindByCount(level.Dual->OpenSides, point / 2);
  }
};

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeDooSabinScheme()
{
  return std::make_unique<DooSabinScheme<Id>>();
}

SUBDIVISION_COMPILE_FUNCTION(MakeDooSabinScheme);

}
