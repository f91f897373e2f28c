// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SchemeTools.h
 * Rows of surface schemes as maps from columns to weights, to be compared number by number.
 */
#ifndef SchemeTools_h
#define SchemeTools_h

#include "SurfaceTools.h"

#include "Core/Surfaces/Scheme/SurfaceTags.h"
#include "Core/Surfaces/Steps/SurfaceSchemes.h"

#include <map>
#include <memory>
#include <string>

namespace surfacetools
{

using Weights = std::map<int, double>; ///< by column

/// Of all rows together.
Weights ToWeights(const RowBlock<int>& rows);

/// Compares to rounding. Columns that one of the rows does not name have the weight 0.
void ExpectRow(const Weights& row, const Weights& expected, const std::string& what);

/// Finds the tags of a level that was made of a model: corners are those of the model, its lines
/// are creases.
void ClassifyModel(const Model& model, const SurfaceScheme<int>& scheme, SurfaceFeatures features,
  SurfaceLevel<int>& level);

/// A surface with features, and the rows of a scheme with and without ModifiedBoundary.
class SchemeRows
{
public:
  SchemeRows(SurfaceSchemeKind scheme, const Model& model, const SurfaceFeatures& features);

  /// Of a vertex; of edges and faces by where they stand behind the vertices.
  Weights GetRow(vtkIdType at, bool modified = true) const;
  Weights GetEdgeRow(int a, int b, bool modified = true) const
  {
    return this->GetRow(this->Level.Mesh.NumberOfVertices + this->FindEdge(a, b), modified);
  }
  Weights GetFaceRow(int face, bool modified = true) const
  {
    const PolygonMesh<int>& mesh = this->Level.Mesh;
    return this->GetRow(mesh.NumberOfVertices + mesh.GetNumberOfEdges() + face, modified);
  }

  SurfaceLevel<int> Level;
  const std::shared_ptr<const SurfaceScheme<int>> Modified;
  const std::shared_ptr<const SurfaceScheme<int>> Plain;

private:
  int FindEdge(int a, int b) const;
};

}

#endif
