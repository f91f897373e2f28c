// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Complex/SimplicialComplex.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
Buffer<unsigned char> FindManifoldDimensions(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs)
{
  // Dimensions of which the output has no cells are not looked at.
  const auto has = [&runs](int dimension)
  {
    return std::any_of(runs.begin(), runs.end(),
      [dimension](const CellRun& run) { return run.Dimension == dimension; });
  };
  const bool hasVertices = has(0);
  const bool hasEdges = (hasVertices || has(1)) && !complex.HasEdgesAlone(); // or all are lines
  Buffer<unsigned char> vertices(hasVertices ? complex.NumberOfVertices : 0, 0);
  Buffer<unsigned char> edges(hasEdges ? complex.NumberOfEdges : 0, 1);
  const auto edgeDimension = [&](vtkIdType e)
  { return edges.empty() ? static_cast<unsigned char>(1) : edges[e]; };
  auto faceDimension = [&](vtkIdType f)
  { return static_cast<unsigned char>(complex.FaceTets[f].size() > 0 ? 3 : 2); };
  ForEachInTurn(hasEdges ? complex.FaceEdges.size() : 0,
    [&](vtkIdType i)
    {
      unsigned char& edge = edges[complex.FaceEdges[i]];
      edge = std::max(edge, faceDimension(i / 3));
    });
  ForEachInTurn(hasVertices ? complex.EdgeVertices.size() : 0,
    [&](vtkIdType i)
    {
      unsigned char& vertex = vertices[complex.EdgeVertices[i]];
      vertex = std::max(vertex, edgeDimension(i / 2));
    });
  const CellRun last = runs.empty() ? CellRun() : runs.back();
  Buffer<unsigned char> dimensions(last.FirstCell + last.Count);
  for (const CellRun& run : runs)
  {
    if (run.Dimension == 3 || (run.Dimension == 1 && edges.empty()))
    {
      Fill(dimensions.data() + run.FirstCell, run.Count, static_cast<unsigned char>(run.Dimension));
      continue;
    }
    ForEach(run.Count,
      [&](vtkIdType k)
      {
        const vtkIdType i = run.First + k;
        unsigned char& dimension = dimensions[run.FirstCell + k];
        switch (run.Dimension)
        {
          case 0:
            dimension = vertices[complex.VertexCells[i]];
            break;
          case 1:
            dimension = edges[run.Equal ? complex.EqualLines.Twins[i] : i];
            break;
          default:
            dimension = faceDimension(run.Equal ? complex.EqualTriangles.Twins[i] : i);
            break;
        }
      });
  }
  return dimensions;
}

SUBDIVISION_COMPILE_FUNCTION(FindManifoldDimensions);

}
