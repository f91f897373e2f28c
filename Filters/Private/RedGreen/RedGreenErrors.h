// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenErrors.h
 * The errors of edges for criteria that ask for the limit: how far the limit is from the edges and
 * triangles of a red-green refinement.
 */
#ifndef SubdivisionObjects_RedGreenErrors_h
#define SubdivisionObjects_RedGreenErrors_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/PairTable.h"
#include "Core/Solids/Limits/LatticeValues.h"
#include "Core/Solids/Limits/PatchTree.h"
#include "Private/Criteria/RefinementCriteria.h"
#include "Private/RedGreen/RedGreenLimit.h"
#include "Private/RedGreen/RefinementMarks.h"

#include "vtkSMPThreadLocal.h"

#include <array>
#include <deque>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace subdivision
{

/// What the places of a candidate that is a tetrahedron take: its edges with their places.
constexpr double BytesOfErrors = 1000.;

template <typename Id>
class RedGreenErrors
{
public:
  /// All three must outlive this.
  RedGreenErrors(const RedGreenLimit<Id>& limit, const RefinementOptions& options,
    const RefinementCriteria& criteria);

  /// Finds the errors of the edges of candidates: the largest distance of the limit from the edge,
  /// measured at one to three places along it; inside a surface the distance from the triangles at
  /// the edge. The error inside a triangle counts for its three edges, inside a green triangle for
  /// the edge that is no edge of the uniform refinement.
  template <typename Cells>
  void Find(const RedGreen<Id>& state, const Cells& cells);

  /// The error by Find; negative: a value is not finite.
  double GetError(Id a, Id b) const
  {
    const bool isMeasured = this->OfAttribute || (this->MayBeCurved[a] && this->MayBeCurved[b]);
    const Id edge = isMeasured ? this->Edges.Find(a, b) : Id(-1);
    return edge < 0 ? 0. : this->Errors[edge];
  }

private:
  using Carrier = std::array<Id, 4>; ///< the vertices of a control simplex, ascending; then -1

  /// An edge (two corners) or face (three) of the uniform refinement with the places of
  /// PatchTree.h, or a tetrahedron (four) with one place, between the middles of the edges 01 and
  /// 23.
  struct Site
  {
    std::array<Id, 4> Corners;
    Id Curved;              ///< the number of the simplex on which it lies, -1: inside a solid
    unsigned char Used = 0; ///< a bit for each place
    int GetSize() const { return this->Corners[2] < 0 ? 2 : this->Corners[3] < 0 ? 3 : 4; }
  };
  static constexpr int PlacesOfSite = 3;
  static constexpr std::size_t MostOnLattice = 1 << 20; ///< in numbers of 8 bytes, of each thread
  /// A place on the limit at which the error is measured, and the edge or triangle that stands for
  /// it.
  struct Sample
  {
    Id Site;
    int Place; ///< of the site
    std::array<Id, 3> Corners{ { -1, -1, -1 } };
    std::array<Id, 3> Edges{ { -1, -1, -1 } }; ///< the edges that get the error
    double Weight = 0.;                        ///< of the second end of an edge
    bool OfShape = true;                       ///< not of the attribute alone
  };
  /// An edge of a candidate, and how its ends lie in the leaf of the candidate.
  struct EdgeOfCell
  {
    Id Ends[2];
    /// For each end the edge of the leaf whose midpoint it is; for a corner of the leaf twice the
    /// corner.
    std::array<Id, 2> Of[2];
    /// Whether some cell of the uniform refinement has the edge.
    bool IsUniform;
  };
  /// The triangles of a surface at an edge.
  struct SidesOfEdge
  {
    Id Opposites[2] = { -1, -1 };
    /// Whether errors are distances from the edge and not from triangles. So it is if the edge lies
    /// on a control edge, where input cells end, or has more than two triangles.
    bool IsBoundary = false;
  };
  /// Where a vertex lies on a curve or surface.
  struct PlaceOfVertex
  {
    Id Simplex;                    ///< its number; -1: the vertex is inside a solid
    std::array<double, 3> Weights; ///< of the corners
  };
  /// The ends of vertices at places of sites, whose numbers follow the numbers of the state.
  using Midpoints = std::vector<std::array<Id, 2>>;
  /// The limits over a level, of each thread, from round to round.
  template <typename LevelType>
  struct LevelLimits
  {
    LevelLattices<LevelType> Lattices;
    vtkSMPThreadLocal<std::shared_ptr<LatticeValues<LevelType>>> OfThreads;
  };

  void FindCurved(const SimplicialComplex<Id>& complex, const Strata<Id>& strata);
  void FindCarriers(const RedGreen<Id>& state);
  Id FindNumber(const Carrier& carrier) const;
  Id FindNumber(Id a, Id b) const
  {
    return this->MayBeCurved[a] && this->MayBeCurved[b]
      ? this->FindNumber(Unite(this->Carriers[a], this->Carriers[b]))
      : Id(-1);
  }
  std::array<double, 3> GetWeights(Id vertex, const PatchSimplex<Id>& simplex) const;
  static Carrier Unite(const Carrier& a, const Carrier& b);

  template <typename Cells>
  void FindSamples(const RedGreen<Id>& state, const Cells& cells);
  static EdgeOfCell LookAt(const RedGreen<Id>& state, const std::array<Id, 4>& leaf, Id a, Id b);
  void AddSample(int place, const std::array<Id, 3>& corners, const std::array<Id, 3>& edges,
    double weight, bool ofShape);
  void AddEdge(const EdgeOfCell& edge, const std::array<Id, 4>& leaf, Id curved);
  void AddSide(Id edge, Id opposite, bool isOfSolid);
  void AddTriangle(const RedGreen<Id>& state, const std::array<Id, 4>& leaf,
    const std::array<Id, 3>& corners, Id curved, bool isOfSolid);

  void FindLimits(const RedGreen<Id>& state);
  void FindLimitsOnCurved(const Buffer<double>& control);
  Id GetSimplexOf(vtkIdType item) const;
  template <typename Act>
  void ForPlacesOf(vtkIdType item, const PatchSimplex<Id>& simplex, const Act& act);
  void FindOtherLimits(const RedGreen<Id>& state, const Buffer<double>& control);
  std::vector<std::pair<Id, double*>> FindUnknown(Id vertices, Midpoints& midpoints);
  static Id AddMidpointAt(const Site& site, int place, Id vertices, Midpoints& midpoints);
  template <typename LevelType>
  LevelLimits<LevelType>& GetLimitsOf(const LevelType& level);
  template <typename LevelType>
  LatticeValues<LevelType>& GetValuesOfThread(LevelLimits<LevelType>& limits);
  Buffer<double> GetControlValues() const;
  bool IsKnown(const Buffer<double>& values, vtkIdType place) const;
  bool IsUnknown(Id site, int place) const;
  const double* AtCorner(Id vertex) const
  {
    return this->AtVertices.data() + this->Components * vtkIdType(this->NumberOfCorner[vertex]);
  }

  double Measure(const Sample& sample) const;
  double GetErrorOfEdge(
    const Sample& sample, const double* const* corners, const double* place) const;
  void TakeErrors();

  const RedGreenLimit<Id>& Limit;
  const RefinementOptions& Options;
  const RefinementCriteria& Criteria;
  const bool OfAttribute;
  int Components = 0; ///< coordinates, then the attribute
  /// Edges and faces of the control mesh that do not follow the rule for the inside of a solid,
  /// sorted by their corners, which ascend; then all vertices.
  std::vector<PatchSimplex<Id>> Curved;
  Buffer<vtkIdType> FirstCurved; ///< of each control vertex, in Curved
  KnownPolynomials Polynomials;
  std::tuple<std::unique_ptr<LevelLimits<Level<Id>>>, std::unique_ptr<LevelLimits<TetOctLevel<Id>>>>
    OnLattice; ///< that of the control level is set
  // Of each vertex of the state so far:
  std::vector<Carrier> Carriers;
  std::vector<PlaceOfVertex> Places;
  std::vector<unsigned char> MayBeCurved; ///< 0: no edge at it is on a curve or surface
  // Of one round:
  PairTable<Id> Edges;
  Buffer<double> Errors;          ///< of edges
  std::vector<SidesOfEdge> Sides; ///< of edges
  Id NumberOfEdges = 0;
  std::deque<Site> Sites; ///< these two are large, and grow without a copy
  std::deque<Sample> Samples;
  Buffer<Id> NumberOfCorner; ///< of each vertex of the state that is a corner of a sample
  std::vector<Id> Corners;   ///< these vertices
  Buffer<double> AtVertices; ///< the limits at these corners
  Buffer<double> AtSites;    ///< at the places of sites
};

}

#endif
