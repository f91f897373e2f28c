// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Rules/Masks.h"
#include "Core/Solids/BoxSpline/BoxSplineSplit.h"

namespace subdivision
{

const RingMasks& BoxSplineMasks()
{
  auto vertexMask = [](Rule rule, vtkIdType size)
  { return size == 0 ? Mask{ 1., 0. } : VertexMask(rule, size); };
  static const RingMasks masks{ MaskTables<Mask>{
    MaskTable<Mask>(vertexMask), MaskTable<Mask>(EdgeMask) } };
  return masks;
}

}
