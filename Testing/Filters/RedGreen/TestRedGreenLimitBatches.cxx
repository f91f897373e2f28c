// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenLimitBatches.cxx
 * vtkRedGreenRefinement: criteria that ask for the limit find it some edges at a time.
 */
#include "RedGreenRefinementTools.h"

#include "Core/Memory/Loops.h"
#include "Private/RedGreen/RedGreenErrors.h"

#include "vtkCallbackCommand.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace red_green_refinement_tools;
using subdivision::BetweenLoops;
using subdivision::LimitBatches;

namespace
{

/// As long as it lives, batches are this small.
class SmallBatches
{
public:
  explicit SmallBatches(std::size_t least)
    : Before(std::exchange(LimitBatches::Least, least))
  {
  }
  ~SmallBatches() { LimitBatches::Least = this->Before; }

private:
  const std::size_t Before;
};

Grid RefineByLimit(vtkUnstructuredGrid* input, bool ofArray, int scheme, vtkIdType mostCells)
{
  vtkNew<Messages> messages; // at mostCells it warns
  return Refine(
    input,
    [=](Filter* filter)
    {
      filter->SetRefineByAttributeError(ofArray);
      filter->SetRefineByGeometricError(!ofArray);
      filter->SetAttributeErrorKindToLimitDifference();
      filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
      filter->SetAttributeTolerance(1e-4);
      filter->SetGeometricTolerance(1e-5);
      filter->SetVolumeScheme(scheme);
      filter->SetMaximumLevel(2);
      filter->SetMaximumNumberOfCells(mostCells);
    },
    messages);
}

class RedGreenLimitBatches : public testing::TestWithParam<std::string>
{
};

/// Which marks fit into the output shows the order of their errors.
TEST_P(RedGreenLimitBatches, ChangeNoError)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  input->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("V", 1, input->GetNumberOfPoints(), -1., 1., 3));
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
  {
    for (const bool ofArray : { true, false })
    {
      for (const vtkIdType times : { 3, 1000 })
      {
        const vtkIdType most = times * input->GetNumberOfCells();
        const Grid whole = RefineByLimit(input, ofArray, scheme, most);
        const SmallBatches small(7);
        const Grid parts = RefineByLimit(input, ofArray, scheme, most);
        ASSERT_EQ(whole->GetNumberOfPoints(), parts->GetNumberOfPoints());
        ASSERT_EQ(whole->GetNumberOfCells(), parts->GetNumberOfCells());
        for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
        {
          ASSERT_EQ(GetCell(whole, i), GetCell(parts, i)) << "cell " << i;
        }
        for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
        {
          ASSERT_EQ(GetPoint(whole, i), GetPoint(parts, i)) << "point " << i;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, RedGreenLimitBatches, testing::ValuesIn(coretest::GetNamesOfZoo(0)),
  [](const auto& instance) { return instance.param; });

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)

double GetUsedBytes()
{
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// The most memory in use while the filter works on a mesh, in bytes for each of its cells. It
/// looks as often as the filter may report.
double FindMostBytes(vtkUnstructuredGrid* input, const Configure& configure)
{
  const double seconds = std::exchange(BetweenLoops::SecondsBetween, 0.);
  const double before = GetUsedBytes();
  double most = before;
  vtkNew<vtkCallbackCommand> look;
  look->SetClientData(&most);
  look->SetCallback([](vtkObject*, unsigned long, void* data, void*)
    { *static_cast<double*>(data) = std::max(*static_cast<double*>(data), GetUsedBytes()); });
  const Grid output = Refine(input,
    [&](Filter* filter)
    {
      configure(filter);
      filter->AddObserver(vtkCommand::ProgressEvent, look);
    });
  BetweenLoops::SecondsBetween = seconds;
  EXPECT_EQ(output->GetNumberOfCells(), input->GetNumberOfCells());
  return (most - before) / static_cast<double>(input->GetNumberOfCells());
}

TEST(RedGreenLimitDifference, TakesLittleMemory)
{
  const Grid box = MakeBox(18);
  box->GetPointData()->SetScalars(
    MakeArray<vtkDoubleArray>("V", 1, box->GetNumberOfPoints(), -1., 1., 3));
  const SmallBatches small(64);
  const double ofLimit = FindMostBytes(box,
    [](Filter* filter)
    {
      filter->RefineByAttributeErrorOn();
      filter->SetAttributeErrorKindToLimitDifference();
      filter->SetAttributeTolerance(1e9);
    });
  const double ofOthers = FindMostBytes(box,
    [](Filter* filter)
    {
      filter->RefineByGeometricErrorOn(); // which has a control level, too
      filter->SetGeometricTolerance(1e9);
    });
  this->RecordProperty("Bytes", std::to_string(std::lround(ofLimit - ofOthers)));
  // Twice, because pages of 2 MB round up what a small mesh takes. All rows at once take 18000.
  EXPECT_LT(ofLimit - ofOthers, 2. * LimitBatches::BytesOfTet);
}

#endif

}
