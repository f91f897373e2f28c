// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchTree.h
 * The limit over one simplex of a curve or sheet of a level, from the values at the vertices on
 * which it depends (SheetKey.h), without any step of subdivision of the level. Where a corner is
 * not regular, the simplex is split, as often as a place needs: all parts but the parts at such
 * corners have nothing but regular vertices, and the limit over them is a polynomial
 * (PatchPolynomials.h).
 */
#ifndef SubdivisionObjects_PatchTree_h
#define SubdivisionObjects_PatchTree_h

#include "Core/Solids/Limits/PatchPolynomials.h"
#include "Core/Solids/Limits/SheetReader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace subdivision
{

/// A vertex, an edge or a face of a level.
template <typename Id>
struct PatchSimplex
{
  std::array<Id, 3> Corners{ { -1, -1, -1 } };
  Id Number = -1; ///< of the vertex, the edge or the face
};

class PatchTree
{
public:
  PatchTree(PatchPolynomials& polynomials, int components)
    : Polynomials(polynomials)
    , Components(static_cast<std::size_t>(components))
  {
  }

  /// Begins the tree of an edge or a face: false if it is no curve and in no sheet. `values`: at
  /// the vertices of the level, interleaved.
  template <typename LevelType>
  bool Start(const SheetReader<LevelType>& reader,
    const PatchSimplex<typename LevelType::IdType>& simplex, const double* values);
  /// Begins a tree. The key belongs to a face or the edge of a curve. Returns where the values at
  /// its columns are to be written, interleaved. `order`: which of the caller's corners is the
  /// first, second, third of the key.
  double* Start(const SheetKey& key, std::size_t columns, const std::array<int, 3>& order);

  /// Finds the limit at a place inside; `at`: the weights of the caller's corners. It is not a
  /// number if the tree does not reach the place, or the values are none.
  void Find(const std::array<double, 3>& at, double* limit);

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

template <typename LevelType>
bool PatchTree::Start(const SheetReader<LevelType>& reader,
  const PatchSimplex<typename LevelType::IdType>& simplex, const double* values)
{
  using Id = typename LevelType::IdType;
  const auto isBefore = [&](Id a, Id b)
  { return AreValuesBefore(values, static_cast<vtkIdType>(this->Components), a, b); };
  std::array<Id, 3> corners = simplex.Corners;
  if (corners[1] < 0)
  {
    return false;
  }
  const Id face =
    corners[2] < 0 ? reader.ChooseFace(simplex.Number, isBefore, corners[2]) : simplex.Number;
  const std::array<int, 3> order =
    SortCorners(face < 0 ? 2 : 3, [&](int a, int b) { return isBefore(corners[a], corners[b]); });
  const std::array<Id, 3> sorted{ { corners[order[0]], corners[order[1]], corners[order[2]] } };
  SheetPatch<Id> patch;
  if (!(face < 0 ? reader.ReadCurve(simplex.Number, sorted[0], sorted[1], patch)
                 : reader.ReadFace(face, sorted, patch)))
  {
    return false;
  }
  double* to = this->Start(patch.Key, patch.Columns.size(), order);
  for (const Id column : patch.Columns)
  {
    to = std::copy_n(values + vtkIdType(this->Components) * column, this->Components, to);
  }
  return true;
}

}

#endif
