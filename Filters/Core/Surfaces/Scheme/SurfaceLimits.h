// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceLimits.h
 * Limit positions and tangents of Loop and Catmull-Clark surfaces (Mathematics 8, 12).
 *
 * A limit row is a left eigenvector of the matrix that a step applies to a vertex, the other ends
 * of its edges and, for quads, the opposite corners of its faces. It requires that the rules around
 * the vertex are the same in all further steps. Where the first step has other rules, because
 * curves are near, the row is the limit row of the next level times this step.
 */
#ifndef SubdivisionObjects_SurfaceLimits_h
#define SubdivisionObjects_SurfaceLimits_h

#include "Core/Rules/LoopWeights.h"
#include "Core/Surfaces/Scheme/CurveTangents.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <array>

namespace subdivision
{

template <typename Id>
class LimitFinder
{
public:
  /// `weights`: of triangles; quads have one choice only.
  LimitFinder(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
    const SurfaceScheme<Id>& scheme, bool modifiedBoundary, LoopWeights weights);

  /// SurfaceScheme::AppendLimitRows. A tangent that does not exist has no entries.
  void AppendRows(LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
  {
    for (vtkIdType v = begin; v < end; ++v)
    {
      this->Append(static_cast<Id>(v), kind, rows);
      rows.EndRow();
    }
  }

  /// Appends a tangent of the vertex of a corner, on a curve or a corner, in the sector there.
  void AppendOfSector(Id corner, LimitKind kind, RowBlock<Id>& rows)
  {
    const Id vertex = this->Mesh.Vertices[corner];
    AppendSectorTangent(
      this->Level, this->Tags, vertex, kind, this->Scratch, rows,
      [&](const SectorEnds<Id>& ends, double turn)
      { this->AppendAcross(vertex, ends, turn, rows); }, corner);
    rows.EndRow();
  }

  /// SurfaceScheme::AppendLimitRowsOfNext, where the scheme is one for faces of Arity corners.
  template <int Arity>
  static void AppendRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
    LoopWeights weights, LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

  /// SurfaceScheme::GetSecondTangent, likewise.
  template <int Arity>
  static const double* GetSecondTangent(const double* first);

private:
  void Append(Id vertex, LimitKind kind, RowBlock<Id>& rows);
  struct Star
  {
    std::vector<Id> Edges;
    std::vector<Id> Ends;  ///< of the edges
    std::vector<Id> Faces; ///< face j lies between edges j and j + 1
    std::vector<Id> Opposite;
  };
  /// Weights for the vertex, the ends of its edges and the opposite corners of its faces.
  struct StarMask
  {
    double Own = 0.;
    std::vector<double> Edges;
    std::vector<double> Faces;
  };

  void AppendSmooth(Id vertex, LimitKind kind, RowBlock<Id>& rows);
  void AppendBlend(Id vertex, RowBlock<Id>& rows);
  void AppendCurvePosition(Id vertex, RowBlock<Id>& rows);
  void AppendAcross(Id vertex, const SectorEnds<Id>& ends, double turn, RowBlock<Id>& rows);

  void AddStep(const FanStep<Id>& step, Id vertex);
  static StarMask MakeSmoothMask(LimitKind kind, std::size_t m, bool quads, LoopWeights weights);
  template <int Arity, std::size_t N>
  static const std::array<double, N>& GetRegularMask(LimitKind kind);
  void SetTransversalMask();
  void Solve(LimitKind kind, const std::vector<double>& matrix);
  std::vector<double> MakeMatrix(double own, double ring) const;
  void AppendMask(Id vertex, RowBlock<Id>& rows);
  bool IsUniform() const;

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const SurfaceScheme<Id>& Scheme;
  bool ModifiedBoundary;
  LoopWeights Weights;
  bool Quads;
  Star Around;
  StarMask Row;
  RowBlock<Id> Next;
  std::vector<Id> Scratch;
};

}

#endif
