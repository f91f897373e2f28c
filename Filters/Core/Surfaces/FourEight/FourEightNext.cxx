// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightNext.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/FourEight/FourEightRegular.h"
#include "Core/Surfaces/FourEight/FourEightTopology.h"
#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"

#include <algorithm>
#include <array>
#include <vector>

namespace subdivision
{
namespace
{

/// The next level, from this one.
template <typename Id>
class NextLevel
{
public:
  explicit NextLevel(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Children(level)
  {
  }

  vtkIdType GetNumberOfVertices() const
  {
    return this->Mesh.NumberOfVertices + this->Mesh.NumberOfFaces;
  }
  vtkIdType GetNumberOfFaces() const { return this->Mesh.GetNumberOfEdges(); }

  /// The vertex in a corner's face.
  Id GetApex(Id corner) const
  {
    return static_cast<Id>(this->Mesh.NumberOfVertices) + this->Mesh.GetFace(corner);
  }
  /// FourEightTopology::GetSpokeOut.
  Id GetSpokeOut(Id corner) const { return this->Children.GetSpokeOut(corner); }
  /// The quad across a corner's edge.
  Id GetQuad(Id corner) const
  {
    return this->Children.GetChild(std::min(corner, this->Mesh.Twins[corner]));
  }
  /// The corner to which a quad belongs: of its edge the first.
  Id FindOwner(vtkIdType quad) const { return this->Children.FindCornerOf(static_cast<Id>(quad)); }
  /// The next corner from this one on to which a quad belongs.
  Id FindNextOwner(Id corner) const
  {
    while (!this->Children.HasChild(corner))
    {
      ++corner;
    }
    return corner;
  }

  /// The vertices of the quad of an owner.
  std::array<Id, 4> GetVertices(Id owner) const
  {
    const Id twin = this->Mesh.Twins[owner];
    return { this->Mesh.Vertices[owner], this->GetApex(twin), this->Mesh.Vertices[twin],
      this->GetApex(owner) };
  }
  /// The quads across the four sides of the quad of an owner.
  std::array<Id, 4> GetNeighbours(Id owner) const
  {
    const Id twin = this->Mesh.Twins[owner];
    return { this->GetQuad(this->Mesh.Next(twin)), this->GetQuad(this->Mesh.Previous(twin)),
      this->GetQuad(this->Mesh.Next(owner)), this->GetQuad(this->Mesh.Previous(owner)) };
  }

  const PolygonMesh<Id>& Mesh;

private:
  const FourEightTopology<Id> Children;
};

/// Appends the rows of vertices in faces [begin, end) of a level, on whichever later one.
/// visitAround(first, size, visit) calls visit(vertex) for the vertices around that in the face
/// with this first corner and this number of corners.
template <typename Id, typename VisitAround>
void AppendInFaces(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end,
  const VisitAround& visitAround, RowBlock<Id>& rows)
{
  const PolygonMesh<Id>& mesh = next.Mesh;
  const auto getVertex = [&mesh](vtkIdType face)
  { return static_cast<Id>(mesh.NumberOfVertices + face); };
  for (vtkIdType f = begin; f < end; ++f)
  {
    f += rows.AddRun(FourEightVertex, end - f,
      [&](vtkIdType i, Id* columns)
      {
        const Id face = static_cast<Id>(f + i);
        if (mesh.GetSize(face) != 4)
        {
          return false;
        }
        *columns++ = getVertex(face);
        visitAround(mesh.GetFirst(face), 4, [&columns](Id vertex) { *columns++ = vertex; });
        return true;
      });
    if (f < end)
    {
      const Id face = static_cast<Id>(f);
      const Id size = mesh.GetSize(face);
      rows.Add(getVertex(face), 0.5);
      visitAround(mesh.GetFirst(face), size,
        [&](Id vertex) { rows.Add(vertex, 0.5 / static_cast<double>(size)); });
      rows.EndRow();
    }
  }
}

/// The vertices around that in a face are those of the face.
template <typename Id>
void AppendApices(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const auto visitAround = [&next](Id first, Id size, const auto& visit)
  { std::for_each_n(next.Mesh.Vertices.data() + first, size, visit); };
  AppendInFaces(next, begin, end, visitAround, rows);
}

/// Those of this level's vertices that steps made, each in a face of a level before. Half-edges at
/// such a vertex follow from the corners of that face, which takes less time than a walk.
template <typename Id>
class MadeVertices
{
public:
  explicit MadeVertices(const SurfaceLevel<Id>& level)
    : NumberOfVertices(static_cast<Id>(level.Mesh.NumberOfVertices))
  {
    for (const SurfaceLevel<Id>* before = level.Before; before; before = before->Before)
    {
      this->Levels.emplace_back(*before);
    }
  }

  /// The first of them, after which all were made.
  vtkIdType GetFirst() const
  {
    return this->Levels.empty() ? this->NumberOfVertices
                                : this->Levels.back().Mesh.NumberOfVertices;
  }

  /// Appends the rows of vertices [begin, end), which count from the first one: on the next level
  /// those around a vertex are in the faces of this one.
  void Append(vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
  {
    for (std::size_t i = this->Levels.size(); i-- > 0;)
    {
      const auto visitAround = [this, i](Id first, Id size, const auto& visit)
      {
        visit(this->GetApexAt(i, first + size - 1));
        for (Id corner = first; corner < first + size - 1; ++corner)
        {
          visit(this->GetApexAt(i, corner));
        }
      };
      const vtkIdType faces = this->Levels[i].Mesh.NumberOfFaces;
      AppendInFaces(
        this->Levels[i], std::max<vtkIdType>(begin, 0), std::min(end, faces), visitAround, rows);
      begin -= faces;
      end -= faces;
    }
  }

private:
  /// The vertex in that of this level's faces which has come to lie at a corner of a face of
  /// Levels[i], around the vertex in it.
  Id GetApexAt(std::size_t i, Id corner) const
  {
    if (i > 0)
    {
      corner = this->Levels[i].GetSpokeOut(corner);
      while (--i > 0)
      {
        corner = this->Levels[i - 1].Mesh.Next(this->Levels[i].GetSpokeOut(corner));
      }
    }
    return this->NumberOfVertices + this->Levels[0].GetQuad(corner);
  }

  const Id NumberOfVertices;
  std::vector<NextLevel<Id>> Levels; ///< the last one first
};

/// The vertices around one of this level are those in its faces, and the walk around it begins
/// beyond the edge of its corner.
template <typename Id>
void AppendVertices(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  using Steps = typename CycleWalks<Id>::Steps;
  AppendCycleRows(
    next.Mesh, FourEightVertex, begin, end, [](Id) { return true; },
    [&](Id vertex, const Steps& steps, Id* columns)
    {
      if (steps.size() != 4)
      {
        return false;
      }
      columns[0] = vertex;
      columns[1] = next.GetApex(steps[3].Corner);
      for (int k = 0; k < 3; ++k)
      {
        columns[2 + k] = next.GetApex(steps[k].Corner);
      }
      return true;
    },
    [&](Id vertex, const Steps& steps)
    {
      const double weight = 0.5 / static_cast<double>(steps.size());
      rows.Add(vertex, 0.5);
      rows.Add(next.GetApex(steps.back().Corner), weight);
      for (std::size_t k = 0; k + 1 < steps.size(); ++k)
      {
        rows.Add(next.GetApex(steps[k].Corner), weight);
      }
    },
    rows);
}

template <typename Id>
void AppendCentres(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  Id corner = next.FindOwner(begin);
  rows.AddRun(FourEightCentre, end - begin,
    [&](vtkIdType, Id* columns)
    {
      corner = next.FindNextOwner(corner);
      const std::array<Id, 4> quad = next.GetVertices(corner++);
      std::copy(quad.begin(), quad.end(), columns);
      return true;
    });
}

/// Calls visit(face, quad, owner, side, other) for each face of the level after the next one, which
/// lies between two quads across a side of one of them: it belongs to that with the smaller number.
template <typename Id, typename Visit>
void ForSpokes(const NextLevel<Id>& next, const Visit& visit)
{
  constexpr vtkIdType block = 16384;
  const vtkIdType quads = next.GetNumberOfFaces();
  Buffer<Id> starts((quads + block - 1) / block + 1);
  const auto forQuads = [&](vtkIdType b, const auto& act)
  {
    const vtkIdType end = std::min(quads, (b + 1) * block);
    Id corner = next.FindOwner(b * block);
    for (vtkIdType quad = b * block; quad < end; ++quad)
    {
      corner = next.FindNextOwner(corner);
      act(static_cast<Id>(quad), corner++);
    }
  };
  const auto forBlocks = [&](const auto& act)
  {
    ForRangesOfBlocks(starts.size() - 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType b = begin; b < end; ++b)
        {
          act(b);
        }
      });
  };
  forBlocks(
    [&](vtkIdType b)
    {
      Id count = 0;
      forQuads(b,
        [&](Id quad, Id owner)
        {
          for (const Id other : next.GetNeighbours(owner))
          {
            count += quad < other;
          }
        });
      starts[b] = count;
    });
  CountsToOffsets(starts);
  forBlocks(
    [&](vtkIdType b)
    {
      Id face = starts[b];
      forQuads(b,
        [&](Id quad, Id owner)
        {
          const std::array<Id, 4> others = next.GetNeighbours(owner);
          for (std::size_t side = 0; side < 4; ++side)
          {
            if (quad < others[side])
            {
              visit(face++, quad, owner, side, others[side]);
            }
          }
        });
    });
}

template <typename Id>
SurfaceLevel<Id> Count(const SurfaceLevel<Id>& skipped)
{
  SurfaceLevel<Id> next;
  next.Step = skipped.Step + 1;
  next.Mesh.Arity = 4;
  next.Mesh.NumberOfVertices = skipped.Mesh.NumberOfVertices + skipped.Mesh.NumberOfFaces;
  next.Mesh.NumberOfFaces = skipped.Mesh.GetNumberOfEdges();
  return next;
}

template <typename Id>
void AppendRows(const SurfaceLevel<Id>& level, const IrregularRows<Id>&, vtkIdType begin,
  vtkIdType end, RowBlock<Id>& rows)
{
  const NextLevel<Id> next(level);
  ForKindsOfRows<2>({ next.GetNumberOfVertices(), next.GetNumberOfFaces() }, begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      kind == 0 ? AppendFourEightVertices(level, first, last, rows)
                : AppendCentres(next, first, last, rows);
    });
}

template <typename Id>
void GetParents(const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents)
{
  const NextLevel<Id> next(level);
  const vtkIdType quad = row - next.GetNumberOfVertices();
  if (quad < 0)
  {
    parents.assign({ row });
    return;
  }
  const std::array<Id, 4> vertices = next.GetVertices(next.FindOwner(quad));
  parents.assign(vertices.begin(), vertices.end());
}

template <typename Id, typename Out>
void WriteFaces(const SurfaceLevel<Id>& level, Out* ids)
{
  const NextLevel<Id> next(level);
  const Id centres = static_cast<Id>(next.GetNumberOfVertices());
  ForSpokes(next,
    [&](Id face, Id quad, Id owner, std::size_t side, Id other)
    {
      const std::array<Id, 4> vertices = next.GetVertices(owner);
      Out* to = ids + 4 * static_cast<vtkIdType>(face);
      to[0] = static_cast<Out>(vertices[side]);
      to[1] = static_cast<Out>(centres + other);
      to[2] = static_cast<Out>(vertices[(side + 1) % 4]);
      to[3] = static_cast<Out>(centres + quad);
    });
}

}

template <typename Id>
void AppendFourEightVertices(
  const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const NextLevel<Id> next(level);
  const MadeVertices<Id> made(level);
  const vtkIdType others = made.GetFirst();
  ForKindsOfRows<3>({ others, level.Mesh.NumberOfVertices - others, level.Mesh.NumberOfFaces },
    begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      kind == 0     ? AppendVertices(next, first, last, rows)
        : kind == 1 ? made.Append(first, last, rows)
                    : AppendApices(next, first, last, rows);
    });
}

template <typename Id>
StepOfNext<Id> MakeFourEightStepOfNext()
{
  return { [](const SurfaceLevel<Id>& level) { return !FourEightTopology<Id>(level).HasFixed(); },
    AppendRows<Id>, GetParents<Id>, [](const SurfaceLevel<Id>& level, IdsOut ids)
    { std::visit([&level](auto* to) { WriteFaces(level, to); }, ids); }, Count<Id> };
}

SUBDIVISION_COMPILE_FUNCTION(AppendFourEightVertices);
SUBDIVISION_COMPILE_FUNCTION(MakeFourEightStepOfNext);

}
