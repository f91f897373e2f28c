// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/CellMeasures.h"

#include "vtkMath.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <limits>

namespace subdivision
{
namespace
{

double MeasureTet(const double* a, const double* b, const double* c, const double* d)
{
  double edges[3][3];
  vtkMath::Subtract(b, a, edges[0]);
  vtkMath::Subtract(c, a, edges[1]);
  vtkMath::Subtract(d, a, edges[2]);
  return vtkMath::Determinant3x3(edges) / 6.;
}

/// Cones from a corner to the faces. A bilinear face has the mean of the volumes that its two cuts
/// have.
double MeasureHexahedron(const double points[8][3])
{
  constexpr int faces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
    { 0, 3, 2, 1 }, { 4, 5, 6, 7 } }; // outward
  double volume = 0.;
  for (const auto& face : faces)
  {
    for (int i = 0; i < 4; ++i)
    {
      volume += MeasureTet(
        points[0], points[face[i]], points[face[(i + 1) % 4]], points[face[(i + 2) % 4]]);
    }
  }
  return volume / 2.;
}

}

CellMeasures MeasureCell(vtkPointSet* mesh, const vtkIdType* corners, vtkIdType size)
{
  double points[8][3];
  for (vtkIdType i = 0; i < size; ++i)
  {
    mesh->GetPoint(corners[i], points[i]);
  }
  CellMeasures found;
  if (size == 4)
  {
    found.Volume = found.Least = MeasureTet(points[0], points[1], points[2], points[3]);
    return found;
  }
  found.Volume = MeasureHexahedron(points);
  found.Least = std::numeric_limits<double>::max();
  for (int i = 0; i < 8; ++i)
  {
    const int next = (i + 1) % 4 + i / 4 * 4;
    const int before = (i + 3) % 4 + i / 4 * 4;
    const int other = (i + 4) % 8;
    const double volume = i < 4
      ? MeasureTet(points[i], points[next], points[before], points[other])
      : MeasureTet(points[i], points[before], points[next], points[other]);
    found.Least = std::min(found.Least, volume);
  }
  return found;
}

}
