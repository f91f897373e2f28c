// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestAllocations.cxx
 * Small runs of every filter, in which each allocation of the library fails in turn: the filter
 * reports an error that speaks of memory, or gives the output that it gives otherwise, and works
 * afterwards. Sanitizers add that nothing leaks.
 */
#include "FailingMemory.h"
#include "FuzzMesh.h"
#include "MultiDimensionalSubdivisionTools.h"

#include "Options.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkSubdivisionModelSource.h"

#include <cstring>
#include <string>

using namespace multi_dimensional_subdivision_tools;

namespace
{

void AddArrays(vtkDataSet* data)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<double>(i % 5));
  }
  data->GetPointData()->SetScalars(values);
  vtkNew<vtkIntArray> materials;
  materials->SetName("Labels");
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    materials->InsertNextValue(static_cast<int>(i % 2));
  }
  data->GetCellData()->SetScalars(materials);
}

/// Which switches of a filter are on.
enum class Switches
{
  Default,
  All,
  Bounds ///< GenerateErrorBounds alone, whose three more levels would take long with others
};

constexpr const char* BoundsName = "GenerateErrorBounds";

/// What a filter takes: solids with surfaces and curves, a surface, or an image of labels.
vtkSmartPointer<vtkDataSet> MakeInput(const std::string& filter, Switches switches)
{
  vtkSmartPointer<vtkDataSet> data;
  if (switches == Switches::Bounds)
  {
    data = MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 1., 1., 1. } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_LINE, { 2, 3 } } });
  }
  else if (filter.find("label") != std::string::npos)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(3, 3, 3);
    data = image;
  }
  else if (filter.find("surface") != std::string::npos || filter.find("probe") != std::string::npos)
  {
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(5);
    source->SetPhiResolution(4);
    source->Update();
    data = source->GetOutput();
    data->GetPointData()->Initialize();
  }
  else if (filter.find("smoothness") != std::string::npos)
  {
    // Two tetrahedra and a curve: characteristic maps of more take minutes.
    data =
      MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. }, { 1., 1., 1. } },
        { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } }, { VTK_LINE, { 0, 4 } } });
  }
  else
  {
    vtkNew<vtkSubdivisionModelSource> source;
    source->SetModelToMixedDimensions();
    source->Update();
    data = source->GetOutput();
  }
  AddArrays(data);
  return data;
}

vtkSmartPointer<vtkAlgorithm> MakeFilter(
  const subdivide::Filter& what, Switches switches, vtkDataSet* input)
{
  const auto filter = vtkSmartPointer<vtkAlgorithm>::Take(what.New());
  for (const subdivide::Option& option : what.Options)
  {
    subdivide::Value one;
    one.Numbers.assign(option.Count, 1.);
    if (option.Type == subdivide::Kind::Mesh)
    {
      filter->SetInputDataObject(option.Port, input);
    }
    if (switches == Switches::All && option.Type == subdivide::Kind::Array)
    {
      const char* name = option.Association == vtkDataObject::CELL ? "Labels" : "Values";
      filter->SetInputArrayToProcess(option.Index, option.Port, 0, option.Association, name);
    }
    const bool isLevel = std::strstr(option.Property, "Level") && option.Count == 1 &&
      option.Type == subdivide::Kind::Whole;
    const bool needsMore = std::strstr(option.Property, "ByFunction") ||
      std::strstr(option.Property, "BySelection"); // a function, a selection
    const bool isOfBounds = std::strcmp(option.Property, BoundsName) == 0;
    const bool isOn = switches == Switches::Bounds ? isOfBounds
                                                   : switches == Switches::All &&
        option.Type == subdivide::Kind::Switch && !needsMore && !isOfBounds;
    if (isLevel || isOn)
    {
      option.Set(filter, one);
    }
  }
  filter->SetInputDataObject(input);
  return filter;
}

vtkSmartPointer<vtkDataObject> Copy(vtkAlgorithm* filter)
{
  vtkDataObject* output = filter->GetOutputDataObject(0);
  auto copy = vtkSmartPointer<vtkDataObject>::Take(output->NewInstance());
  copy->DeepCopy(output);
  return copy;
}

/// Lets an allocation fail in the filter's own work: not while the pipeline prepares it.
class Failing : public vtkCommand
{
public:
  static Failing* New() { return new Failing; }
  void Execute(vtkObject*, unsigned long event, void*) override
  {
    if (event == StartEvent)
    {
      failing_memory::FailAfter(this->Calls);
    }
    else
    {
      this->HasFailed = failing_memory::Stop();
    }
  }
  long Calls = 0;
  bool HasFailed = false;
};

struct Tried
{
  std::string Filter;
  Switches On;
};

class Allocations : public testing::TestWithParam<Tried>
{
};

/// All but the probe, which makes ten thousands of small lists in a run.
std::vector<Tried> ListFilters()
{
  std::vector<Tried> all;
  for (const subdivide::Filter& filter : subdivide::GetFilters())
  {
    if (filter.HasInput && std::string(filter.Name) != "limit-probe")
    {
      all.push_back({ filter.Name, Switches::Default });
      all.push_back({ filter.Name, Switches::All });
      if (std::any_of(filter.Options.begin(), filter.Options.end(),
            [](const subdivide::Option& option)
            { return std::strcmp(option.Property, BoundsName) == 0; }))
      {
        all.push_back({ filter.Name, Switches::Bounds });
      }
    }
  }
  return all;
}

TEST_P(Allocations, AFailureIsAnErrorAndTheFilterWorksAfterwards)
{
  vtkSMPTools::Initialize(2);
  const auto& filters = subdivide::GetFilters();
  const auto what = std::find_if(filters.begin(), filters.end(),
    [&](const subdivide::Filter& filter) { return filter.Name == GetParam().Filter; });
  const auto input = MakeInput(GetParam().Filter, GetParam().On);
  vtkNew<Messages> messages;
  const auto reference = MakeFilter(*what, GetParam().On, input);
  messages->Watch(reference);
  reference->Update();
  ASSERT_TRUE(messages->Errors.empty()) << messages->Errors[0];
  const auto expected = Copy(reference);
  ASSERT_EQ(fuzz::FindFault(input, expected), nullptr);

  long calls = 0;
  for (bool failed = true; failed; ++calls)
  {
    SCOPED_TRACE(calls);
    const auto filter = MakeFilter(*what, GetParam().On, input);
    messages->Errors.clear();
    messages->Watch(filter);
    vtkNew<Failing> failing;
    failing->Calls = calls;
    filter->AddObserver(vtkCommand::StartEvent, failing);
    filter->AddObserver(vtkCommand::EndEvent, failing);
    filter->Update();
    failed = failing->HasFailed;
    filter->RemoveObserver(failing);
    if (messages->Errors.empty())
    {
      ASSERT_TRUE(fuzz::AreEqual(filter->GetOutputDataObject(0), expected));
    }
    else
    {
      ASSERT_NE(messages->Errors[0].find("memory"), std::string::npos) << messages->Errors[0];
      ASSERT_EQ(fuzz::FindFault(input, filter->GetOutputDataObject(0)), nullptr);
    }
    messages->Errors.clear();
    filter->Modified();
    filter->Update();
    ASSERT_TRUE(messages->Errors.empty()) << messages->Errors[0];
    ASSERT_TRUE(fuzz::AreEqual(filter->GetOutputDataObject(0), expected));
  }
  const bool hasOwnMemory =
    GetParam().Filter.find("cage") == std::string::npos; // else VTK's arrays
  EXPECT_EQ(calls > 5, hasOwnMemory);
  std::cout << calls - 1 << " allocations failed\n";
}

std::string NameOf(const testing::TestParamInfo<Tried>& info)
{
  std::string name = info.param.Filter +
    (info.param.On == Switches::All         ? "_on"
        : info.param.On == Switches::Bounds ? "_bounds"
                                            : "");
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Filters, Allocations, testing::ValuesIn(ListFilters()), NameOf);

}
