// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchPolynomials.h
 * The limit over a part of a curve segment or triangle as a polynomial of degree 4: few
 * neighbourhoods (SheetKey.h) serve a whole mesh, and a place costs a few sums. They are found on a
 * mesh of the triangles of a neighbourhood alone, when they are first needed.
 */
#ifndef SubdivisionObjects_PatchPolynomials_h
#define SubdivisionObjects_PatchPolynomials_h

#include "Core/Operators/PatchPowers.h"
#include "Core/Rules/LoopWeights.h"
#include "Core/Solids/Limits/SheetKey.h"

#include "vtkSMPThreadLocal.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace subdivision
{

class PatchPolynomials
{
public:
  explicit PatchPolynomials(LoopWeights weights)
    : Weights(weights)
  {
  }
  /// The weights of all columns of a key for the first of PatchPowers::Quartic, then for the
  /// second, ...; u and v are the weights of the second and the third corner. The key belongs to a
  /// face or the edge of a curve.
  const std::vector<double>& Find(const SheetKey& key);
  /// The same without zeros: a row for each power.
  const SparseRows<int>& FindSparse(const SheetKey& key);
  /// A child (ListChildren) of a face.
  const SheetChild& FindChild(const SheetKey& key, int child);

private:
  LoopWeights Weights;
  std::unordered_map<std::uint64_t, std::vector<double>> Found;
  std::unordered_map<std::uint64_t, SparseRows<int>> Sparse;
  std::unordered_map<std::uint64_t, SheetChild> Children;
};

/// The findings of each thread, for all work on levels with the same weights.
class KnownPolynomials
{
public:
  PatchPolynomials& OfThread(LoopWeights weights)
  {
    std::shared_ptr<PatchPolynomials>& found = this->Found.Local();
    if (!found)
    {
      found = std::make_shared<PatchPolynomials>(weights);
    }
    return *found;
  }

private:
  vtkSMPThreadLocal<std::shared_ptr<PatchPolynomials>> Found;
};

}

#endif
