// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedValues.h
 * Values of points that several partitions of a mesh have, where not each of them can compute all.
 */
#ifndef SubdivisionObjects_SharedValues_h
#define SubdivisionObjects_SharedValues_h

#include "Private/Partitions/SharedDirectory.h"

#include <map>

namespace subdivision
{

/**
 * Each partition computes the values of its own things right, and takes the values of all others
 * from the first partition that has them as own.
 *
 * All partitions make this, and call its functions, together. A directory finds the owners: three
 * exchanges, 8 Width + 40 bytes for each thing. TakeOthers is one exchange.
 */
class SharedValues
{
public:
  SharedValues(const SharedKeys& things, Partners& partners);

  /// Replaces the values of things that are not own, `components` numbers for each thing. Values
  /// that no partition has as own stay.
  void TakeOthers(double* values, int components);

private:
  using Things = std::map<int, std::vector<vtkIdType>>; ///< for each partition, in a common order

  Partners& With;
  Things Out;
  Things In;
};

}

#endif
