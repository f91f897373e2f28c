// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitPatchShape.h
 * The lattices of the patches of LimitPatches.h, and products of their polynomials.
 */
#ifndef SubdivisionObjects_LimitPatchShape_h
#define SubdivisionObjects_LimitPatchShape_h

#include "Private/Bezier/PatchShape.h"
#include "Private/Places/LimitPatches.h"

#include <array>
#include <vector>

namespace subdivision
{

/// A patch as PatchShape.h has it, and products of its polynomials.
struct LimitPatches::Shape
{
  /// Of the lattice that tells how good a polynomial is.
  static constexpr int Divisions = PatchSide - 1;

  explicit Shape(PatchShape::Kind kind)
    : Of(PatchShape::Get(kind))
    , Degree(kind == PatchShape::Triangle ? 4 : 3)
  {
    const bool isQuad = kind == PatchShape::Quad;
    const int rows = kind == PatchShape::Curve ? 0 : Divisions;
    for (int j = 0; j <= rows; ++j)
    {
      for (int i = 0; i <= (isQuad ? Divisions : Divisions - j); ++i)
      {
        this->Places.push_back({ { i, j } });
      }
    }
    const auto getPower = [this](int node)
    { return this->Degree == 4 || node < 2 ? node : node - 1; };
    const auto weigh = [&](int degree, int i, int j)
    {
      return kind == PatchShape::Triangle ? Choose(degree, i) * Choose(degree - i, j)
                                          : Choose(degree, i) * (isQuad ? Choose(degree, j) : 1.);
    };
    const std::size_t size = this->Of.Nodes.size();
    for (std::size_t a = 0; a < size; ++a)
    {
      for (std::size_t b = 0; b <= a; ++b)
      {
        const auto& nodeA = this->Of.Nodes[a];
        const auto& nodeB = this->Of.Nodes[b];
        const int i[2] = { getPower(nodeA[0]), getPower(nodeB[0]) };
        const int j[2] = { getPower(nodeA[1]), getPower(nodeB[1]) };
        const double weight = weigh(this->Degree, i[0], j[0]) * weigh(this->Degree, i[1], j[1]) /
          weigh(2 * this->Degree, i[0] + i[1], j[0] + j[1]);
        this->Products.push_back({ static_cast<int>(a), static_cast<int>(b),
          PatchSide * (j[0] + j[1]) + i[0] + i[1], a == b ? weight : 2. * weight });
      }
    }
  }

  struct Product
  {
    int First;
    int Second;
    int Factor;
    double Weight;
  };
  const PatchShape& Of;
  const int Degree;
  std::vector<std::array<int, 2>> Places; ///< of the lattice
  std::vector<Product> Products;

private:
  static double Choose(int n, int k)
  {
    double result = 1.;
    for (int i = 1; i <= k; ++i)
    {
      result = result * (n - k + i) / i;
    }
    return result;
  }
};

}

#endif
