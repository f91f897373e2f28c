// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceBounds.h"

#include "Private/Bounds/DeeperThirds.h"
#include "Private/Bounds/ErrorBounds.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

namespace subdivision
{

bool AddSurfaceBounds(vtkPolyData* input, const SurfaceOptions& options, vtkPolyData* output)
{
  if (options.Scheme != SurfaceSchemeKind::Loop &&
    options.Scheme != SurfaceSchemeKind::CatmullClark &&
    options.Scheme != SurfaceSchemeKind::SqrtThree && options.Scheme != SurfaceSchemeKind::Linear)
  {
    options.Warn("Error bounds need Scheme = Loop, CatmullClark, SqrtThree or Linear: "
                 "GenerateErrorBounds is ignored.");
    return true;
  }
  const bool hasThirds = options.Scheme == SurfaceSchemeKind::SqrtThree;
  BoundedRun bounded{ input, output, options.Levels, false, false, hasThirds, nullptr, {}, {} };
  const auto subdivide = [](vtkPolyData* mesh, SurfaceOptions other, const RunOptions& shared,
                           int levels, MatrixFactors* factors) -> vtkSmartPointer<vtkPointSet>
  {
    const FeatureOptions features = other.Features;
    static_cast<RunOptions&>(other) = shared;
    other.Features = features;
    other.Factors = factors;
    other.Levels = levels;
    other.GenerateLimitNormals = other.GenerateTangents = false;
    other.Cache = nullptr;
    const auto made = vtkSmartPointer<vtkPolyData>::New();
    return SubdivideSurface(mesh, other, made) ? made : nullptr;
  };
  bounded.Subdivide = [&](
                        int levels, bool project, const RunOptions& shared, MatrixFactors* factors)
  {
    SurfaceOptions other = options;
    other.ProjectToLimit = project;
    return subdivide(input, other, shared, levels, factors);
  };
  bounded.SubdividePatch =
    [&](vtkPolyData* patch, int levels, const RunOptions& shared, MatrixFactors* factors)
  {
    SurfaceOptions other;
    other.Scheme = options.Scheme;
    other.Features.Singular = patch->GetCellData()->GetArray(PatchSingularName);
    return subdivide(patch, other, shared, levels, factors);
  };
  return AddErrorBounds(bounded, options);
}

}
