// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThickPieces.h
 * The samples near surfaces, curves and points, which have a thickness in an image.
 */
#ifndef SubdivisionObjects_ThickPieces_h
#define SubdivisionObjects_ThickPieces_h

#include "Private/Samples/PieceLists.h"

#include <functional>

namespace subdivision
{

class ThickPieces
{
public:
  ThickPieces(const std::vector<SampledMesh>& meshes, const SampleOptions& options);

  /// Calls act(i, j, k, piece, dimension, weights) for the samples of a slab that are within half
  /// of the thickness of a piece: once or more for each, the last time with the nearest piece and
  /// its distance squared.
  /// Pieces of less dimensions come first, and take their samples from others.
  using Act = std::function<void(int, int, int, const ListedPiece&, int, const Place&, double)>;
  void ForSlab(vtkIdType number, const Act& act) const;

private:
  /// Of the nodes of a piece, and the largest anywhere in it.
  std::array<double, 10> GetRadii(const ListedPiece& listed, int dimension) const;
  double GetLargestRadius(const ListedPiece& listed, int dimension) const;
  void Sample(const ListedPiece& listed, int dimension, const SampleGrid& slab,
    std::vector<double>& squares, const Act& act) const;

  const std::vector<SampledMesh>& Meshes;
  const SampleOptions& Options;
  std::array<std::vector<ListedPiece>, 3> Pieces;
  std::vector<SlabLists> Lists; ///< of each dimension
};

}

#endif
