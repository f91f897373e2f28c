// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridStamp.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Control/Stamp.h"
#include "Private/Run/StampFields.h"
#include "Private/Uniform/HybridMarks.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

/// The field arrays of derived parts by their number of corners, and of their sharpness.
constexpr const char* PartNames[4] = { SingularNames[0], SingularNames[1], SingularNames[2],
  "SubdivisionSingularQuads" };
constexpr const char* PartSharpnessNames[4] = { "SubdivisionVertexSharpness", SharpnessNames[1],
  SharpnessNames[2], "SubdivisionQuadSharpness" };

/// The cells that a cell becomes, which follow each other.
class Descendants
{
public:
  explicit Descendants(int levels)
    : Levels(levels)
  {
  }
  vtkIdType Count(CellShape shape) const { return Count(shape, this->Levels); }
  /// Which of them has a corner of the cell.
  vtkIdType FindAt(CellShape shape, int corner) const
  {
    vtkIdType place = 0;
    for (int left = this->Levels - 1; left >= 0; --left)
    {
      for (const CellChild& child : GetCellTable(shape).Children)
      {
        const auto* end = child.Points.data() + GetCellTable(child.Shape).Corners;
        const auto* found = std::find(child.Points.data(), end, corner);
        if (found != end)
        {
          shape = child.Shape;
          corner = static_cast<int>(found - child.Points.data());
          break;
        }
        place += Count(child.Shape, left);
      }
    }
    return place;
  }

private:
  static vtkIdType Count(CellShape shape, int levels)
  {
    std::array<double, NumberOfShapes> counts{};
    counts[static_cast<std::size_t>(shape)] = 1.;
    for (int level = 0; level < levels; ++level)
    {
      counts = CountChildren(counts);
    }
    return static_cast<vtkIdType>(std::accumulate(counts.begin(), counts.end(), 0.));
  }

  const int Levels;
};

/// Finds the control mesh, and the first descendant of each of its cells. Returns false if the
/// cells are no descendants.
bool FindControl(const HybridCells& cells, int levels, vtkIdType points, HybridCells& control,
  std::vector<vtkIdType>& firsts)
{
  const Descendants descendants(levels);
  std::vector<vtkIdType> offsets{ 0 };
  for (const CellShape shape : InTurn(cells.Shapes))
  {
    offsets.push_back(offsets.back() + GetCellTable(shape).Corners);
  }
  const auto size = static_cast<vtkIdType>(cells.Shapes.size());
  control = HybridCells();
  control.NumberOfPoints = points;
  for (vtkIdType first = 0; first < size;)
  {
    BetweenLoops::Act();
    // The first child of a cell has its type.
    const CellShape shape = cells.Shapes[static_cast<std::size_t>(first)];
    const vtkIdType count = descendants.Count(shape);
    if (count > size - first)
    {
      return false;
    }
    for (int corner = 0; corner < GetCellTable(shape).Corners; ++corner)
    {
      const auto cell = static_cast<std::size_t>(first + descendants.FindAt(shape, corner));
      const vtkIdType* begin = cells.Corners.data() + offsets[cell];
      const vtkIdType* end = cells.Corners.data() + offsets[cell + 1];
      const auto isOld = [points](vtkIdType point) { return point < points; };
      const vtkIdType* old = std::find_if(begin, end, isOld);
      if (std::count_if(begin, end, isOld) != 1)
      {
        return false;
      }
      control.Corners.push_back(*old);
    }
    control.Shapes.push_back(shape);
    control.Sources.push_back(cells.Sources[static_cast<std::size_t>(first)]);
    firsts.push_back(first);
    first += count;
  }
  firsts.push_back(size);
  return true;
}

/// Whether all descendants of a cell have the values of its first one.
template <typename Value>
bool AreEqual(const std::vector<vtkIdType>& firsts, const std::vector<Value>& values)
{
  for (std::size_t c = 0; !values.empty() && c + 1 < firsts.size(); ++c)
  {
    const auto begin = values.begin() + firsts[c];
    if (std::any_of(begin, values.begin() + firsts[c + 1],
          [begin](const Value& value) { return value != *begin; }))
    {
      return false;
    }
  }
  return true;
}

bool HaveEqualValues(
  const HybridCells& cells, const std::vector<vtkIdType>& firsts, const FeatureOptions& features)
{
  SimplicesOfCells simplices;
  for (const CellShape shape : InTurn(cells.Shapes))
  {
    simplices.Simplices.Dimensions.push_back(
      static_cast<unsigned char>(GetCellTable(shape).Dimension));
  }
  simplices.ParentCells = cells.Sources;
  const FeatureValues values = ReadFeatureValues(features, simplices, [](const std::string&) {});
  return AreEqual(firsts, values.Singular) && AreEqual(firsts, values.Material) &&
    AreEqual(firsts, values.Part) && AreEqual(firsts, values.Rules) &&
    AreEqual(firsts, values.Sharpness);
}

bool HasSelection(vtkDataArray* selected)
{
  bool isFound = false;
  for (const vtkIdType cell : InTurn(selected ? selected->GetNumberOfTuples() : vtkIdType(0)))
  {
    isFound = isFound || selected->GetComponent(cell, 0) != 0.;
  }
  return isFound;
}

std::vector<DerivedPart> ReadParts(vtkFieldData* data)
{
  std::vector<DerivedPart> parts;
  for (int size = 1; size <= 4; ++size)
  {
    const std::vector<vtkIdType> ids = ReadFieldIds(PartNames[size - 1], data, size);
    const std::vector<double> sharpness = ReadFieldValues(PartSharpnessNames[size - 1], data);
    for (const std::size_t i : InTurn(ids.size() / static_cast<std::size_t>(size)))
    {
      const auto first = ids.begin() + static_cast<std::ptrdiff_t>(i) * size;
      const double left =
        i < sharpness.size() ? sharpness[i] : std::numeric_limits<double>::infinity();
      parts.push_back({ std::min(size, 3) - 1, { first, first + size }, left });
    }
  }
  return parts;
}

}

HybridStamp ReadHybridStamp(
  vtkPointSet* input, const HybridCells& cells, const FeatureOptions& features)
{
  HybridStamp stamp;
  Stamp numbers;
  std::vector<vtkIdType> firsts;
  const bool isTrue = ReadStamp(input, StampScheme::Hybrid, numbers) && numbers.Levels > 0 &&
    cells.Warnings.empty() && !HasSelection(features.Marks.SelectedCells) &&
    FindControl(cells, numbers.Levels, numbers.NumberOfControlPoints, stamp.Control, firsts) &&
    HaveEqualValues(cells, firsts, features);
  if (!isTrue)
  {
    return {};
  }
  stamp.MadeLevels = numbers.Levels;
  stamp.NumberOfControlPoints = numbers.NumberOfControlPoints;
  stamp.Derived = ReadParts(input->GetFieldData());
  stamp.GlobalIds = ReadFieldIds(GlobalIdsName, input->GetFieldData());
  return stamp;
}

namespace
{

/// Whether cells are the same; an octahedron may begin with any of its corners.
template <typename Id>
bool AreSameCells(const CellList<Id>& a, const CellList<Id>& b)
{
  if (a.NumberOfPoints != b.NumberOfPoints || a.Corners.size() != b.Corners.size() ||
    !std::equal(a.Shapes.begin(), a.Shapes.end(), b.Shapes.begin(), b.Shapes.end()))
  {
    return false;
  }
  for (const vtkIdType c : InTurn(a.GetNumberOfCells()))
  {
    const Id* own = a.GetCorners(c);
    const Id* end = a.GetCorners(c + 1);
    if (a.Shapes[c] == CellShape::Octahedron ? !std::is_permutation(own, end, b.GetCorners(c))
                                             : !std::equal(own, end, b.GetCorners(c)))
    {
      return false;
    }
  }
  return true;
}

}

template <typename Id>
bool RestoreHybridLevel(const HybridStamp& stamp, const CellList<Id>& cells, vtkPointSet* input,
  const UniformOptions& options, HybridLevel<Id>& level)
{
  const FeatureOptions& features = options.Features;
  HybridLevel<Id> made;
  made.Complex = BuildCellComplex(ListCells<Id>(stamp.Control));
  HybridChoices choices;
  std::vector<std::string> warnings;
  if (!ReadHybridChoices(
        made.Complex, stamp.Control.Sources, input, features, Coordinates(nullptr),
        stamp.MadeLevels, stamp.Derived,
        [&warnings](const std::string& warning) { warnings.push_back(warning); }, choices))
  {
    return false;
  }
  DecideStrata(made, choices);
  for (int step = 0; step < stamp.MadeLevels; ++step)
  {
    made = RefineHybrid(made, HybridRules::Smooth);
  }
  // Marks of a finer level make it a control mesh.
  bool isMarked = false;
  ForHybridMarks<Id>(
    made.Complex, input, features.Marks, [](const std::string&) {},
    [&isMarked](int, Id, double) { isMarked = true; });
  if (isMarked || !AreSameCells(made.Complex.Cells, cells))
  {
    return false;
  }
  Tell(warnings, options);
  level = std::move(made);
  return true;
}

void WriteHybridStamp(
  const HybridStamp& stamp, int levels, bool isPart, vtkUnstructuredGrid* output)
{
  vtkFieldData* data = output->GetFieldData();
  for (int a = data->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    if (BelongsToStamp(data->GetAbstractArray(a)->GetName()))
    {
      data->RemoveArray(a);
    }
  }
  Stamp numbers;
  numbers.Scheme = StampScheme::Hybrid;
  if (isPart)
  {
    numbers.NumberOfPoints = UnknownNumber;
    numbers.NumberOfCells = UnknownNumber;
    WriteStamp(numbers, output);
  }
  if (isPart || levels == 0)
  {
    return;
  }
  numbers.Levels = stamp.MadeLevels + levels;
  numbers.NumberOfControlPoints = stamp.NumberOfControlPoints;
  WriteStamp(numbers, output);
  StampedIds others;
  others.Global = stamp.GlobalIds;
  WriteStampedIds(others, output);
  std::vector<vtkIdType> ids[4];
  std::vector<double> sharpness[4];
  for (const DerivedPart& part : InTurn(stamp.Derived))
  {
    if (part.Sharpness > levels)
    {
      const std::size_t kind = part.Corners.size() - 1;
      ids[kind].insert(ids[kind].end(), part.Corners.begin(), part.Corners.end());
      sharpness[kind].push_back(part.Sharpness - levels);
    }
  }
  for (int kind = 0; kind < 4; ++kind)
  {
    if (std::all_of(sharpness[kind].begin(), sharpness[kind].end(),
          [](double left) { return std::isinf(left); }))
    {
      sharpness[kind].clear();
    }
    WriteField<vtkIdTypeArray>(PartNames[kind], ids[kind], data, kind + 1);
    WriteField<vtkDoubleArray>(PartSharpnessNames[kind], sharpness[kind], data);
  }
}

SUBDIVISION_COMPILE_FUNCTION(RestoreHybridLevel);

}
