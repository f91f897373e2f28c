// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/ShadingFacets.h"

#include "Core/Memory/Loops.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <algorithm>
#include <iterator>

namespace subdivision
{

template <typename Level>
ShadingCells<typename Level::IdType> FindShadingCells(const Level& level, int steps)
{
  using Id = typename Level::IdType;
  ShadingCells<Id> cells;
  for (const Id f : InTurn(level.Complex.NumberOfTriangleCells))
  {
    cells.Triangles.push_back(static_cast<Id>(f >> 2 * steps));
  }
  cells.Lines.assign(static_cast<std::size_t>(level.Complex.NumberOfLineCells), 1);
  cells.Points.assign(level.Complex.VertexCells.begin(), level.Complex.VertexCells.end());
  return cells;
}

template <typename Level>
ShadingFacets<typename Level::IdType> FindShadingFacets(const Level& level,
  const Buffer<unsigned char>& missing, const ShadingCells<typename Level::IdType>& cells)
{
  using Id = typename Level::IdType;
  const SimplicialComplex<Id>& complex = level.Complex;
  ShadingFacets<Id> facets;
  auto isMissing = [&missing](Id vertex) { return missing[vertex] != 0; };
  for (const Id f : InTurn(complex.NumberOfFaces))
  {
    const Row<Id> tets = complex.FaceTets[f];
    const Id* corners = complex.FaceVertices.data() + 3 * vtkIdType(f);
    const auto face = static_cast<std::size_t>(f);
    const Id parent = face < cells.Triangles.size() ? cells.Triangles[face] : Id(-1);
    if ((tets.size() < 2 || parent >= 0) && std::any_of(corners, corners + 3, isMissing))
    {
      facets.Triangles.insert(facets.Triangles.end(), corners, corners + 3);
      facets.Triangles.push_back(
        tets.size() == 1 ? SchemeOf<Level>::FindInside(level, *tets.begin(), corners) : -1);
      facets.Parents.push_back(parent);
    }
  }
  for (const std::size_t e : InTurn(cells.Lines.size()))
  {
    const Id* ends = complex.EdgeVertices.data() + 2 * e;
    if (cells.Lines[e] && std::any_of(ends, ends + 2, isMissing))
    {
      facets.Lines.insert(facets.Lines.end(), ends, ends + 2);
    }
  }
  std::copy_if(
    cells.Points.begin(), cells.Points.end(), std::back_inserter(facets.Points), isMissing);
  return facets;
}

#define SUBDIVISION_FACETS(Scheme)                                                                 \
  template ShadingCells<Scheme::Id> FindShadingCells(const Scheme::Level&, int);                   \
  template ShadingFacets<Scheme::Id> FindShadingFacets(                                            \
    const Scheme::Level&, const Buffer<unsigned char>&, const ShadingCells<Scheme::Id>&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_FACETS);

}
