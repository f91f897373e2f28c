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
#include <string>
#include <vector>

namespace subdivision
{

class MatrixFactors;
class OtherPartitions;
class ToldWarnings;

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
};

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
