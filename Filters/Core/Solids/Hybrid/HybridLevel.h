// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridLevel.h
 * A level of the scheme in which every cell keeps its type, and the operator of its step
 * (Mathematics 15).
 */
#ifndef SubdivisionObjects_HybridLevel_h
#define SubdivisionObjects_HybridLevel_h

#include "Core/Operators/PointOperator.h"
#include "Core/Operators/RowBlock.h"
#include "Core/Solids/Hybrid/HybridStrata.h"

#include <functional>

namespace subdivision
{

template <typename Id>
struct HybridLevel
{
  CellComplex<Id> Complex;
  HybridStrata<Id> Strata;
  HybridSharpness<Id> Sharpness;
};

/// Whether points move, or the split is linear: then no strata are read.
enum class HybridRules : unsigned char
{
  Smooth,
  Linear
};

/// The operator of the step of a level, which must outlive it. It makes its rows when they are
/// used.
template <typename Id>
class HybridRows : public PointOperator
{
public:
  HybridRows(const HybridLevel<Id>& level, HybridRules rules);

  vtkIdType GetNumberOfColumns() const override { return this->Level.Complex.NumberOfVertices; }
  vtkIdType GetNumberOfRows() const override { return this->Level.Complex.GetNumberOfNewPoints(); }
  void ForEachBlock(const User& use) const override;

  /// Appends a row to a block. For one thread.
  using AddRow = std::function<void(vtkIdType row, RowBlock<Id>& block)>;
  /// Makes rows one by one, as long as this lives.
  AddRow StartRows() const;

  /// The vertex whose values a new point takes in arrays that are not smoothed: of the corners of
  /// its edge, quad or solid the one for which isEarlier(vertex, other) is true for all others.
  template <typename IsEarlier>
  vtkIdType FindOrigin(vtkIdType row, const IsEarlier& isEarlier) const
  {
    const Row<Id> corners = this->GetCorners(row);
    return corners.size() == 0
      ? row
      : static_cast<vtkIdType>(*std::min_element(corners.begin(), corners.end(), isEarlier));
  }

private:
  /// The corners of the edge, quad or solid of a new point; none for an old one.
  Row<Id> GetCorners(vtkIdType row) const;
  /// The first blend that is not before a row.
  std::vector<SharpRow>::const_iterator FindBlend(vtkIdType row) const
  {
    return std::lower_bound(this->Blends.begin(), this->Blends.end(), row,
      [](const SharpRow& blend, vtkIdType wanted) { return blend.Row < wanted; });
  }

  const HybridLevel<Id>& Level;
  HybridRules Rules;
  Buffer<unsigned char> AreRelaxed;      ///< edges whose w is not 1; empty: none
  std::vector<SharpRow> Blends;          ///< of semi-sharp edges and faces, ascending
  Buffer<unsigned char> AreSharpRelaxed; ///< by the strata of their first stage
};

/// The level after a step.
template <typename Id>
HybridLevel<Id> RefineHybrid(const HybridLevel<Id>& level, HybridRules rules);

}

#endif
