// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LimitNormals.h"

#include "Core/Rules/Pi.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/Simplices.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
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
  {
    this->FindFacesAtCurves();
    this->FindTurnedFaces();
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

  void FindFacesAtCurves();
  bool FindPair(Id edge, Id (&faces)[2]) const;
  bool Contradict(Id edge, const Id (&faces)[2]) const;
  void FindTurnedFaces();
  void OrientPart(Id first);
  /// The most triangles that a sector with a tangent plane has.
  static constexpr std::size_t MostTriangles = 6;
  bool Follow(Id vertex, Id edge, Id face, Walk& walk) const;
  void AppendSector(Id vertex, const Walk& walk, SectorPart<Id>& part) const;
  void AppendSides(
    Id vertex, const Walk& walk, const std::vector<Id>& around, SectorPart<Id>& part) const;
  double GetSign(Id vertex, const Walk& walk) const;
  Rule RuleOf(Id edge) const { return this->Strata.Edges[edge].GetRule(); }
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
  Rows<Id> FacesAtCurves; ///< the faces of less than two tetrahedra at each edge with d = 1
  /// For each triangle of a surface whether its orientation is opposite to that of the first
  /// triangle of its part (LimitTangents::First). Empty if that is so for none.
  Buffer<unsigned char> Turned;
};

template <typename Scheme>
void SectorWalker<Scheme>::FindFacesAtCurves()
{
  const vtkIdType edges = this->Complex.NumberOfEdges;
  this->FacesAtCurves.Offsets = Buffer<Id>(edges + 1, 0);
  auto forPairs = [&](const auto& act)
  {
    for (Id face = 0; face < this->Complex.NumberOfFaces; ++face)
    {
      for (int k = 0; k < 3 && this->Complex.FaceTets[face].size() < 2; ++k)
      {
        const Id edge = this->Complex.FaceEdges[3 * vtkIdType(face) + k];
        if (this->RuleOf(edge) == Rule::Curve)
        {
          act(edge, face);
        }
      }
    }
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
    for (Id face : this->FacesAtCurves[edge])
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
bool SectorWalker<Scheme>::FindPair(Id edge, Id (&faces)[2]) const
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
bool SectorWalker<Scheme>::Contradict(Id edge, const Id (&faces)[2]) const
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
void SectorWalker<Scheme>::FindTurnedFaces()
{
  std::atomic<bool> found(false);
  ForEach(this->Complex.NumberOfEdges,
    [&](vtkIdType e)
    {
      Id faces[2];
      const Id edge = static_cast<Id>(e);
      if (this->FindPair(edge, faces) && this->Contradict(edge, faces))
      {
        found.store(true, std::memory_order_relaxed);
      }
    });
  if (!found)
  {
    return;
  }
  this->Turned = Buffer<unsigned char>(this->Complex.NumberOfFaces, 2);
  for (Id face = 0; face < this->Complex.NumberOfFaces; ++face)
  {
    if (this->Turned[face] == 2 && this->Complex.FaceTets[face].size() == 0)
    {
      this->OrientPart(face);
    }
  }
}

/// Sets Turned for the part of a triangle: all triangles that are reached over FindPair. If the
/// part is not orientable, no triangle of it counts as turned.
template <typename Scheme>
void SectorWalker<Scheme>::OrientPart(Id first)
{
  std::vector<Id> part = { first };
  this->Turned[first] = 0;
  bool isOrientable = true;
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      Id faces[2];
      const Id edge = this->Complex.FaceEdges[3 * vtkIdType(part[i]) + k];
      if (!this->FindPair(edge, faces))
      {
        continue;
      }
      const Id other = faces[faces[0] == part[i] ? 1 : 0];
      const unsigned char side =
        static_cast<unsigned char>(this->Turned[part[i]] ^ (this->Contradict(edge, faces) ? 1 : 0));
      if (this->Turned[other] == 2)
      {
        this->Turned[other] = side;
        part.push_back(other);
      }
      isOrientable = isOrientable && this->Turned[other] == side;
    }
  }
  for (const Id face : part)
  {
    this->Turned[face] = isOrientable ? this->Turned[face] : 0;
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
      const vtkIdType tet = this->Tets.Find(cell);
      const vtkIdType number = this->Solids.Numbers.empty() ? tet : this->Solids.Numbers[tet];
      part.Sides.push_back(2 * number + (Scheme::GetTurn(this->Here, cell, triangle) < 0 ? 1 : 0));
    }
  }
  part.SideSizes.push_back(static_cast<vtkIdType>(part.Sides.size() - before));
}

/// 1 if a walk on a surface has the orientation of the first triangle of its part, else -1. On the
/// boundary of a solid always 1.
template <typename Scheme>
double SectorWalker<Scheme>::GetSign(Id vertex, const Walk& walk) const
{
  if (this->Complex.FaceTets[walk.Faces.front()].size() > 0)
  {
    return 1.;
  }
  const std::size_t first =
    std::min_element(walk.Faces.begin(), walk.Faces.end()) - walk.Faces.begin();
  const Id face = walk.Faces[first];
  const Id ahead = this->Complex.GetOtherEnd(walk.Edges[first], vertex);
  const int own = this->Complex.VertexInFace(face, vertex);
  const bool isTurned = !this->Turned.empty() && this->Turned[face] == 1;
  return (this->Complex.VertexInFace(face, ahead) == (own + 1) % 3) != isTurned ? 1. : -1.;
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
  const double sign = this->GetSign(vertex, walk);
  this->AppendSides(vertex, walk, around, part);
  auto append = [&](Id column, double first, double second)
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

}

template <typename Level>
LimitTangents<typename Level::IdType> BuildLimitTangents(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases, const ControlSolids& solids)
{
  using Id = typename Level::IdType;
  const SectorWalker<SchemeOf<Level>> walker(level, solids);
  const vtkIdType vertices = level.Complex.NumberOfVertices;
  constexpr vtkIdType block = 4096;
  const vtkIdType blocks = (vertices + block - 1) / block;
  std::vector<bool> isSharp(vertices, !SchemeOf<Level>::Traits.HasTangents);
  for (const SharpRow& row : creases.ListParts(level.Complex).GetRows())
  {
    if (row.Row < vertices)
    {
      isSharp[row.Row] = true;
    }
  }
  std::vector<SectorPart<Id>> parts(blocks);
  LimitTangents<Id> tangents;
  tangents.Sectors.Offsets = Buffer<Id>(vertices + 1);
  auto makeBlocks = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType b = begin; b < end; ++b)
    {
      for (vtkIdType v = b * block; v < std::min(vertices, (b + 1) * block); ++v)
      {
        tangents.Sectors.Offsets[v] = isSharp[v] ? 0 : walker.Append(static_cast<Id>(v), parts[b]);
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
  tangents.Shading = FindShadingFacets(level, tangents.Sectors);
  return tangents;
}

#define SUBDIVISION_NORMALS(Scheme)                                                                \
  template LimitTangents<Scheme::Id> BuildLimitTangents(                                           \
    const Scheme::Level&, const SemiSharpStages<Scheme::Id>&, const ControlSolids&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_NORMALS);

}
