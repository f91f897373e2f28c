// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestAllocations.cxx
 * Small runs of every filter and source, in which each allocation of the library fails in turn, and
 * larger ones, in which some do: the filter reports an error with the bytes that it expected to
 * need, or gives the output that it gives otherwise, works afterwards, and keeps no memory.
 */
#include "FailingMemory.h"
#include "FuzzChecks.h"
#include "MultiDimensionalSubdivisionTools.h"

#include "Options.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkSphereSource.h"
#include "vtkSubdivisionModelSource.h"

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <regex>

using namespace multi_dimensional_subdivision_tools;

namespace
{

void AddArrays(vtkDataSet* data)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("Weights");
  vtkNew<vtkDoubleArray> directions;
  directions->SetName("Directions");
  directions->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<double>(i % 5));
    weights->InsertNextValue(i % 2 == 0 ? 1. : 0.);
    directions->InsertNextTuple3(0., 0., i == 1 ? 1. : 0.); // others are free
  }
  data->GetPointData()->SetScalars(values);
  data->GetPointData()->AddArray(weights);
  data->GetPointData()->AddArray(directions);
  vtkNew<vtkIntArray> materials;
  materials->SetName("Labels");
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    materials->InsertNextValue(static_cast<int>(i % 2));
  }
  data->GetCellData()->SetScalars(materials);
}

/// Which options of a filter are not the default.
enum class Settings
{
  Default,
  All,    ///< all switches are on
  Bounds, ///< GenerateErrorBounds alone, whose three more levels would take long with others
  Entry,  ///< one entry of one option
  Large   ///< the default, with more levels, and another input
};

constexpr const char* BoundsName = "GenerateErrorBounds";

struct Tried
{
  std::string Filter;
  Settings Set;
  std::string Property; ///< Entry
  std::string Entry;
};

/// For messages of GoogleTest, which has no other way to print it.
void PrintTo(const Tried& tried, std::ostream* stream)
{
  *stream << tried.Filter << " " << tried.Property << " " << tried.Entry;
}

bool Has(const std::string& name, const char* part)
{
  return name.find(part) != std::string::npos;
}

/// Some triangles and a curve.
vtkSmartPointer<vtkDataSet> MakeLittle()
{
  return MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 1., 1., 1. } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_LINE, { 2, 3 } } });
}

/// What a filter takes: solids with surfaces and curves, a surface, or an image of labels.
vtkSmartPointer<vtkDataSet> MakeInput(const Tried& tried)
{
  const std::string& filter = tried.Filter;
  const bool isLarge = tried.Set == Settings::Large;
  vtkSmartPointer<vtkDataSet> data;
  if (tried.Set == Settings::Bounds || Has(filter, "probe") ||
    (tried.Property == "OutputCells" && Has(filter, "multi")))
  {
    data = MakeLittle(); // solids would take minutes, and the probe makes ten thousands of lists
  }
  else if (Has(filter, "label"))
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    const int size = isLarge ? 6 : 3;
    image->SetDimensions(size, size, size);
    data = image;
  }
  else if (Has(filter, "surface") || tried.Property == "SurfaceScheme")
  {
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(isLarge ? 12 : 5);
    source->SetPhiResolution(isLarge ? 9 : 4);
    source->Update();
    data = source->GetOutput();
    data->GetPointData()->Initialize();
  }
  else if (Has(filter, "smoothness"))
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

bool IsLevel(const subdivide::Option& option)
{
  return std::strstr(option.Property, "Level") && option.Count == 1 &&
    option.Type == subdivide::Kind::Whole;
}

/// Whether a switch is on. Some need more: a function, a selection.
bool IsOn(const subdivide::Option& option, Settings set)
{
  const bool isOfBounds = std::strcmp(option.Property, BoundsName) == 0;
  const bool needsMore =
    std::strstr(option.Property, "ByFunction") || std::strstr(option.Property, "BySelection");
  return set == Settings::Bounds
    ? isOfBounds
    : set == Settings::All && option.Type == subdivide::Kind::Switch && !needsMore && !isOfBounds;
}

/// What an edit needs to do something: Translation, a falloff, and local frames.
bool IsEdit(const subdivide::Option& option, const Tried& tried)
{
  const std::string name = option.Property;
  return tried.Filter == "edit" &&
    (name == "Translation" || name == "FalloffRadius" || name == "Frame");
}

int FindEntry(const subdivide::Option& option, const std::string& name)
{
  for (const auto& entry : option.Entries)
  {
    if (name == entry.first)
    {
      return entry.second;
    }
  }
  return -1;
}

/// An array that the option takes.
const char* ChooseArray(const subdivide::Option& option)
{
  const std::string name = option.Property;
  return option.Association == vtkDataObject::CELL ? "Labels"
    : name == "InterpolationArray"                 ? "Weights"
    : name == "NormalArray"                        ? "Directions"
                                                   : "Values";
}

vtkSmartPointer<vtkAlgorithm> MakeFilter(
  const subdivide::Filter& what, const Tried& tried, vtkDataSet* input)
{
  const auto filter = vtkSmartPointer<vtkAlgorithm>::Take(what.New());
  for (const subdivide::Option& option : what.Options)
  {
    subdivide::Value value;
    value.Numbers.assign(option.Count, 1.);
    const bool isGrid = Has(tried.Filter, "sampler") && option.Port == 3; // it is an image
    if (option.Type == subdivide::Kind::Mesh && !isGrid)
    {
      filter->SetInputDataObject(option.Port, input);
    }
    if (tried.Set == Settings::All && option.Type == subdivide::Kind::Array)
    {
      filter->SetInputArrayToProcess(
        option.Index, option.Port, 0, option.Association, ChooseArray(option));
    }
    const bool isEntry = tried.Property == option.Property;
    if (isEntry)
    {
      value.Numbers = { static_cast<double>(FindEntry(option, tried.Entry)) };
    }
    else if (IsLevel(option) && tried.Set == Settings::Large)
    {
      value.Numbers = { 2. };
    }
    const bool isSize = std::strcmp(option.Property, "NumberOfSamples") == 0; // of an image
    value.Numbers = isSize ? std::vector<double>{ 12. } : value.Numbers;
    if (IsLevel(option) || IsOn(option, tried.Set) || isEntry || IsEdit(option, tried) || isSize)
    {
      option.Set(filter, value);
    }
  }
  if (what.HasInput)
  {
    filter->SetInputDataObject(input);
  }
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

/// Whether the entries of an option are tried one by one: those that choose other code.
bool ChoosesCode(const subdivide::Option& option)
{
  const std::string name = option.Property;
  return option.Type == subdivide::Kind::Choice &&
    (Has(name, "Scheme") || name == "Placement" || name == "OutputCells" || name == "FalloffAlong");
}

/// The runs of one filter.
class Trials
{
public:
  explicit Trials(const Tried& tried)
    : How(tried)
    , What(*std::find_if(subdivide::GetFilters().begin(), subdivide::GetFilters().end(),
        [&](const subdivide::Filter& filter) { return filter.Name == tried.Filter; }))
    , Input(MakeInput(tried))
  {
  }

  /// The first run, and the number of the calls for memory of the second one.
  void Count(long& calls);
  /// Lets one call fail; `failed`: whether there are so many.
  void Fail(long call, bool& failed);
  bool HasToldEstimate() const { return this->Estimated; }

private:
  vtkSmartPointer<vtkAlgorithm> Make()
  {
    const auto filter = MakeFilter(this->What, this->How, this->Input);
    this->Heard->Errors = {};
    this->Heard->Warnings = {};
    this->Heard->Inversions = {};
    this->Heard->Watch(filter);
    return filter;
  }
  /// Runs the filter, one of whose calls fails. Returns whether it did.
  static bool Run(vtkAlgorithm* filter, long call);
  void ExpectWhole(vtkDataObject* output) const;

  Tried How;
  const subdivide::Filter& What;
  vtkSmartPointer<vtkDataSet> Input;
  vtkNew<Messages> Heard;
  vtkSmartPointer<vtkDataObject> Expected;
  bool Estimated = false;
};

bool Trials::Run(vtkAlgorithm* filter, long call)
{
  vtkNew<Failing> failing;
  failing->Calls = call;
  filter->AddObserver(vtkCommand::StartEvent, failing);
  filter->AddObserver(vtkCommand::EndEvent, failing);
  filter->Update();
  filter->RemoveObserver(failing);
  return failing->HasFailed;
}

void Trials::ExpectWhole(vtkDataObject* output) const
{
  vtkDataObject* input = this->What.HasInput ? this->Input.Get() : nullptr;
  const char* fault = input ? fuzz::FindFault(input, output) : nullptr;
  ASSERT_EQ(fault, nullptr) << fault;
}

void Trials::Count(long& calls)
{
  const auto first = this->Make();
  first->Update();
  ASSERT_TRUE(this->Heard->Errors.empty()) << this->Heard->Errors[0];
  this->Expected = Copy(first);
  this->ExpectWhole(this->Expected);
  const auto second = this->Make();
  ASSERT_FALSE(Run(second, std::numeric_limits<long>::max()));
  calls = failing_memory::GetNumberOfCalls();
}

void Trials::Fail(long call, bool& failed)
{
  SCOPED_TRACE(call);
  const auto filter = this->Make();
  failed = Run(filter, call);
  std::vector<std::string>& errors = this->Heard->Errors;
  if (errors.empty())
  {
    ASSERT_TRUE(fuzz::AreEqual(filter->GetOutputDataObject(0), this->Expected));
  }
  else
  {
    ASSERT_NE(errors[0].find("memory"), std::string::npos) << errors[0];
    ASSERT_TRUE(std::regex_search(errors[0], std::regex("[0-9] ([kMGT]?B|bytes)"))) << errors[0];
    this->Estimated = this->Estimated || Has(errors[0], " were expected to be enough; ");
    this->ExpectWhole(filter->GetOutputDataObject(0));
  }
  errors.clear();
  filter->Modified();
  filter->Update();
  ASSERT_TRUE(errors.empty()) << errors[0];
  ASSERT_TRUE(fuzz::AreEqual(filter->GetOutputDataObject(0), this->Expected));
}

class Allocations : public testing::TestWithParam<Tried>
{
};

/// All filters and sources.
std::vector<Tried> ListTried()
{
  std::vector<Tried> all;
  for (const subdivide::Filter& filter : subdivide::GetFilters())
  {
    all.push_back({ filter.Name, Settings::Default, {}, {} });
    all.push_back({ filter.Name, Settings::All, {}, {} });
    all.push_back({ filter.Name, Settings::Large, {}, {} });
    for (const subdivide::Option& option : filter.Options)
    {
      if (std::strcmp(option.Property, BoundsName) == 0)
      {
        all.push_back({ filter.Name, Settings::Bounds, {}, {} });
      }
      for (std::size_t i = 0; ChoosesCode(option) && i < option.Entries.size(); ++i)
      {
        const char* entry = option.Entries[i].first;
        if (std::strcmp(entry, option.Default) != 0)
        {
          all.push_back({ filter.Name, Settings::Entry, option.Property, entry });
        }
      }
    }
  }
  return all;
}

/// Runs of so many calls or less have each call fail, longer ones each k-th, except those of the
/// default and of all switches, as long as the filter is not the probe or the sampler: it would
/// take an hour.
constexpr long Most = 100;

long GetStep(const Tried& tried, long calls)
{
  const bool isEach = (tried.Set == Settings::Default || tried.Set == Settings::All) &&
    !Has(tried.Filter, "probe") && !Has(tried.Filter, "sampler");
  return isEach ? 1 : std::max(1L, calls / Most);
}

/// The calls that fail: of large runs one at random in each twentieth, so that no part of a run is
/// left out by chance.
std::vector<long> ListCalls(const Tried& tried, long calls)
{
  std::vector<long> list;
  if (tried.Set != Settings::Large)
  {
    for (long call = 0; call < calls; call += GetStep(tried, calls))
    {
      list.push_back(call);
    }
    return list;
  }
  const char* given = std::getenv("SUBDIVISIONOBJECTS_RANDOM_SEED");
  const auto seed =
    given ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : std::random_device()();
  std::cout << "SUBDIVISIONOBJECTS_RANDOM_SEED=" << seed << "\n";
  std::mt19937 chance(seed);
  constexpr long parts = 20;
  for (long part = 0; part < parts && calls > 0; ++part)
  {
    const long first = part * calls / parts;
    const auto size = static_cast<unsigned long>((part + 1) * calls / parts - first);
    list.push_back(first + static_cast<long>(size > 0 ? chance() % size : 0));
  }
  return list;
}

TEST_P(Allocations, AFailureIsAnErrorAndTheFilterWorksAfterwards)
{
  const Tried& tried = GetParam();
  // One thread for those that are many: on a busy machine it takes a fraction of the time.
  const bool isOfThreads = tried.Set == Settings::Default || tried.Set == Settings::All;
  vtkSMPTools::Initialize(2);
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ 2, isOfThreads ? vtkSMPTools::GetBackend() : "Sequential", false },
    [&]
    {
      Trials trials(tried);
      long calls = 0;
      trials.Count(calls);
      ASSERT_FALSE(HasFatalFailure());
      bool failed = false;
      trials.Fail(0, failed); // what the first error makes once is there then
      const long before = failing_memory::CountPieces();
      long failures = 0;
      for (const long call : ListCalls(tried, calls))
      {
        trials.Fail(call, failed);
        ASSERT_FALSE(HasFatalFailure());
        failures += failed ? 1 : 0;
      }
      EXPECT_LE(failing_memory::CountPieces() - before, 2 + failures / 8); // some are made once
      std::cout << failures << " allocations failed of " << calls << "\n";
      const bool hasArraysOfVtkAlone = Has(tried.Filter, "cage") || Has(tried.Filter, "model");
      EXPECT_EQ(calls > 4, !hasArraysOfVtkAlone);
      const bool estimates = Has(tried.Filter, "surface") || Has(tried.Filter, "multi") ||
        Has(tried.Filter, "red-green");
      EXPECT_TRUE(trials.HasToldEstimate() || !estimates);
    });
}

std::string NameOf(const testing::TestParamInfo<Tried>& info)
{
  const Tried& tried = info.param;
  const char* set = tried.Set == Settings::All ? "_on"
    : tried.Set == Settings::Bounds            ? "_bounds"
    : tried.Set == Settings::Large             ? "_large"
                                               : "";
  std::string name =
    tried.Filter + set + (tried.Set == Settings::Entry ? "_" + tried.Property + tried.Entry : "");
  std::replace_if(name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Filters, Allocations, testing::ValuesIn(ListTried()), NameOf);

}
