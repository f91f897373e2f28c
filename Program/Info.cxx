// SPDX-License-Identifier: BSD-3-Clause
#include "Info.h"
#include "Conversion.h"
#include "Messages.h"
#include "Names.h"
#include "Settings.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

namespace subdivide
{
namespace
{

/// Up to how many cells the second sample is made, which is wanted, and the third and the others,
/// which make the result more exact.
constexpr double MostCells[] = { 3e7, 4e6, 5e5 };

/// Numbers for each dimension from 0 to 3.
using Numbers = std::array<double, 4>;

/// An output, by dimensions. Each point belongs to the largest dimension of the cells around it.
struct Sample
{
  Size Output;
  double Seconds = 0.;
  Numbers Cells{};
  /// How many points there are beside those that belong to the insides of cells, if each point is
  /// shared out among the cells around it: a quad in a plane has 1 of them, a triangle 1/2.
  Numbers Points{};
  Numbers Inside{};
};

int GetDimension(int type)
{
  static std::array<int, VTK_NUMBER_OF_CELL_TYPES> dimensions{};
  int& known = dimensions.at(type); // plus 1; 0: not known
  if (known == 0)
  {
    auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    known = 1 + (cell ? cell->GetCellDimension() : 0);
  }
  return known - 1;
}

/// The points inside a large regular mesh of such cells, per cell.
double GetShare(int type, vtkIdType corners)
{
  switch (type)
  {
    case VTK_TETRA:
      return 1. / 6.;
    case VTK_PYRAMID:
      return 1. / 3.;
    case VTK_WEDGE:
      return 1. / 2.;
    case VTK_TRIANGLE:
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
      return static_cast<double>(corners) / 2. - 1.;
    case VTK_POLY_LINE:
      return static_cast<double>(corners) - 1.;
    default:
      return GetDimension(type) > 0 ? 1. : 0.;
  }
}

void Count(vtkDataSet* set, Sample& sample)
{
  vtkNew<vtkIdList> corners;
  std::vector<char> dimensions(static_cast<std::size_t>(set->GetNumberOfPoints()), 0);
  const auto exists = [&](vtkIdType id) { return id >= 0 && id < set->GetNumberOfPoints(); };
  for (vtkIdType c = 0; c < set->GetNumberOfCells(); ++c)
  {
    const auto dimension = static_cast<char>(GetDimension(set->GetCellType(c)));
    set->GetCellPoints(c, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      if (exists(corners->GetId(i)))
      {
        char& largest = dimensions[corners->GetId(i)];
        largest = std::max(largest, dimension);
      }
    }
  }
  for (vtkIdType c = 0; c < set->GetNumberOfCells(); ++c)
  {
    const int type = set->GetCellType(c);
    const int dimension = GetDimension(type);
    ++sample.Cells[dimension];
    set->GetCellPoints(c, corners);
    // A triangle on a solid has no points of its own.
    const vtkIdType* ids = corners->GetPointer(0);
    if (std::any_of(ids, ids + corners->GetNumberOfIds(),
          [&](vtkIdType id) { return exists(id) && dimensions[id] == dimension; }))
    {
      sample.Inside[dimension] += GetShare(type, corners->GetNumberOfIds());
    }
  }
  for (char dimension : dimensions)
  {
    ++sample.Points[static_cast<std::size_t>(dimension)];
  }
}

Sample Make(const Command& command)
{
  Sample sample;
  const auto start = std::chrono::steady_clock::now();
  vtkDataObject* data = Update(command);
  sample.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  sample.Output = GetSize(data);
  for (vtkDataSet* set : GetDataSets(data))
  {
    Count(set, sample);
  }
  return sample;
}

/// How cells of each dimension grow in a level.
struct Growth
{
  Numbers Rates{ { 1., 2., 4., 8. } };
  bool Alternates = false; ///< curves and boundaries grow in every second level
  bool IsDual = false;     ///< the faces of a level are those around points, too
};

Growth GetGrowth(const Stage& stage)
{
  Growth growth;
  const Option* scheme = FindOption(*stage.What, "Scheme");
  if (!scheme || std::string(stage.What->Name) != "surface-subdivision")
  {
    return growth;
  }
  for (const auto& entry : scheme->Entries)
  {
    if (entry.second != scheme->Get(stage.Algorithm, 0))
    {
      continue;
    }
    const std::string name = Plain(entry.first);
    growth.IsDual = name == "doosabin" || name == "midedge";
    growth.Alternates = name == "sqrtthree" || name == "foureight";
    growth.Rates[2] = name == "sqrtthree" ? 3. : name == "foureight" || name == "midedge" ? 2. : 4.;
    growth.Rates[1] = growth.Alternates ? std::sqrt(growth.Rates[2]) : 2.;
  }
  return growth;
}

double GetSum(const Numbers& numbers)
{
  return numbers[0] + numbers[1] + numbers[2] + numbers[3];
}

Numbers Multiply(const Numbers& numbers, const Numbers& growth, int levels)
{
  Numbers product{};
  for (std::size_t d = 0; d < numbers.size(); ++d)
  {
    product[d] = numbers[d] * std::pow(growth[d], levels);
  }
  return product;
}

/// Simplices of the input of those dimensions that the output does not show: the filter makes, and
/// counts, them too.
Numbers CountOthers(const Stage& stage, const Sample& output)
{
  Numbers others{};
  vtkDataObject* input = stage.What->HasInput && FindOption(*stage.What, "OutputDimensions")
    ? stage.Algorithm->GetInputDataObject(0, 0)
    : nullptr;
  for (vtkDataSet* set : GetDataSets(input))
  {
    Sample given;
    Count(set, given);
    constexpr Numbers simplices{ 0., 1., 2., 6. };
    for (std::size_t d = 1; d < others.size(); ++d)
    {
      others[d] += output.Cells[d] == 0. ? simplices[d] * given.Inside[d] : 0.;
    }
  }
  return others;
}

/// About how memory and time go: by corners of cells, and by points.
double GetWeight(const Numbers& cells, double points)
{
  return 2. * cells[0] + 3. * cells[1] + 4. * cells[2] + 5. * cells[3] + 3. * points;
}

/// The number that follows from the last samples: a sum of powers of the rates, of which the first
/// as many as there are samples are taken.
double Extrapolate(std::vector<double> numbers, const std::vector<double>& rates, int levels)
{
  const std::size_t count = std::min(rates.size(), numbers.size());
  // The numbers are a recurrence whose characteristic polynomial has these roots; highest power
  // first.
  std::vector<double> polynomial{ 1. };
  for (std::size_t r = 0; r < count; ++r)
  {
    polynomial.push_back(0.);
    for (std::size_t i = polynomial.size() - 1; i > 0; --i)
    {
      polynomial[i] -= rates[r] * polynomial[i - 1];
    }
  }
  for (int level = 0; level < levels; ++level)
  {
    double next = 0.;
    for (std::size_t i = 1; i < polynomial.size(); ++i)
    {
      next -= polynomial[i] * numbers[numbers.size() - i];
    }
    numbers.push_back(next);
  }
  return numbers.back();
}

/// The faces of a dual scheme, or their points: before the first level they are others.
double ForetellDual(
  const std::vector<Sample>& samples, Numbers Sample::* numbers, const Growth& growth, int levels)
{
  const Numbers& before = samples[samples.size() - 2].*numbers;
  return Extrapolate({ before[2], (samples.back().*numbers)[2] }, { growth.Rates[2], 1. }, levels);
}

/// The cells of each dimension after some more levels.
Numbers ForetellCells(const std::vector<Sample>& samples, const Growth& growth, int levels)
{
  Numbers cells = Multiply(samples.back().Cells, growth.Rates, levels);
  if (growth.Alternates && levels % 2 == 1 && samples.size() > 1)
  {
    const Sample& before = samples[samples.size() - 2];
    cells[1] = Multiply(before.Cells, growth.Rates, levels + 1)[1];
  }
  if (growth.IsDual && samples.size() > 2)
  {
    cells[2] = ForetellDual(samples, &Sample::Cells, growth, levels);
  }
  return cells;
}

/// The points after some more levels: those inside of cells grow as these do, and what is beside
/// them as the boundary.
double ForetellPoints(
  const std::vector<Sample>& samples, const Growth& growth, int levels, const Numbers& cells)
{
  double points = samples.back().Points[0];
  for (std::size_t d = 1; d < cells.size(); ++d)
  {
    if (d == 2 && growth.IsDual && samples.size() > 2)
    {
      points += ForetellDual(samples, &Sample::Points, growth, levels);
      continue;
    }
    const Sample& last = samples.back();
    const double inside =
      last.Cells[d] > 0. ? last.Inside[d] * cells[d] / last.Cells[d] : last.Inside[d];
    std::vector<double> beside;
    for (const Sample& sample : samples)
    {
      beside.push_back(sample.Points[d] - sample.Inside[d]);
    }
    std::vector<double> rates{ 1. };
    if (d == 2)
    {
      rates = { std::sqrt(growth.Rates[2]), 1. };
      if (growth.Alternates)
      {
        rates.pop_back();
      }
    }
    else if (d == 3)
    {
      rates = { 4., 2., 1. };
    }
    points += inside + Extrapolate(beside, rates, levels);
  }
  return std::round(points);
}

/// The number with so many digits after the point.
std::string Text(double number, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << number;
  return text.str();
}

}

Forecast Foretell(const Command& command)
{
  const Stage& last = command.Stages.back();
  const Option* option = FindOption(*last.What, "NumberOfLevels");
  if (!option || FindOption(*last.What, "RestMesh")) // the levels are those of a cage
  {
    // What cannot be foretold is made, and not written.
    const Sample made = Make(command);
    return { made.Output, made.Seconds, true, 0. };
  }
  const int levels = static_cast<int>(option->Get(last.Algorithm, 0));
  const Option* limit = FindOption(*last.What, "MaximumNumberOfCells");
  const double maximum = limit ? limit->Get(last.Algorithm, 0) : HUGE_VAL;
  const Growth growth = GetGrowth(last);
  std::vector<Sample> samples;
  Numbers others{};
  std::optional<WithoutWarnings> ofFewerLevels; // the first sample tells those of the input
  for (int i = 0; i <= levels; ++i)
  {
    if (i > 0)
    {
      ofFewerLevels.emplace();
      const double cells = GetSum(ForetellCells(samples, growth, 1));
      if (cells > MostCells[std::min(i, 3) - 1] ||
        cells + GetSum(Multiply(others, growth.Rates, i)) > maximum)
      {
        break;
      }
    }
    ApplySetting(last.Algorithm, *option, std::to_string(i));
    samples.push_back(Make(command));
    others = i == 0 ? CountOthers(last, samples.front()) : others;
  }
  const Sample& sample = samples.back();
  const int more = levels + 1 - static_cast<int>(samples.size());
  const Numbers cells = ForetellCells(samples, growth, more);
  Forecast forecast{ sample.Output, sample.Seconds, more == 0, 0. };
  forecast.Output.Cells = std::round(GetSum(cells));
  forecast.Output.Points = ForetellPoints(samples, growth, more, cells);
  const double times = GetWeight(cells, forecast.Output.Points) /
    std::max(1., GetWeight(sample.Cells, sample.Output.Points));
  forecast.Output.Bytes *= times;
  forecast.Seconds *= times;
  const double all = forecast.Output.Cells + GetSum(Multiply(others, growth.Rates, levels));
  forecast.Maximum = all > maximum ? maximum : 0.;
  return forecast;
}

void PrintInfo(const Command& command)
{
  const Forecast forecast = Foretell(command);
  const Size& size = forecast.Output;
  std::cout << (forecast.IsExact ? "" : "about ") << Text(size.Cells, 0) << " cells, "
            << Text(size.Points, 0) << " points, " << Text(size.Bytes / 1e6, 1) << " MB, "
            << Text(forecast.Seconds, 2) << " s, beside the time for reading and writing\n";
  if (forecast.Maximum > 0.)
  {
    std::cout << "MaximumNumberOfCells = " << Text(forecast.Maximum, 0)
              << " would stop this run: use fewer levels, or raise it by --maximum-cells\n";
  }
}

}
