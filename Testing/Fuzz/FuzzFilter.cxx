// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzFilter.h"

#include "FuzzChecks.h"
#include "FuzzMesh.h"

#include "vtkBox.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkLogger.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphere.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <vector>

namespace fuzz
{
namespace
{

using subdivide::Filter;
using subdivide::Kind;
using subdivide::Option;
using subdivide::Value;

class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
};
vtkStandardNewMacro(SilentWindow);

/// Numbers of cells for which memory and time are taken have to stay small, and those of boxes
/// along each axis more so.
double GetMost(const Option& option)
{
  const bool isOfCells =
    std::strstr(option.Property, "NumberOf") && std::strstr(option.Property, "Cells");
  return !isOfCells ? 1e300 : option.Count > 1 ? 8. : 20000.;
}

double ChooseReal(Bytes& bytes)
{
  constexpr double numbers[] = { 0., 1., 0.5, 0.1, 2., -1., 0.01, 10., 30., 90., 180., 1e-300,
    1e300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() };
  return bytes.OneOf(numbers);
}

double ChooseWhole(Bytes& bytes)
{
  constexpr double numbers[] = { 0., 1., 2., 3., 1., 2., 4., -1., 6., 10., 60., 1000.,
    2147483647. };
  return bytes.OneOf(numbers);
}

vtkSmartPointer<vtkImplicitFunction> ChooseFunction(Bytes& bytes)
{
  if (bytes.Choose(2) == 0)
  {
    vtkNew<vtkSphere> sphere;
    sphere->SetCenter(bytes.Number(), bytes.Number(), bytes.Number());
    sphere->SetRadius(ChooseReal(bytes));
    return sphere;
  }
  vtkNew<vtkBox> box;
  const double low = bytes.Number();
  box->SetBounds(low, low + 1., low, low + ChooseReal(bytes), low, low + 2.);
  return box;
}

vtkSmartPointer<vtkSelection> MakeSelection(Bytes& bytes)
{
  vtkNew<vtkIdTypeArray> ids;
  const int size = bytes.Choose(5);
  for (int i = 0; i < size; ++i)
  {
    ids->InsertNextValue(bytes.Chance(16) ? -1 : bytes.Choose(24));
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(bytes.Choose(vtkSelectionNode::NUM_CONTENT_TYPES));
  node->SetFieldType(bytes.Choose(3));
  node->SetSelectionList(ids);
  vtkNew<vtkSelection> selection;
  selection->AddNode(node);
  return selection;
}

vtkSmartPointer<vtkTable> MakeTable(Bytes& bytes)
{
  vtkNew<vtkTable> table;
  const int columns = bytes.Choose(4);
  for (int i = 0; i < columns; ++i)
  {
    vtkNew<vtkIdTypeArray> column;
    column->SetName(ChooseArray(bytes));
    for (int row = 0; row < 3; ++row)
    {
      column->InsertNextValue(bytes.Choose(6));
    }
    table->AddColumn(column);
  }
  return table;
}

Value ChooseValue(const Option& option, Bytes& bytes)
{
  Value value;
  switch (option.Type)
  {
    case Kind::Switch:
      value.Numbers.push_back(bytes.Choose(2));
      break;
    case Kind::Choice:
      value.Numbers.push_back(
        option.Entries[bytes.Choose(static_cast<int>(option.Entries.size()))].second);
      break;
    case Kind::Choices:
      for (const auto& entry : option.Entries)
      {
        if (bytes.Choose(2) == 0)
        {
          value.Numbers.push_back(entry.second);
        }
      }
      break;
    case Kind::Names:
      value.Names.emplace_back(ChooseArray(bytes));
      break;
    default:
      for (int i = 0; i < option.Count; ++i)
      {
        const double number = option.Type == Kind::Whole ? ChooseWhole(bytes) : ChooseReal(bytes);
        value.Numbers.push_back(number > GetMost(option) ? GetMost(option) : number);
      }
  }
  return value;
}

void SetOption(vtkAlgorithm* filter, const Option& option, Bytes& bytes)
{
  switch (option.Type)
  {
    case Kind::Array:
      filter->SetInputArrayToProcess(
        option.Index, option.Port, 0, bytes.Choose(2), ChooseArray(bytes));
      return;
    case Kind::Mesh:
      filter->SetInputDataObject(option.Port, MakeData(bytes));
      return;
    case Kind::Selection:
      filter->SetInputDataObject(option.Port, MakeSelection(bytes));
      return;
    case Kind::Table:
      filter->SetInputDataObject(option.Port, MakeTable(bytes));
      return;
    case Kind::Function:
    {
      Value value;
      const auto function = ChooseFunction(bytes);
      value.Function = function;
      option.Set(filter, value);
      return;
    }
    default:
      option.Set(filter, ChooseValue(option, bytes));
  }
}

}

const Filter& ChooseFilter(Bytes& bytes)
{
  static const std::vector<const Filter*> filters = []
  {
    std::vector<const Filter*> found;
    for (const Filter& filter : subdivide::GetFilters())
    {
      if (filter.HasInput)
      {
        found.push_back(&filter);
      }
    }
    return found;
  }();
  return *filters[bytes.Choose(static_cast<int>(filters.size()))];
}

vtkSmartPointer<vtkAlgorithm> MakeFilter(const Filter& what, Bytes& bytes)
{
  const auto filter = vtkSmartPointer<vtkAlgorithm>::Take(what.New());
  for (const Option& option : what.Options)
  {
    const bool isBounded = GetMost(option) < 1e300;
    if (isBounded || bytes.Chance(option.Type == Kind::Mesh ? 1 : 4))
    {
      SetOption(filter, option, bytes);
    }
  }
  return filter;
}

bool CarriesArrays(const Filter& what)
{
  constexpr const char* others[] = { "cage-around", // a box around the input
    "label-solid",                                  // has tetrahedra in place of voxels
    "limit-probe",                                  // has the points of another input
    "smoothness" };                                 // has vertices with what it computes
  return std::none_of(std::begin(others), std::end(others),
    [&](const char* name) { return std::strcmp(name, what.Name) == 0; });
}

bool CarriesCellArrays(const Filter& what)
{
  // Its cells are vertices, edges and triangles that cells of the input share.
  return CarriesArrays(what) && std::strcmp(what.Name, "simplicial-complex-topology") != 0;
}

bool IsChainWhole(const Filter& what, vtkDataObject* input, Bytes& bytes)
{
  const auto find = [&](const char* a, const char* b)
  {
    return std::find_if(what.Options.begin(), what.Options.end(), [=](const Option& option)
      { return std::strcmp(option.Property, a) == 0 || std::strcmp(option.Property, b) == 0; });
  };
  const auto levels = find("NumberOfLevels", "NumberOfLevels");
  const auto scheme = find("VolumeScheme", "Scheme");
  const auto seams = find("JoinSeams", "JoinSeams"); // with it filters in a row are others
  const bool isUniform = std::strcmp(what.Name, "multi-dimensional-subdivision") == 0 ||
    std::strcmp(what.Name, "surface-subdivision") == 0;
  if (!isUniform || !HasDoublesOnly(input))
  {
    return true;
  }
  const Value chosen = ChooseValue(*scheme, bytes);
  if (std::strcmp(scheme->Property, "VolumeScheme") == 0 &&
    chosen.Numbers.front() >= vtkMultiDimensionalSubdivision::HYBRID)
  {
    return true; // equal up to rounding, which TestHybridFeatures sees to
  }
  const auto run = [&](vtkDataObject* from, double wanted)
  {
    const auto filter = vtkSmartPointer<vtkAlgorithm>::Take(what.New());
    Value value;
    value.Numbers.push_back(wanted);
    levels->Set(filter, value);
    scheme->Set(filter, chosen);
    value.Numbers = { 0. };
    if (seams != what.Options.end())
    {
      seams->Set(filter, value);
    }
    const auto made = Run(filter, from);
    const auto copy = vtkSmartPointer<vtkDataObject>::Take(made->NewInstance());
    copy->DeepCopy(made);
    return copy;
  };
  return AreEqual(run(input, 2.), run(run(input, 1.), 1.));
}

vtkSmartPointer<vtkDataObject> Run(vtkAlgorithm* filter, vtkDataObject* input)
{
  filter->SetInputDataObject(0, input);
  filter->Update();
  return filter->GetOutputDataObject(0);
}

void Report(const char* fault, const char* filter)
{
  std::fprintf(stderr, "%s: %s\n", filter, fault);
  std::abort();
}

void Silence()
{
  vtkOutputWindow::SetInstance(vtkNew<SilentWindow>());
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

}
