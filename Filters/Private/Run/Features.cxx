// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Run/Features.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"
#include "Core/Rules/Pi.h"
#include "Core/Solids/Complex/RunSimplices.h"

#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>

namespace subdivision
{
namespace
{

template <typename Value, typename Get>
std::vector<Value> ReadValues(vtkDataArray* array, const SimplicesOfCells& cells, const Get& get)
{
  std::vector<Value> values;
  if (array)
  {
    values.resize(cells.Simplices.Dimensions.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const vtkIdType cell =
        cells.ParentCells.empty() ? static_cast<vtkIdType>(i) : cells.ParentCells[i];
      values[i] = get(array->GetComponent(cell, 0));
    }
  }
  return values;
}

/// An integer for each number, in the same order; NaN is the least.
vtkIdType MakeKey(double value)
{
  value = std::isnan(value) ? std::numeric_limits<double>::lowest() : value + 0.; // -0 becomes 0
  std::int64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits < 0 ? bits ^ std::numeric_limits<std::int64_t>::max() : bits;
}

/// Warns once of all simplices for which `accept` is true, with their number and the cell of the
/// first.
template <typename Accept>
void WarnOfFirst(vtkDataArray* array, const SimplicesOfCells& cells, const Accept& accept,
  const std::string& what, const std::function<void(const std::string&)>& warn)
{
  vtkIdType count = 0;
  vtkIdType first = -1;
  for (const std::size_t i : InTurn(cells.Simplices.Dimensions.size()))
  {
    if (accept(i))
    {
      const vtkIdType cell =
        cells.ParentCells.empty() ? static_cast<vtkIdType>(i) : cells.ParentCells[i];
      first = count++ == 0 ? cell : first;
    }
  }
  if (count > 0)
  {
    std::ostringstream message;
    message << "Cell array \"" << array->GetName() << "\": " << what << ", " << count
            << " in all, first in cell " << first << ".";
    warn(message.str());
  }
}

template <typename Value>
bool LiftValues(const SimplexList& control, int levels, const std::vector<Value>& values,
  std::vector<Value>& lifted)
{
  lifted.clear();
  if (values.empty())
  {
    return true;
  }
  auto first = values.begin();
  for (unsigned char dimension : InTurn(control.Dimensions))
  {
    const auto last = first + (std::ptrdiff_t(1) << (dimension * levels));
    if (std::any_of(first, last, [&first](const Value& value) { return value != *first; }))
    {
      return false;
    }
    lifted.push_back(*first);
    first = last;
  }
  return true;
}

template <typename Value>
void Encode(const std::vector<Value>& values, std::vector<long long>& out)
{
  out.push_back(static_cast<long long>(values.size()));
  for (const Value& value : InTurn(values))
  {
    long long bits = 0;
    std::memcpy(&bits, &value, sizeof(Value));
    out.push_back(bits);
  }
}

}

std::vector<int> NumberMaterials(vtkDataArray* array, std::vector<vtkIdType>* keys)
{
  // A double cannot tell all integers of 64 bits apart.
  const bool isLong = array->GetDataTypeSize() == 8 && array->GetDataType() != VTK_DOUBLE;
  std::vector<vtkIdType> values;
  values.reserve(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (const vtkIdType i : InTurn(array->GetNumberOfTuples()))
  {
    values.push_back(isLong ? static_cast<vtkIdType>(array->GetVariantValue(i).ToLongLong())
                            : MakeKey(array->GetComponent(i, 0)));
  }
  std::vector<vtkIdType> sorted = values;
  SortDistinct(sorted);
  std::vector<int> numbers;
  numbers.reserve(values.size());
  for (const vtkIdType value : InTurn(values))
  {
    numbers.push_back(
      static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin()));
  }
  if (keys)
  {
    *keys = std::move(sorted);
  }
  return numbers;
}

namespace
{

/// Reads the sharpness of lines and triangles. One whose sharpness is infinite becomes singular.
void ReadSharpness(const FeatureOptions& options, const SimplicesOfCells& cells,
  const std::function<void(const std::string&)>& warn, FeatureValues& values)
{
  values.Sharpness = ReadValues<double>(options.Sharpness, cells, [](double v) { return v; });
  const auto& dimensions = cells.Simplices.Dimensions;
  const auto canBeSharp = [&](std::size_t i) { return dimensions[i] == 1 || dimensions[i] == 2; };
  if (options.Sharpness)
  {
    WarnOfFirst(
      options.Sharpness, cells,
      [&](std::size_t i) { return canBeSharp(i) && !(values.Sharpness[i] >= 0.); },
      "the filter takes values that are negative or not a number as 0", warn);
    WarnOfFirst(
      options.Sharpness, cells,
      [&](std::size_t i) { return !canBeSharp(i) && values.Sharpness[i] > 0.; },
      "only lines and faces have a sharpness, so the filter ignores that of other cells", warn);
  }
  bool any = false;
  for (const std::size_t i : InTurn(values.Sharpness.size()))
  {
    double& sharpness = values.Sharpness[i];
    sharpness = canBeSharp(i) && sharpness > 0. ? sharpness : 0.;
    if (std::isinf(sharpness))
    {
      values.Singular.resize(dimensions.size(), 0);
      values.Singular[i] = 1;
      sharpness = 0.;
    }
    any = any || sharpness > 0.;
  }
  if (!any)
  {
    values.Sharpness.clear();
  }
}

}

FeatureValues ReadFeatureValues(const FeatureOptions& options, const SimplicesOfCells& cells,
  const std::function<void(const std::string&)>& warn)
{
  FeatureValues values;
  values.Singular = ReadValues<unsigned char>(
    options.Singular, cells, [](double v) { return static_cast<unsigned char>(v != 0.); });
  if (options.Singular)
  {
    WarnOfFirst(
      options.Singular, cells,
      [&](std::size_t i) { return values.Singular[i] && cells.Simplices.Dimensions[i] == 3; },
      "3D cells cannot be singular, so the filter ignores their flags; flag vertices, lines or "
      "faces instead",
      warn);
    for (const std::size_t i : InTurn(values.Singular.size()))
    {
      values.Singular[i] = values.Singular[i] && cells.Simplices.Dimensions[i] < 3;
    }
  }
  ReadSharpness(options, cells, warn, values);
  if (std::none_of(values.Singular.begin(), values.Singular.end(), [](auto v) { return v; }))
  {
    values.Singular.clear();
  }
  if (options.PreserveInterfaces && options.Material)
  {
    const std::vector<int> numbers = NumberMaterials(options.Material);
    for (const vtkIdType i : InTurn(cells.Simplices.GetNumberOfSimplices()))
    {
      values.Material.push_back(numbers[cells.ParentCells.empty() ? i : cells.ParentCells[i]]);
    }
  }
  values.Part = ReadValues<int>(options.Part, cells,
    [](double v) { return v < 0. ? -1 : static_cast<int>(std::min(v, 2147483646.)); });
  auto isRule = [](double v) { return v >= 0. && v <= 6.; };
  values.Rules = ReadValues<unsigned char>(options.Rules, cells,
    [&](double v) { return static_cast<unsigned char>(isRule(v) ? v : 255.); });
  if (options.Rules)
  {
    WarnOfFirst(
      options.Rules, cells, [&](std::size_t i) { return values.Rules[i] == 255; },
      "values outside 0 to 6 are no rules; the filter takes them as 0", warn);
    std::replace(values.Rules.begin(), values.Rules.end(), static_cast<unsigned char>(255),
      static_cast<unsigned char>(0));
  }
  return values;
}

bool LiftFeatureValues(
  const SimplexList& control, int levels, const FeatureValues& values, FeatureValues& lifted)
{
  return LiftValues(control, levels, values.Singular, lifted.Singular) &&
    LiftValues(control, levels, values.Material, lifted.Material) &&
    LiftValues(control, levels, values.Part, lifted.Part) &&
    LiftValues(control, levels, values.Rules, lifted.Rules) &&
    LiftValues(control, levels, values.Sharpness, lifted.Sharpness);
}

std::vector<double> ReadCornerAngles(const FeatureOptions& options)
{
  std::vector<double> angles;
  if (options.ModifiedBoundary && options.CornerAngles)
  {
    for (const vtkIdType i : InTurn(options.CornerAngles->GetNumberOfTuples()))
    {
      const double angle = options.CornerAngles->GetComponent(i, 0);
      angles.push_back(angle >= 0. ? angle * (Pi / 180.) : -1.);
    }
  }
  return angles;
}

std::vector<long long> EncodeChoices(const FeatureOptions& options, const FeatureValues& values)
{
  std::vector<long long> choices = { options.DartEnds, static_cast<int>(options.Weights),
    static_cast<int>(options.Embedded), options.PreserveInterfaces, options.DetectFeatures,
    static_cast<int>(options.Type1), static_cast<int>(options.Type2),
    static_cast<int>(options.Type3), options.ModifiedBoundary };
  Encode(values.Singular, choices);
  Encode(values.Material, choices);
  Encode(values.Part, choices);
  Encode(values.Rules, choices);
  Encode(values.Sharpness, choices);
  Encode(ReadCornerAngles(options), choices);
  return choices;
}

namespace
{

/// Gives each vertex, edge and face the choice of the first maximal cell at it that has one.
template <typename Id>
void SpreadChoices(const FeatureValues& values, const SimplicialComplex<Id>& complex,
  const std::vector<CellRun>& runs, StrataOptions& strata)
{
  strata.VertexChoices = Buffer<unsigned char>(complex.NumberOfVertices, 0);
  strata.EdgeChoices = Buffer<unsigned char>(complex.NumberOfEdges, 0);
  strata.FaceChoices = Buffer<unsigned char>(complex.NumberOfFaces, 0);
  Buffer<bool> hasFace(complex.NumberOfEdges, false);
  for (Id edge : InTurn(complex.FaceEdges))
  {
    hasFace[edge] = true;
  }
  auto give = [](Buffer<unsigned char>& choices, const Id* begin, int count, unsigned char choice)
  {
    for (const Id* i = begin; i != begin + count; ++i)
    {
      choices[*i] = choices[*i] ? choices[*i] : choice;
    }
  };
  for (const CellRun& run : runs)
  {
    for (vtkIdType i = 0; !run.Equal && i < run.Count; ++i)
    {
      const unsigned char choice = values.Rules[run.FirstCell + i];
      const vtkIdType entity = run.First + i;
      if (!choice)
      {
        continue;
      }
      if (run.Dimension == 3)
      {
        give(strata.VertexChoices, complex.TetVertices.data() + 4 * entity, 4, choice);
        give(strata.EdgeChoices, complex.TetEdges.data() + 6 * entity, 6, choice);
        give(strata.FaceChoices, complex.TetFaces.data() + 4 * entity, 4, choice);
      }
      else if (run.Dimension == 2 && complex.FaceTets[entity].size() == 0)
      {
        give(strata.VertexChoices, complex.FaceVertices.data() + 3 * entity, 3, choice);
        give(strata.EdgeChoices, complex.FaceEdges.data() + 3 * entity, 3, choice);
      }
      else if (run.Dimension == 1 && !hasFace[entity])
      {
        const Id edge = static_cast<Id>(entity);
        give(strata.VertexChoices, complex.EdgeVertices.data() + 2 * entity, 2, choice);
        give(strata.EdgeChoices, &edge, 1, choice);
      }
    }
  }
}

}

template <typename Id>
StrataOptions MakeStrataOptions(const FeatureOptions& options, const FeatureValues& values,
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs)
{
  StrataOptions strata;
  strata.Type1 = options.Type1;
  strata.Type2 = options.Type2;
  strata.Type3 = options.Type3;
  strata.DartEnds = options.DartEnds;
  strata.Weights = options.Weights;
  strata.ModifiedBoundary = options.ModifiedBoundary;
  const std::vector<double> angles = ReadCornerAngles(options);
  if (!angles.empty())
  {
    strata.CornerAngles = Buffer<double>(complex.NumberOfVertices, -1.);
    std::copy_n(angles.begin(),
      std::min(angles.size(), static_cast<std::size_t>(complex.NumberOfVertices)),
      strata.CornerAngles.begin());
  }
  if (!values.Part.empty())
  {
    auto parts = [&](int dimension)
    {
      const Buffer<vtkIdType> simplices = FindSimplicesOf(complex, runs, dimension);
      Buffer<int> result(simplices.size());
      std::transform(simplices.begin(), simplices.end(), result.begin(),
        [&](vtkIdType simplex) { return simplex < 0 ? -1 : values.Part[simplex]; });
      return result;
    };
    strata.EdgeParts = parts(1);
    strata.FaceParts = parts(2);
  }
  if (!values.Rules.empty())
  {
    SpreadChoices(values, complex, runs, strata);
  }
  return strata;
}

template <typename Id>
void WarnOfContradictions(const FeatureOptions& options, const FeatureValues& values,
  const SimplicesOfCells& cells, const SimplicialComplex<Id>& complex,
  const std::vector<CellRun>& runs, const std::function<void(const std::string&)>& warn)
{
  if (values.Singular.empty() || !options.Singular)
  {
    return;
  }
  auto cellOf = [&](vtkIdType i) { return cells.ParentCells.empty() ? i : cells.ParentCells[i]; };
  const EqualCells<Id>* equals[3] = { nullptr, &complex.EqualLines, &complex.EqualTriangles };
  vtkIdType count = 0;
  std::ostringstream message;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    // FindSimplicesOf gives the first of equal lines and triangles, the last of equal vertices.
    const Buffer<vtkIdType> simplices = FindSimplicesOf(complex, runs, dimension);
    for (const CellRun& run : runs)
    {
      const bool mayBeEqual = run.Dimension == dimension && (run.Equal || dimension == 0);
      for (vtkIdType i = 0; mayBeEqual && i < run.Count; ++i)
      {
        const vtkIdType own = run.FirstCell + i;
        const vtkIdType twin = dimension == 0 ? simplices[complex.VertexCells[run.First + i]]
                                              : simplices[equals[dimension]->Twins[run.First + i]];
        if (values.Singular[own] != values.Singular[twin] && count++ == 0)
        {
          message
            << "Cell array \"" << options.Singular->GetName() << "\": cells "
            << cellOf(std::min(own, twin)) << " and " << cellOf(std::max(own, twin))
            << " are equal, but only one of them is flagged; the filter takes both as singular";
        }
      }
    }
  }
  if (count > 0)
  {
    message << ". There are " << count << " such pairs; give equal cells the same flag.";
    warn(message.str());
  }
}

template <typename Id>
SolidSharpness FindSharpness(const FeatureValues& values, const SimplicialComplex<Id>& complex,
  const std::vector<CellRun>& runs)
{
  SolidSharpness sharpness;
  std::vector<double>* found[4] = { nullptr, &sharpness.Edges, &sharpness.Faces, nullptr };
  const vtkIdType sizes[4] = { 0, complex.NumberOfEdges, complex.NumberOfFaces, 0 };
  ForSimplices(complex, values.Sharpness.empty() ? std::vector<CellRun>() : runs,
    [&](vtkIdType place, int dimension, vtkIdType simplex, bool)
    {
      const double value = values.Sharpness[place];
      if (found[dimension] && value > 0.)
      {
        found[dimension]->resize(static_cast<std::size_t>(sizes[dimension]), 0.);
        double& own = (*found[dimension])[simplex];
        own = std::max(own, value);
      }
    });
  return sharpness;
}

SUBDIVISION_COMPILE_FUNCTION(WarnOfContradictions);
SUBDIVISION_COMPILE_FUNCTION(FindSharpness);

SUBDIVISION_COMPILE_FUNCTION(MakeStrataOptions);

}
