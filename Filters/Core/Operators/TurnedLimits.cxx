// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/TurnedLimits.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Operators/DirectSolver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace subdivision
{
namespace
{

/// Calls use(shift, weight) for each shift of an equation.
template <typename Use>
void ForEntries(const double* equation, const Use& use)
{
  for (int k = 0; k < static_cast<int>(equation[3]); ++k)
  {
    use(static_cast<std::size_t>(equation[4 + 2 * k]), equation[5 + 2 * k]);
  }
}

double Dot(const double* a, const double* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The equations for the limits of one part of a mesh, as numbers that it sends, one after the
/// other: one by which they are sorted; what is wanted of shifts; the only shift that it moves, -1:
/// all that it has; how many it has; and each of these with its weight. Shift 3 i + c is component
/// c of control point i.
struct Equations
{
  const double* Points;
  const WholeSystem& Whole;
  std::vector<double> List = {};

  /// Appends: the sum over a row of `vector` times the shifts is `part` of `vector` times `place`,
  /// less what it is for the points. Returns false, and appends nothing, if the row has no weights.
  bool Append(const SparseRows<long long>& rows, vtkIdType i, const double* vector, double part,
    const double* place, int which)
  {
    const std::size_t begin = this->List.size();
    const auto own = static_cast<double>(this->Whole.Numbers[i]);
    double wanted = Dot(vector, place);
    this->List.insert(
      this->List.end(), { 5. * own + which, 0., which < 3 ? 3. * own + which : -1., 0. });
    for (vtkIdType k = rows.Offsets[i]; k < rows.Offsets[i + 1]; ++k)
    {
      const auto column = static_cast<double>(this->Whole.Numbers[rows.Columns[k]]);
      wanted -= rows.Weights[k] * Dot(vector, this->Points + 3 * rows.Columns[k]);
      for (int c = 0; c < 3; ++c)
      {
        const double weight = rows.Weights[k] * vector[c];
        if (weight != 0. && column >= 0.)
        {
          this->List.insert(this->List.end(), { 3. * column + c, weight });
          this->List[begin + 3] += 1.;
        }
      }
    }
    this->List[begin + 1] = part * wanted;
    const bool isUsed = this->List[begin + 3] > 0. && std::isfinite(wanted);
    this->List.resize(isUsed ? this->List.size() : begin);
    return isUsed;
  }
};

/// Solves the equations. Returns the shifts, and behind them the largest error; only this if
/// factors do not fit into memory.
std::vector<double> Solve(const std::vector<double>& list, vtkIdType points, double mostBytes)
{
  std::vector<const double*> equations;
  for (std::size_t at = 0; at < list.size(); at += 4 + 2 * static_cast<std::size_t>(list[at + 3]))
  {
    equations.push_back(list.data() + at);
  }
  StableSort(equations, [](const double* a, const double* b) { return a[0] < b[0]; });
  equations.erase( // several parts have the points between them
    std::unique(equations.begin(), equations.end(),
      [](const double* a, const double* b) { return a[0] == b[0]; }),
    equations.end());
  const auto number = static_cast<vtkIdType>(equations.size());
  std::vector<double> shifts(static_cast<std::size_t>(3 * points), 0.);
  std::vector<std::vector<std::pair<vtkIdType, double>>> movers(shifts.size()); // of each shift
  for (const vtkIdType e : InTurn(number))
  {
    const auto add = [&](std::size_t shift, double weight)
    { movers[shift].emplace_back(e, weight); };
    const double own = equations[e][2];
    own < 0. ? ForEntries(equations[e], add) : add(static_cast<std::size_t>(own), 1.);
  }
  std::vector<double> rows; // entries of equal columns are added
  for (const vtkIdType e : InTurn(number))
  {
    rows.insert(rows.end(), { static_cast<double>(e), 0. });
    const std::size_t count = rows.size() - 1;
    ForEntries(equations[e],
      [&](std::size_t shift, double weight)
      {
        for (const auto& mover : movers[shift])
        {
          rows.insert(rows.end(), { static_cast<double>(mover.first), weight * mover.second });
          rows[count] += 1.;
        }
      });
  }
  DirectSolver solver;
  double error = number > 0 ? std::numeric_limits<double>::infinity() : 0.;
  if (number > 0 && !solver.Factorise(number, rows, mostBytes))
  {
    return { error };
  }
  std::vector<double> residuals(equations.size());
  for (int round = number > 0 ? 0 : 5; round < 5; ++round)
  {
    error = 0.;
    for (const vtkIdType e : InTurn(number))
    {
      residuals[e] = equations[e][1];
      ForEntries(equations[e],
        [&](std::size_t shift, double weight) { residuals[e] -= weight * shifts[shift]; });
      const double size = std::abs(residuals[e]);
      error = size <= error || std::isnan(error) ? error : size;
    }
    solver.Solve(residuals);
    for (const std::size_t shift : InTurn(round < 4 ? shifts.size() : std::size_t(0)))
    {
      for (const auto& mover : movers[shift])
      {
        shifts[shift] += mover.second * residuals[mover.first];
      }
    }
  }
  shifts.push_back(error);
  return shifts;
}

}

TurnedLimits FindTurnedLimits(const SparseRows<long long>* rows, const WantedLimits& wanted,
  const InterpolationLimits& limits, std::vector<double>& shifts)
{
  TurnedLimits found;
  const vtkIdType size = rows[0].GetNumberOfRows();
  const WholeSystem whole = limits.FindWhole ? limits.FindWhole() : WholeSystem(size);
  Equations equations{ wanted.Points, whole };
  for (const vtkIdType i : InTurn(size))
  {
    const double* n = wanted.Normals + 3 * i;
    const double length = std::hypot(n[0], n[1], n[2]);
    bool hasTangent = length == 0.;
    for (int which = 0; which < 5 && whole.AreOwn[i] && whole.Numbers[i] >= 0; ++which)
    {
      const double axis[3] = { which == 0 ? 1. : 0., which == 1 ? 1. : 0., which == 2 ? 1. : 0. };
      if (which < 3 && wanted.Parts[i] != 0.)
      {
        equations.Append(rows[0], i, axis, wanted.Parts[i], wanted.Points + 3 * i, which);
      }
      if (which < 3 || length == 0.)
      {
        continue;
      }
      const SparseRows<long long>& tangent = rows[which - 2];
      double square = 0.; // of all weights: so tangents of all points count alike
      for (vtkIdType k = tangent.Offsets[i]; k < tangent.Offsets[i + 1]; ++k)
      {
        square += tangent.Weights[k] * tangent.Weights[k];
      }
      const double unit = std::sqrt(square) * length;
      const double along[3] = { n[0] / unit, n[1] / unit, n[2] / unit };
      hasTangent |= square > 0. && equations.Append(tangent, i, along, 1., axis, which);
    }
    if (!hasTangent && whole.AreOwn[i])
    {
      found.FirstFlat = found.NumberFlat++ == 0 ? i : found.FirstFlat;
    }
  }
  if (whole.ToSolver(equations.List))
  {
    equations.List = Solve(equations.List, whole.Size,
      limits.FindMemory ? limits.FindMemory() : std::numeric_limits<double>::infinity());
  }
  whole.FromSolver(equations.List);
  std::vector<double> extent{ wanted.Extent };
  limits.FindLargest ? limits.FindLargest(extent) : void();
  found.HasConverged = equations.List.back() <= limits.Tolerance * extent[0];
  shifts.assign(static_cast<std::size_t>(3 * size), 0.);
  for (const vtkIdType i : InTurn(found.HasConverged ? size : vtkIdType(0)))
  {
    if (whole.Numbers[i] >= 0)
    {
      std::copy_n(equations.List.begin() + 3 * whole.Numbers[i], 3, shifts.begin() + 3 * i);
    }
  }
  return found;
}

}
