// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/UniformCells.h"

#include "Core/Memory/Ids.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Values/PointCopies.h"

#include "vtkNew.h"
#include "vtkTypeInt32Array.h"

namespace subdivision
{
namespace
{

constexpr unsigned char TypeOfDimension[4] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };

/// Writes the cells of a level after 0, 1 or 2 steps to a storage of the right size.
template <typename Id, typename Out>
void WriteRefined(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int steps,
  const CellStorage<Out>& storage, Id centres)
{
  switch (steps)
  {
    case 0:
      WriteCells(complex, runs, storage);
      break;
    case 1:
      WriteChildren(complex, runs, storage);
      break;
    default:
      WriteGrandchildren(complex, runs, storage, 3, centres);
      break;
  }
}

/// Makes room for cells and lets `write` fill it.
template <typename Write>
UniformCells Fill(const CellCounts& counts, bool small, double points, const Write& write)
{
  UniformCells made;
  made.Cells = vtkSmartPointer<vtkCellArray>::New();
  const auto types = MakeArray(VTK_UNSIGNED_CHAR, 1, counts.Cells);
  auto fill = [&](auto* offsets, auto* connectivity)
  {
    Allocate(offsets, 1, counts.Cells + 1);
    Allocate(connectivity, 1, counts.Entries);
    using Out = typename std::remove_pointer<decltype(offsets->GetPointer(0))>::type;
    write(CellStorage<Out>{ connectivity->GetPointer(0), offsets->GetPointer(0),
      static_cast<unsigned char*>(types->GetVoidPointer(0)) });
    made.Cells->SetData(offsets, connectivity);
  };
  if (small && std::max(static_cast<double>(counts.Entries), points) < LargestSmallId)
  {
    vtkNew<vtkTypeInt32Array> offsets;
    vtkNew<vtkTypeInt32Array> connectivity;
    fill(offsets.Get(), connectivity.Get());
  }
  else
  {
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> connectivity;
    fill(offsets.Get(), connectivity.Get());
  }
  made.Types = vtkUnsignedCharArray::SafeDownCast(types);
  return made;
}

template <typename Scheme>
double CountPoints(const typename Scheme::Level& level, int steps)
{
  LevelCounts counts = CountSimplices<Scheme>(level);
  for (int step = 0; step < steps; ++step)
  {
    counts = counts.Refine();
  }
  return counts.Vertices;
}

void AddOctahedra(const std::vector<CellRun>& runs, int steps, UniformCells& made)
{
  made.Octahedra = vtkSmartPointer<vtkIdTypeArray>::New();
  made.Octahedra->SetName(OctahedraName);
  Allocate(made.Octahedra, 1, CountCells(runs).Cells);
  NumberOctahedra(runs, steps, made.Octahedra->GetPointer(0));
}

/// act(offsets, connectivity, coordinates) with the values as they are stored.
template <typename Out, typename Act>
void WithPoints(vtkDataArray* offsets, vtkDataArray* ids, vtkDataArray* points, const Act& act)
{
  const Out* first = static_cast<const Out*>(offsets->GetVoidPointer(0));
  Out* connectivity = static_cast<Out*>(ids->GetVoidPointer(0));
  if (points->GetDataType() == VTK_FLOAT)
  {
    act(first, connectivity, static_cast<const float*>(points->GetVoidPointer(0)));
  }
  else
  {
    act(first, connectivity, static_cast<const double*>(points->GetVoidPointer(0)));
  }
}
template <typename Act>
void WithCells(vtkCellArray* cells, vtkDataArray* points, const Act& act)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  vtkDataArray* connectivity = cells->GetConnectivityArray();
  if (cells->IsStorage64Bit())
  {
    WithPoints<long long>(offsets, connectivity, points, act);
  }
  else
  {
    WithPoints<int>(offsets, connectivity, points, act);
  }
}

}

template <typename Scheme>
UniformCells MakeChildren(const typename Scheme::Level& level, const std::vector<CellRun>& runs,
  int steps, vtkDataArray* points, bool small)
{
  const std::vector<CellRun> children = RefineRuns(runs, steps);
  KnownSigns signs{ {}, steps };
  if (points)
  {
    signs.Signs.resize(static_cast<std::size_t>(CountCells(runs).Cells));
  }
  UniformCells made = Fill(CountCells(children), small, CountPoints<Scheme>(level, steps),
    [&](auto storage)
    {
      storage.Signs = points ? signs.Signs.data() : nullptr;
      if (points && points->GetDataType() == VTK_FLOAT)
      {
        Scheme::WriteChildren(
          level, runs, steps, static_cast<const float*>(points->GetVoidPointer(0)), storage);
      }
      else
      {
        Scheme::WriteChildren(level, runs, steps,
          points ? static_cast<const double*>(points->GetVoidPointer(0)) : nullptr, storage);
      }
    });
  if (Scheme::Traits.HasPieces)
  {
    AddOctahedra(children, Scheme::CountSteps(level) + steps, made);
  }
  made.Signs = std::move(signs);
  return made;
}

UniformCells CopyCells(
  const SimplexList& cells, const std::vector<CellRun>& runs, int steps, bool small)
{
  const CellCounts counts{ cells.GetNumberOfSimplices(),
    static_cast<vtkIdType>(cells.Connectivity.size()) };
  UniformCells made = Fill(counts, small, static_cast<double>(cells.NumberOfPoints),
    [&](const auto& storage)
    {
      using Out = typename std::remove_reference<decltype(*storage.Offsets)>::type;
      Out entry = 0;
      for (vtkIdType i = 0; i < counts.Cells; ++i)
      {
        storage.Types[i] = TypeOfDimension[cells.Dimensions[i]];
        storage.Offsets[i] = entry;
        entry += cells.Dimensions[i] + 1;
      }
      storage.Offsets[counts.Cells] = entry;
      ForEach(counts.Entries,
        [&](vtkIdType i) { storage.Connectivity[i] = static_cast<Out>(cells.Connectivity[i]); });
    });
  if (steps >= 0)
  {
    AddOctahedra(runs, steps, made);
  }
  return made;
}

void TurnOctahedra(UniformCells& cells, bool shared, vtkDataArray* points)
{
  const vtkIdType* octahedra = cells.Octahedra->GetPointer(0);
  const vtkIdType size = cells.Octahedra->GetNumberOfTuples();
  if (shared)
  {
    bool turned = false;
    WithCells(cells.Cells, points,
      [&](const auto* offsets, const auto* connectivity, const auto* coordinates)
      { turned = AreTurned(octahedra, size, offsets, connectivity, coordinates); });
    if (turned)
    {
      return;
    }
    vtkDataArray* connectivity = cells.Cells->GetConnectivityArray();
    vtkNew<vtkCellArray> copied;
    copied->SetData(cells.Cells->GetOffsetsArray(), CopyOfValues(connectivity));
    cells.Cells = copied;
  }
  WithCells(cells.Cells, points,
    [&](const auto* offsets, auto* connectivity, const auto* coordinates)
    { TurnOctahedra(octahedra, size, offsets, connectivity, coordinates); });
}

template <typename Id>
SimplexTuples GatherTuples(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int steps, Id centres)
{
  const CellCounts counts = CountCells(RefineRuns(runs, steps));
  SimplexTuples gathered;
  if (counts.Cells == 0)
  {
    return gathered;
  }
  Buffer<long long> connectivity(counts.Entries);
  Buffer<long long> offsets(counts.Cells + 1);
  Buffer<unsigned char> types(counts.Cells);
  const CellStorage<long long> storage{ connectivity.data(), offsets.data(), types.data() };
  WriteRefined(complex, runs, steps, storage, centres);
  for (vtkIdType i = 0; i < counts.Cells; ++i)
  {
    const int dimension = static_cast<int>(offsets[i + 1] - offsets[i]) - 1;
    auto& tuples = gathered.Tuples[dimension];
    tuples.insert(
      tuples.end(), connectivity.data() + offsets[i], connectivity.data() + offsets[i + 1]);
  }
  return gathered;
}

SUBDIVISION_COMPILE_FUNCTION(GatherTuples);
#define SUBDIVISION_MAKE_CHILDREN(Scheme)                                                          \
  template UniformCells MakeChildren<Scheme>(                                                      \
    const Scheme::Level&, const std::vector<CellRun>&, int, vtkDataArray*, bool)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_MAKE_CHILDREN);

}
