// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RandomSurfaces.h
 * Rough triangle meshes with vertices of many valences, closed and open: spheres, spheres with a
 * hole, tori and fields of heights, all with turned edges and noise.
 */
#ifndef RandomSurfaces_h
#define RandomSurfaces_h

#include "SurfaceTools.h"

namespace surfacetools
{

class RandomSurface
{
public:
  explicit RandomSurface(unsigned seed);
  const Model& Get() const { return this->Surface; }

private:
  std::size_t Pick(std::size_t choices) { return this->Random() % choices; }
  /// The same numbers with any standard library.
  double Choose(double least, double most)
  {
    return least + (most - least) * (this->Random() / 4294967296.);
  }

  /// A tetrahedron the faces of which are split again and again.
  void MakeSphere();

  /// Closed: a torus.
  void MakeSheet(bool isClosed);

  static bool Has(const std::vector<vtkIdType>& face, vtkIdType vertex)
  {
    return std::find(face.begin(), face.end(), vertex) != face.end();
  }
  std::size_t CountFaces(vtkIdType a, vtkIdType b) const
  {
    const auto& faces = this->Surface.Faces;
    return static_cast<std::size_t>(std::count_if(
      faces.begin(), faces.end(), [=](const auto& face) { return Has(face, a) && Has(face, b); }));
  }

  /// Replaces an edge by that between the vertices opposite to it, where there is none yet.
  void TurnEdges(std::size_t trials);

  /// Takes a vertex away, with the faces at it.
  void CutOff(vtkIdType vertex);

  std::mt19937 Random;
  Model Surface;
};

}

#endif
