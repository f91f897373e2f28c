// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ForecastRules.h
 * How much filters make, by the cells of the input and their options. Knows neither ParaView nor
 * Qt.
 */
#ifndef SubdivisionObjects_ForecastRules_h
#define SubdivisionObjects_ForecastRules_h

#include <array>

/// As GetControlCounts has them.
using ControlCounts = std::array<double, 9>;

/// About what an output has.
struct Forecast
{
  double Cells = 0.; ///< 0: the input has no data
  double Bytes = 0.;
  double Seconds = 0.;   ///< 0: nobody knows
  double Work = 0.;      ///< the cells that MaximumNumberOfCells limits
  bool IsAtMost = false; ///< there may be far fewer
};

/// The options that change an output. Numbers are those of the classes.
struct ForecastOptions
{
  enum Kinds
  {
    OfAllDimensions,
    OfSurfaces,
    RedGreen,
    Adaptive,
    OfLabels ///< vtkSubdivisionLabelSolid, where GetControlCounts would have voxels
  };
  int Kind = OfAllDimensions;
  int Levels = 0; ///< of local refinement: at most
  int Scheme = 0; ///< of surfaces
  int VolumeScheme = 0;
  bool KeepCellTypes = false;
  std::array<bool, 4> Dimensions{ { true, true, true, true } }; ///< of the output
  int OutputCells = 0;
  int CellOrder = 2;
  bool ReadsLimit = false; ///< projects, or adds normals or tangents
  bool AddsNormals = false;
  bool AddsTangents = false;
  bool AddsBounds = false;
  bool AddsClasses = false;
  double BytesPerPoint = 12.; ///< of coordinates and arrays of the input
  double BytesPerCell = 0.;   ///< of arrays of the input
  double MaximumNumberOfCells = 1e300;
  double MaximumNumberOfVoxels = 0.; ///< that labels keep; 0: all
};

/// About what comes out; of local refinement, and of Bezier cells, what comes out at most.
Forecast Foretell(const ControlCounts& counts, const ForecastOptions& options);

#endif
