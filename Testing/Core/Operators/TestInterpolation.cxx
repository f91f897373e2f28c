// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 8, Interpolation: the solver alone, on matrices whose solutions are known.
#include "Precompiled.h"

#include "Core/Operators/Interpolation.h"

#include "Core/Operators/SparseRows.h"

namespace
{

using namespace subdivision;

/// A closed polygon: own weight for each vertex, the rest for its two neighbours.
SparseRows<int> MakePolygon(int size, double own)
{
  SparseRows<int> rows;
  rows.NumberOfColumns = size;
  rows.Offsets = Buffer<int>(size + 1);
  rows.Columns = Buffer<int>(3 * size);
  rows.Weights = Buffer<double>(3 * size);
  rows.Offsets[0] = 0;
  for (int i = 0; i < size; ++i)
  {
    rows.Offsets[i + 1] = 3 * (i + 1);
    for (int k = 0; k < 3; ++k)
    {
      rows.Columns[3 * i + k] = (i + size + k - 1) % size;
      rows.Weights[3 * i + k] = k == 1 ? own : (1. - own) / 2.;
    }
  }
  return rows;
}

std::vector<double> Solve(const PointOperator& rows, const std::vector<double>& given,
  std::vector<InterpolationGroup>& groups, const InterpolationLimits& limits = {})
{
  std::vector<double> shifts(given.size());
  FindInterpolation(rows, given.data(), groups, limits, shifts.data());
  return shifts;
}

std::vector<double> MakeWave(int size, double scale, double offset)
{
  std::vector<double> values;
  for (int i = 0; i < size; ++i)
  {
    values.push_back(offset + scale * std::sin(i * i * 0.7));
  }
  return values;
}

double FindError(const PointOperator& rows, const std::vector<double>& given,
  const std::vector<double>& shifts, double scale)
{
  std::vector<double> control(given);
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    control[i] += shifts[i];
  }
  std::vector<double> limit(given.size());
  rows.Apply(control.data(), limit.data(), 1);
  double most = 0.;
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    most = std::max(most, std::abs(limit[i] - given[i]));
  }
  return most / scale;
}

/// Rows of three entries, one of them in a random column, whose sum is 1; eigenvalues are anywhere.
SparseRows<int> MakeRandom(int size, std::mt19937& random)
{
  SparseRows<int> rows = MakePolygon(size, 0.4);
  for (int i = 0; i < size; ++i)
  {
    const double part = 0.3 * std::generate_canonical<double, 30>(random);
    rows.Columns[3 * i + 2] = static_cast<int>(random() % static_cast<unsigned>(size));
    rows.Weights[3 * i] += part;
    rows.Weights[3 * i + 2] -= part;
  }
  return rows;
}

/// What elimination finds in the dense matrix of rows and columns that are solved for.
std::vector<double> SolveDensely(const SparseRows<int>& rows, const std::vector<double>& given)
{
  const std::size_t size = given.size();
  std::vector<double> right(size);
  rows.Apply(given.data(), right.data(), 1);
  std::vector<std::vector<double>> matrix(size, std::vector<double>(size, 0.));
  const auto isKnown = [&](std::size_t i) { return std::isfinite(right[i]); };
  for (std::size_t i = 0; i < size; ++i)
  {
    for (int k = rows.Offsets[static_cast<vtkIdType>(i)]; isKnown(i) && k < 3 * int(i + 1); ++k)
    {
      const auto column = static_cast<std::size_t>(rows.Columns[k]);
      matrix[i][column] += isKnown(column) ? rows.Weights[k] : 0.;
    }
    matrix[i][i] = isKnown(i) ? matrix[i][i] : 1.;
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    right[i] = isKnown(i) ? given[i] - right[i] : 0.;
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < size; ++r)
    {
      pivot = std::abs(matrix[r][i]) > std::abs(matrix[pivot][i]) ? r : pivot;
    }
    std::swap(matrix[i], matrix[pivot]);
    std::swap(right[i], right[pivot]);
    for (std::size_t r = 0; r < size; ++r)
    {
      const double part = r == i ? 0. : matrix[r][i] / matrix[i][i];
      for (std::size_t c = i; part != 0. && c < size; ++c)
      {
        matrix[r][c] -= part * matrix[i][c];
      }
      right[r] -= part == 0. ? 0. : part * right[i];
    }
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    right[i] /= matrix[i][i];
  }
  return right;
}
}

TEST(Interpolation, LimitsAreTheGivenValues)
{
  // Eigenvalues of cubic B-splines lie from 1/3 to 1, those with own weight .56 from .12 to 1.
  for (const double own : { 2. / 3., 0.56 })
  {
    const SparseRows<int> rows = MakePolygon(50, own);
    const std::vector<double> given = MakeWave(50, 3., 1.);
    std::vector<InterpolationGroup> groups{ { 1 } };
    const std::vector<double> shifts = Solve(rows, given, groups);
    EXPECT_TRUE(groups[0].HasConverged);
    EXPECT_LE(groups[0].Products, 40);
    EXPECT_GT(groups[0].Products, 10);
    EXPECT_LE(groups[0].Error, 1e-10);
    EXPECT_LT(FindError(rows, given, shifts, 6.), 1.1e-10);
  }
}

TEST(Interpolation, ConstantsStayExactly)
{
  const SparseRows<int> rows = MakePolygon(7, 0.6);
  for (const double value : { 0., 0.1, -1e7 / 3. })
  {
    std::vector<InterpolationGroup> groups{ { 1 } };
    const std::vector<double> shifts = Solve(rows, std::vector<double>(7, value), groups);
    EXPECT_EQ(shifts, std::vector<double>(7, 0.));
    EXPECT_EQ(groups[0].Products, 1);
    EXPECT_TRUE(groups[0].HasConverged);
  }
}

/// A column has the same bits whatever is solved for beside it.
TEST(Interpolation, GroupsDoNotMatterToEachOther)
{
  const SparseRows<int> rows = MakePolygon(50, 2. / 3.);
  const std::vector<double> one = MakeWave(50, 1., 0.);
  const std::vector<double> rough = MakeWave(50, 1e-7, 1e3);
  std::vector<InterpolationGroup> alone{ { 1 } };
  const std::vector<double> shifts = Solve(rows, one, alone);
  std::vector<double> both;
  for (int i = 0; i < 50; ++i)
  {
    both.insert(both.end(), { rough[i], one[i], i % 2 * 1. });
  }
  std::vector<InterpolationGroup> groups{ { 1 }, { 1 }, { 1 } };
  const std::vector<double> together = Solve(rows, both, groups);
  for (int i = 0; i < 50; ++i)
  {
    ASSERT_EQ(together[3 * i + 1], shifts[i]) << i;
  }
  EXPECT_EQ(groups[1].Products, alone[0].Products);
  EXPECT_NE(groups[2].Products, alone[0].Products) << "else this test shows nothing";
  EXPECT_TRUE(groups[0].HasConverged) << "as far as rounding lets it";
}

TEST(Interpolation, ValuesThatAreNotFiniteStay)
{
  const SparseRows<int> rows = MakePolygon(50, 2. / 3.);
  std::vector<double> given = MakeWave(50, 1., 0.);
  given[10] = std::numeric_limits<double>::quiet_NaN();
  given[20] = std::numeric_limits<double>::infinity();
  std::vector<InterpolationGroup> groups{ { 1 } };
  const std::vector<double> shifts = Solve(rows, given, groups);
  EXPECT_TRUE(groups[0].HasConverged);
  for (int i = 0; i < 50; ++i)
  {
    const bool isNear = std::abs(i - 10) < 2 || std::abs(i - 20) < 2;
    EXPECT_EQ(shifts[i] == 0., isNear) << i;
  }
}

/// Where the wave of every other vertex has eigenvalue 0, there is no solution to find; where it is
/// less, none is found without memory.
TEST(Interpolation, WhatDoesNotConvergeGetsTheLeastError)
{
  for (const double own : { 0.5, 0.45 })
  {
    const SparseRows<int> rows = MakePolygon(10, own);
    const std::vector<double> given{ 1., -1., 1., -1., 1., -1., 1., -1., 1., -1. };
    std::vector<InterpolationGroup> groups{ { 1 } };
    InterpolationLimits limits;
    limits.FindMemory = [own] { return own == 0.5 ? 1e9 : 100.; };
    const std::vector<double> shifts = Solve(rows, given, groups, limits);
    EXPECT_FALSE(groups[0].HasConverged);
    EXPECT_EQ(groups[0].IsTooLarge, own != 0.5);
    EXPECT_NEAR(groups[0].Error, FindError(rows, given, shifts, 2.), 1e-12);
    EXPECT_LE(groups[0].Error, own == 0.5 ? 0.5 : 0.55 + 1e-12) << "that of no shift at all";
  }
}

/// Where the iteration does not converge, factors of the matrix give what elimination does, also
/// where values are missing, which differ between columns.
TEST(Interpolation, SlowColumnsAreSolvedForDirectly)
{
  std::mt19937 random(5);
  int direct = 0;
  for (int trial = 0; trial < 40; ++trial)
  {
    SCOPED_TRACE(trial);
    const int size = 5 + trial;
    const SparseRows<int> rows = MakeRandom(size, random);
    std::vector<double> columns[3] = { MakeWave(size, 1., 0.), MakeWave(size, 30., 7.),
      MakeWave(size, 1e-3, 0.) };
    columns[1][random() % columns[1].size()] = std::numeric_limits<double>::quiet_NaN();
    columns[2][random() % columns[2].size()] = std::numeric_limits<double>::infinity();
    std::vector<double> given;
    for (int i = 0; i < size; ++i)
    {
      given.insert(given.end(), { columns[0][i], columns[1][i], columns[2][i] });
    }
    std::vector<InterpolationGroup> groups{ { 1 }, { 2 } };
    const std::vector<double> shifts = Solve(rows, given, groups);
    for (int c = 0; c < 3; ++c)
    {
      const std::vector<double> expected = SolveDensely(rows, columns[c]);
      double most = 1e-300;
      for (const double value : expected)
      {
        most = std::max(most, std::abs(value));
      }
      for (int i = 0; i < size; ++i)
      {
        EXPECT_NEAR(shifts[3 * i + c], expected[i], 1e-7 * most) << c << ", row " << i;
      }
    }
    for (const InterpolationGroup& group : groups)
    {
      EXPECT_TRUE(group.HasConverged);
      direct += group.Products == 40 ? 1 : 0;
    }
  }
  EXPECT_GT(direct, 40) << "else this test shows little";
}

/// A small range beside a large one in one column: each value may be wrong by a part of its own.
TEST(Interpolation, EachMaterialHasARangeOfItsOwn)
{
  const int size = 20;
  const SparseRows<int> rows = MakePolygon(size, 2. / 3.);
  std::vector<double> given;
  std::vector<double> factors;
  std::vector<int> materials;
  for (int i = 0; i < size; ++i) // two fields, of which each row has one
  {
    const bool isFirst = i < size / 2;
    const double value = std::sin(0.7 * i * i);
    given.insert(given.end(), { isFirst ? value * 1e-6 : 0., isFirst ? 0. : 1e6 });
    // A limit at an end of a material is a mean of what the material has.
    const bool isEnd = i % (size / 2) == 0 || i % (size / 2) == size / 2 - 1;
    const double factor = isEnd ? 6. / 5. : 1.;
    factors.insert(factors.end(), { isFirst ? factor : 0., isFirst ? 0. : factor });
    materials.insert(materials.end(), { 0, 1 });
  }
  for (const bool apart : { true, false })
  {
    std::vector<InterpolationGroup> groups{ { 1, 2, factors.data() } };
    if (apart)
    {
      groups[0].Materials = materials.data();
      groups[0].NumberOfMaterials = 2;
    }
    std::vector<double> control = Solve(rows, given, groups);
    EXPECT_TRUE(groups[0].HasConverged);
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      control[i] += given[i];
    }
    std::vector<double> limit(given.size());
    rows.Apply(control.data(), limit.data(), 2);
    double most = 0.;
    for (std::size_t i = 0; i < given.size(); i += 2)
    {
      most = std::max(most, factors[i] > 0. ? std::abs(factors[i] * limit[i] - given[i]) : 0.);
    }
    EXPECT_EQ(most < 2.1e-16, apart) << most << " of a range of 2e-6";
  }
}

/// A part of a mesh takes values of rows that it does not have right from other parts.
TEST(Interpolation, PartsSolveTogether)
{
  const SparseRows<int> rows = MakePolygon(12, 2. / 3.);
  const std::vector<double> given = MakeWave(12, 1., 0.);
  std::vector<InterpolationGroup> whole{ { 1 } };
  const std::vector<double> shifts = Solve(rows, given, whole);
  // Each row of `wrong` is right but for row 3, which the other part has.
  SparseRows<int> wrong = MakePolygon(12, 2. / 3.);
  wrong.Weights[9] = wrong.Weights[10] = wrong.Weights[11] = 1. / 3.;
  InterpolationLimits limits;
  int largest = 0;
  limits.FindLargest = [&](std::vector<double>&) { ++largest; };
  std::vector<std::vector<double>> products;
  InterpolationLimits recorder;
  recorder.TakeOthers = [&](double* of, int) { products.emplace_back(of, of + 12); };
  Solve(rows, given, whole, recorder);
  std::size_t next = 0;
  limits.TakeOthers = [&](double* of, int) { of[3] = products[next++][3]; };
  std::vector<InterpolationGroup> part{ { 1 } };
  EXPECT_EQ(Solve(wrong, given, part, limits), shifts);
  EXPECT_EQ(part[0].Products, whole[0].Products);
  EXPECT_EQ(largest, whole[0].Products + 2);
}
