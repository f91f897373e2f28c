// SPDX-License-Identifier: BSD-3-Clause
// Cell data where new cells lie in several old ones (Mathematics 1): regions keep their areas, and
// filters in a row give what one filter gives.
#include "Core/Surfaces/Mesh/Carriers.h"
#include "SurfaceTools.h"

#include "vtkCallbackCommand.h"
#include "vtkStringArray.h"

using namespace surfacetools;
using multi_dimensional_subdivision_tools::GetPoint;

namespace
{

using Data = vtkSmartPointer<vtkPolyData>;

constexpr const char* Numbers = "Number";

/// With its own number for each cell, as an integer and as text.
Data MakeNumbered(const Model& model)
{
  const Data input = MakeInput(model);
  vtkNew<vtkIntArray> numbers;
  vtkNew<vtkStringArray> names;
  numbers->SetName(Numbers);
  names->SetName("Name");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    // Neither ascending nor the same for two cells.
    const int number = static_cast<int>((7 * cell + 3) % 101);
    numbers->InsertNextValue(number);
    names->InsertNextValue("cell " + std::to_string(number));
  }
  input->GetCellData()->AddArray(numbers);
  input->GetCellData()->AddArray(names);
  return input;
}

std::vector<int> GetNumbers(vtkPolyData* data)
{
  vtkDataArray* array = data->GetCellData()->GetArray(Numbers);
  std::vector<int> numbers(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = static_cast<int>(array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return numbers;
}

double GetArea(vtkPolyData* data, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(cell, ids);
  Point normal{};
  const Point origin = GetPoint(data, ids->GetId(0));
  for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i)
  {
    const Point a = GetPoint(data, ids->GetId(i));
    const Point b = GetPoint(data, ids->GetId(i + 1));
    for (int c = 0; c < 3; ++c)
    {
      const int d = (c + 1) % 3;
      const int e = (c + 2) % 3;
      normal[c] +=
        0.5 * ((a[d] - origin[d]) * (b[e] - origin[e]) - (a[e] - origin[e]) * (b[d] - origin[d]));
    }
  }
  return std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
}

/// The part of the area that each number has, and that of cells at a point with several numbers.
std::map<int, double> GetShares(vtkPolyData* data, double& seam)
{
  const std::vector<int> numbers = GetNumbers(data);
  std::vector<std::set<int>> atPoints(data->GetNumberOfPoints());
  vtkNew<vtkIdList> ids;
  auto visit = [&](vtkIdType cell, const auto& use)
  {
    data->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      use(ids->GetId(i));
    }
  };
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    visit(cell, [&](vtkIdType point) { atPoints[point].insert(numbers[cell]); });
  }
  std::map<int, double> shares;
  double all = 0.;
  seam = 0.;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const double area = GetArea(data, cell);
    bool isAtSeam = false;
    visit(cell, [&](vtkIdType point) { isAtSeam = isAtSeam || atPoints[point].size() > 1; });
    shares[numbers[cell]] += area;
    seam += isAtSeam ? area : 0.;
    all += area;
  }
  for (auto& share : shares)
  {
    share.second /= all;
  }
  seam /= all;
  return shares;
}

/// Of side 2 around the origin.
Model MakeCube()
{
  Model cube = MakeZoo(false)["cube"];
  for (int i = 0; i < 8; ++i)
  {
    const bool isRight = i % 4 == 1 || i % 4 == 2;
    cube.Points[i] = { isRight ? 1. : -1., i % 4 < 2 ? -1. : 1., i < 4 ? -1. : 1. };
  }
  return cube;
}

/// Nobody is to hear that polygons are split.
void BeQuiet(vtkSurfaceSubdivision* filter)
{
  vtkNew<vtkCallbackCommand> ear;
  ear->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  filter->AddObserver(vtkCommand::WarningEvent, ear);
}

Data Refine(vtkPolyData* input, int scheme, int levels, bool withIds = false)
{
  return RunFilter(input, scheme, levels, false,
    [withIds](vtkSurfaceSubdivision* filter)
    {
      BeQuiet(filter);
      filter->SetGenerateOriginalIds(withIds);
    });
}

class SurfaceCarriers : public testing::TestWithParam<int>
{
};

TEST_P(SurfaceCarriers, RegionsOfACubeKeepTheirAreas)
{
  const Data cube = MakeNumbered(MakeCube());
  for (int levels = 1; levels <= 6; ++levels)
  {
    double seam = 0.;
    const auto shares = GetShares(Refine(cube, GetParam(), levels), seam);
    EXPECT_TRUE(shares.size() == 6u || levels == 1) << levels; // then all cells may be at seams
    for (const auto& share : shares)
    {
      // The true border runs through the cells at the seam: each region has about a sixth of them.
      EXPECT_NEAR(share.second, 1. / 6., seam / 6. + 1e-6) << levels;
    }
  }
}

/// Whether a point of the plane lies in a convex polygon, or on its border.
bool IsIn(const Point& p, vtkPolyData* data, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(cell, ids);
  const vtkIdType size = ids->GetNumberOfIds();
  bool isIn = true;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Point a = GetPoint(data, ids->GetId(i));
    const Point b = GetPoint(data, ids->GetId((i + 1) % size));
    const double side = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    isIn = isIn && side > -1e-9;
  }
  return isIn;
}

/// In a regular plane grid, of which nothing moves but its border, the parameters are the plane.
TEST_P(SurfaceCarriers, CellsLieInThoseWhoseDataTheyHave)
{
  const bool triangles = GetParam() == vtkSurfaceSubdivision::SQRT_THREE;
  constexpr int size = 8;
  const double height = triangles ? std::sqrt(3.) / 2. : 1.;
  const Data grid = MakeInput(
    MakeSheet(size, size, triangles, { 1., 0., 0. }, { triangles ? 0.5 : 0., height, 0. }));
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(Numbers);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    numbers->InsertNextValue(static_cast<int>(cell));
  }
  grid->GetCellData()->AddArray(numbers);
  for (int levels = 1; levels <= 4; ++levels)
  {
    const Data output = Refine(grid, GetParam(), levels);
    const std::vector<int> found = GetNumbers(output);
    vtkNew<vtkIdList> ids;
    int inside = 0;
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      output->GetCellPoints(cell, ids);
      Point centre{};
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        const Point p = GetPoint(output, ids->GetId(i));
        for (int c = 0; c < 2; ++c)
        {
          centre[c] += p[c] / static_cast<double>(ids->GetNumberOfIds());
        }
      }
      const double row = centre[1] / height;
      const double column = centre[0] - (triangles ? 0.5 * row : 0.);
      if (std::min(row, column) > 2.5 && std::max(row, column) < size - 2.5)
      {
        ++inside;
        ASSERT_TRUE(IsIn(centre, grid, found[cell])) << levels << ", cell " << cell;
      }
    }
    EXPECT_GT(inside, 8);
  }
}

/// After two steps each cell lies in one of those before: none can be lost, even one of a triangle.
TEST_P(SurfaceCarriers, EveryCellHasItsPart)
{
  for (const auto& entry : MakeZoo(GetParam() == vtkSurfaceSubdivision::SQRT_THREE))
  {
    SCOPED_TRACE(entry.first);
    const Data input = MakeNumbered(entry.second);
    const std::vector<int> given = GetNumbers(input);
    for (int levels = 2; levels <= 4; levels += 2)
    {
      const std::vector<int> numbers = GetNumbers(Refine(input, GetParam(), levels));
      for (const int number : given)
      {
        EXPECT_GT(std::count(numbers.begin(), numbers.end(), number), 0) << number;
      }
    }
  }
}

void ExpectSameCellData(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetCellData()->GetNumberOfArrays(), b->GetCellData()->GetNumberOfArrays());
  for (int i = 0; i < a->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* first = a->GetCellData()->GetAbstractArray(i);
    vtkAbstractArray* second = b->GetCellData()->GetAbstractArray(first->GetName());
    ASSERT_TRUE(second) << first->GetName();
    ASSERT_EQ(first->GetNumberOfValues(), second->GetNumberOfValues());
    for (vtkIdType v = 0; v < first->GetNumberOfValues(); ++v)
    {
      ASSERT_EQ(first->GetVariantValue(v), second->GetVariantValue(v))
        << first->GetName() << " of cell " << v;
    }
  }
}

TEST_P(SurfaceCarriers, FiltersInARowAreOneFilter)
{
  const std::vector<std::vector<int>> rows{ { 1, 1 }, { 1, 2 }, { 2, 1 }, { 1, 1, 1 }, { 3, 1 },
    { 1, 3 }, { 2, 1, 1 }, { 2, 1, 2 } };
  for (const auto& entry : MakeZoo(false))
  {
    Model model = entry.second;
    const vtkIdType points = static_cast<vtkIdType>(model.Points.size());
    model.Points.insert(model.Points.end(), { { 5., 0., 0. }, { 6., 0., 1. }, { 7., 1., 0. } });
    model.Lines.push_back({ points, points + 1, points + 2 });
    const Data input = MakeNumbered(model);
    for (const std::vector<int>& row : rows)
    {
      SCOPED_TRACE(entry.first + testing::PrintToString(row));
      Data chained = input;
      for (const int levels : row)
      {
        chained = Refine(chained, GetParam(), levels, true);
      }
      const int all = std::accumulate(row.begin(), row.end(), 0);
      const Data direct = Refine(input, GetParam(), all, true);
      ExpectSameBits(chained, direct);
      ExpectSameCellData(chained, direct);
    }
  }
}

/// What somebody computed between two filters counts, not what was carried; and from there filters
/// in a row go on.
TEST_P(SurfaceCarriers, DataThatWereChangedAreTaken)
{
  const Data cube = MakeNumbered(MakeCube());
  const Data between = Refine(cube, GetParam(), 1, true);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(Numbers);
  for (vtkIdType cell = 0; cell < between->GetNumberOfCells(); ++cell)
  {
    numbers->InsertNextValue(1000 + static_cast<int>(cell));
  }
  between->GetCellData()->AddArray(numbers);
  const Data two = Refine(between, GetParam(), 2, true);
  const std::vector<int> after = GetNumbers(two);
  EXPECT_EQ(std::set<int>(after.begin(), after.end()).size(),
    static_cast<std::size_t>(between->GetNumberOfCells()));
  EXPECT_GE(*std::min_element(after.begin(), after.end()), 1000);
  ExpectSameCellData(Refine(Refine(between, GetParam(), 1, true), GetParam(), 1, true), two);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SurfaceCarriers,
  testing::Values(vtkSurfaceSubdivision::SQRT_THREE, vtkSurfaceSubdivision::FOUR_EIGHT,
    vtkSurfaceSubdivision::DOO_SABIN, vtkSurfaceSubdivision::MIDEDGE));

using subdivision::Carrier;
using subdivision::CommonCarrier;

Carrier<int> FindCommon(const std::vector<Carrier<int>>& carriers)
{
  CommonCarrier<int> common;
  for (const Carrier<int>& carrier : carriers)
  {
    common.Add(carrier);
  }
  return common.Get();
}

TEST(CommonCarrier, TheOneOfHighestDimensionElseWhatTheyShare)
{
  const Carrier<int> face{ 4, 4 };
  const Carrier<int> other{ 2, 2 };
  const Carrier<int> edge{ 2, 4 };
  const Carrier<int> far{ 3, 4 };
  const Carrier<int> vertex{ 1, -1 };
  EXPECT_EQ(FindCommon({ vertex, edge, face, edge }), face);
  EXPECT_EQ(FindCommon({ vertex, edge, edge }), edge);
  EXPECT_EQ(FindCommon({ face, other, face, edge }), edge);
  EXPECT_EQ(FindCommon({ face, other, { 7, 7 }, face }), (Carrier<int>{ 2, -1 }));
  EXPECT_EQ(FindCommon({ far, edge }), (Carrier<int>{ 2, -1 }));
  EXPECT_EQ(FindCommon({ { 5, -1 }, vertex }), vertex);
}

}
