// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/SqrtThreeScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/CurveTangents.h"
#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeMasks.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeRefinement.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace subdivision
{
namespace
{

template <typename Id>
class SqrtThreeScheme : public SqrtThreeRefinement<Id>
{
public:
  explicit SqrtThreeScheme(bool modifiedBoundary)
    : ModifiedBoundary(modifiedBoundary)
  {
  }

  bool NeedsTriangles() const override { return true; }
  double GetThirdEigenvalue(int k, double angle) const override
  {
    return this->ModifiedBoundary ? GetSqrtThreeThirdEigenvalue(k, angle) : 0.;
  }
  FaceMemory GetFaceMemory() const override { return { 32., 0.5, 8., 38., 108., 132. }; }
  double CountFaces(double faces, double /*corners*/, int steps) const override
  {
    return faces * std::pow(3., steps);
  }
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
  const double* GetSecondTangent(const double* first) const override
  {
    return first == SqrtThreeLimits[1].data() ? SqrtThreeLimits[2].data() : nullptr;
  }

private:
  using Topology = SqrtThreeTopology<Id>;
  /// Whether the centres of the next step may have other rows than the plain one.
  bool HasOtherCentres(const SurfaceLevel<Id>& level) const
  {
    return this->ModifiedBoundary && (!level.Places.empty() || !level.Tags.Sectors.empty());
  }
  /// On a level after an odd step at most one corner of a face is no centre, and may lie on a
  /// curve.
  CentreAtCurves<Id, 3> FindCentre(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, Id face) const
  {
    return { level, tags, face, 3, GetSqrtThreeFarWeight, 1. / 3. };
  }
  void AppendCentre(const SurfaceLevel<Id>& level, Id face, RowBlock<Id>& rows) const;
  void AppendVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, std::vector<Id>& edges, RowBlock<Id>& rows) const;
  void AppendSmooth(const SurfaceLevel<Id>& level, Id vertex, const std::vector<FanStep<Id>>& steps,
    RowBlock<Id>& rows) const;
  bool NeedsNext(const SurfaceLevel<Id>& level, const std::vector<FanStep<Id>>& steps) const;
  void AppendThird(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, bool second,
    std::vector<Id>& edges, RowBlock<Id>& rows) const;
  void AppendSmoothPosition(const SurfaceLevel<Id>& level, Id vertex,
    const std::vector<FanStep<Id>>& steps, RowBlock<Id>& rows) const;
  void AppendSmoothTangent(const SurfaceLevel<Id>& level, const std::vector<FanStep<Id>>& steps,
    LimitKind kind, RowBlock<Id>& rows) const;
  void AppendAcross(const SurfaceLevel<Id>& level, Id vertex, const SectorEnds<Id>& ends,
    double turn, const std::vector<Id>& ring, RowBlock<Id>& rows) const;

  const bool ModifiedBoundary;
};

/// Writes the neighbours of a vertex in the order of VisitCycle, if every other one of its six
/// faces is `stride` corners after the one before, beginning with the face of `corner`. `at`: the
/// vertex's corner in each of them.
template <typename Id>
bool FindRingOfThree(
  const PolygonMesh<Id>& mesh, Id vertex, Id first, Id stride, int at, Id ring[6])
{
  for (Id* pair = ring; pair < ring + 6; pair += 2)
  {
    const Id* face = mesh.Vertices.data() + first;
    if (face[at] != vertex)
    {
      return false;
    }
    pair[0] = face[(at + 1) % 3];
    pair[1] = face[(at + 2) % 3];
    first += stride;
  }
  return ring[1] != ring[2] && ring[3] != ring[4] && ring[5] != ring[0];
}

/// Writes a vertex that a step made and its six neighbours, without a walk. Returns false for
/// vertices which the faces of GetStrideOfMade do not surround.
template <typename Id>
bool FindRingOfMade(const SurfaceLevel<Id>& level, Id vertex, Id columns[7])
{
  const Id corner = level.Mesh.VertexCorners[vertex];
  const bool isOfLastStep = corner % 9 == 2;
  if (corner <= 0 || (!isOfLastStep && !level.Places.empty()))
  {
    return false; // may have ghosts
  }
  columns[0] = vertex;
  const Id first = isOfLastStep ? corner - 2 : corner;
  const Id stride = GetStrideOfMade(corner);
  return stride > 0 &&
    FindRingOfThree(level.Mesh, vertex, first, stride, isOfLastStep ? 2 : 0, columns + 1);
}

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
int CountFixedOpposites(const SurfaceLevel<Id>& level, const std::vector<FanStep<Id>>& steps)
{
  return static_cast<int>(std::count_if(steps.begin(), steps.end(),
    [&](const FanStep<Id>& step) { return FindFixedOpposite(level, step) >= 0; }));
}

/// Appends the rows of vertices [begin, end). `mask`: of smooth vertices with six neighbours and no
/// ghosts; other(v, steps) appends the entries of any other vertex, with the walk around it if it
/// is smooth, and with `isInside` also where a neighbour is on a curve.
template <typename Id, typename Other>
void AppendSqrtThreeVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  const std::array<double, 7>& mask, bool isInside, vtkIdType begin, vtkIdType end,
  const Other& other, RowBlock<Id>& rows)
{
  const auto isTaken = [&tags, isInside](Id v)
  { return !isInside || tags.Vertices[v] == VertexTag::Smooth; };
  AppendVertexRows(
    level.Mesh, tags, mask, level.VerticesBefore, begin, end,
    [&](Id vertex, const std::vector<FanStep<Id>>& steps, Id* columns)
    {
      bool isRegular = steps.size() == 6;
      *columns++ = vertex;
      for (std::size_t k = 0; isRegular && k < 6; ++k)
      {
        *columns = GetNeighbour(level.Mesh, steps[k]);
        isRegular = FindFixedOpposite(level, steps[k]) < 0 && isTaken(*columns++);
      }
      return isRegular;
    },
    [&](Id vertex, Id* columns)
    {
      return FindRingOfMade(level, vertex, columns) &&
        std::all_of(columns + 1, columns + 7, isTaken);
    },
    other, rows);
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
  this->AppendVertices(level, tags, begin, std::min(end, vertices), edges, rows);
  vtkIdType row = std::max(begin, vertices);
  const vtkIdType endOfCentres = std::min(end, thirds);
  const bool hasOthers = this->HasOtherCentres(level);
  Id face = row < endOfCentres ? topology.FindFace(static_cast<Id>(row - vertices)) : 0;
  while (row < endOfCentres)
  {
    row += rows.AddRun(SqrtThreeCentre, endOfCentres - row,
      [&](vtkIdType, Id* columns)
      {
        while (topology.GetCentre(face) < 0)
        {
          ++face;
        }
        if (hasOthers && !this->FindCentre(level, tags, face).IsPlain())
        {
          return false;
        }
        std::copy_n(mesh.Vertices.data() + 3 * face++, 3, columns);
        return true;
      });
    if (row < endOfCentres)
    {
      this->FindCentre(level, tags, face++).Append(rows);
      rows.EndRow();
      ++row;
    }
  }
  for (; row < end; ++row)
  {
    const bool second = (row - thirds) % 2 == 1;
    this->AppendThird(mesh, tags, topology.FindCutEdge(static_cast<Id>(row)), second, edges, rows);
    rows.EndRow();
  }
}

template <typename Id>
void SqrtThreeScheme<Id>::AppendVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  vtkIdType begin, vtkIdType end, std::vector<Id>& edges, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const auto append = [&](Id vertex, const std::vector<FanStep<Id>>& steps)
  {
    if (!steps.empty())
    {
      this->AppendSmooth(level, vertex, steps, rows);
    }
    else if (level.Step % 2 == 1)
    {
      AppendCurveVertex(mesh, tags, vertex, 19. / 27., edges, rows);
    }
    else
    {
      rows.Add(vertex, 1.);
    }
  };
  AppendSqrtThreeVertices(level, tags, SqrtThreeVertex, false, begin, end, append, rows);
}

/// Appends the row of a smooth vertex p. In even steps it has a ghost neighbour a + b - p beyond
/// each fixed edge ab opposite to it, which keeps a flat grid exact (Mathematics 11). `steps`: of a
/// walk around it.
template <typename Id>
void SqrtThreeScheme<Id>::AppendSmooth(const SurfaceLevel<Id>& level, Id vertex,
  const std::vector<FanStep<Id>>& steps, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  int ghosts = 0;
  const std::size_t own = rows.GetNumberOfEntries();
  rows.Add(vertex, 0.); // weights follow when all entries are known
  for (const FanStep<Id>& step : steps)
  {
    rows.Add(GetNeighbour(mesh, step), 0.);
    const Id opposite = FindFixedOpposite(level, step);
    if (opposite >= 0)
    {
      ++ghosts;
      rows.Add(mesh.Vertices[opposite], 0.);
      rows.Add(mesh.Vertices[mesh.Next(opposite)], 0.);
    }
  }
  const int n = static_cast<int>(steps.size()) + ghosts;
  const double ring = GetSqrtThreeRingWeight(n) / n;
  rows.SetWeight(own, 1. - ring * (n + ghosts));
  for (std::size_t entry = own + 1; entry < rows.GetNumberOfEntries(); ++entry)
  {
    rows.SetWeight(entry, ring);
  }
}

/// Appends the row of the point at one third of a fixed edge: the row of a cubic B-spline cut into
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
  const bool isPosition = kind == LimitKind::Position;
  AppendSqrtThreeVertices(
    level, tags, SqrtThreeLimits[static_cast<std::size_t>(kind)], this->HasOtherCentres(level),
    begin, end,
    [&](Id vertex, const std::vector<FanStep<Id>>& steps)
    {
      if (!steps.empty())
      {
        isPosition ? this->AppendSmoothPosition(level, vertex, steps, rows)
                   : this->AppendSmoothTangent(level, steps, kind, rows);
      }
      else if (isPosition)
      {
        AppendCurveVertex(level.Mesh, tags, vertex, 2. / 3., edges, rows);
      }
      else
      {
        AppendSectorTangent(level, tags, vertex, kind, edges, rows,
          [&](const SectorEnds<Id>& ends, double turn)
          { this->AppendAcross(level, vertex, ends, turn, edges, rows); });
      }
    },
    rows);
}

/// Whether a limit row of a smooth vertex is made from the ring after the next step.
template <typename Id>
bool SqrtThreeScheme<Id>::NeedsNext(
  const SurfaceLevel<Id>& level, const std::vector<FanStep<Id>>& steps) const
{
  return std::any_of(steps.begin(), steps.end(),
    [&](const FanStep<Id>& step)
    {
      return FindFixedOpposite(level, step) >= 0 ||
        (this->HasOtherCentres(level) &&
          !this->FindCentre(level, level.Tags, step.Corner / 3).IsPlain());
    });
}

/// Appends the entries of the centre of a face, which is not cut, in a limit.
template <typename Id>
void SqrtThreeScheme<Id>::AppendCentre(
  const SurfaceLevel<Id>& level, Id face, RowBlock<Id>& rows) const
{
  if (this->HasOtherCentres(level))
  {
    this->FindCentre(level, level.Tags, face).Append(rows);
    return;
  }
  for (Id c = 3 * face; c < 3 * face + 3; ++c)
  {
    rows.Add(level.Mesh.Vertices[c], 1. / 3.);
  }
}

/// Appends the limit (1 - b) p + b mean(ring) (Kobbelt, eq. 7). Before an even step, a vertex p
/// opposite to a fixed edge has no such ring, but after the step it has: there the two points on
/// the fixed edge replace the centre of the face. So it is where the step makes centres around p by
/// the modified rule.
template <typename Id>
void SqrtThreeScheme<Id>::AppendSmoothPosition(const SurfaceLevel<Id>& level, Id vertex,
  const std::vector<FanStep<Id>>& steps, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const int n = static_cast<int>(steps.size());
  const int ghosts = CountFixedOpposites(level, steps);
  const double a = GetSqrtThreeRingWeight(n + ghosts);
  const double b = 3. * a / (1. + 3. * a);
  if (!this->NeedsNext(level, steps))
  {
    rows.Add(vertex, 1. - b);
    for (const FanStep<Id>& step : steps)
    {
      rows.Add(GetNeighbour(mesh, step), b / n);
    }
    return;
  }
  RowBlock<Id> next;
  std::vector<Id> edges;
  auto addNext = [&](double weight)
  {
    AddTimes(next, weight, rows);
    next.Clear();
  };
  this->AppendSmooth(level, vertex, steps, next);
  addNext(1. - b);
  const double ring = b / (n + ghosts);
  for (const FanStep<Id>& step : steps)
  {
    const Id opposite = FindFixedOpposite(level, step);
    if (opposite < 0)
    {
      this->AppendCentre(level, step.Corner / 3, next);
      addNext(ring);
      continue;
    }
    for (const bool second : { false, true })
    {
      this->AppendThird(mesh, level.Tags, mesh.Edges[opposite], second, edges, next);
      addNext(ring);
    }
  }
}

/// Appends a tangent: the sum over the ring with the weights cos or sin of the angle. A step turns
/// the ring by half a triangle, which does not change the plane of both tangents. For a vertex
/// for which NeedsNext holds the ring after the next step is taken, as for the position.
template <typename Id>
void SqrtThreeScheme<Id>::AppendSmoothTangent(const SurfaceLevel<Id>& level,
  const std::vector<FanStep<Id>>& steps, LimitKind kind, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const int n = static_cast<int>(steps.size());
  const int ghosts = CountFixedOpposites(level, steps);
  const bool isNext = this->NeedsNext(level, steps);
  int j = 0;
  auto getNext = [&]
  {
    const double angle = 2. * Pi * j++ / (n + ghosts);
    return kind == LimitKind::Tangent1 ? std::cos(angle) : std::sin(angle);
  };
  std::vector<Id> edges;
  RowBlock<Id> made;
  for (const FanStep<Id>& step : steps)
  {
    const Id first = GetNeighbour(mesh, step);
    const Id opposite = FindFixedOpposite(level, step);
    if (!isNext)
    {
      rows.Add(first, getNext());
    }
    else if (opposite < 0)
    {
      made.Clear();
      this->AppendCentre(level, step.Corner / 3, made);
      AddTimes(made, getNext(), rows);
    }
    for (int end = 0; end < 2 && opposite >= 0; ++end)
    {
      const Id edge = mesh.Edges[opposite];
      const bool isFirst = mesh.EdgeVertices[2 * edge] == first;
      made.Clear();
      this->AppendThird(mesh, level.Tags, edge, isFirst == (end == 1), edges, made);
      AddTimes(made, getNext(), rows);
    }
  }
}

/// Appends the tangent across a curve in a sector, times `turn`. `ring`: the other ends of its
/// edges. Before an odd step that makes a centre of the sector by the rule of a corner, the ring
/// after the step is taken, as for smooth vertices.
template <typename Id>
void SqrtThreeScheme<Id>::AppendAcross(const SurfaceLevel<Id>& level, Id vertex,
  const SectorEnds<Id>& ends, double turn, const std::vector<Id>& ring, RowBlock<Id>& rows) const
{
  std::vector<FanStep<Id>> steps;
  for (FanStep<Id> step = ends.First; static_cast<int>(steps.size()) < ends.Size;)
  {
    steps.push_back(step);
    step.Advance(level.Mesh);
  }
  const int size = static_cast<int>(ring.size()) - 1;
  const int faces = level.Step % 2 == 0 ? size : size - 1;
  SqrtThreeTransversalMask mask(
    faces, GetSqrtThreeFarWeight(this->ModifiedBoundary && faces != 3 ? Pi / faces : 0.));
  const bool isNext = level.Step % 2 == 0 && faces > 1 && this->NeedsNext(level, steps);
  if (isNext)
  {
    turn /= mask.Eigenvalue;
  }
  if (isNext || level.Step % 2 == 1)
  {
    mask.MakeOdd();
  }
  rows.Add(vertex, turn * mask.Own);
  rows.Add(ring.front(), turn * mask.End);
  rows.Add(ring.back(), turn * mask.End);
  if (isNext)
  {
    RowBlock<Id> made;
    for (std::size_t j = 0; j < steps.size(); ++j)
    {
      made.Clear();
      this->AppendCentre(level, steps[j].Corner / 3, made);
      AddTimes(made, turn * mask.Inside[j + 1], rows);
    }
    return;
  }
  for (std::size_t j = 1; j + 1 < ring.size(); ++j)
  {
    rows.Add(ring[j], turn * mask.Inside[j]);
  }
}

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeSqrtThreeScheme(bool modifiedBoundary)
{
  return std::make_unique<SqrtThreeScheme<Id>>(modifiedBoundary);
}

SUBDIVISION_COMPILE_FUNCTION(MakeSqrtThreeScheme);

}
