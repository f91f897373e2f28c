// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/SharpLattice.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Solids/Limits/LatticeLimit.h"

namespace subdivision
{

template <typename Id>
SharpSimplices<Id>::SharpSimplices(const SimplicialComplex<Id>& complex,
  const subdivision::Strata<Id>& strata, const SemiSharpStages<Id>& creases)
  : Creases(creases)
  , NumberOfVertices(complex.NumberOfVertices)
  , Parts(creases.ListParts(complex))
{
  const std::vector<SharpRow> rows = this->Parts.GetRows();
  if (rows.empty() || creases.Stages.empty())
  {
    return;
  }
  this->Flags = { { Buffer<unsigned char>(complex.NumberOfVertices, 0),
    Buffer<unsigned char>(complex.NumberOfEdges, 0),
    Buffer<unsigned char>(complex.NumberOfFaces, 0) } };
  for (const SharpRow& row : InTurn(rows))
  {
    const vtkIdType edge = row.Row - this->NumberOfVertices;
    edge < 0 ? this->Flags[0][row.Row] = 1 : this->Flags[1][edge] = 1;
  }
  for (const vtkIdType face : InTurn(creases.FaceSharpness.size()))
  {
    this->Flags[2][face] = creases.FaceSharpness[face] > 0. ? 1 : 0;
  }
  const auto addSectors = [&](const std::vector<SectorEdge<Id>>& sectors)
  {
    for (const SectorEdge<Id>& sector : sectors)
    {
      const Id* ends = complex.EdgeVertices.data() + 2 * vtkIdType(sector.Edge);
      this->Flags[1][sector.Edge] |= this->Flags[0][ends[0]] | this->Flags[0][ends[1]];
    }
  };
  addSectors(strata.Sectors);
  for (const SharpStage<Id>& stage : creases.Stages)
  {
    addSectors(stage.Strata.Sectors);
  }
}

/// The weight of the sharp row in a step (SemiSharp.h, SharpSectors.h).
template <typename Id, typename Lattice>
double SharpLattice<Id, Lattice>::GetWeight(const LatticeVertex<Id>& vertex, int step) const
{
  const double own = this->Sharp.GetSharpness(vertex.Dimension, vertex.Simplex, step);
  const LatticeWeights& weights = vertex.Weights;
  if (own > 0. || vertex.Dimension != 1 || weights[0] % 2 == 0)
  {
    return std::min(1., own);
  }
  // The ends, if they are control vertices, of the edge in whose middle the vertex is.
  const std::array<bool, 2> isControl{ { weights[1] == 1, weights[0] == 1 } };
  const auto isAtSector = [&](const std::vector<SectorEdge<Id>>& sectors)
  {
    const auto ofEdge = FindSectorEdges(sectors, vertex.Simplex);
    return std::any_of(ofEdge.begin(), ofEdge.end(),
      [&](const SectorEdge<Id>& sector) { return isControl[sector.End]; });
  };
  if (!isAtSector(*this->Sectors[0]) && !isAtSector(*this->Sectors[1 + this->FindStage(step)]))
  {
    return 0.;
  }
  const int ends[2] = { 0, 1 };
  const Id* corners = this->Complex.EdgeVertices.data() + 2 * vtkIdType(vertex.Simplex);
  return std::min(1.,
    GetMeanOfEnds(ends, [&](int end)
      { return isControl[end] ? this->Sharp.GetSharpness(0, corners[end], step) : 0.; }));
}

template <typename Id, typename Lattice>
bool SharpLattice<Id, Lattice>::ReadBlend(
  const LatticeVertex<Id>& vertex, int step, LatticeRow<Id>& row) const
{
  const double weight = this->GetWeight(vertex, step);
  if (weight <= 0.)
  {
    return this->Smooth.ReadRow(vertex, row);
  }
  bool isKnown = this->OfStages[this->FindStage(step)].ReadRow(vertex, row);
  if (isKnown && weight < 1.)
  {
    Sum sum;
    AddTo(sum, weight, row);
    isKnown = this->Smooth.ReadRow(vertex, row);
    AddTo(sum, 1. - weight, row);
    Write(sum, row);
  }
  return isKnown;
}

template <typename Id, typename Lattice>
bool SharpLattice<Id, Lattice>::StepBack(LatticeRow<Id>& row) const
{
  LatticeRow<Id> own;
  Sum sum;
  bool isKnown = true;
  for (std::size_t i = 0; isKnown && i < row.Vertices.size(); ++i)
  {
    isKnown = this->ReadRow(row.Vertices[i], own);
    AddTo(sum, row.Weights[i], own);
  }
  Write(sum, row);
  return isKnown;
}

template <typename Id, typename Lattice>
bool SharpLattice<Id, Lattice>::ReadSharpLimit(
  const LatticeVertex<Id>& vertex, int steps, LatticeRow<Id>& row)
{
  LatticeStar<Id> star;
  bool isKnown = this->Smooth.AddStar(vertex, star) && this->Smooth.ReadLimit(vertex, row);
  for (std::size_t stage = this->FindStage(CountLevels(vertex)); stage < this->OfStages.size();
    ++stage)
  {
    isKnown = isKnown && this->OfStages[stage].AddStar(vertex, star);
  }
  return isKnown && this->GoBack(star, steps, row);
}

template <typename Id, typename Lattice>
bool SharpLattice<Id, Lattice>::ReadStar(const LatticeStar<Id>& star, std::size_t size,
  const std::vector<std::array<int, 2>>& corners, int made, std::vector<LatticeRow<Id>>& rows)
{
  const LatticeVertex<Id>& vertex = star.Items[0];
  const double most = this->GetSharpnessLeft(vertex);
  const int steps = most > 0.
    ? std::min(static_cast<int>(std::ceil(most)), std::max(1, MostStepsOfStars - made))
    : 0;
  // On curves inside a face the rules of its edges depend on which weights are odd.
  Neighbourhood key{ vertex.Dimension, made + steps };
  AppendId(vertex.Simplex, key);
  for (const long long weight : vertex.Weights)
  {
    key.push_back(vertex.Dimension == 2 ? static_cast<int>(weight % 2) : 0);
  }
  const std::size_t items = star.Items.size();
  const std::vector<double>* found = this->Stars.Find(key,
    [&](std::vector<double>& solved)
    {
      SolvedRows local;
      const bool isKnown = ReadStarRows(this->Smooth, star, local);
      solved = isKnown ? FindStarRows(ReadLocalRows(local, Neighbourhood(), items).Fill(), items,
                           corners, made + steps)
                       : solved;
      return isKnown;
    });
  if (!found)
  {
    return false;
  }
  const double* weights = found->data();
  rows.resize(size);
  bool isKnown = true;
  for (std::size_t i = 0; isKnown && i < size; ++i, weights += items)
  {
    rows[i].Clear();
    for (std::size_t k = 0; k < items; ++k)
    {
      weights[k] != 0. ? rows[i].Add(star.Items[k], weights[k]) : void();
    }
    isKnown = this->GoBack(star, steps, rows[i]);
  }
  return isKnown;
}

/// Goes back over the steps in which something around a vertex is still sharp. All levels look the
/// same there, so that the rows of later steps are those of the next one, with another sharpness.
/// There may be more of these than levels that a vertex has a name on.
template <typename Id, typename Lattice>
bool SharpLattice<Id, Lattice>::GoBack(
  const LatticeStar<Id>& star, int steps, LatticeRow<Id>& row) const
{
  if (steps <= 0)
  {
    return true;
  }
  const int level = CountLevels(star.Items[0]);
  Sum items; // numbers them; the weights mean nothing
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < star.Items.size(); ++i)
  {
    items.GetNumber(star.Items[i]) == places.size() ? places.push_back(i) : void();
  }
  Sum sum;
  AddTo(sum, 1., row);
  bool isKnown = true;
  for (int step = level + steps - 1; isKnown && step >= level; --step)
  {
    Sum before;
    for (std::size_t i = 0; isKnown && i < sum.Vertices.size(); ++i)
    {
      const std::ptrdiff_t number = items.Find(sum.Vertices[i]);
      isKnown = number >= 0 &&
        this->ReadBlend(star.Next[places[static_cast<std::size_t>(number)]], step, row);
      AddTo(before, sum.OfVertices[i][0], row);
    }
    std::swap(sum, before);
  }
  Write(sum, row);
  return isKnown;
}

SUBDIVISION_COMPILE(class SharpSimplices);
template class SharpLattice<int, BoxSplineLattice<int>>;
template class SharpLattice<long long, BoxSplineLattice<long long>>;
template class SharpLattice<int, TetOctLattice<int>>;
template class SharpLattice<long long, TetOctLattice<long long>>;

}
