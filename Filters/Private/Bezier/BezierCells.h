// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BezierCells.h
 * Writes a mesh on the limit as Bezier cells of VTK.
 */
#ifndef SubdivisionObjects_BezierCells_h
#define SubdivisionObjects_BezierCells_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkDataObject;
class vtkMultiProcessController;

namespace subdivision
{

struct BezierOptions
{
  /// How often a cell may be split.
  int Levels = 0;
  /// How many steps were made: Levels and those of CountFurtherSteps.
  int Steps = 0;
  /// What Bezier cells may leave out, as a part of the diagonal of the mesh, and of an array's
  /// range.
  double Tolerance = 0.;
  bool Use32BitIds = false;
  /// The ranks that have parts of the mesh; null: this process has all.
  vtkMultiProcessController* Controller = nullptr;
  /// Called with an error, where Steps are too few for a cell. Such cells stay linear.
  std::function<void(const std::string&)> Fail;
};

/// How many steps beyond Levels an input needs: more if it has solids or, where faces become quads,
/// faces that are none. `input`: what ReadableMesh.h makes; null: not known.
int CountFurtherSteps(vtkDataObject* input, bool toQuads);

/**
 * Makes a grid of Bezier cells of a mesh that was split uniformly and moved to the limit, or of
 * each mesh of a composite data set. The cells of a cell of the control mesh follow one another.
 * Each control cell becomes one Bezier cell if that is the limit but for two thirds of the
 * tolerance at the points of one further step, so that the tolerance is kept between these too;
 * else its children do, down to `Levels`.
 *
 * Control points that equal cells share, by the points of the mesh, are one point. Arrays of
 * floating point numbers get control values, all others the values of the point that the control
 * point belongs to. Cells of other types stay. Field data are shared, but for a stamp. All ranks
 * call this together.
 */
vtkSmartPointer<vtkDataObject> MakeBezierCells(vtkDataObject* data, const BezierOptions& options);

}

#endif
