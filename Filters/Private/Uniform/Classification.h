// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Classification.h
 * Adds the point arrays of GenerateClassification.
 */
#ifndef SubdivisionObjects_Classification_h
#define SubdivisionObjects_Classification_h

#include "Core/Solids/Strata/Strata.h"

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

constexpr const char* RuleName = "RuleDimension";
constexpr const char* TypeName = "NonManifoldType";

/// Adds both arrays. `vertices` and `edges` are the strata of the level before, whose edges have
/// the new points.
void AddRules(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges, vtkPointSet* input,
  vtkUnstructuredGrid* output);

}

#endif
