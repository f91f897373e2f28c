// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/MixedVoxels.h"

#include "Core/Memory/Vectors.h"

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

}

MixedVoxels::MixedVoxels(const std::vector<SampledMesh>& meshes,
  const std::vector<double>& materials, const SampleOptions& options)
  : Meshes(meshes)
  , Materials(materials)
  , Options(options)
  , Faces(ListFaces(meshes, true))
{
  const auto& spacing = options.Grid.Spacing;
  const double more = *std::max_element(spacing.begin(), spacing.end());
  this->Lists =
    std::make_unique<SlabLists>(options.Grid, static_cast<vtkIdType>(this->Faces.size()),
      [&](vtkIdType i)
      {
        const SolidFace& face = this->Faces[i];
        return FindReach(GetNodes(meshes[face.Mesh].Mesh, face.Triangle, 2), 2, more);
      });
}

void MixedVoxels::Mark(
  const SolidFace& face, const SampleGrid& slab, std::vector<char>& flags) const
{
  const SampleGrid& grid = this->Options.Grid;
  const auto nodes = GetNodes(this->Meshes[face.Mesh].Mesh, face.Triangle, 2);
  const int halvings = CountHalvings(FindSize(nodes, 2, grid.Spacing), 2., 2.);
  // A part is nowhere farther from its straight triangle than twice the bend of its edges.
  const double bend = 2. * FindBend(nodes, 2) / std::pow(4., halvings);
  ForStraightParts(nodes, 2, halvings,
    [&](const StraightPart& part)
    {
      const Place half = vectors::Scale(0.5, grid.Spacing);
      const auto box = FindBox(part.Corners, 3, { bend + half[0], bend + half[1], bend + half[2] });
      ForSamplesIn(
        slab, box.first, box.second, [&](int, int, int, vtkIdType voxel) { flags[voxel] = 1; });
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

void MixedVoxels::CoverSlab(vtkIdType number, const std::vector<ListedPiece>& solids,
  const SlabLists& lists, const char* mask, const std::function<double(vtkIdType)>& materialOf,
  float* coverage) const
{
  const SampleGrid& grid = this->Options.Grid;
  const SampleGrid slab = GetSlab(grid, number);
  const vtkIdType size = CountSamplesOf(slab);
  const vtkIdType begin = GetBegin(grid, slab);
  const int components = static_cast<int>(std::max<std::size_t>(this->Materials.size(), 1));
  std::vector<char> flags(size, 0);
  this->Lists->ForNumbers(number, [&](vtkIdType f) { this->Mark(this->Faces[f], slab, flags); });
  for (vtkIdType s = 0; s < size; ++s)
  {
    flags[s] = flags[s] || mask[begin + s] == InOther;
    if (!flags[s] && mask[begin + s])
    {
      coverage[components * (begin + s) + this->GetComponent(materialOf(begin + s))] = 1.F;
    }
  }
  std::vector<std::uint64_t> taken(size, 0); // places that are in a piece already
  lists.ForNumbers(number,
    [&](vtkIdType i)
    {
      const ListedPiece& listed = solids[i];
      const TetrahedronSamples samples(GetNodes(this->Meshes[listed.Mesh].Mesh, *listed.Piece, 3));
      const int component = this->GetComponent(this->GetMaterial(listed));
      const auto box = FindBox(std::array<Place, 2>{ samples.GetLow(), samples.GetHigh() }, 2,
        vectors::Scale(0.5, grid.Spacing));
      ForSamplesIn(slab, box.first, box.second,
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
