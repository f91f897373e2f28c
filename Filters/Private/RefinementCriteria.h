// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinementCriteria.h
 * Where a mesh is to be refined, whatever refines it: criteria on edges (two points) and on cells
 * (lists of points). Errors are told as multiples of what is allowed, so that the worst can be
 * found: above 1 means refine.
 */
#ifndef SubdivisionObjects_RefinementCriteria_h
#define SubdivisionObjects_RefinementCriteria_h

#include "Core/Buffer.h"

#include "vtkDataArray.h"
#include "vtkImplicitFunction.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

struct SimplicesOfCells;

/// A criterion is on where its array, function or tolerance is there.
struct RefinementOptions
{
  vtkSmartPointer<vtkDataArray> Attribute; ///< of points
  double AttributeTolerance = 0.1;
  bool AttributeOfLimit = false; ///< LimitDifference instead of Jump

  vtkSmartPointer<vtkDataArray> Range; ///< of points, or of cells
  bool RangeOfCells = false;
  double Least = 0.;
  double Most = 1.;

  std::vector<unsigned char> Selected; ///< of input cells; empty: none
  vtkSmartPointer<vtkImplicitFunction> Function;

  bool ByEdgeLength = false;
  double MaximumEdgeLength = 1.;

  bool ByGeometricError = false;
  double GeometricTolerance = 0.001;
  bool RelativeTolerance = true; ///< to the bounding box of the input

  vtkSmartPointer<vtkDataArray> WantedLevel; ///< of cells
  int MaximumLevel = 3;
  /// How integers are taken along to new points, see PointArrays.
  bool InterpolateIntegers = false;

  /// Whether some criterion asks for the limit.
  bool ReadsLimit() const
  {
    return this->ByGeometricError || (this->Attribute && this->AttributeOfLimit);
  }
};

/// An array of points in double, continued to points that are added between others.
class ContinuedArray
{
public:
  /// The array itself, then the mean over the members of each centre. Arrays that are not
  /// interpolated take the value of one point: `smooth` is false.
  void Start(vtkDataArray* array, const SimplicesOfCells& cells, bool smooth);
  bool IsSet() const { return this->Components > 0; }
  int GetComponents() const { return this->Components; }
  vtkIdType GetSize() const
  {
    return this->Components == 0 ? 0
                                 : static_cast<vtkIdType>(this->Values.size()) / this->Components;
  }
  const double* Get(vtkIdType point) const
  {
    return this->Values.data() + point * this->Components;
  }
  bool IsSmooth() const { return this->Smooth; }
  /// All values, made room for `size` points.
  double* Grow(vtkIdType size)
  {
    this->Values.resize(static_cast<std::size_t>(size) * this->Components);
    return this->Values.data();
  }
  double GetNorm(vtkIdType point) const;
  double GetDistance(vtkIdType a, vtkIdType b) const;
  /// The diagonal of the box of all values that are finite.
  double GetRange() const;
  /// ends(i): the two points that the i-th added one lies between, the earlier one first. They are
  /// old, or added before it.
  template <typename Ends>
  void Continue(vtkIdType size, const Ends& ends);

private:
  std::vector<double> Values;
  int Components = 0;
  bool Smooth = true;
};

class RefinementCriteria
{
public:
  /// `cells` say which points were added to the input's.
  RefinementCriteria(
    const RefinementOptions& options, vtkPointSet* input, const SimplicesOfCells& cells);

  /// Points that were added since, up to `size`.
  template <typename Ends>
  void Continue(vtkIdType size, const Ends& ends)
  {
    this->Coordinates.Continue(size, ends);
    this->Attribute.Continue(size, ends);
    if (!this->Options.RangeOfCells)
    {
      this->Range.Continue(size, ends);
    }
  }

  /// The arrays of points: coordinates, then those of the other criteria. For meshes whose points
  /// move: tolerances are of the input all the same.
  std::vector<ContinuedArray*> GetPointArrays();

  const ContinuedArray& GetCoordinates() const { return this->Coordinates; }
  const ContinuedArray& GetAttribute() const { return this->Attribute; }

  /// The error of an edge for the criteria that do not ask for the limit. Values that are not
  /// finite have no error; `hasNoValue` tells of them.
  double GetEdgeError(vtkIdType a, vtkIdType b, bool& hasNoValue) const;

  /// Whether two points differ, but no number lies between them: nothing to split.
  bool IsTooShort(vtkIdType a, vtkIdType b) const;

  /// The errors at a place, made a little larger, because between places they are. That of the
  /// attribute on an edge is how far its value is from what the two ends with these weights give;
  /// negative if a value is not finite.
  double GetAttributeErrorAtLimit(
    const double* const* corners, const double* weights, const double* value) const;
  /// The distance from the edge or triangle between two or three corners.
  double GetGeometricError(const double* const* corners, int size, const double* place) const;
  /// The same where the distance is known.
  double GetGeometricError(double distance) const;

  /// Whether any criterion asks for errors of edges.
  bool ReadsEdges() const
  {
    return this->Options.ByEdgeLength || this->Options.Attribute || this->Options.ReadsLimit();
  }

  /// errors[i] of cell first + i, for each i < size. Cells tell GetPoints(i) (a range of ids),
  /// GetInputCell(i), GetLevel(i).
  template <typename Cells>
  void GetCellErrors(
    const Cells& cells, vtkIdType first, vtkIdType size, Buffer<double>& errors) const;

private:
  double Allow(double error, double allowed) const;
  template <typename Points>
  bool IsInRange(const Points& points, vtkIdType inputCell) const;
  void EvaluateFunction(const Buffer<double>& centroids, Buffer<double>& values) const;

  const RefinementOptions& Options;
  ContinuedArray Coordinates;
  ContinuedArray Attribute;
  ContinuedArray Range;
  double AllowedJump = 0.;
  double AllowedDistance = 0.;
};

// ------------------------------------------------------------------------------------------------

template <typename Ends>
void ContinuedArray::Continue(vtkIdType size, const Ends& ends)
{
  const vtkIdType old = this->GetSize();
  if (!this->IsSet() || size <= old)
  {
    return;
  }
  this->Values.resize(static_cast<std::size_t>(size) * this->Components);
  double* values = this->Values.data();
  for (vtkIdType i = old; i < size; ++i)
  {
    const auto [first, second] = ends(i);
    for (int c = 0; c < this->Components; ++c)
    {
      const double a = values[static_cast<vtkIdType>(first) * this->Components + c];
      const double b = values[static_cast<vtkIdType>(second) * this->Components + c];
      values[i * this->Components + c] = this->Smooth ? 0.5 * a + 0.5 * b : a;
    }
  }
}

template <typename Points>
bool RefinementCriteria::IsInRange(const Points& points, vtkIdType inputCell) const
{
  auto inside = [this](double value)
  { return value >= this->Options.Least && value <= this->Options.Most; };
  if (this->Options.RangeOfCells)
  {
    return inside(this->Range.GetNorm(inputCell));
  }
  return std::any_of(
    points.begin(), points.end(), [&](auto point) { return inside(this->Range.GetNorm(point)); });
}

template <typename Cells>
void RefinementCriteria::GetCellErrors(
  const Cells& cells, vtkIdType first, vtkIdType size, Buffer<double>& errors) const
{
  Buffer<double> values;
  if (this->Options.Function)
  {
    Buffer<double> centroids(3 * size);
    ForEach(size,
      [&](vtkIdType i)
      {
        const auto points = cells.GetPoints(first + i);
        double* centroid = centroids.data() + 3 * i;
        std::fill(centroid, centroid + 3, 0.);
        for (auto point : points)
        {
          const double* x = this->Coordinates.Get(point);
          for (int c = 0; c < 3; ++c)
          {
            // A quarter is exact, and much faster than a division.
            centroid[c] +=
              points.size() == 4 ? 0.25 * x[c] : x[c] / static_cast<double>(points.size());
          }
        }
      });
    this->EvaluateFunction(centroids, values);
  }
  ForEach(size,
    [&](vtkIdType i)
    {
      const vtkIdType inputCell = cells.GetInputCell(first + i);
      const int level = cells.GetLevel(first + i);
      const bool wanted = (!this->Options.Selected.empty() && this->Options.Selected[inputCell]) ||
        (this->Options.WantedLevel &&
          this->Options.WantedLevel->GetComponent(inputCell, 0) > level) ||
        (!values.empty() && values[i] <= 0.) ||
        (this->Options.Range && this->IsInRange(cells.GetPoints(first + i), inputCell));
      // Of cells that are wanted the coarse ones come first, each level as bad again as the next.
      errors[i] = wanted ? std::ldexp(1.5, std::max(this->Options.MaximumLevel - level, 0)) : 0.;
    });
}

}

#endif
