// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/MixedVoxels.h"

#include "Core/Memory/TupleIndex.h"

#include "vtkDataArray.h"

#include <cmath>
#include <cstdint>

namespace subdivision
{
namespace
{

/// Places in a voxel; their bits fit into one number.
constexpr int Places = 64;

/// Place `n` in a voxel, in parts of it: an additive sequence, which fills it evenly seen from any
/// side, begun at another place in each voxel. So errors do not add up where a face is parallel to
/// the image.
Place GetPlaceInVoxel(int n, const std::array<int, 3>& voxel)
{
  constexpr double root = 1.2207440846057596; // of x^4 = x + 1
  constexpr double steps[3] = { 1. / root, 1. / (root * root), 1. / (root * root * root) };
  std::uint64_t hash = 0;
  for (const int index : voxel)
  {
    hash = (hash ^ static_cast<std::uint32_t>(index)) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29;
  }
  Place place{};
  for (int x = 0; x < 3; ++x)
  {
    const double begin = static_cast<double>((hash >> (20 * x)) & 0xFFFFF) / 0x100000;
    const double at = begin + n * steps[x];
    place[x] = at - std::floor(at) - 0.5;
  }
  return place;
}

/// The corners of the faces of a tetrahedron, and the middles of 01, 02 and 12 of each.
constexpr int NodesOfFaces[4][6] = { { 0, 1, 2, 4, 5, 6 }, { 0, 1, 3, 4, 7, 8 },
  { 0, 2, 3, 5, 7, 9 }, { 1, 2, 3, 6, 8, 9 } };

}

MixedVoxels::MixedVoxels(const std::vector<SampledMesh>& meshes,
  const std::vector<double>& materials, const SampleOptions& options)
  : Meshes(meshes)
  , Materials(materials)
  , Options(options)
{
  for (std::size_t m = 0; m < meshes.size(); ++m)
  {
    this->AddFaces(m);
  }
  const double more = options.Grid.Spacing[2];
  this->Lists =
    std::make_unique<SlabLists>(options.Grid, static_cast<vtkIdType>(this->Faces.size()),
      [&](vtkIdType i)
      {
        const Face& face = this->Faces[i];
        const auto nodes = GetNodes(meshes[face.Mesh].Mesh, face.Triangle, 2);
        const double bend = FindBend(nodes, 2);
        std::pair<double, double> reach(nodes[0][2], nodes[0][2]);
        for (int n = 1; n < 6; ++n)
        {
          reach.first = std::min(reach.first, nodes[n][2]);
          reach.second = std::max(reach.second, nodes[n][2]);
        }
        return std::make_pair(reach.first - bend - more, reach.second + bend + more);
      });
}

void MixedVoxels::AddFaces(std::size_t mesh)
{
  const SampledMesh& of = this->Meshes[mesh];
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
  { return of.Material ? of.Material->GetComponent(solids[f / 4].Cell, 0) : 0.; };
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
      Face face{ mesh, { {}, solids[f / 4].Cell } };
      for (int n = 0; n < 6; ++n)
      {
        face.Triangle.Nodes[n] = solids[f / 4].Nodes[NodesOfFaces[f % 4][n]];
      }
      this->Faces.push_back(face);
    }
  }
}

void MixedVoxels::Mark(
  const Face& face, const std::pair<int, int>& slices, std::vector<char>& flags) const
{
  const SampleGrid& grid = this->Options.Grid;
  const auto nodes = GetNodes(this->Meshes[face.Mesh].Mesh, face.Triangle, 2);
  double size = 0.;
  for (int x = 0; x < 3; ++x)
  {
    for (int n = 1; n < 6; ++n)
    {
      size = std::max(size, std::abs(nodes[n][x] - nodes[0][x]) / grid.Spacing[x]);
    }
  }
  int halvings = 0;
  for (; size > 2. && halvings < 8; size /= 2.)
  {
    ++halvings;
  }
  // A part is nowhere farther from its straight triangle than twice the bend of its edges.
  const double bend = 2. * FindBend(nodes, 2) / std::pow(4., halvings);
  ForStraightParts(nodes, 2, halvings,
    [&](const StraightPart& part)
    {
      Place low{};
      Place high{};
      for (int x = 0; x < 3; ++x)
      {
        const double more = bend + grid.Spacing[x] / 2.;
        const auto& c = part.Corners;
        low[x] = std::min({ c[0][x], c[1][x], c[2][x] }) - more;
        high[x] = std::max({ c[0][x], c[1][x], c[2][x] }) + more;
      }
      ForSamplesIn(
        grid, slices, low, high, [&](int, int, int, vtkIdType voxel) { flags[voxel] = 1; });
    });
}

int MixedVoxels::GetComponent(double material) const
{
  const auto found =
    std::lower_bound(this->Materials.begin(), this->Materials.end(), material, IsBeforeMaterial);
  return this->Materials.empty() ? 0 : static_cast<int>(found - this->Materials.begin());
}

double MixedVoxels::GetMaterial(const ListedPiece& listed) const
{
  vtkDataArray* const material = this->Meshes[listed.Mesh].Material;
  return material ? material->GetComponent(listed.Piece->Cell, 0) : 0.;
}

void MixedVoxels::CoverSlab(vtkIdType slab, const std::vector<ListedPiece>& solids,
  const SlabLists& lists, const char* mask, const std::function<double(vtkIdType)>& materialOf,
  float* coverage) const
{
  const SampleGrid& grid = this->Options.Grid;
  const auto& extent = grid.Extent;
  const auto slices = GetSlices(grid, slab);
  const vtkIdType width = extent[1] - extent[0] + 1;
  const vtkIdType height = extent[3] - extent[2] + 1;
  const vtkIdType size = width * height * (slices.second - slices.first);
  const vtkIdType begin = width * height * (slices.first - extent[4]);
  const int components = static_cast<int>(std::max<std::size_t>(this->Materials.size(), 1));
  std::vector<char> flags(size, 0);
  this->Lists->ForNumbers(slab, [&](vtkIdType f) { this->Mark(this->Faces[f], slices, flags); });
  for (vtkIdType s = 0; s < size; ++s)
  {
    flags[s] = flags[s] || mask[begin + s] == InOther;
    if (!flags[s] && mask[begin + s])
    {
      coverage[components * (begin + s) + this->GetComponent(materialOf(begin + s))] = 1.F;
    }
  }
  std::vector<std::uint64_t> taken(size, 0); // places that are in a piece already
  lists.ForNumbers(slab,
    [&](vtkIdType i)
    {
      const ListedPiece& listed = solids[i];
      const TetrahedronSamples samples(GetNodes(this->Meshes[listed.Mesh].Mesh, *listed.Piece, 3));
      const int component = this->GetComponent(this->GetMaterial(listed));
      Place low = samples.GetLow();
      Place high = samples.GetHigh();
      for (int x = 0; x < 3; ++x)
      {
        low[x] -= grid.Spacing[x] / 2.;
        high[x] += grid.Spacing[x] / 2.;
      }
      ForSamplesIn(grid, slices, low, high,
        [&](int at, int j, int k, vtkIdType voxel)
        {
          if (flags[voxel])
          {
            const int found = this->CountPlaces(samples, { at, j, k }, taken[voxel]);
            coverage[components * (begin + voxel) + component] += found / float(Places);
          }
        });
    });
}

int MixedVoxels::CountPlaces(
  const TetrahedronSamples& samples, const std::array<int, 3>& voxel, std::uint64_t& taken) const
{
  const SampleGrid& grid = this->Options.Grid;
  Place middle{};
  Place half{};
  for (int x = 0; x < 3; ++x)
  {
    middle[x] = grid.GetPlace(x, voxel[x]);
    half[x] = grid.Spacing[x] / 2.;
  }
  int found = 0;
  for (int n = 0; n < Places && samples.MayReach(middle, half); ++n)
  {
    const std::uint64_t bit = std::uint64_t(1) << n;
    Place place = middle;
    const Place part = GetPlaceInVoxel(n, voxel);
    for (int x = 0; x < 3; ++x)
    {
      place[x] += part[x] * grid.Spacing[x];
    }
    if (!(taken & bit) && samples.Contains(place))
    {
      taken |= bit;
      ++found;
    }
  }
  return found;
}

}
