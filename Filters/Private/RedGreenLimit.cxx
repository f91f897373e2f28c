// SPDX-License-Identifier: BSD-3-Clause
#include "RedGreenLimit.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

template <typename Id>
bool RedGreenLimit<Id>::Build(const ControlMesh& mesh, const FeatureOptions& features,
  const double* points, const WarnFunction& warn)
{
  ControlComplex<Id> control;
  if (!BuildControlComplex(mesh, features, points, warn, Depth::ForRefinement, control))
  {
    return false;
  }
  this->Control = std::move(control.Current);
  this->Creases = BuildSharpStages<Id>(mesh, features, control, 0);
  this->FindCurved();
  return true;
}

template <typename Id>
LocalLimit<Id> RedGreenLimit<Id>::GetOperator(const RedGreen<Id>& state) const
{
  const Id given = state.GetNumberOfInputVertices();
  std::vector<std::array<Id, 2>> midpoints(state.GetNumberOfVertices() - given);
  ForEach(static_cast<vtkIdType>(midpoints.size()),
    [&](vtkIdType i) { midpoints[i] = state.GetEnds(static_cast<Id>(given + i)); });
  return LocalLimit<Id>(this->Control, this->Creases, midpoints);
}

// ------------------------------------------------------------------------------------------------
// Where vertices lie

template <typename Id>
void RedGreenLimit<Id>::FindCurved()
{
  const SimplicialComplex<Id>& complex = this->Control.Complex;
  for (Id e = 0; e < complex.NumberOfEdges; ++e)
  {
    const Rule rule = this->Control.Strata.Edges[e].GetRule();
    if (rule != Rule::Solid && rule != Rule::RegularEdge)
    {
      const Id* ends = complex.EdgeVertices.data() + 2 * static_cast<vtkIdType>(e);
      this->Curved.push_back(
        { { std::min(ends[0], ends[1]), std::max(ends[0], ends[1]), -1, -1 } });
    }
  }
  for (Id f = 0; f < complex.NumberOfFaces; ++f)
  {
    if (this->Control.Strata.Faces[f].GetRule() != Rule::Solid)
    {
      const Id* corners = complex.FaceVertices.data() + 3 * static_cast<vtkIdType>(f);
      Carrier face = { { corners[0], corners[1], corners[2], -1 } };
      std::sort(face.begin(), face.begin() + 3);
      this->Curved.push_back(face);
    }
  }
  std::sort(this->Curved.begin(), this->Curved.end());
}

template <typename Id>
void RedGreenLimit<Id>::FindCarriers(const RedGreen<Id>& state)
{
  auto vertex = static_cast<Id>(this->Carriers.size());
  this->Carriers.resize(state.GetNumberOfVertices());
  for (; vertex < state.GetNumberOfVertices(); ++vertex)
  {
    if (vertex < state.GetNumberOfInputVertices())
    {
      this->Carriers[vertex] = { { vertex, -1, -1, -1 } };
      continue;
    }
    const auto ends = state.GetEnds(vertex);
    this->Carriers[vertex] = Unite(this->Carriers[ends[0]], this->Carriers[ends[1]]);
  }
}

template <typename Id>
typename RedGreenLimit<Id>::Carrier RedGreenLimit<Id>::Unite(const Carrier& a, const Carrier& b)
{
  Carrier both = { { -1, -1, -1, -1 } };
  auto isEnd = [](Id vertex) { return vertex < 0; };
  std::set_union(a.begin(), std::find_if(a.begin(), a.end(), isEnd), b.begin(),
    std::find_if(b.begin(), b.end(), isEnd), both.begin()); // both lie in one simplex
  return both;
}

/// Whether an edge lies on a curve, a surface, or a boundary, joint or singular surface of a solid.
template <typename Id>
bool RedGreenLimit<Id>::IsCurved(Id a, Id b) const
{
  const Carrier carrier = Unite(this->Carriers[a], this->Carriers[b]);
  return carrier[3] < 0 && std::binary_search(this->Curved.begin(), this->Curved.end(), carrier);
}

// ------------------------------------------------------------------------------------------------
// Errors

/// The edges of candidates that are edges of the uniform refinement.
template <typename Id>
template <typename Cells>
void RedGreenLimit<Id>::FindEdges(const RedGreen<Id>& state, const Cells& cells, int maximumLevel)
{
  this->Edges = PairTable<Id>();
  this->Ends.clear();
  const Id given = state.GetNumberOfInputVertices();
  for (vtkIdType i = 0; i < cells.GetSize(); ++i)
  {
    const auto points = cells.GetPoints(i);
    if (cells.IsOver(i) || cells.GetSteps(i) >= maximumLevel || points.size() < 2)
    {
      continue;
    }
    const auto leaf = state.GetCell(cells.GetLeaf(i)).Vertices;
    auto isCorner = [&leaf](Id v) { return std::find(leaf.begin(), leaf.end(), v) != leaf.end(); };
    auto meet = [&](Id a, Id b) // whether two parts of leaf edges meet: vertices count as such
    {
      const auto none = std::array<Id, 2>{ { a, a } };
      const auto first = isCorner(a) || a < given ? none : state.GetEnds(a);
      const auto other = std::array<Id, 2>{ { b, b } };
      const auto second = isCorner(b) || b < given ? other : state.GetEnds(b);
      return first[0] == second[0] || first[0] == second[1] || first[1] == second[0] ||
        first[1] == second[1];
    };
    for (auto a = points.begin(); a != points.end(); ++a)
    {
      for (auto b = a + 1; b != points.end(); ++b)
      {
        const auto first = static_cast<Id>(*a);
        const auto second = static_cast<Id>(*b);
        const auto next = static_cast<Id>(this->Ends.size());
        if (((isCorner(first) && isCorner(second)) || meet(first, second)) &&
          this->Edges.FindOrAdd(first, second, next) == next)
        {
          this->Ends.push_back({ { first, second } });
        }
      }
    }
  }
}

template <typename Id>
template <typename Cells>
void RedGreenLimit<Id>::FindErrors(const RedGreen<Id>& state, const Cells& cells, int maximumLevel,
  const RefinementOptions& options, const RefinementCriteria& criteria)
{
  this->FindCarriers(state);
  this->FindEdges(state, cells, maximumLevel);
  // The vertices that edges depend on, numbered anew; then the middles of the edges.
  const Id given = state.GetNumberOfInputVertices();
  Buffer<Id> numbers(state.GetNumberOfVertices(), Id(-1));
  for (const auto& ends : this->Ends)
  {
    numbers[ends[0]] = 0;
    numbers[ends[1]] = 0;
  }
  for (Id v = state.GetNumberOfVertices() - 1; v >= given; --v)
  {
    if (numbers[v] == 0)
    {
      const auto ends = state.GetEnds(v);
      numbers[ends[0]] = 0;
      numbers[ends[1]] = 0;
    }
  }
  std::vector<std::array<Id, 2>> midpoints;
  for (Id v = 0; v < state.GetNumberOfVertices(); ++v)
  {
    if (v < given)
    {
      numbers[v] = v;
    }
    else if (numbers[v] == 0)
    {
      numbers[v] = static_cast<Id>(given + midpoints.size());
      const auto ends = state.GetEnds(v);
      midpoints.push_back({ { numbers[ends[0]], numbers[ends[1]] } });
    }
  }
  const vtkIdType firstMiddle = given + static_cast<vtkIdType>(midpoints.size());
  for (const auto& ends : this->Ends)
  {
    midpoints.push_back({ { numbers[ends[0]], numbers[ends[1]] } });
  }
  const LocalLimit<Id> limit(this->Control, this->Creases, midpoints);
  auto getLimits = [&limit](const ContinuedArray& array)
  {
    Buffer<double> limits(limit.GetNumberOfRows() * array.GetComponents());
    limit.Apply(array.Get(0), limits.data(), array.GetComponents());
    return limits;
  };
  const bool ofAttribute = options.Attribute && options.AttributeOfLimit;
  const Buffer<double> points =
    options.ByGeometricError ? getLimits(criteria.GetCoordinates()) : Buffer<double>();
  const Buffer<double> values = ofAttribute ? getLimits(criteria.GetAttribute()) : Buffer<double>();
  this->Errors = Buffer<double>(static_cast<vtkIdType>(this->Ends.size()));
  ForEach(this->Errors.size(),
    [&](vtkIdType e)
    {
      const vtkIdType rows[3] = { numbers[this->Ends[e][0]], numbers[this->Ends[e][1]],
        firstMiddle + e };
      double error = 0.;
      if (options.ByGeometricError && this->IsCurved(this->Ends[e][0], this->Ends[e][1]))
      {
        error = criteria.GetGeometricError(
          points.data() + 3 * rows[0], points.data() + 3 * rows[1], points.data() + 3 * rows[2]);
      }
      if (ofAttribute)
      {
        const int components = criteria.GetAttribute().GetComponents();
        const double change =
          criteria.GetAttributeErrorAtLimit(values.data() + components * rows[0],
            values.data() + components * rows[1], values.data() + components * rows[2]);
        error = change < 0. && error <= 1. ? change : std::max(error, change);
      }
      this->Errors[e] = error;
    });
}

#define SUBDIVISION_ERRORS(Id, Cells)                                                              \
  template void RedGreenLimit<Id>::FindErrors(const RedGreen<Id>&, const Cells<Id>&, int,          \
    const RefinementOptions&, const RefinementCriteria&)
template class RedGreenLimit<int>;
template class RedGreenLimit<long long>;
SUBDIVISION_ERRORS(int, InputCandidates);
SUBDIVISION_ERRORS(int, ChangedCandidates);
SUBDIVISION_ERRORS(long long, InputCandidates);
SUBDIVISION_ERRORS(long long, ChangedCandidates);

}
