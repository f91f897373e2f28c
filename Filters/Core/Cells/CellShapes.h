// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellShapes.h
 * The types of cells and their children, as tables (Mathematics 15).
 *
 * Local points of a cell: corners, the middles of its edges, of its quads, and its centre. Edge i
 * of a face goes from its corner i to the next one.
 */
#ifndef SubdivisionObjects_CellShapes_h
#define SubdivisionObjects_CellShapes_h

#include <array>
#include <vector>

namespace subdivision
{

enum class CellShape : unsigned char
{
  Vertex,
  Line,
  Triangle,
  Quad,
  Tet,
  Pyramid,
  Wedge,
  Hex,
  Octahedron ///< three pairs of opposite corners, one after the other
};
constexpr int NumberOfShapes = 9;

/// The part of a cell in which an edge or a face of a child lies, or a corner of a child is.
struct CellPart
{
  enum Kinds : unsigned char
  {
    AtCorner,
    InEdge,
    InFace,
    Inside
  };
  Kinds Kind = Inside;
  unsigned char Index = 0;
};

struct CellChild
{
  CellShape Shape;
  std::array<unsigned char, 8> Points; ///< local points
  std::vector<CellPart> Edges;         ///< where each of its edges lies
  std::vector<CellPart> Faces;
};

struct CellTable
{
  int Dimension = 0;
  int Corners = 1;
  std::vector<std::array<unsigned char, 2>> Edges;
  std::vector<std::vector<unsigned char>> Faces; ///< corners in cyclic order; of a polygon: itself
  std::vector<std::vector<unsigned char>> FaceEdges;
  std::vector<unsigned char> Quads; ///< the faces that have four corners
  bool HasCentre = false;
  std::vector<CellChild> Children;
  /// What each local point is in the middle of, and the corners of that.
  std::vector<CellPart> Points;
  std::vector<std::vector<unsigned char>> PointCorners;
};

const CellTable& GetCellTable(CellShape shape);

/// The number of cells of each type after a step.
std::array<double, NumberOfShapes> CountChildren(const std::array<double, NumberOfShapes>& cells);

}

#endif
