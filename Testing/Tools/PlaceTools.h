// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceTools.h
 * Places in cells, and the limit there by a filter that has EvaluateLimit.
 */
#ifndef PlaceTools_h
#define PlaceTools_h

#include "Precompiled.h"

namespace place_tools
{

struct Places
{
  vtkNew<vtkIdTypeArray> Cells;
  vtkNew<vtkDoubleArray> Parameters;
  Places() { this->Parameters->SetNumberOfComponents(3); }
  void Add(vtkIdType cell, const std::array<double, 3>& p)
  {
    this->Cells->InsertNextValue(cell);
    this->Parameters->InsertNextTuple(p.data());
  }
  vtkIdType GetSize() const { return this->Cells->GetNumberOfTuples(); }
};

/// The limit at places, which must not fail.
template <typename FilterPointer>
vtkSmartPointer<vtkPolyData> Evaluate(const FilterPointer& filter, const Places& places)
{
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  EXPECT_TRUE(filter->EvaluateLimit(places.Cells, places.Parameters, result));
  EXPECT_EQ(result->GetNumberOfPoints(), places.GetSize());
  EXPECT_EQ(result->GetNumberOfVerts(), places.GetSize());
  return result;
}

/// Points that a probe looks for.
inline vtkSmartPointer<vtkPolyData> MakeTargets(const std::vector<std::array<double, 3>>& targets)
{
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const std::array<double, 3>& target : targets)
  {
    points->InsertNextPoint(target.data());
  }
  data->SetPoints(points);
  return data;
}

/// The points of a limit, moved along its normals.
inline std::vector<std::array<double, 3>> MoveAlongNormals(vtkPolyData* limit, double distance)
{
  std::vector<std::array<double, 3>> moved(static_cast<std::size_t>(limit->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < limit->GetNumberOfPoints(); ++i)
  {
    double normal[3];
    limit->GetPoint(i, moved[i].data());
    limit->GetPointData()->GetArray("LimitNormals")->GetTuple(i, normal);
    for (int c = 0; c < 3; ++c)
    {
      moved[i][c] += distance * normal[c];
    }
  }
  return moved;
}

}

#endif
