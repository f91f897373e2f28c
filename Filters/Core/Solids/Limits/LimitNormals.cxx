// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LimitNormals.h"

#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/Simplices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// Sectors of a stretch of vertices.
template <typename Id>
struct SectorPart
{
  std::vector<Id> Sizes; ///< entries of each sector's rows
  std::vector<Id> Columns;
  std::vector<double> First;
  std::vector<double> Second;
  std::vector<vtkIdType> SideSizes;
  std::vector<vtkIdType> Sides;
  std::vector<Id> Triangles;
};

/// The triangles of surfaces that continue each other across edges.
template <typename Scheme>
class TrianglePairs
{
public:
  using Id = typename Scheme::Id;

  explicit TrianglePairs(const typename Scheme::Level& level)
    : Complex(level.Complex)
    , Strata(level.Strata)
  {
    this->FindFacesAtCurves();
  }
  Row<Id> GetFacesAtCurve(Id edge) const { return this->FacesAtCurves[edge]; }
  Rule RuleOf(Id edge) const { return this->Strata.Edges[edge].GetRule(); }
  /// Links for FindSides, over edges with an end that is sure; no flags: all are.
  template <typename Visit>
  void ForLinks(Id face, const std::vector<char>& isSure, const Visit& visit) const;

private:
  void FindFacesAtCurves();
  bool FindPair(Id edge, Id (&faces)[2]) const;
  bool Contradict(Id edge, const Id (&faces)[2]) const;

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  Rows<Id> FacesAtCurves; ///< the faces of less than two tetrahedra at each edge with d = 1
};

template <typename Scheme>
class SectorWalker
{
public:
  using Id = typename Scheme::Id;

  SectorWalker(const typename Scheme::Level& level, const ControlSolids& solids)
    : Here(level)
    , Complex(level.Complex)
    , Strata(level.Strata)
    , Solids(solids)
    , Tets(level, solids.Steps)
    , Pairs(level)
  {
  }

  /// Appends the sectors of a vertex, and says how many they are.
  Id Append(Id vertex, SectorPart<Id>& part) const;

private:
  struct Walk
  {
    std::vector<Id> Edges;
    std::vector<Id> Faces;
    bool IsClosed = false;
  };

  /// The most triangles that a sector with a tangent plane has.
  static constexpr std::size_t MostTriangles = 6;
  bool Follow(Id vertex, Id edge, Id face, Walk& walk) const;
  void AppendSector(Id vertex, const Walk& walk, SectorPart<Id>& part) const;
  void AppendSides(
    Id vertex, const Walk& walk, const std::vector<Id>& around, SectorPart<Id>& part) const;
  std::pair<Id, double> GetSign(Id vertex, const Walk& walk) const;
  Rule RuleOf(Id edge) const { return this->Pairs.RuleOf(edge); }
  Id EdgeAcross(Id face, Id edge, Id vertex) const
  {
    const Id* edges = this->Complex.FaceEdges.data() + 3 * vtkIdType(face);
    const int* local = triangle::EdgesAt[this->Complex.VertexInFace(face, vertex)];
    return edges[edges[local[0]] == edge ? local[1] : local[0]];
  }

  const typename Scheme::Level& Here;
  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const ControlSolids& Solids;
  const typename Scheme::ControlTets Tets;
  const TrianglePairs<Scheme> Pairs;
};

template <typename Scheme>
void TrianglePairs<Scheme>::FindFacesAtCurves()
{
  const vtkIdType edges = this->Complex.NumberOfEdges;
  this->FacesAtCurves.Offsets = Buffer<Id>(edges + 1, 0);
  auto forPairs = [&](const auto& act)
  {
    ForEachInTurn(this->Complex.NumberOfFaces,
      [&](vtkIdType f)
      {
        const Id face = static_cast<Id>(f);
        for (int k = 0; k < 3 && this->Complex.FaceTets[face].size() < 2; ++k)
        {
          const Id edge = this->Complex.FaceEdges[3 * f + k];
          if (this->RuleOf(edge) == Rule::Curve)
          {
            act(edge, face);
          }
        }
      });
  };
  forPairs([&](Id edge, Id) { ++this->FacesAtCurves.Offsets[edge]; });
  CountsToOffsets(this->FacesAtCurves.Offsets);
  this->FacesAtCurves.Items = Buffer<Id>(this->FacesAtCurves.Offsets[edges]);
  std::vector<Id> next(this->FacesAtCurves.Offsets.begin(), this->FacesAtCurves.Offsets.end());
  forPairs([&](Id edge, Id face) { this->FacesAtCurves.Items[next[edge]++] = face; });
}

/// Walks around a vertex from an edge over a face and further smooth edges, back to the first edge
/// or to the next sharp edge. Returns whether the faces on the way are a sector.
template <typename Scheme>
bool SectorWalker<Scheme>::Follow(Id vertex, Id edge, Id face, Walk& walk) const
{
  walk.Edges.assign(1, edge);
  walk.Faces.clear();
  for (;;)
  {
    if (face < 0 || this->Complex.FaceTets[face].size() > 1)
    {
      return false;
    }
    walk.Faces.push_back(face);
    const Id next = this->EdgeAcross(face, walk.Edges.back(), vertex);
    if (next == edge)
    {
      walk.IsClosed = true;
      return this->RuleOf(edge) == Rule::Surface;
    }
    walk.Edges.push_back(next);
    if (this->RuleOf(next) != Rule::Surface)
    {
      walk.IsClosed = false;
      return this->RuleOf(next) == Rule::Curve && this->RuleOf(edge) == Rule::Curve;
    }
    const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(next);
    if (faces.size() != 2 || (faces.begin()[0] != face && faces.begin()[1] != face))
    {
      return false;
    }
    face = faces.begin()[faces.begin()[0] == face ? 1 : 0];
  }
}

template <typename Scheme>
typename Scheme::Id SectorWalker<Scheme>::Append(Id vertex, SectorPart<Id>& part) const
{
  const Rule rule = this->Strata.Vertices[vertex].GetRule();
  const Row<Id> ring = this->Strata.VertexRings.GetCarriers(vertex);
  Walk walk;
  if (rule == Rule::Surface && ring.size() > 0)
  {
    const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(*ring.begin());
    if (faces.size() == 2 && this->Follow(vertex, *ring.begin(), *faces.begin(), walk) &&
      walk.IsClosed && static_cast<vtkIdType>(walk.Edges.size()) == ring.size())
    {
      this->AppendSector(vertex, walk, part);
      return 1;
    }
    return 0;
  }
  Id sectors = 0;
  for (Id edge : rule == Rule::Curve && ring.size() == 2 ? ring : Row<Id>())
  {
    const Id other = ring.begin()[edge == ring.begin()[0] ? 1 : 0];
    for (Id face : this->Pairs.GetFacesAtCurve(edge))
    {
      // Each sector is found from both of its ends: once is enough.
      if (edge < other && this->Follow(vertex, edge, face, walk) && !walk.IsClosed &&
        walk.Edges.back() == other && walk.Faces.size() <= MostTriangles)
      {
        this->AppendSector(vertex, walk, part);
        ++sectors;
      }
    }
  }
  return sectors;
}

/// Finds the two maximal triangles that continue each other across an edge, smooth or crease.
/// Returns false if there are not exactly two.
template <typename Scheme>
bool TrianglePairs<Scheme>::FindPair(Id edge, Id (&faces)[2]) const
{
  const Row<Id> row = this->RuleOf(edge) == Rule::Surface ? this->Strata.EdgeRings.GetCarriers(edge)
                                                          : this->FacesAtCurves[edge];
  if (row.size() != 2)
  {
    return false;
  }
  std::copy(row.begin(), row.end(), faces);
  return faces[0] >= 0 && faces[1] >= 0 && this->Complex.FaceTets[faces[0]].size() == 0 &&
    this->Complex.FaceTets[faces[1]].size() == 0;
}

/// Whether both triangles run along their edge in the same direction.
template <typename Scheme>
bool TrianglePairs<Scheme>::Contradict(Id edge, const Id (&faces)[2]) const
{
  const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge);
  auto runsAlong = [&](Id face)
  {
    return (this->Complex.VertexInFace(face, ends[0]) + 1) % 3 ==
      this->Complex.VertexInFace(face, ends[1]);
  };
  return runsAlong(faces[0]) == runsAlong(faces[1]);
}

template <typename Scheme>
template <typename Visit>
void TrianglePairs<Scheme>::ForLinks(
  Id face, const std::vector<char>& isSure, const Visit& visit) const
{
  for (int k = 0; k < 3 && this->Complex.FaceTets[face].size() == 0; ++k)
  {
    Id faces[2];
    const Id edge = this->Complex.FaceEdges[3 * vtkIdType(face) + k];
    const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge);
    if ((isSure.empty() || isSure[ends[0]] || isSure[ends[1]]) && this->FindPair(edge, faces))
    {
      visit(vtkIdType(faces[faces[0] == face ? 1 : 0]), this->Contradict(edge, faces));
    }
  }
}

/// Appends LimitTangents::Sides for the triangles of a walk.
template <typename Scheme>
void SectorWalker<Scheme>::AppendSides(
  Id vertex, const Walk& walk, const std::vector<Id>& around, SectorPart<Id>& part) const
{
  const std::size_t before = part.Sides.size();
  for (std::size_t j = 0; j < walk.Faces.size(); ++j)
  {
    const Id triangle[3] = { vertex, around[j], around[(j + 1) % around.size()] };
    for (Id cell : this->Complex.FaceTets[walk.Faces[j]])
    {
      const vtkIdType tet =
        this->Solids.IsOfLevel ? static_cast<vtkIdType>(cell) : this->Tets.Find(cell);
      const vtkIdType number = this->Solids.Numbers.empty() ? tet : this->Solids.Numbers[tet];
      part.Sides.push_back(2 * number + (Scheme::GetTurn(this->Here, cell, triangle) < 0 ? 1 : 0));
    }
  }
  part.SideSizes.push_back(static_cast<vtkIdType>(part.Sides.size() - before));
}

/// The triangle of a walk on a surface by which its side is decided, and 1 if the walk has the
/// orientation of this triangle, else -1. On the boundary of a solid -1 and 1.
template <typename Scheme>
std::pair<typename Scheme::Id, double> SectorWalker<Scheme>::GetSign(
  Id vertex, const Walk& walk) const
{
  if (this->Complex.FaceTets[walk.Faces.front()].size() > 0)
  {
    return { static_cast<Id>(-1), 1. };
  }
  const std::size_t first =
    std::min_element(walk.Faces.begin(), walk.Faces.end()) - walk.Faces.begin();
  const Id face = walk.Faces[first];
  const Id ahead = this->Complex.GetOtherEnd(walk.Edges[first], vertex);
  const int own = this->Complex.VertexInFace(face, vertex);
  return { face, this->Complex.VertexInFace(face, ahead) == (own + 1) % 3 ? 1. : -1. };
}

template <typename Scheme>
void SectorWalker<Scheme>::AppendSector(Id vertex, const Walk& walk, SectorPart<Id>& part) const
{
  const std::size_t size = walk.Edges.size();
  std::vector<Id> around;
  for (Id edge : walk.Edges)
  {
    around.push_back(this->Complex.GetOtherEnd(edge, vertex));
  }
  const auto [face, sign] = this->GetSign(vertex, walk);
  part.Triangles.push_back(face < 0 ? face : static_cast<Id>(face >> 2 * this->Solids.Steps));
  this->AppendSides(vertex, walk, around, part);
  auto append = [&part, sign = sign](Id column, double first, double second)
  {
    part.Columns.push_back(column);
    part.First.push_back(first);
    part.Second.push_back(sign * second);
  };
  if (walk.IsClosed)
  {
    for (std::size_t j = 0; j < size; ++j)
    {
      const double angle = 2. * Pi * static_cast<double>(j) / static_cast<double>(size);
      append(around[j], std::cos(angle), std::sin(angle));
    }
    part.Sizes.push_back(static_cast<Id>(size));
  }
  else
  {
    const double angle = Pi / static_cast<double>(size - 1);
    double sum = 0.;
    for (std::size_t j = 1; j + 1 < size; ++j)
    {
      const double weight = std::sin(angle * static_cast<double>(j));
      append(around[j], 0., weight);
      sum += weight;
    }
    // One triangle: the second difference.
    const double end = size == 2 ? 1. : (std::sin(angle) - sum) / (1. + 2. * std::cos(angle));
    append(around.front(), 1., end);
    append(around.back(), -1., end);
    append(vertex, 0., -2. * end - sum);
    part.Sizes.push_back(static_cast<Id>(size + 1));
  }
}

/// One buffer of what several parts hold.
template <typename Id, typename T>
Buffer<T> Join(const std::vector<SectorPart<Id>>& parts, std::vector<T> SectorPart<Id>::* values)
{
  vtkIdType size = 0;
  for (const SectorPart<Id>& part : parts)
  {
    size += static_cast<vtkIdType>((part.*values).size());
  }
  Buffer<T> joined(size);
  T* out = joined.begin();
  for (const SectorPart<Id>& part : parts)
  {
    out = std::copy((part.*values).begin(), (part.*values).end(), out);
  }
  return joined;
}

template <typename Id, typename T>
Buffer<T> JoinOffsets(
  const std::vector<SectorPart<Id>>& parts, std::vector<T> SectorPart<Id>::* sizes)
{
  const Buffer<T> joined = Join(parts, sizes);
  Buffer<T> offsets(joined.size() + 1);
  std::copy(joined.begin(), joined.end(), offsets.begin());
  CountsToOffsets(offsets);
  return offsets;
}

/// The vertices without tangents because a crease there is still sharp, or because the scheme has
/// none.
template <typename Level>
std::vector<bool> FindSharpVertices(
  const Level& level, const SemiSharpStages<typename Level::IdType>& creases)
{
  const vtkIdType vertices = level.Complex.NumberOfVertices;
  std::vector<bool> isSharp(vertices, !SchemeOf<Level>::Traits.HasTangents);
  for (const SharpRow& row : creases.ListParts(level.Complex).GetRows())
  {
    if (row.Row < vertices)
    {
      isSharp[row.Row] = true;
    }
  }
  return isSharp;
}

/// LimitTangents::AlongCurves. `missing`: the vertices without sector.
template <typename Level>
Buffer<typename Level::IdType> FindCurves(
  const Level& level, const std::vector<bool>& isSharp, const Buffer<unsigned char>& missing)
{
  using Id = typename Level::IdType;
  const auto& complex = level.Complex;
  Buffer<Id> along(2 * missing.size(), Id(-1));
  ForEach(missing.size(),
    [&](vtkIdType v)
    {
      const Row<Id> ring = level.Strata.VertexRings.GetCarriers(v);
      if (!missing[v] || isSharp[v] || level.Strata.Vertices[v].GetRule() != Rule::Curve ||
        ring.size() != 2)
      {
        return;
      }
      const Id vertex = static_cast<Id>(v);
      const Id* edges = ring.begin();
      const bool endsHere = complex.EdgeVertices[2 * vtkIdType(edges[0]) + 1] == vertex;
      along[2 * v] = complex.GetOtherEnd(edges[endsHere ? 0 : 1], vertex);
      along[2 * v + 1] = complex.GetOtherEnd(edges[endsHere ? 1 : 0], vertex);
    });
  return along;
}

/// The tangents of `rows` vertices: vertexOf(row).
template <typename Level, typename VertexOf>
LimitTangents<typename Level::IdType> BuildTangents(const Level& level,
  const std::vector<bool>& isSharp, const ControlSolids& solids, vtkIdType rows,
  const VertexOf& vertexOf)
{
  using Id = typename Level::IdType;
  const SectorWalker<SchemeOf<Level>> walker(level, solids);
  const vtkIdType vertices = level.Complex.NumberOfVertices;
  constexpr vtkIdType block = 4096;
  const vtkIdType blocks = (rows + block - 1) / block;
  std::vector<SectorPart<Id>> parts(blocks);
  LimitTangents<Id> tangents;
  tangents.Sectors.Offsets = Buffer<Id>(rows + 1);
  auto makeBlocks = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType b = begin; b < end; ++b)
    {
      for (vtkIdType row = b * block; row < std::min(rows, (b + 1) * block); ++row)
      {
        const Id vertex = vertexOf(row);
        tangents.Sectors.Offsets[row] = isSharp[vertex] ? 0 : walker.Append(vertex, parts[b]);
      }
    }
  };
  ForRangesOfBlocks(blocks, makeBlocks);
  CountsToOffsets(tangents.Sectors.Offsets);
  tangents.First.NumberOfColumns = tangents.Second.NumberOfColumns = vertices;
  tangents.First.Offsets = JoinOffsets(parts, &SectorPart<Id>::Sizes);
  tangents.First.Columns = Join(parts, &SectorPart<Id>::Columns);
  tangents.First.Weights = Join(parts, &SectorPart<Id>::First);
  tangents.Second.Offsets = JoinOffsets(parts, &SectorPart<Id>::Sizes);
  tangents.Second.Columns = Join(parts, &SectorPart<Id>::Columns);
  tangents.Second.Weights = Join(parts, &SectorPart<Id>::Second);
  tangents.SideOffsets = JoinOffsets(parts, &SectorPart<Id>::SideSizes);
  tangents.Sides = Join(parts, &SectorPart<Id>::Sides);
  tangents.Triangles = Join(parts, &SectorPart<Id>::Triangles);
  return tangents;
}

}

template <typename Level>
FaceSides FindTriangleSides(const Level& level, const std::vector<char>& isSure)
{
  using Id = typename Level::IdType;
  const TrianglePairs<SchemeOf<Level>> pairs(level);
  return FindSides(vtkIdType(level.Complex.NumberOfTriangleCells),
    [&](vtkIdType face, const auto& visit)
    { pairs.ForLinks(static_cast<Id>(face), isSure, visit); });
}

template <typename Level>
LimitTangents<typename Level::IdType> BuildLimitTangents(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases, const ControlSolids& solids)
{
  using Id = typename Level::IdType;
  const std::vector<bool> isSharp = FindSharpVertices(level, creases);
  LimitTangents<Id> tangents = BuildTangents(level, isSharp, solids, level.Complex.NumberOfVertices,
    [](vtkIdType v) { return static_cast<Id>(v); });
  const Buffer<unsigned char> missing = tangents.FindMissing();
  tangents.AlongCurves = FindCurves(level, isSharp, missing);
  tangents.Shading = FindShadingFacets(level, missing, FindShadingCells(level, solids.Steps));
  return tangents;
}

template <typename Level>
LimitTangents<typename Level::IdType> BuildLimitTangents(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases, const ControlSolids& solids,
  const Buffer<typename Level::IdType>& vertices)
{
  return BuildTangents(level, FindSharpVertices(level, creases), solids, vertices.size(),
    [&vertices](vtkIdType row) { return vertices[row]; });
}

#define SUBDIVISION_NORMALS(Scheme)                                                                \
  template FaceSides FindTriangleSides(const Scheme::Level&, const std::vector<char>&);            \
  template LimitTangents<Scheme::Id> BuildLimitTangents(                                           \
    const Scheme::Level&, const SemiSharpStages<Scheme::Id>&, const ControlSolids&);               \
  template LimitTangents<Scheme::Id> BuildLimitTangents(const Scheme::Level&,                      \
    const SemiSharpStages<Scheme::Id>&, const ControlSolids&, const Buffer<Scheme::Id>&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_NORMALS);

}
