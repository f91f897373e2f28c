// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellMoments.h
 * Integrals over the linear cells of a mesh on the limit, and the extremes of its values.
 */
#ifndef SubdivisionObjects_CellMoments_h
#define SubdivisionObjects_CellMoments_h

#include "vtkType.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace subdivision
{

/// The places of sums.
enum MomentIndex
{
  MeasureMoment = 0,   ///< length, area or volume
  MassMoment = 1,      ///< the same, weighted by density as are all that follow
  FirstMoments = 2,    ///< of x, y, z
  SecondMoments = 5,   ///< of xx, yy, zz, xy, yz, xz
  IntegralMoments = 11 ///< of each component of each array
};

/// What is summed over cells of one dimension and material, and for each component of each array
/// the largest of four numbers: the value, its negative, and the same with what the limit may be
/// beyond them between points.
struct MomentRow
{
  double Cells = 0.;
  std::vector<double> Sums;
  std::vector<double> Largest;

  void Add(const MomentRow& other);
};

/// By dimension and material.
using MomentRows = std::map<std::pair<int, double>, MomentRow>;

struct MomentInput
{
  vtkUnstructuredGrid* Mesh = nullptr;
  vtkDataArray* Material = nullptr; ///< of cells; null: all are 0
  vtkDataArray* Density = nullptr;  ///< of points; null: all are 1
  std::vector<vtkDataArray*> Values;
  std::array<double, 3> Origin = {}; ///< of first and second moments
  /// The cell of the control mesh that each cell is a part of, and the signs of their volumes.
  vtkDataArray* Parents = nullptr;
  const std::vector<signed char>* Signs = nullptr;
  /// How many points the level before this one has; they come first. Negative: not known.
  vtkIdType NumberOfOldPoints = -1;
};

/// Adds the sums over the cells of a mesh, but for ghosts. Cells with quads are cut around their
/// middle and those of the quads, so that neighbours fit. Sums have the same bits for any number of
/// threads.
void AddMoments(const MomentInput& input, MomentRows& rows);

/// The derivatives of the sums over cells of one dimension, and of one material unless it is null,
/// by what the points of a mesh have. Each point has a row: of the measure by its place (3), with a
/// density of the mass by its place and its density (3 + 1), and of the integral of each array by
/// its place (3 for each component), its value (1, that of all components) and, with a density,
/// that (1 for each component).
std::vector<double> FindMomentGradients(
  const MomentInput& input, int dimension, const double* material);

/// The signs of the volumes of the cells of a control mesh. `input`: its parts, not smoothed.
std::vector<signed char> FindSigns(const MomentInput& input);

}

#endif
