// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/Interpolation.h"

#include "Core/Memory/Coordinates.h"
#include "Core/Operators/DirectSolver.h"
#include "Core/Operators/MatrixFactors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace subdivision
{
namespace
{

/// The largest rounding error of a limit, as a fraction of the largest value: rows are means.
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
    , Given(given)
    , Shifts(shifts)
  {
    for (std::size_t g = 0; g < groups.size(); ++g)
    {
      const auto materials = static_cast<std::size_t>(groups[g].NumberOfMaterials);
      for (int c = 0; c < groups[g].Components * groups[g].Fields; ++c)
      {
        const int field = c / groups[g].Components;
        const auto component = static_cast<std::size_t>(c % groups[g].Components);
        this->Columns.push_back({ g, this->Units.size() + materials * component, groups[g].Fields,
          groups[g].Factors ? groups[g].Factors + field : nullptr,
          groups[g].Materials ? groups[g].Materials + field : nullptr });
      }
      this->Units.resize(
        this->Units.size() + materials * static_cast<std::size_t>(groups[g].Components));
    }
    const vtkIdType size = limit.GetNumberOfRows() * this->GetColumns();
    this->Residuals = Buffer<double>(size);
    this->Products = Buffer<double>(size);
    this->Steps = Buffer<double>(size, 0.);
    std::fill_n(shifts, size, 0.);
    this->HasEnded.assign(groups.size(), 0);
    this->FindRanges();
    this->Start();
  }

  void Solve()
  {
    const double middle = (1. + this->Limits.LeastEigenvalue) / 2.;
    const double half = (1. - this->Limits.LeastEigenvalue) / 2.;
    double ratio = half / middle;
    double ofStep = 0.;
    double ofResidual = 1. / middle;
    for (int products = 1; this->GoOn(products); ++products)
    {
      this->Advance(ofStep, ofResidual);
      const double next = 1. / (2. * middle / half - ratio);
      ofStep = next * ratio;
      ofResidual = 2. * next / half;
      ratio = next;
    }
  }

  /// Solves for the columns of groups that did not converge. Where this fails too, their shifts
  /// come from the iteration, or are none, whatever is nearer.
  void SolveDirectly()
  {
    Buffer<double> shifts(this->Steps.size());
    CopyInThreads(this->Shifts, shifts.size(), shifts.data());
    this->Start();
    const std::vector<double> without = this->FindErrors();
    const vtkIdType columns = this->GetColumns();
    const WholeSystem whole = this->Limits.FindWhole ? this->Limits.FindWhole()
                                                     : WholeSystem(this->Limit.GetNumberOfRows());
    MatrixFactors factors;
    factors.Append(this->Limit);
    const MatrixFactors::Matrix matrix = factors.Multiply();
    Direct direct;
    for (int column = 0; column < columns; ++column)
    {
      InterpolationGroup& group = this->Groups[this->Columns[column].Group];
      if (!group.HasConverged)
      {
        this->Factorise(column, matrix, whole, direct);
        group.IsTooLarge = !direct.Fits;
        ForEach(matrix.GetNumberOfRows(),
          [&](vtkIdType row) { this->Shifts[columns * row + column] = 0.; });
        for (int round = 0; direct.Fits && round < 3; ++round)
        {
          this->SolveOnce(column, whole, direct.Solver);
        }
      }
    }
    const std::vector<double> errors = this->FindErrors();
    std::vector<double> factorsOfShifts(errors.size(), -1.); // they stay
    for (std::size_t g = 0; g < errors.size(); ++g)
    {
      InterpolationGroup& group = this->Groups[g];
      if (!group.HasConverged)
      {
        group.HasConverged = !group.IsTooLarge && errors[g] <= 1.;
        const double least = this->Limits.Tolerance * without[g];
        factorsOfShifts[g] = group.HasConverged ? -1. : group.Error < least ? 1. : 0.;
        group.Error = std::min(group.Error, least);
      }
    }
    ForEach(shifts.size(),
      [&](vtkIdType i)
      {
        const double factor = factorsOfShifts[this->Columns[i % columns].Group];
        this->Shifts[i] = factor < 0. ? this->Shifts[i] : factor == 0. ? 0. : shifts[i];
      });
  }

private:
  /// The factors of a part of the rows, and these.
  struct Direct
  {
    DirectSolver Solver;
    std::vector<double> Rows;
    bool Fits = false;
  };

  struct Column
  {
    std::size_t Group;
    std::size_t Slot; ///< the first of its component, which has one for each material
    vtkIdType Fields;
    const double* Factors; ///< null: 1
    const int* Materials;  ///< null: 0
  };

  int GetColumns() const { return static_cast<int>(this->Columns.size()); }

  double GetFactorOfField(vtkIdType i) const
  {
    const vtkIdType columns = this->GetColumns();
    const Column& column = this->Columns[i % columns];
    return column.Factors ? column.Factors[column.Fields * (i / columns)] : 1.;
  }
  double GetPart(vtkIdType i) const
  {
    return this->Limits.Parts ? this->Limits.Parts[i / this->GetColumns()] : 1.;
  }
  /// 0 where the limit is free, too.
  double GetFactor(vtkIdType i) const
  {
    return this->GetPart(i) == 0. ? 0. : this->GetFactorOfField(i);
  }
  /// Whether the field of a column has a value in a row.
  bool HasValue(vtkIdType i) const { return this->GetFactorOfField(i) != 0.; }

  /// Where a value counts: with its component of its material.
  std::size_t GetSlot(vtkIdType i) const
  {
    const vtkIdType columns = this->GetColumns();
    const Column& column = this->Columns[i % columns];
    const int* material = column.Materials;
    return column.Slot +
      static_cast<std::size_t>(material ? material[column.Fields * (i / columns)] : 0);
  }

  /// The largest value(i) for each place(i), over all finite ones that a field has.
  template <typename Place, typename Value>
  std::vector<double> FindLargest(std::size_t size, const Place& place, const Value& value) const
  {
    const vtkIdType columns = this->GetColumns();
    std::vector<double> largest(size, -std::numeric_limits<double>::infinity());
    std::mutex mutex;
    ForRanges(this->Limit.GetNumberOfRows(),
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<double> here(largest.size(), -std::numeric_limits<double>::infinity());
        for (vtkIdType i = columns * begin; i < columns * end; ++i)
        {
          const double v = value(i);
          double& most = here[place(i)];
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

  /// Finds the ranges, and the error that each value may have: a fraction of the range of its
  /// material, the largest of its components.
  void FindRanges()
  {
    const auto place = [&](vtkIdType i) { return this->GetSlot(i); };
    const std::vector<double> high =
      this->FindLargest(this->Units.size(), place, [&](vtkIdType i) { return this->Given[i]; });
    const std::vector<double> low =
      this->FindLargest(this->Units.size(), place, [&](vtkIdType i) { return -this->Given[i]; });
    std::size_t first = 0;
    for (InterpolationGroup& group : this->Groups)
    {
      const auto materials = static_cast<std::size_t>(group.NumberOfMaterials);
      std::vector<double> allowed(materials, std::numeric_limits<double>::min());
      group.Range.clear();
      for (int c = 0; c < group.Components; ++c, first += materials)
      {
        group.Range.push_back(-*std::max_element(&low[first], &low[first] + materials));
        group.Range.push_back(*std::max_element(&high[first], &high[first] + materials));
        for (std::size_t m = 0; m < materials; ++m)
        {
          const double most = high[first + m];
          const double least = low[first + m];
          allowed[m] = std::max({ allowed[m], LimitUnit * most, LimitUnit * least,
            this->Limits.Tolerance * (most + least) });
        }
      }
      const std::size_t from = first - materials * static_cast<std::size_t>(group.Components);
      for (std::size_t slot = from; slot < first; ++slot)
      {
        this->Units[slot] = 1. / allowed[(slot - from) % materials];
      }
    }
  }

  /// The errors of groups, 1 where they are as large as they may be.
  std::vector<double> FindErrors() const
  {
    const vtkIdType columns = this->GetColumns();
    std::vector<double> errors = this->FindLargest(
      this->Groups.size(), [&](vtkIdType i) { return this->Columns[i % columns].Group; },
      [&](vtkIdType i) { return std::abs(this->Residuals[i]) * this->Units[this->GetSlot(i)]; });
    for (double& error : errors)
    {
      error = std::max(error, 0.); // there may be no values
    }
    return errors;
  }

  /// Ends groups that have converged, and groups that may have no more products. Returns whether
  /// others are left.
  bool GoOn(int products)
  {
    const std::vector<double> errors = this->FindErrors();
    for (std::size_t g = 0; g < this->Groups.size(); ++g)
    {
      if (!this->HasEnded[g])
      {
        InterpolationGroup& group = this->Groups[g];
        group.Products = products;
        group.Error = errors[g] * this->Limits.Tolerance;
        group.HasConverged = errors[g] <= 1.;
        this->HasEnded[g] = group.HasConverged || products >= this->Limits.MostProducts;
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
    this->Subtract();
  }

  /// Sets the residuals for shifts that are 0.
  void Start()
  {
    this->Multiply(this->Given);
    ForEach(this->Residuals.size(),
      [&](vtkIdType i)
      {
        const bool isWanted = this->GetFactor(i) != 0.;
        this->Residuals[i] =
          isWanted ? this->GetPart(i) * (this->Given[i] - this->Products[i]) : 0.;
      });
  }

  /// Sets the residuals after the steps.
  void Subtract()
  {
    this->Multiply(this->Steps.data());
    ForEach(this->Steps.size(),
      [&](vtkIdType i)
      {
        double& residual = this->Residuals[i];
        residual -= std::isfinite(residual) ? this->Products[i] : 0.;
      });
  }

  // ----------------------------------------------------------------------------------------------

  /// Whether a shift is looked for.
  bool IsUnknown(vtkIdType i) const
  {
    return this->GetFactor(i) != 0. && std::isfinite(this->Residuals[i]);
  }

  /// Makes the factors for a column, unless the column before has the same ones in all parts.
  void Factorise(
    int column, const MatrixFactors::Matrix& matrix, const WholeSystem& whole, Direct& direct) const
  {
    const vtkIdType columns = this->GetColumns();
    std::vector<double> rows;
    for (const vtkIdType row : InTurn(matrix.GetNumberOfRows()))
    {
      const vtkIdType i = columns * row + column;
      if (!whole.AreOwn[row] || !this->IsUnknown(i))
      {
        continue;
      }
      rows.insert(rows.end(), { static_cast<double>(whole.Numbers[row]), 0. });
      const std::size_t count = rows.size() - 1;
      for (vtkIdType k = matrix.Offsets[row]; k < matrix.Offsets[row + 1]; ++k)
      {
        const vtkIdType other = matrix.Columns[k];
        if (whole.Numbers[other] >= 0 && this->IsUnknown(columns * other + column))
        {
          rows.insert(rows.end(),
            { static_cast<double>(whole.Numbers[other]), matrix.Weights[k] * this->GetFactor(i) });
          rows[count] += 1.;
        }
      }
    }
    std::vector<double> isNew{ rows == direct.Rows ? 0. : 1. };
    if (this->Limits.FindLargest)
    {
      this->Limits.FindLargest(isNew);
    }
    if (isNew[0] == 0. && direct.Fits)
    {
      return;
    }
    direct.Rows = rows;
    std::vector<double> fits;
    if (whole.ToSolver(rows))
    {
      const double most = this->Limits.FindMemory ? this->Limits.FindMemory()
                                                  : std::numeric_limits<double>::infinity();
      fits.push_back(direct.Solver.Factorise(whole.Size, rows, most) ? 1. : 0.);
    }
    whole.FromSolver(fits);
    direct.Fits = fits[0] == 1.;
  }

  /// Adds to the shifts of a column the solution for its residuals.
  void SolveOnce(int column, const WholeSystem& whole, const DirectSolver& solver)
  {
    const vtkIdType columns = this->GetColumns();
    const vtkIdType rows = this->Limit.GetNumberOfRows();
    std::vector<double> sent; // pairs of numbers and residuals
    for (const vtkIdType row : InTurn(rows))
    {
      if (whole.AreOwn[row] && this->IsUnknown(columns * row + column))
      {
        sent.insert(sent.end(),
          { static_cast<double>(whole.Numbers[row]), this->Residuals[columns * row + column] });
      }
    }
    std::vector<double> values;
    if (whole.ToSolver(sent))
    {
      values.assign(static_cast<std::size_t>(whole.Size), 0.);
      for (std::size_t at = 0; at < sent.size(); at += 2)
      {
        values[static_cast<std::size_t>(sent[at])] = sent[at + 1];
      }
      solver.Solve(values);
    }
    whole.FromSolver(values);
    ForEach(this->Steps.size(), [&](vtkIdType i) { this->Steps[i] = 0.; });
    ForEach(rows,
      [&](vtkIdType row)
      {
        const vtkIdType i = columns * row + column;
        this->Steps[i] =
          this->IsUnknown(i) && whole.Numbers[row] >= 0 ? values[whole.Numbers[row]] : 0.;
        this->Shifts[i] += this->Steps[i];
      });
    this->Subtract();
  }

  void Multiply(const double* values)
  {
    this->Limit.Apply(values, this->Products.data(), this->GetColumns());
    if (this->Limits.TakeOthers)
    {
      this->Limits.TakeOthers(this->Products.data(), this->GetColumns());
    }
    if (this->Limits.Parts ||
      std::any_of(this->Columns.begin(), this->Columns.end(),
        [](const Column& column) { return column.Factors != nullptr; }))
    {
      ForEach(this->Products.size(), [&](vtkIdType i) { this->Products[i] *= this->GetFactor(i); });
    }
  }

  const PointOperator& Limit;
  const InterpolationLimits& Limits;
  std::vector<InterpolationGroup>& Groups;
  std::vector<Column> Columns;
  const double* Given;
  double* Shifts;
  Buffer<double> Residuals; ///< NaN where there is no shift
  Buffer<double> Products;
  Buffer<double> Steps;
  std::vector<double> Units; ///< of each slot, 1 / the error that a value may have
  std::vector<char> HasEnded;
};

}

void FindInterpolation(const PointOperator& limit, const double* given,
  std::vector<InterpolationGroup>& groups, const InterpolationLimits& limits, double* shifts)
{
  Chebyshev solver(limit, given, groups, limits, shifts);
  solver.Solve();
  if (!std::all_of(groups.begin(), groups.end(),
        [](const InterpolationGroup& group) { return group.HasConverged; }))
  {
    solver.SolveDirectly();
  }
}

}
