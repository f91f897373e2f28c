// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Strata/ComplexDescription.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/TupleIndex.h"
#include "Core/Solids/Complex/Links.h"

namespace subdivision
{
namespace
{

bool IsFlagged(const Buffer<unsigned char>& flags, vtkIdType i)
{
  return !flags.empty() && flags[i];
}

signed char GetDimension(Rule rule)
{
  return static_cast<signed char>(rule == Rule::RegularEdge ? Rule::Solid : rule);
}

/// Describes vertex or edge i; `boundary` tells whether it lies on the boundary of some C_k.
SimplexFacts Describe(unsigned char dimensions, vtkIdType valence, bool boundary, Stratum stratum,
  const Buffer<unsigned char>& singular, vtkIdType i)
{
  SimplexFacts facts;
  facts.Valence = static_cast<int>(valence);
  facts.ManifoldDimensions = dimensions;
  facts.NonManifoldType = static_cast<unsigned char>(stratum.GetType());
  facts.RuleDimension = GetDimension(stratum.GetRule());
  facts.Boundary = boundary;
  facts.Singular = IsFlagged(singular, i);
  return facts;
}

template <typename Id>
void DescribeVerticesAndEdges(const Links<Id>& links, const Strata<Id>& strata,
  const SingularSimplices& singular, ComplexDescription<Id>& description)
{
  const SimplicialComplex<Id>& complex = links.Complex;
  description.Facts[1] = Buffer<SimplexFacts>(complex.NumberOfEdges);
  ForEach(complex.NumberOfEdges,
    [&](vtkIdType i)
    {
      const Id edge = static_cast<Id>(i);
      const bool boundary =
        links.PlaceEdge(edge, 3) == Place::Boundary || links.PlaceEdge(edge, 2) == Place::Boundary;
      description.Facts[1][i] = Describe(links.EdgeDimensions(edge), links.EdgeFaces[i].size(),
        boundary, strata.Edges[i], singular.Edges, i);
    });
  description.Facts[0] = Buffer<SimplexFacts>(complex.NumberOfVertices);
  ForEach(complex.NumberOfVertices,
    [&](vtkIdType i)
    {
      const Id vertex = static_cast<Id>(i);
      bool boundary = false;
      for (int k = 1; k <= 3; ++k)
      {
        boundary = boundary || links.PlaceVertex(vertex, k) == Place::Boundary;
      }
      description.Facts[0][i] = Describe(links.VertexDimensions(vertex),
        links.VertexEdges[i].size(), boundary, strata.Vertices[i], singular.Vertices, i);
    });
}

template <typename Id>
void DescribeFaces(
  const Links<Id>& links, const SingularSimplices& singular, ComplexDescription<Id>& description)
{
  const SimplicialComplex<Id>& complex = links.Complex;
  description.Facts[2] = Buffer<SimplexFacts>(complex.NumberOfFaces);
  ForEach(complex.NumberOfFaces,
    [&](vtkIdType i)
    {
      const vtkIdType tets = complex.FaceTets[i].size();
      SimplexFacts& facts = description.Facts[2][i];
      facts.Valence = static_cast<int>(tets);
      facts.ManifoldDimensions = links.FaceDimension(static_cast<Id>(i));
      facts.NonManifoldType = tets > 2 ? 2 : 0;
      facts.RuleDimension = -1;
      facts.Boundary = tets == 1;
      facts.Singular = IsFlagged(singular.Faces, i);
    });
}

/// Simplices in the order of their sorted vertices: grouped by the smallest, then sorted.
template <int N, typename Id>
Buffer<Id> SortSimplices(const Buffer<Id>& vertices, Id numberOfVertices)
{
  const vtkIdType size = vertices.size() / N;
  Buffer<std::array<Id, N>> tuples(size);
  ForEach(size, [&](vtkIdType i) { tuples[i] = SortedTuple<N>(vertices.data() + N * i); });
  Rows<Id> lists = ListByRow<Id>(
    numberOfVertices, size, [&](vtkIdType i) { return tuples[i][0]; },
    [](vtkIdType i) { return static_cast<Id>(i); });
  Buffer<Id>& order = lists.Items;
  ForEach(numberOfVertices,
    [&](vtkIdType v)
    {
      std::sort(order.data() + lists.Offsets[v], order.data() + lists.Offsets[v + 1],
        [&tuples](Id a, Id b) { return tuples[a] < tuples[b]; });
    });
  return std::move(order);
}

/// The vertices of simplices; other points do not belong to the complex.
template <typename Id>
Buffer<Id> FindUsedVertices(const Links<Id>& links)
{
  const SimplicialComplex<Id>& complex = links.Complex;
  Buffer<Id> places(complex.NumberOfVertices + vtkIdType(1));
  ForEach(complex.NumberOfVertices,
    [&](vtkIdType v) { places[v] = links.VertexEdges[v].size() > 0 ? 1 : 0; });
  for (Id vertex : InTurn(complex.VertexCells))
  {
    places[vertex] = 1;
  }
  CountsToOffsets(places);
  Buffer<Id> used(places[complex.NumberOfVertices]);
  ForEach(complex.NumberOfVertices,
    [&](vtkIdType v)
    {
      if (places[v] < places[v + 1])
      {
        used[places[v]] = static_cast<Id>(v);
      }
    });
  return used;
}

/// C_k is connected through vertices: as many components as vertices, less one for each edge that
/// joins two.
template <typename Id>
vtkIdType CountComponents(
  const SimplicialComplex<Id>& complex, const ComplexDescription<Id>& description, int k)
{
  Buffer<Id> parents(complex.NumberOfVertices);
  ForEach(complex.NumberOfVertices, [&](vtkIdType v) { parents[v] = static_cast<Id>(v); });
  auto root = [&parents](Id v)
  {
    while (parents[v] != v)
    {
      v = parents[v] = parents[parents[v]];
    }
    return v;
  };
  vtkIdType components = 0;
  for (const SimplexFacts& vertex : description.Facts[0])
  {
    components += vertex.ManifoldDimensions & DimensionBit(k) ? 1 : 0;
  }
  for (const vtkIdType e : InTurn(complex.NumberOfEdges))
  {
    if (description.Facts[1][e].ManifoldDimensions & DimensionBit(k))
    {
      const Id a = root(complex.EdgeVertices[2 * e]);
      const Id b = root(complex.EdgeVertices[2 * e + 1]);
      parents[std::max(a, b)] = std::min(a, b);
      components -= a != b ? 1 : 0;
    }
  }
  return components;
}

}

bool SimplexFacts::IsSpecial() const
{
  const int k = this->ManifoldDimensions == DimensionBit(1) ? 1
    : this->ManifoldDimensions == DimensionBit(2)           ? 2
    : this->ManifoldDimensions == DimensionBit(3)           ? 3
                                                            : 0;
  return this->NonManifoldType != 0 || this->Boundary || this->Singular ||
    (this->RuleDimension >= 0 && this->RuleDimension != k);
}

template <typename Id>
ComplexDescription<Id> DescribeComplex(
  const SimplicialComplex<Id>& complex, const Strata<Id>& strata, const SingularSimplices& singular)
{
  const Links<Id> links(complex);
  ComplexDescription<Id> description;
  DescribeVerticesAndEdges(links, strata, singular, description);
  DescribeFaces(links, singular, description);
  description.Order[0] = FindUsedVertices(links);
  description.Order[1] = SortSimplices<2>(complex.EdgeVertices, complex.NumberOfVertices);
  description.Order[2] = SortSimplices<3>(complex.FaceVertices, complex.NumberOfVertices);
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    description.Counts[dimension] = description.Order[dimension].size();
    description.Components[dimension + 1] = CountComponents(complex, description, dimension + 1);
  }
  description.Counts[3] = complex.NumberOfTets;
  for (Id vertex : description.Order[0])
  {
    description.Components[0] += description.Facts[0][vertex].ManifoldDimensions == 0 ? 1 : 0;
  }
  return description;
}

SUBDIVISION_COMPILE_FUNCTION(DescribeComplex);

}
