// SPDX-License-Identifier: BSD-3-Clause
#include "RefinedCells.h"

#include "Simplices.h"

#include "vtkCellType.h"

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
  ForEach(run.Count,
    [&](vtkIdType i)
    {
      out.Types[run.FirstCell + i] = TypeOfDimension[run.Dimension];
      out.Offsets[run.FirstCell + i] = static_cast<Out>(run.FirstEntry + corners * i);
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

/// Writes the children of a run's cells, each given by its lattice points.
template <int Children, int Corners, typename Out, typename Lattice>
void WriteChildrenOfRun(
  const CellRun& run, const int (&table)[Children][Corners], Out* out, const Lattice& lattice)
{
  ForEach(run.Count,
    [&](vtkIdType i)
    {
      Out points[10];
      lattice(run.First + i, points);
      Out* next = out + i * (Children * Corners);
      for (const auto& child : table)
      {
        for (int corner : child)
        {
          *next++ = points[corner];
        }
      }
    });
}

constexpr int VertexChildren[1][1] = { { 0 } };
constexpr int LineChildren[2][2] = { { 0, 2 }, { 2, 1 } };

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
  const CellStorage<Out>& out)
{
  const std::vector<CellRun> children = RefineRuns(runs, 1);
  const CellCounts counts = CountCells(children);
  out.Offsets[counts.Cells] = static_cast<Out>(counts.Entries);
  const Id midpoints = complex.NumberOfVertices;
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const CellRun& run = runs[r];
    WriteLayout(children[r], out);
    Out* connectivity = out.Connectivity + children[r].FirstEntry;
    switch (run.Dimension)
    {
      case 0:
        WriteChildrenOfRun(run, VertexChildren, connectivity,
          [&](vtkIdType i, Out* points) { points[0] = static_cast<Out>(complex.VertexCells[i]); });
        break;
      case 1:
        WriteChildrenOfRun(run, LineChildren, connectivity,
          [&](vtkIdType i, Out* points)
          {
            const Id edge = run.Equal ? complex.EqualLines.Twins[i] : static_cast<Id>(i);
            const Id* ends =
              (run.Equal ? complex.EqualLines.Vertices : complex.EdgeVertices).data() + 2 * i;
            points[0] = static_cast<Out>(ends[0]);
            points[1] = static_cast<Out>(ends[1]);
            points[2] = static_cast<Out>(midpoints + edge);
          });
        break;
      case 2:
        WriteChildrenOfRun(run, triangle::Children, connectivity,
          [&](vtkIdType i, Out* points)
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
            for (int k = 0; k < 3; ++k)
            {
              points[k] = static_cast<Out>(vertices[k]);
              points[3 + k] = static_cast<Out>(midpoints + edges[k]);
            }
          });
        break;
      default:
        WriteChildrenOfRun(run, tetrahedron::Children, connectivity,
          [&](vtkIdType i, Out* points)
          {
            Id own[6];
            const Id* vertices = complex.TetVertices.data() + 4 * i;
            const Id* edges = complex.TetEdges.data() + 6 * i;
            if (run.Equal)
            {
              GetEdgesOfEqualTet(complex, i, own);
              vertices = complex.EqualTets.Vertices.data() + 4 * i;
              edges = own;
            }
            for (int k = 0; k < 4; ++k)
            {
              points[k] = static_cast<Out>(vertices[k]);
            }
            for (int k = 0; k < 6; ++k)
            {
              points[4 + k] = static_cast<Out>(midpoints + edges[k]);
            }
          });
        break;
    }
  }
}

#define SUBDIVISION_WRITE(Id, Out)                                                                 \
  template void WriteCells(                                                                        \
    const SimplicialComplex<Id>&, const std::vector<CellRun>&, const CellStorage<Out>&);           \
  template void WriteChildren(                                                                     \
    const SimplicialComplex<Id>&, const std::vector<CellRun>&, const CellStorage<Out>&)
SUBDIVISION_WRITE(int, int);
SUBDIVISION_WRITE(int, long long);
SUBDIVISION_WRITE(long long, int);
SUBDIVISION_WRITE(long long, long long);

}
