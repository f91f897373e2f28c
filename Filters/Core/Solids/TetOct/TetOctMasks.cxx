// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TetOct/TetOctMasks.h"

#include "Core/Solids/TetOct/TetOctSplit.h"

namespace subdivision
{

namespace
{

template <LoopWeights Weights>
const RingMasks& GetMasksWith()
{
  auto vertexMask = [](Rule rule, vtkIdType size)
  {
    // The least ring of an inner vertex with d = 3 has 5 members.
    return rule == Rule::Solid && size < 5 ? MakeParted({ 1., 0. }, size)
                                           : TetOctVertexMask(rule, size, Weights);
  };
  static const RingMasks masks{ MaskTables<PartedMask>{ MaskTable<PartedMask>(vertexMask),
                                  MaskTable<PartedMask>(TetOctEdgeMask) },
    tetoct::TetVertexOwn, tetoct::TetVertexOther };
  return masks;
}

}

const RingMasks& TetOctMasks(LoopWeights weights)
{
  return weights == LoopWeights::Loop ? GetMasksWith<LoopWeights::Loop>()
                                      : GetMasksWith<LoopWeights::Warren>();
}

}
