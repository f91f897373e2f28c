// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Topology/SharedCounts.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Complex/Links.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace subdivision
{
namespace
{

/// Which of some nodes are joined.
class Joins
{
public:
  explicit Joins(vtkIdType size)
    : Parents(size)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), vtkIdType(0));
  }
  vtkIdType FindRoot(vtkIdType node)
  {
    while (this->Parents[node] != node)
    {
      node = this->Parents[node] = this->Parents[this->Parents[node]];
    }
    return node;
  }
  /// Returns whether they were not joined before.
  bool Join(vtkIdType a, vtkIdType b)
  {
    a = this->FindRoot(a);
    b = this->FindRoot(b);
    this->Parents[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  Buffer<vtkIdType> Parents;
};

/// A component of C_k at a vertex.
struct Place
{
  vtkIdType Point;
  vtkIdType Component;
  vtkIdType Dimension;
};

/// Two components of C_k that are one.
struct Link
{
  vtkIdType Dimension;
  std::pair<vtkIdType, vtkIdType> Ends[2]; ///< partition, component

  bool operator<(const Link& other) const
  {
    return std::tie(this->Dimension, this->Ends[0], this->Ends[1]) <
      std::tie(other.Dimension, other.Ends[0], other.Ends[1]);
  }
};

template <typename T>
void Append(const T& record, std::vector<char>& message)
{
  const char* bytes = reinterpret_cast<const char*>(&record);
  message.insert(message.end(), bytes, bytes + sizeof(T));
}

template <typename T, typename Use>
void ForRecords(const Partners::Messages& messages, const Use& use)
{
  for (const auto& [from, message] : messages)
  {
    for (std::size_t i = 0; i + sizeof(T) <= message.size(); i += sizeof(T))
    {
      T record;
      std::memcpy(static_cast<void*>(&record), message.data() + i, sizeof(T));
      use(from, record);
    }
  }
}

/// Finds the component of C_k of each vertex with own edges in it, -1 for others. Returns how many
/// there are.
template <typename Id>
vtkIdType FindOwnComponents(const SimplicialComplex<Id>& complex,
  const ComplexDescription<Id>& description, const OwnSimplices& own, int k,
  Buffer<vtkIdType>& components)
{
  Joins joins(complex.NumberOfVertices);
  components = Buffer<vtkIdType>(complex.NumberOfVertices, -1);
  for (const vtkIdType e : InTurn(complex.NumberOfEdges))
  {
    if (own.Flags[1][e] && (description.Facts[1][e].ManifoldDimensions & DimensionBit(k)))
    {
      const Id* ends = complex.EdgeVertices.data() + 2 * e;
      joins.Join(ends[0], ends[1]);
      components[ends[0]] = components[ends[1]] = 0;
    }
  }
  vtkIdType size = 0;
  for (const vtkIdType v : InTurn(complex.NumberOfVertices))
  {
    if (components[v] >= 0) // roots come first
    {
      const vtkIdType root = joins.FindRoot(v);
      components[v] = root == v ? size++ : components[root];
    }
  }
  return size;
}

/// The links between own components and components of others, for the first partition.
std::set<Link> FindLinks(
  const OwnSimplices& own, const Buffer<vtkIdType> components[4], Partners& partners)
{
  const std::vector<vtkIdType>& ids = partners.GetPointIds();
  Partners::Messages messages;
  for (const auto& [partition, vertex] : own.Holders)
  {
    for (int k = 1; k <= 3; ++k)
    {
      if (components[k][vertex] >= 0)
      {
        Append(Place{ ids[vertex], components[k][vertex], k }, messages[partition]);
      }
    }
  }
  std::set<Link> links;
  if (!partners.Send(messages))
  {
    return links;
  }
  ForRecords<Place>(messages,
    [&](int from, const Place& place)
    {
      const auto found = std::lower_bound(ids.begin(), ids.end(), place.Point);
      const vtkIdType component = found != ids.end() && *found == place.Point
        ? components[place.Dimension][found - ids.begin()]
        : -1;
      if (component >= 0)
      {
        links.insert({ place.Dimension,
          { { partners.GetPartition(), component }, { from, place.Component } } });
      }
    });
  return links;
}

/// How many components of each C_k are others of the same C_k too: in the first partition, 0 in all
/// others.
void CountJoined(const std::set<Link>& links, Partners& partners, vtkIdType joined[4])
{
  Partners::Messages messages;
  const int first = partners.FindFirst();
  for (const Link& link : links)
  {
    Append(link, messages[first]);
  }
  if (!partners.Send(messages))
  {
    return;
  }
  std::vector<Link> all;
  std::map<std::tuple<vtkIdType, vtkIdType, vtkIdType>, vtkIdType> nodes;
  const auto find = [&](const Link& link, int end)
  {
    const auto [partition, component] = link.Ends[end];
    return nodes
      .emplace(
        std::make_tuple(link.Dimension, partition, component), static_cast<vtkIdType>(nodes.size()))
      .first->second;
  };
  ForRecords<Link>(messages,
    [&](int, const Link& link)
    {
      all.push_back(link);
      find(link, 0);
      find(link, 1);
    });
  Joins joins(static_cast<vtkIdType>(nodes.size()));
  for (const Link& link : all)
  {
    joined[link.Dimension] += joins.Join(find(link, 0), find(link, 1)) ? 1 : 0;
  }
}

}

template <typename Id>
ComplexNumbers CountTogether(const SimplicialComplex<Id>& complex,
  const ComplexDescription<Id>& description, const OwnSimplices& own, Partners& partners)
{
  vtkIdType components[4] = { 0, 0, 0, 0 };
  Buffer<vtkIdType> ofVertices[4];
  for (int k = 1; k <= 3; ++k)
  {
    components[k] = FindOwnComponents(complex, description, own, k, ofVertices[k]);
  }
  for (const Id vertex : description.Order[0])
  {
    const bool isAlone = description.Facts[0][vertex].ManifoldDimensions == 0;
    components[0] += isAlone && own.Flags[0][vertex] ? 1 : 0;
  }
  vtkIdType joined[4] = { 0, 0, 0, 0 };
  CountJoined(FindLinks(own, ofVertices, partners), partners, joined);
  ComplexNumbers numbers;
  for (int k = 0; k <= 3; ++k)
  {
    const Buffer<unsigned char>& flags = own.Flags[k];
    numbers.Counts[k] = partners.Sum(std::count(flags.begin(), flags.end(), 1));
    numbers.Components[k] = partners.Sum(components[k]) - partners.Sum(joined[k]);
  }
  return numbers;
}

SUBDIVISION_COMPILE_FUNCTION(CountTogether);

}
