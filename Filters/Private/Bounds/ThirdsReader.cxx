// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/ThirdsReader.h"

#include "Core/Memory/Loops.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellType.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

using Lattice = PieceLattice;
using Corners = std::array<vtkIdType, 3>; ///< of a cell; -1 behind the last one

/// The cells of a mesh: first vertices, then lines, then triangles.
struct SortedCells
{
  std::vector<Corners> Cells;
  vtkIdType FirstLine = 0;
  vtkIdType FirstTriangle = 0;
  vtkIdType Points;
  bool HasOthers = false; ///< other cells, or another order
  explicit SortedCells(vtkPointSet* mesh)
    : Points(mesh->GetNumberOfPoints())
  {
    const CellReader cells(mesh);
    std::vector<vtkIdType> scratch;
    int dimension = 0;
    for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
    {
      const CellIds cell = cells.GetCell(c, scratch);
      const int type = cells.GetGridType(c, cell.Size);
      const int last = std::exchange(dimension,
        type == VTK_TRIANGLE   ? 2
          : type == VTK_LINE   ? 1
          : type == VTK_VERTEX ? 0
                               : -1);
      if (dimension < last)
      {
        this->HasOthers = true;
        return;
      }
      this->FirstLine += dimension < 1 ? 1 : 0;
      this->FirstTriangle += dimension < 2 ? 1 : 0;
      this->Cells.push_back({ { -1, -1, -1 } });
      std::copy_n(cell.Ids, dimension + 1, this->Cells.back().begin());
    }
  }

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Cells.size()); }
  vtkIdType CountLines() const { return this->FirstTriangle - this->FirstLine; }
  vtkIdType CountTriangles() const { return this->GetNumberOfCells() - this->FirstTriangle; }
  int GetDimension(vtkIdType cell) const
  {
    return cell < this->FirstLine ? 0 : cell < this->FirstTriangle ? 1 : 2;
  }
  bool Has(vtkIdType cell, vtkIdType point) const
  {
    const Corners& corners = this->Cells[cell];
    return std::find(corners.begin(), corners.end(), point) != corners.end();
  }
};

/// A cell after two steps, and where its corners are in the cell that it is a part of, whose edges
/// have three divisions.
struct Part
{
  vtkIdType Cell;
  std::array<FrameNode, 3> Corners;
};

constexpr int PartsOf[3] = { 1, 3, 9 }; ///< by dimension
constexpr FrameNode CornerPlaces[3] = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } };

/// The place that is twice as near to one corner as to another one.
FrameNode GetThird(int near, int far)
{
  return { { 2 * CornerPlaces[near][0] + CornerPlaces[far][0],
    2 * CornerPlaces[near][1] + CornerPlaces[far][1], 0 } };
}

/// How two steps of the sqrt(3) scheme split cells.
class PairOfSteps
{
public:
  PairOfSteps(const SortedCells& before, const SortedCells& between, const SortedCells& after)
    : Before(before)
    , Between(between)
    , After(after)
    , Parts(before.Cells.size())
  {
    // The first step makes the centres of all triangles, and nothing else.
    this->Known = !before.HasOthers && !between.HasOthers && !after.HasOthers &&
      between.Points - before.Points == before.CountTriangles() &&
      3 * between.CountTriangles() == after.CountTriangles() &&
      after.CountTriangles() == 9 * before.CountTriangles() &&
      after.FirstLine == before.FirstLine && after.CountLines() == 3 * before.CountLines();
    for (const vtkIdType child : InTurn(this->Known ? after.GetNumberOfCells() : 0))
    {
      const int dimension = after.GetDimension(child);
      const vtkIdType of = dimension == 0 ? child
        : dimension == 1                  ? before.FirstLine + (child - after.FirstLine) / 3
                                          : this->FindTriangle(child);
      this->Known = of >= 0 && static_cast<int>(this->Parts[of].size()) < PartsOf[dimension];
      if (!this->Known)
      {
        return;
      }
      this->Parts[of].push_back({ child, {} });
    }
    std::vector<char> isPlaced(this->Parts.size(), 0);
    ForEach(before.GetNumberOfCells(),
      [&](vtkIdType cell) { isPlaced[cell] = this->PlaceParts(cell) ? 1 : 0; });
    this->Known = this->Known && std::find(isPlaced.begin(), isPlaced.end(), 0) == isPlaced.end();
  }

  bool IsKnown() const { return this->Known; }
  const std::vector<Part>& GetParts(vtkIdType cell) const { return this->Parts[cell]; }

private:
  using Placed = std::vector<std::pair<vtkIdType, FrameNode>>;
  /// In which triangle a part lies: in the triangle of its centre, or it is at a corner. Then it is
  /// the child across the edge of its parent between that corner and the centre.
  vtkIdType FindTriangle(vtkIdType child) const
  {
    const vtkIdType number = child - this->After.FirstTriangle;
    const Corners& part = this->After.Cells[child];
    const Corners& parent = this->Between.Cells[this->Between.FirstTriangle + number / 3];
    for (const vtkIdType point :
      { part[0], part[1], part[2], parent[number % 3], parent[(number + 1) % 3] })
    {
      if (point >= this->Before.Points && point < this->Between.Points)
      {
        return this->Before.FirstTriangle + point - this->Before.Points;
      }
    }
    return -1;
  }
  /// One part of a line is at each end.
  void PlaceOnLine(vtkIdType line, Placed& points) const
  {
    for (int end = 0; end < 2; ++end)
    {
      const vtkIdType at = this->Before.Cells[line][end];
      points.push_back({ at, { { 3 * end, 0, 0 } } });
      for (const Part& part : this->Parts[line])
      {
        const Corners& corners = this->After.Cells[part.Cell];
        if (this->After.Has(part.Cell, at))
        {
          points.push_back({ corners[corners[0] == at ? 1 : 0], { { 1 + end, 0, 0 } } });
        }
      }
    }
  }
  /// The part at a corner has the two points that are near it. Of the parts at the centre three
  /// join points that are near different corners, the points of one edge.
  void PlaceInTriangle(vtkIdType triangle, Placed& points) const
  {
    for (int k = 0; k < 3; ++k)
    {
      points.push_back({ this->Before.Cells[triangle][k], GetThird(k, k) });
    }
    const vtkIdType centre = this->Before.Points + triangle - this->Before.FirstTriangle;
    points.push_back({ centre, { { 1, 1, 0 } } });
    for (const Part& part : this->Parts[triangle])
    {
      const Corners& corners = this->After.Cells[part.Cell];
      const auto at = std::find(corners.begin(), corners.end(), centre) - corners.begin();
      if (at == 3)
      {
        continue;
      }
      const vtkIdType thirds[2] = { corners[(at + 1) % 3], corners[(at + 2) % 3] };
      const int near[2] = { this->FindCorner(triangle, thirds[0]),
        this->FindCorner(triangle, thirds[1]) };
      for (int end = 0; end < 2 && near[0] >= 0 && near[1] >= 0 && near[0] != near[1]; ++end)
      {
        points.push_back({ thirds[end], GetThird(near[end], near[1 - end]) });
      }
    }
  }

  /// The corner of a triangle that has a part with a point; -1 if there is none.
  int FindCorner(vtkIdType triangle, vtkIdType point) const
  {
    for (const Part& part : this->Parts[triangle])
    {
      for (int k = 0; k < 3; ++k)
      {
        if (this->After.Has(part.Cell, point) &&
          this->After.Has(part.Cell, this->Before.Cells[triangle][k]))
        {
          return k;
        }
      }
    }
    return -1;
  }
  /// Finds where the parts of a cell are. Returns false where a corner of a part has no place.
  bool PlaceParts(vtkIdType cell)
  {
    const int dimension = this->Before.GetDimension(cell);
    Placed points;
    if (dimension == 0)
    {
      points.push_back({ this->Before.Cells[cell][0], {} });
    }
    else if (dimension == 1)
    {
      this->PlaceOnLine(cell, points);
    }
    else
    {
      this->PlaceInTriangle(cell, points);
    }
    for (Part& part : this->Parts[cell])
    {
      for (int k = 0; k <= dimension; ++k)
      {
        const auto at = std::find_if(points.begin(), points.end(),
          [&](const auto& placed) { return placed.first == this->After.Cells[part.Cell][k]; });
        if (at == points.end())
        {
          return false;
        }
        part.Corners[k] = at->second;
      }
    }
    return true;
  }

  const SortedCells& Before;
  const SortedCells& Between;
  const SortedCells& After;
  std::vector<std::vector<Part>> Parts; ///< of each cell
  bool Known;
};

/// The points of all cells after two pairs of steps, each in the order of its lattice; -1 where a
/// place has no point.
Buffer<vtkIdType> ReadPoints(const std::vector<int>& kinds, const PairOfSteps& first,
  const PairOfSteps& second, const SortedCells& last)
{
  std::vector<vtkIdType> starts = { 0 };
  for (const int kind : InTurn(kinds))
  {
    starts.push_back(starts.back() + Lattice::Get(kind).CountPoints());
  }
  Buffer<vtkIdType> points(starts.back(), -1);
  ForEach(static_cast<vtkIdType>(kinds.size()),
    [&](vtkIdType cell)
    {
      const Lattice& lattice = Lattice::Get(kinds[cell]);
      for (const Part& part : first.GetParts(cell))
      {
        for (const Part& piece : second.GetParts(part.Cell))
        {
          for (int k = 0; k < lattice.Corners; ++k)
          {
            FrameNode place{ { 0, 0, 0 } };
            const FrameNode& in = piece.Corners[k];
            for (int x = 0; x < lattice.Dimension; ++x)
            {
              place[x] = (3 - in[0] - in[1]) * part.Corners[0][x] + in[0] * part.Corners[1][x] +
                in[1] * part.Corners[2][x];
            }
            points[starts[cell] + lattice.Find(place)] = last.Cells[piece.Cell][k];
          }
        }
      }
    });
  return points;
}

}

std::unique_ptr<NestedPieces> ReadThirds(
  const std::function<vtkSmartPointer<vtkPointSet>(int steps)>& getMesh)
{
  std::vector<SortedCells> cells;
  for (int steps = 0; steps <= 4; ++steps)
  {
    const auto mesh = getMesh(steps);
    if (!mesh)
    {
      return nullptr;
    }
    cells.emplace_back(mesh);
  }
  const PairOfSteps first(cells[0], cells[1], cells[2]);
  const PairOfSteps second(cells[2], cells[3], cells[4]);
  const std::array<vtkIdType, Lattice::Steps + 1> counts{ { cells[0].Points, cells[0].Points,
    cells[2].Points, cells[4].Points } };
  std::vector<int> kinds;
  Buffer<vtkIdType> points;
  if (first.IsKnown() && second.IsKnown())
  {
    kinds.resize(static_cast<std::size_t>(cells[0].FirstLine), -1);
    kinds.resize(static_cast<std::size_t>(cells[0].FirstTriangle), Lattice::CurveInThirds);
    kinds.resize(cells[0].Cells.size(), Lattice::TriangleInThirds);
    points = ReadPoints(kinds, first, second, cells[4]);
  }
  if (std::find(points.begin(), points.end(), -1) != points.end())
  {
    kinds.clear();
  }
  return std::make_unique<NestedPieces>(kinds, std::move(points), counts);
}

}
