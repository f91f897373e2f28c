// SPDX-License-Identifier: BSD-3-Clause
#include "LimitNormals.h"

#include "Simplices.h"
#include "TetOctRingEmitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace subdivision
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Sectors of a stretch of vertices.
template <typename Id>
struct SectorPart
{
  std::vector<Id> Sizes; ///< entries of each sector's rows
  std::vector<Id> Columns;
  std::vector<double> First;
  std::vector<double> Second;
  std::vector<Id> InsideSizes;
  std::vector<Id> Inside;
};

/// The vertex of a cell that lies behind a vertex and a face at it.
template <typename Id>
Id FindInside(const Level<Id>& level, Id tet, Id face, Id)
{
  const auto& complex = level.Complex;
  return complex.TetVertices[4 * vtkIdType(tet) + complex.FaceInTet(tet, face)];
}
template <typename Id>
Id FindInside(const TetOctLevel<Id>& level, Id cell, Id face, Id vertex)
{
  const auto& complex = level.Complex;
  const Id oct = cell - complex.NumberOfTets;
  return oct < 0
    ? complex.TetVertices[4 * vtkIdType(cell) + complex.FaceInTet(cell, face)]
    : level.OctVertices[6 * vtkIdType(oct) + octahedron::Opposite(VertexInOct(level, oct, vertex))];
}

/// The level is a Level or a TetOctLevel.
template <template <typename> class AnyLevel, typename Id>
class SectorWalker
{
public:
  explicit SectorWalker(const AnyLevel<Id>& level)
    : Here(level)
    , Complex(level.Complex)
    , Strata(level.Strata)
  {
    this->FindFacesAtCurves();
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
  bool Follow(Id vertex, Id edge, Id face, Walk& walk) const;
  void AppendSector(Id vertex, const Walk& walk, SectorPart<Id>& part) const;
  double GetSign(Id vertex, const Walk& walk) const;
  Rule RuleOf(Id edge) const { return this->Strata.Edges[edge].GetRule(); }
  Id EdgeAcross(Id face, Id edge, Id vertex) const
  {
    const Id* edges = this->Complex.FaceEdges.data() + 3 * vtkIdType(face);
    const int* local = triangle::EdgesAt[this->Complex.VertexInFace(face, vertex)];
    return edges[edges[local[0]] == edge ? local[1] : local[0]];
  }

  const AnyLevel<Id>& Here;
  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  Rows<Id> FacesAtCurves; ///< of each edge that follows the rule for curves, in surfaces only
};

template <template <typename> class AnyLevel, typename Id>
void SectorWalker<AnyLevel, Id>::FindFacesAtCurves()
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

/// From an edge over a face and on through smooth edges: around, or to the next sharp edge.
template <template <typename> class AnyLevel, typename Id>
bool SectorWalker<AnyLevel, Id>::Follow(Id vertex, Id edge, Id face, Walk& walk) const
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

template <template <typename> class AnyLevel, typename Id>
Id SectorWalker<AnyLevel, Id>::Append(Id vertex, SectorPart<Id>& part) const
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
        walk.Edges.back() == other)
      {
        this->AppendSector(vertex, walk, part);
        ++sectors;
      }
    }
  }
  return sectors;
}

/// Whether the walk goes around the vertex like its surface triangle with the smallest number.
template <template <typename> class AnyLevel, typename Id>
double SectorWalker<AnyLevel, Id>::GetSign(Id vertex, const Walk& walk) const
{
  const std::size_t first =
    std::min_element(walk.Faces.begin(), walk.Faces.end()) - walk.Faces.begin();
  const Id face = walk.Faces[first];
  const Id ahead = this->Complex.OtherEnd(walk.Edges[first], vertex);
  const int own = this->Complex.VertexInFace(face, vertex);
  return this->Complex.VertexInFace(face, ahead) == (own + 1) % 3 ? 1. : -1.;
}

template <template <typename> class AnyLevel, typename Id>
void SectorWalker<AnyLevel, Id>::AppendSector(
  Id vertex, const Walk& walk, SectorPart<Id>& part) const
{
  const std::size_t size = walk.Edges.size();
  const double sign = this->GetSign(vertex, walk);
  auto append = [&](Id column, double first, double second)
  {
    part.Columns.push_back(column);
    part.First.push_back(first);
    part.Second.push_back(sign * second);
  };
  std::vector<Id> around;
  for (Id edge : walk.Edges)
  {
    around.push_back(this->Complex.OtherEnd(edge, vertex));
  }
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
  Id inside = 0;
  for (std::size_t j = 0; j < walk.Faces.size(); ++j)
  {
    for (Id cell : this->Complex.FaceTets[walk.Faces[j]])
    {
      const Id pair[2] = { around[j], around[(j + 1) % size] };
      part.Inside.push_back(pair[sign > 0. ? 0 : 1]);
      part.Inside.push_back(pair[sign > 0. ? 1 : 0]);
      part.Inside.push_back(FindInside(this->Here, cell, walk.Faces[j], vertex));
      inside += 3;
    }
  }
  part.InsideSizes.push_back(inside);
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

template <typename Id>
Buffer<Id> JoinOffsets(
  const std::vector<SectorPart<Id>>& parts, std::vector<Id> SectorPart<Id>::* sizes)
{
  const Buffer<Id> joined = Join(parts, sizes);
  Buffer<Id> offsets(joined.size() + 1);
  std::copy(joined.begin(), joined.end(), offsets.begin());
  CountsToOffsets(offsets);
  return offsets;
}

template <template <typename> class AnyLevel, typename Id>
LimitTangents<Id> BuildTangents(const AnyLevel<Id>& level, const SemiSharpStages<Id>& creases)
{
  const SectorWalker<AnyLevel, Id> walker(level);
  const vtkIdType vertices = level.Complex.NumberOfVertices;
  constexpr vtkIdType block = 4096;
  const vtkIdType blocks = (vertices + block - 1) / block;
  std::vector<bool> isSharp(vertices, false);
  for (vtkIdType e = 0; e < creases.Sharpness.size(); ++e)
  {
    if (creases.Sharpness[e] > 0.)
    {
      isSharp[level.Complex.EdgeVertices[2 * e]] = true;
      isSharp[level.Complex.EdgeVertices[2 * e + 1]] = true;
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
  vtkSMPTools::For(0, blocks, 1, makeBlocks);
  CountsToOffsets(tangents.Sectors.Offsets);
  tangents.First.NumberOfColumns = tangents.Second.NumberOfColumns = vertices;
  tangents.First.Offsets = JoinOffsets(parts, &SectorPart<Id>::Sizes);
  tangents.First.Columns = Join(parts, &SectorPart<Id>::Columns);
  tangents.First.Weights = Join(parts, &SectorPart<Id>::First);
  tangents.Second.Offsets = JoinOffsets(parts, &SectorPart<Id>::Sizes);
  tangents.Second.Columns = Join(parts, &SectorPart<Id>::Columns);
  tangents.Second.Weights = Join(parts, &SectorPart<Id>::Second);
  tangents.Inside.Offsets = JoinOffsets(parts, &SectorPart<Id>::InsideSizes);
  tangents.Inside.Items = Join(parts, &SectorPart<Id>::Inside);
  return tangents;
}

}

template <typename Id>
LimitTangents<Id> BuildLimitTangents(const Level<Id>& level, const SemiSharpStages<Id>& creases)
{
  return BuildTangents(level, creases);
}
template <typename Id>
LimitTangents<Id> BuildLimitTangents(
  const TetOctLevel<Id>& level, const SemiSharpStages<Id>& creases)
{
  return BuildTangents(level, creases);
}

namespace
{

using Vector = std::array<double, 3>;

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double Length(const Vector& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

/// Of unit length; zero if it is shorter than `least`, or not finite.
inline Vector Normalise(const Vector& a, double least)
{
  const double length = Length(a);
  return length > least && std::isfinite(length)
    ? Vector{ a[0] / length, a[1] / length, a[2] / length }
    : Vector{ 0., 0., 0. };
}

}

template <typename Id>
void ComputeLimitNormals(const LimitTangents<Id>& tangents, const double* points, double* normals)
{
  const vtkIdType sectors = tangents.GetNumberOfSectors();
  Buffer<double> first(3 * sectors);
  Buffer<double> second(3 * sectors);
  tangents.First.Apply(points, first.data(), 3);
  tangents.Second.Apply(points, second.data(), 3);
  auto read = [](const double* at) { return Vector{ at[0], at[1], at[2] }; };
  auto normalOf = [&](vtkIdType sector, vtkIdType vertex)
  {
    const Vector u = read(first.data() + 3 * sector);
    const Vector w = read(second.data() + 3 * sector);
    const Vector normal = Normalise(Cross(u, w), 1e-12 * Length(u) * Length(w));
    const Row<Id> inside = tangents.Inside[sector];
    double volume = 0.;
    for (const Id* triple = inside.begin(); triple != inside.end(); triple += 3)
    {
      Vector sides[3];
      for (int k = 0; k < 3; ++k)
      {
        sides[k] = read(points + 3 * vtkIdType(triple[k]));
        for (int c = 0; c < 3; ++c)
        {
          sides[k][c] -= points[3 * vertex + c];
        }
      }
      volume += Dot(Cross(sides[0], sides[1]), sides[2]);
    }
    const double sign = volume > 0. ? -1. : 1.; // the solid lies behind
    return Vector{ sign * normal[0], sign * normal[1], sign * normal[2] };
  };
  ForEach(tangents.Sectors.GetNumberOfRows(),
    [&](vtkIdType v)
    {
      Vector sum = { 0., 0., 0. };
      for (vtkIdType s = tangents.Sectors.Offsets[v]; s < tangents.Sectors.Offsets[v + 1]; ++s)
      {
        const Vector normal = normalOf(s, v);
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += normal[c];
        }
      }
      const Vector normal = Normalise(sum, 1e-12);
      std::copy(normal.begin(), normal.end(), normals + 3 * v);
    });
}

#define SUBDIVISION_NORMALS(Id)                                                                    \
  template LimitTangents<Id> BuildLimitTangents(const Level<Id>&, const SemiSharpStages<Id>&);     \
  template LimitTangents<Id> BuildLimitTangents(                                                   \
    const TetOctLevel<Id>&, const SemiSharpStages<Id>&);                                           \
  template void ComputeLimitNormals(const LimitTangents<Id>&, const double*, double*)
SUBDIVISION_NORMALS(int);
SUBDIVISION_NORMALS(long long);

}
