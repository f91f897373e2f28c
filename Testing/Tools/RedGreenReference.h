// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenReference.h
 * Mathematics 13 by definition, slowly: vertices are barycentric coordinates in the input, leaves
 * are lists of vertices, the closure is a loop over everything. And an independent check of what
 * Core wrote: conformity, orientation and volume in exact (dyadic) barycentric coordinates.
 */
#ifndef SubdivisionObjects_RedGreenReference_h
#define SubdivisionObjects_RedGreenReference_h

#include "CoreReference.h"

#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/RedGreen/RedGreenOutput.h"

namespace redgreen_reference
{

using namespace coretest;

/// A point of the input complex: weights of input vertices, sorted. Dyadic, hence exact.
using Key = std::vector<std::pair<vtkIdType, double>>;

Key Middle(const Key& a, const Key& b);

/// The input vertices of the smallest simplex that holds some points.
Tuple Support(const std::vector<Key>& points);

using Cell = std::vector<Key>;
using Pair = std::pair<Key, Key>;

inline Pair MakePair(const Key& a, const Key& b)
{
  return a < b ? Pair(a, b) : Pair(b, a);
}

/// The children of Mathematics 2, as pairs of corners whose middles they join.
std::vector<Cell> RedChildren(const Cell& c);

/// A leaf of the definition.
struct NaiveLeaf
{
  vtkIdType Input;
  int Level;
  Cell Points;
  bool operator<(const NaiveLeaf& other) const
  {
    return std::tie(this->Input, this->Level, this->Points) <
      std::tie(other.Input, other.Level, other.Points);
  }
  bool operator==(const NaiveLeaf& other) const { return !(*this < other) && !(other < *this); }
};

class NaiveRedGreen
{
public:
  explicit NaiveRedGreen(const SimplexList& input);

  std::set<NaiveLeaf> Leaves;
  std::set<Pair> Splits;

  void MarkCell(const NaiveLeaf& leaf);
  /// A cell that will be a leaf.
  void MarkLater(const Cell& cell);
  /// An edge of a cell of the output in a leaf.
  void MarkEdge(const NaiveLeaf& leaf, const Pair& edge);
  void Close();

  static std::set<Pair> EdgesOf(const Cell& cell);

private:
  bool IsSplit(const Key& a, const Key& b) const { return this->Splits.count(MakePair(a, b)) > 0; }
  /// All leaves once; says whether anything changed.
  bool Sweep();

  std::vector<Pair> Pending;
};

/// What Core wrote, with vertices as points of the input complex.
template <typename Id>
struct Written
{
  std::vector<Key> Keys; ///< of vertices
  SimplexList Cells;
  std::vector<unsigned char> Types;
  std::vector<unsigned char> Levels;
  std::vector<unsigned char> Kinds;
  std::vector<vtkIdType> GreenParents;
  std::vector<vtkIdType> InputCells;
  std::vector<GreenLeaf<Id>> GreenLeaves;
  std::vector<double> Points;

  std::vector<Cell> GetPointsOfCells() const
  {
    std::vector<Cell> cells;
    for (const Tuple& tuple : GetCells(this->Cells))
    {
      Cell cell;
      for (vtkIdType v : tuple)
      {
        cell.push_back(this->Keys[v]);
      }
      cells.push_back(cell);
    }
    return cells;
  }
  Cell GetPoints(const GreenLeaf<Id>& leaf) const
  {
    Cell cell;
    for (int i = 0; i <= leaf.Dimension; ++i)
    {
      cell.push_back(this->Keys[leaf.Vertices[i]]);
    }
    return cell;
  }
  /// Cells that are not green, and the leaves of those that are.
  std::set<NaiveLeaf> GetLeaves() const
  {
    std::set<NaiveLeaf> leaves;
    const auto cells = this->GetPointsOfCells();
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (this->GreenParents[i] < 0)
      {
        leaves.insert({ this->InputCells[i], this->Levels[i], cells[i] });
      }
      else
      {
        const auto& leaf = this->GreenLeaves[this->GreenParents[i]];
        leaves.insert({ leaf.Input, leaf.Level, this->GetPoints(leaf) });
      }
    }
    return leaves;
  }
};

template <typename Id>
std::vector<Key> MakeKeys(const RedGreen<Id>& state, const std::vector<Key>* inputKeys = nullptr)
{
  std::vector<Key> keys;
  for (Id v = 0; v < state.GetNumberOfVertices(); ++v)
  {
    if (v < state.GetNumberOfInputVertices())
    {
      keys.push_back(inputKeys ? (*inputKeys)[v] : Key{ { v, 1. } });
    }
    else
    {
      const auto ends = state.GetEnds(v);
      keys.push_back(Middle(keys[ends[0]], keys[ends[1]]));
    }
  }
  return keys;
}

template <typename Id>
Written<Id> Write(const RedGreen<Id>& state, const std::vector<double>& points,
  const std::vector<Key>* inputKeys = nullptr)
{
  const RedGreenOutput<Id> output(state);
  const CellCounts counts = output.GetCounts();
  WrittenCells cells(counts);
  Written<Id> written;
  written.Levels.assign(counts.Cells, 99);
  written.Kinds.assign(counts.Cells, 99);
  written.GreenParents.assign(counts.Cells, -99);
  written.InputCells.assign(counts.Cells, -99);
  output.template Write<long long>({ cells.GetStorage(), written.Levels.data(),
    written.Kinds.data(), written.GreenParents.data(), written.InputCells.data() });
  written.Cells = cells.ToList(state.GetNumberOfVertices());
  written.Types = cells.Types;
  for (vtkIdType i = 0; i < output.GetNumberOfGreenLeaves(); ++i)
  {
    written.GreenLeaves.push_back(output.GetGreenLeaf(i));
  }
  written.Keys = MakeKeys(state, inputKeys);
  written.Points.resize(3 * static_cast<std::size_t>(state.GetNumberOfVertices()));
  MakeMidpointRows(state).Apply(points.data(), written.Points.data(), 3);
  return written;
}

/// The leaf of Core as the definition names it.
template <typename Id>
NaiveLeaf ToNaive(
  const RedGreen<Id>& state, const RedGreenLeaf<Id>& leaf, const std::vector<Key>& keys)
{
  const RedGreenCell<Id> cell = state.GetCell(leaf);
  NaiveLeaf naive{ cell.Input, cell.Level, {} };
  for (int i = 0; i <= cell.Dimension; ++i)
  {
    naive.Points.push_back(keys[cell.Vertices[i]]);
  }
  return naive;
}

using Matrix4 = std::array<std::array<double, 4>, 4>;

/// Determinant of the rows from `row` on and the columns of a mask, by expansion: exact for dyadic
/// numbers of a few bits.
double Determinant(const Matrix4& m, int size, int row = 0, unsigned int used = 0);

/// Barycentric coordinates of up to four points in a simplex of the input, vertices in order.
Matrix4 Coordinates(const Cell& points, const Tuple& simplex);

}

#endif
