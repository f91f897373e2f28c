// SPDX-License-Identifier: BSD-3-Clause
// How a surface subdivision interpolates.
#include "Private/Surface/SurfaceRun.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/MatrixFactors.h"
#include "Private/Values/SharedInterpolation.h"

#include <algorithm>

namespace subdivision
{

/// An earlier filter that made the input has solved for control points, or was not to.
template <typename Id>
bool SurfaceRun<Id>::Interpolates() const
{
  return this->Options.Interpolation.IsOn() && this->MadeLevels == 0;
}

/// Makes the level of `cells` alone, for its limits, or finds it kept.
template <typename Id>
void SurfaceRun<Id>::MakeControl(
  const SurfaceCells& cells, const SurfaceCreases& creases, KeptSurface<Id>* kept)
{
  this->Control = nullptr;
  if (!this->Interpolates())
  {
    return;
  }
  std::unique_ptr<SurfaceSteps<Id>> made = kept ? std::move(kept->Control) : nullptr;
  if (!made || !made->ReplaceSectors(this->Classify(made->GetLevel(0), creases.Features)))
  {
    SurfaceLevel<Id> level = MakeControlLevel<Id>(cells);
    level.Tags = this->Classify(level, creases.Features);
    made = std::make_unique<SurfaceSteps<Id>>(
      std::move(level), this->Scheme, 0, LastLevel::Whole, nullptr);
  }
  this->SetSharpness(*made, creases);
  this->Control = made.get();
  if (kept)
  {
    kept->Control = std::move(made);
  }
  else
  {
    this->Own.push_back(std::move(made));
  }
}

/// Replaces points and arrays by control values. Where there are seams the points of the joined
/// mesh are used.
template <typename Id>
void SurfaceRun<Id>::Interpolate()
{
  this->Solves = AgreeWithOthers(this->Interpolates(), this->Options);
  if (!this->Solves)
  {
    return;
  }
  InterpolationLimits limits;
  limits.LeastEigenvalue = this->Scheme->NeedsTriangles()
    ? GetLeastEigenvalue(this->Options.Features.Weights)
    : 0.1; // Mathematics 8
  ConnectToOthers(this->Input, this->NoCentres, this->Options, limits);
  const auto solve = [&](SurfaceSteps<Id>& control, bool points, bool arrays)
  {
    InterpolationOptions options = this->Options.Interpolation;
    options.Points = options.Points && points;
    options.Arrays = options.Arrays && arrays;
    if (options.Normals && points)
    {
      const LimitKind kinds[3] = { LimitKind::Position, LimitKind::Tangent1, LimitKind::Tangent2 };
      SparseRows<long long> rows[3];
      std::transform(kinds, kinds + 3, rows,
        [&control](LimitKind kind)
        {
          MatrixFactors factors;
          factors.Append(control.GetLimit(kind));
          return factors.Multiply();
        });
      this->Points->TurnLimits(rows, options, limits, this->Options.Warn);
      options.Points = false; // they are interpolated, too
    }
    options.Normals = nullptr;
    if (options.IsOn())
    {
      this->Points->Interpolate(
        control.GetLimit(LimitKind::Position).Store(), options, limits, this->Options.Warn);
    }
  };
  if (AgreeWithOthers(!this->JoinedControl, this->Options))
  {
    solve(*this->Control, true, true);
    return;
  }
  solve(this->JoinedControl ? *this->JoinedControl : *this->Control, true, false);
  solve(*this->Control, false, true);
}

SUBDIVISION_COMPILE(class SurfaceRun);

}
