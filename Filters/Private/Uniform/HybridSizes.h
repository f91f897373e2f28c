// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridSizes.h
 * How large an output gets whose cells keep their types.
 */
#ifndef SubdivisionObjects_HybridSizes_h
#define SubdivisionObjects_HybridSizes_h

#include "Core/Solids/Hybrid/HybridLevel.h"
#include "Private/Uniform/HybridCells.h"
#include "Private/Uniform/UniformSubdivision.h"

#include <string>

namespace subdivision
{

/// Whether the rules of the last level are read, whatever the mesh is.
bool MakesLastLevel(const UniformOptions& options);

/// Which parts of the last level are made beside its cells.
struct HybridPlan
{
  bool MakesLast = false;
  double SkinFaces = 0.; ///< of the control mesh, whose children are a level of their own
};

/// Decides that. Normals and tangents of some meshes need the last level, of others its skin
/// (HybridSkin.h).
template <typename Id>
HybridPlan PlanHybrid(const HybridLevel<Id>& control, const UniformOptions& options);

/// An error message if the output is too large. `corners`: how many its cells have.
std::string CheckHybridSize(vtkPointSet* input, const HybridCells& cells,
  const UniformOptions& options, const HybridPlan& plan, double& corners);

}

#endif
