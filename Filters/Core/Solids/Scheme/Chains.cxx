// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/Chains.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"

#include <algorithm>
#include <vector>

namespace subdivision
{
namespace
{

/// Makes chains block by block.
template <typename Id>
class ChainMaker
{
public:
  ChainMaker(const SimplicialComplex<Id>& complex, const Strata<Id>& strata, const RingMasks& masks,
    int steps, const ChainOperator::ChainUser& use)
    : Complex(complex)
    , OfLevel(strata)
    , Masks(masks)
    , Steps(steps)
    , Use(use)
  {
  }

  /// The rows of those vertices that are not inside a run of edges.
  void AtVertices(vtkIdType begin, vtkIdType end)
  {
    this->Clear();
    for (vtkIdType v = begin; v < end; ++v)
    {
      if (!this->IsInside(v))
      {
        this->AddStar(static_cast<Id>(v));
      }
    }
    if (!this->Vertices.empty())
    {
      this->UseBlock();
    }
  }

  /// The rows of the points on edges, and of the vertices between them.
  void AlongEdges(vtkIdType begin, vtkIdType end)
  {
    this->Clear();
    for (vtkIdType first = begin; first < end;)
    {
      vtkIdType last = first;
      bool joins = this->JoinsNext(last);
      while (joins && last + 1 < end)
      {
        joins = this->JoinsNext(++last);
      }
      this->AddStar(this->Complex.EdgeVertices[2 * first]);
      this->AddStar(this->Complex.EdgeVertices[2 * last + 1]);
      this->Runs.push_back({ first, last + 1 - first, joins });
      first = last + 1;
    }
    this->UseBlock();
  }

private:
  /// Whether an edge ends at a vertex where the next one starts, and both together are what the
  /// rule of curves takes there, in this order.
  bool AreJoinedAt(vtkIdType vertex, vtkIdType edge) const
  {
    const Row<Id> ring = this->OfLevel.VertexRings.GetCarriers(vertex);
    const Id* ends = this->Complex.EdgeVertices.data() + 2 * edge;
    return ring.size() == 2 && ring.begin()[0] == edge && ring.begin()[1] == edge + 1 &&
      ends[1] == vertex && ends[2] == vertex &&
      this->OfLevel.Vertices[vertex].GetRule() == Rule::Curve;
  }
  bool JoinsNext(vtkIdType edge) const
  {
    return this->AreJoinedAt(this->Complex.EdgeVertices[2 * edge + 1], edge);
  }
  /// Whether two edges are joined at a vertex.
  bool IsInside(vtkIdType vertex) const
  {
    const Row<Id> ring = this->OfLevel.VertexRings.GetCarriers(vertex);
    return ring.size() == 2 && this->AreJoinedAt(vertex, ring.begin()[0]);
  }

  void Clear()
  {
    this->Vertices.clear();
    this->Strata.clear();
    this->Members.clear();
    this->Offsets.assign(1, 0);
    this->Runs.clear();
  }
  void AddStar(Id vertex)
  {
    const Row<Id> ring = this->OfLevel.VertexRings.GetMembers(vertex);
    this->Vertices.push_back(vertex);
    this->Strata.push_back(this->OfLevel.Vertices[vertex]);
    this->Members.insert(this->Members.end(), ring.begin(), ring.end());
    this->Offsets.push_back(static_cast<Id>(this->Members.size()));
  }

  void UseBlock()
  {
    const auto centres = static_cast<Id>(this->Vertices.size());
    const auto spokes = static_cast<Id>(this->Members.size());
    this->Columns = this->Vertices;
    this->Columns.insert(this->Columns.end(), this->Members.begin(), this->Members.end());
    this->Places.resize(this->Members.size());
    this->Ends.resize(2 * this->Members.size());
    for (Id centre = 0; centre < centres; ++centre)
    {
      for (Id i = this->Offsets[centre]; i < this->Offsets[centre + 1]; ++i)
      {
        this->Places[i] = this->Ends[2 * i + 1] = centres + i;
        this->Ends[2 * i] = centre;
      }
    }
    this->OfSpokes.resize(this->Members.size(), Stratum(Rule::Curve));
    this->NoOffsets.resize(this->Members.size() + 1, 0);
    ChainRows<Id> rows;
    rows.Steps = this->Steps;
    rows.NumberOfVertices = this->Complex.NumberOfVertices;
    rows.NumberOfEdges = this->Complex.NumberOfEdges;
    rows.Ends = this->Complex.EdgeVertices.data();
    rows.Runs = this->Runs.data();
    rows.NumberOfRuns = static_cast<vtkIdType>(this->Runs.size());
    rows.StepsOfStars = this->NeedsLast() ? this->Steps : this->Steps - 1;
    rows.Centres = { &this->Masks, false, 0, centres, this->Strata.data(), nullptr,
      this->Offsets.data(), this->Places.data() };
    rows.Spokes = { &this->Masks, true, centres, spokes, this->OfSpokes.data(), this->Ends.data(),
      this->NoOffsets.data(), nullptr };
    rows.Columns = this->Columns.data();
    this->Use(rows);
  }
  /// Whether some row is that of a centre.
  bool NeedsLast() const
  {
    return this->Runs.empty() ||
      std::any_of(
        this->Runs.begin(), this->Runs.end(), [](const EdgeRun& run) { return run.HasEnd; });
  }

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& OfLevel;
  const RingMasks& Masks;
  const int Steps;
  const ChainOperator::ChainUser& Use;
  // The block.
  std::vector<EdgeRun> Runs;
  std::vector<Id> Vertices; ///< the centres of stars
  std::vector<Stratum> Strata;
  std::vector<Id> Members; ///< of their rings
  std::vector<Id> Offsets;
  std::vector<Id> Columns;
  std::vector<Id> Places; ///< of the members in Columns
  std::vector<Id> Ends;   ///< of spokes
  std::vector<Stratum> OfSpokes;
  std::vector<Id> NoOffsets;
};

}

template <typename Id>
void Chains<Id>::ForEachChains(const ChainUser& use) const
{
  ForKinds<2>({ this->Complex.NumberOfVertices, this->Complex.NumberOfEdges },
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      ChainMaker<Id> maker(this->Complex, this->Strata, this->Masks, this->Steps, use);
      ForBlocks(
        first, last, [&](vtkIdType begin, vtkIdType end)
        { kind == 0 ? maker.AtVertices(begin, end) : maker.AlongEdges(begin, end); },
        std::max<vtkIdType>(1, (4 * BlockSize) >> this->Steps));
    });
}

template <typename Id>
Buffer<Stratum> Chains<Id>::GetStrata() const
{
  const vtkIdType size = vtkIdType(1) << this->Steps;
  Buffer<Stratum> strata(this->GetNumberOfRows());
  CopyInThreads(this->Strata.Vertices.data(), this->Complex.NumberOfVertices, strata.data());
  ForEach(this->Complex.NumberOfEdges,
    [&](vtkIdType e)
    {
      for (vtkIdType place = 1; place < size; ++place)
      {
        strata[this->Points.GetFirstAt(place) + this->Points.GetFactor(place) * e] =
          this->Strata.Edges[e];
      }
    });
  return strata;
}

SUBDIVISION_COMPILE(class Chains);

}
