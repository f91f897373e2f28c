// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridMasks.h"

#include "Core/Rules/Masks.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// What a fine solid contributes at one of its corners.
SolidMask MakeFineMask(CellShape shape, int corner)
{
  // The weights of the corner itself, of those with which it has an edge, of those with which it
  // has a quad, and of all others.
  struct Weights
  {
    double Weight, Own, Edge, Quad, Rest;
  };
  const bool isApex = shape == CellShape::Pyramid && corner == 4;
  const Weights w = isApex        ? Weights{ 1., 1. / 12., 11. / 48., 0., 0. }
    : shape == CellShape::Tet     ? Weights{ 1., -1. / 16., 17. / 48., 0., 0. }
    : shape == CellShape::Pyramid ? Weights{ 1. / 2., 17. / 48., 1. / 16., 13. / 48., 0. }
    : shape == CellShape::Wedge   ? Weights{ 7. / 6., 1. / 8., 3. / 16., 3. / 16., 0. }
    : shape == CellShape::Hex     ? Weights{ 7. / 4., 1. / 8., 1. / 8., 1. / 8., 1. / 8. }
                                  : Weights{ 1., 3. / 8., 1. / 12., 0., 7. / 24. };
  const CellTable& table = GetCellTable(shape);
  SolidMask mask{ w.Weight, {} };
  std::fill_n(mask.Shares, table.Corners, w.Weight * w.Rest);
  for (const unsigned char quad : table.Quads)
  {
    const auto& face = table.Faces[quad];
    if (std::find(face.begin(), face.end(), corner) != face.end())
    {
      for (const int c : face)
      {
        mask.Shares[c] = w.Weight * w.Quad;
      }
    }
  }
  for (const auto& edge : table.Edges)
  {
    if (edge[0] == corner || edge[1] == corner)
    {
      mask.Shares[edge[0]] = mask.Shares[edge[1]] = w.Weight * w.Edge;
    }
  }
  if (shape == CellShape::Wedge)
  {
    mask.Shares[(corner + 3) % 6] = w.Weight / 8.; // along the axis
  }
  else if (shape == CellShape::Pyramid && !isApex)
  {
    mask.Shares[4] = w.Weight / 4.;
  }
  mask.Shares[corner] = w.Weight * w.Own;
  return mask;
}

/// Sums what the children contribute.
std::vector<SolidMask> MakeMasks(CellShape shape)
{
  const CellTable& table = GetCellTable(shape);
  std::vector<SolidMask> masks(table.Points.size());
  for (const CellChild& child : table.Children)
  {
    const int corners = GetCellTable(child.Shape).Corners;
    for (int i = 0; i < corners; ++i)
    {
      const SolidMask fine = MakeFineMask(child.Shape, i);
      SolidMask& mask = masks[child.Points[i]];
      mask.Weight += fine.Weight;
      for (int j = 0; j < corners; ++j)
      {
        const auto& means = table.PointCorners[child.Points[j]];
        for (const int c : means)
        {
          mask.Shares[c] += fine.Shares[j] / static_cast<double>(means.size());
        }
      }
    }
  }
  return masks;
}

}

const std::vector<SolidMask>& GetSolidMasks(CellShape shape)
{
  static const std::vector<SolidMask> masks[] = { MakeMasks(CellShape::Tet),
    MakeMasks(CellShape::Pyramid), MakeMasks(CellShape::Wedge), MakeMasks(CellShape::Hex),
    MakeMasks(CellShape::Octahedron) };
  return masks[static_cast<int>(shape) - static_cast<int>(CellShape::Tet)];
}

double GetRelaxation(vtkIdType quads, vtkIdType triangles, LoopWeights weights)
{
  if (quads == 0)
  {
    return (1. - SurfaceVertexMask(triangles, weights).Own) * 8. / 3.;
  }
  const double q = static_cast<double>(quads);
  const double t = static_cast<double>(triangles);
  return (36. * q / (3. * q + 2. * t) + 2. * t) / (3. * q + 2. * t);
}

}
