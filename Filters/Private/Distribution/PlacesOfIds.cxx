// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/PlacesOfIds.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Runs.h"
#include "Core/Memory/Sorting.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

namespace subdivision
{
namespace
{

using Parts = std::vector<std::vector<MeshPart>>;
using Warn = std::function<void(const std::string&)>;

struct PlaceOfId
{
  vtkIdType Id;
  std::array<double, 3> At;
  double Tolerance;
  int Block;
  vtkIdType Variant;
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

/// Sets the variants of points of one id. Returns one that is not at the place of the first; null:
/// all are.
const PlaceOfId* SetVariants(PlaceOfId** begin, PlaceOfId** end)
{
  std::vector<PlaceOfId*> others;
  std::copy_if(begin, end, std::back_inserter(others),
    [begin](const PlaceOfId* point) { return !AreNear(**begin, *point); });
  std::sort(others.begin(), others.end(),
    [](const PlaceOfId* a, const PlaceOfId* b) { return a->At < b->At; });
  for (size_t i = 0; i < others.size(); ++i)
  {
    others[i]->Variant =
      i == 0 ? 1 : others[i - 1]->Variant + (others[i]->At != others[i - 1]->At ? 1 : 0);
  }
  return others.empty() ? nullptr : others[0];
}

std::string DescribePlaces(vtkIdType count, const PlaceOfId& a, const PlaceOfId& b)
{
  std::ostringstream text;
  text << "Points at different places have the same global id, " << count
       << " ids in all; the first is " << a.Id;
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

/// Sets the variants of the points that this directory knows. Returns whether there are some.
bool CompareIds(Exchange::Lists<PlaceOfId>& asked, const Warn& warn)
{
  std::vector<PlaceOfId*> points;
  for (auto& [from, list] : asked)
  {
    for (PlaceOfId& point : InTurn(list))
    {
      points.push_back(&point);
    }
  }
  StableSort(points, [](const PlaceOfId* a, const PlaceOfId* b) { return a->Id < b->Id; });
  vtkIdType several = 0;
  const PlaceOfId* first[2] = {};
  ForEachRun(
    points, [](const PlaceOfId* point) { return point->Id; },
    [&](size_t begin, size_t end)
    {
      const PlaceOfId* other = SetVariants(points.data() + begin, points.data() + end);
      if (other && several++ == 0)
      {
        first[0] = points[begin];
        first[1] = other;
      }
    });
  if (several > 0)
  {
    warn(DescribePlaces(several, *first[0], *first[1]));
  }
  return several > 0;
}

/// Calls visit(point, index) for the points of a part that have an id.
template <typename Visit>
void ForEachPoint(const MeshPart& part, const Visit& visit)
{
  const double tolerance = 1e-6 * part.Mesh->GetLength();
  for (const size_t i : InTurn(part.Points.size()))
  {
    PlaceOfId point{ part.Points[i], {}, tolerance, part.Index, 0 };
    if (point.Id >= 0)
    {
      part.Mesh->GetPoint(static_cast<vtkIdType>(i), point.At.data());
      visit(point, i);
    }
  }
}

}

bool FindPlacesOfIds(Parts& parts, Exchange& exchange, const Warn& warn)
{
  const int partitions = exchange.GetNumberOfPartitions();
  std::vector<Exchange::Lists<PlaceOfId>> lists(parts.size());
  std::vector<Exchange::Lists<vtkIdType*>> variants(parts.size()); // of the points in the lists
  for (size_t p = 0; p < parts.size(); ++p)
  {
    for (MeshPart& part : parts[p])
    {
      part.Variants.assign(part.Points.size(), 0);
      ForEachPoint(part,
        [&](const PlaceOfId& point, size_t i)
        {
          lists[p][static_cast<int>(point.Id % partitions)].push_back(point);
          variants[p][static_cast<int>(point.Id % partitions)].push_back(&part.Variants[i]);
        });
    }
  }
  std::vector<Exchange::Lists<PlaceOfId>> asked = exchange.SendLists(lists);
  bool areSame = true;
  for (Exchange::Lists<PlaceOfId>& list : asked)
  {
    areSame = !CompareIds(list, warn) && areSame;
  }
  const bool areSeveral = !exchange.Agree(areSame);
  if (areSeveral)
  {
    const std::vector<Exchange::Lists<PlaceOfId>> answers = exchange.SendLists(asked);
    for (size_t p = 0; p < parts.size(); ++p)
    {
      for (const auto& [from, list] : answers[p])
      {
        for (size_t i = 0; i < list.size(); ++i)
        {
          *variants[p][from][i] = list[i].Variant;
        }
      }
    }
  }
  return areSeveral;
}

bool HavePlacesOfIds(const Parts& parts, Exchange& exchange)
{
  bool areSame = true;
  for (const std::vector<MeshPart>& partition : parts)
  {
    Exchange::Lists<PlaceOfId> points;
    for (const MeshPart& part : partition)
    {
      ForEachPoint(part, [&](const PlaceOfId& point, size_t) { points[0].push_back(point); });
    }
    areSame = !CompareIds(points, [](const std::string&) {}) && areSame;
  }
  return exchange.Agree(areSame);
}

}
