// SPDX-License-Identifier: BSD-3-Clause
#include "TetOctCells.h"

#include "TetOctTables.h"

#include <atomic>

namespace subdivision
{
namespace
{

/// One of the cells that a control tetrahedron t has become: the number of the tetrahedron or
/// octahedron is Base + Stride t.
struct Descendant
{
  vtkIdType Base;
  vtkIdType Stride;
  bool IsOct;
  vtkIdType FirstChild; ///< place of its first child among those of t, in output cells
  vtkIdType FirstOct;   ///< the same among octahedra
};

/// The descendants in output order; `tets` control tetrahedra in all.
std::vector<Descendant> ListDescendants(vtkIdType tets, int steps)
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

/// act(descendant, t, i) for each descendant of each tetrahedron t = First + i of a run of `tets`.
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

/// The vertices of one cell and the midpoints of its edges, whether it has a twin or not.
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
  void Read(vtkIdType cell, Id* lattice) const
  {
    constexpr bool isOct = Shape::Vertices == 6;
    const Id* vertices = this->GetVertices(cell, isOct);
    std::copy(vertices, vertices + Shape::Vertices, lattice);
    Id own[Shape::Edges];
    const Id* edges =
      (isOct ? this->Level.OctEdges : this->Level.Complex.TetEdges).data() + Shape::Edges * cell;
    Id twin = static_cast<Id>(cell);
    if (this->Equal)
    {
      if constexpr (isOct)
      {
        GetEdgesOfEqualOct(this->Level, cell, own);
        twin = this->Level.EqualOcts.Twins[cell];
      }
      else
      {
        GetEdgesOfEqualTet(this->Level.Complex, cell, own);
      }
      edges = own;
    }
    for (int e = 0; e < Shape::Edges; ++e)
    {
      lattice[Shape::Vertices + e] = this->Ids.Midpoint(edges[e]);
    }
    if constexpr (isOct)
    {
      lattice[Shape::Points - 1] = this->Ids.Centre(twin);
    }
  }

private:
  const TetOctLevel<Id>& Level;
  const TetOctIds<Id> Ids;
  const bool Equal;
};

/// Of a sorted octahedron.
template <typename Id, typename T>
int FindShortestDiagonal(const Id vertices[6], const T* points)
{
  constexpr double tolerance = sizeof(T) < sizeof(double) ? 1e-5 : 1e-9;
  double lengths[3];
  for (int pair = 0; pair < 3; ++pair)
  {
    const T* p = points + 3 * vtkIdType(vertices[2 * pair]);
    const T* q = points + 3 * vtkIdType(vertices[2 * pair + 1]);
    lengths[pair] = 0.;
    for (int c = 0; c < 3; ++c)
    {
      const double difference = static_cast<double>(p[c]) - static_cast<double>(q[c]);
      lengths[pair] += difference * difference;
    }
  }
  const double limit = std::min({ lengths[0], lengths[1], lengths[2] }) * (1. + tolerance);
  return lengths[0] <= limit ? 0 : lengths[1] <= limit ? 1 : lengths[2] <= limit ? 2 : 0;
}

template <typename Shape, typename Id, typename Out, typename T>
void WriteChildrenOf(const LatticeReader<Id>& reader, vtkIdType cell, const T* points, Out* out)
{
  Id lattice[Shape::Points];
  reader.template Read<Shape>(cell, lattice);
  auto writeTets = [&]()
  {
    for (const auto& child : Children<Shape>.Tets)
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
  for (const auto& child : Children<Shape>.Octs)
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
}

/// Runs of solids in units of control tetrahedra.
struct SolidRun
{
  vtkIdType First;
  vtkIdType Count;
};
SolidRun ToControl(const CellRun& run, int steps)
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

template <typename Id, typename Out, typename T>
void WriteTetOctChildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs,
  const T* points, const CellStorage<Out>& out)
{
  WriteChildren(level.Complex, runs, out, 2);
  const std::vector<CellRun> children = RefineRuns(runs, 1);
  const vtkIdType perTet = vtkIdType(32) << (3 * level.Steps); // entries of the connectivity
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    if (runs[r].Dimension < 3)
    {
      continue;
    }
    const SolidRun run = ToControl(runs[r], level.Steps);
    const LatticeReader<Id> reader(level, runs[r].Equal);
    Out* connectivity = out.Connectivity + children[r].FirstEntry;
    ForDescendants(ListDescendants(level, runs[r].Equal), run.Count,
      [&](const Descendant& cell, vtkIdType i)
      {
        const vtkIdType number = cell.Base + cell.Stride * (run.First + i);
        Out* first = connectivity + i * perTet + 4 * cell.FirstChild;
        if (cell.IsOct)
        {
          WriteChildrenOf<OctShape>(reader, number, points, first);
        }
        else
        {
          WriteChildrenOf<TetShape>(reader, number, points, first);
        }
      });
  }
}

void NumberOctahedra(const std::vector<CellRun>& runs, int steps, vtkIdType* numbers)
{
  const std::vector<Descendant> parents = ListDescendants(vtkIdType(0), std::max(steps - 1, 0));
  const vtkIdType cellsPerTet = vtkIdType(1) << (3 * steps);
  const vtkIdType octsPerTet =
    steps == 0 ? 0 : parents.back().FirstOct + (parents.back().IsOct ? 6 : 1);
  vtkIdType before = 0;
  for (const CellRun& run : runs)
  {
    vtkIdType* first = numbers + run.FirstCell;
    if (run.Dimension < 3 || steps == 0)
    {
      ForRanges(run.Count,
        [first](vtkIdType begin, vtkIdType end)
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

/// Its pieces follow each other, four cells with the same number.
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

namespace
{

/// Calls solid(cell of the level, is it an octahedron, reader, place of its first output cell) and
/// low(run) for the cells of a level; false as soon as one of them says so.
template <typename Id, typename Solid>
bool EachSolid(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, const Solid& solid)
{
  for (const CellRun& run : runs)
  {
    if (run.Dimension < 3)
    {
      continue;
    }
    const SolidRun tets = ToControl(run, level.Steps);
    const std::vector<Descendant> list = ListDescendants(level, run.Equal);
    const LatticeReader<Id> reader(level, run.Equal);
    vtkIdType place = run.FirstCell;
    for (vtkIdType i = 0; i < tets.Count; ++i)
    {
      for (const Descendant& cell : list)
      {
        const vtkIdType number = cell.Base + cell.Stride * (tets.First + i);
        if (!solid(reader.GetVertices(number, cell.IsOct), cell.IsOct, place))
        {
          return false;
        }
        place += cell.IsOct ? 4 : 1;
      }
    }
  }
  return true;
}

/// Where the vertices of each cell are in the connectivity of a list.
std::vector<vtkIdType> FindEntries(const SimplexList& cells)
{
  std::vector<vtkIdType> entries;
  entries.reserve(cells.Dimensions.size());
  vtkIdType entry = 0;
  for (unsigned char dimension : cells.Dimensions)
  {
    entries.push_back(entry);
    entry += dimension + 1;
  }
  return entries;
}

template <typename Id>
void CopySorted(const Id* vertices, vtkIdType sorted[6])
{
  std::copy(vertices, vertices + 6, sorted);
  SortOctahedron(sorted);
}

}

template <typename Id>
bool HasCells(
  const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, const SimplexList& cells)
{
  const CellCounts counts = CountCells(runs);
  if (counts.Cells != cells.GetNumberOfSimplices() ||
    level.Complex.NumberOfVertices != cells.NumberOfPoints)
  {
    return false;
  }
  const std::vector<vtkIdType> entries = FindEntries(cells);
  const vtkIdType* connectivity = cells.Connectivity.data();
  for (const CellRun& run : runs)
  {
    if (run.Dimension < 3)
    {
      const std::vector<CellRun> alone = RefineRuns({ run }, 0);
      Buffer<long long> written(run.Count * (run.Dimension + 1));
      Buffer<long long> offsets(run.Count + 1);
      Buffer<unsigned char> types(run.Count);
      WriteCells(level.Complex, alone,
        CellStorage<long long>{ written.data(), offsets.data(), types.data() });
      if (!std::equal(written.begin(), written.end(), connectivity + run.FirstEntry))
      {
        return false;
      }
    }
  }
  return EachSolid(level, runs,
    [&](const Id* vertices, bool isOct, vtkIdType place)
    {
      const vtkIdType* read = connectivity + entries[place];
      if (!isOct)
      {
        return std::equal(vertices, vertices + 4, read);
      }
      vtkIdType sorted[6];
      CopySorted(vertices, sorted);
      for (int diagonal = 0; diagonal < 3; ++diagonal)
      {
        vtkIdType tets[16];
        CutOctahedron(sorted, diagonal, tets);
        if (std::equal(tets, tets + 16, read))
        {
          return true;
        }
      }
      return false;
    });
}

template <typename Id>
std::vector<vtkIdType> FindParents(
  const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, const SimplexList& cells)
{
  std::vector<vtkIdType> parents;
  std::vector<vtkIdType> firsts;
  for (std::size_t i = 0; i < cells.Dimensions.size(); ++i)
  {
    firsts.push_back(static_cast<vtkIdType>(parents.size()));
    parents.insert(parents.end(), std::size_t(1) << cells.Dimensions[i], static_cast<vtkIdType>(i));
  }
  const std::vector<vtkIdType> entries = FindEntries(cells);
  EachSolid(level, runs,
    [&](const Id* vertices, bool isOct, vtkIdType place)
    {
      if (!isOct)
      {
        return true;
      }
      const vtkIdType* tets = cells.Connectivity.data() + entries[place];
      auto findPiece = [&](std::initializer_list<int> corners)
      {
        int piece = 0;
        auto lies = [&](int corner)
        {
          const vtkIdType* tet = tets + 4 * piece;
          return std::find(tet, tet + 4, static_cast<vtkIdType>(vertices[corner])) != tet + 4;
        };
        while (piece < 3 && !std::all_of(corners.begin(), corners.end(), lies))
        {
          ++piece;
        }
        return place + piece;
      };
      vtkIdType* out = parents.data() + firsts[place];
      for (int v = 0; v < 6; ++v)
      {
        std::fill_n(out + 4 * v, 4, findPiece({ v }));
      }
      for (int f = 0; f < 8; ++f)
      {
        const int* corners = octahedron::FaceVertices[f];
        out[24 + f] = findPiece({ corners[0], corners[1], corners[2] });
      }
      return true;
    });
  return parents;
}

#define SUBDIVISION_WRITE(Id, Out, T)                                                              \
  template void WriteTetOctChildren(                                                               \
    const TetOctLevel<Id>&, const std::vector<CellRun>&, const T*, const CellStorage<Out>&)
#define SUBDIVISION_CELLS(Id)                                                                      \
  SUBDIVISION_WRITE(Id, int, float);                                                               \
  SUBDIVISION_WRITE(Id, int, double);                                                              \
  SUBDIVISION_WRITE(Id, long long, float);                                                         \
  SUBDIVISION_WRITE(Id, long long, double);                                                        \
  template bool HasCells(const TetOctLevel<Id>&, const std::vector<CellRun>&, const SimplexList&); \
  template std::vector<vtkIdType> FindParents(                                                     \
    const TetOctLevel<Id>&, const std::vector<CellRun>&, const SimplexList&)
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
