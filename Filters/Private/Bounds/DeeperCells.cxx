// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/DeeperCells.h"

#include "Core/Memory/Loops.h"

#include <algorithm>

namespace subdivision
{

Buffer<double> DeeperCells::Take(int step, const Buffer<double>& values, int components) const
{
  const vtkIdType size = this->Get().Pieces.GetNumberOfPoints(step);
  Buffer<double> taken(components * size);
  ForEach(size,
    [&](vtkIdType i)
    {
      std::copy_n(
        values.data() + components * this->Old[i], components, taken.data() + components * i);
    });
  return taken;
}

}
