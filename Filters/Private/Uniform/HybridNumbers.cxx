// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridNumbers.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/Partitions/OtherPartitions.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
void NumberNewPoints(const CellComplex<Id>& complex, const std::vector<vtkIdType>& sources,
  const std::vector<vtkIdType>& places, OtherPartitions& others, WholeIds& points)
{
  const vtkIdType old = complex.NumberOfVertices;
  std::vector<char> own(static_cast<std::size_t>(complex.GetNumberOfNewPoints()), 0);
  for (const vtkIdType c : InTurn(complex.Cells.GetNumberOfCells()))
  {
    if (others.IsOwn(sources[static_cast<std::size_t>(c)]))
    {
      for (const Id edge : complex.CellEdges[c])
      {
        own[static_cast<std::size_t>(old + edge)] = 1;
      }
      for (const Id face : complex.CellFaces[c])
      {
        if (face < complex.NumberOfQuads)
        {
          own[static_cast<std::size_t>(old + complex.NumberOfEdges + face)] = 1;
        }
      }
    }
  }
  const auto add = [&](int size, vtkIdType first, vtkIdType count, const auto& corners)
  {
    SharedKeys means;
    means.Width = size == 4 ? 5 : size;
    std::vector<vtkIdType> key(static_cast<std::size_t>(means.Width));
    for (const vtkIdType i : InTurn(count))
    {
      const Id* begin = corners(i);
      std::transform(begin, begin + size, key.begin(),
        [&points](Id point) { return points.Ids[static_cast<std::size_t>(point)]; });
      if (size == 4) // quads with the same corners in another order differ in the opposite one
      {
        key[4] = key[static_cast<std::size_t>(
          (std::min_element(key.begin(), key.begin() + 4) - key.begin() + 2) % 4)];
      }
      std::sort(key.begin(), key.begin() + size);
      means.Own.push_back(own[static_cast<std::size_t>(first + i)] && key[0] >= 0);
      std::replace(key.begin(), key.end(), vtkIdType(-1), vtkIdType(0));
      means.Keys.insert(means.Keys.end(), key.begin(), key.end());
    }
    points.Add(means, others);
  };
  add(2, old, complex.NumberOfEdges,
    [&](vtkIdType e) { return complex.EdgeVertices.data() + 2 * e; });
  add(4, old + complex.NumberOfEdges, complex.NumberOfQuads,
    [&](vtkIdType q) { return complex.FaceVertices.data() + 4 * q; });
  std::vector<vtkIdType> centres;
  for (const Id cell : complex.CentreCells)
  {
    centres.push_back(sources[static_cast<std::size_t>(cell)]);
  }
  points.Add(MakeKeysOfPieces(centres, places, others), others);
}

SUBDIVISION_COMPILE_FUNCTION(NumberNewPoints);

}
