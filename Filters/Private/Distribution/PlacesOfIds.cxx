// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/PlacesOfIds.h"

#include "Core/Memory/Loops.h"
#include "Private/Distribution/PartitionsOfRank.h"
#include "Private/Partitions/SharedDirectory.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <sstream>
#include <vector>

namespace subdivision
{
namespace
{

/// The message about a point to the directory of ids.
struct PlaceOfId
{
  std::array<double, 3> At;
  double Tolerance;
  vtkIdType Block;
};
constexpr int SizeOfPlace = sizeof(PlaceOfId) / sizeof(vtkIdType);

struct PointOfId
{
  PlaceOfId Place;
  vtkIdType* Variant;
};

bool AreNear(const PlaceOfId& a, const PlaceOfId& b)
{
  const double tolerance = std::max(a.Tolerance, b.Tolerance);
  bool areFar = false;
  for (int c = 0; c < 3; ++c)
  {
    areFar = areFar || std::abs(a.At[c] - b.At[c]) > tolerance;
  }
  return !areFar;
}

/// Sets the variants of points of one id: 0 for points at the place of the first. Returns one that
/// is not there, if there is one.
const PointOfId* SetVariants(std::vector<PointOfId>& points)
{
  for (const PointOfId& point : points)
  {
    *point.Variant = 0;
  }
  const PlaceOfId first = points[0].Place;
  const auto others = std::stable_partition(points.begin(), points.end(),
    [&first](const PointOfId& point) { return AreNear(first, point.Place); });
  std::sort(others, points.end(),
    [](const PointOfId& a, const PointOfId& b) { return a.Place.At < b.Place.At; });
  for (auto point = others; point != points.end(); ++point)
  {
    *point->Variant = point == others
      ? 1
      : *(point - 1)->Variant + ((point - 1)->Place.At != point->Place.At ? 1 : 0);
  }
  return others == points.end() ? nullptr : &*others;
}

std::string DescribePlaces(vtkIdType count, vtkIdType id, const PlaceOfId& a, const PlaceOfId& b)
{
  std::ostringstream text;
  text << "Points at different places have the same global id, " << count
       << " ids in all; the first is " << id;
  for (const PlaceOfId& point : { a, b })
  {
    text << ", at (" << point.At[0] << ", " << point.At[1] << ", " << point.At[2] << ") in block "
         << point.Block;
  }
  text << ". They are not one point, and each stays where it is. If each block was numbered by "
          "itself, remove the array of global ids: blocks are joined where points have the same "
          "coordinates then.";
  return text.str();
}

}

bool FindPlacesOfIds(std::vector<MeshPart>& parts, Exchange& exchange,
  const std::function<void(const std::string&)>& warn)
{
  SharedKeys ids;
  std::vector<vtkIdType> told;
  for (MeshPart& part : parts)
  {
    part.Variants.assign(part.Points.size(), 0);
    PlaceOfId place{ {}, 1e-6 * part.Mesh->GetLength(), part.Index };
    for (const size_t i : InTurn(part.Points.size()))
    {
      ids.Keys.push_back(part.Points[i]);
      part.Mesh->GetPoint(static_cast<vtkIdType>(i), place.At.data());
      told.resize(told.size() + SizeOfPlace);
      std::memcpy(&*(told.end() - SizeOfPlace), &place, sizeof(place));
    }
  }
  ids.Own.assign(ids.Keys.size(), 1);
  SharedDirectory directory(ids, SizeOfPlace, told, 1, exchange);
  vtkIdType several = 0;
  vtkIdType id = 0; // the first of them, and two of its points
  PlaceOfId apart[2] = {};
  std::vector<PointOfId> points;
  directory.ForThings(
    [&](auto first, auto last)
    {
      points.clear();
      for (auto entry = first; entry != last; ++entry)
      {
        points.push_back({ {}, entry->Answer });
        std::memcpy(&points.back().Place, entry->Told, sizeof(PlaceOfId));
      }
      const PlaceOfId one = points[0].Place;
      const PointOfId* other = SetVariants(points);
      several += other ? 1 : 0;
      if (other && several == 1)
      {
        id = *first->Key;
        apart[0] = one;
        apart[1] = other->Place;
      }
    });
  if (several > 0)
  {
    warn(DescribePlaces(several, id, apart[0], apart[1]));
  }
  const bool areSeveral = !exchange.Agree(several == 0);
  if (areSeveral)
  {
    const std::vector<vtkIdType> variants = directory.TakeAnswers();
    auto variant = variants.begin();
    for (MeshPart& part : parts)
    {
      for (vtkIdType& own : part.Variants)
      {
        own = std::max<vtkIdType>(*variant++, 0);
      }
    }
  }
  return areSeveral;
}

bool HavePlacesOfIds(std::vector<MeshPart>& parts, Exchange& exchange)
{
  PartitionsOfRank alone;
  ExchangeOfAll own(alone);
  return exchange.Agree(!FindPlacesOfIds(parts, own, [](const std::string&) {}));
}

}
