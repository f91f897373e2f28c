// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreen.h
 * Local refinement of a mixed-dimension complex that stays conforming (Mathematics 13; section 4.2
 * and figure 17 of Chang & Qin).
 *
 * The state is a forest: its trees are the input cells and their *red* children (Mathematics 2: the
 * order of the vertices, and with it the diagonal, is inherited), its *leaves* the cells that are
 * not red. Beside it there is nothing but the set of edges that have a midpoint. Green children are
 * never part of the state: they are what the midpoints on its edges make of a leaf, written with
 * the output and forgotten.
 *
 * A round: marks, then Close(). Closing makes the set of midpoints the smallest that contains the
 * marks and has
 *  - on each triangle, and so on each face of a tetrahedron, 0, 1 or 3 split edges;
 *  - no leaf with an edge of which a half is split, or with a face of three split edges where an
 *    edge between their midpoints is split: such leaves become red.
 * The set is a closure: it does not depend on the order of marks or rounds. The numbers of new
 * vertices do, and on nothing else.
 *
 * Cost: a cell of the input is read when a mark comes near, and stored (*active*) when two of its
 * vertices are ends of split edges: only such a cell can have a split edge. Which cells these are
 * is found by scanning for flagged vertices, in threads, those blocks of cells whose range of
 * vertices has newly flagged ones; after a few times all cells an incidence from vertices to cells
 * takes over. Red children are stored when something happens to one of them.
 * So work and memory are those of the cells that change, plus a few passes at memory speed.
 * Threads: scans, and all that RedGreenOutput does; spreading from cell to cell is sequential, and
 * so the same whatever their number. Memory (Id int): 1 byte per input point, 4 per input cell of
 * each page of 4096 where one is stored; 88 bytes per stored cell, 24 per edge of these that is
 * looked up, 12 to 96 for its place in the index, 4 per new vertex: 200 to 300 bytes per stored
 * cell in all, that is some 50 per cell of an output that is refined all over. Lists grow by
 * doubling. Id int is enough for 300 million stored cells.
 */
#ifndef SubdivisionObjects_RedGreen_h
#define SubdivisionObjects_RedGreen_h

#include "Core/Memory/GrowingBuffer.h"
#include "Core/Memory/PairTable.h"
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

  /// The arrays of the view must stay; `orderTet` puts the vertices of an input tetrahedron of
  /// level 0 into their final order (TetOrder.h) when it is first needed; none: they are in order.
  explicit RedGreen(const SimplexView& cells, std::function<void(vtkIdType*)> orderTet = nullptr);

  /// For a mesh whose green cells were replaced by their leaves: a vertex of the input that is the
  /// midpoint of an edge of a leaf. Before any mark; the next Close() heeds it. Midpoints that no
  /// refinement can have made may lead to cells without end: marks and Close() throw
  /// std::invalid_argument at LastLevel then.
  void AddMidpoint(Id end0, Id end1, Id midpoint);

  /// @name A round
  ///@{
  /// Cells of the input that are about to be marked: to store them together is faster.
  void Expect(const std::vector<Id>& cells);
  /// All edges of a leaf: it becomes red. A cell that is red already is left alone.
  void MarkCell(const Leaf& leaf);
  /// An edge of the cells that the output would have in place of a leaf. A red or green edge inside
  /// the leaf makes it red: that edge vanishes, or it is an edge between two midpoints and is
  /// split.
  void MarkEdge(const Leaf& leaf, Id end0, Id end1);
  /// To the fixed point. Says whether any edge was split since the Close() before.
  bool Close();
  ///@}

  /// The cells that the output would have and that it did not have before the last Close(), in no
  /// special order: where criteria need to look before the next round. Those that are `steps` red
  /// steps or more from the input are left out. In the first round, each input cell is to be looked
  /// at: it is the leaf { cell, -1 } unless IsRed.
  Buffer<RedGreenOutputCell<Id>> GetChangedCells(int steps = std::numeric_limits<int>::max()) const;
  bool IsRed(Id cell) const;

  vtkIdType GetNumberOfInputCells() const { return this->Input.NumberOfSimplices; }
  Id GetNumberOfInputVertices() const { return this->InputVertices; }
  Id GetNumberOfVertices() const
  {
    return this->InputVertices + static_cast<Id>(this->MidpointEdges.size());
  }
  /// How many cells the output would have.
  vtkIdType GetNumberOfCells() const { return this->OutputCells; }

  /// @name Where vertices and cells come from
  ///@{
  /// The ends of the edge whose midpoint a vertex is that refinement added (vertex >= input
  /// vertices). Both are smaller than the vertex.
  std::array<Id, 2> GetEnds(Id vertex) const;
  /// The same as an edge of a tree cell: in the uniform refinement of the input, `vertex` is the
  /// edge point of local edge `Edge` (Simplices.h) of the cell `Cell`, which has level
  /// GetCell(Cell).Level; on the next level it is a vertex for the first time.
  RedGreenOrigin<Id> GetOrigin(Id vertex) const;
  /// A tree cell: an input cell (cell < input cells), or a red child that is stored.
  Cell GetCell(Id cell) const;
  /// A leaf as the cell that it is; `Parent` and `Child` tell its place in the tree.
  Cell GetCell(const Leaf& leaf) const;
  ///@}

  std::size_t GetMemorySize() const;

private:
  friend class RedGreenOutput<Id>;

  struct Edge
  {
    Id Ends[2];
    Id Midpoint;  ///< -1: whole
    Id Halves[2]; ///< beside each end; -1: not needed yet
    Id FirstUse;  ///< list of the nodes that have it: 6 * node + local edge
  };
  /// A stored cell of the forest.
  struct Node
  {
    Id Vertices[4];
    Id Edges[6]; ///< -1: not looked up, because no cell can have split it
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
  SimplexPlaces Places;
  std::function<void(vtkIdType*)> OrderTet;
  Id InputVertices = 0;
  vtkIdType OutputCells = 0;

  SparseIds<Id> Roots; ///< the node of each input cell, -1
  GrowingBuffer<Node> Nodes;
  GrowingBuffer<Edge> Edges;
  PairTable<Id> EdgesByEnds; ///< but for the halves of edges of this run
  GrowingBuffer<Id> MidpointEdges;
  std::unordered_map<Id, Id> KnownMidpoints; ///< edges, by vertices of the input

  GrowingBuffer<Id> Queue;      ///< edges that were split, and whose cells do not know yet
  std::vector<Id> ChangedNodes; ///< since the last Close()
  std::vector<Id> LastChanges;  ///< from the Close() before that to the last

  bool InnerEdgesSplit = false; ///< whether any edge between midpoints may be
  Buffer<unsigned char> Flags;  ///< of input vertices: end of a split edge
  std::vector<Id> NewFlags;
  Buffer<Range> BlockRanges;  ///< the vertices that blocks of input cells have
  vtkIdType ScannedCells = 0; ///< in all scans
  Rows<Id> Incidence;         ///< cells at each input vertex; empty until it is needed
};

#define SUBDIVISION_RED_GREEN(EXTERN, Id) EXTERN template class RedGreen<Id>
SUBDIVISION_RED_GREEN(extern, int);
SUBDIVISION_RED_GREEN(extern, long long);

}

#endif
