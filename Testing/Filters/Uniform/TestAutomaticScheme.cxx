// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestAutomaticScheme.cxx
 * VolumeScheme = AUTOMATIC, the default: HYBRID where cells would be cut and it can, else
 * BOX_SPLINE.
 */
#include "OperatorCacheTools.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSubdivisionOperator.h"

using namespace operator_cache_tools;

namespace
{

/// With the default scheme.
Grid RunDefault(
  vtkDataObject* input, int levels, const Configure& configure = {}, Messages* messages = nullptr)
{
  const int scheme = vtkNew<Filter>()->GetVolumeScheme();
  return operator_cache_tools::Execute(
    input, levels,
    [&](Filter* filter)
    {
      filter->SetVolumeScheme(scheme);
      configure ? configure(filter) : void();
    },
    messages);
}

const std::vector<Point> Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1.2 }, { 0, 1, 1 }, { 3, 0, 0 }, { 4, 0, 0 }, { 3, 1, 0 }, { 3, 0, 1 } };

/// A cell beside a tetrahedron that does not touch it.
Grid MakeGrid(int type, const std::vector<vtkIdType>& corners)
{
  const Grid grid =
    operator_cache_tools::MakeGrid(Points, { { type, corners }, { VTK_TETRA, { 8, 9, 10, 11 } } });
  AddArrays(grid);
  return grid;
}
Grid MakeHexahedron()
{
  return MakeGrid(VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
}

Configure Take(int scheme, const Configure& more = {})
{
  return [=](Filter* filter)
  {
    filter->SetVolumeScheme(scheme);
    more ? more(filter) : void();
  };
}

void ExpectSame(vtkUnstructuredGrid* found, vtkUnstructuredGrid* expected, const std::string& what)
{
  EXPECT_EQ(Compare(found, expected), "") << what;
}

}

TEST(AutomaticScheme, IsTheDefault)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetVolumeScheme(), int(Filter::AUTOMATIC));
  EXPECT_EQ(int(Filter::AUTOMATIC), 4) << "states and scripts hold the number";
  EXPECT_EQ(int(Filter::HYBRID), 3);
  filter->SetVolumeSchemeToHybrid();
  filter->SetVolumeSchemeToAutomatic();
  EXPECT_EQ(filter->GetVolumeScheme(), int(Filter::AUTOMATIC));
}

TEST(AutomaticScheme, CellsThatWouldBeCutKeepTheirTypes)
{
  const std::vector<std::pair<int, std::vector<vtkIdType>>> cells = {
    { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_VOXEL, { 0, 1, 3, 2, 4, 5, 7, 6 } },
    { VTK_WEDGE, { 0, 1, 2, 4, 5, 6 } }, { VTK_PYRAMID, { 0, 1, 2, 3, 4 } },
    { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_PIXEL, { 0, 1, 3, 2 } }, { VTK_POLYGON, { 0, 1, 2, 3 } }
  };
  for (const auto& [type, corners] : cells)
  {
    const Grid input = MakeGrid(type, corners);
    ExpectSame(
      RunDefault(input, 2), RunDefault(input, 2, Take(Filter::HYBRID)), std::to_string(type));
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(MakeHexahedron()->GetPoints());
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 2, 3 });
  surface->SetPolys(quads);
  EXPECT_EQ(RunDefault(surface, 1)->GetCellType(0), VTK_QUAD);
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  EXPECT_EQ(RunDefault(image, 1)->GetNumberOfCells(), 64);
}

TEST(AutomaticScheme, SimplicesAreThoseOfTheBoxSpline)
{
  for (const auto& [type, corners] :
    std::vector<std::pair<int, std::vector<vtkIdType>>>{ { VTK_TETRA, { 0, 1, 2, 4 } },
      { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_LINE, { 0, 1 } }, { VTK_POLYGON, { 0, 1, 2 } } })
  {
    const Grid input = MakeGrid(type, corners);
    const Configure limits = [](Filter* filter) { filter->ProjectToLimitOn(); };
    ExpectSame(RunDefault(input, 2), RunDefault(input, 2, Take(Filter::BOX_SPLINE)), "");
    ExpectSame(
      RunDefault(input, 1, limits), RunDefault(input, 1, Take(Filter::BOX_SPLINE, limits)), "");
  }
}

/// A quad that is hidden is no reason, and what an earlier filter cut stays cut.
TEST(AutomaticScheme, HiddenAndCutCells)
{
  const Grid input = MakeHexahedron();
  input->AllocateCellGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  EXPECT_EQ(RunDefault(input, 1)->GetNumberOfCells(), 8);
  const Grid cut = RunDefault(MakeHexahedron(), 1, Take(Filter::BOX_SPLINE));
  ExpectSame(
    RunDefault(cut, 1), RunDefault(MakeHexahedron(), 2, Take(Filter::BOX_SPLINE)), "in a row");
  vtkNew<vtkImageData> voxel;
  voxel->SetDimensions(2, 2, 2);
  ExpectSame(RunDefault(RunDefault(voxel, 1), 1), RunDefault(voxel, 2), "uncut");
}

/// Where HYBRID has an option, it is taken; else BOX_SPLINE, and one warning names the option.
TEST(AutomaticScheme, OptionsDecide)
{
  const std::vector<std::pair<std::string, Configure>> cases = {
    { "ProjectToLimit", [](Filter* filter) { filter->ProjectToLimitOn(); } },
    { "GenerateLimitNormals", [](Filter* filter) { filter->GenerateLimitNormalsOn(); } },
    { "GenerateTangents", [](Filter* filter) { filter->GenerateTangentsOn(); } },
    { "GenerateClassification", [](Filter* filter) { filter->GenerateClassificationOn(); } },
    { "Interpolation", [](Filter* filter) { filter->InterpolatePointsOn(); } },
    { "OutputCells = Bezier", [](Filter* filter) { filter->SetOutputCellsToBezier(); } },
    { "GenerateErrorBounds", [](Filter* filter) { filter->GenerateErrorBoundsOn(); } },
  };
  const Grid input = MakeHexahedron();
  for (const auto& [name, configure] : cases)
  {
    vtkNew<Messages> ofHybrid;
    const Grid hybrid = RunDefault(input, 1, Take(Filter::HYBRID, configure), ofHybrid);
    vtkNew<Messages> ofBoxSpline;
    const Grid boxSpline = RunDefault(input, 1, Take(Filter::BOX_SPLINE, configure), ofBoxSpline);
    vtkNew<Messages> messages;
    const Grid output = RunDefault(input, 1, Take(Filter::AUTOMATIC, configure), messages);
    const bool can = ofHybrid->Errors.empty() && ofHybrid->CountWarnings("is ignored") == 0 &&
      ofHybrid->CountWarnings("stay linear") == 0;
    EXPECT_TRUE(messages->Errors.empty()) << name;
    ExpectSame(output, can ? hybrid : boxSpline, name);
    EXPECT_EQ(messages->CountWarnings("Automatic takes BoxSpline"), can ? 0 : 1) << name;
    EXPECT_TRUE(can || messages->CountWarnings(name)) << name;
    // Of a mesh of simplices nobody has to be told.
    vtkNew<Messages> ofTetrahedra;
    RunDefault(MakeGrid(VTK_TETRA, { 0, 1, 2, 4 }), 1, configure, ofTetrahedra);
    EXPECT_EQ(ofTetrahedra->CountWarnings("BoxSpline"), 0) << name;
  }
}

TEST(AutomaticScheme, OperatorsAreThoseOfTheOutput)
{
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputData(MakeHexahedron());
  vtkNew<vtkSubdivisionOperator> result;
  ASSERT_TRUE(filter->ComputeOperator(result));
  filter->Update();
  EXPECT_EQ(result->GetNumberOfRows(), filter->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(filter->GetOutput()->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_TRUE(messages->Warnings.empty());
}

/// Blocks that are one mesh have one scheme, others each their own.
TEST(AutomaticScheme, Blocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeHexahedron());
  blocks->SetBlock(1, MakeGrid(VTK_TETRA, { 0, 1, 2, 4 }));
  const auto types = [&](bool joins)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(blocks);
    filter->SetJoinBlocks(joins);
    filter->Update();
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    std::vector<vtkIdType> counts;
    for (unsigned int b = 0; b < 2; ++b)
    {
      auto* grid = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(b));
      counts.push_back(grid->GetCellType(0));
      counts.push_back(grid->GetCellData()->HasArray("OctahedronId"));
    }
    return counts;
  };
  EXPECT_EQ(types(true), (std::vector<vtkIdType>{ VTK_HEXAHEDRON, 1, VTK_TETRA, 1 }));
  EXPECT_EQ(types(false), (std::vector<vtkIdType>{ VTK_HEXAHEDRON, 1, VTK_TETRA, 0 }));
}
