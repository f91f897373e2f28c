// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SubdivisionDeformationTools.h
 * Cages, things inside of them, and a filter that is told the three.
 */
#ifndef SubdivisionObjects_SubdivisionDeformationTools_h
#define SubdivisionObjects_SubdivisionDeformationTools_h

#include "FeatureTools.h"

#include "vtkSubdivisionDeformation.h"

namespace deformation_tools
{

using namespace feature_tools;
using Map = std::function<Point(const Point&)>;

/// Points in a box, one vertex cell each, with arrays of every kind.
Grid MakeCloud(int size, Point low, Point high, unsigned seed, int type = VTK_DOUBLE);

/// The points of a mesh, in double precision, at other places.
vtkSmartPointer<vtkPoints> MovePoints(vtkPointSet* mesh, const Map& map);

Grid Moved(vtkUnstructuredGrid* mesh, const Map& map);

/// x -> a (1.1 x + 0.4 y - 0.3 z, …) + b: turns, shears and stretches.
inline Point Affine(const Point& x)
{
  return { 1.1 * x[0] + 0.4 * x[1] - 0.3 * x[2] + 0.7, -0.5 * x[0] + 0.9 * x[1] + 0.2 * x[2] - 3.,
    0.1 * x[0] - 0.6 * x[1] + 1.7 * x[2] + 0.25 };
}

inline Point Bend(const Point& x)
{
  return { x[0] + 0.1 * x[2] * x[2], x[1] - 0.2 * std::sin(x[2]), x[2] + 0.1 * x[0] * x[1] };
}

/// A filter that stays, and what it said.
class Deformer
{
public:
  Deformer() { this->Heard->Watch(this->Filter); }
  vtkSubdivisionDeformation* operator->() { return this->Filter; }
  /// A copy of the output that shares its arrays.
  vtkSmartPointer<vtkPointSet> Run(
    vtkDataObject* input, vtkDataObject* rest, vtkDataObject* deformed);
  const std::vector<std::string>& GetWarnings() const { return this->Heard->Warnings; }
  const std::vector<std::string>& GetErrors() const { return this->Heard->Errors; }
  void Forget()
  {
    this->Heard->Warnings.clear();
    this->Heard->Errors.clear();
  }
  bool WasSilent() const { return this->Heard->Warnings.empty() && this->Heard->Errors.empty(); }

private:
  vtkNew<vtkSubdivisionDeformation> Filter;
  vtkNew<Messages> Heard;
};

/// The largest distance, in any coordinate, between the points and those of a map.
double GetLargestError(vtkPointSet* result, vtkPointSet* input, const Map& map);

inline std::string ComparePoints(vtkPointSet* a, vtkPointSet* b)
{
  return CompareValues(a->GetPoints()->GetData(), b->GetPoints()->GetData());
}

}

#endif
