// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Topology/SharedCounts.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Complex/Links.h"
#include "Private/Partitions/SharedDirectory.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

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

/// Two components of C_k that are one: k, then the partition and the number there of both.
using Link = std::array<vtkIdType, 5>;

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

/// The links between components at the vertices that this partition keeps.
std::set<Link> FindLinks(
  const OwnSimplices& own, const Buffer<vtkIdType> components[4], OtherPartitions& others)
{
  const std::vector<vtkIdType>& ids = others.GetPointIds();
  SharedKeys places;
  places.Width = 2;
  std::vector<vtkIdType> told;
  for (const vtkIdType vertex : InTurn(own.Shared))
  {
    for (int k = 1; k <= 3; ++k)
    {
      if (components[k][vertex] >= 0)
      {
        places.Keys.insert(places.Keys.end(), { ids[vertex], k });
        told.push_back(components[k][vertex]);
      }
    }
  }
  places.Own.assign(told.size(), 1);
  std::set<Link> links;
  SharedDirectory directory(places, 1, told, 0, others);
  directory.ForThings(
    [&links](auto first, auto last)
    {
      for (auto other = first + 1; other != last; ++other)
      {
        links.insert({ first->Key[1], first->From, *first->Told, other->From, *other->Told });
      }
    });
  return links;
}

/// How many components of each C_k are others of the same C_k too: in the first partition, 0 in all
/// others.
void CountJoined(const std::set<Link>& links, OtherPartitions& others, vtkIdType joined[4])
{
  std::vector<Link> all(links.begin(), links.end());
  others.BringTo(others.FindFirst(), all);
  std::map<std::array<vtkIdType, 3>, vtkIdType> nodes;
  const auto find = [&nodes](vtkIdType k, vtkIdType partition, vtkIdType component)
  {
    const std::array<vtkIdType, 3> node{ k, partition, component };
    return nodes.emplace(node, static_cast<vtkIdType>(nodes.size())).first->second;
  };
  Joins joins(2 * static_cast<vtkIdType>(all.size()));
  for (const auto& [k, partition, component, other, componentThere] : all)
  {
    joined[k] += joins.Join(find(k, partition, component), find(k, other, componentThere)) ? 1 : 0;
  }
}

}

template <typename Id>
ComplexNumbers CountTogether(const SimplicialComplex<Id>& complex,
  const ComplexDescription<Id>& description, const OwnSimplices& own, OtherPartitions& others)
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
  CountJoined(FindLinks(own, ofVertices, others), others, joined);
  ComplexNumbers numbers;
  for (int k = 0; k <= 3; ++k)
  {
    const Buffer<unsigned char>& flags = own.Flags[k];
    numbers.Counts[k] = others.Sum(std::count(flags.begin(), flags.end(), 1));
    numbers.Components[k] = others.Sum(components[k]) - others.Sum(joined[k]);
  }
  return numbers;
}

SUBDIVISION_COMPILE_FUNCTION(CountTogether);

}
