// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenNormals.h
 * The normals of a state whose vertices lie on the limit.
 */
#ifndef SubdivisionObjects_RedGreenNormals_h
#define SubdivisionObjects_RedGreenNormals_h

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/Partitions/SharedNumbers.h"
#include "Private/Partitions/SharedSides.h"
#include "Private/Reading/SolidOrientation.h"
#include "Private/RedGreen/RedGreenLimit.h"

#include "vtkPointSet.h"

#include <algorithm>
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
    const RedGreenLimit<Id>& limit, OtherPartitions* others)
  {
    SimplicesOfCells cells = mesh.Cells;
    cells.TakeIds(); // the ids may still be those of the input's cells
    this->Inverted =
      mesh.MadeLevels > 0 ? mesh.Inverted : FindInvertedTets(cells.Simplices, points);
    limit.WithControl(
      [&](const auto& control)
      {
        const FaceSides sides = FindTriangleSides(control, FindSureVertices(cells, others));
        this->Turned = TakeParents(others
            ? JoinSides(sides, MakeTriangleKeys(input, cells, control.Complex, *others), *others)
            : sides.ListTurned(),
          mesh.MadeLevels);
      });
  }
  /// The normals of the vertices of an operator that was made for normals, three numbers each, from
  /// the coordinates of the control vertices.
  Buffer<double> Compute(const LocalLimit<Id>& limit, const Coordinates& control) const
  {
    Buffer<double> normals(3 * limit.GetNumberOfRows());
    limit.ComputeNormals(control, this->Inverted, this->Turned, normals.data());
    return normals;
  }

private:
  /// Triangles are known by the cell of which they are a part: their order is the order of the
  /// whole mesh. The complex has triangles of equal vertices once, in the place of the first.
  static SharedKeys MakeTriangleKeys(vtkPointSet* input, const SimplicesOfCells& cells,
    const SimplicialComplex<Id>& complex, OtherPartitions& others)
  {
    const SharedKeys pieces = MakeKeysOfPieces(cells, PlaceCells(input, others), others);
    SharedKeys keys;
    keys.Width = pieces.Width;
    auto key = pieces.Keys.begin();
    const auto* vertices = cells.Simplices.Connectivity.data();
    const Id* face = complex.FaceVertices.data();
    for (const int dimension : InTurn(cells.Simplices.Dimensions))
    {
      if (dimension == 2 &&
        keys.Own.size() < static_cast<std::size_t>(complex.NumberOfTriangleCells) &&
        std::is_permutation(face, face + 3, vertices))
      {
        keys.Keys.insert(keys.Keys.end(), key, key + pieces.Width);
        keys.Own.push_back(1);
        face += 3;
      }
      key += pieces.Width;
      vertices += dimension + 1;
    }
    return keys;
  }

  std::vector<vtkIdType> Inverted;
  Buffer<unsigned char> Turned;
};

}

#endif
