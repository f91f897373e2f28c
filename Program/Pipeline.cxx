// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline.h"
#include "Conversion.h"
#include "Files.h"
#include "Messages.h"
#include "Names.h"
#include "Settings.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace subdivide
{
namespace
{

bool HasArray(vtkDataObject* data, int association, const std::string& name)
{
  const auto sets = GetDataSets(data);
  return std::any_of(sets.begin(), sets.end(), [&](vtkDataSet* set)
    { return set->GetAttributesAsFieldData(association)->HasArray(name.c_str()); });
}

/// Where an array is at the other of points and cells alone, it is that.
void FindArrays(const Stage& stage)
{
  for (const auto& one : stage.Arrays)
  {
    const Option& option = *one.first;
    vtkAlgorithm* before = stage.Algorithm->GetNumberOfInputConnections(option.Port) > 0
      ? stage.Algorithm->GetInputAlgorithm(option.Port, 0)
      : nullptr;
    if (!before)
    {
      continue;
    }
    before->Update();
    vtkDataObject* data = stage.Algorithm->GetInputDataObject(option.Port, 0);
    const int other = 1 - option.Association; // points are 0, cells are 1
    if (data && !HasArray(data, option.Association, one.second) &&
      HasArray(data, other, one.second))
    {
      stage.Algorithm->SetInputArrayToProcess(
        option.Index, option.Port, 0, other, one.second.c_str());
    }
  }
}

/// The number with so many digits after the point.
std::string Text(double number, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << number;
  return text.str();
}

void PrintSize(const Size& size, double seconds, const char* about)
{
  std::cout << about << Text(size.Cells, 0) << " cells, " << Text(size.Points, 0) << " points, "
            << Text(size.Bytes / 1e6, 1) << " MB, " << Text(seconds, 2) << " s\n";
}

double Run(const Command& command, Size& size)
{
  const auto start = std::chrono::steady_clock::now();
  size = GetSize(Update(command));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}

void Connect(Command& command)
{
  for (std::size_t i = 0; i < command.Stages.size(); ++i)
  {
    Stage& stage = command.Stages[i];
    for (const auto& file : stage.Files)
    {
      stage.Algorithm->SetInputDataObject(file.first->Port, ReadFile(file.second));
    }
    if (i > 0)
    {
      stage.Algorithm->SetInputConnection(0, command.Stages[i - 1].Algorithm->GetOutputPort());
    }
    else if (stage.What->HasInput)
    {
      stage.Algorithm->SetInputDataObject(0, ReadFile(command.Input));
    }
    ShowProgress(stage.Algorithm, stage.What->Label);
  }
}

vtkDataObject* Update(const Command& command)
{
  const int before = GetNumberOfErrors();
  vtkDataObject* data = nullptr;
  for (const Stage& stage : command.Stages)
  {
    FindArrays(stage);
    stage.Algorithm->Update();
    data = stage.Algorithm->GetOutputDataObject(0);
    if (!data || GetNumberOfErrors() > before)
    {
      throw Failure(std::string("the filter ") + stage.What->Name + " failed");
    }
  }
  EndProgress();
  return data;
}

Size GetSize(vtkDataObject* data)
{
  Size size;
  for (vtkDataSet* set : GetDataSets(data))
  {
    size.Cells += static_cast<double>(set->GetNumberOfCells());
    size.Points += static_cast<double>(set->GetNumberOfPoints());
    for (vtkIdType i = 0; !size.HasSolids && i < set->GetNumberOfCells(); ++i)
    {
      const int type = set->GetCellType(i);
      size.HasSolids = type >= VTK_TETRA && type <= VTK_HEXAGONAL_PRISM;
    }
  }
  size.Bytes = 1024. * static_cast<double>(data->GetActualMemorySize());
  return size;
}

double Extrapolate(const std::vector<double>& numbers, std::vector<double> rates, int levels)
{
  const std::size_t count = numbers.size();
  if (levels < static_cast<int>(count))
  {
    return numbers[levels];
  }
  if (count > 1 && numbers[count - 1] == numbers[count - 2])
  {
    return numbers.back();
  }
  rates.resize(std::min(rates.size(), count));
  // The numbers are a recurrence whose characteristic polynomial has these roots; highest power
  // first.
  std::vector<double> polynomial{ 1. };
  for (double rate : rates)
  {
    polynomial.push_back(0.);
    for (std::size_t i = polynomial.size() - 1; i > 0; --i)
    {
      polynomial[i] -= rate * polynomial[i - 1];
    }
  }
  std::vector<double> all = numbers;
  while (static_cast<int>(all.size()) <= levels)
  {
    double next = 0.;
    for (std::size_t i = 1; i < polynomial.size(); ++i)
    {
      next -= polynomial[i] * all[all.size() - i];
    }
    all.push_back(next);
  }
  return all[levels];
}

void PrintInfo(const Command& command)
{
  constexpr int samples = 4;
  constexpr double largest = 5e5; // cells that are made for an estimate
  const Stage& last = command.Stages.back();
  const Option* option = FindOption(*last.What, "NumberOfLevels");
  std::vector<double> cells;
  std::vector<double> points;
  Size size;
  double seconds = 0.;
  if (!option)
  {
    // What cannot be foretold is made, and not written.
    seconds = Run(command, size);
    PrintSize(size, seconds, "");
    return;
  }
  const int levels = static_cast<int>(option->Get(last.Algorithm));
  for (int i = 0; i <= std::min(samples - 1, levels) && 8. * size.Cells < largest; ++i)
  {
    ApplySetting(last.Algorithm, *option, std::to_string(i));
    seconds = Run(command, size);
    cells.push_back(size.Cells);
    points.push_back(size.Points);
  }
  if (static_cast<int>(cells.size()) == levels + 1)
  {
    PrintSize(size, seconds, "");
    return;
  }
  const double growth = cells.size() > 1 ? std::round(cells.back() / cells[cells.size() - 2]) : 4.;
  std::vector<double> rates{ growth, 1. };
  if (size.HasSolids)
  {
    rates = { 8., 4., 2., 1. };
  }
  else if (growth == 4. || cells.size() == 1)
  {
    rates = { 4., 2., 1. };
  }
  Size estimate;
  estimate.Cells = Extrapolate(cells, rates, levels);
  estimate.Points = Extrapolate(points, rates, levels);
  const double times = estimate.Cells / std::max(1., size.Cells);
  estimate.Bytes = times * size.Bytes;
  PrintSize(estimate, times * seconds, "about ");
}

}
