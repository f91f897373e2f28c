// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenErrors.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace subdivision
{

template <typename Id>
RedGreenErrors<Id>::RedGreenErrors(const RedGreenLimit<Id>& limit, const RefinementOptions& options,
  const RefinementCriteria& criteria)
  : Limit(limit)
  , Options(options)
  , Criteria(criteria)
  , OfAttribute(options.Attribute && options.AttributeErrorOfLimit)
  , Components(
      (options.ReadsShape() ? 3 : 0) + (OfAttribute ? criteria.GetAttribute().GetComponents() : 0))
{
  limit.WithControl([this](const auto& level) { this->FindCurved(level.Complex, level.Strata); });
}

template <typename Id>
template <typename Cells>
void RedGreenErrors<Id>::Find(const RedGreen<Id>& state, const Cells& cells)
{
  this->FindCarriers(state);
  this->FindSamples(state, cells);
  this->FindLimits(state);
  this->TakeErrors();
}

// ------------------------------------------------------------------------------------------------
// Where vertices lie

template <typename Id>
void RedGreenErrors<Id>::FindCurved(const SimplicialComplex<Id>& complex, const Strata<Id>& strata)
{
  for (const Id e : InTurn(complex.NumberOfEdges))
  {
    const Rule rule = strata.Edges[e].GetRule();
    if (rule != Rule::Solid && rule != Rule::RegularEdge)
    {
      const Id* ends = complex.EdgeVertices.data() + 2 * static_cast<vtkIdType>(e);
      this->Curved.push_back(
        { { { std::min(ends[0], ends[1]), std::max(ends[0], ends[1]), -1 } }, e });
    }
  }
  for (const Id f : InTurn(complex.NumberOfFaces))
  {
    if (strata.Faces[f].GetRule() != Rule::Solid)
    {
      const Id* corners = complex.FaceVertices.data() + 3 * static_cast<vtkIdType>(f);
      PatchSimplex<Id> face{ { { corners[0], corners[1], corners[2] } }, f };
      std::sort(face.Corners.begin(), face.Corners.end());
      this->Curved.push_back(face);
    }
  }
  StableSort(this->Curved,
    [](const PatchSimplex<Id>& a, const PatchSimplex<Id>& b) { return a.Corners < b.Corners; });
  this->FirstCurved = Buffer<vtkIdType>(complex.NumberOfVertices + vtkIdType(1), 0);
  for (const PatchSimplex<Id>& simplex : InTurn(this->Curved))
  {
    ++this->FirstCurved[simplex.Corners[0]];
  }
  CountsToOffsets(this->FirstCurved);
  for (const Id v : InTurn(complex.NumberOfVertices))
  {
    this->Curved.push_back({ { { v, -1, -1 } }, v });
  }
}

template <typename Id>
void RedGreenErrors<Id>::FindCarriers(const RedGreen<Id>& state)
{
  const auto first = static_cast<Id>(this->Carriers.size());
  this->Carriers.resize(state.GetNumberOfVertices());
  this->Places.resize(state.GetNumberOfVertices());
  this->MayBeCurved.resize(state.GetNumberOfVertices(), 1);
  ForEachInTurn(state.GetNumberOfVertices() - first,
    [&](vtkIdType i)
    {
      const auto vertex = static_cast<Id>(first + i);
      Carrier& carrier = this->Carriers[vertex];
      if (vertex < state.GetNumberOfInputVertices())
      {
        carrier = { { vertex, -1, -1, -1 } };
        this->Places[vertex] = { static_cast<Id>(
                                   this->FirstCurved[state.GetNumberOfInputVertices()] + vertex),
          { { 1., 0., 0. } } };
        return;
      }
      const auto ends = state.GetEnds(vertex);
      carrier = Unite(this->Carriers[ends[0]], this->Carriers[ends[1]]);
      PlaceOfVertex& place = this->Places[vertex];
      place.Simplex = this->FindNumber(carrier);
      this->MayBeCurved[vertex] = carrier[2] < 0 || place.Simplex >= 0 ? 1 : 0;
      if (place.Simplex >= 0)
      {
        const auto a = this->GetWeights(ends[0], this->Curved[place.Simplex]);
        const auto b = this->GetWeights(ends[1], this->Curved[place.Simplex]);
        for (int k = 0; k < 3; ++k)
        {
          place.Weights[k] = 0.5 * (a[k] + b[k]);
        }
      }
    });
}

/// The weights of the corners of a simplex on which a vertex lies, or at whose faces. They are not
/// numbers where these are not exact.
template <typename Id>
std::array<double, 3> RedGreenErrors<Id>::GetWeights(
  Id vertex, const PatchSimplex<Id>& simplex) const
{
  constexpr double least = 1. / (std::int64_t(1) << 48);
  const Carrier& carrier = this->Carriers[vertex];
  std::array<double, 3> weights{};
  for (int i = 0, k = 0; i < 3 && carrier[i] >= 0; ++i, ++k)
  {
    while (simplex.Corners[k] != carrier[i])
    {
      ++k;
    }
    weights[k] = this->Places[vertex].Weights[i];
    if (weights[k] < least)
    {
      weights.fill(std::numeric_limits<double>::quiet_NaN());
      break;
    }
  }
  return weights;
}

template <typename Id>
typename RedGreenErrors<Id>::Carrier RedGreenErrors<Id>::Unite(const Carrier& a, const Carrier& b)
{
  Carrier both = { { -1, -1, -1, -1 } };
  auto isEnd = [](Id vertex) { return vertex < 0; };
  std::set_union(a.begin(), std::find_if(a.begin(), a.end(), isEnd), b.begin(),
    std::find_if(b.begin(), b.end(), isEnd), both.begin()); // both lie in one simplex
  return both;
}

/// The number of a control edge or face whose limit is a curve, a surface, or a boundary, joint or
/// singular surface of a solid; else -1.
template <typename Id>
Id RedGreenErrors<Id>::FindNumber(const Carrier& carrier) const
{
  if (carrier[3] >= 0)
  {
    return -1;
  }
  const std::array<Id, 3> corners{ { carrier[0], carrier[1], carrier[2] } };
  const auto last = this->Curved.begin() + this->FirstCurved[carrier[0] + vtkIdType(1)];
  const auto found = std::lower_bound(this->Curved.begin() + this->FirstCurved[carrier[0]], last,
    corners, [](const PatchSimplex<Id>& simplex, const std::array<Id, 3>& wanted)
    { return simplex.Corners < wanted; });
  return found == last || found->Corners != corners ? Id(-1)
                                                    : static_cast<Id>(found - this->Curved.begin());
}

// ------------------------------------------------------------------------------------------------
// Where to look

template <typename Id>
typename RedGreenErrors<Id>::EdgeOfCell RedGreenErrors<Id>::LookAt(
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

/// Adds a sample at a place of the last site.
template <typename Id>
void RedGreenErrors<Id>::AddSample(int place, const std::array<Id, 3>& corners,
  const std::array<Id, 3>& edges, double weight, bool ofShape)
{
  this->Sites.back().Used |= static_cast<unsigned char>(1 << place);
  this->Samples.push_back({ static_cast<Id>(this->Sites.size()) - 1, place, corners, edges, weight,
    ofShape && this->Options.ReadsShape() });
}

/// Adds the places at which an edge is measured: three on an edge of the uniform refinement, so
/// that a curve is noticed that crosses the edge in its middle; on any other edge its middle.
template <typename Id>
void RedGreenErrors<Id>::AddEdge(const EdgeOfCell& edge, const std::array<Id, 4>& leaf, Id curved)
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
  const auto add = [&](int place, double weight)
  { this->AddSample(place, { { a, b, -1 } }, { { number, -1, -1 } }, weight, curved >= 0); };
  if (edge.IsUniform)
  {
    this->Sites.push_back({ { { a, b, -1, -1 } }, curved });
    add(0, 0.25);
    add(1, 0.5);
    add(2, 0.75);
    return;
  }
  const bool isFromCorner = edge.Of[0][0] == edge.Of[0][1];
  const bool isToCorner = edge.Of[1][0] == edge.Of[1][1];
  if (isFromCorner || isToCorner)
  {
    const auto& split = edge.Of[isFromCorner ? 1 : 0];
    this->Sites.push_back({ { { isFromCorner ? a : b, split[0], split[1], -1 } }, curved });
  }
  else // between midpoints of opposite edges: in the middle of the leaf, like the diagonal
  {
    this->Sites.push_back({ { { leaf[0], leaf[2], leaf[1], leaf[3] } }, curved });
  }
  add(0, 0.5);
}

/// Adds a triangle to an edge. A face of two tetrahedra is added by both and counts once.
template <typename Id>
void RedGreenErrors<Id>::AddSide(Id edge, Id opposite, bool isOfSolid)
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
void RedGreenErrors<Id>::AddTriangle(const RedGreen<Id>& state, const std::array<Id, 4>& leaf,
  const std::array<Id, 3>& corners, Id curved, bool isOfSolid)
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
    green = LookAt(state, leaf, a, b).IsUniform ? green : i;
  }
  if (green < 0)
  {
    this->Sites.push_back({ { { corners[0], corners[1], corners[2], -1 } }, curved });
    for (int i = 0; i < 3; ++i)
    {
      this->AddSample(i, corners, sides, 0., true);
    }
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    if (green != i && std::find(leaf.begin(), leaf.end(), corners[i]) == leaf.end())
    {
      // The corner is a midpoint, and the triangle half of a leaf's face.
      const auto ends = state.GetEnds(corners[i]);
      Id near = corners[(i + 1) % 3];
      Id beside = corners[(i + 2) % 3];
      if (near != ends[0] && near != ends[1])
      {
        std::swap(near, beside);
      }
      this->Sites.push_back(
        { { { near, ends[0] == near ? ends[1] : ends[0], beside, -1 } }, curved });
      this->AddSample(0, corners, { { sides[green], -1, -1 } }, 0., true);
    }
  }
}

template <typename Id>
template <typename Cells>
void RedGreenErrors<Id>::FindSamples(const RedGreen<Id>& state, const Cells& cells)
{
  this->Edges = PairTable<Id>();
  this->NumberOfEdges = 0;
  this->Sides.clear();
  this->Sites.clear();
  this->Samples.clear();
  ForEachInTurn(cells.GetSize(),
    [&](vtkIdType i)
    {
      const auto points = cells.GetPoints(i);
      const auto size = static_cast<int>(points.size());
      const auto candidates = std::count_if(
        points.begin(), points.end(), [this](auto point) { return this->MayBeCurved[point]; });
      if (size < 2 || (candidates < 2 && !this->OfAttribute) || cells.IsOver(i) ||
        cells.GetSteps(i) >= this->Options.MaximumLevel)
      {
        return;
      }
      const auto leaf = state.GetCell(cells.GetLeaf(i)).Vertices;
      for (auto a = points.begin(); a != points.end(); ++a)
      {
        for (auto b = a + 1; b != points.end(); ++b)
        {
          const auto first = static_cast<Id>(*a);
          const auto second = static_cast<Id>(*b);
          const Id curved = this->FindNumber(first, second);
          if (curved >= 0 || this->OfAttribute)
          {
            this->AddEdge(LookAt(state, leaf, first, second), leaf, curved);
          }
        }
      }
      for (int opposite = size == 4 ? 0 : 3;
        this->Options.ReadsShape() && candidates > 2 && opposite < 4; ++opposite)
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
        const auto mayBe = [this](Id vertex) { return this->MayBeCurved[vertex] != 0; };
        const Id curved = std::all_of(corners.begin(), corners.end(), mayBe)
          ? this->FindNumber(Unite(Unite(this->Carriers[corners[0]], this->Carriers[corners[1]]),
              this->Carriers[corners[2]]))
          : Id(-1);
        if (curved >= 0)
        {
          this->AddTriangle(state, leaf, corners, curved, size == 4);
        }
      }
    });
}

// ------------------------------------------------------------------------------------------------
// Errors

/// The geometric error at a place over an edge. A triangle at the edge that is not known did not
/// change in the last round; the edge was measured with it before.
template <typename Id>
double RedGreenErrors<Id>::GetErrorOfEdge(
  const Sample& sample, const double* const* corners, const double* place) const
{
  const SidesOfEdge& sides = this->Sides[sample.Edges[0]];
  if (sides.IsBoundary)
  {
    return this->Criteria.GetGeometricError(corners, 2, place);
  }
  const double* opposites[2] = { nullptr, nullptr };
  int triangles = 0;
  for (const Id opposite : sides.Opposites)
  {
    if (opposite >= 0)
    {
      opposites[triangles++] = this->AtCorner(opposite);
    }
  }
  return this->Criteria.GetErrorOverEdge(corners, opposites, triangles, place);
}

template <typename Id>
double RedGreenErrors<Id>::Measure(const Sample& sample) const
{
  const int size = sample.Corners[2] < 0 ? 2 : 3;
  const double* place = this->AtSites.data() +
    this->Components * (PlacesOfSite * vtkIdType(sample.Site) + sample.Place);
  const double* corners[3];
  for (int k = 0; k < size; ++k)
  {
    corners[k] = this->AtCorner(sample.Corners[k]);
  }
  double error = 0.;
  if (sample.OfShape && size == 3)
  {
    error = this->Criteria.GetGeometricError(corners, size, place);
  }
  else if (sample.OfShape)
  {
    const double* ends[2] = { corners[0], corners[1] };
    if (std::lexicographical_compare(ends[1], ends[1] + 3, ends[0], ends[0] + 3))
    {
      std::swap(ends[0], ends[1]); // whichever cell had the edge first
    }
    error = this->GetErrorOfEdge(sample, ends, place);
  }
  if (this->OfAttribute && size == 2)
  {
    const int first = this->Options.ReadsShape() ? 3 : 0;
    const double* values[2] = { corners[0] + first, corners[1] + first };
    const double weights[2] = { 1. - sample.Weight, sample.Weight };
    const double change = this->Criteria.GetAttributeErrorAtLimit(values, weights, place + first);
    error = change < 0. && error <= 1. ? change : std::max(error, change);
  }
  return error;
}

template <typename Id>
void RedGreenErrors<Id>::TakeErrors()
{
  Buffer<double> errors(static_cast<vtkIdType>(this->Samples.size()));
  ForEach(errors.size(), [&](vtkIdType i) { errors[i] = this->Measure(this->Samples[i]); });
  this->Errors = Buffer<double>(this->NumberOfEdges, 0.);
  for (const vtkIdType i : InTurn(errors.size()))
  {
    for (const Id edge : this->Samples[i].Edges)
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
  template void RedGreenErrors<Id>::Find(const RedGreen<Id>&, const Cells<Id>&)
SUBDIVISION_COMPILE(class RedGreenErrors);
SUBDIVISION_ERRORS(int, InputCandidates);
SUBDIVISION_ERRORS(int, ChangedCandidates);
SUBDIVISION_ERRORS(long long, InputCandidates);
SUBDIVISION_ERRORS(long long, ChangedCandidates);

}
