// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSearch.h
 * The cells of a surface, in which the nearest places are searched (NearestPlaces.h).
 */
#ifndef SubdivisionObjects_SurfaceSearch_h
#define SubdivisionObjects_SurfaceSearch_h

#include "Core/Surfaces/Places/SurfacePlaces.h"
#include "Private/Places/NearestPlaces.h"
#include "Private/Surface/SurfaceCells.h"

#include <vector>

namespace subdivision
{

/// Vertices, then lines, then faces. If a face has not the number of corners of the scheme, all
/// faces count as the quads at their corners, and all lines as two halves, so that cells meet at
/// whole edges.
template <typename Id>
class SurfaceSearch
{
public:
  /// `cells` and `level` have to live as long as this.
  SurfaceSearch(const SurfaceCells& cells, const SurfaceLevel<Id>& level, bool needsTriangles);

  SearchedCells GetCells() const
  {
    const vtkIdType corners = this->Level.Mesh.NumberOfVertices +
      this->Level.Mesh.GetNumberOfEdges() + this->Level.Mesh.NumberOfFaces;
    return { corners, this->Dimensions, this->Connectivity, this->HasQuads };
  }

  /// The cell of the surface with a place.
  vtkIdType FindOwner(const NearestPlace& place) const;
  /// The place, on an edge that may have faces. Its parameters are as in the search.
  SurfacePlace<Id> MakePlace(const NearestPlace& place) const;
  /// How far a place on a line is from its first point.
  double GetPlaceOnLine(const NearestPlace& place) const
  {
    const Part& part = this->Parts[place.Cell];
    return part.Corner < 0 ? place.Weights[1] : 0.5 * (place.Weights[1] + part.Corner);
  }
  /// The vertex that is nearest, by parameters.
  Id FindNearestVertex(const NearestPlace& place) const;

private:
  struct Part
  {
    vtkIdType Number; ///< of the vertex, line or face
    int Corner;       ///< or half; -1: the whole of it
  };
  void AddCell(int dimension, const Part& part, std::initializer_list<Id> corners);

  const SurfaceCells& Cells;
  const SurfaceLevel<Id>& Level;
  const bool HasQuads;
  bool IsSplit = false;
  std::vector<unsigned char> Dimensions;
  std::vector<vtkIdType> Connectivity;
  std::vector<Part> Parts; ///< of each cell
};

}

#endif
