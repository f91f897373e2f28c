// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedValues.h
 * Values of points that several partitions of a mesh have, where not each of them can compute all.
 */
#ifndef SubdivisionObjects_SharedValues_h
#define SubdivisionObjects_SharedValues_h

#include "Private/Partitions/SharedDirectory.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/**
 * Each partition computes the values of its own things right, and takes the values of all others
 * from their owners: the first partition that has the thing as own.
 *
 * All partitions make this, and call its functions, together. A directory finds the owners: three
 * exchanges, 8 Width + 32 bytes for each thing. TakeOthers is one exchange.
 */
class SharedValues
{
public:
  SharedValues(const SharedKeys& things, Exchange& exchange);
  /// `owners`: of each thing its owner, and which of the owner's things it is; -1 twice: its value
  /// stays. One exchange.
  SharedValues(const std::vector<vtkIdType>& owners, Exchange& exchange);

  /// Replaces the values of things that are not own, `components` numbers for each thing. Values
  /// that no partition has as own stay.
  template <typename T>
  void TakeOthers(T* values, int components)
  {
    const auto size = static_cast<std::size_t>(components);
    Exchange::Lists<T> lists;
    for (const auto& [to, things] : this->Out)
    {
      std::vector<T>& list = lists[to];
      list.reserve(size * things.size());
      for (const vtkIdType thing : things)
      {
        list.insert(list.end(), values + size * thing, values + size * (thing + 1));
      }
    }
    this->With.SendLists(lists);
    for (const auto& [from, things] : this->In)
    {
      auto next = lists.at(from).begin();
      for (const vtkIdType thing : things)
      {
        std::copy_n(next, size, values + size * thing);
        next += static_cast<std::ptrdiff_t>(size);
      }
    }
  }

private:
  using Things = Exchange::Lists<vtkIdType>; ///< for each partition, in a common order

  Exchange& With;
  Things Out;
  Things In;
};

}

#endif
