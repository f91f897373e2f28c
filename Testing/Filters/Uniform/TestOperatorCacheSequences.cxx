// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestOperatorCacheSequences.cxx
 * Composite input, and random sequences of edits: the output is that of a fresh filter.
 */
#include "OperatorCacheTools.h"

using namespace operator_cache_tools;

// ---------------------------------------------------------------- composite input

namespace
{

void ExpectBlocks(Kept& filter, const std::vector<Grid>& grids, const Configure& configure = {})
{
  filter->JoinBlocksOff();
  filter->SetInputDataObject(MakeBlocks(grids));
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  ASSERT_EQ(output->GetNumberOfBlocks(), grids.size());
  for (unsigned i = 0; i < grids.size(); ++i)
  {
    auto* block = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(i));
    ASSERT_TRUE(block);
    EXPECT_EQ(Compare(block, Fresh(grids[i], configure)), "") << i;
  }
}

}

TEST(OperatorCache, BlocksHaveOperatorsOfTheirOwn)
{
  std::vector<Grid> grids = { MakeInput(1), MakeFan(6), MakeOctahedron() };
  Kept filter;
  ExpectBlocks(filter, grids);
  EXPECT_EQ(filter.CountBuilds(), 3);
  EXPECT_TRUE(HoldsOperators(filter.Get(), 3));
  grids[0] = DeepCopy(grids[0]);
  grids[0]->GetPointData()->GetArray("scalar")->Fill(2.);
  ExpectBlocks(filter, grids);
  EXPECT_EQ(filter.CountBuilds(), 0);
  grids[1] = MakeFan(7);
  ExpectBlocks(filter, grids);
  EXPECT_EQ(filter.CountBuilds(), 1);
  EXPECT_TRUE(HoldsOperators(filter.Get(), 3)); // the old one is forgotten
  ExpectBlocks(filter, { grids[2], grids[0] });
  EXPECT_EQ(filter.CountBuilds(), 0);
  EXPECT_TRUE(HoldsOperators(filter.Get(), 2));
}

TEST(OperatorCache, BlocksOfEqualCellsAndOtherShapes)
{
  // Twins in topology, of which only one has features.
  const Grid flat = MakeFan(6);
  const Grid steep = MakeFan(6);
  MovePoint(steep, 0, 0, 0, 3.);
  const Configure detect = [](Filter* f) { f->DetectFeaturesOn(); };
  Kept filter(detect);
  ExpectBlocks(filter, { flat, steep, flat }, detect);
  filter.CountBuilds();
  for (int i = 0; i < 3; ++i)
  {
    ExpectBlocks(filter, { flat, steep, flat }, detect);
    EXPECT_EQ(filter.CountBuilds(), 0);
  }
}

TEST(OperatorCache, BlocksOfEqualCellsShareTheirPoints)
{
  const std::vector<Grid> grids = { MakeFan(6), MakeFan(6) };
  MovePoint(grids[1], 0, 0, 0, 1.);
  Kept filter;
  std::vector<vtkDataArray*> points[2];
  for (auto& list : points)
  {
    ExpectBlocks(filter, grids);
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    for (unsigned i = 0; i < 2; ++i)
    {
      auto* block = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(i));
      block->GetPoints()->GetData()->Register(nullptr); // so that no address comes again
      list.push_back(block->GetPoints()->GetData());
    }
  }
  EXPECT_EQ(points[0], points[1]);
  for (const auto& list : points)
  {
    for (vtkDataArray* array : list)
    {
      array->UnRegister(nullptr);
    }
  }
}

// ---------------------------------------------------------------- random sequences

namespace
{

/// One edit of a mesh or of the options; the same for the kept filter and the fresh one.
class Editor
{
public:
  explicit Editor(unsigned seed)
    : Random(seed)
    , Input(MakeRandomComplex(seed))
  {
    AddArrays(this->Input);
  }
  void Edit()
  {
    vtkUnstructuredGrid* grid = this->Input;
    const int n = static_cast<int>(grid->GetNumberOfPoints());
    const int cells = static_cast<int>(grid->GetNumberOfCells());
    const char* names[4] = { "Singular", "MaterialId", "Part", "Rule" };
    switch (this->Draw(12))
    {
      case 0:
        MovePoint(grid, this->Draw(n), 0.1 * this->Draw(30), 0.1 * this->Draw(30), 0.4);
        break;
      case 1: // a little
        MovePoint(grid, this->Draw(n), 0.3, 0.4 + 1e-9 * this->Draw(100), 0.2);
        break;
      case 2: // and nobody is told
        this->SwapPointsOfCells();
        break;
      case 3:
      case 4:
      {
        const int index = this->Draw(4);
        vtkDataArray* array = grid->GetCellData()->GetArray(names[index]);
        const int cell = this->Draw(cells);
        const bool solid = grid->GetCellType(cell) == VTK_TETRA;
        array->SetTuple1(cell, index == 0 && solid ? 0 : this->Draw(index == 0 ? 2 : 4));
        break;
      }
      case 5:
        this->Seed = this->Random();
        break;
      case 6:
        this->Levels = this->Draw(3);
        break;
      case 7:
        this->Precision = this->Draw(3);
        break;
      case 8:
        this->Narrow = !this->Narrow;
        break;
      case 9:
        this->Original = !this->Original;
        break;
      case 10:
        this->Angle = 20. * this->Draw(9);
        break;
      default:
        grid->GetPointData()->GetArray("double")->SetComponent(this->Draw(n), 1, this->Draw(9));
        break;
    }
  }
  void Configure(Filter* filter) const
  {
    RandomOptions(this->Seed)(filter);
    filter->SetNumberOfLevels(this->Levels);
    filter->SetOutputPointsPrecision(this->Precision);
    filter->SetUse32BitIds(this->Narrow);
    filter->SetGenerateOriginalIds(this->Original);
    filter->SetGenerateClassification(this->Original || this->Narrow);
    filter->SetFeatureAngle(this->Angle);
  }
  vtkUnstructuredGrid* GetInput() const { return this->Input; }

private:
  int Draw(int n) { return static_cast<int>((this->Random() >> 8) % static_cast<unsigned>(n)); }
  void SwapPointsOfCells()
  {
    vtkDataArray* ids = this->Input->GetCells()->GetConnectivityArray();
    const int n = static_cast<int>(this->Input->GetNumberOfPoints());
    const vtkIdType a = this->Draw(n);
    const vtkIdType b = this->Draw(n);
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
      ids->SetComponent(i, 0, static_cast<double>(id == a ? b : id == b ? a : id));
    }
  }

  std::mt19937 Random;
  Grid Input;
  unsigned Seed = 0;
  int Levels = 1;
  int Precision = vtkAlgorithm::DEFAULT_PRECISION;
  bool Narrow = false;
  bool Original = false;
  double Angle = 30.;
};

}

TEST(OperatorCache, OutputIsThatOfAFreshFilter)
{
  vtkIdType builds = 0;
  int updates = 0;
  for (unsigned seed = 0; seed < 25; ++seed)
  {
    Editor editor(seed);
    vtkNew<Filter> filter;
    for (int i = 0; i < 60; ++i)
    {
      editor.Edit();
      filter->SetInputData(editor.GetInput());
      editor.Configure(filter);
      filter->Modified();
      vtkNew<Messages> heard; // both may say the same
      heard->Watch(filter);
      filter->Update();
      filter->RemoveObserver(heard);
      vtkNew<Messages> own;
      const Grid fresh = Execute(
        editor.GetInput(), 1,
        [&editor](Filter* f)
        {
          editor.Configure(f);
          f->CacheOperatorOff();
        },
        own);
      ASSERT_EQ(Compare(filter->GetOutput(), fresh), "") << seed << " " << i;
      ASSERT_EQ(
        filter->GetOutput()->GetCells()->IsStorage64Bit(), fresh->GetCells()->IsStorage64Bit());
      ASSERT_TRUE(own->Errors.empty());
      ++updates;
    }
    builds += filter->GetNumberOfTopologyBuilds();
  }
  EXPECT_GT(builds, updates / 4); // both happened often enough
  EXPECT_LT(builds, updates * 3 / 4);
}
