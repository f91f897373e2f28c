// SPDX-License-Identifier: BSD-3-Clause
// Operators and cells that are made without being stored: they are those that Refine stores.
#include "Core/Solids/Scheme/ChildRows.h"
#include "CoreZoo.h"

#include <gtest/gtest.h>

#include <mutex>

using namespace coretest;

namespace
{

/// Everything that makes a row.
struct RowContent
{
  int Rule = -1;
  int Type = -1;
  vtkIdType Column = -1; ///< of a vertex
  std::vector<int> Ends;
  std::vector<int> Ring;
  bool operator==(const RowContent& other) const
  {
    return this->Rule == other.Rule && this->Type == other.Type && this->Column == other.Column &&
      this->Ends == other.Ends && this->Ring == other.Ring;
  }
};

/// All rows in order; fails when one is not handed over exactly once.
std::vector<RowContent> Collect(const RingOperator<int>& operation, vtkIdType vertices)
{
  std::vector<RowContent> all(operation.GetNumberOfRows());
  std::mutex mutex;
  operation.ForRows(
    [&](const RingRows<int>& rows)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      for (vtkIdType i = 0; i < rows.Count; ++i)
      {
        const vtkIdType row = rows.FirstRow + i;
        ASSERT_LT(row, static_cast<vtkIdType>(all.size()));
        ASSERT_EQ(rows.OfEdges, row >= vertices);
        ASSERT_EQ(all[row].Rule, -1) << row;
        all[row].Rule = static_cast<int>(rows.Strata[i].GetRule());
        all[row].Type = rows.Strata[i].GetType();
        if (rows.OfEdges)
        {
          all[row].Ends.assign(rows.Ends + 2 * i, rows.Ends + 2 * i + 2);
        }
        else
        {
          all[row].Column = rows.GetColumn(i);
        }
        const Row<int> ring = rows.GetRing(i);
        all[row].Ring.assign(ring.begin(), ring.end());
      }
    });
  return all;
}

void ExpectSameOnTheFly(const Subdivided<int>& level)
{
  const Subdivided<int> children = RefineOnce(level);
  const vtkIdType vertices = children.Level.Complex.NumberOfVertices;
  const auto stored = Collect(LevelRows<int>(children.Level), vertices);
  ASSERT_EQ(static_cast<vtkIdType>(stored.size()), vertices + children.Level.Complex.NumberOfEdges);
  for (std::size_t row = 0; row < stored.size(); ++row)
  {
    ASSERT_GE(stored[row].Rule, 0) << row;
  }
  const auto made = Collect(ChildRows<BoxSplineSplit<int>>(level.Level), vertices);
  ASSERT_EQ(made.size(), stored.size());
  for (std::size_t row = 0; row < stored.size(); ++row)
  {
    ASSERT_TRUE(made[row] == stored[row]) << row;
  }
  if (!HasEqualCells(level.Level.Complex))
  {
    WrittenCells written(CountCells(RefineRuns(level.Runs, 2)));
    WriteGrandchildren(level.Level.Complex, level.Runs, written.GetStorage());
    WrittenCells expected(CountCells(RefineRuns(children.Runs, 1)));
    WriteChildren(children.Level.Complex, children.Runs, expected.GetStorage());
    ASSERT_EQ(written.Connectivity, expected.Connectivity);
    ASSERT_EQ(written.Offsets, expected.Offsets);
    ASSERT_EQ(written.Types, expected.Types);
  }
}

}

TEST(CoreChildRows, AreThoseOfTheStoredLevel)
{
  for (JointRule rule : { JointRule::Blend, JointRule::Sharp, JointRule::FollowDimension2 })
  {
    StrataOptions options;
    options.Type1 = options.Type2 = options.Type3 = rule;
    for (const Mesh& mesh : MakeZooAndRandom())
    {
      SCOPED_TRACE(mesh.Name);
      const Subdivided<int> level = Build<int>(mesh.Cells, mesh.Singular, options);
      ExpectSameOnTheFly(level);
      ExpectSameOnTheFly(RefineOnce(level));
    }
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
    const auto found = Collect(rows, rows.GetNumberOfVertices());
    const auto expected = Collect(all, all.GetNumberOfVertices());
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

TEST(CoreChildRows, ManyBlocks)
{
  const Mesh mesh = MakeLattice("many", 8, 1., 1).Control;
  const Subdivided<int> level = Build<int>(mesh.Cells, mesh.Singular);
  ASSERT_GT(level.Level.Complex.NumberOfEdges, 2000);
  ExpectSameOnTheFly(RefineOnce(level));
}
