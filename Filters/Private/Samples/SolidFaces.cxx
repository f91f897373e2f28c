// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/SolidFaces.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Memory/TupleIndex.h"
#include "Private/Arrays/Arrays.h"

#include "vtkDataArray.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>

namespace subdivision
{
namespace
{

/// The corners of the faces of a tetrahedron, and the middles of 01, 02 and 12 of each.
constexpr int NodesOfFaces[4][6] = { { 0, 1, 2, 4, 5, 6 }, { 0, 1, 3, 4, 7, 8 },
  { 0, 2, 3, 5, 7, 9 }, { 1, 2, 3, 6, 8, 9 } };

void AddFaces(const std::vector<SampledMesh>& meshes, std::size_t mesh, bool betweenMaterials,
  std::vector<SolidFace>& faces)
{
  const SampledMesh& of = meshes[mesh];
  const auto& solids = of.Pieces.Pieces[3];
  Buffer<std::array<vtkIdType, 3>> corners(4 * static_cast<vtkIdType>(solids.size()));
  ForEach(corners.size(),
    [&](vtkIdType f)
    {
      const auto& nodes = solids[f / 4].Nodes;
      const auto& face = NodesOfFaces[f % 4];
      const vtkIdType ids[3] = { nodes[face[0]], nodes[face[1]], nodes[face[2]] };
      corners[f] = SortedTuple<3>(ids);
    });
  const auto numbers = NumberTuples<3, vtkIdType>(corners, of.Mesh->GetNumberOfPoints(), 0);
  // What is known of a face: nothing, the first tetrahedron, or that it is between two alike.
  std::vector<vtkIdType> first(numbers.Representatives.size(), -1);
  std::vector<char> isInside(first.size(), 0);
  const auto material = [&](vtkIdType f)
  {
    return betweenMaterials && of.Material ? of.Material->GetComponent(solids[f / 4].Cell, 0) : 0.;
  };
  for (const vtkIdType f : InTurn(corners.size()))
  {
    const vtkIdType number = numbers.Numbers[f];
    isInside[number] = first[number] >= 0 && material(first[number]) == material(f);
    first[number] = f;
  }
  for (const vtkIdType number : InTurn(static_cast<vtkIdType>(first.size())))
  {
    if (!isInside[number] && first[number] >= 0)
    {
      const vtkIdType f = first[number];
      SolidFace face{ mesh, { {}, solids[f / 4].Cell } };
      for (int n = 0; n < 6; ++n)
      {
        face.Triangle.Nodes[n] = solids[f / 4].Nodes[NodesOfFaces[f % 4][n]];
      }
      faces.push_back(face);
    }
  }
}

/// Where the middle of the corners is. Blocks, ranks and copies of points have the same bits.
Place FindMiddle(const std::vector<SampledMesh>& meshes, const SolidFace& face)
{
  std::array<Place, 3> corners{};
  for (int c = 0; c < 3; ++c)
  {
    meshes[face.Mesh].Mesh->GetPoint(face.Triangle.Nodes[c], corners[c].data());
  }
  std::sort(corners.begin(), corners.end()); // the order of a sum makes other bits
  Place middle{};
  for (int x = 0; x < 3; ++x)
  {
    middle[x] = (corners[0][x] + corners[1][x] + corners[2][x]) / 3.;
  }
  return middle;
}

}

std::vector<SolidFace> ListFaces(const std::vector<SampledMesh>& meshes, bool betweenMaterials)
{
  std::vector<SolidFace> faces;
  for (std::size_t m = 0; m < meshes.size(); ++m)
  {
    AddFaces(meshes, m, betweenMaterials, faces);
  }
  return faces;
}

void DropCommonFaces(const std::vector<SampledMesh>& meshes, vtkMultiProcessController* controller,
  std::vector<SolidFace>& faces)
{
  std::vector<double> numbers;
  for (const SolidFace& face : InTurn(faces))
  {
    const Place middle = FindMiddle(meshes, face);
    numbers.insert(numbers.end(), middle.begin(), middle.end());
  }
  numbers = controller ? GatherFromRanks(controller, numbers) : numbers;
  std::vector<Place> middles(numbers.size() / 3);
  for (const vtkIdType i : InTurn(static_cast<vtkIdType>(numbers.size())))
  {
    middles[i / 3][i % 3] = numbers[i];
  }
  StableSort(middles, std::less<>());
  std::vector<SolidFace> outer;
  for (const SolidFace& face : InTurn(faces))
  {
    const auto same = std::equal_range(middles.begin(), middles.end(), FindMiddle(meshes, face));
    if (same.second - same.first == 1)
    {
      outer.push_back(face);
    }
  }
  faces.swap(outer);
}

}
