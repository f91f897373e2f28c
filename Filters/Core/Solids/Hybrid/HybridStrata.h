// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridStrata.h
 * Which rule does each vertex, edge and face follow (Mathematics 15). The control mesh is decided
 * by the links of StrataBuilder.h; children inherit: what lies in an edge or a face has its rule,
 * what lies in a solid the rule of solids.
 */
#ifndef SubdivisionObjects_HybridStrata_h
#define SubdivisionObjects_HybridStrata_h

#include "Core/Cells/CellComplex.h"
#include "Core/Solids/Scheme/SemiSharp.h"
#include "Core/Solids/Strata/StrataBuilder.h"

#include <vector>

namespace subdivision
{

/// A vertex with d = 1, and its neighbours on the curve.
template <typename Id>
struct CurveVertex
{
  Id Vertex;
  Id Ring[2];
};

template <typename Id>
struct HybridStrata
{
  Buffer<Decision> Vertices;
  Buffer<Decision> Edges;
  Buffer<Stratum> Faces;
  Buffer<unsigned char> SingularFaces; ///< empty: none is
  Buffer<int> EdgeParts;               ///< of JointRule::FollowPart; may be empty
  Buffer<int> FaceParts;
  Buffer<CurveVertex<Id>> Curves; ///< by vertex
  /// Common neighbours of Blend edges beside those on triangles, on the control mesh; may be empty.
  std::vector<std::vector<Id>> Reliefs;
  std::vector<SectorEdge<Id>> Sectors;
  LoopWeights Weights = LoopWeights::Warren;

  const CurveVertex<Id>& GetCurve(Id vertex) const;
};

/// Whether a face, or an edge without faces, is in the ring of a vertex or an edge with d = 2.
template <typename Id>
bool IsInRing(const CellComplex<Id>& complex, const HybridStrata<Id>& strata, Id face,
  const Decision& decision);

template <typename Id>
HybridStrata<Id> DecideHybridStrata(
  const CellComplex<Id>& complex, const SingularSimplices& singular, const StrataOptions& options);

/// The strata of the next level, `next`.
template <typename Id>
HybridStrata<Id> RefineHybridStrata(
  const CellComplex<Id>& complex, const HybridStrata<Id>& strata, const CellComplex<Id>& next);

/// What semi-sharp edges and faces of a level need; empty: there are none.
template <typename Id>
struct HybridSharpness
{
  /// The strata of the next `Steps` steps if all edges and faces were singular that are still sharp
  /// in the last of these.
  struct Stage
  {
    double Steps;
    HybridStrata<Id> Strata;
  };
  SolidSharpness Left;       ///< of each edge and face
  std::vector<Stage> Stages; ///< in the order in which they end

  /// The rows of the next step that are blends of the smooth row and the row of the first stage, in
  /// ascending order.
  std::vector<SharpRow> FindRows(
    const CellComplex<Id>& complex, const HybridStrata<Id>& smooth) const;
  /// The largest sharpness of edges and faces at a vertex.
  double GetMost(const CellComplex<Id>& complex, Id vertex) const;
};

/// `singular` is for ever.
template <typename Id>
HybridSharpness<Id> DecideHybridSharpness(const CellComplex<Id>& complex,
  const SingularSimplices& singular, const StrataOptions& options, SolidSharpness sharpness);

/// The same on the next level, `next`.
template <typename Id>
HybridSharpness<Id> RefineHybridSharpness(const CellComplex<Id>& complex,
  const HybridSharpness<Id>& sharpness, const CellComplex<Id>& next);

}

#endif
