// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionDeformationInputs.cxx
 * Bad input, points outside, arrays, vectors and normals.
 */
#include "SubdivisionDeformationTools.h"

#include "Private/Deformation/EmbeddedPoints.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkSubdivisionCageSource.h"

using namespace deformation_tools;

namespace
{

/// A cloud in the middle of a box of 2^3, with arrays of every kind.
Grid MakeInput(int type = VTK_DOUBLE)
{
  const Grid cloud = MakeCloud(40, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1, type);
  AddArrays(cloud);
  AddGlobalIds(cloud, 3);
  return cloud;
}

/// The output is the input, in every way.
void ExpectUntouched(vtkPointSet* output, const Grid& input)
{
  ASSERT_TRUE(output);
  EXPECT_EQ(Compare(vtkUnstructuredGrid::SafeDownCast(output), input), "");
}

void ExpectOneError(Deformer& filter, const std::string& part)
{
  ASSERT_EQ(filter.GetErrors().size(), 1U);
  EXPECT_NE(filter.GetErrors()[0].find(part), std::string::npos) << filter.GetErrors()[0];
  EXPECT_TRUE(filter.GetWarnings().empty());
  filter.Forget();
}

void ExpectOneWarning(Deformer& filter, const std::string& part)
{
  ASSERT_EQ(filter.GetWarnings().size(), 1U);
  EXPECT_NE(filter.GetWarnings()[0].find(part), std::string::npos) << filter.GetWarnings()[0];
  EXPECT_TRUE(filter.GetErrors().empty());
  filter.Forget();
}

}

// ---------------------------------------------------------------- bad input

TEST(SubdivisionDeformationInputs, MeshesThatDiffer)
{
  const Grid input = MakeInput();
  const Grid cage = MakeKuhnBox(2);
  Deformer filter;
  // Another order of points in a cell.
  Grid other = DeepCopy(cage);
  vtkNew<vtkCellArray> cells;
  cells->DeepCopy(cage->GetCells());
  const Ids ids = GetCell(cage, 17);
  const vtkIdType turned[4] = { ids[1], ids[2], ids[0], ids[3] };
  cells->ReplaceCellAtId(17, 4, turned);
  other->SetCells(subdivision::GetCellTypes(cage), cells);
  ExpectUntouched(filter.Run(input, cage, other), input);
  ExpectOneError(filter, "Cell 17 is the first that differs");
  // A point more, a cell less.
  other = DeepCopy(cage);
  other->GetPoints()->InsertNextPoint(9, 9, 9);
  ExpectUntouched(filter.Run(input, cage, other), input);
  ExpectOneError(filter, "rest mesh has 27 points, the deformed mesh 28");
  std::vector<Cell> fewer;
  for (vtkIdType i = 0; i < 47; ++i)
  {
    fewer.push_back({ VTK_TETRA, GetCell(cage, i) });
  }
  std::vector<Point> points;
  for (vtkIdType i = 0; i < 27; ++i)
  {
    points.push_back(GetPoint(cage, i));
  }
  ExpectUntouched(filter.Run(input, cage, MakeGrid(points, fewer)), input);
  ExpectOneError(filter, "rest mesh has 48 cells, the deformed mesh 47");
  // Another type of cell with the same points.
  fewer.push_back({ VTK_QUAD, GetCell(cage, 47) });
  ExpectUntouched(filter.Run(input, cage, MakeGrid(points, fewer)), input);
  ExpectOneError(filter, "Cell 47 is the first that differs");
  // It goes on where it was.
  EXPECT_LT(GetLargestError(filter.Run(input, cage, Moved(cage, Affine)), input, Affine), 1e-12);
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformationInputs, EqualCellsStoredOtherwise)
{
  // An unstructured grid at rest, poly data deformed.
  const Grid sheet =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } });
  vtkNew<vtkPolyData> other;
  vtkNew<vtkCellArray> polys;
  const vtkIdType triangle[3] = { 0, 1, 2 };
  polys->InsertNextCell(3, triangle);
  other->SetPoints(sheet->GetPoints());
  other->SetPolys(polys);
  Deformer filter;
  filter.Run(MakeInput(), sheet, other);
  EXPECT_TRUE(filter.GetErrors().empty());
}

TEST(SubdivisionDeformationInputs, InvertedCells)
{
  const Grid input = MakeInput();
  const Grid cage = MakeKuhnBox(2);
  Deformer filter;
  // In the deformed mesh: a vertex of the box pushed through it.
  const Grid folded = DeepCopy(cage);
  folded->GetPoints()->SetPoint(0, 3., 3., 3.);
  const auto output = filter.Run(input, cage, folded);
  EXPECT_LT(GetLargestError(output, output, [](const Point& x) { return x; }), 1e-300); // finite
  ASSERT_EQ(filter.GetWarnings().size(), 1U);
  EXPECT_NE(filter.GetWarnings()[0].find("turns inside out"), std::string::npos);
  EXPECT_NE(filter.GetWarnings()[0].find("the first is cell 0"), std::string::npos);
  filter.Forget();
  filter.Run(input, cage, Moved(cage, Affine));
  EXPECT_TRUE(filter.WasSilent());
  // At rest.
  Grid bad = MakeKuhnBox(2);
  const Ids ids = GetCell(bad, 5);
  const vtkIdType turned[4] = { ids[0], ids[1], ids[3], ids[2] };
  bad->GetCells()->ReplaceCellAtId(5, 4, turned);
  const auto at = filter.Run(input, bad, Moved(bad, Affine));
  ExpectOneWarning(filter, "inverted or flat cells (1 of its cells, the first is cell 5)");
  EXPECT_LT(GetLargestError(at, input, Affine), 1e-12);
  // The cell of the input is named, not a piece of it.
  const Grid box = MakeMixedBox(2);
  const Grid pushed = DeepCopy(box);
  pushed->GetPoints()->SetPoint(26, -9., -9., -9.);
  filter.Run(input, box, pushed);
  ASSERT_FALSE(filter.GetWarnings().empty());
  const std::string& text = filter.GetWarnings().back();
  const std::string mark = "the first is cell ";
  ASSERT_NE(text.find(mark), std::string::npos) << text;
  const Ids named = GetCell(box, std::stoi(text.substr(text.find(mark) + mark.size())));
  EXPECT_NE(std::find(named.begin(), named.end(), 26), named.end()) << text;
}

TEST(SubdivisionDeformationInputs, EmptyThings)
{
  const Grid input = MakeInput();
  const Grid cage = MakeKuhnBox(2);
  vtkNew<vtkUnstructuredGrid> nothing;
  const Grid noCells = MakeGrid({ { 0, 0, 0 }, { 1, 1, 1 } }, {});
  Deformer filter;
  for (vtkUnstructuredGrid* empty : { nothing.Get(), noCells.Get() })
  {
    ExpectUntouched(filter.Run(input, empty, empty), input);
    ExpectOneWarning(filter, "has no cells");
  }
  const Grid flat = MakeGrid({ { 0, 0, 0 }, { 1, 1, 1 } }, { { VTK_TETRA, { 0, 1, 1, 0 } } });
  ExpectUntouched(filter.Run(input, flat, flat), input);
  EXPECT_EQ(filter.GetErrors().size(), 0U);
  ASSERT_FALSE(filter.GetWarnings().empty());
  EXPECT_NE(filter.GetWarnings().back().find("no cell that can be used"), std::string::npos);
  filter.Forget();
  const auto output = filter.Run(nothing, cage, cage);
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_TRUE(filter.WasSilent());
  vtkNew<vtkPolyData> noPoints;
  EXPECT_TRUE(filter.Run(noPoints, cage, cage)->IsA("vtkPolyData"));
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformationInputs, MissingControlMesh)
{
  vtkNew<vtkSubdivisionDeformation> filter;
  vtkNew<Messages> heard;
  heard->Watch(filter);
  filter->SetInputData(MakeInput());
  filter->SetRestMeshData(MakeKuhnBox(1));
  filter->Update();
  EXPECT_FALSE(heard->Errors.empty());
}

TEST(SubdivisionDeformationInputs, WithoutARestMeshItIsTheCageAround)
{
  const Grid cloud = MakeCloud(500, { 3, 1, 0 }, { 5, 2, 9 }, 7);
  for (const double x : { 3., 5. }) // corners of its box
  {
    cloud->GetPoints()->InsertNextPoint(x, 1, 0);
    cloud->GetPoints()->InsertNextPoint(x, 2, 9);
  }
  const auto move = [](const Point& p) -> Point
  { return { p[0] + 0.5 * p[2], 2 * p[1], p[2] - 0.25 * p[0] + 1 }; };
  for (const bool isDefault : { true, false })
  {
    vtkNew<vtkSubdivisionCageSource> source;
    source->SetInputDataObject(0, cloud);
    isDefault ? void() : source->SetNumberOfCells(2, 3, 4);
    source->Update();
    const Grid moved = DeepCopy(source->GetOutput());
    for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
    {
      moved->GetPoints()->SetPoint(i, move(GetPoint(moved, i)).data());
    }
    vtkNew<vtkSubdivisionDeformation> filter;
    filter->SetDeformedMeshData(moved);
    vtkNew<Messages> told;
    told->Watch(filter);
    filter->SetInputData(cloud);
    filter->Update();
    ASSERT_EQ(told->Warnings.size(), 1u);
    EXPECT_NE(told->Warnings[0].find("default Margin"), std::string::npos);
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
    auto* output = vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_LT(GetLargestError(output, cloud, move), 1e-12);
  }
  vtkNew<vtkSubdivisionDeformation> filter;
  vtkNew<Messages> heard;
  heard->Watch(filter);
  filter->SetInputData(cloud);
  for (const Grid& other : { MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
                               { { VTK_TETRA, { 0, 1, 2, 3 } } }),
         MakeCloud(9, { 0, 0, 0 }, { 1, 1, 1 }, 1) })
  {
    heard->Errors.clear();
    filter->SetDeformedMeshData(other);
    filter->Update();
    ASSERT_EQ(heard->Errors.size(), 1u);
    EXPECT_NE(heard->Errors[0].find("DeformedMesh is no cage around"), std::string::npos);
  }
}

TEST(SubdivisionDeformationInputs, NotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Grid cage = MakeKuhnBox(2);
  const Grid input = MakeInput();
  input->GetPoints()->SetPoint(3, nan, 1., 1.);
  input->GetPoints()->SetPoint(4, 1., std::numeric_limits<double>::infinity(), 1.);
  for (int rule : { 0, 1 })
  {
    Deformer filter;
    filter->SetOutsidePoints(rule);
    const auto output = filter.Run(input, cage, Moved(cage, Affine));
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 2);
    ExpectOneWarning(filter,
      "2 of 40 points, the first is point 3, are not inside the subdivided rest mesh (2 are not "
      "finite)");
    EXPECT_TRUE(std::isnan(GetPoint(output, 3)[0]));
    EXPECT_EQ(GetPoint(output, 3)[1], 1.);
    EXPECT_EQ(GetPoint(output, 4)[0], 1.);
    for (vtkIdType i = 5; i < 40; ++i)
    {
      EXPECT_NEAR(GetPoint(output, i)[0], Affine(GetPoint(input, i))[0], 1e-12);
    }
  }
  Deformer filter;
  const Grid lost = DeepCopy(cage);
  lost->GetPoints()->SetPoint(7, 0., nan, 0.);
  const Grid good = MakeInput();
  ExpectUntouched(filter.Run(good, cage, lost), good);
  ExpectOneError(filter, "Point 7 of the deformed mesh is not finite");
}

TEST(SubdivisionDeformationInputs, TooManyCells)
{
  const Grid input = MakeInput();
  const Grid cage = MakeKuhnBox(2);
  Deformer filter;
  filter->SetMaximumNumberOfCells(1000);
  ExpectUntouched(filter.Run(input, cage, cage), input);
  ExpectOneError(filter, "MaximumNumberOfCells");
  filter->SetNumberOfLevels(1);
  EXPECT_LT(GetLargestError(filter.Run(input, cage, Moved(cage, Affine)), input, Affine), 1e-12);
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformationInputs, MissingFeatureArray)
{
  const Grid input = MakeInput();
  const Grid cage = MakeKuhnBox(2);
  Deformer filter;
  filter->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "creases");
  ExpectUntouched(filter.Run(input, cage, cage), input);
  ExpectOneError(filter, "\"creases\"");
}

// ---------------------------------------------------------------- outside

TEST(SubdivisionDeformationInputs, OutsidePoints)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid moved = Moved(cage, Affine);
  const Grid input = MakeGrid({ { 1, 1, 1 }, { 5, 1, 1 }, { 1, 1, 0.5 }, { 1, -7, 1.2 } }, {});
  Deformer filter;
  auto leave = filter.Run(input, cage, moved);
  ExpectOneWarning(filter, "2 of 4 points, the first is point 1");
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 2);
  for (vtkIdType i : { 1, 3 })
  {
    EXPECT_EQ(GetPoint(leave, i), GetPoint(input, i));
  }
  for (vtkIdType i : { 0, 2 })
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(leave, i)[c], Affine(GetPoint(input, i))[c], 1e-12);
    }
  }
  // The number is said again when it is found again, not whenever the mesh moves.
  filter.Run(input, cage, Moved(cage, Bend));
  EXPECT_TRUE(filter.WasSilent());
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 2);

  filter->SetOutsidePointsToError();
  for (int time = 0; time < 2; ++time)
  {
    ExpectUntouched(filter.Run(input, cage, moved), input);
    ExpectOneError(filter, "2 of 4 points, the first is point 1");
  }

  // Nearest: at rest nothing moves; shifts are shifts; a point moves as its nearest point does.
  filter->SetOutsidePointsToNearest();
  const auto same = filter.Run(input, cage, cage);
  EXPECT_LT(GetLargestError(same, input, [](const Point& x) { return x; }), 1e-14);
  ExpectOneWarning(filter, "nearest");
  auto shift = [](const Point& x) { return Point{ x[0] + 3., x[1] - 2., x[2] + 1. }; };
  EXPECT_LT(GetLargestError(filter.Run(input, cage, Moved(cage, shift)), input, shift), 1e-12);
  // By symmetry the nearest point to (5, 1, 1) is on the axis; its image is that of an affine map.
  const auto nearest = filter.Run(input, cage, moved);
  const Grid fine = Subdivide(cage, 2);
  double best = 1e300;
  Point foot = {};
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    const Point x = GetPoint(fine, i);
    const double distance =
      (x[0] - 5.) * (x[0] - 5.) + (x[1] - 1.) * (x[1] - 1.) + (x[2] - 1.) * (x[2] - 1.);
    if (distance < best)
    {
      best = distance;
      foot = x;
    }
  }
  const Point image = Affine(foot);
  EXPECT_NEAR(GetPoint(nearest, 1)[0] - 5., image[0] - foot[0], 0.05);
  EXPECT_NEAR(GetPoint(nearest, 1)[1] - 1., image[1] - foot[1], 0.05);
  EXPECT_TRUE(filter.WasSilent());
}

// ---------------------------------------------------------------- arrays

TEST(SubdivisionDeformationInputs, ArraysPass)
{
  const Grid input = MakeInput();
  const Grid cage = MakeKuhnBox(2);
  Deformer filter;
  filter->TransformVectorsOff();
  auto output = filter.Run(input, cage, Moved(cage, Affine));
  output->SetPoints(input->GetPoints());
  ExpectUntouched(output, input);
  // On: all but the active vectors.
  filter->TransformVectorsOn();
  output = filter.Run(input, cage, Moved(cage, Affine));
  EXPECT_EQ(CompareArrays(input->GetPointData(), output->GetPointData(), "point data"),
    "point data: double: values");
  EXPECT_EQ(CompareArrays(input->GetCellData(), output->GetCellData(), "cell data"),
    "cell data: double: values");
  EXPECT_EQ(CompareArrays(input->GetFieldData(), output->GetFieldData(), "field data"), "");
  EXPECT_EQ(output->GetPointData()->GetVectors()->GetComponentName(1), std::string("middle"));
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformationInputs, VectorsAndNormals)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid moved = Moved(cage, Affine);
  for (int mirror : { 0, 1 })
  {
    const Grid input = MakeCloud(30, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);
    input->GetPoints()->SetPoint(7, 50., 0., 0.); // outside
    vtkDataSetAttributes* both[2] = { input->GetPointData(), input->GetCellData() };
    for (vtkDataSetAttributes* data : both)
    {
      data->SetVectors(MakeArray<vtkDoubleArray>("velocity", 3, 30, -1, 1, 5));
      data->SetNormals(MakeArray<vtkFloatArray>("normals", 3, 30, -1, 1, 6));
      data->SetTangents(MakeArray<vtkFloatArray>("tangents", 3, 30, -1, 1, 8));
      data->AddArray(MakeArray<vtkDoubleArray>("other", 3, 30, -1, 1, 7));
    }
    auto map = [mirror](const Point& x) { return Affine({ x[0], x[1], mirror ? -x[2] : x[2] }); };
    Deformer filter;
    const auto output = filter.Run(input, cage, Moved(cage, map));
    EXPECT_EQ(filter.GetErrors().size(), 0U);
    const Point zero = map({ 0, 0, 0 });
    auto turn = [&](const double* v)
    {
      Point result = map({ v[0], v[1], v[2] });
      for (int c = 0; c < 3; ++c)
      {
        result[c] -= zero[c];
      }
      return result;
    };
    vtkDataSetAttributes* results[2] = { output->GetPointData(), output->GetCellData() };
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_EQ(CompareValues(both[k]->GetArray("other"), results[k]->GetArray("other")), "");
      ASSERT_EQ(results[k]->GetNumberOfArrays(), both[k]->GetNumberOfArrays());
      for (vtkIdType i = 0; i < 30; ++i)
      {
        double v[3];
        double n[3];
        double t[3];
        both[k]->GetVectors()->GetTuple(i, v);
        both[k]->GetNormals()->GetTuple(i, n);
        both[k]->GetTangents()->GetTuple(i, t);
        double v2[3];
        double n2[3];
        double t2[3];
        results[k]->GetVectors()->GetTuple(i, v2);
        results[k]->GetNormals()->GetTuple(i, n2);
        results[k]->GetTangents()->GetTuple(i, t2);
        if (i == 7)
        {
          EXPECT_TRUE(std::equal(v, v + 3, v2));
          continue;
        }
        const Point wanted = turn(v);
        const Point tangent = turn(t);
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(v2[c], wanted[c], 1e-11);
          EXPECT_NEAR(t2[c], tangent[c], 1e-6);
        }
        // A normal is what is perpendicular to the images of what it was perpendicular to, on the
        // same side, and long 1.
        const double a[3] = { n[1], -n[0], 0. };
        const double b[3] = { 0., n[2], -n[1] };
        const Point a2 = turn(a);
        const Point b2 = turn(b);
        const Point side = turn(n);
        EXPECT_NEAR(n2[0] * a2[0] + n2[1] * a2[1] + n2[2] * a2[2], 0., 1e-6);
        EXPECT_NEAR(n2[0] * b2[0] + n2[1] * b2[1] + n2[2] * b2[2], 0., 1e-6);
        EXPECT_GT(n2[0] * side[0] + n2[1] * side[1] + n2[2] * side[2], 0.);
        EXPECT_NEAR(n2[0] * n2[0] + n2[1] * n2[1] + n2[2] * n2[2], 1., 1e-6);
      }
    }
  }
}

TEST(SubdivisionDeformationInputs, VectorsAreDerivatives)
{
  // In a bent mesh, against differences of the map itself within a cell.
  const Grid cage = MakeKuhnBox(2, 0.1, 2);
  const Grid bent = Moved(cage, Bend);
  const double step = 1e-6;
  const Grid input = MakeCloud(50, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);
  input->GetPointData()->SetVectors(MakeArray<vtkDoubleArray>("v", 3, 50, -1, 1, 5));
  const Grid shifted = DeepCopy(input);
  for (vtkIdType i = 0; i < 50; ++i)
  {
    const Point x = GetPoint(input, i);
    const double* v = input->GetPointData()->GetVectors()->GetTuple3(i);
    shifted->GetPoints()->SetPoint(i, x[0] + step * v[0], x[1] + step * v[1], x[2] + step * v[2]);
  }
  Deformer filter;
  const auto a = filter.Run(input, cage, bent);
  const auto b = filter.Run(shifted, cage, bent);
  for (vtkIdType i = 0; i < 50; ++i)
  {
    double v[3];
    a->GetPointData()->GetVectors()->GetTuple(i, v);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(v[c], (GetPoint(b, i)[c] - GetPoint(a, i)[c]) / step, 1e-8);
    }
  }
}

// ---------------------------------------------------------------- control meshes without solids

TEST(SubdivisionDeformationInputs, TrianglesInAPlaneHoldAnImage)
{
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    std::vector<Point> points;
    std::vector<Cell> cells;
    for (vtkIdType i = 0; i < 16; ++i)
    {
      points.push_back({ 1. * (i % 4), 1. * (i / 4), 0.5 });
      if (i % 4 < 3 && i < 12)
      {
        cells.push_back({ VTK_TRIANGLE, { i, i + 1, i + 5 } });
        cells.push_back({ VTK_TRIANGLE, { i, i + 5, i + 4 } });
      }
    }
    const Grid cage = MakeGrid(points, cells, type);
    const Grid image = MakeCloud(60, { 0.5, 0.5, 0.5 }, { 2.5, 2.5, 0.5 }, 4, type);
    Deformer filter;
    filter->SetOutsidePointsToError();
    const auto moved = filter.Run(image, cage, Moved(cage, Affine));
    EXPECT_TRUE(filter.WasSilent());
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
    EXPECT_LT(GetLargestError(moved, image, Affine), type == VTK_DOUBLE ? 1e-12 : 1e-5);
    // A point above the plane is outside.
    filter->SetOutsidePointsToLeave();
    const Grid above = DeepCopy(image);
    Point lifted = GetPoint(image, 7);
    lifted[2] += 0.01;
    above->GetPoints()->SetPoint(7, lifted.data());
    const auto left = filter.Run(above, cage, Moved(cage, Affine));
    ExpectOneWarning(filter, "1 of 60 points, the first is point 7, are not inside");
    EXPECT_EQ(GetPoint(left, 7), GetPoint(above, 7));
  }
}

/// As many as rows have numbers for; in fact 2^31.
TEST(SubdivisionDeformationInputs, TooManyPointsForTheNearest)
{
  using subdivision::EmbeddedPoints;
  const Grid cage = MakeKuhnBox(2);
  const Grid input = MakeGrid({ { 4, 1, 1 }, { 5, 1, 1 }, { 1, -7, 1.2 } }, {});
  const vtkIdType most = std::exchange(EmbeddedPoints::MostOthers, input->GetNumberOfPoints() - 1);
  Deformer filter;
  filter->SetOutsidePointsToNearest();
  ExpectUntouched(filter.Run(input, cage, Moved(cage, Affine)), input);
  ExpectOneError(filter, "which is too many to find the nearest place for each");
  EmbeddedPoints::MostOthers = most;
  filter.Run(input, cage, Moved(cage, Affine));
  ExpectOneWarning(filter, "3 of 3 points");
}
