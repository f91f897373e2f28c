// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/UniformBounds.h"

#include "Private/Bounds/ErrorBounds.h"

#include "vtkUnstructuredGrid.h"

namespace subdivision
{

bool AddUniformBounds(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
{
  if (options.KeepCellTypes)
  {
    options.Warn(
      "Cells that keep their type have no error bounds (VolumeScheme = Hybrid, KeepCellTypes): "
      "GenerateErrorBounds is ignored.");
    return true;
  }
  BoundedRun bounded;
  bounded.Input = input;
  bounded.Output = output;
  bounded.Levels = options.Levels;
  bounded.KnowsParts = true;
  bounded.IsTetOct = options.Scheme == StampScheme::TetOct;
  bounded.Subdivide = [&](int levels, bool project, const RunOptions& shared,
                        MatrixFactors* factors) -> vtkSmartPointer<vtkPointSet>
  {
    UniformOptions other;
    static_cast<RunOptions&>(other) = shared;
    other.GenerateLimitNormals = other.GenerateTangents = false;
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
