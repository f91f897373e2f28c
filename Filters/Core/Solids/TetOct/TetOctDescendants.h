// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctDescendants.h
 * The solids of a tet/oct level in output order, in which the solids of one control tetrahedron
 * follow each other (TetOctCells.h).
 */
#ifndef SubdivisionObjects_TetOctDescendants_h
#define SubdivisionObjects_TetOctDescendants_h

#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/TetOct/TetOctSplit.h"

#include <vector>

namespace subdivision
{

/// One of the cells that a control tetrahedron t has become: the number of the tetrahedron or
/// octahedron is Base + Stride t.
struct Descendant
{
  vtkIdType Base;
  vtkIdType Stride;
  bool IsOct;
  vtkIdType FirstChild; ///< position of its first child among the cells of t
  vtkIdType FirstOct;   ///< the same among octahedra
};

/// The descendants of a control tetrahedron in output order, `steps` steps later. `tets` is the
/// number of all control tetrahedra.
inline std::vector<Descendant> ListDescendants(vtkIdType tets, int steps)
{
  std::vector<Descendant> list = { { 0, 1, false, 0, 0 } };
  vtkIdType octs = 0;
  for (int step = 0; step < steps; ++step)
  {
    std::vector<Descendant> next;
    for (const Descendant& cell : list)
    {
      auto append = [&](bool isOct, vtkIdType first, int children)
      {
        for (int i = 0; i < children; ++i)
        {
          next.push_back({ first + children * cell.Base + i, children * cell.Stride, isOct, 0, 0 });
        }
      };
      if (cell.IsOct)
      {
        append(true, tets, 6);
        append(false, 4 * tets, 8);
      }
      else
      {
        append(false, 0, 4);
        append(true, 0, 1);
      }
    }
    const vtkIdType parents = tets;
    tets = 4 * tets + 8 * octs;
    octs = parents + 6 * octs;
    list = std::move(next);
  }
  vtkIdType child = 0;
  vtkIdType oct = 0;
  for (Descendant& cell : list)
  {
    cell.FirstChild = child;
    cell.FirstOct = oct;
    child += cell.IsOct ? 32 : 8;
    oct += cell.IsOct ? 6 : 1;
  }
  return list;
}

/// act(descendant, i) for each descendant of each tetrahedron i of a run of `tets`.
template <typename Act>
void ForDescendants(const std::vector<Descendant>& list, vtkIdType tets, const Act& act)
{
  const vtkIdType size = static_cast<vtkIdType>(list.size());
  ForRanges(tets * size,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType tet = begin / size;
      vtkIdType k = begin % size;
      for (vtkIdType i = begin; i < end; ++i)
      {
        act(list[k], tet);
        if (++k == size)
        {
          k = 0;
          ++tet;
        }
      }
    });
}

/// Reads the lattice points of cells of a level or, if `equal`, of its EqualCells.
template <typename Id>
class LatticeReader
{
public:
  LatticeReader(const TetOctLevel<Id>& level, bool equal)
    : Level(level)
    , Ids(level)
    , Equal(equal)
  {
  }
  const Id* GetVertices(vtkIdType cell, bool isOct) const
  {
    const Buffer<Id>* lists[2][2] = { { &this->Level.Complex.TetVertices,
                                        &this->Level.OctVertices },
      { &this->Level.Complex.EqualTets.Vertices, &this->Level.EqualOcts.Vertices } };
    return lists[this->Equal][isOct]->data() + (isOct ? 6 : 4) * cell;
  }
  template <typename Shape>
  SolidLattice<Shape, Id> Read(Id cell) const
  {
    const SolidList<Id> list = TetOctSplit<Id>::GetSolids(this->Level, Shape());
    if (!this->Equal)
    {
      return { list, this->Ids, cell };
    }
    Id edges[Shape::Edges];
    GetEdgesOfEqual<Shape>(list, cell, edges);
    return { this->Ids, list.Equal->Vertices.data() + Shape::Vertices * vtkIdType(cell), edges,
      list.Equal->Twins[cell] };
  }

private:
  const TetOctLevel<Id>& Level;
  const ChildIds<TetOctSplit<Id>> Ids;
  const bool Equal;
};

/// A run of solids, counted in control tetrahedra.
struct SolidRun
{
  vtkIdType First;
  vtkIdType Count;
};
inline SolidRun ToControl(const CellRun& run, int steps)
{
  return { run.First >> (3 * steps), run.Count >> (3 * steps) };
}

template <typename Id>
std::vector<Descendant> ListDescendants(const TetOctLevel<Id>& level, bool equal)
{
  const vtkIdType cells =
    equal ? level.Complex.EqualTets.Twins.size() : vtkIdType(level.Complex.NumberOfTets);
  const vtkIdType octs = equal ? level.EqualOcts.Twins.size() : vtkIdType(level.NumberOfOctahedra);
  return ListDescendants((cells + 4 * octs) >> (3 * level.Steps), level.Steps);
}

}

#endif
