// SPDX-License-Identifier: BSD-3-Clause
// Curves alone are subdivided in several steps at once. The output is that of single steps, which a
// filter makes that keeps operators.
#include "OperatorCacheTools.h"

using namespace operator_cache_tools;

namespace
{

/// Lines and vertices with loops, branches, copies of lines, loose points and arrays of every kind.
Grid MakeCurves(unsigned seed)
{
  std::mt19937 random(seed);
  const auto draw = [&random](int n) { return static_cast<vtkIdType>(random() % n); };
  const int size = 8 + static_cast<int>(draw(30));
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int i = 0; i < size; ++i)
  {
    points.push_back({ 1. * i, 0.01 * static_cast<double>(draw(100)), 0.02 * i * i });
    if (i > 0 && draw(10) > 0)
    {
      cells.push_back({ VTK_LINE, { i - 1, i } });
    }
    const vtkIdType other = draw(size);
    if (other != i && draw(4) == 0)
    {
      cells.push_back({ VTK_LINE, { other, i } });
    }
  }
  const int lines = static_cast<int>(cells.size());
  for (int i = 0; i < 4; ++i)
  {
    const Cell copied = cells[static_cast<std::size_t>(draw(lines))];
    cells.push_back({ VTK_LINE, { copied.Points[1], copied.Points[0] } });
    cells.push_back({ VTK_VERTEX, { draw(size) } });
  }
  const Grid grid = MakeGrid(points, cells, seed % 2 ? VTK_FLOAT : VTK_DOUBLE);
  AddArrays(grid);
  if (seed % 3 == 0)
  {
    AddGlobalIds(grid, seed);
  }
  std::vector<int> singular; // the same of copies
  for (const Cell& cell : cells)
  {
    singular.push_back((cell.Points[0] + cell.Points.back() + seed) % 8 == 0);
  }
  AddCellArray(grid, "Singular", singular);
  return grid;
}

Configure OptionsOf(unsigned seed, int levels)
{
  return [seed, levels](Filter* filter)
  {
    filter->SetCreaseEnd(seed / 2 % 2);
    filter->SetEmbeddedCells(seed % 3);
    filter->SetType2Rule(seed % 5 == 1 ? Filter::TYPE2_SHARP : Filter::TYPE2_BLEND);
    filter->SetVolumeScheme(seed % 5 == 0 ? Filter::LINEAR : Filter::BOX_SPLINE);
    filter->SetGenerateClassification(seed % 4 == 0);
    filter->SetInterpolateIntegers(seed % 3 == 1);
    filter->SetGenerateOriginalIds(seed % 3 == 2);
    filter->SetUse32BitIds(seed % 7 == 0);
    filter->SetNumberOfLevels(levels);
  };
}

}

TEST(CurveLevels, AreSingleSteps)
{
  for (unsigned seed = 0; seed < 42; ++seed)
  {
    const Grid input = MakeCurves(seed);
    const Configure configure = OptionsOf(seed, 2 + static_cast<int>(seed) % 6);
    Kept kept(configure);
    EXPECT_EQ(Compare(Fresh(input, configure), kept.Update(input)), "") << seed;
  }
}

TEST(CurveLevels, GoOnFromAnEarlierOutput)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const Grid first = Fresh(MakeCurves(seed), OptionsOf(seed, 2));
    const Configure configure = OptionsOf(seed, 3);
    Kept kept(configure);
    EXPECT_EQ(Compare(Fresh(first, configure), kept.Update(first)), "") << seed;
  }
}

// Sharpness that has not ended is blended step by step.
TEST(CurveLevels, SemiSharp)
{
  const Grid input = MakeCurves(1);
  const auto sharpness = vtkSmartPointer<vtkDoubleArray>::New();
  sharpness->SetName("Sharpness");
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    sharpness->InsertNextValue(input->GetCellType(i) == VTK_LINE && i % 3 == 0 ? 1.5 : 0.);
  }
  input->GetCellData()->AddArray(sharpness);
  const Configure configure = [](Filter* filter)
  {
    OptionsOf(1, 5)(filter);
    SetCellArray(filter, 4, "Sharpness");
  };
  Kept kept(configure);
  EXPECT_EQ(Compare(Fresh(input, configure), kept.Update(input)), "");
}

TEST(CurveLevels, WithAnyNumberOfThreads)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int i = 0; i < 30000; ++i)
  {
    points.push_back({ 0.001 * i, std::sin(0.01 * i), std::cos(0.01 * i) });
    if (i % 1000 != 0)
    {
      cells.push_back({ VTK_LINE, { i - 1, i } });
    }
    else if (i > 0)
    {
      cells.push_back({ VTK_LINE, { i, i - 700 } });
    }
  }
  const Grid input = MakeGrid(points, cells);
  AddArrays(input);
  AddGlobalIds(input, 1);
  MakeInThreads([&] { return Fresh(input, OptionsOf(1, 3)); });
}
