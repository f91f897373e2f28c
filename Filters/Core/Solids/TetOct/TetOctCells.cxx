// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TetOct/TetOctCells.h"

#include "Core/Solids/TetOct/TetOctDescendants.h"

#include <atomic>

namespace subdivision
{
namespace
{

/// The children of a cell with these lattice points; returns where the next goes.
template <typename Shape, typename Id, typename Out, typename T>
Out* WritePieces(const Id* lattice, const T* points, Out* out)
{
  auto writeTets = [&]()
  {
    for (const auto& child : Children<Shape, TetShape>.Points)
    {
      for (int point : child)
      {
        *out++ = static_cast<Out>(lattice[point]);
      }
    }
  };
  if (Shape::Vertices == 4)
  {
    writeTets();
  }
  for (const auto& child : Children<Shape, OctShape>.Points)
  {
    Id vertices[6];
    for (int i = 0; i < 6; ++i)
    {
      vertices[i] = lattice[child[i]];
    }
    SortOctahedron(vertices);
    CutOctahedron(vertices, points ? FindShortestDiagonal(vertices, points) : 0, out);
    out += 16;
  }
  if (Shape::Vertices == 6)
  {
    writeTets();
  }
  return out;
}

/// Writes the children of the children of a cell.
template <typename Id, typename Out, typename T>
class GrandchildrenWriter
{
public:
  GrandchildrenWriter(const TetOctLevel<Id>& level, const T* points)
    : Level(level)
    , Ids(level)
    , Midpoints(this->Ids.GetNumberOfVertices())
    , Centres(this->Midpoints + this->Ids.GetNumberOfEdges())
    , Points(points)
  {
  }
  void Write(Id cell, bool isOct, Out* out) const
  {
    if (isOct)
    {
      const SolidParts<OctShape, Id> parts = this->Split<OctShape>(cell);
      out = this->WriteOcts(parts, this->Ids.template ChildOf<OctShape, OctShape>(cell, 0), out);
      this->WriteTets(parts, out);
    }
    else
    {
      const SolidParts<TetShape, Id> parts = this->Split<TetShape>(cell);
      out = this->WriteTets(parts, out);
      this->WriteOcts(parts, this->Ids.template ChildOf<TetShape, OctShape>(cell, 0), out);
    }
  }

private:
  template <typename Shape>
  SolidParts<Shape, Id> Split(Id cell) const
  {
    return { this->Level.Complex, TetOctSplit<Id>::GetSolids(this->Level, Shape()), this->Ids,
      cell };
  }
  template <typename Child, typename Shape>
  void GetLattice(const SolidParts<Shape, Id>& parts, std::size_t child, Id* lattice) const
  {
    const auto& table = Children<Shape, Child>;
    for (int i = 0; i < Child::Vertices; ++i)
    {
      lattice[i] = parts.Lattice.Points[table.Points[child][i]];
    }
    for (int e = 0; e < Child::Edges; ++e)
    {
      lattice[Child::Vertices + e] = this->Midpoints + parts.Edges[table.Edges[child][e]];
    }
  }
  template <typename Shape>
  Out* WriteTets(const SolidParts<Shape, Id>& parts, Out* out) const
  {
    for (int c = 0; c < ChildrenOf<Shape, TetShape>; ++c)
    {
      Id lattice[PointsOf<TetShape>];
      this->template GetLattice<TetShape>(parts, c, lattice);
      out = WritePieces<TetShape>(lattice, this->Points, out);
    }
    return out;
  }
  template <typename Shape>
  Out* WriteOcts(const SolidParts<Shape, Id>& parts, Id firstOct, Out* out) const
  {
    for (int c = 0; c < ChildrenOf<Shape, OctShape>; ++c)
    {
      Id lattice[PointsOf<OctShape>];
      this->template GetLattice<OctShape>(parts, c, lattice);
      lattice[OctShape::Centre] = this->Centres + firstOct + c;
      out = WritePieces<OctShape>(lattice, this->Points, out);
    }
    return out;
  }

  const TetOctLevel<Id>& Level;
  const ChildIds<TetOctSplit<Id>> Ids;
  const Id Midpoints; ///< of the edges of the children
  const Id Centres;
  const T* Points;
};

/// Calls write(whether the solid is in EqualCells, its number there or in the level, whether it is
/// an octahedron, the position in the connectivity of its descendants after `steps` steps) for each
/// solid of a level.
template <typename Id, typename Out, typename Write>
void ForSolids(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, int steps,
  Out* connectivity, const Write& write)
{
  const std::vector<CellRun> descendants = RefineRuns(runs, steps);
  const vtkIdType perChild = vtkIdType(4) << (3 * (steps - 1)); // entries of the connectivity
  const vtkIdType perTet = vtkIdType(4) << (3 * (level.Steps + steps));
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    if (runs[r].Dimension < 3)
    {
      continue;
    }
    const bool equal = runs[r].Equal;
    const SolidRun run = ToControl(runs[r], level.Steps);
    Out* first = connectivity + descendants[r].FirstEntry;
    ForDescendants(ListDescendants(level, equal), run.Count,
      [&](const Descendant& cell, vtkIdType i)
      {
        write(equal, static_cast<Id>(cell.Base + cell.Stride * (run.First + i)), cell.IsOct,
          first + i * perTet + perChild * cell.FirstChild);
      });
  }
}

}

template <typename Id, typename Out, typename T>
void WriteTetOctChildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs,
  const T* points, const CellStorage<Out>& out)
{
  WriteChildren(level.Complex, runs, out, 2);
  const LatticeReader<Id> readers[2] = { { level, false }, { level, true } };
  ForSolids(level, runs, 1, out.Connectivity,
    [&](bool equal, Id cell, bool isOct, Out* first)
    {
      if (isOct)
      {
        WritePieces<OctShape>(readers[equal].template Read<OctShape>(cell).Points, points, first);
      }
      else
      {
        WritePieces<TetShape>(readers[equal].template Read<TetShape>(cell).Points, points, first);
      }
    });
}

template <typename Id, typename Out, typename T>
void WriteTetOctGrandchildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs,
  const T* points, const CellStorage<Out>& out)
{
  WriteGrandchildren(level.Complex, runs, out, 2, level.NumberOfOctahedra);
  const GrandchildrenWriter<Id, Out, T> writer(level, points);
  ForSolids(level, runs, 2, out.Connectivity,
    [&](bool, Id cell, bool isOct, Out* first) { writer.Write(cell, isOct, first); });
}

void NumberOctahedra(const std::vector<CellRun>& runs, int steps, vtkIdType* numbers)
{
  // The solids one step before the output, among the descendants of one control tetrahedron. Each
  // control tetrahedron becomes 8^steps output cells.
  const bool hasSolids = std::any_of(runs.begin(), runs.end(),
    [](const CellRun& run) { return run.Dimension == 3 && run.Count > 0; });
  const std::vector<Descendant> parents =
    hasSolids && steps > 0 ? ListDescendants(vtkIdType(0), steps - 1) : std::vector<Descendant>();
  const vtkIdType cellsPerTet = vtkIdType(1) << (3 * steps);
  const vtkIdType octsPerTet =
    parents.empty() ? 0 : parents.back().FirstOct + (parents.back().IsOct ? 6 : 1);
  vtkIdType before = 0;
  for (const CellRun& run : runs)
  {
    vtkIdType* first = numbers + run.FirstCell;
    if (run.Dimension < 3 || parents.empty())
    {
      ForRanges(run.Count, [first](vtkIdType begin, vtkIdType end)
        { std::fill(first + begin, first + end, vtkIdType(-1)); });
      continue;
    }
    const vtkIdType tets = ToControl(run, steps).Count;
    ForDescendants(parents, tets,
      [&](const Descendant& parent, vtkIdType i)
      {
        vtkIdType* out = first + i * cellsPerTet + parent.FirstChild;
        vtkIdType* octs = parent.IsOct ? out : out + 4;
        std::fill_n(parent.IsOct ? out + 24 : out, parent.IsOct ? 8 : 4, vtkIdType(-1));
        const vtkIdType number = before + i * octsPerTet + parent.FirstOct;
        for (int oct = 0; oct < (parent.IsOct ? 6 : 1); ++oct)
        {
          std::fill_n(octs + 4 * oct, 4, number + oct);
        }
      });
    before += tets * octsPerTet;
  }
}

namespace
{

/// Whether a cell is the first of the four pieces of an octahedron, which are consecutive and have
/// the same number.
bool IsFirstPiece(const vtkIdType* octahedra, vtkIdType cell)
{
  return octahedra[cell] >= 0 && (cell == 0 || octahedra[cell - 1] != octahedra[cell]);
}

}

template <typename Out, typename T>
void TurnOctahedra(const vtkIdType* octahedra, vtkIdType cells, const Out* offsets,
  Out* connectivity, const T* points)
{
  ForEach(cells,
    [&](vtkIdType i)
    {
      if (IsFirstPiece(octahedra, i))
      {
        Out* tets = connectivity + offsets[i];
        vtkIdType vertices[6];
        JoinOctahedron(tets, vertices);
        const vtkIdType first = vertices[0]; // an end of the diagonal that it has
        SortOctahedron(vertices);
        const int diagonal = FindShortestDiagonal(vertices, points);
        if (vertices[2 * diagonal] != first && vertices[2 * diagonal + 1] != first)
        {
          CutOctahedron(vertices, diagonal, tets);
        }
      }
    });
}

template <typename Out, typename T>
bool AreTurned(const vtkIdType* octahedra, vtkIdType cells, const Out* offsets,
  const Out* connectivity, const T* points)
{
  std::atomic<bool> turned(true);
  ForEach(cells,
    [&](vtkIdType i)
    {
      if (IsFirstPiece(octahedra, i))
      {
        const Out* tets = connectivity + offsets[i];
        vtkIdType vertices[6];
        vtkIdType wanted[16];
        JoinOctahedron(tets, vertices);
        SortOctahedron(vertices);
        CutOctahedron(vertices, FindShortestDiagonal(vertices, points), wanted);
        if (!std::equal(tets, tets + 16, wanted))
        {
          turned.store(false, std::memory_order_relaxed);
        }
      }
    });
  return turned;
}

#define SUBDIVISION_WRITE(Id, Out, T)                                                              \
  template void WriteTetOctChildren(                                                               \
    const TetOctLevel<Id>&, const std::vector<CellRun>&, const T*, const CellStorage<Out>&);       \
  template void WriteTetOctGrandchildren(                                                          \
    const TetOctLevel<Id>&, const std::vector<CellRun>&, const T*, const CellStorage<Out>&)
#define SUBDIVISION_CELLS(Id)                                                                      \
  SUBDIVISION_WRITE(Id, int, float);                                                               \
  SUBDIVISION_WRITE(Id, int, double);                                                              \
  SUBDIVISION_WRITE(Id, long long, float);                                                         \
  SUBDIVISION_WRITE(Id, long long, double)
SUBDIVISION_CELLS(int);
SUBDIVISION_CELLS(long long);

#define SUBDIVISION_TURN(Out, T)                                                                   \
  template void TurnOctahedra(const vtkIdType*, vtkIdType, const Out*, Out*, const T*);            \
  template bool AreTurned(const vtkIdType*, vtkIdType, const Out*, const Out*, const T*)
SUBDIVISION_TURN(int, float);
SUBDIVISION_TURN(int, double);
SUBDIVISION_TURN(long long, float);
SUBDIVISION_TURN(long long, double);

}
