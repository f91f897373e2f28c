// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestKeepCellTypes.cxx
 * KeepCellTypes: red refinement of hexahedra, wedges, pyramids, quads and simplices as such.
 */
#include "OperatorCacheTools.h"
#include "PartitionTools.h"

#include "vtkImageData.h"

using namespace operator_cache_tools;

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

/// The corners of the faces of cells, by VTK's own cells.
std::vector<Ids> GetFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  std::vector<Ids> faces;
  vtkCell* of = grid->GetCell(cell);
  for (int f = 0; f < of->GetNumberOfFaces(); ++f)
  {
    vtkIdList* ids = of->GetFace(f)->GetPointIds();
    faces.emplace_back(ids->begin(), ids->end());
  }
  return faces;
}

/// Six times the volume below the bilinear or flat face, seen along z, with its orientation: summed
/// over the faces of a cell with faces turned outward it is six times the volume.
double GetFlux(vtkPointSet* grid, const Ids& face)
{
  // A quad is the mean of its two cuts: exact for a bilinear face.
  const auto triangle = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const Point p = GetPoint(grid, a);
    const Point q = GetPoint(grid, b);
    const Point r = GetPoint(grid, c);
    return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
      p[2] * (q[0] * r[1] - q[1] * r[0]);
  };
  if (face.size() == 3)
  {
    return triangle(face[0], face[1], face[2]);
  }
  return (triangle(face[0], face[1], face[2]) + triangle(face[0], face[2], face[3]) +
           triangle(face[0], face[1], face[3]) + triangle(face[1], face[2], face[3])) /
    2.;
}

/// The volume of the cells that come from each input cell.
std::map<int, double> MeasureByOrigin(vtkUnstructuredGrid* grid)
{
  std::map<int, double> volumes;
  vtkDataArray* origins = grid->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    double volume = 0.;
    for (const Ids& face : GetFaces(grid, c))
    {
      volume += GetFlux(grid, face) / 6.;
    }
    volumes[static_cast<int>(origins->GetComponent(c, 0))] += volume;
  }
  return volumes;
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

std::map<int, int> CountTypes(vtkUnstructuredGrid* grid)
{
  std::map<int, int> counts;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    ++counts[grid->GetCellType(c)];
  }
  return counts;
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
  const std::map<int, int> once = { { VTK_HEXAHEDRON, 8 }, { VTK_WEDGE, 8 }, { VTK_PYRAMID, 12 },
    { VTK_TETRA, 16 }, { VTK_QUAD, 4 }, { VTK_TRIANGLE, 4 }, { VTK_LINE, 2 }, { VTK_VERTEX, 1 } };
  EXPECT_EQ(CountTypes(Refine(input, 1)), once);
  const std::map<int, int> twice = { { VTK_HEXAHEDRON, 64 }, { VTK_WEDGE, 64 }, { VTK_PYRAMID, 72 },
    { VTK_TETRA, 176 }, { VTK_QUAD, 16 }, { VTK_TRIANGLE, 16 }, { VTK_LINE, 4 },
    { VTK_VERTEX, 1 } };
  EXPECT_EQ(CountTypes(Refine(input, 2)), twice);
}

TEST(KeepCellTypes, NoFaceHangsAndVolumesAreKept)
{
  for (const double bend : { 0., 0.1 })
  {
    const Grid input = MakeMixed(bend);
    const Grid start = Refine(input, 0);
    const auto volumes = MeasureByOrigin(start);
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
      const auto now = MeasureByOrigin(output);
      for (const auto& [cell, volume] : volumes)
      {
        EXPECT_NEAR(now.at(cell), volume, 1e-13) << "cell " << cell;
      }
      const auto refined = CountFaces(output);
      EXPECT_EQ(refined.first, faces.first << (2 * levels)) << "outer faces become four each";
      inner[levels - 1] = refined.second;
    }
    // Of a hexahedron 12 faces are new, of a wedge 10, a pyramid 13, a tetrahedron 8.
    EXPECT_EQ(inner[0], 4 * faces.second + 12 + 10 + 2 * 13 + 8);
    EXPECT_EQ(inner[1], 4 * inner[0] + 8 * 12 + 8 * 10 + 12 * 13 + 16 * 8);
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

/// One filter of two levels, two filters, blocks and threads give the same.
TEST(KeepCellTypes, FiltersInARowAndBlocks)
{
  const Grid input = MakeMixed(0.1);
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

TEST(KeepCellTypes, ImagesAndWhatHasNoChildren)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 4, 2);
  const Grid output = Refine(image, 1);
  EXPECT_EQ(output->GetNumberOfCells(), 8 * 6);
  EXPECT_EQ(output->GetNumberOfPoints(), 5 * 7 * 3);
  EXPECT_EQ(output->GetCellType(0), VTK_HEXAHEDRON);
  const Grid polygon = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 }, { 0, 1, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_POLYGON, { 0, 1, 2, 3, 4 } } });
  vtkNew<Messages> messages;
  Execute(polygon, 1, Keeping, messages);
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("Cell 1 has 5 points and the type 7"), std::string::npos);
  const Grid broken = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, NAN } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_QUAD, { 0, 1, 2, 2 } } });
  vtkNew<Messages> warnings;
  EXPECT_EQ(Execute(broken, 1, Keeping, warnings)->GetNumberOfCells(), 4);
  EXPECT_EQ(warnings->CountWarnings("2 cell(s)"), 1);
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
