// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestManyRuns.cxx
 * One filter that runs very often while its options change holds as much memory at the end as after
 * the first runs. SUBDIVISIONOBJECTS_RUNS=10000 in the environment makes 10,000 runs of each;
 * without it the main filter has so many, the others fewer.
 */
#include "FailingMemory.h"
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSphereSource.h"
#include "vtkSubdivisionDeformation.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkSurfaceSubdivision.h"

#include <cstdio>
#include <cstdlib>

#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33) && !defined(__SANITIZE_ADDRESS__) &&               \
  !defined(__SANITIZE_THREAD__)
#include <malloc.h>
#define KNOWS_HEAP 1
#else
#define KNOWS_HEAP 0
#endif

using namespace multi_dimensional_subdivision_tools;

namespace
{

/// Bytes that the heap of this thread has handed out.
double GetUsedBytes()
{
#if KNOWS_HEAP
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
#else
  return 0.;
#endif
}

/// `usual` unless the environment says otherwise.
int GetNumberOfRuns(int usual)
{
  const char* given = std::getenv("SUBDIVISIONOBJECTS_RUNS");
  return given ? std::atoi(given) : usual;
}

/// Changes some options at run `i`; the same ones again after `Period` runs.
template <typename Filter>
using Change = std::function<void(Filter*, int i)>;
constexpr int Period = 60;
/// Bytes that VTK and the library of C may keep once, not in each run.
constexpr double Most = 2048.;

/// By how many bytes the heap grows after the first runs; NaN after an error.
template <typename Filter>
double FindGrowth(vtkDataObject* input, int usual, const Change<Filter>& change)
{
  double first = 0.;
  bool failed = false;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]
    {
      vtkNew<Filter> filter;
      vtkNew<Messages> messages; // warnings are not to be printed
      messages->Watch(filter);
      filter->SetInputDataObject(input);
      const int runs = std::max(6, GetNumberOfRuns(usual) / Period) * Period;
      for (int i = 0; i < runs; ++i)
      {
        change(filter, i % Period);
        filter->Modified();
        filter->Update();
        messages->Warnings = {};
        messages->Inversions = {};
        failed = failed || !messages->Errors.empty();
        if (i == 3 * Period - 1)
        {
          first = GetUsedBytes();
        }
      }
      first = GetUsedBytes() - first;
    });
  return failed ? std::numeric_limits<double>::quiet_NaN() : first;
}

/// In a process of its own, whose threads do not keep what was freed: that would count as used.
template <typename Filter>
void ExpectFlatHeap(vtkDataObject* input, int usual, const Change<Filter>& change)
{
  if (!KNOWS_HEAP)
  {
    GTEST_SKIP() << "skipped: this library of C does not say how much memory is used";
  }
  setenv("GLIBC_TUNABLES", "glibc.malloc.tcache_count=0", 1);
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
    {
      const double growth = FindGrowth(input, usual, change);
      std::fprintf(stderr, "The heap grows by %g bytes.", growth);
      std::_Exit(growth <= Most ? 0 : 1);
    },
    testing::ExitedWithCode(0), "grows");
}

vtkSmartPointer<vtkDataSet> MakeSolid()
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModelToMixedDimensions();
  source->Update();
  return source->GetOutput();
}

/// Points that a solid deforms.
struct DeformedCloud
{
  static constexpr vtkIdType Size = 100000;
  static constexpr double BytesOfOutput = 24. * Size;

  DeformedCloud()
  {
    const auto cage = MakeSolid();
    this->Points->SetDataTypeToDouble();
    this->Cloud->SetPoints(this->Points);
    this->SetNumberOfPoints(Size);
    this->Filter->SetInputData(this->Cloud);
    this->Filter->SetInputDataObject(1, cage);
    this->Filter->SetInputDataObject(2, cage);
  }
  void SetNumberOfPoints(vtkIdType size) const
  {
    this->Points->SetNumberOfPoints(size);
    this->Points->GetData()->Fill(0.3);
    this->Points->Modified();
  }
  /// The growth of memory in an update; 0 if it is not known.
  double FindPeak() const
  {
    failing_memory::StartPeak();
    this->Filter->Update();
    return static_cast<double>(failing_memory::GetPeak());
  }

  const vtkNew<vtkPoints> Points;
  const vtkNew<vtkPolyData> Cloud;
  const vtkNew<vtkSubdivisionDeformation> Filter;
};

}

TEST(ManyRuns, MultiDimensionalSubdivision)
{
  ExpectFlatHeap<vtkMultiDimensionalSubdivision>(MakeSolid(), 10000,
    [](vtkMultiDimensionalSubdivision* filter, int i)
    {
      filter->SetNumberOfLevels(i % 3);
      filter->SetVolumeScheme(i / 3 % 2);
      filter->SetProjectToLimit(i % 5 == 1);
      filter->SetGenerateLimitNormals(i % 4 == 1);
      filter->SetGenerateClassification(i % 2 == 1);
      filter->SetGenerateOriginalIds(i % 6 < 2);
      filter->SetDetectFeatures(i % 10 < 3);
      filter->SetMergePoints(i % 15 == 2);
      filter->SetCacheOperator(i % 20 < 12);
      filter->SetOutputPointsPrecision(i % 3);
    });
}

TEST(ManyRuns, SurfaceSubdivision)
{
  vtkNew<vtkSphereSource> source;
  source->Update();
  ExpectFlatHeap<vtkSurfaceSubdivision>(source->GetOutput(), 2000,
    [](vtkSurfaceSubdivision* filter, int i)
    {
      filter->SetNumberOfLevels(i % 3);
      filter->SetScheme(i / 3 % (vtkSurfaceSubdivision::LINEAR + 1));
      filter->SetProjectToLimit(i % 5 == 1);
      filter->SetGenerateLimitNormals(i % 4 == 1);
      filter->SetInterpolatePoints(i % 7 == 1);
      filter->SetGenerateOriginalIds(i % 6 < 2);
      filter->SetCacheOperator(i % 20 < 12);
    });
}

TEST(ManyRuns, RedGreenRefinement)
{
  ExpectFlatHeap<vtkRedGreenRefinement>(MakeSolid(), 2000,
    [](vtkRedGreenRefinement* filter, int i)
    {
      filter->SetMaximumLevel(1 + i % 2);
      filter->SetRefineByEdgeLength(i % 3 != 0);
      filter->SetMaximumEdgeLength(0.5 + 0.1 * (i % 4));
      filter->SetPlacement(i / 3 % 2);
      filter->SetVolumeScheme(i / 6 % 2);
      filter->SetGenerateOriginalIds(i % 6 < 2);
    });
}

TEST(ManyRuns, AdaptiveSurfaceSubdivision)
{
  vtkNew<vtkSphereSource> source;
  source->Update();
  ExpectFlatHeap<vtkAdaptiveSurfaceSubdivision>(source->GetOutput(), 600,
    [](vtkAdaptiveSurfaceSubdivision* filter, int i)
    {
      filter->SetMaximumLevel(1 + i % 2);
      filter->SetRefineByEdgeLength(i % 3 != 0);
      filter->SetMaximumEdgeLength(0.1 + 0.05 * (i % 4));
      filter->SetGenerateLimitNormals(i % 4 == 1);
      filter->SetGenerateOriginalIds(i % 6 < 2);
    });
}

TEST(ManyRuns, SubdivisionDeformation)
{
  const auto cage = MakeSolid();
  ExpectFlatHeap<vtkSubdivisionDeformation>(cage, 1000,
    [&](vtkSubdivisionDeformation* filter, int i)
    {
      filter->SetInputDataObject(1, cage);
      filter->SetInputDataObject(2, cage);
      filter->SetNumberOfLevels(i % 3);
      filter->SetVolumeScheme(i / 3 % 2);
      filter->SetTransformVectors(i % 4 == 1);
      filter->SetOutputPointsPrecision(i % 3);
    });
}

/// A run may not follow a request, as after an error of what is before the filter: outputs that
/// were made are not kept for one.
TEST(ManyRuns, DeformationWithRequestsAlone)
{
  if (!KNOWS_HEAP)
  {
    GTEST_SKIP() << "skipped: this library of C does not say how much memory is used";
  }
  const DeformedCloud cloud;
  cloud.Filter->Update();
  auto held = vtkSmartPointer<vtkPolyData>::New();
  held->ShallowCopy(cloud.Filter->GetOutputDataObject(0));
  cloud.Filter->GetOutputDataObject(0)->Initialize();
  cloud.Filter->Modified();
  cloud.Filter->PropagateUpdateExtent();
  const double before = GetUsedBytes();
  held = nullptr;
  EXPECT_LE(GetUsedBytes(), before - DeformedCloud::BytesOfOutput);
}

/// The output before is gone when other points are bound, which takes most memory.
TEST(ManyRuns, DeformationOfOtherPoints)
{
  const DeformedCloud fresh;
  const double first = fresh.FindPeak();
  if (first == 0.)
  {
    GTEST_SKIP() << "skipped: sanitizers have an own heap";
  }
  fresh.SetNumberOfPoints(DeformedCloud::Size + 1000);
  EXPECT_LE(fresh.FindPeak(), first - 0.5 * DeformedCloud::BytesOfOutput);
}

TEST(ManyRuns, SimplicialComplexTopology)
{
  ExpectFlatHeap<vtkSimplicialComplexTopology>(MakeSolid(), 2000,
    [](vtkSimplicialComplexTopology* filter, int i)
    {
      filter->SetDetectFeatures(i % 10 < 3);
      filter->SetMergePoints(i % 15 == 2);
      filter->SetOutputPointsPrecision(i % 3);
    });
}
