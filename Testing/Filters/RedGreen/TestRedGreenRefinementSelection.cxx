// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementSelection.cxx
 * vtkRedGreenRefinement: selections of every kind.
 */
#include "RedGreenRefinementTools.h"
#include "SelectionTools.h"

#include "vtkCompositeDataPipeline.h"
#include "vtkInformation.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkUnsignedIntArray.h"

using namespace red_green_refinement_tools;

namespace
{

using Node = vtkSmartPointer<vtkSelectionNode>;

template <typename Array = vtkIdTypeArray>
Node MakeNode(int content, int field, const std::vector<double>& values, int components = 1,
  const char* name = nullptr)
{
  vtkNew<Array> list;
  list->SetNumberOfComponents(components);
  list->SetName(name);
  for (double value : values)
  {
    list->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  auto node = Node::New();
  node->SetContentType(content);
  node->SetFieldType(field);
  node->SetSelectionList(list);
  return node;
}

Node OfCells(const std::vector<double>& ids)
{
  return MakeNode(vtkSelectionNode::INDICES, vtkSelectionNode::CELL, ids);
}

Node OfPoints(const std::vector<double>& ids)
{
  return MakeNode(vtkSelectionNode::INDICES, vtkSelectionNode::POINT, ids);
}

Node Inverse(Node node)
{
  node->GetProperties()->Set(vtkSelectionNode::INVERSE(), 1);
  return node;
}

vtkSmartPointer<vtkSelection> MakeSelection(
  const std::vector<Node>& nodes, const std::string& expression = "")
{
  auto selection = vtkSmartPointer<vtkSelection>::New();
  std::string name = "A";
  for (const Node& node : nodes)
  {
    selection->SetNode(name, node);
    ++name[0];
  }
  selection->SetExpression(expression);
  return selection;
}

Configure By(vtkSelection* selection)
{
  return [selection](Filter* filter)
  {
    selection_tools::RefineBy(filter, selection);
    filter->SetMaximumLevel(1);
  };
}

/// Compares with what is refined where `wanted` are the cells that are selected: the wanted level
/// says the same.
std::string Check(
  vtkUnstructuredGrid* input, vtkSelection* selection, const std::set<vtkIdType>& wanted)
{
  const Grid marked = Grid::New();
  marked->ShallowCopy(input);
  vtkNew<vtkIntArray> levels;
  levels->SetName("Levels of this test");
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    levels->InsertNextValue(static_cast<int>(wanted.count(i)));
  }
  marked->GetCellData()->AddArray(levels);
  const Grid expected = Refine(marked,
    [](Filter* filter)
    {
      filter->RefineByWantedLevelOn();
      filter->SetInputArrayToProcess(
        7, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Levels of this test");
    });
  EXPECT_GT(wanted.size(), 0u);
  EXPECT_LT(static_cast<vtkIdType>(wanted.size()), input->GetNumberOfCells());
  expected->GetCellData()->RemoveArray("Levels of this test");
  return Compare(Refine(input, By(selection)), expected, false);
}

std::set<vtkIdType> CellsWithPoints(vtkUnstructuredGrid* grid, const std::set<vtkIdType>& points)
{
  std::set<vtkIdType> found;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    for (vtkIdType id : GetCell(grid, i))
    {
      if (points.count(id) > 0)
      {
        found.insert(i);
      }
    }
  }
  return found;
}

std::set<vtkIdType> AllBut(vtkUnstructuredGrid* grid, const std::set<vtkIdType>& cells)
{
  std::set<vtkIdType> others;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (cells.count(i) == 0)
    {
      others.insert(i);
    }
  }
  return others;
}

class RedGreenSelection : public testing::Test
{
protected:
  const Grid Box = MakeBox(2);
};

}

TEST_F(RedGreenSelection, SeveralNodesAreOred)
{
  EXPECT_EQ(
    Check(this->Box, MakeSelection({ OfCells({ 4, 9 }), OfCells({ 17 }) }), { 4, 9, 17 }), "");
}

TEST_F(RedGreenSelection, Expressions)
{
  const std::vector<Node> nodes = { OfCells({ 4, 9, 17 }), OfCells({ 9, 17, 30 }),
    OfCells({ 17 }) };
  EXPECT_EQ(Check(this->Box, MakeSelection(nodes, "A & B"), { 9, 17 }), "");
  EXPECT_EQ(Check(this->Box, MakeSelection(nodes, "(A & !B) | (B & !A)"), { 4, 30 }), "");
  EXPECT_EQ(Check(this->Box, MakeSelection(nodes, "(A | B) & !C"), { 4, 9, 30 }), "");
  EXPECT_EQ(Check(this->Box, MakeSelection(nodes, "B"), { 9, 17, 30 }), "");
}

TEST_F(RedGreenSelection, Inverse)
{
  EXPECT_EQ(
    Check(this->Box, MakeSelection({ Inverse(OfCells({ 4, 9 })) }), AllBut(this->Box, { 4, 9 })),
    "");
  std::set<vtkIdType> points;
  std::vector<double> others;
  for (vtkIdType i = 0; i < this->Box->GetNumberOfPoints(); ++i)
  {
    i == 2 || i == 11 ? static_cast<void>(points.insert(i))
                      : others.push_back(static_cast<double>(i));
  }
  EXPECT_EQ(Check(this->Box, MakeSelection({ Inverse(OfPoints(others)) }),
              CellsWithPoints(this->Box, points)),
    "");
}

TEST_F(RedGreenSelection, Points)
{
  const auto wanted = CellsWithPoints(this->Box, { 3, 8 });
  EXPECT_EQ(Check(this->Box, MakeSelection({ OfPoints({ 3, 8 }) }), wanted), "");
  const Node containing = OfPoints({ 3, 8 });
  containing->GetProperties()->Set(vtkSelectionNode::CONTAINING_CELLS(), 1);
  EXPECT_EQ(Check(this->Box, MakeSelection({ containing }), wanted), "");
}

TEST_F(RedGreenSelection, IdsThatDoNotExist)
{
  EXPECT_EQ(Check(this->Box, MakeSelection({ OfCells({ 4, 48, 5000, -1, -7 }) }), { 4 }), "");
  EXPECT_EQ(Check(this->Box, MakeSelection({ OfPoints({ 3, 27, 5000, -1 }) }),
              CellsWithPoints(this->Box, { 3 })),
    "");
}

TEST_F(RedGreenSelection, GlobalAndPedigreeIds)
{
  AddGlobalIds(this->Box, 5);
  for (int field : { vtkSelectionNode::CELL, vtkSelectionNode::POINT })
  {
    const bool ofCells = field == vtkSelectionNode::CELL;
    vtkDataSetAttributes* data = ofCells
      ? static_cast<vtkDataSetAttributes*>(this->Box->GetCellData())
      : static_cast<vtkDataSetAttributes*>(this->Box->GetPointData());
    const std::set<vtkIdType> chosen = { 2, 7 };
    std::vector<double> ids;
    for (vtkIdType i : chosen)
    {
      ids.push_back(data->GetGlobalIds()->GetComponent(i, 0));
    }
    const auto wanted = ofCells ? chosen : CellsWithPoints(this->Box, chosen);
    EXPECT_EQ(Check(this->Box, MakeSelection({ MakeNode(vtkSelectionNode::GLOBALIDS, field, ids) }),
                wanted),
      "");
    vtkNew<vtkIdTypeArray> pedigree;
    pedigree->SetName("Pedigree");
    for (vtkIdType i = 0; i < data->GetGlobalIds()->GetNumberOfTuples(); ++i)
    {
      pedigree->InsertNextValue(3 * i);
    }
    data->SetPedigreeIds(pedigree);
    EXPECT_EQ(Check(this->Box,
                MakeSelection(
                  { MakeNode(vtkSelectionNode::PEDIGREEIDS, field, { 6, 21, 22 }, 1, "Pedigree") }),
                wanted),
      "");
  }
}

TEST_F(RedGreenSelection, Thresholds)
{
  AddValues(this->Box);
  std::set<vtkIdType> points;
  for (vtkIdType i = 0; i < this->Box->GetNumberOfPoints(); ++i)
  {
    const double v = this->Box->GetPointData()->GetArray("V")->GetComponent(i, 0);
    if (v >= 9.5 && v <= 20.)
    {
      points.insert(i);
    }
  }
  EXPECT_EQ(Check(this->Box,
              MakeSelection({ MakeNode<vtkDoubleArray>(
                vtkSelectionNode::THRESHOLDS, vtkSelectionNode::POINT, { 9.5, 20. }, 2, "V") }),
              CellsWithPoints(this->Box, points)),
    "");
  AddWantedLevels(this->Box, 9, 3, 1.);
  std::set<vtkIdType> cells;
  for (vtkIdType i = 0; i < this->Box->GetNumberOfCells(); ++i)
  {
    if (this->Box->GetCellData()->GetArray("WantedLevel")->GetComponent(i, 0) == 4.)
    {
      cells.insert(i);
    }
  }
  for (int content : { vtkSelectionNode::THRESHOLDS, vtkSelectionNode::VALUES })
  {
    const bool isRange = content == vtkSelectionNode::THRESHOLDS;
    const Node node = isRange
      ? MakeNode<vtkDoubleArray>(content, vtkSelectionNode::CELL, { 3.5, 4.5 }, 2, "WantedLevel")
      : MakeNode<vtkIntArray>(content, vtkSelectionNode::CELL, { 4 }, 1, "WantedLevel");
    EXPECT_EQ(Check(this->Box, MakeSelection({ node }), cells), "");
  }
}

TEST_F(RedGreenSelection, Locations)
{
  // The cell around a point, and the point next to one.
  const Ids ids = GetCell(this->Box, 13);
  std::vector<double> centre(3, 0.);
  for (vtkIdType id : ids)
  {
    for (int c = 0; c < 3; ++c)
    {
      centre[c] += GetPoint(this->Box, id)[c] / 4.;
    }
  }
  EXPECT_EQ(Check(this->Box,
              MakeSelection({ MakeNode<vtkDoubleArray>(
                vtkSelectionNode::LOCATIONS, vtkSelectionNode::CELL, centre, 3) }),
              { 13 }),
    "");
  const Point p = GetPoint(this->Box, 6);
  const Node near = MakeNode<vtkDoubleArray>(
    vtkSelectionNode::LOCATIONS, vtkSelectionNode::POINT, { p[0] + 0.01, p[1], p[2] }, 3);
  near->GetProperties()->Set(vtkSelectionNode::EPSILON(), 0.1);
  EXPECT_EQ(Check(this->Box, MakeSelection({ near }), CellsWithPoints(this->Box, { 6 })), "");
}

TEST_F(RedGreenSelection, Frustum)
{
  // The corners of a small box around one corner of the mesh.
  std::vector<double> corners;
  for (int x = 0; x < 2; ++x)
  {
    for (int y = 0; y < 2; ++y)
    {
      for (int z = 0; z < 2; ++z)
      {
        for (double w : { x - 0.9, y - 0.9, 0.1 - z, 1. })
        {
          corners.push_back(w);
        }
      }
    }
  }
  std::set<vtkIdType> points;
  for (vtkIdType i = 0; i < this->Box->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(this->Box, i);
    if (std::max({ p[0], p[1], p[2] }) < 0.1)
    {
      points.insert(i);
    }
  }
  ASSERT_EQ(points.size(), 1u);
  const auto wanted = CellsWithPoints(this->Box, points);
  for (int field : { vtkSelectionNode::CELL, vtkSelectionNode::POINT })
  {
    EXPECT_EQ(
      Check(this->Box,
        MakeSelection({ MakeNode<vtkDoubleArray>(vtkSelectionNode::FRUSTUM, field, corners, 4) }),
        wanted),
      "");
  }
}

TEST_F(RedGreenSelection, PointsAndCellsTogether)
{
  auto wanted = CellsWithPoints(this->Box, { 3 });
  wanted.insert({ 4, 9 });
  EXPECT_EQ(Check(this->Box, MakeSelection({ OfPoints({ 3 }), OfCells({ 4, 9 }) }), wanted), "");
}

TEST_F(RedGreenSelection, OfABlockWhereThereAreNone)
{
  const Node node = OfCells({ 4, 9 });
  node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 3);
  EXPECT_EQ(Check(this->Box, MakeSelection({ node }), { 4, 9 }), "");
}

/// Nothing is refined, and the user hears of it.
TEST_F(RedGreenSelection, ThatCannotBeUsed)
{
  const Node withoutList = OfCells({});
  withoutList->SetSelectionList(nullptr);
  const Node ofRows = MakeNode(vtkSelectionNode::INDICES, vtkSelectionNode::ROW, { 1 });
  const Node ofNothing = vtkSmartPointer<vtkSelectionNode>::New();
  const Node query = OfCells({ 1 });
  query->SetContentType(vtkSelectionNode::QUERY);
  query->SetQueryString("id > 3");
  const Node words = OfCells({});
  words->SetSelectionList(MakeNames("words", 2));
  for (const auto& selection : { MakeSelection({ OfCells({ 4 }) }, "A & ("),
         MakeSelection({ OfCells({ 4 }) }, "Z"), MakeSelection({}),
         MakeSelection({ MakeNode(vtkSelectionNode::GLOBALIDS, vtkSelectionNode::CELL, { 1 }) }),
         MakeSelection({ MakeNode(vtkSelectionNode::FRUSTUM, vtkSelectionNode::CELL, { 1 }) }),
         MakeSelection({ MakeNode(
           vtkSelectionNode::THRESHOLDS, vtkSelectionNode::CELL, { 1, 2 }, 2, "nothing") }),
         MakeSelection({ MakeNode(vtkSelectionNode::THRESHOLDS, vtkSelectionNode::CELL, { 1 }) }),
         MakeSelection({ words }), MakeSelection({ OfCells({}) }), MakeSelection({ withoutList }),
         MakeSelection({ ofRows }), MakeSelection({ ofNothing }), MakeSelection({ query }) })
  {
    vtkNew<Messages> messages;
    const Grid output = Refine(this->Box, By(selection), messages);
    EXPECT_EQ(messages->Warnings.size(), 1u);
    EXPECT_EQ(messages->CountWarnings("RefineBySelection:"), 1);
    EXPECT_EQ(GetCells(output), GetCells(this->Box));
  }
}

namespace
{

using Blocks = vtkSmartPointer<vtkMultiBlockDataSet>;

/// A box, and a collection of two more: flat indices 1, and 2 with 3 and 4 in it.
Blocks MakeBlocks()
{
  auto blocks = Blocks::New();
  vtkNew<vtkMultiBlockDataSet> inner;
  blocks->SetBlock(0, MakeBox(1));
  inner->SetBlock(0, MakeBox(1));
  inner->SetBlock(1, MakeBox(1));
  blocks->SetBlock(1, inner);
  return blocks;
}

/// How many cells each block has then.
std::vector<vtkIdType> RunBlocks(vtkSelection* selection, Messages* messages)
{
  vtkNew<Filter> filter;
  vtkNew<vtkCompositeDataPipeline> executive;
  filter->SetExecutive(executive);
  filter->JoinBlocksOff();
  messages->Watch(filter);
  filter->SetInputDataObject(MakeBlocks());
  filter->RefineByAttributeErrorOff();
  By(selection)(filter);
  filter->Update();
  std::vector<vtkIdType> cells;
  auto* all = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* inner = vtkMultiBlockDataSet::SafeDownCast(all->GetBlock(1));
  for (vtkDataObject* block : { all->GetBlock(0), inner->GetBlock(0), inner->GetBlock(1) })
  {
    cells.push_back(vtkDataSet::SafeDownCast(block)->GetNumberOfCells());
  }
  return cells;
}

}

TEST(RedGreenSelectionOfBlocks, Whole)
{
  vtkNew<Messages> messages;
  const Node blocks =
    MakeNode<vtkUnsignedIntArray>(vtkSelectionNode::BLOCKS, vtkSelectionNode::CELL, { 3 });
  EXPECT_EQ(RunBlocks(MakeSelection({ blocks }), messages), (std::vector<vtkIdType>{ 6, 48, 6 }));
  const Node parent =
    MakeNode<vtkUnsignedIntArray>(vtkSelectionNode::BLOCKS, vtkSelectionNode::CELL, { 2 });
  EXPECT_EQ(RunBlocks(MakeSelection({ parent }), messages), (std::vector<vtkIdType>{ 6, 48, 48 }));
  EXPECT_EQ(RunBlocks(MakeSelection({ parent, blocks }, "A & !B"), messages),
    (std::vector<vtkIdType>{ 6, 6, 48 }));
  EXPECT_TRUE(messages->Warnings.empty() && messages->Errors.empty());
}

TEST(RedGreenSelectionOfBlocks, CellsOfOneAndOfAll)
{
  vtkNew<Messages> messages;
  const Node everywhere = OfCells({ 0, 1, 2, 3, 4, 5 });
  EXPECT_EQ(
    RunBlocks(MakeSelection({ everywhere }), messages), (std::vector<vtkIdType>{ 48, 48, 48 }));
  const Node inOne = OfCells({ 0, 1, 2, 3, 4, 5 });
  inOne->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 4);
  EXPECT_EQ(RunBlocks(MakeSelection({ inOne }), messages), (std::vector<vtkIdType>{ 6, 6, 48 }));
  EXPECT_EQ(RunBlocks(MakeSelection({ everywhere, inOne }, "A & !B"), messages),
    (std::vector<vtkIdType>{ 48, 48, 6 }));
  EXPECT_TRUE(messages->Warnings.empty() && messages->Errors.empty());
}

TEST(RedGreenSelectionOfBlocks, NothingIsSaidOnce)
{
  vtkNew<Messages> messages;
  const Node nothing = OfCells({ 7 });
  EXPECT_EQ(RunBlocks(MakeSelection({ nothing }), messages), (std::vector<vtkIdType>{ 6, 6, 6 }));
  EXPECT_EQ(messages->CountWarnings("no cell is selected"), 1);
}
