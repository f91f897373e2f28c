// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceBounds.h"

#include "Private/Bounds/ErrorBounds.h"
#include "Private/Bounds/PartsAsCells.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"
#include "vtkType.h"

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
  BoundedRun bounded;
  bounded.Input = input;
  bounded.Output = output;
  bounded.Levels = options.Levels;
  bounded.HasThirds = options.Scheme == SurfaceSchemeKind::SqrtThree;
  const auto subdivide = [](vtkPolyData* mesh, SurfaceOptions& other, int levels,
                           MatrixFactors* factors) -> vtkSmartPointer<vtkPointSet>
  {
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
    static_cast<RunOptions&>(other) = shared;
    other.ProjectToLimit = project;
    return subdivide(input, other, levels, factors);
  };
  if (bounded.HasThirds && options.Features.ModifiedBoundary)
  {
    bounded.SubdividePlain = [&](int levels, const RunOptions& shared, MatrixFactors* factors)
    {
      SurfaceOptions other = options;
      static_cast<RunOptions&>(other) = shared;
      other.ProjectToLimit = false;
      other.Features.ModifiedBoundary = false;
      return subdivide(input, other, levels, factors);
    };
  }
  bounded.SubdividePatch =
    [&](vtkPolyData* patch, int levels, const RunOptions& shared, MatrixFactors* factors)
  {
    SurfaceOptions other;
    static_cast<RunOptions&>(other) = shared;
    other.Scheme = options.Scheme;
    other.Features = FeatureOptions();
    other.Features.ModifiedBoundary = false; // patches end anywhere
    other.Features.Singular = patch->GetCellData()->GetArray(PatchSingularName);
    other.MaximumNumberOfCells = VTK_ID_MAX; // which users give for meshes
    return subdivide(patch, other, levels, factors);
  };
  return AddErrorBounds(bounded, options);
}

}
