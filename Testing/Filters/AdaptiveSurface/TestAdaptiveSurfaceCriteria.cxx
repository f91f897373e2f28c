// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveSurfaceSubdivision: selections and implicit functions; and what older scripts are
// told.

#include "AdaptiveFilterTools.h"
#include "SelectionTools.h"

#include "vtkCompositeDataPipeline.h"
#include "vtkInformation.h"
#include "vtkSphere.h"

using namespace adaptive_filter_tools;
using namespace selection_tools;

namespace
{

constexpr int Levels = 4;

std::function<void(Filter*)> By(vtkSelection* selection)
{
  return [selection](Filter* filter)
  {
    RefineBy(filter, selection);
    filter->SetMaximumLevel(Levels);
  };
}

/// What a wanted level gives in these cells, and in no others.
PolyData RefineCells(vtkPolyData* input, const std::set<vtkIdType>& cells)
{
  auto marked = PolyData::New();
  marked->ShallowCopy(input);
  WantLevel(marked, 0);
  for (const vtkIdType cell : cells)
  {
    marked->GetCellData()->GetArray("WantedLevel")->SetComponent(cell, 0, Levels);
  }
  PolyData output = Refine(marked,
    [](Filter* filter)
    {
      filter->RefineByWantedLevelOn();
      filter->SetMaximumLevel(Levels);
    });
  output->GetCellData()->RemoveArray("WantedLevel");
  return output;
}

void ExpectTheSame(vtkPolyData* a, vtkPolyData* b)
{
  EXPECT_EQ(a->GetCellData()->GetNumberOfArrays(), b->GetCellData()->GetNumberOfArrays());
  for (vtkPolyData* mesh : { a, b })
  {
    mesh->GetPointData()->RemoveArray("Name");
  }
  ExpectSameBits(a, b);
}

std::set<vtkIdType> FindCellsWith(vtkPolyData* mesh, vtkIdType point)
{
  std::set<vtkIdType> found;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    if (ids->IsId(point) >= 0)
    {
      found.insert(cell);
    }
  }
  return found;
}

Point GetCentre(vtkPolyData* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  Point centre{};
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      centre[c] += mesh->GetPoint(ids->GetId(i))[c] / static_cast<double>(ids->GetNumberOfIds());
    }
  }
  return centre;
}

}

/// A hill has lines first: cells 0 and 1.
TEST(AdaptiveSurfaceSelection, CellsAndPointsAreRefinedWithAllThatLiesInThem)
{
  const PolyData input = MakeHill(6);
  ASSERT_EQ(input->GetNumberOfLines(), 2);
  const vtkIdType size = input->GetNumberOfCells();
  const PolyData ofCells =
    Refine(input, By(MakeSelection(vtkSelectionNode::CELL, { 0, 9, 40, size + 5 })));
  ExpectTheSame(ofCells, RefineCells(input, { 0, 9, 40 }));
  EXPECT_GT(ofCells->GetNumberOfCells(), size + 2 * 60);
  EXPECT_LT(ofCells->GetNumberOfCells(), size + 800);
  const PolyData ofPoints = Refine(input, By(MakeSelection(vtkSelectionNode::POINT, { 24 })));
  const std::set<vtkIdType> around = FindCellsWith(input, 24);
  EXPECT_EQ(around.size(), 6u);
  ExpectTheSame(ofPoints, RefineCells(input, around));
}

TEST(AdaptiveSurfaceSelection, NothingSelectedIsToldOnce)
{
  vtkNew<Messages> messages;
  const PolyData input = MakeHill(4);
  const PolyData output =
    Refine(input, By(MakeSelection(vtkSelectionNode::CELL, { 5000 })), messages);
  EXPECT_EQ(output->GetNumberOfCells(), input->GetNumberOfCells());
  EXPECT_EQ(messages->CountWarnings("no cell is selected"), 1);
  EXPECT_EQ(messages->Warnings.size(), 1u);
}

TEST(AdaptiveSurfaceSelection, OfABlock)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeHill(4));
  blocks->SetBlock(1, MakeHill(4));
  const Selection selection = MakeSelection(vtkSelectionNode::CELL, { 9 });
  selection->GetNode(0u)->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 2);
  vtkNew<Messages> messages;
  vtkNew<Filter> filter;
  vtkNew<vtkCompositeDataPipeline> executive;
  filter->SetExecutive(executive);
  filter->JoinBlocksOff();
  messages->Watch(filter);
  filter->SetInputDataObject(blocks);
  filter->RefineByAttributeErrorOff();
  filter->RefineByGeometricErrorOff();
  By(selection)(filter);
  filter->Update();
  auto* all = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(all, nullptr);
  auto* first = vtkPolyData::SafeDownCast(all->GetBlock(0));
  auto* second = vtkPolyData::SafeDownCast(all->GetBlock(1));
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->GetNumberOfCells(), MakeHill(4)->GetNumberOfCells());
  ExpectTheSame(second, RefineCells(MakeHill(4), { 9 }));
  EXPECT_TRUE(messages->Warnings.empty() && messages->Errors.empty());
}

TEST(AdaptiveSurfaceFunction, WhatLiesInsideIsRefined)
{
  const PolyData input = MakeHill(8);
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(4., 2., 0.);
  sphere->SetRadius(1.5);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->RefineByAttributeErrorOff();
  filter->RefineByGeometricErrorOff();
  filter->RefineByFunctionOn();
  filter->SetImplicitFunction(sphere);
  filter->SetMaximumLevel(Levels);
  filter->Update();
  vtkIdType before = input->GetNumberOfCells();
  for (const double radius : { 1.5, 2.5 })
  {
    sphere->SetRadius(radius); // counts as a change of the filter
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    vtkDataArray* generations = output->GetCellData()->GetArray("Generation");
    vtkIdType inside = 0;
    vtkIdType outside = 0;
    for (vtkIdType cell = output->GetNumberOfLines(); cell < output->GetNumberOfCells(); ++cell)
    {
      const Point centre = GetCentre(output, cell);
      const double distance = std::hypot(centre[0] - 4., centre[1] - 2., centre[2]);
      const double generation = generations->GetComponent(cell, 0);
      if (distance < radius - 0.5)
      {
        ++inside;
        ASSERT_GE(generation, 2. * Levels - 1.);
      }
      outside += distance > radius + 2.5 && generation == 0. ? 1 : 0;
    }
    EXPECT_GT(inside, 50);
    EXPECT_GT(outside, 20);
    EXPECT_GT(output->GetNumberOfCells(), before);
    before = output->GetNumberOfCells();
  }
}

TEST(AdaptiveSurfaceFunction, LinesToo)
{
  const PolyData input = MakeHill(4); // two lines from (1, 0, 0) to (3, 0, 0)
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(input->GetPoint(1));
  sphere->SetRadius(1.01);
  auto alone = PolyData::New();
  alone->SetPoints(input->GetPoints());
  alone->SetLines(input->GetLines());
  const PolyData output = Refine(alone,
    [&sphere](Filter* filter)
    {
      filter->RefineByFunctionOn();
      filter->SetImplicitFunction(sphere);
      filter->SetMaximumLevel(Levels);
    });
  EXPECT_EQ(output->GetCellData()->GetArray("Generation")->GetComponent(0, 0), 2. * Levels);
  EXPECT_LT(output->GetNumberOfLines(), 2 * 9);
  EXPECT_GE(output->GetNumberOfLines(), 9 + 1);
}

TEST(AdaptiveSurfaceFunction, WithoutOneThereIsAnError)
{
  vtkNew<Messages> messages;
  const PolyData output =
    Refine(MakeHill(4), [](Filter* filter) { filter->RefineByFunctionOn(); }, messages);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("RefineByFunction needs"), std::string::npos);
}

/// Options for solids are not ignored in silence.
TEST(AdaptiveSurface, OptionsWithoutRulesAreToldOf)
{
  const PolyData input = MakeHill(4);
  const PolyData expected = Refine(input, [](Filter*) {});
  for (const auto& configure :
    std::vector<std::function<void(vtkSubdivisionAlgorithm*)>>{ [](vtkSubdivisionAlgorithm* filter)
      { filter->SetEmbeddedCellsToSingular(); },
      [](vtkSubdivisionAlgorithm* filter) { filter->SetType1RuleToFollowDimension2(); },
      [](vtkSubdivisionAlgorithm* filter) { filter->SetType2RuleToFollowPart(); } })
  {
    vtkNew<Messages> messages;
    const PolyData output = Refine(input, configure, messages);
    EXPECT_EQ(messages->CountWarnings("have no rules for EmbeddedCells"), 1);
    EXPECT_EQ(messages->Warnings.size(), 1u);
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(output->GetNumberOfCells(), expected->GetNumberOfCells());
  }
}
