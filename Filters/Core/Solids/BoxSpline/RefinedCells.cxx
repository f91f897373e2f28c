// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/BoxSpline/RefinedCells.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/BoxSpline/SignOfChildren.h"
#include "Core/Solids/Scheme/EqualSimplices.h"

#include "vtkCellType.h"

#include <array>
#include <utility>

namespace subdivision
{
namespace
{

constexpr unsigned char TypeOfDimension[4] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };

/// Types and offsets of a run.
template <typename Out>
void WriteLayout(const CellRun& run, const CellStorage<Out>& out)
{
  const vtkIdType corners = run.Dimension + 1;
  const vtkIdType firstEntry = run.FirstEntry;
  unsigned char* types = out.Types + run.FirstCell;
  Out* offsets = out.Offsets + run.FirstCell;
  ForRanges(run.Count,
    [=](vtkIdType begin, vtkIdType end)
    {
      std::fill(types + begin, types + end, TypeOfDimension[run.Dimension]);
      for (vtkIdType i = begin; i < end; ++i)
      {
        offsets[i] = static_cast<Out>(firstEntry + corners * i);
      }
    });
}

/// The vertices of the cells that a run takes.
template <typename Id>
const Id* GetVertices(const SimplicialComplex<Id>& complex, const CellRun& run)
{
  const Buffer<Id>* lists[4][2] = { { &complex.VertexCells, nullptr },
    { &complex.EdgeVertices, &complex.EqualLines.Vertices },
    { &complex.FaceVertices, &complex.EqualTriangles.Vertices },
    { &complex.TetVertices, &complex.EqualTets.Vertices } };
  return lists[run.Dimension][run.Equal]->data() + (run.Dimension + 1) * run.First;
}

/// Writes the children of a run's cells by `table`. lattice(i, points) gives the lattice points of
/// the `Parents` cells that cell i of the complex consists of: itself, or its children.
template <int Parents, int Children, int Corners, typename Out, typename Lattice>
void WriteChildrenOfRun(
  const CellRun& run, const int (&table)[Children][Corners], Out* out, const Lattice& lattice)
{
  constexpr int size = Corners * (Corners + 1) / 2; // of a lattice
  ForEach(run.Count,
    [&](vtkIdType i)
    {
      Out points[Parents * size];
      lattice(run.First + i, points);
      Out* next = out + i * (Parents * Children * Corners);
      for (int parent = 0; parent < Parents; ++parent)
      {
        for (const auto& child : table)
        {
          for (int corner : child)
          {
            *next++ = points[parent * size + corner];
          }
        }
      }
    });
}

/// The number in a TetLattice of each corner of each child, one after the other.
template <int Parents>
constexpr auto MakeCornerPlaces()
{
  std::array<unsigned char, 32 * Parents> places{};
  std::size_t next = 0;
  for (const auto& points : TetLatticeOf<Parents>.Points)
  {
    for (const auto& child : tetrahedron::Children)
    {
      for (const int corner : child)
      {
        places[next++] = points[static_cast<std::size_t>(corner)];
      }
    }
  }
  return places;
}

/// Writes the children without a loop, so that these numbers are constants.
template <int Parents, typename Out, std::size_t... Corner>
void WriteByTable(const Out* ids, Out* out, std::index_sequence<Corner...>)
{
  constexpr auto places = MakeCornerPlaces<Parents>();
  ((out[Corner] = ids[places[Corner]]), ...);
}

/// The same for tetrahedra, with a look at their volumes. `signs`: one for each cell of the run, or
/// null. lattice(i, points) gives the points of the TetLattice.
template <int Parents, typename Out, typename Lattice>
void WriteChildrenOfTets(const CellRun& run, Out* out, const Lattice& lattice,
  const StoredPoints& points, signed char* signs)
{
  const SignOfChildren<Parents> sign(points);
  signed char* known = points.Single || points.Double ? signs : nullptr;
  ForEach(run.Count,
    [&](vtkIdType i)
    {
      Out ids[TetLattice<Parents>::Size];
      lattice(run.First + i, ids);
      WriteByTable<Parents>(
        ids, out + i * (32 * Parents), std::make_index_sequence<32 * Parents>());
      if (known)
      {
        known[i] = sign.Find(ids);
      }
    });
}

/// The lattice points of `count` cells: their vertices, then the midpoints of their edges.
template <int Corners, typename Id, typename Out>
void CopyLattices(const Id* vertices, const Id* edges, int count, Id midpoints, Out* points)
{
  constexpr int edgesOfCell = Corners * (Corners - 1) / 2;
  for (int i = 0; i < count; ++i)
  {
    for (int k = 0; k < Corners; ++k)
    {
      *points++ = static_cast<Out>(vertices[Corners * i + k]);
    }
    for (int k = 0; k < edgesOfCell; ++k)
    {
      *points++ = static_cast<Out>(midpoints + edges[edgesOfCell * i + k]);
    }
  }
}

constexpr int VertexChildren[1][1] = { { 0 } };
constexpr int LineChildren[2][2] = { { 0, 2 }, { 2, 1 } };

/// Writes the cells of runs after some steps: the layout of all and, up to a dimension, vertices.
/// write(run, connectivity, signs) writes other cells up to it.
template <typename Id, typename Out, typename Write>
void WriteRuns(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int steps,
  const CellStorage<Out>& out, int highest, const Write& write)
{
  const std::vector<CellRun> refined = RefineRuns(runs, steps);
  const CellCounts counts = CountCells(refined);
  out.Offsets[counts.Cells] = static_cast<Out>(counts.Entries);
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const CellRun& run = runs[r];
    WriteLayout(refined[r], out);
    Out* connectivity = out.Connectivity + refined[r].FirstEntry;
    if (run.Dimension == 0 && highest >= 0)
    {
      WriteChildrenOfRun<1>(run, VertexChildren, connectivity,
        [&](vtkIdType i, Out* lattice) { lattice[0] = static_cast<Out>(complex.VertexCells[i]); });
    }
    else if (run.Dimension <= highest)
    {
      write(run, connectivity, out.Signs ? out.Signs + run.FirstCell : nullptr);
    }
  }
}

}

std::vector<CellRun> RefineRuns(const std::vector<CellRun>& runs, int levels)
{
  std::vector<CellRun> refined = runs;
  vtkIdType cell = 0;
  vtkIdType entry = 0;
  for (CellRun& run : refined)
  {
    const int shift = run.Dimension * levels;
    run.First <<= shift;
    run.Count <<= shift;
    run.FirstCell = cell;
    run.FirstEntry = entry;
    cell += run.Count;
    entry += run.Count * (run.Dimension + 1);
  }
  return refined;
}

CellCounts CountCells(const std::vector<CellRun>& runs)
{
  CellCounts counts;
  for (const CellRun& run : runs)
  {
    counts.Cells += run.Count;
    counts.Entries += run.Count * (run.Dimension + 1);
  }
  return counts;
}

template <typename Id, typename Out>
void WriteCells(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const CellStorage<Out>& out)
{
  const CellCounts counts = CountCells(runs);
  out.Offsets[counts.Cells] = static_cast<Out>(counts.Entries);
  for (const CellRun& run : runs)
  {
    WriteLayout(run, out);
    const Id* vertices = GetVertices(complex, run);
    ForEach(run.Count * (run.Dimension + 1),
      [&](vtkIdType i) { out.Connectivity[run.FirstEntry + i] = static_cast<Out>(vertices[i]); });
  }
}

template <typename Id, typename Out>
void WriteChildren(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const CellStorage<Out>& out, int highest, const StoredPoints& points)
{
  const Id midpoints = complex.NumberOfVertices;
  const auto write = [&](const CellRun& run, Out* connectivity, signed char* signs)
  {
    switch (run.Dimension)
    {
      case 1:
        WriteChildrenOfRun<1>(run, LineChildren, connectivity,
          [&](vtkIdType i, Out* lattice)
          {
            const Id edge = run.Equal ? complex.EqualLines.Twins[i] : static_cast<Id>(i);
            const Id* ends =
              (run.Equal ? complex.EqualLines.Vertices : complex.EdgeVertices).data() + 2 * i;
            CopyLattices<2>(ends, &edge, 1, midpoints, lattice);
          });
        break;
      case 2:
        WriteChildrenOfRun<1>(run, triangle::Children, connectivity,
          [&](vtkIdType i, Out* lattice)
          {
            Id own[3];
            const Id* vertices = complex.FaceVertices.data() + 3 * i;
            const Id* edges = complex.FaceEdges.data() + 3 * i;
            if (run.Equal)
            {
              GetEdgesOfEqualTriangle(complex, i, own);
              vertices = complex.EqualTriangles.Vertices.data() + 3 * i;
              edges = own;
            }
            CopyLattices<3>(vertices, edges, 1, midpoints, lattice);
          });
        break;
      default:
        WriteChildrenOfTets<1>(
          run, connectivity,
          [&](vtkIdType i, Out* lattice)
          {
            Id own[6];
            const Id* vertices = complex.TetVertices.data() + 4 * i;
            const Id* edges = complex.TetEdges.data() + 6 * i;
            if (run.Equal)
            {
              GetEdgesOfEqual<MarkedTetShape>(GetTets(complex), i, own);
              vertices = complex.EqualTets.Vertices.data() + 4 * i;
              edges = own;
            }
            CopyLattices<4>(vertices, edges, 1, midpoints, lattice);
          },
          points, signs);
        break;
    }
  };
  WriteRuns(complex, runs, 1, out, highest, write);
}

template <typename Id, typename Out>
void WriteGrandchildren(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const CellStorage<Out>& out, int highest, Id centres, const StoredPoints& points)
{
  const ChildIds<BoxSplineSplit<Id>> ids(complex, { complex.NumberOfTets });
  const Id midpoints = complex.NumberOfVertices + complex.NumberOfEdges + centres;
  const auto write = [&](const CellRun& run, Out* connectivity, signed char* signs)
  {
    switch (run.Dimension)
    {
      case 1:
        WriteChildrenOfRun<2>(run, LineChildren, connectivity,
          [&](vtkIdType i, Out* lattice)
          {
            const Id e = static_cast<Id>(i);
            const Id* ends = complex.EdgeVertices.data() + 2 * i;
            const Id vertices[4] = { ends[0], ids.Midpoint(e), ids.Midpoint(e), ends[1] };
            const Id edges[2] = { 2 * e, 2 * e + 1 };
            CopyLattices<2>(vertices, edges, 2, midpoints, lattice);
          });
        break;
      case 2:
        WriteChildrenOfRun<4>(run, triangle::Children, connectivity,
          [&](vtkIdType i, Out* lattice)
          {
            const TriangleChildren<Id> children(complex, ids, static_cast<Id>(i));
            CopyLattices<3>(children.Vertices, children.Edges, 4, midpoints, lattice);
          });
        break;
      default:
        WriteChildrenOfTets<8>(
          run, connectivity,
          [&](vtkIdType i, Out* lattice)
          {
            const SolidParts<MarkedTetShape, Id> parts(
              complex, GetTets(complex), ids, static_cast<Id>(i));
            lattice =
              std::copy(std::begin(parts.Lattice.Points), std::end(parts.Lattice.Points), lattice);
            std::transform(std::begin(parts.Edges), std::end(parts.Edges), lattice,
              [midpoints](Id edge) { return static_cast<Out>(midpoints + edge); });
          },
          points, signs);
        break;
    }
  };
  WriteRuns(complex, runs, 2, out, highest, write);
}

template <typename Id>
bool HasCells(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, const SimplexList& cells)
{
  const CellCounts counts = CountCells(runs);
  if (counts.Cells != cells.GetNumberOfSimplices() ||
    complex.NumberOfVertices != cells.NumberOfPoints)
  {
    return false;
  }
  Buffer<long long> connectivity(counts.Entries);
  Buffer<long long> offsets(counts.Cells + 1);
  Buffer<unsigned char> types(counts.Cells);
  WriteCells(
    complex, runs, CellStorage<long long>{ connectivity.data(), offsets.data(), types.data() });
  return std::equal(connectivity.begin(), connectivity.end(), cells.Connectivity.begin());
}

SUBDIVISION_COMPILE_FUNCTION(HasCells);
/// SUBDIVISION_COMPILE_FUNCTION for functions of two types: of ids, and of the ids they write.
#define SUBDIVISION_COMPILE_WRITER(Function)                                                       \
  template decltype(Function<int, int>) Function<int, int>;                                        \
  template decltype(Function<int, long long>) Function<int, long long>;                            \
  template decltype(Function<long long, int>) Function<long long, int>;                            \
  template decltype(Function<long long, long long>) Function<long long, long long>

SUBDIVISION_COMPILE_WRITER(WriteCells);
SUBDIVISION_COMPILE_WRITER(WriteChildren);
SUBDIVISION_COMPILE_WRITER(WriteGrandchildren);

}
