// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridScheme.cxx
 * VolumeScheme = HYBRID: smooth subdivision in which every cell keeps its type (Mathematics 15).
 */
#include "HybridFilterTools.h"
#include "TypedCellTools.h"

#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <cstdlib>

using namespace hybrid_filter_tools;
using typed_cell_tools::CountTypes;

namespace
{

/// A unit cube, and one that is twice as long beside it.
Grid MakeCubes()
{
  std::vector<Point> points;
  for (int i = 0; i < 12; ++i)
  {
    points.push_back({ i % 3 == 2 ? 3. : i % 3 * 1., i / 3 % 2 * 1., i / 6 * 1. });
  }
  return MakeGrid(points,
    { { VTK_HEXAHEDRON, { 0, 1, 4, 3, 6, 7, 10, 9 } },
      { VTK_HEXAHEDRON, { 1, 2, 5, 4, 7, 8, 11, 10 } } });
}

Grid MakeCube()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  return Execute(image, 0, Hybrid);
}

}

TEST(HybridScheme, AVoxelBecomesEightRoundedHexahedra)
{
  const Grid cube = MakeCube();
  EXPECT_EQ(cube->GetCellType(0), VTK_HEXAHEDRON);
  const Grid output = Execute(cube, 1, Hybrid);
  EXPECT_EQ(CountTypes(output), (std::map<int, int>{ { VTK_HEXAHEDRON, 8 } }));
  EXPECT_EQ(output->GetNumberOfPoints(), 27);
  for (const double x : GetPoint(output, 0))
  {
    EXPECT_NEAR(x, 2. / 9., 1e-15);
  }
  EXPECT_EQ(Execute(cube, 3, Hybrid)->GetNumberOfCells(), 512);
}

TEST(HybridScheme, TypesOfAllCells)
{
  const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 2, 0, 0 }, { 2, 0, 1 },
                                { 0.5, 0.5, 2 }, { -1, 0, 0 }, { -1, 1, 0 }, { -2, 0, 0 } },
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_WEDGE, { 1, 2, 8, 5, 6, 9 } },
      { VTK_PYRAMID, { 4, 5, 6, 7, 10 } }, { VTK_TETRA, { 5, 9, 6, 10 } },
      { VTK_QUAD, { 0, 3, 12, 11 } }, { VTK_TRIANGLE, { 11, 12, 13 } }, { VTK_LINE, { 13, 10 } },
      { VTK_VERTEX, { 13 } } });
  AddArrays(input);
  vtkNew<Messages> messages;
  const Grid output = Execute(input, 1,
    With(
      [](Filter* filter)
      {
        filter->GenerateOriginalIdsOn();
        filter->DetectFeaturesOn();
      }),
    messages);
  EXPECT_EQ(CountTypes(output),
    (std::map<int, int>{ { VTK_HEXAHEDRON, 8 }, { VTK_WEDGE, 8 }, { VTK_PYRAMID, 4 },
      { VTK_TETRA, 16 }, { VTK_QUAD, 4 }, { VTK_TRIANGLE, 4 }, { VTK_LINE, 2 },
      { VTK_VERTEX, 1 } }));
  vtkDataArray* octahedra = output->GetCellData()->GetArray("OctahedronId");
  ASSERT_NE(octahedra, nullptr);
  std::map<double, int> pieces;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    ++pieces[octahedra->GetComponent(c, 0)];
  }
  EXPECT_EQ(pieces[0.], 4);
  EXPECT_EQ(pieces[1.], 4);
  EXPECT_EQ(pieces[-1.], output->GetNumberOfCells() - 8);
  EXPECT_TRUE(messages->Errors.empty());
  // Cell data come from parents, and a smooth array is smoothed like points.
  vtkDataArray* origins = output->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellData()->GetArray("int")->GetComponent(c, 0),
      input->GetCellData()->GetArray("int")->GetComponent(
        static_cast<vtkIdType>(origins->GetComponent(c, 0)), 0));
  }
}

TEST(HybridScheme, TetrahedraAreThoseOfTheTetOctScheme)
{
  const Grid input =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1.2 }, { 2, 0, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } }, { VTK_TRIANGLE, { 1, 4, 5 } },
        { VTK_LINE, { 5, 3 } } });
  const Grid output = Execute(input, 1, Hybrid);
  const Grid expected =
    Execute(input, 1, [](Filter* filter) { filter->SetVolumeSchemeToTetOct(); });
  ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(CountTypes(output), CountTypes(expected));
  double sums[2] = { 0., 0. };
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      sums[0] += std::pow(GetPoint(output, i)[c], 2) * (c + 1);
      sums[1] += std::pow(GetPoint(expected, i)[c], 2) * (c + 1);
    }
  }
  EXPECT_NEAR(sums[0], sums[1], 1e-12);
}

TEST(HybridScheme, SurfacesOfQuadsAreCatmullClark)
{
  const Grid quads =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, .5 }, { 3, 0, 0 }, { 0, 1, .3 }, { 1, 1, 1 },
               { 2, 1, 0 }, { 3, 1, 0 }, { 0, 2, 0 }, { 1, 2, 0 }, { 2, 2, .7 }, { 3, 2, .2 } },
      { { VTK_QUAD, { 0, 1, 5, 4 } }, { VTK_QUAD, { 1, 2, 6, 5 } }, { VTK_QUAD, { 2, 3, 7, 6 } },
        { VTK_QUAD, { 4, 5, 9, 8 } }, { VTK_QUAD, { 5, 6, 10, 9 } },
        { VTK_QUAD, { 6, 7, 11, 10 } } });
  const auto expected = SubdivideQuads(quads, 1);
  const Grid output = Execute(quads, 1, Hybrid);
  ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double nearest = 1.;
    for (vtkIdType k = 0; k < output->GetNumberOfPoints(); ++k)
    {
      const double* p = expected->GetPoint(k);
      const Point q = GetPoint(output, i);
      nearest = std::min(
        nearest, std::max({ std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2]) }));
    }
    // A corner of one quad is sharp in the surface scheme; here it follows the border.
    EXPECT_TRUE(nearest < 1e-13 || i == 0 || i == 3 || i == 8 || i == 11) << i;
  }
}

TEST(HybridScheme, InterfacesAndFeatures)
{
  const Grid cubes = MakeCubes();
  vtkNew<vtkIntArray> material;
  material->SetName("Material");
  material->InsertNextValue(1);
  material->InsertNextValue(2);
  cubes->GetCellData()->AddArray(material);
  const Grid smooth = Execute(cubes, 1, Hybrid);
  const Grid split = Execute(cubes, 1,
    With(
      [](Filter* filter)
      {
        filter->PreserveInterfacesOn();
        filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Material");
      }));
  EXPECT_GT(GetPoint(smooth, 1)[0], 1.1);
  EXPECT_EQ(GetPoint(split, 1)[0], 1.) << "the interface stays plane";
  EXPECT_EQ(GetPoint(smooth, 0), GetPoint(split, 0));
  // With all edges as features the corners stay, and edges are cubic splines.
  const Grid box = Execute(cubes, 2, With([](Filter* filter) { filter->DetectFeaturesOn(); }));
  for (const vtkIdType corner : { 0, 2, 3, 5, 6, 8, 9, 11 })
  {
    EXPECT_EQ(GetPoint(box, corner), GetPoint(cubes, corner)) << corner;
  }
  double bounds[6];
  box->GetBounds(bounds);
  EXPECT_EQ(bounds[1], 3.);
}

// Figures of an independent implementation: points, and the sums of their coordinates and squares.
TEST(HybridScheme, MeshOfAllTypes)
{
  const char* shared = std::getenv("SUBDIVISIONOBJECTS_SHARED_DATA");
  const std::string path =
    (shared ? shared : std::string("../shared/data")) + "/hex_mfem_tinyzoo.vtu";
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    GTEST_SKIP() << path << " is not there";
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  const std::vector<std::vector<double>> expected = { { 45., 45.13565793, 22.55402441, 22.60616352,
                                                        94.6526781326 },
    { 225., 225.52539657, 113.08384459, 113.37694696, 446.1233261582 },
    { 1377., 1379.75502717, 693.76157490, 695.77188914, 2667.5372881483 } };
  for (int levels = 1; levels <= 3; ++levels)
  {
    const Grid output = Execute(reader->GetOutput(), levels, Hybrid);
    std::vector<double> found = { static_cast<double>(output->GetNumberOfPoints()), 0., 0., 0.,
      0. };
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Point p = GetPoint(output, i);
      for (int c = 0; c < 3; ++c)
      {
        found[1 + c] += p[c];
        found[4] += p[c] * p[c];
      }
    }
    for (int k = 0; k < 5; ++k)
    {
      EXPECT_NEAR(found[k], expected[levels - 1][k], 1e-8) << levels << " levels, " << k;
    }
    if (levels == 2)
    {
      const auto types = CountTypes(output);
      EXPECT_EQ(types,
        (std::map<int, int>{ { VTK_TRIANGLE, 128 }, { VTK_QUAD, 96 }, { VTK_TETRA, 64 + 4 * 24 },
          { VTK_HEXAHEDRON, 64 }, { VTK_WEDGE, 64 }, { VTK_PYRAMID, 16 } }));
    }
  }
}
