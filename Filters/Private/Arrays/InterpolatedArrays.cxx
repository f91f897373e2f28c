// SPDX-License-Identifier: BSD-3-Clause
// How PointArrays interpolates.
#include "Private/Arrays/PointArrays.h"

#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/Interpolation.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace subdivision
{
namespace
{

/// Part of the range that interpolated values may exceed it by rounding, and by the error of the
/// solver.
double GetRangeTie(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT ? 1e-5 : 1e-9;
}

bool IsFloating(vtkDataArray* array)
{
  return array && (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT);
}

std::vector<double> FindRange(vtkDataArray* array)
{
  std::vector<double> range;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      const double value = array->GetComponent(i, c);
      low = std::isfinite(value) ? std::min(low, value) : low;
      high = std::isfinite(value) ? std::max(high, value) : high;
    }
    range.insert(range.end(), { low, high });
  }
  return range;
}

/// Values of several arrays side by side, with all components of a point one after the other.
class Columns
{
public:
  explicit Columns(const std::vector<vtkSmartPointer<vtkDataArray>*>& arrays)
    : Arrays(arrays)
  {
    for (const auto* array : arrays)
    {
      this->Groups.push_back({ (*array)->GetNumberOfComponents() });
      this->Width += this->Groups.back().Columns;
    }
    this->Rows = (*arrays[0])->GetNumberOfTuples();
    this->Given = Buffer<double>(this->Rows * this->Width);
    int first = 0;
    for (const auto* array : arrays)
    {
      Buffer<double> converted;
      const int size = (*array)->GetNumberOfComponents();
      const double* values = ReadDoubles(
        (*array)->GetVoidPointer(0), (*array)->GetDataType(), this->Rows * size, converted);
      ForEach(this->Rows, [&](vtkIdType i)
        { std::copy_n(values + size * i, size, this->Given.data() + this->Width * i + first); });
      first += size;
    }
  }
  void Solve(const PointOperator& limit, const InterpolationLimits& limits)
  {
    this->Shifts = Buffer<double>(this->Given.size());
    FindInterpolation(limit, this->Given.data(), this->Groups, limits, this->Shifts.data());
  }
  /// Replaces the arrays by new ones with the given values plus `weight` times their shifts.
  void Replace(double weight)
  {
    int first = 0;
    for (auto* array : this->Arrays)
    {
      const int size = (*array)->GetNumberOfComponents();
      Buffer<double> values(this->Rows * size);
      ForEach(values.size(),
        [&](vtkIdType i)
        {
          const vtkIdType at = this->Width * (i / size) + first + i % size;
          values[i] = this->Given[at] + weight * this->Shifts[at];
        });
      first += size;
      const auto replaced = MakeArray((*array)->GetDataType(), size, this->Rows);
      StoreDoubles(
        values.data(), replaced->GetVoidPointer(0), replaced->GetDataType(), values.size());
      CopyLooks(*array, replaced);
      *array = replaced;
    }
  }
  const std::vector<InterpolationGroup>& GetGroups() const { return this->Groups; }

private:
  const std::vector<vtkSmartPointer<vtkDataArray>*>& Arrays;
  std::vector<InterpolationGroup> Groups;
  vtkIdType Width = 0;
  vtkIdType Rows = 0;
  Buffer<double> Given;
  Buffer<double> Shifts;
};

}

/// Finds what is interpolated, points first, and the ranges of the arrays.
std::vector<vtkSmartPointer<vtkDataArray>*> PointArrays::FindInterpolated(
  const InterpolationOptions& options, const std::function<void(const std::string&)>& warn)
{
  std::vector<vtkSmartPointer<vtkDataArray>*> found;
  if (options.Points && !this->FinalPoints)
  {
    found.push_back(&this->Points);
  }
  std::vector<std::string> missing = options.Arrays ? options.Names : std::vector<std::string>();
  for (Entry& entry : this->Entries)
  {
    if (!options.Arrays || !IsFloating(entry.Current))
    {
      continue;
    }
    const char* name = entry.Current->GetName();
    const auto named = std::remove(missing.begin(), missing.end(), name ? name : "");
    if (options.Names.empty() || named != missing.end())
    {
      missing.erase(named, missing.end());
      entry.Range = FindRange(entry.Current);
      found.push_back(&entry.Current);
    }
  }
  for (const std::string& name : missing)
  {
    warn("The filter does not interpolate the array \"" + name +
      "\": the input has no point array of floating point numbers of this name.");
  }
  return found;
}

void PointArrays::Interpolate(const PointOperator& limit, const InterpolationOptions& options,
  const InterpolationLimits& limits, const std::function<void(const std::string&)>& warn)
{
  const auto arrays = this->FindInterpolated(options, warn);
  if (arrays.empty() || this->NumberOfPoints == 0)
  {
    return;
  }
  Columns columns(arrays);
  columns.Solve(limit, limits);
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const InterpolationGroup& group = columns.GetGroups()[a];
    if (!group.HasConverged)
    {
      const char* name = (*arrays[a])->GetName();
      std::ostringstream message;
      message << "The limit does not pass through the "
              << (arrays[a] == &this->Points
                     ? "points"
                     : "values of the array " + std::string(name ? name : ""))
              << " of the input: after " << limits.MostProducts
              << " products with the limit operator the largest error is " << group.Error
              << " of the range. The filter takes what came nearest; a smaller "
                 "InterpolationWeight helps if it is rough.";
      warn(message.str());
    }
  }
  columns.Replace(options.Weight);
  this->Doubles = Buffer<double>();
  this->HasMoved = true;
}

std::string PointArrays::DescribeOvershoot() const
{
  std::ostringstream text;
  for (const Entry& entry : this->Entries)
  {
    vtkIdType count = 0;
    double most = 0.;
    for (std::size_t c = 0; 2 * c < entry.Range.size(); ++c)
    {
      const double low = entry.Range[2 * c];
      const double high = entry.Range[2 * c + 1];
      for (vtkIdType i = 0; low < high && i < entry.Current->GetNumberOfTuples(); ++i)
      {
        const double value = entry.Current->GetComponent(i, static_cast<int>(c));
        const double beyond = std::max(low - value, value - high) / (high - low);
        count += beyond > GetRangeTie(entry.Current) ? 1 : 0;
        most = std::max(most, beyond);
      }
    }
    if (count > 0)
    {
      text << (text.tellp() > 0 ? ", " : "") << count << " of "
           << entry.Current->GetNumberOfValues() << " values of "
           << (entry.Current->GetName() ? entry.Current->GetName() : "an array without name")
           << " (by up to " << 100. * most << " % of the range)";
    }
  }
  return text.tellp() > 0
    ? "Interpolated values exceed the range that the input has: " + text.str() +
      ". Take a smaller InterpolationWeight if that must not be."
    : std::string();
}

}
