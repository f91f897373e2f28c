// SPDX-License-Identifier: BSD-3-Clause
#include "CoreReference.h"

#include <iterator>

namespace coretest
{

Tuple Without(const Tuple& outer, const Tuple& inner)
{
  Tuple rest;
  std::set_difference(
    outer.begin(), outer.end(), inner.begin(), inner.end(), std::back_inserter(rest));
  return rest;
}

Sets FacesOf(const Tuple& simplex)
{
  Sets faces;
  for (int pattern = 1; pattern < 1 << simplex.size(); ++pattern)
  {
    Tuple face;
    for (std::size_t i = 0; i < simplex.size(); ++i)
    {
      if (pattern >> i & 1)
      {
        face.push_back(simplex[i]);
      }
    }
    faces.insert(face);
  }
  return faces;
}

Reference::Reference(const SimplexList& list, const std::set<Tuple>& singular)
  : Singular(singular)
  , NumberOfPoints(list.NumberOfPoints)
{
  Sets cells;
  Sets properFaces;
  for (const Tuple& ordered : GetCells(list))
  {
    const Tuple cell = Sorted(ordered);
    if (ordered.size() == 4 && cells.count(cell) == 0)
    {
      this->Marked[cell] = { Sorted({ ordered[0], ordered[2] }),
        Sorted({ ordered[1], ordered[3] }) };
    }
    cells.insert(cell);
    for (const Tuple& face : FacesOf(cell))
    {
      this->Closure.insert(face);
      if (face.size() < cell.size())
      {
        properFaces.insert(face);
      }
    }
  }
  for (const Tuple& cell : cells)
  {
    if (properFaces.count(cell) == 0)
    {
      this->Maximal[cell.size() - 1].insert(cell);
      for (vtkIdType v : cell)
      {
        this->MaximalAt[cell.size() - 1][v].insert(cell);
      }
    }
  }
  for (const Tuple& simplex : this->Closure)
  {
    if (simplex.size() == 2)
    {
      this->Neighbours[simplex[0]].insert(simplex[1]);
      this->Neighbours[simplex[1]].insert(simplex[0]);
    }
  }
  for (const Tuple& simplex : this->Closure)
  {
    if (simplex.size() == 2)
    {
      this->Edges[simplex] = this->DecideEdge(simplex);
    }
  }
  for (vtkIdType v = 0; v < list.NumberOfPoints; ++v)
  {
    this->Vertices.push_back(this->DecideVertex(v));
  }
}

Sets Reference::Link(const Tuple& simplex, int k) const
{
  Sets link;
  const auto around = this->MaximalAt[k].find(simplex[0]);
  if (around != this->MaximalAt[k].end())
  {
    for (const Tuple& cell : around->second)
    {
      if (Contains(cell, simplex))
      {
        link.insert(Without(cell, simplex));
      }
    }
  }
  return link;
}

Tuple Reference::VerticesOf(const Sets& simplices)
{
  std::set<vtkIdType> vertices;
  for (const Tuple& simplex : simplices)
  {
    vertices.insert(simplex.begin(), simplex.end());
  }
  return Tuple(vertices.begin(), vertices.end());
}

int Reference::CountPieces(const Sets& simplices)
{
  Sets left = simplices;
  int pieces = 0;
  while (!left.empty())
  {
    ++pieces;
    std::set<vtkIdType> piece(left.begin()->begin(), left.begin()->end());
    for (bool grows = true; grows;)
    {
      grows = false;
      for (auto i = left.begin(); i != left.end();)
      {
        const bool meets =
          std::any_of(i->begin(), i->end(), [&](vtkIdType v) { return piece.count(v) > 0; });
        if (meets)
        {
          piece.insert(i->begin(), i->end());
          i = left.erase(i);
          grows = true;
        }
        else
        {
          ++i;
        }
      }
    }
  }
  return pieces;
}

Shape Reference::ShapeOfGraph(const Sets& arcs)
{
  std::map<vtkIdType, int> degrees;
  for (const Tuple& arc : arcs)
  {
    ++degrees[arc[0]];
    ++degrees[arc[1]];
  }
  int ends = 0;
  for (const auto& degree : degrees)
  {
    if (degree.second > 2)
    {
      return Shape::Type2;
    }
    ends += degree.second == 1 ? 1 : 0;
  }
  if (CountPieces(arcs) > 1)
  {
    return Shape::Type3;
  }
  return ends == 0 ? Shape::Interior : Shape::Boundary;
}

Shape Reference::ShapeOfSurface(const Sets& triangles)
{
  std::map<Tuple, int> edges;
  for (const Tuple& t : triangles)
  {
    for (const Tuple& face : FacesOf(t))
    {
      edges[face] += face.size() == 2 ? 1 : 0;
    }
  }
  int numberOfEdges = 0;
  int ends = 0;
  for (const auto& edge : edges)
  {
    if (edge.second > 2)
    {
      return Shape::Type2;
    }
    numberOfEdges += edge.first.size() == 2 ? 1 : 0;
    ends += edge.second == 1 ? 1 : 0;
  }
  const Tuple vertices = VerticesOf(triangles);
  for (vtkIdType v : vertices)
  {
    Sets around;
    for (const Tuple& t : triangles)
    {
      if (Contains(t, { v }))
      {
        around.insert(Without(t, { v }));
      }
    }
    const Shape shape = ShapeOfGraph(around);
    if (shape != Shape::Interior && shape != Shape::Boundary)
    {
      return Shape::Type3;
    }
  }
  const int euler =
    static_cast<int>(vertices.size()) - numberOfEdges + static_cast<int>(triangles.size());
  if (CountPieces(triangles) == 1 && euler == (ends == 0 ? 2 : 1))
  {
    return ends == 0 ? Shape::Interior : Shape::Boundary;
  }
  return Shape::Type3;
}

/// The table of Mathematics 3.
Shape Reference::Place(const Tuple& simplex, int k) const
{
  const Sets link = this->Link(simplex, k);
  if (link.empty())
  {
    return Shape::Absent;
  }
  switch (k - static_cast<int>(simplex.size()))
  {
    case -1:
      return Shape::Interior; // a maximal line
    case 0:
      return link.size() == 1 ? Shape::Boundary : link.size() == 2 ? Shape::Interior : Shape::Type2;
    case 1:
    {
      // A vertex or an edge with a bad link vertex is type 2, whatever its pieces are.
      return ShapeOfGraph(link);
    }
    default:
      return ShapeOfSurface(link);
  }
}

std::vector<int> Reference::DimensionsOf(const Tuple& simplex) const
{
  std::vector<int> dimensions;
  for (int k = 1; k <= 3; ++k)
  {
    if (!this->Link(simplex, k).empty())
    {
      dimensions.push_back(k);
    }
  }
  return dimensions;
}

int Reference::TypeOf(const Tuple& simplex) const
{
  const std::vector<int> dimensions = this->DimensionsOf(simplex);
  if (dimensions.size() != 1)
  {
    return dimensions.empty() ? 0 : 1;
  }
  const Shape shape = this->Place(simplex, dimensions[0]);
  return shape == Shape::Type2 ? 2 : shape == Shape::Type3 ? 3 : 0;
}

Sets Reference::SingularFacesAt(const Tuple& simplex) const
{
  Sets faces;
  for (const Tuple& s : this->Singular)
  {
    if (s.size() == 3 && this->Closure.count(s) > 0 && Contains(s, simplex))
    {
      faces.insert(s);
    }
  }
  return faces;
}

Sets Reference::BoundaryTrianglesAt(const Tuple& simplex) const
{
  std::map<Tuple, int> counts;
  for (const Tuple& rest : this->Link(simplex, 3))
  {
    for (vtkIdType v : rest)
    {
      Tuple tet = rest;
      tet.insert(tet.end(), simplex.begin(), simplex.end());
      ++counts[Without(Sorted(tet), { v })];
    }
  }
  Sets boundary;
  for (const auto& triangle : counts)
  {
    if (triangle.second == 1)
    {
      boundary.insert(triangle.first);
    }
  }
  return boundary;
}

bool Reference::IsRegular(const Tuple& edge) const
{
  const Sets link = this->Link(edge, 3);
  return link.size() == 4 &&
    std::all_of(link.begin(), link.end(),
      [&](Tuple tet)
      {
        tet.insert(tet.end(), edge.begin(), edge.end());
        return this->Marked.at(Sorted(tet)).count(edge) > 0;
      });
}

Expected Reference::DecideEdge(const Tuple& edge) const
{
  Expected expected;
  expected.Type = this->TypeOf(edge);
  const Sets singular = this->SingularFacesAt(edge);
  if (this->Singular.count(edge) > 0 || (!singular.empty() && singular.size() != 2))
  {
    expected.FollowedRule = Rule::Curve;
    return expected;
  }
  if (singular.size() == 2)
  {
    expected.FollowedRule = Rule::Surface;
    expected.Ring = Without(VerticesOf(singular), edge);
    return expected;
  }
  if (expected.Type != 0)
  {
    expected.FollowedRule = Rule::Blend;
    const auto& a = this->Neighbours.at(edge[0]);
    const auto& b = this->Neighbours.at(edge[1]);
    std::set_intersection(
      a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(expected.Ring));
    return expected;
  }
  const int k = this->DimensionsOf(edge)[0];
  const bool interior = this->Place(edge, k) == Shape::Interior;
  if (k == 1 || (k == 2 && !interior))
  {
    expected.FollowedRule = Rule::Curve;
  }
  else if (k == 2)
  {
    expected.FollowedRule = Rule::Surface;
    expected.Ring = VerticesOf(this->Link(edge, 2));
  }
  else if (!interior)
  {
    expected.FollowedRule = Rule::Surface;
    expected.Ring = Without(VerticesOf(this->BoundaryTrianglesAt(edge)), edge);
  }
  else
  {
    expected.FollowedRule = this->IsRegular(edge) ? Rule::RegularEdge : Rule::Solid;
    expected.Ring = VerticesOf(this->Link(edge, 3));
  }
  return expected;
}

Expected Reference::DecideVertex(vtkIdType vertex) const
{
  const Tuple self = { vertex };
  Expected expected;
  expected.Type = this->TypeOf(self);
  if (this->Singular.count(self) > 0 || this->DimensionsOf(self).empty())
  {
    return expected;
  }
  const auto& neighbours = this->Neighbours.at(vertex);
  Tuple creases;
  for (vtkIdType n : neighbours)
  {
    const Tuple edge = Sorted({ vertex, n });
    const std::size_t faces = this->SingularFacesAt(edge).size();
    if (this->Singular.count(edge) > 0 || (faces > 0 && faces != 2))
    {
      creases.push_back(n);
    }
  }
  if (!creases.empty())
  {
    if (creases.size() == 2)
    {
      expected.FollowedRule = Rule::Curve;
      expected.Ring = creases;
    }
    return expected;
  }
  const Sets singular = this->SingularFacesAt(self);
  if (!singular.empty())
  {
    Sets arcs;
    for (const Tuple& face : singular)
    {
      arcs.insert(Without(face, self));
    }
    if (ShapeOfGraph(arcs) == Shape::Interior)
    {
      expected.FollowedRule = Rule::Surface;
      expected.Ring = VerticesOf(arcs);
    }
    return expected;
  }
  if (expected.Type != 0)
  {
    expected.FollowedRule = Rule::Blend;
    expected.Ring = Tuple(neighbours.begin(), neighbours.end());
    return expected;
  }
  const int k = this->DimensionsOf(self)[0];
  if (this->Place(self, k) == Shape::Interior)
  {
    expected.FollowedRule = static_cast<Rule>(k);
    expected.Ring = VerticesOf(this->Link(self, k));
    return expected;
  }
  expected.FollowedRule = static_cast<Rule>(k - 1);
  if (k == 3)
  {
    expected.Ring = Without(VerticesOf(this->BoundaryTrianglesAt(self)), self);
  }
  else if (k == 2)
  {
    for (vtkIdType n : neighbours)
    {
      if (this->Place(Sorted({ vertex, n }), 2) == Shape::Boundary)
      {
        expected.Ring.push_back(n);
      }
    }
  }
  return expected;
}

std::vector<double> Reference::MakeRow(const Tuple& simplex, const Expected& expected) const
{
  const double m = static_cast<double>(expected.Ring.size());
  double own = 1.;
  double ring = 0.;
  if (simplex.size() == 1)
  {
    switch (expected.FollowedRule)
    {
      case Rule::Corner:
        break;
      case Rule::Curve:
        ring = 1. / 8.;
        break;
      case Rule::Surface:
        ring = expected.Ring.size() == 3 ? 3. / 16. : 3. / (8. * m);
        break;
      default:
        ring = 7. / (16. * m);
        break;
    }
    own = 1. - m * ring;
  }
  else
  {
    switch (expected.FollowedRule)
    {
      case Rule::Curve:
        break;
      case Rule::Surface:
      case Rule::RegularEdge:
        ring = 1. / 8.;
        break;
      default:
        ring = expected.Ring.empty() ? 0. : 3. / (8. * m);
        break;
    }
    own = (1. - m * ring) / 2.;
  }
  std::vector<double> row(this->NumberOfPoints, 0.);
  for (vtkIdType v : simplex)
  {
    row[v] += own;
  }
  for (vtkIdType v : expected.Ring)
  {
    row[v] += ring;
  }
  return row;
}

}
