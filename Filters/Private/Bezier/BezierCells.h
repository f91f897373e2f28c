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
  /// Whether cells may be split more often, by further steps: then nothing is written if there are
  /// some of which this is not known yet.
  bool MayGoOn = false;
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
 * All cells have one degree, the largest that one of them needs. Control points that equal cells
 * share, by the points of the mesh, are one point. Arrays of
 * floating point numbers get control values, all others the values of the point that the control
 * point belongs to. Cells of other types stay. Field data are shared, but for a stamp. All ranks
 * call this together. Returns null if steps are too few (MayGoOn).
 */
vtkSmartPointer<vtkDataObject> MakeBezierCells(vtkDataObject* data, const BezierOptions& options);

/// The runs of a filter that make Bezier cells: with as many steps as some cell needs, and no more.
class BezierRounds
{
public:
  /// Says how many steps beyond levels an input needs (CountFurtherSteps).
  void SetFurtherSteps(int further) { this->FurtherSteps = further; }
  int GetSteps() const { return this->Levels + this->FurtherSteps; }
  /// Calls run(begin, end), which ends with Finish, for one level and, while cells have to be split
  /// that were not looked at, for the next, up to `most`. `begin` and `end` are where progress
  /// goes. Returns what the last call returns.
  int Run(int most, const std::function<int(double, double)>& run);
  /// Makes Bezier cells by `options`, of which levels and steps are set here; or does nothing, if
  /// another run follows.
  vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made, BezierOptions options);

private:
  int FurtherSteps = 0;
  int Levels = 0;
  bool MayGoOn = false;
  bool GoesOn = false;
};

}

#endif
