// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Skin.h
 * Tangents where a level has some, without its solids.
 *
 * The *skin* of a level is a level of its own: cells that are no solids, boundaries of solids, and
 * curves. No rule there reads the inside of a solid, unless a joint blends them. So the skin alone
 * is refined, and its vertices are some vertices of the whole.
 */
#ifndef SubdivisionObjects_Skin_h
#define SubdivisionObjects_Skin_h

#include "Core/Solids/Limits/RegularRings.h"

namespace subdivision
{

template <typename Id>
struct SkinTangents
{
  LimitTangents<Id> Tangents;
  Buffer<Id> Vertices;    ///< their numbers
  bool HasAll = true;     ///< Tangents has all vertices, in order
  RegularRings<Id> Rings; ///< they count before Tangents; may be empty

  /// ComputeLimitNormals of LimitNormals.h. `size`: the number of vertices.
  Buffer<double> ComputeNormals(const Coordinates& points, vtkIdType size,
    const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned) const;
  /// ComputeLimitTangents of LimitNormals.h.
  void ComputeTangents(const Coordinates& points, vtkIdType size,
    const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned,
    Buffer<double> (&tangents)[2]) const;
  std::size_t GetMemorySize() const
  {
    return this->Tangents.GetMemorySize() + this->Vertices.GetMemorySize() +
      this->Rings.GetMemorySize();
  }

private:
  template <std::size_t Count, typename Compute>
  void ComputeFrames(const Coordinates& points, vtkIdType size, Buffer<double> (&frames)[Count],
    const Compute& compute) const;
};

/// Finds the tangents (LimitNormals.h) at the vertices of the skin of a level that is `steps` steps
/// after `level`, which was made with Depth::ForRefinement and has no semi-sharp rules then.
/// `solids`: of `level`. False: the skin has rules that read solids, or the scheme has no tangents.
template <typename Level>
bool BuildSkinTangents(const Level& level, const ControlSolids& solids, int steps,
  SkinTangents<typename Level::IdType>& tangents);

}

#endif
