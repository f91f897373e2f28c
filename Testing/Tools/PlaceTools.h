// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceTools.h
 * Places in cells, and the limit there by a filter that has EvaluateLimit.
 */
#ifndef PlaceTools_h
#define PlaceTools_h

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>

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

}

#endif
