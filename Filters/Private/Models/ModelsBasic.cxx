// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModelsBasic.cxx
 * The flower (mixed dimensions), the screw, the block of two materials and the cylinder.
 */
#include "Private/Models/Models.h"

#include "vtkMath.h"

#include <cmath>

namespace subdivision
{

namespace
{

using Ids = ModelBuilder::Ids;
using Vector = ModelBuilder::Vector;

/// A point by its distance from the z axis, its angle around it and its height.
vtkIdType Polar(ModelBuilder& model, double radius, double degrees, double z)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  return model.Point(radius * std::cos(angle), radius * std::sin(angle), z);
}

/// A solid disc of six wedges per layer around the z axis; returns the ring of its widest level.
Ids FlowerHead(ModelBuilder& model, vtkIdType& foot)
{
  const double radii[] = { 0.65, 1.15, 0.8 };
  const double heights[] = { -0.6, 0.0, 0.6 };
  std::vector<Ids> rings;
  Ids axis;
  for (int level = 0; level < 3; ++level)
  {
    axis.push_back(model.Point(0.0, 0.0, 1.25 * heights[level]));
    rings.push_back(model.Ring(6, radii[level], heights[level]));
  }
  for (int level = 0; level < 2; ++level)
  {
    const Ids& low = rings[level];
    const Ids& high = rings[level + 1];
    for (int i = 0, j = 1; i < 6; ++i, j = (j + 1) % 6)
    {
      model.Hexahedron({ axis[level], low[i], low[j], axis[level] },
        { axis[level + 1], high[i], high[j], axis[level + 1] });
    }
  }
  foot = axis[0];
  return rings[1];
}

/// A petal on every edge of the ring; neighbours share a point, where the notch between them ends.
void Petals(ModelBuilder& model, const Ids& ring)
{
  const int n = static_cast<int>(ring.size());
  Ids notch;
  for (int i = 0; i < n; ++i)
  {
    notch.push_back(Polar(model, 1.7, 360.0 * i / n, 0.0));
  }
  for (int i = 0, j = 1; i < n; ++i, j = (j + 1) % n)
  {
    const double left = 360.0 * i / n;
    const double step = 360.0 / n;
    const vtkIdType waist = Polar(model, 1.85, left + 0.5 * step, 0.3);
    const Ids middle{ Polar(model, 2.65, left + 0.04 * step, 0.4),
      Polar(model, 2.75, left + 0.5 * step, 0.65), Polar(model, 2.65, left + 0.96 * step, 0.4) };
    const Ids tip{ Polar(model, 3.4, left + 0.2 * step, 0.95),
      Polar(model, 3.75, left + 0.5 * step, 1.05), Polar(model, 3.4, left + 0.8 * step, 0.95) };
    model.Triangle(ring[i], notch[i], waist);
    model.Triangle(ring[i], waist, ring[j]);
    model.Triangle(ring[j], waist, notch[j]);
    model.Strip({ notch[i], waist, notch[j] }, middle);
    model.Strip(middle, tip);
  }
}

/// A leaf that grows from `base` toward the angle `degrees`, with a midrib.
void Leaf(ModelBuilder& model, vtkIdType base, double degrees)
{
  const Vector origin = model[base];
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const auto at = [&](double along, double across, double up)
  {
    return model.Point(origin[0] + along * std::cos(angle) - across * std::sin(angle),
      origin[1] + along * std::sin(angle) + across * std::cos(angle), origin[2] + up);
  };
  const Ids low{ at(0.5, 0.4, 0.45), at(0.55, 0.0, 0.3), at(0.5, -0.4, 0.45) };
  const Ids high{ at(1.3, 0.5, 0.75), at(1.4, 0.0, 0.6), at(1.3, -0.5, 0.75) };
  model.Fan(base, low);
  model.Strip(low, high);
  model.Fan(at(2.3, 0.0, 0.5), high);
}

}

void BuildMixedDimensions(ModelBuilder& model)
{
  model.Tension = [](const Vector& x)
  { return 1.0 - 0.25 * std::hypot(x[0], x[1]) + 0.15 * std::sin(3.0 * x[2]); };
  vtkIdType foot = -1;
  model.Material = 2;
  const Ids ring = FlowerHead(model, foot);
  model.Material = 1;
  Petals(model, ring);

  Ids stem{ foot };
  for (int i = 1; i <= 8; ++i)
  {
    stem.push_back(model.Point(0.35 * std::sin(0.8 * i), 0.2 * std::sin(0.6 * i), -0.7 - 0.5 * i));
  }
  Leaf(model, stem[4], 200.0);
  Leaf(model, stem[6], 20.0);
  model.Material = 0;
  model.Polyline(stem);
}

void BuildScrew(ModelBuilder& model)
{
  model.Tension = [](const Vector& x) { return std::hypot(x[0], x[1]) - 0.25 * x[2]; };
  const vtkIdType centre = model.Point(0.0, 0.0, 0.0);
  const vtkIdType tip = model.Point(0.0, 0.0, -3.2);
  const vtkIdType head = model.Point(0.0, 0.0, 2.8);
  const Ids low = model.Ring(4, 1.0, -1.3, 0.0);
  const Ids high = model.Ring(4, 1.0, 1.3, 60.0);
  const Ids lowRim = model.Ring(4, 2.6, -1.7, -10.0);
  const Ids highRim = model.Ring(4, 2.6, 1.3, 80.0);
  for (int i = 0, j = 1; i < 4; ++i, j = (j + 1) % 4)
  {
    model.Material = 1; // the core
    model.Tetrahedron(centre, tip, low[i], low[j]);
    model.Tetrahedron(centre, low[i], low[j], high[i]);
    model.Tetrahedron(centre, low[j], high[i], high[j]);
    model.Tetrahedron(centre, head, high[i], high[j]);
    model.Material = 0; // a blade, along a rising edge of the core
    model.Triangle(low[i], lowRim[i], high[i]);
    model.Triangle(lowRim[i], highRim[i], high[i]);
  }
}

void BuildMaterialBlock(ModelBuilder& model)
{
  vtkIdType grid[3][3][4];
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        // A steady rise with a strong change of sign from one vertex to the next.
        const double sign = (i + j + k) % 2 == 0 ? 1.0 : -1.0;
        model.Tension = [=](const Vector&) { return 0.5 * k + sign * (1.0 + 0.25 * (i + 2 * j)); };
        grid[i][j][k] = model.Point(i, j, k);
      }
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 2; ++j)
    {
      for (int i = 0; i < 2; ++i)
      {
        model.Material = k > i ? 1 : 0; // the interface is a step
        const auto quad = [&](int z)
        {
          return Ids{ grid[i][j][z], grid[i + 1][j][z], grid[i + 1][j + 1][z], grid[i][j + 1][z] };
        };
        model.Hexahedron(quad(k), quad(k + 1));
      }
    }
  }
}

void BuildCylinder(ModelBuilder& model)
{
  constexpr int sides = 8;
  model.Tension = [](const Vector& x) { return 0.5 * x[2] - 0.3 * std::hypot(x[0], x[1]); };
  Ids axis;
  std::vector<Ids> inner;
  std::vector<Ids> outer;
  for (int level = 0; level < 4; ++level)
  {
    axis.push_back(model.Point(0.0, 0.0, level));
    inner.push_back(model.Ring(sides, 0.75, level));
    outer.push_back(model.Ring(sides, 1.5, level));
  }
  for (int low = 0, high = 1; high < 4; ++low, ++high)
  {
    for (int i = 0, j = 1; i < sides; ++i, j = (j + 1) % sides)
    {
      model.Hexahedron({ axis[low], inner[low][i], inner[low][j], axis[low] },
        { axis[high], inner[high][i], inner[high][j], axis[high] });
      model.Hexahedron({ inner[low][i], outer[low][i], outer[low][j], inner[low][j] },
        { inner[high][i], outer[high][i], outer[high][j], inner[high][j] });
    }
  }
  model.Material = 1; // the rims
  model.Polyline(outer.front(), ModelBuilder::SINGULAR, true);
  model.Polyline(outer.back(), ModelBuilder::SINGULAR, true);
}

}
