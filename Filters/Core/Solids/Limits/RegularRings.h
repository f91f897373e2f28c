// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegularRings.h
 * Tangents of surfaces where the last level is not made. Nearly all of its vertices are *regular*:
 * inside a surface, with six neighbours, and all rules around stay the same. The level before tells
 * their rings, and the weights of both tangents are the same for all of them.
 */
#ifndef SubdivisionObjects_RegularRings_h
#define SubdivisionObjects_RegularRings_h

#include "Core/Memory/Coordinates.h"
#include "Core/Solids/Limits/LimitNormals.h"

namespace subdivision
{

template <typename Id>
struct RegularRings
{
  static constexpr int Size = 6;
  Buffer<Id> Members; ///< so many for each vertex, in the order of the walk of LimitNormals.h
  /// For each vertex twice the control triangle by which its side is decided, and 1 more if the
  /// walk runs against it. -1: the vertex is not regular, and has any members.
  Buffer<Id> Sides;

  std::size_t GetMemorySize() const
  {
    return this->Members.GetMemorySize() + this->Sides.GetMemorySize();
  }
  /// ComputeLimitNormals at regular vertices; other normals stay as they are.
  void ComputeNormals(
    const Coordinates& points, const Buffer<unsigned char>& turned, double* normals) const;
  /// ComputeLimitTangents, likewise.
  void ComputeTangents(const Coordinates& points, const Buffer<unsigned char>& turned,
    double* first, double* second) const;

private:
  template <typename Act>
  void ForRegular(
    const Coordinates& points, const Buffer<unsigned char>& turned, const Act& act) const;
};

/// Finds the rings of the level after one without solids, which is `steps` steps after the control
/// level; and the tangents of all vertices that are not regular, whose numbers `vertices` receives.
/// At further vertices there the tangents mean nothing.
template <typename Level>
RegularRings<typename Level::IdType> FindRegularRings(const Level& level, int steps,
  LimitTangents<typename Level::IdType>& others, Buffer<typename Level::IdType>& vertices);

}

#endif
