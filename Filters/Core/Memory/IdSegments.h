// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IdSegments.h
 * The order in which a level numbers its vertices, or other parts, told by their origins on the
 * control level.
 */
#ifndef SubdivisionObjects_IdSegments_h
#define SubdivisionObjects_IdSegments_h

#include "vtkType.h"

#include <utility>
#include <vector>

namespace subdivision
{

/// Consecutive ids: first the ids that come from the first control thing of a kind, then the ids
/// from the second one, and so on.
struct IdSegment
{
  int Kind;
  vtkIdType OfEach;              ///< how many ids each thing has, if Before is empty
  std::vector<vtkIdType> Before; ///< else: how many there are before each thing, and in all

  bool IsVaried() const { return !this->Before.empty(); }
  vtkIdType CountBefore(vtkIdType thing) const
  {
    return this->IsVaried() ? this->Before[thing] : this->OfEach * thing;
  }
};

using IdSegments = std::vector<IdSegment>;

/// Appends the children of all that has ids in `parents`, each of which has the same number of
/// them: consecutive, and in the order of their parents.
inline void AppendChildren(const IdSegments& parents, vtkIdType ofEach, IdSegments& children)
{
  for (IdSegment child : parents)
  {
    child.OfEach *= ofEach;
    for (vtkIdType& before : child.Before)
    {
      before *= ofEach;
    }
    children.push_back(std::move(child));
  }
}

/// The same where numbers differ: before(i) is the number of children before the children of parent
/// i; for the last id plus 1 it is the number of all children. `sizes`: how many control things
/// there are of each kind.
template <typename Before>
void AppendVariedChildren(const IdSegments& parents, const std::vector<vtkIdType>& sizes,
  const Before& before, IdSegments& children)
{
  vtkIdType first = 0;
  for (const IdSegment& parent : parents)
  {
    const vtkIdType size = sizes[parent.Kind];
    IdSegment child{ parent.Kind, 0, std::vector<vtkIdType>(size + 1) };
    for (vtkIdType i = 0; i <= size; ++i)
    {
      child.Before[i] = before(first + parent.CountBefore(i)) - before(first);
    }
    first += parent.CountBefore(size);
    children.push_back(std::move(child));
  }
}

}

#endif
