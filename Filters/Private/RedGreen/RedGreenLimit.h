// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenLimit.h
 * Red-green refinement and the limit of smooth subdivision: the operator that puts all vertices of
 * a state on it, and the errors of edges that criteria ask for.
 */
#ifndef SubdivisionObjects_RedGreenLimit_h
#define SubdivisionObjects_RedGreenLimit_h

#include "Core/Memory/PairTable.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LimitNormals.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Private/Control/ControlComplex.h"
#include "Private/Criteria/RefinementCriteria.h"
#include "Private/RedGreen/RefinementMarks.h"

#include <array>
#include <variant>
#include <vector>

namespace subdivision
{

template <typename Id>
class RedGreenLimit
{
public:
  /// `scheme`: that of the limit. False where a stamp that is trusted leads to other cells than
  /// those that were read.
  bool Build(const ControlMesh& mesh, const FeatureOptions& features, StampScheme scheme,
    const Coordinates& points, const WarnFunction& warn);

  /// The limits of the control vertices.
  SparseRows<Id> GetControlRows() const;
  /// Sets the coordinates and the attribute of the control vertices, where they are not those that
  /// the criteria read; empty: they are.
  void SetControlValues(std::vector<double> coordinates, std::vector<double> attribute)
  {
    this->ControlCoordinates = std::move(coordinates);
    this->ControlAttribute = std::move(attribute);
  }

  /// Calls act(level) for the control level, which is of the scheme of the limit.
  template <typename Act>
  void WithControl(const Act& act) const
  {
    std::visit(act, this->Control);
  }

  /// From values at the control vertices to the limits of all vertices of a state; `hasNormals`:
  /// for normals, too.
  LocalLimit<Id> GetOperator(const RedGreen<Id>& state, bool hasNormals) const;

  /// Finds the errors of the edges of candidates: the largest distance of the limit from the edge,
  /// measured at one to three places along it; inside a surface the distance from the triangles at
  /// the edge. The error inside a triangle counts for its three edges, inside a green triangle for
  /// the edge that is no edge of the uniform refinement.
  template <typename Cells>
  void FindErrors(const RedGreen<Id>& state, const Cells& cells, int maximumLevel,
    const RefinementOptions& options, const RefinementCriteria& criteria);

  /// What FindErrors found; negative: a value is not finite.
  double GetError(Id a, Id b) const
  {
    const Id edge = this->Edges.Find(a, b);
    return edge < 0 ? 0. : this->Errors[edge];
  }

private:
  using Carrier = std::array<Id, 4>; ///< the vertices of a control simplex, ascending; then -1

  /// A place on the limit at which the error is measured, and the point of the straight edge or
  /// triangle that stands for it.
  struct Sample
  {
    Id Place = 0; ///< among the vertices of the state, then the Middles
    std::array<Id, 3> Corners{ { -1, -1, -1 } };
    std::array<double, 3> Weights{ { 0., 0., 0. } };
    std::array<Id, 3> Edges{ { -1, -1, -1 } }; ///< the edges that get the error
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

  void FindCurved(const SimplicialComplex<Id>& complex, const Strata<Id>& strata);
  void FindCarriers(const RedGreen<Id>& state);
  bool IsCurved(const Carrier& carrier) const;
  void AddSide(Id edge, Id opposite, bool isOfSolid);
  double GetErrorOfEdge(const Sample& sample, const double* const* corners, const double* place,
    const Buffer<double>& limits, const Buffer<Id>& numbers,
    const RefinementCriteria& criteria) const;
  static Carrier Unite(const Carrier& a, const Carrier& b);
  template <typename Cells>
  void FindSamples(const RedGreen<Id>& state, const Cells& cells, int maximumLevel,
    const RefinementOptions& options);
  Id GetMiddle(Id a, Id b);
  static EdgeOfCell LookAt(const RedGreen<Id>& state, const std::array<Id, 4>& leaf, Id a, Id b);
  void AddEdge(const EdgeOfCell& edge, const std::array<Id, 4>& leaf);
  void AddTriangle(const RedGreen<Id>& state, const std::array<Id, 4>& leaf,
    const std::array<Id, 3>& corners, bool isOfSolid);
  Buffer<Id> NumberPlaces(
    const RedGreen<Id>& state, std::vector<std::array<Id, 2>>& midpoints) const;
  void Measure(const RedGreen<Id>& state, const RefinementOptions& options,
    const RefinementCriteria& criteria);

  template <typename Scheme>
  bool BuildWith(const ControlMesh& mesh, const FeatureOptions& features, const Coordinates& points,
    const WarnFunction& warn);
  LocalLimit<Id> MakeOperator(const std::vector<std::array<Id, 2>>& midpoints,
    const Buffer<unsigned char>& wanted, const ControlSolids* solids) const;

  std::variant<Level<Id>, TetOctLevel<Id>> Control;
  SemiSharpStages<Id> Creases;
  ControlSolids Solids;
  std::vector<double> ControlCoordinates;
  std::vector<double> ControlAttribute;
  /// Edges and faces of the control mesh that do not follow the rule for the inside of a solid;
  /// sorted.
  std::vector<Carrier> Curved;
  std::vector<Carrier> Carriers; ///< of each vertex of the state so far
  PairTable<Id> Edges;
  Buffer<double> Errors;          ///< of edges
  std::vector<SidesOfEdge> Sides; ///< of edges
  Id NumberOfEdges = 0;
  // Samples of one round:
  Id FirstMiddle = 0; ///< the number of vertices of the state
  PairTable<Id> MiddlesByEnds;
  std::vector<std::array<Id, 2>> Middles; ///< ends of each place that is no vertex
  std::vector<Sample> Samples;
};

}

#endif
