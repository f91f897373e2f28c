// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestGhostTypes.cxx
 * Cells and points that VTK takes for such that are not there, and layers of duplicate cells.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkAMRBox.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkOverlappingAMR.h"
#include "vtkSubdivisionLabelSolid.h"
#include "vtkSurfaceSubdivision.h"
#include "vtkUniformGrid.h"

using namespace multi_dimensional_subdivision_tools;
using Filter = vtkMultiDimensionalSubdivision;

namespace
{

void SetGhosts(vtkDataSetAttributes* data, const std::vector<unsigned char>& values)
{
  vtkNew<vtkUnsignedCharArray> types;
  types->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const unsigned char value : values)
  {
    types->InsertNextValue(value);
  }
  data->AddArray(types);
}

Grid MakeTwo()
{
  return MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } } });
}

/// A grid of triangles, `size` squares wide, of which those from `begin` to `end` are there; others
/// up to `layers` squares away are duplicates.
void AddSlab(int size, int begin, int end, int layers, vtkPoints* points, vtkCellArray* cells,
  std::vector<unsigned char>& types)
{
  const int first = std::max(0, begin - layers);
  const int last = std::min(size, end + layers);
  const vtkIdType start = points->GetNumberOfPoints();
  for (int x = first; x <= last; ++x)
  {
    for (int y = 0; y <= size; ++y)
    {
      points->InsertNextPoint(x, y, std::sin(x) * std::cos(2. * y));
    }
  }
  for (int x = first; x < last; ++x)
  {
    for (int y = 0; y < size; ++y)
    {
      const vtkIdType a = start + (x - first) * (size + 1) + y;
      const bool isOwn = x >= begin && x < end;
      cells->InsertNextCell({ a, a + size + 1, a + size + 2 });
      cells->InsertNextCell({ a, a + size + 2, a + 1 });
      types.insert(types.end(), 2, isOwn ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
  }
}

vtkSmartPointer<vtkPolyData> MakeSlabs(int parts, int layers)
{
  constexpr int size = 8;
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::vector<unsigned char> types;
  for (int part = 0; part < parts; ++part)
  {
    AddSlab(size, size * part / parts, size * (part + 1) / parts, layers, points, cells, types);
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
  SetGhosts(surface->GetCellData(), types);
  return surface;
}

template <typename FilterClass>
vtkSmartPointer<vtkPointSet> RunOn(FilterClass* filter, vtkDataObject* input, Messages* messages)
{
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
}

/// The places of the points of cells that are no duplicates.
std::vector<Point> FindOwnPlaces(vtkPointSet* mesh)
{
  std::vector<Point> places;
  vtkUnsignedCharArray* types = mesh->GetCellGhostArray();
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCellPoints(c, ids);
    for (vtkIdType i = 0; types->GetValue(c) == 0 && i < ids->GetNumberOfIds(); ++i)
    {
      places.push_back(GetPoint(mesh, ids->GetId(i)));
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Whether each place is near one of the others.
void ExpectSamePlaces(const std::vector<Point>& found, const std::vector<Point>& whole)
{
  ASSERT_FALSE(found.empty());
  for (const Point& p : found)
  {
    double least = 1.;
    for (const Point& q : whole)
    {
      least = std::min(
        least, std::max({ std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2]) }));
    }
    ASSERT_LT(least, 1e-12);
  }
}

template <typename FilterClass, typename Set>
void ExpectEnoughLayers(int enough, const Set& set)
{
  vtkNew<FilterClass> ofWhole;
  set(ofWhole.Get());
  vtkNew<Messages> quiet;
  const auto whole = FindOwnPlaces(RunOn(ofWhole.Get(), MakeSlabs(1, 0), quiet));
  EXPECT_TRUE(quiet->Warnings.empty());
  for (const int layers : { 1, 2, 3 })
  {
    vtkNew<FilterClass> filter;
    set(filter.Get());
    vtkNew<Messages> messages;
    const auto parts = RunOn(filter.Get(), MakeSlabs(2, layers), messages);
    EXPECT_EQ(messages->CountWarnings("layers of duplicate"), layers < enough ? 1 : 0) << layers;
    EXPECT_EQ(messages->Warnings.size(), layers < enough ? 1u : 0u) << layers;
    if (layers >= enough)
    {
      ExpectSamePlaces(FindOwnPlaces(parts), whole);
    }
  }
}

/// Four cubes side by side, of which two grids of eight smaller ones replace the second and the
/// third.
vtkSmartPointer<vtkOverlappingAMR> MakeLevels()
{
  const auto amr = vtkSmartPointer<vtkOverlappingAMR>::New();
  const std::vector<int> counts{ 1, 2 };
  amr->Initialize(2, counts.data());
  const double zero[3] = { 0., 0., 0. };
  amr->SetOrigin(zero);
  amr->SetGridDescription(VTK_XYZ_GRID);
  const auto add = [&](unsigned int level, unsigned int index, double x, std::array<int, 3> size)
  {
    const double width = level == 0 ? 1. : 0.5;
    const std::array<double, 3> spacing{ width, width, width };
    const std::array<double, 3> origin{ x, 0., 0. };
    vtkNew<vtkUniformGrid> grid;
    grid->SetOrigin(origin.data());
    grid->SetSpacing(spacing.data());
    grid->SetDimensions(size.data());
    if (level == 0)
    {
      constexpr unsigned char refined = vtkDataSetAttributes::REFINEDCELL;
      SetGhosts(grid->GetCellData(), { 0, refined, refined, 0 });
    }
    amr->SetSpacing(level, spacing.data());
    amr->SetAMRBox(
      level, index, vtkAMRBox(origin.data(), size.data(), spacing.data(), zero, VTK_XYZ_GRID));
    amr->SetDataSet(level, index, grid);
  };
  add(0, 0, 0., { 5, 2, 2 });
  add(1, 0, 1., { 3, 3, 3 });
  add(1, 1, 2., { 3, 3, 3 });
  return amr;
}

}

TEST(GhostTypes, LevelsOfAmrAreBlocks)
{
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToBoxSpline();
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(MakeLevels());
  filter->SetNumberOfLevels(1);
  filter->Update();
  EXPECT_EQ(messages->CountWarnings("inside an edge"), 1); // of coarse cubes beside small ones
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(made);
  ASSERT_EQ(made->GetNumberOfBlocks(), 2u);
  std::vector<vtkIdType> cells;
  for (unsigned int level = 0; level < 2; ++level)
  {
    EXPECT_EQ(
      made->GetMetaData(level)->Get(vtkCompositeDataSet::NAME()), "Level " + std::to_string(level));
    auto* grids = vtkMultiBlockDataSet::SafeDownCast(made->GetBlock(level));
    ASSERT_TRUE(grids);
    for (unsigned int g = 0; g < grids->GetNumberOfBlocks(); ++g)
    {
      auto* grid = vtkUnstructuredGrid::SafeDownCast(grids->GetBlock(g));
      ASSERT_TRUE(grid);
      cells.push_back(grid->GetNumberOfCells());
    }
  }
  const vtkIdType ofCube = cells[0] / 2;
  EXPECT_GT(ofCube, 0);
  EXPECT_EQ(cells, (std::vector<vtkIdType>{ 2 * ofCube, 8 * ofCube, 8 * ofCube }));
  // Grids of a level are joined: both small ones have the same points where they meet.
  auto* fine = vtkMultiBlockDataSet::SafeDownCast(made->GetBlock(1));
  const auto middle = [&](unsigned int g)
  {
    std::set<Point> points;
    auto* grid = vtkUnstructuredGrid::SafeDownCast(fine->GetBlock(g));
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      const Point at = GetPoint(grid, p);
      if (std::abs(at[0] - 2.) < 1e-6)
      {
        points.insert(at);
      }
    }
    return points;
  };
  EXPECT_GT(middle(0).size(), 9u);
  EXPECT_EQ(middle(0), middle(1));
}

TEST(GhostTypes, RefinedCellsAndThoseOfHiddenPointsAreNotThere)
{
  const Grid one = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 1, 2, 3, 4 } } });
  const Grid expected = Subdivide(one, 1);
  const Grid refined = MakeTwo();
  SetGhosts(refined->GetCellData(), { vtkDataSetAttributes::REFINEDCELL, 0 });
  const Grid hidden = MakeTwo();
  SetGhosts(hidden->GetPointData(), { vtkDataSetAttributes::HIDDENPOINT, 0, 0, 0, 0 });
  for (const Grid& grid : { refined, hidden })
  {
    const Grid output = Subdivide(grid, 1);
    EXPECT_EQ(GetCells(output), GetCells(expected));
    for (vtkIdType p = 0; p < expected->GetNumberOfPoints(); ++p)
    {
      EXPECT_EQ(GetPoint(output, p), GetPoint(expected, p));
    }
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, grid);
    vtkNew<Filter> filter;
    filter->SetVolumeSchemeToBoxSpline();
    filter->SetInputDataObject(blocks);
    filter->Update();
    auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(made->GetBlock(0))->GetNumberOfCells(),
      expected->GetNumberOfCells());
  }
}

TEST(GhostTypes, LabelsOfVoxelsThatAreNotThere)
{
  for (const unsigned char type : { vtkDataSetAttributes::REFINEDCELL,
         vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 2, 2);
    vtkNew<vtkIntArray> labels;
    labels->SetName("Labels");
    labels->InsertNextValue(1);
    labels->InsertNextValue(2);
    image->GetCellData()->SetScalars(labels);
    SetGhosts(image->GetCellData(), { type, 0 });
    vtkNew<vtkSubdivisionLabelSolid> filter;
    filter->SetInputData(image);
    filter->Update();
    vtkDataArray* found = filter->GetOutput()->GetCellData()->GetArray("Labels");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->GetRange()[0], 2.);
  }
}

TEST(GhostTypes, LayersInOneMeshGiveNoFalseWarning)
{
  ExpectEnoughLayers<Filter>(1,
    [](Filter* filter)
    {
      filter->SetNumberOfLevels(2);
      filter->ModifiedBoundaryOff();
    });
  ExpectEnoughLayers<Filter>(2, [](Filter* filter) { filter->SetNumberOfLevels(2); });
  ExpectEnoughLayers<vtkSurfaceSubdivision>(
    2, [](vtkSurfaceSubdivision* filter) { filter->SetNumberOfLevels(2); });
}
