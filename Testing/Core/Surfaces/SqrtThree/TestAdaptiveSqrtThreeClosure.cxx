// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 11: the closure of adaptive sqrt(3), face by face and edge by edge. Split everywhere,
// the mesh is that of the uniform scheme; split anywhere, it is the smallest closed part of that.
#include "AdaptiveSurfaceTools.h"

using namespace surfacetools;

namespace
{

using Mesh = AdaptiveSqrtThree<int>;
constexpr int MostLevel = 4;

std::map<std::string, Model> MakeClosureZoo()
{
  std::map<std::string, Model> zoo = MakeZoo(true);
  zoo["fan of 7"] = MakeFan(7, false);
  zoo["half fan of 4"] = MakeFan(4, true);
  zoo["equal lines"] = zoo["free line"];
  zoo["equal lines"].Lines = { { 0, 3 }, { 3, 0 }, { 0, 3 }, { 1, 2 }, { 2, 1 } };
  return zoo;
}

/// Which vertex of one mesh is which of another one, learnt where they have to be the same.
class SameVertices
{
public:
  explicit SameVertices(vtkIdType control)
  {
    for (int v = 0; v < control; ++v)
    {
      this->Expect(v, v);
    }
  }
  void Expect(int one, int other)
  {
    ASSERT_EQ(this->Forward.emplace(one, other).first->second, other) << "vertex " << one;
    ASSERT_EQ(this->Backward.emplace(other, one).first->second, one) << "vertex " << one;
  }

private:
  std::map<int, int> Forward;
  std::map<int, int> Backward;
};

/// Which child of its parent a face is: that across the edge of this corner.
int GetSlot(const Mesh& mesh, int face)
{
  return face - mesh.GetChild(3 * mesh.GetParent(face));
}

/// The faces between which a face lies.
std::vector<int> GetParents(const Mesh& mesh, int face)
{
  if (face < mesh.GetNumberOfControlFaces())
  {
    return {};
  }
  const int parent = mesh.GetParent(face);
  const int twin = mesh.GetTwin(3 * parent + GetSlot(mesh, face));
  return twin < 0 ? std::vector<int>{ parent } : std::vector<int>{ parent, twin / 3 };
}

/// Adds a face, and all that must be split before or with it, to a set of faces of a mesh that is
/// split everywhere.
void Close(const Mesh& full, int face, std::set<int>& split)
{
  if (!split.insert(face).second)
  {
    return;
  }
  std::vector<int> neighbours{ face }; // have to be there
  for (int corner = 3 * face; corner < 3 * face + 3; ++corner)
  {
    if (!full.IsFixed(corner))
    {
      neighbours.push_back(full.GetTwin(corner) / 3);
    }
  }
  for (int neighbour : neighbours)
  {
    for (int parent : GetParents(full, neighbour))
    {
      Close(full, parent, split);
    }
  }
  if (full.IsCut(face))
  {
    const Mesh::Segment& segment = full.GetSegmentAt(full.GetSegment(3 * face));
    for (int i = 0; i < segment.NumberOfSides; ++i)
    {
      const int side = full.GetSide(segment, i);
      Close(full, side / 3, split);
      Close(full, full.GetChild(side), split);
    }
  }
}

/// A mesh beside one that is split everywhere.
class Part
{
public:
  Part(const Mesh& mesh, const Mesh& full)
    : Own(mesh)
    , Full(full)
    , Vertices(mesh.GetNumberOfControlVertices())
  {
    this->Same.assign(static_cast<std::size_t>(mesh.GetNumberOfFaces()), -1);
    for (int face = 0; face < mesh.GetNumberOfControlFaces(); ++face)
    {
      this->Add(face, face);
    }
    for (int face : mesh.GetNewFaces())
    {
      const int parent = this->Same[static_cast<std::size_t>(mesh.GetParent(face))];
      this->Add(face, full.GetChild(3 * parent + GetSlot(mesh, face)));
    }
    const vtkIdType control = CountControlSegments(full);
    for (int s = 0; s < control; ++s)
    {
      this->AddSegment(s, s);
    }
  }

  int GetSame(int face) const { return this->Same[static_cast<std::size_t>(face)]; }

  void Check(const std::set<int>& split)
  {
    ASSERT_EQ(
      this->There.size(), this->Own.GetNewFaces().size() + this->Own.GetNumberOfControlFaces());
    for (int same = 0; same < this->Full.GetNumberOfFaces(); ++same)
    {
      const std::vector<int> parents = GetParents(this->Full, same);
      const bool isThere = std::all_of(
        parents.begin(), parents.end(), [&](int parent) { return split.count(parent) > 0; });
      ASSERT_EQ(this->There.count(same) > 0, isThere) << "face " << same;
    }
    for (const auto& [same, face] : this->There)
    {
      ASSERT_EQ(this->Own.IsSplit(face), split.count(same) > 0) << "face " << same;
      this->CheckFace(face, same);
    }
    for (const auto& [segment, same] : this->Segments)
    {
      this->CheckSegment(this->Own.GetSegmentAt(segment), this->Full.GetSegmentAt(same));
    }
    ASSERT_EQ(static_cast<vtkIdType>(this->Segments.size()), this->Own.GetNumberOfSegments());
  }

private:
  static vtkIdType CountControlSegments(const Mesh& mesh)
  {
    vtkIdType count = 0;
    while (
      count < mesh.GetNumberOfSegments() && mesh.GetSegmentAt(static_cast<int>(count)).Parent < 0)
    {
      ++count;
    }
    return count;
  }
  void Add(int face, int same)
  {
    this->Same[static_cast<std::size_t>(face)] = same;
    EXPECT_TRUE(this->There.emplace(same, face).second) << "face " << same;
  }
  void AddSegment(int segment, int same)
  {
    this->Segments[segment] = same;
    const Mesh::Segment& own = this->Own.GetSegmentAt(segment);
    const Mesh::Segment& other = this->Full.GetSegmentAt(same);
    for (int j = 0; own.Thirds >= 0 && j < 3; ++j)
    {
      EXPECT_EQ(this->Own.GetSegmentAt(own.Children + j).Parent, segment);
      this->AddSegment(own.Children + j, other.Children + j);
    }
  }

  void CheckFace(int face, int same)
  {
    ASSERT_TRUE(this->Own.IsThere(face));
    ASSERT_EQ(this->Own.GetLevel(face), this->Full.GetLevel(same));
    for (int i = 0; i < 3; ++i)
    {
      const int corner = 3 * face + i;
      this->Vertices.Expect(this->Own.GetVertex(corner), this->Full.GetVertex(3 * same + i));
      ASSERT_EQ(this->Own.GetVertices(face)[i], this->Own.GetVertex(corner));
      this->CheckTwin(corner, 3 * same + i);
      if (this->Own.IsSplit(face))
      {
        const bool isMiddle = this->Own.IsCut(face) && i == 0;
        if (!isMiddle)
        {
          this->Vertices.Expect(this->Own.GetApex(corner), this->Full.GetApex(3 * same + i));
        }
        ASSERT_EQ(this->Own.GetParent(this->Own.GetChild(corner)), face);
      }
    }
    if (this->Own.IsSplit(face) && !this->Own.IsCut(face))
    {
      const Mesh::Vertex& centre = this->Own.GetAdded(this->Own.GetApex(3 * face));
      ASSERT_EQ(centre.Source, face);
      ASSERT_EQ(centre.Level, this->Own.GetLevel(face) + 1);
      ASSERT_FALSE(centre.IsSecond);
    }
  }

  void CheckTwin(int corner, int same)
  {
    const int twin = this->Own.GetTwin(corner);
    const int other = this->Full.GetTwin(same);
    ASSERT_EQ(this->Own.IsFixed(corner), this->Full.IsFixed(same));
    if (this->Full.IsFixed(same))
    {
      // A segment is that of an even level.
      const auto found = this->Segments.find(this->Own.GetSegment(corner));
      ASSERT_NE(found, this->Segments.end());
      ASSERT_EQ(found->second, this->Full.GetSegment(same));
      return;
    }
    const auto neighbour = this->There.find(other / 3);
    if (neighbour != this->There.end())
    {
      ASSERT_EQ(twin, 3 * neighbour->second + other % 3);
      ASSERT_EQ(this->Own.IsExchanged(corner), this->Full.IsExchanged(same));
      return;
    }
    ASSERT_EQ(twin, -1);
    // What has to be split is there, is whole, and is a parent of the face that is missing.
    const int missing = this->Own.GetTwin(this->Own.FindMissing(corner)) / 3;
    ASSERT_GE(missing, 0);
    ASSERT_TRUE(this->Own.IsThere(missing));
    ASSERT_FALSE(this->Own.IsSplit(missing));
    const std::vector<int> parents = GetParents(this->Full, other / 3);
    ASSERT_EQ(std::count(parents.begin(), parents.end(), this->GetSame(missing)), 1);
  }

  void CheckSegment(const Mesh::Segment& own, const Mesh::Segment& other)
  {
    ASSERT_EQ(own.Level, other.Level);
    ASSERT_EQ(own.NumberOfLines, other.NumberOfLines);
    ASSERT_EQ(own.NumberOfSides, other.NumberOfSides);
    for (int end = 0; end < 2; ++end)
    {
      this->Vertices.Expect(own.Ends[end], other.Ends[end]);
      if (own.Thirds >= 0)
      {
        this->Vertices.Expect(own.Thirds + end, other.Thirds + end);
        const Mesh::Vertex& third = this->Own.GetAdded(own.Thirds + end);
        ASSERT_EQ(&this->Own.GetSegmentAt(-1 - third.Source), &own);
        ASSERT_EQ(third.Level, own.Level + 2);
        ASSERT_EQ(third.IsSecond, end == 1);
      }
    }
    for (int i = 0; i < own.NumberOfSides; ++i)
    {
      const int side = this->Own.GetSide(own, i);
      const int expected = this->Full.GetSide(other, i);
      const auto found = this->There.find(expected / 3);
      ASSERT_GE(expected, 0);
      ASSERT_EQ(side, found == this->There.end() ? -1 : 3 * found->second + expected % 3);
      if (side < 0)
      {
        const int missing = this->Own.FindMissingSide(own, i);
        ASSERT_TRUE(this->Own.IsThere(missing));
        ASSERT_FALSE(this->Own.IsSplit(missing));
        const std::vector<int> parents = GetParents(this->Full, expected / 3);
        ASSERT_EQ(std::count(parents.begin(), parents.end(), this->GetSame(missing)), 1);
      }
    }
  }

  const Mesh& Own;
  const Mesh& Full;
  std::vector<int> Same;       ///< the face of the full mesh that a face is, -1
  std::map<int, int> There;    ///< the other way round
  std::map<int, int> Segments; ///< the segment of the full mesh that a segment is
  SameVertices Vertices;
};

/// The cells that the output would have.
vtkIdType CountCells(const Adaptive& adaptive)
{
  Mesh mesh = adaptive.Mesh;
  const AdaptiveSqrtThreeOutput<int> output(mesh);
  std::vector<AdaptiveSqrtThreeOutput<int>::Piece> pieces;
  for (int line : adaptive.Control.Level.Lines)
  {
    output.AppendPieces(line, pieces);
  }
  return output.GetNumberOfTriangles() + static_cast<vtkIdType>(pieces.size());
}

}

TEST(AdaptiveSqrtThreeClosure, SplitEverywhereEachFaceIsThatOfTheUniformMesh)
{
  for (const auto& [name, model] : MakeClosureZoo())
  {
    SCOPED_TRACE(name);
    Adaptive adaptive(model);
    adaptive.SplitTo(MostLevel);
    const Mesh& mesh = adaptive.Mesh;
    Walk uniform(model, SurfaceSchemeKind::SqrtThree);
    std::map<int, int> numbers; // of the faces of a level, in the uniform mesh
    for (int face = 0; face < mesh.GetNumberOfControlFaces(); ++face)
    {
      numbers[face] = face;
    }
    SameVertices vertices(mesh.GetNumberOfControlVertices());
    for (int level = 0; level <= MostLevel; ++level)
    {
      const PolygonMesh<int>& expected = uniform.Level.Mesh;
      ASSERT_EQ(static_cast<vtkIdType>(numbers.size()), expected.NumberOfFaces);
      std::map<int, int> children;
      for (const auto& [face, number] : numbers)
      {
        ASSERT_EQ(mesh.GetLevel(face), level);
        for (int i = 0; i < 3; ++i)
        {
          const int corner = 3 * number + i;
          vertices.Expect(mesh.GetVertex(3 * face + i), expected.Vertices[corner]);
          const bool isFixed = IsSharp(uniform.Level.Tags.Edges[expected.Edges[corner]]);
          ASSERT_EQ(mesh.IsFixed(3 * face + i), isFixed);
          if (level == 0)
          {
            const int segment = mesh.GetSegmentOfEdge(expected.Edges[corner]);
            ASSERT_EQ(segment, isFixed ? mesh.GetSegment(3 * face + i) : -1);
          }
          if (!isFixed)
          {
            const int twin = mesh.GetTwin(3 * face + i);
            ASSERT_EQ(3 * numbers.at(twin / 3) + twin % 3, expected.Twins[corner]);
            const int other = numbers.at(twin / 3);
            ASSERT_EQ(mesh.IsBefore(face, twin / 3), number < other);
            ASSERT_EQ(mesh.IsBefore(twin / 3, face), other < number);
          }
          if (level < MostLevel)
          {
            children[mesh.GetChild(3 * face + i)] = corner;
          }
        }
      }
      numbers = children;
      uniform.Step();
    }
  }
}

TEST(AdaptiveSqrtThreeClosure, SplitsAreTheSmallestClosedSet)
{
  for (const auto& [name, model] : MakeClosureZoo())
  {
    Adaptive full(model);
    full.SplitTo(MostLevel);
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      Adaptive adaptive(model);
      std::set<int> expected;
      for (int step = 0; step < 6; ++step)
      {
        std::vector<int> whole;
        for (int face = 0; face < adaptive.Mesh.GetNumberOfFaces(); ++face)
        {
          if (adaptive.Mesh.IsThere(face) && !adaptive.Mesh.IsSplit(face) &&
            adaptive.Mesh.GetLevel(face) < MostLevel)
          {
            whole.push_back(face);
          }
        }
        // Often one of those that were made last, which are deep.
        const std::size_t some =
          random() % 2 ? whole.size() : std::min<std::size_t>(3, whole.size());
        const int face = whole[whole.size() - 1 - random() % some];
        Close(full.Mesh, Part(adaptive.Mesh, full.Mesh).GetSame(face), expected);
        const Mesh before = adaptive.Mesh;
        ASSERT_TRUE(adaptive.Mesh.Split(face));
        ASSERT_NO_FATAL_FAILURE(Part(adaptive.Mesh, full.Mesh).Check(expected));
        const vtkIdType cells = adaptive.Mesh.GetNumberOfCells();
        ASSERT_EQ(cells, CountCells(adaptive));
        // The same with just enough cells, and with one less.
        Mesh again = before;
        ASSERT_TRUE(again.Split(face, cells));
        ASSERT_EQ(again.GetNewFaces(), adaptive.Mesh.GetNewFaces());
        again = before;
        ASSERT_FALSE(again.Split(face, cells - 1));
        ASSERT_LT(again.GetNumberOfCells(), cells);
      }
    }
  }
}

TEST(AdaptiveSqrtThreeClosure, ASegmentWithoutFacesIsCutAlone)
{
  for (const auto& [name, lines] : { std::pair("free line", 1), std::pair("equal lines", 3) })
  {
    SCOPED_TRACE(name);
    Adaptive adaptive(MakeClosureZoo()[name]);
    const vtkIdType before = adaptive.Mesh.GetNumberOfCells();
    ASSERT_EQ(before, 1 + 5);
    const int segment = adaptive.Mesh.GetSegmentOfEdge(adaptive.Control.Level.Lines[0] / 2);
    ASSERT_EQ(adaptive.Mesh.GetSegmentAt(segment).NumberOfSides, 0);
    ASSERT_EQ(adaptive.Mesh.GetSegmentAt(segment).NumberOfLines, lines);
    EXPECT_FALSE(adaptive.Mesh.Cut(segment, before + 2 * lines - 1));
    EXPECT_EQ(adaptive.Mesh.GetNumberOfCells(), before);
    EXPECT_EQ(adaptive.Mesh.GetSegmentAt(segment).Thirds, -1);
    EXPECT_TRUE(adaptive.Mesh.Cut(segment, before + 2 * lines));
    EXPECT_EQ(adaptive.Mesh.GetNumberOfCells(), before + 2 * lines);
    EXPECT_EQ(CountCells(adaptive), before + 2 * lines);
    const int thirds = adaptive.Mesh.GetSegmentAt(segment).Thirds;
    EXPECT_EQ(thirds, adaptive.Mesh.GetNumberOfControlVertices());
    EXPECT_TRUE(adaptive.Mesh.Cut(segment, 0)); // is cut already
    EXPECT_EQ(adaptive.Mesh.GetNumberOfVertices(), thirds + 2);
    const int child = adaptive.Mesh.GetSegmentAt(segment).Children;
    EXPECT_EQ(adaptive.Mesh.GetSegmentAt(child).Level, 2);
  }
}

TEST(AdaptiveSqrtThreeClosure, NewNumbersOfVerticesReachAll)
{
  for (const auto& [name, model] : MakeClosureZoo())
  {
    SCOPED_TRACE(name);
    Adaptive adaptive(model);
    adaptive.SplitTo(3);
    const Mesh before = adaptive.Mesh;
    // The last one comes first; the two points of a segment stay together.
    Buffer<int> numbers(before.GetNumberOfVertices());
    int next = static_cast<int>(before.GetNumberOfVertices());
    for (int v = 0; v < before.GetNumberOfVertices(); ++v)
    {
      const bool isAdded = v >= before.GetNumberOfControlVertices();
      numbers[v] = isAdded ? 0 : v;
      if (isAdded && before.GetAdded(v).Source < 0)
      {
        next -= 2;
        numbers[v] = next;
        numbers[++v] = next + 1;
      }
      else if (isAdded)
      {
        numbers[v] = --next;
      }
    }
    Mesh& mesh = adaptive.Mesh;
    mesh.Renumber(numbers);
    for (int face = 0; face < mesh.GetNumberOfFaces(); ++face)
    {
      ASSERT_EQ(mesh.IsThere(face), before.IsThere(face));
      for (int corner = 3 * face; mesh.IsThere(face) && corner < 3 * face + 3; ++corner)
      {
        ASSERT_EQ(mesh.GetVertex(corner), numbers[before.GetVertex(corner)]);
        if (mesh.IsSplit(face) && !mesh.IsFixed(corner))
        {
          ASSERT_EQ(mesh.GetApex(corner), numbers[before.GetApex(corner)]);
        }
      }
    }
    for (int s = 0; s < mesh.GetNumberOfSegments(); ++s)
    {
      const Mesh::Segment& segment = mesh.GetSegmentAt(s);
      const Mesh::Segment& old = before.GetSegmentAt(s);
      ASSERT_EQ(segment.Ends[0], numbers[old.Ends[0]]);
      ASSERT_EQ(segment.Ends[1], numbers[old.Ends[1]]);
      ASSERT_EQ(segment.Thirds, old.Thirds < 0 ? old.Thirds : numbers[old.Thirds]);
    }
    for (auto v = static_cast<int>(before.GetNumberOfControlVertices());
      v < before.GetNumberOfVertices(); ++v)
    {
      ASSERT_EQ(mesh.GetAdded(numbers[v]).Source, before.GetAdded(v).Source);
      ASSERT_EQ(mesh.GetAdded(numbers[v]).Level, before.GetAdded(v).Level);
      ASSERT_EQ(mesh.GetAdded(numbers[v]).IsSecond, before.GetAdded(v).IsSecond);
    }
  }
}
