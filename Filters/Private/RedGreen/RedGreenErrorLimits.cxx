// SPDX-License-Identifier: BSD-3-Clause
// The limits from which RedGreenErrors measures: those on curves and surfaces by polynomials over
// control simplices, all others by values on a lattice.
#include "Private/RedGreen/RedGreenErrors.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/UnevenRanges.h"
#include "Core/Solids/Limits/LatticePlaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace subdivision
{
namespace
{

/// Some vertices of a state, those from which they come, and midpoints behind them, with numbers of
/// their own; those of the control mesh keep theirs.
template <typename Id>
class NeededVertices
{
public:
  using Midpoints = std::vector<std::array<Id, 2>>;

  /// `more`: midpoints of vertices of the state, or of earlier ones of these, which have the
  /// numbers behind those of the state. `wanted` has vertices of both kinds.
  NeededVertices(const RedGreen<Id>& state, const Midpoints& more,
    const std::vector<std::pair<Id, double*>>& wanted)
    : Numbers(state.GetNumberOfVertices(), Id(-1))
  {
    const auto need = [this](Id vertex)
    { vertex < static_cast<Id>(this->Numbers.size()) ? void(this->Numbers[vertex] = 0) : void(); };
    for (const auto& ends : InTurn(more))
    {
      need(ends[0]);
      need(ends[1]);
    }
    for (const auto& [vertex, to] : InTurn(wanted))
    {
      need(vertex);
    }
    const Id given = state.GetNumberOfInputVertices();
    const Id last = state.GetNumberOfVertices() - 1;
    ForEachInTurn(last + 1 - given,
      [&](vtkIdType i)
      {
        const Id vertex = last - static_cast<Id>(i);
        for (const Id end : state.GetEnds(vertex))
        {
          this->Numbers[vertex] == 0 ? need(end) : void();
        }
      });
    for (const Id vertex : InTurn(static_cast<Id>(this->Numbers.size())))
    {
      if (vertex < given)
      {
        this->Numbers[vertex] = vertex;
      }
      else if (this->Numbers[vertex] == 0)
      {
        this->Numbers[vertex] = given + this->Add(state.GetEnds(vertex));
      }
    }
    this->First = given + static_cast<Id>(this->Found.size());
    std::for_each(more.begin(), more.end(), [this](const auto& ends) { this->Add(ends); });
  }

  const Midpoints& GetMidpoints() const { return this->Found; }
  Id GetNumber(Id vertex) const
  {
    const auto size = static_cast<Id>(this->Numbers.size());
    return vertex < size ? this->Numbers[vertex] : this->First + vertex - size;
  }

private:
  Id Add(const std::array<Id, 2>& ends)
  {
    this->Found.push_back({ { this->GetNumber(ends[0]), this->GetNumber(ends[1]) } });
    return static_cast<Id>(this->Found.size()) - 1;
  }

  Buffer<Id> Numbers; ///< -1: not needed
  Midpoints Found;
  Id First = 0; ///< of the midpoints behind those of the state
};

}

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
            const PatchSimplex<Id>& simplex = this->Curved[i];
            if (items.size() > 0 && tree.Start(reader, simplex, control.data()))
            {
              for (const Id item : items)
              {
                this->ForPlacesOf(
                  item, simplex, [&tree](const auto& at, double* limit) { tree.Find(at, limit); });
              }
            }
          }
        });
    });
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

/// Adds the vertex at a place of a site, and vertices between; `vertices`: of the state.
template <typename Id>
Id RedGreenErrors<Id>::AddMidpointAt(const Site& site, int place, Id vertices, Midpoints& midpoints)
{
  const auto add = [&](Id a, Id b)
  {
    midpoints.push_back({ { a, b } });
    return vertices + static_cast<Id>(midpoints.size()) - 1;
  };
  const auto& at = site.Corners;
  if (site.GetSize() == 2)
  {
    const Id middle = add(at[0], at[1]);
    return place == 1 ? middle : add(middle, at[place / 2]);
  }
  const bool isTet = site.GetSize() == 4;
  const Id first = isTet ? add(at[0], at[1]) : add(at[place], at[(place + 1) % 3]);
  return add(first, isTet ? add(at[2], at[3]) : add(at[place], at[(place + 2) % 3]));
}

/// The vertices of which the limit is not known yet, and where it belongs; those at places of sites
/// are added to the midpoints.
template <typename Id>
std::vector<std::pair<Id, double*>> RedGreenErrors<Id>::FindUnknown(
  Id vertices, Midpoints& midpoints)
{
  std::vector<std::pair<Id, double*>> unknown;
  const vtkIdType size = this->Components;
  for (const std::size_t i : InTurn(this->Corners.size()))
  {
    const auto corner = static_cast<vtkIdType>(i);
    if (!this->IsKnown(this->AtVertices, corner))
    {
      unknown.emplace_back(this->Corners[i], this->AtVertices.data() + size * corner);
    }
  }
  for (const Id i : InTurn(static_cast<Id>(this->Sites.size())))
  {
    for (int place = 0; place < PlacesOfSite; ++place)
    {
      if (this->IsUnknown(i, place))
      {
        unknown.emplace_back(AddMidpointAt(this->Sites[i], place, vertices, midpoints),
          this->AtSites.data() + size * (PlacesOfSite * vtkIdType(i) + place));
      }
    }
  }
  return unknown;
}

template <typename Id>
template <typename LevelType>
typename RedGreenErrors<Id>::template LevelLimits<LevelType>& RedGreenErrors<Id>::GetLimitsOf(
  const LevelType& level)
{
  auto& limits = std::get<std::unique_ptr<LevelLimits<LevelType>>>(this->OnLattice);
  if (!limits)
  {
    limits.reset(new LevelLimits<LevelType>{ { level, this->Limit.GetCreases() }, {} });
  }
  return *limits;
}

template <typename Id>
template <typename LevelType>
LatticeValues<LevelType>& RedGreenErrors<Id>::GetValuesOfThread(LevelLimits<LevelType>& limits)
{
  std::shared_ptr<LatticeValues<LevelType>>& values = limits.OfThreads.Local();
  if (!values)
  {
    values = std::make_shared<LatticeValues<LevelType>>(limits.Lattices, this->Components);
  }
  constexpr std::size_t ofNames = 8; // beside the values of a vertex
  if (values->GetSize() * (static_cast<std::size_t>(this->Components) + ofNames) > MostOnLattice)
  {
    values->Clear();
  }
  return *values;
}

/// Finds all limits that are not known yet.
template <typename Id>
void RedGreenErrors<Id>::FindOtherLimits(const RedGreen<Id>& state, const Buffer<double>& control)
{
  Midpoints midpoints;
  const std::vector<std::pair<Id, double*>> unknown =
    this->FindUnknown(state.GetNumberOfVertices(), midpoints);
  if (unknown.empty())
  {
    return;
  }
  const NeededVertices<Id> needed(state, midpoints, unknown);
  this->Limit.WithControl(
    [&](const auto& level)
    {
      LatticePlaces<Id> places(level);
      places.Find(needed.GetMidpoints()); // all lie in cells
      auto& limits = this->GetLimitsOf(level);
      ForUnevenRanges(static_cast<vtkIdType>(unknown.size()),
        [&](vtkIdType begin, vtkIdType end)
        {
          for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
          {
            const Id vertex = needed.GetNumber(unknown[i].first);
            this->GetValuesOfThread(limits).FindLimit(
              places.GetVertex(vertex), places.GetLevel(vertex), control.data(), unknown[i].second);
          }
        });
    });
}

template void RedGreenErrors<int>::FindLimits(const RedGreen<int>&);
template void RedGreenErrors<long long>::FindLimits(const RedGreen<long long>&);

}
