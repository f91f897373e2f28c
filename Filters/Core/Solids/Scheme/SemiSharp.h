// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SemiSharp.h
 * Rows of semi-sharp creases and surfaces: blends of the smooth and the sharp rows (Mathematics 5).
 *
 * In the sharp row of a vertex or edge all lines and triangles are singular that are still sharp.
 * Its weight is min(1, mean of the remaining sharpness of the lines at it, which are the edge
 * itself or edges at the vertex; if no line is sharp there, of the triangles at it).
 */
#ifndef SubdivisionObjects_SemiSharp_h
#define SubdivisionObjects_SemiSharp_h

#include "Core/Rules/Sharpness.h"
#include "Core/Solids/Scheme/Stencils.h"

#include <vector>

namespace subdivision
{

/// The remaining sharpness of control edges and of control faces; each may be empty.
struct SolidSharpness
{
  EdgeSharpness Edges;
  std::vector<double> Faces;
};

inline bool IsSharpAfter(const SolidSharpness& sharpness, int steps)
{
  return IsSharpAfter(sharpness.Edges, steps) || IsSharpAfter(sharpness.Faces, steps);
}

struct SharpRow
{
  vtkIdType Row;
  double Sharpness; ///< that remains, a mean
};

/// Lists the lines and faces of a level that are still sharp, for the row of each vertex and edge
/// in them. Rows of edges come after rows of vertices.
class SharpParts
{
public:
  /// Adds a part to a row.
  void Add(vtkIdType row, bool isFace, double sharpness)
  {
    this->Parts.push_back({ row, isFace, sharpness });
  }
  template <typename Id>
  void AddEdge(const SimplicialComplex<Id>& complex, vtkIdType edge, double sharpness);
  template <typename Id>
  void AddFace(const SimplicialComplex<Id>& complex, vtkIdType face, double sharpness);
  /// After the last part.
  void Sort();
  std::vector<SharpRow> GetRows() const;
  /// The mean of the remaining sharpness at a row after `steps` more steps; 0: none.
  double GetSharpness(vtkIdType row, double steps) const;
  /// The largest sharpness at a row.
  double GetMostSharpness(vtkIdType row) const;

private:
  struct Part
  {
    vtkIdType Row;
    bool IsFace;
    double Sharpness;
  };
  using Iterator = std::vector<Part>::const_iterator;
  Iterator FindRow(vtkIdType row) const;
  Iterator FindEnd(Iterator first) const;
  static double GetMean(Iterator first, Iterator end, double steps);

  std::vector<Part> Parts;
};

/**
 * Finds the rows that are blends: rows of vertices, and then rows of edges. `sharpness` is of
 * control simplices. Since it was given `steps` steps have been made, so that value - steps
 * remains. `depth` is the number of steps since the control mesh: a control edge has become 2^depth
 * edges of `complex`, a control face 4^depth faces. A level for output has only triangle cells.
 */
template <typename Id>
std::vector<SharpRow> FindSharpRows(
  const SolidSharpness& sharpness, int steps, int depth, const SimplicialComplex<Id>& complex);

/// Replaces these rows of `smooth`, which ascend, by blends with rows of `sharp`, which is the same
/// operator with all edges and faces singular that are still sharp.
template <typename Id>
void BlendSemiSharp(
  const std::vector<SharpRow>& rows, const Stencils<Id>& sharp, Stencils<Id>& smooth);

}

#endif
