// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenTables.cxx
 * Mathematics 13: which patterns close to which, and what the parts of each are. And the small
 * types that red-green refinement is made of.
 */
#include "Precompiled.h"

#include "Core/Solids/RedGreen/RedGreenCells.h"
#include "Core/Solids/RedGreen/RedGreenTables.h"

using namespace subdivision;
using namespace subdivision::redgreen;

namespace
{

const std::vector<std::vector<std::pair<int, int>>> Edges{ {}, { { 0, 1 } },
  { { 0, 1 }, { 1, 2 }, { 0, 2 } },
  { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } };

int Count(unsigned int pattern)
{
  int bits = 0;
  for (int k = 0; k < 8; ++k)
  {
    bits += pattern >> k & 1u;
  }
  return bits;
}

/// The edges that three corners have, as a pattern.
unsigned int GetTriangle(int dimension, const std::set<int>& corners)
{
  unsigned int pattern = 0;
  const auto& edges = Edges[static_cast<std::size_t>(dimension)];
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    pattern |= corners.count(edges[k].first) && corners.count(edges[k].second) ? 1u << k : 0u;
  }
  return pattern;
}

/// By definition: a triangle with two split edges splits its third one, until none does.
unsigned int Close(int dimension, unsigned int pattern)
{
  const std::vector<std::set<int>> triangles = dimension < 2 ? std::vector<std::set<int>>{}
    : dimension == 2
    ? std::vector<std::set<int>>{ { 0, 1, 2 } }
    : std::vector<std::set<int>>{ { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } };
  for (bool again = true; again;)
  {
    again = false;
    for (const std::set<int>& corners : triangles)
    {
      const unsigned int triangle = GetTriangle(dimension, corners);
      if (Count(pattern & triangle) == 2)
      {
        pattern |= triangle;
        again = true;
      }
    }
  }
  return pattern;
}

/// Twice the barycentric coordinates of a lattice point.
std::array<int, 4> GetPoint(int dimension, int point)
{
  std::array<int, 4> weights{};
  if (point <= dimension)
  {
    weights[static_cast<std::size_t>(point)] = 2;
    return weights;
  }
  const auto& edge =
    Edges[static_cast<std::size_t>(dimension)][static_cast<std::size_t>(point - dimension - 1)];
  weights[static_cast<std::size_t>(edge.first)] = 1;
  weights[static_cast<std::size_t>(edge.second)] = 1;
  return weights;
}

int Determinant(const std::vector<std::vector<int>>& rows)
{
  if (rows.size() == 1)
  {
    return rows[0][0];
  }
  int sum = 0;
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    std::vector<std::vector<int>> minor;
    for (std::size_t i = 1; i < rows.size(); ++i)
    {
      minor.push_back(rows[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(k));
    }
    sum += (k % 2 ? -1 : 1) * rows[0][k] * Determinant(minor);
  }
  return sum;
}

/// The size of a part; that of the whole cell is 2 to the power of dimension + 1.
int GetSize(int dimension, const signed char* vertices)
{
  std::vector<std::vector<int>> rows;
  for (int i = 0; i <= dimension; ++i)
  {
    const std::array<int, 4> point = GetPoint(dimension, vertices[i]);
    rows.emplace_back(point.begin(), point.begin() + dimension + 1);
  }
  return Determinant(rows);
}

std::vector<std::vector<int>> GetParts(const Parts& parts, int dimension)
{
  std::vector<std::vector<int>> lists;
  for (int part = 0; part < parts.Count; ++part)
  {
    lists.emplace_back(parts.Vertices[part], parts.Vertices[part] + dimension + 1);
  }
  return lists;
}

using Lists = std::vector<std::vector<int>>;

}

TEST(RedGreenTables, EdgesAndFaces)
{
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    const auto& edges = Edges[static_cast<std::size_t>(dimension)];
    EXPECT_EQ(NumberOfEdges[dimension], static_cast<int>(edges.size()));
    EXPECT_EQ(Full[dimension], (1u << edges.size()) - 1u);
    for (int k = 0; k < static_cast<int>(edges.size()); ++k)
    {
      EXPECT_EQ(EndsOf(dimension, k)[0], edges[static_cast<std::size_t>(k)].first);
      EXPECT_EQ(EndsOf(dimension, k)[1], edges[static_cast<std::size_t>(k)].second);
    }
  }
  for (int face = 0; face < 4; ++face)
  {
    std::set<int> corners{ 0, 1, 2, 3 };
    corners.erase(face);
    EXPECT_EQ(FacePattern(face), GetTriangle(3, corners));
  }
  for (unsigned int pattern = 0; pattern < 64; ++pattern)
  {
    EXPECT_EQ(CountBits(pattern), Count(pattern));
  }
}

TEST(RedGreenTables, PatternsClose)
{
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    for (unsigned int pattern = 0; pattern <= Full[dimension]; ++pattern)
    {
      EXPECT_EQ(ClosePattern(dimension, pattern), Close(dimension, pattern)) << pattern;
    }
  }
}

TEST(RedGreenTables, PartsFillTheCell)
{
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    for (unsigned int pattern = 0; pattern <= Full[dimension]; ++pattern)
    {
      SCOPED_TRACE(std::to_string(dimension) + " " + std::to_string(pattern));
      const Parts parts = MakeParts(dimension, pattern);
      const unsigned int closed = Close(dimension, pattern);
      EXPECT_EQ(parts.Closed, closed);
      const int split = Count(closed);
      const bool isRed = split > 0 && split == static_cast<int>(Edges[dimension].size());
      EXPECT_EQ(parts.Kind,
        isRed          ? RefinementKind::Red
          : split == 0 ? RefinementKind::Untouched
          : split == 1 ? RefinementKind::GreenI
          : split == 2 ? RefinementKind::GreenII
                       : RefinementKind::GreenIII);
      const int expected[4] = { 1, 2, 4, 4 };
      EXPECT_EQ(parts.Count, isRed ? 1 << dimension : expected[split]);
      int sum = 0;
      std::set<int> used;
      for (int part = 0; part < parts.Count; ++part)
      {
        const int size = GetSize(dimension, parts.Vertices[part]);
        EXPECT_GT(size, 0) << "part " << part; // oriented as the cell
        sum += size;
        used.insert(parts.Vertices[part], parts.Vertices[part] + dimension + 1);
      }
      EXPECT_EQ(sum, 2 << dimension);
      std::set<int> points;
      for (int i = 0; i <= dimension; ++i)
      {
        points.insert(i);
      }
      for (int k = 0; k < NumberOfEdges[dimension]; ++k)
      {
        if (closed >> k & 1u)
        {
          points.insert(dimension + 1 + k);
        }
      }
      EXPECT_EQ(used, points); // and no midpoint of another edge
    }
  }
}

// Ids of children follow from the order of the parts and of their vertices.
TEST(RedGreenTables, PartsInTheirOrder)
{
  EXPECT_EQ(GetParts(MakeParts(0, 0), 0), (Lists{ { 0 } }));
  EXPECT_EQ(GetParts(MakeParts(1, 1), 1), (Lists{ { 0, 2 }, { 2, 1 } }));
  EXPECT_EQ(GetParts(MakeParts(2, 0), 2), (Lists{ { 0, 1, 2 } }));
  EXPECT_EQ(GetParts(MakeParts(2, 2), 2), (Lists{ { 0, 1, 4 }, { 0, 4, 2 } }));
  EXPECT_EQ(GetParts(MakeParts(3, 0), 3), (Lists{ { 0, 1, 2, 3 } }));
  EXPECT_EQ(GetParts(MakeParts(3, 8), 3), (Lists{ { 0, 1, 7, 3 }, { 0, 7, 2, 3 } }));
  EXPECT_EQ(GetParts(MakeParts(3, 1u << 0 | 1u << 5), 3),
    (Lists{ { 0, 4, 2, 9 }, { 4, 1, 2, 9 }, { 0, 4, 9, 3 }, { 4, 1, 9, 3 } }));
  for (int face = 0; face < 4; ++face)
  {
    // Face by face: the children of the triangle of Mathematics 2, with the vertex opposite.
    const int* corners = tetrahedron::FaceVertices[face];
    Lists expected;
    for (int child = 0; child < 4; ++child)
    {
      std::vector<int> part(4, face);
      for (int i = 0; i < 3; ++i)
      {
        const int point = triangle::Children[child][i];
        const int edge = point - 3; // of the triangle
        part[static_cast<std::size_t>(corners[i])] = point < 3 ? corners[point]
                                                               : 4 +
            tetrahedron::EdgeOf[corners[triangle::EdgeVertices[edge][0]]]
                               [corners[triangle::EdgeVertices[edge][1]]];
      }
      expected.push_back(part);
    }
    EXPECT_EQ(GetParts(MakeParts(3, FacePattern(face)), 3), expected) << face;
  }
  for (int child = 0; child < 8; ++child)
  {
    const int* own = tetrahedron::Children[child];
    EXPECT_EQ(GetParts(MakeParts(3, 63), 3)[child], std::vector<int>(own, own + 4));
    const int* flat = triangle::Children[child % 4];
    EXPECT_EQ(GetParts(MakeParts(2, 7), 2)[child % 4], std::vector<int>(flat, flat + 3));
  }
}

TEST(RedGreenTables, OneTableForAll)
{
  const auto table = MakeAllParts();
  ASSERT_EQ(table.size(), 4u);
  ASSERT_EQ(PartsOf.size(), 4u);
  ASSERT_EQ(table[0].size(), 64u); // patterns of six edges
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    for (unsigned int pattern = 0; pattern < 64; ++pattern)
    {
      const Parts parts = pattern <= Full[dimension] ? MakeParts(dimension, pattern) : Parts();
      for (const Parts& other : { table[dimension][pattern], PartsOf[dimension][pattern] })
      {
        EXPECT_EQ(other.Closed, parts.Closed);
        EXPECT_EQ(other.Kind, parts.Kind);
        EXPECT_EQ(GetParts(other, dimension), GetParts(parts, dimension));
      }
    }
  }
  EXPECT_EQ(Parts().Closed, 0);
  EXPECT_EQ(Parts().Count, 1);
  EXPECT_EQ(GetParts(Parts(), 3), (Lists{ { 0, 0, 0, 0 } }));
}

TEST(RedGreenCells, NothingIsNamedBeforeItIsSet)
{
  EXPECT_EQ(LastLevel, 255);
  const RedGreenLeaf<int> leaf;
  EXPECT_EQ(leaf.Cell, 0);
  EXPECT_EQ(leaf.Child, -1);
  const RedGreenCell<int> cell;
  EXPECT_EQ(cell.Input, 0);
  EXPECT_EQ(cell.Parent, -1);
  EXPECT_EQ(cell.Child, -1);
  EXPECT_EQ(cell.Dimension, 0);
  EXPECT_EQ(cell.Level, 0);
  EXPECT_EQ(cell.Vertices, (std::array<int, 4>{ -1, -1, -1, -1 }));
  const RedGreenOutputCell<int> made;
  EXPECT_EQ(made.Leaf.Child, -1);
  EXPECT_EQ(made.Input, 0);
  EXPECT_EQ(made.Dimension, 0);
  EXPECT_EQ(made.Level, 0);
  EXPECT_EQ(made.Kind, RefinementKind::Untouched);
  EXPECT_EQ(made.Vertices, (std::array<int, 4>{ -1, -1, -1, -1 }));
  const RedGreenOrigin<int> origin;
  EXPECT_EQ(origin.Cell, 0);
  EXPECT_EQ(origin.Edge, 0);
}

// Values of cell arrays in files, and of numbers that ranks exchange.
TEST(RedGreenCells, NumbersOfKindsAndScopes)
{
  EXPECT_EQ(static_cast<int>(RefinementKind::Untouched), 0);
  EXPECT_EQ(static_cast<int>(RefinementKind::Red), 1);
  EXPECT_EQ(static_cast<int>(RefinementKind::GreenI), 2);
  EXPECT_EQ(static_cast<int>(RefinementKind::GreenII), 3);
  EXPECT_EQ(static_cast<int>(RefinementKind::GreenIII), 4);
  EXPECT_EQ(static_cast<int>(CellScope::Ignored), 0);
  EXPECT_EQ(static_cast<int>(CellScope::Copied), 1);
  EXPECT_EQ(static_cast<int>(CellScope::Own), 2);
}
