// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PlacePolynomial.h"

#include "Core/Solids/Complex/Simplices.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

/// The factor of a coordinate in a basis polynomial, and its first two derivatives: the product of
/// (4 t - r) / (r + 1) for r < m, which is 1 at t = m / 4 and 0 at all smaller nodes.
std::array<double, 3> GetFactor(int m, double t)
{
  std::array<double, 3> factor{ { 1., 0., 0. } };
  for (int r = 0; r < m; ++r)
  {
    const double value = (LatticeSize * t - r) / (r + 1);
    const double slope = static_cast<double>(LatticeSize) / (r + 1);
    factor[2] = factor[2] * value + 2. * factor[1] * slope;
    factor[1] = factor[1] * value + factor[0] * slope;
    factor[0] *= value;
  }
  return factor;
}

std::vector<PlaceNode> MakeLattice(int dimension)
{
  if (dimension == 0)
  {
    return { { { LatticeSize, 0, 0, 0 } } };
  }
  std::vector<PlaceNode> lattice;
  for (int i = 0; i <= LatticeSize; ++i)
  {
    for (int j = 0; i + j <= (dimension > 1 ? LatticeSize : i); ++j)
    {
      for (int k = 0; i + j + k <= (dimension > 2 ? LatticeSize : i + j); ++k)
      {
        lattice.push_back({ { LatticeSize - i - j - k, i, j, k } });
      }
    }
  }
  return lattice;
}

/// The inverse, by elimination. Its entries are integers, and so exact.
CornerMatrix Invert(CornerMatrix matrix)
{
  CornerMatrix inverse{};
  for (int i = 0; i < 4; ++i)
  {
    inverse[i][i] = 1.;
  }
  for (int i = 0; i < 4; ++i)
  {
    int pivot = i;
    while (matrix[pivot][i] == 0.)
    {
      ++pivot;
    }
    std::swap(matrix[i], matrix[pivot]);
    std::swap(inverse[i], inverse[pivot]);
    const double diagonal = matrix[i][i];
    for (int c = 0; c < 4; ++c)
    {
      matrix[i][c] /= diagonal;
      inverse[i][c] /= diagonal;
    }
    for (int row = 0; row < 4; ++row)
    {
      const double factor = row == i ? 0. : matrix[row][i];
      for (int c = 0; c < 4; ++c)
      {
        matrix[row][c] -= factor * matrix[i][c];
        inverse[row][c] -= factor * inverse[i][c];
      }
    }
  }
  return inverse;
}

std::vector<SimplexChild> MakeChildrenOf(int dimension)
{
  std::vector<SimplexChild> children;
  const int count = 1 << dimension;
  for (int child = 0; child < count; ++child)
  {
    SimplexChild made{};
    CornerMatrix corners{};
    for (int i = 0; i < 4; ++i)
    {
      if (i > dimension)
      {
        corners[i][i] = 1.; // there is no such corner
        continue;
      }
      const int point = dimension == 3 ? tetrahedron::Children[child][i]
        : dimension == 2               ? triangle::Children[child][i]
                                       : (child == i ? child : 2);
      const int edge = point - dimension - 1;
      const int* ends = edge < 0 ? nullptr
        : dimension == 3         ? tetrahedron::EdgeVertices[edge]
                                 : triangle::EdgeVertices[edge];
      made.Corners[i] = { { ends ? ends[0] : point, ends ? ends[1] : point } };
      for (const int corner : made.Corners[i])
      {
        corners[corner][i] += 0.5;
      }
    }
    made.ToChild = Invert(corners);
    children.push_back(made);
  }
  return children;
}

}

const std::vector<PlaceNode>& ListLattice(int dimension)
{
  static const std::array<std::vector<PlaceNode>, 4> lattices{ { MakeLattice(0), MakeLattice(1),
    MakeLattice(2), MakeLattice(3) } };
  return lattices[dimension];
}

const std::vector<SimplexChild>& ListChildren(int dimension)
{
  static const std::array<std::vector<SimplexChild>, 4> children{ { {}, MakeChildrenOf(1),
    MakeChildrenOf(2), MakeChildrenOf(3) } };
  return children[dimension];
}

CornerWeights Multiply(const CornerMatrix& matrix, const CornerWeights& weights)
{
  CornerWeights product{};
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      product[i] += matrix[i][k] * weights[k];
    }
  }
  return product;
}

std::vector<int> ListChildrenTo(int part)
{
  std::vector<int> children;
  for (; part > 1; part /= 4)
  {
    children.insert(children.begin(), part % 4);
  }
  return children;
}

void PlaceInPart::GoToChild(int dimension, int child)
{
  const SimplexChild& taken = ListChildren(dimension)[child];
  this->At = Multiply(taken.ToChild, this->At);
  for (CornerWeights& direction : this->Directions)
  {
    direction = Multiply(taken.ToChild, direction);
  }
  const std::array<int, 4> carriers = this->Carriers;
  for (int i = 0; i <= dimension; ++i)
  {
    const auto [first, second] = taken.Corners[i];
    this->Carriers[i] = carriers[first] | carriers[second];
    if (first == second)
    {
      // Close to the corner that stays only the other weights are small and exact: they say where
      // the place is.
      this->At[i] = 0.;
      this->At[i] = 1. - std::accumulate(this->At.begin(), this->At.end(), 0.);
    }
  }
  this->MoveInside();
}

void PlaceInPart::MoveInside()
{
  if (*std::min_element(this->At.begin(), this->At.end()) >= 0.)
  {
    return;
  }
  for (double& weight : this->At)
  {
    weight = std::max(weight, 0.);
  }
  double& most = *std::max_element(this->At.begin(), this->At.end());
  most = 0.;
  most = 1. - std::accumulate(this->At.begin(), this->At.end(), 0.);
}

int PlaceInPart::FindChild(int dimension) const
{
  const std::vector<SimplexChild>& children = ListChildren(dimension);
  int best = -1;
  double most = 0.;
  for (std::size_t c = 0; c < children.size(); ++c)
  {
    const CornerWeights at = Multiply(children[c].ToChild, this->At);
    const double least = *std::min_element(at.begin(), at.begin() + dimension + 1);
    if (best < 0 || least > most)
    {
      best = static_cast<int>(c);
      most = least;
    }
  }
  return best;
}

std::vector<std::array<double, PlaceParts::Count>> WeightLattice(
  int dimension, const CornerWeights& at, const std::array<CornerWeights, 3>& directions)
{
  const std::vector<PlaceNode>& lattice = ListLattice(dimension);
  std::vector<std::array<double, PlaceParts::Count>> weights;
  for (const PlaceNode& point : lattice)
  {
    std::array<std::array<double, 3>, 4> factors;
    for (int i = 0; i < 4; ++i)
    {
      factors[i] = GetFactor(point[i], at[i]);
    }
    // The product with some factors replaced by their derivatives.
    const auto multiply = [&](int a, int b)
    {
      double product = 1.;
      for (int i = 0; i < 4; ++i)
      {
        product *= factors[i][(i == a ? 1 : 0) + (i == b ? 1 : 0)];
      }
      return product;
    };
    const auto differentiate = [&](const CornerWeights& u, const CornerWeights& v)
    {
      double sum = 0.;
      for (int i = 0; i < 4; ++i)
      {
        for (int k = 0; k < 4; ++k)
        {
          sum += u[i] == 0. || v[k] == 0. ? 0. : u[i] * v[k] * multiply(i, k);
        }
      }
      return sum;
    };
    std::array<double, PlaceParts::Count> parts{};
    parts[PlaceParts::Value] = multiply(-1, -1);
    for (int d = 0; d < 3; ++d)
    {
      for (int i = 0; i < 4; ++i)
      {
        parts[PlaceParts::First + d] += directions[d][i] * multiply(i, -1);
      }
    }
    parts[PlaceParts::Second] = differentiate(directions[0], directions[0]);
    parts[PlaceParts::Mixed] = differentiate(directions[0], directions[1]);
    parts[PlaceParts::SecondOfSecond] = differentiate(directions[1], directions[1]);
    weights.push_back(parts);
  }
  return weights;
}

}
