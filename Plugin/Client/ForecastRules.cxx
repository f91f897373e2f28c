// SPDX-License-Identifier: BSD-3-Clause
#include "ForecastRules.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Of the fastest filter with one thread, and of one that makes normals: between the two.
constexpr double SecondsPerCell = 1e-7;

using Numbers = std::array<double, 4>; ///< by dimension

/// Faces after so many levels by the number of a scheme of vtkSurfaceSubdivision.
double CountFaces(int scheme, const ControlCounts& counts, int levels)
{
  enum
  {
    CatmullClark = 2,
    DooSabin = 3,
    Midedge = 4,
    FourEight = 5,
    SqrtThree = 6,
    Automatic = 8
  };
  const double triangles = counts[2];
  const double corners = counts[4];
  switch (levels > 0 ? scheme : -1)
  {
    case CatmullClark:
    case DooSabin:
      return corners * std::pow(4., levels - 1);
    case Midedge:
    case FourEight: // twice as many for each edge, which two faces have
      return corners * std::pow(2., levels - 2);
    case SqrtThree:
      return triangles * std::pow(3., levels);
    case Automatic:
      return std::max(corners * std::pow(4., levels - 1), triangles * std::pow(4., levels));
    default:
      return triangles * std::pow(4., levels);
  }
}

/// Whether the main filter cuts no cell of an input with these.
bool KeepsTypes(const ForecastOptions& options, const ControlCounts& counts)
{
  enum
  {
    Linear = 2,
    Hybrid = 3,
    Automatic = 4
  };
  const bool hasUncut = counts[6] != counts[2] || counts[7] + counts[8] != counts[3];
  const bool needsCuts = options.OutputCells == 1 || options.AddsBounds;
  return options.VolumeScheme == Hybrid ||
    (options.VolumeScheme == Linear && options.KeepCellTypes) ||
    (options.VolumeScheme == Automatic && hasUncut && !needsCuts);
}

/// Cells by dimension: a pyramid becomes 4 pyramids and 8 tetrahedra.
Numbers CountCells(const ForecastOptions& options, const ControlCounts& counts, bool keepsTypes)
{
  const int levels = options.Levels;
  if (options.Kind == ForecastOptions::OfSurfaces || options.Kind == ForecastOptions::Adaptive)
  {
    const bool isAdaptive = options.Kind == ForecastOptions::Adaptive;
    return { counts[0], counts[1] * std::pow(2., levels),
      isAdaptive ? counts[2] * std::pow(3., levels) : CountFaces(options.Scheme, counts, levels),
      0. };
  }
  if (options.Kind == ForecastOptions::OfLabels)
  {
    const double most = options.MaximumNumberOfVoxels;
    const double voxels = most > 0. ? std::min(most, counts[5]) : counts[5];
    return { 0., 0., 0., voxels * (keepsTypes ? 1. : 6.) * std::pow(8., levels) };
  }
  const double faces = keepsTypes ? counts[6] : counts[2];
  const double solids = keepsTypes ? 2. * counts[7] + counts[8] : counts[3];
  const double pyramids = keepsTypes ? counts[7] * std::pow(4., levels) : 0.;
  return { counts[0], counts[1] * std::pow(2., levels), faces * std::pow(4., levels),
    solids * std::pow(8., levels) - pyramids };
}

/// How cells of the output look.
struct Shapes
{
  Numbers Points;  ///< per cell of a large mesh
  Numbers Corners; ///< of a cell
};

/// Of quads and hexahedra, of an order, or of simplices.
Shapes GetShapes(bool areQuads, bool areHexahedra, int order)
{
  const double n = order;
  const double line = n + 1.;
  Shapes shapes{ { 1., n, n * n / 2., n * n * n * 0.18 },
    { 1., line, line * (n + 2.) / 2., line * (n + 2.) * (n + 3.) / 6. } };
  if (areQuads)
  {
    shapes.Points[2] = n * n;
    shapes.Corners[2] = line * line;
  }
  if (areHexahedra)
  {
    shapes.Points[3] = n * n * n;
    shapes.Corners[3] = line * line * line;
  }
  return shapes;
}

bool HasQuads(const ForecastOptions& options, const ControlCounts& counts, bool keepsTypes)
{
  const bool isOfQuads = options.Scheme >= 2 && options.Scheme <= 5;
  const bool areMost = counts[4] > 3.5 * counts[6];
  return options.Kind == ForecastOptions::OfSurfaces
    ? (isOfQuads || (options.Scheme == 8 && areMost)) && options.Levels > 0
    : keepsTypes && areMost;
}

}

Forecast Foretell(const ControlCounts& counts, const ForecastOptions& options)
{
  enum
  {
    Linear,
    Bezier,
    Quadratic
  };
  const bool isLocal =
    options.Kind == ForecastOptions::RedGreen || options.Kind == ForecastOptions::Adaptive;
  const bool isOfLabels = options.Kind == ForecastOptions::OfLabels;
  const bool isSolid = isOfLabels || options.Kind == ForecastOptions::OfAllDimensions;
  const bool keepsTypes = isSolid && KeepsTypes(options, counts);
  const Numbers made = CountCells(options, counts, keepsTypes);
  const bool isCurved = options.OutputCells != Linear && !isLocal;
  const int asked = options.OutputCells == Quadratic ? 2 : options.CellOrder;
  const int order = isCurved ? asked : 1;
  Shapes shapes = GetShapes(HasQuads(options, counts, keepsTypes),
    keepsTypes && (isOfLabels || counts[3] > 2. * counts[8]), order);
  constexpr int Even = 1;
  constexpr int LinearSolids = 2;
  const bool hasOctahedra = isSolid && !isCurved &&
    (options.VolumeScheme == Even || (keepsTypes && options.VolumeScheme != LinearSolids));
  double bytesPerCell = options.BytesPerCell + (isCurved ? 9. : 0.) +
    (options.AddsBounds ? 8. : 0.) + (hasOctahedra ? 8. : 0.);
  if (isLocal) // ids, levels and kinds
  {
    bytesPerCell += options.Kind == ForecastOptions::RedGreen ? 18. : 9.;
  }
  shapes.Points[3] *= isLocal || isOfLabels ? 1.6 : 1.; // there may be more border
  if (options.OutputCells == Bezier && !isLocal)
  {
    const bool areQuads = shapes.Corners[2] == (order + 1.) * (order + 1.);
    shapes.Corners = { 1., 4., areQuads ? 16. : 15., 56. };
    shapes.Points = shapes.Corners; // hardly any are shared by cells of several sizes
    bytesPerCell = options.BytesPerCell;
  }
  const double bytesPerPoint = options.BytesPerPoint + (options.AddsNormals ? 12. : 0.) +
    (options.AddsTangents ? 24. : 0.) + (options.AddsBounds ? 8. : 0.) +
    (options.AddsClasses ? 6. : 0.);
  Forecast forecast;
  forecast.IsAtMost = isLocal || isOfLabels || options.OutputCells == Bezier;
  for (std::size_t d = 0; d < made.size(); ++d)
  {
    forecast.Work += made[d];
    if (options.Dimensions[d])
    {
      forecast.Cells += made[d];
      forecast.Bytes += made[d] *
        (8. * (shapes.Corners[d] + 1.) + 1. + bytesPerCell + shapes.Points[d] * bytesPerPoint);
    }
  }
  if (isLocal)
  {
    const double share = std::min(1., options.MaximumNumberOfCells / std::max(1., forecast.Cells));
    forecast.Cells *= share;
    forecast.Bytes *= share;
    forecast.Work = forecast.Cells;
  }
  if (isLocal || isOfLabels) // how many rounds there will be, nobody knows
  {
    return forecast;
  }
  // Nodes are points of further levels, bounds need three, and Bezier cells two.
  const double steps = options.AddsBounds ? 3. : isCurved ? std::log2(std::max(2, order)) : 0.;
  // Those of orders that are no powers of 2 are evaluated one by one.
  const double each = order == 3 || order > 4 ? 30. : 1.;
  const double further =
    each * std::pow(made[3] > 0. ? 8. : 4., options.OutputCells == Bezier ? 2. : steps);
  forecast.Seconds =
    SecondsPerCell * forecast.Work * further * (options.ReadsLimit || isCurved ? 2. : 1.);
  return forecast;
}
