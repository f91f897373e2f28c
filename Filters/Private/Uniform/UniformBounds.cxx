// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/UniformBounds.h"

#include "Private/Bounds/ErrorBounds.h"

#include "vtkUnstructuredGrid.h"

namespace subdivision
{

bool AddUniformBounds(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
{
  if (options.KeepCellTypes || options.Scheme == StampScheme::TetOct)
  {
    options.Warn("Error bounds need VolumeScheme = BoxSpline or Linear, and no KeepCellTypes: "
                 "GenerateErrorBounds is ignored.");
    return true;
  }
  BoundedRun bounded{ input, output, options.Levels, true, {} };
  bounded.Subdivide = [&](int levels, bool project, const RunOptions& shared,
                        MatrixFactors* factors) -> vtkSmartPointer<vtkPointSet>
  {
    UniformOptions other;
    static_cast<RunOptions&>(other) = shared;
    other.Factors = factors;
    other.Levels = levels;
    other.Scheme = options.Scheme;
    other.ProjectToLimit = project;
    const auto made = vtkSmartPointer<vtkUnstructuredGrid>::New();
    return SubdivideUniformly(input, other, made) ? made : nullptr;
  };
  return AddErrorBounds(bounded, options);
}

}
