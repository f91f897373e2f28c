// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridReferenceCells.h
 * The cells of the hybrid scheme: their sides, children and centroids, as tables.
 */
#ifndef SubdivisionObjects_HybridReferenceCells_h
#define SubdivisionObjects_HybridReferenceCells_h

#include <cstddef>
#include <utility>
#include <vector>

namespace hybridtest
{

using Ids = std::vector<int>;

enum class Type
{
  Vertex,
  Line,
  Triangle,
  Quad,
  Tet,
  Pyramid,
  Wedge,
  Hex,
  Octahedron ///< a, a', b, b', c, c': three opposite pairs
};

struct Cell
{
  Type Shape = Type::Vertex;
  Ids Corners; ///< in the order of VTK
  int Material = 0;
};

using Locals = std::vector<Ids>;

/// Edges, quads, triangles and inner children of a type, in local numbers.
struct Table
{
  int Dimension;
  Locals Edges;
  Locals Quads;
  Locals Triangles;
  bool HasCentre;
  std::vector<std::pair<Type, Ids>> Inner;
};

const Table& GetTable(Type shape);

bool Has(const Ids& ids, int id);

/// Corners of a cell by local numbers.
Ids Named(const Cell& cell, const Ids& locals);

int DimensionOf(Type shape);
Ids Sorted(Ids ids);
/// The sides of a cell of one dimension, the cell itself if it has that dimension.
std::vector<Cell> Sides(const Cell& cell, int dimension);

/// Whether sorted corners are one of its sides of a dimension.
bool HasSide(const Cell& cell, const Ids& side, int dimension);

/// What a fine cell counts at its corner i, and how much each of its corners counts.
double Centroid(const Cell& cell, std::size_t i, std::vector<double>& shares);

}

#endif
