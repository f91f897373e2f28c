// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/SheetRows.h"

#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/PatchPowers.h"
#include "Core/Operators/PlaceSum.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Solids/Limits/LatticeNames.h"
#include "Core/Solids/Limits/LocalLattice.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/Limits/SheetReader.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace subdivision
{
namespace
{

/// The polynomial that is 1 at a node of the lattice and 0 at all others: integers, divided once.
PatchPolynomial ExpandNode(const PlaceNode& node)
{
  const double weights[3][3] = { { 1., -1., -1. }, { 0., 1., 0. }, { 0., 0., 1. } };
  PatchPolynomial polynomial{};
  polynomial[0] = 1.;
  double divisor = 1.;
  for (int i = 0; i < 3; ++i)
  {
    for (int r = 0; r < node[i]; ++r)
    {
      polynomial = MultiplyByLinear(PatchPowers::Quartic, polynomial,
        LatticeSize * weights[i][0] - r, LatticeSize * weights[i][1], LatticeSize * weights[i][2]);
      divisor *= r + 1;
    }
  }
  for (double& value : polynomial)
  {
    value /= divisor;
  }
  return polynomial;
}

/// The mesh of a key: all cells at its corners.
class SheetMesh
{
public:
  explicit SheetMesh(const SheetKey& key)
  {
    if (key.Places == SheetPlaces::CurveVertex || key.Places == SheetPlaces::CurveEdge ||
      key.Places == SheetPlaces::CurveLattice)
    {
      this->AddCurve(key);
    }
    else
    {
      this->AddTriangles(key);
    }
  }
  /// The rows of the places, over the columns of the key.
  std::vector<double> FindRows(const SheetKey& key, LoopWeights ofSurfaces) const;
  /// The rows of the powers of which the limit over the lattice is a sum.
  std::vector<double> FindPowers(const SheetKey& key, LoopWeights ofSurfaces) const;
  SheetChild FindChild(const SheetKey& key, int child, LoopWeights ofSurfaces) const;

private:
  using Corners = std::array<int, 3>;

  void AddCurve(const SheetKey& key);
  void AddTriangles(const SheetKey& key);
  void AddCell(const int* corners, int size);
  Level<int> MakeLevel(LoopWeights ofSurfaces) const;
  int FindFirst(int column) const
  {
    while (this->Equals[column] != column)
    {
      column = this->Equals[column];
    }
    return column;
  }

  std::vector<int> Equals; ///< of each column an earlier one that is the same vertex, or itself
  std::vector<int> Fixed;  ///< vertices that are corners
  /// The edges on which the sheet ends. Both sides of a crease may be in the mesh.
  std::set<std::array<int, 2>> Creases;
  SimplexList Cells;
};

void SheetMesh::AddCell(const int* corners, int size)
{
  this->Cells.Dimensions.push_back(static_cast<unsigned char>(size - 1));
  this->Cells.Connectivity.insert(this->Cells.Connectivity.end(), corners, corners + size);
}

void SheetMesh::AddCurve(const SheetKey& key)
{
  const bool isVertex = key.Places == SheetPlaces::CurveVertex;
  int next = isVertex ? 1 : 2;
  if (!isVertex)
  {
    const int line[2] = { 0, 1 };
    this->AddCell(line, 2);
  }
  for (int end = 0; end < (isVertex ? 1 : 2); ++end)
  {
    if (key.Fans[end].What == SheetFan::Kind::Open)
    {
      for (int i = 0; i < (isVertex ? 2 : 1); ++i)
      {
        const int line[2] = { end, next++ };
        this->AddCell(line, 2);
      }
    }
    else
    {
      this->Fixed.push_back(end);
    }
  }
  this->Equals.resize(next);
  std::iota(this->Equals.begin(), this->Equals.end(), 0);
}

void SheetMesh::AddTriangles(const SheetKey& key)
{
  // The vertices at each corner: those Before, the other two corners, those After.
  std::array<std::vector<int>, 3> fans;
  int next = 3;
  int across[3][2]; // at each corner the vertices across the edges to the next and to the last one
  for (int i = 0; i < 3; ++i)
  {
    const SheetFan& fan = key.Fans[i];
    std::vector<int>& vertices = fans[i];
    const int firstAfter = next;
    next += fan.After;
    for (int k = fan.Before; k > 0; --k)
    {
      vertices.push_back(next + k - 1);
    }
    const bool isClosed = fan.IsClosed();
    across[i][0] = isClosed ? firstAfter + fan.After - 1 : fan.Before > 0 ? next : -1;
    across[i][1] = fan.After > 0 ? firstAfter : -1;
    next += fan.Before;
    vertices.push_back((i + 1) % 3);
    vertices.push_back((i + 2) % 3);
    for (int k = 0; k < fan.After; ++k)
    {
      vertices.push_back(firstAfter + k);
    }
    if (isClosed)
    {
      vertices.push_back((i + 1) % 3);
    }
    if (fan.What == SheetFan::Kind::ClosedCorner || fan.What == SheetFan::Kind::OpenCorner)
    {
      this->Fixed.push_back(i);
    }
  }
  this->Equals.resize(next);
  std::iota(this->Equals.begin(), this->Equals.end(), 0);
  for (int i = 0; i < 3; ++i)
  {
    if (across[i][0] >= 0 && across[(i + 1) % 3][1] >= 0)
    {
      const int a = this->FindFirst(across[i][0]);
      const int b = this->FindFirst(across[(i + 1) % 3][1]);
      this->Equals[std::max(a, b)] = std::min(a, b);
    }
  }
  std::set<Corners> triangles;
  for (int i = 0; i < 3; ++i)
  {
    if (key.Fans[i].What == SheetFan::Kind::Open || key.Fans[i].What == SheetFan::Kind::OpenCorner)
    {
      for (const int end : { fans[i].front(), fans[i].back() })
      {
        this->Creases.insert(
          { std::min(i, this->FindFirst(end)), std::max(i, this->FindFirst(end)) });
      }
    }
    for (std::size_t k = 0; key.Fans[i].What != SheetFan::Kind::None && k + 1 < fans[i].size(); ++k)
    {
      Corners corners{ { i, this->FindFirst(fans[i][k]), this->FindFirst(fans[i][k + 1]) } };
      std::sort(corners.begin(), corners.end());
      if (triangles.insert(corners).second)
      {
        this->AddCell(corners.data(), 3);
      }
    }
  }
}

Level<int> SheetMesh::MakeLevel(LoopWeights ofSurfaces) const
{
  const auto columns = static_cast<int>(this->Equals.size());
  SimplexList cells = this->Cells;
  cells.NumberOfPoints = columns;
  std::vector<CellRun> runs;
  Level<int> level;
  level.Complex = BuildComplex<int>(cells, runs);
  SingularSimplices singular;
  singular.Vertices = Buffer<unsigned char>(columns, 0);
  for (const int vertex : this->Fixed)
  {
    singular.Vertices[vertex] = 1;
  }
  singular.Edges = Buffer<unsigned char>(level.Complex.NumberOfEdges, 0);
  for (vtkIdType e = 0; e < singular.Edges.size(); ++e)
  {
    const auto [a, b] =
      std::minmax({ level.Complex.EdgeVertices[2 * e], level.Complex.EdgeVertices[2 * e + 1] });
    singular.Edges[e] = this->Creases.count({ a, b });
  }
  StrataOptions options;
  options.Weights = ofSurfaces;
  level.Strata = BuildStrata(level.Complex, singular, options);
  return level;
}

std::vector<double> SheetMesh::FindRows(const SheetKey& key, LoopWeights ofSurfaces) const
{
  const SheetPlaces places = key.Places;
  const auto columns = static_cast<int>(this->Equals.size());
  const Level<int> level = this->MakeLevel(ofSurfaces);
  std::vector<std::array<int, 2>> midpoints;
  std::vector<int> found = { 0 };
  const int middle = columns; // the first midpoint
  if (places == SheetPlaces::Edge || places == SheetPlaces::CurveEdge)
  {
    midpoints = { { { 0, 1 } }, { { 0, middle } }, { { middle, 1 } } };
    found = { middle + 1, middle, middle + 2 };
  }
  else if (places == SheetPlaces::Face)
  {
    midpoints = { { { 0, 1 } }, { { 0, 2 } }, { { 1, 2 } }, { { middle, middle + 1 } },
      { { middle, middle + 2 } }, { { middle + 1, middle + 2 } } };
    found = { middle + 3, middle + 4, middle + 5 };
  }
  const SparseRows<int> rows = LocalLimit<int>(level, {}, midpoints).BuildRows();
  std::vector<double> weights;
  for (const int row : found)
  {
    const std::size_t first = weights.size();
    weights.resize(first + columns, 0.);
    for (int k = rows.Offsets[row]; k < rows.Offsets[row + 1]; ++k)
    {
      weights[first + rows.Columns[k]] += rows.Weights[k];
    }
  }
  return weights;
}

/// The sums of nodes that are powers go back as derivatives do (PlaceSum.h), so that they have the
/// precision of numbers of their own size, however small the part.
std::vector<double> SheetMesh::FindPowers(const SheetKey& key, LoopWeights ofSurfaces) const
{
  const auto columns = static_cast<int>(this->Equals.size());
  const int dimension = key.Places == SheetPlaces::FaceLattice ? 2 : 1;
  VertexNames<int> names(columns);
  std::array<int, 4> corners{ { 0, 1, 2, -1 } };
  for (const int child : ListChildrenTo(key.Part))
  {
    corners = GetCornersOfChild(corners, dimension, child, names);
  }
  std::vector<int> nodes;
  for (const PlaceNode& node : ListLattice(dimension))
  {
    nodes.push_back(FindNode(corners, node, names));
  }
  const Level<int> level = this->MakeLevel(ofSurfaces);
  const LocalLimit<int> limit(level, {}, names.GetMidpoints());
  LocalLattice<int> lattice(limit);
  PlaceSum<LocalLattice<int>, PatchPolynomial> sum(lattice);
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    sum.AddLimit(nodes[n], ExpandNode(ListLattice(dimension)[n]));
  }
  sum.StepBack(lattice.GetLevel(nodes[0]) + 1);
  std::vector<double> weights(static_cast<std::size_t>(QuarticPowers * columns), 0.);
  sum.ForColumns(
    [&](int column, const PatchPolynomial& powers)
    {
      for (int p = 0; p < QuarticPowers; ++p)
      {
        weights[p * columns + column] = powers[p];
      }
    });
  return weights;
}

/// Reads the child off this mesh after a step. All that it depends on is there.
SheetChild SheetMesh::FindChild(const SheetKey& key, int child, LoopWeights ofSurfaces) const
{
  Level<int> level = this->MakeLevel(ofSurfaces);
  const Level<int> refined = Refine(level, Depth::ForRefinement);
  const auto findEdge = [](const Level<int>& of, int a, int b)
  {
    int edge = 0;
    for (const auto& ends = of.Complex.EdgeVertices; edge < of.Complex.NumberOfEdges; ++edge)
    {
      const int first = ends[2 * edge];
      const int second = ends[2 * edge + 1];
      if ((first == a && second == b) || (first == b && second == a))
      {
        break;
      }
    }
    return edge;
  };
  const auto getMiddle = [&](int a, int b)
  { return a == b ? a : level.Complex.NumberOfVertices + findEdge(level, a, b); };
  const bool isFace = key.Places == SheetPlaces::Face;
  std::array<int, 3> corners{ { -1, -1, -1 } };
  for (int i = 0; i < (isFace ? 3 : 2); ++i)
  {
    corners[i] = child < 3 ? getMiddle(child, i) : getMiddle(i, (i + 1) % 3);
  }
  const Buffer<unsigned char> none;
  const SheetReader<Level<int>> reader(refined, none);
  const int edge = findEdge(refined, corners[0], corners[1]);
  SheetPatch<int> patch;
  bool isSheet = false;
  if (isFace)
  {
    const int face = reader.FindFace(edge, corners);
    isSheet = face >= 0 && reader.ReadFace(face, corners, patch);
  }
  else
  {
    const int third = key.Places == SheetPlaces::Edge ? getMiddle(child, 2) : -1;
    isSheet = reader.ReadEdge(
      edge, corners[0], corners[1], [third](int a, int) { return a == third; }, patch);
  }
  SheetChild made;
  if (!isSheet)
  {
    return made;
  }
  made.Key = patch.Key;
  const Stencils<int> stencils = TakeStencils(level);
  const auto append = [&](vtkIdType begin, vtkIdType end, RowBlock<int>& rows)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      ExplicitRows<int> entries;
      stencils.AppendRow(patch.Columns[i], 1., entries);
      for (std::size_t k = 0; k < entries.Columns.size(); ++k)
      {
        rows.Add(entries.Columns[k], entries.Weights[k]);
      }
      rows.EndRow();
    }
  };
  made.Rows = BlockOperator<int>(static_cast<vtkIdType>(this->Equals.size()),
    static_cast<vtkIdType>(patch.Columns.size()), append)
                .Store();
  return made;
}

}

const SheetChild& SheetRows::FindChild(const SheetKey& key, int child)
{
  SheetKey part = key;
  part.Part = static_cast<std::uint16_t>(4 + child);
  const auto [found, isNew] = this->Children.try_emplace(part.Pack());
  if (isNew)
  {
    found->second = SheetMesh(key).FindChild(key, child, this->Weights);
  }
  return found->second;
}

std::vector<double> SheetRows::Make(const SheetKey& key) const
{
  const SheetMesh mesh(key);
  return key.HasLattice() ? mesh.FindPowers(key, this->Weights) : mesh.FindRows(key, this->Weights);
}

}
