// SPDX-License-Identifier: BSD-3-Clause
// Red-green refinement of a mesh of which three states have parts: together they do what one state
// does that has all of it.
#include "CoreZoo.h"
#include "RedGreenChecks.h"

using namespace redgreen_reference;

namespace
{

/// Each cell is the own one of one part. A part splits those that share a vertex with its own
/// cells, too, and ignores the rest.
std::vector<CellScope> MakeScopes(
  const std::vector<Tuple>& cells, const std::vector<int>& owners, int part)
{
  std::set<vtkIdType> own;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    if (owners[c] == part)
    {
      own.insert(cells[c].begin(), cells[c].end());
    }
  }
  std::vector<CellScope> scopes;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const bool isNear =
      std::any_of(cells[c].begin(), cells[c].end(), [&](vtkIdType v) { return own.count(v) > 0; });
    scopes.push_back(owners[c] == part ? CellScope::Own
        : isNear                       ? CellScope::Copied
                                       : CellScope::Ignored);
  }
  return scopes;
}

/// A state, with the names of its leaves and vertices.
class NamedState
{
public:
  NamedState(const Mesh& mesh, std::vector<CellScope> scopes)
    : Scopes(std::move(scopes))
    , State(SimplexView(mesh.Cells))
    , Points(mesh.Points)
  {
    if (!this->Scopes.empty())
    {
      this->State.SetScopes(this->Scopes.data());
    }
    this->ReadKeys();
    for (int cell = 0; cell < static_cast<int>(this->State.GetNumberOfInputCells()); ++cell)
    {
      this->Leaves[ToNaive(this->State, { cell, -1 }, this->Keys)] = { cell, -1 };
    }
  }

  void ReadKeys()
  {
    this->Keys = MakeKeys(this->State);
    for (std::size_t v = this->Vertices.size(); v < this->Keys.size(); ++v)
    {
      this->Vertices.emplace(this->Keys[v], static_cast<int>(v));
    }
  }
  void Close()
  {
    this->State.Close();
    this->ReadKeys();
    for (const auto& cell : this->State.GetChangedCells())
    {
      this->Leaves[ToNaive(this->State, cell.Leaf, this->Keys)] = cell.Leaf;
    }
  }
  int Find(const Key& key) const
  {
    const auto found = this->Vertices.find(key);
    return found == this->Vertices.end() ? -1 : found->second;
  }
  bool IsOwn(vtkIdType cell) const
  {
    return this->Scopes.empty() || this->Scopes[static_cast<std::size_t>(cell)] == CellScope::Own;
  }
  Written<int> GetOutput() const { return Write(this->State, this->Points); }

  std::vector<CellScope> Scopes;
  RedGreen<int> State;
  std::vector<double> Points;
  std::vector<Key> Keys;
  std::map<Key, int> Vertices;
  std::map<NaiveLeaf, RedGreenLeaf<int>> Leaves;
  int NextToSend = 0;
};

/// Some states that tell each other of splits in their own cells.
class Together
{
public:
  Together(const Mesh& mesh, int parts, std::mt19937& random)
    : Cells(GetCells(mesh.Cells))
  {
    for (std::size_t c = 0; c < this->Cells.size(); ++c)
    {
      this->Owners.push_back(static_cast<int>(random() % static_cast<unsigned>(parts)));
    }
    for (int part = 0; part < parts; ++part)
    {
      this->Parts.push_back(
        std::make_unique<NamedState>(mesh, MakeScopes(this->Cells, this->Owners, part)));
      this->Parts.back()->NextToSend = this->Parts.back()->State.GetNumberOfInputVertices();
    }
  }

  NamedState& GetOwner(vtkIdType cell)
  {
    return *this->Parts[static_cast<std::size_t>(this->Owners[static_cast<std::size_t>(cell)])];
  }
  void Close()
  {
    for (bool isNew = true; isNew;)
    {
      isNew = false;
      for (const auto& part : this->Parts)
      {
        part->State.Propagate();
        part->ReadKeys();
      }
      for (const auto& part : this->Parts)
      {
        isNew = this->Send(*part) || isNew;
      }
    }
    for (const auto& part : this->Parts)
    {
      part->Close();
    }
  }

  std::vector<std::unique_ptr<NamedState>> Parts;

private:
  /// Returns whether anything was sent.
  bool Send(NamedState& from)
  {
    const int begin = from.NextToSend;
    from.ReadKeys();
    const int end = from.State.GetNumberOfVertices();
    for (int v = begin; v < end; ++v)
    {
      bool isOwn = false;
      from.State.ForInputCells(v, [&](int cell) { isOwn = isOwn || from.IsOwn(cell); });
      const auto ends = from.State.GetEnds(v);
      for (const auto& to : this->Parts)
      {
        if (isOwn && to.get() != &from)
        {
          this->Receive(*to, from.Keys[static_cast<std::size_t>(ends[0])],
            from.Keys[static_cast<std::size_t>(ends[1])]);
        }
      }
    }
    from.NextToSend = end;
    return end > begin;
  }
  void Receive(NamedState& to, const Key& a, const Key& b)
  {
    const int ends[2] = { to.Find(a), to.Find(b) };
    const bool hasEdge = this->HasCell(to, Support({ a, b }));
    if (ends[0] < 0 || ends[1] < 0)
    {
      ASSERT_FALSE(hasEdge);
      return;
    }
    ASSERT_EQ(to.State.SplitEdge(ends[0], ends[1]), hasEdge);
    to.ReadKeys();
    ASSERT_EQ(to.Find(Middle(a, b)) >= 0, hasEdge);
  }
  /// Whether a state splits an input cell with these vertices.
  bool HasCell(const NamedState& state, const Tuple& vertices) const
  {
    for (std::size_t c = 0; c < this->Cells.size(); ++c)
    {
      const Tuple cell = Sorted(this->Cells[c]);
      if (state.Scopes[c] != CellScope::Ignored &&
        std::includes(cell.begin(), cell.end(), vertices.begin(), vertices.end()))
      {
        return true;
      }
    }
    return false;
  }

  std::vector<Tuple> Cells;
  std::vector<int> Owners;
};

/// Marks a cell of the output or an edge of it, in the state that has all and in the part that owns
/// it.
void MarkInBoth(NamedState& whole, Together& parts, std::mt19937& random)
{
  const Written<int> output = whole.GetOutput();
  const std::size_t i = random() % output.InputCells.size();
  const Cell points = output.GetPointsOfCells()[i];
  NaiveLeaf leaf{ output.InputCells[i], output.Levels[i], points };
  const vtkIdType green = output.GreenParents[i];
  if (green >= 0)
  {
    leaf.Points = output.GetPoints(output.GreenLeaves[static_cast<std::size_t>(green)]);
  }
  NamedState& owner = parts.GetOwner(leaf.Input);
  ASSERT_EQ(owner.Leaves.count(leaf), 1u);
  if (green < 0 && random() % 2)
  {
    whole.State.MarkCell(whole.Leaves.at(leaf));
    owner.State.MarkCell(owner.Leaves.at(leaf));
  }
  else if (points.size() > 1)
  {
    const std::size_t a = random() % points.size();
    const std::size_t b = (a + 1 + random() % (points.size() - 1)) % points.size();
    for (NamedState* state : { &whole, &owner })
    {
      state->State.MarkEdge(state->Leaves.at(leaf), state->Find(points[a]), state->Find(points[b]));
    }
  }
}

std::set<NaiveLeaf> GetLeavesOf(const Written<int>& output, const NamedState& part)
{
  std::set<NaiveLeaf> leaves;
  for (const NaiveLeaf& leaf : output.GetLeaves())
  {
    if (part.IsOwn(leaf.Input))
    {
      leaves.insert(leaf);
    }
  }
  return leaves;
}

void CheckPart(const NamedState& part, const Written<int>& expected)
{
  const Written<int> output = part.GetOutput();
  ASSERT_EQ(GetLeavesOf(output, part), GetLeavesOf(expected, part));
  const auto own = std::count_if(output.InputCells.begin(), output.InputCells.end(),
    [&](vtkIdType cell) { return part.IsOwn(cell); });
  ASSERT_EQ(part.State.GetNumberOfCells(), own);
  for (std::size_t i = 0; i < output.InputCells.size(); ++i)
  {
    if (part.Scopes[static_cast<std::size_t>(output.InputCells[i])] == CellScope::Ignored)
    {
      ASSERT_EQ(output.Kinds[i], static_cast<unsigned char>(RefinementKind::Untouched));
    }
  }
}

class RedGreenScopesOfZoo : public testing::TestWithParam<std::string>
{
};

}

TEST_P(RedGreenScopesOfZoo, PartsDoWhatTheWholeDoes)
{
  const Mesh mesh = FindInZoo(GetParam());
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    NamedState whole(mesh, {});
    Together parts(mesh, 3, random);
    const bool isEmpty = mesh.Cells.GetNumberOfSimplices() == 0;
    for (int round = 0; round < 4 && !isEmpty && whole.State.GetNumberOfCells() < 400; ++round)
    {
      ASSERT_NO_FATAL_FAILURE(MarkInBoth(whole, parts, random));
      whole.Close();
      ASSERT_NO_FATAL_FAILURE(parts.Close());
      const Written<int> expected = whole.GetOutput();
      for (const auto& part : parts.Parts)
      {
        ASSERT_NO_FATAL_FAILURE(CheckPart(*part, expected)) << "round " << round;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, RedGreenScopesOfZoo, testing::ValuesIn(GetNamesOfZoo(60)),
  [](const auto& instance) { return instance.param; });
