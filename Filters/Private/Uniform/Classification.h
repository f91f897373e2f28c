// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Classification.h
 * The arrays of GenerateClassification, and the warning of solids that are inside out.
 */
#ifndef SubdivisionObjects_Classification_h
#define SubdivisionObjects_Classification_h

#include "Core/Rules/Stratum.h"
#include "Private/Reading/SolidOrientation.h"
#include "Private/Run/RunOptions.h"

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkPointSet;

namespace subdivision
{

// Of points.
constexpr const char* RuleName = "RuleDimension";
constexpr const char* TypeName = "NonManifoldType";
// Of cells.
constexpr const char* DimensionName = "ManifoldDimension";
constexpr const char* InvertedName = "Inverted"; ///< solids that smoothing turned inside out

/// Adds both arrays of points to the output.
void AddRules(
  const std::function<Stratum(vtkIdType)>& ofPoint, vtkPointSet* input, vtkPointSet* output);

/// Warns of solids that smoothing turned inside out, if they are many.
void TellInverted(const InvertedCells& found, vtkIdType cells, const RunOptions& options);

/// Adds a cell array instead of the input's.
void AddToCells(const char* name, const std::vector<unsigned char>& values, vtkPointSet* input,
  vtkPointSet* output);

}

#endif
