// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceStamp.cxx
 * How vtkSurfaceSubdivision knows its own output, and what it believes of a file.
 */
#include "SurfaceTools.h"

using namespace surfacetools;

namespace
{

vtkIdTypeArray* GetStamp(vtkPolyData* output)
{
  return vtkIdTypeArray::SafeDownCast(output->GetFieldData()->GetArray("SubdivisionSurface"));
}

void AddField(vtkPolyData* mesh, const char* name, const std::vector<vtkIdType>& values)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  for (const vtkIdType value : values)
  {
    array->InsertNextValue(value);
  }
  mesh->GetFieldData()->AddArray(array);
}

}

/// Schemes that are refined anew to see whether the stamp tells the truth: 20 levels of sqrt(3) are
/// 3,486,784,401 triangles for each one.
TEST(SurfaceStamp, AForgedNumberOfLevelsCostsNothing)
{
  for (const int scheme : { vtkSurfaceSubdivision::SQRT_THREE, vtkSurfaceSubdivision::FOUR_EIGHT,
         vtkSurfaceSubdivision::DOO_SABIN, vtkSurfaceSubdivision::MIDEDGE })
  {
    const auto output = RunFilter(MakeInput(MakeZoo(true)["tetrahedron"]), scheme, 2);
    const auto plain = vtkSmartPointer<vtkPolyData>::New();
    plain->DeepCopy(output);
    plain->GetFieldData()->Initialize();
    ASSERT_EQ(GetStamp(output)->GetValue(2), 2);
    GetStamp(output)->SetValue(2, 20);
    ExpectSameBits(RunFilter(output, scheme, 1), RunFilter(plain, scheme, 1));
  }
}

TEST(SurfaceStamp, AForgedStampIsNotBelieved)
{
  const Model grid = MakeSheet(2, 1, false, { 1., 0., 0. }, { 0., 1., 0. });
  const auto plain = MakeInput(grid);
  const auto expected = RunFilter(plain, vtkSurfaceSubdivision::CATMULL_CLARK, 1);
  const vtkIdType points = plain->GetNumberOfPoints();
  const vtkIdType version = GetStamp(expected)->GetValue(0);
  for (const vtkIdType size : { 1 << 26, 1 << 28, 1 << 30, 3, 4, 5, 0 })
  {
    for (const vtkIdType levels : { 1, 2, 19, 20 })
    {
      const auto forged = MakeInput(grid);
      // Version, scheme, levels, control points, control faces, corners of each, points, cells.
      AddField(forged, "SubdivisionSurface",
        { version, vtkSurfaceSubdivision::CATMULL_CLARK, levels, points, 1, size, points, 2 });
      // Read where there is no common size.
      AddField(forged, "SubdivisionSurfaceSizes", { vtkIdType(1) << 58 });
      ExpectSameBits(RunFilter(forged, vtkSurfaceSubdivision::CATMULL_CLARK, 1), expected);
    }
  }
}

/// Schemes whose stamps have the control cells: lines would be halved 20 times, too.
TEST(SurfaceStamp, AForgedNumberOfLevelsOfLinesCostsNothing)
{
  constexpr vtkIdType lines = 3000;
  Model model;
  for (vtkIdType i = 0; i <= lines; ++i)
  {
    model.Points.push_back({ static_cast<double>(i), 0., 0. });
    if (i > 0)
    {
      model.Lines.push_back({ i - 1, i });
    }
  }
  for (const int scheme : { vtkSurfaceSubdivision::SQRT_THREE, vtkSurfaceSubdivision::FOUR_EIGHT,
         vtkSurfaceSubdivision::DOO_SABIN, vtkSurfaceSubdivision::MIDEDGE })
  {
    const auto plain = MakeInput(model);
    const auto expected = RunFilter(plain, scheme, 1);
    for (const int levels : { 3, 20 })
    {
      const auto forged = MakeInput(model);
      const vtkIdType version = GetStamp(expected)->GetValue(0);
      AddField(forged, "SubdivisionSurface",
        { version, scheme, levels, lines + 1, 0, 3, lines + 1, lines });
      std::vector<vtkIdType> control;
      for (vtkIdType i = 0; i < lines; ++i)
      {
        control.insert(control.end(), { i, i + 1 });
      }
      AddField(forged, "SubdivisionSurfaceCells", control);
      ExpectSameBits(RunFilter(forged, scheme, 1), expected);
    }
  }
}

/// New points take integers and strings from the parent with the smallest global id; outputs have
/// none.
TEST(SurfaceStamp, GlobalIdsGoOn)
{
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::SQRT_THREE;
    ++scheme)
  {
    const auto input = MakeInput(MakeSheet(
      4, 4, scheme != vtkSurfaceSubdivision::CATMULL_CLARK, { 1., 0., 0. }, { 0.2, 1., 0. }));
    const vtkIdType size = input->GetNumberOfPoints();
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("Ids");
    vtkNew<vtkIntArray> numbers;
    numbers->SetName("Number");
    for (vtkIdType i = 0; i < size; ++i)
    {
      ids->InsertNextValue(1000 - 7 * i);
      numbers->InsertNextValue(static_cast<int>(i));
    }
    input->GetPointData()->AddArray(numbers);
    const auto withoutIds = RunFilter(input, scheme, 3);
    input->GetPointData()->SetGlobalIds(ids);
    const auto direct = RunFilter(input, scheme, 3);
    auto chained = RunFilter(input, scheme, 1);
    chained = RunFilter(chained, scheme, 1);
    chained = RunFilter(chained, scheme, 1);
    auto getNumbers = [](vtkPolyData* output)
    {
      vtkDataArray* array = output->GetPointData()->GetArray("Number");
      std::vector<int> values;
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        values.push_back(static_cast<int>(array->GetTuple1(i)));
      }
      return values;
    };
    EXPECT_EQ(getNumbers(chained), getNumbers(direct)) << scheme;
    EXPECT_NE(getNumbers(withoutIds), getNumbers(direct)) << scheme;
  }
}

namespace
{

/// A bumpy grid with three creases that meet inside, two at its boundary, and their sharpness.
vtkSmartPointer<vtkPolyData> MakeCreased(bool triangles, bool flagged)
{
  Model grid = MakeSheet(4, 4, triangles, { 1., 0., 0. }, { 0.2, 1., 0. });
  const std::vector<Point> noise = MakeRandomPoints(grid.Points.size(), 5);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      grid.Points[i][c] += 0.3 * noise[i][c];
    }
  }
  grid.Lines = { { 12, 13 }, { 12, 7 }, { 12, 11 }, { 11, 10 }, { 2, 7 } };
  const auto input = MakeInput(grid);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  const double values[] = { 2.5, 1.3, 4., 0.7, 1. };
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    flags->InsertNextValue(flagged && cell < 3);
    sharpness->InsertNextValue(cell < 5 ? values[cell] : 0.);
  }
  input->GetCellData()->AddArray(flags);
  input->GetCellData()->AddArray(sharpness);
  // Angles and flatness that are given, for some.
  vtkNew<vtkDoubleArray> angles;
  angles->SetName("Angles");
  vtkNew<vtkDoubleArray> flatness;
  flatness->SetName("Flatness");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    angles->InsertNextValue(i % 3 == 0 ? 100. : -1.);
    flatness->InsertNextValue(i % 4 == 0 ? 0.3 : -1.);
  }
  input->GetPointData()->AddArray(angles);
  input->GetPointData()->AddArray(flatness);
  return input;
}

vtkSmartPointer<vtkPolyData> RunCreased(
  vtkPolyData* input, int scheme, int levels, bool limit, bool shapes)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(limit);
  filter->GenerateOriginalIdsOn();
  filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
  if (shapes)
  {
    filter->SetInputArrayToProcess(10, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Angles");
    filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Flatness");
  }
  filter->Update();
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

}

TEST(SurfaceStamp, SharpAndFlaggedCornersChain)
{
  for (const int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
         vtkSurfaceSubdivision::MODIFIED_BUTTERFLY })
  {
    for (const bool flagged : { false, true })
    {
      for (const bool shapes : { false, true })
      {
        const auto input = MakeCreased(scheme != vtkSurfaceSubdivision::CATMULL_CLARK, flagged);
        auto chained = RunCreased(input, scheme, 1, false, shapes);
        chained = RunCreased(chained, scheme, 1, false, shapes);
        ExpectSameBits(chained, RunCreased(input, scheme, 2, false, shapes));
        ExpectSameBits(
          RunCreased(chained, scheme, 1, true, shapes), RunCreased(input, scheme, 3, true, shapes));
      }
    }
  }
}

TEST(SurfaceStamp, OriginalCellsAreThoseOfTheFirstInput)
{
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::SQRT_THREE;
    ++scheme)
  {
    const Model cube = MakeZoo(false)["cube"];
    const auto input = MakeInput(cube);
    vtkNew<vtkIntArray> numbers;
    numbers->SetName("Number");
    for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
    {
      numbers->InsertNextValue(static_cast<int>(cell));
    }
    input->GetCellData()->AddArray(numbers);
    vtkSmartPointer<vtkPolyData> chained = input;
    for (int levels = 1; levels < 5; ++levels)
    {
      vtkNew<vtkSurfaceSubdivision> filter;
      filter->SetInputData(chained);
      filter->SetScheme(scheme);
      filter->SetNumberOfLevels(1);
      filter->GenerateOriginalIdsOn();
      filter->Update();
      chained = vtkSmartPointer<vtkPolyData>::New();
      chained->ShallowCopy(filter->GetOutput());
      vtkDataArray* ids = chained->GetCellData()->GetArray("vtkOriginalCellIds");
      vtkDataArray* known = chained->GetCellData()->GetArray("Number");
      ASSERT_TRUE(ids && known);
      for (vtkIdType cell = 0; cell < chained->GetNumberOfCells(); ++cell)
      {
        ASSERT_EQ(ids->GetComponent(cell, 0), known->GetComponent(cell, 0))
          << "scheme " << scheme << " level " << levels;
      }
    }
  }
}
