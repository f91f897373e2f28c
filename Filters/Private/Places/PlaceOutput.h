// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceOutput.h
 * Places at which the limit is asked for, and arrays of the answer besides the arrays of the mesh:
 * derivatives, normals and curvatures.
 */
#ifndef SubdivisionObjects_PlaceOutput_h
#define SubdivisionObjects_PlaceOutput_h

#include "Core/Memory/GrowingBuffer.h"
#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/PlaceParts.h"
#include "Core/Operators/SparseRows.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkDoubleArray;
class vtkIdTypeArray;
class vtkPolyData;

namespace subdivision
{

struct RunOptions;

/// Places at which the limit is asked for, in cells of the input, and the mesh that gets it.
struct PlaceRequest
{
  vtkIdTypeArray* Cells = nullptr;
  vtkDataArray* Parameters = nullptr; ///< three components
  vtkPolyData* Output = nullptr;
  /// If not null, places are the ones nearest to its points, and the arrays above are not read.
  vtkDataSet* Targets = nullptr;
  bool HasDerivatives = true; ///< whether there are arrays of derivatives, normals and curvatures
  /// If not null, gets the rows of values over the control points and, in solids with
  /// HasDerivatives, of the three first derivatives.
  std::array<SparseRows<vtkIdType>, 4>* Rows = nullptr;

  PlaceDerivatives GetDerivatives() const
  {
    return this->HasDerivatives ? PlaceDerivatives::Second : PlaceDerivatives::None;
  }
};

/// The error message if not each place has one cell and three parameters; else empty.
std::string CheckPlaceArrays(vtkIdTypeArray* cells, vtkDataArray* parameters);

/// The value and the derivatives of the points at a place.
using PlacePoint = std::array<std::array<double, 3>, PlaceParts::Count>;

template <typename Id>
PlacePoint SumParts(const PlaceRows<Id>& rows, vtkIdType place, const double* points)
{
  PlacePoint parts{};
  for (int p = 0; p < PlaceParts::Count; ++p)
  {
    if (rows.HasPart(p))
    {
      WeightedRows<Id> row = rows.GetRows(p, place, place + 1);
      row.FirstRow = 0;
      SumRows(row, points, parts[p].data(), 3);
    }
  }
  return parts;
}

/// A point array of zeros.
vtkDoubleArray* AddPlaceArray(
  const char* name, int components, vtkIdType size, vtkPolyData* output);

/// Derivatives of the points, normals and curvatures, as arrays of an output.
class DerivativeArrays
{
public:
  DerivativeArrays(vtkIdType size, vtkPolyData* output);
  /// `dimension`: of the cell with place i.
  void Set(vtkIdType i, int dimension, const PlacePoint& parts);

private:
  std::array<double*, 3> Tangents{};
  double* Normals = nullptr;
  double* Mean = nullptr;
  double* Gaussian = nullptr;
};

/// Rows of some places after rows of others. Together they may have more entries than an int
/// counts.
class AppendedRows
{
public:
  /// The rows of one of PlaceParts; zeros, if it is not there.
  template <typename Id>
  void Append(const PlaceRows<Id>& part, int which = PlaceParts::Value)
  {
    this->NumberOfColumns = part.NumberOfColumns;
    const vtkIdType rows = part.GetNumberOfPlaces();
    const vtkIdType before = this->Columns.size();
    const vtkIdType entries = part.Columns.size();
    std::transform(part.Offsets.begin(), part.Offsets.begin() + rows, this->Offsets.Extend(rows),
      [&](Id offset) { return before + offset; });
    std::copy_n(part.Columns.begin(), entries, this->Columns.Extend(entries));
    double* weights = this->Weights.Extend(entries);
    part.HasPart(which) ? std::copy_n(part.Weights[which].begin(), entries, weights)
                        : std::fill_n(weights, entries, 0.);
  }
  SparseRows<vtkIdType> Finish();

private:
  vtkIdType NumberOfColumns = 0;
  GrowingBuffer<vtkIdType> Offsets;
  GrowingBuffer<vtkIdType> Columns;
  GrowingBuffer<double> Weights;
};

/// Warns of places that are missing because their `what` are not finite, which is a noun.
void WarnOfMissingPlaces(
  const std::vector<vtkIdType>& missing, const char* what, const RunOptions& options);

/// Gives an output with points one vertex for each, all point arrays of another, and the arrays of
/// the places; null: they have none. Places that are missing get points and values that are not a
/// number, or 0 where these are integers.
void FinishPlaces(const std::vector<vtkIdType>& missing, vtkPolyData* arrays, vtkDataSet* places,
  vtkPolyData* output);

}

#endif
