// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingFacets.h
 * The triangles, lines and points of a level at vertices without tangents, from which these take
 * normals for shading (ShadingNormals.h).
 */
#ifndef SubdivisionObjects_ShadingFacets_h
#define SubdivisionObjects_ShadingFacets_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/ShadingNormals.h"

#include <vector>

namespace subdivision
{

/// As ids of vertices.
template <typename Id>
struct ShadingFacets
{
  std::vector<Id> Triangles; ///< three corners, then another vertex of the bounded solid, or -1
  std::vector<Id> Parents;   ///< the control triangle of each; -1: none, which is on a solid
  std::vector<Id> Lines;     ///< two ends
  std::vector<Id> Points;

  /// `turned` has a flag for each control triangle; empty: none is turned.
  void Fill(ShadingNormals& normals, const Buffer<unsigned char>& turned) const
  {
    ForEachInTurn(static_cast<vtkIdType>(this->Parents.size()),
      [&](vtkIdType i)
      {
        const Id* corners = this->Triangles.data() + 4 * i;
        const Id parent = this->Parents[i];
        corners[3] < 0
          ? normals.AddFacet(corners, 3, parent >= 0 && !turned.empty() && turned[parent] != 0)
          : normals.AddFacetOfSolid(corners, corners[3]);
      });
    for (std::size_t i = 0; i < this->Lines.size(); i += 2)
    {
      normals.AddLine(this->Lines[i], this->Lines[i + 1]);
    }
    for (const Id point : this->Points)
    {
      normals.AddPoint(point);
    }
    normals.Fill();
  }
  std::size_t GetMemorySize() const
  {
    return sizeof(Id) *
      (this->Triangles.size() + this->Parents.size() + this->Lines.size() + this->Points.size());
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

/// Those of a level that was made as a whole, so many steps after the control level.
template <typename Level>
ShadingCells<typename Level::IdType> FindShadingCells(const Level& level, int steps);

/// Finds the triangle cells, the triangles of boundaries, the line cells and the vertex cells at
/// vertices that are flagged. Takes time linear in the size of the level.
template <typename Level>
ShadingFacets<typename Level::IdType> FindShadingFacets(const Level& level,
  const Buffer<unsigned char>& missing, const ShadingCells<typename Level::IdType>& cells);

}

#endif
