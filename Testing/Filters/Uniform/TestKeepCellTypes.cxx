// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestKeepCellTypes.cxx
 * KeepCellTypes: red refinement of hexahedra, wedges, pyramids, quads and simplices as such.
 */
#include "OperatorCacheTools.h"
#include "PartitionTools.h"
#include "TypedCellTools.h"

#include "vtkImageData.h"

using namespace operator_cache_tools;
using namespace typed_cell_tools;

namespace
{

const Configure Keeping = [](Filter* filter)
{
  filter->SetVolumeSchemeToLinear();
  filter->KeepCellTypesOn();
};

/// A hexahedron, and on its sides a wedge with a pyramid and tetrahedra on it, a quad, a line.
/// Neighbours share whole faces. `bend` moves points out of planes.
Grid MakeMixed(double bend)
{
  std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 2, 0, 0 }, { 2, 0, 1 }, { 0.5, 0.5, 2 },
    { 1.5, 1.5, 0.5 }, { -1, 0, 0 }, { -1, 1, 0 }, { -2, 0, 0 } };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i][1] += bend * std::sin(3. * static_cast<double>(i));
    points[i][2] += bend * std::cos(5. * static_cast<double>(i));
  }
  return MakeGrid(points,
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } },
      { VTK_WEDGE, { 1, 2, 8, 5, 6, 9 } }, // beside the side 1 2 6 5
      { VTK_PYRAMID, { 4, 5, 6, 7, 10 } }, // on the top
      { VTK_PYRAMID, { 2, 6, 9, 8, 11 } }, // on the slanted side of the wedge
      { VTK_TETRA, { 5, 9, 6, 10 } }, { VTK_QUAD, { 0, 3, 13, 12 } },
      { VTK_TRIANGLE, { 12, 13, 14 } }, { VTK_LINE, { 14, 10 } }, { VTK_VERTEX, { 14 } } });
}

/// How many faces of solids are there once, and how many twice. Where there is a hanging face,
/// fewer are there twice.
std::pair<int, int> CountFaces(vtkUnstructuredGrid* grid)
{
  std::map<Ids, int> counts;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    for (Ids& face : GetFaces(grid, c))
    {
      std::sort(face.begin(), face.end());
      ++counts[face];
    }
  }
  std::pair<int, int> found;
  for (const auto& [face, count] : counts)
  {
    EXPECT_LE(count, 2);
    ++(count == 1 ? found.first : found.second);
  }
  return found;
}

Grid Refine(vtkDataObject* input, int levels, const Configure& configure = {})
{
  return Execute(input, levels,
    [&](Filter* filter)
    {
      Keeping(filter);
      filter->GenerateOriginalIdsOn();
      if (configure)
      {
        configure(filter);
      }
    });
}

}

TEST(KeepCellTypes, TypesAndNumbers)
{
  const Grid input = MakeMixed(0.);
  EXPECT_EQ(CountTypes(Refine(input, 0)), CountTypes(input));
  // Octahedra, one of a tetrahedron and one of each pyramid, are four tetrahedra.
  const std::map<int, int> once = { { VTK_HEXAHEDRON, 8 }, { VTK_WEDGE, 8 }, { VTK_PYRAMID, 8 },
    { VTK_TETRA, 24 }, { VTK_QUAD, 4 }, { VTK_TRIANGLE, 4 }, { VTK_LINE, 2 }, { VTK_VERTEX, 1 } };
  EXPECT_EQ(CountTypes(Refine(input, 1)), once);
  const std::map<int, int> twice = { { VTK_HEXAHEDRON, 64 }, { VTK_WEDGE, 64 }, { VTK_PYRAMID, 32 },
    { VTK_TETRA, 256 }, { VTK_QUAD, 16 }, { VTK_TRIANGLE, 16 }, { VTK_LINE, 4 },
    { VTK_VERTEX, 1 } };
  EXPECT_EQ(CountTypes(Refine(input, 2)), twice);
}

TEST(KeepCellTypes, NoFaceHangsAndVolumesAreKept)
{
  for (const double bend : { 0., 0.1 })
  {
    const Grid input = MakeMixed(bend);
    const Grid start = Refine(input, 0);
    const auto volumes = MeasureSolidsBy(start, "vtkOriginalCellIds");
    for (int c = 0; c < 5; ++c)
    {
      EXPECT_GT(volumes.at(c), 0.1) << "the faces of all cells point outward";
    }
    const auto faces = CountFaces(start);
    EXPECT_EQ(faces.second, 5);
    int inner[2] = { 0, 0 }; // faces inside cells, from cells of the level before
    for (int levels = 1; levels <= 2; ++levels)
    {
      const Grid output = Refine(input, levels);
      const auto now = MeasureSolidsBy(output, "vtkOriginalCellIds");
      for (const auto& [cell, volume] : volumes)
      {
        EXPECT_NEAR(now.at(cell), volume, 1e-13) << "cell " << cell;
      }
      const auto refined = CountFaces(output);
      EXPECT_EQ(refined.first, faces.first << (2 * levels)) << "outer faces become four each";
      inner[levels - 1] = refined.second;
    }
    // Of a hexahedron 12 faces are new, of a wedge 10, a pyramid 16, a tetrahedron 8. Each
    // octahedron of the first level has 4 faces inside that the second one does not have, and 48
    // new ones.
    EXPECT_EQ(inner[0], 4 * faces.second + 12 + 10 + 2 * 16 + 8);
    EXPECT_EQ(
      inner[1], 4 * (inner[0] - 3 * 4) + 8 * 12 + 8 * 10 + 8 * 16 + 12 * 8 + 3 * (24 + 6 * 4));
  }
}

TEST(KeepCellTypes, SolidsStayPositive)
{
  const Grid output = Refine(MakeMixed(0.), 2);
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    double volume = 0.;
    for (const Ids& face : GetFaces(output, c))
    {
      volume += GetFlux(output, face);
    }
    EXPECT_TRUE(output->GetCell(c)->GetCellDimension() < 3 || volume > 0.) << c;
  }
}

TEST(KeepCellTypes, ArraysAndIds)
{
  const Grid input = MakeMixed(0.1);
  AddArrays(input);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(input, i);
    input->GetPointData()->GetArray("double")->SetComponent(i, 0, 2. * p[0] - p[1] + 3. * p[2]);
  }
  const Grid output = Refine(input, 2);
  vtkDataArray* values = output->GetPointData()->GetArray("double");
  vtkDataArray* ids = output->GetPointData()->GetArray("vtkOriginalPointIds");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(output, i);
    EXPECT_NEAR(values->GetComponent(i, 0), 2. * p[0] - p[1] + 3. * p[2], 1e-13);
    EXPECT_EQ(ids->GetComponent(i, 0), i < input->GetNumberOfPoints() ? i : -1);
  }
  vtkDataArray* origins = output->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellData()->GetArray("int")->GetComponent(c, 0),
      input->GetCellData()->GetArray("int")->GetComponent(
        static_cast<vtkIdType>(origins->GetComponent(c, 0)), 0));
  }
  for (const char* name : { "int", "string", "bit", "rgb" })
  {
    EXPECT_NE(output->GetPointData()->GetAbstractArray(name), nullptr) << name;
  }
}

/// Octahedra are found again by their number: without that a second filter had other points.
TEST(KeepCellTypes, FiltersInARowHaveTheSamePoints)
{
  const Grid input = MakeMixed(0.1);
  const Grid twice = Execute(input, 2, Keeping);
  const Grid inARow = Execute(Execute(input, 1, Keeping), 1, Keeping);
  EXPECT_EQ(CountTypes(twice), CountTypes(inARow));
  const auto sort = [](const Grid& grid)
  {
    std::vector<std::array<long long, 3>> points;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const Point p = GetPoint(grid, i);
      points.push_back({});
      std::transform(p.begin(), p.end(), points.back().begin(),
        [](double x) { return std::llround(x * 1.2345678e9); });
    }
    std::sort(points.begin(), points.end());
    return points;
  };
  EXPECT_EQ(sort(twice), sort(inARow));
}

/// One filter of two levels, two filters, blocks and threads give the same.
TEST(KeepCellTypes, FiltersInARowAndBlocks)
{
  const Grid whole = MakeMixed(0.1);
  // Without octahedra, whose pieces may come out in another order.
  const std::vector<Cell> kept = { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } },
    { VTK_WEDGE, { 1, 2, 8, 5, 6, 9 } }, { VTK_QUAD, { 0, 3, 13, 12 } },
    { VTK_TRIANGLE, { 12, 13, 14 } }, { VTK_LINE, { 14, 10 } }, { VTK_VERTEX, { 14 } } };
  std::vector<Point> points;
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(whole, i));
  }
  const Grid input = MakeGrid(points, kept);
  AddArrays(input);
  const Grid twice = Execute(input, 2, Keeping);
  EXPECT_EQ(Compare(twice, Execute(Execute(input, 1, Keeping), 1, Keeping)), "");
  EXPECT_EQ(Compare(twice,
              Execute(input, 2,
                [](Filter* filter)
                {
                  Keeping(filter);
                  filter->Use32BitIdsOn();
                })),
    "");
  partition_tools::NumberCells(input);
  AddGlobalIds(input, 3);
  const auto cut = partition_tools::Cut(
    input, partition_tools::CutByChance(input, 2, 5), 2, partition_tools::KnownBy::GlobalIds);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int b = 0; b < cut.size(); ++b)
  {
    blocks->SetBlock(b, cut[b]);
  }
  vtkNew<Filter> filter;
  Keeping(filter);
  filter->SetInputDataObject(blocks);
  filter->Update();
  vtkIdType cells = 0;
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (unsigned int b = 0; b < cut.size(); ++b)
  {
    cells += vtkUnstructuredGrid::SafeDownCast(output->GetBlock(b))->GetNumberOfCells();
  }
  EXPECT_EQ(cells, Execute(input, 1, Keeping)->GetNumberOfCells());
}

TEST(KeepCellTypes, ImagesAndCellsThatCannotBeUsed)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 4, 2);
  const Grid output = Refine(image, 1);
  EXPECT_EQ(output->GetNumberOfCells(), 8 * 6);
  EXPECT_EQ(output->GetNumberOfPoints(), 5 * 7 * 3);
  EXPECT_EQ(output->GetCellType(0), VTK_HEXAHEDRON);
  const Grid broken = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, NAN } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_QUAD, { 0, 1, 1, 0 } } });
  vtkNew<Messages> warnings;
  EXPECT_EQ(Execute(broken, 1, Keeping, warnings)->GetNumberOfCells(), 4);
  EXPECT_EQ(warnings->CountWarnings("Passed over 1 cell (cell 1"), 1);
  EXPECT_EQ(warnings->CountWarnings("Passed over 1 cell (cell 2"), 1);
  vtkNew<Messages> ignored;
  Execute(MakeMixed(0.), 1, [](Filter* filter) { filter->KeepCellTypesOn(); }, ignored);
  EXPECT_EQ(ignored->CountWarnings("needs VolumeScheme"), 1);
  vtkNew<Messages> large;
  Execute(
    MakeMixed(0.), 9,
    [](Filter* filter)
    {
      Keeping(filter);
      filter->SetMaximumNumberOfCells(1000);
    },
    large);
  EXPECT_FALSE(large->Errors.empty());
}
