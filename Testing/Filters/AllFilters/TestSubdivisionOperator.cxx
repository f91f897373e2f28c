// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionOperator.cxx
 * What filters do to points as a matrix: its factors give the bits of the output, the matrix itself
 * the output but for rounding.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSubdivisionModelSource.h"
#include "vtkSubdivisionOperator.h"
#include "vtkSurfaceSubdivision.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

struct Matrix
{
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIdTypeArray> Ids;
  vtkNew<vtkDoubleArray> Weights;

  vtkIdType GetNumberOfRows() const { return this->Offsets->GetNumberOfTuples() - 1; }
  std::vector<double> Multiply(const std::vector<double>& values, int components) const
  {
    std::vector<double> result;
    for (vtkIdType row = 0; row < this->GetNumberOfRows(); ++row)
    {
      for (int c = 0; c < components; ++c)
      {
        double sum = 0.;
        for (vtkIdType k = this->Offsets->GetValue(row); k < this->Offsets->GetValue(row + 1); ++k)
        {
          sum += this->Weights->GetValue(k) * values.at(this->Ids->GetValue(k) * components + c);
        }
        result.push_back(sum);
      }
    }
    return result;
  }
};

std::vector<double> GetValues(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    values.push_back(array->GetVariantValue(i).ToDouble());
  }
  return values;
}

Grid MakeModel(int model)
{
  return InDouble(LoadModel(model));
}

/// Compares the matrices of a filter with what it makes of its input. `rounds`: the factors do,
/// too.
template <typename Filter>
void CheckMatrices(Filter* filter, vtkPointSet* input, bool rounds = false)
{
  filter->SetInputData(input);
  vtkNew<vtkSubdivisionOperator> found;
  ASSERT_TRUE(filter->ComputeOperator(found));
  filter->Update();
  const std::vector<double> expected = GetValues(filter->GetOutput()->GetPoints()->GetData());
  std::vector<double> values = GetValues(input->GetPoints()->GetData());
  ASSERT_EQ(found->GetNumberOfColumns(), input->GetNumberOfPoints());
  ASSERT_EQ(found->GetNumberOfRows(), filter->GetOutput()->GetNumberOfPoints());

  Matrix product;
  found->GetRows(product.Offsets, product.Ids, product.Weights);
  const std::vector<double> rounded = product.Multiply(values, 3);
  const double size = std::max(1., input->GetLength());
  ASSERT_EQ(rounded.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_NEAR(rounded[i], expected[i], 1e-14 * size) << i;
  }
  for (vtkIdType row = 0; row < product.GetNumberOfRows(); ++row)
  {
    std::set<vtkIdType> columns;
    double sum = 0.;
    for (vtkIdType k = product.Offsets->GetValue(row); k < product.Offsets->GetValue(row + 1); ++k)
    {
      ASSERT_TRUE(columns.insert(product.Ids->GetValue(k)).second) << row;
      sum += product.Weights->GetValue(k);
    }
    ASSERT_NEAR(sum, 1., 1e-14) << row;
  }

  ASSERT_GE(found->GetNumberOfFactors(), 1);
  for (int i = 0; i < found->GetNumberOfFactors(); ++i)
  {
    Matrix factor;
    found->GetFactor(i, factor.Offsets, factor.Ids, factor.Weights);
    values = factor.Multiply(values, 3);
  }
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_NEAR(values[i], expected[i], rounds ? 1e-14 * size : 0.) << i;
  }
}

using Solids = vtkMultiDimensionalSubdivision;
using Surfaces = vtkSurfaceSubdivision;

}

TEST(SubdivisionOperator, AllModelsAndSchemes)
{
  for (int model = 0; model <= vtkSubdivisionModelSource::CYLINDER; ++model)
  {
    const Grid input = MakeModel(model);
    for (const int scheme : { Solids::BOX_SPLINE, Solids::TET_OCT, Solids::LINEAR })
    {
      for (const int levels : { 0, 1, 2 })
      {
        for (const bool limit : { false, true })
        {
          SCOPED_TRACE(testing::Message() << model << " " << scheme << " " << levels << limit);
          vtkNew<Solids> filter;
          filter->SetVolumeScheme(scheme);
          filter->SetNumberOfLevels(levels);
          filter->SetProjectToLimit(limit);
          CheckMatrices(filter.Get(), input);
        }
      }
    }
  }
}

TEST(SubdivisionOperator, SemiSharpCreases)
{
  const Grid input = MakeModel(vtkSubdivisionModelSource::MECHANICAL_PART);
  const auto sharpness =
    MakeArray<vtkDoubleArray>("Sharpness", 1, input->GetNumberOfCells(), 0., 3.5, 1);
  const auto singular = vtkSmartPointer<vtkIntArray>::New();
  singular->SetName("Singular");
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    singular->InsertNextValue(input->GetCellType(i) == VTK_LINE);
  }
  input->GetCellData()->AddArray(sharpness);
  input->GetCellData()->AddArray(singular);
  for (const bool limit : { false, true })
  {
    vtkNew<Solids> filter;
    filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
    filter->SetEmbeddedCells(Solids::SINGULAR);
    filter->SetNumberOfLevels(2);
    filter->SetProjectToLimit(limit);
    CheckMatrices(filter.Get(), input);
  }
}

TEST(SubdivisionOperator, CentresOfSplitCells)
{
  const Grid input = MakeMixedBox(2);
  vtkNew<Solids> filter;
  filter->SetVolumeSchemeToBoxSpline();
  CheckMatrices(filter.Get(), input, true);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), input->GetNumberOfPoints());
}

TEST(SubdivisionOperator, AfterAnotherFilter)
{
  vtkNew<Solids> first;
  first->SetInputData(MakeModel(vtkSubdivisionModelSource::SPRING_AND_VALVE));
  first->SetVolumeSchemeToTetOct();
  first->Update();
  vtkNew<Solids> second;
  second->SetVolumeSchemeToTetOct();
  CheckMatrices(second.Get(), first->GetOutput());
}

TEST(SubdivisionOperator, KeptOperators)
{
  const Grid input = MakeModel(vtkSubdivisionModelSource::SPRING_AND_VALVE);
  for (const bool cache : { false, true })
  {
    vtkNew<Solids> filter;
    filter->SetCacheOperator(cache);
    filter->SetNumberOfLevels(3); // without a cache the last two steps are made at once
    CheckMatrices(filter.Get(), input);
    CheckMatrices(filter.Get(), input);
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), cache ? 1 : 0);
  }
}

TEST(SubdivisionOperator, AllSurfaceSchemes)
{
  for (int scheme = Surfaces::LOOP; scheme <= Surfaces::LINEAR; ++scheme)
  {
    for (const bool limit : { false, true })
    {
      SCOPED_TRACE(testing::Message() << scheme << limit);
      vtkNew<vtkPolyData> input;
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      vtkNew<vtkCellArray> polys;
      for (int i = 0; i < 25; ++i)
      {
        points->InsertNextPoint(i % 5 + 0.1 * (i % 3), i / 5 + 0.1 * (i % 4), std::sin(i));
      }
      for (vtkIdType i = 0; i < 19; ++i)
      {
        if (i % 5 < 4)
        {
          polys->InsertNextCell({ i, i + 1, i + 6 });
          polys->InsertNextCell({ i, i + 6, i + 5 });
        }
      }
      input->SetPoints(points);
      input->SetPolys(polys);
      vtkNew<Surfaces> filter;
      filter->SetScheme(scheme);
      filter->SetNumberOfLevels(2);
      filter->SetProjectToLimit(limit);
      CheckMatrices(filter.Get(), input);
    }
  }
}

/// Points follow the surface that is joined at the seam of a texture.
TEST(SubdivisionOperator, Seams)
{
  vtkNew<vtkPolyData> input;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> texture;
  texture->SetNumberOfComponents(2);
  for (int i = 0; i < 12; ++i)
  {
    const int x = i < 6 ? i % 3 : i % 3 + 2; // points 2, 5 and 6, 9 are the same
    points->InsertNextPoint(x, i / 3 % 2, 0.1 * x * x);
    texture->InsertNextTuple2(i < 6 ? 0. : 1., 0.);
  }
  vtkNew<vtkCellArray> polys;
  for (const vtkIdType i : { 0, 1, 6, 7 })
  {
    polys->InsertNextCell({ i, i + 1, i + 4, i + 3 });
  }
  input->SetPoints(points);
  input->SetPolys(polys);
  input->GetPointData()->SetTCoords(texture);
  vtkNew<Surfaces> filter;
  filter->SetScheme(Surfaces::CATMULL_CLARK);
  filter->SetNumberOfLevels(2);
  CheckMatrices(filter.Get(), input);
  filter->ProjectToLimitOn();
  CheckMatrices(filter.Get(), input);
  const std::vector<double> joined = GetValues(filter->GetOutput()->GetPoints()->GetData());
  filter->JoinSeamsOff();
  CheckMatrices(filter.Get(), input);
  EXPECT_NE(GetValues(filter->GetOutput()->GetPoints()->GetData()), joined);
}

TEST(SubdivisionOperator, WhatHasNone)
{
  const Grid grid = MakeModel(vtkSubdivisionModelSource::SPRING_AND_VALVE);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, grid);
  vtkNew<vtkSubdivisionOperator> found;
  const auto fails = [&found](Solids* filter, const char* part)
  {
    vtkNew<Messages> messages;
    messages->Watch(filter);
    EXPECT_FALSE(filter->ComputeOperator(found)) << part;
    EXPECT_EQ(found->GetNumberOfRows(), 0) << part;
    EXPECT_TRUE(!messages->Errors.empty() && messages->Errors[0].find(part) != std::string::npos)
      << part;
  };
  vtkNew<Solids> filter;
  fails(filter, "the input is missing");
  filter->SetInputDataObject(blocks);
  fails(filter, "consists of blocks");
  filter->SetInputDataObject(grid);
  filter->InterpolatePointsOn();
  fails(filter, "InterpolatePoints");
  filter->InterpolatePointsOff();
  filter->SetMaximumNumberOfCells(10);
  fails(filter, "MaximumNumberOfCells");
  filter->SetMaximumNumberOfCells(1000000);
  EXPECT_TRUE(filter->ComputeOperator(found));
  EXPECT_GT(found->GetNumberOfRows(), grid->GetNumberOfPoints());
}
