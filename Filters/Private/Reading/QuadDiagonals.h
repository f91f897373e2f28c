// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file QuadDiagonals.h
 * Which diagonal splits a quad. The answer depends on the quad's four points and on the triangles
 * of the whole mesh, never on the cell that asks: so all its neighbours agree, and nothing is
 * stored per quad.
 */
#ifndef SubdivisionObjects_QuadDiagonals_h
#define SubdivisionObjects_QuadDiagonals_h

#include "Private/Reading/PointOrder.h"

#include "vtkType.h"

#include <array>
#include <vector>

namespace subdivision
{

/// Point ids in ascending order.
using TriangleKey = std::array<vtkIdType, 3>;
using QuadKey = std::array<vtkIdType, 4>;

TriangleKey MakeTriangleKey(vtkIdType a, vtkIdType b, vtkIdType c);
QuadKey MakeQuadKey(const vtkIdType* quad);

class QuadDiagonals
{
public:
  explicit QuadDiagonals(const PointOrder& order)
    : Order(order)
  {
  }

  /// The triangles that the mesh has beside its quads. Repeated ones are welcome.
  void SetTriangles(std::vector<TriangleKey>&& triangles, vtkIdType numberOfPoints);

  struct Choice
  {
    /// 0: the diagonal joins the quad's points 0 and 2; 1: 1 and 3.
    int Diagonal = 0;
    /// The mesh has triangles on both diagonals, so no choice conforms.
    bool Contested = false;
  };

  /// `quad`: four different points, in the order of its boundary.
  Choice Choose(const vtkIdType* quad) const;

  /// The diagonal on both sides of which the mesh has triangles; -1: there is none. Of two it is
  /// the one through the smallest point.
  int FindCut(const vtkIdType* quad) const;

  const PointOrder& GetOrder() const { return this->Order; }

private:
  /// Of a diagonal and the quad's other two points: how many triangles of the mesh these make.
  int CountTriangles(const vtkIdType* quad, int diagonal) const;
  /// The diagonal through the smallest point.
  int FindSmallest(const vtkIdType* quad) const;
  bool HasTriangle(const TriangleKey& key) const;

  PointOrder Order;
  std::vector<TriangleKey> Triangles; ///< ascending
  std::vector<vtkIdType> First; ///< of the triangles with smallest id p: [First[p], First[p+1])
};

}

#endif
