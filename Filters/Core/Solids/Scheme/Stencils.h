// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stencils.h
 * The operator of a volume scheme (Mathematics 1): the matrix that takes values at the vertices of
 * a level, coordinates or any array, to values at the vertices of the next.
 *
 * Rows are stored as rules and rings without weights, which follow from the rule and the size of
 * the ring. Vertex rows come first, then edge rows, then rows of the centres of solids. A scheme
 * gives its own kinds of rows with overloads of two functions: GetSolidRows(level), and
 * TakeSolidRows(level, stencils), which moves the same out of the level.
 */
#ifndef SubdivisionObjects_Stencils_h
#define SubdivisionObjects_Stencils_h

#include "Core/Operators/PointOperator.h"
#include "Core/Solids/Scheme/Level.h"

#include <memory>
#include <vector>

namespace subdivision
{

/// Rows with explicit weights, which replace rows of rules and rings. Rows ascend.
template <typename Id>
struct ExplicitRows
{
  std::vector<Id> Rows;
  std::vector<Id> Offsets{ 0 };
  std::vector<Id> Columns;
  std::vector<double> Weights;
};

/// The part of rows that schemes store in ways of their own.
template <typename Id>
struct SolidRows
{
  const RingMasks* Masks;
  vtkIdType NumberOfCentres = 0;
  const Id* CentreVertices = nullptr; ///< six for each centre, which is their mean
  /// The weights of these vertices, the first ones, depend on counts, one for each member of their
  /// rings (RingRows).
  vtkIdType NumberOfCounted = 0;
  const Id* Counts = nullptr;
};

/// The stored rows of an operator, or of a level from which no operator was taken yet.
template <typename Id>
struct StoredRows
{
  const Buffer<Stratum>& Vertices;
  const Buffer<Stratum>& Edges;
  const Buffer<Id>& EdgeVertices;
  const Rings<Id>& VertexRings;
  const Rings<Id>& EdgeRings;
  const SolidRows<Id> Solids;

  vtkIdType GetNumberOfRows() const
  {
    return this->Vertices.size() + this->Edges.size() + this->Solids.NumberOfCentres;
  }
  /// The rows of a range of vertices (kind 0), of edges (1), or of centres (2).
  RingRows<Id> Get(std::size_t kind, vtkIdType begin, vtkIdType end) const;
};

/// The rows of a level that stays whole.
template <typename Level>
StoredRows<typename Level::IdType> GetStoredRows(const Level& level)
{
  return { level.Strata.Vertices, level.Strata.Edges, level.Complex.EdgeVertices,
    level.Strata.VertexRings, level.Strata.EdgeRings, GetSolidRows(level) };
}

/// The rows of the edges of a level whose rule depends on sectors (SectorEdges.h).
template <typename Id>
ExplicitRows<Id> MakeSectorRows(const Strata<Id>& strata, const Buffer<Id>& edgeVertices);

/// Appends columns and weights of a row, each weight times `factor`. `own`: rows that replace some
/// of the stored ones.
template <typename Id>
void AppendRow(const StoredRows<Id>& stored, const ExplicitRows<Id>& own, vtkIdType row,
  double factor, ExplicitRows<Id>& rows);

/// The operator that takes a level to the next, while the level stays whole and has no sectors
/// (SectorEdges.h). ChildRows.h has the operator of a level that is never made.
template <typename Id>
class LevelRows : public RingOperator<Id>
{
public:
  template <typename Level>
  explicit LevelRows(const Level& level)
    : Stored(GetStoredRows(level))
  {
  }
  vtkIdType GetNumberOfColumns() const override { return this->Stored.Vertices.size(); }
  vtkIdType GetNumberOfRows() const override { return this->Stored.GetNumberOfRows(); }
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;

private:
  const StoredRows<Id> Stored;
};

template <typename Id>
struct Stencils : RingOperator<Id>
{
  Buffer<Stratum> Vertices;
  Buffer<Stratum> Edges;
  Buffer<Id> EdgeVertices;
  Rings<Id> VertexRings; ///< without carriers
  Rings<Id> EdgeRings;
  const RingMasks* Masks = nullptr;
  Buffer<Id> CentreVertices; ///< as in SolidRows
  vtkIdType NumberOfCounted = 0;
  std::shared_ptr<const Buffer<Id>> Counts; ///< null: none
  ExplicitRows<Id> Explicit;                ///< of sectors, and of semi-sharp creases

  vtkIdType GetNumberOfColumns() const override { return this->Vertices.size(); }
  vtkIdType GetNumberOfRows() const override { return this->GetStored().GetNumberOfRows(); }
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;
  void ForEachBlock(const PointOperator::User& use) const override;
  std::size_t GetMemorySize() const;

  /// Appends columns and weights of a row, each weight times `factor`.
  void AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const
  {
    subdivision::AppendRow(this->GetStored(), this->Explicit, row, factor, rows);
  }

private:
  StoredRows<Id> GetStored() const;
};

/// Moves the operator out of a level that is not refined any more. Write its cells first, because
/// they need vertices of edges and solids.
template <typename Level>
Stencils<typename Level::IdType> TakeStencils(Level& level)
{
  using Id = typename Level::IdType;
  Stencils<Id> stencils;
  TakeSolidRows(level, stencils);
  stencils.Explicit = MakeSectorRows(level.Strata, level.Complex.EdgeVertices);
  stencils.Vertices = std::move(level.Strata.Vertices);
  stencils.Edges = std::move(level.Strata.Edges);
  stencils.EdgeVertices = std::move(level.Complex.EdgeVertices);
  stencils.VertexRings = std::move(level.Strata.VertexRings);
  stencils.VertexRings.Carriers = Buffer<Id>();
  stencils.EdgeRings = std::move(level.Strata.EdgeRings);
  stencils.EdgeRings.Carriers = Buffer<Id>();
  return stencils;
}

}

#endif
