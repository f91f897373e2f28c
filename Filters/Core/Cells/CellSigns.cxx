// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellSigns.h"

#include <cmath>

namespace subdivision
{
namespace
{

/// A solid of positive volume.
const SolidPlaces& GetModel(CellShape shape)
{
  static const SolidPlaces tet{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  static const SolidPlaces pyramid{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { .5, .5, 1 } } };
  static const SolidPlaces wedge{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 0, 1, 1 } } };
  static const SolidPlaces hex{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };
  static const SolidPlaces octahedron{ { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
    { 0, 0, 1 }, { 0, 0, -1 } } };
  return shape == CellShape::Tet  ? tet
    : shape == CellShape::Pyramid ? pyramid
    : shape == CellShape::Wedge   ? wedge
    : shape == CellShape::Hex     ? hex
                                  : octahedron;
}

/// Adds the volume between the fan of a face around its middle and the middle of
/// the solid, and how large that could be.
void AddFace(
  const std::vector<unsigned char>& face, const SolidPlaces& x, double& volume, double& most)
{
  const auto size = face.size();
  double centre[3] = { 0., 0., 0. };
  for (int c = 0; c < 3; ++c)
  {
    for (const unsigned char corner : face)
    {
      centre[c] += x[corner][c] / static_cast<double>(size);
    }
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto& a = x[face[i]];
    const auto& b = x[face[(i + 1) % size]];
    volume += centre[0] * (a[1] * b[2] - a[2] * b[1]) + centre[1] * (a[2] * b[0] - a[0] * b[2]) +
      centre[2] * (a[0] * b[1] - a[1] * b[0]);
    most += std::hypot(centre[0], centre[1], centre[2]) * std::hypot(a[0], a[1], a[2]) *
      std::hypot(b[0], b[1], b[2]);
  }
}

/// Moves corners so that their mean is zero.
void Centre(const CellTable& table, SolidPlaces& x)
{
  for (int c = 0; c < 3; ++c)
  {
    double mean = 0.;
    for (int i = 0; i < table.Corners; ++i)
    {
      mean += x[i][c] / table.Corners;
    }
    for (int i = 0; i < table.Corners; ++i)
    {
      x[i][c] -= mean;
    }
  }
}

std::vector<double> FindSigns(CellShape shape)
{
  SolidPlaces x = GetModel(shape);
  Centre(GetCellTable(shape), x);
  std::vector<double> signs;
  for (const std::vector<unsigned char>& face : GetCellTable(shape).Faces)
  {
    double volume = 0.;
    double most = 0.;
    AddFace(face, x, volume, most);
    signs.push_back(volume > 0. ? 1. : -1.);
  }
  return signs;
}

}

const std::vector<double>& GetFaceSigns(CellShape shape)
{
  static const auto all = []
  {
    std::array<std::vector<double>, NumberOfShapes> made;
    for (int s = static_cast<int>(CellShape::Tet); s < NumberOfShapes; ++s)
    {
      made[static_cast<std::size_t>(s)] = FindSigns(static_cast<CellShape>(s));
    }
    return made;
  }();
  return all[static_cast<std::size_t>(shape)];
}

int FindOrientation(CellShape shape, const SolidPlaces& corners, double least)
{
  const CellTable& table = GetCellTable(shape);
  SolidPlaces x = corners;
  Centre(table, x);
  double volume = 0.;
  double most = 0.;
  for (std::size_t f = 0; f < table.Faces.size(); ++f)
  {
    double part = 0.;
    AddFace(table.Faces[f], x, part, most);
    volume += GetFaceSigns(shape)[f] * part;
  }
  return volume > least * most ? 1 : volume < -least * most ? -1 : 0;
}

}
