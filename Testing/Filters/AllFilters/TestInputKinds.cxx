// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestInputKinds.cxx
 * Structured data and non-linear cells through the filters: each input gives what a grid
 * or surface gives that is made of it by hand, bit for bit.
 */
#include "SelectionTools.h"
#include "SubdivisionDeformationTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkStructuredGrid.h"
#include "vtkSurfaceSubdivision.h"

using namespace deformation_tools;

namespace
{

using Dimensions = std::array<int, 3>;
using DataSet = vtkSmartPointer<vtkDataSet>;

void AddValues(vtkDataSet* data)
{
  data->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Values", 1, data->GetNumberOfPoints(), 0, 1, 7));
  data->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("MaterialId", 1, data->GetNumberOfCells(), 0, 3, 8));
}

/// One of each class, not regular where the class allows it.
std::vector<DataSet> MakeStructured(const Dimensions& n)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 1 + n[0], -1, n[1] - 2, 0, n[2] - 1);
  image->SetSpacing(.5, 1, .75);
  image->SetOrigin(1, 2, 3);
  vtkNew<vtkRectilinearGrid> rectilinear;
  rectilinear->SetDimensions(n.data());
  vtkSmartPointer<vtkDoubleArray> axes[3];
  for (int a = 0; a < 3; ++a)
  {
    axes[a] = vtkSmartPointer<vtkDoubleArray>::New();
    for (int i = 0; i < n[a]; ++i)
    {
      axes[a]->InsertNextValue(i + .1 * i * i);
    }
  }
  rectilinear->SetXCoordinates(axes[0]);
  rectilinear->SetYCoordinates(axes[1]);
  rectilinear->SetZCoordinates(axes[2]);
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(n.data());
  vtkNew<vtkPoints> points;
  points->SetData(MakeArray<vtkDoubleArray>("", 3, rectilinear->GetNumberOfPoints(), 0, .2, 9));
  for (vtkIdType i = 0; i < rectilinear->GetNumberOfPoints(); ++i)
  {
    double x[3];
    rectilinear->GetPoint(i, x);
    double given[3];
    points->GetPoint(i, given);
    points->SetPoint(i, x[0] + given[0], x[1] + given[1], x[2] + given[2]);
  }
  structured->SetPoints(points);
  std::vector<DataSet> all = { image.Get(), rectilinear.Get(), structured.Get() };
  for (const DataSet& data : all)
  {
    AddValues(data);
  }
  return all;
}

/// Hides a cell and a point.
void Hide(vtkDataSet* data, vtkIdType cell, vtkIdType point)
{
  vtkNew<vtkUnsignedCharArray> cells;
  cells->SetName(vtkDataSetAttributes::GhostArrayName());
  cells->SetNumberOfValues(data->GetNumberOfCells());
  cells->FillValue(0);
  cells->SetValue(cell, vtkDataSetAttributes::HIDDENCELL);
  vtkNew<vtkUnsignedCharArray> points;
  points->SetName(vtkDataSetAttributes::GhostArrayName());
  points->SetNumberOfValues(data->GetNumberOfPoints());
  points->FillValue(0);
  points->SetValue(point, vtkDataSetAttributes::HIDDENPOINT);
  data->GetCellData()->AddArray(cells);
  data->GetPointData()->AddArray(points);
}

/// The cells as VTK says they are, without the hidden ones; `to` is empty.
template <typename Mesh>
vtkSmartPointer<Mesh> CopyByHand(vtkDataSet* data)
{
  auto to = vtkSmartPointer<Mesh>::New();
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  vtkDataArray* ofCells = data->GetCellData()->GetArray(ghosts);
  vtkDataArray* ofPoints = data->GetPointData()->GetArray(ghosts);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(data->GetPoint(i));
  }
  to->SetPoints(points);
  to->GetPointData()->ShallowCopy(data->GetPointData());
  to->GetPointData()->RemoveArray(ghosts);
  to->GetCellData()->CopyAllocate(data->GetCellData());
  to->Allocate(data->GetNumberOfCells());
  // Without blanking, so that VTK tells the types of all cells.
  const auto plain = DataSet::Take(data->NewInstance());
  plain->ShallowCopy(data);
  plain->GetCellData()->RemoveArray(ghosts);
  plain->GetPointData()->RemoveArray(ghosts);
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    plain->GetCellPoints(c, ids);
    bool isHidden = ofCells && ofCells->GetComponent(c, 0) > 0;
    for (const vtkIdType id : *ids)
    {
      isHidden = isHidden || (ofPoints && ofPoints->GetComponent(id, 0) > 0);
    }
    int type = plain->GetCellType(c);
    if (type == VTK_PIXEL && to->IsA("vtkPolyData"))
    {
      const vtkIdType third = ids->GetId(2);
      ids->SetId(2, ids->GetId(3));
      ids->SetId(3, third);
      type = VTK_QUAD;
    }
    if (!isHidden)
    {
      to->GetCellData()->CopyData(data->GetCellData(), c, to->InsertNextCell(type, ids));
    }
  }
  to->GetCellData()->RemoveArray(ghosts);
  return to;
}

/// What a filter makes, as a data set that is compared; it may not say anything unless `heard`.
vtkSmartPointer<vtkDataObject> RunAlone(
  vtkAlgorithm* filter, vtkDataObject* input, Messages* heard = nullptr)
{
  UpdateInSilence(filter, input, heard);
  return filter->GetOutputDataObject(0);
}

std::string CompareAny(vtkDataObject* a, vtkDataObject* b)
{
  auto* x = vtkPointSet::SafeDownCast(a);
  auto* y = vtkPointSet::SafeDownCast(b);
  for (vtkPointSet* mesh : { x, y })
  {
    mesh->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    mesh->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    mesh->GetCellData()->RemoveArray("vtkOriginalCellIds"); // which count hidden cells
  }
  return x->GetNumberOfCells() == 0 ? "no cells" : Compare(x, y, false);
}

vtkSmartPointer<vtkAlgorithm> MakeFilter(int which)
{
  if (which == 0)
  {
    auto filter = vtkSmartPointer<vtkMultiDimensionalSubdivision>::New();
    filter->PreserveInterfacesOn();
    filter->GenerateClassificationOn();
    return filter;
  }
  if (which == 1)
  {
    auto filter = vtkSmartPointer<vtkRedGreenRefinement>::New();
    filter->RefineByAttributeErrorOff();
    filter->RefineByEdgeLengthOn();
    filter->SetMaximumEdgeLength(.9);
    return filter;
  }
  if (which == 2)
  {
    return vtkSmartPointer<vtkSimplicialComplexTopology>::New();
  }
  if (which == 3)
  {
    auto filter = vtkSmartPointer<vtkSurfaceSubdivision>::New();
    filter->SetSchemeToCatmullClark();
    return filter;
  }
  auto filter = vtkSmartPointer<vtkAdaptiveSurfaceSubdivision>::New();
  filter->RefineByAttributeErrorOff();
  filter->RefineByGeometricErrorOff();
  filter->RefineByEdgeLengthOn();
  filter->SetMaximumEdgeLength(.9);
  return filter;
}

}

TEST(InputKinds, StructuredDataAreWhatTheirCellsAre)
{
  const std::vector<Dimensions> shapes = { { 4, 3, 5 }, { 5, 4, 1 }, { 5, 1, 4 }, { 1, 5, 4 },
    { 6, 1, 1 } };
  for (const Dimensions& shape : shapes)
  {
    for (const bool hides : { false, true })
    {
      for (const DataSet& data : MakeStructured(shape))
      {
        if (hides)
        {
          Hide(data, data->GetNumberOfCells() - 1, 1);
        }
        for (int which = 0; which < 3; ++which)
        {
          EXPECT_EQ(CompareAny(RunAlone(MakeFilter(which), data),
                      RunAlone(MakeFilter(which), CopyByHand<vtkUnstructuredGrid>(data))),
            "")
            << data->GetClassName() << " filter " << which << " hides " << hides << " " << shape[0]
            << shape[1] << shape[2];
        }
      }
    }
  }
}

TEST(InputKinds, FlatStructuredDataAreSurfaces)
{
  for (const Dimensions& shape : { Dimensions{ 5, 4, 1 }, Dimensions{ 5, 1, 4 } })
  {
    for (const bool hides : { false, true })
    {
      for (const DataSet& data : MakeStructured(shape))
      {
        if (hides)
        {
          Hide(data, 3, 1);
        }
        for (int which = 3; which < 5; ++which)
        {
          vtkNew<Messages> heard; // schemes of triangles tell that they split quads
          EXPECT_EQ(CompareAny(RunAlone(MakeFilter(which), data, heard),
                      RunAlone(MakeFilter(which), CopyByHand<vtkPolyData>(data), heard)),
            "")
            << data->GetClassName() << " filter " << which << " hides " << hides;
          EXPECT_TRUE(heard->Errors.empty());
        }
      }
    }
  }
}

TEST(InputKinds, AnExplicitGridIsOfHexahedra)
{
  const DataSet structured = MakeStructured({ 3, 4, 3 })[2];
  vtkNew<vtkExplicitStructuredGrid> grid;
  grid->SetDimensions(3, 4, 3);
  grid->SetPoints(vtkPointSet::SafeDownCast(structured)->GetPoints());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType c = 0; c < structured->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    structured->GetCellPoints(c, ids);
    cells->InsertNextCell(ids);
  }
  grid->SetCells(cells);
  AddValues(grid);
  EXPECT_EQ(CompareAny(RunAlone(MakeFilter(0), grid),
              RunAlone(MakeFilter(0), CopyByHand<vtkUnstructuredGrid>(structured))),
    "");
}

TEST(InputKinds, NewValuesOfAnImageBuildNothing)
{
  const DataSet image = MakeStructured({ 4, 4, 4 })[0];
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  RunAlone(filter, image);
  image->GetPointData()->GetArray("Values")->SetComponent(3, 0, 5.);
  image->GetPointData()->GetArray("Values")->Modified();
  image->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
}

TEST(InputKinds, BlocksMayBeStructured)
{
  // Two images with a common face are one mesh.
  vtkNew<vtkMultiBlockDataSet> images;
  vtkNew<vtkMultiBlockDataSet> grids;
  for (unsigned int b = 0; b < 2; ++b)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 3, 3);
    image->SetOrigin(2. * b, 0, 0);
    AddValues(image);
    images->SetBlock(b, image);
    grids->SetBlock(b, CopyByHand<vtkUnstructuredGrid>(image));
  }
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  vtkNew<vtkMultiDimensionalSubdivision> other;
  vtkNew<Messages> messages; // their values differ on the common face
  auto* result = vtkMultiBlockDataSet::SafeDownCast(RunAlone(filter, images, messages));
  auto* expected = vtkMultiBlockDataSet::SafeDownCast(RunAlone(other, grids, messages));
  ASSERT_TRUE(result && expected);
  EXPECT_EQ(messages->CountWarnings("in the point array \"Values\" (blocks 1 and 2)"), 2);
  for (unsigned int b = 0; b < 2; ++b)
  {
    EXPECT_EQ(CompareAny(result->GetBlock(b), expected->GetBlock(b)), "");
  }
}

TEST(InputKinds, ASelectionOfAnImageIsThatOfItsCells)
{
  const DataSet image = MakeStructured({ 4, 4, 4 })[0];
  const auto selection = selection_tools::MakeSelection(vtkSelectionNode::CELL, { 13 });
  vtkSmartPointer<vtkDataObject> results[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkRedGreenRefinement> filter;
    filter->RefineByAttributeErrorOff();
    filter->RefineBySelectionOn();
    filter->SetMaximumLevel(1);
    filter->SetInputDataObject(1, selection);
    results[i] = RunAlone(filter, i == 0 ? image : DataSet(CopyByHand<vtkUnstructuredGrid>(image)));
  }
  EXPECT_EQ(CompareAny(results[0], results[1]), "");
  EXPECT_GT(vtkDataSet::SafeDownCast(results[0])->GetNumberOfCells(), 6 * 27);
}

TEST(InputKinds, CagesAndObjectsMayBeStructured)
{
  vtkNew<vtkImageData> cage;
  cage->SetDimensions(4, 4, 4);
  cage->SetSpacing(.5, .5, .5);
  const auto grid = CopyByHand<vtkUnstructuredGrid>(cage);
  vtkNew<vtkImageData> object;
  object->SetDimensions(5, 5, 2);
  object->SetOrigin(.2, .2, .2);
  object->SetSpacing(.2, .2, .2);
  Deformer deformer;
  const auto result = deformer.Run(object, cage, Moved(grid, Affine));
  ASSERT_TRUE(vtkStructuredGrid::SafeDownCast(result));
  EXPECT_LT(GetLargestError(result, CopyByHand<vtkUnstructuredGrid>(object), Affine), 1e-12);
  EXPECT_EQ(deformer->GetNumberOfTopologyBuilds(), 1);
  cage->Modified();
  deformer.Run(object, cage, Moved(grid, Bend));
  EXPECT_EQ(deformer->GetNumberOfTopologyBuilds(), 1);
  EXPECT_EQ(deformer->GetNumberOfLocationBuilds(), 1);
  EXPECT_TRUE(deformer.WasSilent());
}

// ------------------------------------------------------------------------------------------------
// Non-linear cells

namespace
{

/// A quadratic tetrahedron with straight sides, and a quadratic triangle on one of its faces.
Grid MakeQuadratic()
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, 0, 0 },
                               { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 } },
    { { VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } },
      { VTK_QUADRATIC_TRIANGLE, { 0, 2, 1, 6, 5, 4 } }, { VTK_LINE, { 4, 1 } } });
  AddValues(grid);
  return grid;
}

}

TEST(InputKinds, CornersAreOneLinearCellAndOneWarning)
{
  const Grid quadratic = MakeQuadratic();
  const Grid linear = MakeGrid(
    {}, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 2, 1 } }, { VTK_LINE, { 4, 1 } } });
  linear->SetPoints(quadratic->GetPoints());
  linear->GetPointData()->ShallowCopy(quadratic->GetPointData());
  linear->GetCellData()->ShallowCopy(quadratic->GetCellData());
  for (int which = 0; which < 3; ++which)
  {
    vtkNew<Messages> heard;
    vtkNew<Messages> ofLinear;
    EXPECT_EQ(CompareAny(RunAlone(MakeFilter(which), quadratic, heard),
                RunAlone(MakeFilter(which), linear, ofLinear)),
      "");
    // The end of the line hangs, of which red-green refinement tells only where it splits.
    EXPECT_LE(ofLinear->Warnings.size(), 1u);
    EXPECT_EQ(ofLinear->CountWarnings("1 point hangs"), int(ofLinear->Warnings.size()));
    ASSERT_EQ(heard->Warnings.size(), 1u + ofLinear->Warnings.size());
    EXPECT_EQ(heard->CountWarnings("2 cells are not linear (the first is cell 0"), 1);
    EXPECT_EQ(heard->CountWarnings("5 nodes that no cell uses any more"), 1) << heard->Warnings[0];
    EXPECT_TRUE(heard->Errors.empty());
  }
}

TEST(InputKinds, PiecesKeepAllPointsAndArrays)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetQuadraticCellsToPieces();
  filter->SetNumberOfLevels(0);
  filter->GenerateOriginalIdsOn();
  const Grid quadratic = MakeQuadratic();
  auto* result = vtkUnstructuredGrid::SafeDownCast(RunAlone(filter, quadratic));
  ASSERT_EQ(result->GetNumberOfCells(), 8 + 4 + 1);
  EXPECT_EQ(result->GetNumberOfPoints(), 10);
  vtkDataArray* materials = result->GetCellData()->GetArray("MaterialId");
  vtkDataArray* originals = result->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < 13; ++c)
  {
    const vtkIdType cell = c < 8 ? 0 : (c < 12 ? 1 : 2);
    EXPECT_EQ(originals->GetComponent(c, 0), static_cast<double>(cell));
    EXPECT_EQ(materials->GetComponent(c, 0),
      quadratic->GetCellData()->GetArray("MaterialId")->GetComponent(cell, 0));
  }
  EXPECT_EQ(CompareValues(result->GetPointData()->GetArray("Values"),
              quadratic->GetPointData()->GetArray("Values")),
    "");
  filter->SetNumberOfLevels(1);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 8 * 8 + 4 * 4 + 2);
}

TEST(InputKinds, BlocksShareTheNodesOfNonLinearCells)
{
  // Cut in pieces, two blocks are what one grid is.
  const Grid whole = MakeGrid({ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, 0, 0 },
                                { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 },
                                { 0, 0, -2 }, { 0, 0, -1 }, { 1, 0, -1 }, { 0, 1, -1 } },
    { { VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } },
      { VTK_QUADRATIC_TETRA, { 0, 2, 1, 10, 6, 5, 4, 11, 13, 12 } } });
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int b = 0; b < 2; ++b)
  {
    const Grid part = MakeGrid({}, { { VTK_QUADRATIC_TETRA, GetCell(whole, b) } });
    part->SetPoints(whole->GetPoints());
    blocks->SetBlock(b, part);
  }
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  vtkNew<vtkMultiDimensionalSubdivision> other;
  filter->SetQuadraticCellsToPieces();
  other->SetQuadraticCellsToPieces();
  auto* result = vtkMultiBlockDataSet::SafeDownCast(RunAlone(filter, blocks));
  auto* expected = vtkUnstructuredGrid::SafeDownCast(RunAlone(other, whole));
  ASSERT_TRUE(result && expected);
  EXPECT_EQ(expected->GetNumberOfCells(), 128);
  std::set<Point> points;
  vtkIdType cells = 0;
  for (unsigned int b = 0; b < 2; ++b)
  {
    auto* part = vtkPointSet::SafeDownCast(result->GetBlock(b));
    cells += part->GetNumberOfCells();
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      points.insert(GetPoint(part, i));
    }
  }
  EXPECT_EQ(cells, 128);
  EXPECT_EQ(points.size(), static_cast<size_t>(expected->GetNumberOfPoints()));
}

TEST(InputKinds, SurfaceFiltersReadGridsOfSurfaces)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 },
    { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 3, 1, 1 }, { 0, 0, 3 } };
  const Grid grid = MakeGrid(points,
    { { VTK_TETRA, { 0, 1, 2, 10 } }, { VTK_BIQUADRATIC_QUAD, { 0, 1, 2, 3, 4, 5, 6, 7, 8 } },
      { VTK_TRIANGLE, { 1, 9, 5 } }, { VTK_LINE, { 0, 4 } } });
  AddValues(grid);
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetSchemeToCatmullClark();
  filter->SetNumberOfLevels(0);
  filter->SetQuadraticCellsToPieces();
  filter->GenerateOriginalIdsOn();
  vtkNew<Messages> heard;
  auto* result = vtkPolyData::SafeDownCast(RunAlone(filter, grid, heard));
  ASSERT_TRUE(result);
  EXPECT_EQ(heard->Warnings.size(), 2u);
  EXPECT_EQ(heard->CountWarnings("of another cell"), 1); // the nodes of the quad, on a tetrahedron
  EXPECT_EQ(heard->CountWarnings("1 cell(s) are solids, the first is cell 0"), 1);
  EXPECT_TRUE(heard->Errors.empty());
  ASSERT_EQ(result->GetNumberOfCells(), 1 + 4 + 1 + 4);
  EXPECT_EQ(result->GetNumberOfPolys(), 9);
  const std::vector<double> sources = { 3, 1, 1, 1, 1, 2, 0, 0, 0, 0 };
  for (vtkIdType c = 0; c < 10; ++c)
  {
    EXPECT_EQ(
      result->GetCellData()->GetArray("vtkOriginalCellIds")->GetComponent(c, 0), sources[c]);
    EXPECT_EQ(result->GetCellData()->GetArray("MaterialId")->GetComponent(c, 0),
      grid->GetCellData()
        ->GetArray("MaterialId")
        ->GetComponent(static_cast<vtkIdType>(sources[c]), 0));
  }
}
