// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 2: the tables of ordered simplices, which diagonal is chosen, and the paper's
// octahedra.
#include "Core/Solids/Complex/Simplices.h"
#include "CoreZoo.h"

using namespace coretest;

namespace
{

using Point = std::array<int, 3>;

/// Twice the lattice points of the tetrahedron (0, e1, e2, e3): integers, so volumes are exact.
Point LatticePoint(int i)
{
  const Point corners[4] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };
  if (i < 4)
  {
    return corners[i];
  }
  const int edges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  Point middle;
  for (int c = 0; c < 3; ++c)
  {
    middle[c] = (corners[edges[i - 4][0]][c] + corners[edges[i - 4][1]][c]) / 2;
  }
  return middle;
}

int SixVolumes(const Point& a, const Point& b, const Point& c, const Point& d)
{
  int m[3][3];
  for (int i = 0; i < 3; ++i)
  {
    m[0][i] = b[i] - a[i];
    m[1][i] = c[i] - a[i];
    m[2][i] = d[i] - a[i];
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Vertices 0..3 of which a lattice point is made.
std::set<int> CornersOf(int point)
{
  if (point < 4)
  {
    return { point };
  }
  const int* ends = tetrahedron::EdgeVertices[point - 4];
  return { ends[0], ends[1] };
}

std::set<int> CornersOf(std::initializer_list<int> points)
{
  std::set<int> corners;
  for (int point : points)
  {
    const std::set<int> own = CornersOf(point);
    corners.insert(own.begin(), own.end());
  }
  return corners;
}

}

TEST(CoreSimplices, ChildrenOfTetHaveOneEighthEachAndTheOrientationOfTheParent)
{
  EXPECT_EQ(SixVolumes(LatticePoint(0), LatticePoint(1), LatticePoint(2), LatticePoint(3)), 8);
  for (const auto& child : tetrahedron::Children)
  {
    EXPECT_EQ(SixVolumes(LatticePoint(child[0]), LatticePoint(child[1]), LatticePoint(child[2]),
                LatticePoint(child[3])),
      1);
  }
}

TEST(CoreSimplices, MarkedEdgesOfChildrenAreParallelToThoseOfTheParent)
{
  // The diagonals of the octahedra inside the children are parallel to the parent's.
  auto middleOf = [](const int* tet, int a, int b)
  {
    const Point p = LatticePoint(tet[a]);
    const Point q = LatticePoint(tet[b]);
    return Point{ p[0] + q[0], p[1] + q[1], p[2] + q[2] };
  };
  auto diagonal = [&](const int* tet)
  {
    const Point p = middleOf(tet, 0, 2);
    const Point q = middleOf(tet, 1, 3);
    return Point{ q[0] - p[0], q[1] - p[1], q[2] - p[2] };
  };
  const int parent[4] = { 0, 1, 2, 3 };
  const Point along = diagonal(parent);
  for (int child = 0; child < 4; ++child)
  {
    const Point own = diagonal(tetrahedron::Children[child]);
    EXPECT_EQ((Point{ 2 * own[0], 2 * own[1], 2 * own[2] }), along) << child;
  }
  // In a tetrahedron around the diagonal, the diagonal itself and the edge opposite to it are
  // marked.
  for (int child = 4; child < 8; ++child)
  {
    const int* tet = tetrahedron::Children[child];
    const std::set<int> pairs[2] = { { tet[0], tet[2] }, { tet[1], tet[3] } };
    EXPECT_EQ(std::count(pairs, pairs + 2, std::set<int>{ 5, 8 }), 1) << child;
  }
}

TEST(CoreSimplices, EdgesOfChildrenAreClassified)
{
  for (int child = 0; child < 8; ++child)
  {
    for (int edge = 0; edge < 6; ++edge)
    {
      const int p = tetrahedron::Children[child][tetrahedron::EdgeVertices[edge][0]];
      const int q = tetrahedron::Children[child][tetrahedron::EdgeVertices[edge][1]];
      const tetrahedron::ChildEdge origin = tetrahedron::ChildEdges[child][edge];
      const std::set<int> carrier = CornersOf({ p, q });
      switch (origin.Origin)
      {
        case tetrahedron::EdgeOrigin::HalfEdge:
        {
          const int* ends = tetrahedron::EdgeVertices[origin.Index];
          EXPECT_EQ(carrier, (std::set<int>{ ends[0], ends[1] }));
          EXPECT_EQ((std::set<int>{ p, q }), (std::set<int>{ origin.Corner, 4 + origin.Index }));
          break;
        }
        case tetrahedron::EdgeOrigin::InFace:
        {
          std::set<int> face = { 0, 1, 2, 3 };
          face.erase(origin.Index);
          EXPECT_EQ(carrier, face);
          EXPECT_TRUE(CornersOf(p).count(origin.Corner) && CornersOf(q).count(origin.Corner));
          EXPECT_TRUE(p >= 4 && q >= 4);
          break;
        }
        default:
          EXPECT_EQ((std::set<int>{ p, q }), (std::set<int>{ 5, 8 }));
          break;
      }
    }
  }
}

TEST(CoreSimplices, FacesOfChildrenAreClassified)
{
  std::map<std::set<int>, std::set<int>> interior; // points: children
  for (int child = 0; child < 8; ++child)
  {
    for (int face = 0; face < 4; ++face)
    {
      std::set<int> points;
      std::set<int> carrier;
      for (int i = 0; i < 4; ++i)
      {
        if (i != face)
        {
          points.insert(tetrahedron::Children[child][i]);
          const std::set<int> own = CornersOf(tetrahedron::Children[child][i]);
          carrier.insert(own.begin(), own.end());
        }
      }
      const tetrahedron::ChildFace origin = tetrahedron::ChildFaces[child][face];
      std::set<int> without = { 0, 1, 2, 3 };
      without.erase(origin.Index);
      switch (origin.Origin)
      {
        case tetrahedron::FaceOrigin::FaceCorner:
          EXPECT_EQ(carrier, without);
          EXPECT_EQ(points.count(origin.Corner), 1u);
          EXPECT_GE(*points.rbegin(), 4);
          break;
        case tetrahedron::FaceOrigin::FaceMiddle:
          EXPECT_EQ(carrier, without);
          EXPECT_GE(*points.begin(), 4);
          EXPECT_EQ(tetrahedron::MiddleChildren[origin.Index], child);
          break;
        default:
        {
          EXPECT_EQ(carrier.size(), 4u);
          const auto& entry = tetrahedron::InteriorFaces[origin.Index];
          EXPECT_EQ(
            points, (std::set<int>{ 4 + entry.Edges[0], 4 + entry.Edges[1], 4 + entry.Edges[2] }));
          interior[points].insert(child);
          EXPECT_TRUE(entry.Tets[0] == child || entry.Tets[1] == child);
          break;
        }
      }
    }
  }
  EXPECT_EQ(interior.size(), 8u);
  for (const auto& face : interior)
  {
    EXPECT_EQ(face.second.size(), 2u);
  }
}

TEST(CoreSimplices, TablesOfTriangles)
{
  for (int edge = 0; edge < 3; ++edge)
  {
    const int* ends = triangle::EdgeVertices[edge];
    EXPECT_EQ(ends[0] + ends[1] + triangle::VertexOpposite[edge], 3);
    EXPECT_EQ(triangle::EdgeOpposite[triangle::VertexOpposite[edge]], edge);
    for (int end : { ends[0], ends[1] })
    {
      const int* at = triangle::EdgesAt[end];
      EXPECT_TRUE(at[0] == edge || at[1] == edge);
      EXPECT_NE(at[0], at[1]);
    }
  }
  for (int edge = 0; edge < 6; ++edge)
  {
    const int* ends = tetrahedron::EdgeVertices[edge];
    const int* others = tetrahedron::EdgeVertices[tetrahedron::OppositeEdge(edge)];
    EXPECT_EQ((std::set<int>{ ends[0], ends[1], others[0], others[1] }).size(), 4u);
    EXPECT_EQ(tetrahedron::EdgeOf[ends[0]][ends[1]], edge);
    EXPECT_EQ(tetrahedron::EdgeOf[ends[1]][ends[0]], edge);
    EXPECT_EQ(tetrahedron::IsMarked(edge),
      edge == tetrahedron::MarkedEdges[0] || edge == tetrahedron::MarkedEdges[1]);
  }
  EXPECT_EQ(CornersOf(4 + tetrahedron::MarkedEdges[0]), (std::set<int>{ 0, 2 }));
  EXPECT_EQ(CornersOf(4 + tetrahedron::MarkedEdges[1]), (std::set<int>{ 1, 3 }));
}

// ------------------------------------------------------------------------------------------------
// The diagonal that is chosen

namespace
{

Tuple OrderOne(Tuple tet, const std::vector<double>& points, const vtkIdType* ids = nullptr)
{
  SimplexList list;
  list.NumberOfPoints = static_cast<vtkIdType>(points.size() / 3);
  list.Dimensions = { 0, 3 };
  list.Connectivity = tet;
  list.Connectivity.insert(list.Connectivity.begin(), 3);
  OrderTets(list, points.data(), ids, list.NumberOfPoints);
  EXPECT_EQ(list.Connectivity[0], 3);
  return Tuple(list.Connectivity.begin() + 1, list.Connectivity.end());
}

std::set<std::set<vtkIdType>> PairOf(const Tuple& tet)
{
  return { { tet[0], tet[2] }, { tet[1], tet[3] } };
}

/// Whether a permutation of four is even.
bool IsEven(const Tuple& a, const Tuple& b)
{
  int inversions = 0;
  std::vector<std::ptrdiff_t> places;
  for (vtkIdType v : a)
  {
    places.push_back(std::find(b.begin(), b.end(), v) - b.begin());
  }
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      inversions += places[i] > places[j] ? 1 : 0;
    }
  }
  return inversions % 2 == 0;
}

}

TEST(CoreTetOrder, ShortestDiagonalForAllOrders)
{
  // Stretched along x; vertices 0 and 1 lie left, 2 and 3 right: the diagonal between the midpoints
  // of 01 and 23 is the longest. Of the others, that of 02 and 13 is the shorter one.
  const std::vector<double> points = { 0, 0, 0, 0, 1, 0, 5, 0.9, 0.5, 5, 0.2, 0.6 };
  Tuple tet = { 0, 1, 2, 3 };
  do
  {
    const Tuple ordered = OrderOne(tet, points);
    EXPECT_EQ(PairOf(ordered), (std::set<std::set<vtkIdType>>{ { 0, 2 }, { 1, 3 } }));
    EXPECT_EQ(ordered[0], tet[0]);
    EXPECT_TRUE(IsEven(tet, ordered));
  } while (std::next_permutation(tet.begin(), tet.end()));
}

TEST(CoreTetOrder, TiesGoToTheShorterEdgeThenToTheSmallestGlobalIds)
{
  // Regular: all diagonals and edges tie, so the two smallest ids are partners.
  const std::vector<double> regular = { 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1 };
  EXPECT_EQ(PairOf(OrderOne({ 3, 2, 1, 0 }, regular)),
    (std::set<std::set<vtkIdType>>{ { 0, 1 }, { 2, 3 } }));
  const vtkIdType ids[4] = { 70, 20, 90, 40 };
  EXPECT_EQ(PairOf(OrderOne({ 3, 2, 1, 0 }, regular, ids)),
    (std::set<std::set<vtkIdType>>{ { 1, 3 }, { 0, 2 } }));
  // Kuhn: the diagonals of {v0 v2, v1 v3} and {v0 v3, v1 v2} tie; v0 v3 is the long edge.
  for (double h : { 1., 0.1, 0.3, 1. / 3. })
  {
    const std::vector<double> kuhn = { 7 * h, 0, 2 * h, 7 * h + h, 0, 2 * h, 7 * h + h, h, 2 * h,
      7 * h + h, h, 2 * h + h };
    EXPECT_EQ(
      PairOf(OrderOne({ 0, 1, 2, 3 }, kuhn)), (std::set<std::set<vtkIdType>>{ { 0, 2 }, { 1, 3 } }))
      << h;
  }
}

TEST(CoreTetOrder, TiesOfARotatedLatticeSurviveRounding)
{
  // A rotation keeps the ties of a Kuhn lattice, up to rounding.
  const double r[3][3] = { { 2. / 3., -1. / 3., 2. / 3. }, { 2. / 3., 2. / 3., -1. / 3. },
    { -1. / 3., 2. / 3., 2. / 3. } };
  for (int i = 0; i < 125; ++i)
  {
    int axes[3] = { 0, 1, 2 };
    do
    {
      int p[3] = { i % 5, i / 5 % 5, i / 25 };
      std::vector<double> points;
      for (int corner = 0; corner < 4; ++corner)
      {
        for (const auto& row : r)
        {
          points.push_back(0.1 * (row[0] * p[0] + row[1] * p[1] + row[2] * p[2]));
        }
        p[axes[corner % 3]] += 1;
      }
      ASSERT_EQ(PairOf(OrderOne({ 0, 1, 2, 3 }, points)),
        (std::set<std::set<vtkIdType>>{ { 0, 2 }, { 1, 3 } }));
    } while (std::next_permutation(axes, axes + 3));
  }
}

// ------------------------------------------------------------------------------------------------
// The paper's procedure: octahedra with a stored diagonal

namespace
{

using Corners = std::set<Point>;

struct Octahedron
{
  Point Pairs[3][2]; ///< opposite corners; the first pair is the stored diagonal
};

Point Middle(const Point& a, const Point& b)
{
  return { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 };
}

struct PaperMesh
{
  std::vector<std::array<Point, 4>> Tets; ///< the stored diagonal of each lies between 02 and 13
  std::vector<Octahedron> Octahedra;

  void SplitTet(const std::array<Point, 4>& t)
  {
    for (int i = 0; i < 4; ++i)
    {
      std::array<Point, 4> child;
      for (int j = 0; j < 4; ++j)
      {
        child[j] = Middle(t[i], t[j]);
      }
      this->Tets.push_back(child);
    }
    this->Octahedra.push_back({ { { Middle(t[0], t[2]), Middle(t[1], t[3]) },
      { Middle(t[0], t[1]), Middle(t[2], t[3]) }, { Middle(t[0], t[3]), Middle(t[1], t[2]) } } });
  }
  void SplitOctahedron(const Octahedron& o)
  {
    // A small octahedron at each corner: opposite pairs are parallel to those of the parent.
    const Point centre = Middle(o.Pairs[0][0], o.Pairs[0][1]);
    for (int pair = 0; pair < 3; ++pair)
    {
      for (const Point& corner : o.Pairs[pair])
      {
        Octahedron child;
        for (int q = 0; q < 3; ++q)
        {
          for (int side = 0; side < 2; ++side)
          {
            child.Pairs[q][side] = Middle(corner, o.Pairs[q][side]);
          }
        }
        EXPECT_TRUE(Middle(child.Pairs[0][0], child.Pairs[0][1]) == Middle(corner, centre));
        this->Octahedra.push_back(child);
      }
    }
    // And a tetrahedron under each face: the centre and three midpoints of edges.
    for (int face = 0; face < 8; ++face)
    {
      const Point& a = o.Pairs[0][face & 1];
      const Point& b = o.Pairs[1][face >> 1 & 1];
      const Point& c = o.Pairs[2][face >> 2 & 1];
      const Point ab = Middle(a, b);
      const Point bc = Middle(b, c);
      const Point ca = Middle(c, a);
      // Its diagonal, from the middle of (centre, bc) to that of (ab, ca), is parallel to the
      // first pair, that is, to the stored one.
      this->Tets.push_back({ centre, ab, bc, ca });
    }
  }
};

/// Tetrahedra of a level as sets of integer points.
std::set<Corners> RunPaper(std::array<Point, 4> tet, int levels)
{
  PaperMesh mesh;
  mesh.Tets.push_back(tet);
  for (int level = 0; level < levels; ++level)
  {
    PaperMesh next;
    for (const auto& t : mesh.Tets)
    {
      next.SplitTet(t);
    }
    for (const auto& o : mesh.Octahedra)
    {
      next.SplitOctahedron(o);
    }
    mesh = next;
  }
  std::set<Corners> result;
  for (const auto& t : mesh.Tets)
  {
    result.insert(Corners(t.begin(), t.end()));
  }
  for (const Octahedron& o : mesh.Octahedra)
  {
    for (int i = 0; i < 4; ++i) // around the diagonal
    {
      const Point& p = o.Pairs[1][i & 1];
      const Point& q = o.Pairs[2][i >> 1];
      result.insert({ o.Pairs[0][0], o.Pairs[0][1], p, q });
    }
  }
  return result;
}

}

TEST(CoreRefinement, EqualsThePapersOctahedra)
{
  Mesh mesh("Tet");
  mesh.AddPoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
  mesh.AddCell({ 0, 1, 2, 3 });
  constexpr int unit = 64;
  const std::array<Point, 4> corners = { { { 0, 0, 0 }, { unit, 0, 0 }, { 0, unit, 0 },
    { 0, 0, unit } } };
  Subdivided<int> level = Build<int>(mesh.Cells);
  std::vector<Point> positions(corners.begin(), corners.end());
  for (int step = 1; step <= 3; ++step)
  {
    const auto& parent = level.Level.Complex;
    for (int e = 0; e < parent.NumberOfEdges; ++e)
    {
      positions.push_back(
        Middle(positions[parent.EdgeVertices[2 * e]], positions[parent.EdgeVertices[2 * e + 1]]));
    }
    level = RefineOnce(level);
    std::set<Corners> tets;
    for (const Tuple& tet : GetCells(ReadCells(level)))
    {
      Corners points;
      for (vtkIdType v : tet)
      {
        points.insert(positions[v]);
      }
      EXPECT_EQ(points.size(), 4u);
      tets.insert(points);
    }
    EXPECT_EQ(tets.size(), std::size_t(1) << 3 * step);
    EXPECT_EQ(tets, RunPaper(corners, step)) << step;
  }
}
