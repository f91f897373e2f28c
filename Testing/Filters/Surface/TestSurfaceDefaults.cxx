// SPDX-License-Identifier: BSD-3-Clause
// What the surface filter does before anyone chooses: which scheme it takes, and the outside of
// solids.
#include "SurfaceTools.h"

#include "vtkExtractDimensions.h"

namespace
{

using namespace surfacetools;
using multi_dimensional_subdivision_tools::GetTuple;
using multi_dimensional_subdivision_tools::Grid;
using multi_dimensional_subdivision_tools::Ids;
using multi_dimensional_subdivision_tools::MakeArray;
using multi_dimensional_subdivision_tools::MakeBlocks;
using multi_dimensional_subdivision_tools::MakeGrid;
using multi_dimensional_subdivision_tools::Messages;
using multi_dimensional_subdivision_tools::UpdateInSilence;
using Surface = vtkSmartPointer<vtkPolyData>;
constexpr int Automatic = vtkSurfaceSubdivision::AUTOMATIC;
constexpr int Loop = vtkSurfaceSubdivision::LOOP;
constexpr int CatmullClark = vtkSurfaceSubdivision::CATMULL_CLARK;

/// A strip of quads, the first ones of which are triangles.
Surface MakeRow(int quads, int pairs)
{
  Model model = surfacetools::MakeSheet(quads + pairs, 1, false, { 1., 0., 0.2 }, { 0., 1., 0.1 });
  for (int i = 0; i < pairs; ++i)
  {
    const auto quad = model.Faces[static_cast<std::size_t>(2 * i)];
    model.Faces[static_cast<std::size_t>(2 * i)] = { quad[0], quad[1], quad[2] };
    model.Faces.insert(model.Faces.begin() + 2 * i + 1, { quad[0], quad[2], quad[3] });
  }
  return MakeInput(model);
}

int FindScheme(vtkDataObject* input, int levels = 1)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetNumberOfLevels(levels);
  UpdateInSilence(filter, input, nullptr, { "are solids" });
  return filter->GetSchemeInUse();
}

/// Hexahedra with the points 0, 1, ... of a lattice of n cubes along each axis.
Grid MakeCubes(int n)
{
  std::vector<Point> points;
  std::vector<multi_dimensional_subdivision_tools::Cell> cells;
  const vtkIdType row = n + 1;
  const vtkIdType layer = row * row;
  for (vtkIdType i = 0; i < row * layer; ++i)
  {
    points.push_back({ double(i % row), double(i / row % row), double(i / layer) });
    if (i % row < n && i / row % row < n && i / layer < n)
    {
      cells.push_back({ VTK_HEXAHEDRON,
        { i, i + 1, i + row + 1, i + row, i + layer, i + layer + 1, i + layer + row + 1,
          i + layer + row } });
    }
  }
  cells.push_back({ VTK_QUAD, { 0, row, row + 1, 1 } }); // a face of the first hexahedron
  cells.push_back({ VTK_TRIANGLE, { 0, 1, 2 * layer } });
  return MakeGrid(points, cells);
}

/// What faces that look outwards enclose.
double GetVolume(vtkPolyData* surface)
{
  double volume = 0.;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    surface->GetCellPoints(c, ids);
    for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      Point p[3];
      surface->GetPoint(ids->GetId(0), p[0].data());
      surface->GetPoint(ids->GetId(i), p[1].data());
      surface->GetPoint(ids->GetId(i + 1), p[2].data());
      volume += vtkMath::Determinant3x3(p[0].data(), p[1].data(), p[2].data()) / 6.;
    }
  }
  return volume;
}

}

TEST(SurfaceDefaults, SchemeFollowsTheMajorityOfFaces)
{
  EXPECT_EQ(vtkSmartPointer<vtkSurfaceSubdivision>::New()->GetScheme(), Automatic);
  EXPECT_EQ(FindScheme(MakeRow(3, 1)), CatmullClark); // three quads, two triangles
  EXPECT_EQ(FindScheme(MakeRow(2, 1)), Loop);         // as many triangles as quads
  EXPECT_EQ(FindScheme(MakeRow(0, 3)), Loop);
  EXPECT_EQ(
    FindScheme(MakeInput(std::vector<Point>{ { 0, 0, 0 }, { 1, 0, 0 } }, {}, { { 0, 1 } })), Loop);
  const Surface strip = MakeRow(3, 0);
  strip->SetStrips(vtkSmartPointer<vtkCellArray>::New());
  strip->GetStrips()->InsertNextCell({ 0, 1, 2, 3, 5 });
  EXPECT_EQ(FindScheme(strip), Loop); // three triangles
}

TEST(SurfaceDefaults, HiddenAndGhostCellsDoNotCount)
{
  const Surface row = MakeRow(3, 1);
  for (const int type : { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::DUPLICATECELL })
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType c = 0; c < row->GetNumberOfCells(); ++c)
    {
      ghosts->InsertNextValue(
        static_cast<unsigned char>(c + 1 == row->GetNumberOfCells() ? type : 0));
    }
    row->GetCellData()->AddArray(ghosts);
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetInputData(row);
    vtkNew<Messages> heard;
    heard->Watch(filter);
    filter->Update();
    EXPECT_EQ(filter->GetSchemeInUse(), Loop) << type;
  }
}

TEST(SurfaceDefaults, CellsThatAreLeftOutDoNotCount)
{
  const Surface row = MakeRow(3, 1);
  row->GetPoints()->SetPoint(
    row->GetNumberOfPoints() - 1, std::numeric_limits<double>::quiet_NaN(), 0., 0.);
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(row);
  vtkNew<Messages> heard;
  heard->Watch(filter);
  filter->Update();
  EXPECT_EQ(filter->GetSchemeInUse(), Loop); // two quads are left, beside two triangles
}

TEST(SurfaceDefaults, AutomaticIsTheSchemeItTakesBitForBit)
{
  for (const bool quads : { true, false })
  {
    const Surface input = quads ? MakeRow(5, 1) : MakeRow(1, 4);
    const int scheme = quads ? CatmullClark : Loop;
    const Surface named = RunFilter(input, scheme, 2, true);
    ExpectSameBits(RunFilter(input, Automatic, 2, true), named);
    // The second filter sees the cells that the first made, and goes on.
    ExpectSameBits(RunFilter(RunFilter(input, Automatic, 1), Automatic, 1, true), named);
  }
}

TEST(SurfaceDefaults, ChoiceIsMadeAnewForEachInput)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  for (const bool quads : { true, false, true })
  {
    UpdateInSilence(filter, quads ? MakeRow(4, 0) : MakeRow(0, 4));
    EXPECT_EQ(filter->GetSchemeInUse(), quads ? CatmullClark : Loop);
  }
  const auto blocks =
    MakeBlocks(std::vector<vtkSmartPointer<vtkPointSet>>{ MakeRow(0, 2), MakeRow(9, 0) });
  filter->SetInputData(blocks);
  filter->Update();
  EXPECT_EQ(filter->GetSchemeInUse(), CatmullClark) << "one scheme for all blocks";
}

TEST(SurfaceDefaults, SolidsBecomeTheirOutside)
{
  const Grid cubes = MakeCubes(2);
  const vtkIdType points = cubes->GetNumberOfPoints();
  cubes->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("heat", 1, points, 0., 9., 3));
  cubes->GetCellData()->AddArray(MakeArray<vtkIntArray>("region", 1, 10, 0, 99, 4));
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetNumberOfLevels(0);
  filter->GenerateOriginalIdsOn();
  vtkNew<Messages> heard;
  UpdateInSilence(filter, cubes, heard);
  EXPECT_EQ(heard->Warnings.size(), 1u);
  EXPECT_EQ(heard->CountWarnings("8 cell(s) are solids, the first is cell 0"), 1);
  EXPECT_EQ(heard->CountWarnings("takes their outside, 23 face(s)"), 1);
  vtkPolyData* outside = filter->GetOutput();
  ASSERT_EQ(outside->GetNumberOfPolys(), filter->GetSchemeInUse() == Loop ? 49 : 25);
  EXPECT_EQ(outside->GetNumberOfPoints(), points);
  for (vtkIdType i = 0; i < points; ++i)
  {
    EXPECT_EQ(outside->GetPointData()->GetArray("heat")->GetComponent(i, 0),
      cubes->GetPointData()->GetArray("heat")->GetComponent(i, 0));
  }
  auto* ids = outside->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < outside->GetNumberOfCells(); ++c)
  {
    const auto id = static_cast<vtkIdType>(ids->GetComponent(c, 0));
    EXPECT_EQ(outside->GetCellData()->GetArray("region")->GetComponent(c, 0),
      cubes->GetCellData()->GetArray("region")->GetComponent(id, 0));
  }
}

TEST(SurfaceDefaults, OutsideOfSolidsIsClosedAndLooksOutwards)
{
  const Grid cubes = MakeCubes(2);
  vtkNew<vtkExtractDimensions> solids;
  solids->SetInputData(cubes);
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputConnection(solids->GetOutputPort());
  filter->SetNumberOfLevels(0);
  vtkNew<Messages> heard;
  heard->Watch(filter);
  filter->Update();
  EXPECT_EQ(filter->GetSchemeInUse(), CatmullClark); // no polygons, so the faces of solids count
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 24);
  EXPECT_NEAR(GetVolume(filter->GetOutput()), 8., 1e-12);
}

TEST(SurfaceDefaults, SolidsThatBlocksShareAreLeftOut)
{
  const Grid cubes = MakeCubes(1);
  const auto blocks = MakeBlocks(std::vector<Grid>{ cubes, MakeCubes(2) });
  vtkNew<vtkSurfaceSubdivision> filter;
  vtkNew<Messages> heard;
  heard->Watch(filter);
  filter->SetInputData(blocks);
  filter->Update();
  EXPECT_EQ(heard->CountWarnings("leaves them out, because blocks or ranks share them"), 2);
  filter->JoinBlocksOff();
  filter->Update();
  EXPECT_EQ(heard->CountWarnings("takes their outside"), 2);
}
