// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestProlongation.cxx
 * The matrix from the nodes of curved cells to those of the next level: polynomials of the order of
 * the cells stay what they are, and so does the geometry of straight cells.
 */
#include "CurvedTools.h"
#include "vtkSubdivisionOperator.h"

using namespace curved_tools;

namespace
{

const std::vector<int> Orders{ 0, 1, 2, 3, 4, 5, 6 };

/// The matrix of a filter; no rows after an error.
struct NodeMatrix
{
  template <typename AnyFilter>
  explicit NodeMatrix(AnyFilter* filter)
  {
    vtkNew<vtkSubdivisionOperator> found;
    this->IsFound = filter->ComputeProlongation(found);
    found->GetRows(this->Offsets, this->Columns, this->Weights);
    this->NumberOfColumns = found->GetNumberOfColumns();
    this->NumberOfRows = found->GetNumberOfRows();
  }
  /// A value for each column in, for each row out.
  std::vector<double> Multiply(const std::vector<double>& values) const
  {
    std::vector<double> sums;
    for (vtkIdType i = 0; i < this->NumberOfRows; ++i)
    {
      sums.push_back(0.);
      for (vtkIdType k = this->Offsets->GetValue(i); k < this->Offsets->GetValue(i + 1); ++k)
      {
        sums.back() += this->Weights->GetValue(k) *
          values.at(static_cast<std::size_t>(this->Columns->GetValue(k)));
      }
    }
    return sums;
  }

  bool IsFound = false;
  vtkIdType NumberOfRows = 0;
  vtkIdType NumberOfColumns = 0;
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIdTypeArray> Columns;
  vtkNew<vtkDoubleArray> Weights;
};

/// A polynomial in the coordinates, with all terms of a degree and below.
std::vector<double> EvaluatePolynomial(vtkPointSet* grid, int degree)
{
  std::vector<double> values;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(grid, i);
    double sum = 0.;
    for (int a = 0; a <= degree; ++a)
    {
      for (int b = 0; a + b <= degree; ++b)
      {
        for (int c = 0; a + b + c <= degree; ++c)
        {
          sum += std::cos(1. + a + 3. * b + 7. * c) * std::pow(p[0], a) * std::pow(p[1], b) *
            std::pow(p[2], c);
        }
      }
    }
    values.push_back(sum);
  }
  return values;
}

double FindSize(const std::vector<double>& values)
{
  double most = 1.;
  for (const double x : values)
  {
    most = std::max(most, std::abs(x));
  }
  return most;
}

/// The matrix of a filter whose cells are straight and of the same shape as their parameters.
template <typename AnyFilter, typename Make>
void ExpectPolynomials(AnyFilter* filter, int levels, int degree, const Make& make)
{
  filter->SetNumberOfLevels(levels - 1);
  const Grid coarse = make(filter);
  filter->SetNumberOfLevels(levels);
  const Grid fine = make(filter);
  const NodeMatrix matrix(filter);
  ASSERT_TRUE(matrix.IsFound);
  EXPECT_EQ(filter->GetNumberOfLevels(), levels);
  ASSERT_EQ(matrix.NumberOfColumns, coarse->GetNumberOfPoints());
  ASSERT_EQ(matrix.NumberOfRows, fine->GetNumberOfPoints());
  for (int of = 0; of <= degree; ++of)
  {
    const std::vector<double> found = matrix.Multiply(EvaluatePolynomial(coarse, of));
    const std::vector<double> expected = EvaluatePolynomial(fine, of);
    const double size = FindSize(expected);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_NEAR(found[i], expected[i], 1e-12 * size) << i << ", degree " << of;
    }
  }
  // Other degrees tell cells of one order from another.
  const std::vector<double> found = matrix.Multiply(EvaluatePolynomial(coarse, 2 * degree + 2));
  const std::vector<double> expected = EvaluatePolynomial(fine, 2 * degree + 2);
  double most = 0.;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    most = std::max(most, std::abs(found[i] - expected[i]));
  }
  EXPECT_GT(most, 1e-9);
}

const auto MakeSolid = [](Filter* filter)
{
  filter->Update();
  const Grid copy = Grid::New();
  copy->DeepCopy(filter->GetOutput());
  return copy;
};

/// A box of all types of cells, whose cells are the images of their parameters by linear maps.
Grid MakeStraight(bool pyramids)
{
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ 2. * (i & 1), 1. * (i >> 1 & 1), 1. * (i >> 2) });
  }
  points.insert(points.end(), { { 3, 0.5, 0 }, { 3, 0.5, 1 }, { 1, 0.5, 1.5 }, { 0, 0.5, 2 } });
  std::vector<Cell> cells{ { VTK_HEXAHEDRON, { 0, 1, 3, 2, 4, 5, 7, 6 } },
    { VTK_WEDGE, { 1, 3, 8, 5, 7, 9 } }, { VTK_QUAD, { 0, 1, 3, 2 } },
    { VTK_TRIANGLE, { 1, 3, 8 } }, { VTK_LINE, { 0, 1 } }, { VTK_VERTEX, { 0 } } };
  if (pyramids)
  {
    cells.push_back({ VTK_PYRAMID, { 4, 5, 7, 6, 10 } });
    cells.push_back({ VTK_TETRA, { 4, 10, 6, 11 } });
  }
  return MakeGrid(points, cells);
}

}

TEST(Prolongation, SimplicesOfAllOrders)
{
  for (const int order : Orders)
  {
    for (const int levels : { 1, 2 })
    {
      if (levels == 2 && order > 4)
      {
        continue;
      }
      SCOPED_TRACE(testing::Message() << order << " " << levels);
      vtkNew<Filter> filter;
      filter->SetInputData(MakeUprightMixed());
      filter->SetVolumeSchemeToLinear();
      SetOrder(filter, order);
      ExpectPolynomials(filter.Get(), levels, order == 0 ? 2 : order, MakeSolid);
    }
  }
}

/// The four cells of an octahedron are no parts of such ones, but nodes have places in them.
TEST(Prolongation, CellsOfAllTypes)
{
  for (const int order : { 0, 1, 2, 4 })
  {
    for (const int levels : { 1, 2 })
    {
      SCOPED_TRACE(testing::Message() << order << " " << levels);
      vtkNew<Filter> filter;
      filter->SetVolumeSchemeToLinear();
      filter->KeepCellTypesOn();
      SetOrder(filter, order);
      filter->SetInputData(MakeStraight(false));
      ExpectPolynomials(filter.Get(), levels, order == 0 ? 2 : order, MakeSolid);
      filter->SetInputData(MakeUprightMixed()); // octahedra
      ExpectPolynomials(filter.Get(), levels, order == 0 ? 2 : order, MakeSolid);
      if (order == 0)
      {
        filter->SetInputData(MakeStraight(true));
        ExpectPolynomials(filter.Get(), levels, 1, MakeSolid);
      }
    }
  }
}

/// Sheets of squares with sharp corners stay flat, with even parameters, and so does all of LINEAR.
TEST(Prolongation, Surfaces)
{
  for (const int scheme : { vtkSurfaceSubdivision::LINEAR, vtkSurfaceSubdivision::CATMULL_CLARK })
  {
    for (const int order : Orders)
    {
      const bool isLinear = scheme == vtkSurfaceSubdivision::LINEAR;
      if (isLinear && order > 2 && order != 4)
      {
        continue; // cells stay linear
      }
      SCOPED_TRACE(testing::Message() << scheme << " " << order);
      vtkNew<vtkSurfaceSubdivision> filter;
      filter->SetScheme(scheme);
      filter->SetInputDataObject(bezier_tools::ToSurface(bezier_tools::MakeSheet(3, isLinear, 0.)));
      SetOrder(filter, order);
      const auto make = [](vtkSurfaceSubdivision* made)
      {
        made->Update();
        const Grid copy = Grid::New();
        copy->DeepCopy(made->GetUnstructuredGridOutput());
        return copy;
      };
      ExpectPolynomials(filter.Get(), 1, order == 0 ? 2 : order, make);
    }
  }
}

/// The places of nodes in cells do not depend on where they are.
TEST(Prolongation, AllSchemesOfSimplicesHaveOneMatrix)
{
  const auto make = [](int scheme, int order)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(MakeUprightMixed());
    filter->SetVolumeScheme(scheme);
    filter->SetNumberOfLevels(2);
    SetOrder(filter, order);
    return std::make_unique<NodeMatrix>(filter.Get());
  };
  for (const int order : { 0, 3, 4 })
  {
    const auto smooth = make(Filter::BOX_SPLINE, order);
    ASSERT_TRUE(smooth->IsFound);
    const auto straight = make(Filter::LINEAR, order);
    EXPECT_EQ(CompareValues(smooth->Offsets, straight->Offsets), "");
    EXPECT_EQ(CompareValues(smooth->Columns, straight->Columns), "");
    EXPECT_EQ(CompareValues(smooth->Weights, straight->Weights), "");
  }
}

/// With straight cells of order 1 the operator of one linear level is the prolongation, too.
TEST(Prolongation, OfOrderOneIsTheOperatorOfALinearLevel)
{
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToLinear();
  filter->SetInputData(
    Execute(MakeUprightMixed(), 1, [](Filter* f) { f->SetVolumeSchemeToLinear(); }));
  filter->SetNumberOfLevels(1);
  SetOrder(filter, 1);
  const NodeMatrix matrix(filter.Get());
  vtkNew<vtkSubdivisionOperator> step;
  ASSERT_TRUE(filter->ComputeOperator(step));
  std::vector<double> values;
  for (vtkIdType i = 0; i < step->GetNumberOfColumns(); ++i)
  {
    values.push_back(std::sin(1. + static_cast<double>(i)));
  }
  const std::vector<double> found = matrix.Multiply(values);
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> weights;
  step->GetRows(offsets, ids, weights);
  ASSERT_EQ(static_cast<vtkIdType>(found.size()), step->GetNumberOfRows());
  for (vtkIdType i = 0; i < step->GetNumberOfRows(); ++i)
  {
    double sum = 0.;
    for (vtkIdType k = offsets->GetValue(i); k < offsets->GetValue(i + 1); ++k)
    {
      sum += weights->GetValue(k) * values[static_cast<std::size_t>(ids->GetValue(k))];
    }
    EXPECT_NEAR(found[static_cast<std::size_t>(i)], sum, 1e-15);
  }
}

/// An output of some dimensions, or torn between materials, has nodes of its own.
TEST(Prolongation, DimensionsAndJumps)
{
  vtkNew<Filter> filter;
  filter->SetInputData(MakeUprightMixed());
  filter->SetVolumeSchemeToLinear();
  filter->ClearOutputDimensions();
  filter->AddOutputDimension(2);
  for (const int order : { 2, 3 })
  {
    SetOrder(filter, order);
    ExpectPolynomials(filter.Get(), 1, order, MakeSolid);
  }
  const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 4, 2, 3 } } });
  for (const char* name : { "MaterialId", "Density" })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(1.);
    array->InsertNextValue(2.);
    input->GetCellData()->AddArray(array);
  }
  vtkNew<Filter> torn;
  torn->SetInputData(input);
  torn->SetVolumeSchemeToLinear();
  torn->PreserveInterfacesOn();
  torn->SetInterfaceValuesToDiscontinuous();
  torn->AddFieldOfCells("Density");
  SetOrder(torn, 0);
  ExpectPolynomials(torn.Get(), 1, 2, MakeSolid);
  torn->SetNumberOfLevels(0);
  std::vector<double> density;
  MakeSolid(torn);
  for (vtkIdType i = 0; i < torn->GetOutput()->GetNumberOfPoints(); ++i)
  {
    density.push_back(torn->GetOutput()->GetPointData()->GetArray("Density")->GetComponent(i, 0));
  }
  torn->SetNumberOfLevels(1);
  torn->Update();
  const std::vector<double> found = NodeMatrix(torn.Get()).Multiply(density);
  ASSERT_EQ(static_cast<vtkIdType>(found.size()), torn->GetOutput()->GetNumberOfPoints());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i],
      torn->GetOutput()->GetPointData()->GetArray("Density")->GetComponent(
        static_cast<vtkIdType>(i), 0),
      1e-12);
  }
}

TEST(Prolongation, ErrorsNameTheCure)
{
  const auto expect = [](auto* filter, const char* text)
  {
    vtkNew<Messages> messages;
    messages->Watch(filter);
    EXPECT_FALSE(NodeMatrix(filter).IsFound);
    ASSERT_GE(messages->Errors.size(), 1u) << text;
    EXPECT_NE(messages->Errors[0].find(text), std::string::npos) << messages->Errors[0];
  };
  vtkNew<Filter> filter;
  filter->SetInputData(MakeUprightMixed());
  expect(filter.Get(), "set OutputCells to Quadratic or Lagrange");
  SetOrder(filter, 0);
  filter->SetNumberOfLevels(0);
  expect(filter.Get(), "NumberOfLevels to 1 or more");
  vtkNew<vtkSurfaceSubdivision> surface;
  surface->SetSchemeToCatmullClark();
  surface->SetInputDataObject(bezier_tools::ToSurface(bezier_tools::MakeSheet(3, true, 0.)));
  SetOrder(surface, 0);
  expect(surface.Get(), "Take one level more");
  surface->SetNumberOfLevels(2);
  EXPECT_TRUE(NodeMatrix(surface.Get()).IsFound);
}
