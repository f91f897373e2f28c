// SPDX-License-Identifier: BSD-3-Clause
#include "DualFilterTools.h"

#include "vtkSurfaceSubdivision.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"

namespace dualtools
{

Data MakeData(
  const Points& points, const Faces& faces, const Faces& lines, const std::vector<int>& vertices)
{
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (const auto& p : points)
  {
    coordinates->InsertNextPoint(p.data());
  }
  auto fill = [](const Faces& from)
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& ids : from)
    {
      cells->InsertNextCell(static_cast<int>(ids.size()));
      for (const int id : ids)
      {
        cells->InsertCellPoint(id);
      }
    }
    return cells;
  };
  Faces single;
  for (const int vertex : vertices)
  {
    single.push_back({ vertex });
  }
  auto data = Data::New();
  data->SetPoints(coordinates);
  data->SetVerts(fill(single));
  data->SetLines(fill(lines));
  data->SetPolys(fill(faces));
  return data;
}

void AddIds(
  vtkDataSetAttributes* data, const char* name, const std::vector<vtkIdType>& values, bool global)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  for (const vtkIdType value : values)
  {
    array->InsertNextValue(value);
  }
  if (global)
  {
    data->SetGlobalIds(array);
  }
  else
  {
    data->AddArray(array);
  }
}

Data Subdivide(vtkPolyData* input, int scheme, int levels)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(levels);
  filter->Update();
  auto output = Data::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

void ExpectSameArray(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      ASSERT_EQ(a->GetComponent(i, c), b->GetComponent(i, c));
    }
  }
}

void ExpectSameData(vtkPolyData* a, vtkPolyData* b)
{
  ExpectSameArray(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  vtkCellArray* cells[3][2] = { { a->GetVerts(), b->GetVerts() }, { a->GetLines(), b->GetLines() },
    { a->GetPolys(), b->GetPolys() } };
  for (auto& pair : cells)
  {
    ExpectSameArray(pair[0]->GetConnectivityArray(), pair[1]->GetConnectivityArray());
    ExpectSameArray(pair[0]->GetOffsetsArray(), pair[1]->GetOffsetsArray());
  }
  ExpectSameArray(a->GetPointData()->GetArray("labels"), b->GetPointData()->GetArray("labels"));
  ExpectSameArray(a->GetCellData()->GetArray("cells"), b->GetCellData()->GetArray("cells"));
}

void ExpectFiltersInARow(int scheme)
{
  for (const Shape& shape : MakeShapes())
  {
    SCOPED_TRACE(shape.Name);
    const int n = shape.NumberOfVertices;
    const auto& face = shape.Polygons[0];
    const Data input = MakeData(MakePoints(n + 6), shape.Polygons,
      { { face[1], face[0], face[2] }, { n, n + 2, n + 1 }, { n + 1, n + 2 }, { n + 2, n + 3 },
        { n + 5, n } },
      { face[1], n + 4 });
    std::vector<vtkIdType> labels;
    for (int i = 0; i < n + 6; ++i)
    {
      labels.push_back((7 * i) % 5);
    }
    AddIds(input->GetPointData(), "labels", labels, false);
    std::vector<vtkIdType> cells;
    for (int i = 0; i < input->GetNumberOfCells(); ++i)
    {
      cells.push_back(i);
    }
    AddIds(input->GetCellData(), "cells", cells, false);
    Data step = input;
    for (int levels = 1; levels <= 4; ++levels)
    {
      SCOPED_TRACE(levels);
      step = Subdivide(step, scheme, 1);
      ExpectSameData(step, Subdivide(input, scheme, levels));
    }
  }
}

void ExpectLinesAndVertices(int scheme)
{
  // A free curve of three points, a line along an edge of the triangle, three vertex cells.
  const Points points = MakePoints(8);
  const Data input = MakeData(points, { { 0, 1, 2 } }, { { 3, 4, 5 }, { 1, 0 } }, { 2, 6, 4 });
  const Data out = Subdivide(input, scheme, 1);
  ASSERT_EQ(out->GetNumberOfVerts(), 3);
  ASSERT_EQ(out->GetNumberOfLines(), 6);
  auto expect = [&](vtkIdType id, const std::vector<std::pair<int, double>>& row)
  {
    double x[3];
    out->GetPoint(id, x);
    std::array<double, 3> sum{};
    for (const auto& entry : row)
    {
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += entry.second * points[entry.first][c];
      }
    }
    EXPECT_TRUE(IsNear({ x[0], x[1], x[2] }, sum));
  };
  auto getId = [&](vtkIdType cell, vtkIdType i)
  {
    vtkNew<vtkIdList> ids;
    out->GetCellPoints(cell, ids);
    return ids->GetId(i);
  };
  expect(getId(0, 0), { { 2, 1. } });
  expect(getId(1, 0), { { 6, 1. } });
  expect(getId(2, 0), { { 3, 0.125 }, { 4, 0.75 }, { 5, 0.125 } });
  expect(getId(3, 0), { { 3, 1. } });
  expect(getId(3, 1), { { 3, 0.5 }, { 4, 0.5 } });
  EXPECT_EQ(getId(4, 1), getId(2, 0));
  EXPECT_EQ(getId(4, 1), getId(5, 0));
  expect(getId(6, 1), { { 5, 1. } });
  expect(getId(7, 0), { { 1, 1. } });
  expect(getId(8, 1), { { 0, 1. } });
  // The point that no cell uses is there too.
  bool found = false;
  for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i)
  {
    double x[3];
    out->GetPoint(i, x);
    found = found || IsNear({ x[0], x[1], x[2] }, points[7]);
  }
  EXPECT_TRUE(found);
}

void ExpectWarnings(int scheme)
{
  const Data input = MakeData(MakePoints(4), { { 0, 1, 2 }, { 2, 1, 3 } }, { { 1, 2 } });
  const Data plain = Subdivide(input, scheme, 1);
  struct Ear
  {
    void Hear(vtkObject*, unsigned long, void* text)
    {
      this->Said.emplace_back(static_cast<const char*>(text));
    }
    std::vector<std::string> Said;
  } ear;
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->AddObserver(vtkCommand::WarningEvent, &ear, &Ear::Hear);
  filter->SetInputData(input);
  filter->SetScheme(scheme);
  filter->Update();
  EXPECT_TRUE(ear.Said.empty());
  filter->SetDetectFeatures(true);
  filter->SetFeatureAngle(0.);
  filter->Update();
  ASSERT_EQ(ear.Said.size(), 1u);
  EXPECT_NE(ear.Said[0].find("creases"), std::string::npos);
  ExpectSameArray(plain->GetPoints()->GetData(), filter->GetOutput()->GetPoints()->GetData());
}

}
