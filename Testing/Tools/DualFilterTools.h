// SPDX-License-Identifier: BSD-3-Clause
// What the surface filter does around dual schemes.
#ifndef DualFilterTools_h
#define DualFilterTools_h

#include "DualSchemeTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace dualtools
{

using Data = vtkSmartPointer<vtkPolyData>;

Data MakeData(const Points& points, const Faces& faces, const Faces& lines = {},
  const std::vector<int>& vertices = {});

void AddIds(
  vtkDataSetAttributes* data, const char* name, const std::vector<vtkIdType>& values, bool global);

Data Subdivide(vtkPolyData* input, int scheme, int levels);

void ExpectSameArray(vtkDataArray* a, vtkDataArray* b);

void ExpectSameData(vtkPolyData* a, vtkPolyData* b);

/// Filters of one level are one filter of several, bit for bit: on all shapes, with a curve on
/// edges of the surface, a free one, two lines on one edge, vertices with and without faces.
void ExpectFiltersInARow(int scheme);

void ExpectLinesAndVertices(int scheme);

/// Creases and limits mean nothing here, and the filter says so.
void ExpectWarnings(int scheme);

}

#endif
