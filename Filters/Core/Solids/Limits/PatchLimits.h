// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchLimits.h
 * Limits of values at places of curves and sheets of a level, without any step of subdivision of
 * the level: each simplex has a tree of its own (PatchTree.h). Other places are left to
 * LatticeValues.
 */
#ifndef SubdivisionObjects_PatchLimits_h
#define SubdivisionObjects_PatchLimits_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Limits/PatchTree.h"
#include "Core/Solids/Limits/SheetReader.h"

#include <array>

namespace subdivision
{

/// A vertex, an edge or a face of a level.
template <typename Id>
struct PatchSimplex
{
  std::array<Id, 3> Corners{ { -1, -1, -1 } };
  Id Number = -1; ///< of the vertex, the edge or the face
};

template <typename LevelType>
class PatchLimits
{
public:
  using Id = typename LevelType::IdType;

  /// `values`: at the vertices of the level, interleaved. Both must outlive this.
  PatchLimits(const LevelType& level, const double* values, int components)
    : Reader(level, None)
    , Values(values)
    , Components(components)
  {
  }

  /// Starts the tree of an edge or a face: false if it is no curve and in no sheet.
  bool Start(const PatchSimplex<Id>& simplex, PatchTree& tree) const;
  /// Finds the limit at a vertex. Returns false as Start does, and leaves the limit.
  bool FindAtVertex(Id vertex, SheetRows& rows, double* limit) const;

private:
  const double* At(Id vertex) const { return this->Values + vtkIdType(this->Components) * vertex; }

  const Buffer<unsigned char> None;
  const SheetReader<LevelType> Reader;
  const double* const Values;
  const int Components;
};

}

#endif
