// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Distances.h
 * How far samples are away from the outside of solids, and from surfaces, curves and points.
 */
#ifndef SubdivisionObjects_Distances_h
#define SubdivisionObjects_Distances_h

#include "Private/Samples/PieceLists.h"

#include <memory>
#include <vector>

namespace subdivision
{

class Distances
{
public:
  Distances(const std::vector<SampledMesh>& meshes, const SampleOptions& options);

  /// Writes the distances of the samples of a slab, which are negative where they have been so: in
  /// solids. SampleOptions::Others, if it is there, gets those from surfaces, curves and points.
  void WriteSlab(vtkIdType number, float* distances) const;

  /// The distance from the whole where that from the outside of solids is `solid`: inside of solids
  /// their outside counts alone.
  static float Unite(float solid, float other)
  {
    return solid < 0.F ? solid : std::min(solid, other);
  }

private:
  struct Part
  {
    ListedPiece Piece;
    int Dimension;
    bool IsOutside; ///< of a solid
  };
  std::array<Place, 10> GetNodesOf(const Part& part) const;
  /// Lowers the squares of distances of samples that are nearer to a part.
  void Approach(const Part& part, const SampleGrid& slab, std::vector<double>& squares) const;

  const std::vector<SampledMesh>& Meshes;
  const SampleOptions& Options;
  std::vector<Part> Parts;
  std::unique_ptr<SlabLists> Lists;
};

}

#endif
