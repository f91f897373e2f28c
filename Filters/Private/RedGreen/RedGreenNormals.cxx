// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenNormals.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/Control/SharedSides.h"
#include "Private/Reading/SolidOrientation.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <map>

namespace subdivision
{

template <typename Id>
RedGreenNormals<Id>::RedGreenNormals(vtkPointSet* input, const ControlMesh& mesh,
  const Coordinates& points, const RedGreenLimit<Id>& limit, Partners* others)
{
  SimplicesOfCells cells = mesh.Cells;
  cells.TakeIds(); // the ids may still be those of the input's cells
  this->Inverted = mesh.MadeLevels > 0 ? mesh.Inverted : FindInvertedTets(cells.Simplices, points);
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

/// Triangles are known by the cell of which they are a part: their order is that of the whole mesh.
template <typename Id>
SharedKeys RedGreenNormals<Id>::MakeTriangleKeys(vtkPointSet* input, const SimplicesOfCells& cells,
  const SimplicialComplex<Id>& complex, Partners& others)
{
  std::vector<vtkIdType> parents = cells.ParentCells;
  for (vtkIdType s = 0; cells.ParentCells.empty() && s < cells.Simplices.GetNumberOfSimplices();
    ++s)
  {
    parents.push_back(s);
  }
  const SharedKeys pieces = MakeKeysOfPieces(parents, PlaceCells(input, others), others);
  std::map<std::array<Id, 3>, std::size_t> simplices; // the first one with these vertices
  auto sorted = [](const auto* vertices)
  {
    std::array<Id, 3> triangle;
    std::copy_n(vertices, 3, triangle.begin());
    std::sort(triangle.begin(), triangle.end());
    return triangle;
  };
  const auto* vertices = cells.Simplices.Connectivity.data();
  for (const std::size_t s : InTurn(cells.Simplices.Dimensions.size()))
  {
    if (cells.Simplices.Dimensions[s] == 2)
    {
      simplices.emplace(sorted(vertices), s);
    }
    vertices += cells.Simplices.Dimensions[s] + 1;
  }
  SharedKeys keys;
  keys.Width = pieces.Width;
  for (const vtkIdType face : InTurn(complex.NumberOfTriangleCells))
  {
    const std::size_t simplex = simplices.at(sorted(complex.FaceVertices.data() + 3 * face));
    const auto key = pieces.Keys.begin() + static_cast<std::ptrdiff_t>(simplex * keys.Width);
    keys.Keys.insert(keys.Keys.end(), key, key + keys.Width);
    keys.Own.push_back(1);
  }
  return keys;
}

template <typename Id>
Buffer<double> RedGreenNormals<Id>::Compute(
  const LocalLimit<Id>& limit, const Coordinates& control) const
{
  Buffer<double> normals(3 * limit.GetNumberOfRows());
  limit.ComputeNormals(control, this->Inverted, this->Turned, normals.data());
  return normals;
}

SUBDIVISION_COMPILE(class RedGreenNormals);

}
