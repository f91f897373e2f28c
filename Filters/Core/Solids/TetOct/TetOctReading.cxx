// SPDX-License-Identifier: BSD-3-Clause
// Compares cells that were read with the cells of a tet/oct level.
#include "Core/Solids/TetOct/TetOctCells.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/TetOct/TetOctDescendants.h"

namespace subdivision
{
namespace
{

/// Calls solid(its vertices, whether it is an octahedron, the position of its first output cell)
/// for each solid of a level in output order. Stops and returns false as soon as a call returns
/// false.
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
  for (unsigned char dimension : InTurn(cells.Dimensions))
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
  for (const std::size_t i : InTurn(cells.Dimensions.size()))
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

template bool HasCells(const TetOctLevel<int>&, const std::vector<CellRun>&, const SimplexList&);
template bool HasCells(
  const TetOctLevel<long long>&, const std::vector<CellRun>&, const SimplexList&);
SUBDIVISION_COMPILE_FUNCTION(FindParents);

}
