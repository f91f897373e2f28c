// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelStar.h
 * The star of a vertex of a level of any volume scheme, from which its local matrix follows
 * (LimitRowMaker.h).
 */
#ifndef SubdivisionObjects_LevelStar_h
#define SubdivisionObjects_LevelStar_h

#include "Core/Solids/Limits/LimitRowMaker.h"

#include <array>
#include <cstring>
#include <numeric>
#include <vector>

namespace subdivision
{

/// Numbers beyond Rule for rows of three kinds: of the centres of solids; of vertices whose weights
/// follow from numbers at their spokes, and have these numbers behind the ring, one for each
/// member; and of edges whose rule depends on sectors (SectorEdges.h), which have the weights of
/// their two ends and of the members behind the ring.
constexpr int CentreRow = 16;
constexpr int SpokesRow = 17;
constexpr int SectorRow = 18;

/// Writes a weight as numbers of a row, and reads it.
inline void PutWeight(double weight, std::vector<int>& numbers)
{
  int bits[2];
  static_assert(sizeof(bits) == sizeof(weight), "a weight is two numbers");
  std::memcpy(bits, &weight, sizeof(bits));
  numbers.push_back(bits[0]);
  numbers.push_back(bits[1]);
}
inline double TakeWeight(const int*& numbers)
{
  double weight = 0.;
  std::memcpy(&weight, numbers, sizeof(weight));
  numbers += 2;
  return weight;
}

/// The star of a vertex of a level (LimitRowMaker.h): its items are its edges, and the solids at it
/// in which rings have members. The key of solid s is NumberOfEdges + s.
template <typename Scheme>
class LevelStar
{
public:
  using IdType = typename Scheme::Id;
  using Id = IdType;
  using LevelType = typename Scheme::Level;

  explicit LevelStar(const LevelType& level)
    : Here(level)
    , Complex(level.Complex)
    , Solids(level)
  {
  }
  StarRules<Id> GetRules() const
  {
    return { this->Here.Strata, Scheme::GetSpokes(this->Here).get() };
  }
  Id GetOppositeEnd(Id vertex, Id key) const
  {
    const Id solid = key - this->Complex.NumberOfEdges;
    return solid < 0 ? this->Complex.GetOtherEnd(key, vertex)
                     : this->Solids.GetOppositeEnd(solid, vertex);
  }

  /// The numbers of a row are the rule, or one of the two above, the size of the ring, and the
  /// ring.
  template <typename Number>
  bool ReadRow(const StarRules<Id>& rules, Id vertex, Id key, bool first, Neighbourhood& rows,
    const Number& number) const
  {
    const std::size_t start = rows.size();
    rows.resize(start + 2);
    auto add = [&](Id member)
    { rows.push_back(number(member, this->GetOppositeEnd(vertex, member))); };
    bool all = true;
    if (key < 0)
    {
      this->ReadVertexRow(rules, vertex, rows, add);
      return true;
    }
    if (key >= this->Complex.NumberOfEdges)
    {
      rows[start] = CentreRow;
      this->Solids.ForEdgesInSolid(key - this->Complex.NumberOfEdges, vertex, add);
    }
    else
    {
      rows[start] = static_cast<int>(rules.Strata.Edges[key].GetRule());
      all = this->ReadEdgeRow(rules.Strata, vertex, key, first, rows, number, add);
      const auto sectors = FindSectorEdges(rules.Strata.Sectors, key);
      if (!sectors.IsEmpty())
      {
        return this->ReadSectors(sectors, vertex, first, rows, start, number) && all;
      }
    }
    rows[start + 1] = static_cast<int>(rows.size() - start) - 2;
    return all;
  }

  template <typename Add>
  void Weigh(const int*& row, int item, const Add& add) const
  {
    const RingMasks& masks = this->Solids.GetMasks();
    const int kind = row[0];
    const int size = row[1];
    const int* ring = row + 2;
    row = ring + size;
    if (kind == CentreRow) // the mean of six vertices
    {
      add(0, 1. / 6.);
      add(item, 1. / 6.);
      std::for_each(ring, row, [&](int member) { add(member, 1. / 6.); });
      return;
    }
    if (kind == SpokesRow)
    {
      const int* counts = row;
      row += size;
      const double all = std::accumulate(counts, row, 0.) / 3.;
      add(0, masks.CountedOwn);
      for (int k = 0; k < size; ++k)
      {
        add(ring[k], masks.CountedOther * static_cast<double>(counts[k]) / all);
      }
      return;
    }
    if (kind == SectorRow)
    {
      add(0, TakeWeight(row));
      add(item, TakeWeight(row));
      for (int k = 0; k < size; ++k)
      {
        add(ring[k], TakeWeight(row));
      }
      return;
    }
    const PartedMask mask = GetMask(masks, item > 0, static_cast<Rule>(kind), size);
    add(0, mask.Own);
    if (item > 0)
    {
      add(item, mask.Own);
    }
    for (int part = 0; part < mask.Parts; ++part)
    {
      for (vtkIdType k = 0; k < mask.Sizes[part]; ++k)
      {
        add(*ring++, mask.Weights[part]);
      }
    }
  }

private:
  /// Appends the row of the vertex itself: members at edges, then members in solids.
  template <typename Add>
  void ReadVertexRow(
    const StarRules<Id>& rules, Id vertex, Neighbourhood& rows, const Add& add) const
  {
    const std::size_t start = rows.size() - 2;
    const Rule rule = rules.Strata.Vertices[vertex].GetRule();
    const Row<Id> ring = rules.Strata.VertexRings.GetCarriers(vertex);
    const Id* firstSolid = ring.end() - this->Solids.CountSolids(vertex, rule, ring.size());
    std::for_each(ring.begin(), firstSolid, add);
    std::for_each(
      firstSolid, ring.end(), [&](Id solid) { add(this->Complex.NumberOfEdges + solid); });
    rows[start] = static_cast<int>(rule);
    rows[start + 1] = static_cast<int>(ring.size());
    if (this->Solids.HasSpokes(vertex, rule))
    {
      rows[start] = SpokesRow;
      const Id* tets = rules.TetsAtSpokes->data() + rules.Strata.VertexRings.Offsets[vertex];
      std::transform(tets, tets + ring.size(), std::back_inserter(rows),
        [](Id count) { return static_cast<int>(count); });
    }
  }

  /// Appends the row of an edge: one member on each face, then in each solid that carries members
  /// those opposite to its two ends.
  template <typename Number, typename Add>
  bool ReadEdgeRow(const subdivision::Strata<Id>& strata, Id vertex, Id edge, bool first,
    Neighbourhood& rows, const Number& number, const Add& add) const
  {
    const Row<Id> carriers = strata.EdgeRings.GetCarriers(edge);
    const Id* member = strata.EdgeRings.GetMembers(edge).begin();
    const Id* firstSolid =
      carriers.begin() + this->Solids.CountFaces(strata.Edges[edge].GetRule(), carriers.size());
    bool all = true;
    for (const Id* face = carriers.begin(); face != firstSolid; ++face, ++member)
    {
      if (*face >= 0)
      {
        add(this->Complex.OtherEdge(*face, edge, vertex));
      }
      else if (first)
      {
        rows.push_back(number(Id(-1), *member));
      }
      all = all && (*face >= 0 || first);
    }
    const Id far = this->Complex.GetOtherEnd(edge, vertex);
    for (const Id* solid = firstSolid; solid != carriers.end(); solid += 2)
    {
      add(this->Complex.NumberOfEdges + *solid);
      add(this->Solids.GetEdgeBeyond(*solid, vertex, far));
    }
    return all;
  }

  /// Turns the row of an edge, from `start` on, into one of sectors. After the first step the rule
  /// at the far end, and what depends on both ends, is no longer that of an edge at the vertex.
  template <typename Number>
  bool ReadSectors(const SectorEdgeRange<Id>& sectors, Id vertex, bool first, Neighbourhood& rows,
    std::size_t start, const Number& number) const
  {
    const int near =
      this->Complex.EdgeVertices[2 * vtkIdType(sectors.begin()->Edge)] == vertex ? 0 : 1;
    std::array<SectorEdge<Id>, 2> taken;
    std::size_t size = 0;
    bool all = true;
    for (const SectorEdge<Id>& sector : sectors)
    {
      all = all && sector.End == near && !sector.IsShared;
      if (first || sector.End == near)
      {
        taken[size] = sector;
        taken[size++].IsShared = first && sector.IsShared;
      }
    }
    if (size > 0)
    {
      this->WriteSectors({ taken.data(), taken.data() + size }, near, rows, start, number);
    }
    else
    {
      rows[start + 1] = static_cast<int>(rows.size() - start) - 2;
    }
    return all;
  }

  template <typename Number>
  void WriteSectors(const SectorEdgeRange<Id>& sectors, int near, Neighbourhood& rows,
    std::size_t start, const Number& number) const
  {
    const SectorMask mask = GetSectorMask(sectors);
    std::vector<double> weights(rows.size() - start - 2, mask.Ring);
    for (const SectorEdge<Id>& sector : sectors)
    {
      for (int k = 0; k < 2 && sector.Flatness > 0.; ++k)
      {
        rows.push_back(number(sector.End == near ? sector.Bounds[k] : Id(-1), sector.Ends[k]));
        weights.push_back(mask.Bounds[sector.End][k]);
      }
    }
    rows[start] = SectorRow;
    rows[start + 1] = static_cast<int>(rows.size() - start) - 2;
    PutWeight(mask.Ends[near], rows);
    PutWeight(mask.Ends[1 - near], rows);
    for (const double weight : weights)
    {
      PutWeight(weight, rows);
    }
  }

  const LevelType& Here;
  const SimplicialComplex<Id>& Complex;
  const typename Scheme::Star Solids;
};

}

#endif
