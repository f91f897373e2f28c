// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildTuples.h
 * The edges and faces of the children of a complex as sets of vertices, each of which comes once:
 * for it lies in one edge, face or solid of the complex.
 */
#ifndef SubdivisionObjects_ChildTuples_h
#define SubdivisionObjects_ChildTuples_h

#include "Core/Cells/CellComplex.h"
#include "Core/Memory/TupleIndex.h"

#include <algorithm>
#include <array>
#include <vector>

namespace subdivision
{

inline bool HasCorners(const std::vector<unsigned char>& face, int count)
{
  return static_cast<int>(face.size()) == count;
}

/// act(place, tuple) for the edges or the faces of N corners of a cell, with their place among all
/// of them.
template <int N, typename Id, typename Act>
void ForTuples(const CellList<Id>& cells, vtkIdType cell, const Act& act)
{
  const CellTable& table = cells.GetTable(cell);
  const Id* corners = cells.GetCorners(cell);
  const auto give = [&](vtkIdType place, const auto& item)
  {
    Id vertices[N];
    std::transform(item.begin(), item.end(), vertices, [&](int k) { return corners[k]; });
    act(place, SortedTuple<N>(vertices));
  };
  vtkIdType place = 0;
  if constexpr (N == 2)
  {
    for (const auto& edge : table.Edges)
    {
      give(place++, edge);
    }
  }
  else
  {
    for (const auto& face : table.Faces)
    {
      HasCorners(face, N) ? give(place, face) : void();
      ++place;
    }
  }
}

/// The edges or faces of N corners of children, as local points of the cell that they lie inside.
template <int N>
std::vector<std::array<unsigned char, N>> ListInside(CellShape shape)
{
  const CellTable& table = GetCellTable(shape);
  const auto inside = table.Dimension == 3 ? CellPart::Inside
    : table.Dimension == 2                 ? CellPart::InFace
                                           : CellPart::InEdge;
  std::vector<std::array<unsigned char, N>> all;
  for (const CellChild& child : table.Children)
  {
    const auto add = [&](const auto& item, const CellPart& part)
    {
      std::array<unsigned char, N> points;
      std::transform(
        item.begin(), item.end(), points.begin(), [&](int k) { return child.Points[k]; });
      std::sort(points.begin(), points.end());
      if (part.Kind == inside && std::find(all.begin(), all.end(), points) == all.end())
      {
        all.push_back(points);
      }
    };
    const CellTable& made = GetCellTable(child.Shape);
    for (std::size_t i = 0; N == 2 && i < made.Edges.size(); ++i)
    {
      add(made.Edges[i], child.Edges[i]);
    }
    for (std::size_t i = 0; N > 2 && i < made.Faces.size(); ++i)
    {
      HasCorners(made.Faces[i], N) ? add(made.Faces[i], child.Faces[i]) : void();
    }
  }
  return all;
}

/// The edges or the faces of N corners of all children of a complex, each once, in lexicographic
/// order.
template <int N, typename Id>
class ChildTuples
{
public:
  using Tail = std::array<Id, N - 1>;

  explicit ChildTuples(const CellComplex<Id>& parents)
  {
    const Buffer<std::array<Id, N>> all = this->List(parents);
    Rows<Id> groups = ListByRow<Id>(
      parents.GetNumberOfNewPoints(), all.size(), [&](vtkIdType i) { return all[i][0]; },
      [](vtkIdType i) { return static_cast<Id>(i); });
    this->Tails = Buffer<Tail>(all.size());
    ForEach(parents.GetNumberOfNewPoints(),
      [&](vtkIdType v)
      {
        Tail* begin = this->Tails.data() + groups.Offsets[v];
        Tail* end = begin;
        for (const Id i : groups[v])
        {
          std::copy(all[i].begin() + 1, all[i].end(), (end++)->begin());
        }
        std::sort(begin, end);
      });
    this->Offsets = std::move(groups.Offsets);
  }

  vtkIdType GetSize() const { return this->Tails.size(); }
  Id Find(const std::array<Id, N>& tuple) const
  {
    const auto isOther = [&](const Tail& tail)
    {
      bool is = false; // most differ in the last one
      for (int k = N - 1; k > 0; --k)
      {
        is = is || tail[static_cast<std::size_t>(k - 1)] != tuple[static_cast<std::size_t>(k)];
      }
      return is;
    };
    Id number = this->Offsets[tuple[0]];
    while (isOther(this->Tails[number]))
    {
      ++number;
    }
    return number;
  }
  /// act(number, smallest vertex, others)
  template <typename Act>
  void ForAll(const Act& act) const
  {
    ForEach(this->Offsets.size() - 1,
      [&](vtkIdType v)
      {
        for (Id number = this->Offsets[v]; number < this->Offsets[v + 1]; ++number)
        {
          act(number, static_cast<Id>(v), this->Tails[number]);
        }
      });
  }

private:
  using Points = std::vector<std::array<unsigned char, N>>;

  static Buffer<std::array<Id, N>> List(const CellComplex<Id>& parents)
  {
    std::array<Points, NumberOfShapes> inside;
    for (int s = 0; s < NumberOfShapes; ++s)
    {
      inside.at(s) = ListInside<N>(static_cast<CellShape>(s));
    }
    const auto of = [&](CellShape shape) -> const Points&
    { return inside[static_cast<std::size_t>(shape)]; };
    const auto isSolid = [&](vtkIdType c)
    { return parents.Cells.GetTable(c).Dimension == 3 && !parents.IsTwin(c); };
    const auto count = [](const Points& items) { return static_cast<vtkIdType>(items.size()); };
    const vtkIdType size = parents.Cells.GetNumberOfCells();
    Buffer<Id> first(size + 1);
    ForEach(size, [&](vtkIdType c)
      { first[c] = isSolid(c) ? static_cast<Id>(count(of(parents.Cells.Shapes[c]))) : Id(0); });
    CountsToOffsets(first);
    const vtkIdType quads = parents.NumberOfEdges * count(of(CellShape::Line));
    const vtkIdType triangles = quads + parents.NumberOfQuads * count(of(CellShape::Quad));
    const vtkIdType solids =
      triangles + (parents.NumberOfFaces - parents.NumberOfQuads) * count(of(CellShape::Triangle));
    Buffer<std::array<Id, N>> all(solids + first[size]);
    const auto write = [&](const Points& items, const Id* points, vtkIdType place)
    {
      for (const auto& item : items)
      {
        Id vertices[N];
        std::transform(item.begin(), item.end(), vertices, [&](int k) { return points[k]; });
        all[place++] = SortedTuple<N>(vertices);
      }
    };
    const Id edges = parents.NumberOfVertices;
    ForEach(parents.NumberOfEdges,
      [&](vtkIdType e)
      {
        const Id* ends = parents.EdgeVertices.data() + 2 * e;
        const Id points[3] = { ends[0], ends[1], static_cast<Id>(edges + e) };
        write(of(CellShape::Line), points, e * count(of(CellShape::Line)));
      });
    ForEach(parents.NumberOfFaces,
      [&](vtkIdType f)
      {
        const auto face = static_cast<Id>(f);
        const bool isQuad = face < parents.NumberOfQuads;
        Id points[9];
        Id* end =
          std::copy(parents.GetVertices(face).begin(), parents.GetVertices(face).end(), points);
        end = std::transform(parents.GetEdges(face).begin(), parents.GetEdges(face).end(), end,
          [&](Id edge) { return edges + edge; });
        *end = edges + parents.NumberOfEdges + face; // a triangle has none
        const Points& items = of(isQuad ? CellShape::Quad : CellShape::Triangle);
        write(items, points,
          isQuad ? quads + f * count(items)
                 : triangles + (f - parents.NumberOfQuads) * count(items));
      });
    ForEach(size,
      [&](vtkIdType c)
      {
        if (isSolid(c))
        {
          Id points[27];
          FindPointsOfStep(parents, c, points);
          write(of(parents.Cells.Shapes[c]), points, solids + first[c]);
        }
      });
    return all;
  }

  Buffer<Id> Offsets; ///< by the smallest vertex
  Buffer<Tail> Tails; ///< the other vertices
};

}

#endif
