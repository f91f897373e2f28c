// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Values/MergedValues.h"

#include "vtkDataArray.h"
#include "vtkVariant.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace subdivision
{

/// By how much values of two points differ: 0 if they are equal, infinity if there is no number.
double GetDifference(vtkAbstractArray* array, vtkIdType i, vtkIdType j)
{
  double most = 0.;
  auto* numbers = vtkDataArray::SafeDownCast(array);
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    if (!numbers)
    {
      const vtkIdType size = array->GetNumberOfComponents();
      const bool isSame =
        array->GetVariantValue(i * size + k) == array->GetVariantValue(j * size + k);
      most = isSame ? most : std::numeric_limits<double>::infinity();
      continue;
    }
    const double a = numbers->GetComponent(i, k);
    const double b = numbers->GetComponent(j, k);
    const bool isSame = a == b || (std::isnan(a) && std::isnan(b));
    const double difference = isSame ? 0. : std::abs(a - b);
    most =
      std::max(most, std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference);
  }
  return most;
}

namespace
{

std::string ListReplaced(const ReplacedValues& replaced, bool ofTexture)
{
  std::ostringstream text;
  for (const auto& [name, what] : replaced)
  {
    if (what.IsTexture == ofTexture)
    {
      text << (text.tellp() > 0 ? ", " : "") << '"' << name << "\" (" << what.Points
           << (what.Points == 1 ? " point" : " points");
      if (what.Most > 0.) // texts differ by no number
      {
        text << ", by up to " << what.Most;
      }
      text << ")";
    }
  }
  return text.str();
}

}

void DescribeReplaced(const ReplacedValues& replaced, MergedValues rule, bool ofSides,
  std::vector<std::string>& warnings)
{
  const std::string option = ofSides ? "JoinSides" : "MergePoints";
  const std::string set = ofSides ? "witch MergePoints on, and set" : "et";
  const std::string values = ListReplaced(replaced, false);
  const std::string texture = ListReplaced(replaced, true);
  if (!values.empty())
  {
    warnings.push_back(option + ": points that become one differ in " + values +
      ", and the first of them, by its id, gives the value. " +
      (rule == MergedValues::First
          ? "S" + set +
            " MergedValues to Average or Keep to have the mean, or a value on either side."
          : "Means and jumps exist for floating point numbers only; InterpolateIntegers takes "
            "means of integers, too."));
  }
  if (!texture.empty())
  {
    warnings.push_back(option + ": points that become one differ in the texture coordinates " +
      texture +
      ". The filter leaves them out, because cells at the seam would show a wrong part of the "
      "texture. Use JoinSeams of vtkSurfaceSubdivision instead, which the schemes Loop, "
      "ModifiedButterfly, CatmullClark and Linear have, or s" +
      set + " MergedValues to Keep.");
  }
}

void DescribeCollapsed(vtkIdType cells, vtkIdType first, std::vector<std::string>& warnings)
{
  if (cells > 0)
  {
    warnings.push_back("MergePoints joins points of one and the same cell in " +
      std::to_string(cells) + (cells == 1 ? " cell (cell " : " cells (the first is cell ") +
      std::to_string(first) +
      "), which collapse in part or whole. Lower MergeTolerance if they should stay.");
  }
}

void DescribeTorn(vtkIdType torn, std::vector<std::string>& warnings)
{
  if (torn > 0)
  {
    warnings.push_back("MergedValues: " + std::to_string(torn) +
      (torn == 1 ? " point touches" : " points touch") +
      " another of the same connected part, with another value, as at the ends of a slit. Values "
      "jump between parts only, so that one of both is taken there. Use vtkSurfaceSubdivision with "
      "Scheme = Loop or CatmullClark, which keeps such seams too.");
  }
}

}
