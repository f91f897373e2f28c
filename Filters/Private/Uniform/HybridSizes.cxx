// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridSizes.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Hybrid/HybridSkin.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Run/SizeChecks.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <array>
#include <cmath>
#include <numeric>

namespace subdivision
{

bool MakesLastLevel(const UniformOptions& options)
{
  return options.Scheme != StampScheme::Linear &&
    (options.ProjectToLimit || options.GenerateClassification ||
      (options.HasFrames() && options.Levels == 0));
}

template <typename Id>
HybridPlan PlanHybrid(const HybridLevel<Id>& control, const UniformOptions& options)
{
  HybridPlan plan{ MakesLastLevel(options), 0. };
  const bool wantsFrames = options.HasFrames() && options.Scheme != StampScheme::Linear;
  if (!plan.MakesLast && wantsFrames)
  {
    const CellComplex<Id>& complex = control.Complex;
    plan.MakesLast = !HasClosedSkin(control, options.Levels, options.GenerateTangents);
    // A face has one solid or two.
    plan.SkinFaces = plan.MakesLast ? 0.
      : complex.NumberOfTets > 0
      ? 2. * complex.NumberOfFaces - static_cast<double>(complex.CellFaces.Items.size())
      : complex.NumberOfTriangleCells;
  }
  return plan;
}

std::string CheckHybridSize(vtkPointSet* input, const HybridCells& cells,
  const UniformOptions& options, const HybridPlan& plan, double& corners)
{
  std::array<double, NumberOfShapes> counts{};
  for (const CellShape shape : InTurn(cells.Shapes))
  {
    ++counts[static_cast<std::size_t>(shape)];
  }
  for (int level = 0; level < options.Levels; ++level)
  {
    counts = CountChildren(counts);
  }
  counts[static_cast<int>(CellShape::Tet)] += 4. * counts[static_cast<int>(CellShape::Octahedron)];
  counts[static_cast<int>(CellShape::Octahedron)] = 0.;
  const double all = std::accumulate(counts.begin(), counts.end(), 0.);
  corners = 0.;
  for (int s = 0; s < NumberOfShapes; ++s)
  {
    corners += counts[s] * GetCellTable(static_cast<CellShape>(s)).Corners;
  }
  const double bytes = 8. * corners + 17. * all;
  const std::string tooMany =
    CheckNumberOfCells(all, bytes, options.Levels, options.MaximumNumberOfCells);
  if (!tooMany.empty())
  {
    return tooMany;
  }
  // About one point for each cell. The lists of the level before are smaller than the cells, for
  // which they make room.
  const double points = all + static_cast<double>(input->GetNumberOfPoints());
  // The last level, or its skin of quads, is a complex, too, where its limits are read.
  const double copies = plan.MakesLast ? 15. : options.Cache ? 2.2 : 1.3;
  const double frames = plan.MakesLast
    ? 0.
    : (options.GenerateLimitNormals ? 24. : 0.) + (options.GenerateTangents ? 48. : 0.);
  const double ofSkin = 15. * (8. * 4. + 17.) * plan.SkinFaces * std::pow(4., options.Levels);
  return CheckMemory(all, points,
    copies * bytes + ofSkin + all * (8. + GetBytesPerTuple(input->GetCellData())) +
      1.2 * points * (24. + frames + GetBytesPerTuple(input->GetPointData())),
    options.Levels);
}

SUBDIVISION_COMPILE_FUNCTION(PlanHybrid);

}
