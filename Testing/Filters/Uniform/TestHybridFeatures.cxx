// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridFeatures.cxx
 * VolumeScheme = HYBRID: creases, marks, and values that jump.
 */
#include "HybridFilterTools.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPlane.h"
#include "vtkSurfaceSubdivision.h"

using namespace hybrid_filter_tools;

namespace
{

/// The same points in another order.
void ExpectSamePointsInAnyOrder(vtkPointSet* a, vtkPointSet* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    double nearest = 1.;
    for (vtkIdType k = 0; k < b->GetNumberOfPoints(); ++k)
    {
      b->GetPoint(k, q);
      nearest = std::min(
        nearest, std::max({ std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2]) }));
    }
    EXPECT_LT(nearest, 1e-13) << "point " << i;
  }
}

}

TEST(HybridFeatures, SemiSharpTetrahedraAreThoseOfTheTetOctScheme)
{
  const Grid input =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1.2 }, { 2, 0, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } }, { VTK_TRIANGLE, { 1, 4, 5 } },
        { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } }, { VTK_TRIANGLE, { 1, 2, 3 } },
        { VTK_TRIANGLE, { 0, 2, 3 } } });
  AddSharpness(input, { { 3, 1.5 }, { 4, .75 }, { 5, 2.25 }, { 6, 1. } });
  for (int levels = 1; levels <= 3; ++levels)
  {
    const Grid output = Execute(input, levels, With(ReadSharpness));
    const Grid expected = Execute(input, levels,
      [](Filter* filter)
      {
        filter->SetVolumeSchemeToTetOct();
        ReadSharpness(filter);
      });
    ExpectSamePointsInAnyOrder(output, expected);
    // The sharpness that is left, and cells without one.
    vtkDataArray* left = output->GetCellData()->GetArray("Sharpness");
    vtkDataArray* wanted = expected->GetCellData()->GetArray("Sharpness");
    double range[2];
    left->GetRange(range);
    EXPECT_EQ(range[1], std::max(0., 2.25 - levels));
    double sums[2] = { 0., 0. };
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      sums[0] += left->GetComponent(c, 0);
      sums[1] += wanted->GetComponent(c, 0);
    }
    EXPECT_NEAR(sums[0], sums[1], 1e-12);
  }
}

TEST(HybridFeatures, SemiSharpQuadsAreCatmullClark)
{
  std::vector<Point> points;
  for (int i = 0; i < 25; ++i)
  {
    points.push_back({ i % 5 * 1., i / 5 * 1., std::sin(i * 1.7) / 2. });
  }
  vtkNew<vtkPolyData> surface;
  surface->AllocateExact(25, 25);
  const Grid grid = MakeGrid(points, { { VTK_VERTEX, { 0 } } });
  const Grid quads = Grid::Take(vtkUnstructuredGrid::New());
  quads->SetPoints(grid->GetPoints());
  quads->AllocateExact(25, 100);
  surface->SetPoints(grid->GetPoints());
  const auto add = [&](int type, std::initializer_list<vtkIdType> ids)
  {
    quads->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.begin());
    surface->InsertNextCell(type, static_cast<int>(ids.size()), ids.begin());
  };
  std::map<vtkIdType, double> sharp;
  // Cells of a surface have lines first.
  for (const vtkIdType i : { 5, 6, 7, 12, 13 })
  {
    sharp[quads->GetNumberOfCells()] = i < 10 ? 1.5 : .6; // where both schemes blend alike
    add(VTK_LINE, { i, i + 1 });
  }
  for (vtkIdType i = 0; i < 16; ++i)
  {
    const vtkIdType p = i / 4 * 5 + i % 4;
    add(VTK_QUAD, { p, p + 1, p + 6, p + 5 });
  }
  AddSharpness(quads, sharp);
  surface->GetCellData()->ShallowCopy(quads->GetCellData());
  for (int levels = 1; levels <= 2; ++levels)
  {
    vtkNew<vtkSurfaceSubdivision> subdivide;
    subdivide->SetInputData(surface);
    subdivide->SetSchemeToCatmullClark();
    subdivide->SetNumberOfLevels(levels);
    subdivide->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
    // Corners of one quad are sharp in the surface scheme; here vertex cells say so.
    subdivide->Update();
    const Grid corners = Grid::Take(vtkUnstructuredGrid::New());
    corners->DeepCopy(quads);
    vtkNew<vtkIntArray> singular;
    singular->SetName("Singular");
    singular->SetNumberOfValues(corners->GetNumberOfCells());
    singular->Fill(0);
    for (const vtkIdType corner : { 0, 4, 20, 24 })
    {
      corners->InsertNextCell(VTK_VERTEX, 1, &corner);
      singular->InsertNextValue(1);
      vtkDoubleArray::SafeDownCast(corners->GetCellData()->GetArray("Sharpness"))
        ->InsertNextValue(0.);
    }
    corners->GetCellData()->AddArray(singular);
    const Grid output = Execute(corners, levels,
      With(
        [](Filter* filter)
        {
          ReadSharpness(filter);
          filter->SetInputArrayToProcess(
            0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Singular");
        }));
    ExpectSamePointsInAnyOrder(output, subdivide->GetOutput());
  }
}

TEST(HybridFeatures, SharpQuadsOfSolidsAndOfMarks)
{
  // The quad between hexahedron and wedge has a sharpness, by its cell or by its marked points.
  const Grid input = MakeAllTypes();
  const auto execute = [&](double sharpness, int levels)
  {
    AddSharpness(input, { { 9, sharpness } });
    return Execute(input, levels, With(ReadSharpness));
  };
  const Grid smooth = execute(0., 1);
  const Grid half = execute(.5, 1);
  const Grid sharp = execute(1., 1);
  double most = 0.;
  for (vtkIdType i = 0; i < smooth->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(
        GetPoint(half, i)[c], (GetPoint(smooth, i)[c] + GetPoint(sharp, i)[c]) / 2., 1e-14);
      most = std::max(most, std::abs(GetPoint(smooth, i)[c] - GetPoint(sharp, i)[c]));
    }
  }
  EXPECT_GT(most, .01);
  for (const double sharpness : { .5, 1.75, 1e9 })
  {
    vtkNew<vtkDoubleArray> marks;
    marks->SetName("Marks");
    vtkNew<vtkDoubleArray> ofPoints;
    ofPoints->SetName("PointSharpness");
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      marks->InsertNextValue(i == 1 || i == 2 || i == 5 || i == 6 ? 1. : 0.);
      ofPoints->InsertNextValue(sharpness);
    }
    const Grid marked = Grid::Take(vtkUnstructuredGrid::New());
    marked->DeepCopy(input);
    marked->GetPointData()->AddArray(marks);
    marked->GetPointData()->AddArray(ofPoints);
    const Grid byMarks = Execute(marked, 2,
      With(
        [](Filter* filter)
        {
          filter->SetInputArrayToProcess(8, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Marks");
          filter->SetInputArrayToProcess(
            9, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "PointSharpness");
          filter->MarkSurfacesOn();
          filter->MarkCornersOff();
        }));
    const Grid byCell = execute(sharpness, 2);
    for (vtkIdType i = 0; i < byCell->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(GetPoint(byCell, i), GetPoint(byMarks, i)) << i;
    }
  }
}

TEST(HybridFeatures, GeometryMarksQuadsAndEdges)
{
  const Grid input = MakeAllTypes();
  const auto execute = [&](vtkDataObject* geometry, const Configure& more)
  {
    return Execute(input, 1,
      With(
        [&](Filter* filter)
        {
          if (geometry)
          {
            filter->SetInputDataObject(2, geometry);
          }
          more(filter);
        }));
  };
  const Grid marks = MakeGrid({ GetPoint(input, 1), GetPoint(input, 2), GetPoint(input, 6),
                                GetPoint(input, 5), GetPoint(input, 10), GetPoint(input, 4) },
    { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_LINE, { 4, 5 } }, { VTK_VERTEX, { 4 } } });
  const Grid byGeometry = execute(marks, [](Filter*) {});
  const Grid flagged =
    feature_tools::With(input, "Singular", { 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0 });
  flagged->InsertNextCell(VTK_LINE, 2, Ids{ 10, 4 }.data());
  flagged->InsertNextCell(VTK_VERTEX, 1, Ids{ 10 }.data());
  for (int k = 0; k < flagged->GetCellData()->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = flagged->GetCellData()->GetAbstractArray(k);
    array->InsertNextTuple(9, array);
    array->InsertNextTuple(9, array);
  }
  const Grid byCells =
    Execute(flagged, 1, With([](Filter* filter) { SetCellArray(filter, 0, "Singular"); }));
  for (vtkIdType i = 0; i < byGeometry->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(GetPoint(byGeometry, i), GetPoint(byCells, i)) << i;
  }
  EXPECT_NE(Compare(byGeometry, execute(nullptr, [](Filter*) {})), "");
}

/// Lines on diagonals of quads mark nothing, and a warning says so once.
TEST(HybridFeatures, LinesOnDiagonalsAreTold)
{
  const Grid input = MakeAllTypes();
  const Grid lines = MakeGrid(
    { GetPoint(input, 1), GetPoint(input, 2), GetPoint(input, 6) }, { { VTK_LINE, { 0, 1 } } });
  for (const bool hasDiagonal : { false, true })
  {
    const Grid marks = DeepCopy(lines);
    hasDiagonal ? void(marks->InsertNextCell(VTK_LINE, 2, Ids{ 0, 2 }.data())) : void();
    vtkNew<Messages> messages;
    Execute(
      input, 1, With([&](Filter* filter) { filter->SetInputDataObject(2, marks); }), messages);
    EXPECT_EQ(messages->CountWarnings("diagonals of quads"), hasDiagonal ? 1 : 0);
    EXPECT_EQ(messages->CountWarnings("between points 1 and 6"), hasDiagonal ? 1 : 0);
    EXPECT_EQ(messages->CountWarnings("VolumeScheme = BoxSpline"), hasDiagonal ? 1 : 0);
  }
}

TEST(HybridFeatures, ValuesThatJump)
{
  // Each material has the values that it has alone, where the points are the same.
  const Grid input = MakeAllTypes();
  AddCellArray(input, "Material", { 1, 2, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1 });
  vtkNew<vtkDoubleArray> values;
  values->SetName("Value");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(1.);
  }
  input->GetPointData()->AddArray(values);
  const Configure jumps = With(
    [](Filter* filter)
    {
      filter->PreserveInterfacesOn();
      filter->SetInterfaceValuesToDiscontinuous();
      SetCellArray(filter, 1, "Material");
    });
  for (int levels = 0; levels <= 2; ++levels)
  {
    const Grid output = Execute(input, levels, jumps);
    vtkDataArray* origins = output->GetPointData()->GetArray("MaterialPointIds");
    ASSERT_NE(origins, nullptr) << levels;
    // A constant stays one, and the points are those without jumps.
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      EXPECT_NEAR(output->GetPointData()->GetArray("Value")->GetComponent(i, 0), 1., 1e-14);
    }
    const Grid whole = Execute(input, levels,
      With(
        [](Filter* filter)
        {
          filter->PreserveInterfacesOn();
          SetCellArray(filter, 1, "Material");
        }));
    EXPECT_GT(output->GetNumberOfPoints(), whole->GetNumberOfPoints());
    for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(GetPoint(output, i), GetPoint(whole, i)) << i;
    }
    // The output can go on: its copies are one point again, and jump again.
    const Grid next = Execute(output, 1, jumps);
    EXPECT_GT(next->GetNumberOfPoints(), output->GetNumberOfPoints());
  }
  // Filters in a row join copies, and jump again.
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    values->SetValue(i, std::sin(7. * static_cast<double>(i)));
  }
  ExpectSame(Execute(Execute(input, 1, jumps), 1, jumps), Execute(input, 2, jumps));
  // The values of cells of two materials as values of points keep their range on each side.
  const Grid jumping = DeepCopy(input);
  const Grid once = Execute(jumping, 0,
    [&](Filter* filter)
    {
      jumps(filter);
      filter->AddFieldOfCells("Material");
    });
  const Grid output = Execute(once, 2, jumps);
  vtkDataArray* field = output->GetPointData()->GetArray("Material");
  ASSERT_NE(field, nullptr);
  vtkDataArray* material = output->GetCellData()->GetArray("Material");
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    for (const vtkIdType i : GetCell(output, c))
    {
      EXPECT_NEAR(field->GetComponent(i, 0), material->GetComponent(c, 0), 1e-12) << c;
    }
  }
}

TEST(HybridFeatures, AnglesOfCorners)
{
  // A grid of quads, and the same of triangles: angles of corners count in both.
  std::vector<Point> points;
  for (int i = 0; i < 9; ++i)
  {
    points.push_back({ i % 3 * 1., i / 3 * 1., i * i * .02 });
  }
  const Grid quads = MakeGrid(points,
    { { VTK_QUAD, { 0, 1, 4, 3 } }, { VTK_QUAD, { 1, 2, 5, 4 } }, { VTK_QUAD, { 3, 4, 7, 6 } },
      { VTK_QUAD, { 4, 5, 8, 7 } }, { VTK_VERTEX, { 1 } } });
  AddCellArray(quads, "Singular", { 0, 0, 0, 0, 1 });
  vtkNew<vtkDoubleArray> angles;
  angles->SetName("Angles");
  for (int i = 0; i < 9; ++i)
  {
    angles->InsertNextValue(i == 1 ? 120. : -1.);
  }
  quads->GetPointData()->AddArray(angles);
  const auto execute = [&](bool hasAngles)
  {
    return Execute(quads, 1,
      With(
        [hasAngles](Filter* filter)
        {
          SetCellArray(filter, 0, "Singular");
          if (hasAngles)
          {
            filter->SetInputArrayToProcess(
              10, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Angles");
          }
        }));
  };
  const Grid plain = execute(false);
  const Grid angled = execute(true);
  // The edge 1 4, with t = 60 degrees at its corner: 3/8 cos(t) / 4 more there than by 3/8.
  int changed = 0;
  for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
  {
    if (GetPoint(plain, i) != GetPoint(angled, i))
    {
      ++changed;
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(GetPoint(angled, i)[c] - GetPoint(plain, i)[c],
          (points[1][c] - points[4][c]) * std::cos(std::acos(-1.) / 3.) / 4., 1e-14);
      }
    }
  }
  EXPECT_EQ(changed, 1);
}

/// Limits and normals where something is still sharp are those of finer levels, also by the
/// default.
TEST(HybridFeatures, LimitsWhereSomethingIsStillSharp)
{
  const Grid input = MakeAllTypes();
  AddSharpness(input, { { 8, 2.5 } });
  const auto run = [&](int levels, const Configure& configure)
  {
    vtkNew<Messages> messages;
    const Grid output = Execute(
      input, levels,
      [&](Filter* filter)
      {
        configure(filter);
        ReadSharpness(filter);
        filter->ProjectToLimitOn();
        filter->GenerateLimitNormalsOn();
      },
      messages);
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(messages->CountWarnings("is not available"), 0);
    return output;
  };
  const Grid expected = run(3, Hybrid);
  for (const int levels : { 0, 1, 2 })
  {
    const Grid output = run(levels, Hybrid);
    ExpectSame(run(levels, [](Filter* filter) { filter->SetVolumeSchemeToAutomatic(); }), output);
    vtkDataArray* normals = output->GetPointData()->GetArray("LimitNormals");
    vtkDataArray* wanted = expected->GetPointData()->GetArray("LimitNormals");
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(GetPoint(output, i)[c], GetPoint(expected, i)[c], 1e-12) << i;
        EXPECT_NEAR(normals->GetComponent(i, c), wanted->GetComponent(i, c), 1e-6) << i;
      }
    }
  }
  vtkNew<Messages> messages;
  const Grid interpolated = Execute(input, 1,
    With(
      [](Filter* filter)
      {
        ReadSharpness(filter);
        filter->ProjectToLimitOn();
        filter->InterpolatePointsOn();
      }),
    messages);
  EXPECT_TRUE(messages->Errors.empty());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(interpolated, i)[c], GetPoint(input, i)[c], 1e-9) << i;
    }
  }
}
