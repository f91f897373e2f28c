// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridFacts.h"

#include "Core/Cells/CellSigns.h"
#include "Core/Memory/Ids.h"
#include "Core/Memory/Vectors.h"
#include "Core/Solids/Location/TetFrame.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The orientation of a hexahedron that is far from flat; 0 for others, which need a closer look.
/// Three determinants, after J. Grandy, are twelve times the volume whose faces are fans around
/// their middles.
template <typename Id>
signed char FindOrientationOfHex(const Id* corners, const Coordinates& points)
{
  const double* x[8];
  std::transform(corners, corners + 8, x, [&points](Id v) { return points + 3 * vtkIdType(v); });
  double size = 0.;
  for (int i = 1; i < 8; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      size = std::max(size, std::abs(x[i][c] - x[0][c]));
    }
  }
  const auto edge = [&x](int to, int from) { return vectors::Subtract(x[to], x[from]); };
  const auto sum = [](const vectors::Vector& a, const vectors::Vector& b)
  { return vectors::Vector{ a[0] + b[0], a[1] + b[1], a[2] + b[2] }; };
  const auto determinant = [](const auto& a, const auto& b, const auto& c)
  { return vectors::Dot(a, vectors::Cross(b, c)); };
  const vectors::Vector a = edge(6, 1);
  const vectors::Vector b = edge(7, 0);
  const vectors::Vector c = edge(6, 3);
  const vectors::Vector d = edge(2, 0);
  const vectors::Vector e = edge(5, 0);
  const vectors::Vector f = edge(6, 4);
  const double volume =
    determinant(sum(a, b), c, d) + determinant(b, sum(c, e), f) + determinant(a, e, sum(f, d));
  // FindOrientation adds up 24 triangles whose corners are less than 2 sqrt(3) of this size away
  // from the middle: in all less than 1000 times its cube, and of half the volume.
  return std::abs(volume) > 2000. * points.Tie * size * size * size ? (volume > 0. ? 1 : -1) : 0;
}

}

template <typename Id>
signed char FindOrientation(CellShape shape, const Id* corners, const Coordinates& points)
{
  const signed char ofHex = shape == CellShape::Hex ? FindOrientationOfHex(corners, points) : 0;
  if (ofHex != 0)
  {
    return ofHex;
  }
  if (shape == CellShape::Tet)
  {
    const double* of[4];
    std::transform(corners, corners + 4, of, [&points](Id v) { return points + 3 * vtkIdType(v); });
    return static_cast<signed char>(GetOrientationOfTet(of, points.Tie));
  }
  SolidPlaces x{};
  for (int i = 0; i < GetCellTable(shape).Corners; ++i)
  {
    std::copy_n(points + 3 * vtkIdType(corners[i]), 3, x[i].begin());
  }
  return static_cast<signed char>(FindOrientation(shape, x, points.Tie));
}

template <typename Id>
std::vector<unsigned char> FindMaximalDimensions(const CellComplex<Id>& complex)
{
  const auto ofEdge = [&complex](Id edge)
  {
    return complex.EdgeSolids[edge].size() > 0 ? 3 : complex.EdgeFaces[edge].size() > 0 ? 2 : 1;
  };
  const auto ofVertex = [&](Id vertex)
  {
    int dimension = complex.VertexSolids[vertex].size() > 0 ? 3 : 0;
    for (const Id edge : complex.VertexEdges[vertex])
    {
      dimension = std::max(dimension, ofEdge(edge));
    }
    return dimension;
  };
  std::vector<unsigned char> dimensions(
    static_cast<std::size_t>(complex.Cells.GetNumberOfCells()), 3);
  ForEach(complex.Cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      const int own = complex.Cells.GetTable(c).Dimension;
      const int found = own == 3 ? 3
        : own == 2 ? (complex.FaceSolids[*complex.CellFaces[c].begin()].size() > 0 ? 3 : 2)
        : own == 1 ? ofEdge(*complex.CellEdges[c].begin())
                   : ofVertex(*complex.Cells.GetCorners(c));
      dimensions[static_cast<std::size_t>(c)] = static_cast<unsigned char>(found);
    });
  return dimensions;
}

template <typename Id>
std::vector<signed char> FindOrientations(const CellList<Id>& cells, const Coordinates& points)
{
  std::vector<signed char> signs(static_cast<std::size_t>(cells.GetNumberOfCells()), 0);
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      if (cells.GetTable(c).Dimension == 3)
      {
        signs[static_cast<std::size_t>(c)] =
          FindOrientation(cells.Shapes[c], cells.GetCorners(c), points);
      }
    });
  return signs;
}

template <typename Id>
Buffer<unsigned char> FindInverted(
  const CellList<Id>& cells, const std::vector<signed char>& signs, const Coordinates& points)
{
  Buffer<unsigned char> found(static_cast<vtkIdType>(signs.size()));
  ForEach(found.size(),
    [&](vtkIdType c)
    {
      const signed char sign = signs[static_cast<std::size_t>(c)]; // 0: no solid
      found[c] =
        sign != 0 && sign * FindOrientation(cells.Shapes[c], cells.GetCorners(c), points) < 0;
    });
  return found;
}

SUBDIVISION_COMPILE_FUNCTION(FindMaximalDimensions);
SUBDIVISION_COMPILE_FUNCTION(FindOrientation);
SUBDIVISION_COMPILE_FUNCTION(FindOrientations);
SUBDIVISION_COMPILE_FUNCTION(FindInverted);

}
