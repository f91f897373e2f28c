// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionLabelHexahedra.cxx
 * CellType = HEXAHEDRA of vtkSubdivisionLabelSolid: control voxels stay whole.
 */
#include "LabelTools.h"
#include "TypedCellTools.h"

#include "vtkSubdivisionLabelSolid.h"

#include "vtkTable.h"
#include "vtkTrivialProducer.h"

using namespace label_tools;
using namespace typed_cell_tools;

namespace
{

/// A ball (2) in a ball (1), in n^3 voxels.
Rule BallsOf(int n)
{
  return [n](int i, int j, int k)
  {
    const auto at = [n](int c) { return (2. * c + 1.) / n - 1.; };
    const double radius = std::hypot(at(i), at(j), at(k));
    return radius < .55 ? 2 : radius < .9 ? 1 : 0;
  };
}

/// How many corners of hexahedra are inverted, by the edges that meet there.
int CountInvertedCorners(vtkUnstructuredGrid* grid)
{
  constexpr int neighbours[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 },
    { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };
  int count = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const Ids ids = GetCell(grid, c);
    for (int corner = 0; corner < 8; ++corner)
    {
      const Ids tet = { ids[corner], ids[neighbours[corner][0]], ids[neighbours[corner][1]],
        ids[neighbours[corner][2]] };
      count += GetSignedVolume(grid, tet) > 0. ? 0 : 1;
    }
  }
  return count;
}

}

TEST(SubdivisionLabelHexahedra, ControlVoxelsStayWhole)
{
  constexpr int n = 14;
  const Image image = MakeImage({ n, n, n }, BallsOf(n));
  std::map<int, double> wanted;
  for (int i = 0; i < n * n * n; ++i)
  {
    wanted[BallsOf(n)(i % n, i / n % n, i / n / n)] += 1.;
  }
  Made made;
  made->SetCellTypeToHexahedra();
  made->SetNumberOfControlCells(0);
  made->SetNumberOfLevels(0);
  const Grid solid = DeepCopy(made.Run(image));
  made.ExpectSilence();
  const int voxels = static_cast<int>(wanted[1] + wanted[2]);
  EXPECT_EQ(CountTypes(solid), (std::map<int, int>{ { VTK_HEXAHEDRON, voxels } }));
  const auto volumes = MeasureSolidsBy(solid, "Tissue");
  ASSERT_EQ(volumes.size(), 2u);
  for (const auto& [label, volume] : volumes)
  {
    EXPECT_NEAR(volume / wanted[label], 1., .005) << label;
  }
  EXPECT_EQ(CountInvertedCorners(solid), 0);
  ExpectFitting(solid);
  // As tetrahedra it has the same corners in the same places, but for the correction of volumes.
  made->SetCellTypeToTetrahedra();
  EXPECT_EQ(made.Run(image)->GetNumberOfPoints(), solid->GetNumberOfPoints());
  // The scheme for hexahedra goes on with it, and keeps the interface.
  vtkNew<vtkMultiDimensionalSubdivision> smooth;
  smooth->SetInputData(solid);
  smooth->SetVolumeSchemeToHybrid();
  smooth->PreserveInterfacesOn();
  smooth->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Tissue");
  smooth->Update();
  const Grid finer = DeepCopy(vtkUnstructuredGrid::SafeDownCast(smooth->GetOutputDataObject(0)));
  EXPECT_EQ(CountTypes(finer), (std::map<int, int>{ { VTK_HEXAHEDRON, 8 * voxels } }));
  EXPECT_EQ(CountInvertedCorners(finer), 0);
  ExpectFitting(finer);
}

TEST(SubdivisionLabelHexahedra, AllLevelsAreOnTheLimit)
{
  constexpr int n = 10;
  const Image image = MakeImage({ n, n, n }, BallsOf(n));
  Made made;
  made->SetCellTypeToHexahedra();
  made->SetNumberOfControlCells(0);
  made->SetNumberOfLevels(1);
  const Grid solid = DeepCopy(made.Run(image));
  made.ExpectSilence();
  std::map<int, double> wanted;
  for (int i = 0; i < n * n * n; ++i)
  {
    wanted[BallsOf(n)(i % n, i / n % n, i / n / n)] += 1.;
  }
  EXPECT_EQ(solid->GetNumberOfCells(), 8 * static_cast<vtkIdType>(wanted[1] + wanted[2]));
  for (const auto& [label, volume] : MeasureSolidsBy(solid, "Tissue"))
  {
    EXPECT_NEAR(volume / wanted[label], 1., .005) << label;
  }
  EXPECT_EQ(CountInvertedCorners(solid), 0);
  ExpectFitting(solid);
}

/// The whole image is one label: with FlatBorder it stays a box, on all levels.
TEST(SubdivisionLabelHexahedra, TheBorderStaysFlat)
{
  const Image image = MakeImage({ 4, 4, 4 }, [](int, int, int) { return 1; });
  for (const int levels : { 0, 1, 2 })
  {
    Made made;
    made->SetCellTypeToHexahedra();
    made->SetNumberOfControlCells(0);
    made->SetNumberOfLevels(levels);
    const Grid solid = made.Run(image);
    made.ExpectSilence();
    EXPECT_EQ(CountTypes(solid), (std::map<int, int>{ { VTK_HEXAHEDRON, 64 << 3 * levels } }));
    EXPECT_NEAR(MeasureSolidsBy(solid, "Tissue")[1], 64., 1e-5);
  }
}

/// Mirrored, coarsened, with a table and arrays of voxels.
TEST(SubdivisionLabelHexahedra, CarriesWhatTetrahedraCarry)
{
  const Image image = MakeImage({ 12, 12, 12 }, BallsOf(12));
  vtkNew<vtkDoubleArray> values;
  values->SetName("Value");
  for (int i = 0; i < 12 * 12 * 12; ++i)
  {
    values->InsertNextValue(i % 12);
  }
  image->GetPointData()->AddArray(values);
  image->SetSpacing(1., -1., 1.);
  vtkNew<vtkTable> table;
  for (const char* name : { "Label", "Stiffness" })
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    column->InsertNextValue(1.);
    column->InsertNextValue(2.);
    table->AddColumn(column);
  }
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(table);
  std::vector<Grid> solids;
  for (const int type :
    { vtkSubdivisionLabelSolid::TETRAHEDRA, vtkSubdivisionLabelSolid::HEXAHEDRA })
  {
    Made made;
    made->SetCellType(type);
    made->SetNumberOfControlCells(300);
    made->SetNumberOfLevels(0);
    made->SetMaterialsConnection(producer->GetOutputPort());
    solids.push_back(DeepCopy(made.Run(image)));
    made.ExpectSilence();
  }
  const vtkIdType cells = solids[1]->GetNumberOfCells();
  ASSERT_EQ(solids[0]->GetNumberOfCells(), 6 * cells);
  EXPECT_GT(MeasureSolids(solids[1]), 0.);
  EXPECT_EQ(CountInvertedCorners(solids[1]), 0);
  EXPECT_EQ(
    solids[0]->GetCellData()->GetNumberOfArrays(), solids[1]->GetCellData()->GetNumberOfArrays());
  for (const char* name : { "Tissue", "Stiffness", "Value" })
  {
    vtkDataArray* tets = solids[0]->GetCellData()->GetArray(name);
    vtkDataArray* hexes = solids[1]->GetCellData()->GetArray(name);
    ASSERT_TRUE(tets && hexes) << name;
    for (vtkIdType c = 0; c < cells; ++c)
    {
      EXPECT_EQ(tets->GetComponent(6 * c, 0), hexes->GetComponent(c, 0));
    }
  }
}
