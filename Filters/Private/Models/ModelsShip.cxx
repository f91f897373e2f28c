// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModelsShip.cxx
 * A ship: x runs from the stern to the bow, y from the middle to the side, z up. One half is built,
 * the other is its mirror image.
 */
#include "Private/Models/Models.h"

#include <cmath>
#include <utility>

namespace subdivision
{

namespace
{

using Ids = ModelBuilder::Ids;
using Vector = ModelBuilder::Vector;

enum Material
{
  Hull,
  Decks,
  Bow,
  House,
  Rigging
};

constexpr int Stations = 9; // along the ship; the last one is the stem, a single line
constexpr int Bulkhead = 5; // the station where the solid bow begins
constexpr int Columns = 3;  // from the middle to the side

/// Heights: the bottom, two decks and the rail.
enum Level
{
  Bottom,
  LowerDeck,
  MainDeck,
  Rail,
  NumberOfLevels
};

struct Lines
{
  vtkIdType At[Stations][Columns][NumberOfLevels];
};

/// Where the hull lines run.
Vector HullPoint(int station, int column, int level)
{
  const double x[Stations] = { 0.0, 1.2, 2.4, 3.5, 4.6, 5.7, 6.8, 7.8, 8.6 };
  const double halfBreadth[Stations] = { 1.15, 1.4, 1.5, 1.55, 1.55, 1.45, 1.25, 0.85, 0.0 };
  const double flare[NumberOfLevels] = { 0.8, 0.98, 1.05, 1.15 };
  const double height[NumberOfLevels] = { 0.0, 0.8, 1.6, 2.15 };
  const double across = column / (Columns - 1.0);
  const double forward = station > 4 ? (x[station] - x[4]) / (x[Stations - 1] - x[4]) : 0.0;
  const double rise =
    level == Bottom ? 0.3 * across * across * (1.0 - 0.7 * forward) + 0.25 * forward : 0.0;
  const double sheer = 0.22 * level * forward * forward;
  const double rake = 0.3 * level * forward * forward;
  return { x[station] + rake, halfBreadth[station] * flare[level] * across,
    height[level] + rise + sheer };
}

/// The points of the hull that are used: the rail has only its side and the stern.
Lines MakeLines(ModelBuilder& model)
{
  Lines lines;
  for (int i = 0; i < Stations; ++i)
  {
    for (int level = 0; level < NumberOfLevels; ++level)
    {
      for (int j = 0; j < Columns; ++j)
      {
        const bool open = level == Rail && i > 0 && j + 1 < Columns;
        const bool stem = i + 1 == Stations && j > 0;
        lines.At[i][j][level] = stem ? lines.At[i][0][level]
          : open && i + 1 < Stations ? -1
                                     : model.Point(HullPoint(i, j, level));
      }
    }
  }
  return lines;
}

void SolidBow(ModelBuilder& model, const Lines& lines)
{
  model.Material = Bow;
  for (int i = Bulkhead; i + 1 < Stations; ++i)
  {
    for (int j = 0; j + 1 < Columns; ++j)
    {
      for (int level = Bottom; level < MainDeck; ++level)
      {
        const auto quad = [&](int z)
        {
          return Ids{ lines.At[i][j][z], lines.At[i + 1][j][z], lines.At[i + 1][j + 1][z],
            lines.At[i][j + 1][z] };
        };
        model.Hexahedron(quad(level), quad(level + 1));
      }
    }
  }
}

void HullAndDecks(ModelBuilder& model, const Lines& lines)
{
  constexpr int side = Columns - 1;
  const auto floor = [&](int i, int level)
  {
    for (int j = 0; j < side; ++j)
    {
      model.Quad(lines.At[i][j][level], lines.At[i + 1][j][level], lines.At[i + 1][j + 1][level],
        lines.At[i][j + 1][level]);
    }
  };
  const auto shell = [&](int i, int level)
  {
    model.Quad(lines.At[i][side][level], lines.At[i + 1][side][level],
      lines.At[i + 1][side][level + 1], lines.At[i][side][level + 1]);
  };
  model.Material = Hull;
  for (int level = Bottom; level < Rail; ++level) // the transom
  {
    for (int j = 0; j < side; ++j)
    {
      model.Quad(lines.At[0][j][level], lines.At[0][j + 1][level], lines.At[0][j + 1][level + 1],
        lines.At[0][j][level + 1]);
    }
  }
  for (int i = 0; i + 1 < Stations; ++i)
  {
    if (i < Bulkhead)
    {
      floor(i, Bottom);
      shell(i, Bottom);
      shell(i, LowerDeck);
    }
    shell(i, MainDeck);
  }
  model.Material = Decks;
  for (int i = 0; i < Bulkhead; ++i)
  {
    floor(i, LowerDeck);
    floor(i, MainDeck);
  }
}

/// Walls and a roof over the rows `middle` and `side` of the floor; returns the rows of the roof.
std::pair<Ids, Ids> Cabin(
  ModelBuilder& model, const Ids& middle, const Ids& side, double height, double slope)
{
  Ids roofMiddle, roofSide;
  const double centre = 0.5 * (model[middle.front()][0] + model[middle.back()][0]);
  for (std::size_t i = 0; i < middle.size(); ++i)
  {
    const Vector& m = model[middle[i]];
    const Vector& s = model[side[i]];
    const double x = centre + slope * (m[0] - centre);
    const double y = slope * s[1];
    const double z = m[2] + height;
    roofMiddle.push_back(model.Point(x, 0.0, z + 0.05));
    roofSide.push_back(model.Point(x, y, z));
  }
  model.Strip(side, roofSide);
  model.Strip(roofMiddle, roofSide);
  model.Quad(middle.front(), side.front(), roofSide.front(), roofMiddle.front());
  model.Quad(middle.back(), side.back(), roofSide.back(), roofMiddle.back());
  return { roofMiddle, roofSide };
}

/// Two storeys on the main deck, a mast and a bowsprit.
void HouseAndRigging(ModelBuilder& model, const Lines& lines)
{
  Ids middle, side;
  for (int i = 1; i < Bulkhead; ++i)
  {
    middle.push_back(lines.At[i][0][MainDeck]);
    side.push_back(lines.At[i][1][MainDeck]);
  }
  model.Material = House;
  auto [roofMiddle, roofSide] = Cabin(model, middle, side, 0.95, 0.95);
  roofMiddle.erase(roofMiddle.begin());
  roofSide.erase(roofSide.begin());
  const auto bridge = Cabin(model, roofMiddle, roofSide, 0.85, 1.0);

  model.Material = Rigging;
  Ids mast{ bridge.first[1] };
  const Vector foot = model[mast[0]];
  for (int i = 1; i <= 4; ++i)
  {
    mast.push_back(model.Point(foot[0] - 0.08 * i, 0.0, foot[2] + 0.45 * i));
  }
  model.Polyline(mast);
  Ids bowsprit{ lines.At[Stations - 1][0][Rail] };
  const Vector stem = model[bowsprit[0]];
  for (int i = 1; i <= 3; ++i)
  {
    bowsprit.push_back(model.Point(stem[0] + 0.5 * i, 0.0, stem[2] + 0.2 * i));
  }
  model.Polyline(bowsprit);
}

}

void BuildShip(ModelBuilder& model)
{
  model.Tension = [](const Vector& x) { return std::sin(0.9 * x[0]) + 0.5 * x[2] - 0.4 * x[1]; };
  const Lines lines = MakeLines(model);
  SolidBow(model, lines);
  HullAndDecks(model, lines);
  HouseAndRigging(model, lines);
  model.Mirror(1);
}

}
