// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StarMesh.h
 * A flat mesh around one vertex, of sectors of triangles or quads with three rings of them.
 */
#ifndef SubdivisionObjects_StarMesh_h
#define SubdivisionObjects_StarMesh_h

#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <array>
#include <vector>

namespace subdivision
{

/**
 * Sector s has the vertices i d(s) + j d(s + 1) with directions d of length 1; rings are straight
 * in each, so that middles of edges and faces lie on rings of a finer mesh of the same kind. Vertex
 * 0 is the middle.
 */
class StarMesh
{
public:
  using Place = std::array<double, 2>;

  /// `angle`: of all sectors together; 2 pi closes them.
  StarMesh(int sectors, double angle, bool quads);

  int GetNumberOfVertices() const { return static_cast<int>(this->Places.size()); }
  const std::vector<Place>& GetPlaces() const { return this->Places; }
  /// The same with three coordinates each.
  const double* GetPoints() const { return this->Points.data(); }
  PolygonList<int> MakeList() const;
  bool IsOnFirstRay(int vertex) const;

  /// The direction of a place, from 0 up to the angle of the mesh.
  double FindTurn(const Place& place) const;
  /// How many rings a place is away from the middle.
  double Measure(const Place& place) const;

private:
  static constexpr int Rings = 3;

  void AddSector(int sector);
  int FindVertex(int sector, int i, int j);

  const int Sectors;
  const bool IsClosed;
  const bool HasQuads;
  const double Angle;
  std::vector<int> Ids; ///< of each sector, i and j; -1: not made
  std::vector<Place> Places;
  std::vector<double> Points;
  std::vector<int> Corners; ///< of all faces
};

}

#endif
