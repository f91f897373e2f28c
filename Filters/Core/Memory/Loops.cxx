// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Memory/Loops.h"

#include "vtkSMPTools.h"

namespace subdivision
{

void ForRanges(vtkIdType size, RangeBody body)
{
  if (size <= WorthThreads)
  {
    body(0, size);
    return;
  }
  vtkSMPTools::For(0, size, body);
}

void ForRangesOfBlocks(vtkIdType blocks, RangeBody body, vtkIdType worthThreads)
{
  if (blocks < worthThreads)
  {
    body(0, blocks);
    return;
  }
  vtkSMPTools::For(0, blocks, 1, body);
}

}
