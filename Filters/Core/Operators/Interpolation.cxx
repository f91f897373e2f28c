// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/Interpolation.h"

#include "Core/Memory/Coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace subdivision
{
namespace
{

/// The largest rounding error of a limit, as a part of the largest value: rows are means.
constexpr double LimitUnit = 32. * DoubleUnit;

/// The iteration for all groups together. Each of them ends by itself, when the others do not
/// matter.
class Chebyshev
{
public:
  Chebyshev(const PointOperator& limit, const double* given,
    std::vector<InterpolationGroup>& groups, const InterpolationLimits& limits, double* shifts)
    : Limit(limit)
    , Limits(limits)
    , Groups(groups)
    , Shifts(shifts)
  {
    for (std::size_t g = 0; g < groups.size(); ++g)
    {
      const std::size_t first = this->GroupOfComponent.size();
      this->GroupOfComponent.insert(this->GroupOfComponent.end(), groups[g].Components, g);
      for (int c = 0; c < groups[g].Components * groups[g].Fields; ++c)
      {
        const int field = c / groups[g].Components;
        this->Columns.push_back({ g, first + c % groups[g].Components, groups[g].Fields,
          groups[g].Factors ? groups[g].Factors + field : nullptr });
      }
    }
    const vtkIdType size = limit.GetNumberOfRows() * this->GetColumns();
    this->Residuals = Buffer<double>(size);
    this->Products = Buffer<double>(size);
    this->Steps = Buffer<double>(size, 0.);
    std::fill_n(shifts, size, 0.);
    this->HasEnded.assign(groups.size(), 0);
    this->FindRanges(given);
    this->Multiply(given);
    ForEach(size, [&](vtkIdType i)
      { this->Residuals[i] = this->HasValue(i) ? given[i] - this->Products[i] : 0.; });
  }

  /// Gives group g no more than most[g] products. Returns after which the error was least.
  std::vector<int> Solve(const std::vector<int>& most)
  {
    const double middle = (1. + this->Limits.LeastEigenvalue) / 2.;
    const double half = (1. - this->Limits.LeastEigenvalue) / 2.;
    std::vector<int> best(this->Groups.size(), 1);
    std::vector<double> least(this->Groups.size(), std::numeric_limits<double>::infinity());
    double ratio = half / middle;
    double ofStep = 0.;
    double ofResidual = 1. / middle;
    for (int products = 1; this->GoOn(products, most, best, least); ++products)
    {
      this->Advance(ofStep, ofResidual);
      const double next = 1. / (2. * middle / half - ratio);
      ofStep = next * ratio;
      ofResidual = 2. * next / half;
      ratio = next;
    }
    return best;
  }

private:
  struct Column
  {
    std::size_t Group;
    std::size_t Component;
    vtkIdType Fields;
    const double* Factors; ///< null: 1
  };

  int GetColumns() const { return static_cast<int>(this->Columns.size()); }

  double GetFactor(vtkIdType i) const
  {
    const vtkIdType columns = this->GetColumns();
    const Column& column = this->Columns[i % columns];
    return column.Factors ? column.Factors[column.Fields * (i / columns)] : 1.;
  }
  /// Whether the field of a column has a value in a row.
  bool HasValue(vtkIdType i) const { return this->GetFactor(i) != 0.; }

  /// The largest value(i) of each component, over all finite ones that a field has.
  template <typename Value>
  std::vector<double> FindLargest(const Value& value) const
  {
    const vtkIdType columns = this->GetColumns();
    std::vector<double> largest(
      this->GroupOfComponent.size(), -std::numeric_limits<double>::infinity());
    std::mutex mutex;
    ForRanges(this->Limit.GetNumberOfRows(),
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<double> here(largest.size(), -std::numeric_limits<double>::infinity());
        for (vtkIdType i = columns * begin; i < columns * end; ++i)
        {
          const double v = value(i);
          double& most = here[this->Columns[i % columns].Component];
          most = std::isfinite(v) && v > most && this->HasValue(i) ? v : most;
        }
        const std::lock_guard<std::mutex> lock(mutex);
        std::transform(here.begin(), here.end(), largest.begin(), largest.begin(),
          [](double a, double b) { return std::max(a, b); });
      });
    if (this->Limits.FindLargest)
    {
      this->Limits.FindLargest(largest);
    }
    return largest;
  }

  /// Finds the range of each group, which is the largest of its components, and the error that it
  /// may have.
  void FindRanges(const double* given)
  {
    const std::vector<double> high = this->FindLargest([&](vtkIdType i) { return given[i]; });
    const std::vector<double> low = this->FindLargest([&](vtkIdType i) { return -given[i]; });
    this->Ranges.assign(this->Groups.size(), 0.);
    this->Allowed.assign(this->Groups.size(), 0.);
    for (InterpolationGroup& group : this->Groups)
    {
      group.Range.clear();
    }
    for (std::size_t c = 0; c < this->GroupOfComponent.size(); ++c)
    {
      const std::size_t g = this->GroupOfComponent[c];
      this->Groups[g].Range.insert(this->Groups[g].Range.end(), { -low[c], high[c] });
      this->Ranges[g] = std::max(this->Ranges[g], high[c] + low[c]);
      this->Allowed[g] = std::max({ this->Allowed[g], LimitUnit * high[c], LimitUnit * low[c],
        this->Limits.Tolerance * this->Ranges[g] });
    }
  }

  /// Ends groups that have converged, and those that may have no more products. Returns whether
  /// there are others.
  bool GoOn(
    int products, const std::vector<int>& most, std::vector<int>& best, std::vector<double>& least)
  {
    std::vector<double> errors(this->Groups.size(), 0.);
    const std::vector<double> ofComponents =
      this->FindLargest([&](vtkIdType i) { return std::abs(this->Residuals[i]); });
    for (std::size_t c = 0; c < ofComponents.size(); ++c)
    {
      double& error = errors[this->GroupOfComponent[c]];
      error = std::max(error, ofComponents[c]);
    }
    for (std::size_t g = 0; g < this->Groups.size(); ++g)
    {
      if (!this->HasEnded[g])
      {
        InterpolationGroup& group = this->Groups[g];
        group.Products = products;
        group.Error = this->Ranges[g] > 0. ? errors[g] / this->Ranges[g] : 0.;
        group.HasConverged = errors[g] <= this->Allowed[g];
        best[g] = errors[g] < least[g] ? products : best[g];
        least[g] = std::min(least[g], errors[g]);
        this->HasEnded[g] = group.HasConverged || products >= most[g];
      }
    }
    return std::count(this->HasEnded.begin(), this->HasEnded.end(), 0) > 0;
  }

  /// Adds the next step to the shifts of groups that go on.
  void Advance(double ofStep, double ofResidual)
  {
    const vtkIdType columns = this->GetColumns();
    ForEach(this->Steps.size(),
      [&](vtkIdType i)
      {
        const double residual = this->Residuals[i];
        this->Steps[i] =
          std::isfinite(residual) ? ofStep * this->Steps[i] + ofResidual * residual : 0.;
        this->Shifts[i] += this->HasEnded[this->Columns[i % columns].Group] ? 0. : this->Steps[i];
      });
    this->Multiply(this->Steps.data());
    ForEach(this->Steps.size(),
      [&](vtkIdType i)
      {
        double& residual = this->Residuals[i];
        residual -= std::isfinite(residual) ? this->Products[i] : 0.;
      });
  }

  void Multiply(const double* values)
  {
    this->Limit.Apply(values, this->Products.data(), this->GetColumns());
    if (this->Limits.TakeOthers)
    {
      this->Limits.TakeOthers(this->Products.data(), this->GetColumns());
    }
    if (std::any_of(this->Columns.begin(), this->Columns.end(),
          [](const Column& column) { return column.Factors != nullptr; }))
    {
      ForEach(this->Products.size(), [&](vtkIdType i) { this->Products[i] *= this->GetFactor(i); });
    }
  }

  const PointOperator& Limit;
  const InterpolationLimits& Limits;
  std::vector<InterpolationGroup>& Groups;
  std::vector<Column> Columns;
  std::vector<std::size_t> GroupOfComponent; ///< of the components of all groups
  double* Shifts;
  Buffer<double> Residuals; ///< NaN where there is no shift
  Buffer<double> Products;
  Buffer<double> Steps;
  std::vector<double> Ranges;
  std::vector<double> Allowed;
  std::vector<char> HasEnded;
};

}

void FindInterpolation(const PointOperator& limit, const double* given,
  std::vector<InterpolationGroup>& groups, const InterpolationLimits& limits, double* shifts)
{
  const std::vector<int> most(groups.size(), limits.MostProducts);
  const std::vector<int> best = Chebyshev(limit, given, groups, limits, shifts).Solve(most);
  const bool isBest = std::equal(groups.begin(), groups.end(), best.begin(),
    [](const InterpolationGroup& group, int products) { return group.Products == products; });
  if (!isBest)
  {
    Chebyshev(limit, given, groups, limits, shifts).Solve(best);
  }
}

}
