// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionLabelSolid.cxx
 * Images of labels become smooth solids that keep volumes, lie close to the voxels, fit together
 * and carry what is known of materials.
 */
#include "LabelTools.h"

#include "vtkSubdivisionLabelSolid.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkStaticPointLocator.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"

using namespace label_tools;

namespace
{

/// Soft tissue (1) around a bone (2) with marrow (3), in n^3 voxels.
Rule ScanOf(int n)
{
  return [n](int i, int j, int k)
  {
    const double x = (2. * i + 1.) / n - 1.;
    const double y = (2. * j + 1.) / n - 1.;
    const double z = (2. * k + 1.) / n - 1.;
    if (x * x / .81 + y * y / .64 + z * z / .86 >= 1.)
    {
      return 0;
    }
    const double along = (.3 * x + .2 * y + z) / std::sqrt(1.13);
    const double radius = std::sqrt(std::max(0., x * x + y * y + z * z - along * along));
    const double wall = .34 + .12 * along * along;
    const int inside = radius < wall - .15 && std::abs(along) < .55 ? 3 : 2;
    return radius < wall && std::abs(along) < .7 ? inside : 1;
  };
}

using Face = std::array<vtkIdType, 3>;

/// What a solid has of each label.
struct Solid
{
  explicit Solid(vtkUnstructuredGrid* grid, const char* name = "Tissue");

  std::map<int, double> Volumes;
  std::map<Face, std::vector<int>> Labels; ///< of the one or two cells at a face
  vtkIdType NumberOfInverted = 0;
};

Solid::Solid(vtkUnstructuredGrid* grid, const char* name)
{
  vtkDataArray* labels = grid->GetCellData()->GetArray(name);
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const Ids tet = GetCell(grid, i);
    const double volume = GetSignedVolume(grid, tet);
    const int label = static_cast<int>(labels->GetComponent(i, 0));
    this->Volumes[label] += volume;
    this->NumberOfInverted += volume <= 0. ? 1 : 0;
    for (int left = 0; left < 4; ++left)
    {
      Face face{ tet[(left + 1) % 4], tet[(left + 2) % 4], tet[(left + 3) % 4] };
      std::sort(face.begin(), face.end());
      this->Labels[face].push_back(label);
    }
  }
}

/// How often labels are in an image.
std::map<int, double> Count(vtkImageData* image)
{
  vtkDataArray* labels = image->GetPointData()->GetScalars() ? image->GetPointData()->GetScalars()
                                                             : image->GetCellData()->GetScalars();
  std::map<int, double> found;
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    found[static_cast<int>(labels->GetComponent(i, 0))] += 1.;
  }
  found.erase(0);
  return found;
}

void ExpectVolumes(
  const std::map<int, double>& found, const std::map<int, double>& expected, double error)
{
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [label, volume] : expected)
  {
    ASSERT_TRUE(found.count(label)) << label;
    EXPECT_NEAR(found.at(label) / volume, 1., error) << "label " << label;
  }
}

/// The largest distance of a point from the nearest of others.
double GetLargestDistance(const std::vector<Point>& from, const std::vector<Point>& to)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : to)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  double largest = 0.;
  for (const Point& p : from)
  {
    Point q;
    cloud->GetPoint(locator->FindClosestPoint(p.data()), q.data());
    largest = std::max(largest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return largest;
}

/// Points of the faces of voxels (around points) at which `label` ends.
std::vector<Point> SampleVoxels(const std::array<int, 3>& n, const Rule& rule, int label)
{
  std::vector<Point> samples;
  const auto is = [&](std::array<int, 3> at)
  {
    bool isThere = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      isThere = isThere && at[axis] >= 0 && at[axis] < n[axis];
    }
    return isThere && rule(at[0], at[1], at[2]) == label;
  };
  constexpr int steps = 4;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int k = 0; k <= n[2]; ++k)
    {
      for (int j = 0; j <= n[1]; ++j)
      {
        for (int i = 0; i <= n[0]; ++i)
        {
          std::array<int, 3> before{ i, j, k };
          --before[axis];
          if (is({ i, j, k }) == is(before))
          {
            continue;
          }
          for (int s = 0; s <= steps * steps + 2 * steps; ++s)
          {
            Point p{ i - .5, j - .5, k - .5 };
            p[(axis + 1) % 3] += s % (steps + 1) / double(steps);
            p[(axis + 2) % 3] += s / (steps + 1) / double(steps);
            samples.push_back(p);
          }
        }
      }
    }
  }
  return samples;
}

/// Points of the triangles at which `label` ends.
std::vector<Point> SampleSolid(vtkUnstructuredGrid* grid, const Solid& solid, int label)
{
  std::vector<Point> samples;
  constexpr int steps = 3;
  for (const auto& [face, labels] : solid.Labels)
  {
    if (std::count(labels.begin(), labels.end(), label) != 1)
    {
      continue;
    }
    for (int i = 0; i <= steps; ++i)
    {
      for (int j = 0; i + j <= steps; ++j)
      {
        const double weights[3] = { i / double(steps), j / double(steps),
          (steps - i - j) / double(steps) };
        Point p{ 0., 0., 0. };
        for (int c = 0; c < 3; ++c)
        {
          const Point corner = GetPoint(grid, face[c]);
          for (int axis = 0; axis < 3; ++axis)
          {
            p[axis] += weights[c] * corner[axis];
          }
        }
        samples.push_back(p);
      }
    }
  }
  return samples;
}

}

TEST(SubdivisionLabelSolid, AScanKeepsVolumesAndShape)
{
  constexpr int n = 22;
  const Image image = MakeImage({ n, n, n }, ScanOf(n));
  const auto wanted = Count(image);
  ASSERT_EQ(wanted.size(), 3u);
  for (const int scheme : { vtkSubdivisionAlgorithm::BOX_SPLINE, vtkSubdivisionAlgorithm::TET_OCT })
  {
    Made made;
    made->SetNumberOfControlCells(0);
    made->SetVolumeScheme(scheme);
    vtkUnstructuredGrid* grid = made.Run(image);
    made.ExpectSilence();
    double voxels = 0.;
    for (const auto& [label, count] : wanted)
    {
      voxels += count;
    }
    EXPECT_EQ(grid->GetNumberOfCells(), 48 * static_cast<vtkIdType>(voxels));
    const Solid solid(grid);
    EXPECT_EQ(solid.NumberOfInverted, 0);
    ExpectVolumes(solid.Volumes, wanted, .005);
    // Cells fit together: no face of three cells; the outside has area where there is background.
    for (const auto& [face, labels] : solid.Labels)
    {
      ASSERT_LE(labels.size(), 2u);
    }
    // In voxels, which are the control voxels here.
    for (const auto& [label, count] : wanted)
    {
      const auto stairs = SampleVoxels({ n, n, n }, ScanOf(n), label);
      const auto smooth = SampleSolid(grid, solid, label);
      EXPECT_LE(GetLargestDistance(stairs, smooth), .6) << label;
      EXPECT_LE(GetLargestDistance(smooth, stairs), .6) << label;
    }
  }
}

TEST(SubdivisionLabelSolid, SmoothingMakesStairsFlat)
{
  // A slope of one in three: normals of the interface all look the same way, but at its ends.
  const Image image =
    MakeImage({ 24, 8, 14 }, [](int i, int, int k) { return 3 * k < i + 9 ? 1 : 2; });
  std::vector<double> rough; // root mean squares of the distance from the plane
  for (const int steps : { 0, 20, 60 })
  {
    Made made;
    made->SetNumberOfControlCells(0);
    made->SetNumberOfSmoothingSteps(steps);
    vtkUnstructuredGrid* grid = made.Run(image);
    made.ExpectSilence();
    std::vector<double> heights;
    for (const auto& [face, labels] : Solid(grid).Labels)
    {
      const Point p = GetPoint(grid, face[0]);
      if (labels.size() == 2 && labels[0] != labels[1] && p[0] > 4. && p[0] < 19. && p[1] > 1. &&
        p[1] < 6.)
      {
        heights.push_back(p[2] - p[0] / 3.);
      }
    }
    const double mean =
      std::accumulate(heights.begin(), heights.end(), 0.) / static_cast<double>(heights.size());
    double squares = 0.;
    for (const double height : heights)
    {
      squares += (height - mean) * (height - mean);
    }
    rough.push_back(std::sqrt(squares / static_cast<double>(heights.size())));
  }
  EXPECT_GT(rough[0], .2);
  EXPECT_LT(rough[1], .6 * rough[0]);
  EXPECT_LT(rough[2], .4 * rough[0]);
}

TEST(SubdivisionLabelSolid, PointAndCellLabelsGiveTheSame)
{
  const Rule rule = ScanOf(12);
  Made ofPoints;
  Made ofCells;
  vtkUnstructuredGrid* a = ofPoints.Run(MakeImage({ 12, 12, 12 }, rule));
  vtkUnstructuredGrid* b = ofCells.Run(MakeImage({ 12, 12, 12 }, rule, true));
  ASSERT_GT(a->GetNumberOfCells(), 0);
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  EXPECT_EQ(GetCells(a), GetCells(b));
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(GetPoint(a, i)[axis] + .5, GetPoint(b, i)[axis], 1e-9);
    }
  }
}

TEST(SubdivisionLabelSolid, CoarsensByMajority)
{
  constexpr int n = 24;
  const Image image = MakeImage({ n, n, n }, ScanOf(n));
  Made made;
  made->SetNumberOfControlCells(1000);
  vtkUnstructuredGrid* grid = made.Run(image);
  made.ExpectSilence();
  const vtkIdType cells = grid->GetNumberOfCells() / 48;
  EXPECT_LE(cells, 1000);
  EXPECT_GT(cells, 500);
  const Solid solid(grid);
  EXPECT_EQ(solid.NumberOfInverted, 0);
  ExpectVolumes(solid.Volumes, Count(image), .005); // of the voxels, not of the blocks
  // Ties: materials before background, then the smallest label.
  made->SetNumberOfControlCells(2);
  made->SetNumberOfLevels(0);
  const int labels[3][8] = { { 0, 0, 0, 6, 6, 5, 5, 5 }, { 9, 9, 9, 9, 7, 7, 7, 7 },
    { 8, 8, 8, 0, 0, 0, 0, 0 } };
  grid = made.Run(MakeImage(
    { 6, 2, 2 }, [&](int i, int j, int k) { return labels[i / 2][i % 2 + 2 * j + 4 * k]; }));
  EXPECT_EQ(grid->GetNumberOfCells(), 2 * 6) << "most voxels of the last block are background";
  const Solid blocks(grid);
  EXPECT_TRUE(blocks.Volumes.count(5) && blocks.Volumes.count(7));
  EXPECT_EQ(made.Heard->CountWarnings("3 of 5 labels have the most voxels in no block of 2^3"), 1);
}

TEST(SubdivisionLabelSolid, CarriesMaterialsAndVoxelArrays)
{
  const Image image = MakeImage({ 4, 4, 4 }, [](int i, int, int) { return i < 2 ? 3 : 8; });
  image->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Density", 1, 64, 0., 1., 1));
  image->GetPointData()->AddArray(MakeArray<vtkIntArray>("Count", 2, 64, 0., 100., 2));
  vtkNew<vtkTable> table;
  vtkNew<vtkIntArray> labels;
  labels->SetName("Tissue");
  vtkNew<vtkDoubleArray> modulus;
  modulus->SetName("Modulus");
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (const int label : { 8, 3 })
  {
    labels->InsertNextValue(label);
    modulus->InsertNextValue(10. * label);
    names->InsertNextValue(label == 8 ? "bone" : "fat");
  }
  for (vtkAbstractArray* column : { static_cast<vtkAbstractArray*>(labels),
         static_cast<vtkAbstractArray*>(modulus), static_cast<vtkAbstractArray*>(names) })
  {
    table->AddColumn(column);
  }
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(table);
  for (const bool isTable : { true, false })
  {
    Made made;
    made->SetNumberOfControlCells(8); // blocks of 2^3, one label each
    if (isTable)
    {
      made->SetMaterialsConnection(source->GetOutputPort());
    }
    else
    {
      image->GetFieldData()->ShallowCopy(table->GetRowData());
    }
    vtkUnstructuredGrid* grid = made.Run(image);
    made.ExpectSilence();
    ASSERT_EQ(grid->GetNumberOfCells(), 8 * 48);
    vtkCellData* data = grid->GetCellData();
    EXPECT_EQ(data->GetNumberOfArrays(), 4);
    EXPECT_EQ(data->GetScalars(), data->GetArray("Tissue"));
    EXPECT_EQ(data->GetScalars()->GetDataType(), VTK_UNSIGNED_CHAR);
    EXPECT_EQ(grid->GetPointData()->GetNumberOfArrays(), 0);
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      ASSERT_EQ(data->GetArray("Modulus")->GetComponent(i, 0),
        10. * data->GetScalars()->GetComponent(i, 0));
    }
    double mean = 0.;
    for (const vtkIdType voxel : { 0, 1, 4, 5, 16, 17, 20, 21 })
    {
      mean += image->GetPointData()->GetArray("Density")->GetComponent(voxel, 0) / 8.;
    }
    EXPECT_NEAR(data->GetArray("Density")->GetComponent(0, 0), mean, 1e-12);
    EXPECT_EQ(data->GetArray("Count")->GetComponent(0, 1),
      image->GetPointData()->GetArray("Count")->GetComponent(0, 1));
    auto* carried = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("Name"));
    ASSERT_TRUE(carried);
    EXPECT_EQ(carried->GetValue(1), "fat");
  }
  // Without a column of labels the number of the row is the label; 8 has none.
  table->RemoveColumnByName("Tissue");
  image->GetFieldData()->Initialize();
  labels->SetName("Other");
  Made made;
  made->SetMaterialsConnection(source->GetOutputPort());
  made.Run(image);
  EXPECT_EQ(made.Heard->CountWarnings("no row for label 3"), 1);
}

TEST(SubdivisionLabelSolid, BackgroundIsLeftOut)
{
  const Image image =
    MakeImage({ 6, 6, 6 }, [](int i, int, int k) { return i < 3 ? 7
                                                     : k < 3    ? 0
                                                                : 2; });
  Made made;
  made->SetBackgroundLabel(7);
  const Solid solid(made.Run(image));
  made.ExpectSilence();
  ExpectVolumes(solid.Volumes, { { 0, 54. }, { 2, 54. } }, .005);
  // Hidden voxels are background too.
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(216);
  ghosts->FillValue(0);
  for (int i = 108; i < 216; ++i)
  {
    ghosts->SetValue(i, vtkDataSetAttributes::HIDDENPOINT);
  }
  image->GetPointData()->AddArray(ghosts);
  ExpectVolumes(Solid(made.Run(image)).Volumes, { { 0, 54. } }, .005);
}

TEST(SubdivisionLabelSolid, VoxelsThatTouchInEdgesAndPoints)
{
  Made made;
  // All pairs of diagonals, and three materials around them.
  const Rule diagonals = [](int i, int j, int k)
  {
    return (i == j && k < 2) || (i == 0 && j == 3 && k == 3) ? 1 : i + j == 3 && k == 2 ? 2 : 0;
  };
  const Image image = MakeImage({ 4, 4, 4 }, diagonals);
  const Solid solid(made.Run(image));
  made.ExpectSilence();
  EXPECT_EQ(solid.NumberOfInverted, 0);
  ExpectVolumes(solid.Volumes, Count(image), .005);
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    std::mt19937 random(seed);
    const Image noise =
      MakeImage({ 5, 5, 5 }, [&](int, int, int) { return static_cast<int>(random() % 4); });
    EXPECT_EQ(Solid(made.Run(noise)).NumberOfInverted, 0) << seed;
    EXPECT_TRUE(made.Heard->Errors.empty());
  }
}

TEST(SubdivisionLabelSolid, TurnedAndMirroredImages)
{
  const Rule rule = ScanOf(10);
  const Image image = MakeImage({ 10, 10, 10 }, rule);
  auto wanted = Count(image);
  vtkNew<vtkMatrix3x3> directions; // turned about z, and mirrored
  const double turned[9] = { .6, .8, 0., -.8, .6, 0., 0., 0., -1. };
  std::copy(turned, turned + 9, directions->GetData());
  image->SetDirectionMatrix(directions);
  image->SetSpacing(.5, 1., 3.);
  image->SetOrigin(100., -50., 7.);
  image->SetExtent(5, 14, -3, 6, 0, 9);
  for (auto& [label, volume] : wanted)
  {
    volume *= 1.5;
  }
  Made made;
  vtkUnstructuredGrid* grid = made.Run(image);
  const Solid solid(grid);
  EXPECT_EQ(solid.NumberOfInverted, 0);
  ExpectVolumes(solid.Volumes, wanted, .005);
  double center[3];
  image->TransformContinuousIndexToPhysicalPoint(9.5, 1.5, 4.5, center);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(
      (grid->GetBounds()[2 * axis] + grid->GetBounds()[2 * axis + 1]) / 2., center[axis], .5);
  }
}

TEST(SubdivisionLabelSolid, WhatCannotBeDoneIsSaid)
{
  Made made;
  Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 0; });
  EXPECT_EQ(made.Run(image)->GetNumberOfCells(), 0);
  EXPECT_TRUE(made.Heard->Errors.empty());
  EXPECT_EQ(made.Heard->CountWarnings("All voxels have the label of the background, 0"), 1);
  image->GetPointData()->Initialize();
  made.Run(image);
  made.ExpectError("The input has no labels");
  image->GetPointData()->SetScalars(MakeArray<vtkDoubleArray>("Values", 1, 27, 0., 1., 1));
  made.Run(image);
  made.ExpectError("Point array \"Values\" (array index 0) holds values that are no whole numbers");
  made->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Values");
  made.Run(image);
  made.ExpectError("Cell array \"Values\" (array index 0) is not there");
  made->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "None");
  image = MakeImage({ 3, 3, 1 }, [](int, int, int) { return 1; });
  EXPECT_EQ(made.Run(image)->GetNumberOfCells(), 9 * 48) << "flat images have voxels around points";
  vtkNew<vtkIntArray> labels;
  labels->SetNumberOfValues(4);
  labels->FillValue(1);
  image->GetPointData()->Initialize();
  image->GetCellData()->SetScalars(labels);
  made.Run(image);
  made.ExpectError("two points");
  image = MakeImage({ 9, 9, 9 }, [](int, int, int) { return 1; });
  made->SetNumberOfLevels(15);
  made.Run(image);
  made.ExpectError("NumberOfLevels = 15 would make 1.54e+17 cells");
  made.ExpectError("Or make NumberOfControlCells smaller.");
  made->SetNumberOfLevels(1);
  EXPECT_GT(made.Run(image)->GetNumberOfCells(), 0);
  made.Filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(made.Filter->GetOutput()->GetNumberOfCells(), 0) << "the first piece is the whole";
}
