// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"
#include "Names.h"

#include "vtkAlgorithm.h"
#include "vtkBox.h"
#include "vtkCylinder.h"
#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"
#include "vtkSphere.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace subdivide
{
namespace
{

std::string Named(const Option& option)
{
  return std::string("--") + option.Name;
}

double ToNumber(const Option& option, const std::string& text)
{
  std::istringstream stream(text);
  double number = 0.;
  std::string rest;
  const bool isWhole = option.Type == Kind::Whole || option.Type == Kind::Selection;
  if (!(stream >> number) || (stream >> rest) || (isWhole && number != std::floor(number)))
  {
    throw UsageError(Named(option) + " takes " + (isWhole ? "whole numbers" : "numbers") +
      ", not \"" + text + "\"");
  }
  return number;
}

std::string ToText(double number)
{
  std::ostringstream text;
  text << std::setprecision(16) << number;
  return text.str();
}

/// A number that the option does not take, and the range that it has.
UsageError OutOfRange(const Option& option, double number, double lowest, double highest)
{
  const bool hasLowest = lowest > -option.Limit;
  const bool hasHighest = highest < option.Limit;
  const std::string range = hasLowest && !hasHighest ? ToText(lowest) + " or more"
    : hasHighest && !hasLowest                       ? ToText(highest) + " or less"
                               : "from " + ToText(lowest) + " to " + ToText(highest);
  return UsageError(Named(option) + " takes " +
    (option.Type == Kind::Real ? "numbers" : "whole numbers") + " " + range + ", not " +
    ToText(number) + "; the nearest is " + ToText(number < lowest ? lowest : highest));
}

/// What the filter keeps where each of the numbers is this one.
std::vector<double> GetKept(vtkAlgorithm* filter, const Option& option, double number)
{
  Value value;
  value.Numbers.assign(option.Count, number);
  option.Set(filter, value);
  for (int i = 0; i < option.Count; ++i)
  {
    value.Numbers[i] = option.Get(filter, i);
  }
  return value.Numbers;
}

/// Sets numbers that the type and the filter can hold.
void SetNumbers(vtkAlgorithm* filter, const Option& option, const std::vector<double>& numbers)
{
  const auto other = vtkSmartPointer<vtkAlgorithm>::Take(filter->NewInstance());
  const std::vector<double> lowest = GetKept(other, option, -option.Limit);
  const std::vector<double> highest = GetKept(other, option, option.Limit);
  for (int i = 0; i < option.Count; ++i)
  {
    if (!(numbers[i] >= lowest[i] && numbers[i] <= highest[i]))
    {
      throw OutOfRange(option, numbers[i], lowest[i], highest[i]);
    }
  }
  Value value;
  value.Numbers = numbers;
  option.Set(filter, value);
}

double ToEntry(const Option& option, const std::string& text)
{
  std::vector<std::string> names;
  auto entries = option.Entries;
  entries.insert(entries.end(), option.Spellings.begin(), option.Spellings.end());
  for (const auto& entry : entries)
  {
    if (Plain(entry.first) == Plain(text) || std::to_string(entry.second) == text)
    {
      return entry.second;
    }
    names.emplace_back(entry.first);
  }
  throw UsageError(Named(option) + " takes " + DescribeValue(option) + ", not \"" + text + "\"" +
    DidYouMean(text, names));
}

/// "sphere=1,2,3,0.5" is a kind and numbers; without "=" there are no numbers.
std::string SplitKind(const Option& option, const std::string& text, std::vector<double>& numbers)
{
  const std::size_t at = text.find('=');
  if (at != std::string::npos)
  {
    for (const std::string& part : SplitList(text.substr(at + 1)))
    {
      numbers.push_back(ToNumber(option, part));
    }
  }
  return Plain(text.substr(0, at));
}

vtkSmartPointer<vtkImplicitFunction> ToFunction(const Option& option, const std::string& text)
{
  std::vector<double> numbers;
  const std::string kind = SplitKind(option, text, numbers);
  const double* n = numbers.data();
  const bool isRound = kind == "sphere" || kind == "cylinder";
  if (isRound && !numbers.empty() && numbers.back() <= 0.)
  {
    throw UsageError(Named(option) + " takes a radius above 0, not " + ToText(numbers.back()));
  }
  if ((kind == "plane" || kind == "cylinder") && numbers.size() >= 6 && n[3] == 0. && n[4] == 0. &&
    n[5] == 0.)
  {
    throw UsageError(Named(option) + " takes a direction that is not zero");
  }
  if (kind == "sphere" && numbers.size() == 4)
  {
    vtkNew<vtkSphere> sphere;
    sphere->SetCenter(n[0], n[1], n[2]);
    sphere->SetRadius(n[3]);
    return sphere;
  }
  if (kind == "box" && numbers.size() == 6 && n[0] <= n[1] && n[2] <= n[3] && n[4] <= n[5])
  {
    vtkNew<vtkBox> box;
    box->SetBounds(n);
    return box;
  }
  if (kind == "plane" && numbers.size() == 6)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(n[0], n[1], n[2]);
    plane->SetNormal(n[3], n[4], n[5]);
    return plane;
  }
  if (kind == "cylinder" && numbers.size() == 7)
  {
    vtkNew<vtkCylinder> cylinder;
    cylinder->SetCenter(n[0], n[1], n[2]);
    cylinder->SetAxis(n[3], n[4], n[5]);
    cylinder->SetRadius(n[6]);
    return cylinder;
  }
  throw UsageError(Named(option) + " takes " + DescribeValue(option) + ", not \"" + text + "\"");
}

vtkSmartPointer<vtkSelection> ToSelection(const Option& option, const std::string& text)
{
  std::vector<double> numbers;
  const std::string kind = SplitKind(option, text, numbers);
  if ((kind != "points" && kind != "cells") || numbers.empty())
  {
    throw UsageError(Named(option) + " takes " + DescribeValue(option) + ", not \"" + text + "\"");
  }
  vtkNew<vtkIdTypeArray> ids;
  for (double id : numbers)
  {
    if (id < 0. || id > option.Limit)
    {
      throw OutOfRange(option, id, 0., option.Limit);
    }
    ids->InsertNextValue(static_cast<vtkIdType>(id));
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(kind == "points" ? vtkSelectionNode::POINT : vtkSelectionNode::CELL);
  node->SetSelectionList(ids);
  vtkNew<vtkSelection> selection;
  selection->AddNode(node);
  return selection;
}

Value ToNumbers(const Option& option, const std::string& text)
{
  Value value;
  for (const std::string& part : SplitList(text))
  {
    value.Numbers.push_back(ToNumber(option, part));
  }
  if (static_cast<int>(value.Numbers.size()) != option.Count)
  {
    throw UsageError(Named(option) + " takes " + std::to_string(option.Count) +
      " number(s) with commas between them, not \"" + text + "\"");
  }
  return value;
}

Value ToValue(const Option& option, const std::string& text)
{
  Value value;
  switch (option.Type)
  {
    case Kind::Switch:
      value.Numbers.push_back(IsOn(Named(option), text) ? 1. : 0.);
      break;
    case Kind::Choice:
      value.Numbers.push_back(ToEntry(option, text));
      break;
    case Kind::Choices:
      for (const std::string& part :
        text.empty() ? std::vector<std::string>{ "" } : SplitList(text))
      {
        value.Numbers.push_back(ToEntry(option, part));
      }
      break;
    case Kind::Names:
      value.Names = SplitList(text);
      if (std::count(value.Names.begin(), value.Names.end(), "") > 0)
      {
        throw UsageError(
          Named(option) + " takes names with commas between them, not \"" + text + "\"");
      }
      break;
    default:
      value = ToNumbers(option, text);
  }
  return value;
}

}

bool IsOn(const std::string& name, const std::string& text)
{
  const std::string plain = Plain(text);
  if (plain == "on" || plain == "1" || plain == "true" || plain == "yes")
  {
    return true;
  }
  if (plain == "off" || plain == "0" || plain == "false" || plain == "no")
  {
    return false;
  }
  throw UsageError(name + " takes on or off, not \"" + text + "\"");
}

void ApplySetting(vtkAlgorithm* filter, const Option& option, const std::string& text)
{
  if (option.Type == Kind::Array)
  {
    filter->SetInputArrayToProcess(option.Index, option.Port, 0, option.Association, text.c_str());
    return;
  }
  if (option.Type == Kind::Selection)
  {
    filter->SetInputDataObject(option.Port, ToSelection(option, text));
    return;
  }
  if (option.Type == Kind::Function)
  {
    const auto function = ToFunction(option, text);
    Value value;
    value.Function = function;
    option.Set(filter, value);
    return;
  }
  const Value value = ToValue(option, text);
  if (option.Type == Kind::Whole || option.Type == Kind::Real)
  {
    SetNumbers(filter, option, value.Numbers);
  }
  else
  {
    option.Set(filter, value);
    if (option.Get && option.Get(filter, 0) != value.Numbers[0])
    {
      throw UsageError(Named(option) + " cannot be " + text + " in this filter");
    }
  }
}

std::string DescribeValue(const Option& option)
{
  std::string text;
  switch (option.Type)
  {
    case Kind::Choice:
    case Kind::Choices:
      for (const auto& entry : option.Entries)
      {
        std::string name = entry.first;
        for (std::size_t at = 0; (at = name.find(' ', at)) != std::string::npos;)
        {
          name[at] = '-';
        }
        text += std::string(text.empty() ? "" : option.Type == Kind::Choice ? "|" : ",") + name;
      }
      return text;
    case Kind::Names:
      return "NAME,...";
    case Kind::Array:
      return "NAME";
    case Kind::Function:
      return "sphere=X,Y,Z,RADIUS|box=X,X,Y,Y,Z,Z|plane=POINT,NORMAL|cylinder=POINT,AXIS,RADIUS";
    case Kind::Mesh:
    case Kind::Table:
      return "FILE";
    case Kind::Selection:
      return "points=ID,...|cells=ID,...";
    case Kind::Whole:
    case Kind::Real:
      for (int i = 0; i < option.Count; ++i)
      {
        text += i == 0 ? "N" : ",N";
      }
      return text;
    default:
      return text;
  }
}

}
