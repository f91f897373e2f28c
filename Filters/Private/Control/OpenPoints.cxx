// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/OpenPoints.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

namespace subdivision
{
namespace
{

/// How often each item is named: 0, 1, or 2 for more.
template <typename Id>
Buffer<unsigned char> CountUses(const Buffer<Id>& named, vtkIdType size)
{
  Buffer<unsigned char> uses(size, 0);
  for (const Id item : InTurn(named))
  {
    uses[item] = static_cast<unsigned char>(uses[item] + (uses[item] < 2 ? 1 : 0));
  }
  return uses;
}

/// Calls use(vertices, size) for each open part of the border.
template <typename Id, typename Use>
void ForOpenParts(const SimplicialComplex<Id>& complex, const Use& use)
{
  if (complex.NumberOfTets > 0)
  {
    ForEachInTurn(complex.NumberOfFaces,
      [&](vtkIdType face)
      {
        if (complex.FaceTets[face].size() < 2)
        {
          use(complex.FaceVertices.data() + 3 * face, 3);
        }
      });
    ForEachInTurn(complex.NumberOfLineCells,
      [&](vtkIdType line) { use(complex.EdgeVertices.data() + 2 * line, 2); });
  }
  else if (complex.NumberOfFaces > 0)
  {
    const Buffer<unsigned char> uses = CountUses(complex.FaceEdges, complex.NumberOfEdges);
    ForEachInTurn(complex.NumberOfEdges,
      [&](vtkIdType edge)
      {
        if (uses[edge] < 2)
        {
          use(complex.EdgeVertices.data() + 2 * edge, 2);
        }
      });
  }
  else
  {
    const Buffer<unsigned char> uses = CountUses(complex.EdgeVertices, complex.NumberOfVertices);
    ForEachInTurn(complex.NumberOfVertices,
      [&](vtkIdType vertex)
      {
        const Id end = static_cast<Id>(vertex);
        if (uses[vertex] == 1)
        {
          use(&end, 1);
        }
      });
  }
}

template <typename Id, typename Use>
void ForOpenParts(const PolygonMesh<Id>& mesh, const Use& use)
{
  ForEachInTurn(mesh.EdgeCorners.size(),
    [&](vtkIdType edge)
    {
      const Id corner = mesh.EdgeCorners[edge];
      if (corner < 0 || mesh.Twins[corner] < 0) // edges of three faces, too, which are few
      {
        use(mesh.EdgeVertices.data() + 2 * edge, 2);
      }
    });
}

/// Of points at one place, the table has the first that was added.
class PlaceTable
{
public:
  PlaceTable() = default;
  PlaceTable(const double* coordinates, vtkIdType size)
    : Points(coordinates)
  {
    vtkIdType slots = 16;
    while (slots < 2 * size)
    {
      slots *= 2;
    }
    this->Slots = Buffer<vtkIdType>(slots, -1);
  }
  vtkIdType FindOrAdd(vtkIdType point)
  {
    const double* x = this->Points + 3 * point;
    const auto mask = static_cast<unsigned long long>(this->Slots.size() - 1);
    unsigned long long i = this->Hash(x) & mask;
    for (;; i = (i + 1) & mask)
    {
      vtkIdType& slot = this->Slots[static_cast<vtkIdType>(i)];
      if (slot < 0)
      {
        slot = point;
      }
      if (slot == point || std::equal(x, x + 3, this->Points + 3 * slot))
      {
        return slot;
      }
    }
  }

private:
  static unsigned long long Hash(const double* x)
  {
    unsigned long long hash = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double value = x[k] + 0.; // -0 is 0
      unsigned long long bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
      hash ^= hash >> 32;
    }
    return hash;
  }

  const double* Points = nullptr;
  Buffer<vtkIdType> Slots; ///< -1: empty
};

/// The points of a border, and whether parts of it are at one place.
class Border
{
public:
  Border(vtkIdType points, const double* coordinates)
    : Points(coordinates)
    , States(points, 0)
  {
  }
  template <typename Id>
  void AddPoints(const Id* vertices, int size)
  {
    std::for_each(vertices, vertices + size, [this](Id vertex) { this->States[vertex] = Open; });
  }
  /// Finds the points at one place. Returns whether there are any.
  bool FindPlaces()
  {
    this->Places =
      PlaceTable(this->Points, std::count(this->States.begin(), this->States.end(), Open));
    ForEachInTurn(this->States.size(),
      [this](vtkIdType point)
      {
        const vtkIdType first = this->States[point] == None ? point : this->Places.FindOrAdd(point);
        if (first != point)
        {
          this->Pair = this->Count++ == 0 ? std::array<vtkIdType, 2>{ first, point } : this->Pair;
          this->States[point] = Shared;
          this->States[first] = Shared;
        }
      });
    return this->Count > 0;
  }
  /// Adds a part of the border; `isSingle`: whether it needs no other part to be joined with.
  template <typename Id>
  void AddPart(const Id* vertices, int size, bool isSingle)
  {
    const auto isShared = [this](Id vertex) { return this->States[vertex] == Shared; };
    const bool mayJoin = isSingle ? std::all_of(vertices, vertices + size, isShared)
                                  : std::any_of(vertices, vertices + size, isShared);
    if (this->Joins || !mayJoin)
    {
      return;
    }
    std::array<vtkIdType, 3> places = { -1, -2, -3 };
    std::transform(vertices, vertices + size, places.begin(),
      [this](Id vertex) { return this->Places.FindOrAdd(vertex); });
    std::sort(places.begin(), places.end());
    const bool hasSize = std::adjacent_find(places.begin(), places.end()) == places.end();
    this->Joins = hasSize && (isSingle || !this->Parts.insert(places).second);
  }
  std::string Describe() const
  {
    if (!this->Joins)
    {
      return {};
    }
    return std::to_string(this->Count) +
      (this->Count == 1 ? " point where cells end is" : " points where cells end are") +
      " at the place of another (for instance points " + std::to_string(this->Pair[0]) + " and " +
      std::to_string(this->Pair[1]) +
      "), and cells that do not share points come apart there. If they should be joined, switch "
      "MergePoints on, or apply vtkStaticCleanUnstructuredGrid (surfaces: vtkCleanPolyData) first.";
  }

private:
  enum State : unsigned char
  {
    None,
    Open,
    Shared
  };

  const double* Points;
  Buffer<unsigned char> States; ///< of each point
  PlaceTable Places;
  vtkIdType Count = 0;
  std::array<vtkIdType, 2> Pair = { -1, -1 };
  std::set<std::array<vtkIdType, 3>> Parts; ///< by their places, until two are equal
  bool Joins = false;
};

template <typename Mesh>
std::string Describe(const Mesh& mesh, bool hasSolids, const Coordinates& coordinates)
{
  Border border(mesh.NumberOfVertices, coordinates);
  ForOpenParts(mesh, [&](const auto* vertices, int size) { border.AddPoints(vertices, size); });
  if (border.FindPlaces())
  {
    ForOpenParts(mesh, [&](const auto* vertices, int size)
      { border.AddPart(vertices, size, hasSolids && size == 2); });
  }
  return border.Describe();
}

}

template <typename Id>
std::string DescribeCoincident(const SimplicialComplex<Id>& complex, const Coordinates& coordinates)
{
  return Describe(complex, complex.NumberOfTets > 0, coordinates);
}

template <typename Id>
std::string DescribeCoincidentOfSurface(const PolygonMesh<Id>& mesh, const Coordinates& coordinates)
{
  return Describe(mesh, false, coordinates);
}

SUBDIVISION_COMPILE_FUNCTION(DescribeCoincident);
SUBDIVISION_COMPILE_FUNCTION(DescribeCoincidentOfSurface);

}
