// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunOptions.h
 * The options that all filters share, and the functions through which their work reports progress,
 * warnings and errors.
 */
#ifndef SubdivisionObjects_RunOptions_h
#define SubdivisionObjects_RunOptions_h

#include "Private/Arrays/PointArrays.h"
#include "Private/Run/Features.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace subdivision
{

class KeptEntries;
class MatrixFactors;
class OtherPartitions;
class ToldWarnings;
struct CellSplits;
struct PlaceRequest;

/// From where to where the progress of a filter goes during a part of its work.
struct ProgressPart
{
  double Begin = 0.;
  double End = 1.;

  double At(double done) const { return this->Begin + done * (this->End - this->Begin); }
  ProgressPart Take(double begin, double end) const { return { this->At(begin), this->At(end) }; }
};

struct RunOptions
{
  bool InterpolateIntegers = false;
  bool GenerateOriginalIds = false;
  bool GenerateGlobalIds = false;
  bool GenerateLimitNormals = false;
  bool GenerateTangents = false;
  int OutputPointsPrecision = 2;
  vtkIdType MaximumNumberOfCells = 500000000;
  FeatureOptions Features;
  bool HasMaterialFields = false; ///< MaterialFields.h has added arrays
  InterpolationOptions Interpolation;
  /// The part of the work in which ConnectToFilter makes `Progress` count.
  ProgressPart Part;
  /// Called with the fraction of the work that is done, or with a negative number, which means the
  /// last one; never goes back. Returns true if the work must stop.
  std::function<bool(double)> Progress;
  std::function<void(const std::string&)> Warn;
  ToldWarnings* Told = nullptr; ///< warnings of earlier time steps; null: nobody knows
  std::function<void(const std::string&)> Fail;
  /// The other partitions of the mesh of which the work gets a part; null: it gets all.
  OtherPartitions* Others = nullptr;
  /// How many layers of fine cells of other partitions around its own the output of a part needs.
  int GhostLayers = 0;
  /// Where the operator from points of the input to points of the output goes as a matrix; null:
  /// nowhere.
  MatrixFactors* Factors = nullptr;
  /// A further text in the warning of missing values (MissingValues.h).
  std::string* NoteOfMissing = nullptr;

  /// Whether something is computed from points before they are projected.
  bool HasFrames() const { return this->GenerateLimitNormals || this->GenerateTangents; }
};

/// The options of the filters that make a number of levels.
struct LevelOptions : RunOptions
{
  int Levels = 1;
  bool ProjectToLimit = false;
  /// Whether GenerateLimitNormals, which is on, counts only where nothing is sharp in the picture.
  bool NormalsWhereSmooth = false;
  bool Use32BitIds = false;
  /// Where operators and levels are kept; null: nowhere.
  KeptEntries* Cache = nullptr;
  /// Null, or places that are wanted, not an output.
  const PlaceRequest* Places = nullptr;
  /// Null, or of which cells children are wanted; then there is no stamp, and nothing is kept.
  CellSplits* Splits = nullptr;

  bool ReadsLimit() const { return this->ProjectToLimit || this->HasFrames(); }
};

/// Starts the points of an input and their arrays; `cells` and `globalIds`, which have to live on,
/// as in PointArrays. `isContinued`: an earlier filter of this kind made the input. `replaced`:
/// arrays that the filter makes itself, beside normals and tangents.
std::unique_ptr<PointArrays> StartPointArrays(const RunOptions& options, vtkPointSet* input,
  const SimplicesOfCells& cells, const std::vector<vtkIdType>& globalIds, bool isContinued,
  const std::function<void(const std::string&)>& warn, std::vector<std::string> replaced = {});

/// Passes warnings that were collected to Warn, and forgets them.
inline void Tell(std::vector<std::string>& warnings, const RunOptions& options)
{
  for (const std::string& warning : warnings)
  {
    options.Warn(warning);
  }
  warnings.clear();
}

}

#endif
