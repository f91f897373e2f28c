// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/SqrtThreeNext.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeMasks.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeTopology.h"

#include <algorithm>
#include <array>

namespace subdivision
{
namespace
{

/// The next level, from this one: a vertex in each face, and across each corner's edge the face
/// with the number of the corner.
template <typename Id>
class NextLevel
{
public:
  explicit NextLevel(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Vertices(static_cast<Id>(level.Mesh.NumberOfVertices))
  {
  }

  /// The vertex in a corner's face.
  Id GetApex(Id corner) const { return this->Vertices + corner / 3; }
  /// The vertex in the face beyond a corner's edge.
  Id GetBeyond(Id corner) const { return this->GetApex(this->Mesh.Twins[corner]); }
  /// The vertices of the face across a corner's edge.
  std::array<Id, 3> GetFace(Id corner) const
  {
    return { this->Mesh.Vertices[corner], this->GetBeyond(corner), this->GetApex(corner) };
  }
  vtkIdType GetNumberOfVertices() const
  {
    return this->Mesh.NumberOfVertices + this->Mesh.NumberOfFaces;
  }

  const PolygonMesh<Id>& Mesh;
  const Id Vertices;
};

/// Appends the rows of vertices which no step made. The ring around a vertex has the vertices in
/// its faces, and begins with that beyond the edge of its corner.
template <typename Id>
void AppendGiven(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  using Steps = typename CycleWalks<Id>::Steps;
  AppendCycleRows(
    next.Mesh, SqrtThreeVertex, begin, end, [](Id) { return true; },
    [&](Id vertex, const Steps& steps, Id* columns)
    {
      if (steps.size() != 6)
      {
        return false;
      }
      columns[0] = vertex;
      for (int k = 0; k < 6; ++k)
      {
        columns[1 + k] = next.GetApex(steps[(k + 5) % 6].Corner);
      }
      return true;
    },
    [&](Id vertex, const Steps& steps)
    {
      const int n = static_cast<int>(steps.size());
      const double ring = GetSqrtThreeRingWeight(n) / n;
      rows.Add(vertex, 1. - ring * n);
      for (int k = 0; k < n; ++k)
      {
        rows.Add(next.GetApex(steps[(k + n - 1) % n].Corner), ring);
      }
    },
    rows);
}

/// Appends those of vertices that steps made, without walks.
template <typename Id>
void AppendMade(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  rows.AddRun(SqrtThreeVertex, end - begin,
    [&](vtkIdType i, Id* columns)
    {
      const Id vertex = static_cast<Id>(begin + i);
      const Id first = next.Mesh.VertexCorners[vertex];
      const Id stride = GetStrideOfMade(first);
      columns[0] = vertex;
      for (Id k = 0; k < 3; ++k)
      {
        const Id corner = first + k * stride;
        columns[2 + 2 * k] = next.GetApex(corner);
        columns[k < 2 ? 3 + 2 * k : 1] = next.GetBeyond(next.Mesh.Previous(corner));
      }
      return true;
    });
}

/// Appends the rows of the vertices in faces.
template <typename Id>
void AppendApices(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  rows.AddRun(SqrtThreeVertex, end - begin,
    [&](vtkIdType i, Id* columns)
    {
      const Id first = static_cast<Id>(3 * (begin + i));
      columns[0] = next.GetApex(first);
      for (Id k = 0; k < 3; ++k)
      {
        columns[1 + 2 * k] = next.Mesh.Vertices[first + k];
        columns[2 + 2 * k] = next.GetBeyond(first + k);
      }
      return true;
    });
}

/// Appends the rows of the centres of the next level's faces, three in each face of this one.
template <typename Id>
void AppendCentres(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  AppendRegularGroups<3>(
    SqrtThreeCentre, begin, end,
    [&](vtkIdType face, Id* columns)
    {
      const Id first = static_cast<Id>(3 * face);
      for (Id i = 0; i < 3; ++i)
      {
        *columns++ = next.Mesh.Vertices[first + i];
        *columns++ = next.GetBeyond(first + i);
        *columns++ = next.Vertices + static_cast<Id>(face);
      }
      return true;
    },
    [](vtkIdType) {}, rows);
}

template <typename Id>
void AppendRows(const SurfaceLevel<Id>& level, const IrregularRows<Id>&, vtkIdType begin,
  vtkIdType end, RowBlock<Id>& rows)
{
  const NextLevel<Id> next(level);
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType given = level.FirstMade < 0 ? mesh.NumberOfVertices : level.FirstMade;
  ForKindsOfRows<4>(
    { given, mesh.NumberOfVertices - given, mesh.NumberOfFaces, 3 * mesh.NumberOfFaces }, begin,
    end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      switch (kind)
      {
        case 0:
          AppendGiven(next, first, last, rows);
          break;
        case 1:
          AppendMade(next, given + first, given + last, rows);
          break;
        case 2:
          AppendApices(next, first, last, rows);
          break;
        default:
          AppendCentres(next, first, last, rows);
          break;
      }
    });
}

template <typename Id>
void GetParents(const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents)
{
  const NextLevel<Id> next(level);
  const vtkIdType corner = row - next.GetNumberOfVertices();
  if (corner < 0)
  {
    parents.assign({ row });
    return;
  }
  const std::array<Id, 3> face = next.GetFace(static_cast<Id>(corner));
  parents.assign(face.begin(), face.end());
}

/// The children of the face across a corner's edge lie across its three edges, towards the faces
/// across three edges of this level.
template <typename Id, typename Out>
void WriteFaces(const SurfaceLevel<Id>& level, Out* ids)
{
  const NextLevel<Id> next(level);
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Id centres = static_cast<Id>(next.GetNumberOfVertices());
  ForEach(mesh.NumberOfFaces,
    [&](vtkIdType f)
    {
      const Id first = static_cast<Id>(3 * f);
      const Id apex = next.Vertices + static_cast<Id>(f);
      const Id* const twins = mesh.Twins.data() + first;
      Out* to = ids + 27 * f;
      for (Id i = 0; i < 3; ++i, to += 9)
      {
        const Id twin = twins[i];
        const Id face = twin / 3;
        const Id after = twin == 3 * face + 2 ? twin - 2 : twin + 1;
        const Id own = centres + first + i;
        WriteFace(to, mesh.Vertices[first + i], centres + after, own);
        WriteFace(to + 3, next.Vertices + face, centres + twin, own);
        WriteFace(to + 6, apex, centres + twins[(i + 2) % 3], own);
      }
    });
}

template <typename Id>
SurfaceLevel<Id> Count(const SurfaceLevel<Id>& skipped)
{
  SurfaceLevel<Id> next;
  next.Step = skipped.Step + 1;
  next.FirstMade = skipped.FirstMade;
  next.Mesh.Arity = 3;
  next.Mesh.NumberOfVertices = skipped.Mesh.NumberOfVertices + skipped.Mesh.NumberOfFaces;
  next.Mesh.NumberOfFaces = 3 * skipped.Mesh.NumberOfFaces;
  return next;
}

}

template <typename Id>
StepOfNext<Id> MakeSqrtThreeStepOfNext()
{
  return { [](const SurfaceLevel<Id>& level) { return !level.HasCurves; }, AppendRows<Id>,
    GetParents<Id>, [](const SurfaceLevel<Id>& level, IdsOut ids)
    { std::visit([&level](auto* to) { WriteFaces(level, to); }, ids); }, Count<Id> };
}

SUBDIVISION_COMPILE_FUNCTION(MakeSqrtThreeStepOfNext);

}
