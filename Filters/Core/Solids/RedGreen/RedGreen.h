// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreen.h
 * Local refinement of a mixed-dimension complex that stays conforming (Mathematics 13; section 4.2
 * and figure 17 of Chang & Qin).
 *
 * The state is a forest and a set of split edges, which are edges with a midpoint. Each input cell
 * is the root of a tree, in which the children of a *red* cell are its red children (children
 * inherit the order of vertices, and with it the diagonal: Mathematics 2). The cells that are not
 * red are the *leaves*. Green cells are not part of the state: RedGreenOutput cuts each leaf with
 * split edges into them when it writes the output.
 *
 * A round consists of marks and then Close(), which makes the set of split edges the smallest that
 * contains the marks and has
 *  - on each triangle, and so on each face of a tetrahedron, 0, 1 or 3 split edges;
 *  - no leaf with an edge of which a half is split, or with a face of three split edges where an
 *    edge between their midpoints is split, or with a split diagonal, which an equal tetrahedron
 *    may have: such leaves become red.
 * This set does not depend on the order of marks or rounds. The ids of new vertices do until
 * SortVertices() gives them an order of their own.
 *
 * Cost: an input cell is stored (is *active*) if it is marked, or if two of its vertices are
 * flagged as ends of split edges, because only such a cell can have a split edge. To find these
 * cells, threads scan the blocks of cells whose range of vertices has newly flagged ones. After
 * scans of four times all cells an incidence from vertices to cells replaces them. The red children
 * of a cell are stored when one of them is marked or gets a split edge. So work and memory are
 * proportional to the cells that change, but for a few passes over all cells. Threads do the scans
 * and all of RedGreenOutput; one thread passes splits on from cell to cell, so that the result does
 * not depend on the number of threads.
 *
 * Memory (Id int): 1 byte per input point, 4 per input cell of each page of 4096 where one is
 * stored, 8 per input cell if cells have several dimensions; 84 bytes per stored cell, 24 per edge
 * of these that is looked up, 24 to 96 for its entry in the index, 4 per new vertex. In all 200 to
 * 300 bytes per stored cell, or some 50 per cell of an output that is refined all over. Lists grow
 * by doubling. Id int is enough for 300 million stored cells.
 */
#ifndef SubdivisionObjects_RedGreen_h
#define SubdivisionObjects_RedGreen_h

#include "Core/Memory/GrowingBuffer.h"
#include "Core/Memory/PairTable.h"
#include "Core/Memory/SimplexStarts.h"
#include "Core/Memory/SparseIds.h"
#include "Core/Solids/RedGreen/RedGreenCells.h"

#include <functional>
#include <limits>
#include <unordered_map>
#include <vector>

namespace subdivision
{

template <typename Id>
class RedGreen
{
public:
  using Leaf = RedGreenLeaf<Id>;
  using Cell = RedGreenCell<Id>;

  /// The arrays of the view must outlive this object. `orderTet` puts the vertices of an input
  /// tetrahedron of level 0 into their final order (TetOrder.h); null: they are in it.
  explicit RedGreen(const SimplexView& cells, std::function<void(vtkIdType*)> orderTet = nullptr);

  /// Tells that an input vertex is the midpoint of an edge of a leaf. This is for an input whose
  /// green cells were replaced by their leaves. Call it before any mark; the next Close() takes it
  /// into account. Midpoints that no refinement can have made may require endless splitting: then
  /// marks and Close() throw std::invalid_argument at LastLevel.
  void AddMidpoint(Id end0, Id end1, Id midpoint);

  /// Sets the scope of each input cell; else all are Own. The array must outlive this object. Call
  /// it before all else.
  void SetScopes(const CellScope* scopes);

  /// @name A round
  ///@{
  /// Cells of the input that are about to be marked: to store them together is faster.
  void Expect(const std::vector<Id>& cells);
  /// Marks all edges of a leaf, which becomes red. Does nothing if it is red already.
  void MarkCell(const Leaf& leaf);
  /// Marks an edge of a leaf, or of the cells into which the output would cut the leaf. An edge
  /// that only these cells have makes the leaf red. If the edge is an edge of a red child it is
  /// split too; otherwise it vanishes.
  void MarkEdge(const Leaf& leaf, Id end0, Id end1);
  /// Splits until nothing more has to be split. Returns whether any edge was split since the
  /// previous Close().
  bool Close();
  ///@}

  /// @name A round of which other states have a part
  ///@{
  /// Splits until nothing more has to be split, but does not end the round.
  void Propagate();
  /// Splits an edge that another state has split. Its ends, if they are midpoints, exist here.
  /// Returns false if no cell that is not ignored has the edge.
  bool SplitEdge(Id end0, Id end1);
  /// Calls use(cell) for the input cells that have the edge whose midpoint is `vertex`, a vertex
  /// that this object added; for a cell perhaps more than once. Call it after Propagate().
  template <typename Use>
  void ForInputCells(Id vertex, const Use& use) const
  {
    Id next = this->Edges[this->MidpointEdges[vertex - this->InputVertices]].FirstUse;
    while (next >= 0)
    {
      const Node& node = this->Nodes[next / 6];
      use(node.Input);
      next = node.NextUse[next % 6];
    }
  }
  ///@}

  /// Orders new vertices by how many halvings made them, then by the ids of the two ends of their
  /// edge, the smaller one first. Afterwards nothing may be marked any more.
  void SortVertices();

  /// The cells that the output would have now and would not have had before the last Close(), in no
  /// particular order: before the next round criteria need to look at these only. Cells that are
  /// `steps` red splits or more from their input cell are left out. In the first round criteria
  /// have to look at all input cells instead: a cell is the leaf { cell, -1 } unless IsRed(cell).
  Buffer<RedGreenOutputCell<Id>> GetChangedCells(int steps = std::numeric_limits<int>::max()) const;
  bool IsRed(Id cell) const;
  /// A bit for each edge of an input cell (Simplices.h), set where it is split after Close().
  unsigned int GetSplitEdges(Id cell) const
  {
    const Id node = this->Roots[cell];
    return node < 0 ? 0 : this->Nodes[node].Pattern;
  }

  vtkIdType GetNumberOfInputCells() const { return this->Input.NumberOfSimplices; }
  Id GetNumberOfInputVertices() const { return this->InputVertices; }
  Id GetNumberOfVertices() const
  {
    return this->InputVertices + static_cast<Id>(this->MidpointEdges.size());
  }
  /// How many cells the output would have, without cells from input cells that are not Own.
  vtkIdType GetNumberOfCells() const { return this->OutputCells; }

  /// @name Where vertices and cells come from
  ///@{
  /// The ends of the edge whose midpoint is `vertex`, a vertex that this object added (vertex >=
  /// GetNumberOfInputVertices()). The ids of both ends are smaller.
  std::array<Id, 2> GetEnds(Id vertex) const;
  /// The same edge as local edge `Edge` (Simplices.h) of a cell `Cell` of the forest. In the
  /// uniform refinement of the input that cell exists on level GetCell(Cell).Level, and `vertex`
  /// first exists on the next level.
  RedGreenOrigin<Id> GetOrigin(Id vertex) const;
  /// A cell of the forest: an input cell (cell < GetNumberOfInputCells()), or a stored red child.
  Cell GetCell(Id cell) const;
  /// A leaf as a cell of the forest, also if it is not stored.
  Cell GetCell(const Leaf& leaf) const;
  ///@}

  std::size_t GetMemorySize() const;

private:
  friend class RedGreenOutput<Id>;

  struct Edge
  {
    Id Ends[2];
    Id Midpoint;  ///< -1: not split
    Id Halves[2]; ///< the half at each end; -1: not needed yet
    Id FirstUse;  ///< start of the list of nodes that have it, as 6 * node + local edge
  };
  /// A stored cell of the forest.
  struct Node
  {
    Id Vertices[4];
    Id Edges[6]; ///< -1: not looked up, because it cannot be split yet
    Id NextUse[6];
    Id Input;
    Id Parent;     ///< node, -1
    Id FirstChild; ///< node, -1: none is stored
    unsigned char Dimension;
    unsigned char Level;
    unsigned char Child;   ///< which of its parent
    unsigned char Pattern; ///< its split edges, closed
    unsigned char Flagged; ///< how many vertices were flagged when edges were looked up
    bool Changed;          ///< it is among ChangedNodes
  };

  Id FindNode(Id cell) const
  {
    return cell < this->Roots.size() ? this->Roots[cell] : this->GetChildNode(cell);
  }
  template <typename Use>
  void ForChangedParts(Id index, int steps, const Use& use) const;
  Id GetChildNode(Id cell) const { return cell - static_cast<Id>(this->Roots.size()); }
  Id GetPublicId(Id node) const
  {
    const Node& stored = this->Nodes[node];
    return stored.Parent < 0 ? stored.Input : node + static_cast<Id>(this->Roots.size());
  }
  static bool IsNodeRed(const Node& node);
  void GetLattice(const Node& node, Id* lattice) const;
  void ReadInput(Id cell, vtkIdType* vertices) const;

  // cells come into being
  void StoreInputs(const std::vector<Id>& cells);
  Id Activate(Id cell);
  Id GetStored(const Leaf& leaf);
  void LookUpEdges(Id node);
  Id GetEdge(Id node, int k);
  void AddUse(Id node, int k);
  void Settle(Id node);
  void Expand(Id node);

  // edges
  Id AddEdge(Id a, Id b);
  Id FindOrAddEdge(Id a, Id b);
  Id GetHalf(Id edge, int side);
  Id FindMidpointEdge(Id vertex) const;
  bool IsHalfSplit(Id edge);
  bool IsInnerEdgeSplit(const Node& node) const;
  bool HasInputCell(Id a, Id b);
  bool HasUserOfBoth(Id edge, Id second) const;
  CellScope GetScope(vtkIdType cell) const
  {
    return this->Scopes ? this->Scopes[cell] : CellScope::Own;
  }

  // midpoints spread
  void Split(Id edge);
  void SetPattern(Id node, unsigned int pattern);
  void MakeRed(Id node);
  void Spread(Id edge);
  void SpreadToParents(Id edge);
  void MakeUsersRed(Id edge, Id second);

  // cells near split edges
  void FlagEnds(const Edge& edge);
  int CountFlagged(const vtkIdType* vertices, int corners) const;
  bool IsNearFlags(vtkIdType cell, int flagged) const;
  void ActivateNearFlags();
  struct Range
  {
    Id Least;
    Id Most;
  };
  static Range FindRange(const vtkIdType* vertices, vtkIdType size);
  std::vector<Id> ScanCells();
  std::vector<Id> FollowIncidence();
  void BuildIncidence();

  SimplexView Input;
  SimplexStarts Places; ///< of the input cells in the connectivity
  std::function<void(vtkIdType*)> OrderTet;
  const CellScope* Scopes = nullptr; ///< of the input cells; null: all are Own
  Id InputVertices = 0;
  vtkIdType OutputCells = 0;

  SparseIds<Id> Roots; ///< the node of each input cell, -1
  GrowingBuffer<Node> Nodes;
  GrowingBuffer<Edge> Edges;
  PairTable<Id> EdgesByEnds; ///< without the halves of edges that this object split
  GrowingBuffer<Id> MidpointEdges;
  GrowingBuffer<bool> InnerEnds; ///< of new vertices: end of a split edge between midpoints
  std::unordered_map<Id, Id> KnownMidpoints; ///< edge whose midpoint an input vertex is

  GrowingBuffer<Id> Queue;      ///< split edges that were not passed on to the cells at them
  bool HasSplit = false;        ///< since the last Close()
  std::vector<Id> ChangedNodes; ///< since the last Close()
  std::vector<Id> LastChanges;  ///< ChangedNodes of the last Close()

  bool InnerEdgesSplit = false;  ///< whether an edge between midpoints may be split
  bool InnerEndsAreKnown = true; ///< not after AddMidpoint
  Buffer<unsigned char> Flags;   ///< of input vertices: end of a split edge
  std::vector<Id> NewFlags;
  Buffer<Range> BlockRanges;  ///< the least and largest vertex of each block of input cells
  vtkIdType ScannedCells = 0; ///< number, in all scans together
  Rows<Id> Incidence;         ///< cells at each input vertex; empty until it is needed
};

/// The vertices that a state added, by how many halvings made them: first the midpoints between
/// vertices of the input, then the midpoints with one of these at an end, and so on.
template <typename Id>
std::vector<std::vector<Id>> ListByHalvings(const RedGreen<Id>& state)
{
  std::vector<std::vector<Id>> lists;
  const Id given = state.GetNumberOfInputVertices();
  std::vector<unsigned char> halvings(state.GetNumberOfVertices() - given);
  const auto count = [&](Id vertex) { return vertex < given ? 0 : halvings[vertex - given]; };
  for (Id vertex = given; vertex < state.GetNumberOfVertices(); ++vertex)
  {
    const auto ends = state.GetEnds(vertex);
    const int before = std::max(count(ends[0]), count(ends[1]));
    halvings[vertex - given] = static_cast<unsigned char>(before + 1);
    lists.resize(std::max<std::size_t>(lists.size(), before + 1));
    lists[before].push_back(vertex);
  }
  return lists;
}

}

#endif
