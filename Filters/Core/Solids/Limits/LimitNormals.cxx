// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LimitNormals.h"

#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Rules/SectorMasks.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/Limits/SectorParts.h"
#include "Core/Solids/Limits/SolidsAtFaces.h"
#include "Core/Solids/Limits/TrianglePairs.h"
#include "Core/Solids/Scheme/SharpSectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

template <typename Scheme>
class SectorWalker
{
public:
  using Id = typename Scheme::Id;

  SectorWalker(const typename Scheme::Level& level, const SemiSharpStages<Id>& creases,
    const ControlSolids& solids)
    : Here(level)
    , Complex(level.Complex)
    , Strata(level.Strata)
    , Solids(level, solids)
    , Pairs(level)
    , OwnRows(MakeSectorRows(level.Strata, level.Complex.EdgeVertices))
  {
    if (!creases.Stages.empty())
    {
      this->BlendOwnRows(creases);
    }
    for (std::size_t size = 2; size < FewEdges; ++size)
    {
      for (const bool isClosed : { false, true })
      {
        this->Known[isClosed][size] = this->FindTangents(size, isClosed);
      }
    }
  }

  /// Appends the sectors of a vertex, and says how many they are.
  Id Append(Id vertex, SectorPart<Id>& part) const;

private:
  using Walk = SectorWalk<Id>;

  /// The most triangles that a sector with a tangent plane has by the plain rule.
  static constexpr std::size_t MostTriangles = 6;
  bool Follow(Id vertex, Id edge, Id face, Walk& walk) const;
  void AppendSector(Id vertex, SectorPart<Id>& part) const;
  void BlendOwnRows(const SemiSharpStages<Id>& creases);
  SectorTangents FindTangents(std::size_t size, bool isClosed) const
  {
    return FindSectorTangents(size, isClosed, this->Strata.ModifiedBoundary);
  }
  bool IsPlain(Id vertex, const Walk& walk) const;
  void AppendAfterStep(Id vertex, const Walk& walk, const SectorTangents& tangents, double sign,
    SectorPart<Id>& part) const;
  void AppendSides(Id vertex, const Walk& walk, SectorPart<Id>& part) const;
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
  const SolidsAtFaces<Scheme> Solids;
  const TrianglePairs<Scheme> Pairs;
  ExplicitRows<Id> OwnRows;      ///< of edges whose rule depends on sectors
  std::vector<SharpRow> Blended; ///< those of them that depend on creases that are still sharp
  static constexpr std::size_t FewEdges = 16;
  SectorTangents Known[2][FewEdges]; ///< FindTangents
};

/// Walks around a vertex from an edge over a face and further smooth edges, back to the first edge
/// or to the next sharp edge. Returns whether the faces on the way are a sector.
template <typename Scheme>
bool SectorWalker<Scheme>::Follow(Id vertex, Id edge, Id face, Walk& walk) const
{
  walk.Edges.assign(1, edge);
  walk.Faces.clear();
  for (;;)
  {
    if (face < 0 || this->Solids.Count(face) > 1)
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
  Walk& walk = part.Walk;
  if (rule == Rule::Surface && ring.size() > 0)
  {
    const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(*ring.begin());
    if (faces.size() == 2 && this->Follow(vertex, *ring.begin(), *faces.begin(), walk) &&
      walk.IsClosed && static_cast<vtkIdType>(walk.Edges.size()) == ring.size())
    {
      this->AppendSector(vertex, part);
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
        walk.Edges.back() == other &&
        (this->Strata.ModifiedBoundary || walk.Faces.size() <= MostTriangles))
      {
        this->AppendSector(vertex, part);
        ++sectors;
      }
    }
  }
  return sectors;
}

/// Appends LimitTangents::Sides for the triangles of a walk.
template <typename Scheme>
void SectorWalker<Scheme>::AppendSides(Id vertex, const Walk& walk, SectorPart<Id>& part) const
{
  const std::vector<Id>& around = walk.Ends;
  const std::size_t before = part.Sides.size();
  for (std::size_t j = 0; j < walk.Faces.size(); ++j)
  {
    const Id triangle[3] = { vertex, around[j], around[(j + 1) % around.size()] };
    this->Solids.ForSides(
      walk.Faces[j], triangle, [&part](vtkIdType side) { part.Sides.push_back(side); });
  }
  part.SideSizes.push_back(static_cast<vtkIdType>(part.Sides.size() - before));
}

/// The triangle of a walk on a surface by which its side is decided, and 1 if the walk has the
/// orientation of this triangle, else -1. On the boundary of a solid -1 and 1.
template <typename Scheme>
std::pair<typename Scheme::Id, double> SectorWalker<Scheme>::GetSign(
  Id vertex, const Walk& walk) const
{
  if (this->Solids.Count(walk.Faces.front()) > 0)
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
void SectorWalker<Scheme>::AppendSector(Id vertex, SectorPart<Id>& part) const
{
  Walk& walk = part.Walk;
  std::vector<Id>& around = walk.Ends;
  around.clear();
  for (Id edge : walk.Edges)
  {
    around.push_back(this->Complex.GetOtherEnd(edge, vertex));
  }
  const auto [face, sign] = this->GetSign(vertex, walk);
  part.Triangles.push_back(face);
  this->AppendSides(vertex, walk, part);
  const bool isKnown = walk.Edges.size() < FewEdges;
  const SectorTangents found =
    isKnown ? SectorTangents() : this->FindTangents(walk.Edges.size(), walk.IsClosed);
  const SectorTangents& tangents = isKnown ? this->Known[walk.IsClosed][walk.Edges.size()] : found;
  if (!this->IsPlain(vertex, walk))
  {
    this->AppendAfterStep(vertex, walk, tangents, sign, part);
    return;
  }
  auto append = [&part, sign = sign](Id column, const std::array<double, 2>& weights)
  {
    part.Columns.push_back(column);
    part.First.push_back(weights[0]);
    part.Second.push_back(sign * weights[1]);
  };
  const std::size_t size = around.size();
  for (std::size_t j = walk.IsClosed ? 0 : 1; j < (walk.IsClosed ? size : size - 1); ++j)
  {
    append(around[j], tangents.Edges[j]);
  }
  if (!walk.IsClosed)
  {
    append(around.front(), tangents.Edges.front());
    append(around.back(), tangents.Edges.back());
    append(vertex, tangents.Own);
  }
  part.Sizes.push_back(static_cast<Id>(walk.IsClosed ? size : size + 1));
}

/// Makes blends of rows next to creases that are still sharp.
template <typename Scheme>
void SectorWalker<Scheme>::BlendOwnRows(const SemiSharpStages<Id>& creases)
{
  const StoredRows<Id> smooth = GetStoredRows(this->Here);
  const subdivision::Strata<Id>& strata = creases.Stages.front().Strata;
  const StoredRows<Id> sharp{ strata.Vertices, strata.Edges, this->Complex.EdgeVertices,
    strata.VertexRings, strata.EdgeRings, GetSolidRows(this->Here) };
  const ExplicitRows<Id> ofSharp = MakeSectorRows(strata, this->Complex.EdgeVertices);
  const std::vector<SharpRow> rows = creases.ListParts(this->Complex).GetRows();
  std::vector<SharpRow> all = rows;
  AddSharpSectors(this->OwnRows.Rows, ofSharp.Rows, this->Complex.EdgeVertices,
    this->Complex.NumberOfVertices, all);
  std::set_difference(all.begin(), all.end(), rows.begin(), rows.end(),
    std::back_inserter(this->Blended),
    [](const SharpRow& a, const SharpRow& b) { return a.Row < b.Row; });
  this->OwnRows = BlendRows(
    this->Blended, this->OwnRows, [&](Id row, double factor, ExplicitRows<Id>& out)
    { AppendRow(smooth, this->OwnRows, row, factor, out); },
    [&](Id row, double factor, ExplicitRows<Id>& out)
    { AppendRow(sharp, ofSharp, row, factor, out); });
}

/// Whether the rules at the edges of a walk stay the same: no other end changes them.
template <typename Scheme>
bool SectorWalker<Scheme>::IsPlain(Id vertex, const Walk& walk) const
{
  if (this->Blended.empty() && this->Strata.Sectors.empty())
  {
    return true;
  }
  const auto isPlain = [&](Id edge)
  {
    const SharpRow row{ vtkIdType(this->Complex.NumberOfVertices) + edge, 0. };
    const auto sectors = FindSectorEdges(this->Strata.Sectors, edge);
    return !std::binary_search(this->Blended.begin(), this->Blended.end(), row,
             [](const SharpRow& a, const SharpRow& b) { return a.Row < b.Row; }) &&
      std::all_of(sectors.begin(), sectors.end(),
        [&](const SectorEdge<Id>& sector)
        {
          return !sector.IsShared &&
            this->Complex.EdgeVertices[2 * vtkIdType(edge) + sector.End] == vertex;
        });
  };
  return std::all_of(walk.Edges.begin(), walk.Edges.end(), isPlain);
}

/// Appends the tangents of the next level times the rows of the step to it.
template <typename Scheme>
void SectorWalker<Scheme>::AppendAfterStep(Id vertex, const Walk& walk,
  const SectorTangents& tangents, double sign, SectorPart<Id>& part) const
{
  const StoredRows<Id> stored = GetStoredRows(this->Here);
  ExplicitRows<Id> row;
  const std::size_t before = part.Columns.size();
  const auto append = [&](vtkIdType number, const std::array<double, 2>& weights)
  {
    row.Columns.clear();
    row.Weights.clear();
    AppendRow(stored, this->OwnRows, number, 1., row);
    for (std::size_t k = 0; k < row.Columns.size(); ++k)
    {
      part.Columns.push_back(row.Columns[k]);
      part.First.push_back(weights[0] * row.Weights[k]);
      part.Second.push_back(sign * weights[1] * row.Weights[k]);
    }
  };
  for (std::size_t j = 0; j < walk.Edges.size(); ++j)
  {
    append(vtkIdType(this->Complex.NumberOfVertices) + walk.Edges[j], tangents.Edges[j]);
  }
  append(vertex, tangents.Own);
  part.Sizes.push_back(static_cast<Id>(part.Columns.size() - before));
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
    [&](vtkIdType row)
    {
      const auto vertex = static_cast<Id>(row);
      const Row<Id> ring = level.Strata.VertexRings.GetCarriers(vertex);
      if (!missing[row] || isSharp[vertex] ||
        level.Strata.Vertices[vertex].GetRule() != Rule::Curve || ring.size() != 2)
      {
        return;
      }
      const Id* edges = ring.begin();
      const bool endsHere = complex.EdgeVertices[2 * vtkIdType(edges[0]) + 1] == vertex;
      along[2 * row] = complex.GetOtherEnd(edges[endsHere ? 0 : 1], vertex);
      along[2 * row + 1] = complex.GetOtherEnd(edges[endsHere ? 1 : 0], vertex);
    });
  return along;
}

}

SectorTangents FindSectorTangents(std::size_t size, bool isClosed, bool isModified)
{
  SectorTangents tangents;
  tangents.Edges.resize(size);
  if (isClosed)
  {
    for (std::size_t j = 0; j < size; ++j)
    {
      const double angle = 2. * Pi * static_cast<double>(j) / static_cast<double>(size);
      tangents.Edges[j] = { { std::cos(angle), std::sin(angle) } };
    }
    return tangents;
  }
  const double angle = Pi / static_cast<double>(size - 1);
  double sum = 0.;
  for (std::size_t j = 1; j + 1 < size; ++j)
  {
    const double weight = std::sin(angle * static_cast<double>(j));
    tangents.Edges[j] = { { 0., weight } };
    sum += weight;
  }
  // One triangle: the second difference.
  double end = size == 2 ? 1. : (std::sin(angle) - sum) / (1. + 2. * std::cos(angle));
  tangents.Own = { { 0., -2. * end - sum } };
  if (isModified && size > 2)
  {
    const TransversalMask mask = GetTransversalMask(static_cast<int>(size) - 1, false, true);
    end = mask.End;
    tangents.Own[1] = mask.Own;
  }
  tangents.Edges.front() = { { 1., end } };
  tangents.Edges.back() = { { -1., end } };
  return tangents;
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
  return BuildLimitTangents(
    level, creases, solids, FindShadingCells(level, solids.Steps), solids.Steps);
}

template <typename Level>
LimitTangents<typename Level::IdType> BuildLimitTangents(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases, const ControlSolids& solids,
  const ShadingCells<typename Level::IdType>& cells, int made)
{
  using Id = typename Level::IdType;
  const std::vector<bool> isSharp = FindSharpVertices(level, creases);
  const SectorWalker<SchemeOf<Level>> walker(level, creases, solids);
  const vtkIdType vertices = level.Complex.NumberOfVertices;
  LimitTangents<Id> tangents =
    CollectSectors<Id>(vertices, vertices, [&](vtkIdType v, SectorPart<Id>& part)
      { return isSharp[v] ? Id(0) : walker.Append(static_cast<Id>(v), part); });
  for (Id& face : tangents.Triangles)
  {
    face = face < 0 ? face : cells.Triangles[face];
  }
  const Buffer<unsigned char> missing = tangents.FindMissing();
  tangents.AlongCurves = FindCurves(level, isSharp, missing);
  Buffer<Id> rowsOf(vertices);
  ForEach(vertices, [&](vtkIdType v) { rowsOf[v] = missing[v] ? static_cast<Id>(v) : Id(-1); });
  tangents.Shading = BuildShadingStars(level, creases, solids, cells, rowsOf, made);
  return tangents;
}

#define SUBDIVISION_NORMALS(Scheme)                                                                \
  template FaceSides FindTriangleSides(const Scheme::Level&, const std::vector<char>&);            \
  template LimitTangents<Scheme::Id> BuildLimitTangents(                                           \
    const Scheme::Level&, const SemiSharpStages<Scheme::Id>&, const ControlSolids&);               \
  template LimitTangents<Scheme::Id> BuildLimitTangents(const Scheme::Level&,                      \
    const SemiSharpStages<Scheme::Id>&, const ControlSolids&, const ShadingCells<Scheme::Id>&,     \
    int)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_NORMALS);

}
