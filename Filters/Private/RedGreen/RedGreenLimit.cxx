// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenLimit.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

template <typename Id>
bool RedGreenLimit<Id>::Build(const ControlMesh& mesh, const FeatureOptions& features,
  StampScheme scheme, const Coordinates& points, const WarnFunction& warn)
{
  return scheme == StampScheme::TetOct
    ? this->template BuildWith<TetOctScheme<Id>>(mesh, features, points, warn)
    : this->template BuildWith<BoxSplineScheme<Id>>(mesh, features, points, warn);
}

template <typename Id>
template <typename Scheme>
bool RedGreenLimit<Id>::BuildWith(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn)
{
  ControlComplex<Id> control;
  typename Scheme::Level level;
  if (!BuildControlComplex<Scheme>(
        mesh, features, points, warn, Depth::ForRefinement, control, level))
  {
    return false;
  }
  this->Solids.Numbers = std::move(control.Solids);
  this->Solids.Steps = mesh.MadeLevels;
  this->Creases = BuildSharpStages<Scheme>(mesh, features, control, 0);
  this->FindCurved(level.Complex, level.Strata);
  this->Control = std::move(level);
  return true;
}

template <typename Id>
SparseRows<Id> RedGreenLimit<Id>::GetControlRows() const
{
  return std::visit(
    [this](const auto& control) { return BuildLimitRows(control, this->Creases); }, this->Control);
}

template <typename Id>
LocalLimit<Id> RedGreenLimit<Id>::MakeOperator(const std::vector<std::array<Id, 2>>& midpoints,
  const Buffer<unsigned char>& wanted, const ControlSolids* solids) const
{
  return std::visit([&](const auto& control)
    { return LocalLimit<Id>(control, this->Creases, midpoints, wanted, 1, solids); },
    this->Control);
}

template <typename Id>
LocalLimit<Id> RedGreenLimit<Id>::GetOperator(const RedGreen<Id>& state, bool hasNormals) const
{
  const Id given = state.GetNumberOfInputVertices();
  std::vector<std::array<Id, 2>> midpoints(state.GetNumberOfVertices() - given);
  ForEach(static_cast<vtkIdType>(midpoints.size()),
    [&](vtkIdType i) { midpoints[i] = state.GetEnds(static_cast<Id>(given + i)); });
  return this->MakeOperator(
    midpoints, Buffer<unsigned char>(), hasNormals ? &this->Solids : nullptr);
}

// ------------------------------------------------------------------------------------------------
// Where vertices lie

template <typename Id>
void RedGreenLimit<Id>::FindCurved(const SimplicialComplex<Id>& complex, const Strata<Id>& strata)
{
  for (const Id e : InTurn(complex.NumberOfEdges))
  {
    const Rule rule = strata.Edges[e].GetRule();
    if (rule != Rule::Solid && rule != Rule::RegularEdge)
    {
      const Id* ends = complex.EdgeVertices.data() + 2 * static_cast<vtkIdType>(e);
      this->Curved.push_back(
        { { std::min(ends[0], ends[1]), std::max(ends[0], ends[1]), -1, -1 } });
    }
  }
  for (const Id f : InTurn(complex.NumberOfFaces))
  {
    if (strata.Faces[f].GetRule() != Rule::Solid)
    {
      const Id* corners = complex.FaceVertices.data() + 3 * static_cast<vtkIdType>(f);
      Carrier face = { { corners[0], corners[1], corners[2], -1 } };
      std::sort(face.begin(), face.begin() + 3);
      this->Curved.push_back(face);
    }
  }
  StableSort(this->Curved, std::less<>());
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

/// Whether the limit of a control simplex is a curve, a surface, or a boundary, joint or singular
/// surface of a solid.
template <typename Id>
bool RedGreenLimit<Id>::IsCurved(const Carrier& carrier) const
{
  return carrier[3] < 0 && std::binary_search(this->Curved.begin(), this->Curved.end(), carrier);
}

// ------------------------------------------------------------------------------------------------
// Where to look

/// The place in the middle of an edge of the uniform refinement, which is given by its ends.
template <typename Id>
Id RedGreenLimit<Id>::GetMiddle(Id a, Id b)
{
  const auto next = static_cast<Id>(this->FirstMiddle + this->Middles.size());
  const Id place = this->MiddlesByEnds.FindOrAdd(a, b, next);
  if (place == next)
  {
    this->Middles.push_back({ { a, b } });
  }
  return place;
}

template <typename Id>
typename RedGreenLimit<Id>::EdgeOfCell RedGreenLimit<Id>::LookAt(
  const RedGreen<Id>& state, const std::array<Id, 4>& leaf, Id a, Id b)
{
  EdgeOfCell edge{ { a, b }, {}, false };
  for (int i = 0; i < 2; ++i)
  {
    const Id end = edge.Ends[i];
    const bool isCorner = std::find(leaf.begin(), leaf.end(), end) != leaf.end();
    edge.Of[i] = isCorner || end < state.GetNumberOfInputVertices()
      ? std::array<Id, 2>{ { end, end } }
      : state.GetEnds(end);
  }
  const auto& [first, second] = edge.Of;
  edge.IsUniform = (first[0] == first[1] && second[0] == second[1]) || first[0] == second[0] ||
    first[0] == second[1] || first[1] == second[0] || first[1] == second[1];
  return edge;
}

/// Adds the places at which an edge is measured: three on an edge of the uniform refinement, so
/// that a curve is noticed that crosses the edge in its middle; on any other edge its middle.
template <typename Id>
void RedGreenLimit<Id>::AddEdge(const EdgeOfCell& edge, const std::array<Id, 4>& leaf)
{
  const Id a = edge.Ends[0];
  const Id b = edge.Ends[1];
  const Id number = this->Edges.FindOrAdd(a, b, this->NumberOfEdges);
  if (number != this->NumberOfEdges)
  {
    return;
  }
  ++this->NumberOfEdges;
  this->Sides.emplace_back();
  this->Sides.back().IsBoundary = Unite(this->Carriers[a], this->Carriers[b])[2] < 0;
  auto add = [&](Id place, double weight)
  {
    this->Samples.push_back(
      { place, { { a, b, -1 } }, { { 1. - weight, weight, 0. } }, { { number, -1, -1 } } });
  };
  if (edge.IsUniform)
  {
    const Id middle = this->GetMiddle(a, b);
    add(middle, 0.5);
    add(this->GetMiddle(a, middle), 0.25);
    add(this->GetMiddle(middle, b), 0.75);
    return;
  }
  const bool isFromCorner = edge.Of[0][0] == edge.Of[0][1];
  const bool isToCorner = edge.Of[1][0] == edge.Of[1][1];
  if (isFromCorner || isToCorner)
  {
    const Id corner = isFromCorner ? a : b;
    const auto& split = edge.Of[isFromCorner ? 1 : 0];
    add(this->GetMiddle(this->GetMiddle(corner, split[0]), this->GetMiddle(corner, split[1])), 0.5);
  }
  else // between midpoints of opposite edges: in the middle of the leaf, like the diagonal
  {
    add(this->GetMiddle(this->GetMiddle(leaf[0], leaf[2]), this->GetMiddle(leaf[1], leaf[3])), 0.5);
  }
}

/// Adds a triangle to an edge. A face of two tetrahedra is added by both and counts once.
template <typename Id>
void RedGreenLimit<Id>::AddSide(Id edge, Id opposite, bool isOfSolid)
{
  SidesOfEdge& sides = this->Sides[edge];
  for (Id& side : sides.Opposites)
  {
    if (side == opposite && isOfSolid)
    {
      return;
    }
    if (side < 0)
    {
      side = opposite;
      return;
    }
  }
  sides.IsBoundary = true; // more than two triangles
}

/// Adds the places at which the inside of a triangle of a surface is measured.
template <typename Id>
void RedGreenLimit<Id>::AddTriangle(const RedGreen<Id>& state, const std::array<Id, 4>& leaf,
  const std::array<Id, 3>& corners, bool isOfSolid)
{
  int green = -1; // the corner opposite to the side that is no edge of the uniform refinement
  std::array<Id, 3> sides;
  for (int i = 0; i < 3; ++i)
  {
    const Id a = corners[(i + 1) % 3];
    const Id b = corners[(i + 2) % 3];
    sides[i] = this->Edges.Find(a, b);
    if (sides[i] >= 0)
    {
      this->AddSide(sides[i], corners[i], isOfSolid);
    }
    green = this->LookAt(state, leaf, a, b).IsUniform ? green : i;
  }
  for (int i = 0; i < 3; ++i)
  {
    const Id a = corners[(i + 1) % 3];
    const Id b = corners[(i + 2) % 3];
    Sample sample;
    sample.Corners = corners;
    sample.Weights.fill(0.25);
    sample.Weights[i] = 0.5;
    sample.Edges = sides;
    if (green < 0)
    {
      sample.Place =
        this->GetMiddle(this->GetMiddle(corners[i], a), this->GetMiddle(corners[i], b));
      this->Samples.push_back(sample);
    }
    else if (green != i && std::find(leaf.begin(), leaf.end(), corners[i]) == leaf.end())
    {
      sample.Place = this->GetMiddle(corners[i], this->GetMiddle(a, b)); // half of a leaf's face
      sample.Edges = { { sides[green], -1, -1 } };
      this->Samples.push_back(sample);
    }
  }
}

template <typename Id>
template <typename Cells>
void RedGreenLimit<Id>::FindSamples(
  const RedGreen<Id>& state, const Cells& cells, int maximumLevel, const RefinementOptions& options)
{
  this->Edges = PairTable<Id>();
  this->NumberOfEdges = 0;
  this->Sides.clear();
  this->FirstMiddle = state.GetNumberOfVertices();
  this->MiddlesByEnds = PairTable<Id>();
  this->Middles.clear();
  this->Samples.clear();
  const bool ofAttribute = options.Attribute && options.AttributeErrorOfLimit;
  for (vtkIdType i = 0; i < cells.GetSize(); ++i)
  {
    const auto points = cells.GetPoints(i);
    if (cells.IsOver(i) || cells.GetSteps(i) >= maximumLevel || points.size() < 2)
    {
      continue;
    }
    const auto leaf = state.GetCell(cells.GetLeaf(i)).Vertices;
    for (auto a = points.begin(); a != points.end(); ++a)
    {
      for (auto b = a + 1; b != points.end(); ++b)
      {
        const auto first = static_cast<Id>(*a);
        const auto second = static_cast<Id>(*b);
        if (ofAttribute || this->IsCurved(Unite(this->Carriers[first], this->Carriers[second])))
        {
          this->AddEdge(this->LookAt(state, leaf, first, second), leaf);
        }
      }
    }
    const auto size = static_cast<int>(points.size());
    for (int opposite = size == 4 ? 0 : 3; options.ReadsShape() && size > 2 && opposite < 4;
      ++opposite)
    {
      std::array<Id, 3> corners;
      auto corner = corners.begin();
      for (int k = 0; k < size; ++k)
      {
        if (k != opposite)
        {
          *corner++ = static_cast<Id>(*(points.begin() + k));
        }
      }
      const Carrier side = Unite(this->Carriers[corners[0]], this->Carriers[corners[1]]);
      if (this->IsCurved(Unite(side, this->Carriers[corners[2]])))
      {
        this->AddTriangle(state, leaf, corners, size == 4);
      }
    }
  }
}

// ------------------------------------------------------------------------------------------------
// Errors

/// Numbers the vertices that places depend on, then the middles. Vertices of the input keep their
/// numbers; `midpoints` gets the ends of the later ones. Returns the new number of each vertex and
/// middle, -1 for those that are not needed.
template <typename Id>
Buffer<Id> RedGreenLimit<Id>::NumberPlaces(
  const RedGreen<Id>& state, std::vector<std::array<Id, 2>>& midpoints) const
{
  const Id given = state.GetNumberOfInputVertices();
  Buffer<Id> numbers(this->FirstMiddle + static_cast<vtkIdType>(this->Middles.size()), Id(-1));
  for (const Sample& sample : this->Samples)
  {
    for (Id corner : sample.Corners)
    {
      if (corner >= 0)
      {
        numbers[corner] = 0;
      }
    }
  }
  for (const auto& ends : this->Middles)
  {
    numbers[ends[0]] = 0;
    numbers[ends[1]] = 0;
  }
  for (Id v = this->FirstMiddle - 1; v >= given; --v)
  {
    if (numbers[v] == 0)
    {
      const auto ends = state.GetEnds(v);
      numbers[ends[0]] = 0;
      numbers[ends[1]] = 0;
    }
  }
  for (const Id v : InTurn(static_cast<Id>(numbers.size())))
  {
    if (v < given)
    {
      numbers[v] = v;
    }
    else if (v >= this->FirstMiddle || numbers[v] == 0)
    {
      numbers[v] = static_cast<Id>(given + midpoints.size());
      const auto ends =
        v < this->FirstMiddle ? state.GetEnds(v) : this->Middles[v - this->FirstMiddle];
      midpoints.push_back({ { numbers[ends[0]], numbers[ends[1]] } });
    }
  }
  return numbers;
}

template <typename Id>
template <typename Cells>
void RedGreenLimit<Id>::FindErrors(const RedGreen<Id>& state, const Cells& cells, int maximumLevel,
  const RefinementOptions& options, const RefinementCriteria& criteria)
{
  this->FindCarriers(state);
  this->FindSamples(state, cells, maximumLevel, options);
  this->Measure(state, options, criteria);
}

/// The geometric error at a place over an edge. A triangle at the edge that is not known did not
/// change in the last round; the edge was measured with it before.
template <typename Id>
double RedGreenLimit<Id>::GetErrorOfEdge(const Sample& sample, const double* const* corners,
  const double* place, const Buffer<double>& limits, const Buffer<Id>& numbers,
  const RefinementCriteria& criteria) const
{
  const SidesOfEdge& sides = this->Sides[sample.Edges[0]];
  if (sides.IsBoundary)
  {
    return criteria.GetGeometricError(corners, 2, place);
  }
  const double* opposites[2] = { nullptr, nullptr };
  int triangles = 0;
  for (const Id opposite : sides.Opposites)
  {
    if (opposite >= 0)
    {
      opposites[triangles++] = limits.data() + 3 * static_cast<vtkIdType>(numbers[opposite]);
    }
  }
  return criteria.GetErrorOverEdge(corners, opposites, triangles, place);
}

template <typename Id>
void RedGreenLimit<Id>::Measure(
  const RedGreen<Id>& state, const RefinementOptions& options, const RefinementCriteria& criteria)
{
  std::vector<std::array<Id, 2>> midpoints;
  const Buffer<Id> numbers = this->NumberPlaces(state, midpoints);
  // Only the limits that samples read are computed: in late rounds those of a part of the mesh.
  Buffer<unsigned char> wanted(
    state.GetNumberOfInputVertices() + static_cast<vtkIdType>(midpoints.size()), 0);
  for (const auto& sample : this->Samples)
  {
    wanted[numbers[sample.Place]] = 1;
    for (Id corner : sample.Corners)
    {
      if (corner >= 0)
      {
        wanted[numbers[corner]] = 1;
      }
    }
  }
  const LocalLimit<Id> limit = this->MakeOperator(midpoints, wanted, nullptr);
  auto getLimits = [&limit](const ContinuedArray& array, const std::vector<double>& control)
  {
    Buffer<double> limits(limit.GetNumberOfRows() * array.GetComponents());
    limit.Apply(
      control.empty() ? array.Get(0) : control.data(), limits.data(), array.GetComponents());
    return limits;
  };
  const bool ofAttribute = options.Attribute && options.AttributeErrorOfLimit;
  const Buffer<double> points = options.ReadsShape()
    ? getLimits(criteria.GetCoordinates(), this->ControlCoordinates)
    : Buffer<double>();
  const Buffer<double> values =
    ofAttribute ? getLimits(criteria.GetAttribute(), this->ControlAttribute) : Buffer<double>();
  Buffer<double> errors(static_cast<vtkIdType>(this->Samples.size()));
  ForEach(errors.size(),
    [&](vtkIdType i)
    {
      const Sample& sample = this->Samples[i];
      const int size = sample.Corners[2] < 0 ? 2 : 3;
      auto gather = [&](const Buffer<double>& of, int components, const double** corners)
      {
        for (int k = 0; k < size; ++k)
        {
          corners[k] = of.data() + static_cast<vtkIdType>(components) * numbers[sample.Corners[k]];
        }
        return of.data() + static_cast<vtkIdType>(components) * numbers[sample.Place];
      };
      const double* corners[3];
      double error = 0.;
      if (options.ReadsShape() &&
        (size == 3 ||
          this->IsCurved(
            Unite(this->Carriers[sample.Corners[0]], this->Carriers[sample.Corners[1]]))))
      {
        const double* place = gather(points, 3, corners);
        if (size == 2 &&
          std::lexicographical_compare(corners[1], corners[1] + 3, corners[0], corners[0] + 3))
        {
          std::swap(corners[0], corners[1]); // whichever cell had the edge first
        }
        error = size == 3 ? criteria.GetGeometricError(corners, size, place)
                          : this->GetErrorOfEdge(sample, corners, place, points, numbers, criteria);
      }
      if (ofAttribute && size == 2)
      {
        const double* place = gather(values, criteria.GetAttribute().GetComponents(), corners);
        const double change =
          criteria.GetAttributeErrorAtLimit(corners, sample.Weights.data(), place);
        error = change < 0. && error <= 1. ? change : std::max(error, change);
      }
      errors[i] = error;
    });
  this->Errors = Buffer<double>(this->NumberOfEdges, 0.);
  for (const vtkIdType i : InTurn(errors.size()))
  {
    for (Id edge : this->Samples[i].Edges)
    {
      if (edge >= 0)
      {
        double& worst = this->Errors[edge];
        // -1 reports a value that is not finite, unless the edge is split anyway.
        const bool isTold = std::min(worst, errors[i]) < 0. && std::max(worst, errors[i]) <= 1.;
        worst = isTold ? -1. : std::max(worst, errors[i]);
      }
    }
  }
}

#define SUBDIVISION_ERRORS(Id, Cells)                                                              \
  template void RedGreenLimit<Id>::FindErrors(const RedGreen<Id>&, const Cells<Id>&, int,          \
    const RefinementOptions&, const RefinementCriteria&)
SUBDIVISION_COMPILE(class RedGreenLimit);
SUBDIVISION_ERRORS(int, InputCandidates);
SUBDIVISION_ERRORS(int, ChangedCandidates);
SUBDIVISION_ERRORS(long long, InputCandidates);
SUBDIVISION_ERRORS(long long, ChangedCandidates);

}
