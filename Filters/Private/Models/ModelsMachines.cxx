// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModelsMachines.cxx
 * The spring with its valve, and the mechanical part.
 */
#include "Private/Models/Models.h"

#include "vtkMath.h"

#include <cmath>
#include <vector>

namespace subdivision
{

namespace
{

using Ids = ModelBuilder::Ids;
using Vector = ModelBuilder::Vector;

constexpr int Sectors = 8;

// ---- Spring and valve ---------------------------------------------------------------------------

/// The bottom of the cap, from the axis outward: what the other parts are joined to.
struct CapBottom
{
  Ids Pipe;  // carries the cylinder
  Ids Inner; // the spring ends between Inner and Outer
  Ids Outer;
};

CapBottom Cap(ModelBuilder& model, double z)
{
  vtkIdType axis[2];
  Ids rings[2][3];
  const double radii[2][3] = { { 0.6, 1.1, 1.9 }, { 0.6, 1.1, 1.6 } };
  const double heights[2][3] = { { z, z, z }, { z + 0.8, z + 0.7, z + 0.55 } };
  for (int top = 0; top < 2; ++top)
  {
    axis[top] = model.Point(0.0, 0.0, z + 0.85 * top);
    for (int r = 0; r < 3; ++r)
    {
      rings[top][r] = model.Ring(Sectors, radii[top][r], heights[top][r]);
    }
  }
  for (int i = 0, j = 1; i < Sectors; ++i, j = (j + 1) % Sectors)
  {
    const auto hexahedron = [&](int inner, int outer)
    {
      const auto quad = [&](int top)
      {
        const Ids& in = rings[top][inner];
        const Ids& out = rings[top][outer];
        return Ids{ in[i], out[i], out[j], in[j] };
      };
      model.Hexahedron(quad(0), quad(1));
    };
    model.Hexahedron({ axis[0], rings[0][0][i], rings[0][0][j], axis[0] },
      { axis[1], rings[1][0][i], rings[1][0][j], axis[1] });
    hexahedron(0, 1);
    hexahedron(1, 2);
  }
  return { rings[0][0], rings[0][1], rings[0][2] };
}

/// A chain of hexahedra along a spiral that rises to the cap and ends in one of its bottom faces.
/// From where the last section stands, smoothing turns no cell inside out.
void Spring(ModelBuilder& model, const CapBottom& cap, double zOfCap)
{
  constexpr int last = 20; // sections, `Sectors` to a turn
  constexpr double pitch = 1.3;
  Ids before;
  for (int s = 0; s <= last; ++s)
  {
    const double angle = vtkMath::RadiansFromDegrees(360.0 * (s - last + 0.5) / Sectors);
    const double z = zOfCap - 0.8 + pitch * (s - last) / Sectors;
    const auto corner = [&](double radius, double dz)
    { return model.Point(radius * std::cos(angle), radius * std::sin(angle), z + dz); };
    const Ids section{ corner(1.1, -0.35), corner(1.9, -0.35), corner(1.9, 0.35),
      corner(1.1, 0.35) };
    if (s > 0)
    {
      model.Hexahedron(before, section);
    }
    before = section;
  }
  model.Hexahedron(before, { cap.Inner[2], cap.Outer[2], cap.Outer[1], cap.Inner[1] });
}

}

void BuildSpringAndValve(ModelBuilder& model)
{
  constexpr double zOfCap = 4.0;
  model.Tension = [](const Vector& x) { return std::hypot(x[0], x[1]) * std::sin(1.6 * x[2]); };
  model.Material = 0;
  const CapBottom cap = Cap(model, zOfCap);
  model.Material = 1;
  Spring(model, cap, zOfCap);

  model.Material = 2; // the valve: a pipe that widens to a trumpet
  const double radii[] = { 0.55, 0.55, 0.55, 0.6, 1.05, 1.75 };
  const double heights[] = { 3.0, 2.0, 1.0, 0.1, -0.7, -1.1 };
  Ids above = cap.Pipe;
  for (int i = 0; i < 6; ++i)
  {
    const Ids below = model.Ring(Sectors, radii[i], heights[i]);
    model.Strip(above, below, true);
    above = below;
  }
}

// ---- Mechanical part ----------------------------------------------------------------------------

namespace
{

constexpr int Levels = 3; // of points, from the bottom to the top face

/// The outline as polygons in the plane, extruded through all levels.
class Plate
{
public:
  explicit Plate(ModelBuilder& model)
    : Model(model)
  {
  }

  /// The same point at every level.
  Ids Column(double x, double y)
  {
    Ids column;
    for (int level = 0; level < Levels; ++level)
    {
      column.push_back(this->Model.Point(x, y, 0.5 * level));
    }
    return column;
  }

  /// A column of hexahedra (or of wedges, when two corners are equal), flat at the bottom and the
  /// top.
  void Extrude(const Ids& a, const Ids& b, const Ids& c, const Ids& d)
  {
    for (int level = 0; level + 1 < Levels; ++level)
    {
      this->Model.Hexahedron({ a[level], b[level], c[level], d[level] },
        { a[level + 1], b[level + 1], c[level + 1], d[level + 1] });
    }
    for (int level : { 0, Levels - 1 })
    {
      this->Model.SolidFace({ a[level], b[level], c[level], d[level] }, ModelBuilder::SINGULAR);
    }
  }

private:
  ModelBuilder& Model;
};

constexpr int Rows = 4; // of columns across the plate

/// The end with the hole; two of its corners are cut off, to become round. Returns the columns
/// where the plate goes on.
std::vector<Ids> EyeOfPlate(ModelBuilder& model, Plate& plate)
{
  const double outline[12][2] = { { 1.5, -1.5 }, { 1.5, -0.6 }, { 1.5, 0.6 }, { 1.5, 1.5 },
    { 0.6, 1.5 }, { -0.6, 1.5 }, { -1.5, 1.5 }, { -1.5, 0.6 }, { -1.5, -0.6 }, { -1.5, -1.5 },
    { -0.6, -1.5 }, { 0.6, -1.5 } };
  std::vector<Ids> hole;
  for (int i = 0; i < Sectors; ++i)
  {
    const double angle = vtkMath::RadiansFromDegrees(45.0 * i - 22.5);
    hole.push_back(plate.Column(0.9 * std::cos(angle), 0.9 * std::sin(angle)));
  }
  std::vector<Ids> outer(12);
  for (int i = 0; i < 12; ++i)
  {
    if (i != 6 && i != 9) // the corners that are cut off
    {
      outer[i] = plate.Column(outline[i][0], outline[i][1]);
    }
  }
  for (int i = 0, j = 1; i < Sectors; ++i, j = (j + 1) % Sectors)
  {
    // Even sectors face a side of the outline, odd ones a corner.
    const int from = 3 * (i / 2) + 1 + i % 2;
    const int to = (from + 1 + i % 2) % 12;
    plate.Extrude(hole[i], outer[from], outer[to], hole[j]);
    if (i % 2 == 1 && !outer[(from + 1) % 12].empty())
    {
      plate.Extrude(outer[from], outer[(from + 1) % 12], outer[to], outer[from]);
    }
  }
  for (int level : { 0, Levels - 1 })
  {
    Ids rim;
    for (const Ids& column : hole)
    {
      rim.push_back(column[level]);
    }
    model.Polyline(rim, ModelBuilder::SINGULAR, true);
  }
  return { outer[0], outer[1], outer[2], outer[3] };
}

/// The far end: a flat face between sharp edges, with four sharp corners.
void SharpEnd(ModelBuilder& model, const std::vector<Ids>& columns)
{
  constexpr int top = Levels - 1;
  for (int row = 0; row + 1 < Rows; ++row)
  {
    for (int level = 0; level < top; ++level)
    {
      model.SolidFace({ columns[row][level], columns[row + 1][level], columns[row + 1][level + 1],
                        columns[row][level + 1] },
        ModelBuilder::SINGULAR);
    }
    model.Line(columns[row][0], columns[row + 1][0], ModelBuilder::SINGULAR);
    model.Line(columns[row][top], columns[row + 1][top], ModelBuilder::SINGULAR);
  }
  for (const Ids& column : { columns.front(), columns.back() })
  {
    model.Polyline(column, ModelBuilder::SINGULAR);
    model.Vertex(column[0], ModelBuilder::SINGULAR);
    model.Vertex(column[top], ModelBuilder::SINGULAR);
  }
}

/// A tube of four sides that leaves the plate in one quad and comes back in another.
void Handle(ModelBuilder& model, const Ids& from, const Ids& to)
{
  const double path[][3] = { { 2.45, 1.9, 170.0 }, { 2.9, 2.75, 130.0 }, { 4.1, 2.75, 50.0 },
    { 4.55, 1.9, 10.0 } }; // x, z and the direction of the outer side, in degrees
  Ids before = from;
  for (const auto& station : path)
  {
    const double angle = vtkMath::RadiansFromDegrees(station[2]);
    const auto corner = [&](double out, double y)
    {
      return model.Point(station[0] + out * std::cos(angle), y, station[1] + out * std::sin(angle));
    };
    const Ids section{ corner(0.38, -0.5), corner(0.38, 0.5), corner(-0.38, 0.5),
      corner(-0.38, -0.5) };
    model.Strip(before, section, true);
    before = section;
  }
  model.Strip(before, to, true);
}

}

void BuildMechanicalPart(ModelBuilder& model)
{
  model.Tension = [](const Vector& x) { return std::cos(1.3 * x[0]) + 0.6 * x[2]; };
  model.Material = 0;
  Plate plate(model);
  std::vector<Ids> columns = EyeOfPlate(model, plate);
  Ids feet[2];
  const double stations[] = { 2.1, 2.9, 4.1, 4.9, 5.5 };
  for (int s = 0; s < 5; ++s)
  {
    std::vector<Ids> next;
    for (double y : { -1.5, -0.6, 0.6, 1.5 })
    {
      next.push_back(plate.Column(stations[s], y));
    }
    for (int row = 0; row + 1 < Rows; ++row)
    {
      plate.Extrude(columns[row], next[row], next[row + 1], columns[row + 1]);
    }
    if (s == 1 || s == 3) // under the handle, its outer side first
    {
      const std::vector<Ids>& out = s == 1 ? columns : next;
      const std::vector<Ids>& in = s == 1 ? next : columns;
      feet[s / 2] = { out[1].back(), out[2].back(), in[2].back(), in[1].back() };
    }
    columns = next;
  }
  SharpEnd(model, columns);
  model.Material = 1;
  Handle(model, feet[0], feet[1]);
}

}
