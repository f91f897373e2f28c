// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointOrder.h
 * The order of points that decides every tie: by global id, or by index where there are none.
 */
#ifndef SubdivisionObjects_PointOrder_h
#define SubdivisionObjects_PointOrder_h

#include "vtkType.h"

namespace subdivision
{

struct PointOrder
{
  /// May be null: then the index is the global id.
  const vtkIdType* GlobalIds = nullptr;

  bool operator()(vtkIdType a, vtkIdType b) const
  {
    if (this->GlobalIds && this->GlobalIds[a] != this->GlobalIds[b])
    {
      return this->GlobalIds[a] < this->GlobalIds[b];
    }
    return a < b; // global ids that are not unique must not make the result random
  }
};

}

#endif
