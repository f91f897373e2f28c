// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenNormals.h
 * The normals of a state whose vertices lie on the limit.
 */
#ifndef SubdivisionObjects_RedGreenNormals_h
#define SubdivisionObjects_RedGreenNormals_h

#include "Private/Partitions/SharedNumbers.h"
#include "Private/RedGreen/RedGreenLimit.h"

#include <vector>

class vtkPointSet;

namespace subdivision
{

class OtherPartitions;

template <typename Id>
class RedGreenNormals
{
public:
  /// Finds on which side normals are: `mesh` was read from `input`, and `points` are its given
  /// coordinates. All partitions call it together; null: there are no others.
  RedGreenNormals(vtkPointSet* input, const ControlMesh& mesh, const Coordinates& points,
    const RedGreenLimit<Id>& limit, OtherPartitions* others);

  /// The normals of the vertices of an operator that was made for normals, three numbers each, from
  /// the coordinates of the control vertices.
  Buffer<double> Compute(const LocalLimit<Id>& limit, const Coordinates& control) const;

private:
  static SharedKeys MakeTriangleKeys(vtkPointSet* input, const SimplicesOfCells& cells,
    const SimplicialComplex<Id>& complex, OtherPartitions& others);

  std::vector<vtkIdType> Inverted;
  Buffer<unsigned char> Turned;
};

}

#endif
