// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/Skin.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/Restriction.h"
#include "Core/Solids/Limits/SolidsAtFaces.h"

#include <algorithm>

namespace subdivision
{
namespace
{

template <typename Id>
Buffer<Id> CopyOf(const Buffer<Id>& ids)
{
  Buffer<Id> copy(ids.size());
  CopyInThreads(ids.data(), ids.size(), copy.data());
  return copy;
}
template <typename Id>
Buffer<Id> Join(const Buffer<Id>& first, const Buffer<Id>& second)
{
  Buffer<Id> joined(first.size() + second.size());
  CopyInThreads(first.data(), first.size(), joined.data());
  CopyInThreads(second.data(), second.size(), joined.data() + first.size());
  return joined;
}
/// So many children of each, one after the other.
template <typename Id>
Buffer<Id> MakeChildren(const Buffer<Id>& parents, Id ofEach, Id first)
{
  Buffer<Id> children(ofEach * parents.size());
  ForEach(children.size(), [&](vtkIdType i)
    { children[i] = first + ofEach * parents[i / ofEach] + static_cast<Id>(i % ofEach); });
  return children;
}

template <typename LevelType>
class Skin
{
public:
  using Id = typename LevelType::IdType;
  using Scheme = SchemeOf<LevelType>;

  explicit Skin(const LevelType& level)
    : Whole(level)
    , Kept{ Buffer<unsigned char>(level.Complex.NumberOfVertices, 0),
      Buffer<unsigned char>(level.Complex.NumberOfEdges, 0),
      Buffer<unsigned char>(level.Complex.NumberOfFaces, 0) }
  {
    this->Flag();
  }
  /// Whether rows of the skin read only vertices that are kept.
  bool IsClosed() const;
  /// The sides of its faces.
  Rows<vtkIdType> FindSides(const ControlSolids& solids) const;
  /// Makes it after some steps, and the numbers of its vertices in the whole.
  LevelType Refine(int steps, Buffer<Id>& vertices) const;

private:
  void Flag();
  template <typename IsRight>
  bool Has(
    const Rings<Id>& rings, vtkIdType owner, vtkIdType inSolids, const IsRight& isRight) const;

  const LevelType& Whole;
  PartsOfLevel Kept;
};

template <typename LevelType>
void Skin<LevelType>::Flag()
{
  const auto& complex = this->Whole.Complex;
  const auto& strata = this->Whole.Strata;
  ForEachInTurn(complex.NumberOfFaces,
    [&](vtkIdType f)
    {
      this->Kept.Faces[f] = f < complex.NumberOfTriangleCells || complex.FaceTets[f].size() < 2 ||
        strata.Faces[f].GetRule() == Rule::Curve;
      for (int k = 0; k < 3 && this->Kept.Faces[f]; ++k)
      {
        this->Kept.Edges[complex.FaceEdges[3 * f + k]] = 1;
      }
    });
  ForEachInTurn(complex.NumberOfEdges,
    [&](vtkIdType e)
    {
      this->Kept.Edges[e] |=
        e < complex.NumberOfLineCells || strata.Edges[e].GetRule() == Rule::Curve;
      for (int k = 0; k < 2 && this->Kept.Edges[e]; ++k)
      {
        this->Kept.Vertices[complex.EdgeVertices[2 * e + k]] = 1;
      }
    });
  for (const Id vertex : complex.VertexCells)
  {
    this->Kept.Vertices[vertex] = 1;
  }
}

/// Whether the members of a ring, of which some lie in solids, are kept, and the carriers right.
template <typename LevelType>
template <typename IsRight>
bool Skin<LevelType>::Has(
  const Rings<Id>& rings, vtkIdType owner, vtkIdType inSolids, const IsRight& isRight) const
{
  bool has = inSolids == 0;
  for (vtkIdType k = rings.Offsets[owner]; has && k < rings.Offsets[owner + 1]; ++k)
  {
    const Id carrier = rings.Carriers[k];
    has = carrier < 0 ? this->Kept.Vertices[rings.Members[k]] : isRight(carrier);
  }
  return has;
}

/// Midpoints of edges with rules of solids read solids at the faces there, and edges in such faces.
template <typename LevelType>
bool Skin<LevelType>::IsClosed() const
{
  const auto& strata = this->Whole.Strata;
  const typename Scheme::Star solids(this->Whole);
  bool isClosed = true;
  ForEachInTurn(this->Kept.Vertices.size(),
    [&](vtkIdType v)
    {
      const auto inSolids = solids.CountSolids(
        static_cast<Id>(v), strata.Vertices[v].GetRule(), strata.VertexRings.GetSize(v));
      isClosed = isClosed &&
        (!this->Kept.Vertices[v] ||
          this->Has(strata.VertexRings, v, inSolids,
            [this](Id edge) { return this->Kept.Edges[edge] != 0; }));
    });
  ForEachInTurn(this->Kept.Edges.size(),
    [&](vtkIdType e)
    {
      const Rule rule = strata.Edges[e].GetRule();
      const vtkIdType size = strata.EdgeRings.GetSize(e);
      isClosed = isClosed &&
        (!this->Kept.Edges[e] ||
          this->Has(strata.EdgeRings, e, size - solids.CountFaces(rule, size),
            [&](Id face)
            {
              return this->Kept.Faces[face] &&
                (rule <= Rule::Surface || this->Whole.Complex.FaceTets[face].size() == 0);
            }));
    });
  ForEachInTurn(this->Kept.Faces.size(),
    [&](vtkIdType f)
    {
      const Rule rule = strata.Faces[f].GetRule();
      isClosed = isClosed && (!this->Kept.Faces[f] || rule == Rule::Surface || rule == Rule::Curve);
    });
  return isClosed;
}

template <typename LevelType>
Rows<vtkIdType> Skin<LevelType>::FindSides(const ControlSolids& solids) const
{
  const SolidsAtFaces<Scheme> at(this->Whole, solids);
  const Selection<Id> faces(this->Kept.Faces);
  Rows<vtkIdType> sides;
  sides.Offsets = Buffer<vtkIdType>(faces.Old.size() + 1);
  ForEach(faces.Old.size(), [&](vtkIdType f) { sides.Offsets[f] = at.Count(faces.Old[f]); });
  CountsToOffsets(sides.Offsets);
  sides.Items = Buffer<vtkIdType>(sides.Offsets[faces.Old.size()]);
  ForEach(faces.Old.size(),
    [&](vtkIdType f)
    {
      const Id* corners = this->Whole.Complex.FaceVertices.data() + 3 * vtkIdType(faces.Old[f]);
      vtkIdType* next = sides.Items.data() + sides.Offsets[f];
      at.ForSides(faces.Old[f], { corners[0], corners[1], corners[2] },
        [&next](vtkIdType side) { *next++ = side; });
    });
  return sides;
}

/// Ids of children follow from those of their parents (Refiner.h): midpoints of edges come after
/// vertices, and edges in faces after halves of edges.
template <typename LevelType>
LevelType Skin<LevelType>::Refine(int steps, Buffer<Id>& vertices) const
{
  const auto& complex = this->Whole.Complex;
  const Restriction<LevelType> part(this->Whole, this->Kept);
  LevelType level = part.Restrict();
  level.Complex.NumberOfLineCells = complex.NumberOfLineCells;
  level.Complex.NumberOfTriangleCells = complex.NumberOfTriangleCells;
  level.Complex.VertexCells = Buffer<Id>(complex.VertexCells.size());
  std::transform(complex.VertexCells.begin(), complex.VertexCells.end(),
    level.Complex.VertexCells.begin(), [&](Id v) { return part.GetNewVertices()[v]; });
  const bool isWhole = complex.NumberOfTets == 0 && Scheme::CountCentres(this->Whole) == 0 &&
    part.GetOldVertices().size() == complex.NumberOfVertices;
  Buffer<Id> edges = CopyOf(part.GetOldEdges());
  Buffer<Id> faces = CopyOf(part.GetOldFaces());
  vertices = isWhole ? Buffer<Id>() : CopyOf(part.GetOldVertices());
  LevelCounts counts = CountSimplices<Scheme>(this->Whole);
  for (int step = 0; step < steps; ++step)
  {
    level = subdivision::Refine(level, Depth::ForRefinement);
    if (!isWhole)
    {
      const auto firstMidpoint = static_cast<Id>(counts.Vertices);
      const auto firstInFace = static_cast<Id>(2. * counts.Edges);
      vertices = Join(vertices, MakeChildren(edges, Id(1), firstMidpoint));
      edges = Join(MakeChildren(edges, Id(2), Id(0)), MakeChildren(faces, Id(3), firstInFace));
      faces = MakeChildren(faces, Id(4), Id(0));
      counts = counts.Refine();
    }
  }
  return level;
}

}

/// Calls compute(points, frames) for Tangents, and spreads the frames to all vertices.
template <typename Id>
template <std::size_t Count, typename Compute>
void SkinTangents<Id>::ComputeFrames(const Coordinates& points, vtkIdType size,
  Buffer<double> (&frames)[Count], const Compute& compute) const
{
  const vtkIdType own = this->HasAll ? size : this->Vertices.size();
  Buffer<double> ofOwn[Count];
  std::generate(ofOwn, ofOwn + Count, [own]() { return Buffer<double>(3 * own); });
  if (this->HasAll)
  {
    compute(points, ofOwn);
    std::move(ofOwn, ofOwn + Count, frames);
    return;
  }
  Buffer<double> taken(3 * own);
  ForEach(own, [&](vtkIdType i)
    { std::copy_n(points + 3 * vtkIdType(this->Vertices[i]), 3, taken.data() + 3 * i); });
  compute(Coordinates(taken.data(), points.Tie), ofOwn);
  for (std::size_t k = 0; k < Count; ++k)
  {
    frames[k] = this->Rings.Sides.empty() ? Buffer<double>(3 * size, 0.) : Buffer<double>(3 * size);
    ForEach(own,
      [&](vtkIdType i)
      {
        std::copy_n(
          ofOwn[k].data() + 3 * i, 3, frames[k].data() + 3 * vtkIdType(this->Vertices[i]));
      });
  }
}

template <typename Id>
Buffer<double> SkinTangents<Id>::ComputeNormals(const Coordinates& points, vtkIdType size,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned) const
{
  Buffer<double> normals[1];
  this->ComputeFrames(points, size, normals, [&](const Coordinates& own, Buffer<double>* frames)
    { ComputeLimitNormals(this->Tangents, own, inverted, turned, frames[0].data()); });
  this->Rings.ComputeNormals(points, turned, normals[0].data());
  return std::move(normals[0]);
}

template <typename Id>
void SkinTangents<Id>::ComputeTangents(const Coordinates& points, vtkIdType size,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned,
  Buffer<double> (&tangents)[2]) const
{
  this->ComputeFrames(points, size, tangents,
    [&](const Coordinates& own, Buffer<double>* frames)
    {
      ComputeLimitTangents(
        this->Tangents, own, inverted, turned, frames[0].data(), frames[1].data());
    });
  this->Rings.ComputeTangents(points, turned, tangents[0].data(), tangents[1].data());
}

template <typename Level>
bool BuildSkinTangents(const Level& level, const ControlSolids& solids, int steps,
  SkinTangents<typename Level::IdType>& tangents)
{
  using Scheme = SchemeOf<Level>;
  if constexpr (Scheme::Traits.HasTangents)
  {
    const int all = solids.Steps + steps;
    tangents.HasAll = false;
    if (steps > 0 && level.Complex.NumberOfTets == 0 && Scheme::CountCentres(level) == 0)
    {
      Level before;
      for (int step = 0; step + 1 < steps; ++step)
      {
        before = subdivision::Refine(step == 0 ? level : before, Depth::ForRefinement);
      }
      tangents.Rings =
        FindRegularRings(steps > 1 ? before : level, all - 1, tangents.Tangents, tangents.Vertices);
      return true;
    }
    const Skin<Level> skin(level);
    if (skin.IsClosed())
    {
      const Rows<vtkIdType> sides = skin.FindSides(solids);
      const Level refined = skin.Refine(steps, tangents.Vertices);
      tangents.HasAll = tangents.Vertices.empty();
      tangents.Tangents = BuildLimitTangents(refined, {}, { {}, all, &sides, steps });
      return true;
    }
  }
  return false;
}

SUBDIVISION_COMPILE(struct SkinTangents);

#define SUBDIVISION_SKIN(Scheme)                                                                   \
  template bool BuildSkinTangents(                                                                 \
    const Scheme::Level&, const ControlSolids&, int, SkinTangents<Scheme::Id>&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_SKIN);

}
