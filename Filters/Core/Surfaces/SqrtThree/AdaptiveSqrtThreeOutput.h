// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSqrtThreeOutput.h
 * The triangles and lines of an adaptive sqrt(3) mesh, in an order that depends on nothing but on
 * which faces are split: the children of a face one after another. Where every face of a level is
 * split, faces and vertices have the numbers of the uniform mesh.
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
  /// Three vertices, the index of the paper, and the control face of each triangle: of those that
  /// lie in two, the first.
  template <typename Value>
  void WriteTriangles(Value* vertices, unsigned char* generations, vtkIdType* faces) const;

  /// For each triangle, the value of the control face from which it has its orientation.
  template <typename Value>
  Buffer<Value> SpreadToTriangles(const Buffer<Value>& ofControlFaces) const
  {
    Buffer<Value> values(this->Triangles);
    ForEach(this->Mesh.GetNumberOfControlFaces(),
      [&](vtkIdType f)
      {
        Value* first = values.data() + this->Offsets[f];
        std::fill(first, first + this->Counts[f], ofControlFaces[f]);
      });
    return values;
  }

  /// The pieces of a control line (2 edge + 1 if it runs against the edge), from its beginning.
  struct Piece
  {
    Id Ends[2];
    int Generation;
  };
  void AppendPieces(Id line, std::vector<Piece>& pieces) const;

private:
  void NumberVertices();
  void CountTriangles();
  Id GetSourceOfHalf(Id face, int corner) const;
  void NumberThirds(std::vector<Id>& segments, Buffer<Id>& numbers, Id& next) const;

  AdaptiveSqrtThree<Id>& Mesh;
  std::vector<Id> VertexLevels;
  vtkIdType Triangles = 0;
  Buffer<Id> Counts;            ///< of triangles in each face
  Buffer<Id> Offsets;           ///< the first of them
  Buffer<Carrier<Id>> Carriers; ///< of each face, on the control mesh
};

}

#endif
