// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Rules/Masks.h"
#include "Core/Solids/BoxSpline/BoxSplineSplit.h"

namespace subdivision
{

namespace
{

template <LoopWeights Weights>
const RingMasks& GetMasksWith()
{
  auto vertexMask = [](Rule rule, vtkIdType size)
  { return size == 0 ? Mask{ 1., 0. } : VertexMask(rule, size, Weights); };
  static const RingMasks masks{ MaskTables<Mask>{
    MaskTable<Mask>(vertexMask), MaskTable<Mask>(EdgeMask) } };
  return masks;
}

}

const RingMasks& BoxSplineMasks(LoopWeights weights)
{
  return weights == LoopWeights::Loop ? GetMasksWith<LoopWeights::Loop>()
                                      : GetMasksWith<LoopWeights::Warren>();
}

}
