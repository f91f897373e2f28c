// SPDX-License-Identifier: BSD-3-Clause
// The limits from which RedGreenErrors measures: those on curves and surfaces by polynomials over
// control simplices, or by values on a lattice where it is no polynomial, and all others by
// LocalLimit.
#include "Private/RedGreen/RedGreenErrors.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Location/CurveOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace subdivision
{

/// The coordinates and the attribute of the control vertices, as far as they are wanted, side by
/// side.
template <typename Id>
Buffer<double> RedGreenErrors<Id>::GetControlValues() const
{
  vtkIdType size = 0;
  this->Limit.WithControl([&](const auto& level) { size = level.Complex.NumberOfVertices; });
  Buffer<double> values(size * this->Components);
  int first = 0;
  const auto take = [&](const ContinuedArray& array, const std::vector<double>& control)
  {
    const int components = array.GetComponents();
    const double* from = control.empty() ? array.Get(0) : control.data();
    ForEach(size,
      [&, first](vtkIdType v)
      {
        std::copy_n(
          from + components * v, components, values.data() + this->Components * v + first);
      });
    first += components;
  };
  if (size > 0 && this->Options.ReadsShape())
  {
    take(this->Criteria.GetCoordinates(), this->Limit.GetControlCoordinates());
  }
  if (size > 0 && this->OfAttribute)
  {
    take(this->Criteria.GetAttribute(), this->Limit.GetControlAttribute());
  }
  return values;
}

/// Numbers the vertices that are needed (0 in `needed`, -1 for others) and those from which they
/// come. Vertices of the input keep their numbers.
template <typename Id>
typename RedGreenErrors<Id>::Numbering RedGreenErrors<Id>::NumberVertices(
  const RedGreen<Id>& state, Buffer<Id>&& needed) const
{
  const Id given = state.GetNumberOfInputVertices();
  Numbering numbering{ std::move(needed), {} };
  Buffer<Id>& numbers = numbering.Numbers;
  const Id last = state.GetNumberOfVertices() - 1;
  ForEachInTurn(last + 1 - given,
    [&](vtkIdType i)
    {
      const Id v = last - static_cast<Id>(i);
      if (numbers[v] == 0)
      {
        const auto ends = state.GetEnds(v);
        numbers[ends[0]] = 0;
        numbers[ends[1]] = 0;
      }
    });
  for (const Id v : InTurn(static_cast<Id>(numbers.size())))
  {
    if (v < given)
    {
      numbers[v] = v;
    }
    else if (numbers[v] == 0)
    {
      numbers[v] = static_cast<Id>(given + numbering.Midpoints.size());
      const auto ends = state.GetEnds(v);
      numbering.Midpoints.push_back({ { numbers[ends[0]], numbers[ends[1]] } });
    }
  }
  return numbering;
}

template <typename Id>
bool RedGreenErrors<Id>::IsKnown(const Buffer<double>& values, vtkIdType place) const
{
  const double* first = values.data() + this->Components * place;
  return std::none_of(
    first, first + this->Components, [](double value) { return std::isnan(value); });
}

/// Whether a sample asks for the limit at a place of a site, and it was not found yet.
template <typename Id>
bool RedGreenErrors<Id>::IsUnknown(Id site, int place) const
{
  return (this->Sites[site].Used & 1 << place) != 0 &&
    !this->IsKnown(this->AtSites, PlacesOfSite * vtkIdType(site) + place);
}

template <typename Id>
bool RedGreenErrors<Id>::IsKnown(Id site) const
{
  bool isKnown = true;
  for (int place = 0; place < PlacesOfSite; ++place)
  {
    isKnown = isKnown && !this->IsUnknown(site, place);
  }
  return isKnown;
}

template <typename Id>
void RedGreenErrors<Id>::FindLimits(const RedGreen<Id>& state)
{
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  this->NumberOfCorner = Buffer<Id>(state.GetNumberOfVertices(), Id(-1));
  this->Corners.clear();
  for (const Sample& sample : InTurn(this->Samples))
  {
    for (const Id corner : sample.Corners)
    {
      if (corner >= 0 && this->NumberOfCorner[corner] < 0)
      {
        this->NumberOfCorner[corner] = static_cast<Id>(this->Corners.size());
        this->Corners.push_back(corner);
      }
    }
  }
  this->AtVertices =
    Buffer<double>(this->Components * static_cast<vtkIdType>(this->Corners.size()), unknown);
  this->AtSites = Buffer<double>(
    PlacesOfSite * this->Components * static_cast<vtkIdType>(this->Sites.size()), unknown);
  if (this->Samples.empty())
  {
    return;
  }
  const Buffer<double> control = this->GetControlValues();
  if (this->Limit.GetCreases().Stages.empty()) // edges that are sharp for some steps are no curves
  {
    this->FindLimitsOnCurved(control);
  }
  this->FindOtherLimits(state, control);
}

/// Finds the limits on curves and surfaces.
template <typename Id>
void RedGreenErrors<Id>::FindLimitsOnCurved(const Buffer<double>& control)
{
  // The corners and sites on each simplex.
  const auto all = static_cast<vtkIdType>(this->Corners.size() + this->Sites.size());
  subdivision::Rows<Id> on;
  on.Offsets = Buffer<Id>(static_cast<vtkIdType>(this->Curved.size()) + 1, 0);
  ForEachInTurn(all,
    [&](vtkIdType i)
    {
      const Id simplex = this->GetSimplexOf(i);
      simplex < 0 ? void() : void(++on.Offsets[simplex]);
    });
  CountsToOffsets(on.Offsets);
  on.Items = Buffer<Id>(on.Offsets[static_cast<vtkIdType>(this->Curved.size())]);
  Buffer<Id> next(on.Offsets.size());
  CopyInThreads(on.Offsets.data(), on.Offsets.size(), next.data());
  ForEachInTurn(all,
    [&](vtkIdType i)
    {
      const Id simplex = this->GetSimplexOf(i);
      simplex < 0 ? void() : void(on.Items[next[simplex]++] = static_cast<Id>(i));
    });
  this->Limit.WithControl(
    [&](const auto& level)
    {
      const SheetReader<std::decay_t<decltype(level)>> reader(level);
      ForRanges(static_cast<vtkIdType>(this->Curved.size()),
        [&](vtkIdType begin, vtkIdType end)
        {
          PatchTree tree(this->Polynomials.OfThread(level.Strata.Weights), this->Components);
          for (vtkIdType i = begin; i < end; ++i)
          {
            const Row<Id> items = on[static_cast<Id>(i)];
            if (items.size() > 0)
            {
              const PatchSimplex<Id>& simplex = this->Curved[i];
              const bool hasTree = tree.Start(reader, simplex, control.data());
              LatticeValues<Id>& values = this->GetLatticeOfThread(level);
              for (const Id item : items)
              {
                this->ForPlacesOf(item, simplex,
                  [&](const std::array<double, 3>& at, double* limit)
                  {
                    hasTree ? tree.Find(at, limit) : void();
                    std::isnan(*limit) ? FindLimitOnLattice(simplex, at, level.Complex,
                                           control.data(), values, limit)
                                       : void();
                  });
              }
            }
          }
        });
    });
}

template <typename Id>
template <typename LevelType>
LatticeValues<Id>& RedGreenErrors<Id>::GetLatticeOfThread(const LevelType& level)
{
  std::shared_ptr<LatticeValues<Id>>& values = this->OnLattice.Local();
  if (!values)
  {
    values = std::make_shared<LatticeValues<Id>>(level, this->Components);
  }
  constexpr std::size_t ofNames = 8; // beside the values of a vertex
  if (values->GetSize() * (static_cast<std::size_t>(this->Components) + ofNames) > MostOnLattice)
  {
    values->Clear();
  }
  return *values;
}

/// Finds the limit at a place of a simplex, whose corners are in ascending order.
template <typename Id>
void RedGreenErrors<Id>::FindLimitOnLattice(const PatchSimplex<Id>& simplex,
  const std::array<double, 3>& at, const SimplicialComplex<Id>& complex, const double* control,
  LatticeValues<Id>& values, double* limit)
{
  const int dimension = simplex.Corners[1] < 0 ? 0 : simplex.Corners[2] < 0 ? 1 : 2;
  const Id* corners = dimension == 0 ? simplex.Corners.data()
    : dimension == 1                 ? complex.EdgeVertices.data() + 2 * vtkIdType(simplex.Number)
                                     : complex.FaceVertices.data() + 3 * vtkIdType(simplex.Number);
  std::array<double, 3> ordered{};
  for (int k = 0; k <= dimension; ++k)
  {
    const Id* sorted = std::find(simplex.Corners.begin(), simplex.Corners.end(), corners[k]);
    ordered[k] = at[sorted - simplex.Corners.begin()];
  }
  values.FindLimit(dimension, simplex.Number, ordered, control, limit);
}

/// The number of the control simplex on which a corner or, by the numbers that follow, a site lies;
/// -1: inside a solid.
template <typename Id>
Id RedGreenErrors<Id>::GetSimplexOf(vtkIdType item) const
{
  const auto corners = static_cast<vtkIdType>(this->Corners.size());
  if (item < corners)
  {
    return this->Places[this->Corners[item]].Simplex;
  }
  const Site& site = this->Sites[item - corners];
  return site.GetSize() < 4 ? site.Curved : Id(-1);
}

/// act(weights of the corners of the simplex, where the limit belongs) for a corner, or for each
/// place of a site that samples ask for.
template <typename Id>
template <typename Act>
void RedGreenErrors<Id>::ForPlacesOf(
  vtkIdType item, const PatchSimplex<Id>& simplex, const Act& act)
{
  const auto corners = static_cast<vtkIdType>(this->Corners.size());
  if (item < corners)
  {
    act(
      this->Places[this->Corners[item]].Weights, this->AtVertices.data() + this->Components * item);
    return;
  }
  const Site& site = this->Sites[item - corners];
  const int size = site.GetSize();
  std::array<std::array<double, 3>, 3> at{};
  for (int k = 0; k < size; ++k)
  {
    at[k] = this->GetWeights(site.Corners[k], simplex);
  }
  for (int place = 0; place < PlacesOfSite; ++place)
  {
    if ((site.Used & 1 << place) == 0)
    {
      continue;
    }
    // In an edge at a quarter, a half and three quarters, in a face near one of the corners.
    std::array<double, 3> weights;
    for (int i = 0; i < 3; ++i)
    {
      weights[i] = size == 2
        ? 0.25 * ((3 - place) * at[0][i] + (1 + place) * at[1][i])
        : 0.5 * at[place][i] + 0.25 * (at[(place + 1) % 3][i] + at[(place + 2) % 3][i]);
    }
    act(
      weights, this->AtSites.data() + this->Components * (PlacesOfSite * (item - corners) + place));
  }
}

/// The vertex in the middle of an edge between two vertices of a numbering.
template <typename Id>
Id RedGreenErrors<Id>::GetMiddle(Id a, Id b, Numbering& numbering, PairTable<Id>& middles) const
{
  vtkIdType given = 0;
  this->Limit.WithControl([&](const auto& level) { given = level.Complex.NumberOfVertices; });
  const auto next = static_cast<Id>(given + numbering.Midpoints.size());
  const Id middle = middles.FindOrAdd(a, b, next);
  if (middle == next)
  {
    numbering.Midpoints.push_back({ { a, b } });
  }
  return middle;
}

/// The corners and sites of which some limit is not known yet. Neighbours in this list are near
/// each other, so that a part of it depends on a small part of the mesh.
template <typename Id>
std::vector<typename RedGreenErrors<Id>::Unknown> RedGreenErrors<Id>::FindUnknown() const
{
  std::vector<Unknown> unknown;
  for (const Id i : InTurn(static_cast<Id>(this->Corners.size())))
  {
    if (!this->IsKnown(this->AtVertices, i))
    {
      unknown.push_back({ i, true });
    }
  }
  for (const Id i : InTurn(static_cast<Id>(this->Sites.size())))
  {
    if (!this->IsKnown(i))
    {
      unknown.push_back({ i, false });
    }
  }
  const ContinuedArray& points = this->Criteria.GetCoordinates();
  const auto getPoint = [&](const Unknown& of)
  {
    const Id vertex = of.IsCorner ? this->Corners[of.Number] : this->Sites[of.Number].Corners[0];
    return points.Get(this->Carriers[vertex][0]);
  };
  Box box;
  for (const Unknown& of : InTurn(unknown))
  {
    box.Add(getPoint(of));
  }
  const Buffer<vtkIdType> order = SortAlongCurve(static_cast<vtkIdType>(unknown.size()), box,
    [&](vtkIdType i, double* x) { std::copy_n(getPoint(unknown[i]), 3, x); });
  std::vector<Unknown> sorted(unknown.size());
  ForEach(order.size(), [&](vtkIdType i) { sorted[i] = unknown[order[i]]; });
  return sorted;
}

/// Finds all limits that are not known yet, a batch at a time: rows to the places of an edge take
/// some 15 KB.
template <typename Id>
void RedGreenErrors<Id>::FindOtherLimits(const RedGreen<Id>& state, const Buffer<double>& control)
{
  const std::vector<Unknown> unknown = this->FindUnknown();
  const std::size_t most = std::max(LimitBatches::Least, unknown.size() / LimitBatches::Most + 1);
  for (std::size_t begin = 0; begin < unknown.size(); begin += most)
  {
    const Unknown* first = unknown.data() + begin;
    this->FindLimitsOf({ first, first + std::min(most, unknown.size() - begin) }, state, control);
  }
}

/// The vertex at a place of a site whose corners have the numbers `at`.
template <typename Id>
Id RedGreenErrors<Id>::GetVertexAt(const Site& site, int place, const std::array<Id, 4>& at,
  Numbering& numbering, PairTable<Id>& middles) const
{
  const auto getMiddle = [&](Id a, Id b) { return this->GetMiddle(a, b, numbering, middles); };
  if (site.GetSize() == 2)
  {
    const Id middle = getMiddle(at[0], at[1]);
    return place == 1 ? middle : getMiddle(middle, at[place / 2]);
  }
  if (site.GetSize() == 3)
  {
    const Id first = getMiddle(at[place], at[(place + 1) % 3]);
    return getMiddle(first, getMiddle(at[place], at[(place + 2) % 3]));
  }
  const Id first = getMiddle(at[0], at[1]);
  return getMiddle(first, getMiddle(at[2], at[3]));
}

template <typename Id>
void RedGreenErrors<Id>::FindLimitsOf(
  const Row<Unknown>& batch, const RedGreen<Id>& state, const Buffer<double>& control)
{
  Buffer<Id> needed(state.GetNumberOfVertices(), Id(-1));
  bool isCurved = true;
  for (const Unknown& of : InTurn(batch))
  {
    if (of.IsCorner)
    {
      needed[this->Corners[of.Number]] = 0;
      isCurved = isCurved && this->IsOnCurve(this->Corners[of.Number]);
      continue;
    }
    const Site& site = this->Sites[of.Number];
    isCurved = isCurved && site.Curved >= 0;
    for (int k = 0; k < site.GetSize(); ++k)
    {
      needed[site.Corners[k]] = 0;
    }
  }
  Numbering numbering = this->NumberVertices(state, std::move(needed));
  PairTable<Id> middles;
  std::vector<std::pair<Id, double*>> found; // vertices, and where their limits belong
  const vtkIdType size = this->Components;
  for (const Unknown& of : InTurn(batch))
  {
    if (of.IsCorner)
    {
      found.emplace_back(
        numbering.Numbers[this->Corners[of.Number]], this->AtVertices.data() + size * of.Number);
      continue;
    }
    const Site& site = this->Sites[of.Number];
    std::array<Id, 4> at{};
    for (int k = 0; k < site.GetSize(); ++k)
    {
      at[k] = numbering.Numbers[site.Corners[k]];
    }
    for (int place = 0; place < PlacesOfSite; ++place)
    {
      if (this->IsUnknown(of.Number, place))
      {
        found.emplace_back(this->GetVertexAt(site, place, at, numbering, middles),
          this->AtSites.data() + size * (PlacesOfSite * vtkIdType(of.Number) + place));
      }
    }
  }
  Buffer<unsigned char> wanted(
    state.GetNumberOfInputVertices() + static_cast<vtkIdType>(numbering.Midpoints.size()), 0);
  for (const auto& [vertex, to] : found)
  {
    wanted[vertex] = 1;
  }
  const LocalLimit<Id> limit =
    this->Limit.MakeOperator(numbering.Midpoints, wanted, nullptr, isCurved && !this->OfAttribute);
  Buffer<double> limits(limit.GetNumberOfRows() * size);
  limit.Apply(control.data(), limits.data(), this->Components);
  for (const auto& [vertex, to] : found)
  {
    std::copy_n(limits.data() + size * vertex, size, to);
  }
}

template void RedGreenErrors<int>::FindLimits(const RedGreen<int>&);
template void RedGreenErrors<long long>::FindLimits(const RedGreen<long long>&);

}
