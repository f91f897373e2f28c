// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/ThickPieces.h"

#include "vtkDataArray.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace subdivision
{
namespace
{

/// How often the edges of a piece are halved before its parts are straight, but for a tolerance:
/// each halving leaves a quarter.
int CountHalvings(double bend, double tolerance)
{
  int halvings = 0;
  for (; bend > tolerance && halvings < 8; bend /= 4.)
  {
    ++halvings;
  }
  return halvings;
}

}

ThickPieces::ThickPieces(const std::vector<SampledMesh>& meshes, const SampleOptions& options)
  : Meshes(meshes)
  , Options(options)
{
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    auto& pieces = this->Pieces[dimension];
    pieces = ListPieces(meshes, dimension);
    this->Lists.emplace_back(options.Grid, static_cast<vtkIdType>(pieces.size()),
      [&](vtkIdType i)
      {
        const auto nodes = GetNodes(meshes[pieces[i].Mesh].Mesh, *pieces[i].Piece, dimension);
        const double more =
          this->GetLargestRadius(pieces[i], dimension) + FindBend(nodes, dimension);
        std::pair<double, double> reach(nodes[0][2], nodes[0][2]);
        for (int n = 1; n < QuadraticPiece::CountNodes(dimension); ++n)
        {
          reach.first = std::min(reach.first, nodes[n][2]);
          reach.second = std::max(reach.second, nodes[n][2]);
        }
        return std::make_pair(reach.first - more, reach.second + more);
      });
  }
}

std::array<double, 10> ThickPieces::GetRadii(const ListedPiece& listed, int dimension) const
{
  std::array<double, 10> radii{};
  vtkDataArray* const thickness = this->Meshes[listed.Mesh].Thickness;
  for (int n = 0; n < QuadraticPiece::CountNodes(dimension); ++n)
  {
    radii[n] = thickness ? thickness->GetComponent(listed.Piece->Nodes[n], 0) / 2.
                         : this->Options.Thickness / 2.;
  }
  return radii;
}

/// A parabola through three numbers is nowhere larger than this.
double ThickPieces::GetLargestRadius(const ListedPiece& listed, int dimension) const
{
  double largest = 0.;
  for (const double radius : this->GetRadii(listed, dimension))
  {
    largest = std::max(largest, std::abs(radius));
  }
  return this->Meshes[listed.Mesh].Thickness && dimension > 0 ? 3. * largest : largest;
}

void ThickPieces::Sample(const ListedPiece& listed, int dimension,
  const std::pair<int, int>& slices, std::vector<double>& squares, const Act& act) const
{
  const auto nodes = GetNodes(this->Meshes[listed.Mesh].Mesh, *listed.Piece, dimension);
  const auto radii = this->GetRadii(listed, dimension);
  const double largest = this->GetLargestRadius(listed, dimension);
  const auto tryOne = [&](const StraightPart& part, int i, int j, int k, double& square)
  {
    const SampleGrid& grid = this->Options.Grid;
    const NearestPoint nearest = FindNearest(part.Corners.data(), dimension + 1,
      { grid.GetPlace(0, i), grid.GetPlace(1, j), grid.GetPlace(2, k) });
    if (nearest.Square > largest * largest || nearest.Square >= square)
    {
      return;
    }
    Place weights{};
    for (int c = 0; c <= dimension; ++c)
    {
      weights[0] += nearest.Weights[c] * part.Weights[c][0];
      weights[1] += nearest.Weights[c] * part.Weights[c][1];
    }
    const auto shares = GetSharesOfPiece(dimension, weights);
    const double radius = std::inner_product(
      shares.begin(), shares.begin() + QuadraticPiece::CountNodes(dimension), radii.begin(), 0.);
    if (radius >= 0. && nearest.Square <= radius * radius)
    {
      square = nearest.Square;
      act(i, j, k, listed, dimension, weights, square);
    }
  };
  const int halvings = CountHalvings(FindBend(nodes, dimension), this->Options.Tolerance);
  ForStraightParts(nodes, dimension, halvings,
    [&](const StraightPart& part)
    {
      Place low = part.Corners[0];
      Place high = part.Corners[0];
      for (int x = 0; x < 3; ++x)
      {
        for (int c = 1; c <= dimension; ++c)
        {
          low[x] = std::min(low[x], part.Corners[c][x]);
          high[x] = std::max(high[x], part.Corners[c][x]);
        }
        low[x] -= largest;
        high[x] += largest;
      }
      ForSamplesIn(this->Options.Grid, slices, low, high,
        [&](int i, int j, int k, vtkIdType sample) { tryOne(part, i, j, k, squares[sample]); });
    });
}

void ThickPieces::ForSlab(vtkIdType slab, const Act& act) const
{
  const SampleGrid& grid = this->Options.Grid;
  const auto slices = GetSlices(grid, slab);
  std::vector<double> squares;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    this->Lists[dimension].ForNumbers(slab,
      [&](vtkIdType i)
      {
        if (squares.empty())
        {
          squares.assign(static_cast<std::size_t>(slices.second - slices.first) *
              (grid.Extent[1] - grid.Extent[0] + 1) * (grid.Extent[3] - grid.Extent[2] + 1),
            std::numeric_limits<double>::infinity());
        }
        this->Sample(this->Pieces[dimension][i], dimension, slices, squares, act);
      });
    // What is taken stays: no piece of more dimensions is nearer than nothing.
    for (double& square : squares)
    {
      square = square < std::numeric_limits<double>::infinity() ? -1. : square;
    }
  }
}

}
