// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementCriteria.cxx
 * vtkRedGreenRefinement: what each criterion refines, limits, bad input.
 */
#include "RedGreenRefinementTools.h"
#include "SelectionTools.h"

#include "vtkCompositeDataPipeline.h"
#include "vtkInformation.h"
#include "vtkPlane.h"
#include "vtkSphere.h"

using namespace red_green_refinement_tools;
using namespace selection_tools;

namespace
{

TEST(RedGreenCriteria, AttributeErrorIsOnByDefaultAndIsMet)
{
  const Grid box = MakeBox(4);
  AddValues(box);
  vtkNew<Filter> filter;
  filter->SetInputData(box);
  filter->SetMaximumLevel(10);
  filter->SetAttributeTolerance(0.1);
  filter->Update();
  const Grid output = filter->GetOutput();
  vtkDataArray* values = output->GetPointData()->GetArray("V");
  const double allowed = 0.1 * 68.;
  double largest = 0.;
  ForEdges(output,
    [&](vtkIdType a, vtkIdType b)
    {
      largest =
        std::max(largest, std::abs(values->GetComponent(a, 0) - values->GetComponent(b, 0)));
    });
  EXPECT_LE(largest, allowed * (1. + 1e-12));
  EXPECT_GT(largest, allowed / 4.);
  EXPECT_GT(output->GetNumberOfCells(), box->GetNumberOfCells());
  EXPECT_GT(CountKind(output, 0), 0) << "not everything needs to be refined";
}

TEST(RedGreenCriteria, ASmallerDemandGivesACoarserMesh)
{
  const Grid box = MakeBox(3);
  AddValues(box);
  vtkIdType before = std::numeric_limits<vtkIdType>::max();
  for (double tolerance : { 0.01, 0.05, 0.1, 2. })
  {
    const Grid output = Refine(box,
      [tolerance](Filter* filter)
      {
        filter->RefineByAttributeErrorOn();
        filter->SetAttributeTolerance(tolerance);
      });
    EXPECT_LT(output->GetNumberOfCells(), before);
    before = output->GetNumberOfCells();
  }
  EXPECT_EQ(before, box->GetNumberOfCells());
}

TEST(RedGreenCriteria, TheArrayIsTheNamedOneTheActiveOneOrTheFirstFloatingOne)
{
  const Grid box = MakeBox(2);
  vtkNew<vtkIntArray> labels;
  labels->SetName("labels");
  labels->SetNumberOfTuples(box->GetNumberOfPoints());
  labels->Fill(3);
  box->GetPointData()->AddArray(labels);
  AddValues(box, "first");
  auto run = [&](const char* name)
  {
    return Refine(box,
      [name](Filter* filter)
      {
        filter->RefineByAttributeErrorOn();
        if (name)
        {
          filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
        }
      })
      ->GetNumberOfCells();
  };
  EXPECT_GT(run(nullptr), box->GetNumberOfCells());
  EXPECT_EQ(run("labels"), box->GetNumberOfCells()); // the same everywhere
  box->GetPointData()->SetActiveScalars("labels");
  EXPECT_EQ(run(nullptr), 8 * box->GetNumberOfCells()); // all once
  EXPECT_EQ(run("first"), run("first"));
  EXPECT_GT(run("first"), box->GetNumberOfCells());
}

TEST(RedGreenCriteria, ValuesThatAreNotFiniteAreCounted)
{
  const Grid box = MakeBox(1);
  AddValues(box);
  box->GetPointData()->GetArray("V")->SetComponent(3, 0, std::numeric_limits<double>::quiet_NaN());
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  ForEdges(box,
    [&](vtkIdType a, vtkIdType b)
    {
      if (a == 3 || b == 3)
      {
        edges.emplace(std::min(a, b), std::max(a, b));
      }
    });
  vtkNew<Messages> messages;
  const Grid output = Refine(
    box,
    [](Filter* filter)
    {
      filter->RefineByAttributeErrorOn();
      filter->SetAttributeTolerance(0.6);
      filter->SetMaximumLevel(1);
    },
    messages);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(
    messages->CountWarnings("does not refine " + std::to_string(edges.size()) + " edges"), 1);
  EXPECT_GT(output->GetNumberOfCells(), box->GetNumberOfCells());
}

TEST(RedGreenCriteria, ArrayRangeOfCellsAndOfPoints)
{
  const Grid box = MakeBox(2);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("C");
  for (vtkIdType i = 0; i < box->GetNumberOfCells(); ++i)
  {
    cells->InsertNextValue(static_cast<double>(i));
  }
  box->GetCellData()->AddArray(cells);
  const Grid byCell = Refine(box,
    [](Filter* filter)
    {
      filter->RefineByArrayRangeOn();
      filter->SetArrayRange(7., 8.);
      filter->SetMaximumLevel(2);
      filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "C");
    });
  for (vtkIdType i = 0; i < byCell->GetNumberOfCells(); ++i)
  {
    const vtkIdType origin = GetOrigin(byCell, i);
    if (origin == 7 || origin == 8)
    {
      EXPECT_EQ(GetLevel(byCell, i), 2.);
      EXPECT_EQ(GetKind(byCell, i), 1.);
    }
  }
  EXPECT_LT(byCell->GetNumberOfCells(), 64 * box->GetNumberOfCells() / 4);
  AddValues(box);
  const Grid byPoint = Refine(box,
    [](Filter* filter)
    {
      filter->RefineByArrayRangeOn();
      filter->SetArrayRange(9.5, 20.); // the corner edge x = 2, y = 2
      filter->SetMaximumLevel(1);
      filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
    });
  for (vtkIdType i = 0; i < byPoint->GetNumberOfCells(); ++i)
  {
    const Ids origin = GetCell(box, GetOrigin(byPoint, i));
    const bool isWanted = std::any_of(origin.begin(), origin.end(),
      [&](vtkIdType p) { return box->GetPointData()->GetArray("V")->GetComponent(p, 0) > 9.5; });
    EXPECT_TRUE(!isWanted || GetKind(byPoint, i) == 1.);
  }
  EXPECT_GT(CountKind(byPoint, 0), 0);
}

/// Runs with a selection of the given ids.
Grid RefineSelected(vtkDataObject* input, int fieldType, const Ids& ids, Messages* messages)
{
  return Refine(
    input,
    [&](Filter* filter)
    {
      RefineBy(filter, MakeSelection(fieldType, ids));
      filter->SetMaximumLevel(1);
    },
    messages);
}

TEST(RedGreenCriteria, SelectionOfCellsAndOfPoints)
{
  const Grid box = MakeBox(2);
  const Grid cells = RefineSelected(box, vtkSelectionNode::CELL, { 4, 9 }, nullptr);
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    const vtkIdType origin = GetOrigin(cells, i);
    EXPECT_TRUE((origin != 4 && origin != 9) || GetKind(cells, i) == 1.);
  }
  EXPECT_GT(CountKind(cells, 0), 0);
  const Grid points = RefineSelected(box, vtkSelectionNode::POINT, { 5 }, nullptr);
  for (vtkIdType i = 0; i < points->GetNumberOfCells(); ++i)
  {
    const Ids origin = GetCell(box, GetOrigin(points, i));
    EXPECT_TRUE(std::count(origin.begin(), origin.end(), 5) == 0 || GetKind(points, i) == 1.);
  }
  EXPECT_GT(CountKind(points, 1), 0);
}

TEST(RedGreenCriteria, AnEmptySelectionIsSaid)
{
  const Grid box = MakeBox(1);
  vtkNew<Messages> messages;
  const Grid output = RefineSelected(box, vtkSelectionNode::CELL, {}, messages);
  EXPECT_EQ(messages->CountWarnings("no cell is selected"), 1);
  EXPECT_EQ(output->GetNumberOfCells(), box->GetNumberOfCells());
  EXPECT_EQ(GetCells(output), GetCells(box));
  const Grid without = Refine(box, [](Filter* filter) { filter->RefineBySelectionOn(); }, messages);
  EXPECT_EQ(messages->CountWarnings("no cell is selected"), 2);
  EXPECT_EQ(without->GetNumberOfCells(), box->GetNumberOfCells());
}

TEST(RedGreenCriteria, ASelectionKnowsTheBlocks)
{
  const Grid first = MakeBox(1);
  const Grid second = MakeBox(1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  const Selection selection = MakeSelection(vtkSelectionNode::CELL, { 0 });
  selection->GetNode(0u)->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 2);
  vtkNew<Filter> filter;
  vtkNew<vtkCompositeDataPipeline> executive;
  filter->SetExecutive(executive);
  filter->JoinBlocksOff();
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(blocks);
  filter->RefineByAttributeErrorOff();
  RefineBy(filter, selection);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_TRUE(messages->Warnings.empty() && messages->Errors.empty());
  EXPECT_EQ(vtkDataSet::SafeDownCast(output->GetBlock(0))->GetNumberOfCells(), 6);
  EXPECT_GT(vtkDataSet::SafeDownCast(output->GetBlock(1))->GetNumberOfCells(), 100);
}

TEST(RedGreenCriteria, CellsInsideAFunction)
{
  const Grid box = MakeBox(2);
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(1.);
  vtkNew<Filter> filter;
  filter->SetInputData(box);
  filter->RefineByAttributeErrorOff();
  filter->RefineByFunctionOn();
  filter->SetImplicitFunction(sphere);
  filter->Update();
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfCells(); ++i)
  {
    Point centre = {};
    const Ids ids = GetCell(filter->GetOutput(), i);
    for (vtkIdType id : ids)
    {
      for (int c = 0; c < 3; ++c)
      {
        centre[c] += GetPoint(filter->GetOutput(), id)[c] / 4.;
      }
    }
    if (sphere->FunctionValue(centre.data()) < -1e-9)
    {
      EXPECT_EQ(GetLevel(filter->GetOutput(), i), 3.);
    }
  }
  const vtkIdType before = filter->GetOutput()->GetNumberOfCells();
  EXPECT_GT(before, box->GetNumberOfCells());
  sphere->SetRadius(0.3); // the filter notices, and the mesh is coarser again
  filter->Update();
  EXPECT_LT(filter->GetOutput()->GetNumberOfCells(), before);
}

TEST(RedGreenCriteria, EdgeLength)
{
  const Grid box = MakeBox(1);
  const Grid output = Refine(box,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.5);
      filter->SetMaximumLevel(10);
    });
  double longest = 0.;
  ForEdges(output,
    [&](vtkIdType a, vtkIdType b)
    {
      const Point p = GetPoint(output, a);
      const Point q = GetPoint(output, b);
      longest = std::max(longest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    });
  EXPECT_LE(longest, 0.5);
  EXPECT_GT(longest, 0.25);
}

TEST(RedGreenCriteria, WantedLevelsAreReached)
{
  const Grid box = MakeBox(2);
  AddWantedLevels(box, 3, 11, 0.5);
  const Grid output = RefineToWanted(box);
  vtkDataArray* wanted = output->GetCellData()->GetArray("WantedLevel");
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    EXPECT_GE(GetLevel(output, i), wanted->GetComponent(i, 0));
  }
}

TEST(RedGreenCriteria, AreOred)
{
  const Grid box = MakeBox(2);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0., 0.);
  plane->SetNormal(1., 0., 0.);
  AddWantedLevels(box, 1, 3, 0.1);
  auto run = [&](bool byFunction, bool byLevel)
  {
    return Refine(box,
      [&](Filter* filter)
      {
        filter->SetRefineByFunction(byFunction);
        filter->SetImplicitFunction(plane);
        filter->SetRefineByWantedLevel(byLevel);
        filter->SetMaximumLevel(1);
      });
  };
  const Grid both = run(true, true);
  for (const Grid& one : { run(true, false), run(false, true) })
  {
    std::set<vtkIdType> red;
    for (vtkIdType i = 0; i < one->GetNumberOfCells(); ++i)
    {
      if (GetKind(one, i) == 1.)
      {
        red.insert(GetOrigin(one, i));
      }
    }
    EXPECT_FALSE(red.empty());
    for (vtkIdType i = 0; i < both->GetNumberOfCells(); ++i)
    {
      EXPECT_TRUE(red.count(GetOrigin(both, i)) == 0 || GetKind(both, i) == 1.);
    }
  }
}

}
