// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingParts.h
 * Lists the stars of ShadingStars.h from what lies at their vertices.
 */
#ifndef SubdivisionObjects_ShadingParts_h
#define SubdivisionObjects_ShadingParts_h

#include "Core/Operators/BlockOperator.h"
#include "Core/Solids/Limits/ShadingStars.h"

#include <array>
#include <utility>

namespace subdivision
{

/// What lies at a vertex: a corner of a face between two edges, or a line with one edge, or
/// nothing.
template <typename Id>
struct ShadingPart
{
  Id Vertex;
  Id Edges[2]; ///< by numbers that tell apart the edges at the vertex; -1: none
  Id Face;
};

template <typename Id>
class ShadingParts
{
public:
  using Part = ShadingPart<Id>;
  using Stars = ShadingStars<Id>;

  void Add(const Part& part) { this->Parts.push_back(part); }

  /// Makes the stars. getRow(vertex) is Star::Row, and setCorner(part, corner) sets the parent and
  /// the side of a corner.
  template <typename GetRow, typename SetCorner>
  void ListStars(vtkIdType vertices, const GetRow& getRow, const SetCorner& setCorner)
  {
    const Rows<vtkIdType> parts = ListByRow<vtkIdType>(
      vertices, static_cast<vtkIdType>(this->Parts.size()), [this](vtkIdType i)
      { return this->Parts[static_cast<std::size_t>(i)].Vertex; }, [](vtkIdType i) { return i; });
    for (const Id v : InTurn(static_cast<Id>(vertices)))
    {
      if (parts[v].size() > 0)
      {
        this->AddStar(v, getRow(v), parts[v], setCorner);
      }
    }
    this->Found.Stars.push_back(this->GetEnd());
  }
  Id GetVertex(vtkIdType star) const { return this->Vertices[static_cast<std::size_t>(star)]; }
  /// The edges of a star, in the order of its rows.
  const std::vector<Id>& GetEdges(vtkIdType star) const
  {
    return this->Edges[static_cast<std::size_t>(star)];
  }
  /// Pairs of these at the corners of a star, from 1 on.
  std::vector<std::array<int, 2>> GetCorners(vtkIdType star) const
  {
    std::vector<std::array<int, 2>> corners;
    const auto* own = this->Found.Stars.data() + star;
    for (vtkIdType i = own[0].FirstCorner; i < own[1].FirstCorner; ++i)
    {
      const Id* ends = this->Found.Corners[static_cast<std::size_t>(i)].Ends;
      corners.push_back({ { static_cast<int>(ends[0]) + 1, static_cast<int>(ends[1]) + 1 } });
    }
    return corners;
  }

  /// Makes the rows: getMaker() in each of several threads, whose result appends those of a star by
  /// maker(star, rows).
  template <typename GetMaker>
  Stars MakeRows(vtkIdType columns, const GetMaker& getMaker)
  {
    const std::vector<typename Stars::Star>& stars = this->Found.Stars;
    const auto append = [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
    {
      const auto maker = getMaker();
      RowBlock<Id> made;
      vtkIdType star = std::upper_bound(stars.begin(), stars.end(), begin,
                         [](vtkIdType row, const auto& other) { return row < other.FirstRow; }) -
        stars.begin() - 1;
      for (vtkIdType row = begin; row < end; ++star)
      {
        made.Clear();
        maker(star, made);
        for (; row < std::min(end, stars[star + 1].FirstRow); ++row)
        {
          const auto own = static_cast<std::size_t>(row - stars[star].FirstRow);
          for (std::size_t k = made.GetBegin(own); k < made.GetEnd(own); ++k)
          {
            rows.Add(made.GetColumns()[k], made.GetWeights()[k]);
          }
          rows.EndRow();
        }
      }
    };
    this->Found.Rows = BlockOperator<Id>(columns, this->NumberOfRows, append).Store();
    return std::move(this->Found);
  }

private:
  typename Stars::Star GetEnd() const
  {
    typename Stars::Star end;
    end.FirstRow = this->NumberOfRows;
    end.FirstCorner = static_cast<vtkIdType>(this->Found.Corners.size());
    end.FirstLine = static_cast<vtkIdType>(this->Found.Lines.size());
    return end;
  }
  template <typename SetCorner>
  void AddStar(Id vertex, Id row, const Row<vtkIdType>& parts, const SetCorner& setCorner)
  {
    typename Stars::Star star = this->GetEnd();
    star.Row = row;
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
      const Part& part = this->Parts[static_cast<std::size_t>(i)];
      if (part.Face >= 0)
      {
        const Id first = number(part.Edges[0]);
        this->Found.Corners.push_back({ { first, number(part.Edges[1]) }, Id(-1), -1 });
        setCorner(part, this->Found.Corners.back());
      }
      else if (part.Edges[0] >= 0 && star.FirstCorner == this->GetEnd().FirstCorner)
      {
        this->Found.Lines.push_back(number(part.Edges[0]));
      }
    }
    this->NumberOfRows += static_cast<vtkIdType>(edges.size());
    this->Vertices.push_back(vertex);
    this->Edges.push_back(std::move(edges));
    this->Found.Stars.push_back(star);
  }

  std::vector<Part> Parts;
  Stars Found;
  vtkIdType NumberOfRows = 0;
  std::vector<Id> Vertices;           ///< of each star
  std::vector<std::vector<Id>> Edges; ///< of each star
};

}

#endif
