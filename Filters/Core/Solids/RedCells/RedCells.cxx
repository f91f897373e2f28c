// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/RedCells/RedCells.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/TupleIndex.h"

#include <algorithm>

namespace subdivision
{
namespace
{

struct RedChild
{
  CellShape Shape;
  std::vector<int> Points;
};

/// How a cell is split. Its points are numbered: corners, middles of edges, middles of quads, and
/// the middle of a hexahedron.
struct RedShape
{
  int Corners;
  std::vector<std::array<int, 2>> Edges;
  std::vector<std::array<int, 4>> Quads;
  bool HasCentre;
  std::vector<RedChild> Children;
};

std::vector<RedChild> MakeChildren(CellShape shape, const std::vector<std::vector<int>>& points)
{
  std::vector<RedChild> children;
  for (const std::vector<int>& child : points)
  {
    children.push_back({ shape, child });
  }
  return children;
}

RedShape MakePyramid()
{
  RedShape pyramid{ 5,
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } },
    { { 0, 1, 2, 3 } }, false,
    MakeChildren(CellShape::Pyramid,
      { { 0, 5, 13, 8, 9 }, { 5, 1, 6, 13, 10 }, { 13, 6, 2, 7, 11 }, { 8, 13, 7, 3, 12 },
        { 9, 10, 11, 12, 4 }, { 9, 12, 11, 10, 13 } }) };
  const auto tets = MakeChildren(
    CellShape::Tet, { { 5, 13, 9, 10 }, { 6, 13, 10, 11 }, { 7, 13, 11, 12 }, { 8, 13, 12, 9 } });
  pyramid.Children.insert(pyramid.Children.end(), tets.begin(), tets.end());
  return pyramid;
}

const RedShape& GetShape(CellShape shape)
{
  static const std::array<RedShape, NumberOfShapes> shapes{ {
    { 1, {}, {}, false, MakeChildren(CellShape::Vertex, { { 0 } }) },
    { 2, { { 0, 1 } }, {}, false, MakeChildren(CellShape::Line, { { 0, 2 }, { 2, 1 } }) },
    { 3, { { 0, 1 }, { 1, 2 }, { 2, 0 } }, {}, false,
      MakeChildren(CellShape::Triangle, { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 }, { 3, 4, 5 } }) },
    { 4, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } }, { { 0, 1, 2, 3 } }, false,
      MakeChildren(
        CellShape::Quad, { { 0, 4, 8, 7 }, { 4, 1, 5, 8 }, { 8, 5, 2, 6 }, { 7, 8, 6, 3 } }) },
    { 4, { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }, {}, false,
      MakeChildren(CellShape::Tet,
        { { 0, 4, 5, 6 }, { 4, 1, 7, 8 }, { 5, 7, 2, 9 }, { 6, 8, 9, 3 }, { 4, 5, 6, 8 },
          { 7, 5, 4, 8 }, { 5, 6, 8, 9 }, { 8, 7, 5, 9 } }) },
    MakePyramid(),
    { 6,
      { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 } },
      { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } }, false,
      MakeChildren(CellShape::Wedge,
        { { 0, 6, 8, 12, 15, 17 }, { 6, 1, 7, 15, 13, 16 }, { 8, 7, 2, 17, 16, 14 },
          { 6, 7, 8, 15, 16, 17 }, { 12, 15, 17, 3, 9, 11 }, { 15, 13, 16, 9, 4, 10 },
          { 17, 16, 14, 11, 10, 5 }, { 15, 16, 17, 9, 10, 11 } }) },
    { 8,
      { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 }, { 7, 4 }, { 0, 4 },
        { 1, 5 }, { 2, 6 }, { 3, 7 } },
      { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
        { 3, 0, 4, 7 } },
      true,
      MakeChildren(CellShape::Hex,
        { { 0, 8, 20, 11, 16, 22, 26, 25 }, { 8, 1, 9, 20, 22, 17, 23, 26 },
          { 20, 9, 2, 10, 26, 23, 18, 24 }, { 11, 20, 10, 3, 25, 26, 24, 19 },
          { 16, 22, 26, 25, 4, 12, 21, 15 }, { 22, 17, 23, 26, 12, 5, 13, 21 },
          { 26, 23, 18, 24, 21, 13, 6, 14 }, { 25, 26, 24, 19, 15, 21, 14, 7 } }) },
  } };
  return shapes[static_cast<std::size_t>(shape)];
}

/// act(shape, corners) for each cell.
template <typename Act>
void ForCells(const ShapedCells& cells, const Act& act)
{
  const long long* corners = cells.Corners.data();
  for (const CellShape shape : InTurn(cells.Shapes))
  {
    const RedShape& red = GetShape(shape);
    act(red, corners);
    corners += red.Corners;
  }
}

/// The vertex sets of all edges, or of all quads, of all cells, and their numbers.
template <int N>
struct Parts
{
  using Tuple = std::array<long long, N>;

  template <typename List>
  Parts(const ShapedCells& cells, const List& list)
  {
    std::vector<Tuple> found;
    ForCells(cells,
      [&](const RedShape& shape, const long long* corners)
      {
        for (const auto& part : list(shape))
        {
          long long vertices[N];
          std::transform(
            part.begin(), part.end(), vertices, [corners](int k) { return corners[k]; });
          found.push_back(SortedTuple<N>(vertices));
        }
      });
    this->Tuples = Buffer<Tuple>(static_cast<vtkIdType>(found.size()));
    std::copy(found.begin(), found.end(), this->Tuples.begin());
    this->Index = NumberTuples<N, long long>(this->Tuples, cells.NumberOfPoints, 0);
  }
  long long GetSize() const { return this->Index.Representatives.size(); }

  Buffer<Tuple> Tuples;
  TupleNumbers<long long> Index;
};

/// Writes rows one after the other.
class RowWriter
{
public:
  RowWriter(vtkIdType columns, vtkIdType rows, vtkIdType entries)
  {
    this->Rows.NumberOfColumns = columns;
    this->Rows.Offsets = Buffer<long long>(rows + 1);
    this->Rows.Columns = Buffer<long long>(entries);
    this->Rows.Weights = Buffer<double>(entries);
    this->Rows.Offsets[0] = 0;
  }
  void AddMean(const long long* first, int size)
  {
    for (int k = 0; k < size; ++k)
    {
      this->Rows.Columns[this->Entry] = first[k];
      this->Rows.Weights[this->Entry++] = 1. / size;
    }
    this->Rows.Offsets[++this->Row] = this->Entry;
  }
  SparseRows<long long> Rows;

private:
  vtkIdType Row = 0;
  vtkIdType Entry = 0;
};

}

int GetNumberOfCorners(CellShape shape)
{
  return GetShape(shape).Corners;
}

void ShapedCells::Add(CellShape shape, const long long* corners)
{
  this->Shapes.push_back(shape);
  this->Corners.insert(this->Corners.end(), corners, corners + GetNumberOfCorners(shape));
}

std::array<double, NumberOfShapes> CountRedChildren(const std::array<double, NumberOfShapes>& cells)
{
  std::array<double, NumberOfShapes> counts{};
  for (int s = 0; s < NumberOfShapes; ++s)
  {
    for (const RedChild& child : GetShape(static_cast<CellShape>(s)).Children)
    {
      counts[static_cast<std::size_t>(child.Shape)] += cells[s];
    }
  }
  return counts;
}

RedStep RefineRed(const ShapedCells& cells)
{
  const Parts<2> edges(cells, [](const RedShape& shape) -> const auto& { return shape.Edges; });
  const Parts<4> quads(cells, [](const RedShape& shape) -> const auto& { return shape.Quads; });
  const long long firstEdge = cells.NumberOfPoints;
  const long long firstQuad = firstEdge + edges.GetSize();
  long long centre = firstQuad + quads.GetSize();
  const long long centres = std::count(cells.Shapes.begin(), cells.Shapes.end(), CellShape::Hex);
  RowWriter rows(firstEdge, centre + centres,
    firstEdge + 2 * edges.GetSize() + 4 * quads.GetSize() + 8 * centres);
  for (long long point = 0; point < firstEdge; ++point)
  {
    rows.AddMean(&point, 1);
  }
  for (const long long first : InTurn(edges.Index.Representatives))
  {
    rows.AddMean(edges.Tuples[first].data(), 2);
  }
  for (const long long first : InTurn(quads.Index.Representatives))
  {
    rows.AddMean(quads.Tuples[first].data(), 4);
  }
  RedStep step;
  vtkIdType edge = 0;
  vtkIdType quad = 0;
  vtkIdType cell = 0;
  ForCells(cells,
    [&](const RedShape& shape, const long long* corners)
    {
      std::vector<long long> points(corners, corners + shape.Corners);
      for (std::size_t e = 0; e < shape.Edges.size(); ++e)
      {
        points.push_back(firstEdge + edges.Index.Numbers[edge++]);
      }
      for (std::size_t q = 0; q < shape.Quads.size(); ++q)
      {
        points.push_back(firstQuad + quads.Index.Numbers[quad++]);
      }
      if (shape.HasCentre)
      {
        rows.AddMean(SortedTuple<8>(corners).data(), 8);
        points.push_back(centre++);
      }
      for (const RedChild& child : shape.Children)
      {
        step.Children.Shapes.push_back(child.Shape);
        std::transform(child.Points.begin(), child.Points.end(),
          std::back_inserter(step.Children.Corners), [&points](int k) { return points[k]; });
        step.Parents.push_back(cell);
      }
      ++cell;
    });
  step.Children.NumberOfPoints = centre;
  step.Rows = std::move(rows.Rows);
  return step;
}

}
