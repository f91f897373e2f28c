// SPDX-License-Identifier: BSD-3-Clause
// How PointArrays interpolates.
#include "Private/Arrays/PointArrays.h"

#include "Core/Memory/Loops.h"
#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/Interpolation.h"
#include "Core/Operators/TurnedLimits.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

namespace subdivision
{
namespace
{

/// Fraction of the range that interpolated values may exceed it by rounding, and by the error of
/// the solver. Where values are much larger than their range, so is their rounding.
double GetRangeTie(vtkDataArray* array, double largest, double range)
{
  const bool isFloat = array->GetDataType() == VTK_FLOAT;
  const double rounding = isFloat ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                  : std::numeric_limits<double>::epsilon();
  return std::max(isFloat ? 1e-5 : 1e-9, 8. * rounding * largest / range);
}

bool IsFloating(vtkDataArray* array)
{
  return array && (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT);
}

/// A name without the marks that arrays of joined meshes get where others of the same name have
/// another type (JoinedArray).
std::string GetGivenName(const std::string& name)
{
  return name.substr(0, name.find_last_not_of('\'') + 1);
}

/// An array, or the fields of one; the last component of each of these is a weight.
struct Source
{
  std::vector<vtkSmartPointer<vtkDataArray>*> Fields;
  bool HasWeights;

  vtkDataArray* GetFirst() const { return *this->Fields[0]; }
  int GetComponents() const
  {
    return this->GetFirst()->GetNumberOfComponents() - (this->HasWeights ? 1 : 0);
  }
};

/// Whether all parts of the mesh have columns for as many arrays of the same types.
bool HaveAllTheSame(const std::vector<Source>& sources, const InterpolationLimits& limits)
{
  if (!limits.FindLargest)
  {
    return true;
  }
  std::uint64_t hash = sources.size();
  for (const Source& source : sources)
  {
    const int kind =
      100 * source.GetFirst()->GetNumberOfComponents() + source.GetFirst()->GetDataType();
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
  explicit Columns(const std::vector<Source>& sources)
    : Sources(sources)
    , Rows(sources[0].GetFirst()->GetNumberOfTuples())
  {
    for (const Source& source : sources)
    {
      const auto fields = static_cast<int>(source.Fields.size());
      this->Groups.push_back({ source.GetComponents(), fields });
      this->Width += source.GetComponents() * fields;
    }
    this->Given = Buffer<double>(this->Rows * this->Width);
    this->ForEachField(
      [&](const Source& source, int field, vtkIdType first)
      {
        vtkDataArray* array = *source.Fields[static_cast<std::size_t>(field)];
        const int size = array->GetNumberOfComponents();
        Buffer<double> converted;
        const double* values =
          ReadDoubles(array->GetVoidPointer(0), array->GetDataType(), this->Rows * size, converted);
        ForEach(this->Rows,
          [&](vtkIdType i)
          {
            std::copy_n(values + size * i, source.GetComponents(),
              this->Given.data() + this->Width * i + first);
          });
      });
  }

  /// Gives the fields of each material a range of their own. `cells` have the centres, which have
  /// the materials of their first members.
  void SetMaterials(const InterpolationOptions& options, const SimplicesOfCells& cells)
  {
    const vtkIdType points = this->Rows - cells.GetNumberOfCentres();
    this->Materials.resize(this->Sources.size());
    for (std::size_t s = 0; s < this->Sources.size(); ++s)
    {
      for (const vtkIdType i : InTurn(this->Sources[s].HasWeights ? this->Rows : vtkIdType(0)))
      {
        const vtkIdType point =
          i < points ? i : cells.CentreMembers[cells.CentreOffsets[i - points]];
        const vtkIdType first = point * (static_cast<vtkIdType>(options.Materials.size()) / points);
        for (const auto* field : this->Sources[s].Fields)
        {
          this->Materials[s].push_back(options.Materials[first + GetColour((*field)->GetName())]);
        }
      }
      if (this->Sources[s].HasWeights)
      {
        this->Groups[s].Materials = this->Materials[s].data();
        this->Groups[s].NumberOfMaterials = options.NumberOfMaterials;
      }
    }
  }

  void Solve(const PointOperator& limit, const InterpolationLimits& limits)
  {
    if (limits.TakeOthers)
    {
      limits.TakeOthers(this->Given.data(), static_cast<int>(this->Width));
    }
    this->FindFactors(limit, limits);
    this->Shifts = Buffer<double>(this->Given.size());
    FindInterpolation(limit, this->Given.data(), this->Groups, limits, this->Shifts.data());
  }

  /// Replaces the arrays by new ones with the given values plus `weight` times their shifts.
  void Replace(double weight)
  {
    this->ForEachField(
      [&](const Source& source, int field, vtkIdType first)
      {
        auto& array = *source.Fields[static_cast<std::size_t>(field)];
        const int size = array->GetNumberOfComponents();
        const int components = source.GetComponents();
        Buffer<double> values(this->Rows * size);
        ForEach(values.size(),
          [&](vtkIdType i)
          {
            const vtkIdType row = i / size;
            const auto component = static_cast<int>(i % size);
            const vtkIdType at = this->Width * row + first + component;
            values[i] = component < components ? this->Given[at] + weight * this->Shifts[at]
                                               : array->GetComponent(row, component);
          });
        const auto replaced = MakeArray(array->GetDataType(), size, this->Rows);
        StoreDoubles(
          values.data(), replaced->GetVoidPointer(0), replaced->GetDataType(), values.size());
        CopyLooks(array, replaced);
        array = replaced;
      });
  }
  const std::vector<InterpolationGroup>& GetGroups() const { return this->Groups; }
  /// The given values of all fields of a source, NaN where a field has none.
  Buffer<double> TakeGiven(std::size_t source) const
  {
    const Source& wanted = this->Sources[source];
    const int components = wanted.GetComponents();
    const auto fields = static_cast<vtkIdType>(wanted.Fields.size());
    Buffer<double> values(this->Rows * fields * components);
    this->ForEachField(
      [&](const Source& other, int field, vtkIdType first)
      {
        if (&other == &wanted)
        {
          ForEach(this->Rows * components,
            [&](vtkIdType i)
            {
              const vtkIdType row = i / components;
              const bool isThere = this->Factors[fields * row + field] != 0.;
              values[(fields * row + field) * components + i % components] = isThere
                ? this->Given[this->Width * row + first + i % components]
                : std::numeric_limits<double>::quiet_NaN();
            });
        }
      });
    return values;
  }

private:
  /// Calls visit(source, field, first of its columns).
  template <typename Visit>
  void ForEachField(const Visit& visit) const
  {
    vtkIdType first = 0;
    for (const Source& source : this->Sources)
    {
      for (std::size_t field = 0; field < source.Fields.size(); ++field)
      {
        visit(source, static_cast<int>(field), first);
        first += source.GetComponents();
      }
    }
  }

  /// Limits of fields are divided by the limits of their weights, which all arrays have in common.
  void FindFactors(const PointOperator& limit, const InterpolationLimits& limits)
  {
    const auto found = std::find_if(this->Sources.begin(), this->Sources.end(),
      [](const Source& source) { return source.HasWeights; });
    if (found == this->Sources.end())
    {
      return;
    }
    const auto fields = static_cast<vtkIdType>(found->Fields.size());
    Buffer<double> weights(fields * this->Rows);
    ForEach(weights.size(),
      [&](vtkIdType i)
      {
        weights[i] = (*found->Fields[static_cast<std::size_t>(i % fields)])
                       ->GetComponent(i / fields, found->GetComponents());
      });
    this->Factors = Buffer<double>(weights.size());
    limit.Apply(weights.data(), this->Factors.data(), static_cast<int>(fields));
    ForEach(weights.size(),
      [&](vtkIdType i)
      {
        const double sum = this->Factors[i];
        this->Factors[i] = weights[i] == 1. && sum > LeastWeight ? 1. / sum : 0.;
      });
    if (limits.TakeOthers)
    {
      limits.TakeOthers(this->Factors.data(), static_cast<int>(fields));
    }
    for (std::size_t s = 0; s < this->Sources.size(); ++s)
    {
      this->Groups[s].Factors = this->Sources[s].HasWeights ? this->Factors.data() : nullptr;
    }
  }

  const std::vector<Source>& Sources;
  std::vector<InterpolationGroup> Groups;
  vtkIdType Width = 0;
  vtkIdType Rows;
  Buffer<double> Given;
  Buffer<double> Shifts;
  Buffer<double> Factors;
  std::vector<std::vector<int>> Materials;
};

/// InterpolationLimits::Parts: of points, then of centres, which follow their freest member.
std::vector<double> ListParts(vtkDataArray* chosen, const SimplicesOfCells& cells)
{
  std::vector<double> parts;
  for (const vtkIdType i : InTurn(chosen ? chosen->GetNumberOfTuples() : vtkIdType(0)))
  {
    parts.push_back(chosen->GetComponent(i, 0));
  }
  for (const vtkIdType c : InTurn(chosen ? cells.GetNumberOfCentres() : vtkIdType(0)))
  {
    double least = 1.;
    for (vtkIdType k = cells.CentreOffsets[c]; k < cells.CentreOffsets[c + 1]; ++k)
    {
      least = std::min(least, parts[cells.CentreMembers[k]]);
    }
    parts.push_back(least);
  }
  return parts;
}

std::string DescribeMiss(
  const std::string& what, const InterpolationGroup& group, const InterpolationLimits& limits)
{
  std::ostringstream message;
  message << "The limit does not pass through the " << what << " of the input: after "
          << limits.MostProducts << " products with the limit operator the largest error is "
          << group.Error << " of the range, and "
          << (group.IsTooLarge
                 ? "the mesh is too large to solve for it directly. Interpolate a part of it. "
                 : "there is no solution: on such a mesh limits cannot alternate between "
                   "neighbours as these do. ")
          << "The filter takes what came nearest; a smaller InterpolationWeight helps if it is "
             "rough.";
  return message.str();
}

}

/// Finds the arrays to interpolate, points first.
void PointArrays::FindInterpolated(
  const InterpolationOptions& options, const std::function<void(const std::string&)>& warn)
{
  auto& all = this->ToInterpolate;
  all.clear();
  std::set<std::string> missing;
  if (options.Arrays)
  {
    missing.insert(options.Names.begin(), options.Names.end());
  }
  for (std::size_t e = 0; e < this->Entries.size(); ++e)
  {
    vtkDataArray* array = this->Entries[e].Current;
    if (!options.Arrays || !IsFloating(array))
    {
      continue;
    }
    const bool hasWeights = this->HasWeights(this->Entries[e]);
    const std::string own = array->GetName() ? array->GetName() : "";
    const std::string name = hasWeights ? GetFieldName(own) : own;
    const std::string given = GetGivenName(name);
    if (!options.Names.empty() &&
      std::find(options.Names.begin(), options.Names.end(), given) == options.Names.end())
    {
      continue;
    }
    missing.erase(given);
    const auto known = std::find_if(all.begin(), all.end(), [&](const Interpolated& other)
      { return hasWeights && other.HasWeights && other.Name == name; });
    if (known == all.end())
    {
      all.push_back({ name, { e }, hasWeights });
    }
    else
    {
      known->Entries.push_back(e);
    }
  }
  for (Interpolated& array : all)
  {
    array.IsReplaced = !array.HasWeights &&
      std::any_of(all.begin(), all.end(),
        [&](const Interpolated& other) { return other.HasWeights && other.Name == array.Name; });
  }
  const auto order = [this](const Interpolated& array)
  {
    vtkDataArray* first = this->Entries[array.Entries[0]].Current;
    return std::make_tuple(
      GetGivenName(array.Name), first->GetDataType(), first->GetNumberOfComponents(), array.Name);
  };
  std::sort(all.begin(), all.end(),
    [&](const Interpolated& a, const Interpolated& b) { return order(a) < order(b); });
  if (options.Points && !this->FinalPoints)
  {
    all.insert(all.begin(), { "", {} });
  }
  for (const std::string& name : missing)
  {
    warn("The filter does not interpolate the array \"" + name +
      "\": the input has no point array of floating point numbers of this name.");
  }
}

void PointArrays::Interpolate(const PointOperator& limit, const InterpolationOptions& options,
  const InterpolationLimits& limits, const std::function<void(const std::string&)>& warn)
{
  this->FindInterpolated(options, warn);
  std::vector<Source> sources;
  for (const Interpolated& array : this->ToInterpolate)
  {
    sources.push_back({ {}, array.HasWeights });
    for (const std::size_t e : array.Entries)
    {
      sources.back().Fields.push_back(&this->Entries[e].Current);
    }
    if (array.Entries.empty())
    {
      sources.back().Fields.push_back(&this->Points);
    }
  }
  if (!HaveAllTheSame(sources, limits))
  {
    warn("Point arrays of one name have different types on different ranks: the filter ignores "
         "InterpolateArrays.");
    const bool hasPoints = this->ToInterpolate.size() > 0 && this->ToInterpolate[0].Entries.empty();
    sources.resize(hasPoints ? 1 : 0, {});
    this->ToInterpolate.resize(sources.size());
  }
  if (sources.empty() || (this->NumberOfPoints == 0 && !limits.TakeOthers))
  {
    return;
  }
  const std::vector<double> parts = ListParts(options.Chosen, this->Cells);
  InterpolationLimits ofParts = limits;
  ofParts.Parts = options.Chosen ? parts.data() : nullptr;
  Columns columns(sources);
  columns.SetMaterials(options, this->Cells);
  columns.Solve(limit, ofParts);
  for (std::size_t a = 0; a < sources.size(); ++a)
  {
    const InterpolationGroup& group = columns.GetGroups()[a];
    Interpolated& array = this->ToInterpolate[a];
    array.Range = group.Range;
    if (array.HasWeights && group.HasConverged && options.Weight == 1. && !options.Chosen)
    {
      array.Given = columns.TakeGiven(a);
    }
    if (!group.HasConverged && !array.IsReplaced)
    {
      warn(DescribeMiss(
        array.Entries.empty() ? "points" : "values of the array " + array.Name, group, limits));
    }
  }
  columns.Replace(options.Weight);
  this->Doubles = Buffer<double>();
  this->HasMoved = true;
}

void PointArrays::TurnLimits(const SparseRows<long long>* rows, const InterpolationOptions& options,
  const InterpolationLimits& limits, const std::function<void(const std::string&)>& warn)
{
  const double* points = this->GetCoordinates();
  const vtkIdType size = this->NumberOfPoints;
  std::vector<double> normals(static_cast<std::size_t>(3 * size), 0.);
  for (const vtkIdType i : InTurn(options.Normals->GetNumberOfTuples()))
  {
    options.Normals->GetTuple(i, normals.data() + 3 * i);
  }
  std::vector<double> parts = ListParts(options.Points ? options.Chosen : nullptr, this->Cells);
  parts.resize(normals.size() / 3, options.Points ? 1. : 0.);
  std::vector<double> shifts;
  const WantedLimits wanted{ points, normals.data(), parts.data(), this->Input->GetLength() };
  const TurnedLimits found = FindTurnedLimits(rows, wanted, limits, shifts);
  if (found.NumberFlat > 0)
  {
    warn(std::to_string(found.NumberFlat) + " points, the first is point " +
      std::to_string(found.FirstFlat) +
      ", have no tangents. Give them zero vectors as normals (array index 14).");
  }
  if (!found.HasConverged)
  {
    warn(
      "No control points give the limit these normals (array index 14) and points, or the mesh "
      "is too large: the filter ignores the normals. Leave points around free (array index 13).");
    normals.assign(normals.size(), 0.);
    FindTurnedLimits(rows, wanted, limits, shifts);
  }
  const auto moved = MakeArray(this->Points->GetDataType(), 3, size);
  for (const vtkIdType i : InTurn(3 * size))
  {
    shifts[i] = points[i] + options.Weight * shifts[i];
  }
  StoreDoubles(shifts.data(), moved->GetVoidPointer(0), moved->GetDataType(), 3 * size);
  CopyLooks(this->Points, moved);
  this->Points = moved;
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

std::vector<Overshoot> PointArrays::FindOvershoot(
  const std::vector<char>& counted, const std::vector<ColourMask>& colours) const
{
  std::vector<Overshoot> found;
  for (const Interpolated& interpolated : this->ToInterpolate)
  {
    if (interpolated.Entries.empty() || interpolated.IsReplaced)
    {
      continue;
    }
    const std::string& name = interpolated.Name;
    Overshoot array{ name.empty() ? "an array without name" : name, 0 };
    for (const std::size_t e : interpolated.Entries)
    {
      vtkDataArray* values = this->Entries[e].Current;
      const int colour = interpolated.HasWeights ? GetColour(values->GetName()) : NoColour;
      for (const vtkIdType i : InTurn(values->GetNumberOfTuples()))
      {
        const bool isThere =
          colour == NoColour || (colours[static_cast<std::size_t>(i)] >> colour & 1) != 0;
        for (std::size_t c = 0; isThere && 2 * c < interpolated.Range.size(); ++c)
        {
          const double low = interpolated.Range[2 * c];
          const double high = interpolated.Range[2 * c + 1];
          const double value = values->GetComponent(i, static_cast<int>(c));
          const double beyond = std::max(low - value, value - high) / (high - low);
          ++array.NumberOfValues;
          const double largest = std::max(std::abs(low), std::abs(high));
          if (low < high && std::isfinite(value) &&
            beyond > GetRangeTie(values, largest, high - low) && (counted.empty() || counted[i]))
          {
            ++array.Count;
            array.Most = std::max(array.Most, beyond);
          }
        }
      }
    }
    found.push_back(std::move(array));
  }
  return found;
}

LimitMisses PointArrays::FindMisses(const std::vector<char>& counted) const
{
  LimitMisses misses;
  std::set<std::pair<vtkIdType, std::size_t>> found;
  for (const Interpolated& array : this->ToInterpolate)
  {
    double range = 0.;
    double largest = 0.;
    for (std::size_t c = 0; 2 * c < array.Range.size(); ++c)
    {
      range = std::max(range, array.Range[2 * c + 1] - array.Range[2 * c]);
      largest =
        std::max({ largest, std::abs(array.Range[2 * c]), std::abs(array.Range[2 * c + 1]) });
    }
    const auto components = static_cast<vtkIdType>(array.Range.size() / 2);
    const auto fields = static_cast<vtkIdType>(array.Entries.size());
    for (vtkIdType i = 0; range > 0. && i < array.Given.size(); ++i)
    {
      const vtkIdType row = i / components / fields;
      if (!counted.empty() && !counted[static_cast<std::size_t>(row)])
      {
        continue;
      }
      const auto field = static_cast<std::size_t>(i / components % fields);
      vtkDataArray* current = this->Entries[array.Entries[field]].Current;
      const double value = current->GetComponent(row, static_cast<int>(i % components));
      const double miss = std::abs(value - array.Given[i]) / range;
      if (miss > GetRangeTie(current, largest, range)) // not where there is no value
      {
        misses.Most = std::max(misses.Most, miss);
        found.insert({ row, field });
      }
    }
  }
  misses.Count = static_cast<vtkIdType>(found.size());
  return misses;
}

}
