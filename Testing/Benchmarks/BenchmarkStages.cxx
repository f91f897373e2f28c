// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkStages.cxx
 * Where the time goes: the stages of the filter by themselves, with Core directly. Each sums up
 * over the levels. Also the last level's operator as compressed rows: what an execution with
 * another scalar is compared with.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"
#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/Complex/TetOrder.h"
#include "Private/Reading/CellsToSimplices.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

namespace benchmarks
{
namespace
{

using namespace subdivision;

struct StageWatches
{
  Stopwatch Convert;  ///< cells to simplices, order of the tetrahedra
  Stopwatch Classify; ///< complex and strata of the input
  Stopwatch Stencil;  ///< complex, strata and rings of the levels between
  Stopwatch Split;    ///< the output's cells
  Stopwatch Apply;    ///< points and scalar, all levels
};
constexpr Stopwatch StageWatches::* Stages[] = { &StageWatches::Convert, &StageWatches::Classify,
  &StageWatches::Stencil, &StageWatches::Split, &StageWatches::Apply };
constexpr const char* StageNames[] = { "convert", "classify", "stencils", "split", "apply" };

Buffer<double> Copy(vtkDataArray* array)
{
  const vtkIdType tuples = array->GetNumberOfTuples();
  const int components = array->GetNumberOfComponents();
  Buffer<double> values(tuples * components);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    array->GetTuple(i, values.data() + i * components);
  }
  return values;
}

void ApplyTo(const Stencils<int>& stencils, Buffer<double>& values, int components)
{
  Buffer<double> next(stencils.GetNumberOfRows() * components);
  stencils.Apply(values.data(), next.data(), components);
  values = std::move(next);
}

void Split(const Level<int>& level, const std::vector<CellRun>& runs, StageWatches& watches)
{
  const CellCounts counts = CountCells(RefineRuns(runs, 1));
  Buffer<long long> connectivity;
  Buffer<long long> offsets;
  Buffer<unsigned char> types;
  watches.Split.Time(
    [&]()
    {
      connectivity = Buffer<long long>(counts.Entries);
      offsets = Buffer<long long>(counts.Cells + 1);
      types = Buffer<unsigned char>(counts.Cells);
      WriteChildren(level.Complex, runs,
        CellStorage<long long>{ connectivity.data(), offsets.data(), types.data() });
    });
}

/// Does what the filter does; returns the last level's operator.
Stencils<int> RunStages(const Case& which, StageWatches& watches)
{
  vtkPointSet* input = GetInput(which);
  Buffer<double> points = Copy(input->GetPoints()->GetData());
  Buffer<double> scalar = Copy(input->GetPointData()->GetScalars());
  SimplicesOfCells cells;
  std::vector<CellRun> runs;
  Level<int> level;
  watches.Convert.Time(
    [&]()
    {
      cells = CellsToSimplices(input, nullptr);
      OrderTets(cells.Simplices, points.data(), nullptr, 0);
    });
  watches.Classify.Time(
    [&]()
    {
      level.Complex = BuildComplex<int>(cells.Simplices, runs);
      level.Strata = BuildStrata(level.Complex, SingularSimplices(), StrataOptions());
    });
  Stencils<int> stencils;
  for (int left = which.Levels - 1; left >= 0; --left)
  {
    Level<int> next;
    if (left == 0)
    {
      Split(level, runs, watches);
    }
    else
    {
      watches.Stencil.Time(
        [&]() { next = Refine(level, left == 1 ? Depth::ForOutput : Depth::ForRefinement); });
      runs = RefineRuns(runs, 1);
    }
    stencils = TakeStencils(level);
    level = std::move(next);
    watches.Apply.Time(
      [&]()
      {
        ApplyTo(stencils, points, 3);
        ApplyTo(stencils, scalar, 1);
      });
  }
  return stencils;
}

/// Compressed rows with 12 bytes for each entry.
struct CompressedRows
{
  Buffer<int> Starts;
  Buffer<int> Columns;
  Buffer<double> Weights;
};

CompressedRows MakeCompressedRows(const Stencils<int>& stencils)
{
  const vtkIdType vertices = stencils.Vertices.size();
  CompressedRows rows;
  rows.Starts = Buffer<int>(stencils.GetNumberOfRows() + 1);
  for (vtkIdType v = 0; v < vertices; ++v)
  {
    rows.Starts[v] = 1 + static_cast<int>(stencils.VertexRings.GetSize(v));
  }
  for (vtkIdType e = 0; e < stencils.Edges.size(); ++e)
  {
    rows.Starts[vertices + e] = 2 + static_cast<int>(stencils.EdgeRings.GetSize(e));
  }
  CountsToOffsets(rows.Starts);
  const int entries = rows.Starts[stencils.GetNumberOfRows()];
  rows.Columns = Buffer<int>(entries, 0);
  rows.Weights = Buffer<double>(entries, 0.1);
  return rows;
}

/// Reads all columns and weights and writes one value per row, into fresh memory.
Produced ReadRows(Stopwatch& watch, const CompressedRows& rows)
{
  const vtkIdType size = rows.Starts.size() - 1;
  Buffer<double> out;
  watch.Time(
    [&]()
    {
      out = Buffer<double>(size);
      ForEach(size,
        [&](vtkIdType i)
        {
          double sum = 0.;
          for (int k = rows.Starts[i]; k < rows.Starts[i + 1]; ++k)
          {
            sum += rows.Weights[k] * static_cast<double>(rows.Columns[k]);
          }
          out[i] = sum;
        });
      benchmark::ClobberMemory();
    });
  return { static_cast<double>(rows.Columns.size()),
    12. * static_cast<double>(rows.Columns.size()) };
}

void RegisterStages()
{
  for (const char* name : { "cube", "sphere", "polylines" })
  {
    const Case& which = GetCase(name);
    const std::string end = "/" + which.Name + "/levels:" + std::to_string(which.Levels);
    for (int threads : ThreadCounts)
    {
      // Each stage runs all of them.
      for (std::size_t s = 0; s < std::size(Stages) && (threads == 1 || !IsQuick()); ++s)
      {
        Register(std::string("stage/") + StageNames[s] + end, threads,
          [&which, s](Stopwatch& watch)
          {
            StageWatches watches;
            RunStages(which, watches);
            watch = watches.*Stages[s];
            const OutputSize& size = GetOutputSize(which, which.Levels);
            return Produced{ size.Cells, size.Bytes };
          });
      }
      Register("limit/rows" + end, threads,
        [&which](Stopwatch& watch)
        {
          StageWatches watches;
          return ReadRows(watch, MakeCompressedRows(RunStages(which, watches)));
        });
    }
  }
}

const Registration Registered(RegisterStages);

}
}
