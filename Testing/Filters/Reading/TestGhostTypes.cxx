// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestGhostTypes.cxx
 * Cells and points that VTK takes for such that are not there, and layers of duplicate cells.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSubdivisionLabelSolid.h"
#include "vtkSurfaceSubdivision.h"

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
  ExpectEnoughLayers<Filter>(1, [](Filter* filter) { filter->SetNumberOfLevels(2); });
  ExpectEnoughLayers<vtkSurfaceSubdivision>(
    2, [](vtkSurfaceSubdivision* filter) { filter->SetNumberOfLevels(2); });
}
