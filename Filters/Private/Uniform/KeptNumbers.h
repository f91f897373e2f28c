// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KeptNumbers.h
 * Numbers the points and cells of a part of an output of KeepCellTypes as the whole output numbers
 * them.
 */
#ifndef SubdivisionObjects_KeptNumbers_h
#define SubdivisionObjects_KeptNumbers_h

#include "Core/Solids/RedCells/RedCells.h"
#include "Private/Control/Partners.h"
#include "Private/Control/SharedNumbers.h"

#include <vector>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

/**
 * All partitions make the same calls. A new point is known by the numbers of the corners whose mean
 * it is, in hexahedra by the input cell and the hexahedron of it: two exchanges for input points
 * and cells each, and six for each step.
 */
class KeptNumbers
{
public:
  KeptNumbers(vtkPointSet* input, Partners& partners);

  /// Numbers the points of a step; `before`: the cells before it, `sources`: their input cells.
  void Add(const RedStep& step, const ShapedCells& before, const std::vector<vtkIdType>& sources);
  /// Adds the numbers as arrays to the output; `sources`: the input cells of its cells. Points and
  /// cells far from own ones get -1.
  void Write(const std::vector<vtkIdType>& sources, vtkUnstructuredGrid* output) const;

private:
  using Ids = std::vector<vtkIdType>;

  void AddMeans(const RedStep& step, vtkIdType first, vtkIdType last, int corners,
    const std::vector<char>& own);
  void AddCentres(const ShapedCells& before, const Ids& sources);
  void Take(const SharedNumbers& numbers);

  Partners& With;
  Ids Places;          ///< of the input cells in the whole
  Ids Points;          ///< numbers of the points so far
  vtkIdType Total = 0; ///< of points in the whole
};

}

#endif
