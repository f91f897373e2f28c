// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StarMesh.h
 * A flat mesh around one vertex, of sectors of triangles or quads with three rings of them.
 */
#ifndef SubdivisionObjects_StarMesh_h
#define SubdivisionObjects_StarMesh_h

#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
  StarMesh(int sectors, double angle, bool quads)
    : Sectors(sectors)
    , IsClosed(angle > 2. * Pi - 1e-6)
    , HasQuads(quads)
    , Angle(angle)
    , Ids(static_cast<std::size_t>(sectors + 1) * (Rings + 1) * (Rings + 1), -1)
  {
    for (int sector = 0; sector < sectors; ++sector)
    {
      this->AddSector(sector);
    }
    for (const Place& place : this->Places)
    {
      this->Points.insert(this->Points.end(), { place[0], place[1], 0. });
    }
  }

  int GetNumberOfVertices() const { return static_cast<int>(this->Places.size()); }
  const std::vector<Place>& GetPlaces() const { return this->Places; }
  /// The same with three coordinates each.
  const double* GetPoints() const { return this->Points.data(); }
  PolygonList<int> MakeList() const
  {
    PolygonList<int> list;
    list.NumberOfVertices = this->GetNumberOfVertices();
    const int size = this->HasQuads ? 4 : 3;
    const auto corners = static_cast<vtkIdType>(this->Corners.size());
    list.FaceOffsets = Buffer<int>(corners / size + 1);
    for (int face = 0; face <= corners / size; ++face)
    {
      list.FaceOffsets[face] = size * face;
    }
    list.Vertices = Buffer<int>(corners);
    std::copy(this->Corners.begin(), this->Corners.end(), list.Vertices.begin());
    return list;
  }
  bool IsOnFirstRay(int vertex) const
  {
    const Place& place = this->Places[vertex];
    return std::abs(place[1]) < 1e-9 && place[0] > -1e-9;
  }
  /// The direction of a place, from 0 up to the angle of the mesh.
  double FindTurn(const Place& place) const
  {
    double turn = std::atan2(place[1], place[0]);
    turn += turn < -1e-6 ? 2. * Pi : 0.;
    return turn > this->Angle + 1e-6 || (this->IsClosed && turn > 2. * Pi - 1e-9) ? 0. : turn;
  }
  /// How many rings a place is away from the middle.
  double Measure(const Place& place) const
  {
    const double width = this->Angle / this->Sectors;
    const double turn = this->FindTurn(place);
    const double sector =
      std::min(std::max(std::floor(turn / width + 1e-9), 0.), this->Sectors - 1.);
    const double inside = turn - sector * width;
    const double length = std::hypot(place[0], place[1]);
    const double b = length * std::sin(inside) / std::sin(width);
    const double a = length * std::sin(width - inside) / std::sin(width);
    return this->HasQuads ? std::max(a, b) : a + b;
  }

private:
  static constexpr int Rings = 3;
  void AddSector(int sector)
  {
    const auto add = [&](std::initializer_list<std::array<int, 2>> face)
    {
      for (const auto& corner : face)
      {
        this->Corners.push_back(this->FindVertex(sector, corner[0], corner[1]));
      }
    };
    for (int i = 0; i < Rings; ++i)
    {
      for (int j = 0; j < Rings; ++j)
      {
        if (this->HasQuads)
        {
          add({ { { i, j } }, { { i + 1, j } }, { { i + 1, j + 1 } }, { { i, j + 1 } } });
        }
        else if (i + j < Rings)
        {
          add({ { { i, j } }, { { i + 1, j } }, { { i, j + 1 } } });
          if (i + j + 1 < Rings)
          {
            add({ { { i + 1, j } }, { { i + 1, j + 1 } }, { { i, j + 1 } } });
          }
        }
      }
    }
  }

  /// The vertices of a ray belong to the sector that begins there.
  int FindVertex(int sector, int i, int j)
  {
    if (i == 0 && j > 0)
    {
      return this->FindVertex(this->IsClosed ? (sector + 1) % this->Sectors : sector + 1, j, 0);
    }
    const int owner = i == 0 ? 0 : sector;
    int& id = this->Ids[(static_cast<std::size_t>(owner) * (Rings + 1) + i) * (Rings + 1) + j];
    if (id < 0)
    {
      id = static_cast<int>(this->Places.size());
      const double width = this->Angle / this->Sectors;
      const double a = owner * width;
      const double b = a + width;
      this->Places.push_back(
        { { i * std::cos(a) + j * std::cos(b), i * std::sin(a) + j * std::sin(b) } });
    }
    return id;
  }

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
