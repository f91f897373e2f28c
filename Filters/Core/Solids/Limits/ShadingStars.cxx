// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/ShadingStars.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/Limits/LevelStar.h"
#include "Core/Solids/Limits/SolidsAtFaces.h"

#include <array>
#include <utility>

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

/// What lies at a vertex: a corner of a triangle with two edges and their solid, or a line with one
/// edge, or nothing.
template <typename Id>
struct ShadingPart
{
  Id Vertex;
  Id Edges[2];
  Id Face;
};

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
    const Rows<vtkIdType> parts = ListByRow<vtkIdType>(
      this->Complex.NumberOfVertices, static_cast<vtkIdType>(this->Parts.size()),
      [this](vtkIdType i) { return this->Parts[i].Vertex; }, [](vtkIdType i) { return i; });
    std::vector<Id> vertices;
    for (const Id v : InTurn(static_cast<Id>(this->Complex.NumberOfVertices)))
    {
      if (parts[v].size() > 0)
      {
        vertices.push_back(v);
        this->AddStar(v, parts[v]);
      }
    }
    this->Found.Stars.push_back(this->GetEnd());
    this->MakeRows(vertices, made);
    return std::move(this->Found);
  }

private:
  using Stars = ShadingStars<Id>;

  void Collect();
  void AddStar(Id vertex, const Row<vtkIdType>& parts);
  vtkIdType GetSide(const Part& part) const;
  typename Stars::Star GetEnd() const
  {
    typename Stars::Star end;
    end.FirstRow = this->NumberOfRows;
    end.FirstCorner = static_cast<vtkIdType>(this->Found.Corners.size());
    end.FirstLine = static_cast<vtkIdType>(this->Found.Lines.size());
    return end;
  }
  void MakeRows(const std::vector<Id>& vertices, int made);
  std::vector<LimitRow<Id>> MakeStar(
    LimitRowMaker<LevelStar<Scheme>>& maker, vtkIdType star, Id vertex, int made) const;
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
  std::vector<Part> Parts;
  Stars Found;
  vtkIdType NumberOfRows = 0;
  std::vector<std::vector<Id>> Edges; ///< of each star; its rows in this order
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
        this->Parts.push_back(
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
        this->Parts.push_back({ vertex, { static_cast<Id>(e), Id(-1) }, Id(-1) });
      }
    }
  }
  for (const Id vertex : InTurn(this->Cells.Points))
  {
    if (isMissing(vertex))
    {
      this->Parts.push_back({ vertex, { Id(-1), Id(-1) }, Id(-1) });
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

/// Adds a star whose rows are not made yet: corners and lines name edges by their order.
template <typename Scheme>
void ShadingBuilder<Scheme>::AddStar(Id vertex, const Row<vtkIdType>& parts)
{
  Stars& found = this->Found;
  typename Stars::Star star = this->GetEnd();
  star.Row = this->RowsOf[vertex];
  std::vector<Id> edges;
  const auto number = [&edges](Id edge)
  {
    const auto at = std::find(edges.begin(), edges.end(), edge);
    const auto place = static_cast<Id>(at - edges.begin());
    at == edges.end() ? edges.push_back(edge) : void();
    return place;
  };
  for (const vtkIdType i : parts)
  {
    const Part& part = this->Parts[i];
    if (part.Face >= 0)
    {
      const auto face = static_cast<std::size_t>(part.Face);
      const vtkIdType side = this->GetSide(part);
      const Id first = number(part.Edges[0]);
      found.Corners.push_back({ { first, number(part.Edges[1]) },
        side < 0 && face < this->Cells.Triangles.size() ? this->Cells.Triangles[face] : Id(-1),
        side });
    }
    else if (part.Edges[0] >= 0 && star.FirstCorner == this->GetEnd().FirstCorner)
    {
      found.Lines.push_back(number(part.Edges[0]));
    }
  }
  this->NumberOfRows += static_cast<vtkIdType>(edges.size());
  this->Edges.push_back(std::move(edges));
  found.Stars.push_back(star);
}

/// The rows of a star. Where a curve goes through and no triangle is, they are those of the level:
/// their chord is that of the limit.
template <typename Scheme>
std::vector<LimitRow<typename Scheme::Id>> ShadingBuilder<Scheme>::MakeStar(
  LimitRowMaker<LevelStar<Scheme>>& maker, vtkIdType star, Id vertex, int made) const
{
  const std::vector<Id>& edges = this->Edges[star];
  const auto& own = this->Found.Stars[star];
  const vtkIdType end = this->Found.Stars[star + 1].FirstCorner;
  std::vector<std::array<int, 2>> corners;
  for (vtkIdType i = own.FirstCorner; i < end; ++i)
  {
    const Id* ends = this->Found.Corners[i].Ends;
    corners.push_back({ { static_cast<int>(ends[0]) + 1, static_cast<int>(ends[1]) + 1 } });
  }
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

template <typename Scheme>
void ShadingBuilder<Scheme>::MakeRows(const std::vector<Id>& vertices, int made)
{
  const std::vector<typename Stars::Star>& stars = this->Found.Stars;
  const auto append = [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
  {
    LimitRowMaker<LevelStar<Scheme>> maker(this->Here, this->Creases, this->Sharp);
    vtkIdType star = std::upper_bound(stars.begin(), stars.end(), begin,
                       [](vtkIdType row, const auto& other) { return row < other.FirstRow; }) -
      stars.begin() - 1;
    for (vtkIdType row = begin; row < end; ++star)
    {
      const std::vector<LimitRow<Id>> own = this->MakeStar(maker, star, vertices[star], made);
      for (; row < std::min(end, stars[star + 1].FirstRow); ++row)
      {
        const LimitRow<Id>& found = own[row - stars[star].FirstRow];
        for (std::size_t k = 0; k < found.Columns.size(); ++k)
        {
          rows.Add(found.Columns[k], found.Weights[k]);
        }
        rows.EndRow();
      }
    }
  };
  this->Found.Rows =
    BlockOperator<Id>(this->Complex.NumberOfVertices, this->NumberOfRows, append).Store();
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
