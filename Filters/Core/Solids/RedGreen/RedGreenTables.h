// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenTables.h
 * The cells that a cell with split edges becomes (Mathematics 13), as tables that the compiler
 * works out.
 *
 * A *pattern* has bit k for local edge k (Simplices.h). Lattice points: vertices first, then the
 * midpoints of the edges.
 */
#ifndef SubdivisionObjects_RedGreenTables_h
#define SubdivisionObjects_RedGreenTables_h

#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/RedGreen/RedGreenCells.h"

namespace subdivision
{
namespace redgreen
{

constexpr int NumberOfEdges[4] = { 0, 1, 3, 6 };
/// The pattern of a red cell.
constexpr unsigned int Full[4] = { 0, 1, 7, 63 };

/// Positions of the ends of an edge in its cell.
constexpr const int* EndsOf(int dimension, int edge)
{
  return dimension == 3 ? tetrahedron::EdgeVertices[edge] : triangle::EdgeVertices[edge];
}

/// The edges of face f of a tetrahedron, as a pattern.
constexpr unsigned int FacePattern(int face)
{
  unsigned int pattern = 0;
  for (int edge = 0; edge < 6; ++edge)
  {
    pattern |= tetrahedron::Touches(edge, face) ? 0u : 1u << edge;
  }
  return pattern;
}

constexpr int CountBits(unsigned int pattern)
{
  return pattern == 0 ? 0 : static_cast<int>(pattern & 1u) + CountBits(pattern >> 1);
}

/// A triangle with two split edges splits its third.
constexpr unsigned int ClosePattern(int dimension, unsigned int pattern)
{
  if (dimension == 2)
  {
    return CountBits(pattern) >= 2 ? Full[2] : pattern;
  }
  for (int pass = 0; dimension == 3 && pass < 3; ++pass)
  {
    for (int face = 0; face < 4; ++face)
    {
      if (CountBits(pattern & FacePattern(face)) >= 2)
      {
        pattern |= FacePattern(face);
      }
    }
  }
  return pattern;
}

/// The parts of a cell, as lattice points.
struct Parts
{
  unsigned char Closed = 0; ///< the pattern after closing; all else is of the closed one
  signed char Count = 1;
  RefinementKind Kind = RefinementKind::Untouched;
  signed char Vertices[8][4] = {};
};

/// Green-I and green-II: each split edge doubles the parts; in one half of them the midpoint
/// replaces one end of the edge, in the other half the other end.
constexpr void SetGreen(Parts& parts, int dimension, unsigned int pattern)
{
  parts.Count = 1;
  for (int i = 0; i <= dimension; ++i)
  {
    parts.Vertices[0][i] = static_cast<signed char>(i);
  }
  for (int edge = 0; edge < NumberOfEdges[dimension]; ++edge) // up to two, opposite ones
  {
    if ((pattern >> edge & 1u) == 0)
    {
      continue;
    }
    const int count = parts.Count;
    for (int part = 0; part < count; ++part)
    {
      for (int i = 0; i <= dimension; ++i)
      {
        parts.Vertices[count + part][i] = parts.Vertices[part][i];
      }
      const auto midpoint = static_cast<signed char>(dimension + 1 + edge);
      parts.Vertices[part][EndsOf(dimension, edge)[1]] = midpoint;
      parts.Vertices[count + part][EndsOf(dimension, edge)[0]] = midpoint;
    }
    parts.Count = static_cast<signed char>(2 * count);
  }
}

/// Green-III: the children of a face, each with the vertex opposite to the face.
constexpr void SetFace(Parts& parts, int face)
{
  parts.Count = 4;
  for (int child = 0; child < 4; ++child)
  {
    parts.Vertices[child][face] = static_cast<signed char>(face);
    for (int i = 0; i < 3; ++i)
    {
      const int point = triangle::Children[child][i];
      const int* corners = tetrahedron::FaceVertices[face];
      const int* ends = triangle::EdgeVertices[point < 3 ? 0 : point - 3];
      parts.Vertices[child][corners[i]] = static_cast<signed char>(
        point < 3 ? corners[point] : 4 + tetrahedron::EdgeOf[corners[ends[0]]][corners[ends[1]]]);
    }
  }
}

constexpr void SetRed(Parts& parts, int dimension)
{
  constexpr int line[2][2] = { { 0, 2 }, { 2, 1 } };
  parts.Count = static_cast<signed char>(1 << dimension);
  for (int child = 0; child < parts.Count; ++child)
  {
    for (int i = 0; i <= dimension; ++i)
    {
      parts.Vertices[child][i] = static_cast<signed char>(dimension == 1 ? line[child][i]
          : dimension == 2 ? triangle::Children[child][i]
                           : tetrahedron::Children[child][i]);
    }
  }
}

constexpr Parts MakeParts(int dimension, unsigned int pattern)
{
  Parts parts;
  const unsigned int closed = ClosePattern(dimension, pattern & Full[dimension]);
  parts.Closed = static_cast<unsigned char>(closed);
  const int split = CountBits(closed);
  if (split == NumberOfEdges[dimension] && split > 0)
  {
    parts.Kind = RefinementKind::Red;
    SetRed(parts, dimension);
  }
  else if (split == 3)
  {
    parts.Kind = RefinementKind::GreenIII;
    int face = 0;
    while (FacePattern(face) != closed)
    {
      ++face;
    }
    SetFace(parts, face);
  }
  else
  {
    parts.Kind = split == 0 ? RefinementKind::Untouched
      : split == 1          ? RefinementKind::GreenI
                            : RefinementKind::GreenII;
    SetGreen(parts, dimension, closed);
  }
  return parts;
}

constexpr auto MakeAllParts()
{
  std::array<std::array<Parts, 64>, 4> table{};
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    for (unsigned int pattern = 0; pattern <= Full[dimension]; ++pattern)
    {
      table[dimension][pattern] = MakeParts(dimension, pattern);
    }
  }
  return table;
}
/// By dimension and pattern, closed or not.
constexpr auto PartsOf = MakeAllParts();

}
}

#endif
