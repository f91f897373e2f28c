// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenClosure.cxx
 * Random marks over six rounds on every complex of the zoo: the leaves are those of the definition,
 * the output is conforming, nothing is inverted, volume and quality are kept.
 */
#include "CoreZoo.h"
#include "RedGreenChecks.h"

using namespace redgreen_reference;

namespace
{

/// Core and definition side by side.
template <typename Id>
class SideBySide
{
public:
  SideBySide(const Mesh& mesh, unsigned int seed)
    : Input(mesh.Cells)
    , Points(mesh.Points)
    , Random(seed)
    , State(SimplexView(mesh.Cells))
    , Naive(mesh.Cells)
    , Output(Write(this->State, this->Points))
  {
    for (Id i = 0; i < static_cast<Id>(mesh.Cells.GetNumberOfSimplices()); ++i)
    {
      this->Handles[ToNaive(this->State, { i, -1 }, this->Output.Keys)] = { i, -1 };
    }
  }

  void Round(int marks)
  {
    const auto points = this->Output.GetPointsOfCells();
    const std::size_t splits = this->Naive.Splits.size();
    for (int i = 0; i < marks && !points.empty(); ++i)
    {
      this->Mark(points);
    }
    const bool hasSplit = this->State.Close();
    this->Naive.Close();
    ASSERT_EQ(hasSplit, this->Naive.Splits.size() > splits);
    const auto before = GetNames(this->Output);
    this->Output = Write(this->State, this->Points);
    for (const auto& cell : this->State.GetChangedCells())
    {
      this->Handles[ToNaive(this->State, cell.Leaf, this->Output.Keys)] = cell.Leaf;
    }
    this->CheckChanges(before);
  }

  void Check() const
  {
    ASSERT_EQ(this->State.GetNumberOfCells(), this->Output.Cells.GetNumberOfSimplices());
    ASSERT_EQ(this->Output.GetLeaves(), this->Naive.Leaves);
    for (Id i = 0; i < static_cast<Id>(this->Input.GetNumberOfSimplices()); ++i)
    {
      const NaiveLeaf whole = ToNaive(this->State, { i, -1 }, this->Output.Keys);
      ASSERT_EQ(this->State.IsRed(i), this->Naive.Leaves.count(whole) == 0) << "input cell " << i;
    }
    CheckConforming(this->Input, this->Output);
    CheckArrays(this->Input, this->Output);
    this->CheckOrigins();
  }
  void CheckSpace() const { CheckShape(this->Input, this->Points, this->Output); }

  vtkIdType GetNumberOfCells() const { return this->State.GetNumberOfCells(); }
  const Written<Id>& GetOutput() const { return this->Output; }

private:
  using Name = std::tuple<vtkIdType, int, Cell>;
  static std::set<Name> GetNames(const Written<Id>& output)
  {
    std::set<Name> names;
    const auto points = output.GetPointsOfCells();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      names.insert(Name(output.InputCells[i], output.Kinds[i], points[i]));
    }
    return names;
  }

  /// A cell of the output or one of its edges, green or not.
  void Mark(const std::vector<Cell>& points)
  {
    const std::size_t i = this->Random() % points.size();
    NaiveLeaf leaf{ this->Output.InputCells[i], this->Output.Levels[i], points[i] };
    const vtkIdType green = this->Output.GreenParents[i];
    if (green >= 0)
    {
      leaf.Points = this->Output.GetPoints(this->Output.GreenLeaves[green]);
    }
    const auto found = this->Handles.find(leaf);
    ASSERT_NE(found, this->Handles.end());
    if (green < 0 && this->Random() % 2)
    {
      this->State.MarkCell(found->second);
      this->Naive.MarkCell(leaf);
      if (found->second.Child < 0 && leaf.Points.size() > 1 && this->Random() % 2)
      {
        // A child of what has just become red, in the same round.
        const auto children = RedChildren(leaf.Points);
        const std::size_t child = this->Random() % children.size();
        this->State.MarkCell({ found->second.Cell, static_cast<int>(child) });
        this->Naive.MarkLater(children[child]);
      }
      return;
    }
    const Tuple cell = GetCells(this->Output.Cells)[i];
    const bool all = this->Random() % 2 > 0;
    const int chosen = this->Random() % 6;
    int edge = 0;
    for (std::size_t a = 0; a < cell.size(); ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        if (all || edge++ == chosen)
        {
          this->State.MarkEdge(found->second, static_cast<Id>(cell[a]), static_cast<Id>(cell[b]));
          this->Naive.MarkEdge(leaf, MakePair(points[i][a], points[i][b]));
        }
      }
    }
  }

  /// The changed cells are those that the output did not have.
  void CheckChanges(const std::set<Name>& before) const
  {
    std::set<Name> expected;
    for (const Name& name : GetNames(this->Output))
    {
      if (!before.count(name))
      {
        expected.insert(name);
      }
    }
    std::set<Name> changed;
    for (const auto& cell : this->State.GetChangedCells())
    {
      Cell points;
      for (int i = 0; i <= cell.Dimension; ++i)
      {
        points.push_back(this->Output.Keys[cell.Vertices[i]]);
      }
      changed.insert(
        Name(this->State.GetCell(cell.Leaf).Input, static_cast<int>(cell.Kind), points));
    }
    ASSERT_EQ(changed, expected);
  }

  void CheckOrigins() const
  {
    for (Id v = this->State.GetNumberOfInputVertices(); v < this->State.GetNumberOfVertices(); ++v)
    {
      const auto origin = this->State.GetOrigin(v);
      const auto cell = this->State.GetCell(origin.Cell);
      const int* ends = cell.Dimension == 3 ? tetrahedron::EdgeVertices[origin.Edge]
                                            : triangle::EdgeVertices[origin.Edge];
      const auto& keys = this->Output.Keys;
      ASSERT_EQ(keys[v], Middle(keys[cell.Vertices[ends[0]]], keys[cell.Vertices[ends[1]]]));
      for (Id end : this->State.GetEnds(v))
      {
        ASSERT_LT(end, v);
      }
      // From the root to the cell by child numbers.
      std::vector<int> path;
      auto at = cell;
      while (at.Parent >= 0)
      {
        path.insert(path.begin(), at.Child);
        ASSERT_EQ(at.Level, this->State.GetCell(at.Parent).Level + 1);
        at = this->State.GetCell(at.Parent);
      }
      Cell points = ToNaive(this->State, { at.Input, -1 }, keys).Points;
      for (int child : path)
      {
        points = RedChildren(points)[child];
      }
      ASSERT_EQ(points, ToNaive(this->State, { origin.Cell, -1 }, keys).Points);
    }
  }

  SimplexList Input;
  std::vector<double> Points;
  std::mt19937 Random;
  RedGreen<Id> State;
  NaiveRedGreen Naive;
  Written<Id> Output;
  std::map<NaiveLeaf, RedGreenLeaf<Id>> Handles;
};

class RedGreenOfZoo : public testing::TestWithParam<std::string>
{
};

template <typename Id>
void RunRounds(const Mesh& mesh, unsigned int seed)
{
  SideBySide<Id> both(mesh, seed);
  for (int round = 0; round < 6 && both.GetNumberOfCells() < 1200; ++round)
  {
    both.Round(1 + static_cast<int>(seed % 2));
    ASSERT_NO_FATAL_FAILURE(both.Check()) << "seed " << seed << " round " << round;
  }
  ASSERT_NO_FATAL_FAILURE(both.CheckSpace()) << "seed " << seed;
}

}

TEST_P(RedGreenOfZoo, EqualsDefinition)
{
  for (unsigned int seed = 1; seed <= 2 && !HasFatalFailure(); ++seed)
  {
    RunRounds<int>(FindInZoo(GetParam()), seed);
  }
}

TEST_P(RedGreenOfZoo, EqualsDefinitionLongLong)
{
  RunRounds<long long>(FindInZoo(GetParam()), 3);
}

INSTANTIATE_TEST_SUITE_P(Zoo, RedGreenOfZoo, testing::ValuesIn(GetNamesOfZoo(60)),
  [](const auto& instance) { return instance.param; });
