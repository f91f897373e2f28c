// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Classification.h
 * How the mesh was understood, as point arrays.
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

/// Adds both arrays: the rules and types of old vertices, then of the edges whose points are new.
void AddRules(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges, vtkPointSet* input,
  vtkUnstructuredGrid* output);

}

#endif
