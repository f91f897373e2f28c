// SPDX-License-Identifier: BSD-3-Clause
// How PointArrays interpolates.
#include "Private/Arrays/PointArrays.h"

#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/Interpolation.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>
#include <tuple>

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

/// By what arrays of joined meshes are sorted: these have marks in the names of arrays where others
/// of the same name have another type (JoinedArray).
auto GetOrder(vtkDataArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return std::make_tuple(name.substr(0, name.find_last_not_of('\'') + 1), array->GetDataType(),
    array->GetNumberOfComponents(), name);
}

/// Whether all parts of the mesh have columns for as many arrays of the same types.
bool HaveAllTheSame(
  const std::vector<vtkSmartPointer<vtkDataArray>*>& arrays, const InterpolationLimits& limits)
{
  if (!limits.FindLargest)
  {
    return true;
  }
  std::uint64_t hash = arrays.size();
  for (const auto* array : arrays)
  {
    const int kind = 100 * (*array)->GetNumberOfComponents() + (*array)->GetDataType();
    hash = (1000003 * hash + static_cast<std::uint64_t>(kind)) % (std::uint64_t(1) << 50);
  }
  std::vector<double> both{ static_cast<double>(hash), -static_cast<double>(hash) };
  limits.FindLargest(both);
  return both[0] == -both[1];
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
    if (limits.TakeOthers)
    {
      limits.TakeOthers(this->Given.data(), static_cast<int>(this->Width));
    }
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
  std::set<std::string> missing;
  if (options.Arrays)
  {
    missing.insert(options.Names.begin(), options.Names.end());
  }
  this->Interpolated.clear();
  for (std::size_t e = 0; e < this->Entries.size(); ++e)
  {
    vtkDataArray* array = this->Entries[e].Current;
    if (!options.Arrays || !IsFloating(array))
    {
      continue;
    }
    const std::string name = std::get<0>(GetOrder(array));
    if (options.Names.empty() ||
      std::find(options.Names.begin(), options.Names.end(), name) != options.Names.end())
    {
      missing.erase(name);
      this->Interpolated.push_back(e);
    }
  }
  std::sort(this->Interpolated.begin(), this->Interpolated.end(),
    [this](std::size_t a, std::size_t b)
    { return GetOrder(this->Entries[a].Current) < GetOrder(this->Entries[b].Current); });
  for (const std::size_t e : this->Interpolated)
  {
    found.push_back(&this->Entries[e].Current);
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
  auto arrays = this->FindInterpolated(options, warn);
  if (!HaveAllTheSame(arrays, limits))
  {
    warn("Point arrays of one name have different types on different ranks: the filter ignores "
         "InterpolateArrays.");
    arrays.resize(arrays.size() - this->Interpolated.size());
    this->Interpolated.clear();
  }
  if (arrays.empty() || (this->NumberOfPoints == 0 && !limits.TakeOthers))
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
  const std::size_t first = arrays.size() - this->Interpolated.size();
  for (std::size_t i = 0; i < this->Interpolated.size(); ++i)
  {
    this->Entries[this->Interpolated[i]].Range = columns.GetGroups()[first + i].Range;
  }
  columns.Replace(options.Weight);
  this->Doubles = Buffer<double>();
  this->HasMoved = true;
}

vtkDataArray* PointArrays::FindCurrent(vtkAbstractArray* given) const
{
  const auto found =
    std::find_if(this->Entries.begin(), this->Entries.end(), [&](const Entry& entry)
      { return this->Input->GetPointData()->GetAbstractArray(entry.Source) == given; });
  return found == this->Entries.end() ? nullptr : found->Current.Get();
}

std::vector<Overshoot> PointArrays::FindOvershoot(const std::vector<char>& counted) const
{
  std::vector<Overshoot> found;
  for (const std::size_t e : this->Interpolated)
  {
    const Entry& entry = this->Entries[e];
    const char* name = entry.Current->GetName();
    Overshoot array{ name ? name : "an array without name", entry.Current->GetNumberOfValues() };
    for (std::size_t c = 0; 2 * c < entry.Range.size(); ++c)
    {
      const double low = entry.Range[2 * c];
      const double high = entry.Range[2 * c + 1];
      for (vtkIdType i = 0; low < high && i < entry.Current->GetNumberOfTuples(); ++i)
      {
        const double value = entry.Current->GetComponent(i, static_cast<int>(c));
        const double beyond = std::max(low - value, value - high) / (high - low);
        if (beyond > GetRangeTie(entry.Current) && (counted.empty() || counted[i]))
        {
          ++array.Count;
          array.Most = std::max(array.Most, beyond);
        }
      }
    }
    found.push_back(std::move(array));
  }
  return found;
}

}
