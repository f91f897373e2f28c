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

namespace surfacetools
{

using Weights = std::map<int, double>; ///< by column

/// Of all rows together.
Weights ToWeights(const RowBlock<int>& rows);

/// Compares to rounding. Columns that one of the rows does not name have the weight 0.
void ExpectRow(const Weights& row, const Weights& expected, const std::string& what);

/// A row that goes by the part s to where ends 1 and k + 1 of a sector's curves have these weights.
Weights Flatten(Weights row, int k, double s, double first, double last);

/// The angle of the only sector of some vertices, and its flatness; negative: by default.
SurfaceFeatures GiveShape(
  std::size_t points, const std::vector<int>& vertices, double angle, double flatness = -1.);

/// Calls `test(model, features, j, side)` for each smooth edge j of vertex 0 between two creases,
/// on whose side there are so many faces; `make(n)` makes a surface with n faces there.
template <typename Make, typename Test>
void ForEdgesNextToACrease(const Make& make, const Test& test)
{
  for (int left = 1; left <= 6; ++left)
  {
    for (int right = left == 1 ? 2 : 1; right <= 6; ++right)
    {
      Model model = make(left + right);
      model.Lines = { { 0, 1 }, { 0, 1 + left } };
      SurfaceFeatures features;
      features.DartEnds = true; // the other ends of the two creases ask for nothing
      SCOPED_TRACE("creases " + std::to_string(left) + " " + std::to_string(right));
      for (int j = 1; j < left + right; ++j)
      {
        if (j != left)
        {
          test(model, features, j, j < left ? left : right);
        }
      }
    }
  }
}

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
