// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/BoxSpline.h"

namespace subdivision
{
namespace
{

/// A number for each corner of a triangle.
using OfCorners = std::array<double, 3>;
/// One of PlaceParts of all control points.
using OfPoints = std::array<double, MostPatchPowers>;

constexpr int FirstBeyond = 3;
constexpr int FirstNext = 6;

/// Sets the weights of the corners, from the weights of all other points, which are divided by 12
/// here. The spline reproduces linear functions: the sum of the control points, with the
/// coordinates that `linear` belongs to, is `linear`.
void SetCorners(const OfCorners& linear, OfPoints& points)
{
  for (int i = FirstBeyond; i < BoxSplinePoints; ++i)
  {
    points[i] *= 1. / 12.;
  }
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const int last = (k + 2) % 3;
    const double* beyond = points.data() + FirstBeyond;
    const double* own = points.data() + FirstNext + 2 * k;
    const double others = points[FirstNext + 2 * next] + points[FirstNext + 2 * last + 1];
    points[k] =
      linear[k] - (beyond[k] + beyond[last]) + beyond[next] - 2. * (own[0] + own[1]) + others;
  }
}

/// The terms of all parts, for the two corners of each edge: their sum and their product, and
/// derivatives of the weight of the point beyond by these two, times 12.
struct TriangleTerms
{
  explicit TriangleTerms(const OfCorners& at)
    : At(at)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double a = at[k];
      const double b = at[(k + 1) % 3];
      const double sum = a + b;
      const double product = a * b;
      this->Sum[k] = sum;
      this->Product[k] = product;
      this->BySum[k] = sum * (sum * (6. - 4. * sum) + 4. * product);
      this->ByProduct[k] = 2. * sum * sum + 4. * product;
    }
  }

  void SetValue(OfPoints& points) const
  {
    for (int k = 0; k < 3; ++k)
    {
      const double square = this->Sum[k] * this->Sum[k];
      const double product = this->Product[k];
      points[FirstBeyond + k] =
        square * (this->Sum[k] * (2. - this->Sum[k]) + 2. * product) + 2. * product * product;
      const double a = this->At[k];
      const double cube = a * a * a;
      points[FirstNext + 2 * k] = cube * (a + 2. * this->At[(k + 1) % 3]);
      points[FirstNext + 2 * k + 1] = cube * (a + 2. * this->At[(k + 2) % 3]);
    }
    SetCorners(this->At, points);
  }

  /// Along a direction, that is, the changes of the weights of the corners.
  void SetFirst(const OfCorners& d, OfPoints& points) const
  {
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const int last = (k + 2) % 3;
      const double a = this->At[k];
      points[FirstBeyond + k] = this->BySum[k] * (d[k] + d[next]) +
        this->ByProduct[k] * (this->At[next] * d[k] + a * d[next]);
      const double square = 2. * a * a;
      points[FirstNext + 2 * k] = square * ((2. * a + 3. * this->At[next]) * d[k] + a * d[next]);
      points[FirstNext + 2 * k + 1] =
        square * ((2. * a + 3. * this->At[last]) * d[k] + a * d[last]);
    }
    SetCorners(d, points);
  }

  void SetSecond(const OfCorners& d, const OfCorners& e, OfPoints& points) const
  {
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const int last = (k + 2) % 3;
      const double a = this->At[k];
      const double b = this->At[next];
      const double sum = this->Sum[k];
      const double ofSum[2] = { d[k] + d[next], e[k] + e[next] };
      const double ofProduct[2] = { b * d[k] + a * d[next], b * e[k] + a * e[next] };
      points[FirstBeyond + k] =
        (12. * sum * (1. - sum) + 4. * this->Product[k]) * ofSum[0] * ofSum[1] +
        4. * sum * (ofSum[0] * ofProduct[1] + ofSum[1] * ofProduct[0]) +
        4. * ofProduct[0] * ofProduct[1] + this->ByProduct[k] * (d[k] * e[next] + d[next] * e[k]);
      const double square = d[k] * e[k];
      points[FirstNext + 2 * k] =
        6. * a * (2. * (a + b) * square + a * (d[k] * e[next] + d[next] * e[k]));
      points[FirstNext + 2 * k + 1] =
        6. * a * (2. * (a + this->At[last]) * square + a * (d[k] * e[last] + d[last] * e[k]));
    }
    SetCorners({ { 0., 0., 0. } }, points);
  }

  const OfCorners At;
  OfCorners Sum;
  OfCorners Product;
  OfCorners BySum;
  OfCorners ByProduct;
};

/// The four uniform cubic B-splines that are not zero in [0, 1], and their derivatives.
struct CubicTerms
{
  explicit CubicTerms(double x)
    : Values{ { (1. - x) * (1. - x) * (1. - x) / 6., 2. / 3. + x * x * (0.5 * x - 1.),
        1. / 6. + 0.5 * x * (1. + x * (1. - x)), x * x * x / 6. } }
    , First{ { -0.5 * (1. - x) * (1. - x), x * (1.5 * x - 2.), 0.5 + x * (1. - 1.5 * x),
        0.5 * x * x } }
    , Second{ { 1. - x, 3. * x - 2., 1. - 3. * x, x } }
  {
  }
  std::array<double, 4> Values;
  std::array<double, 4> First;
  std::array<double, 4> Second;
};

/// Adds the products of two functions of u and v.
void AddProducts(
  double factor, const std::array<double, 4>& ofU, const std::array<double, 4>& ofV, OfPoints& sums)
{
  for (int j = 0; j < 4; ++j)
  {
    const double weight = factor * ofV[j];
    for (int i = 0; i < 4; ++i)
    {
      sums[4 * j + i] += weight * ofU[i];
    }
  }
}

}

void WeightBoxSpline(double u, double v, const PatchDirections& directions,
  PlaceDerivatives derivatives, PatchParts& parts)
{
  const TriangleTerms terms(OfCorners{ { 1. - u - v, u, v } });
  std::array<OfCorners, 2> along;
  for (int p = 0; p < 2; ++p)
  {
    along[p] = { { -(directions[0][p] + directions[1][p]), directions[0][p], directions[1][p] } };
    terms.SetFirst(along[p], parts[PlaceParts::First + p]);
  }
  terms.SetValue(parts[PlaceParts::Value]);
  if (derivatives == PlaceDerivatives::Second)
  {
    terms.SetSecond(along[0], along[0], parts[PlaceParts::Second]);
    terms.SetSecond(along[0], along[1], parts[PlaceParts::Mixed]);
    terms.SetSecond(along[1], along[1], parts[PlaceParts::SecondOfSecond]);
  }
}

void WeightBicubic(double u, double v, const PatchDirections& directions,
  PlaceDerivatives derivatives, PatchParts& parts)
{
  const CubicTerms ofU(u);
  const CubicTerms ofV(v);
  const auto& [du, dv] = directions;
  parts[PlaceParts::Value] = {};
  AddProducts(1., ofU.Values, ofV.Values, parts[PlaceParts::Value]);
  for (int p = 0; p < 2; ++p)
  {
    OfPoints& sums = parts[PlaceParts::First + p];
    sums = {};
    AddProducts(du[p], ofU.First, ofV.Values, sums);
    AddProducts(dv[p], ofU.Values, ofV.First, sums);
  }
  constexpr int axes[3][2] = { { 0, 0 }, { 0, 1 }, { 1, 1 } };
  for (int k = 0; k < 3 && derivatives == PlaceDerivatives::Second; ++k)
  {
    const auto [p, q] = axes[k];
    OfPoints& sums = parts[PlaceParts::Second + k];
    sums = {};
    AddProducts(du[p] * du[q], ofU.Second, ofV.Values, sums);
    AddProducts(du[p] * dv[q] + dv[p] * du[q], ofU.First, ofV.First, sums);
    AddProducts(dv[p] * dv[q], ofU.Values, ofV.Second, sums);
  }
}

void WeightCubic(double u, const PatchDirections& directions, PatchParts& parts)
{
  const CubicTerms terms(u);
  const auto& du = directions[0];
  parts = {};
  for (int i = 0; i < 4; ++i)
  {
    parts[PlaceParts::Value][i] = terms.Values[i];
    parts[PlaceParts::First][i] = du[0] * terms.First[i];
    parts[PlaceParts::First + 1][i] = du[1] * terms.First[i];
    parts[PlaceParts::Second][i] = du[0] * du[0] * terms.Second[i];
    parts[PlaceParts::Mixed][i] = du[0] * du[1] * terms.Second[i];
    parts[PlaceParts::SecondOfSecond][i] = du[1] * du[1] * terms.Second[i];
  }
}

}
