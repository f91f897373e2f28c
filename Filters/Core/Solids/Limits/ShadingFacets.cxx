// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/ShadingFacets.h"

#include <algorithm>
#include <iterator>

namespace subdivision
{
namespace
{

/// A vertex of a solid that a face of it does not have.
template <typename Id>
Id FindInside(const Level<Id>& level, Id cell, const Id* face)
{
  const Id* first = level.Complex.TetVertices.data() + 4 * vtkIdType(cell);
  return *std::find_if(
    first, first + 3, [face](Id v) { return std::find(face, face + 3, v) == face + 3; });
}
template <typename Id>
Id FindInside(const TetOctLevel<Id>& level, Id cell, const Id* face)
{
  const Id tets = level.Complex.NumberOfTets;
  const Id* first = cell < tets ? level.Complex.TetVertices.data() + 4 * vtkIdType(cell)
                                : level.OctVertices.data() + 6 * vtkIdType(cell - tets);
  return *std::find_if(first, first + (cell < tets ? 3 : 5),
    [face](Id v) { return std::find(face, face + 3, v) == face + 3; });
}

template <template <typename> class AnyLevel, typename Id>
ShadingFacets<Id> Collect(const AnyLevel<Id>& level, const Rows<Id>& sectors)
{
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
        cells.size() == 1 ? FindInside(level, *cells.begin(), corners) : -1);
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

}

template <typename Id>
ShadingFacets<Id> FindShadingFacets(const Level<Id>& level, const Rows<Id>& sectors)
{
  return Collect(level, sectors);
}
template <typename Id>
ShadingFacets<Id> FindShadingFacets(const TetOctLevel<Id>& level, const Rows<Id>& sectors)
{
  return Collect(level, sectors);
}

template ShadingFacets<int> FindShadingFacets(const Level<int>&, const Rows<int>&);
template ShadingFacets<long long> FindShadingFacets(
  const Level<long long>&, const Rows<long long>&);
template ShadingFacets<int> FindShadingFacets(const TetOctLevel<int>&, const Rows<int>&);
template ShadingFacets<long long> FindShadingFacets(
  const TetOctLevel<long long>&, const Rows<long long>&);

}
