// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/TouchingSides.h"

#include "Core/Memory/Sorting.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellFaces.h"
#include "Private/Reading/NearPoints.h"

#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace subdivision
{
namespace
{

using Pairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

std::uint64_t HashPlace(const double* x)
{
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k)
  {
    const double value = x[k] + 0.; // -0 is 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Points whose hashes meet: all that have equal coordinates, and a few others.
std::vector<vtkIdType> FindDoubled(vtkPoints* points)
{
  const vtkIdType size = points->GetNumberOfPoints();
  std::uint64_t bits = 1024;
  while (bits < 16 * static_cast<std::uint64_t>(size))
  {
    bits *= 2;
  }
  std::vector<bool> once(bits);
  std::vector<bool> twice(bits);
  const auto at = [&](vtkIdType i)
  {
    double x[3];
    points->GetPoint(i, x);
    return HashPlace(x) & (bits - 1);
  };
  bool isAny = false;
  for (const vtkIdType i : InTurn(size))
  {
    const std::uint64_t bit = at(i);
    twice[bit] = once[bit];
    isAny = isAny || once[bit];
    once[bit] = true;
  }
  std::vector<vtkIdType> doubled;
  for (vtkIdType i = 0; isAny && i < size; ++i)
  {
    if (twice[at(i)])
    {
      doubled.push_back(i);
    }
  }
  return doubled;
}

/// For points with equal coordinates, the first one of them; -1 for others. Empty if there are
/// none.
Buffer<vtkIdType> FindPlaces(vtkPoints* points)
{
  const std::vector<vtkIdType> doubled = FindDoubled(points);
  if (doubled.empty())
  {
    return {};
  }
  std::vector<double> x(3 * doubled.size());
  std::vector<vtkIdType> indices(doubled.size());
  std::iota(indices.begin(), indices.end(), vtkIdType(0));
  for (const std::size_t i : InTurn(doubled.size()))
  {
    points->GetPoint(doubled[i], x.data() + 3 * i);
  }
  const Buffer<vtkIdType> firsts = FindFirstOfNear(x.data(), indices, 0., PointOrder{});
  if (std::equal(firsts.begin(), firsts.end(), indices.begin()))
  {
    return {};
  }
  Buffer<vtkIdType> places(points->GetNumberOfPoints(), -1);
  for (const std::size_t i : InTurn(doubled.size()))
  {
    const auto first = static_cast<std::size_t>(firsts[static_cast<vtkIdType>(i)]);
    if (first != i)
    {
      places[doubled[i]] = places[doubled[first]] = doubled[first];
    }
  }
  return places;
}

/// An edge of a face: the places of its ends, the smaller one first, and the points there.
using Edge = std::array<vtkIdType, 4>;

class Sides
{
public:
  Sides(vtkPointSet* mesh, Buffer<vtkIdType> places)
    : Places(std::move(places))
    , IsBlocked(mesh->GetNumberOfPoints(), 0)
  {
    const CellReader cells(mesh);
    const CheckedCells checked = CheckCells(mesh, cells);
    CellFaces faces(mesh, cells);
    std::vector<vtkIdType> scratch;
    for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
    {
      const bool takesPart = TakesPart(checked.States[static_cast<std::size_t>(c)]);
      const int dimension = takesPart ? GetDimensionOfType(cells.GetCellType(c)) : 0;
      if (dimension >= 2)
      {
        faces.ForEach(c, cells.GetCell(c, scratch), [&](const vtkIdType* loop, vtkIdType size)
          { dimension == 2 ? this->AddFace(loop, size) : this->Block(loop, size); });
      }
    }
    StableSort(this->Edges, std::less<>());
  }

  Pairs FindPairs() const
  {
    Pairs pairs;
    const auto isSame = [](const Edge& a, const Edge& b) { return a[0] == b[0] && a[1] == b[1]; };
    for (std::size_t i = 0; i + 1 < this->Edges.size(); ++i)
    {
      const Edge& a = this->Edges[i];
      const Edge& b = this->Edges[i + 1];
      const bool isAlone = isSame(a, b) && (i == 0 || !isSame(this->Edges[i - 1], a)) &&
        (i + 2 == this->Edges.size() || !isSame(b, this->Edges[i + 2]));
      for (int end = 0; end < 2 && isAlone && !this->IsBlocked[a[0]] && !this->IsBlocked[a[1]];
        ++end)
      {
        if (a[2 + end] != b[2 + end])
        {
          pairs.emplace_back(a[2 + end], b[2 + end]);
        }
      }
    }
    return pairs;
  }

private:
  void AddFace(const vtkIdType* loop, vtkIdType size)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType a = loop[i];
      const vtkIdType b = loop[(i + 1) % size];
      const vtkIdType from = this->Places[a];
      const vtkIdType to = this->Places[b];
      if (from >= 0 && to >= 0 && from != to)
      {
        this->Edges.push_back(from < to ? Edge{ from, to, a, b } : Edge{ to, from, b, a });
      }
    }
    this->Ring.clear();
    std::for_each(loop, loop + size, [this](vtkIdType point)
      { this->Places[point] < 0 ? void() : this->Ring.push_back({ this->Places[point], point }); });
    std::sort(this->Ring.begin(), this->Ring.end());
    for (std::size_t i = 1; i < this->Ring.size(); ++i)
    {
      const auto& [place, point] = this->Ring[i];
      const bool isDouble = this->Ring[i - 1].first == place && this->Ring[i - 1].second != point;
      this->IsBlocked[place] |= isDouble ? 1 : 0;
    }
  }
  void Block(const vtkIdType* loop, vtkIdType size)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (this->Places[loop[i]] >= 0)
      {
        this->IsBlocked[this->Places[loop[i]]] = 1;
      }
    }
  }

  Buffer<vtkIdType> Places;
  Buffer<unsigned char> IsBlocked; ///< of the first point of each place
  std::vector<Edge> Edges;
  Pairs Ring; ///< places and points of a face
};

}

Pairs FindTouchingSides(vtkPointSet* readable)
{
  if (!readable->GetPoints())
  {
    return {};
  }
  Buffer<vtkIdType> places = FindPlaces(readable->GetPoints());
  return places.empty() ? Pairs() : Sides(readable, std::move(places)).FindPairs();
}

}
