// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointOperator.h
 * The one operator: whatever moves points passes its rows as blocks, and ApplyRows.h applies each
 * block to all arrays.
 *
 * A block is a view of consecutive rows. It points into the operator, or into memory of the thread
 * that made it. Rows copy, have four entries, a weight for each entry, or equal weights, also by
 * quads, or are stored as rules and rings. In the last kind the values of a ring are summed before
 * they are weighted, which takes fewer multiplications and no memory for weights.
 */
#ifndef SubdivisionObjects_PointOperator_h
#define SubdivisionObjects_PointOperator_h

#include "Core/Memory/Buffer.h"
#include "Core/Operators/RingMasks.h"

#include "vtkTypeTraits.h"

#include <algorithm>
#include <functional>
#include <variant>

namespace subdivision
{

/// Row FirstRow + i is column FirstColumn + i.
struct CopiedRows
{
  vtkIdType FirstRow;
  vtkIdType Count;
  vtkIdType FirstColumn;
};

/// Four entries. Weights beyond the last corner of a simplex are 0, and repeat the column of
/// another corner.
struct CornerRow
{
  double Weights[4] = { 0., 0., 0., 0. };
  int Columns[4] = { 0, 0, 0, 0 };

  bool IsEmpty() const
  {
    return std::all_of(this->Weights, this->Weights + 4, [](double w) { return w == 0.; });
  }
};

/// Rows of four entries, which need no offsets.
struct RowsOfFour
{
  vtkIdType FirstRow;
  vtkIdType Count;
  const CornerRow* Rows;
};

/// Row i has the entries [Offsets[i], Offsets[i + 1]).
template <typename Id>
struct WeightedRows
{
  vtkIdType FirstRow;
  vtkIdType Count;
  const Id* Offsets;
  const Id* Columns;
  const double* Weights;
  const Id* Numbers = nullptr; ///< of the rows; null: they are consecutive
  bool CopiesOnes = true;      ///< a row whose only entry has weight 1 copies
  bool SkipsZeros = false;     ///< an entry of weight 0 is not read
  /// Where the rows read and write: values of the input and the output, or values between
  /// (PointOperator::GetNumberBetween), where columns count from FirstColumn.
  bool FromBetween = false;
  bool ToBetween = false;
  vtkIdType FirstColumn = 0;
};

/// Rows of `Size` entries whose weights are the same in all of them.
template <typename Id>
struct EqualRows
{
  vtkIdType FirstRow;
  vtkIdType Count;
  int Size;
  const Id* Columns; ///< Size for each row
  const double* Weights;
};

/// The rows of the corners of quads, with the same weights in all of them: row k of each four has
/// the columns of the first one, begun at the k-th, in a circle. Count is a multiple of four.
template <typename Id>
struct QuadRows
{
  vtkIdType FirstRow;
  vtkIdType Count;
  const Id* Columns; ///< four at the beginning of 16 for each quad
  const double* Weights;

  Id GetColumn(vtkIdType row, int k) const { return this->Columns[row / 4 * 16 + (row + k) % 4]; }
};

/// Rows without weights, all of vertices, of edges, or of centres. The weights follow from the rule
/// and the size of the ring.
template <typename Id>
struct RingRows
{
  const RingMasks* Masks;
  bool OfEdges;
  vtkIdType FirstRow; ///< number of the first row
  vtkIdType Count;
  const Stratum* Strata;
  const Id* Ends;    ///< 2 for each edge
  const Id* Offsets; ///< ring i is Members[Offsets[i] .. Offsets[i + 1])
  const Id* Members;
  /// If true, each row is the mean of six members, and Strata and Offsets are null.
  bool OfCentres = false;
  /// For rows of vertices: where d = 3, the weights of the first NumberOfCounted rows are in
  /// proportion to Counts, which has a number for each member.
  vtkIdType NumberOfCounted = 0;
  const Id* Counts = nullptr;
  const Id* Columns = nullptr; ///< of the vertices of rows; null: the numbers of the rows
  vtkIdType RowsBefore = 0;    ///< such a column minus the number of its row

  static constexpr int CentreSize = 6;

  /// The column of the vertex of a row.
  vtkIdType GetColumn(vtkIdType i) const
  {
    return this->Columns ? static_cast<vtkIdType>(this->Columns[i])
                         : this->RowsBefore + this->FirstRow + i;
  }

  Row<Id> GetRing(vtkIdType i) const
  {
    return this->OfCentres
      ? Row<Id>{ this->Members + CentreSize * i, this->Members + CentreSize * (i + 1) }
      : Row<Id>{ this->Members + this->Offsets[i], this->Members + this->Offsets[i + 1] };
  }
  bool HasCounts(vtkIdType i) const
  {
    return i < this->NumberOfCounted && this->Strata[i].GetRule() == Rule::Solid;
  }
};

using RowsView =
  std::variant<CopiedRows, RowsOfFour, WeightedRows<int>, WeightedRows<long long>, EqualRows<int>,
    EqualRows<long long>, QuadRows<int>, QuadRows<long long>, RingRows<int>, RingRows<long long>>;

/// out = S in, for interleaved values per column. Each row is summed in double, in the order of its
/// entries, and stored in the type of the array; integers are rounded.
class PointOperator
{
public:
  virtual ~PointOperator() = default;

  virtual vtkIdType GetNumberOfColumns() const = 0;
  virtual vtkIdType GetNumberOfRows() const = 0;
  /// An operator of several stages has this many values between the input and the output, for each
  /// array. They are in double.
  virtual vtkIdType GetNumberBetween() const { return 0; }

  /// Receives a block. ForEachBlock passes each row at least once, in any order and from several
  /// threads. It passes a row that reads a value between, or that replaces an earlier row, only
  /// after the call for the earlier row has returned.
  using User = std::function<void(const RowsView&)>;
  virtual void ForEachBlock(const User& use) const = 0;

  template <typename T>
  void Apply(const T* in, T* out, int components) const
  {
    const int type = vtkTypeTraits<T>::VTKTypeID();
    this->ApplyTo(in, type, out, type, components);
  }
  /// The same for values in double that are stored in single precision.
  void Apply(const double* in, float* out, int components) const
  {
    this->ApplyTo(in, VTK_DOUBLE, out, VTK_FLOAT, components);
  }

protected:
  PointOperator() = default;
  PointOperator(const PointOperator&) = default;
  PointOperator& operator=(const PointOperator&) = default;

private:
  /// Types are numbers of VTK (ApplyRows.h).
  void ApplyTo(const void* in, int inType, void* out, int outType, int components) const;
};

/// An operator whose rows are stored as rules and rings, or made from another level.
template <typename Id>
class RingOperator : public PointOperator
{
public:
  using RingsUser = std::function<void(const RingRows<Id>&)>;
  /// As ForEachBlock, for the rows that have rings.
  virtual void ForRows(const RingsUser& use) const = 0;
  void ForEachBlock(const User& use) const override
  {
    this->ForRows([&use](const RingRows<Id>& rows) { use(rows); });
  }
};

}

#endif
