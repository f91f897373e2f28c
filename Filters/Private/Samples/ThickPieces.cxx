// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/ThickPieces.h"

#include "vtkDataArray.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace subdivision
{

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
        return FindReach(nodes, dimension, this->GetLargestRadius(pieces[i], dimension));
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

void ThickPieces::Sample(const ListedPiece& listed, int dimension, const SampleGrid& slab,
  std::vector<double>& squares, const Act& act) const
{
  const auto nodes = GetNodes(this->Meshes[listed.Mesh].Mesh, *listed.Piece, dimension);
  const auto radii = this->GetRadii(listed, dimension);
  const double largest = this->GetLargestRadius(listed, dimension);
  const auto visit = [&](int i, int j, int k, vtkIdType sample, const StraightPart& part,
                       const NearestPoint& nearest)
  {
    double& square = squares[sample];
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
  // Each halving leaves a quarter of the bend.
  const int halvings = CountHalvings(FindBend(nodes, dimension), this->Options.Tolerance, 4.);
  ForSamplesNear(slab, nodes, dimension, halvings, largest, visit);
}

void ThickPieces::ForSlab(vtkIdType number, const Act& act) const
{
  const SampleGrid slab = GetSlab(this->Options.Grid, number);
  std::vector<double> squares;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    this->Lists[dimension].ForNumbers(number,
      [&](vtkIdType i)
      {
        if (squares.empty())
        {
          squares.assign(CountSamplesOf(slab), std::numeric_limits<double>::infinity());
        }
        this->Sample(this->Pieces[dimension][i], dimension, slab, squares, act);
      });
    // What is taken stays: no piece of more dimensions is nearer than nothing.
    for (double& square : squares)
    {
      square = square < std::numeric_limits<double>::infinity() ? -1. : square;
    }
  }
}

}
