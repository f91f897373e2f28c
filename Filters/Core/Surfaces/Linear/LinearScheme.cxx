// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Linear/LinearScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"

namespace subdivision
{
namespace
{

template <typename Id>
class LinearSurfaceScheme : public PrimalScheme<Id, 3>
{
public:
  bool HasLimitStars() const override { return false; }
  FaceMemory GetFaceMemory() const override { return { 32., 0.5, 24., 24., 88., 232., 24. }; }
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>&, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override
  {
    const vtkIdType vertices = level.Mesh.NumberOfVertices;
    for (vtkIdType row = begin; row < end; ++row)
    {
      if (row < vertices)
      {
        rows.Add(row, 1.);
      }
      else
      {
        rows.Add(level.Mesh.EdgeVertices[2 * (row - vertices)], 0.5);
        rows.Add(level.Mesh.EdgeVertices[2 * (row - vertices) + 1], 0.5);
      }
      rows.EndRow();
    }
  }

  bool HasLimitsOfNext(const SurfaceLevel<Id>& level, bool tangents) const override
  {
    return !tangents && level.Mesh.Arity > 0;
  }
  /// There are no tangent planes at vertices: these rows are empty.
  void AppendLimitRows(const SurfaceLevel<Id>&, const SurfaceTags<Id>&, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    for (vtkIdType row = begin; row < end; ++row)
    {
      if (kind == LimitKind::Position)
      {
        rows.Add(row, 1.);
      }
      rows.EndRow();
    }
  }
};

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeLinearScheme()
{
  return std::make_unique<LinearSurfaceScheme<Id>>();
}

SUBDIVISION_COMPILE_FUNCTION(MakeLinearScheme);

}
