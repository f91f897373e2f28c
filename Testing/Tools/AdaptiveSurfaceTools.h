// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSurfaceTools.h
 * Adaptive sqrt(3) meshes of the surfaces of SurfaceTools.h.
 */
#ifndef AdaptiveSurfaceTools_h
#define AdaptiveSurfaceTools_h

#include "SurfaceTools.h"

#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThreeOutput.h"
#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThreeRows.h"

namespace surfacetools
{

/// An adaptive mesh with what it was made of.
class Adaptive
{
public:
  explicit Adaptive(const Model& model)
    : Control(model, SurfaceSchemeKind::SqrtThree, false)
    , Mesh(Control.Level)
  {
  }

  /// Splits everything below a level.
  void SplitTo(int level);
  /// Splits some of the faces that are there, several times.
  void SplitAtRandom(unsigned seed, int rounds, int maximumLevel);

  struct Result
  {
    std::vector<Point> Points;
    std::vector<std::array<int, 3>> Triangles;
    std::vector<unsigned char> Generations;
    std::vector<vtkIdType> Faces;
  };
  /// Renumbers the vertices.
  Result Finish();

  Walk Control;
  AdaptiveSqrtThree<int> Mesh;
};

}

#endif
