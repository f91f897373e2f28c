// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTwoThreads.cxx
 * Two filters that two threads execute at the same time, each its own: their outputs have the bits
 * of runs alone. The checks of threads (./dev test --tsan) see what they share.
 */
#include "PlaceTools.h"
#include "SubdivisionDeformationTools.h"
#include "SurfaceTools.h"

#include "vtkRedGreenRefinement.h"
#include "vtkSubdivisionLimitProbe.h"

#include <atomic>
#include <thread>

using namespace feature_tools;

namespace
{

using Object = vtkSmartPointer<vtkDataObject>;
using Algorithm = vtkSmartPointer<vtkAlgorithm>;
using Maker = std::function<Algorithm()>;

constexpr int Runs = 20;

struct Worker
{
  const char* Name;
  Maker Make; ///< with inputs of its own: VTK's data sets make caches when they are read
};

Grid MakeBox()
{
  const Grid box = MakeKuhnBox(1, 0.1);
  AddArrays(box);
  return box;
}

Algorithm MakeUniform()
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetNumberOfLevels(2);
  filter->ProjectToLimitOn();
  filter->GenerateLimitNormalsOn();
  filter->SetInputDataObject(MakeBox());
  return filter;
}

Algorithm MakeSurface()
{
  auto filter = vtkSmartPointer<vtkSurfaceSubdivision>::New();
  filter->SetNumberOfLevels(2);
  filter->SetInputDataObject(
    surfacetools::MakeInput(surfacetools::MakeSheet(4, 4, true, { 1., 0., 0. }, { 0., 1., 0.5 })));
  return filter;
}

Algorithm MakeRedGreen()
{
  auto filter = vtkSmartPointer<vtkRedGreenRefinement>::New();
  filter->RefineByAttributeErrorOff();
  filter->RefineByEdgeLengthOn();
  filter->SetMaximumEdgeLength(0.5);
  filter->SetPlacementToLimit();
  filter->SetInputDataObject(MakeBox());
  return filter;
}

Algorithm MakeDeformation()
{
  auto filter = vtkSmartPointer<vtkSubdivisionDeformation>::New();
  const Grid cage = MakeKuhnBox(2);
  filter->SetInputDataObject(
    0, deformation_tools::MakeCloud(5, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1));
  filter->SetInputDataObject(1, cage);
  filter->SetInputDataObject(2, deformation_tools::Moved(cage, deformation_tools::Affine));
  return filter;
}

Algorithm MakeProbe()
{
  auto filter = vtkSmartPointer<vtkSubdivisionLimitProbe>::New();
  filter->SetInputDataObject(
    MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 1., 1., 1. } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 3, 2 } } }));
  filter->SetInputDataObject(3, place_tools::MakeTargets({ { 0.5, 0.5, 0.5 }, { 2., 0.3, 0.1 } }));
  return filter;
}

const std::vector<Worker>& GetWorkers()
{
  static const std::vector<Worker> workers = { { "uniform", MakeUniform },
    { "surface", MakeSurface }, { "redgreen", MakeRedGreen }, { "deformation", MakeDeformation },
    { "probe", MakeProbe } };
  return workers;
}

/// A new filter in each second run, the one before with what it kept in the others. Returns the
/// first difference from `expected`.
std::string RunOften(const Maker& make, vtkDataObject* expected, std::atomic<int>& arrived)
{
  Algorithm filter;
  ++arrived;
  while (arrived < 2)
  {
    std::this_thread::yield(); // both begin at once
  }
  std::string found;
  for (int run = 0; run < Runs && found.empty(); ++run)
  {
    if (run % 2 == 0)
    {
      filter = make();
    }
    filter->Modified();
    filter->Update();
    found = Compare(filter->GetOutputDataObject(0), expected);
  }
  return found;
}

Object RunAlone(const Worker& worker)
{
  const Algorithm filter = worker.Make();
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty()) << worker.Name;
  Object output = filter->GetOutputDataObject(0);
  EXPECT_GT(vtkPointSet::SafeDownCast(output)->GetNumberOfPoints(), 0) << worker.Name;
  return output;
}

using Pair = std::pair<std::size_t, std::size_t>;

class TwoThreads : public testing::TestWithParam<Pair>
{
};

TEST_P(TwoThreads, GiveTheBitsOfRunsAlone)
{
  const Worker& here = GetWorkers()[GetParam().first];
  const Worker& there = GetWorkers()[GetParam().second];
  const Object alone = RunAlone(here);
  const Object alsoAlone = RunAlone(there);
  std::atomic<int> arrived{ 0 };
  std::string other;
  std::thread thread([&] { other = RunOften(there.Make, alsoAlone, arrived); });
  const std::string own = RunOften(here.Make, alone, arrived);
  thread.join();
  EXPECT_EQ(own, "") << here.Name;
  EXPECT_EQ(other, "") << there.Name;
}

std::vector<Pair> ListPairs()
{
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < GetWorkers().size(); ++i)
  {
    for (std::size_t k = 0; k <= i; ++k)
    {
      pairs.emplace_back(k, i);
    }
  }
  return pairs;
}

std::string NameOf(const testing::TestParamInfo<Pair>& info)
{
  return std::string(GetWorkers()[info.param.first].Name) + "_" +
    GetWorkers()[info.param.second].Name;
}

INSTANTIATE_TEST_SUITE_P(Pairs, TwoThreads, testing::ValuesIn(ListPairs()), NameOf);

}
