// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkRedGreen.cxx
 * Red-green refinement with Core directly, from the cells in memory to all arrays of the output:
 * cells, cell arrays, points and one scalar.
 *  - corner: unit cube of 12^3 x 6 tetrahedra, 4 rounds, marked where the centroid lies within 0.21
 *    of the corner;
 *  - percent: 1 % of 5 million tetrahedra, those around the centre; scattered: any 1 %.
 */
#include "BenchmarkLimit.h"

#include "Core/RedGreenOutput.h"
#include "Core/TetOrder.h"

#include <cmath>
#include <memory>

namespace benchmarks
{
namespace
{

using namespace subdivision;
using Leaf = RedGreenLeaf<int>;

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

/// What is measured, made when it is first needed, and the size of its output.
struct LocalCase
{
  std::string Name;
  std::function<std::function<Output()>()> Make;
  std::function<Output()> Run;
  OutputSize Size;

  void Prepare()
  {
    if (!this->Run)
    {
      this->Run = this->Make();
      const Output output = this->Run();
      this->Size.Cells = static_cast<double>(output.Types.size());
      this->Size.Points = static_cast<double>(output.Scalar.size());
      this->Size.Arrays = output.GetSizes();
      for (std::size_t bytes : this->Size.Arrays)
      {
        this->Size.Bytes += static_cast<double>(bytes);
      }
    }
  }
};

std::function<Output()> MakePercent(bool scattered)
{
  static std::shared_ptr<const Input> shared;
  if (!shared)
  {
    shared = std::make_shared<const Input>(MakeInput(94));
  }
  const auto input = shared;
  const double squaredRadius = std::pow(0.01 * 3. / (4. * 3.14159265358979), 2. / 3.);
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

void RegisterRedGreen()
{
  static LocalCase corner{ "corner/levels:4",
    []()
    {
      const auto input = std::make_shared<const Input>(MakeInput(12));
      return [input]() { return RefineCorner(*input, 4, 0.21); };
    },
    nullptr, {} };
  static LocalCase percent{ "percent/levels:1", []() { return MakePercent(false); }, nullptr, {} };
  static LocalCase scattered{ "scattered/levels:1", []() { return MakePercent(true); }, nullptr,
    {} };
  for (LocalCase* which : { &corner, &percent, &scattered })
  {
    if (IsQuick() && which != &corner)
    {
      continue;
    }
    for (int threads : ThreadCounts)
    {
      Register("redgreen/core/" + which->Name, threads,
        [which](Stopwatch& watch)
        {
          which->Prepare();
          Output output;
          watch.Time([&]() { output = which->Run(); });
          return Produced{ which->Size.Cells, which->Size.Bytes };
        });
      Register("limit/small/" + which->Name, threads,
        [which](Stopwatch& watch)
        {
          which->Prepare();
          return RunLimit(watch, which->Size, Pages::Small);
        });
      Register("limit/huge/" + which->Name, threads,
        [which](Stopwatch& watch)
        {
          which->Prepare();
          return RunLimit(watch, which->Size, Pages::Huge);
        });
    }
  }
}

const Registration Registered(RegisterRedGreen);

}
}
