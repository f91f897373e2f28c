// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceBounds.h"

#include "Private/Bounds/ErrorBounds.h"

#include "vtkPolyData.h"

namespace subdivision
{

bool AddSurfaceBounds(vtkPolyData* input, const SurfaceOptions& options, vtkPolyData* output)
{
  if (options.Scheme != SurfaceSchemeKind::Loop &&
    options.Scheme != SurfaceSchemeKind::CatmullClark &&
    options.Scheme != SurfaceSchemeKind::Linear)
  {
    options.Warn("Error bounds need Scheme = Loop, CatmullClark or Linear: GenerateErrorBounds is "
                 "ignored.");
    return true;
  }
  BoundedRun bounded{ input, output, options.Levels, false, false, nullptr, {} };
  bounded.Subdivide = [&](int levels, bool project, const RunOptions& shared,
                        MatrixFactors* factors) -> vtkSmartPointer<vtkPointSet>
  {
    SurfaceOptions other = options;
    static_cast<RunOptions&>(other) = shared;
    other.Factors = factors;
    other.Levels = levels;
    other.ProjectToLimit = project;
    other.GenerateLimitNormals = other.GenerateTangents = false;
    other.Cache = nullptr;
    const auto made = vtkSmartPointer<vtkPolyData>::New();
    return SubdivideSurface(input, other, made) ? made : nullptr;
  };
  return AddErrorBounds(bounded, options);
}

}
