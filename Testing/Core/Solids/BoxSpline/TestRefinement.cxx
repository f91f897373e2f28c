// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 2 and 4: what children inherit is what they would get if everything were derived
// again; the cells that are written are those of the next level; Core equals the slow reference on
// all levels.
#include "CoreReference.h"
#include "CoreZoo.h"

using namespace coretest;

namespace
{

std::string Show(const Tuple& tuple)
{
  std::string text = "(";
  for (vtkIdType v : tuple)
  {
    text += " " + std::to_string(v);
  }
  return text + " )";
}

void ExpectSame(const Tuple& simplex, Stratum stratum, const Tuple& ring, const Expected& expected)
{
  EXPECT_EQ(static_cast<int>(stratum.GetRule()), static_cast<int>(expected.FollowedRule))
    << "rule of " << Show(simplex);
  EXPECT_EQ(stratum.GetType(), expected.Type) << "type of " << Show(simplex);
  EXPECT_EQ(ring, expected.Ring) << "ring of " << Show(simplex);
}

/// Edges by their vertices.
template <typename Id>
std::map<Tuple, Id> IndexEdges(const SimplicialComplex<Id>& complex)
{
  std::map<Tuple, Id> index;
  for (Id e = 0; e < complex.NumberOfEdges; ++e)
  {
    const Id* ends = complex.EdgeVertices.data() + 2 * vtkIdType(e);
    index[Sorted({ ends[0], ends[1] })] = e;
  }
  return index;
}

/// A Blend edge that is born inside a crowded face: what it inherits is the ring in the cells at
/// that face. Common neighbours of its ends with which it spans no face are not looked for after
/// the input.
Tuple DropUnspanned(const Level<int>& level, const Tuple& edge, const Tuple& ring)
{
  std::set<Tuple> faces;
  for (int f = 0; f < level.Complex.NumberOfFaces; ++f)
  {
    const int* v = level.Complex.FaceVertices.data() + 3 * f;
    faces.insert(Sorted({ v[0], v[1], v[2] }));
  }
  Tuple spanned;
  for (vtkIdType v : ring)
  {
    if (faces.count(Sorted({ edge[0], edge[1], v })) > 0)
    {
      spanned.push_back(v);
    }
  }
  return spanned;
}

/// Edges from `firstInner` on were born inside a face.
void ExpectReference(const Level<int>& level, const Reference& reference, int firstInner)
{
  ASSERT_EQ(level.Complex.NumberOfVertices, static_cast<int>(reference.Vertices.size()));
  for (int v = 0; v < level.Complex.NumberOfVertices; ++v)
  {
    ExpectSame(
      { v }, level.Strata.Vertices[v], GetRing(level.Strata.VertexRings, v), reference.Vertices[v]);
  }
  const auto edges = IndexEdges(level.Complex);
  ASSERT_EQ(static_cast<std::size_t>(level.Complex.NumberOfEdges), edges.size());
  ASSERT_EQ(edges.size(), reference.Edges.size());
  for (const auto& edge : edges)
  {
    const auto expected = reference.Edges.find(edge.first);
    ASSERT_NE(expected, reference.Edges.end()) << Show(edge.first);
    Expected same = expected->second;
    if (edge.second >= firstInner && same.FollowedRule == Rule::Blend)
    {
      same.Ring = DropUnspanned(level, edge.first, same.Ring);
    }
    ExpectSame(edge.first, level.Strata.Edges[edge.second],
      GetRing(level.Strata.EdgeRings, edge.second), same);
  }
}

/// Same strata and rings, whatever the edges are numbered.
void ExpectSameStrata(const Level<int>& inherited, const Level<int>& derived, int firstInner)
{
  ASSERT_EQ(inherited.Complex.NumberOfVertices, derived.Complex.NumberOfVertices);
  ASSERT_EQ(inherited.Complex.NumberOfFaces, derived.Complex.NumberOfFaces);
  ASSERT_EQ(inherited.Complex.NumberOfTets, derived.Complex.NumberOfTets);
  for (int v = 0; v < inherited.Complex.NumberOfVertices; ++v)
  {
    ExpectSame({ v }, inherited.Strata.Vertices[v], GetRing(inherited.Strata.VertexRings, v),
      { derived.Strata.Vertices[v].GetRule(), derived.Strata.Vertices[v].GetType(),
        GetRing(derived.Strata.VertexRings, v) });
  }
  const auto edges = IndexEdges(inherited.Complex);
  const auto others = IndexEdges(derived.Complex);
  ASSERT_EQ(edges.size(), others.size());
  for (const auto& edge : edges)
  {
    const auto other = others.find(edge.first);
    ASSERT_NE(other, others.end()) << Show(edge.first);
    const Stratum stratum = derived.Strata.Edges[other->second];
    Tuple ring = GetRing(derived.Strata.EdgeRings, other->second);
    if (edge.second >= firstInner && stratum.GetRule() == Rule::Blend)
    {
      ring = DropUnspanned(derived, edge.first, ring);
    }
    ExpectSame(edge.first, inherited.Strata.Edges[edge.second],
      GetRing(inherited.Strata.EdgeRings, edge.second),
      { stratum.GetRule(), stratum.GetType(), ring });
  }
}

/// Edges and faces of faces and tetrahedra are where the tables say; so are the carriers of rings.
void ExpectConsistent(const Level<int>& level)
{
  const auto& complex = level.Complex;
  auto ends = [&](int e)
  { return Sorted({ complex.EdgeVertices[2 * e], complex.EdgeVertices[2 * e + 1] }); };
  auto face = [&](int f)
  {
    const int* v = complex.FaceVertices.data() + 3 * f;
    return Sorted({ v[0], v[1], v[2] });
  };
  const int faceEdges[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };
  for (int f = 0; f < complex.NumberOfFaces; ++f)
  {
    const int* v = complex.FaceVertices.data() + 3 * f;
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_EQ(
        ends(complex.FaceEdges[3 * f + i]), Sorted({ v[faceEdges[i][0]], v[faceEdges[i][1]] }));
    }
  }
  std::vector<std::set<int>> tetsAt(complex.NumberOfFaces);
  const int tetEdges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  for (int t = 0; t < complex.NumberOfTets; ++t)
  {
    const int* v = complex.TetVertices.data() + 4 * t;
    for (int i = 0; i < 6; ++i)
    {
      ASSERT_EQ(
        ends(complex.TetEdges[6 * t + i]), Sorted({ v[tetEdges[i][0]], v[tetEdges[i][1]] }));
    }
    for (int i = 0; i < 4; ++i)
    {
      Tuple opposite(v, v + 4);
      opposite.erase(opposite.begin() + i);
      ASSERT_EQ(face(complex.TetFaces[4 * t + i]), Sorted(opposite));
      tetsAt[complex.TetFaces[4 * t + i]].insert(t);
    }
  }
  for (int f = 0; f < complex.NumberOfFaces; ++f)
  {
    const Row<int> tets = complex.FaceTets[f];
    ASSERT_EQ(std::set<int>(tets.begin(), tets.end()), tetsAt[f]);
    ASSERT_EQ(tets.size(), static_cast<vtkIdType>(tetsAt[f].size()));
  }
  for (int v = 0; v < complex.NumberOfVertices; ++v)
  {
    const Row<int> members = level.Strata.VertexRings.GetMembers(v);
    const Row<int> carriers = level.Strata.VertexRings.GetCarriers(v);
    for (int i = 0; i < members.size(); ++i)
    {
      ASSERT_EQ(ends(carriers.begin()[i]), Sorted({ v, members.begin()[i] }));
    }
  }
  for (int e = 0; e < complex.NumberOfEdges; ++e)
  {
    const Row<int> members = level.Strata.EdgeRings.GetMembers(e);
    const Row<int> carriers = level.Strata.EdgeRings.GetCarriers(e);
    for (int i = 0; i < members.size(); ++i)
    {
      if (carriers.begin()[i] >= 0)
      {
        Tuple all = ends(e);
        all.push_back(members.begin()[i]);
        ASSERT_EQ(face(carriers.begin()[i]), Sorted(all));
      }
    }
  }
}

}

TEST(CoreInheritance, InputEqualsReference)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      const Subdivided<int> input = Build<int>(mesh.Cells, mesh.Singular);
      ExpectReference(
        input.Level, Reference(mesh.Cells, mesh.Singular), input.Level.Complex.NumberOfEdges);
      ExpectConsistent(input.Level);
    });
}

TEST(CoreInheritance, ChildrenEqualDerivedAnew)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      Subdivided<int> level = Build<int>(mesh.Cells, mesh.Singular);
      std::set<Tuple> singular = mesh.Singular;
      const bool random = mesh.Name.compare(0, 6, "Random") == 0;
      for (int step = 1; step <= 2; ++step)
      {
        SCOPED_TRACE("level " + std::to_string(step));
        const SimplexList children = ReadChildren(level);
        singular = RefineSingular(level.Level.Complex, singular);
        const int firstInner = 2 * level.Level.Complex.NumberOfEdges;
        level = RefineOnce(level);
        ExpectConsistent(level.Level);
        const SimplexList cells = ReadCells(level);
        EXPECT_EQ(children.Dimensions, cells.Dimensions);
        EXPECT_EQ(children.Connectivity, cells.Connectivity);
        EXPECT_EQ(children.NumberOfPoints, cells.NumberOfPoints);
        const Subdivided<int> derived = Build<int>(cells, singular);
        ExpectSameStrata(level.Level, derived.Level, firstInner);
        const SimplexList again = ReadCells(derived);
        EXPECT_EQ(again.Connectivity, cells.Connectivity);
        if (step == 1 && (!random || mesh.Cells.GetNumberOfSimplices() < 40))
        {
          ExpectReference(level.Level, Reference(cells, singular), firstInner);
        }
        if (testing::Test::HasFailure() || random)
        {
          break;
        }
      }
    });
}

TEST(CoreInheritance, ChildrenOfEachCell)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      // In output order, by the lists of Mathematics 2, with the points found by name.
      const Subdivided<int> level = Build<int>(mesh.Cells, mesh.Singular);
      const auto edges = IndexEdges(level.Level.Complex);
      const auto points = static_cast<vtkIdType>(mesh.Cells.NumberOfPoints);
      auto x = [&](const Tuple& cell, int name)
      {
        const vtkIdType a = cell[name / 10];
        const vtkIdType b = cell[name % 10];
        return a == b ? a : points + edges.at(Sorted({ a, b }));
      };
      const std::vector<std::vector<std::vector<int>>> tables = { { { 0 } },
        { { 0, 1 }, { 1, 11 } }, { { 0, 1, 2 }, { 1, 11, 12 }, { 2, 12, 22 }, { 1, 12, 2 } },
        { { 0, 1, 2, 3 }, { 1, 11, 12, 13 }, { 2, 12, 22, 23 }, { 3, 13, 23, 33 }, { 1, 2, 3, 13 },
          { 12, 2, 1, 13 }, { 2, 3, 13, 23 }, { 13, 12, 2, 23 } } };
      std::vector<Tuple> expected;
      for (const Tuple& cell : GetCells(mesh.Cells))
      {
        for (const auto& child : tables[cell.size() - 1])
        {
          Tuple corners;
          for (int name : child)
          {
            corners.push_back(x(cell, name));
          }
          expected.push_back(corners);
        }
      }
      EXPECT_EQ(GetCells(ReadChildren(level)), expected);

      WrittenCells written(CountCells(RefineRuns(level.Runs, 1)));
      WriteChildren(level.Level.Complex, level.Runs, written.GetStorage());
      const unsigned char types[4] = { 1, 3, 5, 10 };
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        ASSERT_EQ(written.Types[i], types[expected[i].size() - 1]);
      }
    });
}

TEST(CoreInheritance, OutputDepthHasTheSameOperator)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      const Subdivided<int> input = Build<int>(mesh.Cells, mesh.Singular);
      const Subdivided<int> full = RefineOnce(input, Depth::ForRefinement);
      const Subdivided<int> flat = RefineOnce(input, Depth::ForOutput);
      EXPECT_EQ(ReadCells(full).Connectivity, ReadCells(flat).Connectivity);
      EXPECT_EQ(ReadChildren(full).Connectivity, ReadChildren(flat).Connectivity);
      auto equal = [](const Buffer<int>& a, const Buffer<int>& b)
      { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
      EXPECT_TRUE(
        equal(full.Level.Strata.VertexRings.Offsets, flat.Level.Strata.VertexRings.Offsets));
      EXPECT_TRUE(
        equal(full.Level.Strata.VertexRings.Members, flat.Level.Strata.VertexRings.Members));
      EXPECT_TRUE(equal(full.Level.Strata.EdgeRings.Offsets, flat.Level.Strata.EdgeRings.Offsets));
      EXPECT_TRUE(equal(full.Level.Strata.EdgeRings.Members, flat.Level.Strata.EdgeRings.Members));
      for (int v = 0; v < full.Level.Complex.NumberOfVertices; ++v)
      {
        ASSERT_EQ(full.Level.Strata.Vertices[v].GetRule(), flat.Level.Strata.Vertices[v].GetRule());
        ASSERT_EQ(full.Level.Strata.Vertices[v].GetType(), flat.Level.Strata.Vertices[v].GetType());
      }
      for (int e = 0; e < full.Level.Complex.NumberOfEdges; ++e)
      {
        ASSERT_EQ(full.Level.Strata.Edges[e].GetRule(), flat.Level.Strata.Edges[e].GetRule());
        ASSERT_EQ(full.Level.Strata.Edges[e].GetType(), flat.Level.Strata.Edges[e].GetType());
      }
    });
}
