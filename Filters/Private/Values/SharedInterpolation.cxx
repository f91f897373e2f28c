// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Values/SharedInterpolation.h"

#include "Private/ArrayNames.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Partitions/SharedNumbers.h"
#include "Private/Partitions/SharedValues.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Values/MaterialColours.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointSet.h"

#include <memory>
#include <sstream>

namespace subdivision
{
namespace
{

/// The control points: points by their ids, the centres that cells bring by the ids of these cells.
SharedKeys MakeControlKeys(
  vtkPointSet* input, const SimplicesOfCells& cells, OtherPartitions& others)
{
  SharedKeys control;
  control.Width = 2;
  control.Own = FindOwnPoints(input, [&](vtkIdType cell) { return others.IsOwn(cell); });
  for (const vtkIdType id : others.GetPointIds())
  {
    control.Keys.insert(control.Keys.end(), { id, 0 });
  }
  if (cells.GetNumberOfCentres() > 0)
  {
    const SharedKeys centres = MakeCentreKeys(input->GetNumberOfPoints(), cells.GetView(),
      MakeKeysOfPieces(cells, others.GetCellIds(), others));
    for (size_t c = 0; c < centres.Own.size(); ++c)
    {
      control.Keys.insert(control.Keys.end(), { centres.Keys[2 * c], 1 + centres.Keys[2 * c + 1] });
      control.Own.push_back(centres.Own[c]);
    }
  }
  return control;
}

/// The rows of control points of all partitions in the order of the whole mesh, where centres come
/// after points.
WholeSystem FindWhole(const SharedKeys& control, OtherPartitions& others)
{
  SharedKeys ordered = control;
  ordered.Width = 3;
  ordered.Keys.clear();
  for (size_t i = 0; i < control.Own.size(); ++i)
  {
    const vtkIdType* key = control.Keys.data() + 2 * i;
    ordered.Keys.insert(ordered.Keys.end(), { key[1] > 0 ? 1 : 0, key[0], key[1] });
  }
  const SharedNumbers numbers = NumberTogether(ordered, others);
  const int first = others.FindFirst();
  WholeSystem whole(numbers.Totals[0]);
  whole.Numbers = numbers.First;
  whole.AreOwn = control.Own;
  whole.ToSolver = [first, &others](std::vector<double>& values)
  {
    others.BringTo(first, values);
    return others.GetPartition() == first;
  };
  whole.FromSolver = [first, &others](std::vector<double>& values)
  { others.TakeFrom(first, values); };
  return whole;
}

OtherPartitions* FindOthers(const RunOptions& options)
{
  return options.Interpolation.IsOn() ? options.Others : nullptr;
}

/// `others`: partitions that call this too; if there are any, nothing is counted.
void TellMisses(
  LimitMisses misses, OtherPartitions* others, const std::function<void(const std::string&)>& warn)
{
  if (others)
  {
    std::vector<double> most{ misses.Most };
    others->FindLargest(most);
    misses.Most = most[0];
  }
  if (misses.Most > 0.)
  {
    std::ostringstream text;
    text << "At " << (others ? "some" : std::to_string(misses.Count))
         << " points the values of a material are not those of the input, but differ by up to "
         << 100. * misses.Most
         << " % of the range: there the material touches others in edges or points only, or ends "
            "on a curve that goes on without it. With no level they are the same.";
    warn(text.str());
  }
}

}

bool AgreeWithOthers(bool own, const RunOptions& options)
{
  OtherPartitions* others = FindOthers(options);
  return others ? others->Agree(own) : own;
}

void ConnectToOthers(vtkPointSet* input, const SimplicesOfCells& cells, const RunOptions& options,
  InterpolationLimits& limits)
{
  limits.FindMemory = GetAvailableMemory;
  if (OtherPartitions* others = FindOthers(options))
  {
    const auto keys = std::make_shared<SharedKeys>(MakeControlKeys(input, cells, *others));
    const auto shared = std::make_shared<SharedValues>(*keys, *others);
    limits.TakeOthers = [shared](double* values, int components)
    { shared->TakeOthers(values, components); };
    limits.FindLargest = [others](std::vector<double>& values) { others->FindLargest(values); };
    limits.FindWhole = [keys, others] { return subdivision::FindWhole(*keys, *others); };
  }
}

bool HasWeights(
  const InterpolationOptions& options, const std::function<void(const std::string&)>& fail)
{
  for (vtkIdType i = 0; options.Chosen && i < options.Chosen->GetNumberOfTuples(); ++i)
  {
    const double weight = options.Chosen->GetComponent(i, 0);
    if (!(weight >= 0. && weight <= 1.))
    {
      fail("The weight " + std::to_string(weight) + " of point " + std::to_string(i) +
        " (array index 13) must be from 0 (free) to 1 (interpolated).");
      return false;
    }
  }
  return true;
}

void WarnOfLateInterpolation(const InterpolationOptions& options,
  const std::vector<vtkIdType>& before, const std::function<void(const std::string&)>& warn)
{
  if (options.IsOn() && before.empty())
  {
    warn("An earlier filter made the input, and did not interpolate: its control points are "
         "smoothed already. This filter ignores InterpolatePoints and InterpolateArrays. "
         "Switch them on in the first of the filters.");
  }
}

void TellOvershoot(
  const PointArrays& arrays, const RunOptions& options, vtkPointSet* output, bool isLimit)
{
  OtherPartitions* others = FindOthers(options);
  std::vector<char> counted;
  if (others && options.Interpolation.Arrays)
  {
    auto* blocks = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray(BlockName));
    counted = FindOwnPoints(
      output, [blocks](vtkIdType cell) { return blocks && blocks->GetValue(cell) != NoBlock; });
  }
  const bool hasColours = options.HasMaterialFields && options.Interpolation.Arrays;
  if (isLimit && hasColours)
  {
    TellMisses(arrays.FindMisses(counted), others, options.Warn);
  }
  std::vector<Overshoot> found = arrays.FindOvershoot(
    counted, hasColours ? FindColoursAtPoints(output) : std::vector<ColourMask>());
  if (others && !found.empty())
  {
    std::vector<double> most;
    for (const Overshoot& array : found)
    {
      most.push_back(array.Most);
    }
    others->FindLargest(most);
    for (size_t a = 0; a < found.size(); ++a)
    {
      found[a].Most = most[a];
    }
  }
  std::ostringstream text;
  for (const Overshoot& array : found)
  {
    if (array.Most > 0.)
    {
      text << (text.tellp() > 0 ? ", " : "");
      if (!others)
      {
        text << array.Count << " of " << array.NumberOfValues << " ";
      }
      text << "values of " << array.Name << " (by up to " << 100. * array.Most
           << " % of the range)";
    }
  }
  if (text.tellp() > 0)
  {
    options.Warn("Interpolated values exceed the range that the input has: " + text.str() +
      ". Take a smaller InterpolationWeight if that must not be.");
  }
}

}
