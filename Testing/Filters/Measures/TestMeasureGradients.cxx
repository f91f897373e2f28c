// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMeasureGradients.cxx
 * Derivatives of vtkSubdivisionMeasures by control points, values and densities, against
 * differences.
 */
#include "HybridFilterTools.h"
#include "MeasureTools.h"

#include "vtkMultiBlockDataSet.h"

using namespace measure_tools;

namespace
{

/// Points that are moved a little, so that no choice of a rule is near to another one, and arrays.
Grid AddArrays(const Grid& mesh)
{
  const Grid made = Grid::New();
  made->DeepCopy(mesh);
  made->GetPointData()->Initialize();
  made->GetCellData()->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> density;
  density->SetName("Density");
  vtkNew<vtkDoubleArray> values;
  values->SetName("Value");
  values->SetNumberOfComponents(2);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double at[3];
    mesh->GetPoint(p, at);
    for (int x = 0; x < 3; ++x)
    {
      at[x] += 0.03 * std::sin(7. * double(p) + 3. * x);
    }
    points->InsertNextPoint(at);
    density->InsertNextValue(1. + 0.3 * std::sin(double(p)));
    values->InsertNextTuple2(std::cos(2. * double(p)), at[0] - at[1] * at[2]);
  }
  made->SetPoints(points);
  made->GetPointData()->AddArray(density);
  made->GetPointData()->AddArray(values);
  std::vector<int> materials;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    materials.push_back(int(c % 2));
  }
  AddCellArray(made, "MaterialId", materials);
  return made;
}

struct Number
{
  const char* Name;
  int Component;
};

constexpr Number Numbers[] = { { "Measure", 0 }, { "Mass", 0 }, { "ValueIntegral", 0 },
  { "ValueIntegral", 1 }, { "DensityIntegral", 0 } };
using Row = std::array<double, 5>; ///< of these numbers

/// The derivatives of all rows by a number that `move` changes, by five places: exact for
/// polynomials of degree 4.
std::vector<Row> FindDifferences(
  vtkSubdivisionMeasures* filter, const Grid& mesh, const std::function<void(double)>& move)
{
  constexpr double step = 1e-3;
  std::vector<Row> sums;
  for (const auto& [steps, weight] : { std::make_pair(-2, 1.), std::make_pair(-1, -8.),
         std::make_pair(1, 8.), std::make_pair(2, -1.) })
  {
    move(steps * step);
    mesh->GetPoints()->Modified();
    mesh->GetPointData()->Modified();
    mesh->Modified();
    const Table table = Measure(filter, mesh, { "give way" });
    sums.resize(table->GetNumberOfRows(), Row{});
    for (std::size_t row = 0; row < sums.size(); ++row)
    {
      for (std::size_t i = 0; i < sums[row].size(); ++i)
      {
        sums[row][i] += weight / (12. * step) *
          Get(table, Numbers[i].Name, static_cast<vtkIdType>(row), Numbers[i].Component);
      }
    }
  }
  move(0.);
  mesh->Modified();
  return sums;
}

/// Of all rows, by every `stride`th point.
void Check(vtkSubdivisionMeasures* filter, const Grid& mesh, vtkIdType stride)
{
  const Table table = Measure(filter, mesh, { "give way" });
  std::vector<vtkSmartPointer<vtkPointData>> found;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    found.push_back(vtkSmartPointer<vtkPointData>::New());
    ASSERT_TRUE(filter->ComputeGradients(row, found.back()));
  }
  const auto get = [&](std::size_t row, const char* name, vtkIdType point, int component = 0)
  {
    vtkDataArray* const array = found[row]->GetArray(name);
    EXPECT_TRUE(array && array->GetNumberOfTuples() == mesh->GetNumberOfPoints()) << name;
    return array ? array->GetComponent(point, component) : 0.;
  };
  const auto check = [&](const std::vector<Row>& expected, const auto& own)
  {
    ASSERT_EQ(expected.size(), found.size());
    for (std::size_t row = 0; row < expected.size(); ++row)
    {
      const Row derivatives = own(row);
      for (std::size_t i = 0; i < derivatives.size(); ++i)
      {
        EXPECT_NEAR(derivatives[i], expected[row][i], 1e-7) << Numbers[i].Name << ", row " << row;
      }
    }
  };
  double largest = 0.;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); p += stride)
  {
    SCOPED_TRACE(testing::Message() << "point " << p);
    const Point at = GetPoint(mesh, p);
    for (int x = 0; x < 3; ++x)
    {
      const auto move = [&](double step)
      {
        Point moved = at;
        moved[x] += step;
        mesh->GetPoints()->SetPoint(p, moved.data());
      };
      check(FindDifferences(filter, mesh, move),
        [&](std::size_t row)
        {
          largest = std::max(largest, std::abs(get(row, "MeasureByPoints", p, x)));
          return Row{ get(row, "MeasureByPoints", p, x), get(row, "MassByPoints", p, x),
            get(row, "ValueIntegralByPoints", p, x), get(row, "ValueIntegralByPoints", p, 3 + x),
            get(row, "DensityIntegralByPoints", p, x) };
        });
    }
    const auto change = [&](const char* name, int component)
    {
      vtkDataArray* const array = mesh->GetPointData()->GetArray(name);
      const double before = array->GetComponent(p, component);
      return FindDifferences(filter, mesh,
        [=](double step)
        {
          array->SetComponent(p, component, before + step);
          array->Modified();
        });
    };
    check(change("Value", 1),
      [&](std::size_t row) { return Row{ 0., 0., 0., get(row, "ValueIntegralByValues", p), 0. }; });
    check(change("Density", 0),
      [&](std::size_t row)
      {
        return Row{ 0., get(row, "MassByDensity", p), get(row, "ValueIntegralByDensity", p, 0),
          get(row, "ValueIntegralByDensity", p, 1),
          get(row, "DensityIntegralByValues", p) + get(row, "DensityIntegralByDensity", p) };
      });
  }
  EXPECT_GT(largest, 0.1);
}

}

TEST(MeasureGradients, AreDifferencesOfTheNumbers)
{
  const Grid mesh = AddArrays(hybrid_filter_tools::MakeAllTypes());
  for (const int scheme :
    { vtkMultiDimensionalSubdivision::BOX_SPLINE, vtkMultiDimensionalSubdivision::HYBRID })
  {
    SCOPED_TRACE(testing::Message() << "scheme " << scheme);
    vtkNew<vtkSubdivisionMeasures> filter;
    filter->SetVolumeScheme(scheme);
    filter->SetMaximumLevel(2);
    filter->SetTolerance(0.);
    SetDensity(filter, "Density");
    Check(filter, mesh, mesh->GetNumberOfPoints() / 2);
  }
}

/// Of surfaces and curves, and of a solid that is turned inside out, on three more levels.
TEST(MeasureGradients, OfAllDimensionsAreDifferences)
{
  const Grid mesh = AddArrays(
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0.3 }, { 0, 1, 0 }, { 2, 0, 1 }, { 3, 1, 1 },
               { 4, 0, 0 }, { 3, -1, 0 }, { 0, 0, 3 }, { 1, 0, 3 }, { 0, 1, 3 }, { 0, 0, 4 } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 2, 3 } }, { VTK_LINE, { 4, 5 } },
        { VTK_LINE, { 5, 6 } }, { VTK_LINE, { 6, 7 } }, { VTK_TETRA, { 9, 8, 10, 11 } } }));
  vtkNew<vtkSubdivisionMeasures> filter;
  filter->SetMaximumLevel(4);
  filter->SetTolerance(0.);
  SetDensity(filter, "Density");
  Check(filter, mesh, 3);
  const vtkIdType row = FindRow(Measure(filter, mesh), 3);
  vtkNew<vtkPointData> found;
  ASSERT_TRUE(filter->ComputeGradients(row, found));
  // Moved up, the tip makes the volume larger, whatever the cell's orientation is.
  EXPECT_GT(found->GetArray("MeasureByPoints")->GetComponent(11, 2), 1e-3);
}

/// What dimensions the output has does not matter, and without a density there is less.
TEST(MeasureGradients, FollowTheOptions)
{
  const Grid mesh = AddArrays(hybrid_filter_tools::MakeAllTypes());
  vtkNew<vtkSubdivisionMeasures> filter;
  filter->SetMaximumLevel(2);
  filter->SetOutputDimensions(vtkMultiDimensionalSubdivision::TETRAHEDRA);
  Measure(filter, mesh, { "give way" });
  vtkNew<vtkPointData> found;
  ASSERT_TRUE(filter->ComputeGradients(0, found));
  EXPECT_EQ(filter->GetOutputDimensions(), int(vtkMultiDimensionalSubdivision::TETRAHEDRA));
  EXPECT_EQ(found->GetNumberOfArrays(), 5);
  EXPECT_FALSE(found->GetArray("MassByPoints"));
  EXPECT_EQ(found->GetArray("ValueIntegralByPoints")->GetNumberOfComponents(), 6);
  // Moved together, points change nothing.
  for (int x = 0; x < 3; ++x)
  {
    double sum = 0.;
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      sum += found->GetArray("MeasureByPoints")->GetComponent(p, x);
    }
    EXPECT_NEAR(sum, 0., 1e-10);
  }
}

TEST(MeasureGradients, NeedARowAndOneMesh)
{
  const Grid mesh = AddArrays(hybrid_filter_tools::MakeAllTypes());
  const auto fail = [](vtkDataObject* input, vtkIdType row)
  {
    vtkNew<vtkSubdivisionMeasures> filter;
    filter->SetMaximumLevel(1);
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(input);
    vtkNew<vtkPointData> found;
    EXPECT_FALSE(filter->ComputeGradients(row, found));
    EXPECT_EQ(found->GetNumberOfArrays(), 0);
    return messages->Errors.empty() ? std::string() : messages->Errors.front();
  };
  EXPECT_NE(fail(mesh, 99).find("There is no row 99: the table has "), std::string::npos);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, mesh);
  EXPECT_NE(fail(blocks, 0).find("one mesh in this process"), std::string::npos);
}
