// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinementCriteria.h
 * Tells where a mesh is to be refined, for all kinds of refinement: by criteria on edges (two
 * points) and on cells (lists of points). An error is a multiple of the allowed one, so that the
 * worst can be found; where it is above 1 the mesh is refined.
 */
#ifndef SubdivisionObjects_RefinementCriteria_h
#define SubdivisionObjects_RefinementCriteria_h

#include "Core/Memory/GrowingBuffer.h"

#include "vtkDataArray.h"
#include "vtkImplicitFunction.h"
#include "vtkMath.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

class vtkPointSet;

namespace subdivision
{

struct SimplicesOfCells;

/// The factor by which an error may be larger between the places where it is measured: quarters of
/// an edge, along which the limit is cubic, and of a triangle, in which it is nearly quadratic.
constexpr double BetweenPlaces = 1.1;

/// The criteria. One that has an array, a selection or a function is on if that is set; the others
/// have flags. GetEdgeError, GetCellError and GetGeometricError below tell their meaning.
struct RefinementOptions
{
  vtkSmartPointer<vtkDataArray> Attribute; ///< of points
  double AttributeTolerance = 0.1;
  bool AttributeErrorOfLimit = false; ///< LimitDifference instead of Jump

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
  /// Whether nobody chose criteria or tolerances: then something is refined on each mesh.
  bool AreDefaults = false;
  /// Where they ask for nothing: all edges, once. Returns whether that is new.
  bool SplitAll()
  {
    this->MaximumEdgeLength = this->AreDefaults ? 0. : this->MaximumEdgeLength;
    this->MaximumLevel = std::min(this->MaximumLevel, this->AreDefaults ? 1 : 60);
    this->ByEdgeLength = this->ByEdgeLength || this->AreDefaults;
    return std::exchange(this->AreDefaults, false);
  }
  /// Whether integers at new points are interpolated, as in PointArrays.
  bool InterpolateIntegers = false;

  /// Where the input is a part of a mesh: sets each value to the largest of all parts. Tolerances
  /// are relative to the whole mesh.
  std::function<void(std::vector<double>&)> FindLargest;

  /// Whether some criterion asks for the limit's shape, or for the limit of anything.
  bool ReadsShape() const { return this->ByGeometricError || this->ByCurvature; }
  bool ReadsLimit() const
  {
    return this->ReadsShape() || (this->Attribute && this->AttributeErrorOfLimit);
  }
  /// Whether some criterion asks for edges, or for cells by more than the function.
  bool ReadsEdges() const { return this->ByEdgeLength || this->Attribute || this->ReadsShape(); }
  bool ReadsCells() const { return !this->Selected.empty() || this->WantedLevel || this->Range; }
  /// Whether no criterion is on.
  bool IsEmpty() const { return !this->ReadsEdges() && !this->ReadsCells() && !this->Function; }
};

/// The values of a point array in double, extended to points that refinement adds. Values that are
/// in double already are read in place.
class ContinuedArray
{
public:
  /// Takes the values of the array, then of the centres: the mean of the members or, if `smooth` is
  /// false, the value of the first member.
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
  /// All values, with room for `size` points. From here on they are a copy, which the caller may
  /// change.
  double* Grow(vtkIdType size);
  double GetNorm(vtkIdType point) const;
  /// The distance between two values, by std::hypot unless it is clearly below `allowed`.
  double GetDistance(vtkIdType a, vtkIdType b, double allowed) const;
  /// The diagonal of the box of all values that are finite; `findLargest`: as in
  /// RefinementOptions.
  double GetRange(const std::function<void(std::vector<double>&)>& findLargest) const;
  /// Adds values for the points up to `size`. ends(i): the two points between which point i lies,
  /// the one with the smaller global id first; both come before i.
  template <typename Ends>
  void Continue(vtkIdType size, const Ends& ends);

private:
  void FillCentres(const SimplicesOfCells& cells, vtkIdType given);

  vtkSmartPointer<vtkDataArray> Array; ///< null once its values are copied
  Buffer<double> Converted;
  const double* Values = nullptr; ///< the array's, or converted ones
  vtkIdType Given = 0; ///< number of points in Values, centres included; the rest is in Added
  GrowingBuffer<double> Added;
  int Components = 0;
  bool Smooth = true;
};

class RefinementCriteria
{
public:
  /// `cells` has the centres that were added to the input's points.
  RefinementCriteria(
    const RefinementOptions& options, vtkPointSet* input, const SimplicesOfCells& cells);

  /// Extends the arrays to points that were added since, up to `size`; `ends` as in ContinuedArray.
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

  /// The point arrays: coordinates, then the arrays of the other criteria. Where refinement moves
  /// points it writes to them; tolerances stay relative to the input.
  std::vector<ContinuedArray*> GetPointArrays();

  const ContinuedArray& GetCoordinates() const { return this->Coordinates; }
  const ContinuedArray& GetAttribute() const { return this->Attribute; }

  /// The error of an edge for the criteria that do not ask for the limit. A value that is not
  /// finite gives no error and sets `hasNoValue`.
  inline double GetEdgeError(vtkIdType a, vtkIdType b, bool& hasNoValue) const;

  /// Whether two points differ but no number lies between their coordinates, so that the edge
  /// between them cannot be split.
  bool IsTooShort(vtkIdType a, vtkIdType b) const;

  /// The error of the attribute at a place on an edge: the difference between its value on the
  /// limit and the mean of the ends with these weights. It is enlarged a little, because between
  /// places it may be larger. Negative if a value is not finite.
  double GetAttributeErrorAtLimit(
    const double* const* corners, const double* weights, const double* value) const;
  /// The geometric error at a place: its distance from the edge or triangle with these two or three
  /// corners, enlarged in the same way.
  double GetGeometricError(const double* const* corners, int size, const double* place) const;
  /// The same where the distance is known, and the length of the longest edge.
  inline double GetGeometricError(double distance, double length) const;
  /**
   * The same at a place over an edge inside a surface; `opposites`: the third corners of its two
   * triangles, as far as these are known. The place must be near one of the two triangles and near
   * the planes of both. A place that is beside the edge but in these planes has no error, because
   * the surface goes on there. Where the triangles are folded over the surface ends at the edge,
   * and the distance from the edge counts.
   */
  double GetErrorOverEdge(const double* const ends[2], const double* const opposites[2],
    int triangles, const double* place) const;
  /// The signed distance of a place from the plane of three corners.
  static double GetHeight(const double* const* corners, const double* place);

  /// Whether any criterion asks for errors of edges.
  bool ReadsEdges() const { return this->Options.ReadsEdges(); }

  /// Whether there is an implicit function, and whether several threads may evaluate it.
  bool ReadsFunction() const { return this->Options.Function != nullptr; }
  bool IsFunctionForThreads() const;
  /// Whether the function is the only criterion, so that cells where it is positive need no look.
  bool ReadsFunctionOnly() const
  {
    return this->ReadsFunction() && !this->Options.ReadsEdges() && !this->Options.ReadsCells();
  }
  /// Evaluates the function at the centroids of the cells [first, last); `centroids` is memory for
  /// them.
  template <typename Cells>
  void EvaluateFunction(const Cells& cells, vtkIdType first, vtkIdType last,
    Buffer<double>& centroids, Buffer<double>& values) const;

  /// The error of cell i for the criteria on cells. `value`: of the function, or null.
  template <typename Cells, typename Points>
  double GetCellError(
    const Cells& cells, vtkIdType i, const Points& points, const double* value) const;

private:
  inline double Allow(double error, double allowed) const;
  template <typename Points>
  bool IsInRange(const Points& points, vtkIdType inputCell) const;
  void EvaluateFunction(double* centroids, vtkIdType size, double* values) const;

  const RefinementOptions& Options;
  ContinuedArray Coordinates;
  ContinuedArray Attribute;
  ContinuedArray Range;
  double AllowedJump = 0.;
  double AllowedDistance = 0.;
  double Rounding = 0.; ///< distances up to it make no angle: edges of no length would have one
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

/// The error as a multiple of the allowed one. No error gives 0, even if none is allowed.
double RefinementCriteria::Allow(double error, double allowed) const
{
  if (!(error > 0.)) // also where it is not a number
  {
    return 0.;
  }
  return allowed > 0. ? error / allowed : std::numeric_limits<double>::infinity();
}

double RefinementCriteria::GetEdgeError(vtkIdType a, vtkIdType b, bool& hasNoValue) const
{
  double worst = 0.;
  if (this->Options.ByEdgeLength)
  {
    worst = this->Allow(this->Coordinates.GetDistance(a, b, this->Options.MaximumEdgeLength),
      this->Options.MaximumEdgeLength);
  }
  if (this->Attribute.IsSet() && !this->Options.AttributeErrorOfLimit)
  {
    const double jump = this->Attribute.GetDistance(a, b, this->AllowedJump);
    hasNoValue = !std::isfinite(jump);
    worst = hasNoValue ? worst : std::max(worst, this->Allow(jump, this->AllowedJump));
  }
  return worst;
}

double RefinementCriteria::GetGeometricError(double distance, double length) const
{
  if (!std::isfinite(distance))
  {
    return 0.;
  }
  const double most = BetweenPlaces * distance;
  double error = this->Options.ByGeometricError ? this->Allow(most, this->AllowedDistance) : 0.;
  if (this->Options.ByCurvature && distance > this->Rounding)
  {
    // An arc of angle t over a chord of length c rises to c tan(t / 4) / 2.
    const double angle = 4. * vtkMath::DegreesFromRadians(std::atan2(2. * most, length));
    error = std::max(error, this->Allow(angle, this->Options.MaximumAngle));
  }
  return error;
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
  for (vtkIdType i = first; i < last; ++i)
  {
    const auto points = cells.GetPoints(i);
    const auto size = static_cast<double>(points.size());
    std::fill(centroid, centroid + 3, 0.);
    for (auto point : points)
    {
      const double* x = this->Coordinates.Get(point);
      for (int c = 0; c < 3; ++c)
      {
        // A quarter is exact, and much faster than a division.
        centroid[c] += points.size() == 4 ? 0.25 * x[c] : x[c] / size;
      }
    }
    centroid += 3;
  }
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
  // The error doubles for each level that a cell is coarser, so that coarse cells are refined
  // first.
  return wanted ? std::ldexp(1.5, std::max(this->Options.MaximumLevel - level, 0)) : 0.;
}

}

#endif
