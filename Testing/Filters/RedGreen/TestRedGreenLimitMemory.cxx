// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenLimitMemory.cxx
 * vtkRedGreenRefinement: criteria that ask for the limit keep few values.
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

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)

namespace
{

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

}

TEST(RedGreenLimitDifference, TakesLittleMemory)
{
  const Grid box = MakeBox(18);
  box->GetPointData()->SetScalars(
    MakeArray<vtkDoubleArray>("V", 1, box->GetNumberOfPoints(), -1., 1., 3));
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
  EXPECT_LT(ofLimit - ofOthers, 2. * subdivision::BytesOfErrors);
}

#endif
