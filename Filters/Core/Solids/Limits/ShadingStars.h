// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingStars.h
 * The stars of vertices without tangents at the limit, from which these take normals for shading
 * (ShadingNormals.h).
 */
#ifndef SubdivisionObjects_ShadingStars_h
#define SubdivisionObjects_ShadingStars_h

#include "Core/Memory/Loops.h"
#include "Core/Operators/SparseRows.h"
#include "Core/Solids/Limits/LimitStencils.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace subdivision
{

/// The tetrahedra of the control mesh: the number that LimitTangents::Sides uses for each, in the
/// order of the complex (empty: its number there), and the number of steps from the control level
/// to the level.
struct ControlSolids
{
  std::vector<vtkIdType> Numbers;
  int Steps = 0;
  /// For a skin (Skin.h), whose faces have no solids: the sides (LimitTangents::Sides) of each of
  /// its faces some steps before, seen in the order of its vertices.
  const Rows<vtkIdType>* OfSkin = nullptr;
  int SkinSteps = 0;
};

/// Whether a side (LimitTangents::Sides) has its solid behind it. `inverted`: as in
/// ComputeLimitNormals.
inline bool IsOutwards(vtkIdType side, const std::vector<vtkIdType>& inverted)
{
  return (side % 2 == 1) == std::binary_search(inverted.begin(), inverted.end(), side - side % 2);
}

/// Local matrices are full ones. Larger stars are read off the level, not off the limit.
constexpr std::size_t MostEdgesOfStars = 200;

template <typename Id>
struct ShadingStars
{
  /// Of a triangle.
  struct Corner
  {
    Id Ends[2];     ///< rows of the star
    Id Parent;      ///< the control triangle; -1: none, which is on a solid
    vtkIdType Side; ///< of a solid, as LimitTangents::Sides; -1: of none, or of two
  };
  struct Star
  {
    Id Row = 0; ///< which normal is made
    // Rows, corners and lines from here to the first ones of the next star:
    vtkIdType FirstRow = 0;
    vtkIdType FirstCorner = 0;
    vtkIdType FirstLine = 0;
  };
  SparseRows<Id> Rows;     ///< where far ends of edges lie, seen from the vertex
  std::vector<Star> Stars; ///< and one more
  std::vector<Corner> Corners;
  std::vector<Id> Lines; ///< rows of the star

  /// Computes the normals from the points of the level; the rest is as in ComputeLimitNormals.
  void Fill(const double* points, const std::vector<vtkIdType>& inverted,
    const Buffer<unsigned char>& turned, double* normals) const;
  std::size_t GetMemorySize() const
  {
    return this->Rows.GetMemorySize() + sizeof(Star) * this->Stars.size() +
      sizeof(Corner) * this->Corners.size() + sizeof(Id) * this->Lines.size();
  }
};

/// The parts of a level that lie in cells of the control level.
template <typename Id>
struct ShadingCells
{
  std::vector<Id> Triangles; ///< the control triangle of each of the first faces, or -1
  std::vector<char> Lines;   ///< whether each of the first edges lies in a line
  std::vector<Id> Points;    ///< the vertices that are cells
};

/// The cells of a level that was made as a whole, so many steps after the control level.
template <typename Level>
ShadingCells<typename Level::IdType> FindShadingCells(const Level& level, int steps);

/// Makes the stars of the vertices that have a row, `rows[vertex]` >= 0, and lie at triangle cells,
/// triangles of boundaries, line cells or vertex cells. Takes time linear in the size of the level,
/// which is `made` steps after the control level.
template <typename Level>
ShadingStars<typename Level::IdType> BuildShadingStars(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases, const ControlSolids& solids,
  const ShadingCells<typename Level::IdType>& cells, const Buffer<typename Level::IdType>& rows,
  int made);

}

#endif
