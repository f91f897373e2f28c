// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionLabelSolidInput.cxx
 * What vtkSubdivisionLabelSolid makes of arrays that do not fit.
 */
#include "LabelTools.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"

using namespace label_tools;

namespace
{

/// The image as a rectilinear grid, with coordinates of its points by their index.
vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear(
  vtkImageData* image, const std::function<double(int)>& coordinate)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  const int* n = image->GetDimensions();
  grid->SetDimensions(n[0], n[1], n[2]);
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkDoubleArray> values;
    for (int i = 0; i < n[axis]; ++i)
    {
      values->InsertNextValue(coordinate(i));
    }
    axis == 0     ? grid->SetXCoordinates(values)
      : axis == 1 ? grid->SetYCoordinates(values)
                  : grid->SetZCoordinates(values);
  }
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  grid->GetCellData()->ShallowCopy(image->GetCellData());
  return grid;
}

/// The grid with its points moved.
vtkSmartPointer<vtkStructuredGrid> MakeStructured(
  vtkRectilinearGrid* grid, const std::function<Point(const Point&)>& move)
{
  auto moved = vtkSmartPointer<vtkStructuredGrid>::New();
  moved->SetDimensions(grid->GetDimensions());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    Point x;
    grid->GetPoint(p, x.data());
    points->InsertNextPoint(move(x).data());
  }
  moved->SetPoints(points);
  moved->GetPointData()->ShallowCopy(grid->GetPointData());
  moved->GetCellData()->ShallowCopy(grid->GetCellData());
  return moved;
}

double GetVolume(vtkUnstructuredGrid* solid, double label)
{
  vtkDataArray* labels = solid->GetCellData()->GetArray("Tissue");
  double volume = 0.;
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    const vtkIdType* ids = nullptr;
    vtkIdType size = 0;
    solid->GetCellPoints(c, size, ids);
    double edges[3][3];
    for (int k = 0; k < 3; ++k)
    {
      vtkMath::Subtract(
        GetPoint(solid, ids[k + 1]).data(), GetPoint(solid, ids[0]).data(), edges[k]);
    }
    volume += labels->GetComponent(c, 0) == label ? vtkMath::Determinant3x3(edges) / 6. : 0.;
  }
  return volume;
}

}

// Arrays that cannot be true, voxels without a volume.
TEST(SubdivisionLabelSolid, ForgedInput)
{
  for (const vtkIdType size : { 0, 3, 26, 28, 1000 })
  {
    const Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; });
    image->GetPointData()->GetScalars()->SetNumberOfTuples(size);
    Made made;
    made.Run(image);
    made.ExpectError("The input has no labels");
  }
  {
    Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; });
    image->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("short", 1, 3, 0., 1., 1));
    Made made;
    EXPECT_FALSE(made.Run(image)->GetCellData()->HasArray("short"));
    EXPECT_EQ(made.Heard->CountWarnings("\"short\""), 1);
  }
  {
    const Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; });
    image->SetSpacing(0., 1., 1.);
    Made made;
    made.Run(image);
    made.ExpectError("spacing is 0.0");
  }
}

// The arrays of field data have different sizes: those of the labels' size are the columns.
TEST(SubdivisionLabelSolid, FieldDataWithOtherArrays)
{
  const Image image = MakeImage({ 3, 3, 3 }, [](int i, int, int) { return i < 2 ? 1 : 2; });
  vtkFieldData* fields = image->GetFieldData();
  fields->AddArray(MakeArray<vtkDoubleArray>("TimeValue", 1, 1, 3., 3., 1));
  const auto labels = MakeArray<vtkDoubleArray>("Label", 1, 4, 0., 0., 1);
  const auto values = MakeArray<vtkDoubleArray>("K", 1, 4, 0., 0., 1);
  labels->SetValue(0, std::nan(""));
  for (int i = 1; i < 4; ++i)
  {
    labels->SetValue(i, i);
    values->SetValue(i, 10. * i);
  }
  fields->AddArray(labels);
  fields->AddArray(values);
  Made made;
  vtkUnstructuredGrid* solid = made.Run(image);
  made.ExpectSilence();
  vtkDataArray* found = solid->GetCellData()->GetArray("K");
  vtkDataArray* tissues = solid->GetCellData()->GetArray("Tissue");
  ASSERT_TRUE(found && tissues);
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(10. * tissues->GetComponent(c, 0), found->GetComponent(c, 0));
  }
  EXPECT_FALSE(solid->GetCellData()->HasArray("TimeValue"));
  EXPECT_TRUE(solid->GetFieldData()->HasArray("TimeValue"));
}

TEST(SubdivisionLabelSolid, TablesThatAreNotClearAreTold)
{
  const Image image = MakeImage({ 3, 3, 3 }, [](int i, int, int) { return i < 2 ? 1 : 2; });
  image->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("K", 1, 27, 0., 1., 1));
  vtkNew<vtkTable> table;
  const auto labels = MakeArray<vtkDoubleArray>("Label", 1, 4, 0., 0., 1);
  const auto values = MakeArray<vtkDoubleArray>("K", 1, 4, 0., 0., 1);
  const int given[] = { 2, 1, 2, 7 };
  for (int i = 0; i < 4; ++i)
  {
    labels->SetValue(i, given[i]);
    values->SetValue(i, 10. + i);
  }
  table->AddColumn(labels);
  table->AddColumn(values);
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(table);
  {
    Made made;
    made->SetMaterialsConnection(source->GetOutputPort());
    vtkUnstructuredGrid* solid = made.Run(image);
    EXPECT_EQ(made.Heard->CountWarnings("several rows for label 2: the first counts"), 1);
    EXPECT_EQ(made.Heard->CountWarnings("\"K\" of the table of materials replaces the array"), 1);
    vtkDataArray* tissues = solid->GetCellData()->GetArray("Tissue");
    for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
    {
      ASSERT_EQ(solid->GetCellData()->GetArray("K")->GetComponent(c, 0),
        tissues->GetComponent(c, 0) == 2. ? 10. : 11.);
    }
  }
  table->RemoveColumnByName("Label");
  vtkNew<vtkStringArray> names;
  names->SetName("Label");
  names->SetNumberOfValues(4);
  table->AddColumn(names);
  Made made;
  made->SetMaterialsConnection(source->GetOutputPort());
  made.Run(image);
  EXPECT_EQ(made.Heard->CountWarnings("\"Label\" of the table of materials has no numbers"), 1);
}

TEST(SubdivisionLabelSolid, ProgressGoesOn)
{
  Made made;
  double last = 0.;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&last);
  listener->SetCallback(
    [](vtkObject*, unsigned long, void* at, void* data)
    {
      auto* before = static_cast<double*>(at);
      EXPECT_GE(*static_cast<double*>(data), *before);
      *before = *static_cast<double*>(data);
    });
  made.Filter->AddObserver(vtkCommand::ProgressEvent, listener);
  made.Run(MakeImage({ 6, 6, 6 }, [](int i, int j, int) { return i < 3 ? 1 : j < 2 ? 0 : 2; }));
  EXPECT_EQ(last, 1.);
}

TEST(SubdivisionLabelSolid, MeansOfLargeValuesAreFinite)
{
  const Image image = MakeImage({ 2, 2, 2 }, [](int, int, int) { return 1; });
  image->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Large", 1, 8, 1e308, 1e308, 1));
  Made made;
  made->SetNumberOfControlCells(1);
  vtkUnstructuredGrid* solid = made.Run(image);
  ASSERT_GT(solid->GetNumberOfCells(), 0);
  EXPECT_NEAR(solid->GetCellData()->GetArray("Large")->GetComponent(0, 0) / 1e308, 1., 1e-12);
}

TEST(SubdivisionLabelSolid, HiddenPointsHideTheirCells)
{
  const Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; }, true);
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName(vtkDataSetAttributes::GhostArrayName());
  hidden->SetNumberOfValues(64);
  hidden->FillValue(0);
  hidden->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  image->GetPointData()->AddArray(hidden);
  Made made;
  EXPECT_EQ(made.Run(image)->GetNumberOfCells(), 26 * 48);
  hidden->SetValue(1, vtkDataSetAttributes::HIDDENPOINT); // two cells, one of them hidden before
  image->Modified();
  EXPECT_EQ(made.Run(image)->GetNumberOfCells(), 25 * 48);
}

TEST(SubdivisionLabelSolid, EvenGridsAreImages)
{
  const auto ball = [](int i, int j, int k)
  { return (i - 4) * (i - 4) + (j - 4) * (j - 4) + (k - 3) * (k - 3) < 10 ? (i < 4 ? 1 : 2) : 0; };
  for (const bool ofCells : { false, true })
  {
    const Image image = MakeImage({ 9, 9, 8 }, ball, ofCells);
    const auto rectilinear = MakeRectilinear(image, [](int i) { return double(i); });
    const auto structured = MakeStructured(rectilinear, [](const Point& p) { return p; });
    Made made;
    const Grid expected = DeepCopy(made.Run(image));
    ASSERT_GT(expected->GetNumberOfCells(), 0);
    for (vtkDataSet* grid :
      { static_cast<vtkDataSet*>(rectilinear), static_cast<vtkDataSet*>(structured) })
    {
      vtkUnstructuredGrid* solid = made.Run(grid);
      made.ExpectSilence();
      ASSERT_EQ(solid->GetNumberOfPoints(), expected->GetNumberOfPoints());
      for (vtkIdType p = 0; p < solid->GetNumberOfPoints(); ++p)
      {
        for (int c = 0; c < 3; ++c)
        {
          ASSERT_NEAR(GetPoint(solid, p)[c], GetPoint(expected, p)[c], 1e-9);
        }
      }
    }
  }
}

TEST(SubdivisionLabelSolid, VolumesInUnevenGrids)
{
  // Cells grow by a tenth each; the sheared and mirrored grid has the same volumes.
  const auto coordinate = [](int i) { return 10. * (std::pow(1.1, i) - 1.); };
  const Image image = MakeImage(
    { 9, 8, 8 }, [](int i, int j, int k)
    { return i < 1 || j < 1 || k < 1 || i > 7 || j > 6 || k > 6 ? 0
        : i < 4                                                 ? 1
                                                                : 2; }, true);
  const auto rectilinear = MakeRectilinear(image, coordinate);
  const auto structured = MakeStructured(
    rectilinear, [](const Point& p) { return Point{ -p[0], p[1] + .3 * p[0], p[2] }; });
  const double side = coordinate(7) - coordinate(1);
  for (vtkDataSet* grid :
    { static_cast<vtkDataSet*>(rectilinear), static_cast<vtkDataSet*>(structured) })
  {
    for (const vtkIdType cells : { 0, 60 })
    {
      Made made;
      made->SetNumberOfControlCells(cells);
      vtkUnstructuredGrid* solid = made.Run(grid);
      EXPECT_TRUE(made.Heard->Errors.empty());
      const double first = side * side * (coordinate(4) - coordinate(1));
      const double second = side * side * (coordinate(8) - coordinate(4));
      EXPECT_NEAR(GetVolume(solid, 1.) / first, 1., cells ? .05 : .005);
      EXPECT_NEAR(GetVolume(solid, 2.) / second, 1., cells ? .05 : .005);
    }
  }
}

TEST(SubdivisionLabelSolid, GridsWithoutVolume)
{
  Made made;
  const Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; });
  made.Run(MakeRectilinear(image, [](int) { return 1.; }));
  made.ExpectError("have no volume");
  made.Run(MakeRectilinear(
    MakeImage({ 3, 3, 1 }, [](int, int, int) { return 1; }), [](int i) { return double(i); }));
  made.ExpectError("one point only");
}

// The place of a hidden point counts for the sizes of voxels: without one there is an error, no
// wrong volume.
TEST(SubdivisionLabelSolid, PointsWithoutPlace)
{
  const Image image = MakeImage({ 4, 4, 4 }, [](int, int, int) { return 1; });
  const auto place = [](int i) { return double(i); };
  for (const double nowhere : { std::nan(""), HUGE_VAL })
  {
    const auto grid =
      MakeStructured(MakeRectilinear(image, place), [](const Point& p) { return p; });
    grid->GetPoints()->SetPoint(21, 1., nowhere, 1.);
    grid->BlankPoint(21);
    Made made;
    made.Run(grid);
    made.ExpectError("Point 21 of the input is at no finite place");
  }
}
