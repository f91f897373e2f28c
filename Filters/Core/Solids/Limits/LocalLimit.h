// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalLimit.h
 * Limits of vertices of the uniform refinement of a level, without the uniform refinement: of
 * each step only a neighbourhood of what is asked for is made.
 *
 * A vertex is named by the edge whose point it is, an edge by its two ends: so vertices need
 * neither their level nor their number in the uniform refinement, which would overflow on deep
 * levels. Step by step, the level is restricted to the cells around those that hold vertices of
 * later steps (Restriction.h), and the part is refined like any level, with the same rules and
 * rings. The limit of a vertex is that of the level on which it first exists (LimitStencils.h).
 * Which rows are needed is then followed back from the limits to the control level, and no other is
 * kept; each of them is whole, or the part is made larger.
 */
#ifndef SubdivisionObjects_LocalLimit_h
#define SubdivisionObjects_LocalLimit_h

#include "Core/Memory/Store.h"
#include "Core/Solids/Limits/LimitStencils.h"

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace subdivision
{

template <typename Id>
class LocalLimit
{
public:
  /**
   * Vertices 0 to V - 1 are those of `control` (made with Depth::ForRefinement, or the input),
   * which has V; vertex V + i is the point of the edge between the vertices `midpoints[i]`, both
   * smaller than V + i, which must be an edge of the uniform refinement (RedGreen::GetEnds). The
   * same edge may be named again. Throws std::invalid_argument for an edge that does not exist.
   * `wanted`: a flag for each vertex whose limit is asked for; empty: all. Nothing is computed for
   * the others, and Apply leaves them as they are. `rings`: how many rings of neighbours are tried
   * first around what holds later vertices.
   */
  LocalLimit(const Level<Id>& control, const SemiSharpStages<Id>& creases,
    const std::vector<std::array<Id, 2>>& midpoints,
    const Buffer<unsigned char>& wanted = Buffer<unsigned char>(), int rings = 1);

  /// Control vertices, then midpoints.
  vtkIdType GetNumberOfRows() const { return this->NumberOfRows; }
  vtkIdType GetNumberOfColumns() const { return this->NumberOfColumns; }

  /// out = limits of all vertices, from values at the control vertices, of type T; what is between
  /// is in double.
  template <typename T>
  void Apply(const T* in, T* out, int components) const;

  /// The same as one operator. A row has as many entries as control vertices have an influence.
  SparseRows<Id> BuildRows() const;

  /// How many values are computed on the way, on all levels: the work of an Apply.
  vtkIdType GetNumberOfSupportValues() const;

private:
  /// One step and the limits of what is new on its level.
  struct Step
  {
    SparseRows<Id> Rows;   ///< from the values of the step before; the first step's copy
    SparseRows<Id> Limits; ///< from this step's values
    std::vector<Id> Vertices;
  };
  class Builder;
  void ApplyInDouble(const double* in, double* out, int components) const;

  vtkIdType NumberOfRows = 0;
  vtkIdType NumberOfColumns = 0;
  std::vector<Step> Steps;
};

/// How far the middle of a chord is from the curve or surface at the limit: the geometric error of
/// an edge whose ends have the limits a and b and whose point has the limit m.
inline double GetChordError(const double a[3], const double b[3], const double m[3])
{
  return std::hypot(
    m[0] - 0.5 * (a[0] + b[0]), m[1] - 0.5 * (a[1] + b[1]), m[2] - 0.5 * (a[2] + b[2]));
}

template <typename Id>
template <typename T>
void LocalLimit<Id>::Apply(const T* in, T* out, int components) const
{
  if constexpr (std::is_same<T, double>::value)
  {
    this->ApplyInDouble(in, out, components);
  }
  else
  {
    Buffer<double> values(this->NumberOfColumns * components);
    ForEach(values.size(), [&](vtkIdType i) { values[i] = static_cast<double>(in[i]); });
    Buffer<double> limits(this->NumberOfRows * components);
    this->ApplyInDouble(values.data(), limits.data(), components);
    ForEach(limits.size(), [&](vtkIdType i) { out[i] = Store<T>(limits[i]); });
  }
}

extern template class LocalLimit<int>;
extern template class LocalLimit<long long>;

}

#endif
