// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSqrtThreeOutput.h
 * Writes the triangles and lines of an adaptive sqrt(3) mesh. Their order depends only on which
 * faces are split: the children of a face are consecutive. If all faces are split equally often,
 * faces and vertices have the numbers of the uniform mesh.
 */
#ifndef SubdivisionObjects_AdaptiveSqrtThreeOutput_h
#define SubdivisionObjects_AdaptiveSqrtThreeOutput_h

#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThree.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
class AdaptiveSqrtThreeOutput
{
public:
  /// Renumbers the vertices of the mesh: level by level, in the order of their faces and segments.
  explicit AdaptiveSqrtThreeOutput(AdaptiveSqrtThree<Id>& mesh);

  /// The first vertex of each level, and their number at the end.
  const std::vector<Id>& GetVertexLevels() const { return this->VertexLevels; }

  vtkIdType GetNumberOfTriangles() const { return this->Triangles; }
  /// Writes three vertices, the generation, and the control face of each triangle; of a triangle
  /// that lies in two control faces, the one with the smaller number.
  void WriteTriangles(Id* vertices, unsigned char* generations, vtkIdType* faces) const;

  /// For each triangle the number of its face in the mesh; for one of odd generation a vacant
  /// number.
  Buffer<Id> FindFaces() const;

  /// AppendPieces appends the pieces of a control line, from its beginning. `line` is 2 edge + (1
  /// if the line runs against the edge).
  struct Piece
  {
    Id Ends[2];
    int Generation;
  };
  void AppendPieces(Id line, std::vector<Piece>& pieces) const;

private:
  void NumberVertices();
  void CountTriangles();
  template <typename Act>
  void ForTriangles(const Act& act) const;
  void NumberThirds(std::vector<Id>& segments, Buffer<Id>& numbers, Id& next) const;

  AdaptiveSqrtThree<Id>& Mesh;
  std::vector<Id> VertexLevels;
  vtkIdType Triangles = 0;
  Buffer<Id> Counts;  ///< of triangles in each face
  Buffer<Id> Offsets; ///< the first of them
  AdaptiveSqrtThreeCarriers<Id> Carriers;
};

}

#endif
