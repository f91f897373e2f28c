// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelSolid.h
 * The work of vtkSubdivisionLabelSolid.
 */
#ifndef SubdivisionObjects_LabelSolid_h
#define SubdivisionObjects_LabelSolid_h

#include "Private/Run/RunOptions.h"

#include "vtkType.h"

#include <functional>
#include <string>

class vtkDataArray;
class vtkDataSet;
class vtkFieldData;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace subdivision
{

/// The progress at which the labels are read and solids begin.
constexpr double LabelsAreRead = .05;

struct LabelSolidOptions : RunOptions
{
  vtkDataArray* Labels = nullptr; ///< of the image or grid, one for each voxel
  bool OfPoints = false;          ///< voxels are around points; false: they are the cells
  vtkIdType Background = 0;
  vtkIdType WantedCells = 0; ///< of the control mesh; 0: one for each voxel
  bool ByCorners = true;     ///< whether voxels that touch in an edge or corner are connected
  bool KeepConnected = true;
  bool FlatBorder = true;
  int SmoothingSteps = 0;
  double LargestMove = 0.; ///< in control voxels
  int Levels = 0;
  bool Hexahedra = false;            ///< what Subdivide makes; false: tetrahedra
  vtkFieldData* Materials = nullptr; ///< a table; null: there is none
  /// Makes the limit that passes through the points of a grid of hexahedra, with interfaces between
  /// labels, creases at lines between points of the grid, and original ids, unless all cells are
  /// those of the grid. Returns null after an error or a stop.
  std::function<vtkUnstructuredGrid*(vtkUnstructuredGrid*, vtkPolyData*)> Subdivide;
  /// The same with curved cells, once, when the solid is good; empty: they stay linear.
  std::function<vtkUnstructuredGrid*(vtkUnstructuredGrid*, vtkPolyData*)> Curve;
};

/// The name of the output's labels.
std::string GetLabelName(const LabelSolidOptions& options);

/// Returns false after an error or a stop.
bool MakeLabelSolid(
  vtkDataSet* image, const LabelSolidOptions& options, vtkUnstructuredGrid* output);

}

#endif
