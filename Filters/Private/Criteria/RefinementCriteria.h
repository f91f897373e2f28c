// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinementCriteria.h
 * Where a mesh is to be refined, whatever refines it: criteria on edges (two points) and on cells
 * (lists of points). Errors are told as multiples of what is allowed, so that the worst can be
 * found: above 1 means refine.
 */
#ifndef SubdivisionObjects_RefinementCriteria_h
#define SubdivisionObjects_RefinementCriteria_h

#include "Core/Memory/GrowingBuffer.h"

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

  bool ByCurvature = false;
  double MaximumAngle = 10.; ///< in degrees

  vtkSmartPointer<vtkDataArray> WantedLevel; ///< of cells
  int MaximumLevel = 3;
  /// How integers are taken along to new points, see PointArrays.
  bool InterpolateIntegers = false;

  /// Whether some criterion asks for the limit's shape, or for the limit of anything.
  bool ReadsShape() const { return this->ByGeometricError || this->ByCurvature; }
  bool ReadsLimit() const
  {
    return this->ReadsShape() || (this->Attribute && this->AttributeOfLimit);
  }
};

/// An array of points in double, continued to points that are added between others. The array's own
/// values are read where they are if they are double.
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
    return this->Components == 0 ? 0 : this->Given + this->Added.size() / this->Components;
  }
  const double* Get(vtkIdType point) const
  {
    return point < this->Given ? this->Values + point * this->Components
                               : this->Added.data() + (point - this->Given) * this->Components;
  }
  bool IsSmooth() const { return this->Smooth; }
  /// All values, from here on to be changed too, and room for those of `size` points.
  double* Grow(vtkIdType size);
  double GetNorm(vtkIdType point) const;
  /// To the last bit where it is not clearly below `allowed`.
  double GetDistance(vtkIdType a, vtkIdType b, double allowed) const;
  /// The diagonal of the box of all values that are finite.
  double GetRange() const;
  /// ends(i): the two points that the i-th added one lies between, the earlier one first. They are
  /// old, or added before it.
  template <typename Ends>
  void Continue(vtkIdType size, const Ends& ends);

private:
  void FillCentres(const SimplicesOfCells& cells, vtkIdType given);

  vtkSmartPointer<vtkDataArray> Array; ///< as long as it is read
  Buffer<double> Converted;
  const double* Values = nullptr; ///< the array's, or converted ones
  vtkIdType Given = 0;            ///< so many of them, with centres; the others are added
  GrowingBuffer<double> Added;
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
  /// The same where the distance is known, and the length of the longest edge.
  double GetGeometricError(double distance, double length) const;
  /**
   * The same over an edge inside a surface; `opposites`: the third corners of its one or two
   * triangles that are known. The surface has to be near one of two triangles, and each plane near
   * the surface. A place beside the edge, in the planes of the triangles, is no error of a surface,
   * unless they are folded over: then the surface ends beside the edge.
   */
  double GetErrorOverEdge(const double* const ends[2], const double* const opposites[2],
    int triangles, const double* place) const;
  /// Of a place over the plane of three corners, with a sign.
  static double GetHeight(const double* const* corners, const double* place);

  /// Whether any criterion asks for errors of edges.
  bool ReadsEdges() const
  {
    return this->Options.ByEdgeLength || this->Options.Attribute || this->Options.ReadsLimit();
  }

  /// Whether there is an implicit function, and whether it may be asked in several threads.
  bool ReadsFunction() const { return this->Options.Function != nullptr; }
  bool IsFunctionForThreads() const;
  /// Whether nothing else is to be looked at where it is positive.
  bool ReadsFunctionOnly() const
  {
    return this->ReadsFunction() && !this->ReadsEdges() && this->Options.Selected.empty() &&
      !this->Options.WantedLevel && !this->Options.Range;
  }
  /// The function at the centroids of cells from `first` to `last`; `centroids` is room for them.
  template <typename Cells>
  void EvaluateFunction(const Cells& cells, vtkIdType first, vtkIdType last,
    Buffer<double>& centroids, Buffer<double>& values) const;

  /// The error of a cell. Cells tell GetInputCell(i), GetLevel(i). `value`: of the function.
  template <typename Cells, typename Points>
  double GetCellError(
    const Cells& cells, vtkIdType i, const Points& points, const double* value) const;

private:
  double Allow(double error, double allowed) const;
  template <typename Points>
  bool IsInRange(const Points& points, vtkIdType inputCell) const;
  void EvaluateFunction(double* centroids, vtkIdType size, double* values) const;

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
  double* value = this->Added.Extend((size - old) * this->Components);
  for (vtkIdType i = old; i < size; ++i)
  {
    const auto [first, second] = ends(i);
    const double* a = this->Get(first);
    const double* b = this->Get(second);
    for (int c = 0; c < this->Components; ++c)
    {
      *value++ = this->Smooth ? 0.5 * a[c] + 0.5 * b[c] : a[c];
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
void RefinementCriteria::EvaluateFunction(const Cells& cells, vtkIdType first, vtkIdType last,
  Buffer<double>& centroids, Buffer<double>& values) const
{
  double* centroid = centroids.data();
  cells.ForPoints(first, last,
    [&](vtkIdType, const auto& points)
    {
      if (points.size() == 4) // a quarter is exact, and much faster than a division
      {
        const double* x[4];
        std::transform(points.begin(), points.end(), x,
          [this](auto point) { return this->Coordinates.Get(point); });
        for (int c = 0; c < 3; ++c)
        {
          centroid[c] = 0.25 * x[0][c] + 0.25 * x[1][c] + 0.25 * x[2][c] + 0.25 * x[3][c];
        }
      }
      else
      {
        std::fill(centroid, centroid + 3, 0.);
        for (auto point : points)
        {
          const double* x = this->Coordinates.Get(point);
          for (int c = 0; c < 3; ++c)
          {
            centroid[c] += x[c] / static_cast<double>(points.size());
          }
        }
      }
      centroid += 3;
    });
  this->EvaluateFunction(centroids.data(), last - first, values.data());
}

template <typename Cells, typename Points>
double RefinementCriteria::GetCellError(
  const Cells& cells, vtkIdType i, const Points& points, const double* value) const
{
  const vtkIdType inputCell = cells.GetInputCell(i);
  const int level = cells.GetLevel(i);
  const bool wanted = (value && *value <= 0.) ||
    (!this->Options.Selected.empty() && this->Options.Selected[inputCell]) ||
    (this->Options.WantedLevel && this->Options.WantedLevel->GetComponent(inputCell, 0) > level) ||
    (this->Options.Range && this->IsInRange(points, inputCell));
  // Of cells that are wanted the coarse ones come first, each level as bad again as the next.
  return wanted ? std::ldexp(1.5, std::max(this->Options.MaximumLevel - level, 0)) : 0.;
}

}

#endif
