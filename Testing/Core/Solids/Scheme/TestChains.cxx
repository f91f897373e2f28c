// SPDX-License-Identifier: BSD-3-Clause
// Several steps at once are what single steps are, bit for bit: values of all types, cells, strata,
// and whose values points take.
#include "Core/Solids/Scheme/Chains.h"
#include "CoreTools.h"
#include "StoredValues.h"

#include "vtkType.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

using namespace coretest;

namespace
{

/// Polylines, loops, branches, single lines that are turned or repeated, points and vertex cells
/// without lines, corners and creases, by chance.
Mesh MakeLines(unsigned int seed)
{
  std::mt19937 random(seed);
  const auto draw = [&random](vtkIdType n) { return static_cast<vtkIdType>(random() % n); };
  Mesh mesh("lines " + std::to_string(seed));
  const vtkIdType points = 3 + draw(seed % 3 == 0 ? 700 : 12);
  mesh.Cells.NumberOfPoints = points;
  const auto add = [&](vtkIdType a, vtkIdType b)
  {
    if (a != b)
    {
      mesh.AddCell({ a, b });
      if (draw(20) == 0)
      {
        mesh.Singular.insert(Sorted({ a, b }));
      }
    }
  };
  for (vtkIdType polyline = draw(4); polyline >= 0; --polyline)
  {
    const vtkIdType first = draw(points);
    const vtkIdType last = std::min(points, first + 2 + draw(points));
    for (vtkIdType i = first; i + 1 < last; ++i)
    {
      add(draw(30) == 0 ? i + 1 : i, draw(30) == 0 ? draw(points) : i + 1);
    }
    if (draw(2) == 0)
    {
      add(last - 1, first);
    }
    if (draw(2) == 0)
    {
      mesh.AddCell({ draw(points) });
      mesh.Singular.insert({ draw(points) });
    }
    add(draw(points), draw(points));
  }
  return mesh;
}

std::vector<StoredValues> MakeArrays(vtkIdType tuples, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<StoredValues> arrays;
  for (const auto& [type, components] : std::vector<std::array<int, 2>>{ { VTK_DOUBLE, 3 },
         { VTK_DOUBLE, 1 }, { VTK_FLOAT, 3 }, { VTK_FLOAT, 1 }, { VTK_UNSIGNED_CHAR, 3 },
         { VTK_UNSIGNED_CHAR, 1 }, { VTK_FLOAT, 2 }, { VTK_LONG_LONG, 1 }, { VTK_DOUBLE, 4 } })
  {
    for (const bool second : { false, true })
    {
      const bool wild = second != (components == 1); // so that some vectors and scalars differ
      arrays.push_back(MakeStoredValues(type, type, components, tuples, random, wild));
    }
  }
  return arrays;
}

bool AreEqual(const Buffer<Stratum>& a, const Buffer<Stratum>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](Stratum x, Stratum y) { return x.GetRule() == y.GetRule() && x.GetType() == y.GetType(); });
}

void Apply(const PointOperator& operation, std::vector<StoredValues>& arrays)
{
  std::vector<MovedArray> moved;
  for (StoredValues& values : arrays)
  {
    values.Resize(operation.GetNumberOfRows());
    moved.push_back(values.GetArray());
  }
  ApplyToArrays(operation, moved);
}

/// What single steps make of a level.
struct Stepped
{
  std::vector<Subdivided<int>> Levels;
  std::vector<StoredValues> Arrays;
  std::vector<vtkIdType> Origins;
};

/// Whether a vertex gives a midpoint what is not smoothed. Among control vertices the larger number
/// comes first here, so that a test sees who asks.
bool IsEarlier(vtkIdType a, vtkIdType b, vtkIdType controls)
{
  return a < controls && b < controls ? a > b : a < b;
}

Stepped StepByStep(const Subdivided<int>& level, int steps, std::vector<StoredValues> arrays)
{
  Stepped stepped;
  stepped.Levels.reserve(static_cast<std::size_t>(steps));
  const vtkIdType controls = level.Level.Complex.NumberOfVertices;
  for (vtkIdType v = 0; v < controls; ++v)
  {
    stepped.Origins.push_back(v);
  }
  const Subdivided<int>* now = &level;
  for (int step = 0; step < steps; ++step)
  {
    for (StoredValues& values : arrays)
    {
      values.In = step > 0 ? values.Out : values.In;
      values.Tuples = now->Level.Complex.NumberOfVertices;
    }
    Apply(LevelRows<int>(now->Level), arrays);
    for (int e = 0; e < now->Level.Complex.NumberOfEdges; ++e)
    {
      const int* ends = now->Level.Complex.EdgeVertices.data() + 2 * vtkIdType(e);
      const int origin = IsEarlier(ends[0], ends[1], controls) ? ends[0] : ends[1];
      stepped.Origins.push_back(stepped.Origins[static_cast<std::size_t>(origin)]);
    }
    stepped.Levels.push_back(RefineOnce(*now));
    now = &stepped.Levels.back();
  }
  stepped.Arrays = std::move(arrays);
  return stepped;
}

void ExpectSame(const Subdivided<int>& level, int steps, unsigned int seed)
{
  const vtkIdType controls = level.Level.Complex.NumberOfVertices;
  std::vector<StoredValues> arrays = MakeArrays(controls, seed);
  const Stepped expected = StepByStep(level, steps, arrays);
  const Subdivided<int>& last = expected.Levels.back();
  const Chains<int> chains(level.Level, steps);
  ASSERT_EQ(chains.GetNumberOfRows(), last.Level.Complex.NumberOfVertices);
  Apply(chains, arrays);
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    EXPECT_EQ(CountDifferences(arrays[i], expected.Arrays[i]), 0) << "array " << i;
    std::vector<StoredValues> alone = { arrays[i] };
    alone[0].Out.assign(alone[0].Out.size(), 0);
    Apply(chains, alone); // some arrays are moved side by side
    EXPECT_EQ(CountDifferences(alone[0], expected.Arrays[i]), 0) << "array " << i << " alone";
  }
  EXPECT_TRUE(AreEqual(chains.GetStrata(), last.Level.Strata.Vertices));
  for (vtkIdType row = 0; row < chains.GetNumberOfRows(); ++row)
  {
    const vtkIdType origin = chains.FindOrigin(
      row, [controls](vtkIdType a, vtkIdType b) { return IsEarlier(a, b, controls); });
    ASSERT_EQ(origin, expected.Origins[static_cast<std::size_t>(row)]) << row;
  }
  WrittenCells written(CountCells(RefineRuns(level.Runs, steps)));
  WriteChains(level.Level.Complex, level.Runs, steps, written.GetStorage());
  WrittenCells cells(CountCells(last.Runs));
  WriteCells(last.Level.Complex, last.Runs, cells.GetStorage());
  EXPECT_EQ(written.Connectivity, cells.Connectivity);
  EXPECT_EQ(written.Offsets, cells.Offsets);
  EXPECT_EQ(written.Types, cells.Types);
}

}

TEST(Chains, AreSingleSteps)
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    const Mesh mesh = MakeLines(seed);
    SCOPED_TRACE(mesh.Name);
    StrataOptions options;
    options.DartEnds = seed % 2 == 0;
    options.Type2 = seed % 4 == 1 ? JointRule::Sharp : JointRule::Blend;
    const Subdivided<int> level = Build<int>(mesh.Cells, mesh.Singular, options);
    ASSERT_TRUE(level.Level.Complex.HasEdgesAlone());
    ExpectSame(level, 1 + static_cast<int>(seed) % MostStepsOfChains, seed);
    ExpectSame(RefineOnce(level), 2, seed);
  }
}

// Longer than what threads and blocks take at a time.
TEST(Chains, OfManyEdges)
{
  Mesh mesh("many");
  mesh.Cells.NumberOfPoints = 20000;
  for (vtkIdType i = 0; i + 1 < mesh.Cells.NumberOfPoints; ++i)
  {
    if (i % 6000 != 0)
    {
      mesh.AddCell({ i, i + 1 });
    }
  }
  mesh.AddCell({ 15000, 20 }); // branches
  ExpectSame(Build<int>(mesh.Cells), 3, 1);
}

// It is no matrix, as values are stored after each step: whoever asks for rows is told so.
TEST(Chains, HaveNoRows)
{
  Mesh mesh("line");
  mesh.Cells.NumberOfPoints = 2;
  mesh.AddCell({ 0, 1 });
  const Subdivided<int> level = Build<int>(mesh.Cells);
  const Chains<int> chains(level.Level, 2);
  EXPECT_THROW(chains.ForEachBlock([](const RowsView&) {}), std::logic_error);
}

// All chains at a vertex take all of its edges along, which is too much where there are many.
TEST(Chains, OnlyWhereFewEdgesMeet)
{
  for (const vtkIdType edges : { 2, 31, 34, 1000 })
  {
    Mesh star("star");
    star.Cells.NumberOfPoints = edges + 1;
    for (vtkIdType i = 1; i <= edges; ++i)
    {
      star.AddCell({ 0, i });
    }
    EXPECT_EQ(HasSmallStars(Build<int>(star.Cells).Level), edges < 32) << edges;
  }
}
