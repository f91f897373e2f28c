// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceStarLevels.h
 * The levels that a surface scheme makes of the mesh around one vertex (StarMesh.h).
 */
#ifndef SubdivisionObjects_SurfaceStarLevels_h
#define SubdivisionObjects_SurfaceStarLevels_h

#include "Core/Smoothness/StarMesh.h"
#include "Core/Smoothness/SurfaceStars.h"
#include "Core/Surfaces/Steps/SurfaceSteps.h"

#include <memory>
#include <vector>

namespace subdivision
{

/// The steps after which the mesh around the vertex repeats, and how much smaller it then is.
struct Period
{
  int Steps;
  double Factor;
};

Period GetPeriod(SurfaceSchemeKind scheme);

class SurfaceStarLevels
{
public:
  using Matrix = SparseRows<int>;

  SurfaceStarLevels(const SurfaceStar& star, const StarMesh& mesh, int steps);

  const SurfaceLevel<int>& Get(int level) const { return this->Steps->GetLevel(level); }
  const SurfaceScheme<int>& GetScheme() const { return this->Steps->GetScheme(); }
  Matrix GetStep(int step) const { return this->Steps->GetStep(step).Store(); }
  /// From one level to a later one.
  Matrix GetSteps(int from, int to) const;
  /// Values of the vertices of a level at the vertices of a later one.
  std::vector<StarMesh::Place> Apply(int from, int to, std::vector<StarMesh::Place> values) const;

  /// The sum of weight times get(column) over the entries of a row.
  template <typename Get>
  static double SumRow(const Matrix& matrix, vtkIdType row, const Get& get)
  {
    double sum = 0.;
    for (vtkIdType k = matrix.Offsets[row]; k < matrix.Offsets[row + 1]; ++k)
    {
      sum += matrix.Weights[k] * get(matrix.Columns[k]);
    }
    return sum;
  }

private:
  std::unique_ptr<SurfaceSteps<int>> Steps;
};

/// The values of some of `size` vertices, two for each; others have no numbers.
std::vector<StarMesh::Place> PlaceValues(
  const std::vector<double>& values, const std::vector<int>& vertices, std::size_t size);

/// Where the vertices of the control mesh and of the first `steps` levels lie in the control mesh.
std::vector<std::vector<StarMesh::Place>> FindStarPlaces(
  const SurfaceStarLevels& levels, const std::vector<StarMesh::Place>& control, int steps);

}

#endif
