// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MixedVoxels.h
 * How much of each voxel is inside, where a face between materials or the outside passes.
 */
#ifndef SubdivisionObjects_MixedVoxels_h
#define SubdivisionObjects_MixedVoxels_h

#include "Private/Samples/PieceLists.h"
#include "Private/Samples/SolidFaces.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace subdivision
{

/// What the mask has while a slab is made: 0 outside; in the end surfaces count as solids do.
constexpr char InSolid = 1;
constexpr char InOther = 2;

/// A voxel is the box around a sample, as large as the spacing.
class MixedVoxels
{
public:
  MixedVoxels(const std::vector<SampledMesh>& meshes, const std::vector<double>& materials,
    const SampleOptions& options);

  /// `solids`: all, in an order in which the slab has the numbers of those that reach half a voxel
  /// into it. Writes the coverage of the samples of the slab, of each material, into `coverage`,
  /// which is 0; `mask` and `materialOf` are those of samples that are done.
  /// Voxels whose sample is of a surface or a curve are looked at like those with a face.
  void CoverSlab(vtkIdType number, const std::vector<ListedPiece>& solids, const SlabLists& lists,
    const char* mask, const std::function<double(vtkIdType)>& materialOf, float* coverage) const;

private:
  /// Marks the voxels of the slab through which faces may pass; `flags` begin at its first slice.
  void Mark(const SolidFace& face, const SampleGrid& slab, std::vector<char>& flags) const;
  /// How many places of a voxel are in a piece and in none before; `taken` has a bit for each.
  int CountPlaces(
    const TetrahedronSamples& samples, const std::array<int, 3>& voxel, std::uint64_t& taken) const;
  int GetComponent(double material) const;
  double GetMaterial(const ListedPiece& listed) const;

  const std::vector<SampledMesh>& Meshes;
  const std::vector<double>& Materials;
  const SampleOptions& Options;
  const std::vector<SolidFace> Faces;
  std::unique_ptr<SlabLists> Lists;
};

}

#endif
