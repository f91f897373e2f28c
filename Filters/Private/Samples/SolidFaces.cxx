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
/// The corners against them.
constexpr int Tops[4] = { 3, 2, 1, 0 };

/// Materials may be no numbers.
bool AreSame(double a, double b)
{
  return a == b || (a != a && b != b);
}

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
  // What is known of a face: nothing, the last tetrahedron, or that it is between two alike.
  std::vector<vtkIdType> last(numbers.Representatives.size(), -1);
  std::vector<char> isInside(last.size(), 0);
  const auto material = [&](vtkIdType f)
  {
    return betweenMaterials && of.Material ? of.Material->GetComponent(solids[f / 4].Cell, 0) : 0.;
  };
  const auto top = [&](vtkIdType f) { return solids[f / 4].Nodes[Tops[f % 4]]; };
  for (const vtkIdType f : InTurn(corners.size()))
  {
    const vtkIdType number = numbers.Numbers[f];
    const vtkIdType other = last[number];
    isInside[number] |= other >= 0 && top(other) != top(f) && // a cell may be there twice
      AreSame(material(other), material(f));
    last[number] = f;
  }
  for (const vtkIdType number : InTurn(static_cast<vtkIdType>(last.size())))
  {
    if (!isInside[number] && last[number] >= 0)
    {
      const vtkIdType f = last[number];
      SolidFace face{ mesh, { {}, solids[f / 4].Cell }, top(f) };
      for (int n = 0; n < 6; ++n)
      {
        face.Triangle.Nodes[n] = solids[f / 4].Nodes[NodesOfFaces[f % 4][n]];
      }
      faces.push_back(face);
    }
  }
}

/// The middle of the corners, and the corner of the tetrahedron against them. Blocks, ranks and
/// copies of points have the same bits.
using FaceKey = std::array<double, 6>;

FaceKey MakeKey(const std::vector<SampledMesh>& meshes, const SolidFace& face)
{
  vtkPointSet* const mesh = meshes[face.Mesh].Mesh;
  std::array<Place, 3> corners{};
  for (int c = 0; c < 3; ++c)
  {
    mesh->GetPoint(face.Triangle.Nodes[c], corners[c].data());
  }
  std::sort(corners.begin(), corners.end()); // the order of a sum makes other bits
  FaceKey key{};
  mesh->GetPoint(face.Top, key.data() + 3);
  for (int x = 0; x < 3; ++x)
  {
    key[x] = (corners[0][x] + corners[1][x] + corners[2][x]) / 3.;
  }
  return key;
}

/// Orders keys by the middles alone.
bool IsMiddleLess(const FaceKey& a, const FaceKey& b)
{
  return std::lexicographical_compare(a.begin(), a.begin() + 3, b.begin(), b.begin() + 3);
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
    const FaceKey key = MakeKey(meshes, face);
    numbers.insert(numbers.end(), key.begin(), key.end());
  }
  numbers = controller ? GatherFromRanks(controller, numbers) : numbers;
  std::vector<FaceKey> keys(numbers.size() / 6);
  for (const vtkIdType i : InTurn(static_cast<vtkIdType>(numbers.size())))
  {
    keys[i / 6][i % 6] = numbers[i];
  }
  StableSort(keys, std::less<>());
  std::vector<SolidFace> outer;
  for (const SolidFace& face : InTurn(faces))
  {
    // The same tetrahedron may be there more than once: its faces have nothing behind them.
    const auto same =
      std::equal_range(keys.begin(), keys.end(), MakeKey(meshes, face), IsMiddleLess);
    if (same.first == same.second || *same.first == *(same.second - 1))
    {
      outer.push_back(face);
    }
  }
  faces.swap(outer);
}

}
