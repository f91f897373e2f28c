// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/QuadraticPieces.h"

#include "Core/Memory/Loops.h"
#include "Private/Roots/SplitRoots.h"

#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace subdivision
{
namespace
{

/// Corners of a cell.
using Corners = std::vector<unsigned char>;

constexpr std::array<std::array<int, 2>, 6> EdgesOfPieces = { { { 0, 1 }, { 0, 2 }, { 1, 2 },
  { 0, 3 }, { 1, 3 }, { 2, 3 } } };

/// The triangles of a face, from its corner with the least id on.
void CutFace(const Corners& face, const std::array<vtkIdType, 8>& ids, std::vector<Corners>& cut)
{
  const std::size_t size = face.size();
  const auto first = std::min_element(face.begin(), face.end(),
                       [&](unsigned char a, unsigned char b) { return ids[a] < ids[b]; }) -
    face.begin();
  for (std::size_t i = 1; i + 1 < size; ++i)
  {
    cut.push_back({ face[first], face[(first + i) % size], face[(first + i + 1) % size] });
  }
}

/// The simplices of a cell, as its corners.
std::vector<Corners> CutCell(CellShape shape, const std::array<vtkIdType, 8>& ids)
{
  const CellTable& table = GetCellTable(shape);
  std::vector<Corners> cut;
  if (table.Dimension < 2)
  {
    cut.push_back(table.Dimension == 0 ? Corners{ 0 } : Corners{ 0, 1 });
    return cut;
  }
  if (table.Dimension == 2)
  {
    CutFace(table.Faces[0], ids, cut);
    return cut;
  }
  const auto least = static_cast<unsigned char>(
    std::min_element(ids.begin(), ids.begin() + table.Corners) - ids.begin());
  std::vector<Corners> triangles;
  for (const Corners& face : table.Faces)
  {
    if (std::find(face.begin(), face.end(), least) == face.end())
    {
      CutFace(face, ids, triangles);
    }
  }
  for (const Corners& triangle : triangles)
  {
    cut.push_back({ least, triangle[0], triangle[1], triangle[2] });
  }
  return cut;
}

/// The place on the way from one node to another, in quarters of the way.
FrameNode GetBetween(const FrameNode& from, const FrameNode& to, int quarters)
{
  FrameNode at = from;
  for (int axis = 0; axis < 3; ++axis)
  {
    at[axis] += quarters * (to[axis] - from[axis]) / 4;
  }
  return at;
}

class PieceMaker
{
public:
  PieceMaker(vtkPointSet* mesh, int steps)
    : Mesh(mesh)
    , Steps(steps)
    , Roots(mesh, steps)
  {
  }

  vtkIdType GetNumberOfRoots() const { return this->Roots.GetNumberOfRoots(); }
  /// Calls act(root, nodes of the corners, dimension) for the simplices of each root.
  template <typename Act>
  void ForPieces(vtkIdType r, const Act& act) const
  {
    const Root& root = this->Roots.GetRoot(r);
    if (!root.Lattice || root.Quarter > 0) // an octahedron is cut as one
    {
      return;
    }
    const CellTable& table = GetCellTable(root.Shape);
    const auto nodes = GetCornerNodes(root.Shape, 1 << root.Steps);
    std::array<vtkIdType, 8> ids{};
    for (int c = 0; c < table.Corners; ++c)
    {
      ids[c] = this->Roots.GetPoint(root, nodes[c]);
    }
    for (const Corners& corners : CutCell(root.Shape, ids))
    {
      std::array<FrameNode, 4> at{};
      std::transform(corners.begin(), corners.end(), at.begin(),
        [&](unsigned char corner) { return nodes[corner]; });
      act(root, at, static_cast<int>(corners.size()) - 1);
    }
  }
  bool IsStrange(vtkIdType r) const { return !this->Roots.GetRoot(r).Lattice; }
  vtkIdType GetFirst(vtkIdType r) const { return this->Roots.GetRoot(r).First; }

  QuadraticPiece Make(const Root& root, const std::array<FrameNode, 4>& at, int dimension) const
  {
    QuadraticPiece piece{ {}, root.First };
    for (int c = 0; c <= dimension; ++c)
    {
      piece.Nodes[c] = this->Roots.GetPoint(root, at[c]);
    }
    for (int e = 0; e < dimension * (dimension + 1) / 2; ++e)
    {
      const auto [a, b] = EdgesOfPieces[e];
      piece.Nodes[dimension + 1 + e] = this->Roots.GetPoint(root, GetBetween(at[a], at[b], 2));
    }
    return piece;
  }
  /// How far the points at the quarters of an edge are away from the parabola through the others.
  double FindDeviation(const Root& root, const FrameNode& a, const FrameNode& b) const
  {
    std::array<std::array<double, 3>, 5> points{};
    for (int quarter = 0; quarter < 5; ++quarter)
    {
      this->Mesh->GetPoint(
        this->Roots.GetPoint(root, GetBetween(a, b, quarter)), points[quarter].data());
    }
    double most = 0.;
    for (const int quarter : { 1, 3 })
    {
      const int near = quarter - 1;
      const int far = quarter + 1;
      double square = 0.;
      double along = 0.;
      double length = 0.;
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto& p = points;
        const double other = p[quarter == 1 ? 4 : 0][axis];
        const double middle = p[2][axis];
        const double end = p[quarter == 1 ? 0 : 4][axis];
        const double away = 0.375 * end + 0.75 * middle - 0.125 * other - p[quarter][axis];
        const double direction = p[far][axis] - p[near][axis];
        square += away * away;
        along += away * direction;
        length += direction * direction;
      }
      square -= length > 0. ? along * along / length : 0.;
      most = std::max(most, std::sqrt(std::max(square, 0.)));
    }
    return most;
  }

private:
  vtkPointSet* Mesh;
  const int Steps;
  const SplitRoots Roots;
};

}

std::array<std::array<double, 3>, 10> GetNodes(
  vtkPointSet* mesh, const QuadraticPiece& piece, int dimension)
{
  std::array<std::array<double, 3>, 10> nodes{};
  for (int n = 0; n < QuadraticPiece::CountNodes(dimension); ++n)
  {
    mesh->GetPoints()->GetPoint(piece.Nodes[n], nodes[n].data());
  }
  return nodes;
}

double FindBend(const std::array<std::array<double, 3>, 10>& nodes, int dimension)
{
  double most = 0.;
  for (int e = 0; e < dimension * (dimension + 1) / 2; ++e)
  {
    double square = 0.;
    for (int x = 0; x < 3; ++x)
    {
      const double straight = (nodes[EdgesOfPieces[e][0]][x] + nodes[EdgesOfPieces[e][1]][x]) / 2.;
      const double bend = nodes[dimension + 1 + e][x] - straight;
      square += bend * bend;
    }
    most = std::max(most, square);
  }
  return std::sqrt(most);
}

QuadraticPieces MakeQuadraticPieces(vtkPointSet* mesh, bool measures)
{
  QuadraticPieces made;
  if (!mesh->GetPoints() || mesh->GetNumberOfCells() == 0)
  {
    return made;
  }
  const PieceMaker maker(mesh, 1);
  for (const vtkIdType r : InTurn(maker.GetNumberOfRoots()))
  {
    if (made.Strange < 0 && maker.IsStrange(r))
    {
      made.Strange = maker.GetFirst(r);
    }
    maker.ForPieces(r,
      [&](const Root& root, const std::array<FrameNode, 4>& at, int dimension)
      {
        if (root.Steps == 0 && dimension > 0) // a side of a polygon: its middles are a level away
        {
          made.Bend = std::numeric_limits<double>::infinity();
          return;
        }
        const QuadraticPiece piece = maker.Make(root, at, dimension);
        made.Pieces[dimension].push_back(piece);
        made.Bend = std::max(made.Bend, FindBend(GetNodes(mesh, piece, dimension), dimension));
      });
  }
  if (measures)
  {
    const PieceMaker coarser(mesh, 2);
    for (const vtkIdType r : InTurn(coarser.GetNumberOfRoots()))
    {
      coarser.ForPieces(r,
        [&](const Root& root, const std::array<FrameNode, 4>& at, int dimension)
        {
          for (int e = 0; root.Steps == 2 && e < dimension * (dimension + 1) / 2; ++e)
          {
            made.CoarserDeviation = std::max(made.CoarserDeviation,
              coarser.FindDeviation(root, at[EdgesOfPieces[e][0]], at[EdgesOfPieces[e][1]]));
          }
        });
    }
  }
  return made;
}

}
