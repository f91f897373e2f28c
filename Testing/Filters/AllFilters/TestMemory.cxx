// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMemory.cxx
 * What is larger than the memory is refused before memory is taken for it, with a message that says
 * what helps; refinement ends where the memory ends.
 */
#include "AdaptiveFilterTools.h"
#include "LabelTools.h"
#include "RedGreenRefinementTools.h"

#include "Private/Run/SizeChecks.h"

#include "vtkMultiDimensionalSubdivision.h"
#include "vtkSubdivisionSmoothness.h"
#include "vtkSurfaceSubdivision.h"

#if defined(__unix__)
#include <sys/resource.h>
#endif

using multi_dimensional_subdivision_tools::Messages;

namespace
{

/// The most memory that this process has had, in bytes; 0 where the system does not tell.
double GetPeakBytes()
{
#if defined(__linux__)
  rusage usage;
  return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024. * static_cast<double>(usage.ru_maxrss) : 0.;
#else
  return 0.;
#endif
}

vtkSmartPointer<vtkPolyData> MakeSheet(int size, bool triangles)
{
  return surfacetools::MakeInput(
    surfacetools::MakeSheet(size, size, triangles, { 1., 0., 0. }, { 0., 1., 0. }));
}

/// Of the memory of this machine so many bytes; what other processes do makes it a bit more or
/// less.
subdivision::MemoryShare TakeShare(double bytes)
{
  return subdivision::MemoryShare(static_cast<int>(subdivision::GetAvailableMemory() / bytes));
}

/// The first number of levels whose cells alone need more than twice the memory that there is; -1
/// if the largest that filters take is too few.
int FindTooManyLevels(double cells, double bytesPerCell, double children)
{
  for (int levels = 1; levels <= 20; ++levels)
  {
    if (cells * bytesPerCell * std::pow(children, levels) > 2. * subdivision::GetAvailableMemory())
    {
      return levels;
    }
  }
  return -1;
}

/// Expects that the filter, with so many levels, fails at once.
template <typename Filter>
void ExpectRefused(Filter* filter, int levels, vtkDataObject* input)
{
  if (levels < 0)
  {
    GTEST_SKIP() << "this machine has memory for the most levels";
  }
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->SetNumberOfLevels(levels);
  filter->SetMaximumNumberOfCells(VTK_ID_MAX);
  const double before = GetPeakBytes();
  filter->Update();
  EXPECT_LT(GetPeakBytes() - before, 1e8);
  ASSERT_FALSE(messages->Errors.empty());
  const std::string& error = messages->Errors[0];
  const std::string begin = "NumberOfLevels = " + std::to_string(levels) + " would make ";
  EXPECT_NE(error.find(begin), std::string::npos) << error;
  EXPECT_NE(error.find("B are available"), std::string::npos) << error;
  EXPECT_NE(
    error.find(" are available. Use fewer levels, or a part of the input."), std::string::npos)
    << error;
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

using Setup = std::function<void(vtkMultiDimensionalSubdivision*)>;

void ExpectSolidsRefused(const Setup& setup)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  setup(filter);
  const auto box = red_green_refinement_tools::MakeBox(2);
  const auto cells = static_cast<double>(box->GetNumberOfCells());
  ExpectRefused(filter.Get(), FindTooManyLevels(cells, 41., 8.), box);
}

void ExpectSurfaceRefused(int scheme, bool triangles, double children)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetScheme(scheme);
  const auto sheet = MakeSheet(150, triangles);
  const auto cells = static_cast<double>(sheet->GetNumberOfCells());
  ExpectRefused(filter.Get(), FindTooManyLevels(cells, 32., children), sheet);
}

template <typename Filter>
void RefineToLevel(Filter* filter, int level)
{
  filter->RefineByWantedLevelOn();
  filter->SetMaximumLevel(level);
  filter->SetMaximumNumberOfCells(VTK_ID_MAX);
}

/// Expects that local refinement ends early where memory ends, and fails where there is none.
template <typename RefineIt>
void ExpectToEndWithLittleMemory(vtkDataSet& input, const RefineIt& refine)
{
  {
    const auto share = TakeShare(4e6);
    vtkNew<Messages> messages;
    const auto output = refine(messages);
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(
      messages->CountWarnings("for which there is not enough memory. Use weaker criteria"), 1);
    EXPECT_GT(output->GetNumberOfCells(), input.GetNumberOfCells());
    EXPECT_LT(output->GetNumberOfCells(), 20000); // 41 bytes for each are told, and more is needed
  }
  const auto share = TakeShare(1e4);
  vtkNew<Messages> messages;
  EXPECT_EQ(refine(messages)->GetNumberOfCells(), 0);
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(
    messages->Errors[0].find("There is not enough memory for the " +
      std::to_string(input.GetNumberOfCells()) + " cells of the input. Use a part of the input."),
    std::string::npos)
    << messages->Errors[0];
}

}

TEST(Memory, RefusesSolids)
{
  ExpectSolidsRefused([](vtkMultiDimensionalSubdivision*) {});
}

TEST(Memory, RefusesTetrahedraAndOctahedra)
{
  ExpectSolidsRefused(
    [](vtkMultiDimensionalSubdivision* filter) { filter->SetVolumeSchemeToTetOct(); });
}

TEST(Memory, RefusesLimits)
{
  ExpectSolidsRefused([](vtkMultiDimensionalSubdivision* filter) { filter->ProjectToLimitOn(); });
}

TEST(Memory, RefusesCellsThatKeepTheirTypes)
{
  ExpectSolidsRefused(
    [](vtkMultiDimensionalSubdivision* filter)
    {
      filter->SetVolumeSchemeToLinear();
      filter->KeepCellTypesOn();
    });
}

TEST(Memory, RefusesSurfacesOfAllSchemes)
{
  using Filter = vtkSurfaceSubdivision;
  for (const int scheme : { Filter::LOOP, Filter::MODIFIED_BUTTERFLY })
  {
    ExpectSurfaceRefused(scheme, true, 4.);
  }
  for (const int scheme : { Filter::CATMULL_CLARK, Filter::DOO_SABIN })
  {
    ExpectSurfaceRefused(scheme, false, 4.);
  }
  ExpectSurfaceRefused(Filter::SQRT_THREE, true, 3.);
  ExpectSurfaceRefused(Filter::FOUR_EIGHT, true, 2.);
  ExpectSurfaceRefused(Filter::MIDEDGE, false, 2.);
}

TEST(Memory, EndsLocalRefinementOfSolids)
{
  using namespace red_green_refinement_tools;
  const Grid box = MakeBox(4);
  vtkNew<vtkIntArray> wanted;
  wanted->SetName("WantedLevel");
  wanted->SetNumberOfTuples(box->GetNumberOfCells());
  wanted->FillValue(6); // 100 million cells
  box->GetCellData()->AddArray(wanted);
  const Configure configure = [](Filter* filter) { RefineToLevel(filter, 6); };
  ExpectToEndWithLittleMemory(
    *box, [&](Messages* messages) { return Refine(box, configure, messages); });
}

TEST(Memory, EndsLocalRefinementOfSurfaces)
{
  using namespace adaptive_filter_tools;
  const PolyData sheet = MakeSheet(10, true);
  WantLevel(sheet, 12);
  const auto configure = [](Filter* filter) { RefineToLevel(filter, 12); };
  ExpectToEndWithLittleMemory(
    *sheet, [&](Messages* messages) { return Refine(sheet, configure, messages); });
}

TEST(Memory, RefusesLabels)
{
  const auto image = label_tools::MakeImage({ 12, 12, 12 }, [](int i, int, int) { return i < 6; });
  label_tools::Made made;
  const auto share = TakeShare(2e4);
  made.Run(image);
  made.ExpectError("1728 voxels take about ");
  made.ExpectError("Take a part of the image, or make NumberOfControlCells smaller.");
}

TEST(Memory, RefusesSmoothness)
{
  vtkNew<vtkSubdivisionSmoothness> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(red_green_refinement_tools::MakeBox(4));
  const auto share = TakeShare(2e4);
  filter->Update();
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find(" are available. Use a part of the input."), std::string::npos)
    << messages->Errors[0];
  EXPECT_EQ(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells(), 0);
}

TEST(Memory, RefusesErrorBounds)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(red_green_refinement_tools::MakeBox(4));
  filter->GenerateErrorBoundsOn();
  const auto share = TakeShare(2e6); // three levels more need some 100 MB
  filter->Update();
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find(" are available. "), std::string::npos) << messages->Errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}
