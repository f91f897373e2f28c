// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkRedGreen.cxx
 * Red-green refinement, with Core directly and with the filter, from the cells in memory to all
 * arrays of the output: cells, cell arrays, points and one scalar.
 *  - corner: unit cube of 12^3 x 6 tetrahedra, 4 rounds, marked where the centroid lies within 0.21
 *    of the corner;
 *  - percent: 1 % of 5 million tetrahedra, those around the centre; scattered: any 1 %.
 */
#include "BenchmarkLimit.h"

#include "Core/Solids/Complex/TetOrder.h"
#include "Core/Solids/RedGreen/RedGreenOutput.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkRedGreenRefinement.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSphere.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <memory>

namespace benchmarks
{
namespace
{

using namespace subdivision;
using Leaf = RedGreenLeaf<int>;

constexpr int LargeCube = 94; ///< 5 million tetrahedra

struct Input
{
  SimplexList Cells;
  std::vector<double> Points;
  std::vector<double> Scalar;
};

Input MakeInput(int n)
{
  FlatMesh mesh = MakeCube(n);
  Input input;
  input.Cells.NumberOfPoints = mesh.GetNumberOfPoints();
  input.Cells.Dimensions.assign(static_cast<std::size_t>(mesh.GetNumberOfCells()), 3);
  input.Cells.Connectivity.assign(mesh.Cells.begin(), mesh.Cells.end());
  input.Points = std::move(mesh.Points);
  input.Scalar = std::move(mesh.Scalar);
  OrderTets(input.Cells, input.Points.data(), nullptr, 0);
  return input;
}

/// Everything that a filter would hand over.
struct Output
{
  Buffer<double> Points;
  Buffer<double> Scalar;
  Buffer<long long> Connectivity;
  Buffer<long long> Offsets;
  Buffer<unsigned char> Types;
  Buffer<unsigned char> Levels;
  Buffer<unsigned char> Kinds;
  Buffer<vtkIdType> GreenParents;
  Buffer<vtkIdType> InputCells;

  std::vector<std::size_t> GetSizes() const
  {
    return { this->Points.GetMemorySize(), this->Scalar.GetMemorySize(),
      this->Connectivity.GetMemorySize(), this->Offsets.GetMemorySize(),
      this->Types.GetMemorySize(), this->Levels.GetMemorySize(), this->Kinds.GetMemorySize(),
      this->GreenParents.GetMemorySize(), this->InputCells.GetMemorySize() };
  }
};

Output MakeOutput(const RedGreen<int>& state, const Input& input)
{
  const RedGreenOutput<int> plan(state);
  const CellCounts counts = plan.GetCounts();
  const auto rows = MakeMidpointRows(state);
  Output out;
  out.Points = Buffer<double>(3 * rows.GetNumberOfRows());
  out.Scalar = Buffer<double>(rows.GetNumberOfRows());
  out.Connectivity = Buffer<long long>(counts.Entries);
  out.Offsets = Buffer<long long>(counts.Cells + 1);
  out.Types = Buffer<unsigned char>(counts.Cells);
  out.Levels = Buffer<unsigned char>(counts.Cells);
  out.Kinds = Buffer<unsigned char>(counts.Cells);
  out.GreenParents = Buffer<vtkIdType>(counts.Cells);
  out.InputCells = Buffer<vtkIdType>(counts.Cells);
  plan.Write<long long>({ { out.Connectivity.data(), out.Offsets.data(), out.Types.data() },
    out.Levels.data(), out.Kinds.data(), out.GreenParents.data(), out.InputCells.data() });
  rows.Apply(input.Points.data(), out.Points.data(), 3);
  rows.Apply(input.Scalar.data(), out.Scalar.data(), 1);
  return out;
}

/// Squared distance of a cell's centroid from a point on the diagonal of the cube.
template <typename Ids>
double GetDistance(const std::vector<double>& points, const Ids& vertices, double centre)
{
  double sum = 0.;
  for (int c = 0; c < 3; ++c)
  {
    double x = -centre;
    for (int i = 0; i < 4; ++i)
    {
      x += 0.25 * points[3 * vertices[i] + c];
    }
    sum += x * x;
  }
  return sum;
}

Output RefineCorner(const Input& input, int rounds, double radius)
{
  RedGreen<int> state{ SimplexView(input.Cells) };
  std::vector<double> points = input.Points; // criteria look at new vertices
  std::vector<Leaf> marks;
  const int cells = static_cast<int>(input.Cells.GetNumberOfSimplices());
  for (int cell = 0; cell < cells; ++cell)
  {
    if (GetDistance(points, input.Cells.Connectivity.data() + 4 * vtkIdType(cell), 0.) <
      radius * radius)
    {
      marks.push_back({ cell, -1 });
    }
  }
  for (int round = 0; round < rounds; ++round)
  {
    for (const Leaf& leaf : marks)
    {
      state.MarkCell(leaf);
    }
    state.Close();
    for (int v = static_cast<int>(points.size() / 3); v < state.GetNumberOfVertices(); ++v)
    {
      const auto ends = state.GetEnds(v);
      for (int c = 0; c < 3; ++c)
      {
        points.push_back(0.5 * (points[3 * ends[0] + c] + points[3 * ends[1] + c]));
      }
    }
    marks.clear();
    for (const auto& cell : state.GetChangedCells())
    {
      if (cell.Kind == RefinementKind::Red &&
        GetDistance(points, cell.Vertices, 0.) < radius * radius)
      {
        marks.push_back(cell.Leaf);
      }
    }
  }
  return MakeOutput(state, input);
}

Output RefinePercent(const Input& input, const std::vector<int>& marks)
{
  RedGreen<int> state{ SimplexView(input.Cells) };
  for (int cell : marks)
  {
    state.MarkCell({ cell, -1 });
  }
  state.Close();
  return MakeOutput(state, input);
}

/// The radius of a ball that has 1 % of the unit cube's volume.
double GetPercentRadius()
{
  return std::cbrt(0.01 * 3. / (4. * 3.14159265358979));
}

std::function<Output()> MakePercent(bool scattered)
{
  static std::shared_ptr<const Input> shared;
  if (!shared)
  {
    shared = std::make_shared<const Input>(MakeInput(LargeCube));
  }
  const auto input = shared;
  const double squaredRadius = GetPercentRadius() * GetPercentRadius();
  std::vector<int> marks;
  const int cells = static_cast<int>(input->Cells.GetNumberOfSimplices());
  for (int cell = 0; cell < cells; ++cell)
  {
    const unsigned int chance = static_cast<unsigned int>(cell) * 2654435761u >> 7;
    if (scattered ? chance % 100 == 0
                  : GetDistance(input->Points,
                      input->Cells.Connectivity.data() + 4 * vtkIdType(cell), 0.5) < squaredRadius)
    {
      marks.push_back(cell);
    }
  }
  return [input, marks]() { return RefinePercent(*input, marks); };
}

/// A run of what is measured, timed, and the sizes of its output's arrays.
using Work = std::function<OutputSize(Stopwatch&)>;

OutputSize AddUp(OutputSize size)
{
  for (std::size_t bytes : size.Arrays)
  {
    size.Bytes += static_cast<double>(bytes);
  }
  return size;
}

Work RunCore(const std::function<Output()>& run)
{
  return [run](Stopwatch& watch)
  {
    Output output;
    watch.Time([&]() { output = run(); });
    OutputSize size;
    size.Cells = static_cast<double>(output.Types.size());
    size.Points = static_cast<double>(output.Scalar.size());
    size.Arrays = output.GetSizes();
    return AddUp(size);
  };
}

/// The whole filter: cells whose centroid is inside a ball.
Work RunFilter(int n, int levels, double centre, double radius)
{
  const auto input = ToVtk(MakeCube(n));
  return [=](Stopwatch& watch)
  {
    vtkNew<vtkSphere> ball;
    ball->SetCenter(centre, centre, centre);
    ball->SetRadius(radius);
    vtkNew<vtkRedGreenRefinement> filter;
    filter->SetInputData(input);
    filter->RefineByAttributeErrorOff();
    filter->RefineByFunctionOn();
    filter->SetImplicitFunction(ball);
    filter->SetMaximumLevel(levels);
    watch.Time([&]() { filter->Update(); });
    vtkUnstructuredGrid* output = filter->GetOutput();
    OutputSize size;
    size.Cells = static_cast<double>(output->GetNumberOfCells());
    size.Points = static_cast<double>(output->GetNumberOfPoints());
    auto add = [&size](vtkDataArray* array)
    {
      size.Arrays.push_back(
        static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
    };
    add(output->GetPoints()->GetData());
    add(output->GetPointData()->GetScalars());
    add(output->GetCells()->GetConnectivityArray());
    add(output->GetCells()->GetOffsetsArray());
    add(subdivision::GetCellTypes(output));
    for (int i = 0; i < output->GetCellData()->GetNumberOfArrays(); ++i)
    {
      add(output->GetCellData()->GetArray(i));
    }
    return AddUp(size);
  };
}

/// What is measured, made when it is first needed, and the size of its output.
struct LocalCase
{
  std::string What;
  std::string Name;
  std::function<Work()> Make;
  Work Run;
  OutputSize Size;

  void Prepare()
  {
    if (!this->Run)
    {
      Stopwatch unused;
      this->Run = this->Make();
      this->Size = this->Run(unused);
    }
  }
};

void RegisterRedGreen()
{
  static LocalCase cases[] = {
    { "core", "corner/levels:4",
      []()
      {
        const auto input = std::make_shared<const Input>(MakeInput(12));
        return RunCore([input]() { return RefineCorner(*input, 4, 0.21); });
      },
      nullptr, {} },
    { "core", "percent/levels:1", []() { return RunCore(MakePercent(false)); }, nullptr, {} },
    { "core", "scattered/levels:1", []() { return RunCore(MakePercent(true)); }, nullptr, {} },
    { "filter", "corner/levels:4", []() { return RunFilter(12, 4, 0., 0.21); }, nullptr, {} },
    { "filter", "percent/levels:1",
      []() { return RunFilter(LargeCube, 1, 0.5, GetPercentRadius()); }, nullptr, {} },
  };
  for (LocalCase& which : cases)
  {
    const bool isSmall = which.Name.compare(0, 6, "corner") == 0;
    if (IsQuick() && which.What == "core" && !isSmall)
    {
      continue; // the filter does the same and more
    }
    for (int threads : ThreadCounts)
    {
      Register("redgreen/" + which.What + "/" + which.Name, threads,
        [&which](Stopwatch& watch)
        {
          which.Prepare();
          which.Run(watch);
          return Produced{ which.Size.Cells, which.Size.Bytes };
        });
      const struct
      {
        const char* Name;
        Pages Kind;
      } limits[] = { { "small", Pages::Small }, { "huge", Pages::Huge } };
      for (const auto& limit : limits)
      {
        Register("redgreen-limit/" + which.What + "-" + limit.Name + "/" + which.Name, threads,
          [&which, limit](Stopwatch& watch)
          {
            which.Prepare();
            return RunLimit(watch, which.Size, limit.Kind);
          });
      }
    }
  }
}

const Registration Registered(RegisterRedGreen);

}
}
