// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/ShadingFacets.h"

#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <algorithm>
#include <iterator>

namespace subdivision
{

template <typename Level>
ShadingFacets<typename Level::IdType> FindShadingFacets(
  const Level& level, const Rows<typename Level::IdType>& sectors)
{
  using Id = typename Level::IdType;
  const SimplicialComplex<Id>& complex = level.Complex;
  ShadingFacets<Id> facets;
  auto hasNone = [&sectors](Id vertex)
  { return sectors.Offsets[vertex] == sectors.Offsets[vertex + 1]; };
  for (Id f = 0; f < complex.NumberOfFaces; ++f)
  {
    const Row<Id> cells = complex.FaceTets[f];
    const Id* corners = complex.FaceVertices.data() + 3 * vtkIdType(f);
    if ((cells.size() < 2 || f < complex.NumberOfTriangleCells) &&
      std::any_of(corners, corners + 3, hasNone))
    {
      facets.Triangles.insert(facets.Triangles.end(), corners, corners + 3);
      facets.Triangles.push_back(
        cells.size() == 1 ? SchemeOf<Level>::FindInside(level, *cells.begin(), corners) : -1);
    }
  }
  for (Id e = 0; e < complex.NumberOfLineCells; ++e)
  {
    const Id* ends = complex.EdgeVertices.data() + 2 * vtkIdType(e);
    if (std::any_of(ends, ends + 2, hasNone))
    {
      facets.Lines.insert(facets.Lines.end(), ends, ends + 2);
    }
  }
  std::copy_if(complex.VertexCells.begin(), complex.VertexCells.end(),
    std::back_inserter(facets.Points), hasNone);
  return facets;
}

#define SUBDIVISION_FACETS(Scheme)                                                                 \
  template ShadingFacets<Scheme::Id> FindShadingFacets(                                            \
    const Scheme::Level&, const Rows<Scheme::Id>&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_FACETS);

}
