// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBasisFunctions.cxx
 * Basis functions: what becomes of an array that is 1 at one point and 0 at all others.
 */
#include "FeatureTools.h"

#include "vtkSurfaceSubdivision.h"

#include "vtkSubdivisionOperator.h"

using namespace feature_tools;

namespace
{

using Solids = vtkMultiDimensionalSubdivision;
using Surfaces = vtkSurfaceSubdivision;

template <typename FilterClass>
std::vector<double> FindBasis(FilterClass* filter, vtkDataSet* input, vtkIdType point)
{
  vtkNew<vtkDoubleArray> impulse;
  impulse->SetName("Impulse");
  impulse->SetNumberOfTuples(input->GetNumberOfPoints());
  impulse->Fill(0.);
  impulse->SetValue(point, 1.);
  const auto copy = vtkSmartPointer<vtkDataSet>::Take(input->NewInstance());
  copy->ShallowCopy(input);
  copy->GetPointData()->AddArray(impulse);
  filter->SetInputDataObject(copy);
  filter->Update();
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* array = output->GetPointData()->GetArray("Impulse");
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
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
