// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BezierCells.h
 * Writes a mesh on the limit as Bezier cells of VTK.
 */
#ifndef SubdivisionObjects_BezierCells_h
#define SubdivisionObjects_BezierCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <memory>
#include <string>

class vtkDataObject;
class vtkMultiProcessController;

namespace subdivision
{

struct BezierOptions
{
  /// How often a cell may be split.
  int Levels = 0;
  /// How many steps were made: Levels and CountFurtherSteps.
  int Steps = 0;
  /// Whether cells may be split more often, by further steps: then nothing is written if there are
  /// some of which this is not known yet.
  bool MayGoOn = false;
  /// Whether the data has all cells of the run.
  bool IsWhole = true;
  vtkIdType MaximumNumberOfCells = VTK_ID_MAX; ///< in this process
  /// The distance that Bezier cells may have, as a fraction of the diagonal of the mesh, and of an
  /// array's range.
  double Tolerance = 0.;
  bool Use32BitIds = false;
  /// The ranks that have parts of the mesh; null: this process has all.
  vtkMultiProcessController* Controller = nullptr;
  /// Called with an error, where Steps are too few for a cell. Such cells stay linear.
  std::function<void(const std::string&)> Fail;
};

/// Whether an input has solids or, where faces become quads, faces that are none. `input`: from
/// ReadableMesh.h; null: not known.
bool HasOtherCells(vtkDataObject* input, bool toQuads);
/// How many steps beyond Levels an input needs: more if it has solids or, where faces become quads,
/// faces that are none. `input`: from ReadableMesh.h; null: not known.
int CountFurtherSteps(vtkDataObject* input, bool toQuads);

/**
 * Makes a grid of Bezier cells of a mesh that was split uniformly and moved to the limit, or of
 * each mesh of a composite data set. The cells of a cell of the control mesh follow one another.
 * Each control cell becomes one Bezier cell if that is the limit, up to two thirds of the
 * tolerance, at the points of one further step: so the tolerance is kept between these too. Else
 * its children do, down to `Levels`.
 *
 * All cells have one degree, the largest that one of them needs. Control points that equal cells
 * share, by the points of the mesh, are one point. Arrays of
 * floating point numbers get control values, all others the values of the point that the control
 * point belongs to. Cells of other types stay. Field data are shared, but for a stamp. All ranks
 * call this together.
 */
vtkSmartPointer<vtkDataObject> MakeBezierCells(vtkDataObject* data, const BezierOptions& options);

struct BezierState;
struct CellSplits;

/// The runs of a filter that make Bezier cells: with as many steps as some cell needs, and no more.
/// After the first run each makes only cells that have to be split, where it can (CellSplits.h).
class BezierRounds
{
public:
  BezierRounds();
  ~BezierRounds();

  /// Says how many steps beyond levels an input needs (CountFurtherSteps).
  void SetFurtherSteps(int further) { this->FurtherSteps = further; }
  /// Calls run(), which ends with Finish, for one level, and for the next, up to `most`, while
  /// cells have to be split that were not looked at. Calls it once if `most` is negative: then
  /// there are no Bezier cells. Returns the result of the last call. `options`: of the run.
  template <typename Options>
  int Run(int most, Options& options, const std::function<int()>& run)
  {
    auto* const cache = options.Cache;
    const auto runPart = [&](double begin, double end)
    {
      options.Part = { begin, end };
      options.Splits = most < 0 ? nullptr : this->GetSplits();
      options.Cache = options.Splits ? nullptr : cache; // only whole levels are kept
      return run();
    };
    const int result = most < 0 ? runPart(0., 1.) : this->Run(most, runPart);
    if (cache)
    {
      cache->ForgetUnused();
    }
    return result;
  }
  /// Sets the levels of a run. Its cells do not count: there will be fewer of them.
  template <typename Options>
  void SetLevels(Options& options) const
  {
    options.Levels = this->Levels + this->FurtherSteps;
    options.MaximumNumberOfCells = VTK_ID_MAX;
  }
  /// Makes Bezier cells by `options`, of which levels and steps are set here; or does nothing, if
  /// another run follows.
  vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made, BezierOptions options);

private:
  int Run(int most, const std::function<int(double, double)>& run);
  CellSplits* GetSplits() const;

  int FurtherSteps = 0;
  int Levels = 0;
  bool MayGoOn = false;
  bool GoesOn = false;
  std::unique_ptr<BezierState> Now; ///< while a filter runs
};

}

#endif
