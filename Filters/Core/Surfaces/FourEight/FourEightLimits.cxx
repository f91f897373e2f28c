// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/FourEight/FourEightMasks.h"
#include "Core/Surfaces/FourEight/FourEightStar.h"
#include "Core/Surfaces/FourEight/FourEightTopology.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/CurveTangents.h"
#include "Core/Surfaces/Scheme/SurfacePatch.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace subdivision
{
namespace
{

/// The entries of one row: columns and weights.
template <typename Id>
using Entries = std::vector<std::pair<Id, double>>;

/// A vertex whose limit is wanted, on some level.
template <typename Id>
struct WantedLimit
{
  Id Vertex;
  Id Corner;        ///< at the vertex, inside or in the sector of the tangent
  double Turn = 1.; ///< -1: the face of that corner has another orientation than on the first level
  std::size_t Owner; ///< the number of the row that is made
};

template <typename Id>
class FourEightLimits
{
public:
  FourEightLimits(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
    bool modifiedBoundary, LimitKind kind)
    : Scheme(scheme)
    , Level(level)
    , ModifiedBoundary(modifiedBoundary)
    , Kind(kind)
  {
  }

  void Append(vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
  {
    this->CollectRows(begin, end);
    for (const Entries<Id>& entries : this->Rows)
    {
      for (const auto& [column, weight] : entries)
      {
        rows.Add(column, weight);
      }
      rows.EndRow();
    }
  }

private:
  using Wanted = WantedLimit<Id>;

  void CollectRows(vtkIdType begin, vtkIdType end)
  {
    this->Rows.assign(static_cast<std::size_t>(end - begin), {});
    std::vector<Wanted> irregular;
    for (vtkIdType v = begin; v < end; ++v)
    {
      const Id vertex = static_cast<Id>(v);
      const auto owner = static_cast<std::size_t>(v - begin);
      if (this->Level.Tags.Vertices[v] == VertexTag::Smooth)
      {
        this->Want({ vertex, this->Level.Mesh.VertexCorners[v], 1., owner }, irregular);
      }
      else
      {
        this->CollectOnCurve(vertex, owner, irregular);
      }
    }
    for (std::size_t first = 0; first < irregular.size();)
    {
      const std::size_t next = std::min(first + this->AtATime, irregular.size());
      this->Descend({ irregular.begin() + static_cast<std::ptrdiff_t>(first),
        irregular.begin() + static_cast<std::ptrdiff_t>(next) });
      first = next;
    }
  }

  /// Makes the row of a vertex, or adds it to the irregular ones.
  void Want(const Wanted& wanted, std::vector<Wanted>& irregular)
  {
    if (!this->Find(this->Level, wanted, this->Rows[wanted.Owner]))
    {
      irregular.push_back(wanted);
    }
  }

  void CollectOnCurve(Id vertex, std::size_t owner, std::vector<Wanted>& irregular)
  {
    const PolygonMesh<Id>& mesh = this->Level.Mesh;
    RowBlock<Id> row;
    if (this->Kind == LimitKind::Position)
    {
      AppendCurveVertex(mesh, this->Level.Tags, vertex, 2. / 3., this->Ring, row);
    }
    else
    {
      AppendSectorTangent(this->Level, this->Level.Tags, vertex, this->Kind, this->Ring, row,
        [&](const SectorEnds<Id>& ends, double turn)
        {
          if (ends.Size - this->Level.Step % 2 == 1) // the sector of one face
          {
            row.Add(vertex, -2. * turn);
            row.Add(this->Ring.front(), turn);
            row.Add(this->Ring.back(), turn);
            return;
          }
          this->Want({ vertex, ends.First.Corner, turn, owner }, irregular);
        });
    }
    for (std::size_t i = 0; i < row.GetNumberOfEntries(); ++i)
    {
      this->Rows[owner].emplace_back(row.GetColumns()[i], row.GetWeights()[i]);
    }
  }

  // ----------------------------------------------------------------------------------------------
  // Where all is regular

  /// Finds the entries of a row on a level. False: the vertex is not regular there.
  bool Find(const SurfaceLevel<Id>& level, const Wanted& wanted, Entries<Id>& entries)
  {
    if (level.Tags.Vertices[wanted.Vertex] != VertexTag::Smooth)
    {
      if (!this->Star.FindBeside(level, FindSectorEnds(level.Mesh, level.Tags, wanted.Corner)))
      {
        return false;
      }
      this->FindAcross(wanted, entries);
    }
    else
    {
      if (!this->Star.FindAround(level, wanted.Corner, this->ModifiedBoundary))
      {
        return false;
      }
      this->Kind == LimitKind::Position ? this->FindPosition(wanted.Vertex, entries)
                                        : this->FindTangent(wanted, entries);
    }
    return true;
  }

  void FindPosition(Id vertex, Entries<Id>& entries) const
  {
    using Totals = FourEightTotals;
    const double k = static_cast<double>(this->Star.Wedges.size());
    entries.emplace_back(vertex, Totals::Own);
    for (const auto& wedge : this->Star.Wedges)
    {
      entries.emplace_back(wedge.Ends[0], Totals::Edges / k);
      entries.emplace_back(wedge.Opposite, Totals::Faces / k);
      entries.emplace_back(wedge.Ahead[0], Totals::Ahead / k);
      entries.emplace_back(wedge.Knights[0], Totals::Knights / (2. * k));
      entries.emplace_back(wedge.Knights[1], Totals::Knights / (2. * k));
    }
  }

  /// `wave(j)`: the cosine or sine of the direction of edge j, and of the face after it at j + 0.5.
  template <typename Function>
  void AddWave(const FourEightWave& mask, double factor, bool isAround, const Function& wave,
    Entries<Id>& entries) const
  {
    const std::size_t k = this->Star.Wedges.size();
    for (std::size_t j = 0; j < k; ++j)
    {
      const auto& wedge = this->Star.Wedges[j];
      const double edge = static_cast<double>(j);
      const double face = edge + 0.5;
      if (isAround || j > 0) // on the curve other weights follow
      {
        entries.emplace_back(wedge.Ends[0], factor * mask.Edge * wave(edge));
        entries.emplace_back(wedge.Ahead[0], factor * mask.Ahead * wave(edge));
      }
      entries.emplace_back(wedge.Opposite, factor * mask.Face * wave(face));
      for (int end = 0; end < 2; ++end)
      {
        entries.emplace_back(wedge.Knights[end],
          factor * (mask.KnightOfEdge * wave(edge + end) + mask.KnightOfFace * wave(face)));
      }
    }
  }

  /// A step turns the directions by half a face, which does not change the plane of both tangents.
  void FindTangent(const Wanted& wanted, Entries<Id>& entries)
  {
    const std::size_t k = this->Star.Wedges.size();
    if (k < 2)
    {
      return; // no plane
    }
    const double angle = 2. * Pi / static_cast<double>(k);
    std::unique_ptr<FourEightWave>& known = Recall(this->Waves, k);
    if (!known)
    {
      known = std::make_unique<FourEightWave>(angle);
    }
    const FourEightWave& mask = *known;
    const bool isFirst = this->Kind == LimitKind::Tangent1;
    this->AddWave(
      mask, this->Scale(mask) * (isFirst ? 1. : wanted.Turn), true,
      [=](double j) { return isFirst ? std::cos(j * angle) : std::sin(j * angle); }, entries);
  }

  void FindAcross(const Wanted& wanted, Entries<Id>& entries)
  {
    const std::size_t k = this->Star.Wedges.size();
    const double angle = Pi / static_cast<double>(k);
    std::unique_ptr<FourEightCurveMask>& known = Recall(this->CurveMasks, k);
    if (!known)
    {
      known =
        std::make_unique<FourEightCurveMask>(static_cast<int>(k), this->ModifiedBoundary && k != 2);
    }
    const FourEightCurveMask& mask = *known;
    const double factor = this->Scale(mask.Inside) * wanted.Turn;
    entries.emplace_back(wanted.Vertex, factor * mask.Own);
    for (int end = 0; end < 2; ++end)
    {
      const auto& wedge = end == 0 ? this->Star.Wedges.front() : this->Star.Wedges.back();
      entries.emplace_back(wedge.Ends[end], factor * mask.End);
      entries.emplace_back(wedge.Ahead[end], factor * mask.Beyond);
    }
    this->AddWave(
      mask.Inside, factor, false, [=](double j) { return std::sin(j * angle); }, entries);
  }

  /// The part of a tangent that was lost in the steps to the present level.
  double Scale(const FourEightWave& mask) const
  {
    return std::pow(mask.Value, -static_cast<double>(this->Patches.size()));
  }

  template <typename Mask>
  static std::unique_ptr<Mask>& Recall(std::vector<std::unique_ptr<Mask>>& known, std::size_t k)
  {
    known.resize(std::max(known.size(), k + 1));
    return known[k];
  }

  // ----------------------------------------------------------------------------------------------
  // Elsewhere

  void Descend(std::vector<Wanted> wanted)
  {
    constexpr int most = 8; // five are enough
    // No loop over a patch is worth threads, of which this is one already. A step doubles corners.
    constexpr vtkIdType mostCorners = WorthThreads / 3;
    constexpr std::size_t few = 4; // of a patch that is larger, they share most
    SurfaceLevel<Id> next;
    for (int step = 0; step < most && !wanted.empty(); ++step)
    {
      const SurfaceLevel<Id>& whole = step == 0 ? this->Level : next;
      this->Patches.push_back(this->Crop(whole, wanted));
      const SurfaceLevel<Id>& level = this->Patches.back()->Level;
      const std::size_t fitting = static_cast<std::size_t>(mostCorners) * wanted.size() /
        static_cast<std::size_t>(level.Mesh.GetNumberOfCorners());
      this->AtATime = fitting >= few ? fitting : std::numeric_limits<std::size_t>::max() / 2;
      next = this->Scheme.Refine(level, Depth::ForRefinement);
      for (Wanted& each : wanted)
      {
        Advance(level, next, each);
      }
      std::vector<Wanted> rest;
      for (const Wanted& each : wanted)
      {
        Entries<Id> entries;
        if (this->Find(next, each, entries))
        {
          this->PullBack(entries);
          this->Rows[each.Owner] = std::move(entries);
        }
        else
        {
          rest.push_back(each);
        }
      }
      wanted = std::move(rest);
    }
    this->Patches.clear();
  }

  /// The patch around the wanted vertices, which are renumbered.
  std::unique_ptr<SurfacePatch<Id>> Crop(
    const SurfaceLevel<Id>& whole, std::vector<Wanted>& wanted) const
  {
    std::vector<Id> vertices;
    for (const Wanted& each : wanted)
    {
      vertices.push_back(each.Vertex);
    }
    this->AddCurves(whole, vertices);
    SortUnique(vertices);
    auto patch = std::make_unique<SurfacePatch<Id>>(whole, vertices);
    for (Wanted& each : wanted)
    {
      each.Vertex = SurfacePatch<Id>::Find(patch->Vertices, each.Vertex);
      each.Corner = patch->FindCorner(whole.Mesh, each.Corner);
    }
    this->Scheme.CloseRim(whole, *patch);
    this->Scheme.Prepare(patch->Level);
    return patch;
  }

  /// Adds the vertices on curves whose sectors make rows of faces beyond faces of the given ones.
  void AddCurves(const SurfaceLevel<Id>& level, std::vector<Id>& vertices) const
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    if (!this->ModifiedBoundary)
    {
      return;
    }
    std::vector<Id> near = vertices;
    std::vector<Id> beyond;
    const auto appendAround = [&mesh](Id vertex, std::vector<Id>& to)
    { VisitFaces(mesh, vertex, [&](Id face) { AppendOfFace(mesh, mesh.Vertices, face, to); }); };
    for (const Id vertex : vertices)
    {
      appendAround(vertex, near);
    }
    SortUnique(near);
    for (const Id vertex : near)
    {
      appendAround(vertex, beyond);
    }
    std::copy_if(beyond.begin(), beyond.end(), std::back_inserter(vertices),
      [&level](Id v) { return FourEightStar<Id>::MovesCentres(level, v); });
  }

  /// Moves a corner to the next level, into the same fan or sector.
  static void Advance(const SurfaceLevel<Id>& level, const SurfaceLevel<Id>& next, Wanted& wanted)
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const FourEightTopology<Id> topology(level);
    const Id twin = mesh.Twins[wanted.Corner];
    const bool isOfTwin = twin >= 0 && twin < wanted.Corner; // the child across the edge
    if (level.Tags.Vertices[wanted.Vertex] == VertexTag::Smooth && isOfTwin &&
      mesh.Vertices[twin] == mesh.Vertices[wanted.Corner])
    {
      wanted.Turn = -wanted.Turn;
    }
    wanted.Corner = GetCornerAt(next.Mesh, topology.GetHalfEdgeAt(wanted.Corner), wanted.Vertex);
  }

  /// Takes the entries of a row from the level after the last patch to the first level. Columns
  /// keep the order in which walks around vertices find them, so that no sum depends on how
  /// vertices are numbered.
  void PullBack(Entries<Id>& entries)
  {
    for (auto patch = this->Patches.rbegin(); patch != this->Patches.rend(); ++patch)
    {
      const SurfaceLevel<Id>& level = (*patch)->Level;
      Entries<Id> before;
      this->Found.resize(static_cast<std::size_t>(level.Mesh.NumberOfVertices), -1);
      for (const auto& [row, weight] : entries)
      {
        this->Step.Clear();
        this->Scheme.AppendRows(level, level.Tags, row, row + 1, this->Step);
        for (std::size_t i = 0; i < this->Step.GetNumberOfEntries(); ++i)
        {
          const Id column = this->Step.GetColumns()[i];
          if (this->Found[column] < 0)
          {
            this->Found[column] = static_cast<Id>(before.size());
            before.emplace_back(column, 0.);
          }
          before[this->Found[column]].second += weight * this->Step.GetWeights()[i];
        }
      }
      for (auto& [column, weight] : before)
      {
        this->Found[column] = -1;
        column = (*patch)->Vertices[column];
      }
      entries = std::move(before);
    }
  }

  const SurfaceScheme<Id>& Scheme;
  const SurfaceLevel<Id>& Level;
  const bool ModifiedBoundary;
  const LimitKind Kind;
  std::vector<Entries<Id>> Rows; ///< that are made
  FourEightStar<Id> Star;
  std::vector<std::unique_ptr<SurfacePatch<Id>>> Patches; ///< of all levels but the present one
  std::vector<std::unique_ptr<FourEightWave>> Waves;      ///< by number of faces
  std::vector<std::unique_ptr<FourEightCurveMask>> CurveMasks;
  std::size_t AtATime = 8; ///< how many vertices share a patch, by the size of the one before
  std::vector<Id> Ring;
  std::vector<Id> Found; ///< of each column the number of its entry, -1: none
  RowBlock<Id> Step;
};

}

template <typename Id>
void AppendFourEightLimits(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  bool modifiedBoundary, LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  FourEightLimits<Id>(scheme, level, modifiedBoundary, kind).Append(begin, end, rows);
}

SUBDIVISION_COMPILE_FUNCTION(AppendFourEightLimits);

}
