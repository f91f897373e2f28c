// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeParts.h
 * Limits over control edges and faces that touch joints, by the box-spline scheme: a part of one
 * that touches neither a joint nor a control vertex is regular, and the limit over it is a
 * polynomial (PatchTree.h) of values on its level (LatticeValues.h).
 */
#ifndef SubdivisionObjects_LatticeParts_h
#define SubdivisionObjects_LatticeParts_h

#include "Core/Solids/Limits/LatticeValues.h"
#include "Core/Solids/Limits/PatchLimits.h"

#include <array>
#include <cstddef>
#include <vector>

namespace subdivision
{

template <typename Id>
class LatticeParts
{
public:
  /// `values` are those of `level`, the control level, with the values `control` at its vertices,
  /// interleaved. All three must outlive this.
  LatticeParts(
    const Level<Id>& level, LatticeValues<Id>& values, const double* control, int components)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , Values(values)
    , Control(control)
    , Components(components)
  {
  }

  /// Begins an edge or face. False: it is no curve and in no sheet.
  bool Start(const PatchSimplex<Id>& simplex);
  /// Adds a place; `at`: the weights of the simplex' corners.
  void Add(const std::array<double, 3>& at, double* limit);
  /// Writes the limits at those places that were added since the start and lie in a regular part
  /// that is larger than what the level of the place has.
  void Run(PatchTree& tree);

private:
  /// How a sheet goes on across an edge of its face.
  struct Side
  {
    bool IsInside = false; ///< to the face Across
    bool IsCurve = false;  ///< not at all
    Id Across = -1;
  };
  /// A part of a level, whose number is Dimension: its corners have Weights and one more for the
  /// corner. If it is turned, Simplex is 1, and they have one more for both others.
  using Part = LatticeVertex<Id>;
  struct Place
  {
    std::size_t Part;
    std::array<double, 3> At; ///< weights of the part's corners
    double* Limit;
  };

  bool IsBefore(Id a, Id b) const { return AreValuesBefore(this->Control, this->Components, a, b); }
  void SortCorners(const Id* corners, int size);
  bool StartFace(Id face);
  Side FindSide(Id edge, Id face) const;
  bool IsRegular(const Part& part) const;
  bool IsOutside(const LatticeWeights& point) const;
  SheetKey ListColumns(const Part& part, std::vector<LatticeWeights>& columns) const;
  const double* FindValue(const LatticeWeights& point, int level);

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  LatticeValues<Id>& Values;
  const double* const Control;
  const int Components;
  // Of the current simplex, or the face of the sheet at it:
  int Dimension = 2;
  Id Simplex = -1;
  std::array<Id, 3> Corners{ { -1, -1, -1 } }; ///< in the order of the values at them
  std::array<int, 3> Order{};  ///< which of the caller's corners each is; -1: none of them
  std::array<Side, 3> Sides{}; ///< opposite to the corners
  VertexNumbers<Part> Parts;
  std::vector<Place> Places;
};

}

#endif
