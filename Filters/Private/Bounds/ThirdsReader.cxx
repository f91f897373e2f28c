// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/ThirdsReader.h"

#include "Core/Memory/Loops.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellType.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

using Lattice = PieceLattice;
using Ends = std::array<vtkIdType, 2>;
using Triangle = std::array<vtkIdType, 3>;

/// The cells of a mesh: first vertices, then lines, then triangles.
struct SortedCells
{
  std::vector<vtkIdType> Vertices;
  std::vector<Ends> Lines;
  std::vector<Triangle> Triangles;
  vtkIdType Points = 0;
  bool HasOthers = false;

  explicit SortedCells(vtkPointSet* mesh);
};

SortedCells::SortedCells(vtkPointSet* mesh)
  : Points(mesh->GetNumberOfPoints())
{
  const CellReader cells(mesh);
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    const int type = cells.GetGridType(c, cell.Size);
    if (type == VTK_TRIANGLE)
    {
      this->Triangles.push_back({ { cell.Ids[0], cell.Ids[1], cell.Ids[2] } });
    }
    else if (type == VTK_LINE && this->Triangles.empty())
    {
      this->Lines.push_back({ { cell.Ids[0], cell.Ids[1] } });
    }
    else if (type == VTK_VERTEX && this->Lines.empty() && this->Triangles.empty())
    {
      this->Vertices.push_back(cell.Ids[0]);
    }
    else
    {
      this->HasOthers = true;
    }
  }
}

/// A cell whose edges are cut into thirds: the points, and the parts by their numbers there.
struct LineInThirds
{
  static constexpr int Parts = 3;
  std::array<vtkIdType, 4> Points{}; ///< from end to end
  std::array<vtkIdType, Parts> Children{};
};
struct TriangleInThirds
{
  static constexpr int Parts = 9;
  static constexpr int Centre = 3;
  /// The corners, the centre, and of each edge the two points that cut it.
  std::array<vtkIdType, 10> Points{};
  std::array<vtkIdType, Parts> Children{};

  /// The point of the edge between two corners that is nearer to the first.
  static int GetThird(int near, int far) { return 4 + 2 * near + (far == (near + 1) % 3 ? 0 : 1); }
  static LatticePoint GetPlace(int point);
};

/// On the lattice of three divisions.
LatticePoint TriangleInThirds::GetPlace(int point)
{
  constexpr std::array<LatticePoint, 3> corners{ { { { 0, 0, 0 } }, { { 1, 0, 0 } },
    { { 0, 1, 0 } } } };
  if (point == Centre)
  {
    return { { 1, 1, 0 } };
  }
  const int near = point < Centre ? point : (point - 4) / 2;
  const int far = point < Centre ? point : (near + 1 + point % 2) % 3;
  LatticePoint place{ { 0, 0, 0 } };
  for (int x = 0; x < 2; ++x)
  {
    place[x] = 2 * corners[near][x] + corners[far][x];
  }
  return place;
}

/// How two steps of the sqrt(3) scheme split cells.
class PairOfSteps
{
public:
  PairOfSteps(const SortedCells& before, const SortedCells& between, const SortedCells& after);
  bool IsKnown() const { return this->Known; }
  const std::vector<LineInThirds>& GetLines() const { return this->Lines; }
  const std::vector<TriangleInThirds>& GetTriangles() const { return this->Triangles; }

private:
  static void FindLine(const Ends& line, const std::vector<Ends>& after, LineInThirds& found);
  static void FindPoints(const std::vector<Triangle>& after, TriangleInThirds& found);
  template <typename Cells>
  static bool AreFound(const Cells& cells)
  {
    return std::all_of(cells.begin(), cells.end(), [](const auto& cell)
      { return std::find(cell.Points.begin(), cell.Points.end(), -1) == cell.Points.end(); });
  }

  std::vector<LineInThirds> Lines;
  std::vector<TriangleInThirds> Triangles;
  bool Known;
};

/// In which triangle a part lies: in the triangle of its centre, or it is at a corner. Then it is
/// the child across the edge of its parent between that corner and the centre.
vtkIdType FindTriangle(
  const SortedCells& before, const SortedCells& between, const SortedCells& after, vtkIdType child)
{
  const Triangle& part = after.Triangles[child];
  const Triangle& parent = between.Triangles[child / 3];
  for (const vtkIdType point :
    { part[0], part[1], part[2], parent[child % 3], parent[(child + 1) % 3] })
  {
    if (point >= before.Points && point < between.Points)
    {
      return point - before.Points;
    }
  }
  return -1;
}

PairOfSteps::PairOfSteps(
  const SortedCells& before, const SortedCells& between, const SortedCells& after)
  : Lines(before.Lines.size())
  , Triangles(before.Triangles.size())
{
  // The first step makes the centres of all triangles, and nothing else.
  this->Known = !before.HasOthers &&
    between.Points - before.Points == static_cast<vtkIdType>(before.Triangles.size()) &&
    3 * between.Triangles.size() == after.Triangles.size() &&
    after.Triangles.size() == TriangleInThirds::Parts * before.Triangles.size() &&
    after.Lines.size() == LineInThirds::Parts * before.Lines.size();
  std::vector<int> counts(before.Triangles.size(), 0);
  for (const std::size_t child : InTurn(this->Known ? after.Triangles.size() : 0))
  {
    const vtkIdType of = FindTriangle(before, between, after, static_cast<vtkIdType>(child));
    if (of < 0 || counts[of] == TriangleInThirds::Parts)
    {
      this->Known = false;
      break;
    }
    this->Triangles[of].Children[counts[of]++] = static_cast<vtkIdType>(child);
  }
  if (!this->Known)
  {
    return;
  }
  ForEach(static_cast<vtkIdType>(this->Lines.size()),
    [&](vtkIdType i)
    {
      for (int part = 0; part < LineInThirds::Parts; ++part)
      {
        this->Lines[i].Children[part] = LineInThirds::Parts * i + part;
      }
      FindLine(before.Lines[i], after.Lines, this->Lines[i]);
    });
  ForEach(static_cast<vtkIdType>(this->Triangles.size()),
    [&](vtkIdType i)
    {
      TriangleInThirds& found = this->Triangles[i];
      found.Points.fill(-1);
      std::copy(before.Triangles[i].begin(), before.Triangles[i].end(), found.Points.begin());
      found.Points[TriangleInThirds::Centre] = before.Points + i;
      FindPoints(after.Triangles, found);
    });
  this->Known = AreFound(this->Lines) && AreFound(this->Triangles);
}

/// One part of a line is at each end. Leaves points at -1 where that is not so.
void PairOfSteps::FindLine(const Ends& line, const std::vector<Ends>& after, LineInThirds& found)
{
  found.Points = { { line[0], -1, -1, line[1] } };
  for (int end = 0; end < 2; ++end)
  {
    for (const vtkIdType child : found.Children)
    {
      const Ends& part = after[child];
      const auto at = std::find(part.begin(), part.end(), line[end]);
      if (at != part.end())
      {
        found.Points[1 + end] = part[at == part.begin() ? 1 : 0];
      }
    }
  }
}

/// The part at a corner has the two points that are near it. Of the parts at the centre three join
/// points that are near different corners, the points of one edge. Leaves points at -1 where that
/// is not so.
void PairOfSteps::FindPoints(const std::vector<Triangle>& after, TriangleInThirds& found)
{
  const auto has = [](const Triangle& part, vtkIdType point)
  { return std::find(part.begin(), part.end(), point) != part.end(); };
  const auto findCorner = [&](vtkIdType point)
  {
    for (const vtkIdType child : found.Children)
    {
      for (int k = 0; has(after[child], point) && k < 3; ++k)
      {
        if (has(after[child], found.Points[k]))
        {
          return k;
        }
      }
    }
    return -1;
  };
  const vtkIdType centre = found.Points[TriangleInThirds::Centre];
  for (const vtkIdType child : found.Children)
  {
    const Triangle& part = after[child];
    const auto at = std::find(part.begin(), part.end(), centre) - part.begin();
    if (at == 3)
    {
      continue;
    }
    const Ends thirds{ { part[(at + 1) % 3], part[(at + 2) % 3] } };
    const std::array<int, 2> near{ { findCorner(thirds[0]), findCorner(thirds[1]) } };
    for (int end = 0; end < 2 && near[0] >= 0 && near[1] >= 0 && near[0] != near[1]; ++end)
    {
      found.Points[TriangleInThirds::GetThird(near[end], near[1 - end])] = thirds[end];
    }
  }
}

/// Finds the points of a line after two pairs of steps. `parts`: the lines between these.
void ReadLine(const LineInThirds& line, const std::vector<Ends>& parts, const PairOfSteps& last,
  vtkIdType* points)
{
  const Lattice& lattice = Lattice::Get(Lattice::CurveInThirds);
  for (int part = 0; part < LineInThirds::Parts; ++part)
  {
    for (const vtkIdType child : line.Children)
    {
      const Ends ends{ { line.Points[part], line.Points[part + 1] } };
      const bool isSame = parts[child] == ends;
      for (int i = 0; i < 4 && (isSame || parts[child] == Ends{ { ends[1], ends[0] } }); ++i)
      {
        points[lattice.Find({ { 3 * part + (isSame ? i : 3 - i), 0, 0 } })] =
          last.GetLines()[child].Points[i];
      }
    }
  }
}

/// The same of a triangle.
void ReadTriangle(const TriangleInThirds& triangle, const std::vector<Triangle>& parts,
  const PairOfSteps& last, vtkIdType* points)
{
  const Lattice& lattice = Lattice::Get(Lattice::TriangleInThirds);
  for (const vtkIdType child : triangle.Children)
  {
    std::array<LatticePoint, 3> corners{};
    for (int k = 0; k < 3; ++k)
    {
      const auto at = std::find(triangle.Points.begin(), triangle.Points.end(), parts[child][k]);
      if (at == triangle.Points.end())
      {
        return;
      }
      corners[k] = TriangleInThirds::GetPlace(static_cast<int>(at - triangle.Points.begin()));
    }
    const TriangleInThirds& part = last.GetTriangles()[child];
    for (int i = 0; i < static_cast<int>(part.Points.size()); ++i)
    {
      const LatticePoint in = TriangleInThirds::GetPlace(i);
      LatticePoint place{ { 0, 0, 0 } };
      for (int x = 0; x < 2; ++x)
      {
        place[x] =
          (3 - in[0] - in[1]) * corners[0][x] + in[0] * corners[1][x] + in[1] * corners[2][x];
      }
      points[lattice.Find(place)] = part.Points[i];
    }
  }
}

}

NestedPieces ReadThirds(const FourSqrtThreeSteps& meshes)
{
  const SortedCells given(meshes[0]);
  const SortedCells one(meshes[1]);
  const SortedCells two(meshes[2]);
  const SortedCells three(meshes[3]);
  const SortedCells four(meshes[4]);
  const PairOfSteps first(given, one, two);
  const PairOfSteps second(two, three, four);
  const std::array<vtkIdType, PieceLattice::Steps + 1> counts{ { given.Points, given.Points,
    two.Points, four.Points } };
  if (!first.IsKnown() || !second.IsKnown())
  {
    return NestedPieces({}, {}, counts);
  }
  const auto vertices = static_cast<vtkIdType>(given.Vertices.size());
  const auto lines = static_cast<vtkIdType>(given.Lines.size());
  const auto triangles = static_cast<vtkIdType>(given.Triangles.size());
  std::vector<signed char> kinds(given.Vertices.size(), -1);
  kinds.resize(kinds.size() + given.Lines.size(), Lattice::CurveInThirds);
  kinds.resize(kinds.size() + given.Triangles.size(), Lattice::TriangleInThirds);
  const auto ofLine = static_cast<vtkIdType>(Lattice::Get(Lattice::CurveInThirds).Places.size());
  const auto ofTriangle =
    static_cast<vtkIdType>(Lattice::Get(Lattice::TriangleInThirds).Places.size());
  Buffer<vtkIdType> points(vertices + ofLine * lines + ofTriangle * triangles, -1);
  CopyInThreads(given.Vertices.data(), vertices, points.data());
  vtkIdType* to = points.data() + vertices;
  ForEach(
    lines, [&](vtkIdType i) { ReadLine(first.GetLines()[i], two.Lines, second, to + ofLine * i); });
  to += ofLine * lines;
  ForEach(triangles, [&](vtkIdType i)
    { ReadTriangle(first.GetTriangles()[i], two.Triangles, second, to + ofTriangle * i); });
  if (std::find(points.data(), points.data() + points.size(), -1) != points.data() + points.size())
  {
    return NestedPieces({}, {}, counts);
  }
  return NestedPieces(std::move(kinds), std::move(points), counts);
}

}
