// SPDX-License-Identifier: BSD-3-Clause
// Operators and cells that are made without being stored: they are those that Refine stores.
#include "TetOctTools.h"

#include "Core/Operators/ApplyRows.h"
#include "Core/Solids/Scheme/ChildRows.h"

#include <mutex>

using namespace tetoct_tools;

namespace
{

template <typename Scheme>
using RowsOf = ChildRows<typename Scheme::template Split<int>>;

/// Everything that makes a row.
struct RowContent
{
  char Kind = 0; ///< v, e, o; 0: not handed over
  int Rule = -1;
  int Type = -1;
  vtkIdType Column = -1; ///< of a vertex
  std::vector<int> Ends;
  std::vector<int> Ring;
  std::vector<int> Tets; ///< at the spokes of a control vertex
  bool operator==(const RowContent& other) const
  {
    return this->Kind == other.Kind && this->Rule == other.Rule && this->Type == other.Type &&
      this->Column == other.Column && this->Ends == other.Ends && this->Ring == other.Ring &&
      this->Tets == other.Tets;
  }
};

/// All rows in order; fails when one is not handed over exactly once.
std::vector<RowContent> Collect(const RingOperator<int>& operation)
{
  std::vector<RowContent> all(operation.GetNumberOfRows());
  std::mutex mutex;
  operation.ForRows(
    [&](const RingRows<int>& rows)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      for (vtkIdType i = 0; i < rows.Count; ++i)
      {
        ASSERT_LT(rows.FirstRow + i, static_cast<vtkIdType>(all.size()));
        RowContent& row = all[rows.FirstRow + i];
        ASSERT_EQ(row.Kind, 0) << rows.FirstRow + i;
        row.Kind = rows.OfCentres ? 'o' : rows.OfEdges ? 'e' : 'v';
        const Row<int> ring = rows.GetRing(i);
        row.Ring.assign(ring.begin(), ring.end());
        if (rows.OfCentres)
        {
          continue;
        }
        row.Rule = static_cast<int>(rows.Strata[i].GetRule());
        row.Type = rows.Strata[i].GetType();
        if (!rows.OfEdges)
        {
          row.Column = rows.GetColumn(i);
        }
        if (rows.OfEdges)
        {
          row.Ends.assign(rows.Ends + 2 * i, rows.Ends + 2 * i + 2);
        }
        else if (rows.HasCounts(i))
        {
          const int* tets = rows.Counts + rows.Offsets[i];
          row.Tets.assign(tets, tets + ring.size());
        }
      }
    });
  return all;
}

void Write(const Subdivided<int>& level, int depth, const std::vector<double>&, WrittenCells& cells)
{
  depth == 1 ? WriteChildren(level.Level.Complex, level.Runs, cells.GetStorage())
             : WriteGrandchildren(level.Level.Complex, level.Runs, cells.GetStorage());
}

void Write(
  const TetOctMesh<int>& level, int depth, const std::vector<double>& points, WrittenCells& cells)
{
  depth == 1 ? WriteTetOctChildren(level.Level, level.Runs, points.data(), cells.GetStorage())
             : WriteTetOctGrandchildren(level.Level, level.Runs, points.data(), cells.GetStorage());
}

/// The same cells, whichever diagonals of octahedra the points ask for.
template <typename AnyLevel>
void ExpectSameCells(
  const AnyLevel& level, const AnyLevel& children, const std::vector<double>& points)
{
  WrittenCells made(CountCells(RefineRuns(level.Runs, 2)));
  Write(level, 2, points, made);
  WrittenCells expected(CountCells(RefineRuns(children.Runs, 1)));
  Write(children, 1, points, expected);
  ASSERT_EQ(made.Connectivity, expected.Connectivity);
  ASSERT_EQ(made.Offsets, expected.Offsets);
  ASSERT_EQ(made.Types, expected.Types);
}

vtkIdType CountOctahedra(const Level<int>&)
{
  return 0;
}

vtkIdType CountOctahedra(const TetOctLevel<int>& level)
{
  return level.NumberOfOctahedra;
}

template <typename Scheme, typename AnyLevel>
void ExpectSameOnTheFly(const AnyLevel& level)
{
  const AnyLevel children = RefineOnce(level);
  const auto stored = Collect(LevelRows<int>(children.Level));
  const RowsOf<Scheme> rows(level.Level);
  const vtkIdType vertices = children.Level.Complex.NumberOfVertices;
  const vtkIdType edges = children.Level.Complex.NumberOfEdges;
  ASSERT_EQ(rows.GetNumberOfVertices(), vertices);
  ASSERT_EQ(rows.GetNumberOfEdges(), edges);
  ASSERT_EQ(rows.GetNumberOfRows(), vertices + edges + CountOctahedra(children.Level));
  const auto made = Collect(rows);
  ASSERT_EQ(made.size(), stored.size());
  for (std::size_t row = 0; row < stored.size(); ++row)
  {
    const auto at = static_cast<vtkIdType>(row);
    ASSERT_EQ(stored[row].Kind, at < vertices ? 'v' : at < vertices + edges ? 'e' : 'o') << row;
    ASSERT_TRUE(made[row] == stored[row]) << row;
  }
  if (HasEqualCells(level.Level.Complex))
  {
    return;
  }
  std::mt19937 random(5);
  std::vector<double> points(3 * stored.size());
  std::generate(points.begin(), points.end(), [&random] { return random() / 4294967296.; });
  ExpectSameCells(level, children, points);
  ExpectSameCells(level, children, std::vector<double>(points.size(), 1.)); // all diagonals tie
}

template <typename Scheme>
class ChildRowsOf : public testing::Test
{
};
using Schemes = testing::Types<OfBoxSpline, OfTetOct>;
TYPED_TEST_SUITE(ChildRowsOf, Schemes);

}

TYPED_TEST(ChildRowsOf, AreThoseOfTheStoredLevel)
{
  for (JointRule rule : { JointRule::Blend, JointRule::Sharp, JointRule::FollowDimension2 })
  {
    StrataOptions options;
    options.Type1 = options.Type2 = options.Type3 = rule;
    ForEachMesh(
      [&](const Mesh& mesh)
      {
        const auto level = TypeParam::Make(mesh, options);
        ExpectSameOnTheFly<TypeParam>(level);
        ExpectSameOnTheFly<TypeParam>(RefineOnce(level));
      });
  }
}

TYPED_TEST(ChildRowsOf, ManyBlocks)
{
  const auto level = TypeParam::Make(MakeLattice("many", 8, 1., 1).Control);
  ASSERT_GT(level.Level.Complex.NumberOfEdges, 2000);
  ExpectSameOnTheFly<TypeParam>(RefineOnce(level));
}

// What a filter does in its last two steps.
TYPED_TEST(ChildRowsOf, SumsAreThoseOfTheStoredOperators)
{
  const Mesh mesh = MakeLattice("Lattice", 4, 0.3, 11).Control;
  const auto level = RefineOnce(TypeParam::Make(mesh));
  std::mt19937 random(3);
  for (int components : { 1, 2, 3 })
  {
    std::vector<double> values(level.Level.Complex.NumberOfVertices * components);
    std::generate(values.begin(), values.end(), [&random] { return random() / 4294967296.; });
    auto apply = [components](const auto& operation, const std::vector<double>& in)
    {
      std::vector<double> out(operation.GetNumberOfRows() * components);
      operation.ForRows(
        [&](const RingRows<int>& rows) { SumRows(rows, in.data(), out.data(), components); });
      return out;
    };
    const std::vector<double> made =
      apply(RowsOf<TypeParam>(level.Level), apply(LevelRows<int>(level.Level), values));
    std::vector<double> expected = values;
    const auto children = RefineOnce(level);
    for (const auto* step : { &level, &children })
    {
      const Stencils<int> stencils = CopyStencils(step->Level);
      std::vector<double> next(stencils.GetNumberOfRows() * components);
      stencils.Apply(expected.data(), next.data(), components);
      expected = std::move(next);
    }
    ASSERT_EQ(made, expected);
  }
}

// The rows of each second part of the level, one after the other, are among those of all parts.
TEST(CoreChildRows, OfSelectedParts)
{
  const auto select = [](vtkIdType size)
  {
    Buffer<int> selected(size / 2);
    ForEach(selected.size(), [&](vtkIdType i) { selected[i] = static_cast<int>(2 * i + 1); });
    return selected;
  };
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    SCOPED_TRACE(mesh.Name);
    const Level<int> level = RefineOnce(Build<int>(mesh.Cells, mesh.Singular)).Level;
    const auto& complex = level.Complex;
    const Buffer<int> vertices = select(complex.NumberOfVertices);
    const Buffer<int> edges = select(complex.NumberOfEdges);
    const Buffer<int> faces = select(complex.NumberOfFaces);
    const Buffer<int> tets = select(complex.NumberOfTets);
    SimplicialComplex<int> part; // its numbers alone count
    part.NumberOfVertices = static_cast<int>(vertices.size());
    part.NumberOfEdges = static_cast<int>(edges.size());
    part.NumberOfFaces = static_cast<int>(faces.size());
    part.NumberOfTets = static_cast<int>(tets.size());
    using Rows = ChildRows<BoxSplineSplit<int>>;
    const Rows::Selected selection{ vertices, edges, faces, { &tets },
      Rows::Ids(part, { part.NumberOfTets }) };
    const Rows rows(level, &selection);
    const Rows all(level);
    ASSERT_EQ(rows.GetNumberOfColumns(), all.GetNumberOfColumns());
    const auto found = Collect(rows);
    const auto expected = Collect(all);
    std::vector<vtkIdType> numbers; // of the selected rows among all
    const auto add = [&](const Buffer<int>& selected, vtkIdType first, int ofEach)
    {
      for (const int i : selected)
      {
        for (int k = 0; k < ofEach; ++k)
        {
          numbers.push_back(first + vtkIdType(ofEach) * i + k);
        }
      }
    };
    const vtkIdType firstEdge = all.GetNumberOfVertices();
    const vtkIdType inFaces = firstEdge + 2 * vtkIdType(complex.NumberOfEdges);
    add(vertices, 0, 1);
    add(edges, complex.NumberOfVertices, 1);
    add(edges, firstEdge, 2);
    add(faces, inFaces, 3);
    add(tets, inFaces + 3 * vtkIdType(complex.NumberOfFaces), 1);
    ASSERT_EQ(found.size(), numbers.size());
    for (std::size_t row = 0; row < found.size(); ++row)
    {
      ASSERT_TRUE(found[row] == expected[numbers[row]]) << row;
    }
  }
}
