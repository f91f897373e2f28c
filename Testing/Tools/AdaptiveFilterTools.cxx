// SPDX-License-Identifier: BSD-3-Clause
#include "AdaptiveFilterTools.h"

#include "vtkGenericCell.h"
#include "vtkStaticCellLocator.h"

namespace adaptive_filter_tools
{

PolyData Refine(
  vtkPolyData* input, const std::function<void(Filter*)>& configure, Messages* messages)
{
  vtkNew<Filter> filter;
  filter->RefineByAttributeErrorOff();
  filter->RefineByGeometricErrorOff();
  configure(filter);
  UpdateInSilence(filter, input, messages);
  auto output = PolyData::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

void WantLevel(vtkPolyData* input, int level)
{
  vtkNew<vtkIntArray> wanted;
  wanted->SetName("WantedLevel");
  wanted->SetNumberOfTuples(input->GetNumberOfCells());
  wanted->FillValue(level);
  input->GetCellData()->AddArray(wanted);
}

PolyData MakeHill(int size)
{
  Model grid = MakeSheet(size, size, true, { 1., 0., 0. }, { 0.5, 0.8, 0. });
  for (Point& p : grid.Points)
  {
    const double x = p[0] / size - 0.75;
    const double y = p[1] / size - 0.4;
    p[2] = 0.3 * size * std::exp(-20. * (x * x + y * y));
  }
  grid.Lines = { { 1, 2 }, { 2, 3 } };
  PolyData input = MakeInput(grid);
  const vtkIdType points = input->GetNumberOfPoints();
  vtkNew<vtkFloatArray> values;
  values->SetName("Value");
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (vtkIdType i = 0; i < points; ++i)
  {
    values->InsertNextValue(static_cast<float>(input->GetPoint(i)[2]));
    labels->InsertNextValue(static_cast<int>(i % 5));
    names->InsertNextValue(std::to_string(i));
  }
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("OfCell");
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    ofCells->InsertNextValue(0.5 * static_cast<double>(i));
  }
  input->GetPointData()->SetScalars(values);
  input->GetPointData()->AddArray(labels);
  input->GetPointData()->AddArray(names);
  input->GetCellData()->AddArray(ofCells);
  return input;
}

double GetLargestDistance(vtkPolyData* from, vtkPolyData* to)
{
  vtkNew<vtkPolyData> faces;
  faces->SetPoints(to->GetPoints());
  faces->SetPolys(to->GetPolys());
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(faces);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell; // of one's own: each cell that VTK makes costs ten times the search
  double largest = 0.;
  for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
  {
    double nearest[3];
    vtkIdType id = 0;
    int part = 0;
    double distance = 0.;
    locator->FindClosestPoint(from->GetPoint(i), nearest, cell, id, part, distance);
    largest = std::max(largest, distance);
  }
  return std::sqrt(largest);
}

PolyData RefineByShape(vtkPolyData* input, double tolerance)
{
  return Refine(input,
    [tolerance](Filter* filter)
    {
      filter->RefineByGeometricErrorOn();
      filter->RelativeToleranceOff();
      filter->SetGeometricTolerance(tolerance);
      filter->SetMaximumLevel(20);
    });
}

}
