// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Linear/LinearScheme.h"

#include "Core/Solids/Scheme/ChildRowsMaker.h"

namespace subdivision
{

const RingMasks& LinearMasks()
{
  static const RingMasks masks{ MaskTables<Mask>{
    MaskTable<Mask>([](Rule, vtkIdType) { return Mask{ 1., 0. }; }),
    MaskTable<Mask>([](Rule, vtkIdType) { return Mask{ 1. / 2., 0. }; }) } };
  return masks;
}

template class ChildRows<LinearSplit<int>>;
template class ChildRows<LinearSplit<long long>>;

}
