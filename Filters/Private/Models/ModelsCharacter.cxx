// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModelsCharacter.cxx
 * A small hero with big ears: x runs to its left hand, y backward, z up. One half is built, the
 * other is its mirror image.
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

enum Material
{
  Body,
  Head,
  Limbs,
  Cape,
  Hair,
  Goggles
};

/// Half of a cross-section of the body: the middle and five points from the front to the back.
struct Section
{
  vtkIdType Middle, Front, FrontSide, Side, BackSide, Back;
};

Section MakeSection(ModelBuilder& model, double z, double width, double depth, double nose = 0.0)
{
  Section s;
  s.Middle = model.Point(0.0, 0.0, z);
  s.Front = model.Point(0.0, -depth - nose, z);
  s.Back = model.Point(0.0, depth, z);
  s.Side = model.Point(width, 0.0, z);
  s.FrontSide = model.Point(0.68 * width, -0.8 * depth, z);
  s.BackSide = model.Point(0.68 * width, 0.8 * depth, z);
  return s;
}

void Solid(ModelBuilder& model, const Section& a, const Section& b)
{
  model.Hexahedron(
    { a.Middle, a.Front, a.FrontSide, a.Side }, { b.Middle, b.Front, b.FrontSide, b.Side });
  model.Hexahedron(
    { a.Middle, a.Side, a.BackSide, a.Back }, { b.Middle, b.Side, b.BackSide, b.Back });
}

/// Six points around `centre`, in the plane of the y axis and the direction (cos, sin) of `degrees`
/// in the xz plane.
Ids Hexagon(ModelBuilder& model, const Vector& centre, double radius, double degrees, double phase)
{
  Ids ids;
  const double tilt = vtkMath::RadiansFromDegrees(degrees);
  for (int i = 0; i < 6; ++i)
  {
    const double angle = vtkMath::RadiansFromDegrees(60.0 * i + phase);
    const double across = radius * std::cos(angle);
    ids.push_back(model.Point(centre[0] + across * std::cos(tilt),
      centre[1] + radius * std::sin(angle), centre[2] + across * std::sin(tilt)));
  }
  return ids;
}

/// One station of a limb: where, how wide, and the direction of the section's first axis.
struct Station
{
  Vector Centre;
  double Radius;
  double Degrees;
};

void Limb(ModelBuilder& model, Ids from, const std::vector<Station>& stations, double phase)
{
  for (const Station& s : stations)
  {
    const Ids section = Hexagon(model, s.Centre, s.Radius, s.Degrees, phase);
    model.Strip(from, section, true);
    from = section;
  }
  const Vector& last = stations.back().Centre;
  const Vector& other = stations[stations.size() - 2].Centre;
  Vector end;
  for (int i = 0; i < 3; ++i)
  {
    end[i] = last[i] + 0.4 * (last[i] - other[i]);
  }
  model.Fan(model.Point(end), from, true);
}

/// A solid ball of eight tetrahedra that hangs on `anchor`, centred at `centre`.
void Bead(ModelBuilder& model, vtkIdType anchor, const Vector& centre)
{
  const auto beyond = [&](const Vector& from)
  {
    return Vector{ 2.0 * centre[0] - from[0], 2.0 * centre[1] - from[1],
      2.0 * centre[2] - from[2] };
  };
  const Vector a = model[anchor];
  const double dx = a[0] - centre[0];
  const double dz = a[2] - centre[2];
  const Vector up{ centre[0] - dz, centre[1], centre[2] + dx };
  const Vector back{ centre[0], centre[1] + std::hypot(dx, dz), centre[2] };
  const vtkIdType middle = model.Point(centre);
  const vtkIdType far = model.Point(beyond(a));
  const Ids equator{ model.Point(up), model.Point(back), model.Point(beyond(up)),
    model.Point(beyond(back)) };
  for (int i = 0, j = 1; i < 4; ++i, j = (j + 1) % 4)
  {
    model.Tetrahedron(middle, anchor, equator[i], equator[j]);
    model.Tetrahedron(middle, far, equator[i], equator[j]);
  }
}

/// A solid bump on one face of the head.
void Goggle(ModelBuilder& model, const Ids& face)
{
  Vector centre{ 0.0, 0.0, 0.0 };
  for (vtkIdType id : face)
  {
    for (int i = 0; i < 3; ++i)
    {
      centre[i] += 0.25 * model[id][i];
    }
  }
  Ids front;
  for (vtkIdType id : face)
  {
    const Vector x = model[id];
    front.push_back(model.Point(0.25 * centre[0] + 0.75 * x[0] + 0.03,
      0.25 * centre[1] + 0.75 * x[1] - 0.45, 0.25 * centre[2] + 0.75 * x[2]));
  }
  model.Material = Goggles;
  model.Hexahedron(face, front);
}

void CapeFrom(ModelBuilder& model, const Section& shoulders)
{
  model.Material = Cape;
  Ids above{ shoulders.Back, shoulders.BackSide };
  const double rows[][3] = { { 3.3, 0.75, 0.75 }, { 2.4, 1.1, 0.95 }, { 1.5, 1.35, 1.25 },
    { 0.8, 1.8, 1.5 } }; // z, y, half width
  for (const auto& row : rows)
  {
    const double fold = 0.12 * row[1];
    const Ids below{ model.Point(0.0, row[1] + fold, row[0]),
      model.Point(0.55 * row[2], row[1] - fold, row[0]), model.Point(row[2], row[1], row[0]) };
    model.Strip({ above[0], above[1] }, { below[0], below[1] });
    if (above.size() == 2)
    {
      model.Triangle(above[1], below[2], below[1]);
    }
    else
    {
      model.Strip({ above[1], above[2] }, { below[1], below[2] });
    }
    above = below;
  }
}

void HeadParts(ModelBuilder& model, const Section& eyes, const Section& brow, const Section& crown)
{
  model.Material = Cape; // the ears
  model.Strip(
    { eyes.Side, brow.Side }, { model.Point(1.95, 0.2, 5.0), model.Point(1.95, 0.2, 6.5) });
  Goggle(model, { eyes.Front, eyes.FrontSide, brow.FrontSide, brow.Front });
  model.Material = Hair;
  const Ids antenna{ crown.FrontSide, model.Point(0.65, -0.5, 6.9), model.Point(0.8, -0.6, 7.25),
    model.Point(1.1, -0.7, 7.5), model.Point(1.5, -0.8, 7.5) };
  model.Polyline(antenna);
  model.Polyline({ crown.Middle, model.Point(0.0, -0.05, 6.95), model.Point(0.0, 0.2, 7.3),
    model.Point(0.0, 0.6, 7.3), model.Point(0.0, 0.7, 6.95), model.Point(0.0, 0.45, 6.85) });
  model.Material = Head;
  Bead(model, antenna.back(), { 1.85, -0.85, 7.35 });
}

}

void BuildCharacter(ModelBuilder& model)
{
  model.Tension = [](const Vector& x)
  { return std::sin(1.1 * x[2]) + 0.4 * std::abs(x[0]) - 0.3 * x[1]; };
  const Section pelvis = MakeSection(model, 1.9, 0.75, 0.5);
  const Section waist = MakeSection(model, 2.6, 0.65, 0.5);
  const Section chest = MakeSection(model, 3.2, 0.8, 0.55);
  const Section shoulders = MakeSection(model, 3.85, 0.75, 0.5);
  const Section neck = MakeSection(model, 4.2, 0.5, 0.45);
  const Section cheeks = MakeSection(model, 4.65, 1.2, 1.1);
  const Section eyes = MakeSection(model, 5.15, 1.35, 1.2, 0.4);
  const Section brow = MakeSection(model, 5.85, 1.25, 1.1);
  const Section crown = MakeSection(model, 6.4, 0.8, 0.7);
  model.Material = Body;
  Solid(model, pelvis, waist);
  Solid(model, waist, chest);
  Solid(model, chest, shoulders);
  Solid(model, shoulders, neck);
  model.Material = Head;
  Solid(model, neck, cheeks);
  Solid(model, cheeks, eyes);
  Solid(model, eyes, brow);
  Solid(model, brow, crown);

  model.Material = Limbs;
  Limb(model,
    { shoulders.FrontSide, shoulders.Side, shoulders.BackSide, chest.BackSide, chest.Side,
      chest.FrontSide },
    { { { 1.2, 0.0, 3.45 }, 0.36, 70.0 }, { { 1.6, 0.0, 3.1 }, 0.32, 40.0 },
      { { 1.9, -0.05, 2.6 }, 0.3, 25.0 }, { { 2.05, -0.1, 2.2 }, 0.42, 15.0 } },
    -60.0);
  Limb(model,
    { pelvis.Middle, pelvis.Front, pelvis.FrontSide, pelvis.Side, pelvis.BackSide, pelvis.Back },
    { { { 0.45, 0.0, 1.35 }, 0.38, 0.0 }, { { 0.48, 0.0, 0.8 }, 0.34, 0.0 },
      { { 0.5, -0.05, 0.35 }, 0.38, 0.0 }, { { 0.52, -0.3, 0.0 }, 0.5, 0.0 } },
    180.0);
  CapeFrom(model, shoulders);
  HeadParts(model, eyes, brow, crown);
  model.Mirror(0);
}

}
