// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/ShadingStars.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/Limits/LevelStar.h"
#include "Core/Solids/Limits/ShadingParts.h"
#include "Core/Solids/Limits/SolidsAtFaces.h"

namespace subdivision
{

template <typename Level>
ShadingCells<typename Level::IdType> FindShadingCells(const Level& level, int steps)
{
  using Id = typename Level::IdType;
  ShadingCells<Id> cells;
  for (const Id f : InTurn(level.Complex.NumberOfTriangleCells))
  {
    cells.Triangles.push_back(static_cast<Id>(f >> 2 * steps));
  }
  cells.Lines.assign(static_cast<std::size_t>(level.Complex.NumberOfLineCells), 1);
  cells.Points.assign(level.Complex.VertexCells.begin(), level.Complex.VertexCells.end());
  return cells;
}

namespace
{

template <typename Scheme>
class ShadingBuilder
{
public:
  using Id = typename Scheme::Id;
  using Part = ShadingPart<Id>;

  ShadingBuilder(const typename Scheme::Level& level, const SemiSharpStages<Id>& creases,
    const ControlSolids& solids, const ShadingCells<Id>& cells, const Buffer<Id>& rows)
    : Here(level)
    , Complex(level.Complex)
    , Creases(creases)
    , Sharp(creases.ListParts(level.Complex))
    , Solids(level, solids)
    , Cells(cells)
    , RowsOf(rows)
  {
  }

  ShadingStars<Id> Build(int made)
  {
    this->Collect();
    this->Parts.ListStars(
      this->Complex.NumberOfVertices, [this](Id vertex) { return this->RowsOf[vertex]; },
      [this](const Part& part, typename ShadingStars<Id>::Corner& corner)
      {
        const auto face = static_cast<std::size_t>(part.Face);
        corner.Side = this->GetSide(part);
        corner.Parent = corner.Side < 0 && face < this->Cells.Triangles.size()
          ? this->Cells.Triangles[face]
          : Id(-1);
      });
    using Maker = LimitRowMaker<LevelStar<Scheme>>;
    return this->Parts.MakeRows(this->Complex.NumberOfVertices,
      [&]
      {
        auto maker = std::make_shared<Maker>(this->Here, this->Creases, this->Sharp);
        return [this, maker, made](vtkIdType star, RowBlock<Id>& rows)
        {
          for (const LimitRow<Id>& row : this->MakeStar(*maker, star, made))
          {
            for (std::size_t k = 0; k < row.Columns.size(); ++k)
            {
              rows.Add(row.Columns[k], row.Weights[k]);
            }
            rows.EndRow();
          }
        };
      });
  }

private:
  void Collect();
  vtkIdType GetSide(const Part& part) const;
  std::vector<LimitRow<Id>> MakeStar(
    LimitRowMaker<LevelStar<Scheme>>& maker, vtkIdType star, int made) const;
  Id GetFarEnd(const Part& part, int side) const
  {
    return this->Complex.GetOtherEnd(part.Edges[side], part.Vertex);
  }

  const typename Scheme::Level& Here;
  const SimplicialComplex<Id>& Complex;
  const SemiSharpStages<Id>& Creases;
  const SharpParts Sharp;
  const SolidsAtFaces<Scheme> Solids;
  const ShadingCells<Id>& Cells;
  const Buffer<Id>& RowsOf;
  ShadingParts<Id> Parts; ///< their edges are those of the level
};

template <typename Scheme>
void ShadingBuilder<Scheme>::Collect()
{
  const auto isMissing = [this](Id vertex) { return this->RowsOf[vertex] >= 0; };
  for (const Id f : InTurn(static_cast<Id>(this->Complex.NumberOfFaces)))
  {
    const auto face = static_cast<std::size_t>(f);
    const bool isCell = face < this->Cells.Triangles.size() && this->Cells.Triangles[face] >= 0;
    const Id* corners = this->Complex.FaceVertices.data() + 3 * vtkIdType(f);
    const Id* edges = this->Complex.FaceEdges.data() + 3 * vtkIdType(f);
    for (int k = 0; k < 3 && (isCell || this->Solids.Count(f) < 2); ++k)
    {
      if (isMissing(corners[k]))
      {
        const int* local = triangle::EdgesAt[k];
        const Id next = corners[(k + 1) % 3];
        const bool isFirst = this->Complex.GetOtherEnd(edges[local[0]], corners[k]) == next;
        this->Parts.Add(
          { corners[k], { edges[local[isFirst ? 0 : 1]], edges[local[isFirst ? 1 : 0]] }, f });
      }
    }
  }
  for (const std::size_t e : InTurn(this->Cells.Lines.size()))
  {
    for (int end = 0; end < 2 && this->Cells.Lines[e]; ++end)
    {
      const Id vertex = this->Complex.EdgeVertices[2 * e + end];
      if (isMissing(vertex))
      {
        this->Parts.Add({ vertex, { static_cast<Id>(e), Id(-1) }, Id(-1) });
      }
    }
  }
  for (const Id vertex : InTurn(this->Cells.Points))
  {
    if (isMissing(vertex))
    {
      this->Parts.Add({ vertex, { Id(-1), Id(-1) }, Id(-1) });
    }
  }
}

template <typename Scheme>
vtkIdType ShadingBuilder<Scheme>::GetSide(const Part& part) const
{
  vtkIdType side = -1;
  if (this->Solids.Count(part.Face) == 1)
  {
    this->Solids.ForSides(part.Face,
      { part.Vertex, this->GetFarEnd(part, 0), this->GetFarEnd(part, 1) },
      [&side](vtkIdType found) { side = found; });
  }
  return side;
}

/// The rows of a star. Where a curve goes through and no triangle is, they are those of the level:
/// their chord is that of the limit.
template <typename Scheme>
std::vector<LimitRow<typename Scheme::Id>> ShadingBuilder<Scheme>::MakeStar(
  LimitRowMaker<LevelStar<Scheme>>& maker, vtkIdType star, int made) const
{
  const Id vertex = this->Parts.GetVertex(star);
  const std::vector<Id>& edges = this->Parts.GetEdges(star);
  const std::vector<std::array<int, 2>> corners = this->Parts.GetCorners(star);
  const bool isCurve = corners.empty() && edges.size() == 2 &&
    this->Here.Strata.Vertices[vertex].GetRule() == Rule::Curve &&
    this->Sharp.GetMostSharpness(vertex) <= 0.;
  if (!Scheme::Traits.HasTangents || isCurve || edges.size() > MostEdgesOfStars)
  {
    std::vector<LimitRow<Id>> rows;
    for (const Id edge : edges)
    {
      rows.push_back({ { vertex, this->Complex.GetOtherEnd(edge, vertex) }, { -1., 1. } });
    }
    return rows;
  }
  return maker.MakeStar(vertex, edges, corners, made);
}

}

template <typename Id>
void ShadingStars<Id>::Fill(const double* points, const std::vector<vtkIdType>& inverted,
  const Buffer<unsigned char>& turned, double* normals) const
{
  Buffer<double> ends(3 * this->Rows.GetNumberOfRows());
  this->Rows.Apply(points, ends.data(), 3);
  ForRanges(std::max(vtkIdType(1), static_cast<vtkIdType>(this->Stars.size())) - 1,
    [&](vtkIdType begin, vtkIdType last)
    {
      ShadingStar around;
      for (vtkIdType s = begin; s < last; ++s)
      {
        const Star& star = this->Stars[s];
        const auto getEnd = [&](Id row) { return ends.data() + 3 * (star.FirstRow + row); };
        around.Clear();
        for (vtkIdType i = star.FirstCorner; i < this->Stars[s + 1].FirstCorner; ++i)
        {
          const Corner& corner = this->Corners[i];
          const bool isTurned = corner.Side >= 0
            ? !IsOutwards(corner.Side, inverted)
            : corner.Parent >= 0 && !turned.empty() && turned[corner.Parent] != 0;
          const double* a = getEnd(corner.Ends[0]);
          const double* b = getEnd(corner.Ends[1]);
          const double middle[3] = { (a[0] + b[0]) / 3., (a[1] + b[1]) / 3., (a[2] + b[2]) / 3. };
          around.AddCorner(a, b, middle, isTurned ? -1. : 1.);
        }
        for (vtkIdType i = star.FirstLine; i < this->Stars[s + 1].FirstLine; ++i)
        {
          around.AddLine(getEnd(this->Lines[i]));
        }
        around.FindNormal(normals + 3 * star.Row);
      }
    });
}

template <typename Level>
ShadingStars<typename Level::IdType> BuildShadingStars(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases, const ControlSolids& solids,
  const ShadingCells<typename Level::IdType>& cells, const Buffer<typename Level::IdType>& rows,
  int made)
{
  return ShadingBuilder<SchemeOf<Level>>(level, creases, solids, cells, rows).Build(made);
}

SUBDIVISION_COMPILE(struct ShadingStars);

#define SUBDIVISION_STARS(Scheme)                                                                  \
  template ShadingCells<Scheme::Id> FindShadingCells(const Scheme::Level&, int);                   \
  template ShadingStars<Scheme::Id> BuildShadingStars(const Scheme::Level&,                        \
    const SemiSharpStages<Scheme::Id>&, const ControlSolids&, const ShadingCells<Scheme::Id>&,     \
    const Buffer<Scheme::Id>&, int)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_STARS);

}
