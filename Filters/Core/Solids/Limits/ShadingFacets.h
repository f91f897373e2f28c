// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingFacets.h
 * The triangles, lines and points of a level at vertices without tangents, from which these take
 * normals for shading (ShadingNormals.h).
 */
#ifndef SubdivisionObjects_ShadingFacets_h
#define SubdivisionObjects_ShadingFacets_h

#include "Core/Memory/Buffer.h"
#include "Core/Operators/ShadingNormals.h"

#include <vector>

namespace subdivision
{

/// As ids of vertices.
template <typename Id>
struct ShadingFacets
{
  std::vector<Id> Triangles; ///< three corners, then another vertex of the bounded solid, or -1
  std::vector<Id> Lines;     ///< two ends
  std::vector<Id> Points;

  void Fill(ShadingNormals& normals) const
  {
    for (std::size_t i = 0; i < this->Triangles.size(); i += 4)
    {
      const Id* corners = this->Triangles.data() + i;
      corners[3] < 0 ? normals.AddFacet(corners, 3, false)
                     : normals.AddFacetOfSolid(corners, corners[3]);
    }
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
    return sizeof(Id) * (this->Triangles.size() + this->Lines.size() + this->Points.size());
  }
};

/// Finds the triangle cells, the triangles of boundaries, the line cells and the vertex cells at
/// vertices whose row of `sectors` is empty. Takes time linear in the size of the level.
template <typename Level>
ShadingFacets<typename Level::IdType> FindShadingFacets(
  const Level& level, const Rows<typename Level::IdType>& sectors);

}

#endif
