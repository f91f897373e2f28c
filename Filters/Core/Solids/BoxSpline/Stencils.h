// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stencils.h
 * The operator of the box-spline scheme (Mathematics 1): the matrix that takes values at the
 * vertices of a level, coordinates or any array, to those at the vertices of the next.
 *
 * Rows are stored as rules and rings without weights, which follow from the rule and the size of
 * the ring (Masks.h). Vertex rows come first, then edge rows. Each row is summed in double, in the
 * order of the ring, and stored in the type of the array.
 */
#ifndef SubdivisionObjects_Stencils_h
#define SubdivisionObjects_Stencils_h

#include "Core/Memory/Store.h"
#include "Core/Solids/BoxSpline/Refinement.h"

#include <vector>

namespace subdivision
{

/// Rows with explicit weights, which replace those that rules and rings give.
template <typename Id>
struct ExplicitRows
{
  std::vector<Id> Rows;
  std::vector<Id> Offsets{ 0 };
  std::vector<Id> Columns;
  std::vector<double> Weights;

  /// Writes these rows of the result only.
  template <typename T>
  void Apply(const T* in, T* out, int components) const;
};

/// Consecutive rows, all of vertices or all of edges, as they are summed.
template <typename Id>
struct StencilRows
{
  bool OfEdges;
  vtkIdType FirstRow; ///< number of the first row; for a vertex its id
  vtkIdType Count;
  const Stratum* Strata;
  const Id* Ends;    ///< 2 for each edge
  const Id* Offsets; ///< ring i is Members[Offsets[i] .. Offsets[i + 1])
  const Id* Members;

  Row<Id> GetRing(vtkIdType i) const
  {
    return { this->Members + this->Offsets[i], this->Members + this->Offsets[i + 1] };
  }
};

/// out = rows times in, for `components` interleaved values per vertex. Integers are rounded.
template <typename Id, typename T>
void SumRows(const StencilRows<Id>& rows, const T* in, T* out, int components);

template <typename Id>
template <typename T>
void ExplicitRows<Id>::Apply(const T* in, T* out, int components) const
{
  ForEach(static_cast<vtkIdType>(this->Rows.size()),
    [&](vtkIdType i)
    {
      for (int c = 0; c < components; ++c)
      {
        double sum = 0.;
        for (Id k = this->Offsets[i]; k < this->Offsets[i + 1]; ++k)
        {
          sum += this->Weights[k] *
            static_cast<double>(in[static_cast<vtkIdType>(this->Columns[k]) * components + c]);
        }
        out[static_cast<vtkIdType>(this->Rows[i]) * components + c] = Store<T>(sum);
      }
    });
}

template <typename Id>
struct Stencils
{
  Buffer<Stratum> Vertices;
  Buffer<Stratum> Edges;
  Buffer<Id> EdgeVertices;
  Rings<Id> VertexRings; ///< without carriers
  Rings<Id> EdgeRings;
  ExplicitRows<Id> Explicit; ///< semi-sharp creases need them

  vtkIdType GetNumberOfColumns() const { return this->Vertices.size(); }
  vtkIdType GetNumberOfRows() const { return this->Vertices.size() + this->Edges.size(); }
  std::size_t GetMemorySize() const;

  /// Appends columns and weights of the row that the rule gives, each weight times `factor`.
  void AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const;

  /// out = S in, as SumRows.
  template <typename T>
  void Apply(const T* in, T* out, int components) const;
};

/// Moves the operator out of a level that is not refined any more. Write its cells first, because
/// line cells need the vertices of edges.
template <typename Id>
Stencils<Id> TakeStencils(Level<Id>& level);

}

#endif
