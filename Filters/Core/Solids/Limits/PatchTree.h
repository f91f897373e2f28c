// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchTree.h
 * The limit over one simplex of a curve or sheet, from the values at what it depends on
 * (SheetRows.h). Where a corner is not regular, the simplex is split, as often as a place needs:
 * all parts but those at such corners have nothing but regular vertices, and the limit over them is
 * a polynomial (PatchPolynomials.h).
 */
#ifndef SubdivisionObjects_PatchTree_h
#define SubdivisionObjects_PatchTree_h

#include "Core/Solids/Limits/PatchPolynomials.h"

#include <array>
#include <cstddef>
#include <vector>

namespace subdivision
{

class PatchTree
{
public:
  PatchTree(PatchPolynomials& polynomials, int components)
    : Polynomials(polynomials)
    , Components(static_cast<std::size_t>(components))
  {
  }

  /// Begins a tree. The places of the key are those of a face, an edge or an edge of a curve.
  /// Returns where the values at its columns are to be written, interleaved. `order`: which of the
  /// caller's corners is the first, second, third of the key.
  double* Start(const SheetKey& key, std::size_t columns, const std::array<int, 3>& order);

  /// Finds the limit at a place inside; `at`: the weights of the caller's corners. It is not a
  /// number if the tree does not reach the place, or the values are none.
  void Find(const std::array<double, 3>& at, double* limit);

  PatchPolynomials& GetPolynomials() { return this->Polynomials; }

private:
  static constexpr int MostSplits = 64;

  struct Node
  {
    SheetKey Key;
    std::size_t Columns = 0;
    std::size_t Values = 0;     ///< where these begin
    std::ptrdiff_t Powers = -1; ///< where those of the polynomial begin; -1: not yet made
    std::array<int, 4> Children{ { -1, -1, -1, -1 } };
    bool IsRegular = false;
  };

  int Add(const SheetKey& key, std::size_t columns);
  int GetChild(int parent, int child);
  void MakePowers(Node& node);
  template <typename Size>
  static void SumRows(const SparseRows<int>& rows, const double* from, double* to, Size size);
  template <typename Act>
  void WithSize(const Act& act) const;

  PatchPolynomials& Polynomials;
  const std::size_t Components;
  std::array<int, 3> Order{ { 0, 1, 2 } };
  std::vector<Node> Nodes;
  std::vector<double> Values; ///< of all nodes
  std::vector<double> Powers;
};

}

#endif
