// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexRow.h
 * Weighted sums over vertices of one level, whatever names the vertices, and their numbers.
 */
#ifndef SubdivisionObjects_VertexRow_h
#define SubdivisionObjects_VertexRow_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace subdivision
{

template <typename VertexType>
struct VertexRow
{
  using Vertex = VertexType;

  std::vector<Vertex> Vertices;
  std::vector<double> Weights;

  void Clear()
  {
    this->Vertices.clear();
    this->Weights.clear();
  }
  void Add(const Vertex& vertex, double weight)
  {
    this->Vertices.push_back(vertex);
    this->Weights.push_back(weight);
  }
};

/// Up to four vertices, ascending, and their weights; -1: there are no more.
using WeightedVertices = std::array<std::pair<vtkIdType, int>, 4>;

/// A vertex of a level by its number there.
template <typename Id>
struct LevelVertex
{
  int Level;
  Id Number;

  bool operator==(const LevelVertex& other) const
  {
    return this->Level == other.Level && this->Number == other.Number;
  }
  std::uint64_t GetHash() const
  {
    const std::uint64_t hash = static_cast<std::uint64_t>(this->Number) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 32;
  }
  Id GetColumn() const { return this->Number; }
};

/// Numbers vertices, or other things that are ids, or have GetHash() and can be compared, in the
/// order in which they first come, with a hash table.
template <typename Vertex>
class VertexNumbers
{
public:
  void Clear()
  {
    const bool isSparse =
      this->Slots.size() > First && 8 * this->Vertices.size() < this->Slots.size();
    this->Slots.assign(this->Slots.size() / (isSparse ? 2 : 1), -1);
    this->Vertices.clear();
  }
  /// The number of a vertex. A new one gets the next, which is how many there were.
  std::size_t GetNumber(const Vertex& vertex)
  {
    if (2 * (this->Vertices.size() + 1) > this->Slots.size())
    {
      this->Grow();
    }
    int& slot = this->Slots[this->Locate(vertex)];
    if (slot < 0)
    {
      slot = static_cast<int>(this->Vertices.size());
      this->Vertices.push_back(vertex);
    }
    return static_cast<std::size_t>(slot);
  }

  /// The number of a vertex; -1: it has none.
  std::ptrdiff_t Find(const Vertex& vertex) const { return this->Slots[this->Locate(vertex)]; }

  std::vector<Vertex> Vertices; ///< by their numbers

private:
  static constexpr std::size_t First = 64; ///< slots

  static std::uint64_t Hash(const Vertex& vertex)
  {
    if constexpr (std::is_integral<Vertex>::value)
    {
      return (static_cast<std::uint64_t>(vertex) * 0x9e3779b97f4a7c15u) >> 32;
    }
    else
    {
      return vertex.GetHash();
    }
  }
  /// The slot that has the vertex, or the empty one where it belongs.
  std::size_t Locate(const Vertex& vertex) const
  {
    for (std::uint64_t hash = Hash(vertex);; ++hash)
    {
      const std::size_t at = hash & (this->Slots.size() - 1);
      const int slot = this->Slots[at];
      if (slot < 0 || this->Vertices[static_cast<std::size_t>(slot)] == vertex)
      {
        return at;
      }
    }
  }
  void Grow()
  {
    this->Slots.assign(2 * this->Slots.size(), -1);
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      this->Slots[this->Locate(this->Vertices[i])] = static_cast<int>(i);
    }
  }

  std::vector<int> Slots = std::vector<int>(First, -1); ///< a power of two
};

}

#endif
