// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementChaining.cxx
 * vtkRedGreenRefinement: what travels with an output so that the next filter can undo its green
 * cells: through files, and when it is damaged.
 */
#include "FileTools.h"
#include "RedGreenRefinementTools.h"

#include "Core/Solids/RedGreen/RedGreenTables.h"

using namespace file_tools;
using namespace red_green_refinement_tools;

namespace
{

/// A mesh of all dimensions with cells of all kinds.
Grid MakeGreen()
{
  const Grid input = MakeGrid(coretest::With(
    coretest::MakeLattice("", 2, 1., 5).Control, "", { { 0, 1, 2 }, { 3, 27 }, { 4 } }));
  AddWeights(input);
  const Grid green = RefineByChance(input, 4, 12);
  green->GetCellData()->RemoveArray("WantedLevel");
  for (int kind = 0; kind < 5; ++kind)
  {
    EXPECT_GT(CountKind(green, kind), 0) << kind;
  }
  return green;
}

}

TEST(RedGreenLeaves, AreWhatGreenCellsArePartsOf)
{
  const Grid green = MakeGreen();
  vtkDataArray* leaves = green->GetFieldData()->GetArray("RedGreenLeaves");
  vtkDataArray* parents = green->GetCellData()->GetArray("GreenParent");
  vtkDataArray* weights = green->GetPointData()->GetArray("Weights");
  ASSERT_EQ(leaves->GetNumberOfComponents(), 10);
  std::map<vtkIdType, std::vector<Ids>> parts;
  for (vtkIdType i = 0; i < green->GetNumberOfCells(); ++i)
  {
    const auto parent = static_cast<vtkIdType>(parents->GetComponent(i, 0));
    EXPECT_EQ(parent >= 0, GetKind(green, i) >= 2.);
    ASSERT_LT(parent, leaves->GetNumberOfTuples());
    if (parent < 0)
    {
      EXPECT_EQ(parent, -1);
      continue;
    }
    parts[parent].push_back(GetCell(green, i));
  }
  EXPECT_EQ(static_cast<vtkIdType>(parts.size()), leaves->GetNumberOfTuples());
  for (const auto& [parent, cells] : parts)
  {
    // The points of the leaf and of its edges are all that its parts have, and its corners are.
    const int corners = static_cast<int>(cells[0].size());
    std::set<vtkIdType> own;
    int middles = 0;
    for (int c = 0; c < 10; ++c)
    {
      const auto point = static_cast<vtkIdType>(leaves->GetComponent(parent, c));
      EXPECT_EQ(c < 4 && c >= corners && point >= 0, false);
      if (point >= 0)
      {
        own.insert(point);
      }
      if (c < 4 || point < 0)
      {
        continue;
      }
      ++middles;
      const int* ends = subdivision::redgreen::EndsOf(corners - 1, c - 4);
      for (int w = 0; w < weights->GetNumberOfComponents(); ++w)
      {
        const auto a = static_cast<vtkIdType>(leaves->GetComponent(parent, ends[0]));
        const auto b = static_cast<vtkIdType>(leaves->GetComponent(parent, ends[1]));
        EXPECT_EQ(weights->GetComponent(point, w),
          (weights->GetComponent(a, w) + weights->GetComponent(b, w)) / 2.);
      }
    }
    std::set<vtkIdType> found;
    for (const Ids& cell : cells)
    {
      found.insert(cell.begin(), cell.end());
    }
    EXPECT_EQ(found, own);
    EXPECT_EQ(static_cast<int>(own.size()), corners + middles);
    EXPECT_EQ(cells.size(), middles == 1 ? 2u : 4u);
  }
}

TEST(RedGreenLeaves, TravelThroughFiles)
{
  const Grid green = MakeGreen();
  const Grid direct = HalveAll(green, 2);
  EXPECT_LT(direct->GetNumberOfCells(), 64 * green->GetNumberOfCells()) << "undone";
  for (int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended })
  {
    if (mode == vtkXMLWriter::Appended && !ReadsAppendedData())
    {
      continue;
    }
    for (bool narrow : { false, true })
    {
      const Grid read = WriteAndRead(green, mode, narrow);
      const Grid again = HalveAll(read, 2);
      EXPECT_EQ(GetCells(again), GetCells(direct)) << mode << narrow;
      EXPECT_EQ(CompareValues(again->GetPoints()->GetData(), direct->GetPoints()->GetData()), "");
      EXPECT_EQ(again->GetNumberOfPoints(), direct->GetNumberOfPoints());
      for (const char* name : { "RefinementLevel", "RefinementKind" })
      {
        EXPECT_EQ(CompareValues(
                    again->GetCellData()->GetArray(name), direct->GetCellData()->GetArray(name)),
          "");
      }
    }
  }
}

/// Values that are not numbers are the same as each other.
TEST(RedGreenLeaves, AreUndoneWhereNothingIsKnown)
{
  const Grid green = DeepCopy(MakeGreen());
  auto unknown = MakeArray<vtkDoubleArray>("Unknown", 1, green->GetNumberOfCells(), 0., 1., 1);
  unknown->Fill(std::numeric_limits<double>::quiet_NaN());
  green->GetCellData()->AddArray(unknown);
  EXPECT_EQ(GetCells(HalveAll(green, 1)), GetCells(HalveAll(MakeGreen(), 1)));
}

/// Leaves that are not those of the cells: as if they were not there, whatever they say.
TEST(RedGreenLeaves, ThatAreDamagedAreNotUsed)
{
  const Grid box = MakeBox(1);
  std::mt19937 random(1);
  int damaged = 0;
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    AddWantedLevels(box, 1, seed);
    const Grid once = RefineToWanted(box, 1);
    once->GetCellData()->RemoveArray("WantedLevel");
    vtkDataArray* leaves = once->GetFieldData()->GetArray("RedGreenLeaves");
    const vtkIdType size = leaves->GetNumberOfTuples();
    vtkNew<vtkIdTypeArray> before;
    before->DeepCopy(leaves);
    for (unsigned k = 0; size > 0 && k < 1 + seed % 5; ++k)
    {
      const auto point = static_cast<vtkIdType>(random() % (once->GetNumberOfPoints() + 4)) - 2;
      const auto leaf = static_cast<vtkIdType>(random() % size);
      leaves->SetComponent(leaf, static_cast<int>(random() % 10), static_cast<double>(point));
    }
    vtkNew<Messages> messages;
    const Grid twice = HalveAll(once, 1, {}, messages);
    if (CompareValues(before, leaves) != "" && messages->CountWarnings("is replaced") > 0)
    {
      ++damaged;
      EXPECT_EQ(twice->GetNumberOfCells(), 8 * once->GetNumberOfCells()) << seed;
    }
  }
  EXPECT_GT(damaged, 100);
}

/// Cells of the first filter were taken away, or put in another order.
TEST(RedGreenLeaves, OfOtherCellsAreNotUsed)
{
  const Grid green = MakeGreen();
  for (int change = 0; change < 3; ++change)
  {
    std::vector<Ids> ids = GetCells(green);
    change == 0     ? ids.pop_back()
      : change == 1 ? std::swap(ids[0], ids.back())
                    : std::swap(ids[10], ids[11]);
    std::vector<Cell> cells;
    const int types[] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };
    for (const Ids& cell : ids)
    {
      cells.push_back({ types[cell.size() - 1], cell });
    }
    const Grid changed = multi_dimensional_subdivision_tools::MakeGrid({}, cells);
    changed->SetPoints(green->GetPoints());
    changed->GetFieldData()->PassData(green->GetFieldData());
    if (change > 0)
    {
      changed->GetCellData()->PassData(green->GetCellData());
    }
    vtkNew<Messages> messages;
    const Grid output = HalveAll(changed, 0, {}, messages);
    EXPECT_EQ(GetCells(output), ids) << change;
    EXPECT_EQ(CountKind(output, 0), output->GetNumberOfCells()) << change;
  }
}

/// Levels are counted in a byte.
TEST(RedGreenLeaves, LevelsEndAt255)
{
  Grid line = multi_dimensional_subdivision_tools::MakeGrid(
    { { 0., 0., 0. }, { 1., 0., 0. } }, { { VTK_LINE, { 0, 1 } } });
  vtkNew<vtkDoubleArray> x;
  x->SetName("x");
  x->InsertNextValue(0.);
  x->InsertNextValue(1.);
  line->GetPointData()->SetScalars(x);
  for (int filters = 1; filters <= 6; ++filters)
  {
    line = Refine(line,
      [](Filter* filter)
      {
        filter->RefineByArrayRangeOn(); // the cell at the point 0
        filter->SetArrayRange(0., 0.);
        filter->SetMaximumLevel(60);
      });
    EXPECT_EQ(line->GetNumberOfCells(), 1 + std::min(60 * filters, 255));
    EXPECT_EQ(GetFinestLevel(line), std::min(60 * filters, 255));
    EXPECT_EQ(CountKind(line, 1), line->GetNumberOfCells());
  }
}
