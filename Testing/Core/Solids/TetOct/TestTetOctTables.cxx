// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTetOctTables.cxx
 * Mathematics 10: the local numbers of an octahedron, and the parts of both shapes, number by
 * number and by their volumes.
 */
#include "Precompiled.h"

#include "Core/Solids/TetOct/TetOctTables.h"

#include <iterator>
#include <type_traits>

using namespace subdivision;

namespace
{

using Point = std::array<int, 3>;
using List = std::vector<int>;
using Lists = std::vector<List>;

constexpr int Centre = 18; // of an octahedron, as lattice point

/// The edges by definition: all pairs but opposite ones, the smaller numbers first.
Lists ListEdges()
{
  Lists edges;
  for (int a = 0; a < 6; ++a)
  {
    for (int b = a + 1; b < 6; ++b)
    {
      if (a / 2 != b / 2)
      {
        edges.push_back({ a, b });
      }
    }
  }
  return edges;
}

/// The lattice point between two vertices of an octahedron.
int FindMiddle(int a, int b)
{
  const Lists edges = ListEdges();
  const List edge{ std::min(a, b), std::max(a, b) };
  return 6 + static_cast<int>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
}

/// The lattice points of a positive octahedron around 0, and of a positive tetrahedron. Twice their
/// coordinates.
std::vector<Point> ListPoints(bool isOctahedron)
{
  std::vector<Point> points = isOctahedron
    ? std::vector<Point>{ { 2, 0, 0 }, { -2, 0, 0 }, { 0, 2, 0 }, { 0, -2, 0 }, { 0, 0, 2 },
        { 0, 0, -2 } }
    : std::vector<Point>{ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };
  const Lists edges = isOctahedron
    ? ListEdges()
    : Lists{ { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  for (const List& edge : edges)
  {
    Point middle{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      middle[i] = (points[static_cast<std::size_t>(edge[0])][i] +
                    points[static_cast<std::size_t>(edge[1])][i]) /
        2;
    }
    points.push_back(middle);
  }
  points.push_back({ 0, 0, 0 });
  return points;
}

/// The determinant of p - q for three pairs of points.
int Determinant(const std::vector<Point>& points, const List& pairs)
{
  int d[3][3];
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      d[row][i] = points.at(static_cast<std::size_t>(pairs[2 * row]))[i] -
        points.at(static_cast<std::size_t>(pairs[2 * row + 1]))[i];
    }
  }
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
    d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
    d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

/// Six times the volumes of parts, all of which are positive.
int SumVolumes(bool isOctahedron, const Lists& parts)
{
  const std::vector<Point> points = ListPoints(isOctahedron);
  int sum = 0;
  for (const List& part : parts)
  {
    const int volume = Determinant(points,
      part.size() == 6 ? part : List{ part[1], part[0], part[2], part[0], part[3], part[0] });
    EXPECT_GT(volume, 0) << "part " << &part - parts.data();
    sum += volume;
  }
  return sum;
}

template <typename Arrays>
Lists MakeLists(const Arrays& arrays)
{
  Lists lists;
  for (const auto& array : arrays)
  {
    lists.emplace_back(std::begin(array), std::end(array));
  }
  return lists;
}

}

TEST(TetOctTables, EdgesOfAnOctahedron)
{
  const Lists edges = ListEdges();
  EXPECT_EQ(MakeLists(octahedron::EdgeVertices), edges);
  EXPECT_EQ(&OctShape::EdgeVertices, &octahedron::EdgeVertices);
  EXPECT_EQ(&OctShape::EdgeOf, &octahedron::EdgeOf);
  EXPECT_EQ(MakeLists(octahedron::EdgeOf).size(), 6u);
  for (int a = 0; a < 6; ++a)
  {
    EXPECT_EQ(octahedron::Opposite(a), a % 2 ? a - 1 : a + 1);
    EXPECT_EQ(MakeLists(octahedron::EdgeOf)[static_cast<std::size_t>(a)].size(), 6u);
    for (int b = 0; b < 6; ++b)
    {
      EXPECT_EQ(octahedron::EdgeOf[a][b], a / 2 == b / 2 ? -1 : FindMiddle(a, b) - 6);
    }
  }
}

TEST(TetOctTables, FacesOfAnOctahedron)
{
  const std::vector<Point> points = ListPoints(true);
  const Lists faces = MakeLists(octahedron::FaceVertices);
  EXPECT_EQ(&OctShape::FaceVertices, &octahedron::FaceVertices);
  ASSERT_EQ(faces.size(), 8u);
  for (int face = 0; face < 8; ++face)
  {
    const List& own = faces[static_cast<std::size_t>(face)];
    List corners{ face % 2, 2 + face / 2 % 2, 4 + face / 4 };
    EXPECT_EQ(own[0], corners[0]);
    EXPECT_GT(Determinant(points, { own[0], Centre, own[1], Centre, own[2], Centre }), 0);
    do
    {
      EXPECT_EQ(octahedron::FaceOf(corners[0], corners[1], corners[2]), face);
      EXPECT_EQ(OctShape::FaceOf(corners[0], corners[1], corners[2]), face);
    } while (std::next_permutation(corners.begin(), corners.end()));
    EXPECT_EQ(std::set<int>(own.begin(), own.end()), std::set<int>(corners.begin(), corners.end()));
    for (int corner = 0; corner < 3; ++corner)
    {
      EXPECT_EQ(octahedron::CornerOf(face, own[static_cast<std::size_t>(corner)]), corner);
    }
  }
}

TEST(TetOctTables, FacesAtAnEdge)
{
  const Lists edges = ListEdges();
  for (int edge = 0; edge < 12; ++edge)
  {
    const int a = edges[static_cast<std::size_t>(edge)][0];
    const int b = edges[static_cast<std::size_t>(edge)][1];
    int third = 0; // of no pair of the edge
    while (third / 2 == a / 2 || third / 2 == b / 2)
    {
      third += 2;
    }
    EXPECT_EQ(octahedron::ThirdPair(a, b), third);
    EXPECT_EQ(octahedron::ThirdPair(b, a), third);
    int first = 0; // that has all three
    for (int vertex : { a, b, third })
    {
      first += vertex % 2 << vertex / 2;
    }
    EXPECT_EQ(octahedron::FirstFaceAt(edge), first);
  }
}

TEST(TetOctTables, NumbersOfBothShapes)
{
  EXPECT_EQ(TetShape::Shapes::Size, 2);
  EXPECT_EQ(TetShape::Index, 0);
  EXPECT_EQ(OctShape::Index, 1);
  EXPECT_EQ(OctShape::Vertices, 6);
  EXPECT_EQ(OctShape::Edges, 12);
  EXPECT_EQ(OctShape::Faces, 8);
  EXPECT_EQ(OctShape::Centres, 1);
  EXPECT_EQ(OctShape::Centre, Centre);
}

TEST(TetOctTables, PartsOfATetrahedron)
{
  const Lists tets = MakeLists(TetShape::GetChildren(TetShape()));
  const Lists octs = MakeLists(TetShape::GetChildren(OctShape()));
  EXPECT_EQ(tets, (Lists{ { 0, 4, 5, 6 }, { 4, 1, 7, 8 }, { 5, 7, 2, 9 }, { 6, 8, 9, 3 } }));
  EXPECT_EQ(octs, (Lists{ { 4, 9, 6, 7, 5, 8 } })); // x01,x23, x03,x12, x02,x13
  EXPECT_EQ(SumVolumes(false, tets), 4);
  EXPECT_EQ(SumVolumes(false, octs), 4);
  static_assert(
    std::is_same_v<decltype(TetShape::GetInnerEdges()), std::array<std::array<int, 2>, 0>>);
  EXPECT_EQ(MakeLists(TetShape::GetInnerFaces()),
    (Lists{ { 4, 5, 6 }, { 4, 7, 8 }, { 5, 7, 9 }, { 6, 8, 9 } }));
}

TEST(TetOctTables, PartsOfAnOctahedron)
{
  const Lists tets = MakeLists(OctShape::GetChildren(TetShape()));
  const Lists octs = MakeLists(OctShape::GetChildren(OctShape()));
  Lists expected;
  for (const auto& face : octahedron::FaceVertices)
  {
    const int p = face[0];
    const int q = face[1];
    const int r = face[2];
    expected.push_back({ Centre, FindMiddle(p, q), FindMiddle(q, r), FindMiddle(r, p) });
  }
  EXPECT_EQ(tets, expected);
  expected.clear();
  for (int v = 0; v < 6; ++v)
  {
    expected.emplace_back();
    for (int w = 0; w < 6; ++w)
    {
      expected.back().push_back(v == w ? v : v / 2 == w / 2 ? Centre : FindMiddle(v, w));
    }
  }
  EXPECT_EQ(octs, expected);
  EXPECT_EQ(SumVolumes(true, tets), 16);
  EXPECT_EQ(SumVolumes(true, octs), 48);
}

TEST(TetOctTables, InsideAnOctahedron)
{
  Lists spokes;
  for (int edge = 0; edge < 12; ++edge)
  {
    spokes.push_back({ Centre, 6 + edge });
  }
  EXPECT_EQ(MakeLists(OctShape::GetInnerEdges()), spokes);
  Lists expected;
  for (const auto& face : octahedron::FaceVertices)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int corner = face[i];
      const int next = face[(i + 1) % 3];
      const int last = face[(i + 2) % 3];
      expected.push_back({ Centre, FindMiddle(corner, next), FindMiddle(corner, last) });
    }
  }
  EXPECT_EQ(MakeLists(OctShape::GetInnerFaces()), expected);
}
