// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBasisFunctions.cxx
 * BasisPoint: what becomes of 1 at one point and 0 at all others.
 */
#include "FeatureTools.h"

#include "vtkSurfaceSubdivision.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkSubdivisionOperator.h"

using namespace feature_tools;

namespace
{

using Solids = vtkMultiDimensionalSubdivision;
using Surfaces = vtkSurfaceSubdivision;

std::vector<double> GetValues(vtkDataSet* output, const char* name = "BasisFunction")
{
  vtkDataArray* array = output->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

template <typename FilterClass>
std::vector<double> FindBasis(FilterClass* filter, vtkDataObject* input, vtkIdType point)
{
  filter->SetBasisPoint(point);
  filter->SetInputDataObject(input);
  filter->Update();
  return GetValues(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0)));
}

/// All basis functions add up to 1, and each is a column of the operator.
template <typename FilterClass>
void ExpectColumns(FilterClass* filter, vtkDataSet* input)
{
  vtkNew<vtkSubdivisionOperator> factors;
  filter->SetInputDataObject(input);
  ASSERT_TRUE(filter->ComputeOperator(factors));
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> columns;
  vtkNew<vtkDoubleArray> weights;
  factors->GetRows(offsets, columns, weights);
  const vtkIdType rows = factors->GetNumberOfRows();
  std::vector<double> sums(static_cast<std::size_t>(rows), 0.);
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    const std::vector<double> values = FindBasis(filter, input, point);
    ASSERT_EQ(static_cast<vtkIdType>(values.size()), rows);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      double weight = 0.;
      for (vtkIdType k = offsets->GetValue(row); k < offsets->GetValue(row + 1); ++k)
      {
        weight += columns->GetValue(k) == point ? weights->GetValue(k) : 0.;
      }
      ASSERT_NEAR(values[row], weight, 1e-13) << "point " << point << " row " << row;
      sums[row] += values[row];
    }
  }
  for (const double sum : sums)
  {
    EXPECT_NEAR(sum, 1., 1e-12);
  }
}

vtkSmartPointer<vtkPolyData> MakeSurface()
{
  const Grid fan = MakeFan(5);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(fan->GetPoints());
  surface->SetPolys(fan->GetCells());
  return surface;
}

}

TEST(BasisFunctions, AreColumnsOfTheOperatorAndAddUpToOne)
{
  for (const int scheme : { Solids::BOX_SPLINE, Solids::TET_OCT })
  {
    for (const bool limit : { false, true })
    {
      SCOPED_TRACE(testing::Message() << "volumes " << scheme << ", limit " << limit);
      vtkNew<Solids> filter;
      filter->SetVolumeScheme(scheme);
      filter->SetNumberOfLevels(1);
      filter->SetProjectToLimit(limit);
      ExpectColumns(filter.Get(), MakeKuhnBox(2));
    }
  }
  for (int scheme = Surfaces::LOOP; scheme <= Surfaces::LINEAR; ++scheme)
  {
    for (const bool limit : { false, true })
    {
      SCOPED_TRACE(testing::Message() << "surfaces " << scheme << ", limit " << limit);
      vtkNew<Surfaces> filter;
      filter->SetScheme(scheme);
      filter->SetNumberOfLevels(2);
      filter->SetProjectToLimit(limit);
      ExpectColumns(filter.Get(), MakeSurface());
    }
  }
}

TEST(BasisFunctions, AreWhatBecomesOfAnImpulse)
{
  const Grid box = MakeKuhnBox(3);
  vtkNew<vtkDoubleArray> impulse;
  impulse->SetName("Impulse");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    impulse->InsertNextValue(i == 21 ? 1. : 0.);
  }
  box->GetPointData()->AddArray(impulse);
  vtkNew<Solids> filter;
  filter->SetNumberOfLevels(2);
  EXPECT_TRUE(FindBasis(filter.Get(), box, -1).empty()); // off by default
  EXPECT_EQ(filter->GetBasisPoint(), -1);
  const std::vector<double> values = FindBasis(filter.Get(), box, 21);
  EXPECT_EQ(values, GetValues(filter->GetUnstructuredGridOutput(), "Impulse"));
  EXPECT_GT(*std::max_element(values.begin(), values.end()), 0.1);
  EXPECT_FALSE(box->GetPointData()->HasArray("BasisFunction")); // the input stays as it is
}

TEST(BasisFunctions, InterpolateOnRequest)
{
  const Grid box = MakeKuhnBox(3);
  vtkNew<Solids> filter;
  filter->SetNumberOfLevels(1);
  filter->SetProjectToLimit(true);
  filter->SetInterpolateArrays(true);
  const std::vector<double> values = FindBasis(filter.Get(), box, 21);
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(values[i], i == 21 ? 1. : 0., 1e-8);
  }
}

TEST(BasisFunctions, OfGlobalIdsInOneMeshAndInBlocks)
{
  const Grid box = MakeKuhnBox(3);
  vtkNew<Solids> filter;
  const std::vector<double> expected = FindBasis(filter.Get(), box, 21);
  const Grid named = DeepCopy(box);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    ids->InsertNextValue(1000 + 2 * i);
  }
  named->GetPointData()->SetGlobalIds(ids);
  EXPECT_EQ(FindBasis(filter.Get(), named, 1042), expected);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, named);
  filter->SetBasisPoint(1042);
  filter->SetInputDataObject(blocks);
  filter->Update();
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(made);
  EXPECT_EQ(GetValues(vtkDataSet::SafeDownCast(made->GetBlock(0))), expected);
}

TEST(BasisFunctions, AMissingPointIsSaid)
{
  const Grid box = MakeKuhnBox(1);
  vtkNew<Solids> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  for (const double value : FindBasis(filter.Get(), box, 8))
  {
    EXPECT_EQ(value, 0.);
  }
  EXPECT_EQ(messages->CountWarnings("BasisPoint is 8, but the input has no such point"), 1);
}
