// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingMasks.h
 * The masks of a scheme whose rows are stored as rules and rings, in tables, so that applying a row
 * divides nothing.
 */
#ifndef SubdivisionObjects_RingMasks_h
#define SubdivisionObjects_RingMasks_h

#include "Core/Rules/Mask.h"
#include "Core/Rules/Rule.h"
#include "Core/Rules/Stratum.h"

#include <variant>

namespace subdivision
{

/// The masks of vertices, or of edges, by rule and size of the ring. MaskType is Mask for rings of
/// one section, and PartedMask for others.
template <typename MaskType>
class MaskTable
{
public:
  using Compute = MaskType (*)(Rule, vtkIdType);

  explicit MaskTable(Compute compute)
    : ComputeMask(compute)
  {
    for (int rule = 0; rule < Rules; ++rule)
    {
      for (vtkIdType size = 0; size < Sizes; ++size)
      {
        this->Masks[rule][size] = compute(static_cast<Rule>(rule), size);
      }
    }
  }

  /// `scratch` has room for a mask that is not in the table.
  const MaskType& Get(Rule rule, vtkIdType ringSize, MaskType& scratch) const
  {
    if (ringSize < Sizes)
    {
      return this->Masks[static_cast<int>(rule)][ringSize];
    }
    scratch = this->ComputeMask(rule, ringSize);
    return scratch;
  }

private:
  static constexpr int Rules = 6;
  static constexpr vtkIdType Sizes = 64;
  Compute ComputeMask;
  MaskType Masks[Rules][Sizes];
};

template <typename MaskType>
struct MaskTables
{
  MaskTable<MaskType> Vertices;
  MaskTable<MaskType> Edges;
};

struct RingMasks
{
  /// Masks of one section have tables of their own, because their rows are summed in fewer steps.
  std::variant<MaskTables<Mask>, MaskTables<PartedMask>> Tables;
  /// Of a vertex with counts (RingRows): its own weight, and the weight of a member per count,
  /// before it is divided by a third of the sum of all counts. Only PartedMasks come with counts.
  double CountedOwn = 0.;
  double CountedOther = 0.;
};

/// The mask of a row, whichever table has it. For where speed does not matter.
inline PartedMask GetMask(const RingMasks& masks, bool ofEdge, Rule rule, vtkIdType ringSize)
{
  if (const auto* plain = std::get_if<MaskTables<Mask>>(&masks.Tables))
  {
    Mask scratch;
    return MakeParted(
      (ofEdge ? plain->Edges : plain->Vertices).Get(rule, ringSize, scratch), ringSize);
  }
  const auto& parted = std::get<MaskTables<PartedMask>>(masks.Tables);
  PartedMask scratch;
  return (ofEdge ? parted.Edges : parted.Vertices).Get(rule, ringSize, scratch);
}

}

#endif
